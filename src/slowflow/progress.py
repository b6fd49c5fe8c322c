"""Progress. Takes the parts of a work; returns every second a word on how far it is, where somebody wants to read it.

In a file or a pipe, where lines stay, it is one in ten seconds. Nobody reads it unless `shown`: a program that asks is
not talked into.

    from slowflow import Isolator, progress
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
from contextvars import ContextVar
from typing import TypeVar

T = TypeVar("T")

#: seconds after which something is said, and between two words; and the same where they are no terminal's
EVERY, EVERY_IN_A_FILE = 1.0, 10.0

_say: ContextVar[Callable[[str], None] | None] = ContextVar("who reads how far a work is", default=None)


def _to_stderr(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def _to_a_file() -> Callable[[str], None]:
    """Says to stderr what comes at least `EVERY_IN_A_FILE` seconds after it was made, and after the line before."""
    last, lock = time.monotonic(), threading.Lock()

    def say(text: str) -> None:
        nonlocal last
        with lock:
            if (now := time.monotonic()) - last < EVERY_IN_A_FILE:
                return
            last = now
        _to_stderr(text)

    return say


@contextlib.contextmanager
def shown(say: Callable[[str], None] | None = None) -> Iterator[None]:
    """Within it what takes longer than a second says how far it is: to stderr, or to `say`, a line at a time.

    Where stderr is no terminal, a line comes every ten seconds at most.
    """
    if say is None:
        say = _to_stderr if sys.stderr.isatty() else _to_a_file()
    token = _say.set(say)
    try:
        yield
    finally:
        _say.reset(token)


def chunks(count: int, at_once: int, what: str) -> Iterator[slice]:
    """Slices of at most `at_once` that make up `count`; between them, how much of `what` is done."""
    say, last = _say.get(), time.monotonic()
    for start in range(0, count, at_once):
        now = time.monotonic()
        if say is not None and now - last >= EVERY:
            last = now
            say(f"{what}: {100 * start // count} %")
        yield slice(start, start + at_once)


class Tally:
    """How many designs of so many are done; counted by any thread, and reported every second."""

    def __init__(self, total: int, what: str = "designs") -> None:
        # of who asks: a thread of a pool has no reader of its own
        self._say, self._last, self._lock = _say.get(), time.monotonic(), threading.Lock()
        self._total, self._what, self._done = total, what, 0

    def add(self, more: int) -> None:
        """So many more are done."""
        with self._lock:
            self._done += more
        self.come_to(lambda: self._done)

    def come_to(self, count: Callable[[], int]) -> None:
        """Count how many are done if it is time to report it."""
        now = time.monotonic()
        with self._lock:
            if self._say is None or now - self._last < EVERY:
                return
            self._last = now
        if (done := count()) < self._total:
            self._say(f"{self._what}: {done} of {self._total}")


def each(items: Iterable[T], total: int, what: str = "designs") -> Iterator[T]:
    """The items, so many in all; between them, how many are done."""
    tally = Tally(total, what)
    for item in items:
        yield item
        tally.add(1)


@contextlib.contextmanager
def named(what: str) -> Iterator[None]:
    """Says that `what` is being done if it takes longer than a second, and then how long it took."""
    say = _say.get()
    if say is None:
        yield
        return
    begun = time.monotonic()
    timer = threading.Timer(EVERY, say, (f"{what} ...",))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        if (took := time.monotonic() - begun) >= EVERY:
            say(f"{what}: {took:.1f} s")
