/* The second approximation's answers. Takes its curve, or a critical forcing of the first one; returns folds, states
 * and the peak, which lie between the curve's points, and critical forcings.
 */
#pragma once

#include "second.h"
#include "states.h"

/* ==== Zeros in a bracket ========================================================================================== */

typedef double sf_function(const void *inputs, double x);

/* The zero between a and b, at which the function has the signs of f_a and f_b, to a relative width; Chandrupatla's
 * choice between the inverse quadratic and the middle. */
static double sf_zero_between(sf_function *f, const void *inputs, double a, double f_a, double b, double f_b,
                              double width) {
    double ratio = 0.5, c = a, f_c = f_a;
    for (int i = 0; i < 200; i++) {
        const double x = a + ratio * (b - a), f_x = f(inputs, x);
        if ((f_x < 0) == (f_a < 0))
            c = a, f_c = f_a;
        else
            c = b, f_c = f_b, b = a, f_b = f_a;
        a = x, f_a = f_x;
        const double least = 0.5 * width * fabs(fabs(f_a) < fabs(f_b) ? a : b) / fabs(b - a);
        if (!(least < 0.5) || f_x == 0)
            break;
        const double xi = (a - b) / (c - b), phi = (f_a - f_b) / (f_c - f_b);
        if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
            ratio = f_a / (f_b - f_a) * f_c / (f_b - f_c) + (c - a) / (b - a) * f_a / (f_c - f_a) * f_b / (f_c - f_b);
        else
            ratio = 0.5;
        ratio = fmin(fmax(ratio, least), 1 - least);
    }
    return fabs(f_a) < fabs(f_b) ? a : b;
}

/* ==== Folds ======================================================================================================= */

/* up: whether a sweep leaves it for a larger amplitude */
typedef struct {
    double Omega, A, u_max, A_1;
    int up, corner;
} sf_second_fold;

/* lost: how many of those looked for were not found, next to which the curve is lost; left: of the curve that they were
 * looked for on */
typedef struct {
    int n, lost, tried;
    sf_status status;
    sf_left_out left;
    sf_second_fold at[SF_MOST_FOLDS];
} sf_second_folds;

/* Where F_A is evaluated between two points of a curve, by amplitude. */
typedef struct {
    const sf_second *second;
    double A[2], Omega[2];
} sf_second_between;

static double sf_Omega_between(const sf_second_between *between, double A) {
    const double ratio = (A - between->A[0]) / (between->A[1] - between->A[0]);
    double Omega = between->Omega[0] + ratio * (between->Omega[1] - between->Omega[0]);
    sf_second_approach(between->second, 0, &Omega, &A);
    return Omega;
}

static double sf_slope_between(const void *inputs, double A) {
    const sf_second_between *between = inputs;
    const sf_balance at = sf_second_at(between->second, sf_Omega_between(between, A), A);
    return at.F_A;
}

/* Where F_A changes its sign between two neighbouring points; 0 where it cannot be found. */
static int sf_second_fold_between(const sf_second *second, const sf_second_point *one, const sf_second_point *other,
                                  sf_second_fold *fold) {
    const sf_second_point *low = one->A < other->A ? one : other, *high = one->A < other->A ? other : one;
    const sf_second_between between = {second, {low->A, high->A}, {low->Omega, high->Omega}};
    const double f_low = sf_slope_between(&between, low->A), f_high = sf_slope_between(&between, high->A);
    if (!sf_opposite(f_low, f_high) || !(low->A < high->A))
        return 0;
    fold->A = sf_zero_between(sf_slope_between, &between, low->A, f_low, high->A, f_high, 0x1p-50);
    fold->corner = 0, fold->up = f_low > 0;
    for (int k = 0; k < second->model->breaks; k++)
        if (fabs(fold->A - second->model->b[k]) <= 0x1p-49 * second->model->b[k])
            fold->corner = 1, fold->A = second->model->b[k];
    /* next to a tip the frequency may slip to its other side, and the slope with it */
    if (!fold->corner && !(fabs(sf_slope_between(&between, fold->A)) <= SF_VANISHED * fmax(fabs(f_low), fabs(f_high))))
        return 0;
    fold->Omega = sf_Omega_between(&between, fold->A);
    const sf_balance at = sf_second_at(second, fold->Omega, fold->A);
    fold->u_max = at.u_max, fold->A_1 = at.A_1;
    return 1;
}

