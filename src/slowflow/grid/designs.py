"""Maps over named axes, made from xarray or dask arrays.

Results are xarray Datasets. Dask arrays stay lazy until a result is computed, block by block; `store` writes the blocks
into a Zarr store.
"""

from __future__ import annotations

import inspect
import pickle
from collections.abc import Mapping
from enum import IntEnum
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from slowflow.answers.answer import optional
from slowflow.answers.table import COLUMNS, IN_TIME, QUESTIONS, ManyQuestions, Question
from slowflow.core import validate
from slowflow.core.mechanism import Mechanism
from slowflow.core.model import THROUGHOUT
from slowflow.grid.block import DIMENSIONLESS, INNER, UNITS_OF, Ask, MapColumn, attributes, made_by
from slowflow.support.errors import Refused
from slowflow.support.immutable import Unchanging
from slowflow_kernels.domains import DAMPING, DISSIPATION

if TYPE_CHECKING:
    import xarray

__all__ = ["Grid"]

#: designs in a block where the arrays do not say how they are to be cut: some tens of MB
AT_ONCE = 2**18


class Grid(Unchanging, ManyQuestions["xarray.Dataset", Any]):
    """Designs of one mechanism over named axes, and the questions about them; answers are xarray Datasets.

    mechanism -- record of the mechanism
    designs   -- an empty batch, of the class that evaluates each block
    values    -- numbers of the designs by name: DataArrays, which broadcast by the names of their axes; or arrays of
            dask and NumPy, which broadcast by position, with axes "design_0" and so on

    An answer has the columns of a batch, including `remarks`, over all axes, with the parameters as coordinates;
    coordinates of axes are kept. It is computed at once, unless a parameter is a dask array: then by `.compute()`.
    `workers` threads share one block, in addition to dask's own.

    Raises ValueError for arrays without real numbers and for axes that do not match, ImportError without xarray.
    """

    mechanism: Mechanism
    designs: Any
    values: dict[str, Any]
    _parameters: Mapping[str, Any]

    def __init__(self, mechanism: Mechanism, designs: Any, values: Mapping[str, Any]) -> None:
        # not by attribute: these cannot be set
        self.__dict__.update(mechanism=mechanism, designs=designs, values=labelled(values), _parameters=values)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Grid):
            return NotImplemented
        own, theirs = ((one.mechanism, one.designs, *one.values) for one in (self, other))
        return own == theirs and all(value.identical(other.values[name]) for name, value in self.values.items())

    def __hash__(self) -> int:
        return hash((self.mechanism, self.designs, *self.sizes.items()))

    @cached_property
    def second_approximation(self) -> Self:
        """The same questions with higher harmonics of force and friction; see `slowflow.second.many`."""
        return type(self)(self.mechanism, self.designs.second_approximation, self._parameters)

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
        return self._answer(*self._query(question, workers, **arguments))

    def store(self, path: Any, question: str, *, workers: int = 1, **arguments: Any) -> xarray.Dataset:
        """Write a question's answer into a Zarr store, block by block; an incomplete store is continued.

        path      -- folder of the store, which every worker of a cluster must reach; or another store that Zarr accepts
        question  -- name of the method, such as "saddle_node_onset"
        arguments -- arguments of this question, such as F_0, Omega and max_count

        Blocks are the chunks of the parameters, or about 250,000 designs along unchunked axes. After an interruption, a
        call with the same numbers computes the missing blocks, with the same bits; until then the attribute `complete`
        is 0, and status is -1 for missing entries. Each call reads the blocks that are there, and computes those anew
        that have lost a chunk or do not match their checksums. Returns the store as a lazy Dataset.

        Raises ValueError for a store with other numbers, another question, version or backend, or with damaged
        metadata, and FileExistsError if the path is something else, before anything is computed; ImportError without
        dask, xarray and Zarr.
        """
        for package in ("dask", "zarr"):
            optional(package, "store", "grid")
        from slowflow.grid.store import filled

        ask, values = self._query(question, workers, **arguments)
        must_travel(ask)
        nested = {dim for value in values.values() for dim, index in value.indexes.items() if index.nlevels > 1}
        if nested:
            raise Refused(
                f"the coordinate {nested.pop()} has several levels, which Zarr cannot store: call its .reset_index"
            )
        axes = sizes(values)
        return filled(path, ask, values, axes, blocks(values, axes))

    def _query(self, question: str, workers: int = 1, **arguments: Any) -> tuple[Ask, dict[str, Any]]:
        """Return a question as a function of a block's numbers, and all the numbers that it takes.

        arguments -- of the question, other than the designs, as its method takes them

        Raises TypeError for missing or unknown arguments, ValueError for invalid ones, as a batch without designs does.
        """
        entry = QUESTIONS[validate.choice("question", question, tuple(QUESTIONS))]
        getattr(self.designs, question)  # or the reason why there is none
        arguments = {name: value for name, value in arguments.items() if value is not None}
        validate.bound(question, inspect.signature(getattr(ManyQuestions, question)), (self,), arguments)
        options = {name: arguments.pop(name, default) for name, default in self._defaults(entry).items()}
        plain = {self._shown(name): name for name in (*arguments, *options)}
        tables = (name for name, axis in entry.argument_axes.items() if axis == "row" or "tau" in arguments)
        axes = {self._shown(name): entry.argument_axes[name] for name in tables}
        values = self._with({self._shown(name): value for name, value in arguments.items()}, axes)
        inner = {name: [dim for dim in value.dims if dim == axes.get(name)] for name, value in values.items()}
        with_rows = tuple(name for name, dims in inner.items() if dims)
        shown_options = {self._shown(name): value for name, value in options.items()}
        own = self.designs, self.mechanism, question, tuple(values), shown_options, with_rows, plain, workers
        sizes_of_none = ([0, *(values[name].sizes[dim] for dim in dims)] for name, dims in inner.items())
        none = Ask(*own).answer(*map(np.empty, sizes_of_none))
        ask = Ask(*own, self._columns(none), self._about_map(none))
        of_designs = {dim for name, value in values.items() for dim in value.dims if dim not in inner[name]}
        taken = {*INNER, "done", *ask.columns} & {*of_designs, *values}
        if taken:
            raise Refused(f"an axis or a parameter cannot be named {taken.pop()}: the answer has a column of that name")
        return ask, {name: one.assign_attrs(self._about(plain.get(name, name))) for name, one in values.items()}

    def _columns(self, none: Any) -> dict[str, MapColumn]:
        """The columns of a map by name, from the answer about no designs."""
        batch, found = getattr(none, "answer", none), {}
        for name, (axis, kind) in batch.question.layout(batch.system).items():
            shown = self._shown(name)
            length = getattr(none, shown).shape[-1] if axis else 1
            found[shown] = MapColumn(axis, length, kind, self._about(name, batch.question.kinds))
        return found

    def _about_map(self, none: Any) -> dict[str, str]:
        """The attributes of a whole map, from the answer about no designs."""
        batch = getattr(none, "answer", none)
        settings = {name: value for name, value in self.designs._settings.items() if value != THROUGHOUT}
        if batch.question.name in IN_TIME:
            del settings["excitation"]
        own = {"mechanism": self.mechanism.name, "title": self.mechanism.title, **settings}
        return {**own, "question": batch.question.name, "depth": batch.system, **made_by(self.mechanism)}

    def _about(self, name: str, kinds: type[IntEnum] | None = None) -> dict[str, Any]:
        """The attributes of a column, or of a number that a question takes."""
        return attributes(name, *self._meaning(name), kinds)

    def _defaults(self, row: Question) -> Mapping[str, Any]:
        """The options of a question."""
        return row.options

    def _shown(self, name: str) -> str:
        """The name of a column or an argument in an answer."""
        return name

    def _meaning(self, name: str) -> tuple[str, str]:
        """The meaning and the unit of a number."""
        known = {domain.name: domain.doc for domain in (*self.mechanism.design, *DAMPING, *DISSIPATION)}
        return known.get(name) or COLUMNS[name].text, UNITS_OF.get(name, DIMENSIONLESS)

    def _with(self, arguments: Mapping[str, Any], axes: Mapping[str, str]) -> dict[str, Any]:
        """All numbers of a question; axes of tables and records by name."""
        plain = {name: value for name, value in arguments.items() if name not in axes}
        values = labelled({**self._parameters, **plain}) if plain else dict(self.values)
        values |= {name: tabled(name, arguments[name], axis) for name, axis in axes.items() if name in arguments}
        return _aligned(values)

    def _answer(self, ask: Ask, values: dict[str, Any]) -> Any:
        xarray = optional("xarray", "a grid", "grid")
        if any(value.chunks is not None for value in values.values()):
            must_travel(ask)
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
            keep_attrs=False,
            input_core_dims=[[dim for dim in value.dims if dim in INNER] for value in values.values()],
            output_core_dims=[[column.axis] if column.axis else [] for column in ask.columns.values()],
            output_dtypes=[column.type for column in ask.columns.values()],
            dask_gufunc_kwargs={"output_sizes": ask.lengths},
        )
        content = xarray.Dataset(dict(zip(ask.columns, found, strict=True)), attrs=dict(ask.about))
        for name, column in ask.columns.items():
            content[name].attrs.update(column.attributes)
        return content.assign_coords(values)


