"""Every generated kernel in balls against 40-digit values from independent routes, of few digits and of many."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator
from typing import NamedTuple

import pytest
from flint import arb, arb_series, ctx

from slowflow.averaged.balls.search import bits_lost
from tests.files import ROOT, stored

ORACLE = stored("kernel_oracle")
MODULES = sorted(path.stem for path in (ROOT / "generated" / "slowflow_kernels").glob("*_balls.py"))
FUNCTIONS = [(name, one) for name in MODULES for one in importlib.import_module(f"slowflow_kernels.{name}").__all__]
#: of the arithmetic here
EXACTLY = 400
#: a radius, in 2^-bits of what rounding the arguments and the result once each would cause; measured: at most 13.3, of
#: the jump of a force with delta_h = 1e-6, and 1.4 of averages
MOST = 16

#: the force below u_cr, beyond which it is u; (5), and what it is cut from
FORCES = {
    "rod_spring": lambda u, alpha, beta, gamma, _: alpha * u + beta * u**3 + gamma * u**5,
    "rod_spring_untruncated": lambda u, alpha, beta, _: (alpha - 2 * beta) * u + 2 * beta * u / (1 - u * u).sqrt(),
}


class Case(NamedTuple):
    """A function in balls, its arguments, how many of its bits closed forms may lose there, and what it has to hold."""

    function: Callable[..., object]
    arguments: list[object]
    lost: int
    values: list[arb]
    scales: list[arb]


def printed(row: dict) -> list[arb]:
    """A row's values, widened by the rounding of their last digit."""
    values = [arb(text) for text in row["is"]]
    return [arb(value.mid(), (abs(value) * arb("1e-39")).upper()) for value in values]


def scales(row: dict) -> list[arb]:
    return [arb(text) for text in row["scale"]]


def balls_of(module: str) -> object:
    return importlib.import_module(f"slowflow_kernels.{module}_balls")


def plainly(module: str, name: str) -> Iterator[Case]:
    """A function of the same arguments and outputs as the kernel of its name; `given` has the coefficients first."""
    for row in ORACLE[module]["coefficients" if name == "given" else name]:
        yield Case(getattr(balls_of(module), name), [*map(arb, row["at"])], 0, printed(row), scales(row))


def at_u_cr(module: str, parameters: list[arb], u_cr: arb) -> tuple[arb, arb]:
    """By how much the force exceeds u at u_cr, and its slope that of u."""
    taylor = FORCES[module](arb_series([u_cr, 1], prec=2), *parameters) - arb_series([u_cr, 1], prec=2)
    return taylor[0], taylor[1]


def by_coefficients(module: str) -> Iterator[Case]:
    """A design's parameters, then what the force loses at its breakpoint, of which each digit counts."""
    for case in plainly(module, "given"):
        lost = []
        if module in FORCES:
            (u_cr,) = (arb(one) for one in balls_of(module).breakpoints(*case.values))
            lost = [at_u_cr(module, case.values, u_cr)[0]]
        yield case._replace(values=case.values + lost, scales=case.scales + [abs(one) for one in lost])


def kinks(module: str) -> Iterator[Case]:
    """What the slope of the force loses; its scale by the size of its terms."""
    for row in ORACLE[module]["breakpoints"]:
        parameters = [*map(arb, row["at"])]
        slope = at_u_cr(module, parameters, printed(row)[0])[1]
        yield Case(balls_of(module).kinks, parameters, 0, [slope], [1 + abs(slope) + sum(map(abs, parameters))])


def averages(module: str, name: str) -> Iterator[Case]:
    """h to h_AAA, and h - A h_A, on the side of the breakpoint that doubles tell."""
    plain, balls = importlib.import_module(f"slowflow_kernels.{module}"), balls_of(module)
    jumps = {tuple(row["at"]): printed(row) for row in ORACLE[module]["jumps"]}
    for row, other in zip(ORACLE[module]["averaged"], ORACLE[module]["intercept"], strict=True):
        A, *p = map(arb, row["at"])
        resting = A == 0 and hasattr(balls, "at_rest")
        if resting != (name == "at_rest"):
            continue
        ends = [arb(end) for end in balls.breakpoints(*p)] if hasattr(balls, "breakpoints") else []
        passed = int(sum(row["at"][0] > end for end in plain.breakpoints(*row["at"][1:])))
        values = printed(row) + printed(other)
        if ends and not passed and ends[0] < A:
            A = ends[0]  # the double next to u_cr stands for it
            values[4] = values[0] - A * values[1]
        sides = [passed, A, A - ends[passed - 1] if passed else A] if ends else [A]
        # averages of a force that jumps take by how much
        jump = [] if hasattr(balls, "kinks") else jumps[tuple(row["at"][1:])]
        arguments = p if resting else [*sides, *p, *jump]
        yield Case(getattr(balls, name), arguments, bits_lost(A, ends), values, scales(row) + scales(other))


def cases(module: str, name: str) -> Iterator[Case]:
    if name in ("known", "at_rest"):
        return averages(module, name)
    return (
        {"given": by_coefficients, "kinks": kinks}[name](module)
        if name in ("given", "kinks")
        else plainly(module, name)
    )


@pytest.mark.parametrize(("module", "name"), FUNCTIONS)
def test_a_function_in_balls_holds_its_values_and_little_else(module, name):
    tried = 0
    with ctx.workprec(EXACTLY):
        for case in cases(module.removesuffix("_balls"), name):
            for bits in (53, 120):
                with ctx.workprec(bits + case.lost):
                    found = case.function(*case.arguments)
                found = [arb(one) for one in (found if isinstance(found, tuple) else [found])]
                for ball, value, scale in zip(found, case.values, case.scales, strict=True):
                    assert ball.overlaps(value), (case, bits, ball)
                    # the quotients of zeros at the double A = 1, which is no amplitude u_cr + x, are not known
                    at_1 = name == "known" and case.arguments[1] == 1
                    assert at_1 or ball.rad() <= MOST * arb(2) ** -bits * scale.upper(), (case, bits, ball)
                    tried += 1
    assert tried
