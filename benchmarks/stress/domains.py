"""Where arguments of kernels are drawn: a box for each name, and the hard places in it; points as tuples of doubles.

A kernel's domain is the box, cut to where its formula is defined. `EXTREME` is the same beyond all bounds, 1e±150 and
subnormals, measured apart.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from derivations.paper.restoring_force import FAR
from tests.oracles.definitions.points import RANGES

Point = dict[str, float]
Draw = Callable[[np.random.Generator], float]

#: smallest and largest size, whether negative numbers and whether zero belong to it
Limits = tuple[float, float, bool, bool]
BOX: dict[str, Limits] = {
    "Omega": (1e-3, 1e3, False, False),
    "A": (1e-9, 1e3, False, False),
    "F_0": (1e-9, 1e3, False, False),
    "m": (1e-12, 1.0, False, True),
    "mu": (1e-12, 1.0, False, True),
    "zeta": (1e-12, 1.0, False, True),
    "h": (1e-12, 1e3, True, True),
    "h_A": (1e-9, 1e6, True, True),
    "h_AA": (1e-9, 1e9, True, True),
    "h_AAA": (1e-9, 1e12, True, True),
    "alpha": (1e-16, 1e3, True, True),
    "beta": (1e-12, 1e3, True, True),
    "gamma": (1e-12, 1e3, False, True),
    "u_cr": (1e-6, 1 - 2.0**-53, False, False),
    "lam": (1.0, 100.0, False, False),
    "r": (1e-6, 1e6, False, False),
    "delta_h": (1e-12, 1 - 2.0**-53, False, False),
    "u": (1e-9, 1e3, True, True),
    "p": (1e-9, 1e3, True, False),
    "q": (1e-12, 1e3, False, True),
    "p_A": (1e-9, 1e6, True, True),
    "span": (1e-9, 1e3, True, True),
    "root": (1e-9, 1e3, True, False),
    "k": (1e-9, 1e3, True, False),
    "k_A": (1e-9, 1e6, True, True),
    "lacks": (1e-9, 1e3, True, True),
    "preload": (1e-12, 1.0, False, True),
    "reduction": (1e-12, 1 - 2.0**-53, False, True),
    "X": (1e-6, 1e6, False, False),
    "T": (1e-9, 1e6, True, True),
    "R": (1e-9, 1e6, True, True),
}
SIGNED, POSITIVE = (1e-9, 1e3, True, True), (1e-9, 1e3, False, False)
#: of other laws of damping, and what a parameter does to them
OF_LAWS: dict[str, Limits] = {
    **{"x": (1e-3, 1e3, False, False), "I": (1e-12, 1e3, False, True), "I_0": (1e-12, 1.0, False, True)},
    **{"eta": (1e-12, 1.0, False, True), "d": (1e-12, 1e3, False, True), "c_2": (1e-12, 1e3, False, True)},
    **dict.fromkeys(("c_3", "d_3", "zeta_2"), (1e-12, 1e3, False, True)),
    **dict.fromkeys(("zeta_A", "zeta_AA", "zeta_AAA"), (1e-9, 1e6, False, True)),
    **{"I_0A": BOX["h_A"], "I_0AA": BOX["h_AA"], "I_0AAA": BOX["h_AAA"], "I_A": BOX["h_A"], "R_A": BOX["h_A"]},
    **{"beside": BOX["h_A"], "steepest": (1e-9, 1e6, False, True)},
    **dict.fromkeys(("h_p", "h_Ap", "h_AAp", "I_0p", "I_0Ap", "I_0AAp", "zeta_p", "zeta_Ap", "zeta_AAp"), SIGNED),
    **dict.fromkeys(("d_p", "d_3p"), SIGNED),
    **dict.fromkeys(("end_p", "forcing_p", "frequency_p", "A_p", "Omega_p", "F_0_p"), SIGNED),
    **dict.fromkeys(("S_Omega", "S_OmegaOmega", "S_F", "S_FOmega", "force_Omega", "force_F"), SIGNED),
    "force": POSITIVE,
}
#: of motions off the centre, and of forces known by values
OFF_CENTRE: dict[str, Limits] = {
    **dict.fromkeys((f"{name}_{order}" for name in ("c", "s") for order in range(4)), SIGNED),
    **dict.fromkeys((f"{name}_{order}_p" for name in ("c", "s") for order in range(3)), SIGNED),
    **dict.fromkeys(("c_x", "c_y", "c_xx", "c_yy", "X_x", "Y_y", "I_A", "load", "load_p", "end_p", "a"), SIGNED),
    **dict.fromkeys((f"{name}_{order}" for name in ("L", "M") for order in (1, 2, "k")), SIGNED),
    **dict.fromkeys(("X", "Y", "B", "force", "root", "intercept", "least"), POSITIVE),
    **dict.fromkeys(("C_1", "S_1", "D_0", "resists"), SIGNED),
    **{"t": (1e-9, 1.0, True, True), "edge": (1e-9, 1.0, True, True), "side": (1.0, 1.0, True, False)},
    **{"I": (1e-12, 1e3, False, True), "eta": (1e-12, 1.0, False, True), "d": (1e-12, 1e3, False, True)},
    **{"F_2": (1e-9, 1e3, False, True), "angle": (1e-9, math.pi, False, False), "k": (1.0, 1e3, True, True)},
}
SAMPLED: dict[str, Limits] = {
    **dict.fromkeys(("sine", "cosine"), (1e-9, 1.0, False, False)),
    "b": POSITIVE,
    **dict.fromkeys(("f", "f_u", "f_uu", "f_uuu", "f_uuuu"), SIGNED),
    **dict.fromkeys((f"lost_{order}" for order in range(4)), SIGNED),
}
#: of modules whose arguments are others, or have other signs
APART = (
    (("duffing",), {"gamma": BOX["beta"]}),
    (("dissipation", "sensitivities"), OF_LAWS),
    (("off_centre",), OFF_CENTRE),
    (("sampled",), SAMPLED),
)
OF_MODULE = {module: box for modules, box in APART for module in modules}
#: modules whose numbers have no scale to vary over: the ranges of the kernels' oracle serve
PLAIN = ("motion", "den_hartog", "second_approximation", "inertia")
#: what a double lacks of its number
LACKED = ("tail", "p_low", "q_low")
#: sizes of the extreme arguments
EXTREME = (1e-150, 1e-100, 1e100, 1e150, 2.0**-1074, 2.0**-1022)
DESIGN = ("lam", "r", "delta_h")
TINY = (0.0, 1e-12, 1e-6)


def limits(module: str, name: str) -> Limits:
    """The box of an argument."""
    if name == "tau":
        return 1e-9, 30.0, False, False
    if module.startswith(PLAIN):
        low, high = RANGES[{"friction": "mu"}.get(name, name)]
        return min(abs(low), abs(high)) if low * high > 0 else 0.0, max(abs(low), abs(high)), low < 0, low <= 0 <= high
    return (0.0, 1e-10, True, True) if name in LACKED else OF_MODULE.get(module, BOX).get(name) or BOX[name]


def in_words(module: str, names: Iterable[str]) -> str:
    """The box of some arguments, those of the same range together."""
    ranges: dict[str, list[str]] = {}
    for name in names:
        low, high, negative, zero = limits(module, name)
        sizes = f"up to {high:.4g}" if low == 0 else f"{low:.4g} to {high:.4g}"
        ranges.setdefault(sizes + " of either sign" * negative + " or 0" * (zero and low > 0), []).append(name)
    return "; ".join(f"{', '.join(names)} {sizes}" for sizes, names in ranges.items())


def inside(module: str, names: Sequence[str], at: Sequence[float]) -> bool:
    """Whether a point lies in the box, and what doubles lack is less than they hold."""
    arguments = dict(zip(names, at, strict=True))
    for name, x in arguments.items():
        if name.endswith("_low") and abs(x) > math.ulp(arguments[name.removesuffix("_low")]):
            return False
        low, high, negative, zero = limits(module, name)
        if not math.isfinite(x) or (x < 0 and not negative) or (x == 0 and not zero) or abs(x) > high:
            return False
        if x and abs(x) < low:
            return False
    x = dict(zip(names, at, strict=True))
    if "h_3" in x and not -0.5 < -x["h"] / (x["A"] * x["Omega"] ** 2) < 8:
        return False
    if module in OF_MODULE and not _defined(x):
        return False
    if "T" in x and "R" not in x and x.get("h_AA", x["T"]) == 0:  # one form of R divides by it
        return False
    return "tau" not in x or x["tau"] <= math.pi / (2 * x["Omega"])


def _defined(x: Point) -> bool:
    """Whether what is attached has left, the force has bent within the motion, and what counts does so."""
    if "L_2" in x and not (x["k"] >= 1 and x["k"].is_integer()):
        return False
    if "L_k" in x and x["k"] not in (0, -1):
        return False
    return x.get("u_cr", 0) <= x.get("A", math.inf) and ("b" not in x or x["b"] < x["A"])


def drawn(module: str, name: str, rng: np.random.Generator) -> float:
    """A number of any size in the box; now and then zero, or with few bits."""
    low, high, negative, zero = limits(module, name)
    if name in LACKED:
        return 0.0
    if module.startswith(PLAIN):
        x = float(rng.uniform(low, high))
        return -x if negative and rng.random() < 0.5 else x
    if zero and rng.random() < 0.1:
        return 0.0
    if name == "delta_h" or name == "u_cr":
        x = float(rng.choice([10 ** rng.uniform(math.log10(low), 0), 1 - 10 ** rng.uniform(-15.5, 0), rng.random()]))
    elif rng.random() < 0.5:  # of order one
        x = float(10 ** rng.uniform(max(math.log10(low), -2), min(math.log10(high), 1)))
    else:
        x = float(10 ** rng.uniform(math.log10(low), math.log10(high)))
    x = min(max(x, low), high)
    return -x if negative and rng.random() < 0.5 else x


def ulps(x: float, k: int) -> float:
    """The k-th double after x."""
    for _ in range(abs(k)):
        x = math.nextafter(x, math.inf if k > 0 else -math.inf)
    return x


def few(rng: np.random.Generator) -> int:
    """A small number of ulps."""
    return int(rng.integers(-3, 4))


def point(module: str, names: Sequence[str], coefficients: Mapping[str, Callable[..., Sequence[float]]],
          rng: np.random.Generator) -> tuple[str, tuple[float, ...]]:  # fmt: skip
    """A random point and the name of its place; `coefficients` make a mechanism's parameters from a design."""
    x: Point = {name: drawn(module, name, rng) for name in names}
    base = next((name for name in sorted(coefficients, key=len, reverse=True) if module.startswith(name)), None)
    if base is not None and "alpha" in x:
        _design(x, base, coefficients[base], rng)
    if "tau" in x:  # within half a half-cycle
        x["tau"] = float(10 ** rng.uniform(-6, 0)) * math.pi / (2 * x["Omega"])
    if "h_3" in x:  # below the third harmonic's resonance
        x["h"] = -x["A"] * x["Omega"] ** 2 * float(rng.choice([rng.uniform(-0.5, 8), 1 + 10 ** rng.uniform(-15, -1)]))
    if "tail" in x:
        x["tail"] = x["Omega"] * 2.0**-53 * rng.uniform(-1, 1)
    for name in ("p", "q"):
        if f"{name}_low" in x:
            x[f"{name}_low"] = x[name] * 2.0**-54 * rng.uniform(-1, 1)
    if "b" in x:  # within the motion
        x["b"] = min(x["b"], x["A"] * float(rng.random()))
    if "u_cr" in x and module in OF_MODULE:  # beyond it
        x["A"] = max(x["A"], x["u_cr"])
    if "k" in x and module == "off_centre":
        x["k"] = float(rng.integers(-1, 1) if "L_k" in x else rng.integers(1, 40))
    known = {*x, "u_cr"} - {"delta_h"} if "alpha" in x and "delta_h" in x else x.keys()
    fitting = [place for place, (needed, _) in LOCATIONS.items() if needed <= known]
    if module.startswith(PLAIN) or not fitting or rng.random() < 0.25:
        return "anywhere", tuple(x.values())
    place = str(rng.choice(fitting))
    LOCATIONS[place][1](x, rng)
    return place, tuple(x.values())


