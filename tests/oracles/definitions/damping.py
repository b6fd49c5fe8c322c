"""Other laws of damping than viscous and Coulomb: what they put into R and I, by quadrature and differentiation."""

from __future__ import annotations

import itertools

from mpmath import mp, mpf

from tests.oracles.definitions.along import static_halves
from tests.oracles.definitions.laws import (
    TINY,
    Laws,
    by_arguments,
    by_laws,
    derivative,
    polynomial,
    stays,
    with_zeros,
)
from tests.oracles.definitions.points import Definitions
from tests.oracles.definitions.series import variables


def by_work(work, A):
    """The share in I of what does that work in a cycle: I is work/(pi A)."""
    return work / (mp.pi * A)


def power_work(c, power):
    """That of c |u'|^power at A = Omega = 1, along the way from 1 to -1 and back, where u'^2 = 1 - u^2."""
    return 2 * mp.quad(lambda u: c * (1 - u**2) ** (mpf(power) / 2), [-1, 1])


def viscous_ratio(A, zeta, zeta_2):
    """The work of 2 (zeta + zeta_2 u^2) u' in a cycle over that of 2 u', and three derivatives by A."""
    (a,) = variables((A,), 3)
    of_zeta, of_zeta_2 = (mp.quad(lambda s, n=n: s**n * mp.sqrt(1 - s**2), [-1, 1]) for n in (0, 2))
    ratio = zeta + zeta_2 * a**2 * (of_zeta_2 / of_zeta)
    return [mp.chop(ratio.derivative(order), TINY) for order in range(4)]


def rest_of(A, m, eta, u_cr=None):
    """I_0 from the work of friction, on all of the way or on what lies within u_cr, and of structural damping."""
    way = 4 * (A if u_cr is None else u_cr)
    # m = 4 mu/pi; the ellipse of eta u'/Omega over u
    return by_work(m * mp.pi / 4 * way + mp.pi * eta * A**2, A)


def rest_share(A, *others):
    """I_0 and three derivatives."""
    (a,) = variables((A,), 3)
    dissipation = rest_of(a, *others)
    return [mp.chop(dissipation.derivative(order), TINY) for order in range(4)]


def searched_system(system, far, unknown):
    """Both functions and slopes by A and another unknown, from local balances that have the values and slopes given."""

    def of(at, A, F_0, *x):
        (I_0, I_0A, I_0AA, I_0AAA), (z, z_A, z_AA, z_AAA), (d, d_3), (h, h_A, h_AA, h_AAA) = (
            x[:4],
            x[4:8],
            x[8:10],
            x[10:14],
        )
        R_0, I_at, R_A, I_A = x[14:]
        a, w = variables((0, at), 3)

        def taylor(*values):
            return sum((value * a**k / mp.factorial(k) for k, value in enumerate(values)), 0 * a)

        def of_I(w):  # what depends on w, but for the first slope along A
            viscous = 2 * zeta * (A + a) * w
            if far:
                return taylor(I_0, I_0A, I_0AA, I_0AAA) * w**2 + viscous
            return viscous + d * (A + a) ** 2 * w**2 + d_3 * (A + a) ** 3 * w**3

        zeta = taylor(z, z_A, z_AA, z_AAA)
        unit, cubic = at**2 if far else 1, 0 if far else 6 * d_3 * at**3
        bend_I = [
            I_0AA * unit + 2 * (2 * z_A + A * z_AA) * at + 2 * d * (1 if far else at**2) + A * cubic,
            I_0AAA * unit + 2 * (3 * z_AA + A * z_AAA) * at + cubic,
        ]
        R = taylor(R_0, R_A, h_AA * unit, h_AAA * unit)
        R += (taylor(h, h_A, h_AA, h_AAA) if far else A + a) * (w**2 - at**2)
        I = taylor(I_at, I_A, *bend_I) + of_I(w) - of_I(0 * w + at)
        square = (R**2 + I**2) * mpf("0.5")
        R_w = R.derivative(0, 1)

        def both(value, order=0):
            """A function's value and slopes: of the square's derivative of this order along A."""
            found, by_a, by_w = (value.derivative(order + i, j) for i, j in ((0, 0), (1, 0), (0, 1)))
            if unknown == "R":
                by_a, by_w = by_a - by_w * R.derivative(1, 0) / R_w, by_w / R_w
            return found, by_a, by_w

        # where R^2 + I^2 is stationary in w, over its slope by R, or by what leaves it finite at w = 0
        rest, place = taylor(I_0, I_0A), A + a
        ratio = zeta / w + d * place + mpf("1.5") * d_3 * place**2 * w
        if unknown == "R":
            still = R + I * ((place * zeta + rest * w) / (taylor(h, h_A) * w) if far else ratio)
        elif far:
            still = R * taylor(h, h_A, h_AA) + rest * I
            still += place * zeta * (rest * w + 2 * zeta * place + d * place**2 / w)
        else:
            still = R + (rest + 2 * zeta * place * w + d * (place * w) ** 2 + d_3 * (place * w) ** 3) * ratio
        level = both(2 * square - F_0**2)
        fold, cusp, peak = both(square, 1), both(square, 2), both(still)
        pairs = {"folds": (level, fold), "peaks": (level, peak), "cusps": (fold, cusp), "isolas": (fold, peak)}
        pair = pairs.get(system) or (fold, both(square.by(0).by(1) / (2 * w)))
        return [pair[0][0], pair[1][0], *pair[0][1:], *pair[1][1:]]

    return of


