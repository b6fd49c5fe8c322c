"""What is solved for each answer: systems of equations in A and Omega, and their slopes.

along         test functions along A: folds, cusps, isola points; what no state exceeds
frequencies   the quartics whose roots are the frequencies at an amplitude
slopes        along the response and along the fold locus
newton        one Newton step on each system
gradients     how answers move with the parameters
"""
