"""The command line: scenes and proofs. Takes arguments; returns text, files and an exit code (`main`)."""

from __future__ import annotations

import argparse
import contextlib
import importlib.metadata
import os
import platform
import runpy
import sys
import traceback
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import slowflow
from slowflow.answers import files
from slowflow.answers.answer import Answer, in_text
from slowflow.app import costs, verdict
from slowflow.app.query import QUESTIONS, Query
from slowflow.app.scenes import Scene, read
from slowflow.core import backend
from slowflow.oscillators.isolator import ROD_SPRING
from slowflow.support import progress
from slowflow.support.errors import SlowflowError
from slowflow_kernels.domains import DAMPING

#: the exit code of a program that writes to a pipe that nobody reads any more: 128 and the number of that signal
NOBODY_READS = 141

#: the exit code where all was answered and a requirement is not met
NOT_MET = 3
#: seconds below which no estimate is told
SHORT = 0.01
#: numbers of an isolator, which are options of `certify`
OF_ISOLATOR = (*ROD_SPRING.design, *DAMPING)


def info() -> dict[str, str]:
    """What runs here, by topic: versions, how the extensions were built, where they are."""
    lines = {
        "slowflow": f"{slowflow.__version__}, {Path(slowflow.__file__).parent}",
        "python": f"{platform.python_version()} ({platform.python_implementation()})",
        **{package: importlib.metadata.version(package) for package in ("numpy", "scipy")},
        "machine": f"{platform.system()} {platform.machine()}",
    }
    for what, module in (("kernels", backend.KERNELS), ("solvers", backend.SOLVER)):
        build = module.BUILD
        lines[what] = f"{build['compiler']}, {build['abi']}, {module.__file__}"
        lines[f"{what} run"] = f"{build['chosen']}; built for {build['builds'].replace('arch=', '')}"
        lines["processor"] = build["processor"]
    return lines


def certify(args: argparse.Namespace) -> int:
    """Print a certificate; 0 if all of it is proved, 2 if a number is not allowed."""
    # here, not above: `slowflow info` needs none of it
    from slowflow import example

    changes = {one.name: value for one in OF_ISOLATOR if (value := getattr(args, one.name)) is not None}
    try:
        isolator = example.isolator(**changes)
        found = isolator.certify(args.F_0, Omega=args.Omega)
    except SlowflowError as error:
        print(error, file=sys.stderr)
        return 2
    print(isolator)
    print(found)
    return 0 if found.proved else 1


def _progress(quiet: bool) -> contextlib.AbstractContextManager[None]:
    """Within it progress is shown, unless nothing is to be."""
    return contextlib.nullcontext() if quiet else progress.shown()


def run_scene(args: argparse.Namespace) -> int:
    """Compute the results that an input file requests.

    Exit code 1 if a question has no answer, 3 if all have one and a requirement is not met.
    """
    # before anything is computed: these refuse
    if args.report is not None:
        files.check_target(args.report, args.scene)
        if not _can_draw():
            return 2
    scene = _read(args.scene)
    earlier = [] if args.out is None else files.written(args.out, [f"{question}.csv" for question in QUESTIONS])
    answers: list[tuple[Query, Answer]] = []
    failed = []
    with _progress(args.quiet):
        for query in scene.queries:
            try:
                with progress.named(str(query)):
                    answers.append((query, scene.answer(query)))
            except SlowflowError as error:
                failed.append({"question": query.question, **query.arguments, "error": str(error)})
                print(f"{query}: {error}", file=sys.stderr)
        outcome = verdict.verdict(scene) if scene.requirements else None
    content = {**provenance(scene), "answers": [query.content(answer) for query, answer in answers], "failed": failed}
    if outcome is not None:
        content["verdict"] = outcome.to_dict()
    if args.json:
        print(files.in_json(content), end="")
    if args.out is None and not args.json:
        if outcome is not None:
            print(f"# {verdict.in_words(outcome)}", *in_text(outcome), "", sep="\n")
        if scene.frame:
            print(f"# {scene.frame}", "", sep="\n")
        for query, answer in answers:
            print(f"# {query}", *in_text(answer), "", sep="\n")
    if args.out is not None:
        args.out.mkdir(parents=True, exist_ok=True)
        tables = {}
        for question in dict.fromkeys(query.question for query, _ in answers):
            same = [(query.numbers(), answer) for query, answer in answers if query.question == question]
            units = next(query.units() for query, _ in answers)
            tables[f"{question}.csv"] = files.in_csv(same, units)
        for path in earlier:
            if path.name not in tables:
                path.unlink()
        for name, text in tables.items():
            files.write(args.out / name, text)
        content["files"] = {name: files.digest(text.encode()) for name, text in tables.items()}
        files.write(args.out / files.RECORD, files.in_json(content))
        if not args.quiet:
            if outcome is not None:
                print(verdict.in_words(outcome), file=sys.stderr)
            print(f"{len(answers)} answers are written to the folder {args.out}", file=sys.stderr)
    made = 0 if args.report is None else _report(scene, args.report, args.quiet)
    return made or (1 if failed else 0 if outcome is None or outcome.all_met else NOT_MET)


