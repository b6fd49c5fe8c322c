/* What is asked along the amplitude: in goes one sample of the averaged force, out come functions of A whose zeros count.
 *
 * Everything that can change along a locus changes at a zero of a function that is explicit in A:
 *
 *   SF_STIFFNESS  h and h_A                      the static state and its fold at Omega = 0
 *   SF_ISOLA      F_A = F_Omega = 0              Omega from both, put into F_Omega
 *   SF_CUSP       F_A = F_AA = 0                 F_AA is biquadratic in Omega: both roots in closed form, put into F_A
 *   SF_TURN       F_A = F_AOmega = 0             F_A at its two critical points in Omega
 *   SF_UNDAMPED   cusps for zeta = 0             h_AA = 0, or the locus touches the backbone R = 0
 *   SF_PEAK       F = F_Omega = 0                F at its two critical points in Omega
 *   SF_REST       F = Omega = 0                  h^2 + m^2 = F_0^2
 *
 * The functions are generated: derivations/loci.py eliminates Omega. With the slopes beside them, two zeros between neighbouring samples are not missed.
 */
#ifndef SF_QUESTIONS_H
#define SF_QUESTIONS_H

#include "model.h"

typedef enum { SF_STIFFNESS, SF_ISOLA, SF_CUSP, SF_TURN, SF_UNDAMPED, SF_PEAK, SF_REST } sf_question;

/* Up to two functions (channels) of A. exists: whether each is defined here; Omega: what its zero has for Omega;
 * edge: positive where they are defined, with its slope; floor: where its sign changes one of them ends at Omega = 0, with
 * its slope; merge: the value where a channel ends, if `edge` does not say */
typedef struct {
    int exists[2];
    double y[2], dy[2], Omega[2];
    double edge, d_edge, floor, d_floor, merge;
} sf_answer;

static inline void sf_ask_stiffness(const sf_sample *at, sf_answer *out) {
    out->exists[0] = out->exists[1] = 1;
    out->y[0] = at->h, out->dy[0] = at->h_A;
    out->y[1] = at->h_A, out->dy[1] = at->h_AA;
}

static inline void sf_ask_isola(const sf_model *model, const sf_sample *at, sf_answer *out) {
    double isola[2];
    out->Omega[0] = slow_flow_isola_Omega(fmax(at->h_A, 0));
    out->edge = at->h_A, out->d_edge = at->h_AA;
    if (model->m == 0) { /* without the factor Omega there is a zero with h_A <= 0, which is dropped later */
        slow_flow_mu0_isola(at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA, isola);
    } else if (at->h_A > 0) {
        slow_flow_isola(at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA, isola);
    } else {
        return;
    }
    out->exists[0] = 1;
    out->y[0] = isola[0], out->dy[0] = isola[1];
}

/* Omega^2 solves X^2 + c_1 X + c_0 = 0; channel 0 is the larger root. A channel ends at Omega = 0 with F_A/2 there. */
static inline void sf_ask_cusp(const sf_model *model, const sf_sample *at, sf_answer *out) {
    double cusps[5], at_end[4], minus_half_c_1, c_0, square, root, X[2];
    int i;
    slow_flow_cusps(at->A, model->zeta, at->h, at->h_A, at->h_AA, at->h_AAA, cusps);
    minus_half_c_1 = cusps[0], c_0 = cusps[1], square = cusps[2]; /* the last is (c_1/2)^2 - c_0 */
    out->edge = square, out->d_edge = cusps[4];
    out->floor = c_0, out->d_floor = cusps[3];
    slow_flow_fold_quartic(at->A, model->m, model->zeta, at->h, at->h_A, at_end);
    out->merge = at_end[0];
    if (!(square >= 0) || (minus_half_c_1 <= 0 && c_0 >= 0))
        return;
    root = sqrt(square);
    if (minus_half_c_1 > 0) {
        X[0] = minus_half_c_1 + root;
        X[1] = c_0 / X[0];
    } else {
        X[1] = minus_half_c_1 - root;
        X[0] = c_0 / X[1];
    }
    for (i = 0; i < 2; i++) {
        double w, slope;
        if (!(X[i] > 0))
            continue;
        w = sqrt(X[i]);
        slope = 0.5 * slow_flow_cusp_F_AAOmega(w, i == 0 ? root : -root);
        out->exists[i] = 1;
        out->Omega[i] = w;
        out->y[i] = sf_half_F_A(model, at, w);
        out->dy[i] = -2 * sf_quarter_F_AOmega(model, at, w) * sf_half_F_AAA(at, w) / slope;
    }
}

/* Critical values of a quartic. With q = 0 the lower one lies at Omega = 0 and belongs to other questions. */
static inline void sf_ask_critical(const sf_isolated *q, double p_A, sf_answer *out) {
    out->exists[0] = q->exist && q->w1 > 0;
    out->exists[1] = q->exist;
    out->y[0] = q->f1, out->y[1] = q->f2;
    out->Omega[0] = q->w1, out->Omega[1] = q->w2;
    out->merge = q->f0;
    if (!q->exist) {
        double critical[2];
        slow_flow_critical(q->s.A, q->s.p, q->s.q, p_A, critical);
        out->edge = critical[0], out->d_edge = critical[1];
    }
}

static inline void sf_ask_turn(const sf_model *model, const sf_sample *at, sf_answer *out) {
    sf_isolated q;
    sf_isolate_fold(&q, at->A, at->h, at->h_A, model->m, model->zeta);
    sf_ask_critical(&q, slow_flow_turn_p_A(at->A, model->zeta, at->h_A, at->h_AA), out);
    if (q.exist) {
        out->dy[0] = sf_half_F_AA(model, at, q.w1);
        out->dy[1] = sf_half_F_AA(model, at, q.w2);
    }
}

