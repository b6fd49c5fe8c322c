"""Slow flow of any mechanism, in h = H - A and its derivatives: on whole intervals.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

Each output holds every value that the function of the same name takes on the arguments: objects with operators and
the methods `square` and `sqrt`. Equations and domains that are not stated here are those of slow_flow.py.
"""

__all__ = [
    "backbone", "cusp", "cusp_bend", "cusp_R", "cusps", "F", "F_A", "F_AA", "F_AOmega", "F_Omega",
    "F_Omega_reduced", "F_Omega_reduced_mu0", "F_Omega_reduced_zeta0", "F_OmegaOmega", "fold", "fold_zeta0",
    "intercept", "isola", "isola_bend", "isola_mu0", "isola_Omega", "least_restoring", "level", "level_rise",
    "most_restoring", "R", "state", "state_R", "undamped_Omega", "undamped_rises",
]


def R(Omega, A, h):
    """Cosine balance, -F_0 cos phi at a fixed point."""
    return A * Omega.square() + h


def F(Omega, A, F_0, m, zeta, h):
    """Frequency response; zero at a steady state."""
    R = A * Omega.square() + h
    I = 2.0 * A * Omega * zeta + m
    return R.square() + (-F_0 + I) * (F_0 + I)


def F_A(Omega, A, m, zeta, h, h_A):
    """dF/dA; positive where stable."""
    t0 = Omega.square()
    R = A * t0 + h
    t1 = 2.0 * Omega * zeta
    I = A * t1 + m
    return 2.0 * (I * t1 + R * (h_A + t0))


def F_AA(Omega, A, m, zeta, h, h_A, h_AA):
    """d2F/dA2."""
    t0 = Omega.square()
    R = A * t0 + h
    t1 = h_A + t0
    return 2.0 * (R * h_AA + 4.0 * t0 * zeta.square() + t1.square())


def F_Omega(Omega, A, m, zeta, h):
    """dF/dOmega."""
    R = A * Omega.square() + h
    I = 2.0 * A * Omega * zeta + m
    return 4.0 * A * (I * zeta + Omega * R)


def F_AOmega(Omega, A, m, zeta, h, h_A):
    """d2F/dA dOmega."""
    t0 = Omega.square()
    R = A * t0 + h
    t1 = A * Omega
    t2 = 2.0 * t1
    I = m + t2 * zeta
    return 4.0 * (I * zeta + Omega * R + t1 * (h_A + t0) + t2 * zeta.square())


def F_OmegaOmega(Omega, A, zeta, h):
    """d2F/dOmega2."""
    t0 = A * Omega.square()
    R = h + t0
    return 4.0 * A * (2.0 * A * zeta.square() + R + 2.0 * t0)


def backbone(A, h):
    """Frequency on the backbone."""
    turn = -h / A
    return turn.sqrt()


def level(Omega, A, m, zeta, h):
    """The forcing F_0 for which (Omega, A) is a steady state."""
    R = A * Omega.square() + h
    I = 2.0 * A * Omega * zeta + m
    return (I.square() + R.square()).sqrt()


def least_restoring(F_0, m):
    """The |h| of a state at Omega = 0, and the least |h - A h_A| of a fold."""
    return (F_0 - m).sqrt() * (F_0 + m).sqrt()


def intercept(A, h, h_A, h_AA):
    """k = h - A h_A, where the tangent of h meets A = 0, and its slope along A."""
    return -A * h_A + h, -A * h_AA


def F_Omega_reduced(Omega, A, m, zeta, h):
    """F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.

    Equation (34). Domain: Omega > 0, A > 0.
    """
    p = 2.0 * A * zeta.square() + h
    t0 = A * Omega.square()
    return Omega * (p + t0) + m * zeta, p + 3.0 * t0


