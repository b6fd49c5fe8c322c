"""Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr; amplitudes up to
u_cr only.

Written by `make derive`; never edit.
Input: derivations/mechanisms/rod_spring.py, sha256 76b1d63466e9529259acb51ca65a45e8a9acd6a1a923137e90a07d40549a4ff1
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain and the operations after each pass.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from slowflow_kernels import slow_flow as flow
from slowflow_support.backend import NATIVE
from slowflow_support.broadcast import by_regime, floats, full, number_by_regime
from slowflow_kernels.rod_spring import (
    HARMONICS_UP_TO,
    NAME,
    PARAMETERS,
    RATIOS,
    REACH,
    REACH_REASON,
    breakpoints,
    coefficients,
    force,
    hardening,
    jumps,
    saddle_node_onset,
    saddle_nodes,
)

__all__ = [
    "F_A",
    "F_AA",
    "F_AAA",
    "HARMONICS_UP_TO",
    "H_A",
    "H_AA",
    "NAME",
    "PARAMETERS",
    "RATIOS",
    "REACH",
    "REACH_REASON",
    "F",
    "F_AOmega",
    "F_Omega",
    "H",
    "I",
    "R",
    "averaged",
    "averaged_2",
    "averaged_3",
    "backbone",
    "breakpoints",
    "coefficients",
    "equivalent_damping",
    "force",
    "h",
    "h_A",
    "h_AA",
    "h_AAA",
    "hardening",
    "jacobian",
    "jumps",
    "limit_envelope",
    "phase",
    "saddle_node_onset",
    "saddle_nodes",
    "stability",
    "transmissibility",
]


def _averaged_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 28 structured, 19 common subexpressions, 19 power chains
    t0 = -alpha
    t1 = A * A
    t2 = gamma * t1
    t3 = 4.5 * beta
    return (
        A * (t0 + t1 * (-0.75 * beta - 0.625 * t2)),
        t0 + t1 * (-2.25 * beta - 3.125 * t2),
        A * (-12.5 * t2 - t3),
        -37.5 * t2 - t3,
    )


def averaged(A, alpha, beta, gamma, u_cr):
    """h, h_A, h_AA, h_AAA together.

    Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_averaged_passed_0,)
    return by_regime(guards, bodies, arguments, 4)


def _averaged_3_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 23 structured, 17 common subexpressions, 17 power chains
    t0 = -alpha
    t1 = A * A
    t2 = gamma * t1
    return (
        A * (t0 + t1 * (-0.75 * beta - 0.625 * t2)),
        t0 + t1 * (-2.25 * beta - 3.125 * t2),
        A * (-4.5 * beta - 12.5 * t2),
    )


def averaged_3(A, alpha, beta, gamma, u_cr):
    """h, h_A, h_AA together.

    Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_averaged_3_passed_0,)
    return by_regime(guards, bodies, arguments, 3)


def _averaged_2_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 17 structured, 13 common subexpressions, 13 power chains
    t0 = -alpha
    t1 = A * A
    t2 = gamma * t1
    return (
        A * (t0 + t1 * (-0.75 * beta - 0.625 * t2)),
        t0 + t1 * (-2.25 * beta - 3.125 * t2),
    )


def averaged_2(A, alpha, beta, gamma, u_cr):
    """h, h_A together.

    Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_averaged_2_passed_0,)
    return by_regime(guards, bodies, arguments, 2)


def _h_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 9 structured, 8 common subexpressions, 8 power chains
    t0 = A * A
    return A * (-alpha + t0 * (-0.75 * beta - 0.625 * gamma * t0))


