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

import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
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


def equation_of_motion_dimensional(x, x_dot, x_ddot, F_k, m, c, k_v, F_c, F, omega, t, *, xp=np):
    """(1) Equation of motion, lhs - rhs, in physical units. F_k is the value of (2) at x."""
    return m * x_ddot + c * x_dot + k_v * x + F_c * xp.sign(x_dot) + F_k - F * xp.cos(omega * t)


def F_k_dimensional(x, lam, k_h, L, Delta_h, *, xp=np):
    """(2) Restoring force of the horizontal springs: (value for |x| <= x_cr, value for |x| > x_cr)."""
    attached = lam * k_h * (L - Delta_h - xp.sqrt(L**2 - x**2)) * x / xp.sqrt(L**2 - x**2)
    return attached, 0


def x_cr(L, Delta_h, *, xp=np):
    """(2) Displacement at which the horizontal springs leave the push-rod."""
    return xp.sqrt(L**2 - (L - Delta_h) ** 2)


def equation_of_motion(u, u_dot, u_ddot, F_k, zeta, mu, F_0, Omega, tau, *, xp=np):
    """(3) Dimensionless equation of motion, lhs - rhs. zeta and mu carry a bar in the paper. F_k is (5) or (6) at u."""
    return u_ddot + 2 * zeta * u_dot + u + mu * xp.sign(u_dot) + F_k - F_0 * xp.cos(Omega * tau)


def dimensionless_quantities(
    omega_n, tau, Omega, u, delta_h, zeta, mu, F_0, r, m, c, k_v, k_h, F_c, F, omega, t, x, L, Delta_h, *, xp=np
):
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


def F_k_scaling(F_k_u, F_k_x, k_v, L, *, xp=np):
    """(5) Definition of the dimensionless force F_k(u) from F_k(x) of (2), lhs - rhs."""
    return F_k_u - F_k_x / (k_v * L)


def F_k(u, lam, r, delta_h, *, xp=np):
    """(5) Dimensionless restoring force: (value for |u| <= u_cr, value for |u| > u_cr)."""
    attached = lam * r * (1 - delta_h - xp.sqrt(1 - u**2)) * u / xp.sqrt(1 - u**2)
    return attached, 0


def u_cr(delta_h, *, xp=np):
    """(5) Critical displacement: the horizontal springs detach beyond it."""
    return xp.sqrt(1 - (1 - delta_h) ** 2)


def F_k_taylor(u, alpha, beta, gamma, *, xp=np):
    """(6) Fifth-order Taylor expansion of (5): (value for |u| <= u_cr, value for |u| > u_cr)."""
    return (alpha - 1) * u + beta * u**3 + gamma * u**5, 0


def alpha(lam, r, delta_h, *, xp=np):
    """(7) Linear coefficient: the stiffness at the equilibrium."""
    return 1 - lam * r * delta_h


def beta(lam, r, delta_h, *, xp=np):
    """(7) Cubic coefficient."""
    return lam * r * (1 - delta_h) / 2


def gamma(lam, r, delta_h, *, xp=np):
    """(7) Quintic coefficient."""
    return 3 * lam * r * (1 - delta_h) / 8


# Section 3.1: periodic motion


def averaging_form(u, u_ddot, Omega, epsilon, G, *, xp=np):
    """(8) Rescaled equation of motion, lhs - rhs. G is the value of (9)."""
    return u_ddot + Omega**2 * u - epsilon * G


def G(u, u_dot, F_k, F_0, Omega, tau, zeta, mu, sigma, *, xp=np):
    """(9) The perturbation G(u, u', Omega tau). F_k is the (unbarred) restoring force at u."""
    return F_0 * xp.cos(Omega * tau) - 2 * zeta * u_dot - mu * xp.sign(u_dot) - F_k + sigma * u


def rescaling(zeta_bar, mu_bar, F_0_bar, F_k_bar, Omega, zeta, mu, F_0, F_k, sigma, epsilon, *, xp=np):
    """(10) Definitions of zeta, mu, F_0, F_k by their barred values, and of sigma: five residuals lhs - rhs."""
    return (
        zeta_bar - epsilon * zeta,
        mu_bar - epsilon * mu,
        F_0_bar - epsilon * F_0,
        F_k_bar - epsilon * F_k,
        Omega**2 - (1 + epsilon * sigma),
    )


