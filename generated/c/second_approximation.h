/* Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/extensions/second_approximation.py, derivations/extensions/wave.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef SECOND_APPROXIMATION_H
#define SECOND_APPROXIMATION_H

#include <math.h>

#include "inline.h"
#include "angles.h"

#define SECOND_APPROXIMATION_RESONANCE 9.0

/* What response, detachment, detachment_by_inertia have in common. */
SF_COMMON void second_approximation_common_1(double A, double Omega, double h, double h_3, double h_3_A,
    double h_3_AA, double h_5, double h_5_A, double h_5_AA, double h_A, double h_AA, double m, double *a_3_out,
    double *a_3_A_out, double *a_3_Omega_out, double *a_5_out, double *a_5_A_out, double *a_5_Omega_out,
    double *A_1_out, double *A_1_A_out, double *A_1_Omega_out, double *sine_out, double *sine_Omega_out,
    double *u_max_out, double *u_max_A_out, double *u_max_Omega_out, double *spring_out, double *spring_Omega_out,
    double *R_A_out) {
    const double t0 = 1.0 / A;
    const double Omega2 = Omega * Omega;
    const double t1 = 1.0 / Omega2;
    const double kappa = -h * t0 * t1;
    const double kappa_A = -h_A * t0 * t1 + h * t1 / (A * A);
    const double Omega3 = Omega * Omega2;
    const double t2 = 1.0 / Omega3;
    const double t3 = 2.0 * t2;
    const double kappa_Omega = h * t0 * t3;
    const double t4 = 9.0 - kappa;
    const double t5 = 1.0 / t4;
    const double t6 = t1 * t5;
    const double a_3 = -h_3 * t6;
    const double t7 = kappa_A * t1;
    const double t8 = 1.0 / (t4 * t4);
    const double t9 = h_3 * t8;
    const double a_3_A = -h_3_A * t6 - t7 * t9;
    const double t10 = kappa_Omega * t1;
    const double a_3_Omega = 2.0 * h_3 * t2 * t5 - t10 * t9;
    const double t11 = 25.0 - kappa;
    const double t12 = 1.0 / t11;
    const double t13 = t1 * t12;
    const double a_5 = -h_5 * t13;
    const double t14 = 1.0 / (t11 * t11);
    const double t15 = h_5 * t14;
    const double a_5_A = -h_5_A * t13 - t15 * t7;
    const double a_5_Omega = 2.0 * h_5 * t12 * t2 - t10 * t15;
    const double t16 = a_3 + a_5;
    const double share_A = a_3_A + a_5_A;
    const double share_Omega = a_3_Omega + a_5_Omega;
    const double A_1 = A - t16;
    const double A_1_A = 1.0 - share_A;
    const double A_1_Omega = -share_Omega;
    const double t17 = 49.0 - kappa;
    const double total = kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa +
        3.5993895204234291e-33) + 2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) +
        1.5562307152262564e-25) + 1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) +
        6.851973846392482e-18) + 5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) +
        3.3510322056003729e-10) + 2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t12
        + t5 + 0.062181275759752595 + 1.0 / t17;
    const double total_1 = kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (kappa * (7.5515438230257031e-34 * kappa + 5.7590232326774865e-32) +
        4.3756246853670614e-30) + 3.3106528631349914e-28) + 2.4931086234100061e-26) + 1.8674768582715075e-24) +
        1.3904033649698182e-22) + 1.0280748556111104e-20) + 7.5415474592217156e-19) + 5.4815790771139856e-17) +
        3.9417171084807582e-15) + 2.798495530515744e-13) + 1.9561724230771392e-11) + 1.3404128822401492e-09) +
        8.9305484067876734e-08) + 5.6693374139091918e-06) + t14 + t8 + 0.00031585946398298526 + 1.0 / (t17 * t17);
    const double t18 = 1.0 / A_1;
    const double t19 = m * t18;
    const double t20 = t1 * total;
    const double sine = -t19 * t20;
    const double t21 = t19 * total_1;
    const double t22 = 1.0 / (A_1 * A_1);
    const double sine_A = A_1_A * m * t1 * t22 * total - t21 * t7;
    const double sine_Omega = A_1_Omega * m * t20 * t22 - t10 * t21 + t19 * t3 * total;
    const double cosine = sqrt((1.0 - sine) * (sine + 1.0));
    const double cosine_1 = -sine / cosine;
    const double u_max = A_1 * cosine + t16;
    const double t23 = A_1 * cosine_1;
    const double u_max_A = A_1_A * cosine + share_A + sine_A * t23;
    const double u_max_Omega = A_1_Omega * cosine + share_Omega + sine_Omega * t23;
    const double t24 = -h_A;
    const double t25 = h_3_A + t24;
    const double t26 = h_5_A + t24;
    const double spring = a_3 * t25 + a_5 * t26 + h;
    const double spring_A = a_3 * h_3_AA + a_3_A * t25 + a_5 * h_5_AA + a_5_A * t26 + h_A - h_AA * t16;
    const double spring_Omega = a_3_Omega * t25 + a_5_Omega * t26;
    const double R_A = A_1_A * Omega2 - m * sine_A + spring_A;
    *a_3_out = a_3;
    *a_3_A_out = a_3_A;
    *a_3_Omega_out = a_3_Omega;
    *a_5_out = a_5;
    *a_5_A_out = a_5_A;
    *a_5_Omega_out = a_5_Omega;
    *A_1_out = A_1;
    *A_1_A_out = A_1_A;
    *A_1_Omega_out = A_1_Omega;
    *sine_out = sine;
    *sine_Omega_out = sine_Omega;
    *u_max_out = u_max;
    *u_max_A_out = u_max_A;
    *u_max_Omega_out = u_max_Omega;
    *spring_out = spring;
    *spring_Omega_out = spring_Omega;
    *R_A_out = R_A;
}

