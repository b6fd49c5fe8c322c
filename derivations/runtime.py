"""A mechanism that is stated in a running program: from pieces of a force to the sources of its kernels and its record.

In:  a name, the pieces of u + F_k(u) as SymPy expressions, the parameters.
Out: `stated`, the `Mechanism` that a file of `mechanisms/` would hold; `sources`, what `codegen/` prints for it: a
     Python module, and C headers with a record that the compiled solvers take; `told`, its derivation as a document;
     `written`, both as files.

A piecewise polynomial has a closed average, and solvers know of it what `monotone` proves; where it proves nothing, and
of any other force, whose average is a quadrature, they take what holds it between two amplitudes.

Nothing here reads a string as code: forces are SymPy expressions already, and names are names.
"""

from __future__ import annotations

import hashlib
import keyword
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import sympy as sp

from slowflow.support.errors import NotSettled, Refused

from . import given as given_by
from .asymmetric.sided import Sided
from .asymmetric.sided import check as check_sided
from .codegen.catalogue.bent import with_bends
from .codegen.catalogue.mechanism import mechanism_module, with_proofs
from .codegen.catalogue.quadrature import quadrature_module
from .codegen.catalogue.sided import sided_module
from .codegen.form import Module
from .codegen.measured import AT_RUNTIME
from .codegen.provenance import versions
from .codegen.targets import numpy, program
from .codegen.views import programs
from .codegen.write import MANIFEST, as_json, write
from .forces.monotone import not_shown, smooth_end
from .forces.of_mechanism import OfMechanism, of_mechanism
from .forces.quadrature import FUNCTIONS, Quadrature, singular_at, v
from .mechanisms import DAMPING, DISSIPATION, FORCING, UNIT, Mechanism, Parameter, Piece
from .page import Page
from .paper.averaging import averaged
from .paper.equation_of_motion import oscillator, without_poles_that_cancel
from .paper.slow_flow import slow_flow
from .symbols import u
from .vanishing import reduced, vanishes

#: a user's parameter may have their names
_x = sp.Dummy("x", real=True)
_k_v, _L = sp.Dummy("k_v", positive=True), sp.Dummy("L", positive=True)
_above = sp.Symbol("above", positive=True)
#: what a parameter may not be called: it has that meaning already
TAKEN = {"u", "A", "Omega", "out", "contact", "load", "excitation"}
TAKEN |= {one.symbol.name for one in (*DAMPING, *DISSIPATION, FORCING)}
#: words of C11 that are names in Python: the printed C would not compile
WORDS_OF_C = frozenset(
    "auto case char const default do double enum extern float goto inline int long register restrict short signed "
    "sizeof static struct switch typedef union unsigned void volatile".split()
)
HERE = Path(__file__).parent
DOCUMENT = "derivation"


@dataclass(frozen=True)
class Sources:
    """What is derived of one mechanism, printed where it is asked for: NumPy answers without any C.

    module  -- its kernels and its record; its name has a hash of all that it follows from
    derived -- steps of the derivation that compiled solvers need more of; None where the module has them
    odd     -- whether the force is: only such a one has a record in C
    """

    module: Module
    derived: OfMechanism | None = None
    odd: bool = True

    @cached_property
    def solved(self) -> Module:
        """The module with all that compiled solvers ask of it."""
        return self.module if self.derived is None else with_proofs(self.module, self.derived)

    @property
    def python(self) -> dict[str, str]:
        """The module by file name, after what is interpreted: its motion, and of an odd force its record."""
        text = numpy.text(self.module, programs(self.module, numpy.contained(self.module)))
        data = {program.motion.name_of(self.module.name): program.motion.text(self.module)}
        if self.odd:
            data[program.name_of(self.module.name)] = program.text(self.solved, programs(self.solved))
        return data | {f"{self.module.name}.py": text}

    @property
    def compiled(self) -> dict[str, str]:
        """The sources of its shared library by file name, with headers of its own and those of the package to include.

        One source defines `slowflow_record`, the last `slowflow_laws`, the pieces of the force as Taylor recurrences.
        """
        from .codegen.targets import c, generic  # here, not above: NumPy answers without

        motion = {f"{self.module.name}_motion.c": c.motion(self.module)}
        if not self.odd:
            return motion
        module, code = self.solved, {self.solved.name: programs(self.solved)}
        files = c.headers([module], code) | generic.files([module], code)
        headers = {Path(file).name: text for file, text in files.items()}
        return headers | {f"{module.name}.c": c.records.of_one(module)} | motion

    @property
    def exported(self) -> dict[str, str]:
        """A source that gives each of its C functions a symbol; none where no header is in C."""
        from .codegen.targets import c  # here, not above: NumPy answers without

        header = f"{self.module.name}.h"
        return c.exported([header]) if self.odd else {}


