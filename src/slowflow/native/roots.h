/* Positive frequencies at a given amplitude. Takes A, h, h_A, m, zeta, F_0; returns sorted Omega and their number.
 *
 *   sf_response_roots   F = R^2 + I^2 - F_0^2 = 0                  up to 3   the response curve
 *   sf_fold_roots       F_A/2 = R (w^2 + h_A) + 2 zeta w I = 0     up to 3   the fold locus
 *   sf_peak_roots       F_Omega/(4 A) = w R + zeta I = 0           up to 2   the peak locus
 *
 * with R = A w^2 + h and I = 2 zeta A w + m; everything is dimensionless.
 *
 * Method.  Both quartics are depressed, with a positive leading and a non-negative linear coefficient, and their
 * derivative is k (A w^3 + p w + q), q >= 0.  So there are at most two positive critical points, a maximum w1 and then
 * a minimum w2.  The signs at 0, w1 and w2 give the number of roots; between these points the quartic is monotone.
 * Each root is found by Halley steps kept in their bracket, on the unexpanded form, and corrected by Newton with a
 * residual in double-double.  A sign that rounding could have decided is found again in double-double.
 *
 * Conventions:
 *   - roots are counted with multiplicity: a curve that touches zero gives its double root twice, as two equal numbers
 *     (three for a triple root), so that branches keep their partner up to the point where they meet;
 *   - "touches" means that the value at the critical point is zero to within the error of double-double, 2^-98 of its
 *     terms;
 *   - a root at w = 0 is not positive and is not counted;
 *   - unused places are NaN;
 *   - the domain is A > 0, m >= 0, zeta >= 0, F_0 >= 0, all finite; outside it the count is -1 and all places are NaN.
 *
 * The error of a root is at most u (1 + kappa), u = 2^-53, kappa the condition number of the root in the arguments.
 * For that, squares of the arguments must not overflow and the square of F_0 must stay above 1e-290; h_A may have any
 * finite size.
 *
 * C99.  Build without contraction and without fast-math: the error terms below would be optimised away.  fma() is worth
 * a hardware instruction (target_clones, -mfma); without it the results are the same and slower.
 */
#pragma once

#include <math.h>

#include "clones.h"
#include "conventions.h"
#include "frequencies.h"
#include "slow_flow.h"

#if defined(__GNUC__)
#define SF_RARELY __attribute__((noinline, cold, unused)) static
#define SF_UNLIKELY(x) __builtin_expect(!!(x), 0)
#else
#define SF_RARELY static inline
#define SF_UNLIKELY(x) (x)
#endif

#define SF_ROUGH FREQUENCIES_ROUGH /* a value below this part of its terms has no certain sign in double */
#define SF_FINE FREQUENCIES_FINE   /* the same in double-double */

/* ==== The formulas, as they are generated, for either quartic.  Everything below this block is a solver that knows
 * only these.
 * ============================================================================================================ */

typedef enum { SF_RESPONSE, SF_FOLD } sf_kind;

typedef struct {
    sf_kind kind;
    double A, h, h_A, m, zeta, F_0;
    double k, p, p_low, q, q_low; /* derivative of the quartic: k (A w^3 + p w + q) */
} sf_quartic;

/* The quartic in double.  Its rounding error is below SF_ROUGH * size. */
SF_ALWAYS double sf_value(const sf_quartic *s, double w, double *size) {
    double out[2];
    if (s->kind == SF_RESPONSE)
        frequencies_response(w, s->A, s->F_0, s->m, s->zeta, s->h, out);
    else
        frequencies_fold(w, s->A, s->m, s->zeta, s->h, s->h_A, out);
    *size = out[1];
    return out[0];
}

/* The quartic in double-double, rounded to double.  Its error is below SF_FINE * size. */
SF_ALWAYS double sf_value_fine(const sf_quartic *s, double w) {
    double out[2];
    if (s->kind == SF_RESPONSE)
        frequencies_response_fine(w, s->A, s->F_0, s->m, s->zeta, s->h, out);
    else
        frequencies_fold_fine(w, s->A, s->m, s->zeta, s->h, s->h_A, out);
    return out[0];
}

