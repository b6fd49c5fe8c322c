/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: on whole intervals.

   Written by `make derive` from derivations/mechanisms/rod_spring.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of rod_spring.h.
   passed: how many breakpoints the amplitude exceeds; beyond: by how much it exceeds the last of these. */

#ifndef ROD_SPRING_INTERVALS_H
#define ROD_SPRING_INTERVALS_H

#include "interval.h"
#include "inline.h"

SF_FAMILY_BEGIN

/* The |u| at which a piece of the force ends. */
static inline void rod_spring_intervals_breakpoints(const sf_interval *p, sf_interval *out)
{
    const sf_interval u_cr = p[3];
    out[0] = u_cr;
}

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
static inline void rod_spring_intervals_given(sf_interval lam, sf_interval r, sf_interval delta_h, sf_interval *out)
{
    const sf_interval u_cr = sfi_mul(sfi_sqrt(delta_h), sfi_sqrt(sfi_sub(sfi_point(2.0), delta_h)));
    const sf_interval t0 = sfi_mul(lam, r);
    const sf_interval t1 = sfi_mul(t0, sfi_sub(delta_h, sfi_point(1.0)));
    const sf_interval delta_h2 = sfi_square(delta_h);
    const sf_interval delta_h3 = sfi_mul(delta_h, delta_h2);
    out[0] = sfi_add(sfi_neg(sfi_mul(delta_h, t0)), sfi_point(1.0));
    out[1] = sfi_neg(sfi_times(0.5, t1));
    out[2] = sfi_neg(sfi_times(0.375, t1));
    out[3] = u_cr;
    out[4] = sfi_neg(sfi_times(0.125, sfi_mul(sfi_mul(sfi_mul(delta_h3, t0), u_cr),
        sfi_add(sfi_add(sfi_neg(sfi_times(15.0, delta_h)), sfi_times(3.0, delta_h2)), sfi_point(20.0)))));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_intervals_known_passed_0(sf_interval A, sf_interval beyond, const sf_interval *p, sf_interval *out)
{
    const sf_interval alpha = p[0], beta = p[1], gamma = p[2];
    const sf_interval t0 = sfi_neg(alpha);
    const sf_interval A2 = sfi_square(A);
    const sf_interval t1 = sfi_mul(A2, gamma);
    const sf_interval t2 = sfi_times(4.5, beta);
    const sf_interval A3 = sfi_mul(A, A2);
    out[0] = sfi_mul(A, sfi_add(sfi_mul(A2, sfi_sub(sfi_neg(sfi_times(0.75, beta)), sfi_times(0.625, t1))), t0));
    out[1] = sfi_add(sfi_mul(A2, sfi_sub(sfi_neg(sfi_times(2.25, beta)), sfi_times(3.125, t1))), t0);
    out[2] = sfi_mul(A, sfi_sub(sfi_neg(sfi_times(12.5, t1)), t2));
    out[3] = sfi_sub(sfi_neg(sfi_times(37.5, t1)), t2);
    out[4] = sfi_mul(A3, sfi_add(sfi_times(1.5, beta), sfi_times(2.5, t1)));
}

static inline void rod_spring_intervals_known_passed_1(sf_interval A, sf_interval beyond, const sf_interval *p, sf_interval *out)
{
    const sf_interval alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3], jump_1 = p[4];
    const sf_interval root = sfi_mul(sfi_sqrt(beyond), sfi_sqrt(sfi_add(A, u_cr)));
    const sf_interval t0 = sfi_inverse(A);
    const sf_interval x = sfi_mul(t0, u_cr);
    const sf_interval y = sfi_mul(root, t0);
    const sf_interval psi_0 = sfi_atan2(root, u_cr);
    const sf_interval theta = sfi_atan2(u_cr, root);
    const sf_interval t1 = sfi_mul(x, y);
    const sf_interval t2 = sfi_times(0.5, t1);
    const sf_interval M2 = sfi_add(sfi_neg(t2), sfi_times(0.5, theta));
    const sf_interval t3 = sfi_square(x);
    const sf_interval M4 = sfi_add(sfi_neg(sfi_mul(t1, sfi_add(sfi_times(0.25, t3), sfi_point(0.375)))), sfi_times(0.375,
        theta));
    const sf_interval M6 = sfi_add(sfi_neg(sfi_mul(t1, sfi_add(sfi_mul(t3,
        sfi_add(sfi_mul(sfi_around(0.16666666666666666), t3), sfi_around(0.20833333333333334))),
        sfi_point(0.3125)))), sfi_times(0.3125, theta));
    const sf_interval S2_2 = sfi_add(sfi_times(0.5, psi_0), t2);
    const sf_interval A2 = sfi_square(A);
    const sf_interval t4 = sfi_mul(M4, beta);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval t5 = sfi_mul(M6, gamma);
    const sf_interval t6 = sfi_mul(A4, t5);
    const sf_interval t7 = sfi_add(sfi_mul(M2, alpha), S2_2);
    const sf_interval t8 = sfi_times(3.0, beta);
    const sf_interval t9 = sfi_inverse(A2);
    const sf_interval t10 = sfi_inverse(root);
    const sf_interval u_cr2 = sfi_square(u_cr);
    const sf_interval t11 = sfi_times(6.0, t4);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval t12 = sfi_mul(jump_1, u_cr2);
    const sf_interval root2 = sfi_square(root);
    const sf_interval root3 = sfi_mul(root, root2);
    const sf_interval t13 = sfi_inverse(root3);
    const sf_interval t14 = sfi_mul(t12, t13);
    const sf_interval t15 = sfi_div(t10, A3);
    const sf_interval t16 = sfi_mul(gamma, u_cr2);
    const sf_interval u_cr3 = sfi_mul(u_cr, u_cr2);
    const sf_interval t17 = sfi_mul(u_cr3, sfi_add(sfi_sub(sfi_neg(alpha), sfi_mul(u_cr2, sfi_add(sfi_times(5.0, t16),
        t8))), sfi_point(1.0)));
    const sf_interval t18 = sfi_inverse(A4);
    const sf_interval t19 = sfi_mul(t10, t12);
    const sf_interval t20 = sfi_mul(t10, t18);
    const sf_interval u_cr4 = sfi_square(u_cr2);
    const sf_interval u_cr5 = sfi_mul(u_cr, u_cr4);
    const sf_interval A5 = sfi_mul(A, A4);
    out[0] = sfi_neg(sfi_mul(sfi_around(1.2732395447351628), sfi_mul(A, sfi_add(sfi_add(sfi_mul(A2, t4), t6),
        t7))));
    out[1] = sfi_mul(sfi_around(1.2732395447351628), sfi_sub(sfi_sub(sfi_add(sfi_neg(sfi_mul(sfi_mul(A2, M4),
        t8)), sfi_mul(sfi_mul(sfi_mul(jump_1, t10), t9), u_cr2)), sfi_times(5.0, t6)), t7));
    out[2] = sfi_neg(sfi_mul(sfi_around(1.2732395447351628), sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A, t11),
        sfi_times(20.0, sfi_mul(A3, t5))), sfi_mul(t0, t14)), sfi_times(2.0, sfi_mul(t12, t15))), sfi_mul(t15,
        t17))));
    out[3] = sfi_mul(sfi_around(1.2732395447351628),
        sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_sub(sfi_neg(sfi_times(60.0, sfi_mul(A2, t5))), t11),
        sfi_mul(sfi_mul(t12, t13), t9)), sfi_mul(sfi_mul(t13, t17), t9)), sfi_mul(t14, sfi_add(sfi_times(2.0, t9),
        sfi_div(sfi_point(3.0), root2)))), sfi_times(3.0, sfi_mul(t17, t20))), sfi_times(6.0, sfi_mul(t18, t19))),
        sfi_times(2.0, sfi_mul(sfi_mul(t20, u_cr5), sfi_add(sfi_times(10.0, t16), t8)))));
    out[4] = sfi_mul(sfi_around(1.2732395447351628), sfi_sub(sfi_add(sfi_times(2.0, sfi_mul(A3, t4)),
        sfi_times(4.0, sfi_mul(A5, t5))), sfi_mul(t0, t19)));
}

