/* A shock: in go an oscillator at rest and the acceleration of its base, arc by arc, out comes what the mass does then,
 * as slowflow.exact.transient states it. */
#ifndef SF_SHOCK_H
#define SF_SHOCK_H

#include "follow.h"

/* the base's acceleration over a stretch of tau: -F cos(theta + Omega tau) */
typedef struct {
    double span, Omega, F, theta;
} sf_arc;

/* a phase of the motion, and the arc that it is under, which begins at tau = since. */
typedef struct {
    double since;
    sf_arc arc;
    sf_phase phase;
} sf_stretch;

typedef struct {
    const sf_system *system;
    long most, left; /* steps that one integration may take, and all */
    sf_phases phases;
    long count, room;
    sf_stretch *at;
} sf_shocked;

/* what a batch is given as doubles: largest |u|, when; largest acceleration, when; when the springs leave, NaN for
 * never;
 * whether the mass rests at the end, and where */
enum { SF_SHOCK_NUMBERS = 7 };

static inline double sf_time_of(const sf_stretch *one, double theta)
{
    return one->since + (theta - one->arc.theta) / one->arc.Omega;
}

static inline sf_forced sf_forced_by(const sf_shocked *shock, const sf_arc *arc)
{
    return (sf_forced){shock->system, arc->Omega, arc->F, shock->left < shock->most ? shock->left + 1 : shock->most};
}

/* The motion from (u, v) on under one arc, its phases behind those before. */
static sf_outcome sf_under(sf_shocked *shock, double since, const sf_arc *arc, double u, double v)
{
    const double end = arc->theta + arc->Omega * arc->span;
    sf_forced forced = sf_forced_by(shock, arc);
    const long most = forced.left;
    const int region = sf_region_of(shock->system, u);
    sf_outcome outcome = SF_GOOD;
    shock->phases.count = 0;
    if (arc->F == 0.0 && v == 0.0 && fabs(sf_push(&forced, region, 0.0, u)) <= sf_holding(shock->system, region)) {
        if (!sf_append(&shock->phases, (sf_phase){0, region, arc->theta, u, 0.0, end, u, 0.0, SF_TIME, 0}))
            return SF_NO_MEMORY;
    }
    else
        outcome = sf_follow(&forced, arc->theta, u, v, end, NULL, &shock->phases);
    shock->left -= most - forced.left;
    if (outcome != SF_GOOD)
        return outcome;
    if (shock->left < 0)
        return SF_STALLS;
    if (shock->count + shock->phases.count > shock->room) {
        const long room = 2 * (shock->count + shock->phases.count);
        sf_stretch *const more = realloc(shock->at, (size_t)room * sizeof *more);
        if (more == NULL)
            return SF_NO_MEMORY;
        shock->at = more, shock->room = room;
    }
    for (long i = 0; i < shock->phases.count; i++)
        shock->at[shock->count++] = (sf_stretch){since, *arc, shock->phases.at[i]};
    return SF_GOOD;
}

/* All phases: under the arcs, then freely until the mass has turned twice or is held, for `after` at least. */
static sf_outcome sf_all_phases(sf_shocked *shock, const sf_arc *arcs, long count, double tau, double after)
{
    double u = 0.0, v = 0.0, A = 0.0;
    for (long i = 0; i < count; i++) {
        const sf_outcome outcome = sf_under(shock, tau, &arcs[i], u, v);
        if (outcome != SF_GOOD)
            return outcome;
        u = shock->at[shock->count - 1].phase.u_end, v = shock->at[shock->count - 1].phase.v_end;
        tau += arcs[i].span;
    }
    const double over = tau + after;
    const long before = shock->count;
    long turned = 0;
    for (int turn = 0; turn < SF_MOST_TURNS; turn++) {
        const sf_arc free_arc = {fmax(over - tau, SF_TURN), 1.0, 0.0, 0.0};
        long i = turn > 0 ? shock->count : 0;
        const sf_outcome outcome = sf_under(shock, tau, &free_arc, u, v);
        if (outcome != SF_GOOD)
            return outcome;
        const sf_phase *const last = &shock->at[shock->count - 1].phase;
        u = last->u_end, v = last->v_end;
        tau += free_arc.span;
        for (; i < shock->count; i++) {
            turned += i >= before && shock->at[i].phase.event == SF_STOP;
            A = fmax(A, fabs(shock->at[i].phase.u_end));
        }
        /* a mass that is damped much creeps back, and turns once at most: until it does not move, or has come back */
        const int creeps = fabs(v) <= fabs(u) * SF_CREEPS || fmax(fabs(u), fabs(v)) <= A * SF_CREEPS;
        if (tau >= over && (turned >= 2 || last->slip == 0 || creeps))
            return SF_GOOD;
    }
    return SF_STALLS;
}

