/* The quartics whose roots are the frequencies at an amplitude: F of the response, F_A/2 of the folds.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/systems/frequencies.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef FREQUENCIES_H
#define FREQUENCIES_H

#include <math.h>

#include "inline.h"
#include "twofold.h"

/* what exported.c defines otherwise */
#ifndef SF_TWOFOLD
#define SF_TWOFOLD TWOFOLD_INLINE
#endif

#define FREQUENCIES_ROUGH 8.8817841970012523e-16
#define FREQUENCIES_FINE 3.1554436208840472e-30

/* F, and what its rounding error is below ROUGH times of.
   Equation (24). Domain: Omega >= 0, A > 0. Operations: 20. Error / u (1 + kappa): measured 0.98. */
SF_TWOFOLD void frequencies_response(double Omega, double A, double F_0, double m, double zeta, double h, double *out) {
    const double t0 = A * Omega * Omega;
    const double R = h + t0;
    const double I_ = 2.0 * A * Omega * zeta + m;
    const double t1 = F_0 + I_;
    const double t2 = t0 + fabs(h);
    out[0] = R * R + t1 * (-F_0 + I_);
    out[1] = t1 * t1 + t2 * (8.8817841970012523e-16 * t2 + fabs(R));
}

/* F at Omega = 0, and what its rounding error is below ROUGH times of.
   Equation (24). Domain: any. Operations: 7. Error / u (1 + kappa): proved -, 1.34; measured 1.3. */
SF_TWOFOLD void frequencies_response_at_0(double F_0, double m, double h, double *out) {
    const double t0 = h * h;
    const double t1 = F_0 + m;
    out[0] = t0 + t1 * (-F_0 + m);
    out[1] = t0 + t1 * t1;
}

/* F_A/2, and what its rounding error is below ROUGH times of.
   Equation (30). Domain: Omega >= 0, A > 0. Operations: 23. Error / u (1 + kappa): measured 1.1. */
SF_TWOFOLD void frequencies_fold(double Omega, double A, double m, double zeta, double h, double h_A, double *out) {
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega * zeta;
    const double I_ = A * t2 + m;
    const double t3 = I_ * t2;
    const double t4 = h_A + t0;
    const double t5 = t1 + fabs(h);
    out[0] = R * t4 + t3;
    out[1] = t3 + t5 * fabs(t4) + (t0 + fabs(h_A)) * (8.8817841970012523e-16 * t5 + fabs(R));
}

/* F_A/2 at Omega = 0.
   Equation (30). Domain: any. Operations: 1. Error / u (1 + kappa): proved 0.34. */
SF_TWOFOLD double frequencies_fold_at_0(double h, double h_A) {
    return h * h_A;
}

/* A Omega^3 + p Omega + q.
   Equation from (24), (30). Domain: Omega >= 0, A > 0. Operations: 5. Error / u (1 + kappa): proved 2.67. */
SF_TWOFOLD double frequencies_cubic(double Omega, double A, double p, double q) {
    return Omega * (A * Omega * Omega + p) + q;
}

/* Its derivative by Omega.
   Equation from (24), (30). Domain: Omega >= 0, A > 0. Operations: 4. Error / u (1 + kappa): proved 1.26. */
SF_TWOFOLD double frequencies_cubic_slope(double Omega, double A, double p) {
    return 3.0 * A * Omega * Omega + p;
}

/* Of a quartic from 0 to a critical point, and its magnitude.
   Equation from (24), (30). Domain: Omega >= 0, A > 0. Operations: 11. Error / u (1 + kappa): proved 3.01, -;
   measured 0.55. */
SF_TWOFOLD void frequencies_rise(double Omega, double A, double p, double k, double *out) {
    const double t0 = Omega * Omega;
    const double t1 = 0.75 * A * t0;
    const double t2 = k * t0;
    out[0] = t2 * (-0.5 * p - t1);
    out[1] = t2 * (t1 + 0.5 * fabs(p));
}

/* F in double-double, and what its error is below FINE times of.
   Exact: 6 products and 4 sums. Equation (24). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.9. */
