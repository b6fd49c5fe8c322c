/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: in double-double.

   Written by `make derive` from derivations/mechanisms/rod_spring.py; never edit.

   `out` takes the outputs, where there are several.
   Equations and domains that are not stated here are those of rod_spring.h.
   passed: how many breakpoints the amplitude exceeds; beyond: by how much it exceeds the last of these. */

#ifndef ROD_SPRING_PAIRS_H
#define ROD_SPRING_PAIRS_H

#include "pair_angles.h"
#include "inline.h"

SF_FAMILY_BEGIN

/* The |u| at which a piece of the force ends. */
static inline void rod_spring_pairs_breakpoints(const sf_pair *p, sf_pair *out)
{
    const sf_pair u_cr = p[3];
    out[0] = u_cr;
}

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
static inline void rod_spring_pairs_given(sf_pair lam, sf_pair r, sf_pair delta_h, sf_pair *out)
{
    const sf_pair u_cr = sfp_mul(sfp_sqrt(delta_h), sfp_sqrt(sfp_sub(sfp_point(2.0), delta_h)));
    const sf_pair t0 = sfp_mul(lam, r);
    const sf_pair t1 = sfp_mul(t0, sfp_sub(delta_h, sfp_point(1.0)));
    const sf_pair delta_h2 = sfp_square(delta_h);
    const sf_pair delta_h3 = sfp_mul(delta_h, delta_h2);
    out[0] = sfp_add(sfp_neg(sfp_mul(delta_h, t0)), sfp_point(1.0));
    out[1] = sfp_neg(sfp_times(0.5, t1));
    out[2] = sfp_neg(sfp_times(0.375, t1));
    out[3] = u_cr;
    out[4] = sfp_neg(sfp_times(0.125, sfp_mul(sfp_mul(sfp_mul(delta_h3, t0), u_cr),
        sfp_add(sfp_add(sfp_neg(sfp_times(15.0, delta_h)), sfp_times(3.0, delta_h2)), sfp_point(20.0)))));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
TWOFOLD_INLINE void rod_spring_pairs_known_passed_0(sf_pair A, sf_pair beyond, const sf_pair *p, sf_pair *out)
{
    const sf_pair alpha = p[0], beta = p[1], gamma = p[2];
    const sf_pair t0 = sfp_neg(alpha);
    const sf_pair A2 = sfp_square(A);
    const sf_pair t1 = sfp_mul(A2, gamma);
    const sf_pair t2 = sfp_times(4.5, beta);
    const sf_pair A3 = sfp_mul(A, A2);
    out[0] = sfp_mul(A, sfp_add(sfp_mul(A2, sfp_sub(sfp_neg(sfp_times(0.75, beta)), sfp_times(0.625, t1))), t0));
    out[1] = sfp_add(sfp_mul(A2, sfp_sub(sfp_neg(sfp_times(2.25, beta)), sfp_times(3.125, t1))), t0);
    out[2] = sfp_mul(A, sfp_sub(sfp_neg(sfp_times(12.5, t1)), t2));
    out[3] = sfp_sub(sfp_neg(sfp_times(37.5, t1)), t2);
    out[4] = sfp_mul(A3, sfp_add(sfp_times(1.5, beta), sfp_times(2.5, t1)));
}

TWOFOLD_INLINE void rod_spring_pairs_known_passed_1_far_1(sf_pair A, sf_pair beyond, const sf_pair *p, sf_pair *out)
{
    const sf_pair alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3], jump_1 = p[4];
    const sf_pair root = sfp_mul(sfp_sqrt(beyond), sfp_sqrt(sfp_add(A, u_cr)));
    const sf_pair t0 = sfp_inverse(A);
    const sf_pair x = sfp_mul(t0, u_cr);
    const sf_pair y = sfp_mul(root, t0);
    const sf_pair s = sfp_div(x, sfp_sqrt(sfp_add(sfp_times(2.0, y), sfp_point(2.0))));
    const sf_pair s2 = sfp_square(s);
    const sf_pair s4 = sfp_square(s2);
    const sf_pair s3 = sfp_mul(s, s2);
    const sf_pair s6 = sfp_square(s3);
    const sf_pair s7 = sfp_mul(s, s6);
    const sf_pair M6 = sfp_mul(s7, sfp_add(sfp_add(sfp_mul(s2, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4,
        sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4,
        sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4,
        sfp_sub(sfp_neg(sfp_mul(sfp_of(3.6492503041747691e-05, -2.8531636118039589e-21), s4)),
        sfp_of(5.3427095924732542e-05, -2.8127886550331484e-21))), sfp_of(8.10560684803189e-05,
        6.3613902977465824e-21))), sfp_of(0.00012837971250216165, 9.0350181040458698e-21))),
        sfp_of(0.00021441317186122989, -1.3221977713237859e-20))), sfp_of(0.00038296467549092059,
        1.6116518780189932e-20))), sfp_of(0.000746755888967803, 2.6283689029951623e-20))),
        sfp_of(0.0016416352370689656, -8.2249819981658953e-20))), sfp_of(0.0042968750000000003,
        -3.4694469519536144e-19))), sfp_of(0.01488095238095238, 8.2605879808419381e-19))),
        sfp_of(0.088235294117647065, -5.7143832149824231e-18))), sfp_of(3.0769230769230771,
        -1.7080354225002409e-16))), sfp_of(35.555555555555557, -1.578983857244667e-15))), sfp_mul(s4,
        sfp_add(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4,
        sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4, sfp_sub(sfp_mul(s4,
        sfp_sub(sfp_neg(sfp_mul(sfp_of(4.3976166456228718e-05, -3.0801198081974557e-21), s4)),
        sfp_of(6.5487812903216656e-05, 7.9720747976875325e-22))), sfp_of(0.00010140631546048408,
        -2.3068131329478817e-21))), sfp_of(0.00016468815332235291, 1.1976651905363131e-20))),
        sfp_of(0.00028384801668998523, -6.9500139261891304e-21))), sfp_of(0.00052806309291294638,
        4.6465807392235902e-20))), sfp_of(0.0010878039944556453, -9.0933085434268117e-20))),
        sfp_of(0.0025860821759259261, -2.0880930729350455e-19))), sfp_of(0.007642663043478261,
        -1.1313413973761785e-19))), sfp_of(0.032894736842105261, 1.8260247115545337e-18))),
        sfp_of(0.33333333333333331, 1.8503717077085941e-17))), sfp_of(21.818181818181817,
        1.6148698540002276e-15)))), sfp_of(18.285714285714285, 1.0150610510858574e-15)));
    const sf_pair x2 = sfp_square(x);
    const sf_pair x4 = sfp_square(x2);
    const sf_pair x5 = sfp_mul(x, x4);
    const sf_pair M4 = sfp_add(sfp_mul(sfp_of(1.2, 4.4408920985006264e-17), M6), sfp_mul(sfp_of(0.20000000000000001,
        -1.1102230246251566e-17), sfp_mul(x5, y)));
    const sf_pair x3 = sfp_mul(x, x2);
    const sf_pair M2 = sfp_add(sfp_mul(sfp_of(1.3333333333333333, 7.4014868308343765e-17), M4),
        sfp_mul(sfp_of(0.33333333333333331, 1.8503717077085941e-17), sfp_mul(x3, y)));
    const sf_pair S2_2 = sfp_add(sfp_neg(M2), sfp_of(0.78539816339744828, 3.061616997868383e-17));
    const sf_pair A2 = sfp_square(A);
    const sf_pair t1 = sfp_mul(M4, beta);
    const sf_pair A4 = sfp_square(A2);
    const sf_pair t2 = sfp_mul(M6, gamma);
    const sf_pair t3 = sfp_mul(A4, t2);
    const sf_pair t4 = sfp_add(sfp_mul(M2, alpha), S2_2);
    const sf_pair t5 = sfp_times(3.0, beta);
    const sf_pair t6 = sfp_inverse(A2);
    const sf_pair t7 = sfp_inverse(root);
    const sf_pair u_cr2 = sfp_square(u_cr);
    const sf_pair t8 = sfp_times(6.0, t1);
    const sf_pair A3 = sfp_mul(A, A2);
    const sf_pair t9 = sfp_mul(jump_1, u_cr2);
    const sf_pair root2 = sfp_square(root);
    const sf_pair root3 = sfp_mul(root, root2);
    const sf_pair t10 = sfp_inverse(root3);
    const sf_pair t11 = sfp_mul(t10, t9);
    const sf_pair t12 = sfp_div(t7, A3);
    const sf_pair t13 = sfp_mul(gamma, u_cr2);
    const sf_pair u_cr3 = sfp_mul(u_cr, u_cr2);
    const sf_pair t14 = sfp_mul(u_cr3, sfp_add(sfp_sub(sfp_neg(alpha), sfp_mul(u_cr2, sfp_add(sfp_times(5.0, t13),
        t5))), sfp_point(1.0)));
    const sf_pair t15 = sfp_inverse(A4);
    const sf_pair t16 = sfp_mul(t7, t9);
    const sf_pair t17 = sfp_mul(t15, t7);
    const sf_pair u_cr4 = sfp_square(u_cr2);
    const sf_pair u_cr5 = sfp_mul(u_cr, u_cr4);
    const sf_pair A5 = sfp_mul(A, A4);
    out[0] = sfp_neg(sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17), sfp_mul(A,
        sfp_add(sfp_add(sfp_mul(A2, t1), t3), t4))));
    out[1] = sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17),
        sfp_sub(sfp_sub(sfp_add(sfp_neg(sfp_mul(sfp_mul(A2, M4), t5)), sfp_mul(sfp_mul(sfp_mul(jump_1, t6), t7),
        u_cr2)), sfp_times(5.0, t3)), t4));
    out[2] = sfp_neg(sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17),
        sfp_add(sfp_add(sfp_add(sfp_add(sfp_mul(A, t8), sfp_times(20.0, sfp_mul(A3, t2))), sfp_mul(t0, t11)),
        sfp_mul(t12, t14)), sfp_times(2.0, sfp_mul(t12, t9)))));
    out[3] = sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17),
        sfp_sub(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_neg(sfp_times(60.0, sfp_mul(A2, t2))),
        sfp_mul(sfp_mul(t10, t14), t6)), sfp_mul(sfp_mul(t10, t6), t9)), sfp_mul(t11, sfp_add(sfp_times(2.0, t6),
        sfp_div(sfp_point(3.0), root2)))), sfp_times(3.0, sfp_mul(t14, t17))), sfp_times(6.0, sfp_mul(t15, t16))),
        sfp_times(2.0, sfp_mul(sfp_mul(t17, u_cr5), sfp_add(sfp_times(10.0, t13), t5)))), t8));
    out[4] = sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17), sfp_sub(sfp_add(sfp_times(2.0,
        sfp_mul(A3, t1)), sfp_times(4.0, sfp_mul(A5, t2))), sfp_mul(t0, t16)));
}

