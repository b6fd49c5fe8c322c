/* Points at which two functions of amplitude and frequency vanish, by any laws of damping and either excitation: in
 * goes a piece of the force, out come all of them.
 *
 * Unknowns are the amplitude and the balance R: Omega^2 = (R - h)/A, in which nothing cancels where R is small, as at a
 * fold of weak damping; or the frequency w, where R is not small against h. Under an excitation by inertia all is over
 * Omega^2, in w = 1/Omega: Omega^-2 = (R - A)/h. None is missed: a box is left only when it is proved to hold no point,
 * or exactly one. First what both functions demand narrows R and w (demands.h), which nearly removes a dimension; then
 * one of them may have a sign on what is left. If the determinant of their slopes has one, the box holds no more than
 * one point (the slopes between two points are among those of the box). That there is one Krawczyk's operator proves on
 * a small box around where Newton's method leads. Else the box is cut; where that goes on until no double lies between
 * its ends, it is marked undecided. As in scan.h what kernels err by is taken for granted (SF_ERROR).
 */
#pragma once

#include "demands.h"
#include "krawczyk.h"

enum {
    SF_MOST_BOXES = 200000, /* looked at, after which the search is given up */
    SF_FEW_BOXES = 500,     /* the same where there is another way */
    SF_NEWTON_STEPS = 40
};
/* of R, relatively: a box that is no wider is not cut any more */
#define SF_THIN 0x1p-50
/* of F_0: the same next to a jump of the force */
#define SF_THIN_AT_JUMP 0x1p-24
/* a cell so narrow is tried where the sign of R is not known */
#define SF_NARROW_CELL 0x1p-6
/* where R is cut, not in the middle: what vanishes there would lie on the edges of two boxes */
#define SF_ASKEW 0.4375
/* a w that counts as 0 where widths are compared */
#define SF_LOW 0x1p-10
/* by how much more than A the other unknown has to move the functions to be cut */
#define SF_MUCH_MORE 4
/* of h, or where all is over Omega^2 of A: an R that is less is the unknown */
#define SF_SMALL_SHARE 0.5
/* how far a box around a point extends, as a multiple of what it is not known by, and as a share of it at least */
#define SF_AROUND 8
#define SF_AROUND_LEAST 0x1p-44
/* what of a piece is left out next to rest, with a preload */
#define SF_NEXT_TO_PRELOAD 0x1p-60
/* how far above a corner no cell of turns and cusps is cut: derivatives of h, which come from infinity there, are less
 * known on less; and of R how wide a box in it is not cut any more */
#define SF_NEXT_TO_CORNER 0x1p-40
#define SF_THIN_AT_CORNER 0x1p-20

/* ==== The functions ============================================================================================== */

typedef void sf_functions_of(double w, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA,
                             double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3,
                             double h, double h_A, double h_AA, double h_AAA, double R, double I, double R_A,
                             double I_A, double *out);
typedef void sf_functions_on(sf_interval w, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A,
                             sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A,
                             sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h,
                             sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I,
                             sf_interval R_A, sf_interval I_A, sf_interval *out);

/* Of each system, of a force and of inertia, by R and by w: both functions and their slopes by A and by the other
 * unknown, of the first and then of the second. Turns know of neither. */
