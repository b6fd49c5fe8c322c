"""Duffing oscillator: one cubic piece, no breakpoint: in balls.

Written by `make derive` from derivations/mechanisms/duffing.py; never edit.

Arguments are `flint.arb`, or numbers that are exact; each output holds the value of the function of the same name,
to the digits of `flint.ctx`. passed_n is meant where A exceeds n breakpoints; beyond: by how much it exceeds the
last of these.
"""

from flint import arb

__all__ = [
    "given", "known",
]


def given(alpha, beta):
    """The parameters from the design, and what the force loses at each breakpoint.

    Equation (5)-(7). Domain: any design.
    """
    return alpha, beta


def known(A, alpha, beta):
    """h, h_A, h_AA, h_AAA, h - A h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    A2 = A**2
    t0 = A2 * beta
    t1 = 4.5 * beta
    A3 = A * A2
    return A * (-alpha - 0.75 * t0), -alpha - 2.25 * t0, -A * t1, -t1, 1.5 * A3 * beta
