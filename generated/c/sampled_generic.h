/* The average of a force that is known by its values and those of its derivatives, u = A sine: on numbers of the kind REAL.

   Written by `make derive` from derivations/forces/quadrature.py, derivations/forces/sampled.py; never edit.

   Included where OF makes the names of functions, and REAL, ADD, ... are what arithmetic_*.h says. Rounding errors
   are those of doubles, see sampled.h. */

/* Under the integrals of h and h_AAAA.
   Equation (20), (31). Domain: any. Operations: 7. Error / u (1 + kappa): measured 0.77. */
KERNEL void OF(bent_terms)(REAL sine, REAL f, REAL f_uuuu, REAL *out) {
    const REAL sine2 = SQUARE(sine);
    const REAL sine4 = SQUARE(sine2);
    const REAL sine5 = MUL(sine, sine4);
    out[0] = NEG(MUL(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), f), sine));
    out[1] = NEG(MUL(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), f_uuuu), sine5));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 0 are the first to be lost.
   Equation (31). Domain: A > b > 0. Operations: 56. Error / u (1 + kappa): measured 1.2. */
KERNEL REAL OF(bent_end_0)(REAL A, REAL b, REAL lost_0, REAL lost_1, REAL lost_2, REAL lost_3) {
    const REAL root = MUL(SQRT(SUB(A, b)), SQRT(ADD(A, b)));
    const REAL A2 = SQUARE(A);
    const REAL A4 = SQUARE(A2);
    const REAL A5 = MUL(A, A4);
    const REAL t0 = INVERSE(A5);
    const REAL root2 = SQUARE(root);
    const REAL root4 = SQUARE(root2);
    const REAL t1 = TIMES(3.0, A4);
    const REAL root3 = MUL(root, root2);
    const REAL root6 = SQUARE(root3);
    const REAL root7 = MUL(root, root6);
    const REAL b2 = SQUARE(b);
    const REAL b4 = SQUARE(b2);
    const REAL b5 = MUL(b, b4);
    const REAL b3 = MUL(b, b2);
    const REAL A3 = MUL(A, A2);
    const REAL A6 = SQUARE(A3);
    return NEG(DIV(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), ADD(MUL(MUL(MUL(TIMES(3.0, b2),
        lost_0), t0), ADD(ADD(ADD(MUL(TIMES(4.0, A2), root4), TIMES(5.0, A6)), MUL(root2, t1)), TIMES(8.0, root6))),
        MUL(root2, ADD(NEG(MUL(MUL(MUL(b3, lost_1), t0), ADD(ADD(MUL(TIMES(5.0, A2), root2), TIMES(12.0, root4)),
        t1))), MUL(root2, SUB(MUL(MUL(MUL(b4, lost_2), t0), ADD(A2, TIMES(4.0, root2))), MUL(MUL(MUL(b5, lost_3),
        root2), t0))))))), root7));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 1 are the first to be lost.
   Equation (31). Domain: A > b > 0. Operations: 38. Error / u (1 + kappa): measured 0.76. */
KERNEL REAL OF(bent_end_1)(REAL A, REAL b, REAL lost_1, REAL lost_2, REAL lost_3) {
    const REAL root = MUL(SQRT(SUB(A, b)), SQRT(ADD(A, b)));
    const REAL A2 = SQUARE(A);
    const REAL A4 = SQUARE(A2);
    const REAL A5 = MUL(A, A4);
    const REAL t0 = INVERSE(A5);
    const REAL root2 = SQUARE(root);
    const REAL root4 = SQUARE(root2);
    const REAL root5 = MUL(root, root4);
    const REAL b2 = SQUARE(b);
    const REAL b4 = SQUARE(b2);
    const REAL b5 = MUL(b, b4);
    const REAL b3 = MUL(b, b2);
    return NEG(DIV(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), ADD(NEG(MUL(MUL(MUL(b3, lost_1),
        t0), ADD(ADD(MUL(TIMES(5.0, A2), root2), TIMES(3.0, A4)), TIMES(12.0, root4)))), MUL(root2,
        SUB(MUL(MUL(MUL(b4, lost_2), t0), ADD(A2, TIMES(4.0, root2))), MUL(MUL(MUL(b5, lost_3), root2), t0))))),
        root5));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 2 are the first to be lost.
   Equation (31). Domain: A > b > 0. Operations: 25. Error / u (1 + kappa): measured 1.2. */
KERNEL REAL OF(bent_end_2)(REAL A, REAL b, REAL lost_2, REAL lost_3) {
    const REAL root = MUL(SQRT(SUB(A, b)), SQRT(ADD(A, b)));
    const REAL A2 = SQUARE(A);
    const REAL A4 = SQUARE(A2);
    const REAL A5 = MUL(A, A4);
    const REAL t0 = INVERSE(A5);
    const REAL root2 = SQUARE(root);
    const REAL root3 = MUL(root, root2);
    const REAL b2 = SQUARE(b);
    const REAL b4 = SQUARE(b2);
    const REAL b5 = MUL(b, b4);
    return NEG(DIV(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), SUB(MUL(MUL(MUL(b4, lost_2), t0),
        ADD(A2, TIMES(4.0, root2))), MUL(MUL(MUL(b5, lost_3), root2), t0))), root3));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 3 are the first to be lost.
   Equation (31). Domain: A > b > 0. Operations: 15. Error / u (1 + kappa): measured 0.65. */
KERNEL REAL OF(bent_end_3)(REAL A, REAL b, REAL lost_3) {
    const REAL root = MUL(SQRT(SUB(A, b)), SQRT(ADD(A, b)));
    const REAL A2 = SQUARE(A);
    const REAL A4 = SQUARE(A2);
    const REAL A5 = MUL(A, A4);
    const REAL b2 = SQUARE(b);
    const REAL b4 = SQUARE(b2);
    const REAL b5 = MUL(b, b4);
    return DIV(MUL(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), b5), lost_3), MUL(A5, root));
}
