"""The slow flow by its definition. Takes Omega, A, F_0, damping and h; returns what its kernels are to give."""

from __future__ import annotations

from mpmath import mp, mpf

from tests.oracles.definitions.laws import BY_A, balances, by_laws, derivative, near, polynomial
from tests.oracles.definitions.points import Definitions


def phase(Omega, A, m, zeta, h):
    R, I = balances(Omega, A, m, zeta, h)
    if I == 0:  # the limit of vanishing damping: I > 0 keeps phi below zero
        return -mp.pi if R > 0 else mpf(0)
    return mp.arg(mp.mpc(-R, -I))


def rates(Omega, A, phi, F_0, m, zeta, h):
    """(19): the averaged A' and phi'."""
    return (
        -(F_0 * mp.sin(phi) + 2 * zeta * Omega * A + m) / (2 * Omega),
        -(F_0 * mp.cos(phi) + Omega**2 * A + h) / (2 * Omega * A),
    )


def jacobian(Omega, A, m, zeta, h, h_A):
    R, I = balances(Omega, A, m, zeta, h)
    F_0, phi = mp.sqrt(R**2 + I**2), mp.arg(mp.mpc(-R, -I))
    local = near(A, (h, h_A))
    entries = []
    for k in (0, 1):
        for by in ((1, 0), (0, 1)):
            entry = mp.diff(lambda a, f, k=k: rates(Omega, a, f, F_0, m, zeta, local(a))[k], (A, phi), by)
            entries.append(mp.chop(entry, tol=mpf(10) ** -45))
    return entries


def stability(Omega, A, m, zeta, h, h_A):
    J11, J12, J21, J22 = jacobian(Omega, A, m, zeta, h, h_A)
    return 4 * Omega**2 * (J11 * J22 - J12 * J21)


def cubic(A, h, h_A):
    """f' of the spring alpha u + beta u^3 that has this h = -alpha A - 3/4 beta A^3 and h_A at A."""
    beta = 2 * (h - A * h_A) / (3 * A**3)
    alpha = -h / A - mpf(3) / 4 * beta * A**2
    return lambda u: alpha + 3 * beta * u**2


def stiffness_harmonic(A, h, h_A, n):
    """Mean of f'(A cos psi) cos(n psi) over a cycle, by quadrature."""
    slope = cubic(A, h, h_A)
    return mp.quad(lambda psi: slope(A * mp.cos(psi)) * mp.cos(n * psi), [0, mp.pi], method="gauss-legendre") / mp.pi


def mean_stiffness(A, h, h_A):
    return stiffness_harmonic(A, h, h_A, 0)


def offset_stiffness(Omega, A, h, h_A):
    """From the balance of B + b cos 2 psi: b by the second harmonic's, put into the mean's."""
    k_0, k_2 = (stiffness_harmonic(A, h, h_A, n) for n in (0, 2))
    return k_0 + k_2 * (2 * k_2 / (4 * Omega**2 - k_0))


def dissipated(Omega, A, m, zeta):
    """Work of both dampings over a cycle of u = A cos psi, by quadrature; mu = pi m/4."""
    speed = lambda psi: A * Omega * mp.sin(psi)  # noqa: E731
    power = lambda psi: 2 * zeta * speed(psi) ** 2 + mp.pi * m / 4 * abs(speed(psi))  # noqa: E731
    return 2 * mp.quad(power, [0, mp.pi], method="gauss-legendre") / Omega


def equivalent_damping(Omega, A, m, zeta):
    """The ratio of a purely viscous damping that does the same work."""
    return zeta * 0 + dissipated(Omega, A, m, zeta) / dissipated(Omega, A, 0, mpf(1))


def transmissibility(Omega, A, F_0, m, zeta, h):
    """Harmonics of f(u) + 2 zeta u' + mu sign(u'): the force's is -h by definition, the damping's by quadrature."""
    damping = lambda psi: -2 * zeta * A * Omega * mp.sin(psi) - mp.pi * m / 4  # noqa: E731
    sine = 2 / mp.pi * mp.quad(lambda psi: damping(psi) * mp.sin(psi), [0, mp.pi], method="gauss-legendre")
    return mp.hypot(h, sine) / F_0


