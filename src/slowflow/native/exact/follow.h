/* Motion from switch to switch, as slowflow.exact.motion states it: slip in one direction over one piece, or rest. */
#pragma once

#include <stdlib.h>

#include "exact_conventions.h"
#include "inertia.h"
#include "first_zero.h"
#include "motion.h"
#include "sides.h"

#define SF_GLIMPSE 1e-6 /* a slip from rest of less, in theta, is none: the push exceeds friction by rounding */
#define SF_TURN 6.283185307179586

/* The equation of motion without its forcing. Pieces are by rising u, numbered from piece `about`, which holds u = 0;
 * piece i from edge[i] to edge[i + 1], of which the first and the last are SF_FAR away. */
typedef struct {
    int pieces, about, odd;
    const sf_piece *piece;
    const double *edge;
    double mu, zeta;
    int inertial;       /* whether F_0 means a force F_0 Omega^2 */
    double load;        /* static force besides that */
    double c_2;         /* quadratic damping */
    int released;       /* whether friction acts on piece `about` only */
    double mu_s;        /* what friction holds a mass at rest with, where that is more than mu */
    double jump;        /* f(0+): where it is not 0 piece `about` is the place u = 0, without width, with f = 0 */
    double eta;         /* structural damping, (eta/Omega) u' */
    double c_3, zeta_2; /* cubic damping, and the growth of zeta with u^2 */
} sf_system;

/* F_0: amplitude of the excitation, see sf_forcing */
typedef struct {
    const sf_system *system;
    double Omega, F_0;
    long left; /* steps that may still be taken */
} sf_forced;

/* A stretch of smooth motion. slip: sign of the velocity, 0 at rest; undecided: touches a stop within rounding. Python
 * reads this layout. */
typedef struct {
    int slip, region;
    double theta, u, v, end, u_end, v_end;
    int event;
    _Bool undecided;
} sf_phase;

typedef struct {
    long count, room;
    sf_phase *at;
} sf_phases;

static inline const sf_piece *sf_piece_of(const sf_system *system, int region) {
    return &system->piece[system->about + region];
}

/* amplitude of the force */
static inline double sf_forcing(const sf_forced *forced) {
    return forced->system->inertial ? inertia_force(forced->Omega, forced->F_0) : forced->F_0;
}

/* friction on a piece, of a mass that slips and at rest */
static inline double sf_friction(const sf_system *system, int region) {
    return system->released && region != 0 ? 0.0 : system->mu;
}
static inline double sf_static(const sf_system *system, int region) {
    return system->released && region != 0 ? 0.0 : fmax(system->mu, system->mu_s);
}

/* the largest push against which a mass rests there: at u = 0 what the force jumps to holds it too */
static inline double sf_holding(const sf_system *system, int region) {
    return sf_static(system, region) + (region == 0 ? system->jump : 0.0);
}

/* the region into which a mass slips from that one */
static inline int sf_beyond(const sf_system *system, int slip, int region) {
    return region + slip == 0 && system->jump != 0.0 ? slip : region + slip;
}

/* of a mass that stops at u in that region */
static inline int sf_stopped(const sf_system *system, int region, double u) {
    return u == 0.0 && system->jump != 0.0 ? 0 : region;
}

/* how many zeros v has in time where a mass breaks away: two, as the push balances friction, unless static friction
 * is larger */
static inline int sf_zeros_of_start(const sf_system *system, int region) {
    return sf_static(system, region) > sf_friction(system, region) ? 1 : 2;
}

/* the viscous damping ratio of motions at Omega, structural damping among it, and its slope by Omega */
static inline void sf_damping(const sf_forced *forced, double damping[2]) {
    damping[0] = damping[1] = 0.0;
    if (forced->system->eta != 0.0)
        motion_structural(forced->Omega, forced->system->eta, damping);
    damping[0] += forced->system->zeta;
}

static inline sf_drive sf_drive_of(const sf_forced *forced, int slip, int region) {
    const sf_system *const system = forced->system;
    const double friction = slip * sf_friction(system, region) - system->load;
    double zeta[2];
    sf_damping(forced, zeta);
    return (sf_drive){forced->Omega, sf_forcing(forced), zeta[0],       friction, slip * system->c_2,
                      zeta[1],       system->c_3,        system->zeta_2};
}

/* what friction has to hold at rest */
static inline double sf_push(const sf_forced *forced, int region, double theta, double u) {
    const sf_system *const system = forced->system;
    return motion_push(cos(theta), sf_forcing(forced), sf_value(sf_piece_of(system, region), u) - system->load);
}

