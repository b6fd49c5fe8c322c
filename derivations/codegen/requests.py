"""In which form the kernels of mechanism-free modules are requested: one table, by the names of kernels.

In:  the kernels that a step of the derivation states.
Out: `requested`, what `Module` takes of them.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ..kernels import Kernel
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

#: by module, with names of kernels, or * for all that are in neither of the first two:
#:     cells    -- on intervals, and nowhere on doubles
#:     settled  -- in double-double only
#:     from_c   -- called by no Python code: in C, and had from there in Python
#:     in_c     -- in C these too, and no others; all where nothing is said
#:     unlooped -- evaluated once an answer: Python has them as no loop over arrays
#:     others   -- as in `Kernel`
REQUESTS = {
    "slow_flow": {
        "enclosed": f"friction fold_quartic peak_cubic turn peak {_ON_INTERVALS}",
        # friction's number is no double: balls have it
        "searched": f"{_ON_INTERVALS} {_STATES} undamped_rises",
        "paired": "friction",
        "unlooped": "held",
        "from_c": """fold_moves fold_square peak_Omega_A cusp_balance isola_level isola_hessian tail rest isola_Omega
            isola cusp_R peak least_restoring most_restoring level_rise cusp_bend isola_bend Omega_A turn fold_mu0
            isola_mu0 fold_zeta0 undamped undamped_level undamped_Omega undamped_rises""",
        "cells": f"{_STATES} fold_least",
        "settled": " ".join(f"{kind}_step" for kind in EQUATIONS),
    },
    "inertia": {
        "enclosed": "terms peak isola isola_apart",
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
        "enclosed": f"""at_rest released viscous I I_A far R_of_response R_of_peak R_where_stationary static
            turn_share {_SYSTEMS}""",
        "cells": """rest_intercept released_intercept sine_intercept sine_intercept_far I_AA I_AA_far R_of_peak_by_rest
            velocity turn_terms""",
    },
    "off_centre": {
        "generic": "*",
        "from_c": "begin up down ended_along",
        "in_c": "",
        "enclosed": "ended_slopes ended_state ended_along ended_fold beside begin down",
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
        "enclosed": "bent_terms bent_end_0 bent_end_1 bent_end_2 bent_end_3",
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


def requested(module: str, kernels: Iterable[Kernel]) -> dict[str, tuple[Kernel, ...]]:
    """The kernels of a module with the forms requested of each; an error where a name is no kernel's."""
    by_name = {kernel.name: kernel for kernel in kernels}
    requests = {flag: names.split() for flag, names in REQUESTS.get(module, {}).items()}
    apart = {form: requests.pop(form, []) for form in ("cells", "settled")}
    from_c = requests.pop("from_c", [])
    only = [name for names in apart.values() for name in names]
    if unknown := {name for names in (*requests.values(), only, from_c) for name in names} - {"*", *by_name}:
        raise ArithmeticError(f"{module} has no kernels {sorted(unknown)}")
    flags: dict[str, dict[str, bool]] = {name: {} for name in by_name}
    for flag, names in requests.items():
        for name in by_name:
            chosen = name in names or (names == ["*"] and name not in only)
            flags[name] |= {"looped": not chosen} if flag == "unlooped" else {flag: chosen}
    for name in by_name if from_c == ["*"] else from_c:
        flags[name] |= {"in_c": True, "in_python": False}
    stated = {name: replace(kernel, **flags[name]) for name, kernel in by_name.items()}
    return {
        "kernels": tuple(kernel for name, kernel in stated.items() if name not in only),
        **{form: tuple(stated[name] for name in names) for form, names in apart.items()},
    }
