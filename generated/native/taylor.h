/* Every piece of every restoring force as Taylor recurrences: the coefficients of each series on the way to f(u) and df/du.

   Written by `make derive` from the pieces of the forces of every mechanism; never edit.

   C99, for the integrator of src/slowflow/native/exact/step.h. `p` holds the constants of the kernel in their order. */

#ifndef TAYLOR_H
#define TAYLOR_H

/* Gauss's rule of twice as many nodes on [-1, 1], of which half are the negatives of these */
enum { SF_NODES = 4 };
static const double sf_gauss_node[SF_NODES] = {0.96028985649753629, 0.79666647741362673, 0.52553240991632899, 0.18343464249564981};
static const double sf_gauss_weight[SF_NODES] = {0.10122853629037626, 0.22238103445337448, 0.31370664587788727, 0.36268378337836199};

#include "exact/step.h"
#include "inline.h"

/* Coefficient n of what is made of series a, b: numbers of series, and of sums over lower coefficients. */
static SF_INLINE double sf_product(const sf_coefficients *c, int a, int b, int k) {
    return ((sf_lane(c->sum, k) + (c->second[a] * c->last[b] + c->last[a] * c->second[b])) + c->w[a] * c->first[b]) + c->first[a] * c->w[b];
}
static SF_INLINE double sf_square(const sf_coefficients *c, int a, int k) {
    return sf_lane(c->sum, k) + 2.0 * (c->second[a] * c->last[a] + c->first[a] * c->w[a]);
}
/* of q = a/b, over = 1/b; the sum is that of b q */
static SF_INLINE double sf_quotient(const sf_coefficients *c, int a, int b, int q, int k) {
    return (c->w[a] - (sf_lane(c->sum, k) + (c->second[b] * c->last[q] + c->last[b] * c->second[q]))) * c->over[q] - c->w[b] * (c->first[q] * c->over[q]);
}
/* of q = 1/b, likewise */
static SF_INLINE double sf_reciprocal(const sf_coefficients *c, int b, int q, int k) {
    return -(sf_lane(c->sum, k) + (c->second[b] * c->last[q] + c->last[b] * c->second[q])) * c->over[q] - c->w[b] * (c->first[q] * c->over[q]);
}
/* of s = sqrt(a), over = 1/(2 s); the sum is that of s s */
static SF_INLINE double sf_root(const sf_coefficients *c, int a, int s, int k) {
    return (c->w[a] - (sf_lane(c->sum, k) + 2.0 * c->second[s] * c->last[s])) * c->over[s];
}
/* of q = a^r, over = 1/a, from a q' = r a' q; the sums are those of (t a') q and a (t q') */
static SF_INLINE double sf_power(const sf_coefficients *c, int a, int q, int k, double r) {
    return (r * (c->n * c->w[a] * c->first[q] + (sf_lane(c->sum, k) + (c->second[a] * c->last[q] + (c->n - 1.0) * c->last[a] * c->second[q]))) - (sf_lane(c->sum, k + 1) + ((c->n - 1.0) * c->second[a] * c->last[q] + c->last[a] * c->second[q]))) * c->over[q] * sf_over[c->n];
}
/* of y from b y' = a', over = 1/b; the sum is that of b (t y') */
static SF_INLINE double sf_of_ratio(const sf_coefficients *c, int a, int b, int y, int k) {
    return (c->n * c->w[a] - (sf_lane(c->sum, k) + ((c->n - 1.0) * c->second[b] * c->last[y] + c->last[b] * c->second[y]))) * c->over[y] * sf_over[c->n];
}
/* of y from y' = a' b; the sum is that of (t a') b */
static SF_INLINE double sf_of_rate(const sf_coefficients *c, int a, int b, int k) {
    return (sf_lane(c->sum, k) + (c->second[a] * c->last[b] + (c->n - 1.0) * c->last[a] * c->second[b]) + c->n * c->w[a] * c->first[b]) * sf_over[c->n];
}

SF_FAMILY_BEGIN

