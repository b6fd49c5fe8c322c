/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: on whole intervals.

   Written by `make derive` from derivations/mechanisms/rod_spring.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   passed: how many breakpoints the amplitude exceeds; beyond: by how much it exceeds the last of these. */

#ifndef ROD_SPRING_INTERVALS_H
#define ROD_SPRING_INTERVALS_H

#include "interval.h"
#include "inline.h"
#include "arithmetic_intervals.h"
#define OF(name) rod_spring_intervals_##name
#include "rod_spring_generic.h"

/* h, h_A, h_AA, h_AAA, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
static inline void rod_spring_intervals_known(int passed, sf_interval A, sf_interval beyond, const sf_interval *p, sf_interval *out) {
    const sf_interval u_cr = p[3];
    if (passed == 0)
        rod_spring_intervals_known_passed_0(A, beyond, p, out);
    else if (passed == 1 && A.lo <= MUL(CONSTANT(1.05, -4.4408920985006264e-17), u_cr).hi)
        rod_spring_intervals_known_passed_1(A, beyond, p, out);
    else
        rod_spring_intervals_known_passed_1_far_1(A, beyond, p, out);
}

#include "arithmetic_end.h"
#endif