def components(Omega, A, m, h, h_3, h_5):
    """Largest displacement, first harmonic, sine and cosine of the turn, a_3, a_5, kappa; of h, h_3, h_5 at A."""
    K = -h / A
    a_3, a_5 = (-h_n / (n**2 * Omega**2 - K) for n, h_n in ((3, h_3), (5, h_5)))
    A_1 = A - a_3 - a_5
    # sum over odd n of 1/(n^2 - kappa) is pi tan(pi k/2)/(4 k), k^2 = kappa
    k = mp.sqrt(K) / Omega
    sine = -m / (A_1 * Omega**2) * mp.re(mp.pi * mp.tan(mp.pi * k / 2) / (4 * k) - 1 / (1 - k**2))
    turned = mp.asin(sine)
    u_max = A_1 * mp.cos(turned) + a_3 + a_5
    return [u_max, A_1, sine, mp.cos(turned), a_3, a_5, K / Omega**2]


def wave(turned, Omega, m, A_1, sine, cosine, a_3, a_5, kappa):
    """u and u', friction's harmonics by the closed sums of their waves over half a cycle."""
    k, x = mp.sqrt(kappa), mp.pi / 2 - turned
    whole = mp.re(mp.cos(k * x) / mp.cos(k * mp.pi / 2))
    of_u = mp.pi / (4 * kappa) * (whole - 1) - mp.sin(turned) / (1 - kappa)
    of_v = mp.re(mp.pi / (4 * k) * mp.sin(k * x) / mp.cos(k * mp.pi / 2)) - mp.cos(turned) / (1 - kappa)
    c, s = mp.cos(turned), mp.sin(turned)
    u = A_1 * (c * cosine - s * sine) - m / Omega**2 * of_u
    v = -A_1 * (s * cosine + c * sine) - m / Omega**2 * of_v
    for n, a_n in ((3, a_3), (5, a_5)):
        u, v = u + a_n * mp.cos(n * turned), v - n * a_n * mp.sin(n * turned)
    return [u, Omega * v]


def second(Omega, A, m, zeta, h, h_3, h_5):
    """The balance with harmonics: R, I, largest displacement, first harmonic; h, h_3, h_5 are functions of A."""
    u_max, A_1, sine, _, a_3, a_5, _ = components(Omega, A, m, h(A), h_3(A), h_5(A))
    # force of A cos psi + a_3 (cos 3 psi - cos psi) + a_5 (cos 5 psi - cos psi), to first order in a_3, a_5
    shares = (mp.diff(lambda a, h_n=h_n: h_n(a) - h(a), A) for h_n in (h_3, h_5))
    R = A_1 * Omega**2 + h(A) + sum(a_n * slope for a_n, slope in zip((a_3, a_5), shares, strict=True))
    # power of the forcing is what friction, 4 mu u_max a cycle, and viscosity take
    I = 2 * zeta * Omega * (A_1**2 + 9 * a_3**2 + 25 * a_5**2) / A_1 + m * u_max / A_1
    return R - m * sine, I, u_max, A_1


def second_kernel(kernel):
    """The kernels of the second approximation; derivatives numerically."""
    if kernel in ("components", "wave"):
        return {"components": components, "wave": wave}[kernel]
    orders = 4 if kernel == "folds" else 3

    def of(Omega, A, *x):
        F_0, m, zeta, *averages = (mpf(0), *x) if kernel.startswith("detachment") else x
        families = [near(A, averages[k * orders : (k + 1) * orders]) for k in range(3)]

        def at(w, a):
            return second(w, a, m, zeta, *families)

        def F(w, a):
            R, I, *_ = at(w, a)
            return R**2 + I**2 - F_0**2

        def slope(f, by):
            return mp.diff(f, (Omega, A), by)

        R, I, u_max, A_1 = at(Omega, A)
        F_Omega, F_A = slope(F, (1, 0)), slope(F, (0, 1))
        if kernel == "folds":
            return [F(Omega, A), F_A, slope(F, (0, 2))]
        if kernel == "detachment":
            by_A, by_Omega = (slope(lambda w, a: at(w, a)[2], by) for by in ((0, 1), (1, 0)))
            return [mp.sqrt(R**2 + I**2), u_max, F_Omega * by_A - F_A * by_Omega]
        if kernel == "detachment_by_inertia":

            def level_squared(w, a):
                return (F(w, a) + F_0**2) / w**4

            (by_A, by_Omega), (rise, tangential) = (
                [slope(f, by) for by in ((0, 1), (1, 0))] for f in (lambda w, a: at(w, a)[2], level_squared)
            )
            return [mp.sqrt(R**2 + I**2) / Omega**2, u_max, Omega**4 * (tangential * by_A - rise * by_Omega)]
        slopes = [slope(lambda w, a: at(w, a)[0], by) for by in ((0, 1), (1, 0))]
        return [u_max, A_1, mp.arg(mp.mpc(-R, -I)), R, F(Omega, A), F_A, F_Omega, *slopes]

    return of