TWOFOLD_INLINE void rod_spring_pairs_known_passed_1(sf_pair A, sf_pair beyond, const sf_pair *p, sf_pair *out)
{
    const sf_pair alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3], jump_1 = p[4];
    const sf_pair root = sfp_mul(sfp_sqrt(beyond), sfp_sqrt(sfp_add(A, u_cr)));
    const sf_pair t0 = sfp_inverse(A);
    const sf_pair x = sfp_mul(t0, u_cr);
    const sf_pair y = sfp_mul(root, t0);
    const sf_pair psi_0 = pair_angles_atan2(root, u_cr);
    const sf_pair theta = pair_angles_atan2_swapped(root, u_cr);
    const sf_pair t1 = sfp_mul(x, y);
    const sf_pair t2 = sfp_times(0.5, t1);
    const sf_pair M2 = sfp_add(sfp_neg(t2), sfp_times(0.5, theta));
    const sf_pair t3 = sfp_square(x);
    const sf_pair M4 = sfp_add(sfp_neg(sfp_mul(t1, sfp_add(sfp_times(0.25, t3), sfp_point(0.375)))), sfp_times(0.375,
        theta));
    const sf_pair M6 = sfp_add(sfp_neg(sfp_mul(t1, sfp_add(sfp_mul(t3, sfp_add(sfp_mul(sfp_of(0.16666666666666666,
        9.2518585385429707e-18), t3), sfp_of(0.20833333333333334, -9.2518585385429707e-18))), sfp_point(0.3125)))),
        sfp_times(0.3125, theta));
    const sf_pair S2_2 = sfp_add(sfp_times(0.5, psi_0), t2);
    const sf_pair A2 = sfp_square(A);
    const sf_pair t4 = sfp_mul(M4, beta);
    const sf_pair A4 = sfp_square(A2);
    const sf_pair t5 = sfp_mul(M6, gamma);
    const sf_pair t6 = sfp_mul(A4, t5);
    const sf_pair t7 = sfp_add(sfp_mul(M2, alpha), S2_2);
    const sf_pair t8 = sfp_times(3.0, beta);
    const sf_pair t9 = sfp_inverse(A2);
    const sf_pair t10 = sfp_inverse(root);
    const sf_pair u_cr2 = sfp_square(u_cr);
    const sf_pair t11 = sfp_times(6.0, t4);
    const sf_pair A3 = sfp_mul(A, A2);
    const sf_pair t12 = sfp_mul(jump_1, u_cr2);
    const sf_pair root2 = sfp_square(root);
    const sf_pair root3 = sfp_mul(root, root2);
    const sf_pair t13 = sfp_inverse(root3);
    const sf_pair t14 = sfp_mul(t12, t13);
    const sf_pair t15 = sfp_div(t10, A3);
    const sf_pair t16 = sfp_mul(gamma, u_cr2);
    const sf_pair u_cr3 = sfp_mul(u_cr, u_cr2);
    const sf_pair t17 = sfp_mul(u_cr3, sfp_add(sfp_sub(sfp_neg(alpha), sfp_mul(u_cr2, sfp_add(sfp_times(5.0, t16),
        t8))), sfp_point(1.0)));
    const sf_pair t18 = sfp_inverse(A4);
    const sf_pair t19 = sfp_mul(t10, t12);
    const sf_pair t20 = sfp_mul(t10, t18);
    const sf_pair u_cr4 = sfp_square(u_cr2);
    const sf_pair u_cr5 = sfp_mul(u_cr, u_cr4);
    const sf_pair A5 = sfp_mul(A, A4);
    out[0] = sfp_neg(sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17), sfp_mul(A,
        sfp_add(sfp_add(sfp_mul(A2, t4), t6), t7))));
    out[1] = sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17),
        sfp_sub(sfp_sub(sfp_add(sfp_neg(sfp_mul(sfp_mul(A2, M4), t8)), sfp_mul(sfp_mul(sfp_mul(jump_1, t10), t9),
        u_cr2)), sfp_times(5.0, t6)), t7));
    out[2] = sfp_neg(sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17),
        sfp_add(sfp_add(sfp_add(sfp_add(sfp_mul(A, t11), sfp_times(20.0, sfp_mul(A3, t5))), sfp_mul(t0, t14)),
        sfp_times(2.0, sfp_mul(t12, t15))), sfp_mul(t15, t17))));
    out[3] = sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17),
        sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_sub(sfp_neg(sfp_times(60.0, sfp_mul(A2, t5))), t11),
        sfp_mul(sfp_mul(t12, t13), t9)), sfp_mul(sfp_mul(t13, t17), t9)), sfp_mul(t14, sfp_add(sfp_times(2.0, t9),
        sfp_div(sfp_point(3.0), root2)))), sfp_times(3.0, sfp_mul(t17, t20))), sfp_times(6.0, sfp_mul(t18, t19))),
        sfp_times(2.0, sfp_mul(sfp_mul(t20, u_cr5), sfp_add(sfp_times(10.0, t16), t8)))));
    out[4] = sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17), sfp_sub(sfp_add(sfp_times(2.0,
        sfp_mul(A3, t4)), sfp_times(4.0, sfp_mul(A5, t5))), sfp_mul(t0, t19)));
}

TWOFOLD_INLINE void rod_spring_pairs_known(int passed, sf_pair A, sf_pair beyond, const sf_pair *p, sf_pair *out)
{
    const sf_pair u_cr = p[3];
    if (passed == 0)
        rod_spring_pairs_known_passed_0(A, beyond, p, out);
    else if (passed == 1 && A.high > 64.0 * u_cr.high)
        rod_spring_pairs_known_passed_1_far_1(A, beyond, p, out);
    else
        rod_spring_pairs_known_passed_1(A, beyond, p, out);
}

SF_FAMILY_END

#endif
