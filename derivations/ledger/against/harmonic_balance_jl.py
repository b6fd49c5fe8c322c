"""Against HarmonicBalance.jl: one harmonic in the equation of motion, and (17) averaged to second order.

With c = A e^(i phi) = u - i v and z = e^(i Omega tau) the displacement A cos psi is (c z + c_bar/z)/2, and (17) gives
the rate r of c, a polynomial in z and 1/z. Averaging to second order keeps

    mean of r + mean of (dr/dc d + dr/dc_bar d_bar)

where d, the change of variables, is the integral of r less its mean, and has no mean.
"""

from __future__ import annotations

import sympy as sp

from ...paper.averaging import G
from ...symbols import A, Omega, epsilon, psi
from ..rows import FALSE, TRUE
from . import Claims, Derived, Judge, equal

u, v, u_dot, v_dot, alpha, beta, eta, gamma, lam, F = sp.symbols(
    "u v u_dot v_dot alpha beta eta gamma lam F", real=True
)
omega_0 = sp.Symbol("omega_0", positive=True)
NAMES = {x.name: x for x in (u, v, u_dot, v_dot, alpha, beta, eta, gamma, lam, F, omega_0)} | {"omega": Omega}
c, c_bar, c_dot, c_dot_bar, z, turn = sp.symbols("c c_bar c_dot c_dot_bar z turn")  # turn is e^(i phi)
CONJUGATE = {sp.I: -sp.I, c: c_bar, c_bar: c, c_dot: c_dot_bar, c_dot_bar: c_dot, z: 1 / z}
COMPONENTS = {c: u - sp.I * v, c_bar: u + sp.I * v, c_dot: u_dot - sp.I * v_dot, c_dot_bar: u_dot + sp.I * v_dot}

Pair = tuple[sp.Expr, sp.Expr]


def real(amplitude: sp.Expr) -> sp.Expr:
    """The harmonic with this amplitude: Re amplitude z."""
    return (amplitude * z + (amplitude * z).xreplace(CONJUGATE)) / 2


def components(amplitude: sp.Expr) -> Pair:
    """x and y of x - i y."""
    value = sp.expand(amplitude.xreplace(COMPONENTS))
    return value.subs(sp.I, 0), sp.expand((value.subs(sp.I, 0) - value) / sp.I)


def harmonics(expression: sp.Expr) -> dict[int, sp.Expr]:
    """Coefficients of a polynomial in z and 1/z, by power of z."""
    terms = sp.collect(sp.expand(expression), z, evaluate=False)
    return {0: sp.S.Zero} | {int(power.as_base_exp()[1]) if power != 1 else 0: value for power, value in terms.items()}


X, COSINE, COSINE_2 = real(c), real(sp.S.One), (z**2 + z**-2) / 2


def balances() -> Pair:
    """Cosine and sine of the pumped oscillator's equation of motion."""
    velocity = real(c_dot + sp.I * Omega * c)
    force = gamma * velocity + (omega_0**2 - lam * COSINE_2) * X + alpha * X**3 + eta * X**2 * velocity + F * COSINE
    return components(2 * harmonics(real(2 * sp.I * Omega * c_dot - Omega**2 * c) + force)[1])


def second_order(derived: Derived, force: sp.Expr, excitation: sp.Expr) -> tuple[Pair, sp.Expr]:
    """Averaged rates of u and v, and d, of x'' + gamma x' + omega_0^2 x + force = excitation."""
    of_A, of_phi = (rate.subs(epsilon, 1) for rate in derived.averaged.unaveraged)
    whole = z * turn  # e^(i psi)
    circle = {sp.cos(psi): (whole + 1 / whole) / 2, sp.sin(psi): (whole - 1 / whole) / (2 * sp.I)}
    perturbation = excitation - force - gamma * real(sp.I * Omega * c) + (Omega**2 - omega_0**2) * X
    rate = sp.expand(((of_A + sp.I * of_phi) * turn).subs(circle)).subs(G, perturbation)
    of = harmonics(rate)
    change = sp.Add(*(value * z**k / (sp.I * k * Omega) for k, value in of.items() if k))
    more = harmonics(sp.diff(rate, c) * change + sp.diff(rate, c_bar) * change.xreplace(CONJUGATE))[0]
    return components(of[0] + more), change


def formulas(derived: Derived) -> dict[str, Judge]:
    """Balances of one harmonic, and rates of second order."""
    harmonic = "one harmonic in the equation of motion, second derivatives of u and v neglected"
    averaging = "averaging (17) to second order"
    mixed, _ = second_order(derived, beta * X**2 + alpha * X**3, F * COSINE_2)
    forced, _ = second_order(derived, sp.S.Zero, F * COSINE)
    names = ("cosine_balance", "sine_balance", "u_rate", "v_rate", "forced_u_rate", "forced_v_rate")
    found = (*((one, harmonic) for one in balances()), *((one, averaging) for one in (*mixed, *forced)))
    return {name: equal(one, NAMES, rewriting=by) for name, (one, by) in zip(names, found, strict=True)}


def claims(derived: Derived) -> Claims:
    """The free oscillation of the cubic spring, to second order in alpha."""
    (_, of_v), change = second_order(derived, alpha * X**3, sp.S.Zero)
    w_1, w_2, m = sp.symbols("w_1 w_2 m")
    slow = omega_0 + w_1 * epsilon + w_2 * epsilon**2
    free = {gamma: 0, v: 0, alpha: epsilon * alpha, Omega: slow}

    def order(expression: sp.Expr, power: int) -> sp.Expr:
        return sp.factor(sp.diff(expression, epsilon, power).subs(epsilon, 0) / sp.factorial(power))

    balance = of_v.subs(free)
    (first,) = sp.solve(order(balance, 1), w_1)
    (second,) = sp.solve(order(balance, 2).subs(w_1, first), w_2)
    # the displacement is largest where z = 1
    largest = u + epsilon * order(components(change.subs(z, 1))[0].subs(free), 1).subs(w_1, first)
    square = epsilon * alpha * A**2
    elliptic = sum(sp.rf(sp.Rational(1, 2), k) ** 2 / sp.factorial(k) ** 2 * m**k for k in range(3))  # 2 K/pi
    exact = sp.sqrt(omega_0**2 + square) / elliptic.subs(m, square / (2 * (omega_0**2 + square)))
    off = slow.subs({w_1: first, w_2: second}) - exact.subs(A, largest)
    series = sp.Add(*(order(exact, k) for k in range(3)))
    return {
        "higher_orders": (
            TRUE if all(order(off, k) == 0 for k in range(3)) else FALSE,
            "With α alone, the second order and its change of variables give, for the free oscillation with the "
            f"largest displacement A, the frequency {sp.sstr(series)}: the series of the exact one, "
            "π√(ω₀² + αA²)/(2K), to that order, proved.",
        )
    }
