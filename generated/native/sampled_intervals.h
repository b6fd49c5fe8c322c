/* The average of a force that is known by its values and those of its derivatives, u = A sine: on whole intervals.

   Written by `make derive` from derivations/forces/quadrature.py, derivations/forces/sampled.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef SAMPLED_INTERVALS_H
#define SAMPLED_INTERVALS_H

#include "interval.h"
#include "inline.h"
#include "arithmetic_intervals.h"
#define OF(name) sampled_intervals_##name
#include "sampled_generic.h"

#include "arithmetic_end.h"
#endif
