"""The numbers that every oscillator has besides its mechanism's, and which of them are allowed.

Written by `make derive` from derivations/mechanisms/__init__.py; never edit.
"""

from slowflow.support.record import Parameter

# dry friction and viscous damping (4)
DAMPING = (
    Parameter("mu", "dry friction", "k_v L", least=0.0),
    Parameter("zeta", "viscous damping ratio", "2 sqrt(k_v m)", least=0.0),
)
# what an oscillator may dissipate by besides these, and where dry friction acts
DISSIPATION = (
    Parameter("eta", "structural damping, the loss factor of the vertical spring", "1", least=0.0),
    Parameter("c_2", "quadratic damping, the factor of |u'|u'", "m/L", least=0.0),
    Parameter("c_3", "cubic damping, the factor of u'^3", "sqrt(m^3/k_v)/L^2", least=0.0),
    Parameter("zeta_2", "growth of the viscous damping ratio with u^2", "2 sqrt(k_v m)/L^2", least=0.0),
)
CONTACTS = {
    "throughout": "dry friction acts at every displacement",
    "attached": "it acts while |u| is below the first breakpoint",
}
# what the amplitude F_0 of an excitation is of (4); that of a force, and those of inertia, whose force is F_0 Omega^2
EXCITATIONS = {
    "force": Parameter("F_0", "forcing amplitude", "k_v L", above=0.0),
    "base": Parameter("F_0", "displacement amplitude of the base; u is relative to the base", "L", above=0.0),
    "unbalance": Parameter("F_0", "unbalanced mass times its radius", "m L", above=0.0),
}
