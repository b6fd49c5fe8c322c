/* Frequencies at many amplitudes. Takes blocks of quartics; returns their roots, by loops that vectorise.
 *
 * The method is that of roots.h, without its branches: signs at three points, the start of each root, Halley's steps in
 * double, as many for each, and a Newton step with the residual in double-double. Where that step is not small enough
 * to be the last, roots.h goes on from there; where rounding could have decided a sign, the block is marked, and
 * roots.h has the quartic.
 */
#pragma once

#include <stddef.h>

#include "roots.h"

enum { SF_QUARTICS = 64, SF_MOST_JOBS = 3 * SF_QUARTICS };

/* F = 0 at n amplitudes. f0, f1, f2: F at 0 and at its maximum w1 and minimum w2, if there are any; p, q: of its
 * derivative;
 * signs: a sum of SF_F0_BELOW and others, or SF_UNSURE */
typedef struct {
    double A[SF_QUARTICS], h[SF_QUARTICS], m[SF_QUARTICS], zeta[SF_QUARTICS], F_0[SF_QUARTICS];
    double p[SF_QUARTICS], q[SF_QUARTICS], w1[SF_QUARTICS], w2[SF_QUARTICS], f0[SF_QUARTICS], f1[SF_QUARTICS],
        f2[SF_QUARTICS];
    double signs[SF_QUARTICS];
} sf_quartics;

enum { SF_F0_BELOW = 1, SF_F1_ABOVE = 2, SF_F2_BELOW = 4, SF_CRITICAL = 8, SF_UNSURE = -1 };

/* Roots to compute: of which quartic of a block, and at which place (roots.h), one of the first four; is_last:
 * whether Omega needs no further step */
typedef struct {
    int n, of[SF_MOST_JOBS];
    double A[SF_MOST_JOBS], h[SF_MOST_JOBS], m[SF_MOST_JOBS], zeta[SF_MOST_JOBS], F_0[SF_MOST_JOBS];
    double p[SF_MOST_JOBS], q[SF_MOST_JOBS], w1[SF_MOST_JOBS], w2[SF_MOST_JOBS];
    double f0[SF_MOST_JOBS], f1[SF_MOST_JOBS], f2[SF_MOST_JOBS], place[SF_MOST_JOBS], Omega[SF_MOST_JOBS];
    double is_last[SF_MOST_JOBS];
} sf_jobs;

/* Signs of the first n quartics, up to a whole vector; what is left over is filled with the last. */
void sf_isolate_lanes(ptrdiff_t n, sf_quartics *block);
/* The roots of all jobs; places that are left over of a vector are overwritten. */
void sf_refine_lanes(sf_jobs *jobs);

/* The root of job k, from what the lanes found of it. */
static inline double sf_root_of_job(const sf_jobs *jobs, int k) {
    sf_isolated q;
    if (!SF_UNLIKELY(jobs->is_last[k] == 0))
        return jobs->Omega[k];
    sf_isolate_response(&q, jobs->A[k], jobs->h[k], jobs->m[k], jobs->zeta[k], jobs->F_0[k]);
    return sf_root_at(&q, (sf_place)jobs->place[k]);
}

/* The places of the roots that a sum of signs shows, by rising Omega; returns their number. */
static inline int sf_places_of_signs(int signs, sf_place place[3]) {
    return sf_places(signs & SF_CRITICAL, signs & SF_F0_BELOW, signs & SF_F1_ABOVE, signs & SF_F2_BELOW, place);
}

static inline void sf_add_job(const sf_quartics *block, int i, int place, sf_jobs *jobs) {
    const int k = jobs->n++;
    jobs->of[k] = i, jobs->place[k] = place;
    jobs->A[k] = block->A[i], jobs->h[k] = block->h[i], jobs->m[k] = block->m[i], jobs->zeta[k] = block->zeta[i];
    jobs->F_0[k] = block->F_0[i], jobs->p[k] = block->p[i], jobs->q[k] = block->q[i];
    jobs->w1[k] = block->w1[i], jobs->w2[k] = block->w2[i];
    jobs->f0[k] = block->f0[i], jobs->f1[k] = block->f1[i], jobs->f2[k] = block->f2[i];
}
