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
- The paper's plain text lost minus signs, fraction bars and brackets. Where that leaves a choice, each reading is a
  function of its own. A docstring begins with equation and quantity, in the form of `statements`.
- `x_dot` is a time derivative. `dH_i_dA` is the derivative of H_i with respect to A.
"""

import tomllib
from dataclasses import dataclass, fields
from fractions import Fraction
from pathlib import Path

import numpy as np

from .statements import claims, formulas


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
    """A number quoted in the paper: `printed` is the printed string, `sentence` the words around it.

    entry -- of Table 2: the forcing of its row, and its column
    """

    id: str
    symbol: str
    printed: str
    where: str
    sentence: str
    entry: tuple[str, ...] = ()


# Section 2: the oscillator


def equation_of_motion_dimensional(x, x_dot, x_ddot, F_k, m, c, k_v, F_c, F, omega, t, *, xp=np):
    """(1): equation of motion. In physical units, lhs - rhs. F_k is the value of (2) at x."""
    return m * x_ddot + c * x_dot + k_v * x + F_c * xp.sign(x_dot) + F_k - F * xp.cos(omega * t)


def F_k_dimensional(x, lam, k_h, L, Delta_h, *, xp=np):
    """(2): F_k(x). Restoring force of the horizontal springs: (value for |x| <= x_cr, value for |x| > x_cr)."""
    attached = lam * k_h * (L - Delta_h - xp.sqrt(L**2 - x**2)) * x / xp.sqrt(L**2 - x**2)
    return attached, 0


def x_cr(L, Delta_h, *, xp=np):
    """(2): x_cr. Displacement at which the horizontal springs leave the push-rod."""
    return xp.sqrt(L**2 - (L - Delta_h) ** 2)


def equation_of_motion(u, u_dot, u_ddot, F_k, zeta, mu, F_0, Omega, tau, *, xp=np):
    """(3): equation of motion. Dimensionless, lhs - rhs. zeta and mu have a bar in the paper. F_k is (5) or (6)."""
    return u_ddot + 2 * zeta * u_dot + u + mu * xp.sign(u_dot) + F_k - F_0 * xp.cos(Omega * tau)


def dimensionless_quantities(
    omega_n, tau, Omega, u, delta_h, zeta, mu, F_0, r, m, c, k_v, k_h, F_c, F, omega, t, x, L, Delta_h, *, xp=np
):
    """(4): omega_n, tau, Omega, u, delta_h, zeta, mu, F_0, r. Their definitions, in that order, lhs - rhs."""
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


def F_k_scaling(F_k_u, F_k_x, k_v, L, *, xp=np):
    """(5): F_k(u) in terms of F_k(x). Definition of the dimensionless force, lhs - rhs. F_k_x is the value of (2)."""
    return F_k_u - F_k_x / (k_v * L)


def F_k(u, lam, r, delta_h, *, xp=np):
    """(5): F_k(u). Dimensionless restoring force: (value for |u| <= u_cr, value for |u| > u_cr)."""
    attached = lam * r * (1 - delta_h - xp.sqrt(1 - u**2)) * u / xp.sqrt(1 - u**2)
    return attached, 0


def u_cr(delta_h, *, xp=np):
    """(5): u_cr. Critical displacement: the horizontal springs detach beyond it."""
    return xp.sqrt(1 - (1 - delta_h) ** 2)


def F_k_taylor(u, alpha, beta, gamma, *, xp=np):
    """(6): F_k(u). Fifth-order Taylor expansion of (5): (value for |u| <= u_cr, value for |u| > u_cr)."""
    return (alpha - 1) * u + beta * u**3 + gamma * u**5, 0


def alpha(lam, r, delta_h, *, xp=np):
    """(7): alpha. Linear coefficient: the stiffness at the equilibrium."""
    return 1 - lam * r * delta_h


def beta(lam, r, delta_h, *, xp=np):
    """(7): beta. Cubic coefficient."""
    return lam * r * (1 - delta_h) / 2


def gamma(lam, r, delta_h, *, xp=np):
    """(7): gamma. Quintic coefficient."""
    return 3 * lam * r * (1 - delta_h) / 8


# Section 3.1: periodic motion


def averaging_form(u, u_ddot, Omega, epsilon, G, *, xp=np):
    """(8): equation of motion. Rescaled, lhs - rhs. G is the value of (9)."""
    return u_ddot + Omega**2 * u - epsilon * G


def G(u, u_dot, F_k, F_0, Omega, tau, zeta, mu, sigma, *, xp=np):
    """(9): G. The perturbation G(u, u', Omega tau). F_k is the (unbarred) restoring force at u."""
    return F_0 * xp.cos(Omega * tau) - 2 * zeta * u_dot - mu * xp.sign(u_dot) - F_k + sigma * u


def rescaling(zeta_bar, mu_bar, F_0_bar, F_k_bar, Omega, zeta, mu, F_0, F_k, sigma, epsilon, *, xp=np):
    """(10): zeta, mu, F_0, F_k, sigma. Definitions by the barred values, lhs - rhs."""
    return (
        zeta_bar - epsilon * zeta,
        mu_bar - epsilon * mu,
        F_0_bar - epsilon * F_0,
        F_k_bar - epsilon * F_k,
        Omega**2 - (1 + epsilon * sigma),
    )


def period(Omega, *, xp=np):
    """text after (10): T. The period of G."""
    return 2 * xp.pi / Omega


def first_order_solution(A, Omega, psi, *, xp=np):
    """(11): u, u'. The assumed solution."""
    return A * xp.cos(psi), -A * Omega * xp.sin(psi)


def psi(Omega, tau, phi, *, xp=np):
    """text after (11): psi. The fast angle."""
    return Omega * tau + phi


def velocity_condition(u_dot, A, A_dot, phi_dot, Omega, psi, *, xp=np):
    """(12): u'. Time derivative of the first equation of (11), lhs - rhs."""
    return u_dot - (A_dot * xp.cos(psi) - A * Omega * xp.sin(psi) - A * phi_dot * xp.sin(psi))


def variation_condition(A, A_dot, phi_dot, psi, *, xp=np):
    """(13): condition on A', phi'. Condition that makes (12) agree with (11), lhs - rhs."""
    return A_dot * xp.cos(psi) - A * phi_dot * xp.sin(psi)


def acceleration_condition(u, u_ddot, A, A_dot, phi_dot, Omega, psi, *, xp=np):
    """(14): u''. Time derivative of the second equation of (11), lhs - rhs."""
    return u_ddot + Omega**2 * u - (-A_dot * Omega * xp.sin(psi) - A * Omega * phi_dot * xp.cos(psi))


def forced_condition(A, A_dot, phi_dot, Omega, psi, epsilon, G, *, xp=np):
    """(15): equation for A', phi'. (14) put into (8), lhs - rhs."""
    return A_dot * Omega * xp.sin(psi) + A * Omega * phi_dot * xp.cos(psi) + epsilon * G


def linear_system(A, A_dot, phi_dot, Omega, psi, epsilon, G, *, xp=np):
    """(16): linear system for A', A phi'. (13) and (15) with right side (0, -epsilon G / Omega), lhs - rhs."""
    return (
        xp.cos(psi) * A_dot - xp.sin(psi) * A * phi_dot,
        xp.sin(psi) * A_dot + xp.cos(psi) * A * phi_dot + epsilon / Omega * G,
    )


def modulation(Omega, psi, epsilon, G, *, xp=np):
    """(17): A', A phi'. Solution of (16)."""
    return -epsilon / Omega * G * xp.sin(psi), -epsilon / Omega * G * xp.cos(psi)


def averaged_modulation_integrand(Omega, psi, epsilon, G, *, xp=np):
    """(18): A', A phi'. Integrands over psi from 0 to 2 pi, prefactor included, whose integrals are (A', A phi')."""
    return (
        -epsilon / (2 * xp.pi * Omega) * G * xp.sin(psi),
        -epsilon / (2 * xp.pi * Omega) * G * xp.cos(psi),
    )


def Gamma(A, phi, Omega, F_0, zeta, mu, sigma, epsilon, H_i, *, xp=np):
    """(19): Gamma. Slow flow (A', A phi'). H_i is (21) or (22) at A."""
    return (
        -epsilon / (2 * Omega) * (F_0 * xp.sin(phi) + 2 * zeta * Omega * A + 4 / xp.pi * mu),
        -epsilon / (2 * Omega) * (F_0 * xp.cos(phi) + sigma * A + H_i),
    )


def H_i_integrand_plus(f_k, psi, *, xp=np):
    """(20): H_i [plus in front]. Integrand over psi from 0 to 2 pi, with prefactor. f_k is the force at A cos psi."""
    return 1 / (2 * xp.pi) * f_k * xp.cos(psi)


def H_i_integrand_minus(f_k, psi, *, xp=np):
    """(20): H_i [minus in front]. Integrand over psi from 0 to 2 pi, with prefactor. f_k is the force at A cos psi."""
    return -1 / (2 * xp.pi) * f_k * xp.cos(psi)


def H_1(A, alpha, beta, gamma, *, xp=np):
    """(21): H_1. Averaged restoring force for A <= u_cr."""
    return (1 - alpha) * A - 3 * beta * A**3 / 4 - 5 * gamma * A**5 / 8


def detachment_angle(A, u_cr, psi_0, *, xp=np):
    """text before (22): u_cr in terms of psi_0. The angle at which the springs detach, lhs - rhs."""
    return u_cr - A * xp.cos(psi_0)


def H_2(A, alpha, beta, gamma, psi_0, *, xp=np):
    """(22): H_2. Averaged restoring force for A > u_cr. psi_0 is (32)."""
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


def fixed_points(A, phi, Omega, F_0, zeta, mu, sigma, H_i, *, xp=np):
    """(23): fixed points. Of (19): two residuals lhs - rhs."""
    return (
        F_0 * xp.sin(phi) + 2 * zeta * Omega * A + 4 / xp.pi * mu,
        F_0 * xp.cos(phi) + sigma * A + H_i,
    )


def F(Omega, A, F_0, zeta, mu, H_i, *, xp=np):
    """(24): F. Frequency-response function, zero on the response curve. H_i is (21) or (22) at A."""
    return (
        A**2 * Omega**4
        + (4 * A**2 * zeta**2 + 2 * A * (H_i - A)) * Omega**2
        + 16 / xp.pi * mu * zeta * A * Omega
        + 16 / xp.pi**2 * mu**2
        + (H_i - A) ** 2
        - F_0**2
    )


def tan_phi(Omega, A, zeta, mu, H_i, *, xp=np):
    """(25): tan phi. Tangent of the phase."""
    return (2 * zeta * Omega * A + 4 / xp.pi * mu) / ((Omega**2 - 1) * A + H_i)


def backbone(A_c, Omega, H_i, *, xp=np):
    """(26): A_c. Backbone A_c = H_i / (1 - Omega^2), lhs - rhs. H_i is (21) or (22) at A_c."""
    return A_c - H_i / (1 - Omega**2)


def A_L(Omega, F_0, zeta, mu, *, xp=np):
    """(27): A_L. Limit envelope."""
    return (F_0 - 4 / xp.pi * mu) / (2 * zeta * Omega)


def F_0_sticking(mu, *, xp=np):
    """text after (27): F_0 at sticking. The forcing amplitude that must be exceeded, otherwise the system sticks."""
    return 4 / xp.pi * mu


# Section 3.2: stability


def D_q_Gamma(A, Omega, zeta, mu, sigma, H_i, dH_i_dA, *, xp=np):
    """(28): D_q Gamma. Jacobian of (19) with respect to q = (A, phi) at a fixed point: two rows of two entries."""
    return (
        (-zeta, 1 / (2 * Omega) * (sigma * A + H_i)),
        (-1 / (2 * Omega * A) * (sigma + dH_i_dA), -zeta - 2 * mu / (xp.pi * Omega * A)),
    )


def characteristic_equation(eigenvalue, trace, determinant, *, xp=np):
    """(29): characteristic equation. Of (28), lhs - rhs. The eigenvalue is the paper's second lambda."""
    return eigenvalue**2 - trace * eigenvalue + determinant


def stability_boundary(Omega, A, zeta, mu, H_i, dH_i_dA, *, xp=np):
    """(30): stability boundary. det(D_q Gamma) = 0, lhs - rhs."""
    return (
        Omega**4
        + (H_i / A + dH_i_dA + 4 * zeta**2 - 2) * Omega**2
        + 8 * zeta * mu / (xp.pi * A) * Omega
        + (1 - dH_i_dA) * (1 - H_i / A)
    )


def dH_2_dA_inverse_A(A, alpha, beta, gamma, u_cr, p, q, psi_0, *, xp=np):
    """(31): dH_2/dA [fourth term 6 q A^-1 u_cr]. Derivative of (22). p, q, psi_0 are (32)."""
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


def dH_2_dA_A(A, alpha, beta, gamma, u_cr, p, q, psi_0, *, xp=np):
    """(31): dH_2/dA [fourth term 6 q A u_cr, as in the plain text]. Derivative of (22). p, q, psi_0 are (32)."""
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


def p(A, u_cr, *, xp=np):
    """(32): p. Abbreviation p of (31)."""
    return xp.sqrt(1 - u_cr**2 / A**2)


def q(A, alpha, beta, gamma, *, xp=np):
    """(32): q. Abbreviation q of (31)."""
    return -8 + 8 * alpha + 18 * A**2 * beta + 25 * A**4 * gamma


def psi_0(A, u_cr, *, xp=np):
    """(32): psi_0. Angle of detachment, for A > u_cr."""
    return xp.arccos(u_cr / A)


# Section 3.3: critical forcing amplitudes


def saddle_node_resultant(*, xp=np):
    """(33): resultant for A_s. Its zero is the inflection amplitude A_s: only even powers, up to the 36th."""
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


def detachment_resultant(*, xp=np):
    """(34): resultant for F_cr. Its zero is the critical forcing F_cr: only even powers, up to the sixth."""
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


def delta_h_qzs_inverse(lam, r, *, xp=np):
    """text after (34): delta_h at quasi-zero stiffness [(lam r)^-1]. Upper end of the range of delta_h."""
    return (lam * r) ** -1


def delta_h_qzs_literal(lam, r, *, xp=np):
    """text after (34): delta_h at quasi-zero stiffness [lam r^-1]. Upper end of the range of delta_h."""
    return lam * r**-1


# Section 4.1: Den Hartog's solution


def A_den_hartog(F_0, mu, V, U, *, xp=np):
    """(35): A. Den Hartog's amplitude of continuous motion for delta_h = 0 and zeta = 0. V and U are (37)."""
    return F_0 * xp.sqrt(V**2 - (mu / F_0) ** 2 * U**2)


def A_stick_slip(F_0, Omega, V, U, S, *, xp=np):
    """(36): bound of A. The amplitude must exceed it for a motion without stops. V, U and S are (37)."""
    return F_0 * xp.sqrt(V**2 / (1 + (U * Omega**2 / S) ** 2))


def V(Omega, *, xp=np):
    """(37): V. Response function."""
    return 1 / (1 - Omega**2)


def U(Omega, *, xp=np):
    """(37): U. Damping function."""
    return xp.sin(xp.pi / Omega) / (Omega * (1 + xp.cos(xp.pi / Omega)))


def S_maximand_plus_plus(Omega, tau, U, *, xp=np):
    """(37): S [+ Omega sin tau, + cos Omega tau]. The maximum of this over 0 <= tau <= pi / Omega."""
    return (Omega * xp.sin(tau) + U * Omega**2 * (xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_plus_minus(Omega, tau, U, *, xp=np):
    """(37): S [+ Omega sin tau, - cos Omega tau]. The maximum of this over 0 <= tau <= pi / Omega."""
    return (Omega * xp.sin(tau) + U * Omega**2 * (-xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_minus_plus(Omega, tau, U, *, xp=np):
    """(37): S [- Omega sin tau, + cos Omega tau]. The maximum of this over 0 <= tau <= pi / Omega."""
    return (-Omega * xp.sin(tau) + U * Omega**2 * (xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_minus_minus(Omega, tau, U, *, xp=np):
    """(37): S [- Omega sin tau, - cos Omega tau]. The maximum of this over 0 <= tau <= pi / Omega."""
    return (-Omega * xp.sin(tau) + U * Omega**2 * (-xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def mu_over_F_0_sticking(*, xp=np):
    """text of Section 4.1: mu / F_0 at sticking. The threshold beyond which the system sticks."""
    return xp.pi / 4


# Section 4.2: parametric analysis


def zeta_eq(Omega, A, zeta, mu, *, xp=np):
    """(38): zeta_eq. Equivalent viscous damping ratio."""
    return zeta + 2 * mu / (xp.pi * Omega * A)


def F_cr_limit_literal(mu, *, xp=np):
    """text of Section 4.2: F_cr as delta_h -> 0 [pi mu / 4, as printed]. The limit."""
    return xp.pi * mu / 4


def F_cr_limit_inverse(mu, *, xp=np):
    """text of Section 4.2: F_cr as delta_h -> 0 [4 mu / pi]. The limit."""
    return 4 * mu / xp.pi


# Section 4.3: numerical example


def delta_h_limit_inverse(r, *, xp=np):
    """text of Section 4.3: delta_h at quasi-zero stiffness [(3 r)^-1]. Its upper end for lam = 3."""
    return (3 * r) ** -1


def delta_h_limit_literal(r, *, xp=np):
    """text of Section 4.3: delta_h at quasi-zero stiffness [3 r^-1]. Its upper end for lam = 3."""
    return 3 * r**-1


# Appendix A: direct integration


def smoothed_equation_of_motion_u(u, u_dot, u_ddot, Phi_1, Phi_2, lam, r, delta_h, zeta, mu, F_0, Omega, tau, *, xp=np):
    """(A1): equation of motion [linear term x read as u]. Smoothed, lhs - rhs. Phi_1, Phi_2 are (A2)."""
    return (
        u_ddot
        + 2 * zeta * u_dot
        + Phi_1 * mu
        + u
        - lam * r * (delta_h - 1 + xp.sqrt(1 - u**2)) * u / xp.sqrt(1 - u**2) * Phi_2
        - F_0 * xp.cos(Omega * tau)
    )


def smoothed_equation_of_motion_x(
    u, u_dot, u_ddot, x, Phi_1, Phi_2, lam, r, delta_h, zeta, mu, F_0, Omega, tau, *, xp=np
):
    """(A1): equation of motion [linear term x as printed]. Smoothed, lhs - rhs. Phi_1, Phi_2 are (A2)."""
    return (
        u_ddot
        + 2 * zeta * u_dot
        + Phi_1 * mu
        + x
        - lam * r * (delta_h - 1 + xp.sqrt(1 - u**2)) * u / xp.sqrt(1 - u**2) * Phi_2
        - F_0 * xp.cos(Omega * tau)
    )


def Phi_1(nu_1, u_dot, *, xp=np):
    """(A2): Phi_1. Smoothed sign of the velocity, in exponentials as printed: doubles overflow for nu_1 |u'| > 709."""
    return (xp.exp(nu_1 * u_dot) - xp.exp(-nu_1 * u_dot)) / (xp.exp(nu_1 * u_dot) + xp.exp(-nu_1 * u_dot))


def Phi_2_minus_minus(nu_2, u, u_cr, *, xp=np):
    """(A2): Phi_2 [exponents -nu_2 (u + u_cr), -nu_2 (u - u_cr)]. Smoothed indicator of |u| <= u_cr."""
    return 1 / (1 + xp.exp(-nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(-nu_2 * (u - u_cr)))


def Phi_2_plus_plus(nu_2, u, u_cr, *, xp=np):
    """(A2): Phi_2 [exponents nu_2 (u + u_cr), nu_2 (u - u_cr)]. Smoothed indicator of |u| <= u_cr."""
    return 1 / (1 + xp.exp(nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(nu_2 * (u - u_cr)))


def Phi_2_minus_plus(nu_2, u, u_cr, *, xp=np):
    """(A2): Phi_2 [exponents -nu_2 (u + u_cr), nu_2 (u - u_cr)]. Smoothed indicator of |u| <= u_cr."""
    return 1 / (1 + xp.exp(-nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(nu_2 * (u - u_cr)))


def Phi_2_plus_minus(nu_2, u, u_cr, *, xp=np):
    """(A2): Phi_2 [exponents nu_2 (u + u_cr), -nu_2 (u - u_cr)]. Smoothed indicator of |u| <= u_cr."""
    return 1 / (1 + xp.exp(nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(-nu_2 * (u - u_cr)))


# Captions and Table 1


def delta_h_caption_inverse(r, *, xp=np):
    """captions of Figures 2, 3, 4: delta_h [(6 r)^-1]. The preload."""
    return (6 * r) ** -1


def delta_h_caption_literal(r, *, xp=np):
    """captions of Figures 2, 3, 4: delta_h [6 r^-1]. The preload."""
    return 6 * r**-1


def delta_h_table_inverse(r, *, xp=np):
    """Table 1: delta_h [1 / (6 r)]. The preload."""
    return 1 / (6 * r)


def delta_h_table_literal(r, *, xp=np):
    """Table 1: delta_h [(1 / 6) r]. The preload."""
    return r / 6


FORMULAS = formulas(globals())

# delta_h is taken as 1 / (6 r): Table 1's other reading, r / 6, is an entry of FORMULAS.
TABLE_1: dict[str, Fraction] = {
    "lam": Fraction(3),
    "r": Fraction(3747, 1848),
    "delta_h": 1 / (6 * Fraction(3747, 1848)),
    "mu": Fraction(12, 1000),
    "zeta": Fraction(2, 100),
}

COLUMNS = tuple(one.name for one in fields(Table2Row))
TITLE_2 = "Saddle node bifurcation points"
TABLE_2: tuple[Table2Row, ...] = (
    Table2Row("F_SN", "-", "-", "-", "-"),
    Table2Row("0.025", "0.8023", "0.1722", "0.8318", "0.2893"),
    Table2Row("F_cr", "0.8287", "0.1842", "0.9288", "u_cr"),
    Table2Row("0.040", "0.8672", "0.2052", "0.9938", "0.5536"),
    Table2Row("0.050", "0.8976", "0.2222", "1.0175", "0.5876"),
)


def _numbers(quoted):
    """Those of published.toml and of Table 2."""
    for where, sentences in quoted.items():
        for sentence, of in sentences.items():
            for name, (symbol, printed) in of.items():
                yield Number(name, symbol, printed, where, sentence)
    for k, row in enumerate(TABLE_2, start=1):
        for column, printed in vars(row).items():
            kind, _, quantity = column.rpartition("_")
            symbol = f"{kind.replace('_', '-')} {quantity} at {row.F_0}" if column != "F_0" else column
            yield Number(f"table_2_row_{k}_{column}", symbol, printed, "Table 2", TITLE_2, (row.F_0, column))


_QUOTED = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
NUMBERS, CLAIMS = tuple(_numbers(_QUOTED["number"])), claims(_QUOTED["claim"])
