"""A map in a Zarr store, block by block. Takes a question and its numbers; returns the store, complete at last.

A block is computed and written by one task of dask, and ticked off in the array `done` when all of it is written. What
is not ticked off is computed, or computed again, with the same bits; so is what is ticked off and cannot be read.
Nothing else is remembered, so that any process may go on where another one stopped.
"""

from __future__ import annotations

import hashlib
import json
import os
import pickle
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import dask
import numpy as np
import xarray
import zarr
from dask.callbacks import Callback
from zarr.codecs import ZstdCodec
from zarr.core.sync import sync
from zarr.errors import ContainsArrayError, ContainsGroupError

from slowflow.grid.block import INNER, NOT_YET, Ask
from slowflow.support import progress
from slowflow.support.errors import Refused

#: which blocks are written; it is made last, so that a store which has it is prepared
DONE = "done"
#: numbers of a parameter up to which it is read at the start, compared by content and kept in one piece
READ = 2**20
#: of places that are not written yet
FILL = {"f": np.nan, "i": 0, "u": 0}

Block = tuple[int, ...]


def filled(path: Any, ask: Ask, values: Mapping[str, Any], sizes: dict[str, int], blocks: dict[str, int]) -> Any:
    """The store at a path, begun or continued until every block is in it; a lazy Dataset.

    values -- DataArrays by name, what `ask` is called with
    sizes  -- lengths of the axes, in their order
    blocks -- lengths of a block along each; a store that was begun keeps its own
    """
    if isinstance(path, Path) or (isinstance(path, str) and "://" not in path):
        path = os.path.abspath(path)  # means the same to every process; a store of Zarr, or an address, does as it is
    values = {name: value if _unread(value) else value.compute() for name, value in values.items()}
    identity = _identity(ask, values, sizes)
    coords = {dim for value in values.values() for dim in value.coords}
    about = {**ask.about, "query": json.dumps(identity), "blocks": json.dumps(blocks), "complete": 0}
    about["coordinates"] = " ".join(sorted((coords | values.keys()) - sizes.keys()))
    while True:
        try:
            group = _begun(path, identity, about)
            blocks = json.loads(group.attrs["blocks"])
            _prepare(path, ask, values, group, sizes, blocks)
        except (ContainsGroupError, ContainsArrayError):
            continue  # another process made it in between: it is there now
        break
    dims = list(sizes)
    unread = {name: tuple(map(dims.index, _dims(value, sizes))) for name, value in values.items() if _unread(value)}
    fill = Fill(path, ask, unread)
    done = _read(path, DONE, lambda: group[DONE][...])
    dask.compute(*(dask.delayed(fill.check, pure=False)(tuple(block)) for block in np.argwhere(done).tolist()))
    _note_complete(group)
    with _reporter(group):
        dask.compute(*_missing(fill, values, group, sizes, blocks))
    _note_complete(group)
    return xarray.open_zarr(path, consolidated=False).drop_vars(DONE)


def _note_complete(group: Any) -> None:
    """Note whether every block is ticked off; what is noted is not written again, another process may know better."""
    complete = int(np.all(group[DONE][...]))
    if group.attrs["complete"] != complete:
        group.attrs["complete"] = complete


def _reporter(group: Any) -> Callback:
    """A callback that reports how many blocks are written while dask computes on this machine; a cluster has its own.

    Each is ticked off in the store, of whichever process.
    """
    total = group[DONE].size
    tally = progress.Tally(total, "blocks")

    def after(*_: Any) -> None:
        tally.come_to(lambda: int(np.count_nonzero(group[DONE][...])))

    return Callback(posttask=after)


# ---- one block


