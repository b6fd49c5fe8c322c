"""Offset motion, u = B + A cos psi: under a static load, or where a force is not odd.

offset       whether a motion about the centre stays there
off_centre   the slow flow at a mean B, of a force given as steps
sided        a force that is not odd; `one_end`, of two linear pieces
curved       forces of any kind
"""
