"""In: a published function and its `Subject`. Out: `Judgement`: whether they agree, by proof, or how they differ.

No row of the ledger is needed to judge another: the mutation test calls `judge` with functions that it has changed.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from . import formulas
from .formulas import Reading, Subject
from .proofs import Quotient, canonical, nonzero_somewhere
from .rows import DIFFERS, IDENTICAL, REWRITTEN
from .source import EXACT


@dataclass(frozen=True)
class Judgement:
    """identical, equal after a stated rewriting, or differs."""

    verdict: str
    published: str  #: the published expression in its own symbols
    derived: str  #: the derived one
    difference: str = ""  #: published less derived, in lowest terms, where it is not zero
    factor: str = ""  #: published divided by derived, if that is a number
    printed: tuple[sp.Expr, ...] = ()  #: the published expressions
    found: tuple[tuple[str, sp.Expr], ...] = ()  #: the derived ones, by name where they have one
    evidence: str = ""  #: what was used to make them equal, and what else readers have to know


def _flat(value: Any) -> Iterator[sp.Expr]:
    if isinstance(value, tuple | list):
        for entry in value:
            yield from _flat(entry)
    else:
        yield sp.sympify(value)


def _values(function: Callable[..., Any], values: dict[str, sp.Expr], known: dict[str, sp.Symbol]) -> list[sp.Expr]:
    names = [name for name in inspect.signature(function).parameters if name != "xp"]
    arguments = {
        name: values[name] if name in values else known.get(name, sp.Symbol(name, real=True)) for name in names
    }
    return list(_flat(function(**arguments, xp=EXACT)))


def _text(values: list[sp.Expr]) -> str:
    return "; ".join(sp.sstr(value) for value in values)


def _compare(published: sp.Expr, derived: sp.Expr, subject: Subject) -> tuple[Quotient, str]:
    """What must vanish, and the rewriting that putting it so means."""
    if subject.how == formulas.DIFFERENCE:
        return canonical(published - derived), ""
    if subject.how == formulas.COSINES:
        return canonical(sp.cos(published) - sp.cos(derived)), "comparison of cosines, as both angles are in [0, π]"
    if published.subs(subject.sample).is_negative is not False:
        return canonical(published - derived), ""
    return canonical(published**2 - derived**2), "comparison of squares, as both sides are positive"


def _factor(published: list[sp.Expr], derived: list[sp.Expr]) -> str:
    """The number by which every published entry is the derived one times it, or nothing."""
    ratios = set()
    for one, other in zip(published, derived, strict=True):
        if other == 0:
            return ""
        ratio = canonical(one / other)
        value = ratio.numerator / ratio.denominator
        if value.free_symbols or value.has(sp.sin, sp.cos):
            return ""
        ratios.add(value)
    return sp.sstr(ratios.pop()) if len(ratios) == 1 else ""


def _judge_form(
    function: Callable[..., Any], subject: Subject, form: Reading, known: dict[str, sp.Symbol]
) -> Judgement:
    published = _values(function, subject.values | form.values, known)
    derived = list(_flat(form.derived))
    printed = _values(function, {}, known)
    found = tuple(subject.shown.items()) or tuple(("", value) for value in derived)
    shown = ", ".join(f"{name} = {value}" if name else sp.sstr(value) for name, value in subject.shown.items())
    judged = Judgement(DIFFERS, _text(printed), shown or _text(derived), printed=tuple(printed), found=found)
    if len(published) != len(derived):
        return replace(judged, difference=f"{len(published)} entries for {len(derived)}")
    used = {form.rewriting} if form.rewriting else set()
    differences = []
    for one, other in zip(published, derived, strict=True):
        quotient, rewriting = _compare(one, other, subject)
        if not quotient.is_zero and not nonzero_somewhere(quotient):
            raise ArithmeticError(f"{function.__name__}: {quotient.text()} is neither zero nor shown not to be")
        differences.append(quotient)
        used |= set(quotient.relations) | ({rewriting} if rewriting else set())
    if all(quotient.is_zero for quotient in differences):
        by = f"Rewriting: {'; '.join(sorted(used))}." if used else ""
        return replace(judged, verdict=REWRITTEN if used else IDENTICAL, evidence=by)
    factor = _factor(published, derived) if subject.how == formulas.DIFFERENCE else ""
    prefix = {formulas.SQUARES: "of the squares: ", formulas.COSINES: "of the cosines: "}.get(subject.how, "")
    return replace(judged, difference=prefix + "; ".join(q.text() for q in differences), factor=factor)


def _judge_fields(function: Callable[..., Any], subject: Subject) -> Judgement:
    def text(record: dict[str, Any]) -> str:
        return (
            f"Res_{record['eliminated']}({record['first']}, {record['second']}) at {record['evaluated_at']}: degree "
            f"{record['degree']} in {record['unknown']}, powers in steps of {record['step']}, coefficients "
            f"{record['coefficients']}"
        )

    published, derived = vars(function(xp=EXACT)), subject.forms[0].derived
    wrong = [f"{key}: {published[key]} for {derived[key]}" for key in derived if published[key] != derived[key]]
    return Judgement(DIFFERS if wrong else IDENTICAL, text(published), text(derived), difference="; ".join(wrong))


def judge(function: Callable[..., Any], subject: Subject) -> Judgement:
    """The verdict on one published function."""
    if subject.how == formulas.FIELDS:
        judgements = [_judge_fields(function, subject)]
    else:
        known = formulas.shared_symbols()
        judgements = [_judge_form(function, subject, form, known) for form in subject.forms]
    found = next((one for one in judgements if one.verdict != DIFFERS), judgements[0])
    return replace(found, evidence=f"{found.evidence} {subject.remark}".strip())
