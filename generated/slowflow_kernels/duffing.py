"""Duffing oscillator: one polynomial of degree five, no breakpoint.

Written by `make derive` from derivations/mechanisms/duffing.py; never edit.

Rounding errors were measured with A, F_0 1e-09 to 1000; Omega 0.001 to 1000; alpha 1e-16 to 1000 of either sign or
0; beta, gamma, h 1e-12 to 1000 of either sign or 0; h_A 1e-09 to 1e+06 of either sign or 0; h_AA 1e-09 to 1e+09 of
either sign or 0; m, mu, zeta 1e-12 to 1 or 0; u 1e-09 to 1000 of either sign or 0.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from slowflow_kernels import slow_flow as flow
from slowflow.support.backend import NATIVE, compiled, from_c
from slowflow.support.broadcast import broadcast_outputs, common_shape, floats, full, number_by_regime
from slowflow.support.record import Law, Mechanism, Parameter

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from slowflow.support.broadcast import Floats

__all__ = [
    "F_A", "H_A", "H_AA", "MECHANISM", "F", "H", "averaged", "averaged_2", "averaged_H", "backbone", "breakpoints",
    "by_design", "by_parameter", "coefficients", "detachment", "equivalent_damping", "fold_quartic", "force",
    "force_1", "force_1_u", "h", "h_A", "h_AA", "h_AAA", "hardening", "harmonics", "intercept", "jacobian", "jumps",
    "level", "limit_envelope", "peak_cubic", "phase", "response_quartic", "saddle_node_onset", "saddle_nodes",
    "stability", "steps", "steps_by", "transmissibility",
]


def averaged(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """h, h_A, h_AA, h_AAA together.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 19. Error / u (1 + kappa): proved 5.76, 4.76, 2.34, 1.51.
    """
    A, alpha, beta, gamma = floats(A, alpha, beta, gamma)
    t0 = A * A
    gamma_A2 = gamma * t0
    gamma_A4 = gamma_A2 * t0
    beta_A2 = beta * t0
    t1 = 4.5 * beta
    return broadcast_outputs((A, alpha, beta, gamma),
        A * (-alpha - 0.75 * beta_A2 - 0.625 * gamma_A4),
        -alpha - 2.25 * beta_A2 - 3.125 * gamma_A4,
        A * (-12.5 * gamma_A2 - t1),
        -37.5 * gamma_A2 - t1,
    )


def averaged_2(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any]:
    """h, h_A together.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 13. Error / u (1 + kappa): proved 5.76, 4.76.
    """
    A, alpha, beta, gamma = floats(A, alpha, beta, gamma)
    t0 = A * A
    gamma_A2 = gamma * t0
    gamma_A4 = gamma_A2 * t0
    beta_A2 = beta * t0
    return A * (-alpha - 0.75 * beta_A2 - 0.625 * gamma_A4), -alpha - 2.25 * beta_A2 - 3.125 * gamma_A4


def averaged_H(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any]:
    """H, H_A together.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 14. Error / u (1 + kappa): proved 8.01, 6.67.
    """
    A, alpha, beta, gamma = floats(A, alpha, beta, gamma)
    t0 = A * A
    gamma_A2 = gamma * t0
    gamma_A4 = gamma_A2 * t0
    beta_A2 = beta * t0
    t1 = alpha - 1.0
    return A * (-0.75 * beta_A2 - 0.625 * gamma_A4 - t1), -2.25 * beta_A2 - 3.125 * gamma_A4 - t1


def intercept(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """h - A h_A, where the tangent of h meets A = 0; linear terms are none.

    Equation (20)-(22), (31). Domain: A >= 0. Operations: 8. Error / u (1 + kappa): proved 4.61.
    """
    A, alpha, beta, gamma = floats(A, alpha, beta, gamma)
    t0 = A * A
    gamma_A2 = gamma * t0
    gamma_A4 = gamma_A2 * t0
    beta_A2 = beta * t0
    return full(A * (1.5 * beta_A2 + 2.5 * gamma_A4), common_shape((A, alpha, beta, gamma)))


def harmonics(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any]:
    """Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.

    Equation beyond (20). Domain: A >= 0. Operations: 26. Error / u (1 + kappa): proved 4.11, 3.51, 2.34, 1.51,
    0.72, 0.84, 0.81, 0.76.
    """
    A, alpha, beta, gamma = floats(A, alpha, beta, gamma)
    A2 = A * A
    A3 = A * A2
    t0 = A2 * gamma
    t1 = 1.5 * beta
    A4 = A2 * A2
    A5 = A * A4
    return broadcast_outputs((A, alpha, beta, gamma),
        A3 * (-0.25 * beta - 0.3125 * t0),
        A2 * (-0.75 * beta - 1.5625 * t0),
        A * (-6.25 * t0 - t1),
        -18.75 * t0 - t1,
        -0.0625 * A5 * gamma,
        -0.3125 * A4 * gamma,
        -1.25 * A3 * gamma,
        -3.75 * t0,
    )


def by_parameter(A: Any, h: Any, h_A: Any, h_AA: Any, alpha: Any, beta: Any, gamma: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.

    Equation from (20)-(22), (31). Domain: A > 0. Operations: 10. Error / u (1 + kappa): proved 0.84 at most.
    """
    A, h, h_A, h_AA, alpha, beta, gamma = floats(A, h, h_A, h_AA, alpha, beta, gamma)
    A2 = A * A
    A3 = A * A2
    A4 = A2 * A2
    A5 = A * A4
    return broadcast_outputs((A, h, h_A, h_AA, alpha, beta, gamma),
        -A, -1.0, 0.0,
        -0.75 * A3,
        -2.25 * A2,
        -4.5 * A,
        -0.625 * A5,
        -3.125 * A4,
        -12.5 * A3,
    )