def stated(
    name: str,
    pieces: Sequence[tuple[sp.Expr, sp.Expr | None]],
    parameters: Mapping[str, Mapping[str, Any]],
    title: str = "",
    reach: Any = sp.oo,
    reach_reason: str = "",
    *,
    odd: bool = True,
) -> Mechanism | Sided:
    """A mechanism from the force f(u) = u + F_k(u) for u > 0: each piece with the |u| at which it ends, the last None.

    parameters -- by name: `doc`, `unit`, and the bounds above, least, below, most, as of `Parameter`; design numbers
    odd        -- whether the force is; else pieces are polynomials for all u, by rising u, each with the u it ends at

    Raises TypeError for what is of another kind, as a force that is no SymPy expression, ValueError for names that are
    none or taken, for symbols that are no parameters, and for pieces without an end before the last; ArithmeticError as
    the derivation does.
    """
    name, pieces, parameters = given_by.module_name(name), given_by.pieces(pieces), given_by.parameters(parameters)
    title, reach_reason = given_by.text("title", title), given_by.text("reach_reason", reach_reason)
    furthest, odd = given_by.reach(reach), given_by.flag("odd", odd)
    design = designed(parameters)
    symbols = {parameter.symbol.name: parameter.symbol for parameter in design}
    forces, ends = [], []
    for number, (force, end) in enumerate(pieces, start=1):
        last = number == len(pieces)
        if (end is None) != last:
            raise Refused(f"piece {number} must {'have no end, it is the last' if last else 'say where it ends'}")
        forces.append(without_poles_that_cancel(_in_ours(f"piece {number}", force, symbols, {"u": u}, odd=odd)))
        if end is not None:
            ends.append(_in_ours(f"the end of piece {number}", end, symbols, {}))
    named = title or f"{name}, a custom restoring force"
    if not odd:
        sided = Sided(name, named, tuple(forces), tuple(ends), design, furthest, reach_reason)
        check_sided(sided)
        return sided
    _check_ends(name, ends)
    dimensional = {symbol: sp.Symbol(f"{symbol.name}_dimensional", positive=True) for symbol in symbols.values()}
    closed = all(force.is_polynomial(u) for force in forces)
    to_dimensional = {u: _x / _L, **dimensional}
    made = tuple(
        Piece(
            _k_v * _L * (force - u).subs(to_dimensional),
            until=_x - _L * end.subs(dimensional) if end is not None else None,
        )
        for force, end in zip(forces, [*ends, None], strict=True)
    )
    coefficients = _coefficients(forces, ends) if closed else ({},) * len(forces)
    mechanism = Mechanism(
        name=name,
        title=named,
        x=_x,
        k_v=_k_v,
        length=_L,
        pieces=made,
        design=design,
        ratios=dimensional,
        order=max(max(powers) for powers in coefficients) if closed else sp.oo,
        coefficients=coefficients,
        breakpoints=tuple(sp.Symbol(f"u_{number}", real=True) for number in range(1, len(pieces))),
        instead=() if closed else tuple(symbols.values()) or (UNIT.symbol,),
        reach=furthest,
        reach_reason=reach_reason,
        mirrored=_mirrored(pieces[0][0]),
    )
    if not closed:
        check(quadrature(mechanism), name, furthest)
    return mechanism


def _mirrored(force: Any) -> str:
    """A first piece as it is written, where for u < 0 it is real and not its mirror image; a constant is a preload."""
    force = given_by.expression("piece 1", force)
    right = sp.Dummy("right", positive=True)
    at = {symbol: right for symbol in force.free_symbols if symbol.name == "u"}
    left = force.subs({symbol: -right for symbol in at})
    roots = (power for power in left.atoms(sp.Pow) if power.has(right) and not power.exp.is_integer)
    if not at or left.has(sp.I) or any(not power.base.is_positive for power in roots):
        return ""
    even = sp.expand(force.subs(at) + left)
    return given_by.in_text(force) if reduced(even).has(right) else ""


def designed(parameters: Mapping[str, Mapping[str, Any]]) -> tuple[Parameter, ...]:
    """The numbers of a design, checked by module `given`. Raises ValueError for names that are taken."""
    found = []
    for key, about in parameters.items():
        if not key.isidentifier() or keyword.iskeyword(key) or key in TAKEN:
            raise Refused(f"parameter {key!r} is not allowed: it must be a name that is none of {sorted(TAKEN)}")
        if key in WORDS_OF_C:
            raise Refused(f"parameter {key!r} is not allowed: it is a word of C")
        found.append(_parameter(_symbol(key, about), about))
    return tuple(found)


