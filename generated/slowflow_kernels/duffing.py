"""Duffing oscillator: one cubic piece, no breakpoint.

Written by `make derive`; never edit.
Input: derivations/mechanisms/duffing.py, sha256 9cc742f303d96c79bad0568c2c4516c8f5944292cc72520ca6ccbb22912545d8
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain and the operations after each pass.
FORCE: force and slope of each piece, for any kind of number that has arithmetic.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from slowflow_kernels import slow_flow as flow
from slowflow_support.backend import NATIVE, coefficients_of, in_tuple
from slowflow_support.broadcast import by_regime, floats, full, number_by_regime, stacked
from slowflow_support.record import Mechanism, Parameter

NAME = "duffing"
PARAMETERS = ("alpha", "beta")
RATIOS = ("kappa_1", "kappa_3")
REACH = float("inf")
REACH_REASON = ""
HARMONICS_UP_TO = float("inf")

__all__ = [
    "FORCE",
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
    "force_1",
    "force_1_u",
    "h",
    "h_A",
    "h_AA",
    "h_AAA",
    "hardening",
    "harmonics",
    "jacobian",
    "jumps",
    "limit_envelope",
    "phase",
    "saddle_node_onset",
    "saddle_nodes",
    "stability",
    "transmissibility",
]


def _averaged_passed_0(A, alpha, beta):
    # operations: 12 structured, 9 common subexpressions, 9 power chains
    t0 = A * A * beta
    t1 = 4.5 * beta
    return (
        A * (-alpha - 0.75 * t0),
        -alpha - 2.25 * t0,
        -A * t1,
        -t1,
    )


def averaged(A, alpha, beta):
    """h, h_A, h_AA, h_AAA together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_averaged_passed_0,)
    return by_regime(guards, bodies, arguments, 4)


def _averaged_3_passed_0(A, alpha, beta):
    # operations: 11 structured, 9 common subexpressions, 9 power chains
    t0 = A * A * beta
    return (
        A * (-alpha - 0.75 * t0),
        -alpha - 2.25 * t0,
        -4.5 * A * beta,
    )


def averaged_3(A, alpha, beta):
    """h, h_A, h_AA together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_averaged_3_passed_0,)
    return by_regime(guards, bodies, arguments, 3)


def _averaged_2_passed_0(A, alpha, beta):
    # operations: 9 structured, 7 common subexpressions, 7 power chains
    t0 = A * A * beta
    return (
        A * (-alpha - 0.75 * t0),
        -alpha - 2.25 * t0,
    )


def averaged_2(A, alpha, beta):
    """h, h_A together.

    Equation (20)-(22), (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_averaged_2_passed_0,)
    return by_regime(guards, bodies, arguments, 2)


def _h_passed_0(A, alpha, beta):
    # operations: 5 structured, 5 common subexpressions, 5 power chains
    return A * (-0.75 * A * A * beta - alpha)


