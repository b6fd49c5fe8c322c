"""The kernels of the frequencies at an amplitude: both quartics in double and in double-double, and what they share.

In:  `Results`.
Out: `frequencies_module`.
"""

from __future__ import annotations

import sympy as sp

from ...kernels import Kernel, Let, plain
from ...paper.slow_flow import I, R, m
from ...results import Results
from ...symbols import F_0, A, Omega, h, h_A, zeta
from ...systems.frequencies import Frequencies, Quartic, k, p, q
from ..compensated import magnitude
from ..form import Module, TwofoldKernel

#: a value below this part of its terms has no certain sign in double, and in double-double
ROUGH, FINE = sp.Rational(1, 2**50), sp.Rational(1, 2**98)

#: what a frequency and coefficients lack in double
tail, p_low, q_low = sp.symbols("tail p_low q_low", real=True)


def frequencies_module(results: Results) -> Module:
    """The quartics F and F_A/2, their derivative's cubic, and its discriminant."""
    of = results.frequencies
    lets = ((R, of.R), (I, of.I))
    kernels: list[Kernel] = []
    twofolds: list[TwofoldKernel] = []
    for name, quartic, arguments, equation in (
        ("response", of.response, (F_0, m, zeta, h), "(24)"),
        ("fold", of.fold, (m, zeta, h, h_A), "(30)"),
    ):
        some_kernels, some_twofolds = of_quartic(name, quartic, arguments, lets, equation)
        kernels += some_kernels
        twofolds += some_twofolds
    kernels += shared(of)
    twofolds += shared_twofolds(of)
    return Module(
        name="frequencies",
        title="The quartics whose roots are the frequencies at an amplitude: F of the response, F_A/2 of the folds",
        inputs=("paper/averaging.py", "paper/slow_flow.py", "systems/frequencies.py"),
        kernels=tuple(kernels),
        twofolds=tuple(twofolds),
        constants={"ROUGH": ROUGH, "FINE": FINE},
    )


def of_quartic(
    name: str, quartic: Quartic, given: tuple[sp.Symbol, ...], lets: tuple[Let, ...], equation: str
) -> tuple[list[Kernel], list[TwofoldKernel]]:
    """One quartic: its value, at 0 too, and the coefficients of its derivative."""
    arguments = (Omega, A, *given)
    size, fine_size = (magnitude(lets, quartic.value, epsilon) for epsilon in (ROUGH, FINE))
    constant = [argument for argument in given if quartic.at_0.has(argument)]
    what = {"response": "F", "fold": "F_A/2"}[name]
    domain = "Omega >= 0, A > 0"
    outputs = [quartic.at_0] if quartic.at_0.is_Mul else [quartic.at_0, magnitude((), quartic.at_0, ROUGH)]
    kernels = [
        plain(
            name,
            arguments,
            (quartic.value, size),
            f"{what}, and what its rounding error is below ROUGH times of.",
            equation,
            domain,
            lets=lets,
            generic=True,
        ),
        plain(
            f"{name}_at_0",
            constant,
            outputs if len(outputs) > 1 else outputs[0],
            f"{what} at Omega = 0" + (", and what its rounding error is below ROUGH times of." if outputs[1:] else "."),
            equation,
            "any",
            generic=True,
        ),
    ]
    squared = sp.expand(quartic.value) if name == "response" else quartic.value

    def fine(suffix: str, more: tuple[sp.Symbol, ...], lows: dict[sp.Symbol, sp.Symbol], where: str) -> TwofoldKernel:
        return TwofoldKernel(
            name + suffix,
            (Omega, *more, A, *given),
            lets,
            (squared,),
            f"{what}{where} in double-double, and what its error is below FINE times of.",
            equation,
            domain,
            lows,
            beside=(fine_size,),
        )

    derivative = [argument for argument in (A, *given) if any(x.has(argument) for x in (quartic.p, quartic.q))]
    twofolds = [
        fine("_fine", (), {}, ""),
        fine("_beside", (tail,), {Omega: tail}, " at Omega + tail"),
        TwofoldKernel(
            f"{name}_derivative",
            tuple(derivative),
            (),
            (quartic.p, quartic.q),
            f"The derivative of {what} by Omega is k (A Omega^3 + p Omega + q): p, p_low, q, q_low, k.",
            equation,
            "A > 0",
            returns="pairs",
            beside=(quartic.k,),
        ),
    ]
    if quartic.at_0.is_Add:
        twofolds.append(
            TwofoldKernel(
                f"{name}_exactly_at_0",
                tuple(constant),
                (),
                (sp.expand(quartic.at_0),),
                f"{what} at Omega = 0, with a certain sign.",
                equation,
                "any",
                returns="distilled",
            )
        )
    return kernels, twofolds


def shared(of: Frequencies) -> list[Kernel]:
    """The cubic A w^3 + p w + q and the rise of a quartic to where it vanishes."""
    texts = ("from (24), (30)", "Omega >= 0, A > 0")
    return [
        plain("cubic", (Omega, A, p, q), of.cubic, "A Omega^3 + p Omega + q.", *texts, generic=True),
        plain("cubic_slope", (Omega, A, p), of.slope, "Its derivative by Omega.", *texts, generic=True),
        plain(
            "rise",
            (Omega, A, p, k),
            (of.rise, magnitude((), of.rise, ROUGH)),
            "Of a quartic from 0 to a critical point, and its magnitude.",
            *texts,
            generic=True,
        ),
    ]


def shared_twofolds(of: Frequencies) -> list[TwofoldKernel]:
    """The cubic, and what is positive where it has two positive roots."""
    lows = {p: p_low, q: q_low}
    texts = ("from (24), (30)", "A > 0")
    return [
        TwofoldKernel(
            "cubic_fine",
            (Omega, A, p, p_low, q, q_low),
            (),
            (of.cubic,),
            "A Omega^3 + p Omega + q in double-double.",
            *texts,
            lows,
        ),
        TwofoldKernel(
            "discriminant",
            (A, p, p_low, q, q_low),
            (),
            (of.discriminant,),
            "Of the cubic, over A: for p < 0 < q positive where it has two positive roots; and its first term.",
            *texts,
            lows,
            beside=(of.discriminant.coeff(p, 3) * p**3,),
        ),
    ]
