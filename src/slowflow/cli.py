"""The command line: `slowflow info`, `paper` and `certify`. In go arguments, out come text and an exit code."""

from __future__ import annotations

import argparse
import importlib.metadata
import platform
import sys
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import slowflow
from slowflow import backend
from slowflow.isolator import ROD_SPRING
from slowflow_kernels.domains import DAMPING


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


def add_certify(commands: Any) -> None:
    """`slowflow certify 0.04 --zeta 0.03`: options are the isolator's numbers, by default those of Table 1."""
    certify = commands.add_parser(
        "certify",
        help="proofs at a forcing: all folds, F_SN, F_cr, each in an interval; exit code 1 where one is not proved",
        description="An isolator in interval arithmetic. Numbers that are not given are those of the paper's Table 1.",
    )
    certify.add_argument("F_0", type=float, help="forcing amplitude over k_v L")
    certify.add_argument("--Omega", type=float, help="a frequency, of which all states are wanted too")
    for domain in (*ROD_SPRING.design, *DAMPING):
        certify.add_argument(f"--{domain.name}", type=float, help=domain.doc)


def certify(given: argparse.Namespace) -> int:
    """Print a certificate; 0 if all of it is proved, 2 if a number is not allowed."""
    # here, not above: `slowflow info` needs none of it
    from slowflow.paper import example

    names = (domain.name for domain in (*ROD_SPRING.design, *DAMPING))
    changes = {name: value for name in names if (value := getattr(given, name)) is not None}
    try:
        isolator = example.isolator(**changes)
        found = isolator.certify(given.F_0, Omega=given.Omega)
    except ValueError as error:
        print(error, file=sys.stderr)
        return 2
    print(isolator)
    print(found)
    return 0 if found.proved else 1


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one subcommand; 0 if it succeeds."""
    parser = argparse.ArgumentParser(prog="slowflow", description="Slow flow of piecewise-smooth vibration isolators.")
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("info", help="the backend in use, versions, how the compiled code was built")
    paper = commands.add_parser("paper", help="Table 2 published / derived / verdict, the ledger's findings, Fig. 7")
    paper.add_argument("--out", type=Path, default=Path("output"), help="folder for the figures")
    add_certify(commands)
    given = parser.parse_args(arguments)
    if given.command == "certify":
        return certify(given)
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