/* Largest displacement, A_1 and phase, R, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega.
   Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Operations: 254. Error / u (1 + kappa):
   measured 1.3. */
SF_KERNEL void second_approximation_response(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_3, double h_3_A, double h_3_AA, double h_5, double h_5_A, double h_5_AA, double *out) {
    double a_3, a_3_A, a_3_Omega, a_5, a_5_A, a_5_Omega, A_1, A_1_A, A_1_Omega, sine, sine_Omega, u_max, u_max_A,
        u_max_Omega, spring, spring_Omega, R_A;
    second_approximation_common_1(A, Omega, h, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA, h_A, h_AA, m, &a_3, &a_3_A,
        &a_3_Omega, &a_5, &a_5_A, &a_5_Omega, &A_1, &A_1_A, &A_1_Omega, &sine, &sine_Omega, &u_max, &u_max_A,
        &u_max_Omega, &spring, &spring_Omega, &R_A);
    const double Omega2 = Omega * Omega;
    const double t18 = 1.0 / A_1;
    const double t19 = m * t18;
    const double t22 = 1.0 / (A_1 * A_1);
    const double R = A_1 * Omega2 - m * sine + spring;
    const double t27 = 2.0 * Omega;
    const double R_Omega = A_1 * t27 + A_1_Omega * Omega2 - m * sine_Omega + spring_Omega;
    const double t28 = m * u_max;
    const double t29 = 9.0 * a_3 * a_3 + 25.0 * a_5 * a_5;
    const double t30 = zeta * (A_1 + t18 * t29);
    const double I_ = t18 * t28 + t27 * t30;
    const double t31 = Omega * t18 * zeta;
    const double t32 = 36.0 * a_3 * t31;
    const double t33 = 100.0 * a_5 * t31;
    const double t34 = -t22 * t28 + t27 * zeta * (-t22 * t29 + 1.0);
    const double I_A = A_1_A * t34 + a_3_A * t32 + a_5_A * t33 + t19 * u_max_A;
    const double I_Omega = A_1_Omega * t34 + a_3_Omega * t32 + a_5_Omega * t33 + t19 * u_max_Omega + 2.0 * t30;
    const double t35 = -I_;
    const double t36 = 2.0 * I_;
    const double t37 = 2.0 * R;
    out[0] = u_max;
    out[1] = A_1;
    out[2] = angles_atan2_swapped(-R, t35);
    out[3] = R;
    out[4] = R * R + (-F_0 - t35) * (F_0 + I_);
    out[5] = I_A * t36 + R_A * t37;
    out[6] = I_Omega * t36 + R_Omega * t37;
    out[7] = R_A;
    out[8] = R_Omega;
}

