"""What is solved for each answer: systems of equations in A and Omega, their slopes and bounds.

along         test functions along A: folds, cusps, isola points
frequencies   the quartics whose roots are the frequencies at an amplitude
slopes        along the response and along the fold locus
newton        one Newton step on each system
gradients     how answers move with the parameters
bounds        what no steady state exceeds
"""
