/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: in double-double.

   Written by `make derive` from derivations/mechanisms/rod_spring.py; never edit.

   `out` takes the outputs, where there are several.
   passed: how many breakpoints the amplitude exceeds; beyond: by how much it exceeds the last of these. */

#ifndef ROD_SPRING_PAIRS_H
#define ROD_SPRING_PAIRS_H

#include "pair_angles.h"
#include "inline.h"
#include "arithmetic_pairs.h"
#define OF(name) rod_spring_pairs_##name
#include "rod_spring_generic.h"

/* h, h_A, h_AA, h_AAA, h - A h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. */
TWOFOLD_INLINE void rod_spring_pairs_known(int passed, sf_pair A, sf_pair beyond, const sf_pair *p, sf_pair *out) {
    const sf_pair u_cr = p[3];
    if (passed == 0)
        rod_spring_pairs_known_passed_0(A, beyond, p, out);
    else if (passed == 1 && A.high > 64.0 * u_cr.high)
        rod_spring_pairs_known_passed_1_far_1(A, beyond, p, out);
    else
        rod_spring_pairs_known_passed_1(A, beyond, p, out);
}

#include "arithmetic_end.h"
#endif