/* The same at w + tail, a correction below the last place of w. */
SF_ALWAYS double sf_value_near(const sf_quartic *s, double w, double tail, double *size) {
    double out[2];
    if (s->kind == SF_RESPONSE)
        frequencies_response_beside(w, tail, s->A, s->F_0, s->m, s->zeta, s->h, out);
    else
        frequencies_fold_beside(w, tail, s->A, s->m, s->zeta, s->h, s->h_A, out);
    *size = out[1];
    return out[0];
}

/* The quartic at 0 with a certain sign. */
SF_RARELY double sf_value_exactly_at_0(const sf_quartic *s) {
    return s->kind == SF_RESPONSE ? frequencies_response_exactly_at_0(s->F_0, s->m, s->h)
                                  : frequencies_fold_at_0(s->h, s->h_A);
}

/* The same in double, where it is certain. */
SF_ALWAYS double sf_value_at_0(const sf_quartic *s) {
    double out[2];
    if (s->kind == SF_FOLD)
        return frequencies_fold_at_0(s->h, s->h_A);
    frequencies_response_at_0(s->F_0, s->m, s->h, out);
    return SF_UNLIKELY(fabs(out[0]) < SF_ROUGH * out[1]) ? sf_value_exactly_at_0(s) : out[0];
}

/* Coefficients of the derivative. */
SF_ALWAYS void sf_derivative_coefficients(sf_quartic *s) {
    double out[5];
    if (s->kind == SF_RESPONSE)
        frequencies_response_derivative(s->A, s->m, s->zeta, s->h, out);
    else
        frequencies_fold_derivative(s->A, s->m, s->zeta, s->h, s->h_A, out);
    s->p = out[0], s->p_low = out[1], s->q = out[2], s->q_low = out[3], s->k = out[4];
}

/* The cubic A w^3 + p w + q and its slope. */
SF_ALWAYS double sf_cubic(const sf_quartic *s, double w) { return frequencies_cubic(w, s->A, s->p, s->q); }
SF_ALWAYS double sf_cubic_slope(const sf_quartic *s, double w) { return frequencies_cubic_slope(w, s->A, s->p); }

/* The cubic in double-double, rounded to double. */
SF_ALWAYS double sf_cubic_fine(const sf_quartic *s, double w) {
    return frequencies_cubic_fine(w, s->A, s->p, s->p_low, s->q, s->q_low);
}

/* ==== The cubic A w^3 + p w + q, q >= 0 =========================================================================== */

/* 1 - rho^2 = (4 |p|^3 - 27 A q^2) / (4 |p|^3) in double-double, for p < 0; 0 where only rounding is left. */
SF_RARELY double sf_gap_fine(const sf_quartic *s) {
    double out[2];
    frequencies_discriminant(s->A, s->p, s->p_low, s->q, s->q_low, out);
    return fabs(out[0]) <= SF_FINE * out[1] ? 0 : out[0] / out[1];
}

/* Number of points where the cubic vanishes on w >= 0, counted with multiplicity (0 or 2), and these points.
 *
 * With y = w / sqrt(-p/3A) the cubic is y^3 - 3 y + 2 rho, whose roots are cos(b) +- sqrt(3) sin(b), 3 b = acos(rho).
 * cos(b) is well conditioned on 0 <= rho <= 1, and sin(b) = sin(3b) / (4 cos(b)^2 - 1), so two Newton steps on
 * 4 c^3 - 3 c = rho take the place of the trigonometric functions.  The small root follows from Vieta. */
