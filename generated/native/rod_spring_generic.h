/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: on numbers of the kind REAL.

   Written by `make derive` from derivations/mechanisms/rod_spring.py; never edit.

   Included where OF makes the names of functions, and REAL, ADD, ... are what arithmetic_*.h says. */

SF_FAMILY_BEGIN

/* The |u| at which a piece of the force ends. */
KERNEL void OF(breakpoints)(const REAL *p, REAL *out) {
    const REAL u_cr = p[3];
    out[0] = u_cr;
}

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
KERNEL void OF(given)(REAL lam, REAL r, REAL delta_h, REAL *out) {
    const REAL u_cr = MUL(SQRT(delta_h), SQRT(SUB(POINT(2.0), delta_h)));
    const REAL t0 = MUL(lam, r);
    const REAL t1 = MUL(t0, SUB(delta_h, POINT(1.0)));
    const REAL delta_h2 = SQUARE(delta_h);
    const REAL delta_h3 = MUL(delta_h, delta_h2);
    out[0] = ADD(NEG(MUL(delta_h, t0)), POINT(1.0));
    out[1] = NEG(TIMES(0.5, t1));
    out[2] = NEG(TIMES(0.375, t1));
    out[3] = u_cr;
    out[4] = NEG(TIMES(0.125, MUL(MUL(MUL(delta_h3, t0), u_cr), ADD(ADD(NEG(TIMES(15.0, delta_h)), TIMES(3.0,
        delta_h2)), POINT(20.0)))));
}

