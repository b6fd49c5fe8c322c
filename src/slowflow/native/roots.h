/* Positive frequencies at a given amplitude: in go A, h, h_A, m, zeta, F_0, out come sorted Omega and their number.
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
 * Conventions, the same as in slowflow.averaged.reference.roots:
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
#ifndef SF_ROOTS_H
#define SF_ROOTS_H

#include <math.h>

#if defined(__GNUC__)
#define SF_ALWAYS static inline __attribute__((always_inline))
#define SF_RARELY __attribute__((noinline, cold, unused)) static
#define SF_UNLIKELY(x) __builtin_expect(!!(x), 0)
#else
#define SF_ALWAYS static inline
#define SF_RARELY static inline
#define SF_UNLIKELY(x) (x)
#endif

#define SF_ROUGH 0x1p-50 /* a value below this part of its terms has no certain sign in double */
#define SF_FINE 0x1p-98  /* the same in double-double */

typedef struct {
    double hi, lo;
} sf_dd;

SF_ALWAYS sf_dd sf_two_sum(double a, double b) {
    sf_dd s;
    double t;
    s.hi = a + b;
    t = s.hi - a;
    s.lo = (a - (s.hi - t)) + (b - t);
    return s;
}

SF_ALWAYS sf_dd sf_two_product(double a, double b) {
    sf_dd s;
    s.hi = a * b;
    s.lo = fma(a, b, -s.hi);
    return s;
}

SF_ALWAYS sf_dd sf_renormalise(double hi, double lo) {
    sf_dd s;
    s.hi = hi + lo;
    s.lo = lo - (s.hi - hi);
    return s;
}

/* ==== The formulas.  Everything below this block is a solver that knows only these. =============================== */

typedef enum { SF_RESPONSE, SF_FOLD } sf_kind;

typedef struct {
    sf_kind kind;
    double A, h, h_A, m, zeta, F_0;
    double k; /* derivative of the quartic: k (A w^3 + p w + q) */
    sf_dd p, q;
} sf_quartic;

/* R and I at the point w + tail in double-double; the tail is a correction below the last place of w. */
SF_ALWAYS void sf_R_and_I(const sf_quartic *s, double w, double tail, sf_dd *R, sf_dd *I) {
    const sf_dd Aw = sf_two_product(s->A, w);
    const sf_dd Aww = sf_two_product(Aw.hi, w);
    const sf_dd y = sf_two_product(2 * s->zeta, Aw.hi);
    *R = sf_two_sum(Aww.hi, s->h);
    R->lo += fma(Aw.lo, w, Aww.lo) + 2 * Aw.hi * tail;
    *I = sf_two_sum(y.hi, s->m);
    I->lo += fma(2 * s->zeta, Aw.lo + s->A * tail, y.lo);
}

/* The quartic in double.  Its rounding error is below SF_ROUGH * size. */
SF_ALWAYS double sf_value(const sf_quartic *s, double w, double *size) {
    const double Aw = s->A * w, Aww = Aw * w;
    const double R = Aww + s->h, I = 2 * s->zeta * Aw + s->m, R_terms = Aww + fabs(s->h);
    if (s->kind == SF_RESPONSE) {
        *size = (fabs(R) + SF_ROUGH * R_terms) * R_terms + (I + s->F_0) * (I + s->F_0);
        return R * R + (I - s->F_0) * (I + s->F_0);
    } else {
        const double T = w * w + s->h_A, T_terms = w * w + fabs(s->h_A), last = 2 * s->zeta * w * I;
        *size = (fabs(R) + SF_ROUGH * R_terms) * T_terms + fabs(T) * R_terms + last;
        return R * T + last;
    }
}

