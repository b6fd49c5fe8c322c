"""Excitation by inertia: a shaking base and a rotating unbalance, by the same routes as a constant force."""

from __future__ import annotations

from mpmath import mp, mpf

from tests.oracles.definitions.laws import Laws, balances, by_arguments, by_laws, linear_root, near, stays
from tests.oracles.definitions.points import Definitions, beside_backbone


def shaken(Omega, F_0):
    """Amplitude of the force m omega^2 Y of a base, or m_u e omega^2 of an unbalance, made dimensionless."""
    return F_0 * Omega**2


def inertial(Omega, F_0):
    """The same by differentiating the motion of what is thrown to and fro."""
    return -mp.diff(lambda tau: F_0 * mp.cos(Omega * tau), 0, 2)


def squared_level(Omega, A, m, zeta, h):
    """The square of the excitation at which the response vanishes."""
    return sum(one**2 for one in balances(Omega, A, m, zeta, h)) / Omega**4


def shaken_isolation(A, F_0, reduction, h):
    """Where the square of the force on the base, h beside the same damping, is less by that share of the force's."""
    m, zeta = mpf("0.01"), mpf("0.03")
    if A**2 <= reduction * F_0**2 or h > 0:
        raise ValueError("there is no such frequency")

    def excess(w):
        R, I = balances(w, A, m, zeta, h)
        return mp.sqrt(R**2 + I**2) - mp.sqrt(h**2 + I**2 + reduction * inertial(w, F_0) ** 2)

    low = mp.sqrt(abs(h) / A)
    high = next(w for w in (low * 2**k for k in range(1, 200)) if excess(w) > 0)
    return mp.findroot(excess, (low, high), solver="anderson")


def parabola(f):
    """Coefficients of a quadratic, constant first, from its values at 1, 2 and 3."""
    matrix = mp.matrix([[node**k for k in range(3)] for node in (1, 2, 3)])
    with mp.extradps(20):
        return list(mp.lu_solve(matrix, mp.matrix([f(mpf(node)) for node in (1, 2, 3)])))


def shaken_terms(at):
    """Of the level's slope, which is -4 rest - linear Omega + 4 fall Omega^2."""
    constant, first, second = parabola(lambda w: Laws({**at, "Omega": w}).fall.value)
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
        return (balances(v, a, 0, 0, h)[0] ** 2 + balances(v, A, m, zeta, 0)[1] ** 2) / v**4

    a = linear_root(lambda a: mp.diff(lambda v: squared(v, a), w))
    return w, balances(w, a, 0, 0, h)[0], balances(w, A, m, zeta, 0)[1]


def slope_at(w, A, m, zeta, R, h_A):
    """F_A where R is that."""
    return Laws({"Omega": w, "A": A, "m": m, "zeta": zeta, "R": R, "h_A": h_A})("F_A")


def shaken_peak(x, A, F_0, m, zeta, h, h_A):
    """F_A by differentiation at that R."""
    w, R, I = balanced(x, A, m, zeta, h)
    least = mp.hypot(R, I) / w**2
    return [least - F_0, slope_at(w, A, m, zeta, R, h_A) / (2 * least * w**4)]


def drift(laws):
    """dOmega/dA where the level's slope over Omega^2 stays."""
    return stays(laws.fall / laws.Omega**2)


def shaken_isola(at):
    """-h F_A/(2 I Omega^3) at that R; its slope along the amplitudes where the level's slope over Omega^2 stays."""
    x, A, m, zeta, *values = at.values()
    h, h_A, turn = near(A, values), near(A, values[1:]), drift(Laws(at))

    def value(t):
        a = A + t
        w, R, I = balanced(x - x**2 * turn * t, a, m, zeta, h(a))
        return -h(a) * slope_at(w, a, m, zeta, R, h_A(a)) / (2 * I * w**3)

    return [value(mpf(0)), mp.diff(value, 0)]


def shaken_isola_apart(x, A, m, zeta, h, k, cubic):
    """The same at amplitudes where R is that: A dR/dA is R - k, and R + 2 h - cubic; each for its part of damping."""
    w, R, I = balanced(x, A, m, zeta, h)
    friction, viscous = (balances(w, A, *only, h)[1] for only in ((m, 0), (0, zeta)))
    drag = friction + viscous / 2
    A_R_A = (friction * (R - k) + viscous / 2 * (R + 2 * h - cubic)) / drag
    h_A = A_R_A / A - w**2
    return [-h * slope_at(w, A, m, zeta, R, h_A) / (2 * I * w**3)]


def shaken_fold_slopes(Omega, A, m, zeta, k):
    """By F_A at three slopes of R, in which it is a quadratic; I by its definition."""

    def half_F_A(T):
        return slope_at(Omega, A, m, zeta, k + A * T, T - Omega**2) / 2

    constant, linear, square = parabola(half_F_A)
    if linear**2 < 4 * square * constant:
        raise ValueError("no fold at such an intercept")
    with mp.extradps(20):
        smaller, larger = sorted(
            (mp.re(T) for T in mp.polyroots([square, linear, constant], 200, extraprec=200)), key=abs
        )
    return [larger, smaller, -(k + A * larger) / balances(Omega, A, m, zeta, 0)[1]]