/* duffing: Piece 1 of the whole restoring force u + F_k(u). Equation (3), (5). */
static double duffing_force_1_value(const sf_law *self, const double *p, double u) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = u * u;
    return u * (alpha + t0 * (beta + gamma * t0));
}

static double duffing_force_1_slope(const sf_law *self, const double *p, double u) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = u * u;
    return alpha + t0 * (3.0 * beta + 5.0 * gamma * t0);
}

static int duffing_force_1_powers(const double *p, double *c) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    c[0] = 0.0;
    c[1] = alpha;
    c[2] = 0.0;
    c[3] = beta;
    c[4] = 0.0;
    c[5] = gamma;
    return 5;
}


static SF_INLINE void duffing_force_1_begin(const double *p, double *first, double *over) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    first[1] = first[0] * first[0];
    first[2] = beta + gamma * first[1];
    first[3] = first[1] * first[2];
    first[4] = alpha + first[3];
    first[5] = first[0] * first[4];
}

static SF_INLINE void duffing_force_1_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
    const double gamma = p[2];
    w[1] = sf_square(c, 0, 0);
    w[2] = gamma * w[1];
    w[3] = sf_product(c, 1, 2, 1);
    w[4] = w[3];
    w[5] = sf_product(c, 0, 4, 2);
    left[0] = sf_four_of(w[0], w[1], w[0], 0.0);
    right[0] = sf_four_of(w[0], w[2], w[4], 0.0);
}

static SF_INLINE void duffing_force_1_both_begin(const double *p, double *first, double *over) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    first[1] = first[0] * first[0];
    first[2] = gamma * first[1];
    first[3] = beta + first[2];
    first[4] = first[1] * first[3];
    first[5] = alpha + first[4];
    first[6] = first[0] * first[5];
    first[7] = (3.0 * beta) + 5.0 * first[2];
    first[8] = first[1] * first[7];
    first[9] = alpha + first[8];
}

static SF_INLINE void duffing_force_1_both_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
    const double gamma = p[2];
    w[1] = sf_square(c, 0, 0);
    w[2] = gamma * w[1];
    w[3] = w[2];
    w[4] = sf_product(c, 1, 3, 1);
    w[5] = w[4];
    w[6] = sf_product(c, 0, 5, 2);
    w[7] = 5.0 * w[2];
    w[8] = sf_product(c, 1, 7, 3);
    w[9] = w[8];
    left[0] = sf_four_of(w[0], w[1], w[0], w[1]);
    right[0] = sf_four_of(w[0], w[3], w[5], w[7]);
}

SF_FMA static void duffing_force_1(const sf_law *self, const double *p, const sf_drive *drive, double theta, double u, double v,
    const sf_four *flow, sf_expansion *x) {
    double over[10], w[4 * 10];
    sf_four left[1 * SF_TERMS], right[1 * SF_TERMS];
    if (flow == NULL)
        sf_expand(duffing_force_1_begin, duffing_force_1_next,
            p, drive, theta, u, v, NULL, 6, 1, 5, 0, 0, over, w, left, right, x);
    else
        sf_expand(duffing_force_1_both_begin, duffing_force_1_both_next,
            p, drive, theta, u, v, flow, 10, 1, 6, 9, 0, over, w, left, right, x);
}

/* rod_spring: Piece 1 of the whole restoring force u + F_k(u). Equation (3), (6). */
static double rod_spring_force_1_value(const sf_law *self, const double *p, double u) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = u * u;
    return u * (alpha + t0 * (beta + gamma * t0));
}

static double rod_spring_force_1_slope(const sf_law *self, const double *p, double u) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = u * u;
    return alpha + t0 * (3.0 * beta + 5.0 * gamma * t0);
}

static int rod_spring_force_1_powers(const double *p, double *c) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    c[0] = 0.0;
    c[1] = alpha;
    c[2] = 0.0;
    c[3] = beta;
    c[4] = 0.0;
    c[5] = gamma;
    return 5;
}


static SF_INLINE void rod_spring_force_1_begin(const double *p, double *first, double *over) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    first[1] = first[0] * first[0];
    first[2] = beta + gamma * first[1];
    first[3] = first[1] * first[2];
    first[4] = alpha + first[3];
    first[5] = first[0] * first[4];
}

