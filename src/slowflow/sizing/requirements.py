"""Inverse design: in go a design, free numbers and what is required, out comes the nearest design that has it.

By SciPy's differential evolution over the batch questions, from a seed: each generation is one batch.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.optimize import differential_evolution

from slowflow import validate
from slowflow.answer import Answer
from slowflow.mechanism import Floats
from slowflow.sizing.subject import Subject

#: what a violation counts, in distances from the design as it is
PENALTY = 1e3
#: a requirement is met to rounding
MET = 1e-9
#: members of a generation for each free number, and generations
MEMBERS, GENERATIONS = 15, 300
INFEASIBLE = "infeasible: the binding requirement is {}; as near as all of them can be had it is {:.4g}"


@dataclass(frozen=True, eq=False)
class Met(Answer):
    """The design that meets requirements and is nearest to the one that was given, or comes nearest to meeting them.

    design   -- an `Isolator`, or a mount
    feasible -- whether it meets them
    numbers  -- the free numbers, by name
    reached  -- the required answers, by name
    binding  -- of an infeasible design the requirement that it violates most, in words; "" of others
    """

    design: Any = field(repr=False)
    feasible: bool
    numbers: Mapping[str, float]
    reached: Mapping[str, float]
    binding: str
    message: str

    def __hash__(self) -> int:
        return hash((self.design, self.binding))


def meet(
    of: Any,
    free: Mapping[str, tuple[float, float]],
    *,
    at_least: Mapping[str, float] | None = None,
    at_most: Mapping[str, float] | None = None,
    F: float | None = None,
    F_0: float | None = None,
    seed: int = 0,
) -> Met:
    """The design nearest to `of` that meets requirements.

    of       -- an `Isolator`, or a mount in SI units
    free     -- by name, the lowest and the highest value of each number that may change; distances are shares of that
    at_least, at_most -- by name of an answer that `slowflow.sizing` lists, what it has to reach and not to exceed
    F, F_0   -- the forcing, F of a mount in N, F_0 of an isolator

    An answer that a design does not have meets nothing; F_SN and F_cr are infinite where there is no such forcing.
    Where no design meets all, `.feasible` is False and `.message` names the binding requirement. Raises ValueError for
    what is not allowed.
    """
    subject = Subject(of)
    forcing = subject.forcing(F, F_0)
    wanted = [(name, limit, 1.0) for name, limit in (at_least or {}).items()]
    wanted += [(name, limit, -1.0) for name, limit in (at_most or {}).items()]
    names = subject.answered([name for name, _, _ in wanted], forcing)
    wanted = [(name, validate.number(name, limit, above=0.0), sign) for name, limit, sign in wanted]
    subject.check_varied(free)
    if not wanted or not free:
        raise ValueError("meet needs at least one requirement and one free number")
    ends = {name: validate.window(name, pair) for name, pair in free.items()}
    low, high = np.array(list(ends.values())).T
    start = np.array([subject.nominal[name] for name in free])

    def short(values: Floats) -> Floats:
        """How far each requirement is from being met, as a share of its limit: shape (requirements, designs)."""
        found = subject.ask(dict(zip(free, values, strict=True)), dict.fromkeys(names), forcing)
        rows = []
        for name, limit, sign in wanted:
            share = sign * (1 - np.minimum(found[name] / limit, 1e6))
            rows.append(np.where(np.isnan(share), 1.0, np.maximum(share, 0.0)))
        return np.array(rows)

    def cost(values: Floats) -> Floats:
        away = (((values.T - start) / (high - low)) ** 2).sum(axis=1)
        missed = short(values).sum(axis=0)
        return np.asarray(np.where(missed > MET, PENALTY * (1 + missed), 0.0) + away)

    found = differential_evolution(
        lambda x: cost(x.reshape(len(free), -1)),
        list(zip(low, high, strict=True)),
        x0=np.clip(start, low, high),
        popsize=MEMBERS,
        maxiter=GENERATIONS,
        tol=1e-8,
        rng=seed,
        polish=False,
        updating="deferred",
        vectorized=True,
    )
    numbers = dict(zip(free, found.x.tolist(), strict=True))
    missed = short(found.x.reshape(-1, 1))[:, 0]
    reached = {name: float(values) for name, values in subject.ask(numbers, names, forcing).items()}
    binding, message = "", ""
    if missed.max() > MET:
        name, limit, sign = wanted[int(missed.argmax())]
        unit = f" {subject.unit(name)}" if subject.unit(name) else ""
        binding = f"{name} {'>=' if sign > 0 else '<='} {limit:g}{unit}"
        message = INFEASIBLE.format(binding, reached[name])
    return Met(subject.of.replace(**numbers), not binding, numbers, reached, binding, message)
