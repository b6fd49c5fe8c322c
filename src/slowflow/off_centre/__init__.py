"""Motions off the centre, u = B + A cos psi: the averaged questions where a load or the motion itself moves the mean.

means      of a piecewise polynomial and its derivatives over a cycle, at numbers and on boxes
boxes      all solutions of a few equations in a box, by exclusion and Krawczyk's test
equations  what vanishes at states, at folds, at rest and where the springs detach, in the form that `boxes` takes
onset      the lowest forcing with a fold, and that none is below
questions  `OffCentre`, what a user asks
answers    what is answered
"""
