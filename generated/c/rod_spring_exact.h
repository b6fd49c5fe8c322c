/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated.

   Written by `make derive`; never edit.
   Input: derivations/mechanisms/rod_spring_exact.py, sha256 1b3371a6f3bd082d4bd24294ddea9a01f4b0822a58acd7b5b61ebe7b7e44131c
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Regimes: passed_n where A exceeds n breakpoints, far_k where it exceeds k of them 5/4 times.
   Operations are counted after each pass. */

#ifndef ROD_SPRING_EXACT_H
#define ROD_SPRING_EXACT_H

#include <math.h>

#include "slow_flow.h"

/* alpha, beta, u_cr */
#define ROD_SPRING_EXACT_PARAMETERS 3
#define ROD_SPRING_EXACT_BREAKPOINTS 1

/* h, h_A, h_AA, h_AAA together.
   Equation (20)-(22), (31). Domain: A >= 0.
   Operations where passed_0: 97 structured, 88 common subexpressions, 87 power chains
   Operations where passed_0_steep: 153 structured, 136 common subexpressions, 135 power chains
   Operations where passed_1_far: 670 structured, 670 common subexpressions, 610 power chains
   Operations where passed_1: 637 structured, 637 common subexpressions, 594 power chains
   Operations where passed_1_steep_far: 1666 structured, 1666 common subexpressions, 1613 power chains
   Operations where passed_1_steep: 1452 structured, 1452 common subexpressions, 1414 power chains
 */
static inline void rod_spring_exact_averaged_passed_0(double A, const double *p, double *out)
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
    const double t10 = 1.0 / k;
    const double k2 = k * k;
    const double t11 = 1.0 / k2;
    const double k3 = k * k2;
    out[0] = -A * alpha - P * t9;
    out[1] = -alpha - t8 * (B * m * t10 - C * m + P);
    out[2] = -t9 * (2.0 * B * t11 + C * t10);
    out[3] = -t8 * (B * (5.0 * m + 3.0) / k3 + C * t11 * (7.0 * m - 3.0));
}

static inline void rod_spring_exact_averaged_passed_0_steep(double A, const double *p, double *out)
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
    const double t14 = 1.0 / k;
    const double k2 = k * k;
    const double t15 = 1.0 / k2;
    const double k3 = k * k2;
    out[0] = -A * alpha - P * t13;
    out[1] = -alpha - t12 * (B * m * t14 - C * m + P);
    out[2] = -t13 * (2.0 * B * t15 + C * t14);
    out[3] = -t12 * (B * (5.0 * m + 3.0) / k3 + C * t15 * (7.0 * m - 3.0));
}

static inline void rod_spring_exact_averaged_passed_1_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
}

static inline void rod_spring_exact_averaged_passed_1(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
}

static inline void rod_spring_exact_averaged_passed_1_steep_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double a0_half_0_2 = a0_half_0 * a0_half_0;
    const double a0_half_0_3 = a0_half_0 * a0_half_0_2;
    const double a02_0 = -a0_half_0_3;
    const double a03_0 = -2.0 * a02_0 * a0_half_0_2;
    const double b0_0 = sqrt(Y_0);
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
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
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
}

static inline void rod_spring_exact_averaged_passed_1_steep(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
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
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
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
    const double c2 = c * c;
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
}

static inline void rod_spring_exact_averaged(double A, const double *p, double *out)
{
    const double u_cr = p[2];
    if ((A <= u_cr) && (A <= 0.69999999999999996)) {
        rod_spring_exact_averaged_passed_0(A, p, out);
        return;
    }
    if (A <= u_cr) {
        rod_spring_exact_averaged_passed_0_steep(A, p, out);
        return;
    }
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A)) {
        rod_spring_exact_averaged_passed_1_far(A, p, out);
        return;
    }
    if (u_cr <= 0.75) {
        rod_spring_exact_averaged_passed_1(A, p, out);
        return;
    }
    if (1.05 * u_cr <= A) {
        rod_spring_exact_averaged_passed_1_steep_far(A, p, out);
        return;
    }
    rod_spring_exact_averaged_passed_1_steep(A, p, out);
}

/* h, h_A, h_AA together.
   Equation (20)-(22), (31). Domain: A >= 0.
   Operations where passed_0: 83 structured, 75 common subexpressions, 75 power chains
   Operations where passed_0_steep: 139 structured, 123 common subexpressions, 123 power chains
   Operations where passed_1_far: 576 structured, 576 common subexpressions, 544 power chains
   Operations where passed_1: 482 structured, 482 common subexpressions, 467 power chains
   Operations where passed_1_steep_far: 1116 structured, 1116 common subexpressions, 1089 power chains
   Operations where passed_1_steep: 941 structured, 941 common subexpressions, 932 power chains
 */
static inline void rod_spring_exact_averaged_3_passed_0(double A, const double *p, double *out)
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
    const double t10 = 1.0 / k;
    out[0] = -A * alpha - P * t9;
    out[1] = -alpha - t8 * (B * m * t10 - C * m + P);
    out[2] = -t9 * (2.0 * B / (k * k) + C * t10);
}

static inline void rod_spring_exact_averaged_3_passed_0_steep(double A, const double *p, double *out)
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
    const double t14 = 1.0 / k;
    out[0] = -A * alpha - P * t13;
    out[1] = -alpha - t12 * (B * m * t14 - C * m + P);
    out[2] = -t13 * (2.0 * B / (k * k) + C * t14);
}

static inline void rod_spring_exact_averaged_3_passed_1_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double sum_2 = tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 *
        tangent_11 * term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 *
        tangent_14 * term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 *
        tangent_3 * term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6
        * term_6 + tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9;
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0;
    out[2] = 2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 *
        T3 * sum_2 * u_cr2 / c) / A;
}

static inline void rod_spring_exact_averaged_3_passed_1(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c2 = c * c;
    const double c3 = c * c2;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c) - 1.0;
    out[2] = -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root));
}

static inline void rod_spring_exact_averaged_3_passed_1_steep_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double a0_half_0_2 = a0_half_0 * a0_half_0;
    const double a0_half_0_3 = a0_half_0 * a0_half_0_2;
    const double a02_0 = -a0_half_0_3;
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double lam0_2 = a02_0 * b0_0 + a02_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double X0_2 = 0.25 * lam0_2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Y0_2 = 0.25 * lam0_2;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
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
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2 * x2;
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
    const double sum_2 = tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 *
        tangent_11 * term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 *
        tangent_14 * term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 *
        tangent_3 * term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6
        * term_6 + tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9;
    const double T3 = T * t0;
    out[0] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0;
    out[2] = 2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c -
        6.0 * V2 - 7.0 * V4 - 3.0 * V6) / A;
}

static inline void rod_spring_exact_averaged_3_passed_1_steep(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double y2 = root * root / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double b0_half_0 = 0.5 / b0_0;
    const double b0_half_0_2 = b0_half_0 * b0_half_0;
    const double b0_half_0_3 = b0_half_0 * b0_half_0_2;
    const double b02_0 = -b0_half_0_3;
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_0 * b0_half_0 + b0_half_0;
    const double lam0_2 = a0_0 * b02_0 + b02_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1;
    const double X0_2 = 0.25 * lam0_2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1 + 0.25;
    const double Y0_2 = 0.25 * lam0_2;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
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
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2 * x2;
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
    const double c2 = c * c;
    const double c3 = c * c2;
    out[0] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
    out[1] = -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0;
    out[2] = -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root));
}

static inline void rod_spring_exact_averaged_3(double A, const double *p, double *out)
{
    const double u_cr = p[2];
    if ((A <= u_cr) && (A <= 0.69999999999999996)) {
        rod_spring_exact_averaged_3_passed_0(A, p, out);
        return;
    }
    if (A <= u_cr) {
        rod_spring_exact_averaged_3_passed_0_steep(A, p, out);
        return;
    }
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A)) {
        rod_spring_exact_averaged_3_passed_1_far(A, p, out);
        return;
    }
    if (u_cr <= 0.75) {
        rod_spring_exact_averaged_3_passed_1(A, p, out);
        return;
    }
    if (1.05 * u_cr <= A) {
        rod_spring_exact_averaged_3_passed_1_steep_far(A, p, out);
        return;
    }
    rod_spring_exact_averaged_3_passed_1_steep(A, p, out);
}

/* h, h_A together.
   Equation (20)-(22), (31). Domain: A >= 0.
   Operations where passed_0: 75 structured, 68 common subexpressions, 68 power chains
   Operations where passed_0_steep: 131 structured, 116 common subexpressions, 116 power chains
   Operations where passed_1_far: 506 structured, 506 common subexpressions, 483 power chains
   Operations where passed_1: 432 structured, 432 common subexpressions, 424 power chains
   Operations where passed_1_steep_far: 692 structured, 692 common subexpressions, 671 power chains
   Operations where passed_1_steep: 568 structured, 568 common subexpressions, 563 power chains
 */
static inline void rod_spring_exact_averaged_2_passed_0(double A, const double *p, double *out)
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
    out[0] = -A * P * t8 - A * alpha;
    out[1] = -alpha - t8 * (B * m / k - C * m + P);
}

static inline void rod_spring_exact_averaged_2_passed_0_steep(double A, const double *p, double *out)
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
    out[0] = -A * P * t12 - A * alpha;
    out[1] = -alpha - t12 * (B * m / k - C * m + P);
}

static inline void rod_spring_exact_averaged_2_passed_1_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0;
}

static inline void rod_spring_exact_averaged_2_passed_1(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    out[0] = 20.371832715762604 * A * T3 * beta * sum_0 * u_cr2 / c - A;
    out[1] = -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr2 / c) - 1.0;
}

