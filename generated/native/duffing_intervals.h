/* Duffing oscillator: one polynomial of degree five, no breakpoint: on whole intervals.

   Written by `make derive` from derivations/mechanisms/duffing.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef DUFFING_INTERVALS_H
#define DUFFING_INTERVALS_H

#include "interval.h"
#include "arithmetic_intervals.h"

/* The parameters from the design, and what the force loses at each breakpoint.
   Equation (5)-(7). Domain: any design. */
static inline void duffing_intervals_given(sf_interval alpha, sf_interval beta, sf_interval gamma, sf_interval *out) {
    out[0] = alpha;
    out[1] = beta;
    out[2] = gamma;
}

/* h, h_A, h_AA, h_AAA, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void duffing_intervals_known(sf_interval A, const sf_interval *p, sf_interval *out) {
    const sf_interval alpha = p[0], beta = p[1], gamma = p[2];
    const sf_interval t0 = SQUARE(A);
    const sf_interval gamma_A2 = MUL(gamma, t0);
    const sf_interval gamma_A4 = MUL(gamma_A2, t0);
    const sf_interval beta_A2 = MUL(beta, t0);
    const sf_interval t1 = TIMES(4.5, beta);
    out[0] = MUL(A, SUB(SUB(NEG(alpha), TIMES(0.75, beta_A2)), TIMES(0.625, gamma_A4)));
    out[1] = SUB(SUB(NEG(alpha), TIMES(2.25, beta_A2)), TIMES(3.125, gamma_A4));
    out[2] = MUL(A, SUB(NEG(TIMES(12.5, gamma_A2)), t1));
    out[3] = SUB(NEG(TIMES(37.5, gamma_A2)), t1);
    out[4] = MUL(A, ADD(TIMES(1.5, beta_A2), TIMES(2.5, gamma_A4)));
}

#include "arithmetic_end.h"
#endif
