"""Table 2, published and derived, with verdicts, and Fig. 7; with --figures all figures and their parameters."""

from __future__ import annotations

import argparse
from pathlib import Path

from examples.paper.figures import FIGURES, UNDATED, draw
from examples.paper.report import report
from slowflow.answers.quantities import UNITS, si
from slowflow.app.report import read_ledger
from slowflow.support import progress


def main() -> None:
    """Print and draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--out", type=Path, default=Path("output"), help="folder for the figures")
    parser.add_argument("--figures", action="store_true", help="draw Figs. 1b to 7b, all of them")
    parser.add_argument("--format", choices=UNDATED, action="append", help="default: png and svg; may be repeated")
    parser.add_argument("--width", default="7.2 in", help="with its unit, such as '84 mm', a column of a journal")
    parser.add_argument("--style", action="append", default=[], help="style sheet of Matplotlib, a name or a file")
    options = parser.parse_args()
    if not options.figures:
        for line in report(read_ledger()):
            print(line)
    with progress.shown():
        names = tuple(FIGURES) if options.figures else ("7a", "7b")
        width = float(si("L", options.width, "m") / UNITS["length"]["in"])
        print("Figures:", *draw(options.out, names, options.format or ("png", "svg"), width=width, style=options.style))
    for name, figure in FIGURES.items() if options.figures else ():
        print(f"Fig. {name}: {figure.caption}{f'; chosen here: {figure.chosen}' if figure.chosen else ''}")


if __name__ == "__main__":
    main()
