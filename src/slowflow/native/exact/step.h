/* One step of the equation of motion (3) by its Taylor series: in goes a state in a piece of the force, out come series
 * of u and v = du/dtau in time, and of their derivatives by (u, v, Omega, F_0), with the step over which they hold. */
#ifndef SF_STEP_H
#define SF_STEP_H

#include <stdint.h>
#include <string.h>

#include "series.h"

enum { SF_COLUMNS = 4 }; /* u and v at the start, Omega, F_0 */

/* the constants of a slip phase: friction is mu times the sign of the velocity */
typedef struct {
    double Omega, F_0, zeta, friction;
} sf_drive;

/* in time from the start of the step, coefficient by coefficient; w[0] is u */
typedef struct {
    sf_series w[SF_MOST_SERIES], v, cosine, sine;
    double U[SF_TERMS][SF_COLUMNS], V[SF_TERMS][SF_COLUMNS];
} sf_expansion;

static const double sf_over[SF_TERMS + 1] = {
    0.0,       1.0,       1.0 / 2,   1.0 / 3,   1.0 / 4,   1.0 / 5,   1.0 / 6,   1.0 / 7,   1.0 / 8,
    1.0 / 9,   1.0 / 10,  1.0 / 11,  1.0 / 12,  1.0 / 13,  1.0 / 14,  1.0 / 15,  1.0 / 16,  1.0 / 17,
    1.0 / 18,  1.0 / 19,  1.0 / 20,  1.0 / 21,  1.0 / 22,  1.0 / 23,  1.0 / 24,  1.0 / 25};

static inline double sf_force(const sf_law *law, const double *p, double u)
{
    sf_series w[SF_MOST_SERIES];
    w[0][0] = u;
    law->force(0, p, w);
    return w[law->value][0];
}

static inline double sf_stiffness(const sf_law *law, const double *p, double u)
{
    sf_series w[SF_MOST_SERIES];
    w[0][0] = u;
    law->both(0, p, w);
    return w[law->slope][0];
}

/* u' = v, v' = F_0 cos theta - f(u) - 2 zeta v - friction; the same order of operations as in a push less friction */
static void sf_expand(const sf_law *law, const double *p, const sf_drive *drive, double theta, double u, double v,
                      sf_expansion *x)
{
    x->w[0][0] = u, x->v[0] = v;
    x->cosine[0] = cos(theta), x->sine[0] = sin(theta);
    for (int n = 0; n < SF_ORDER; n++) {
        const double over = sf_over[n + 1];
        law->force(n, p, x->w);
        x->w[0][n + 1] = x->v[n] * over;
        x->v[n + 1] = (drive->F_0 * x->cosine[n] - x->w[law->value][n] - 2.0 * drive->zeta * x->v[n] -
                       sf_constant(drive->friction, n)) * over;
        x->cosine[n + 1] = -drive->Omega * x->sine[n] * over;
        x->sine[n + 1] = drive->Omega * x->cosine[n] * over;
    }
}

/* coefficient n of the slope times each column of U, from the term `first` on, in two sums as in sf_convolved */
static inline void sf_pulled(const double *slope, const double (*U)[SF_COLUMNS], int n, int first, double *pull)
{
    double even[SF_COLUMNS] = {0.0}, odd[SF_COLUMNS] = {0.0};
    int j = first;
    for (; j + 2 <= n + 1; j += 2)
        for (int c = 0; c < SF_COLUMNS; c++) {
            even[c] += slope[n - j] * U[j][c];
            odd[c] += slope[n - j - 1] * U[j + 1][c];
        }
    for (int c = 0; c < SF_COLUMNS; c++)
        pull[c] = even[c] + odd[c] + (j <= n ? slope[n - j] * U[j][c] : 0.0);
}

/* The same with the derivatives by column at a fixed theta = Omega tau: of u, U' = V and of v, V' = -f'(u) U - 2 zeta V,
 * less the rates of u and v over Omega in the column of Omega, plus cos theta in that of F_0. */