/* its derivatives by theta, u and the amplitude of the force */
static inline void sf_push_slopes(const sf_forced *forced, int region, double theta, double u, double by[3]) {
    motion_push_slopes(cos(theta), sin(theta), sf_forcing(forced), sf_slope(sf_piece_of(forced->system, region), u),
                       by);
}

static inline double sf_acceleration(const sf_forced *forced, int slip, int region, double theta, double u, double v) {
    const sf_system *const system = forced->system;
    double resists[3], zeta[2];
    sf_damping(forced, zeta);
    motion_resistance(v, zeta[0], slip * sf_friction(system, region), slip * system->c_2, system->c_3, system->zeta_2,
                      u, resists);
    return motion_acceleration(cos(theta), v, sf_forcing(forced), zeta[0], resists[0],
                               sf_value(sf_piece_of(system, region), u) - system->load);
}

static inline double sf_edge_ahead(const sf_system *system, int slip, int region) {
    return system->edge[system->about + region + (slip > 0)];
}

/* an edge belongs to the piece below it, where the force is odd to the inner one */
static inline int sf_region_of(const sf_system *system, double u) {
    int index = 0;
    for (int i = 1; i < system->pieces; i++)
        index += system->odd && i <= system->about ? u >= system->edge[i] : u > system->edge[i];
    return index - system->about;
}

/* when and in which direction a mass at rest at u moves off, at or after theta; infinity and 0 if never */
static double sf_break_away(const sf_forced *forced, int region, double theta, double u, int *direction) {
    const sf_system *const system = forced->system;
    const double force = sf_value(sf_piece_of(system, region), u) - system->load;
    const double amplitude = sf_forcing(forced);
    double first = HUGE_VAL;
    *direction = 0;
    for (int slip = -1; slip <= 1; slip += 2) {
        const double cosine = motion_breakaway(amplitude, slip * sf_holding(system, region), force);
        if (!(fabs(cosine) < 1.0))
            continue;
        /* cos theta rises through it for slip = 1 and falls for slip = -1 */
        const double angle = -slip * acos(cosine);
        const double at = fmax(angle + SF_TURN * ceil((theta - angle) / SF_TURN - SF_OF_TURN), theta);
        if (at < first)
            first = at, *direction = slip;
    }
    return first;
}

/* what follows a stop reached in direction slip: the next direction, 0 if friction holds the mass */
static inline int sf_after_stop(const sf_forced *forced, int slip, int region, double theta, double u) {
    const double push = sf_push(forced, region, theta, u);
    double holds = sf_holding(forced->system, region);
    if (forced->F_0 == 0.0) /* the spring balances the load but for a rounding, which moves nothing */
        holds = fmax(holds, SF_BALANCED * fabs(forced->system->load));
    if (holds > 0 && fabs(push) <= holds)
        return 0;
    return slip ? -slip : push > 0 ? 1 : -1;
}

/* Slip from (theta, u, v) up to the first stop, to u = edge, or to `end`. `zeros`: of the velocity at the start, 0 if
 * it moves, 1 from rest, 2 where the acceleration vanishes too, at break-away. */
static sf_outcome sf_until(const sf_piece *over, const sf_drive *drive, int slip, double edge, double end, int zeros,
                           double *theta, double *u, double *v, long *left, sf_event *event, _Bool *undecided) {
    const double start = *theta, whole = (end - start) / drive->Omega;
    double passed = 0.0;
    sf_expansion x;
    *undecided = 0;
    for (;;) {
        if ((*left)-- <= 0)
            return SF_STALLS;
        const sf_piece *const piece = sf_piece_at(over, drive, 1.0, *theta, *u, *v);
        double h = fmin(sf_expanded(piece, drive, 1.0, *theta, *u, *v, NULL, &x), whole - passed);
        if (!(h >= 0.0) || !isfinite(x.v[SF_ORDER]))
            return SF_STALLS;
        const int last = h == whole - passed;
        double ahead[SF_TERMS + 2] = {0.0}, zero; /* v along the step, with zeros beyond its order */
        sf_scaled(x.v, h, slip, ahead);
        const sf_found stop = h > 0.0 ? sf_first_zero(ahead + zeros, &zero) : SF_NONE;
        *undecided |= stop == SF_UNDECIDED;
        *event = last ? SF_TIME : SF_NOTHING;
        double at = h;
        if (stop == SF_ONE)
            at = h * zero, *event = SF_STOP;
        double there = sf_at(x.u, at);
        /* series meet on the way to the piece's edge */
        const double place = over->law->breaks == SF_BEGINS ? HUGE_VAL : sf_passed(over, *u, edge);
        const int meets = isfinite(place);
        const double limit = meets ? place : edge;
        if (slip * (there - limit) > 0.0) { /* up to there u is monotone */
            double left[SF_TERMS];
            sf_scaled(x.u, h, -slip, left);
            left[0] += slip * limit;
            at = left[0] > 0.0 ? h * sf_refined(left, 0.0, at / h) : 0.0;
            there = limit, *event = meets ? SF_NOTHING : SF_EDGE;
        }
        *v = *event == SF_STOP ? 0.0 : sf_at(x.v, at);
        *u = there;
        passed += at;
        *theta = start + drive->Omega * passed;
        if (*event == SF_TIME)
            *theta = end;
        if (*event != SF_NOTHING)
            return SF_GOOD;
        zeros = 0;
    }
}

