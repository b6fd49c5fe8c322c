"""Base classes of results.

Results are immutable, compare by value, and can be copied and pickled. They convert to plain Python, or to tables of
pandas and xarray, which are optional: `pip install 'slowflow[tables]'`.
"""

from __future__ import annotations

import dataclasses
import importlib.util
import operator
import re
from collections import namedtuple
from collections.abc import Callable, Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, Self, overload

import numpy as np
import numpy.typing as npt

from slowflow.core import validate
from slowflow.support.text import Text, together

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.axes import Axes

__all__ = ["Answer", "Drawn", "Single", "Table"]

#: types of a table's entries
PLAIN = (bool, int, float, str)
#: by name of a number, texts for some of its values
Labels = Mapping[str, Mapping[float, str]]
#: most rows, and columns, that are printed
SHOWN, ACROSS = 30, 16
#: width of names of numbers
NAMED = 14


#: fields made on first read, all of them by `_later`
WHEN_READ = ("message", "remarks", "untruncated")


class Answer:
    """Base class of results: read-only arrays, comparison by value, conversion to plain numbers and lists.

    labels   -- texts printed instead of some numbers, by name
    has_rows -- whether `columns` has a row for each of several entries, or one row for a single answer
    """

    labels: ClassVar[Labels] = MappingProxyType({})
    has_rows: ClassVar[bool] = False

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name in WHEN_READ and "_later" in self.__dict__:
                self.__dict__.update(self._later(self))
                if name in self.__dict__:
                    return self.__dict__[name]
            return self.__getattribute__(name)  # a property that is missing has its own message

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._content()]

    @classmethod
    def _made(cls, *, message: str | Callable[[], str] = "", **found: Any) -> Self:
        """An answer from its fields by name, in a fifth of the time; a function makes the message when it is read.

        A field whose default is a value need not be among them, nor one that `_later` makes of the answer.
        """
        one = cls.__new__(cls)
        for value in found.values():
            if type(value) is np.ndarray:
                value.setflags(write=False)
        if not isinstance(message, str):
            found["_later"] = lambda _: {"message": message()}
        elif "_later" not in found:
            found["message"] = message
        one.__dict__.update(found)
        return one

    def __post_init__(self) -> None:
        for value in self.__dict__.values():
            _freeze(value)

    def __getstate__(self) -> dict[str, Any]:
        # messages are made now: a copy has nothing to make them from
        if "_later" in self.__dict__:
            getattr(self, "message")  # noqa: B009
        return {name: value for name, value in self.__dict__.items() if name != "_later"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        # copied arrays can be written to
        self.__dict__.update(state)
        Answer.__post_init__(self)

    def _content(self) -> dict[str, Any]:
        """The results and the arguments of the query, by name, without the slow flow behind them."""
        shown = [one for one in dataclasses.fields(self) if one.repr]  # type: ignore[arg-type]
        if any(one.metadata for one in shown):
            loaded = getattr(self, "load", None) is not None
            shown = [one for one in shown if one.metadata.get("loaded", loaded) == loaded]
        return {one.name: getattr(self, one.name) for one in shown}

    def _numbers(self) -> set[str]:
        """Names of numbers that may be missing."""
        return {field.name for field in dataclasses.fields(self) if field.type == "float | None"}  # type: ignore[arg-type]

    def units_of_columns(self) -> Mapping[str, str]:
        """Units of the columns, for those that have one; empty by default."""
        return {}

    def text_of(self, name: str, value: object) -> str:
        """Text printed instead of a number; usually empty."""
        return self.labels.get(name, {}).get(value, "") if isinstance(value, float) else ""

    def units_of_about(self) -> Mapping[str, str]:
        """Units of the values of `about`; empty by default."""
        return {}

    def _members(self) -> Mapping[str, Any]:
        """Its members by name, answers and arrays of any length among them."""
        return self._content()

    def __str__(self) -> str:
        return "\n".join(in_text(shown(self)))

    def _repr_html_(self) -> str:
        """Return the answer as notebooks show it: a table or text, diagnostics, and its plot if Matplotlib is there."""
        from html import escape

        one = shown(self)
        if not one.has_rows or "__str__" in vars(type(one)):  # some have lines of their own
            return f"<pre>{escape(str(self))}</pre>{self._figure()}"
        columns, cells = one.columns(), "".join
        names, *rows = _rows(columns, one.units_of_columns())
        table = [cells(f"<th>{escape(name)}</th>" for name in names)]
        table += [cells(f"<td>{escape(cell)}</td>" for cell in row) for row in rows]
        below = "<br>".join(escape(text) for text in (_more(columns), str(one.about().get("message", ""))) if text)
        return f"<table>{cells(f'<tr>{row}</tr>' for row in table)}</table><p>{below}</p>{self._figure()}"

    def _figure(self) -> str:
        """Its plot as SVG in HTML; empty for an answer without one."""
        return ""

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Answer) or type(self) is not type(other):
            return NotImplemented
        return all(same(one, two) for one, two in zip(self._content().values(), other._content().values(), strict=True))

    def __hash__(self) -> int:
        content = (value.tobytes() if isinstance(value, np.ndarray) else value for value in self._content().values())
        return hash((type(self), *content))

    def to_dict(self) -> dict[str, Any]:
        """Convert to plain Python: lists for arrays, numbers and texts, by name; complex numbers are pairs."""
        return {name: plain(value) for name, value in self._content().items()}

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """Return arrays of one length by name, a row for each entry; a single answer has its numbers and texts.

        Nested answers and arrays of other lengths are in `to_dict` only.
        """
        numbers = self._numbers()
        found = {
            name: np.nan if value is None and name in numbers else value for name, value in self._content().items()
        }
        return {name: np.array([plain(value)]) for name, value in found.items() if isinstance(value, PLAIN)}

    def about(self) -> dict[str, Any]:
        """Return values common to all rows of `columns`: message, forcing, parameters of the oscillator."""
        return {}

    def to_pandas(self) -> pandas.DataFrame:
        """Convert `columns` to a DataFrame, with `about` in `.attrs`. Raises ImportError without pandas."""
        pandas = optional("pandas", "to_pandas")
        frame = pandas.DataFrame(self.columns())
        frame.attrs.update({**self.about(), "units": {**self.units_of_about(), **self.units_of_columns()}})
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """Convert `columns` to a Dataset along "entry", each with its units. Raises ImportError without xarray.

        If "entry" is itself a column, as in a gradient, the dimension is "row". `about` is in the attributes, with
        units, such as "F" and "F_units".
        """
        xarray = optional("xarray", "to_xarray")
        units = self.units_of_columns()
        columns = self.columns()
        row = "row" if "entry" in columns else "entry"
        found = {name: (row, column, {"units": units.get(name, "1")}) for name, column in columns.items()}
        entry = {row: np.arange(max(map(len, columns.values()), default=0))}
        attributes = {name: value for name, value in self.about().items() if value is not None}
        attributes |= {f"{name}_units": unit for name, unit in self.units_of_about().items()}
        return xarray.Dataset(found, coords=entry, attrs=attributes)


