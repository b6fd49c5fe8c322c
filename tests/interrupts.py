"""Ctrl-C: a program that prints "asked" and then takes minutes in, what it says when it is interrupted out."""

from __future__ import annotations

import signal
import subprocess
import sys
import time

# a runner in the background may have its children ignore interrupts
LISTENING = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
ENDING = "KeyboardInterrupt"


#: seconds within which an interrupt is promised to be heard, and within which an interpreter ends
HEARD, ENDS = 1.0, 1.0


def _stretched() -> float:
    """By how much longer than on a processor of its own anything takes here and now, where others work as well."""
    wall, own = time.perf_counter(), time.process_time()
    while time.process_time() - own < 0.1:
        pass
    return (time.perf_counter() - wall) / (time.process_time() - own)


def interrupted(program: str) -> str:
    """What it prints from 0.5 s after it has asked, and the end of its errors: no more than ENDING if it heard.

    Fails if that takes longer than is promised, on a machine that does nothing else.
    """
    before = _stretched()
    with subprocess.Popen(
        [sys.executable, "-c", LISTENING + program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        try:
            assert process.stdout.readline() == "asked\n"
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            sent = time.perf_counter()
            out, err = process.communicate(timeout=30)
            took = time.perf_counter() - sent
        finally:
            process.kill()
    allowed = 2 * (HEARD + ENDS) * max(before, _stretched())  # twice, as what others do varies
    assert took < allowed, f"heard after {took:.2f} s, allowed are {allowed:.2f} s"
    return out + err.rstrip()[-len(ENDING) :]
