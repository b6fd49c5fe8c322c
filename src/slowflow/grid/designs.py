"""Designs in arrays with named axes, or in blocks. Takes arrays of xarray or dask; returns Datasets of answers.

Dask arrays stay lazy until an answer is computed, block by block; `store` writes the blocks into Zarr.
"""

from __future__ import annotations

import copy
import pickle
from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np

from slowflow.answers.answer import optional
from slowflow.answers.table import AVERAGING, OFFSET, QUESTIONS, SECOND, ManyQuestions, Question
from slowflow.core import validate
from slowflow.core.mechanism import Mechanism
from slowflow.core.model import AT_CENTRE, THROUGHOUT, check_names, off_centre_by
from slowflow.exact.transient import NO_PULSE
from slowflow.grid.block import INNER, Ask, lengths, made_by, of_column, of_map
from slowflow.off_centre.many import check_polynomial
from slowflow.random_vibration.questions import excited_by
from slowflow.second.many import UNANSWERED
from slowflow.support.errors import Refused, WrongType
from slowflow.support.immutable import Unchanging
from slowflow.support.text import text
from slowflow_kernels.domains import DISSIPATION

__all__ = ["Grid"]

#: designs in a block where the arrays do not say how they are to be cut: some tens of MB
AT_ONCE = 2**18