/* h, h_A, h_AA, h_AAA, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
KERNEL void OF(known_passed_0)(REAL A, REAL beyond, const REAL *p, REAL *out) {
    const REAL alpha = p[0], beta = p[1], gamma = p[2];
    const REAL t0 = NEG(alpha);
    const REAL A2 = SQUARE(A);
    const REAL t1 = MUL(A2, gamma);
    const REAL t2 = TIMES(4.5, beta);
    const REAL A3 = MUL(A, A2);
    out[0] = MUL(A, ADD(MUL(A2, SUB(NEG(TIMES(0.75, beta)), TIMES(0.625, t1))), t0));
    out[1] = ADD(MUL(A2, SUB(NEG(TIMES(2.25, beta)), TIMES(3.125, t1))), t0);
    out[2] = MUL(A, SUB(NEG(TIMES(12.5, t1)), t2));
    out[3] = SUB(NEG(TIMES(37.5, t1)), t2);
    out[4] = MUL(A3, ADD(TIMES(1.5, beta), TIMES(2.5, t1)));
}

KERNEL void OF(known_passed_1)(REAL A, REAL beyond, const REAL *p, REAL *out) {
    const REAL alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3], jump_1 = p[4];
    const REAL root = MUL(SQRT(beyond), SQRT(ADD(A, u_cr)));
    const REAL t0 = INVERSE(A);
    const REAL x = MUL(t0, u_cr);
    const REAL y = MUL(root, t0);
    const REAL psi_0 = ATAN2(root, u_cr);
    const REAL theta = ATAN2_SWAPPED(root, u_cr);
    const REAL t1 = MUL(x, y);
    const REAL t2 = TIMES(0.5, t1);
    const REAL M2 = ADD(NEG(t2), TIMES(0.5, theta));
    const REAL t3 = SQUARE(x);
    const REAL M4 = ADD(NEG(MUL(t1, ADD(TIMES(0.25, t3), POINT(0.375)))), TIMES(0.375, theta));
    const REAL M6 = ADD(NEG(MUL(t1, ADD(MUL(t3, ADD(MUL(CONSTANT(0.16666666666666666, 9.2518585385429707e-18),
        t3), CONSTANT(0.20833333333333334, -9.2518585385429707e-18))), POINT(0.3125)))), TIMES(0.3125, theta));
    const REAL S2_2 = ADD(TIMES(0.5, psi_0), t2);
    const REAL A2 = SQUARE(A);
    const REAL t4 = MUL(M4, beta);
    const REAL A4 = SQUARE(A2);
    const REAL t5 = MUL(M6, gamma);
    const REAL t6 = MUL(A4, t5);
    const REAL t7 = ADD(MUL(M2, alpha), S2_2);
    const REAL t8 = TIMES(3.0, beta);
    const REAL t9 = INVERSE(A2);
    const REAL t10 = INVERSE(root);
    const REAL u_cr2 = SQUARE(u_cr);
    const REAL t11 = TIMES(6.0, t4);
    const REAL A3 = MUL(A, A2);
    const REAL t12 = MUL(jump_1, u_cr2);
    const REAL root2 = SQUARE(root);
    const REAL root3 = MUL(root, root2);
    const REAL t13 = INVERSE(root3);
    const REAL t14 = MUL(t12, t13);
    const REAL t15 = DIV(t10, A3);
    const REAL t16 = MUL(gamma, u_cr2);
    const REAL u_cr3 = MUL(u_cr, u_cr2);
    const REAL t17 = MUL(u_cr3, ADD(SUB(NEG(alpha), MUL(u_cr2, ADD(TIMES(5.0, t16), t8))), POINT(1.0)));
    const REAL t18 = INVERSE(A4);
    const REAL t19 = MUL(t10, t12);
    const REAL t20 = MUL(t10, t18);
    const REAL u_cr4 = SQUARE(u_cr2);
    const REAL u_cr5 = MUL(u_cr, u_cr4);
    const REAL A5 = MUL(A, A4);
    out[0] = NEG(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), MUL(A, ADD(ADD(MUL(A2, t4), t6),
        t7))));
    out[1] = MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), SUB(SUB(ADD(NEG(MUL(MUL(A2, M4), t8)),
        MUL(MUL(MUL(jump_1, t10), t9), u_cr2)), TIMES(5.0, t6)), t7));
    out[2] = NEG(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), ADD(ADD(ADD(ADD(MUL(A, t11),
        TIMES(20.0, MUL(A3, t5))), MUL(t0, t14)), TIMES(2.0, MUL(t12, t15))), MUL(t15, t17))));
    out[3] = MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17),
        ADD(ADD(ADD(ADD(ADD(ADD(SUB(NEG(TIMES(60.0, MUL(A2, t5))), t11), MUL(MUL(t12, t13), t9)), MUL(MUL(t13, t17),
        t9)), MUL(t14, ADD(TIMES(2.0, t9), DIV(POINT(3.0), root2)))), TIMES(3.0, MUL(t17, t20))), TIMES(6.0,
        MUL(t18, t19))), TIMES(2.0, MUL(MUL(t20, u_cr5), ADD(TIMES(10.0, t16), t8)))));
    out[4] = MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), SUB(ADD(TIMES(2.0, MUL(A3, t4)),
        TIMES(4.0, MUL(A5, t5))), MUL(t0, t19)));
}

KERNEL void OF(known_passed_1_far_1)(REAL A, REAL beyond, const REAL *p, REAL *out) {
    const REAL alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3], jump_1 = p[4];
    const REAL root = MUL(SQRT(beyond), SQRT(ADD(A, u_cr)));
    const REAL t0 = INVERSE(A);
    const REAL x = MUL(t0, u_cr);
    const REAL y = MUL(root, t0);
    const REAL s = DIV(x, SQRT(ADD(TIMES(2.0, y), POINT(2.0))));
    const REAL s2 = SQUARE(s);
    const REAL s4 = SQUARE(s2);
    const REAL s3 = MUL(s, s2);
    const REAL s6 = SQUARE(s3);
    const REAL s7 = MUL(s, s6);
    const REAL M6 = WITHIN(MUL(s7, ADD(ADD(MUL(s2, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4,
        SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4,
        SUB(NEG(MUL(CONSTANT(3.6492503041747691e-05, -2.8531636118039589e-21), s4)),
        CONSTANT(5.3427095924732542e-05, -2.8127886550331484e-21))), CONSTANT(8.10560684803189e-05,
        6.3613902977465824e-21))), CONSTANT(0.00012837971250216165, 9.0350181040458698e-21))),
        CONSTANT(0.00021441317186122989, -1.3221977713237859e-20))), CONSTANT(0.00038296467549092059,
        1.6116518780189932e-20))), CONSTANT(0.000746755888967803, 2.6283689029951623e-20))),
        CONSTANT(0.0016416352370689656, -8.2249819981658953e-20))), CONSTANT(0.0042968750000000003,
        -3.4694469519536144e-19))), CONSTANT(0.01488095238095238, 8.2605879808419381e-19))),
        CONSTANT(0.088235294117647065, -5.7143832149824231e-18))), CONSTANT(3.0769230769230771,
        -1.7080354225002409e-16))), CONSTANT(35.555555555555557, -1.578983857244667e-15))), MUL(s4, ADD(MUL(s4,
        SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4, SUB(MUL(s4,
        SUB(NEG(MUL(CONSTANT(4.3976166456228718e-05, -3.0801198081974557e-21), s4)),
        CONSTANT(6.5487812903216656e-05, 7.9720747976875325e-22))), CONSTANT(0.00010140631546048408,
        -2.3068131329478817e-21))), CONSTANT(0.00016468815332235291, 1.1976651905363131e-20))),
        CONSTANT(0.00028384801668998523, -6.9500139261891304e-21))), CONSTANT(0.00052806309291294638,
        4.6465807392235902e-20))), CONSTANT(0.0010878039944556453, -9.0933085434268117e-20))),
        CONSTANT(0.0025860821759259261, -2.0880930729350455e-19))), CONSTANT(0.007642663043478261,
        -1.1313413973761785e-19))), CONSTANT(0.032894736842105261, 1.8260247115545337e-18))),
        CONSTANT(0.33333333333333331, 1.8503717077085941e-17))), CONSTANT(21.818181818181817,
        1.6148698540002276e-15)))), CONSTANT(18.285714285714285, 1.0150610510858574e-15))), 8.6736173798840355e-18);
    const REAL x2 = SQUARE(x);
    const REAL x4 = SQUARE(x2);
    const REAL x5 = MUL(x, x4);
    const REAL M4 = ADD(MUL(CONSTANT(1.2, 4.4408920985006264e-17), M6), MUL(CONSTANT(0.20000000000000001,
        -1.1102230246251566e-17), MUL(x5, y)));
    const REAL x3 = MUL(x, x2);
    const REAL M2 = ADD(MUL(CONSTANT(1.3333333333333333, 7.4014868308343765e-17), M4),
        MUL(CONSTANT(0.33333333333333331, 1.8503717077085941e-17), MUL(x3, y)));
    const REAL S2_2 = ADD(NEG(M2), CONSTANT(0.78539816339744828, 3.061616997868383e-17));
    const REAL A2 = SQUARE(A);
    const REAL t1 = MUL(M4, beta);
    const REAL A4 = SQUARE(A2);
    const REAL t2 = MUL(M6, gamma);
    const REAL t3 = MUL(A4, t2);
    const REAL t4 = ADD(MUL(M2, alpha), S2_2);
    const REAL t5 = TIMES(3.0, beta);
    const REAL t6 = INVERSE(A2);
    const REAL t7 = INVERSE(root);
    const REAL u_cr2 = SQUARE(u_cr);
    const REAL t8 = TIMES(6.0, t1);
    const REAL A3 = MUL(A, A2);
    const REAL t9 = MUL(jump_1, u_cr2);
    const REAL root2 = SQUARE(root);
    const REAL root3 = MUL(root, root2);
    const REAL t10 = INVERSE(root3);
    const REAL t11 = MUL(t10, t9);
    const REAL t12 = DIV(t7, A3);
    const REAL t13 = MUL(gamma, u_cr2);
    const REAL u_cr3 = MUL(u_cr, u_cr2);
    const REAL t14 = MUL(u_cr3, ADD(SUB(NEG(alpha), MUL(u_cr2, ADD(TIMES(5.0, t13), t5))), POINT(1.0)));
    const REAL t15 = INVERSE(A4);
    const REAL t16 = MUL(t7, t9);
    const REAL t17 = MUL(t15, t7);
    const REAL u_cr4 = SQUARE(u_cr2);
    const REAL u_cr5 = MUL(u_cr, u_cr4);
    const REAL A5 = MUL(A, A4);
    out[0] = NEG(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), MUL(A, ADD(ADD(MUL(A2, t1), t3),
        t4))));
    out[1] = MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), SUB(SUB(ADD(NEG(MUL(MUL(A2, M4), t5)),
        MUL(MUL(MUL(jump_1, t6), t7), u_cr2)), TIMES(5.0, t3)), t4));
    out[2] = NEG(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), ADD(ADD(ADD(ADD(MUL(A, t8),
        TIMES(20.0, MUL(A3, t2))), MUL(t0, t11)), MUL(t12, t14)), TIMES(2.0, MUL(t12, t9)))));
    out[3] = MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17),
        SUB(ADD(ADD(ADD(ADD(ADD(ADD(NEG(TIMES(60.0, MUL(A2, t2))), MUL(MUL(t10, t14), t6)), MUL(MUL(t10, t6), t9)),
        MUL(t11, ADD(TIMES(2.0, t6), DIV(POINT(3.0), root2)))), TIMES(3.0, MUL(t14, t17))), TIMES(6.0, MUL(t15,
        t16))), TIMES(2.0, MUL(MUL(t17, u_cr5), ADD(TIMES(10.0, t13), t5)))), t8));
    out[4] = MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), SUB(ADD(TIMES(2.0, MUL(A3, t1)),
        TIMES(4.0, MUL(A5, t2))), MUL(t0, t16)));
}

SF_FAMILY_END
