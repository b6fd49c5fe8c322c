"""Cases in; tests/data/off_centre.json out: states and detachments off the centre to 40 digits, all there are.

    python -m tests.oracles.make_off_centre

The means of a polynomial force are typed here from those of powers. Of a Duffing oscillator the balance gives A^2 as a
quotient of polynomials in B; put into F = 0 it leaves one polynomial in B, whose roots python-flint isolates, each in a
ball: of a polynomial with real coefficients a root is real whose ball, which holds no other, meets the real axis. A
truncated isolator detaches where a polynomial in B vanishes, at A = u_cr - |B|; the frequency is a root of a cubic.
Every sign that a choice depends on is that of a whole ball.
"""

from __future__ import annotations

import random

from flint import acb_poly, arb, ctx, fmpq, fmpq_poly

from tests.files import store
from tests.oracles.averaged import DIGITS, _sign, exact

#: of roots of polynomials whose coefficients are balls
TOLERANCE = arb(10) ** -80
ANSWERS = {"duffing": "states", "isolator": "detachment"}


def ball(x: fmpq) -> arb:
    return arb(x.p) / arb(x.q)


def shown(x: arb) -> str:
    if x.rel_accuracy_bits() < 4 * DIGITS:
        raise ArithmeticError(f"{x} has too few digits")
    return x.mid().str(DIGITS, radius=False)


def real_roots(polynomial: fmpq_poly) -> list[arb]:
    """All real roots, each in a ball of its own; a double one is refused."""
    cleared = polynomial.numer()
    if cleared.gcd(cleared.derivative()).degree() > 0:
        raise ArithmeticError("a double root")
    return sorted((root.real for root, _ in cleared.complex_roots() if root.imag == 0), key=float)


def duffing(case: dict) -> list[dict]:
    """All states: A, B, and whether each is stable."""
    alpha, beta, zeta, load, Omega, F_0 = (
        exact(case[name]) for name in ("alpha", "beta", "zeta", "load", "Omega", "F_0")
    )
    B = fmpq_poly([0, 1])
    above, below = load - alpha * B - beta * B**3, fmpq(3, 2) * beta * B  # A^2 = above/below
    stiff = (Omega**2 - alpha - 3 * beta * B**2) * below - fmpq(3, 4) * beta * above
    lag = 4 * zeta**2 * Omega**2
    # A^2 ((Omega^2 - k)^2 + lag) times below^3
    smooth = above * (stiff**2 + lag * below**2)
    if case["mu"] == 0:
        polynomial = smooth - F_0**2 * below**3
        m = arb(0)
        roots = real_roots(polynomial)
    else:
        # m = 4 mu/pi is irrational: with mu' = 1/pi times a rational the polynomial is in pi; balls of acb do
        m = 4 * ball(exact(case["mu"])) / arb.pi()
        rest = [ball(x) for x in (smooth - F_0**2 * below**3).coeffs()]
        cube = [ball(x) for x in (below**3).coeffs()]
        total = [x + m * m * y for x, y in zip(rest, cube + [arb(0)] * (len(rest) - len(cube)), strict=True)]
        left = acb_poly(total) ** 2
        right = acb_poly([ball(x) for x in (4 * lag * above * below**5).coeffs()]) * (m * m)
        roots = sorted((root.real for root in (left - right).roots(tol=TOLERANCE) if root.imag.contains(0)), key=float)
    found = []
    for root in roots:
        square = ball_at(above, root) / ball_at(below, root)
        if _sign(square) < 0:
            continue
        A = square.sqrt()
        R = A * (ball(Omega**2 - alpha) - 3 * ball(beta) * root**2 - ball(fmpq(3, 4) * beta) * square)
        I = 2 * ball(zeta * Omega) * A + m
        off = R * R + I * I - ball(F_0**2)
        if not off.contains(0):  # the other sign of A, from squaring
            if not (R * R + (m - 2 * ball(zeta * Omega) * A) ** 2 - ball(F_0**2)).contains(0):
                raise ArithmeticError("a root that is none")
            continue
        c_1 = ball(alpha) + 3 * ball(beta) * root**2 + ball(fmpq(3, 2) * beta) * square
        s_1 = 3 * ball(beta) * A * root
        h_A = -(ball(alpha) + 3 * ball(beta) * root**2 + ball(fmpq(9, 4) * beta) * square) + 2 * s_1**2 / c_1
        turns = R * (ball(Omega**2) + h_A) + 2 * ball(zeta * Omega) * I
        found.append((A, root, _sign(turns) > 0 and _sign(c_1) > 0))
    found.sort(key=lambda one: float(one[0]))
    return [{"A": shown(A), "B": shown(B), "stable": stable} for A, B, stable in found]


