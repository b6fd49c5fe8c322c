/* The equations of a periodic motion with a given order of switches, their Jacobian, and Newton's iteration, as
 * slowflow.exact.cycle states them. */
#pragma once

#include "follow.h"

/* phases of a cycle with k of them: slip[i] and region[i], the factor `sign` of the state after the cycle */
typedef struct {
    long k;
    const int *phase; /* k pairs (slip, region) */
    int half_turns, sign;
} sf_cycle;

/* A margin that is positive while no phase has to be put in at a turning point; `rest`: the excess of the push over
 * friction, else the distance of the turning point from the breakpoint ahead. Its gradient has k + 4 entries. */
typedef struct {
    int phase, rest;
    double margin;
} sf_border;

/* residual (k + 2), jacobian (k + 2, k + 4) with columns u_0, theta_0, k spans, Omega, F_0; borders (2 k) */
typedef struct {
    double *residual, *jacobian, *of_A, *gradients;
    double monodromy[2][2], A;
    sf_border *border;
    long borders;
} sf_equations;

/* The numbers of workspace for a cycle of k phases: residual, jacobian, of_A, gradients, two rows of the state's
 * derivatives and one of theta's. */
static inline size_t sf_numbers(long k) { return (size_t)(k + 2) + (k + 2) * (k + 4) + (k + 4) + 2 * k * (k + 4); }

/* Equations with their arrays one after the other in sf_numbers(k) numbers. */
static inline sf_equations sf_equations_in(double *numbers, sf_border *at, long k) {
    const long n = k + 4;
    return (sf_equations){.residual = numbers,
                          .jacobian = numbers + (k + 2),
                          .of_A = numbers + (k + 2) + (k + 2) * n,
                          .gradients = numbers + (k + 2) + (k + 3) * n,
                          .border = at};
}

/* Turns a row of derivatives whose last is by the amplitude of the force into one by that of the excitation. */
static inline void sf_excited(double *row, long n, double by_Omega, double by_F_0) {
    row[n - 2] += by_Omega * row[n - 1];
    row[n - 1] *= by_F_0;
}

/* Takes note of |u| at a switch, and of its derivatives by the unknowns, where it is the largest up to there. */
static inline void sf_reached(sf_equations *out, double u, const double *of_u, long n) {
    if (!(fabs(u) > out->A))
        return;
    out->A = fabs(u);
    for (long j = 0; j < n; j++)
        out->of_A[j] = copysign(1.0, u) * of_u[j];
}

