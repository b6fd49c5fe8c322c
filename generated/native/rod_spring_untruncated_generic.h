/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: on numbers of the kind REAL.

   Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
   never edit.

   Included where OF makes the names of functions, and REAL, ADD, ... are what arithmetic_*.h says. */

SF_FAMILY_BEGIN

/* Steps of the arithmetic-geometric mean, with the sum of its differences and that of their squares by weight. */
SF_COMMON void OF(means)(REAL quarter, int turns, REAL *state) {
    SF_UNROLLED
    for (int turn = 0; turn < turns; turn++) {
        const REAL a = state[0], b = state[1], e = state[2], total = state[3], squares = state[4];
        const REAL mean = ADD(TIMES(0.5, a), TIMES(0.5, b));
        const REAL difference = DIV(MUL(SQUARE(e), quarter), mean);
        state[0] = mean;
        state[1] = MUL(SQRT(a), SQRT(b));
        state[2] = difference;
        state[3] = ADD(difference, total);
        state[4] = ADD(SQUARE(difference), TIMES(0.5, squares));
    }
}

/* The |u| at which a piece of the force ends. */
KERNEL void OF(breakpoints)(const REAL *p, REAL *out) {
    const REAL delta_h = p[2];
    out[0] = SQRT(ADD(NEG(SQUARE(delta_h)), TIMES(2.0, delta_h)));
}

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
KERNEL void OF(given)(REAL lam, REAL r, REAL delta_h, REAL *out) {
    const REAL t0 = MUL(lam, r);
    out[0] = ADD(NEG(MUL(delta_h, t0)), POINT(1.0));
    out[1] = NEG(TIMES(0.5, MUL(t0, SUB(delta_h, POINT(1.0)))));
    out[2] = delta_h;
    out[3] = POINT(0.0);
}

/* What the slope of the force loses at each breakpoint.
   Equation (5). Domain: any parameters. */