def extreme(module: str, names: Sequence[str], rng: np.random.Generator) -> tuple[float, ...]:
    """A point with some of its arguments beyond all bounds, the others of order one."""
    at = []
    for name in names:
        negative = limits(module, name)[2]
        x = float(rng.choice(EXTREME)) if rng.random() < 0.4 else float(rng.uniform(0.5, 2))
        if name in ("u_cr", "delta_h"):
            x = min(x, 0.3)
        at.append(-x if negative and rng.random() < 0.5 else x)
    return tuple(at)


def _design(x: Point, base: str, coefficients: Callable[..., Sequence[float]], rng: np.random.Generator) -> None:
    """Parameters of a mechanism from a design; every other one quasi-zero stiffness, to the ulp, or negative."""
    own = [name for name in ("alpha", "beta", "gamma", "u_cr", "delta_h") if name in x]
    if own[-1] in ("beta", "gamma"):
        if rng.random() < 0.3:
            x["alpha"] = float(rng.choice([0.0, 2.0**-53, -(2.0**-53), 1e-12]))
        return
    lam, r, delta_h = drawn(base, "lam", rng), drawn(base, "r", rng), drawn(base, "delta_h", rng)
    kind = rng.integers(0, 4)
    if kind < 3:  # alpha = 1 - lam r delta_h: of either sign, zero to the ulp, anything
        lam, r = 1.0, float(rng.uniform(0.3, 0.95) / delta_h) if kind == 0 else 1 / delta_h
    if kind == 1:
        r = ulps(r, few(rng))
    if kind == 2:
        r *= float(rng.uniform(1, 3))
    x.update(zip(own, (float(value) for value in coefficients(lam, r, delta_h)), strict=True))
    if "A" in x:
        x["A"] = _corner(x) * float(10 ** rng.uniform(-3, 2))