static inline void rod_spring_exact_averaged_2_passed_1_steep_far(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
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
    const double T3 = T * t0;
    out[0] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
    out[1] = 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0;
}

static inline void rod_spring_exact_averaged_2_passed_1_steep(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double u_cr = p[2];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double b0_half_0 = 0.5 / b0_0;
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_0 * b0_half_0 + b0_half_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1 + 0.25;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
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
    out[0] = 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
    out[1] = -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0;
}

static inline void rod_spring_exact_averaged_2(double A, const double *p, double *out)
{
    const double u_cr = p[2];
    if ((A <= u_cr) && (A <= 0.69999999999999996)) {
        rod_spring_exact_averaged_2_passed_0(A, p, out);
        return;
    }
    if (A <= u_cr) {
        rod_spring_exact_averaged_2_passed_0_steep(A, p, out);
        return;
    }
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A)) {
        rod_spring_exact_averaged_2_passed_1_far(A, p, out);
        return;
    }
    if (u_cr <= 0.75) {
        rod_spring_exact_averaged_2_passed_1(A, p, out);
        return;
    }
    if (1.05 * u_cr <= A) {
        rod_spring_exact_averaged_2_passed_1_steep_far(A, p, out);
        return;
    }
    rod_spring_exact_averaged_2_passed_1_steep(A, p, out);
}

/* The averaged restoring force h = H - A.
   Equation (20)-(22). Domain: A >= 0.
   Operations where passed_0: 59 structured, 54 common subexpressions, 54 power chains
   Operations where passed_0_steep: 115 structured, 102 common subexpressions, 102 power chains
   Operations where passed_1_far: 369 structured, 369 common subexpressions, 367 power chains
   Operations where passed_1: 369 structured, 369 common subexpressions, 367 power chains
   Operations where passed_1_steep_far: 305 structured, 305 common subexpressions, 303 power chains
   Operations where passed_1_steep: 305 structured, 305 common subexpressions, 303 power chains
 */
static inline double rod_spring_exact_h_passed_0(double A, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
    const double m = A * A;
    const double k_c = sqrt(1.0 - A) * sqrt(A + 1.0);
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
    const double t3 = e_3 * e_3;
    const double t4 = m / a_4;
    const double e_4 = 0.25 * t3 * t4;
    const double e = e_1 + e_2 + e_3 + e_4;
    const double tau = 16.0 * e_4 * e_4 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3;
    const double P = t4 * (e + tau);
    return -2.0 * A * P * beta - A * alpha;
}

static inline double rod_spring_exact_h_passed_0_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
    const double m = A * A;
    const double k_c = sqrt(1.0 - A) * sqrt(A + 1.0);
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
    const double t7 = e_7 * e_7;
    const double t8 = m / a_8;
    const double e_8 = 0.25 * t7 * t8;
    const double e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8;
    const double tau = 256.0 * e_8 * e_8 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3 + 16.0 * t4 + 32.0 * t5 + 64.0 * t6 +
        128.0 * t7;
    const double P = t8 * (e + tau);
    return -2.0 * A * P * beta - A * alpha;
}

static inline double rod_spring_exact_h_passed_1_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double term_2 = f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 *
        (0.98366812327974718 * t0 + 0.98366812327974718) + 1.0) / (c + delta_2);
    const double term_3 = f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 *
        (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3);
    const double term_4 = f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 *
        (0.92620004742927431 * t0 + 0.92620004742927431) + 1.0) / (c + delta_4);
    const double term_5 = f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274
        * t0 + 0.88256053579205274) + 1.0) / (c + delta_5);
    const double term_6 = f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836
        * t0 + 0.82956576238276836) + 1.0) / (c + delta_6);
    const double term_7 = f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619
        * t0 + 0.76777743210482619) + 1.0) / (c + delta_7);
    const double term_8 = f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585
        * t0 + 0.69785049479331585) + 1.0) / (c + delta_8);
    const double term_9 = f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289
        * t0 + 0.62052618298924289) + 1.0) / (c + delta_9);
    const double term_10 = f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 *
        (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10);
    const double term_11 = f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 *
        (0.44703376953808915 * t0 + 0.44703376953808915) + 1.0) / (c + delta_11);
    const double term_12 = f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12);
    const double term_13 = f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 *
        (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c + delta_13);
    const double term_14 = f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 *
        (0.15386991360858354 * t0 + 0.15386991360858354) + 1.0) / (c + delta_14);
    const double term_15 = f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 *
        (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c + delta_15);
    const double sum_0 = term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 +
        term_4 + term_5 + term_6 + term_7 + term_8 + term_9;
    const double T3 = T * t0;
    return 20.371832715762604 * A * T3 * beta * sum_0 * u_cr * u_cr / c - A;
}

static inline double rod_spring_exact_h_passed_1(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double T3 = T * t0;
    return 20.371832715762604 * A * T3 * beta * sum_0 * u_cr * u_cr / c - A;
}

static inline double rod_spring_exact_h_passed_1_steep_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double a1_0 = sqrt(X0_0);
    const double b1_0 = sqrt(Y0_0);
    const double c1_0 = sqrt(Z0_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double below1_0 = c1_0 * q1_0;
    const double term1_0 = 1.0 / below1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double a2_0 = sqrt(X1_0);
    const double b2_0 = sqrt(Y1_0);
    const double c2_0 = sqrt(Z1_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double below2_0 = c2_0 * q2_0;
    const double term2_0 = 1.0 / below2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double a3_0 = sqrt(X2_0);
    const double b3_0 = sqrt(Y2_0);
    const double c3_0 = sqrt(Z2_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double below3_0 = c3_0 * q3_0;
    const double term3_0 = 1.0 / below3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double a4_0 = sqrt(X3_0);
    const double b4_0 = sqrt(Y3_0);
    const double c4_0 = sqrt(Z3_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double below4_0 = c4_0 * q4_0;
    const double term4_0 = 1.0 / below4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double a5_0 = sqrt(X4_0);
    const double b5_0 = sqrt(Y4_0);
    const double c5_0 = sqrt(Z4_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double below5_0 = c5_0 * q5_0;
    const double term5_0 = 1.0 / below5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double over_0 = 1.0 / mean_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double xy_0 = dx_0 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double sq_0 = sqrt(over_0);
    const double power_0 = over_0 * sq_0;
    const double last_0 = power_0 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double V2 = R_0 * third;
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
    return 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
}

static inline double rod_spring_exact_h_passed_1_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double a1_0 = sqrt(X0_0);
    const double b1_0 = sqrt(Y0_0);
    const double c1_0 = sqrt(Z0_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double below1_0 = c1_0 * q1_0;
    const double term1_0 = 1.0 / below1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double a2_0 = sqrt(X1_0);
    const double b2_0 = sqrt(Y1_0);
    const double c2_0 = sqrt(Z1_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double below2_0 = c2_0 * q2_0;
    const double term2_0 = 1.0 / below2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double a3_0 = sqrt(X2_0);
    const double b3_0 = sqrt(Y2_0);
    const double c3_0 = sqrt(Z2_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double below3_0 = c3_0 * q3_0;
    const double term3_0 = 1.0 / below3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double a4_0 = sqrt(X3_0);
    const double b4_0 = sqrt(Y3_0);
    const double c4_0 = sqrt(Z3_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double below4_0 = c4_0 * q4_0;
    const double term4_0 = 1.0 / below4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double a5_0 = sqrt(X4_0);
    const double b5_0 = sqrt(Y4_0);
    const double c5_0 = sqrt(Z4_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double below5_0 = c5_0 * q5_0;
    const double term5_0 = 1.0 / below5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double over_0 = 1.0 / mean_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double xy_0 = dx_0 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double sq_0 = sqrt(over_0);
    const double power_0 = over_0 * sq_0;
    const double last_0 = power_0 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double V2 = R_0 * third;
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
    return 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2) - A;
}

static inline double rod_spring_exact_h(double A, double alpha, double beta, double u_cr)
{
    if ((A <= u_cr) && (A <= 0.69999999999999996))
        return rod_spring_exact_h_passed_0(A, alpha, beta, u_cr);
    if (A <= u_cr)
        return rod_spring_exact_h_passed_0_steep(A, alpha, beta, u_cr);
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A))
        return rod_spring_exact_h_passed_1_far(A, alpha, beta, u_cr);
    if (u_cr <= 0.75)
        return rod_spring_exact_h_passed_1(A, alpha, beta, u_cr);
    if (1.05 * u_cr <= A)
        return rod_spring_exact_h_passed_1_steep_far(A, alpha, beta, u_cr);
    return rod_spring_exact_h_passed_1_steep(A, alpha, beta, u_cr);
}

/* d/dA of the averaged restoring force h = H - A.
   Equation (31). Domain: A >= 0.
   Operations where passed_0: 70 structured, 64 common subexpressions, 64 power chains
   Operations where passed_0_steep: 126 structured, 112 common subexpressions, 112 power chains
   Operations where passed_1_far: 496 structured, 496 common subexpressions, 476 power chains
   Operations where passed_1: 422 structured, 422 common subexpressions, 417 power chains
   Operations where passed_1_steep_far: 682 structured, 682 common subexpressions, 663 power chains
   Operations where passed_1_steep: 558 structured, 558 common subexpressions, 555 power chains
 */
static inline double rod_spring_exact_h_A_passed_0(double A, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
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
    return -alpha - 2.0 * beta * (B * m / k - C * m + P);
}

static inline double rod_spring_exact_h_A_passed_0_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
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
    return -alpha - 2.0 * beta * (B * m / k - C * m + P);
}

static inline double rod_spring_exact_h_A_passed_1_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    return 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c) - 1.0;
}

static inline double rod_spring_exact_h_A_passed_1(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    const double T3 = T * t0;
    return -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr * u_cr / c) - 1.0;
}

static inline double rod_spring_exact_h_A_passed_1_steep_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
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
    const double T3 = T * t0;
    return 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4) - 1.0;
}

