"""docs/stability.md and its pictures: measured numbers in, files out. Every number on the page comes from them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable
from operator import itemgetter
from pathlib import Path
from typing import Any

import matplotlib as mpl

from benchmarks.document import Columns, columns_of, environment_lines, table
from benchmarks.stress import answers, counts, domains, kernels, proofs, roots

mpl.use("Agg")
import matplotlib.pyplot as plt

Rows = list[tuple[str, ...]]
Numbers = dict[str, Any]
GROUPS = {
    "slow flow": lambda module: module.startswith("slow_flow"),
    "rod_spring": lambda module: module.startswith("rod_spring") and "untruncated" not in module,
    "rod_spring_untruncated": lambda module: module.startswith("rod_spring_untruncated"),
    "the others": lambda module: not module.startswith(("slow_flow", "rod_spring")),
}
U = 2.0**-53
#: what is known of kernels that miss the target
WHY = {
    "rod_spring.F_A": "h and h_A have errors of 0.3 u (1 + κ) with κ = 20 and 21. In F_A these sensitivities cancel, "
    "so that F_A has only κ = 1.2. If h and h_A were rounded correctly, the error of F_A would be 0.74",
    "rod_spring.fold_quartic": "h and h_A have errors of 0.3 and 2.1 u (1 + κ) with κ = 5 and 7. In the coefficient "
    "h h_A their sensitivities have opposite signs, so that it has only κ = 1.3. If h and h_A were rounded correctly, "
    "its error would be 0.67",
    "rod_spring.saddle_node_onset": "the coefficient of A^20 is a sum of seven products of both signs, each rounded "
    "several times. The largest product is 11 times the sum, the sum of absolute values 24 times",
    "rod_spring_untruncated.F_A": "the sensitivities of h and h_A cancel, as for rod_spring. A longer search found 5.6",
    "rod_spring_untruncated.harmonics": "the fifth harmonic contains T_5 = 16 s^5 - 20 s^3 + 5 s, whose terms cancel",
    "rod_spring_untruncated.stability": "far above u_cr and at low frequencies the result is the product of two "
    "numbers near -1 that hardly depend on the arguments. So κ is near 0, but there are seven roundings of one u each",
}

HEAD = """# Rounding errors: worst cases found by search

This page has the largest rounding errors that a search found, for kernels, roots, results and counts. *Kernels* are the
functions from which results are computed, such as the averaged force h and the response F. `rod_spring` is the paper's
isolator, `duffing` the cubic spring.

Errors are given in units of u (1 + κ), where u = 2^-53 is the unit roundoff and κ the relative condition number with
respect to all arguments. Rounding each argument and the result once may cause an error of this size.

Each search starts from the worst of many random points and changes one coordinate at a time, by ulps and by factors,
while the error grows. The errors are therefore lower bounds of the true maxima. They are measured against exact values:
for kernels computed to at least 40 digits, for roots by FLINT, for results by Newton's method in 420 bits, and for
counts by proof.