def _corner(x: Point) -> float:
    """u_cr, from the preload where that stands for it."""
    return x["u_cr"] if "u_cr" in x else math.sqrt(2 * x["delta_h"] - x["delta_h"] ** 2)


# --- places: each changes a point in place ----------------------------------------------------------------------------


def _above_corner(x: Point, rng: np.random.Generator) -> None:
    x["A"] = ulps(_corner(x), int(rng.integers(-1, 3)))


def _near_corner(x: Point, rng: np.random.Generator) -> None:
    x["A"] = _corner(x) * (1 + float(rng.choice([-1, 1])) * float(10 ** rng.uniform(-15, 0)))


def _small_amplitude(x: Point, rng: np.random.Generator) -> None:
    x["A"] = float(10 ** rng.uniform(-9, -3))


def _regimes_meet(x: Point, rng: np.random.Generator) -> None:
    x["A"] = ulps(float(FAR) * _corner(x), few(rng))


def _displacement(x: Point, rng: np.random.Generator) -> None:
    x["u"] = float(rng.choice([-1, 1])) * ulps(_corner(x), -int(rng.integers(0, 3)))


def _backbone(x: Point, rng: np.random.Generator) -> None:
    x["h"] = ulps(-x["A"] * x["Omega"] ** 2, few(rng))


