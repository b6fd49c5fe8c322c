/* Power series, coefficient by coefficient: what the generated forces are written in.
 *
 * A force takes n and the series of u up to its coefficient n, and adds the coefficient n of every series on the way to
 * f(u) and its derivative, as these functions give it. */
#ifndef SF_SERIES_H
#define SF_SERIES_H

#include <math.h>

/* the tail of order 24 falls below a rounding in steps of a fifth of the radius of convergence */
enum { SF_ORDER = 24, SF_TERMS = SF_ORDER + 1, SF_MOST_SERIES = 40, SF_MOST_CONSTANTS = 16 };

typedef double sf_series[SF_TERMS];

/* One smooth piece of a restoring force: force(n, p, w) adds the coefficient n to each series on the way from u = w[0]
 * to f = w[value]; both() to f = w[value_of_both] and df/du = w[slope] as well. Where the piece is linear df/du is
 * w[slope][0] alone. */
typedef struct {
    const char *name;
    void (*force)(int n, const double *p, sf_series *w);
    void (*both)(int n, const double *p, sf_series *w);
    int value, value_of_both, slope, linear;
} sf_law;

static inline double sf_constant(double value, int n) { return n == 0 ? value : 0.0; }

/* sum of a[j] b[n - j] for j from first to last: four sums, as each addition waits for the one before it */
static inline double sf_convolved(const double *a, const double *b, int n, int first, int last)
{
    const double *const up = a + first, *const down = b + n - first;
    const int count = last - first + 1;
    double sum[4] = {0.0, 0.0, 0.0, 0.0};
    int j = 0;
    for (; j + 4 <= count; j += 4) {
        sum[0] += up[j] * down[-j];
        sum[1] += up[j + 1] * down[-j - 1];
        sum[2] += up[j + 2] * down[-j - 2];
        sum[3] += up[j + 3] * down[-j - 3];
    }
    for (; j < count; j++)
        sum[0] += up[j] * down[-j];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

static inline double sf_product(const double *a, const double *b, int n) { return sf_convolved(a, b, n, 0, n); }

static inline double sf_square(const double *a, int n)
{
    const double half = sf_convolved(a, a, n, 0, (n - 1) / 2 - (n == 0));
    const double middle = n % 2 ? 0.0 : a[n / 2];
    return 2.0 * half + middle * middle;
}

/* of q = a/b, whose coefficients below n are known */
static inline double sf_quotient(const double *a, const double *b, const double *q, int n)
{
    return (a[n] - sf_convolved(b, q, n, 1, n)) / b[0];
}

/* of q = 1/b */
static inline double sf_reciprocal(const double *b, const double *q, int n)
{
    return n == 0 ? 1.0 / b[0] : -sf_convolved(b, q, n, 1, n) / b[0];
}

/* of s = sqrt(a) */
static inline double sf_root(const double *a, const double *s, int n)
{
    if (n == 0)
        return sqrt(a[0]);
    const double half = sf_convolved(s, s, n, 1, (n - 1) / 2);
    const double middle = n % 2 ? 0.0 : s[n / 2];
    return (a[n] - 2.0 * half - middle * middle) / (2.0 * s[0]);
}

/* of c = cbrt(a), from 3 a c' = a' c */
static inline double sf_cube_root(const double *a, const double *c, int n)
{
    if (n == 0)
        return cbrt(a[0]);
    double sum = 0.0;
    for (int j = 0; j < n; j++)
        sum += ((double)(n - j) / 3.0 - j) * a[n - j] * c[j];
    return sum / (n * a[0]);
}

/* of sin(a), given the series of cos(a), from its derivative; the other way round with the sign */
static inline double sf_of_angle(const double *a, const double *other, double sign, int n)
{
    double sum = 0.0;
    for (int j = 1; j <= n; j++)
        sum += j * a[j] * other[n - j];
    return sign * sum / n;
}

static inline double sf_sine(const double *a, const double *cosine, int n)
{
    return n == 0 ? sin(a[0]) : sf_of_angle(a, cosine, 1.0, n);
}

static inline double sf_cosine(const double *a, const double *sine, int n)
{
    return n == 0 ? cos(a[0]) : sf_of_angle(a, sine, -1.0, n);
}

#endif
