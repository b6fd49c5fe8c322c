"""Cases in; tests/data/exact_motions.json out: motions and folds of the equation of motion (3) to 40 digits.

    python -m tests.oracles.make_exact_motions

A half-wave symmetric motion without rest is a pair (A, theta) that half a turn takes from (u, v) = (A, 0) to (-A, 0);
a fold is one for which the derivative of that map by (A, theta) is singular, too. Half a turn is integrated by power
series of 100 terms in FLINT's arithmetic of 320 bits, from breakpoint to breakpoint; derivatives are differences over
2^-83. Nothing but Table 1 is shared with the package: the forces are typed from (5), (6) and Duffing's, and the values
that a search starts from are typed in, too. Half an hour of one processor.
"""

from collections.abc import Callable

from flint import arb, arb_mat, arb_poly, arb_series, ctx

from slowflow.example import TABLE_1
from tests.files import store
from tests.oracles.certified_roots import precision

BITS, TERMS, DIGITS = 320, 100, 40
NOTHING = arb(2) ** -290
LONGEST = arb("0.4").mid()  # step, within which the mass does not come back to a breakpoint
APART = arb(2) ** -83  # exact: of the values whose difference is a derivative
FURTHER = arb(2) ** -67  # of those whose difference is a second one: Newton's iteration needs no more

WITHOUT_FRICTION = TABLE_1 | {"mu": 0.0}
HARDENING = {"alpha": 1.0, "beta": 0.1, "mu": 0.0, "zeta": 0.025}
RUBBING = {"alpha": 0.3, "beta": 1.5, "mu": 0.01, "zeta": 0.03}
SHAKEN = TABLE_1 | {"excitation": "base"}
HARDENING_SHAKEN = HARDENING | {"excitation": "base"}
#: force, its numbers, F_0, Omega or None for a fold, then A, theta and Omega to start from
CASES: tuple[tuple[str, dict[str, float], float, float | None, tuple[float, ...]], ...] = (
    ("untruncated", TABLE_1, 0.04, 0.9, (0.408, 0.84)),
    ("untruncated", TABLE_1, 0.04, 0.9, (0.123, 2.59)),
    ("untruncated", TABLE_1, 0.04, 1.2, (0.0374, 2.63)),
    ("truncated", TABLE_1, 0.04, 0.9, (0.410, 0.84)),
    ("truncated", TABLE_1, 0.04, 0.9, (0.312, 2.40)),
    ("duffing", HARDENING, 0.18, 1.2, (2.287, 2.29)),
    ("untruncated", TABLE_1, 0.04, None, (0.2039, 2.52, 0.8663)),
    ("untruncated", TABLE_1, 0.04, None, (0.5581, 1.93, 0.9933)),
    ("truncated", TABLE_1, 0.04, None, (0.2040, 2.52, 0.8663)),
    ("truncated", TABLE_1, 0.04, None, (0.5596, 1.92, 0.9930)),
    ("untruncated", WITHOUT_FRICTION, 0.04, None, (0.2098, 2.96, 0.8847)),
    ("untruncated", WITHOUT_FRICTION, 0.04, None, (0.6328, 2.45, 1.0117)),
    ("duffing", HARDENING, 0.18, None, (1.085, 2.80, 1.1157)),
    ("duffing", HARDENING, 0.18, None, (2.872, 1.62, 1.2696)),
    ("duffing", RUBBING, 0.06, None, (0.2997, 2.67, 0.7619)),
    ("duffing", RUBBING, 0.06, None, (0.7983, 1.61, 0.9995)),
    ("untruncated", SHAKEN, 0.05, 0.95, (0.106, 2.66)),
    ("untruncated", SHAKEN, 0.05, None, (0.1968, 2.466, 0.8537)),
    ("untruncated", SHAKEN, 0.05, None, (0.5932, 2.262, 1.0120)),
    ("truncated", SHAKEN, 0.05, None, (0.5960, 2.258, 1.0118)),
    ("duffing", HARDENING_SHAKEN, 0.1, None, (0.9574, 2.686, 1.0860)),
)

#: u, a series of Taylor's in time, in; the restoring force out
Piece = Callable[[arb_series], arb_series]


def forces(kind: str, numbers: dict[str, float]) -> tuple[list[Piece], arb | None]:
    """The pieces of the whole restoring force by rising |u|, and the breakpoint."""
    if kind == "duffing":
        return [lambda u: u * (numbers["alpha"] + numbers["beta"] * (u * u))], None
    springs, left = arb(numbers["lam"]) * arb(numbers["r"]), 1 - arb(numbers["delta_h"])

    def untruncated(u: arb_series) -> arb_series:
        return u * (1 - springs + springs * left / (1 - u * u).sqrt())

    def truncated(u: arb_series) -> arb_series:
        square = u * u
        return u * (1 - springs * (1 - left) + springs * left * square * (arb(1) / 2 + arb(3) / 8 * square))

    return [untruncated if kind == "untruncated" else truncated, lambda u: u], (1 - left * left).sqrt()


