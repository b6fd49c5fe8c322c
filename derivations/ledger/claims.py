"""In: `Facts`. Out: for every sentence of CLAIMS a verdict and its evidence.

Where a sentence says in words what an equation says, the verdict follows from the proof of that equation; where it
states a number or a sign, from a certified value, which is claimed: a verdict whose evidence fails is an error.
Where it judges a figure, from what was measured (`measured`).
"""

from __future__ import annotations

from itertools import pairwise

import sympy as sp
from flint import arb

from ..claims import claim
from ..mechanisms.rod_spring import delta_h, lam, r
from ..paper.slow_flow import I, R, m
from ..symbols import F_0, A, Omega, mu, u, zeta
from . import measured, published
from .balls import evaluate, rounded, sign, significant
from .facts import Facts
from .formulas import stiffness
from .rows import DEFINITION, DIFFERS, FALSE, LOOSE, TRUE, Row

#: evidence by verdict and sentence
Verdicts = dict[str, dict[str, str]]


def by_equations(facts: Facts, where: str, functions: str, remark: str = "") -> str:
    """The evidence for a sentence that puts equations into words: these, by their functions in published.py."""
    if any(facts.judgements[name].verdict == DIFFERS for name in functions.split()):
        raise ArithmeticError(f"{where} does not hold")
    return f"Proved: {where}. {remark}".strip()


def few(x: arb) -> str:
    """Four significant digits."""
    return significant(x, 4)


#: sentences that equations prove: which, their functions, and a remark
BY_EQUATIONS: dict[str, tuple[str, ...]] = {
    "dimensionless_equation": ("(3) and (4) from (1)", "equation_of_motion dimensionless_quantities"),
    "taylor": ("(6), (7)", "F_k_taylor alpha beta gamma"),
    "rescaled_equation": ("(8) with (9), (10)", "averaging_form G rescaling"),
    "G_period": ("T = 2π/Ω", "period", "Periodic in τ at fixed u, u'."),
    "variation_condition": ("(13) from (11), (12)", "variation_condition velocity_condition"),
    "substitution": ("(15) from (8), (14)", "forced_condition acceleration_condition"),
    "linear_system": ("(16) from (13), (15)", "linear_system"),
    "linear_solution": ("(17)", "modulation"),
    "velocity_sign": (
        "(19) from (18), friction integrated over the two half-cycles",
        "Gamma",
        "u' = −AΩ sin ψ: the signs are right inside the intervals; at their ends u' = 0.",
    ),
    "H_1_continuous": ("(21), no breakpoint reached", "H_1"),
    "frequency_response": ("(24) from (23)", "F fixed_points"),
    "phase": ("(25) from (23)", "tan_phi", "It determines φ up to π, (23) uniquely."),
    "backbone": ("(26)", "backbone"),
    "envelope_unbounded": ("(27): A_L = (F_0 − 4μ/π)/(2ζΩ) → ∞ for F_0 > 4μ/π", "A_L"),
    "jacobian": ("(28)", "D_q_Gamma"),
    "determinant_null": (
        "(30) is 4Ω² det, and 4Ω² det = F_A/(2A)",
        "stability_boundary",
        "tr < 0, so det > 0 is stability.",
    ),
    "derivative_H_2": ("(31), fourth term 6qA⁻¹u_cr", "dH_2_dA_inverse_A"),
    "resultant_even_36": ("degree 36, even powers only", "saddle_node_resultant"),
    "den_hartog": ("(35) from the half-cycle problem", "A_den_hartog V U"),
    "den_hartog_boundary": ("(36), with S of (37) read with both signs minus", "A_stick_slip S_maximand_minus_minus"),
    "zeta_eq_equating": ("(38) from (23)", "zeta_eq"),
    "smoothing_functions": ("Φ_1 = tanh(ν_1u'), Φ_2 a difference of two logistic steps", "Phi_1 Phi_2_minus_minus"),
}


