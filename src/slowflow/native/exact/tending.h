/* A motion followed until it is shown to tend to a stable periodic one, and a sweep of such, as
 * slowflow.exact.shooting.settle and slowflow.exact.sweep state it: in goes a state, out comes what it tends to.
 *
 * This is the usual case alone: the first length of a cycle that is tried closes in the order of switches that the motion
 * shows, the cycle is stable, and the motion is near enough. What is otherwise, a rest, another length, a neutral motion,
 * a play, too many steps, is left to Python, which begins with the same state anew. */
#ifndef SF_TENDING_H
#define SF_TENDING_H

#include "trace.h"

#define SF_HALF_TURN (0.5 * SF_TURN)
/* steps at one frequency, some tenths of a second, beyond which it is Python's, who hears Ctrl-C */
enum { SF_AT_ONE_FREQUENCY = 100000, SF_AT_ONCE = 50000 };

/* What a motion tends to: a state of it, its largest |u|, rests in a period; and how many turns that took. */
typedef struct {
    double u, v, A;
    long turns, stops;
} sf_tended;

/* Workspace: phases of a turn, of what shows a cycle, and of the cycle; states after each turn; and for cycles of up to
 * `phases` phases what Newton's iteration needs. */
typedef struct {
    sf_phases turn, shown, own;
    double (*passed)[2];
    long phases;
    int *order;
    double *numbers;
    sf_border *border;
} sf_tending;

static void sf_free_tending(sf_tending *room)
{
    free(room->turn.at), free(room->shown.at), free(room->own.at), free(room->passed);
    free(room->order), free(room->numbers), free(room->border);
}

static size_t sf_newton_numbers(long k) { return (size_t)((k + 3) * (k + 3) + 2 * (k + 3) + 3 * (k + 4)); }

/* Room for a cycle of k phases; 0 where there is none. */
static int sf_make_room(sf_tending *room, long k)
{
    if (k <= room->phases)
        return 1;
    free(room->order), free(room->numbers), free(room->border);
    room->phases = k;
    room->order = malloc((size_t)(2 * k) * sizeof *room->order);
    room->numbers = malloc((2 * (size_t)(k + 3) + sf_numbers(k) + sf_newton_numbers(k)) * sizeof *room->numbers);
    room->border = malloc((size_t)(2 * k + 1) * sizeof *room->border);
    if (room->order != NULL && room->numbers != NULL && room->border != NULL)
        return 1;
    room->phases = 0;
    return 0;
}

static double sf_largest_u(const sf_phase *phase, long count)
{
    double largest = 0.0;
    for (long i = 0; i < count; i++)
        largest = fmax(largest, fmax(fabs(phase[i].u), fabs(phase[i].u_end)));
    return largest;
}

static long sf_rests(const sf_phase *phase, long count)
{
    long rests = 0;
    for (long i = 0; i < count; i++)
        rests += phase[i].slip == 0;
    return rests;
}

/* theta less whole turns, as Python's % has it */
static double sf_within_turn(double theta)
{
    const double rest = fmod(theta, SF_TURN);
    return rest < 0.0 ? rest + SF_TURN : rest;
}

/* The cycle that a motion shows, from its highest beginning of a downward slip, with trial unknowns z; 0 where there is
 * none. */
static int sf_shown_cycle(sf_tending *room, double Omega, int half_turns, sf_cycle *cycle, double **z)
{
    const double span = SF_HALF_TURN * half_turns;
    const sf_phase *const at = room->shown.at;
    const long count = room->shown.count;
    const int sign = half_turns % 2 ? -1 : 1;
    long first = -1, last = -1, i;
    for (i = 0; i < count; i++)
        if (at[i].slip == -1 && at[i].v == 0.0 && at[i].theta + span < at[count - 1].end - SF_WHOLE &&
            (first < 0 || at[i].u > at[first].u))
            first = i;
    for (i = first + 1; first >= 0 && i < count; i++)
        if (at[i].slip == -sign && at[i].v == 0.0 &&
            (last < 0 || fabs(at[i].theta - at[first].theta - span) < fabs(at[last].theta - at[first].theta - span)))
            last = i;
    if (last < 0 || !sf_make_room(room, last - first))
        return 0;
    *cycle = (sf_cycle){last - first, room->order, half_turns, sign};
    *z = room->numbers;
    (*z)[0] = at[first].u, (*z)[1] = sf_within_turn(at[first].theta), (*z)[cycle->k + 2] = Omega;
    for (i = 0; i < cycle->k; i++) {
        const sf_phase *const phase = &at[first + i];
        room->order[2 * i] = phase->slip, room->order[2 * i + 1] = phase->region;
        (*z)[2 + i] = phase->end - phase->theta;
    }
    return 1;
}