`make stress` writes the page. `benchmarks/results/stability.json` has all numbers and the exact points, and
`tests/averaged/test_stability.py` checks that the errors at these points do not grow.
"""


def number(x: Any) -> str:
    """Three digits; JSON has words for what is not finite."""
    return x if isinstance(x, str) else f"{x:.3g}"


def value(x: Any) -> float:
    """As a number."""
    return float(x)


def where(names: Iterable[str], at: Iterable[float]) -> str:
    """A point in words."""
    return ", ".join(f"{name} {x:.4g}" for name, x in zip(names, at, strict=True))


def worst_of(row: Numbers) -> Numbers | None:
    """The worst point of a kernel or kind."""
    return max(row["worst"], key=lambda w: value(w["error"]), default=None)


def misses(row: Numbers, target: float) -> bool:
    """Whether the worst error is beyond the target."""
    worst = worst_of(row)
    return worst is not None and value(worst["error"]) > target


def at_worst(cell: Callable[[Numbers, Numbers], str]) -> Callable[[Numbers], str]:
    """What a cell shows of a row and its worst point; a dash where there is none."""
    return lambda row: "-" if (worst := worst_of(row)) is None else cell(row, worst)


def error(target: float = math.inf) -> Callable[[Numbers], str]:
    """The cell of the worst error, marked beyond the target."""
    return at_worst(lambda row, worst: number(worst["error"]) + " **missed**" * misses(row, target))


def counted(name: str) -> Callable[[Numbers], str]:
    """The cell of a number, or of how many there are in a list."""
    return lambda row: f"{row[name] if isinstance(row[name], int) else len(row[name]):,}"


def by_numpy(row: Numbers, worst: Numbers) -> str:
    """The error on NumPy at the worst point."""
    other = row["rows"][row["worst"].index(worst)]["errors"]["numpy"]
    return "-" if other is None else number(other)


condition = at_worst(lambda row, worst: number(worst["condition"]))
kernel_name: Callable[[Numbers], str] = lambda row: f"{row['module']}.{row['kernel']}"  # noqa: E731
question: Callable[[Numbers], str] = lambda row: f"{row['mechanism']}, {row['kind']}"  # noqa: E731
KERNELS: Columns = {
    "kernel": kernel_name,
    "points": counted("points"),
    "error / u(1+κ)": error(kernels.TARGET),
    "NumPy kernel": at_worst(by_numpy),
    "1 + κ": condition,
    "worst point": at_worst(lambda row, worst: where(row["names"], worst["at"])),
}
ROOTS: Columns = {
    "roots": itemgetter("kind"),
    "family": itemgetter("family"),
    "cases": counted("cases"),
    "wrong counts": counted("wrong"),
    "error / u(1+κ)": error(),
    "1 + κ": condition,
}
ANSWERS: Columns = {
    "force": itemgetter("mechanism"),
    "result": itemgetter("kind"),
    "cases": counted("answers"),
    "error / u(1+κ)": error(answers.TARGET),
    "1 + κ": condition,
    "no reference": counted("alone"),
}
COUNTS: Columns = {
    "force, number of": question,
    "cases": counted("cases"),
    "wrong": lambda row: f"{len(row['wrong'])} of {decided(row):,}",
    "wrong next to a level": lambda row: f"{row['wrong beside']:,} of {row['beside'] - row['said beside']:,}",
    "undecided": counted("said"),
    "repeated in balls": counted("balls"),
    "still undecided": counted("open"),
    "wrong in balls": counted("wrong by balls"),
    "refused": counted("refused"),
    "not proved": counted("unproved"),
}
SCALE: Columns = {
    "force, number of": question,
    "cases": counted("queries"),
    "wrong": counted("differ"),
    "undecided": counted("undecided"),
    "not proved": counted("unproved"),
    "refused": counted("refused"),
}


def by_group(found: list[Numbers]) -> Rows:
    """How many kernels of each group keep to the target."""
    rows = []
    for name, belongs in GROUPS.items():
        worst = sorted((value(w["error"]) for r in found if belongs(r["module"]) if (w := worst_of(r))), reverse=True)
        if worst:
            within = sum(e <= kernels.TARGET for e in worst)
            rows.append((name, str(len(worst)), str(within), number(worst[len(worst) // 2]), number(worst[0])))
    return rows


def merged(found: list[list[Numbers]]) -> list[Numbers]:
    """Answers of all shares by mechanism and kind."""
    table: dict[tuple[str, str], Numbers] = {}
    for row in itertools.chain(*found):
        key = row["mechanism"], row["kind"]
        if key not in table:
            table[key] = {**row, **{name: list(row[name]) for name in ("alone", "unjudged", "drawn", "worst")}}
        else:
            for name in ("answers", "alone", "unjudged", "drawn", "worst"):
                table[key][name] += row[name]
    return [table[key] for key in sorted(table)]


def totals(found: list[Numbers]) -> list[Numbers]:
    """Counts of all shares by kind and mechanism."""
    out: dict[tuple[str, str], Numbers] = {}
    for kind, row in itertools.product(("states", "folds"), found):
        mine, mechanism = row[kind], row["mechanism"]
        none: Numbers = {"wrong": [], "refused": [], **dict.fromkeys(counts.NUMBERS, 0)}
        named = {"mechanism": mechanism, "kind": kind, "names": row["names"]}
        total = out.setdefault((kind, mechanism), {**named, **none})
        for name in (*counts.NUMBERS, "wrong", "refused"):
            total[name] += mine[name]
    return list(out.values())


def decided(total: Numbers) -> int:
    """Cases that are no level to rounding and of which doubles say nothing."""
    return int(total["cases"] - total["beside"] - total["said"] + total["said beside"])


def scale_lines(found: list[Numbers]) -> list[str]:
    """Counts against proofs, and some of the cases that differ or that nothing proves."""
    return [
        "### Millions of cases against proofs in intervals",
        "",
        "This table compares numbers in double precision with proofs in interval arithmetic, over many decades of",
        "damping, with and without friction; some frequencies lie next to folds. *Wrong* counts numbers that differ",
        "from the proved ones and are not marked as undecided. For cases that are *not proved*, a sample in ball",
        "arithmetic agrees (`tests/averaged/test_undecided.py`).",
        "",
        *columns_of(SCALE, found),
        "",
    ]


def by_extreme(found: list[Numbers]) -> tuple[Rows, int, int]:
    """Kernels that lose something at extreme numbers, and how many were tried and kept all."""
    tried = [row for row in found if row["found"] is not None and row["found"]["points"]]
    lost = [row for row in tried if row["found"]["lost"]]
    rows = []
    for row in lost:
        mine, worst = row["found"], row["found"]["worst"]
        names = kernels.named().get((row["module"], row["kernel"]), [f"x{k}" for k in range(len(worst["at"]))])
        beyond = f"{mine['lost']} of {mine['points']}"
        rows.append((kernel_name(row), beyond, number(worst["error"]), where(names, worst["at"])))
    return rows, len(tried), len(tried) - len(lost)


# --- pictures ---------------------------------------------------------------------------------------------------------


def scatter(panels: dict[str, list[list[float]]], target: float) -> Any:
    """Relative error against 1 + kappa, with the envelopes u (1 + kappa) and the target's."""
    figure, axes = plt.subplots(1, len(panels), figsize=(3.6 * len(panels), 3.6), sharey=True, layout="constrained")
    for ax, (title, points) in zip(axes, panels.items(), strict=True):
        x = [condition for condition, error in points if error > 0]
        y = [max(condition * error * U, 1e-20) for condition, error in points if error > 0]
        ax.loglog(x, y, ".", ms=2.5, color="#30638e", alpha=0.5)
        ends = [1.0, max([*x, 10.0])]
        ax.loglog(ends, [U * end for end in ends], "k-", lw=1, label="u (1 + κ)")
        if target != 1:
            ax.loglog(ends, [target * U * end for end in ends], "k--", lw=0.8, label=f"{target:g} u (1 + κ)")
        ax.set(title=title, xlabel="1 + κ")
        ax.grid(alpha=0.2)
    axes[0].set_ylabel("relative error")
    axes[0].legend(loc="upper left", fontsize=8)
    return figure