@dataclass(frozen=True)
class Fill:
    """The task of one block, which pickles: computes its columns, writes them, ticks it off.

    unread -- axes of the parameters that were not read at the start, by name: they are written with the columns
    """

    path: Any
    ask: Ask
    unread: dict[str, tuple[int, ...]]

    def __call__(self, block: Block, region: tuple[slice, ...], *values: Any) -> None:
        """The block with this number, in this region of the map; values have all its axes, some of length 1."""
        group = zarr.open_group(self.path, mode="r+")
        for name, column in zip(self.ask.columns, self.ask(*values), strict=True):
            # chunks without a number are written too: one that is missing is lost
            group[name].with_config({"write_empty_chunks": True})[region] = column
        by_name = dict(zip(self.ask.names, values, strict=True))
        for name, axes in self.unread.items():
            value = by_name[name].reshape([by_name[name].shape[k] for k in axes])
            group[name].with_config({"write_empty_chunks": True})[tuple(region[k] for k in axes)] = value
        group[DONE][block] = True

    def check(self, block: Block) -> None:
        """Take back the tick of a block of which a chunk is missing, which reads as the fill value, or is damaged."""
        group = zarr.open_group(self.path, mode="r+")
        chunks = {name: (*block, 0) if column.axis else block for name, column in self.ask.columns.items()}
        chunks |= {name: tuple(block[k] for k in axes) for name, axes in self.unread.items()}
        if not all(_is_readable(group[name], chunk) for name, chunk in chunks.items()):
            group[DONE][block] = False


def _is_readable(array: Any, chunk: Block) -> bool:
    """Whether a chunk is there, and decodes; its checksum is compared with that."""
    if not sync((array.store_path / array.metadata.encode_chunk_key(chunk)).exists()):
        return False
    try:
        array.get_block_selection(chunk)
    except (RuntimeError, ValueError):  # of the codec, or of an array that has another size
        return False
    return True


def _missing(
    fill: Fill, values: Mapping[str, Any], group: Any, sizes: Mapping[str, int], blocks: Mapping[str, int]
) -> Iterator[Any]:
    """The tasks of the blocks that are not ticked off."""
    task = dask.delayed(fill, pure=False, traverse=False)
    pieces = [_part_of(value, sizes, blocks) for value in values.values()]
    for block in np.argwhere(~np.asarray(group[DONE][...])).tolist():
        steps = list(zip(sizes, block, strict=True))
        region = tuple(slice(k * blocks[dim], min((k + 1) * blocks[dim], sizes[dim])) for dim, k in steps)
        yield task(tuple(block), region, *(part(tuple(block), region) for part in pieces))


def _part_of(
    value: Any, sizes: Mapping[str, int], blocks: Mapping[str, int]
) -> Callable[[Block, tuple[slice, ...]], Any]:
    """What a block has of a parameter, with all axes of the map, of length 1 where it does not vary: array or task."""
    plain = value.drop_vars(list(value.coords))
    whole = plain.expand_dims([dim for dim in sizes if dim not in value.dims]).transpose(*sizes, ...)
    if _unread(value):
        tasks = np.asarray(whole.chunk({dim: blocks[dim] for dim in value.dims}).data.to_delayed())
        return lambda block, _: tasks[tuple(k if n > 1 else 0 for k, n in zip(block, tasks.shape, strict=True))]
    array, varies = whole.values, [length > 1 for length in whole.shape]  # a table's rows come last
    return lambda _, region: array[tuple(k if one else slice(None) for k, one in zip(region, varies, strict=False))]


def _unread(value: Any) -> bool:
    return int(value.size) > READ and not any(dim in INNER for dim in value.dims)


def _dims(value: Any, sizes: Mapping[str, int]) -> list[str]:
    """The axes of a parameter, in the map's order."""
    return [dim for dim in sizes if dim in value.dims]


# ---- the store


def _begun(path: Any, identity: dict[str, Any], about: dict[str, Any]) -> Any:
    """The store that was begun with the same numbers, or a new one, which has nothing but what it is about."""
    folder = Path(path) if isinstance(path, str) and "://" not in path else None
    try:
        group = _read(path, "zarr.json", lambda: zarr.open_group(path, mode="r+"))
    except (FileNotFoundError, FileExistsError):
        others = folder is not None and folder.exists() and (not folder.is_dir() or any(folder.iterdir()))
        if folder is not None and others and not any(folder.glob("zarr.*")):  # else another process began just now
            raise FileExistsError(f"{path} exists and is not a Zarr store") from None
        return zarr.create_group(path, attributes=about)
    begun = json.loads(group.attrs.get("query", "{}"))
    if not begun:
        raise FileExistsError(f"{path} is a Zarr store, but not that of a map")
    other = sorted(name for name in begun | identity if begun.get(name) != identity.get(name))
    if other:
        differences = "; ".join(
            f"{name}: {begun.get(name, 'none')} there, {identity.get(name, 'none')} here" for name in other
        )
        raise Refused(f"{path} was begun with other values and is unchanged: {differences}")
    return group