static inline void sf_ask_peak(const sf_model *model, double F_0, const sf_sample *at, sf_answer *out) {
    sf_isolated q;
    sf_isolate_response(&q, at->A, at->h, model->m, model->zeta, F_0);
    sf_ask_critical(&q, slow_flow_peak_p_A(model->zeta, at->h_A), out);
    if (q.exist) {
        out->dy[0] = 2 * sf_half_F_A(model, at, q.w1);
        out->dy[1] = 2 * sf_half_F_A(model, at, q.w2);
    }
}

static inline void sf_ask_undamped(const sf_sample *at, sf_answer *out) {
    double factors[4];
    slow_flow_zeta0_undamped(at->A, at->h, at->h_A, at->h_AA, at->h_AAA, factors);
    out->exists[0] = out->exists[1] = 1;
    out->y[0] = factors[0], out->dy[0] = factors[1];
    out->y[1] = factors[2], out->dy[1] = factors[3];
    out->Omega[0] = out->Omega[1] = slow_flow_zeta0_undamped_Omega(fmin(at->h_A, 0));
}

/* h^2 + m^2 = F_0^2 has two smooth halves */
static inline void sf_ask_rest(const sf_model *model, double F_0, const sf_sample *at, sf_answer *out) {
    double halves[3];
    slow_flow_rest(F_0, model->m, at->h, at->h_A, halves);
    out->exists[0] = out->exists[1] = 1;
    out->y[0] = halves[0], out->y[1] = halves[1];
    out->dy[0] = out->dy[1] = halves[2];
}

static inline void sf_ask(sf_question question, const sf_model *model, double F_0, const sf_sample *at,
                          sf_answer *out) {
    static const sf_answer nothing = {{0, 0}, {0, 0}, {0, 0}, {0, 0}, 1, 0, 1, 0, 0};
    *out = nothing;
    switch (question) {
    case SF_STIFFNESS:
        sf_ask_stiffness(at, out);
        break;
    case SF_ISOLA:
        sf_ask_isola(model, at, out);
        break;
    case SF_CUSP:
        sf_ask_cusp(model, at, out);
        break;
    case SF_TURN:
        sf_ask_turn(model, at, out);
        break;
    case SF_UNDAMPED:
        sf_ask_undamped(at, out);
        break;
    case SF_PEAK:
        sf_ask_peak(model, F_0, at, out);
        break;
    case SF_REST:
        sf_ask_rest(model, F_0, at, out);
        break;
    }
}

static inline int sf_channels(sf_question question) { return question == SF_ISOLA ? 1 : 2; }

/* Whether a zero really belongs: where a channel is defined more widely than its meaning. */
static inline int sf_belongs(sf_question question, const sf_sample *at) {
    if (question == SF_ISOLA)
        return at->h_A > 0;
    if (question == SF_UNDAMPED)
        return at->h_A < 0;
    return 1;
}

/* Whether a channel that ends between `inside` and `outside`, `width` apart (signed), has no zero before its end: it is
 * close to the value that it ends with, on the same side of zero, and its slope does not lead across. Where it ends by
 * merging with the other channel their slopes may be infinite there, but not their mean. */
static inline int sf_settled(sf_question question, int channel, const sf_answer *inside, const sf_answer *outside,
                             double width) {
    const int merges = question == SF_CUSP ? outside->edge < 0 : inside->exists[0];
    double y = inside->y[channel], slope = inside->dy[channel], last = inside->merge;
    if (question == SF_ISOLA)
        return y > 0;
    if (merges) {
        if (!inside->exists[1 - channel])
            return 0;
        last = inside->y[1 - channel];
        slope = 0.5 * (inside->dy[0] + inside->dy[1]);
    }
    return !sf_opposite(y, last) && fabs(y - last) <= 0.5 * fabs(y) && !sf_opposite(y, y + 2 * slope * width);
}

/* Whether a function with these values and slopes at both ends of a width may come down to zero between: values on one
 * side of zero, slopes towards it and away again, and near zero where the tangents meet (the lowest that a convex
 * function can be) or on the cubic with these values and slopes. */
static inline int sf_may_touch(double y_0, double dy_0, double y_1, double dy_1, double width) {
    const double sign = y_0 < 0 ? -1 : 1;
    double t, lowest;
    int i;
    y_0 *= sign, dy_0 *= sign, y_1 *= sign, dy_1 *= sign;
    if (!(dy_0 < 0 && dy_1 > 0))
        return 0;
    t = (y_1 - y_0 - dy_1 * width) / (dy_0 - dy_1);
    lowest = y_0 + dy_0 * t;
    for (i = 1; i < 8; i++) {
        const double x = 0.125 * i, z = 1 - x;
        lowest = fmin(lowest, z * z * ((1 + 2 * x) * y_0 + x * width * dy_0) +
                                  x * x * ((1 + 2 * z) * y_1 - z * width * dy_1));
    }
    return !(lowest >= 0.3 * fmin(y_0, y_1));
}

/* Whether a channel that is defined at neither end of an interval may be inside: it comes from Omega = 0 to merge with the
 * other one, or there is a window. */
static inline int sf_may_exist(int channel, const sf_answer *a, const sf_answer *b, double width) {
    const int other = 1 - channel;
    if ((a->exists[other] && b->edge < 0) || (b->exists[other] && a->edge < 0))
        return 1;
    if (a->edge < 0 && b->edge < 0)
        return sf_may_touch(a->edge, a->d_edge, b->edge, b->d_edge, width);
    return !(a->edge < 0) && !(b->edge < 0) && !sf_opposite(a->floor, b->floor) &&
           sf_may_touch(a->floor, a->d_floor, b->floor, b->d_floor, width);
}

#endif
