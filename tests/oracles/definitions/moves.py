"""How answers move with a parameter: what defines them is solved for parameters on either side."""

from __future__ import annotations

import functools

from mpmath import mp, mpf

from tests.oracles.definitions.along import fold_moves, partials
from tests.oracles.definitions.points import Function
from tests.oracles.definitions.slow_flow import balances, near, phase, response, transmissibility

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
