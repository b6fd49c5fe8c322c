/* Structural and quadratic damping, and dry friction of what is attached: on numbers of the kind REAL.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/extensions/dissipation.py; never edit.

   Included where OF makes the names of functions, and REAL, ADD, ... are what arithmetic_*.h says. Rounding errors
   are those of doubles, see dissipation.h. */

SF_FAMILY_BEGIN

/* I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.
   Equation from (19). Domain: A > 0. Operations: 2. Error / u (1 + kappa): proved 1.01, 0.0, 0.0, 0.0. */
KERNEL void OF(at_rest)(REAL A, REAL m, REAL eta, REAL *out) {
    out[0] = ADD(MUL(A, eta), m);
    out[1] = eta;
    out[2] = POINT(0.0);
    out[3] = POINT(0.0);
}

/* The same where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. Operations: 13. Error / u (1 + kappa): proved 1.01, 1.01, 0.67, 0.86. */
KERNEL void OF(released)(REAL A, REAL m, REAL eta, REAL u_cr, REAL *out) {
    const REAL t0 = MUL(m, u_cr);
    const REAL A2 = SQUARE(A);
    const REAL A3 = MUL(A, A2);
    const REAL A4 = SQUARE(A2);
    out[0] = ADD(MUL(A, eta), DIV(t0, A));
    out[1] = SUB(eta, DIV(t0, A2));
    out[2] = DIV(TIMES(2.0, t0), A3);
    out[3] = NEG(DIV(TIMES(6.0, t0), A4));
}

/* The viscous damping ratio of a cycle, and three derivatives by A.
   Equation from (19). Domain: A > 0. Operations: 6. Error / u (1 + kappa): proved 1.01, 0.34, 0.0, 0.0. */
KERNEL void OF(viscous)(REAL A, REAL zeta, REAL zeta_2, REAL *out) {
    const REAL t0 = TIMES(0.5, zeta_2);
    out[0] = ADD(MUL(BY_SQUARE(POINT(0.25), A), zeta_2), zeta);
    out[1] = MUL(A, t0);
    out[2] = t0;
    out[3] = POINT(0.0);
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. Operations: 14. Error / u (1 + kappa): proved 7.01. */
KERNEL REAL OF(I)(REAL Omega, REAL A, REAL I_0, REAL zeta, REAL d, REAL d_3) {
    const REAL A2 = SQUARE(A);
    const REAL Omega2 = SQUARE(Omega);
    const REAL A3 = MUL(A, A2);
    const REAL Omega3 = MUL(Omega, Omega2);
    return ADD(ADD(ADD(MUL(MUL(TIMES(2.0, A), Omega), zeta), MUL(MUL(A2, Omega2), d)), MUL(MUL(A3, Omega3),
        d_3)), I_0);
}

/* dI/dA.
   Equation (23). Domain: Omega > 0, A > 0. Operations: 17. Error / u (1 + kappa): proved 7.26. */
KERNEL REAL OF(I_A)(REAL Omega, REAL A, REAL I_0A, REAL zeta, REAL zeta_A, REAL d, REAL d_3) {
    const REAL t0 = TIMES(2.0, Omega);
    const REAL Omega2 = SQUARE(Omega);
    const REAL Omega3 = MUL(Omega, Omega2);
    return ADD(ADD(ADD(ADD(MUL(MUL(BY_SQUARE(POINT(3.0), A), Omega3), d_3), MUL(MUL(TIMES(2.0, A), Omega2), d)),
        MUL(MUL(A, t0), zeta_A)), I_0A), MUL(t0, zeta));
}

/* R, R_A, I and I_A over Omega^2, at x = 1/Omega.
   Equation (23). Domain: x >= 0, A > 0. Operations: 21. Error / u (1 + kappa): proved 1.01, 1.34, 4.01, 4.51. */
KERNEL void OF(far)(REAL x, REAL A, REAL I_0, REAL I_0A, REAL zeta, REAL zeta_A, REAL d, REAL h, REAL h_A, REAL *out) {
    const REAL t0 = SQUARE(x);
    const REAL t1 = TIMES(2.0, A);
    const REAL t2 = MUL(x, zeta);
    out[0] = ADD(A, MUL(h, t0));
    out[1] = ADD(MUL(h_A, t0), POINT(1.0));
    out[2] = ADD(ADD(MUL(SQUARE(A), d), MUL(I_0, t0)), MUL(t1, t2));
    out[3] = ADD(ADD(ADD(MUL(I_0A, t0), MUL(d, t1)), MUL(MUL(t1, x), zeta_A)), TIMES(2.0, t2));
}

/* F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each.
   Equation from (24). Domain: F_0 > I_0. Operations: 10. Error / u (1 + kappa): measured 0.76. */
KERNEL void OF(static)(REAL F_0, REAL I_0, REAL I_0A, REAL h, REAL h_A, REAL *out) {
    const REAL c = SQRT(MUL(SUB(F_0, I_0), ADD(F_0, I_0)));
    const REAL t0 = DIV(MUL(I_0, I_0A), c);
    out[0] = ADD(NEG(c), h);
    out[1] = ADD(c, h);
    out[2] = ADD(h_A, t0);
    out[3] = SUB(h_A, t0);
}

/* D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D without cubic damping.
   Equation from (30). Domain: x >= 0, A > 0. Operations: 39. Error / u (1 + kappa): measured 0.69. */
KERNEL REAL OF(turn_share)(REAL x, REAL A, REAL I_0, REAL I_0A, REAL zeta, REAL zeta_A, REAL d) {
    const REAL A2 = SQUARE(A);
    const REAL A3 = MUL(A, A2);
    const REAL t0 = MUL(A, I_0);
    const REAL t1 = MUL(A2, d);
    const REAL x2 = SQUARE(x);
    const REAL x3 = MUL(x, x2);
    return ADD(ADD(ADD(BY_SQUARE(TIMES(4.0, A3), d), MUL(x, ADD(MUL(MUL(TIMES(3.0, A3), d), zeta_A),
        MUL(TIMES(9.0, t1), zeta)))), MUL(x2, ADD(ADD(ADD(BY_SQUARE(TIMES(4.0, A), zeta), MUL(MUL(TIMES(4.0, A2),
        zeta), zeta_A)), MUL(I_0A, t1)), MUL(TIMES(2.0, d), t0)))), MUL(x3, ADD(ADD(MUL(MUL(A, I_0A), zeta),
        MUL(I_0, zeta)), MUL(t0, zeta_A))));
}

/* The size of R where F = 0.
   Equation (24). Domain: Omega >= 0, A > 0. Operations: 4. Error / u (1 + kappa): measured 0.62. */
KERNEL REAL OF(R_of_response)(REAL F_0, REAL I_) {
    return SQRT(SUB(SQUARE(F_0), SQUARE(I_)));
}

/* R where F_Omega = 0.
   Equation from (24). Domain: Omega >= 0, A > 0. Operations: 9. Error / u (1 + kappa): proved 4.76. */
KERNEL REAL OF(R_of_peak)(REAL Omega, REAL A, REAL zeta, REAL d, REAL d_3, REAL I_) {
    return MUL(I_, SUB(SUB(NEG(MUL(MUL(BY_SQUARE(POINT(1.5), A), Omega), d_3)), MUL(A, d)), DIV(zeta, Omega)));
}

/* Where a level by inertia is stationary, x = 1/Omega: what is not negative, lower and higher R/Omega^2.
   Equation from (24). Domain: Omega >= 0, A > 0. Operations: 20. Error / u (1 + kappa): measured 0.92. */
KERNEL void OF(R_where_stationary)(REAL x, REAL A, REAL I_0, REAL zeta, REAL d, REAL *out) {
    const REAL t0 = SQUARE(A);
    const REAL t1 = MUL(A, zeta);
    const REAL t2 = MUL(MUL(x, ADD(MUL(I_0, x), t1)), ADD(ADD(BY_SQUARE(I_0, x), MUL(d, t0)), MUL(TIMES(2.0, t1),
        x)));
    const REAL t3 = SUB(t0, TIMES(4.0, t2));
    const REAL t4 = ADD(TIMES(0.5, A), TIMES(0.5, SQRT(t3)));
    out[0] = t3;
    out[1] = DIV(t2, t4);
    out[2] = t4;
}

/* F and F_A/2; derivatives by A and by R of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 73. Error / u (1 + kappa): proved -, 1.01, 9.26,
   8.26, -, -; measured 0.96. */
KERNEL void OF(folds_by_R)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = INVERSE(Omega);
    const REAL t1 = TIMES(2.0, zeta);
    const REAL t2 = TIMES(2.0, A);
    const REAL Omega2 = SQUARE(Omega);
    const REAL t3 = MUL(MUL(SQUARE(A), Omega2), d_3);
    const REAL t4 = MUL(t0, ADD(ADD(MUL(MUL(Omega, d), t2), t1), TIMES(3.0, t3)));
    const REAL t5 = MUL(R_A, t4);
    const REAL t6 = INVERSE(A);
    const REAL t7 = MUL(R_A, t6);
    const REAL t8 = TIMES(0.5, I_A);
    const REAL t9 = MUL(A, Omega);
    const REAL t10 = TIMES(4.0, d);
    const REAL t11 = MUL(t0, ADD(ADD(ADD(t1, MUL(t10, t9)), MUL(t2, zeta_A)), TIMES(9.0, t3)));
    const REAL t12 = TIMES(0.5, I_);
    const REAL Omega3 = MUL(Omega, Omega2);
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[2] = MUL(TIMES(2.0, I_), SUB(I_A, TIMES(0.5, t5)));
    out[3] = ADD(MUL(I_, t4), TIMES(2.0, R));
    out[4] = ADD(ADD(MUL(R, SUB(h_AA, t7)), MUL(t12, ADD(SUB(ADD(ADD(ADD(MUL(MUL(TIMES(12.0, A), Omega3), d_3),
        TIMES(2.0, I_0AA)), MUL(TIMES(8.0, Omega), zeta_A)), MUL(Omega2, t10)), MUL(t11, t7)), MUL(TIMES(4.0, t9),
        zeta_AA)))), MUL(t8, SUB(TIMES(2.0, I_A), t5)));
    out[5] = ADD(ADD(ADD(MUL(R, t6), R_A), MUL(MUL(t11, t12), t6)), MUL(t4, t8));
}

