/* Duffing oscillator: one cubic piece, no breakpoint: on whole intervals.

   Written by `make derive` from derivations/mechanisms/duffing.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef DUFFING_INTERVALS_H
#define DUFFING_INTERVALS_H

#include "interval.h"
#include "arithmetic_intervals.h"

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
static inline void duffing_intervals_given(sf_interval alpha, sf_interval beta, sf_interval *out)
{
    out[0] = alpha;
    out[1] = beta;
}

/* h, h_A, h_AA, h_AAA, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void duffing_intervals_known(sf_interval A, const sf_interval *p, sf_interval *out)
{
    const sf_interval alpha = p[0], beta = p[1];
    const sf_interval A2 = SQUARE(A);
    const sf_interval t0 = MUL(A2, beta);
    const sf_interval t1 = TIMES(4.5, beta);
    const sf_interval A3 = MUL(A, A2);
    out[0] = MUL(A, SUB(NEG(alpha), TIMES(0.75, t0)));
    out[1] = SUB(NEG(alpha), TIMES(2.25, t0));
    out[2] = NEG(MUL(A, t1));
    out[3] = NEG(t1);
    out[4] = TIMES(1.5, MUL(A3, beta));
}

#include "arithmetic_end.h"
#endif