/* The quartic at w + tail in double-double, rounded to double.  Its error is below SF_FINE * size. */
SF_ALWAYS double sf_value_dd(const sf_quartic *s, double w, double tail, double *size) {
    sf_dd R, I;
    const double R_terms = s->A * w * w + fabs(s->h);
    sf_R_and_I(s, w, tail, &R, &I);
    if (s->kind == SF_RESPONSE) {
        const sf_dd RR = sf_two_product(R.hi, R.hi), II = sf_two_product(I.hi, I.hi);
        const sf_dd FF = sf_two_product(s->F_0, s->F_0);
        const sf_dd u = sf_two_sum(II.hi, -FF.hi), v = sf_two_sum(RR.hi, u.hi);
        const double low = (RR.lo + R.lo * (2 * R.hi + R.lo)) + ((II.lo - FF.lo) + 2 * I.hi * I.lo);
        *size = (fabs(R.hi) + SF_FINE * R_terms) * R_terms + (I.hi + s->F_0) * (I.hi + s->F_0);
        return v.hi + (v.lo + (u.lo + low));
    } else {
        const sf_dd ww = sf_two_product(w, w);
        sf_dd T = sf_two_sum(ww.hi, s->h_A);
        const sf_dd y = sf_two_product(2 * s->zeta, w);
        const sf_dd yI = sf_two_product(y.hi, I.hi);
        sf_dd RT, v;
        double low;
        T.lo += ww.lo + 2 * w * tail;
        RT = sf_two_product(R.hi, T.hi);
        v = sf_two_sum(RT.hi, yI.hi);
        low = (RT.lo + (R.hi * T.lo + R.lo * (T.hi + T.lo))) +
              (yI.lo + (y.hi * I.lo + (y.lo + 2 * s->zeta * tail) * I.hi));
        *size = (fabs(R.hi) + SF_FINE * R_terms) * (ww.hi + fabs(s->h_A)) + fabs(T.hi) * R_terms + y.hi * I.hi;
        return v.hi + (v.lo + low);
    }
}

/* The quartic at 0 in double, with the bound of sf_value. */
SF_ALWAYS double sf_value_at_0(const sf_quartic *s, double *size) {
    if (s->kind == SF_RESPONSE) {
        *size = s->h * s->h + (s->m + s->F_0) * (s->m + s->F_0);
        return s->h * s->h + (s->m - s->F_0) * (s->m + s->F_0);
    }
    *size = 0; /* a single product has a certain sign */
    return s->h * s->h_A;
}

/* Coefficients of the derivative k (A w^3 + p w + q): for F_Omega, p = h + 2 zeta^2 A and q = zeta m. */
SF_ALWAYS void sf_derivative_coefficients(sf_quartic *s) {
    const sf_dd z = sf_two_product(2 * s->zeta, s->zeta);
    const sf_dd y = sf_two_product(z.hi, s->A);
    const double y_lo = fma(z.lo, s->A, y.lo);
    s->q = sf_two_product(s->zeta, s->m);
    if (s->kind == SF_RESPONSE) {
        const sf_dd p = sf_two_sum(s->h, y.hi);
        s->k = 4 * s->A;
        s->p = sf_renormalise(p.hi, p.lo + y_lo);
    } else { /* p = (h + A h_A)/2 + 2 zeta^2 A, q = zeta m / 2 */
        const sf_dd t = sf_two_product(s->A, s->h_A);
        const sf_dd u = sf_two_sum(s->h, t.hi);
        const sf_dd p = sf_two_sum(0.5 * u.hi, y.hi);
        s->k = 4;
        s->p = sf_renormalise(p.hi, p.lo + (y_lo + 0.5 * (u.lo + t.lo)));
        s->q.hi *= 0.5;
        s->q.lo *= 0.5;
    }
}

/* ==== The cubic A w^3 + p w + q, q >= 0 =========================================================================== */

/* The cubic at w + tail in double-double, rounded to double. */
SF_ALWAYS double sf_cubic_dd(const sf_quartic *s, double w, double tail) {
    const sf_dd aw = sf_two_product(s->A, w);
    const sf_dd aww = sf_two_product(aw.hi, w);
    const sf_dd b = sf_two_sum(aww.hi, s->p.hi);
    const double b_lo = b.lo + (fma(aw.lo, w, aww.lo) + 2 * aw.hi * tail + s->p.lo);
    const sf_dd wb = sf_two_product(w, b.hi);
    const sf_dd v = sf_two_sum(wb.hi, s->q.hi);
    return v.hi + (v.lo + (wb.lo + (w * b_lo + tail * b.hi) + s->q.lo));
}

