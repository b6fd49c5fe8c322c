"""Random isolators and the paper's (Table 1), for the tests of the exact motion."""

import math
from dataclasses import dataclass

import numpy as np

from slowflow import Duffing, Isolator
from slowflow.exact import EquationOfMotion
from slowflow.example import TABLE_1


@dataclass(frozen=True)
class Case:
    """An oscillator and a forcing."""

    system: EquationOfMotion
    Omega: float
    F_0: float


def isolator(lam, r, delta_h, mu, zeta, exact):
    """EquationOfMotion and its force by hand, (5) or (6) and u beyond u_cr: pieces, and where they end."""
    u_cr = math.sqrt(1 - (1 - delta_h) ** 2)
    iso = Isolator(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta)
    if exact:

        def attached(u):
            root = math.sqrt(1 - u * u)
            return u + lam * r * (1 - delta_h - root) * u / root

        return iso.equation_of_motion("untruncated"), ((attached, lambda u: u), (u_cr,))
    # equation (7)
    alpha = 1 - lam * r * delta_h
    beta, gamma = lam / 2 * r * (1 - delta_h), 3 / 8 * lam * r * (1 - delta_h)
    inner = lambda u: alpha * u + beta * u**3 + gamma * u**5  # noqa: E731
    return iso.equation_of_motion(), ((inner, lambda u: u), (u_cr,))


def table_1(exact):
    """The paper's isolator."""
    return isolator(**TABLE_1, exact=exact)[0]


def random_cases(count, seed):
    """Isolators over the paper's ranges and beyond, a fifth of them without friction, two fifths at low frequency."""
    rng = np.random.default_rng(seed)
    cases = []
    while len(cases) < count:
        lam, r = int(rng.integers(1, 5)), rng.uniform(0.5, 3)
        delta_h = (1 - rng.uniform(0.05, 0.95)) / (lam * r)
        if delta_h > 0.6:
            continue
        n = len(cases)
        F_0 = rng.uniform(0.02, 0.3)
        mu = 0.0 if n % 5 == 0 else F_0 * rng.uniform(0.05, 0.9)
        Omega = rng.uniform(0.08, 0.3) if n % 5 in (1, 3) else rng.uniform(0.3, 1.3)
        if n % 10 == 6:  # several stops each way
            mu, Omega = F_0 * rng.uniform(0.1, 0.3), rng.uniform(0.05, 0.15)
        system, _ = isolator(lam, r, delta_h, mu, rng.uniform(0.005, 0.1), exact=bool(n % 2))
        cases.append(Case(system, float(Omega), float(F_0)))
    return cases


#: what may act on a mass beside its spring, viscous damping and friction, for a share of the force
LAWS = (
    lambda rng, F_0: {},
    lambda rng, F_0: {"c_2": rng.uniform(0.05, 0.5)},
    lambda rng, F_0: {"mu_s": F_0 * rng.uniform(0.5, 0.95)},
    lambda rng, F_0: {"excitation": str(rng.choice(["base", "unbalance"]))},
    lambda rng, F_0: {"load": F_0 * rng.uniform(-0.5, 0.5)},
    lambda rng, F_0: {"contact": "attached"},
)


def random_motions(count, seed):
    """(system, Omega, F_0) of isolators with either force and of Duffing oscillators, with each of LAWS in turn.

    A third of them at low frequencies, a sixth without friction.
    """
    rng = np.random.default_rng(seed)
    found = []
    while len(found) < count:
        n = len(found)
        law = n % len(LAWS)
        Omega, F_0 = (
            float(rng.uniform(0.1, 0.3) if n % 3 == 1 else rng.uniform(0.3, 1.3)),
            float(rng.uniform(0.02, 0.2)),
        )
        damping = LAWS[law](rng, F_0)
        inertial = "excitation" in damping
        force = F_0 * Omega**2 if inertial else F_0
        own = {"mu": 0.0 if n % 36 < 6 and "contact" not in damping else force * rng.uniform(0.05, 0.5)}
        own["zeta"] = rng.uniform(0.005, 0.1)
        if n // len(LAWS) % 3 == 2:
            damping.pop("contact", None)  # its force has one piece
            one = Duffing(rng.uniform(0.2, 1.5), rng.uniform(0.0, 1.0), **own, **damping)
        else:
            lam, r = int(rng.integers(1, 5)), rng.uniform(0.5, 3)
            delta_h = (1 - rng.uniform(0.05, 0.95)) / (lam * r)
            if delta_h > 0.6:
                continue
            one = Isolator(lam=lam, r=r, delta_h=delta_h, **own, **damping)
        which = ("truncated", "untruncated")[n % 2] if isinstance(one, Isolator) else None
        found.append((one.equation_of_motion(which), Omega, F_0))
    return found