def _near_backbone(x: Point, rng: np.random.Generator) -> None:
    x["h"] = -x["A"] * x["Omega"] ** 2 * (1 + float(10 ** rng.uniform(-15, -1)))


def _backbone_of_mechanism(x: Point, rng: np.random.Generator) -> None:
    x["Omega"] = ulps(math.sqrt(abs(x["alpha"]) or 1.0), few(rng))


def _other_factor(x: Point, rng: np.random.Generator) -> None:
    x["h_A"] = ulps(-(x["Omega"] ** 2), few(rng))


def _isola(x: Point, rng: np.random.Generator) -> None:
    x["h_A"] = x["Omega"] ** 2 * (1 + few(rng) * 2.0**-52)


def _response(x: Point, rng: np.random.Generator) -> None:
    R, I = x["A"] * x["Omega"] ** 2 + x["h"], 2 * x["zeta"] * x["A"] * x["Omega"] + x["m"]
    x["F_0"] = ulps(math.hypot(R, I), few(rng))


def _sticking(x: Point, rng: np.random.Generator) -> None:
    x["F_0"] = ulps(x["m"] if "m" in x else 4 * x["mu"] / math.pi, int(rng.integers(1, 3)))


def _weak(x: Point, rng: np.random.Generator) -> None:
    x["F_0"] = abs(x["h"]) * float(10 ** rng.uniform(-14, -6))


