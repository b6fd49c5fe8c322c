/* See root_lanes.h. */
#include "root_lanes.h"

#include <math.h>

#include "clones.h"
#include "design_lanes.h"
#include "frequencies.h"

enum { HALLEY = 2 };

/* sf_critical_points and what sf_isolate does with them */
SF_WIDE static void isolate(ptrdiff_t n, sf_quartics *block) {
    SF_EACH(i, n) {
        const double A = block->A[i], h = block->h[i], m = block->m[i], zeta = block->zeta[i], F_0 = block->F_0[i];
        double derivative[5], at_0[2], at_1[2], at_2[2];
        frequencies_response_derivative(A, m, zeta, h, derivative);
        frequencies_response_at_0(F_0, m, h, at_0);
        const double p = derivative[0], q = derivative[2];
        const sf_lane_critical at = sf_lane_critical_at(A, p, q);
        const double rho = at.rho, w1 = at.w1, w2 = at.w2;
        const int is_critical = (p < 0) & (rho <= 1 - SF_MAY_MEET);
        frequencies_response(w1, A, F_0, m, zeta, h, at_1);
        frequencies_response(w2, A, F_0, m, zeta, h, at_2);
        const int is_sure =
            ((p >= 0) | (rho <= 1 - SF_MAY_MEET) | (rho > 1 + SF_MAY_MEET)) & (fabs(at_0[0]) >= SF_ROUGH * at_0[1]) &
            ((is_critical == 0) | ((fabs(at_1[0]) > SF_ROUGH * at_1[1]) & (fabs(at_2[0]) > SF_ROUGH * at_2[1]))) &
            (A > 0) & (m >= 0) & (zeta >= 0) & (F_0 >= m) & (A + fabs(h) + m + zeta + F_0 < HUGE_VAL);
        const double signs = (at_0[0] < 0 ? SF_F0_BELOW : 0.0) + (at_1[0] > 0 ? SF_F1_ABOVE : 0.0) +
                             (at_2[0] < 0 ? SF_F2_BELOW : 0.0) + (is_critical ? SF_CRITICAL : 0.0);
        block->p[i] = p, block->q[i] = q, block->w1[i] = w1, block->w2[i] = w2;
        block->f0[i] = at_0[0], block->f1[i] = at_1[0], block->f2[i] = at_2[0];
        block->signs[i] = is_sure ? signs : SF_UNSURE;
    }
}

/* The starts of sf_root_below, sf_root_between, sf_root_above and sf_root_of_rising, places 0 to 3, and sf_refine. */
SF_WIDE static void refine(ptrdiff_t n, sf_jobs *jobs) {
    SF_EACH(i, n) {
        const double A = jobs->A[i], h = jobs->h[i], m = jobs->m[i], zeta = jobs->zeta[i], F_0 = jobs->F_0[i];
        const double p = jobs->p[i], q = jobs->q[i], w1 = jobs->w1[i], w2 = jobs->w2[i], place = jobs->place[i];
        const double f1 = jobs->f1[i], f2 = jobs->f2[i], k = 4 * A, E = -jobs->f0[i] / k, line = E / q;
        const double sum = 3 * w2 * w2 + p / A, vv = 0.5 * SF_GREATER(sum, 0.0);
        const double depth = SF_GREATER(-f2, 0.0), twice_S = 2 * sqrt(depth / (k * A)),
                     signed_S = place == 2 ? twice_S : -twice_S;
        const double under = vv + signed_S;
        const double by_minimum = w2 + signed_S / (sqrt(vv) + sqrt(SF_GREATER(under, 0.0)));
        const double drop = sqrt(2 * SF_GREATER(f1, 0.0) / (-k * frequencies_cubic_slope(w1, A, p)));
        const double less = w1 - drop;
        const double root = sqrt(p * p + 4 * A * E), high = sqrt(p > 0 ? 4 * E / (p + root) : (root - p) / A);
        const double below = SF_GREATER(line, less), between = f1 < -f2 ? w1 + drop : by_minimum;
        const double rising = p >= 0 ? SF_LESSER(high, line) : high;
        const double start = place == 0 ? below : place == 1 ? between : place == 2 ? by_minimum : rising;
        const double lo = place == 1 ? w1 : place == 2 ? w2 : 0.0;
        const double hi = place == 0 ? w1 : place == 1 ? w2 : 2 * (place == 2 ? by_minimum : high);
        double w = (start > lo) & (start < hi) ? start : 0.5 * (lo + hi);
        for (int step = 0; step < HALLEY; step++) {
            double value[2];
            frequencies_response(w, A, F_0, m, zeta, h, value);
            const double C = frequencies_cubic(w, A, p, q), D = frequencies_cubic_slope(w, A, p);
            const double next = w - 2 * value[0] * C / (2 * k * C * C - value[0] * D);
            w = (next > lo) & (next < hi) ? next : 0.5 * (lo + hi);
        }
        double fine[2];
        frequencies_response_fine(w, A, F_0, m, zeta, h, fine);
        const double C = frequencies_cubic(w, A, p, q), D = frequencies_cubic_slope(w, A, p), step = fine[0] / (k * C);
        const double next = w - step;
        const int is_last = (fabs(step * D) * fabs(step) <= SF_CORRECTED * fabs(C) * w) & (next >= lo) & (next <= hi);
        jobs->Omega[i] = next, jobs->is_last[i] = is_last;
    }
}

void sf_isolate_lanes(ptrdiff_t n, sf_quartics *block) {
    sf_fill(block->A, n), sf_fill(block->h, n), sf_fill(block->m, n), sf_fill(block->zeta, n), sf_fill(block->F_0, n);
    isolate(sf_filled(n), block);
}

void sf_refine_lanes(sf_jobs *jobs) {
    const ptrdiff_t n = jobs->n; /* none are filled, if there are no jobs */
    sf_fill(jobs->A, n), sf_fill(jobs->h, n), sf_fill(jobs->m, n), sf_fill(jobs->zeta, n), sf_fill(jobs->F_0, n);
    sf_fill(jobs->p, n), sf_fill(jobs->q, n), sf_fill(jobs->w1, n), sf_fill(jobs->w2, n);
    sf_fill(jobs->f0, n), sf_fill(jobs->f1, n), sf_fill(jobs->f2, n), sf_fill(jobs->place, n);
    refine(sf_filled(n), jobs);
}
