"""Where kernels are held, and one row of the table. Takes a definition; returns its values and their scale."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence

from flint import fmpq
from mpmath import mp, mpf

from derivations.ledger import published
from tests.oracles.definitions.forces import rod_coefficients

DIGITS = 40
STEP = mpf(10) ** -20
EXACT_STEP = fmpq(1, 2**70)
SCENES = {"": (), "_mu0": ("m", "mu"), "_zeta0": ("zeta",), "_mu0_zeta0": ("m", "mu", "zeta")}

Function = Callable[..., list]
# each with the parameters it belongs to
Amplitudes = list[tuple[float, tuple[float, ...]]]

RANGES = {
    "Omega": (0.3, 2.0),
    "A": (0.01, 1.0),
    "F_0": (0.03, 0.1),
    "F_2": (0.03, 0.1),
    "m": (0.001, 0.03),
    "mu": (0.001, 0.02),
    "zeta": (0.004, 0.1),
    **{"zeta_A": (0.0, 0.2), "zeta_AA": (0.0, 0.5), "zeta_AAA": (0.0, 1.0), "zeta_2": (0.01, 1.0), "d_3": (0.01, 1.0)},
    "h": (-1.0, -0.001),
    "steepest": (0.0, 3.0),
    "reduction": (0.01, 0.999),
    "h_A": (-2.0, 1.0),
    "h_AA": (-5.0, 5.0),
    "h_AAA": (-20.0, 20.0),
    **{f"{name}_{n}": (-1.0, 1.0) for name in ("s", "c", "L", "M") for n in (0, 2, 3, "k")},
    **{"X": (0.3, 1.5), "Y": (0.3, 1.5), "c_x": (0.1, 1.5), "c_y": (-1.5, 0.5)},
    **{name: (-1.0, 1.0) for name in ("X_x", "Y_y", "c_xx", "c_yy")},
    **{"c_1": (0.2, 1.5), "s_1": (-0.5, 0.5), "L_1": (0.0, 1.0), "M_1": (0.0, 1.0)},
    **{
        "load": (-0.1, 0.1),
        **{f"{name}_{n}_p": (-1.0, 1.0) for name in ("s", "c") for n in range(3)},
        **{"load_p": (-1.0, 1.0), "end_p": (-1.0, 1.0), "side": (0.8, 1.2)},
        "t": (-0.9, 0.9),
        "resists": (-1.0, 1.0),
        "B": (0.01, 0.5),
        "D_0": (0.001, 0.1),
        "edge": (-1.0, 1.0),
        "C_1": (0.2, 1.5),
        "S_1": (-0.5, 0.5),
        "a": (-0.9, 0.9),
        "angle": (0.1, 3.0),
        "k": (1, 5),
    },
    **{
        f"h_{n}{order}": (-size, size)
        for n in (3, 5)
        for order, size in (("", 0.02), ("_A", 0.2), ("_AA", 2.0), ("_AAA", 20.0))
    },
    **{"turned": (0.0, 3.14), "kappa": (-0.5, 8.0)},
    **{"a_3": (-0.02, 0.02), "a_5": (-0.01, 0.01)},
    "S": (0.5, 2.0),
    **{"force": (0.03, 0.1), "force_Omega": (-0.2, 0.2), "force_F": (0.5, 2.0)},
    **{f"S_{name}": (-1.0, 1.0) for name in ("Omega", "OmegaOmega", "F", "FOmega")},
    "root": (-1.0, 1.0),
    "span": (-1.0, 1.0),
    "p": (-1.0, 0.1),
    "q": (0.0001, 0.003),
    # k = h - A h_A, in size above F_0 and A |T|
    "intercept": (1.0, 3.0),
    "k_A": (-3.0, 3.0),
    "lacks": (-0.5, 0.5),
    "X": (0.1, 4.0),
    "T": (-0.9, 0.9),
    "R": (0.1, 4.0),
    # 1/Omega, and what the least level of an excitation by inertia follows from
    "u": (-1.0, 1.0),
    "x": (0.5, 3.0),
    "fall": (0.001, 1.0),
    "linear": (0.0001, 0.03),
    "rest": (0.001, 1.0),
    "lost": (0.001, 0.5),
    **{"cubic": (-1.0, 1.0), "other": (-1.0, 1.0), "share": (-0.5, 0.5)},
    # other laws of damping
    "eta": (0.005, 0.2),
    **{"c_2": (0.05, 2.0), "c_3": (0.05, 2.0)},
    "d": (0.05, 2.0),
    "u_cr": (0.05, 0.5),
    "I": (0.01, 0.1),
    "I_0": (0.005, 0.05),
    "I_A": (-0.2, 0.2),
    "R_A": (-2.0, 2.0),
    "beside": (-0.1, 0.1),
    "h_over_A": (-2.0, 1.0),
    **dict.fromkeys(("I_0_over_A", "I_over_A"), (0.01, 0.5)),
    "A_1": (0.01, 1.0),
    "phi": (-3.1, -0.05),
    "I_0A": (-0.2, 0.2),
    "I_0AA": (-1.0, 1.0),
    "I_0AAA": (-5.0, 5.0),
    **dict.fromkeys(("friction", "quadratic"), (-0.5, 0.5)),
    **dict.fromkeys(("cosine", "sine", "slip"), (-0.99, 0.99)),
    **dict.fromkeys(("v", "f", "inner", "outer"), (-1.0, 1.0)),
    **dict.fromkeys(("f_u", "inner_u", "outer_u"), (-0.5, 2.0)),
    **dict.fromkeys(("left", "right"), (0.01, 0.99)),
    "nu": (10.0, 1000.0),
    **dict.fromkeys(("before", "after", "by_theta", "by_u"), (-1.0, 1.0)),
    **dict.fromkeys(("beyond", "holds", "preload", "force"), (0.001, 0.1)),
    **dict.fromkeys(("pull", "growth"), (0.01, 1.0)),
    "least": (0.03, 0.9),
    **dict.fromkeys(("tail", "p_low", "q_low"), (-1e-21, 1e-21)),
    "k": (0.04, 4.0),
    # what a parameter does, and what an answer does then
    **dict.fromkeys(("h_p", "h_Ap", "m_p", "zeta_p", "end_p", "forcing_p", "frequency_p"), (-1.0, 1.0)),
    **dict.fromkeys(("I_0p", "I_0Ap", "zeta_Ap", "zeta_AAp", "d_p", "d_3p", "A_p", "Omega_p", "F_0_p"), (-1.0, 1.0)),
    "I_0AAp": (-5.0, 5.0),
    "h_AAp": (-5.0, 5.0),
    # random vibration
    **dict.fromkeys(("sigma_u", "sigma_v", "end"), (0.05, 0.5)),
    **{"S_0": (1e-4, 1e-2), "c": (0.1, 1.0), "ratio": (0.02, 0.45)},
    **{"theta": (0.02, 1.2), "slope": (-3.0, 3.0), "G": (1e-4, 1e-2)},
    **dict.fromkeys(("E_re", "E_im", "D_re", "D_im"), (-1.0, 1.0)),
    **{"W_1": (0.05, 0.5), "level": (0.2, 3.0), "within": (0.05, 1.0)},
}

TABLE_1 = tuple(float(published.TABLE_1[name]) for name in ("lam", "r", "delta_h"))
DESIGNS = (TABLE_1, (1.0, 0.5, 0.05), (4.0, 4.0, 0.0606), (1.0, 1.0, 0.9), (2.0, 1.5, 0.5), (3.0, 2.0, 1e-6))
STEEP_DESIGNS = (*DESIGNS, (1.0, 0.8, 0.33), (1.0, 1.2, 0.34), (1.0, 1.0, 0.99))
DUFFINGS = ((1.0, 0.3), (0.2, 2.5), (-0.1, 1.0), (1.0, -0.4))


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


def points(rng: random.Random, names: str, count: int) -> list[list[float]]:
    return [[rng.uniform(*RANGES[name]) for name in names.split()] for _ in range(count)]


def measured(f: Function, at: Sequence[float], exact: bool = False) -> tuple[list, list]:
    """Values, and |f| + sum |x df/dx| over the arguments, by a difference quotient in each."""
    x = [fmpq(*value.as_integer_ratio()) if exact else mpf(value) for value in at]
    step = EXACT_STEP if exact else STEP
    values = f(*x)
    scales = [abs(value) for value in values]
    for k, value in enumerate(x):
        if value != 0:
            shifted = f(*x[:k], value * (1 + step), *x[k + 1 :])
            if len(shifted) != len(values):
                raise ValueError("the number of coefficients changes here")
            scales = [s + abs(b - a) / step for s, a, b in zip(scales, values, shifted, strict=True)]
    return values, scales


def entry(f: Function, at: Sequence[float], exact: bool = False) -> dict:
    """One row: values, and their scale."""
    values, scales = measured(f, at, exact)
    return {"at": list(at), "is": [shown(v) for v in values], "scale": [shown(s, 6) for s in scales]}


def shown(value, digits: int = DIGITS) -> str:
    if isinstance(value, fmpq):
        value = mpf(int(value.p)) / int(value.q)
    if value == 0:
        return "0"
    return mp.nstr(value, digits)


def zeroed(f: Function, names: Sequence[str], scene: str) -> Function:
    """The function with the scene's arguments put to zero, whatever is passed for them."""
    gone = [k for k, name in enumerate(names) if name in SCENES[scene]]
    return lambda *x: f(*(value * 0 if k in gone else value for k, value in enumerate(x)))