/* F and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 61. Error / u (1 + kappa): proved -, 6.01, 9.26, 8.26,
   -, -; measured 0.92. */
KERNEL void OF(peaks_by_R)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = MUL(A, d);
    const REAL t1 = INVERSE(Omega);
    const REAL t2 = MUL(t1, zeta);
    const REAL t3 = MUL(SQUARE(A), d_3);
    const REAL t4 = TIMES(2.0, zeta);
    const REAL t5 = TIMES(2.0, t0);
    const REAL t6 = SQUARE(Omega);
    const REAL t7 = TIMES(3.0, t3);
    const REAL t8 = MUL(t1, ADD(ADD(MUL(Omega, t5), t4), MUL(t6, t7)));
    const REAL t9 = MUL(R_A, t8);
    const REAL t10 = MUL(I_, t1);
    const REAL t11 = DIV(MUL(TIMES(0.25, t10), ADD(NEG(DIV(t4, t6)), t7)), A);
    const REAL t12 = ADD(ADD(MUL(TIMES(0.25, Omega), t7), TIMES(0.5, t2)), TIMES(0.25, t5));
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = ADD(MUL(I_, ADD(ADD(MUL(TIMES(1.5, Omega), t3), t0), t2)), R);
    out[2] = MUL(TIMES(2.0, I_), SUB(I_A, TIMES(0.5, t9)));
    out[3] = ADD(MUL(I_, t8), TIMES(2.0, R));
    out[4] = ADD(ADD(SUB(MUL(I_, ADD(MUL(MUL(TIMES(3.0, A), Omega), d_3), d)), MUL(R_A, t11)), MUL(t10, zeta_A)),
        MUL(t12, SUB(TIMES(2.0, I_A), t9)));
    out[5] = ADD(ADD(t11, MUL(t12, t8)), POINT(1.0));
}

/* F_A/2 and F_AA/2; derivatives by A and by R of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 125. Error / u (1 + kappa): proved 1.01, 10.26,
   -, -, -, -; measured 0.71. */
KERNEL void OF(cusps_by_R)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = MUL(Omega, zeta_A);
    const REAL t1 = TIMES(4.0, t0);
    const REAL t2 = MUL(A, zeta_AA);
    const REAL t3 = MUL(Omega, t2);
    const REAL t4 = TIMES(2.0, t3);
    const REAL Omega2 = SQUARE(Omega);
    const REAL t5 = MUL(Omega2, d);
    const REAL t6 = TIMES(2.0, t5);
    const REAL Omega3 = MUL(Omega, Omega2);
    const REAL t7 = MUL(Omega3, d_3);
    const REAL t8 = MUL(A, t7);
    const REAL t9 = TIMES(6.0, t8);
    const REAL t10 = INVERSE(A);
    const REAL t11 = MUL(R_A, t10);
    const REAL t12 = SUB(h_AA, t11);
    const REAL t13 = INVERSE(Omega);
    const REAL t14 = TIMES(2.0, zeta);
    const REAL t15 = MUL(Omega, d);
    const REAL t16 = TIMES(2.0, t15);
    const REAL t17 = MUL(MUL(SQUARE(A), Omega2), d_3);
    const REAL t18 = MUL(t13, ADD(ADD(MUL(A, t16), t14), TIMES(3.0, t17)));
    const REAL t19 = SUB(I_A, MUL(TIMES(0.5, R_A), t18));
    const REAL t20 = TIMES(2.0, zeta_A);
    const REAL t21 = MUL(t13, ADD(ADD(ADD(MUL(TIMES(4.0, A), t15), MUL(A, t20)), t14), TIMES(9.0, t17)));
    const REAL t22 = ADD(ADD(ADD(SUB(ADD(TIMES(2.0, I_0AA), TIMES(8.0, t0)), MUL(t11, t21)), TIMES(4.0, t3)),
        TIMES(4.0, t5)), TIMES(12.0, t8));
    const REAL t23 = TIMES(0.5, I_);
    const REAL t24 = TIMES(0.5, t18);
    const REAL t25 = MUL(t10, t21);
    const REAL t26 = TIMES(6.0, I_);
    const REAL t27 = MUL(MUL(I_, t13), ADD(ADD(ADD(MUL(MUL(TIMES(9.0, A), Omega2), d_3), t16), t2), t20));
    const REAL t28 = ADD(ADD(ADD(ADD(I_0AA, t1), t4), t6), t9);
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(I_, I_0AA), MUL(I_, t1)), MUL(I_, t4)), MUL(I_, t6)), MUL(I_, t9)),
        SQUARE(I_A)), MUL(R, h_AA)), SQUARE(R_A));
    out[2] = ADD(ADD(MUL(I_A, t19), MUL(R, t12)), MUL(t22, t23));
    out[3] = ADD(ADD(ADD(MUL(I_A, t24), MUL(R, t10)), R_A), MUL(t23, t25));
    out[4] = ADD(ADD(SUB(ADD(ADD(ADD(ADD(ADD(MUL(MUL(MUL(TIMES(2.0, A), I_), Omega), zeta_AAA), MUL(I_, I_0AAA)),
        MUL(I_A, t22)), MUL(MUL(Omega, t26), zeta_AA)), MUL(R, h_AAA)), MUL(TIMES(2.0, R_A), t12)), MUL(t11, t27)),
        MUL(t19, t28)), MUL(t26, t7));
    out[5] = ADD(ADD(ADD(ADD(MUL(I_A, t25), h_AA), MUL(t10, t27)), TIMES(2.0, t11)), MUL(t24, t28));
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 95. Error / u (1 + kappa): proved 1.01, 6.01, -, -, -,
   -; measured 0.67. */