/* State at `end`, which may lie before theta, and its derivatives by the state at theta, Omega and F_0. */
static sf_outcome sf_advance(const sf_piece *over, const sf_drive *drive, double theta, double end, double *u,
                             double *v, sf_four flow[2], long *left) {
    const double start = theta, whole = (end - start) / drive->Omega;
    double passed = 0.0;
    sf_expansion x;
    flow[0] = sf_four_of(1.0, 0.0, 0.0, 0.0), flow[1] = sf_four_of(0.0, 1.0, 0.0, 0.0);
    while (passed != whole) {
        if ((*left)-- <= 0)
            return SF_STALLS;
        const double rest = whole - passed;
        const sf_piece *const piece = sf_piece_at(over, drive, rest, theta, *u, *v);
        const double most = sf_expanded(piece, drive, rest, theta, *u, *v, flow, &x);
        if (!(most > 0.0) || !isfinite(sf_lane(&x.V[SF_ORDER], 0)))
            return SF_STALLS;
        double h = fabs(rest) <= most ? rest : copysign(most, rest);
        double there = sf_at(x.u, h);
        const double place = sf_passed(over, *u, there);
        if (isfinite(place))
            h = sf_met(&x, h, place), there = place;
        passed = h == rest ? whole : passed + h;
        *u = there, *v = sf_at(x.v, h);
        sf_four_at(x.U, h, &flow[0]);
        sf_four_at(x.V, h, &flow[1]);
        theta = start + drive->Omega * passed;
    }
    return isfinite(*u) && isfinite(*v) ? SF_GOOD : SF_STALLS;
}

/* Of a phase u, v and the acceleration of the mass, in the inertial frame, on a grid of theta that does not fall,
 * at or after its start. */
static sf_outcome sf_sample(sf_forced *forced, const sf_phase *phase, const double *grid, long count,
                            double (*out)[3]) {
    const double start = phase->theta;
    const sf_piece *const over = sf_piece_of(forced->system, phase->region);
    const sf_drive drive = sf_drive_of(forced, phase->slip, phase->region);
    /* a phase that ends where its piece does has no series from there on: a rounding later is still on the way there */
    const double tolerance = count > 0 ? 0x1p-50 * fmax(fabs(start), fabs(grid[count - 1])) / drive.Omega : 0.0;
    double passed = 0.0, theta = start, u = phase->u, v = phase->v;
    long i = 0;
    sf_expansion x;
    for (; phase->slip == 0 && i < count; i++) /* with the base */
        out[i][0] = u, out[i][1] = 0.0, out[i][2] = -motion_push(cos(grid[i]), drive.F_0, 0.0);
    while (i < count) {
        if (forced->left-- <= 0)
            return SF_STALLS;
        double h = sf_expanded(sf_piece_at(over, &drive, 1.0, theta, u, v), &drive, 1.0, theta, u, v, NULL, &x);
        if (!(h > 0.0) || !isfinite(x.v[SF_ORDER]))
            return SF_STALLS;
        double there = sf_at(x.u, h);
        const double place = sf_passed(over, u, there);
        if (isfinite(place))
            h = sf_met(&x, h, place), there = place;
        for (; i < count; i++) {
            const double at = (grid[i] - start) / drive.Omega - passed;
            if (!(at <= h + tolerance))
                break;
            out[i][0] = sf_at(x.u, at), out[i][1] = sf_at(x.v, at);
            /* in the inertial frame the forcing is no force */
            out[i][2] = sf_rate(&drive, 0.0, sf_value(over, out[i][0]), out[i][0], out[i][1]);
        }
        u = there, v = sf_at(x.v, h);
        passed += h;
        theta = start + drive.Omega * passed;
    }
    return SF_GOOD;
}

