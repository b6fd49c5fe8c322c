/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated.

   Written by `make derive`; never edit.
   Input: derivations/mechanisms/rod_spring_untruncated.py, sha256 fcc795df716f7e2f9f892242cfe193b7bb6d648ba5e980491479e0dbe8cfd9fa
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Regimes: passed_n where A exceeds n breakpoints, far_k where it exceeds k of them 5/4 times.
   Operations are counted after each pass. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/emit/rounding.py); others are measured (docs/stability.md). */

#ifndef ROD_SPRING_UNTRUNCATED_H
#define ROD_SPRING_UNTRUNCATED_H

#include <math.h>

#include "angles.h"
#include "slow_flow.h"

/* alpha, beta, delta_h */
#define ROD_SPRING_UNTRUNCATED_PARAMETERS 3
#define ROD_SPRING_UNTRUNCATED_BREAKPOINTS 1

/* h, h_A, h_AA, h_AAA, H, H_A, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0.
   Operations where passed_0_end: 184 structured, 155 common subexpressions, 154 power chains
   Operations where passed_0: 120 structured, 99 common subexpressions, 98 power chains
   Operations where passed_0_steep: 176 structured, 147 common subexpressions, 146 power chains
   Operations where passed_1_far: 715 structured, 715 common subexpressions, 640 power chains
   Operations where passed_1: 675 structured, 675 common subexpressions, 615 power chains
   Operations where passed_1_steeper_far: 1057 structured, 1057 common subexpressions, 964 power chains
   Operations where passed_1_steep_far: 1722 structured, 1722 common subexpressions, 1658 power chains
   Operations where passed_1_steep_away: 1365 structured, 1365 common subexpressions, 1357 power chains
   Operations where passed_1_steep: 1491 structured, 1491 common subexpressions, 1444 power chains
 */
static inline void rod_spring_untruncated_averaged_all_passed_0_end(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double delta_h = p[2];
    const double m = A * A;
    const double k_c = 1.0 - delta_h;
    const double k = k_c * k_c;
    const double a_1 = 0.5 * k_c + 0.5;
    const double b_1 = sqrt(k_c);
    const double e_1 = 0.25 / a_1;
    const double a_2 = 0.5 * a_1 + 0.5 * b_1;
    const double b_2 = sqrt(a_1) * sqrt(b_1);
    const double t0 = e_1 * e_1;
    const double t1 = 0.25 * m;
    const double e_2 = t0 * t1 / a_2;
    const double a_3 = 0.5 * a_2 + 0.5 * b_2;
    const double b_3 = sqrt(a_2) * sqrt(b_2);
    const double t2 = e_2 * e_2;
    const double e_3 = t1 * t2 / a_3;
    const double a_4 = 0.5 * a_3 + 0.5 * b_3;
    const double b_4 = sqrt(a_3) * sqrt(b_3);
    const double t3 = e_3 * e_3;
    const double e_4 = t1 * t3 / a_4;
    const double a_5 = 0.5 * a_4 + 0.5 * b_4;
    const double b_5 = sqrt(a_4) * sqrt(b_4);
    const double t4 = e_4 * e_4;
    const double e_5 = t1 * t4 / a_5;
    const double a_6 = 0.5 * a_5 + 0.5 * b_5;
    const double b_6 = sqrt(a_5) * sqrt(b_5);
    const double t5 = e_5 * e_5;
    const double e_6 = t1 * t5 / a_6;
    const double a_7 = 0.5 * a_6 + 0.5 * b_6;
    const double b_7 = sqrt(a_6) * sqrt(b_6);
    const double t6 = e_6 * e_6;
    const double e_7 = t1 * t6 / a_7;
    const double a_8 = 0.5 * a_7 + 0.5 * b_7;
    const double b_8 = sqrt(a_7) * sqrt(b_7);
    const double t7 = e_7 * e_7;
    const double e_8 = t1 * t7 / a_8;
    const double a_9 = 0.5 * a_8 + 0.5 * b_8;
    const double t8 = e_8 * e_8;
    const double t9 = 1.0 / a_9;
    const double t10 = m * t9;
    const double e_9 = 0.25 * t10 * t8;
    const double e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8 + e_9;
    const double tau = 512.0 * e_9 * e_9 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3 + 16.0 * t4 + 32.0 * t5 + 64.0 * t6 +
        128.0 * t7 + 256.0 * t8;
    const double P = t10 * (e + tau);
    const double B = t9 * (-m * tau + 1.0);
    const double C = 2.0 * t9 * tau;
    const double t11 = 2.0 * beta;
    const double t12 = A * t11;
    const double t13 = P * t12;
    const double t14 = 1.0 / k;
    const double t15 = B * t14;
    const double t16 = alpha + t11 * (-C * m + P + m * t15);
    const double k2 = k * k;
    const double t17 = 1.0 / k2;
    const double k3 = k * k2;
    out[0] = -A * alpha - t13;
    out[1] = -t16;
    out[2] = -t12 * (2.0 * B * t17 + C * t14);
    out[3] = -t11 * (B * (5.0 * m + 3.0) / k3 + C * t17 * (7.0 * m - 3.0));
    out[4] = -A * (alpha - 1.0) - t13;
    out[5] = 1.0 - t16;
    out[6] = 4.0 * A * beta * m * (-0.5 * C + 0.5 * t15);
}

static inline void rod_spring_untruncated_averaged_all_passed_0(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double m = A * A;
    const double t0 = A + 1.0;
    const double t1 = 1.0 - A;
    const double k_c = sqrt(t0) * sqrt(t1);
    const double k = t0 * t1;
    const double a_1 = 0.5 * k_c + 0.5;
    const double b_1 = sqrt(k_c);
    const double e_1 = 0.25 / a_1;
    const double a_2 = 0.5 * a_1 + 0.5 * b_1;
    const double b_2 = sqrt(a_1) * sqrt(b_1);
    const double t2 = e_1 * e_1;
    const double t3 = 0.25 * m;
    const double e_2 = t2 * t3 / a_2;
    const double a_3 = 0.5 * a_2 + 0.5 * b_2;
    const double b_3 = sqrt(a_2) * sqrt(b_2);
    const double t4 = e_2 * e_2;
    const double e_3 = t3 * t4 / a_3;
    const double a_4 = 0.5 * a_3 + 0.5 * b_3;
    const double t5 = e_3 * e_3;
    const double t6 = 1.0 / a_4;
    const double t7 = m * t6;
    const double e_4 = 0.25 * t5 * t7;
    const double e = e_1 + e_2 + e_3 + e_4;
    const double tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5;
    const double P = t7 * (e + tau);
    const double B = t6 * (-m * tau + 1.0);
    const double C = 2.0 * t6 * tau;
    const double t8 = 2.0 * beta;
    const double t9 = A * t8;
    const double t10 = P * t9;
    const double t11 = 1.0 / k;
    const double t12 = B * t11;
    const double t13 = alpha + t8 * (-C * m + P + m * t12);
    const double k2 = k * k;
    const double t14 = 1.0 / k2;
    const double k3 = k * k2;
    out[0] = -A * alpha - t10;
    out[1] = -t13;
    out[2] = -t9 * (2.0 * B * t14 + C * t11);
    out[3] = -t8 * (B * (5.0 * m + 3.0) / k3 + C * t14 * (7.0 * m - 3.0));
    out[4] = -A * (alpha - 1.0) - t10;
    out[5] = 1.0 - t13;
    out[6] = 4.0 * A * beta * m * (-0.5 * C + 0.5 * t12);
}

static inline void rod_spring_untruncated_averaged_all_passed_0_steep(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double m = A * A;
    const double t0 = A + 1.0;
    const double t1 = 1.0 - A;
    const double k_c = sqrt(t0) * sqrt(t1);
    const double k = t0 * t1;
    const double a_1 = 0.5 * k_c + 0.5;
    const double b_1 = sqrt(k_c);
    const double e_1 = 0.25 / a_1;
    const double a_2 = 0.5 * a_1 + 0.5 * b_1;
    const double b_2 = sqrt(a_1) * sqrt(b_1);
    const double t2 = e_1 * e_1;
    const double t3 = 0.25 * m;
    const double e_2 = t2 * t3 / a_2;
    const double a_3 = 0.5 * a_2 + 0.5 * b_2;
    const double b_3 = sqrt(a_2) * sqrt(b_2);
    const double t4 = e_2 * e_2;
    const double e_3 = t3 * t4 / a_3;
    const double a_4 = 0.5 * a_3 + 0.5 * b_3;
    const double b_4 = sqrt(a_3) * sqrt(b_3);
    const double t5 = e_3 * e_3;
    const double e_4 = t3 * t5 / a_4;
    const double a_5 = 0.5 * a_4 + 0.5 * b_4;
    const double b_5 = sqrt(a_4) * sqrt(b_4);
    const double t6 = e_4 * e_4;
    const double e_5 = t3 * t6 / a_5;
    const double a_6 = 0.5 * a_5 + 0.5 * b_5;
    const double b_6 = sqrt(a_5) * sqrt(b_5);
    const double t7 = e_5 * e_5;
    const double e_6 = t3 * t7 / a_6;
    const double a_7 = 0.5 * a_6 + 0.5 * b_6;
    const double b_7 = sqrt(a_6) * sqrt(b_6);
    const double t8 = e_6 * e_6;
    const double e_7 = t3 * t8 / a_7;
    const double a_8 = 0.5 * a_7 + 0.5 * b_7;
    const double t9 = e_7 * e_7;
    const double t10 = 1.0 / a_8;
    const double t11 = m * t10;
    const double e_8 = 0.25 * t11 * t9;
    const double e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8;
    const double tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 +
        128.0 * t9;
    const double P = t11 * (e + tau);
    const double B = t10 * (-m * tau + 1.0);
    const double C = 2.0 * t10 * tau;
    const double t12 = 2.0 * beta;
    const double t13 = A * t12;
    const double t14 = P * t13;
    const double t15 = 1.0 / k;
    const double t16 = B * t15;
    const double t17 = alpha + t12 * (-C * m + P + m * t16);
    const double k2 = k * k;
    const double t18 = 1.0 / k2;
    const double k3 = k * k2;
    out[0] = -A * alpha - t14;
    out[1] = -t17;
    out[2] = -t13 * (2.0 * B * t18 + C * t15);
    out[3] = -t12 * (B * (5.0 * m + 3.0) / k3 + C * t18 * (7.0 * m - 3.0));
    out[4] = -A * (alpha - 1.0) - t14;
    out[5] = 1.0 - t17;
    out[6] = 4.0 * A * beta * m * (-0.5 * C + 0.5 * t16);
}

static inline void rod_spring_untruncated_averaged_all_passed_1_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0);
    const double g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0);
    const double g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0);
    const double g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0);
    const double g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0);
    const double g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0);
    const double g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0);
    const double g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0);
    const double g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0);
    const double g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0);
    const double g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0);
    const double g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0);
    const double g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0);
    const double g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0);
    const double g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0);
    const double A2 = A * A;
    const double U2 = 4.0 * A2 * t0;
    const double v2_1 = 0.99379661859049351 * g_1 * g_1;
    const double square_1 = -U2 * v2_1 + 1.0;
    const double delta_1 = sqrt(square_1);
    const double f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1;
    const double v2_2 = 0.96760297675669993 * g_2 * g_2;
    const double square_2 = -U2 * v2_2 + 1.0;
    const double delta_2 = sqrt(square_2);
    const double f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2;
    const double v2_3 = 0.92164198121722729 * g_3 * g_3;
    const double square_3 = -U2 * v2_3 + 1.0;
    const double delta_3 = sqrt(square_3);
    const double f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3;
    const double v2_4 = 0.85784652785798998 * g_4 * g_4;
    const double square_4 = -U2 * v2_4 + 1.0;
    const double delta_4 = sqrt(square_4);
    const double f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4;
    const double v2_5 = 0.77891309933755515 * g_5 * g_5;
    const double square_5 = -U2 * v2_5 + 1.0;
    const double delta_5 = sqrt(square_5);
    const double f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5;
    const double v2_6 = 0.68817935411770381 * g_6 * g_6;
    const double square_6 = -U2 * v2_6 + 1.0;
    const double delta_6 = sqrt(square_6);
    const double f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6;
    const double v2_7 = 0.58948218524948104 * g_7 * g_7;
    const double square_7 = -U2 * v2_7 + 1.0;
    const double delta_7 = sqrt(square_7);
    const double f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7;
    const double v2_8 = 0.4869953130832757 * g_8 * g_8;
    const double square_8 = -U2 * v2_8 + 1.0;
    const double delta_8 = sqrt(square_8);
    const double f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8;
    const double v2_9 = 0.38505274377519932 * g_9 * g_9;
    const double square_9 = -U2 * v2_9 + 1.0;
    const double delta_9 = sqrt(square_9);
    const double f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9;
    const double v2_10 = 0.28796547636914854 * g_10 * g_10;
    const double square_10 = -U2 * v2_10 + 1.0;
    const double delta_10 = sqrt(square_10);
    const double f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10;
    const double v2_11 = 0.19983919110743342 * g_11 * g_11;
    const double square_11 = -U2 * v2_11 + 1.0;
    const double delta_11 = sqrt(square_11);
    const double f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11;
    const double v2_12 = 0.12440062341181206 * g_12 * g_12;
    const double square_12 = -U2 * v2_12 + 1.0;
    const double delta_12 = sqrt(square_12);
    const double f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12;
    const double v2_13 = 0.064839964168231387 * g_13 * g_13;
    const double square_13 = -U2 * v2_13 + 1.0;
    const double delta_13 = sqrt(square_13);
    const double f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13;
    const double v2_14 = 0.023675950313912963 * g_14 * g_14;
    const double square_14 = -U2 * v2_14 + 1.0;
    const double delta_14 = sqrt(square_14);
    const double f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14;
    const double v2_15 = 0.0026493505760394136 * g_15 * g_15;
    const double square_15 = -U2 * v2_15 + 1.0;
    const double delta_15 = sqrt(square_15);
    const double f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15;
    const double term_1 = f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 *
        (0.99689348407464951 * t0 + 0.99689348407464951) + 1.0) / (c + delta_1);
    const double t1 = 1.0 - 0.99379661859049351 * t0;
    const double tangent_1 = 3.975186474361974 * t0 / (t1 * t1);
    const double term_2 = f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 *
        (0.98366812327974718 * t0 + 0.98366812327974718) + 1.0) / (c + delta_2);
    const double t2 = 1.0 - 0.96760297675669993 * t0;
    const double tangent_2 = 3.8704119070267997 * t0 / (t2 * t2);
    const double term_3 = f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 *
        (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3);
    const double t3 = 1.0 - 0.92164198121722729 * t0;
    const double tangent_3 = 3.6865679248689092 * t0 / (t3 * t3);
    const double term_4 = f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 *
        (0.92620004742927431 * t0 + 0.92620004742927431) + 1.0) / (c + delta_4);
    const double t4 = 1.0 - 0.85784652785798998 * t0;
    const double tangent_4 = 3.4313861114319599 * t0 / (t4 * t4);
    const double term_5 = f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274
        * t0 + 0.88256053579205274) + 1.0) / (c + delta_5);
    const double t5 = 1.0 - 0.77891309933755515 * t0;
    const double tangent_5 = 3.1156523973502206 * t0 / (t5 * t5);
    const double term_6 = f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836
        * t0 + 0.82956576238276836) + 1.0) / (c + delta_6);
    const double t6 = 1.0 - 0.68817935411770381 * t0;
    const double tangent_6 = 2.7527174164708152 * t0 / (t6 * t6);
    const double term_7 = f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619
        * t0 + 0.76777743210482619) + 1.0) / (c + delta_7);
    const double t7 = 1.0 - 0.58948218524948104 * t0;
    const double tangent_7 = 2.3579287409979242 * t0 / (t7 * t7);
    const double term_8 = f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585
        * t0 + 0.69785049479331585) + 1.0) / (c + delta_8);
    const double t8 = 1.0 - 0.4869953130832757 * t0;
    const double tangent_8 = 1.9479812523331028 * t0 / (t8 * t8);
    const double term_9 = f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289
        * t0 + 0.62052618298924289) + 1.0) / (c + delta_9);
    const double t9 = 1.0 - 0.38505274377519932 * t0;
    const double tangent_9 = 1.5402109751007973 * t0 / (t9 * t9);
    const double term_10 = f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 *
        (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10);
    const double t10 = 1.0 - 0.28796547636914854 * t0;
    const double tangent_10 = 1.1518619054765942 * t0 / (t10 * t10);
    const double term_11 = f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 *
        (0.44703376953808915 * t0 + 0.44703376953808915) + 1.0) / (c + delta_11);
    const double t11 = 1.0 - 0.19983919110743342 * t0;
    const double tangent_11 = 0.79935676442973369 * t0 / (t11 * t11);
    const double term_12 = f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12);
    const double t12 = 1.0 - 0.12440062341181206 * t0;
    const double tangent_12 = 0.49760249364724823 * t0 / (t12 * t12);
    const double term_13 = f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 *
        (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c + delta_13);
    const double t13 = 1.0 - 0.064839964168231387 * t0;
    const double tangent_13 = 0.25935985667292555 * t0 / (t13 * t13);
    const double term_14 = f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 *
        (0.15386991360858354 * t0 + 0.15386991360858354) + 1.0) / (c + delta_14);
    const double t14 = 1.0 - 0.023675950313912963 * t0;
    const double tangent_14 = 0.094703801255651851 * t0 / (t14 * t14);
    const double term_15 = f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 *
        (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c + delta_15);
    const double t15 = 1.0 - 0.0026493505760394136 * t0;
    const double tangent_15 = 0.010597402304157654 * t0 / (t15 * t15);
    const double sum_0 = term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 +
        term_4 + term_5 + term_6 + term_7 + term_8 + term_9;
    const double sum_1 = tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 +
        tangent_13 * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3
        + tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9;
    const double tangent_1_2 = tangent_1 * tangent_1;
    const double tangent_10_2 = tangent_10 * tangent_10;
    const double tangent_11_2 = tangent_11 * tangent_11;
    const double tangent_12_2 = tangent_12 * tangent_12;
    const double tangent_13_2 = tangent_13 * tangent_13;
    const double tangent_14_2 = tangent_14 * tangent_14;
    const double tangent_15_2 = tangent_15 * tangent_15;
    const double tangent_2_2 = tangent_2 * tangent_2;
    const double tangent_3_2 = tangent_3 * tangent_3;
    const double tangent_4_2 = tangent_4 * tangent_4;
    const double tangent_5_2 = tangent_5 * tangent_5;
    const double tangent_6_2 = tangent_6 * tangent_6;
    const double tangent_7_2 = tangent_7 * tangent_7;
    const double tangent_8_2 = tangent_8 * tangent_8;
    const double tangent_9_2 = tangent_9 * tangent_9;
    const double sum_2 = tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 *
        term_13 + tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_1_2 * term_1 + tangent_2_2 * term_2 +
        tangent_3_2 * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 * term_6 + tangent_7_2 *
        term_7 + tangent_8_2 * term_8 + tangent_9_2 * term_9;
    const double tangent_1_3 = tangent_1 * tangent_1_2;
    const double tangent_10_3 = tangent_10 * tangent_10_2;
    const double tangent_11_3 = tangent_11 * tangent_11_2;
    const double tangent_12_3 = tangent_12 * tangent_12_2;
    const double tangent_13_3 = tangent_13 * tangent_13_2;
    const double tangent_14_3 = tangent_14 * tangent_14_2;
    const double tangent_15_3 = tangent_15 * tangent_15_2;
    const double tangent_2_3 = tangent_2 * tangent_2_2;
    const double tangent_3_3 = tangent_3 * tangent_3_2;
    const double tangent_4_3 = tangent_4 * tangent_4_2;
    const double tangent_5_3 = tangent_5 * tangent_5_2;
    const double tangent_6_3 = tangent_6 * tangent_6_2;
    const double tangent_7_3 = tangent_7 * tangent_7_2;
    const double tangent_8_3 = tangent_8 * tangent_8_2;
    const double tangent_9_3 = tangent_9 * tangent_9_2;
    const double sum_3 = tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 *
        term_13 + tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_1_3 * term_1 + tangent_2_3 * term_2 +
        tangent_3_3 * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 * term_6 + tangent_7_3 *
        term_7 + tangent_8_3 * term_8 + tangent_9_3 * term_9;
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0;
    out[2] = 2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 *
        T3 * sum_2 * u_cr2 / c) / A;
    out[3] = 2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0
        * T3 * sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2;
    out[4] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c;
    out[5] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c);
    out[6] = 2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 * u_cr2 / c + 8.0 * T3 * sum_1 * u_cr2 / c);
}

static inline void rod_spring_untruncated_averaged_all_passed_1(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0);
    const double g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0);
    const double g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0);
    const double g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0);
    const double g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0);
    const double g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0);
    const double g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0);
    const double g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0);
    const double g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0);
    const double g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0);
    const double g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0);
    const double g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0);
    const double g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0);
    const double g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0);
    const double g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0);
    const double A2 = A * A;
    const double U2 = 4.0 * A2 * t0;
    const double v2_1 = 0.99379661859049351 * g_1 * g_1;
    const double square_1 = -U2 * v2_1 + 1.0;
    const double delta_1 = sqrt(square_1);
    const double f_1 = 0.007968192496166605 * g_1 * v2_1 / delta_1;
    const double v2_2 = 0.96760297675669993 * g_2 * g_2;
    const double square_2 = -U2 * v2_2 + 1.0;
    const double delta_2 = sqrt(square_2);
    const double f_2 = 0.018466468311090958 * g_2 * v2_2 / delta_2;
    const double v2_3 = 0.92164198121722729 * g_3 * g_3;
    const double square_3 = -U2 * v2_3 + 1.0;
    const double delta_3 = sqrt(square_3);
    const double f_3 = 0.028784707883323369 * g_3 * v2_3 / delta_3;
    const double v2_4 = 0.85784652785798998 * g_4 * g_4;
    const double square_4 = -U2 * v2_4 + 1.0;
    const double delta_4 = sqrt(square_4);
    const double f_4 = 0.03879919256962705 * g_4 * v2_4 / delta_4;
    const double v2_5 = 0.77891309933755515 * g_5 * g_5;
    const double square_5 = -U2 * v2_5 + 1.0;
    const double delta_5 = sqrt(square_5);
    const double f_5 = 0.048402672830594053 * g_5 * v2_5 / delta_5;
    const double v2_6 = 0.68817935411770381 * g_6 * g_6;
    const double square_6 = -U2 * v2_6 + 1.0;
    const double delta_6 = sqrt(square_6);
    const double f_6 = 0.057493156217619065 * g_6 * v2_6 / delta_6;
    const double v2_7 = 0.58948218524948104 * g_7 * g_7;
    const double square_7 = -U2 * v2_7 + 1.0;
    const double delta_7 = sqrt(square_7);
    const double f_7 = 0.065974229882180491 * g_7 * v2_7 / delta_7;
    const double v2_8 = 0.4869953130832757 * g_8 * g_8;
    const double square_8 = -U2 * v2_8 + 1.0;
    const double delta_8 = sqrt(square_8);
    const double f_8 = 0.073755974737705204 * g_8 * v2_8 / delta_8;
    const double v2_9 = 0.38505274377519932 * g_9 * g_9;
    const double square_9 = -U2 * v2_9 + 1.0;
    const double delta_9 = sqrt(square_9);
    const double f_9 = 0.080755895229420213 * g_9 * v2_9 / delta_9;
    const double v2_10 = 0.28796547636914854 * g_10 * g_10;
    const double square_10 = -U2 * v2_10 + 1.0;
    const double delta_10 = sqrt(square_10);
    const double f_10 = 0.086899787201082976 * g_10 * v2_10 / delta_10;
    const double v2_11 = 0.19983919110743342 * g_11 * g_11;
    const double square_11 = -U2 * v2_11 + 1.0;
    const double delta_11 = sqrt(square_11);
    const double f_11 = 0.092122522237786122 * g_11 * v2_11 / delta_11;
    const double v2_12 = 0.12440062341181206 * g_12 * g_12;
    const double square_12 = -U2 * v2_12 + 1.0;
    const double delta_12 = sqrt(square_12);
    const double f_12 = 0.096368737174644253 * g_12 * v2_12 / delta_12;
    const double v2_13 = 0.064839964168231387 * g_13 * g_13;
    const double square_13 = -U2 * v2_13 + 1.0;
    const double delta_13 = sqrt(square_13);
    const double f_13 = 0.099593420586795267 * g_13 * v2_13 / delta_13;
    const double v2_14 = 0.023675950313912963 * g_14 * g_14;
    const double square_14 = -U2 * v2_14 + 1.0;
    const double delta_14 = sqrt(square_14);
    const double f_14 = 0.1017623897484055 * g_14 * v2_14 / delta_14;
    const double v2_15 = 0.0026493505760394136 * g_15 * g_15;
    const double square_15 = -U2 * v2_15 + 1.0;
    const double delta_15 = sqrt(square_15);
    const double f_15 = 0.10285265289355884 * g_15 * v2_15 / delta_15;
    const double fall_1 = f_1 * v2_1 / square_1;
    const double fall_2 = f_2 * v2_2 / square_2;
    const double fall_3 = f_3 * v2_3 / square_3;
    const double fall_4 = f_4 * v2_4 / square_4;
    const double fall_5 = f_5 * v2_5 / square_5;
    const double fall_6 = f_6 * v2_6 / square_6;
    const double fall_7 = f_7 * v2_7 / square_7;
    const double fall_8 = f_8 * v2_8 / square_8;
    const double fall_9 = f_9 * v2_9 / square_9;
    const double fall_10 = f_10 * v2_10 / square_10;
    const double fall_11 = f_11 * v2_11 / square_11;
    const double fall_12 = f_12 * v2_12 / square_12;
    const double fall_13 = f_13 * v2_13 / square_13;
    const double fall_14 = f_14 * v2_14 / square_14;
    const double fall_15 = f_15 * v2_15 / square_15;
    const double sum_0 = f_1 * g_1 * (0.0031065159253504597 - 0.0030968654841560038 * t0) * (g_1 *
        (0.99689348407464951 * t0 + 0.99689348407464951) + 1.0) / (c + delta_1) + f_10 * g_10 * (0.46337585185798008
        - 0.24865867177287138 * t0) * (g_10 * (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c +
        delta_10) + f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 * (0.44703376953808915 *
        t0 + 0.44703376953808915) + 1.0) / (c + delta_11) + f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604
        * t0) * (g_12 * (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12) + f_13 * g_13 *
        (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 * (0.25463692616788985 * t0 + 0.25463692616788985) +
        1.0) / (c + delta_13) + f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 *
        (0.15386991360858354 * t0 + 0.15386991360858354) + 1.0) / (c + delta_14) + f_15 * g_15 *
        (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 * (0.051471842555317698 * t0 +
        0.051471842555317698) + 1.0) / (c + delta_15) + f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 *
        t0) * (g_2 * (0.98366812327974718 * t0 + 0.98366812327974718) + 1.0) / (c + delta_2) + f_3 * g_3 *
        (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 * (0.96002186496830755 * t0 + 0.96002186496830755)
        + 1.0) / (c + delta_3) + f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 *
        (0.92620004742927431 * t0 + 0.92620004742927431) + 1.0) / (c + delta_4) + f_5 * g_5 * (0.11743946420794732 -
        0.10364743645449757 * t0) * (g_5 * (0.88256053579205274 * t0 + 0.88256053579205274) + 1.0) / (c + delta_5) +
        f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836 * t0 +
        0.82956576238276836) + 1.0) / (c + delta_6) + f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) *
        (g_7 * (0.76777743210482619 * t0 + 0.76777743210482619) + 1.0) / (c + delta_7) + f_8 * g_8 *
        (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585 * t0 + 0.69785049479331585) +
        1.0) / (c + delta_8) + f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 *
        (0.62052618298924289 * t0 + 0.62052618298924289) + 1.0) / (c + delta_9);
    const double sum_1 = fall_1 + fall_10 + fall_11 + fall_12 + fall_13 + fall_14 + fall_15 + fall_2 + fall_3 +
        fall_4 + fall_5 + fall_6 + fall_7 + fall_8 + fall_9;
    const double sum_2 = fall_1 / square_1 + fall_10 / square_10 + fall_11 / square_11 + fall_12 / square_12 +
        fall_13 / square_13 + fall_14 / square_14 + fall_15 / square_15 + fall_2 / square_2 + fall_3 / square_3 +
        fall_4 / square_4 + fall_5 / square_5 + fall_6 / square_6 + fall_7 / square_7 + fall_8 / square_8 + fall_9 /
        square_9;
    const double sum_3 = fall_1 * (4.0 * U2 * v2_1 + 1.0) / (square_1 * square_1) + fall_10 * (4.0 * U2 * v2_10 +
        1.0) / (square_10 * square_10) + fall_11 * (4.0 * U2 * v2_11 + 1.0) / (square_11 * square_11) + fall_12 *
        (4.0 * U2 * v2_12 + 1.0) / (square_12 * square_12) + fall_13 * (4.0 * U2 * v2_13 + 1.0) / (square_13 *
        square_13) + fall_14 * (4.0 * U2 * v2_14 + 1.0) / (square_14 * square_14) + fall_15 * (4.0 * U2 * v2_15 +
        1.0) / (square_15 * square_15) + fall_2 * (4.0 * U2 * v2_2 + 1.0) / (square_2 * square_2) + fall_3 * (4.0 *
        U2 * v2_3 + 1.0) / (square_3 * square_3) + fall_4 * (4.0 * U2 * v2_4 + 1.0) / (square_4 * square_4) + fall_5
        * (4.0 * U2 * v2_5 + 1.0) / (square_5 * square_5) + fall_6 * (4.0 * U2 * v2_6 + 1.0) / (square_6 * square_6)
        + fall_7 * (4.0 * U2 * v2_7 + 1.0) / (square_7 * square_7) + fall_8 * (4.0 * U2 * v2_8 + 1.0) / (square_8 *
        square_8) + fall_9 * (4.0 * U2 * v2_9 + 1.0) / (square_9 * square_9);
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c2 = c * c;
    const double c3 = c * c2;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double A4 = A2 * A2;
    const double c4 = c2 * c2;
    const double c5 = c * c4;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c) - 1.0;
    out[2] = -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root));
    out[3] = -2.5464790894703255 * beta * (96.0 * T5 * sum_3 - 3.0 * u_cr5 / (A4 * c5 * root) + 3.0 * u_cr5 / (A4
        * c3 * root) + u_cr5 / (A2 * c3 * root3));
    out[4] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c;
    out[5] = -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c);
    out[6] = 81.487330863050417 * A3 * T5 * beta * sum_1;
}

