/* Behind generated text on numbers of any kind (*_generic.h).

   Written by `make derive`; never edit. */

#undef OF
#undef REAL
#undef KERNEL
#undef POINT
#undef CONSTANT
#undef ADD
#undef SUB
#undef MUL
#undef DIV
#undef TIMES
#undef NEG
#undef INVERSE
#undef SQUARE
#undef BY_SQUARE
#undef SQRT
#undef ATAN2
#undef ATAN2_SWAPPED
#undef WITHIN
