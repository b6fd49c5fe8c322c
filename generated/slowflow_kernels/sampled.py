"""The average of a force that is known by its values and those of its derivatives, u = A sine.

Written by `make derive` from derivations/forces/quadrature.py, derivations/forces/sampled.py; never edit.

Rounding errors were measured with A, b 1e-09 to 1000; cosine, sine 1e-09 to 1; f, f_u, f_uu, f_uuu, f_uuuu, lost_0,
lost_1, lost_2, lost_3 1e-09 to 1000 of either sign or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from slowflow.support.backend import from_c

__all__ = [
    "at_rest", "averaged_end", "averaged_terms", "bent_end_0", "bent_end_1", "bent_end_2", "bent_end_3",
    "bent_terms", "harmonics_end", "harmonics_terms", "intercept_end", "intercept_terms",
]


def at_rest(f: Any) -> Any:
    """h as A tends to 0.

    Equation (20). Domain: any. Operations: 1. Error / u (1 + kappa): measured 0.73.
    """
    return -1.2732395447351628 * f

#: functions that no Python code calls, which are in C, with their arguments; see generated/c/sampled.h
FROM_C = {
    "averaged_terms": "sine f f_u f_uu f_uuu",
    "averaged_end": "A b lost_0 lost_1 lost_2",
    "intercept_terms": "A sine cosine f_uu",
    "intercept_end": "A b lost_0 lost_1",
    "harmonics_terms": "sine f f_u f_uu f_uuu",
    "harmonics_end": "A b lost_0 lost_1 lost_2",
    "bent_terms": "sine f f_uuuu",
    "bent_end_0": "A b lost_0 lost_1 lost_2 lost_3",
    "bent_end_1": "A b lost_1 lost_2 lost_3",
    "bent_end_2": "A b lost_2 lost_3",
    "bent_end_3": "A b lost_3",
}
globals().update(from_c("sampled", FROM_C))
