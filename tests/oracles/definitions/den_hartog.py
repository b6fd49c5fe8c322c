"""Den Hartog's solution from its four linear conditions, for one stop and for none."""

from __future__ import annotations

from mpmath import mp, mpf

from tests.oracles.definitions.points import RANGES, Definitions


def half_cycle(Omega, A, mu):
    """B, C, p, q of u = mu + V(p cos - q sin)(Omega tau) + B cos tau + C sin tau, from (A, 0) to (-A, 0)."""
    end, V = mp.pi / Omega, 1 / (1 - Omega**2)

    def row(tau):
        return [mp.cos(tau), mp.sin(tau), V * mp.cos(Omega * tau), -V * mp.sin(Omega * tau)]

    def slope(tau):
        return [-mp.sin(tau), mp.cos(tau), -V * Omega * mp.sin(Omega * tau), -V * Omega * mp.cos(Omega * tau)]

    matrix = mp.matrix([row(mpf(0)), slope(mpf(0)), row(end), slope(end)])
    with mp.extradps(30):
        return list(mp.lu_solve(matrix, mp.matrix([A - mu, 0, -A - mu, 0])))


def motion(tau, Omega, A, mu):
    B, C, p, q = half_cycle(Omega, A, mu)
    V = 1 / (1 - Omega**2)
    return mu + V * (p * mp.cos(Omega * tau) - q * mp.sin(Omega * tau)) + B * mp.cos(tau) + C * mp.sin(tau)


def forcing(Omega, A, mu):
    _, _, p, q = half_cycle(Omega, A, mu)
    return mp.hypot(p, q)


def exact_V(Omega):
    """Without friction the forced motion is A = V p."""
    return [1 / half_cycle(Omega, mpf(1), mpf(0))[2]]


def exact_U(Omega):
    return [-half_cycle(Omega, mpf(0), mpf(1))[3] * exact_V(Omega)[0]]


def exact_amplitude(Omega, F_0, mu):
    V, U = exact_V(Omega)[0], exact_U(Omega)[0]
    guess = mp.sqrt(F_0**2 * V**2 - mu**2 * U**2)
    return [mp.findroot(lambda A: forcing(Omega, A, mu) - F_0, guess)]


def exact_bound(Omega, F_0, S):
    """The amplitude at which A = mu S/Omega^2: forcing is proportional to A there."""
    return [F_0 / forcing(Omega, mpf(1), Omega**2 / S)]


def slope_ratio(tau, Omega):
    """u' = -A Omega sin(Omega tau) + mu g: the second share alone, times Omega/sin(Omega tau)."""
    g = mp.diff(lambda t: motion(t, Omega, mpf(0), mpf(1)), tau)
    return [Omega * g / mp.sin(Omega * tau)]


DEN_HARTOG: Definitions = {
    "V": ("Omega", exact_V),
    "U": ("Omega", exact_U),
    "S_ratio": ("tau Omega", slope_ratio),
    "amplitude": ("Omega F_0 mu", exact_amplitude),
    "bound": ("Omega F_0 S", exact_bound),
    "motion": ("tau Omega A mu", lambda *x: [motion(*x)]),
}

FREQUENCIES_OF_POINTS = (0.4, 0.45, 0.55, 0.7, 0.9, 0.999, 1.0 + 1e-9, 1.001, 1.1, 1.5, 2.0, 3.0)

BETWEEN = {**RANGES, "tau": (0.05, 0.5)}


def place(_: str, names: list[str], number: int, x: list[float]) -> None:
    """Friction small enough for a steady motion; tau in the first half of the half-cycle, where S is attained."""
    at = dict(zip(names, x, strict=True))
    at["Omega"] = Omega = FREQUENCIES_OF_POINTS[number % 12]
    if "mu" in at:
        most = at.get("F_0", at.get("A")) * abs(float(exact_V(mpf(Omega))[0] / exact_U(mpf(Omega))[0]))
        at["mu"] = most * (0.1 + 40 * at["mu"])
    if "tau" in at:
        at["tau"] = 1e-6 if number < 12 else at["tau"] * float(mp.pi) / Omega
    x[:] = at.values()