SF_ALWAYS int sf_critical_points(const sf_quartic *s, double *w1, double *w2) {
    if (!(s->p < 0))
        return 0;
    if (s->q == 0) {
        *w1 = 0;
        *w2 = sqrt(-s->p / s->A);
        return 2;
    }
    const double r = sqrt(-s->p / (3 * s->A));
    const double rho = 1.5 * s->q / (-s->p * r);
    if (rho > 1 + SF_MAY_MEET)
        return 0;
    double gap = (1 - rho) * (1 + rho);
    if (SF_UNLIKELY(rho > 1 - SF_MAY_MEET)) {
        gap = sf_gap_fine(s);
        if (gap < 0)
            return 0;
    }
    /* cubic Hermite interpolation of c(rho) between c(0) = sqrt(3)/2, c' = 1/6 and c(1) = 1, c' = 1/9 */
    const double c0 = 0.86602540378443865, rise = 0.13397459621556135;
    double c = c0 + rho * (1. / 6 + rho * ((3 * rise - 4. / 9) + rho * (5. / 18 - 2 * rise)));
    c = (8 * c * c * c + rho) / (12 * c * c - 3);
    c = (8 * c * c * c + rho) / (12 * c * c - 3);
    const double y2 = c + 1.7320508075688773 * sqrt(gap) / (4 * c * c - 1);
    *w1 = r * rho / (y2 * c);
    *w2 = r * y2;
    return 2;
}

/* Newton with the double-double residual, on a simple root of the cubic near w. */
SF_ALWAYS double sf_polish_cubic(const sf_quartic *s, double w) {
    for (int i = 0; i < SF_POLISHING; i++) {
        const double slope = sf_cubic_slope(s, w);
        const double step = sf_cubic_fine(s, w) / slope;
        if (!(fabs(step) <= SF_SIMPLE * w))
            break; /* a double root: the slope is noise, and w is as good as it gets */
        w -= step;
        if (3 * s->A * w * step * step <= SF_POLISHED * w * fabs(slope))
            break;
    }
    return w;
}

/* ==== The quartic ================================================================================================= */

/* The quartic at its critical point near w, in double-double; 0 where only rounding is left. */
SF_RARELY double sf_critical_value_fine(const sf_quartic *s, double w) {
    double tail = 0, rise[2], size;
    for (int i = 0; i < 3; i++) {
        const double step = sf_cubic_fine(s, w) / sf_cubic_slope(s, w);
        if (!(fabs(step) <= SF_SIMPLE * w))
            break; /* maximum and minimum coincide: the value does not depend on w in second order */
        tail = -step;
        if (i < 2)
            w += tail;
    }
    /* The rise from w = 0, whose terms may be far smaller than those of the value. */
    const double start = sf_value_exactly_at_0(s);
    frequencies_rise(w, s->A, s->p, s->k, rise);
    if (fabs(start + rise[0]) > SF_BY_RISE * (fabs(start) + rise[1]))
        return start + rise[0];
    const double value = sf_value_near(s, w, tail, &size);
    return fabs(value) <= SF_FINE * size ? 0 : value;
}

SF_ALWAYS double sf_critical_value(const sf_quartic *s, double w) {
    double size;
    const double value = sf_value(s, w, &size);
    return SF_UNLIKELY(fabs(value) <= SF_ROUGH * size) ? sf_critical_value_fine(s, w) : value;
}

/* The root between lo and hi, where the quartic is monotone and rises (+1) or falls (-1), from the first guess w. */
SF_ALWAYS double sf_refine(const sf_quartic *s, double w, double lo, double hi, double rising) {
    if (SF_UNLIKELY(!(w > lo && w < hi)))
        w = 0.5 * (lo + hi);
    for (int i = 0; i < SF_NEARING;
         i++) { /* Halley in double, until the next error is below 2^-36 of the distance to a fold */
        double size;
        const double f = sf_value(s, w, &size);
        const double C = sf_cubic(s, w), D = sf_cubic_slope(s, w);
        if (fabs(f) <= SF_ROUGH * size)
            break;
        double next = w - 2 * f * C / (2 * s->k * C * C - f * D);
        if (f * rising < 0)
            lo = w;
        else
            hi = w;
        if (SF_UNLIKELY(!(next > lo && next < hi)))
            next = 0.5 * (lo + hi);
        const double shift = fabs(next - w);
        w = next;
        if (shift * fabs(D) <= SF_NEAR_ROOT * fabs(C) && shift <= SF_NEAR_ROOT * w)
            break;
    }
    for (int i = 0; i < SF_CORRECTING;
         i++) { /* Newton with the double-double residual: once, but for nearly multiple roots */
        const double f = sf_value_fine(s, w);
        const double C = sf_cubic(s, w), D = sf_cubic_slope(s, w);
        const double step = f / (s->k * C);
        double next = w - step;
        if (fabs(step * D) * fabs(step) <= SF_CORRECTED * fabs(C) * w && next >= lo && next <= hi)
            return next;
        if (f * rising < 0)
            lo = w;
        else
            hi = w;
        if (!(next > lo && next < hi))
            next = 0.5 * (lo + hi);
        if (next == w || !(lo < hi))
            return next;
        w = next;
    }
    return w;
}