class Grid(Unchanging, ManyQuestions[Any]):
    """Designs of one mechanism over named axes, and the questions about them; answers are xarray Datasets.

    mechanism -- record of the mechanism
    values    -- the parameters of its design by name, mu and zeta, and eta and c_2 if used: DataArrays, which broadcast
            by the names of their axes; or dask and NumPy arrays, which broadcast by position, with axes "design_0" and
            so on
    excitation, contact -- as in `slowflow.averaged.many.Designs`

    An answer has the columns of a batch, including `remarks`, over all axes, with the parameters as coordinates;
    coordinates of axes are kept. It is computed at once, unless a parameter is a dask array: then by `.compute()`.
    `workers` threads share one block, in addition to dask's own.

    Raises TypeError for a missing or unknown name, ValueError for arrays without real numbers and for axes that do not
    match, ImportError without xarray.
    """

    mechanism: Mechanism
    excitation: str
    contact: str
    values: dict[str, Any]
    _parameters: dict[str, Any]
    _depth: str

    def __init__(
        self, mechanism: Mechanism, values: Mapping[str, Any], excitation: str = "force", contact: str = THROUGHOUT
    ) -> None:
        own = {name: value for name, value in values.items() if name != "load"}
        parameters = {name: own[name] for name in check_names(mechanism, own, DISSIPATION)}
        if "load" in values:
            check_polynomial(mechanism)
            parameters["load"] = values["load"]
        # not by attribute: these cannot be set
        self.__dict__.update(mechanism=mechanism, excitation=excitation, contact=contact, values=labelled(parameters))
        self.__dict__.update(_parameters=parameters, _depth=AVERAGING)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Grid):
            return NotImplemented
        own = (self.mechanism, self.excitation, self.contact, self._depth, *self.values)
        theirs = (other.mechanism, other.excitation, other.contact, other._depth, *other.values)
        return own == theirs and all(value.identical(other.values[name]) for name, value in self.values.items())

    def __hash__(self) -> int:
        return hash((self.mechanism, self.excitation, self.contact, self._depth, *self.sizes.items()))

    @cached_property
    def second_approximation(self) -> Grid:
        """The same questions with higher harmonics of force and friction; see `slowflow.second.many`."""
        validate.is_plain("second_approximation", self._laws)
        if "load" in self._parameters:
            raise validate.NotAvailable(AT_CENTRE.format(off_centre_by(self.mechanism, 0.0) or "with a load"))
        deeper = copy.copy(self)
        deeper.__dict__["_depth"] = SECOND
        return deeper

    @property
    def _laws(self) -> str:
        """The damping laws other than mu and zeta, by name; empty without."""
        names = [one.name for one in DISSIPATION if one.name in self._parameters]
        return ", ".join(names if self.contact == THROUGHOUT else [*names, f"contact = {self.contact!r}"])

    @property
    def sizes(self) -> dict[str, int]:
        """Number of designs along each axis, by name."""
        return sizes(self.values)

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of designs along each axis."""
        return tuple(self.sizes.values())

    def _ask(self, question: str, /, *, workers: int = 1, **arguments: Any) -> Any:
        """The answer to a question by its name, from what its method takes, as a Dataset."""
        return self._answer(*self.asked(question, workers, **arguments))

    def store(self, path: Any, question: str, *, workers: int = 1, **arguments: Any) -> Any:
        """Write a question's answer into a Zarr store, block by block; an incomplete store is continued.

        path      -- folder of the store, which every worker of a cluster must reach; or another store that Zarr accepts
        question  -- name of the method, such as "saddle_node_onset"
        arguments -- arguments of this question, such as F_0, Omega and max_count

        Blocks are the chunks of the parameters, or about 250,000 designs along unchunked axes. After an interruption, a
        call with the same numbers computes the missing blocks, with the same bits; until then the attribute `complete`
        is 0, and status is -1 for missing entries. Returns the store as a lazy Dataset.

        Raises ValueError for a store with other numbers, another question, version or backend, and FileExistsError if
        the path is something else, before anything is computed; ImportError without dask, xarray and Zarr.
        """
        for package in ("dask", "zarr"):
            optional(package, "store", "grid")
        from slowflow.grid.store import filled

        ask, values = self.asked(question, workers, **arguments)
        must_travel(self.mechanism)
        nested = {dim for value in values.values() for dim, index in value.indexes.items() if index.nlevels > 1}
        if nested:
            raise Refused(
                f"the coordinate {nested.pop()} has several levels, which Zarr cannot store: call its .reset_index"
            )
        axes = sizes(values)
        return filled(path, ask, values, axes, blocks(values, axes))

    def asked(self, question: str, workers: int, **arguments: Any) -> tuple[Ask, dict[str, Any]]:
        """Return a question as a function of a block's numbers, and all the numbers that it takes.

        arguments -- of the question, other than the designs, as its method takes them

        Raises TypeError for missing or unknown arguments, ValueError for invalid ones.
        """
        system = OFFSET if "load" in self._parameters else self._depth
        known = tuple(name for name, row in QUESTIONS.items() if system in row.columns)
        if question in QUESTIONS and question not in known:
            raise validate.NotAvailable(self._without(question))
        entry = QUESTIONS[validate.choice("question", question, known)]
        arguments = {name: value for name, value in arguments.items() if value is not None}
        for name in entry.takes:
            if name not in arguments:
                raise WrongType(f"{name} is missing for {question}")
        for name in arguments:
            if name not in (*entry.takes, *entry.may, *entry.options):
                raise WrongType(f"{name} is not an argument of {question}")
        options = {name: arguments.pop(name, default) for name, default in entry.options.items()}
        self._check(question, options, arguments, workers)
        if options.get("psd") is not None:  # as a store tells it
            options["psd"] = [np.asarray(row, dtype=float).tolist() for row in options["psd"]]
        values, tables = self._with(entry, arguments)
        rows = max((values[name].sizes["row"] for name in tables if "row" in values[name].dims), default=1)
        own = self.mechanism, self.excitation, self.contact, question, self._depth, tuple(values)
        more = tuple(options.items()), tables, lengths(entry, system, options, rows)
        found = Ask(*own, *more, workers, made_by(self.mechanism))
        axes = {dim for name, value in values.items() for dim in value.dims if dim != entry.argument_axes.get(name)}
        taken = {*INNER, "done", *found.columns()} & {*axes, *values}
        if taken:
            raise Refused(f"an axis or a parameter cannot be named {taken.pop()}: the answer has a column of that name")
        return found, values

    def _check(self, question: str, options: Mapping[str, Any], arguments: Mapping[str, Any], workers: int) -> None:
        """Raises ValueError for what is the same for all designs and not allowed, before anything is computed."""
        validate.workers(workers)
        if "max_count" in options:
            validate.count("max_count", options["max_count"], least=1)
        if "samples" in options:
            validate.curve(options["samples"], options["Omega"])
        if options.get("after") is not None:
            validate.number("after", options["after"], least=0.0)
        if question == "random":
            excited_by(None if arguments.get("S_0") is None else 1.0, options["psd"])
        if question == "transient" and ("duration" in arguments) == ("tau" in arguments):
            raise Refused(NO_PULSE)
        if question == "certify":
            validate.is_force(question, self.excitation)
            validate.is_plain(question, self._laws)

    def _without(self, question: str) -> str:
        """Why a question of the table has no answer here."""
        if "load" in self._parameters:
            return AT_CENTRE.format(off_centre_by(self.mechanism, 0.0) or "with a load")
        if question == "rest":
            return text("rest is not available without a load: the mass rests at {u} = 0")
        return f"{question}: {UNANSWERED[question]}"

    def _with(self, entry: Question, arguments: Mapping[str, Any]) -> tuple[dict[str, Any], tuple[str, ...]]:
        """All numbers of a question, and the names of those that are tables or records."""
        axes = {name: axis for name, axis in entry.argument_axes.items() if axis == "row" or "tau" in arguments}
        plain = {name: value for name, value in arguments.items() if name not in axes}
        values = labelled({**self._parameters, **plain}) if plain else dict(self.values)
        for name, axis in axes.items():
            if name in arguments:
                values[name] = tabled(name, arguments[name], axis)
        aligned = optional("xarray", "a grid", "grid").align(*values.values(), join="exact", copy=False)
        values = dict(zip(values, aligned, strict=True))
        return values, tuple(name for name, axis in axes.items() if name in arguments and axis in values[name].dims)

    def _answer(self, ask: Ask, values: dict[str, Any]) -> Any:
        xarray = optional("xarray", "a grid", "grid")
        columns = ask.columns()
        if any(value.chunks is not None for value in values.values()):
            must_travel(self.mechanism)
            cut = blocks(values, sizes(values))
            whole = dict.fromkeys(INNER, -1)
            values = {
                name: value.chunk({dim: {**cut, **whole}[dim] for dim in value.dims}) for name, value in values.items()
            }
        found = xarray.apply_ufunc(
            ask,
            *values.values(),
            join="exact",
            dask="parallelized",
            input_core_dims=[[dim for dim in value.dims if dim in INNER] for value in values.values()],
            output_core_dims=[[axis] if axis else [] for axis, _ in columns.values()],
            output_dtypes=[kind for _, kind in columns.values()],
            dask_gufunc_kwargs={"output_sizes": dict(ask.lengths)},
        )
        content = xarray.Dataset(dict(zip(columns, found, strict=True)), attrs=of_map(ask))
        for name in columns:
            content[name].attrs.update(of_column(ask, name))
        coordinates = {name: value.assign_attrs(of_column(ask, name)) for name, value in values.items()}
        return content.assign_coords(coordinates)


def labelled(values: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers by name as DataArrays with common axes and the coordinates of these; small ones are loaded."""
    xarray = optional("xarray", "a grid", "grid")
    named = any(isinstance(value, (xarray.DataArray, xarray.Variable)) and value.ndim for value in values.values())
    found = {}
    for name, value in values.items():
        array = value if validate.is_labelled(value) else validate.real_array(name, value)
        if not all(length == length for length in array.shape):  # dask counts what it has not counted as NaN
            raise Refused(f"{name} has blocks of unknown length: {name}.compute_chunk_sizes() counts them")
        if array.dtype.kind not in "fiu":
            raise Refused(f"{name} holds {array.dtype}: it must hold real numbers")
        if isinstance(array, (xarray.DataArray, xarray.Variable)):
            found[name] = xarray.DataArray(array).reset_coords(drop=True)
        elif named and array.ndim:
            raise Refused(f"{name} has axes without names, while others have names: xarray.DataArray({name}, dims=...)")
        else:
            found[name] = xarray.DataArray(array) if named else array
    if not named:
        found = _by_position(xarray, found)
    if not all(isinstance(dim, str) for value in found.values() for dim in value.dims):
        raise Refused("the names of axes must be strings")
    aligned = xarray.align(*found.values(), join="exact", copy=False)
    found = {name: _parameter(name, value) for name, value in zip(found, aligned, strict=True)}
    own = [name for name in found if name in sizes(found) and found[name].dims != (name,)]
    if own:
        raise Refused(f"an axis is named {own[0]}, but {own[0]} itself has other axes: rename the axis")
    return found