static sf_outcome sf_cycle_equations(sf_forced *forced, const sf_cycle *cycle, const double *z, sf_equations *out,
                                     double *work) {
    const sf_system *const system = forced->system;
    const long k = cycle->k, n = k + 4;
    const double Omega = forced->Omega = z[k + 2];
    double u = z[0], v = 0.0, theta = z[1];
    double *const of_u = work, *const of_v = work + n, *const of_theta = work + 2 * n;
    memset(work, 0, 3 * (size_t)n * sizeof *work);
    memset(out->jacobian, 0, (size_t)((k + 2) * n) * sizeof *out->jacobian);
    of_u[0] = 1.0, of_theta[1] = 1.0;
    double M[2][2] = {{1.0, 0.0}, {0.0, 1.0}};
    out->A = -1.0;
    sf_reached(out, u, of_u, n);
    out->borders = 0;
    for (long i = 0; i < k; i++) {
        const int slip = cycle->phase[2 * i], region = cycle->phase[2 * i + 1], flip = i == k - 1 ? cycle->sign : 1;
        const long next = (i + 1) % k;
        const int next_slip = flip * cycle->phase[2 * next], next_region = flip * cycle->phase[2 * next + 1];
        const double end = theta + z[2 + i];
        double *const row = out->jacobian + i * n;
        const sf_piece *const piece = sf_piece_of(system, region);
        const double holds = sf_holding(system, region);
        if (slip == 0) {
            of_theta[2 + i] = 1.0;
            out->residual[i] = sf_push(forced, region, end, u) - next_slip * holds;
            double by[3];
            sf_push_slopes(forced, region, end, u, by);
            for (long j = 0; j < n; j++) {
                of_v[j] = 0.0;
                row[j] = by[0] * of_theta[j] + by[1] * of_u[j];
            }
            row[n - 1] += by[2];
            /* v is forgotten; where the push that breaks it away exceeds friction the acceleration jumps from 0, and u
             * shows when; elsewhere it is continuous */
            const double jump =
                system->mu_s > system->mu ? sf_acceleration(forced, next_slip, region, end, u, 0.0) : 0.0;
            const double of_place = jump == 0.0 ? 0.0 : motion_released(jump, Omega, by[0], by[1]);
            M[1][0] = of_place * M[0][0], M[1][1] = of_place * M[0][1];
            v = 0.0, theta = end;
            continue;
        }
        const sf_drive drive = sf_drive_of(forced, slip, region);
        const double rate_u = v / Omega, rate_v = sf_acceleration(forced, slip, region, theta, u, v) / Omega;
        sf_four by[2];
        const sf_outcome outcome = sf_advance(piece, &drive, theta, end, &u, &v, by, &forced->left);
        if (outcome != SF_GOOD)
            return outcome;
        double flow[2][4];
        memcpy(flow, by, sizeof flow);
        const double acceleration = sf_acceleration(forced, slip, region, end, u, v);
        for (long j = 0; j < n; j++) {
            const double a = of_u[j] - rate_u * of_theta[j], b = of_v[j] - rate_v * of_theta[j];
            const double at_end = of_theta[j] + (j == 2 + i ? 1.0 : 0.0);
            of_u[j] = flow[0][0] * a + flow[0][1] * b + v / Omega * at_end;
            of_v[j] = flow[1][0] * a + flow[1][1] * b + acceleration / Omega * at_end;
        }
        of_theta[2 + i] = 1.0;
        for (int c = 2; c < 4; c++)
            of_u[k + c] += flow[0][c], of_v[k + c] += flow[1][c];
        for (int c = 0; c < 2; c++) {
            const double a = M[0][c], b = M[1][c];
            M[0][c] = flow[0][0] * a + flow[0][1] * b;
            M[1][c] = flow[1][0] * a + flow[1][1] * b;
        }
        theta = end;
        sf_reached(out, u, of_u, n);
        const double edge = sf_edge_ahead(system, slip, region);
        if (next_region != region) {
            out->residual[i] = u - edge;
            memcpy(row, of_u, (size_t)n * sizeof *row);
            if (v != 0.0) {
                const double gains =
                    motion_across(acceleration, sf_acceleration(forced, slip, next_region, end, u, v), v);
                for (int c = 0; c < 2; c++)
                    M[1][c] += gains * M[0][c];
            }
            continue;
        }
        out->residual[i] = v;
        memcpy(row, of_v, (size_t)n * sizeof *row);
        const double after = sf_acceleration(forced, next_slip, region, end, u, v);
        for (int c = 0; c < 2; c++)
            M[1][c] *= next_slip == 0 ? 0.0 : acceleration != 0.0 ? motion_turned(acceleration, after) : 1.0;
        if (fabs(edge) != SF_FAR) {
            double *const gradient = out->gradients + out->borders * n;
            for (long j = 0; j < n; j++)
                gradient[j] = -slip * of_u[j];
            out->border[out->borders++] = (sf_border){(int)i, 0, slip * (edge - u)};
        }
        if (next_slip != 0 && holds > 0) {
            double *const gradient = out->gradients + out->borders * n;
            double by_push[3];
            sf_push_slopes(forced, region, end, u, by_push);
            for (long j = 0; j < n; j++)
                gradient[j] = next_slip * (by_push[0] * of_theta[j] + by_push[1] * of_u[j]);
            gradient[n - 1] += next_slip * by_push[2];
            out->border[out->borders++] = (sf_border){(int)i, 1, next_slip * sf_push(forced, region, end, u) - holds};
        }
    }
    double *const closes = out->jacobian + k * n, *const spans = closes + n;
    out->residual[k] = u - cycle->sign * z[0];
    memcpy(closes, of_u, (size_t)n * sizeof *closes);
    closes[0] -= cycle->sign;
    double whole = 0.0;
    for (long i = 0; i < k; i++)
        whole += z[2 + i], spans[2 + i] = 1.0;
    if (system->inertial) { /* up to here the last column is by the amplitude of the force */
        double by[2];
        inertia_force_slopes(Omega, forced->F_0, by);
        for (long r = 0; r < k + 2; r++)
            sf_excited(out->jacobian + r * n, n, by[0], by[1]);
        for (long r = 0; r < out->borders; r++)
            sf_excited(out->gradients + r * n, n, by[0], by[1]);
        sf_excited(out->of_A, n, by[0], by[1]);
    }
    out->residual[k + 1] = whole - 0.5 * SF_TURN * cycle->half_turns;
    for (int r = 0; r < 2; r++)
        for (int c = 0; c < 2; c++)
            out->monodromy[r][c] = cycle->sign * M[r][c];
    return SF_GOOD;
}

/* Solves m x = b for two right-hand sides, b[0] and b[1], in place, by elimination with partial pivoting; 0 where m is
 * singular. */
static int sf_solve(double *m, long n, double *const b[2]) {
    for (long i = 0; i < n; i++) {
        long best = i;
        for (long r = i + 1; r < n; r++)
            if (fabs(m[r * n + i]) > fabs(m[best * n + i]))
                best = r;
        if (!(fabs(m[best * n + i]) > 0.0))
            return 0;
        if (best != i) {
            for (long c = i; c < n; c++) {
                const double kept = m[i * n + c];
                m[i * n + c] = m[best * n + c], m[best * n + c] = kept;
            }
            for (int s = 0; s < 2; s++) {
                const double kept = b[s][i];
                b[s][i] = b[s][best], b[s][best] = kept;
            }
        }
        for (long r = i + 1; r < n; r++) {
            const double factor = m[r * n + i] / m[i * n + i];
            if (factor == 0.0)
                continue;
            for (long c = i + 1; c < n; c++)
                m[r * n + c] -= factor * m[i * n + c];
            for (int s = 0; s < 2; s++)
                b[s][r] -= factor * b[s][i];
        }
    }
    for (int s = 0; s < 2; s++)
        for (long i = n - 1; i >= 0; i--) {
            double sum = b[s][i];
            for (long c = i + 1; c < n; c++)
                sum -= m[i * n + c] * b[s][c];
            b[s][i] = sum / m[i * n + i];
        }
    return 1;
}

