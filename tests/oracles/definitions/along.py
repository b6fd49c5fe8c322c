"""Where curves change along the amplitude. Takes h and its derivatives; returns functions that vanish there."""

from __future__ import annotations

from mpmath import mp, mpf

from tests.oracles.definitions.laws import (
    Laws,
    balances,
    by_arguments,
    by_laws,
    derivative,
    linear_root,
    near,
    stays,
    with_slope,
    with_zeros,
)
from tests.oracles.definitions.points import Definitions, beside_backbone, specialized
from tests.oracles.definitions.resultants import detachment, of_reals
from tests.oracles.definitions.slow_flow import SLOW_FLOW


def static_halves(F_0, I_0, I_0A, h, h_A):
    """h less and plus what it is where F vanishes at Omega = 0, and their slopes."""

    def half(a, sign):
        lag, local = (near(mpf(1), values)(a) for values in ((I_0, I_0A), (h, h_A)))
        return local + sign * mp.findroot(lambda x: x**2 + lag**2 - mpf(F_0) ** 2, F_0)

    return [half(mpf(1), sign) for sign in (-1, 1)] + [mp.diff(lambda a, s=sign: half(a, s), 1) for sign in (-1, 1)]


def isola(at):
    """F_Omega/(4 A) where Omega^2 = h_A, and its slope; without the common factor Omega if there is no friction."""
    laws = Laws({**at, "Omega": mp.sqrt(at["h_A"])})
    value = laws.F.by(1) / (4 * laws.A)
    return with_slope(value if at["m"] else value / laws.Omega, at["h_AA"] / (2 * laws.Omega.value))


def isola_frequency(h_A):
    """Of a state with F_A = F_Omega = 0 at A = 1; the damping is arbitrary."""
    at = {"m": mpf(1) / 100, "zeta": mpf(1) / 20, "h_A": h_A}
    return [mp.findroot(lambda w: with_zeros({**at, "Omega": w}, h="F_Omega")("F_A"), 1.01 * mp.sqrt(h_A))]


def fold(A, F_0, m, zeta, h, h_A, k, k_A):
    """On the circle R^2 + I^2 = F_0^2 and the line k R + m I = F_0^2, by angles: R less A Omega^2 + h, reversed."""
    of_h, of_k = near(A, (h, h_A)), near(A, (k, k_A))

    def at(a):
        normal, half = mp.atan2(m, of_k(a)), mp.acos(F_0 / mp.hypot(of_k(a), m))
        I, R = max((F_0 * mp.sin(angle), F_0 * mp.cos(angle)) for angle in (normal + half, normal - half))
        w = (I - m) / balances(1, a, 0, zeta, 0)[1]
        return balances(w, a, 0, 0, of_h(a))[0] - R, w

    return [at(A)[0], mp.diff(lambda a: at(a)[0], A), at(A)[1]]


def tangent_R(at, T):
    """R where the tangent of h meets A = 0 at the intercept, and its slope is T."""
    return at["intercept"] + at["A"] * T


def cusps(at):
    """F_AA/2 by T = Omega^2 + h_A, where R = k + A T, and by X = Omega^2, where R = A X + h."""

    def half_F_AA(X, **R):
        return mp.re(Laws({**at, "Omega": mp.sqrt(X), **R})("F_AA")) / 2

    def quadratic(f):
        """Half the linear and the constant coefficient of a monic quadratic, from its values at 0 and 1."""
        return [(f(mpf(1)) - f(mpf(0)) - 1) / 2, f(mpf(0))]

    a, b = quadratic(lambda T: half_F_AA(T - at["h_A"], R=tangent_R(at, T)))
    return [a, b, *quadratic(half_F_AA), a**2 - b]


def where_tangent(at, **names):
    """The laws at Omega^2 = X with R's slope T."""
    return with_zeros({**at, "Omega": mp.sqrt(at["X"]), "h_A": at["T"] - at["X"]}, **names)


def cusp_balance(at):
    """The R for which F_A, linear in it, vanishes at h_A = T - X; Omega^2 by it, the forcing as of `cusp`, squared."""
    laws = where_tangent(at, R="F_A")
    R, I = laws.R.value, laws.I.value
    return [(R - at["h"]) / at["A"], R * at["intercept"] + at["m"] * I]


def cusp(at):
    """By differentiating F along A and Omega; F_AA/2 = (X - X_1)(X - X_2), root = (X_1 - X_2)/2, at X = X_1.

    R is k + A T, which the second uses; the forcing is that of R (k + A T) in place of R^2.
    """
    A, R, other = at["A"], at["R"], tangent_R(at, at["T"])
    laws, tangent = where_tangent(at), where_tangent({**at, "R": other})
    bend = mp.diff(lambda v: (v**2 - at["X"]) * (v**2 - at["X"] + 2 * at["root"]), laws.Omega.value)
    tangential = -laws("F_AOmega") / 2 * laws("F_AAA") / 2 / bend
    level = mp.sqrt(R * other + laws.I.value**2 - A * laws("F_A") / 2)
    return [laws("F_A") / 2, (tangent("F_A") - A * tangent("F_AA")) / 2, tangential, level]