def section_2(facts: Facts) -> Verdicts:
    rod = facts.rod.oscillator
    compression = rod.mechanism.pieces[0].until
    definitions = {symbol.name: value for symbol, value in rod.definitions.items()}
    u_cr, alpha = definitions["u_cr"], stiffness(facts.results)
    rising = sp.factor(sp.diff(u_cr**2, delta_h))
    claim("α falls from 1", sp.diff(alpha, delta_h) == -lam * r and alpha.subs(delta_h, 0) == 1)
    claim("u_cr rises", rising.equals(2 * (1 - delta_h)))
    claim("the force is odd", all(sp.expand(piece + piece.subs(u, -u)) == 0 for piece in rod.exact))
    return {
        TRUE: {
            "spring_tension": f"The compression of a horizontal spring, {sp.sstr(compression)}, vanishes at x_cr and "
            "is negative beyond.",
            "odd_terms": "F_k(−u) = −F_k(u) exactly; all even Taylor coefficients vanish.",
            "u_cr_null": f"u_cr = {sp.sstr(u_cr)} vanishes at δ_h = 0.",
            "linear_null_preload": "α = 1 at δ_h = 0, and u_cr = 0: only the linear piece is left, although β = λr/2.",
            "hslds_to_qzs": "α = 1 − λrδ_h falls from 1 to 0 on 0 ≤ δ_h ≤ 1/(λr).",
            "negative_stiffness": "α = 1 − λrδ_h < 0 for δ_h > 1/(λr).",
            "u_cr_range": "du_cr²/dδ_h = 2(1 − δ_h) > 0 for δ_h < 1.",
            "snap_through": "For α < 0 the whole force u + F_k(u) falls from 0 at u = 0 and is u_cr > 0 at u_cr: a "
            "second equilibrium on either side.",
        },
        LOOSE: {
            "linear_collapse": "The force is that of a linear oscillator. But the first expression of (5) does not "
            "turn into the second: at δ_h = 0 it is λr(1 − √(1 − u²))u/√(1 − u²). Its interval |u| ≤ u_cr shrinks to a "
            "point.",
        },
    }


def section_3_1(facts: Facts) -> Verdicts:
    flow, without_friction, without_viscosity = (facts.results.flows[scene] for scene in ("", "mu0", "zeta0"))
    claim("at μ = 0 the response is biquadratic", without_friction.response_quartic[1] == 0)
    claim("at ζ = 0 the response is biquadratic", without_viscosity.response_quartic[1] == 0)
    quiet = flow.F.subs({R: 0, I: flow.I.subs(A, 0)})
    claim("F at A = 0", sp.expand(quiet - (m**2 - F_0**2)) == 0)
    return {
        TRUE: {
            "closed_form": "At μ = 0 the coefficient of Ω vanishes: quadratic in Ω².",
            "friction_alone": "At ζ = 0, I = 4μ/π for every A: with F_0 > 4μ/π every amplitude has Ω² = (−h ± √(F_0² − "
            "I²))/A.",
            "sticking_by_limit": "h → 0 with A, and (24) becomes (4μ/π)² − F_0² = 0.",
        },
        LOOSE: {
            "H_2_intervals": "Four intervals, and (22) is right. But the two bullets below the sentence, as in our "
            "copy, assign |u| > u_cr to [ψ_0, π − ψ_0] and [π + ψ_0, 2π − ψ_0]. There |A cos ψ| < u_cr: at ψ = π/2 it "
            "is 0. (22) follows with the bullets exchanged.",
            "envelope_hypothesis": "The hypothesis is not needed: the first equation of (23) has no H_i, so (27) holds "
            "on both sides of u_cr.",
            "envelope": "sin φ = −1 gives (27). sin φ = +1 gives 2ζΩA = −F_0 − 4μ/π < 0: no amplitude.",
            "sticking": "|sin φ| ≤ 1 in (23) needs F_0 ≥ 4μ/π + 2ζΩA. No frequency is in the condition: the "
            "excitation's amplitude is insufficient, not its frequency.",
        },
        FALSE: {
            "numerical_only": "(24) is a depressed quartic in Ω, which has a solution in radicals for any μ. With ζ = "
            "0 its only odd term, 16μζAΩ/π, vanishes, so that it is quadratic in Ω² for any μ.",
        },
    }