class Single(Answer):
    """An answer that consists of plain numbers and texts."""

    def __post_init__(self) -> None:
        pass


class Drawn(Answer):
    """Base class of results that can be plotted.

    picture -- name of the plot in `pictures.PICTURES`
    """

    picture: ClassVar[str]

    @property
    def can_draw(self) -> tuple[str, ...]:
        """Quantities that `plot` may draw, for `of`."""
        return ("A",)

    def plot(self, ax: Axes | None = None, *, of: str = "A") -> Axes:
        """Plot into Matplotlib axes, new ones by default, and return them.

        of -- quantity of a response curve: "A", "phi", "transmissibility" or "transmissibility_dB"; "B" under a load,
              "A_1" in the second approximation

        Curves over Omega are solid where stable and dashed where unstable, with bars where an exact motion stops; folds
        are triangles that point in the direction of the jump, jumps of a sweep are arrows. The forcing axis of a fold
        locus, which is unbounded, ends at four times the smallest forcing. A shock is plotted over tau, shaded beyond
        u_cr; a shock spectrum as the ratio over the duration. Raises ValueError for another `of`, ImportError without
        Matplotlib.
        """
        from slowflow.answers import pictures

        quantity = validate.choice("of", of, self.can_draw)
        draw = pictures.PICTURES[self.picture]
        return draw(ax, self) if self.picture != "response" else pictures.response(ax, self, quantity)

    def _figure(self) -> str:
        return drawn(self, self.picture)


#: metadata of a field that only answers under a load have, or only the others
LOADED, UNLOADED = MappingProxyType({"loaded": True}), MappingProxyType({"loaded": False})


def entry_of(table: type, attribute: str, name: str, columns: Iterable[str]) -> Any:
    """Make the named tuple of a table's entries, an attribute of its class: so entries can be pickled."""
    made: Any = namedtuple(name, columns, module=table.__module__)  # type: ignore[misc]
    made.__qualname__, made.__doc__ = f"{table.__qualname__}.{attribute}", f"An entry of `{table.__name__}`."
    return made


#: annotations of a table's columns
COLUMN = re.compile(r"Floats|Flags|Ints|(npt\.)?NDArray\[.*\]")