def gathered(rows: Iterable[Numbers], key: Callable[[Numbers], str]) -> dict[str, list[list[float]]]:
    """Points drawn and worst by panel."""
    panels: dict[str, list[list[float]]] = {}
    for row in rows:
        points = panels.setdefault(key(row), [])
        points += row["drawn"]
        points += [[value(w["condition"]), value(w["error"])] for w in row["worst"] if not isinstance(w["error"], str)]
    return panels


def pictures(numbers: Numbers) -> dict[str, Any]:
    """By file name."""

    def group(row: Numbers) -> str:
        return next(name for name, belongs in GROUPS.items() if belongs(row["module"]))

    return {
        "stability_kernels": scatter(gathered(numbers["kernels"], group), kernels.TARGET),
        "stability_roots": scatter(gathered(numbers["roots"], lambda row: row["kind"]), roots.TARGET),
        "stability_answers": scatter(
            gathered(itertools.chain(*numbers["answers"]), lambda row: row["mechanism"]), answers.TARGET
        ),
    }


# --- the page ---------------------------------------------------------------------------------------------------------


def in_short(numbers: Numbers) -> list[str]:
    """Targets and what was measured."""
    found = [row for row in numbers["kernels"] if worst_of(row)]
    beyond = [row for row in found if misses(row, kernels.TARGET)]
    of_roots = [w for row in numbers["roots"] if (w := worst_of(row))]
    quartics = sum(row["cases"] for row in numbers["roots"])
    wrong_roots = sum(len(row["wrong"]) for row in numbers["roots"])
    of_answers = merged(numbers["answers"])
    missed = [row for row in of_answers if misses(row, answers.TARGET)]
    of_counts = totals(numbers["counts"])
    cases, marked, balls, open_, wrong_balls = (
        sum(t[name] for t in of_counts) for name in ("cases", "said", "balls", "open", "wrong by balls")
    )
    wrong = sum(len(t["wrong"]) + t["wrong beside"] for t in of_counts)
    many, differ, of_many, unproved = (
        sum(t[name] for t in numbers["counts against proofs"])
        for name in ("queries", "differ", "undecided", "unproved")
    )
    lines = [
        f"- **Kernels, target {kernels.TARGET:g} u (1 + κ)**: {len(found) - len(beyond)} of {len(found)} meet it; "
        + (f"{len(beyond)} miss it and are listed below." if beyond else "none misses it."),
        f"- **Roots in Omega, target {roots.TARGET:g} u (1 + κ)**: the largest error of {quartics:,} cases is "
        f"{number(max(value(w['error']) for w in of_roots))}; {wrong_roots} cases have a wrong number of roots.",
        f"- **Results, target {answers.TARGET:g} u (1 + κ)**: {len(of_answers) - len(missed)} of {len(of_answers)} "
        f"kinds meet it{'; the others are marked below' if missed else ''}.",
        f"- **Numbers of states and folds, target: none of 10^7 wrong**: {cases:,} cases have forces near or "
        f"between those at which the number changes. Of these, {wrong:,} are wrong and not marked; {marked:,} "
        f"({marked / cases:.1%}) are marked as undecided in double precision. Ball arithmetic was tried on {balls:,} "
        f"of the marked cases: {open_:,} stay undecided, {wrong_balls:,} are wrong. Of {many:,} further cases, "
        f"{differ:,} are wrong and not marked, {of_many:,} ({of_many / many:.1%}) are marked, and for {unproved:,} the "
        f"proof fails.",
        f"- **Proofs, target 99 % of folds in double precision, in at most twice the time**: "
        f"{fraction(numbers['proofs'][0], 'folds', 'alone')} are proved, in {numbers['proofs'][0]['ratio']:.2f} times "
        f"the time of `saddle_nodes` (median). With ball arithmetic, {balls_fraction(numbers['proofs'][0])}.",
    ]
    return lines