def tabled(name: str, value: Any, axis: str) -> Any:
    """A column of a table, or a record, as a DataArray that may have this axis; an unnamed array has it."""
    xarray = optional("xarray", "a grid", "grid")
    array = value if validate.is_labelled(value) else validate.real_array(name, value)
    if array.dtype.kind not in "fiu":
        raise Refused(f"{name} holds {array.dtype}: it must hold real numbers")
    if isinstance(array, (xarray.DataArray, xarray.Variable)):
        found = xarray.DataArray(array).reset_coords(drop=True)
    elif array.ndim < 2:
        found = xarray.DataArray(array, dims=[axis][: array.ndim])
    else:
        raise Refused(f"{name} has several axes without names: xarray.DataArray({name}, dims=[..., {axis!r}])")
    return found.astype(float).drop_vars(axis, errors="ignore")


def _by_position(xarray: Any, arrays: dict[str, Any]) -> dict[str, Any]:
    """Arrays that broadcast as NumPy's do, as DataArrays; an axis of length 1 that others stretch is left out."""
    shape = validate.common_shape(arrays)
    found = {}
    for name, array in arrays.items():
        beyond = len(shape) - array.ndim
        kept = [k for k, length in enumerate(array.shape) if length == shape[beyond + k]]
        plain = array.reshape([array.shape[k] for k in kept]) if len(kept) < array.ndim else array
        found[name] = xarray.DataArray(plain, dims=[f"design_{beyond + k}" for k in kept])
    return found


