"""The numbers that every oscillator has beside its mechanism's, and which of them are allowed.

Written by `make derive`; never edit.
Input: derivations/mechanisms/__init__.py
"""

from slowflow_support.record import Parameter

# dry friction and viscous damping (4)
DAMPING = (
    Parameter("mu", "dry friction", "k_v L", least=0.0),
    Parameter("zeta", "viscous damping ratio", "2 sqrt(k_v m)", least=0.0),
)
# excitation (4)
FORCING = Parameter("F_0", "forcing amplitude", "k_v L", above=0.0)
