"""A generated kernel and any doubles in; its exact values there and what rounding its arguments would cost, out.

The definitions are those of `definitions`. In place of its quadratures, which fail next to a breakpoint and at extreme
numbers, the averaged forces come from `averaged` (truncated) and from FLINT's elliptic integrals (untruncated), in
balls, differentiated numerically with hundreds of bits to spare. As many digits are used as the exponents ask for.
"""

from __future__ import annotations

import functools
import importlib
import math
from collections.abc import Sequence
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
from tests.oracles.definitions.points import Function, Table, measured
from tests.oracles.definitions.resultants import rational

DIGITS = 60
RELATIVE = 2.0**-50
#: kernels that give the averages themselves
AVERAGES = {
    **averaged_force.TOGETHER,
    **{name: (name,) for name in ("h", "h_A", "h_AA", "h_AAA", "intercept", "H", "H_A", "H_AA")},
}
RESULTANTS = {"saddle_nodes": resultants.saddle_nodes, "saddle_node_onset": resultants.saddle_node_onset}
#: definitions that are quadratures or searches for a root, which need numbers of moderate size
BY_QUADRATURE = {"equivalent_damping", "transmissibility", "mean_stiffness", "offset_stiffness", "rise", "harmonics"}
#: the modules of no mechanism
MODULES = {
    "slow_flow": Table(along.OF_FLOW, place=along.place),
    "inertia": Table(inertia.INERTIA, place=inertia.place),
    "dissipation": Table(damping.DISSIPATION, place=damping.place),
    "linearization": Table(linearization.LINEARIZATION),
    "sensitivities": Table(sensitivities.SENSITIVITIES),
    "motion": Table(motion.MOTION),
    "off_centre": Table(off_centre.OFF_CENTRE, 5, off_centre.place, off_centre.BETWEEN),
    "second_approximation": Table(slow_flow.SECOND, 12, slow_flow.beside_resonances),
    "frequencies": Table(frequencies.FREQUENCIES),
    "sampled": Table(sampled.SAMPLED, 5, sampled.place, sampled.BETWEEN),
    "den_hartog": Table(den_hartog.DEN_HARTOG, 24, den_hartog.place, den_hartog.BETWEEN),
}
#: parameters of mechanisms that have no file to be read as a definition
PARAMETERS = {
    "duffing": ("alpha", "beta", "gamma"),
    "rod_spring": ("alpha", "beta", "gamma", "u_cr"),
    "rod_spring_untruncated": ("alpha", "beta", "delta_h"),
}


def parameters_of(mechanism: str) -> tuple[str, ...]:
    """The names of a mechanism's parameters."""
    other = averaged_force.stated(mechanism)
    return other.parameters if other else PARAMETERS[mechanism]


def define(module: str, kernel: str, names: Sequence[str], at: Sequence[float]) -> Function:
    """The function of `names` that the kernel is on its side of every breakpoint at this point.

    Raises KeyError for a kernel without a definition.
    """
    known = dict(zip(names, at, strict=True))
    folds = ("fold", "fold_mu0", "fold_zeta0") if module == "slow_flow" else ()
    if kernel in folds:
        m = known.get("m", 0.0)
        if known.get("k", known.get("intercept")) ** 2 < (known["F_0"] - m) * (known["F_0"] + m):
            raise ValueError("no fold at such an intercept")
    if kernel == "R_of_fold" and abs(known["Omega"] ** 2 + known["h_A"]) <= RELATIVE * known["Omega"] ** 2:
        raise ValueError("a pole, to rounding")
    with_rest = kernel in ("limit_envelope", "saddle_nodes", *folds)
    if with_rest and "F_0" in known and kernel != "fold_mu0":
        friction = known["m"] if "m" in known else 4 * known["mu"] / math.pi
        if known["F_0"] <= friction * (1 + RELATIVE):
            raise ValueError("at rest, or a rounding from it")
    if module == "slow_flow" and kernel == "isola":
        if known["h_A"] <= 0:
            raise ValueError("no isola point: h_A > 0")
        if known["m"] == 0:
            raise ValueError("a common factor is left out without friction")
    return MODULES[module].definitions[kernel][1] if module in MODULES else _of_mechanism(module, kernel, names, at)


def is_of_gradients(kernel: str) -> bool:
    """Whether a kernel is one of the gradients', judged by differences in tests/averaged/test_gradients.py."""
    return kernel in ("by_parameter", "by_design", "steps_by", "fold_moves", "right", "of_state")