static int sf_is_same_fold(const sf_second_fold *a, const sf_second_fold *b) {
    return fabs(a->Omega - b->Omega) <= SF_SETTLED * b->Omega && fabs(a->A - b->A) <= SF_SETTLED * b->A &&
           a->corner == b->corner && a->up == b->up;
}

/* Every fold between points of the curve, by rising Omega. */
static void sf_folds_on(const sf_model *model, double F_0, const sf_second_curve *curve, sf_second_folds *out) {
    const sf_second here = {model, F_0, SF_EVERY_POINT}, *second = &here;
    int k;
    out->n = out->lost = out->tried = 0, out->status = SF_OK;
    for (long i = 1; i < curve->n; i++) {
        const sf_second_point *one = &curve->point[i - 1], *other = &curve->point[i];
        sf_second_fold fold;
        if (one->part != other->part || (one->at.F_A > 0) == (other->at.F_A > 0))
            continue;
        out->tried++;
        if (!sf_second_fold_between(second, one, other, &fold)) {
            out->lost++;
            continue;
        }
        /* where points crowd the curve may turn to and fro within rounding */
        for (k = 0; k < out->n && !sf_is_same_fold(&out->at[k], &fold); k++)
            ;
        if (k < out->n)
            continue;
        if (out->n == SF_MOST_FOLDS) {
            out->status = SF_TOO_MANY;
            return;
        }
        for (k = out->n++; k > 0 && out->at[k - 1].Omega > fold.Omega; k--)
            out->at[k] = out->at[k - 1];
        out->at[k] = fold;
    }
}

/* ==== States ====================================================================================================== */

/* The state at a frequency between two amplitudes with one in between; 0 where it is not found. */
static int sf_second_state(const sf_second *second, double Omega, double low, double A, double high,
                           sf_second_point *out) {
    double step = HUGE_VAL;
    const sf_balance at_low = sf_second_at(second, Omega, low);
    const sf_balance at_high = sf_second_at(second, Omega, high);
    const int between = (at_low.F > 0) != (at_high.F > 0);
    for (int k = 0; k < SF_STEPS && fabs(step) > 0x1p-52 * A; k++) {
        const sf_balance at = sf_second_at(second, Omega, A);
        if (between && (at.F > 0) == (at_high.F > 0))
            high = A;
        else if (between)
            low = A;
        step = at.F / at.F_A;
        if (between && !(A - step >= low && A - step <= high) && fabs(step) > SF_DONE * A)
            A = sqrt(low * high);
        else
            A = fmin(fmax(A - step, low), high);
    }
    out->Omega = Omega, out->A = A;
    out->at = sf_second_at(second, Omega, A);
    return fabs(step) <= SF_DONE * A;
}

/* The states at a frequency where the curve crosses it, by rising A; out has room for as many as sf_most_crossings
 * says. */
static int sf_states_on(const sf_model *model, double F_0, const sf_second_curve *curve, double Omega,
                        sf_second_point *out) {
    const sf_second here = {model, F_0, SF_EVERY_POINT}, *second = &here;
    int n = 0, k;
    for (long i = 1; i < curve->n; i++) {
        const sf_second_point *one = &curve->point[i - 1], *other = &curve->point[i];
        sf_second_point found;
        if (one->part != other->part || (one->Omega > Omega) == (other->Omega > Omega))
            continue;
        const double ratio = (Omega - one->Omega) / (other->Omega - one->Omega);
        if (!sf_second_state(second, Omega, fmin(one->A, other->A), exp(log(one->A) + ratio * log(other->A / one->A)),
                             fmax(one->A, other->A), &found))
            continue;
        /* a curve that turns next to a corner may cross a frequency to and fro within rounding */
        for (k = 0; k < n && fabs(out[k].A - found.A) > SF_SETTLED * found.A; k++)
            ;
        if (k < n)
            continue;
        for (k = n++; k > 0 && out[k - 1].A > found.A; k--)
            out[k] = out[k - 1];
        out[k] = found;
    }
    return n;
}