def h(A, alpha, beta):
    """The averaged restoring force h = H - A.

    Equation (20)-(22). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_h_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _h_A_passed_0(A, alpha, beta):
    # operations: 4 structured, 4 common subexpressions, 4 power chains
    return -2.25 * A * A * beta - alpha


def h_A(A, alpha, beta):
    """d/dA of the averaged restoring force h = H - A.

    Equation (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_h_A_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _h_AA_passed_0(A, alpha, beta):
    # operations: 2 structured, 2 common subexpressions, 2 power chains
    return -4.5 * A * beta


def h_AA(A, alpha, beta):
    """d2/dA2 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_h_AA_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _h_AAA_passed_0(A, alpha, beta):
    # operations: 1 structured, 1 common subexpressions, 1 power chains
    return -4.5 * beta


def h_AAA(A, alpha, beta):
    """d3/dA3 of the averaged restoring force h = H - A.

    Equation from (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_h_AAA_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _H_passed_0(A, alpha, beta):
    # operations: 6 structured, 6 common subexpressions, 6 power chains
    return A * (-0.75 * A * A * beta - alpha + 1.0)


def H(A, alpha, beta):
    """The averaged force H beside the vertical spring.

    Equation (20)-(22). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_H_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _H_A_passed_0(A, alpha, beta):
    # operations: 5 structured, 5 common subexpressions, 5 power chains
    return -2.25 * A * A * beta - alpha + 1.0


def H_A(A, alpha, beta):
    """d/dA of the averaged force H beside the vertical spring.

    Equation (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_H_A_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _H_AA_passed_0(A, alpha, beta):
    # operations: 2 structured, 2 common subexpressions, 2 power chains
    return -4.5 * A * beta


def H_AA(A, alpha, beta):
    """d2/dA2 of the averaged force H beside the vertical spring.

    Equation from (31). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_H_AA_passed_0,)
    return number_by_regime(guards, bodies, arguments)


def _harmonics_passed_0(A, alpha, beta):
    # operations: 10 structured, 9 common subexpressions, 8 power chains
    t0 = 1.5 * beta
    A2 = A * A
    A3 = A * A2
    return (
        -0.25 * A3 * beta,
        -0.75 * A2 * beta,
        -A * t0,
        -t0,
        0.0,
        0.0,
        0.0,
        0.0,
    )


def harmonics(A, alpha, beta):
    """Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.

    Equation beyond (20). Domain: A >= 0.
    """
    arguments = floats(A, alpha, beta)
    A, alpha, beta = arguments
    guards = ()
    bodies = (_harmonics_passed_0,)
    return by_regime(guards, bodies, arguments, 8)


def coefficients(alpha, beta):
    """The parameters alpha, beta from the design.

    Equation (5), (7). Domain: any design.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    alpha, beta = floats(alpha, beta)
    arguments = (alpha, beta)
    return (
        full(alpha, arguments),
        full(beta, arguments),
    )


def breakpoints(alpha, beta):
    """The |u| at which a piece of the force ends.

    Equation (5). Domain: any parameters.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    alpha, beta = floats(alpha, beta)
    return ()


def jumps(alpha, beta):
    """What the force loses at each breakpoint: f below less f above.

    Equation (6). Domain: any parameters.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    alpha, beta = floats(alpha, beta)
    return ()


def hardening(alpha, beta):
    """The force over the displacement, f(u)/u, rises with |u| where none of these is negative.

    Equation from (3). Domain: any parameters.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    alpha, beta = floats(alpha, beta)
    arguments = (alpha, beta)
    return (
        full(beta, arguments),
    )


def _force_piece_1(u, alpha, beta):
    # operations: 4 structured, 4 common subexpressions, 4 power chains
    return u * (alpha + beta * u * u)


def force(u, alpha, beta):
    """Whole dimensionless restoring force u + F_k(u), truncated.

    Equation (3), (6). Domain: any u.
    """
    arguments = floats(u, alpha, beta)
    u, alpha, beta = arguments
    guards = ()
    bodies = (_force_piece_1,)
    return number_by_regime(guards, bodies, arguments)


def force_1(u, alpha, beta):
    """Piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds.
    Operations: 4 structured, 4 common subexpressions, 4 power chains.
    """
    return u * (alpha + beta * u * u)


def force_1_u(u, alpha, beta):
    """d/du of piece 1 of the whole restoring force u + F_k(u).

    Equation (3), (6). Domain: where it holds.
    Operations: 4 structured, 4 common subexpressions, 4 power chains.
    """
    return alpha + 3.0 * beta * u * u


def saddle_node_onset(m, zeta, alpha, beta):
    """Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.

    Equation (33). Domain: roots with A > 0.
    Operations: 137 structured, 78 common subexpressions, 53 power chains.
    """
    m, zeta, alpha, beta = floats(m, zeta, alpha, beta)
    t0 = alpha * alpha
    zeta2 = zeta * zeta
    zeta4 = zeta2 * zeta2
    m2 = m * m
    m4 = m2 * m2
    t1 = m4 * zeta4
    beta2 = beta * beta
    t2 = alpha * zeta4
    beta4 = beta2 * beta2
    t3 = m2 * zeta2
    beta5 = beta * beta4
    beta3 = beta * beta2
    beta6 = beta3 * beta3
    beta7 = beta * beta6
    beta8 = beta4 * beta4
    return stacked(
        (
            4096.0 * t0 * t1,
            36864.0 * alpha * beta * t1,
            34560.0 * beta2 * t1,
            294912.0 * beta2 * m2 * t0 * zeta4,
            1658880.0 * beta3 * m2 * t2,
            -1710720.0 * alpha * beta4 * t3 + 1430784.0 * beta4 * m2 * zeta4,
            5308416.0 * beta4 * t0 * zeta4 - 1819584.0 * beta5 * t3,
            11943936.0 * beta5 * t2,
            -1119744.0 * alpha * beta6 * zeta2 + 6718464.0 * beta6 * zeta4,
            -1259712.0 * beta7 * zeta2,
            59049.0 * beta8,
        ),
        (m, zeta, alpha, beta),
    )


def saddle_nodes(F_0, m, zeta, alpha, beta):
    """Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.

    Equation from (24), (30). Domain: roots with A > 0.
    Operations: 432 structured, 196 common subexpressions, 162 power chains.
    """
    F_0, m, zeta, alpha, beta = floats(F_0, m, zeta, alpha, beta)
    F_0_2 = F_0 * F_0
    m2 = m * m
    m3 = m * m2
    m6 = m3 * m3
    F_0_4 = F_0_2 * F_0_2
    m4 = m2 * m2
    F_0_3 = F_0 * F_0_2
    F_0_6 = F_0_3 * F_0_3
    zeta2 = zeta * zeta
    t0 = m6 * zeta2
    t1 = 128.0 * alpha
    zeta4 = zeta2 * zeta2
    t2 = 256.0 * zeta4
    t3 = F_0_2 * m4
    t4 = F_0_4 * m2
    t5 = beta * zeta2
    t6 = alpha * alpha
    beta2 = beta * beta
    t7 = 72.0 * beta2
    t8 = alpha * zeta4
    t9 = 216.0 * beta2
    t10 = F_0_2 * alpha * zeta4
    t11 = beta2 * zeta4
    t12 = alpha * zeta2
    t13 = beta2 * t12
    t14 = m2 * zeta2
    beta3 = beta * beta2
    t15 = beta3 * zeta2
    beta4 = beta2 * beta2
    t16 = 81.0 * beta4
    t17 = beta4 * m2
    t18 = 1728.0 * beta3
    t19 = F_0_2 * zeta2
    beta5 = beta * beta4
    t20 = 486.0 * beta5
    m8 = m4 * m4
    F_0_8 = F_0_4 * F_0_4
    beta6 = beta3 * beta3
    return stacked(
        (
            -64.0 * F_0_2 * m6 + 96.0 * F_0_4 * m4 - 64.0 * F_0_6 * m2 + 16.0 * F_0_8 + 16.0 * m8,
            256.0 * F_0_2 * alpha * m4 * zeta2 + 256.0 * F_0_4 * m2 * zeta4 - t0 * t1 - t1 * t4 * zeta2 - t2 * t3,
            192.0 * F_0_6 * t5 - 96.0 * beta * t0 + m4 * t2 * t6 + 384.0 * t3 * t5 - 480.0 * t4 * t5,
            -F_0_6 * t7 + 768.0 * beta * m2 * t10 + 384.0 * beta * m4 * t8 + m6 * t7 - t3 * t9 + t4 * t9,
            288.0 * F_0_2 * alpha * beta2 * t14 + 576.0 * F_0_4 * t11 + 288.0 * F_0_4 * t13 + 144.0 * m4 * t11 -
            576.0 * m4 * t13,
            648.0 * F_0_2 * beta3 * m2 * zeta2 - 216.0 * F_0_4 * t15 + 1152.0 * beta2 * m2 * t6 * zeta4 - 432.0 * m4
            * t15,
            -162.0 * F_0_2 * t17 + F_0_4 * t16 + m2 * t18 * t8 + m4 * t16 + t10 * t18,
            1296.0 * F_0_2 * beta4 * zeta4 - 648.0 * alpha * beta4 * t19 + 648.0 * beta4 * m2 * zeta4 - 648.0 * t12
            * t17,
            1296.0 * beta4 * t6 * zeta4 - t14 * t20 - t19 * t20,
            1944.0 * beta5 * t8,
            729.0 * beta6 * zeta4,
        ),
        (F_0, m, zeta, alpha, beta),
    )


def R(Omega, A, mu, zeta, alpha, beta):
    """Cosine balance, -F_0 cos phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta)
    arguments = (Omega, A, mu, zeta, alpha, beta)
    return full(flow.R(Omega, A, average), arguments)


def I(Omega, A, mu, zeta, alpha, beta):  # noqa: E743
    """Sine balance, -F_0 sin phi at a fixed point.

    Equation (23). Domain: Omega > 0, A > 0.
    """
    arguments = (Omega, A, mu, zeta, alpha, beta)
    return full(flow.I(Omega, A, flow.friction(mu), zeta), arguments)


def F(Omega, A, F_0, mu, zeta, alpha, beta):
    """Frequency response; zero at a steady state.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta)
    return flow.F(Omega, A, F_0, flow.friction(mu), zeta, average)


def F_A(Omega, A, mu, zeta, alpha, beta):
    """dF/dA; positive where stable.

    Equation (24), (30). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta)
    return flow.F_A(Omega, A, flow.friction(mu), zeta, average, average_A)


def F_AA(Omega, A, mu, zeta, alpha, beta):
    """d2F/dA2.

    Equation (24), (33). Domain: Omega > 0, A > 0.
    """
    average, average_A, average_AA = averaged_3(A, alpha, beta)
    return flow.F_AA(Omega, A, flow.friction(mu), zeta, average, average_A, average_AA)


def F_AAA(Omega, A, mu, zeta, alpha, beta):
    """d3F/dA3.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average, average_A, average_AA, average_AAA = averaged(A, alpha, beta)
    return flow.F_AAA(Omega, A, flow.friction(mu), zeta, average, average_A, average_AA, average_AAA)


def F_Omega(Omega, A, mu, zeta, alpha, beta):
    """dF/dOmega.

    Equation (24), (34). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta)
    return flow.F_Omega(Omega, A, flow.friction(mu), zeta, average)