static inline void rod_spring_untruncated_averaged_all_passed_1_steeper_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double g_1 = 1.0 / (0.99754352492802578 * t0 + 1.0);
    const double g_2 = 1.0 / (0.98710220320360464 * t0 + 1.0);
    const double g_3 = 1.0 / (0.96850119628762721 * t0 + 1.0);
    const double g_4 = 1.0 / (0.94204803952146043 * t0 + 1.0);
    const double g_5 = 1.0 / (0.90818556237499348 * t0 + 1.0);
    const double g_6 = 1.0 / (0.86748116762530669 * t0 + 1.0);
    const double g_7 = 1.0 / (0.82061701033654577 * t0 + 1.0);
    const double g_8 = 1.0 / (0.76837850672767649 * t0 + 1.0);
    const double g_9 = 1.0 / (0.71164115515046622 * t0 + 1.0);
    const double g_10 = 1.0 / (0.65135585768649396 * t0 + 1.0);
    const double g_11 = 1.0 / (0.58853298117048669 * t0 + 1.0);
    const double g_12 = 1.0 / (0.52422542274260353 * t0 + 1.0);
    const double g_13 = 1.0 / (0.45951096306885042 * t0 + 1.0);
    const double g_14 = 1.0 / (0.395474202728469 * t0 + 1.0);
    const double g_15 = 1.0 / (0.33318838440271731 * t0 + 1.0);
    const double g_16 = 1.0 / (0.27369740547231697 * t0 + 1.0);
    const double g_17 = 1.0 / (0.21799832246488254 * t0 + 1.0);
    const double g_18 = 1.0 / (0.16702464056194843 * t0 + 1.0);
    const double g_19 = 1.0 / (0.12163066822343055 * t0 + 1.0);
    const double g_20 = 1.0 / (0.082577199139114363 * t0 + 1.0);
    const double g_21 = 1.0 / (0.050518761472587721 * t0 + 1.0);
    const double g_22 = 1.0 / (0.025992648096404506 * t0 + 1.0);
    const double g_23 = 1.0 / (0.0094099116687183324 * t0 + 1.0);
    const double g_24 = 1.0 / (0.0010484754715846482 * t0 + 1.0);
    const double A2 = A * A;
    const double U2 = 4.0 * A2 * t0;
    const double v2_1 = 0.99754352492802578 * g_1 * g_1;
    const double square_1 = -U2 * v2_1 + 1.0;
    const double delta_1 = sqrt(square_1);
    const double f_1 = 0.0031533460523058385 * g_1 * v2_1 / delta_1;
    const double v2_2 = 0.98710220320360464 * g_2 * g_2;
    const double square_2 = -U2 * v2_2 + 1.0;
    const double delta_2 = sqrt(square_2);
    const double f_2 = 0.0073275539012762625 * g_2 * v2_2 / delta_2;
    const double v2_3 = 0.96850119628762721 * g_3 * g_3;
    const double square_3 = -U2 * v2_3 + 1.0;
    const double delta_3 = sqrt(square_3);
    const double f_3 = 0.01147723457923454 * g_3 * v2_3 / delta_3;
    const double v2_4 = 0.94204803952146043 * g_4 * g_4;
    const double square_4 = -U2 * v2_4 + 1.0;
    const double delta_4 = sqrt(square_4);
    const double f_4 = 0.015579315722943849 * g_4 * v2_4 / delta_4;
    const double v2_5 = 0.90818556237499348 * g_5 * g_5;
    const double square_5 = -U2 * v2_5 + 1.0;
    const double delta_5 = sqrt(square_5);
    const double f_5 = 0.019616160457355529 * g_5 * v2_5 / delta_5;
    const double v2_6 = 0.86748116762530669 * g_6 * g_6;
    const double square_6 = -U2 * v2_6 + 1.0;
    const double delta_6 = sqrt(square_6);
    const double f_6 = 0.02357076083932438 * g_6 * v2_6 / delta_6;
    const double v2_7 = 0.82061701033654577 * g_7 * g_7;
    const double square_7 = -U2 * v2_7 + 1.0;
    const double delta_7 = sqrt(square_7);
    const double f_7 = 0.027426509708356948 * g_7 * v2_7 / delta_7;
    const double v2_8 = 0.76837850672767649 * g_8 * g_8;
    const double square_8 = -U2 * v2_8 + 1.0;
    const double delta_8 = sqrt(square_8);
    const double f_8 = 0.03116722783279809 * g_8 * v2_8 / delta_8;
    const double v2_9 = 0.71164115515046622 * g_9 * g_9;
    const double square_9 = -U2 * v2_9 + 1.0;
    const double delta_9 = sqrt(square_9);
    const double f_9 = 0.034777222564770442 * g_9 * v2_9 / delta_9;
    const double v2_10 = 0.65135585768649396 * g_10 * g_10;
    const double square_10 = -U2 * v2_10 + 1.0;
    const double delta_10 = sqrt(square_10);
    const double f_10 = 0.038241351065830709 * g_10 * v2_10 / delta_10;
    const double v2_11 = 0.58853298117048669 * g_11 * g_11;
    const double square_11 = -U2 * v2_11 + 1.0;
    const double delta_11 = sqrt(square_11);
    const double f_11 = 0.041545082943464748 * g_11 * v2_11 / delta_11;
    const double v2_12 = 0.52422542274260353 * g_12 * g_12;
    const double square_12 = -U2 * v2_12 + 1.0;
    const double delta_12 = sqrt(square_12);
    const double f_12 = 0.04467456085669428 * g_12 * v2_12 / delta_12;
    const double v2_13 = 0.45951096306885042 * g_13 * g_13;
    const double square_13 = -U2 * v2_13 + 1.0;
    const double delta_13 = sqrt(square_13);
    const double f_13 = 0.047616658492490478 * g_13 * v2_13 / delta_13;
    const double v2_14 = 0.395474202728469 * g_14 * g_14;
    const double square_14 = -U2 * v2_14 + 1.0;
    const double delta_14 = sqrt(square_14);
    const double f_14 = 0.050359035553854473 * g_14 * v2_14 / delta_14;
    const double v2_15 = 0.33318838440271731 * g_15 * g_15;
    const double square_15 = -U2 * v2_15 + 1.0;
    const double delta_15 = sqrt(square_15);
    const double f_15 = 0.052890189485193667 * g_15 * v2_15 / delta_15;
    const double v2_16 = 0.27369740547231697 * g_16 * g_16;
    const double square_16 = -U2 * v2_16 + 1.0;
    const double delta_16 = sqrt(square_16);
    const double f_16 = 0.055199503699984165 * g_16 * v2_16 / delta_16;
    const double v2_17 = 0.21799832246488254 * g_17 * g_17;
    const double square_17 = -U2 * v2_17 + 1.0;
    const double delta_17 = sqrt(square_17);
    const double f_17 = 0.057277292100403214 * g_17 * v2_17 / delta_17;
    const double v2_18 = 0.16702464056194843 * g_18 * g_18;
    const double square_18 = -U2 * v2_18 + 1.0;
    const double delta_18 = sqrt(square_18);
    const double f_18 = 0.059114839698395635 * g_18 * v2_18 / delta_18;
    const double v2_19 = 0.12163066822343055 * g_19 * g_19;
    const double square_19 = -U2 * v2_19 + 1.0;
    const double delta_19 = sqrt(square_19);
    const double f_19 = 0.060704439165893881 * g_19 * v2_19 / delta_19;
    const double v2_20 = 0.082577199139114363 * g_20 * g_20;
    const double square_20 = -U2 * v2_20 + 1.0;
    const double delta_20 = sqrt(square_20);
    const double f_20 = 0.062039423159892665 * g_20 * v2_20 / delta_20;
    const double v2_21 = 0.050518761472587721 * g_21 * g_21;
    const double square_21 = -U2 * v2_21 + 1.0;
    const double delta_21 = sqrt(square_21);
    const double f_21 = 0.06311419228625402 * g_21 * v2_21 / delta_21;
    const double v2_22 = 0.025992648096404506 * g_22 * g_22;
    const double square_22 = -U2 * v2_22 + 1.0;
    const double delta_22 = sqrt(square_22);
    const double f_22 = 0.063924238584648185 * g_22 * v2_22 / delta_22;
    const double v2_23 = 0.0094099116687183324 * g_23 * g_23;
    const double square_23 = -U2 * v2_23 + 1.0;
    const double delta_23 = sqrt(square_23);
    const double f_23 = 0.064466164435950088 * g_23 * v2_23 / delta_23;
    const double v2_24 = 0.0010484754715846482 * g_24 * g_24;
    const double square_24 = -U2 * v2_24 + 1.0;
    const double delta_24 = sqrt(square_24);
    const double f_24 = 0.064737696812683918 * g_24 * v2_24 / delta_24;
    const double term_1 = f_1 * g_1 * (0.0012289927475738814 - 0.0012274823244002922 * t0) * (g_1 *
        (0.99877100725242607 * t0 + 0.99877100725242607) + 1.0) / (c + delta_1);
    const double t1 = 1.0 - 0.99754352492802578 * t0;
    const double tangent_1 = 3.9901740997121031 * t0 / (t1 * t1);
    const double term_2 = f_2 * g_2 * (0.0064698277336492421 - 0.0064279690627461455 * t0) * (g_2 *
        (0.99353017226635076 * t0 + 0.99353017226635076) + 1.0) / (c + delta_2);
    const double t2 = 1.0 - 0.98710220320360464 * t0;
    const double tangent_2 = 3.9484088128144186 * t0 / (t2 * t2);
    const double term_3 = f_3 * g_3 * (0.015875416277173142 - 0.015623387435199608 * t0) * (g_3 *
        (0.98412458372282685 * t0 + 0.98412458372282685) + 1.0) / (c + delta_3);
    const double t3 = 1.0 - 0.96850119628762721 * t0;
    const double tangent_3 = 3.8740047851505088 * t0 / (t3 * t3);
    const double term_4 = f_4 * g_4 * (0.029408407453752748 - 0.028543553024786811 * t0) * (g_4 *
        (0.97059159254624727 * t0 + 0.97059159254624727) + 1.0) / (c + delta_4);
    const double t4 = 1.0 - 0.94204803952146043 * t0;
    const double tangent_4 = 3.7681921580858417 * t0 / (t4 * t4);
    const double term_5 = f_5 * g_5 * (0.047012296839569138 - 0.044802140785437379 * t0) * (g_5 *
        (0.95298770316043091 * t0 + 0.95298770316043091) + 1.0) / (c + delta_5);
    const double t5 = 1.0 - 0.90818556237499348 * t0;
    const double tangent_5 = 3.6327422494999739 * t0 / (t5 * t5);
    const double term_6 = f_6 * g_6 * (0.068613309293445668 - 0.063905523081247625 * t0) * (g_6 *
        (0.93138669070655433 * t0 + 0.93138669070655433) + 1.0) / (c + delta_6);
    const double t6 = 1.0 - 0.86748116762530669 * t0;
    const double tangent_6 = 3.4699246705012268 * t0 / (t6 * t6);
    const double term_7 = f_7 * g_7 * (0.094120863284430326 - 0.085262126379023903 * t0) * (g_7 *
        (0.90587913671556963 * t0 + 0.90587913671556963) + 1.0) / (c + delta_7);
    const double t7 = 1.0 - 0.82061701033654577 * t0;
    const double tangent_7 = 3.2824680413461831 * t0 / (t7 * t7);
    const double term_8 = f_8 * g_8 * (0.12342797972575212 - 0.10819351354657145 * t0) * (g_8 * (0.87657202027424785
        * t0 + 0.87657202027424785) + 1.0) / (c + delta_8);
    const double t8 = 1.0 - 0.76837850672767649 * t0;
    const double tangent_8 = 3.073514026910706 * t0 / (t8 * t8);
    const double term_9 = f_9 * g_9 * (0.15641173837560646 - 0.13194710647392729 * t0) * (g_9 * (0.84358826162439349
        * t0 + 0.84358826162439349) + 1.0) / (c + delta_9);
    const double t9 = 1.0 - 0.71164115515046622 * t0;
    const double tangent_9 = 2.8465646206018649 * t0 / (t9 * t9);
    const double term_10 = f_10 * g_10 * (0.19293379597055738 - 0.15571034634294872 * t0) * (g_10 *
        (0.80706620402944262 * t0 + 0.80706620402944262) + 1.0) / (c + delta_10);
    const double t10 = 1.0 - 0.65135585768649396 * t0;
    const double tangent_10 = 2.6054234307459758 * t0 / (t10 * t10);
    const double term_11 = f_11 * g_11 * (0.23284096748425967 - 0.17862605134525358 * t0) * (g_11 *
        (0.76715903251574036 * t0 + 0.76715903251574036) + 1.0) / (c + delta_11);
    const double t11 = 1.0 - 0.58853298117048669 * t0;
    const double tangent_11 = 2.3541319246819468 * t0 / (t11 * t11);
    const double term_12 = f_12 * g_12 * (0.27596586907618537 - 0.19980870818121108 * t0) * (g_12 *
        (0.72403413092381463 * t0 + 0.72403413092381463) + 1.0) / (c + delta_12);
    const double t12 = 1.0 - 0.52422542274260353 * t0;
    const double tangent_12 = 2.0969016909704141 * t0 / (t12 * t12);
    const double term_13 = f_13 * g_13 * (0.32212762036733611 - 0.2183614165638135 * t0) * (g_13 *
        (0.67787237963266389 * t0 + 0.67787237963266389) + 1.0) / (c + delta_13);
    const double t13 = 1.0 - 0.45951096306885042 * t0;
    const double tangent_13 = 1.8380438522754017 * t0 / (t13 * t13);
    const double term_14 = f_14 * g_14 * (0.3711326032234864 - 0.23339319404804459 * t0) * (g_14 *
        (0.6288673967765136 * t0 + 0.6288673967765136) + 1.0) / (c + delta_14);
    const double t14 = 1.0 - 0.395474202728469 * t0;
    const double tangent_14 = 1.581896810913876 * t0 / (t14 * t14);
    const double term_15 = f_15 * g_15 * (0.42277527391602732 - 0.24403634168125538 * t0) * (g_15 *
        (0.57722472608397268 * t0 + 0.57722472608397268) + 1.0) / (c + delta_15);
    const double t15 = 1.0 - 0.33318838440271731 * t0;
    const double tangent_15 = 1.3327535376108692 * t0 / (t15 * t15);
    const double term_16 = f_16 * g_16 * (0.47683902527776695 - 0.24946356924991608 * t0) * (g_16 *
        (0.523160974722233 * t0 + 0.523160974722233) + 1.0) / (c + delta_16);
    const double t16 = 1.0 - 0.27369740547231697 * t0;
    const double tangent_16 = 1.0947896218892679 * t0 / (t16 * t16);
    const double term_17 = f_17 * g_17 * (0.53309709524904159 - 0.24890458228607587 * t0) * (g_17 *
        (0.46690290475095841 * t0 + 0.46690290475095841) + 1.0) / (c + delta_17);
    const double t17 = 1.0 - 0.21799832246488254 * t0;
    const double tangent_17 = 0.87199328985953017 * t0 / (t17 * t17);
    const double term_18 = f_18 * g_18 * (0.59131351800928322 - 0.24166184142876829 * t0) * (g_18 *
        (0.40868648199071672 * t0 + 0.40868648199071672) + 1.0) / (c + delta_18);
    const double t18 = 1.0 - 0.16702464056194843 * t0;
    const double tangent_18 = 0.66809856224779374 * t0 / (t18 * t18);
    const double term_19 = f_19 * g_19 * (0.6512441137078393 - 0.22712521806873018 * t0) * (g_19 *
        (0.34875588629216075 * t0 + 0.34875588629216075) + 1.0) / (c + delta_19);
    const double t19 = 1.0 - 0.12163066822343055 * t0;
    const double tangent_19 = 0.4865226728937222 * t0 / (t19 * t19);
    const double term_20 = f_20 * g_20 * (0.71263751264454445 - 0.2047852882163412 * t0) * (g_20 *
        (0.28736248735545555 * t0 + 0.28736248735545555) + 1.0) / (c + delta_20);
    const double t20 = 1.0 - 0.082577199139114363 * t0;
    const double tangent_20 = 0.33030879655645745 * t0 / (t20 * t20);
    const double term_21 = f_21 * g_21 * (0.77523620960531092 - 0.17424502892210134 * t0) * (g_21 *
        (0.22476379039468905 * t0 + 0.22476379039468905) + 1.0) / (c + delta_21);
    const double t21 = 1.0 - 0.050518761472587721 * t0;
    const double tangent_21 = 0.20207504589035089 * t0 / (t21 * t21);
    const double term_22 = f_22 * g_22 * (0.83877764393110832 - 0.13522970797248721 * t0) * (g_22 *
        (0.16122235606889171 * t0 + 0.16122235606889171) + 1.0) / (c + delta_22);
    const double t22 = 1.0 - 0.025992648096404506 * t0;
    const double tangent_22 = 0.10397059238561802 * t0 / (t22 * t22);
    const double term_23 = f_23 * g_23 * (0.90299530079053725 - 0.087594787540744359 * t0) * (g_23 *
        (0.097004699209462697 * t0 + 0.097004699209462697) + 1.0) / (c + delta_23);
    const double t23 = 1.0 - 0.0094099116687183324 * t0;
    const double tangent_23 = 0.03763964667487333 * t0 / (t23 * t23);
    const double term_24 = f_24 * g_24 * (0.96761982903713062 - 0.031331695491284714 * t0) * (g_24 *
        (0.03238017096286936 * t0 + 0.03238017096286936) + 1.0) / (c + delta_24);
    const double t24 = 1.0 - 0.0010484754715846482 * t0;
    const double tangent_24 = 0.0041939018863385927 * t0 / (t24 * t24);
    const double sum_0 = term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_16 + term_17 +
        term_18 + term_19 + term_2 + term_20 + term_21 + term_22 + term_23 + term_24 + term_3 + term_4 + term_5 +
        term_6 + term_7 + term_8 + term_9;
    const double sum_1 = tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 +
        tangent_13 * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_16 * term_16 + tangent_17 *
        term_17 + tangent_18 * term_18 + tangent_19 * term_19 + tangent_2 * term_2 + tangent_20 * term_20 +
        tangent_21 * term_21 + tangent_22 * term_22 + tangent_23 * term_23 + tangent_24 * term_24 + tangent_3 *
        term_3 + tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 *
        term_8 + tangent_9 * term_9;
    const double tangent_1_2 = tangent_1 * tangent_1;
    const double tangent_10_2 = tangent_10 * tangent_10;
    const double tangent_11_2 = tangent_11 * tangent_11;
    const double tangent_12_2 = tangent_12 * tangent_12;
    const double tangent_13_2 = tangent_13 * tangent_13;
    const double tangent_14_2 = tangent_14 * tangent_14;
    const double tangent_15_2 = tangent_15 * tangent_15;
    const double tangent_16_2 = tangent_16 * tangent_16;
    const double tangent_17_2 = tangent_17 * tangent_17;
    const double tangent_18_2 = tangent_18 * tangent_18;
    const double tangent_19_2 = tangent_19 * tangent_19;
    const double tangent_2_2 = tangent_2 * tangent_2;
    const double tangent_20_2 = tangent_20 * tangent_20;
    const double tangent_21_2 = tangent_21 * tangent_21;
    const double tangent_22_2 = tangent_22 * tangent_22;
    const double tangent_23_2 = tangent_23 * tangent_23;
    const double tangent_24_2 = tangent_24 * tangent_24;
    const double tangent_3_2 = tangent_3 * tangent_3;
    const double tangent_4_2 = tangent_4 * tangent_4;
    const double tangent_5_2 = tangent_5 * tangent_5;
    const double tangent_6_2 = tangent_6 * tangent_6;
    const double tangent_7_2 = tangent_7 * tangent_7;
    const double tangent_8_2 = tangent_8 * tangent_8;
    const double tangent_9_2 = tangent_9 * tangent_9;
    const double sum_2 = tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 *
        term_13 + tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_16_2 * term_16 + tangent_17_2 * term_17
        + tangent_18_2 * term_18 + tangent_19_2 * term_19 + tangent_1_2 * term_1 + tangent_20_2 * term_20 +
        tangent_21_2 * term_21 + tangent_22_2 * term_22 + tangent_23_2 * term_23 + tangent_24_2 * term_24 +
        tangent_2_2 * term_2 + tangent_3_2 * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 *
        term_6 + tangent_7_2 * term_7 + tangent_8_2 * term_8 + tangent_9_2 * term_9;
    const double tangent_1_3 = tangent_1 * tangent_1_2;
    const double tangent_10_3 = tangent_10 * tangent_10_2;
    const double tangent_11_3 = tangent_11 * tangent_11_2;
    const double tangent_12_3 = tangent_12 * tangent_12_2;
    const double tangent_13_3 = tangent_13 * tangent_13_2;
    const double tangent_14_3 = tangent_14 * tangent_14_2;
    const double tangent_15_3 = tangent_15 * tangent_15_2;
    const double tangent_16_3 = tangent_16 * tangent_16_2;
    const double tangent_17_3 = tangent_17 * tangent_17_2;
    const double tangent_18_3 = tangent_18 * tangent_18_2;
    const double tangent_19_3 = tangent_19 * tangent_19_2;
    const double tangent_2_3 = tangent_2 * tangent_2_2;
    const double tangent_20_3 = tangent_20 * tangent_20_2;
    const double tangent_21_3 = tangent_21 * tangent_21_2;
    const double tangent_22_3 = tangent_22 * tangent_22_2;
    const double tangent_23_3 = tangent_23 * tangent_23_2;
    const double tangent_24_3 = tangent_24 * tangent_24_2;
    const double tangent_3_3 = tangent_3 * tangent_3_2;
    const double tangent_4_3 = tangent_4 * tangent_4_2;
    const double tangent_5_3 = tangent_5 * tangent_5_2;
    const double tangent_6_3 = tangent_6 * tangent_6_2;
    const double tangent_7_3 = tangent_7 * tangent_7_2;
    const double tangent_8_3 = tangent_8 * tangent_8_2;
    const double tangent_9_3 = tangent_9 * tangent_9_2;
    const double sum_3 = tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 *
        term_13 + tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_16_3 * term_16 + tangent_17_3 * term_17
        + tangent_18_3 * term_18 + tangent_19_3 * term_19 + tangent_1_3 * term_1 + tangent_20_3 * term_20 +
        tangent_21_3 * term_21 + tangent_22_3 * term_22 + tangent_23_3 * term_23 + tangent_24_3 * term_24 +
        tangent_2_3 * term_2 + tangent_3_3 * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 *
        term_6 + tangent_7_3 * term_7 + tangent_8_3 * term_8 + tangent_9_3 * term_9;
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0;
    out[2] = 2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 *
        T3 * sum_2 * u_cr2 / c) / A;
    out[3] = 2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0
        * T3 * sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2;
    out[4] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c;
    out[5] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c);
    out[6] = 2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 * u_cr2 / c + 8.0 * T3 * sum_1 * u_cr2 / c);
}

