/* What generated text on numbers of any kind (*_generic.h, arithmetic_end.h) means in double-double (pair.h). */
#include "arithmetic_begin.h"

#define REAL sf_pair
#define KERNEL TWOFOLD_INLINE
#define POINT sfp_point
#define ADD sfp_add
#define SUB sfp_sub
#define MUL sfp_mul
#define DIV sfp_div
#define TIMES sfp_times
#define NEG sfp_neg
#define INVERSE sfp_inverse
#define SQUARE sfp_square
#define SQRT sfp_sqrt
#define CONSTANT sfp_of
#define ATAN2 pair_angles_atan2
#define ATAN2_SWAPPED pair_angles_atan2_swapped
/* series that are cut short have a pair's digits */
#define WITHIN(a, error) (a)
