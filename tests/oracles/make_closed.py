"""Seeds in; tests/data/closed.json out: certified folds, onsets and states under forces averaged in closed form.

    python -m tests.oracles.make_closed

The forces are typed here, f(u) for u > 0, and averaged as `make_stated` averages any: no closed form is used. Each case
has folds; draws without any are left out, and those in which balls do not tell a cusp from a point next to one.

Up to its end the first piece of a stop, of a bilinear spring and of play is linear, and has no fold. Play has no
stiffness there: with p = -h/A and q = -h_A, p < q, folds have Omega^2 between them, and R R_A + I I_A = 0 says
(Omega^2 - p)(q - Omega^2) >= 4 zeta^2 Omega^2. So there is none where q <= 4 zeta^2, nor where
(q - p)^2 < 16 zeta^2 p; p rises, so that beyond twice the gap it is at least p there, which bounds the amplitude.
"""

from __future__ import annotations

from itertools import count

from flint import arb

from tests.oracles.averaged import BITS, Jet, Point
from tests.oracles.certified_roots import precision
from tests.oracles.make_random_isolators import write
from tests.oracles.make_stated import Force, Piece, Stated, _uniform, case

#: of each force
EACH = 30


class Bent(Stated):
    """Of a force that is linear up to its bend."""

    def _corner_extrema(self) -> list[Point]:
        return []  # the locus does not come to the bend from below


class DeadZone(Bent):
    """Of a force that vanishes up to the gap; the least slope is p at twice the gap."""

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


#: with their oscillators
FORCES: dict[str, tuple[Force, type[Stated]]] = {
    "stop": (
        Force(
            (lambda u, n: u, lambda u, n: u + n("k") * (u - n("gap"))),
            _uniform(k=(0.3, 5.0), gap=(0.1, 0.5)),
            lambda n: arb(1),
            end="gap",
        ),
        Bent,
    ),
    "bilinear": (
        Force(
            (lambda u, n: u, lambda u, n: u + (n("k") - 1) * (u - n("gap"))),
            _uniform(k=(0.25, 0.75), gap=(0.1, 0.4)),
            lambda n: n("k"),
            end="gap",
        ),
        Bent,
    ),
    "play": (
        Force(
            (lambda u, n: 0 * u, lambda u, n: u - n("gap")),
            _uniform(gap=(0.03, 0.4)),
            lambda n: arb(2) / 3 - arb(3).sqrt() / (2 * arb.pi()),
            end="gap",
        ),
        DeadZone,
    ),
    "even": (
        Force(
            (lambda u, n: u + n("a") * u * u + n("b") * u * u * u,),
            _uniform(a=(-0.5, 1.0), b=(0.3, 0.8)),
            lambda n: 1 - n("a") ** 2 / (3 * n("b")),
        ),
        Stated,
    ),
    "preload": (
        Force(
            (lambda u, n: n("c") + u + n("b") * u * u * u,),
            _uniform(c=(0.005, 0.04), b=(0.2, 1.5)),
            lambda n: arb(1),
            at_rest=True,
        ),
        Stated,
    ),
}


def cases(name: str) -> list[dict]:
    """Those of a force."""
    force, kind = FORCES[name]
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
    write("closed", [one for name in FORCES for one in cases(name)])