def period(Omega, *, xp=np):
    """Text after (10): the period T of G."""
    return 2 * xp.pi / Omega


def first_order_solution(A, Omega, psi, *, xp=np):
    """(11) The assumed solution: (u, u')."""
    return A * xp.cos(psi), -A * Omega * xp.sin(psi)


def psi(Omega, tau, phi, *, xp=np):
    """Text after (11): the fast angle."""
    return Omega * tau + phi


def velocity_condition(u_dot, A, A_dot, phi_dot, Omega, psi, *, xp=np):
    """(12) Time derivative of the first equation of (11), lhs - rhs."""
    return u_dot - (A_dot * xp.cos(psi) - A * Omega * xp.sin(psi) - A * phi_dot * xp.sin(psi))


def variation_condition(A, A_dot, phi_dot, psi, *, xp=np):
    """(13) Condition that makes (12) agree with (11), lhs - rhs."""
    return A_dot * xp.cos(psi) - A * phi_dot * xp.sin(psi)


def acceleration_condition(u, u_ddot, A, A_dot, phi_dot, Omega, psi, *, xp=np):
    """(14) Time derivative of the second equation of (11), lhs - rhs."""
    return u_ddot + Omega**2 * u - (-A_dot * Omega * xp.sin(psi) - A * Omega * phi_dot * xp.cos(psi))


def forced_condition(A, A_dot, phi_dot, Omega, psi, epsilon, G, *, xp=np):
    """(15) (14) put into (8): A' Omega sin psi + A Omega phi' cos psi = -epsilon G, lhs - rhs."""
    return A_dot * Omega * xp.sin(psi) + A * Omega * phi_dot * xp.cos(psi) + epsilon * G


def linear_system(A, A_dot, phi_dot, Omega, psi, epsilon, G, *, xp=np):
    """(16) (13) and (15) as a linear system for (A', A phi') with right side (0, -epsilon G / Omega): two lhs - rhs."""
    return (
        xp.cos(psi) * A_dot - xp.sin(psi) * A * phi_dot,
        xp.sin(psi) * A_dot + xp.cos(psi) * A * phi_dot + epsilon / Omega * G,
    )


def modulation(Omega, psi, epsilon, G, *, xp=np):
    """(17) Solution of (16): (A', A phi')."""
    return -epsilon / Omega * G * xp.sin(psi), -epsilon / Omega * G * xp.cos(psi)


def averaged_modulation_integrand(Omega, psi, epsilon, G, *, xp=np):
    """(18) Integrands over psi from 0 to 2 pi, prefactor included, whose integrals are (A', A phi')."""
    return (
        -epsilon / (2 * xp.pi * Omega) * G * xp.sin(psi),
        -epsilon / (2 * xp.pi * Omega) * G * xp.cos(psi),
    )


def Gamma(A, phi, Omega, F_0, zeta, mu, sigma, epsilon, H_i, *, xp=np):
    """(19) Slow flow: (A', A phi'). H_i is (21) or (22) at A."""
    return (
        -epsilon / (2 * Omega) * (F_0 * xp.sin(phi) + 2 * zeta * Omega * A + 4 / xp.pi * mu),
        -epsilon / (2 * Omega) * (F_0 * xp.cos(phi) + sigma * A + H_i),
    )


def H_i_integrand_plus(f_k, psi, *, xp=np):
    """(20) Integrand of H_i over psi from 0 to 2 pi, with prefactor, plus in front. f_k is the force at A cos psi."""
    return 1 / (2 * xp.pi) * f_k * xp.cos(psi)


def H_i_integrand_minus(f_k, psi, *, xp=np):
    """(20) Integrand of H_i over psi from 0 to 2 pi, with prefactor, minus in front. f_k is the force at A cos psi."""
    return -1 / (2 * xp.pi) * f_k * xp.cos(psi)


def H_1(A, alpha, beta, gamma, *, xp=np):
    """(21) Averaged restoring force for A <= u_cr."""
    return (1 - alpha) * A - 3 * beta * A**3 / 4 - 5 * gamma * A**5 / 8


def detachment_angle(A, u_cr, psi_0, *, xp=np):
    """Text before (22): u_cr = A cos psi_0, lhs - rhs."""
    return u_cr - A * xp.cos(psi_0)


def H_2(A, alpha, beta, gamma, psi_0, *, xp=np):
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


