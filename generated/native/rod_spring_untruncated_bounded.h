/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: in double-double with a bound of the error.

   Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
   never edit.

   `out` takes the outputs, where there are several. */

#ifndef ROD_SPRING_UNTRUNCATED_BOUNDED_H
#define ROD_SPRING_UNTRUNCATED_BOUNDED_H

#include "carlson.h"
#include "inline.h"

SF_FAMILY_BEGIN

/* A; sqrt(1 - u_cr^2); sine, cosine and angle of where the first piece ends.
   Equation (5). Domain: beyond > 0. */
static inline void rod_spring_untruncated_bounded_ends(sf_bounded beyond, const sf_bounded *p, sf_bounded *out)
{
    const sf_bounded delta_h = p[2];
    const sf_bounded u_cr = sfb_sqrt(sfb_add(sfb_neg(sfb_square(delta_h)), sfb_times(2.0, delta_h)));
    const sf_bounded c = sfb_sub(sfb_point(1.0), delta_h);
    const sf_bounded A = sfb_add(beyond, u_cr);
    const sf_bounded root = sfb_mul(sfb_sqrt(beyond), sfb_sqrt(sfb_add(A, u_cr)));
    const sf_bounded t0 = sfb_inverse(A);
    const sf_bounded x = sfb_mul(t0, u_cr);
    const sf_bounded y = sfb_mul(root, t0);
    const sf_bounded theta = sfb_atan2(u_cr, root);
    out[0] = A;
    out[1] = c;
    out[2] = x;
    out[3] = y;
    out[4] = theta;
}

/* The average without the last piece, over b: h, h_A, h_AA, h_AAA, h - A h_A by Carlson's integrals.
   Equation (20)-(22), (31). Domain: A > u_cr. */
static inline void rod_spring_untruncated_bounded_parts(sf_bounded A, sf_bounded c, sf_bounded x, sf_bounded y, sf_bounded theta, sf_bounded of_first, sf_bounded of_second, sf_bounded *out)
{
    const sf_bounded F = sfb_mul(of_first, x);
    const sf_bounded x2 = sfb_square(x);
    const sf_bounded x3 = sfb_mul(x, x2);
    const sf_bounded D = sfb_mul(sfb_around(0.33333333333333331, 1.8503717077085941e-17), sfb_mul(of_second, x3));
    const sf_bounded t0 = sfb_inverse(c);
    const sf_bounded t1 = sfb_mul(x, y);
    const sf_bounded t2 = sfb_around(1.2732395447351628, -7.8714706700729944e-17);
    const sf_bounded t3 = sfb_mul(t2, sfb_add(sfb_neg(D), sfb_times(0.5, sfb_mul(t0, sfb_add(sfb_neg(t1), theta)))));
    const sf_bounded t4 = sfb_mul(F, t2);
    const sf_bounded t5 = sfb_add(A, sfb_point(1.0));
    const sf_bounded t6 = sfb_sub(A, sfb_point(1.0));
    const sf_bounded t7 = sfb_div(sfb_point(1.0), sfb_mul(sfb_mul(A, t5), t6));
    const sf_bounded t8 = sfb_mul(t2, t7);
    const sf_bounded t9 = sfb_mul(t0, t1);
    const sf_bounded A2 = sfb_square(A);
    const sf_bounded t10 = sfb_mul(D, sfb_sub(A2, sfb_point(2.0)));
    const sf_bounded t11 = sfb_sub(sfb_add(sfb_mul(t10, t8), sfb_mul(t4, t7)), sfb_mul(t8, t9));
    const sf_bounded t12 = sfb_around(2.5464790894703255, -1.5742941340145989e-16);
    const sf_bounded t13 = sfb_mul(t12, t7);
    const sf_bounded t14 = sfb_times(5.0, A2);
    const sf_bounded t15 = sfb_square(t5);
    const sf_bounded t16 = sfb_square(t6);
    const sf_bounded t17 = sfb_div(sfb_point(1.0), sfb_mul(sfb_mul(A2, t15), t16));
    const sf_bounded t18 = sfb_mul(t17, sfb_sub(t14, sfb_point(3.0)));
    const sf_bounded A4 = sfb_square(A2);
    const sf_bounded t19 = sfb_sub(sfb_point(3.0), t14);
    const sf_bounded t20 = sfb_mul(sfb_mul(D, t17), sfb_add(A4, t19));
    const sf_bounded t21 = sfb_mul(A4, x2);
    const sf_bounded t22 = sfb_mul(A2, x2);
    const sf_bounded t23 = sfb_mul(t0, x);
    const sf_bounded t24 = sfb_div(sfb_mul(sfb_mul(t17, t23), sfb_sub(sfb_add(sfb_add(t19, t21), sfb_times(4.0, t22)),
        sfb_times(3.0, x2))), y);
    const sf_bounded t25 = sfb_around(3.8197186342054881, -1.4099515177158535e-17);
    const sf_bounded t26 = sfb_add(sfb_add(sfb_neg(sfb_times(31.0, A2)), sfb_times(27.0, A4)), sfb_point(12.0));
    const sf_bounded t27 = sfb_mul(t15, t5);
    const sf_bounded t28 = sfb_mul(t16, t6);
    const sf_bounded A3 = sfb_mul(A, A2);
    const sf_bounded t29 = sfb_div(sfb_point(1.0), sfb_mul(sfb_mul(A3, t27), t28));
    const sf_bounded A6 = sfb_square(A3);
    const sf_bounded t30 = sfb_times(6.0, A6);
    const sf_bounded t31 = sfb_mul(t2, t29);
    const sf_bounded x4 = sfb_square(x2);
    const sf_bounded y2 = sfb_square(y);
    const sf_bounded y3 = sfb_mul(y, y2);
    out[0] = sfb_mul(A, t3);
    out[1] = sfb_add(sfb_mul(A, t11), t3);
    out[2] = sfb_sub(sfb_add(sfb_add(sfb_mul(A, sfb_sub(sfb_sub(sfb_neg(sfb_mul(t12, t20)), sfb_mul(t18, t4)),
        sfb_mul(t2, t24))), sfb_mul(F, t13)), sfb_mul(t10, t13)), sfb_mul(t13, t9));
    out[3] = sfb_sub(sfb_sub(sfb_sub(sfb_mul(A, sfb_add(sfb_sub(sfb_mul(sfb_mul(D, t31),
        sfb_sub(sfb_add(sfb_sub(sfb_times(65.0, A2), sfb_times(55.0, A4)), t30), sfb_point(24.0))),
        sfb_div(sfb_mul(sfb_mul(t23, t31),
        sfb_add(sfb_sub(sfb_add(sfb_add(sfb_add(sfb_sub(sfb_sub(sfb_add(sfb_neg(sfb_times(29.0, sfb_mul(A2, x4))),
        sfb_times(19.0, sfb_mul(A4, x4))), sfb_times(7.0, sfb_mul(A6, x2))), sfb_times(44.0, t21)), sfb_times(59.0,
        t22)), t26), sfb_mul(t30, x4)), sfb_times(24.0, x2)), sfb_times(12.0, x4))), y3)), sfb_mul(sfb_mul(t26,
        t29), t4))), sfb_mul(sfb_mul(F, t18), t25)), sfb_mul(sfb_around(7.6394372684109761, -2.819903035431707e-17),
        t20)), sfb_mul(t24, t25));
    out[4] = sfb_neg(sfb_mul(A2, t11));
}

SF_FAMILY_END

#endif