SLOW_FLOW: Definitions = {
    "friction": ("mu", lambda mu: [4 * mu / mp.pi]),
    "R": by_laws("Omega A h", lambda laws: laws.R.value),
    "I": by_laws("Omega A m zeta", lambda laws: laws.I.value),
    "F": derivative("F", "Omega A F_0 m zeta h"),
    "F_A": derivative("F_A", "Omega A m zeta h h_A"),
    "F_AA": derivative("F_AA", "Omega A m zeta h h_A h_AA"),
    "F_Omega": derivative("F_Omega", "Omega A m zeta h"),
    "F_AOmega": derivative("F_AOmega", "Omega A m zeta h h_A"),
    "phase": ("Omega A m zeta h", lambda *x: [phase(*x)]),
    "backbone": ("A h", lambda A, h: [mp.findroot(lambda w: balances(w, A, 0, 0, h)[0], mp.sqrt(-h / A))]),
    "limit_envelope": (
        "Omega F_0 m zeta",
        lambda w, F_0, m, zeta: [(F_0 - m) / balances(w, 1, 0, zeta, 0)[1] if zeta else mp.inf],
    ),
    "equivalent_damping": ("Omega A m zeta", lambda *x: [equivalent_damping(*x)]),
    "transmissibility": ("Omega A F_0 m zeta h", lambda *x: [transmissibility(*x)]),
    "jacobian": ("Omega A m zeta h h_A", jacobian),
    "mean_stiffness": ("A h h_A", lambda A, h, h_A: [mean_stiffness(A, h, h_A)]),
    "offset_stiffness": ("Omega A h h_A", lambda *x: [offset_stiffness(*x)]),
    "stability": ("Omega A m zeta h h_A", lambda *x: [stability(*x)]),
    "response_quartic": polynomial("F", (0, 1, 2, 4), "A F_0 m zeta h"),
    "fold_quartic": polynomial("F_A", (0, 1, 2, 4), "A m zeta h h_A", lambda at: 2),
    "peak_cubic": polynomial("F_Omega", (0, 1, 3), "A m zeta h", lambda at: 4 * at["A"]),
}

FAMILIES = {top: " ".join(name + by for name in ("h", "h_3", "h_5") for by in BY_A[:top]) for top in (3, 4)}
SECOND: Definitions = {
    kernel: (names, second_kernel(kernel))
    for kernel, names in {
        "response": f"Omega A F_0 m zeta {FAMILIES[3]}",
        "folds": f"Omega A F_0 m zeta {FAMILIES[4]}",
        "detachment": f"Omega A m zeta {FAMILIES[3]}",
        "detachment_by_inertia": f"Omega A m zeta {FAMILIES[3]}",
        "components": "Omega A m h h_3 h_5",
        "wave": "turned Omega m A_1 sine cosine a_3 a_5 kappa",
    }.items()
}


def beside_resonances(_: str, names: list[str], number: int, x: list[float]) -> None:
    """|h| < 9 A Omega^2; half of the points next to the backbone."""
    at = dict(zip(names, x, strict=True))
    if number % 2:
        at |= {"kappa": 1 + 1e-6} if "kappa" in at else {}
    if "h" in at:
        kappa = 1 + 1e-6 if number % 2 else -0.5 - 8.5 * at["h"]
        at["h"] = -at["A"] * at["Omega"] ** 2 * kappa
    x[:] = at.values()
