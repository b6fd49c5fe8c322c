/* What programs are made of, which are interpreted, in C and in Python.

   Written by `make derive` from derivations/codegen/conventions.toml; never edit. */

#ifndef PROGRAM_CONVENTIONS_H
#define PROGRAM_CONVENTIONS_H

/* What a program does with one or two numbers. */
typedef enum {
    SF_ADD_OPERATION = 0, /* a + b */
    SF_SUB_OPERATION = 1, /* a - b */
    SF_MUL_OPERATION = 2, /* a b */
    SF_DIV_OPERATION = 3, /* a/b */
    SF_NEG_OPERATION = 4, /* -a */
    SF_SQRT_OPERATION = 5, /* square root */
    SF_ATAN2_OPERATION = 6, /* angle of (b, a) */
    SF_ATAN2_SWAPPED_OPERATION = 7, /* angle of (a, b), which shares its arctangent with the other */
    SF_SQUARE_OPERATION = 8, /* a^2 */
    SF_INVERSE_OPERATION = 9, /* 1/a */
    SF_TIMES_OPERATION = 10, /* the double a times b */
    SF_WITHIN_OPERATION = 11, /* a, known to a relative error of the double b */
    SF_ROOT_OPERATION = 12, /* square root of what may be negative */
    SF_POWER_OPERATION = 13, /* a^b */
    SF_ABS_OPERATION = 14, /* |a| */
    SF_COPYSIGN_OPERATION = 15, /* |a| with the sign of b */
    SF_EXP_OPERATION = 16, /* exp */
    SF_LOG_OPERATION = 17, /* log */
    SF_LOG1P_OPERATION = 18, /* log1p */
    SF_CBRT_OPERATION = 19, /* cbrt */
    SF_SIN_OPERATION = 20, /* sin */
    SF_COS_OPERATION = 21, /* cos */
    SF_TAN_OPERATION = 22, /* tan */
    SF_SINH_OPERATION = 23, /* sinh */
    SF_COSH_OPERATION = 24, /* cosh */
    SF_TANH_OPERATION = 25, /* tanh */
    SF_ASIN_OPERATION = 26, /* asin */
    SF_ACOS_OPERATION = 27, /* acos */
    SF_ATAN_OPERATION = 28, /* atan */
    SF_ASINH_OPERATION = 29, /* asinh */
    SF_ACOSH_OPERATION = 30, /* acosh */
    SF_ATANH_OPERATION = 31, /* atanh */
    SF_HYPOT_OPERATION = 32 /* hypot */
} sf_operation;

/* of the data that programs are; others are refused */
#define SF_PROGRAM_FORM 1
/* of a program */
#define SF_MOST_REGISTERS 1024
/* numbers side by side in a register */
#define SF_LANES 8

#endif
