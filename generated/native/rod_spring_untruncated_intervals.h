/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: on whole intervals.

   Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
   never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of rod_spring_untruncated.h. */

#ifndef ROD_SPRING_UNTRUNCATED_INTERVALS_H
#define ROD_SPRING_UNTRUNCATED_INTERVALS_H

#include "interval.h"
#include "inline.h"

SF_FAMILY_BEGIN

/* Steps of the arithmetic-geometric mean, with the sum of its differences and that of their squares by weight. */
SF_COMMON void rod_spring_untruncated_intervals_means(sf_interval quarter, int turns, sf_interval *state)
{
    SF_UNROLLED
    for (int turn = 0; turn < turns; turn++) {
        const sf_interval a = state[0], b = state[1], e = state[2], total = state[3], squares = state[4];
        const sf_interval mean = sfi_add(sfi_times(0.5, a), sfi_times(0.5, b));
        const sf_interval difference = sfi_div(sfi_mul(sfi_square(e), quarter), mean);
        state[0] = mean;
        state[1] = sfi_mul(sfi_sqrt(a), sfi_sqrt(b));
        state[2] = difference;
        state[3] = sfi_add(difference, total);
        state[4] = sfi_add(sfi_square(difference), sfi_times(0.5, squares));
    }
}

/* The |u| at which a piece of the force ends. */
static inline void rod_spring_untruncated_intervals_breakpoints(const sf_interval *p, sf_interval *out)
{
    const sf_interval delta_h = p[2];
    out[0] = sfi_sqrt(sfi_add(sfi_neg(sfi_square(delta_h)), sfi_times(2.0, delta_h)));
}

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
static inline void rod_spring_untruncated_intervals_given(sf_interval lam, sf_interval r, sf_interval delta_h, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(lam, r);
    out[0] = sfi_add(sfi_neg(sfi_mul(delta_h, t0)), sfi_point(1.0));
    out[1] = sfi_neg(sfi_times(0.5, sfi_mul(t0, sfi_sub(delta_h, sfi_point(1.0)))));
    out[2] = delta_h;
    out[3] = sfi_point(0.0);
}

/* What the slope of the force loses at each breakpoint.
   Equation (5). Domain: any parameters. */