/* The largest root w2 + d, above the minimum w2 with the value f2 < 0.  With v^2 = slope'(w2)/(2A), d (v + d/2) = S is
 * exact for q = 0, and gives a d that is not too small otherwise. */
SF_ALWAYS double sf_root_above(const sf_quartic *s, double w2, double f2) {
    const double twice_vv = fmax(3 * w2 * w2 + s->p / s->A, 0);
    const double twice_S = 2 * sqrt(-f2 / (s->k * s->A));
    const double start = w2 + twice_S / (sqrt(0.5 * twice_vv) + sqrt(0.5 * twice_vv + twice_S));
    return sf_refine(s, start, w2, 2 * start, 1);
}

/* The root between the maximum w1 with f1 > 0 and the minimum w2 with f2 < 0. */
SF_ALWAYS double sf_root_between(const sf_quartic *s, double w1, double f1, double w2, double f2) {
    double start;
    if (f1 < -f2) {
        start = w1 + sqrt(2 * f1 / (-s->k * sf_cubic_slope(s, w1)));
    } else {
        const double vv = 0.5 * fmax(3 * w2 * w2 + s->p / s->A, 0);
        const double twice_S = 2 * sqrt(-f2 / (s->k * s->A));
        start = w2 - twice_S / (sqrt(vv) + sqrt(fmax(vv - twice_S, 0)));
    }
    return sf_refine(s, start, w1, w2, -1);
}

/* The root between 0, where the value is f0 < 0, and the maximum w1 with f1 > 0.  The quartic is concave here: the
 * tangent at 0 and the parabola at w1 both end below the root. */
SF_ALWAYS double sf_root_below(const sf_quartic *s, double f0, double w1, double f1) {
    const double drop = sqrt(2 * f1 / (-s->k * sf_cubic_slope(s, w1)));
    return sf_refine(s, fmax(-f0 / (s->k * s->q), w1 - drop), 0, w1, 1);
}

/* The only root, of a quartic that rises for all w > 0 from f0 < 0. */
SF_ALWAYS double sf_root_of_rising(const sf_quartic *s, double f0) {
    const double p = s->p, E = -f0 / s->k;
    const double root = sqrt(p * p + 4 * s->A * E);
    const double high = sqrt(p > 0 ? 4 * E / (p + root) : (root - p) / s->A);
    const double line = E / s->q; /* infinite for q = 0 */
    const double start = p >= 0 ? fmin(high, line) : high;
    return sf_refine(s, start, 0, 2 * high, 1);
}

/* ==== One root at a time ========================================================================================== */

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

