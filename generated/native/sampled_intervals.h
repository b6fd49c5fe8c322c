/* The average of a force that is known by its values and those of its derivatives, u = A sine: on whole intervals.

   Written by `make derive` from derivations/forces/quadrature.py, derivations/forces/sampled.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of sampled.h. */

#ifndef SAMPLED_INTERVALS_H
#define SAMPLED_INTERVALS_H

#include "interval.h"
#include "arithmetic_intervals.h"

/* Under the integrals of h and h_AAAA. */
static inline void sampled_intervals_bent_terms(sf_interval sine, sf_interval f, sf_interval f_uuuu, sf_interval *out)
{
    const sf_interval sine2 = SQUARE(sine);
    const sf_interval sine4 = SQUARE(sine2);
    const sf_interval sine5 = MUL(sine, sine4);
    out[0] = NEG(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), MUL(f, sine)));
    out[1] = NEG(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), MUL(f_uuuu, sine5)));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 0 are the first to be lost. */
static inline sf_interval sampled_intervals_bent_end_0(sf_interval A, sf_interval b, sf_interval lost_0, sf_interval lost_1, sf_interval lost_2, sf_interval lost_3)
{
    const sf_interval root = MUL(SQRT(SUB(A, b)), SQRT(ADD(A, b)));
    const sf_interval A2 = SQUARE(A);
    const sf_interval A4 = SQUARE(A2);
    const sf_interval A5 = MUL(A, A4);
    const sf_interval t0 = INVERSE(A5);
    const sf_interval root2 = SQUARE(root);
    const sf_interval root4 = SQUARE(root2);
    const sf_interval t1 = TIMES(3.0, A4);
    const sf_interval root3 = MUL(root, root2);
    const sf_interval root6 = SQUARE(root3);
    const sf_interval root7 = MUL(root, root6);
    const sf_interval b2 = SQUARE(b);
    const sf_interval b4 = SQUARE(b2);
    const sf_interval b5 = MUL(b, b4);
    const sf_interval b3 = MUL(b, b2);
    const sf_interval A3 = MUL(A, A2);
    const sf_interval A6 = SQUARE(A3);
    return NEG(DIV(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), ADD(TIMES(3.0, MUL(MUL(MUL(b2,
        lost_0), t0), ADD(ADD(ADD(TIMES(4.0, MUL(A2, root4)), TIMES(5.0, A6)), MUL(root2, t1)), TIMES(8.0,
        root6)))), MUL(root2, ADD(NEG(MUL(MUL(MUL(b3, lost_1), t0), ADD(ADD(TIMES(5.0, MUL(A2, root2)), TIMES(12.0,
        root4)), t1))), MUL(root2, SUB(MUL(MUL(MUL(b4, lost_2), t0), ADD(A2, TIMES(4.0, root2))), MUL(MUL(MUL(b5,
        lost_3), root2), t0))))))), root7));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 1 are the first to be lost. */
static inline sf_interval sampled_intervals_bent_end_1(sf_interval A, sf_interval b, sf_interval lost_1, sf_interval lost_2, sf_interval lost_3)
{
    const sf_interval root = MUL(SQRT(SUB(A, b)), SQRT(ADD(A, b)));
    const sf_interval A2 = SQUARE(A);
    const sf_interval A4 = SQUARE(A2);
    const sf_interval A5 = MUL(A, A4);
    const sf_interval t0 = INVERSE(A5);
    const sf_interval root2 = SQUARE(root);
    const sf_interval root4 = SQUARE(root2);
    const sf_interval root5 = MUL(root, root4);
    const sf_interval b2 = SQUARE(b);
    const sf_interval b4 = SQUARE(b2);
    const sf_interval b5 = MUL(b, b4);
    const sf_interval b3 = MUL(b, b2);
    return NEG(DIV(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), ADD(NEG(MUL(MUL(MUL(b3, lost_1),
        t0), ADD(ADD(TIMES(5.0, MUL(A2, root2)), TIMES(3.0, A4)), TIMES(12.0, root4)))), MUL(root2,
        SUB(MUL(MUL(MUL(b4, lost_2), t0), ADD(A2, TIMES(4.0, root2))), MUL(MUL(MUL(b5, lost_3), root2), t0))))),
        root5));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 2 are the first to be lost. */
static inline sf_interval sampled_intervals_bent_end_2(sf_interval A, sf_interval b, sf_interval lost_2, sf_interval lost_3)
{
    const sf_interval root = MUL(SQRT(SUB(A, b)), SQRT(ADD(A, b)));
    const sf_interval A2 = SQUARE(A);
    const sf_interval A4 = SQUARE(A2);
    const sf_interval A5 = MUL(A, A4);
    const sf_interval t0 = INVERSE(A5);
    const sf_interval root2 = SQUARE(root);
    const sf_interval root3 = MUL(root, root2);
    const sf_interval b2 = SQUARE(b);
    const sf_interval b4 = SQUARE(b2);
    const sf_interval b5 = MUL(b, b4);
    return NEG(DIV(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), SUB(MUL(MUL(MUL(b4, lost_2), t0),
        ADD(A2, TIMES(4.0, root2))), MUL(MUL(MUL(b5, lost_3), root2), t0))), root3));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 3 are the first to be lost. */
static inline sf_interval sampled_intervals_bent_end_3(sf_interval A, sf_interval b, sf_interval lost_3)
{
    const sf_interval root = MUL(SQRT(SUB(A, b)), SQRT(ADD(A, b)));
    const sf_interval A2 = SQUARE(A);
    const sf_interval A4 = SQUARE(A2);
    const sf_interval A5 = MUL(A, A4);
    const sf_interval b2 = SQUARE(b);
    const sf_interval b4 = SQUARE(b2);
    const sf_interval b5 = MUL(b, b4);
    return DIV(MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), MUL(b5, lost_3)), MUL(A5, root));
}

#include "arithmetic_end.h"
#endif