def page(numbers: Numbers) -> str:
    """The whole text."""
    extreme, tried, kept = by_extreme(numbers["extremes"])
    missed = [row for row in numbers["kernels"] if misses(row, kernels.TARGET)]
    of_answers = merged(numbers["answers"])
    lines = [
        HEAD,
        "Environment: " + "".join(environment_lines(numbers["environment"])),
        "",
        "## Summary",
        "",
        *in_short(numbers),
        "",
        "## Kernels",
        "",
        "![Errors of kernels against condition](stability_kernels.png)",
        "",
        *table(
            ("kernels", "number", "within the target", "median of the worst", "worst"), by_group(numbers["kernels"])
        ),
        "",
        "Kernels that miss the target:" if missed else "Every kernel meets the target.",
        "",
        *(columns_of(KERNELS, missed) if missed else []),
        "",
        *(f"- `{name}`: {WHY.get(name, 'the cause is not known')}." for name in map(kernel_name, missed)),
        "",
        "`benchmarks/stress/domains.py` has the bounds of the arguments. The search includes points of",
        f"{len(domains.LOCATIONS)} difficult kinds, for example an ulp from u_cr, on the backbone, at cusps and with",
        "vanishing damping. It does not include gradients with viscous damping and dry friction only.",
        "",
        "### At 1e±150 and subnormal numbers",
        "",
        f"Kernels were also tried with arguments of {', '.join(f'{x:.3g}' for x in domains.EXTREME)}. Of {tried}",
        f"kernels, {kept} keep their accuracy wherever the result is a normal double. In the others, an intermediate",
        "result overflows or loses digits by underflow:",
        "",
        *table(("kernel", "points beyond the target", "error / u(1+κ)", "worst point"), extreme),
        "",
        "### Proved bounds",
        "",
        "If a kernel is a polynomial, or a polynomial divided by a monomial, an error bound is proved for all",
        "arguments without overflow and underflow. The header of the generated function states it. Errors of other",
        "kernels are measured only.",
        "",
        "## Roots in Omega",
        "",
        "![Errors of roots against condition](stability_roots.png)",
        "",
        *(f"- *{kind}*: the {name}" for kind, name in roots.NAMES.items()),
        "",
        "For double and triple roots κ is infinite, and only the number of roots is compared. Cases are drawn at",
        "random: in the family *mild* of moderate size, in *decades* over several powers of ten, in *zeros* with m and",
        "zeta that may be 0, and in each other family near the case that its name states.",
        "",
        *columns_of(ROOTS, numbers["roots"]),
        "",
        "## Results",
        "",
        "![Errors of answers against condition](stability_answers.png)",
        "",
        "κ is the condition number with respect to parameters and force, plus that with respect to the kernels.",
        "The parameters have these ranges: ",
        ", ".join(f"{name} {low:g} to {high:g}" for name, (low, high) in answers.BOUNDS.items()) + ".",
        "",
        "*No reference* counts results for which Newton's method finds no exact solution within 1 %. Their F_0 is an",
        "ulp above 4 mu/pi, or they are peaks with zeta of 1e-9 or less, or results at the corner. A fold closer to",
        "u_cr than doubles resolve is returned at a double next to u_cr, where A may miss the target.",
        "",
        *columns_of(ANSWERS, of_answers),
        "",
        *refused_lines(numbers),
        *unjudged_lines(of_answers),
        "## Numbers of states and folds",
        "",
        "A *level* is a force at which the number of states or folds changes. The tested forces lie between levels and",
        f"at relative distances of an ulp to 0.1 from them: {counts.FORCINGS['states']} forces at each frequency for",
        f"states and {counts.FORCINGS['folds']} for each oscillator for folds, with zeta from 1e-4 to 0.5.",
        "",
        f"*Next to a level* means within {counts.UNDECIDED:g} u (1 + κ) of it, where rounding the arguments once may",
        "shift the level past the force. Numbers that are marked as undecided do not count as *wrong*; of these",
        f"*undecided* ones, {counts.ASKED_OF_BALLS:.0%}, drawn at random, were repeated in ball arithmetic.",
        "*Refused* counts cases for which the solver raises an error instead.",
        "",
        *columns_of(COUNTS, totals(numbers["counts"])),
        "",
        *wrong_lines(numbers),
        *scale_lines(numbers["counts against proofs"]),
        "## Proofs at run time",
        "",
        *proof_lines(numbers["proofs"][0]),
    ]
    return "\n".join(lines)