def quadrature(mechanism: Mechanism) -> Quadrature:
    """The average of a force of any kind, as `stated` has it."""
    units = {mechanism.x: u, mechanism.length: 1, mechanism.k_v: 1}
    pieces = tuple(u + piece.force.subs(mechanism.dimensional).subs(units) for piece in mechanism.pieces)
    ends = (u - piece.until.subs(mechanism.dimensional).subs(units) for piece in mechanism.pieces[:-1])
    return Quadrature(pieces, dict(zip(mechanism.breakpoints, ends, strict=True)))


def by_quadrature(mechanism: Mechanism) -> Mechanism | None:
    """The mechanism with the design for parameters, where its average is a quadrature; None elsewhere.

    So is that of a piecewise polynomial which is smooth where two pieces meet: rounded coefficients of both would leave
    a kink there.
    """
    if mechanism.order == sp.oo:
        return mechanism
    forces = [piece.force for piece in mechanism.pieces]
    if not all(one.is_polynomial(mechanism.x) and sp.degree(one, mechanism.x) <= mechanism.order for one in forces):
        return None  # it is truncated
    if smooth_end(oscillator(mechanism)) is None:
        return None
    design = tuple(parameter.symbol for parameter in mechanism.design) or (UNIT.symbol,)
    return replace(mechanism, order=sp.oo, coefficients=({},) * len(mechanism.pieces), instead=design)


def sources(mechanism: Mechanism | Sided) -> Sources:
    """What is printed of it, under `name_of`. Raises ArithmeticError where the derivation refuses it, and why."""
    name = name_of(mechanism)
    if isinstance(mechanism, Sided):
        return Sources(sided_module(name, mechanism), odd=False)
    integrated = by_quadrature(mechanism)
    if integrated is not None:
        return Sources(quadrature_module(name, integrated, quadrature(integrated)))
    derived = of_mechanism(replace(mechanism, name=name), enclosed=True)
    # not composed with the slow flow and without resultants: solvers ask neither
    module = mechanism_module({name: derived}, name, None)
    module = replace(module, inputs=(AT_RUNTIME,), native=False)
    return Sources(with_bends(module, derived) if not_shown(derived.oscillator) else module, derived)


def description(mechanism: Mechanism | Sided) -> Page:
    """Its derivation."""
    # here, not above: who derives a mechanism need not print its document
    from .document import document, document_of_quadrature, document_of_sided

    equations = averaged()
    flow = slow_flow(equations)
    if isinstance(mechanism, Sided):
        return document_of_sided(mechanism, equations, flow)
    integrated = by_quadrature(mechanism)
    if integrated is not None:
        return document_of_quadrature(integrated, quadrature(integrated), equations, flow)
    return document(of_mechanism(mechanism, enclosed=True), equations, flow)


def written(mechanism: Mechanism | Sided, folder: Path) -> list[str]:
    """All that is printed and told of it as files in a folder, in which an earlier run's are replaced; their names."""
    printed = sources(mechanism)
    name = printed.module.name
    page = description(mechanism)
    documents = {f"{DOCUMENT}.md": page.markdown(), f"{DOCUMENT}.tex": page.tex()}
    files = {**printed.compiled, **printed.exported, **printed.python, **documents}
    content = {
        "command": "slowflow derive",
        "mechanism": {"name": name, "title": mechanism.title},
        "versions": versions(),
        "files": {file: hashlib.sha256(text.encode()).hexdigest() for file, text in sorted(files.items())},
    }
    files[MANIFEST] = as_json(content)
    write(files, folder)
    return sorted(files)


def name_of(mechanism: Mechanism | Sided) -> str:
    """Of its module: with a hash of all that it follows from, so that one of that name is this one."""
    return f"{mechanism.name}_{_digest(mechanism)}"


def _coefficients(forces: Sequence[sp.Expr], ends: Sequence[sp.Expr]) -> tuple[dict[int, sp.Symbol], ...]:
    """Names of the coefficients of piecewise polynomials."""
    coefficients = []
    for number, force in enumerate(forces, start=1):
        powers = {power for (power,), value in sp.Poly(force, u).terms() if value != 0} | {1}
        if number > 1 and 0 in powers and _is_continuous(forces, ends, number):
            powers.discard(0)
        coefficients.append({power: sp.Symbol(f"c{number}_{power}", real=True) for power in sorted(powers)})
    return tuple(coefficients)


def _check_ends(name: str, ends: Sequence[sp.Expr]) -> None:
    """That each piece ends beyond the one below it, where that is known without the numbers."""
    for number, (low, high) in enumerate(zip([sp.Integer(0), *ends], ends, strict=False), start=1):
        if (high - low).is_negative or high.is_real is False:
            where = f"{given_by.in_text(low)}, where piece {number - 1} does" if number > 1 else "0"
            raise NotSettled(
                f"{name}: piece {number} ends at |u| = {given_by.in_text(high)}, which is not above {where}"
            )


