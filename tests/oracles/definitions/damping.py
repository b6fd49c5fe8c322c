"""Other laws of damping than viscous and Coulomb: what they put into R and I, by quadrature and differentiation."""

from __future__ import annotations

import itertools

from mpmath import mp, mpf

from tests.oracles.definitions.points import Function
from tests.oracles.definitions.series import variables
from tests.oracles.definitions.slow_flow import balances, near


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


#: what rounding leaves of a zero
TINY = mpf(10) ** -45


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


BY_A = "", "_A", "_AA", "_AAA"


class Laws:
    """R, I and what follows from them, as series in A and Omega about a kernel's arguments.

    Where R and I are arguments they stand for the values at (Omega, A), and their slopes are those of A Omega^2 + h
    and of I_0 + 2 zeta A Omega + d (A Omega)^2 + d_3 (A Omega)^3.
    """

    def __init__(self, names, x, order, by_inertia=False):
        at = dict(zip(names.split(), x, strict=True))
        self.d, self.d_3 = at.get("d", 0), at.get("d_3", 0)
        self.A, self.Omega = variables((at["A"], at["Omega"]), order)
        self.h, self.rest, self.zeta = (
            near(at["A"], [at.get(f"{name}{by}", 0) for by in slopes])(self.A)
            for name, slopes in (("h", BY_A), ("I_0", ("", "A", "AA", "AAA")), ("zeta", BY_A))
        )
        self.own = law_balances(self.Omega, self.A, self.rest, self.zeta, self.d, self.d_3, self.h)
        self.R, self.I = (
            one + (at[name] - one.value) if name in at else one for name, one in zip("RI", self.own, strict=True)
        )
        self.force = at.get("F_0", 0) * (self.Omega**2 if by_inertia else 1)

    def F(self):
        return self.R**2 + self.I**2 - self.force**2

    def F_A(self):
        return self.F().by(0)

    def F_AA(self):
        return self.F_A().by(0)

    def peak(self):
        """F_Omega/(4 A Omega), in which the I of I_0 counts; with the slopes of R and I themselves."""
        ratio = self.zeta / self.Omega + self.d * self.A + mpf("1.5") * self.d_3 * self.A**2 * self.Omega
        return self.R + self.own[1] * ratio

    def bend(self):
        """F_AOmega/(2 Omega) of the R and I that h and I_0 give."""
        return sum(one**2 for one in self.own).by(0).by(1) / (2 * self.Omega)

    def least(self):
        """-Omega^5/4 times the slope of the level by Omega, in which h and I_0 count; with the slopes of R and I."""
        v = self.A * self.Omega
        return self.R * self.h + self.I * (self.rest + self.zeta * v - self.d_3 * v**3 / 2)

    def level(self):
        """Of an excitation by inertia, squared."""
        return sum(one**2 for one in self.own) / self.Omega**4


def dissipated_balance(names, order=0):
    """I, or a derivative of it by A."""
    return lambda *x: [Laws(names, x, max(order, 1)).I.derivative(order, 0)]


def dissipated_slope(order, names, halved=False):
    """One derivative of F, over 2 A if it is halved."""

    def slope(*x):
        laws = Laws(names, x, sum(order))
        return [laws.F().derivative(*order) / (2 * laws.A.value if halved else 1)]

    return slope


def polynomial_of(half, names):
    """Coefficients of F, or of F_A/2, of which these are all."""

    def coefficients(*x):
        F = Laws(f"Omega {names}", (mpf(0), *x), 7).F()
        return [(F.by(0) / 2 if half else F).derivative(0, power) / mp.factorial(power) for power in range(7)]

    return coefficients


def slope_where_stays(name, names):
    """dOmega/dA of the states where F or a level stays."""

    def slope(*x):
        by_A, by_Omega = getattr(Laws(names, x, 1), name)().slopes()
        return [-by_A / by_Omega]

    return slope


def level_of_laws(w, a, rest, zeta, d, h):
    """Of an excitation by inertia."""
    return sum(part**2 for part in law_balances(w, a, rest, zeta, d, 0, h)) / w**4


def cusp_by_inertia(names):
    """d^2 level^2/dA^2 along F_A = 0 with F_AA = 0, times Omega^5 F_AOmega^2/4."""

    def bend(Omega, *x):
        laws = Laws(names, (Omega, *x), 3)
        F = laws.F()
        return [-(Omega**5) / 4 * laws.level().derivative(0, 1) * F.derivative(3, 0) * F.derivative(1, 1)]

    return bend


def isola_by_inertia(names):
    """As `law_isola`, of what the level's slope leaves where it vanishes."""

    def bend(Omega, *x):
        laws = Laws(names, (Omega, *x), 2)
        by_Omega = (laws.Omega**5 * laws.level().by(1)).derivative(0, 1) / Omega
        return stationary_share(*(laws.F().derivative(*order) for order in ((2, 0), (1, 1))), by_Omega)

    return bend


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


def stationary_share(F_AA, F_AOmega, F_OmegaOmega):
    """The determinant of second derivatives, and F_AA times it."""
    determinant = mp.det(mp.matrix([[F_AA, F_AOmega], [F_AOmega, F_OmegaOmega]]))
    return [determinant, F_AA * determinant]


