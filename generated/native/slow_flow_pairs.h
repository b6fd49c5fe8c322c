/* Slow flow of any mechanism, in h = H - A and its derivatives: in double-double.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/offset.py, derivations/along.py, derivations/slopes.py, derivations/bounds.py, derivations/gradients.py, derivations/newton.py, derivations/resultants.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   `out` takes the outputs, where there are several. */

#ifndef SLOW_FLOW_PAIRS_H
#define SLOW_FLOW_PAIRS_H

#include "pair_angles.h"

/* Dry friction's share of I.
   Equation (23). Domain: mu >= 0. */
static inline sf_pair slow_flow_pairs_friction(sf_pair mu)
{
    return sfp_mul(sfp_of(1.2732395447351628, -7.8714706700729944e-17), mu);
}

/* The forcing F_0 for which (Omega, A) is a steady state.
   Equation (24). Domain: Omega >= 0, A > 0. */
static inline sf_pair slow_flow_pairs_level(sf_pair Omega, sf_pair A, sf_pair m, sf_pair zeta, sf_pair h)
{
    const sf_pair R = sfp_add(sfp_mul(A, sfp_square(Omega)), h);
    const sf_pair I_ = sfp_add(sfp_times(2.0, sfp_mul(sfp_mul(A, Omega), zeta)), m);
    return sfp_sqrt(sfp_add(sfp_square(I_), sfp_square(R)));
}