/* The forcing (24), largest displacement, and what vanishes where the forcing that reaches it is least.
   Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Operations: 252. Error / u (1 + kappa):
   measured 1.6. */
SF_KERNEL void second_approximation_detachment(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA, double h_3, double h_3_A, double h_3_AA, double h_5, double h_5_A, double h_5_AA, double *out) {
    double a_3, a_3_A, a_3_Omega, a_5, a_5_A, a_5_Omega, A_1, A_1_A, A_1_Omega, sine, sine_Omega, u_max, u_max_A,
        u_max_Omega, spring, spring_Omega, R_A;
    second_approximation_common_1(A, Omega, h, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA, h_A, h_AA, m, &a_3, &a_3_A,
        &a_3_Omega, &a_5, &a_5_A, &a_5_Omega, &A_1, &A_1_A, &A_1_Omega, &sine, &sine_Omega, &u_max, &u_max_A,
        &u_max_Omega, &spring, &spring_Omega, &R_A);
    const double Omega2 = Omega * Omega;
    const double t18 = 1.0 / A_1;
    const double t19 = m * t18;
    const double t22 = 1.0 / (A_1 * A_1);
    const double R = A_1 * Omega2 - m * sine + spring;
    const double t27 = 2.0 * Omega;
    const double R_Omega = A_1 * t27 + A_1_Omega * Omega2 - m * sine_Omega + spring_Omega;
    const double t28 = m * u_max;
    const double t29 = 9.0 * a_3 * a_3 + 25.0 * a_5 * a_5;
    const double t30 = zeta * (A_1 + t18 * t29);
    const double I_ = t18 * t28 + t27 * t30;
    const double t31 = Omega * t18 * zeta;
    const double t32 = 36.0 * a_3 * t31;
    const double t33 = 100.0 * a_5 * t31;
    const double t34 = -t22 * t28 + t27 * zeta * (-t22 * t29 + 1.0);
    const double I_A = A_1_A * t34 + a_3_A * t32 + a_5_A * t33 + t19 * u_max_A;
    const double I_Omega = A_1_Omega * t34 + a_3_Omega * t32 + a_5_Omega * t33 + t19 * u_max_Omega + 2.0 * t30;
    const double t35 = 2.0 * I_;
    const double t36 = 2.0 * R;
    out[0] = hypot(R, I_);
    out[1] = u_max;
    out[2] = u_max_A * (I_Omega * t35 + R_Omega * t36) - u_max_Omega * (I_A * t35 + R_A * t36);
}

/* The same of an excitation by inertia.
   Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Operations: 287. Error / u (1 + kappa):
   measured 1.7. */
