"""Step 2, equations (8)-(20): variation of parameters and averaging over one cycle (Krylov, Bogoliubov, Mitropolsky).

In:  the shape of the equation of motion; the restoring force stays an open function F_k.
Out: `Averaged`: the amplitude and phase equations before and after averaging. What the mechanism contributes is one
     number for each amplitude, H = -(1/pi) int_0^{2 pi} F_k(A cos psi) cos psi dpsi, the definition behind (20).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.simplify.fu import TR8

from ..claims import claim
from ..symbols import F_0, A, Omega, epsilon, mu, phi, psi, sigma, zeta

A_dot, phi_dot = sp.symbols("A_dot phi_dot", real=True)
G = sp.Symbol("G", real=True)
F_k = sp.Symbol("F_k", real=True)
H = sp.Symbol("H", real=True)

DISPLACEMENT = A * sp.cos(psi)
VELOCITY = -A * Omega * sp.sin(psi)


@dataclass(frozen=True)
class Averaged:
    """The slow flow, for A' and for A phi' (11)-(20)."""

    compatibility: sp.Expr  #: (13): A' cos psi - A phi' sin psi = 0, so that u' keeps the form of (11)
    motion: sp.Expr  #: (15): A' Omega sin psi + A Omega phi' cos psi = -epsilon G, times -1
    unaveraged: tuple[sp.Expr, sp.Expr]  #: (17): A' = -(epsilon/Omega) G sin psi, A phi' = -(epsilon/Omega) G cos psi
    #: (9) at (11): G = F_0 cos(psi - phi) - 2 zeta u' - mu sign(u') - F_k + sigma u; sign(u') by half-cycle, as a pair
    perturbation: tuple[sp.Expr, sp.Expr]
    #: (19): A' = -(F_0 sin phi + 2 zeta Omega A + 4 mu/pi)/(2 Omega), A phi' = -(F_0 cos phi + sigma A + H)/(2 Omega)
    slow_flow: tuple[sp.Expr, sp.Expr]
    restoring_integrand: sp.Expr  #: (20): H is the integral of -F_k(A cos psi) cos psi/pi over a cycle


def variation_of_parameters() -> tuple[sp.Expr, sp.Expr, tuple[sp.Expr, sp.Expr]]:
    """(11)-(17): A and phi vary in u = A cos psi, u' = -A Omega sin psi, psi' = Omega + phi'; solved for A', A phi'."""

    def along_the_motion(expression: sp.Expr) -> sp.Expr:
        return sp.diff(expression, A) * A_dot + sp.diff(expression, psi) * (Omega + phi_dot)

    compatibility = sp.expand(along_the_motion(DISPLACEMENT) - VELOCITY)
    motion = sp.expand(along_the_motion(VELOCITY) + Omega**2 * DISPLACEMENT - epsilon * G)
    solution = sp.solve([compatibility, motion], [A_dot, phi_dot], dict=True)[0]
    return compatibility, motion, (sp.trigsimp(solution[A_dot]), sp.trigsimp(A * solution[phi_dot]))


def cycle_integral(integrand: sp.Expr, start: sp.Expr, end: sp.Expr) -> sp.Expr:
    """Exact integral over psi of a polynomial in sines and cosines: products become sums of multiple angles first."""
    linear = sp.expand(integrand, trig=True)
    while (halved := sp.expand(TR8(linear))) != linear:  # a power at a time
        linear = halved
    integral = sum(map(_antiderivative, sp.Add.make_args(linear)))
    return sp.expand(integral.subs(psi, end) - integral.subs(psi, start))


def _antiderivative(term: sp.Expr) -> sp.Expr:
    """By psi, of a constant, or a constant times sin(k psi + c) or cos(k psi + c)."""
    constant, wave = term.as_independent(psi)
    if wave == 1:
        return constant * psi
    (angle,) = wave.args
    return constant * {sp.sin: -sp.cos(angle), sp.cos: sp.sin(angle)}[wave.func] / sp.diff(angle, psi)


def averaged() -> Averaged:
    """All of step 2."""
    compatibility, motion, unaveraged = variation_of_parameters()
    forcing = F_0 * sp.cos(psi - phi)

    def perturbation(sign_of_velocity: int) -> sp.Expr:
        return forcing - 2 * zeta * VELOCITY - mu * sign_of_velocity - F_k + sigma * DISPLACEMENT

    # u' = -A Omega sin psi: negative over the first half of the cycle, positive over the second
    halves = ((perturbation(-1), 0, sp.pi), (perturbation(1), sp.pi, 2 * sp.pi))
    restoring_integrand = -F_k * sp.cos(psi) / sp.pi

    slow_flow = []
    for rate, harmonic, mechanism_term in zip(unaveraged, (sp.sin(psi), sp.cos(psi)), (0, H), strict=True):
        weight = sp.cancel(rate / (G * harmonic)).subs(epsilon, 1)
        claim(
            "`A'` and `A phi'` are `G sin(psi)` and `G cos(psi)` times a factor without `psi`",
            not weight.has(psi),
            eq="(17)",
        )
        known = sum(cycle_integral(half.subs(F_k, 0) * harmonic, start, end) for half, start, end in halves)
        # An odd force along A cos psi is even in psi: its sine component vanishes, its cosine component is
        # -F_k cos psi, which integrates to pi H.
        slow_flow.append(sp.factor_terms(sp.expand(weight * (known + sp.pi * mechanism_term) / (2 * sp.pi))))
    return Averaged(
        compatibility,
        motion,
        unaveraged,
        (halves[0][0], halves[1][0]),
        (slow_flow[0], slow_flow[1]),
        restoring_integrand,
    )