KERNEL void OF(isolas_by_R)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = MUL(A, d);
    const REAL t1 = INVERSE(Omega);
    const REAL t2 = MUL(t1, zeta);
    const REAL t3 = MUL(SQUARE(A), d_3);
    const REAL t4 = INVERSE(A);
    const REAL t5 = MUL(R_A, t4);
    const REAL Omega2 = SQUARE(Omega);
    const REAL t6 = TIMES(2.0, zeta);
    const REAL t7 = TIMES(2.0, t0);
    const REAL t8 = TIMES(3.0, t3);
    const REAL t9 = MUL(t1, ADD(ADD(MUL(Omega, t7), MUL(Omega2, t8)), t6));
    const REAL t10 = SUB(TIMES(2.0, I_A), MUL(R_A, t9));
    const REAL t11 = TIMES(0.5, I_A);
    const REAL t12 = TIMES(4.0, Omega);
    const REAL t13 = MUL(A, d_3);
    const REAL t14 = MUL(t1, ADD(ADD(ADD(MUL(TIMES(2.0, A), zeta_A), MUL(TIMES(9.0, Omega2), t3)), MUL(t0, t12)),
        t6));
    const REAL t15 = TIMES(0.5, I_);
    const REAL t16 = MUL(I_, t1);
    const REAL t17 = MUL(TIMES(0.25, t16), SUB(t8, DIV(t6, Omega2)));
    const REAL t18 = ADD(ADD(MUL(TIMES(0.25, Omega), t8), TIMES(0.5, t2)), TIMES(0.25, t7));
    const REAL Omega3 = MUL(Omega, Omega2);
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(MUL(I_, ADD(ADD(MUL(TIMES(1.5, Omega), t3), t0), t2)), R);
    out[2] = ADD(ADD(MUL(R, SUB(h_AA, t5)), MUL(t10, t11)), MUL(t15, SUB(ADD(ADD(ADD(ADD(MUL(MUL(A, t12),
        zeta_AA), TIMES(2.0, I_0AA)), MUL(TIMES(8.0, Omega), zeta_A)), MUL(TIMES(4.0, Omega2), d)), MUL(TIMES(12.0,
        Omega3), t13)), MUL(t14, t5))));
    out[3] = ADD(ADD(ADD(MUL(R, t4), R_A), MUL(t11, t9)), MUL(MUL(t14, t15), t4));
    out[4] = SUB(ADD(ADD(MUL(I_, ADD(MUL(TIMES(3.0, Omega), t13), d)), MUL(t10, t18)), MUL(t16, zeta_A)), MUL(t17,
        t5));
    out[5] = ADD(ADD(MUL(t17, t4), MUL(t18, t9)), POINT(1.0));
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 241. Error / u (1 + kappa): proved 1.01, -, -, -, -, -;
   measured 2.1. */
