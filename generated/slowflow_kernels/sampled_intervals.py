"""The average of a force that is known by its values and those of its derivatives, u = A sine: on whole intervals.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/quadrature.py, derivations/sampled.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Each output holds every value that the function of the same name takes on the arguments: objects with operators and
the methods `square` and `sqrt`.
"""

# a formatter would spread each polynomial over a page
# fmt: off

__all__ = [
    "bent_end_0",
    "bent_end_1",
    "bent_end_2",
    "bent_end_3",
    "bent_terms",
]


def bent_terms(sine, f, f_uuuu):
    """Under the integrals of h and h_AAAA.

    Equation (20), (31). Domain: any.
    """
    sine2 = sine.square()
    sine4 = sine2.square()
    sine5 = sine * sine4
    return (
        -1.2732395447351628 * f * sine,
        -1.2732395447351628 * f_uuuu * sine5,
    )


def bent_end_0(A, b, lost_0, lost_1, lost_2, lost_3):
    """What a breakpoint adds to h_AAAA; derivatives of order 0 are the first to be lost.

    Equation (31). Domain: A > b > 0.
    """
    root = (A - b).sqrt() * (A + b).sqrt()
    A2 = A.square()
    A4 = A2.square()
    A5 = A * A4
    t0 = 1.0 / A5
    root2 = root.square()
    root4 = root2.square()
    t1 = 3.0 * A4
    root3 = root * root2
    root6 = root3.square()
    root7 = root * root6
    b2 = b.square()
    b4 = b2.square()
    b5 = b * b4
    b3 = b * b2
    A3 = A * A2
    A6 = A3.square()
    return (
        -1.2732395447351628 * (3.0 * b2 * lost_0 * t0 * (4.0 * A2 * root4 + 5.0 * A6 + root2 * t1 + 8.0 * root6) +
        root2 * (-b3 * lost_1 * t0 * (5.0 * A2 * root2 + 12.0 * root4 + t1) + root2 * (b4 * lost_2 * t0 * (A2 + 4.0
        * root2) - b5 * lost_3 * root2 * t0))) / root7
    )


def bent_end_1(A, b, lost_1, lost_2, lost_3):
    """What a breakpoint adds to h_AAAA; derivatives of order 1 are the first to be lost.

    Equation (31). Domain: A > b > 0.
    """
    root = (A - b).sqrt() * (A + b).sqrt()
    A2 = A.square()
    A4 = A2.square()
    A5 = A * A4
    t0 = 1.0 / A5
    root2 = root.square()
    root4 = root2.square()
    root5 = root * root4
    b2 = b.square()
    b4 = b2.square()
    b5 = b * b4
    b3 = b * b2
    return (
        -1.2732395447351628 * (-b3 * lost_1 * t0 * (5.0 * A2 * root2 + 3.0 * A4 + 12.0 * root4) + root2 * (b4 *
        lost_2 * t0 * (A2 + 4.0 * root2) - b5 * lost_3 * root2 * t0)) / root5
    )


def bent_end_2(A, b, lost_2, lost_3):
    """What a breakpoint adds to h_AAAA; derivatives of order 2 are the first to be lost.

    Equation (31). Domain: A > b > 0.
    """
    root = (A - b).sqrt() * (A + b).sqrt()
    A2 = A.square()
    A4 = A2.square()
    A5 = A * A4
    t0 = 1.0 / A5
    root2 = root.square()
    root3 = root * root2
    b2 = b.square()
    b4 = b2.square()
    b5 = b * b4
    return (
        -1.2732395447351628 * (b4 * lost_2 * t0 * (A2 + 4.0 * root2) - b5 * lost_3 * root2 * t0) / root3
    )


def bent_end_3(A, b, lost_3):
    """What a breakpoint adds to h_AAAA; derivatives of order 3 are the first to be lost.

    Equation (31). Domain: A > b > 0.
    """
    root = (A - b).sqrt() * (A + b).sqrt()
    A2 = A.square()
    A4 = A2.square()
    A5 = A * A4
    b2 = b.square()
    b4 = b2.square()
    b5 = b * b4
    return (
        1.2732395447351628 * b5 * lost_3 / (A5 * root)
    )
