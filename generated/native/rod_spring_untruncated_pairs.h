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

/* Steps of the arithmetic-geometric mean, with the sum of its differences and that of their squares by weight. */
SF_COMMON void rod_spring_untruncated_pairs_means(sf_pair quarter, int turns, sf_pair *state)
{
    SF_UNROLLED
    for (int turn = 0; turn < turns; turn++) {
        const sf_pair a = state[0], b = state[1], e = state[2], total = state[3], squares = state[4];
        const sf_pair mean = sfp_add(sfp_times(0.5, a), sfp_times(0.5, b));
        const sf_pair difference = sfp_div(sfp_mul(sfp_square(e), quarter), mean);
        state[0] = mean;
        state[1] = sfp_mul(sfp_sqrt(a), sfp_sqrt(b));
        state[2] = difference;
        state[3] = sfp_add(difference, total);
        state[4] = sfp_add(sfp_square(difference), sfp_times(0.5, squares));
    }
}

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
    const sf_pair square = sfp_square(e_1);
    const sf_pair quarter = sfp_times(0.25, m);
    sf_pair means[] = {a_1, b_1, e_1, e_1, square};
    rod_spring_untruncated_pairs_means(quarter, 3, means);
    const sf_pair a_4 = means[0], b_4 = means[1], e_4 = means[2], total = means[3], squares = means[4];
    const sf_pair a_5 = sfp_add(sfp_times(0.5, a_4), sfp_times(0.5, b_4));
    const sf_pair t2 = sfp_inverse(a_5);
    const sf_pair e_5 = sfp_mul(sfp_mul(sfp_square(e_4), quarter), t2);
    const sf_pair e = sfp_add(e_5, total);
    const sf_pair tau = sfp_add(sfp_times(32.0, sfp_square(e_5)), sfp_times(16.0, squares));
    const sf_pair P = sfp_mul(sfp_mul(m, t2), sfp_add(e, tau));
    const sf_pair B = sfp_mul(t2, sfp_add(sfp_neg(sfp_mul(m, tau)), sfp_point(1.0)));
    const sf_pair C = sfp_times(2.0, sfp_mul(t2, tau));
    const sf_pair t3 = sfp_times(2.0, beta);
    const sf_pair t4 = sfp_mul(A, t3);
    const sf_pair t5 = sfp_inverse(k);
    const sf_pair t6 = sfp_mul(B, t5);
    const sf_pair k2 = sfp_square(k);
    const sf_pair t7 = sfp_inverse(k2);
    const sf_pair k3 = sfp_mul(k, k2);
    out[0] = sfp_sub(sfp_neg(sfp_mul(A, alpha)), sfp_mul(P, t4));
    out[1] = sfp_sub(sfp_neg(alpha), sfp_mul(t3, sfp_add(sfp_add(sfp_neg(sfp_mul(C, m)), P), sfp_mul(m, t6))));
    out[2] = sfp_neg(sfp_mul(t4, sfp_add(sfp_times(2.0, sfp_mul(B, t7)), sfp_mul(C, t5))));
    out[3] = sfp_neg(sfp_mul(t3, sfp_add(sfp_div(sfp_mul(B, sfp_add(sfp_times(5.0, m), sfp_point(3.0))), k3),
        sfp_mul(sfp_mul(C, t7), sfp_sub(sfp_times(7.0, m), sfp_point(3.0))))));
    out[4] = sfp_times(4.0, sfp_mul(sfp_mul(sfp_mul(A, beta), m), sfp_add(sfp_neg(sfp_times(0.5, C)),
        sfp_times(0.5, t6))));
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
    const sf_pair square = sfp_square(e_1);
    const sf_pair quarter = sfp_times(0.25, m);
    sf_pair means[] = {a_1, b_1, e_1, e_1, square};
    rod_spring_untruncated_pairs_means(quarter, 8, means);
    const sf_pair a_9 = means[0], b_9 = means[1], e_9 = means[2], total = means[3], squares = means[4];
    const sf_pair a_10 = sfp_add(sfp_times(0.5, a_9), sfp_times(0.5, b_9));
    const sf_pair t2 = sfp_inverse(a_10);
    const sf_pair e_10 = sfp_mul(sfp_mul(sfp_square(e_9), quarter), t2);
    const sf_pair e = sfp_add(e_10, total);
    const sf_pair tau = sfp_add(sfp_times(1024.0, sfp_square(e_10)), sfp_times(512.0, squares));
    const sf_pair P = sfp_mul(sfp_mul(m, t2), sfp_add(e, tau));
    const sf_pair B = sfp_mul(t2, sfp_add(sfp_neg(sfp_mul(m, tau)), sfp_point(1.0)));
    const sf_pair C = sfp_times(2.0, sfp_mul(t2, tau));
    const sf_pair t3 = sfp_times(2.0, beta);
    const sf_pair t4 = sfp_mul(A, t3);
    const sf_pair t5 = sfp_inverse(k);
    const sf_pair t6 = sfp_mul(B, t5);
    const sf_pair k2 = sfp_square(k);
    const sf_pair t7 = sfp_inverse(k2);
    const sf_pair k3 = sfp_mul(k, k2);
    out[0] = sfp_sub(sfp_neg(sfp_mul(A, alpha)), sfp_mul(P, t4));
    out[1] = sfp_sub(sfp_neg(alpha), sfp_mul(t3, sfp_add(sfp_add(sfp_neg(sfp_mul(C, m)), P), sfp_mul(m, t6))));
    out[2] = sfp_neg(sfp_mul(t4, sfp_add(sfp_times(2.0, sfp_mul(B, t7)), sfp_mul(C, t5))));
    out[3] = sfp_neg(sfp_mul(t3, sfp_add(sfp_div(sfp_mul(B, sfp_add(sfp_times(5.0, m), sfp_point(3.0))), k3),
        sfp_mul(sfp_mul(C, t7), sfp_sub(sfp_times(7.0, m), sfp_point(3.0))))));
    out[4] = sfp_times(4.0, sfp_mul(sfp_mul(sfp_mul(A, beta), m), sfp_add(sfp_neg(sfp_times(0.5, C)),
        sfp_times(0.5, t6))));
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