static long sf_most_crossings(const sf_second_curve *curve, double Omega) {
    long n = 0;
    for (long i = 1; i < curve->n; i++)
        n += curve->point[i - 1].part == curve->point[i].part &&
             (curve->point[i - 1].Omega > Omega) != (curve->point[i].Omega > Omega);
    return n;
}

/* ==== Critical forcings =========================================================================================== */

/* F, F_A and F_AA over F_0^2 by ln A, at a state given by logarithms. */
static void sf_second_cusp_at(const sf_second *second, double ln_Omega, double ln_A, double out[2]) {
    const double Omega = exp(ln_Omega), A = exp(ln_A), per = A / (second->F_0 * second->F_0);
    double k[SF_KNOWN], folds[3];
    sf_second_known(second->model, 1, &A, k);
    second_approximation_folds(Omega, A, second->F_0, second->model->m, second->model->zeta, k[0], k[1], k[2], k[3],
                               k[4], k[5], k[6], k[7], k[8], k[9], k[10], k[11], folds);
    out[0] = folds[1] * per, out[1] = folds[2] * per * A;
}

/* The lowest forcing that has a fold, from the first approximation's cusp: F_A = F_AA = 0, which do not hold F_0, by
 * Newton's iteration with differences for slopes; 0 where it does not come near. */
static int sf_second_cusp(const sf_model *model, const sf_onset *first, sf_onset *out, double *u_max) {
    const sf_second second = {model, first->F_SN, SF_EVERY_POINT};
    const double from[2] = {log(first->Omega), log(first->A)}, apart = 0x1p-20;
    double x[2] = {from[0], from[1]}, g[2], length = HUGE_VAL, balance[3];
    for (int i = 0; i < SF_STEPS && length > 0x1p-50; i++) {
        double by[2][2], step[2];
        sf_second_cusp_at(&second, x[0], x[1], g);
        for (int j = 0; j < 2; j++) {
            double up[2], down[2];
            sf_second_cusp_at(&second, x[0] + (j == 0) * apart, x[1] + (j == 1) * apart, up);
            sf_second_cusp_at(&second, x[0] - (j == 0) * apart, x[1] - (j == 1) * apart, down);
            by[0][j] = (up[0] - down[0]) / (2 * apart), by[1][j] = (up[1] - down[1]) / (2 * apart);
        }
        const double determinant = by[0][0] * by[1][1] - by[0][1] * by[1][0];
        step[0] = -(g[0] * by[1][1] - g[1] * by[0][1]) / determinant;
        step[1] = -(g[1] * by[0][0] - g[0] * by[1][0]) / determinant;
        length = fmax(fabs(step[0]), fabs(step[1]));
        if (!(length < HUGE_VAL))
            return 0;
        for (int j = 0; j < 2; j++)
            x[j] += step[j] * fmin(1, SF_LONGEST / length);
    }
    double Omega = exp(x[0]), A = exp(x[1]);
    if (!(length <= SF_DONE && fabs(x[0] - from[0]) <= SF_SMALL && fabs(x[1] - from[1]) <= SF_SMALL))
        return 0;
    sf_second_level(model, Omega, A, balance);
    out->F_SN = balance[0];
    if (!(fabs(log(out->F_SN / first->F_SN)) <= SF_SMALL && sf_second_is_small(&second, Omega, A)))
        return 0;
    out->Omega = Omega, out->A = A, out->kind = SF_CUSP_KIND, out->rest = first->rest;
    *u_max = balance[1];
    return 1;
}

/* A at which the largest displacement is u at a frequency: above it by what friction's harmonics take off; and the
 * forcing, u_max and what vanishes where the forcing is least. */
static double sf_second_reaching(const sf_model *model, double u, double Omega, double balance[3]) {
    double A = u;
    for (int i = 0; i < SF_STEPS; i++) {
        sf_second_level(model, Omega, A, balance);
        if (fabs(u / balance[1] - 1) <= SF_ROUNDING)
            break;
        A *= u / balance[1];
    }
    return A;
}

