/* Steps in a piece of a force whose sides meet at u = 0, as those of u |u| and |u|^(3/2) do, or that begins behind a
 * gap without a series. Takes a state in it; returns the series of step.h from there on, on the side that the motion
 * is on or comes to. */
#pragma once

#include "first_zero.h"
#include "step.h"

/* half of the nodes of Gauss's rule, SF_NODES, with sf_gauss_node and sf_gauss_weight: see taylor.h */
enum { SF_GRADED = 4, SF_HALVINGS = 60 };
/* a distance from where a piece begins without a series, over what that or the velocity is: nearer coefficients
 * overflow */
#define SF_AT_PLACE 0x1p-36

static SF_INLINE void sf_forceless_begin(const double *p, double *first, double *over) {
    first[1] = 0.0;
    (void)p, (void)over;
}

static SF_INLINE void sf_forceless_next(const sf_coefficients *c, const double *p, double *w, sf_four *left,
                                        sf_four *right) {
    w[1] = 0.0;
    (void)c, (void)p, (void)left, (void)right;
}

/* The motion without the force, or where that is no more than a constant friction. */
static void sf_forceless(const sf_drive *drive, double theta, double u, double v, const sf_four *flow,
                         sf_expansion *x) {
    double over[2], w[4 * 2];
    sf_four left[SF_TERMS], right[SF_TERMS];
    sf_expand(sf_forceless_begin, sf_forceless_next, NULL, drive, theta, u, v, flow, 2, 0, 1, 1, 1, over, w, left,
              right, x);
}

/* What a force without a series at a place does from there on, over a step so short that the way under what it is at
 * that place suffices: the integrals of the rest along that, by Gauss's rule in the fourth root of time. They enter the
 * second coefficients, so that the series hold at the step's end, whose distance is given. */
static double sf_branched(const sf_law *law, const double *p, const sf_drive *inputs, double direction, double side,
                          double theta, double place, double start, double v, const sf_four *flow, sf_expansion *x) {
    const double at_place = law->value(law, p, place);
    sf_drive constant = *inputs;
    const sf_drive *const drive = &constant;
    constant.friction += at_place;
    sf_forceless(drive, theta, start, v, flow, x);
    double h = copysign(fmin(sf_step_of(x, flow != NULL), 0.125), direction);
    for (int i = 0;; i++, h *= 0.5) {
        const double u = sf_at(x->u, h), force = law->value(law, p, u) - at_place, slope = law->slope(law, p, u),
                     cube = fabs(h * h * h);
        const double rate = fabs(sf_at(x->v, h));
        /* what it changes in itself */
        if (side * (u - place) > 0.0 && fabs(force * slope) * cube <= 0x1p-54 * rate &&
            (flow == NULL || slope * slope * cube <= 0x1p-54))
            break;
        if (i == SF_HALVINGS)
            return 0.0;
    }
    double pushes = 0.0, moment = 0.0;
    sf_four by_v = sf_all(0.0), by_u = by_v;
    for (int i = 0; i < 2 * SF_NODES; i++) {
        const double node = i < SF_NODES ? -sf_gauss_node[i] : sf_gauss_node[i - SF_NODES], s = 0.5 * (1.0 + node),
                     cube = s * s * s;
        const double at = h * s * cube, u = sf_at(x->u, at);
        /* over h */
        const double weight = 0.5 * sf_gauss_weight[i % SF_NODES] * SF_GRADED * cube,
                     force = weight * (law->value(law, p, u) - at_place);
        pushes += force, moment += force * (1.0 - at / h);
        if (flow != NULL) {
            sf_four U;
            sf_four_at(x->U, at, &U);
            const sf_four pull = sf_times(sf_all(weight * law->slope(law, p, u)), U);
            by_v = sf_plus(by_v, pull), by_u = sf_more(by_u, pull, sf_all(1.0 - at / h));
        }
    }
    x->v[1] -= pushes, x->u[2] -= moment;
    if (flow != NULL)
        x->V[1] = sf_less(x->V[1], by_v), x->U[2] = sf_less(x->U[2], by_u);
    return fabs(h);
}

/* Where the motion over a piece goes over to another series: where its sides meet, or it begins. */
static inline double sf_meeting(const sf_piece *piece, double u) {
    return piece->law->breaks == SF_BEGINS ? piece->law->begins(piece->law, piece->p[u > 0.0], u) : 0.0;
}

