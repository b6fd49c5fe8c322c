"""R, I and F of any laws of damping as Taylor series in A and Omega, and what kernels are to give in terms of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from mpmath import mp, mpf

from tests.oracles.definitions.points import Function
from tests.oracles.definitions.series import Series, variables

#: what rounding leaves of a zero
TINY = mpf(10) ** -45
BY_A = "", "_A", "_AA", "_AAA"
#: derivatives of F, by A and by Omega
ORDERS = {
    **{"F": (0, 0), "F_A": (1, 0), "F_AA": (2, 0), "F_AAA": (3, 0), "F_Omega": (0, 1), "F_OmegaOmega": (0, 2)},
    **{"F_AOmega": (1, 1), "F_AOmegaOmega": (1, 2)},
}


def balances(w: Any, a: Any, rest: Any, zeta: Any, h: Any, d: Any = 0, d_3: Any = 0) -> tuple[Any, Any]:
    """R and I: what balances F_0 cos phi and F_0 sin phi at a steady state, with the sign reversed.

    rest is the part of I that friction and structural damping have, at Omega = 0; d and d_3 are of quadratic and cubic
    damping.
    """
    return a * w**2 + h, rest + 2 * zeta * a * w + d * (a * w) ** 2 + d_3 * (a * w) ** 3


def near(A: Any, values: Iterable[Any]) -> Callable[[Any], Any]:
    """An h with the given value and derivatives at A."""
    return lambda a: sum(value * (a - A) ** k / mp.factorial(k) for k, value in enumerate(values))


class Laws:
    """R, I and F as series about the values of a kernel's arguments, by name: x is 1/Omega, and what is not there is 0.

    Where R and I are arguments they stand for the values at (Omega, A), and their slopes are those of A Omega^2 + h
    and of I_0 + 2 zeta A Omega + d (A Omega)^2 + d_3 (A Omega)^3.
    """

    def __init__(self, at: dict[str, Any], order: int = 3, by_inertia: bool = False) -> None:
        self.d, self.d_3 = at.get("d", 0), at.get("d_3", 0)
        place = at.get("A", 1), at["Omega"] if "Omega" in at else 1 / at["x"] if "x" in at else 0
        self.A, self.Omega = variables(place, order)
        known = {"I_0": at.get("m", 0)} | at
        self.h, self.rest, self.zeta = (
            near(place[0], [known.get(f"{name}{by}", 0) for by in orders])(self.A)
            for name, orders in (("h", BY_A), ("I_0", ("", "A", "AA", "AAA")), ("zeta", BY_A))
        )
        self.own = balances(self.Omega, self.A, self.rest, self.zeta, self.h, self.d, self.d_3)
        self.R, self.I = (
            one + (at[name] - one.value) if name in at else one for name, one in zip("RI", self.own, strict=True)
        )
        self.F = self.R**2 + self.I**2 - (at.get("F_0", 0) * (self.Omega**2 if by_inertia else 1)) ** 2

    def __call__(self, name: str) -> Any:
        """A derivative of F, by its name."""
        return self.F.derivative(*ORDERS[name])

    @property
    def level(self) -> Series:
        """Of an excitation by inertia, squared."""
        return sum(one**2 for one in self.own) / self.Omega**4

    @property
    def fall(self) -> Series:
        """Omega^5 times the slope of that by Omega."""
        return self.Omega**5 * self.level.by(1)

    @property
    def hessian(self) -> Any:
        """The determinant of F's second derivatives."""
        return self._with(self("F_OmegaOmega"))

    @property
    def fall_hessian(self) -> Any:
        """The same of the level: where its slope vanishes that is Omega F_Omega."""
        return self._with(self.fall.derivative(0, 1) / self.Omega.value)

    def _with(self, F_OmegaOmega: Any) -> Any:
        return self("F_AA") * F_OmegaOmega - self("F_AOmega") ** 2


def by_laws(names: str, f: Callable[[Laws], Any], order: int = 3, by_inertia: bool = False) -> tuple[str, Function]:
    """A kernel's arguments, and its values by R, I and F."""

    def of(*x: Any) -> list[Any]:
        found = f(Laws(dict(zip(names.split(), x, strict=True)), order, by_inertia))
        return found if isinstance(found, list) else [found]

    return names, of


def by_arguments(names: str, f: Callable[[dict[str, Any]], Any]) -> tuple[str, Function]:
    """The same by the arguments as they are named."""

    def of(*x: Any) -> list[Any]:
        found = f(dict(zip(names.split(), x, strict=True)))
        return found if isinstance(found, list) else [found]

    return names, of


def derivative(name: str, names: str) -> tuple[str, Function]:
    """One of F's."""
    return by_laws(names, lambda laws: laws(name), sum(ORDERS[name]) or 1)


def linear_root(f: Callable[[Any], Any]) -> Any:
    """Where a linear function vanishes."""
    at_0, at_1 = f(mpf(0)), f(mpf(1))
    return at_0 / (at_0 - at_1)


def with_zeros(at: dict[str, Any], **names: str) -> Laws:
    """The laws with further arguments, in each of which a derivative of F is linear, that make it vanish."""
    for unknown, name in names.items():
        at = at | {
            unknown: linear_root(lambda value, at=at, unknown=unknown, name=name: Laws({**at, unknown: value})(name))
        }
    return Laws(at)


def stays(one: Series) -> Any:
    """dOmega/dA where a series stays."""
    by_A, by_Omega = one.slopes()
    return -by_A / by_Omega


def with_slope(one: Series, turn: Any) -> list[Any]:
    """The value, and its slope by A where Omega has one."""
    by_A, by_Omega = one.slopes()
    return [one.value, by_A + turn * by_Omega]


def polynomial(name: str, powers: Iterable[int], names: str, divisor: Callable[[dict[str, Any]], Any] = lambda _: 1):
    """Coefficients of a derivative of F as a polynomial in Omega; no other power is there."""
    by_A, by_Omega = ORDERS[name]

    def of(at: dict[str, Any]) -> list[Any]:
        F = Laws(at, 7).F
        found = [F.derivative(by_A, k + by_Omega) / mp.factorial(k) / divisor(at) for k in range(7 - by_Omega)]
        assert all(found[k] == 0 for k in range(len(found)) if k not in powers)
        return [found[k] for k in powers]

    return by_arguments(names, of)