def far_by_inertia(at):
    """The level less F_0, squares; and what its slope is, without what grows with Omega."""
    laws, grows = Laws(at), at["zeta"] * at["d"] * at["A"] ** 3
    Omega, level = laws.Omega.value, laws.level
    return [level.value - at["F_0"] ** 2, -(Omega**3) / 4 * level.derivative(0, 1) - Omega * grows, grows]


def stationary_R(at):
    """R/Omega^2 at both h for which the slope of the level vanishes: in h that is a parabola."""
    below, middle, above = (Laws({**at, "h": mpf(h)}).level.derivative(0, 1) for h in (-1, 0, 1))
    square = (below + above) / 2 - middle
    centre, constant = (below - above) / 4 / square, middle / square
    if centre**2 < constant:
        raise ValueError("no stationary level at such a frequency")
    lower, higher = (at["A"] + (centre + sign * mp.sqrt(centre**2 - constant)) * at["x"] ** 2 for sign in (-1, 1))
    return [(higher - lower) ** 2, lower, higher]


def largest_held(Omega, F_0, m, zeta, eta, d):
    """The amplitude at which I is F_0, as a root."""
    with mp.extradps(20):
        roots = mp.polyroots([d * Omega**2, 2 * zeta * Omega + eta, m - F_0], maxsteps=200, extraprec=200)
        return max(root.real for root in roots)


def rest_moves(A, m=1, *ends):
    """Derivatives of I_0 and its slopes by m, eta and, where friction ends there, u_cr, from the work of each."""
    a, *at = variables((A, m, 1, *ends), 3)
    dissipation = rest_of(a, *at)
    by_each = itertools.product(range(len(at)), range(3))
    return [
        mp.chop(dissipation.derivative(order, *(int(k == j) for j in range(len(at)))), TINY) for k, order in by_each
    ]


def slope_of_sum(pairs):
    """Of the sum of squares of functions with these values and slopes."""
    return mp.diff(lambda t: sum((value + slope * t) ** 2 for value, slope in pairs), 0)


