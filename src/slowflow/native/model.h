/* What every solver file knows: the oscillator as numbers, and the slow flow at a point.
 *
 * Everything is dimensionless. The derivatives of F are halved or quartered where a comment says so.
 */
#pragma once

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "conventions.h"
#include "inertia.h"
#include "roots.h"
#include "mechanism.h"
#include "slow_flow.h"

/* m, zeta: the damping as the quartics of roots.h take it, I = 2 zeta A Omega + m; eta, d, d_3, zeta_2, released: other
 * laws of it, see laws.h, 0 where the record takes none; breaks: number of breakpoints b > 0, by rising size; jump:
 * force just below less force just above; kink: the same of its slope and of its curvature; reach: the mechanism's,
 * infinite where of its pieces a linear one is left; by_laws: whether laws.h answers for it: there are other laws, or a
 * preload under an excitation by inertia; lowest: the lowest Omega of the query, which bounds the states of a mass that
 * no spring holds; sign_lost: whether the sign of a jump is lost, as where the jump is below the range of doubles */
typedef struct {
    const sf_mechanism *mechanism;
    double p[SF_MOST_PARAMETERS];
    union {
        double damping[SF_MOST_DAMPING];
        struct {
            double m, zeta, eta, d, d_3, zeta_2, released;
        };
    };
    double b[SF_MOST_BREAKS], jump[SF_MOST_BREAKS], kink[SF_MOST_BREAKS][2];
    int breaks, sign_lost, by_laws;
    double reach, lowest;
} sf_model;

/* k = h - A h_A */
typedef struct {
    double A;
    union {
        double averages[5];
        struct {
            double h, h_A, h_AA, h_AAA, k;
        };
    };
} sf_sample;

typedef struct {
    double Omega, A;
} sf_point;

/* What the force loses at its breakpoints: as a difference of parameters it may be all rounding, so it is that of the
 * design, if the design and its form on intervals are known. Returns a bit for each whose sign is lost even so. */
static inline unsigned sf_jumps_of(const sf_mechanism *mechanism, const double *design, const double *p, double *jump) {
    sf_interval inputs[SF_MOST_PARAMETERS + SF_MOST_BREAKS];
    unsigned sign_lost = 0;
    mechanism->jumps(mechanism, p, jump);
    if (design == NULL || mechanism->parameters_within == NULL)
        return 0;
    mechanism->parameters_within(mechanism, design, inputs);
    for (int i = 0; i < mechanism->breakpoints; i++) {
        const sf_interval lost = inputs[mechanism->parameters + i];
        if (sfi_has_sign(lost))
            jump[i] = 0.5 * lost.lo + 0.5 * lost.hi;
        else if (!(lost.lo == 0 && lost.hi == 0))
            sign_lost |= 1u << i;
    }
    return sign_lost;
}

/* Number of the piece that begins at an amplitude, or holds it. */
static inline int sf_piece_from(const sf_model *model, double A) {
    int number = 0;
    while (number < model->breaks && model->b[number] <= A)
        number++;
    return number;
}

/* An amplitude in place of 0 where kernels take 0 for a part of a piece that ends there. */
#define SF_NEXT_TO_REST 0x1p-100

/* For a question that has no k in it: here that is a difference, which may be all rounding. */
static inline sf_sample sf_sample_without_k_at(const sf_model *model, double A) {
    const double from = A == 0 && model->breaks < model->mechanism->breakpoints ? SF_NEXT_TO_REST : A;
    double f[4], tangent[2];
    model->mechanism->averaged(model->mechanism, 1, &from, model->p, f);
    for (int i = 0; from != A && i < 3; i++) { /* what tends to 0 has |f - A f_A| <= A |f_A| next to it */
        const double rise = from * f[i + 1];
        f[i] = fabs(f[i] - rise) > fabs(rise) ? f[i] : 0;
    }
    slow_flow_intercept(A, f[0], f[1], f[2], tangent);
    /* a slope that is infinite at rest takes nothing off h */
    return (sf_sample){.A = A, .h = f[0], .h_A = f[1], .h_AA = f[2], .h_AAA = f[3], .k = A > 0 ? tangent[0] : f[0]};
}

/* Whether the force jumps at u = 0, and inertia excites the mass. */
static inline int sf_has_preload_by_inertia(const sf_model *model) {
    if (!model->mechanism->inertial)
        return 0;
    const sf_sample at = sf_sample_without_k_at(model, 0);
    return at.h != 0;
}

/* The share of h by which it is rounded where it is proportional to A. */
#define SF_LINEAR 0x1p-50

/* The rest of a model whose parameters and damping are set; 0 where one of these is beyond SF_LARGEST, and where the
 * ends of its pieces do not rise. design: NULL where it is not known */
