"""The command line: `slowflow info`, `slowflow paper`. In go arguments, out come text and an exit code."""

from __future__ import annotations

import argparse
import importlib.metadata
import platform
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

import slowflow
from slowflow import backend


def info() -> dict[str, str]:
    """What runs here, by topic: backend, versions, how the extensions were built, where they are."""
    lines = {
        "backend": backend.NAME,
        "slowflow": f"{slowflow.__version__}, {Path(slowflow.__file__).parent}",
        "python": f"{platform.python_version()} ({platform.python_implementation()})",
        **{package: importlib.metadata.version(package) for package in ("numpy", "scipy")},
        "machine": f"{platform.system()} {platform.machine()}",
    }
    for what, module in (("kernels", backend.KERNELS), ("solvers", backend.SOLVER)):
        if module is None:
            lines[what] = "NumPy"
        else:
            build = module.BUILD
            lines[what] = f"{build['compiler']}, {build['abi']}, {module.__file__}"
            lines[f"{what} run"] = f"{build['chosen']}; built for {build['builds'].replace('arch=', '')}"
            lines["processor"] = build["processor"]
    return lines


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one subcommand; 0 if it succeeds."""
    parser = argparse.ArgumentParser(prog="slowflow", description="Slow flow of piecewise-smooth vibration isolators.")
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("info", help="the backend in use, versions, how the compiled code was built")
    paper = commands.add_parser("paper", help="Table 2 published / derived / verdict, the ledger's findings, Fig. 7")
    paper.add_argument("--out", type=Path, default=Path("output"), help="folder for the figures")
    given = parser.parse_args(arguments)
    if given.command == "info":
        for topic, text in info().items():
            print(f"{topic:14}{text}")
    else:
        # here, not above: `slowflow info` needs none of it
        from slowflow.paper.report import draw, read_ledger, report

        for line in report(read_ledger()):
            print(line)
        if find_spec("matplotlib") is None:
            print("Figures: not drawn, since matplotlib is not installed: pip install 'slowflow[plot]'")
        else:
            print("Figures:", *draw(given.out))
    return 0