/* 1 - rho^2 = (4 |p|^3 - 27 A q^2) / (4 |p|^3) in double-double, for p < 0; 0 where only rounding is left. */
SF_RARELY double sf_gap_dd(const sf_quartic *s) {
    const double p_lo = s->p.hi < 0 ? -s->p.lo : s->p.lo, p = fabs(s->p.hi);
    const sf_dd p2 = sf_two_product(p, p);
    const double p2_lo = p2.lo + 2 * p * p_lo;
    const sf_dd p3 = sf_two_product(p2.hi, p);
    const double p3_lo = p3.lo + (p2_lo * p + p2.hi * p_lo);
    const sf_dd q2 = sf_two_product(s->q.hi, s->q.hi);
    const double q2_lo = q2.lo + 2 * s->q.hi * s->q.lo;
    const sf_dd c = sf_two_product(27, s->A);
    const sf_dd d = sf_two_product(c.hi, q2.hi);
    const double d_lo = d.lo + (c.hi * q2_lo + c.lo * q2.hi);
    const sf_dd gap = sf_two_sum(4 * p3.hi, -d.hi);
    const double value = gap.hi + (gap.lo + (4 * p3_lo - d_lo));
    return fabs(value) <= SF_FINE * 4 * p3.hi ? 0 : value / (4 * p3.hi);
}

/* Number of points where the cubic vanishes on w >= 0, counted with multiplicity (0 or 2), and these points.
 *
 * With y = w / sqrt(-p/3A) the cubic is y^3 - 3 y + 2 rho, whose roots are cos(b) +- sqrt(3) sin(b), 3 b = acos(rho).
 * cos(b) is well conditioned on 0 <= rho <= 1, and sin(b) = sin(3b) / (4 cos(b)^2 - 1), so two Newton steps on
 * 4 c^3 - 3 c = rho take the place of the trigonometric functions.  The small root follows from Vieta. */
SF_ALWAYS int sf_critical_points(const sf_quartic *s, double *w1, double *w2) {
    double r, rho, gap, c, y2;
    if (!(s->p.hi < 0))
        return 0;
    if (s->q.hi == 0) {
        *w1 = 0;
        *w2 = sqrt(-s->p.hi / s->A);
        return 2;
    }
    r = sqrt(-s->p.hi / (3 * s->A));
    rho = 1.5 * s->q.hi / (-s->p.hi * r);
    if (rho > 1 + 0x1p-26)
        return 0;
    gap = (1 - rho) * (1 + rho);
    if (SF_UNLIKELY(rho > 1 - 0x1p-26)) {
        gap = sf_gap_dd(s);
        if (gap < 0)
            return 0;
    }
    /* cubic Hermite interpolation of c(rho) between c(0) = sqrt(3)/2, c' = 1/6 and c(1) = 1, c' = 1/9 */
    {
        const double c0 = 0.86602540378443865, rise = 0.13397459621556135;
        c = c0 + rho * (1. / 6 + rho * ((3 * rise - 4. / 9) + rho * (5. / 18 - 2 * rise)));
    }
    c = (8 * c * c * c + rho) / (12 * c * c - 3);
    c = (8 * c * c * c + rho) / (12 * c * c - 3);
    y2 = c + 1.7320508075688773 * sqrt(gap) / (4 * c * c - 1);
    *w1 = r * rho / (y2 * c);
    *w2 = r * y2;
    return 2;
}

/* Newton with the double-double residual, on a simple root of the cubic near w. */
SF_ALWAYS double sf_polish_cubic(const sf_quartic *s, double w) {
    int i;
    for (i = 0; i < 8; i++) {
        const double slope = 3 * s->A * w * w + s->p.hi;
        const double step = sf_cubic_dd(s, w, 0) / slope;
        if (!(fabs(step) <= 0x1p-10 * w))
            break; /* a double root: the slope is noise, and w is as good as it gets */
        w -= step;
        if (3 * s->A * w * step * step <= 0x1p-58 * w * fabs(slope))
            break;
    }
    return w;
}

