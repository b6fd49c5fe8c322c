"""The symbols that all steps share: the paper's letters, dimensionless unless it says so. Nothing comes in."""

import sympy as sp

# slow variables, frequency, forcing and damping (4), (11)
A, Omega, F_0 = sp.symbols("A Omega F_0", positive=True)
mu, zeta = sp.symbols("mu zeta", nonnegative=True)
# other laws of damping: loss factor of the vertical spring, factors of |u'|u' and u'^3, what zeta grows by with u^2
eta, c_2, c_3, zeta_2 = sp.symbols("eta c_2 c_3 zeta_2", nonnegative=True)
phi = sp.Symbol("phi", real=True)
psi = sp.Symbol("psi", real=True)
tau = sp.Symbol("tau", nonnegative=True)
sigma, epsilon = sp.symbols("sigma epsilon", real=True)

# displacement, dimensionless; the argument of every restoring force
u = sp.Symbol("u", real=True)

# averaged restoring force, h = H - A, and its derivatives with respect to A, while the mechanism is left open
h, h_A, h_AA, h_AAA = sp.symbols("h h_A h_AA h_AAA", real=True)