static inline void rod_spring_untruncated_intervals_kinks(const sf_interval *p, sf_interval *out)
{
    const sf_interval alpha = p[0], beta = p[1], delta_h = p[2];
    const sf_interval u_cr = sfi_sqrt(sfi_add(sfi_neg(sfi_square(delta_h)), sfi_times(2.0, delta_h)));
    const sf_interval c = sfi_sub(sfi_point(1.0), delta_h);
    const sf_interval t0 = sfi_times(2.0, beta);
    const sf_interval c2 = sfi_square(c);
    const sf_interval c3 = sfi_mul(c, c2);
    out[0] = sfi_add(sfi_add(sfi_sub(sfi_sub(alpha, t0), sfi_point(1.0)), sfi_div(sfi_mul(t0, sfi_square(u_cr)),
        c3)), sfi_div(t0, c));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together. Where A does not exceed the breakpoint, nor 7/10.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_intervals_attached(sf_interval A, const sf_interval *p, sf_interval *out)
{
    const sf_interval alpha = p[0], beta = p[1];
    const sf_interval m = sfi_square(A);
    const sf_interval t0 = sfi_add(A, sfi_point(1.0));
    const sf_interval t1 = sfi_sub(sfi_point(1.0), A);
    const sf_interval k_c = sfi_mul(sfi_sqrt(t0), sfi_sqrt(t1));
    const sf_interval k = sfi_mul(t0, t1);
    const sf_interval a_1 = sfi_add(sfi_times(0.5, k_c), sfi_point(0.5));
    const sf_interval b_1 = sfi_sqrt(k_c);
    const sf_interval e_1 = sfi_div(sfi_point(0.25), a_1);
    const sf_interval square = sfi_square(e_1);
    const sf_interval quarter = sfi_times(0.25, m);
    sf_interval means[] = {a_1, b_1, e_1, e_1, square};
    rod_spring_untruncated_intervals_means(quarter, 3, means);
    const sf_interval a_4 = means[0], b_4 = means[1], e_4 = means[2], total = means[3], squares = means[4];
    const sf_interval a_5 = sfi_within(sfi_add(sfi_times(0.5, a_4), sfi_times(0.5, b_4)), 8.6736173798840355e-19);
    const sf_interval t2 = sfi_inverse(a_5);
    const sf_interval e_5 = sfi_mul(sfi_mul(sfi_square(e_4), quarter), t2);
    const sf_interval e = sfi_within(sfi_add(e_5, total), 8.6736173798840355e-19);
    const sf_interval tau = sfi_within(sfi_add(sfi_times(32.0, sfi_square(e_5)), sfi_times(16.0, squares)), 8.6736173798840355e-19);
    const sf_interval P = sfi_mul(sfi_mul(m, t2), sfi_add(e, tau));
    const sf_interval B = sfi_mul(t2, sfi_add(sfi_neg(sfi_mul(m, tau)), sfi_point(1.0)));
    const sf_interval C = sfi_times(2.0, sfi_mul(t2, tau));
    const sf_interval t3 = sfi_times(2.0, beta);
    const sf_interval t4 = sfi_mul(A, t3);
    const sf_interval t5 = sfi_inverse(k);
    const sf_interval t6 = sfi_mul(B, t5);
    const sf_interval k2 = sfi_square(k);
    const sf_interval t7 = sfi_inverse(k2);
    const sf_interval k3 = sfi_mul(k, k2);
    out[0] = sfi_sub(sfi_neg(sfi_mul(A, alpha)), sfi_mul(P, t4));
    out[1] = sfi_sub(sfi_neg(alpha), sfi_mul(t3, sfi_add(sfi_add(sfi_neg(sfi_mul(C, m)), P), sfi_mul(m, t6))));
    out[2] = sfi_neg(sfi_mul(t4, sfi_add(sfi_times(2.0, sfi_mul(B, t7)), sfi_mul(C, t5))));
    out[3] = sfi_neg(sfi_mul(t3, sfi_add(sfi_div(sfi_mul(B, sfi_add(sfi_times(5.0, m), sfi_point(3.0))), k3),
        sfi_mul(sfi_mul(C, t7), sfi_sub(sfi_times(7.0, m), sfi_point(3.0))))));
    out[4] = sfi_times(4.0, sfi_mul(sfi_mul(sfi_mul(A, beta), m), sfi_add(sfi_neg(sfi_times(0.5, C)),
        sfi_times(0.5, t6))));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together. Where A does not exceed the breakpoint.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_intervals_attached_steep(sf_interval A, const sf_interval *p, sf_interval *out)
{
    const sf_interval alpha = p[0], beta = p[1];
    const sf_interval m = sfi_square(A);
    const sf_interval t0 = sfi_add(A, sfi_point(1.0));
    const sf_interval t1 = sfi_sub(sfi_point(1.0), A);
    const sf_interval k_c = sfi_mul(sfi_sqrt(t0), sfi_sqrt(t1));
    const sf_interval k = sfi_mul(t0, t1);
    const sf_interval a_1 = sfi_add(sfi_times(0.5, k_c), sfi_point(0.5));
    const sf_interval b_1 = sfi_sqrt(k_c);
    const sf_interval e_1 = sfi_div(sfi_point(0.25), a_1);
    const sf_interval square = sfi_square(e_1);
    const sf_interval quarter = sfi_times(0.25, m);
    sf_interval means[] = {a_1, b_1, e_1, e_1, square};
    rod_spring_untruncated_intervals_means(quarter, 8, means);
    const sf_interval a_9 = means[0], b_9 = means[1], e_9 = means[2], total = means[3], squares = means[4];
    const sf_interval a_10 = sfi_within(sfi_add(sfi_times(0.5, a_9), sfi_times(0.5, b_9)), 8.6736173798840355e-19);
    const sf_interval t2 = sfi_inverse(a_10);
    const sf_interval e_10 = sfi_mul(sfi_mul(sfi_square(e_9), quarter), t2);
    const sf_interval e = sfi_within(sfi_add(e_10, total), 8.6736173798840355e-19);
    const sf_interval tau = sfi_within(sfi_add(sfi_times(1024.0, sfi_square(e_10)), sfi_times(512.0, squares)), 8.6736173798840355e-19);
    const sf_interval P = sfi_mul(sfi_mul(m, t2), sfi_add(e, tau));
    const sf_interval B = sfi_mul(t2, sfi_add(sfi_neg(sfi_mul(m, tau)), sfi_point(1.0)));
    const sf_interval C = sfi_times(2.0, sfi_mul(t2, tau));
    const sf_interval t3 = sfi_times(2.0, beta);
    const sf_interval t4 = sfi_mul(A, t3);
    const sf_interval t5 = sfi_inverse(k);
    const sf_interval t6 = sfi_mul(B, t5);
    const sf_interval k2 = sfi_square(k);
    const sf_interval t7 = sfi_inverse(k2);
    const sf_interval k3 = sfi_mul(k, k2);
    out[0] = sfi_sub(sfi_neg(sfi_mul(A, alpha)), sfi_mul(P, t4));
    out[1] = sfi_sub(sfi_neg(alpha), sfi_mul(t3, sfi_add(sfi_add(sfi_neg(sfi_mul(C, m)), P), sfi_mul(m, t6))));
    out[2] = sfi_neg(sfi_mul(t4, sfi_add(sfi_times(2.0, sfi_mul(B, t7)), sfi_mul(C, t5))));
    out[3] = sfi_neg(sfi_mul(t3, sfi_add(sfi_div(sfi_mul(B, sfi_add(sfi_times(5.0, m), sfi_point(3.0))), k3),
        sfi_mul(sfi_mul(C, t7), sfi_sub(sfi_times(7.0, m), sfi_point(3.0))))));
    out[4] = sfi_times(4.0, sfi_mul(sfi_mul(sfi_mul(A, beta), m), sfi_add(sfi_neg(sfi_times(0.5, C)),
        sfi_times(0.5, t6))));
}

/* The same where it does, from the parts.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_intervals_detached(sf_interval A, sf_interval part_0, sf_interval part_1, sf_interval part_2, sf_interval part_3, sf_interval part_4, const sf_interval *p, sf_interval *out)
{
    const sf_interval beta = p[1];
    const sf_interval t0 = sfi_times(2.0, beta);
    out[0] = sfi_add(sfi_neg(A), sfi_times(2.0, sfi_mul(beta, part_0)));
    out[1] = sfi_sub(sfi_mul(part_1, t0), sfi_point(1.0));
    out[2] = sfi_mul(part_2, t0);
    out[3] = sfi_mul(part_3, t0);
    out[4] = sfi_mul(part_4, t0);
}

SF_FAMILY_END

#endif