static void sf_spaced(double low, double high, long count, double *out)
{
    const double step = (high - low) / (double)(count - 1);
    for (long k = 0; k < count - 1; k++)
        out[k] = (double)k * step + low;
    out[count - 1] = high;
}

/* |acceleration| of the mass, as seen by who stands still, at angles within a phase; the largest, and where */
static sf_outcome sf_accelerations(sf_shocked *shock, const sf_stretch *one, const double *theta, long count,
                                   double *largest, long *where)
{
    const sf_phase *const phase = &one->phase;
    sf_forced forced = sf_forced_by(shock, &one->arc);
    const sf_piece *const piece = sf_piece_of(shock->system, phase->region);
    const sf_drive drive = sf_drive_of(&forced, phase->slip, phase->region);
    double states[2 * SF_POINTS][2];
    const long most = forced.left;
    if (phase->slip != 0) {
        const sf_outcome outcome =
            sf_sample(piece, &drive, phase->theta, phase->u, phase->v, theta, count, states, &forced.left);
        shock->left -= most - forced.left;
        if (outcome != SF_GOOD || shock->left < 0)
            return SF_STALLS;
    }
    *largest = -1.0;
    for (long k = 0; k < count; k++) {
        const double u = states[k][0], v = states[k][1];
        double resists[2];
        motion_resistance(v, drive.zeta, drive.friction, drive.quadratic, resists);
        /* seen by who stands still the forcing is no force */
        const double a = phase->slip == 0
                             ? motion_push(cos(theta[k]), drive.F_0, 0.0)
                             : motion_acceleration(0.0, v, drive.F_0, drive.zeta, resists[0], sf_value(piece, u));
        if (fabs(a) > *largest)
            *largest = fabs(a), *where = k;
    }
    return SF_GOOD;
}

/* The largest acceleration and its time: at points of each phase, then ever nearer to the largest of these. */
static sf_outcome sf_largest_acceleration(sf_shocked *shock, double *largest, double *when)
{
    double theta[2 * SF_POINTS], most = 0.0, a;
    long k = 0;
    for (long i = 0; i < shock->count; i++) {
        sf_stretch *const one = &shock->at[i];
        sf_spaced(one->phase.theta, one->phase.end, SF_POINTS, theta);
        const sf_outcome outcome = sf_accelerations(shock, one, theta, SF_POINTS, &a, &k);
        if (outcome != SF_GOOD)
            return outcome;
        one->phase.event = (int)k; /* what ended it has been counted: its place is free */
        one->phase.v_end = a;
        most = fmax(most, a);
    }
    *largest = 0.0, *when = 0.0;
    for (long i = 0; i < shock->count; i++) {
        const sf_stretch *const one = &shock->at[i];
        if (one->phase.v_end < SF_NEAR * most)
            continue;
        long count = SF_POINTS;
        sf_spaced(one->phase.theta, one->phase.end, count, theta);
        k = one->phase.event;
        for (int round = 0; round < SF_ROUNDS; round++) {
            sf_spaced(theta[k > 0 ? k - 1 : 0], theta[k < count - 1 ? k + 1 : count - 1], 2 * SF_POINTS, theta);
            count = 2 * SF_POINTS;
            const sf_outcome outcome = sf_accelerations(shock, one, theta, count, &a, &k);
            if (outcome != SF_GOOD)
                return outcome;
        }
        if (a * SF_SAME > *largest)
            *largest = a, *when = sf_time_of(one, theta[k]);
    }
    return SF_GOOD;
}

/* What the mass does, as SF_SHOCK_NUMBERS numbers; `shock` is given its oscillator and steps, and memory is kept in
 * it. */
static sf_outcome sf_shock(sf_shocked *shock, const sf_arc *arcs, long count, double begin, double after, double *out)
{
    shock->count = 0;
    sf_outcome outcome = sf_all_phases(shock, arcs, count, begin, after);
    if (outcome != SF_GOOD)
        return outcome;
    out[0] = 0.0, out[4] = NAN;
    for (long i = 0; i < shock->count; i++)
        out[0] = fmax(out[0], fabs(shock->at[i].phase.u_end)); /* between switches u is monotone */
    for (long i = shock->count - 1; i >= 0; i--) {
        const sf_stretch *const one = &shock->at[i];
        if (fabs(one->phase.u_end) >= out[0] * SF_SAME)
            out[1] = sf_time_of(one, one->phase.end);
        if (one->phase.region != 0)
            out[4] = sf_time_of(one, one->phase.theta);
    }
    const sf_phase last = shock->at[shock->count - 1].phase;
    out[5] = last.slip == 0, out[6] = last.u_end;
    return sf_largest_acceleration(shock, &out[2], &out[3]);
}

#endif