static SF_INLINE void rod_spring_force_1_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
    const double gamma = p[2];
    w[1] = sf_square(c, 0, 0);
    w[2] = gamma * w[1];
    w[3] = sf_product(c, 1, 2, 1);
    w[4] = w[3];
    w[5] = sf_product(c, 0, 4, 2);
    left[0] = sf_four_of(w[0], w[1], w[0], 0.0);
    right[0] = sf_four_of(w[0], w[2], w[4], 0.0);
}

static SF_INLINE void rod_spring_force_1_both_begin(const double *p, double *first, double *over) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    first[1] = first[0] * first[0];
    first[2] = gamma * first[1];
    first[3] = beta + first[2];
    first[4] = first[1] * first[3];
    first[5] = alpha + first[4];
    first[6] = first[0] * first[5];
    first[7] = (3.0 * beta) + 5.0 * first[2];
    first[8] = first[1] * first[7];
    first[9] = alpha + first[8];
}

static SF_INLINE void rod_spring_force_1_both_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
    const double gamma = p[2];
    w[1] = sf_square(c, 0, 0);
    w[2] = gamma * w[1];
    w[3] = w[2];
    w[4] = sf_product(c, 1, 3, 1);
    w[5] = w[4];
    w[6] = sf_product(c, 0, 5, 2);
    w[7] = 5.0 * w[2];
    w[8] = sf_product(c, 1, 7, 3);
    w[9] = w[8];
    left[0] = sf_four_of(w[0], w[1], w[0], w[1]);
    right[0] = sf_four_of(w[0], w[3], w[5], w[7]);
}

SF_FMA static void rod_spring_force_1(const sf_law *self, const double *p, const sf_drive *drive, double theta, double u, double v,
    const sf_four *flow, sf_expansion *x) {
    double over[10], w[4 * 10];
    sf_four left[1 * SF_TERMS], right[1 * SF_TERMS];
    if (flow == NULL)
        sf_expand(rod_spring_force_1_begin, rod_spring_force_1_next,
            p, drive, theta, u, v, NULL, 6, 1, 5, 0, 0, over, w, left, right, x);
    else
        sf_expand(rod_spring_force_1_both_begin, rod_spring_force_1_both_next,
            p, drive, theta, u, v, flow, 10, 1, 6, 9, 0, over, w, left, right, x);
}

/* rod_spring: Piece 2 of the whole restoring force u + F_k(u). Equation (3), (6). */
static double rod_spring_force_2_value(const sf_law *self, const double *p, double u) {
    return u;
}

static double rod_spring_force_2_slope(const sf_law *self, const double *p, double u) {
    return 1.0;
}

static int rod_spring_force_2_powers(const double *p, double *c) {
    c[0] = 0.0;
    c[1] = 1.0;
    return 1;
}


static SF_INLINE void rod_spring_force_2_begin(const double *p, double *first, double *over) {
}

static SF_INLINE void rod_spring_force_2_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
}

static SF_INLINE void rod_spring_force_2_both_begin(const double *p, double *first, double *over) {
    first[1] = 1.0;
}

static SF_INLINE void rod_spring_force_2_both_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
    w[1] = 0.0;
}

SF_FMA static void rod_spring_force_2(const sf_law *self, const double *p, const sf_drive *drive, double theta, double u, double v,
    const sf_four *flow, sf_expansion *x) {
    double over[2], w[4 * 2];
    sf_four left[1 * SF_TERMS], right[1 * SF_TERMS];
    if (flow == NULL)
        sf_expand(rod_spring_force_2_begin, rod_spring_force_2_next,
            p, drive, theta, u, v, NULL, 1, 0, 0, 0, 1, over, w, left, right, x);
    else
        sf_expand(rod_spring_force_2_both_begin, rod_spring_force_2_both_next,
            p, drive, theta, u, v, flow, 2, 0, 0, 1, 1, over, w, left, right, x);
}

