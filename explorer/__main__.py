"""`python -m explorer` writes docs/explorer.html; with --check it compares instead, and exits with 1 where they differ.

In:  explorer.c, the solvers' C and what is derived of the library, compiled to WebAssembly by `ziglang`; the records;
     the page's parts in this folder.
Out: one page that holds all of it and makes no network requests. It is the same whenever and wherever it is made,
     except for how zlib packs the WebAssembly.
"""

from __future__ import annotations

import argparse
import base64
import functools
import hashlib
import json
import re
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

from derivations import runtime
from derivations.asymmetric.sided import Sided
from derivations.library import stated
from explorer import one_end
from explorer.about import LIBRARY, about

HERE = Path(__file__).parent
ROOT = HERE.parent
PAGE = ROOT / "docs" / "explorer.html"
SOURCES = ("explorer/explorer.c", "explorer/random.c")
INCLUDED = [HERE, *(ROOT / name for name in ("src/slowflow/native", "src/slowflow/native/exact"))]
INCLUDED += [ROOT / "generated/c", ROOT / "generated/native"]
#: other compilers write other bytes
ZIG = "0.17.1"
#: as setup.py has them where they concern arithmetic: the same digits as every other build
FLAGS = ("-std=c11", "-O2", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off", "-g0", "-w")
LINKED = ("--target=wasm32-wasi", "-mexec-model=reactor", "-Wl,--strip-all")
#: most that the page may weigh, in bytes
MOST = 700_000


def sources() -> list[Path]:
    """All that the page is made of but for the package's data and what is derived: its files, what the library states,
    and the headers that explorer.c includes."""
    files = [path for path in sorted(HERE.iterdir()) if path.suffix in {".c", ".h", ".py", ".html", ".css", ".js"}]
    files += [ROOT / f"derivations/library/{name}.py" for _, name, *_ in LIBRARY]
    files.append(ROOT / "derivations/asymmetric/one_end.py")
    headers: set[Path] = set()
    left = [ROOT / name for name in SOURCES]
    while left:
        names = re.findall(r'#include "([^"]+)"', left.pop().read_text())
        found = {folder / name for name in names for folder in INCLUDED if (folder / name).exists()} - headers
        headers |= found
        left += found
    return sorted(headers - set(files)) + files


def digest() -> str:
    """Of the sources, so that a page can be told that was made from others."""
    of_all = hashlib.sha256()
    for path in sources():
        of_all.update(path.relative_to(ROOT).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return of_all.hexdigest()[:16]


def records(text: str) -> list[tuple[str, int]]:
    """Name and number of parameters of each mechanism in a generated table of records, in its order."""
    (table,) = re.findall(r"records\[\] = \{(.*?)\};", text, re.DOTALL)
    counts = dict(re.findall(r"IN_EVERY_RECORD\((\w+)\),.*?\.parameters = (\d+),", text, re.DOTALL))
    return [(name, int(counts[name])) for name in re.findall(r"&(\w+)_record", table)]


@functools.cache
def mechanisms() -> tuple[list[str], dict[str, str], dict[str, str]]:
    """What the page calls the mechanisms; C by the name of its file; likewise what that includes.

    The C is a header with records and restoring forces in that order, and a source for each mechanism of the library:
    in one the names of their statics would meet. Those whose force is not odd have theirs in the header.
    """
    of_package = records((ROOT / "generated/native/records.h").read_text())
    table = [(name, name, count, f"records + {i}") for i, (name, count) in enumerate(of_package)]
    header, sources, included = [], {}, {}
    on_one_side: list[tuple[str, str]] = []
    for _, name, *_ in LIBRARY:
        mechanism = stated(name)
        if isinstance(mechanism, Sided):
            on_one_side.append((name, one_end.text(name, mechanism)))
            continue
        derived = runtime.sources(mechanism)
        # the name of what is derived has a hash of the whole derivation, with the prose of its ledger
        printed = {
            file.replace(derived.module.name, name): text.replace(derived.module.name, name)
            for file, text in derived.compiled.items()
        }
        source = printed.pop(f"{name}.c")
        ((kernels, count),) = records(source)
        table.append((name, kernels, count, f"&{name}_of_library"))
        sources[f"{name}.c"] = f"#define slowflow_record {name}_of_library\n{source}"
        header += [f'#include "{kernels}.h"', f"extern const sf_mechanism *const {name}_of_library;"]
        included |= printed
    for name, kernels, count, _ in table:
        arguments = "".join(f", p[{i}]" for i in range(count))
        header.append(f"static double {name}_at(double u, const double *p) {{ return {kernels}_force(u{arguments}); }}")
        shipped = (folder / f"{kernels}.h" for folder in INCLUDED)
        kernel = included.get(f"{kernels}.h") or next(one.read_text() for one in shipped if one.exists())
        last = max(map(int, re.findall(rf"\b{kernels}_force_(\d+)_u\(", kernel)))
        pieces = [f"passed == {k - 1} ? {kernels}_force_{k}_u(u{arguments}) : " for k in range(1, last)]
        slope = f"{''.join(pieces)}{kernels}_force_{last}_u(u{arguments})"
        header.append(f"static double {name}_slope(double u, const double *p, int passed) {{ return {slope}; }}")
    for name, text in on_one_side:
        header.append(text)
        table.append((name, name, 0, f"&{name}_of_library"))
    for kind, column in {
        "char *const names[]": [f'"{name}"' for name, *_ in table],
        "sf_mechanism *const *const mechanisms[]": [record for *_, record in table],
    }.items():
        header.append(f"static const {kind} = {{{', '.join(column)}}};")
    functions = ["NULL"] * (len(table) - len(on_one_side)) + [f"{name}_place" for name, _ in on_one_side]
    header.append(f"static double (*const places_of[])(const double *) = {{{', '.join(functions)}}};")
    own = {name for name, _ in on_one_side}
    of_each = ", ".join(f"{name}_force" if name in own else f"{name}_at" for name, *_ in table)
    header.append(f"static double (*const forces[])(double, const double *) = {{{of_each}}};")
    # where the force is not odd nothing asks for its slope
    slopes = ", ".join("NULL" if name in own else f"{name}_slope" for name, *_ in table)
    header.append(f"static double (*const slopes[])(double, const double *, int) = {{{slopes}}};")
    return [name for name, *_ in table], sources, {**included, "mechanisms.h": "\n".join(header) + "\n"}


def compiled() -> bytes:
    """The solvers as WebAssembly."""
    version = subprocess.run(
        [sys.executable, "-m", "ziglang", "version"], capture_output=True, text=True
    ).stdout.strip()
    if version != ZIG:
        sys.exit(f"the explorer is compiled by ziglang {ZIG}, not {version or 'none'}: pip install ziglang=={ZIG}")
    with tempfile.TemporaryDirectory() as folder:
        _, sources, headers = mechanisms()
        for name, text in {**sources, **headers}.items():
            Path(folder, name).write_text(text)
        included = [f"-I{path.relative_to(ROOT)}" for path in INCLUDED]
        target = Path(folder, "solvers.wasm")
        inputs = [*SOURCES, *(str(Path(folder, name)) for name in sorted(sources))]
        command = [sys.executable, "-m", "ziglang", "cc", *FLAGS, *LINKED, *included, f"-I{folder}", *inputs]
        subprocess.run([*command, "-o", str(target)], cwd=ROOT, check=True)
        return target.read_bytes()


def page(wasm: bytes) -> str:
    """The whole page: its parts where page.html names them."""
    known = about()
    if set(known["mechanisms"]) != set(mechanisms()[0]):
        sys.exit("PRESETS in explorer/about.py has to have a design of every mechanism in generated/native/records.h")
    data = json.dumps({**known, "digest": digest()}, sort_keys=True, separators=(",", ":")).replace("</", "<\\/")
    made = {"wasm": base64.b64encode(zlib.compress(wasm, 9)).decode(), "data": data}

    def part(match: re.Match[str]) -> str:
        name = match[1]
        return made[name] if name in made else (HERE / name).read_text().strip()

    return re.sub(r"\{\{(\S+)\}\}", part, (HERE / "page.html").read_text())


def unpacked(text: str) -> tuple[str, bytes]:
    """A page without its WebAssembly, and that: implementations of zlib pack the same bytes differently."""
    before, packed, after = re.split(r'(?<=<script id="wasm" type="application/base64">)([^<]*)', text)
    return before + after, zlib.decompress(base64.b64decode(packed))


def main() -> int:
    """Write the page, or compare it."""
    parser = argparse.ArgumentParser(prog="python -m explorer", description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare with what is there, and write nothing")
    options = parser.parse_args()
    text = page(compiled())
    if len(text.encode()) > MOST:
        sys.exit(f"the page has {len(text.encode())} bytes, more than {MOST}")
    if options.check:
        same = PAGE.exists() and unpacked(PAGE.read_text()) == unpacked(text)
        print(f"{PAGE.relative_to(ROOT)} is {'the same' if same else 'another'}")
        return 0 if same else 1
    PAGE.write_text(text)
    print(f"{PAGE.relative_to(ROOT)}: {len(text.encode())} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