static inline double rod_spring_exact_h_A_passed_1_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double b0_half_0 = 0.5 / b0_0;
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_0 * b0_half_0 + b0_half_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1 + 0.25;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
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
    return -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2) - 1.0;
}

static inline double rod_spring_exact_h_A(double A, double alpha, double beta, double u_cr)
{
    if ((A <= u_cr) && (A <= 0.69999999999999996))
        return rod_spring_exact_h_A_passed_0(A, alpha, beta, u_cr);
    if (A <= u_cr)
        return rod_spring_exact_h_A_passed_0_steep(A, alpha, beta, u_cr);
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A))
        return rod_spring_exact_h_A_passed_1_far(A, alpha, beta, u_cr);
    if (u_cr <= 0.75)
        return rod_spring_exact_h_A_passed_1(A, alpha, beta, u_cr);
    if (1.05 * u_cr <= A)
        return rod_spring_exact_h_A_passed_1_steep_far(A, alpha, beta, u_cr);
    return rod_spring_exact_h_A_passed_1_steep(A, alpha, beta, u_cr);
}

/* d2/dA2 of the averaged restoring force h = H - A.
   Equation from (31). Domain: A >= 0.
   Operations where passed_0: 64 structured, 58 common subexpressions, 58 power chains
   Operations where passed_0_steep: 116 structured, 102 common subexpressions, 102 power chains
   Operations where passed_1_far: 548 structured, 548 common subexpressions, 525 power chains
   Operations where passed_1: 260 structured, 260 common subexpressions, 255 power chains
   Operations where passed_1_steep_far: 1089 structured, 1089 common subexpressions, 1068 power chains
   Operations where passed_1_steep: 797 structured, 797 common subexpressions, 792 power chains
 */
static inline double rod_spring_exact_h_AA_passed_0(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
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
    const double e_4 = t3 * t5 * t6;
    const double tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5;
    const double B = t6 * (-m * tau + 1.0);
    const double C = 2.0 * t6 * tau;
    return -2.0 * A * beta * (2.0 * B / (k * k) + C / k);
}

static inline double rod_spring_exact_h_AA_passed_0_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
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
    const double e_8 = t10 * t3 * t9;
    const double tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 +
        128.0 * t9;
    const double B = t10 * (-m * tau + 1.0);
    const double C = 2.0 * t10 * tau;
    return -2.0 * A * beta * (2.0 * B / (k * k) + C / k);
}

static inline double rod_spring_exact_h_AA_passed_1_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double sum_2 = tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 *
        tangent_11 * term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 *
        tangent_14 * term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 *
        tangent_3 * term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6
        * term_6 + tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9;
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    return 2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 *
        T3 * sum_2 * u_cr2 / c) / A;
}

static inline double rod_spring_exact_h_AA_passed_1(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double sum_2 = fall_1 / square_1 + fall_10 / square_10 + fall_11 / square_11 + fall_12 / square_12 +
        fall_13 / square_13 + fall_14 / square_14 + fall_15 / square_15 + fall_2 / square_2 + fall_3 / square_3 +
        fall_4 / square_4 + fall_5 / square_5 + fall_6 / square_6 + fall_7 / square_7 + fall_8 / square_8 + fall_9 /
        square_9;
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c2 = c * c;
    const double c3 = c * c2;
    return -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root));
}

static inline double rod_spring_exact_h_AA_passed_1_steep_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double a0_half_0_2 = a0_half_0 * a0_half_0;
    const double a0_half_0_3 = a0_half_0 * a0_half_0_2;
    const double a02_0 = -a0_half_0_3;
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double lam0_2 = a02_0 * b0_0 + a02_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double X0_2 = 0.25 * lam0_2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Y0_2 = 0.25 * lam0_2;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
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
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2 * x2;
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
    const double sum_2 = tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 *
        tangent_11 * term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 *
        tangent_14 * term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 *
        tangent_3 * term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6
        * term_6 + tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9;
    const double T3 = T * t0;
    return 2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c -
        6.0 * V2 - 7.0 * V4 - 3.0 * V6) / A;
}

static inline double rod_spring_exact_h_AA_passed_1_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
    const double u_cr2 = u_cr * u_cr;
    const double A2 = A * A;
    const double x2 = u_cr2 / A2;
    const double y2 = root * root / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double b0_half_0 = 0.5 / b0_0;
    const double b0_half_0_2 = b0_half_0 * b0_half_0;
    const double b0_half_0_3 = b0_half_0 * b0_half_0_2;
    const double b02_0 = -b0_half_0_3;
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_0 * b0_half_0 + b0_half_0;
    const double lam0_2 = a0_0 * b02_0 + b02_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1;
    const double X0_2 = 0.25 * lam0_2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1 + 0.25;
    const double Y0_2 = 0.25 * lam0_2;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
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
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double V4 = -2.0 * R_1 * third * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2 * x2;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c2 = c * c;
    const double c3 = c * c2;
    return -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root));
}

static inline double rod_spring_exact_h_AA(double A, double alpha, double beta, double u_cr)
{
    if ((A <= u_cr) && (A <= 0.69999999999999996))
        return rod_spring_exact_h_AA_passed_0(A, alpha, beta, u_cr);
    if (A <= u_cr)
        return rod_spring_exact_h_AA_passed_0_steep(A, alpha, beta, u_cr);
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A))
        return rod_spring_exact_h_AA_passed_1_far(A, alpha, beta, u_cr);
    if (u_cr <= 0.75)
        return rod_spring_exact_h_AA_passed_1(A, alpha, beta, u_cr);
    if (1.05 * u_cr <= A)
        return rod_spring_exact_h_AA_passed_1_steep_far(A, alpha, beta, u_cr);
    return rod_spring_exact_h_AA_passed_1_steep(A, alpha, beta, u_cr);
}

/* d3/dA3 of the averaged restoring force h = H - A.
   Equation from (31). Domain: A >= 0.
   Operations where passed_0: 70 structured, 64 common subexpressions, 63 power chains
   Operations where passed_0_steep: 122 structured, 108 common subexpressions, 107 power chains
   Operations where passed_1_far: 616 structured, 616 common subexpressions, 574 power chains
   Operations where passed_1: 365 structured, 365 common subexpressions, 343 power chains
   Operations where passed_1_steep_far: 1613 structured, 1613 common subexpressions, 1572 power chains
   Operations where passed_1_steep: 1289 structured, 1289 common subexpressions, 1263 power chains
 */
static inline double rod_spring_exact_h_AAA_passed_0(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
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
    const double e_4 = t3 * t5 * t6;
    const double tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5;
    const double B = t6 * (-m * tau + 1.0);
    const double C = 2.0 * t6 * tau;
    const double k2 = k * k;
    const double k3 = k * k2;
    return -2.0 * beta * (B * (5.0 * m + 3.0) / k3 + C * (7.0 * m - 3.0) / k2);
}

static inline double rod_spring_exact_h_AAA_passed_0_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
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
    const double e_8 = t10 * t3 * t9;
    const double tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 +
        128.0 * t9;
    const double B = t10 * (-m * tau + 1.0);
    const double C = 2.0 * t10 * tau;
    const double k2 = k * k;
    const double k3 = k * k2;
    return -2.0 * beta * (B * (5.0 * m + 3.0) / k3 + C * (7.0 * m - 3.0) / k2);
}

static inline double rod_spring_exact_h_AAA_passed_1_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    return 2.5464790894703255 * beta * (-192.0 * T3 * sum_0 * u_cr2 / c - 384.0 * T3 * sum_1 * u_cr2 / c - 360.0
        * T3 * sum_2 * u_cr2 / c - 120.0 * T3 * sum_3 * u_cr2 / c) / A2;
}

static inline double rod_spring_exact_h_AAA_passed_1(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double sum_3 = fall_1 * (4.0 * U2 * v2_1 + 1.0) / (square_1 * square_1) + fall_10 * (4.0 * U2 * v2_10 +
        1.0) / (square_10 * square_10) + fall_11 * (4.0 * U2 * v2_11 + 1.0) / (square_11 * square_11) + fall_12 *
        (4.0 * U2 * v2_12 + 1.0) / (square_12 * square_12) + fall_13 * (4.0 * U2 * v2_13 + 1.0) / (square_13 *
        square_13) + fall_14 * (4.0 * U2 * v2_14 + 1.0) / (square_14 * square_14) + fall_15 * (4.0 * U2 * v2_15 +
        1.0) / (square_15 * square_15) + fall_2 * (4.0 * U2 * v2_2 + 1.0) / (square_2 * square_2) + fall_3 * (4.0 *
        U2 * v2_3 + 1.0) / (square_3 * square_3) + fall_4 * (4.0 * U2 * v2_4 + 1.0) / (square_4 * square_4) + fall_5
        * (4.0 * U2 * v2_5 + 1.0) / (square_5 * square_5) + fall_6 * (4.0 * U2 * v2_6 + 1.0) / (square_6 * square_6)
        + fall_7 * (4.0 * U2 * v2_7 + 1.0) / (square_7 * square_7) + fall_8 * (4.0 * U2 * v2_8 + 1.0) / (square_8 *
        square_8) + fall_9 * (4.0 * U2 * v2_9 + 1.0) / (square_9 * square_9);
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double c2 = c * c;
    const double c3 = c * c2;
    const double A4 = A2 * A2;
    const double c4 = c2 * c2;
    const double c5 = c * c4;
    return -2.5464790894703255 * beta * (96.0 * T5 * sum_3 - 3.0 * u_cr5 / (A4 * c5 * root) + 3.0 * u_cr5 / (A4
        * c3 * root) + u_cr5 / (A2 * c3 * root3));
}

