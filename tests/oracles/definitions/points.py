"""Where kernels are held, and one row of the table. Takes a definition; returns its values and their scale."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

from mpmath import mp, mpf

from derivations.ledger import published
from tests.oracles.definitions.forces import rod_coefficients

DIGITS = 40
STEP = mpf(10) ** -20

Function = Callable[..., list]
Definitions = dict[str, tuple[str, Function]]
# each with the parameters it belongs to
Amplitudes = list[tuple[float, tuple[float, ...]]]

Range = tuple[float, float]
#: arguments by what they lie between
_BETWEEN: dict[Range, str] = {
    (-20.0, 20.0): "h_AAA h_3_AAA h_5_AAA",
    (-5.0, 5.0): "h_AA I_0AAA I_0AAp h_AAp",
    (-3.1, -0.05): "phi",
    (-3.0, 3.0): "k_A slope",
    (-2.0, 1.0): "h_A",
    (-2.0, 2.0): "h_3_AA h_5_AA R_A",
    (-1.5, 0.5): "c_y",
    (-1.0, -0.001): "h",
    (-1.0, 0.1): "p",
    (-1.0, 1.0): (
        "s_0 s_2 s_3 s_k c_0 c_k L_0 L_2 L_3 L_k M_0 M_2 M_3 M_k X_x Y_y c_xx c_yy s_0_p s_1_p "
        "s_2_p c_0_p c_1_p c_2_p load_p end_p resists edge S_Omega S_OmegaOmega S_F S_FOmega root "
        "span u cubic other I_0AA v f inner outer before after by_theta by_u h_p h_Ap m_p zeta_p "
        "forcing_p frequency_p I_0p I_0Ap zeta_Ap zeta_AAp d_p d_3p A_p Omega_p F_0_p E_re E_im "
        "D_re D_im"
    ),
    (-0.99, 0.99): "cosine sine slip",
    (-0.9, 0.9): "t a T",
    (-0.5, 0.5): "s_1 S_1 lacks share friction quadratic",
    (-0.5, 2.0): "f_u inner_u outer_u",
    (-0.5, 8.0): "kappa",
    (-0.2, 0.2): "h_3_A h_5_A force_Omega I_A I_0A",
    (-0.1, 0.1): "load beside",
    (-0.02, 0.02): "h_3 h_5 a_3",
    (-0.01, 0.01): "a_5",
    (-1e-21, 1e-21): "tail p_low q_low",
    (0.0, 0.2): "zeta_A",
    (0.0, 0.5): "zeta_AA",
    (0.0, 1.0): "zeta_AAA L_1 M_1",
    (0.0, 3.0): "steepest",
    (0.0, 3.14): "turned",
    (0.0001, 0.003): "q",
    (0.0001, 0.01): "S_0 G",
    (0.0001, 0.03): "linear",
    (0.001, 0.02): "mu",
    (0.001, 0.03): "m",
    (0.001, 0.1): "D_0 force beyond holds preload",
    (0.001, 0.5): "lost",
    (0.001, 1.0): "fall rest",
    (0.004, 0.1): "zeta",
    (0.005, 0.05): "I_0",
    (0.005, 0.2): "eta",
    (0.01, 0.1): "I",
    (0.01, 0.5): "B",
    (0.01, 0.99): "left right",
    (0.01, 0.999): "reduction",
    (0.01, 1.0): "A zeta_2 d_3 A_1 pull growth",
    (0.02, 0.45): "ratio",
    (0.02, 1.2): "theta",
    (0.03, 0.1): "F_0 F_2",
    (0.03, 0.9): "least",
    (0.04, 4.0): "k",
    (0.05, 0.5): "u_cr sigma_u sigma_v end W_1",
    (0.05, 1.0): "within",
    (0.05, 2.0): "c_2 c_3 d",
    (0.1, 1.0): "c",
    (0.1, 1.5): "c_x",
    (0.1, 3.0): "angle",
    (0.1, 4.0): "X R",
    (0.2, 1.5): "c_1 C_1",
    (0.2, 3.0): "level",
    (0.3, 1.5): "Y",
    (0.3, 2.0): "Omega",
    (0.5, 2.0): "S force_F",
    (0.5, 3.0): "x",
    (0.8, 1.2): "side",
    (1.0, 3.0): "intercept",
    (10.0, 1000.0): "nu",
}
RANGES: dict[str, Range] = {name: ends for ends, names in _BETWEEN.items() for name in names.split()}

TABLE_1 = tuple(float(published.TABLE_1[name]) for name in ("lam", "r", "delta_h"))
DESIGNS = (TABLE_1, (1.0, 0.5, 0.05), (4.0, 4.0, 0.0606), (1.0, 1.0, 0.9), (2.0, 1.5, 0.5), (3.0, 2.0, 1e-6))
STEEP_DESIGNS = (*DESIGNS, (1.0, 0.8, 0.33), (1.0, 1.2, 0.34), (1.0, 1.0, 0.99))
DUFFINGS = ((1.0, 0.3, 0.1), (0.2, 2.5, -0.7), (-0.1, 1.0, 0.3), (1.0, -0.4, 0.2))


def parameters_of(design: Sequence[float]) -> tuple[float, ...]:
    """Doubles near the isolator's coefficients; as inputs they are exact."""
    return tuple(float(c) for c in rod_coefficients(*map(mpf, design)))


