"""Step 5, equations (33) and (34): the critical forcings by elimination of Omega.

In:  the slow flow and the averaged force of the first regime (a polynomial in A).
Out: `Elimination`: a resultant with its coefficients by power, the powers that vanish, content and factors.

A root of a resultant is a candidate only: elimination adds roots (Omega negative or complex, A negative), so each one
has to be tried in the system that it came from.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from ..claims import claim
from ..kernels import Formulas
from ..symbols import F_0, A, Omega, h, h_A, h_AA, zeta
from .restoring_force import Restoring
from .slow_flow import I, R, m


@dataclass(frozen=True)
class Elimination:
    """A resultant in Omega, as a polynomial in one quantity.

    unknown      -- the quantity
    coefficients -- by power of the unknown, exact, content divided out; powers that vanish identically are absent
    reduced      -- the same for the product of the factors that hold a root to look for: each factor once, without
                    powers of the unknown itself and without factors free of it
    content      -- the rational factor divided out
    factors      -- (factor, multiplicity) over the rationals, all symbols kept
    degree       -- in the unknown
    """

    unknown: sp.Symbol
    coefficients: dict[int, sp.Expr]
    reduced: dict[int, sp.Expr]
    content: sp.Rational
    factors: tuple[tuple[sp.Expr, int], ...]

    @property
    def degree(self) -> int:
        return max(self.coefficients)

    @property
    def by_even_power(self) -> tuple[sp.Expr, ...]:
        """Coefficients of the reduced resultant by even power of its unknown, constant first, zeros included."""
        odd = [power for power in self.reduced if power % 2]
        claim(f"the resultant has even powers of `{self.unknown}` only", not odd)
        top = max(self.reduced)
        return tuple(in_factors(self.reduced.get(power, sp.Integer(0))) for power in range(0, top + 1, 2))


def in_factors(value: sp.Expr) -> sp.Expr:
    """A polynomial by its factors, and these by powers of m, each with a coefficient that is factored in turn.

    Expanded powers of a small difference lose its digits.
    """
    constant, factors = _factors(value)
    by_m = (sp.collect(base, m, _factored) if base.is_Add else base for base, _ in factors)
    return sp.Mul(constant, *(base**count for base, (_, count) in zip(by_m, factors, strict=True)))


def _factored(value: sp.Expr) -> sp.Expr:
    """`sp.factor` of a polynomial with rational coefficients, in a tenth of its time."""
    constant, factors = _factors(value)
    product = sp.Mul(*(base**count for base, count in factors))
    # unevaluated, or SymPy would multiply a number into a lone sum
    return constant * product if abs(constant) == 1 else sp.Mul(constant, *sp.Mul.make_args(product), evaluate=False)


def _factors(value: sp.Expr) -> tuple[sp.Rational, list[tuple[sp.Expr, int]]]:
    """A rational factor, and the irreducible ones with how often they are there, integers without a common divisor."""
    if value.is_Rational:
        return value, []
    polynomial = sp.Poly(value)
    symbols = polynomial.gens
    constant, factors = _to_flint(polynomial, symbols, _ring(symbols)).factor()
    found = [(_to_sympy(factor.to_dict(), symbols), int(count)) for factor, count in factors]
    return sp.Rational(int(constant.p), int(constant.q)), found


def _ring(symbols: Sequence[sp.Symbol]) -> fmpq_mpoly_ctx:
    return fmpq_mpoly_ctx.get([symbol.name for symbol in symbols], Ordering.lex)


def _to_flint(expression: sp.Expr | sp.Poly, symbols: Sequence[sp.Symbol], ring: fmpq_mpoly_ctx) -> fmpq_mpoly:
    terms = sp.Poly(expression, *symbols).terms()
    return ring.from_dict({powers: fmpq(int(value.p), int(value.q)) for powers, value in terms})


def _to_sympy(terms: Mapping[Sequence[int], fmpq], symbols: Sequence[sp.Symbol]) -> sp.Expr:
    exact = {tuple(powers): sp.Rational(int(value.p), int(value.q)) for powers, value in terms.items()}
    return sp.Poly.from_dict(exact, *symbols).as_expr()


def eliminate(first: sp.Expr, second: sp.Expr, variable: sp.Symbol, unknown: sp.Symbol) -> Elimination:
    """Res_variable(first, second) of two polynomials with rational coefficients, ordered by the unknown."""
    others = sorted((first.free_symbols | second.free_symbols) - {variable, unknown}, key=lambda symbol: symbol.name)
    symbols = (variable, unknown, *others)
    ring = _ring(symbols)
    resultant = _to_flint(first, symbols, ring).resultant(_to_flint(second, symbols, ring), variable.name)
    if resultant == 0:
        # the two vanish together whatever the unknown is: no value of it stands out
        return Elimination(unknown, {0: sp.Integer(0)}, {0: sp.Integer(0)}, sp.Rational(0), ())
    constant, factored = resultant.factor()
    factors = [(_to_sympy(factor.to_dict(), symbols), int(count)) for factor, count in factored]
    telling = ring.constant(1)
    for factor, _ in factored:
        if factor.degrees()[1] and len(factor) > 1:
            telling *= factor
    return Elimination(
        unknown,
        _by_power(resultant / constant, symbols),
        _by_power(telling, symbols),
        sp.Rational(int(constant.p), int(constant.q)),
        tuple(sorted(factors, key=lambda pair: sp.srepr(pair[0]))),
    )


def _by_power(polynomial: fmpq_mpoly, symbols: Sequence[sp.Symbol]) -> dict[int, sp.Expr]:
    """By power of the second symbol."""
    found: dict[int, dict[Sequence[int], fmpq]] = {}
    for (first, power, *others), value in polynomial.to_dict().items():
        found.setdefault(int(power), {})[first, 0, *others] = value
    return {power: _to_sympy(terms, symbols) for power, terms in sorted(found.items())}


def _expanded(flow: Formulas, expression: sp.Expr) -> sp.Expr:
    return sp.expand(expression.subs({R: flow.R, I: flow.I}))


def saddle_node_onset(flow: Formulas, restoring: Restoring) -> Elimination:
    """(33): Res_Omega(F_A, F_AA) with the first regime's averaged force; its roots A_s are candidates for the onset."""
    derivatives = restoring.regimes[0].derivatives
    in_A = {h: derivatives[0], h_A: derivatives[1], h_AA: derivatives[2]}
    return eliminate(*(_expanded(flow, F).subs(in_A).expand() for F in (flow.F_A, flow.F_AA)), Omega, A)


def saddle_nodes(flow: Formulas, restoring: Restoring) -> Elimination:
    """Res_Omega(F, F_A) with the averaged force of the first regime: every fold at one F_0 is among its roots in A."""
    derivatives = restoring.regimes[0].derivatives
    in_A = {h: derivatives[0], h_A: derivatives[1]}
    return eliminate(*(_expanded(flow, F).subs(in_A).expand() for F in (flow.F, flow.F_A)), Omega, A)


def detachment(flow: Formulas) -> Elimination:
    """(34): Res_Omega(F, F_Omega) as a polynomial in F_0, for A = u_cr and its h; its roots are candidates for F_cr."""
    return eliminate(_expanded(flow, flow.F), _expanded(flow, flow.F_Omega), Omega, F_0)


def detached(flow: Formulas) -> Formulas:
    """The kernel of that, and the `Elimination` itself as `resultant`."""
    of = Formulas((A, m, zeta, h), domain="A > 0")
    of.resultant = detachment(flow)
    text = "Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr."
    of.add("detachment", of.resultant.by_even_power, text, "(34)", returns="stack")
    return of