def section_3_2(facts: Facts) -> Verdicts:
    flow, example = facts.results.flows[""], facts.example
    amplitude, forcing = arb("0.35"), facts.forcing("0.040")
    jacobian = flow.jacobian
    found = ""
    for frequency in example.frequencies(amplitude, forcing):
        values = {**example.attached(amplitude), Omega: frequency}
        trace, determinant = evaluate(jacobian.trace(), values), evaluate(jacobian.det(), values)
        if determinant < 0:
            larger = (trace + (trace**2 - 4 * determinant).sqrt()) / 2
            claim("trace negative, one eigenvalue positive", sign(trace) < 0 < sign(larger))
            found = (
                f"At F_0 = 0.040, A = 0.35, Ω = {few(frequency)} the trace is {few(trace)} and an eigenvalue is "
                f"{few(larger)}."
            )
    claim("an unstable point", bool(found))
    boundary = flow.stability.subs({R: flow.R, I: flow.I}).subs(m, flow.friction)
    friction_term = sp.expand(sp.expand(boundary).coeff(mu))
    claim("friction's term in (30)", sp.expand(friction_term - 8 * zeta * Omega / (sp.pi * A)) == 0)
    fold = facts.fold("0.040", "jump-up")
    size = evaluate(friction_term, {zeta: example.zeta, Omega: fold.Omega, A: fold.A}) * example.m * arb.pi() / 4
    return {
        TRUE: {
            "no_hopf": "A Hopf bifurcation needs tr = 0; tr = −2ζ − 2μ/(πΩA) < 0.",
            "friction_marginal": f"μ is in (30) only in 8ζμΩ/(πA). At the jump-up fold of 0.040 this is {few(size)}, "
            f"Ω⁴ is {few(fold.Omega**4)}.",
            "friction_without_zeta": "μ is in (30) only in 8ζμΩ/(πA), which vanishes with ζ.",
        },
        FALSE: {
            "trace_negative": "A negative trace means that the sum of the eigenvalues is negative. If det < 0, one of "
            f"them is positive; (30) detects this. {found}",
            "imaginary_eigenvalue": "At a saddle node det = 0, so the eigenvalues are 0 and tr. A purely imaginary "
            "pair would be a Hopf bifurcation, which the preceding sentence excludes.",
        },
    }


