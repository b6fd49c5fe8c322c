"""Step 1 once more, equation (4): what each dimensionless number is measured in, a product of powers of k_v, L and m.

In:  the dimensionless groups, or a mechanism's ratios.
Out: `Scale`s: a dimensional letter is its dimensionless number times the scale; of F_0 by what it is the amplitude of.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..mechanisms import L, Mechanism, k_v, x
from ..paper import equation_of_motion as osc
from ..symbols import F_0, Omega, c_2, c_3, eta, mu, tau, u, zeta, zeta_2
from . import inertia

#: the factors of |x'|x', x'^3 and x^2 x' in (1), and the loss factor of k_v, whose force is eta k_v x'/omega
c_q, c_c, c_xx, loss = sp.symbols("c_q c_c c_xx eta", positive=True)


@dataclass(frozen=True)
class Scale:
    """factor k_v^(power) L^(power) m^(power)."""

    letter: sp.Symbol  #: the dimensional quantity
    factor: sp.Expr
    powers: tuple[sp.Rational, ...]  #: of k_v, L and m


def scale(group: sp.Expr, letter: sp.Symbol, bases: tuple[sp.Symbol, ...]) -> Scale:
    """What a group measures its letter in; it has to be the letter over a product of powers."""
    unit = sp.simplify(letter / group)
    powers = tuple(sp.simplify(base * sp.diff(unit, base) / unit) for base in bases)
    factor = sp.simplify(unit / sp.Mul(*(base**power for base, power in zip(bases, powers, strict=True))))
    if not factor.is_positive or factor.free_symbols or not all(power.is_Rational for power in powers):
        raise ArithmeticError(f"{group} is not {letter} over a product of powers of {bases}")
    return Scale(letter, factor, powers)


def of_every_oscillator() -> dict[sp.Symbol, Scale]:
    """Of the numbers that all have: displacement, time, frequency, forcing, friction, damping."""
    groups = osc.groups(k_v, L)
    letters = {u: x, tau: osc.t, Omega: osc.omega, F_0: osc.F, mu: osc.F_c, zeta: osc.c}
    values = {u: x / L, tau: groups[osc.omega_n] * osc.t} | groups
    natural = {osc.omega_n: groups[osc.omega_n]}
    bases = (k_v, L, osc.m)
    return {number: scale(values[number].subs(natural), letter, bases) for number, letter in letters.items()}


def of_every_law() -> dict[sp.Symbol, Scale]:
    """Of the numbers of other laws of damping, whose forces are scaled as (1) is."""
    forces = {
        c_2: c_q * osc.u_dot**2,
        c_3: c_c * osc.u_dot**3,
        eta: loss * k_v / osc.omega * osc.u_dot,
        zeta_2: c_xx * (L * u) ** 2 * osc.u_dot,
    }
    own = {c_2: osc.u_dot**2, c_3: osc.u_dot**3, eta: osc.u_dot / Omega, zeta_2: 2 * u**2 * osc.u_dot}
    groups, bases = osc.groups(k_v, L), (k_v, L, osc.m)
    natural, letters = groups[osc.omega_n], {c_2: c_q, c_3: c_c, eta: loss, zeta_2: c_xx}
    found = {}
    for number, force in forces.items():
        # x' = L omega_n u', over k_v L
        scaled = force.subs({osc.u_dot: L * natural * osc.u_dot, osc.omega: Omega * natural}) / (k_v * L)
        found[number] = scale(sp.simplify(scaled / own[number]), letters[number], bases)
    return found


def of_every_excitation() -> dict[str, Scale]:
    """Of F_0, by the excitation that it is the amplitude of: a force F, a base's Y, an unbalance's U = m_u e."""
    U = sp.Symbol("U", positive=True)
    letters = {"base": inertia.Y, "unbalance": U}
    bases = (k_v, L, osc.m)
    found = {"force": of_every_oscillator()[F_0]}
    for name in inertia.EXCITATIONS:
        amplitude = inertia.amplitude_of(name).subs(inertia.m_u, U / inertia.e)
        found[name] = scale(amplitude, letters[name], bases)
    return found


def of_design(mechanism: Mechanism) -> tuple[Scale, ...]:
    """Of a design's numbers, in their order; none where these are not the ratios."""
    if tuple(parameter.symbol for parameter in mechanism.design) != tuple(mechanism.ratios):
        return ()
    bases = (mechanism.k_v, mechanism.length, osc.m)
    found = []
    for ratio in mechanism.ratios.values():
        (letter,) = ratio.free_symbols - set(bases)
        found.append(scale(ratio, letter, bases))
    return tuple(found)