def _of_mechanism(name: str, kernel: str, names: Sequence[str], at: Sequence[float]) -> Function:
    inner = parameters_of(name)
    own = [one for one in names if one not in inner]
    place = abs(dict(zip(names, at, strict=True)).get("u" if "u" in names else "A", 0.0))
    ends = averaged_force.doubles_at_ends(name, at[len(own) :]) if (*own, *inner) == (*names,) else []
    # of the force that is steep below u_cr and goes on above the double next to u_cr is above
    onwards = kernel == "force" and name == "rod_spring_untruncated"
    passed = sum(place >= end if onwards else place > end for end in ends)
    if kernel == "harmonics" and name == "rod_spring_untruncated" and ends[0] > 0.75:
        raise ValueError("the harmonics are derived for u_cr <= 3/4")
    if kernel in AVERAGES:
        return lambda *x: _outputs(AVERAGES[kernel], name, passed, *x)
    if kernel == "harmonics":
        harmonic = averaged_force.harmonic_by_quadrature
        return lambda *x: [v for n in (3, 5) for v in harmonic(name, n, passed, *x)]
    if kernel == "by_parameter":
        return lambda A, h, h_A, h_AA, *p: averaged_force.changes(name, passed, A, (h, h_A, h_AA), *p)
    if kernel in RESULTANTS:
        return _resultant(name, kernel, len(own))
    if kernel in averaged_force.COMPOSED:
        return averaged_force.composed(kernel, own, functools.partial(averages, name, passed))
    return averaged_force.of_force(name, kernel, passed)


def _resultant(name: str, kernel: str, own: int) -> Function:
    """Of the first piece: where that ends does not matter."""

    def of_rationals(*x: Any) -> list[fmpq]:
        if other := averaged_force.stated(name):
            found = RESULTANTS[kernel](fmpq(1), *x[:own], *other.first(x[own:]))
            # the scale is a convention: that of the kernel
            of_product = getattr(importlib.import_module(f"slowflow_kernels.{name}"), kernel)
            scale = of_product(*(float(v.p) / float(v.q) for v in x))[-1]
            return [fmpq(*float(scale).as_integer_ratio()) * c for c in found]
        used = x[: own + 3]
        return RESULTANTS[kernel](resultants.LEADING[kernel](*used[own - 1 :]), *used)

    return resultants.of_reals(of_rationals)


def _outputs(outputs: Sequence[str], name: str, passed: int, A: Any, *p: Any) -> list[Any]:
    """Averages by name: of the whole force, h, and of the force beside the vertical spring's, H."""
    h, h_A, h_AA, h_AAA = averages(name, passed, A, *p)
    values = {"h": h, "h_A": h_A, "h_AA": h_AA, "h_AAA": h_AAA, "intercept": h - A * h_A}
    # the double next to the first breakpoint stands for it
    end = A if passed else min([A, *averaged_force.pieces(name, p)[1]])
    values |= {"H": h + end, "H_A": h_A + 1, "H_AA": h_AA}
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
def averages(name: str, passed: int, A: Any, *p: Any) -> list[Any]:
    """h, h_A, h_AA, h_AAA: of mpmath's numbers at its precision."""
    if averaged_force.stated(name):
        return averaged_force.harmonic_by_quadrature(name, 1, passed, A, *p)
    if name == "rod_spring_untruncated":
        return _untruncated(passed, A, *p)
    alpha, beta, gamma, u = p if name == "rod_spring" else (*p, mpf(1))
    parameters = {"alpha": alpha, "beta": beta, "gamma": gamma, "u": u}
    with precision(3 * mp.prec + 300):
        force = Truncated(zeta=1, mu=0, **{key: rational(value) for key, value in parameters.items()})
        return [_number(x) for x in force.h(arb(rational(A)), DETACHED if passed else ATTACHED)]


def _number(x: arb) -> Any:
    q = exact_ball(x)
    return mpf(int(q.p)) / int(q.q)


def _untruncated(passed: int, A: Any, alpha: Any, beta: Any, delta_h: Any) -> list[Any]:
    if A == 0:
        return [mpf(0), -alpha, mpf(0), -9 * beta / 2]
    # next to the corner derivatives grow by 2^53 from one to the next
    spare = mp.prec // 2 + 120 + (0 if delta_h >= 1 else 4 * max(0, -mp.mag(1 - delta_h)))
    with precision(4 * spare + 2 * mp.prec + 8 * abs(mp.mag(A))):
        amplitude, alpha_, beta_, preload = (arb(rational(x)) for x in (A, alpha, beta, delta_h))
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
    f = define(module, kernel, names, at)
    digits = digits_for(at)
    with workdps(digits):
        found, scales = measured(f, at)
        if any(isinstance(value, mp.mpc) for value in found):
            raise ValueError("not real")
        # what numerical differentiation, or quadrature, leaves of a zero
        exact = kernel in (*RESULTANTS, "detachment") or (kernel in AVERAGES and module in PARAMETERS)
        noise = mpf(0) if exact else mpf(10) ** (15 - digits)
        found, scales = (
            [mpf(0) if s < noise else mpf(v) for v, s in zip(column, scales, strict=True)] for column in (found, scales)
        )
        if kernel.endswith("_derivative"):  # p and q as doubles with what they lack
            found, scales = frequencies.in_pairs(found, scales)
        if kernel == "harmonics":  # they act together: the fifth is measured by the third's scale
            scales = [max(pair) for pair in zip(scales[:4], scales[4:], strict=True)] * 2
        return found, scales