def state_R(Omega, A, h, h_A, k):
    """R by its definition, and by its tangent along A, which meets A = 0 at k = h - A h_A.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    return A * t0 + h, A * (h_A + t0) + k


def state(Omega, A, F_0, m, zeta, h_A, h_AA, R):
    """F and its first two derivatives along A, by R (`state_R`).

    Equation (24), (30), (33). Domain: Omega > 0, A > 0.
    """
    t0 = 2.0 * Omega * zeta
    I = A * t0 + m
    t1 = Omega.square()
    t2 = h_A + t1
    return (
        R.square() + (-F_0 + I) * (F_0 + I),
        2.0 * (I * t0 + R * t2),
        2.0 * (R * h_AA + 4.0 * t1 * zeta.square() + t2.square()),
    )


def most_restoring(A, F_0, m, zeta):
    """The largest |h| of a state with this amplitude: F_0 + (A Omega)^2/A at the highest Omega."""
    c = -0.5 * (-F_0 + m) / zeta
    fastest = c / A
    return F_0 + c * fastest


def fold(A, F_0, m, zeta, h, h_A, k, k_A):
    """Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega."""
    excess = (F_0 - m) * (F_0 + m)
    least = excess.sqrt()
    t0 = 1.0 / k
    t1 = least * t0
    share = ((1.0 - t1) * (t1 + 1.0)).sqrt()
    J = excess / (F_0 + m * share)
    t2 = 1.0 / share
    lag = excess / (F_0 * t2 + m)
    t3 = J * t0
    t4 = 1.0 / (zeta.square())
    t5 = 1.0 / A
    t6 = t4 * t5
    t7 = 0.25 * lag.square()
    return (
        -F_0 * t3 + h + t6 * t7,
        F_0 * J.square() * k_A * (0.5 * t3 * t6 + (F_0 + m * t2) / excess) / (k.square()) + h_A - t4 * t7 /
        (A.square()),
        0.5 * lag * t5 / zeta,
    )


def isola_Omega(h_A):
    """Omega at an isola point."""
    return h_A.sqrt()


def isola(A, m, zeta, h, h_A, h_AA):
    """Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A."""
    w = h_A.sqrt()
    t0 = 2.0 * zeta.square()
    bracket = A * (h_A + t0) + h
    bracket_A = A * h_AA + 2.0 * h_A + t0
    return bracket * w + m * zeta, 0.5 * bracket * h_AA / w + bracket_A * w


def cusps(A, zeta, h, h_A, h_AA, k):
    """F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d."""
    t0 = zeta.square()
    half_e = 0.5 * A * h_AA + 2.0 * t0
    t1 = 4.0 * h_A * t0 - h_AA * k
    return half_e, -t1, h_A + half_e, h * h_AA + h_A.square(), half_e.square() + t1


def cusp_R(A, zeta, h_AA, k, X, T):
    """R where F_AA = 0 (`cusps`), in two forms: by its tangent, and from F_AA itself."""
    return A * T + k, (-T.square() - 4.0 * X * zeta.square()) / h_AA


def cusp(A, m, zeta, h_AA, h_AAA, k, X, T, R, root):
    """Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0."""
    w = X.sqrt()
    t0 = m * zeta
    t1 = 2.0 * t0 * w
    t2 = 4.0 * A * zeta.square()
    return (
        R * T + X * t2 + t1,
        -A * h_AA * k + T * (-A.square() * h_AA + k) + t1,
        0.5 * (R * h_AAA + 3.0 * T * h_AA) * (-A * T - R - t0 / w - t2) / root,
        (A * t1 + R * k + m.square()).sqrt(),
    )


def level_rise(Omega, A, m, zeta, h, h_A, h_AA):
    """Positive where the level rises with A along the fold locus, negative where it falls."""
    t0 = Omega.square()
    R = A * t0 + h
    t1 = A * Omega
    t2 = 2.0 * t1
    I = m + t2 * zeta
    t3 = h_A + t0
    t4 = zeta.square()
    F_AA = 2.0 * (R * h_AA + 4.0 * t0 * t4 + t3.square())
    t5 = I * zeta + Omega * R
    F_Omega = 4.0 * A * t5
    F_AOmega = 4.0 * (t1 * t3 + t2 * t4 + t5)
    return -F_AA * F_AOmega * F_Omega


def cusp_bend(Omega, A, zeta, h_AA, h_AAA, T):
    """Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum; T = dR/dA."""
    t0 = Omega.square()
    t1 = 4.0 * t0 * zeta.square()
    R = (-T.square() - t1) / h_AA
    F_AAA = 2.0 * (R * h_AAA + 3.0 * T * h_AA)
    t2 = 2.0 * t0
    t3 = 2.0 / Omega
    F_Omega = A * R * t3 * (-T + t2)
    F_AOmega = t3 * (A * T * t2 + A * t1 - R * T + R * t2)
    return -F_AAA * F_AOmega * F_Omega / A


def isola_bend(Omega, A, m, zeta, h_AA):
    """The same at an isola point."""
    t0 = 2.0 * A
    t1 = Omega * t0 * zeta + m
    R = -t1 * zeta / Omega
    Omega2 = Omega.square()
    t2 = 4.0 * zeta.square()
    Omega4 = Omega2.square()
    F_AA = 2.0 * (Omega2 * t2 + 4.0 * Omega4 + R * h_AA)
    Omega3 = Omega * Omega2
    Omega5 = Omega * Omega4
    return (
        8.0 * A * F_AA * t1 * zeta * (-Omega3 * h_AA * t0 - Omega3 * t2 - 4.0 * Omega5 + h_AA * m * zeta) / Omega2
    )


def isola_mu0(A, zeta, h, h_A, h_AA):
    """Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A."""
    t0 = 2.0 * zeta.square()
    bracket = A * (h_A + t0) + h
    bracket_A = A * h_AA + 2.0 * h_A + t0
    return bracket, bracket_A


def F_Omega_reduced_mu0(Omega, A, zeta, h):
    """F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.

    Equation (34). Domain: m = 0, Omega > 0, A > 0.
    """
    t0 = 2.0 * A
    p = h + t0 * zeta.square()
    return A * Omega.square() + p, Omega * t0


def fold_zeta0(F_0, m, k, k_A):
    """Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A."""
    excess = (F_0 - m) * (F_0 + m)
    least = excess.sqrt()
    return (k - least) * (k + least), 2.0 * k * k_A


def F_Omega_reduced_zeta0(Omega, A, h):
    """F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.

    Equation (34). Domain: zeta = 0, Omega > 0, A > 0.
    """
    return A * Omega.square() + h, 2.0 * A * Omega


def undamped_Omega(h_A):
    """Omega of the folds."""
    return (-h_A).sqrt()


def undamped_rises(h_AA, h_AAA, k):
    """The sign of the level's slope along A on the undamped folds; and, where that is 0, of the slope's own."""
    return -h_AA * k, -h_AAA * k