def ball_at(polynomial: fmpq_poly, x: arb) -> arb:
    value = arb(0)
    for coefficient in reversed(polynomial.coeffs()):
        value = value * x + ball(coefficient)
    return value


def detachment(case: dict) -> dict:
    """The lowest forcing that brings |B| + A to u_cr, and where."""
    alpha, beta, gamma, u_cr = (exact(x) for x in case["parameters"])
    zeta, load, m = exact(case["zeta"]), exact(case["load"]), 4 * ball(exact(case["mu"])) / arb.pi()
    levels = []
    for side in (1, -1):
        B = fmpq_poly([0, 1])
        A = u_cr - side * B
        mean = alpha * B + beta * (B**3 + fmpq(3, 2) * A**2 * B)
        mean += gamma * (B**5 + 5 * A**2 * B**3 + fmpq(15, 8) * A**4 * B)
        for root in real_roots(mean - load):
            if _sign(side * root) < 0 or _sign(ball(u_cr) - side * root) < 0:
                continue
            amplitude = ball(u_cr) - side * root
            first = ball(alpha) * amplitude + ball(beta) * (3 * root**2 * amplitude + 3 * amplitude**3 / 4)
            first += ball(gamma) * (5 * root**4 * amplitude + 15 * root**2 * amplitude**3 / 2 + 5 * amplitude**5 / 8)
            levels += [(level, Omega, amplitude, root) for level, Omega in least(amplitude, -first, m, ball(zeta))]
    level, Omega, amplitude, root = min(levels, key=lambda one: float(one[0]))
    if not all(other is level or other > level for other, *_ in levels):
        raise ArithmeticError("two levels are not told apart")
    return {"F_cr": shown(level), "Omega_cr": shown(Omega), "A": shown(amplitude), "B": shown(root)}


def least(A: arb, h: arb, m: arb, zeta: arb) -> list[tuple[arb, arb]]:
    """Where R^2 + I^2 is stationary in Omega > 0: Omega (A Omega^2 + h) + zeta (2 zeta A Omega + m) = 0."""
    cubic = acb_poly([zeta * m, h + 2 * zeta**2 * A, 0, A])
    found = []
    for root in cubic.roots(tol=TOLERANCE):
        Omega = root.real
        if root.imag.contains(0) and _sign(Omega) > 0:
            R, I = A * Omega**2 + h, 2 * zeta * A * Omega + m
            found.append(((R * R + I * I).sqrt(), Omega))
    static = (h * h + m * m).sqrt()
    if any(not level < static for level, _ in found[-1:]):
        raise ArithmeticError("the static state may be lower: another case")
    return found


def cases() -> list[dict]:
    """Drawn with a fixed seed: springs that harden, soften and have two wells, with and without friction."""
    rng = random.Random(20)
    drawn = []
    for number in range(24):
        alpha, beta = ((1.0, rng.uniform(0.2, 2.0)), (1.0, -rng.uniform(0.05, 0.3)), (-rng.uniform(0.2, 0.8), 1.0))[
            number % 3
        ]
        drawn.append(
            {
                "kind": "duffing",
                "alpha": alpha,
                "beta": beta,
                "mu": 0.0 if number % 2 else rng.uniform(0.001, 0.01),
                "zeta": rng.uniform(0.02, 0.08),
                "load": rng.choice((-1, 1)) * rng.uniform(0.005, 0.3),
                "Omega": rng.uniform(0.6, 1.5),
                "F_0": rng.uniform(0.03, 0.3),
            }
        )
    for _ in range(12):
        drawn.append(
            {
                "kind": "isolator",
                "parameters": [
                    rng.uniform(0.3, 0.9),
                    rng.uniform(1.0, 3.0),
                    rng.uniform(1.0, 3.0),
                    rng.uniform(0.2, 0.5),
                ],
                "mu": rng.uniform(0.0, 0.015),
                "zeta": rng.uniform(0.01, 0.05),
                "load": rng.choice((-1, 1)) * rng.uniform(0.005, 0.1),
            }
        )
    return drawn


def main() -> None:
    ctx.prec = 800
    rows = []
    for case in cases():
        try:
            question = {"duffing": duffing, "isolator": detachment}[case["kind"]]
            found = {ANSWERS[case["kind"]]: question(case)}
        except ArithmeticError as error:
            print(f"left out, {error}: {case}")
            continue
        rows.append({**case, **found})
    store("off_centre", rows)


if __name__ == "__main__":
    main()