def _strong(x: Point, rng: np.random.Generator) -> None:
    x["F_0"] = abs(x["h"]) * float(10 ** rng.uniform(3, 9))


def _statics(x: Point, rng: np.random.Generator) -> None:
    x["F_0"] = ulps(math.hypot(x["m"], x["h"]), few(rng))


def _undamped(x: Point, rng: np.random.Generator) -> None:
    x["zeta"] = float(rng.choice(TINY))


def _frictionless(x: Point, rng: np.random.Generator) -> None:
    x["m" if "m" in x else "mu"] = float(rng.choice(TINY))


def _triple(x: Point, rng: np.random.Generator) -> None:
    """A fold with F_AA = 0 but for rounding: a cusp."""
    R, T = x["A"] * x["Omega"] ** 2 + x["h"], x["Omega"] ** 2 + x["h_A"]
    if R:
        x["h_AA"] = -(T**2 + 4 * x["zeta"] ** 2 * x["Omega"] ** 2) / R


def _double_cubic(x: Point, rng: np.random.Generator) -> None:
    """A w^3 + p w + q with a double root but for rounding."""
    w = float(10 ** rng.uniform(-1, 1))
    x["p"], x["q"] = -3 * x["A"] * w**2, ulps(2 * x["A"] * w**3, few(rng))


def _softest(x: Point, rng: np.random.Generator) -> None:
    x["delta_h"] = float(rng.choice([1e-12, 1e-9, 1 - 1e-9, 1 - 2.0**-53, ulps(1.0, -2)]))


def _quasi_zero(x: Point, rng: np.random.Generator) -> None:
    x["r"] = ulps(1 / (x["lam"] * x["delta_h"]), few(rng))


def _intercept(x: Point, rng: np.random.Generator) -> None:
    x["F_0"] = x["m"] + abs(x["k"]) * float(rng.choice([rng.random(), 10 ** rng.uniform(-9, 0)]))


def _response_of_laws(x: Point, rng: np.random.Generator) -> None:
    R, I = x["A"] * x["Omega"] ** 2 + x["h"], x["I_0"] + 2 * x["zeta"] * x["A"] * x["Omega"]
    v = x["A"] * x["Omega"]
    x["F_0"] = ulps(math.hypot(R, I + x["d"] * v**2 + x["d_3"] * v**3), few(rng))


def _balanced(x: Point, rng: np.random.Generator) -> None:
    x["F_0"] = ulps(math.hypot(x["R"], x["I"]), few(rng))


def _all_taken(x: Point, rng: np.random.Generator) -> None:
    x["I"] = ulps(x["F_0"], -int(rng.integers(0, 3)))


