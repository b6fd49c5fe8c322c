"""The kernels of the frequencies at an amplitude: both quartics in double and in double-double, and what they share.

In:  `Results`.
Out: `frequencies_module`.
"""

from __future__ import annotations

import sympy as sp

from ...kernels import Formulas, Let, Lets
from ...paper.slow_flow import I, R, m
from ...results import Results
from ...symbols import F_0, A, Omega, h, h_A, zeta
from ...systems.frequencies import Frequencies, Quartic, k, p, q
from ..compensated import magnitude
from ..form import Module, TwofoldKernel
from ..requests import requested

#: a value below this part of its terms has no certain sign in double, and in double-double
ROUGH, FINE = sp.Rational(1, 2**50), sp.Rational(1, 2**98)

#: what a frequency and coefficients lack in double
tail, p_low, q_low = sp.symbols("tail p_low q_low", real=True)


def frequencies_module(results: Results) -> Module:
    """The quartics F and F_A/2, their derivative's cubic, and its discriminant."""
    found = results.frequencies
    lets = ((R, found.R), (I, found.I))
    of = Formulas((Omega, A, F_0, m, zeta, h, h_A, p, q, k), domain="Omega >= 0, A > 0")
    twofolds: list[TwofoldKernel] = []
    for name, quartic, arguments, equation in (
        ("response", found.response, (F_0, m, zeta, h), "(24)"),
        ("fold", found.fold, (m, zeta, h, h_A), "(30)"),
    ):
        twofolds += of_quartic(of, name, quartic, arguments, lets, equation)
    state_shared(of, found)
    twofolds += shared_twofolds(found)
    return Module(
        name="frequencies",
        title="The quartics whose roots are the frequencies at an amplitude: F of the response, F_A/2 of the folds",
        inputs=("paper/averaging.py", "paper/slow_flow.py", "systems/frequencies.py"),
        stated=requested("frequencies", of.kernels.values()),
        twofolds=tuple(twofolds),
        constants={"ROUGH": ROUGH, "FINE": FINE},
    )


def of_quartic(
    of: Formulas, name: str, quartic: Quartic, parameters: tuple[sp.Symbol, ...], lets: tuple[Let, ...], equation: str
) -> list[TwofoldKernel]:
    """One quartic: its value, at 0 too, and the coefficients of its derivative."""
    size, fine_size = (magnitude(lets, quartic.value, epsilon) for epsilon in (ROUGH, FINE))
    what = {"response": "F", "fold": "F_A/2"}[name]
    bounded = "and what its rounding error is below ROUGH times of"
    of.add(name, Lets(lets, (quartic.value, size)), f"{what}, {bounded}.", equation)
    if quartic.at_0.is_Mul:
        at_0, text = quartic.at_0, f"{what} at Omega = 0."
    else:
        at_0, text = (quartic.at_0, magnitude((), quartic.at_0, ROUGH)), f"{what} at Omega = 0, {bounded}."
    of.add(f"{name}_at_0", at_0, text, equation, "any")
    squared = sp.expand(quartic.value) if name == "response" else quartic.value

    def fine(suffix: str, more: tuple[sp.Symbol, ...], lows: dict[sp.Symbol, sp.Symbol], where: str) -> TwofoldKernel:
        return TwofoldKernel(
            name + suffix,
            (Omega, *more, A, *parameters),
            lets,
            (squared,),
            f"{what}{where} in double-double, and what its error is below FINE times of.",
            equation,
            of.domain,
            lows,
            plain=(fine_size,),
        )

    derivative = [argument for argument in (A, *parameters) if any(x.has(argument) for x in (quartic.p, quartic.q))]
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
            plain=(quartic.k,),
        ),
    ]
    if quartic.at_0.is_Add:
        twofolds.append(
            TwofoldKernel(
                f"{name}_exactly_at_0",
                of.kernels[f"{name}_at_0"].arguments,
                (),
                (sp.expand(quartic.at_0),),
                f"{what} at Omega = 0, with a certain sign.",
                equation,
                "any",
                returns="distilled",
            )
        )
    return twofolds


def state_shared(of: Formulas, found: Frequencies) -> None:
    """The cubic A w^3 + p w + q and the rise of a quartic to where it vanishes."""
    equation = "from (24), (30)"
    of.add("cubic", found.cubic, "A Omega^3 + p Omega + q.", equation)
    of.add("cubic_slope", found.slope, "Its derivative by Omega.", equation)
    rise, text = (
        (found.rise, magnitude((), found.rise, ROUGH)),
        "Of a quartic from 0 to a critical point, and its magnitude.",
    )
    of.add("rise", rise, text, equation)


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
            plain=(of.discriminant.coeff(p, 3) * p**3,),
        ),
    ]
