"""How long each question of a scene takes: times of random designs, which `slowflow explain` estimates from.

    python -m benchmarks.costs    writes src/slowflow/app/costs.py, in some ten minutes

A design is a mount of usual numbers from a fixed seed. Its time is that of the processor, which other programs on the
machine change least. What a time is counted by, as a frequency or a row of a spectrum, `Query.count` says.
"""

from __future__ import annotations

import random
import statistics
import tempfile
import time
import warnings
from collections.abc import Iterator
from pathlib import Path

from benchmarks.environment import processor
from slowflow.answers.table import SHOCKS
from slowflow.app.scenes import QUESTIONS, Query, Scene, read
from slowflow.sizing import tolerances
from slowflow.sizing.subject import Subject
from slowflow.sizing.tolerances import FEW_SAMPLES
from slowflow.support.errors import SlowflowError

#: designs of each kind; seconds after which no further design is asked
DESIGNS, SEED, PATIENCE = 15, 35, 6.0
WHERE = Path("src/slowflow/app/costs.py")
#: what a mount has besides, by kind
KINDS = {"plain": "", "laws": "eta = 0.02\nc_2 = 20.0", "load": "load = {load:.4f}"}
MOUNT = """[mount]
m = 12.0
k_v = 2500.0
k_h = {k_h:.1f}
L = 0.080
preload = {preload:.5f}
friction = {friction:.4f}
zeta = {zeta:.4f}
{more}
[ask]
F = [{F:.3f}]
f = [{f:.3f}]
questions = ["{question}"]
[tolerances]
k_h = 0.05
preload = 0.05
"""
SPECTRUM = "[spectrum]\nf = [{f:.3f}, 2.2, 5.0]\nF = [{F:.3f}, {F:.3f}, 2.0]\n"
SHOCK = "[shock]\nacceleration = [{a:.2f}]\nduration = [{duration:.4f}]\n"
PSD = '[psd]\nf = [1.0, 5.0, 100.0]\nG = [{G:.2e}, {G:.2e}, {G_end:.2e}]\nunit = "g^2/Hz"\n'
DOCUMENT = '''"""Seconds that questions take: of a plain oscillator, with more laws of damping, loaded.

Written by `python -m benchmarks.costs`; never edit. Medians of random mounts; nine of ten answers took between
1/SPREAD and SPREAD times as long.
"""

# fmt: off
from __future__ import annotations

from collections.abc import Mapping

MACHINE = "{processor}"
SPREAD = {spread}
COSTS: Mapping[str, tuple[float, float, float]] = {{
{rows}
}}
'''


def scene(question: str, kind: str, drawn: random.Random) -> Scene:
    """A scene with one question, about a mount that is drawn."""
    numbers = {
        "k_h": drawn.uniform(800, 3000),
        "preload": drawn.uniform(0.003, 0.012),
        "friction": drawn.choice((0.0, drawn.uniform(0.1, 0.8))),
        "zeta": drawn.uniform(0.01, 0.06),
        "F": drawn.uniform(2.0, 8.0),
        "f": drawn.uniform(1.5, 6.0),
        "load": 12.0 + drawn.uniform(-1.0, 1.0),
        "a": drawn.uniform(5, 40),
        "duration": drawn.uniform(0.005, 0.1),
        "G": 1e-4,
        "G_end": 2.5e-7,
    }
    more = KINDS[kind].format(**numbers)
    if question in (*SHOCKS, "random"):
        more = more.replace("eta = 0.02\n", "")  # which neither has
    text = (MOUNT + SPECTRUM + SHOCK + PSD).format(more=more, question=question, **numbers)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "scene.toml")
        path.write_text(text)
        return read(path)


def once(of: Scene, request: Query) -> float:
    """Seconds of one answer over what it is counted by; of tolerances design by design, those of a tenth of them."""
    begun = time.process_time()
    few = request.question == "tolerances" and Subject(of.oscillator, request.arguments["within"]).one_by_one
    if few:
        tolerances(of.oscillator, **request.arguments | {"samples": FEW_SAMPLES // 10})
    else:
        of.answer(request)
    return (time.process_time() - begun) * (10 if few else 1) / request.count()


def entries() -> Iterator[tuple[str, str, list[float]]]:
    """Entry, kind, and the times of designs."""
    for question in QUESTIONS:
        for kind in KINDS:
            drawn, times, begun = random.Random(SEED), {}, time.monotonic()
            for _ in range(DESIGNS):
                of = scene(question, kind, drawn)
                for request in of.queries:
                    try:
                        took = once(of, request)
                    except SlowflowError:
                        continue
                    times.setdefault(request.cost, []).append(took)
                if time.monotonic() - begun > PATIENCE:
                    break
            for entry, found in times.items():
                # the first has imports among it
                yield entry, kind, found[1:] or found


def main() -> None:
    """Write the times."""
    warnings.simplefilter("ignore")
    table: dict[str, dict[str, float]] = {}
    spreads = []
    for entry, kind, found in entries():
        middle = statistics.median(found)
        table.setdefault(entry, {})[kind] = middle
        spreads += [max(one / middle, middle / one) for one in found]
    # a question that a kind has no answer to costs nothing
    rows = [
        f'    "{entry}": ({", ".join(f"{kinds.get(kind, 0.0):.2g}" for kind in KINDS)}),'
        for entry, kinds in table.items()
    ]
    text = DOCUMENT.format(
        processor=processor(), spread=f"{statistics.quantiles(spreads, n=10)[-1]:.1f}", rows="\n".join(rows)
    )
    WHERE.write_text(text)


if __name__ == "__main__":
    main()
