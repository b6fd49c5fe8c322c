"""Which derived expression stands against which published function.

In:  the derivation's results.
Out: `GROUPS`, which give one `Subject` for each function of published.py, by its name: what to put in for the
     function's arguments and what must come out. `judging` does the comparison.

A published relation lhs - rhs is fed the derived quantities and must give zero. Where an argument is not given here,
the shared symbol of the same name is put in.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from .. import symbols
from ..mechanisms.rod_spring import Delta_h, delta_h, k_h, lam, r
from ..paper import averaging
from ..paper import equation_of_motion as osc
from ..paper.averaging import DISPLACEMENT, VELOCITY, G, H
from ..paper.critical_forcings import Elimination
from ..paper.den_hartog import S, U, V
from ..paper.restoring_force import Restoring
from ..paper.slow_flow import I, R, m
from ..results import Results
from ..symbols import F_0, A, Omega, epsilon, h, h_A, mu, phi, psi, sigma, tau, zeta

#: the mechanism whose equations the paper publishes
MECHANISM = "rod_spring"

DIFFERENCE, SQUARES, COSINES, FIELDS = "difference", "squares", "cosines", "fields"


@dataclass(frozen=True)
class Reading:
    """One form in which the derived quantity may stand: what must come out, in which sense, at which extra values."""

    derived: Any
    rewriting: str = ""
    values: dict[str, sp.Expr] = field(default_factory=dict)


@dataclass(frozen=True)
class Subject:
    """What a published function is compared with."""

    forms: tuple[Reading, ...]  #: derived forms; the function agrees if it equals one of them
    #: values of its arguments, where they are not the symbols of the same names
    values: dict[str, sp.Expr] = field(default_factory=dict)
    #: difference: published - derived must vanish;  squares: so must the difference of the squares, both being
    #: positive at `sample`;  cosines: both are angles in [0, pi], their cosines must agree;  fields: a record
    how: str = DIFFERENCE
    #: the derived quantity for readers by its name, where the form itself would not tell
    shown: dict[str, sp.Expr] = field(default_factory=dict)
    sample: dict[sp.Symbol, sp.Rational] = field(default_factory=dict)  #: a point at which the square roots are real
    literal: bool = False  #: the text is not damaged here: this reading is what the paper prints
    remark: str = ""  #: for readers, whatever the verdict


def _named(*modules: Any) -> dict[str, sp.Symbol]:
    found = {}
    for module in modules:
        for value in vars(module).values():
            if isinstance(value, sp.Symbol):
                found[value.name] = value
    return found


def shared_symbols() -> dict[str, sp.Symbol]:
    """Symbols of the derivation by name, and new ones for what only the paper names."""
    known = _named(osc, averaging, symbols) | {
        s.name: s for s in (lam, r, delta_h, k_h, Delta_h, S, U, V, *sp.symbols("k_v L", positive=True))
    }
    new = "x_dot x_ddot F_k_x F_k_u A_c eigenvalue trace determinant p q Phi_1 Phi_2 f_k F_k_bar"
    positive = "u_cr psi_0 nu_1 nu_2"
    return (
        known
        | {s.name: s for s in sp.symbols(new, real=True)}
        | {s.name: s for s in sp.symbols(positive, positive=True)}
        | {s.name: s for s in sp.symbols("x alpha beta gamma", real=True)}
    )


def same(derived: Any, rewriting: str = "", **subject: Any) -> Subject:
    """A subject with one form."""
    return Subject((Reading(derived, rewriting),), **subject)


def fields(
    elimination: Elimination, first: str, second: str, at: str, unknown: str, coefficients: str
) -> dict[str, Any]:
    """What a published resultant states, as the derivation has it."""
    powers = sorted(elimination.coefficients)
    return {
        "first": first,
        "second": second,
        "eliminated": "Omega",
        "evaluated_at": at,
        "unknown": unknown,
        "coefficients": coefficients,
        "degree": elimination.degree,
        "step": int(sp.gcd_list([sp.Integer(power) for power in powers])),
    }


def stiffness(results: Results) -> sp.Expr:
    """alpha of (7)."""
    definitions = results.mechanisms[MECHANISM].oscillator.definitions
    return next(value for symbol, value in definitions.items() if symbol.name == "alpha")


def dimensionless_motion(results: Results) -> sp.Expr:
    """(3) as it follows from (1): divided by k_v L, dimensional parameters by their groups, with F_k for the force."""
    mechanism = results.mechanisms[MECHANISM].oscillator.mechanism
    k_v, length = mechanism.k_v, mechanism.length
    groups = osc.dimensionless_groups(mechanism)
    rate = groups[osc.omega_n]
    motion = osc.equation_of_motion(k_v, length * symbols.u, length * rate * osc.u_dot, length * rate**2 * osc.u_ddot)
    dimensional = {osc.c: zeta, osc.F_c: mu, osc.F: F_0}
    values = {old: sp.solve(groups[new] - new, old)[0] for old, new in dimensional.items()}
    oscillation = {osc.cos_forcing: sp.cos(Omega * tau), osc.sign_u_dot: sp.sign(osc.u_dot)}
    return sp.expand(motion.subs(values) / (k_v * length)).subs(oscillation) + averaging.F_k


def _oscillator(results: Results) -> dict[str, Subject]:
    rod = results.mechanisms[MECHANISM].oscillator
    mechanism = rod.mechanism
    k_v, length, x = mechanism.k_v, mechanism.length, mechanism.x
    s = shared_symbols()
    groups = osc.dimensionless_groups(mechanism)
    oscillation = {osc.cos_forcing: sp.cos(osc.omega * osc.t), osc.sign_u_dot: sp.sign(s["x_dot"])}
    dimensional = (osc.equation_of_motion(k_v, x, s["x_dot"], s["x_ddot"]) + averaging.F_k).subs(oscillation)
    scaled = dimensionless_motion(results)
    end = length * rod.exact_ends[0].subs(delta_h, Delta_h / length)
    names = {
        "omega_n": groups[osc.omega_n],
        "tau": groups[osc.omega_n] * osc.t,
        "Omega": osc.omega / groups[osc.omega_n],
        "u": x / length,
        **{symbol.name: groups[symbol] for symbol in (delta_h, zeta, mu, F_0, r)},
    }
    coefficients = {symbol.name: value for symbol, value in rod.definitions.items()}
    sample = {s["L"]: sp.Integer(2), Delta_h: sp.Rational(1, 2), delta_h: sp.Rational(1, 4)}
    return {
        "equation_of_motion_dimensional": same(
            dimensional, values={"F_k": averaging.F_k}, remark="The statement that the derivation starts from."
        ),
        "F_k_dimensional": same(tuple(piece.force for piece in mechanism.pieces)),
        "x_cr": same(end, how=SQUARES, sample=sample),
        "equation_of_motion": same(scaled, remark="(1) with x = L u, d/dt = ω_n d/dτ, divided by k_v L."),
        "dimensionless_quantities": same(
            (0,) * 9,
            values=names,
            shown=names,
            remark="The coefficients of (1) after the scaling are these groups: with them each definition gives zero.",
        ),
        "F_k_scaling": same(
            0,
            values={"F_k_u": s["F_k_x"] / (k_v * length)},
            shown={"F_k_u": s["F_k_x"] / (k_v * length)},
            remark="The factor by which (1) is multiplied, so that inertia and vertical stiffness become 1.",
        ),
        "F_k": same(rod.exact),
        "u_cr": same(rod.exact_ends[0], how=SQUARES, sample=sample),
        "F_k_taylor": same(tuple(piece - symbols.u for piece in rod.polynomials)),
        **{name: same(coefficients[name]) for name in ("alpha", "beta", "gamma")},
    }


def _averaging(results: Results) -> dict[str, Subject]:
    mean = results.averaged
    s = shared_symbols()
    scaled = dimensionless_motion(results)
    small = {symbol: epsilon * symbol for symbol in (zeta, mu, F_0, averaging.F_k)}
    # 1 = Omega^2 - epsilon sigma in the stiffness term
    rescaled = sp.expand(scaled.subs(small, simultaneous=True) + (Omega**2 - epsilon * sigma - 1) * symbols.u)
    perturbation = sp.expand((osc.u_ddot + Omega**2 * symbols.u - rescaled) / epsilon)
    velocity = mean.compatibility + VELOCITY
    acceleration = mean.motion + epsilon * G - Omega**2 * DISPLACEMENT
    forcing_angle = mean.perturbation[0].coeff(F_0).args[0]
    angle = psi - phi if sp.cos(psi - phi) == sp.cos(forcing_angle) else sp.nan
    bars = {f"{name}_bar": epsilon * s[name] for name in ("zeta", "mu", "F_0", "F_k")}
    integrand = mean.restoring_integrand.subs(averaging.F_k, s["f_k"])
    return {
        "averaging_form": same(
            rescaled, values={"G": perturbation}, remark="(3) with the barred parameters and 1 = Ω² − εσ of (10)."
        ),
        "G": same(perturbation, values={"F_k": averaging.F_k}),
        "rescaling": same(
            (0,) * 5,
            values={**bars, "sigma": (Omega**2 - 1) / epsilon},
            shown={**bars, "sigma": (Omega**2 - 1) / epsilon},
            remark="A choice; with it (3) takes the form (8), (9).",
        ),
        "period": same(sp.periodicity(sp.cos(Omega * tau), tau)),
        "first_order_solution": same((DISPLACEMENT, VELOCITY), remark="An assumption, and the start of the averaging."),
        "psi": same(
            psi,
            values={"phi": psi - Omega * tau + (angle - (psi - phi))},
            shown={"": Omega * tau + phi},
            remark="The forcing is cos(ψ − φ) in the derivation.",
        ),
        "velocity_condition": same(0, values={"u_dot": velocity}, shown={"u_dot": velocity}),
        "variation_condition": same(mean.compatibility),
        "acceleration_condition": same(
            0,
            values={"u": DISPLACEMENT, "u_ddot": acceleration},
            shown={"u_ddot": sp.expand(acceleration)},
        ),
        "forced_condition": same(-mean.motion, remark="The derived equation is this one times −1."),
        "linear_system": same((mean.compatibility, sp.expand(-mean.motion / Omega))),
        "modulation": same(mean.unaveraged),
        "averaged_modulation_integrand": same(tuple(rate / (2 * sp.pi) for rate in mean.unaveraged)),
        "Gamma": same(tuple(epsilon * rate for rate in mean.slow_flow), values={"H_i": H}),
        "H_i_integrand_plus": same(integrand),
        "H_i_integrand_minus": same(integrand),
    }


def _atan(y: sp.Expr, x: sp.Expr) -> sp.Expr:
    return sp.atan(y / x)


def in_angle(expression: sp.Expr, end: sp.Symbol, angle: sp.Symbol) -> sp.Expr:
    """A closed form of `restoring` beyond one breakpoint, with end = A cos(angle).

    sqrt(A^2 - end^2) = A sin(angle); of the two angles at the end one is the angle, one pi/2 less it.
    """
    root = {p: p.base for p in expression.atoms(sp.Pow) if p.exp.is_Rational and p.exp.q == 2}
    if any(sp.expand(base) != A**2 - end**2 for base in root.values()):
        raise ArithmeticError(f"an unforeseen root in {expression}")
    opposite = sp.Symbol("opposite", positive=True)
    expression = expression.xreplace({p: opposite ** (2 * p.exp) for p in root})
    angles = {
        **{form(opposite, end): angle for form in (sp.atan2, _atan)},
        **{form(end, opposite): sp.pi / 2 - angle for form in (sp.atan2, _atan)},
    }
    return expression.xreplace(angles).subs({opposite: A * sp.sin(angle), end: A * sp.cos(angle)})


def detached_derivative(results: Results, order: int) -> sp.Expr:
    """H_2 (order 0) or its derivative with respect to A, in A, the coefficients and psi_0, where u_cr = A cos psi_0."""
    return _detached(results.mechanisms[MECHANISM].beside_vertical, order)


def _detached(averages: Restoring, order: int) -> sp.Expr:
    (end,) = averages.breakpoints
    return in_angle(averages.regimes[1].closed_form(order), end, shared_symbols()["psi_0"])


def whole_averages(results: Results) -> list[tuple[str, sp.Expr, sp.Expr]]:
    """What must agree: h = H_i - A and its derivative by H_i, which formulas are held against, and as numbers have it.

    The two are derived apart from each other, from F_k and from F_k + u.
    """
    rod = results.mechanisms[MECHANISM]
    found = []
    for order, (name, linear) in enumerate((("h = H_{} - A", A), ("dh/dA = dH_{}/dA - 1", sp.Integer(1)))):
        attached, whole = (one.regimes[0].derivatives[order] for one in (rod.beside_vertical, rod.whole))
        found.append((name.format(1, 1), attached - linear, whole))
        found.append((name.format(2, 2), _detached(rod.beside_vertical, order) - linear, _detached(rod.whole, order)))
    return found


ANGLE = "u_cr = A cos ψ₀, √(A² − u_cr²) = A sin ψ₀"


def _restoring(results: Results) -> dict[str, Subject]:
    s = shared_symbols()
    averages = results.mechanisms[MECHANISM].beside_vertical
    u_cr, angle = s["u_cr"], s["psi_0"]
    (end,) = averages.breakpoints
    lets = {symbol.name: value.subs(end, u_cr) for symbol, value in averages.regimes[1].lets}
    root = lets["root"]
    psi_0 = lets["psi_0"].subs({symbol: root for symbol, _ in averages.regimes[1].lets if symbol.name == "root"})
    attached_slope = averages.regimes[0].derivatives[1]
    on_circle = {"u_cr": A * sp.cos(angle), "p": sp.sin(angle), "q": -8 * attached_slope}
    slope = Reading(detached_derivative(results, 1), f"{ANGLE}, p = sin ψ₀, q = −8 ∂H_1/∂A")
    sample = {A: sp.Integer(2), u_cr: sp.Integer(1)}
    return {
        "H_1": same(averages.regimes[0].derivatives[0]),
        "detachment_angle": same(0, values={"psi_0": psi_0}, shown={"psi_0": psi_0}),
        "H_2": same(detached_derivative(results, 0), ANGLE),
        "dH_2_dA_inverse_A": Subject((slope,), values=on_circle),
        "dH_2_dA_A": Subject((slope,), values=on_circle),
        "p": same(root / A, how=SQUARES, sample=sample, remark="p = sin ψ₀."),
        "q": same(-8 * attached_slope, remark="q = −8 ∂H_1/∂A."),
        "psi_0": same(psi_0, how=COSINES),
    }


NOTATION = "H_i = h + A"
FRICTION = "m = 4μ/π"


def _slow_flow(results: Results) -> dict[str, Subject]:
    s = shared_symbols()
    flow = results.flows[""]
    whole = {R: flow.R, I: flow.I}
    friction = {m: flow.friction}
    rates = results.averaged.slow_flow
    slope = {"H_i": h + A, "dH_i_dA": h_A + 1}
    jacobian = flow.jacobian.subs(friction)
    phase = flow.phase.subs(whole).subs(friction)
    eigenvalue = s["eigenvalue"]
    characteristic = (eigenvalue * sp.eye(2) - flow.jacobian).det()
    return {
        "fixed_points": same(tuple(sp.expand(-2 * Omega * rate) for rate in rates), values={"H_i": H}),
        "F": same(flow.F.subs(whole).subs(friction), f"{NOTATION}, {FRICTION}", values={"H_i": h + A}),
        "tan_phi": same(
            sp.tan(phase),
            f"{NOTATION}, {FRICTION}",
            values={"H_i": h + A},
            remark="The tangent determines φ up to π; the derivation has φ = atan2(−I, −R).",
        ),
        "backbone": same(
            0,
            NOTATION,
            values={"A_c": A, "H_i": h + A, "Omega": flow.backbone},
            shown={"Omega": flow.backbone},
        ),
        "A_L": same(flow.limit_envelope.subs(friction), FRICTION),
        "F_0_sticking": same(sp.solve(flow.limit_envelope, F_0)[0].subs(friction), FRICTION),
        "D_q_Gamma": same(
            tuple(jacobian),
            f"{NOTATION}, σ = Ω² − 1, {FRICTION}",
            values={**slope, "sigma": Omega**2 - 1},
        ),
        "characteristic_equation": same(
            sp.expand(characteristic),
            values={"trace": flow.jacobian.trace(), "determinant": flow.jacobian.det()},
            shown={"": sp.Symbol("det(eigenvalue*1 - D_q_Gamma)")},
        ),
        "stability_boundary": same(
            flow.stability.subs(whole).subs(friction),
            f"{NOTATION}, {FRICTION}",
            values=slope,
            shown={"": flow.stability, "R": flow.R, "I": flow.I},
        ),
        "zeta_eq": same(flow.equivalent_damping.subs(friction), FRICTION),
    }


def _critical(results: Results) -> dict[str, Subject]:
    onset = results.mechanisms[MECHANISM].saddle_node_onset
    detachment = results.detachment[""].resultant
    friction = results.flows[""].friction
    quasi_zero = sp.solve(stiffness(results), delta_h)[0]
    return {
        "saddle_node_resultant": same(
            fields(onset, "dF/dA", "d2F/dA2", "A = A_s", "A_s", "b_i"),
            how=FIELDS,
            remark=f"Degree {onset.degree}; powers that vanish identically: the odd ones; content {onset.content}; "
            f"{len(onset.factors)} irreducible factor over Q[A, α, β, γ, ζ, m], so no extraneous factor, "
            "although some roots are not points of the response.",
        ),
        "detachment_resultant": same(
            fields(detachment, "F", "dF/dOmega", "A = u_cr", "F_cr", "c_i(delta_h)"),
            how=FIELDS,
            remark=f"Degree {detachment.degree}; the odd powers vanish identically; content {detachment.content}; "
            "factors over Q: "
            + " and ".join(
                f"{sp.sstr(f)}^{k}" if f.is_Symbol else f"a polynomial of {len(f.args)} terms"
                for f, k in detachment.factors
            )
            + "; the factor A^8 = u_cr^8 is extraneous.",
        ),
        **{name: same(quasi_zero) for name in ("delta_h_qzs_inverse", "delta_h_qzs_literal")},
        **{name: same(quasi_zero.subs(lam, 3)) for name in ("delta_h_limit_inverse", "delta_h_limit_literal")},
        "mu_over_F_0_sticking": same(mu / friction, "the reciprocal of F_0/μ = 4/π"),
        "F_cr_limit_literal": same(friction, literal=True),
        "F_cr_limit_inverse": same(
            friction,
            remark="With A = u_cr → 0, m ≤ F_cr ≤ m + 2ζ u_cr √(−h/u_cr): at any Ω the forcing is √(R² + I²) ≥ I ≥ m, "
            "and R = 0 at the upper bound. Not what the paper prints; tried because it is the reciprocal of the "
            "fraction there.",
        ),
    }


def _den_hartog(results: Results) -> dict[str, Subject]:
    exact = results.den_hartog.exact
    mirrored = sp.expand(exact.slope_ratio.subs(tau, sp.pi / Omega - tau)).subs(U, exact.damping)
    maximand = Subject(
        (
            Reading(exact.slope_ratio),
            Reading(
                mirrored,
                "τ → π/Ω − τ, which maps the interval onto itself and preserves the maximum; U of (37)",
                {"U": exact.damping},
            ),
        )
    )
    sample = {F_0: sp.Integer(1), mu: sp.Rational(1, 10), V: sp.Integer(2), U: sp.Integer(1), S: sp.Integer(1)}
    signs = ("plus_plus", "plus_minus", "minus_plus", "minus_minus")
    return {
        "A_den_hartog": same(exact.amplitude, how=SQUARES, sample=sample),
        "A_stick_slip": same(exact.bound, how=SQUARES, sample={**sample, Omega: sp.Integer(2)}),
        "V": same(exact.response),
        "U": same(exact.damping),
        **{f"S_maximand_{name}": maximand for name in signs},
    }


def logistic(x: sp.Expr) -> sp.Expr:
    """The smooth step of (A2)."""
    return 1 / (1 + sp.exp(-x))


def _smoothing(results: Results) -> dict[str, Subject]:
    s = shared_symbols()
    force = results.mechanisms[MECHANISM].oscillator.exact[0]
    motion = dimensionless_motion(results).subs({sp.sign(osc.u_dot): s["Phi_1"], averaging.F_k: force * s["Phi_2"]})
    window = logistic(s["nu_2"] * (symbols.u + s["u_cr"])) - logistic(s["nu_2"] * (symbols.u - s["u_cr"]))
    step = sp.tanh(s["nu_1"] * osc.u_dot)
    names = ("minus_minus", "plus_plus", "minus_plus", "plus_minus")
    return {
        "smoothed_equation_of_motion_u": same(
            motion, remark="(3) and (5), untruncated, with sign → Φ_1, |u| ≤ u_cr → Φ_2."
        ),
        "smoothed_equation_of_motion_x": same(motion, literal=True),
        "Phi_1": same(step.rewrite(sp.exp), "tanh in exponentials", shown={"": step}),
        **{f"Phi_2_{name}": same(window, remark="Difference of two logistic steps.") for name in names},
    }


def _preloads(results: Results) -> dict[str, Subject]:
    half = sp.solve(stiffness(results).subs(lam, 3) - sp.Rational(1, 2), delta_h)[0]
    choice = "A choice; compared with the preload that gives α = 1/2 with λ = 3."
    return {
        "delta_h_caption_inverse": same(half, remark=choice),
        "delta_h_caption_literal": same(half, remark="With r = 2.03 the preload would exceed the rod, δ_h > 1."),
        "delta_h_table_inverse": same(half, remark=choice),
        "delta_h_table_literal": same(half, remark="It would make α = 1 − r²/2 negative."),
    }


#: what states subjects, in the paper's order
GROUPS = (_oscillator, _averaging, _restoring, _slow_flow, _critical, _den_hartog, _smoothing, _preloads)
