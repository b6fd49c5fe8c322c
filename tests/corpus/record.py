"""What a family's answers are reduced to, and how two records differ.

Of each question: the number of answers, of refusals, of rows (folds, states, points); a hash of the bits of every
column, of every text; and, up to `KEPT`, the numbers themselves, by which a difference is measured.
"""

from __future__ import annotations

import hashlib
import warnings
from collections import defaultdict
from collections.abc import Iterable
from typing import Any

import numpy as np

from slowflow import SlowflowError
from slowflow.answers.answer import Answer
from slowflow.averaged.batches import Batch

#: numbers of a column that are kept by value
KEPT = 100_000


class Column:
    """A hash of all bits, and the first numbers."""

    def __init__(self) -> None:
        self.hash, self.kept, self.count = hashlib.sha256(), [], 0

    def add(self, value: Any) -> int:
        array = np.ascontiguousarray(value)
        if array.dtype.kind not in "fciub":
            self.hash.update(repr(value).encode())
            return 0
        self.hash.update(repr((array.dtype.str, array.shape)).encode())
        # a NaN is a NaN, whatever its payload
        self.hash.update(
            np.where(np.isnan(array), np.nan, array).tobytes() if array.dtype.kind in "fc" else array.tobytes()
        )
        if self.count < KEPT:
            flat = array.ravel()[: KEPT - self.count]
            self.kept.append(flat.view(float) if flat.dtype.kind == "c" else flat.astype(float))
            self.count += len(flat)
        return array.size


def fields(answer: Any, name: str = "") -> Iterable[tuple[str, Any]]:
    """Every number, array and word in an answer, by dotted name."""
    if isinstance(answer, Answer):
        for part, value in answer._content().items():
            yield from fields(value, f"{name}.{part}" if name else part)
        if isinstance(answer, Batch):
            yield "remarks", answer.remarks
    elif isinstance(answer, dict):
        for part, value in answer.items():
            yield from fields(value, f"{name}.{part}")
    elif isinstance(answer, tuple | list) and any(isinstance(one, Answer) for one in answer):
        for one in answer:
            yield from fields(one, name)
    else:
        yield name or "value", answer


def reduced(pairs: Iterable[tuple[str, Any]]) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """The record of a family, and the numbers that are kept, by "question/column"."""
    columns: dict[str, Column] = defaultdict(Column)
    counts: dict[str, dict[str, int]] = defaultdict(lambda: {"answers": 0, "refusals": 0, "numbers": 0})
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for question, answer in pairs:
            count = counts[question]
            if isinstance(answer, SlowflowError):
                count["refusals"] += 1
                columns[f"{question}/refusal"].add(f"{type(answer).__name__}: {answer}")
                continue
            count["answers"] += 1
            for name, value in fields(answer):
                count["numbers"] += columns[f"{question}/{name}"].add(value)
            if not isinstance(answer, Batch):
                columns[f"{question}/text"].add(str(answer))
    record: dict[str, Any] = {question: dict(count, bits={}) for question, count in sorted(counts.items())}
    for path, column in sorted(columns.items()):
        question, _, name = path.partition("/")
        record[question]["bits"][name] = column.hash.hexdigest()[:16]
    return record, {path: np.concatenate(one.kept) for path, one in columns.items() if one.kept}


def differences(
    old: dict[str, Any], new: dict[str, Any], before: dict[str, np.ndarray], after: dict[str, np.ndarray]
) -> list[str]:
    """A line for each question and column that is not the same; with the numbers of both, how far they are apart."""
    lines = [
        f"{question}: only {'before' if question in old else 'after'}" for question in sorted(old.keys() ^ new.keys())
    ]
    for question in sorted(old.keys() & new.keys()):
        one, two = old[question], new[question]
        lines += [
            f"{question}: {one[name]} {name} before, {two[name]} after"
            for name in ("answers", "refusals", "numbers")
            if one[name] != two[name]
        ]
        for name in sorted(one["bits"].keys() | two["bits"].keys()):
            if one["bits"].get(name) != two["bits"].get(name):
                path = f"{question}/{name}"
                lines.append(f"{path}: other bits{distance(before.get(path), after.get(path))}")
    return lines


def distance(one: np.ndarray | None, two: np.ndarray | None) -> str:
    """How many of the numbers that were kept differ, and the largest relative difference."""
    if one is None or two is None:
        return ""
    if one.shape != two.shape:
        return f", {one.size} numbers before, {two.size} after"
    apart = (one != two) & ~(np.isnan(one) & np.isnan(two))
    if not apart.any():
        return ", none of the numbers that were kept"
    with np.errstate(all="ignore"):
        largest = np.nanmax(np.abs(one - two)[apart] / np.maximum(np.abs(one), np.abs(two))[apart])
    return f", {apart.sum()} of {apart.size} numbers, at most {largest:.1e} of their size"
