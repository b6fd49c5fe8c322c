"""How often a stationary motion passes a level, and the largest |u| within a time. Takes a motion and its equation.

A motion that is lightly damped keeps its energy over many cycles. By that, V the potential of f less the load, let

    z = sqrt(2 (V(u) - V(B))/k)/u_rms     where it turns,     I = 2 <r sin psi>     for a velocity z v_rms sin psi

with the equivalent linear oscillator's k and c, and r the damping force, which takes the power I z v_rms/2. As the
excitation feeds in c v_rms^2 on average, z has the stationary density (stochastic averaging of the energy)

    p(z) = N z exp(-int_0^z I dz/(c v_rms)),     Rayleigh's for a linear oscillator

A level is passed once a cycle by all motions of more energy, at the rate nu = (v_rms/u_rms) P(z)/(2 pi) to each side.
These passages come in clusters, since the energy takes its time: it comes to z once in

    T(z) = int_0^z 2/(b z p) int_0^z p dz dz,     b = (int G dOmega)^2/int G^2 dOmega/pi

on average, the mean time of first passage of a diffusion. b tells how fast the energy varies, G is the spectral density
of the response: b = c under white noise. First passages then have the rate nu (1 - exp(-1/(nu T))), where clusters are
as large as Vanmarcke takes them to be, and exp(-rate tau) is the share of motions that have not passed after tau.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from slowflow.core.mechanism import EquationOfMotion, Floats
from slowflow.random_vibration.fokker_planck import damping_force
from slowflow.support.quadrature import gauss

#: root mean squares up to which displacements are counted at least, and beyond the likely one, and steps up to there
FARTHEST, BEYOND, STEPS = 12.0, 6.0, 2000
#: z at which P underflows; angles of half a cycle; points of a response's spectrum, and decades on either side
MOST, NODES, POINTS, DECADES = 38.0, 24, 2000, 4
_AT, _WEIGHTS = gauss(NODES)
_COS, _SIN = np.cos(np.pi * _AT), np.sin(np.pi * _AT)


def largest(of: Any, system: EquationOfMotion, motion: int, tau: float) -> float:
    """Mean of the largest |u| of one of the motions of a `RandomResponse` within a duration."""
    B, u, v, k, c = (float(one[motion]) for one in (of.B, of.u_rms, of.v_rms, of.stiffness, of.damping))
    likely = math.sqrt(2 * max(math.log(tau) + math.log(v / u), 0.0))
    distance = np.linspace(0.0, max(FARTHEST, likely + BEYOND) * u, STEPS)
    z_of_sides = []
    for side in (1.0, -1.0):
        middles = B + side * 0.5 * (distance[1:] + distance[:-1])
        V = np.append(0.0, np.cumsum(side * (system.force(middles) - system.load) * np.diff(distance)))
        z_of_sides.append(np.sqrt(np.maximum.accumulate(np.maximum(2 * V / k, 0.0))) / u)
    z = np.linspace(0.0, min(MOST, *(float(one[-1]) for one in z_of_sides)), STEPS)
    right, left = (np.interp(z, one, distance)[:, np.newaxis] for one in z_of_sides)
    at = B + np.where(_COS > 0, right, left) * _COS
    I = 2 * (damping_force(system, at, v * z[:, np.newaxis] * _SIN) * _SIN) @ _WEIGHTS
    rate = _first_passages(z, _integral(I / (c * v), z), v / u, _bandwidth(of, motion))
    level = np.linspace(0.0, abs(B) + distance[-1], 2 * STEPS)
    beyond = np.maximum(level, abs(B))  # nearer ones than the mean are passed at least as surely as that
    passed = sum(
        0.5 * np.interp(np.interp(beyond - side * B, distance, one), z, rate)
        for side, one in zip((1.0, -1.0), z_of_sides, strict=True)
    )
    return float(np.trapezoid(-np.expm1(-tau * passed), level))


def _integral(values: Floats, z: Floats) -> Floats:
    return np.append(0.0, np.cumsum(0.5 * (values[1:] + values[:-1]) * np.diff(z)))


def _first_passages(z: Floats, exponent: Floats, Omega: float, b: float) -> Floats:
    """The rate at which z is first passed, to either of two sides."""
    with np.errstate(all="ignore"):
        p = z * np.exp(-exponent)
        below, above = _integral(p, z), -_integral(p[::-1], z[::-1])[::-1]
        nu = Omega / math.pi * above / below[-1]
        T = _integral(np.where(z > 0, 2 * below * np.exp(exponent) / (b * z), 0.0), z)
        return np.where(nu * T > 0, nu * -np.expm1(-1 / (nu * T)), np.where(z > 0, 0.0, nu))


def _bandwidth(of: Any, motion: int) -> float:
    """b: of a linear oscillator under white noise whose energy varies as fast the damping c."""
    Omega_e, ratio = float(of.Omega_e[motion]), min(float(of.ratio_e[motion]), 1.0)
    far = np.geomspace(10.0**-DECADES, 10.0**DECADES, POINTS)
    near = 1 + ratio * np.sinh(np.linspace(-math.asinh(1 / ratio), math.asinh(1 / ratio), POINTS))
    Omega = Omega_e * np.unique(np.concatenate((far, near[near > 0])))
    density = of.response_psd(Omega)[motion]
    return float(np.trapezoid(density, Omega) ** 2 / np.trapezoid(density**2, Omega) / math.pi)
