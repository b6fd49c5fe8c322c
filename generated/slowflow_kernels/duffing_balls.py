"""Duffing oscillator: one polynomial of degree five, no breakpoint: in balls.

Written by `make derive` from derivations/mechanisms/duffing.py; never edit.

Arguments are `flint.arb`, or numbers that are exact; each output holds the value of the function of the same name,
to the digits of `flint.ctx`. passed_n is meant where A exceeds n breakpoints; beyond: by how much it exceeds the
last of these.
"""

from flint import arb

__all__ = [
    "given", "known",
]


def given(alpha, beta, gamma):
    """The parameters from the design, and what the force loses at each breakpoint.

    Equation (5)-(7). Domain: any design.
    """
    return alpha, beta, gamma


def known(A, alpha, beta, gamma):
    """h, h_A, h_AA, h_AAA, h - A h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    t0 = A**2
    gamma_A2 = gamma * t0
    gamma_A4 = gamma_A2 * t0
    beta_A2 = beta * t0
    t1 = 4.5 * beta
    return (
        A * (-alpha - 0.75 * beta_A2 - 0.625 * gamma_A4),
        -alpha - 2.25 * beta_A2 - 3.125 * gamma_A4,
        A * (-12.5 * gamma_A2 - t1),
        -37.5 * gamma_A2 - t1,
        A * (1.5 * beta_A2 + 2.5 * gamma_A4),
    )
