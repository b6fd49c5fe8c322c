"""Writes `data/kernel_oracle.json`: every generated kernel's values to 40 digits at fixed points, by other routes.

In:  definitions typed here, Table 1 as typed from the paper, seeded points; for a mechanism that has no definitions
     here its file, see `stated`. Nothing that derives or computes.
Out: {module: {kernel: [{"at": arguments, "is": values, "scale": |f| + sum |x df/dx|}, ...]}}.

The routes: the averaged force by quadrature of the piecewise force, its derivatives and those of F by numerical
differentiation, coefficients of polynomials by interpolation, resultants as Sylvester determinants over the rationals,
the Jacobian by differentiating the averaged equations of motion, Den Hartog's solution from its four linear conditions,
moves of answers by solving what defines them for parameters on either side.

u * scale is the error that rounding the arguments and the result once each would cause: error/scale is measured in u.

After a change of the list of kernels: python -m tests.oracles.make_kernel_oracle [module ...] (all: ten minutes).
"""

from __future__ import annotations

import functools
import importlib
import itertools
import json
import math
import random
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from flint import arb, arb_series, ctx, fmpq, fmpq_poly
from mpmath import mp, mpf

from derivations.emit.catalogue.flow import OWN
from derivations.mechanisms import all_mechanisms
from slowflow.paper import published
from tests.oracles.stated import Stated

DIGITS = 40
mp.dps = 60
ctx.prec = 300
STEP = mpf(10) ** -20
EXACT_STEP = fmpq(1, 2**70)
OUT = Path(__file__).parents[1] / "data" / "kernel_oracle.json"
SCENES = {"": (), "_mu0": ("m", "mu"), "_zeta0": ("zeta",), "_mu0_zeta0": ("m", "mu", "zeta")}

Function = Callable[..., list]
# each with the parameters it belongs to
Amplitudes = list[tuple[float, tuple[float, ...]]]


# --- slow flow: the definitions --------------------------------------------------------------------------------------


def balances(Omega, A, m, zeta, h):
    """R and I: what balances F_0 cos phi and F_0 sin phi at a steady state, with the sign reversed."""
    return A * Omega**2 + h, 2 * zeta * A * Omega + m


def response(Omega, A, F_0, m, zeta, h):
    R, I = balances(Omega, A, m, zeta, h)
    return R**2 + I**2 - F_0**2


def near(A, values):
    """An h with the given value and derivatives at A."""
    return lambda a: sum(value * (a - A) ** k / mp.factorial(k) for k, value in enumerate(values))


def slope_of_response(order, Omega, A, m, zeta, *values):
    h = near(A, values)
    return mp.diff(lambda a: response(Omega, a, 0, m, zeta, h(a)), A, order)


def mixed_slope(Omega, A, m, zeta, h, h_A):
    local = near(A, (h, h_A))
    return mp.diff(lambda a, w: response(w, a, 0, m, zeta, local(a)), (A, Omega), (1, 1))


def phase(Omega, A, m, zeta, h):
    R, I = balances(Omega, A, m, zeta, h)
    if I == 0:  # the limit of vanishing damping: I > 0 keeps phi below zero
        return -mp.pi if R > 0 else mpf(0)
    return mp.arg(mp.mpc(-R, -I))


def rates(Omega, A, phi, F_0, m, zeta, h):
    """(19): the averaged A' and phi'."""
    return (
        -(F_0 * mp.sin(phi) + 2 * zeta * Omega * A + m) / (2 * Omega),
        -(F_0 * mp.cos(phi) + Omega**2 * A + h) / (2 * Omega * A),
    )


def jacobian(Omega, A, m, zeta, h, h_A):
    R, I = balances(Omega, A, m, zeta, h)
    F_0, phi = mp.sqrt(R**2 + I**2), mp.arg(mp.mpc(-R, -I))
    local = near(A, (h, h_A))
    entries = []
    for k in (0, 1):
        for by in ((1, 0), (0, 1)):
            entry = mp.diff(lambda a, f, k=k: rates(Omega, a, f, F_0, m, zeta, local(a))[k], (A, phi), by)
            entries.append(mp.chop(entry, tol=mpf(10) ** -45))
    return entries


def stability(Omega, A, m, zeta, h, h_A):
    J11, J12, J21, J22 = jacobian(Omega, A, m, zeta, h, h_A)
    return 4 * Omega**2 * (J11 * J22 - J12 * J21)


def cubic(A, h, h_A):
    """f' of the spring alpha u + beta u^3 that has this h = -alpha A - 3/4 beta A^3 and h_A at A."""
    beta = 2 * (h - A * h_A) / (3 * A**3)
    alpha = -h / A - mpf(3) / 4 * beta * A**2
    return lambda u: alpha + 3 * beta * u**2


def stiffness_harmonic(A, h, h_A, n):
    """Mean of f'(A cos psi) cos(n psi) over a cycle, by quadrature."""
    slope = cubic(A, h, h_A)
    return mp.quad(lambda psi: slope(A * mp.cos(psi)) * mp.cos(n * psi), [0, mp.pi], method="gauss-legendre") / mp.pi


def mean_stiffness(A, h, h_A):
    return stiffness_harmonic(A, h, h_A, 0)


def offset_stiffness(Omega, A, h, h_A):
    """From the balance of B + b cos 2 psi: b by the second harmonic's, put into the mean's."""
    k_0, k_2 = (stiffness_harmonic(A, h, h_A, n) for n in (0, 2))
    return k_0 + k_2 * (2 * k_2 / (4 * Omega**2 - k_0))


def dissipated(Omega, A, m, zeta):
    """Work of both dampings over a cycle of u = A cos psi, by quadrature; mu = pi m/4."""
    speed = lambda psi: A * Omega * mp.sin(psi)  # noqa: E731
    power = lambda psi: 2 * zeta * speed(psi) ** 2 + mp.pi * m / 4 * abs(speed(psi))  # noqa: E731
    return 2 * mp.quad(power, [0, mp.pi], method="gauss-legendre") / Omega


def equivalent_damping(Omega, A, m, zeta):
    """The ratio of a purely viscous damping that does the same work."""
    return zeta * 0 + dissipated(Omega, A, m, zeta) / dissipated(Omega, A, 0, mpf(1))


def transmissibility(Omega, A, F_0, m, zeta, h):
    """Harmonics of f(u) + 2 zeta u' + mu sign(u'): the force's is -h by definition, the damping's by quadrature."""
    damping = lambda psi: -2 * zeta * A * Omega * mp.sin(psi) - mp.pi * m / 4  # noqa: E731
    sine = 2 / mp.pi * mp.quad(lambda psi: damping(psi) * mp.sin(psi), [0, mp.pi], method="gauss-legendre")
    return mp.hypot(h, sine) / F_0


def interpolated(f, degree, missing):
    """Coefficients of a polynomial from its values, without one that must vanish."""
    nodes = [mpf(k) / 2 for k in range(-degree, degree + 1, 2)]
    matrix = mp.matrix([[node**k for k in range(degree + 1)] for node in nodes])
    with mp.extradps(20):
        coefficients = list(mp.lu_solve(matrix, mp.matrix([f(node) for node in nodes])))
    assert abs(coefficients.pop(missing)) < mpf(10) ** -50
    return coefficients


def response_quartic(A, F_0, m, zeta, h):
    return interpolated(lambda w: response(w, A, F_0, m, zeta, h), 4, 3)


def fold_quartic(A, m, zeta, h, h_A):
    return interpolated(lambda w: slope_of_response(1, w, A, m, zeta, h, h_A) / 2, 4, 3)


def peak_cubic(A, m, zeta, h):
    return interpolated(lambda w: mp.diff(lambda v: response(v, A, 0, m, zeta, h), w) / (4 * A), 3, 2)


def second(Omega, A, m, zeta, h, h_3, h_5):
    """The balance with harmonics: R, I, largest displacement, first harmonic; h, h_3, h_5 are functions of A."""
    K = -h(A) / A
    a_3, a_5 = (-h_n(A) / (n**2 * Omega**2 - K) for n, h_n in ((3, h_3), (5, h_5)))
    A_1 = A - a_3 - a_5
    # sum over odd n of 1/(n^2 - kappa) is pi tan(pi k/2)/(4 k), k^2 = kappa
    k = mp.sqrt(K) / Omega
    turned = mp.asin(-m / (A_1 * Omega**2) * mp.re(mp.pi * mp.tan(mp.pi * k / 2) / (4 * k) - 1 / (1 - k**2)))
    u_max = A_1 * mp.cos(turned) + a_3 + a_5
    # force of A cos psi + a_3 (cos 3 psi - cos psi) + a_5 (cos 5 psi - cos psi), to first order in a_3, a_5
    shares = (mp.diff(lambda a, h_n=h_n: h_n(a) - h(a), A) for h_n in (h_3, h_5))
    R = A_1 * Omega**2 + h(A) + sum(a_n * share for a_n, share in zip((a_3, a_5), shares, strict=True))
    # power of the forcing is what friction, 4 mu u_max a cycle, and viscosity take
    I = 2 * zeta * Omega * (A_1**2 + 9 * a_3**2 + 25 * a_5**2) / A_1 + m * u_max / A_1
    return R - m * mp.sin(turned), I, u_max, A_1


def second_kernel(kernel):
    """The kernels of the second approximation; derivatives numerically."""
    orders = 4 if kernel == "folds" else 3

    def of(Omega, A, *x):
        F_0, m, zeta, *averages = (mpf(0), *x) if kernel.startswith("detachment") else x
        families = [near(A, averages[k * orders : (k + 1) * orders]) for k in range(3)]

        def at(w, a):
            return second(w, a, m, zeta, *families)

        def F(w, a):
            R, I, *_ = at(w, a)
            return R**2 + I**2 - F_0**2

        def slope(f, by):
            return mp.diff(f, (Omega, A), by)

        R, I, u_max, A_1 = at(Omega, A)
        F_Omega, F_A = slope(F, (1, 0)), slope(F, (0, 1))
        if kernel == "folds":
            return [F(Omega, A), F_A, slope(F, (0, 2))]
        if kernel == "detachment":
            by_A, by_Omega = (slope(lambda w, a: at(w, a)[2], by) for by in ((0, 1), (1, 0)))
            return [mp.sqrt(R**2 + I**2), u_max, F_Omega * by_A - F_A * by_Omega]
        if kernel == "detachment_by_inertia":

            def level_squared(w, a):
                return (F(w, a) + F_0**2) / w**4

            (by_A, by_Omega), (rise, along) = (
                [slope(f, by) for by in ((0, 1), (1, 0))] for f in (lambda w, a: at(w, a)[2], level_squared)
            )
            return [mp.sqrt(R**2 + I**2) / Omega**2, u_max, Omega**4 * (along * by_A - rise * by_Omega)]
        slopes = [slope(lambda w, a: at(w, a)[0], by) for by in ((0, 1), (1, 0))]
        return [u_max, A_1, mp.arg(mp.mpc(-R, -I)), R, F(Omega, A), F_A, F_Omega, *slopes]

    return of


SLOW_FLOW: dict[str, tuple[str, Function]] = {
    "friction": ("mu", lambda mu: [4 * mu / mp.pi]),
    "R": ("Omega A h", lambda Omega, A, h: [balances(Omega, A, 0, 0, h)[0]]),
    "I": ("Omega A m zeta", lambda Omega, A, m, zeta: [balances(Omega, A, m, zeta, 0)[1]]),
    "F": ("Omega A F_0 m zeta h", lambda *x: [response(*x)]),
    "F_A": ("Omega A m zeta h h_A", lambda *x: [slope_of_response(1, *x)]),
    "F_AA": ("Omega A m zeta h h_A h_AA", lambda *x: [slope_of_response(2, *x)]),
    "F_Omega": ("Omega A m zeta h", lambda w, A, m, zeta, h: [mp.diff(lambda v: response(v, A, 0, m, zeta, h), w)]),
    "F_AOmega": ("Omega A m zeta h h_A", lambda *x: [mixed_slope(*x)]),
    "phase": ("Omega A m zeta h", lambda *x: [phase(*x)]),
    "backbone": ("A h", lambda A, h: [mp.findroot(lambda w: balances(w, A, 0, 0, h)[0], mp.sqrt(-h / A))]),
    "limit_envelope": (
        "Omega F_0 m zeta",
        lambda w, F_0, m, zeta: [(F_0 - m) / balances(w, 1, 0, zeta, 0)[1] if zeta else mp.inf],
    ),
    "equivalent_damping": ("Omega A m zeta", lambda *x: [equivalent_damping(*x)]),
    "transmissibility": ("Omega A F_0 m zeta h", lambda *x: [transmissibility(*x)]),
    "jacobian": ("Omega A m zeta h h_A", jacobian),
    "mean_stiffness": ("A h h_A", lambda A, h, h_A: [mean_stiffness(A, h, h_A)]),
    "offset_stiffness": ("Omega A h h_A", lambda *x: [offset_stiffness(*x)]),
    "stability": ("Omega A m zeta h h_A", lambda *x: [stability(*x)]),
    "response_quartic": ("A F_0 m zeta h", response_quartic),
    "fold_quartic": ("A m zeta h h_A", fold_quartic),
    "peak_cubic": ("A m zeta h", peak_cubic),
}


# --- where curves change along the amplitude -------------------------------------------------------------------------


def level(Omega, A, m, zeta, h):
    """The forcing at which the response vanishes, found as a root."""
    R, I = balances(Omega, A, m, zeta, h)
    return mp.findroot(lambda F_0: response(Omega, A, F_0, m, zeta, h), abs(R) + I)


def rest(F_0, m, h, h_A):
    c = mp.findroot(lambda x: response(0, 1, F_0, m, 0, x), F_0)
    return [h - c, h + c, mp.diff(lambda a: near(mpf(1), (h, h_A))(a) + c, 1)]


def isola_frequency(h_A):
    """Of a state with F_A = F_Omega = 0 at A = 1, found together with h; the damping is arbitrary."""
    m, zeta = mpf(1) / 100, mpf(1) / 20

    def both(w, h):
        F_Omega = mp.diff(lambda v: response(v, 1, 0, m, zeta, h), w)
        return [slope_of_response(1, w, mpf(1), m, zeta, h, h_A), F_Omega]

    return mp.findroot(both, (1.01 * mp.sqrt(h_A), -1.01 * h_A))[0]


def isola(A, m, zeta, *values):
    """F_Omega/(4 A) where Omega^2 = h_A, and its slope; without the common factor Omega if there is no friction."""
    h, h_A = near(A, values), near(A, values[1:])

    def along(a):
        w = mp.sqrt(h_A(a))
        value = mp.diff(lambda v: response(v, a, 0, m, zeta, h(a)), w) / (4 * a)
        return value if m else value / w

    return [along(A), mp.diff(along, A)]


def tangent(A, *values):
    """Where the tangent of h meets A = 0, from h's Taylor series, and its slope."""
    h = near(A, values)

    def at_0(a):
        value, slope = mp.taylor(h, a, 1)
        return value - a * slope

    return [at_0(A), mp.diff(at_0, A)]


def fold(A, F_0, m, zeta, h, h_A, k, k_A):
    """On the circle R^2 + I^2 = F_0^2 and the line k R + m I = F_0^2, by angles: R less A Omega^2 + h, reversed."""
    of_h, of_k = near(A, (h, h_A)), near(A, (k, k_A))

    def at(a):
        normal, half = mp.atan2(m, of_k(a)), mp.acos(F_0 / mp.hypot(of_k(a), m))
        I, R = max((F_0 * mp.sin(angle), F_0 * mp.cos(angle)) for angle in (normal + half, normal - half))
        w = (I - m) / balances(1, a, 0, zeta, 0)[1]
        return balances(w, a, 0, 0, of_h(a))[0] - R, w

    return [at(A)[0], mp.diff(lambda a: at(a)[0], A), at(A)[1]]


def quadratic(f):
    """Half the linear and the constant coefficient of a monic quadratic, from its values at 0 and 1."""
    return [(f(mpf(1)) - f(mpf(0)) - 1) / 2, f(mpf(0))]


def cusps(A, zeta, h, h_A, h_AA, k):
    """F_AA/2 by T = Omega^2 + h_A, where R = k + A T, and by X = Omega^2, where R = A X + h."""

    def half_F_AA(X, value):
        local = near(A, (value, h_A, h_AA))
        return mp.re(mp.diff(lambda a: response(mp.sqrt(X), a, 0, 0, zeta, local(a)), A, 2)) / 2

    a, b = quadratic(lambda T: half_F_AA(T - h_A, k + A * T - A * (T - h_A)))
    return [a, b, *quadratic(lambda X: half_F_AA(X, h)), a**2 - b]


def cusp_R(A, zeta, h_AA, k, X, T):
    """k + A T, and the R for which F_AA, which is linear in it, vanishes."""

    def F_AA(R):
        return slope_of_response(2, mp.sqrt(X), A, 0, zeta, R - A * X, T - X, h_AA)

    return [k + A * T, F_AA(mpf(0)) / (F_AA(mpf(0)) - F_AA(mpf(1)))]


def cusp_balance(A, m, zeta, h, k, X, T):
    """The R for which F_A, linear in it, vanishes at h_A = T - X; Omega^2 by it, the forcing as of `cusp`, squared."""
    w = mp.sqrt(X)
    F_A = [slope_of_response(1, w, A, m, zeta, R - A * X, T - X) for R in (mpf(0), mpf(1))]
    R = F_A[0] / (F_A[0] - F_A[1])
    I = balances(w, A, m, zeta, h)[1]
    return [(R - h) / A, R * k + m * I]


def cusp(A, m, zeta, h_AA, h_AAA, k, X, T, R, root):
    """By differentiating F along A and Omega; F_AA/2 = (X - X_1)(X - X_2), root = (X_1 - X_2)/2, at X = X_1.

    R is k + A T, which the second uses; the forcing is that of R (k + A T) in place of R^2.
    """
    w, h_A = mp.sqrt(X), T - X
    values, tangent = (((r - A * X, h_A, h_AA, h_AAA)) for r in (R, k + A * T))
    half_F_A, half_F_AAA = (slope_of_response(n, w, A, m, zeta, *values) / 2 for n in (1, 3))
    by_tangent = [slope_of_response(n, w, A, m, zeta, *tangent) / 2 for n in (1, 2)]
    half_F_AAOmega = mp.diff(lambda v: (v**2 - X) * (v**2 - X + 2 * root), w)
    along = -mixed_slope(w, A, m, zeta, *values[:2]) / 2 * half_F_AAA / half_F_AAOmega
    I = balances(w, A, m, zeta, values[0])[1]
    return [half_F_A, by_tangent[0] - A * by_tangent[1], along, mp.sqrt(R * (k + A * T) + I**2 - A * half_F_A)]


