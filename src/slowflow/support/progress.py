"""Progress of long computations, logged under "slowflow" at level INFO.

A line is logged after one second, then whenever the elapsed time has grown by a tenth, but at most once a second.
Programs that configure `logging` see these lines; others use `shown`.

    from slowflow import Isolator
    from slowflow.support import progress
    from slowflow.sizing import tolerances

    mount = Isolator.physical(m=12, k_v=2500, k_h=1700, L=0.080, preload=0.009, friction=0.4, zeta=0.02)
    with progress.shown():
        tolerances(mount, {"k_h": 0.05}, F=5, samples=10**4)
"""

from __future__ import annotations

import contextlib
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from typing import Any, TypeVar

__all__ = ["shown"]

T = TypeVar("T")

#: seconds before the first line, and at least between two; the latter over the time that has passed
EVERY, FRACTION = 1.0, 0.1


def _logger() -> Any:
    """The logger where somebody reads it: not where `logging`, which takes a while to import, is not imported yet."""
    if (logging := sys.modules.get("logging")) is None:
        return None
    log = logging.getLogger("slowflow")
    return log if log.isEnabledFor(logging.INFO) else None


@contextlib.contextmanager
def shown() -> Iterator[None]:
    """Print progress to stderr within this context."""
    import logging

    log, handler = logging.getLogger("slowflow"), logging.StreamHandler()
    level = log.level
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    try:
        yield
    finally:
        log.setLevel(level)
        log.removeHandler(handler)


class Tally:
    """Counter of completed designs; any thread may add, and progress is logged from time to time."""

    def __init__(self, total: int, what: str = "designs") -> None:
        self._log, self._lock, self._begun = _logger(), threading.Lock(), time.monotonic()
        self._next = self._begun + EVERY
        self._total, self._what, self._done = total, what, 0

    def add(self, more: int) -> None:
        """Add completed designs."""
        with self._lock:
            self._done += more
        self.come_to(lambda: self._done)

    def come_to(self, count: Callable[[], int]) -> None:
        """Count the completed designs if it is time to log."""
        now = time.monotonic()
        with self._lock:
            if self._log is None or now < self._next:
                return
            self._next = now + max(EVERY, FRACTION * (now - self._begun))
        if (done := count()) < self._total:
            self._log.info("%s: %d of %d", self._what, done, self._total)


def each(items: Iterable[T], total: int, what: str = "designs") -> Iterator[T]:
    """Iterate over items, of known number, and log progress."""
    tally = Tally(total, what)
    for item in items:
        yield item
        tally.add(1)


def chunks(count: int, at_once: int, what: str) -> Iterator[slice]:
    """Slices of at most `at_once` that cover `count`; progress of `what` is logged between them."""
    tally = Tally(count, what)
    for start in range(0, count, at_once):
        yield slice(start, start + at_once)
        tally.add(at_once)


@contextlib.contextmanager
def named(what: str) -> Iterator[None]:
    """Log that `what` is running if it takes longer than a second, and then its duration."""
    if (log := _logger()) is None:
        yield
        return
    begun = time.monotonic()
    timer = threading.Timer(EVERY, log.info, ("%s ...", what))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        if (took := time.monotonic() - begun) >= EVERY:
            log.info("%s: %.1f s", what, took)
