"""Seeds in; tests/data/closed.json out: certified folds, onsets and states under forces averaged in closed form.

    python -m tests.oracles.make_closed

The forces are those of `pieces`, f(u) for u > 0, averaged as `make_stated` averages any: no closed form is used. Each
case has folds; draws without any are left out, and those in which balls do not tell a cusp from a point next to one.

Up to its end the first piece of a stop, of a bilinear spring and of play is linear, and has no fold. Play has no
stiffness there: with p = -h/A and q = -h_A, p < q, folds have Omega^2 between them, and R R_A + I I_A = 0 says
(Omega^2 - p)(q - Omega^2) >= 4 zeta^2 Omega^2. So there is none where q <= 4 zeta^2, nor where
(q - p)^2 < 16 zeta^2 p; p rises, so that beyond twice the gap it is at least p there, which bounds the amplitude.
"""

from __future__ import annotations

from itertools import count
from typing import Any

from flint import arb

from tests.files import store
from tests.oracles.averaged import BITS, Jet, Point
from tests.oracles.certified_roots import precision
from tests.oracles.make_stated import Force, Piece, Stated, _uniform, case
from tests.oracles.pieces import CLOSED, a, b, k

#: of each force
EACH = 30


class Bent(Stated):
    """Of a force that is linear up to its bend."""

    def _corner_extrema(self) -> list[Point]:
        return []  # the locus does not come to the bend from below


class DeadZone(Bent):
    """Of a force that vanishes up to the gap; the least slope is p at twice the gap."""

    @property
    def least_slope(self) -> arb:
        return arb(2) / 3 - arb(3).sqrt() / (2 * arb.pi())

    def ask(self, F_0: float, frequencies: list[float]) -> None:
        with precision(BITS):
            super().ask(F_0, frequencies)
            self.high = self.high.max(self.u_cr * arb("2.001"))

    def _nothing_below(self, A: arb, Omega: arb, forcing: arb) -> bool:
        quiet = (A * Omega**2) ** 2 + (2 * arb(self.zeta) * A * Omega + self.m) ** 2 < forcing**2
        return bool(A < self.u_cr and quiet)

    def _unfolded(self, j: Jet, piece: Piece) -> bool:
        if not piece.beyond:
            return True
        A, zeta = j.A[0], arb(self.zeta)
        p, q = -j.h[0] / A, -j.g[0]
        return bool(q < 4 * zeta**2 or (q - p) ** 2 < 16 * zeta**2 * p)


#: what is drawn of each, more about it, and its oscillators
DRAWN: dict[str, tuple[dict[str, tuple[float, float]], dict[str, Any], type[Stated]]] = {
    "stop": ({"k": (0.3, 5.0), "gap": (0.1, 0.5)}, {}, Bent),
    "bilinear": ({"k": (0.25, 0.75), "gap": (0.1, 0.4)}, {"least_slope": k}, Bent),
    "play": ({"gap": (0.03, 0.4)}, {}, DeadZone),
    "even": ({"a": (-0.5, 1.0), "b": (0.3, 0.8)}, {"least_slope": 1 - a**2 / (3 * b)}, Stated),
    "preload": ({"c": (0.005, 0.04), "b": (0.2, 1.5)}, {"at_rest": True}, Stated),
}


def cases(name: str) -> list[dict]:
    """Those of a force."""
    ranges, more, kind = DRAWN[name]
    force = Force(CLOSED[name], _uniform(**ranges), **more)
    found: list[dict] = []
    for index in count():
        try:
            one = case(name, force, index, kind)
        except ArithmeticError:
            continue
        if one["folds"]:
            found.append(one)
        if len(found) == EACH:
            return found
    raise AssertionError


if __name__ == "__main__":
    store("closed", [one for name in DRAWN for one in cases(name)])
