/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: on whole intervals.

   Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
   never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef ROD_SPRING_UNTRUNCATED_INTERVALS_H
#define ROD_SPRING_UNTRUNCATED_INTERVALS_H

#include "interval.h"
#include "inline.h"
#include "arithmetic_intervals.h"
#define OF(name) rod_spring_untruncated_intervals_##name
#include "rod_spring_untruncated_generic.h"

#include "arithmetic_end.h"
#endif