static inline int sf_prepare(const sf_mechanism *mechanism, const double *design, sf_model *model) {
    double b[SF_MOST_BREAKS], jump[SF_MOST_BREAKS], kink[2 * SF_MOST_BREAKS];
    model->by_laws = 0;
    if (mechanism->damping_size < SF_MOST_DAMPING)
        model->eta = model->d = model->d_3 = model->zeta_2 = model->released = 0;
    else
        for (int i = 2; i < SF_MOST_DAMPING; i++)
            model->by_laws |= model->damping[i] != 0;
    if (!(model->m <= SF_LARGEST))
        return 0;
    for (int i = 0; i < mechanism->parameters; i++)
        if (!(fabs(model->p[i]) <= SF_LARGEST))
            return 0;
    model->mechanism = mechanism;
    model->breaks = model->sign_lost = 0, model->reach = mechanism->reach, model->lowest = 0;
    if (mechanism->breakpoints == 0) {
        model->by_laws = model->by_laws || sf_has_preload_by_inertia(model);
        return model->released == 0;
    }
    mechanism->ends(mechanism, model->p, b);
    const unsigned sign_lost = sf_jumps_of(mechanism, design, model->p, jump);
    if (mechanism->kinks != NULL)
        mechanism->kinks(mechanism, model->p, kink);
    for (int i = 0; i < mechanism->breakpoints; i++) {
        if (!(b[i] >= 0 && (model->breaks == 0 || b[i] > model->b[model->breaks - 1])))
            return 0;
        if (b[i] > 0) { /* a piece of no width is no piece */
            model->b[model->breaks] = b[i];
            model->kink[model->breaks][0] = mechanism->kinks != NULL ? kink[2 * i] : 1;
            model->kink[model->breaks][1] = mechanism->kinks != NULL ? kink[2 * i + 1] : 0;
            model->sign_lost |= (sign_lost >> i & 1u) != 0;
            model->jump[model->breaks++] = jump[i];
        }
    }
    model->by_laws = model->by_laws || sf_has_preload_by_inertia(model);
    /* friction that ends at a breakpoint needs one */
    if (model->released != 0 && model->breaks == 0)
        return 0;
    if (model->breaks == 0 && model->reach < HUGE_VAL) {
        double at[4];
        const double A = 0.5 * model->reach;
        mechanism->averaged(mechanism, 1, &A, model->p, at);
        if (at[2] == 0 && fabs(at[0] - A * at[1]) <= SF_LINEAR * fabs(at[0]))
            model->reach = HUGE_VAL;
    }
    /* a breakpoint that rounds to the reach lies below it: folds on it are looked for */
    if (model->breaks > 0 && model->b[model->breaks - 1] >= model->reach)
        model->reach = nextafter(model->b[model->breaks - 1], HUGE_VAL);
    return 1;
}

/* F's derivatives at a sample: the generated slow flow, scaled by powers of two. */
static inline double sf_half_F_A(const sf_model *model, const sf_sample *at, double w) {
    return 0.5 * slow_flow_F_A(w, at->A, model->m, model->zeta, at->h, at->h_A);
}
static inline double sf_half_F_AA(const sf_model *model, const sf_sample *at, double w) {
    return 0.5 * slow_flow_F_AA(w, at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA);
}
static inline double sf_quarter_F_AOmega(const sf_model *model, const sf_sample *at, double w) {
    return 0.25 * slow_flow_F_AOmega(w, at->A, model->m, model->zeta, at->h, at->h_A);
}
static inline double sf_F_Omega(const sf_model *model, const sf_sample *at, double w) {
    return slow_flow_F_Omega(w, at->A, model->m, model->zeta, at->h);
}
static inline double sf_quarter_F_OmegaOmega(const sf_model *model, const sf_sample *at, double w) {
    return 0.25 * slow_flow_F_OmegaOmega(w, at->A, model->zeta, at->h);
}

static inline int sf_inertial(const sf_model *model) { return model->mechanism->inertial; }

/* Amplitude of the force at an amplitude of the excitation. */
static inline double sf_force(const sf_model *model, double F_0, double w) {
    return sf_inertial(model) ? inertia_force(w, F_0) : F_0;
}

/* The amplitude of the excitation for which (Omega, A) is a steady state. */
static inline double sf_level(const sf_model *model, const sf_sample *at, double w) {
    return model->mechanism->level(w, at->A, model->damping, at->h);
}

/* Whether the excitation leaves the mass at rest at every frequency (27). */
static inline int sf_sticks(const sf_model *model, double F_0) {
    return !sf_inertial(model) && !(F_0 > model->mechanism->dissipation(0, 0, model->damping));
}

static inline int sf_opposite(double a, double b) { return (a < 0) != (b < 0); }
