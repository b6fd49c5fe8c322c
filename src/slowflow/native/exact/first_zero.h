/* The first zero of a polynomial on [0, 1], isolated by the signs of its Bernstein coefficients: none is skipped. */
#pragma once

#include <string.h>

#include "series.h"

/* NONE; ONE; UNDECIDED: it comes so near to zero that rounding hides whether it gets there */
typedef enum { SF_NONE, SF_ONE, SF_UNDECIDED } sf_found;

enum { SF_DEEPEST = 60 };

/* Bernstein coefficients on [0, 1] of the polynomial with coefficients a, by sums alone */
static void sf_bernstein(const double *a, double *b) {
    double binomial = 1.0; /* each an integer, and exact */
    for (int k = 0; k <= SF_ORDER; k++, binomial = binomial * (SF_ORDER + 1 - k) / k)
        b[k] = a[k] / binomial;
    for (int r = 1; r <= SF_ORDER; r++)
        for (int j = SF_ORDER; j >= r; j--)
            b[j] += b[j - 1];
}

/* a(x) and a'(x), by Horner's rule for even and odd powers apart: a(x) = E(x^2) + x D(x^2) */
static inline double sf_value_and_slope(const double *a, double x, double *slope) {
    const double square = x * x;
    double even = a[SF_ORDER], odd = a[SF_ORDER - 1], of_even = 0.0, of_odd = 0.0;
    for (int k = SF_ORDER - 2; k >= 2; k -= 2) {
        of_even = of_even * square + even, of_odd = of_odd * square + odd;
        even = even * square + a[k], odd = odd * square + a[k - 1];
    }
    of_even = of_even * square + even, even = even * square + a[0];
    *slope = 2.0 * x * of_even + odd + 2.0 * square * of_odd;
    return even + x * odd;
}

/* The zero between low, where the polynomial is positive, and high, where it is not, and the values there: Newton's
 * iteration from their chord, kept inside. */
static double sf_refined(const double *a, double low, double high) {
    double slope;
    const double above = sf_value_and_slope(a, low, &slope), below = sf_value_and_slope(a, high, &slope);
    double x = low + (high - low) * (above / (above - below));
    if (!(x > low && x < high))
        x = 0.5 * (low + high);
    for (int i = 0; i < 200; i++) {
        const double value = sf_value_and_slope(a, x, &slope);
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
                                double *zero) {
    int changes = 0, clear = 1;
    double before = 1.0, most = 0.0;
    for (int k = 0; k <= SF_ORDER; k++) {
        most = fabs(b[k]) > most ? fabs(b[k]) : most;
        clear &= b[k] > noise;
        if (b[k] != 0.0) {
            changes += (b[k] > 0.0) != (before > 0.0);
            before = b[k];
        }
    }
    if (clear || changes == 0)
        return SF_NONE;
    if (changes == 1 && b[SF_ORDER] < -noise) {
        *zero = sf_refined(a, low, high);
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
 * it only touches zero within rounding, and is positive beyond, that is UNDECIDED, at *zero. */
static sf_found sf_first_zero(const double *a, double *zero) {
    *zero = 0.0;
    if (!(a[0] > 0.0))
        return SF_ONE;
    double size = a[0], up = 0.0, down = 0.0, steeper = 0.0, order = 1.0;
    for (int k = 1; k <= SF_ORDER; k++, order += 1.0) {
        const double rise = a[k] > 0.0 ? a[k] : 0.0;
        size += fabs(a[k]), up += rise, down += rise - a[k];
        steeper += order * rise;
    }
    const double noise = 4.0 * 0x1p-53 * size, end = a[0] + (up - down);
    /* all that falls does not use up a[0] */
    if (a[0] - down > noise)
        return SF_NONE;
    /* it falls all the way to below zero */
    if (end < -noise && a[1] < 0.0 && steeper < -a[1] - SF_ORDER * noise) {
        *zero = sf_refined(a, 0.0, 1.0);
        return SF_ONE;
    }
    double b[SF_TERMS];
    sf_bernstein(a, b);
    return sf_first_within(a, b, 0.0, 1.0, noise, 0, zero);
}