/* clang-format off */
#define SF_NEAR(of) {dissipation_##of##_by_R, dissipation_##of##_by_Omega}
#define SF_FAR(of) {dissipation_##of##_far_by_R, dissipation_##of##_far_by_x}
#define SF_FORMS(of)                                                                                                   \
    {{SF_NEAR(of##folds), SF_FAR(of##folds)},                                                                          \
     {SF_NEAR(of##peaks), SF_FAR(of##peaks)},                                                                          \
     {SF_NEAR(of##cusps), SF_FAR(of##cusps)},                                                                          \
     {SF_NEAR(of##isolas), SF_FAR(of##isolas)},                                                                        \
     {SF_NEAR(of##turns), {NULL, NULL}}}
/* clang-format on */

static sf_functions_of *const sf_at_points[SF_LAW_SYSTEMS][2][2] = SF_FORMS();
static sf_functions_on *const sf_on_boxes[SF_LAW_SYSTEMS][2][2] = SF_FORMS(intervals_);

/* On a box, of which u is the other unknown. */
static void sf_functions_within(const sf_law_search *search, const sf_strip *strip, int by_w, sf_interval u,
                                sf_interval out[6]) {
    const sf_cell *cell = &strip->cell;
    const sf_interval *rest = strip->rest, *zeta = strip->zeta;
    const sf_interval w = by_w ? u : sfi_sqrt(sf_square_of(search, strip, u));
    sf_balances of;
    sf_balances_at(search, strip, w, &of);
    if (!by_w)
        of.R = u, of.R_A = sf_slope_of(search, strip, u);
    sf_on_boxes[search->system][search->far][by_w](
        w, cell->A, search->force, rest[0], rest[1], rest[2], rest[3], zeta[0], zeta[1], zeta[2], zeta[3],
        search->laws.d, search->laws.d_3, cell->h, cell->h_A, cell->h_AA, cell->h_AAA, of.R, of.I, of.R_A, of.I_A, out);
}

/* At a point, of which Omega, R and the size of its terms are set, NaN where there is none. */
static void sf_functions_at(const sf_law_search *search, const sf_sample *at, sf_law_point *point, double out[6]) {
    const sf_law_terms terms = sf_law_terms_at(search->model, at->A, search->laws.beyond);
    const double A = at->A, u = point->u, *rest = terms.rest, *zeta = terms.zeta, d = terms.d, d_3 = terms.d_3;
    const double square = search->far ? (u - A) / at->h : (u - at->h) / A;
    const double w = point->by_w ? u : square > 0 ? sqrt(square) : NAN;
    double of[4];
    if (search->far) {
        dissipation_far(w, A, rest[0], rest[1], zeta[0], zeta[1], d, at->h, at->h_A, of);
        point->Omega = 1 / w, point->size = A + fabs(at->h) * w * w;
    } else {
        of[0] = slow_flow_R(w, A, at->h), of[1] = w * w + at->h_A;
        of[2] = dissipation_I(w, A, rest[0], zeta[0], d, d_3);
        of[3] = dissipation_I_A(w, A, rest[1], zeta[0], zeta[1], d, d_3);
        point->Omega = w, point->size = fabs(at->h) + A * w * w;
    }
    if (!point->by_w)
        of[0] = u, of[1] = search->far ? (at->k + at->h_A * u) / at->h : (u - at->k) / A;
    point->R = of[0];
    sf_at_points[search->system][search->far][point->by_w](w, A, search->F_0, rest[0], rest[1], rest[2], rest[3],
                                                           zeta[0], zeta[1], zeta[2], zeta[3], d, d_3, at->h, at->h_A,
                                                           at->h_AA, at->h_AAA, of[0], of[2], of[1], of[3], out);
}

static sf_interval sf_determinant(const sf_interval f[6]) { return sfi_sub(sfi_mul(f[2], f[5]), sfi_mul(f[3], f[4])); }

/* ==== One point ================================================================================================== */

/* Newton's method from a place in a box; 0 where it leads nowhere, or beyond the piece. */
static int sf_approach_point(const sf_law_search *search, sf_law_point *point) {
    double last = HUGE_VAL, f[6];
    for (int i = 0; i < SF_NEWTON_STEPS; i++) {
        const sf_sample at = sf_sample_at(search->model, point->A);
        sf_functions_at(search, &at, point, f);
        const double determinant = f[2] * f[5] - f[3] * f[4];
        const double by_A = (f[0] * f[5] - f[3] * f[1]) / determinant, by_u = (f[2] * f[1] - f[0] * f[4]) / determinant;
        const double off = fmax(fabs(by_A) / point->A, fabs(by_u) / (fabs(point->u) + fabs(at.h) * SF_ERROR));
        if (!(off < HUGE_VAL))
            return 0;
        /* as far as roundings let it come; next to a breakpoint functions vary on the scale of what is beyond it */
        const double beyond = fmax(point->A - search->base, 0x1p-22 * point->A);
        if (off <= 0x1p-52 || (off <= 0x1p-30 && off >= 0.5 * last && fabs(by_A) <= 0x1p-30 * beyond))
            return 1;
        last = off;
        point->A -= by_A, point->u -= by_u;
        if (!(point->A > search->base && point->A <= search->end * (1 + 0x1p-20) && (!point->by_w || point->u > 0)))
            return 0;
    }
    return last <= 0x1p-30;
}

/* The functions at a place, within their roundings. */
static void sf_functions_about(const sf_law_search *search, const double place[2], int by_w, sf_interval out[6]) {
    sf_strip strip;
    sf_node node;
    sf_node_at(search, place[0], &node);
    sf_make_strip(search, &node, &node, &strip);
    sf_functions_within(search, &strip, by_w, sfi_point(place[1]), out);
}

/* Krawczyk's operator on a box between two corners, from a place in it: at: the functions there; on: on the box */
static void sf_map_box(const sf_interval at[6], const sf_interval on[6], const double place[2], const double low[2],
                       const double high[2], double centre[2], double radius[2]) {
    double wide[2], floor_[2];
    sf_values of;
    for (int i = 0; i < 2; i++) {
        of.at[i] = at[i], of.slope[i][0] = on[2 + 2 * i], of.slope[i][1] = on[3 + 2 * i];
        wide[i] = fmax(high[i] - place[i], place[i] - low[i]);
    }
    sf_krawczyk(2, place, wide, &of, centre, radius, floor_);
}

static inline sf_interval *sf_second_unknown(sf_law_box *box) { return box->by_w ? &box->of.w : &box->of.R; }

/* Whether a box around a point, which is made, is proved to hold exactly one. */
static int sf_prove_point(const sf_law_search *search, sf_law_point *point, sf_law_box *around) {
    const double A = point->A, u = point->u, place[2] = {A, u};
    double centre[2], radius[2], extent[2];
    sf_interval at[6], on[6];
    sf_strip strip;
    sf_functions_about(search, place, point->by_w, at);
    sf_map_box(at, at, place, place, place, centre, radius);
    for (int i = 0; i < 2; i++)
        extent[i] = SF_AROUND * (fabs(centre[i] - place[i]) + radius[i]);
    point->off_A = sfi_most(extent[0], sfi_least(SF_AROUND_LEAST * A, 0.25 * (A - search->base)));
    point->off_u = sfi_most(extent[1], SF_AROUND_LEAST * (fabs(u) + SF_CLOSE * point->size)); /* R may be 0 */
    if (!(A - point->off_A > search->base && A <= search->end && point->off_u < HUGE_VAL))
        return 0;
    const double low[2] = {A - point->off_A, u - point->off_u};
    const double high[2] = {sfi_least(A + point->off_A, search->end), u + point->off_u};
    sf_node_at(search, low[0], &around->a), sf_node_at(search, high[0], &around->b);
    around->by_w = point->by_w, *sf_second_unknown(around) = sfi_of(low[1], high[1]);
    sf_make_strip(search, &around->a, &around->b, &strip);
    sf_functions_within(search, &strip, point->by_w, *sf_second_unknown(around), on);
    sf_map_box(at, on, place, low, high, centre, radius);
    return sf_is_within(2, low, high, centre, radius);
}

/* Whether a box, of which the functions are known, is proved to hold none, as next to a point outside. */
static int sf_is_left(const sf_law_search *search, const sf_law_box *box, double middle, sf_interval u,
                      const sf_interval on[6]) {
    const double place[2] = {middle, 0.5 * (u.lo + u.hi)}, low[2] = {box->a.at.A, u.lo}, high[2] = {box->b.at.A, u.hi};
    double centre[2], radius[2];
    sf_interval at[6];
    sf_functions_about(search, place, box->by_w, at);
    sf_map_box(at, on, place, low, high, centre, radius);
    return sf_is_off(2, low, high, centre, radius);
}

static void sf_add_point(sf_law_points *found, const sf_law_point *point) {
    for (int i = 0; i < found->n; i++) {
        const sf_law_point *other = &found->at[i];
        if (other->part == point->part && fabs(other->A - point->A) <= fmax(other->off_A, point->off_A) &&
            (other->by_w == point->by_w ? fabs(other->u - point->u) <= fmax(other->off_u, point->off_u)
                                        : fabs(other->R - point->R) <= SF_CLOSE * point->size))
            return;
    }
    if (found->n == SF_MOST_POINTS)
        found->status = SF_TOO_MANY;
    else
        found->at[found->n++] = *point;
}

/* Omega of a fold that was found by R, by a step of Newton's method in it: from R it has the roundings of h besides. A
 * is kept, of which that step would lose digits where R is small. */
static void sf_polish_Omega(const sf_law_search *search, sf_law_point *point) {
    sf_law_point at_w = *point;
    double f[6];
    at_w.by_w = 1, at_w.u = search->far ? 1 / point->Omega : point->Omega;
    const sf_sample at = sf_sample_at(search->model, point->A);
    sf_functions_at(search, &at, &at_w, f);
    const double w = at_w.u - (f[2] * f[1] - f[0] * f[4]) / (f[2] * f[5] - f[3] * f[4]);
    if (fabs(w - at_w.u) <= SF_CLOSE * at_w.u)
        point->Omega = search->far ? 1 / w : w;
}

/* The level at a point by R itself, of which A Omega^2 + h may leave little: as at A = 0 with R for h and I for m. */
static double sf_level_at_point(const sf_law_search *search, const sf_law_point *point) {
    const double w = point->Omega, R = search->far ? point->R * w * w : point->R;
    const double I = sf_law_I(search->model, point->A, w);
    return (sf_inertial(search->model) ? inertia_level : slow_flow_level)(w, 0, I, 0, R);
}

/* Whether the only point that a box may have is found, where the determinant has a sign on the box. */
static int sf_settle_point(sf_law_search *search, sf_law_box *box, double middle) {
    const sf_interval u = *sf_second_unknown(box);
    sf_law_point point = {.A = middle, .u = 0.5 * (u.lo + u.hi), .by_w = box->by_w, .part = search->part};
    sf_law_box around;
    if (!sf_approach_point(search, &point) || !sf_prove_point(search, &point, &around))
        return 0;
    const sf_interval near = *sf_second_unknown(&around);
    if (around.a.at.A > box->b.at.A || around.b.at.A < box->a.at.A || sf_is_none(sfi_both(near, u)))
        return 0;
    if (around.a.at.A < box->a.at.A || around.b.at.A > box->b.at.A || near.lo < u.lo || near.hi > u.hi) {
        /* on the edge: there is no other in both together */
        sf_interval slopes[6];
        sf_strip strip;
        sf_make_strip(search, around.a.at.A < box->a.at.A ? &around.a : &box->a,
                      around.b.at.A > box->b.at.A ? &around.b : &box->b, &strip);
        sf_functions_within(search, &strip, box->by_w, sfi_join(u, near), slopes);
        if (!sfi_has_sign(sf_determinant(slopes)))
            return 0;
    }
    if (!point.by_w && search->system == SF_LAW_FOLDS)
        sf_polish_Omega(search, &point);
    sf_add_point(&search->found, &point);
    return 1;
}

/* ==== The search ================================================================================================= */

/* Whether it is the other unknown that is cut, with which both functions change more than with A. Next to a jump no
 * slope by A is bounded, next to w = 0 none by R. */
static int sf_moves_by_other(const sf_law_search *search, const sf_law_box *box, sf_interval u,
                             const sf_interval f[6]) {
    const double width = box->b.at.A - box->a.at.A, height = u.hi - u.lo;
    const double of_A[] = {sf_size_of(f[2]) * width, sf_size_of(f[4]) * width};
    const double of_u[] = {sf_size_of(f[3]) * height, sf_size_of(f[5]) * height};
    const int is_A_bounded = of_A[0] < HUGE_VAL && of_A[1] < HUGE_VAL;
    const int is_u_bounded = of_u[0] < HUGE_VAL && of_u[1] < HUGE_VAL;
    const int is_unlimited = search->F_0 == HUGE_VAL && search->system != SF_LAW_ISOLAS;
    if (is_A_bounded && is_u_bounded)
        return of_u[0] > SF_MUCH_MORE * of_A[0] && of_u[1] > SF_MUCH_MORE * of_A[1];
    if (is_A_bounded || is_u_bounded)
        return is_A_bounded;
    if (is_unlimited && u.hi == HUGE_VAL)
        return width < SF_NARROW_CELL * box->b.at.A;
    if (!sf_is_forced(search) && !is_unlimited && search->base > 0)
        return height * (box->b.at.A - search->base) * SF_MUCH_MORE * SF_MUCH_MORE >
               width * sfi_most(sf_size_of(u), SF_LOW * SF_LOW);
    return height * box->b.at.A >
           width * sfi_most(sf_size_of(u), box->by_w || !sf_is_forced(search) ? SF_LOW : search->F_0);
}

/* Whether R is no small difference of A Omega^2 and h, or R over Omega^2 does not determine w, as h may vanish. */
static int sf_is_R_large(const sf_law_search *search, const sf_strip *strip, sf_interval R) {
    const double size = SF_SMALL_SHARE * sf_size_of(search->far ? strip->cell.A : strip->cell.h);
    return R.lo >= size || R.hi <= -size || (search->far && !(strip->cell.h.hi < 0));
}

/* Looks at a box: 0 where it is settled. middle: where the cell is cut; other: whether it is not A that is cut */
static int sf_look_at_box(sf_law_search *search, sf_law_box *box, double middle, int inside, int *other) {
    sf_strip strip;
    *other = 0;
    sf_make_strip(search, &box->a, &box->b, &strip);
    if (!sf_narrow_unknowns(search, &strip, &box->of))
        return 0;
    box->by_w = sf_is_R_large(search, &strip, box->of.R);
    if (box->a.at.A > 0 && (inside || box->b.at.A <= search->blurred) &&
        (sfi_has_sign(box->of.R) || box->b.at.A - box->a.at.A < SF_NARROW_CELL * box->a.at.A)) {
        const sf_interval u = *sf_second_unknown(box);
        sf_interval f[6];
        sf_functions_within(search, &strip, box->by_w, u, f);
        if (sfi_has_sign(f[0]) || sfi_has_sign(f[1]))
            return 0;
        if (inside && sfi_has_sign(sf_determinant(f)) &&
            (sf_settle_point(search, box, middle) ||
             ((box->by_w || sf_square_of(search, &strip, u).lo >= 0) && sf_is_left(search, box, middle, u, f))))
            return 0;
        *other = sf_moves_by_other(search, box, u, f);
    }
    return 1;
}

/* Where the other unknown is cut, not in the middle: what vanishes there would lie on the edges of two boxes. */
static double sf_cut_other(sf_interval u) {
    if (u.hi == HUGE_VAL)
        return u.lo > -HUGE_VAL ? 4 * sfi_most(u.lo, 1) : 0;
    return (1 - SF_ASKEW) * u.lo + SF_ASKEW * u.hi;
}

/* Whether boxes next to an amplitude are undecided as it is. */
static int sf_is_in_doubt(const sf_law_points *found, double A) {
    return found->undecided > 0 && fabs(found->doubt[found->undecided - 1] - A) <= SF_CLOSE * A;
}

/* All points of a system on a piece of the force from `first` to `last`. */
static void sf_search_points(sf_law_search *search, const sf_sample *first, const sf_sample *last) {
    sf_law_points *found = &search->found;
    const int most = search->model->by_laws ? SF_MOST_BOXES : SF_FEW_BOXES;
    int top = 0;
    search->end = last->A;
    if ((search->system == SF_LAW_TURNS && isinf(first->h_A)) ||
        (search->system == SF_LAW_CUSPS && search->F_0 == HUGE_VAL && isinf(first->h_AA)))
        search->blurred = (1 + SF_NEXT_TO_CORNER) * first->A;
    else
        search->blurred = 0;
    search->pending[0].a.at = *first, search->pending[0].b.at = *last;
    /* with a preload what lies next to rest is left out: there A Omega^2 is all that counts, and F has no fold but
     * where F_0 is m, or what holds the mass, to rounding */
    if (first->A == 0 && first->h != 0)
        search->pending[0].a.at = sf_sample_at(search->model, SF_NEXT_TO_PRELOAD * last->A);
    sf_know(&search->pending[0].a.at, &search->pending[0].a.known);
    sf_know(&search->pending[0].b.at, &search->pending[0].b.known);
    search->pending[0].of.R = sf_all(), search->pending[0].of.w = sfi_of(0, HUGE_VAL);
    for (top = 1; top > 0;) {
        sf_law_box *box = &search->pending[top - 1], *next = box + 1;
        const double a = box->a.at.A, b = box->b.at.A, middle = sf_amid(search->base, a, b);
        const int inside = middle > a && middle < b && b - a > SF_NARROW * b && b > search->blurred;
        const double thin = b > search->blurred ? SF_THIN : SF_THIN_AT_CORNER;
        int other;
        sf_interval *u;
        double at;
        if (found->boxes++ > most || found->status != SF_OK) {
            found->status = SF_UNRESOLVED;
            return;
        }
        if (b < SF_FIRST || !sf_look_at_box(search, box, middle, inside, &other)) {
            top--;
            continue;
        }
        u = sf_second_unknown(box), at = sf_cut_other(*u);
        int is_thin = !(at > u->lo && at < u->hi) || (u->hi < HUGE_VAL && u->hi - u->lo <= thin * sf_size_of(*u));
        /* next to a jump F_A bounds no R from below, and F has its square only */
        is_thin |= isinf(box->a.at.h_A) && sf_is_forced(search) && !box->by_w &&
                   u->hi - u->lo <= SF_THIN_AT_JUMP * search->F_0;
        if (!inside && (is_thin || sf_is_in_doubt(found, b))) {
            if (found->undecided < SF_MOST_POINTS)
                found->doubt[found->undecided++] = b;
            top--;
            continue;
        }
        if (top == SF_MOST_PENDING) {
            found->status = SF_UNRESOLVED;
            return;
        }
        *next = *box;
        if ((other && !is_thin) || !inside) {
            u->lo = sf_second_unknown(next)->hi = at;
        } else {
            sf_node_at(search, middle, &box->a);
            next->b = box->a;
        }
        top++;
    }
}

static void sf_begin_search(const sf_model *model, sf_law_system system, double F_0, sf_law_search *search) {
    search->model = model, search->system = system, search->F_0 = F_0, search->force = sfi_point(F_0);
    search->far = sf_inertial(model) && system != SF_LAW_TURNS && !(system == SF_LAW_CUSPS && F_0 == HUGE_VAL);
    search->found.n = search->found.boxes = search->found.undecided = 0, search->found.status = SF_OK;
}

/* piece: its number */
static void sf_begin_piece(sf_law_search *search, int piece) {
    search->part = piece, search->base = piece > 0 ? search->model->b[piece - 1] : 0;
    sf_hold_laws(search->model, piece, &search->laws);
}

/* All points of the pieces up to an amplitude. */
static void sf_search_pieces(const sf_model *model, sf_law_system system, double F_0, const sf_stretches *pieces,
                             sf_law_search *search) {
    sf_begin_search(model, system, F_0, search);
    for (int i = 0; i < pieces->n && search->found.status == SF_OK; i++) {
        /* where there is no spring F rises with Omega, or falls over Omega^4: next to where it is flat, to the fourth
         * power */
        if (system == SF_LAW_PEAKS && !sf_has_force(&pieces->at[i]))
            continue;
        sf_begin_piece(search, i);
        sf_search_points(search, &pieces->at[i].first, &pieces->at[i].last);
    }
}