/* rod_spring_untruncated: Piece 1 of the whole restoring force u + F_k(u). Equation (3), (5). */
static double rod_spring_untruncated_force_1_value(const sf_law *self, const double *p, double u) {
    const double alpha = p[0], beta = p[1];
    const double t0 = sqrt((1.0 - u) * (u + 1.0));
    return u * (alpha + 2.0 * beta * u * u / (t0 * (t0 + 1.0)));
}

static double rod_spring_untruncated_force_1_slope(const sf_law *self, const double *p, double u) {
    const double alpha = p[0], beta = p[1];
    const double root_1 = sqrt((1.0 - u) * (u + 1.0));
    const double t0 = root_1 + 1.0;
    const double t1 = 1.0 / t0;
    const double t2 = u * u;
    const double t3 = t2 / root_1;
    const double t4 = 2.0 * beta;
    return alpha + 6.0 * beta * t1 * t3 - t3 * (-t3 * t4 / (t0 * t0) - t1 * t2 * t4 / (root_1 * root_1));
}

static double rod_spring_untruncated_force_1_secant(const sf_law *self, const double *p, double u) {
    const double alpha = p[0], beta = p[1];
    const double t0 = sqrt((1.0 - u) * (u + 1.0));
    return alpha + 2.0 * beta * u * u / (t0 * (t0 + 1.0));
}


static SF_INLINE void rod_spring_untruncated_force_1_begin(const double *p, double *first, double *over) {
    first[1] = 1.0 - first[0];
    first[2] = 1.0 + first[0];
    first[3] = first[1] * first[2];
    first[4] = sqrt(first[3]);
    over[4] = 0.5 / first[4];
    first[5] = 1.0 / first[4];
    over[5] = 1.0 / first[4];
    first[7] = rod_spring_untruncated_force_1_secant(NULL, p, first[0]);
    first[8] = first[0] * first[7];
}

static SF_INLINE void rod_spring_untruncated_force_1_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
    const double beta = p[1];
    const double t0 = (2.0 * beta);
    w[1] = -w[0];
    w[2] = w[0];
    w[3] = sf_product(c, 1, 2, 0);
    w[4] = sf_root(c, 3, 4, 1);
    w[5] = sf_reciprocal(c, 4, 5, 2);
    w[6] = t0 * w[5];
    w[7] = w[6];
    w[8] = sf_product(c, 0, 7, 3);
    left[0] = sf_four_of(w[1], w[4], w[4], w[0]);
    right[0] = sf_four_of(w[2], w[4], w[5], w[7]);
}

static SF_INLINE void rod_spring_untruncated_force_1_both_begin(const double *p, double *first, double *over) {
    first[1] = 1.0 - first[0];
    first[2] = 1.0 + first[0];
    first[3] = first[1] * first[2];
    first[4] = sqrt(first[3]);
    over[4] = 0.5 / first[4];
    first[5] = 1.0 / first[4];
    over[5] = 1.0 / first[4];
    first[7] = rod_spring_untruncated_force_1_secant(NULL, p, first[0]);
    first[8] = first[0] * first[7];
    first[9] = first[5] / first[3];
    over[9] = 1.0 / first[3];
    first[11] = rod_spring_untruncated_force_1_slope(NULL, p, first[0]);
}

static SF_INLINE void rod_spring_untruncated_force_1_both_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
    const double beta = p[1];
    const double t1 = (2.0 * beta);
    w[1] = -w[0];
    w[2] = w[0];
    w[3] = sf_product(c, 1, 2, 0);
    w[4] = sf_root(c, 3, 4, 1);
    w[5] = sf_reciprocal(c, 4, 5, 2);
    w[6] = t1 * w[5];
    w[7] = w[6];
    w[8] = sf_product(c, 0, 7, 3);
    w[9] = sf_quotient(c, 5, 3, 9, 4);
    w[10] = t1 * w[9];
    w[11] = w[10];
    left[0] = sf_four_of(w[1], w[4], w[4], w[0]);
    right[0] = sf_four_of(w[2], w[4], w[5], w[7]);
    left[1] = sf_four_of(w[3], 0.0, 0.0, 0.0);
    right[1] = sf_four_of(w[9], 0.0, 0.0, 0.0);
}