def refused_lines(numbers: Numbers) -> list[str]:
    """Refusals, by mechanism and kind of message."""
    refused: dict[tuple[str, str], list[Any]] = {}
    for group in numbers["answers"]:
        for row in group[:1]:
            for message, at in row["failed"]:
                plain = message.split(" at ")[0]
                refused.setdefault((row["mechanism"], plain), []).append(where(row["names"], at) if at else "its onset")
    if not refused:
        return []
    rows = [(mechanism, message, str(len(all_)), all_[0]) for (mechanism, message), all_ in refused.items()]
    return ["Refused:", "", *table(("force", "message", "times", "for example"), rows), ""]


def unjudged_lines(found: list[Numbers]) -> list[str]:
    """Answers of which the exact solution's condition could not be had: nothing is known of these."""
    rows = [
        (row["mechanism"], row["kind"], message, where(row["names"], at))
        for row in found
        for message, at in row["unjudged"]
    ]
    if not rows:
        return []
    return ["Results without a reference value:", "", *table(("force", "answer", "why", "where"), rows), ""]


def wrong_lines(numbers: Numbers) -> list[str]:
    """The wrong counts, if any: how many, and some of each question, the farthest from a level first."""
    head = ("question", "found", "proved", "distance / u(1+κ)", "relative", "Omega of the level", "where")
    wrong, rows = 0, []
    for total in totals(numbers["counts"]):
        wrong += len(total["wrong"])
        for at, got, proved, *distances in sorted(total["wrong"], key=lambda w: -w[3])[:5]:
            there = where(total["names"], [value(x) for x in at]).removesuffix(", Omega nan")
            rows.append((question(total), str(got), str(proved), *map(number, distances), there))
    if not rows:
        return []
    return [f"{wrong} wrong in all; the farthest from a level first:", "", *table(head, rows), ""]