def section_3_3(facts: Facts) -> Verdicts:
    example, onset = facts.example, facts.example.onset
    below = ["0.016", "0.019", "0.0217"]
    above = ["0.025", "F_cr", "0.040", "0.050"]
    claim("no fold below the onset", all(not facts.folds(label) for label in below))
    claim("two folds above the onset", all(len(facts.folds(label)) == 2 for label in above))
    attached, lowest = facts.preload_of_onset
    least, negative = facts.spurious_onset
    roots = [amplitude for amplitude, _ in example.onset_candidates]
    claim("two positive roots of (33)", len(roots) == 2 and onset.A is not roots[0])
    others = facts.other_onsets
    claim("the least root is spurious elsewhere too", all(found[0] < valid for found, valid in others))
    claim("two positive zeros of F_AA at A_s", len(facts.bends_at_onset) == 2)
    spurious, valid, high = facts.detachment_roots
    claim("the middle root of (34) is F_cr", valid.overlaps(example.detachment.F_0))
    claim("depressed cubic", example.polynomials["peak"][2] == 0)
    claim("c_i polynomial", facts.detachment_in_preload)
    return {
        TRUE: {
            "jumps_above_F_SN": f"No fold at {', '.join(below)}, two at 0.025, F_cr, 0.040 and 0.050: all certified up "
            "to A = 1.",
            "triple_root": "F = F_A = F_AA = 0 at (Ω_s, A_s): a triple root in A, among the ten of (24) at that Ω.",
            "solved_numerically": "All its roots were isolated with a certificate.",
            "F_SN_evaluation": f"F(Ω_s, A_s) = 0 gives F_SN = {significant(onset.F_0)}.",
            "depressed_cubic": "F_Ω/(4A) has degree 3 in Ω and no term in Ω².",
            "cubic_root": "Two positive roots; the larger one is Ω_cr, the least forcing at A = u_cr.",
            "F_cr_equation": "F_cr² = R² + I² at (Ω_cr, u_cr).",
            "resultant_even_6": by_equations(
                facts,
                "degree 6, even powers only",
                "detachment_resultant",
                f"Three positive roots with Table 1: {few(spurious)}, {few(valid)}, {few(high)}; F_cr is the middle "
                "one.",
            ),
            "c_i_polynomial": "Once the extraneous factor u_cr⁸ is divided out only even powers of u_cr are left, and "
            "u_cr² = δ_h(2 − δ_h).",
            "preload_range": "With the bracket, (λr)⁻¹: there α = 0, the quasi-zero-stiffness mechanism.",
        },
        LOOSE: {
            "inflection": "Only at F_0 = F_SN, and only if (i) the root A_s lies below u_cr. This holds if and only if "
            "F_A(Ω_2, u_cr) < 0, where Ω_2 is the least positive root of F_AA(Ω, u_cr) = 0; otherwise (33) has no root "
            "that is a point of the response. And (ii) F_SN of (33) is the onset only up to F_0 = 4μ/π + "
            "2ζ√(−u_cr h_1(u_cr)), h_1 = H_1 − A, where the backbone reaches u_cr: from there on folds lie on the "
            "corner that the jump of (6) makes. With the other parameters of Table 1, (i) holds from "
            f"δ_h = {few(attached)}/(λr) on, both hold from δ_h = {few(lowest)}/(λr) on; Table 1 has 1/(2λr).",
            "Omega_s": "At A_s, F_AA = 0 has two positive roots, Ω = "
            + " and ".join(few(x) for x in facts.bends_at_onset)
            + "; only the first satisfies F_A = 0 too.",
            "fixed_preload": "The cubic has closed-form roots in its coefficients, which are functions of δ_h: "
            "Ω_cr(δ_h) and F_cr(δ_h) follow without fixing δ_h.",
        },
        FALSE: {
            "one_positive_root": f"(33) has two positive real roots with Table 1, A = {significant(roots[0])} and "
            f"{significant(roots[1])}.",
            "minimum_root": f"The least positive root with Table 1 is A = {significant(least)}. There F_A and F_AA "
            f"vanish together only at the negative frequency Ω = {significant(negative)}, so this root is not a point "
            f"of the response. A_s = {significant(onset.A)} is the second root. The least root is also spurious for "
            f"{len(others)} other isolators.",
        },
    }