static inline void rod_spring_intervals_known_passed_1_far_1(sf_interval A, sf_interval beyond, const sf_interval *p, sf_interval *out)
{
    const sf_interval alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3], jump_1 = p[4];
    const sf_interval root = sfi_mul(sfi_sqrt(beyond), sfi_sqrt(sfi_add(A, u_cr)));
    const sf_interval t0 = sfi_inverse(A);
    const sf_interval x = sfi_mul(t0, u_cr);
    const sf_interval y = sfi_mul(root, t0);
    const sf_interval s = sfi_div(x, sfi_sqrt(sfi_add(sfi_times(2.0, y), sfi_point(2.0))));
    const sf_interval s2 = sfi_square(s);
    const sf_interval s4 = sfi_square(s2);
    const sf_interval s3 = sfi_mul(s, s2);
    const sf_interval s6 = sfi_square(s3);
    const sf_interval s7 = sfi_mul(s, s6);
    const sf_interval M6 = sfi_within(sfi_mul(s7, sfi_add(sfi_add(sfi_mul(s2, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4,
        sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4,
        sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4,
        sfi_sub(sfi_neg(sfi_mul(sfi_around(3.6492503041747691e-05), s4)), sfi_around(5.3427095924732542e-05))),
        sfi_around(8.10560684803189e-05))), sfi_around(0.00012837971250216165))),
        sfi_around(0.00021441317186122989))), sfi_around(0.00038296467549092059))),
        sfi_around(0.000746755888967803))), sfi_around(0.0016416352370689656))),
        sfi_around(0.0042968750000000003))), sfi_around(0.01488095238095238))), sfi_around(0.088235294117647065))),
        sfi_around(3.0769230769230771))), sfi_around(35.555555555555557))), sfi_mul(s4, sfi_add(sfi_mul(s4,
        sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4,
        sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4, sfi_sub(sfi_mul(s4,
        sfi_sub(sfi_neg(sfi_mul(sfi_around(4.3976166456228718e-05), s4)), sfi_around(6.5487812903216656e-05))),
        sfi_around(0.00010140631546048408))), sfi_around(0.00016468815332235291))),
        sfi_around(0.00028384801668998523))), sfi_around(0.00052806309291294638))),
        sfi_around(0.0010878039944556453))), sfi_around(0.0025860821759259261))),
        sfi_around(0.007642663043478261))), sfi_around(0.032894736842105261))), sfi_around(0.33333333333333331))),
        sfi_around(21.818181818181817)))), sfi_around(18.285714285714285))), 8.6736173798840355e-18);
    const sf_interval x2 = sfi_square(x);
    const sf_interval x4 = sfi_square(x2);
    const sf_interval x5 = sfi_mul(x, x4);
    const sf_interval M4 = sfi_add(sfi_mul(sfi_around(1.2), M6), sfi_mul(sfi_around(0.20000000000000001), sfi_mul(x5,
        y)));
    const sf_interval x3 = sfi_mul(x, x2);
    const sf_interval M2 = sfi_add(sfi_mul(sfi_around(1.3333333333333333), M4), sfi_mul(sfi_around(0.33333333333333331),
        sfi_mul(x3, y)));
    const sf_interval S2_2 = sfi_add(sfi_neg(M2), sfi_around(0.78539816339744828));
    const sf_interval A2 = sfi_square(A);
    const sf_interval t1 = sfi_mul(M4, beta);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval t2 = sfi_mul(M6, gamma);
    const sf_interval t3 = sfi_mul(A4, t2);
    const sf_interval t4 = sfi_add(sfi_mul(M2, alpha), S2_2);
    const sf_interval t5 = sfi_times(3.0, beta);
    const sf_interval t6 = sfi_inverse(A2);
    const sf_interval t7 = sfi_inverse(root);
    const sf_interval u_cr2 = sfi_square(u_cr);
    const sf_interval t8 = sfi_times(6.0, t1);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval t9 = sfi_mul(jump_1, u_cr2);
    const sf_interval root2 = sfi_square(root);
    const sf_interval root3 = sfi_mul(root, root2);
    const sf_interval t10 = sfi_inverse(root3);
    const sf_interval t11 = sfi_mul(t10, t9);
    const sf_interval t12 = sfi_div(t7, A3);
    const sf_interval t13 = sfi_mul(gamma, u_cr2);
    const sf_interval u_cr3 = sfi_mul(u_cr, u_cr2);
    const sf_interval t14 = sfi_mul(u_cr3, sfi_add(sfi_sub(sfi_neg(alpha), sfi_mul(u_cr2, sfi_add(sfi_times(5.0, t13),
        t5))), sfi_point(1.0)));
    const sf_interval t15 = sfi_inverse(A4);
    const sf_interval t16 = sfi_mul(t7, t9);
    const sf_interval t17 = sfi_mul(t15, t7);
    const sf_interval u_cr4 = sfi_square(u_cr2);
    const sf_interval u_cr5 = sfi_mul(u_cr, u_cr4);
    const sf_interval A5 = sfi_mul(A, A4);
    out[0] = sfi_neg(sfi_mul(sfi_around(1.2732395447351628), sfi_mul(A, sfi_add(sfi_add(sfi_mul(A2, t1), t3),
        t4))));
    out[1] = sfi_mul(sfi_around(1.2732395447351628), sfi_sub(sfi_sub(sfi_add(sfi_neg(sfi_mul(sfi_mul(A2, M4),
        t5)), sfi_mul(sfi_mul(sfi_mul(jump_1, t6), t7), u_cr2)), sfi_times(5.0, t3)), t4));
    out[2] = sfi_neg(sfi_mul(sfi_around(1.2732395447351628), sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A, t8),
        sfi_times(20.0, sfi_mul(A3, t2))), sfi_mul(t0, t11)), sfi_mul(t12, t14)), sfi_times(2.0, sfi_mul(t12,
        t9)))));
    out[3] = sfi_mul(sfi_around(1.2732395447351628),
        sfi_sub(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_neg(sfi_times(60.0, sfi_mul(A2, t2))),
        sfi_mul(sfi_mul(t10, t14), t6)), sfi_mul(sfi_mul(t10, t6), t9)), sfi_mul(t11, sfi_add(sfi_times(2.0, t6),
        sfi_div(sfi_point(3.0), root2)))), sfi_times(3.0, sfi_mul(t14, t17))), sfi_times(6.0, sfi_mul(t15, t16))),
        sfi_times(2.0, sfi_mul(sfi_mul(t17, u_cr5), sfi_add(sfi_times(10.0, t13), t5)))), t8));
    out[4] = sfi_mul(sfi_around(1.2732395447351628), sfi_sub(sfi_add(sfi_times(2.0, sfi_mul(A3, t1)),
        sfi_times(4.0, sfi_mul(A5, t2))), sfi_mul(t0, t16)));
}

static inline void rod_spring_intervals_known(int passed, sf_interval A, sf_interval beyond, const sf_interval *p, sf_interval *out)
{
    const sf_interval u_cr = p[3];
    if (passed == 0)
        rod_spring_intervals_known_passed_0(A, beyond, p, out);
    else if (passed == 1 && A.lo <= sfi_mul(sfi_around(1.05), u_cr).hi)
        rod_spring_intervals_known_passed_1(A, beyond, p, out);
    else
        rod_spring_intervals_known_passed_1_far_1(A, beyond, p, out);
}

SF_FAMILY_END

#endif