class Entry:
    """An entry of a table, for type checkers: which of these numbers it has its table says, in SI units or without."""

    Omega: float
    Omega_low: float
    Omega_high: float
    Omega_e: float
    A: float
    A_1: float
    B: float
    F_0: float
    u: float
    u_rms: float
    f: float
    f_low: float
    f_high: float
    f_e: float
    F: float
    Y: float
    a: float
    U: float
    x: float
    x_max: float
    x_rms: float
    v_rms: float
    a_rms: float
    a_max: float
    phi: float
    transmissibility_dB: float
    stiffness: float
    damping: float
    ratio_e: float
    beyond: float
    crossing_rate: float
    dry: float
    acceleration: float
    duration: float
    ratio: float
    error: float
    error_of_A: float
    value: float
    low: float
    high: float
    nominal: float
    median: float
    share: float
    first: float
    first_error: float
    total: float
    total_error: float
    limit: float
    margin: float
    one: float
    other: float
    stable: bool
    corner: bool
    minimum: bool
    settled: bool
    found: bool
    crosses: bool
    detaches: bool
    sticks: bool
    met: bool
    kind: str
    reason: str
    parameter: str
    unit: str
    answer: str
    requirement: str
    case: str
    branch: int
    stops: int
    turns: int
    motions: int


class TupleEntry(Entry, tuple[Any, ...]):
    """An entry of a dimensionless table, for type checkers: it can be unpacked too."""

    if TYPE_CHECKING:
        _fields: ClassVar[tuple[str, ...]]

        def __new__(cls, *numbers: object) -> Self: ...


class Table(Answer):
    """An answer with several entries: arrays of one length.

    entry -- type of an entry, a named tuple with a field for each array of the answer
    extra_columns -- further columns of each entry, not in its named tuple
    """

    entry: ClassVar[type[TupleEntry]]
    extra_columns: ClassVar[tuple[str, ...]] = ()
    has_rows = True

    def __init_subclass__(cls, entry: str = "", columns: str = "", **more: Any) -> None:
        super().__init_subclass__(**more)
        if entry:
            declared = (name for name, kind in cls.__annotations__.items() if COLUMN.fullmatch(kind))
            cls.entry = entry_of(cls, "entry", entry, columns.split() or declared)

    def _entry_of(self) -> type[TupleEntry]:
        """The named tuple of an entry."""
        return self.entry

    def _beside_of(self) -> tuple[str, ...]:
        """Further columns of each entry."""
        return self.extra_columns

    def __len__(self) -> int:
        return int(getattr(self, self._entry_of()._fields[0]).size)

    @overload
    def __getitem__(self, k: int) -> TupleEntry: ...
    @overload
    def __getitem__(self, k: slice) -> list[TupleEntry]: ...
    def __getitem__(self, k: int | slice) -> Any:
        if isinstance(k, slice):
            return list(self)[k]
        entry = self._entry_of()
        return entry(*(getattr(self, name)[operator.index(k)].item() for name in entry._fields))

    def __iter__(self) -> Iterator[TupleEntry]:
        entry = self._entry_of()
        columns = (getattr(self, name).tolist() for name in entry._fields)
        return (entry(*values) for values in zip(*columns, strict=True))

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """Return arrays of one length by name: those of the entries, then the further ones."""
        found = {name: getattr(self, name) for name in (*self._entry_of()._fields, *self._beside_of())}
        content, shape = self._content().items(), (len(self),)
        return found | {name: one for name, one in content if isinstance(one, np.ndarray) and one.shape == shape}

    def about(self) -> dict[str, Any]:
        """Return message, forcing and, if known, the parameters of the oscillator."""
        known = {name: plain(value) for name, value in self._content().items() if isinstance(value, PLAIN)}
        model = getattr(self, "_model", None)
        return known if model is None else known | model.arguments()


def _freeze(value: Any) -> None:
    """Make arrays read-only, in tuples too."""
    if isinstance(value, np.ndarray):
        value.setflags(write=False)
    elif not isinstance(value, PLAIN) and isinstance(value, (tuple, Mapping)):  # PLAIN is the faster test
        for part in value.values() if isinstance(value, Mapping) else value:
            _freeze(part)


def shown(answer: Any) -> Any:
    """Return an answer in the units in which it is printed; as it is where it has none, or where these were chosen."""
    return answer if getattr(answer, "chosen", not hasattr(answer, "in_units")) else answer.in_units()


def drawn(answer: Any, picture: str) -> str:
    """Return the plot of an answer as SVG in HTML; empty without Matplotlib, and for folds, whose table suffices."""
    if picture == "folds" or not importlib.util.find_spec("matplotlib"):
        return ""
    from slowflow.answers import page

    return page.figure(answer.plot(page.axes()), "")


def in_text(answer: Answer) -> Iterator[str]:
    """Yield an answer as lines: a table with units in its head, or names, values and units; then the answers in it."""
    if answer.has_rows:
        yield from _table(answer.columns(), answer.units_of_columns())
        if message := answer.about().get("message"):
            yield str(message)
    else:
        yield from in_values(answer, {name: value for name, (value,) in answer.columns().items()})
    for name, value in answer._members().items():
        if isinstance(value, Answer):
            yield from (f"{name}:", *(f"  {line}" for line in in_text(value)))


