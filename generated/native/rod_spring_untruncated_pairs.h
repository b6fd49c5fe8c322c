/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: in double-double.

   Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
   never edit.

   `out` takes the outputs, where there are several.
   Equations and domains that are not stated here are those of rod_spring_untruncated.h. */

#ifndef ROD_SPRING_UNTRUNCATED_PAIRS_H
#define ROD_SPRING_UNTRUNCATED_PAIRS_H

#include "pair_angles.h"
#include "inline.h"

SF_FAMILY_BEGIN

/* The |u| at which a piece of the force ends. */
static inline void rod_spring_untruncated_pairs_breakpoints(const sf_pair *p, sf_pair *out)
{
    const sf_pair delta_h = p[2];
    out[0] = sfp_sqrt(sfp_add(sfp_neg(sfp_square(delta_h)), sfp_times(2.0, delta_h)));
}

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
static inline void rod_spring_untruncated_pairs_given(sf_pair lam, sf_pair r, sf_pair delta_h, sf_pair *out)
{
    const sf_pair t0 = sfp_mul(lam, r);
    out[0] = sfp_add(sfp_neg(sfp_mul(delta_h, t0)), sfp_point(1.0));
    out[1] = sfp_neg(sfp_times(0.5, sfp_mul(t0, sfp_sub(delta_h, sfp_point(1.0)))));
    out[2] = delta_h;
    out[3] = sfp_point(0.0);
}

/* What the slope of the force loses at each breakpoint.
   Equation (5). Domain: any parameters. */