def expanded(piece: Piece, u: arb, v: arb, theta: arb, Omega: arb, F_0: arb, zeta: arb, mu: arb) -> arb_poly:
    """The series of u(t) for a mass that moves downwards: u'' = F_0 cos(theta + Omega t) - f(u) - 2 zeta u' + mu."""
    x = arb_series([u, v])
    # by u' = e^(-2 zeta t) (v + int e^(2 zeta t) push dt), each time two coefficients more
    for ctx.cap in range(4, TERMS + 1, 2):
        grows = arb_series([0, 2 * zeta]).exp()
        push = F_0 * arb_series([theta, Omega]).cos() - piece(x) + mu
        x = u + ((v + (grows * push).integral()) / grows).integral()
    return arb_poly(x.coeffs())


def at(x: arb_poly, t: arb) -> tuple[arb, arb]:
    """u and v at t, rounded to the middles of their balls."""
    return x(t).mid(), x.derivative()(t).mid()


def half_turn(case: tuple[str, dict[str, float], float], A: arb, theta: arb, Omega: arb) -> tuple[arb, arb]:
    """(u + A, v) half a turn after the maximum A at phase theta."""
    kind, numbers, F_0 = case
    pieces, u_cr = forces(kind, numbers)
    zeta, mu = arb(numbers["zeta"]), arb(numbers["mu"])
    # of a base that shakes F_0 is the amplitude: its acceleration is that times Omega^2
    force = arb(F_0) * Omega**2 if "excitation" in numbers else arb(F_0)
    # downwards through the regions; what ends each
    if u_cr is not None and A > u_cr:
        course = [(pieces[1], u_cr), (pieces[0], -u_cr), (pieces[1], None)]
    else:
        course = [(pieces[0], None)]
    u, v, passed, end = A, arb(0), arb(0), arb.pi() / Omega
    for piece, edge in course:
        while True:
            x = expanded(piece, u, v, theta + Omega * passed, Omega, force, zeta, mu)
            scale = max(abs(x[0].mid()), abs(x[1].mid()), abs(x[2].mid()))
            tail = max(abs(x[TERMS - 1].mid()), abs(x[TERMS - 2].mid()))
            step = min(LONGEST, ((scale * NOTHING / tail).log() / (TERMS - 1)).exp().mid())
            last = not passed + step < end
            step = (end - passed).mid() if last else step
            there, rate = at(x, step)
            if edge is not None and there < edge:
                step = crossing(x, edge, step)
                u, v = edge.mid(), at(x, step)[1]
                passed = (passed + step).mid()
                break
            u, v, passed = there, rate, (passed + step).mid()
            if last:
                return (u + A).mid(), v
    raise AssertionError("half a turn ends before a breakpoint is met")


def crossing(x: arb_poly, edge: arb, step: arb) -> arb:
    """Where u falls through the edge within the step, by Newton's iteration."""
    t = step
    for _ in range(60):
        u, v = at(x, t)
        change = ((u - edge) / v).mid()
        t = (t - change).mid()
        if abs(change) < NOTHING:
            return t
    raise AssertionError("a breakpoint's time does not converge")


def residual(
    case: tuple[str, dict[str, float], float], fold: bool, unknowns: list[arb], Omega: arb | None
) -> list[arb]:
    """Residuals of a motion or a fold."""
    A, theta, frequency = (*unknowns, Omega) if Omega is not None else unknowns
    out = list(half_turn(case, A, theta, frequency))
    if fold:
        (a, b), (c, d) = (
            [
                (more - less) / (2 * APART)
                for more, less in zip(
                    half_turn(case, A + dA, theta + dt, frequency),
                    half_turn(case, A - dA, theta - dt, frequency),
                    strict=True,
                )
            ]
            for dA, dt in ((APART, arb(0)), (arb(0), APART))
        )
        out.append((a * d - b * c).mid())
    return out


def solved(case: tuple[str, dict[str, float], float], Omega: float | None, start: tuple[float, ...]) -> list[arb]:
    """Newton's iteration, until a step is below the digits kept."""
    x, frequency = [arb(value) for value in start], None if Omega is None else arb(Omega)
    fold = Omega is None
    for _ in range(40):
        f = residual(case, fold, x, frequency)
        columns = []
        for i in range(len(x)):
            shifted = [value + (FURTHER if i == j else 0) for j, value in enumerate(x)]
            changed = residual(case, fold, shifted, frequency)
            columns.append([(more - less) / FURTHER for more, less in zip(changed, f, strict=True)])
        matrix = arb_mat(len(x), len(x), [columns[j][i].mid() for i in range(len(x)) for j in range(len(x))])
        step = matrix.solve(arb_mat(len(x), 1, [-value for value in f]))
        size = max(abs(step[i, 0].mid()) for i in range(len(x)))
        # a start typed to a few digits may be too far for whole steps
        step_length = min(arb(1), arb("0.1") / size) if size > arb("0.1") else arb(1)
        x = [(value + step_length * step[i, 0]).mid() for i, value in enumerate(x)]
        if size < arb(10) ** -(DIGITS + 3):
            return x
    raise AssertionError(f"no motion found: {case}, {Omega}, {start}")


def row(kind: str, numbers: dict[str, float], F_0: float, Omega: float | None, start: tuple[float, ...]) -> dict:
    """What is recorded of a case."""
    A, theta, *rest = (value.str(DIGITS, radius=False) for value in solved((kind, numbers, F_0), Omega, start))
    known = {"force": kind, "numbers": numbers, "F_0": F_0, "fold": Omega is None}
    return known | {"Omega": rest[0] if rest else Omega, "A": A, "theta": theta}


if __name__ == "__main__":
    with precision(BITS):
        store("exact_motions", [row(*case) for case in CASES])