def fraction(numbers: Numbers, what: str, proved: str = "proved") -> str:
    """How much of it is proved, or by doubles alone."""
    known, total = numbers[proved][what], numbers["queries"][what]
    return f"{known:,} of {total:,} ({known / total:.1%})"


def balls_fraction(numbers: Numbers) -> str:
    """How much is proved of all questions of the families that are hard."""
    total, proved = (
        sum(sum(found[name].values()) for found in numbers["families"].values()) for name in ("queries", "proved")
    )
    return f"{proved:,} of {total:,} hard cases are proved"


def proof_lines(numbers: Numbers) -> list[str]:
    """What `certify` proves of random isolators, and what it does not."""
    drawn = ", ".join(f"{name} 10^{low:g} to 10^{high:g}" for name, (low, high) in proofs.DRAWN.items())
    families = {"as above": numbers, **numbers["families"]}
    by_family = [
        (
            name,
            *(f"{found['alone'][what]:,} of {found['queries'][what]:,}" for what in proofs.QUESTIONS),
            f"{sum(found['proved'][what] for what in proofs.QUESTIONS):,} of {sum(found['queries'].values()):,}",
        )
        for name, found in families.items()
    ]
    by_distance = [
        (name, f"{by_doubles:,} of {tried:,}", f"{proved:,}")
        for name, (tried, proved, by_doubles) in numbers["beside"].items()
    ]
    unproved = [row for found in families.values() for row in found["unproved"]]
    slowest = max(found["slowest"] for found in numbers["families"].values())
    lines = [
        f"`Isolator.certify` was tried on {numbers['isolators']:,} random isolators, first in interval arithmetic.",
        "Cases left undecided were repeated in ball arithmetic of 128 or 512 bits by python-flint, which takes",
        f"{slowest:.2g} s at most. The enclosures of A have a median relative width of {numbers['width']:.2g}, at most",
        f"{numbers['widest']:.2g}. The proof of Table 2 takes {1e3 * numbers['table_2']:.2g} ms.",
        "",
        f"The isolators have 1 to {proofs.MOST_SPRINGS} springs, {drawn}, where *excess* is F_0/(4 mu/pi) - 1.",
        "In each of four families of hard cases one parameter is extreme: delta_h up to 1 - 10^-16, delta_h down to",
        "10^-12, alpha down to 10^-16, excess from 10^-16 to 10^-6. A fifth family has the untruncated force.",
        "",
        *table(("isolators", *(f"{what}, by intervals" for what in proofs.QUESTIONS), "all, with balls"), by_family),
        "",
        "Folds near F_SN, where two of them coincide within rounding:",
        "",
        *table(("relative distance of F_0 from F_SN", "proved by intervals", "proved with balls"), by_distance),
        "",
    ]
    if numbers["others"]:
        head = ("isolator", "F_0", "found", "proved")
        lines += [
            "Cases in which the proved number of folds differs from the one found:",
            "",
            *table(head, _rows(numbers["others"])),
            "",
        ]
    if unproved:
        head = ("question", "isolator", "F_0", "why")
        lines += ["Not proved:", "", *table(head, _rows(unproved)), ""]
    return lines


def _rows(found: list[list[str]]) -> Rows:
    return [tuple(row) for row in found]


def write(numbers: Numbers, folder: Path) -> None:
    """docs/stability.md and docs/stability_*.png."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, figure in pictures(numbers).items():
        figure.savefig(folder / f"{name}.png", dpi=110, metadata={"Software": None})
        plt.close(figure)
    (folder / "stability.md").write_text(page(numbers), encoding="utf-8")
