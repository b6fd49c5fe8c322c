"""A cubic, or a quadratic, term in the force, with linear or nonlinear damping: slow flow of first and second order.

x = u cos(omega t) + v sin(omega t). A dot is the derivative by slow time. The oscillators are

    x'' + gamma x' + (omega_0^2 - lam cos(2 omega t)) x + alpha x^3 + eta x^2 x' + F cos(omega t) = 0     balances
    x'' + gamma x' + omega_0^2 x + beta x^2 + alpha x^3 = F cos(2 omega t)                    rates, by averaging
    x'' + gamma x' + omega_0^2 x = F cos(omega t)                                             forced rates, the same
"""

from typing import Any

# several terms to a line, as the program prints them
# fmt: off


def cosine_balance(
    u: Any, v: Any, u_dot: Any, v_dot: Any, omega: Any, omega_0: Any, gamma: Any, alpha: Any, eta: Any, lam: Any,
    F: Any, *, xp: Any,
) -> Any:
    """driven resonator: cosine balance. Lhs - rhs."""
    return (
        F - u * lam / 2 + 2 * v_dot * omega + u_dot * gamma - u * omega**2 + u * omega_0**2 + v * gamma * omega
        + 3 * u**3 * alpha / 4 + 3 * u**2 * u_dot * eta / 4 + u * v_dot * v * eta / 2 + 3 * u * v**2 * alpha / 4
        + v**2 * u_dot * eta / 4 + u**2 * v * eta * omega / 4 + v**3 * eta * omega / 4
    )


def sine_balance(
    u: Any, v: Any, u_dot: Any, v_dot: Any, omega: Any, omega_0: Any, gamma: Any, alpha: Any, eta: Any, lam: Any,
    *, xp: Any,
) -> Any:
    """driven resonator: sine balance. Lhs - rhs."""
    return (
        v_dot * gamma + v * lam / 2 - 2 * u_dot * omega - u * gamma * omega - v * omega**2 + v * omega_0**2
        + u**2 * v_dot * eta / 4 + 3 * u**2 * v * alpha / 4 + u * v * u_dot * eta / 2 + 3 * v_dot * v**2 * eta / 4
        + 3 * v**3 * alpha / 4 - u**3 * eta * omega / 4 - u * v**2 * eta * omega / 4
    )


def u_rate(u: Any, v: Any, omega: Any, omega_0: Any, gamma: Any, alpha: Any, beta: Any, F: Any, *, xp: Any) -> Any:
    """three-wave mixing, order 2: du/dT."""
    return (
        -u * gamma * omega / 2 - v * omega**2 / 2 + v * omega_0**2 / 2 + 3 * u**2 * v * alpha / 8 + 3 * v**3 * alpha / 8
    ) / omega + (
        F * v * beta * omega**5 / 6 - 5 * u**2 * v * beta**2 * omega**5 / 12 - 5 * v**3 * beta**2 * omega**5 / 12
        - v * gamma**2 * omega**7 / 8 - v * omega**9 / 8 + v * omega**7 * omega_0**2 / 4 - v * omega**5 * omega_0**4 / 8
        + 3 * u**2 * v * alpha * omega**7 / 8 - 3 * u**2 * v * alpha * omega**5 * omega_0**2 / 8
        + 3 * v**3 * alpha * omega**7 / 8 - 3 * v**3 * alpha * omega**5 * omega_0**2 / 8
        - 51 * u**4 * v * alpha**2 * omega**5 / 256 - 51 * u**2 * v**3 * alpha**2 * omega**5 / 128
        - 51 * v**5 * alpha**2 * omega**5 / 256
    ) / omega**8


def v_rate(u: Any, v: Any, omega: Any, omega_0: Any, gamma: Any, alpha: Any, beta: Any, F: Any, *, xp: Any) -> Any:
    """three-wave mixing, order 2: dv/dT."""
    return (
        F * u * beta * omega**5 / 6 + 5 * u**3 * beta**2 * omega**5 / 12 + 5 * u * v**2 * beta**2 * omega**5 / 12
        + u * gamma**2 * omega**7 / 8 + u * omega**9 / 8 - u * omega**7 * omega_0**2 / 4 + u * omega**5 * omega_0**4 / 8
        - 3 * u**3 * alpha * omega**7 / 8 + 3 * u**3 * alpha * omega**5 * omega_0**2 / 8
        - 3 * u * v**2 * alpha * omega**7 / 8 + 3 * u * v**2 * alpha * omega**5 * omega_0**2 / 8
        + 51 * u**5 * alpha**2 * omega**5 / 256 + 51 * u**3 * v**2 * alpha**2 * omega**5 / 128
        + 51 * u * v**4 * alpha**2 * omega**5 / 256
    ) / omega**8 + (
        u * omega**2 / 2 - u * omega_0**2 / 2 - v * gamma * omega / 2 - 3 * u**3 * alpha / 8 - 3 * u * v**2 * alpha / 8
    ) / omega


def forced_u_rate(u: Any, v: Any, omega: Any, omega_0: Any, gamma: Any, F: Any, *, xp: Any) -> Any:
    """harmonic oscillator, order 2: du/dT. Forced at omega."""
    return (
        F * gamma * omega**6 / 8 - v * gamma**2 * omega**7 / 8 - v * omega**9 / 8 + v * omega**7 * omega_0**2 / 4
        - v * omega**5 * omega_0**4 / 8
    ) / omega**8 + (-u * gamma * omega / 2 - v * omega**2 / 2 + v * omega_0**2 / 2) / omega


def forced_v_rate(u: Any, v: Any, omega: Any, omega_0: Any, gamma: Any, F: Any, *, xp: Any) -> Any:
    """harmonic oscillator, order 2: dv/dT. Forced at omega."""
    return (
        F * omega**7 / 8 - F * omega**5 * omega_0**2 / 8 + u * gamma**2 * omega**7 / 8 + u * omega**9 / 8
        - u * omega**7 * omega_0**2 / 4 + u * omega**5 * omega_0**4 / 8
    ) / omega**8 + (F / 2 + u * omega**2 / 2 - u * omega_0**2 / 2 - v * gamma * omega / 2) / omega


# fmt: on
TITLE = "HarmonicBalance.jl: averaging to second order, nonlinear damping"
CITATION = (
    "J. Košata, J. del Pino, T. L. Heugel, O. Zilberberg, HarmonicBalance.jl: A Julia suite for nonlinear dynamics "
    "using harmonic balance, SciPost Phys. Codebases 6 (2022), arXiv:2202.00571"
)
READ_IN = (
    "The program's documentation, which prints what it derives: the examples Parametrically driven resonator, "
    "Parametric pumping via three-wave mixing, and Harmonic oscillator: comparison of KB and HB methods; sentence: "
    "Extracting harmonic equations. The algorithm: src/krylov-bogoliubov.jl."
)
CLAIMS = {
    "Krylov-Bogoliubov": {
        "higher_orders": "the Krylov-Bogoliubov method excels in computing higher orders in 1/ω, enabling the capture "
        "of faster dynamics within a system",
    },
}