def turn(at):
    """F_A/2 and F_AA/2 by differentiating F, at the slope of R for which F_AOmega, linear in it, vanishes."""

    def laws(T):
        return Laws({**at, "R": tangent_R(at, T), "h_A": T - at["Omega"] ** 2})

    found = laws(linear_root(lambda T: laws(T)("F_AOmega")))
    return [found("F_A") / 2, found("F_AA") / 2]


def peak_slope(at):
    """dOmega/dA where F stays stationary over Omega."""
    return stays(with_zeros(at, h="F_Omega").F.by(1))


def peak(at):
    """F, and its slope along A, for the h that makes F stationary over Omega."""
    laws = with_zeros(at, h="F_Omega")
    return [laws("F"), laws("F_A")]


def undamped_frequency(h_A):
    """Of a fold off the backbone; A and h are arbitrary."""
    return [mp.findroot(lambda w: Laws({"Omega": w, "h": mpf(1), "h_A": h_A})("F_A"), 1.01 * mp.sqrt(-h_A))]


def undamped_fold(F_0, m, k, k_A):
    """F of a state whose R is k, and its slope."""
    laws = Laws({"F_0": F_0, "m": m, "h": k, "h_A": k_A})
    return [laws("F"), laws("F_A")]


def undamped_rises(h_AA, h_AAA, k):
    """The slope of level^2/2 at A = 1 along folds whose tangent meets A = 0 at k; the same of h_AAA where h_AA is 0."""

    def slope(*derivatives):
        laws = Laws(dict(zip(("h", "h_AA", "h_AAA"), (k, *derivatives), strict=True)))
        return ((laws.h - laws.A * laws.h.by(0)) ** 2 / 2).by(0)

    return [slope(h_AA, mpf(0)).value, slope(mpf(0), h_AAA).by(0).value]


def undamped(at):
    """F_AA/(2 R) and R at the undamped folds, each with its slope."""
    laws = Laws({**at, "Omega": mp.sqrt(-at["h_A"])})
    turn = -at["h_AA"] / (2 * laws.Omega.value)
    return with_slope(laws.F.by(0).by(0) / (2 * laws.R), turn) + with_slope(laws.R, turn)


def fold_sensitivities(A, k, R):
    """Derivatives of F and F_A by R at constant I; R's tangent over A meets A = 0 at k."""

    def shifted(order, y):
        return Laws({"A": A, "R": R + y, "h_A": (R + y - k) / A}, 2).F.derivative(order, 0)

    return [mp.diff(lambda y, order=order: shifted(order, y), 0) for order in (0, 1)]


def isola_laws(at):
    """With h and h_A for which F_A = F_Omega = 0; both are linear."""
    return with_zeros(at, h="F_Omega", h_A="F_A")


def cusp_bend(at):
    """With h, and then m, in which they are linear, for which F_AA = F_A = 0."""
    if at["zeta"] == 0:
        raise ValueError("no m makes F_A = 0")
    laws = with_zeros({**at, "h_A": at["T"] - at["Omega"] ** 2}, h="F_AA", m="F_A")
    return -laws("F_Omega") * laws("F_AAA") * laws("F_AOmega") / at["A"]


def tail(Omega, F_0, m):
    """Of the states of a spring h = A without viscous damping."""
    return [mp.findroot(lambda a: sum(one**2 for one in balances(Omega, a, m, 0, a)) - F_0**2, F_0 / Omega**2)]


def most_restoring(A, F_0, m, zeta):
    """F_0 + A Omega^2 at the Omega for which damping takes all of the forcing."""
    return [F_0 + A * linear_root(lambda w: balances(w, A, m, zeta, 0)[1] - F_0) ** 2]


def isolation(A, F_0, reduction, h):
    """Where the square of the force on the base, h beside the same damping, is less by that share of F_0^2: a root."""
    m, zeta = mpf("0.01"), mpf("0.03")

    def excess(w):
        R, I = balances(w, A, m, zeta, h)
        return mp.sqrt(R**2 + I**2) - mp.sqrt(h**2 + I**2 + reduction * F_0**2)

    return [mp.findroot(excess, 1.2 * mp.sqrt((abs(h) + F_0) / A))]


