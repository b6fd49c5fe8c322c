"""Taylor recurrences: restoring forces as straight-line code for the coefficients of power series.

In:  `Module`s, whose records name the kernels of each piece f(u) of a restoring force and of its slope.
Out: the text of `native/taylor.h`: for each piece one assignment for the coefficient n of each series on the way from u
     to f, and to df/du, and the table of all pieces.

With u(t) a power series, every quantity along the way is one; its coefficient n follows from those up to n of what it
is made of (Cauchy's product and what comes of it for quotients, roots, sine and cosine). The functions that do so are
in src/slowflow/native/exact/series.h.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import jinja2
import sympy as sp

from derivations.emit.compensated import copysign
from derivations.emit.form import Kernel, Module
from derivations.emit.passes import is_constant, straight_line
from derivations.emit.provenance import tools
from derivations.emit.targets.c.printer import CPrinter
from derivations.emit.targets.printing import Unprintable
from derivations.symbols import u

PRINTER = CPrinter()


@dataclass(frozen=True)
class Law:
    """One piece of a force as the template needs it.

    name   -- of the kernel, after that of its module
    prefix -- of its functions
    doc    -- what it is
    force, both -- recurrences of f alone, and of f and df/du
    linear -- whether df/du is a constant
    """

    name: str
    prefix: str
    doc: str
    force: Recurrence
    both: Recurrence
    linear: bool


def text(modules: Sequence[Module], environment: jinja2.Environment) -> str:
    """The file."""
    return environment.get_template("taylor.h.jinja").render(tools=tools(), laws=list(laws(modules)))


def laws(modules: Sequence[Module]) -> Iterator[Law]:
    """Each piece of each force."""
    for module in modules:
        by_name = {kernel.name: kernel for kernel in module.kernels}
        for name, name_of_slope in module.record.pieces if module.record else ():
            force, slope = by_name[name], by_name[name_of_slope]
            yield Law(
                name=f"{module.name}.{name}",
                prefix=f"{module.name}_{name}",
                doc=f"{module.name}: {force.doc} Equation {force.equation}.",
                force=recurrence(force),
                both=recurrence(force, slope),
                linear=not slope.branches[0].outputs[0].has(u),
            )


@dataclass(frozen=True)
class Recurrence:
    """The recurrences of one piece.

    parameters -- those that enter, with their place among the piece's constants
    scalars    -- quantities without u, in order: (name, C expression)
    lines      -- C expressions of the coefficient n of the series 1, 2, ...; series 0 is u
    value, slope -- numbers of the series of f and df/du; slope -1 where it is not asked for
    """

    parameters: tuple[tuple[str, int], ...]
    scalars: tuple[tuple[str, str], ...]
    lines: tuple[str, ...]
    value: int
    slope: int = -1


@dataclass
class _Builder:
    """Series as they are put down; a quantity is the number of its series, or text where u does not enter."""

    known: dict[sp.Symbol, int | str]
    lines: list[str] = field(default_factory=list)
    made: dict[str, int] = field(default_factory=dict)

    def add(self, text: str) -> int:
        """The number of the series with that recurrence; {} in the text stands for its own number."""
        if text not in self.made:
            self.made[text] = len(self.lines) + 1
            self.lines.append(text.format(self.made[text]))
        return self.made[text]

    def of(self, expression: sp.Expr) -> int | str:
        """The number of the expression's series, or its text."""
        if is_constant(expression):
            return PRINTER.doprint(expression)
        if expression.is_Symbol:
            return self.known[expression]
        if isinstance(expression, sp.UnevaluatedExpr):
            return self.of(expression.doit())
        if expression.is_Add:
            return self._sum(expression)
        if expression.is_Mul:
            factor, series = self._product(expression)
            if series is None:
                return factor
            return series if factor == "" else self.add(_scaled(factor, series))
        if expression.is_Pow:
            return self._power(self.of(expression.base), expression.exp)
        if expression.func is copysign:
            size, of = (self.of(argument) for argument in expression.args)
            return f"copysign({size}, {of if isinstance(of, str) else f'w[{of}][0]'})"
        if expression.func in (sp.sin, sp.cos):
            return self._angle(self.of(expression.args[0]), expression.func)
        if expression.func is sp.tan:
            angle = self.of(expression.args[0])
            if isinstance(angle, str):
                return f"tan({angle})"
            return self._quotient(self._angle(angle, sp.sin), self._angle(angle, sp.cos))
        raise Unprintable(f"no recurrence is known for {expression.func}: {expression}")

    def _sum(self, expression: sp.Expr) -> int | str:
        constants, terms = [], []
        for term in expression.as_ordered_terms():
            factor, series = self._product(term) if term.is_Mul else ("", self.of(term))
            if series is None or isinstance(series, str):
                constants.append(factor or series)
            else:
                terms.append(_scaled(factor, series))
        constant = _joined(constants) if constants else ""
        if not terms:
            return f"({constant})"
        return self.add(_joined([f"sf_constant({constant}, n)"] * bool(constants) + terms))

    def _product(self, expression: sp.Expr) -> tuple[str, int | None]:
        """The factor without u, empty for 1, and the series that is left; None where there is none."""
        number, factors = sp.Integer(1), []
        above: list[int] = []
        below: list[int] = []
        for part in expression.as_ordered_factors():
            if is_constant(part):
                number *= part.doit()
                continue
            inverse = part.is_Pow and part.exp.could_extract_minus_sign()
            found = self.of(sp.Pow(part.base, -part.exp)) if inverse else self.of(part)
            if isinstance(found, str):
                factors.append(f"1.0 / ({found})" if inverse else f"({found})" if " " in found else found)
            else:
                (below if inverse else above).append(found)
        if abs(number) != 1 or (number == 1 and not factors and not above and not below):
            factors.insert(0, PRINTER.doprint(abs(number)))
        factor = ("-" if number.is_negative else "") + " * ".join(factors)
        if not above and not below:
            return f"({factor})", None
        numerator, denominator = self._chain(above), self._chain(below)
        if denominator is None:
            return factor, numerator
        return factor, self._quotient("1.0" if numerator is None else numerator, denominator)

    def _chain(self, series: list[int]) -> int | None:
        if not series:
            return None
        product = series[0]
        for other in series[1:]:
            product = self._times(product, other)
        return product

    def _times(self, a: int, b: int) -> int:
        if a == b:
            return self.add(f"sf_square(w[{a}], n)")
        return self.add(f"sf_product(w[{min(a, b)}], w[{max(a, b)}], n)")

    def _quotient(self, above: int | str, below: int | str) -> int:
        if isinstance(below, str):
            return self.add(f"w[{above}][n] / ({below})")
        if isinstance(above, str):
            one = self.add(f"sf_reciprocal(w[{below}], w[{{}}], n)")
            return one if above == "1.0" else self.add(_scaled(above, one))
        return self.add(f"sf_quotient(w[{above}], w[{below}], w[{{}}], n)")

    def _power(self, base: int | str, exponent: sp.Expr) -> int | str:
        if isinstance(base, str):
            symbol = sp.Symbol(f"({base})" if " " in base else base)
            return PRINTER.doprint(sp.Pow(symbol, exponent))
        if exponent.could_extract_minus_sign():
            return self._quotient("1.0", self._power(base, -exponent))
        root = {1: None, 2: "sf_root", 3: "sf_cube_root"}.get(exponent.q if exponent.is_Rational else 0, "")
        if root == "":
            raise Unprintable(f"no recurrence is known for the power {exponent}")
        if root is not None:
            base = self.add(f"{root}(w[{base}], w[{{}}], n)")
        return self._chain([base] * int(exponent.p))

    def _angle(self, angle: int | str, function: type[sp.Function]) -> int | str:
        """Sine and cosine are put down together: each needs the other."""
        if isinstance(angle, str):
            return f"{function.__name__}({angle})"
        first = f"sf_sine(w[{angle}], w[{{}} + 1], n)"
        if first not in self.made:
            self.add(first)
            self.add(f"sf_cosine(w[{angle}], w[{{}} - 1], n)")
        return self.made[first] + (function is sp.cos)


