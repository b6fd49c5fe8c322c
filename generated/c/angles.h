/* The arctangent that all generated C calls: it vectorises, and gives the same digits with every compiler and library.

   Written by `make derive` from the Chebyshev series in derivations/codegen/arctangent.py; never edit.

   C99. Wrong with fast-math; build with contraction off if the digits are to be the same everywhere. */

#ifndef ANGLES_H
#define ANGLES_H

#include <float.h>
#include <math.h>

#include "inline.h"

/* e; *t is the quotient of the smaller and the larger of |x| and |y|, rounded once, and t + t e is within 0.028 u of
   atan(t), u = 2^-53. No branches, no 0/0: a sum, as compilers make of a choice two quotients, of which the one by 1
   overflows further on. Both functions take it of the same arguments: a compiler computes it once where both acute angles
   of a triangle are needed. */
SF_COMMON double angles_of_quotient(double x, double y, double *t) {
    const double a = fabs(x), b = fabs(y);
    const double larger = b > a ? b : a;
    const double smaller = b > a ? a : b;
    const int infinite = (a > DBL_MAX) & (b > DBL_MAX);
    const double above = infinite ? 1.0 : smaller;
    const double below = infinite ? 1.0 : larger + (larger == 0.0);
    *t = above / below;
    const double w = *t * *t - 0.5;
    const double e0_0 = -0.1295802486328968 + w * -0.20375308470043654;
    const double e0_1 = 0.083407404828432535 + w * -0.040246909281954631;
    const double e0_2 = 0.021049375194045355 + w * -0.011551426789700016;
    const double e0_3 = 0.0065456999140787462 + w * -0.0037952050551789589;
    const double e0_4 = 0.0022387042108408758 + w * -0.001338408644987374;
    const double e0_5 = 0.00080882295597646656 + w * -0.00049311267346680032;
    const double e0_6 = 0.00030286054650797961 + w * -0.00018719835343029235;
    const double e0_7 = 0.00011628414347979453 + w * -7.2405152211318089e-05;
    const double e0_8 = 4.5526115476739991e-05 + w * -2.9487289317705549e-05;
    const double e0_9 = 1.8154196063996323e-05 + w * -9.0073528212208615e-06;
    const double e0_10 = 6.5171034141287979e-06 + w * -8.2679958173371503e-06;
    const double w2 = w * w;
    const double e1_0 = e0_0 + w2 * e0_1;
    const double e1_1 = e0_2 + w2 * e0_3;
    const double e1_2 = e0_4 + w2 * e0_5;
    const double e1_3 = e0_6 + w2 * e0_7;
    const double e1_4 = e0_8 + w2 * e0_9;
    const double e1_5 = e0_10 + w2 * 4.6583428695989543e-06;
    const double w4 = w2 * w2;
    const double e2_0 = e1_0 + w4 * e1_1;
    const double e2_1 = e1_2 + w4 * e1_3;
    const double e2_2 = e1_4 + w4 * e1_5;
    const double w8 = w4 * w4;
    const double e3_0 = e2_0 + w8 * e2_1;
    const double w16 = w8 * w8;
    const double e4_0 = e3_0 + w16 * e2_2;
    return e4_0;
}

/* The angle of (x, y) from -pi to pi; signed zeros and infinities as in C99's atan2, NaN if either is NaN. */
static inline double angles_atan2(double y, double x) {
    double t;
    const double e = angles_of_quotient(x, y, &t);
    const int steep = fabs(y) > fabs(x);
    /* right half t, pi/2 - t; left half pi/2 + t, pi - t */
    const double side = copysign(1.0, x);
    const double base = steep ? 1.5707963267948966 : side < 0.0 ? 3.1415926535897931 : 0.0;
    const double base_low = steep ? 6.123233995736766e-17 : side < 0.0 ? 1.2246467991473532e-16 : 0.0;
    const double s = side * (steep ? -t : t);
    const double high = base + s;
    const double low = s - (high - base);
    return copysign(high + (low + (base_low + s * e)), y);
}

/* The angle of (y, x): what atan2(x, y) gives. */
static inline double angles_atan2_swapped(double y, double x) {
    double t;
    const double e = angles_of_quotient(x, y, &t);
    const int steep = fabs(y) > fabs(x);
    const double side = copysign(1.0, y);
    const double base = steep ? (side < 0.0 ? 3.1415926535897931 : 0.0) : 1.5707963267948966;
    const double base_low = steep ? (side < 0.0 ? 1.2246467991473532e-16 : 0.0) : 6.123233995736766e-17;
    const double s = side * (steep ? t : -t);
    const double high = base + s;
    const double low = s - (high - base);
    return copysign(high + (low + (base_low + s * e)), x);
}

#endif
