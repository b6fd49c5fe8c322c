"""A generated kernel and any doubles in; its exact values there and what rounding its arguments would cost, out.

The definitions are those of `definitions`. In place of its quadratures, which fail next to a breakpoint and at extreme
numbers, the averaged forces come from `averaged` (truncated) and from FLINT's elliptic integrals (untruncated), in
balls, differentiated numerically with hundreds of bits to spare. As many digits are used as the exponents ask for.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from typing import Any

from flint import acb, arb, fmpq
from mpmath import mp, mpf, workdps

from tests.oracles.averaged import ATTACHED, DETACHED, Oscillator, exact_ball
from tests.oracles.certified_roots import precision
from tests.oracles.definitions import (
    along,
    averaged_force,
    damping,
    den_hartog,
    frequencies,
    inertia,
    linearization,
    motion,
    off_centre,
    resultants,
    sampled,
    sensitivities,
    slow_flow,
)
from tests.oracles.definitions.points import SCENES, measured, zeroed

DIGITS = 60
RELATIVE = 2.0**-50
ORDERS = ("", "_A", "_AA", "_AAA")
#: kernels that give the averages themselves
AVERAGES = {**averaged_force.TOGETHER, **{name: (name,) for name in (l + order for l in "hH" for order in ORDERS)}}
RESULTANTS = {"saddle_nodes": resultants.saddle_nodes, "saddle_node_onset": resultants.saddle_node_onset}
#: definitions that are quadratures or searches for a root, which need numbers of moderate size
BY_QUADRATURE = {"equivalent_damping", "transmissibility", "mean_stiffness", "offset_stiffness", "rise", "harmonics"}
#: modules whose definitions name their arguments
BY_NAMES: dict[str, Any] = {
    "inertia": inertia.INERTIA,
    "off_centre": off_centre.OFF_CENTRE,
    "linearization": linearization.LINEARIZATION,
    "sampled": sampled.SAMPLED,
    "dissipation": damping.DISSIPATION,
    "sensitivities": sensitivities.SENSITIVITIES,
}
Definition = Callable[..., list[Any]]


def scene_of(module: str) -> tuple[str, str]:
    """The module without the vanishing dampings in its name, and these."""
    scene = max((scene for scene in SCENES if module.endswith(scene)), key=len)
    return module.removesuffix(scene), scene


def define(module: str, kernel: str, names: Sequence[str], at: Sequence[float]) -> tuple[Definition, bool]:
    """The function of `names` that the kernel is on its side of every breakpoint at this point; whether of rationals.

    Raises KeyError for a kernel without a definition.
    """
    base, scene = scene_of(module)
    known = dict(zip(names, at, strict=True))
    if kernel == "phase" and scene == "_mu0_zeta0":
        inertia = known["A"] * known["Omega"] ** 2
        if abs(inertia + known["h"]) <= RELATIVE * inertia:
            raise ValueError("in phase or out of it, to rounding")
    if base == "slow_flow" and kernel == "fold":
        m = 0.0 if "mu0" in scene else known["m"]
        if known["k"] ** 2 < (known["F_0"] - m) * (known["F_0"] + m):
            raise ValueError("no fold at such an intercept")
    if kernel == "R_of_fold" and abs(known["Omega"] ** 2 + known["h_A"]) <= RELATIVE * known["Omega"] ** 2:
        raise ValueError("a pole, to rounding")
    with_rest = kernel in ("limit_envelope", "saddle_nodes", "fold") and base != "off_centre"
    if with_rest and "F_0" in known and "mu0" not in scene:
        friction = known["m"] if "m" in known else 4 * known["mu"] / math.pi
        if known["F_0"] <= friction * (1 + RELATIVE):
            raise ValueError("at rest, or a rounding from it")
    if kernel == "isola" and "mu0" not in scene and known["h_A"] <= 0:
        raise ValueError("no isola point: h_A > 0")
    if base in averaged_force.TYPED:
        f, rational = _of_mechanism(base, kernel, names, at)
    elif kernel == "isola" and known["m"] == 0 and "mu0" not in scene:
        raise ValueError("a common factor is left out without friction")
    elif base == "slow_flow" and kernel == "detachment":
        f, rational = resultants.detachment, True
    else:
        of_locus = along.UNDAMPED if "zeta" in SCENES[scene] else along.DAMPED
        table = {
            "slow_flow": slow_flow.SLOW_FLOW | along.SLOPES | along.LOCI | of_locus | along.BESIDE_FOLDS,
            "frequencies": frequencies.FREQUENCIES,
            "motion": motion.MOTION,
            "den_hartog": den_hartog.DEN_HARTOG,
            **BY_NAMES,
        }.get(base)
        f, rational = (slow_flow.second_kernel(kernel) if table is None else table[kernel][1]), False
    return zeroed(f, list(names), scene), rational


def is_of_gradients(kernel: str) -> bool:
    """Whether a kernel is one of the gradients', judged by differences in tests/averaged/test_gradients.py."""
    return kernel in ("by_parameter", "by_design", "steps_by", "fold_moves", "right", "of_state")


