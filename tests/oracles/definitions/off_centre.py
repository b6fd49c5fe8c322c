"""Motions off the centre: means over a period of a polynomial that has the given ones, folds by their phase."""

from __future__ import annotations

import functools
import itertools
import math
import operator

from mpmath import mp, mpf

from tests.oracles.definitions.laws import balances
from tests.oracles.definitions.points import RANGES, Definitions
from tests.oracles.definitions.series import stated, variables


def mean_of_power(n):
    """Of cos(psi)^n over a cycle."""
    return mpf(0) if n % 2 else mpf(math.comb(n, n // 2)) / 2**n


@functools.cache
def shares(n, precision):
    """The 2 n terms of a polynomial in u/A by its means at (A, 0), those of its derivatives times as many A."""
    rows = [
        [math.perm(j, k) * mean_of_power(j - k + first) if j >= k else mpf(0) for j in range(2 * n)]
        for first in (0, 1)
        for k in range(n)
    ]
    with mp.workprec(precision + 40):
        return (mp.matrix(rows) ** -1).tolist()


def powers(x, count):
    """x^0 and those after it."""
    return [x**0, *itertools.accumulate([x] * (count - 1), operator.mul)]


def force_with(A, c, s):
    """Means over a cycle c(A, B), s(A, B) of a force that has these at (A, 0): c_n = <f^(n)>, s_n = <f^(n) cos psi>."""
    n = len(c)
    scaled = [value * A**k for values in (c, s) for k, value in enumerate(values)]
    terms = [mp.fdot(row, scaled) for row in shares(n, mp.prec)]

    def means(at):
        """By powers of B, each (B + at cos psi)^j by the binomial theorem."""
        sizes = powers(at / A, 2 * n)

        def of(first, k):
            return sum(
                sizes[j - k] * (term * math.comb(j, k) * mean_of_power(j - k + first) / A**k)
                for j, term in enumerate(terms)
                if j >= k and (j - k + first) % 2 == 0
            )

        return tuple([of(first, k) for k in range(2 * n)] for first in (0, 1))

    return means


def at_mean(by_powers, B):
    """A mean at B."""
    return functools.reduce(lambda found, one: found * B + one, reversed(by_powers))


def means_with(A, c, s, at, B):
    """c and s at (at, B)."""
    return tuple(at_mean(one, B) for one in force_with(A, c, s)(at))


def balanced(excess, slope, like, order):
    """The number near 0, as a series, at which what has about that slope there vanishes: an order more each time."""
    found = like * 0
    for _ in range(order + 1):
        found = found - excess(found) / slope
    return found


def off_averaged(A, *means):
    """h along the balance of the mean, which is solved for B at each amplitude; c_0 itself does not matter."""
    (at,) = variables((A,), 3)
    mean, first = force_with(A, (mpf(0), *means[:3]), means[3:])(at)
    h = -2 * at_mean(first, balanced(lambda B: at_mean(mean, B), means[0], at, 3))
    return [h.derivative(order) for order in range(4)]


def off_moved(A, c_1, c_2, c_3, s_1, s_2, s_3, *changes):
    """B and h along the balance at each amplitude and each number of the parameter; c_0 and s_0 do not matter."""
    at, p = variables((A, 0), 3)
    both = zip(
        force_with(A, (mpf(0), c_1, c_2, c_3), (mpf(0), s_1, s_2, s_3))(at),
        [[*more, 0, 0] for more in force_with(A, changes[:3], changes[3:6])(at)],
        strict=True,
    )
    mean, first = ([one + p * more for one, more in zip(*pair, strict=True)] for pair in both)
    mean[0] -= p * changes[6]
    B = balanced(lambda B: at_mean(mean, B), c_1, at, 3)
    h = -2 * at_mean(first, B)
    return [B.derivative(0, 1), *(h.derivative(order, 1) for order in range(3))]


def off_moved_at_end(side, c_1, s_1, c_0_p, load_p, end_p):
    """The amplitude at which a motion of amplitude 1 about 0 comes to the end of a piece, as that and the mean move."""
    (p,) = variables((0,), 1)

    def excess(beyond):
        place = 1 + beyond, side * (p * end_p - beyond)
        return means_with(mpf(1), (mpf(0), c_1), (mpf(0), s_1), *place)[0] + p * (c_0_p - load_p)

    return [balanced(excess, s_1 - side * c_1, p, 1).derivative(1)]


def off_state(Omega, A, force, I, I_A, load, c_0, c_1, s_0, s_1):
    at, B = variables((A, 0), 1)
    mean, first = means_with(A, (c_0, c_1), (s_0, s_1), at, B)
    return stated(mean - load, (at * Omega**2 - 2 * first) ** 2 + (I + I_A * (at - A)) ** 2 - force**2)


def lag(A, Omega, m, eta, zeta, d):
    """I, its slope by A."""
    return m + eta * A + 2 * zeta * A * Omega + d * (A * Omega) ** 2, eta + 2 * zeta * Omega + 2 * d * A * Omega**2


def off_fold(R, A, F_0, F_2, m, eta, zeta, d, load, c_0, c_1, c_2, s_0, s_1, s_2):
    """The slope of R^2 + I^2 along the balance at the Omega of R, by c_1 A/2; less by c_1 what F is there."""
    at, B, R = variables((A, 0, R), 2)
    mean, first = means_with(A, (c_0, c_1, c_2), (s_0, s_1, s_2), at, B)
    Omega = ((R + 2 * first) / at).sqrt()
    I, I_A = lag(at, Omega, m, eta, zeta, d)
    F = R**2 + I**2 - (F_0 + F_2 * Omega**2) ** 2
    half_F_A = R * (Omega**2 - 2 * first.by(0)) + I * I_A
    turns = mean.by(1) * half_F_A - mean.by(0) * R * -2 * first.by(1)
    return stated(mean - load, at * turns - mean.by(1) * F, F)


def by_ends(A, c_0, s_0, c_x, c_y, X, Y, c_xx=0, c_yy=0, X_x=0, Y_y=0):
    """A, and the means of a force and of its share in cos psi, by x and y: B + A and B - A move by 2 X and by -2 Y.

    The force is one whose mean changes by each coordinate as given: c_1 +- s_1 and 2 c_2 - s_1/A +- 2 s_2, as
    A <f'' sin^2> is s_1.
    """
    together, apart = c_x / X, c_y / Y
    further, nearer = (c_xx - X_x * together) / X**2, (c_yy - Y_y * apart) / Y**2
    c_1, s_1 = (together - apart) / 2, (together + apart) / 2
    of = (c_0, c_1, (further + nearer + 2 * s_1 / A) / 4), (s_0, s_1, (further - nearer) / 4)

    def at(x, y):
        up, down = X * x + X_x * x**2 / 2, Y * y + Y_y * y**2 / 2
        return A + up + down, *means_with(A, *of, A + up + down, up - down)

    return at


def ended_state(Omega, A, force, I, I_A, load, *ends):
    at, mean, first = by_ends(A, *ends)(*variables((0, 0), 1))
    return stated(mean - load, (at * Omega**2 - 2 * first) ** 2 + (I + I_A * (at - A)) ** 2 - force**2)


def ended_along(A, s_0, c_x, c_y, X, Y):
    """A and h/A along (-c_y, c_x), the latter times A^2/4: what F_A has beside A's own share goes as this times R."""
    (s,) = variables((0,), 1)
    at, _, first = by_ends(A, mpf(0), s_0, c_x, c_y, X, Y)(-c_y * s, c_x * s)
    return [at.derivative(1), A**2 / 4 * (-2 * first / at).derivative(1)]


def ended_slopes(A, s_0, c_x, c_y, X, Y):
    """Of s_0 by x and by y, and of c_x by y: the force has these at (A, 0), and A and B move with both ends."""
    B = mpf(0)
    c_1, s_1 = (c_x / X - c_y / Y) / 2, (c_x / X + c_y / Y) / 2
    means = force_with(A, (B, c_1), (s_0, s_1))

    def at(x, y):
        return A + X * x + Y * y, X * x - Y * y

    def first(x, y):
        radius, middle = at(x, y)
        return mp.fdot(means(radius)[1], powers(middle, len(means(radius)[1]))) if middle else means(radius)[1][0]

    def mean(x, y):
        radius, middle = at(x, y)
        return mp.fdot(means(radius)[0], powers(middle, len(means(radius)[0]))) if middle else means(radius)[0][0]

    return [
        mp.diff(first, (0, 0), (1, 0)),
        mp.diff(first, (0, 0), (0, 1)),
        mp.diff(mean, (0, 0), (1, 1)),
    ]


def ended_fold(R, A, F_0, F_2, m, eta, zeta, d, load, *rest):
    """As `off_fold`, along the balance by the ends."""
    c_0, s_0, c_x, c_y, c_xx, c_yy, X, Y, X_x, Y_y = rest
    x, y, R = variables((0, 0, R), 2)
    at, mean, first = by_ends(A, c_0, s_0, c_x, c_y, X, Y, c_xx, c_yy, X_x, Y_y)(x, y)
    Omega = ((R + 2 * first) / at).sqrt()
    I, I_A = lag(at, Omega, m, eta, zeta, d)
    F = R**2 + I**2 - (F_0 + F_2 * Omega**2) ** 2
    half = [R * (Omega**2 * at.by(k) - 2 * first.by(k)) + I * I_A * at.by(k) for k in (0, 1)]
    tangential = [mean.by(0) * one[1] - mean.by(1) * one[0] for one in (half, [at.by(0), at.by(1)])]
    return stated(mean - load, at * tangential[0] - tangential[1] * F, F)


OFF_CENTRE: Definitions = {
    "averaged": ("A c_1 c_2 c_3 s_0 s_1 s_2 s_3", off_averaged),
    "state": ("Omega A force I I_A load c_0 c_1 s_0 s_1", off_state),
    "fold": ("R A F_0 F_2 m eta zeta d load c_0 c_1 c_2 s_0 s_1 s_2", off_fold),
    "begin": (
        "A a root angle",
        lambda A, a, r, psi: [1 / (mp.pi * r), psi / mp.pi, a / A / (mp.pi * r), r / (mp.pi * A)],
    ),
    "up": (
        "k A a span L_2 L_1 M_2 M_1",
        lambda k, A, a, span, L_2, L_1, M_2, M_1: [
            (span * L_2 - (2 * k - 1) * a * L_1) / k**2,
            (span * M_2 - (2 * k + 1) * a * M_1 + 2 * A * L_1) / (k + 1) ** 2,
        ],
    ),
    "down": (
        "k A a root L_1 L_k M_1 M_k",
        lambda k, A, a, r, L_1, L_k, M_1, M_k: [
            (k**2 * L_k + (2 * k - 1) * a * L_1) / r**2,
            ((k + 1) ** 2 * M_k + (2 * k + 1) * a * M_1 - 2 * A * L_1) / r**2,
        ],
    ),
    "beside": ("B c_3 s_2", lambda B, c_3, s_2: [(lambda c, s: (c + s) * (c - s) / c)(B**2 * c_3 / 3, B * s_2)]),
    "moved": ("A c_1 c_2 c_3 s_1 s_2 s_3 c_0_p c_1_p c_2_p s_0_p s_1_p s_2_p load_p", off_moved),
    "moved_at_end": ("side c_1 s_1 c_0_p load_p end_p", off_moved_at_end),
    "ended_state": ("Omega A force I I_A load c_0 s_0 c_x c_y X Y", ended_state),
    "ended_along": ("A s_0 c_x c_y X Y", ended_along),
    "ended_slopes": ("A s_0 c_x c_y X Y", ended_slopes),
    "ended_fold": ("R A F_0 F_2 m eta zeta d load c_0 s_0 c_x c_y c_xx c_yy X Y X_x Y_y", ended_fold),
    "frequency_by_phase": (
        "A R I m zeta h",
        lambda A, R, I, m, zeta, h: [
            mp.findroot(lambda w: balances(w, A, m, zeta, h)[1] - I, mpf(1)),
            mp.findroot(lambda square: balances(mp.sqrt(square), A, m, zeta, h)[0] - R, mpf(1)),
        ],
    ),
}


#: a mean's third derivative has the name of a law of damping
BETWEEN = {**RANGES, "c_3": (-1.0, 1.0)}


def place(kernel: str, names: list[str], number: int, x: list[float]) -> None:
    """The recursion's number counts: 1, 2, ... upwards, 0 and -1 downwards; and A Omega^2 = R + 2 s_0."""
    if names[0] == "k" and len(names) > 1:
        x[0] = float(number + 1 if kernel == "up" else -(number % 2))
    if names[:2] == ["R", "A"]:
        x[0] += 2.0