KERNEL void OF(turns_by_R)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = MUL(R, R_A);
    const REAL t1 = MUL(A, R_A);
    const REAL t2 = MUL(TIMES(2.0, I_), d);
    const REAL A2 = SQUARE(A);
    const REAL t3 = MUL(I_A, d);
    const REAL t4 = INVERSE(Omega);
    const REAL t5 = MUL(I_, t4);
    const REAL t6 = MUL(t5, zeta);
    const REAL t7 = MUL(t5, zeta_A);
    const REAL t8 = MUL(t4, zeta);
    const REAL t9 = MUL(I_A, t8);
    const REAL t10 = MUL(A2, d_3);
    const REAL t11 = MUL(I_, Omega);
    const REAL t12 = TIMES(4.5, t11);
    const REAL A3 = MUL(A, A2);
    const REAL t13 = MUL(A3, d_3);
    const REAL t14 = MUL(I_A, Omega);
    const REAL t15 = TIMES(1.5, t14);
    const REAL t16 = INVERSE(A);
    const REAL Omega2 = SQUARE(Omega);
    const REAL t17 = MUL(d_3, t1);
    const REAL Omega3 = MUL(Omega, Omega2);
    const REAL t18 = MUL(t10, t15);
    const REAL t19 = MUL(t16, t6);
    const REAL t20 = MUL(A, t3);
    const REAL t21 = MUL(A, d_3);
    const REAL t22 = TIMES(4.0, zeta_A);
    const REAL t23 = MUL(A, zeta);
    const REAL t24 = MUL(A2, d);
    const REAL t25 = MUL(Omega, d);
    const REAL t26 = MUL(A2, zeta);
    const REAL t27 = TIMES(2.0, zeta_AA);
    const REAL t28 = MUL(A, t8);
    const REAL t29 = MUL(I_A, t4);
    const REAL t30 = TIMES(2.0, zeta_A);
    const REAL t31 = MUL(d_3, t26);
    const REAL t32 = TIMES(12.0, t31);
    const REAL t33 = MUL(t13, zeta_A);
    const REAL t34 = TIMES(3.0, t33);
    const REAL t35 = DIV(POINT(0.5), Omega3);
    const REAL t36 = MUL(I_, t35);
    const REAL t37 = MUL(t36, zeta_A);
    const REAL t38 = MUL(MUL(I_A, t35), zeta);
    const REAL t39 = BY_SQUARE(A2, d);
    const REAL t40 = TIMES(4.0, t39);
    const REAL t41 = DIV(POINT(2.0), Omega2);
    const REAL t42 = BY_SQUARE(t41, zeta);
    const REAL t43 = TIMES(2.25, t5);
    const REAL t44 = MUL(t41, zeta_A);
    const REAL t45 = TIMES(6.0, d);
    const REAL t46 = MUL(TIMES(15.0, t13), t25);
    const REAL t47 = TIMES(6.0, Omega2);
    const REAL A4 = SQUARE(A2);
    const REAL t48 = BY_SQUARE(A4, d_3);
    const REAL t49 = MUL(MUL(t16, t36), zeta);
    const REAL t50 = MUL(TIMES(0.75, t10), t29);
    const REAL t51 = MUL(MUL(t24, t30), t4);
    const REAL t52 = MUL(TIMES(13.5, Omega2), t48);
    const REAL Omega4 = SQUARE(Omega2);
    out[0] = ADD(MUL(I_, I_A), t0);
    out[1] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(A, t2), MUL(A, t7)), MUL(A, t9)), MUL(A2, t3)), R), t1), MUL(t10,
        t12)), MUL(t13, t15)), t6);
    out[2] = SUB(SUB(SUB(SUB(SUB(SUB(SUB(SUB(ADD(ADD(ADD(ADD(ADD(ADD(MUL(MUL(MUL(TIMES(2.0, A), I_), Omega),
        zeta_AA), MUL(MUL(MUL(TIMES(6.0, A), I_), Omega3), d_3)), MUL(I_, I_0AA)), MUL(MUL(TIMES(4.0, I_), Omega),
        zeta_A)), MUL(MUL(TIMES(2.0, I_), Omega2), d)), SQUARE(I_A)), MUL(R, h_AA)), MUL(R_A, t18)), MUL(R_A, t19)),
        MUL(R_A, t2)), MUL(R_A, t7)), MUL(R_A, t9)), MUL(t0, t16)), MUL(t1, t3)), MUL(t12, t17));
    out[3] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(R, t16), R_A), MUL(t12, t21)), t18), t19), t2), t20), t7), t9);
    out[4] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(SUB(ADD(ADD(SUB(SUB(SUB(SUB(SUB(ADD(SUB(SUB(SUB(ADD(ADD(SUB(SUB(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(A,
        h_AA), MUL(MUL(A, t29), t30)), MUL(MUL(A, t5), zeta_AA)), MUL(MUL(A3, t25), t27)), MUL(MUL(MUL(TIMES(3.0,
        A4), Omega2), d_3), zeta_AA)), MUL(MUL(TIMES(1.5, I_0AA), Omega), t13)), MUL(I_0AA, t24)), MUL(I_0AA, t28)),
        MUL(MUL(Omega, t22), t24)), MUL(TIMES(2.0, Omega2), t39)), MUL(MUL(TIMES(9.0, Omega3), d), t13)),
        MUL(TIMES(9.0, Omega4), t48)), MUL(R_A, t32)), MUL(R_A, t34)), MUL(R_A, t37)), MUL(R_A, t38)), MUL(R_A,
        t40)), MUL(R_A, t42)), MUL(R_A, t46)), MUL(R_A, t49)), MUL(R_A, t50)), MUL(R_A, t51)), MUL(R_A, t52)),
        MUL(MUL(t1, t44), zeta)), MUL(MUL(t1, t45), t8)), MUL(TIMES(9.0, t10), t14)), MUL(TIMES(9.0, t11), t21)),
        MUL(t17, t43)), t2), TIMES(4.0, t20)), MUL(t22, t23)), MUL(TIMES(2.0, t23), t25)), MUL(t26, t27)), MUL(t31,
        t47)), MUL(t33, t47)), TIMES(2.0, t7)), TIMES(2.0, t9));
    out[5] = ADD(ADD(ADD(ADD(SUB(ADD(ADD(ADD(SUB(SUB(ADD(ADD(ADD(ADD(MUL(t21, t43), MUL(t23, t44)), MUL(t28,
        t45)), t32), t34), t37), t38), t40), t42), t46), t49), t50), t51), t52), POINT(2.0));
}

/* F and F_A/2; derivatives by A and by Omega of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 59. Error / u (1 + kappa): proved -, 1.01, 1.01,
   7.26, 10.26, -; measured 0.5. */
KERNEL void OF(folds_by_Omega)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = ADD(MUL(I_, I_A), MUL(R, R_A));
    const REAL t1 = TIMES(2.0, Omega);
    const REAL t2 = MUL(R, t1);
    const REAL t3 = TIMES(2.0, zeta);
    const REAL t4 = MUL(A, t1);
    const REAL Omega2 = SQUARE(Omega);
    const REAL t5 = MUL(MUL(SQUARE(A), Omega2), d_3);
    const REAL t6 = ADD(ADD(MUL(d, t4), t3), TIMES(3.0, t5));
    const REAL t7 = TIMES(2.0, A);
    const REAL t8 = TIMES(4.0, Omega);
    const REAL Omega3 = MUL(Omega, Omega2);
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = t0;
    out[2] = TIMES(2.0, t0);
    out[3] = MUL(t7, ADD(MUL(I_, t6), t2));
    out[4] = ADD(ADD(ADD(MUL(I_, ADD(ADD(ADD(ADD(MUL(MUL(TIMES(6.0, A), Omega3), d_3), I_0AA), MUL(TIMES(2.0,
        Omega2), d)), MUL(t4, zeta_AA)), MUL(t8, zeta_A))), SQUARE(I_A)), MUL(R, h_AA)), SQUARE(R_A));
    out[5] = ADD(ADD(ADD(MUL(MUL(A, I_A), t6), MUL(I_, ADD(ADD(ADD(MUL(MUL(A, d), t8), t3), TIMES(9.0, t5)),
        MUL(t7, zeta_A)))), MUL(R_A, t4)), t2);
}

/* F and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 101. Error / u (1 + kappa): proved -, -, 1.01, 7.26, -,
   -; measured 0.72. */
KERNEL void OF(peaks_by_Omega)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = INVERSE(Omega);
    const REAL t1 = MUL(I_0, t0);
    const REAL t2 = TIMES(3.0, zeta);
    const REAL t3 = MUL(A, Omega);
    const REAL t4 = MUL(d, t3);
    const REAL t5 = ADD(ADD(MUL(I_0, d), MUL(t4, ADD(t2, t4))), BY_SQUARE(POINT(2.0), zeta));
    const REAL t6 = TIMES(5.0, d);
    const REAL t7 = TIMES(3.0, d_3);
    const REAL t8 = ADD(MUL(t3, ADD(MUL(t3, t7), t6)), TIMES(8.0, zeta));
    const REAL t9 = ADD(TIMES(3.0, I_0), MUL(t3, t8));
    const REAL A2 = SQUARE(A);
    const REAL t10 = TIMES(0.5, A2);
    const REAL t11 = MUL(MUL(d_3, t10), t9);
    const REAL t12 = TIMES(2.0, zeta);
    const REAL t13 = TIMES(2.0, t4);
    const REAL t14 = SQUARE(Omega);
    const REAL t15 = MUL(A2, t7);
    const REAL t16 = TIMES(2.0, A);
    const REAL A3 = MUL(A, A2);
    const REAL t17 = MUL(d_3, t14);
    const REAL t18 = ADD(t13, t2);
    const REAL t19 = MUL(d_3, t3);
    const REAL t20 = ADD(MUL(t3, ADD(TIMES(6.0, t19), t6)), t8);
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = ADD(ADD(ADD(MUL(A, t5), MUL(Omega, t11)), R), MUL(t1, zeta));
    out[2] = TIMES(2.0, ADD(MUL(I_, I_A), MUL(R, R_A)));
    out[3] = MUL(t16, ADD(MUL(I_, ADD(ADD(t12, t13), MUL(t14, t15))), MUL(TIMES(2.0, Omega), R)));
    out[4] = ADD(ADD(ADD(ADD(ADD(ADD(MUL(TIMES(0.5, I_0A), ADD(ADD(MUL(Omega, t15), MUL(d, t16)), MUL(t0, t12))),
        R_A), MUL(MUL(t10, t17), t20)), MUL(t18, t4)), MUL(t19, t9)), t5), MUL(zeta_A, ADD(ADD(MUL(A, ADD(TIMES(3.0,
        t4), TIMES(4.0, zeta))), MUL(TIMES(4.0, A3), t17)), t1)));
    out[5] = ADD(ADD(SUB(ADD(MUL(MUL(A2, d), t18), MUL(MUL(MUL(TIMES(0.5, A3), Omega), d_3), t20)), DIV(MUL(I_0,
        zeta), t14)), t11), TIMES(2.0, t3));
}

