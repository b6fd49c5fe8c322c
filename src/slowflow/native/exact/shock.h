/* A shock. Takes an oscillator and the acceleration of its base, arc by arc; returns what the mass does then.
 *
 * Seen from the base the mass moves by the equation of motion with minus the base's acceleration as its forcing. */
#pragma once

#include "follow.h"

/* the base's acceleration over a stretch of tau: -F cos(theta + Omega tau) */
typedef struct {
    double span, Omega, F, theta;
} sf_arc;

/* a phase of the motion, and the arc that it is under, which begins at tau = since; the largest of some of its
 * accelerations, and which that is. Python reads this layout. */
typedef struct {
    double since;
    sf_arc arc;
    sf_phase phase;
    double largest;
    long which;
} sf_stretch;

/* u, v: how it begins; rest: where the mass rests without friction; lost: where it is not followed further, when, u,
 * and the amplitude of what drives it then */
typedef struct {
    const sf_system *system;
    double u, v, rest;
    long most, left; /* steps that one integration may take, and all */
    sf_phases phases;
    long count, room;
    sf_stretch *at;
    double lost[3];
} sf_shocked;

/* what a batch is given as doubles: largest |u|, when; largest acceleration, when; when the springs leave, NaN for
 * never; whether the mass rests at the end, and where */
enum { SF_SHOCK_NUMBERS = 7 };

static inline double sf_time_of(const sf_stretch *one, double theta) {
    return one->since + (theta - one->arc.theta) / one->arc.Omega;
}

static inline sf_forced sf_forced_by(const sf_shocked *shock, const sf_arc *arc) {
    return (sf_forced){shock->system, arc->Omega, arc->F, shock->left < shock->most ? shock->left + 1 : shock->most};
}

/* The motion from where it is on under one arc, its phases behind those before. */
static sf_outcome sf_under(sf_shocked *shock, double since, const sf_arc *arc) {
    const sf_system *const system = shock->system;
    const double end = arc->theta + arc->Omega * arc->span;
    double u = shock->u;
    sf_forced forced = sf_forced_by(shock, arc);
    const long most = forced.left;
    const int region = sf_region_of(system, u);
    sf_outcome outcome = SF_GOOD;
    shock->phases.count = 0;
    /* at rest the spring holds the load but for a rounding, which has no part in where the mass goes */
    const double error = system->load != 0.0 ? SF_BALANCED * (fabs(system->load) + arc->F) : 0.0;
    const double holds = sf_holding(system, region), push = fabs(sf_push(&forced, region, arc->theta, u));
    const int balanced = shock->v == 0.0 && push <= fmax(holds, error);
    if (arc->F == 0.0 && balanced) {
        if (!sf_append(&shock->phases, (sf_phase){0, region, arc->theta, u, 0.0, end, u, 0.0, SF_TIME, 0}))
            return SF_NO_MEMORY;
    } else {
        if (balanced && holds < error) /* some roundings back from where F cos(theta) begins to push: it goes there */
            u += copysign(SF_BACK, sin(arc->theta)) * fmax(fmax(fabs(u), fabs(system->load)), arc->F);
        outcome = sf_follow(&forced, arc->theta, u, shock->v, end, NULL, &shock->phases);
    }
    shock->left -= most - forced.left;
    const sf_phase *const last = shock->phases.count ? &shock->phases.at[shock->phases.count - 1] : NULL;
    if (outcome == SF_GOOD && shock->left < 0)
        outcome = SF_STALLS;
    if (outcome != SF_GOOD) { /* the last phase ends where the motion is lost */
        shock->lost[0] = since + (last != NULL ? last->end - arc->theta : 0.0) / arc->Omega;
        shock->lost[1] = last != NULL ? last->u_end : u, shock->lost[2] = arc->F;
        return outcome;
    }
    if (shock->count + shock->phases.count > shock->room) {
        const long room = 2 * (shock->count + shock->phases.count);
        sf_stretch *const more = realloc(shock->at, (size_t)room * sizeof *more);
        if (more == NULL)
            return SF_NO_MEMORY;
        shock->at = more, shock->room = room;
    }
    for (long i = 0; i < shock->phases.count; i++)
        shock->at[shock->count++] = (sf_stretch){since, *arc, shock->phases.at[i], 0.0, 0};
    shock->u = last->u_end, shock->v = last->v_end;
    return SF_GOOD;
}

/* u and v at the end of each arc; phases are not kept. */
static sf_outcome sf_recorded(sf_shocked *shock, const sf_arc *arcs, long count, double (*out)[2]) {
    double since = 0.0;
    for (long i = 0; i < count; since += arcs[i++].span) {
        shock->count = 0;
        const sf_outcome outcome = sf_under(shock, since, &arcs[i]);
        if (outcome != SF_GOOD)
            return outcome;
        out[i][0] = shock->u, out[i][1] = shock->v;
    }
    return SF_GOOD;
}

/* All phases: under the arcs, then freely until the mass has turned twice or is held, for `after` at least: a free
 * motion only loses energy. SF_DIVERGES where that does not come. */