static void sf_expand_both(const sf_law *law, const double *p, const sf_drive *drive, double theta, double u, double v,
                           const double flow[2][SF_COLUMNS], sf_expansion *x)
{
    x->w[0][0] = u, x->v[0] = v;
    x->cosine[0] = cos(theta), x->sine[0] = sin(theta);
    memcpy(x->U[0], flow[0], sizeof x->U[0]);
    memcpy(x->V[0], flow[1], sizeof x->V[0]);
    const double *const slope = x->w[law->slope];
    for (int n = 0; n < SF_ORDER; n++) {
        const double over = sf_over[n + 1];
        law->both(n, p, x->w);
        x->w[0][n + 1] = x->v[n] * over;
        const double rate = drive->F_0 * x->cosine[n] - x->w[law->value_of_both][n] - 2.0 * drive->zeta * x->v[n] -
                            sf_constant(drive->friction, n);
        x->v[n + 1] = rate * over;
        x->cosine[n + 1] = -drive->Omega * x->sine[n] * over;
        x->sine[n + 1] = drive->Omega * x->cosine[n] * over;
        double pull[SF_COLUMNS];
        sf_pulled(slope, (const double (*)[SF_COLUMNS])x->U, n, law->linear ? n : 0, pull);
        for (int c = 0; c < SF_COLUMNS; c++) {
            x->U[n + 1][c] = x->V[n][c] * over;
            x->V[n + 1][c] = (-pull[c] - 2.0 * drive->zeta * x->V[n][c]) * over;
        }
        x->U[n + 1][2] -= x->v[n] / drive->Omega * over;
        x->V[n + 1][2] -= rate / drive->Omega * over;
        x->V[n + 1][3] += x->cosine[n] * over;
    }
}

/* log2 |x| to 0.1 */
static inline double sf_log2(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits &= INT64_MAX;
    return (double)bits * 0x1p-52 - 1023.0;
}

static inline double sf_largest(const double *row)
{
    double most = 0.0;
    for (int c = 0; c < SF_COLUMNS; c++)
        most = fmax(most, fabs(row[c]));
    return most;
}

/* log2 of the step at which a term of that order is a rounding of the largest of the first three */
static double sf_reach_of(const double head[3], double tail, int order)
{
    if (tail == 0.0)
        return HUGE_VAL;
    double most = -HUGE_VAL;
    for (int k = 0; k < 3; k++)
        if (head[k] != 0.0)
            most = fmax(most, (sf_log2(head[k]) - sf_log2(tail) - 54.0) / (order - k));
    return most;
}

/* The step over which the last two terms of every series are no more than a rounding; infinite where all vanish. */
static double sf_step_of(const sf_expansion *x, int variations)
{
    double least = HUGE_VAL;
    for (int order = SF_ORDER - 1; order <= SF_ORDER; order++) {
        least = fmin(least, sf_reach_of(x->w[0], x->w[0][order], order));
        least = fmin(least, sf_reach_of(x->v, x->v[order], order));
        if (variations) {
            const double of_u[3] = {sf_largest(x->U[0]), sf_largest(x->U[1]), sf_largest(x->U[2])};
            const double of_v[3] = {sf_largest(x->V[0]), sf_largest(x->V[1]), sf_largest(x->V[2])};
            least = fmin(least, sf_reach_of(of_u, sf_largest(x->U[order]), order));
            least = fmin(least, sf_reach_of(of_v, sf_largest(x->V[order]), order));
        }
    }
    return exp2(least);
}

/* by Horner's rule, for even and odd powers apart */
static inline double sf_at(const double *series, double h)
{
    const double square = h * h;
    double even = series[SF_ORDER], odd = series[SF_ORDER - 1];
    for (int k = SF_ORDER - 2; k >= 2; k -= 2)
        even = even * square + series[k], odd = odd * square + series[k - 1];
    return series[0] + (h * odd + square * even);
}

static void sf_columns_at(double series[SF_TERMS][SF_COLUMNS], double h, double *out)
{
    const double square = h * h;
    double even[SF_COLUMNS], odd[SF_COLUMNS];
    memcpy(even, series[SF_ORDER], sizeof even);
    memcpy(odd, series[SF_ORDER - 1], sizeof odd);
    for (int k = SF_ORDER - 2; k >= 2; k -= 2)
        for (int c = 0; c < SF_COLUMNS; c++)
            even[c] = even[c] * square + series[k][c], odd[c] = odd[c] * square + series[k - 1][c];
    for (int c = 0; c < SF_COLUMNS; c++)
        out[c] = series[0][c] + (h * odd[c] + square * even[c]);
}

#endif