SF_TWOFOLD void frequencies_response_fine(double Omega, double A, double F_0, double m, double zeta, double h, double *out) {
    double d0_low;
    const double d0 = twofold_two_product(A, Omega, &d0_low);
    double d1_low;
    const double d1 = twofold_two_product(d0, Omega, &d1_low);
    const double d2 = fma(d0_low, Omega, d1_low);
    double d3_low;
    const double R = twofold_two_sum(d1, h, &d3_low);
    const double R_low = d2 + d3_low;
    double d5_low;
    const double d5 = twofold_two_product(d0, 2.0 * zeta, &d5_low);
    const double d6 = fma(d0_low, 2.0 * zeta, d5_low);
    double d7_low;
    const double I_ = twofold_two_sum(d5, m, &d7_low);
    const double I_low = d6 + d7_low;
    double d9_low;
    const double d9 = twofold_two_product(F_0, F_0, &d9_low);
    double d10_low;
    const double d10 = twofold_two_product(I_, I_, &d10_low);
    const double d11 = fma(I_low, 2.0 * I_ + I_low, d10_low);
    double d12_low;
    const double d12 = twofold_two_product(R, R, &d12_low);
    const double d13 = fma(R_low, 2.0 * R + R_low, d12_low);
    double d14_low;
    const double d14 = twofold_two_sum(-d9, d10, &d14_low);
    const double d15 = d11 + d14_low - d9_low;
    double d16_low;
    const double d16 = twofold_two_sum(d14, d12, &d16_low);
    const double d17 = d13 + d15 + d16_low;
    const double t0 = A * Omega * Omega + fabs(h);
    const double t1 = F_0 + I_;
    out[0] = d16 + d17;
    out[1] = t0 * (3.1554436208840472e-30 * t0 + fabs(R)) + t1 * t1;
}

/* F at Omega + tail in double-double, and what its error is below FINE times of.
   Exact: 7 products and 4 sums. Equation (24). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.7. */
SF_TWOFOLD void frequencies_response_beside(double Omega, double tail, double A, double F_0, double m, double zeta, double h, double *out) {
    double d0_low;
    const double d0 = twofold_two_product(A, Omega, &d0_low);
    const double d1 = fma(A, tail, d0_low);
    double d2_low;
    const double d2 = twofold_two_product(d0, Omega, &d2_low);
    const double d3 = fma(d0, tail, d2_low);
    const double d4 = fma(d1, Omega + tail, d3);
    double d5_low;
    const double R = twofold_two_sum(d2, h, &d5_low);
    const double R_low = d4 + d5_low;
    double d7_low;
    const double d7 = twofold_two_product(A, 2.0 * zeta, &d7_low);
    double d8_low;
    const double d8 = twofold_two_product(d7, Omega, &d8_low);
    const double d9 = fma(d7, tail, d8_low);
    const double d10 = fma(d7_low, Omega + tail, d9);
    double d11_low;
    const double I_ = twofold_two_sum(d8, m, &d11_low);
    const double I_low = d10 + d11_low;
    double d13_low;
    const double d13 = twofold_two_product(F_0, F_0, &d13_low);
    double d14_low;
    const double d14 = twofold_two_product(I_, I_, &d14_low);
    const double d15 = fma(I_low, 2.0 * I_ + I_low, d14_low);
    double d16_low;
    const double d16 = twofold_two_product(R, R, &d16_low);
    const double d17 = fma(R_low, 2.0 * R + R_low, d16_low);
    double d18_low;
    const double d18 = twofold_two_sum(-d13, d14, &d18_low);
    const double d19 = -d13_low + d15 + d18_low;
    double d20_low;
    const double d20 = twofold_two_sum(d18, d16, &d20_low);
    const double d21 = d17 + d19 + d20_low;
    const double t0 = A * Omega * Omega + fabs(h);
    const double t1 = F_0 + I_;
    out[0] = d20 + d21;
    out[1] = t0 * (3.1554436208840472e-30 * t0 + fabs(R)) + t1 * t1;
}

/* The derivative of F by Omega is k (A Omega^3 + p Omega + q): p, p_low, q, q_low, k.
   Exact: 3 products and 2 sums. Equation (24). Domain: A > 0. Error / u (1 + kappa): measured 0.31. */
SF_TWOFOLD void frequencies_response_derivative(double A, double m, double zeta, double h, double *out) {
    double d0_low;
    const double d0 = twofold_two_product(A, zeta, &d0_low);
    double d1_low;
    const double d1 = twofold_two_product(d0, 2.0 * zeta, &d1_low);
    const double d2 = fma(d0_low, 2.0 * zeta, d1_low);
    double d3_low;
    const double d3 = twofold_two_sum(d1, h, &d3_low);
    const double d4 = d2 + d3_low;
    double d5_low;
    const double d5 = twofold_two_sum(d3, d4, &d5_low);
    double d6_low;
    const double d6 = twofold_two_product(m, zeta, &d6_low);
    out[0] = d5;
    out[1] = d5_low;
    out[2] = d6;
    out[3] = d6_low;
    out[4] = 4.0 * A;
}

/* F at Omega = 0, with a certain sign.
   Exact: 3 products. Equation (24). Domain: any. Error / u (1 + kappa): measured 0.34. */