static sf_outcome sf_all_phases(sf_shocked *shock, const sf_arc *arcs, long count, double tau, double after) {
    double A = 0.0;
    for (long i = 0; i < count; i++) {
        const sf_outcome outcome = sf_under(shock, tau, &arcs[i]);
        if (outcome != SF_GOOD)
            return outcome;
        tau += arcs[i].span;
    }
    const double over = tau + after;
    const long before = shock->count;
    long turned = 0, i = 0;
    for (int turn = 0; turn < SF_MOST_TURNS; turn++) {
        const sf_arc free_arc = {fmax(over - tau, SF_TURN), 1.0, 0.0, 0.0};
        const sf_outcome outcome = sf_under(shock, tau, &free_arc);
        if (outcome != SF_GOOD)
            return outcome;
        tau += free_arc.span;
        for (; i < shock->count; i++) {
            turned += i >= before && shock->at[i].phase.event == SF_STOP;
            A = fmax(A, fabs(shock->at[i].phase.u_end - shock->rest));
        }
        /* a mass that is damped much creeps back, and turns once at most: until it does not move, or has come back */
        const double off = fabs(shock->u - shock->rest), v = fabs(shock->v);
        const int creeps = v <= off * SF_CREEPS || fmax(off, v) <= A * SF_CREEPS + SF_BACK * fabs(shock->rest);
        if (tau >= over && (turned >= 2 || shock->at[shock->count - 1].phase.slip == 0 || creeps))
            return SF_GOOD;
    }
    return SF_DIVERGES;
}

static void sf_spaced(double low, double high, long count, double *out) {
    const double step = (high - low) / (double)(count - 1);
    for (long k = 0; k < count - 1; k++)
        out[k] = (double)k * step + low;
    out[count - 1] = high;
}

/* The largest |acceleration| of the mass, in the inertial frame, at angles within a phase, and at which. */
static sf_outcome sf_accelerations(sf_shocked *shock, const double *theta, long count, sf_stretch *one) {
    sf_forced forced = sf_forced_by(shock, &one->arc);
    double states[2 * SF_POINTS][3];
    const long most = forced.left;
    const sf_outcome outcome = sf_sample(&forced, &one->phase, theta, count, states);
    shock->left -= most - forced.left;
    if (outcome != SF_GOOD || shock->left < 0) {
        shock->lost[0] = sf_time_of(one, theta[0]), shock->lost[1] = one->phase.u, shock->lost[2] = one->arc.F;
        return SF_STALLS;
    }
    one->largest = -1.0;
    for (long k = 0; k < count; k++)
        if (fabs(states[k][2]) > one->largest)
            one->largest = fabs(states[k][2]), one->which = k;
    return SF_GOOD;
}

/* The largest acceleration and its time: at points of each phase, then ever nearer to the largest of these. */
static sf_outcome sf_largest_acceleration(sf_shocked *shock, double *largest, double *when) {
    double theta[2 * SF_POINTS], most = 0.0;
    for (long i = 0; i < shock->count; i++) {
        sf_stretch *const one = &shock->at[i];
        sf_spaced(one->phase.theta, one->phase.end, SF_POINTS, theta);
        const sf_outcome outcome = sf_accelerations(shock, theta, SF_POINTS, one);
        if (outcome != SF_GOOD)
            return outcome;
        most = fmax(most, one->largest);
    }
    *largest = 0.0, *when = 0.0;
    for (long i = 0; i < shock->count; i++) {
        sf_stretch *const one = &shock->at[i];
        if (one->largest < SF_NEAR * most)
            continue;
        long count = SF_POINTS;
        sf_spaced(one->phase.theta, one->phase.end, count, theta);
        for (int round = 0; round < SF_ROUNDS; round++) {
            const long k = one->which;
            sf_spaced(theta[k > 0 ? k - 1 : 0], theta[k < count - 1 ? k + 1 : count - 1], 2 * SF_POINTS, theta);
            count = 2 * SF_POINTS;
            const sf_outcome outcome = sf_accelerations(shock, theta, count, one);
            if (outcome != SF_GOOD)
                return outcome;
        }
        if (one->largest * SF_SAME > *largest)
            *largest = one->largest, *when = sf_time_of(one, theta[one->which]);
    }
    return SF_GOOD;
}

/* What the mass does, as SF_SHOCK_NUMBERS numbers; `shock` is given its oscillator, start and steps, and memory is kept
 * in it. */
static sf_outcome sf_shock(sf_shocked *shock, const sf_arc *arcs, long count, double begin, double after, double *out) {
    const double from = fabs(shock->u);
    const int innermost = shock->system->jump != 0.0;
    shock->count = 0;
    sf_outcome outcome = sf_all_phases(shock, arcs, count, begin, after);
    if (outcome != SF_GOOD)
        return outcome;
    out[0] = from, out[4] = NAN;
    for (long i = 0; i < shock->count; i++)
        out[0] = fmax(out[0], fabs(shock->at[i].phase.u_end)); /* between switches u is monotone */
    for (long i = shock->count - 1; i >= 0; i--) {
        const sf_stretch *const one = &shock->at[i];
        if (fabs(one->phase.u_end) >= out[0] * SF_SAME)
            out[1] = sf_time_of(one, one->phase.end);
        if (abs(one->phase.region) > innermost)
            out[4] = sf_time_of(one, one->phase.theta);
    }
    if (from != 0.0 && from >= out[0] * SF_SAME)
        out[1] = begin;
    const sf_phase *const last = &shock->at[shock->count - 1].phase;
    out[5] = last->slip == 0 && sf_holding(shock->system, last->region) > 0.0, out[6] = shock->u;
    return sf_largest_acceleration(shock, &out[2], &out[3]);
}