def far_by_inertia(x, A, F_0, I_0, zeta, d, h):
    """The level less F_0, squares; and what its slope is, without what grows with Omega."""
    w, grows = 1 / x, zeta * d * A**3
    slope = mp.diff(lambda v: level_of_laws(v, A, I_0, zeta, d, h), w)
    return [level_of_laws(w, A, I_0, zeta, d, h) - F_0**2, -(w**3) / 4 * slope - w * grows, grows]


def stationary_R(x, A, I_0, zeta, d):
    """R/Omega^2 at both h for which the slope of the level vanishes: in h that is a parabola."""
    w = 1 / x

    def slope(h):
        return mp.diff(lambda v: level_of_laws(v, A, I_0, zeta, d, h), w)

    below, at, above = (slope(mpf(h)) for h in (-1, 0, 1))
    middle, constant = (below - above) / 4 / ((below + above) / 2 - at), at / ((below + above) / 2 - at)
    if middle**2 < constant:
        raise ValueError("no stationary level at such a frequency")
    lower, higher = (A + (middle + sign * mp.sqrt(middle**2 - constant)) * x**2 for sign in (-1, 1))
    return [(higher - lower) ** 2, lower, higher]


def far_balances(x, A, I_0, I_0A, zeta, zeta_A, d, h, h_A):
    """R, R_A, I and I_A over Omega^2 at Omega = 1/x."""
    w, force = 1 / x, near(A, [h, h_A])
    names, of = "Omega A I_0 I_0A zeta zeta_A d", (w, A, I_0, I_0A, zeta, zeta_A, d)
    of_R = [mp.diff(lambda a: balances(w, a, 0, zeta, force(a))[0], A, order) for order in (0, 1)]
    return [x**2 * one for one in (*of_R, *dissipated_balance(names)(*of), *dissipated_balance(names, 1)(*of))]


def turn_beside(x, A, *damping):
    """F_AOmega/(4 Omega) over Omega^2 at the h and h_A for which R and R_A vanish."""
    w = 1 / x
    slope = dissipated_slope((1, 1), "Omega A I_0 I_0A zeta zeta_A d h h_A")(w, A, *damping, -A * w**2, -(w**2))
    return [slope[0] / (4 * w) * x**2]


def largest_held(Omega, F_0, m, zeta, eta, d):
    """The amplitude at which I is F_0, as a root."""
    with mp.extradps(20):
        roots = mp.polyroots([d * Omega**2, 2 * zeta * Omega + eta, m - F_0], maxsteps=200, extraprec=200)
        return max(root.real for root in roots)


def law_balances(w, a, rest, zeta, d, d_3, h):
    """R and I of any laws, from I_0."""
    R, I = balances(w, a, rest, zeta, h)
    return R, I + d * (a * w) ** 2 + d_3 * (a * w) ** 3


def rest_moves(A, m=1, *ends):
    """Derivatives of I_0 and its slopes by m, eta and, where friction ends there, u_cr, from the work of each."""
    a, *at = variables((A, m, 1, *ends), 3)
    dissipation = rest_of(a, *at)
    by_each = itertools.product(range(len(at)), range(3))
    return [
        mp.chop(dissipation.derivative(order, *(int(k == j) for j in range(len(at)))), TINY) for k, order in by_each
    ]


def law_response(Omega, A, F_0, *others):
    return sum(part**2 for part in law_balances(Omega, A, *others)) - F_0**2


def law_bend(names):
    """d^2 F_0^2/dA^2 along F_A = 0 with F_AA = 0, times F_AOmega^2 over A."""

    def bend(*x):
        laws = Laws(names, x, 3)
        F = laws.F()
        return [-mp.fprod(F.derivative(*order) for order in ((0, 1), (3, 0), (1, 1))) / laws.A.value]

    return bend


def law_isola(names):
    def bend(*x):
        F = Laws(names, x, 2).F()
        return stationary_share(*(F.derivative(*order) for order in ((2, 0), (1, 1), (0, 2))))

    return bend


def slope_of_sum(pairs):
    """Of the sum of squares of functions with these values and slopes."""
    return mp.diff(lambda t: sum((value + slope * t) ** 2 for value, slope in pairs), 0)


def vanishing_R(Omega, A, zeta, d, d_3, I):
    """R at which R^2 + I^2 is stationary in Omega."""
    by_R, by_I = (mp.diff(lambda w, n=n: law_balances(w, A, 0, zeta, d, d_3, 0)[n], Omega) for n in (0, 1))
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
        lag = lambda a: law_balances(Omega, a, eta * a, zeta, d, 0, 0)[1]  # noqa: E731
        return least_slope(A, A**2 * h_AA / 2, lag(A), mp.diff(lag, A))[0] / A**2

    # a quadratic in A, by three of its values
    nodes = [mpf(1), mpf(2), mpf(3)]
    found = mp.lu_solve(mp.matrix([[1, A, A**2] for A in nodes]), mp.matrix([whole(A) for A in nodes]))
    return [found[0], found[2]]


