/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance: on whole intervals.

   Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/paper/averaging.py,
   derivations/paper/slow_flow.py, derivations/extensions/inertia.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef INERTIA_INTERVALS_H
#define INERTIA_INTERVALS_H

#include "interval.h"
#include "inline.h"
#include "arithmetic_intervals.h"
#define OF(name) inertia_intervals_##name
#include "inertia_generic.h"

#include "arithmetic_end.h"
#endif
