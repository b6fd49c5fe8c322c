/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: in double-double with a bound of the error.

   Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
   never edit.

   `out` takes the outputs, where there are several. */

#ifndef ROD_SPRING_UNTRUNCATED_BOUNDED_H
#define ROD_SPRING_UNTRUNCATED_BOUNDED_H

#include "carlson.h"
#include "inline.h"
#include "arithmetic_bounded.h"

SF_FAMILY_BEGIN

/* A; sqrt(1 - u_cr^2); sine, cosine and angle of where the first piece ends.
   Equation (5). Domain: beyond > 0. */
static inline void rod_spring_untruncated_bounded_ends(sf_bounded beyond, const sf_bounded *p, sf_bounded *out) {
    const sf_bounded delta_h = p[2];
    const sf_bounded u_cr = SQRT(ADD(NEG(SQUARE(delta_h)), TIMES(2.0, delta_h)));
    const sf_bounded c = SUB(POINT(1.0), delta_h);
    const sf_bounded A = ADD(beyond, u_cr);
    const sf_bounded root = MUL(SQRT(beyond), SQRT(ADD(A, u_cr)));
    const sf_bounded t0 = INVERSE(A);
    const sf_bounded x = MUL(t0, u_cr);
    const sf_bounded y = MUL(root, t0);
    const sf_bounded theta = ATAN2_SWAPPED(root, u_cr);
    out[0] = A;
    out[1] = c;
    out[2] = x;
    out[3] = y;
    out[4] = theta;
}

/* The average without the last piece, over b: h, h_A, h_AA, h_AAA, h - A h_A by Carlson's integrals.
   Equation (20)-(22), (31). Domain: A > u_cr. */
static inline void rod_spring_untruncated_bounded_parts(sf_bounded A, sf_bounded c, sf_bounded x, sf_bounded y, sf_bounded theta, sf_bounded of_first, sf_bounded of_second, sf_bounded *out) {
    const sf_bounded F = MUL(of_first, x);
    const sf_bounded x2 = SQUARE(x);
    const sf_bounded x3 = MUL(x, x2);
    const sf_bounded D = MUL(CONSTANT(0.33333333333333331, 1.8503717077085941e-17), MUL(of_second, x3));
    const sf_bounded t0 = INVERSE(c);
    const sf_bounded t1 = MUL(x, y);
    const sf_bounded t2 = CONSTANT(1.2732395447351628, -7.8714706700729944e-17);
    const sf_bounded t3 = MUL(t2, ADD(NEG(D), TIMES(0.5, MUL(t0, ADD(NEG(t1), theta)))));
    const sf_bounded t4 = MUL(F, t2);
    const sf_bounded t5 = ADD(A, POINT(1.0));
    const sf_bounded t6 = SUB(A, POINT(1.0));
    const sf_bounded t7 = DIV(POINT(1.0), MUL(MUL(A, t5), t6));
    const sf_bounded t8 = MUL(t2, t7);
    const sf_bounded t9 = MUL(t0, t1);
    const sf_bounded A2 = SQUARE(A);
    const sf_bounded t10 = MUL(D, SUB(A2, POINT(2.0)));
    const sf_bounded t11 = SUB(ADD(MUL(t10, t8), MUL(t4, t7)), MUL(t8, t9));
    const sf_bounded t12 = CONSTANT(2.5464790894703255, -1.5742941340145989e-16);
    const sf_bounded t13 = MUL(t12, t7);
    const sf_bounded t14 = TIMES(5.0, A2);
    const sf_bounded t15 = SQUARE(t5);
    const sf_bounded t16 = SQUARE(t6);
    const sf_bounded t17 = DIV(POINT(1.0), MUL(MUL(A2, t15), t16));
    const sf_bounded t18 = MUL(t17, SUB(t14, POINT(3.0)));
    const sf_bounded A4 = SQUARE(A2);
    const sf_bounded t19 = SUB(POINT(3.0), t14);
    const sf_bounded t20 = MUL(MUL(D, t17), ADD(A4, t19));
    const sf_bounded t21 = MUL(A4, x2);
    const sf_bounded t22 = MUL(A2, x2);
    const sf_bounded t23 = MUL(t0, x);
    const sf_bounded t24 = DIV(MUL(MUL(t17, t23), SUB(ADD(ADD(t19, t21), TIMES(4.0, t22)), TIMES(3.0, x2))), y);
    const sf_bounded t25 = CONSTANT(3.8197186342054881, -1.4099515177158535e-17);
    const sf_bounded t26 = ADD(ADD(NEG(TIMES(31.0, A2)), TIMES(27.0, A4)), POINT(12.0));
    const sf_bounded t27 = MUL(t15, t5);
    const sf_bounded t28 = MUL(t16, t6);
    const sf_bounded A3 = MUL(A, A2);
    const sf_bounded t29 = DIV(POINT(1.0), MUL(MUL(A3, t27), t28));
    const sf_bounded A6 = SQUARE(A3);
    const sf_bounded t30 = TIMES(6.0, A6);
    const sf_bounded t31 = MUL(t2, t29);
    const sf_bounded x4 = SQUARE(x2);
    const sf_bounded y2 = SQUARE(y);
    const sf_bounded y3 = MUL(y, y2);
    out[0] = MUL(A, t3);
    out[1] = ADD(MUL(A, t11), t3);
    out[2] = SUB(ADD(ADD(MUL(A, SUB(SUB(NEG(MUL(t12, t20)), MUL(t18, t4)), MUL(t2, t24))), MUL(F, t13)), MUL(t10,
        t13)), MUL(t13, t9));
    out[3] = SUB(SUB(SUB(MUL(A, ADD(SUB(MUL(MUL(D, t31), SUB(ADD(SUB(TIMES(65.0, A2), TIMES(55.0, A4)), t30),
        POINT(24.0))), DIV(MUL(MUL(t23, t31), ADD(SUB(ADD(ADD(ADD(SUB(SUB(ADD(NEG(TIMES(29.0, MUL(A2, x4))),
        TIMES(19.0, MUL(A4, x4))), TIMES(7.0, MUL(A6, x2))), TIMES(44.0, t21)), TIMES(59.0, t22)), t26), MUL(t30,
        x4)), TIMES(24.0, x2)), TIMES(12.0, x4))), y3)), MUL(MUL(t26, t29), t4))), MUL(MUL(F, t18), t25)),
        MUL(CONSTANT(7.6394372684109761, -2.819903035431707e-17), t20)), MUL(t24, t25));
    out[4] = NEG(MUL(A2, t11));
}

SF_FAMILY_END

#include "arithmetic_end.h"
#endif
