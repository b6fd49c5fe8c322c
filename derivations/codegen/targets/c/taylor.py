"""Taylor recurrences: restoring forces as straight-line code for the coefficients of power series.

In:  `Module`s, whose records name the kernels of each piece f(u) of a restoring force and of its slope.
Out: the text of `native/taylor.h`: for each piece the leading coefficients of the series on the way from u to f, and to
     df/du, one assignment for each of their coefficients n > 0, and the table of all pieces; `of_one`, the same for one
     module as a source of its own.

With u(t) a power series, every quantity along the way is one; its coefficient n follows from those up to n of what it
is made of: Cauchy's product, and what comes of it for quotients and roots. Any other elementary function y of a series
a has a derivative that is algebraic in series at hand, and so

    y' = a' b       exp (b = y), sin and cos, sinh and cosh (b the other one), tan and tanh (b = 1 +- y^2)
    b y' = a'       log (b = a), and the inverses of circular and hyperbolic functions (b their derivative's reciprocal)
    a y' = r a' y   a power r that is no whole number, which may be a parameter

Each coefficient is a sum of products of two series' coefficients. What is summed of lower coefficients is known before
coefficient n is begun, for all products at once: the sums of four are added side by side (`sf_four` in
src/slowflow/native/exact/series.h). What a force and its slope have in common is one series.

A piece of an odd force that is no odd function itself is stated by the side of u = 0 on which it holds. That side is
the last of its constants, 1 or -1: at u = 0, where two such pieces meet, u does not tell.

A constant enters the leading coefficient alone. So a force that depends on u through a root may be written in powers of
that root beyond it (`by_root`), with fewer products, while its leading coefficient keeps the form in which no digits
cancel.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import jinja2
import sympy as sp
from sympy.codegen.cfunctions import log1p

from ....forces.elliptic import gauss
from ....forces.quadrature import singular_at
from ....symbols import u
from ...compensated import copysign
from ...conventions import FORCE_DEGREE
from ...form import Let, Module
from ...passes import is_constant, straight_line
from ..printing import Unprintable, literal
from .printer import CPrinter

PRINTER = CPrinter()

#: sums that are added side by side
LANES = 4

#: nodes of Gauss's rule on the first step from where a force has no series
NODES = 8

#: led_by_...(expression): the expression, whose leading coefficient the function of that name gives
SECANT, SLOPE = sp.symbols("led_by_secant led_by_slope", cls=sp.Function, real=True)
LED_BY = {SECANT: "secant", SLOPE: "slope"}

#: 1 where a piece holds for u > 0, -1 where it holds for u < 0
SIDE = sp.Symbol("on_side", real=True)

#: y, b, sign: y' = a' b and b' = sign a' y
PAIRED = ((sp.sin, sp.cos, "-"), (sp.sinh, sp.cosh, ""))
#: y' = a' b with b = 1 + sign y^2, by y: what 1/sqrt(b) is of a, sign
BY_SQUARE = {sp.tan: ("cos", ""), sp.tanh: ("cosh", "-")}
#: b y' = a', by y: b of a
INVERSES = {
    sp.log: lambda a: a,
    log1p: lambda a: 1 + a,
    sp.asin: lambda a: sp.sqrt((1 - a) * (1 + a)),
    sp.acos: lambda a: -sp.sqrt((1 - a) * (1 + a)),
    sp.atan: lambda a: 1 + a**2,
    sp.asinh: lambda a: sp.sqrt(1 + a**2),
    sp.acosh: lambda a: sp.sqrt((a - 1) * (a + 1)),
    sp.atanh: lambda a: (1 - a) * (1 + a),
}


#: coefficient n of a series that is made of others, from coefficients 0, 1, n - 1 and n of series, `over`, a reciprocal
#: of coefficients 0, and sums over lower ones: by name the numbers that it takes and the expression, where `below` is
#: sum k of a b for 0 < j < n
BELOW = "(sum[{k}] + (second[{a}] * last[{b}] + last[{a}] * second[{b}]))"
OF_RATIO = BELOW.format(a="{b}", b="{q}", k="{k}")
RULES = {
    "product": ("a b k", f"({BELOW} + w[{{a}}] * first[{{b}}]) + first[{{a}}] * w[{{b}}]", ""),
    "square": ("a k", "sum[{k}] + 2.0 * (second[{a}] * last[{a}] + first[{a}] * w[{a}])", ""),
    "quotient": (
        "a b q k",
        f"(w[{{a}}] - {OF_RATIO}) * over[{{q}}] - w[{{b}}] * (first[{{q}}] * over[{{q}}])",
        "of q = a/b, over = 1/b; the sum is that of b q",
    ),
    "reciprocal": (
        "b q k",
        f"-{OF_RATIO} * over[{{q}}] - w[{{b}}] * (first[{{q}}] * over[{{q}}])",
        "of q = 1/b, likewise",
    ),
    "root": (
        "a s k",
        "(w[{a}] - (sum[{k}] + 2.0 * second[{s}] * last[{s}])) * over[{s}]",
        "of s = sqrt(a), over = 1/(2 s); the sum is that of s s",
    ),
    "power": (
        "a q k r",
        "({r} * (n * w[{a}] * first[{q}] + "
        "(sum[{k}] + (second[{a}] * last[{q}] + (n - 1.0) * last[{a}] * second[{q}])))"
        " - (sum[{k} + 1] + ((n - 1.0) * second[{a}] * last[{q}] + last[{a}] * second[{q}]))) * over[{q}] * over_n",
        "of q = a^r, over = 1/a, from a q' = r a' q; the sums are those of (t a') q and a (t q')",
    ),
    "of_ratio": (
        "a b y k",
        "(n * w[{a}] - (sum[{k}] + ((n - 1.0) * second[{b}] * last[{y}] + last[{b}] * second[{y}]))) * over[{y}]"
        " * over_n",
        "of y from b y' = a', over = 1/b; the sum is that of b (t y')",
    ),
    "of_rate": (
        "a b k",
        "(sum[{k}] + (second[{a}] * last[{b}] + (n - 1.0) * last[{a}] * second[{b}]) + n * w[{a}] * first[{b}])"
        " * over_n",
        "of y from y' = a' b; the sum is that of (t a') b",
    ),
}


def rules() -> list[tuple[str, list[str], str, str]]:
    """Of each its name, numbers that it takes, C, and what it is."""
    found = []
    for name, (taken, expression, doc) in RULES.items():
        numbers = taken.split()
        text = expression.format(**{number: number for number in numbers})
        text = re.sub(r"\b(w|first|second|last|over)\[", r"c->\1[", re.sub(r"\bn\b", "c->n", text))
        text = re.sub(r"\bsum\[([^]]+)\]", r"sf_lane(c->sum, \1)", text.replace("over_n", "sf_over[c->n]"))
        found.append((name, numbers, text, doc))
    return found


@dataclass(frozen=True)
class Body:
    """A C function: declarations (name, expression), and statements."""

    declarations: tuple[tuple[str, str], ...]
    statements: tuple[str, ...]

    @property
    def constants(self) -> tuple[tuple[str, str], ...]:
        """The declarations of what is in the array of constants."""
        return tuple(one for one in self.declarations if one[1].startswith("p["))


def body(known: Sequence[tuple[str, str]], statements: Sequence[str], result: str = "") -> Body:
    """The statements with those of the known quantities, each of which may need earlier ones, that they need."""
    statements = (*statements, f"return {result};") if result else tuple(statements)
    texts, needed = list(statements), []
    for name, value in reversed(known):
        if any(_names(name, text) for text in texts):
            needed.insert(0, (name, value))
            texts.append(value)
    return Body(tuple(needed), statements)


def _takes(number: int, text: str) -> bool:
    """Whether a recurrence takes the first coefficient of that series."""
    numbers = re.search(r"\(c, ([\d, ]+), \d+[,)]", text)
    return f"first[{number}]" in text or (numbers is not None and str(number) in numbers[1].split(", "))


def _names(name: str, text: str) -> bool:
    return re.search(rf"\b{name}\b", text) is not None


@dataclass(frozen=True)
class Recurrences:
    """One piece of a force as the template needs it.

    name   -- of the law
    prefix -- of its functions
    doc    -- what it is
    scalars -- f, df/du and other leading coefficients, by name
    force, both -- recurrences of f alone, and of f and df/du
    powers -- what writes the coefficients of a polynomial in u > 0 and returns its degree; None for any other force
    linear -- whether df/du is a constant
    constants -- how many it takes, without the side of u = 0
    breaks -- what it is at u = 0, or where it begins, as src/slowflow/native/exact/step.h names it
    """

    name: str
    prefix: str
    doc: str
    scalars: dict[str, Body]
    force: Recurrence
    both: Recurrence
    powers: Body | None
    linear: bool
    constants: int
    breaks: str


def text(modules: Sequence[Module], environment: jinja2.Environment) -> str:
    """The file."""
    return _rendered("taylor.h.jinja", modules, environment, gauss(NODES // 2))


def of_one(module: Module, environment: jinja2.Environment) -> str:
    """A source with the pieces of one force, for a library of its own."""
    return _rendered("motion.c.jinja", [module], environment, ())


def _rendered(
    template: str,
    modules: Sequence[Module],
    environment: jinja2.Environment,
    rule: Sequence[tuple[sp.Rational, sp.Rational]],
) -> str:
    found = list(laws(modules))
    return environment.get_template(template).render(
        laws=found,
        rule=[(literal(node), literal(weight)) for node, weight in rule],
        rules=rules(),
    )


def laws(modules: Sequence[Module]) -> Iterator[Recurrences]:
    """Each piece of each force."""
    for module in modules:
        by_name = {kernel.name: kernel for kernel in module.kernels}
        for law in module.record.pieces if module.record else ():
            force, slope = by_name[law.force], by_name[law.slope]
            constants = tuple(symbol for symbol in force.arguments if symbol != u)
            prefix = f"{module.name}_{law.force}"
            (value,), (gradient,) = force.branches, slope.branches
            named = dict.fromkeys((*value.lets, *gradient.lets))
            lets = original = [(symbol, by_side(stated)) for symbol, stated in named]
            outputs = [by_side(value.outputs[0]), by_side(gradient.outputs[0])]
            forms = dict(zip(("value", "slope"), outputs, strict=True))
            both = recurrence(prefix, constants, lets, outputs)
            secant, short = in_powers(outputs, lets)
            if secant is not None:
                other = recurrence(prefix, constants, [], short)
                if len(other.sums) < len(both.sums):
                    lets, outputs, both, forms["secant"] = [], short, other, secant
            scalars = {kind: scalar(original, form, constants) for kind, form in forms.items()}
            if law.begins is not None:
                scalars["begins"] = scalar([], SIDE * law.begins, constants)
            yield Recurrences(
                name=law.name,
                prefix=prefix,
                doc=f"{module.name}: {force.doc} Equation {force.equation}.",
                scalars=scalars,
                force=recurrence(prefix, constants, lets, outputs[:1]),
                both=both,
                powers=powers(original, forms["value"], constants),
                linear=not gradient.lets and not gradient.outputs[0].has(u),
                constants=len(constants),
                breaks=breaks(original, forms["value"]) if law.begins is None else "SF_BEGINS",
            )


def powers(lets: Sequence[Let], force: sp.Expr, constants: tuple[sp.Symbol, ...]) -> Body | None:
    """The coefficients of a force for u > 0."""
    stated = in_full(lets, force).xreplace({SIDE: sp.Integer(1)})
    if not stated.is_polynomial(u) or sp.degree(stated, u) > FORCE_DEGREE:
        return None
    coefficients = sp.Poly(stated, u).all_coeffs()[::-1]
    lines = [f"c[{power}] = {PRINTER.doprint(factor)};" for power, factor in enumerate(coefficients)]
    return body(packed(constants), lines, str(len(coefficients) - 1))


def in_full(lets: Sequence[Let], expression: sp.Expr) -> sp.Expr:
    """An expression without lets."""
    for symbol, stated in reversed(lets):
        expression = expression.xreplace({symbol: stated})
    return expression


def breaks(lets: Sequence[Let], force: sp.Expr) -> str:
    """What a piece is at u = 0."""
    force = in_full(lets, force)
    if not force.has(SIDE):
        return "SF_SMOOTH"
    return "SF_BRANCHES" if singular_at(force.xreplace({SIDE: sp.Integer(1)}), sp.Integer(0)) else "SF_MEETS"


def in_powers(outputs: Sequence[sp.Expr], lets: Sequence[Let]) -> tuple[sp.Expr | None, list[sp.Expr]]:
    """f/u of an odd force, and the force with its slope in powers of their root but for the leading coefficients.

    None and nothing for a force that does not have this form.
    """
    value, slope = outputs
    if not (value.is_Mul and u in value.args):
        return None, []
    secant = sp.Mul(*(factor for factor in value.args if factor != u))
    ratio, gradient = (by_root(in_full(lets, form)) for form in (secant, slope))
    if ratio is None or gradient is None:
        return None, []
    return secant, [u * SECANT(ratio), SLOPE(gradient)]


def by_root(expression: sp.Expr) -> sp.Expr | None:
    """An expression of u^2 and one root s = sqrt(a + b u^2), as a sum of powers of s; None for any other.

    With u^2 = (s^2 - a)/b it is a rational function of s, whose denominator has to be a power of s.
    """
    powers = [power for power in expression.atoms(sp.Pow) if not power.exp.is_Integer]
    radicands = {power.base for power in powers}
    if len(radicands) != 1 or any(not power.exp.is_Rational or power.exp.q != 2 for power in powers):
        return None
    (radicand,) = radicands
    if not radicand.is_polynomial(u):
        return None
    terms = dict(sp.Poly(radicand, u).terms())
    if set(terms) != {(2,), (0,)}:
        return None
    a, b = terms[0,], terms[2,]
    s = sp.Symbol("s", positive=True)
    rational = expression.subs(sp.sqrt(radicand), s)
    if not rational.is_rational_function(u, s):
        return None
    halves = [sp.Poly(part, u).terms() for part in sp.fraction(sp.cancel(rational))]
    if any(power % 2 for half in halves for (power,), _ in half):
        return None
    above, below = (sum(c * ((s**2 - a) / b) ** (power // 2) for (power,), c in half) for half in halves)
    numerator, denominator = (sp.Poly(part, s) for part in sp.fraction(sp.cancel(above / below)))
    if len(denominator.terms()) != 1:
        return None
    ((degree,), divisor) = denominator.terms()[0]
    root = sp.sqrt(radicand)
    return sp.Add(*(c / divisor * root ** (power - degree) for (power,), c in numerator.terms()))


def scalar(lets: Sequence[Let], expression: sp.Expr, constants: tuple[sp.Symbol, ...]) -> Body:
    """A function of the constants p and u."""
    program = straight_line(lets, [expression], (u, *constants, SIDE))
    known = [*packed(constants), *((symbol.name, PRINTER.doprint(value)) for symbol, value in program.lets)]
    return body(known, (), PRINTER.doprint(program.outputs[0]))


def packed(constants: tuple[sp.Symbol, ...]) -> list[tuple[str, str]]:
    """The constants by their names; the last is the side of u = 0 on which the piece holds."""
    return [(PRINTER.doprint(symbol), f"p[{i}]") for i, symbol in enumerate((*constants, SIDE))]


def by_side(expression: sp.Expr) -> sp.Expr:
    """An expression in the side of u = 0 in place of the sign of u; a contact's, beyond where it begins."""
    stated = expression.replace(copysign, lambda size, of: size * SIDE if of == u else copysign(size, of))
    return stated.replace(sp.Abs, lambda of: SIDE * of if of == u else of)