static inline void rod_spring_untruncated_averaged_all_passed_1_steep_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double c2 = c * c;
    const double lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0);
    const double half = 0.5 * (A - u_cr) * (A + u_cr);
    const double root = sqrt(2.0 * half - 0.5 * fabs(half - lacking) + 0.5 * fabs(half + lacking));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0);
    const double g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0);
    const double g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0);
    const double g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0);
    const double g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0);
    const double g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0);
    const double g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0);
    const double g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0);
    const double g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0);
    const double g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0);
    const double g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0);
    const double g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0);
    const double g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0);
    const double g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0);
    const double g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0);
    const double A2 = A * A;
    const double x2 = u_cr * u_cr / A2;
    const double y2 = root * root / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double a0_half_0_2 = a0_half_0 * a0_half_0;
    const double a0_half_0_3 = a0_half_0 * a0_half_0_2;
    const double a02_0 = -a0_half_0_3;
    const double a03_0 = -2.0 * a02_0 * a0_half_0_2;
    const double b0_0 = sqrt(c2);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double lam0_2 = a02_0 * b0_0 + a02_0;
    const double lam0_3 = a03_0 * b0_0 + a03_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double X0_2 = 0.25 * lam0_2;
    const double X0_3 = 0.25 * lam0_3;
    const double Y0_0 = 0.25 * c2 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Y0_2 = 0.25 * lam0_2;
    const double Y0_3 = 0.25 * lam0_3;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double Z0_3 = 0.25 * lam0_3;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double a13_0 = a1_half_0 * (X0_3 - 2.0 * a11_0 * a12_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double b13_0 = b1_half_0 * (Y0_3 - 2.0 * b11_0 * b12_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double c13_0 = c1_half_0 * (Z0_3 - 2.0 * c11_0 * c12_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double lam1_3 = a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * (a12_0 + b12_0) +
        c12_0 * (a11_0 + b11_0) + c13_0 * (a1_0 + b1_0) + c1_0 * (a13_0 + b13_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double q1_3 = Z0_3 + lam1_3;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double X1_3 = 0.25 * X0_3 + 0.25 * lam1_3;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Y1_3 = 0.25 * Y0_3 + 0.25 * lam1_3;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double Z1_3 = 0.25 * Z0_3 + 0.25 * lam1_3;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double a23_0 = a2_half_0 * (X1_3 - 2.0 * a21_0 * a22_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double b23_0 = b2_half_0 * (Y1_3 - 2.0 * b21_0 * b22_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double c23_0 = c2_half_0 * (Z1_3 - 2.0 * c21_0 * c22_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double lam2_3 = a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * (a22_0 + b22_0) +
        c22_0 * (a21_0 + b21_0) + c23_0 * (a2_0 + b2_0) + c2_0 * (a23_0 + b23_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double q2_3 = Z1_3 + lam2_3;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double below2_3 = c21_0 * q2_2 + c22_0 * q2_1 + c23_0 * q2_0 + c2_0 * q2_3;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double term23_0 = -term2_0 * (below2_1 * term22_0 + below2_2 * term21_0 + below2_3 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double X2_3 = 0.25 * X1_3 + 0.25 * lam2_3;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Y2_3 = 0.25 * Y1_3 + 0.25 * lam2_3;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double Z2_3 = 0.25 * Z1_3 + 0.25 * lam2_3;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double a33_0 = a3_half_0 * (X2_3 - 2.0 * a31_0 * a32_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double b33_0 = b3_half_0 * (Y2_3 - 2.0 * b31_0 * b32_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double c33_0 = c3_half_0 * (Z2_3 - 2.0 * c31_0 * c32_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double lam3_3 = a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * (a32_0 + b32_0) +
        c32_0 * (a31_0 + b31_0) + c33_0 * (a3_0 + b3_0) + c3_0 * (a33_0 + b33_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double q3_3 = Z2_3 + lam3_3;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double below3_3 = c31_0 * q3_2 + c32_0 * q3_1 + c33_0 * q3_0 + c3_0 * q3_3;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double term33_0 = -term3_0 * (below3_1 * term32_0 + below3_2 * term31_0 + below3_3 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double X3_3 = 0.25 * X2_3 + 0.25 * lam3_3;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Y3_3 = 0.25 * Y2_3 + 0.25 * lam3_3;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double Z3_3 = 0.25 * Z2_3 + 0.25 * lam3_3;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double a43_0 = a4_half_0 * (X3_3 - 2.0 * a41_0 * a42_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double b43_0 = b4_half_0 * (Y3_3 - 2.0 * b41_0 * b42_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double c43_0 = c4_half_0 * (Z3_3 - 2.0 * c41_0 * c42_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double lam4_3 = a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * (a42_0 + b42_0) +
        c42_0 * (a41_0 + b41_0) + c43_0 * (a4_0 + b4_0) + c4_0 * (a43_0 + b43_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double q4_3 = Z3_3 + lam4_3;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double below4_3 = c41_0 * q4_2 + c42_0 * q4_1 + c43_0 * q4_0 + c4_0 * q4_3;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double term43_0 = -term4_0 * (below4_1 * term42_0 + below4_2 * term41_0 + below4_3 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double X4_3 = 0.25 * X3_3 + 0.25 * lam4_3;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Y4_3 = 0.25 * Y3_3 + 0.25 * lam4_3;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double Z4_3 = 0.25 * Z3_3 + 0.25 * lam4_3;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double a53_0 = a5_half_0 * (X4_3 - 2.0 * a51_0 * a52_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double b53_0 = b5_half_0 * (Y4_3 - 2.0 * b51_0 * b52_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double c53_0 = c5_half_0 * (Z4_3 - 2.0 * c51_0 * c52_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double lam5_3 = a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * (a52_0 + b52_0) +
        c52_0 * (a51_0 + b51_0) + c53_0 * (a5_0 + b5_0) + c5_0 * (a53_0 + b53_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double q5_3 = Z4_3 + lam5_3;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double below5_3 = c51_0 * q5_2 + c52_0 * q5_1 + c53_0 * q5_0 + c5_0 * q5_3;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double term53_0 = -term5_0 * (below5_1 * term52_0 + below5_2 * term51_0 + below5_3 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double X5_3 = 0.25 * X4_3 + 0.25 * lam5_3;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Y5_3 = 0.25 * Y4_3 + 0.25 * lam5_3;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double Z5_3 = 0.25 * Z4_3 + 0.25 * lam5_3;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dx_3 = over1_0 * (-X5_2 + mean_2) + over2_0 * (-X5_1 + mean_1) + over3_0 * (-X5_0 + mean_0) +
        over_0 * (-X5_3 + mean_3);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dy_3 = over1_0 * (-Y5_2 + mean_2) + over2_0 * (-Y5_1 + mean_1) + over3_0 * (-Y5_0 + mean_0) +
        over_0 * (-Y5_3 + mean_3);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E2_3 = xy_3 - 6.0 * zz_3;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E3_3 = dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 -
        8.0 * zz_1) + dz_3 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E4_3 = zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 -
        3.0 * zz_1) + zz_3 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
    const double E5_3 = dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1
        * zz_1 + xy_2 * zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double series_2 = 0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 +
        0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 + 0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 *
        E5_2;
    const double series_3 = 0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 +
        0.20454545454545456 * E2_1 * E2_2 - 0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 -
        0.17307692307692307 * E2_3 * E3_0 - 0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 -
        0.13636363636363635 * E4_3 + 0.11538461538461539 * E5_3;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double R_3 = 0.000244140625 * last_3 + 3.0 * term03_0 + 0.75 * term13_0 + 0.1875 * term23_0 + 0.046875 *
        term33_0 + 0.01171875 * term43_0 + 0.0029296875 * term53_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double x2_2 = x2 * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2_2;
    const double x2_3 = x2 * x2_2;
    const double V8 = -3.2000000000000002 * R_3 * third * x2_3;
    const double g_1_2 = g_1 * g_1;
    const double g_1_3 = g_1 * g_1_2;
    const double term_1 = 0.0079187627589685176 * g_1_3;
    const double t1 = 1.0 - 0.99379661859049351 * t0;
    const double tangent_1 = 3.975186474361974 * t0 / (t1 * t1);
    const double g_2_2 = g_2 * g_2;
    const double g_2_3 = g_2 * g_2_2;
    const double term_2 = 0.017868209707994881 * g_2_3;
    const double t2 = 1.0 - 0.96760297675669993 * t0;
    const double tangent_2 = 3.8704119070267997 * t0 / (t2 * t2);
    const double g_3_2 = g_3 * g_3;
    const double g_3_3 = g_3 * g_3_2;
    const double term_3 = 0.026529195202345292 * g_3_3;
    const double t3 = 1.0 - 0.92164198121722729 * t0;
    const double tangent_3 = 3.6865679248689092 * t0 / (t3 * t3);
    const double g_4_2 = g_4 * g_4;
    const double g_4_3 = g_4 * g_4_2;
    const double term_4 = 0.033283752629548087 * g_4_3;
    const double t4 = 1.0 - 0.85784652785798998 * t0;
    const double tangent_4 = 3.4313861114319599 * t0 / (t4 * t4);
    const double g_5_2 = g_5 * g_5;
    const double g_5_3 = g_5 * g_5_2;
    const double term_5 = 0.037701475910699687 * g_5_3;
    const double t5 = 1.0 - 0.77891309933755515 * t0;
    const double tangent_5 = 3.1156523973502206 * t0 / (t5 * t5);
    const double g_6_2 = g_6 * g_6;
    const double g_6_3 = g_6 * g_6_2;
    const double term_6 = 0.039565603112029335 * g_6_3;
    const double t6 = 1.0 - 0.68817935411770381 * t0;
    const double tangent_6 = 2.7527174164708152 * t0 / (t6 * t6);
    const double g_7_2 = g_7 * g_7;
    const double g_7_3 = g_7 * g_7_2;
    const double term_7 = 0.038890633201099367 * g_7_3;
    const double t7 = 1.0 - 0.58948218524948104 * t0;
    const double tangent_7 = 2.3579287409979242 * t0 / (t7 * t7);
    const double g_8_2 = g_8 * g_8;
    const double g_8_3 = g_8 * g_8_2;
    const double term_8 = 0.035918814009150916 * g_8_3;
    const double t8 = 1.0 - 0.4869953130832757 * t0;
    const double tangent_8 = 1.9479812523331028 * t0 / (t8 * t8);
    const double g_9_2 = g_9 * g_9;
    const double g_9_3 = g_9 * g_9_2;
    const double term_9 = 0.031095279034110784 * g_9_3;
    const double t9 = 1.0 - 0.38505274377519932 * t0;
    const double tangent_9 = 1.5402109751007973 * t0 / (t9 * t9);
    const double g_10_2 = g_10 * g_10;
    const double g_10_3 = g_10 * g_10_2;
    const double term_10 = 0.025024138617737494 * g_10_3;
    const double t10 = 1.0 - 0.28796547636914854 * t0;
    const double tangent_10 = 1.1518619054765942 * t0 / (t10 * t10);
    const double g_11_2 = g_11 * g_11;
    const double g_11_3 = g_11 * g_11_2;
    const double term_11 = 0.018409690326775727 * g_11_3;
    const double t11 = 1.0 - 0.19983919110743342 * t0;
    const double tangent_11 = 0.79935676442973369 * t0 / (t11 * t11);
    const double g_12_2 = g_12 * g_12;
    const double g_12_3 = g_12 * g_12_2;
    const double term_12 = 0.011988330981934815 * g_12_3;
    const double t12 = 1.0 - 0.12440062341181206 * t0;
    const double tangent_12 = 0.49760249364724823 * t0 / (t12 * t12);
    const double g_13_2 = g_13 * g_13;
    const double g_13_3 = g_13 * g_13_2;
    const double term_13 = 0.0064576338222394032 * g_13_3;
    const double t13 = 1.0 - 0.064839964168231387 * t0;
    const double tangent_13 = 0.25935985667292555 * t0 / (t13 * t13);
    const double g_14_2 = g_14 * g_14;
    const double g_14_3 = g_14 * g_14_2;
    const double term_14 = 0.0024093212835082948 * g_14_3;
    const double t14 = 1.0 - 0.023675950313912963 * t0;
    const double tangent_14 = 0.094703801255651851 * t0 / (t14 * t14);
    const double g_15_2 = g_15 * g_15;
    const double g_15_3 = g_15 * g_15_2;
    const double term_15 = 0.00027249273519073196 * g_15_3;
    const double t15 = 1.0 - 0.0026493505760394136 * t0;
    const double tangent_15 = 0.010597402304157654 * t0 / (t15 * t15);
    const double sum_0 = term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 +
        term_4 + term_5 + term_6 + term_7 + term_8 + term_9;
    const double sum_1 = tangent_1 * term_1 + tangent_10 * term_10 + tangent_11 * term_11 + tangent_12 * term_12 +
        tangent_13 * term_13 + tangent_14 * term_14 + tangent_15 * term_15 + tangent_2 * term_2 + tangent_3 * term_3
        + tangent_4 * term_4 + tangent_5 * term_5 + tangent_6 * term_6 + tangent_7 * term_7 + tangent_8 * term_8 +
        tangent_9 * term_9;
    const double tangent_1_2 = tangent_1 * tangent_1;
    const double tangent_10_2 = tangent_10 * tangent_10;
    const double tangent_11_2 = tangent_11 * tangent_11;
    const double tangent_12_2 = tangent_12 * tangent_12;
    const double tangent_13_2 = tangent_13 * tangent_13;
    const double tangent_14_2 = tangent_14 * tangent_14;
    const double tangent_15_2 = tangent_15 * tangent_15;
    const double tangent_2_2 = tangent_2 * tangent_2;
    const double tangent_3_2 = tangent_3 * tangent_3;
    const double tangent_4_2 = tangent_4 * tangent_4;
    const double tangent_5_2 = tangent_5 * tangent_5;
    const double tangent_6_2 = tangent_6 * tangent_6;
    const double tangent_7_2 = tangent_7 * tangent_7;
    const double tangent_8_2 = tangent_8 * tangent_8;
    const double tangent_9_2 = tangent_9 * tangent_9;
    const double sum_2 = tangent_10_2 * term_10 + tangent_11_2 * term_11 + tangent_12_2 * term_12 + tangent_13_2 *
        term_13 + tangent_14_2 * term_14 + tangent_15_2 * term_15 + tangent_1_2 * term_1 + tangent_2_2 * term_2 +
        tangent_3_2 * term_3 + tangent_4_2 * term_4 + tangent_5_2 * term_5 + tangent_6_2 * term_6 + tangent_7_2 *
        term_7 + tangent_8_2 * term_8 + tangent_9_2 * term_9;
    const double tangent_1_3 = tangent_1 * tangent_1_2;
    const double tangent_10_3 = tangent_10 * tangent_10_2;
    const double tangent_11_3 = tangent_11 * tangent_11_2;
    const double tangent_12_3 = tangent_12 * tangent_12_2;
    const double tangent_13_3 = tangent_13 * tangent_13_2;
    const double tangent_14_3 = tangent_14 * tangent_14_2;
    const double tangent_15_3 = tangent_15 * tangent_15_2;
    const double tangent_2_3 = tangent_2 * tangent_2_2;
    const double tangent_3_3 = tangent_3 * tangent_3_2;
    const double tangent_4_3 = tangent_4 * tangent_4_2;
    const double tangent_5_3 = tangent_5 * tangent_5_2;
    const double tangent_6_3 = tangent_6 * tangent_6_2;
    const double tangent_7_3 = tangent_7 * tangent_7_2;
    const double tangent_8_3 = tangent_8 * tangent_8_2;
    const double tangent_9_3 = tangent_9 * tangent_9_2;
    const double sum_3 = tangent_10_3 * term_10 + tangent_11_3 * term_11 + tangent_12_3 * term_12 + tangent_13_3 *
        term_13 + tangent_14_3 * term_14 + tangent_15_3 * term_15 + tangent_1_3 * term_1 + tangent_2_3 * term_2 +
        tangent_3_3 * term_3 + tangent_4_3 * term_4 + tangent_5_3 * term_5 + tangent_6_3 * term_6 + tangent_7_3 *
        term_7 + tangent_8_3 * term_8 + tangent_9_3 * term_9;
    const double T3 = T * t0;
    out[0] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0;
    out[2] = 2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c -
        6.0 * V2 - 7.0 * V4 - 3.0 * V6) / A;
    out[3] = 2.5464790894703255 * beta * (-192.0 * T3 * sum_0 / c - 384.0 * T3 * sum_1 / c - 360.0 * T3 * sum_2 /
        c - 120.0 * T3 * sum_3 / c + 24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8) / A2;
    out[4] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2);
    out[5] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4);
    out[6] = 2.5464790894703255 * A * beta * (24.0 * T3 * sum_0 / c + 8.0 * T3 * sum_1 / c - 3.0 * V2 - V4);
}

static inline void rod_spring_untruncated_averaged_all_passed_1_steep_away(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double c2 = c * c;
    const double lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0);
    const double half = 0.5 * (A - u_cr) * (A + u_cr);
    const double root = sqrt(2.0 * half - 0.5 * fabs(half - lacking) + 0.5 * fabs(half + lacking));
    const double A2 = A * A;
    const double x2 = u_cr * u_cr / A2;
    const double y2 = root * root / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double a0_half_0_2 = a0_half_0 * a0_half_0;
    const double a0_half_0_3 = a0_half_0 * a0_half_0_2;
    const double a02_0 = -a0_half_0_3;
    const double a03_0 = -2.0 * a02_0 * a0_half_0_2;
    const double b0_0 = sqrt(c2);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double lam0_2 = a02_0 * b0_0 + a02_0;
    const double lam0_3 = a03_0 * b0_0 + a03_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double X0_2 = 0.25 * lam0_2;
    const double X0_3 = 0.25 * lam0_3;
    const double Y0_0 = 0.25 * c2 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Y0_2 = 0.25 * lam0_2;
    const double Y0_3 = 0.25 * lam0_3;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double Z0_3 = 0.25 * lam0_3;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double a13_0 = a1_half_0 * (X0_3 - 2.0 * a11_0 * a12_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double b13_0 = b1_half_0 * (Y0_3 - 2.0 * b11_0 * b12_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double c13_0 = c1_half_0 * (Z0_3 - 2.0 * c11_0 * c12_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double lam1_3 = a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * (a12_0 + b12_0) +
        c12_0 * (a11_0 + b11_0) + c13_0 * (a1_0 + b1_0) + c1_0 * (a13_0 + b13_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double q1_3 = Z0_3 + lam1_3;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double X1_3 = 0.25 * X0_3 + 0.25 * lam1_3;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Y1_3 = 0.25 * Y0_3 + 0.25 * lam1_3;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double Z1_3 = 0.25 * Z0_3 + 0.25 * lam1_3;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double a23_0 = a2_half_0 * (X1_3 - 2.0 * a21_0 * a22_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double b23_0 = b2_half_0 * (Y1_3 - 2.0 * b21_0 * b22_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double c23_0 = c2_half_0 * (Z1_3 - 2.0 * c21_0 * c22_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double lam2_3 = a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * (a22_0 + b22_0) +
        c22_0 * (a21_0 + b21_0) + c23_0 * (a2_0 + b2_0) + c2_0 * (a23_0 + b23_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double q2_3 = Z1_3 + lam2_3;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double below2_3 = c21_0 * q2_2 + c22_0 * q2_1 + c23_0 * q2_0 + c2_0 * q2_3;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double term23_0 = -term2_0 * (below2_1 * term22_0 + below2_2 * term21_0 + below2_3 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double X2_3 = 0.25 * X1_3 + 0.25 * lam2_3;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Y2_3 = 0.25 * Y1_3 + 0.25 * lam2_3;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double Z2_3 = 0.25 * Z1_3 + 0.25 * lam2_3;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double a33_0 = a3_half_0 * (X2_3 - 2.0 * a31_0 * a32_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double b33_0 = b3_half_0 * (Y2_3 - 2.0 * b31_0 * b32_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double c33_0 = c3_half_0 * (Z2_3 - 2.0 * c31_0 * c32_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double lam3_3 = a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * (a32_0 + b32_0) +
        c32_0 * (a31_0 + b31_0) + c33_0 * (a3_0 + b3_0) + c3_0 * (a33_0 + b33_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double q3_3 = Z2_3 + lam3_3;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double below3_3 = c31_0 * q3_2 + c32_0 * q3_1 + c33_0 * q3_0 + c3_0 * q3_3;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double term33_0 = -term3_0 * (below3_1 * term32_0 + below3_2 * term31_0 + below3_3 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double X3_3 = 0.25 * X2_3 + 0.25 * lam3_3;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Y3_3 = 0.25 * Y2_3 + 0.25 * lam3_3;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double Z3_3 = 0.25 * Z2_3 + 0.25 * lam3_3;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double a43_0 = a4_half_0 * (X3_3 - 2.0 * a41_0 * a42_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double b43_0 = b4_half_0 * (Y3_3 - 2.0 * b41_0 * b42_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double c43_0 = c4_half_0 * (Z3_3 - 2.0 * c41_0 * c42_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double lam4_3 = a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * (a42_0 + b42_0) +
        c42_0 * (a41_0 + b41_0) + c43_0 * (a4_0 + b4_0) + c4_0 * (a43_0 + b43_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double q4_3 = Z3_3 + lam4_3;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double below4_3 = c41_0 * q4_2 + c42_0 * q4_1 + c43_0 * q4_0 + c4_0 * q4_3;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double term43_0 = -term4_0 * (below4_1 * term42_0 + below4_2 * term41_0 + below4_3 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double X4_3 = 0.25 * X3_3 + 0.25 * lam4_3;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Y4_3 = 0.25 * Y3_3 + 0.25 * lam4_3;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double Z4_3 = 0.25 * Z3_3 + 0.25 * lam4_3;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double a53_0 = a5_half_0 * (X4_3 - 2.0 * a51_0 * a52_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double b53_0 = b5_half_0 * (Y4_3 - 2.0 * b51_0 * b52_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double c53_0 = c5_half_0 * (Z4_3 - 2.0 * c51_0 * c52_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double lam5_3 = a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * (a52_0 + b52_0) +
        c52_0 * (a51_0 + b51_0) + c53_0 * (a5_0 + b5_0) + c5_0 * (a53_0 + b53_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double q5_3 = Z4_3 + lam5_3;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double below5_3 = c51_0 * q5_2 + c52_0 * q5_1 + c53_0 * q5_0 + c5_0 * q5_3;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double term53_0 = -term5_0 * (below5_1 * term52_0 + below5_2 * term51_0 + below5_3 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double X5_3 = 0.25 * X4_3 + 0.25 * lam5_3;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Y5_3 = 0.25 * Y4_3 + 0.25 * lam5_3;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double Z5_3 = 0.25 * Z4_3 + 0.25 * lam5_3;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dx_3 = over1_0 * (-X5_2 + mean_2) + over2_0 * (-X5_1 + mean_1) + over3_0 * (-X5_0 + mean_0) +
        over_0 * (-X5_3 + mean_3);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dy_3 = over1_0 * (-Y5_2 + mean_2) + over2_0 * (-Y5_1 + mean_1) + over3_0 * (-Y5_0 + mean_0) +
        over_0 * (-Y5_3 + mean_3);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E2_3 = xy_3 - 6.0 * zz_3;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E3_3 = dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 -
        8.0 * zz_1) + dz_3 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E4_3 = zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 -
        3.0 * zz_1) + zz_3 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
    const double E5_3 = dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1
        * zz_1 + xy_2 * zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double series_2 = 0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 +
        0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 + 0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 *
        E5_2;
    const double series_3 = 0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 +
        0.20454545454545456 * E2_1 * E2_2 - 0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 -
        0.17307692307692307 * E2_3 * E3_0 - 0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 -
        0.13636363636363635 * E4_3 + 0.11538461538461539 * E5_3;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double R_3 = 0.000244140625 * last_3 + 3.0 * term03_0 + 0.75 * term13_0 + 0.1875 * term23_0 + 0.046875 *
        term33_0 + 0.01171875 * term43_0 + 0.0029296875 * term53_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double x2_2 = x2 * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2_2;
    const double x2_3 = x2 * x2_2;
    const double V8 = -3.2000000000000002 * R_3 * third * x2_3;
    const double theta = angles_atan2_swapped(root, u_cr);
    const double tangent = u_cr / root;
    const double sum_0 = 0.5 * theta - 0.5 * root * u_cr / A2;
    const double tangents_1 = tangent - theta;
    const double sum_1 = -sum_0 + tangents_1;
    const double tangent2 = tangent * tangent;
    const double tangent3 = tangent * tangent2;
    const double tangents_2 = 0.33333333333333331 * tangent3 - tangents_1;
    const double sum_2 = -sum_1 + tangents_2;
    const double tangent4 = tangent2 * tangent2;
    const double tangent5 = tangent * tangent4;
    const double tangents_3 = 0.20000000000000001 * tangent5 - tangents_2;
    const double sum_3 = -sum_2 + tangents_3;
    out[0] = 2.5464790894703255 * A * beta * (-V2 + sum_0 / c) - A;
    out[1] = 2.5464790894703255 * beta * (2.0 * V2 + V4 - 2.0 * sum_0 / c - sum_1 / c) - 1.0;
    out[2] = 2.5464790894703255 * beta * (-6.0 * V2 - 7.0 * V4 - 3.0 * V6 + 6.0 * sum_0 / c + 7.0 * sum_1 / c +
        3.0 * sum_2 / c) / A;
    out[3] = 2.5464790894703255 * beta * (24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8 - 24.0 * sum_0 / c - 48.0
        * sum_1 / c - 45.0 * sum_2 / c - 15.0 * sum_3 / c) / A2;
    out[4] = 2.5464790894703255 * A * beta * (-V2 + sum_0 / c);
    out[5] = 2.5464790894703255 * beta * (2.0 * V2 + V4 - 2.0 * sum_0 / c - sum_1 / c);
    out[6] = 2.5464790894703255 * A * beta * (-3.0 * V2 - V4 + 3.0 * sum_0 / c + sum_1 / c);
}

static inline void rod_spring_untruncated_averaged_all_passed_1_steep(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double c2 = c * c;
    const double lacking = c2 - (1.0 - u_cr) * (u_cr + 1.0);
    const double half = 0.5 * (A - u_cr) * (A + u_cr);
    const double root = sqrt(2.0 * half - 0.5 * fabs(half - lacking) + 0.5 * fabs(half + lacking));
    const double T = u_cr / (A + root);
    const double t0 = T * T;
    const double g_1 = 1.0 / (0.99379661859049351 * t0 + 1.0);
    const double g_2 = 1.0 / (0.96760297675669993 * t0 + 1.0);
    const double g_3 = 1.0 / (0.92164198121722729 * t0 + 1.0);
    const double g_4 = 1.0 / (0.85784652785798998 * t0 + 1.0);
    const double g_5 = 1.0 / (0.77891309933755515 * t0 + 1.0);
    const double g_6 = 1.0 / (0.68817935411770381 * t0 + 1.0);
    const double g_7 = 1.0 / (0.58948218524948104 * t0 + 1.0);
    const double g_8 = 1.0 / (0.4869953130832757 * t0 + 1.0);
    const double g_9 = 1.0 / (0.38505274377519932 * t0 + 1.0);
    const double g_10 = 1.0 / (0.28796547636914854 * t0 + 1.0);
    const double g_11 = 1.0 / (0.19983919110743342 * t0 + 1.0);
    const double g_12 = 1.0 / (0.12440062341181206 * t0 + 1.0);
    const double g_13 = 1.0 / (0.064839964168231387 * t0 + 1.0);
    const double g_14 = 1.0 / (0.023675950313912963 * t0 + 1.0);
    const double g_15 = 1.0 / (0.0026493505760394136 * t0 + 1.0);
    const double u_cr2 = u_cr * u_cr;
    const double A2 = A * A;
    const double x2 = u_cr2 / A2;
    const double root2 = root * root;
    const double y2 = root2 / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(c2);
    const double b0_half_0 = 0.5 / b0_0;
    const double b0_half_0_2 = b0_half_0 * b0_half_0;
    const double b0_half_0_3 = b0_half_0 * b0_half_0_2;
    const double b02_0 = -b0_half_0_3;
    const double b03_0 = -2.0 * b02_0 * b0_half_0_2;
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_0 * b0_half_0 + b0_half_0;
    const double lam0_2 = a0_0 * b02_0 + b02_0;
    const double lam0_3 = a0_0 * b03_0 + b03_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double term03_0 = -term0_0 * (lam0_1 * term02_0 + lam0_2 * term01_0 + lam0_3 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1;
    const double X0_2 = 0.25 * lam0_2;
    const double X0_3 = 0.25 * lam0_3;
    const double Y0_0 = 0.25 * c2 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1 + 0.25;
    const double Y0_2 = 0.25 * lam0_2;
    const double Y0_3 = 0.25 * lam0_3;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double Z0_3 = 0.25 * lam0_3;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double a13_0 = a1_half_0 * (X0_3 - 2.0 * a11_0 * a12_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double b13_0 = b1_half_0 * (Y0_3 - 2.0 * b11_0 * b12_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double c13_0 = c1_half_0 * (Z0_3 - 2.0 * c11_0 * c12_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double lam1_3 = a11_0 * b12_0 + a12_0 * b11_0 + a13_0 * b1_0 + a1_0 * b13_0 + c11_0 * (a12_0 + b12_0) +
        c12_0 * (a11_0 + b11_0) + c13_0 * (a1_0 + b1_0) + c1_0 * (a13_0 + b13_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double q1_3 = Z0_3 + lam1_3;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double below1_3 = c11_0 * q1_2 + c12_0 * q1_1 + c13_0 * q1_0 + c1_0 * q1_3;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double term13_0 = -term1_0 * (below1_1 * term12_0 + below1_2 * term11_0 + below1_3 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double X1_3 = 0.25 * X0_3 + 0.25 * lam1_3;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Y1_3 = 0.25 * Y0_3 + 0.25 * lam1_3;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double Z1_3 = 0.25 * Z0_3 + 0.25 * lam1_3;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double a23_0 = a2_half_0 * (X1_3 - 2.0 * a21_0 * a22_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double b23_0 = b2_half_0 * (Y1_3 - 2.0 * b21_0 * b22_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double c23_0 = c2_half_0 * (Z1_3 - 2.0 * c21_0 * c22_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double lam2_3 = a21_0 * b22_0 + a22_0 * b21_0 + a23_0 * b2_0 + a2_0 * b23_0 + c21_0 * (a22_0 + b22_0) +
        c22_0 * (a21_0 + b21_0) + c23_0 * (a2_0 + b2_0) + c2_0 * (a23_0 + b23_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double q2_3 = Z1_3 + lam2_3;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double below2_3 = c21_0 * q2_2 + c22_0 * q2_1 + c23_0 * q2_0 + c2_0 * q2_3;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double term23_0 = -term2_0 * (below2_1 * term22_0 + below2_2 * term21_0 + below2_3 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double X2_3 = 0.25 * X1_3 + 0.25 * lam2_3;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Y2_3 = 0.25 * Y1_3 + 0.25 * lam2_3;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double Z2_3 = 0.25 * Z1_3 + 0.25 * lam2_3;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double a33_0 = a3_half_0 * (X2_3 - 2.0 * a31_0 * a32_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double b33_0 = b3_half_0 * (Y2_3 - 2.0 * b31_0 * b32_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double c33_0 = c3_half_0 * (Z2_3 - 2.0 * c31_0 * c32_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double lam3_3 = a31_0 * b32_0 + a32_0 * b31_0 + a33_0 * b3_0 + a3_0 * b33_0 + c31_0 * (a32_0 + b32_0) +
        c32_0 * (a31_0 + b31_0) + c33_0 * (a3_0 + b3_0) + c3_0 * (a33_0 + b33_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double q3_3 = Z2_3 + lam3_3;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double below3_3 = c31_0 * q3_2 + c32_0 * q3_1 + c33_0 * q3_0 + c3_0 * q3_3;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double term33_0 = -term3_0 * (below3_1 * term32_0 + below3_2 * term31_0 + below3_3 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double X3_3 = 0.25 * X2_3 + 0.25 * lam3_3;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Y3_3 = 0.25 * Y2_3 + 0.25 * lam3_3;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double Z3_3 = 0.25 * Z2_3 + 0.25 * lam3_3;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double a43_0 = a4_half_0 * (X3_3 - 2.0 * a41_0 * a42_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double b43_0 = b4_half_0 * (Y3_3 - 2.0 * b41_0 * b42_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double c43_0 = c4_half_0 * (Z3_3 - 2.0 * c41_0 * c42_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double lam4_3 = a41_0 * b42_0 + a42_0 * b41_0 + a43_0 * b4_0 + a4_0 * b43_0 + c41_0 * (a42_0 + b42_0) +
        c42_0 * (a41_0 + b41_0) + c43_0 * (a4_0 + b4_0) + c4_0 * (a43_0 + b43_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double q4_3 = Z3_3 + lam4_3;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double below4_3 = c41_0 * q4_2 + c42_0 * q4_1 + c43_0 * q4_0 + c4_0 * q4_3;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double term43_0 = -term4_0 * (below4_1 * term42_0 + below4_2 * term41_0 + below4_3 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double X4_3 = 0.25 * X3_3 + 0.25 * lam4_3;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Y4_3 = 0.25 * Y3_3 + 0.25 * lam4_3;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double Z4_3 = 0.25 * Z3_3 + 0.25 * lam4_3;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double a53_0 = a5_half_0 * (X4_3 - 2.0 * a51_0 * a52_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double b53_0 = b5_half_0 * (Y4_3 - 2.0 * b51_0 * b52_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double c53_0 = c5_half_0 * (Z4_3 - 2.0 * c51_0 * c52_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double lam5_3 = a51_0 * b52_0 + a52_0 * b51_0 + a53_0 * b5_0 + a5_0 * b53_0 + c51_0 * (a52_0 + b52_0) +
        c52_0 * (a51_0 + b51_0) + c53_0 * (a5_0 + b5_0) + c5_0 * (a53_0 + b53_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double q5_3 = Z4_3 + lam5_3;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double below5_3 = c51_0 * q5_2 + c52_0 * q5_1 + c53_0 * q5_0 + c5_0 * q5_3;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double term53_0 = -term5_0 * (below5_1 * term52_0 + below5_2 * term51_0 + below5_3 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double X5_3 = 0.25 * X4_3 + 0.25 * lam5_3;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Y5_3 = 0.25 * Y4_3 + 0.25 * lam5_3;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double Z5_3 = 0.25 * Z4_3 + 0.25 * lam5_3;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double mean_3 = 0.20000000000000001 * X5_3 + 0.20000000000000001 * Y5_3 + 0.59999999999999998 * Z5_3;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double over3_0 = -over_0 * (mean_1 * over2_0 + mean_2 * over1_0 + mean_3 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dx_3 = over1_0 * (-X5_2 + mean_2) + over2_0 * (-X5_1 + mean_1) + over3_0 * (-X5_0 + mean_0) +
        over_0 * (-X5_3 + mean_3);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dy_3 = over1_0 * (-Y5_2 + mean_2) + over2_0 * (-Y5_1 + mean_1) + over3_0 * (-Y5_0 + mean_0) +
        over_0 * (-Y5_3 + mean_3);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double dz_3 = -0.33333333333333331 * dx_3 - 0.33333333333333331 * dy_3;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double xy_3 = dx_0 * dy_3 + dx_1 * dy_2 + dx_2 * dy_1 + dx_3 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double zz_3 = 2.0 * dz_0 * dz_3 + 2.0 * dz_1 * dz_2;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E2_3 = xy_3 - 6.0 * zz_3;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E3_3 = dz_0 * (3.0 * xy_3 - 8.0 * zz_3) + dz_1 * (3.0 * xy_2 - 8.0 * zz_2) + dz_2 * (3.0 * xy_1 -
        8.0 * zz_1) + dz_3 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E4_3 = zz_0 * (3.0 * xy_3 - 3.0 * zz_3) + zz_1 * (3.0 * xy_2 - 3.0 * zz_2) + zz_2 * (3.0 * xy_1 -
        3.0 * zz_1) + zz_3 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
    const double E5_3 = dz_0 * (xy_0 * zz_3 + xy_1 * zz_2 + xy_2 * zz_1 + xy_3 * zz_0) + dz_1 * (xy_0 * zz_2 + xy_1
        * zz_1 + xy_2 * zz_0) + dz_2 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_3 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double series_2 = 0.20454545454545456 * E2_0 * E2_2 - 0.17307692307692307 * E2_0 * E3_2 +
        0.10227272727272728 * E2_1 * E2_1 - 0.17307692307692307 * E2_1 * E3_1 - 0.17307692307692307 * E2_2 * E3_0 -
        0.21428571428571427 * E2_2 + 0.16666666666666666 * E3_2 - 0.13636363636363635 * E4_2 + 0.11538461538461539 *
        E5_2;
    const double series_3 = 0.20454545454545456 * E2_0 * E2_3 - 0.17307692307692307 * E2_0 * E3_3 +
        0.20454545454545456 * E2_1 * E2_2 - 0.17307692307692307 * E2_1 * E3_2 - 0.17307692307692307 * E2_2 * E3_1 -
        0.17307692307692307 * E2_3 * E3_0 - 0.21428571428571427 * E2_3 + 0.16666666666666666 * E3_3 -
        0.13636363636363635 * E4_3 + 0.11538461538461539 * E5_3;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double sq3_0 = sq_half_0 * (over3_0 - 2.0 * sq1_0 * sq2_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double power_3 = over1_0 * sq2_0 + over2_0 * sq1_0 + over3_0 * sq_0 + over_0 * sq3_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double R_3 = 0.000244140625 * last_3 + 3.0 * term03_0 + 0.75 * term13_0 + 0.1875 * term23_0 + 0.046875 *
        term33_0 + 0.01171875 * term43_0 + 0.0029296875 * term53_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double x2_2 = x2 * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2_2;
    const double x2_3 = x2 * x2_2;
    const double V8 = -3.2000000000000002 * R_3 * third * x2_3;
    const double g_1_2 = g_1 * g_1;
    const double g_1_3 = g_1 * g_1_2;
    const double term_1 = 0.0079187627589685176 * g_1_3;
    const double g_2_2 = g_2 * g_2;
    const double g_2_3 = g_2 * g_2_2;
    const double term_2 = 0.017868209707994881 * g_2_3;
    const double g_3_2 = g_3 * g_3;
    const double g_3_3 = g_3 * g_3_2;
    const double term_3 = 0.026529195202345292 * g_3_3;
    const double g_4_2 = g_4 * g_4;
    const double g_4_3 = g_4 * g_4_2;
    const double term_4 = 0.033283752629548087 * g_4_3;
    const double g_5_2 = g_5 * g_5;
    const double g_5_3 = g_5 * g_5_2;
    const double term_5 = 0.037701475910699687 * g_5_3;
    const double g_6_2 = g_6 * g_6;
    const double g_6_3 = g_6 * g_6_2;
    const double term_6 = 0.039565603112029335 * g_6_3;
    const double g_7_2 = g_7 * g_7;
    const double g_7_3 = g_7 * g_7_2;
    const double term_7 = 0.038890633201099367 * g_7_3;
    const double g_8_2 = g_8 * g_8;
    const double g_8_3 = g_8 * g_8_2;
    const double term_8 = 0.035918814009150916 * g_8_3;
    const double g_9_2 = g_9 * g_9;
    const double g_9_3 = g_9 * g_9_2;
    const double term_9 = 0.031095279034110784 * g_9_3;
    const double g_10_2 = g_10 * g_10;
    const double g_10_3 = g_10 * g_10_2;
    const double term_10 = 0.025024138617737494 * g_10_3;
    const double g_11_2 = g_11 * g_11;
    const double g_11_3 = g_11 * g_11_2;
    const double term_11 = 0.018409690326775727 * g_11_3;
    const double g_12_2 = g_12 * g_12;
    const double g_12_3 = g_12 * g_12_2;
    const double term_12 = 0.011988330981934815 * g_12_3;
    const double g_13_2 = g_13 * g_13;
    const double g_13_3 = g_13 * g_13_2;
    const double term_13 = 0.0064576338222394032 * g_13_3;
    const double g_14_2 = g_14 * g_14;
    const double g_14_3 = g_14 * g_14_2;
    const double term_14 = 0.0024093212835082948 * g_14_3;
    const double g_15_2 = g_15 * g_15;
    const double g_15_3 = g_15 * g_15_2;
    const double term_15 = 0.00027249273519073196 * g_15_3;
    const double sum_0 = term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 +
        term_4 + term_5 + term_6 + term_7 + term_8 + term_9;
    const double T3 = T * t0;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c3 = c * c2;
    const double root3 = root * root2;
    const double A4 = A2 * A2;
    const double c4 = c2 * c2;
    const double c5 = c * c4;
    out[0] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
    out[1] = -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0;
    out[2] = -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root));
    out[3] = -2.5464790894703255 * beta * (3.0 * A2 * (5.0 * A2 * V8 + 6.0 * V6) + 3.0 * V4 - 3.0 * u_cr5 / (A4 *
        c5 * root) + 3.0 * u_cr5 / (A4 * c3 * root) + u_cr5 / (A2 * c3 * root3));
    out[4] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2);
    out[5] = -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2);
    out[6] = 2.5464790894703255 * A3 * V4 * beta;
}

static inline void rod_spring_untruncated_averaged_all(double A, const double *p, double *out)
{
    const double delta_h = p[2];
    if ((A <= sqrt(-delta_h * delta_h + 2.0 * delta_h)) && (sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A)) {
        rod_spring_untruncated_averaged_all_passed_0_end(A, p, out);
        return;
    }
    if ((A <= sqrt(-delta_h * delta_h + 2.0 * delta_h)) && (A <= 0.69999999999999996)) {
        rod_spring_untruncated_averaged_all_passed_0(A, p, out);
        return;
    }
    if (A <= sqrt(-delta_h * delta_h + 2.0 * delta_h)) {
        rod_spring_untruncated_averaged_all_passed_0_steep(A, p, out);
        return;
    }
    if ((sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75) && (1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A)) {
        rod_spring_untruncated_averaged_all_passed_1_far(A, p, out);
        return;
    }
    if (sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75) {
        rod_spring_untruncated_averaged_all_passed_1(A, p, out);
        return;
    }
    if ((sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004) && (1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A)) {
        rod_spring_untruncated_averaged_all_passed_1_steeper_far(A, p, out);
        return;
    }
    if (1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A) {
        rod_spring_untruncated_averaged_all_passed_1_steep_far(A, p, out);
        return;
    }
    if (sqrt(-0.75 * delta_h * delta_h + 1.5 * delta_h + 0.25) <= A) {
        rod_spring_untruncated_averaged_all_passed_1_steep_away(A, p, out);
        return;
    }
    rod_spring_untruncated_averaged_all_passed_1_steep(A, p, out);
}

/* Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.
   Equation beyond (20). Domain: A >= 0, u_cr <= 3/4.
   Operations where passed_0: 3592 structured, 2534 common subexpressions, 1528 power chains
   Operations where passed_1: 4336 structured, 4336 common subexpressions, 3503 power chains
 */
static inline void rod_spring_untruncated_harmonics_passed_0(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double t0 = 0.03925981575906861 * A;
    const double delta_1 = sqrt(1.0 - t0) * sqrt(t0 + 1.0);
    const double t1 = 0.11753739745783764 * A;
    const double delta_2 = sqrt(1.0 - t1) * sqrt(t1 + 1.0);
    const double t2 = 0.19509032201612828 * A;
    const double delta_3 = sqrt(1.0 - t2) * sqrt(t2 + 1.0);
    const double t3 = 0.27144044986507426 * A;
    const double delta_4 = sqrt(1.0 - t3) * sqrt(t3 + 1.0);
    const double t4 = 0.34611705707749296 * A;
    const double delta_5 = sqrt(1.0 - t4) * sqrt(t4 + 1.0);
    const double t5 = 0.41865973753742808 * A;
    const double delta_6 = sqrt(1.0 - t5) * sqrt(t5 + 1.0);
    const double t6 = 0.48862124149695496 * A;
    const double delta_7 = sqrt(1.0 - t6) * sqrt(t6 + 1.0);
    const double t7 = 0.55557023301960218 * A;
    const double delta_8 = sqrt(1.0 - t7) * sqrt(t7 + 1.0);
    const double t8 = 0.61909394930983397 * A;
    const double delta_9 = sqrt(1.0 - t8) * sqrt(t8 + 1.0);
    const double t9 = 0.67880074553294178 * A;
    const double delta_10 = sqrt(1.0 - t9) * sqrt(t9 + 1.0);
    const double t10 = 0.73432250943568556 * A;
    const double delta_11 = sqrt(1.0 - t10) * sqrt(t10 + 1.0);
    const double t11 = 0.78531693088074495 * A;
    const double delta_12 = sqrt(1.0 - t11) * sqrt(t11 + 1.0);
    const double t12 = 0.83146961230254524 * A;
    const double delta_13 = sqrt(1.0 - t12) * sqrt(t12 + 1.0);
    const double t13 = 0.87249600707279706 * A;
    const double delta_14 = sqrt(1.0 - t13) * sqrt(t13 + 1.0);
    const double t14 = 0.90814317382508125 * A;
    const double delta_15 = sqrt(1.0 - t14) * sqrt(t14 + 1.0);
    const double t15 = 0.93819133592248416 * A;
    const double delta_16 = sqrt(1.0 - t15) * sqrt(t15 + 1.0);
    const double t16 = 0.96245523645364728 * A;
    const double delta_17 = sqrt(1.0 - t16) * sqrt(t16 + 1.0);
    const double t17 = 0.98078528040323043 * A;
    const double delta_18 = sqrt(1.0 - t17) * sqrt(t17 + 1.0);
    const double t18 = 0.99306845695492629 * A;
    const double delta_19 = sqrt(1.0 - t18) * sqrt(t18 + 1.0);
    const double t19 = 0.9992290362407229 * A;
    const double delta_20 = sqrt(1.0 - t19) * sqrt(t19 + 1.0);
    const double A2 = A * A;
    const double delta_1_2 = delta_1 * delta_1;
    const double delta_1_3 = delta_1 * delta_1_2;
    const double delta_1_6 = delta_1_3 * delta_1_3;
    const double delta_1_7 = delta_1 * delta_1_6;
    const double delta_10_2 = delta_10 * delta_10;
    const double delta_10_3 = delta_10 * delta_10_2;
    const double delta_10_6 = delta_10_3 * delta_10_3;
    const double delta_10_7 = delta_10 * delta_10_6;
    const double delta_11_2 = delta_11 * delta_11;
    const double delta_11_3 = delta_11 * delta_11_2;
    const double delta_11_6 = delta_11_3 * delta_11_3;
    const double delta_11_7 = delta_11 * delta_11_6;
    const double delta_12_2 = delta_12 * delta_12;
    const double delta_12_3 = delta_12 * delta_12_2;
    const double delta_12_6 = delta_12_3 * delta_12_3;
    const double delta_12_7 = delta_12 * delta_12_6;
    const double delta_13_2 = delta_13 * delta_13;
    const double delta_13_3 = delta_13 * delta_13_2;
    const double delta_13_6 = delta_13_3 * delta_13_3;
    const double delta_13_7 = delta_13 * delta_13_6;
    const double delta_14_2 = delta_14 * delta_14;
    const double delta_14_3 = delta_14 * delta_14_2;
    const double delta_14_6 = delta_14_3 * delta_14_3;
    const double delta_14_7 = delta_14 * delta_14_6;
    const double delta_15_2 = delta_15 * delta_15;
    const double delta_15_3 = delta_15 * delta_15_2;
    const double delta_15_6 = delta_15_3 * delta_15_3;
    const double delta_15_7 = delta_15 * delta_15_6;
    const double delta_16_2 = delta_16 * delta_16;
    const double delta_16_3 = delta_16 * delta_16_2;
    const double delta_16_6 = delta_16_3 * delta_16_3;
    const double delta_16_7 = delta_16 * delta_16_6;
    const double delta_17_2 = delta_17 * delta_17;
    const double delta_17_3 = delta_17 * delta_17_2;
    const double delta_17_6 = delta_17_3 * delta_17_3;
    const double delta_17_7 = delta_17 * delta_17_6;
    const double delta_18_2 = delta_18 * delta_18;
    const double delta_18_3 = delta_18 * delta_18_2;
    const double delta_18_6 = delta_18_3 * delta_18_3;
    const double delta_18_7 = delta_18 * delta_18_6;
    const double delta_19_2 = delta_19 * delta_19;
    const double delta_19_3 = delta_19 * delta_19_2;
    const double delta_19_6 = delta_19_3 * delta_19_3;
    const double delta_19_7 = delta_19 * delta_19_6;
    const double delta_2_2 = delta_2 * delta_2;
    const double delta_2_3 = delta_2 * delta_2_2;
    const double delta_2_6 = delta_2_3 * delta_2_3;
    const double delta_2_7 = delta_2 * delta_2_6;
    const double delta_20_2 = delta_20 * delta_20;
    const double delta_20_3 = delta_20 * delta_20_2;
    const double delta_20_6 = delta_20_3 * delta_20_3;
    const double delta_20_7 = delta_20 * delta_20_6;
    const double delta_3_2 = delta_3 * delta_3;
    const double delta_3_3 = delta_3 * delta_3_2;
    const double delta_3_6 = delta_3_3 * delta_3_3;
    const double delta_3_7 = delta_3 * delta_3_6;
    const double delta_4_2 = delta_4 * delta_4;
    const double delta_4_3 = delta_4 * delta_4_2;
    const double delta_4_6 = delta_4_3 * delta_4_3;
    const double delta_4_7 = delta_4 * delta_4_6;
    const double delta_5_2 = delta_5 * delta_5;
    const double delta_5_3 = delta_5 * delta_5_2;
    const double delta_5_6 = delta_5_3 * delta_5_3;
    const double delta_5_7 = delta_5 * delta_5_6;
    const double delta_6_2 = delta_6 * delta_6;
    const double delta_6_3 = delta_6 * delta_6_2;
    const double delta_6_6 = delta_6_3 * delta_6_3;
    const double delta_6_7 = delta_6 * delta_6_6;
    const double delta_7_2 = delta_7 * delta_7;
    const double delta_7_3 = delta_7 * delta_7_2;
    const double delta_7_6 = delta_7_3 * delta_7_3;
    const double delta_7_7 = delta_7 * delta_7_6;
    const double delta_8_2 = delta_8 * delta_8;
    const double delta_8_3 = delta_8 * delta_8_2;
    const double delta_8_6 = delta_8_3 * delta_8_3;
    const double delta_8_7 = delta_8 * delta_8_6;
    const double delta_9_2 = delta_9 * delta_9;
    const double delta_9_3 = delta_9 * delta_9_2;
    const double delta_9_6 = delta_9_3 * delta_9_3;
    const double delta_9_7 = delta_9 * delta_9_6;
    const double moment_3_0 = (1.078857608738002 * A2 + 0.70370561853545532) / delta_9_7 + (1.2238761547735966 * A2
        + 0.99128730617304139) / delta_8_7 + (1.2638822667231533 * A2 + 1.3234329504908273) / delta_7_7 +
        (1.1798575525493606 * A2 + 1.6828569159709947) / delta_6_7 + (0.98033782288107651 * A2 + 2.0458310352680531)
        / delta_5_7 + (0.70277065253081572 * A2 + 2.3845393470019518) / delta_4_7 + (0.40653349460986854 * A2 +
        2.6703297287956573) / delta_3_7 + (0.15900416907605983 * A2 + 2.8773744296901924) / delta_2_7 +
        (4.387335843990627e-08 * A2 + 1.0985271573031875e-08) / delta_20_7 + (0.01841060387494697 * A2 +
        2.9861493721842582) / delta_1_7 + (3.1202977825571887e-05 * A2 + 7.9100217213007941e-06) / delta_19_7 +
        (0.00063641950022080916 * A2 + 0.00016540003920881557) / delta_18_7 + (0.0044462074693628712 * A2 +
        0.0011999652050383473) / delta_17_7 + (0.018159425144091645 * A2 + 0.0051577379022065628) / delta_16_7 +
        (0.053291393036153767 * A2 + 0.016154310858745517) / delta_15_7 + (0.12432034288634558 * A2 +
        0.040827737302182587) / delta_14_7 + (0.24395393111631411 * A2 + 0.088217564992092656) / delta_13_7 +
        (0.41668754959843518 * A2 + 0.1689120417526308) / delta_12_7 + (0.63300740697659963 * A2 +
        0.29347770790944422) / delta_11_7 + (0.86693575166441239 * A2 + 0.47037290892102585) / delta_10_7;
    const double delta_5_4 = delta_5_2 * delta_5_2;
    const double delta_5_8 = delta_5_4 * delta_5_4;
    const double delta_5_9 = delta_5 * delta_5_8;
    const double delta_16_4 = delta_16_2 * delta_16_2;
    const double delta_16_8 = delta_16_4 * delta_16_4;
    const double delta_16_9 = delta_16 * delta_16_8;
    const double delta_20_4 = delta_20_2 * delta_20_2;
    const double delta_20_8 = delta_20_4 * delta_20_4;
    const double delta_20_9 = delta_20 * delta_20_8;
    const double delta_12_4 = delta_12_2 * delta_12_2;
    const double delta_12_8 = delta_12_4 * delta_12_4;
    const double delta_12_9 = delta_12 * delta_12_8;
    const double delta_19_4 = delta_19_2 * delta_19_2;
    const double delta_19_8 = delta_19_4 * delta_19_4;
    const double delta_19_9 = delta_19 * delta_19_8;
    const double delta_14_4 = delta_14_2 * delta_14_2;
    const double delta_14_8 = delta_14_4 * delta_14_4;
    const double delta_14_9 = delta_14 * delta_14_8;
    const double delta_4_4 = delta_4_2 * delta_4_2;
    const double delta_4_8 = delta_4_4 * delta_4_4;
    const double delta_4_9 = delta_4 * delta_4_8;
    const double delta_17_4 = delta_17_2 * delta_17_2;
    const double delta_17_8 = delta_17_4 * delta_17_4;
    const double delta_17_9 = delta_17 * delta_17_8;
    const double delta_7_4 = delta_7_2 * delta_7_2;
    const double delta_7_8 = delta_7_4 * delta_7_4;
    const double delta_7_9 = delta_7 * delta_7_8;
    const double delta_15_4 = delta_15_2 * delta_15_2;
    const double delta_15_8 = delta_15_4 * delta_15_4;
    const double delta_15_9 = delta_15 * delta_15_8;
    const double delta_10_4 = delta_10_2 * delta_10_2;
    const double delta_10_8 = delta_10_4 * delta_10_4;
    const double delta_10_9 = delta_10 * delta_10_8;
    const double delta_18_4 = delta_18_2 * delta_18_2;
    const double delta_18_8 = delta_18_4 * delta_18_4;
    const double delta_18_9 = delta_18 * delta_18_8;
    const double delta_9_4 = delta_9_2 * delta_9_2;
    const double delta_9_8 = delta_9_4 * delta_9_4;
    const double delta_9_9 = delta_9 * delta_9_8;
    const double delta_1_4 = delta_1_2 * delta_1_2;
    const double delta_1_8 = delta_1_4 * delta_1_4;
    const double delta_1_9 = delta_1 * delta_1_8;
    const double delta_2_4 = delta_2_2 * delta_2_2;
    const double delta_2_8 = delta_2_4 * delta_2_4;
    const double delta_2_9 = delta_2 * delta_2_8;
    const double delta_8_4 = delta_8_2 * delta_8_2;
    const double delta_8_8 = delta_8_4 * delta_8_4;
    const double delta_8_9 = delta_8 * delta_8_8;
    const double delta_11_4 = delta_11_2 * delta_11_2;
    const double delta_11_8 = delta_11_4 * delta_11_4;
    const double delta_11_9 = delta_11 * delta_11_8;
    const double delta_13_4 = delta_13_2 * delta_13_2;
    const double delta_13_8 = delta_13_4 * delta_13_4;
    const double delta_13_9 = delta_13 * delta_13_8;
    const double delta_6_4 = delta_6_2 * delta_6_2;
    const double delta_6_8 = delta_6_4 * delta_6_4;
    const double delta_6_9 = delta_6 * delta_6_8;
    const double delta_3_4 = delta_3_2 * delta_3_2;
    const double delta_3_8 = delta_3_4 * delta_3_4;
    const double delta_3_9 = delta_3 * delta_3_8;
    const double moment_3_1 = 0.089904800728166839 * A * (22.996639084322837 * A2 + 45.0) / delta_9_9 +
        0.10198967956446638 * A * (18.519497029047308 * A2 + 45.0) / delta_8_9 + 0.10532352222692944 * A *
        (14.325043058521533 * A2 + 45.0) / delta_7_9 + 0.098321462712446725 * A * (10.516558550094491 * A2 + 45.0) /
        delta_6_9 + 0.081694818573423048 * A * (7.1878210319990723 * A2 + 45.0) / delta_5_9 + 0.058564221044234643 *
        A * (4.4207950693772338 * A2 + 45.0) / delta_4_9 + 0.033877791217489045 * A * (2.2836140246613974 * A2 +
        45.0) / delta_3_9 + 0.013250347423004984 * A * (0.82890238806970196 * A2 + 45.0) / delta_2_9 +
        3.6561132033255224e-09 * A * (59.907520011993839 * A2 + 45.0) / delta_20_9 + 0.0015342169895789142 * A *
        (0.09247998800616071 * A2 + 45.0) / delta_1_9 + 2.6002481521309901e-06 * A * (59.1710976119303 * A2 + 45.0)
        / delta_19_9 + 5.3034958351734099e-05 * A * (57.716385975338603 * A2 + 45.0) / delta_18_9 +
        0.0003705172891135726 * A * (55.579204930622765 * A2 + 45.0) / delta_17_9 + 0.0015132854286743038 * A *
        (52.812178968000929 * A2 + 45.0) / delta_16_9 + 0.0044409494196794809 * A * (49.483441449905513 * A2 + 45.0)
        / delta_15_9 + 0.010360028573862132 * A * (45.674956941478463 * A2 + 45.0) / delta_14_9 +
        0.020329494259692844 * A * (41.480502970952692 * A2 + 45.0) / delta_13_9 + 0.034723962466536265 * A *
        (37.003360915677163 * A2 + 45.0) / delta_12_9 + 0.052750617248049969 * A * (32.353772871835346 * A2 + 45.0)
        / delta_11_9 + 0.072244645972034366 * A * (27.64622712816465 * A2 + 45.0) / delta_10_9;
    const double delta_1_5 = delta_1 * delta_1_4;
    const double delta_1_10 = delta_1_5 * delta_1_5;
    const double delta_1_11 = delta_1 * delta_1_10;
    const double t20 = 1.0 / delta_1_11;
    const double t21 = A2 * (0.55487992803696429 * A2 + 540.0);
    const double delta_10_5 = delta_10 * delta_10_4;
    const double delta_10_10 = delta_10_5 * delta_10_5;
    const double delta_10_11 = delta_10 * delta_10_10;
    const double t22 = 1.0 / delta_10_11;
    const double t23 = A2 * (165.87736276898792 * A2 + 540.0);
    const double delta_11_5 = delta_11 * delta_11_4;
    const double delta_11_10 = delta_11_5 * delta_11_5;
    const double delta_11_11 = delta_11 * delta_11_10;
    const double t24 = 1.0 / delta_11_11;
    const double t25 = A2 * (194.12263723101208 * A2 + 540.0);
    const double delta_12_5 = delta_12 * delta_12_4;
    const double delta_12_10 = delta_12_5 * delta_12_5;
    const double delta_12_11 = delta_12 * delta_12_10;
    const double t26 = 1.0 / delta_12_11;
    const double t27 = A2 * (222.02016549406298 * A2 + 540.0);
    const double delta_13_5 = delta_13 * delta_13_4;
    const double delta_13_10 = delta_13_5 * delta_13_5;
    const double delta_13_11 = delta_13 * delta_13_10;
    const double t28 = 1.0 / delta_13_11;
    const double t29 = A2 * (248.88301782571617 * A2 + 540.0);
    const double delta_14_5 = delta_14 * delta_14_4;
    const double delta_14_10 = delta_14_5 * delta_14_5;
    const double delta_14_11 = delta_14 * delta_14_10;
    const double t30 = 1.0 / delta_14_11;
    const double t31 = A2 * (274.04974164887079 * A2 + 540.0);
    const double delta_15_5 = delta_15 * delta_15_4;
    const double delta_15_10 = delta_15_5 * delta_15_5;
    const double delta_15_11 = delta_15 * delta_15_10;
    const double t32 = 1.0 / delta_15_11;
    const double t33 = A2 * (296.90064869943308 * A2 + 540.0);
    const double delta_16_5 = delta_16 * delta_16_4;
    const double delta_16_10 = delta_16_5 * delta_16_5;
    const double delta_16_11 = delta_16 * delta_16_10;
    const double t34 = 1.0 / delta_16_11;
    const double t35 = A2 * (316.87307380800559 * A2 + 540.0);
    const double delta_17_5 = delta_17 * delta_17_4;
    const double delta_17_10 = delta_17_5 * delta_17_5;
    const double delta_17_11 = delta_17 * delta_17_10;
    const double t36 = 1.0 / delta_17_11;
    const double t37 = A2 * (333.47522958373662 * A2 + 540.0);
    const double delta_18_5 = delta_18 * delta_18_4;
    const double delta_18_10 = delta_18_5 * delta_18_5;
    const double delta_18_11 = delta_18 * delta_18_10;
    const double t38 = 1.0 / delta_18_11;
    const double t39 = A2 * (346.29831585203164 * A2 + 540.0);
    const double delta_19_5 = delta_19 * delta_19_4;
    const double delta_19_10 = delta_19_5 * delta_19_5;
    const double delta_19_11 = delta_19 * delta_19_10;
    const double t40 = 1.0 / delta_19_11;
    const double t41 = A2 * (355.02658567158181 * A2 + 540.0);
    const double delta_2_5 = delta_2 * delta_2_4;
    const double delta_2_10 = delta_2_5 * delta_2_5;
    const double delta_2_11 = delta_2 * delta_2_10;
    const double t42 = 1.0 / delta_2_11;
    const double t43 = A2 * (4.9734143284182117 * A2 + 540.0);
    const double delta_20_5 = delta_20 * delta_20_4;
    const double delta_20_10 = delta_20_5 * delta_20_5;
    const double delta_20_11 = delta_20 * delta_20_10;
    const double t44 = 1.0 / delta_20_11;
    const double t45 = A2 * (359.44512007196306 * A2 + 540.0);
    const double delta_3_5 = delta_3 * delta_3_4;
    const double delta_3_10 = delta_3_5 * delta_3_5;
    const double delta_3_11 = delta_3 * delta_3_10;
    const double t46 = 1.0 / delta_3_11;
    const double t47 = A2 * (13.701684147968384 * A2 + 540.0);
    const double delta_4_5 = delta_4 * delta_4_4;
    const double delta_4_10 = delta_4_5 * delta_4_5;
    const double delta_4_11 = delta_4 * delta_4_10;
    const double t48 = 1.0 / delta_4_11;
    const double t49 = A2 * (26.524770416263401 * A2 + 540.0);
    const double delta_5_5 = delta_5 * delta_5_4;
    const double delta_5_10 = delta_5_5 * delta_5_5;
    const double delta_5_11 = delta_5 * delta_5_10;
    const double t50 = 1.0 / delta_5_11;
    const double t51 = A2 * (43.126926191994428 * A2 + 540.0);
    const double delta_6_5 = delta_6 * delta_6_4;
    const double delta_6_10 = delta_6_5 * delta_6_5;
    const double delta_6_11 = delta_6 * delta_6_10;
    const double t52 = 1.0 / delta_6_11;
    const double t53 = A2 * (63.099351300566944 * A2 + 540.0);
    const double delta_7_5 = delta_7 * delta_7_4;
    const double delta_7_10 = delta_7_5 * delta_7_5;
    const double delta_7_11 = delta_7 * delta_7_10;
    const double t54 = 1.0 / delta_7_11;
    const double t55 = A2 * (85.950258351129207 * A2 + 540.0);
    const double delta_8_5 = delta_8 * delta_8_4;
    const double delta_8_10 = delta_8_5 * delta_8_5;
    const double delta_8_11 = delta_8 * delta_8_10;
    const double t56 = 1.0 / delta_8_11;
    const double t57 = A2 * (111.11698217428385 * A2 + 540.0);
    const double delta_9_5 = delta_9 * delta_9_4;
    const double delta_9_10 = delta_9_5 * delta_9_5;
    const double delta_9_11 = delta_9 * delta_9_10;
    const double t58 = 1.0 / delta_9_11;
    const double t59 = A2 * (137.97983450593702 * A2 + 540.0);
    const double moment_3_2 = t20 * (2.3647394799184329e-06 * t21 + 0.069039764531051137) + t22 *
        (0.033288198188945128 * t23 + 3.2510090687415465) + t24 * (0.028444691488208815 * t25 + 2.3737777761622487)
        + t26 * (0.021415055259527815 * t27 + 1.562578310994132) + t28 * (0.014054627450619245 * t29 +
        0.91482724168617802) + t30 * (0.0078865643170606577 * t31 + 0.46620128582379594) + t32 *
        (0.0036625576765116907 * t33 + 0.19984272388557664) + t34 * (0.0013319983481469224 * t35 +
        0.06809784429034367) + t36 * (0.00034321760569970094 * t37 + 0.01667327801011077) + t38 *
        (5.1016435440244884e-05 * t39 + 0.0023865731258280345) + t40 * (2.5643256204164034e-06 * t41 +
        0.00011701116684589456) + t42 * (0.00018305407702803422 * t43 + 0.59626563403522437) + t44 *
        (3.6504779149056442e-09 * t45 + 1.6452509414964851e-07) + t46 * (0.0012893966524801449 * t47 +
        1.5245006047870071) + t48 * (0.0043150069939045157 * t49 + 2.6353899469905588) + t50 *
        (0.0097867955857899765 * t51 + 3.6762668358040367) + t52 * (0.017233390322439635 * t53 + 4.4244658220601023)
        + t54 * (0.025146066516265234 * t55 + 4.7395585002118246) + t56 * (0.031479959461460365 * t57 +
        4.5895355804009865) + t58 * (0.03445847090489363 * t59 + 4.0457160327675075);
    const double t60 = 0.001541333133436012 * A2;
    const double delta_1_12 = delta_1_6 * delta_1_6;
    const double delta_1_13 = delta_1 * delta_1_12;
    const double t61 = A * (t60 * (3.88415949625875 * A2 + 6300.0) + 1575.0) / delta_1_13;
    const double t62 = 0.46077045213607754 * A2;
    const double delta_10_12 = delta_10_6 * delta_10_6;
    const double delta_10_13 = delta_10 * delta_10_12;
    const double t63 = A * (t62 * (1161.1415393829154 * A2 + 6300.0) + 1575.0) / delta_10_13;
    const double t64 = 0.53922954786392252 * A2;
    const double delta_11_12 = delta_11_6 * delta_11_6;
    const double delta_11_13 = delta_11 * delta_11_12;
    const double t65 = A * (t64 * (1358.8584606170846 * A2 + 6300.0) + 1575.0) / delta_11_13;
    const double t66 = 0.61672268192795265 * A2;
    const double delta_12_12 = delta_12_6 * delta_12_6;
    const double delta_12_13 = delta_12 * delta_12_12;
    const double t67 = A * (t66 * (1554.1411584584407 * A2 + 6300.0) + 1575.0) / delta_12_13;
    const double t68 = 0.69134171618254492 * A2;
    const double delta_13_12 = delta_13_6 * delta_13_6;
    const double delta_13_13 = delta_13 * delta_13_12;
    const double t69 = A * (t68 * (1742.1811247800131 * A2 + 6300.0) + 1575.0) / delta_13_13;
    const double t70 = 0.7612492823579744 * A2;
    const double delta_14_12 = delta_14_6 * delta_14_6;
    const double delta_14_13 = delta_14 * delta_14_12;
    const double t71 = A * (t70 * (1918.3481915420955 * A2 + 6300.0) + 1575.0) / delta_14_13;
    const double t72 = 0.82472402416509183 * A2;
    const double delta_15_12 = delta_15_6 * delta_15_6;
    const double delta_15_13 = delta_15 * delta_15_12;
    const double t73 = A * (t72 * (2078.3045408960315 * A2 + 6300.0) + 1575.0) / delta_15_13;
    const double t74 = 0.88020298280001552 * A2;
    const double delta_16_12 = delta_16_6 * delta_16_6;
    const double delta_16_13 = delta_16 * delta_16_12;
    const double t75 = A * (t74 * (2218.1115166560389 * A2 + 6300.0) + 1575.0) / delta_16_13;
    const double t76 = 0.92632008217704609 * A2;
    const double delta_17_12 = delta_17_6 * delta_17_6;
    const double delta_17_13 = delta_17 * delta_17_12;
    const double t77 = A * (t76 * (2334.3266070861564 * A2 + 6300.0) + 1575.0) / delta_17_13;
    const double t78 = 0.96193976625564337 * A2;
    const double delta_18_12 = delta_18_6 * delta_18_6;
    const double delta_18_13 = delta_18 * delta_18_12;
    const double t79 = A * (t78 * (2424.0882109642212 * A2 + 6300.0) + 1575.0) / delta_18_13;
    const double t80 = 0.98618496019883828 * A2;
    const double delta_19_12 = delta_19_6 * delta_19_6;
    const double delta_19_13 = delta_19 * delta_19_12;
    const double t81 = A * (t80 * (2485.1860997010726 * A2 + 6300.0) + 1575.0) / delta_19_13;
    const double t82 = 0.013815039801161699 * A2;
    const double delta_2_12 = delta_2_6 * delta_2_6;
    const double delta_2_13 = delta_2 * delta_2_12;
    const double t83 = A * (t82 * (34.813900298927479 * A2 + 6300.0) + 1575.0) / delta_2_13;
    const double t84 = 0.99845866686656404 * A2;
    const double delta_20_12 = delta_20_6 * delta_20_6;
    const double delta_20_13 = delta_20 * delta_20_12;
    const double t85 = A * (t84 * (2516.1158405037413 * A2 + 6300.0) + 1575.0) / delta_20_13;
    const double t86 = 0.038060233744356624 * A2;
    const double delta_3_12 = delta_3_6 * delta_3_6;
    const double delta_3_13 = delta_3 * delta_3_12;
    const double t87 = A * (t86 * (95.911789035778682 * A2 + 6300.0) + 1575.0) / delta_3_13;
    const double t88 = 0.073679917822953883 * A2;
    const double delta_4_12 = delta_4_6 * delta_4_6;
    const double delta_4_13 = delta_4 * delta_4_12;
    const double t89 = A * (t88 * (185.6733929138438 * A2 + 6300.0) + 1575.0) / delta_4_13;
    const double t90 = 0.11979701719998453 * A2;
    const double delta_5_12 = delta_5_6 * delta_5_6;
    const double delta_5_13 = delta_5 * delta_5_12;
    const double t91 = A * (t90 * (301.88848334396101 * A2 + 6300.0) + 1575.0) / delta_5_13;
    const double t92 = 0.17527597583490817 * A2;
    const double delta_6_12 = delta_6_6 * delta_6_6;
    const double delta_6_13 = delta_6 * delta_6_12;
    const double t93 = A * (t92 * (441.69545910396857 * A2 + 6300.0) + 1575.0) / delta_6_13;
    const double t94 = 0.23875071764202557 * A2;
    const double delta_7_12 = delta_7_6 * delta_7_6;
    const double delta_7_13 = delta_7 * delta_7_12;
    const double t95 = A * (t94 * (601.65180845790439 * A2 + 6300.0) + 1575.0) / delta_7_13;
    const double t96 = 0.30865828381745514 * A2;
    const double delta_8_12 = delta_8_6 * delta_8_6;
    const double delta_8_13 = delta_8 * delta_8_12;
    const double t97 = A * (t96 * (777.81887521998692 * A2 + 6300.0) + 1575.0) / delta_8_13;
    const double t98 = 0.38327731807204729 * A2;
    const double delta_9_12 = delta_9_6 * delta_9_6;
    const double delta_9_13 = delta_9 * delta_9_12;
    const double t99 = A * (t98 * (965.85884154155917 * A2 + 6300.0) + 1575.0) / delta_9_13;
    const double moment_3_3 = 2.3647394799184329e-06 * t61 + 0.033288198188945128 * t63 + 0.028444691488208815 * t65
        + 0.021415055259527815 * t67 + 0.014054627450619245 * t69 + 0.0078865643170606577 * t71 +
        0.0036625576765116907 * t73 + 0.0013319983481469224 * t75 + 0.00034321760569970094 * t77 +
        5.1016435440244884e-05 * t79 + 2.5643256204164034e-06 * t81 + 0.00018305407702803422 * t83 +
        3.6504779149056442e-09 * t85 + 0.0012893966524801449 * t87 + 0.0043150069939045157 * t89 +
        0.0097867955857899765 * t91 + 0.017233390322439635 * t93 + 0.025146066516265234 * t95 + 0.031479959461460365
        * t97 + 0.03445847090489363 * t99;
    const double moment_5_0 = t20 * (0.0015294911554703896 * t21 + 44.654267466978368) + t22 * (0.021006467724459715
        * t23 + 2.0515444148348254) + t24 * (0.011199452401947942 * t25 + 0.93462118328656263) + t26 *
        (0.0051010022607719408 * t27 + 0.37220149097994981) + t28 * (0.0019367896204717677 * t29 +
        0.12606722678689999) + t30 * (0.00059054136637325149 * t31 + 0.034908882152876478) + t32 *
        (0.00013643337236556963 * t33 + 0.0074443105530555501) + t34 * (2.1717651504073708e-05 * t35 +
        0.0011103056190226075) + t36 * (2.0114384305267226e-06 * t37 + 9.7714311840216132e-05) + t38 *
        (7.682545382961892e-08 * t39 + 3.5939312871842399e-06) + t40 * (4.9627120539550997e-10 * t41 +
        2.2645046460955198e-08) + t42 * (0.012886768168308823 * t43 + 41.976322610748703) + t44 *
        (8.6858567580270053e-15 * t45 + 3.9146693506888154e-13) + t46 * (0.031348072650511344 * t47 +
        37.063967571722451) + t48 * (0.05025213641714197 * t49 + 30.691485625773861) + t50 * (0.063293656320966701 *
        t51 + 23.775337658773271) + t52 * (0.066875281373276918 * t53 + 17.169424659954501) + t54 *
        (0.061035030621031404 * t55 + 11.503950250170696) + t56 * (0.048746310903563059 * t57 + 7.1068366075593632)
        + t58 * (0.034195009231670875 * t59 + 4.0147834032170282);
    const double moment_5_1 = 0.0015294911554703896 * t61 + 0.021006467724459715 * t63 + 0.011199452401947942 * t65
        + 0.0051010022607719408 * t67 + 0.0019367896204717677 * t69 + 0.00059054136637325149 * t71 +
        0.00013643337236556963 * t73 + 2.1717651504073708e-05 * t75 + 2.0114384305267226e-06 * t77 +
        7.682545382961892e-08 * t79 + 4.9627120539550997e-10 * t81 + 0.012886768168308823 * t83 +
        8.6858567580270053e-15 * t85 + 0.031348072650511344 * t87 + 0.05025213641714197 * t89 + 0.063293656320966701
        * t91 + 0.066875281373276918 * t93 + 0.061035030621031404 * t95 + 0.048746310903563059 * t97 +
        0.034195009231670875 * t99;
    const double delta_1_14 = delta_1_7 * delta_1_7;
    const double delta_1_15 = delta_1 * delta_1_14;
    const double delta_10_14 = delta_10_7 * delta_10_7;
    const double delta_10_15 = delta_10 * delta_10_14;
    const double delta_11_14 = delta_11_7 * delta_11_7;
    const double delta_11_15 = delta_11 * delta_11_14;
    const double delta_12_14 = delta_12_7 * delta_12_7;
    const double delta_12_15 = delta_12 * delta_12_14;
    const double delta_13_14 = delta_13_7 * delta_13_7;
    const double delta_13_15 = delta_13 * delta_13_14;
    const double delta_14_14 = delta_14_7 * delta_14_7;
    const double delta_14_15 = delta_14 * delta_14_14;
    const double delta_15_14 = delta_15_7 * delta_15_7;
    const double delta_15_15 = delta_15 * delta_15_14;
    const double delta_16_14 = delta_16_7 * delta_16_7;
    const double delta_16_15 = delta_16 * delta_16_14;
    const double delta_17_14 = delta_17_7 * delta_17_7;
    const double delta_17_15 = delta_17 * delta_17_14;
    const double delta_18_14 = delta_18_7 * delta_18_7;
    const double delta_18_15 = delta_18 * delta_18_14;
    const double delta_19_14 = delta_19_7 * delta_19_7;
    const double delta_19_15 = delta_19 * delta_19_14;
    const double delta_2_14 = delta_2_7 * delta_2_7;
    const double delta_2_15 = delta_2 * delta_2_14;
    const double delta_20_14 = delta_20_7 * delta_20_7;
    const double delta_20_15 = delta_20 * delta_20_14;
    const double delta_3_14 = delta_3_7 * delta_3_7;
    const double delta_3_15 = delta_3 * delta_3_14;
    const double delta_4_14 = delta_4_7 * delta_4_7;
    const double delta_4_15 = delta_4 * delta_4_14;
    const double delta_5_14 = delta_5_7 * delta_5_7;
    const double delta_5_15 = delta_5 * delta_5_14;
    const double delta_6_14 = delta_6_7 * delta_6_7;
    const double delta_6_15 = delta_6 * delta_6_14;
    const double delta_7_14 = delta_7_7 * delta_7_7;
    const double delta_7_15 = delta_7 * delta_7_14;
    const double delta_8_14 = delta_8_7 * delta_8_7;
    const double delta_8_15 = delta_8 * delta_8_14;
    const double delta_9_14 = delta_9_7 * delta_9_7;
    const double delta_9_15 = delta_9 * delta_9_14;
    const double moment_5_2 = (0.013106171429763712 * A2 * (t98 * (7726.8707323324734 * A2 + 75600.0) + 37800.0) +
        53.857139539881636) / delta_9_15 + (0.015045952665925875 * A2 * (t96 * (6222.5510017598954 * A2 + 75600.0) +
        37800.0) + 76.775439673111819) / delta_8_15 + (0.014572157362074253 * A2 * (t94 * (4813.2144676632352 * A2 +
        75600.0) + 37800.0) + 96.130173228124463) / delta_7_15 + (0.01172163020193517 * A2 * (t92 *
        (3533.5636728317486 * A2 + 75600.0) + 37800.0) + 105.32856816291115) / delta_6_15 + (0.0075823912349327581 *
        A2 * (t90 * (2415.1078667516881 * A2 + 75600.0) + 37800.0) + 99.687508705522561) / delta_5_15 +
        (0.0037025732816428889 * A2 * (t88 * (1485.3871433107504 * A2 + 75600.0) + 37800.0) + 79.147114856998598) /
        delta_4_15 + (0.0011931149725135347 * A2 * (t86 * (767.29431228622946 * A2 + 75600.0) + 37800.0) +
        49.373214424555364) / delta_3_15 + (0.00017803121515353005 * A2 * (t82 * (278.51120239141983 * A2 + 75600.0)
        + 37800.0) + 20.296659865086397) / delta_2_15 + (8.6724689592135779e-15 * A2 * (t84 * (20128.92672402993 *
        A2 + 75600.0) + 37800.0) + 1.3680224393892533e-11) / delta_20_15 + (2.3574553952238424e-06 * A2 * (t60 *
        (31.07327597007 * A2 + 75600.0) + 37800.0) + 2.4089485698658639) / delta_1_15 + (4.8941519894080047e-10 * A2
        * (t80 * (19881.488797608581 * A2 + 75600.0) + 37800.0) + 7.8162714849792818e-07) / delta_19_15 +
        (7.3901459099347348e-08 * A2 * (t78 * (19392.705687713769 * A2 + 75600.0) + 37800.0) +
        0.00012100008978164979) / delta_18_15 + (1.8632358122595822e-06 * A2 * (t76 * (18674.612856689251 * A2 +
        75600.0) + 37800.0) + 0.003168015528079588) / delta_17_15 + (1.9115941633296919e-05 * A2 * (t74 *
        (17744.892133248311 * A2 + 75600.0) + 37800.0) + 0.034205301118916086) / delta_16_15 +
        (0.00011251987988774702 * A2 * (t72 * (16626.436327168252 * A2 + 75600.0) + 37800.0) + 0.21488256147577217)
        / delta_15_15 + (0.00044954919135433536 * A2 * (t70 * (15346.785532336764 * A2 + 75600.0) + 37800.0) +
        0.93010265203787112) / delta_14_15 + (0.0013389834601014916 * A2 * (t68 * (13937.448998240105 * A2 +
        75600.0) + 37800.0) + 3.0504436522430338) / delta_13_15 + (0.0031459037947838215 * A2 * (t66 *
        (12433.129267667526 * A2 + 75600.0) + 37800.0) + 8.0340785607158072) / delta_12_15 + (0.006039075655025909 *
        A2 * (t64 * (10870.867684936677 * A2 + 75600.0) + 37800.0) + 17.639137533068009) / delta_11_15 +
        (0.0096791596311812233 * A2 * (t62 * (9289.1323150633234 * A2 + 75600.0) + 37800.0) + 33.08518666602405) /
        delta_10_15;
    const double delta_5_16 = delta_5_8 * delta_5_8;
    const double delta_5_17 = delta_5 * delta_5_16;
    const double delta_16_16 = delta_16_8 * delta_16_8;
    const double delta_16_17 = delta_16 * delta_16_16;
    const double delta_20_16 = delta_20_8 * delta_20_8;
    const double delta_20_17 = delta_20 * delta_20_16;
    const double delta_12_16 = delta_12_8 * delta_12_8;
    const double delta_12_17 = delta_12 * delta_12_16;
    const double delta_19_16 = delta_19_8 * delta_19_8;
    const double delta_19_17 = delta_19 * delta_19_16;
    const double delta_14_16 = delta_14_8 * delta_14_8;
    const double delta_14_17 = delta_14 * delta_14_16;
    const double delta_4_16 = delta_4_8 * delta_4_8;
    const double delta_4_17 = delta_4 * delta_4_16;
    const double delta_17_16 = delta_17_8 * delta_17_8;
    const double delta_17_17 = delta_17 * delta_17_16;
    const double delta_7_16 = delta_7_8 * delta_7_8;
    const double delta_7_17 = delta_7 * delta_7_16;
    const double delta_15_16 = delta_15_8 * delta_15_8;
    const double delta_15_17 = delta_15 * delta_15_16;
    const double delta_10_16 = delta_10_8 * delta_10_8;
    const double delta_10_17 = delta_10 * delta_10_16;
    const double delta_9_16 = delta_9_8 * delta_9_8;
    const double delta_9_17 = delta_9 * delta_9_16;
    const double delta_18_16 = delta_18_8 * delta_18_8;
    const double delta_18_17 = delta_18 * delta_18_16;
    const double delta_1_16 = delta_1_8 * delta_1_8;
    const double delta_1_17 = delta_1 * delta_1_16;
    const double delta_2_16 = delta_2_8 * delta_2_8;
    const double delta_2_17 = delta_2 * delta_2_16;
    const double delta_11_16 = delta_11_8 * delta_11_8;
    const double delta_11_17 = delta_11 * delta_11_16;
    const double delta_8_16 = delta_8_8 * delta_8_8;
    const double delta_8_17 = delta_8 * delta_8_16;
    const double delta_6_16 = delta_6_8 * delta_6_8;
    const double delta_6_17 = delta_6 * delta_6_16;
    const double delta_13_16 = delta_13_8 * delta_13_8;
    const double delta_13_17 = delta_13 * delta_13_16;
    const double delta_3_16 = delta_3_8 * delta_3_8;
    const double delta_3_17 = delta_3 * delta_3_16;
    const double moment_5_3 = 0.013106171429763712 * A * (t98 * (t98 * (69541.836590992258 * A2 + 952560.0) +
        793800.0) + 99225.0) / delta_9_17 + 0.015045952665925875 * A * (t96 * (t96 * (56002.959015839057 * A2 +
        952560.0) + 793800.0) + 99225.0) / delta_8_17 + 0.014572157362074253 * A * (t94 * (t94 * (43318.930208969119
        * A2 + 952560.0) + 793800.0) + 99225.0) / delta_7_17 + 0.01172163020193517 * A * (t92 * (t92 *
        (31802.07305548574 * A2 + 952560.0) + 793800.0) + 99225.0) / delta_6_17 + 0.0075823912349327581 * A * (t90 *
        (t90 * (21735.970800765193 * A2 + 952560.0) + 793800.0) + 99225.0) / delta_5_17 + 0.0037025732816428889 * A
        * (t88 * (t88 * (13368.484289796754 * A2 + 952560.0) + 793800.0) + 99225.0) / delta_4_17 +
        0.0011931149725135347 * A * (t86 * (t86 * (6905.6488105760654 * A2 + 952560.0) + 793800.0) + 99225.0) /
        delta_3_17 + 0.00017803121515353005 * A * (t82 * (t82 * (2506.6008215227785 * A2 + 952560.0) + 793800.0) +
        99225.0) / delta_2_17 + 8.6724689592135779e-15 * A * (t84 * (t84 * (181160.34051626938 * A2 + 952560.0) +
        793800.0) + 99225.0) / delta_20_17 + 2.3574553952238424e-06 * A * (t60 * (t60 * (279.65948373062997 * A2 +
        952560.0) + 793800.0) + 99225.0) / delta_1_17 + 4.8941519894080047e-10 * A * (t80 * (t80 *
        (178933.39917847721 * A2 + 952560.0) + 793800.0) + 99225.0) / delta_19_17 + 7.3901459099347348e-08 * A *
        (t78 * (t78 * (174534.35118942393 * A2 + 952560.0) + 793800.0) + 99225.0) / delta_18_17 +
        1.8632358122595822e-06 * A * (t76 * (t76 * (168071.51571020324 * A2 + 952560.0) + 793800.0) + 99225.0) /
        delta_17_17 + 1.9115941633296919e-05 * A * (t74 * (t74 * (159704.02919923482 * A2 + 952560.0) + 793800.0) +
        99225.0) / delta_16_17 + 0.00011251987988774702 * A * (t72 * (t72 * (149637.92694451427 * A2 + 952560.0) +
        793800.0) + 99225.0) / delta_15_17 + 0.00044954919135433536 * A * (t70 * (t70 * (138121.0697910309 * A2 +
        952560.0) + 793800.0) + 99225.0) / delta_14_17 + 0.0013389834601014916 * A * (t68 * (t68 *
        (125437.04098416095 * A2 + 952560.0) + 793800.0) + 99225.0) / delta_13_17 + 0.0031459037947838215 * A * (t66
        * (t66 * (111898.16340900774 * A2 + 952560.0) + 793800.0) + 99225.0) / delta_12_17 + 0.006039075655025909 *
        A * (t64 * (t64 * (97837.809164430088 * A2 + 952560.0) + 793800.0) + 99225.0) / delta_11_17 +
        0.0096791596311812233 * A * (t62 * (t62 * (83602.190835569912 * A2 + 952560.0) + 793800.0) + 99225.0) /
        delta_10_17;
    const double A3 = A * A2;
    const double t100 = 0.013333333333333334 * beta;
    const double t101 = 6.0 * moment_3_0;
    const double A4 = A2 * A2;
    const double A5 = A * A4;
    const double t102 = 0.00021164021164021165 * beta;
    out[0] = -A3 * moment_3_0 * t100;
    out[1] = -t100 * (3.0 * A2 * moment_3_0 + A3 * moment_3_1);
    out[2] = -t100 * (A * t101 + 6.0 * A2 * moment_3_1 + A3 * moment_3_2);
    out[3] = -t100 * (18.0 * A * moment_3_1 + 9.0 * A2 * moment_3_2 + A3 * moment_3_3 + t101);
    out[4] = -A5 * moment_5_0 * t102;
    out[5] = -t102 * (5.0 * A4 * moment_5_0 + A5 * moment_5_1);
    out[6] = -t102 * (20.0 * A3 * moment_5_0 + 10.0 * A4 * moment_5_1 + A5 * moment_5_2);
    out[7] = -t102 * (60.0 * A2 * moment_5_0 + 60.0 * A3 * moment_5_1 + 15.0 * A4 * moment_5_2 + A5 * moment_5_3);
}

static inline void rod_spring_untruncated_harmonics_passed_1(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double c = 1.0 - delta_h;
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double T = u_cr / (A + root);
    const double T2 = T * T;
    const double g_1 = 1.0 / (0.99680179919950185 * T2 + 1.0);
    const double s_1 = 1.9967992379801249 * T * g_1;
    const double g_2 = 1.0 / (0.9832255187534148 * T2 + 1.0);
    const double s_2 = 1.9831545766817218 * T * g_2;
    const double g_3 = 1.0 / (0.95911174810059274 * T2 + 1.0);
    const double s_3 = 1.9586850161274965 * T * g_3;
    const double g_4 = 1.0 / (0.92498107681574593 * T2 + 1.0);
    const double s_4 = 1.923518730676409 * T * g_4;
    const double g_5 = 1.0 / (0.88157744655614578 * T2 + 1.0);
    const double s_5 = 1.8778471147099765 * T * g_5;
    const double g_6 = 1.0 / (0.82984762039740356 * T2 + 1.0);
    const double s_6 = 1.8219194498082549 * T * g_6;
    const double g_7 = 1.0 / (0.77092012101329255 * T2 + 1.0);
    const double s_7 = 1.7560411396243454 * T * g_7;
    const double g_8 = 1.0 / (0.70608053366627843 * T2 + 1.0);
    const double s_8 = 1.6805719665236338 * T * g_8;
    const double g_9 = 1.0 / (0.63674343843571335 * T2 + 1.0);
    const double s_9 = 1.5959241065109748 * T * g_9;
    const double g_10 = 1.0 / (0.56442154176958992 * T2 + 1.0);
    const double s_10 = 1.502559871378961 * T * g_10;
    const double g_11 = 1.0 / (0.49069267139845796 * T2 + 1.0);
    const double s_11 = 1.4009891811123425 * T * g_11;
    const double g_12 = 1.0 / (0.41716535201722399 * T2 + 1.0);
    const double s_12 = 1.2917667777384956 * T * g_12;
    const double g_13 = 1.0 / (0.34544371187293316 * T2 + 1.0);
    const double s_13 = 1.1754891949702186 * T * g_13;
    const double g_14 = 1.0 / (0.27709248554562232 * T2 + 1.0);
    const double s_14 = 1.0527914998623846 * T * g_14;
    const double g_15 = 1.0 / (0.21360287630682981 * T2 + 1.0);
    const double s_15 = 0.92434382414084382 * T * g_15;
    const double g_16 = 1.0 / (0.15636002276450464 * T2 + 1.0);
    const double s_16 = 0.79084770408595007 * T * g_16;
    const double g_17 = 1.0 / (0.1066127795359121 * T2 + 1.0);
    const double s_17 = 0.65303224893082301 * T * g_17;
    const double g_18 = 1.0 / (0.065446471220790378 * T2 + 1.0);
    const double s_18 = 0.51165015868575814 * T * g_18;
    const double g_19 = 1.0 / (0.033759214086650779 * T2 + 1.0);
    const double s_19 = 0.36747361312970911 * T * g_19;
    const double g_20 = 1.0 / (0.012242322045974101 * T2 + 1.0);
    const double s_20 = 0.22129005441703975 * T * g_20;
    const double g_21 = 1.0 / (0.0013652244010363957 * T2 + 1.0);
    const double s_21 = 0.073897886330703558 * T * g_21;
    const double v_1 = A * s_1;
    const double square_1 = (1.0 - v_1) * (v_1 + 1.0);
    const double delta_1 = sqrt(square_1);
    const double v_2 = A * s_2;
    const double square_2 = (1.0 - v_2) * (v_2 + 1.0);
    const double delta_2 = sqrt(square_2);
    const double v_3 = A * s_3;
    const double square_3 = (1.0 - v_3) * (v_3 + 1.0);
    const double delta_3 = sqrt(square_3);
    const double v_4 = A * s_4;
    const double square_4 = (1.0 - v_4) * (v_4 + 1.0);
    const double delta_4 = sqrt(square_4);
    const double v_5 = A * s_5;
    const double square_5 = (1.0 - v_5) * (v_5 + 1.0);
    const double delta_5 = sqrt(square_5);
    const double v_6 = A * s_6;
    const double square_6 = (1.0 - v_6) * (v_6 + 1.0);
    const double delta_6 = sqrt(square_6);
    const double v_7 = A * s_7;
    const double square_7 = (1.0 - v_7) * (v_7 + 1.0);
    const double delta_7 = sqrt(square_7);
    const double v_8 = A * s_8;
    const double square_8 = (1.0 - v_8) * (v_8 + 1.0);
    const double delta_8 = sqrt(square_8);
    const double v_9 = A * s_9;
    const double square_9 = (1.0 - v_9) * (v_9 + 1.0);
    const double delta_9 = sqrt(square_9);
    const double v_10 = A * s_10;
    const double square_10 = (1.0 - v_10) * (v_10 + 1.0);
    const double delta_10 = sqrt(square_10);
    const double v_11 = A * s_11;
    const double square_11 = (1.0 - v_11) * (v_11 + 1.0);
    const double delta_11 = sqrt(square_11);
    const double v_12 = A * s_12;
    const double square_12 = (1.0 - v_12) * (v_12 + 1.0);
    const double delta_12 = sqrt(square_12);
    const double v_13 = A * s_13;
    const double square_13 = (1.0 - v_13) * (v_13 + 1.0);
    const double delta_13 = sqrt(square_13);
    const double v_14 = A * s_14;
    const double square_14 = (1.0 - v_14) * (v_14 + 1.0);
    const double delta_14 = sqrt(square_14);
    const double v_15 = A * s_15;
    const double square_15 = (1.0 - v_15) * (v_15 + 1.0);
    const double delta_15 = sqrt(square_15);
    const double v_16 = A * s_16;
    const double square_16 = (1.0 - v_16) * (v_16 + 1.0);
    const double delta_16 = sqrt(square_16);
    const double v_17 = A * s_17;
    const double square_17 = (1.0 - v_17) * (v_17 + 1.0);
    const double delta_17 = sqrt(square_17);
    const double v_18 = A * s_18;
    const double square_18 = (1.0 - v_18) * (v_18 + 1.0);
    const double delta_18 = sqrt(square_18);
    const double v_19 = A * s_19;
    const double square_19 = (1.0 - v_19) * (v_19 + 1.0);
    const double delta_19 = sqrt(square_19);
    const double v_20 = A * s_20;
    const double square_20 = (1.0 - v_20) * (v_20 + 1.0);
    const double delta_20 = sqrt(square_20);
    const double v_21 = A * s_21;
    const double square_21 = (1.0 - v_21) * (v_21 + 1.0);
    const double delta_21 = sqrt(square_21);
    const double u_cr2 = u_cr * u_cr;
    const double g_20_2 = g_20 * g_20;
    const double s_20_2 = s_20 * s_20;
    const double g_17_2 = g_17 * g_17;
    const double s_17_2 = s_17 * s_17;
    const double g_16_2 = g_16 * g_16;
    const double s_16_2 = s_16 * s_16;
    const double g_13_2 = g_13 * g_13;
    const double s_13_2 = s_13 * s_13;
    const double g_12_2 = g_12 * g_12;
    const double s_12_2 = s_12 * s_12;
    const double g_10_2 = g_10 * g_10;
    const double s_10_2 = s_10 * s_10;
    const double g_8_2 = g_8 * g_8;
    const double s_8_2 = s_8 * s_8;
    const double g_18_2 = g_18 * g_18;
    const double s_18_2 = s_18 * s_18;
    const double g_7_2 = g_7 * g_7;
    const double s_7_2 = s_7 * s_7;
    const double g_15_2 = g_15 * g_15;
    const double s_15_2 = s_15 * s_15;
    const double g_5_2 = g_5 * g_5;
    const double s_5_2 = s_5 * s_5;
    const double g_9_2 = g_9 * g_9;
    const double s_9_2 = s_9 * s_9;
    const double g_4_2 = g_4 * g_4;
    const double s_4_2 = s_4 * s_4;
    const double g_6_2 = g_6 * g_6;
    const double s_6_2 = s_6 * s_6;
    const double g_3_2 = g_3 * g_3;
    const double s_3_2 = s_3 * s_3;
    const double g_21_2 = g_21 * g_21;
    const double s_21_2 = s_21 * s_21;
    const double g_11_2 = g_11 * g_11;
    const double s_11_2 = s_11 * s_11;
    const double g_2_2 = g_2 * g_2;
    const double s_2_2 = s_2 * s_2;
    const double g_14_2 = g_14 * g_14;
    const double s_14_2 = s_14 * s_14;
    const double g_19_2 = g_19 * g_19;
    const double s_19_2 = s_19 * s_19;
    const double g_1_2 = g_1 * g_1;
    const double s_1_2 = s_1 * s_1;
    const double sum_3_0 = -0.089087155543931762 * T * g_9_2 * s_9 * u_cr2 * v_9 * (0.20203794674451259 -
        0.16121861481977409 * T2) * (4.0 * s_9_2 - 3.0) * (g_9 * (0.79796205325548741 * T2 + 0.79796205325548741) +
        1.0) / (c * delta_9 * (c + delta_9)) - 0.08013147036138453 * T * g_8_2 * s_8 * u_cr2 * v_8 *
        (0.15971401673818311 - 0.13420544959553846 * T2) * (4.0 * s_8_2 - 3.0) * (g_8 * (0.84028598326181692 * T2 +
        0.84028598326181692) + 1.0) / (c * delta_8 * (c + delta_8)) - 0.07073814219518422 * T * g_7_2 * s_7 * u_cr2
        * v_7 * (0.12197943018782725 - 0.10710044879888024 * T2) * (4.0 * s_7_2 - 3.0) * (g_7 * (0.87802056981217269
        * T2 + 0.87802056981217269) + 1.0) / (c * delta_7 * (c + delta_7)) - 0.060958481399206933 * T * g_6_2 * s_6
        * u_cr2 * v_6 * (0.089040275095872548 - 0.081112104506723889 * T2) * (4.0 * s_6_2 - 3.0) * (g_6 *
        (0.91095972490412747 * T2 + 0.91095972490412747) + 1.0) / (c * delta_6 * (c + delta_6)) -
        0.050845919052226095 * T * g_5_2 * s_5 * u_cr2 * v_5 * (0.061076442645011823 - 0.057346110798842401 * T2) *
        (4.0 * s_5_2 - 3.0) * (g_5 * (0.93892355735498823 * T2 + 0.93892355735498823) + 1.0) / (c * delta_5 * (c +
        delta_5)) - 0.040455739138105289 * T * g_4_2 * s_4 * u_cr2 * v_4 * (0.03824063466179551 -
        0.036778288522458596 * T2) * (4.0 * s_4_2 - 3.0) * (g_4 * (0.9617593653382045 * T2 + 0.9617593653382045) +
        1.0) / (c * delta_4 * (c + delta_4)) - 0.029844887394714987 * T * g_3_2 * s_3 * u_cr2 * v_3 *
        (0.020657491936251805 - 0.020230759963155497 * T2) * (4.0 * s_3_2 - 3.0) * (g_3 * (0.97934250806374823 * T2
        + 0.97934250806374823) + 1.0) / (c * delta_3 * (c + delta_3)) - 0.14772846846434576 * T * g_21_2 * s_21 *
        u_cr2 * v_21 * (0.9630510568346482 - 0.035583718764315382 * T2) * (4.0 * s_21_2 - 3.0) * (g_21 *
        (0.036948943165351779 * T2 + 0.036948943165351779) + 1.0) / (c * delta_21 * (c + delta_21)) -
        0.14692162690693505 * T * g_20_2 * s_20 * u_cr2 * v_20 * (0.88935497279148013 - 0.098402705162545762 * T2) *
        (4.0 * s_20_2 - 3.0) * (g_20 * (0.11064502720851987 * T2 + 0.11064502720851987) + 1.0) / (c * delta_20 * (c
        + delta_20)) - 0.019072440603497005 * T * g_2_2 * s_2 * u_cr2 * v_2 * (0.0084227116591390795 -
        0.0083517695874460833 * T2) * (4.0 * s_2_2 - 3.0) * (g_2 * (0.9915772883408609 * T2 + 0.9915772883408609) +
        1.0) / (c * delta_2 * (c + delta_2)) - 0.14531235048760821 * T * g_19_2 * s_19 * u_cr2 * v_19 *
        (0.81626319343514542 - 0.14997759247820378 * T2) * (4.0 * s_19_2 - 3.0) * (g_19 * (0.18373680656485455 * T2
        + 0.18373680656485455) + 1.0) / (c * delta_19 * (c + delta_19)) - 0.14290942853034197 * T * g_18_2 * s_18 *
        u_cr2 * v_18 * (0.74417492065712088 - 0.1903786081220887 * T2) * (4.0 * s_18_2 - 3.0) * (g_18 *
        (0.25582507934287907 * T2 + 0.25582507934287907) + 1.0) / (c * delta_18 * (c + delta_18)) -
        0.13972598498518832 * T * g_17_2 * s_17 * u_cr2 * v_17 * (0.67348387553458844 - 0.21990334492949942 * T2) *
        (4.0 * s_17_2 - 3.0) * (g_17 * (0.32651612446541151 * T2 + 0.32651612446541151) + 1.0) / (c * delta_17 * (c
        + delta_17)) - 0.1357794067530439 * T * g_16_2 * s_16 * u_cr2 * v_16 * (0.60457614795702497 -
        0.23906382927847042 * T2) * (4.0 * s_16_2 - 3.0) * (g_16 * (0.39542385204297503 * T2 + 0.39542385204297503)
        + 1.0) / (c * delta_16 * (c + delta_16)) - 0.13109124872981795 * T * g_15_2 * s_15 * u_cr2 * v_15 *
        (0.53782808792957804 - 0.2485690357635921 * T2) * (4.0 * s_15_2 - 3.0) * (g_15 * (0.46217191207042191 * T2 +
        0.46217191207042191) + 1.0) / (c * delta_15 * (c + delta_15)) - 0.12568711609000516 * T * g_14_2 * s_14 *
        u_cr2 * v_14 * (0.47360425006880769 - 0.24930326438556996 * T2) * (4.0 * s_14_2 - 3.0) * (g_14 *
        (0.52639574993119231 * T2 + 0.52639574993119231) + 1.0) / (c * delta_14 * (c + delta_14)) -
        0.11959652445517331 * T * g_13_2 * s_13 * u_cr2 * v_13 * (0.41225540251489068 - 0.24230088561217614 * T2) *
        (4.0 * s_13_2 - 3.0) * (g_13 * (0.58774459748510932 * T2 + 0.58774459748510932) + 1.0) / (c * delta_13 * (c
        + delta_13)) - 0.11285273871603677 * T * g_12_2 * s_12 * u_cr2 * v_12 * (0.35411661113075216 -
        0.22871803685202383 * T2) * (4.0 * s_12_2 - 3.0) * (g_12 * (0.64588338886924779 * T2 + 0.64588338886924779)
        + 1.0) / (c * delta_12 * (c + delta_12)) - 0.10549259139834814 * T * g_11_2 * s_11 * u_cr2 * v_11 *
        (0.29950540944382881 - 0.20980191915771326 * T2) * (4.0 * s_11_2 - 3.0) * (g_11 * (0.70049459055617125 * T2
        + 0.70049459055617125) + 1.0) / (c * delta_11 * (c + delta_11)) - 0.097556281585606489 * T * g_10_2 * s_10 *
        u_cr2 * v_10 * (0.24872006431051952 - 0.18685839391989054 * T2) * (4.0 * s_10_2 - 3.0) * (g_10 *
        (0.75127993568948048 * T2 + 0.75127993568948048) + 1.0) / (c * delta_10 * (c + delta_10)) -
        0.0082119972092981695 * T * g_1_2 * s_1 * u_cr2 * v_1 * (0.0016003810099375849 - 0.0015978197905606162 * T2)
        * (4.0 * s_1_2 - 3.0) * (g_1 * (0.99839961899006247 * T2 + 0.99839961899006247) + 1.0) / (c * delta_1 * (c +
        delta_1));
    const double v_1_2 = v_1 * v_1;
    const double v_19_2 = v_19 * v_19;
    const double v_14_2 = v_14 * v_14;
    const double v_2_2 = v_2 * v_2;
    const double v_11_2 = v_11 * v_11;
    const double v_21_2 = v_21 * v_21;
    const double v_3_2 = v_3 * v_3;
    const double v_6_2 = v_6 * v_6;
    const double v_4_2 = v_4 * v_4;
    const double v_9_2 = v_9 * v_9;
    const double v_5_2 = v_5 * v_5;
    const double v_15_2 = v_15 * v_15;
    const double v_7_2 = v_7 * v_7;
    const double v_18_2 = v_18 * v_18;
    const double v_8_2 = v_8 * v_8;
    const double v_10_2 = v_10 * v_10;
    const double v_12_2 = v_12 * v_12;
    const double v_13_2 = v_13 * v_13;
    const double v_16_2 = v_16 * v_16;
    const double v_17_2 = v_17 * v_17;
    const double v_20_2 = v_20 * v_20;
    const double sum_3_1 = 0.0082119972092981695 * T * g_1 * s_1_2 * (4.0 * s_1_2 - 3.0) * (v_1_2 / (delta_1 *
        square_1) - g_1 * u_cr2 * (0.0016003810099375849 - 0.0015978197905606162 * T2) * (g_1 * (0.99839961899006247
        * T2 + 0.99839961899006247) + 1.0) / (c * delta_1 * (c + delta_1))) + 0.097556281585606489 * T * g_10 *
        s_10_2 * (4.0 * s_10_2 - 3.0) * (v_10_2 / (delta_10 * square_10) - g_10 * u_cr2 * (0.24872006431051952 -
        0.18685839391989054 * T2) * (g_10 * (0.75127993568948048 * T2 + 0.75127993568948048) + 1.0) / (c * delta_10
        * (c + delta_10))) + 0.10549259139834814 * T * g_11 * s_11_2 * (4.0 * s_11_2 - 3.0) * (v_11_2 / (delta_11 *
        square_11) - g_11 * u_cr2 * (0.29950540944382881 - 0.20980191915771326 * T2) * (g_11 * (0.70049459055617125
        * T2 + 0.70049459055617125) + 1.0) / (c * delta_11 * (c + delta_11))) + 0.11285273871603677 * T * g_12 *
        s_12_2 * (4.0 * s_12_2 - 3.0) * (v_12_2 / (delta_12 * square_12) - g_12 * u_cr2 * (0.35411661113075216 -
        0.22871803685202383 * T2) * (g_12 * (0.64588338886924779 * T2 + 0.64588338886924779) + 1.0) / (c * delta_12
        * (c + delta_12))) + 0.11959652445517331 * T * g_13 * s_13_2 * (4.0 * s_13_2 - 3.0) * (v_13_2 / (delta_13 *
        square_13) - g_13 * u_cr2 * (0.41225540251489068 - 0.24230088561217614 * T2) * (g_13 * (0.58774459748510932
        * T2 + 0.58774459748510932) + 1.0) / (c * delta_13 * (c + delta_13))) + 0.12568711609000516 * T * g_14 *
        s_14_2 * (4.0 * s_14_2 - 3.0) * (v_14_2 / (delta_14 * square_14) - g_14 * u_cr2 * (0.47360425006880769 -
        0.24930326438556996 * T2) * (g_14 * (0.52639574993119231 * T2 + 0.52639574993119231) + 1.0) / (c * delta_14
        * (c + delta_14))) + 0.13109124872981795 * T * g_15 * s_15_2 * (4.0 * s_15_2 - 3.0) * (v_15_2 / (delta_15 *
        square_15) - g_15 * u_cr2 * (0.53782808792957804 - 0.2485690357635921 * T2) * (g_15 * (0.46217191207042191 *
        T2 + 0.46217191207042191) + 1.0) / (c * delta_15 * (c + delta_15))) + 0.1357794067530439 * T * g_16 * s_16_2
        * (4.0 * s_16_2 - 3.0) * (v_16_2 / (delta_16 * square_16) - g_16 * u_cr2 * (0.60457614795702497 -
        0.23906382927847042 * T2) * (g_16 * (0.39542385204297503 * T2 + 0.39542385204297503) + 1.0) / (c * delta_16
        * (c + delta_16))) + 0.13972598498518832 * T * g_17 * s_17_2 * (4.0 * s_17_2 - 3.0) * (v_17_2 / (delta_17 *
        square_17) - g_17 * u_cr2 * (0.67348387553458844 - 0.21990334492949942 * T2) * (g_17 * (0.32651612446541151
        * T2 + 0.32651612446541151) + 1.0) / (c * delta_17 * (c + delta_17))) + 0.14290942853034197 * T * g_18 *
        s_18_2 * (4.0 * s_18_2 - 3.0) * (v_18_2 / (delta_18 * square_18) - g_18 * u_cr2 * (0.74417492065712088 -
        0.1903786081220887 * T2) * (g_18 * (0.25582507934287907 * T2 + 0.25582507934287907) + 1.0) / (c * delta_18 *
        (c + delta_18))) + 0.14531235048760821 * T * g_19 * s_19_2 * (4.0 * s_19_2 - 3.0) * (v_19_2 / (delta_19 *
        square_19) - g_19 * u_cr2 * (0.81626319343514542 - 0.14997759247820378 * T2) * (g_19 * (0.18373680656485455
        * T2 + 0.18373680656485455) + 1.0) / (c * delta_19 * (c + delta_19))) + 0.019072440603497005 * T * g_2 *
        s_2_2 * (4.0 * s_2_2 - 3.0) * (v_2_2 / (delta_2 * square_2) - g_2 * u_cr2 * (0.0084227116591390795 -
        0.0083517695874460833 * T2) * (g_2 * (0.9915772883408609 * T2 + 0.9915772883408609) + 1.0) / (c * delta_2 *
        (c + delta_2))) + 0.14692162690693505 * T * g_20 * s_20_2 * (4.0 * s_20_2 - 3.0) * (v_20_2 / (delta_20 *
        square_20) - g_20 * u_cr2 * (0.88935497279148013 - 0.098402705162545762 * T2) * (g_20 * (0.11064502720851987
        * T2 + 0.11064502720851987) + 1.0) / (c * delta_20 * (c + delta_20))) + 0.14772846846434576 * T * g_21 *
        s_21_2 * (4.0 * s_21_2 - 3.0) * (v_21_2 / (delta_21 * square_21) - g_21 * u_cr2 * (0.9630510568346482 -
        0.035583718764315382 * T2) * (g_21 * (0.036948943165351779 * T2 + 0.036948943165351779) + 1.0) / (c *
        delta_21 * (c + delta_21))) + 0.029844887394714987 * T * g_3 * s_3_2 * (4.0 * s_3_2 - 3.0) * (v_3_2 /
        (delta_3 * square_3) - g_3 * u_cr2 * (0.020657491936251805 - 0.020230759963155497 * T2) * (g_3 *
        (0.97934250806374823 * T2 + 0.97934250806374823) + 1.0) / (c * delta_3 * (c + delta_3))) +
        0.040455739138105289 * T * g_4 * s_4_2 * (4.0 * s_4_2 - 3.0) * (v_4_2 / (delta_4 * square_4) - g_4 * u_cr2 *
        (0.03824063466179551 - 0.036778288522458596 * T2) * (g_4 * (0.9617593653382045 * T2 + 0.9617593653382045) +
        1.0) / (c * delta_4 * (c + delta_4))) + 0.050845919052226095 * T * g_5 * s_5_2 * (4.0 * s_5_2 - 3.0) *
        (v_5_2 / (delta_5 * square_5) - g_5 * u_cr2 * (0.061076442645011823 - 0.057346110798842401 * T2) * (g_5 *
        (0.93892355735498823 * T2 + 0.93892355735498823) + 1.0) / (c * delta_5 * (c + delta_5))) +
        0.060958481399206933 * T * g_6 * s_6_2 * (4.0 * s_6_2 - 3.0) * (v_6_2 / (delta_6 * square_6) - g_6 * u_cr2 *
        (0.089040275095872548 - 0.081112104506723889 * T2) * (g_6 * (0.91095972490412747 * T2 + 0.91095972490412747)
        + 1.0) / (c * delta_6 * (c + delta_6))) + 0.07073814219518422 * T * g_7 * s_7_2 * (4.0 * s_7_2 - 3.0) *
        (v_7_2 / (delta_7 * square_7) - g_7 * u_cr2 * (0.12197943018782725 - 0.10710044879888024 * T2) * (g_7 *
        (0.87802056981217269 * T2 + 0.87802056981217269) + 1.0) / (c * delta_7 * (c + delta_7))) +
        0.08013147036138453 * T * g_8 * s_8_2 * (4.0 * s_8_2 - 3.0) * (v_8_2 / (delta_8 * square_8) - g_8 * u_cr2 *
        (0.15971401673818311 - 0.13420544959553846 * T2) * (g_8 * (0.84028598326181692 * T2 + 0.84028598326181692) +
        1.0) / (c * delta_8 * (c + delta_8))) + 0.089087155543931762 * T * g_9 * s_9_2 * (4.0 * s_9_2 - 3.0) *
        (v_9_2 / (delta_9 * square_9) - g_9 * u_cr2 * (0.20203794674451259 - 0.16121861481977409 * T2) * (g_9 *
        (0.79796205325548741 * T2 + 0.79796205325548741) + 1.0) / (c * delta_9 * (c + delta_9)));
    const double s_1_3 = s_1 * s_1_2;
    const double square_1_2 = square_1 * square_1;
    const double s_19_3 = s_19 * s_19_2;
    const double square_19_2 = square_19 * square_19;
    const double s_14_3 = s_14 * s_14_2;
    const double square_14_2 = square_14 * square_14;
    const double s_2_3 = s_2 * s_2_2;
    const double square_2_2 = square_2 * square_2;
    const double s_11_3 = s_11 * s_11_2;
    const double square_11_2 = square_11 * square_11;
    const double s_21_3 = s_21 * s_21_2;
    const double square_21_2 = square_21 * square_21;
    const double s_3_3 = s_3 * s_3_2;
    const double square_3_2 = square_3 * square_3;
    const double s_6_3 = s_6 * s_6_2;
    const double square_6_2 = square_6 * square_6;
    const double s_4_3 = s_4 * s_4_2;
    const double square_4_2 = square_4 * square_4;
    const double s_9_3 = s_9 * s_9_2;
    const double square_9_2 = square_9 * square_9;
    const double s_5_3 = s_5 * s_5_2;
    const double square_5_2 = square_5 * square_5;
    const double s_15_3 = s_15 * s_15_2;
    const double square_15_2 = square_15 * square_15;
    const double s_7_3 = s_7 * s_7_2;
    const double square_7_2 = square_7 * square_7;
    const double s_18_3 = s_18 * s_18_2;
    const double square_18_2 = square_18 * square_18;
    const double s_8_3 = s_8 * s_8_2;
    const double square_8_2 = square_8 * square_8;
    const double s_10_3 = s_10 * s_10_2;
    const double square_10_2 = square_10 * square_10;
    const double s_12_3 = s_12 * s_12_2;
    const double square_12_2 = square_12 * square_12;
    const double s_13_3 = s_13 * s_13_2;
    const double square_13_2 = square_13 * square_13;
    const double s_16_3 = s_16 * s_16_2;
    const double square_16_2 = square_16 * square_16;
    const double s_17_3 = s_17 * s_17_2;
    const double square_17_2 = square_17 * square_17;
    const double s_20_3 = s_20 * s_20_2;
    const double square_20_2 = square_20 * square_20;
    const double sum_3_2 = 0.26726146663179529 * T * g_9 * s_9_3 * v_9 * (4.0 * s_9_2 - 3.0) / (delta_9 *
        square_9_2) + 0.24039441108415358 * T * g_8 * s_8_3 * v_8 * (4.0 * s_8_2 - 3.0) / (delta_8 * square_8_2) +
        0.21221442658555267 * T * g_7 * s_7_3 * v_7 * (4.0 * s_7_2 - 3.0) / (delta_7 * square_7_2) +
        0.18287544419762081 * T * g_6 * s_6_3 * v_6 * (4.0 * s_6_2 - 3.0) / (delta_6 * square_6_2) +
        0.15253775715667828 * T * g_5 * s_5_3 * v_5 * (4.0 * s_5_2 - 3.0) / (delta_5 * square_5_2) +
        0.12136721741431587 * T * g_4 * s_4_3 * v_4 * (4.0 * s_4_2 - 3.0) / (delta_4 * square_4_2) +
        0.089534662184144964 * T * g_3 * s_3_3 * v_3 * (4.0 * s_3_2 - 3.0) / (delta_3 * square_3_2) +
        0.4431854053930373 * T * g_21 * s_21_3 * v_21 * (4.0 * s_21_2 - 3.0) / (delta_21 * square_21_2) +
        0.44076488072080516 * T * g_20 * s_20_3 * v_20 * (4.0 * s_20_2 - 3.0) / (delta_20 * square_20_2) +
        0.057217321810491016 * T * g_2 * s_2_3 * v_2 * (4.0 * s_2_2 - 3.0) / (delta_2 * square_2_2) +
        0.43593705146282463 * T * g_19 * s_19_3 * v_19 * (4.0 * s_19_2 - 3.0) / (delta_19 * square_19_2) +
        0.42872828559102588 * T * g_18 * s_18_3 * v_18 * (4.0 * s_18_2 - 3.0) / (delta_18 * square_18_2) +
        0.41917795495556498 * T * g_17 * s_17_3 * v_17 * (4.0 * s_17_2 - 3.0) / (delta_17 * square_17_2) +
        0.40733822025913169 * T * g_16 * s_16_3 * v_16 * (4.0 * s_16_2 - 3.0) / (delta_16 * square_16_2) +
        0.39327374618945388 * T * g_15 * s_15_3 * v_15 * (4.0 * s_15_2 - 3.0) / (delta_15 * square_15_2) +
        0.37706134827001547 * T * g_14 * s_14_3 * v_14 * (4.0 * s_14_2 - 3.0) / (delta_14 * square_14_2) +
        0.35878957336551992 * T * g_13 * s_13_3 * v_13 * (4.0 * s_13_2 - 3.0) / (delta_13 * square_13_2) +
        0.33855821614811027 * T * g_12 * s_12_3 * v_12 * (4.0 * s_12_2 - 3.0) / (delta_12 * square_12_2) +
        0.31647777419504441 * T * g_11 * s_11_3 * v_11 * (4.0 * s_11_2 - 3.0) / (delta_11 * square_11_2) +
        0.29266884475681948 * T * g_10 * s_10_3 * v_10 * (4.0 * s_10_2 - 3.0) / (delta_10 * square_10_2) +
        0.024635991627894507 * T * g_1 * s_1_3 * v_1 * (4.0 * s_1_2 - 3.0) / (delta_1 * square_1_2);
    const double s_1_4 = s_1_2 * s_1_2;
    const double square_1_3 = square_1 * square_1_2;
    const double s_19_4 = s_19_2 * s_19_2;
    const double square_19_3 = square_19 * square_19_2;
    const double s_14_4 = s_14_2 * s_14_2;
    const double square_14_3 = square_14 * square_14_2;
    const double s_2_4 = s_2_2 * s_2_2;
    const double square_2_3 = square_2 * square_2_2;
    const double s_11_4 = s_11_2 * s_11_2;
    const double square_11_3 = square_11 * square_11_2;
    const double s_21_4 = s_21_2 * s_21_2;
    const double square_21_3 = square_21 * square_21_2;
    const double s_3_4 = s_3_2 * s_3_2;
    const double square_3_3 = square_3 * square_3_2;
    const double s_6_4 = s_6_2 * s_6_2;
    const double square_6_3 = square_6 * square_6_2;
    const double s_4_4 = s_4_2 * s_4_2;
    const double square_4_3 = square_4 * square_4_2;
    const double s_9_4 = s_9_2 * s_9_2;
    const double square_9_3 = square_9 * square_9_2;
    const double s_5_4 = s_5_2 * s_5_2;
    const double square_5_3 = square_5 * square_5_2;
    const double s_15_4 = s_15_2 * s_15_2;
    const double square_15_3 = square_15 * square_15_2;
    const double s_7_4 = s_7_2 * s_7_2;
    const double square_7_3 = square_7 * square_7_2;
    const double s_18_4 = s_18_2 * s_18_2;
    const double square_18_3 = square_18 * square_18_2;
    const double s_8_4 = s_8_2 * s_8_2;
    const double square_8_3 = square_8 * square_8_2;
    const double s_10_4 = s_10_2 * s_10_2;
    const double square_10_3 = square_10 * square_10_2;
    const double s_12_4 = s_12_2 * s_12_2;
    const double square_12_3 = square_12 * square_12_2;
    const double s_13_4 = s_13_2 * s_13_2;
    const double square_13_3 = square_13 * square_13_2;
    const double s_16_4 = s_16_2 * s_16_2;
    const double square_16_3 = square_16 * square_16_2;
    const double s_17_4 = s_17_2 * s_17_2;
    const double square_17_3 = square_17 * square_17_2;
    const double s_20_4 = s_20_2 * s_20_2;
    const double square_20_3 = square_20 * square_20_2;
    const double sum_3_3 = 0.089087155543931762 * T * g_9 * s_9_4 * (4.0 * s_9_2 - 3.0) * (12.0 * v_9_2 + 3.0) /
        (delta_9 * square_9_3) + 0.08013147036138453 * T * g_8 * s_8_4 * (4.0 * s_8_2 - 3.0) * (12.0 * v_8_2 + 3.0)
        / (delta_8 * square_8_3) + 0.07073814219518422 * T * g_7 * s_7_4 * (4.0 * s_7_2 - 3.0) * (12.0 * v_7_2 +
        3.0) / (delta_7 * square_7_3) + 0.060958481399206933 * T * g_6 * s_6_4 * (4.0 * s_6_2 - 3.0) * (12.0 * v_6_2
        + 3.0) / (delta_6 * square_6_3) + 0.050845919052226095 * T * g_5 * s_5_4 * (4.0 * s_5_2 - 3.0) * (12.0 *
        v_5_2 + 3.0) / (delta_5 * square_5_3) + 0.040455739138105289 * T * g_4 * s_4_4 * (4.0 * s_4_2 - 3.0) * (12.0
        * v_4_2 + 3.0) / (delta_4 * square_4_3) + 0.029844887394714987 * T * g_3 * s_3_4 * (4.0 * s_3_2 - 3.0) *
        (12.0 * v_3_2 + 3.0) / (delta_3 * square_3_3) + 0.14772846846434576 * T * g_21 * s_21_4 * (4.0 * s_21_2 -
        3.0) * (12.0 * v_21_2 + 3.0) / (delta_21 * square_21_3) + 0.14692162690693505 * T * g_20 * s_20_4 * (4.0 *
        s_20_2 - 3.0) * (12.0 * v_20_2 + 3.0) / (delta_20 * square_20_3) + 0.019072440603497005 * T * g_2 * s_2_4 *
        (4.0 * s_2_2 - 3.0) * (12.0 * v_2_2 + 3.0) / (delta_2 * square_2_3) + 0.14531235048760821 * T * g_19 *
        s_19_4 * (4.0 * s_19_2 - 3.0) * (12.0 * v_19_2 + 3.0) / (delta_19 * square_19_3) + 0.14290942853034197 * T *
        g_18 * s_18_4 * (4.0 * s_18_2 - 3.0) * (12.0 * v_18_2 + 3.0) / (delta_18 * square_18_3) +
        0.13972598498518832 * T * g_17 * s_17_4 * (4.0 * s_17_2 - 3.0) * (12.0 * v_17_2 + 3.0) / (delta_17 *
        square_17_3) + 0.1357794067530439 * T * g_16 * s_16_4 * (4.0 * s_16_2 - 3.0) * (12.0 * v_16_2 + 3.0) /
        (delta_16 * square_16_3) + 0.13109124872981795 * T * g_15 * s_15_4 * (4.0 * s_15_2 - 3.0) * (12.0 * v_15_2 +
        3.0) / (delta_15 * square_15_3) + 0.12568711609000516 * T * g_14 * s_14_4 * (4.0 * s_14_2 - 3.0) * (12.0 *
        v_14_2 + 3.0) / (delta_14 * square_14_3) + 0.11959652445517331 * T * g_13 * s_13_4 * (4.0 * s_13_2 - 3.0) *
        (12.0 * v_13_2 + 3.0) / (delta_13 * square_13_3) + 0.11285273871603677 * T * g_12 * s_12_4 * (4.0 * s_12_2 -
        3.0) * (12.0 * v_12_2 + 3.0) / (delta_12 * square_12_3) + 0.10549259139834814 * T * g_11 * s_11_4 * (4.0 *
        s_11_2 - 3.0) * (12.0 * v_11_2 + 3.0) / (delta_11 * square_11_3) + 0.097556281585606489 * T * g_10 * s_10_4
        * (4.0 * s_10_2 - 3.0) * (12.0 * v_10_2 + 3.0) / (delta_10 * square_10_3) + 0.0082119972092981695 * T * g_1
        * s_1_4 * (4.0 * s_1_2 - 3.0) * (12.0 * v_1_2 + 3.0) / (delta_1 * square_1_3);
    const double sum_5_0 = -0.089087155543931762 * T * g_9_2 * s_9 * u_cr2 * v_9 * (0.20203794674451259 -
        0.16121861481977409 * T2) * (g_9 * (0.79796205325548741 * T2 + 0.79796205325548741) + 1.0) * (s_9_2 * (16.0
        * s_9_2 - 20.0) + 5.0) / (c * delta_9 * (c + delta_9)) - 0.08013147036138453 * T * g_8_2 * s_8 * u_cr2 * v_8
        * (0.15971401673818311 - 0.13420544959553846 * T2) * (g_8 * (0.84028598326181692 * T2 + 0.84028598326181692)
        + 1.0) * (s_8_2 * (16.0 * s_8_2 - 20.0) + 5.0) / (c * delta_8 * (c + delta_8)) - 0.07073814219518422 * T *
        g_7_2 * s_7 * u_cr2 * v_7 * (0.12197943018782725 - 0.10710044879888024 * T2) * (g_7 * (0.87802056981217269 *
        T2 + 0.87802056981217269) + 1.0) * (s_7_2 * (16.0 * s_7_2 - 20.0) + 5.0) / (c * delta_7 * (c + delta_7)) -
        0.060958481399206933 * T * g_6_2 * s_6 * u_cr2 * v_6 * (0.089040275095872548 - 0.081112104506723889 * T2) *
        (g_6 * (0.91095972490412747 * T2 + 0.91095972490412747) + 1.0) * (s_6_2 * (16.0 * s_6_2 - 20.0) + 5.0) / (c
        * delta_6 * (c + delta_6)) - 0.050845919052226095 * T * g_5_2 * s_5 * u_cr2 * v_5 * (0.061076442645011823 -
        0.057346110798842401 * T2) * (g_5 * (0.93892355735498823 * T2 + 0.93892355735498823) + 1.0) * (s_5_2 * (16.0
        * s_5_2 - 20.0) + 5.0) / (c * delta_5 * (c + delta_5)) - 0.040455739138105289 * T * g_4_2 * s_4 * u_cr2 *
        v_4 * (0.03824063466179551 - 0.036778288522458596 * T2) * (g_4 * (0.9617593653382045 * T2 +
        0.9617593653382045) + 1.0) * (s_4_2 * (16.0 * s_4_2 - 20.0) + 5.0) / (c * delta_4 * (c + delta_4)) -
        0.029844887394714987 * T * g_3_2 * s_3 * u_cr2 * v_3 * (0.020657491936251805 - 0.020230759963155497 * T2) *
        (g_3 * (0.97934250806374823 * T2 + 0.97934250806374823) + 1.0) * (s_3_2 * (16.0 * s_3_2 - 20.0) + 5.0) / (c
        * delta_3 * (c + delta_3)) - 0.14772846846434576 * T * g_21_2 * s_21 * u_cr2 * v_21 * (0.9630510568346482 -
        0.035583718764315382 * T2) * (g_21 * (0.036948943165351779 * T2 + 0.036948943165351779) + 1.0) * (s_21_2 *
        (16.0 * s_21_2 - 20.0) + 5.0) / (c * delta_21 * (c + delta_21)) - 0.14692162690693505 * T * g_20_2 * s_20 *
        u_cr2 * v_20 * (0.88935497279148013 - 0.098402705162545762 * T2) * (g_20 * (0.11064502720851987 * T2 +
        0.11064502720851987) + 1.0) * (s_20_2 * (16.0 * s_20_2 - 20.0) + 5.0) / (c * delta_20 * (c + delta_20)) -
        0.019072440603497005 * T * g_2_2 * s_2 * u_cr2 * v_2 * (0.0084227116591390795 - 0.0083517695874460833 * T2)
        * (g_2 * (0.9915772883408609 * T2 + 0.9915772883408609) + 1.0) * (s_2_2 * (16.0 * s_2_2 - 20.0) + 5.0) / (c
        * delta_2 * (c + delta_2)) - 0.14531235048760821 * T * g_19_2 * s_19 * u_cr2 * v_19 * (0.81626319343514542 -
        0.14997759247820378 * T2) * (g_19 * (0.18373680656485455 * T2 + 0.18373680656485455) + 1.0) * (s_19_2 *
        (16.0 * s_19_2 - 20.0) + 5.0) / (c * delta_19 * (c + delta_19)) - 0.14290942853034197 * T * g_18_2 * s_18 *
        u_cr2 * v_18 * (0.74417492065712088 - 0.1903786081220887 * T2) * (g_18 * (0.25582507934287907 * T2 +
        0.25582507934287907) + 1.0) * (s_18_2 * (16.0 * s_18_2 - 20.0) + 5.0) / (c * delta_18 * (c + delta_18)) -
        0.13972598498518832 * T * g_17_2 * s_17 * u_cr2 * v_17 * (0.67348387553458844 - 0.21990334492949942 * T2) *
        (g_17 * (0.32651612446541151 * T2 + 0.32651612446541151) + 1.0) * (s_17_2 * (16.0 * s_17_2 - 20.0) + 5.0) /
        (c * delta_17 * (c + delta_17)) - 0.1357794067530439 * T * g_16_2 * s_16 * u_cr2 * v_16 *
        (0.60457614795702497 - 0.23906382927847042 * T2) * (g_16 * (0.39542385204297503 * T2 + 0.39542385204297503)
        + 1.0) * (s_16_2 * (16.0 * s_16_2 - 20.0) + 5.0) / (c * delta_16 * (c + delta_16)) - 0.13109124872981795 * T
        * g_15_2 * s_15 * u_cr2 * v_15 * (0.53782808792957804 - 0.2485690357635921 * T2) * (g_15 *
        (0.46217191207042191 * T2 + 0.46217191207042191) + 1.0) * (s_15_2 * (16.0 * s_15_2 - 20.0) + 5.0) / (c *
        delta_15 * (c + delta_15)) - 0.12568711609000516 * T * g_14_2 * s_14 * u_cr2 * v_14 * (0.47360425006880769 -
        0.24930326438556996 * T2) * (g_14 * (0.52639574993119231 * T2 + 0.52639574993119231) + 1.0) * (s_14_2 *
        (16.0 * s_14_2 - 20.0) + 5.0) / (c * delta_14 * (c + delta_14)) - 0.11959652445517331 * T * g_13_2 * s_13 *
        u_cr2 * v_13 * (0.41225540251489068 - 0.24230088561217614 * T2) * (g_13 * (0.58774459748510932 * T2 +
        0.58774459748510932) + 1.0) * (s_13_2 * (16.0 * s_13_2 - 20.0) + 5.0) / (c * delta_13 * (c + delta_13)) -
        0.11285273871603677 * T * g_12_2 * s_12 * u_cr2 * v_12 * (0.35411661113075216 - 0.22871803685202383 * T2) *
        (g_12 * (0.64588338886924779 * T2 + 0.64588338886924779) + 1.0) * (s_12_2 * (16.0 * s_12_2 - 20.0) + 5.0) /
        (c * delta_12 * (c + delta_12)) - 0.10549259139834814 * T * g_11_2 * s_11 * u_cr2 * v_11 *
        (0.29950540944382881 - 0.20980191915771326 * T2) * (g_11 * (0.70049459055617125 * T2 + 0.70049459055617125)
        + 1.0) * (s_11_2 * (16.0 * s_11_2 - 20.0) + 5.0) / (c * delta_11 * (c + delta_11)) - 0.097556281585606489 *
        T * g_10_2 * s_10 * u_cr2 * v_10 * (0.24872006431051952 - 0.18685839391989054 * T2) * (g_10 *
        (0.75127993568948048 * T2 + 0.75127993568948048) + 1.0) * (s_10_2 * (16.0 * s_10_2 - 20.0) + 5.0) / (c *
        delta_10 * (c + delta_10)) - 0.0082119972092981695 * T * g_1_2 * s_1 * u_cr2 * v_1 * (0.0016003810099375849
        - 0.0015978197905606162 * T2) * (g_1 * (0.99839961899006247 * T2 + 0.99839961899006247) + 1.0) * (s_1_2 *
        (16.0 * s_1_2 - 20.0) + 5.0) / (c * delta_1 * (c + delta_1));
    const double sum_5_1 = 0.0082119972092981695 * T * g_1 * s_1_2 * (s_1_2 * (16.0 * s_1_2 - 20.0) + 5.0) * (v_1_2
        / (delta_1 * square_1) - g_1 * u_cr2 * (0.0016003810099375849 - 0.0015978197905606162 * T2) * (g_1 *
        (0.99839961899006247 * T2 + 0.99839961899006247) + 1.0) / (c * delta_1 * (c + delta_1))) +
        0.097556281585606489 * T * g_10 * s_10_2 * (s_10_2 * (16.0 * s_10_2 - 20.0) + 5.0) * (v_10_2 / (delta_10 *
        square_10) - g_10 * u_cr2 * (0.24872006431051952 - 0.18685839391989054 * T2) * (g_10 * (0.75127993568948048
        * T2 + 0.75127993568948048) + 1.0) / (c * delta_10 * (c + delta_10))) + 0.10549259139834814 * T * g_11 *
        s_11_2 * (s_11_2 * (16.0 * s_11_2 - 20.0) + 5.0) * (v_11_2 / (delta_11 * square_11) - g_11 * u_cr2 *
        (0.29950540944382881 - 0.20980191915771326 * T2) * (g_11 * (0.70049459055617125 * T2 + 0.70049459055617125)
        + 1.0) / (c * delta_11 * (c + delta_11))) + 0.11285273871603677 * T * g_12 * s_12_2 * (s_12_2 * (16.0 *
        s_12_2 - 20.0) + 5.0) * (v_12_2 / (delta_12 * square_12) - g_12 * u_cr2 * (0.35411661113075216 -
        0.22871803685202383 * T2) * (g_12 * (0.64588338886924779 * T2 + 0.64588338886924779) + 1.0) / (c * delta_12
        * (c + delta_12))) + 0.11959652445517331 * T * g_13 * s_13_2 * (s_13_2 * (16.0 * s_13_2 - 20.0) + 5.0) *
        (v_13_2 / (delta_13 * square_13) - g_13 * u_cr2 * (0.41225540251489068 - 0.24230088561217614 * T2) * (g_13 *
        (0.58774459748510932 * T2 + 0.58774459748510932) + 1.0) / (c * delta_13 * (c + delta_13))) +
        0.12568711609000516 * T * g_14 * s_14_2 * (s_14_2 * (16.0 * s_14_2 - 20.0) + 5.0) * (v_14_2 / (delta_14 *
        square_14) - g_14 * u_cr2 * (0.47360425006880769 - 0.24930326438556996 * T2) * (g_14 * (0.52639574993119231
        * T2 + 0.52639574993119231) + 1.0) / (c * delta_14 * (c + delta_14))) + 0.13109124872981795 * T * g_15 *
        s_15_2 * (s_15_2 * (16.0 * s_15_2 - 20.0) + 5.0) * (v_15_2 / (delta_15 * square_15) - g_15 * u_cr2 *
        (0.53782808792957804 - 0.2485690357635921 * T2) * (g_15 * (0.46217191207042191 * T2 + 0.46217191207042191) +
        1.0) / (c * delta_15 * (c + delta_15))) + 0.1357794067530439 * T * g_16 * s_16_2 * (s_16_2 * (16.0 * s_16_2
        - 20.0) + 5.0) * (v_16_2 / (delta_16 * square_16) - g_16 * u_cr2 * (0.60457614795702497 -
        0.23906382927847042 * T2) * (g_16 * (0.39542385204297503 * T2 + 0.39542385204297503) + 1.0) / (c * delta_16
        * (c + delta_16))) + 0.13972598498518832 * T * g_17 * s_17_2 * (s_17_2 * (16.0 * s_17_2 - 20.0) + 5.0) *
        (v_17_2 / (delta_17 * square_17) - g_17 * u_cr2 * (0.67348387553458844 - 0.21990334492949942 * T2) * (g_17 *
        (0.32651612446541151 * T2 + 0.32651612446541151) + 1.0) / (c * delta_17 * (c + delta_17))) +
        0.14290942853034197 * T * g_18 * s_18_2 * (s_18_2 * (16.0 * s_18_2 - 20.0) + 5.0) * (v_18_2 / (delta_18 *
        square_18) - g_18 * u_cr2 * (0.74417492065712088 - 0.1903786081220887 * T2) * (g_18 * (0.25582507934287907 *
        T2 + 0.25582507934287907) + 1.0) / (c * delta_18 * (c + delta_18))) + 0.14531235048760821 * T * g_19 *
        s_19_2 * (s_19_2 * (16.0 * s_19_2 - 20.0) + 5.0) * (v_19_2 / (delta_19 * square_19) - g_19 * u_cr2 *
        (0.81626319343514542 - 0.14997759247820378 * T2) * (g_19 * (0.18373680656485455 * T2 + 0.18373680656485455)
        + 1.0) / (c * delta_19 * (c + delta_19))) + 0.019072440603497005 * T * g_2 * s_2_2 * (s_2_2 * (16.0 * s_2_2
        - 20.0) + 5.0) * (v_2_2 / (delta_2 * square_2) - g_2 * u_cr2 * (0.0084227116591390795 -
        0.0083517695874460833 * T2) * (g_2 * (0.9915772883408609 * T2 + 0.9915772883408609) + 1.0) / (c * delta_2 *
        (c + delta_2))) + 0.14692162690693505 * T * g_20 * s_20_2 * (s_20_2 * (16.0 * s_20_2 - 20.0) + 5.0) *
        (v_20_2 / (delta_20 * square_20) - g_20 * u_cr2 * (0.88935497279148013 - 0.098402705162545762 * T2) * (g_20
        * (0.11064502720851987 * T2 + 0.11064502720851987) + 1.0) / (c * delta_20 * (c + delta_20))) +
        0.14772846846434576 * T * g_21 * s_21_2 * (s_21_2 * (16.0 * s_21_2 - 20.0) + 5.0) * (v_21_2 / (delta_21 *
        square_21) - g_21 * u_cr2 * (0.9630510568346482 - 0.035583718764315382 * T2) * (g_21 * (0.036948943165351779
        * T2 + 0.036948943165351779) + 1.0) / (c * delta_21 * (c + delta_21))) + 0.029844887394714987 * T * g_3 *
        s_3_2 * (s_3_2 * (16.0 * s_3_2 - 20.0) + 5.0) * (v_3_2 / (delta_3 * square_3) - g_3 * u_cr2 *
        (0.020657491936251805 - 0.020230759963155497 * T2) * (g_3 * (0.97934250806374823 * T2 + 0.97934250806374823)
        + 1.0) / (c * delta_3 * (c + delta_3))) + 0.040455739138105289 * T * g_4 * s_4_2 * (s_4_2 * (16.0 * s_4_2 -
        20.0) + 5.0) * (v_4_2 / (delta_4 * square_4) - g_4 * u_cr2 * (0.03824063466179551 - 0.036778288522458596 *
        T2) * (g_4 * (0.9617593653382045 * T2 + 0.9617593653382045) + 1.0) / (c * delta_4 * (c + delta_4))) +
        0.050845919052226095 * T * g_5 * s_5_2 * (s_5_2 * (16.0 * s_5_2 - 20.0) + 5.0) * (v_5_2 / (delta_5 *
        square_5) - g_5 * u_cr2 * (0.061076442645011823 - 0.057346110798842401 * T2) * (g_5 * (0.93892355735498823 *
        T2 + 0.93892355735498823) + 1.0) / (c * delta_5 * (c + delta_5))) + 0.060958481399206933 * T * g_6 * s_6_2 *
        (s_6_2 * (16.0 * s_6_2 - 20.0) + 5.0) * (v_6_2 / (delta_6 * square_6) - g_6 * u_cr2 * (0.089040275095872548
        - 0.081112104506723889 * T2) * (g_6 * (0.91095972490412747 * T2 + 0.91095972490412747) + 1.0) / (c * delta_6
        * (c + delta_6))) + 0.07073814219518422 * T * g_7 * s_7_2 * (s_7_2 * (16.0 * s_7_2 - 20.0) + 5.0) * (v_7_2 /
        (delta_7 * square_7) - g_7 * u_cr2 * (0.12197943018782725 - 0.10710044879888024 * T2) * (g_7 *
        (0.87802056981217269 * T2 + 0.87802056981217269) + 1.0) / (c * delta_7 * (c + delta_7))) +
        0.08013147036138453 * T * g_8 * s_8_2 * (s_8_2 * (16.0 * s_8_2 - 20.0) + 5.0) * (v_8_2 / (delta_8 *
        square_8) - g_8 * u_cr2 * (0.15971401673818311 - 0.13420544959553846 * T2) * (g_8 * (0.84028598326181692 *
        T2 + 0.84028598326181692) + 1.0) / (c * delta_8 * (c + delta_8))) + 0.089087155543931762 * T * g_9 * s_9_2 *
        (s_9_2 * (16.0 * s_9_2 - 20.0) + 5.0) * (v_9_2 / (delta_9 * square_9) - g_9 * u_cr2 * (0.20203794674451259 -
        0.16121861481977409 * T2) * (g_9 * (0.79796205325548741 * T2 + 0.79796205325548741) + 1.0) / (c * delta_9 *
        (c + delta_9)));
    const double sum_5_2 = 0.26726146663179529 * T * g_9 * s_9_3 * v_9 * (s_9_2 * (16.0 * s_9_2 - 20.0) + 5.0) /
        (delta_9 * square_9_2) + 0.24039441108415358 * T * g_8 * s_8_3 * v_8 * (s_8_2 * (16.0 * s_8_2 - 20.0) + 5.0)
        / (delta_8 * square_8_2) + 0.21221442658555267 * T * g_7 * s_7_3 * v_7 * (s_7_2 * (16.0 * s_7_2 - 20.0) +
        5.0) / (delta_7 * square_7_2) + 0.18287544419762081 * T * g_6 * s_6_3 * v_6 * (s_6_2 * (16.0 * s_6_2 - 20.0)
        + 5.0) / (delta_6 * square_6_2) + 0.15253775715667828 * T * g_5 * s_5_3 * v_5 * (s_5_2 * (16.0 * s_5_2 -
        20.0) + 5.0) / (delta_5 * square_5_2) + 0.12136721741431587 * T * g_4 * s_4_3 * v_4 * (s_4_2 * (16.0 * s_4_2
        - 20.0) + 5.0) / (delta_4 * square_4_2) + 0.089534662184144964 * T * g_3 * s_3_3 * v_3 * (s_3_2 * (16.0 *
        s_3_2 - 20.0) + 5.0) / (delta_3 * square_3_2) + 0.4431854053930373 * T * g_21 * s_21_3 * v_21 * (s_21_2 *
        (16.0 * s_21_2 - 20.0) + 5.0) / (delta_21 * square_21_2) + 0.44076488072080516 * T * g_20 * s_20_3 * v_20 *
        (s_20_2 * (16.0 * s_20_2 - 20.0) + 5.0) / (delta_20 * square_20_2) + 0.057217321810491016 * T * g_2 * s_2_3
        * v_2 * (s_2_2 * (16.0 * s_2_2 - 20.0) + 5.0) / (delta_2 * square_2_2) + 0.43593705146282463 * T * g_19 *
        s_19_3 * v_19 * (s_19_2 * (16.0 * s_19_2 - 20.0) + 5.0) / (delta_19 * square_19_2) + 0.42872828559102588 * T
        * g_18 * s_18_3 * v_18 * (s_18_2 * (16.0 * s_18_2 - 20.0) + 5.0) / (delta_18 * square_18_2) +
        0.41917795495556498 * T * g_17 * s_17_3 * v_17 * (s_17_2 * (16.0 * s_17_2 - 20.0) + 5.0) / (delta_17 *
        square_17_2) + 0.40733822025913169 * T * g_16 * s_16_3 * v_16 * (s_16_2 * (16.0 * s_16_2 - 20.0) + 5.0) /
        (delta_16 * square_16_2) + 0.39327374618945388 * T * g_15 * s_15_3 * v_15 * (s_15_2 * (16.0 * s_15_2 - 20.0)
        + 5.0) / (delta_15 * square_15_2) + 0.37706134827001547 * T * g_14 * s_14_3 * v_14 * (s_14_2 * (16.0 *
        s_14_2 - 20.0) + 5.0) / (delta_14 * square_14_2) + 0.35878957336551992 * T * g_13 * s_13_3 * v_13 * (s_13_2
        * (16.0 * s_13_2 - 20.0) + 5.0) / (delta_13 * square_13_2) + 0.33855821614811027 * T * g_12 * s_12_3 * v_12
        * (s_12_2 * (16.0 * s_12_2 - 20.0) + 5.0) / (delta_12 * square_12_2) + 0.31647777419504441 * T * g_11 *
        s_11_3 * v_11 * (s_11_2 * (16.0 * s_11_2 - 20.0) + 5.0) / (delta_11 * square_11_2) + 0.29266884475681948 * T
        * g_10 * s_10_3 * v_10 * (s_10_2 * (16.0 * s_10_2 - 20.0) + 5.0) / (delta_10 * square_10_2) +
        0.024635991627894507 * T * g_1 * s_1_3 * v_1 * (s_1_2 * (16.0 * s_1_2 - 20.0) + 5.0) / (delta_1 *
        square_1_2);
    const double sum_5_3 = 0.089087155543931762 * T * g_9 * s_9_4 * (12.0 * v_9_2 + 3.0) * (s_9_2 * (16.0 * s_9_2 -
        20.0) + 5.0) / (delta_9 * square_9_3) + 0.08013147036138453 * T * g_8 * s_8_4 * (12.0 * v_8_2 + 3.0) *
        (s_8_2 * (16.0 * s_8_2 - 20.0) + 5.0) / (delta_8 * square_8_3) + 0.07073814219518422 * T * g_7 * s_7_4 *
        (12.0 * v_7_2 + 3.0) * (s_7_2 * (16.0 * s_7_2 - 20.0) + 5.0) / (delta_7 * square_7_3) + 0.060958481399206933
        * T * g_6 * s_6_4 * (12.0 * v_6_2 + 3.0) * (s_6_2 * (16.0 * s_6_2 - 20.0) + 5.0) / (delta_6 * square_6_3) +
        0.050845919052226095 * T * g_5 * s_5_4 * (12.0 * v_5_2 + 3.0) * (s_5_2 * (16.0 * s_5_2 - 20.0) + 5.0) /
        (delta_5 * square_5_3) + 0.040455739138105289 * T * g_4 * s_4_4 * (12.0 * v_4_2 + 3.0) * (s_4_2 * (16.0 *
        s_4_2 - 20.0) + 5.0) / (delta_4 * square_4_3) + 0.029844887394714987 * T * g_3 * s_3_4 * (12.0 * v_3_2 +
        3.0) * (s_3_2 * (16.0 * s_3_2 - 20.0) + 5.0) / (delta_3 * square_3_3) + 0.14772846846434576 * T * g_21 *
        s_21_4 * (12.0 * v_21_2 + 3.0) * (s_21_2 * (16.0 * s_21_2 - 20.0) + 5.0) / (delta_21 * square_21_3) +
        0.14692162690693505 * T * g_20 * s_20_4 * (12.0 * v_20_2 + 3.0) * (s_20_2 * (16.0 * s_20_2 - 20.0) + 5.0) /
        (delta_20 * square_20_3) + 0.019072440603497005 * T * g_2 * s_2_4 * (12.0 * v_2_2 + 3.0) * (s_2_2 * (16.0 *
        s_2_2 - 20.0) + 5.0) / (delta_2 * square_2_3) + 0.14531235048760821 * T * g_19 * s_19_4 * (12.0 * v_19_2 +
        3.0) * (s_19_2 * (16.0 * s_19_2 - 20.0) + 5.0) / (delta_19 * square_19_3) + 0.14290942853034197 * T * g_18 *
        s_18_4 * (12.0 * v_18_2 + 3.0) * (s_18_2 * (16.0 * s_18_2 - 20.0) + 5.0) / (delta_18 * square_18_3) +
        0.13972598498518832 * T * g_17 * s_17_4 * (12.0 * v_17_2 + 3.0) * (s_17_2 * (16.0 * s_17_2 - 20.0) + 5.0) /
        (delta_17 * square_17_3) + 0.1357794067530439 * T * g_16 * s_16_4 * (12.0 * v_16_2 + 3.0) * (s_16_2 * (16.0
        * s_16_2 - 20.0) + 5.0) / (delta_16 * square_16_3) + 0.13109124872981795 * T * g_15 * s_15_4 * (12.0 *
        v_15_2 + 3.0) * (s_15_2 * (16.0 * s_15_2 - 20.0) + 5.0) / (delta_15 * square_15_3) + 0.12568711609000516 * T
        * g_14 * s_14_4 * (12.0 * v_14_2 + 3.0) * (s_14_2 * (16.0 * s_14_2 - 20.0) + 5.0) / (delta_14 * square_14_3)
        + 0.11959652445517331 * T * g_13 * s_13_4 * (12.0 * v_13_2 + 3.0) * (s_13_2 * (16.0 * s_13_2 - 20.0) + 5.0)
        / (delta_13 * square_13_3) + 0.11285273871603677 * T * g_12 * s_12_4 * (12.0 * v_12_2 + 3.0) * (s_12_2 *
        (16.0 * s_12_2 - 20.0) + 5.0) / (delta_12 * square_12_3) + 0.10549259139834814 * T * g_11 * s_11_4 * (12.0 *
        v_11_2 + 3.0) * (s_11_2 * (16.0 * s_11_2 - 20.0) + 5.0) / (delta_11 * square_11_3) + 0.097556281585606489 *
        T * g_10 * s_10_4 * (12.0 * v_10_2 + 3.0) * (s_10_2 * (16.0 * s_10_2 - 20.0) + 5.0) / (delta_10 *
        square_10_3) + 0.0082119972092981695 * T * g_1 * s_1_4 * (12.0 * v_1_2 + 3.0) * (s_1_2 * (16.0 * s_1_2 -
        20.0) + 5.0) / (delta_1 * square_1_3);
    const double u_cr4 = u_cr2 * u_cr2;
    const double A2 = A * A;
    const double c2 = c * c;
    const double c3 = c * c2;
    const double u_cr3 = u_cr * u_cr2;
    const double A3 = A * A2;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double A4 = A2 * A2;
    const double c4 = c2 * c2;
    const double c5 = c * c4;
    const double u_cr5 = u_cr * u_cr4;
    const double A5 = A * A4;
    const double A6 = A3 * A3;
    out[0] = -2.5464790894703255 * beta * sum_3_0;
    out[1] = -2.5464790894703255 * beta * sum_3_1;
    out[2] = 0.63661977236758138 * beta * (-4.0 * sum_3_2 + 4.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) /
        (A2 * c3 * root));
    out[3] = 0.63661977236758138 * beta * (-4.0 * sum_3_3 + 12.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) /
        (A3 * c5 * root) - 8.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr / A) / (A3 * c3 * root) + 4.0 * u_cr4 *
        (-12.0 * u_cr3 / A4 + 3.0 * u_cr / A2) / (A2 * c3 * root) - 4.0 * u_cr4 * (4.0 * u_cr3 / A3 - 3.0 * u_cr /
        A) / (A * c3 * root3));
    out[4] = -2.5464790894703255 * beta * sum_5_0;
    out[5] = -2.5464790894703255 * beta * sum_5_1;
    out[6] = 0.63661977236758138 * beta * (-4.0 * sum_5_2 + 4.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 +
        5.0 * u_cr / A) / (A2 * c3 * root));
    out[7] = 0.63661977236758138 * beta * (-4.0 * sum_5_3 + 12.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3
        + 5.0 * u_cr / A) / (A3 * c5 * root) - 8.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 + 5.0 * u_cr /
        A) / (A3 * c3 * root) + 4.0 * u_cr4 * (-80.0 * u_cr5 / A6 + 60.0 * u_cr3 / A4 - 5.0 * u_cr / A2) / (A2 * c3
        * root) - 4.0 * u_cr4 * (16.0 * u_cr5 / A5 - 20.0 * u_cr3 / A3 + 5.0 * u_cr / A) / (A * c3 * root3));
}

static inline void rod_spring_untruncated_harmonics(double A, const double *p, double *out)
{
    const double delta_h = p[2];
    if (A <= sqrt(-delta_h * delta_h + 2.0 * delta_h)) {
        rod_spring_untruncated_harmonics_passed_0(A, p, out);
        return;
    }
    rod_spring_untruncated_harmonics_passed_1(A, p, out);
}

/* d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.
   Equation from (20)-(22), (31). Domain: A > 0.
   Operations where passed_0: 6 structured, 7 common subexpressions, 7 power chains
   Proved where passed_0, error / u (1 + kappa): 0.0, 0.0, 0.0, 2.34, 3.01, 0.67, 0.0, 0.0, 0.0
   Operations where passed_1: 48 structured, 44 common subexpressions, 44 power chains
   Operations where passed_1_far_1: 148 structured, 90 common subexpressions, 87 power chains
 */
static inline void rod_spring_untruncated_by_parameter_passed_0(double A, double h, double h_A, double h_AA, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double t0 = 1.0 / beta;
    out[0] = -A;
    out[1] = -1.0;
    out[2] = 0.0;
    out[3] = t0 * (A * alpha + h);
    out[4] = t0 * (alpha + h_A);
    out[5] = h_AA * t0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
}

static inline void rod_spring_untruncated_by_parameter_passed_1(double A, double h, double h_A, double h_AA, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double t0 = 1.0 - delta_h;
    const double inner = -1.0 / (t0 * t0);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t1 = 1.0 / A;
    const double x = t1 * u_cr;
    const double y = root * t1;
    const double theta = angles_atan2_swapped(root, u_cr);
    const double M2 = 0.5 * theta - 0.5 * x * y;
    const double t2 = 1.0 / beta;
    const double t3 = 2.5464790894703255 * beta * inner;
    const double t4 = 1.0 / (A * A);
    const double t5 = 1.0 / root;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = t2 * (A + h);
    out[4] = t2 * (h_A + 1.0);
    out[5] = h_AA * t2;
    out[6] = -A * M2 * t3;
    out[7] = t3 * (-M2 + t4 * t5 * u_cr3);
    out[8] = -t1 * t3 * t5 * u_cr3 * (t4 + 1.0 / (root * root));
}

static inline void rod_spring_untruncated_by_parameter_passed_1_far_1(double A, double h, double h_A, double h_AA, const double *p, double *out)
{
    const double beta = p[1];
    const double delta_h = p[2];
    const double u_cr = sqrt(-delta_h * delta_h + 2.0 * delta_h);
    const double t0 = 1.0 - delta_h;
    const double inner = -1.0 / (t0 * t0);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t1 = 1.0 / A;
    const double x = t1 * u_cr;
    const double y = root * t1;
    const double s = x / sqrt(2.0 * y + 2.0);
    const double s2 = s * s;
    const double s4 = s2 * s2;
    const double s3 = s * s2;
    const double M2 = s3 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00067810320704266795 * s4 -
        0.00088998368261633694) - 0.001207644289190119) - 0.0017101353612439386) - 0.0025628662109375001) -
        0.0041562034970238099) - 0.0075827205882352941) - 0.016826923076923076) - 0.055555555555555552) -
        0.80000000000000004) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (-0.00059807125876960886 * s4 -
        0.0007739815359505323) - 0.0010318889149597713) - 0.0014283964710850869) - 0.0020763962357132522) -
        0.0032255753226902175) - 0.0055124383223684207) - 0.010937499999999999) - 0.028409090909090908) -
        0.14285714285714285) + 2.6666666666666665);
    const double t2 = 1.0 / beta;
    const double t3 = 2.5464790894703255 * beta * inner;
    const double t4 = 1.0 / (A * A);
    const double t5 = 1.0 / root;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = t2 * (A + h);
    out[4] = t2 * (h_A + 1.0);
    out[5] = h_AA * t2;
    out[6] = -A * M2 * t3;
    out[7] = t3 * (-M2 + t4 * t5 * u_cr3);
    out[8] = -t1 * t3 * t5 * u_cr3 * (t4 + 1.0 / (root * root));
}

static inline void rod_spring_untruncated_by_parameter(double A, double h, double h_A, double h_AA, const double *p, double *out)
{
    const double delta_h = p[2];
    if (A <= sqrt(-delta_h * delta_h + 2.0 * delta_h)) {
        rod_spring_untruncated_by_parameter_passed_0(A, h, h_A, h_AA, p, out);
        return;
    }
    if (A <= 1.25 * sqrt(-delta_h * delta_h + 2.0 * delta_h)) {
        rod_spring_untruncated_by_parameter_passed_1(A, h, h_A, h_AA, p, out);
        return;
    }
    rod_spring_untruncated_by_parameter_passed_1_far_1(A, h, h_A, h_AA, p, out);
}

/* d/d of each number of the design: of each parameter in turn, then of each breakpoint.
   Equation (5), (7). Domain: any design that has a breakpoint.
   Operations: 17 structured, 13 common subexpressions, 13 power chains
   Proved, error / u (1 + kappa): 0.34, 0.34, 0.34, 4.01, 4.01, 0.34, 0.0, 0.0, 0.0, 0.0, 0.0, -
 */
static inline void rod_spring_untruncated_by_design(double lam, double r, double delta_h, double *out)
{
    const double t0 = lam * r;
    const double t1 = delta_h - 1.0;
    const double t2 = 0.5 * t1;
    out[0] = -delta_h * r;
    out[1] = -delta_h * lam;
    out[2] = -t0;
    out[3] = -r * t2;
    out[4] = -lam * t2;
    out[5] = -0.5 * t0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 1.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = -t1 / (sqrt(delta_h) * sqrt(2.0 - delta_h));
}

/* The parameters alpha, beta, delta_h from the design.
   Equation (5), (7). Domain: any design.
   Operations: 7 structured, 6 common subexpressions, 6 power chains
   Proved, error / u (1 + kappa): 1.34, 6.01, 0.0
 */
static inline void rod_spring_untruncated_coefficients(double lam, double r, double delta_h, double *out)
{
    const double t0 = lam * r;
    out[0] = -delta_h * t0 + 1.0;
    out[1] = -0.5 * t0 * (delta_h - 1.0);
    out[2] = delta_h;
}

/* The |u| at which a piece of the force ends.
   Equation (5). Domain: any parameters.
   Operations: 4 structured, 4 common subexpressions, 4 power chains
 */
static inline void rod_spring_untruncated_breakpoints(const double *p, double *out)
{
    const double delta_h = p[2];
    out[0] = sqrt(-delta_h * delta_h + 2.0 * delta_h);
}

/* What the force loses at each breakpoint: f below less f above.
   Equation (5). Domain: any parameters.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
   Proved, error / u (1 + kappa): 0.0
 */
static inline void rod_spring_untruncated_jumps(const double *p, double *out)
{
    (void)(p);
    out[0] = 0.0;
}

/* The force over the displacement, f(u)/u, rises with |u| where none of these is negative.
   Equation from (3). Domain: any parameters.
   Operations: 1 structured, 1 common subexpressions, 1 power chains
   Proved, error / u (1 + kappa): 0.0
 */
static inline void rod_spring_untruncated_hardening(const double *p, double *out)
{
    const double beta = p[1];
    out[0] = 2.0 * beta;
}

/* Piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds.
   Operations: 16 structured, 12 common subexpressions, 12 power chains
 */
static inline double rod_spring_untruncated_force_1(double u, double alpha, double beta, double delta_h)
{
    (void)(delta_h);
    const double t0 = sqrt((1.0 - u) * (u + 1.0));
    return u * (alpha + 2.0 * beta * u * u / (t0 * (t0 + 1.0)));
}

/* d/du of piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds.
   Operations: 30 structured, 23 common subexpressions, 23 power chains
 */
static inline double rod_spring_untruncated_force_1_u(double u, double alpha, double beta, double delta_h)
{
    (void)(delta_h);
    const double root_1 = sqrt((1.0 - u) * (u + 1.0));
    const double t0 = root_1 + 1.0;
    const double t1 = 1.0 / t0;
    const double t2 = u * u;
    const double t3 = t2 / root_1;
    const double t4 = 2.0 * beta;
    return alpha + 6.0 * beta * t1 * t3 - t3 * (-t3 * t4 / (t0 * t0) - t1 * t2 * t4 / (root_1 * root_1));
}

/* Piece 2 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
   Proved, error / u (1 + kappa): 0.0
 */
static inline double rod_spring_untruncated_force_2(double u, double alpha, double beta, double delta_h)
{
    (void)(alpha);
    (void)(beta);
    (void)(delta_h);
    return u;
}

/* d/du of piece 2 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
   Proved, error / u (1 + kappa): 0.0
 */
static inline double rod_spring_untruncated_force_2_u(double u, double alpha, double beta, double delta_h)
{
    (void)(u);
    (void)(alpha);
    (void)(beta);
    (void)(delta_h);
    return 1.0;
}

/* Whole dimensionless restoring force u + F_k(u), untruncated.
   Equation (3), (5). Domain: |u| < 1.
   Operations where force_2: 0 structured, 0 common subexpressions, 0 power chains
   Proved where force_2, error / u (1 + kappa): 0.0
   Operations where force_1: 16 structured, 12 common subexpressions, 12 power chains
 */
static inline double rod_spring_untruncated_force(double u, double alpha, double beta, double delta_h)
{
    if (sqrt(-delta_h * delta_h + 2.0 * delta_h) <= fabs(u))
        return rod_spring_untruncated_force_2(u, alpha, beta, delta_h);
    return rod_spring_untruncated_force_1(u, alpha, beta, delta_h);
}

/* h, h_A, h_AA, h_AAA together.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_averaged(double A, const double *p, double *out)
{
    double values[7];
    rod_spring_untruncated_averaged_all(A, p, values);
    out[0] = values[0];
    out[1] = values[1];
    out[2] = values[2];
    out[3] = values[3];
}

/* h, h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_averaged_2(double A, const double *p, double *out)
{
    double values[7];
    rod_spring_untruncated_averaged_all(A, p, values);
    out[0] = values[0];
    out[1] = values[1];
}

/* H, H_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_untruncated_averaged_H(double A, const double *p, double *out)
{
    double values[7];
    rod_spring_untruncated_averaged_all(A, p, values);
    out[0] = values[4];
    out[1] = values[5];
}

/* h - A h_A, where the tangent of h meets A = 0; linear terms are none.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline double rod_spring_untruncated_intercept(double A, double alpha, double beta, double delta_h)
{
    const double p[] = {alpha, beta, delta_h};
    double values[7];
    rod_spring_untruncated_averaged_all(A, p, values);
    return values[6];
}

/* The averaged restoring force h = H - A.
   Equation (20)-(22). Domain: A >= 0. */
static inline double rod_spring_untruncated_h(double A, double alpha, double beta, double delta_h)
{
    const double p[] = {alpha, beta, delta_h};
    double values[2];
    rod_spring_untruncated_averaged_2(A, p, values);
    return values[0];
}

/* d/dA of the averaged restoring force h = H - A.
   Equation (31). Domain: A >= 0. */
static inline double rod_spring_untruncated_h_A(double A, double alpha, double beta, double delta_h)
{
    const double p[] = {alpha, beta, delta_h};
    double values[2];
    rod_spring_untruncated_averaged_2(A, p, values);
    return values[1];
}

/* d2/dA2 of the averaged restoring force h = H - A.
   Equation from (31). Domain: A >= 0. */
static inline double rod_spring_untruncated_h_AA(double A, double alpha, double beta, double delta_h)
{
    const double p[] = {alpha, beta, delta_h};
    double values[4];
    rod_spring_untruncated_averaged(A, p, values);
    return values[2];
}

/* d3/dA3 of the averaged restoring force h = H - A.
   Equation from (31). Domain: A >= 0. */
static inline double rod_spring_untruncated_h_AAA(double A, double alpha, double beta, double delta_h)
{
    const double p[] = {alpha, beta, delta_h};
    double values[4];
    rod_spring_untruncated_averaged(A, p, values);
    return values[3];
}

/* The averaged force H beside the vertical spring.
   Equation (20)-(22). Domain: A >= 0. */
static inline double rod_spring_untruncated_H(double A, double alpha, double beta, double delta_h)
{
    const double p[] = {alpha, beta, delta_h};
    double values[2];
    rod_spring_untruncated_averaged_H(A, p, values);
    return values[0];
}

/* d/dA of the averaged force H beside the vertical spring.
   Equation (31). Domain: A >= 0. */
static inline double rod_spring_untruncated_H_A(double A, double alpha, double beta, double delta_h)
{
    const double p[] = {alpha, beta, delta_h};
    double values[2];
    rod_spring_untruncated_averaged_H(A, p, values);
    return values[1];
}

/* d2/dA2 of the averaged force H beside the vertical spring.
   Equation from (31). Domain: A >= 0. */
static inline double rod_spring_untruncated_H_AA(double A, double alpha, double beta, double delta_h)
{
    const double p[] = {alpha, beta, delta_h};
    double values[4];
    rod_spring_untruncated_averaged(A, p, values);
    return values[2];
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_untruncated_F(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    return slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_untruncated_F_A(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    return slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* The forcing F_0 for which (Omega, A) is a steady state.
   Equation (24). Domain: Omega >= 0, A > 0. */
static inline double rod_spring_untruncated_level(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    return slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. */
static inline double rod_spring_untruncated_phase(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    return slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. */
static inline void rod_spring_untruncated_jacobian(double Omega, double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], out);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_untruncated_stability(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    return slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. */
static inline double rod_spring_untruncated_transmissibility(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    return slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. */
static inline double rod_spring_untruncated_backbone(double A, const double *p)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    return slow_flow_backbone(A, average[0]);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. */
static inline double rod_spring_untruncated_limit_envelope(double Omega, double F_0, double mu, double zeta)
{
    return slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. */
static inline double rod_spring_untruncated_equivalent_damping(double Omega, double A, double mu, double zeta)
{
    return slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
}

/* F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24). Domain: A > 0. */
static inline void rod_spring_untruncated_response_quartic(double A, double F_0, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], out);
}

/* F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24), (30). Domain: A > 0. */
static inline void rod_spring_untruncated_fold_quartic(double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], out);
}

/* F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.
   Equation (34). Domain: A > 0. */
static inline void rod_spring_untruncated_peak_cubic(double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], out);
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: A > 0. */
static inline void rod_spring_untruncated_detachment(double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_untruncated_averaged_2(A, p, average);
    slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], out);
}

#endif