def meet_scene(args: argparse.Namespace) -> int:
    """Find the nearest design that meets the requirements of an input file, within the ranges of [free].

    Exit code 3 if no design meets them: the one with the smallest violation is returned.
    """
    scene = _read(args.scene)
    if args.out is not None:
        files.check_target(args.out, args.scene)
    with _progress(args.quiet):
        found, changed = verdict.meet(scene)
        outcome = verdict.verdict(changed)
    text = "" if args.out is None else scene.with_numbers(found.numbers, args.out.parent)
    if args.json:
        content = {**provenance(scene), "design": found.to_dict(), "verdict": outcome.to_dict()}
        print(files.in_json(content), end="")
    else:
        print("# design", *in_text(found), "", f"# {verdict.in_words(outcome)}", *in_text(outcome), sep="\n")
    if args.out is not None:
        files.write(args.out, text)
        if not args.quiet:
            print(f"wrote {args.out}; now run: slowflow run {args.out}", file=sys.stderr)
    return 0 if outcome.all_met else NOT_MET


def provenance(scene: Scene) -> dict[str, Any]:
    """What answers were made from and by."""
    known = info()
    made = {name: known[name] for name in ("python", "numpy", "scipy", "machine")}
    return {
        "made_by": {"slowflow": slowflow.__version__, **made},
        "scene": {"file": scene.path.name, "sha256": scene.sha256, "content": dict(scene.content)},
        "oscillator": repr(scene.oscillator),
        "warnings": list(scene.warnings),
    }


def check_scenes(args: argparse.Namespace) -> int:
    """Say what scenes ask for, what is wrong in them and what is refused; 2 where something is."""
    wrong = False
    for path in args.scene:
        try:
            scene = _read(path)
        except (OSError, SlowflowError) as error:
            print(error, file=sys.stderr)
            wrong = True
        else:
            required = [one.name for one in scene.requirements]
            more = f"; to meet: {', '.join(required)}" if required else ""
            more += f"; free: {', '.join(scene.free)}" if scene.free else ""
            print(f"{path}: {scene.oscillator}; to answer: {', '.join(map(str, scene.queries))}{more}")
            for what, why in verdict.refusals(scene):
                print(f"{path}: {what}: {why}", file=sys.stderr)
                wrong = True
    return 2 if wrong else 0


def explain_scene(args: argparse.Namespace) -> int:
    """Print the plan of each question, and an estimate of how long it takes, from measured times; computes nothing."""
    scene = _read(args.scene)
    print(scene.oscillator)
    total, refused = 0.0, dict(verdict.refusals(scene))
    for query in scene.queries:
        print(query)
        if why := refused.get(str(query)):
            print(f"  {'refused':14}{why}")
            continue
        plan = scene.explain(query)
        total += (seconds := scene.seconds(query))
        print(*(f"  {step}" for step in (plan.steps if plan else ())), f"  {'takes':14}{_some(seconds)}", sep="\n")
    print(
        f"in total {_some(total)}: estimates from medians of random mounts on {costs.MACHINE}; nine of ten were "
        f"within a factor of {costs.SPREAD:g}"
    )
    if scene.requirements:
        print(f"then the requirements: {', '.join(one.name for one in scene.requirements)}")
    if scene.free:
        print(f"free, for slowflow meet: {', '.join(scene.free)}")
    skipped = [question for question in QUESTIONS if not scene.of(question)]
    print(f"not requested, not computed: {', '.join(skipped)}" if skipped else "all questions are requested")
    return 0


