"""The force at which the response of an oscillator with a cubic term in its force begins to jump.

m x'' + 2 lambda m x' + m omega_0^2 x + m beta x^3 = f cos(gamma t). epsilon = gamma - omega_0; b is the amplitude;
kappa b^2 is the change of the free oscillation's frequency with b. A subscript k is for the point at which jumps begin.
"""

from typing import Any


def detuning(epsilon: Any, lam: Any, *, xp: Any) -> Any:
    """§ 29: detuning at the onset. Before (29.7): where the two roots of (29.5) coincide, lhs - rhs."""
    return epsilon**2 - 3 * lam**2


def amplitude(epsilon: Any, kappa: Any, *, xp: Any) -> Any:
    """§ 29: amplitude at the onset, squared. Before (29.7)."""
    return 2 * epsilon / (3 * kappa)


def critical_force(m: Any, omega_0: Any, lam: Any, kappa: Any, *, xp: Any) -> Any:
    """(29.7): force at the onset, squared."""
    return 32 * m**2 * omega_0**2 * lam**3 / (3 * xp.sqrt(3) * kappa)


TITLE = "A cubic spring: where jumps begin"
CITATION = (
    "L. D. Landau, E. M. Lifshitz, Mechanics (Course of Theoretical Physics 1), § 29, Resonance in non-linear "
    "oscillations"
)
READ_IN = "The book: the end of § 29, from its Fig. 32 to (29.8)."
CLAIMS = {
    "§ 29": {
        "inflection": "for f = f_k the section CD reduces to a point of inflection",
    },
}
