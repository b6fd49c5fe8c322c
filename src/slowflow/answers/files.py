"""Answers as files. Takes answers with their queries; returns CSV and JSON, complete or not at all.

A file is written under a temporary name beside its own and renamed when it is whole. A folder of answers has a record,
answers.json, which lists the other files with the hash of each: by it what an earlier scene left is told from what
somebody else put there.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import math
import os
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from slowflow.answers.answer import Answer, head
from slowflow.support.errors import Refused

#: the record of a folder
RECORD = "answers.json"


def write(path: Path, text: str) -> None:
    """The text as a file, whole or not at all."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        os.umask(mask := os.umask(0))
        os.chmod(name, 0o666 & ~mask)  # `mkstemp` allows nobody else to read
        os.replace(name, path)
    except BaseException:
        os.unlink(name)
        raise


def check_target(path: Path, source: Path) -> None:
    """Raise Refused for a file that cannot be written, or is the input file, before anything is computed."""
    if path.resolve() == source.resolve():
        raise Refused(f"{path} is the input file and would be overwritten: write to another file")
    if path.is_dir():
        raise Refused(f"{path} is a folder: the name of a file is needed")
    if not path.parent.is_dir():
        raise Refused(f"{path}: there is no folder {path.parent}")


def written(folder: Path, names: Sequence[str]) -> list[Path]:
    """Which of these files slowflow wrote into a folder. Raises Refused for one that is not as its record has it."""
    if folder.exists() and not folder.is_dir():
        raise Refused(f"{folder} is a file: the name of a folder is needed")
    try:
        recorded = json.loads((folder / RECORD).read_text(encoding="utf-8"))["files"]
    except (OSError, ValueError, LookupError, TypeError):
        recorded = {}
    found = [folder / name for name in names if (folder / name).exists()]
    for path in found:
        if not isinstance(recorded, dict) or recorded.get(path.name) != digest(path.read_bytes()):
            raise Refused(
                f"{path} differs from what slowflow wrote, by the record in {folder / RECORD}, and would be mixed "
                "with the new results: move it, or write to another folder"
            )
    return found


def digest(content: bytes) -> str:
    """The hash of a file."""
    return hashlib.sha256(content).hexdigest()


def in_csv(answers: Sequence[tuple[Mapping[str, float], Answer]], units: Mapping[str, str]) -> str:
    """The columns of answers to one question, one below the other, each after its arguments; units in the head.

    units -- of the arguments

    Numbers have all their digits, and one that there is not is empty.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    before = dict.fromkeys((name for at, _ in answers for name in at), math.nan)
    for arguments, answer in answers:
        own = answer.columns()
        length = len(next(iter(own.values())))
        columns = {name: own.get(name, np.full(length, value)) for name, value in {**before, **arguments}.items()} | own
        of = {**units, **answer.units_of_columns()}
        if not text.tell():
            writer.writerow([head(name, of) for name in columns])
        rows = zip(*(column.tolist() for column in columns.values()), strict=True)
        writer.writerows([_text(value) for value in row] for row in rows)
    return text.getvalue()


def _text(value: Any) -> Any:
    if isinstance(value, float):
        return "" if math.isnan(value) else repr(value)
    return str(value).lower() if isinstance(value, bool) else value


def in_json(content: Any) -> str:
    """Plain Python as JSON, which knows no NaN and no infinity: these are null, and the words "inf" and "-inf"."""
    return json.dumps(_known(content), indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _known(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {str(name): _known(part) for name, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [_known(part) for part in value]
    if isinstance(value, complex):
        return [_known(value.real), _known(value.imag)]
    if isinstance(value, float) and not math.isfinite(value):
        return None if math.isnan(value) else str(value)
    return value