def stationary(Omega, A, m, zeta):
    """The h that makes F stationary over Omega."""

    def by_Omega(h):
        return mp.diff(lambda w: response(w, A, 0, m, zeta, h), Omega)

    return mp.findroot(by_Omega, (-A * Omega**2, -A * Omega**2 - 1))


def peak_slope(Omega, A, m, zeta, h_A):
    """dOmega/dA where F stays stationary over Omega."""
    F_AOmega, F_OmegaOmega = partials([(1, 1), (0, 2)], Omega, A, m, zeta, stationary(Omega, A, m, zeta), h_A)
    return -F_AOmega / F_OmegaOmega


def peak(Omega, A, F_0, m, zeta, h_A):
    """F, and its slope along A, for the h that makes F stationary over Omega."""
    h = stationary(Omega, A, m, zeta)
    return [response(Omega, A, F_0, m, zeta, h), slope_of_response(1, Omega, A, m, zeta, h, h_A)]


def undamped_fold(F_0, m, k, k_A):
    """F of a state whose R is k, and its slope."""
    F = lambda a: response(0, 1, F_0, m, 0, near(mpf(1), (k, k_A))(a))  # noqa: E731
    return [F(mpf(1)), mp.diff(F, 1)]


def undamped_frequency(h_A):
    """Of a fold off the backbone; A and h are arbitrary."""
    return mp.findroot(lambda w: slope_of_response(1, w, mpf(1), 0, 0, mpf(1), h_A), 1.01 * mp.sqrt(-h_A))


def undamped_rises(h_AA, h_AAA, k):
    """The slope of level^2/2 at A = 1 along folds whose tangent meets A = 0 at k; the same of h_AAA where h_AA is 0."""

    def slope(*derivatives):
        h = near(mpf(1), (k, mpf(0), *derivatives))
        tangent = lambda a: h(a) - a * mp.diff(h, a)  # noqa: E731
        return lambda a: mp.diff(lambda s: level(0, 1, 0, 0, tangent(s)) ** 2 / 2, a)

    return [slope(h_AA)(1), mp.diff(slope(0, h_AAA), 1)]


def fold_moves(A, k, R):
    """F and F_A beside a point with that R, whose tangent along A meets A = 0 at k, at an I that stays."""

    def of(order):
        def moved(y):
            slope_of_R = (R + y - k) / A
            return mp.diff(lambda a: (R + y + slope_of_R * (a - A)) ** 2, A, order)

        return mp.diff(moved, 0)

    return [of(0), of(1)]


def undamped(A, *values):
    """F_AA/(2 R) and R at the undamped folds, each with its slope."""
    h, h_A = near(A, values), near(A, values[1:])

    def R(a):
        return balances(mp.sqrt(-h_A(a)), a, 0, 0, h(a))[0]

    def other(a):
        w = mp.sqrt(-h_A(a))
        return mp.diff(lambda s: response(w, s, 0, 0, 0, h(s)), a, 2) / (2 * R(a))

    return [other(A), mp.diff(other, A), R(A), mp.diff(R, A)]


#: names, function, sign of h_A where a root of it is taken
def partials(orders, Omega, A, m, zeta, *values):
    """Derivatives of F by their orders in A and in Omega, numerically."""
    h = near(A, values)
    return [mp.diff(lambda a, w: response(w, a, 0, m, zeta, h(a)), (A, Omega), order) for order in orders]


def slope_of_frequency(Omega, A, m, zeta, *values):
    """dOmega/dA of the states at one forcing, found as roots."""
    h = near(A, values)
    level_here = response(Omega, A, 0, m, zeta, h(A))
    return mp.diff(
        lambda a: mp.findroot(lambda w: response(w, a, 0, m, zeta, h(a)) - level_here, Omega, tol=mpf(10) ** -110), A
    )


def hessian(*x):
    F_AA, F_AOmega, F_OmegaOmega = partials([(2, 0), (1, 1), (0, 2)], *x)
    return mp.det(mp.matrix([[F_AA, F_AOmega], [F_AOmega, F_OmegaOmega]]))


def level_rise(*x):
    F_Omega, F_AA, F_AOmega = partials([(0, 1), (2, 0), (1, 1)], *x)
    return -F_Omega * F_AA * F_AOmega


def cusp_bend(Omega, A, *x):
    F_Omega, F_AAA, F_AOmega = partials([(0, 1), (3, 0), (1, 1)], Omega, A, *x)
    return -F_Omega * F_AAA * F_AOmega / A


def tail(Omega, F_0, m):
    """Of the states of a spring h = A without viscous damping."""
    return mp.findroot(lambda a: response(Omega, a, F_0, m, 0, a), F_0 / Omega**2)


def most_restoring(A, F_0, m, zeta):
    """F_0 + A Omega^2 at the Omega for which damping takes all of the forcing, from its values at 0 and 1."""
    at_0, at_1 = (balances(w, A, m, zeta, 0)[1] for w in (0, 1))
    return F_0 + A * ((F_0 - at_0) / (at_1 - at_0)) ** 2


def isolation(A, h):
    """Where the force on the base, h beside the same damping, is as large as the forcing, found as a root."""
    m, zeta = mpf("0.01"), mpf("0.03")

    def excess(w):
        R, I = balances(w, A, m, zeta, h)
        return mp.sqrt(h**2 + I**2) - mp.sqrt(R**2 + I**2)

    return mp.findroot(excess, 1.4 * mp.sqrt(-h / A))


def response_at_rest(m, preload):
    """The forcing of a motion of no amplitude."""
    return mp.sqrt(response(mpf(1), mpf(0), 0, m, mpf("0.03"), -preload))


SLOPES: dict[str, tuple[str, Function]] = {
    "Omega_A": ("Omega A m zeta h h_A", lambda *x: [slope_of_frequency(*x)]),
    "level_rise": ("Omega A m zeta h h_A h_AA", lambda *x: [level_rise(*x)]),
    "cusp_bend": ("Omega A m zeta h h_A h_AA h_AAA", lambda *x: [cusp_bend(*x)]),
    "isola_bend": ("Omega A m zeta h h_A h_AA", lambda *x: [partials([(2, 0)], *x)[0] * hessian(*x)]),
    "hessian": ("Omega A m zeta h h_A h_AA", lambda *x: [hessian(*x)]),
    "most_restoring": ("A F_0 m zeta", lambda *x: [most_restoring(*x)]),
    "least_restoring": ("F_0 m", lambda *x: [mp.sqrt(mp.mpf(x[0]) ** 2 - mp.mpf(x[1]) ** 2)]),
    "tail": ("Omega F_0 m", lambda *x: [tail(*x)]),
    "isolation": ("A h", lambda *x: [isolation(*x)]),
    "held": ("m preload", lambda *x: [response_at_rest(*x)]),
}
LOCI: dict[str, tuple[str, Function, int]] = {
    "F_OmegaOmega": ("Omega A zeta h", lambda w, A, z, h: [mp.diff(lambda v: response(v, A, 0, 0, z, h), w, 2)], 0),
    "level": ("Omega A m zeta h", lambda *x: [level(*x)], 0),
    "rest": ("F_0 m h h_A", rest, 0),
    "intercept": ("A h h_A h_AA", tangent, 0),
}
DAMPED: dict[str, tuple[str, Function, int]] = {
    "isola_Omega": ("h_A", lambda h_A: [isola_frequency(h_A)], 1),
    "isola": ("A m zeta h h_A h_AA", isola, 1),
    "fold": ("A F_0 m zeta h h_A intercept k_A", fold, 0),
    "cusps": ("A zeta h h_A h_AA intercept", cusps, 0),
    "cusp_R": ("A zeta h_AA intercept X T", cusp_R, 0),
    "cusp": ("A m zeta h_AA h_AAA intercept X T R root", cusp, 0),
    "cusp_balance": ("A m zeta h intercept X T", cusp_balance, 0),
    "peak": ("Omega A F_0 m zeta h_A", peak, 0),
    "peak_Omega_A": ("Omega A m zeta h_A", lambda *x: [peak_slope(*x)], 0),
}
UNDAMPED: dict[str, tuple[str, Function, int]] = {
    "undamped_Omega": ("h_A", lambda h_A: [undamped_frequency(h_A)], -1),
    "undamped": ("A h h_A h_AA h_AAA", undamped, -1),
    "fold": ("F_0 m intercept k_A", undamped_fold, 0),
    "undamped_level": ("m intercept", lambda m, k: [level(0, 1, m, 0, k)], 0),
    "undamped_rises": ("h_AA h_AAA intercept", undamped_rises, 0),
}


# --- how answers move with a parameter -------------------------------------------------------------------------------

AT = "Omega A F_0 m zeta h h_A h_AA h_AAA"
CAUSES = "h_p h_Ap h_AAp m_p zeta_p end_p forcing_p frequency_p"
ASIDE = mpf(10) ** -40
#: by the kind of answer: what is given of it or vanishes there, by orders in A and Omega; and the partial derivatives
#: that must not vanish
PINNED: dict[str, tuple[tuple, tuple]] = {
    "state": (("forcing", "frequency"), ((1, 0),)),
    "fold": (("forcing", (1, 0)), ((2, 0), (0, 1))),
    "corner_fold": (("forcing", "end"), ((0, 1),)),
    "peak": (("forcing", (0, 1)), ((1, 0), (0, 2))),
    "cusp": (((1, 0), (2, 0)), ((3, 0), (1, 1))),
    "isola": (((1, 0), (0, 1)), ("hessian",)),
    "corner_top": (("end", (0, 1)), ((0, 2),)),
    "corner_end": (("end", (1, 0)), ((1, 1),)),
    "corner_backbone": (("end", "R"), ("R",)),
    "corner_rest": (("end", "frequency"), ()),
}


def moves(kind, Omega, A, F_0, m, zeta, *others):
    """Of the answer of a spring that changes with t: solved for at t on either side of 0.

    What is to vanish at t = 0 need not, of arguments at random: F is taken less these terms of its Taylor series.
    """
    (h, *slopes), (h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p) = others[:4], others[4:]
    if kind == "corner_backbone":
        h = -A * Omega**2
    conditions, kept = PINNED[kind]
    gone = [orders for orders in conditions if isinstance(orders, tuple)]
    terms_gone = list(zip(gone, partials(gone, Omega, A, m, zeta, h, *slopes), strict=True))
    level_gone = response(Omega, A, F_0, m, zeta, h)

    def answer(t):
        local = near(A, (h + t * h_p, slopes[0] + t * h_Ap, slopes[1] + t * h_AAp, slopes[2]))

        def F(a, w, f):
            value = response(w, a, f, m + t * m_p, zeta + t * zeta_p, local(a)) - level_gone
            for (i, j), c in terms_gone:
                value -= c * (a - A) ** i * (w - Omega) ** j / (mp.factorial(i) * mp.factorial(j))
            return value

        def equations(a, w, f):
            found = [F(a, w, f)]
            for condition in conditions:
                if isinstance(condition, tuple):
                    found.append(mp.diff(lambda x, y: F(x, y, f), (a, w), condition))
                else:
                    given = {"forcing": f - F_0 - t * forcing_p, "frequency": w - Omega - t * frequency_p}
                    given |= {"end": a - A - t * end_p, "R": balances(w, a, 0, 0, local(a))[0]}
                    found.append(given[condition])
            return found

        return list(mp.findroot(equations, (A, Omega, F_0), tol=mpf(10) ** -100))

    with mp.workdps(120):
        below, above = answer(-ASIDE), answer(ASIDE)
        moved = [mp.chop((b - a) / (2 * ASIDE), tol=mpf(10) ** -45) for a, b in zip(below, above, strict=True)]
    pivots = []
    for one in kept:
        value, size = (must_not_vanish(one, Omega, A, m, zeta, *map(sign, (h, *slopes))) for sign in (mpf, abs))
        pivots += [value[0] - value[1], size[0] + size[1]] if one == "hessian" else [value, size]
    return [*moved, *pivots, *[mpf(1)] * (4 - len(pivots))]


def must_not_vanish(one, Omega, A, m, zeta, *values):
    """A derivative of F, what F's Hessian is the difference of, or R's slope; of h's sizes no term has a sign."""
    if one == "R":
        return mp.diff(lambda w: balances(w, A, 0, 0, values[0])[0], Omega)
    if one != "hessian":
        return partials([one], Omega, A, m, zeta, *values)[0]
    F_AA, F_AOmega, F_OmegaOmega = partials([(2, 0), (1, 1), (0, 2)], Omega, A, m, zeta, *values)
    return F_AA * F_OmegaOmega, F_AOmega**2


def beside_point(Omega, A, m, zeta, h, h_A):
    """F_A, F_Omega and R, each with its size."""
    pairs = [
        [*partials([(1, 0), (0, 1)], Omega, A, m, zeta, *values), balances(Omega, A, 0, 0, values[0])[0]]
        for values in ((h, h_A), (abs(h), abs(h_A)))
    ]
    return [value for pair in zip(*pairs, strict=True) for value in pair]


def moves_of_phase(Omega, A, F_0, m, zeta, h, h_A, h_p, m_p, zeta_p, A_p, Omega_p, F_0_p):
    """Of a state that moves along a line, by differentiating the phase and the transmissibility along it."""

    def at(t):
        own = Omega + t * Omega_p, A + t * A_p
        damping, force = (m + t * m_p, zeta + t * zeta_p), h + t * (h_p + h_A * A_p)
        return phase(*own, *damping, force), transmissibility(*own, F_0 + t * F_0_p, *damping, force)

    return [mp.diff(lambda t, k=k: at(t)[k], 0) for k in (0, 1)]


GRADIENTS: dict[str, tuple[str, Function]] = {
    **{f"moves_of_{kind}": (f"{AT} {CAUSES}", functools.partial(moves, kind)) for kind in PINNED},
    "beside": ("Omega A F_0 m zeta h h_A", lambda w, A, F_0, *x: beside_point(w, A, *x)),
    "moves_of_phase": ("Omega A F_0 m zeta h h_A h_p m_p zeta_p A_p Omega_p F_0_p", moves_of_phase),
    "fold_moves": ("A intercept R", fold_moves),
}
#: what is asked beside a fold
BESIDE_FOLDS: dict[str, tuple[str, Function]] = {
    "fold_square": ("Omega A lacks", lambda w, A, y: [w**2 - y / A]),
}


# --- resultants: Sylvester determinants over the rationals -----------------------------------------------------------


def determinant(matrix: list[list[fmpq_poly]]) -> fmpq_poly:
    """Bareiss' elimination without fractions."""
    matrix = [row[:] for row in matrix]
    size, previous, sign = len(matrix), fmpq_poly([1]), 1
    for k in range(size - 1):
        pivot = next((i for i in range(k, size) if matrix[i][k] != 0), None)
        if pivot is None:
            return fmpq_poly([0])
        if pivot != k:
            matrix[k], matrix[pivot], sign = matrix[pivot], matrix[k], -sign
        for i in range(k + 1, size):
            for j in range(k + 1, size):
                matrix[i][j] = (matrix[k][k] * matrix[i][j] - matrix[i][k] * matrix[k][j]) // previous
        previous = matrix[k][k]
    return sign * matrix[-1][-1]


def resultant(first: list[fmpq_poly], second: list[fmpq_poly]) -> fmpq_poly:
    """Of two polynomials in Omega, given by their coefficients, constant first."""
    zero = fmpq_poly([0])
    first, second = ([c for c in reversed(p)] for p in (first, second))
    while first[0] == 0:
        first = first[1:]
    while second[0] == 0:
        second = second[1:]
    n, k = len(first) - 1, len(second) - 1
    rows = [[zero] * i + first + [zero] * (k - 1 - i) for i in range(k)]
    rows += [[zero] * i + second + [zero] * (n - 1 - i) for i in range(n)]
    return determinant(rows)


def essential(polynomial: fmpq_poly, leading: fmpq) -> list[fmpq]:
    """Coefficients of even power of the product of distinct factors but the unknown itself, scaled to a leading one."""
    distinct = polynomial // polynomial.gcd(polynomial.derivative())
    if distinct[0] == 0:
        distinct = distinct // fmpq_poly([0, 1])
    distinct = distinct * (leading / distinct[distinct.degree()])
    assert all(distinct[k] == 0 for k in range(1, distinct.degree() + 1, 2))
    return [distinct[k] for k in range(0, distinct.degree() + 1, 2)]


def constant(x) -> fmpq_poly:
    return fmpq_poly([x])


X = fmpq_poly([0, 1])


def detachment(A, m, zeta, h):
    """Res(F, F_Omega) in F_0; its essential part is monic."""
    R, I = [constant(h), constant(0), constant(A)], [constant(m), constant(2 * zeta * A)]
    F = added(product(R, R), product(I, I), [-X * X])
    return essential(resultant(F, derived(F)), fmpq(1))


def product(a, b):
    result = [fmpq_poly([0])] * (len(a) + len(b) - 1)
    for (i, x), (j, y) in itertools.product(enumerate(a), enumerate(b)):
        result[i + j] = result[i + j] + x * y
    return result


def added(*polynomials):
    size = max(map(len, polynomials))
    return [sum((p[k] for p in polynomials if k < len(p)), fmpq_poly([0])) for k in range(size)]


def derived(polynomial):
    """By Omega."""
    return [k * c for k, c in enumerate(polynomial)][1:]


def by_amplitude(polynomial):
    return [c.derivative() for c in polynomial]