def _of_mechanism(name: str, kernel: str, names: Sequence[str], at: Sequence[float]) -> tuple[Definition, bool]:
    known = dict(zip(names, at, strict=True))
    inner = {"duffing": ("alpha", "beta"), "rod_spring": ("alpha", "beta", "gamma", "u_cr")}.get(
        name, ("alpha", "beta", "delta_h")
    )
    u_cr = _corner(known) if "alpha" in known else math.inf
    at = abs(known.get("A", known.get("u", 0.0)))
    # of the force that is steep below u_cr and goes on above the double next to u_cr is above
    passed = int(at >= u_cr if kernel == "force" and name == "rod_spring_untruncated" else at > u_cr)
    if kernel == "harmonics" and name == "rod_spring_untruncated" and u_cr > 0.75:
        raise ValueError("the harmonics are derived for u_cr <= 3/4")
    if kernel in AVERAGES:
        return lambda *x: _outputs(AVERAGES[kernel], name, passed, *x), False
    if kernel == "intercept":
        return lambda *x: [h - x[0] * h_A for h, h_A in [_outputs(("h", "h_A"), name, passed, *x)]], False
    if kernel == "harmonics":
        harmonic = averaged_force.harmonic_by_quadrature
        return lambda *x: [v for n in (3, 5) for v in harmonic(name, n, passed, *x)], False
    if kernel in RESULTANTS:
        last = len(names) - len(inner) - 1
        used = last + 1 + (2 if name == "duffing" else 3)
        leading = resultants.LEADING[name, kernel]
        return lambda *x: RESULTANTS[kernel](leading(*x[last:used]), *x[:used]), True
    if kernel in averaged_force.COMPOSED:
        own = [one for one in names if one not in inner]
        return averaged_force.composed(kernel, own, functools.partial(averages, name, passed)), False
    return averaged_force.of_force(name, kernel, passed), False


def _corner(known: dict[str, float]) -> float:
    """The double next to u_cr, which stands for it; infinite where the force has one piece."""
    if "delta_h" in known:
        return math.sqrt(2 * known["delta_h"] - known["delta_h"] ** 2)
    return known.get("u_cr", math.inf)


def _outputs(outputs: Sequence[str], name: str, passed: int, *x: Any) -> list[Any]:
    """Averages by name."""
    values = {}
    for letter, vertical in (("h", False), ("H", True)):
        if any(output.startswith(letter) for output in outputs):
            found = averages(name, passed, *x, vertical=vertical)
            values |= {letter + order: value for order, value in zip(ORDERS, found, strict=True)}
    if "intercept" in outputs:
        values["intercept"] = values["h"] - x[0] * values["h_A"]
    return [values[output] for output in outputs]


# --- the averaged forces ----------------------------------------------------------------------------------------------


class Truncated(Oscillator):
    """A force of any coefficients, linear beyond u."""

    def _stiffness(self) -> tuple[fmpq, fmpq, fmpq]:
        return self.parameters["alpha"], self.parameters["beta"], self.parameters["gamma"]

    @property
    def u_cr(self) -> arb:
        """Where the springs detach."""
        return arb(self.parameters["u"])


@functools.lru_cache(maxsize=64)
def averages(name: str, passed: int, A: Any, *p: Any, vertical: bool = False) -> list[Any]:
    """h, h_A, h_AA, h_AAA, or of the force beside the vertical spring's: of mpmath's numbers at its precision."""
    if name == "rod_spring_untruncated":
        found = _untruncated(passed, A, *p)
    else:
        alpha, beta, gamma, u = p if name == "rod_spring" else (*p, mpf(0), mpf(1))
        parameters = {"alpha": alpha, "beta": beta, "gamma": gamma, "u": u}
        with precision(3 * mp.prec + 300):
            force = Truncated(zeta=1, mu=0, **{key: as_rational(value) for key, value in parameters.items()})
            found = [_number(x) for x in force.h(arb(as_rational(A)), DETACHED if passed else ATTACHED)]
    if vertical:
        found = [found[0] + A, found[1] + 1, *found[2:]]
    return found


