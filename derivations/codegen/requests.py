"""In which form the kernels of mechanism-free modules are requested: one table, by the names of kernels.

In:  the kernels that a step of the derivation states.
Out: `requested`, what `Module` takes of them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ..kernels import ARITHMETICS, Kernel
from ..systems.newton import EQUATIONS

#: systems of functions that vanish together, which the search in boxes takes on numbers and on intervals
_SYSTEMS = " ".join(
    f"{system}_{unknowns}"
    for system in ("folds", "peaks", "cusps", "isolas", "turns")
    for unknowns in ("by_R", "by_Omega", *(("far_by_R", "far_by_x") if system != "turns" else ()))
)

#: what the solvers of slow flow and their proofs evaluate on whole intervals only; in Python proofs in balls do
_ON_INTERVALS = """F_A F_AA fold fold_zeta0 isola isola_mu0 cusps cusp_R cusp intercept R F F_Omega F_OmegaOmega
    F_AOmega level backbone least_restoring most_restoring isola_Omega level_rise cusp_bend isola_bend
    undamped_Omega"""
_STATES = "F_Omega_reduced F_Omega_reduced_mu0 F_Omega_reduced_zeta0 state_R state"
#: of other laws of damping on intervals only
_APART = """rest_intercept released_intercept sine_intercept sine_intercept_far I_AA I_AA_far R_of_peak_by_rest
    velocity turn_terms"""
_STEPS = " ".join(f"{kind}_step" for kind in EQUATIONS)

#: by module, with names of kernels, or * for all that are on doubles:
#:     apart    -- on no doubles, but on other numbers only
#:     from_c   -- called by no Python code: in C, and had from there in Python
#:     in_c     -- in C these too, and no others; all where nothing is said
#:     unlooped -- evaluated once an answer: Python has them as no loop over arrays
#:     others   -- as in `Kernel`, or one of its `ARITHMETICS`
REQUESTS = {
    "slow_flow": {
        "intervals": f"friction fold_quartic peak_cubic turn peak fold_least {_ON_INTERVALS} {_STATES}",
        "enclosures": f"{_ON_INTERVALS} {_STATES} undamped_rises",
        "pairs": f"friction {_STEPS}",
        # its number is no double
        "balls": "friction",
        "unlooped": "held",
        "from_c": """fold_moves fold_square peak_Omega_A cusp_balance isola_level isola_hessian tail rest isola_Omega
            isola cusp_R peak least_restoring most_restoring level_rise cusp_bend isola_bend Omega_A turn fold_mu0
            isola_mu0 fold_zeta0 undamped undamped_level undamped_Omega undamped_rises""",
        "apart": f"{_STATES} fold_least {_STEPS}",
    },
    "inertia": {
        "intervals": "terms peak isola isola_apart",
        "unlooped": "amplitude moves_from",
        "from_c": """terms hessian fold_force fold_level fold_slopes force_slopes level_slope least_Omega_A peak_share
            Omega_of_share isola_apart peak isola cusp_bend bound least share Omega_A""",
    },
    "second_approximation": {"from_c": "detachment_by_inertia folds"},
    "dissipation": {
        "generic": "*",
        "from_c": f"""restoring viscous_moves far response_polynomial fold_polynomial structural_bound quadratic_bound
            R_of_peak F_A_halved Omega_A Omega_A_by_inertia released_moves F_AOmegaOmega cusp_bend_by_inertia
            isola_bend_by_inertia F_OmegaOmega cusp_bend isola_bend static R_of_response R_where_stationary
            turn_share {_SYSTEMS}""",
        "in_c": """quadratic cubic at_rest rest_moves released viscous I I_A F F_A F_AA far_by_inertia limit_envelope
            full_by_inertia""",
        "intervals": f"""at_rest released viscous I I_A far R_of_response R_of_peak R_where_stationary static
            turn_share {_SYSTEMS} {_APART}""",
        "apart": _APART,
    },
    "off_centre": {
        "generic": "*",
        "from_c": "begin up down ended_along",
        "in_c": "",
        "intervals": "ended_slopes ended_state ended_along ended_fold beside begin down",
    },
    "linearization": {
        "generic": "*",
        "from_c": "steepest resonance",
        "in_c": "over_displacements equivalent_damping damping_force response",
    },
    "sensitivities": {"generic": "*", "from_c": "right of_state by_force by_inertia"},
    "sampled": {
        "generic": "*",
        "from_c": """averaged_terms averaged_end intercept_terms intercept_end harmonics_terms harmonics_end bent_terms
            bent_end_0 bent_end_1 bent_end_2 bent_end_3""",
        "in_c": "at_rest",
        "intervals": "bent_terms bent_end_0 bent_end_1 bent_end_2 bent_end_3",
    },
    "frequencies": {"from_c": "*"},
    # the recurrences of `taylor` are the rates in C; only the paper's own way is smoothed
    "motion": {
        "generic": "*",
        "from_c": "turned",
        "in_c": """push push_slopes breakaway acceleration resistance across released rates_by_state rates_by_parameter
            structural""",
    },
}


def requested(module: str, kernels: Iterable[Kernel]) -> tuple[Kernel, ...]:
    """The kernels of a module with the forms requested of each; an error where a name is no kernel's."""
    requests = {form: names.split() for form, names in REQUESTS.get(module, {}).items()}
    by_name = {kernel.name: kernel for kernel in kernels}
    if unknown := {name for names in requests.values() for name in names} - {"*", *by_name}:
        raise ArithmeticError(f"{module} has no kernels {sorted(unknown)}")

    def of(kernel: Kernel) -> Kernel:
        forms = {form for form, names in requests.items() if kernel.name in names or names == ["*"]}
        if "apart" not in forms:
            forms.add("doubles")
        return replace(
            kernel,
            arithmetics=tuple(one for one in ARITHMETICS if one in forms),
            generic="generic" in forms,
            looped="unlooped" not in forms,
            in_c="in_c" not in requests or bool(forms & {"in_c", "from_c"}),
            in_python="from_c" not in forms,
        )

    return tuple(map(of, by_name.values()))