SF_TWOFOLD double frequencies_response_exactly_at_0(double F_0, double m, double h) {
    double d0_low;
    const double d0 = twofold_two_product(h, h, &d0_low);
    double d1_low;
    const double d1 = twofold_two_product(m, m, &d1_low);
    double d2_low;
    const double d2 = twofold_two_product(F_0, F_0, &d2_low);
    double parts[] = {d0_low, d1_low, -d2_low, d0, d1, -d2};
    return twofold_distilled(parts, 6);
}

/* F_A/2 in double-double, and what its error is below FINE times of.
   Exact: 7 products and 4 sums. Equation (30). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.5. */
SF_TWOFOLD void frequencies_fold_fine(double Omega, double A, double m, double zeta, double h, double h_A, double *out) {
    double d0_low;
    const double d0 = twofold_two_product(A, Omega, &d0_low);
    double d1_low;
    const double d1 = twofold_two_product(d0, Omega, &d1_low);
    const double d2 = fma(d0_low, Omega, d1_low);
    double d3_low;
    const double R = twofold_two_sum(d1, h, &d3_low);
    const double R_low = d2 + d3_low;
    double d5_low;
    const double d5 = twofold_two_product(d0, 2.0 * zeta, &d5_low);
    const double d6 = fma(d0_low, 2.0 * zeta, d5_low);
    double d7_low;
    const double I_ = twofold_two_sum(d5, m, &d7_low);
    const double I_low = d6 + d7_low;
    double d9_low;
    const double d9 = twofold_two_product(Omega, 2.0 * zeta, &d9_low);
    double d10_low;
    const double d10 = twofold_two_product(d9, I_, &d10_low);
    const double d11 = fma(d9, I_low, d10_low);
    const double d12 = fma(d9_low, I_ + I_low, d11);
    double d13_low;
    const double d13 = twofold_two_product(Omega, Omega, &d13_low);
    double d14_low;
    const double d14 = twofold_two_sum(d13, h_A, &d14_low);
    const double d15 = d13_low + d14_low;
    double d16_low;
    const double d16 = twofold_two_product(d14, R, &d16_low);
    const double d17 = fma(d14, R_low, d16_low);
    const double d18 = fma(d15, R + R_low, d17);
    double d19_low;
    const double d19 = twofold_two_sum(d10, d16, &d19_low);
    const double d20 = d12 + d18 + d19_low;
    const double t0 = Omega * Omega;
    const double t1 = A * t0 + fabs(h);
    out[0] = d19 + d20;
    out[1] = 2.0 * I_ * Omega * zeta + t1 * fabs(h_A + t0) + (t0 + fabs(h_A)) * (3.1554436208840472e-30 * t1 +
        fabs(R));
}

/* F_A/2 at Omega + tail in double-double, and what its error is below FINE times of.
   Exact: 8 products and 4 sums. Equation (30). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.1. */
SF_TWOFOLD void frequencies_fold_beside(double Omega, double tail, double A, double m, double zeta, double h, double h_A, double *out) {
    double d0_low;
    const double d0 = twofold_two_product(A, Omega, &d0_low);
    const double d1 = fma(A, tail, d0_low);
    double d2_low;
    const double d2 = twofold_two_product(d0, Omega, &d2_low);
    const double d3 = fma(d0, tail, d2_low);
    const double d4 = fma(d1, Omega + tail, d3);
    double d5_low;
    const double R = twofold_two_sum(d2, h, &d5_low);
    const double R_low = d4 + d5_low;
    double d7_low;
    const double d7 = twofold_two_product(A, 2.0 * zeta, &d7_low);
    double d8_low;
    const double d8 = twofold_two_product(d7, Omega, &d8_low);
    const double d9 = fma(d7, tail, d8_low);
    const double d10 = fma(d7_low, Omega + tail, d9);
    double d11_low;
    const double I_ = twofold_two_sum(d8, m, &d11_low);
    const double I_low = d10 + d11_low;
    double d13_low;
    const double d13 = twofold_two_product(2.0 * zeta, I_, &d13_low);
    const double d14 = fma(2.0 * zeta, I_low, d13_low);
    double d15_low;
    const double d15 = twofold_two_product(d13, Omega, &d15_low);
    const double d16 = fma(d13, tail, d15_low);
    const double d17 = fma(d14, Omega + tail, d16);
    double d18_low;
    const double d18 = twofold_two_product(Omega, Omega, &d18_low);
    const double d19 = fma(tail, 2.0 * Omega + tail, d18_low);
    double d20_low;
    const double d20 = twofold_two_sum(d18, h_A, &d20_low);
    const double d21 = d19 + d20_low;
    double d22_low;
    const double d22 = twofold_two_product(d20, R, &d22_low);
    const double d23 = fma(d20, R_low, d22_low);
    const double d24 = fma(d21, R + R_low, d23);
    double d25_low;
    const double d25 = twofold_two_sum(d15, d22, &d25_low);
    const double d26 = d17 + d24 + d25_low;
    const double t0 = Omega * Omega;
    const double t1 = A * t0 + fabs(h);
    out[0] = d25 + d26;
    out[1] = 2.0 * I_ * Omega * zeta + t1 * fabs(h_A + t0) + (t0 + fabs(h_A)) * (3.1554436208840472e-30 * t1 +
        fabs(R));
}

