"""Positive frequencies at a given amplitude: in go A, h, damping and F_0, out come sorted Omega and their number.

=================  =========================================  ==========  ==================
function           equation                                   paper       roots
=================  =========================================  ==========  ==================
`response_roots`   F = R^2 + (I - F_0)(I + F_0) = 0           (24)        0, 1, 2 or 3
`fold_roots`       F_A/2 = R (w^2 + h_A) + 2 zeta w I = 0     (30)        0, 1, 2 or 3
`peak_roots`       F_Omega/(4 A) = w R + zeta I = 0           (34)        0, 1 or 2
`law_roots`        the first two with I of `I_by_laws`        –           0, 1, 2 or 3
`law_peak_roots`   where the level is stationary, likewise    –           0, 1 or 2
=================  =========================================  ==========  ==================

with R = A w^2 + h and I = 2 zeta A w + m; by other laws of damping I = m + eta A + 2 zeta A w + d (A w)^2. All is
dimensionless. The methods stand in native/roots.h and native/laws.h.

- Roots of the first three are counted with multiplicity: a curve that touches zero, to within the error of
  double-double, gives its double root twice, so that branches keep their partner up to the point where they meet.
- A root at w = 0 is not positive and is not counted. Unused places are NaN.
- The domain of the first three is A > 0, m >= 0, zeta >= 0, F_0 >= 0, all finite, h_A of any finite size; outside it
  the count is -1 and all places are NaN. Their error is at most u (1 + kappa), u = 2^-53, kappa the condition number of
  the root in the arguments, if squares of the arguments do not overflow and the square of F_0 stays above 1e-290.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from slowflow.backend import SOLVER

Floats = NDArray[np.float64]
Counts = NDArray[np.int32]


def response_roots(A: ArrayLike, h: ArrayLike, m: ArrayLike, zeta: ArrayLike, F_0: ArrayLike) -> tuple[Floats, Counts]:
    """All Omega > 0 of the response curve F = 0, equation (24), at amplitude A under the forcing F_0.

    The arguments broadcast and are dimensionless: A the amplitude, h = H(A) - A the averaged restoring force,
    m = 4 mu/pi the averaged friction, zeta the damping ratio, F_0 the forcing.  Returns Omega, shape (..., 3), rising,
    padded with NaN, and the number of roots, shape (...), -1 outside the domain (see the module); nothing is raised but
    for arguments that do not broadcast.  With F_0 < m there is no root.
    """
    found: tuple[Floats, Counts] = SOLVER.response_roots(A, h, m, zeta, F_0)
    return found


def fold_roots(A: ArrayLike, h: ArrayLike, h_A: ArrayLike, m: ArrayLike, zeta: ArrayLike) -> tuple[Floats, Counts]:
    """All Omega > 0 of the fold locus F_A = 0, equation (30), at amplitude A; the forcing there is sqrt(R^2 + I^2).

    h_A is the derivative of h, of either sign and any finite size.  Otherwise as in `response_roots`.
    """
    found: tuple[Floats, Counts] = SOLVER.fold_roots(A, h, h_A, m, zeta)
    return found


def peak_roots(A: ArrayLike, h: ArrayLike, m: ArrayLike, zeta: ArrayLike) -> tuple[Floats, Counts]:
    """All Omega > 0 of the peak locus F_Omega = 0, in (34), at amplitude A; the forcing there is sqrt(R^2 + I^2).

    Returns Omega, shape (..., 2), and the number of roots; otherwise as in `response_roots`.
    """
    found: tuple[Floats, Counts] = SOLVER.peak_roots(A, h, m, zeta)
    return found


def law_roots(
    A: ArrayLike, h: ArrayLike, h_A: ArrayLike, damping: tuple[float, ...], F_0: float, inertial: bool
) -> Floats:
    """All Omega > 0 of the response at F_0, or for F_0 < 0 of the fold locus, by any law: shape (..., 3), rising.

    damping -- m, zeta, eta, d, dimensionless; inertial -- whether F_0 Omega^2 excites
    """
    found: Floats = SOLVER.law_roots(A, h, h_A, *damping, F_0, inertial)
    return found


def law_peak_roots(A: ArrayLike, h: ArrayLike, damping: tuple[float, ...], inertial: bool) -> Floats:
    """All Omega > 0 at which the level of an amplitude is stationary: shape (..., 2), rising; see `law_roots`."""
    found: Floats = SOLVER.law_peak_roots(A, h, *damping, inertial)
    return found
