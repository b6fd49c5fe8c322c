/* Duffing oscillator: one cubic piece, no breakpoint: in double-double.

   Written by `make derive` from derivations/mechanisms/duffing.py; never edit.

   `out` takes the outputs, where there are several. */

#ifndef DUFFING_PAIRS_H
#define DUFFING_PAIRS_H

#include "pair_angles.h"
#include "arithmetic_pairs.h"

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
static inline void duffing_pairs_given(sf_pair alpha, sf_pair beta, sf_pair *out)
{
    out[0] = alpha;
    out[1] = beta;
}

/* h, h_A, h_AA, h_AAA, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void duffing_pairs_known(sf_pair A, const sf_pair *p, sf_pair *out)
{
    const sf_pair alpha = p[0], beta = p[1];
    const sf_pair A2 = SQUARE(A);
    const sf_pair t0 = MUL(A2, beta);
    const sf_pair t1 = TIMES(4.5, beta);
    const sf_pair A3 = MUL(A, A2);
    out[0] = MUL(A, SUB(NEG(alpha), TIMES(0.75, t0)));
    out[1] = SUB(NEG(alpha), TIMES(2.25, t0));
    out[2] = NEG(MUL(A, t1));
    out[3] = NEG(t1);
    out[4] = TIMES(1.5, MUL(A3, beta));
}

#include "arithmetic_end.h"
#endif