def fixed_points(A, phi, Omega, F_0, zeta, mu, sigma, H_i, *, xp=np):
    """(23) Fixed points of (19): two residuals lhs - rhs."""
    return (
        F_0 * xp.sin(phi) + 2 * zeta * Omega * A + 4 / xp.pi * mu,
        F_0 * xp.cos(phi) + sigma * A + H_i,
    )


def F(Omega, A, F_0, zeta, mu, H_i, *, xp=np):
    """(24) Frequency-response function, zero on the response curve. H_i is (21) or (22) at A."""
    return (
        A**2 * Omega**4
        + (4 * A**2 * zeta**2 + 2 * A * (H_i - A)) * Omega**2
        + 16 / xp.pi * mu * zeta * A * Omega
        + 16 / xp.pi**2 * mu**2
        + (H_i - A) ** 2
        - F_0**2
    )


def tan_phi(Omega, A, zeta, mu, H_i, *, xp=np):
    """(25) Tangent of the phase."""
    return (2 * zeta * Omega * A + 4 / xp.pi * mu) / ((Omega**2 - 1) * A + H_i)


def backbone(A_c, Omega, H_i, *, xp=np):
    """(26) Backbone A_c = H_i / (1 - Omega^2), lhs - rhs. H_i is (21) or (22) at A_c."""
    return A_c - H_i / (1 - Omega**2)


def A_L(Omega, F_0, zeta, mu, *, xp=np):
    """(27) Limit envelope."""
    return (F_0 - 4 / xp.pi * mu) / (2 * zeta * Omega)


def F_0_sticking(mu, *, xp=np):
    """Text after (27): the forcing amplitude that must be exceeded, otherwise the system sticks."""
    return 4 / xp.pi * mu


# Section 3.2: stability


def D_q_Gamma(A, Omega, zeta, mu, sigma, H_i, dH_i_dA, *, xp=np):
    """(28) Jacobian of (19) with respect to q = (A, phi) at a fixed point: two rows of two entries."""
    return (
        (-zeta, 1 / (2 * Omega) * (sigma * A + H_i)),
        (-1 / (2 * Omega * A) * (sigma + dH_i_dA), -zeta - 2 * mu / (xp.pi * Omega * A)),
    )


def characteristic_equation(eigenvalue, trace, determinant, *, xp=np):
    """(29) Characteristic equation of (28), lhs - rhs. The eigenvalue is the paper's second lambda."""
    return eigenvalue**2 - trace * eigenvalue + determinant


def stability_boundary(Omega, A, zeta, mu, H_i, dH_i_dA, *, xp=np):
    """(30) Stability boundary det(D_q Gamma) = 0, lhs - rhs."""
    return (
        Omega**4
        + (H_i / A + dH_i_dA + 4 * zeta**2 - 2) * Omega**2
        + 8 * zeta * mu / (xp.pi * A) * Omega
        + (1 - dH_i_dA) * (1 - H_i / A)
    )


def dH_2_dA_inverse_A(A, alpha, beta, gamma, u_cr, p, q, psi_0, *, xp=np):
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


def dH_2_dA_A(A, alpha, beta, gamma, u_cr, p, q, psi_0, *, xp=np):
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


def p(A, u_cr, *, xp=np):
    """(32) Abbreviation p of (31)."""
    return xp.sqrt(1 - u_cr**2 / A**2)


def q(A, alpha, beta, gamma, *, xp=np):
    """(32) Abbreviation q of (31)."""
    return -8 + 8 * alpha + 18 * A**2 * beta + 25 * A**4 * gamma


def psi_0(A, u_cr, *, xp=np):
    """(32) Angle of detachment, for A > u_cr."""
    return xp.arccos(u_cr / A)


# Section 3.3: critical forcing amplitudes


def saddle_node_resultant(*, xp=np):
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


def detachment_resultant(*, xp=np):
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


def delta_h_qzs_inverse(lam, r, *, xp=np):
    """Text after (34): upper end of the range of delta_h, the quasi-zero stiffness mechanism, read (lam r)^-1."""
    return (lam * r) ** -1


def delta_h_qzs_literal(lam, r, *, xp=np):
    """Text after (34): upper end of the range of delta_h, the quasi-zero stiffness mechanism, read lam r^-1."""
    return lam * r**-1