SF_KERNEL void second_approximation_detachment_by_inertia(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA, double h_3, double h_3_A, double h_3_AA, double h_5, double h_5_A, double h_5_AA, double *out) {
    double a_3, a_3_A, a_3_Omega, a_5, a_5_A, a_5_Omega, A_1, A_1_A, A_1_Omega, sine, sine_Omega, u_max, u_max_A,
        u_max_Omega, spring, spring_Omega, R_A;
    second_approximation_common_1(A, Omega, h, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA, h_A, h_AA, m, &a_3, &a_3_A,
        &a_3_Omega, &a_5, &a_5_A, &a_5_Omega, &A_1, &A_1_A, &A_1_Omega, &sine, &sine_Omega, &u_max, &u_max_A,
        &u_max_Omega, &spring, &spring_Omega, &R_A);
    const double Omega2 = Omega * Omega;
    const double t1 = 1.0 / Omega2;
    const double Omega3 = Omega * Omega2;
    const double t18 = 1.0 / A_1;
    const double t19 = m * t18;
    const double t22 = 1.0 / (A_1 * A_1);
    const double t27 = m * sine;
    const double R = A_1 * Omega2 + spring - t27;
    const double t28 = m * u_max;
    const double t29 = t18 * t28;
    const double t30 = a_3 * a_3;
    const double t31 = a_5 * a_5;
    const double t32 = 9.0 * t30 + 25.0 * t31;
    const double t33 = 2.0 * Omega * zeta;
    const double I_ = t29 + t33 * (A_1 + t18 * t32);
    const double t34 = Omega * t18 * zeta;
    const double t35 = t22 * t28;
    const double I_A = A_1_A * (t33 * (-t22 * t32 + 1.0) - t35) + 36.0 * a_3 * a_3_A * t34 + 100.0 * a_5 * a_5_A *
        t34 + t19 * u_max_A;
    const double t36 = 2.0 * I_;
    const double t37 = 2.0 * R;
    const double t38 = 18.0 * t30;
    const double t39 = 50.0 * t31;
    const double t40 = A_1_Omega * Omega2 * t22 * zeta;
    out[0] = t1 * hypot(R, I_);
    out[1] = u_max;
    out[2] = -u_max_Omega * (I_A * t36 + R_A * t37) + u_max_A * (t36 * (-A_1 * t33 - A_1_Omega * Omega * t35 + 2.0
        * A_1_Omega * Omega2 * zeta + Omega * m * t18 * u_max_Omega + 36.0 * Omega2 * a_3 * a_3_Omega * t18 * zeta +
        100.0 * Omega2 * a_5 * a_5_Omega * t18 * zeta - 2.0 * t29 - t34 * t38 - t34 * t39 - t38 * t40 - t39 * t40) +
        t37 * (A_1_Omega * Omega3 - Omega * m * sine_Omega + Omega * spring_Omega - 2.0 * spring + 2.0 * t27)) /
        Omega;
}

/* F and its derivatives: a fold has F = F_A = 0, a cusp all three.
   Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Operations: 396. Error / u (1 + kappa):
   measured 1.5. */
