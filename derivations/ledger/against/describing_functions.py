"""Against describing functions: the averages of a play and of a spring that slips, and friction's share of I."""

from __future__ import annotations

import sympy as sp

from ...symbols import A, mu
from ..formulas import in_angle
from . import Derived, Judge, equal

#: sin t = delta/A at the breakpoint delta
t = sp.Symbol("t", positive=True)
ANGLE = "the breakpoint being A sin t, 0 < t < π/2; the describing function is −h/A"


def _average(derived: Derived, name: str, **numbers: sp.Expr) -> sp.Expr:
    """-h/A of a mechanism beyond its breakpoint, in t."""
    of = derived.library(name)
    (end,) = of.whole.breakpoints
    named = {symbol: numbers[symbol.name] for symbol in of.oscillator.mechanism.ratios if symbol.name in numbers}
    values = {symbol: value.subs(named) for symbol, value in of.oscillator.definitions.items() if symbol != end}
    return -in_angle(of.whole.regimes[1].closed_form(), end, sp.pi / 2 - t).subs(values) / A


def formulas(derived: Derived) -> dict[str, Judge]:
    """The three functions."""
    k = sp.Symbol("k", positive=True)
    return {
        # friction is a relay of the velocity, whose amplitude is A Omega; I is what it answers to A Omega
        "ideal_relay": equal(
            derived.friction / A,
            {"M": mu, "A": A},
            remark="Dry friction is a relay of the velocity: its describing function times the velocity's amplitude is "
            "the contribution of friction to I, m = 4μ/π.",
        ),
        "dead_zone": equal(_average(derived, "dead_zone"), {"delta": A * sp.sin(t), "A": A}, rewriting=ANGLE),
        "saturation": equal(
            k * _average(derived, "bilinear", kappa=sp.Integer(0)),
            {"k": k, "a": k * A * sp.sin(t), "A": A},
            rewriting=f"k = k_v, κ = 0; {ANGLE}",
            remark="A bilinear spring without stiffness beyond its breakpoint.",
        ),
    }
