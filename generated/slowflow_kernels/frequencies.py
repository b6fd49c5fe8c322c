"""The quartics whose roots are the frequencies at an amplitude: F of the response, F_A/2 of the folds.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/systems/frequencies.py; never edit.

Rounding errors were measured with A, F_0 1e-09 to 1000; Omega 0.001 to 1000; h 1e-12 to 1000 of either sign or 0;
h_A 1e-09 to 1e+06 of either sign or 0; k, p 1e-09 to 1000 of either sign; m, zeta 1e-12 to 1 or 0; p_low, q_low,
tail up to 1e-10 of either sign; q 1e-12 to 1000 or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from slowflow.support.backend import from_c

ROUGH = 8.881784197001252e-16
FINE = 3.1554436208840472e-30

__all__ = [
    "FINE", "ROUGH", "cubic", "cubic_fine", "cubic_slope", "discriminant", "fold", "fold_at_0", "fold_beside",
    "fold_derivative", "fold_fine", "response", "response_at_0", "response_beside", "response_derivative",
    "response_exactly_at_0", "response_fine", "rise",
]

#: functions that no Python code calls, which are in C, with their arguments; see generated/c/frequencies.h
FROM_C = {
    "response": "Omega A F_0 m zeta h",
    "response_at_0": "F_0 m h",
    "fold": "Omega A m zeta h h_A",
    "fold_at_0": "h h_A",
    "cubic": "Omega A p q",
    "cubic_slope": "Omega A p",
    "rise": "Omega A p k",
    "response_fine": "Omega A F_0 m zeta h",
    "response_beside": "Omega tail A F_0 m zeta h",
    "response_derivative": "A m zeta h",
    "response_exactly_at_0": "F_0 m h",
    "fold_fine": "Omega A m zeta h h_A",
    "fold_beside": "Omega tail A m zeta h h_A",
    "fold_derivative": "A m zeta h h_A",
    "cubic_fine": "Omega A p p_low q q_low",
    "discriminant": "A p p_low q q_low",
}
globals().update(from_c("frequencies", FROM_C))
