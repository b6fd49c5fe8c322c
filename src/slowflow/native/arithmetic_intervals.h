/* What generated text on numbers of any kind (*_generic.h, arithmetic_end.h) means on intervals (interval.h). */
#include "arithmetic_begin.h"

#define REAL sf_interval
#define KERNEL static inline
#define POINT sfi_point
#define ADD sfi_add
#define SUB sfi_sub
#define MUL sfi_mul
#define DIV sfi_div
#define TIMES sfi_times
#define NEG sfi_neg
#define INVERSE sfi_inverse
#define SQUARE sfi_square
#define BY_SQUARE(a, b) sfi_mul(a, sfi_square(b))
#define SQRT sfi_sqrt
#define CONSTANT(high, low) sfi_around(high)
#define ATAN2 sfi_atan2
#define ATAN2_SWAPPED(x, y) sfi_atan2(y, x)
#define WITHIN sfi_within
