/* What generated text on numbers of any kind (*_generic.h, arithmetic_end.h) means in double-double with a bound of the
 * error (bounded.h). */
#include "arithmetic_begin.h"

#define REAL sf_bounded
#define KERNEL static inline
#define POINT sfb_point
#define ADD sfb_add
#define SUB sfb_sub
#define MUL sfb_mul
#define DIV sfb_div
#define TIMES sfb_times
#define NEG sfb_neg
#define INVERSE sfb_inverse
#define SQUARE sfb_square
#define SQRT sfb_sqrt
#define CONSTANT sfb_around
#define ATAN2 sfb_atan2
#define ATAN2_SWAPPED(x, y) sfb_atan2(y, x)
