"""In: the derivation's results and published.py. Out: `Facts`, every number that the ledger quotes, computed once.

All are balls of exact or certified values; what is said of them in words is decided from the balls.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb

from ..mechanisms.rod_spring import delta_h, lam, r
from ..paper.averaging import cycle_integral
from ..paper.den_hartog import U, V
from ..results import Results
from ..symbols import F_0, A, Omega, h, mu, psi, tau, u, zeta
from . import published
from .balls import ball, evaluate, isolate, rounded, sign
from .example import ATTACHED, Example, Point, Polynomials, polynomials
from .formulas import GROUPS, MECHANISM, Subject, detached_derivative, shared_symbols, whole_averages
from .judging import Judgement, judge
from .proofs import canonical
from .rows import DIFFERS

#: the mesh of amplitudes that Table 2 turns out to have been read from: 1000 points on [0, 1]
MESH = 999


def _share_from_which_on(holds: Callable[[Fraction], bool]) -> arb:
    """Where what holds at 1/2, Table 1's, and not at 1/20 begins to, by halves: enclosed to 10^-6."""
    low, high = Fraction(1, 20), Fraction(1, 2)
    if holds(low) or not holds(high):
        raise ArithmeticError("the share does not lie between 1/20 and 1/2")
    while high - low > Fraction(1, 10**6):
        middle = (low + high) / 2
        low, high = (low, middle) if holds(middle) else (middle, high)
    return ball(low).union(ball(high))


@dataclass(frozen=True)
class MeshPoint:
    """The point A = k/999 of a branch that is the extremal one in Omega."""

    k: int
    A: arb
    Omega: arb