SF_FMA static void rod_spring_untruncated_force_1(const sf_law *self, const double *p, const sf_drive *drive, double theta, double u, double v,
    const sf_four *flow, sf_expansion *x) {
    double over[12], w[4 * 12];
    sf_four left[2 * SF_TERMS], right[2 * SF_TERMS];
    if (flow == NULL)
        sf_expand(rod_spring_untruncated_force_1_begin, rod_spring_untruncated_force_1_next,
            p, drive, theta, u, v, NULL, 9, 1, 8, 0, 0, over, w, left, right, x);
    else
        sf_expand(rod_spring_untruncated_force_1_both_begin, rod_spring_untruncated_force_1_both_next,
            p, drive, theta, u, v, flow, 12, 2, 8, 11, 0, over, w, left, right, x);
}

/* rod_spring_untruncated: Piece 2 of the whole restoring force u + F_k(u). Equation (3), (5). */
static double rod_spring_untruncated_force_2_value(const sf_law *self, const double *p, double u) {
    return u;
}

static double rod_spring_untruncated_force_2_slope(const sf_law *self, const double *p, double u) {
    return 1.0;
}

static int rod_spring_untruncated_force_2_powers(const double *p, double *c) {
    c[0] = 0.0;
    c[1] = 1.0;
    return 1;
}


static SF_INLINE void rod_spring_untruncated_force_2_begin(const double *p, double *first, double *over) {
}

static SF_INLINE void rod_spring_untruncated_force_2_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
}

static SF_INLINE void rod_spring_untruncated_force_2_both_begin(const double *p, double *first, double *over) {
    first[1] = 1.0;
}

static SF_INLINE void rod_spring_untruncated_force_2_both_next(const sf_coefficients *c, const double *p, double *w,
    sf_four *left, sf_four *right) {
    w[1] = 0.0;
}

SF_FMA static void rod_spring_untruncated_force_2(const sf_law *self, const double *p, const sf_drive *drive, double theta, double u, double v,
    const sf_four *flow, sf_expansion *x) {
    double over[2], w[4 * 2];
    sf_four left[1 * SF_TERMS], right[1 * SF_TERMS];
    if (flow == NULL)
        sf_expand(rod_spring_untruncated_force_2_begin, rod_spring_untruncated_force_2_next,
            p, drive, theta, u, v, NULL, 1, 0, 0, 0, 1, over, w, left, right, x);
    else
        sf_expand(rod_spring_untruncated_force_2_both_begin, rod_spring_untruncated_force_2_both_next,
            p, drive, theta, u, v, flow, 2, 0, 0, 1, 1, over, w, left, right, x);
}

SF_FAMILY_END

enum { SF_LAWS = 5 };

static const sf_law sf_laws[SF_LAWS + 1] = {
    {"duffing.force_1", 3, SF_SMOOTH, duffing_force_1_value, duffing_force_1_slope, duffing_force_1, NULL, NULL, NULL, duffing_force_1_powers},
    {"rod_spring.force_1", 4, SF_SMOOTH, rod_spring_force_1_value, rod_spring_force_1_slope, rod_spring_force_1, NULL, NULL, NULL, rod_spring_force_1_powers},
    {"rod_spring.force_2", 4, SF_SMOOTH, rod_spring_force_2_value, rod_spring_force_2_slope, rod_spring_force_2, NULL, NULL, NULL, rod_spring_force_2_powers},
    {"rod_spring_untruncated.force_1", 3, SF_SMOOTH, rod_spring_untruncated_force_1_value, rod_spring_untruncated_force_1_slope, rod_spring_untruncated_force_1, NULL, NULL, NULL, NULL},
    {"rod_spring_untruncated.force_2", 3, SF_SMOOTH, rod_spring_untruncated_force_2_value, rod_spring_untruncated_force_2_slope, rod_spring_untruncated_force_2, NULL, NULL, NULL, rod_spring_untruncated_force_2_powers},
    {0},
};

#endif
