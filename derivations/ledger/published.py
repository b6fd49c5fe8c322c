"""In: the paper's symbols as numbers, arrays or expressions. Out: every published formula, table, number and claim.

Source: G. Iarriccio, Primary Resonance Analysis of High-Static-Low-Dynamic Stiffness Isolators with Piecewise
Stiffness, Viscous Damping, and Dry Friction, Appl. Sci. 2025, 15(8), 4187, doi:10.3390/app15084187 (CC BY 4.0).

Everything here is typed by hand from the paper and judged elsewhere. Where the paper is wrong, this file is wrong with
it: correct nothing here. Nothing is imported from the derivation or from what it generates.

Conventions, valid for every function:

- Arguments are scalars or arrays that broadcast; the result has the broadcast shape. All are dimensionless, except in
  (1), (2), (4) and the first part of (5). No function raises an error of its own.
- `xp` is the namespace of sin, cos, sqrt, arccos, exp, sign and pi: NumPy, or anything with the same names. Literals
  are integers only, so an exact namespace gives an exact result.
- A relation returns lhs - rhs. An integral returns its integrand with the prefactor. A system returns a tuple.
- The paper's plain text lost minus signs, fraction bars and brackets. Where that leaves a choice, each `reading` is an
  entry of its own in `FORMULAS`.
- `x_dot` is a time derivative. `dH_i_dA` is the derivative of H_i with respect to A.
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Formula:
    """A published formula: where it stands, what it gives, the transcription, and which reading of the text it is."""

    equation: str
    quantity: str
    function: Callable[..., Any]
    reading: str = ""


@dataclass(frozen=True)
class Resultant:
    """A published resultant: two polynomials, the variable eliminated between them, and the polynomial that is left."""

    first: str
    second: str
    eliminated: str
    evaluated_at: str
    unknown: str
    coefficients: str
    degree: int
    step: int


@dataclass(frozen=True)
class Table2Row:
    """A row of Table 2, every entry a string exactly as printed."""

    F_0: str
    jump_up_Omega: str
    jump_up_A: str
    jump_down_Omega: str
    jump_down_A: str


@dataclass(frozen=True)
class Number:
    """A number quoted in the paper: `printed` is the printed string, `sentence` the words around it."""

    id: str
    symbol: str
    printed: str
    where: str
    sentence: str


@dataclass(frozen=True)
class Claim:
    """A sentence of the paper that a computation can decide; '...' marks an omission."""

    id: str
    where: str
    sentence: str


# Section 2: the oscillator


def equation_of_motion_dimensional(
    x: Any,
    x_dot: Any,
    x_ddot: Any,
    F_k: Any,
    m: Any,
    c: Any,
    k_v: Any,
    F_c: Any,
    F: Any,
    omega: Any,
    t: Any,
    *,
    xp: Any = np,
) -> Any:
    """(1) Equation of motion, lhs - rhs, in physical units. F_k is the value of (2) at x."""
    return m * x_ddot + c * x_dot + k_v * x + F_c * xp.sign(x_dot) + F_k - F * xp.cos(omega * t)


def F_k_dimensional(x: Any, lam: Any, k_h: Any, L: Any, Delta_h: Any, *, xp: Any = np) -> Any:
    """(2) Restoring force of the horizontal springs: (value for |x| <= x_cr, value for |x| > x_cr)."""
    attached = lam * k_h * (L - Delta_h - xp.sqrt(L**2 - x**2)) * x / xp.sqrt(L**2 - x**2)
    return attached, 0


def x_cr(L: Any, Delta_h: Any, *, xp: Any = np) -> Any:
    """(2) Displacement at which the horizontal springs leave the push-rod."""
    return xp.sqrt(L**2 - (L - Delta_h) ** 2)


def equation_of_motion(
    u: Any, u_dot: Any, u_ddot: Any, F_k: Any, zeta: Any, mu: Any, F_0: Any, Omega: Any, tau: Any, *, xp: Any = np
) -> Any:
    """(3) Dimensionless equation of motion, lhs - rhs. zeta and mu carry a bar in the paper. F_k is (5) or (6) at u."""
    return u_ddot + 2 * zeta * u_dot + u + mu * xp.sign(u_dot) + F_k - F_0 * xp.cos(Omega * tau)


def dimensionless_quantities(
    omega_n: Any,
    tau: Any,
    Omega: Any,
    u: Any,
    delta_h: Any,
    zeta: Any,
    mu: Any,
    F_0: Any,
    r: Any,
    m: Any,
    c: Any,
    k_v: Any,
    k_h: Any,
    F_c: Any,
    F: Any,
    omega: Any,
    t: Any,
    x: Any,
    L: Any,
    Delta_h: Any,
    *,
    xp: Any = np,
) -> Any:
    """(4) Definitions of omega_n, tau, Omega, u, delta_h, zeta, mu, F_0, r: nine residuals lhs - rhs, in that order."""
    return (
        omega_n**2 - k_v / m,
        tau - omega_n * t,
        Omega - omega / omega_n,
        u - x / L,
        delta_h - Delta_h / L,
        zeta - c / (2 * xp.sqrt(k_v * m)),
        mu - F_c / (k_v * L),
        F_0 - F / (k_v * L),
        r - k_h / k_v,
    )


def F_k_scaling(F_k_u: Any, F_k_x: Any, k_v: Any, L: Any, *, xp: Any = np) -> Any:
    """(5) Definition of the dimensionless force F_k(u) from F_k(x) of (2), lhs - rhs."""
    return F_k_u - F_k_x / (k_v * L)


def F_k(u: Any, lam: Any, r: Any, delta_h: Any, *, xp: Any = np) -> Any:
    """(5) Dimensionless restoring force: (value for |u| <= u_cr, value for |u| > u_cr)."""
    attached = lam * r * (1 - delta_h - xp.sqrt(1 - u**2)) * u / xp.sqrt(1 - u**2)
    return attached, 0


def u_cr(delta_h: Any, *, xp: Any = np) -> Any:
    """(5) Critical displacement: the horizontal springs detach beyond it."""
    return xp.sqrt(1 - (1 - delta_h) ** 2)


def F_k_taylor(u: Any, alpha: Any, beta: Any, gamma: Any, *, xp: Any = np) -> Any:
    """(6) Fifth-order Taylor expansion of (5): (value for |u| <= u_cr, value for |u| > u_cr)."""
    return (alpha - 1) * u + beta * u**3 + gamma * u**5, 0


def alpha(lam: Any, r: Any, delta_h: Any, *, xp: Any = np) -> Any:
    """(7) Linear coefficient: the stiffness at the equilibrium."""
    return 1 - lam * r * delta_h


def beta(lam: Any, r: Any, delta_h: Any, *, xp: Any = np) -> Any:
    """(7) Cubic coefficient."""
    return lam * r * (1 - delta_h) / 2


def gamma(lam: Any, r: Any, delta_h: Any, *, xp: Any = np) -> Any:
    """(7) Quintic coefficient."""
    return 3 * lam * r * (1 - delta_h) / 8


# Section 3.1: periodic motion


def averaging_form(u: Any, u_ddot: Any, Omega: Any, epsilon: Any, G: Any, *, xp: Any = np) -> Any:
    """(8) Rescaled equation of motion, lhs - rhs. G is the value of (9)."""
    return u_ddot + Omega**2 * u - epsilon * G


def G(
    u: Any,
    u_dot: Any,
    F_k: Any,
    F_0: Any,
    Omega: Any,
    tau: Any,
    zeta: Any,
    mu: Any,
    sigma: Any,
    *,
    xp: Any = np,
) -> Any:
    """(9) The perturbation G(u, u', Omega tau). F_k is the (unbarred) restoring force at u."""
    return F_0 * xp.cos(Omega * tau) - 2 * zeta * u_dot - mu * xp.sign(u_dot) - F_k + sigma * u


def rescaling(
    zeta_bar: Any,
    mu_bar: Any,
    F_0_bar: Any,
    F_k_bar: Any,
    Omega: Any,
    zeta: Any,
    mu: Any,
    F_0: Any,
    F_k: Any,
    sigma: Any,
    epsilon: Any,
    *,
    xp: Any = np,
) -> Any:
    """(10) Definitions of zeta, mu, F_0, F_k by their barred values, and of sigma: five residuals lhs - rhs."""
    return (
        zeta_bar - epsilon * zeta,
        mu_bar - epsilon * mu,
        F_0_bar - epsilon * F_0,
        F_k_bar - epsilon * F_k,
        Omega**2 - (1 + epsilon * sigma),
    )


def period(Omega: Any, *, xp: Any = np) -> Any:
    """Text after (10): the period T of G."""
    return 2 * xp.pi / Omega


def first_order_solution(A: Any, Omega: Any, psi: Any, *, xp: Any = np) -> Any:
    """(11) The assumed solution: (u, u')."""
    return A * xp.cos(psi), -A * Omega * xp.sin(psi)


def psi(Omega: Any, tau: Any, phi: Any, *, xp: Any = np) -> Any:
    """Text after (11): the fast angle."""
    return Omega * tau + phi


def velocity_condition(u_dot: Any, A: Any, A_dot: Any, phi_dot: Any, Omega: Any, psi: Any, *, xp: Any = np) -> Any:
    """(12) Time derivative of the first equation of (11), lhs - rhs."""
    return u_dot - (A_dot * xp.cos(psi) - A * Omega * xp.sin(psi) - A * phi_dot * xp.sin(psi))


def variation_condition(A: Any, A_dot: Any, phi_dot: Any, psi: Any, *, xp: Any = np) -> Any:
    """(13) Condition that makes (12) agree with (11), lhs - rhs."""
    return A_dot * xp.cos(psi) - A * phi_dot * xp.sin(psi)


def acceleration_condition(
    u: Any, u_ddot: Any, A: Any, A_dot: Any, phi_dot: Any, Omega: Any, psi: Any, *, xp: Any = np
) -> Any:
    """(14) Time derivative of the second equation of (11), lhs - rhs."""
    return u_ddot + Omega**2 * u - (-A_dot * Omega * xp.sin(psi) - A * Omega * phi_dot * xp.cos(psi))


def forced_condition(
    A: Any, A_dot: Any, phi_dot: Any, Omega: Any, psi: Any, epsilon: Any, G: Any, *, xp: Any = np
) -> Any:
    """(15) (14) put into (8): A' Omega sin psi + A Omega phi' cos psi = -epsilon G, lhs - rhs."""
    return A_dot * Omega * xp.sin(psi) + A * Omega * phi_dot * xp.cos(psi) + epsilon * G


def linear_system(A: Any, A_dot: Any, phi_dot: Any, Omega: Any, psi: Any, epsilon: Any, G: Any, *, xp: Any = np) -> Any:
    """(16) (13) and (15) as a linear system for (A', A phi') with right side (0, -epsilon G / Omega): two lhs - rhs."""
    return (
        xp.cos(psi) * A_dot - xp.sin(psi) * A * phi_dot,
        xp.sin(psi) * A_dot + xp.cos(psi) * A * phi_dot + epsilon / Omega * G,
    )


def modulation(Omega: Any, psi: Any, epsilon: Any, G: Any, *, xp: Any = np) -> Any:
    """(17) Solution of (16): (A', A phi')."""
    return -epsilon / Omega * G * xp.sin(psi), -epsilon / Omega * G * xp.cos(psi)


def averaged_modulation_integrand(Omega: Any, psi: Any, epsilon: Any, G: Any, *, xp: Any = np) -> Any:
    """(18) Integrands over psi from 0 to 2 pi, prefactor included, whose integrals are (A', A phi')."""
    return (
        -epsilon / (2 * xp.pi * Omega) * G * xp.sin(psi),
        -epsilon / (2 * xp.pi * Omega) * G * xp.cos(psi),
    )


def Gamma(
    A: Any,
    phi: Any,
    Omega: Any,
    F_0: Any,
    zeta: Any,
    mu: Any,
    sigma: Any,
    epsilon: Any,
    H_i: Any,
    *,
    xp: Any = np,
) -> Any:
    """(19) Slow flow: (A', A phi'). H_i is (21) or (22) at A."""
    return (
        -epsilon / (2 * Omega) * (F_0 * xp.sin(phi) + 2 * zeta * Omega * A + 4 / xp.pi * mu),
        -epsilon / (2 * Omega) * (F_0 * xp.cos(phi) + sigma * A + H_i),
    )


def H_i_integrand_plus(f_k: Any, psi: Any, *, xp: Any = np) -> Any:
    """(20) Integrand of H_i over psi from 0 to 2 pi, with prefactor, plus in front. f_k is the force at A cos psi."""
    return 1 / (2 * xp.pi) * f_k * xp.cos(psi)


def H_i_integrand_minus(f_k: Any, psi: Any, *, xp: Any = np) -> Any:
    """(20) Integrand of H_i over psi from 0 to 2 pi, with prefactor, minus in front. f_k is the force at A cos psi."""
    return -1 / (2 * xp.pi) * f_k * xp.cos(psi)


def H_1(A: Any, alpha: Any, beta: Any, gamma: Any, *, xp: Any = np) -> Any:
    """(21) Averaged restoring force for A <= u_cr."""
    return (1 - alpha) * A - 3 * beta * A**3 / 4 - 5 * gamma * A**5 / 8


def detachment_angle(A: Any, u_cr: Any, psi_0: Any, *, xp: Any = np) -> Any:
    """Text before (22): u_cr = A cos psi_0, lhs - rhs."""
    return u_cr - A * xp.cos(psi_0)


def H_2(A: Any, alpha: Any, beta: Any, gamma: Any, psi_0: Any, *, xp: Any = np) -> Any:
    """(22) Averaged restoring force for A > u_cr. psi_0 is (32)."""
    return (
        (1 - alpha) * A
        - 3 * beta * A**3 / 4
        - 5 * gamma * A**5 / 8
        + 1
        / xp.pi
        * (
            (2 * (alpha - 1) * A + 3 * beta * A**3 / 2 + 5 * gamma * A**5 / 4) * psi_0
            + ((alpha - 1) * A + beta * A**3 + 15 * gamma * A**5 / 16) * xp.sin(2 * psi_0)
            + (beta * A**3 / 8 + 3 * gamma * A**5 / 16) * xp.sin(4 * psi_0)
            + gamma * A**5 / 48 * xp.sin(6 * psi_0)
        )
    )


def fixed_points(
    A: Any, phi: Any, Omega: Any, F_0: Any, zeta: Any, mu: Any, sigma: Any, H_i: Any, *, xp: Any = np
) -> Any:
    """(23) Fixed points of (19): two residuals lhs - rhs."""
    return (
        F_0 * xp.sin(phi) + 2 * zeta * Omega * A + 4 / xp.pi * mu,
        F_0 * xp.cos(phi) + sigma * A + H_i,
    )


def F(Omega: Any, A: Any, F_0: Any, zeta: Any, mu: Any, H_i: Any, *, xp: Any = np) -> Any:
    """(24) Frequency-response function, zero on the response curve. H_i is (21) or (22) at A."""
    return (
        A**2 * Omega**4
        + (4 * A**2 * zeta**2 + 2 * A * (H_i - A)) * Omega**2
        + 16 / xp.pi * mu * zeta * A * Omega
        + 16 / xp.pi**2 * mu**2
        + (H_i - A) ** 2
        - F_0**2
    )


def tan_phi(Omega: Any, A: Any, zeta: Any, mu: Any, H_i: Any, *, xp: Any = np) -> Any:
    """(25) Tangent of the phase."""
    return (2 * zeta * Omega * A + 4 / xp.pi * mu) / ((Omega**2 - 1) * A + H_i)


def backbone(A_c: Any, Omega: Any, H_i: Any, *, xp: Any = np) -> Any:
    """(26) Backbone A_c = H_i / (1 - Omega^2), lhs - rhs. H_i is (21) or (22) at A_c."""
    return A_c - H_i / (1 - Omega**2)


def A_L(Omega: Any, F_0: Any, zeta: Any, mu: Any, *, xp: Any = np) -> Any:
    """(27) Limit envelope."""
    return (F_0 - 4 / xp.pi * mu) / (2 * zeta * Omega)


def F_0_sticking(mu: Any, *, xp: Any = np) -> Any:
    """Text after (27): the forcing amplitude that must be exceeded, otherwise the system sticks."""
    return 4 / xp.pi * mu


# Section 3.2: stability


def D_q_Gamma(
    A: Any, Omega: Any, zeta: Any, mu: Any, sigma: Any, H_i: Any, dH_i_dA: Any, *, xp: Any = np
) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    """(28) Jacobian of (19) with respect to q = (A, phi) at a fixed point: two rows of two entries."""
    return (
        (-zeta, 1 / (2 * Omega) * (sigma * A + H_i)),
        (-1 / (2 * Omega * A) * (sigma + dH_i_dA), -zeta - 2 * mu / (xp.pi * Omega * A)),
    )


def characteristic_equation(eigenvalue: Any, trace: Any, determinant: Any, *, xp: Any = np) -> Any:
    """(29) Characteristic equation of (28), lhs - rhs. The eigenvalue is the paper's second lambda."""
    return eigenvalue**2 - trace * eigenvalue + determinant


def stability_boundary(Omega: Any, A: Any, zeta: Any, mu: Any, H_i: Any, dH_i_dA: Any, *, xp: Any = np) -> Any:
    """(30) Stability boundary det(D_q Gamma) = 0, lhs - rhs."""
    return (
        Omega**4
        + (H_i / A + dH_i_dA + 4 * zeta**2 - 2) * Omega**2
        + 8 * zeta * mu / (xp.pi * A) * Omega
        + (1 - dH_i_dA) * (1 - H_i / A)
    )


def dH_2_dA_inverse_A(
    A: Any, alpha: Any, beta: Any, gamma: Any, u_cr: Any, p: Any, q: Any, psi_0: Any, *, xp: Any = np
) -> Any:
    """(31) Derivative of H_2 with respect to A, fourth term 6 q A^-1 u_cr. p, q, psi_0 are (32)."""
    return (
        1
        / (24 * xp.pi * p)
        * (
            16 * gamma * A**-3 * u_cr**7
            + (24 * beta - 20 * gamma * A**2) * A**-3 * u_cr**5
            - (64 * (1 - alpha) + 2 * q) * A**-3 * u_cr**3
            + 6 * q * A**-1 * u_cr
            - 3 * p * q * (xp.pi - 2 * psi_0)
        )
    )


def dH_2_dA_A(A: Any, alpha: Any, beta: Any, gamma: Any, u_cr: Any, p: Any, q: Any, psi_0: Any, *, xp: Any = np) -> Any:
    """(31) Derivative of H_2 with respect to A, fourth term 6 q A u_cr. p, q, psi_0 are (32)."""
    return (
        1
        / (24 * xp.pi * p)
        * (
            16 * gamma * A**-3 * u_cr**7
            + (24 * beta - 20 * gamma * A**2) * A**-3 * u_cr**5
            - (64 * (1 - alpha) + 2 * q) * A**-3 * u_cr**3
            + 6 * q * A * u_cr
            - 3 * p * q * (xp.pi - 2 * psi_0)
        )
    )


def p(A: Any, u_cr: Any, *, xp: Any = np) -> Any:
    """(32) Abbreviation p of (31)."""
    return xp.sqrt(1 - u_cr**2 / A**2)


def q(A: Any, alpha: Any, beta: Any, gamma: Any, *, xp: Any = np) -> Any:
    """(32) Abbreviation q of (31)."""
    return -8 + 8 * alpha + 18 * A**2 * beta + 25 * A**4 * gamma


def psi_0(A: Any, u_cr: Any, *, xp: Any = np) -> Any:
    """(32) Angle of detachment, for A > u_cr."""
    return xp.arccos(u_cr / A)


# Section 3.3: critical forcing amplitudes


def saddle_node_resultant(*, xp: Any = np) -> Resultant:
    """(33) Resultant whose zero is the inflection amplitude A_s: only even powers of A_s, up to the 36th."""
    return Resultant(
        first="dF/dA",
        second="d2F/dA2",
        eliminated="Omega",
        evaluated_at="A = A_s",
        unknown="A_s",
        coefficients="b_i",
        degree=36,
        step=2,
    )


def detachment_resultant(*, xp: Any = np) -> Resultant:
    """(34) Resultant whose zero is the critical forcing F_cr: only even powers of F_cr, up to the sixth."""
    return Resultant(
        first="F",
        second="dF/dOmega",
        eliminated="Omega",
        evaluated_at="A = u_cr",
        unknown="F_cr",
        coefficients="c_i(delta_h)",
        degree=6,
        step=2,
    )


def delta_h_qzs_inverse(lam: Any, r: Any, *, xp: Any = np) -> Any:
    """Text after (34): upper end of the range of delta_h, the quasi-zero stiffness mechanism, read (lam r)^-1."""
    return (lam * r) ** -1


def delta_h_qzs_literal(lam: Any, r: Any, *, xp: Any = np) -> Any:
    """Text after (34): upper end of the range of delta_h, the quasi-zero stiffness mechanism, read lam r^-1."""
    return lam * r**-1


# Section 4.1: Den Hartog's solution


def A_den_hartog(F_0: Any, mu: Any, V: Any, U: Any, *, xp: Any = np) -> Any:
    """(35) Den Hartog's amplitude of continuous motion for delta_h = 0 and zeta = 0. V and U are (37)."""
    return F_0 * xp.sqrt(V**2 - (mu / F_0) ** 2 * U**2)


def A_stick_slip(F_0: Any, Omega: Any, V: Any, U: Any, S: Any, *, xp: Any = np) -> Any:
    """(36) Bound that the amplitude must exceed for a motion without stops. V, U and S are (37)."""
    return F_0 * xp.sqrt(V**2 / (1 + (U * Omega**2 / S) ** 2))


def V(Omega: Any, *, xp: Any = np) -> Any:
    """(37) Response function."""
    return 1 / (1 - Omega**2)


def U(Omega: Any, *, xp: Any = np) -> Any:
    """(37) Damping function."""
    return xp.sin(xp.pi / Omega) / (Omega * (1 + xp.cos(xp.pi / Omega)))


def S_maximand_plus_plus(Omega: Any, tau: Any, U: Any, *, xp: Any = np) -> Any:
    """(37) S is the maximum of this over 0 <= tau <= pi / Omega. Signs: + Omega sin tau, + cos Omega tau."""
    return (Omega * xp.sin(tau) + U * Omega**2 * (xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_plus_minus(Omega: Any, tau: Any, U: Any, *, xp: Any = np) -> Any:
    """(37) S is the maximum of this over 0 <= tau <= pi / Omega. Signs: + Omega sin tau, - cos Omega tau."""
    return (Omega * xp.sin(tau) + U * Omega**2 * (-xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_minus_plus(Omega: Any, tau: Any, U: Any, *, xp: Any = np) -> Any:
    """(37) S is the maximum of this over 0 <= tau <= pi / Omega. Signs: - Omega sin tau, + cos Omega tau."""
    return (-Omega * xp.sin(tau) + U * Omega**2 * (xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_minus_minus(Omega: Any, tau: Any, U: Any, *, xp: Any = np) -> Any:
    """(37) S is the maximum of this over 0 <= tau <= pi / Omega. Signs: - Omega sin tau, - cos Omega tau."""
    return (-Omega * xp.sin(tau) + U * Omega**2 * (-xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def mu_over_F_0_sticking(*, xp: Any = np) -> Any:
    """Text of Section 4.1: threshold of mu / F_0 beyond which the system sticks."""
    return xp.pi / 4


# Section 4.2: parametric analysis


def zeta_eq(Omega: Any, A: Any, zeta: Any, mu: Any, *, xp: Any = np) -> Any:
    """(38) Equivalent viscous damping ratio."""
    return zeta + 2 * mu / (xp.pi * Omega * A)


def F_cr_limit_literal(mu: Any, *, xp: Any = np) -> Any:
    """Text of Section 4.2: limit of F_cr for delta_h -> 0, read pi mu / 4."""
    return xp.pi * mu / 4


def F_cr_limit_inverse(mu: Any, *, xp: Any = np) -> Any:
    """Text of Section 4.2: limit of F_cr for delta_h -> 0, read 4 mu / pi."""
    return 4 * mu / xp.pi


# Section 4.3: numerical example


def delta_h_limit_inverse(r: Any, *, xp: Any = np) -> Any:
    """Text of Section 4.3: the preload beyond which the stiffness is negative for lam = 3, read (3 r)^-1."""
    return (3 * r) ** -1


def delta_h_limit_literal(r: Any, *, xp: Any = np) -> Any:
    """Text of Section 4.3: the preload beyond which the stiffness is negative for lam = 3, read 3 r^-1."""
    return 3 * r**-1


# Appendix A: direct integration


def smoothed_equation_of_motion_u(
    u: Any,
    u_dot: Any,
    u_ddot: Any,
    Phi_1: Any,
    Phi_2: Any,
    lam: Any,
    r: Any,
    delta_h: Any,
    zeta: Any,
    mu: Any,
    F_0: Any,
    Omega: Any,
    tau: Any,
    *,
    xp: Any = np,
) -> Any:
    """(A1) Smoothed equation of motion, lhs - rhs, with its linear spring force read as u. Phi_1, Phi_2 are (A2)."""
    return (
        u_ddot
        + 2 * zeta * u_dot
        + Phi_1 * mu
        + u
        - lam * r * (delta_h - 1 + xp.sqrt(1 - u**2)) * u / xp.sqrt(1 - u**2) * Phi_2
        - F_0 * xp.cos(Omega * tau)
    )


def smoothed_equation_of_motion_x(
    u: Any,
    u_dot: Any,
    u_ddot: Any,
    x: Any,
    Phi_1: Any,
    Phi_2: Any,
    lam: Any,
    r: Any,
    delta_h: Any,
    zeta: Any,
    mu: Any,
    F_0: Any,
    Omega: Any,
    tau: Any,
    *,
    xp: Any = np,
) -> Any:
    """(A1) Smoothed equation of motion, lhs - rhs, with its linear spring force x as printed. Phi_1, Phi_2 are (A2)."""
    return (
        u_ddot
        + 2 * zeta * u_dot
        + Phi_1 * mu
        + x
        - lam * r * (delta_h - 1 + xp.sqrt(1 - u**2)) * u / xp.sqrt(1 - u**2) * Phi_2
        - F_0 * xp.cos(Omega * tau)
    )


def Phi_1(nu_1: Any, u_dot: Any, *, xp: Any = np) -> Any:
    """(A2) Smoothed sign of the velocity, in exponentials as printed: doubles overflow for nu_1 |u'| > 709."""
    return (xp.exp(nu_1 * u_dot) - xp.exp(-nu_1 * u_dot)) / (xp.exp(nu_1 * u_dot) + xp.exp(-nu_1 * u_dot))


def Phi_2_minus_minus(nu_2: Any, u: Any, u_cr: Any, *, xp: Any = np) -> Any:
    """(A2) Smoothed indicator of |u| <= u_cr, exponents -nu_2 (u + u_cr) and -nu_2 (u - u_cr)."""
    return 1 / (1 + xp.exp(-nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(-nu_2 * (u - u_cr)))


def Phi_2_plus_plus(nu_2: Any, u: Any, u_cr: Any, *, xp: Any = np) -> Any:
    """(A2) Smoothed indicator of |u| <= u_cr, exponents nu_2 (u + u_cr) and nu_2 (u - u_cr)."""
    return 1 / (1 + xp.exp(nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(nu_2 * (u - u_cr)))


def Phi_2_minus_plus(nu_2: Any, u: Any, u_cr: Any, *, xp: Any = np) -> Any:
    """(A2) Smoothed indicator of |u| <= u_cr, exponents -nu_2 (u + u_cr) and nu_2 (u - u_cr)."""
    return 1 / (1 + xp.exp(-nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(nu_2 * (u - u_cr)))


def Phi_2_plus_minus(nu_2: Any, u: Any, u_cr: Any, *, xp: Any = np) -> Any:
    """(A2) Smoothed indicator of |u| <= u_cr, exponents nu_2 (u + u_cr) and -nu_2 (u - u_cr)."""
    return 1 / (1 + xp.exp(nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(-nu_2 * (u - u_cr)))


# Captions and Table 1


def delta_h_caption_inverse(r: Any, *, xp: Any = np) -> Any:
    """Captions of Figures 2, 3, 4: preload, read (6 r)^-1."""
    return (6 * r) ** -1


def delta_h_caption_literal(r: Any, *, xp: Any = np) -> Any:
    """Captions of Figures 2, 3, 4: preload, read 6 r^-1."""
    return 6 * r**-1


def delta_h_table_inverse(r: Any, *, xp: Any = np) -> Any:
    """Table 1: preload, read 1 / (6 r)."""
    return 1 / (6 * r)


def delta_h_table_literal(r: Any, *, xp: Any = np) -> Any:
    """Table 1: preload, read (1 / 6) r."""
    return r / 6


FORMULAS: tuple[Formula, ...] = (
    Formula("(1)", "equation of motion", equation_of_motion_dimensional),
    Formula("(2)", "F_k(x)", F_k_dimensional),
    Formula("(2)", "x_cr", x_cr),
    Formula("(3)", "equation of motion", equation_of_motion),
    Formula("(4)", "omega_n, tau, Omega, u, delta_h, zeta, mu, F_0, r", dimensionless_quantities),
    Formula("(5)", "F_k(u) by F_k(x)", F_k_scaling),
    Formula("(5)", "F_k(u)", F_k),
    Formula("(5)", "u_cr", u_cr),
    Formula("(6)", "F_k(u)", F_k_taylor),
    Formula("(7)", "alpha", alpha),
    Formula("(7)", "beta", beta),
    Formula("(7)", "gamma", gamma),
    Formula("(8)", "equation of motion", averaging_form),
    Formula("(9)", "G", G),
    Formula("(10)", "zeta, mu, F_0, F_k, sigma", rescaling),
    Formula("text after (10)", "T", period),
    Formula("(11)", "u, u'", first_order_solution),
    Formula("text after (11)", "psi", psi),
    Formula("(12)", "u'", velocity_condition),
    Formula("(13)", "condition on A', phi'", variation_condition),
    Formula("(14)", "u''", acceleration_condition),
    Formula("(15)", "equation for A', phi'", forced_condition),
    Formula("(16)", "linear system for A', A phi'", linear_system),
    Formula("(17)", "A', A phi'", modulation),
    Formula("(18)", "A', A phi'", averaged_modulation_integrand),
    Formula("(19)", "Gamma", Gamma),
    Formula("(20)", "H_i", H_i_integrand_plus, "plus in front"),
    Formula("(20)", "H_i", H_i_integrand_minus, "minus in front"),
    Formula("(21)", "H_1", H_1),
    Formula("text before (22)", "u_cr by psi_0", detachment_angle),
    Formula("(22)", "H_2", H_2),
    Formula("(23)", "fixed points", fixed_points),
    Formula("(24)", "F", F),
    Formula("(25)", "tan phi", tan_phi),
    Formula("(26)", "A_c", backbone),
    Formula("(27)", "A_L", A_L),
    Formula("text after (27)", "F_0 at sticking", F_0_sticking),
    Formula("(28)", "D_q Gamma", D_q_Gamma),
    Formula("(29)", "characteristic equation", characteristic_equation),
    Formula("(30)", "stability boundary", stability_boundary),
    Formula("(31)", "dH_2/dA", dH_2_dA_inverse_A, "fourth term 6 q A^-1 u_cr"),
    Formula("(31)", "dH_2/dA", dH_2_dA_A, "fourth term 6 q A u_cr, as the plain text stands"),
    Formula("(32)", "p", p),
    Formula("(32)", "q", q),
    Formula("(32)", "psi_0", psi_0),
    Formula("(33)", "resultant for A_s", saddle_node_resultant),
    Formula("(34)", "resultant for F_cr", detachment_resultant),
    Formula("text after (34)", "delta_h at quasi-zero stiffness", delta_h_qzs_inverse, "(lam r)^-1"),
    Formula("text after (34)", "delta_h at quasi-zero stiffness", delta_h_qzs_literal, "lam r^-1"),
    Formula("(35)", "A", A_den_hartog),
    Formula("(36)", "bound of A", A_stick_slip),
    Formula("(37)", "V", V),
    Formula("(37)", "U", U),
    Formula("(37)", "S", S_maximand_plus_plus, "+ Omega sin tau, + cos Omega tau"),
    Formula("(37)", "S", S_maximand_plus_minus, "+ Omega sin tau, - cos Omega tau"),
    Formula("(37)", "S", S_maximand_minus_plus, "- Omega sin tau, + cos Omega tau"),
    Formula("(37)", "S", S_maximand_minus_minus, "- Omega sin tau, - cos Omega tau"),
    Formula("text of Section 4.1", "mu / F_0 at sticking", mu_over_F_0_sticking),
    Formula("(38)", "zeta_eq", zeta_eq),
    Formula("text of Section 4.2", "F_cr as delta_h -> 0", F_cr_limit_literal, "pi mu / 4, as printed"),
    Formula("text of Section 4.2", "F_cr as delta_h -> 0", F_cr_limit_inverse, "4 mu / pi"),
    Formula("text of Section 4.3", "delta_h at quasi-zero stiffness", delta_h_limit_inverse, "(3 r)^-1"),
    Formula("text of Section 4.3", "delta_h at quasi-zero stiffness", delta_h_limit_literal, "3 r^-1"),
    Formula("(A1)", "equation of motion", smoothed_equation_of_motion_u, "linear term x read as u"),
    Formula("(A1)", "equation of motion", smoothed_equation_of_motion_x, "linear term x as printed"),
    Formula("(A2)", "Phi_1", Phi_1),
    Formula("(A2)", "Phi_2", Phi_2_minus_minus, "exponents -nu_2 (u + u_cr), -nu_2 (u - u_cr)"),
    Formula("(A2)", "Phi_2", Phi_2_plus_plus, "exponents nu_2 (u + u_cr), nu_2 (u - u_cr)"),
    Formula("(A2)", "Phi_2", Phi_2_minus_plus, "exponents -nu_2 (u + u_cr), nu_2 (u - u_cr)"),
    Formula("(A2)", "Phi_2", Phi_2_plus_minus, "exponents nu_2 (u + u_cr), -nu_2 (u - u_cr)"),
    Formula("captions of Figures 2, 3, 4", "delta_h", delta_h_caption_inverse, "(6 r)^-1"),
    Formula("captions of Figures 2, 3, 4", "delta_h", delta_h_caption_literal, "6 r^-1"),
    Formula("Table 1", "delta_h", delta_h_table_inverse, "1 / (6 r)"),
    Formula("Table 1", "delta_h", delta_h_table_literal, "(1 / 6) r"),
)


# delta_h is taken as 1 / (6 r): Table 1's other reading, r / 6, is an entry of FORMULAS.
TABLE_1: dict[str, Fraction] = {
    "lam": Fraction(3),
    "r": Fraction(3747, 1848),
    "delta_h": 1 / (6 * Fraction(3747, 1848)),
    "mu": Fraction(12, 1000),
    "zeta": Fraction(2, 100),
}

TABLE_2: tuple[Table2Row, ...] = (
    Table2Row("F_SN", "-", "-", "-", "-"),
    Table2Row("0.025", "0.8023", "0.1722", "0.8318", "0.2893"),
    Table2Row("F_cr", "0.8287", "0.1842", "0.9288", "u_cr"),
    Table2Row("0.040", "0.8672", "0.2052", "0.9938", "0.5536"),
    Table2Row("0.050", "0.8976", "0.2222", "1.0175", "0.5876"),
)


NUMBERS: tuple[Number, ...] = (
    Number("rod_angle", "theta", "0", "Section 2", "oscillating rod parallel to the ground (θ = 0 rad)"),
    Number(
        "alpha_linear", "alpha", "1", "Section 2", "starting from null preload, the restoring force is linear (α = 1)"
    ),
    Number("alpha_qzs", "alpha", "0", "Section 2", "to quasi-zero stiffness (α = 0)"),
    Number("envelope_threshold", "F_0 / mu", "4/π", "Section 3.1", "in the case of resonant load with F_0 > 4/π μ"),
    Number("resultant_A_s_degree", "A_s", "36", "(33)", "i = 0, i even 36 b_i A_s^i = 0"),
    Number("resultant_F_cr_degree", "F_cr", "6", "(34)", "i = 0, i even 6 c_i(δ_h) F_cr^i = 0"),
    Number("amplitude_limit", "A", "1", "Section 4", "only cases where A < 1 are discussed herein"),
    Number(
        "rod_angle_vertical",
        "theta",
        "π/2",
        "Section 4",
        "the oscillating rod reaches the vertical position, (θ = π/2)",
    ),
    Number("S_threshold", "Omega", "1/2", "Section 4.1", "S ≃ 1 for Ω < 1/2, while S = 1 for Ω > 1/2"),
    Number("S_value", "S", "1", "Section 4.1", "S ≃ 1 for Ω < 1/2, while S = 1 for Ω > 1/2"),
    Number("sticking_threshold", "mu / F_0", "π/4", "Section 4.1", "when μ/F_0 is close to the threshold π/4"),
    Number("sticking_exceeded", "mu / F_0", "π/4", "Section 4.2", "when the threshold value μ/F_0 > π/4 is exceeded"),
    Number("F_cr_limit", "F_cr", "πμ/4", "Section 4.2", "F_cr which tends to πμ/4 for any ζ"),
    Number("u_cr", "u_cr", "0.3970", "Section 4.3", "we obtain u_cr = 0.3970"),
    Number("F_cr", "F_cr", "0.0300", "Section 4.3", "and F_cr = 0.0300"),
    Number("Omega_cr", "Omega_cr", "0.9288", "Section 4.3", "the critical forcing frequency Ω_cr = 0.9288"),
    Number("delta_h_limit", "delta_h", "0.16", "Section 4.3", "decreases as δ_h approaches 3 r^-1 ≈ 0.16"),
    Number("peak_shift", "Omega", "1", "Section 4.3", "the resonance peak shifts toward Ω = 1"),
    Number("F_SN", "F_SN", "0.0217", "Section 4.3", "the forcing amplitude F_SN = 0.0217"),
    Number("Omega_SN", "Omega_SN", "0.7762", "Section 4.3", "occurs at Ω_SN, A_SN = 0.7762, 0.1825"),
    Number("A_SN", "A_SN", "0.1825", "Section 4.3", "occurs at Ω_SN, A_SN = 0.7762, 0.1825"),
    Number("conclusion_threshold", "mu / F_0", "π/4", "Section 5", "ratios close to the threshold μ/F_0 = π/4"),
    Number("nu_1", "nu_1", "1000", "Appendix A", "with smoothing parameters ν_1 = ν_2 = 1000"),
    Number("nu_2", "nu_2", "1000", "Appendix A", "with smoothing parameters ν_1 = ν_2 = 1000"),
    Number("sweep_start", "Omega", "0.5", "Appendix A", "The forcing frequency Ω is varied from 0.5 to 1.5"),
    Number("sweep_end", "Omega", "1.5", "Appendix A", "The forcing frequency Ω is varied from 0.5 to 1.5"),
    Number("sweep_steps", "", "300", "Appendix A", "in 300 frequency steps"),
    Number("periods", "", "200", "Appendix A", "At each step, 200 forcing periods are simulated"),
    Number("samples", "", "40", "Appendix A", "with 40 samples recorded per forcing period"),
    Number("steady_periods", "", "100", "Appendix A", "over the last 100 simulated forcing periods"),
    Number("figure_2b_lam", "lam", "3", "Figure 2", "in the case of λ = 3, δ_h = 6 r^-1, ζ = 0.02"),
    Number("figure_2b_delta_h", "delta_h", "6 r^-1", "Figure 2", "in the case of λ = 3, δ_h = 6 r^-1, ζ = 0.02"),
    Number("figure_2b_zeta", "zeta", "0.02", "Figure 2", "in the case of λ = 3, δ_h = 6 r^-1, ζ = 0.02"),
    Number("figure_3a_lam", "lam", "3", "Figure 3", "with λ = 3, δ_h = 6 r^-1, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number(
        "figure_3a_delta_h", "delta_h", "6 r^-1", "Figure 3", "with λ = 3, δ_h = 6 r^-1, ζ = 0.02, μ = 0.01, F_0 = 0.05"
    ),
    Number("figure_3a_zeta", "zeta", "0.02", "Figure 3", "with λ = 3, δ_h = 6 r^-1, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number("figure_3a_mu", "mu", "0.01", "Figure 3", "with λ = 3, δ_h = 6 r^-1, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number("figure_3a_F_0", "F_0", "0.05", "Figure 3", "with λ = 3, δ_h = 6 r^-1, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number("figure_3b_lam", "lam", "3", "Figure 3", "with λ = 3, r = 2.03, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number("figure_3b_r", "r", "2.03", "Figure 3", "with λ = 3, r = 2.03, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number("figure_3b_zeta", "zeta", "0.02", "Figure 3", "with λ = 3, r = 2.03, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number("figure_3b_mu", "mu", "0.01", "Figure 3", "with λ = 3, r = 2.03, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number("figure_3b_F_0", "F_0", "0.05", "Figure 3", "with λ = 3, r = 2.03, ζ = 0.02, μ = 0.01, F_0 = 0.05"),
    Number("figure_4a_lam", "lam", "3", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, ζ = 0, F_0 = 0.05"),
    Number("figure_4a_r", "r", "2.03", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, ζ = 0, F_0 = 0.05"),
    Number(
        "figure_4a_delta_h", "delta_h", "6 r^-1", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, ζ = 0, F_0 = 0.05"
    ),
    Number("figure_4a_zeta", "zeta", "0", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, ζ = 0, F_0 = 0.05"),
    Number("figure_4a_F_0", "F_0", "0.05", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, ζ = 0, F_0 = 0.05"),
    Number("figure_4b_lam", "lam", "3", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, F_0 = 0.05"),
    Number("figure_4b_r", "r", "2.03", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, F_0 = 0.05"),
    Number("figure_4b_delta_h", "delta_h", "6 r^-1", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, F_0 = 0.05"),
    Number("figure_4b_F_0", "F_0", "0.05", "Figure 4", "with λ = 3, r = 2.03, δ_h = 6 r^-1, F_0 = 0.05"),
    Number("figure_5a_lam", "lam", "3", "Figure 5", "Role of the viscous damping, with λ = 3, r = 2.03, μ = 0.012"),
    Number("figure_5a_r", "r", "2.03", "Figure 5", "Role of the viscous damping, with λ = 3, r = 2.03, μ = 0.012"),
    Number("figure_5a_mu", "mu", "0.012", "Figure 5", "Role of the viscous damping, with λ = 3, r = 2.03, μ = 0.012"),
    Number("figure_5b_lam", "lam", "3", "Figure 5", "role of the dry friction force μ, with λ = 3, r = 2.03, ζ = 0.02"),
    Number("figure_5b_r", "r", "2.03", "Figure 5", "role of the dry friction force μ, with λ = 3, r = 2.03, ζ = 0.02"),
    Number(
        "figure_5b_zeta", "zeta", "0.02", "Figure 5", "role of the dry friction force μ, with λ = 3, r = 2.03, ζ = 0.02"
    ),
    Number("table_1_lam", "lam", "3", "Table 1", "Input parameters of the detailed analysis"),
    Number("table_1_r", "r", "3747/1848", "Table 1", "Input parameters of the detailed analysis"),
    Number("table_1_delta_h", "delta_h", "1/6 r", "Table 1", "Input parameters of the detailed analysis"),
    Number("table_1_mu", "mu", "12/1000", "Table 1", "Input parameters of the detailed analysis"),
    Number("table_1_zeta", "zeta", "2/100", "Table 1", "Input parameters of the detailed analysis"),
    Number("table_2_row_1_F_0", "F_0", "F_SN", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_1_jump_up_Omega", "Omega", "-", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_1_jump_up_A", "A", "-", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_1_jump_down_Omega", "Omega", "-", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_1_jump_down_A", "A", "-", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_2_F_0", "F_0", "0.025", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_2_jump_up_Omega", "Omega", "0.8023", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_2_jump_up_A", "A", "0.1722", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_2_jump_down_Omega", "Omega", "0.8318", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_2_jump_down_A", "A", "0.2893", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_3_F_0", "F_0", "F_cr", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_3_jump_up_Omega", "Omega", "0.8287", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_3_jump_up_A", "A", "0.1842", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_3_jump_down_Omega", "Omega", "0.9288", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_3_jump_down_A", "A", "u_cr", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_4_F_0", "F_0", "0.040", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_4_jump_up_Omega", "Omega", "0.8672", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_4_jump_up_A", "A", "0.2052", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_4_jump_down_Omega", "Omega", "0.9938", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_4_jump_down_A", "A", "0.5536", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_5_F_0", "F_0", "0.050", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_5_jump_up_Omega", "Omega", "0.8976", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_5_jump_up_A", "A", "0.2222", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_5_jump_down_Omega", "Omega", "1.0175", "Table 2", "Saddle node bifurcation points"),
    Number("table_2_row_5_jump_down_A", "A", "0.5876", "Table 2", "Saddle node bifurcation points"),
)

CLAIMS: tuple[Claim, ...] = (
    Claim(
        "reliability",
        "Abstract",
        "Results confirm the reliability of the KBM method in dealing with piecewise restoring forces while "
        "highlighting its limitations in case of high dry friction.",
    ),
    Claim(
        "spring_tension",
        "Section 2",
        "when the oscillation amplitude exceeds a critical value x_cr, it is necessary to account for the "
        "detachment of the horizontal springs from the pushrod",
    ),
    Claim("dimensionless_equation", "Section 2", "Using a dimensionless notation, Equation (1) is reduced to"),
    Claim(
        "taylor",
        "Section 2",
        "Using Taylor’s expansion, the nonlinear restoring force can be approximated as ... with coefficients "
        "derived up to the fifth order",
    ),
    Claim(
        "odd_terms",
        "Section 2",
        "Due to the symmetry of the system, the restoring force is an odd function [42]; therefore, only odd "
        "terms appear in (6).",
    ),
    Claim("u_cr_null", "Section 2", "the critical deflection u_cr is null when the preload δ_h = 0"),
    Claim(
        "linear_collapse",
        "Section 2",
        "This causes the first equation of (5) to collapse into the second, resulting in the restoring force of "
        "a linear oscillator.",
    ),
    Claim("linear_null_preload", "Section 2", "starting from null preload, the restoring force is linear (α = 1)"),
    Claim(
        "hslds_to_qzs",
        "Section 2",
        "while increasing the preload, the behavior changes from High-Static–Low-Dynamic Stiffness (0 < α < 1) "
        "to quasi-zero stiffness (α = 0)",
    ),
    Claim(
        "negative_stiffness",
        "Section 2",
        "After quasi-zero-stiffness, the condition of negative stiffness (α < 0) occurs at the equilibrium point.",
    ),
    Claim(
        "u_cr_range",
        "Section 2",
        "the higher the preload, the larger the range of motion of the isolator that is not affected by detachment",
    ),
    Claim(
        "snap_through",
        "Section 2",
        "The side effect of a high preload lies in the stiffness at the equilibrium point, which can be negative "
        "and resulting in snap-trough mechanism.",
    ),
    Claim("rescaled_equation", "Section 3.1", "Equation (3) is rescaled with respect to a small parameter ϵ"),
    Claim("G_period", "Section 3.1", "G(u, u', Ωτ) is periodic with period T = 2π/Ω"),
    Claim(
        "variation_condition",
        "Section 3.1",
        "comparing (12) to the second equation of (11), it requires the following condition to be satisfied",
    ),
    Claim("substitution", "Section 3.1", "and substituting it into Equation (8) results in"),
    Claim(
        "linear_system",
        "Section 3.1",
        "The set of Equations (13) and (15) is linear with respect to the variables A' and Aϕ'",
    ),
    Claim("linear_solution", "Section 3.1", "Solving the linear system (16), it is possible to obtain"),
    Claim(
        "velocity_sign",
        "Section 3.1",
        "Considering that u' < 0 ∀ψ ∈ [0, π] and u' > 0 ∀ψ ∈ [π, 2π], the modulation Equation (18) is reduced to "
        "the standard form",
    ),
    Claim(
        "H_1_continuous",
        "Section 3.1",
        "If response amplitude A ≤ u_cr, the system is not affected by the stiffness discontinuity",
    ),
    Claim(
        "H_2_intervals",
        "Section 3.1",
        "if response amplitude A > u_cr, assuming u_cr = A cos ψ_0, Integral (20) must be split over four intervals",
    ),
    Claim(
        "frequency_response",
        "Section 3.1",
        "Collecting trigonometric terms at the right-hand-side, squaring and adding side by side, the "
        "frequency–response curve is determined",
    ),
    Claim("numerical_only", "Section 3.1", "If μ ≠ 0, the solution must be obtained numerically"),
    Claim(
        "closed_form",
        "Section 3.1",
        "in the case of negligible Coulomb friction, a closed-form solution can be obtained by solving a "
        "quadratic algebraic equation in Ω^2",
    ),
    Claim("phase", "Section 3.1", "The slowly varying phase ϕ(Ω) is retrieved from Equation (23)"),
    Claim(
        "backbone",
        "Section 3.1",
        "the backbone equation can be obtained from the second equation of (23) by assuming cos ϕ = 0",
    ),
    Claim(
        "envelope_hypothesis",
        "Section 3.1",
        "the limit envelope under the hypothesis of A < u_cr where the isolator is not affected by the restoring "
        "force discontinuity",
    ),
    Claim("envelope", "Section 3.1", "Setting sin ϕ = ±1 from the first equation of (23), the limit envelope curve is"),
    Claim(
        "envelope_unbounded",
        "Section 3.1",
        "in the absence of viscous damping, ζ → 0, the limit envelope amplitude A_L → ∞",
    ),
    Claim(
        "friction_alone",
        "Section 3.1",
        "dry friction alone cannot guarantee a bounded response in the case of resonant load with F_0 > 4/π μ",
    ),
    Claim(
        "sticking",
        "Section 3.1",
        "If the inequality is not satisfied, the excitation frequency is insufficient to induce vibrations of "
        "the isolator; thus, the system lies in the sticking region.",
    ),
    Claim(
        "sticking_by_limit",
        "Section 3.1",
        "The same condition could have been obtained equivalently by imposing A → 0 in the amplitude–frequency "
        "Equation (24)",
    ),
    Claim("jacobian", "Section 3.2", "Equation (19) serves as the basis for the Jacobian matrix evaluation"),
    Claim("trace_negative", "Section 3.2", "Since tr(D_qΓ) < 0, all the eigenvalues have a negative real part"),
    Claim("no_hopf", "Section 3.2", "thus, Hopf bifurcations cannot occur"),
    Claim(
        "imaginary_eigenvalue",
        "Section 3.2",
        "a static bifurcation (i.e., saddle nodes), as per its definition, can occur if at least one eigenvalue "
        "is purely imaginary",
    ),
    Claim(
        "determinant_null",
        "Section 3.2",
        "the stability of fixed points can be investigated by finding the values for which det(D_qΓ) is null",
    ),
    Claim(
        "friction_marginal",
        "Section 3.2",
        "the role played by the dry friction on the stability is marginal and strictly related to the value of "
        "the viscous damping ratio",
    ),
    Claim(
        "friction_without_zeta",
        "Section 3.2",
        "as ζ → 0, a variation in the dry friction force does not affect the stability boundary",
    ),
    Claim(
        "derivative_H_2",
        "Section 3.2",
        "the derivative of H_2 with respect to the oscillation amplitude A is reported as follows",
    ),
    Claim(
        "jumps_above_F_SN",
        "Section 3.3",
        "If the forcing amplitude exceeds a critical value F_SN, sudden oscillation jumps occur near resonance "
        "conditions.",
    ),
    Claim(
        "inflection",
        "Section 3.3",
        "For excitation amplitudes below the detachment condition, i.e., A < |u_cr|, the frequency response "
        "displays an inflection point",
    ),
    Claim(
        "triple_root",
        "Section 3.3",
        "with Equation (24) providing three roots, each counted with its own multiplicity",
    ),
    Claim(
        "one_positive_root",
        "Section 3.3",
        "the resultant R, expressed as a function of Ω, has one positive real root at the inflection point",
    ),
    Claim("resultant_even_36", "Section 3.3", "i = 0, i even 36 b_i A_s^i = 0"),
    Claim("solved_numerically", "Section 3.3", "Polynomial (33) can be solved numerically"),
    Claim("minimum_root", "Section 3.3", "the minimum real positive root provides A_s"),
    Claim("Omega_s", "Section 3.3", "By substituting A_s into ∂^2F/∂A^2 = 0, the critical frequency Ω_s is obtained."),
    Claim(
        "F_SN_evaluation",
        "Section 3.3",
        "the forcing amplitude F_SN is provided by the evaluation of F(Ω_s, A_s) = 0",
    ),
    Claim(
        "depressed_cubic",
        "Section 3.3",
        "finding the stationary points of ∂F/∂Ω = 0, which yields a depressed cubic in Ω",
    ),
    Claim("cubic_root", "Section 3.3", "in which one root identifies the critical value Ω_cr"),
    Claim("F_cr_equation", "Section 3.3", "Substituting Ω_cr into (24) leads to an equation of the variable F_cr."),
    Claim(
        "fixed_preload",
        "Section 3.3",
        "it requires to work with a fixed value of the preload δ_h; therefore, it does not show the relationship "
        "F_cr = f(δ_h)",
    ),
    Claim("resultant_even_6", "Section 3.3", "i = 0, i even 6 c_i(δ_h) F_cr^i = 0"),
    Claim("c_i_polynomial", "Section 3.3", "c_i(δ_h) represents the ith polynomial in variable δ_h"),
    Claim(
        "preload_range",
        "Section 3.3",
        "spanning the preload in the range δ_h ∈ [0, λr^-1], which covers a wide range of cases, from HSLDS to "
        "the QZS mechanism",
    ),
    Claim("amplitude_unit", "Section 4", "the normalized oscillation amplitude cannot be larger than the unit"),
    Claim(
        "infinite_stiffness",
        "Section 4",
        "if the oscillating rod reaches the vertical position, (θ = π/2), the equivalent vertical stiffness is "
        "infinite",
    ),
    Claim(
        "den_hartog",
        "Section 4.1",
        "the closed-form solution of the oscillation amplitude under the hypothesis of continuous motion",
    ),
    Claim(
        "den_hartog_boundary",
        "Section 4.1",
        "the relationship describing the boundary below which stick–slip phenomena occur",
    ),
    Claim("S_below_half", "Section 4.1", "S ≃ 1 for Ω < 1/2"),
    Claim("S_above_half", "Section 4.1", "while S = 1 for Ω > 1/2"),
    Claim(
        "den_hartog_agreement",
        "Section 4.1",
        "For several values of the ratio μ/F_0, the agreement between the numerical and the analytical solutions "
        "is excellent.",
    ),
    Claim(
        "kbm_discrepancies",
        "Section 4.1",
        "the KBM shows discrepancies with the other methods in the case of higher values of μ/F_0, and "
        "particularly at low oscillation amplitude",
    ),
    Claim("kbm_qualitative", "Section 4.1", "the qualitative behavior is captured"),
    Claim(
        "kbm_low_friction",
        "Section 4.1",
        "For low μ/F_0, the averaging method provides a reliable means of studying the qualitative behavior of "
        "piecewise nonlinear stiffness isolators in the presence of combined viscous and Coulomb damping.",
    ),
    Claim(
        "kbm_threshold",
        "Section 4.1",
        "caution is required when μ/F_0 is close to the threshold π/4 that leads to the sticking phenomenon, as "
        "identified in Equation (27)",
    ),
    Claim(
        "r_only_method",
        "Section 4.2",
        "this is the only method for modifying the stiffness characteristic without affecting the critical "
        "displacement u_cr",
    ),
    Claim(
        "u_cr_of_delta_h",
        "Section 4.2",
        "the critical displacement u_cr is a function of the horizontal spring preload δ_h: the higher the "
        "preload, the higher is u_cr",
    ),
    Claim(
        "F_cr_of_delta_h",
        "Section 4.2",
        "The increment of δ_h yields a secondary effect, which implies a higher critical force F_cr that is "
        "required to trigger the piecewise behavior of the restoring force.",
    ),
    Claim(
        "unbounded_resonance",
        "Section 4.2",
        "finite amplitude oscillations at resonance cannot be observed when ζ = 0, μ ≠ 0",
    ),
    Claim(
        "no_oscillation",
        "Section 4.2",
        "when the threshold value μ/F_0 > π/4 is exceeded, the external forcing amplitude is insufficient to "
        "induce oscillations; thus, A = 0 ∀Ω",
    ),
    Claim(
        "viscous_bounded",
        "Section 4.2",
        "the introduction of viscous damping into the system limits the resonance peak amplitude to finite values",
    ),
    Claim(
        "zeta_eq_equating",
        "Section 4.2",
        "equating the dissipative terms in the first equation of (23) with those obtained in the case of linear "
        "viscous damping",
    ),
    Claim(
        "zeta_eq_near_resonance",
        "Section 4.2",
        "it is negligible near resonance due to the sudden increase in oscillation amplitude",
    ),
    Claim("zeta_eq_far", "Section 4.2", "it becomes significant at low and high forcing frequencies"),
    Claim("F_cr_damping", "Section 4.2", "higher viscous damping ζ and dry friction forces μ result in a higher F_cr"),
    Claim(
        "F_cr_plateau",
        "Section 4.2",
        "the critical forcing value reaching a plateau region in the case of the QZS mechanism δ_h → λr^-1",
    ),
    Claim("F_cr_roles_differ", "Section 4.2", "the roles played by ζ and μ differ as δ_h → 0"),
    Claim("F_cr_zeta_no_effect", "Section 4.2", "Viscous damping has no remarkable effects on the critical forcing"),
    Claim("F_cr_limit", "Section 4.2", "F_cr which tends to πμ/4 for any ζ"),
    Claim(
        "F_cr_mu_shift",
        "Section 4.2",
        "an increment of the dry friction μ induces a shift toward higher values of F_cr",
    ),
    Claim(
        "example_u_cr_F_cr",
        "Section 4.3",
        "using Equations (5) and (34), we obtain u_cr = 0.3970 and F_cr = 0.0300",
    ),
    Claim(
        "example_Omega_cr",
        "Section 4.3",
        "Substituting these values into (24) allows for the evaluation of the critical forcing frequency Ω_cr = "
        "0.9288.",
    ),
    Claim(
        "detachment_onset",
        "Section 4.3",
        "beyond which the push-rod detaches from the horizontal spring for any forcing amplitude F within the "
        "hatched area",
    ),
    Claim(
        "F_cr_rate",
        "Section 4.3",
        "as u_cr increases with higher values of δ_h, the rate of change in F_cr decreases as δ_h approaches 3 "
        "r^-1 ≈ 0.16",
    ),
    Claim(
        "beyond_limit",
        "Section 4.3",
        "Beyond this threshold, the analysis is no longer of interest to the present study, as it would lead to "
        "the emergence of negative stiffness mechanism.",
    ),
    Claim(
        "agreement_acceptable",
        "Section 4.3",
        "the agreement between the approximate and numerical solution is acceptable",
    ),
    Claim(
        "below_F_cr",
        "Section 4.3",
        "For F_0 ≤ F_cr, the system behaves as a nonlinear oscillator with quintic stiffness nonlinearity and "
        "mixed damping.",
    ),
    Claim(
        "above_F_cr",
        "Section 4.3",
        "For F_0 > F_cr, the piecewise nonlinearity of the restoring force is triggered",
    ),
    Claim("peak_shift", "Section 4.3", "the resonance peak shifts toward Ω = 1"),
    Claim(
        "F_SN_prevents",
        "Section 4.3",
        "the Sylvester criterion allows to determine the forcing amplitude F_SN = 0.0217 that prevents the "
        "system from experiencing saddle-node bifurcations",
    ),
    Claim(
        "no_multistability",
        "Section 4.3",
        "For F_0 ≤ F_SN, the isolator exhibits a predictable behavior without showing response multistability.",
    ),
    Claim(
        "inflection_point",
        "Section 4.3",
        "When F_0 = F_SN, the limit inflection point occurs at Ω_SN, A_SN = 0.7762, 0.1825.",
    ),
    Claim(
        "jump_points",
        "Section 4.3",
        "the jump-up/jump-down frequencies and amplitudes, evaluated using Equations (24) and (30), are listed "
        "in Table 2",
    ),
    Claim(
        "phase_dissipation",
        "Section 4.3",
        "At low forcing amplitude, the phase shift is primarily governed by dissipation",
    ),
    Claim(
        "phase_undamped",
        "Section 4.3",
        "as the forcing amplitude increases, the phase shift approaches that of an undamped Duffing oscillator",
    ),
    Claim(
        "conclusion_kbm",
        "Section 5",
        "The study validates the KBM approach against closed-form solutions and direct integration of the "
        "governing equation, demonstrating its effectiveness in predicting the qualitative system’s behavior.",
    ),
    Claim("conclusion_1_algebraic", "Section 5, (1)", "it provides algebraic equations that can be solved with ease"),
    Claim(
        "conclusion_2_frequency",
        "Section 5, (2)",
        "increasing the preload of the horizontal springs δ_h has a twofold effect: (i) it reduces the natural "
        "frequency of the system",
    ),
    Claim(
        "conclusion_2_u_cr",
        "Section 5, (2)",
        "it increases the critical displacement u_cr required to activate the piecewise restoring force",
    ),
    Claim(
        "conclusion_2_zeta_eq",
        "Section 5, (2)",
        "a relationship for the equivalent viscous damping is provided, demonstrating the dependence between dry "
        "friction, forcing amplitude, and frequency, which explains the limited effect of dry friction near "
        "resonance conditions",
    ),
    Claim(
        "conclusion_3_mu",
        "Section 5, (3)",
        "regardless of the preload δ_h, higher dry friction forces are beneficial in increasing the critical "
        "forcing value F_cr required to activate the piecewise restoring force nonlinearity",
    ),
    Claim(
        "conclusion_3_zeta",
        "Section 5, (3)",
        "increasing viscous damping is effective only at higher δ_h (i.e., for QZS systems)",
    ),
    Claim("conclusion_3_zeta_limit", "Section 5, (3)", "its effect on F_cr is negligible as δ_h → 0"),
    Claim(
        "conclusion_4_resultants",
        "Section 5, (4)",
        "Leveraging the Sylvester resultant, critical forcing amplitudes, resulting in the onset of piecewise "
        "restoring force, are determined along with the condition to prevent jump-up/jump-down phenomena.",
    ),
    Claim(
        "conclusion_5_friction",
        "Section 5, (5)",
        "the adopted friction model is suitable for the analysis of low-friction systems under the assumption of "
        "continuous motion",
    ),
    Claim(
        "conclusion_5_threshold",
        "Section 5, (5)",
        "for friction-to-external force amplitude ratios close to the threshold μ/F_0 = π/4, KBM performs poorly",
    ),
    Claim("smoothed_equation", "Appendix A", "the equation of motion (8) is smoothed as follows"),
    Claim(
        "smoothing_functions",
        "Appendix A",
        "dry friction and restoring forces are smoothed using hyperbolic tangent and Sigmoid-like functions, "
        "respectively",
    ),
    Claim(
        "transients",
        "Appendix A",
        "the steady-state solution is evaluated over the last 100 simulated forcing periods to eliminate "
        "transient effects",
    ),
)
