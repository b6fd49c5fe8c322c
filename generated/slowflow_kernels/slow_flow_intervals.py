"""Slow flow of any mechanism, in h = H - A and its derivatives: on whole intervals.

Written by `make derive`; never edit.
Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/offset.py, derivations/along.py, derivations/slopes.py, derivations/bounds.py, derivations/gradients.py, derivations/newton.py, derivations/resultants.py
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Each output holds every value that the function of the same name takes on the arguments: objects with operators and
the methods `square` and `sqrt`.
"""

# a formatter would spread each polynomial over a page
# fmt: off

__all__ = [
    "cusp",
    "cusp_R",
    "cusps",
    "F_A",
    "F_AA",
    "fold",
    "fold_quartic",
    "isola",
    "peak",
    "peak_cubic",
]


def F_A(Omega, A, m, zeta, h, h_A):
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    R = A * t0 + h
    t1 = 2.0 * Omega * zeta
    I = A * t1 + m
    return (
        2.0 * (I * t1 + R * (h_A + t0))
    )


def F_AA(Omega, A, m, zeta, h, h_A, h_AA):
    """d2F/dA2.

    Equation (24), (33). Domain: Omega > 0, A > 0.
    """
    t0 = Omega.square()
    R = A * t0 + h
    t1 = h_A + t0
    return (
        2.0 * (R * h_AA + 4.0 * t0 * zeta.square() + t1.square())
    )


def fold_quartic(A, m, zeta, h, h_A):
    """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24), (30). Domain: A > 0.
    """
    return (
        h * h_A,
        2.0 * m * zeta,
        A * (h_A + 4.0 * zeta.square()) + h,
        A,
    )


def peak_cubic(A, m, zeta, h):
    """F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.

    Equation (34). Domain: A > 0.
    """
    return (
        m * zeta,
        2.0 * A * zeta.square() + h,
        A,
    )


def fold(A, F_0, m, zeta, h, h_A, k, k_A):
    """Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega.

    Equation from (24), (30). Domain: A > 0, F_0 > m, k^2 >= F_0^2 - m^2.
    """
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


def isola(A, m, zeta, h, h_A, h_AA):
    """Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A.

    Equation from (30), (34). Domain: A > 0, h_A > 0; for m = 0 any h_A.
    """
    w = h_A.sqrt()
    t0 = 2.0 * zeta.square()
    bracket = A * (h_A + t0) + h
    bracket_A = A * h_AA + 2.0 * h_A + t0
    return (
        bracket * w + m * zeta,
        0.5 * bracket * h_AA / w + bracket_A * w,
    )


def cusps(A, zeta, h, h_A, h_AA, k):
    """F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d.

    Equation from (33). Domain: A > 0.
    """
    t0 = zeta.square()
    half_e = 0.5 * A * h_AA + 2.0 * t0
    t1 = 4.0 * h_A * t0 - h_AA * k
    return (
        half_e,
        -t1,
        h_A + half_e,
        h * h_AA + h_A.square(),
        half_e.square() + t1,
    )


def cusp_R(A, zeta, h_AA, k, X, T):
    """R where F_AA = 0 (`cusps`), in two forms: by its tangent, and from F_AA itself.

    Equation from (33). Domain: A > 0, X >= 0.
    """
    return (
        A * T + k,
        (-T.square() - 4.0 * X * zeta.square()) / h_AA,
    )


def cusp(A, m, zeta, h_AA, h_AAA, k, X, T, R, root):
    """Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0.

    Equation from (33). Domain: A > 0, X > 0.
    """
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


def peak(Omega, A, F_0, m, zeta, h_A):
    """F where F_Omega = 0: an extremum of F over Omega, and its slope along A.

    Equation from (24), (34). Domain: Omega > 0, A > 0.
    """
    t0 = 2.0 * A
    R = -t0 * zeta.square() - m * zeta / Omega
    I = Omega * t0 * zeta + m
    return (
        R.square() + (-F_0 + I) * (F_0 + I),
        -2.0 * R * (Omega.square() - h_A),
    )