def in_values(answer: Answer, values: Mapping[str, Any]) -> Iterator[str]:
    """Yield known numbers and texts of an answer, then its intervals, then arrays of one length as a table.

    Diagnostics are codes: the message explains them. Arrays of more than `SHOWN` numbers are left out.
    """
    units = answer.units_of_columns()
    width = max(NAMED, *(len(name) + 2 for name in values))
    for name, value in values.items():
        if name != "remarks" and str(value) not in ("", "nan"):
            label = answer.text_of(name, value)
            yield f"{name:{width}}{label}" if label else f"{name:{width}}{_short(value)} {units.get(name, '')}".rstrip()
    by_length: dict[int, dict[str, Any]] = {}
    for name, value in answer._members().items():
        if isinstance(value, np.ndarray) and value.dtype.kind == "f" and value.shape[-1:] == (2,):
            for low, high in value.reshape(-1, 2).tolist():
                yield f"{head(name, units):{width}}{low!r} to {high!r}"
        elif isinstance(value, np.ndarray) and value.ndim == 1 and 0 < value.size <= SHOWN:
            by_length.setdefault(value.size, {})[name] = value
    for arrays in by_length.values():
        yield from _table(arrays, units)


def _table(columns: Mapping[str, Any], units: Mapping[str, str]) -> Iterator[str]:
    """The lines of a table."""
    rows = _rows(columns, units)
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "  ".join(text.rjust(width) for text, width in zip(row, widths, strict=True))
    if more := _more(columns):
        yield more


def _rows(columns: Mapping[str, Any], units: Mapping[str, str]) -> list[list[str]]:
    """Columns under their names, at most `SHOWN` rows; of many columns the first and the last, as many as `ACROSS`."""
    names = list(columns)
    if many := len(names) > ACROSS:
        names = [*names[: ACROSS - 2], *names[-1:]]
    rows = [[head(name, units) for name in names]]
    rows += ([_short(value) for value in row] for row in zip(*(columns[name][:SHOWN] for name in names), strict=True))
    return [[*row[:-1], "...", row[-1]] for row in rows] if many else rows


def _more(columns: Mapping[str, Any]) -> str:
    more = len(next(iter(columns.values()))) - SHOWN
    return f"and {more} more" if more > 0 else ""


def head(name: str, units: Mapping[str, str]) -> str:
    """Return a column's name, over its unit if it has one."""
    unit = units.get(name, "")
    return f"{name}/({unit})" if {"/", " "} & set(unit) else f"{name}/{unit}" if unit else name


def _short(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, (float, np.floating, np.complexfloating)) else str(value)


def plain(value: Any) -> Any:
    """Convert an array to lists (complex numbers to pairs), answers and mappings to dictionaries, codes to numbers."""
    if isinstance(value, Answer):
        return value.to_dict()
    if np.iscomplexobj(value):  # JSON has none
        value = np.stack((np.real(value), np.imag(value)), axis=-1)
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, Mapping):
        return {name: plain(one) for name, one in value.items()}
    if isinstance(value, Text):
        return str(value)
    return int(value) if isinstance(value, int) and not isinstance(value, bool) else value


def same(one: Any, two: Any) -> bool:
    """Whether two values are equal, arrays and mappings of arrays by their content."""
    if isinstance(one, np.ndarray):
        return np.array_equal(one, two, equal_nan=one.dtype.kind in "fc")
    if isinstance(one, Mapping):
        return one.keys() == two.keys() and all(same(one[name], two[name]) for name in one)
    return bool(one == two)


def frozen(values: Any) -> npt.NDArray[Any]:
    """Return values as a read-only array."""
    array = np.asarray(values)
    array.flags.writeable = False
    return array


def optional(package: str, wanted_by: str, extra: str = "tables") -> Any:
    """Import an optional package, or raise an ImportError that says how to install it."""
    try:
        return importlib.import_module(package)
    except ImportError:
        name = package.partition(".")[0]
        raise ImportError(f"{wanted_by} needs {name}: pip install 'slowflow[{extra}]'") from None


def joined(*remarks: Any) -> str:
    """Join diagnostics into one message."""
    texts = [remark for remark in remarks if remark]
    return together("; ", texts) if texts else ""


def sentences(message: str) -> tuple[str, ...]:
    """Split a message that is `joined` into its diagnostics."""
    if isinstance(message, Text) and message.sentence.pattern.startswith("{_0:s}; "):
        return tuple(one for part in message.values for one in sentences(part))
    return (message,) if isinstance(message, Text) else tuple(message.split("; "))