class Facts:
    """Numbers of the paper's example (Table 1) and of its other statements."""

    def __init__(self, results: Results) -> None:
        self.results = results
        self.rod = results.mechanisms[MECHANISM]
        self._folds: dict[str, list[Point]] = {}
        self._failed: list[Exception] = []

    # ---- formulas -------------------------------------------------------------------------------------------------

    @functools.cached_property
    def judgements(self) -> dict[str, Judgement]:
        """The verdict on every published function, by its name."""
        return {f.name: self._judged(f.function) for f in published.FORMULAS}

    @functools.cached_property
    def subjects(self) -> dict[str, Subject]:
        """What the published functions are held against, by their names; without those that cannot be stated."""
        found: dict[str, Subject] = {}
        for group in GROUPS:
            try:
                found |= group(self.results)
            except Exception as error:
                self._failed.append(error)
        return found

    def _judged(self, function: Callable[..., Any]) -> Judgement:
        """The verdict on one. A wrong derivation may raise anything here: that too is a difference, beside others."""
        try:
            return judge(function, self.subjects[function.__name__])
        except Exception as error:
            errors = self._failed if isinstance(error, KeyError) and self._failed else [error]
            why = "; ".join(f"{type(one).__name__}: {one}" for one in errors)
            return Judgement(DIFFERS, str(function.__doc__).strip(), "not comparable", difference=why)

    def whole_differs(self) -> list[tuple[str, sp.Expr, sp.Expr, str]]:
        """Where the averages that numbers are computed by are not those that formulas are held against; the difference.

        A formula of F_k alone tells nothing of the rest of the force.
        """
        differences = [(name, one, other, canonical(other - one)) for name, one, other in whole_averages(self.results)]
        return [(name, one, other, gap.text()) for name, one, other, gap in differences if not gap.is_zero]

    @functools.cached_property
    def integrals_agree(self) -> bool:
        """Whether -(1/pi) int F_k(A cos psi) cos psi dpsi is H_1 over the cycle and H_2 over its attached parts."""
        angle = shared_symbols()["psi_0"]
        force = self.rod.oscillator.polynomials[0] - u
        integrand = -force.subs(u, A * sp.cos(psi)) * sp.cos(psi) / sp.pi
        attached = [(angle, sp.pi - angle), (sp.pi + angle, 2 * sp.pi - angle)]
        cycle = cycle_integral(integrand, 0, 2 * sp.pi)
        attached_terms = sum(cycle_integral(integrand, *ends) for ends in attached)
        H_1 = self.rod.beside_vertical.regimes[0].derivatives[0]
        return (
            canonical(cycle - H_1).is_zero and canonical(attached_terms - detached_derivative(self.results, 0)).is_zero
        )

    # ---- the example ----------------------------------------------------------------------------------------------

    @functools.cached_property
    def example(self) -> Example:
        """Table 1."""
        return self.isolator()

    @functools.cached_property
    def _polynomials(self) -> Polynomials:
        return polynomials(self.results)

    def isolator(self, **changed: Fraction) -> Example:
        """Table 1, with changes."""
        return Example(self.results, self._polynomials, {**published.TABLE_1, **changed})

    def forcing(self, label: str) -> arb:
        """The forcing of a row of Table 2, or any decimal."""
        named = {"F_SN": self.example.onset.F_0, "F_cr": self.example.detachment.F_0}
        return named[label] if label in named else ball(label)

    def folds(self, label: str) -> list[Point]:
        """Every fold at that forcing, by rising Omega."""
        if label not in self._folds:
            self._folds[label] = self.example.folds(self.forcing(label))
        return self._folds[label]

    def fold(self, label: str, kind: str) -> Point:
        """The one fold of a kind."""
        (point,) = (p for p in self.folds(label) if p.kind == kind)
        return point

    def mesh_point(self, label: str, kind: str) -> MeshPoint:
        """Of the response at A = k/999, the point that stands for this fold: the extremal Omega thereabouts."""
        fold = self.fold(label, kind)
        nearest = round(float(fold.A.mid()) * MESH)
        points = []
        for k in range(nearest - 2, nearest + 3):
            frequencies = self.example.frequencies(arb(k) / MESH, fold.F_0)
            frequencies.sort(key=lambda x: abs(x - fold.Omega).mid())
            # none beyond the peak
            points += [MeshPoint(k, arb(k) / MESH, x) for x in frequencies[:1]]
        direction = 1 if kind == "jump-down" else -1
        best = max(points, key=lambda p: direction * p.Omega.mid())
        if best in (points[0], points[-1]):
            raise ArithmeticError("the extremum lies outside the neighbours looked at")
        return best

    @functools.cached_property
    def chord_shortfall(self) -> arb:
        """How much linear interpolation of F, 1/999 apart in Omega, may lower the jump-down Omega at 0.040."""
        point = self.mesh_point("0.040", "jump-down")
        values = {**self.example.at(point.A), F_0: self.forcing("0.040")}
        f = [evaluate(form, values) for form in self._polynomials["response"].values()]
        x = point.Omega
        slope = f[1] + 2 * f[2] * x + 4 * f[4] * x**3
        bend = 2 * f[2] + 12 * f[4] * x**2
        return bend / slope / 8 / MESH**2

    @functools.cached_property
    def peaks(self) -> dict[str, Point]:
        """The resonance peaks beyond F_cr."""
        return {label: self.example.peak(self.forcing(label)) for label in ("0.040", "0.050")}

    @functools.cached_property
    def variants(self) -> dict[str, Point]:
        """The jump-down fold at 0.050 for parameters that the text also prints."""
        table, rounded_r = published.TABLE_1, Fraction("2.03")
        changes = {
            "r = 2.03, δ_h as in Table 1": {"r": rounded_r},
            "r = 2.03, δ_h = 1/(6r)": {"r": rounded_r, "delta_h": 1 / (6 * rounded_r)},
            "μ = 0.01": {"mu": Fraction("0.01"), "r": table["r"]},
        }
        near = self.fold("0.050", "jump-down").A
        found = {}
        for name, change in changes.items():
            points = self.isolator(**change).detached_folds(
                self.forcing("0.050"), near - arb("0.01"), near + arb("0.01")
            )
            (found[name],) = points
        return found

    # ---- (33) -----------------------------------------------------------------------------------------------------

    @functools.cached_property
    def spurious_onset(self) -> tuple[arb, arb]:
        """The least positive root of (33), and the negative Omega at which F_A and F_AA vanish there."""
        amplitude, points = self.example.onset_candidates[0]
        if points:
            raise ArithmeticError("the least root of (33) is no candidate more")
        at = self.example.attached(amplitude)
        # F_AA is even in Omega: its positive zeros, mirrored
        for frequency in self.example.zeros("bend", at):
            if self.example.at_Omega("fold", -frequency, at).contains(0):
                return amplitude, -frequency
        raise ArithmeticError("no common root on the real axis")

    @functools.cached_property
    def bends_at_onset(self) -> list[arb]:
        """Positive Omega with F_AA = 0 at A_s."""
        return self.example.zeros("bend", self.example.attached(self.example.onset.A))

    @functools.cached_property
    def other_onsets(self) -> list[tuple[list[arb], arb]]:
        """Positive roots of (33) and the valid one for isolators beside Table 1's."""
        r = published.TABLE_1["r"]
        changes: list[dict[str, Fraction]] = [
            {"zeta": Fraction(1, 100)},
            {"zeta": Fraction(1, 20)},
            {"mu": Fraction(1, 1000)},
            {"delta_h": 1 / (4 * r)},
            {"r": Fraction(1), "delta_h": Fraction(1, 4)},
            {"r": Fraction(3), "delta_h": Fraction(1, 15)},
        ]
        found = []
        for change in changes:
            candidates = self.isolator(**change).onset_candidates
            (valid,) = (a for a, points in candidates if points)
            found.append(([a for a, _ in candidates], valid))
        return found

    @functools.cached_property
    def preload_of_onset(self) -> tuple[arb, arb]:
        """Shares of the quasi-zero-stiffness preload, all else as in Table 1.

        From the first on A_s lies below u_cr, from the second on F_SN of (33) lies below the forcing at which folds
        begin on the corner.
        """

        def is_attached(fraction: Fraction) -> bool:
            isolator = self._preloaded(fraction)
            slope = isolator.slope_at_end
            below = slope is not None and sign(slope) < 0
            regimes = [point.regime for _, points in isolator.onset_candidates for point in points]
            if below != (ATTACHED in regimes):
                raise ArithmeticError("A_s and u_cr lie otherwise than the slope at u_cr says")
            return below

        def is_onset(fraction: Fraction) -> bool:
            isolator = self._preloaded(fraction)
            return is_attached(fraction) and sign(isolator.corner - isolator.onset.F_0) > 0

        return _share_from_which_on(is_attached), _share_from_which_on(is_onset)

    def _preloaded(self, fraction: Fraction) -> Example:
        """Table 1 but for the preload, at this fraction of the quasi-zero-stiffness preload."""
        table = published.TABLE_1
        return self.isolator(delta_h=fraction / (table["lam"] * table["r"]))

    @functools.cached_property
    def detachment_roots(self) -> list[arb]:
        """Positive roots of (34)."""
        return self.example.zeros("detachment", self.example.attached(self.example.u_cr))

    # ---- F_cr over the preload ------------------------------------------------------------------------------------

    def F_cr(self, fraction: Fraction, **changed: Fraction) -> arb:
        """F_cr at this fraction of the quasi-zero-stiffness preload, lam = 3, r = 2.03, mu = 0.012, zeta = 0.02."""
        stiffness = {"lam": Fraction(3), "r": Fraction("2.03")}
        parameters = {**stiffness, "mu": Fraction("0.012"), "zeta": Fraction("0.02"), **changed}
        return self.isolator(**parameters, delta_h=fraction / (3 * Fraction("2.03"))).detachment.F_0

    @functools.cached_property
    def F_cr_curve(self) -> list[arb]:
        """F_cr at every 5 % of the quasi-zero-stiffness preload, from 5 % on, with Figure 5's parameters."""
        return [self.F_cr(Fraction(k, 20)) for k in range(1, 21)]

    def F_cr_gain(self, percent: str) -> arb:
        """Relative rise of F_cr from zeta = 0.01 to 0.05 at this percentage of the quasi-zero-stiffness preload."""
        low, high = (self.F_cr(Fraction(percent) / 100, zeta=Fraction(value)) for value in ("0.01", "0.05"))
        return high / low - 1

    @functools.cached_property
    def rises_with_preload(self) -> bool:
        """Whether dF_cr/d delta_h > 0 on 0 < delta_h <= 1/(lam r) for lam r = 3 * 2.03, where Omega_cr^2 >= kappa/2.

        On the peak R = -zeta I/Omega, so dF_cr^2/d delta_h = 2 zeta I (u' (Omega^2 + kappa) + u kappa')/Omega with
        u = u_cr and kappa = -h(u)/u. Times u this is positive if 3/2 (1 - delta_h) kappa + delta_h (2 - delta_h) kappa'
        is: a polynomial, whose roots on the interval Sturm's theorem counts.
        """
        rod = self.rod
        (end,) = rod.whole.breakpoints
        form = rod.whole.regimes[0].derivatives[0].subs(A, end)
        values = rod.oscillator.definitions
        kappa = sp.expand(sp.expand(-form / end).subs(values).subs({lam: 3, r: sp.Rational(203, 100)}))
        criterion = sp.Poly(
            sp.Rational(3, 2) * (1 - delta_h) * kappa + delta_h * (2 - delta_h) * sp.diff(kappa, delta_h), delta_h
        )
        limit = 1 / (3 * sp.Rational(203, 100))
        return criterion.count_roots(0, limit) == 0 and criterion.eval(0) > 0

    @functools.cached_property
    def detachment_in_preload(self) -> bool:
        """Whether the coefficients of (34), u_cr^8 divided out, are polynomials in delta_h.

        h(u_cr) is odd in u_cr, and u_cr^2, alpha, beta, gamma are polynomials in delta_h: only even powers may be left.
        """
        (end,) = self.rod.whole.breakpoints
        force = self.rod.whole.regimes[0].derivatives[0].subs(A, end)
        definitions = self.rod.oscillator.definitions
        basis = [sp.expand(definitions[end] ** 2), *(value for symbol, value in definitions.items() if symbol != end)]
        even = all(
            k % 2 == 0
            for form in self.results.detachment[""].resultant.reduced.values()
            for (k,) in sp.Poly(form.subs({A: end, h: force}), end).monoms()
        )
        return even and all(value.is_polynomial(delta_h) for value in basis)

    # ---- Den Hartog -----------------------------------------------------------------------------------------------

    def S_at_least(self, frequency: str) -> arb:
        """The largest of 99 values of the maximand of (37): a lower bound of S."""
        exact = self.results.den_hartog.exact
        form = exact.slope_ratio.subs(U, exact.damping)
        w = ball(frequency)
        values = [evaluate(form, {Omega: w, tau: arb.pi() / w * k / 100}) for k in range(1, 100)]
        return max(values, key=lambda x: x.mid())

    @functools.cached_property
    def S_is_one(self) -> bool:
        """The identities behind S = 1 for Omega > 1/2; see the finding on (37)."""
        exact = self.results.den_hartog.exact
        x = sp.Symbol("x", real=True)
        b = sp.pi / (2 * Omega)
        ratio = sp.expand(exact.slope_ratio.subs(tau, b - x)).subs(U, exact.damping)
        gap = sp.cos(Omega * x) - Omega * sp.tan(b) * sp.sin(Omega * x) + Omega * sp.sin(x) / sp.cos(b)
        force = Omega * (Omega**2 - 1) * sp.sin(x) / sp.cos(b)
        slope = sp.diff(gap, x)
        return all(
            canonical(e).is_zero
            for e in (
                ratio - (1 - gap / sp.cos(Omega * x)),
                sp.diff(slope, x) + Omega**2 * gap - force,
                gap.subs(x, b),
                slope.subs(x, b),
            )
        )

    def amplitudes_without_stiffening(self, frequency: str, ratio: str) -> tuple[arb, arb]:
        """A/F_0 of the linear oscillator with friction mu/F_0 = ratio: averaged (24) and exact (35)."""
        exact = self.results.den_hartog.exact
        w, friction = ball(frequency), ball(ratio)
        at = {Omega: w, F_0: arb(1), mu: friction}
        response = evaluate(exact.response, at)
        values = {**at, V: response, U: evaluate(exact.damping, at)}
        averaged = abs(response) * (1 - (4 * friction / arb.pi()) ** 2).sqrt()
        return averaged, evaluate(exact.amplitude, values)

    # ---- Table 2 as a whole ---------------------------------------------------------------------------------------

    @functools.cached_property
    def table_2_differing(self) -> int:
        """Printed frequencies and amplitudes of Table 2 that are not roundings of the folds'."""
        wrong = 0
        for row in published.TABLE_2[1:]:
            for kind in ("jump-up", "jump-down"):
                fold, name = self.fold(row.F_0, kind), kind.replace("-", "_")
                for printed, value in (
                    (getattr(row, f"{name}_Omega"), fold.Omega),
                    (getattr(row, f"{name}_A"), fold.A),
                ):
                    wrong += printed == "u_cr" or rounded(value, 4) != printed
        return wrong

    # ---- damping --------------------------------------------------------------------------------------------------

    def friction_share(self, frequency: arb, amplitude: arb) -> arb:
        """Friction's part of (38) divided by zeta."""
        flow = self.results.flows[""]
        values = {**self.example.attached(amplitude), Omega: frequency}
        return evaluate(flow.equivalent_damping - zeta, values) / self.example.zeta

    def smallest_amplitude(self, frequency: str, label: str) -> arb:
        """The least amplitude of the response at a frequency."""
        w, forcing = ball(frequency), self.forcing(label)

        def response(amplitude: Any) -> Any:
            at = {**self.example.attached(amplitude), F_0: forcing}
            return self.example.at_Omega("response", w, at)

        return isolate(response, arb("0.001"), arb(self.example.u_cr.lower()))[0]