/* Whether every phase begins in the region where the one before it ended. */
static int sf_is_consistent(const sf_system *system, const sf_cycle *cycle)
{
    for (long i = 0; i < cycle->k; i++) {
        const long next = (i + 1) % cycle->k;
        const int flip = next == 0 ? cycle->sign : 1, slip = cycle->phase[2 * i], region = cycle->phase[2 * i + 1];
        const int after_slip = flip * cycle->phase[2 * next], after = flip * cycle->phase[2 * next + 1];
        if (after != region && !(slip != 0 && after_slip == slip && after == sf_beyond(system, slip, region)))
            return 0;
    }
    return 1;
}

/* The larger multiplier of a cycle, in modulus. */
static double sf_larger_multiplier(const double M[2][2])
{
    const double half_trace = 0.5 * (M[0][0] + M[1][1]), determinant = M[0][0] * M[1][1] - M[0][1] * M[1][0];
    const double apart = 0.5 * (M[0][0] - M[1][1]), square = apart * apart + M[0][1] * M[1][0];
    if (square < 0.0) /* a pair, whose product is the determinant */
        return sqrt(determinant);
    return fabs(half_trace) + sqrt(square);
}

/* The state of a cycle at one angle of the forcing; 0 where integration fails. */
static int sf_state_of(sf_forced *forced, const sf_cycle *cycle, const double *z, const sf_phase *phases, double theta,
                       double state[2])
{
    const double span = SF_HALF_TURN * cycle->half_turns, turns = floor((theta - z[1]) / span);
    const double local = theta - turns * span;
    long i = cycle->k - 1;
    while (i > 0 && !(phases[i].theta <= local))
        i--;
    const sf_phase *const phase = &phases[i];
    state[0] = phase->u, state[1] = 0.0;
    if (phase->slip != 0) {
        const sf_drive drive = sf_drive_of(forced, phase->slip, phase->region);
        double at[1][2];
        if (sf_sample(sf_piece_of(forced->system, phase->region), &drive, phase->theta, phase->u, phase->v, &local, 1,
                      at, &forced->left) != SF_GOOD)
            return 0;
        state[0] = at[0][0], state[1] = at[0][1];
    }
    if (fmod(turns, 2.0) != 0.0)
        state[0] *= cycle->sign, state[1] *= cycle->sign;
    return 1;
}

/* The state of the cycle at theta that lies nearest to (u, v): a subharmonic passes in any of its turns. */
static int sf_nearest_of(sf_forced *forced, const sf_cycle *cycle, const double *z, const sf_phase *phases, double theta,
                         double u, double v, double nearest[2])
{
    double least = HUGE_VAL;
    for (int turn = 0; turn < cycle->half_turns; turn++) {
        double state[2];
        if (!sf_state_of(forced, cycle, z, phases, theta + SF_TURN * turn, state))
            return 0;
        const double off = fmax(fabs(state[0] - u), fabs(state[1] - v));
        if (off < least)
            least = off, nearest[0] = state[0], nearest[1] = state[1];
    }
    return least < HUGE_VAL;
}

/* Whether the motion through (u, v) tends to the stable cycle that passes `there`, of that period in theta, over which
 * its larger multiplier is given: the map over it is so near its linear part that this brings it nearer, as the ways of
 * two states tell of which one is nearer. */
static int sf_approaches(sf_forced *forced, double theta, double period, double multiplier, double A, double u,
                         double v, const double there[2], sf_phases *phases)
{
    const double away[2] = {u - there[0], v - there[1]}, shares[2] = {1.0, SF_NEARER};
    const double distance = fmax(fabs(away[0]), fabs(away[1]));
    double way[2][2];
    if (distance <= SF_ARRIVED * A)
        return 1;
    for (int i = 0; i < 2; i++) {
        const double at_u = there[0] + shares[i] * away[0], at_v = there[1] + shares[i] * away[1];
        if (sf_follow(forced, theta, at_u, at_v, theta + period, NULL, phases) != SF_GOOD || phases->count == 0)
            return 0;
        const sf_phase *const last = &phases->at[phases->count - 1];
        way[i][0] = (last->u_end - at_u) / shares[i], way[i][1] = (last->v_end - at_v) / shares[i];
    }
    return fmax(fabs(way[0][0] - way[1][0]), fabs(way[0][1] - way[1][1])) <=
           SF_UNLIKE * (1.0 - multiplier) * distance;
}

/* Whether the mass stays where the force is 0, as within a play; then any other place is as good. */
static int sf_may_drift(const sf_system *system, const sf_cycle *cycle, double A)
{
    for (long i = 0; i < cycle->k; i++)
        if (cycle->phase[2 * i + 1] != 0)
            return 0;
    return sf_slope(sf_piece_of(system, 0), 0.5 * A) == 0.0;
}

/* What the motion at (u, v) is to the cycle of so many half turns that it shows: it tends there, and out comes what it
 * tends to; or the cycle is stable, but it is not near enough; or Python is to tell. */
typedef enum { SF_TENDS, SF_IS_FAR, SF_IS_UNUSUAL } sf_tendency;

