/* States and folds of motions with a mean on boxes of both ends of the motion. Takes what turning_points.h knows of a
 * box; returns intervals that hold what vanishes there, what the balance of the mean f_0 = c_0 - load = 0 leaves of
 * the box, and p = -h/A and e = -h_A - p along the balance.
 *
 * The mathematics is derivations/asymmetric/off_centre.py's. An odd force without a load has motions about the centre,
 * B = 0, which have solvers of their own: `centred`.
 */
#pragma once

#include "dissipation.h"
#include "turning_points.h"

/* less than it is rest, as its square is beyond the range of doubles */
#define SF_LEAST_AMPLITUDE 0x1p-500
/* what rounding does to a bound */
#define SF_BOUND_ERROR 0x1p-40

/* I = m + eta A + 2 zeta A Omega + d (A Omega)^2 */
typedef struct {
    double m, zeta, eta, d;
} sf_damping;

static double sf_sine(const sf_damping *of, double Omega, double A) {
    return dissipation_I(Omega, A, of->m + of->eta * A, of->zeta, of->d, 0);
}

static double sf_sine_A(const sf_damping *of, double Omega, double A) {
    return dissipation_I_A(Omega, A, of->eta, of->zeta, 0, of->d, 0);
}

/* (c_1^2 - s_1^2)/(2 c_1), as h_A = 2 s_0/A - 4 of it along the balance; and A's slope, of c_1's sign.
 *
 * With p = c_x and q = -c_y it is p q/(X q + Y p), which rises with p and with q as long as c_1 has a sign. */
static sf_interval sf_resists(const sf_ended *here, sf_interval *rising) {
    sf_interval resistance[2];
    double end[2];
    off_centre_intervals_ended_along(here->A, here->s_0, here->c_x, here->c_y, here->X, here->Y, resistance);
    *rising = resistance[0];
    for (int up = 0; up < 2; up++) {
        const double p = up ? here->c_x.hi : here->c_x.lo, q = up ? here->c_y.lo : here->c_y.hi;
        const double X = (p < 0) != up ? here->X.lo : here->X.hi, Y = (q > 0) != up ? here->Y.lo : here->Y.hi;
        double at[2];
        off_centre_ended_along(1, 0, p, q, X, Y, at);
        const double value = -at[1] / at[0];
        end[up] = value + (up ? 0x1p-48 : -0x1p-48) * fabs(value);
    }
    return sfi_has_sign(resistance[0]) && isfinite(end[0]) && isfinite(end[1]) ? sfi_of(end[0], end[1]) : sf_any_number;
}

/* 2 c_1 */
static sf_interval sf_stiffness(const sf_ended *here) {
    return sfi_sub(sfi_div(here->c_x, here->X), sfi_div(here->c_y, here->Y));
}

static int sf_touches_centre(const sf_ended *here) { return here->B.lo <= 0 && here->B.hi >= 0; }

/* The same of motions off the centre, of an odd force without a load, next to it. */
static sf_interval sf_resists_near(const sf_ended *here) {
    if (!sfi_has_sign(here->c_3))
        return sf_any_number;
    return sfi_times(0.5, off_centre_intervals_beside(here->B, here->c_3, here->s_2));
}

/* Whether c_1 has a sign, or the box is not at the centre: where f_0/B vanishes, c_1 between 0 and B has none, so that
 * where it has one next to the centre no motion is off it. */
static int sf_is_single(const sf_ended *here) { return !sf_touches_centre(here) || sfi_has_sign(sf_stiffness(here)); }

