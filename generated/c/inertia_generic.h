/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance: on numbers of the kind REAL.

   Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/paper/averaging.py,
   derivations/paper/slow_flow.py, derivations/extensions/inertia.py; never edit.

   Included where OF makes the names of functions, and REAL, ADD, ... are what arithmetic_*.h says. Rounding errors
   are those of doubles, see inertia.h. */

/* What the least level of an amplitude follows from; it has one where the first, fall, is positive.
   Equation from (24). Domain: A > 0. Operations: 11. Error / u (1 + kappa): proved 1.61, 0.76, 0.67. */
KERNEL void OF(terms)(REAL A, REAL m, REAL zeta, REAL h, REAL *out) {
    out[0] = NEG(MUL(A, ADD(BY_SQUARE(TIMES(2.0, A), zeta), h)));
    out[1] = MUL(MUL(TIMES(12.0, A), m), zeta);
    out[2] = ADD(SQUARE(h), SQUARE(m));
}

/* The least level of an amplitude less F_0, and its slope along A.
   Equation from (24). Domain: x of `least`, h < 0. Operations: 19. Error / u (1 + kappa): measured 0.87. */
KERNEL void OF(peak)(REAL x, REAL A, REAL F_0, REAL m, REAL zeta, REAL h, REAL h_A, REAL *out) {
    const REAL t0 = MUL(A, zeta);
    const REAL t1 = MUL(m, x);
    const REAL drag = ADD(t0, t1);
    const REAL share = DIV(drag, h);
    const REAL t2 = SQUARE(x);
    const REAL root = SQRT(ADD(SQUARE(share), t2));
    out[0] = ADD(NEG(F_0), MUL(root, ADD(TIMES(2.0, t0), t1)));
    out[1] = DIV(ADD(NEG(MUL(share, ADD(MUL(h_A, t2), POINT(1.0)))), MUL(TIMES(2.0, t2), zeta)), root);
}

/* Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A.
   Equation from (24), (30). Domain: x of `least`, h < 0. Operations: 50. Error / u (1 + kappa): measured 1.2. */
KERNEL void OF(isola)(REAL x, REAL A, REAL m, REAL zeta, REAL h, REAL h_A, REAL h_AA, REAL *out) {
    const REAL t0 = MUL(A, zeta);
    const REAL t1 = MUL(m, x);
    const REAL t2 = ADD(t0, t1);
    const REAL t3 = SQUARE(x);
    const REAL t4 = MUL(h, t3);
    const REAL t5 = TIMES(2.0, zeta);
    const REAL t6 = MUL(h_A, t3);
    const REAL t7 = ADD(t6, POINT(1.0));
    const REAL t8 = TIMES(8.0, x);
    const REAL t9 = TIMES(4.0, h);
    out[0] = SUB(MUL(t2, t7), MUL(t4, t5));
    out[1] = ADD(ADD(SUB(MUL(MUL(h_AA, t2), t3), MUL(t5, t6)), MUL(t7, zeta)), DIV(MUL(SUB(ADD(MUL(MUL(TIMES(2.0,
        h_A), t2), x), MUL(m, t7)), MUL(MUL(t9, x), zeta)), ADD(ADD(SUB(BY_SQUARE(TIMES(16.0, A), zeta), MUL(h_A,
        SUB(NEG(TIMES(4.0, A)), TIMES(8.0, t4)))), MUL(TIMES(12.0, t1), zeta)), t9)), SUB(SUB(NEG(MUL(SQUARE(h),
        t8)), MUL(SQUARE(m), t8)), MUL(TIMES(12.0, m), t0))));
}

/* The same without its slope by k = h - A h_A and cubic = 3 h - A h_A, small where h is like A^3.
   Equation from (24), (30). Domain: x of `least`, h < 0. Operations: 17. Error / u (1 + kappa): measured 1.1. */
KERNEL REAL OF(isola_apart)(REAL x, REAL A, REAL m, REAL zeta, REAL h, REAL k, REAL cubic) {
    const REAL t0 = MUL(A, zeta);
    const REAL t1 = MUL(m, x);
    const REAL drag = ADD(t0, t1);
    const REAL x2 = SQUARE(x);
    const REAL x3 = MUL(x, x2);
    return DIV(SUB(ADD(NEG(MUL(MUL(cubic, t0), x2)), DIV(MUL(SQUARE(drag), SUB(NEG(TIMES(2.0, t0)), t1)), h)),
        MUL(MUL(k, m), x3)), A);
}
