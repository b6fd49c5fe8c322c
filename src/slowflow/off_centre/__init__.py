"""Motions off the centre, u = B + A cos psi: the averaged questions where a load or the motion itself moves the mean.

means      of a piecewise polynomial and its derivatives over a cycle, at numbers and on boxes
curved     what a force has beside its steps that is no polynomial, by sums, at numbers and on boxes
smooth     where such a force is smooth, and where it holds motions back
flow       what excites and what dissipates: frequencies, levels and bounds at points and on boxes
boxes      all solutions of a few equations in a box, by exclusion and Krawczyk's test
turning_points     the means by the motion's ends, in which nothing is singular next to a jump of the force
by_turning_points  what vanishes at rest, where a motion comes to a step, at states and at folds, in these
solution_sheets    the balance of the mean as cells that hold all of it, for all questions
complete   all states, folds and corners
onset      the lowest forcing with a fold, and that none is below
reach      how far motions go at a forcing, up to which frequency they transmit a level, and that none is beyond
curve      the response as curves, from all folds and all states at frequencies between
sensitivities      how answers move with parameters and load
questions  `OffCentre`, what a user asks
answers    what is answered
many       the same of arrays of designs
"""