/* What the balance leaves of a box, low and high, and what is known on it, p and `resists`: whether some may be. */
static int sf_on_balance(const sf_ended *here, const sf_ended *middle, double load, int centred, double *low,
                         double *high, sf_interval *p, sf_interval *resists, sf_interval *rising) {
    const sf_interval f = sfi_sub(middle->c_0, sfi_point(load)), slopes[2] = {here->c_x, here->c_y};
    const sf_interval by[2] = {here->c_x, sfi_neg(here->c_y)}, turns[2] = {here->X, here->Y};
    sf_interval r[2], shift[2], nearer;
    int some = !sfi_has_sign(sfi_sub(here->c_0, sfi_point(load))) && !(here->A.hi <= SF_LEAST_AMPLITUDE);
    for (int i = 0; i < 2; i++) {
        const double at = 0.5 * (low[i] + high[i]), wide = fmax(high[i] - at, at - low[i]) * (1 + SF_BOUND_ERROR);
        r[i] = sfi_of(-wide, wide), shift[i] = sfi_mul(slopes[i], r[i]);
    }
    some &= !sfi_has_sign(sfi_add(sfi_add(f, shift[0]), shift[1]));
    for (int i = 0; i < 2; i++) {
        const sf_interval left =
            sfi_sub(sfi_point(0.5 * (low[i] + high[i])), sfi_div(sfi_add(f, shift[1 - i]), slopes[i]));
        if (sfi_has_sign(slopes[i]))
            low[i] = fmax(low[i], left.lo), high[i] = fmin(high[i], left.hi);
        some &= !(low[i] > high[i]);
    }
    /* p = 2 s_0/A, with its slopes 2 (c_x - X p)/A and -2 (c_y + Y p)/A */
    *p = sfi_div(sfi_times(2, here->s_0), here->A), nearer = sfi_div(sfi_times(2, middle->s_0), middle->A);
    for (int i = 0; i < 2; i++)
        nearer = sfi_add(nearer, sfi_mul(sfi_div(sfi_times(2, sfi_sub(by[i], sfi_mul(turns[i], *p))), here->A), r[i]));
    *p = here->A.lo <= 0 ? sf_any_number : sf_both(*p, nearer);
    *resists = sf_resists(here, rising);
    if (centred && !sf_is_single(here)) {
        /* of motions about the centre, and off it */
        const sf_interval c_1 = sfi_times(0.25, sf_stiffness(here)), limit = sf_resists_near(here);
        const sf_interval hull = sfi_of(fmin(limit.lo, c_1.lo), fmax(limit.hi, c_1.hi));
        const int known = isfinite(limit.lo) && isfinite(limit.hi) && isfinite(c_1.lo) && isfinite(c_1.hi);
        *resists = known ? hull : sf_any_number;
    }
    return some;
}

/* I and I_A, which rise with both. */
static void sf_balance_of_sine(const sf_damping *of, double Omega, sf_interval A, sf_interval *I_, sf_interval *I_A) {
    const double end[2] = {A.lo, A.hi};
    double value[2], slope[2];
    for (int i = 0; i < 2; i++) {
        const double error = i ? 1 + SF_BOUND_ERROR : 1 - SF_BOUND_ERROR;
        value[i] = error * sf_sine(of, Omega, end[i]), slope[i] = error * sf_sine_A(of, Omega, end[i]);
    }
    *I_ = sfi_of(value[0], value[1]), *I_A = sfi_of(slope[0], slope[1]);
}

/* Whether a state may be at a frequency, where its force lies between the least and the most level. */
static int sf_may_be_state(const sf_damping *of, double Omega, double force, sf_interval A, sf_interval p) {
    const sf_interval R = sfi_mul(A, sfi_sub(sfi_point(Omega * Omega), p));
    const double needed = force * force, least = sf_sine(of, Omega, A.lo), most = sf_sine(of, Omega, A.hi);
    const sf_interval level = sfi_add(sfi_square(R), sfi_square(sfi_of(least, most)));
    return !(level.lo > needed * (1 + SF_BOUND_ERROR) || level.hi < needed * (1 - SF_BOUND_ERROR));
}

/* What vanishes at a state, and its slopes by x and y. */
static void sf_ended_state(const sf_ended *here, double Omega, double force, const sf_damping *of, double load,
                           sf_interval *out) {
    sf_interval I_, I_A;
    sf_balance_of_sine(of, Omega, here->A, &I_, &I_A);
    off_centre_intervals_ended_state(sfi_point(Omega), here->A, sfi_point(force), I_, I_A, sfi_point(load), here->c_0,
                                     here->s_0, here->c_x, here->c_y, here->X, here->Y, out);
}

