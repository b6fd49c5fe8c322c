"""Measured phases of a frame in frictional contact with its base: the file of this name with the ending csv.

A mass on a linear spring with dry friction and next to no viscous damping, driven harmonically: phases by which the
motion lags the driving force.
"""

TITLE = "A frame in frictional contact with its base: measured phases"
CITATION = (
    "L. Marino, A. Cicirello, Experimental investigation of a single-degree-of-freedom system with Coulomb friction, "
    "Nonlinear Dynamics 99 (2020) 1781–1799, doi:10.1007/s11071-019-05443-2"
)
READ_IN = (
    "Sentence: the abstract. Phases: the table of the case with a fixed wall, as used by A. Lye, L. Marino, A. "
    "Cicirello, E. Patelli, doi:10.1115/1.4056934."
)
CLAIMS = {
    "Abstract": {
        "friction_damping": "the development of an experimental set-up capable of reproducing friction damping effects "
        "on a harmonically excited SDoF system",
    },
}