/* By what A of a state change, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_state_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, sf_pair *out)
{
    (void)(h_AAA);
    const sf_pair t0 = sfp_square(Omega);
    const sf_pair R = sfp_add(sfp_mul(A, t0), h);
    const sf_pair t1 = sfp_times(2.0, sfp_mul(Omega, zeta));
    const sf_pair I_ = sfp_add(sfp_mul(A, t1), m);
    const sf_pair F = sfp_add(sfp_square(R), sfp_mul(sfp_add(sfp_neg(F_0), I_), sfp_add(F_0, I_)));
    const sf_pair t2 = sfp_add(h_A, t0);
    const sf_pair F_A = sfp_times(2.0, sfp_add(sfp_mul(I_, t1), sfp_mul(R, t2)));
    const sf_pair F_AA = sfp_times(2.0, sfp_add(sfp_add(sfp_mul(R, h_AA), sfp_times(4.0, sfp_mul(t0,
        sfp_square(zeta)))), sfp_square(t2)));
    out[0] = sfp_neg(sfp_div(F, F_A));
    out[1] = sfp_neg(sfp_div(sfp_mul(F, F_AA), sfp_square(F_A)));
}

/* By what Omega and A of a fold change, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_fold_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, sf_pair *out)
{
    const sf_pair t0 = sfp_square(Omega);
    const sf_pair R = sfp_add(sfp_mul(A, t0), h);
    const sf_pair t1 = sfp_mul(A, Omega);
    const sf_pair t2 = sfp_times(2.0, t1);
    const sf_pair I_ = sfp_add(m, sfp_mul(t2, zeta));
    const sf_pair F = sfp_add(sfp_square(R), sfp_mul(sfp_add(sfp_neg(F_0), I_), sfp_add(F_0, I_)));
    const sf_pair t3 = sfp_mul(I_, zeta);
    const sf_pair t4 = sfp_add(h_A, t0);
    const sf_pair F_A = sfp_times(2.0, sfp_add(sfp_times(2.0, sfp_mul(Omega, t3)), sfp_mul(R, t4)));
    const sf_pair t5 = sfp_add(sfp_mul(Omega, R), t3);
    const sf_pair F_Omega = sfp_times(4.0, sfp_mul(A, t5));
    const sf_pair t6 = sfp_square(zeta);
    const sf_pair F_AOmega = sfp_times(4.0, sfp_add(sfp_add(sfp_mul(t1, t4), sfp_mul(t2, t6)), t5));
    const sf_pair t7 = sfp_times(4.0, t6);
    const sf_pair F_AA = sfp_times(2.0, sfp_add(sfp_add(sfp_mul(R, h_AA), sfp_mul(t0, t7)), sfp_square(t4)));
    const sf_pair F_AAOmega = sfp_times(4.0, sfp_mul(Omega, sfp_add(sfp_add(sfp_add(sfp_mul(A, h_AA), sfp_times(2.0,
        h_A)), sfp_times(2.0, t0)), t7)));
    const sf_pair F_AAA = sfp_times(2.0, sfp_add(sfp_mul(R, h_AAA), sfp_times(3.0, sfp_mul(h_AA, t4))));
    const sf_pair t8 = sfp_inverse(sfp_add(sfp_neg(sfp_mul(F_A, F_AOmega)), sfp_mul(F_AA, F_Omega)));
    const sf_pair t9 = sfp_mul(t8, sfp_add(sfp_neg(sfp_mul(F, F_AA)), sfp_square(F_A)));
    const sf_pair t10 = sfp_mul(t8, sfp_sub(sfp_mul(F, F_AOmega), sfp_mul(F_A, F_Omega)));
    out[0] = t9;
    out[1] = t10;
    out[2] = sfp_div(sfp_add(sfp_mul(F_AAA, t10), sfp_mul(F_AAOmega, t9)), F_AA);
}

/* By what Omega and A of a peak change, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_peak_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, sf_pair *out)
{
    (void)(h_AAA);
    const sf_pair t0 = sfp_square(Omega);
    const sf_pair t1 = sfp_mul(A, t0);
    const sf_pair R = sfp_add(h, t1);
    const sf_pair t2 = sfp_times(2.0, A);
    const sf_pair I_ = sfp_add(sfp_mul(sfp_mul(Omega, t2), zeta), m);
    const sf_pair F = sfp_add(sfp_square(R), sfp_mul(sfp_add(sfp_neg(F_0), I_), sfp_add(F_0, I_)));
    const sf_pair t3 = sfp_mul(I_, zeta);
    const sf_pair t4 = sfp_add(sfp_mul(Omega, R), t3);
    const sf_pair t5 = sfp_times(4.0, A);
    const sf_pair F_Omega = sfp_mul(t4, t5);
    const sf_pair t6 = sfp_add(h_A, t0);
    const sf_pair F_A = sfp_times(2.0, sfp_add(sfp_times(2.0, sfp_mul(Omega, t3)), sfp_mul(R, t6)));
    const sf_pair t7 = sfp_square(zeta);
    const sf_pair t8 = sfp_mul(t2, t7);
    const sf_pair F_OmegaOmega = sfp_mul(t5, sfp_add(sfp_add(R, sfp_times(2.0, t1)), t8));
    const sf_pair F_AOmega = sfp_times(4.0, sfp_add(sfp_add(sfp_mul(sfp_mul(A, Omega), t6), sfp_mul(Omega, t8)), t4));
    const sf_pair F_AA = sfp_times(2.0, sfp_add(sfp_add(sfp_mul(R, h_AA), sfp_times(4.0, sfp_mul(t0, t7))),
        sfp_square(t6)));
    const sf_pair t9 = sfp_inverse(sfp_add(sfp_neg(sfp_mul(F_A, F_OmegaOmega)), sfp_mul(F_AOmega, F_Omega)));
    const sf_pair t10 = sfp_mul(t9, sfp_add(sfp_neg(sfp_mul(F, F_AOmega)), sfp_mul(F_A, F_Omega)));
    const sf_pair t11 = sfp_mul(t9, sfp_sub(sfp_mul(F, F_OmegaOmega), sfp_square(F_Omega)));
    out[0] = t10;
    out[1] = t11;
    out[2] = sfp_div(sfp_add(sfp_mul(F_AA, t11), sfp_mul(F_AOmega, t10)), F_A);
}

/* By what Omega and A of a cusp change, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_cusp_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, sf_pair *out)
{
    (void)(F_0);
    const sf_pair t0 = sfp_square(Omega);
    const sf_pair R = sfp_add(sfp_mul(A, t0), h);
    const sf_pair t1 = sfp_mul(A, Omega);
    const sf_pair t2 = sfp_times(2.0, t1);
    const sf_pair I_ = sfp_add(m, sfp_mul(t2, zeta));
    const sf_pair t3 = sfp_mul(I_, zeta);
    const sf_pair t4 = sfp_add(h_A, t0);
    const sf_pair F_A = sfp_times(2.0, sfp_add(sfp_times(2.0, sfp_mul(Omega, t3)), sfp_mul(R, t4)));
    const sf_pair t5 = sfp_square(zeta);
    const sf_pair t6 = sfp_times(4.0, t5);
    const sf_pair F_AA = sfp_times(2.0, sfp_add(sfp_add(sfp_mul(R, h_AA), sfp_mul(t0, t6)), sfp_square(t4)));
    const sf_pair F_AOmega = sfp_times(4.0, sfp_add(sfp_add(sfp_add(sfp_mul(Omega, R), sfp_mul(t1, t4)), sfp_mul(t2,
        t5)), t3));
    const sf_pair F_AAOmega = sfp_times(4.0, sfp_mul(Omega, sfp_add(sfp_add(sfp_add(sfp_mul(A, h_AA), sfp_times(2.0,
        h_A)), sfp_times(2.0, t0)), t6)));
    const sf_pair F_AAA = sfp_times(2.0, sfp_add(sfp_mul(R, h_AAA), sfp_times(3.0, sfp_mul(h_AA, t4))));
    const sf_pair t7 = sfp_inverse(sfp_add(sfp_neg(sfp_mul(F_AA, F_AAOmega)), sfp_mul(F_AAA, F_AOmega)));
    out[0] = sfp_mul(t7, sfp_add(sfp_neg(sfp_mul(F_A, F_AAA)), sfp_square(F_AA)));
    out[1] = sfp_mul(t7, sfp_sub(sfp_mul(F_A, F_AAOmega), sfp_mul(F_AA, F_AOmega)));
    out[2] = sfp_point(0.0);
}

/* By what Omega and A of a isola change, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_isola_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, sf_pair *out)
{
    (void)(F_0);
    const sf_pair t0 = sfp_square(Omega);
    const sf_pair t1 = sfp_mul(A, t0);
    const sf_pair R = sfp_add(h, t1);
    const sf_pair t2 = sfp_mul(A, Omega);
    const sf_pair I_ = sfp_add(m, sfp_times(2.0, sfp_mul(t2, zeta)));
    const sf_pair t3 = sfp_mul(I_, zeta);
    const sf_pair t4 = sfp_add(h_A, t0);
    const sf_pair F_A = sfp_times(2.0, sfp_add(sfp_times(2.0, sfp_mul(Omega, t3)), sfp_mul(R, t4)));
    const sf_pair t5 = sfp_add(sfp_mul(Omega, R), t3);
    const sf_pair t6 = sfp_times(4.0, A);
    const sf_pair F_Omega = sfp_mul(t5, t6);
    const sf_pair t7 = sfp_square(zeta);
    const sf_pair t8 = sfp_times(2.0, t7);
    const sf_pair F_AOmega = sfp_times(4.0, sfp_add(sfp_add(sfp_mul(t2, t4), sfp_mul(t2, t8)), t5));
    const sf_pair t9 = sfp_times(4.0, t7);
    const sf_pair F_AA = sfp_times(2.0, sfp_add(sfp_add(sfp_mul(R, h_AA), sfp_mul(t0, t9)), sfp_square(t4)));
    const sf_pair F_OmegaOmega = sfp_mul(t6, sfp_add(sfp_add(sfp_mul(A, t8), R), sfp_times(2.0, t1)));
    const sf_pair F_AAOmega = sfp_times(4.0, sfp_mul(Omega, sfp_add(sfp_add(sfp_add(sfp_mul(A, h_AA), sfp_times(2.0,
        h_A)), sfp_times(2.0, t0)), t9)));
    const sf_pair F_AAA = sfp_times(2.0, sfp_add(sfp_mul(R, h_AAA), sfp_times(3.0, sfp_mul(h_AA, t4))));
    const sf_pair t10 = sfp_inverse(sfp_add(sfp_neg(sfp_mul(F_AA, F_OmegaOmega)), sfp_square(F_AOmega)));
    const sf_pair t11 = sfp_mul(t10, sfp_add(sfp_neg(sfp_mul(F_A, F_AOmega)), sfp_mul(F_AA, F_Omega)));
    const sf_pair t12 = sfp_mul(t10, sfp_sub(sfp_mul(F_A, F_OmegaOmega), sfp_mul(F_AOmega, F_Omega)));
    out[0] = t11;
    out[1] = t12;
    out[2] = sfp_div(sfp_add(sfp_mul(F_AAA, t12), sfp_mul(F_AAOmega, t11)), F_AA);
}

/* By what Omega of a corner change, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_corner_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, sf_pair *out)
{
    (void)(h_A);
    (void)(h_AA);
    (void)(h_AAA);
    const sf_pair t0 = sfp_mul(A, sfp_square(Omega));
    const sf_pair R = sfp_add(h, t0);
    const sf_pair t1 = sfp_times(2.0, A);
    const sf_pair I_ = sfp_add(sfp_mul(sfp_mul(Omega, t1), zeta), m);
    const sf_pair F = sfp_add(sfp_square(R), sfp_mul(sfp_add(sfp_neg(F_0), I_), sfp_add(F_0, I_)));
    const sf_pair t2 = sfp_times(4.0, A);
    const sf_pair F_Omega = sfp_mul(t2, sfp_add(sfp_mul(I_, zeta), sfp_mul(Omega, R)));
    const sf_pair F_OmegaOmega = sfp_mul(t2, sfp_add(sfp_add(R, sfp_times(2.0, t0)), sfp_mul(t1, sfp_square(zeta))));
    out[0] = sfp_neg(sfp_div(F, F_Omega));
    out[1] = sfp_neg(sfp_div(sfp_mul(F, F_OmegaOmega), sfp_square(F_Omega)));
}

#endif