def _read(path: Any, what: str, read: Callable[[], Any]) -> Any:
    """What a function reads of a store. Raises Refused if that is damaged, with where and what to do."""
    try:
        return read()
    except OSError:  # it is not there, or not allowed
        raise
    except (KeyError, RuntimeError, TypeError, ValueError) as error:
        raise Refused(
            f"{path} is damaged and is unchanged: {what} cannot be read ({error}): restore it from a copy, or delete "
            "the store to compute it anew"
        ) from error


def _prepare(
    path: Any, ask: Ask, values: Mapping[str, Any], group: Any, sizes: dict[str, int], blocks: dict[str, int]
) -> None:
    """All arrays of a store; `done` comes last. Raises Refused for those whose metadata are damaged.

    What was read is written in any case, each file whole and with the same bytes; other arrays are left if they are
    there. So processes that begin at the same time do each other no harm.
    """
    unread = {name: value for name, value in values.items() if _unread(value)}
    coords = {dim: coord for value in values.values() for dim, coord in value.coords.items()}
    read = {name: value for name, value in values.items() if name not in unread}
    # as variables, because xarray would write attributes about coordinates; an encoding is of where they come from, and
    # may round
    encoded: dict[str, Any] = {}
    known = xarray.Dataset(coords=coords | read).reset_coords().drop_encoding()
    known.to_zarr(zarr.storage.MemoryStore(encoded), consolidated=False)
    for key, content in encoded.items():
        if key != "zarr.json":
            sync((group.store_path / key).set(content))
    counts = {f"block_of_{dim}": -(-length // blocks[dim]) for dim, length in sizes.items()}
    lengths, cut = sizes | ask.lengths | counts, blocks | ask.lengths | dict.fromkeys(counts, 1)

    def make(name: str, dims: list[str], kind: Any, fill: Any, attributes: dict[str, Any]) -> None:
        if sync((group.store_path / f"{name}/zarr.json").exists()):
            _read(path, f"{name}/zarr.json", partial(group.__getitem__, name))
            return
        group.create_array(
            name,
            shape=[lengths[dim] for dim in dims],
            chunks=[cut[dim] for dim in dims],
            dtype=kind,
            fill_value=fill,
            compressors=ZstdCodec(level=0, checksum=True),
            dimension_names=dims,
            attributes=attributes,
        )

    for name, value in unread.items():
        make(name, _dims(value, sizes), value.dtype, np.nan, value.attrs)
    for name, (axis, _, kind, attributes) in ask.columns.items():
        fill = NOT_YET if name == "status" else FILL[kind.kind]
        make(name, [*sizes, *([axis] if axis else [])], kind, fill, attributes)
    make(DONE, list(counts), bool, False, {"long_name": "which blocks are written"})


def _identity(ask: Ask, values: Mapping[str, Any], sizes: Mapping[str, int]) -> dict[str, Any]:
    """What makes a map this one, by name: question, version, axes, and each parameter by its content.

    Of a parameter that is not read the name that dask gives it stands for the content.
    """
    found: dict[str, Any] = {**ask.about, **ask.options, "axes": list(sizes.items())}
    # a record that was changed keeps its name
    found["record"] = hashlib.sha256(pickle.dumps(ask.mechanism)).hexdigest()[:16]
    for name, value in values.items():
        dims = _dims(value, sizes)
        kept = value.data.name if value.chunks is not None else _digest(value.transpose(*dims, ...).values)
        found[name] = [dims, kept]
        found |= {f"coordinate {dim}": _digest(np.asarray(coord)) for dim, coord in value.coords.items()}
    plain = json.dumps(found, default=lambda numbers: np.asarray(numbers).tolist())
    return json.loads(plain)  # type: ignore[no-any-return]  # as it is read back


def _digest(array: Any) -> Any:
    """A word for the content of an array; a single number is its own word, so that a refusal shows it."""
    if array.size == 1 and array.dtype.kind in "fiu":
        return array.item()
    content = array.tobytes() if array.dtype.kind in "fiubmM" else repr(array.tolist()).encode()
    return hashlib.sha256(f"{array.dtype.str} {array.shape} ".encode() + content).hexdigest()[:16]
