"""The same oscillator by the method of multiple scales, to first order.

x'' + omega_0^2 x + epsilon (2 mu x' + alpha x^3) = epsilon F cos(Omega t), Omega = omega_0 + epsilon sigma,
x = a cos(Omega t - gamma); T_1 = epsilon t.
"""

from typing import Any

from . import Claim, Formula, Publication


def frequency(a: Any, omega_0: Any, alpha: Any, epsilon: Any, *, xp: Any) -> Any:
    """The frequency of the free oscillation."""
    return omega_0 + epsilon * 3 * alpha * a**2 / (8 * omega_0)


def amplitude_rate(a: Any, gamma: Any, mu: Any, F: Any, omega_0: Any, *, xp: Any) -> Any:
    """da/dT_1."""
    return -mu * a + F / (2 * omega_0) * xp.sin(gamma)


def phase_rate(a: Any, gamma: Any, sigma: Any, alpha: Any, F: Any, omega_0: Any, *, xp: Any) -> Any:
    """dgamma/dT_1."""
    return sigma - 3 * alpha * a**2 / (8 * omega_0) - F / (2 * omega_0 * a) * xp.cos(gamma)


def response(a: Any, sigma: Any, mu: Any, alpha: Any, F: Any, omega_0: Any, *, xp: Any) -> Any:
    """The frequency-response equation, lhs - rhs."""
    return (sigma - 3 * alpha * a**2 / (8 * omega_0)) ** 2 + mu**2 - (F / (2 * omega_0 * a)) ** 2


def cusp(*, xp: Any) -> Any:
    """F^2 alpha/sigma^3 where the region of three states begins."""
    return xp.rational(256, 81)


def relaxation(epsilon: Any, mu: Any, *, xp: Any) -> Any:
    """The time in which a disturbance of the amplitude dies out at the peak."""
    return 1 / (epsilon * mu)


PUBLICATION = Publication(
    name="multiple_scales",
    title="A cubic spring by multiple scales",
    citation="Solving the Duffing Equation with Multiple-scale Analysis, an article of the encyclopedia Sciencepedia; "
    "the method as in A. H. Nayfeh, D. T. Mook, Nonlinear Oscillations (1979), § 4.1",
    read_in="The article, section Principles and Mechanisms. The book was not read.",
    formulas=(
        Formula("Unforced oscillator", "backbone", frequency),
        Formula("Primary resonance", "da/dT_1", amplitude_rate),
        Formula("Primary resonance", "dγ/dT_1", phase_rate),
        Formula("Primary resonance", "frequency response", response),
        Formula("Bistability", "F²α/σ³ at the cusp", cusp),
        Formula("Transient dynamics", "time constant at the peak", relaxation),
    ),
    claims=(
        Claim(
            "universal",
            "Bistability",
            "the location of the cusp point is universally characterized by the dimensionless ratio",
        ),
        Claim(
            "exponential",
            "Transient dynamics",
            "at the peak of the resonance curve ... the transient approach to the steady-state amplitude is a simple "
            "exponential decay governed by the damping coefficient",
        ),
    ),
)