def labelled(values: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers by name as DataArrays with common axes and the coordinates of these; small ones are loaded."""
    xarray = optional("xarray", "a grid", "grid")
    named = any(isinstance(value, (xarray.DataArray, xarray.Variable)) and value.ndim for value in values.values())
    found = {}
    for name, value in values.items():
        array = _numbers(name, value)
        if not all(length == length for length in array.shape):  # dask counts what it has not counted as NaN
            raise Refused(f"{name} has blocks of unknown length: {name}.compute_chunk_sizes() counts them")
        if isinstance(array, (xarray.DataArray, xarray.Variable)):
            if len(set(array.dims)) < array.ndim:
                raise Refused(
                    f"{name} has the axes {', '.join(map(str, array.dims))}: each name may be that of one axis"
                )
            found[name] = xarray.DataArray(array, attrs={}).reset_coords(drop=True)
        elif named and array.ndim:
            raise Refused(f"{name} has axes without names, while others have names: xarray.DataArray({name}, dims=...)")
        else:
            found[name] = xarray.DataArray(array) if named else array
    if not named:
        found = _by_position(xarray, found)
    if not all(isinstance(dim, str) for value in found.values() for dim in value.dims):
        raise Refused("the names of axes must be strings")
    found = {name: _parameter(name, value) for name, value in _aligned(found).items()}
    own = [name for name in found if name in sizes(found) and found[name].dims != (name,)]
    if own:
        raise Refused(f"an axis is named {own[0]}, but {own[0]} itself has other axes: rename the axis")
    return found


def _aligned(values: Mapping[str, Any]) -> dict[str, Any]:
    """DataArrays as they are. Raises ValueError for an axis that is not the same in two of them."""
    axes: dict[str, tuple[str, Any]] = {}
    for name, value in values.items():
        for dim, own in value.indexes.items():
            first, known = axes.setdefault(dim, (name, own))
            if not known.equals(own):
                both = f"{known.to_numpy()} and {own.to_numpy()}"
                raise Refused(f"{first} and {name} have different coordinates along the axis {dim}: {both}")
    aligned = optional("xarray", "a grid", "grid").align(*values.values(), join="exact", copy=False)
    return dict(zip(values, aligned, strict=True))


def tabled(name: str, value: Any, axis: str) -> Any:
    """A column of a table, or a record, as a DataArray that may have this axis; an unnamed array has it."""
    xarray = optional("xarray", "a grid", "grid")
    array = _numbers(name, value)
    if isinstance(array, (xarray.DataArray, xarray.Variable)):
        found = xarray.DataArray(array, attrs={}).reset_coords(drop=True)
    elif array.ndim < 2:
        found = xarray.DataArray(array, dims=[axis][: array.ndim])
    else:
        raise Refused(f"{name} has several axes without names: xarray.DataArray({name}, dims=[..., {axis!r}])")
    return found.astype(float).drop_vars(axis, errors="ignore")


def _numbers(name: str, value: Any) -> Any:
    """Real numbers of any shape, labelled ones as they are. Raises ValueError for labelled ones in a unit."""
    array = value if validate.is_labelled(value) else validate.real_array(name, value)
    if array.dtype.kind not in "fiu":
        raise Refused(f"{name} holds {array.dtype}: it must hold real numbers")
    unit, own = getattr(array, "attrs", {}).get("units", ""), UNITS_OF.get(name, DIMENSIONLESS)
    if unit not in ("", "1", own):
        raise Refused(f"{name} has units = {unit!r}: it must be {f'in {own}' if name in UNITS_OF else own}")
    return array


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


def must_travel(ask: Ask) -> None:
    """Raise ValueError for a mechanism whose functions cannot be sent to another process."""
    try:
        pickle.loads(pickle.dumps(ask))
    except Exception as error:
        raise Refused(f"{ask.mechanism.name} cannot be sent to other processes: {error}") from error