def as_rational(x: Any) -> fmpq:
    """A number of mpmath, exactly."""
    sign, mantissa, exponent, _ = mpf(x)._mpf_
    return fmpq(-int(mantissa) if sign else int(mantissa)) * fmpq(2) ** int(exponent)


def _number(x: arb) -> Any:
    q = exact_ball(x)
    return mpf(int(q.p)) / int(q.q)


def _untruncated(passed: int, A: Any, alpha: Any, beta: Any, delta_h: Any) -> list[Any]:
    if A == 0:
        return [mpf(0), -alpha, mpf(0), -9 * beta / 2]
    # next to the corner derivatives grow by 2^53 from one to the next
    spare = mp.prec // 2 + 120 + (0 if delta_h >= 1 else 4 * max(0, -mp.mag(1 - delta_h)))
    with precision(4 * spare + 2 * mp.prec + 8 * abs(mp.mag(A))):
        amplitude, alpha_, beta_, preload = (arb(as_rational(x)) for x in (A, alpha, beta, delta_h))
        u = (preload * (2 - preload)).sqrt()
        if not passed and amplitude > u:  # the double next to u_cr stands for it
            amplitude = u
        step = amplitude * arb(2) ** -spare

        def of(a: arb) -> arb:
            m = a * a
            if passed:
                end = (u / a).asin()
                sine_2 = (end - end.sin() * end.cos()) / 2
                steep = (acb.elliptic_f(acb(end), acb(m)) - acb.elliptic_e_inc(acb(end), acb(m))).real / m
                constant = 1 - 2 * beta_ / (1 - preload)  # continuous at its end: alpha follows from the rest
            else:
                sine_2 = arb.pi() / 4
                steep = (acb(m).elliptic_k() - acb(m).elliptic_e()).real / m
                constant = alpha_ - 2 * beta_
            return -4 / arb.pi() * a * (arb.pi() / 4 + (constant - 1) * sine_2 + 2 * beta_ * steep)

        y = [of(amplitude + k * step) for k in range(-2, 3)]
        found = [
            y[2],
            (8 * (y[3] - y[1]) - (y[4] - y[0])) / (12 * step),
            (16 * (y[3] + y[1]) - (y[4] + y[0]) - 30 * y[2]) / (12 * step**2),
            (y[4] - y[0] - 2 * (y[3] - y[1])) / (2 * step**3),
        ]
        return [_number(x) for x in found]


# --- one point --------------------------------------------------------------------------------------------------------


def digits_for(at: Sequence[float]) -> int:
    """Digits to work with: numerical differentiation has to see every argument's last bit."""
    decades = max((abs(math.log10(abs(x))) for x in at if x), default=0.0)
    return DIGITS if decades <= 6 else DIGITS + 40 * math.ceil(decades / 10)


def values(module: str, kernel: str, names: Sequence[str], at: Sequence[float]) -> tuple[list[Any], list[Any]]:
    """Values, and |f| + sum |x df/dx| over the arguments: u times it is what rounding these and the result costs.

    Raises ArithmeticError or ValueError outside the domain.
    """
    if module.startswith("den_hartog") and kernel == "amplitude":  # Den Hartog's motion has to exist
        Omega, F_0, mu = (mpf(x) for x in at)
        if F_0 * abs(den_hartog.exact_V(Omega)[0]) <= mu * abs(den_hartog.exact_U(Omega)[0]):
            raise ValueError("no motion without stops")
    f, rational = define(module, kernel, names, at)
    digits = digits_for(at)
    with workdps(digits):
        found, scales = measured(f, at, rational)
        if rational:
            found, scales = ([mpf(int(v.p)) / int(v.q) for v in column] for column in (found, scales))
        if any(isinstance(value, mp.mpc) for value in found):
            raise ValueError("not real")
        # what numerical differentiation leaves of a zero
        noise = mpf(0) if rational or kernel in AVERAGES else mpf(10) ** (15 - digits)
        found, scales = (
            [mpf(0) if s < noise else mpf(v) for v, s in zip(column, scales, strict=True)] for column in (found, scales)
        )
        if kernel.endswith("_derivative"):  # p and q as doubles with what they lack
            found, scales = frequencies.in_pairs(found, scales)
        if kernel == "harmonics":  # they act together: the fifth is measured by the third's scale
            scales = [max(pair) for pair in zip(scales[:4], scales[4:], strict=True)] * 2
        return found, scales
