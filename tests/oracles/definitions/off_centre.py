"""Motions off the centre: means by quadrature over a period, folds by their phase."""

from __future__ import annotations

import itertools
import random

from mpmath import mp, mpf

from tests.oracles.definitions.points import Function, entry, points
from tests.oracles.definitions.slow_flow import balances

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


def off_state(Omega, A, force, I, I_A, load, c_0, c_1, s_0, s_1):
    of, place = force_with(A, (c_0, c_1), (s_0, s_1)), A

    def both(A, B):
        mean, first = of(A, B)
        return mean - load, (A * Omega**2 - 2 * first) ** 2 + (I + I_A * (A - place)) ** 2 - force**2

    slopes = [mp.diff(lambda *x, k=k: both(*x)[k], (A, 0), order) for k in (0, 1) for order in ((1, 0), (0, 1))]
    return [*both(A, mpf(0)), *slopes]


def lag(A, Omega, m, eta, zeta, d):
    """I, its slope by A."""
    return m + eta * A + 2 * zeta * A * Omega + d * (A * Omega) ** 2, eta + 2 * zeta * Omega + 2 * d * A * Omega**2


def off_fold(R, A, F_0, F_2, m, eta, zeta, d, load, c_0, c_1, c_2, s_0, s_1, s_2):
    """The slope of R^2 + I^2 along the balance at the Omega of R, by c_1 A/2; less by c_1 what F is there."""
    of = force_with(A, (c_0, c_1, c_2), (s_0, s_1, s_2))

    def three(A, B, R):
        mean, first = of(A, B)
        by = [[mp.diff(lambda *x, k=k: of(*x)[k], (A, B), order) for order in ((1, 0), (0, 1))] for k in (0, 1)]
        Omega = mp.sqrt((R + 2 * first) / A)
        I, I_A = lag(A, Omega, m, eta, zeta, d)
        F = R**2 + I**2 - (F_0 + F_2 * Omega**2) ** 2
        half_F_A = R * (Omega**2 - 2 * by[1][0]) + I * I_A
        turns = by[0][1] * half_F_A - by[0][0] * R * -2 * by[1][1]
        return mean - load, A * turns - by[0][1] * F, F

    place = A, mpf(0), R
    with mp.workdps(90):
        return [*three(*place), *itertools.chain(*by_each(three, *place))]


def off_fold_by_t(t, A, F_0, m, zeta, load, c_0, c_1, c_2, s_0, s_1, s_2):
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


def ended_state(Omega, A, force, I, I_A, load, *ends):
    of = by_ends(A, *ends)

    def both(x, y):
        at, mean, first = of(x, y)
        return mean - load, (at * Omega**2 - 2 * first) ** 2 + (I + I_A * (at - A)) ** 2 - force**2

    return [*both(mpf(0), mpf(0)), *itertools.chain(*by_each(both, mpf(0), mpf(0)))]


def ended_along(A, s_0, c_x, c_y, X, Y):
    """A and h/A along (-c_y, c_x), the latter times A^2/4: what F_A has beside A's own share goes as this times R."""
    of = by_ends(A, mpf(0), s_0, c_x, c_y, X, Y)

    def along(s):
        at, _, first = of(-c_y * s, c_x * s)
        return at, -2 * first / at

    (slope,), (share,) = by_each(along, mpf(0))
    return [slope, A**2 / 4 * share]


def ended_fold(R, A, F_0, F_2, m, eta, zeta, d, load, *rest):
    """As `off_fold`, along the balance by the ends."""
    c_0, s_0, c_x, c_y, c_xx, c_yy, X, Y, X_x, Y_y = rest
    of = by_ends(A, c_0, s_0, c_x, c_y, X, Y, c_xx, c_yy, X_x, Y_y)

    def three(x, y, R):
        at, mean, first = of(x, y)
        by_A, by_mean, by_first = by_each(of, x, y)
        Omega = mp.sqrt((R + 2 * first) / at)
        I, I_A = lag(at, Omega, m, eta, zeta, d)
        F = R**2 + I**2 - (F_0 + F_2 * Omega**2) ** 2
        half = [R * (Omega**2 * a - 2 * s) + I * I_A * a for a, s in zip(by_A, by_first, strict=True)]
        along = [by_mean[0] * one[1] - by_mean[1] * one[0] for one in (half, by_A)]
        return mean - load, at * along[0] - along[1] * F, F

    with mp.workdps(90):
        return [*three(mpf(0), mpf(0), R), *itertools.chain(*by_each(three, mpf(0), mpf(0), R))]


OFF_CENTRE: dict[str, tuple[str, Function]] = {
    "averaged": ("A c_1 c_2 c_3 s_0 s_1 s_2 s_3", off_averaged),
    "state": ("Omega A force I I_A load c_0 c_1 s_0 s_1", off_state),
    "fold": ("R A F_0 F_2 m eta zeta d load c_0 c_1 c_2 s_0 s_1 s_2", off_fold),
    "fold_by_t": ("t A F_0 m zeta load c_0 c_1 c_2 s_0 s_1 s_2", off_fold_by_t),
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
    "ended_state": ("Omega A force I I_A load c_0 s_0 c_x c_y X Y", ended_state),
    "ended_along": ("A s_0 c_x c_y X Y", ended_along),
    "ended_fold": ("R A F_0 F_2 m eta zeta d load c_0 s_0 c_x c_y c_xx c_yy X Y X_x Y_y", ended_fold),
    "balance_by_phase": (
        "t F_0",  # F_0 exp(i angle), t the tangent of half of what is left to a right angle
        lambda t, F_0: [F_0 * mp.sin(2 * mp.atan(t)), F_0 * mp.cos(2 * mp.atan(t))],
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
            if names.startswith("R A "):  # A Omega^2 = R + 2 s_0
                x[0] += 2.0
        table[kernel] = [entry(f, x) for x in chosen]
    return table