def section_4_1(facts: Facts) -> Verdicts:
    S = {w: facts.S_at_least(w) for w in ("0.48", "0.4", "0.34")}
    claim("S > 1 below 1/2", all(value > 1 for value in S.values()))
    claim("S = 1 above 1/2", facts.S_is_one)
    errors = {}
    for ratio in ("0.2", "0.5", "0.7"):
        averaged, exact = facts.amplitudes_without_stiffening("0.8", ratio)
        errors[ratio] = averaged / exact - 1
    claim("the error grows with friction", abs(errors["0.2"]) < abs(errors["0.5"]) < abs(errors["0.7"]))
    worst = facts.amplitudes_without_stiffening("0.8", "0.785")
    quoted = ", ".join(f"{rounded(100 * value, 1)} % at μ/F_0 = {ratio}" for ratio, value in errors.items())
    return {
        TRUE: {
            "amplitude_unit": "u = sin θ ≤ 1: at u = 1 the push-rod stands vertical.",
            "S_above_half": "With b = π/(2Ω), τ = b − x: the maximand is 1 − f(x)/cos Ωx, f = cos Ωx − Ω tan b sin Ωx "
            "+ Ω sin x/cos b, f(b) = f'(b) = 0 and f'' + Ω²f = Ω(Ω² − 1) sin x/cos b (each proved as an identity). For "
            "Ω > 1/2 the right side is positive on (0, b). So f > 0 there, by Duhamel's integral from b over less than "
            "half a period. The maximand is odd in x, so on (−b, 0) it needs 2 cos Ωx − f > 0 on (0, b): cos Ωx − f "
            "vanishes at 0 and b, satisfies the same equation with the opposite right side, and is positive because Ωb "
            "< π. So the maximand stays below 1, its limit at τ → 0.",
            "kbm_discrepancies": f"From (24) and (35) at Ω = 0.8 the averaged amplitude is off by {quoted}. A_KBM² − "
            "A² = μ²(U² − (16/π²)V²): relative to A² it grows with (μ/F_0)² and as A falls.",
            "kbm_threshold": f"At μ/F_0 = 0.785, just below π/4, and Ω = 0.8: A/F_0 = {few(worst[0])} by averaging, "
            f"{few(worst[1])} by (35).",
        },
        LOOSE: {
            "infinite_stiffness": "The stiffness of the attached expression of (5) grows without bound as u → 1. But "
            "in the piecewise model the springs have left the push-rod at u_cr < 1 for every δ_h < 1, and at θ = π/2 "
            "the force is that of the vertical spring alone.",
        },
        FALSE: {
            "S_below_half": f"S(0.48) ≥ {few(S['0.48'])}, S(0.4) ≥ {few(S['0.4'])}, S(0.34) ≥ {few(S['0.34'])}; at Ω = "
            "1/3, where cos(π/(2Ω)) = 0, U and S are infinite.",
        },
    }


def section_4_2(facts: Facts) -> Verdicts:
    example = facts.example
    detachment = example.detachment
    shares = {"F_cr": facts.friction_share(detachment.Omega, detachment.A)} | {
        label: facts.friction_share(p.Omega, p.A) for label, p in facts.peaks.items()
    }
    claim("friction's share at resonance", all(fraction > arb("0.4") for fraction in shares.values()))
    far = {w: facts.friction_share(arb(w), facts.smallest_amplitude(w, "0.050")) for w in ("0.5", "1.5")}
    claim("larger far from resonance", all(fraction > shares["0.050"] for fraction in far.values()))
    steps = [b - a for a, b in pairwise(facts.F_cr_curve)]
    claim("F_cr rises ever more slowly", all(a > b > 0 for a, b in pairwise(steps)))
    claim("F_cr rises with the preload", facts.rises_with_preload)
    claim("u_cr free of r", all(not value.has(r) for value in [facts.rod.oscillator.exact_ends[0]]))
    gains = {fraction: facts.F_cr_gain(fraction) for fraction in ("1", "10", "100")}
    envelope = (
        "F_cr² is the least of R² + I² at A = u_cr, and only I = 2ζu_crΩ + 4μ/π > 0 contains ζ and μ: by the envelope "
        "theorem ∂F_cr²/∂ζ = 4u_crΩI > 0, ∂F_cr²/∂μ = 8I/π > 0."
    )
    gain_text = ", ".join(f"{rounded(100 * gain, 0)} % at {fraction} %" for fraction, gain in gains.items())
    return {
        TRUE: {
            "u_cr_of_delta_h": "du_cr²/dδ_h = 2(1 − δ_h) > 0.",
            "F_cr_of_delta_h": "On the peak R = −ζI/Ω, so dF_cr²/dδ_h = 2ζI(u_cr'(Ω² + κ) + u_crκ')/Ω, κ = "
            "−h(u_cr)/u_cr. For λr = 3 · 2.03 and wherever Ω_cr² ≥ κ/2 this is positive up to δ_h = 1/(λr): a "
            "polynomial without a root there (Sturm).",
            "unbounded_resonance": "At ζ = 0 and F_0 > 4μ/π every amplitude has a frequency: I does not grow with it.",
            "no_oscillation": "(23) needs F_0 ≥ 4μ/π + 2ζΩA: no fixed point with A > 0 for F_0 ≤ 4μ/π.",
            "viscous_bounded": "(27): A ≤ (F_0 − 4μ/π)/(2ζΩ) at every Ω > 0.",
            "zeta_eq_far": "At F_0 = 0.050 friction's part of (38) over ζ is "
            + ", ".join(f"{few(fraction)} at Ω = {w}" for w, fraction in far.items())
            + " on the lowest branch.",
            "F_cr_damping": envelope,
            "F_cr_roles_differ": "As δ_h → 0, F_cr → 4μ/π: ζ drops out, μ does not.",
            "F_cr_mu_shift": envelope,
        },
        LOOSE: {
            "F_cr_plateau": "With Figure 5's parameters F_cr still rises at δ_h = 1/(λr); its slope over the last 5 % "
            f"of the range is {rounded(100 * steps[-1] / steps[0], 0)} % of that from 5 to 10 %. It flattens, without "
            "a plateau.",
            "F_cr_zeta_no_effect": "True only in the limit: F_cr − 4μ/π falls like 2ζ√(2δ_h). Raising ζ from 0.01 to "
            f"0.05 raises F_cr by {gain_text} of the quasi-zero-stiffness preload.",
        },
        FALSE: {
            "r_only_method": "u_cr depends on δ_h only, and λ and r enter (5) only as the product λr. So the number of "
            "horizontal springs λ also changes the stiffness at a fixed u_cr.",
            "zeta_eq_near_resonance": "At the resonance peaks of the paper's example, the contribution of friction to "
            "(38), divided by ζ, is "
            + ", ".join(f"{few(fraction)} at {label}" for label, fraction in shares.items())
            + ". This is less than away from resonance, but not negligible.",
            "F_cr_limit": "With m = 4μ/π, m ≤ F_cr ≤ m + 2ζu_cr√(−h/u_cr). As u_cr → 0, F_cr → 4μ/π. πμ/4 is less, by "
            "the factor π²/16 = 0.617, and lies in the sticking region, which no F_cr can reach.",
        },
    }


