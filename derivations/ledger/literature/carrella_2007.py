"""A vertical spring between two oblique ones: force, stiffness, the condition for none, and how far the mass may go.

x_hat and y_hat are displacements over the free length of an oblique spring, from where it is unloaded and from where it
lies horizontal; alpha is its stiffness over the vertical one, gamma half the distance of the feet over that length.
"""

from typing import Any


def force(x_hat: Any, alpha: Any, gamma: Any, *, xp: Any) -> Any:
    """(9): force. Over vertical stiffness times free length."""
    across = xp.sqrt(1 - gamma**2)
    return x_hat + 2 * alpha * (across - x_hat) * (1 / xp.sqrt(x_hat**2 - 2 * x_hat * across + 1) - 1)


def stiffness(x_hat: Any, alpha: Any, gamma: Any, *, xp: Any) -> Any:
    """(10): stiffness. Over that of the vertical spring."""
    return 1 + 2 * alpha * (1 - gamma**2 / xp.sqrt(x_hat**2 - 2 * x_hat * xp.sqrt(1 - gamma**2) + 1) ** 3)


def gamma_qzs(alpha: Any, *, xp: Any) -> Any:
    """(11): γ for zero stiffness at equilibrium. The geometry."""
    return 2 * alpha / (2 * alpha + 1)


def alpha_qzs(gamma: Any, *, xp: Any) -> Any:
    """(11b): α for zero stiffness at equilibrium. The stiffness ratio."""
    return gamma / (2 * (1 - gamma))


def excursion(gamma: Any, K_o: Any, *, xp: Any) -> Any:
    """(14): excursion at which the stiffness is K_o. From rest, with (11)."""
    return gamma * xp.sqrt(xp.cbrt(1 / (1 - K_o * (1 - gamma))) ** 2 - 1)


def gamma_opt(K_o: Any, *, xp: Any) -> Any:
    """(19): γ for the largest excursion. Approximately: where (14) is largest."""
    return xp.power(2, 3, 1 + K_o / 2)


def cubic_force(y_hat: Any, gamma: Any, *, xp: Any) -> Any:
    """(28): cubic for the force. For (9) about rest, with (11)."""
    return y_hat**3 / (2 * gamma**2 * (1 - gamma))


def cubic_stiffness(y_hat: Any, gamma: Any, *, xp: Any) -> Any:
    """(29): stiffness of the cubic."""
    return 3 * y_hat**2 / (2 * gamma**2 * (1 - gamma))


TITLE = "Three springs, quasi-zero stiffness"
CITATION = (
    "A. Carrella, M. J. Brennan, T. P. Waters, Static analysis of a passive vibration isolator with "
    "quasi-zero-stiffness characteristic, J. Sound Vib. 301 (2007) 678–689"
)
READ_IN = (
    "Sentences: the abstract of the paper. Formulas: S. Krishna B S, A. Varun, V. Sairam, Digital Reproduction, a "
    "report and MATLAB programs that compute the paper's Figures 3 to 12 anew and quote its equations by number."
)
CLAIMS = {
    "Abstract": {
        "unique": "there is a unique relationship between the geometry and the stiffness of the springs that yields a "
        "system with zero dynamic stiffness at the static equilibrium position",
        "monotone": "The dynamic stiffness increases monotonically with displacement either side of the equilibrium "
        "position",
        "angles": "this is least severe when the oblique springs are inclined at an angle between approximately 48° "
        "and 57°",
        "cubic": "the force–displacement characteristic of the system can be approximated by a cubic equation",
    },
}