SF_KERNEL void second_approximation_folds(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_3, double h_3_A, double h_3_AA, double h_3_AAA, double h_5, double h_5_A, double h_5_AA, double h_5_AAA, double *out) {
    const double t0 = 1.0 / A;
    const double t1 = Omega * Omega;
    const double t2 = 1.0 / t1;
    const double t3 = h * t2;
    const double kappa = -t0 * t3;
    const double t4 = t0 * t2;
    const double A2 = A * A;
    const double t5 = 1.0 / A2;
    const double kappa_A = h * t2 * t5 - h_A * t4;
    const double A3 = A * A2;
    const double kappa_AA = 2.0 * h_A * t2 * t5 - h_AA * t4 - 2.0 * t3 / A3;
    const double t6 = kappa - 9.0;
    const double t7 = -t6;
    const double t8 = 1.0 / t7;
    const double t9 = t2 * t8;
    const double a_3 = -h_3 * t9;
    const double t10 = t7 * t7;
    const double t11 = 1.0 / t10;
    const double t12 = t11 * t2;
    const double t13 = h_3 * t12;
    const double a_3_A = -h_3_A * t9 - kappa_A * t13;
    const double t14 = h_3_A * t12;
    const double t15 = 2.0 * t2;
    const double t16 = kappa_A * t15;
    const double t17 = t10 * t7;
    const double a_3_AA = -h_3_AA * t9 - kappa_A * t14 + kappa_A * (-h_3 * t16 / t17 - t14) - kappa_AA * t13;
    const double t18 = kappa - 25.0;
    const double t19 = -t18;
    const double t20 = 1.0 / t19;
    const double t21 = t2 * t20;
    const double a_5 = -h_5 * t21;
    const double t22 = t19 * t19;
    const double t23 = 1.0 / t22;
    const double t24 = t2 * t23;
    const double t25 = h_5 * t24;
    const double a_5_A = -h_5_A * t21 - kappa_A * t25;
    const double t26 = h_5_A * t24;
    const double t27 = t19 * t22;
    const double a_5_AA = -h_5_AA * t21 - kappa_A * t26 + kappa_A * (-h_5 * t16 / t27 - t26) - kappa_AA * t25;
    const double t28 = a_3 + a_5;
    const double t29 = a_3_A + a_5_A;
    const double share_AA = a_3_AA + a_5_AA;
    const double A_1 = A - t28;
    const double A_1_A = 1.0 - t29;
    const double A_1_AA = -share_AA;
    const double t30 = kappa - 49.0;
    const double t31 = -t30;
    const double total = kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa +
        3.5993895204234291e-33) + 2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) +
        1.5562307152262564e-25) + 1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) +
        6.851973846392482e-18) + 5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) +
        3.3510322056003729e-10) + 2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t20
        + t8 + 0.062181275759752595 + 1.0 / t31;
    const double total_1 = kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (kappa * (7.5515438230257031e-34 * kappa + 5.7590232326774865e-32) +
        4.3756246853670614e-30) + 3.3106528631349914e-28) + 2.4931086234100061e-26) + 1.8674768582715075e-24) +
        1.3904033649698182e-22) + 1.0280748556111104e-20) + 7.5415474592217156e-19) + 5.4815790771139856e-17) +
        3.9417171084807582e-15) + 2.798495530515744e-13) + 1.9561724230771392e-11) + 1.3404128822401492e-09) +
        8.9305484067876734e-08) + 5.6693374139091918e-06) + t11 + t23 + 0.00031585946398298526 + 1.0 / (t31 * t31);
    const double t32 = t18 * t18;
    const double t33 = t18 * t32;
    const double t34 = t30 * t30;
    const double t35 = t30 * t34;
    const double t36 = t6 * t6;
    const double t37 = t36 * t6;
    const double total_2 = kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (1.2082470116841125e-32 * kappa + 8.6385348490162305e-31) +
        6.1258745595138854e-29) + 4.303848722075489e-27) + 2.9917303480920074e-25) + 2.0542245440986584e-23) +
        1.3904033649698181e-21) + 9.2526737004999928e-20) + 6.0332379673773725e-18) + 3.8371053539797902e-16) +
        2.3650302650884553e-14) + 1.3992477652578719e-12) + 7.8246896923085567e-11) + 4.0212386467204473e-09) +
        1.7861096813575347e-07) + 5.6693374139091918e-06 - 2.0 / t37 - 2.0 / t35 - 2.0 / t33;
    const double t38 = 1.0 / A_1;
    const double t39 = m * t38;
    const double t40 = t2 * total;
    const double sine = -t39 * t40;
    const double t41 = t2 * t39;
    const double t42 = kappa_A * total_1;
    const double A_1_2 = A_1 * A_1;
    const double t43 = 1.0 / A_1_2;
    const double sine_A = A_1_A * m * t2 * t43 * total - t41 * t42;
    const double t44 = m * t43;
    const double t45 = t2 * t42 * t44;
    const double A_1_3 = A_1 * A_1_2;
    const double t46 = 1.0 / A_1_3;
    const double sine_AA = A_1_A * t45 + A_1_A * (-A_1_A * m * t15 * t46 * total + t45) + A_1_AA * t40 * t44 -
        kappa_A * kappa_A * t41 * total_2 - kappa_AA * t41 * total_1;
    const double cosine = sqrt((1.0 - sine) * (sine + 1.0));
    const double cosine_1 = -sine / cosine;
    const double cosine2 = cosine * cosine;
    const double cosine3 = cosine * cosine2;
    const double cosine_2 = -1.0 / cosine3;
    const double u_max = A_1 * cosine + t28;
    const double t47 = A_1 * cosine_1;
    const double u_max_A = A_1_A * cosine + sine_A * t47 + t29;
    const double u_max_AA = A_1 * cosine_2 * sine_A * sine_A + 2.0 * A_1_A * cosine_1 * sine_A + A_1_AA * cosine +
        share_AA + sine_AA * t47;
    const double t48 = -h_A;
    const double t49 = h_3_A + t48;
    const double t50 = h_5_A + t48;
    const double spring = a_3 * t49 + a_5 * t50 + h;
    const double t51 = -t28;
    const double spring_A = a_3 * h_3_AA + a_3_A * t49 + a_5 * h_5_AA + a_5_A * t50 + h_A + h_AA * t51;
    const double t52 = -h_AA;
    const double spring_AA = a_3 * h_3_AAA + a_3_A * h_3_AA + a_3_A * (h_3_AA + t52) + a_3_AA * t49 + a_5 * h_5_AAA
        + a_5_A * h_5_AA + a_5_A * (h_5_AA + t52) + a_5_AA * t50 + h_AA * (1.0 - t29) + h_AAA * t51;
    const double R = A_1 * t1 - m * sine + spring;
    const double R_A = A_1_A * t1 - m * sine_A + spring_A;
    const double R_AA = A_1_AA * t1 - m * sine_AA + spring_AA;
    const double t53 = m * u_max;
    const double t54 = 9.0 * a_3 * a_3 + 25.0 * a_5 * a_5;
    const double t55 = Omega * zeta;
    const double t56 = 2.0 * t55;
    const double I_ = t38 * t53 + t56 * (A_1 + t38 * t54);
    const double t57 = m * u_max_A;
    const double t58 = t38 * t55;
    const double t59 = 36.0 * a_3_A;
    const double t60 = t58 * t59;
    const double t61 = 100.0 * a_5_A;
    const double t62 = t58 * t61;
    const double t63 = -t43 * t53 + t56 * (-t43 * t54 + 1.0);
    const double I_A = A_1_A * t63 + a_3 * t60 + a_5 * t62 + t38 * t57;
    const double t64 = t43 * t57;
    const double t65 = t43 * t55;
    const double t66 = a_3 * t65;
    const double t67 = a_5 * t65;
    const double I_AA = -A_1_A * t64 + A_1_A * (A_1_A * (2.0 * t46 * t53 + 4.0 * t46 * t54 * t55) - t59 * t66 - t61
        * t67 - t64) + A_1_AA * t63 + 36.0 * a_3 * a_3_AA * t58 + a_3_A * (-36.0 * A_1_A * t66 + t60) + 100.0 * a_5
        * a_5_AA * t58 + a_5_A * (-100.0 * A_1_A * t67 + t62) + t39 * u_max_AA;
    const double t68 = 2.0 * I_;
    const double t69 = 2.0 * R;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_A * t68 + R_A * t69;
    out[2] = 2.0 * I_A * I_A + I_AA * t68 + 2.0 * R_A * R_A + R_AA * t69;
}

