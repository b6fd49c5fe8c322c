"""Against Marino and Cicirello: phases of Den Hartog's motion (35), exact without stops, and the averaged phase (25).

With the maximum of u at tau = 0 the forcing is p cos(Omega tau) - q sin(Omega tau), and the velocity has the sign of
-sin(Omega tau). So with u = Re C e^(i Omega tau) and higher harmonics, the first harmonic of the equation of motion is

    (1 - Omega^2) C + i m = p + i q
"""

from __future__ import annotations

import csv
from collections import defaultdict
from pathlib import Path

import sympy as sp
from flint import arb

from ...claims import claim
from ...paper.den_hartog import U, V, den_hartog
from ...symbols import F_0, A, Omega, mu, tau
from .. import literature
from ..balls import ball, evaluate, rounded
from ..rows import FALSE, TRUE
from . import Claims, Derived

MEASURED = Path(literature.__file__).parent / "marino_cicirello_2020.csv"
#: standard errors by which a mean of measured phases may be off: by chance one of eight is in 1 of 20 cases
ERRORS = 3


def lags(derived: Derived) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Angles by which the motion lags the forcing: its exact first harmonic, averaged, its exact maximum."""
    exact, m = den_hartog(), derived.friction
    forcing = sp.expand(sp.diff(exact.motion, tau, 2) + exact.motion - mu).subs(V, exact.response)
    p, q = forcing.coeff(sp.cos(Omega * tau)), -forcing.coeff(sp.sin(Omega * tau))
    rest = sp.simplify(forcing - p * sp.cos(Omega * tau) + q * sp.sin(Omega * tau))
    claim("Den Hartog's motion is driven by one harmonic", rest, eq="(35)")
    # the angle of (p + i q)/C is that of (p + i q) (p - i q + i m)/(1 - Omega^2)
    harmonic = sp.atan2(p * m * exact.response, (F_0**2 - q * m) * exact.response)
    known = {A: exact.amplitude, V: exact.response, U: exact.damping}
    averaged = sp.atan2(m, sp.sqrt(F_0**2 - m**2) * sp.sign(1 - Omega))
    return harmonic.subs(known).subs(known), averaged, sp.atan2(q, p).subs(known).subs(known)


def claims(derived: Derived) -> Claims:
    """How far off the phases are, nothing being fitted, and how far they scatter."""
    of_lag = lags(derived)
    with MEASURED.open(encoding="utf-8") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    off: tuple[list[arb], ...] = ([], [], [])
    groups: dict[tuple[str, bool], list[arb]] = defaultdict(list)
    for row in rows:
        beta, at, seen = (ball(row[name]) for name in ("beta", "Omega", "phase_deg"))
        for errors, lag in zip(off, of_lag, strict=True):
            errors.append(evaluate(lag, {F_0: arb(1), mu: beta, Omega: at}) * 180 / arb.pi() - seen)
        groups[row["beta"], at > 1].append(off[0][-1])
    means = [sum(errors) / len(errors) for errors in groups.values()]
    left = sum((one - mean) ** 2 for errors, mean in zip(groups.values(), means, strict=True) for one in errors)
    scatter = (left / (len(rows) - len(groups))).sqrt()
    shifts = [
        abs(mean) * arb(len(errors)).sqrt() / scatter for mean, errors in zip(means, groups.values(), strict=True)
    ]
    exact, averaged, maximum = (
        f"{rounded((sum(x**2 for x in errors) / len(rows)).sqrt(), 1)}° root mean square, "
        f"{rounded(max(map(abs, errors)), 1)}° at most"
        for errors in off
    )
    return {
        "friction_damping": (
            TRUE if max(shifts) < ERRORS else FALSE,
            f"{len(rows)} phases, nothing fitted. The first harmonic of Den Hartog's motion is off by {exact}, the "
            f"averaged phase (25) by {averaged}; that of the largest displacement would be off by {maximum}. The "
            f"phases scatter by {rounded(scatter, 1)}° about the mean at the same friction on the same side of "
            f"resonance; of these {len(means)} means none is off by more than {rounded(max(shifts), 1)} of its "
            "standard errors.",
        )
    }
