/* The average of a force that is known by its values and those of its derivatives, u = A sine: on whole intervals.

   Written by `make derive` from derivations/forces/quadrature.py, derivations/forces/sampled.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of sampled.h. */

#ifndef SAMPLED_INTERVALS_H
#define SAMPLED_INTERVALS_H

#include "interval.h"

/* Under the integrals of h and h_AAAA. */
static inline void sampled_intervals_bent_terms(sf_interval sine, sf_interval f, sf_interval f_uuuu, sf_interval *out)
{
    const sf_interval sine2 = sfi_square(sine);
    const sf_interval sine4 = sfi_square(sine2);
    const sf_interval sine5 = sfi_mul(sine, sine4);
    out[0] = sfi_neg(sfi_mul(sfi_around(1.2732395447351628), sfi_mul(f, sine)));
    out[1] = sfi_neg(sfi_mul(sfi_around(1.2732395447351628), sfi_mul(f_uuuu, sine5)));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 0 are the first to be lost. */
static inline sf_interval sampled_intervals_bent_end_0(sf_interval A, sf_interval b, sf_interval lost_0, sf_interval lost_1, sf_interval lost_2, sf_interval lost_3)
{
    const sf_interval root = sfi_mul(sfi_sqrt(sfi_sub(A, b)), sfi_sqrt(sfi_add(A, b)));
    const sf_interval A2 = sfi_square(A);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval A5 = sfi_mul(A, A4);
    const sf_interval t0 = sfi_inverse(A5);
    const sf_interval root2 = sfi_square(root);
    const sf_interval root4 = sfi_square(root2);
    const sf_interval t1 = sfi_times(3.0, A4);
    const sf_interval root3 = sfi_mul(root, root2);
    const sf_interval root6 = sfi_square(root3);
    const sf_interval root7 = sfi_mul(root, root6);
    const sf_interval b2 = sfi_square(b);
    const sf_interval b4 = sfi_square(b2);
    const sf_interval b5 = sfi_mul(b, b4);
    const sf_interval b3 = sfi_mul(b, b2);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval A6 = sfi_square(A3);
    return sfi_neg(sfi_div(sfi_mul(sfi_around(1.2732395447351628), sfi_add(sfi_times(3.0,
        sfi_mul(sfi_mul(sfi_mul(b2, lost_0), t0), sfi_add(sfi_add(sfi_add(sfi_times(4.0, sfi_mul(A2, root4)),
        sfi_times(5.0, A6)), sfi_mul(root2, t1)), sfi_times(8.0, root6)))), sfi_mul(root2,
        sfi_add(sfi_neg(sfi_mul(sfi_mul(sfi_mul(b3, lost_1), t0), sfi_add(sfi_add(sfi_times(5.0, sfi_mul(A2,
        root2)), sfi_times(12.0, root4)), t1))), sfi_mul(root2, sfi_sub(sfi_mul(sfi_mul(sfi_mul(b4, lost_2), t0),
        sfi_add(A2, sfi_times(4.0, root2))), sfi_mul(sfi_mul(sfi_mul(b5, lost_3), root2), t0))))))), root7));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 1 are the first to be lost. */
static inline sf_interval sampled_intervals_bent_end_1(sf_interval A, sf_interval b, sf_interval lost_1, sf_interval lost_2, sf_interval lost_3)
{
    const sf_interval root = sfi_mul(sfi_sqrt(sfi_sub(A, b)), sfi_sqrt(sfi_add(A, b)));
    const sf_interval A2 = sfi_square(A);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval A5 = sfi_mul(A, A4);
    const sf_interval t0 = sfi_inverse(A5);
    const sf_interval root2 = sfi_square(root);
    const sf_interval root4 = sfi_square(root2);
    const sf_interval root5 = sfi_mul(root, root4);
    const sf_interval b2 = sfi_square(b);
    const sf_interval b4 = sfi_square(b2);
    const sf_interval b5 = sfi_mul(b, b4);
    const sf_interval b3 = sfi_mul(b, b2);
    return sfi_neg(sfi_div(sfi_mul(sfi_around(1.2732395447351628), sfi_add(sfi_neg(sfi_mul(sfi_mul(sfi_mul(b3,
        lost_1), t0), sfi_add(sfi_add(sfi_times(5.0, sfi_mul(A2, root2)), sfi_times(3.0, A4)), sfi_times(12.0,
        root4)))), sfi_mul(root2, sfi_sub(sfi_mul(sfi_mul(sfi_mul(b4, lost_2), t0), sfi_add(A2, sfi_times(4.0,
        root2))), sfi_mul(sfi_mul(sfi_mul(b5, lost_3), root2), t0))))), root5));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 2 are the first to be lost. */
static inline sf_interval sampled_intervals_bent_end_2(sf_interval A, sf_interval b, sf_interval lost_2, sf_interval lost_3)
{
    const sf_interval root = sfi_mul(sfi_sqrt(sfi_sub(A, b)), sfi_sqrt(sfi_add(A, b)));
    const sf_interval A2 = sfi_square(A);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval A5 = sfi_mul(A, A4);
    const sf_interval t0 = sfi_inverse(A5);
    const sf_interval root2 = sfi_square(root);
    const sf_interval root3 = sfi_mul(root, root2);
    const sf_interval b2 = sfi_square(b);
    const sf_interval b4 = sfi_square(b2);
    const sf_interval b5 = sfi_mul(b, b4);
    return sfi_neg(sfi_div(sfi_mul(sfi_around(1.2732395447351628), sfi_sub(sfi_mul(sfi_mul(sfi_mul(b4, lost_2),
        t0), sfi_add(A2, sfi_times(4.0, root2))), sfi_mul(sfi_mul(sfi_mul(b5, lost_3), root2), t0))), root3));
}

/* What a breakpoint adds to h_AAAA; derivatives of order 3 are the first to be lost. */
static inline sf_interval sampled_intervals_bent_end_3(sf_interval A, sf_interval b, sf_interval lost_3)
{
    const sf_interval root = sfi_mul(sfi_sqrt(sfi_sub(A, b)), sfi_sqrt(sfi_add(A, b)));
    const sf_interval A2 = sfi_square(A);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval A5 = sfi_mul(A, A4);
    const sf_interval b2 = sfi_square(b);
    const sf_interval b4 = sfi_square(b2);
    const sf_interval b5 = sfi_mul(b, b4);
    return sfi_div(sfi_mul(sfi_around(1.2732395447351628), sfi_mul(b5, lost_3)), sfi_mul(A5, root));
}

#endif