def by_design(alpha: Any, beta: Any, gamma: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """d/d of each number of the design: of each parameter in turn, then of each breakpoint.

    Equation (5), (7). Domain: any design. Operations: 0. Error / u (1 + kappa): proved 0.0 at most.
    """
    alpha, beta, gamma = floats(alpha, beta, gamma)
    return broadcast_outputs((alpha, beta, gamma), 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)


def coefficients(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any, Any]:
    """The parameters alpha, beta, gamma from the design.

    Equation (5), (7). Domain: any design. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0.
    """
    alpha, beta, gamma = floats(alpha, beta, gamma)
    return broadcast_outputs((alpha, beta, gamma), alpha, beta, gamma)


def breakpoints(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[()]:
    """The |u| at which a piece of the force ends.

    Equation (5). Domain: any parameters. Operations: 0. Gives ().
    """
    alpha, beta, gamma = floats(alpha, beta, gamma)
    return ()


def jumps(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[()]:
    """What the force loses at each breakpoint: f below less f above.

    Equation (5). Domain: any parameters. Operations: 0. Gives ().
    """
    alpha, beta, gamma = floats(alpha, beta, gamma)
    return ()


def hardening(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any]:
    """The force over the displacement, f(u)/u, rises with |u| where none of these is negative.

    Equation from (3). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0.
    """
    alpha, beta, gamma = floats(alpha, beta, gamma)
    return broadcast_outputs((alpha, beta, gamma), beta, gamma)


def steps(alpha: Any, beta: Any, gamma: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """f and its derivatives just above 0, their gains at each breakpoint, and the last piece's by its formula at 0.

    Equation (3), (5). Domain: any parameters. Operations: 2. Error / u (1 + kappa): proved 0.51 at most.
    """
    alpha, beta, gamma = floats(alpha, beta, gamma)
    t0 = 6.0 * beta
    t1 = 120.0 * gamma
    return broadcast_outputs((alpha, beta, gamma), 0.0, alpha, 0.0, t0, 0.0, t1, 0.0, alpha, 0.0, t0, 0.0, t1)


def steps_by(alpha: Any, beta: Any, gamma: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """What each parameter does to derivatives of each piece at u = 0, then to their gains at each breakpoint.

    Equation (3). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0 at most.
    """
    alpha, beta, gamma = floats(alpha, beta, gamma)
    return broadcast_outputs((alpha, beta, gamma),
        0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 6.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 120.0,
    )


def force_1(u: Any, alpha: Any, beta: Any, gamma: Any) -> Any:
    """Piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (5). Domain: where it holds. Operations: 6. Error / u (1 + kappa): proved 4.76.
    """
    t0 = u * u
    return u * (alpha + t0 * (beta + gamma * t0))


def force_1_u(u: Any, alpha: Any, beta: Any, gamma: Any) -> Any:
    """d/du of piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (5). Domain: where it holds. Operations: 7. Error / u (1 + kappa): proved 4.51.
    """
    t0 = u * u
    return alpha + t0 * (3.0 * beta + 5.0 * gamma * t0)


def force(u: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """Whole dimensionless restoring force u + F_k(u).

    Equation (3), (5). Domain: any u.
    """
    u, alpha, beta, gamma = arguments = floats(u, alpha, beta, gamma)
    bodies = (force_1,)
    return number_by_regime((), bodies, arguments)


def h(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """The averaged restoring force h = H - A.

    Equation (20)-(22). Domain: A >= 0. Error / u (1 + kappa): measured 0.62.
    """
    return averaged_2(A, alpha, beta, gamma)[0]


def h_A(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """d/dA of the averaged restoring force h = H - A.

    Equation (31). Domain: A >= 0. Error / u (1 + kappa): measured 0.95.
    """
    return averaged_2(A, alpha, beta, gamma)[1]


def h_AA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """d2/dA2 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 0.51.
    """
    return averaged(A, alpha, beta, gamma)[2]


def h_AAA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """d3/dA3 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 0.76.
    """
    return averaged(A, alpha, beta, gamma)[3]


def H(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """The averaged force H beside the vertical spring.

    Equation (20)-(22). Domain: A >= 0. Error / u (1 + kappa): measured 0.88.
    """
    return averaged_H(A, alpha, beta, gamma)[0]


def H_A(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """d/dA of the averaged force H beside the vertical spring.

    Equation (31). Domain: A >= 0. Error / u (1 + kappa): measured 1.9.
    """
    return averaged_H(A, alpha, beta, gamma)[1]


def H_AA(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """d2/dA2 of the averaged force H beside the vertical spring.

    Equation from (31). Domain: A >= 0. Error / u (1 + kappa): measured 0.73.
    """
    return averaged(A, alpha, beta, gamma)[2]


def F(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """Frequency response; zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 0.64.
    """
    average, _ = averaged_2(A, alpha, beta, gamma)
    return flow.F(Omega, A, F_0, flow.friction(mu), zeta, average)


def F_A(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 0.72.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma)
    return flow.F_A(Omega, A, flow.friction(mu), zeta, average, average_A)


def level(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """The forcing F_0 for which (Omega, A) is a steady state.

    Equation (24). Domain: Omega >= 0, A > 0. Error / u (1 + kappa): measured 1.1.
    """
    average, _ = averaged_2(A, alpha, beta, gamma)
    return flow.level(Omega, A, flow.friction(mu), zeta, average)


def phase(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """Phase phi of a steady state, from -pi to 0.

    Equation (25). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 0.65.
    """
    average, _ = averaged_2(A, alpha, beta, gamma)
    return flow.phase(Omega, A, flow.friction(mu), zeta, average)


def jacobian(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.

    Equation (28). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 0.78.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma)
    return flow.jacobian(Omega, A, flow.friction(mu), zeta, average, average_A)


def stability(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 1.3.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma)
    return flow.stability(Omega, A, flow.friction(mu), zeta, average, average_A)


def transmissibility(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """Fundamental harmonic of the force on the base over F_0, at a steady state.

    Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. Error / u (1 + kappa): measured 0.61.
    """
    average, _ = averaged_2(A, alpha, beta, gamma)
    return flow.transmissibility(Omega, A, F_0, flow.friction(mu), zeta, average)


def backbone(A: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Any:
    """Frequency on the backbone.

    Equation (26). Domain: A > 0, h <= 0. Error / u (1 + kappa): measured 0.63.
    """
    average, _ = averaged_2(A, alpha, beta, gamma)
    return flow.backbone(A, average)


def limit_envelope(Omega: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike) -> Any:
    """Largest amplitude that the forcing can hold at this frequency.

    Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. Error / u (1 + kappa): measured 0.64.
    """
    return flow.limit_envelope(Omega, F_0, flow.friction(mu), zeta)


def equivalent_damping(Omega: ArrayLike, A: ArrayLike, mu: ArrayLike, zeta: ArrayLike) -> Any:
    """Viscous damping ratio that dissipates as much as zeta and friction together.

    Equation (38). Domain: Omega > 0, A > 0. Error / u (1 + kappa): measured 0.94.
    """
    return flow.equivalent_damping(Omega, A, flow.friction(mu), zeta)


def response_quartic(A: ArrayLike, F_0: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24). Domain: A > 0. Error / u (1 + kappa): measured 1.5.
    """
    average, _ = averaged_2(A, alpha, beta, gamma)
    return flow.response_quartic(A, F_0, flow.friction(mu), zeta, average)


def fold_quartic(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any, Any, Any]:
    """F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.

    Equation (24), (30). Domain: A > 0. Error / u (1 + kappa): measured 0.68.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma)
    return flow.fold_quartic(A, flow.friction(mu), zeta, average, average_A)


def peak_cubic(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> tuple[Any, Any, Any]:
    """F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.

    Equation (34). Domain: A > 0. Error / u (1 + kappa): measured 0.65.
    """
    average, _ = averaged_2(A, alpha, beta, gamma)
    return flow.peak_cubic(A, flow.friction(mu), zeta, average)


def detachment(A: ArrayLike, mu: ArrayLike, zeta: ArrayLike, alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> Floats:
    """Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.

    Equation (34). Domain: A > 0. Error / u (1 + kappa): measured 1.5. One array, coefficients by rising power along
    its first axis.
    """
    average, _ = averaged_2(A, alpha, beta, gamma)
    return flow.detachment(A, flow.friction(mu), zeta, average)


if NATIVE is not None:
    globals().update(compiled(globals(), NATIVE.duffing()))
#: functions that no Python code calls, which are in C, with their arguments; see generated/c/duffing.h
FROM_C = {
    "saddle_node_onset": "m zeta alpha beta gamma",
    "saddle_nodes": "F_0 m zeta alpha beta gamma",
}
globals().update(from_c("duffing", FROM_C, stacked=["saddle_node_onset", "saddle_nodes"]))


def _load_balls():
    from slowflow_kernels import duffing_balls

    return duffing_balls


_PIECES = (
    Law(force_1, force_1_u, "duffing.force_1"),
)
_DESIGN = (
    Parameter("alpha", "linear stiffness k_v + k_1; alpha <= 0 is allowed", "k_v"),
    Parameter("beta", "cubic stiffness k_3; beta < 0 softens", "k_v/L^2"),
    Parameter("gamma", "quintic stiffness k_5; 0 is a cubic spring", "k_v/L^4"),
)
_PARAMETERS = (
    Parameter("alpha", "linear stiffness k_v + k_1; alpha <= 0 is allowed", "k_v"),
    Parameter("beta", "cubic stiffness k_3; beta < 0 softens", "k_v/L^2"),
    Parameter("gamma", "quintic stiffness k_5; 0 is a cubic spring", "k_v/L^4"),
)
MECHANISM = Mechanism(
    name="duffing",
    title="Duffing oscillator: one polynomial of degree five, no breakpoint",
    design=_DESIGN,
    parameters=_PARAMETERS,
    coefficients=coefficients,
    pieces=_PIECES,
    breakpoints=breakpoints,
    jumps=jumps,
    hardening=hardening,
    averaged=averaged,
    intercept=intercept,
    harmonics=harmonics,
    harmonics_up_to=float("inf"),
    by_parameter=by_parameter,
    by_design=by_design,
    reach=float("inf"),
    reach_reason="",
    truncated=False,
    steps=steps,
    steps_by=steps_by,
    load_untruncated=None,
    load_balls=_load_balls,
)