def _some(seconds: float) -> str:
    """A time with the one digit that an estimate has."""
    return f"about {float(f'{seconds:.1g}'):g} s" if seconds >= SHORT else f"below {SHORT:g} s"


def derive_mechanisms(args: argparse.Namespace) -> int:
    """Write kernels, C, document and manifest of each mechanism that a Python program derives, or of the library's."""
    # here, not above: it opens the door to the derivation
    from slowflow.derive import Derived, library

    program = args.program
    try:
        kept = list(runpy.run_path(str(program)).values()) if program.is_file() else [library(str(program))]
    except Exception as error:  # the user's program may raise anything
        lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(program)]
        where = f"{program}, line {lines[-1]}" if lines else program
        missing = "" if program.is_file() else "there is no such file; "
        print(f"{where}: {missing}{type(error).__name__}: {error}", file=sys.stderr)
        return 2
    found = [value for value in kept if isinstance(value, Derived)]
    if not found:
        print(
            f"{program} defines no mechanism: assign the result of slowflow.derive.mechanism to a name", file=sys.stderr
        )
        return 2
    for mechanism in dict.fromkeys(found):
        folder = args.out / mechanism.stated_name
        print(f"{folder}: {', '.join(mechanism.write(folder))}")
    return 0


def print_schema(args: argparse.Namespace) -> int:
    """Print what a scene may have, as JSON schema: editors complete a scene by it."""
    from slowflow.app import schema

    print(files.in_json(schema.scene_file()), end="")
    return 0


def serve(args: argparse.Namespace) -> int:
    """Answer a client of the Model Context Protocol, on standard input and output."""
    if find_spec("mcp") is None:
        print("this needs the SDK of the protocol: pip install 'slowflow[mcp]'", file=sys.stderr)
        return 2
    from slowflow.app import tools

    tools.serve()
    return 0