/* What vanishes at a fold, its slopes by x, y and R, and between which R a fold is. */
static void sf_ended_fold(const sf_ended *here, sf_interval R, double F_0, double F_2, const sf_damping *of,
                          double load, int centred, sf_interval *out) {
    const sf_interval above = sfi_add(R, sfi_times(2, here->s_0));
    const sf_interval square = {fmax(above.lo, 0), above.hi <= 0 ? 0 : above.hi};
    const sf_interval of_speed = sfi_mul(square, here->A), by_speed = sfi_times(of->d, of_speed), m = sfi_point(of->m);
    const sf_interval force = sfi_add(sfi_point(F_0), sfi_mul(sfi_point(F_2), sfi_div(square, here->A)));
    const sf_interval I_ = sfi_add(
        sfi_add(sfi_add(sfi_times(of->eta, here->A), sfi_times(2 * of->zeta, sfi_sqrt(of_speed))), by_speed), m);
    const int single = !centred || sf_is_single(here);
    sf_interval rising, resistance = sf_resists(here, &rising);
    if (!single)
        resistance = sf_resists_near(here);
    off_centre_intervals_ended_fold(R, here->A, sfi_point(F_0), sfi_point(F_2), m, sfi_point(of->eta),
                                    sfi_point(of->zeta), sfi_point(of->d), sfi_point(load), here->c_0, here->s_0,
                                    here->c_x, here->c_y, here->c_xx, here->c_yy, here->X, here->Y, here->X_x,
                                    here->Y_y, out);
    if (centred && single && sf_touches_centre(here))
        out[0] = sfi_point(1);
    /* R (h - A h_A) = G^2 + I (A I_A - I), and R^2 = G^2 - I^2 */
    const sf_interval by_line = sfi_div(sfi_add(sfi_square(force), sfi_mul(I_, sfi_sub(by_speed, m))),
                                        sfi_times(4, sfi_sub(sfi_mul(here->A, resistance), here->s_0)));
    const double most = sfi_sqrt(sfi_sub(sfi_square(force), sfi_square(I_))).hi;
    out[12] = sf_both(by_line, sfi_of(-most, most));
}

/* ==== Between which R folds are ================================================================================== */

/* parts of the range of |y|, and how often what is left of it is cut into parts again: folds that are about to meet,
 * next to a cusp, leave no less than half of it each time, and their level has to be known better than an onset's gap
 */
enum { SF_FOLD_PARTS = 8, SF_FOLD_ROUNDS = 10, SF_FOLD_HALVINGS = 60 };

/* I I_A/A, with friction's share at another amplitude: I/A has half of the slope of quadratic damping's part of I,
 * whose share of I_A/A knows no amplitude. */
static double sf_resistance(const sf_damping *of, double Omega, double A, double of_friction) {
    const double over = dissipation_I_A(Omega, A, of->eta, of->zeta, 0, 0.5 * of->d, 0);
    const double at_rest = dissipation_I_A(Omega, 0, of->eta, of->zeta, 0, 0, 0),
                 rising = dissipation_I_A(Omega, 1, 0, 0, 0, of->d, 0);
    return of->m * (at_rest / of_friction + rising) + sf_sine_A(of, Omega, A) * over;
}

static double sf_share_of(double far, double square) { return square > 0 ? far / square : HUGE_VAL; }

/* Between which the square of the forcing is of folds with |y|, Omega^2 = x and Omega between ends. */
static sf_interval sf_levels(const sf_damping *of, int inertial, double sign, sf_interval A, sf_interval p,
                             const double *y, const double *x, const double *Omega) {
    double low = y[0], high = y[1], I_low = sf_sine(of, Omega[0], A.lo), I_high = sf_sine(of, Omega[1], A.hi);
    if (inertial) {
        /* of y/Omega^2 = y/(p + y) either way, and I/Omega^2, which falls with Omega */
        low = fmax(sf_share_of(y[0], x[1]),
                   fmin(sf_share_of(y[0], p.hi + sign * y[0]), sf_share_of(y[1], p.hi + sign * y[1])));
        high = fmin(sf_share_of(y[1], x[0]),
                    fmax(sf_share_of(y[0], p.lo + sign * y[0]), sf_share_of(y[1], p.lo + sign * y[1])));
        I_low = sf_share_of(sf_sine(of, Omega[1], A.lo), Omega[1] * Omega[1]);
        I_high = sf_share_of(sf_sine(of, Omega[0], A.hi), Omega[0] * Omega[0]);
    }
    low *= A.lo, high *= A.hi;
    return sfi_of(low * low + I_low * I_low, high * high + I_high * I_high);
}