SLOPES: Definitions = {
    "Omega_A": by_laws("Omega A m zeta h h_A", lambda laws: stays(laws.F)),
    "level_rise": by_laws("Omega A m zeta h h_A h_AA", lambda laws: -laws("F_Omega") * laws("F_AA") * laws("F_AOmega")),
    "cusp_bend": by_arguments("Omega A zeta h_AA h_AAA T", cusp_bend),
    "isola_bend": by_arguments("Omega A m zeta h_AA", lambda at: (laws := isola_laws(at))("F_AA") * laws.hessian),
    "isola_hessian": by_arguments("Omega A m zeta h_AA", lambda at: isola_laws(at).hessian),
    "most_restoring": ("A F_0 m zeta", most_restoring),
    "least_restoring": ("F_0 m", lambda F_0, m: [mp.sqrt(mpf(F_0) ** 2 - mpf(m) ** 2)]),
    "tail": ("Omega F_0 m", tail),
    "isolation": ("A F_0 reduction h", isolation),
    # the forcing of a motion of no amplitude
    "held": ("m preload", lambda m, preload: [mp.hypot(*balances(mpf(1), 0, m, 0, -preload))]),
}
LOCI: Definitions = {
    "F_OmegaOmega": derivative("F_OmegaOmega", "Omega A zeta h"),
    "level": by_laws("Omega A m zeta h", lambda laws: mp.sqrt(laws("F"))),
    "rest": ("F_0 m h h_A", lambda F_0, m, h, h_A: static_halves(F_0, m, mpf(0), h, h_A)[:3]),
    # where the tangent of h meets A = 0, and its slope
    "intercept": by_laws("A h h_A h_AA", lambda laws: with_slope(laws.h - laws.A * laws.h.by(0), 0)),
}
DAMPED: Definitions = {
    "isola_Omega": ("h_A", isola_frequency),
    "isola_level": by_arguments("Omega A m zeta", lambda at: mp.sqrt(with_zeros(at, h="F_Omega")("F"))),
    "isola": by_arguments("A m zeta h h_A h_AA", isola),
    "fold": ("A F_0 m zeta h h_A intercept k_A", fold),
    "cusps": by_arguments("A zeta h h_A h_AA intercept", cusps),
    "cusp_R": by_arguments(
        "A zeta h_AA intercept X T", lambda at: [tangent_R(at, at["T"]), where_tangent(at, R="F_AA").R.value]
    ),
    "cusp": by_arguments("A m zeta h_AA h_AAA intercept X T R root", cusp),
    "cusp_balance": by_arguments("A m zeta h intercept X T", cusp_balance),
    "turn": by_arguments("Omega A m zeta h_AA intercept", turn),
    "peak": by_arguments("Omega A F_0 m zeta h_A", peak),
    "peak_Omega_A": by_arguments("Omega A m zeta h_A", peak_slope),
}
DETACHMENT = ("A m zeta h", of_reals(detachment))
#: where the dampings in a name vanish, and of folds without viscous damping. There (34) does not depend on A
VANISHING: Definitions = {
    "response_quartic_mu0": specialized(SLOW_FLOW["response_quartic"], m=0),
    "detachment_mu0": specialized(DETACHMENT, m=0),
    "isola_mu0": specialized(DAMPED["isola"], m=0),
    "fold_mu0": specialized(DAMPED["fold"], m=0),
    "detachment_zeta0": specialized(DETACHMENT, A=1, zeta=0),
    "fold_zeta0": ("F_0 m intercept k_A", undamped_fold),
    "undamped_Omega": ("h_A", undamped_frequency),
    "undamped": by_arguments("A h h_A h_AA h_AAA", undamped),
    "undamped_level": ("m intercept", lambda m, k: [mp.hypot(m, k)]),
    "undamped_rises": ("h_AA h_AAA intercept", undamped_rises),
    "detachment_mu0_zeta0": specialized(DETACHMENT, A=1, m=0, zeta=0),
}
#: of folds' neighbours
BESIDE_FOLDS: Definitions = {
    "fold_moves": ("A intercept R", fold_sensitivities),
    "fold_square": ("Omega A lacks", lambda w, A, y: [w**2 - y / A]),
}
#: all of the slow flow
OF_FLOW = SLOW_FLOW | SLOPES | {"detachment": DETACHMENT} | LOCI | DAMPED | BESIDE_FOLDS | VANISHING
#: the sign of h_A where a root of it is taken
SIGNS = {"isola_Omega": 1, "isola": 1, "isola_mu0": 1, "undamped_Omega": -1, "undamped": -1}


def place(kernel: str, names: list[str], number: int, x: list[float]) -> None:
    """Some next to the backbone; where h pushes outwards, too, and where its tangent meets A = 0 below 0."""
    beside_backbone(names, number, x)
    if kernel in SIGNS:
        h_A = names.index("h_A")
        x[h_A] = SIGNS[kernel] * abs(x[h_A])
    turned = ("h",) if kernel == "isolation" else ("intercept", "R") if "intercept" in names else ()
    for k in range(len(x)) if number % 2 == 0 else ():
        x[k] *= -1 if names[k] in turned else 1