/* F_A/2 and F_AA/2; derivatives by A and by Omega of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 99. Error / u (1 + kappa): proved 1.01, 8.26,
   8.26, -, -, -; measured 1.2. */
KERNEL void OF(cusps_by_Omega)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL Omega2 = SQUARE(Omega);
    const REAL t0 = TIMES(2.0, d);
    const REAL t1 = MUL(Omega2, t0);
    const REAL t2 = TIMES(4.0, zeta_A);
    const REAL t3 = MUL(Omega, t2);
    const REAL t4 = TIMES(2.0, A);
    const REAL t5 = MUL(Omega, t4);
    const REAL t6 = MUL(t5, zeta_AA);
    const REAL t7 = MUL(A, d_3);
    const REAL Omega3 = MUL(Omega, Omega2);
    const REAL t8 = TIMES(6.0, Omega3);
    const REAL t9 = MUL(t7, t8);
    const REAL t10 = ADD(ADD(SQUARE(I_A), MUL(R, h_AA)), SQUARE(R_A));
    const REAL t11 = ADD(ADD(ADD(ADD(I_0AA, t1), t3), t6), t9);
    const REAL t12 = TIMES(2.0, zeta);
    const REAL t13 = MUL(MUL(SQUARE(A), Omega2), d_3);
    const REAL t14 = MUL(A, ADD(ADD(MUL(MUL(A, Omega), t0), t12), TIMES(3.0, t13)));
    const REAL t15 = TIMES(4.0, Omega);
    const REAL t16 = MUL(d, t15);
    const REAL t17 = ADD(ADD(ADD(MUL(A, t16), t12), TIMES(9.0, t13)), MUL(t4, zeta_A));
    const REAL t18 = MUL(I_, zeta_AA);
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(ADD(ADD(ADD(ADD(MUL(I_, I_0AA), MUL(I_, t1)), MUL(I_, t3)), MUL(I_, t6)), MUL(I_, t9)), t10);
    out[2] = ADD(MUL(I_, t11), t10);
    out[3] = ADD(ADD(ADD(MUL(I_, t17), MUL(I_A, t14)), MUL(TIMES(2.0, Omega), R)), MUL(R_A, t5));
    out[4] = ADD(ADD(ADD(ADD(ADD(ADD(MUL(I_, I_0AAA), MUL(MUL(I_, d_3), t8)), MUL(MUL(I_, t5), zeta_AAA)),
        MUL(TIMES(3.0, I_A), t11)), MUL(TIMES(6.0, Omega), t18)), MUL(R, h_AAA)), MUL(TIMES(3.0, R_A), h_AA));
    out[5] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(MUL(TIMES(18.0, I_), Omega2), t7), MUL(I_, t16)), MUL(I_, t2)),
        MUL(TIMES(2.0, I_A), t17)), MUL(R_A, t15)), MUL(h_AA, t5)), MUL(t11, t14)), MUL(t18, t4));
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 125. Error / u (1 + kappa): proved 1.01, -, 10.26, -,
   -, -; measured 0.49. */
KERNEL void OF(isolas_by_Omega)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = INVERSE(Omega);
    const REAL t1 = MUL(I_0, t0);
    const REAL t2 = TIMES(3.0, zeta);
    const REAL t3 = MUL(A, Omega);
    const REAL t4 = MUL(d, t3);
    const REAL t5 = ADD(ADD(MUL(I_0, d), MUL(t4, ADD(t2, t4))), BY_SQUARE(POINT(2.0), zeta));
    const REAL A2 = SQUARE(A);
    const REAL t6 = MUL(A2, Omega);
    const REAL t7 = TIMES(5.0, d);
    const REAL t8 = TIMES(3.0, d_3);
    const REAL t9 = ADD(MUL(t3, ADD(MUL(t3, t8), t7)), TIMES(8.0, zeta));
    const REAL t10 = MUL(d_3, ADD(TIMES(3.0, I_0), MUL(t3, t9)));
    const REAL t11 = TIMES(0.5, t10);
    const REAL t12 = TIMES(2.0, t3);
    const REAL Omega2 = SQUARE(Omega);
    const REAL t13 = TIMES(2.0, d);
    const REAL t14 = TIMES(6.0, d_3);
    const REAL t15 = TIMES(2.0, zeta);
    const REAL t16 = TIMES(2.0, t4);
    const REAL t17 = MUL(A2, Omega2);
    const REAL t18 = MUL(d_3, t17);
    const REAL A3 = MUL(A, A2);
    const REAL t19 = MUL(A3, d_3);
    const REAL t20 = ADD(t16, t2);
    const REAL t21 = ADD(MUL(TIMES(0.5, t3), ADD(MUL(t14, t3), t7)), TIMES(0.5, t9));
    const REAL Omega3 = MUL(Omega, Omega2);
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(ADD(ADD(MUL(A, t5), R), MUL(t1, zeta)), MUL(t11, t6));
    out[2] = ADD(ADD(ADD(MUL(I_, ADD(ADD(ADD(ADD(MUL(MUL(A, Omega3), t14), I_0AA), MUL(TIMES(4.0, Omega),
        zeta_A)), MUL(Omega2, t13)), MUL(t12, zeta_AA))), SQUARE(I_A)), MUL(R, h_AA)), SQUARE(R_A));
    out[3] = ADD(ADD(ADD(MUL(MUL(A, I_A), ADD(ADD(t15, t16), MUL(t17, t8))), MUL(I_, ADD(ADD(ADD(MUL(TIMES(2.0,
        A), zeta_A), t15), TIMES(9.0, t18)), TIMES(4.0, t4)))), MUL(TIMES(2.0, Omega), R)), MUL(R_A, t12));
    out[4] = ADD(ADD(ADD(ADD(ADD(ADD(MUL(TIMES(0.5, I_0A), ADD(ADD(MUL(A, t13), MUL(t0, t15)), MUL(t6, t8))),
        R_A), MUL(t10, t3)), MUL(t18, t21)), MUL(t20, t4)), t5), MUL(zeta_A, ADD(ADD(MUL(A, ADD(TIMES(3.0, t4),
        TIMES(4.0, zeta))), MUL(TIMES(4.0, Omega2), t19)), t1)));
    out[5] = ADD(ADD(SUB(ADD(MUL(MUL(A2, d), t20), MUL(A2, t11)), DIV(MUL(I_0, zeta), Omega2)), MUL(MUL(Omega,
        t19), t21)), t12);
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 203. Error / u (1 + kappa): proved 1.01, -, 10.26, -,
   -, -; measured 1.7. */