/* ==== The quartic ================================================================================================= */

/* h^2 + m^2 - F_0^2 with a certain sign: the six exact parts are distilled until they no longer overlap. */
SF_RARELY double sf_response_at_0(const sf_quartic *s) {
    const sf_dd a = sf_two_product(s->h, s->h), b = sf_two_product(s->m, s->m), c = sf_two_product(s->F_0, s->F_0);
    double x[6];
    int i, pass;
    x[0] = a.lo, x[1] = b.lo, x[2] = -c.lo, x[3] = a.hi, x[4] = b.hi, x[5] = -c.hi;
    for (pass = 0; pass < 6; pass++)
        for (i = 1; i < 6; i++) {
            const sf_dd t = sf_two_sum(x[i], x[i - 1]);
            x[i] = t.hi, x[i - 1] = t.lo;
        }
    return x[5] + (x[4] + (x[3] + (x[2] + (x[1] + x[0]))));
}

/* The quartic at its critical point near w, in double-double; 0 where only rounding is left. */
SF_RARELY double sf_critical_value_dd(const sf_quartic *s, double w) {
    double tail = 0, start, rise, value, size;
    int i;
    for (i = 0; i < 3; i++) {
        const double step = sf_cubic_dd(s, w, 0) / (3 * s->A * w * w + s->p.hi);
        if (!(fabs(step) <= 0x1p-10 * w))
            break; /* maximum and minimum coincide: the value does not depend on w in second order */
        tail = -step;
        if (i < 2)
            w += tail;
    }
    /* The rise from w = 0, whose terms may be far smaller than those of the value; A w^3 + q = -p w is used. */
    start = s->kind == SF_RESPONSE ? sf_response_at_0(s) : s->h * s->h_A;
    rise = s->k * w * w * (-0.5 * s->p.hi - 0.75 * s->A * w * w);
    if (fabs(start + rise) > 0x1p-40 * (fabs(start) - s->k * w * w * s->p.hi))
        return start + rise;
    value = sf_value_dd(s, w, tail, &size);
    return fabs(value) <= SF_FINE * size ? 0 : value;
}

SF_ALWAYS double sf_critical_value(const sf_quartic *s, double w) {
    double size;
    const double value = sf_value(s, w, &size);
    return SF_UNLIKELY(fabs(value) <= SF_ROUGH * size) ? sf_critical_value_dd(s, w) : value;
}

SF_ALWAYS double sf_slope(const sf_quartic *s, double w) { return w * (s->A * w * w + s->p.hi) + s->q.hi; }

