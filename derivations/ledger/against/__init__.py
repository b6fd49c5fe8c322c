"""What the derivation has in the place of what `literature` states, one file a publication, of the same name.

In:  a `Publication`; what is derived.
Out: `judged`, one `Judgement` for each formula and sentence. What a publication gives as an approximation is not
     called wrong: what it stands for is certified, and the error is told.

A file has `formulas(derived)`, for each function's name what judges it, and `claims(derived)`, for each sentence's id
its verdict and evidence; where nothing is stated, neither.
"""

from __future__ import annotations

import functools
import importlib
import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from ...forces.of_mechanism import OfMechanism, of_mechanism
from ...kernels import Formulas
from ...library import stated
from ...mechanisms import duffing
from ...paper.averaging import Averaged, averaged
from ...paper.slow_flow import I, R, slow_flow
from ...symbols import h
from ..formulas import same
from ..judging import Judgement, judge
from ..literature import Publication
from ..rows import DIFFERS, FALSE, IDENTICAL, LOOSE, REWRITTEN, TRUE
from ..source import EXACT

APPROXIMATE = "approximate"

#: what each verdict says, in the order of the summary
VOCABULARY = {
    IDENTICAL: "formulas are proved to be the same expression up to the order of terms",
    REWRITTEN: "formulas are proved equal with the relations named in the row",
    APPROXIMATE: "the published formula is an approximation; the row has its error, from certified values",
    DIFFERS: "the exact difference is not zero; the row has it",
    TRUE: "the sentence holds, by the proof or the certified value given",
    LOOSE: "the sentence holds only with a condition that it does not state",
    FALSE: "the sentence does not hold, by the proof given",
}


Judge = Callable[[Callable[..., Any]], Judgement]
Claims = dict[str, tuple[str, str]]


class Derived:
    """What is derived, when it is asked for."""

    @functools.cached_property
    def averaged(self) -> Averaged:
        """(8)-(20)."""
        return averaged()

    @functools.cached_property
    def flow(self) -> Formulas:
        """(23)-(30), without friction."""
        return slow_flow(self.averaged, "mu0")

    @functools.cached_property
    def friction(self) -> sp.Expr:
        """m (23), friction's share of I."""
        return slow_flow(self.averaged).friction

    @functools.cached_property
    def _duffing(self) -> OfMechanism:
        return of_mechanism(duffing.MECHANISM)

    def cubic(self, linear: Any, cubic: Any) -> sp.Expr:
        """h of the oscillator with a cubic term, with these coefficients."""
        names = self._duffing.oscillator.definitions
        return self._duffing.whole.regimes[0].derivatives[0].subs(dict(zip(names, (linear, cubic, 0), strict=True)))

    def response(self, average: sp.Expr) -> sp.Expr:
        """F (24) without friction, with this h."""
        return self.flow.F.subs({R: self.flow.R, I: self.flow.I}).subs(h, average)

    @functools.cache  # noqa: B019 - as long as this object
    def library(self, name: str) -> OfMechanism:
        """A mechanism of the library."""
        return of_mechanism(stated(name))


def value(function: Callable[..., Any], arguments: Mapping[str, Any]) -> sp.Expr:
    """A published function at these arguments, exactly."""
    return sp.sympify(function(**arguments, xp=EXACT))


def plain(function: Callable[..., Any]) -> str:
    """It in its own symbols."""
    names = [name for name in inspect.signature(function).parameters if name != "xp"]
    return sp.sstr(value(function, {name: sp.Symbol(name, positive=True) for name in names}))


def equal(derived: sp.Expr, arguments: Mapping[str, Any], *, rewriting: str = "", **keywords: Any) -> Judge:
    """The published value with these arguments is the derived one, or the exact difference; keywords of a `Subject`."""
    subject = same(derived, rewriting, values=dict(arguments), **keywords)
    return lambda function: judge(function, subject)


def solves(residual: Callable[[sp.Expr], sp.Expr], arguments: Mapping[str, Any], derived: str) -> Judge:
    """The published value, put into a derived equation, solves it, or what is left."""

    def check(function: Callable[..., Any]) -> Judgement:
        vanishes = same(sp.Integer(0), f"substitution into {derived}")
        left = judge(lambda *, xp: residual(value(function, arguments)), vanishes)
        return replace(left, published=plain(function), derived=derived)

    return check


def approximates(error: Callable[[Callable[..., Any]], str], derived: str) -> Judge:
    """The published value is an approximation, and the error of it is this."""
    return lambda function: Judgement(APPROXIMATE, plain(function), derived, evidence=error(function))


@dataclass(frozen=True)
class Verdicts:
    """All on one publication: by the name of a formula's function, and by a sentence's id."""

    publication: Publication
    formulas: dict[str, Judgement]
    claims: Claims


def judged(publication: Publication, derived: Derived) -> Verdicts:
    """Every formula and sentence, in the publication's order. Call it at the ledger's precision."""
    against = importlib.import_module(f"{__name__}.{publication.name}")
    judges: dict[str, Judge] = against.formulas(derived) if publication.formulas else {}
    claims: Claims = against.claims(derived) if publication.claims else {}
    names, ids = [f.name for f in publication.formulas], [claim.id for claim in publication.claims]
    if set(judges) != set(names) or set(claims) != set(ids):
        raise ArithmeticError(
            f"{publication.name}: what is published and what is judged part at "
            f"{sorted(set(judges) ^ set(names)) + sorted(set(claims) ^ set(ids))}"
        )
    formulas = {f.name: judges[f.name](f.function) for f in publication.formulas}
    return Verdicts(publication, formulas, {name: claims[name] for name in ids})