def h(A, alpha, beta, gamma, u_cr):
    """The averaged restoring force h = H - A.

    Equation (20)-(22). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_h_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _h_A_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 8 structured, 7 common subexpressions, 7 power chains
    t0 = A * A
    return -alpha + t0 * (-2.25 * beta - 3.125 * gamma * t0)


def h_A(A, alpha, beta, gamma, u_cr):
    """d/dA of the averaged restoring force h = H - A.

    Equation (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_h_A_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _h_AA_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 6 structured, 6 common subexpressions, 6 power chains
    return A * (-12.5 * A * A * gamma - 4.5 * beta)


def h_AA(A, alpha, beta, gamma, u_cr):
    """d2/dA2 of the averaged restoring force h = H - A.

    Equation from (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_h_AA_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _h_AAA_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 5 structured, 5 common subexpressions, 5 power chains
    return -37.5 * A * A * gamma - 4.5 * beta


def h_AAA(A, alpha, beta, gamma, u_cr):
    """d3/dA3 of the averaged restoring force h = H - A.

    Equation from (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_h_AAA_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _H_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 10 structured, 9 common subexpressions, 9 power chains
    t0 = A * A
    return A * (-alpha + t0 * (-0.75 * beta - 0.625 * gamma * t0) + 1.0)


def H(A, alpha, beta, gamma, u_cr):
    """The averaged force H beside the vertical spring.

    Equation (20)-(22). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_H_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _H_A_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 9 structured, 8 common subexpressions, 8 power chains
    t0 = A * A
    return -alpha + t0 * (-2.25 * beta - 3.125 * gamma * t0) + 1.0


def H_A(A, alpha, beta, gamma, u_cr):
    """d/dA of the averaged force H beside the vertical spring.

    Equation (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_H_A_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _H_AA_passed_0(A, alpha, beta, gamma, u_cr):
    # operations: 6 structured, 6 common subexpressions, 6 power chains
    return A * (-12.5 * A * A * gamma - 4.5 * beta)


def H_AA(A, alpha, beta, gamma, u_cr):
    """d2/dA2 of the averaged force H beside the vertical spring.

    Equation from (31). Domain: 0 <= A <= u_cr.
    """
    arguments = floats(A, alpha, beta, gamma, u_cr)
    A, alpha, beta, gamma, u_cr = arguments
    guards = ()
    bodies = (_H_AA_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def R(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """Cosine balance, -F_0 cos phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    arguments = (Omega, A, mu, zeta, alpha, beta, gamma, u_cr)
    return full(flow.R(Omega, A, average), arguments)


def I(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):  # noqa: E743
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    arguments = (Omega, A, mu, zeta, alpha, beta, gamma, u_cr)
    return full(flow.I(Omega, A, flow.friction(mu), zeta), arguments)


def F(Omega, A, F_0, mu, zeta, alpha, beta, gamma, u_cr):
    """Frequency response; zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.F(Omega, A, F_0, flow.friction(mu), zeta, average)


def F_A(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.F_A(Omega, A, flow.friction(mu), zeta, average, average_A)


def F_AA(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """d2F/dA2.

    Equation (24), (33). Domain: Omega > 0, A > 0.
    """
    average, average_A, average_AA = averaged_3(A, alpha, beta, gamma, u_cr)
    return flow.F_AA(Omega, A, flow.friction(mu), zeta, average, average_A, average_AA)


def F_AAA(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """d3F/dA3.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average, average_A, average_AA, average_AAA = averaged(A, alpha, beta, gamma, u_cr)
    return flow.F_AAA(Omega, A, flow.friction(mu), zeta, average, average_A, average_AA, average_AAA)


def F_Omega(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """dF/dOmega.

    Equation (24), (34). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.F_Omega(Omega, A, flow.friction(mu), zeta, average)


def F_AOmega(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """d2F/dA dOmega.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.F_AOmega(Omega, A, flow.friction(mu), zeta, average, average_A)


def phase(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """Phase phi of a steady state, from -pi to 0.

    Equation (25). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.phase(Omega, A, flow.friction(mu), zeta, average)


def jacobian(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.

    Equation (28). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.jacobian(Omega, A, flow.friction(mu), zeta, average, average_A)


def stability(Omega, A, mu, zeta, alpha, beta, gamma, u_cr):
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta, gamma, u_cr)
    return flow.stability(Omega, A, flow.friction(mu), zeta, average, average_A)


def transmissibility(Omega, A, F_0, mu, zeta, alpha, beta, gamma, u_cr):
    """Fundamental harmonic of the force on the base over F_0, at a steady state.

    Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.transmissibility(Omega, A, F_0, flow.friction(mu), zeta, average)


def backbone(A, alpha, beta, gamma, u_cr):
    """Frequency on the backbone.

    Equation (26). Domain: A > 0, h <= 0.
    """
    average = h(A, alpha, beta, gamma, u_cr)
    return flow.backbone(A, average)


def limit_envelope(Omega, F_0, mu, zeta):
    """Largest amplitude that the forcing can hold at this frequency.

    Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise.
    """
    return flow.limit_envelope(Omega, F_0, flow.friction(mu), zeta)


def equivalent_damping(Omega, A, mu, zeta):
    """Viscous damping ratio that dissipates as much as zeta and friction together.

    Equation (38). Domain: Omega > 0, A > 0.
    """
    return flow.equivalent_damping(Omega, A, flow.friction(mu), zeta)


if NATIVE is not None:
    (
        averaged,
        averaged_3,
        averaged_2,
        h,
        h_A,
        h_AA,
        h_AAA,
        H,
        H_A,
        H_AA,
        R,
        I,
        F,
        F_A,
        F_AA,
        F_AAA,
        F_Omega,
        F_AOmega,
        phase,
        jacobian,
        stability,
        transmissibility,
        backbone,
        limit_envelope,
        equivalent_damping,
    ) = NATIVE.rod_spring_attached()
