"""Ctrl-C: a program that prints "asked" and then takes minutes in, what it says when it is interrupted out."""

from __future__ import annotations

import signal
import subprocess
import sys
import time

# a runner in the background may have its children ignore interrupts
LISTENING = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
ENDING = "KeyboardInterrupt"


def interrupted(program: str) -> str:
    """What it prints from 0.5 s after it has asked, and the end of its errors: no more than ENDING if it heard."""
    with subprocess.Popen(
        [sys.executable, "-c", LISTENING + program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        try:
            assert process.stdout.readline() == "asked\n"
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=30)
        finally:
            process.kill()
    return out + err.rstrip()[-len(ENDING) :]
