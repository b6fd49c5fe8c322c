/* The first zero of a polynomial on [0, 1], isolated by the signs of its Bernstein coefficients: none is skipped. */
#ifndef SF_FIRST_ZERO_H
#define SF_FIRST_ZERO_H

#include <string.h>

#include "series.h"

/* NONE; ONE; UNDECIDED: it comes so near to zero that rounding hides whether it gets there */
typedef enum { SF_NONE, SF_ONE, SF_UNDECIDED } sf_found;

enum { SF_LOW = 6, SF_DEEPEST = 60 };

/* Bernstein coefficients on [0, 1] of the polynomial with coefficients a, by sums alone */
static void sf_bernstein(const double *a, int degree, double *b)
{
    double binomial = 1.0;
    for (int k = 0; k <= degree; k++) {
        b[k] = a[k] / binomial;
        binomial = binomial * (degree - k) / (k + 1);
    }
    for (int r = 1; r <= degree; r++)
        for (int j = degree; j >= r; j--)
            b[j] += b[j - 1];
}

/* The zero between low, where the polynomial is positive, and high, where it is not: Newton's iteration, kept inside. */
static double sf_refined(const double *a, int degree, double low, double high)
{
    double x = 0.5 * (low + high);
    for (int i = 0; i < 200; i++) {
        double value = a[degree], slope = 0.0;
        for (int k = degree - 1; k >= 0; k--) {
            slope = slope * x + value;
            value = value * x + a[k];
        }
        if (value == 0.0)
            return x;
        *(value > 0.0 ? &low : &high) = x;
        double next = x - value / slope;
        if (!(next > low && next < high))
            next = 0.5 * (low + high);
        if (next == x || next == low || next == high || fabs(next - x) <= 0x1p-53 * x)
            return next;
        x = next;
    }
    return x;
}

/* b: Bernstein coefficients on [low, high], good to `noise` */
static sf_found sf_first_within(const double *a, const double *b, double low, double high, double noise, int depth,
                                double *zero)
{
    int changes = 0, clear = 1;
    double before = 1.0, most = 0.0;
    for (int k = 0; k <= SF_ORDER; k++) {
        most = fmax(most, fabs(b[k]));
        clear &= b[k] > noise;
        if (b[k] != 0.0) {
            changes += (b[k] > 0.0) != (before > 0.0);
            before = b[k];
        }
    }
    if (clear || changes == 0)
        return SF_NONE;
    if (changes == 1 && b[SF_ORDER] < -noise) {
        *zero = sf_refined(a, SF_ORDER, low, high);
        return SF_ONE;
    }
    if (most <= noise || depth == SF_DEEPEST) {
        *zero = low;
        return SF_UNDECIDED;
    }
    /* halves by de Casteljau */
    double left[SF_TERMS], right[SF_TERMS];
    memcpy(right, b, sizeof right);
    for (int r = 0; r <= SF_ORDER; r++) {
        left[r] = right[0];
        for (int j = 0; j < SF_ORDER - r; j++)
            right[j] = 0.5 * (right[j] + right[j + 1]);
    }
    const double middle = 0.5 * (low + high);
    const sf_found first = sf_first_within(a, left, low, middle, noise, depth + 1, zero);
    if (first == SF_ONE)
        return SF_ONE;
    double later;
    const sf_found second = sf_first_within(a, right, middle, high, noise, depth + 1, &later);
    if (second == SF_NONE)
        return first;
    if (first == SF_NONE || second == SF_ONE)
        *zero = later;
    return second;
}

/* The first zero on (0, 1] of the polynomial a, which is positive to the right of 0: at 0 itself where it is not. Where
 * it only touches zero within rounding, and is positive beyond, that is UNDECIDED and *zero says where. */
static sf_found sf_first_zero(const double *a, double *zero)
{
    *zero = 0.0;
    if (!(a[0] > 0.0))
        return SF_ONE;
    double beyond = 0.0, size = 0.0, low[SF_LOW + 1], b[SF_TERMS];
    for (int k = SF_ORDER; k > SF_LOW; k--)
        beyond += fabs(a[k]);
    for (int k = 0; k <= SF_LOW; k++)
        size += fabs(a[k]);
    size += beyond;
    const double noise = 4.0 * 0x1p-53 * size;
    sf_bernstein(a, SF_LOW, low);
    int clear = 1;
    for (int k = 0; k <= SF_LOW; k++)
        clear &= low[k] > beyond + noise;
    if (clear)
        return SF_NONE;
    sf_bernstein(a, SF_ORDER, b);
    return sf_first_within(a, b, 0.0, 1.0, noise, 0, zero);
}

#endif
