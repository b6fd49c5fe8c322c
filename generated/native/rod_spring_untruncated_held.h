/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: in double-double with a bound of the error.

   Written by `make derive`; never edit.
   Input: derivations/mechanisms/rod_spring_untruncated.py, sha256 fcc795df716f7e2f9f892242cfe193b7bb6d648ba5e980491479e0dbe8cfd9fa
   Input: none but the equation of motion in derivations/asymmetric/curved.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   `out` takes the outputs, where there are several. */

#ifndef ROD_SPRING_UNTRUNCATED_HELD_H
#define ROD_SPRING_UNTRUNCATED_HELD_H

#include "carlson.h"
#include "inline.h"

SF_FAMILY_BEGIN

/* A; sqrt(1 - u_cr^2); sine, cosine and angle of where the first piece ends.
   Equation (5). Domain: beyond > 0. */
static inline void rod_spring_untruncated_held_ends(sf_held beyond, const sf_held *p, sf_held *out)
{
    const sf_held delta_h = p[2];
    const sf_held u_cr = sfh_sqrt(sfh_add(sfh_neg(sfh_square(delta_h)), sfh_times(2.0, delta_h)));
    const sf_held c = sfh_sub(sfh_point(1.0), delta_h);
    const sf_held A = sfh_add(beyond, u_cr);
    const sf_held root = sfh_mul(sfh_sqrt(beyond), sfh_sqrt(sfh_add(A, u_cr)));
    const sf_held t0 = sfh_inverse(A);
    const sf_held x = sfh_mul(t0, u_cr);
    const sf_held y = sfh_mul(root, t0);
    const sf_held theta = sfh_atan2(u_cr, root);
    out[0] = A;
    out[1] = c;
    out[2] = x;
    out[3] = y;
    out[4] = theta;
}

/* The average without the last piece, over b: h, h_A, h_AA, h_AAA, h - A h_A by Carlson's integrals.
   Equation (20)-(22), (31). Domain: A > u_cr. */
static inline void rod_spring_untruncated_held_parts(sf_held A, sf_held c, sf_held x, sf_held y, sf_held theta, sf_held of_first, sf_held of_second, sf_held *out)
{
    const sf_held F = sfh_mul(of_first, x);
    const sf_held x2 = sfh_square(x);
    const sf_held x3 = sfh_mul(x, x2);
    const sf_held D = sfh_mul(sfh_around(0.33333333333333331, 1.8503717077085941e-17), sfh_mul(of_second, x3));
    const sf_held t0 = sfh_inverse(c);
    const sf_held t1 = sfh_mul(x, y);
    const sf_held t2 = sfh_around(1.2732395447351628, -7.8714706700729944e-17);
    const sf_held t3 = sfh_mul(t2, sfh_add(sfh_neg(D), sfh_times(0.5, sfh_mul(t0, sfh_add(sfh_neg(t1), theta)))));
    const sf_held t4 = sfh_mul(F, t2);
    const sf_held t5 = sfh_add(A, sfh_point(1.0));
    const sf_held t6 = sfh_sub(A, sfh_point(1.0));
    const sf_held t7 = sfh_div(sfh_point(1.0), sfh_mul(sfh_mul(A, t5), t6));
    const sf_held t8 = sfh_mul(t2, t7);
    const sf_held t9 = sfh_mul(t0, t1);
    const sf_held A2 = sfh_square(A);
    const sf_held t10 = sfh_mul(D, sfh_sub(A2, sfh_point(2.0)));
    const sf_held t11 = sfh_sub(sfh_add(sfh_mul(t10, t8), sfh_mul(t4, t7)), sfh_mul(t8, t9));
    const sf_held t12 = sfh_around(2.5464790894703255, -1.5742941340145989e-16);
    const sf_held t13 = sfh_mul(t12, t7);
    const sf_held t14 = sfh_times(5.0, A2);
    const sf_held t15 = sfh_square(t5);
    const sf_held t16 = sfh_square(t6);
    const sf_held t17 = sfh_div(sfh_point(1.0), sfh_mul(sfh_mul(A2, t15), t16));
    const sf_held t18 = sfh_mul(t17, sfh_sub(t14, sfh_point(3.0)));
    const sf_held A4 = sfh_square(A2);
    const sf_held t19 = sfh_sub(sfh_point(3.0), t14);
    const sf_held t20 = sfh_mul(sfh_mul(D, t17), sfh_add(A4, t19));
    const sf_held t21 = sfh_mul(A4, x2);
    const sf_held t22 = sfh_mul(A2, x2);
    const sf_held t23 = sfh_mul(t0, x);
    const sf_held t24 = sfh_div(sfh_mul(sfh_mul(t17, t23), sfh_sub(sfh_add(sfh_add(t19, t21), sfh_times(4.0, t22)),
        sfh_times(3.0, x2))), y);
    const sf_held t25 = sfh_around(3.8197186342054881, -1.4099515177158535e-17);
    const sf_held t26 = sfh_add(sfh_add(sfh_neg(sfh_times(31.0, A2)), sfh_times(27.0, A4)), sfh_point(12.0));
    const sf_held t27 = sfh_mul(t15, t5);
    const sf_held t28 = sfh_mul(t16, t6);
    const sf_held A3 = sfh_mul(A, A2);
    const sf_held t29 = sfh_div(sfh_point(1.0), sfh_mul(sfh_mul(A3, t27), t28));
    const sf_held A6 = sfh_square(A3);
    const sf_held t30 = sfh_times(6.0, A6);
    const sf_held t31 = sfh_mul(t2, t29);
    const sf_held x4 = sfh_square(x2);
    const sf_held y2 = sfh_square(y);
    const sf_held y3 = sfh_mul(y, y2);
    out[0] = sfh_mul(A, t3);
    out[1] = sfh_add(sfh_mul(A, t11), t3);
    out[2] = sfh_sub(sfh_add(sfh_add(sfh_mul(A, sfh_sub(sfh_sub(sfh_neg(sfh_mul(t12, t20)), sfh_mul(t18, t4)),
        sfh_mul(t2, t24))), sfh_mul(F, t13)), sfh_mul(t10, t13)), sfh_mul(t13, t9));
    out[3] = sfh_sub(sfh_sub(sfh_sub(sfh_mul(A, sfh_add(sfh_sub(sfh_mul(sfh_mul(D, t31),
        sfh_sub(sfh_add(sfh_sub(sfh_times(65.0, A2), sfh_times(55.0, A4)), t30), sfh_point(24.0))),
        sfh_div(sfh_mul(sfh_mul(t23, t31),
        sfh_add(sfh_sub(sfh_add(sfh_add(sfh_add(sfh_sub(sfh_sub(sfh_add(sfh_neg(sfh_times(29.0, sfh_mul(A2, x4))),
        sfh_times(19.0, sfh_mul(A4, x4))), sfh_times(7.0, sfh_mul(A6, x2))), sfh_times(44.0, t21)), sfh_times(59.0,
        t22)), t26), sfh_mul(t30, x4)), sfh_times(24.0, x2)), sfh_times(12.0, x4))), y3)), sfh_mul(sfh_mul(t26,
        t29), t4))), sfh_mul(sfh_mul(F, t18), t25)), sfh_mul(sfh_around(7.6394372684109761, -2.819903035431707e-17),
        t20)), sfh_mul(t24, t25));
    out[4] = sfh_neg(sfh_mul(A2, t11));
}

SF_FAMILY_END

#endif