KERNEL void OF(turns_by_Omega)(REAL Omega, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = MUL(A, R_A);
    const REAL t1 = TIMES(2.0, I_);
    const REAL t2 = MUL(d, t1);
    const REAL A2 = SQUARE(A);
    const REAL t3 = MUL(A2, d);
    const REAL t4 = MUL(I_A, t3);
    const REAL t5 = INVERSE(Omega);
    const REAL t6 = MUL(I_, zeta);
    const REAL t7 = MUL(A, t5);
    const REAL t8 = MUL(I_, zeta_A);
    const REAL t9 = MUL(I_A, zeta);
    const REAL t10 = MUL(I_, d_3);
    const REAL t11 = MUL(A2, t10);
    const REAL t12 = TIMES(4.5, t11);
    const REAL t13 = TIMES(1.5, I_A);
    const REAL A3 = MUL(A, A2);
    const REAL t14 = MUL(A3, Omega);
    const REAL t15 = MUL(d_3, t14);
    const REAL t16 = TIMES(4.0, Omega);
    const REAL t17 = MUL(I_, zeta_AA);
    const REAL t18 = TIMES(2.0, Omega);
    const REAL t19 = MUL(A, t18);
    const REAL Omega2 = SQUARE(Omega);
    const REAL Omega3 = MUL(Omega, Omega2);
    const REAL t20 = MUL(A, t10);
    const REAL t21 = MUL(t1, zeta_A);
    const REAL t22 = TIMES(2.0, t9);
    const REAL t23 = MUL(A, t16);
    const REAL t24 = MUL(A3, d_3);
    const REAL t25 = TIMES(3.0, Omega2);
    const REAL t26 = TIMES(4.0, A);
    const REAL t27 = MUL(zeta, zeta_A);
    const REAL t28 = TIMES(9.0, Omega);
    const REAL t29 = TIMES(2.0, A2);
    const REAL t30 = MUL(A2, d_3);
    const REAL t31 = MUL(A3, d);
    const REAL t32 = TIMES(6.0, Omega2);
    const REAL A4 = SQUARE(A2);
    const REAL t33 = MUL(A4, d_3);
    const REAL t34 = SQUARE(d);
    const REAL t35 = SQUARE(d_3);
    const REAL t36 = INVERSE(Omega2);
    const REAL t37 = MUL(A, t36);
    const REAL Omega4 = SQUARE(Omega2);
    const REAL A5 = MUL(A, A4);
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(A, t2), MUL(Omega, t12)), R), t0), MUL(t13, t15)), t4), MUL(t5,
        t6)), MUL(t7, t8)), MUL(t7, t9));
    out[2] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(I_, I_0AA), SQUARE(I_A)), MUL(Omega2, t2)), MUL(TIMES(6.0, Omega3),
        t20)), MUL(R, h_AA)), SQUARE(R_A)), MUL(t16, t8)), MUL(t17, t19));
    out[3] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(A, t21), MUL(A, t22)), MUL(MUL(I_, d), t23)), MUL(MUL(I_A, t24),
        t25)), MUL(TIMES(9.0, Omega2), t11)), MUL(R, t18)), MUL(t0, t18)), MUL(t18, t4)), TIMES(2.0, t6));
    out[4] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(A,
        h_AA), MUL(MUL(TIMES(9.0, A4), Omega4), t35)), MUL(TIMES(1.5, I_0AA), t15)), MUL(I_0AA, t3)), MUL(MUL(I_0AA,
        t7), zeta)), MUL(MUL(I_A, d), t26)), MUL(MUL(I_A, t28), t30)), MUL(MUL(TIMES(2.0, I_A), t7), zeta_A)),
        MUL(MUL(Omega2, t29), t34)), MUL(MUL(TIMES(9.0, Omega3), d_3), t31)), TIMES(2.0, R_A)), MUL(MUL(d, t19),
        zeta)), MUL(MUL(t16, t3), zeta_A)), MUL(t17, t7)), MUL(MUL(t18, t31), zeta_AA)), t2), MUL(t20, t28)),
        MUL(t21, t5)), MUL(t22, t5)), MUL(MUL(t24, t32), zeta_A)), MUL(MUL(t25, t33), zeta_AA)), MUL(t26, t27)),
        MUL(MUL(t29, zeta), zeta_AA)), MUL(MUL(t30, t32), zeta));
    out[5] = ADD(SUB(SUB(SUB(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(MUL(TIMES(4.0, A2), t27), t5),
        MUL(MUL(TIMES(27.0, A5), Omega3), t35)), MUL(MUL(TIMES(6.0, Omega), t33), zeta_A)), MUL(MUL(TIMES(30.0,
        Omega2), d), t33)), t12), MUL(t13, t24)), MUL(TIMES(8.0, t14), t34)), MUL(TIMES(24.0, t15), zeta)), t23),
        MUL(TIMES(12.0, t3), zeta)), MUL(TIMES(4.0, t31), zeta_A)), MUL(t36, t6)), MUL(t37, t8)), MUL(t37, t9)),
        BY_SQUARE(TIMES(4.0, t7), zeta));
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 54. Error / u (1 + kappa): proved -, 1.01, 4.01,
   3.51, 24.51, 12.34; measured 0.79. */
KERNEL void OF(folds_far_by_R)(REAL x, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = INVERSE(h);
    const REAL t1 = DIV(t0, x);
    const REAL t2 = MUL(t1, ADD(MUL(A, zeta), MUL(I_0, x)));
    const REAL t3 = SUB(I_A, MUL(R_A, t2));
    const REAL t4 = SQUARE(x);
    const REAL t5 = MUL(h_A, t0);
    const REAL t6 = MUL(t1, ADD(ADD(MUL(A, zeta_A), MUL(I_0A, x)), zeta));
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[2] = MUL(TIMES(2.0, I_), t3);
    out[3] = TIMES(2.0, ADD(MUL(I_, t2), R));
    out[4] = ADD(ADD(MUL(I_, ADD(ADD(SUB(ADD(MUL(MUL(TIMES(2.0, A), x), zeta_AA), MUL(I_0AA, t4)), MUL(R_A, t6)),
        TIMES(2.0, d)), MUL(TIMES(4.0, x), zeta_A))), MUL(I_A, t3)), MUL(R, ADD(NEG(MUL(R_A, t5)), MUL(h_AA, t4))));
    out[5] = ADD(ADD(ADD(MUL(I_, t6), MUL(I_A, t2)), MUL(R, t5)), R_A);
}

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 56. Error / u (1 + kappa): proved -, 3.26, 4.51, 4.01,
   -, -; measured 0.97. */