def F_AOmega(Omega, A, mu, zeta, alpha, beta):
    """d2F/dA dOmega.

    Equation (24). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta)
    return flow.F_AOmega(Omega, A, flow.friction(mu), zeta, average, average_A)


def phase(Omega, A, mu, zeta, alpha, beta):
    """Phase phi of a steady state, from -pi to 0.

    Equation (25). Domain: Omega > 0, A > 0.
    """
    average = h(A, alpha, beta)
    return flow.phase(Omega, A, flow.friction(mu), zeta, average)


def jacobian(Omega, A, mu, zeta, alpha, beta):
    """Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.

    Equation (28). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta)
    return flow.jacobian(Omega, A, flow.friction(mu), zeta, average, average_A)


def stability(Omega, A, mu, zeta, alpha, beta):
    """4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.

    Equation (30). Domain: Omega > 0, A > 0.
    """
    average, average_A = averaged_2(A, alpha, beta)
    return flow.stability(Omega, A, flow.friction(mu), zeta, average, average_A)


def transmissibility(Omega, A, F_0, mu, zeta, alpha, beta):
    """Fundamental harmonic of the force on the base over F_0, at a steady state.

    Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0.
    """
    average = h(A, alpha, beta)
    return flow.transmissibility(Omega, A, F_0, flow.friction(mu), zeta, average)


