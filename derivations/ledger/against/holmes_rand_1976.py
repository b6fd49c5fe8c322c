"""Against Holmes and Rand: the averaged response (24) and phase (25) of the oscillator with a cubic term."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from ...symbols import F_0, A, Omega, zeta
from ..judging import Judgement
from ..proofs import canonical
from ..rows import DIFFERS, LOOSE
from . import Derived, Judge, equal, plain, value

beta = sp.Symbol("beta", real=True)


def formulas(derived: Derived) -> dict[str, Judge]:
    """The polynomial, and the phase."""

    def phase(function: Callable[..., Any]) -> Judgement:
        published = value(function, {"A": A, "sigma": 2 * zeta * Omega, "phi": F_0})
        difference = canonical(sp.sin(published) + derived.flow.I / F_0)
        shown = "sin φ = −I/F_0, cos φ = −R/F_0"
        if not difference.is_zero:
            return Judgement(DIFFERS, plain(function), shown, f"of the sines: {difference.text()}")
        return Judgement(
            LOOSE,
            plain(function),
            shown,
            evidence="Its sine is right. But the cosine of an arcsine is never negative, so this is the phase only "
            "below the backbone, R ≤ 0. Above the backbone the phase is −π minus this.",
        )

    return {
        "amplitude_polynomial": equal(
            16 * derived.response(derived.cubic(1, beta)),
            {"y": A**2, "alpha": beta, "rho": 1 - Omega**2, "sigma": 2 * zeta * Omega, "phi": F_0},
            rewriting="y = A², ρ = 1 − Ω², σ = 2ζΩ; it is 16 F of (24)",
        ),
        "phase": phase,
    }