static int sf_append(sf_phases *phases, sf_phase phase) {
    if (phases->count == phases->room) {
        const long room = 2 * phases->room + 16;
        sf_phase *const more = realloc(phases->at, (size_t)room * sizeof *more);
        if (more == NULL)
            return 0;
        phases->at = more, phases->room = room;
    }
    phases->at[phases->count++] = phase;
    return 1;
}

/* adds a rest, or prolongs one that the last phase is */
static int sf_rest(sf_phases *phases, int region, double *theta, double u, double until, double end) {
    const int event = until < end ? SF_STOP : SF_TIME;
    sf_phase *const last = phases->count ? &phases->at[phases->count - 1] : NULL;
    const double from = *theta;
    *theta = until;
    if (last != NULL && last->slip == 0) {
        last->end = until, last->event = event;
        return 1;
    }
    return sf_append(phases, (sf_phase){0, region, from, u, 0.0, until, u, 0.0, event, 0});
}

/* All phases from (theta, u, v) to `end`; `start` = {slip, region} overrides the state, e.g. at break-away. */
static sf_outcome sf_follow(sf_forced *forced, double theta, double u, double v, double end, const int *start,
                            sf_phases *phases) {
    const sf_system *const system = forced->system;
    int slip, region, zeros = v == 0.0;
    if (start != NULL) {
        slip = start[0], region = start[1];
        /* of an acceleration that is 0 but for roundings the series may have the other sign: a stop at once */
        const double none = 0x1p-40 * (sf_forcing(forced) + sf_holding(system, region) + fabs(system->load));
        zeros = v != 0.0 ? 0 : slip && slip * sf_acceleration(forced, slip, region, theta, u, 0.0) > none ? 1 : 2;
    } else {
        region = sf_region_of(system, u);
        slip = v != 0 ? (v > 0 ? 1 : -1) : sf_after_stop(forced, 0, region, theta, u);
        if (slip != 0 && u == sf_edge_ahead(system, slip, region))
            region += slip;
    }
    const double most = SF_MOST_PHASES * (1.0 + ceil((end - theta) / SF_TURN));
    phases->count = 0;
    while (theta < end) {
        if ((double)phases->count >= most)
            return SF_CHATTERS;
        if (slip == 0) {
            const double at = sf_break_away(forced, region, theta, u, &slip);
            if (!sf_rest(phases, region, &theta, u, fmin(at, end), end))
                return SF_NO_MEMORY;
            zeros = sf_zeros_of_start(system, region);
            continue;
        }
        if (slip * u >= SF_FAR)
            return SF_ESCAPES;
        const double edge = sf_edge_ahead(system, slip, region);
        if (slip * (u - edge) >= 0.0) { /* turned round within rounding of a breakpoint */
            region += slip;
            continue;
        }
        const sf_drive drive = sf_drive_of(forced, slip, region);
        sf_phase phase = {slip, region, theta, u, v, 0.0, 0.0, 0.0, SF_TIME, 0};
        sf_event event;
        const sf_outcome outcome = sf_until(sf_piece_of(system, region), &drive, slip, edge, end, zeros, &theta, &u, &v,
                                            &forced->left, &event, &phase.undecided);
        if (outcome != SF_GOOD || (event == SF_EDGE && slip * u >= SF_FAR)) { /* beyond it there is no piece */
            phase.end = theta, phase.u_end = u, phase.v_end = v;              /* where the motion is lost */
            return !sf_append(phases, phase) ? SF_NO_MEMORY : outcome != SF_GOOD ? outcome : SF_ESCAPES;
        }
        if (zeros && event == SF_STOP && theta - phase.theta < SF_GLIMPSE && sf_holding(system, region) > 0) {
            theta = phase.theta, u = phase.u, region = sf_stopped(system, region, u);
            const double at = sf_break_away(forced, region, theta + SF_GLIMPSE, u, &slip);
            if (!sf_rest(phases, region, &theta, u, fmin(at, end), end))
                return SF_NO_MEMORY;
            zeros = sf_zeros_of_start(system, region);
            continue;
        }
        zeros = 0;
        if (event == SF_EDGE && fabs(v) < SF_GRAZING &&
            slip * sf_acceleration(forced, slip, sf_beyond(system, slip, region), theta, u, v) < 0.0)
            v = 0.0, event = SF_STOP;
        phase.event = event, phase.end = theta, phase.u_end = u, phase.v_end = v;
        if (!sf_append(phases, phase))
            return SF_NO_MEMORY;
        if (event == SF_STOP) {
            region = sf_stopped(system, region, u);
            slip = sf_after_stop(forced, slip, region, theta, u);
            zeros = 1;
        } else if (event == SF_EDGE)
            region += slip;
    }
    return SF_GOOD;
}