def section_4_3(facts: Facts) -> Verdicts:
    example = facts.example
    detachment, onset = example.detachment, example.onset
    claim("u_cr and F_cr", rounded(example.u_cr, 4) == "0.3970" and rounded(detachment.F_0, 4) == "0.0300")
    claim("Ω_cr", rounded(detachment.Omega, 4) != "0.9288")
    claim("no detached fold at F_cr", all(p.regime == "attached" for p in facts.folds("F_cr")))
    claim("no response at A = 1 at F_cr", example.lowest_forcing(arb(1))[0] > detachment.F_0)
    peaks = [detachment.Omega, *(p.Omega for p in facts.peaks.values())]
    claim("the peak moves towards 1", peaks[0] < peaks[1] < peaks[2] < 1)
    numbers = (rounded(onset.F_0, 4), rounded(onset.Omega, 4), rounded(onset.A, 4))
    claim("the onset", numbers == ("0.0217", "0.7762", "0.1825"))
    ratio = {label: few(example.m / facts.forcing(label)) for label in ("F_SN", "0.050")}
    wrong = facts.table_2_differing
    return {
        TRUE: {
            "example_u_cr_F_cr": "Both are roundings of the derived values.",
            "detachment_onset": "F_cr is the least forcing at A = u_cr; above it the response passes u_cr near Ω_cr.",
            "F_cr_rate": "Its increments over equal steps of δ_h decrease throughout, at 20 points up to 1/(λr).",
            "beyond_limit": "α = 1 − 3rδ_h < 0 for δ_h > (3r)⁻¹.",
            "below_F_cr": "At F_cr, u_cr is reached at one point only, no fold lies beyond it, and A = 1 is not "
            "reached: no response beyond u_cr, not even an isolated one.",
            "above_F_cr": "For F_0 > F_cr, A = u_cr at two frequencies, and the response is beyond it between them.",
            "peak_shift": "Peaks at F_cr, 0.040, 0.050: Ω = " + ", ".join(rounded(x, 4) for x in peaks) + ".",
            "F_SN_prevents": "F_SN is right; it belongs to the second root of (33), not to the least one.",
            "no_multistability": "No fold at or below F_SN in either regime: the response is single-valued.",
            "inflection_point": f"({significant(onset.Omega)}, {significant(onset.A)}).",
            "phase_dissipation": f"sin φ = −(2ζAΩ + 4μ/π)/F_0: its friction part alone is {ratio['F_SN']} at F_SN, "
            f"{ratio['0.050']} at 0.050.",
        },
        LOOSE: {
            "phase_undamped": "Away from resonance sin φ → −2ζAΩ/F_0 as F_0 grows, small but not 0; at the peak φ "
            "stays near −π/2 whatever the forcing.",
        },
        FALSE: {
            "example_Omega_cr": f"Ω_cr = {significant(detachment.Omega)}, 0.9279; 0.9288 is the jump-down frequency at "
            "F_0 = 0.0300.",
            "jump_points": f"{wrong} of the 16 printed frequencies and amplitudes are not the solutions of (24) and "
            "(30); see Table 2.",
        },
    }


