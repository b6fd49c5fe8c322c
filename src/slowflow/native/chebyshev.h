/* Sums of Chebyshev's polynomials, which stand for forces that are known by their values. */
#pragma once

/* Coefficients of degrees 0 to `degree`, x on [-1, 1]; Clenshaw's recurrence in the order of NumPy's chebval. */
static inline double sf_chebyshev(const double *c, int degree, double x) {
    double low = degree > 0 ? c[degree - 1] : c[0], high = degree > 0 ? c[degree] : 0;
    for (int i = degree - 2; i >= 0; i--) {
        const double next = c[i] - high;
        high = low + high * 2 * x, low = next;
    }
    return low + high * x;
}
