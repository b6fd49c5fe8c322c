"""What the dimensionless numbers of every oscillator are measured in, by name (4): powers of k_v, L and m.

Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/extensions/inertia.py,
derivations/extensions/scaling.py; never edit.
"""

from slowflow.support.record import Scale

SCALES = {
    "u": Scale("x", 1.0, (0.0, 1.0, 0.0)),
    "tau": Scale("t", 1.0, (-0.5, 0.0, 0.5)),
    "Omega": Scale("omega", 1.0, (0.5, 0.0, -0.5)),
    "F_0": Scale("F", 1.0, (1.0, 1.0, 0.0)),
    "mu": Scale("F_c", 1.0, (1.0, 1.0, 0.0)),
    "zeta": Scale("c", 2.0, (0.5, 0.0, 0.5)),
    "c_2": Scale("c_q", 1.0, (0.0, -1.0, 1.0)),
    "c_3": Scale("c_c", 1.0, (-0.5, -2.0, 1.5)),
    "eta": Scale("eta", 1.0, (0.0, 0.0, 0.0)),
    "zeta_2": Scale("c_xx", 2.0, (0.5, -2.0, 0.5)),
}
#: of F_0, by what it is the amplitude of
AMPLITUDES = {
    "force": Scale("F", 1.0, (1.0, 1.0, 0.0)),
    "base": Scale("Y", 1.0, (0.0, 1.0, 0.0)),
    "unbalance": Scale("U", 1.0, (0.0, 1.0, 1.0)),
}
