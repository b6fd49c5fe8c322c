/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: in double-double.

   Written by `make derive` from derivations/mechanisms/rod_spring_untruncated.py, derivations/asymmetric/curved.py;
   never edit.

   `out` takes the outputs, where there are several. */

#ifndef ROD_SPRING_UNTRUNCATED_PAIRS_H
#define ROD_SPRING_UNTRUNCATED_PAIRS_H

#include "pair_angles.h"
#include "inline.h"
#include "arithmetic_pairs.h"
#define OF(name) rod_spring_untruncated_pairs_##name
#include "rod_spring_untruncated_generic.h"

#include "arithmetic_end.h"
#endif