static inline double sf_near(double place, double v) { return SF_AT_PLACE * fmax(fabs(place), fabs(v)); }

/* The piece that holds from (u, v) on: below where one begins without a series the next one does, and where the motion
 * turns next to that. A state comes there by rounding, or as Newton's iteration tries it. */
static inline const sf_piece *sf_piece_at(const sf_piece *piece, const sf_drive *drive, double direction, double theta,
                                          double u, double v) {
    if (piece->law->breaks != SF_BEGINS || piece->below == NULL)
        return piece;
    const double place = sf_meeting(piece, u), side = copysign(1.0, place), beyond = side * (u - place);
    const double push = sf_rate(drive, cos(theta), piece->law->value(piece->law, piece->p[u > 0.0], place), place, 0.0);
    const double goes = v != 0.0 ? v * direction : push, near = sf_near(place, v);
    const int turns = side * push < 0.0 && v * v <= 2.0 * fabs(push) * near;
    return beyond < 0.0 || (beyond <= near && (side * goes < 0.0 || turns)) ? piece->below : piece;
}

/* The series from (u, v) on and the step over which they hold; `direction`: sign of the time that is gone. With the
 * derivatives from those in `flow`, or without where it is NULL. */
static SF_INLINE double sf_expanded(const sf_piece *piece, const sf_drive *drive, double direction, double theta,
                                    double u, double v, const sf_four *flow, sf_expansion *x) {
    const sf_law *const law = piece->law;
    const double *p = piece->p[u > 0.0];
    if (law->breaks == SF_BEGINS) {
        const double place = law->begins(law, p, u);
        if (fabs(u - place) <= sf_near(place, v))
            return sf_branched(law, p, drive, direction, copysign(1.0, place), theta, place, u, v, flow, x);
    } else if (law->breaks == SF_SEAMS) {
        const double goes = v != 0.0 ? v * direction : sf_rate(drive, cos(theta), sf_value(piece, u), u, 0.0);
        const double own = p[law->constants];
        p = law->at(law, u != 0.0 || sf_is_on_one_side(piece) ? own : copysign(1.0, goes), u, goes);
    } else if (sf_is_beyond(piece, u) ||
               (law->breaks == SF_BRANCHES && sf_is_on_one_side(piece) && fabs(u) <= sf_near(0.0, v))) {
        const double own = p[law->constants], goes = v != 0.0 ? v * direction : own;
        if (!sf_is_beyond(piece, u) && goes * own > 0.0)
            return sf_branched(law, p, drive, direction, own, theta, 0.0, u, v, flow, x);
        sf_drive constant = *drive;
        constant.friction += law->value(law, p, 0.0);
        sf_forceless(&constant, theta, u, v, flow, x);
        return sf_step_of(x, flow != NULL);
    } else if (u == 0.0 && law->breaks != SF_SMOOTH) {
        const double side = v != 0.0 ? v * direction : sf_rate(drive, cos(theta), 0.0, 0.0, 0.0);
        p = piece->p[side > 0.0];
        if (law->breaks == SF_BRANCHES)
            return sf_branched(law, p, drive, direction, side, theta, 0.0, 0.0, v, flow, x);
    }
    law->expand(law, p, drive, theta, u, v, flow, x);
    return sf_step_of(x, flow != NULL);
}

/* The first place strictly between u and `there` where the motion goes over to another series; infinite if none. */
static inline double sf_passed(const sf_piece *piece, double u, double there) {
    if (piece->law->breaks == SF_SMOOTH)
        return HUGE_VAL;
    const double place = piece->law->breaks == SF_SEAMS
                             ? piece->law->seam(piece->law, u, there - u, !sf_is_on_one_side(piece))
                             : sf_meeting(piece, u);
    return (u - place) * (there - place) < 0.0 ? place : HUGE_VAL;
}

/* Where series meet, on a step of h that passes that place. */
static double sf_met(const sf_expansion *x, double h, double place) {
    double scaled[SF_TERMS];
    const double side = copysign(1.0, x->u[0] - place);
    sf_scaled(x->u, h, side, scaled);
    scaled[0] -= side * place;
    return h * sf_refined(scaled, 0.0, 1.0);
}