def new_scene(args: argparse.Namespace) -> int:
    """Write the starter, or a scene of a measured loop; 2 where there is a file of that name."""
    if (args.loop is None) != (args.mass is None):
        print(
            "--from loop.csv and --mass '12 kg' must be used together: a loop does not contain the mass",
            file=sys.stderr,
        )
        return 2
    # here, not above: no other command needs it
    from slowflow.app import starters

    text = starters.STARTER if args.loop is None else starters.of_loop(args.loop, args.mass)
    try:
        with args.scene.open("x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:
        print(f"{args.scene} already exists: it is not changed", file=sys.stderr)
        return 2
    print(f"wrote {args.scene}; now run: slowflow run {args.scene}")
    return 0


def _quantity(text: str) -> float | str:
    """A number, or one with a unit, which is read where it is used."""
    try:
        return float(text)
    except ValueError:
        return text


def write_report(args: argparse.Namespace) -> int:
    """Write the report of a scene; 2 where it cannot be made."""
    files.check_target(args.out, args.scene)
    if not _can_draw():
        return 2
    return _report(_read(args.scene), args.out, args.quiet)


def _can_draw() -> bool:
    """Whether there is what a report draws with; says so where there is not."""
    found = find_spec("matplotlib") is not None
    if not found:
        print("a report needs matplotlib: pip install 'slowflow[plot]'", file=sys.stderr)
    return found


def _report(scene: Scene, out: Path, quiet: bool) -> int:
    """Write the report of a scene, from the answers that it has and others; 2 where it cannot be made."""
    # here, not above: it imports Matplotlib
    from slowflow.app import report

    try:
        with _progress(quiet), progress.named(f"report of {scene.path}"):
            page = report.html(scene)
    except SlowflowError as error:
        print(error, file=sys.stderr)
        return 2
    files.write(out, page)
    if not quiet:
        print(f"{out} is written", file=sys.stderr)
    return 0


def _read(path: Path) -> Scene:
    scene = read(path)
    for text in scene.warnings:
        print(f"{path}: {text}", file=sys.stderr)
    return scene


def parser() -> argparse.ArgumentParser:
    """Of the subcommands, each with its options and the function that runs it."""
    whole = argparse.ArgumentParser(
        prog="slowflow",
        description="Jumps, detachment, response curves and transmissibility of nonlinear vibration isolators.",
        epilog="Exit codes: 0 success; 1 a question without an answer, or a proof that was not found; 2 invalid "
        "arguments or input file; 3 a requirement that is not met; 130 interrupted; 141 output closed by its reader.",
    )
    whole.add_argument("--version", action="version", version=f"slowflow {slowflow.__version__}")
    commands = whole.add_subparsers(dest="command", required=True)

    def command(run: Callable[[argparse.Namespace], int], name: str, help: str, description: str | None = None) -> Any:
        one = commands.add_parser(name, help=help, description=description)
        one.set_defaults(run=run)
        return one.add_argument

    quiet = {"action": "store_true", "help": "suppress progress output"}
    command(print_info, "info", "print versions, and how the compiled code was built")
    option = command(
        certify,
        "certify",
        "prove all folds at a force amplitude, F_SN and F_cr, each in an interval; exit code 1 if one is not proved",
        "Proofs for an isolator in interval arithmetic. Omitted parameters are those of Table 1 of the paper.",
    )
    option("F_0", type=float, help="forcing amplitude over k_v L")
    option("--Omega", type=float, help="frequency at which all states are proved too, over sqrt(k_v/m)")
    for domain in OF_ISOLATOR:
        option(f"--{domain.name}", type=float, help=domain.doc)
    option = command(run_scene, "run", "compute the answers of an input file", run_scene.__doc__)
    option("scene", type=Path, help="TOML file; `slowflow new` writes an example")
    option("-o", "--out", type=Path, metavar="DIR", help="write CSV and JSON there instead of printing")
    option("--json", action="store_true", help="print JSON")
    option("--report", type=Path, metavar="FILE", help="write the report too, from the same answers, as an HTML page")
    option("--quiet", **quiet)
    option = command(
        meet_scene, "meet", "find the nearest design that meets the requirements of an input file", meet_scene.__doc__
    )
    option("scene", type=Path, help="TOML file with [require] and [free]")
    option("-o", "--out", type=Path, metavar="FILE", help="write the input file with that design")
    option("--json", action="store_true", help="print JSON")
    option("--quiet", **quiet)
    option = command(check_scenes, "check", "check an input file; computes nothing")
    option("scene", type=Path, nargs="+")
    text = "list what runs for an input file, what is skipped, and the estimated time; computes nothing"
    command(explain_scene, "explain", text)("scene", type=Path)
    option = command(write_report, "report", "write results, curves and errors on one HTML page")
    option("scene", type=Path)
    option("-o", "--out", type=Path, metavar="FILE", default=Path("report.html"), help="default: %(default)s")
    option("--quiet", **quiet)
    option = command(new_scene, "new", "write a commented input file as a starting point")
    option("scene", type=Path, nargs="?", default=Path("scene.toml"), help="default: %(default)s")
    option(
        "--from",
        type=Path,
        dest="loop",
        metavar="CSV",
        help="CSV file of a measured force-displacement loop: columns x, F, optionally t",
    )
    option("--mass", type=_quantity, metavar="M", help="mass on the spring, in kg or with a unit, such as '12 kg'")
    command(print_schema, "schema", "print the JSON schema of input files, for completion in editors")
    command(serve, "mcp", "serve the questions as tools of the Model Context Protocol, on standard input and output")
    option = command(
        derive_mechanisms, "derive", "write kernels, C and derivation of the mechanisms that a Python program defines"
    )
    option(
        "program",
        type=Path,
        help="a Python file that derives mechanisms, which is run; or the name of one in the library",
    )
    option("-o", "--out", type=Path, metavar="DIR", default=Path("derived"), help="default: %(default)s")
    return whole


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one subcommand: 0 if it succeeds, 1 if something is not answered or not proved, 2 for what is not allowed."""
    args = parser().parse_args(arguments)
    try:
        code: int = args.run(args)
        sys.stdout.flush()
        return code
    except BrokenPipeError:
        _say_no_more()
        return NOBODY_READS
    except OSError as error:
        print(f"{error.filename}: {error.strerror}" if error.filename and error.strerror else error, file=sys.stderr)
        return 2
    except SlowflowError as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


def _say_no_more() -> None:
    """What is still to be written goes nowhere: Python writes it when it ends, and would complain."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError):
            stream.flush()
        with contextlib.suppress(OSError, ValueError):
            os.dup2(nowhere, stream.fileno())


def print_info(args: argparse.Namespace) -> int:
    """Print `info`."""
    for topic, text in info().items():
        print(f"{topic:14}{text}")
    return 0