static inline void rod_spring_untruncated_pairs_kinks(const sf_pair *p, sf_pair *out)
{
    const sf_pair alpha = p[0], beta = p[1], delta_h = p[2];
    const sf_pair u_cr = sfp_sqrt(sfp_add(sfp_neg(sfp_square(delta_h)), sfp_times(2.0, delta_h)));
    const sf_pair c = sfp_sub(sfp_point(1.0), delta_h);
    const sf_pair t0 = sfp_times(2.0, beta);
    const sf_pair c2 = sfp_square(c);
    const sf_pair c3 = sfp_mul(c, c2);
    out[0] = sfp_add(sfp_add(sfp_sub(sfp_sub(alpha, t0), sfp_point(1.0)), sfp_div(sfp_mul(t0, sfp_square(u_cr)),
        c3)), sfp_div(t0, c));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together. Where A does not exceed the breakpoint, nor 7/10.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_pairs_attached(sf_pair A, const sf_pair *p, sf_pair *out)
{
    const sf_pair alpha = p[0], beta = p[1];
    const sf_pair m = sfp_square(A);
    const sf_pair t0 = sfp_add(A, sfp_point(1.0));
    const sf_pair t1 = sfp_sub(sfp_point(1.0), A);
    const sf_pair k_c = sfp_mul(sfp_sqrt(t0), sfp_sqrt(t1));
    const sf_pair k = sfp_mul(t0, t1);
    const sf_pair a_1 = sfp_add(sfp_times(0.5, k_c), sfp_point(0.5));
    const sf_pair b_1 = sfp_sqrt(k_c);
    const sf_pair e_1 = sfp_div(sfp_point(0.25), a_1);
    const sf_pair a_2 = sfp_add(sfp_times(0.5, a_1), sfp_times(0.5, b_1));
    const sf_pair b_2 = sfp_mul(sfp_sqrt(a_1), sfp_sqrt(b_1));
    const sf_pair t2 = sfp_square(e_1);
    const sf_pair t3 = sfp_times(0.25, m);
    const sf_pair e_2 = sfp_div(sfp_mul(t2, t3), a_2);
    const sf_pair a_3 = sfp_add(sfp_times(0.5, a_2), sfp_times(0.5, b_2));
    const sf_pair b_3 = sfp_mul(sfp_sqrt(a_2), sfp_sqrt(b_2));
    const sf_pair t4 = sfp_square(e_2);
    const sf_pair e_3 = sfp_div(sfp_mul(t3, t4), a_3);
    const sf_pair a_4 = sfp_add(sfp_times(0.5, a_3), sfp_times(0.5, b_3));
    const sf_pair b_4 = sfp_mul(sfp_sqrt(a_3), sfp_sqrt(b_3));
    const sf_pair t5 = sfp_square(e_3);
    const sf_pair e_4 = sfp_div(sfp_mul(t3, t5), a_4);
    const sf_pair a_5 = sfp_add(sfp_times(0.5, a_4), sfp_times(0.5, b_4));
    const sf_pair t6 = sfp_square(e_4);
    const sf_pair t7 = sfp_inverse(a_5);
    const sf_pair t8 = sfp_mul(m, t7);
    const sf_pair e_5 = sfp_times(0.25, sfp_mul(t6, t8));
    const sf_pair e = sfp_add(sfp_add(sfp_add(sfp_add(e_1, e_2), e_3), e_4), e_5);
    const sf_pair tau = sfp_add(sfp_add(sfp_add(sfp_add(sfp_times(32.0, sfp_square(e_5)), sfp_times(2.0, t2)),
        sfp_times(4.0, t4)), sfp_times(8.0, t5)), sfp_times(16.0, t6));
    const sf_pair P = sfp_mul(t8, sfp_add(e, tau));
    const sf_pair B = sfp_mul(t7, sfp_add(sfp_neg(sfp_mul(m, tau)), sfp_point(1.0)));
    const sf_pair C = sfp_times(2.0, sfp_mul(t7, tau));
    const sf_pair t9 = sfp_times(2.0, beta);
    const sf_pair t10 = sfp_mul(A, t9);
    const sf_pair t11 = sfp_inverse(k);
    const sf_pair t12 = sfp_mul(B, t11);
    const sf_pair k2 = sfp_square(k);
    const sf_pair t13 = sfp_inverse(k2);
    const sf_pair k3 = sfp_mul(k, k2);
    out[0] = sfp_sub(sfp_neg(sfp_mul(A, alpha)), sfp_mul(P, t10));
    out[1] = sfp_sub(sfp_neg(alpha), sfp_mul(t9, sfp_add(sfp_add(sfp_neg(sfp_mul(C, m)), P), sfp_mul(m, t12))));
    out[2] = sfp_neg(sfp_mul(t10, sfp_add(sfp_times(2.0, sfp_mul(B, t13)), sfp_mul(C, t11))));
    out[3] = sfp_neg(sfp_mul(t9, sfp_add(sfp_div(sfp_mul(B, sfp_add(sfp_times(5.0, m), sfp_point(3.0))), k3),
        sfp_mul(sfp_mul(C, t13), sfp_sub(sfp_times(7.0, m), sfp_point(3.0))))));
    out[4] = sfp_times(4.0, sfp_mul(sfp_mul(sfp_mul(A, beta), m), sfp_add(sfp_neg(sfp_times(0.5, C)),
        sfp_times(0.5, t12))));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together. Where A does not exceed the breakpoint.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_pairs_attached_steep(sf_pair A, const sf_pair *p, sf_pair *out)
{
    const sf_pair alpha = p[0], beta = p[1];
    const sf_pair m = sfp_square(A);
    const sf_pair t0 = sfp_add(A, sfp_point(1.0));
    const sf_pair t1 = sfp_sub(sfp_point(1.0), A);
    const sf_pair k_c = sfp_mul(sfp_sqrt(t0), sfp_sqrt(t1));
    const sf_pair k = sfp_mul(t0, t1);
    const sf_pair a_1 = sfp_add(sfp_times(0.5, k_c), sfp_point(0.5));
    const sf_pair b_1 = sfp_sqrt(k_c);
    const sf_pair e_1 = sfp_div(sfp_point(0.25), a_1);
    const sf_pair a_2 = sfp_add(sfp_times(0.5, a_1), sfp_times(0.5, b_1));
    const sf_pair b_2 = sfp_mul(sfp_sqrt(a_1), sfp_sqrt(b_1));
    const sf_pair t2 = sfp_square(e_1);
    const sf_pair t3 = sfp_times(0.25, m);
    const sf_pair e_2 = sfp_div(sfp_mul(t2, t3), a_2);
    const sf_pair a_3 = sfp_add(sfp_times(0.5, a_2), sfp_times(0.5, b_2));
    const sf_pair b_3 = sfp_mul(sfp_sqrt(a_2), sfp_sqrt(b_2));
    const sf_pair t4 = sfp_square(e_2);
    const sf_pair e_3 = sfp_div(sfp_mul(t3, t4), a_3);
    const sf_pair a_4 = sfp_add(sfp_times(0.5, a_3), sfp_times(0.5, b_3));
    const sf_pair b_4 = sfp_mul(sfp_sqrt(a_3), sfp_sqrt(b_3));
    const sf_pair t5 = sfp_square(e_3);
    const sf_pair e_4 = sfp_div(sfp_mul(t3, t5), a_4);
    const sf_pair a_5 = sfp_add(sfp_times(0.5, a_4), sfp_times(0.5, b_4));
    const sf_pair b_5 = sfp_mul(sfp_sqrt(a_4), sfp_sqrt(b_4));
    const sf_pair t6 = sfp_square(e_4);
    const sf_pair e_5 = sfp_div(sfp_mul(t3, t6), a_5);
    const sf_pair a_6 = sfp_add(sfp_times(0.5, a_5), sfp_times(0.5, b_5));
    const sf_pair b_6 = sfp_mul(sfp_sqrt(a_5), sfp_sqrt(b_5));
    const sf_pair t7 = sfp_square(e_5);
    const sf_pair e_6 = sfp_div(sfp_mul(t3, t7), a_6);
    const sf_pair a_7 = sfp_add(sfp_times(0.5, a_6), sfp_times(0.5, b_6));
    const sf_pair b_7 = sfp_mul(sfp_sqrt(a_6), sfp_sqrt(b_6));
    const sf_pair t8 = sfp_square(e_6);
    const sf_pair e_7 = sfp_div(sfp_mul(t3, t8), a_7);
    const sf_pair a_8 = sfp_add(sfp_times(0.5, a_7), sfp_times(0.5, b_7));
    const sf_pair b_8 = sfp_mul(sfp_sqrt(a_7), sfp_sqrt(b_7));
    const sf_pair t9 = sfp_square(e_7);
    const sf_pair e_8 = sfp_div(sfp_mul(t3, t9), a_8);
    const sf_pair a_9 = sfp_add(sfp_times(0.5, a_8), sfp_times(0.5, b_8));
    const sf_pair b_9 = sfp_mul(sfp_sqrt(a_8), sfp_sqrt(b_8));
    const sf_pair t10 = sfp_square(e_8);
    const sf_pair e_9 = sfp_div(sfp_mul(t10, t3), a_9);
    const sf_pair a_10 = sfp_add(sfp_times(0.5, a_9), sfp_times(0.5, b_9));
    const sf_pair t11 = sfp_square(e_9);
    const sf_pair t12 = sfp_inverse(a_10);
    const sf_pair t13 = sfp_mul(m, t12);
    const sf_pair e_10 = sfp_times(0.25, sfp_mul(t11, t13));
    const sf_pair e = sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(e_1, e_10), e_2), e_3),
        e_4), e_5), e_6), e_7), e_8), e_9);
    const sf_pair tau = sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_add(sfp_times(1024.0,
        sfp_square(e_10)), sfp_times(256.0, t10)), sfp_times(512.0, t11)), sfp_times(2.0, t2)), sfp_times(4.0, t4)),
        sfp_times(8.0, t5)), sfp_times(16.0, t6)), sfp_times(32.0, t7)), sfp_times(64.0, t8)), sfp_times(128.0, t9));
    const sf_pair P = sfp_mul(t13, sfp_add(e, tau));
    const sf_pair B = sfp_mul(t12, sfp_add(sfp_neg(sfp_mul(m, tau)), sfp_point(1.0)));
    const sf_pair C = sfp_times(2.0, sfp_mul(t12, tau));
    const sf_pair t14 = sfp_times(2.0, beta);
    const sf_pair t15 = sfp_mul(A, t14);
    const sf_pair t16 = sfp_inverse(k);
    const sf_pair t17 = sfp_mul(B, t16);
    const sf_pair k2 = sfp_square(k);
    const sf_pair t18 = sfp_inverse(k2);
    const sf_pair k3 = sfp_mul(k, k2);
    out[0] = sfp_sub(sfp_neg(sfp_mul(A, alpha)), sfp_mul(P, t15));
    out[1] = sfp_sub(sfp_neg(alpha), sfp_mul(t14, sfp_add(sfp_add(sfp_neg(sfp_mul(C, m)), P), sfp_mul(m, t17))));
    out[2] = sfp_neg(sfp_mul(t15, sfp_add(sfp_times(2.0, sfp_mul(B, t18)), sfp_mul(C, t16))));
    out[3] = sfp_neg(sfp_mul(t14, sfp_add(sfp_div(sfp_mul(B, sfp_add(sfp_times(5.0, m), sfp_point(3.0))), k3),
        sfp_mul(sfp_mul(C, t18), sfp_sub(sfp_times(7.0, m), sfp_point(3.0))))));
    out[4] = sfp_times(4.0, sfp_mul(sfp_mul(sfp_mul(A, beta), m), sfp_add(sfp_neg(sfp_times(0.5, C)),
        sfp_times(0.5, t17))));
}

/* The same where it does, from the parts.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_pairs_detached(sf_pair A, sf_pair part_0, sf_pair part_1, sf_pair part_2, sf_pair part_3, sf_pair part_4, const sf_pair *p, sf_pair *out)
{
    const sf_pair beta = p[1];
    const sf_pair t0 = sfp_times(2.0, beta);
    out[0] = sfp_add(sfp_neg(A), sfp_times(2.0, sfp_mul(beta, part_0)));
    out[1] = sfp_sub(sfp_mul(part_1, t0), sfp_point(1.0));
    out[2] = sfp_mul(part_2, t0);
    out[3] = sfp_mul(part_3, t0);
    out[4] = sfp_mul(part_4, t0);
}

SF_FAMILY_END

#endif
