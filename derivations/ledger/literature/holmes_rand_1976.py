"""The amplitude of a damped oscillator with a cubic term in its force, by averaging.

x'' + 2 zeta x' + x + alpha x^3 = phi cos(Omega t), x = A cos(Omega t + theta); y = A^2, rho = 1 - Omega^2,
sigma = 2 zeta Omega.
"""

from typing import Any


def amplitude_polynomial(y: Any, alpha: Any, rho: Any, sigma: Any, phi: Any, *, xp: Any) -> Any:
    """quoted: square of the amplitude. It is where this vanishes."""
    return 9 * alpha**2 * y**3 + 24 * alpha * rho * y**2 + 16 * (rho**2 + sigma**2) * y - 16 * phi**2


def phase(A: Any, sigma: Any, phi: Any, *, xp: Any) -> Any:
    """quoted: phase."""
    return xp.arcsin(-sigma * A / phi)


TITLE = "A cubic spring: amplitude and phase"
CITATION = (
    "P. J. Holmes, D. A. Rand, The bifurcations of Duffing's equation: an application of catastrophe theory, J. Sound "
    "Vib. 44 (1976) 237–253"
)
READ_IN = "A notebook, Duffing Oscillator Bifurcation, that quotes both formulas, without the paper's equation numbers."
