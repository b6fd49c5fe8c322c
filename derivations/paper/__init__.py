"""The paper, section by section: from the equation of motion (1) to the critical forcings (33), (34).

    equation_of_motion   (1)-(7)    dimensionless form, Taylor coefficients, where the springs detach
    averaging            (8)-(20)   variation of parameters, averages over the cycle
    restoring_force      (20)-(22), (31), (32)   the averaged restoring force and its derivatives, piece by piece
    slow_flow            (23)-(30), (38)   fixed points, response, phase, backbone, limit envelope, stability
    critical_forcings    (33), (34) by elimination of Omega
    den_hartog           (35)-(37)  the exact motion of the linear oscillator with dry friction

It needs a mechanism (`mechanisms/`) and symbols, nothing else of the derivation.
"""
