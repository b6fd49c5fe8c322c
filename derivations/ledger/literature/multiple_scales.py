"""The same oscillator by the method of multiple scales, to first order.

x'' + omega_0^2 x + epsilon (2 mu x' + alpha x^3) = epsilon F cos(Omega t), Omega = omega_0 + epsilon sigma,
x = a cos(Omega t - gamma); T_1 = epsilon t.
"""

from typing import Any


def frequency(a: Any, omega_0: Any, alpha: Any, epsilon: Any, *, xp: Any) -> Any:
    """Unforced oscillator: backbone."""
    return omega_0 + epsilon * 3 * alpha * a**2 / (8 * omega_0)


def amplitude_rate(a: Any, gamma: Any, mu: Any, F: Any, omega_0: Any, *, xp: Any) -> Any:
    """Primary resonance: da/dT_1."""
    return -mu * a + F / (2 * omega_0) * xp.sin(gamma)


def phase_rate(a: Any, gamma: Any, sigma: Any, alpha: Any, F: Any, omega_0: Any, *, xp: Any) -> Any:
    """Primary resonance: dγ/dT_1."""
    return sigma - 3 * alpha * a**2 / (8 * omega_0) - F / (2 * omega_0 * a) * xp.cos(gamma)


def response(a: Any, sigma: Any, mu: Any, alpha: Any, F: Any, omega_0: Any, *, xp: Any) -> Any:
    """Primary resonance: frequency response. Lhs - rhs."""
    return (sigma - 3 * alpha * a**2 / (8 * omega_0)) ** 2 + mu**2 - (F / (2 * omega_0 * a)) ** 2


def cusp(*, xp: Any) -> Any:
    """Bistability: F²α/σ³ at the cusp. There the region of three states begins."""
    return xp.rational(256, 81)


def relaxation(epsilon: Any, mu: Any, *, xp: Any) -> Any:
    """Transient dynamics: time constant at the peak. Of a disturbance of the amplitude."""
    return 1 / (epsilon * mu)


TITLE = "A cubic spring by multiple scales"
CITATION = (
    "Solving the Duffing Equation with Multiple-scale Analysis, an article of the encyclopedia Sciencepedia; the "
    "method as in A. H. Nayfeh, D. T. Mook, Nonlinear Oscillations (1979), § 4.1"
)
READ_IN = "The article, section Principles and Mechanisms. The book was not read."
CLAIMS = {
    "Bistability": {
        "universal": "the location of the cusp point is universally characterized by the dimensionless ratio",
    },
    "Transient dynamics": {
        "exponential": "at the peak of the resonance curve ... the transient approach to the steady-state amplitude is "
        "a simple exponential decay governed by the damping coefficient",
    },
}