def check(average: Quadrature, name: str, reach: sp.Expr) -> None:
    """That a force can be summed: made of known functions, real up to the reach, and smooth where its pieces meet.

    Raises ArithmeticError with the reason.
    """
    known = (sp.Add, sp.Mul, sp.Pow, sp.Symbol, sp.Number, sp.NumberSymbol, *FUNCTIONS)
    ends = [sp.Integer(0), *average.breakpoints.values()]
    for number, piece in enumerate(average.pieces, start=1):
        for part in sp.preorder_traversal(piece):
            if not isinstance(part, known):
                raise NotSettled(
                    f"{name}: piece {number} contains {part.func.__name__}, whose average is not known; allowed are "
                    f"{', '.join(function.__name__ for function in FUNCTIONS)}, powers and |u|; a change of formula "
                    "at some |u| needs a piece of its own"
                )
        for end in ends[number : number + 1]:
            singular = singular_at(piece, end)
            if singular:
                raise NotSettled(
                    f"{name}: piece {number} has {given_by.in_text(singular[0])}, which is singular at "
                    f"|u| = {given_by.in_text(end)}, where it ends"
                )
        for end in ends[number - 1 : number + 1]:
            value = sp.simplify(piece.subs(u, end)) if end != 0 or number > 1 else average.at_rest
            if value.is_infinite or value is sp.nan or value.has(sp.zoo, sp.oo):
                raise NotSettled(f"{name}: piece {number} is infinite at |u| = {given_by.in_text(end)}")
        begin, end = (*ends, reach)[number - 1 : number + 1]
        inside = begin + 1 if end.is_infinite else (begin + end) / 2
        for at in (begin, inside, end):
            if at.is_finite is not False and piece.subs(u, at).is_extended_real is False:
                raise NotSettled(f"{name}: piece {number} is not real at |u| = {given_by.in_text(at)}")
    try:
        contacts = average.contacts
    except ArithmeticError as error:
        raise NotSettled(f"{name}: where a piece begins it has {error}") from None
    for contact in contacts:
        # beyond its piece it is taken off the next one, which nothing but a polynomial is known to allow
        if contact.begins < len(average.pieces) - 1 and not contact.factor.is_polynomial(v):
            raise NotSettled(
                f"{name}: piece {contact.begins + 1} has a power {contact.power} of what u exceeds its begin by, times "
                "what is no polynomial: only the last piece may"
            )


def _symbol(name: str, about: Mapping[str, Any]) -> sp.Symbol:
    """With the sign that its bounds leave it: where a piece ends has to be positive."""
    above, least = about.get("above"), about.get("least")
    if above is not None and above >= 0:
        return sp.Symbol(name, positive=True)
    return sp.Symbol(name, nonnegative=True) if least is not None and least >= 0 else sp.Symbol(name, real=True)


def _parameter(symbol: sp.Symbol, about: Mapping[str, Any]) -> Parameter:
    bounds = {key: about[key] for key in given_by.BOUNDS if key in about}
    return Parameter(symbol, about.get("doc", "") or f"parameter {symbol}", about.get("unit", "1"), **bounds)


def _in_ours(
    what: str, expression: Any, symbols: Mapping[str, sp.Symbol], others: Mapping[str, sp.Symbol], *, odd: bool = True
) -> sp.Expr:
    """A user's expression with our symbols in the place of those of the same names."""
    expression = given_by.expression(what, expression)
    known = {**symbols, **others}
    unknown = sorted({symbol.name for symbol in expression.free_symbols} - set(known))
    if "t" in unknown:
        raise Refused(
            f"{what} has t: a restoring force may not depend on time, it is a function of u and parameters; what "
            "drives the mass in time is the excitation, F_0 at the frequency Omega"
        )
    if unknown:
        raise Refused(f"{what} has {', '.join(unknown)}, which {'is' if len(unknown) == 1 else 'are'} no parameter")
    ours = expression.subs({symbol: known[symbol.name] for symbol in expression.free_symbols})
    # a force is stated for u > 0: |u| is u there
    return ours.subs(u, _above).subs(_above, u) if odd and ours.has(sp.Abs, sp.sign) else ours


def _is_continuous(forces: Sequence[sp.Expr], ends: Sequence[sp.Expr], number: int) -> bool:
    below, above = forces[number - 2 : number]
    return vanishes((below - above).subs(u, ends[number - 2]))


def _digest(mechanism: Mechanism | Sided) -> str:
    """Of the mechanism, the tools, and every file of the derivation."""
    contents: Iterable[str] = (repr(mechanism), repr(versions()), _files())
    return hashlib.sha256("\n".join(contents).encode()).hexdigest()[:12]


@cache
def _files() -> str:
    content = (path.read_bytes() for path in sorted(HERE.rglob("*")) if path.suffix in (".py", ".jinja"))
    return hashlib.sha256(b"".join(content)).hexdigest()