static inline double rod_spring_exact_h_AAA_passed_1_steep_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double a0_half_0_2 = a0_half_0 * a0_half_0;
    const double a0_half_0_3 = a0_half_0 * a0_half_0_2;
    const double a02_0 = -a0_half_0_3;
    const double a03_0 = -2.0 * a02_0 * a0_half_0_2;
    const double b0_0 = sqrt(Y_0);
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
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
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
    return 2.5464790894703255 * beta * (-192.0 * T3 * sum_0 / c - 384.0 * T3 * sum_1 / c - 360.0 * T3 * sum_2 /
        c - 120.0 * T3 * sum_3 / c + 24.0 * V2 + 48.0 * V4 + 45.0 * V6 + 15.0 * V8) / A2;
}

static inline double rod_spring_exact_h_AAA_passed_1_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
    const double u_cr2 = u_cr * u_cr;
    const double A2 = A * A;
    const double x2 = u_cr2 / A2;
    const double root2 = root * root;
    const double y2 = root2 / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
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
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
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
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double last_3 = power_0 * series_3 + power_1 * series_2 + power_2 * series_1 + power_3 * series_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double R_3 = 0.000244140625 * last_3 + 3.0 * term03_0 + 0.75 * term13_0 + 0.1875 * term23_0 + 0.046875 *
        term33_0 + 0.01171875 * term43_0 + 0.0029296875 * term53_0;
    const double V4 = -2.0 * R_1 * third * x2;
    const double x2_2 = x2 * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2_2;
    const double x2_3 = x2 * x2_2;
    const double V8 = -3.2000000000000002 * R_3 * third * x2_3;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double root3 = root * root2;
    const double c2 = c * c;
    const double c3 = c * c2;
    const double A4 = A2 * A2;
    const double c4 = c2 * c2;
    const double c5 = c * c4;
    return -2.5464790894703255 * beta * (3.0 * A2 * (5.0 * A2 * V8 + 6.0 * V6) + 3.0 * V4 - 3.0 * u_cr5 / (A4 *
        c5 * root) + 3.0 * u_cr5 / (A4 * c3 * root) + u_cr5 / (A2 * c3 * root3));
}

static inline double rod_spring_exact_h_AAA(double A, double alpha, double beta, double u_cr)
{
    if ((A <= u_cr) && (A <= 0.69999999999999996))
        return rod_spring_exact_h_AAA_passed_0(A, alpha, beta, u_cr);
    if (A <= u_cr)
        return rod_spring_exact_h_AAA_passed_0_steep(A, alpha, beta, u_cr);
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A))
        return rod_spring_exact_h_AAA_passed_1_far(A, alpha, beta, u_cr);
    if (u_cr <= 0.75)
        return rod_spring_exact_h_AAA_passed_1(A, alpha, beta, u_cr);
    if (1.05 * u_cr <= A)
        return rod_spring_exact_h_AAA_passed_1_steep_far(A, alpha, beta, u_cr);
    return rod_spring_exact_h_AAA_passed_1_steep(A, alpha, beta, u_cr);
}

/* The averaged force H beside the vertical spring.
   Equation (20)-(22). Domain: A >= 0.
   Operations where passed_0: 60 structured, 55 common subexpressions, 55 power chains
   Operations where passed_0_steep: 116 structured, 103 common subexpressions, 103 power chains
   Operations where passed_1_far: 368 structured, 368 common subexpressions, 366 power chains
   Operations where passed_1: 368 structured, 368 common subexpressions, 366 power chains
   Operations where passed_1_steep_far: 304 structured, 304 common subexpressions, 302 power chains
   Operations where passed_1_steep: 304 structured, 304 common subexpressions, 302 power chains
 */
static inline double rod_spring_exact_H_passed_0(double A, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
    const double m = A * A;
    const double k_c = sqrt(1.0 - A) * sqrt(A + 1.0);
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
    const double t3 = e_3 * e_3;
    const double t4 = m / a_4;
    const double e_4 = 0.25 * t3 * t4;
    const double e = e_1 + e_2 + e_3 + e_4;
    const double tau = 16.0 * e_4 * e_4 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3;
    const double P = t4 * (e + tau);
    return -2.0 * A * P * beta - A * (alpha - 1.0);
}

static inline double rod_spring_exact_H_passed_0_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
    const double m = A * A;
    const double k_c = sqrt(1.0 - A) * sqrt(A + 1.0);
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
    const double t7 = e_7 * e_7;
    const double t8 = m / a_8;
    const double e_8 = 0.25 * t7 * t8;
    const double e = e_1 + e_2 + e_3 + e_4 + e_5 + e_6 + e_7 + e_8;
    const double tau = 256.0 * e_8 * e_8 + 2.0 * t0 + 4.0 * t2 + 8.0 * t3 + 16.0 * t4 + 32.0 * t5 + 64.0 * t6 +
        128.0 * t7;
    const double P = t8 * (e + tau);
    return -2.0 * A * P * beta - A * (alpha - 1.0);
}

static inline double rod_spring_exact_H_passed_1_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double term_2 = f_2 * g_2 * (0.01633187672025279 - 0.016065146523047254 * t0) * (g_2 *
        (0.98366812327974718 * t0 + 0.98366812327974718) + 1.0) / (c + delta_2);
    const double term_3 = f_3 * g_3 * (0.039978135031692487 - 0.03837988375108025 * t0) * (g_3 *
        (0.96002186496830755 * t0 + 0.96002186496830755) + 1.0) / (c + delta_3);
    const double term_4 = f_4 * g_4 * (0.073799952570725677 - 0.068353519571284313 * t0) * (g_4 *
        (0.92620004742927431 * t0 + 0.92620004742927431) + 1.0) / (c + delta_4);
    const double term_5 = f_5 * g_5 * (0.11743946420794732 - 0.10364743645449757 * t0) * (g_5 * (0.88256053579205274
        * t0 + 0.88256053579205274) + 1.0) / (c + delta_5);
    const double term_6 = f_6 * g_6 * (0.17043423761723162 - 0.14138640826506463 * t0) * (g_6 * (0.82956576238276836
        * t0 + 0.82956576238276836) + 1.0) / (c + delta_6);
    const double term_7 = f_7 * g_7 * (0.23222256789517381 - 0.1782952468553452 * t0) * (g_7 * (0.76777743210482619
        * t0 + 0.76777743210482619) + 1.0) / (c + delta_7);
    const double term_8 = f_8 * g_8 * (0.30214950520668421 - 0.21085518171004011 * t0) * (g_8 * (0.69785049479331585
        * t0 + 0.69785049479331585) + 1.0) / (c + delta_8);
    const double term_9 = f_9 * g_9 * (0.37947381701075716 - 0.23547343921404354 * t0) * (g_9 * (0.62052618298924289
        * t0 + 0.62052618298924289) + 1.0) / (c + delta_9);
    const double term_10 = f_10 * g_10 * (0.46337585185798008 - 0.24865867177287138 * t0) * (g_10 *
        (0.53662414814201986 * t0 + 0.53662414814201986) + 1.0) / (c + delta_10);
    const double term_11 = f_11 * g_11 * (0.55296623046191085 - 0.24719457843065576 * t0) * (g_11 *
        (0.44703376953808915 * t0 + 0.44703376953808915) + 1.0) / (c + delta_11);
    const double term_12 = f_12 * g_12 * (0.64729527446912194 - 0.22830410211906604 * t0) * (g_12 *
        (0.35270472553087812 * t0 + 0.35270472553087812) + 1.0) / (c + delta_12);
    const double term_13 = f_13 * g_13 * (0.7453630738321102 - 0.18979696199965845 * t0) * (g_13 *
        (0.25463692616788985 * t0 + 0.25463692616788985) + 1.0) / (c + delta_13);
    const double term_14 = f_14 * g_14 * (0.8461300863914164 - 0.13019396329467059 * t0) * (g_14 *
        (0.15386991360858354 * t0 + 0.15386991360858354) + 1.0) / (c + delta_14);
    const double term_15 = f_15 * g_15 * (0.94852815744468233 - 0.048822491979278279 * t0) * (g_15 *
        (0.051471842555317698 * t0 + 0.051471842555317698) + 1.0) / (c + delta_15);
    const double sum_0 = term_1 + term_10 + term_11 + term_12 + term_13 + term_14 + term_15 + term_2 + term_3 +
        term_4 + term_5 + term_6 + term_7 + term_8 + term_9;
    const double T3 = T * t0;
    return 20.371832715762604 * A * T3 * beta * sum_0 * u_cr * u_cr / c;
}

static inline double rod_spring_exact_H_passed_1(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double T3 = T * t0;
    return 20.371832715762604 * A * T3 * beta * sum_0 * u_cr * u_cr / c;
}

