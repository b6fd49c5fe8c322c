"""The frequencies at which a damped oscillator with a cubic term in its force has a given amplitude.

mu q'' + zeta q' + kappa q + gamma q^3 = P cos(Om t); a is the amplitude. The formulas have neither mu nor kappa: the
program sets both to 1.
"""

from typing import Any


def upper_frequency(a: Any, zeta: Any, gamma: Any, P: Any, *, xp: Any) -> Any:
    """Om_ana(i,1): higher frequency."""
    root = xp.sqrt(P**2 / a**2 + zeta**4 / 4 - zeta**2 - 3 * zeta**2 * gamma * a**2 / 4)
    return xp.sqrt(1 - zeta**2 / 2 + 3 * gamma * a**2 / 4 + root)


def lower_frequency(a: Any, zeta: Any, gamma: Any, P: Any, *, xp: Any) -> Any:
    """Om_ana(i,2): lower frequency."""
    root = xp.sqrt(P**2 / a**2 + zeta**4 / 4 - zeta**2 - 3 * zeta**2 * gamma * a**2 / 4)
    return xp.sqrt(1 - zeta**2 / 2 + 3 * gamma * a**2 / 4 - root)


TITLE = "A cubic spring by harmonic balance: NLvib's first example"
CITATION = (
    "M. Krack, J. Gross, Harmonic Balance for Nonlinear Vibration Problems (Springer, 2019), "
    "doi:10.1007/978-3-030-14023-6"
)
READ_IN = "The program of the book, NLvib 1.3, EXAMPLES/01_Duffing/Duffing.m. The book was not read."
CLAIMS = {
    "comment": {
        "two_frequencies": "For each amplitude, determine the two associated excitation frequencies",
    },
}