def conclusions(facts: Facts) -> Verdicts:
    gain = facts.F_cr_gain("10")
    claim("ζ raises F_cr at a tenth of the preload", gain > arb("0.5"))
    slowest = (-2 * arb.pi() * 100 * facts.example.zeta / arb("1.5")).exp()
    return {
        TRUE: {
            "conclusion_2_frequency": "The natural frequency is √α, and α falls with δ_h.",
        },
        LOOSE: {
            "conclusion_1_algebraic": "Algebraic in Ω always, in A while attached; beyond u_cr, H_2 contains ψ_0 = "
            "arccos(u_cr/A): transcendental in A.",
            "conclusion_2_zeta_eq": "(38) contains the amplitude of the response, not of the forcing; and near "
            "resonance friction's effect is not small (Section 4.2).",
            "conclusion_4_resultants": "Both resultants have roots that solve neither problem; the paper's rule for "
            "(33) selects such a root (Section 3.3).",
            "smoothed_equation": "(A1) smooths (3) with the untruncated force of (5), not the rescaled (8); and its "
            "spring force is printed as x where u is meant.",
            "transients": f"Viscous damping alone reduces a transient to {few(slowest)} of its size in 100 periods at "
            "Ω = 1.5 (to less at lower Ω); at a fold an eigenvalue is 0, and no number of periods is enough.",
        },
        FALSE: {
            "conclusion_3_zeta": "At a tenth of the quasi-zero-stiffness preload, raising ζ from 0.01 to 0.05 (λ = 3, "
            f"r = 2.03, μ = 0.012) raises F_cr by {rounded(100 * gain, 0)} %, at the full preload by "
            f"{rounded(100 * facts.F_cr_gain('100'), 0)} %.",
        },
        DEFINITION: {
            "conclusion_5_friction": "States the range of the model: continuous motion is assumed in (19).",
        },
    }


#: sentences that repeat another one
REPEATED = {
    "conclusion_2_u_cr": "u_cr_of_delta_h",
    "conclusion_3_mu": "F_cr_mu_shift",
    "conclusion_3_zeta_limit": "F_cr_zeta_no_effect",
    "conclusion_5_threshold": "kbm_threshold",
}
SECTIONS = (section_2, section_3_1, section_3_2, section_3_3, section_4_1, section_4_2, section_4_3, conclusions)


def claim_rows(facts: Facts) -> list[Row]:
    """One row for each entry of CLAIMS, in the paper's order."""
    decided = {name: (TRUE, by_equations(facts, *of)) for name, of in BY_EQUATIONS.items()}
    for section in SECTIONS:
        for verdict, sentences in section(facts).items():
            decided |= {name: (verdict, evidence) for name, evidence in sentences.items()}
    decided |= {name: decided[other] for name, other in REPEATED.items()} | measured.decided(measured.load())
    return [
        Row(one.id, "claim", one.where, "", one.sentence, "", decided[one.id][0], evidence=decided[one.id][1])
        for one in published.CLAIMS
    ]
