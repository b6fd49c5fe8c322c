/* Arithmetic on intervals over NumPy's operands, as slowflow/intervals.py takes it.
 *
 * Otherwise than in interval.h 0 times what is not known is 0, and ends that are no numbers do not hide others: the
 * search in boxes asks for that. Of a few boxes NumPy takes most of its time between its operations.
 */
#include <math.h>

#include "solver.h"

#define ULP 0x1p-52
#define LEAST 0x1p-1022
#define IN(k) (*(const double *)(operands[k] + i * steps[k]))
#define OUT(k) (*(double *)(operands[k] + i * steps[k]))

static inline double wider(double x, double ulp) { return x + ulp * fabs(x); }

/* (lo, hi) times (lo, hi): the extremes of four products, of those that are numbers; NaN where one is not known. */
void sf_interval_product_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const double a[2] = {IN(0), IN(1)}, b[2] = {IN(2), IN(3)};
        double low = NAN, high = NAN;
        int unknown = 0;
        for (int j = 0; j < 4; j++) {
            const double x = a[j >> 1], y = b[j & 1], product = x * y, error = ULP * fabs(product) + LEAST;
            const int zero = x == 0 || y == 0;
            low = fmin(low, zero ? 0 : product - error);
            high = fmax(high, zero ? 0 : product + error);
            unknown |= isnan(product) && !zero;
        }
        OUT(4) = unknown ? NAN : low;
        OUT(5) = unknown ? NAN : high;
    }
}

/* The square of (lo, hi), which is not negative; NaN where lo <= hi is not known. */
void sf_interval_square_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const double lo = IN(0), hi = IN(1);
        const int known = lo <= hi;
        const double least = lo > 0 ? lo : hi < 0 ? -hi : 0, most = -lo > hi ? -lo : hi;
        const double low = wider(least * least, -ULP) - LEAST * (least != 0);
        OUT(2) = !known ? NAN : low < 0 ? 0 : low;
        OUT(3) = known ? wider(most * most, ULP) + LEAST * (most != 0) : NAN;
    }
}

/* 1 over (lo, hi) on one side of 0, which it may touch; anything over one that holds 0 inside. */
void sf_interval_inverse_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const double lo = IN(0), hi = IN(1);
        double low = wider(1 / hi, -ULP) - LEAST, high = wider(1 / lo, ULP) + LEAST;
        if (hi > 0)
            low = lo >= 0 ? (low < 0 ? 0 : low) : -HUGE_VAL;
        if (lo < 0)
            high = hi <= 0 ? (high > 0 ? 0 : high) : HUGE_VAL;
        if (hi == 0)
            low = -HUGE_VAL;
        if (lo == 0)
            high = HUGE_VAL;
        OUT(2) = lo <= hi ? low : NAN;
        OUT(3) = lo <= hi ? high : NAN;
    }
}