@dataclass(frozen=True)
class Line:
    """One series.

    leading -- its first coefficient, from the `first` ones of series before it
    further -- its coefficient n > 0, from those of series before it in `w`, all first ones and sums over lower ones
    over    -- a reciprocal of first coefficients that `further` takes, "" for none
    """

    leading: str
    further: str
    over: str = ""


@dataclass(frozen=True)
class Recurrence:
    """The recurrences of one piece.

    known      -- constants of the piece and quantities without u, in order: (name, C expression)
    lines      -- the series 1, 2, ...; series 0 is u
    sums       -- pairs of coefficients n: sum k holds left[j] right[n - j] of pair k for 0 < j < n
    value, slope -- numbers of the series of f and df/du; slope -1 where it is not asked for
    """

    known: tuple[tuple[str, str], ...]
    lines: tuple[Line, ...]
    sums: tuple[tuple[str, str], ...]
    value: int
    slope: int = -1

    @property
    def begin(self) -> Body:
        """All first coefficients that anything is made of, and reciprocals."""
        made: list[str] = []
        texts = [line.further for line in self.lines]
        for number, line in reversed(list(enumerate(self.lines, 1))):
            if number in (self.value, self.slope) or any(_takes(number, text) for text in texts):
                made = (
                    [f"first[{number}] = {line.leading};"] + [f"over[{number}] = {line.over};"] * bool(line.over) + made
                )
                texts += [line.leading, line.over]
        return body(self.known, made)

    @property
    def next(self) -> Body:
        """All coefficients n > 0, and what they contribute to the sums, four by four."""
        # a constant may take the sign of a first coefficient
        known = [(name, value.replace("first[", "c->first[")) for name, value in self.known]
        further = [line.further.replace("first[", "c->first[") for line in self.lines]
        made = [f"w[{number}] = {line};" for number, line in enumerate(further, 1)]
        for i in range(self.fours):
            left, right = zip(*self.padded[LANES * i : LANES * (i + 1)], strict=True)
            made += [f"left[{i}] = sf_four_of({', '.join(left)});", f"right[{i}] = sf_four_of({', '.join(right)});"]
        return body(known, made)

    @property
    def padded(self) -> list[tuple[str, str]]:
        """The pairs, filled up to whole groups."""
        return [*self.sums, *[("0.0", "0.0")] * (-len(self.sums) % LANES)]

    @property
    def fours(self) -> int:
        """Groups of sums."""
        return -(-len(self.sums) // LANES)


@dataclass
class _Builder:
    """Series as they are put down; a quantity is the number of its series, or text where u does not enter."""

    prefix: str
    known: dict[sp.Symbol, int | str]
    lines: list[Line] = field(default_factory=list)
    sums: list[tuple[str, str]] = field(default_factory=list)
    made: dict[tuple[object, ...], int] = field(default_factory=dict)
    functions: dict[tuple[type[sp.Function], int], int] = field(default_factory=dict)

    def add(self, leading: str, further: str, pairs: Sequence[tuple[str, str]] = (), over: str = "") -> int:
        """The number of the series with these recurrences.

        In the texts {own} stands for that number, {0} for that of the sum over the first pair.
        """
        key = (leading, further, *pairs, over)
        if key not in self.made:
            self.made[key] = own = len(self.lines) + 1
            first_sum = len(self.sums)
            self.sums += [(a.format(own=own), b.format(own=own)) for a, b in pairs]
            self.lines.append(Line(*(part.format(first_sum, own=own) for part in (leading, further, over))))
        return self.made[key]

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
            return series if factor == "" else self._times_constant(factor, series)
        if expression.is_Pow:
            return self._power(self.of(expression.base), expression.exp)
        if expression.func in LED_BY:
            found = self.of(expression.args[0])
            return self.add(f"{self.prefix}_{LED_BY[expression.func]}(NULL, p, first[0])", f"w[{found}]")
        if isinstance(expression, sp.Function):
            inner = self.of(*expression.args)
            if isinstance(inner, str):
                return PRINTER.doprint(expression.func(_named(inner)))
            return self._function(expression.func, inner)
        raise Unprintable(f"no recurrence is known for {expression.func}: {expression}")

    def _sum(self, expression: sp.Expr) -> int | str:
        constants, first, further = [], [], []
        for term in expression.as_ordered_terms():
            factor, series = self._product(term) if term.is_Mul else ("", self.of(term))
            if series is None or isinstance(series, str):
                constants.append(factor or series)
            else:
                first.append(_scaled(factor, "first", series))
                further.append(_scaled(factor, "w", series))
        if not first:
            return f"({_joined(constants)})"
        return self.add(_joined(constants + first), _joined(further))

    def _product(self, expression: sp.Expr) -> tuple[str, int | None]:
        """The factor without u, empty for 1, and the series that is left; None where there is none."""
        number, factors = sp.Integer(1), []
        above: list[int] = []
        below: list[int] = []
        for part in expression.as_ordered_factors():
            if is_constant(part):
                number *= part.doit()
                continue
            inverse = part.is_Pow and part.exp.is_Integer and part.exp.could_extract_minus_sign()
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
        a, b = min(a, b), max(a, b)
        if a == b:
            return self.add(f"first[{a}] * first[{a}]", f"sf_square(c, {a}, {{0}})", [(f"w[{a}]", f"w[{a}]")])
        return self.add(f"first[{a}] * first[{b}]", f"sf_product(c, {a}, {b}, {{0}})", [(f"w[{a}]", f"w[{b}]")])

    def _quotient(self, above: int | str, below: int | str) -> int:
        if isinstance(below, str):
            return self.add(f"first[{above}] / ({below})", f"w[{above}] / ({below})")
        if isinstance(above, str):
            one = self.add(
                f"1.0 / first[{below}]",
                f"sf_reciprocal(c, {below}, {{own}}, {{0}})",
                [(f"w[{below}]", "w[{own}]")],
                f"1.0 / first[{below}]",
            )
            return one if above == "1.0" else self._times_constant(above, one)
        return self.add(
            f"first[{above}] / first[{below}]",
            f"sf_quotient(c, {above}, {below}, {{own}}, {{0}})",
            [(f"w[{below}]", "w[{own}]")],
            f"1.0 / first[{below}]",
        )

    def _power(self, base: int | str, exponent: sp.Expr) -> int | str:
        raised = self.of(exponent)
        if isinstance(base, str):
            if isinstance(raised, str):
                return PRINTER.doprint(sp.Pow(_named(base), exponent if is_constant(exponent) else _named(raised)))
            return self._function(sp.exp, self._times_constant(f"log({base})", raised))
        if not isinstance(raised, str):
            return self._function(sp.exp, self._times(raised, self._function(sp.log, base)))
        if exponent.is_Rational and exponent.q == 2:
            # odd powers of a root by its radicand, which is at hand
            root = self._root(base)
            whole = self._chain([base] * (int(abs(exponent.p)) // 2))
            if exponent.is_positive:
                return root if whole is None else self._times(whole, root)
            one = self._quotient("1.0", root)
            return one if whole is None else self._quotient(one, whole)
        if not exponent.is_Integer:
            return self._broken_power(base, exponent, raised)
        if exponent.is_negative:
            return self._quotient("1.0", self._power(base, -exponent))
        found = self._chain([base] * int(exponent))
        assert found is not None
        return found

    def _root(self, base: int) -> int:
        return self.add(
            f"sqrt(first[{base}])",
            f"sf_root(c, {base}, {{own}}, {{0}})",
            [("w[{own}]", "w[{own}]")],
            "0.5 / first[{own}]",
        )

    def _broken_power(self, base: int, exponent: sp.Expr, raised: str) -> int:
        """From a y' = r a' y."""
        leading = sp.Pow(sp.Symbol("BASE"), exponent if is_constant(exponent) else _named(raised))
        return self.add(
            PRINTER.doprint(leading).replace("BASE", f"first[{base}]"),
            f"sf_power(c, {base}, {{own}}, {{0}}, {raised})",
            [(f"c->n * w[{base}]", "w[{own}]"), (f"w[{base}]", "c->n * w[{own}]")],
            f"1.0 / first[{base}]",
        )

    def _function(self, function: type[sp.Function], of: int) -> int:
        if (function, of) not in self.functions:
            self._put_down(function, of)
        return self.functions[function, of]

    def _put_down(self, function: type[sp.Function], of: int) -> None:
        """The series of a function; of two, of which each is the other's derivative, both."""
        own = len(self.lines) + 1
        self.functions[function, of] = own
        if function is sp.exp:
            self._by_rate("exp", of, own)
        elif function in BY_SQUARE:
            partner, sign = BY_SQUARE[function]
            self._by_rate(function.__name__, of, own + 2)
            square = self._times(own, own)
            root = f"{partner}(first[{of}])"
            self.add(f"1.0 / ({root} * {root})", _scaled(sign, "w", square))
        elif function in INVERSES:
            argument = sp.Symbol(f"series_{of}", real=True)
            self.known[argument] = of
            rate = self.of(INVERSES[function](argument))
            self.functions[function, of] = self.add(
                f"{function.__name__}(first[{of}])",
                f"sf_of_ratio(c, {of}, {rate}, {{own}}, {{0}})",
                [(f"w[{rate}]", "c->n * w[{own}]")],
                f"1.0 / first[{rate}]",
            )
        else:
            for one, other, sign in PAIRED:
                if function in (one, other):
                    self.functions |= {(one, of): own, (other, of): own + 1}
                    self._by_rate(one.__name__, of, own + 1)
                    self._by_rate(other.__name__, of, own, sign)
                    return
            raise Unprintable(f"no recurrence is known for {function}")

    def _by_rate(self, name: str, of: int, rate: int, sign: str = "") -> None:
        self.add(
            f"{name}(first[{of}])",
            f"{sign}sf_of_rate(c, {of}, {rate}, {{0}})",
            [(f"c->n * w[{of}]", f"w[{rate}]")],
        )

    def _times_constant(self, factor: str, series: int) -> int:
        return self.add(_scaled(factor, "first", series), _scaled(factor, "w", series))


def _named(text: str) -> sp.Symbol:
    """A symbol that prints as that text."""
    return sp.Symbol(f"({text})" if " " in text else text, real=True)


def _scaled(factor: str, of: str, series: int) -> str:
    """A coefficient of a series times a factor; a factor of 1 or -1 is empty or a mere sign."""
    return f"{factor}{'' if factor in ('', '-') else ' * '}{of}[{series}]"


def _joined(terms: list[str]) -> str:
    return "".join(
        term if not i else f" - {term[1:]}" if term[0] == "-" else f" + {term}" for i, term in enumerate(terms)
    )


def recurrence(
    prefix: str, constants: tuple[sp.Symbol, ...], lets: Sequence[Let], outputs: Sequence[sp.Expr]
) -> Recurrence:
    """The recurrences of a piece f(u) with its constants; or of it and of df/du."""
    program = straight_line(lets, outputs, (u, *constants, SIDE))
    known = packed(constants)
    builder = _Builder(prefix, {u: 0, **{symbol: PRINTER.doprint(symbol) for symbol in (*constants, SIDE)}})
    for symbol, value in program.lets:
        found = builder.of(value)
        if isinstance(found, str):
            known.append((symbol.name, found))
            found = symbol.name
        builder.known[symbol] = found
    numbers = []
    for output in program.outputs:
        found = builder.of(output)
        numbers.append(builder.add(found, "0.0") if isinstance(found, str) else found)
    return Recurrence(tuple(known), tuple(builder.lines), tuple(builder.sums), *numbers)