/* The root between lo and hi, where the quartic is monotone and rises (+1) or falls (-1), from the first guess w. */
SF_ALWAYS double sf_refine(const sf_quartic *s, double w, double lo, double hi, double rising) {
    int i;
    if (SF_UNLIKELY(!(w > lo && w < hi)))
        w = 0.5 * (lo + hi);
    for (i = 0; i < 12; i++) { /* Halley in double, until the next error is below 2^-36 of the distance to a fold */
        double size, next, moved;
        const double f = sf_value(s, w, &size);
        const double C = sf_slope(s, w), D = 3 * s->A * w * w + s->p.hi;
        if (fabs(f) <= SF_ROUGH * size)
            break;
        next = w - 2 * f * C / (2 * s->k * C * C - f * D);
        if (f * rising < 0)
            lo = w;
        else
            hi = w;
        if (SF_UNLIKELY(!(next > lo && next < hi)))
            next = 0.5 * (lo + hi);
        moved = fabs(next - w);
        w = next;
        if (moved * fabs(D) <= 0x1p-12 * fabs(C) && moved <= 0x1p-12 * w)
            break;
    }
    for (i = 0; i < 100; i++) { /* Newton with the double-double residual: once, but for nearly multiple roots */
        double size, next;
        const double f = sf_value_dd(s, w, 0, &size);
        const double C = sf_slope(s, w), D = 3 * s->A * w * w + s->p.hi;
        const double step = f / (s->k * C);
        next = w - step;
        if (fabs(step * D) * fabs(step) <= 0x1p-57 * fabs(C) * w && next >= lo && next <= hi)
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
    const double twice_vv = fmax(3 * w2 * w2 + s->p.hi / s->A, 0);
    const double twice_S = 2 * sqrt(-f2 / (s->k * s->A));
    const double start = w2 + twice_S / (sqrt(0.5 * twice_vv) + sqrt(0.5 * twice_vv + twice_S));
    return sf_refine(s, start, w2, 2 * start, 1);
}

/* The root between the maximum w1 with f1 > 0 and the minimum w2 with f2 < 0. */
SF_ALWAYS double sf_root_between(const sf_quartic *s, double w1, double f1, double w2, double f2) {
    double start;
    if (f1 < -f2) {
        start = w1 + sqrt(2 * f1 / (-s->k * (3 * s->A * w1 * w1 + s->p.hi)));
    } else {
        const double vv = 0.5 * fmax(3 * w2 * w2 + s->p.hi / s->A, 0);
        const double twice_S = 2 * sqrt(-f2 / (s->k * s->A));
        start = w2 - twice_S / (sqrt(vv) + sqrt(fmax(vv - twice_S, 0)));
    }
    return sf_refine(s, start, w1, w2, -1);
}

/* The root between 0, where the value is f0 < 0, and the maximum w1 with f1 > 0.  The quartic is concave here: the
 * tangent at 0 and the parabola at w1 both end below the root. */
SF_ALWAYS double sf_root_below(const sf_quartic *s, double f0, double w1, double f1) {
    const double drop = sqrt(2 * f1 / (-s->k * (3 * s->A * w1 * w1 + s->p.hi)));
    return sf_refine(s, fmax(-f0 / (s->k * s->q.hi), w1 - drop), 0, w1, 1);
}

/* The only root, of a quartic that rises for all w > 0 from f0 < 0. */
SF_ALWAYS double sf_root_of_rising(const sf_quartic *s, double f0) {
    const double p = s->p.hi, E = -f0 / s->k;
    const double root = sqrt(p * p + 4 * s->A * E);
    const double high = sqrt(p > 0 ? 4 * E / (p + root) : (root - p) / s->A);
    const double line = E / s->q.hi; /* infinite for q = 0 */
    const double start = p >= 0 ? fmin(high, line) : high;
    return sf_refine(s, start, 0, 2 * high, 1);
}

SF_ALWAYS int sf_quartic_roots(sf_quartic *s, double Omega[3]) {
    double f0, f1, f2, w1, w2, size;
    int n = 0;
    sf_derivative_coefficients(s);
    f0 = sf_value_at_0(s, &size);
    if (SF_UNLIKELY(fabs(f0) < SF_ROUGH * size))
        f0 = sf_response_at_0(s);
    if (!sf_critical_points(s, &w1, &w2)) {
        if (f0 < 0)
            Omega[n++] = sf_root_of_rising(s, f0);
        return n;
    }
    f2 = sf_critical_value(s, w2);
    if (w1 == 0) { /* biquadratic, closed form: the guess is the root but for rounding */
        if (f2 == 0) {
            Omega[n++] = w2;
            Omega[n++] = w2;
        } else if (f2 < 0) {
            const double twice_S = 2 * sqrt(-f2 / (s->k * s->A));
            const double xx = w2 * w2 + twice_S;
            if (f0 > 0)
                Omega[n++] = sf_refine(s, sqrt(4 * f0 / (s->k * s->A * xx)), 0, w2, -1);
            Omega[n++] = sf_refine(s, sqrt(xx), w2, 2 * sqrt(xx), 1);
        }
        return n;
    }
    f1 = sf_critical_value(s, w1);
    if (f0 < 0 && f1 > 0)
        Omega[n++] = sf_root_below(s, f0, w1, f1);
    if (f1 == 0) {
        Omega[n++] = w1;
        Omega[n++] = w1;
    } else if (f2 == 0) {
        Omega[n++] = w2;
        Omega[n++] = w2;
    } else if (f1 > 0 && f2 < 0) {
        Omega[n++] = sf_root_between(s, w1, f1, w2, f2);
    }
    if (f2 < 0)
        Omega[n++] = sf_root_above(s, w2, f2);
    else if (f1 == 0)
        Omega[n++] = w2; /* triple root */
    return n;
}

/* ==== Public ====================================================================================================== */

SF_ALWAYS int sf_response_roots(double A, double h, double m, double zeta, double F_0, double Omega[3]) {
    sf_quartic s;
    Omega[0] = Omega[1] = Omega[2] = NAN;
    if (!(A > 0 && m >= 0 && zeta >= 0 && F_0 >= 0 && A + fabs(h) + m + zeta + F_0 < HUGE_VAL))
        return -1;
    if (F_0 < m)
        return 0; /* I >= m > F_0: the mass sticks */
    s.kind = SF_RESPONSE;
    s.A = A, s.h = h, s.h_A = 0, s.m = m, s.zeta = zeta, s.F_0 = F_0;
    return sf_quartic_roots(&s, Omega);
}

SF_ALWAYS int sf_fold_roots(double A, double h, double h_A, double m, double zeta, double Omega[3]) {
    sf_quartic s;
    double scale = 1;
    int i, n = 0;
    Omega[0] = Omega[1] = Omega[2] = NAN;
    if (!(A > 0 && m >= 0 && zeta >= 0 && A + fabs(h) + m + zeta < HUGE_VAL && fabs(h_A) < HUGE_VAL))
        return -1;
    if (zeta == 0) { /* two factors: R = 0 and w^2 + h_A = 0 */
        const double x = h < 0 ? sqrt(-h / A) : 0, y = h_A < 0 ? sqrt(-h_A) : 0;
        if (fmin(x, y) > 0)
            Omega[n++] = fmin(x, y);
        if (fmax(x, y) > 0)
            Omega[n++] = fmax(x, y);
        return n;
    }
    s.kind = SF_FOLD;
    s.A = A, s.h = h, s.h_A = h_A, s.m = m, s.zeta = zeta, s.F_0 = 0;
    if (SF_UNLIKELY(fabs(h_A) > 0x1p100)) { /* beside a corner: measure w in units of sqrt|h_A|, lest w^4 overflow */
        int e;
        frexp(h_A, &e);
        e /= 4;
        scale = ldexp(1, 2 * e);
        s.A = ldexp(A, 2 * e), s.h = ldexp(h, -2 * e), s.h_A = ldexp(h_A, -4 * e), s.m = ldexp(m, -2 * e);
        s.zeta = ldexp(zeta, -2 * e);
    }
    n = sf_quartic_roots(&s, Omega);
    for (i = 0; i < n; i++)
        Omega[i] *= scale;
    return n;
}

SF_ALWAYS int sf_peak_roots(double A, double h, double m, double zeta, double Omega[2]) {
    sf_quartic s;
    double w1, w2;
    Omega[0] = Omega[1] = NAN;
    if (!(A > 0 && m >= 0 && zeta >= 0 && A + fabs(h) + m + zeta < HUGE_VAL))
        return -1;
    s.kind = SF_RESPONSE;
    s.A = A, s.h = h, s.h_A = 0, s.m = m, s.zeta = zeta, s.F_0 = 0;
    sf_derivative_coefficients(&s);
    if (!sf_critical_points(&s, &w1, &w2))
        return 0;
    if (w1 == 0) {
        Omega[0] = sf_polish_cubic(&s, w2);
        return 1;
    }
    Omega[0] = sf_polish_cubic(&s, w1);
    Omega[1] = sf_polish_cubic(&s, w2);
    return 2;
}

#endif