def _scaled(factor: str, series: int) -> str:
    """The coefficient n of a series times a factor; a factor of 1 or -1 is empty or a mere sign."""
    return f"{factor}{'' if factor in ('', '-') else ' * '}w[{series}][n]"


def _joined(terms: list[str]) -> str:
    return "".join(
        term if not i else f" - {term[1:]}" if term[0] == "-" else f" + {term}" for i, term in enumerate(terms)
    )


def recurrence(*kernels: Kernel) -> Recurrence:
    """The recurrences of a piece f(u) whose arguments are u and its constants; or of it and of df/du."""
    constants = tuple(symbol for symbol in kernels[0].arguments if symbol != u)
    branches = [kernel.branches[0] for kernel in kernels]
    lets = list(dict.fromkeys(let for branch in branches for let in branch.lets))
    program = straight_line(lets, [branch.outputs[0] for branch in branches], (u, *constants))
    used = set().union(*(e.free_symbols for e in (*(value for _, value in program.lets), *program.outputs)))
    parameters = tuple((PRINTER.doprint(symbol), i) for i, symbol in enumerate(constants) if symbol in used)
    builder = _Builder({u: 0, **{symbol: PRINTER.doprint(symbol) for symbol in constants}})
    scalars = []
    for symbol, value in program.lets:
        found = builder.of(value)
        if isinstance(found, str):
            scalars.append((symbol.name, found))
            found = symbol.name
        builder.known[symbol] = found
    numbers = []
    for output in program.outputs:
        found = builder.of(output)
        numbers.append(builder.add(f"sf_constant({found}, n)") if isinstance(found, str) else found)
    return Recurrence(parameters, tuple(scalars), tuple(builder.lines), *numbers)
