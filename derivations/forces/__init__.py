"""Averaged restoring forces (20) of every kind: what a mechanism contributes to the slow flow.

of_mechanism   all steps that need a mechanism
elliptic       the force (5) that is not truncated: elliptic integrals
quadrature     any force, as integrals; `contact`: broken powers behind a gap; `sampled`: a force by its values
harmonics      of the force, of any order
by_parameter   how the average changes with each parameter
monotone       proof that h_AAA is monotone on each piece
repeated       stretches of an algorithm that are gone through many times
"""