def around(u_cr: float, thorough: bool) -> list[float]:
    """Amplitudes in every regime, on the corner, close above it, and far beyond."""
    factors = [0.0, 1e-8, 0.3, 1 - 1e-9, 1.0, 1 + 1e-12, 1 + 1e-6, 1.05, 1.249, 1.251, 2.0, 30.0]
    if thorough:
        factors += [1e-3, 0.9, 1 + 1e-9, 1.001, 1.5, 3.0, 10.0, 1e4]
    return [u_cr * factor for factor in factors]


def close_to_one(u_cr: float) -> list[float]:
    """Amplitudes about 1, where elliptic integrals change their kind."""
    return [A for A in (0.699, 0.75, 0.99, 1 - 1e-9, 1.0, 1 + 1e-9, 1.1) if A > 0.9 * u_cr]


def points(rng: random.Random, names: str, count: int, ranges: Mapping[str, Range] = RANGES) -> list[list[float]]:
    return [[rng.uniform(*ranges[name]) for name in names.split()] for _ in range(count)]


def measured(f: Function, at: Sequence[float]) -> tuple[list, list]:
    """Values, and |f| + sum |x df/dx| over the arguments, by a difference quotient in each."""
    x = [mpf(value) for value in at]
    values = f(*x)
    scales = [abs(value) for value in values]
    for k, value in enumerate(x):
        if value != 0:
            shifted = f(*x[:k], value * (1 + STEP), *x[k + 1 :])
            if len(shifted) != len(values):
                raise ValueError("the number of coefficients changes here")
            scales = [s + abs(b - a) / STEP for s, a, b in zip(scales, values, shifted, strict=True)]
    return values, scales


class Table(NamedTuple):
    """Kernels' arguments and definitions; how many points each has, and what puts one by names and its number."""

    definitions: Definitions
    count: int = 6
    place: Callable[[str, list[str], int, list[float]], None] = lambda *_: None
    ranges: Mapping[str, Range] = RANGES

    def points(self, rng: random.Random) -> Iterator[tuple[str, list[str], list[float]]]:
        """Kernels with the names and values of their arguments."""
        for kernel, (names, _) in self.definitions.items():
            for number, x in enumerate(points(rng, names, self.count, self.ranges)):
                self.place(kernel, names.split(), number, x)
                yield kernel, names.split(), x


def beside_backbone(names: list[str], number: int, x: list[float]) -> None:
    """Two points of a kernel of h lie next to the backbone: R is the small difference of two terms."""
    if number < 2 and {"Omega", "A", "h"} <= set(names):
        Omega, A, h = (names.index(name) for name in ("Omega", "A", "h"))
        x[h] = -x[A] * x[Omega] ** 2 * (1 + 1e-9)


def shown(value, digits: int = DIGITS) -> str:
    return "0" if value == 0 else mp.nstr(value, digits)


def specialized(definition: tuple[str, Function], **known: int) -> tuple[str, Function]:
    """A definition where some arguments are known."""
    names, f = definition
    others = [name for name in names.split() if name not in known]

    def of_others(*x: mpf) -> list:
        at = dict(zip(others, x, strict=True)) | {name: mpf(value) for name, value in known.items()}
        return f(*(at[name] for name in names.split()))

    return " ".join(others), of_others