/* One more equation, so that Omega is free: row z = value, or that a border's margin vanishes; or none. */
typedef struct {
    sf_extra_kind kind;
    const double *row; /* k + 3 */
    double value;
    long border;
} sf_extra;

/* The column of an unknown while the equations are solved: spans backwards, then u_0, theta_0, Omega. The equation of a
 * switch holds no later span, so all but four rows have zeros where a column is cleared, and elimination, which passes
 * over them, takes k^2 operations. */
static inline long sf_column(long unknown, long k) {
    return unknown < 2 ? k + unknown : unknown < k + 2 ? k + 1 - unknown : unknown;
}

/* a row of `size` numbers by unknown, by column */
static inline void sf_in_columns(const double *row, long k, long size, double *out) {
    for (long j = 0; j < size; j++)
        out[sf_column(j, k)] = row[j];
}

/* Newton's iteration from z, which it changes. SF_DIVERGES where it does not converge. `along`, if not NULL: the
 * solution of J x = 0, row x = 1 at the end. `work`: (k + 3)^2 + 2 (k + 3) + 3 (k + 4) numbers. */
static sf_outcome sf_newton(sf_forced *forced, const sf_cycle *cycle, double *z, const sf_extra *extra, int most,
                            double tolerance, sf_equations *out, double *direction, double *work) {
    const long k = cycle->k, n = k + 4, size = k + 2 + (extra->kind != SF_NO_MORE);
    double *const m = work, *const solved = m + size * size, *const turned = solved + size, *const rest = turned + size;
    double last = HUGE_VAL;
    for (int i = 0; i < most; i++) {
        const sf_outcome outcome = sf_cycle_equations(forced, cycle, z, out, rest);
        if (outcome != SF_GOOD)
            return outcome;
        double error = 0.0;
        for (long r = 0; r < k + 2; r++) {
            sf_in_columns(out->jacobian + r * n, k, size, m + r * size);
            solved[r] = -out->residual[r], turned[r] = 0.0;
            error = fmax(error, fabs(out->residual[r]));
        }
        if (extra->kind == SF_ROW) {
            double value = -extra->value;
            for (long j = 0; j < size; j++)
                value += extra->row[j] * z[j];
            sf_in_columns(extra->row, k, size, m + (k + 2) * size);
            solved[k + 2] = -value, turned[k + 2] = 1.0;
            error = fmax(error, fabs(value));
        } else if (extra->kind == SF_BORDER) {
            if (extra->border >= out->borders)
                return SF_DIVERGES;
            sf_in_columns(out->gradients + extra->border * n, k, size, m + (k + 2) * size);
            solved[k + 2] = -out->border[extra->border].margin, turned[k + 2] = 1.0;
            error = fmax(error, fabs(solved[k + 2]));
        }
        double *const sides[2] = {solved, turned}, *const step = m;
        if (!sf_solve(m, size, sides))
            return SF_SINGULAR;
        for (long j = 0; j < size; j++)
            step[j] = solved[sf_column(j, k)];
        double length = 0.0;
        for (long j = 0; j < size; j++)
            length = isfinite(step[j]) ? fmax(length, fabs(step[j])) : HUGE_VAL;
        if (!(length <= 2.0) || !isfinite(error))
            return SF_DIVERGES;
        /* towards Omega = 0 a turn takes ever longer: a trial that goes half the way is none */
        if (extra->kind != SF_NO_MORE && !(fabs(step[k + 2]) < 0.5 * z[k + 2]))
            return SF_DIVERGES;
        /* next to a neutral motion a small residual is no sign of convergence: what is left of u_0 has to be small,
         * too; off the centre u_0 itself may be 0 */
        const double own = fabs(step[0]), size_of_u = fmax(fabs(z[0]), out->A);
        const int stays = error <= 100.0 * tolerance && length >= 0.5 * last;
        if (stays && own > SF_LOOSE * size_of_u)
            return SF_DIVERGES;
        const int converges = error <= tolerance && own <= SF_TIGHT * size_of_u;
        /* the last step is taken, too, where it is more than rounding: it leaves the square of its length */
        for (long j = 0; !stays && j < size; j++)
            z[j] += step[j];
        if (stays || converges) {
            for (long j = 0; direction != NULL && j < size; j++)
                direction[j] = turned[sf_column(j, k)];
            return SF_GOOD;
        }
        last = length;
    }
    return SF_DIVERGES;
}