/* What |R| <= F_0 Omega^2 is not more than; infinite next to the amplitude that is tended to as Omega rises.
 *
 * Above it A Omega^2 = R + A p. Below it 1/Omega^2 has to be so large that F over Omega^4 is not negative. */
static double sf_most_by_inertia(const sf_damping *of, sf_interval A, sf_interval p, double F_0) {
    const double size = fmax(fabs(p.lo), fabs(p.hi)), beyond = A.lo > F_0 ? F_0 * size / (1 - F_0 / A.lo) : HUGE_VAL;
    double low = 0, high = A.hi < F_0 ? 1 : 0;
    for (int i = 0; i < SF_FOLD_HALVINGS; i++) {
        const double z = 0.5 * (low + high), R = A.hi * (1 + size * z);
        const double I_ = (of->m + of->eta * A.hi) * z + 2 * of->zeta * A.hi * sqrt(z) + of->d * A.hi * A.hi;
        if ((R * R + I_ * I_) * (1 + SF_BOUND_ERROR) < F_0 * F_0)
            low = z;
        else
            high = z;
    }
    return fmin(beyond, low > 0 ? F_0 / low : HUGE_VAL);
}

/* Whether there may be folds with R = A y, y = Omega^2 - p of that sign, at forcings between two; and between which |R|
 * at the highest. A fold has y (e - y) A = I I_A, with y of the sign of e.
 *
 * e: NaN or infinite where it is not known */
static int sf_folds_between(const sf_damping *of, int inertial, double sign, sf_interval A, sf_interval p,
                            sf_interval e, double lowest, double highest, sf_interval *R) {
    const double above = 1 + SF_BOUND_ERROR, below = 1 - SF_BOUND_ERROR;
    const double at_most = sqrt(sfi_most(highest * highest - of->m * of->m, 0));
    const sf_interval turned = sign > 0 ? e : sfi_neg(e);
    const double least_e = fmax(turned.lo, 0), most_e = (isnan(turned.hi) ? HUGE_VAL : turned.hi) * above;
    double start = sign > 0 && !(p.hi >= 0) ? -p.hi : 0, end = most_e;
    if (!inertial)
        end = fmin(end, at_most / A.lo * above);
    if (sign < 0 && !(end < p.hi))
        end = p.hi < 0 ? 0 : p.hi;
    int left = end >= start && end >= 0;
    const int unknown = !isfinite(end) || !isfinite(p.lo) || !isfinite(p.hi);
    for (int round = 0; left && round < SF_FOLD_ROUNDS; round++) {
        const double width = end - start;
        int first = SF_FOLD_PARTS, last = 0;
        for (int k = 0; k < SF_FOLD_PARTS; k++) {
            const double y[2] = {(start + k * width / SF_FOLD_PARTS) * below,
                                 (start + (k + 1) * width / SF_FOLD_PARTS) * above};
            const double x[2] = {fmax(sign > 0 ? p.lo + y[0] : p.lo - y[1], 0),
                                 fmax(sign > 0 ? p.hi + y[1] : p.hi - y[0], 0)};
            const double Omega[2] = {sqrt(x[0]), sqrt(x[1])}, middle = fmin(fmax(0.5 * most_e, y[0]), y[1]);
            const double slowest = fmin(y[0] * (least_e - y[0]), y[1] * (least_e - y[1]));
            const sf_interval level = sf_levels(of, inertial, sign, A, p, y, x, Omega);
            if (!isinf(most_e) &&
                !(middle * (most_e - middle) * above >= sf_resistance(of, Omega[0], A.lo, A.hi) * below))
                continue;
            if (slowest * below > sf_resistance(of, Omega[1], A.hi, A.lo) * above)
                continue;
            if (!(level.lo * below <= highest * highest) || level.hi * above < lowest * lowest)
                continue;
            first = first < k ? first : k, last = k + 1;
        }
        left = last > 0;
        if (!left || (first == 0 && last == SF_FOLD_PARTS))
            break;
        end = start + last * width / SF_FOLD_PARTS, start += first * width / SF_FOLD_PARTS;
    }
    const double most = inertial ? sf_most_by_inertia(of, A, p, highest) : at_most;
    start *= A.lo, end *= A.hi;
    *R = sfi_of(sfi_least(fmax(start, 0), most) * below, sfi_least(isnan(end) ? HUGE_VAL : end, most) * above);
    return left || unknown;
}