static inline double rod_spring_exact_H_passed_1_steep_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double a1_0 = sqrt(X0_0);
    const double b1_0 = sqrt(Y0_0);
    const double c1_0 = sqrt(Z0_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double below1_0 = c1_0 * q1_0;
    const double term1_0 = 1.0 / below1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double a2_0 = sqrt(X1_0);
    const double b2_0 = sqrt(Y1_0);
    const double c2_0 = sqrt(Z1_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double below2_0 = c2_0 * q2_0;
    const double term2_0 = 1.0 / below2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double a3_0 = sqrt(X2_0);
    const double b3_0 = sqrt(Y2_0);
    const double c3_0 = sqrt(Z2_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double below3_0 = c3_0 * q3_0;
    const double term3_0 = 1.0 / below3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double a4_0 = sqrt(X3_0);
    const double b4_0 = sqrt(Y3_0);
    const double c4_0 = sqrt(Z3_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double below4_0 = c4_0 * q4_0;
    const double term4_0 = 1.0 / below4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double a5_0 = sqrt(X4_0);
    const double b5_0 = sqrt(Y4_0);
    const double c5_0 = sqrt(Z4_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double below5_0 = c5_0 * q5_0;
    const double term5_0 = 1.0 / below5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double over_0 = 1.0 / mean_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double xy_0 = dx_0 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double sq_0 = sqrt(over_0);
    const double power_0 = over_0 * sq_0;
    const double last_0 = power_0 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double V2 = R_0 * third;
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
    return 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2);
}

static inline double rod_spring_exact_H_passed_1_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double a1_0 = sqrt(X0_0);
    const double b1_0 = sqrt(Y0_0);
    const double c1_0 = sqrt(Z0_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double below1_0 = c1_0 * q1_0;
    const double term1_0 = 1.0 / below1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double a2_0 = sqrt(X1_0);
    const double b2_0 = sqrt(Y1_0);
    const double c2_0 = sqrt(Z1_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double below2_0 = c2_0 * q2_0;
    const double term2_0 = 1.0 / below2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double a3_0 = sqrt(X2_0);
    const double b3_0 = sqrt(Y2_0);
    const double c3_0 = sqrt(Z2_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double below3_0 = c3_0 * q3_0;
    const double term3_0 = 1.0 / below3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double a4_0 = sqrt(X3_0);
    const double b4_0 = sqrt(Y3_0);
    const double c4_0 = sqrt(Z3_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double below4_0 = c4_0 * q4_0;
    const double term4_0 = 1.0 / below4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double a5_0 = sqrt(X4_0);
    const double b5_0 = sqrt(Y4_0);
    const double c5_0 = sqrt(Z4_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double below5_0 = c5_0 * q5_0;
    const double term5_0 = 1.0 / below5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double over_0 = 1.0 / mean_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double xy_0 = dx_0 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double sq_0 = sqrt(over_0);
    const double power_0 = over_0 * sq_0;
    const double last_0 = power_0 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double V2 = R_0 * third;
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
    return 2.5464790894703255 * A * beta * (8.0 * T3 * sum_0 / c - V2);
}

static inline double rod_spring_exact_H(double A, double alpha, double beta, double u_cr)
{
    if ((A <= u_cr) && (A <= 0.69999999999999996))
        return rod_spring_exact_H_passed_0(A, alpha, beta, u_cr);
    if (A <= u_cr)
        return rod_spring_exact_H_passed_0_steep(A, alpha, beta, u_cr);
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A))
        return rod_spring_exact_H_passed_1_far(A, alpha, beta, u_cr);
    if (u_cr <= 0.75)
        return rod_spring_exact_H_passed_1(A, alpha, beta, u_cr);
    if (1.05 * u_cr <= A)
        return rod_spring_exact_H_passed_1_steep_far(A, alpha, beta, u_cr);
    return rod_spring_exact_H_passed_1_steep(A, alpha, beta, u_cr);
}

/* d/dA of the averaged force H beside the vertical spring.
   Equation (31). Domain: A >= 0.
   Operations where passed_0: 71 structured, 65 common subexpressions, 65 power chains
   Operations where passed_0_steep: 127 structured, 113 common subexpressions, 113 power chains
   Operations where passed_1_far: 495 structured, 495 common subexpressions, 475 power chains
   Operations where passed_1: 421 structured, 421 common subexpressions, 416 power chains
   Operations where passed_1_steep_far: 681 structured, 681 common subexpressions, 662 power chains
   Operations where passed_1_steep: 557 structured, 557 common subexpressions, 554 power chains
 */
static inline double rod_spring_exact_H_A_passed_0(double A, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
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
    return -alpha - 2.0 * beta * (B * m / k - C * m + P) + 1.0;
}

static inline double rod_spring_exact_H_A_passed_0_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
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
    return -alpha - 2.0 * beta * (B * m / k - C * m + P) + 1.0;
}

static inline double rod_spring_exact_H_A_passed_1_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    return 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 * u_cr2 / c - 8.0 * T3 * sum_1 * u_cr2 / c);
}

static inline double rod_spring_exact_H_A_passed_1(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    const double T3 = T * t0;
    return -2.5464790894703255 * beta * (32.0 * A2 * T5 * sum_1 - 8.0 * T3 * sum_0 * u_cr * u_cr / c);
}

static inline double rod_spring_exact_H_A_passed_1_steep_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
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
    const double T3 = T * t0;
    return 2.5464790894703255 * beta * (-16.0 * T3 * sum_0 / c - 8.0 * T3 * sum_1 / c + 2.0 * V2 + V4);
}

static inline double rod_spring_exact_H_A_passed_1_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double b0_half_0 = 0.5 / b0_0;
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_0 * b0_half_0 + b0_half_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1 + 0.25;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double series_0 = 0.10227272727272728 * E2_0 * E2_0 - 0.17307692307692307 * E2_0 * E3_0 -
        0.21428571428571427 * E2_0 + 0.16666666666666666 * E3_0 - 0.13636363636363635 * E4_0 + 0.11538461538461539 *
        E5_0 + 1.0;
    const double series_1 = 0.20454545454545456 * E2_0 * E2_1 - 0.17307692307692307 * E2_0 * E3_1 -
        0.17307692307692307 * E2_1 * E3_0 - 0.21428571428571427 * E2_1 + 0.16666666666666666 * E3_1 -
        0.13636363636363635 * E4_1 + 0.11538461538461539 * E5_1;
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
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
    return -2.5464790894703255 * beta * (A2 * V4 - 8.0 * T3 * sum_0 / c + V2);
}

static inline double rod_spring_exact_H_A(double A, double alpha, double beta, double u_cr)
{
    if ((A <= u_cr) && (A <= 0.69999999999999996))
        return rod_spring_exact_H_A_passed_0(A, alpha, beta, u_cr);
    if (A <= u_cr)
        return rod_spring_exact_H_A_passed_0_steep(A, alpha, beta, u_cr);
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A))
        return rod_spring_exact_H_A_passed_1_far(A, alpha, beta, u_cr);
    if (u_cr <= 0.75)
        return rod_spring_exact_H_A_passed_1(A, alpha, beta, u_cr);
    if (1.05 * u_cr <= A)
        return rod_spring_exact_H_A_passed_1_steep_far(A, alpha, beta, u_cr);
    return rod_spring_exact_H_A_passed_1_steep(A, alpha, beta, u_cr);
}

/* d2/dA2 of the averaged force H beside the vertical spring.
   Equation from (31). Domain: A >= 0.
   Operations where passed_0: 64 structured, 58 common subexpressions, 58 power chains
   Operations where passed_0_steep: 116 structured, 102 common subexpressions, 102 power chains
   Operations where passed_1_far: 548 structured, 548 common subexpressions, 525 power chains
   Operations where passed_1: 260 structured, 260 common subexpressions, 255 power chains
   Operations where passed_1_steep_far: 1089 structured, 1089 common subexpressions, 1068 power chains
   Operations where passed_1_steep: 797 structured, 797 common subexpressions, 792 power chains
 */
static inline double rod_spring_exact_H_AA_passed_0(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
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
    const double e_4 = t3 * t5 * t6;
    const double tau = 16.0 * e_4 * e_4 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5;
    const double B = t6 * (-m * tau + 1.0);
    const double C = 2.0 * t6 * tau;
    return -2.0 * A * beta * (2.0 * B / (k * k) + C / k);
}

static inline double rod_spring_exact_H_AA_passed_0_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
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
    const double e_8 = t10 * t3 * t9;
    const double tau = 256.0 * e_8 * e_8 + 2.0 * t2 + 4.0 * t4 + 8.0 * t5 + 16.0 * t6 + 32.0 * t7 + 64.0 * t8 +
        128.0 * t9;
    const double B = t10 * (-m * tau + 1.0);
    const double C = 2.0 * t10 * tau;
    return -2.0 * A * beta * (2.0 * B / (k * k) + C / k);
}

static inline double rod_spring_exact_H_AA_passed_1_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double U2 = 4.0 * A * A * t0;
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
    const double sum_2 = tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 *
        tangent_11 * term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 *
        tangent_14 * term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 *
        tangent_3 * term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6
        * term_6 + tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9;
    const double u_cr2 = u_cr * u_cr;
    const double T3 = T * t0;
    return 2.5464790894703255 * beta * (48.0 * T3 * sum_0 * u_cr2 / c + 56.0 * T3 * sum_1 * u_cr2 / c + 24.0 *
        T3 * sum_2 * u_cr2 / c) / A;
}

static inline double rod_spring_exact_H_AA_passed_1(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double sum_2 = fall_1 / square_1 + fall_10 / square_10 + fall_11 / square_11 + fall_12 / square_12 +
        fall_13 / square_13 + fall_14 / square_14 + fall_15 / square_15 + fall_2 / square_2 + fall_3 / square_3 +
        fall_4 / square_4 + fall_5 / square_5 + fall_6 / square_6 + fall_7 / square_7 + fall_8 / square_8 + fall_9 /
        square_9;
    const double T4 = t0 * t0;
    const double T5 = T * T4;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c2 = c * c;
    const double c3 = c * c2;
    return -2.5464790894703255 * beta * (96.0 * A * T5 * sum_2 - u_cr5 / (A3 * c3 * root));
}