def backbone(A, alpha, beta):
    """Frequency on the backbone.

    Equation (26). Domain: A > 0, h <= 0.
    """
    average = h(A, alpha, beta)
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


FORCE = ((force_1, force_1_u),)

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
        harmonics,
        coefficients,
        hardening,
        force,
        saddle_node_onset,
        saddle_nodes,
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
    ) = NATIVE.duffing()
    saddle_node_onset = coefficients_of(saddle_node_onset)
    saddle_nodes = coefficients_of(saddle_nodes)
    hardening = in_tuple(hardening)


_DESIGN = (
    Parameter("alpha", "linear stiffness k_v + k_1; alpha <= 0 is allowed", "k_v"),
    Parameter("beta", "cubic stiffness k_3; beta < 0 softens", "k_v/L^2"),
)
_PARAMETERS = (
    Parameter("alpha", "linear stiffness k_v + k_1; alpha <= 0 is allowed", "k_v"),
    Parameter("beta", "cubic stiffness k_3; beta < 0 softens", "k_v/L^2"),
)
MECHANISM = Mechanism(
    name="duffing",
    title="Duffing oscillator: one cubic piece, no breakpoint",
    design=_DESIGN,
    parameters=_PARAMETERS,
    coefficients=coefficients,
    pieces=FORCE,
    breakpoints=breakpoints,
    jumps=jumps,
    hardening=hardening,
    averaged=averaged,
    harmonics=harmonics,
    harmonics_up_to=float("inf"),
    reach=float("inf"),
    reach_reason="",
    truncated=False,
    attached=None,
    load_untruncated=None,
)
