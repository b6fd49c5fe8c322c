/* Every piece of every restoring force as Taylor recurrences: coefficient n of each series on the way to f(u) and df/du.

   Written by `make derive`; never edit.
   Input: the pieces of the forces of every mechanism, as their modules have them
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   C99, with the series of src/slowflow/native/exact/series.h. `p` holds the constants of the kernel in their order. */

#ifndef TAYLOR_H
#define TAYLOR_H

#include "exact/series.h"

/* duffing: Piece 1 of the whole restoring force u + F_k(u). Equation (3), (5). */
static void duffing_force_1_force(int n, const double *p, sf_series *w)
{
    const double alpha = p[0];
    const double beta = p[1];
    w[1][n] = sf_square(w[0], n);
    w[2][n] = sf_constant(alpha, n) + beta * w[1][n];
    w[3][n] = sf_product(w[0], w[2], n);
}

static void duffing_force_1_both(int n, const double *p, sf_series *w)
{
    const double alpha = p[0];
    const double beta = p[1];
    w[1][n] = sf_square(w[0], n);
    w[2][n] = beta * w[1][n];
    w[3][n] = sf_constant(alpha, n) + w[2][n];
    w[4][n] = sf_product(w[0], w[3], n);
    w[5][n] = sf_constant(alpha, n) + 3.0 * w[2][n];
}

/* rod_spring: Piece 1 of the whole restoring force u + F_k(u). Equation (3), (6). */
static void rod_spring_force_1_force(int n, const double *p, sf_series *w)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double gamma = p[2];
    w[1][n] = sf_square(w[0], n);
    w[2][n] = sf_constant(beta, n) + gamma * w[1][n];
    w[3][n] = sf_product(w[1], w[2], n);
    w[4][n] = sf_constant(alpha, n) + w[3][n];
    w[5][n] = sf_product(w[0], w[4], n);
}

static void rod_spring_force_1_both(int n, const double *p, sf_series *w)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double gamma = p[2];
    w[1][n] = sf_square(w[0], n);
    w[2][n] = gamma * w[1][n];
    w[3][n] = sf_constant(beta, n) + w[2][n];
    w[4][n] = sf_product(w[1], w[3], n);
    w[5][n] = sf_constant(alpha, n) + w[4][n];
    w[6][n] = sf_product(w[0], w[5], n);
    w[7][n] = sf_constant((3.0 * beta), n) + 5.0 * w[2][n];
    w[8][n] = sf_product(w[1], w[7], n);
    w[9][n] = sf_constant(alpha, n) + w[8][n];
}

/* rod_spring: Piece 2 of the whole restoring force u + F_k(u). Equation (3), (6). */
static void rod_spring_force_2_force(int n, const double *p, sf_series *w)
{
    (void)p;
    (void)n, (void)w;
}

static void rod_spring_force_2_both(int n, const double *p, sf_series *w)
{
    (void)p;
    w[1][n] = sf_constant(1.0, n);
}

/* rod_spring_untruncated: Piece 1 of the whole restoring force u + F_k(u). Equation (3), (5). */
static void rod_spring_untruncated_force_1_force(int n, const double *p, sf_series *w)
{
    const double alpha = p[0];
    const double beta = p[1];
    w[1][n] = sf_constant(1.0, n) - w[0][n];
    w[2][n] = sf_constant(1.0, n) + w[0][n];
    w[3][n] = sf_product(w[1], w[2], n);
    w[4][n] = sf_root(w[3], w[4], n);
    w[5][n] = sf_square(w[0], n);
    w[6][n] = sf_constant(1.0, n) + w[4][n];
    w[7][n] = sf_product(w[4], w[6], n);
    w[8][n] = sf_quotient(w[5], w[7], w[8], n);
    w[9][n] = sf_constant(alpha, n) + 2.0 * beta * w[8][n];
    w[10][n] = sf_product(w[0], w[9], n);
}

static void rod_spring_untruncated_force_1_both(int n, const double *p, sf_series *w)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double t2 = (2.0 * beta);
    w[1][n] = sf_constant(1.0, n) - w[0][n];
    w[2][n] = sf_constant(1.0, n) + w[0][n];
    w[3][n] = sf_product(w[1], w[2], n);
    w[4][n] = sf_root(w[3], w[4], n);
    w[5][n] = sf_square(w[0], n);
    w[6][n] = t2 * w[5][n];
    w[7][n] = sf_constant(1.0, n) + w[4][n];
    w[8][n] = sf_reciprocal(w[7], w[8], n);
    w[9][n] = sf_quotient(w[5], w[4], w[9], n);
    w[10][n] = sf_product(w[4], w[7], n);
    w[11][n] = sf_quotient(w[6], w[10], w[11], n);
    w[12][n] = sf_constant(alpha, n) + w[11][n];
    w[13][n] = sf_product(w[0], w[12], n);
    w[14][n] = sf_product(w[8], w[9], n);
    w[15][n] = sf_square(w[7], n);
    w[16][n] = sf_quotient(w[9], w[15], w[16], n);
    w[17][n] = sf_square(w[4], n);
    w[18][n] = sf_product(w[6], w[8], n);
    w[19][n] = sf_quotient(w[18], w[17], w[19], n);
    w[20][n] = -t2 * w[16][n] - w[19][n];
    w[21][n] = sf_product(w[9], w[20], n);
    w[22][n] = sf_constant(alpha, n) + 6.0 * beta * w[14][n] - w[21][n];
}

/* rod_spring_untruncated: Piece 2 of the whole restoring force u + F_k(u). Equation (3), (5). */
static void rod_spring_untruncated_force_2_force(int n, const double *p, sf_series *w)
{
    (void)p;
    (void)n, (void)w;
}

static void rod_spring_untruncated_force_2_both(int n, const double *p, sf_series *w)
{
    (void)p;
    w[1][n] = sf_constant(1.0, n);
}

enum { SF_LAWS = 5 };

static const sf_law sf_laws[SF_LAWS] = {
    {"duffing.force_1", duffing_force_1_force, duffing_force_1_both, 3, 4, 5, 0},
    {"rod_spring.force_1", rod_spring_force_1_force, rod_spring_force_1_both, 5, 6, 9, 0},
    {"rod_spring.force_2", rod_spring_force_2_force, rod_spring_force_2_both, 0, 0, 1, 1},
    {"rod_spring_untruncated.force_1", rod_spring_untruncated_force_1_force, rod_spring_untruncated_force_1_both, 10, 13, 22, 0},
    {"rod_spring_untruncated.force_2", rod_spring_untruncated_force_2_force, rod_spring_untruncated_force_2_both, 0, 0, 1, 1},
};

#endif