KERNEL void OF(kinks)(const REAL *p, REAL *out) {
    const REAL alpha = p[0], beta = p[1], delta_h = p[2];
    const REAL u_cr = SQRT(ADD(NEG(SQUARE(delta_h)), TIMES(2.0, delta_h)));
    const REAL c = SUB(POINT(1.0), delta_h);
    const REAL t0 = TIMES(2.0, beta);
    const REAL c2 = SQUARE(c);
    const REAL c3 = MUL(c, c2);
    out[0] = ADD(ADD(SUB(SUB(alpha, t0), POINT(1.0)), DIV(MUL(t0, SQUARE(u_cr)), c3)), DIV(t0, c));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together. Where A does not exceed the breakpoint, nor 7/10.
   Equation (20)-(22), (31). Domain: A >= 0. */
KERNEL void OF(attached)(REAL A, const REAL *p, REAL *out) {
    const REAL alpha = p[0], beta = p[1];
    const REAL m = SQUARE(A);
    const REAL t0 = ADD(A, POINT(1.0));
    const REAL t1 = SUB(POINT(1.0), A);
    const REAL k_c = MUL(SQRT(t0), SQRT(t1));
    const REAL k = MUL(t0, t1);
    const REAL a_1 = ADD(TIMES(0.5, k_c), POINT(0.5));
    const REAL b_1 = SQRT(k_c);
    const REAL e_1 = DIV(POINT(0.25), a_1);
    const REAL square = SQUARE(e_1);
    const REAL quarter = TIMES(0.25, m);
    REAL means[] = {a_1, b_1, e_1, e_1, square};
    OF(means)(quarter, 3, means);
    const REAL a_4 = means[0], b_4 = means[1], e_4 = means[2], total = means[3], squares = means[4];
    const REAL a_5 = WITHIN(ADD(TIMES(0.5, a_4), TIMES(0.5, b_4)), 8.6736173798840355e-19);
    const REAL t2 = INVERSE(a_5);
    const REAL e_5 = MUL(MUL(SQUARE(e_4), quarter), t2);
    const REAL e = WITHIN(ADD(e_5, total), 8.6736173798840355e-19);
    const REAL tau = WITHIN(ADD(TIMES(32.0, SQUARE(e_5)), TIMES(16.0, squares)), 8.6736173798840355e-19);
    const REAL P = MUL(MUL(m, t2), ADD(e, tau));
    const REAL B = MUL(t2, ADD(NEG(MUL(m, tau)), POINT(1.0)));
    const REAL C = TIMES(2.0, MUL(t2, tau));
    const REAL t3 = TIMES(2.0, beta);
    const REAL t4 = MUL(A, t3);
    const REAL t5 = INVERSE(k);
    const REAL t6 = MUL(B, t5);
    const REAL k2 = SQUARE(k);
    const REAL t7 = INVERSE(k2);
    const REAL k3 = MUL(k, k2);
    out[0] = SUB(NEG(MUL(A, alpha)), MUL(P, t4));
    out[1] = SUB(NEG(alpha), MUL(t3, ADD(ADD(NEG(MUL(C, m)), P), MUL(m, t6))));
    out[2] = NEG(MUL(t4, ADD(TIMES(2.0, MUL(B, t7)), MUL(C, t5))));
    out[3] = NEG(MUL(t3, ADD(DIV(MUL(B, ADD(TIMES(5.0, m), POINT(3.0))), k3), MUL(MUL(C, t7), SUB(TIMES(7.0, m),
        POINT(3.0))))));
    out[4] = TIMES(4.0, MUL(MUL(MUL(A, beta), m), ADD(NEG(TIMES(0.5, C)), TIMES(0.5, t6))));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together. Where A does not exceed the breakpoint.
   Equation (20)-(22), (31). Domain: A >= 0. */
KERNEL void OF(attached_steep)(REAL A, const REAL *p, REAL *out) {
    const REAL alpha = p[0], beta = p[1];
    const REAL m = SQUARE(A);
    const REAL t0 = ADD(A, POINT(1.0));
    const REAL t1 = SUB(POINT(1.0), A);
    const REAL k_c = MUL(SQRT(t0), SQRT(t1));
    const REAL k = MUL(t0, t1);
    const REAL a_1 = ADD(TIMES(0.5, k_c), POINT(0.5));
    const REAL b_1 = SQRT(k_c);
    const REAL e_1 = DIV(POINT(0.25), a_1);
    const REAL square = SQUARE(e_1);
    const REAL quarter = TIMES(0.25, m);
    REAL means[] = {a_1, b_1, e_1, e_1, square};
    OF(means)(quarter, 8, means);
    const REAL a_9 = means[0], b_9 = means[1], e_9 = means[2], total = means[3], squares = means[4];
    const REAL a_10 = WITHIN(ADD(TIMES(0.5, a_9), TIMES(0.5, b_9)), 8.6736173798840355e-19);
    const REAL t2 = INVERSE(a_10);
    const REAL e_10 = MUL(MUL(SQUARE(e_9), quarter), t2);
    const REAL e = WITHIN(ADD(e_10, total), 8.6736173798840355e-19);
    const REAL tau = WITHIN(ADD(TIMES(1024.0, SQUARE(e_10)), TIMES(512.0, squares)), 8.6736173798840355e-19);
    const REAL P = MUL(MUL(m, t2), ADD(e, tau));
    const REAL B = MUL(t2, ADD(NEG(MUL(m, tau)), POINT(1.0)));
    const REAL C = TIMES(2.0, MUL(t2, tau));
    const REAL t3 = TIMES(2.0, beta);
    const REAL t4 = MUL(A, t3);
    const REAL t5 = INVERSE(k);
    const REAL t6 = MUL(B, t5);
    const REAL k2 = SQUARE(k);
    const REAL t7 = INVERSE(k2);
    const REAL k3 = MUL(k, k2);
    out[0] = SUB(NEG(MUL(A, alpha)), MUL(P, t4));
    out[1] = SUB(NEG(alpha), MUL(t3, ADD(ADD(NEG(MUL(C, m)), P), MUL(m, t6))));
    out[2] = NEG(MUL(t4, ADD(TIMES(2.0, MUL(B, t7)), MUL(C, t5))));
    out[3] = NEG(MUL(t3, ADD(DIV(MUL(B, ADD(TIMES(5.0, m), POINT(3.0))), k3), MUL(MUL(C, t7), SUB(TIMES(7.0, m),
        POINT(3.0))))));
    out[4] = TIMES(4.0, MUL(MUL(MUL(A, beta), m), ADD(NEG(TIMES(0.5, C)), TIMES(0.5, t6))));
}

/* The same where it does, from the parts.
   Equation (20)-(22), (31). Domain: A >= 0. */
KERNEL void OF(detached)(REAL A, REAL part_0, REAL part_1, REAL part_2, REAL part_3, REAL part_4, const REAL *p, REAL *out) {
    const REAL beta = p[1];
    const REAL t0 = TIMES(2.0, beta);
    out[0] = ADD(NEG(A), TIMES(2.0, MUL(beta, part_0)));
    out[1] = SUB(MUL(part_1, t0), POINT(1.0));
    out[2] = MUL(part_2, t0);
    out[3] = MUL(part_3, t0);
    out[4] = MUL(part_4, t0);
}

SF_FAMILY_END