def fold_force(Omega, A, m, zeta, other):
    """The same of a force."""
    return [mp.hypot(*balances(Omega, A, m, zeta, -A * other - A * Omega**2))]


def shaken_fold_level(Omega, A, m, zeta, other):
    """R is A times the other slope, reversed."""
    return [mp.sqrt(squared_level(Omega, A, m, zeta, -A * other - A * Omega**2))]


def shaken_peak_share(at):
    """By the level's slope at three values of R, in which it is a quadratic."""
    unmoved = at["A"] * at["Omega"] ** 2
    terms = parabola(lambda R: Laws({**at, "h": R - unmoved}).fall.value)
    if terms[1] ** 2 < 4 * terms[0] * terms[2]:
        raise ValueError("no peak at such a frequency")
    with mp.extradps(20):
        R = min((mp.re(R) for R in mp.polyroots(terms[::-1], 200, extraprec=200)), key=abs)
    return -R / Laws(at).I.value


def shaken_Omega_of_share(A, F_0, m, zeta, ratio):
    """As a root, between frequencies at which the level is higher and lower."""

    def excess(w):
        return mp.sqrt(squared_level(w, A, m, zeta, -ratio * balances(w, A, m, zeta, 0)[1] - A * w**2)) - F_0

    low, high = mpf(1), mpf(1)
    while excess(low) < 0:
        low /= 2
    while excess(high) > 0:
        high *= 2
    return [mp.findroot(excess, (low, high), solver="anderson")]


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


def shaken_share(A, zeta, h):
    """What the least level without friction is short of 4 zeta^2 A^3/|h|."""
    if h > 0:
        raise ValueError("without a resonance the level has no least value")
    x = shaken_least(*shaken_terms({"A": A, "zeta": zeta, "h": h}))
    return [1 - squared_level(1 / x, A, 0, zeta, h) * abs(h) / (4 * zeta**2 * A**3)]


INERTIA: Definitions = {
    "force": ("Omega F_0", lambda *x: [inertial(*x)]),
    "level": by_laws("Omega A m zeta h", lambda laws: mp.sqrt(laws.level.value)),
    "F": by_laws("Omega A F_0 m zeta h", lambda laws: laws("F"), by_inertia=True),
    "level_slope": by_laws("Omega A m zeta h", lambda laws: laws.fall.value),
    "Omega_A": by_laws("Omega A m zeta h h_A", lambda laws: stays(laws.level)),
    "terms": by_arguments("A m zeta h", shaken_terms),
    "least": ("fall linear rest", lambda *x: [shaken_least(*x)]),
    "peak": ("x A F_0 m zeta h h_A", shaken_peak),
    "isola": by_arguments("x A m zeta h h_A h_AA", shaken_isola),
    "isola_apart": ("x A m zeta h intercept cubic", shaken_isola_apart),
    "fold_slopes": ("Omega A m zeta intercept", shaken_fold_slopes),
    "fold_force": ("Omega A m zeta other", fold_force),
    "fold_level": ("Omega A m zeta other", shaken_fold_level),
    "peak_share": by_arguments("Omega A m zeta", shaken_peak_share),
    "Omega_of_share": ("A F_0 m zeta share", shaken_Omega_of_share),
    # what tells minima from maxima of the fold locus: as for a force, with the level's slope for F_Omega
    "cusp_bend": by_laws(
        "Omega A m zeta h h_A h_AA h_AAA", lambda laws: -laws.fall.value * laws("F_AAA") * laws("F_AOmega")
    ),
    "hessian": by_laws("Omega A m zeta h h_A h_AA", lambda laws: laws.fall_hessian),
    "bound": ("A F_0 zeta h h_A h_AA h_AAA lost", shaken_bound),
    "force_slopes": ("Omega F_0", lambda *x: [mp.diff(inertial, x, n) for n in ((1, 0), (0, 1))]),
    "least_Omega_A": by_laws("x A m zeta h h_A", drift),
    "share": ("A zeta h", shaken_share),
    "amplitude": ("Omega force", lambda w, force: [mp.findroot(lambda F_0: inertial(w, F_0) - force, force)]),
    "moves_from": ("F_0 holds", lambda F_0, holds: [mp.findroot(lambda w: inertial(w, F_0) - holds, mpf("0.7"))]),
    "isolation": ("A F_0 reduction h", lambda *x: [shaken_isolation(*x)]),
}


def place(kernel: str, names: list[str], number: int, x: list[float]) -> None:
    """Some next to the backbone; amplitudes above F_0."""
    beside_backbone(names, number, x)
    if kernel == "isolation":
        x[0] += x[1]