def _parameter(name: str, value: Any) -> Any:
    """One parameter, in doubles; where it lies along an axis of its own name it must be that axis' coordinate."""
    value = value if value.dtype == float else value.astype(float)
    if name in value.coords and not np.array_equal(value.coords[name], value, equal_nan=True):
        raise Refused(f"the coordinate {name} differs from the values of {name}: rename the axis")
    return value


def sizes(values: Mapping[str, Any]) -> dict[str, int]:
    """Lengths of all axes of the designs by name, in the order of the parameters."""
    found: dict[str, int] = {}
    for value in values.values():
        found |= {str(dim): int(length) for dim, length in value.sizes.items() if dim not in INNER}
    return found


def blocks(values: Mapping[str, Any], lengths: Mapping[str, int]) -> dict[str, int]:
    """Number of designs per block along each axis: the arrays' chunks, along other axes as many as fit into a block."""
    optional("dask", "blocks", "grid")
    from dask.array.core import normalize_chunks

    cut: dict[str, int] = {}
    for value in values.values():
        for dim, chunks in value.chunksizes.items():
            if dim in INNER:
                continue
            cut[dim] = min(max(chunks), cut.get(dim, max(chunks)))
    target = tuple(max(cut[dim], 1) if dim in cut else "auto" for dim in lengths)
    shape = tuple(lengths.values())
    if not all(shape):  # nothing to cut
        return {dim: max(length, 1) for dim, length in lengths.items()}
    chosen = normalize_chunks(target, shape=shape, limit=8 * AT_ONCE, dtype=np.dtype(float))
    return {dim: max(cuts) for dim, cuts in zip(lengths, chosen, strict=True)}


def must_travel(mechanism: Mechanism) -> None:
    """Raise ValueError for a mechanism whose functions cannot be sent to another process."""
    try:
        pickle.loads(pickle.dumps(mechanism))
    except Exception as error:
        raise Refused(f"{mechanism.name} cannot be sent to other processes: {error}") from error
