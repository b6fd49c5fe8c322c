"""What programs are made of, which are interpreted, in C and in Python.

Written by `make derive` from derivations/codegen/conventions.toml; never edit.
"""

from enum import IntEnum


class Operation(IntEnum):
    """What a program does with one or two numbers.

    0  ADD            a + b
    1  SUB            a - b
    2  MUL            a b
    3  DIV            a/b
    4  NEG            -a
    5  SQRT           square root
    6  ATAN2          angle of (b, a)
    7  ATAN2_SWAPPED  angle of (a, b), which shares its arctangent with the other
    8  SQUARE         a^2
    9  INVERSE        1/a
    10  TIMES          the double a times b
    11  WITHIN         a, known to a relative error of the double b
    12  ROOT           square root of what may be negative
    13  POWER          a^b
    14  ABS            |a|
    15  COPYSIGN       |a| with the sign of b
    16  EXP            exp
    17  LOG            log
    18  LOG1P          log1p
    19  CBRT           cbrt
    20  SIN            sin
    21  COS            cos
    22  TAN            tan
    23  SINH           sinh
    24  COSH           cosh
    25  TANH           tanh
    26  ASIN           asin
    27  ACOS           acos
    28  ATAN           atan
    29  ASINH          asinh
    30  ACOSH          acosh
    31  ATANH          atanh
    32  HYPOT          hypot
    """

    ADD = 0
    SUB = 1
    MUL = 2
    DIV = 3
    NEG = 4
    SQRT = 5
    ATAN2 = 6
    ATAN2_SWAPPED = 7
    SQUARE = 8
    INVERSE = 9
    TIMES = 10
    WITHIN = 11
    ROOT = 12
    POWER = 13
    ABS = 14
    COPYSIGN = 15
    EXP = 16
    LOG = 17
    LOG1P = 18
    CBRT = 19
    SIN = 20
    COS = 21
    TAN = 22
    SINH = 23
    COSH = 24
    TANH = 25
    ASIN = 26
    ACOS = 27
    ATAN = 28
    ASINH = 29
    ACOSH = 30
    ATANH = 31
    HYPOT = 32


# of the data that programs are; others are refused
PROGRAM_FORM = 1
# of a program
MOST_REGISTERS = 1024
# numbers side by side in a register
LANES = 8