# Section 4.1: Den Hartog's solution


def A_den_hartog(F_0, mu, V, U, *, xp=np):
    """(35) Den Hartog's amplitude of continuous motion for delta_h = 0 and zeta = 0. V and U are (37)."""
    return F_0 * xp.sqrt(V**2 - (mu / F_0) ** 2 * U**2)


def A_stick_slip(F_0, Omega, V, U, S, *, xp=np):
    """(36) Bound that the amplitude must exceed for a motion without stops. V, U and S are (37)."""
    return F_0 * xp.sqrt(V**2 / (1 + (U * Omega**2 / S) ** 2))


def V(Omega, *, xp=np):
    """(37) Response function."""
    return 1 / (1 - Omega**2)


def U(Omega, *, xp=np):
    """(37) Damping function."""
    return xp.sin(xp.pi / Omega) / (Omega * (1 + xp.cos(xp.pi / Omega)))


def S_maximand_plus_plus(Omega, tau, U, *, xp=np):
    """(37) S is the maximum of this over 0 <= tau <= pi / Omega. Signs: + Omega sin tau, + cos Omega tau."""
    return (Omega * xp.sin(tau) + U * Omega**2 * (xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_plus_minus(Omega, tau, U, *, xp=np):
    """(37) S is the maximum of this over 0 <= tau <= pi / Omega. Signs: + Omega sin tau, - cos Omega tau."""
    return (Omega * xp.sin(tau) + U * Omega**2 * (-xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_minus_plus(Omega, tau, U, *, xp=np):
    """(37) S is the maximum of this over 0 <= tau <= pi / Omega. Signs: - Omega sin tau, + cos Omega tau."""
    return (-Omega * xp.sin(tau) + U * Omega**2 * (xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def S_maximand_minus_minus(Omega, tau, U, *, xp=np):
    """(37) S is the maximum of this over 0 <= tau <= pi / Omega. Signs: - Omega sin tau, - cos Omega tau."""
    return (-Omega * xp.sin(tau) + U * Omega**2 * (-xp.cos(Omega * tau) + xp.cos(tau))) / xp.sin(Omega * tau)


def mu_over_F_0_sticking(*, xp=np):
    """Text of Section 4.1: threshold of mu / F_0 beyond which the system sticks."""
    return xp.pi / 4


# Section 4.2: parametric analysis


def zeta_eq(Omega, A, zeta, mu, *, xp=np):
    """(38) Equivalent viscous damping ratio."""
    return zeta + 2 * mu / (xp.pi * Omega * A)


def F_cr_limit_literal(mu, *, xp=np):
    """Text of Section 4.2: limit of F_cr for delta_h -> 0, read pi mu / 4."""
    return xp.pi * mu / 4


def F_cr_limit_inverse(mu, *, xp=np):
    """Text of Section 4.2: limit of F_cr for delta_h -> 0, read 4 mu / pi."""
    return 4 * mu / xp.pi


# Section 4.3: numerical example


def delta_h_limit_inverse(r, *, xp=np):
    """Text of Section 4.3: the preload beyond which the stiffness is negative for lam = 3, read (3 r)^-1."""
    return (3 * r) ** -1


def delta_h_limit_literal(r, *, xp=np):
    """Text of Section 4.3: the preload beyond which the stiffness is negative for lam = 3, read 3 r^-1."""
    return 3 * r**-1


# Appendix A: direct integration


def smoothed_equation_of_motion_u(u, u_dot, u_ddot, Phi_1, Phi_2, lam, r, delta_h, zeta, mu, F_0, Omega, tau, *, xp=np):
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
    u, u_dot, u_ddot, x, Phi_1, Phi_2, lam, r, delta_h, zeta, mu, F_0, Omega, tau, *, xp=np
):
    """(A1) Smoothed equation of motion, lhs - rhs, with its linear spring force x as printed. Phi_1, Phi_2 are (A2)."""
    return (
        u_ddot
        + 2 * zeta * u_dot
        + Phi_1 * mu
        + x
        - lam * r * (delta_h - 1 + xp.sqrt(1 - u**2)) * u / xp.sqrt(1 - u**2) * Phi_2
        - F_0 * xp.cos(Omega * tau)
    )


def Phi_1(nu_1, u_dot, *, xp=np):
    """(A2) Smoothed sign of the velocity, in exponentials as printed: doubles overflow for nu_1 |u'| > 709."""
    return (xp.exp(nu_1 * u_dot) - xp.exp(-nu_1 * u_dot)) / (xp.exp(nu_1 * u_dot) + xp.exp(-nu_1 * u_dot))


def Phi_2_minus_minus(nu_2, u, u_cr, *, xp=np):
    """(A2) Smoothed indicator of |u| <= u_cr, exponents -nu_2 (u + u_cr) and -nu_2 (u - u_cr)."""
    return 1 / (1 + xp.exp(-nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(-nu_2 * (u - u_cr)))


def Phi_2_plus_plus(nu_2, u, u_cr, *, xp=np):
    """(A2) Smoothed indicator of |u| <= u_cr, exponents nu_2 (u + u_cr) and nu_2 (u - u_cr)."""
    return 1 / (1 + xp.exp(nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(nu_2 * (u - u_cr)))


def Phi_2_minus_plus(nu_2, u, u_cr, *, xp=np):
    """(A2) Smoothed indicator of |u| <= u_cr, exponents -nu_2 (u + u_cr) and nu_2 (u - u_cr)."""
    return 1 / (1 + xp.exp(-nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(nu_2 * (u - u_cr)))


def Phi_2_plus_minus(nu_2, u, u_cr, *, xp=np):
    """(A2) Smoothed indicator of |u| <= u_cr, exponents nu_2 (u + u_cr) and -nu_2 (u - u_cr)."""
    return 1 / (1 + xp.exp(nu_2 * (u + u_cr))) - 1 / (1 + xp.exp(-nu_2 * (u - u_cr)))


# Captions and Table 1


def delta_h_caption_inverse(r, *, xp=np):
    """Captions of Figures 2, 3, 4: preload, read (6 r)^-1."""
    return (6 * r) ** -1


def delta_h_caption_literal(r, *, xp=np):
    """Captions of Figures 2, 3, 4: preload, read 6 r^-1."""
    return 6 * r**-1


def delta_h_table_inverse(r, *, xp=np):
    """Table 1: preload, read 1 / (6 r)."""
    return 1 / (6 * r)


def delta_h_table_literal(r, *, xp=np):
    """Table 1: preload, read (1 / 6) r."""
    return r / 6


FORMULAS: tuple[Formula, ...] = (
    Formula("(1)", "equation of motion", equation_of_motion_dimensional),
    Formula("(2)", "F_k(x)", F_k_dimensional),
    Formula("(2)", "x_cr", x_cr),
    Formula("(3)", "equation of motion", equation_of_motion),
    Formula("(4)", "omega_n, tau, Omega, u, delta_h, zeta, mu, F_0, r", dimensionless_quantities),
    Formula("(5)", "F_k(u) in terms of F_k(x)", F_k_scaling),
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
    Formula("text before (22)", "u_cr in terms of psi_0", detachment_angle),
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
    Formula("(31)", "dH_2/dA", dH_2_dA_A, "fourth term 6 q A u_cr, as in the plain text"),
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

TITLE_2 = "Saddle node bifurcation points"
TABLE_2: tuple[Table2Row, ...] = (
    Table2Row("F_SN", "-", "-", "-", "-"),
    Table2Row("0.025", "0.8023", "0.1722", "0.8318", "0.2893"),
    Table2Row("F_cr", "0.8287", "0.1842", "0.9288", "u_cr"),
    Table2Row("0.040", "0.8672", "0.2052", "0.9938", "0.5536"),
    Table2Row("0.050", "0.8976", "0.2222", "1.0175", "0.5876"),
)


def _stated():
    """Numbers and claims, as published.toml has them."""
    stated = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
    numbers = [
        Number(name, symbol, printed, where, sentence)
        for where, sentences in stated["number"].items()
        for sentence, of in sentences.items()
        for name, (symbol, printed) in of.items()
    ]
    for k, row in enumerate(TABLE_2, start=1):
        for column, printed in vars(row).items():
            symbol = column.rpartition("_")[2] if column != "F_0" else column
            numbers.append(Number(f"table_2_row_{k}_{column}", symbol, printed, "Table 2", TITLE_2))
    claims = [Claim(name, where, sentence) for where, of in stated["claim"].items() for name, sentence in of.items()]
    return tuple(numbers), tuple(claims)


NUMBERS, CLAIMS = _stated()
