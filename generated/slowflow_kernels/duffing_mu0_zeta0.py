"""Duffing oscillator: one cubic piece, no breakpoint, in the scene mu = 0 and zeta = 0.

Written by `make derive`; never edit.
Input: derivations/mechanisms/duffing.py, sha256 9cc742f303d96c79bad0568c2c4516c8f5944292cc72520ca6ccbb22912545d8
Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

Everything is dimensionless. Arguments broadcast; outputs have their common shape, NumPy scalars for scalars. Each
docstring gives equation number, domain and the operations after each pass.
"""

# a formatter would spread each polynomial over a page
# fmt: off

from slowflow_kernels import slow_flow_mu0_zeta0 as flow
from slowflow_support.backend import NATIVE, coefficients_of
from slowflow_support.broadcast import floats, full, stacked
from slowflow_kernels.duffing import (
    HARMONICS_UP_TO,
    H_A,
    H_AA,
    NAME,
    PARAMETERS,
    RATIOS,
    REACH,
    REACH_REASON,
    H,
    averaged,
    averaged_2,
    averaged_3,
    breakpoints,
    coefficients,
    force,
    h,
    h_A,
    h_AA,
    h_AAA,
    hardening,
    harmonics,
    jumps,
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


def saddle_node_onset(m, zeta, alpha, beta):
    """Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.

    Equation (33). Domain: roots with A > 0.
    Operations: 0 structured, 0 common subexpressions, 0 power chains.
    """
    m, zeta, alpha, beta = floats(m, zeta, alpha, beta)
    return stacked(
        (
            1.0,
        ),
        (m, zeta, alpha, beta),
    )


def saddle_nodes(F_0, m, zeta, alpha, beta):
    """Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.

    Equation from (24), (30). Domain: roots with A > 0.
    Operations: 4 structured, 4 common subexpressions, 4 power chains.
    """
    F_0, m, zeta, alpha, beta = floats(F_0, m, zeta, alpha, beta)
    return stacked(
        (
            -4.0 * F_0 * F_0,
            0.0,
            0.0,
            9.0 * beta * beta,
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


if NATIVE is not None:
    (
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
    ) = NATIVE.duffing_mu0_zeta0()
    saddle_node_onset = coefficients_of(saddle_node_onset)
    saddle_nodes = coefficients_of(saddle_nodes)