KERNEL void OF(peaks_far_by_R)(REAL x, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = INVERSE(h);
    const REAL t1 = INVERSE(x);
    const REAL t2 = MUL(A, zeta);
    const REAL t3 = MUL(t1, t2);
    const REAL t4 = ADD(MUL(I_0, x), t2);
    const REAL t5 = MUL(t0, t4);
    const REAL t6 = SUB(I_A, MUL(MUL(R_A, t1), t5));
    const REAL t7 = MUL(I_, t1);
    const REAL t8 = MUL(I_, t0);
    const REAL x2 = SQUARE(x);
    const REAL x3 = MUL(x, x2);
    const REAL t9 = DIV(TIMES(0.5, t2), x3);
    const REAL t10 = ADD(I_0, t3);
    const REAL t11 = INVERSE(SQUARE(h));
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = ADD(MUL(I_, ADD(MUL(I_0, t0), MUL(t0, t3))), R);
    out[2] = MUL(TIMES(2.0, I_), t6);
    out[3] = TIMES(2.0, ADD(R, MUL(t5, t7)));
    out[4] = MUL(t0, ADD(ADD(SUB(ADD(ADD(MUL(MUL(A, t7), zeta_A), MUL(I_, I_0A)), MUL(MUL(R_A, t8), t9)),
        MUL(MUL(h_A, t10), t8)), MUL(t10, t6)), MUL(t7, zeta)));
    out[5] = ADD(ADD(NEG(MUL(MUL(I_, t11), t9)), MUL(MUL(MUL(t1, t10), t11), t4)), POINT(1.0));
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 99. Error / u (1 + kappa): proved 1.01, 8.01,
   21.51, 12.34, -, -; measured 0.63. */
KERNEL void OF(cusps_far_by_R)(REAL x, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = TIMES(2.0, d);
    const REAL t1 = MUL(TIMES(4.0, x), zeta_A);
    const REAL t2 = SQUARE(x);
    const REAL t3 = MUL(I_0AA, t2);
    const REAL t4 = MUL(h_AA, t2);
    const REAL t5 = TIMES(2.0, I_);
    const REAL t6 = MUL(A, zeta_AA);
    const REAL t7 = MUL(t6, x);
    const REAL t8 = INVERSE(h);
    const REAL t9 = MUL(h_A, t8);
    const REAL t10 = MUL(R_A, t9);
    const REAL t11 = SUB(MUL(h_AA, t2), t10);
    const REAL t12 = ADD(MUL(A, zeta), MUL(I_0, x));
    const REAL t13 = DIV(t8, x);
    const REAL t14 = MUL(R_A, t13);
    const REAL t15 = SUB(I_A, MUL(t12, t14));
    const REAL t16 = ADD(ADD(MUL(A, zeta_A), MUL(I_0A, x)), zeta);
    const REAL t17 = ADD(ADD(ADD(t0, t1), t3), TIMES(2.0, t7));
    const REAL t18 = ADD(NEG(MUL(t14, t16)), t17);
    const REAL t19 = MUL(t12, t13);
    const REAL t20 = MUL(t13, t16);
    const REAL t21 = MUL(I_, x);
    const REAL t22 = MUL(t13, ADD(ADD(ADD(MUL(I_, t6), MUL(I_0AA, t21)), MUL(MUL(R, h_AA), x)), MUL(t5, zeta_A)));
    const REAL t23 = TIMES(2.0, I_A);
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(ADD(ADD(ADD(ADD(ADD(MUL(I_, t0), MUL(I_, t1)), MUL(I_, t3)), SQUARE(I_A)), MUL(R, t4)),
        SQUARE(R_A)), MUL(t5, t7));
    out[2] = ADD(ADD(MUL(I_, t18), MUL(I_A, t15)), MUL(R, t11));
    out[3] = ADD(ADD(ADD(MUL(I_, t20), MUL(I_A, t19)), MUL(R, t9)), R_A);
    out[4] = ADD(ADD(ADD(SUB(ADD(ADD(ADD(MUL(MUL(MUL(A, t5), x), zeta_AAA), MUL(MUL(I_, I_0AAA), t2)), MUL(MUL(R,
        h_AAA), t2)), MUL(TIMES(2.0, R_A), t11)), MUL(R_A, t22)), MUL(t15, t17)), MUL(t18, t23)), MUL(TIMES(6.0,
        t21), zeta_AA));
    out[5] = ADD(ADD(ADD(ADD(TIMES(2.0, t10), MUL(t17, t19)), MUL(t20, t23)), t22), t4);
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 80. Error / u (1 + kappa): proved 1.01, 3.26, 25.84,
   13.67, -, -; measured 0.46. */
KERNEL void OF(isolas_far_by_R)(REAL x, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = INVERSE(h);
    const REAL t1 = INVERSE(x);
    const REAL t2 = MUL(A, zeta);
    const REAL t3 = MUL(t1, t2);
    const REAL x2 = SQUARE(x);
    const REAL t4 = MUL(h_A, t0);
    const REAL t5 = MUL(R_A, t1);
    const REAL t6 = ADD(MUL(I_0, x), t2);
    const REAL t7 = MUL(t0, t6);
    const REAL t8 = SUB(I_A, MUL(t5, t7));
    const REAL t9 = MUL(A, zeta_A);
    const REAL t10 = MUL(t0, ADD(ADD(MUL(I_0A, x), t9), zeta));
    const REAL t11 = MUL(I_, t1);
    const REAL x3 = MUL(x, x2);
    const REAL t12 = DIV(MUL(TIMES(0.5, I_), t2), x3);
    const REAL t13 = ADD(I_0, t3);
    const REAL t14 = INVERSE(SQUARE(h));
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(MUL(I_, ADD(MUL(I_0, t0), MUL(t0, t3))), R);
    out[2] = ADD(ADD(MUL(I_, ADD(SUB(ADD(ADD(MUL(MUL(TIMES(2.0, A), x), zeta_AA), MUL(I_0AA, x2)), TIMES(2.0, d)),
        MUL(t10, t5)), MUL(TIMES(4.0, x), zeta_A))), MUL(I_A, t8)), MUL(R, ADD(NEG(MUL(R_A, t4)), MUL(h_AA, x2))));
    out[3] = ADD(ADD(ADD(MUL(MUL(I_A, t1), t7), MUL(R, t4)), R_A), MUL(t10, t11));
    out[4] = MUL(t0, ADD(ADD(ADD(ADD(SUB(MUL(I_, I_0A), MUL(MUL(I_, t13), t4)), MUL(MUL(R_A, t0), t12)), MUL(t11,
        t9)), MUL(t11, zeta)), MUL(t13, t8)));
    out[5] = ADD(SUB(MUL(MUL(MUL(t1, t13), t14), t6), MUL(t12, t14)), POINT(1.0));
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 49. Error / u (1 + kappa): proved -, 1.01, 1.01,
   2.01, 8.01, 8.34; measured 0.53. */
KERNEL void OF(folds_far_by_x)(REAL x, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = ADD(MUL(I_, I_A), MUL(R, R_A));
    const REAL t1 = MUL(R, x);
    const REAL t2 = ADD(MUL(A, zeta), MUL(I_0, x));
    const REAL t3 = SQUARE(x);
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = t0;
    out[2] = TIMES(2.0, t0);
    out[3] = TIMES(4.0, ADD(MUL(I_, t2), MUL(h, t1)));
    out[4] = ADD(ADD(ADD(MUL(I_, ADD(ADD(ADD(MUL(MUL(TIMES(2.0, A), x), zeta_AA), MUL(I_0AA, t3)), TIMES(2.0, d)),
        MUL(TIMES(4.0, x), zeta_A))), SQUARE(I_A)), MUL(MUL(R, h_AA), t3)), SQUARE(R_A));
    out[5] = TIMES(2.0, ADD(ADD(ADD(MUL(I_, ADD(ADD(MUL(A, zeta_A), MUL(I_0A, x)), zeta)), MUL(I_A, t2)),
        MUL(MUL(R_A, h), x)), MUL(h_A, t1)));
}

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 59. Error / u (1 + kappa): proved -, 7.01, 1.01, 2.01,
   -, 8.51; measured 0.55. */
KERNEL void OF(peaks_far_by_x)(REAL x, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = MUL(R, h);
    const REAL t1 = MUL(A, zeta);
    const REAL t2 = TIMES(2.0, t1);
    const REAL t3 = MUL(I_0, x);
    const REAL t4 = SQUARE(A);
    const REAL t5 = DIV(d, x);
    const REAL t6 = ADD(t3, MUL(t4, t5));
    const REAL t7 = ADD(t2, t6);
    const REAL t8 = ADD(t1, t3);
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = ADD(ADD(MUL(I_, I_0), t0), MUL(t1, t7));
    out[2] = TIMES(2.0, ADD(MUL(I_, I_A), MUL(R, R_A)));
    out[3] = TIMES(4.0, ADD(MUL(I_, t8), MUL(t0, x)));
    out[4] = ADD(ADD(ADD(ADD(ADD(ADD(MUL(MUL(A, zeta_A), ADD(TIMES(4.0, t1), t6)), MUL(I_0, I_A)), MUL(I_0A,
        ADD(I_, MUL(t1, x)))), MUL(R, h_A)), MUL(R_A, h)), MUL(t2, ADD(MUL(A, t5), zeta))), MUL(t7, zeta));
    out[5] = ADD(ADD(MUL(TIMES(2.0, I_0), t8), MUL(BY_SQUARE(POINT(2.0), h), x)), MUL(t1, SUB(I_0, DIV(MUL(d, t4),
        SQUARE(x)))));
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 87. Error / u (1 + kappa): proved 1.01, 6.01,
   6.01, 8.34, 13.41, -; measured 0.58. */
KERNEL void OF(cusps_far_by_x)(REAL x, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = TIMES(2.0, d);
    const REAL x2 = SQUARE(x);
    const REAL t1 = MUL(I_0AA, x2);
    const REAL t2 = MUL(TIMES(4.0, x), zeta_A);
    const REAL t3 = TIMES(2.0, I_);
    const REAL t4 = MUL(A, zeta_AA);
    const REAL t5 = MUL(t4, x);
    const REAL t6 = MUL(R, x2);
    const REAL t7 = ADD(ADD(SQUARE(I_A), SQUARE(R_A)), MUL(h_AA, t6));
    const REAL t8 = ADD(ADD(ADD(t0, t1), t2), TIMES(2.0, t5));
    const REAL t9 = MUL(R, x);
    const REAL t10 = MUL(R_A, x);
    const REAL t11 = ADD(MUL(A, zeta), MUL(I_0, x));
    const REAL t12 = ADD(ADD(MUL(A, zeta_A), MUL(I_0A, x)), zeta);
    const REAL t13 = MUL(I_, x);
    const REAL x3 = MUL(x, x2);
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(ADD(ADD(ADD(MUL(I_, t0), MUL(I_, t1)), MUL(I_, t2)), MUL(t3, t5)), t7);
    out[2] = ADD(MUL(I_, t8), t7);
    out[3] = TIMES(2.0, ADD(ADD(ADD(MUL(I_, t12), MUL(I_A, t11)), MUL(h, t10)), MUL(h_A, t9)));
    out[4] = ADD(ADD(ADD(ADD(ADD(MUL(MUL(MUL(A, t3), x), zeta_AAA), MUL(MUL(I_, I_0AAA), x2)), MUL(TIMES(3.0,
        I_A), t8)), MUL(MUL(TIMES(3.0, R_A), h_AA), x2)), MUL(h_AAA, t6)), MUL(TIMES(6.0, t13), zeta_AA));
    out[5] = TIMES(2.0, ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(I_, t4), MUL(I_0AA, t13)), MUL(TIMES(2.0, I_A), t12)),
        MUL(MUL(h, h_AA), x3)), MUL(TIMES(2.0, h_A), t10)), MUL(h_AA, t9)), MUL(t11, t8)), MUL(t3, zeta_A)));
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 77. Error / u (1 + kappa): proved 1.01, 7.01, 8.01,
   8.34, -, 8.51; measured 0.71. */
