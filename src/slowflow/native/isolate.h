/* One root at a time. Takes a quartic of roots.h; returns its signs, and the root that is wanted of those they count.
 *
 * Along a curve the number of roots is known from both sides. Where rounding hides a pair that is about to meet, or
 * shows one that has met already, the known number decides, and the place where the pair meets represents the root.
 */
#pragma once

#include "roots.h"

/* critical points 0 < w1 < w2 if they exist, and the values f0 at 0, f1 at w1, f2 at w2; w1 = 0 if biquadratic */
typedef struct {
    sf_quartic s;
    int exist;
    double w1, w2, f0, f1, f2;
} sf_isolated;

typedef enum { SF_BELOW, SF_BETWEEN, SF_ABOVE, SF_RISING, SF_AT_W1, SF_AT_W2, SF_AT_0 } sf_place;

static inline void sf_isolate(sf_isolated *q) {
    sf_derivative_coefficients(&q->s);
    q->f0 = sf_value_at_0(&q->s);
    q->w1 = q->w2 = q->f1 = q->f2 = 0;
    q->exist = sf_critical_points(&q->s, &q->w1, &q->w2) != 0;
    if (!q->exist)
        return;
    q->f2 = sf_critical_value(&q->s, q->w2);
    q->f1 = q->w1 == 0 ? q->f0 : sf_critical_value(&q->s, q->w1);
}

static inline void sf_isolate_response(sf_isolated *q, double A, double h, double m, double zeta, double F_0) {
    q->s.kind = SF_RESPONSE;
    q->s.A = A, q->s.h = h, q->s.h_A = 0, q->s.m = m, q->s.zeta = zeta, q->s.F_0 = F_0;
    sf_isolate(q);
}

/* zeta > 0: without it the quartic falls into two factors */
static inline void sf_isolate_fold(sf_isolated *q, double A, double h, double h_A, double m, double zeta) {
    q->s.kind = SF_FOLD;
    q->s.A = A, q->s.h = h, q->s.h_A = h_A, q->s.m = m, q->s.zeta = zeta, q->s.F_0 = 0;
    sf_isolate(q);
}

/* The places of the roots that signs show, by rising Omega: whether there are critical points, and f0 and f2 are below
 * and f1 above 0. A pair that touches is not counted. */
static inline int sf_places(int exist, int f0_below, int f1_above, int f2_below, sf_place place[3]) {
    int n = 0;
    if (!exist) {
        if (f0_below)
            place[n++] = SF_RISING;
        return n;
    }
    if (f0_below && f1_above)
        place[n++] = SF_BELOW;
    if (f1_above && f2_below)
        place[n++] = SF_BETWEEN;
    if (f2_below)
        place[n++] = SF_ABOVE;
    return n;
}

static inline int sf_count(const sf_isolated *q) {
    sf_place place[3];
    return sf_places(q->exist, q->f0 < 0, q->f1 > 0, q->f2 < 0, place);
}

/* Place of root number `index` of `count`, also where the signs count otherwise. */
static inline sf_place sf_place_of(int exist, double f0, double f1, double f2, int count, int index) {
    sf_place place[3];
    const int shown = sf_places(exist, f0 < 0, f1 > 0, f2 < 0, place);
    if (shown == count)
        return index < count ? place[index] : SF_AT_W2;
    if (shown == count - 1) /* the lowest has gone to 0 */
        return index == 0 ? SF_AT_0 : place[index - 1];
    if (shown == count + 1) /* one has come from 0 */
        return place[index + 1];
    if (shown == count - 2) {
        if (!exist) /* maximum and minimum are about to meet: all three are */
            return f0 < 0 ? SF_RISING : SF_AT_0;
        if (!(f1 > 0))
            return index < 2 ? SF_AT_W1 : place[index - 2];
        return index < count - 2 ? place[index] : SF_AT_W2;
    }
    if (shown == count + 2) /* the pair that is nearest to nothing does not count */
        return place[fabs(f1) < fabs(f2) ? index + 2 : index];
    return shown > 0 ? place[shown - 1] : SF_AT_0;
}

static double sf_root_at(const sf_isolated *q, sf_place place) {
    const sf_quartic *s = &q->s;
    if (q->exist && q->w1 == 0 && (place == SF_BETWEEN || place == SF_ABOVE)) { /* biquadratic: closed form */
        const double twice_S = 2 * sqrt(-q->f2 / (s->k * s->A));
        const double xx = q->w2 * q->w2 + twice_S;
        if (place == SF_BETWEEN)
            return sf_refine(s, sqrt(4 * q->f0 / (s->k * s->A * xx)), 0, q->w2, -1);
        return sf_refine(s, sqrt(xx), q->w2, 2 * sqrt(xx), 1);
    }
    switch (place) {
    case SF_BELOW:
        return sf_root_below(s, q->f0, q->w1, q->f1);
    case SF_BETWEEN:
        return sf_root_between(s, q->w1, q->f1, q->w2, q->f2);
    case SF_ABOVE:
        return sf_root_above(s, q->w2, q->f2);
    case SF_RISING:
        return sf_root_of_rising(s, q->f0);
    case SF_AT_W1:
        return q->w1;
    case SF_AT_W2:
        return q->exist ? q->w2 : 0;
    default:
        return 0;
    }
}

static inline double sf_wanted_root(const sf_isolated *q, int count, int index) {
    return sf_root_at(q, sf_place_of(q->exist, q->f0, q->f1, q->f2, count, index));
}