/* Largest displacement and what `wave` takes.
   Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2. Operations: 62. Error / u (1 + kappa):
   measured 1.1. */
SF_KERNEL void second_approximation_components(double Omega, double A, double m, double h, double h_3, double h_5, double *out) {
    const double t0 = 1.0 / (Omega * Omega);
    const double kappa = -h * t0 / A;
    const double t1 = 1.0 / (9.0 - kappa);
    const double a_3 = -h_3 * t0 * t1;
    const double t2 = 1.0 / (25.0 - kappa);
    const double a_5 = -h_5 * t0 * t2;
    const double share = a_3 + a_5;
    const double A_1 = A - share;
    const double total = kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa *
        (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (4.4420846017798256e-35 * kappa +
        3.5993895204234291e-33) + 2.9170831235780408e-31) + 2.3647520450964226e-29) + 1.9177758641615431e-27) +
        1.5562307152262564e-25) + 1.264003059063471e-23) + 1.0280748556111104e-21) + 8.3794971769130177e-20) +
        6.851973846392482e-18) + 5.6310244406867976e-16) + 4.6641592175262402e-14) + 3.912344846154278e-12) +
        3.3510322056003729e-10) + 2.9768494689292246e-08) + 2.8346687069545959e-06) + 0.00031585946398298526) + t1 +
        t2 + 0.062181275759752595 + 1.0 / (49.0 - kappa);
    const double sine = -m * t0 * total / A_1;
    const double cosine = sqrt((1.0 - sine) * (sine + 1.0));
    const double u_max = A_1 * cosine + share;
    out[0] = u_max;
    out[1] = A_1;
    out[2] = sine;
    out[3] = cosine;
    out[4] = a_3;
    out[5] = a_5;
    out[6] = kappa;
}

/* u and u' at an angle after the mass turned at its largest displacement.
   Equation beyond (23). Domain: Omega > 0, 0 <= turned <= pi, |kappa| < 9. Operations: 343. Error / u (1 + kappa):
   measured 1.5. */