def _bends_at_end(x: Point, rng: np.random.Generator) -> None:
    ratio = ulps(1.0, -int(rng.integers(1, 4))) if rng.random() < 0.5 else 1 - float(10 ** rng.uniform(-15, -1))
    x["b"] = x["A"] * ratio


def _bends_at_rest(x: Point, rng: np.random.Generator) -> None:
    x["b"] = x["A"] * float(10 ** rng.uniform(-9, -1))


def _meet(x: Point, rng: np.random.Generator) -> None:
    x["s_1"] = float(rng.choice([-1, 1])) * ulps(x["c_1"], few(rng))


def _least_intercept(x: Point, rng: np.random.Generator) -> None:
    x["intercept"] = ulps(x["least"], int(rng.integers(0, 4)))


def _quarter(x: Point, rng: np.random.Generator) -> None:
    x["t"] = float(rng.choice([-1, 1])) * (1 - float(10 ** rng.uniform(-16, -1)))


def _backbone_of_mean(x: Point, rng: np.random.Generator) -> None:
    x["s_0"] = ulps(x["A"] * x["Omega"] ** 2 / 2, few(rng))


LOCATIONS: dict[str, tuple[set[str], Callable[[Point, np.random.Generator], None]]] = {
    "A an ulp from u_cr": ({"A", "u_cr"}, _above_corner),
    "A near u_cr": ({"A", "u_cr"}, _near_corner),
    f"A = {float(FAR):g} u_cr": ({"A", "u_cr"}, _regimes_meet),
    "A to 0": ({"A"}, _small_amplitude),
    "u at u_cr": ({"u", "u_cr"}, _displacement),
    "on the backbone": ({"Omega", "A", "h"}, _backbone),
    "near the backbone": ({"Omega", "A", "h"}, _near_backbone),
    "on the backbone of small motions": ({"Omega", "alpha"}, _backbone_of_mechanism),
    "Omega^2 = -h_A": ({"Omega", "h_A"}, _other_factor),
    "a fold's intercept": ({"F_0", "m", "k"}, _intercept),
    "isola birth": ({"Omega", "h_A"}, _isola),
    "on the response": ({"Omega", "A", "F_0", "m", "zeta", "h"}, _response),
    "F_0 an ulp above 4 mu/pi": ({"F_0", "m"}, _sticking),
    "F_0 an ulp above 4 mu/pi, mu": ({"F_0", "mu"}, _sticking),
    "F_0 far below |h|": ({"F_0", "h"}, _weak),
    "F_0 far above |h|": ({"F_0", "h"}, _strong),
    "F(0) = 0": ({"F_0", "m", "h"}, _statics),
    "zeta to 0": ({"zeta"}, _undamped),
    "m to 0": ({"m"}, _frictionless),
    "mu to 0": ({"mu"}, _frictionless),
    "cusp": ({"Omega", "A", "zeta", "h", "h_A", "h_AA"}, _triple),
    "double root": ({"A", "p", "q"}, _double_cubic),
    "on the response, other laws": ({"Omega", "A", "F_0", "I_0", "zeta", "d", "d_3", "h"}, _response_of_laws),
    "on the response, R and I": ({"F_0", "R", "I"}, _balanced),
    "I an ulp below F_0": ({"F_0", "I"}, _all_taken),
    "b at A": ({"A", "b"}, _bends_at_end),
    "b to 0": ({"A", "b"}, _bends_at_rest),
    "s_1 at c_1": ({"c_1", "s_1"}, _meet),
    "the least intercept": ({"intercept", "least"}, _least_intercept),
    "t at 1": ({"t"}, _quarter),
    "on the backbone, off the centre": ({"Omega", "A", "s_0"}, _backbone_of_mean),
    "delta_h to 0 or 1": ({"delta_h"}, _softest),
    "quasi-zero stiffness": ({"lam", "r", "delta_h"}, _quasi_zero),
}
