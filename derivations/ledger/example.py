"""In: the derivation's results and exact parameters of the isolator. Out: its folds, onset and detachment, certified.

Folds: F = 0 and F_A = 0. Attached, FLINT isolates all roots in A of the derived Res_Omega(F, F_A). Detached, with
A = u_cr sqrt(1 + t^2), Omega is eliminated through A F_A/2 - F, a quadratic in it; what is left is a smooth function of
t down to the corner t = 0, and interval Newton steps find all its zeros up to A = 1, which no amplitude passes. An
amplitude so found is a candidate: with an Omega of the quadratic, F must vanish, and with the other one it must not.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb, arb_series

from ..forces.of_mechanism import OfMechanism
from ..paper.slow_flow import I, R, m
from ..results import Results
from ..symbols import F_0, A, Omega, h, h_A, h_AA, zeta
from .balls import ball, evaluate, isolate, polynomial_zeros, sign
from .formulas import MECHANISM

ATTACHED, DETACHED = "attached", "detached"


@dataclass(frozen=True)
class Point:
    """A point of the response: frequency, amplitude, forcing and which side of u_cr it is on."""

    Omega: arb
    A: arb
    F_0: arb
    regime: str
    kind: str = ""


#: by name, a polynomial's coefficients by power
Polynomials = dict[str, dict[int, sp.Expr]]


def polynomials(results: Results) -> Polynomials:
    """Those of the derivation in A, h, h_A, h_AA, m, zeta and F_0, by power of Omega, and the resultants.

    response, fold, bend, peak, quadratic: F, F_A/2, F_AA/2, F_Omega/(4 A), A F_A/2 - F
    every_fold, onset, detachment: Res_Omega(F, F_A), by power of A; (33), of A; (34), of F_0
    """
    flow, rod = results.flows[""], results.mechanisms[MECHANISM]
    whole = {R: flow.R, I: flow.I}
    response, fold, bend = (sp.expand(e.subs(whole)) for e in (flow.F, flow.F_A / 2, flow.F_AA / 2))

    def by_power(expression: sp.Expr, degree: int) -> dict[int, sp.Expr]:
        polynomial = sp.Poly(expression, Omega)
        if polynomial.degree() != degree:
            raise ArithmeticError(f"{expression} has not degree {degree} in Omega")
        return {k: polynomial.coeff_monomial(Omega**k) for k in range(degree + 1)}

    return {
        "response": by_power(response, 4),
        "fold": by_power(fold, 4),
        "bend": by_power(bend, 4),
        "peak": by_power(sp.cancel(flow.F_Omega.subs(whole) / (4 * A)), 3),
        "quadratic": by_power(sp.expand(A * fold - response), 2),
        "every_fold": rod.saddle_nodes.reduced,
        "onset": rod.saddle_node_onset.reduced,
        "detachment": results.detachment[""].resultant.reduced,
    }


def coefficients(mechanism: OfMechanism, parameters: Mapping[str, Fraction]) -> dict[sp.Symbol, arb]:
    """Coefficients and breakpoints of the averaged force, by the names of Table 1."""
    ratios = {symbol: ball(parameters[symbol.name]) for symbol in mechanism.oscillator.mechanism.ratios}
    return {symbol: evaluate(value, ratios) for symbol, value in mechanism.oscillator.definitions.items()}


def _value(x: Any) -> arb:
    """A ball, or the constant term of a series."""
    return x if isinstance(x, arb) else x[0]


class Example:
    """The isolator at one set of exact parameters, by the names of Table 1."""

    def __init__(self, results: Results, of: Polynomials, parameters: Mapping[str, Fraction]) -> None:
        derived = results.mechanisms[MECHANISM]
        self.polynomials = of
        self.parameters = dict(parameters)
        self.zeta, self.m = ball(parameters["zeta"]), 4 * ball(parameters["mu"]) / arb.pi()
        self.known = {**coefficients(derived, parameters), m: self.m, zeta: self.zeta}
        self.attached_forms = derived.whole.regimes[0].derivatives[:3]
        regime = derived.whole.regimes[1]
        self.u_cr = self.known[regime.passed[0]]
        self.lets = regime.lets
        self.root = next(symbol for symbol, _ in regime.lets if symbol.name == "root")
        self.detached_forms = regime.derivatives[0], sp.expand(self.root * regime.derivatives[1])
        self._seen: dict[Any, tuple[dict[sp.Symbol, Any], Any]] = {}

    # ---- the averaged force ---------------------------------------------------------------------------------------

    def attached(self, amplitude: Any) -> dict[sp.Symbol, Any]:
        """A, h, h_A, h_AA for A <= u_cr, with the coefficients and the damping."""
        values = {**self.known, A: amplitude}
        forms = zip((h, h_A, h_AA), self.attached_forms, strict=True)
        return values | {symbol: evaluate(form, values) for symbol, form in forms}

    def detached(self, t: Any) -> tuple[dict[sp.Symbol, Any], Any]:
        """A, h and root h_A (in place of h_A) at A = u_cr sqrt(1 + t^2); and root = u_cr t."""
        values: dict[sp.Symbol, Any] = {**self.known, A: self.u_cr * (1 + t * t).sqrt()}
        for symbol, value in self.lets:
            values[symbol] = self.u_cr * t if symbol == self.root else evaluate(value, values)
        force, slope = (evaluate(form, values) for form in self.detached_forms)
        return values | {h: force, h_A: slope}, values[self.root]

    def narrowed(self, t: Any) -> tuple[dict[sp.Symbol, Any], Any]:
        """`detached`, kept for the next forcing; on an interval with h and root h_A by their mean-value forms."""
        ball = _value(t)
        key = (ball.mid().man_exp(), ball.rad().man_exp(), isinstance(t, arb))
        if key not in self._seen:
            at, root = self.detached(t)
            if not isinstance(t, arb):
                centre, _ = self.detached(arb(ball.mid()))
                for symbol in (A, h, h_A):
                    value, slope = at[symbol][0], at[symbol][1]
                    if slope.is_finite():
                        value = value.intersection(centre[symbol] + slope * (ball - ball.mid()))
                    at[symbol] = arb_series([value, slope])
            self._seen[key] = at, root
        return self._seen[key]

    def at(self, amplitude: arb) -> dict[sp.Symbol, Any]:
        """A, h, h_A on the side of u_cr where the amplitude lies; u_cr itself counts as attached."""
        if not amplitude > self.u_cr:
            return self.attached(amplitude)
        values, root = self.detached((amplitude**2 - self.u_cr**2).sqrt() / self.u_cr)
        return {**values, A: amplitude, h_A: values[h_A] / root}

    # ---- points ---------------------------------------------------------------------------------------------------

    def at_Omega(self, name: str, frequency: arb, values: dict[sp.Symbol, Any]) -> arb:
        """The value of one of the polynomials."""
        return sum((evaluate(form, values) * frequency**k for k, form in self.polynomials[name].items()), arb(0))

    def zeros(self, name: str, values: dict[sp.Symbol, Any]) -> list[arb]:
        """Its positive zeros."""
        return polynomial_zeros({k: evaluate(form, values) for k, form in self.polynomials[name].items()})

    def forcing(self, frequency: arb, amplitude: arb) -> arb:
        """The forcing whose response passes through this point."""
        return self.at_Omega("response", frequency, {**self.at(amplitude), F_0: arb(0)}).sqrt()

    def frequencies(self, amplitude: arb, forcing: arb) -> list[arb]:
        """Every Omega > 0 at this amplitude, by rising size."""
        return self.zeros("response", {**self.at(amplitude), F_0: forcing})

    def _on_both(self, at: dict[sp.Symbol, Any], root: Any, forcing: arb, branch: int) -> Any:
        """What is left of F = F_A = 0 at an amplitude when its Omega is put in; None where that is negative.

        F = 0 is R = F_0 cos, I = F_0 sin of one angle, and A F_A/2 - F = R lag - m I + F_0^2 with lag = A h_A - h:
        linear in cos and sin, so that the angle is explicit, then Omega from I; R is left. All times root: finite at
        the corner.
        """
        highest = (forcing - self.m) / (2 * self.zeta * _value(at[A]))
        if _value(at[A]) * highest**2 + _value(at[h]) < -forcing:
            return None  # I <= F_0 bounds Omega, and then R < -F_0: no response so large
        lag = at[A] * at[h_A] - at[h] * root
        length = lag * lag + self.m * self.m * root * root
        inside = length - forcing * forcing * root * root
        if _value(inside) < 0:
            return None
        if not _value(length) > 0:
            return arb.nan()
        if not _value(inside) > 0:
            # the root has no Taylor series here; its value is known all the same
            at, root = {symbol: _value(value) for symbol, value in at.items()}, _value(root)
            lag, length, inside = _value(lag), _value(length), _value(inside).nonnegative_part()
        spread = branch * inside.sqrt()
        sine = (forcing * self.m * root * root + spread * lag) / length
        cosine = (self.m * spread - forcing * lag) * root / length
        frequency = (forcing * sine - self.m) / (2 * self.zeta * at[A])
        if _value(frequency) < 0:
            return None
        return at[A] * frequency * frequency + at[h] - forcing * cosine

    def folds(self, forcing: arb) -> list[Point]:
        """Every fold with u_cr != A < 1 at this forcing, by rising Omega."""
        candidates = [a for a in self.zeros("every_fold", {**self.known, F_0: forcing}) if sign(self.u_cr - a) > 0]
        points = [p for a in candidates for p in self._common(a, ATTACHED, forcing)]
        points += self.detached_folds(forcing, self.u_cr, arb(1))
        return sorted(points, key=lambda p: p.Omega.mid())

    def detached_folds(self, forcing: arb, lowest: arb, highest: arb) -> list[Point]:
        """Every fold between two amplitudes, u_cr or larger."""
        # at u_cr itself the ball would reach below 0
        start = (lowest**2 / self.u_cr**2 - 1).sqrt() if lowest > self.u_cr else arb(0)
        end = (highest**2 / self.u_cr**2 - 1).sqrt()
        found = []
        for branch in (-1, 1):

            def beyond(t: Any, branch: int = branch) -> Any:
                return self._on_both(*self.narrowed(t), forcing, branch)

            found += [self.u_cr * (1 + t * t).sqrt() for t in isolate(beyond, arb(start.mid()), arb(end.upper()))]
        return [p for a in found for p in self._common(a, DETACHED, forcing)]

    def _common(self, amplitude: arb, regime: str, forcing: arb) -> list[Point]:
        """The Omega > 0 at which both A F_A/2 - F and F vanish at this zero of their resultant: one or none."""
        values = {**self.at(amplitude), F_0: forcing}
        c, b, a = (evaluate(form, values) for form in self.polynomials["quadratic"].values())
        discriminant = b * b - 4 * a * c
        if discriminant < 0:
            return []
        spread = discriminant.sqrt()
        both = ((-b + spread) / (2 * a), (-b - spread) / (2 * a))
        hits = [frequency for frequency in both if self.at_Omega("response", frequency, values).contains(0)]
        if len(hits) != 1:
            raise ArithmeticError(f"{len(hits)} frequencies at A = {amplitude}")
        if not hits[0] > 0:
            return []
        # F_A > 0 is stable: a jump-down fold bounds the stable branch from below
        lower, upper = (
            self.stability(hits[0], amplitude * factor) for factor in (1 - arb(2) ** -60, 1 + arb(2) ** -60)
        )
        kind = {(-1, 1): "jump-down", (1, -1): "jump-up"}[sign(lower), sign(upper)]
        return [Point(hits[0], amplitude, forcing, regime, kind)]

    def stability(self, frequency: arb, amplitude: arb) -> arb:
        """F_A/2."""
        return self.at_Omega("fold", frequency, self.at(amplitude))

    @functools.cached_property
    def onset_candidates(self) -> list[tuple[arb, list[Point]]]:
        """Positive roots of (33), each with the points at which F_A and F_AA do vanish (Omega > 0)."""
        found = []
        for amplitude in self.zeros("onset", self.known):
            at, regime = self.attached(amplitude), ATTACHED if amplitude < self.u_cr else DETACHED
            points = [
                Point(frequency, amplitude, self.at_Omega("response", frequency, {**at, F_0: arb(0)}).sqrt(), regime)
                for frequency in self.zeros("bend", at)
                if self.at_Omega("fold", frequency, at).contains(0)
            ]
            found.append((amplitude, points))
        return found

    @functools.cached_property
    def onset(self) -> Point:
        """The lowest forcing with F_A = F_AA = 0 at an amplitude below u_cr."""
        points = [p for _, points in self.onset_candidates for p in points if p.regime == ATTACHED]
        return min(points, key=lambda p: p.F_0.mid())

    @functools.cached_property
    def slope_at_end(self) -> arb | None:
        """F_A/2 at u_cr and the least Omega > 0 with F_AA = 0, of the attached side; None where F_AA > 0 throughout.

        As A falls from u_cr the sign of F_A at that Omega changes at A_s: it is below u_cr where this is negative.
        """
        at = self.attached(self.u_cr)
        bends = self.zeros("bend", at)
        return self.at_Omega("fold", bends[0], at) if bends else None

    @functools.cached_property
    def corner(self) -> arb:
        """The forcing at which the backbone R = 0 reaches u_cr, and from which on folds sit on the corner there."""
        at = self.attached(self.u_cr)
        return self.forcing((-at[h] / self.u_cr).sqrt(), self.u_cr)

    @functools.cached_property
    def detachment(self) -> Point:
        """The lowest forcing that reaches u_cr: a root of (34) with the root of F_Omega = 0 that belongs to it."""
        at = self.attached(self.u_cr)
        points = [
            Point(frequency, self.u_cr, self.forcing(frequency, self.u_cr), ATTACHED)
            for frequency in self.zeros("peak", at)
        ]
        lowest = min(points, key=lambda p: p.F_0.mid())
        if sum(root.overlaps(lowest.F_0) for root in self.zeros("detachment", at)) != 1:
            raise ArithmeticError("F_cr is not a root of (34)")
        return lowest

    def lowest_forcing(self, amplitude: arb) -> tuple[arb, arb]:
        """The lowest forcing that reaches this amplitude, and the Omega > 0 at which it does."""
        found = [(self.forcing(x, amplitude), x) for x in self.zeros("peak", self.at(amplitude))]
        return min(found, key=lambda pair: pair[0].mid())

    def peak(self, forcing: arb) -> Point:
        """The largest amplitude at a forcing above F_cr: where the lowest forcing that reaches it is this one."""
        low, high = arb(self.u_cr.upper()), arb(1)
        for _ in range(50):
            middle = arb(((low + high) / 2).mid())
            if self.lowest_forcing(middle)[0] < forcing:
                low = middle
            else:
                high = middle
        amplitude = low.union(high)
        return Point(
            self.lowest_forcing(low)[1].union(self.lowest_forcing(high)[1]), amplitude, forcing, DETACHED, "peak"
        )