/* The derivative of F_A/2 by Omega is k (A Omega^3 + p Omega + q): p, p_low, q, q_low, k.
   Exact: 4 products and 4 sums. Equation (30). Domain: A > 0. Error / u (1 + kappa): measured 0.76. */
SF_TWOFOLD void frequencies_fold_derivative(double A, double m, double zeta, double h, double h_A, double *out) {
    double d0_low;
    const double d0 = twofold_two_product(A, zeta, &d0_low);
    double d1_low;
    const double d1 = twofold_two_product(d0, 2.0 * zeta, &d1_low);
    const double d2 = fma(d0_low, 2.0 * zeta, d1_low);
    double d3_low;
    const double d3 = twofold_two_product(A, h_A, &d3_low);
    double d4_low;
    const double d4 = twofold_two_sum(d1, 0.5 * d3, &d4_low);
    const double d5 = d2 + 0.5 * d3_low + d4_low;
    double d6_low;
    const double d6 = twofold_two_sum(d4, 0.5 * h, &d6_low);
    const double d7 = d5 + d6_low;
    double d8_low;
    const double d8 = twofold_two_sum(d6, d7, &d8_low);
    double d9_low;
    const double d9 = twofold_two_product(m, zeta, &d9_low);
    double d10_low;
    const double d10 = twofold_two_sum(0.5 * d9, 0.5 * d9_low, &d10_low);
    out[0] = d8;
    out[1] = d8_low;
    out[2] = d10;
    out[3] = d10_low;
    out[4] = 4.0;
}

/* A Omega^3 + p Omega + q in double-double.
   Exact: 3 products and 2 sums. Equation from (24), (30). Domain: A > 0. Error / u (1 + kappa): measured 0.5. */
SF_TWOFOLD double frequencies_cubic_fine(double Omega, double A, double p, double p_low, double q, double q_low) {
    double d0_low;
    const double d0 = twofold_two_product(A, Omega, &d0_low);
    double d1_low;
    const double d1 = twofold_two_product(d0, Omega, &d1_low);
    const double d2 = fma(d0_low, Omega, d1_low);
    double d3_low;
    const double d3 = twofold_two_sum(d1, p, &d3_low);
    const double d4 = d2 + d3_low + p_low;
    double d5_low;
    const double d5 = twofold_two_product(Omega, d3, &d5_low);
    const double d6 = fma(Omega, d4, d5_low);
    double d7_low;
    const double d7 = twofold_two_sum(d5, q, &d7_low);
    const double d8 = d6 + d7_low + q_low;
    return d7 + d8;
}

/* Of the cubic, over A: for p < 0 < q positive where it has two positive roots; and its first term.
   Exact: 5 products and 1 sum. Equation from (24), (30). Domain: A > 0. Error / u (1 + kappa): measured 1.6. */
SF_TWOFOLD void frequencies_discriminant(double A, double p, double p_low, double q, double q_low, double *out) {
    double d0_low;
    const double d0 = twofold_two_product(27.0, A, &d0_low);
    double d1_low;
    const double d1 = twofold_two_product(d0, q, &d1_low);
    const double d2 = fma(d0, q_low, d1_low);
    const double d3 = fma(d0_low, q + q_low, d2);
    double d4_low;
    const double d4 = twofold_two_product(d1, q, &d4_low);
    const double d5 = fma(d1, q_low, d4_low);
    const double d6 = fma(d3, q + q_low, d5);
    double d7_low;
    const double d7 = twofold_two_product(p, p, &d7_low);
    const double d8 = fma(p_low, 2.0 * p + p_low, d7_low);
    double d9_low;
    const double d9 = twofold_two_product(d7, p, &d9_low);
    const double d10 = fma(d7, p_low, d9_low);
    const double d11 = fma(d8, p + p_low, d10);
    double d12_low;
    const double d12 = twofold_two_sum(-d4, -4.0 * d9, &d12_low);
    const double d13 = -4.0 * d11 + d12_low - d6;
    const double p2 = p * p;
    const double p3 = p * p2;
    out[0] = d12 + d13;
    out[1] = -4.0 * p3;
}

#endif
