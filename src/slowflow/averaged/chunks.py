"""Designs in parts. Takes the shape of their arrays; returns indices of parts, and the work on them by threads."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from typing import Any

from slowflow.support import progress

#: designs of the first part, few enough where each takes as long as any, and seconds that a part is to take at most
FIRST_PART, TOO_LONG = 16, 0.4


def blocks(shape: tuple[int, ...], most: int) -> Iterator[tuple[slice | int, ...]]:
    """Indices of parts of at most so many entries that make up an array of that shape.

    Who takes long over a part gets fewer entries next: between parts Ctrl-C is heard.
    """
    if not shape:
        yield (...,)  # type: ignore[misc]  # a view, where () would be the number itself
        return
    beyond = math.prod(shape[1:])
    if beyond > most:
        for k in range(shape[0]):
            for inner in blocks(shape[1:], most):
                yield (k, *inner)
        return
    most_rows = most // max(beyond, 1)
    start, rows = 0, min(FIRST_PART, most_rows)
    while start < shape[0]:
        began = time.perf_counter()
        yield (slice(start, start + rows),)
        start += rows
        took = time.perf_counter() - began
        if took > TOO_LONG:
            rows = max(rows // 4, 1)
        elif took < TOO_LONG / 8:
            rows = min(4 * rows, most_rows)


def map_chunks(
    work: Callable[[Any], None], chunks: Iterator[Any], threads: int, size: Callable[[Any], int], total: int
) -> None:
    """Map `work`, which releases the interpreter's lock, over the chunks by so many threads, with progress.

    size, total -- how many designs a chunk has, and all of them
    """
    tally = progress.Tally(total)

    def run(one: Any) -> None:
        work(one)
        tally.add(size(one))

    if threads == 1:
        for one in chunks:
            run(one)
        return
    from concurrent.futures import ThreadPoolExecutor  # one thread is what most ask for

    with ThreadPoolExecutor(threads) as pool:
        try:
            for _ in pool.map(run, chunks):
                pass
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
