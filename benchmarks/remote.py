"""How everything here is timed: calls in turn, `medians`; jobs in processes of their own, `Remote` and `in_turn`.

`python -m benchmarks.remote <module>` answers a `Remote` in lines of JSON. The module has `prepare()`, which gives jobs
by name: pairs of a function that is timed and one that makes of its answer a dictionary for JSON. A request names a
job; the reply adds `seconds`, the median of its calls, by the processor's clock or by what `clock(job)` of the module
gives. The process may be another interpreter with another environment: nothing but the standard library is imported
here.
"""

from __future__ import annotations

import importlib
import json
import os
import queue
import statistics
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
#: a fast job is repeated within one request for this long, in seconds
WHILE = 0.05
#: the longest that an answer may take, in seconds
PATIENCE = 180


class Failure(Exception):
    """What a process said instead of an answer."""


class Remote:
    """Jobs of one module in one process; see above. Raises Failure where there is no answer."""

    def __init__(self, module: str, python: str = sys.executable, **settings: str) -> None:
        # measured on one core: threads of a linear algebra library would only disturb each other on small matrices
        threads = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        self._process = subprocess.Popen(
            [python, "-m", "benchmarks.remote", module],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            cwd=ROOT,
            env={**os.environ, "PYTHONPATH": str(ROOT), **threads, **settings},
        )
        self._answers: queue.Queue[str] = queue.Queue()
        threading.Thread(target=self._read, daemon=True).start()
        self.jobs: list[str] = self._answer()["jobs"]

    def ask(self, job: str) -> dict[str, Any]:
        """The job's answer, and `seconds`."""
        if self._process.stdin.closed:  # one of its jobs took too long
            raise Failure("its process was ended")
        self._process.stdin.write(json.dumps(job) + "\n")
        self._process.stdin.flush()
        return self._answer()

    def stop(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.wait()
        self._process.stdin.close()

    def _read(self) -> None:
        with self._process.stdout as lines:
            for line in lines:
                self._answers.put(line)
        self._answers.put("")

    def _answer(self) -> dict[str, Any]:
        try:
            line = self._answers.get(timeout=PATIENCE)
        except queue.Empty:
            self.stop()
            raise Failure(f"no answer within {PATIENCE} s") from None
        if not line:
            raise Failure("its process ended without an answer")
        answer: dict[str, Any] = json.loads(line)
        if "error" in answer:
            raise Failure(answer["error"])
        return answer


def in_turn(jobs: dict[str, tuple[Remote, str]], rounds: int) -> tuple[dict[str, dict[str, Any]], dict[str, str]]:
    """Every job in every round: last answers with the median of `seconds`, and failures, by the keys of `jobs`.

    And with the `least` of all calls: where others use the machine too a clock on the wall says more, never less.
    """
    answers: dict[str, dict[str, Any]] = {}
    seconds: dict[str, list[float]] = {key: [] for key in jobs}
    least: dict[str, list[float]] = {key: [] for key in jobs}
    failures: dict[str, str] = {}
    for _ in range(rounds):
        for key, (remote, job) in jobs.items():
            if key in failures:
                continue
            try:
                answers[key] = remote.ask(job)
            except (Failure, OSError) as failure:
                failures[key] = str(failure)
                continue
            seconds[key].append(answers[key]["seconds"])
            least[key].append(answers[key]["least"])
    done = {
        key: {**answer, "seconds": statistics.median(seconds[key]), "least": min(least[key])}
        for key, answer in answers.items()
        if key not in failures
    }
    return done, failures


def processor() -> float:
    """Seconds of processor time, of this process and of those that it waited for: other work does not count."""
    try:
        import resource  # not everywhere
    except ImportError:
        return time.process_time()
    both = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(used.ru_utime + used.ru_stime for used in both)


def medians(calls: dict[str, Callable[[], Any]], rounds: int) -> dict[str, float]:
    """Median processor seconds of each call; every round runs all, each after a call that warms the caches for it."""
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(rounds):
        for name, call in calls.items():
            call()
            start = processor()
            call()
            seconds[name].append(processor() - start)
    return {name: statistics.median(times) for name, times in seconds.items()}


def fresh(code: str, **settings: str) -> Any:
    """The JSON that a fresh interpreter prints; bytecode is kept, as it is by default and in an installed package."""
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"} | settings
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT, env=environment)
    return json.loads(done.stdout)


def timed(job: Callable[[], Any], clock: Callable[[], float]) -> tuple[list[float], Any]:
    """Seconds of calls after one that warms up, by a clock, and the answer."""
    answer = job()
    times: list[float] = []
    while sum(times) < WHILE:
        start = clock()
        job()
        times.append(clock() - start)
    return times, answer


def main() -> None:
    """Answer requests until the input ends."""
    # what a library prints must not be taken for an answer
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)

    def answer(**values: Any) -> None:
        print(json.dumps(values), file=answers, flush=True)

    try:
        module = importlib.import_module(sys.argv[1])
        jobs = module.prepare()
        clock = getattr(module, "clock", lambda _: processor)
        answer(jobs=list(jobs))
    except Exception as error:
        answer(error=f"{type(error).__name__}: {error}")
        return
    for line in sys.stdin:
        try:
            name = json.loads(line)
            run, describe = jobs[name]
            times, found = timed(run, clock(name))
            answer(**describe(found), seconds=statistics.median(times), least=min(times))
        except Exception as error:
            answer(error=f"{type(error).__name__}: {error}")


if __name__ == "__main__":
    main()