typedef struct {
    const sf_model *model;
    double u;
} sf_second_reach;

static double sf_turning_at(const void *inputs, double Omega) {
    const sf_second_reach *reach = inputs;
    double balance[3];
    sf_second_reaching(reach->model, reach->u, Omega, balance);
    return balance[2];
}

/* The lowest forcing whose largest displacement is u_cr; no iteration over A and Omega at once: next to u_cr, above
 * which the harmonics change, it gets stuck. 0 where it does not come near. */
static int sf_second_detach(const sf_model *model, double F_first, double Omega_first, double u_cr, double *F_cr,
                            double *Omega_cr) {
    const sf_second_reach reach = {model, u_cr};
    const sf_second second = {model, F_first, SF_EVERY_POINT};
    if (Omega_first == 0)
        return 0;
    for (int i = 10; i >= 0; i--) {
        const double width = ldexp(SF_SMALL, -i), low = Omega_first * exp(-width), high = Omega_first * exp(width);
        const double f_low = sf_turning_at(&reach, low), f_high = sf_turning_at(&reach, high);
        double balance[3];
        if (!(f_low < 0 && f_high > 0))
            continue;
        *Omega_cr = sf_zero_between(sf_turning_at, &reach, low, f_low, high, f_high, 0x1p-46);
        const double A = sf_second_reaching(model, u_cr, *Omega_cr, balance);
        *F_cr = balance[0];
        /* without damping it is nought to rounding */
        if (fabs(A / u_cr - 1) < SF_SMALL && fabs(*F_cr - F_first) < SF_SMALL * F_first + SF_DONE * u_cr &&
            sf_second_is_small(&second, *Omega_cr, A))
            return 1;
    }
    return 0;
}

/* What vanishes where u_max is largest along the curve, by frequency; near a peak A hardly depends on that. */
typedef struct {
    const sf_second *second;
    double A;
} sf_second_near;

static double sf_amplitude_near(const sf_second_near *near, double Omega, double balance[3]) {
    double A = near->A;
    const double step = sf_second_approach(near->second, 1, &Omega, &A);
    sf_second_level(near->second->model, Omega, A, balance);
    return fabs(step) <= SF_DONE ? A : NAN;
}

static double sf_turning_near(const void *inputs, double Omega) {
    double balance[3];
    sf_amplitude_near(inputs, Omega, balance);
    return balance[2];
}

/* The highest peak of a curve; 0 where there is none between its points. */
static int sf_peak_on(const sf_model *model, double F_0, const sf_second_curve *curve, sf_second_point *out) {
    const sf_second here = {model, F_0, SF_EVERY_POINT}, *second = &here;
    sf_second_near near = {second, 0};
    const sf_second_point *top = NULL, *low, *high;
    double balance[3];
    for (long i = 1; i + 1 < curve->n; i++)
        if (curve->point[i - 1].part == curve->point[i + 1].part &&
            (top == NULL || curve->point[i].at.u_max > top->at.u_max))
            top = &curve->point[i];
    if (top == NULL || !(top->at.u_max >= top[-1].at.u_max && top->at.u_max >= top[1].at.u_max))
        return 0;
    low = top[-1].Omega < top[1].Omega ? top - 1 : top + 1, high = low == top - 1 ? top + 1 : top - 1;
    near.A = top->A;
    const double f_low = sf_turning_near(&near, low->Omega), f_high = sf_turning_near(&near, high->Omega);
    if (!(low->Omega < high->Omega && sf_opposite(f_low, f_high) && f_low == f_low && f_high == f_high))
        return 0;
    out->Omega = sf_zero_between(sf_turning_near, &near, low->Omega, f_low, high->Omega, f_high, 0x1p-46);
    out->A = sf_amplitude_near(&near, out->Omega, balance);
    if (!(out->A > 0))
        return 0;
    out->at = sf_second_at(second, out->Omega, out->A);
    return 1;
}

/* ==== At a forcing ================================================================================================ */

/* inputs: the oscillator's exact inputs, NULL where its numbers are not known; room: a workspace. */