#: what the systems of the search take between F_0 and R
KNOWN = "I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA"
SECOND_ORDER = "Omega A I_0 I_0A I_0AA zeta zeta_A zeta_AA d d_3 h h_A h_AA"
THIRD_ORDER = "Omega A I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA"
FIRST_ORDER = "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A"
LOCAL = "Omega A I_0 zeta d d_3 h"
DISSIPATION: Definitions = {
    "quadratic": ("c_2", lambda c_2: [by_work(power_work(c_2, 2), 1)]),
    "cubic": ("c_3", lambda c_3: [by_work(power_work(c_3, 3), 1)]),
    "viscous": ("A zeta zeta_2", viscous_ratio),
    "viscous_moves": ("A", lambda A: viscous_ratio(A, 0, 1)[:3]),
    # |h| is largest where R = -F_0 at the frequency at which quadratic damping takes all of the forcing
    "restoring": ("A F_0 d", lambda A, F_0, d: [F_0 + A * mp.findroot(lambda X: d * A**2 * X - F_0, F_0 / d / A**2)]),
    "at_rest": ("A m eta", rest_share),
    "released": ("A m eta u_cr", rest_share),
    "I": by_laws("Omega A I_0 zeta d d_3", lambda laws: laws.I.value),
    "F_A": derivative("F_A", FIRST_ORDER),
    "F_AA": derivative("F_AA", SECOND_ORDER),
    "F_Omega": derivative("F_Omega", LOCAL),
    "F_OmegaOmega": derivative("F_OmegaOmega", LOCAL),
    "F_AOmegaOmega": derivative("F_AOmegaOmega", FIRST_ORDER),
    "Omega_A": by_laws(FIRST_ORDER, lambda laws: stays(laws.F)),
    "stability": by_laws(FIRST_ORDER, lambda laws: laws("F_A") / (2 * laws.A.value)),
    "response_polynomial": polynomial("F", range(7), "A I_0 zeta d d_3 h"),
    "fold_polynomial": polynomial("F_A", range(7), "A I_0 I_0A zeta zeta_A d d_3 h h_A", lambda at: 2),
    # F_AOmega/(4 Omega) over Omega^2 at the h and h_A for which R and R_A vanish
    "turn_share": by_arguments(
        "x A I_0 I_0A zeta zeta_A d",
        lambda at: Laws({**at, "R": 0, "h_A": -1 / at["x"] ** 2})("F_AOmega") * at["x"] ** 3 / 4,
    ),
    "limit_envelope": ("Omega F_0 m zeta eta d", lambda *x: [largest_held(*x)]),
    "rest_moves": ("A", rest_moves),
    "released_moves": ("A m u_cr", rest_moves),
    "I_A": by_laws("Omega A I_0A zeta zeta_A d d_3", lambda laws: laws.I.derivative(1, 0)),
    # R, R_A, I and I_A over Omega^2
    "far": by_laws(
        "x A I_0 I_0A zeta zeta_A d h h_A",
        lambda laws: [one.derivative(k, 0) / laws.Omega.value**2 for one in (laws.R, laws.I) for k in (0, 1)],
    ),
    "F": derivative("F", "Omega A F_0 I_0 zeta d d_3 h"),
    # d^2 F_0^2/dA^2 where F_A = 0 stays and F_AA = 0, times F_AOmega^2 over A
    "cusp_bend": by_laws(THIRD_ORDER, lambda laws: -laws("F_Omega") * laws("F_AAA") * laws("F_AOmega") / laws.A.value),
    "isola_bend": by_laws(SECOND_ORDER, lambda laws: [laws.hessian, laws("F_AA") * laws.hessian]),
    "F_A_halved": ("R R_A I I_A", lambda R, R_A, I, I_A: [slope_of_sum(((R, R_A), (I, I_A))) / 2]),
    "R_of_response": ("F_0 I", lambda F_0, I: [mp.sqrt(mpf(F_0) ** 2 - mpf(I) ** 2)]),
    "R_of_peak": by_arguments("Omega A zeta d d_3 I", lambda at: with_zeros(at, R="F_Omega").R.value),
    "Omega_A_by_inertia": by_laws(FIRST_ORDER, lambda laws: stays(laws.level)),
    "far_by_inertia": by_arguments("x A F_0 I_0 zeta d h", far_by_inertia),
    "R_where_stationary": by_arguments("x A I_0 zeta d", stationary_R),
    # d^2 level^2/dA^2 where F_A = 0 stays and F_AA = 0, times Omega^5 F_AOmega^2/4
    "cusp_bend_by_inertia": by_laws(THIRD_ORDER, lambda laws: -laws.fall.value / 4 * laws("F_AAA") * laws("F_AOmega")),
    # the determinant of what the level's slope leaves where it vanishes, and F_AA times it
    "isola_bend_by_inertia": by_laws(SECOND_ORDER, lambda laws: [laws.fall_hessian, laws("F_AA") * laws.fall_hessian]),
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
        f"{system}_{'far_' if far else ''}by_{unknown}": (
            f"{'x' if far else 'Omega'} A F_0 {KNOWN} R I R_A I_A",
            searched_system(system, far, unknown),
        )
        for far in (False, True)
        for unknown in ("R", "x" if far else "Omega")
        for system in ("folds", "peaks", "cusps", "isolas")
    },
    "static": ("F_0 I_0 I_0A h h_A", static_halves),
    **{
        f"turns_by_{unknown}": (
            f"Omega A F_0 {KNOWN} R I R_A I_A",
            searched_system("turns", False, unknown),
        )
        for unknown in ("R", "Omega")
    },
}


def place(kernel: str, names: list[str], number: int, x: list[float]) -> None:
    """Of what leaves at u_cr, beyond that; of I below F_0; far from rest."""
    if kernel.startswith("released"):
        x[0] += x[-1]
    elif kernel == "R_of_response":
        x[1] *= 0.25
    elif kernel == "R_where_stationary":
        x[0] *= 0.125
