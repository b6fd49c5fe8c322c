"""How answers move with a parameter, of any damping and excitation, and what of that kernels give."""

from __future__ import annotations

from mpmath import mp, mpf

from tests.oracles.definitions.damping import KNOWN
from tests.oracles.definitions.inertia import shaken
from tests.oracles.definitions.laws import balances, near
from tests.oracles.definitions.points import Definitions, Function
from tests.oracles.definitions.series import variables

#: for each kind of answer the conditions beside F = 0, and F's derivatives by (A, Omega) that must not vanish
ANSWERS: dict[str, tuple[tuple[str, str], list[tuple[int, int]]]] = {
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
#: forces by Omega and F_0
FORCES: dict[str, Function] = {"force": lambda w, F_0: F_0 + 0 * w, "inertia": shaken}


def balanced(x):
    """R and I by A, Omega and a parameter, of h, I_0, zeta and d, each with what the parameter does to it."""
    A, *values, (d, d_3), (d_p, d_3p) = x
    of = [near(A, one) for one in values]

    def both(a, w, p):
        h, rest, zeta = (at(a) + by_p(a) * p for at, by_p in zip(of[::2], of[1::2], strict=True))
        return balances(w, a, rest, zeta, h, d + d_p * p, d_3 + d_3p * p)

    return both


def implicit(kind, force):
    """Sensitivities of one kind of answer by the implicit function theorem; residuals are subtracted first.

    The system's determinant is the product of what must not vanish.
    """
    conditions, pivots = ANSWERS[kind]

    def of(Omega, A, F_0, *x):
        both = balanced((A, x[10:14], x[14:17], x[:4], x[17:20], x[4:8], x[20:23], x[8:10], x[23:25]))
        forcing_p, frequency_p, end_p = x[25:]
        a, w, f, p = variables((A, Omega, F_0, mpf(0)), 1 + max(sum(DERIVATIVES.get(name, ())) for name in conditions))
        R, I = both(a, w, p)
        if "R" in conditions:
            R = R - R.value
        F = R**2 + I**2 - FORCES[force](w, f) ** 2
        whole = F
        for i, k in (DERIVATIVES[name] for name in conditions if name in DERIVATIVES):
            gone = F.derivative(i, k, 0, 0) / (mp.factorial(i) * mp.factorial(k))
            F = F - gone * (a - a.value) ** i * (w - w.value) ** k
        known = {
            "R": R,
            "forcing": f - forcing_p * p,
            "frequency": w - frequency_p * p,
            "breakpoint": a - end_p * p,
        }
        rows = []
        for name in ("F", *conditions):
            order = (*DERIVATIVES.get(name, (0, 0)), 0, 0)
            rows.append([known.get(name, F).derivative(*(n + (k == j) for j, n in enumerate(order))) for k in range(4)])
        system = mp.matrix([row[:3] for row in rows])
        with mp.extradps(20):
            sensitivities = list(mp.lu_solve(system, mp.matrix([-row[3] for row in rows])))
        if kind not in ("isola", "corner_backbone"):
            determinant = mp.fprod(whole.derivative(*order, 0, 0) for order in pivots)
            determinant *= 1 if "forcing" in conditions else rows[0][2]
            assert mp.almosteq(abs(mp.det(system)), abs(determinant), rel_eps=mpf(10) ** (8 - mp.dps))
        return sensitivities

    return of


def slopes(Omega, A, R, *x):
    """F's derivatives, R's, and 1 where a number is given: by A, Omega and F_0; then their sizes."""
    rest, zeta, (d, d_3), h, (S_Omega, S_OmegaOmega, S_F, S_FOmega) = x[:4], x[4:8], x[8:10], x[10:14], x[14:]

    def rows(sign, h):
        local, lag, ratio = (near(A, [sign(value) for value in values]) for values in (h, rest, zeta))
        a, w = variables((A, Omega), 3)
        both = balances(w, a, lag(a), ratio(a), local(a), d, d_3)
        F, R = sum(part**2 for part in both).derivative, both[0].derivative
        excited = -1 if sign is mpf else 1
        by_Omega, by_both = (F(0, n) + excited * sign(S) for n, S in ((1, S_Omega), (2, S_OmegaOmega)))
        return [
            *(F(1, 0), by_Omega, excited * sign(S_F)),
            *(F(2, 0), F(1, 1), mpf(0)),
            *(F(3, 0), F(2, 1), mpf(0)),
            *(F(1, 1), by_both, excited * sign(S_FOmega)),
            *(R(1, 0), R(0, 1), mpf(0)),
            *(mpf(int(k in (2, 4, 6))) for k in range(9)),
        ]

    # R is an argument of its own: h without its signs is that of the sizes
    return [*rows(mpf, (R - A * Omega**2, *h[1:])), *rows(abs, h)]


def right(Omega, A, R, *x):
    """What a parameter does to F, its derivatives and R, with the opposite sign; and to what is given."""
    rest, zeta, d, h, x = x[:3], x[3:6], x[6:8], (R - A * Omega**2, *x[8:10]), x[10:]
    both = balanced((A, h, x[:3], rest, x[3:6], zeta, x[6:9], d, x[9:11]))
    R_of, I_of = both(*variables((A, Omega, mpf(0)), 3))
    F = (R_of**2 + I_of**2).derivative
    return [-F(0, 0, 1), -F(1, 0, 1), -F(2, 0, 1), -F(0, 1, 1), -R_of.derivative(0, 0, 1), *x[11:]]


def of_state(Omega, A, I_0, I_0A, zeta, zeta_A, d, d_3, h, h_A, force, force_Omega, force_F, *x):
    """Derivatives of phase and transmissibility along a perturbation, from R, I and h."""
    h_p, I_0p, zeta_p, d_p, d_3p, A_p, Omega_p, F_0_p = x

    def perturbed(p):
        w, a, restoring = Omega + Omega_p * p, A + A_p * p, h + (h_p + h_A * A_p) * p
        rest = I_0 + (I_0p + I_0A * A_p) * p
        ratio = zeta + (zeta_p + zeta_A * A_p) * p
        return *balances(w, a, rest, ratio, restoring, d + d_p * p, d_3 + d_3p * p), restoring

    def turned(p):
        R, I, _ = perturbed(p)
        return mp.arg(mp.mpc(-R, -I))

    def passed_on(p):
        _, I, restoring = perturbed(p)
        return mp.hypot(restoring, I) / (force + (force_Omega * Omega_p + force_F * F_0_p) * p)

    return [mp.diff(turned, 0), mp.diff(passed_on, 0)]


def excited(force):
    """A force, its slopes, and those of its square."""

    def of(Omega, F_0):
        w, f = variables((Omega, F_0), 2)
        by = FORCES[force](w, f)
        square = by**2
        orders = (1, 0), (2, 0), (0, 1), (1, 1)
        return [by.value, by.derivative(1, 0), by.derivative(0, 1), *(square.derivative(*order) for order in orders)]

    return of


AT = f"Omega A F_0 {KNOWN}"
CAUSES = "h_p h_Ap h_AAp I_0p I_0Ap I_0AAp zeta_p zeta_Ap zeta_AAp d_p d_3p forcing_p frequency_p end_p"
SENSITIVITIES: Definitions = {
    "slopes": (
        f"Omega A R {KNOWN} S_Omega S_OmegaOmega S_F S_FOmega",
        slopes,
    ),
    "right": (f"Omega A R I_0 I_0A I_0AA zeta zeta_A zeta_AA d d_3 h_A h_AA {CAUSES}", right),
    "of_state": (
        "Omega A I_0 I_0A zeta zeta_A d d_3 h h_A force force_Omega force_F h_p I_0p zeta_p d_p d_3p A_p Omega_p F_0_p",
        of_state,
    ),
    **{f"by_{name}": ("Omega F_0", excited(name)) for name in FORCES},
}
