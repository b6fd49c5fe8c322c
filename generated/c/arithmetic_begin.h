/* Before generated text on numbers of any kind (*_generic.h): macros of these names are kept until arithmetic_end.h.

   Written by `make derive`; never edit. */

#pragma push_macro("OF")
#undef OF
#pragma push_macro("REAL")
#undef REAL
#pragma push_macro("KERNEL")
#undef KERNEL
#pragma push_macro("POINT")
#undef POINT
#pragma push_macro("CONSTANT")
#undef CONSTANT
#pragma push_macro("ADD")
#undef ADD
#pragma push_macro("SUB")
#undef SUB
#pragma push_macro("MUL")
#undef MUL
#pragma push_macro("DIV")
#undef DIV
#pragma push_macro("TIMES")
#undef TIMES
#pragma push_macro("NEG")
#undef NEG
#pragma push_macro("INVERSE")
#undef INVERSE
#pragma push_macro("SQUARE")
#undef SQUARE
#pragma push_macro("BY_SQUARE")
#undef BY_SQUARE
#pragma push_macro("SQRT")
#undef SQRT
#pragma push_macro("ATAN2")
#undef ATAN2
#pragma push_macro("ATAN2_SWAPPED")
#undef ATAN2_SWAPPED
#pragma push_macro("WITHIN")
#undef WITHIN
