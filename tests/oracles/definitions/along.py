"""Where curves change along the amplitude. Takes h and its derivatives; returns functions that vanish there."""

from __future__ import annotations

from mpmath import mp, mpf

from tests.oracles.definitions.points import Function
from tests.oracles.definitions.slow_flow import balances, mixed_slope, near, response, slope_of_response


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


def isola_level(Omega, A, m, zeta):
    """At the h, which F_Omega is linear in, that makes it vanish; at no forcing F is the square of that."""

    def F_Omega(h):
        return mp.diff(lambda v: response(v, A, 0, m, zeta, h), Omega)

    at_0, at_1 = F_Omega(mpf(0)), F_Omega(mpf(1))
    return mp.sqrt(response(Omega, A, 0, m, zeta, at_0 / (at_0 - at_1)))


def isola(A, m, zeta, *values):
    """F_Omega/(4 A) where Omega^2 = h_A, and its slope; without the common factor Omega if there is no friction."""
    h, h_A = near(A, values), near(A, values[1:])

    def level_slope(a):
        w = mp.sqrt(h_A(a))
        value = mp.diff(lambda v: response(v, a, 0, m, zeta, h(a)), w) / (4 * a)
        return value if m else value / w

    return [level_slope(A), mp.diff(level_slope, A)]


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
    tangential = -mixed_slope(w, A, m, zeta, *values[:2]) / 2 * half_F_AAA / half_F_AAOmega
    I = balances(w, A, m, zeta, values[0])[1]
    return [half_F_A, by_tangent[0] - A * by_tangent[1], tangential, mp.sqrt(R * (k + A * T) + I**2 - A * half_F_A)]


def turn(Omega, A, m, zeta, h_AA, k):
    """F_A/2 and F_AA/2 by differentiating F, at the slope of R for which F_AOmega, linear in it, vanishes."""

    def at(T):
        return k + A * T - A * Omega**2, T - Omega**2, h_AA

    mixed = [partials([(1, 1)], Omega, A, m, zeta, *at(T))[0] for T in (mpf(0), mpf(1))]
    T = mixed[0] / (mixed[0] - mixed[1])
    return [F / 2 for F in partials([(1, 0), (2, 0)], Omega, A, m, zeta, *at(T))]


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
    """Derivatives of F and F_A by R at constant I; R's tangent over A meets A = 0 at k."""

    def of(order):
        def shifted(y):
            slope_of_R = (R + y - k) / A
            return mp.diff(lambda a: (R + y + slope_of_R * (a - A)) ** 2, A, order)

        return mp.diff(shifted, 0)

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


def isola_at(Omega, A, m, zeta, h_AA):
    """The same with h and h_A for which F_A = F_Omega = 0."""

    def slope(order, *values):
        return partials([order], Omega, A, m, zeta, *values, h_AA)[0]

    h = mp.findroot(lambda h: slope((0, 1), h, 0), (-A * Omega**2, -2 * A * Omega**2))  # both are linear
    return Omega, A, m, zeta, h, mp.findroot(lambda h_A: slope((1, 0), h, h_A), (Omega**2, 2 * Omega**2)), h_AA


def level_rise(*x):
    F_Omega, F_AA, F_AOmega = partials([(0, 1), (2, 0), (1, 1)], *x)
    return -F_Omega * F_AA * F_AOmega


def cusp_bend(Omega, A, zeta, h_AA, h_AAA, T):
    """With h, and then m, in which they are linear, for which F_AA = F_A = 0."""
    if zeta == 0:
        raise ValueError("no m makes F_A = 0")

    def slope(order, m, h):
        return partials([order], Omega, A, m, zeta, h, T - Omega**2, h_AA, h_AAA)[0]

    def root(f, unit):
        return -unit * f(0) / (f(unit) - f(0))

    h = root(lambda h: slope((2, 0), 0, h), T**2 + A * Omega**2)
    m = root(lambda m: slope((1, 0), m, h), 1 / zeta)
    x = (m, zeta, h, T - Omega**2, h_AA, h_AAA)
    F_Omega, F_AAA, F_AOmega = partials([(0, 1), (3, 0), (1, 1)], Omega, A, *x)
    return -F_Omega * F_AAA * F_AOmega / A


def tail(Omega, F_0, m):
    """Of the states of a spring h = A without viscous damping."""
    return mp.findroot(lambda a: response(Omega, a, F_0, m, 0, a), F_0 / Omega**2)


def most_restoring(A, F_0, m, zeta):
    """F_0 + A Omega^2 at the Omega for which damping takes all of the forcing, from its values at 0 and 1."""
    at_0, at_1 = (balances(w, A, m, zeta, 0)[1] for w in (0, 1))
    return F_0 + A * ((F_0 - at_0) / (at_1 - at_0)) ** 2


def isolation(A, F_0, reduction, h):
    """Where the square of the force on the base, h beside the same damping, is less by that share of F_0^2: a root."""
    m, zeta = mpf("0.01"), mpf("0.03")

    def excess(w):
        R, I = balances(w, A, m, zeta, h)
        return mp.sqrt(R**2 + I**2) - mp.sqrt(h**2 + I**2 + reduction * F_0**2)

    return mp.findroot(excess, 1.2 * mp.sqrt((abs(h) + F_0) / A))


def response_at_rest(m, preload):
    """The forcing of a motion of no amplitude."""
    return mp.sqrt(response(mpf(1), mpf(0), 0, m, mpf("0.03"), -preload))


SLOPES: dict[str, tuple[str, Function]] = {
    "Omega_A": ("Omega A m zeta h h_A", lambda *x: [slope_of_frequency(*x)]),
    "level_rise": ("Omega A m zeta h h_A h_AA", lambda *x: [level_rise(*x)]),
    "cusp_bend": ("Omega A zeta h_AA h_AAA T", lambda *x: [cusp_bend(*x)]),
    "isola_bend": ("Omega A m zeta h_AA", lambda *x: [partials([(2, 0)], *(at := isola_at(*x)))[0] * hessian(*at)]),
    "isola_hessian": ("Omega A m zeta h_AA", lambda *x: [hessian(*isola_at(*x))]),
    "most_restoring": ("A F_0 m zeta", lambda *x: [most_restoring(*x)]),
    "least_restoring": ("F_0 m", lambda *x: [mp.sqrt(mp.mpf(x[0]) ** 2 - mp.mpf(x[1]) ** 2)]),
    "tail": ("Omega F_0 m", lambda *x: [tail(*x)]),
    "isolation": ("A F_0 reduction h", lambda *x: [isolation(*x)]),
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
    "isola_level": ("Omega A m zeta", lambda *x: [isola_level(*x)], 0),
    "isola": ("A m zeta h h_A h_AA", isola, 1),
    "fold": ("A F_0 m zeta h h_A intercept k_A", fold, 0),
    "cusps": ("A zeta h h_A h_AA intercept", cusps, 0),
    "cusp_R": ("A zeta h_AA intercept X T", cusp_R, 0),
    "cusp": ("A m zeta h_AA h_AAA intercept X T R root", cusp, 0),
    "cusp_balance": ("A m zeta h intercept X T", cusp_balance, 0),
    "turn": ("Omega A m zeta h_AA intercept", turn, 0),
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
#: what is asked beside a fold
BESIDE_FOLDS: dict[str, tuple[str, Function]] = {
    "fold_moves": ("A intercept R", fold_moves),
    "fold_square": ("Omega A lacks", lambda w, A, y: [w**2 - y / A]),
}