SF_ALWAYS double sf_root_at(const sf_isolated *q, sf_place place) {
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

/* All of them with their multiplicity: pairs that touch are two, and where maximum and minimum coincide there are
 * three. */
SF_ALWAYS int sf_all_roots(const sf_isolated *q, double Omega[3]) {
    sf_place place[3];
    int n = sf_places(q->exist, q->f0 < 0, q->f1 > 0, q->f2 < 0, place);
    if (q->exist && q->f1 == 0 && q->w1 > 0)
        n = 3, place[0] = place[1] = SF_AT_W1, place[2] = q->f2 < 0 ? SF_ABOVE : SF_AT_W2;
    else if (q->exist && q->f2 == 0)
        place[n++] = SF_AT_W2, place[n++] = SF_AT_W2;
    for (int i = 0; i < n; i++)
        Omega[i] = sf_root_at(q, place[i]);
    return n;
}

/* ==== A number of roots that is known ============================================================================= */

/* Along a curve the number of roots is known from both sides. Where rounding hides a pair that is about to meet, or
 * shows one that has met already, the known number decides, and the place where the pair meets represents the root. */

/* Place of root number `index` of `count`, also where the signs count otherwise. */
static inline sf_place sf_place_of(int exist, double f0, double f1, double f2, int count, int index) {
    sf_place place[3];
    const int shown = sf_places(exist, f0 < 0, f1 > 0, f2 < 0, place);
    if (shown == count)
        return index >= 0 && index < count ? place[index] : SF_AT_W2;
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

/* ==== Public ====================================================================================================== */

SF_ALWAYS int sf_response_roots(double A, double h, double m, double zeta, double F_0, double Omega[3]) {
    sf_isolated q;
    Omega[0] = Omega[1] = Omega[2] = NAN;
    if (!(A > 0 && m >= 0 && zeta >= 0 && F_0 >= 0 && A + fabs(h) + m + zeta + F_0 < HUGE_VAL))
        return -1;
    if (F_0 < m)
        return 0; /* I >= m > F_0: the mass sticks */
    sf_isolate_response(&q, A, h, m, zeta, F_0);
    return sf_all_roots(&q, Omega);
}

SF_ALWAYS int sf_fold_roots(double A, double h, double h_A, double m, double zeta, double Omega[3]) {
    sf_isolated q;
    double scale = 1;
    int n = 0;
    Omega[0] = Omega[1] = Omega[2] = NAN;
    if (!(A > 0 && m >= 0 && zeta >= 0 && A + fabs(h) + m + zeta < HUGE_VAL && fabs(h_A) < HUGE_VAL))
        return -1;
    if (zeta == 0) { /* two factors: the backbone, and one in h_A alone */
        const double x = h < 0 ? slow_flow_backbone(A, h) : 0;
        const double y = h_A < 0 ? slow_flow_undamped_Omega(h_A) : 0;
        if (fmin(x, y) > 0)
            Omega[n++] = fmin(x, y);
        if (fmax(x, y) > 0)
            Omega[n++] = fmax(x, y);
        return n;
    }
    if (SF_UNLIKELY(fabs(h_A) > 0x1p100)) { /* next to a corner: measure w in units of sqrt|h_A|, lest w^4 overflow */
        int e;
        frexp(h_A, &e);
        e /= 4;
        scale = ldexp(1, 2 * e);
        A = ldexp(A, 2 * e), h = ldexp(h, -2 * e), h_A = ldexp(h_A, -4 * e), m = ldexp(m, -2 * e);
        zeta = ldexp(zeta, -2 * e);
    }
    sf_isolate_fold(&q, A, h, h_A, m, zeta);
    n = sf_all_roots(&q, Omega);
    for (int i = 0; i < n; i++)
        Omega[i] *= scale;
    return n;
}

/* The roots of sf_peak_roots as far as double finds them, and the cubic by which sf_polish_cubic settles each. */
SF_ALWAYS int sf_unpolished_peak_roots(sf_quartic *s, double A, double h, double m, double zeta, double Omega[2]) {
    double w1, w2;
    Omega[0] = Omega[1] = NAN;
    if (!(A > 0 && m >= 0 && zeta >= 0 && A + fabs(h) + m + zeta < HUGE_VAL))
        return -1;
    s->kind = SF_RESPONSE;
    s->A = A, s->h = h, s->h_A = 0, s->m = m, s->zeta = zeta, s->F_0 = 0;
    sf_derivative_coefficients(s);
    if (!sf_critical_points(s, &w1, &w2))
        return 0;
    if (w1 == 0) {
        Omega[0] = w2;
        return 1;
    }
    Omega[0] = w1, Omega[1] = w2;
    return 2;
}

SF_ALWAYS int sf_peak_roots(double A, double h, double m, double zeta, double Omega[2]) {
    sf_quartic s;
    int n = sf_unpolished_peak_roots(&s, A, h, m, zeta, Omega);
    for (int i = 0; i < n; i++)
        Omega[i] = sf_polish_cubic(&s, Omega[i]);
    return n;
}