static inline double rod_spring_exact_H_AA_passed_1_steep_far(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
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
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double a0_half_0 = 0.5 / a0_0;
    const double a0_half_0_2 = a0_half_0 * a0_half_0;
    const double a0_half_0_3 = a0_half_0 * a0_half_0_2;
    const double a02_0 = -a0_half_0_3;
    const double b0_0 = sqrt(Y_0);
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_half_0 * b0_0 + a0_half_0;
    const double lam0_2 = a02_0 * b0_0 + a02_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1 + 0.25;
    const double X0_2 = 0.25 * lam0_2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1;
    const double Y0_2 = 0.25 * lam0_2;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
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
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double last_0 = power_0 * series_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double R_0 = 0.000244140625 * last_0 + 3.0 * term0_0 + 0.75 * term1_0 + 0.1875 * term2_0 + 0.046875 *
        term3_0 + 0.01171875 * term4_0 + 0.0029296875 * term5_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double V2 = R_0 * third;
    const double V4 = -2.0 * R_1 * third * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2 * x2;
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
    const double sum_2 = tangent_1 * tangent_1 * term_1 + tangent_10 * tangent_10 * term_10 + tangent_11 *
        tangent_11 * term_11 + tangent_12 * tangent_12 * term_12 + tangent_13 * tangent_13 * term_13 + tangent_14 *
        tangent_14 * term_14 + tangent_15 * tangent_15 * term_15 + tangent_2 * tangent_2 * term_2 + tangent_3 *
        tangent_3 * term_3 + tangent_4 * tangent_4 * term_4 + tangent_5 * tangent_5 * term_5 + tangent_6 * tangent_6
        * term_6 + tangent_7 * tangent_7 * term_7 + tangent_8 * tangent_8 * term_8 + tangent_9 * tangent_9 * term_9;
    const double T3 = T * t0;
    return 2.5464790894703255 * beta * (48.0 * T3 * sum_0 / c + 56.0 * T3 * sum_1 / c + 24.0 * T3 * sum_2 / c -
        6.0 * V2 - 7.0 * V4 - 3.0 * V6) / A;
}

