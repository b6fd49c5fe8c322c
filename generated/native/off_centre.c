/* Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle: loops for NumPy.

   Written by `make derive`; never edit.
   Input: off_centre.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "off_centre.h"

#include "kernels.h"

SF_TUPLE(, off_centre_ended_along, 2, off_centre_ended_along, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, off_centre_begin, 4, off_centre_begin, X(0), X(1), X(2), X(3))
SF_TUPLE(, off_centre_up, 2, off_centre_up, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7))
SF_TUPLE(, off_centre_down, 2, off_centre_down, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7))

static const sf_kernel kernels[] = {
    {"ended_along", 6, 2, SF_ONE(off_centre_ended_along)},
    {"begin", 4, 4, SF_ONE(off_centre_begin)},
    {"up", 8, 2, SF_ONE(off_centre_up)},
    {"down", 8, 2, SF_ONE(off_centre_down)},
};

const sf_module sf_module_off_centre = {"off_centre", kernels, sizeof kernels / sizeof kernels[0]};
