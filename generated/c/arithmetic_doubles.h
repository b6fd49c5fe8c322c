/* What generated text on numbers of any kind (*_generic.h) means on doubles.

   Written by `make derive`; never edit. */

#include <math.h>

#include "arithmetic_begin.h"

#define REAL double
#define KERNEL SF_KERNEL
#define POINT(number) (number)
#define CONSTANT(high, low) (high)
#define ADD(a, b) ((a) + (b))
#define SUB(a, b) ((a) - (b))
#define MUL(a, b) ((a) * (b))
#define DIV(a, b) ((a) / (b))
#define TIMES(number, a) ((number) * (a))
#define NEG(a) (-(a))
#define INVERSE(a) (1.0 / (a))
#define SQUARE(a) ((a) * (a))
#define BY_SQUARE(a, b) ((a) * (b) * (b))
#define SQRT(a) sqrt(a)