SF_KERNEL void second_approximation_wave(double turned, double Omega, double m, double A_1, double sine, double cosine, double a_3, double a_5, double kappa, double *out) {
    const double c_1 = cos(turned);
    const double s_1 = sin(turned);
    const double twice = (c_1 + s_1) * (2.0 * c_1 - 2.0 * s_1);
    const double c_3 = c_1 * twice - c_1;
    const double s_3 = s_1 * twice + s_1;
    const double c_5 = -c_1 + c_3 * twice;
    const double s_5 = -s_1 + s_3 * twice;
    const double c_7 = -c_3 + c_5 * twice;
    const double s_7 = -s_3 + s_5 * twice;
    const double c_9 = -c_5 + c_7 * twice;
    const double s_9 = -s_5 + s_7 * twice;
    const double c_11 = -c_7 + c_9 * twice;
    const double s_11 = -s_7 + s_9 * twice;
    const double c_13 = c_11 * twice - c_9;
    const double s_13 = s_11 * twice - s_9;
    const double c_15 = -c_11 + c_13 * twice;
    const double s_15 = -s_11 + s_13 * twice;
    const double x = -turned + 1.5707963267948966;
    const double x2 = x * x;
    const double kappa2 = kappa * kappa;
    const double kappa4 = kappa2 * kappa2;
    const double kappa8 = kappa4 * kappa4;
    const double left_3 = kappa8 / (387420489.0 - 43046721.0 * kappa);
    const double left_5 = kappa8 / (3814697265625.0 - 152587890625.0 * kappa);
    const double left_7 = kappa8 / (1628413597910449.0 - 33232930569601.0 * kappa);
    const double left_9 = kappa8 / (1.5009463529699914e+17 - 1853020188851841.0 * kappa);
    const double left_11 = kappa8 / (5.5599173134922312e+18 - 45949729863572160.0 * kappa);
    const double left_13 = kappa8 / (1.124554069519574e+20 - 6.654166091831799e+17 * kappa);
    const double left_15 = kappa8 / (1.4778918800354003e+21 - 6.5684083557128909e+18 * kappa);
    const double t0 = x2 * (x2 * (x2 * (3.8681701706306841e-23 * x2 - 1.9572941063391263e-20) +
        8.2206352466243295e-18) - 2.8114572543455206e-15);
    const double t1 = x2 * (t0 + 7.6471637318198164e-13);
    const double t2 = x2 * (t1 - 1.6059043836821613e-10);
    const double t3 = x2 * (t2 + 2.505210838544172e-08);
    const double t4 = x2 * (t3 - 2.7557319223985893e-06);
    const double t5 = x2 * (t4 + 0.00019841269841269841);
    const double t6 = x2 * (t5 - 0.0083333333333333332);
    const double closed_cosines = kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * x * (x2 * (x2 * (x2
        * (x2 * (x2 * (x2 * (x2 * (t0 + 1.6410953816489557e-13) - 4.9869519852303398e-12) + 9.6254507448290844e-11)
        - 1.2276568272158579e-09) + 9.9832961864901149e-09) - 4.687521813584026e-08) + 1.0440270469314786e-07) -
        6.9659157375612845e-08) + x * (x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (t1 - 3.4463003014628067e-11) +
        7.7796450969593306e-10) - 1.0587995819311993e-08) + 8.839129155954177e-08) - 4.1929843983258485e-07) +
        9.3750436271680509e-07) - 6.2641622815888723e-07)) + x * (x2 * (x2 * (x2 * (x2 * (x2 * (t2 +
        5.3762284702819786e-09) - 8.5576096066552638e-08) + 7.6233569899046347e-07) - 3.7124342455007543e-06) +
        8.3859687966516967e-06) - 5.625026176300831e-06)) + x * (x2 * (x2 * (x2 * (x2 * (t3 -
        5.9138513173101762e-07) + 6.1614789167917898e-06) - 3.2018099357599463e-05) + 7.4248684910015081e-05) -
        5.0315812779910177e-05)) + x * (x2 * (x2 * (x2 * (t4 + 4.257972948463327e-05) - 0.00025878211450525515) +
        0.00064036198715198937) - 0.00044549210946009048)) + x * (x2 * (x2 * (t5 - 0.0017883486383545974) +
        0.0051756422901051034) - 0.0038421719229119358)) + x * (x2 * (t6 + 0.035766972767091947) -
        0.031053853740630619)) + x * (x2 * (t6 + 0.16666666666666666) - 0.21460183660255169);
    const double t7 = x2 * (x2 * (x2 * (8.8967913924505741e-22 - 1.6117375710961184e-24 * x2) -
        4.1103176233121648e-19) + 1.5619206968586225e-16);
    const double t8 = x2 * (t7 - 4.7794773323873853e-14);
    const double t9 = x2 * (t8 + 1.1470745597729725e-11);
    const double t10 = x2 * (t9 - 2.08767569878681e-09);
    const double t11 = x2 * (t10 + 2.7557319223985888e-07);
    const double t12 = x2 * (t11 - 2.4801587301587302e-05);
    const double t13 = x2 * (t12 + 0.0013888888888888889);
    const double closed_sines = kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (kappa * (x2 * (x2 * (x2 * (x2
        * (x2 * (x2 * (x2 * (x2 * (t7 - 1.0256846135305973e-14) + 3.5621085608788143e-13) - 8.021208954024237e-12) +
        1.2276568272158579e-10) - 1.2479120233112644e-09) + 7.8125363559733761e-09) - 2.6100676173286966e-08) +
        3.4829578687806423e-08) - 7.7422178957115755e-09) + x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (x2 * (t8 +
        2.4616430724734335e-12) - 6.4830375807994417e-11) + 1.0587995819311992e-09) - 1.1048911444942721e-08) +
        6.9883073305430808e-08) - 2.3437609067920127e-07) + 3.1320811407944362e-07) - 6.9659157375612845e-08) + x2 *
        (x2 * (x2 * (x2 * (x2 * (x2 * (t9 - 4.4801903919016488e-10) + 8.5576096066552628e-09) -
        9.5291962373807933e-08) + 6.1873904091679242e-07) - 2.0964921991629242e-06) + 2.8125130881504155e-06) -
        6.2641622815888723e-07) + x2 * (x2 * (x2 * (x2 * (x2 * (t10 + 5.9138513173101769e-08) -
        7.7018486459897373e-07) + 5.3363498929332442e-06) - 1.856217122750377e-05) + 2.5157906389955088e-05) -
        5.625026176300831e-06) + x2 * (x2 * (x2 * (x2 * (t11 - 5.3224661855791587e-06) + 4.3130352417542525e-05) -
        0.00016009049678799734) + 0.00022274605473004524) - 5.0315812779910177e-05) + x2 * (x2 * (x2 * (t12 +
        0.00029805810639243292) - 0.0012939105725262758) + 0.0019210859614559679) - 0.00044549210946009048) + x2 *
        (x2 * (t13 - 0.0089417431917729866) + 0.015526926870315309) - 0.0038421719229119358) + x2 * (x2 * (t13 -
        0.041666666666666664) + 0.10730091830127585) - 0.031053853740630619;
    const double t14 = m / (Omega * Omega);
    out[0] = A_1 * (c_1 * cosine - s_1 * sine) + a_3 * c_3 + a_5 * c_5 - t14 * (closed_sines +
        0.090909090909090912 * left_11 * s_11 + 0.076923076923076927 * left_13 * s_13 + 0.066666666666666666 *
        left_15 * s_15 + 0.33333333333333331 * left_3 * s_3 + 0.20000000000000001 * left_5 * s_5 +
        0.14285714285714285 * left_7 * s_7 + 0.1111111111111111 * left_9 * s_9);
    out[1] = Omega * (-A_1 * (c_1 * sine + cosine * s_1) - 3.0 * a_3 * s_3 - 5.0 * a_5 * s_5 - t14 * (c_11 *
        left_11 + c_13 * left_13 + c_15 * left_15 + c_3 * left_3 + c_5 * left_5 + c_7 * left_7 + c_9 * left_9 +
        closed_cosines));
}

#endif