def static_halves(F_0, I_0, I_0A, h, h_A):
    """h less and plus what it is where F vanishes at Omega = 0, and their slopes."""

    def half(a, sign):
        lag, local = (near(mpf(1), values)(a) for values in ((I_0, I_0A), (h, h_A)))
        return local + sign * mp.findroot(lambda x: x**2 + lag**2 - mpf(F_0) ** 2, F_0)

    return [half(mpf(1), sign) for sign in (-1, 1)] + [mp.diff(lambda a, s=sign: half(a, s), 1) for sign in (-1, 1)]


#: what the systems of the search take between F_0 and R
KNOWN = "I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA"
DISSIPATION: dict[str, tuple[str, Function]] = {
    "quadratic": ("c_2", lambda c_2: [by_work(power_work(c_2, 2), 1)]),
    "cubic": ("c_3", lambda c_3: [by_work(power_work(c_3, 3), 1)]),
    "viscous": ("A zeta zeta_2", viscous_ratio),
    "viscous_moves": ("A", lambda A: viscous_ratio(A, 0, 1)[:3]),
    # |h| is largest where R = -F_0 at the frequency at which quadratic damping takes all of the forcing
    "restoring": ("A F_0 d", lambda A, F_0, d: [F_0 + A * mp.findroot(lambda X: d * A**2 * X - F_0, F_0 / d / A**2)]),
    "at_rest": ("A m eta", rest_share),
    "released": ("A m eta u_cr", rest_share),
    "I": ("Omega A I_0 zeta d d_3", dissipated_balance("Omega A I_0 zeta d d_3")),
    **{
        f"F_{''.join(letters)}": (names, dissipated_slope((letters.count("A"), letters.count("Omega")), names))
        for letters, names in (
            (("A",), "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A"),
            (("A", "A"), "Omega A I_0 I_0A I_0AA zeta zeta_A zeta_AA d d_3 h h_A h_AA"),
            (("Omega",), "Omega A I_0 zeta d d_3 h"),
            (("Omega", "Omega"), "Omega A I_0 zeta d d_3 h"),
            (("A", "Omega"), "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A"),
            (("A", "Omega", "Omega"), "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A"),
        )
    },
    "Omega_A": (names := "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A", slope_where_stays("F", names)),
    "stability": (names, dissipated_slope((1, 0), names, halved=True)),
    "response_polynomial": (names := "A I_0 zeta d d_3 h", polynomial_of(False, names)),
    "fold_polynomial": (names := "A I_0 I_0A zeta zeta_A d d_3 h h_A", polynomial_of(True, names)),
    "turn_share": ("x A I_0 I_0A zeta zeta_A d", turn_beside),
    "limit_envelope": ("Omega F_0 m zeta eta d", lambda *x: [largest_held(*x)]),
    "rest_moves": ("A", rest_moves),
    "released_moves": ("A m u_cr", rest_moves),
    "I_A": ("Omega A I_0A zeta zeta_A d d_3", dissipated_balance("Omega A I_0A zeta zeta_A d d_3", 1)),
    "far": ("x A I_0 I_0A zeta zeta_A d h h_A", far_balances),
    "F": (names := "Omega A F_0 I_0 zeta d d_3 h", lambda *x: [law_response(*x)]),
    "cusp_bend": (
        names := "Omega A I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA",
        law_bend(names),
    ),
    "isola_bend": (names := "Omega A I_0 I_0A I_0AA zeta zeta_A zeta_AA d d_3 h h_A h_AA", law_isola(names)),
    "F_A_halved": ("R R_A I I_A", lambda R, R_A, I, I_A: [slope_of_sum(((R, R_A), (I, I_A))) / 2]),
    "R_of_response": ("F_0 I", lambda F_0, I: [mp.sqrt(mpf(F_0) ** 2 - mpf(I) ** 2)]),
    "R_of_peak": ("Omega A zeta d d_3 I", lambda *x: [vanishing_R(*x)]),
    "I_scaled": ("Omega A I_0_over_A zeta d d_3", lambda w, A, r, *laws: [law_balances(w, A, r * A, *laws, 0)[1] / A]),
    "F_A_scaled": ("Omega h_over_A h_A I_over_A I_A", scaled_slope),
    "least_scaled": ("Omega zeta eta d h_AA", least_from_rest),
    "Omega_A_by_inertia": (names := "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A", slope_where_stays("level", names)),
    "far_by_inertia": ("x A F_0 I_0 zeta d h", far_by_inertia),
    "R_where_stationary": ("x A I_0 zeta d", stationary_R),
    "cusp_bend_by_inertia": (
        names := "Omega A I_0 I_0A I_0AA I_0AAA zeta zeta_A zeta_AA zeta_AAA d d_3 h h_A h_AA h_AAA",
        cusp_by_inertia(names),
    ),
    "isola_bend_by_inertia": (
        names := "Omega A I_0 I_0A I_0AA zeta zeta_A zeta_AA d d_3 h h_A h_AA",
        isola_by_inertia(names),
    ),
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
