/* Slow flow of any mechanism, in h = H - A and its derivatives: in double-double.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
   derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

   `out` takes the outputs, where there are several.
   Equations and domains that are not stated here are those of slow_flow.h. */

#ifndef SLOW_FLOW_PAIRS_H
#define SLOW_FLOW_PAIRS_H

#include "pair_angles.h"
#include "inline.h"
#include "arithmetic_pairs.h"

SF_FAMILY_BEGIN

/* Dry friction's share of I. */
static inline sf_pair slow_flow_pairs_friction(sf_pair mu) {
    return MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), mu);
}

/* By what A change at a state, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_state_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, double *out) {
    const sf_pair t0 = SQUARE(Omega);
    const sf_pair R = ADD(MUL(A, t0), h);
    const sf_pair t1 = TIMES(2.0, MUL(Omega, zeta));
    const sf_pair I_ = ADD(MUL(A, t1), m);
    const sf_pair F = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    const double t2 = h_A.high + t0.high;
    const double F_A = 2.0 * (I_.high * t1.high + R.high * t2);
    const double F_AA = 2.0 * (R.high * h_AA.high + 4.0 * t0.high * zeta.high * zeta.high + t2 * t2);
    out[0] = -F.high / F_A;
    out[1] = -F.high * F_AA / (F_A * F_A);
}

/* By what Omega, A change at a fold, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_fold_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, double *out) {
    const sf_pair t0 = SQUARE(Omega);
    const sf_pair R = ADD(MUL(A, t0), h);
    const sf_pair t1 = MUL(A, Omega);
    const sf_pair t2 = TIMES(2.0, t1);
    const sf_pair I_ = ADD(m, MUL(t2, zeta));
    const sf_pair F = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    const sf_pair t3 = MUL(I_, zeta);
    const sf_pair t4 = ADD(h_A, t0);
    const sf_pair F_A = TIMES(2.0, ADD(TIMES(2.0, MUL(Omega, t3)), MUL(R, t4)));
    const double t5 = Omega.high * R.high + t3.high;
    const double F_Omega = 4.0 * A.high * t5;
    const double t6 = zeta.high * zeta.high;
    const double F_AOmega = 4.0 * (t1.high * t4.high + t2.high * t6 + t5);
    const double t7 = 4.0 * t6;
    const double F_AA = 2.0 * (R.high * h_AA.high + t0.high * t7 + t4.high * t4.high);
    const double F_AAOmega = 4.0 * Omega.high * (A.high * h_AA.high + 2.0 * h_A.high + 2.0 * t0.high + t7);
    const double F_AAA = 2.0 * (R.high * h_AAA.high + 3.0 * h_AA.high * t4.high);
    const double t8 = 1.0 / (-F_A.high * F_AOmega + F_AA * F_Omega);
    const double t9 = t8 * (-F.high * F_AA + F_A.high * F_A.high);
    const double t10 = t8 * (F.high * F_AOmega - F_A.high * F_Omega);
    out[0] = t9;
    out[1] = t10;
    out[2] = (F_AAA * t10 + F_AAOmega * t9) / F_AA;
}

/* By what Omega, A change at a peak, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_peak_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, double *out) {
    const sf_pair t0 = SQUARE(Omega);
    const sf_pair t1 = MUL(A, t0);
    const sf_pair R = ADD(h, t1);
    const sf_pair t2 = TIMES(2.0, A);
    const sf_pair I_ = ADD(MUL(MUL(Omega, t2), zeta), m);
    const sf_pair F = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    const sf_pair t3 = MUL(I_, zeta);
    const sf_pair t4 = ADD(MUL(Omega, R), t3);
    const sf_pair t5 = TIMES(4.0, A);
    const sf_pair F_Omega = MUL(t4, t5);
    const double t6 = h_A.high + t0.high;
    const double F_A = 2.0 * (2.0 * Omega.high * t3.high + R.high * t6);
    const double t7 = zeta.high * zeta.high;
    const double t8 = t2.high * t7;
    const double F_OmegaOmega = t5.high * (R.high + 2.0 * t1.high + t8);
    const double F_AOmega = 4.0 * (A.high * Omega.high * t6 + Omega.high * t8 + t4.high);
    const double F_AA = 2.0 * (R.high * h_AA.high + 4.0 * t0.high * t7 + t6 * t6);
    const double t9 = 1.0 / (-F_A * F_OmegaOmega + F_AOmega * F_Omega.high);
    const double t10 = t9 * (-F.high * F_AOmega + F_A * F_Omega.high);
    const double t11 = t9 * (F.high * F_OmegaOmega - F_Omega.high * F_Omega.high);
    out[0] = t10;
    out[1] = t11;
    out[2] = (F_AA * t11 + F_AOmega * t10) / F_A;
}

/* By what Omega, A, F_0 change at a cusp, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_cusp_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, double *out) {
    const sf_pair t0 = SQUARE(Omega);
    const sf_pair R = ADD(MUL(A, t0), h);
    const sf_pair t1 = MUL(A, Omega);
    const sf_pair t2 = TIMES(2.0, t1);
    const sf_pair I_ = ADD(m, MUL(t2, zeta));
    const sf_pair t3 = MUL(I_, zeta);
    const sf_pair t4 = ADD(h_A, t0);
    const sf_pair F_A = TIMES(2.0, ADD(TIMES(2.0, MUL(Omega, t3)), MUL(R, t4)));
    const sf_pair t5 = SQUARE(zeta);
    const sf_pair t6 = TIMES(4.0, t5);
    const sf_pair F_AA = TIMES(2.0, ADD(ADD(MUL(R, h_AA), MUL(t0, t6)), SQUARE(t4)));
    const double t7 = Omega.high * R.high + t3.high;
    const double F_AOmega = 4.0 * (t1.high * t4.high + t2.high * t5.high + t7);
    const double F_AAOmega = 4.0 * Omega.high * (A.high * h_AA.high + 2.0 * h_A.high + 2.0 * t0.high + t6.high);
    const double F_AAA = 2.0 * (R.high * h_AAA.high + 3.0 * h_AA.high * t4.high);
    const sf_pair F = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    const double F_Omega = 4.0 * A.high * t7;
    const double t8 = 1.0 / (-F_AA.high * F_AAOmega + F_AAA * F_AOmega);
    const double t9 = t8 * (-F_A.high * F_AAA + F_AA.high * F_AA.high);
    const double t10 = t8 * (F_A.high * F_AAOmega - F_AA.high * F_AOmega);
    out[0] = t9;
    out[1] = t10;
    out[2] = -0.5 * (-F.high - F_A.high * t10 - F_Omega * t9) / F_0.high;
    out[3] = 0.0;
}

/* By what Omega, A, F_0 change at a isola, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_isola_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, double *out) {
    const sf_pair Omega2 = SQUARE(Omega);
    const sf_pair t0 = MUL(A, Omega2);
    const sf_pair R = ADD(h, t0);
    const sf_pair t1 = TIMES(2.0, Omega);
    const sf_pair t2 = MUL(A, t1);
    const sf_pair I_ = ADD(m, MUL(t2, zeta));
    const sf_pair turns = ADD(NEG(Omega2), h_A);
    const sf_pair t3 = MUL(I_, zeta);
    const sf_pair t4 = ADD(MUL(Omega, R), t3);
    const sf_pair t5 = TIMES(4.0, A);
    const sf_pair F_Omega = MUL(t4, t5);
    const double turns_Omega = -t1.high;
    const sf_pair t6 = SQUARE(zeta);
    const double t7 = 2.0 * A.high;
    const double F_OmegaOmega = t5.high * (R.high + 2.0 * t0.high + t6.high * t7);
    const double t8 = Omega2.high + h_A.high;
    const double F_AOmega = 4.0 * (A.high * Omega.high * t8 + t2.high * t6.high + t4.high);
    const sf_pair t9 = DIV(t6, Omega2);
    const sf_pair excess = ADD(MUL(SQUARE(I_), t9), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    const double t10 = t9.high + 1.0;
    const double Omega3 = Omega.high * Omega2.high;
    const double excess_Omega = 2.0 * t3.high * (t10 * t7 - t3.high / Omega3);
    const double t11 = 4.0 * Omega.high;
    const double excess_A = t10 * t11 * t3.high;
    const double t12 = 4.0 * t6.high;
    const double F_AAOmega = t11 * (A.high * h_AA.high + 2.0 * Omega2.high + 2.0 * h_A.high + t12);
    const double F_AAA = 2.0 * (R.high * h_AAA.high + 3.0 * h_AA.high * t8);
    const double F_AA = 2.0 * (Omega2.high * t12 + R.high * h_AA.high + t8 * t8);
    const double t13 = 1.0 / (F_AOmega * turns_Omega - F_OmegaOmega * h_AA.high);
    const double t14 = t13 * (-F_AOmega * turns.high + F_Omega.high * h_AA.high);
    const double t15 = t13 * (-F_Omega.high * turns_Omega + F_OmegaOmega * turns.high);
    out[0] = t14;
    out[1] = t15;
    out[2] = -0.5 * (-excess.high - excess_A * t15 - excess_Omega * t14) / F_0.high;
    out[3] = (F_AAA * t15 + F_AAOmega * t14) / F_AA;
}

/* By what Omega change at a corner, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_corner_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, double *out) {
    const sf_pair t0 = MUL(A, SQUARE(Omega));
    const sf_pair R = ADD(h, t0);
    const sf_pair t1 = TIMES(2.0, A);
    const sf_pair I_ = ADD(MUL(MUL(Omega, t1), zeta), m);
    const sf_pair F = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    const double t2 = 4.0 * A.high;
    const double F_Omega = t2 * (I_.high * zeta.high + Omega.high * R.high);
    const double F_OmegaOmega = t2 * (R.high + 2.0 * t0.high + t1.high * zeta.high * zeta.high);
    out[0] = -F.high / F_Omega;
    out[1] = -F.high * F_OmegaOmega / (F_Omega * F_Omega);
}

/* By what Omega change at a ridge, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_ridge_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, double *out) {
    const sf_pair t0 = MUL(A, SQUARE(Omega));
    const sf_pair R = ADD(h, t0);
    const sf_pair t1 = TIMES(2.0, A);
    const sf_pair I_ = ADD(MUL(MUL(Omega, t1), zeta), m);
    const sf_pair t2 = TIMES(4.0, A);
    const sf_pair F_Omega = MUL(t2, ADD(MUL(I_, zeta), MUL(Omega, R)));
    const double F_OmegaOmega = t2.high * (R.high + 2.0 * t0.high + t1.high * zeta.high * zeta.high);
    out[0] = -F_Omega.high / F_OmegaOmega;
    out[1] = 0.0;
}

/* By what F_0 change at a level, and how far that is from linear.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_pairs_level_step(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A, sf_pair h_AA, sf_pair h_AAA, double *out) {
    const sf_pair R = ADD(MUL(A, SQUARE(Omega)), h);
    const sf_pair I_ = ADD(TIMES(2.0, MUL(MUL(A, Omega), zeta)), m);
    const sf_pair F = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[0] = 0.5 * F.high / F_0.high;
    out[1] = 0.0;
}

SF_FAMILY_END

#include "arithmetic_end.h"
#endif