static sf_tendency sf_tends_to_cycle(sf_forced *forced, double theta, double u, double v, int half_turns,
                                     sf_tending *room, sf_tended *out)
{
    const sf_system *const system = forced->system;
    const sf_extra none = {SF_NO_MORE, NULL, 0.0, 0};
    const double Omega = forced->Omega;
    sf_cycle cycle;
    double *z, there[2];
    const int shown_in = (half_turns % 2 ? 3 : 2) * half_turns + 1;
    if (sf_follow(forced, theta, u, v, theta + shown_in * SF_HALF_TURN, NULL, &room->shown) != SF_GOOD ||
        !sf_shown_cycle(room, Omega, half_turns, &cycle, &z))
        return SF_IS_UNUSUAL;
    double *const numbers = z + cycle.k + 3, *const work = numbers + sf_numbers(cycle.k);
    sf_equations found = sf_equations_in(numbers, room->border, cycle.k);
    if (sf_newton(forced, &cycle, z, &none, SF_MOST_NEWTON, SF_TOLERANCE, &found, NULL, work) != SF_GOOD ||
        !sf_is_consistent(system, &cycle) || !sf_holds(forced, &cycle, cycle.phase[2 * cycle.k - 2] == 0, z, &room->own))
        return SF_IS_UNUSUAL;
    const int symmetric = cycle.sign == -1;
    const double of_cycle = sf_larger_multiplier((const double (*)[2])found.monodromy);
    const double multiplier = symmetric ? of_cycle * of_cycle : of_cycle;
    out->A = sf_largest_u(room->own.at, cycle.k);
    const double period = Omega * (half_turns * (symmetric ? 2 : 1) * SF_HALF_TURN / Omega);
    if (!(multiplier < 1.0) || sf_may_drift(system, &cycle, out->A) ||
        !sf_nearest_of(forced, &cycle, z, room->own.at, theta, u, v, there))
        return SF_IS_UNUSUAL;
    if (!sf_approaches(forced, theta, period, multiplier, out->A, u, v, there, &room->shown))
        return SF_IS_FAR;
    out->u = there[0], out->v = there[1];
    out->stops = sf_rests(room->own.at, cycle.k) * (symmetric ? 2 : 1);
    return SF_TENDS;
}

/* Follows the motion from (theta, u, v), turn by turn; `tries`: half turns of cycles, of which the first has to be the
 * one. `room` has places for the states after most + 1 turns. */
static int sf_tends(sf_forced *forced, double theta, double u, double v, const int *tries, int count, long most,
                    sf_tending *room, sf_tended *out)
{
    long ask = 1;
    room->passed[0][0] = u, room->passed[0][1] = v;
    for (long turns = 1; turns <= most; turns++) {
        if (sf_follow(forced, theta, u, v, theta + SF_TURN, NULL, &room->turn) != SF_GOOD)
            return 0;
        const sf_phases *const phases = &room->turn;
        if (phases->count == 0 || sf_rests(phases->at, phases->count) == phases->count)
            return 0;
        u = phases->at[phases->count - 1].u_end, v = phases->at[phases->count - 1].v_end;
        room->passed[turns][0] = u, room->passed[turns][1] = v;
        if (turns + 1 <= ask)
            continue;
        ask += ask < SF_ASKED_AGAIN ? ask : SF_ASKED_AGAIN;
        const double scale = SF_COMES_BACK * sf_largest_u(phases->at, phases->count);
        for (int i = 0; i < count; i++) {
            const long back = tries[i] % 2 ? tries[i] : tries[i] / 2;
            if (back > turns)
                continue;
            const double *const before = room->passed[turns - back];
            if (!(fmax(fabs(u - before[0]), fabs(v - before[1])) < scale))
                continue;
            out->turns = turns;
            const sf_tendency tendency =
                i == 0 ? sf_tends_to_cycle(forced, theta, u, v, tries[i], room, out) : SF_IS_UNUSUAL;
            if (tendency != SF_IS_FAR)
                return tendency == SF_TENDS;
            break; /* it is asked again when it has gone on */
        }
    }
    return 0;
}

/* A sweep from (u, v) at theta = 0 through n frequencies: how many of them, from the first on, are the usual case. It
 * ends after some tens of milliseconds as well. */
static long sf_sweep(const sf_system *system, const double *Omega, long n, double F_0, double u, double v,
                     const int *tries, int count, long most, sf_tending *room, sf_tended *out, long *steps)
{
    long done = 0;
    *steps = 0;
    while (done < n && *steps < SF_AT_ONCE && system->jump == 0.0) {
        sf_forced forced = {system, Omega[done], F_0, SF_AT_ONE_FREQUENCY};
        const int tends = sf_tends(&forced, 0.0, u, v, tries, count, most, room, &out[done]);
        *steps += SF_AT_ONE_FREQUENCY - forced.left;
        if (!tends)
            break;
        u = out[done].u, v = out[done].v;
        done++;
    }
    return done;
}

#endif