def first_regime(coefficients):
    """h of an odd polynomial force: the mean of 2 cos^(n+1) is 2 (n+1 choose (n+1)/2)/2^(n+1)."""
    total = fmpq_poly([0])
    for k, c in enumerate(coefficients):
        n = 2 * k + 1
        total = total - c * fmpq(2 * int(mp.binomial(n + 1, (n + 1) // 2)), 2 ** (n + 1)) * X**n
    return total


def in_amplitude(F_0, m, zeta, coefficients):
    """F as a polynomial in Omega over Q[A]."""
    R, I = [first_regime(coefficients), constant(0), X], [constant(m), 2 * zeta * X]
    return added(product(R, R), product(I, I), [constant(-F_0 * F_0)])


def saddle_node_onset(leading, m, zeta, *coefficients):
    F_A = by_amplitude(in_amplitude(fmpq(0), m, zeta, coefficients))
    return essential(resultant(F_A, by_amplitude(F_A)), leading)


def saddle_nodes(leading, F_0, m, zeta, *coefficients):
    F = in_amplitude(F_0, m, zeta, coefficients)
    return essential(resultant(F, by_amplitude(F)), leading)


#: the scale of a resultant is a convention: its leading coefficient once its factors are primitive over the integers
LEADING = {
    ("rod_spring", "saddle_node_onset"): lambda zeta, a, b, c: 9765625 * c**8,
    ("rod_spring", "saddle_nodes"): lambda zeta, a, b, c: 15625 * c**6 * zeta**4,
    ("duffing", "saddle_node_onset"): lambda zeta, a, b: 59049 * b**8,
    ("duffing", "saddle_nodes"): lambda zeta, a, b: 729 * b**6 * zeta**4,
}


# --- the averaged force ----------------------------------------------------------------------------------------------

#: mechanisms whose definitions are typed here
TYPED = ("duffing", "rod_spring", "rod_spring_untruncated")


@functools.cache
def stated(name: str) -> Stated | None:
    """What the file of another mechanism says."""
    return None if name in TYPED else Stated(next(one for one in all_mechanisms() if one.name == name))


def pieces(name: str, p: Sequence):
    """The whole restoring force, piece by piece, and where the pieces end."""
    if other := stated(name):
        return other.pieces(p)
    if name == "duffing":
        alpha, beta = p
        return [lambda u: alpha * u + beta * u**3], []
    if name == "rod_spring_untruncated":
        alpha, beta, delta_h = p
        # the rod's end has drawn back by delta_h
        u_cr = mp.sqrt(delta_h * (2 - delta_h))
        return [lambda u: alpha * u + 2 * beta * u * (1 / mp.sqrt(1 - u**2) - 1), lambda u: u], [u_cr]
    alpha, beta, gamma, u_cr = p
    return [lambda u: alpha * u + beta * u**3 + gamma * u**5, lambda u: u], [u_cr]


def joined(name: str, p: Sequence):
    """The pieces once their end is exceeded. The untruncated force is continuous there: alpha follows from the rest."""
    forces, ends = pieces(name, p)
    if name == "rod_spring_untruncated":
        beta, (u_cr,) = p[1], ends
        below = lambda u: u + 2 * beta * u * (1 / mp.sqrt(1 - u**2) - 1 / mp.sqrt(1 - u_cr**2))  # noqa: E731
        forces = [below, *forces[1:]]
    return forces, ends


def average(name: str, p: Sequence, passed: int, less_vertical: bool) -> Callable:
    """-(1/pi) int_0^{2 pi} f(A cos psi) cos psi dpsi by quadrature over a quarter, `passed` ends exceeded."""
    forces, ends = pieces(name, p)

    def of(A):
        cuts = [mpf(0), *(mp.asin(b / A) for b in ends[:passed]), mp.pi / 2]
        total = mpf(0)
        for f, start, end in zip(forces, cuts, cuts[1:], strict=False):

            def integrand(t, f=f):
                u = A * mp.sin(t)
                return (f(u) - u if less_vertical else f(u)) * mp.sin(t)

            total += mp.quad(integrand, [start, end], method="gauss-legendre")
        return -4 / mp.pi * total

    return of


@functools.cache
def gauss(count: int) -> list[tuple[arb, arb]]:
    """Nodes and weights on [0, 1]."""
    pairs = [arb.legendre_p_root(count, k, weight=True) for k in range(count)]
    return [((1 + x) / 2, w / 2) for x, w in pairs]


def untruncated_family(passed: int, less_vertical: bool, A, *p) -> list:
    """The same by Gauss's rule on Taylor series in A, on panels that get finer towards u_cr, where the force is steep.

    In balls, because mpmath takes seconds for these.
    """
    before, ctx.cap = ctx.cap, 4
    alpha, beta, delta_h = map(ball, p)
    u_cr = (delta_h * (2 - delta_h)).sqrt()
    # the double next to u_cr stands for it
    amplitude = arb_series([u_cr if not passed and ball(A) > u_cr else ball(A), 1])
    end = (u_cr / amplitude).asin() if passed else arb_series([arb.pi() / 2])
    # continuous at its end: alpha follows from the rest
    constant = 1 - 2 * beta / (1 - delta_h) if passed else alpha - 2 * beta
    total = arb_series([0 if less_vertical else arb.pi() / 4])
    panels = [*(1 - arb(4) ** -k for k in range(7)), arb(1)]
    for low, high in itertools.pairwise(panels):
        for x, w in gauss(64):
            s = (end * (low + (high - low) * x)).sin()
            beside_vertical = constant + 2 * beta / (1 - (amplitude * s) ** 2).sqrt() - 1
            total += end * ((high - low) * w) * beside_vertical * s**2
    taylor = -4 / arb.pi() * amplitude * total
    ctx.cap = before
    return derivatives(taylor)


def derivatives(taylor: arb_series) -> list:
    """The value and three derivatives from a Taylor series."""
    values = []
    for k in range(4):
        man, exp = (int(part) for part in taylor[k].mid().man_exp())
        values.append(mp.factorial(k) * mp.ldexp(man, exp))
    return values


def ball(x) -> arb:
    """A number of mpmath, exactly."""
    sign, man, exp, _ = mpf(x)._mpf_
    return arb((-int(man) if sign else int(man), int(exp)))


@functools.cache
def family(name: str, passed: int, less_vertical: bool, A, *p):
    """The average and its first three derivatives by A."""
    if name == "rod_spring_untruncated":
        return untruncated_family(passed, less_vertical, A, *p)
    if stated(name):
        value, slope, *rest = harmonic_by_quadrature(name, 1, passed, A, *p)
        return [value + A * less_vertical, slope + less_vertical, *rest]
    taylor = mp.taylor(average(name, p, passed, less_vertical), A, 3)
    return [mp.factorial(k) * c for k, c in enumerate(taylor)]


def harmonic_by_quadrature(name: str, n: int, passed: int, A, *p) -> list:
    """-(1/pi) int_0^{2 pi} f(A cos psi) cos(n psi) dpsi and derivatives, in balls: as `untruncated_family`."""
    before, ctx.cap = ctx.cap, 4
    amplitude = arb_series([ball(A), 1])
    if other := stated(name):
        taylor = harmonic_of_polynomials(other, n, passed, amplitude, [ball(x) for x in p])
        ctx.cap = before
        # what rounding leaves of a zero: a linear piece has no harmonics
        return [value * (not taylor[k].contains(0)) for k, value in enumerate(derivatives(taylor))]
    forces = {
        "duffing": lambda u, q: q[0] * u + q[1] * u**3,
        "rod_spring": lambda u, q: q[0] * u + q[1] * u**3 + q[2] * u**5,
        "rod_spring_untruncated": lambda u, q: (q[0] - 2 * q[1]) * u + 2 * q[1] * u / (1 - u**2).sqrt(),
    }
    q = [ball(x) for x in p]
    if name == "rod_spring_untruncated" and passed:  # continuous at its end
        q[0] = 1 + 2 * q[1] - 2 * q[1] / (1 - q[2])
        q[2] = (q[2] * (2 - q[2])).sqrt()
    end = (q[-1] / amplitude).asin() if passed else arb_series([arb.pi() / 2])
    total = arb_series([0])
    panels = [*(1 - arb(4) ** -k for k in range(7)), arb(1)]
    for low, high in itertools.pairwise(panels):
        for x, w in gauss(64):
            t = end * (low + (high - low) * x)
            u = amplitude * t.sin()
            # u itself, which holds beyond the end, has no higher harmonic over the whole cycle
            total += end * ((high - low) * w) * (forces[name](u, q) - u) * (n * (arb.pi() / 2 - t)).cos()
    taylor = -4 / arb.pi() * total
    ctx.cap = before
    return derivatives(taylor)


def harmonic_of_polynomials(other: Stated, n: int, passed: int, amplitude: arb_series, q: list[arb]) -> arb_series:
    """The same for polynomial pieces, each over its part of the cycle."""
    polynomials, ends = other.polynomials(q), other.pieces(q)[1]
    cuts = [arb_series([0]), *((b / amplitude).asin() for b in ends[:passed]), arb_series([arb.pi() / 2])]
    total = arb_series([0])
    for polynomial, start, end in zip(polynomials, cuts, cuts[1:], strict=False):
        for x, w in gauss(64):
            t = start + (end - start) * x
            u = amplitude * t.sin()
            force = sum((c * u**k for k, c in polynomial.items()), arb_series([0]))
            total += (end - start) * w * force * (n * (arb.pi() / 2 - t)).cos()
    return -4 / arb.pi() * total


def harmonics_table(name: str, amplitudes: Amplitudes) -> list:
    """Both harmonics with their derivatives; the untruncated force's as far as they are derived."""
    rows = []
    for A, p in amplitudes:
        if A == 0 or (name == "rod_spring_untruncated" and scale_of(name, p) > 0.75):
            continue
        passed = passed_by(name, A, p)
        row = entry(lambda *x, n=passed: [v for k in (3, 5) for v in harmonic_by_quadrature(name, k, n, *x)], [A, *p])
        # they act together: the fifth, by far the smaller one at small amplitudes, is measured by the third's scale
        row["scale"] = [max(pair, key=mpf) for pair in zip(row["scale"][:4], row["scale"][4:], strict=True)] * 2
        rows.append(row)
    return rows


def changes_table(name: str, amplitudes: Amplitudes) -> list:
    """How h, h_A and h_AA change with each parameter, at amplitudes of every regime; h and its slopes are given."""
    rows = []
    for A, p in amplitudes:
        if A == 0:
            continue
        passed = passed_by(name, A, p)
        given = [float(value) for value in family(name, passed, False, mpf(A), *map(mpf, p))[:3]]
        rows.append(
            entry(lambda A, h, h_A, h_AA, *q, n=passed: changes(name, n, A, (h, h_A, h_AA), *q), [A, *given, *p])
        )
    return rows


def changes(name: str, passed: int, A, given: Sequence, *p) -> list:
    """By quadratures for parameters on either side. The untruncated force is linear but for what beta multiplies:
    of beta by what that adds to the averages given, which the kernel is a function of.
    """
    found = []
    for k, value in enumerate(p):
        if name == "rod_spring_untruncated" and k == 1:
            rest = [-(1 if passed else p[0]) * linear for linear in (A, 1, 0)]
            found += [(whole - own) / value for whole, own in zip(given, rest, strict=True)]
            continue
        with mp.workdps(200):
            before, ctx.prec = ctx.prec, 600
            step = ASIDE * (abs(value) or 1)
            low, high = (
                harmonic_by_quadrature(name, 1, passed, A, *p[:k], value + side, *p[k + 1 :])[:3]
                for side in (-step, step)
            )
            ctx.prec = before
            # what rounding leaves of a zero
            found += [
                (b - a) / (2 * step) if abs(b - a) > abs(a) * mpf(10) ** -130 else mpf(0)
                for a, b in zip(low, high, strict=True)
            ]
    return found


def second_approximation_table(rng: random.Random) -> dict:
    """Random harmonics, with |h| < 9 A Omega^2; half of the points next to the backbone."""
    table = {}
    orders = ("", "_A", "_AA", "_AAA")
    asked = (("response", "F_0 ", 3), ("folds", "F_0 ", 4), ("detachment", "", 3), ("detachment_by_inertia", "", 3))
    for kernel, forcing, top in asked:
        families = [name + order for name in ("h", "h_3", "h_5") for order in orders[:top]]
        names = f"Omega A {forcing}m zeta".split() + families
        rows = []
        for number in range(12):
            x = {name: rng.uniform(*RANGES[name]) for name in names}
            x["h"] = -x["A"] * x["Omega"] ** 2 * (1 + 1e-6 if number % 2 else rng.uniform(-0.5, 8.0))
            rows.append(entry(second_kernel(kernel), [x[name] for name in names]))
        table[kernel] = rows
    return table


def passed_by(name: str, A: float, p: Sequence[float]) -> int:
    return sum(A > end for end in doubles_at_ends(name, p))


def doubles_at_ends(name: str, p: Sequence[float]) -> list[float]:
    """The doubles next to the breakpoints, which stand for them."""
    if name == "rod_spring_untruncated":
        return [math.sqrt(2 * p[2] - p[2] ** 2)]
    return list(map(float, pieces(name, p)[1]))


# --- forces and parameters -------------------------------------------------------------------------------------------


def rod_force(lam, r, delta_h):
    """F_k at k_v = L = 1: lam springs of stiffness r, shortened by delta_h - (1 - sqrt(1 - u^2)), on a tilted rod."""

    def force(u):
        adjacent = mp.sqrt(1 - u**2)
        return -lam * r * (delta_h - (1 - adjacent)) * u / adjacent

    return force


def rod_coefficients(lam, r, delta_h):
    taylor = mp.taylor(rod_force(lam, r, delta_h), 0, 5)
    # the spring is at its free length where the rod has drawn back by delta_h
    u_cr = mp.sqrt((1 - (1 - delta_h)) * (1 + (1 - delta_h)))
    return [1 + taylor[1], taylor[3], taylor[5], u_cr]


def untruncated_coefficients(lam, r, delta_h):
    alpha, beta, *_ = rod_coefficients(lam, r, delta_h)
    return [alpha, beta, delta_h]


# --- Den Hartog ------------------------------------------------------------------------------------------------------


def half_cycle(Omega, A, mu):
    """B, C, p, q of u = mu + V(p cos - q sin)(Omega tau) + B cos tau + C sin tau, from (A, 0) to (-A, 0)."""
    end, V = mp.pi / Omega, 1 / (1 - Omega**2)

    def row(tau):
        return [mp.cos(tau), mp.sin(tau), V * mp.cos(Omega * tau), -V * mp.sin(Omega * tau)]

    def slope(tau):
        return [-mp.sin(tau), mp.cos(tau), -V * Omega * mp.sin(Omega * tau), -V * Omega * mp.cos(Omega * tau)]

    matrix = mp.matrix([row(mpf(0)), slope(mpf(0)), row(end), slope(end)])
    with mp.extradps(30):
        return list(mp.lu_solve(matrix, mp.matrix([A - mu, 0, -A - mu, 0])))


def motion(tau, Omega, A, mu):
    B, C, p, q = half_cycle(Omega, A, mu)
    V = 1 / (1 - Omega**2)
    return mu + V * (p * mp.cos(Omega * tau) - q * mp.sin(Omega * tau)) + B * mp.cos(tau) + C * mp.sin(tau)


def forcing(Omega, A, mu):
    _, _, p, q = half_cycle(Omega, A, mu)
    return mp.hypot(p, q)


def exact_V(Omega):
    """Without friction the forced motion is A = V p."""
    return [1 / half_cycle(Omega, mpf(1), mpf(0))[2]]


def exact_U(Omega):
    return [-half_cycle(Omega, mpf(0), mpf(1))[3] * exact_V(Omega)[0]]


def exact_amplitude(Omega, F_0, mu):
    V, U = exact_V(Omega)[0], exact_U(Omega)[0]
    guess = mp.sqrt(F_0**2 * V**2 - mu**2 * U**2)
    return [mp.findroot(lambda A: forcing(Omega, A, mu) - F_0, guess)]


def exact_bound(Omega, F_0, S):
    """The amplitude at which A = mu S/Omega^2: forcing is proportional to A there."""
    return [F_0 / forcing(Omega, mpf(1), Omega**2 / S)]


def slope_ratio(tau, Omega):
    """u' = -A Omega sin(Omega tau) + mu g: the second share alone, times Omega/sin(Omega tau)."""
    g = mp.diff(lambda t: motion(t, Omega, mpf(0), mpf(1)), tau)
    return [Omega * g / mp.sin(Omega * tau)]


DEN_HARTOG: dict[str, tuple[str, Function]] = {
    "V": ("Omega", exact_V),
    "U": ("Omega", exact_U),
    "S_ratio": ("tau Omega", slope_ratio),
    "amplitude": ("Omega F_0 mu", exact_amplitude),
    "bound": ("Omega F_0 S", exact_bound),
    "motion": ("tau Omega A mu", lambda *x: [motion(*x)]),
}


# --- the equation of motion ------------------------------------------------------------------------------------------


def rates_by_tau(cosine, v, F_0, zeta, friction, f):
    """u' and u'' of (3)."""
    return [v, F_0 * cosine - 2 * zeta * v - friction - f]


def rates_by_theta(cosine, v, Omega, F_0, zeta, friction, f):
    """theta = Omega tau."""
    return [rate / Omega for rate in rates_by_tau(cosine, v, F_0, zeta, friction, f)]


def matrix(f: Callable, at: Sequence) -> list:
    """The derivatives of each of f's two values by each argument, row by row."""

    def by(k, row):
        return mp.diff(lambda x: f(*at[:k], x, *at[k + 1 :])[row], at[k])

    return [by(k, row) for row in (0, 1) for k in range(len(at))]


def push(cosine, F_0, f):
    """The friction that keeps a mass at rest from accelerating."""
    return mp.findroot(lambda friction: rates_by_tau(cosine, 0, F_0, 0, friction, f)[1], mpf(1))


def push_slopes(cosine, sine, F_0, f_u):
    turned = mp.diff(lambda x: push(cosine * mp.cos(x) - sine * mp.sin(x), F_0, 0), 0)
    return [turned, mp.diff(lambda x: push(cosine, F_0, f_u * x), 0), mp.diff(lambda x: push(cosine, x, 0), F_0)]


def rates_by_state(Omega, zeta, f_u):
    return matrix(lambda u, v: rates_by_theta(0, v, Omega, 0, zeta, 0, f_u * u), (mpf(0), mpf(0)))


def rates_by_parameter(cosine, v, Omega, *others):
    return matrix(lambda *x: rates_by_theta(cosine, v, *x), (Omega, *others))


def smoothed(cosine, v, F_0, mu, zeta, left, right, slip, inner, outer):
    force = inner * (left - right) + outer * (1 - left + right)
    return rates_by_tau(cosine, v, F_0, zeta, mu * slip, force)


def smoothed_by_state(mu, zeta, nu, left, right, slip, inner, outer, inner_u, outer_u):
    """By differentiating logistic functions and tanh that have these values."""

    def moved(value, x):
        return 1 / (1 + (1 / value - 1) * mp.exp(-nu * x))

    def rates(u, v):
        steps = moved(left, u), moved(right, u), mp.tanh(mp.atanh(slip) + nu * v)
        return smoothed(0, v, 0, mu, zeta, *steps, inner + inner_u * u, outer + outer_u * u)

    return matrix(rates, (mpf(0), mpf(0)))


def resisting(v, zeta, friction, quadratic):
    """By the derivative of all that resists."""
    whole = 2 * zeta * v + friction + quadratic * v**2
    slope = mp.diff(lambda x: 2 * zeta * x + friction + quadratic * x**2, v)
    return [whole - 2 * zeta * v, slope / 2]


def passed_on(Omega, A_1, F_0, phi):
    """The first harmonic of the force less the acceleration of A_1 cos(theta + phi), by its Fourier integrals."""

    def passed(theta):
        return F_0 * mp.cos(theta) - mp.diff(lambda t: A_1 * mp.cos(t + phi), theta, 2) * Omega**2

    # the trapezoidal rule is exact for harmonics
    angles = [2 * mp.pi * k / 8 for k in range(8)]
    return mp.hypot(*(sum(passed(t) * f(t) for t in angles) / 4 for f in (mp.cos, mp.sin))) / F_0


def of_structural(Omega, eta):
    """By the work of a cycle of amplitude 1: pi eta, and that of a damper 2 zeta u'."""
    cycle = [2 * mp.pi * k / (8 * Omega) for k in range(8)]
    return [mp.pi * eta / sum(2 * mp.diff(lambda t: mp.cos(Omega * t), t) ** 2 * mp.pi / (4 * Omega) for t in cycle)]


def stopping(Omega, A, mu):
    return [mu / abs(mp.diff(lambda t: A * mp.cos(Omega * t), 0, 2))]


def passed_edge(before, after, v):
    """What v is of u that is ahead by d: it meets the edge the earlier, and has what follows it for as long."""

    def later(d):
        tau = mp.findroot(lambda s: d + v * s + before * s**2 / 2, -d / v) if d else mpf(0)
        return v + before * tau - after * tau

    return mp.diff(later, 0)


def turned_round(before, after):
    """What is left of v that is larger by d: it vanishes the later."""
    return mp.diff(lambda d: after * (0 - mp.findroot(lambda s: d + before * s, -d / before)) if d else mpf(0), 0)


def broken_away(after, Omega, by_theta, by_u):
    """What v is of u that is ahead by d: the push is as large as friction at another time."""

    def later(d):
        tau = mp.findroot(lambda s: by_u * d + by_theta * Omega * s, mpf(0)) if d else mpf(0)
        return after * (0 - tau)

    return mp.diff(later, 0)


def falling(order):
    """Time after which what has that derivative, and no lower one, is `far` from where it began."""
    return lambda far, rate: [
        mp.findroot(lambda s: rate * s**order / mp.factorial(order) - far, mp.root(far / rate, order))
    ]


MOTION: dict[str, tuple[str, Function]] = {
    "push": ("cosine F_0 f", lambda *x: [push(*x)]),
    "push_slopes": ("cosine sine F_0 f_u", push_slopes),
    "breakaway": ("F_0 mu f", lambda F_0, mu, f: [mp.findroot(lambda cosine: push(cosine, F_0, f) - mu, mpf(1))]),
    "acceleration": ("cosine v F_0 zeta mu f", lambda *x: [rates_by_tau(*x)[1]]),
    "rates": ("cosine v Omega F_0 zeta mu f", rates_by_theta),
    "rates_by_state": ("Omega zeta f_u", rates_by_state),
    "rates_by_parameter": ("cosine v Omega F_0 zeta mu f", rates_by_parameter),
    "smoothed": ("cosine v F_0 mu zeta left right slip inner outer", smoothed),
    "smoothed_by_state": ("mu zeta nu left right slip inner outer inner_u outer_u", smoothed_by_state),
    "resistance": ("v zeta friction quadratic", resisting),
    "transmissibility": ("Omega A_1 F_0 phi", lambda *x: [passed_on(*x)]),
    "stopping": ("Omega A mu", stopping),
    "structural": ("Omega eta", of_structural),
    "across": ("before after v", lambda *x: [passed_edge(*x)]),
    "turned": ("before after", lambda *x: [turned_round(*x)]),
    "released": ("after Omega by_theta by_u", lambda *x: [broken_away(*x)]),
    "out": ("beyond pull", falling(2)),
    "back": ("beyond growth", falling(3)),
}


# --- the frequencies at an amplitude ---------------------------------------------------------------------------------

ROUGH, FINE = mpf(2) ** -50, mpf(2) ** -98


def halved_slope(Omega, A, m, zeta, h, h_A):
    return slope_of_response(1, Omega, A, m, zeta, h, h_A) / 2


def terms(kind, epsilon, Omega, A, *x):
    """What a quartic's rounding error is measured by, from the sizes of R's terms and the other factor's."""
    *_, m, zeta, h = x[:-1] if kind == "fold" else x
    R, I = balances(Omega, A, m, zeta, h)
    of_R = A * Omega**2 + abs(h)
    if kind == "response":
        return (abs(R) + epsilon * of_R) * of_R + (I + x[0]) ** 2
    h_A = x[-1]
    return (abs(R) + epsilon * of_R) * (Omega**2 + abs(h_A)) + abs(Omega**2 + h_A) * of_R + 2 * zeta * Omega * I


def quartic(kind, epsilon):
    """The value, and that."""
    value = {"response": response, "fold": halved_slope}[kind]
    return lambda *x: [value(*x), terms(kind, epsilon, *x)]


def beside(kind):
    """At Omega + tail; the terms are those at Omega."""
    f = quartic(kind, FINE)
    return lambda Omega, tail, *x: [f(Omega + tail, *x)[0], f(Omega, *x)[1]]


def derivative(kind):
    """p, q and k of k (A w^3 + p w + q), by interpolation of the quartic."""

    def of(A, *x):
        _, c_1, c_2, c_4 = response_quartic(A, 0, *x) if kind == "response" else fold_quartic(A, *x)
        return [A * c_2 / (2 * c_4), A * c_1 / (4 * c_4), 4 * c_4 / A]

    return of


def in_pairs(row: dict) -> dict:
    """p and q as doubles with what they lack; k. The error of what they lack is measured by theirs."""
    values, scales = [], []
    for value, scale in zip(map(mpf, row["is"][:2]), map(mpf, row["scale"][:2]), strict=True):
        high = mpf(float(value))
        values += [high, value - high]
        scales += [scale, mp.ldexp(scale, -53)]
    return row | {
        "is": [*(shown(value) for value in values), row["is"][2]],
        "scale": [*(shown(scale, 6) for scale in scales), row["scale"][2]],
    }


def rise(Omega, A, p, k):
    """Of a quartic whose derivative vanishes at Omega."""
    q = -A * Omega**3 - p * Omega
    value = mp.quad(lambda w: k * (A * w**3 + p * w + q), [0, Omega])
    return [value, k * Omega**2 * (3 * A * Omega**2 / 4 + abs(p) / 2)]


def cubic_discriminant(A, p, p_low, q, q_low):
    """By the roots: A^3 times the squares of their differences; and where it has a double root for q = 0."""
    p, q = p + p_low, q + q_low
    with mp.extradps(40):
        a, b, c = mp.polyroots([A, 0, p, q], maxsteps=500, extraprec=500)
        return [mp.re(A**3 * ((a - b) * (b - c) * (c - a)) ** 2), -4 * p**3]


FREQUENCIES: dict[str, tuple[str, Function]] = {
    "response": ("Omega A F_0 m zeta h", quartic("response", ROUGH)),
    "response_at_0": ("F_0 m h", lambda *x: [response(0, 1, x[0], x[1], 0, x[2]), x[2] ** 2 + (x[1] + x[0]) ** 2]),
    "fold": ("Omega A m zeta h h_A", quartic("fold", ROUGH)),
    "fold_at_0": ("h h_A", lambda h, h_A: [halved_slope(0, mpf(1), 0, 0, h, h_A)]),
    "cubic": ("Omega A p q", lambda w, A, p, q: [A * w**3 + p * w + q]),
    "cubic_slope": ("Omega A p", lambda w, A, p: [mp.diff(lambda v: A * v**3 + p * v, w)]),
    "rise": ("Omega A p k", rise),
    "response_fine": ("Omega A F_0 m zeta h", quartic("response", FINE)),
    "response_beside": ("Omega tail A F_0 m zeta h", beside("response")),
    "response_derivative": ("A m zeta h", derivative("response")),
    "response_exactly_at_0": ("F_0 m h", lambda *x: [response(0, 1, x[0], x[1], 0, x[2])]),
    "fold_fine": ("Omega A m zeta h h_A", quartic("fold", FINE)),
    "fold_beside": ("Omega tail A m zeta h h_A", beside("fold")),
    "fold_derivative": ("A m zeta h h_A", derivative("fold")),
    "cubic_fine": ("Omega A p p_low q q_low", lambda w, A, p, pp, q, qq: [A * w**3 + (p + pp) * w + (q + qq)]),
    "discriminant": ("A p p_low q q_low", cubic_discriminant),
}


def frequencies_table(rng: random.Random) -> dict:
    table = {kernel: [entry(f, x) for x in points(rng, names, 6)] for kernel, (names, f) in FREQUENCIES.items()}
    for kind in ("response", "fold"):
        table[f"{kind}_derivative"] = [in_pairs(row) for row in table[f"{kind}_derivative"]]
    return table


def motion_table(rng: random.Random) -> dict:
    return {kernel: [entry(f, x) for x in points(rng, names, 6)] for kernel, (names, f) in MOTION.items()}


# --- excitation by inertia -------------------------------------------------------------------------------------------


def shaken(Omega, F_0):
    """Amplitude of the force m omega^2 Y of a base, or m_u e omega^2 of an unbalance, made dimensionless."""
    return F_0 * Omega**2


def inertial(Omega, F_0):
    """The same by differentiating the motion of what is thrown to and fro."""
    return -mp.diff(lambda tau: F_0 * mp.cos(Omega * tau), 0, 2)


def shaken_response(Omega, A, F_0, m, zeta, h):
    return response(Omega, A, shaken(Omega, F_0), m, zeta, h)


def shaken_level(Omega, A, m, zeta, h):
    """The excitation at which the response vanishes, found as a root."""
    R, I = balances(Omega, A, m, zeta, h)
    return mp.findroot(lambda F_0: shaken_response(Omega, A, F_0, m, zeta, h), (abs(R) + I) / Omega**2)


def squared_level(Omega, A, m, zeta, h):
    """F is linear in F_0^2, from its values at 0 and 1."""
    at_0, at_1 = (shaken_response(Omega, A, F_0, m, zeta, h) for F_0 in (0, 1))
    return at_0 / (at_0 - at_1)


def shaken_level_slope(Omega, *x, order=1):
    """Omega^5 times the slope of the squared level, or the derivative of that."""
    return mp.diff(lambda w: w**5 * mp.diff(lambda v: squared_level(v, *x), w), Omega, order - 1)


def shaken_slope_of_frequency(Omega, A, m, zeta, *values):
    """dOmega/dA of the states at one excitation, found as roots."""
    h = near(A, values)
    level_here = squared_level(Omega, A, m, zeta, h(A))
    return mp.diff(
        lambda a: mp.findroot(lambda w: squared_level(w, a, m, zeta, h(a)) - level_here, Omega, tol=mpf(10) ** -110), A
    )


def parabola(f):
    """Coefficients of a quadratic, constant first, from its values at 1, 2 and 3."""
    matrix = mp.matrix([[node**k for k in range(3)] for node in (1, 2, 3)])
    with mp.extradps(20):
        return list(mp.lu_solve(matrix, mp.matrix([f(mpf(node)) for node in (1, 2, 3)])))


def shaken_terms(*x):
    """Of the level's slope, which is -4 rest - linear Omega + 4 fall Omega^2."""
    constant, first, second = parabola(lambda w: shaken_level_slope(w, *x))
    return [second / 4, -first, -constant / 4]


def shaken_least(fall, linear, rest):
    with mp.extradps(20):
        return max(mp.polyroots([4 * rest, linear, -4 * fall], maxsteps=200, extraprec=200))


def balanced(x, A, m, zeta, h):
    """Omega; R and I there, with the R for which the level falls no more, at any Omega: the inertia a in a Omega^2 + h.

    The level's slope is linear in a.
    """
    w = 1 / x

    def squared(v, a):
        return (balances(v, a, 0, 0, h)[0] ** 2 + balances(v, A, m, zeta, 0)[1] ** 2) / shaken(v, 1) ** 2

    slopes = [mp.diff(lambda v, a=a: squared(v, a), w) for a in (0, 1)]
    a = slopes[0] / (slopes[0] - slopes[1])
    return w, balances(w, a, 0, 0, h)[0], balances(w, A, m, zeta, 0)[1]


def shaken_peak(x, A, F_0, m, zeta, h, h_A):
    """F_A by differentiation at that R."""
    w, R, I = balanced(x, A, m, zeta, h)
    least = mp.sqrt(R**2 + I**2) / shaken(w, 1)
    return [least - F_0, slope_of_response(1, w, A, m, zeta, R - A * w**2, h_A) / (2 * least * shaken(w, 1) ** 2)]


def shaken_drift(x, A, m, zeta, *values):
    """dOmega/dA where the level's slope over Omega^2 stays: by a root next to it, at amplitudes next to it."""
    h = near(A, values)

    def falls(w, a):
        return shaken_level_slope(w, a, m, zeta, h(a)) / w**2

    stays = falls(1 / x, A)
    return mp.diff(lambda a: mp.findroot(lambda w: falls(w, a) - stays, 1 / x, tol=mpf(10) ** -110), A)


def shaken_isola(x, A, m, zeta, *values):
    """-h F_A/(2 I Omega^3) at that R; its slope along the amplitudes where the level's slope over Omega^2 stays."""
    h, h_A = near(A, values), near(A, values[1:])

    def value(a, y):
        w, R, I = balanced(y, a, m, zeta, h(a))
        return -h(a) * slope_of_response(1, w, a, m, zeta, R - a * w**2, h_A(a)) / (2 * I * w**3)

    def falls(a, y):
        return y**2 * shaken_level_slope(1 / y, a, m, zeta, h(a))

    by_A, by_x = (1, 0), (0, 1)
    value_A, value_x, falls_A, falls_x = (mp.diff(f, (A, x), by) for f in (value, falls) for by in (by_A, by_x))
    return [value(A, x), value_A - value_x * falls_A / falls_x]


def shaken_sense(order, Omega, A, *x):
    """What tells minima from maxima along the fold locus: as for a force, with the level's slope for F_Omega."""
    by_A, F_AOmega = partials([(order, 0), (1, 1)], Omega, A, *x)
    return -shaken_level_slope(Omega, A, *x[:3]) * by_A * F_AOmega


def shaken_hessian(Omega, A, *x):
    """Where F_Omega = 0 the level's slope is Omega F_Omega."""
    F_AA, F_AOmega = partials([(2, 0), (1, 1)], Omega, A, *x)
    F_OmegaOmega = shaken_level_slope(Omega, A, *x[:3], order=2) / Omega
    return mp.det(mp.matrix([[F_AA, F_AOmega], [F_AOmega, F_OmegaOmega]]))


def shaken_bound(A, F_0, zeta, *values):
    """|h| times the least squared level without friction, a parabola in 1/Omega^2, for the h with zeta^2 A = lost |h|;
    less F_0^2 times the actual |h|.
    """
    *values, lost = values
    h = near(A, values)

    def of(a):
        stiff = zeta**2 * a / lost
        constant, first, second = parabola(lambda s: squared_level(1 / mp.sqrt(s), a, 0, zeta, -stiff))
        return stiff * (constant - first**2 / (4 * second)) + F_0**2 * h(a)

    return [of(A), *(mp.diff(of, A, order) for order in (1, 2, 3))]


#: for each kind of answer the conditions beside F = 0, and F's derivatives by (A, Omega) that must not vanish
SHAKEN_ANSWERS: dict[str, tuple[tuple[str, str], list[tuple[int, int]]]] = {
    "state": (("forcing", "frequency"), [(1, 0)]),
    "fold": (("forcing", "F_A"), [(2, 0), (0, 1)]),
    "corner_fold": (("forcing", "breakpoint"), [(0, 1)]),
    "peak": (("forcing", "F_Omega"), [(1, 0), (0, 2)]),
    "cusp": (("F_A", "F_AA"), [(3, 0), (1, 1)]),
    "isola": (("F_A", "F_Omega"), []),
    "corner_top": (("breakpoint", "F_Omega"), [(0, 2)]),
    "corner_end": (("breakpoint", "F_A"), [(1, 1)]),
    "corner_backbone": (("breakpoint", "R"), []),
    "corner_rest": (("breakpoint", "frequency"), []),
}
DERIVATIVES = {"F_A": (1, 0), "F_AA": (2, 0), "F_Omega": (0, 1)}


def shaken_sizes(Omega, A, F_0, m, zeta, *values):
    """F's derivative of an order by (A, Omega), and the sum of its terms without their signs.

    F less the forcing's square has no negative term but those of h: the sum is that of |h|, with the square added.
    """

    def by(order):
        def derivative(sign, values):
            h = near(A, values)
            return mp.diff(
                lambda a, w: response(w, a, 0, m, zeta, h(a)) + sign * shaken(w, F_0) ** 2, (A, Omega), order
            )

        return derivative(-1, values), derivative(1, [abs(value) for value in values])

    return by


def shaken_moves(kind):
    """How an answer moves: the linear system of its conditions, differentiated numerically; then what must not vanish.

    What vanishes at an answer is taken away from F and R, as points drawn are no answers.
    """

    def of(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_p, h_Ap, h_AAp, m_p, zeta_p, *others):
        values = h, h_A, h_AA, h_AAA
        of_A, of_p = near(A, values), near(A, (h_p, h_Ap, h_AAp))

        def both(a, w, p):
            return balances(w, a, m + m_p * p, zeta + zeta_p * p, of_A(a) + of_p(a) * p)

        size = shaken_sizes(Omega, A, F_0, m, zeta, *values)
        return solved_moves(kind, (A, Omega, F_0, mpf(0)), both, shaken, size, *others)

    return of


def solved_moves(kind, at, balanced, force, size, end_p, forcing_p, frequency_p):
    """The moves of one kind of answer at (A, Omega, F_0, 0).

    balanced -- R and I as functions of A, Omega and the parameter; force -- of Omega and F_0
    size     -- what gives F's derivative of an order, and the sum of its terms without their signs
    """
    conditions, pivots = SHAKEN_ANSWERS[kind]
    A, Omega, _, zero = at
    off = balanced(A, Omega, zero)[0] if "R" in conditions else 0

    def both(a, w, p):
        R, I = balanced(a, w, p)
        return R - off, I

    def whole(a, w, f, p):
        R, I = both(a, w, p)
        return R**2 + I**2 - force(w, f) ** 2

    gone = {by: mp.diff(whole, at, (*by, 0, 0)) for name, by in DERIVATIVES.items() if name in conditions}

    def F(a, w, f, p):
        taken = sum(
            value * (a - A) ** i * (w - Omega) ** k / (mp.factorial(i) * mp.factorial(k))
            for (i, k), value in gone.items()
        )
        return whole(a, w, f, p) - taken

    known = {
        "R": lambda a, w, f, p: both(a, w, p)[0],
        "forcing": lambda a, w, f, p: f - forcing_p * p,
        "frequency": lambda a, w, f, p: w - frequency_p * p,
        "breakpoint": lambda a, w, f, p: a - end_p * p,
    }
    rows = []
    for name in ("F", *conditions):
        order, f = (*DERIVATIVES.get(name, (0, 0)), 0, 0), known.get(name, F)
        rows.append([mp.diff(f, at, [n + (k == j) for j, n in enumerate(order)]) for k in range(4)])
    system = mp.matrix([row[:3] for row in rows])
    with mp.extradps(20):
        moved = list(mp.lu_solve(system, mp.matrix([-row[3] for row in rows])))
    factors = [size(order) for order in pivots]
    if kind == "isola":
        second_derivatives = (size(order) for order in ((2, 0), (1, 1), (0, 2)))
        (by_A, A_size), (mixed, mixed_size), (by_Omega, Omega_size) = second_derivatives
        factors = [(by_A * by_Omega - mixed**2, A_size * Omega_size + mixed_size**2)]
    if kind == "corner_backbone":
        factors = [(rows[2][1], abs(rows[2][1]))]
    determinant = mp.fprod(factor for factor, _ in factors)
    if "forcing" not in conditions:
        determinant *= rows[0][2]
    assert mp.almosteq(abs(mp.det(system)), abs(determinant), rel_eps=mpf(10) ** -40)
    return [*moved, *(part for pair in (*factors, *[(mpf(1), mpf(1))] * (2 - len(factors))) for part in pair)]


def shaken_beside(Omega, A, F_0, m, zeta, h, h_A):
    """F_A, F_Omega and R, each with the sum of its terms without their signs."""
    size = shaken_sizes(Omega, A, F_0, m, zeta, h, h_A)
    return [*size((1, 0)), *size((0, 1)), *(balances(Omega, A, 0, 0, value)[0] for value in (h, abs(h)))]


def shaken_moves_of_phase(Omega, A, F_0, m, zeta, h, h_A, h_p, m_p, zeta_p, A_p, Omega_p, F_0_p):
    """Phase and transmissibility along the moves."""

    def at(p):
        w, a, f = Omega + Omega_p * p, A + A_p * p, F_0 + F_0_p * p
        return w, a, f, m + m_p * p, zeta + zeta_p * p, h + (h_p + h_A * A_p) * p

    def turned(p):
        w, a, _, *others = at(p)
        return phase(w, a, *others)

    def passed_on(p):
        w, a, f, *others = at(p)
        return transmissibility(w, a, shaken(w, f), *others)

    return [mp.diff(turned, 0), mp.diff(passed_on, 0)]


def shaken_outer(A, F_0, m, zeta, h):
    """Roots in X = 1/Omega^2 of F over Omega^4 without odd powers of Omega: of the mean over both its signs."""

    def even(X):
        x = mp.sqrt(X)
        return sum(shaken_response(w, A, F_0, m, zeta, h) * x**4 for w in (1 / x, -1 / x)) / 2

    nodes = [mpf(1), mpf(2), mpf(3)]
    square, linear, over = mp.lu_solve(mp.matrix([[X**2, X, 1] for X in nodes]), mp.matrix([even(X) for X in nodes]))
    root = mp.sqrt(linear**2 - 4 * square * over)
    larger = (root - linear) / (2 * square)
    return [larger, -(root + linear) / (2 * square)]


def shaken_share(A, zeta, h):
    """What the least level without friction is short of 4 zeta^2 A^3/|h|."""
    least = shaken_level(1 / shaken_least(*shaken_terms(A, 0, zeta, h)), A, 0, zeta, h)
    return [1 - least**2 * abs(h) / (4 * zeta**2 * A**3)]


SHAKEN_CAUSES = "h_p h_Ap h_AAp m_p zeta_p end_p forcing_p frequency_p"
INERTIA: dict[str, tuple[str, Function]] = {
    "force": ("Omega F_0", lambda *x: [inertial(*x)]),
    "level": ("Omega A m zeta h", lambda *x: [shaken_level(*x)]),
    "F": ("Omega A F_0 m zeta h", lambda *x: [shaken_response(*x)]),
    "level_slope": ("Omega A m zeta h", lambda *x: [shaken_level_slope(*x)]),
    "Omega_A": ("Omega A m zeta h h_A", lambda *x: [shaken_slope_of_frequency(*x)]),
    "terms": ("A m zeta h", shaken_terms),
    "least": ("fall linear rest", lambda *x: [shaken_least(*x)]),
    "peak": ("x A F_0 m zeta h h_A", shaken_peak),
    "isola": ("x A m zeta h h_A h_AA", shaken_isola),
    "level_rise": ("Omega A m zeta h h_A h_AA", lambda *x: [shaken_sense(2, *x)]),
    "cusp_bend": ("Omega A m zeta h h_A h_AA h_AAA", lambda *x: [shaken_sense(3, *x)]),
    "hessian": ("Omega A m zeta h h_A h_AA", lambda *x: [shaken_hessian(*x)]),
    "bound": ("A F_0 zeta h h_A h_AA h_AAA lost", shaken_bound),
    **{
        f"moves_of_{kind}": (f"Omega A F_0 m zeta h h_A h_AA h_AAA {SHAKEN_CAUSES}", shaken_moves(kind))
        for kind in SHAKEN_ANSWERS
    },
    "beside": ("Omega A F_0 m zeta h h_A", shaken_beside),
    "moves_of_phase": ("Omega A F_0 m zeta h h_A h_p m_p zeta_p A_p Omega_p F_0_p", shaken_moves_of_phase),
    "force_slopes": ("Omega F_0", lambda *x: [mp.diff(inertial, x, n) for n in ((1, 0), (0, 1))]),
    "least_Omega_A": ("x A m zeta h h_A", lambda *x: [shaken_drift(*x)]),
    "outer": ("A F_0 m zeta h", shaken_outer),
    "share": ("A zeta h", shaken_share),
    "amplitude": ("Omega force", lambda w, force: [mp.findroot(lambda F_0: inertial(w, F_0) - force, force)]),
    "moves_from": ("F_0 holds", lambda F_0, holds: [mp.findroot(lambda w: inertial(w, F_0) - holds, mpf("0.7"))]),
}


def inertia_table(rng: random.Random) -> dict:
    """Two points of each kernel next to the backbone, as in `slow_flow_table`."""
    table = {}
    for kernel, (names, f) in INERTIA.items():
        chosen = points(rng, names, 6)
        if {"Omega", "A", "h"} <= set(names.split()):
            Omega, A, h = (names.split().index(x) for x in ("Omega", "A", "h"))
            for x in chosen[:2]:
                x[h] = -x[A] * x[Omega] ** 2 * (1 + 1e-9)
        if kernel == "outer":  # with roots, where the quadratic falls at first and where it does not
            for number, x in enumerate(chosen):
                x[3] *= 0.1
                x[4] -= 0.2
                if number % 3 == 2:
                    x[0], x[4] = 0.5 * x[1], -x[4]
        table[kernel] = [entry(f, x) for x in chosen]
    return table


# --- motions off the centre ------------------------------------------------------------------------------------------


#: exponents of a force that is a sum of exponentials in u, whose means are Bessel functions
EXPONENTS = tuple(mpf(k) / 3 for k in (-4, -3, -2, -1, 1, 2, 3, 4))


def force_with(A, c, s):
    """Means over a cycle c(A, B), s(A, B) of a force that has these at (A, 0): c_n = <f^(n)>, s_n = <f^(n) cos psi>."""
    n = len(c)
    known = EXPONENTS[4 - n : 4 + n]
    rows = [[of(kappa * A) * kappa**k for kappa in known] for of in (bessel_0, bessel_1) for k in range(n)]
    share = mp.lu_solve(mp.matrix(rows), mp.matrix([*c, *s]))

    def means(at, B):
        parts = [(part * mp.exp(kappa * B), kappa * at) for part, kappa in zip(share, known, strict=True)]
        return sum(p * bessel_0(x) for p, x in parts), sum(p * bessel_1(x) for p, x in parts)

    return means


def bessel_0(x):
    return mp.besseli(0, x)


def bessel_1(x):
    return mp.besseli(1, x)


def off_averaged(A, *means):
    """h along the balance of the mean, which is solved for B at each amplitude; c_0 itself does not matter."""
    of = force_with(A, (mpf(0), *means[:3]), means[3:])

    def h(at):
        B = mp.findroot(lambda B: of(at, B)[0], mpf(0), tol=mpf(10) ** -100)
        return -2 * of(at, B)[1]

    with mp.workdps(80):
        return [mp.diff(h, A, order) for order in range(4)]


def off_moved(A, c_1, c_2, c_3, s_1, s_2, s_3, *moves):
    """B and h along the balance at each amplitude and each number of the parameter; c_0 and s_0 do not matter."""
    of = force_with(A, (mpf(0), c_1, c_2, c_3), (mpf(0), s_1, s_2, s_3))
    more, load_p = force_with(A, moves[:3], moves[3:6]), moves[6]

    def B(at, p):
        return mp.findroot(lambda B: of(at, B)[0] + p * (more(at, B)[0] - load_p), mpf(0), tol=mpf(10) ** -100)

    def h(at, p):
        return -2 * (of(at, B(at, p))[1] + p * more(at, B(at, p))[1])

    with mp.workdps(80):
        return [mp.diff(B, (A, 0), (0, 1)), *(mp.diff(h, (A, 0), (order, 1)) for order in range(3))]


def off_moved_at_end(side, c_1, s_1, c_0_p, load_p, end_p):
    """The amplitude at which a motion of amplitude 1 about 0 comes to the end of a piece, as that and the mean move."""
    of = force_with(mpf(1), (mpf(0), c_1), (mpf(0), s_1))

    def A(p):
        return mp.findroot(
            lambda at: of(at, side * (1 + p * end_p - at))[0] + p * (c_0_p - load_p), mpf(1), tol=mpf(10) ** -100
        )

    with mp.workdps(80):
        return [mp.diff(A, 0)]


def off_state(Omega, A, F_0, m, zeta, load, c_0, c_1, s_0, s_1):
    of = force_with(A, (c_0, c_1), (s_0, s_1))

    def both(A, B):
        mean, first = of(A, B)
        return mean - load, response(Omega, A, F_0, m, zeta, -2 * first)

    slopes = [mp.diff(lambda *x, k=k: both(*x)[k], (A, 0), order) for k in (0, 1) for order in ((1, 0), (0, 1))]
    return [*both(A, mpf(0)), *slopes]


def off_fold(t, A, F_0, m, zeta, load, c_0, c_1, c_2, s_0, s_1, s_2):
    """R and I by t, A Omega^2 and 2 zeta A Omega from these apart: F_A along the balance, then that they agree."""
    of = force_with(A, (c_0, c_1, c_2), (s_0, s_1, s_2))

    def three(A, B, t):
        mean, first = of(A, B)
        by = [[mp.diff(lambda *x, k=k: of(*x)[k], (A, B), order) for order in ((1, 0), (0, 1))] for k in (0, 1)]
        R, I = 2 * t * F_0 / (1 + t**2), (1 - t**2) * F_0 / (1 + t**2)
        inertia, damping = R + 2 * first, I - m
        half_F_A = R * (inertia / A - 2 * by[1][0]) + I * damping / A
        turns = by[0][1] * half_F_A - by[0][0] * R * -2 * by[1][1]
        agrees = damping**2 - 4 * zeta**2 * A * inertia
        return mean - load, A * turns * (1 + t**2) / F_0, agrees * (1 + t**2) ** 2

    place = A, mpf(0), t
    with mp.workdps(90):
        slopes = [
            mp.diff(lambda *x, k=k: three(*x)[k], place, tuple(int(i == j) for j in range(3)))
            for k in range(3)
            for i in range(3)
        ]
    return [*three(*place), *slopes]


def off_past(A, root, edge, D_0, C, S):
    """The step's share L of c_1, and edge L of s_1, where edge^2 = 1 - (root/A)^2 in the squares."""
    L = D_0 / (mp.pi * root)
    return [(C**2 - S**2 + 2 * L * (C - edge * S) + (L * root / A) ** 2) / (C + L)]


def by_ends(A, c_0, s_0, c_x, c_y, X, Y, c_xx=0, c_yy=0, X_x=0, Y_y=0):
    """A, and the means of a force and of its share in cos psi, by x and y: B + A and B - A move by 2 X and by -2 Y.

    The force is one whose mean changes by each coordinate as given: c_1 +- s_1 and 2 c_2 - s_1/A +- 2 s_2, as
    A <f'' sin^2> is s_1.
    """
    together, apart = c_x / X, c_y / Y
    further, nearer = (c_xx - X_x * together) / X**2, (c_yy - Y_y * apart) / Y**2
    c_1, s_1 = (together - apart) / 2, (together + apart) / 2
    of = force_with(A, (c_0, c_1, (further + nearer + 2 * s_1 / A) / 4), (s_0, s_1, (further - nearer) / 4))

    def at(x, y):
        up, down = X * x + X_x * x**2 / 2, Y * y + Y_y * y**2 / 2
        return A + up + down, *of(A + up + down, up - down)

    return at


def by_each(f, *place):
    """Slopes of each of what f gives, by each of its arguments in turn."""
    orders = [tuple(int(i == k) for i in range(len(place))) for k in range(len(place))]
    return [[mp.diff(lambda *z, k=k: f(*z)[k], place, order) for order in orders] for k in range(len(f(*place)))]


def ended_state(Omega, A, F_0, m, zeta, load, *ends):
    of = by_ends(A, *ends)

    def both(x, y):
        at, mean, first = of(x, y)
        return mean - load, response(Omega, at, F_0, m, zeta, -2 * first)

    return [*both(mpf(0), mpf(0)), *itertools.chain(*by_each(both, mpf(0), mpf(0)))]


def ended_along(A, s_0, c_x, c_y, X, Y):
    """A and h/A along (-c_y, c_x), the latter times A^2/4: what F_A has beside A's own share goes as this times R."""
    of = by_ends(A, mpf(0), s_0, c_x, c_y, X, Y)

    def along(s):
        at, _, first = of(-c_y * s, c_x * s)
        return at, -2 * first / at

    (slope,), (share,) = by_each(along, mpf(0))
    return [slope, A**2 / 4 * share]


def ended_fold(t, A, F_0, m, zeta, load, *rest):
    """As `off_fold`, along the balance by the ends."""
    c_0, s_0, c_x, c_y, c_xx, c_yy, X, Y, X_x, Y_y = rest
    of = by_ends(A, c_0, s_0, c_x, c_y, X, Y, c_xx, c_yy, X_x, Y_y)

    def three(x, y, t):
        at, mean, first = of(x, y)
        by_A, by_mean, by_first = by_each(of, x, y)
        R, I = 2 * t * F_0 / (1 + t**2), (1 - t**2) * F_0 / (1 + t**2)
        inertia, damping = R + 2 * first, I - m
        half = [R * (inertia / at * a - 2 * s) + I * damping / at * a for a, s in zip(by_A, by_first, strict=True)]
        turns = at * (by_mean[0] * half[1] - by_mean[1] * half[0])
        agrees = damping**2 - 4 * zeta**2 * at * inertia
        return mean - load, turns * (1 + t**2) / F_0, agrees * (1 + t**2) ** 2

    with mp.workdps(90):
        return [*three(mpf(0), mpf(0), t), *itertools.chain(*by_each(three, mpf(0), mpf(0), t))]


OFF_CENTRE: dict[str, tuple[str, Function]] = {
    "averaged": ("A c_1 c_2 c_3 s_0 s_1 s_2 s_3", off_averaged),
    "state": ("Omega A F_0 m zeta load c_0 c_1 s_0 s_1", off_state),
    "fold": ("t A F_0 m zeta load c_0 c_1 c_2 s_0 s_1 s_2", off_fold),
    "turns": (
        "t A F_0 m resists s_0",
        lambda t, A, F_0, m, e, s_0: [(F_0 - m) + (F_0 + m) * t**2 - 2 * t * (-2 * s_0 - A * (2 * s_0 / A - 2 * e))],
    ),
    "begin": (
        "A a root angle",
        lambda A, a, r, psi: [1 / (mp.pi * r), psi / mp.pi, a / A / (mp.pi * r), r / (mp.pi * A)],
    ),
    "up": (
        "k A a L_2 L_1 M_2 M_1",
        lambda k, A, a, L_2, L_1, M_2, M_1: [
            ((A**2 - a**2) * L_2 - (2 * k - 1) * a * L_1) / k**2,
            ((A**2 - a**2) * M_2 - (2 * k + 1) * a * M_1 + 2 * A * L_1) / (k + 1) ** 2,
        ],
    ),
    "down": (
        "k A a root L_1 L_k M_1 M_k",
        lambda k, A, a, r, L_1, L_k, M_1, M_k: [
            (k**2 * L_k + (2 * k - 1) * a * L_1) / r**2,
            ((k + 1) ** 2 * M_k + (2 * k + 1) * a * M_1 - 2 * A * L_1) / r**2,
        ],
    ),
    "past": ("A root edge D_0 C_1 S_1", off_past),
    "beside": ("B c_3 s_2", lambda B, c_3, s_2: [(lambda c, s: (c + s) * (c - s) / c)(B**2 * c_3 / 3, B * s_2)]),
    "moved": ("A c_1 c_2 c_3 s_1 s_2 s_3 c_0_p c_1_p c_2_p s_0_p s_1_p s_2_p load_p", off_moved),
    "moved_at_end": ("side c_1 s_1 c_0_p load_p end_p", off_moved_at_end),
    "ended_state": ("Omega A F_0 m zeta load c_0 s_0 c_x c_y X Y", ended_state),
    "ended_along": ("A s_0 c_x c_y X Y", ended_along),
    "ended_fold": ("t A F_0 m zeta load c_0 s_0 c_x c_y c_xx c_yy X Y X_x Y_y", ended_fold),
    "balance_by_phase": (
        "t F_0",  # F_0 exp(i angle), t the tangent of half of what is left to a right angle
        lambda t, F_0: [F_0 * mp.sin(2 * mp.atan(t)), F_0 * mp.cos(2 * mp.atan(t))],
    ),
    "phase": ("R I F_0", lambda R, I, F_0: [R / (F_0 + I)]),
    "turns_by": (
        "t F_0 m intercept",
        lambda t, F_0, m, k: [(1 + t**2) * (F_0 - m * mp.cos(2 * mp.atan(t)) - k * mp.sin(2 * mp.atan(t)))],
    ),
    "fold_phase": (
        "F_0 m intercept least",
        lambda F_0, m, k, least: [(F_0 - m) / (k + mp.sqrt(k**2 - least**2))],
    ),
    "frequency_by_phase": (
        "A R I m zeta h",
        lambda A, R, I, m, zeta, h: [
            mp.findroot(lambda w: balances(w, A, m, zeta, h)[1] - I, mpf(1)),
            mp.findroot(lambda square: balances(mp.sqrt(square), A, m, zeta, h)[0] - R, mpf(1)),
        ],
    ),
    "versine": (
        "k",
        lambda k: [
            mp.beta(k + mpf(3) / 2, mpf(1) / 2) * 2 / mp.beta(k + mpf(1) / 2, mpf(1) / 2),  # of (2 sin^2(psi/2))^k
        ],
    ),
}


def off_centre_table(rng: random.Random) -> dict:
    """The recursion's number counts: 1, 2, ... upwards, 0 and -1 downwards."""
    table = {}
    for kernel, (names, f) in OFF_CENTRE.items():
        chosen = points(rng, names, 5)
        for number, x in enumerate(chosen):
            if names.startswith("k "):
                x[0] = float(number + 1 if kernel == "up" else -(number % 2))
        table[kernel] = [entry(f, x) for x in chosen]
    return table


# --- a force that is known by its values -----------------------------------------------------------------------------


def cut_off(lost, b, order=0):
    """What is lost at b, as the polynomial that acts below it, and its derivatives."""
    return lambda u: sum(
        one * (u - b) ** (k - order) / mp.factorial(k - order) for k, one in enumerate(lost) if k >= order
    )


@functools.cache
def nodes(precision):
    """Gauss's rule for what is a sum of a few sines."""
    return [*zip(*mp.gauss_quadrature(40, "legendre"), strict=True)]


def below_end(A, b, lost, n, order):
    """An integral of a derivative of that over 0 < u < b: sine^order and cos(n psi) stand beside it."""

    end = mp.asin(b / A)
    total = mpf(0)
    for x, weight in nodes(mp.prec):
        t = end * (1 + x) / 2
        s = mp.sin(t)
        total += weight * cut_off(lost, b, order)(A * s) * s**order * (-1) ** ((n - 1) // 2) * mp.sin(n * t)
    return -2 / mp.pi * end * total


def by_end(n, first, last):
    """What is in derivatives of h_n by A beyond the integrals of derivatives."""

    def f(A, b, *lost):
        def whole(a):
            return below_end(a, b, lost, n, 0)

        return [mp.diff(whole, A, k) - below_end(A, b, lost, n, k) for k in range(first, last + 1)]

    return f


def intercept_by_end(A, b, lost_0, lost_1):
    lost = (lost_0, lost_1)
    slope = mp.diff(lambda a: below_end(a, b, lost, 1, 0), A)
    # the integral of f'' has nothing of a straight line; what is at rest is told apart
    return [below_end(A, b, lost, 1, 0) - A * slope + 4 / mp.pi * cut_off(lost, b)(0)]


def on_sine(n, orders=4):
    return lambda s, *f: [-4 / mp.pi * f[k] * s**k * mp.cos(n * mp.acos(s)) for k in range(orders)]


SAMPLED: dict[str, Function] = {
    "at_rest": lambda f: [-4 / mp.pi * mp.quad(lambda t: f * mp.sin(t), [0, mp.pi / 2])],
    "averaged_terms": on_sine(1),
    "averaged_end": by_end(1, 1, 3),
    "intercept_terms": lambda A, s, c, f_uu: [4 / mp.pi * A**2 * f_uu * s * c**2],
    "intercept_end": intercept_by_end,
    "harmonics_terms": lambda *x: on_sine(3)(*x) + on_sine(5)(*x),
    "harmonics_end": lambda *x: by_end(3, 1, 3)(*x) + by_end(5, 1, 3)(*x),
    "bent_terms": lambda s, f, f_uuuu: [-4 / mp.pi * f * s, -4 / mp.pi * f_uuuu * s**5],
    **{
        f"bent_end_{lowest}": lambda A, b, *lost, lowest=lowest: by_end(1, 4, 4)(A, b, *(0,) * lowest, *lost)
        for lowest in range(4)
    },
}


def sampled_table(rng: random.Random) -> dict:
    """Ends beside amplitudes and far below them; forces and losses of any sign."""
    table = {}
    for kernel, f in SAMPLED.items():
        count = {"at_rest": 1, "intercept_terms": 1, "intercept_end": 2, "bent_terms": 2}.get(kernel, 4)
        count = 3 if kernel in ("averaged_end", "harmonics_end") else count
        count = 4 - int(kernel[-1]) if kernel.startswith("bent_end") else count
        rows = []
        for share in (0.05, 0.4, 0.8, 0.99, 0.9999):
            numbers = [rng.uniform(-1, 1) for _ in range(count)]
            A = rng.uniform(0.2, 1.0)
            before = [A, share * A] if "end" in kernel else [share] if kernel.endswith("s") else []
            before = [A, share, rng.uniform(0.1, 0.9)] if kernel == "intercept_terms" else before
            rows.append(entry(f, [*before, *numbers]))
        table[kernel] = rows
    return table


# --- other laws of damping -------------------------------------------------------------------------------------------


def by_work(work, A):
    """The share in I of what does that work in a cycle: I is work/(pi A)."""
    return work / (mp.pi * A)


def quadratic_work(Omega, A, c_2):
    """c_2 u'^2 along the way from A to -A and back, where u'^2 = Omega^2 (A^2 - u^2)."""
    return 2 * mp.quad(lambda u: c_2 * Omega**2 * (A**2 - u**2), [-A, A])


def rest_share(passed):
    """I_0 from the work of friction, on all of the way or on what lies within u_cr, and of structural damping."""

    def share(A, m, eta, u_cr=None):
        way = 4 * (u_cr if passed else A)
        # m = 4 mu/pi; the ellipse of eta u'/Omega over u
        return by_work(m * mp.pi / 4 * way + mp.pi * eta * A**2, A)

    return lambda A, *x: [mp.chop(mp.diff(lambda a: share(a, *x), A, order), mpf(10) ** -45) for order in range(4)]


def by_laws(names, by_inertia=False):
    """F and I of a kernel's arguments, as functions of A and Omega next to these; and R, I where they are given.

    Where R and I are arguments they stand for the values at (Omega, A), and their slopes are those of A Omega^2 + h
    and of I_0 + 2 zeta A Omega + d (A Omega)^2.
    """
    known = names.split()

    def made(*x):
        at = dict(zip(known, x, strict=True))
        Omega, A, zeta, d = (at.get(name, mpf(0)) for name in ("Omega", "A", "zeta", "d"))
        h = near(A, [at.get(f"h{order}", mpf(0)) for order in ("", "_A", "_AA", "_AAA")])
        rest = near(A, [at.get(f"I_0{order}", mpf(0)) for order in ("", "A", "AA", "AAA")])

        def R(a, w):
            return a * w**2 + h(a)

        def I(a, w):  # noqa: E743
            return balances(w, a, rest(a), zeta, 0)[1] + d * (a * w) ** 2

        off_R, off_I = (at[name] - f(A, Omega) if name in at else 0 for name, f in (("R", R), ("I", I)))

        def F(a, w):
            return (
                (R(a, w) + off_R) ** 2 + (I(a, w) + off_I) ** 2 - (at.get("F_0", 0) * (w**2 if by_inertia else 1)) ** 2
            )

        def peak(a, w):
            """F_Omega/(4 a w), in which the I of I_0 counts; with the slopes of R and I themselves."""
            return R(a, w) + off_R + I(a, w) * (zeta / w + d * a)

        def bend(a, w):
            """F_AOmega/(2 w) of the R and I that h and I_0 give."""
            return mp.diff(lambda b, v: R(b, v) ** 2 + I(b, v) ** 2, (a, w), (1, 1)) / (2 * w)

        def least(a, w):
            """-w^5/4 times the slope of (R^2 + I^2)/w^4 by w, in which h and I_0 count; with the slopes of R and I."""
            return (R(a, w) + off_R) * h(a) + (I(a, w) + off_I) * (rest(a) + zeta * a * w)

        return A, Omega, F, I, peak, bend, least

    return made


def dissipated_balance(names, order=0):
    """I, or a derivative of it by A."""
    made = by_laws(names)

    def balance(*x):
        A, Omega, _, I, *_ = made(*x)
        return [mp.diff(lambda a: I(a, Omega), A, order)]

    return balance


def dissipated_slope(order, names, halved=False):
    """One derivative of F, over 2 A if it is halved."""
    made = by_laws(names)

    def slope(*x):
        A, Omega, F, *_ = made(*x)
        return [mp.diff(F, (A, Omega), order) / (2 * A if halved else 1)]

    return slope


def dissipated_system(first, second, names):
    """Two functions, or one, and their slopes."""
    made = by_laws(names, by_inertia="least" in (first, second) or "inertia" in first)
    first = first.removesuffix(" by inertia")

    def system(*x):
        A, Omega, F, _, peak, bend, least = made(*x)
        of = {
            "F": F,
            "F_A": lambda a, w: mp.diff(lambda b: F(b, w), a),
            "F_AA": lambda a, w: mp.diff(lambda b: F(b, w), a, 2),
            "peak": peak,
            "bend": bend,
            "least": least,
        }
        both = [name for name in (first, second) if name]
        values = [of[name](A, Omega) for name in both]
        by = ((1, 0), (0, 1))
        orders = {"F": (0, 0), "F_A": (1, 0), "F_AA": (2, 0)}

        def slope(name, step):
            if name in orders:
                return mp.diff(F, (A, Omega), tuple(a + b for a, b in zip(orders[name], step, strict=True)))
            return mp.diff(of[name], (A, Omega), step)

        return [*values, *(slope(name, step) for name in both for step in by)]

    return system


def quartic_of(half, names):
    """Coefficients of F, or of F_A/2, from their values at five frequencies."""
    made = by_laws("Omega " + names)

    def coefficients(*x):
        def value(w):
            A, _, F, *_ = made(w, *x)
            return mp.diff(lambda a: F(a, w), A) / 2 if half else F(A, w)

        matrix = mp.matrix([[mpf(node) ** k for k in range(5)] for node in range(1, 6)])
        with mp.extradps(20):
            return list(mp.lu_solve(matrix, mp.matrix([value(mpf(node)) for node in range(1, 6)])))

    return coefficients


def dissipated_frequency(names):
    """dOmega/dA of the states at one forcing, found as roots."""
    made = by_laws(names)

    def slope(*x):
        A, Omega, F, *_ = made(*x)
        here = F(A, Omega)
        return [mp.diff(lambda a: mp.findroot(lambda w: F(a, w) - here, Omega, tol=mpf(10) ** -110), A)]

    return slope


def level_of_laws(w, a, rest, zeta, d, h):
    """Of an excitation by inertia."""
    return sum(part**2 for part in law_balances(w, a, rest, zeta, d, h)) / w**4


def level_along(names):
    """The squared level as a function of A and Omega, and where a kernel asks for it."""
    known = names.split()

    def made(*x):
        at = dict(zip(known, x, strict=True))
        A, zeta, d = (at[name] for name in ("A", "zeta", "d"))
        h = near(A, [at.get(f"h{order}", mpf(0)) for order in ("", "_A", "_AA", "_AAA")])
        rest = near(A, [at.get(f"I_0{order}", mpf(0)) for order in ("", "A", "AA", "AAA")])
        return A, at["Omega"], lambda a, w: level_of_laws(w, a, rest(a), zeta, d, h(a))

    return made


def cusp_by_inertia(names):
    """d^2 level^2/dA^2 along F_A = 0 with F_AA = 0, times Omega^5 F_AOmega^2/4."""
    parts = [dissipated_slope(order, names) for order in ((3, 0), (1, 1))]

    def of(*x):
        A, Omega, level = level_along(names)(*x)
        return [-(Omega**5) / 4 * mp.diff(level, (A, Omega), (0, 1)) * mp.fprod(part(*x)[0] for part in parts)]

    return of


def isola_by_inertia(names):
    """As `law_isola`, of what the level's slope leaves where it vanishes."""
    parts = [dissipated_slope(order, names) for order in ((2, 0), (1, 1))]

    def of(*x):
        A, Omega, level = level_along(names)(*x)
        F_AA, F_AOmega = (part(*x)[0] for part in parts)
        bend = mp.diff(lambda w: w**5 * mp.diff(lambda v: level(A, v), w), Omega) / Omega
        determinant = mp.det(mp.matrix([[F_AA, F_AOmega], [F_AOmega, bend]]))
        return [determinant, F_AA * determinant]

    return of


def frequency_by_inertia(names):
    """dOmega/dA of the states at one level."""

    def of(*x):
        A, Omega, level = level_along(names)(*x)
        return [-mp.diff(level, (A, Omega), (1, 0)) / mp.diff(level, (A, Omega), (0, 1))]

    return of


def far_by_inertia(x, A, F_0, I_0, zeta, d, h):
    """The level less F_0, squares; and what its slope is, without what grows with Omega."""
    w, grows = 1 / x, zeta * d * A**3
    slope = mp.diff(lambda v: level_of_laws(v, A, I_0, zeta, d, h), w)
    return [level_of_laws(w, A, I_0, zeta, d, h) - F_0**2, -(w**3) / 4 * slope - w * grows, grows]


def far_balances(x, A, I_0, I_0A, zeta, d, h, h_A):
    """R, R_A, I and I_A over Omega^2 at Omega = 1/x."""
    w, force = 1 / x, near(A, [h, h_A])
    names, of = "Omega A I_0 I_0A zeta d", (w, A, I_0, I_0A, zeta, d)
    of_R = [mp.diff(lambda a: balances(w, a, 0, zeta, force(a))[0], A, order) for order in (0, 1)]
    return [x**2 * one for one in (*of_R, *dissipated_balance(names)(*of), *dissipated_balance(names, 1)(*of))]


def turn_beside(x, A, *damping):
    """F_AOmega/(4 Omega) over Omega^2 at the h and h_A for which R and R_A vanish."""
    w = 1 / x
    slope = dissipated_slope((1, 1), "Omega A I_0 I_0A zeta d h h_A")(w, A, *damping, -A * w**2, -(w**2))
    return [slope[0] / (4 * w) * x**2]


def largest_held(Omega, F_0, m, zeta, eta, d):
    """The amplitude at which I is F_0, as a root."""
    with mp.extradps(20):
        roots = mp.polyroots([d * Omega**2, 2 * zeta * Omega + eta, m - F_0], maxsteps=200, extraprec=200)
        return max(root.real for root in roots)


def law_balances(w, a, rest, zeta, d, h):
    """R and I of any laws, from I_0."""
    R, I = balances(w, a, rest, zeta, h)
    return R, I + d * (a * w) ** 2


def law_moves(kind, force):
    """As `shaken_moves`, under a force, or what takes its place."""

    def of(Omega, A, F_0, *x):
        rest, (zeta, d), h = x[:4], x[4:6], x[6:10]
        h_p, rest_p, (zeta_p, d_p), others = x[10:13], x[13:16], x[16:18], x[18:]
        of_A, of_p, of_rest, of_rest_p = (near(A, values) for values in (h, h_p, rest, rest_p))

        def both(a, w, p):
            return law_balances(
                w, a, of_rest(a) + of_rest_p(a) * p, zeta + zeta_p * p, d + d_p * p, of_A(a) + of_p(a) * p
            )

        size = law_sizes(Omega, A, rest, zeta, d, h, force=lambda w: force(w, F_0))
        return solved_moves(kind, (A, Omega, F_0, mpf(0)), both, force, size, *others)

    return of


def law_sizes(Omega, A, rest, zeta, d, h, force=lambda w: mpf(0)):
    """As `shaken_sizes`: with h and I_0 without their signs no term of F's derivatives is negative but the force's."""

    def by(order):
        def derivative(sign, of_force):
            local, lag = (near(A, [sign(value) for value in values]) for values in (h, rest))

            def both(a, w):
                squares = (part**2 for part in law_balances(w, a, lag(a), zeta, d, local(a)))
                return sum(squares) + of_force * force(w) ** 2

            return mp.diff(both, (A, Omega), order)

        return derivative(mpf, -1), derivative(abs, 1)

    return by


def law_beside(force):
    """F_A, F_Omega and R, each with its size; the force from Omega and F_0."""

    def of(Omega, A, F_0, I_0, I_0A, zeta, d, *h):
        size = law_sizes(Omega, A, (I_0, I_0A), zeta, d, h, lambda w: force(w, F_0))
        return [*size((1, 0)), *size((0, 1)), *(balances(Omega, A, 0, 0, value)[0] for value in (h[0], abs(h[0])))]

    return of


def law_moves_of_phase(force):
    """Phase and transmissibility along the moves, from R, I and h; the force from Omega and F_0."""

    def of(Omega, A, F_0, I_0, I_0A, zeta, d, h, h_A, h_p, I_0p, zeta_p, d_p, A_p, Omega_p, F_0_p):
        def along(p):
            w, a, restoring = Omega + Omega_p * p, A + A_p * p, h + (h_p + h_A * A_p) * p
            rest = I_0 + (I_0p + I_0A * A_p) * p
            return w, *law_balances(w, a, rest, zeta + zeta_p * p, d + d_p * p, restoring), restoring

        def turned(p):
            _, R, I, _ = along(p)
            return mp.arg(mp.mpc(-R, -I))

        def passed_on(p):
            w, _, I, restoring = along(p)
            return mp.hypot(restoring, I) / force(w, F_0 + F_0_p * p)

        return [mp.diff(turned, 0), mp.diff(passed_on, 0)]

    return of


def rest_moves(passed):
    """What m, eta, and where friction ends u_cr do to I_0 and its first derivatives, from the work of each."""
    share = rest_share(passed)

    def of(A, m=1, u_cr=None):
        at = (mpf(m), mpf(1), *([] if u_cr is None else [u_cr]))
        slopes = []
        with mp.workdps(150):
            for k in range(len(at)):
                order = tuple(int(k == j) for j in range(len(at)))
                slopes += [mp.diff(lambda *x, i=i: share(A, *x)[i], at, order) for i in range(3)]
        return [mp.chop(value, tol=mpf(10) ** -45) for value in slopes]

    return of


def law_response(Omega, A, F_0, *others):
    return sum(part**2 for part in law_balances(Omega, A, *others)) - F_0**2


def law_bend(names):
    """d^2 F_0^2/dA^2 along F_A = 0 with F_AA = 0, times F_AOmega^2 over A."""
    parts = [dissipated_slope(order, names) for order in ((0, 1), (3, 0), (1, 1))]
    at = names.split().index("A")
    return lambda *x: [-mp.fprod(part(*x)[0] for part in parts) / x[at]]


def law_isola(names):
    parts = [dissipated_slope(order, names) for order in ((2, 0), (1, 1), (0, 2))]

    def of(*x):
        F_AA, F_AOmega, F_OmegaOmega = (part(*x)[0] for part in parts)
        determinant = mp.det(mp.matrix([[F_AA, F_AOmega], [F_AOmega, F_OmegaOmega]]))
        return [determinant, F_AA * determinant]

    return of


def slope_of_sum(pairs):
    """Of the sum of squares of functions with these values and slopes."""
    return mp.diff(lambda t: sum((value + slope * t) ** 2 for value, slope in pairs), 0)


def vanishing_R(Omega, A, zeta, d, I):
    """R at which R^2 + I^2 is stationary in Omega."""
    by_R, by_I = (mp.diff(lambda w, n=n: law_balances(w, A, 0, zeta, d, 0)[n], Omega) for n in (0, 1))
    return -I * by_I / by_R


def least_slope(A, k, I, I_A):
    def of(R):
        return slope_of_sum(((R, (R - k) / A), (I, I_A))) / 2

    # a parabola in R, by three of its values
    below, at, above = of(k - 1), of(k), of(k + 1)
    return [4 * A * (at - (above - below) ** 2 / (8 * (above - 2 * at + below)))]


def scaled_slope(Omega, h_over_A, h_A, I_over_A, I_A):
    """At A = 2, where h is 2 h_over_A and I is 2 I_over_A."""
    A = mpf(2)
    R, _ = balances(Omega, A, 0, 0, A * h_over_A)
    R_A = mp.diff(lambda a: balances(Omega, a, 0, 0, a * h_A)[0], A)
    return [slope_of_sum(((R, R_A), (A * I_over_A, I_A))) / (2 * A)]


def least_from_rest(Omega, zeta, eta, d, h_AA):
    """The least F_A for I_0 = eta A and k = A^2 h_AA/2, times 4 A over A^2: its first and third coefficient."""

    def whole(A):
        lag = lambda a: law_balances(Omega, a, eta * a, zeta, d, 0)[1]  # noqa: E731
        return least_slope(A, A**2 * h_AA / 2, lag(A), mp.diff(lag, A))[0] / A**2

    # a quadratic in A, by three of its values
    nodes = [mpf(1), mpf(2), mpf(3)]
    found = mp.lu_solve(mp.matrix([[1, A, A**2] for A in nodes]), mp.matrix([whole(A) for A in nodes]))
    return [found[0], found[2]]


LAW_AT, LAW_SLOWER = "Omega A F_0 I_0 I_0A I_0AA I_0AAA zeta d h h_A h_AA h_AAA", "Omega A F_0 I_0 I_0A zeta d h h_A"
LAW_CAUSES = "h_p h_Ap h_AAp I_0p I_0Ap I_0AAp zeta_p d_p end_p forcing_p frequency_p"


def law_gradients(force) -> dict[str, tuple[str, Function]]:
    """Of other laws of damping, for a force from Omega and F_0."""
    return {
        **{f"moves_of_{kind}": (f"{LAW_AT} {LAW_CAUSES}", law_moves(kind, force)) for kind in SHAKEN_ANSWERS},
        "beside": (LAW_SLOWER, law_beside(force)),
        "moves_of_phase": (f"{LAW_SLOWER} h_p I_0p zeta_p d_p A_p Omega_p F_0_p", law_moves_of_phase(force)),
    }


SHAKEN_LAWS = law_gradients(shaken)
DISSIPATION: dict[str, tuple[str, Function]] = {
    "quadratic": ("c_2", lambda c_2: [by_work(quadratic_work(1, 1, c_2), 1)]),
    # |h| is largest where R = -F_0 at the frequency at which quadratic damping takes all of the forcing
    "restoring": ("A F_0 d", lambda A, F_0, d: [F_0 + A * mp.findroot(lambda X: d * A**2 * X - F_0, F_0 / d / A**2)]),
    "at_rest": ("A m eta", rest_share(passed=False)),
    "released": ("A m eta u_cr", rest_share(passed=True)),
    "I": ("Omega A I_0 zeta d", dissipated_balance("Omega A I_0 zeta d")),
    **{
        f"F_{''.join(letters)}": (names, dissipated_slope((letters.count("A"), letters.count("Omega")), names))
        for letters, names in (
            (("A",), "Omega A I_0 I_0A zeta d h h_A"),
            (("A", "A"), "Omega A I_0 I_0A I_0AA zeta d h h_A h_AA"),
            (("Omega",), "Omega A I_0 zeta d h"),
            (("Omega", "Omega"), "Omega A I_0 zeta d h"),
            (("A", "Omega"), "Omega A I_0 I_0A zeta d h h_A"),
            (("A", "Omega", "Omega"), "Omega A I_0 I_0A zeta d h h_A"),
        )
    },
    "Omega_A": (names := "Omega A I_0 I_0A zeta d h h_A", dissipated_frequency(names)),
    "stability": (names, dissipated_slope((1, 0), names, halved=True)),
    "response_quartic": (names := "A I_0 zeta d h", quartic_of(False, names)),
    "fold_quartic": (names := "A I_0 I_0A zeta d h h_A", quartic_of(True, names)),
    "turn_share": ("x A I_0 I_0A zeta d", turn_beside),
    "limit_envelope": ("Omega F_0 m zeta eta d", lambda *x: [largest_held(*x)]),
    **{
        name: (names, dissipated_system(first, second, names))
        for name, first, second, names in (
            ("folds", "F", "F_A", "Omega A F_0 I_0A I_0AA zeta d h_A h_AA R I"),
            ("peaks", "F", "peak", "Omega A F_0 I_0 I_0A zeta d h_A R I"),
            ("cusps", "F_A", "F_AA", "Omega A I_0A I_0AA I_0AAA zeta d h_A h_AA h_AAA R I"),
            ("isolas", "F_A", "peak", "Omega A I_0 I_0A I_0AA zeta d h_A h_AA R I"),
            ("turns", "F_A", "bend", "Omega A I_0 I_0A I_0AA zeta d h h_A h_AA R I"),
            ("rest", "F", "", "Omega A F_0 I_0A zeta d h_A R I"),
            ("stiffness", "F_A", "", "Omega A I_0A I_0AA zeta d h_A h_AA R I"),
        )
    },
    "rest_moves": ("A", rest_moves(passed=False)),
    "released_moves": ("A m u_cr", rest_moves(passed=True)),
    **law_gradients(lambda w, f: f),
    "I_A": ("Omega A I_0A zeta d", dissipated_balance("Omega A I_0A zeta d", 1)),
    "far": ("x A I_0 I_0A zeta d h h_A", far_balances),
    "F": (names := "Omega A F_0 I_0 zeta d h", lambda *x: [law_response(*x)]),
    "cusp_bend": (names := "Omega A I_0 I_0A I_0AA I_0AAA zeta d h h_A h_AA h_AAA", law_bend(names)),
    "isola_bend": (names := "Omega A I_0 I_0A I_0AA zeta d h h_A h_AA", law_isola(names)),
    "F_A_halved": ("R R_A I I_A", lambda R, R_A, I, I_A: [slope_of_sum(((R, R_A), (I, I_A))) / 2]),
    "R_of_response": ("F_0 I", lambda F_0, I: [mp.sqrt(mpf(F_0) ** 2 - mpf(I) ** 2)]),
    "R_of_peak": ("Omega A zeta d I", lambda *x: [vanishing_R(*x)]),
    "R_of_fold": ("Omega h_A I I_A", lambda w, h_A, I, I_A: [-I * I_A / mp.diff(lambda a: a * w**2 + h_A * a, 1)]),
    "h_A_of_turn": ("Omega A R beside", lambda w, A, R, D: [mp.findroot(lambda s: R + A * (w**2 + s) + D, mpf(1))]),
    "least_F_A": ("A k I I_A", least_slope),
    "I_scaled": ("Omega A I_0_over_A zeta d", lambda w, A, r, *laws: [law_balances(w, A, r * A, *laws, 0)[1] / A]),
    "F_A_scaled": ("Omega h_over_A h_A I_over_A I_A", scaled_slope),
    "least_scaled": ("Omega zeta eta d h_AA", least_from_rest),
    "Omega_A_by_inertia": (names := "Omega A I_0 I_0A zeta d h h_A", frequency_by_inertia(names)),
    "far_by_inertia": ("x A F_0 I_0 zeta d h", far_by_inertia),
    "cusp_bend_by_inertia": (
        names := "Omega A I_0 I_0A I_0AA I_0AAA zeta d h h_A h_AA h_AAA",
        cusp_by_inertia(names),
    ),
    "isola_bend_by_inertia": (names := "Omega A I_0 I_0A I_0AA zeta d h h_A h_AA", isola_by_inertia(names)),
    "full_by_inertia": (
        "F_0 d",
        lambda F_0, d: [mp.findroot(lambda a: a**2 + (d * a**2) ** 2 - F_0**2, F_0 / (1 + d * F_0))],
    ),
    "structural_bound": (
        "A F_0 eta h steepest",
        lambda A, F_0, eta, h, s: [
            eta * A * (A - F_0) - F_0 * abs(h),
            mp.diff(lambda a: eta * a * (a - F_0), A) - F_0 * s,
        ],
    ),
    "quadratic_bound": ("F_0 d", lambda F_0, d: [mp.findroot(lambda a: d * a**2 - F_0, mp.sqrt(F_0 / d))]),
    **{
        name: (names, dissipated_system(first, second, names))
        for name, first, second, names in (
            ("folds_by_inertia", "F by inertia", "F_A", "Omega A F_0 I_0A I_0AA zeta d h_A h_AA R I"),
            ("peaks_by_inertia", "F by inertia", "least", "Omega A F_0 I_0 I_0A zeta d h h_A R I"),
            ("isolas_by_inertia", "F_A", "least", "Omega A I_0 I_0A I_0AA zeta d h h_A h_AA R I"),
        )
    },
}


def shaken_laws_table(rng: random.Random) -> dict:
    """Six points of each kernel."""
    return {kernel: [entry(f, x) for x in points(rng, names, 6)] for kernel, (names, f) in SHAKEN_LAWS.items()}


def dissipation_table(rng: random.Random) -> dict:
    """Six points of each kernel; of what leaves at u_cr, beyond that."""
    table = {}
    for kernel, (names, f) in DISSIPATION.items():
        chosen = points(rng, names, 6)
        for x in chosen:
            if kernel.startswith("released"):
                x[0] += x[-1]
            elif kernel == "R_of_response":  # I < F_0
                x[1] *= 0.25
            elif kernel == "R_of_fold":  # Omega^2 + h_A > 0 on boxes too
                x[1] = abs(x[1])
        table[kernel] = [entry(f, x) for x in chosen]
    return table


# --- points ----------------------------------------------------------------------------------------------------------

RANGES = {
    "Omega": (0.3, 2.0),
    "A": (0.01, 1.0),
    "F_0": (0.03, 0.1),
    "m": (0.001, 0.03),
    "mu": (0.001, 0.02),
    "zeta": (0.004, 0.1),
    "h": (-1.0, -0.001),
    "steepest": (0.0, 3.0),
    "h_A": (-2.0, 1.0),
    "h_AA": (-5.0, 5.0),
    "h_AAA": (-20.0, 20.0),
    **{f"{name}_{n}": (-1.0, 1.0) for name in ("s", "c", "L", "M") for n in (0, 2, 3, "k")},
    **{"X": (0.3, 1.5), "Y": (0.3, 1.5), "c_x": (0.1, 1.5), "c_y": (-1.5, 0.5)},
    **{name: (-1.0, 1.0) for name in ("X_x", "Y_y", "c_xx", "c_yy")},
    **{"c_1": (0.2, 1.5), "s_1": (-0.5, 0.5), "L_1": (0.0, 1.0), "M_1": (0.0, 1.0)},
    **{
        "load": (-0.1, 0.1),
        **{f"{name}_{n}_p": (-1.0, 1.0) for name in ("s", "c") for n in range(3)},
        **{"load_p": (-1.0, 1.0), "end_p": (-1.0, 1.0), "side": (0.8, 1.2)},
        "t": (-0.9, 0.9),
        "resists": (-1.0, 1.0),
        "B": (0.01, 0.5),
        "D_0": (0.001, 0.1),
        "edge": (-1.0, 1.0),
        "C_1": (0.2, 1.5),
        "S_1": (-0.5, 0.5),
        "a": (-0.9, 0.9),
        "angle": (0.1, 3.0),
        "k": (1, 5),
    },
    **{
        f"h_{n}{order}": (-size, size)
        for n in (3, 5)
        for order, size in (("", 0.02), ("_A", 0.2), ("_AA", 2.0), ("_AAA", 20.0))
    },
    "S": (0.5, 2.0),
    "root": (-1.0, 1.0),
    "p": (-1.0, 0.1),
    "q": (0.0001, 0.003),
    # k = h - A h_A, in size above F_0 and A |T|
    "intercept": (1.0, 3.0),
    "k_A": (-3.0, 3.0),
    "lacks": (-0.5, 0.5),
    "X": (0.1, 4.0),
    "T": (-0.9, 0.9),
    "R": (0.1, 4.0),
    # 1/Omega, and what the least level of an excitation by inertia follows from
    "x": (0.5, 3.0),
    "fall": (0.001, 1.0),
    "linear": (0.0001, 0.03),
    "rest": (0.001, 1.0),
    "lost": (0.001, 0.5),
    # other laws of damping
    "eta": (0.005, 0.2),
    "c_2": (0.05, 2.0),
    "d": (0.05, 2.0),
    "u_cr": (0.05, 0.5),
    "I": (0.01, 0.1),
    "I_0": (0.005, 0.05),
    "I_A": (-0.2, 0.2),
    "R_A": (-2.0, 2.0),
    "beside": (-0.1, 0.1),
    "h_over_A": (-2.0, 1.0),
    **dict.fromkeys(("I_0_over_A", "I_over_A"), (0.01, 0.5)),
    "A_1": (0.01, 1.0),
    "phi": (-3.1, -0.05),
    "I_0A": (-0.2, 0.2),
    "I_0AA": (-1.0, 1.0),
    "I_0AAA": (-5.0, 5.0),
    **dict.fromkeys(("friction", "quadratic"), (-0.5, 0.5)),
    **dict.fromkeys(("cosine", "sine", "slip"), (-0.99, 0.99)),
    **dict.fromkeys(("v", "f", "inner", "outer"), (-1.0, 1.0)),
    **dict.fromkeys(("f_u", "inner_u", "outer_u"), (-0.5, 2.0)),
    **dict.fromkeys(("left", "right"), (0.01, 0.99)),
    "nu": (10.0, 1000.0),
    **dict.fromkeys(("before", "after", "by_theta", "by_u"), (-1.0, 1.0)),
    **dict.fromkeys(("beyond", "holds", "preload", "force"), (0.001, 0.1)),
    **dict.fromkeys(("pull", "growth"), (0.01, 1.0)),
    "least": (0.03, 0.9),
    **dict.fromkeys(("tail", "p_low", "q_low"), (-1e-21, 1e-21)),
    "k": (0.04, 4.0),
    # what a parameter does, and what an answer does then
    **dict.fromkeys(("h_p", "h_Ap", "m_p", "zeta_p", "end_p", "forcing_p", "frequency_p"), (-1.0, 1.0)),
    **dict.fromkeys(("I_0p", "I_0Ap", "d_p", "A_p", "Omega_p", "F_0_p"), (-1.0, 1.0)),
    "I_0AAp": (-5.0, 5.0),
    "h_AAp": (-5.0, 5.0),
}

TABLE_1 = tuple(float(published.TABLE_1[name]) for name in ("lam", "r", "delta_h"))
DESIGNS = (TABLE_1, (1.0, 0.5, 0.05), (4.0, 4.0, 0.0606), (1.0, 1.0, 0.9), (2.0, 1.5, 0.5), (3.0, 2.0, 1e-6))
STEEP_DESIGNS = (*DESIGNS, (1.0, 0.8, 0.33), (1.0, 1.2, 0.34), (1.0, 1.0, 0.99))
DUFFINGS = ((1.0, 0.3), (0.2, 2.5), (-0.1, 1.0), (1.0, -0.4))


def parameters_of(design: Sequence[float]) -> tuple[float, ...]:
    """Doubles near the isolator's coefficients; as inputs they are exact."""
    return tuple(float(c) for c in rod_coefficients(*map(mpf, design)))


def around(u_cr: float, thorough: bool) -> list[float]:
    """Amplitudes in every regime, on the corner, close above it, and far beyond."""
    factors = [0.0, 1e-8, 0.3, 1 - 1e-9, 1.0, 1 + 1e-12, 1 + 1e-6, 1.05, 1.249, 1.251, 2.0, 30.0]
    if thorough:
        factors += [1e-3, 0.9, 1 + 1e-9, 1.001, 1.5, 3.0, 10.0, 1e4]
    return [u_cr * factor for factor in factors]


def close_to_one(u_cr: float) -> list[float]:
    """Amplitudes about 1, where elliptic integrals change their kind."""
    return [A for A in (0.699, 0.75, 0.99, 1 - 1e-9, 1.0, 1 + 1e-9, 1.1) if A > 0.9 * u_cr]


def points(rng: random.Random, names: str, count: int) -> list[list[float]]:
    return [[rng.uniform(*RANGES[name]) for name in names.split()] for _ in range(count)]


# --- the table -------------------------------------------------------------------------------------------------------


def entry(f: Function, at: Sequence[float], exact: bool = False) -> dict:
    """One row: values, and their scale by a difference quotient in each argument."""
    x = [fmpq(*value.as_integer_ratio()) for value in at] if exact else [mpf(value) for value in at]
    step = EXACT_STEP if exact else STEP
    values = f(*x)
    scales = [abs(value) for value in values]
    for k, value in enumerate(x):
        if value != 0:
            shifted = f(*x[:k], value * (1 + step), *x[k + 1 :])
            scales = [s + abs(b - a) / step for s, a, b in zip(scales, values, shifted, strict=True)]
    return {"at": list(at), "is": [shown(v) for v in values], "scale": [shown(s, 6) for s in scales]}


def shown(value, digits: int = DIGITS) -> str:
    if isinstance(value, fmpq):
        value = mpf(int(value.p)) / int(value.q)
    if value == 0:
        return "0"
    return mp.nstr(value, digits)


def zeroed(f: Function, names: Sequence[str], scene: str) -> Function:
    """The function with the scene's arguments put to zero, whatever is passed for them."""
    gone = [k for k, name in enumerate(names) if name in SCENES[scene]]
    return lambda *x: f(*(value * 0 if k in gone else value for k, value in enumerate(x)))


def slow_flow_table(rng: random.Random, scene: str) -> dict:
    table = {}
    own = OWN.get(scene.removeprefix("_"))
    for name, (names, f) in (SLOW_FLOW if scene else SLOW_FLOW | SLOPES).items():
        if own and name not in own:
            continue
        chosen = points(rng, names, 6)
        if {"Omega", "A", "h"} <= set(names.split()):  # next to the backbone: R is the small difference of two terms
            Omega, A, h = (names.split().index(x) for x in ("Omega", "A", "h"))
            for x in chosen[:2]:
                x[h] = -x[A] * x[Omega] ** 2 * (1 + 1e-9)
        table[name] = [entry(zeroed(f, names.split(), scene), x) for x in chosen]
    names = "A m zeta h"
    table["detachment"] = [
        entry(zeroed(detachment, names.split(), scene), x, exact=True) for x in points(rng, names, 6)
    ]
    for name, (names, f, sign) in (LOCI | (UNDAMPED if "zeta" in SCENES[scene] else DAMPED)).items():
        if own and name not in own:
            continue
        chosen = points(rng, names, 6)
        if sign:
            h_A = names.split().index("h_A")
            for x in chosen:
                x[h_A] = sign * abs(x[h_A])
        if "intercept" in names:
            with_it = [k for k, argument in enumerate(names.split()) if argument in ("intercept", "R")]
            for x in chosen[::2]:
                for k in with_it:
                    x[k] *= -1
        table[name] = [entry(zeroed(f, names.split(), scene), x) for x in chosen]
    for name, (names, f) in ({} if scene else GRADIENTS | BESIDE_FOLDS).items():
        table[name] = [entry(f, x) for x in points(rng, names, 6)]
    return table


def den_hartog_table(rng: random.Random) -> dict:
    frequencies = [0.4, 0.45, 0.55, 0.7, 0.9, 0.999, 1.0 + 1e-9, 1.001, 1.1, 1.5, 2.0, 3.0]
    table = {}
    for name, (names, f) in DEN_HARTOG.items():
        rows = []
        for Omega in frequencies:
            x = {other: rng.uniform(*RANGES[other]) for other in ("A", "F_0", "mu", "S")}
            x["Omega"] = Omega
            # friction small enough for a steady motion; tau in the first half of the half-cycle, where S is attained
            x["mu"] = x["F_0"] * abs(float(exact_V(mpf(Omega))[0] / exact_U(mpf(Omega))[0])) * rng.uniform(0.1, 0.9)
            taus = [1e-6, rng.uniform(0.05, 0.5) * float(mp.pi) / Omega] if "tau" in names else [0.0]
            for x["tau"] in taus:
                rows.append(entry(f, [x[other] for other in names.split()]))
        table[name] = rows
    return table


#: several averages at once, by mechanism where not all have the kernel; and where they hold
TOGETHER = {
    "averaged": ("h", "h_A", "h_AA", "h_AAA"),
    "averaged_2": ("h", "h_A"),
    "averaged_H": ("H", "H_A"),
    "averaged_all": ("h", "h_A", "h_AA", "h_AAA", "H", "H_A", "intercept"),
}


def has(name: str, kernel: str) -> bool:
    """Whether a mechanism has that kernel of several averages: all at once where they are one algorithm."""
    return kernel != "averaged_all" or name == "rod_spring_untruncated"


def family_table(name: str, amplitudes: Amplitudes) -> dict:
    """h, H and their derivatives, singly and together."""
    table: dict[str, list] = {}
    for A, p in amplitudes:
        passed = passed_by(name, A, p)
        values = {}
        for letter, vertical in (("h", False), ("H", True)):
            row = entry(lambda *x, n=passed, v=vertical: family(name, n, v, *x), [A, *p])
            for order, value, scale in zip(("", "_A", "_AA", "_AAA"), row["is"], row["scale"], strict=True):
                values[letter + order] = value, scale
        del values["H_AAA"]

        def add(kernel: str, outputs: Sequence[str], values=values, at=row["at"]) -> None:
            chosen = [values[output] for output in outputs]
            one = {"at": at, "is": [value for value, _ in chosen], "scale": [scale for _, scale in chosen]}
            table.setdefault(kernel, []).append(one)

        for output in values:
            add(output, (output,))

        def intercept(*x, n=passed):
            h, h_A, *_ = family(name, n, False, *x)
            return [h - x[0] * h_A]

        row = entry(intercept, [A, *p])
        values["intercept"] = row["is"][0], row["scale"][0]
        add("intercept", ("intercept",))
        for kernel, outputs in TOGETHER.items():
            if has(name, kernel):
                add(kernel, outputs)
    return table


#: what every mechanism has of the slow flow, and those of it that are functions of less than Omega, A and damping
COMPOSED = ("F", "F_A", "level", "phase", "jacobian", "stability", "transmissibility")
BARE = (
    *("backbone", "limit_envelope", "equivalent_damping"),
    *("response_quartic", "fold_quartic", "peak_cubic", "detachment"),
)


def rational(x) -> fmpq:
    """The number as it is."""
    mantissa, exponent = abs(x).man_exp
    return int(mp.sign(x)) * fmpq(int(mantissa)) * fmpq(2) ** int(exponent)


def detachment_of_reals(*x):
    return [mpf(int(value.p)) / int(value.q) for value in detachment(*map(rational, x))]


def composed_table(rng: random.Random, name: str, amplitudes: Amplitudes) -> dict:
    """The slow flow's functions with the mechanism put in."""
    table: dict[str, list] = {}
    known = {**SLOW_FLOW, "level": LOCI["level"][:2], "detachment": ("A m zeta h", detachment_of_reals)}
    for kernel in (*COMPOSED, *BARE):
        names, f = known[kernel]
        inner = names.split()
        outer = [x for x in ("Omega", "A", "F_0", "mu", "zeta") if x != "F_0" or "F_0" in inner]
        if kernel in BARE:
            outer = ["mu" if x == "m" else x for x in inner if x[0] != "h"]
        of_mechanism = "h" in inner
        for A, p in amplitudes:
            passed = passed_by(name, A, p)

            def composed(*x, inner=inner, outer=outer, f=f, passed=passed):
                given = dict(zip(outer, x, strict=False))
                given["m"] = 4 * given.get("mu", mpf(0)) / mp.pi
                if "h" in inner:
                    averages = family(name, passed, False, given["A"], *x[len(outer) :])
                    given |= zip(("h", "h_A", "h_AA", "h_AAA"), averages, strict=True)
                return f(*(given[argument] for argument in inner))

            x = [A if argument == "A" else rng.uniform(*RANGES[argument]) for argument in outer]
            if kernel == "backbone" and family(name, passed, False, mpf(A), *map(mpf, p))[0] > 0:
                continue
            table.setdefault(kernel, []).append(entry(composed, [*x, *(p if of_mechanism else ())]))
    return table


def resultant_table(rng: random.Random, name: str, parameters: list[tuple[float, ...]]) -> dict:
    table: dict[str, list] = {}
    # the breakpoint does not enter
    count = 2 if name == "duffing" else 3
    for kernel, f, own in (
        ("saddle_node_onset", saddle_node_onset, ["m", "zeta"]),
        ("saddle_nodes", saddle_nodes, ["F_0", "m", "zeta"]),
    ):

        def whole(*x, f=f, kernel=kernel, last=len(own) - 1):  # noqa: B008
            if other := stated(name):
                found = f(fmpq(1), *x[: last + 1], *other.first(x[last + 1 :]))
                # the scale is a convention: that of the kernel
                scale = getattr(importlib.import_module(f"slowflow_kernels.{name}"), kernel)(
                    *(float(v.p) / float(v.q) for v in x)
                )[-1]
                return [fmpq(*float(scale).as_integer_ratio()) * c for c in found]
            used = x[: last + 1 + count]
            return f(LEADING[name, kernel](*used[last:]), *used)

        for p in parameters:
            x = points(rng, " ".join(own), 1)[0]
            table.setdefault(kernel, []).append(entry(whole, [*x, *p], exact=True))
    return table


COEFFICIENTS = {
    "rod_spring": rod_coefficients,
    "rod_spring_untruncated": untruncated_coefficients,
    "duffing": lambda alpha, beta: [alpha, beta],
}


def scale_of(name: str, p: Sequence[float]) -> float:
    """The last breakpoint, or 1 where there is none."""
    ends = doubles_at_ends(name, p)
    return ends[-1] if ends else 1.0


def by_design(name: str, coefficients: Callable, *design) -> list:
    """Derivatives of each parameter, then of each breakpoint, by each number of a design."""

    def all_of(*x):
        parameters = coefficients(*x)
        return [*parameters, *pieces(name, parameters)[1]]

    count = len(all_of(*design))
    orders = [tuple(int(k == n) for n in range(len(design))) for k in range(len(design))]
    return [
        mp.chop(mp.diff(lambda *x, j=j: all_of(*x)[j], design, order), tol=mpf(10) ** -42)
        for j in range(count)
        for order in orders
    ]


def data_table(name: str, designs: Sequence, parameters: list[tuple[float, ...]]) -> dict:
    """Parameters, breakpoints, jumps and the force itself."""
    other = stated(name)
    coefficients = other.coefficients if other else COEFFICIENTS[name]
    # the Duffing's design is its parameters
    given = parameters if name == "duffing" else designs
    table: dict[str, list] = {"coefficients": [entry(lambda *x: coefficients(*x), x) for x in given]}
    table["by_design"] = [entry(functools.partial(by_design, name, coefficients), x) for x in given]
    table["breakpoints"] = [entry(lambda *q: list(pieces(name, q)[1]), p) for p in parameters]

    def jumps(*q):
        forces, ends = joined(name, q)
        return [below(b) - above(b) for below, above, b in zip(forces, forces[1:], ends, strict=False)]

    table["jumps"] = [entry(jumps, p) for p in parameters]
    if name != "rod_spring_untruncated":
        table["steps"] = [entry(functools.partial(steps, name), p) for p in parameters]
    # f(u)/u rises where no coefficient of its slope is negative: all but the first, or what multiplies 1/sqrt(1 - u^2)
    rising = {
        "duffing": lambda *q: q[1:],
        "rod_spring": lambda *q: [*q[1:3], *(-jump for jump in jumps(*q))],
        "rod_spring_untruncated": lambda *q: [2 * q[1]],
    }
    table["hardening"] = [
        entry(lambda *q: [*(other.hardening(q) if other else rising[name](*q))], p) for p in parameters
    ]
    table["force"] = []
    for p in parameters:
        for factor in (-0.9, 1e-6, 0.7, 0.999, -1.2):
            u = factor * scale_of(name, p)
            k = passed_by(name, abs(u), p)
            table["force"].append(entry(lambda v, *q, k=k: [pieces(name, q)[0][k](v)], [u, *p]))
    return table | pieces_table(name, parameters)


def steps(name: str, *q) -> list:
    """The force and its derivatives at 0, what they gain at each end of a piece, and those of the last piece at 0.

    From values of the polynomials at as many points as they need, by the differences' exact interpolation.
    """
    forces, ends = pieces(name, q)
    other = stated(name)
    degree = max(map(max, other.polynomials(q))) if other else {"duffing": 3, "rod_spring": 5}[name]
    gains = [(forces[0], mpf(0))]
    gains += [(lambda u, k=k: forces[k + 1](u) - forces[k](u), end) for k, end in enumerate(ends)]
    found = []
    for gain, at in [*gains, (forces[-1], mpf(0))]:
        nodes = [mpf(j) / 4 for j in range(1, degree + 2)]
        rows = mp.matrix([[node**k / mp.factorial(k) for k in range(degree + 1)] for node in nodes])
        found += list(mp.lu_solve(rows, mp.matrix([gain(at + node) for node in nodes])))
    return [mpf(0) if abs(value) < mpf(10) ** -45 else value for value in found]


def pieces_table(name: str, parameters: list[tuple[float, ...]]) -> dict:
    """Each piece of the force by itself, and its slope."""
    table: dict[str, list] = {}

    def add(kernel: str, f: Callable, u: float, p: Sequence[float]) -> None:
        table.setdefault(kernel, []).append(entry(lambda v, *q: [f(v, q)], [u, *p]))
        slope = entry(lambda v, *q: [mp.diff(lambda x: f(x, q), v)], [u, *p])
        table.setdefault(f"{kernel}_u", []).append(slope)

    for p in parameters:
        count = len(pieces(name, p)[0])
        for k, factors in enumerate([(-0.9, 1e-6, 0.7, 0.999), *[(-1.2, 30.0)] * (count - 1)]):
            for factor in factors:
                u = factor * scale_of(name, p)
                add(f"force_{k + 1}", lambda v, q, k=k: pieces(name, q)[0][k](v), u, p)
    return table


def tables() -> dict[str, Callable[[random.Random], dict]]:
    """How to make the table of each module."""
    made: dict[str, Callable[[random.Random], dict]] = {}
    for scene in SCENES:
        made["slow_flow" + scene] = functools.partial(slow_flow_table, scene=scene)
    made["inertia"] = inertia_table
    made["dissipation"] = dissipation_table
    made["dissipation_by_inertia"] = shaken_laws_table
    made["second_approximation"] = second_approximation_table
    made["frequencies"] = frequencies_table
    made["motion"] = motion_table
    made["off_centre"] = off_centre_table
    made["sampled"] = sampled_table
    made["den_hartog"] = den_hartog_table
    isolators = [parameters_of(design) for design in DESIGNS]
    untruncated = [(*parameters_of(design)[:2], design[-1]) for design in STEEP_DESIGNS]
    ends = {p: scale_of("rod_spring_untruncated", p) for p in untruncated}
    made |= mechanism_tables(
        "rod_spring_untruncated",
        STEEP_DESIGNS,
        untruncated,
        [(A, p) for p, b in ends.items() for A in (*around(b, False), *close_to_one(b))],
        [(A * ends[p], p) for p in untruncated[::2] for A in (0.5, 1.1, 2.2)],
    )
    made |= mechanism_tables(
        "rod_spring",
        DESIGNS,
        isolators,
        [(A, p) for k, p in enumerate(isolators) for A in around(p[-1], k in (0, 4))],
        [(A * p[-1], p) for p in isolators for A in (0.5, 1.1, 2.2)],
    )
    parameters = [(1 + kappa_1, kappa_3) for kappa_1, kappa_3 in DUFFINGS]
    made |= mechanism_tables(
        "duffing",
        DUFFINGS,
        parameters,
        [(A, p) for p in parameters for A in (0.0, 1e-8, 0.1, 0.7, 3.0)],
        [(A, p) for p in parameters for A in (0.1, 0.6)],
    )
    for name in (one.name for one in all_mechanisms() if one.name not in TYPED):
        other = stated(name)
        designs = other.designs()
        parameters = [tuple(float(c) for c in other.coefficients(*map(mpf, design))) for design in designs]
        made |= mechanism_tables(
            name,
            designs,
            parameters,
            [(A, p) for p in parameters for A in around(scale_of(name, p), False)],
            [(A * scale_of(name, p), p) for p in parameters for A in (0.5, 1.1, 2.2)],
        )
    return made


def mechanism_tables(name: str, designs, parameters, amplitudes: Amplitudes, some: Amplitudes) -> dict:
    """The module of a mechanism: its averages at all `amplitudes`, the composed functions at `some`."""

    def table(rng: random.Random) -> dict:
        own = composed_table(rng, name, some)
        if name != "rod_spring_untruncated":  # its average is no polynomial: there is no resultant
            own |= resultant_table(rng, name, parameters)
        own |= family_table(name, amplitudes) | data_table(name, designs, parameters)
        # of some amplitudes in each regime
        return own | {
            "harmonics": harmonics_table(name, amplitudes),
            "by_parameter": changes_table(name, amplitudes[1::3]),
        }

    return {name: table}


def main(only: list[str]) -> None:
    """Makes the table, or anew the modules named."""
    made = tables()
    table = {module: rows for module, rows in json.loads(OUT.read_text()).items() if only and module in made}
    for module, make in made.items():
        if not only or module in only:
            table[module] = make(random.Random(module))
    lines = []
    for module, kernels in table.items():
        inner = []
        for kernel, rows in kernels.items():
            body = ",\n".join("   " + json.dumps(row) for row in rows)
            inner.append(f'  "{kernel}": [\n{body}\n  ]')
        lines.append(f' "{module}": {{\n' + ",\n".join(inner) + "\n }")
    OUT.write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    main(sys.argv[1:])
