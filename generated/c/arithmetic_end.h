/* Behind generated text on numbers of any kind (*_generic.h): its macros are what they were before it.

   Written by `make derive`; never edit. */

#pragma pop_macro("OF")
#pragma pop_macro("REAL")
#pragma pop_macro("KERNEL")
#pragma pop_macro("POINT")
#pragma pop_macro("CONSTANT")
#pragma pop_macro("ADD")
#pragma pop_macro("SUB")
#pragma pop_macro("MUL")
#pragma pop_macro("DIV")
#pragma pop_macro("TIMES")
#pragma pop_macro("NEG")
#pragma pop_macro("INVERSE")
#pragma pop_macro("SQUARE")
#pragma pop_macro("BY_SQUARE")
#pragma pop_macro("SQRT")
#pragma pop_macro("ATAN2")
#pragma pop_macro("ATAN2_SWAPPED")
#pragma pop_macro("WITHIN")