/* The curve in a window, of about so many samples, from the skeleton of room; NULL if there is no memory, or beyond the
 * range of doubles how far averaging's extends. */
static sf_second_curve *sf_second_shown(const sf_model *model, double F_0, sf_wanted extent, double samples, double low,
                                        double high, sf_room *room, sf_status *status) {
    long n = sf_show(model, F_0, low, high, samples, &room->work);
    sf_second_curve *curve = NULL;
    double *block = n < 0 ? NULL : malloc((size_t)(n + 1) * SF_OF_POINT);
    *status = n < 0 ? SF_NO_BOUND : SF_NO_MEMORY;
    if (block != NULL) {
        const sf_points drawn = sf_points_in(block, n);
        n = sf_draw(model, F_0, samples, &room->work.shown, &drawn);
        curve = sf_second_follow(model, F_0, extent, n, &drawn, room->work.shown.closed);
        if (curve != NULL)
            *status = SF_OK;
    }
    free(block);
    return curve;
}

/* The same, of any skeleton; to be freed by sf_second_free. */
static sf_second_curve *sf_second_response(const sf_model *model, const sf_inputs *inputs, double F_0, sf_wanted extent,
                                           double samples, double low, double high, sf_room *room, sf_status *status) {
    *status = sf_make_skeleton(model, inputs, F_0, room);
    return *status == SF_OK ? sf_second_shown(model, F_0, extent, samples, low, high, room, status) : NULL;
}

/* The curve about some frequencies and what may lie near them. */
static sf_second_curve *sf_second_around(const sf_model *model, const sf_inputs *inputs, double F_0, sf_wanted extent,
                                         double low, double high, sf_room *room, sf_status *status) {
    return sf_second_response(model, inputs, F_0, extent, SF_SAMPLES, low / SF_BEYOND, high * SF_BEYOND, room, status);
}

/* Every fold at F_0; `left`: what of averaging's curve is left out, and how much of it was followed: 0 where there
 * is nothing to start from. Whether doubles resolve averaging's folds is in `room`.
 *
 * low, high: frequencies between which averaging's folds and its peak lie; infinite where these are not known */
static sf_status sf_second_saddle_nodes(const sf_model *model, const sf_inputs *inputs, double F_0, double low,
                                        double high, sf_room *room, sf_second_folds *out) {
    const sf_folds *first = &room->work.folds;
    const int known = high < HUGE_VAL;
    sf_second_curve *curve;
    sf_status status = SF_NONE;
    double A, Omega;
    memset(&out->left, 0, sizeof out->left);
    out->n = out->lost = out->tried = 0, out->status = SF_OK;
    if (!known) {
        high = 0;
        status =
            sf_settled_peak(model, inputs == NULL ? NULL : &inputs->exactly, F_0, HUGE_VAL, &room->work, &A, &Omega);
    }
    if (status != SF_OK && status != SF_UNBOUNDED && status != SF_NONE)
        return status;
    if (status == SF_OK && Omega > 0)
        low = high = Omega;
    status = sf_make_skeleton(model, inputs, F_0, room);
    if (status != SF_OK)
        return status;
    for (int i = 0; i < first->n && !known; i++)
        low = fmin(low, first->at[i].Omega), high = fmax(high, first->at[i].Omega);
    if (high == 0)
        return SF_OK;
    curve = sf_second_shown(model, F_0, SF_FOLDS_ONLY, SF_SAMPLES, low / SF_BEYOND, high * SF_BEYOND, room, &status);
    if (curve == NULL)
        return status;
    sf_folds_on(model, F_0, curve, out);
    out->left = curve->left;
    sf_second_free(curve);
    return out->status;
}

/* The highest peak of the curve about a frequency, which is to be freed if there is one. */
static sf_status sf_second_peak(const sf_model *model, const sf_inputs *inputs, double F_0, double near, sf_room *room,
                                sf_second_curve **curve, sf_second_point *top) {
    sf_status status;
    *curve = sf_second_around(model, inputs, F_0, SF_TOP_ONLY, near, near, room, &status);
    return *curve != NULL && !sf_peak_on(model, F_0, *curve, top) ? SF_NONE : status;
}