KERNEL void OF(isolas_far_by_x)(REAL x, REAL A, REAL F_0, REAL I_0, REAL I_0A, REAL I_0AA, REAL I_0AAA, REAL zeta, REAL zeta_A, REAL zeta_AA, REAL zeta_AAA, REAL d, REAL d_3, REAL h, REAL h_A, REAL h_AA, REAL h_AAA, REAL R, REAL I_, REAL R_A, REAL I_A, REAL *out) {
    const REAL t0 = MUL(A, zeta);
    const REAL t1 = TIMES(2.0, t0);
    const REAL t2 = MUL(I_0, x);
    const REAL t3 = SQUARE(A);
    const REAL t4 = DIV(d, x);
    const REAL t5 = ADD(t2, MUL(t3, t4));
    const REAL t6 = ADD(t1, t5);
    const REAL t7 = SQUARE(x);
    const REAL t8 = TIMES(2.0, x);
    const REAL t9 = MUL(R, h_A);
    const REAL t10 = MUL(R_A, h);
    const REAL t11 = ADD(t0, t2);
    const REAL t12 = MUL(A, zeta_A);
    out[0] = ADD(MUL(I_, I_A), MUL(R, R_A));
    out[1] = ADD(ADD(MUL(I_, I_0), MUL(R, h)), MUL(t0, t6));
    out[2] = ADD(ADD(ADD(MUL(I_, ADD(ADD(ADD(MUL(MUL(A, t8), zeta_AA), MUL(I_0AA, t7)), TIMES(2.0, d)),
        MUL(TIMES(4.0, x), zeta_A))), SQUARE(I_A)), MUL(MUL(R, h_AA), t7)), SQUARE(R_A));
    out[3] = TIMES(2.0, ADD(ADD(ADD(MUL(I_, ADD(ADD(MUL(I_0A, x), t12), zeta)), MUL(I_A, t11)), MUL(t10, x)),
        MUL(t9, x)));
    out[4] = ADD(ADD(ADD(ADD(ADD(ADD(MUL(I_0, I_A), MUL(I_0A, ADD(I_, MUL(t0, x)))), MUL(t1, ADD(MUL(A, t4),
        zeta))), t10), MUL(t12, ADD(TIMES(4.0, t0), t5))), MUL(t6, zeta)), t9);
    out[5] = ADD(ADD(MUL(TIMES(2.0, I_0), t11), MUL(SQUARE(h), t8)), MUL(t0, SUB(I_0, DIV(MUL(d, t3), t7))));
}

SF_FAMILY_END