static inline double rod_spring_exact_H_AA_passed_1_steep(double A, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double c = sqrt((1.0 - u_cr) * (u_cr + 1.0));
    const double u_cr2 = u_cr * u_cr;
    const double A2 = A * A;
    const double x2 = u_cr2 / A2;
    const double y2 = root * root / A2;
    const double third = 0.33333333333333331 * u_cr * x2 / A;
    const double Y_0 = (1.0 - u_cr) * (u_cr + 1.0);
    const double a0_0 = sqrt(y2);
    const double b0_0 = sqrt(Y_0);
    const double b0_half_0 = 0.5 / b0_0;
    const double b0_half_0_2 = b0_half_0 * b0_half_0;
    const double b0_half_0_3 = b0_half_0 * b0_half_0_2;
    const double b02_0 = -b0_half_0_3;
    const double lam0_0 = a0_0 * b0_0 + a0_0 + b0_0;
    const double lam0_1 = a0_0 * b0_half_0 + b0_half_0;
    const double lam0_2 = a0_0 * b02_0 + b02_0;
    const double q0_0 = lam0_0 + 1.0;
    const double term0_0 = 1.0 / q0_0;
    const double term01_0 = -lam0_1 * term0_0 * term0_0;
    const double term02_0 = -term0_0 * (lam0_1 * term01_0 + lam0_2 * term0_0);
    const double X0_0 = 0.25 * lam0_0 + 0.25 * y2;
    const double X0_1 = 0.25 * lam0_1;
    const double X0_2 = 0.25 * lam0_2;
    const double Y0_0 = 0.25 * Y_0 + 0.25 * lam0_0;
    const double Y0_1 = 0.25 * lam0_1 + 0.25;
    const double Y0_2 = 0.25 * lam0_2;
    const double Z0_0 = 0.25 * lam0_0 + 0.25;
    const double Z0_1 = 0.25 * lam0_1;
    const double Z0_2 = 0.25 * lam0_2;
    const double a1_0 = sqrt(X0_0);
    const double a1_half_0 = 0.5 / a1_0;
    const double a11_0 = X0_1 * a1_half_0;
    const double a12_0 = a1_half_0 * (X0_2 - a11_0 * a11_0);
    const double b1_0 = sqrt(Y0_0);
    const double b1_half_0 = 0.5 / b1_0;
    const double b11_0 = Y0_1 * b1_half_0;
    const double b12_0 = b1_half_0 * (Y0_2 - b11_0 * b11_0);
    const double c1_0 = sqrt(Z0_0);
    const double c1_half_0 = 0.5 / c1_0;
    const double c11_0 = Z0_1 * c1_half_0;
    const double c12_0 = c1_half_0 * (Z0_2 - c11_0 * c11_0);
    const double lam1_0 = a1_0 * b1_0 + c1_0 * (a1_0 + b1_0);
    const double lam1_1 = a11_0 * b1_0 + a1_0 * b11_0 + c11_0 * (a1_0 + b1_0) + c1_0 * (a11_0 + b11_0);
    const double lam1_2 = a11_0 * b11_0 + a12_0 * b1_0 + a1_0 * b12_0 + c11_0 * (a11_0 + b11_0) + c12_0 * (a1_0 +
        b1_0) + c1_0 * (a12_0 + b12_0);
    const double q1_0 = Z0_0 + lam1_0;
    const double q1_1 = Z0_1 + lam1_1;
    const double q1_2 = Z0_2 + lam1_2;
    const double below1_0 = c1_0 * q1_0;
    const double below1_1 = c11_0 * q1_0 + c1_0 * q1_1;
    const double below1_2 = c11_0 * q1_1 + c12_0 * q1_0 + c1_0 * q1_2;
    const double term1_0 = 1.0 / below1_0;
    const double term11_0 = -below1_1 * term1_0 * term1_0;
    const double term12_0 = -term1_0 * (below1_1 * term11_0 + below1_2 * term1_0);
    const double X1_0 = 0.25 * X0_0 + 0.25 * lam1_0;
    const double X1_1 = 0.25 * X0_1 + 0.25 * lam1_1;
    const double X1_2 = 0.25 * X0_2 + 0.25 * lam1_2;
    const double Y1_0 = 0.25 * Y0_0 + 0.25 * lam1_0;
    const double Y1_1 = 0.25 * Y0_1 + 0.25 * lam1_1;
    const double Y1_2 = 0.25 * Y0_2 + 0.25 * lam1_2;
    const double Z1_0 = 0.25 * Z0_0 + 0.25 * lam1_0;
    const double Z1_1 = 0.25 * Z0_1 + 0.25 * lam1_1;
    const double Z1_2 = 0.25 * Z0_2 + 0.25 * lam1_2;
    const double a2_0 = sqrt(X1_0);
    const double a2_half_0 = 0.5 / a2_0;
    const double a21_0 = X1_1 * a2_half_0;
    const double a22_0 = a2_half_0 * (X1_2 - a21_0 * a21_0);
    const double b2_0 = sqrt(Y1_0);
    const double b2_half_0 = 0.5 / b2_0;
    const double b21_0 = Y1_1 * b2_half_0;
    const double b22_0 = b2_half_0 * (Y1_2 - b21_0 * b21_0);
    const double c2_0 = sqrt(Z1_0);
    const double c2_half_0 = 0.5 / c2_0;
    const double c21_0 = Z1_1 * c2_half_0;
    const double c22_0 = c2_half_0 * (Z1_2 - c21_0 * c21_0);
    const double lam2_0 = a2_0 * b2_0 + c2_0 * (a2_0 + b2_0);
    const double lam2_1 = a21_0 * b2_0 + a2_0 * b21_0 + c21_0 * (a2_0 + b2_0) + c2_0 * (a21_0 + b21_0);
    const double lam2_2 = a21_0 * b21_0 + a22_0 * b2_0 + a2_0 * b22_0 + c21_0 * (a21_0 + b21_0) + c22_0 * (a2_0 +
        b2_0) + c2_0 * (a22_0 + b22_0);
    const double q2_0 = Z1_0 + lam2_0;
    const double q2_1 = Z1_1 + lam2_1;
    const double q2_2 = Z1_2 + lam2_2;
    const double below2_0 = c2_0 * q2_0;
    const double below2_1 = c21_0 * q2_0 + c2_0 * q2_1;
    const double below2_2 = c21_0 * q2_1 + c22_0 * q2_0 + c2_0 * q2_2;
    const double term2_0 = 1.0 / below2_0;
    const double term21_0 = -below2_1 * term2_0 * term2_0;
    const double term22_0 = -term2_0 * (below2_1 * term21_0 + below2_2 * term2_0);
    const double X2_0 = 0.25 * X1_0 + 0.25 * lam2_0;
    const double X2_1 = 0.25 * X1_1 + 0.25 * lam2_1;
    const double X2_2 = 0.25 * X1_2 + 0.25 * lam2_2;
    const double Y2_0 = 0.25 * Y1_0 + 0.25 * lam2_0;
    const double Y2_1 = 0.25 * Y1_1 + 0.25 * lam2_1;
    const double Y2_2 = 0.25 * Y1_2 + 0.25 * lam2_2;
    const double Z2_0 = 0.25 * Z1_0 + 0.25 * lam2_0;
    const double Z2_1 = 0.25 * Z1_1 + 0.25 * lam2_1;
    const double Z2_2 = 0.25 * Z1_2 + 0.25 * lam2_2;
    const double a3_0 = sqrt(X2_0);
    const double a3_half_0 = 0.5 / a3_0;
    const double a31_0 = X2_1 * a3_half_0;
    const double a32_0 = a3_half_0 * (X2_2 - a31_0 * a31_0);
    const double b3_0 = sqrt(Y2_0);
    const double b3_half_0 = 0.5 / b3_0;
    const double b31_0 = Y2_1 * b3_half_0;
    const double b32_0 = b3_half_0 * (Y2_2 - b31_0 * b31_0);
    const double c3_0 = sqrt(Z2_0);
    const double c3_half_0 = 0.5 / c3_0;
    const double c31_0 = Z2_1 * c3_half_0;
    const double c32_0 = c3_half_0 * (Z2_2 - c31_0 * c31_0);
    const double lam3_0 = a3_0 * b3_0 + c3_0 * (a3_0 + b3_0);
    const double lam3_1 = a31_0 * b3_0 + a3_0 * b31_0 + c31_0 * (a3_0 + b3_0) + c3_0 * (a31_0 + b31_0);
    const double lam3_2 = a31_0 * b31_0 + a32_0 * b3_0 + a3_0 * b32_0 + c31_0 * (a31_0 + b31_0) + c32_0 * (a3_0 +
        b3_0) + c3_0 * (a32_0 + b32_0);
    const double q3_0 = Z2_0 + lam3_0;
    const double q3_1 = Z2_1 + lam3_1;
    const double q3_2 = Z2_2 + lam3_2;
    const double below3_0 = c3_0 * q3_0;
    const double below3_1 = c31_0 * q3_0 + c3_0 * q3_1;
    const double below3_2 = c31_0 * q3_1 + c32_0 * q3_0 + c3_0 * q3_2;
    const double term3_0 = 1.0 / below3_0;
    const double term31_0 = -below3_1 * term3_0 * term3_0;
    const double term32_0 = -term3_0 * (below3_1 * term31_0 + below3_2 * term3_0);
    const double X3_0 = 0.25 * X2_0 + 0.25 * lam3_0;
    const double X3_1 = 0.25 * X2_1 + 0.25 * lam3_1;
    const double X3_2 = 0.25 * X2_2 + 0.25 * lam3_2;
    const double Y3_0 = 0.25 * Y2_0 + 0.25 * lam3_0;
    const double Y3_1 = 0.25 * Y2_1 + 0.25 * lam3_1;
    const double Y3_2 = 0.25 * Y2_2 + 0.25 * lam3_2;
    const double Z3_0 = 0.25 * Z2_0 + 0.25 * lam3_0;
    const double Z3_1 = 0.25 * Z2_1 + 0.25 * lam3_1;
    const double Z3_2 = 0.25 * Z2_2 + 0.25 * lam3_2;
    const double a4_0 = sqrt(X3_0);
    const double a4_half_0 = 0.5 / a4_0;
    const double a41_0 = X3_1 * a4_half_0;
    const double a42_0 = a4_half_0 * (X3_2 - a41_0 * a41_0);
    const double b4_0 = sqrt(Y3_0);
    const double b4_half_0 = 0.5 / b4_0;
    const double b41_0 = Y3_1 * b4_half_0;
    const double b42_0 = b4_half_0 * (Y3_2 - b41_0 * b41_0);
    const double c4_0 = sqrt(Z3_0);
    const double c4_half_0 = 0.5 / c4_0;
    const double c41_0 = Z3_1 * c4_half_0;
    const double c42_0 = c4_half_0 * (Z3_2 - c41_0 * c41_0);
    const double lam4_0 = a4_0 * b4_0 + c4_0 * (a4_0 + b4_0);
    const double lam4_1 = a41_0 * b4_0 + a4_0 * b41_0 + c41_0 * (a4_0 + b4_0) + c4_0 * (a41_0 + b41_0);
    const double lam4_2 = a41_0 * b41_0 + a42_0 * b4_0 + a4_0 * b42_0 + c41_0 * (a41_0 + b41_0) + c42_0 * (a4_0 +
        b4_0) + c4_0 * (a42_0 + b42_0);
    const double q4_0 = Z3_0 + lam4_0;
    const double q4_1 = Z3_1 + lam4_1;
    const double q4_2 = Z3_2 + lam4_2;
    const double below4_0 = c4_0 * q4_0;
    const double below4_1 = c41_0 * q4_0 + c4_0 * q4_1;
    const double below4_2 = c41_0 * q4_1 + c42_0 * q4_0 + c4_0 * q4_2;
    const double term4_0 = 1.0 / below4_0;
    const double term41_0 = -below4_1 * term4_0 * term4_0;
    const double term42_0 = -term4_0 * (below4_1 * term41_0 + below4_2 * term4_0);
    const double X4_0 = 0.25 * X3_0 + 0.25 * lam4_0;
    const double X4_1 = 0.25 * X3_1 + 0.25 * lam4_1;
    const double X4_2 = 0.25 * X3_2 + 0.25 * lam4_2;
    const double Y4_0 = 0.25 * Y3_0 + 0.25 * lam4_0;
    const double Y4_1 = 0.25 * Y3_1 + 0.25 * lam4_1;
    const double Y4_2 = 0.25 * Y3_2 + 0.25 * lam4_2;
    const double Z4_0 = 0.25 * Z3_0 + 0.25 * lam4_0;
    const double Z4_1 = 0.25 * Z3_1 + 0.25 * lam4_1;
    const double Z4_2 = 0.25 * Z3_2 + 0.25 * lam4_2;
    const double a5_0 = sqrt(X4_0);
    const double a5_half_0 = 0.5 / a5_0;
    const double a51_0 = X4_1 * a5_half_0;
    const double a52_0 = a5_half_0 * (X4_2 - a51_0 * a51_0);
    const double b5_0 = sqrt(Y4_0);
    const double b5_half_0 = 0.5 / b5_0;
    const double b51_0 = Y4_1 * b5_half_0;
    const double b52_0 = b5_half_0 * (Y4_2 - b51_0 * b51_0);
    const double c5_0 = sqrt(Z4_0);
    const double c5_half_0 = 0.5 / c5_0;
    const double c51_0 = Z4_1 * c5_half_0;
    const double c52_0 = c5_half_0 * (Z4_2 - c51_0 * c51_0);
    const double lam5_0 = a5_0 * b5_0 + c5_0 * (a5_0 + b5_0);
    const double lam5_1 = a51_0 * b5_0 + a5_0 * b51_0 + c51_0 * (a5_0 + b5_0) + c5_0 * (a51_0 + b51_0);
    const double lam5_2 = a51_0 * b51_0 + a52_0 * b5_0 + a5_0 * b52_0 + c51_0 * (a51_0 + b51_0) + c52_0 * (a5_0 +
        b5_0) + c5_0 * (a52_0 + b52_0);
    const double q5_0 = Z4_0 + lam5_0;
    const double q5_1 = Z4_1 + lam5_1;
    const double q5_2 = Z4_2 + lam5_2;
    const double below5_0 = c5_0 * q5_0;
    const double below5_1 = c51_0 * q5_0 + c5_0 * q5_1;
    const double below5_2 = c51_0 * q5_1 + c52_0 * q5_0 + c5_0 * q5_2;
    const double term5_0 = 1.0 / below5_0;
    const double term51_0 = -below5_1 * term5_0 * term5_0;
    const double term52_0 = -term5_0 * (below5_1 * term51_0 + below5_2 * term5_0);
    const double X5_0 = 0.25 * X4_0 + 0.25 * lam5_0;
    const double X5_1 = 0.25 * X4_1 + 0.25 * lam5_1;
    const double X5_2 = 0.25 * X4_2 + 0.25 * lam5_2;
    const double Y5_0 = 0.25 * Y4_0 + 0.25 * lam5_0;
    const double Y5_1 = 0.25 * Y4_1 + 0.25 * lam5_1;
    const double Y5_2 = 0.25 * Y4_2 + 0.25 * lam5_2;
    const double Z5_0 = 0.25 * Z4_0 + 0.25 * lam5_0;
    const double Z5_1 = 0.25 * Z4_1 + 0.25 * lam5_1;
    const double Z5_2 = 0.25 * Z4_2 + 0.25 * lam5_2;
    const double mean_0 = 0.20000000000000001 * X5_0 + 0.20000000000000001 * Y5_0 + 0.59999999999999998 * Z5_0;
    const double mean_1 = 0.20000000000000001 * X5_1 + 0.20000000000000001 * Y5_1 + 0.59999999999999998 * Z5_1;
    const double mean_2 = 0.20000000000000001 * X5_2 + 0.20000000000000001 * Y5_2 + 0.59999999999999998 * Z5_2;
    const double over_0 = 1.0 / mean_0;
    const double over1_0 = -mean_1 * over_0 * over_0;
    const double over2_0 = -over_0 * (mean_1 * over1_0 + mean_2 * over_0);
    const double dx_0 = over_0 * (-X5_0 + mean_0);
    const double dx_1 = over1_0 * (-X5_0 + mean_0) + over_0 * (-X5_1 + mean_1);
    const double dx_2 = over1_0 * (-X5_1 + mean_1) + over2_0 * (-X5_0 + mean_0) + over_0 * (-X5_2 + mean_2);
    const double dy_0 = over_0 * (-Y5_0 + mean_0);
    const double dy_1 = over1_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_1 + mean_1);
    const double dy_2 = over1_0 * (-Y5_1 + mean_1) + over2_0 * (-Y5_0 + mean_0) + over_0 * (-Y5_2 + mean_2);
    const double dz_0 = -0.33333333333333331 * dx_0 - 0.33333333333333331 * dy_0;
    const double dz_1 = -0.33333333333333331 * dx_1 - 0.33333333333333331 * dy_1;
    const double dz_2 = -0.33333333333333331 * dx_2 - 0.33333333333333331 * dy_2;
    const double xy_0 = dx_0 * dy_0;
    const double xy_1 = dx_0 * dy_1 + dx_1 * dy_0;
    const double xy_2 = dx_0 * dy_2 + dx_1 * dy_1 + dx_2 * dy_0;
    const double zz_0 = dz_0 * dz_0;
    const double zz_1 = 2.0 * dz_0 * dz_1;
    const double zz_2 = 2.0 * dz_0 * dz_2 + dz_1 * dz_1;
    const double E2_0 = xy_0 - 6.0 * zz_0;
    const double E2_1 = xy_1 - 6.0 * zz_1;
    const double E2_2 = xy_2 - 6.0 * zz_2;
    const double E3_0 = dz_0 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_1 = dz_0 * (3.0 * xy_1 - 8.0 * zz_1) + dz_1 * (3.0 * xy_0 - 8.0 * zz_0);
    const double E3_2 = dz_0 * (3.0 * xy_2 - 8.0 * zz_2) + dz_1 * (3.0 * xy_1 - 8.0 * zz_1) + dz_2 * (3.0 * xy_0 -
        8.0 * zz_0);
    const double E4_0 = zz_0 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_1 = zz_0 * (3.0 * xy_1 - 3.0 * zz_1) + zz_1 * (3.0 * xy_0 - 3.0 * zz_0);
    const double E4_2 = zz_0 * (3.0 * xy_2 - 3.0 * zz_2) + zz_1 * (3.0 * xy_1 - 3.0 * zz_1) + zz_2 * (3.0 * xy_0 -
        3.0 * zz_0);
    const double E5_0 = dz_0 * xy_0 * zz_0;
    const double E5_1 = dz_0 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_1 * xy_0 * zz_0;
    const double E5_2 = dz_0 * (xy_0 * zz_2 + xy_1 * zz_1 + xy_2 * zz_0) + dz_1 * (xy_0 * zz_1 + xy_1 * zz_0) + dz_2
        * xy_0 * zz_0;
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
    const double sq_0 = sqrt(over_0);
    const double sq_half_0 = 0.5 / sq_0;
    const double sq1_0 = over1_0 * sq_half_0;
    const double sq2_0 = sq_half_0 * (over2_0 - sq1_0 * sq1_0);
    const double power_0 = over_0 * sq_0;
    const double power_1 = over1_0 * sq_0 + over_0 * sq1_0;
    const double power_2 = over1_0 * sq1_0 + over2_0 * sq_0 + over_0 * sq2_0;
    const double last_1 = power_0 * series_1 + power_1 * series_0;
    const double last_2 = power_0 * series_2 + power_1 * series_1 + power_2 * series_0;
    const double R_1 = 0.000244140625 * last_1 + 3.0 * term01_0 + 0.75 * term11_0 + 0.1875 * term21_0 + 0.046875 *
        term31_0 + 0.01171875 * term41_0 + 0.0029296875 * term51_0;
    const double R_2 = 0.000244140625 * last_2 + 3.0 * term02_0 + 0.75 * term12_0 + 0.1875 * term22_0 + 0.046875 *
        term32_0 + 0.01171875 * term42_0 + 0.0029296875 * term52_0;
    const double V4 = -2.0 * R_1 * third * x2;
    const double V6 = 2.6666666666666665 * R_2 * third * x2 * x2;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A3 = A * A2;
    const double c2 = c * c;
    const double c3 = c * c2;
    return -2.5464790894703255 * beta * (3.0 * A * (A2 * V6 + V4) - u_cr5 / (A3 * c3 * root));
}

