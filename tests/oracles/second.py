"""The second approximation at 30 digits. Takes a force and an oscillator's numbers; returns states and folds.

By the definition of its kernels, which is typed from what it is: the harmonics of spring and friction driving the
linear oscillator that averaging has put in the spring's place; h_n by quadrature. Nothing is taken from the derivation
or from what it generates.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any

from mpmath import mp

from slowflow.example import TABLE_1
from tests.files import store
from tests.oracles.definitions.slow_flow import second

mp.dps = 34


@dataclass(frozen=True)
class Second:
    """pieces of an odd force, by rising |u|, and the |u| at which they end; mu, zeta."""

    pieces: Sequence[Callable[[Any], Any]]
    ends: Sequence[Any]
    mu: Any
    zeta: Any

    def h(self, n: int, A: Any) -> Any:
        """Harmonic n of the force of u = A cos psi, with its sign turned."""
        edges = [mp.pi / 2, *(mp.acos(end / A) for end in reversed(self.ends) if end < A)]
        passed = sum(end < A for end in self.ends)
        edges = [mp.mpf(0), *reversed(edges)]
        total = mp.mpf(0)
        for k, (low, high) in enumerate(pairwise(edges)):
            piece = self.pieces[passed - k]
            total += mp.quad(lambda psi, f=piece: f(A * mp.cos(psi)) * mp.cos(n * psi), [low, high])
        return -4 * total / mp.pi

    def balance(self, Omega: Any, A: Any) -> tuple[Any, Any, Any, Any]:
        """R, I, largest displacement and amplitude of the first harmonic, at A = A_1 + a_3 + a_5."""
        m, (h, h_3, h_5) = 4 * self.mu / mp.pi, (partial(self.h, n) for n in (1, 3, 5))
        return second(Omega, A, m, self.zeta, h, h_3, h_5)

    def F(self, Omega: Any, A: Any, F_0: Any) -> Any:
        """Zero at a steady state."""
        R, I, _, _ = self.balance(Omega, A)
        return R**2 + I**2 - F_0**2

    def state(self, Omega: Any, F_0: Any, near: Any) -> tuple[Any, Any]:
        """Largest displacement and first harmonic of the state at Omega whose A is near the one given."""
        A = mp.findroot(lambda x: self.F(Omega, x, F_0), (near, near * (1 + mp.mpf(10) ** -6)))
        return self.balance(Omega, A)[2:]

    def fold(self, F_0: Any, Omega: Any, A: Any) -> tuple[Any, Any]:
        """Frequency and largest displacement of the fold near the ones given, F = F_A = 0."""

        def both(w: Any, x: Any) -> tuple[Any, Any]:
            return self.F(w, x, F_0), mp.diff(lambda y: self.F(w, y, F_0), x)

        w, x = mp.findroot(both, (Omega, A), tol=mp.mpf(10) ** -40)
        return w, self.balance(w, x)[2]


def table_1() -> Second:
    """The isolator of Table 1: polynomials (6) attached, linear detached."""
    lam, r, delta_h, mu, zeta = (mp.mpf(TABLE_1[name]) for name in ("lam", "r", "delta_h", "mu", "zeta"))
    alpha, beta = 1 - lam * r * delta_h, lam * r * (1 - delta_h) / 2
    gamma, u_cr = 3 * lam * r * (1 - delta_h) / 8, mp.sqrt(delta_h * (2 - delta_h))
    return Second((lambda u: u * (alpha + u**2 * (beta + gamma * u**2)), lambda u: u), (u_cr,), mu, zeta)


def duffing() -> Second:
    """Duffing(1, 0.5, 0.01, 0.02)."""
    return Second((lambda u: u + mp.mpf(0.5) * u**3,), (), mp.mpf(0.01), mp.mpf(0.02))


#: forcing, a frequency with its states, folds: where to look for them
CASES: dict[str, tuple[Callable[[], Second], float, float, list[float], list[tuple[float, float]]]] = {
    "table 1": (table_1, 0.04, 0.9, [0.19, 0.25, 0.48], [(0.8662, 0.2041), (0.9930, 0.5593)]),
    "duffing": (duffing, 0.1, 1.3, [0.143, 1.322, 1.407], [(1.1317, 0.515), (1.38964, 1.591)]),
}


def case(name: str) -> dict[str, Any]:
    """States at the frequency and folds of one of CASES."""
    make, F_0, Omega, states, folds = CASES[name]
    second, forcing = make(), mp.mpf(F_0)
    return {
        "of": name,
        "F_0": F_0,
        "Omega": Omega,
        "states": [[mp.nstr(x, 30) for x in second.state(mp.mpf(Omega), forcing, mp.mpf(A))] for A in states],
        "folds": [[mp.nstr(x, 30) for x in second.fold(forcing, *map(mp.mpf, fold))] for fold in folds],
    }


if __name__ == "__main__":
    store("second", [case(name) for name in CASES])