static inline double rod_spring_exact_H_AA(double A, double alpha, double beta, double u_cr)
{
    if ((A <= u_cr) && (A <= 0.69999999999999996))
        return rod_spring_exact_H_AA_passed_0(A, alpha, beta, u_cr);
    if (A <= u_cr)
        return rod_spring_exact_H_AA_passed_0_steep(A, alpha, beta, u_cr);
    if ((u_cr <= 0.75) && (1.05 * u_cr <= A))
        return rod_spring_exact_H_AA_passed_1_far(A, alpha, beta, u_cr);
    if (u_cr <= 0.75)
        return rod_spring_exact_H_AA_passed_1(A, alpha, beta, u_cr);
    if (1.05 * u_cr <= A)
        return rod_spring_exact_H_AA_passed_1_steep_far(A, alpha, beta, u_cr);
    return rod_spring_exact_H_AA_passed_1_steep(A, alpha, beta, u_cr);
}

/* The parameters alpha, beta, u_cr from the design ratios.
   Equation (5), (7). Domain: any ratios.
   Operations: 11 structured, 10 common subexpressions, 10 power chains
 */
static inline void rod_spring_exact_coefficients(double lam, double r, double delta_h, double *out)
{
    const double t0 = lam * r;
    out[0] = -delta_h * t0 + 1.0;
    out[1] = -0.5 * t0 * (delta_h - 1.0);
    out[2] = sqrt(delta_h) * sqrt(2.0 - delta_h);
}

/* The |u| at which a piece of the force ends.
   Equation (5). Domain: any parameters.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline void rod_spring_exact_breakpoints(const double *p, double *out)
{
    const double u_cr = p[2];
    out[0] = u_cr;
}

/* What the force loses at each breakpoint: f below less f above.
   Equation (5). Domain: any parameters.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline void rod_spring_exact_jumps(const double *p, double *out)
{
    (void)(p);
    out[0] = 0.0;
}

/* Whole dimensionless restoring force u + F_k(u), untruncated.
   Equation (3), (5). Domain: |u| < 1.
   Operations where piece_1: 16 structured, 12 common subexpressions, 12 power chains
   Operations where piece_2: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline double rod_spring_exact_force_piece_1(double u, double alpha, double beta, double u_cr)
{
    (void)(u_cr);
    const double t0 = sqrt((1.0 - u) * (u + 1.0));
    return u * (alpha + 2.0 * beta * u * u / (t0 * (t0 + 1.0)));
}

static inline double rod_spring_exact_force_piece_2(double u, double alpha, double beta, double u_cr)
{
    (void)(alpha);
    (void)(beta);
    (void)(u_cr);
    return u;
}

static inline double rod_spring_exact_force(double u, double alpha, double beta, double u_cr)
{
    if (fabs(u) <= u_cr)
        return rod_spring_exact_force_piece_1(u, alpha, beta, u_cr);
    return rod_spring_exact_force_piece_2(u, alpha, beta, u_cr);
}

/* Whole dimensionless restoring force u + F_k(u), untruncated.
   Equation (3), (5). Domain: |u| < 1.
   Operations where piece_1: 15 structured, 11 common subexpressions, 11 power chains
   Operations where piece_2: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline double rod_spring_exact_untruncated_force_piece_1(double u, double lam, double r, double delta_h)
{
    const double t0 = u * u;
    const double t1 = sqrt(1.0 - t0);
    return -lam * r * u * (delta_h - t0 / (t1 + 1.0)) / t1 + u;
}

static inline double rod_spring_exact_untruncated_force_piece_2(double u, double lam, double r, double delta_h)
{
    (void)(lam);
    (void)(r);
    (void)(delta_h);
    return u;
}

static inline double rod_spring_exact_untruncated_force(double u, double lam, double r, double delta_h)
{
    if (fabs(u) <= sqrt(delta_h) * sqrt(2.0 - delta_h))
        return rod_spring_exact_untruncated_force_piece_1(u, lam, r, delta_h);
    return rod_spring_exact_untruncated_force_piece_2(u, lam, r, delta_h);
}

/* Cosine balance, -F_0 cos phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_R(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(mu);
    (void)(zeta);
    const double average[1] = {
        rod_spring_exact_h(A, p[0], p[1], p[2]),
    };
    return slow_flow_R(Omega, A, average[0]);
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_I(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(p);
    return slow_flow_I(Omega, A, slow_flow_friction(mu), zeta);
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_F(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_exact_h(A, p[0], p[1], p[2]),
    };
    return slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_F_A(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_exact_averaged_2(A, p, average);
    return slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* d2F/dA2.
   Equation (24), (33). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_F_AA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[3];
    rod_spring_exact_averaged_3(A, p, average);
    return slow_flow_F_AA(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], average[2]);
}

/* d3F/dA3.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_F_AAA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[4];
    rod_spring_exact_averaged(A, p, average);
    return slow_flow_F_AAA(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], average[2], average[3]);
}

/* dF/dOmega.
   Equation (24), (34). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_F_Omega(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_exact_h(A, p[0], p[1], p[2]),
    };
    return slow_flow_F_Omega(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_F_AOmega(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_exact_averaged_2(A, p, average);
    return slow_flow_F_AOmega(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_phase(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_exact_h(A, p[0], p[1], p[2]),
    };
    return slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. */
static inline void rod_spring_exact_jacobian(double Omega, double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_exact_averaged_2(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], out);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_stability(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_exact_averaged_2(A, p, average);
    return slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. */
static inline double rod_spring_exact_transmissibility(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_exact_h(A, p[0], p[1], p[2]),
    };
    return slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. */
static inline double rod_spring_exact_backbone(double A, const double *p)
{
    const double average[1] = {
        rod_spring_exact_h(A, p[0], p[1], p[2]),
    };
    return slow_flow_backbone(A, average[0]);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. */
static inline double rod_spring_exact_limit_envelope(double Omega, double F_0, double mu, double zeta)
{
    return slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. */
static inline double rod_spring_exact_equivalent_damping(double Omega, double A, double mu, double zeta)
{
    return slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
}

#endif
