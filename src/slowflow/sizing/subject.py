"""What is sized: in go an isolator or a mount and values of its numbers, out come the answers of all these designs.

A number of a mount is varied in its own terms, and may change what the answers are measured in, as m or k_v do.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from slowflow import loads, validate
from slowflow.answer import frozen
from slowflow.averaged.many import Designs
from slowflow.averaged.questions import Averaged
from slowflow.isolator import ROD_SPRING, Isolator
from slowflow.mechanism import Floats
from slowflow.model import Model
from slowflow.physical import UNITS, Physical, size, sizes
from slowflow_kernels.conventions import FoldKind, Status
from slowflow_kernels.domains import DAMPING
from slowflow_kernels.scaling import SCALES

#: a mount's words for the letters of the scales of its design and its damping
WORDS = {"lam": "n", "k_h": "k_h", "Delta_h": "preload", "F_c": "friction", "c": "c"}
#: what can be asked of designs, by kind; a frequency is called with an f of a mount, with an Omega of an isolator
OF_ALL_FORCINGS = {"F_SN": "force", "F_cr": "force", "rest": "frequency"}
AT_A_FORCING = {"A_peak": "length", **dict.fromkeys(("peak", "jump_up", "jump_down", "isolation"), "frequency")}
KIND = OF_ALL_FORCINGS | AT_A_FORCING


class Subject:
    """An isolator or a mount whose numbers are varied.

    nominal -- the numbers that can be varied, by name, as they are
    answers -- names of what can be asked of it, and what they are among `KIND`

    Raises ValueError for what is no isolator.
    """

    def __init__(self, of: Any) -> None:
        self.of = of
        self.mount = of if isinstance(of, Physical) else None
        isolator = of.oscillator if isinstance(of, Physical) else of
        if not isinstance(isolator, Isolator):
            raise ValueError(f"{of!r} is not allowed: it must be an Isolator, or one made by Isolator.physical")
        self.mechanism = isolator.model.mechanism
        self.nominal = self._numbers(isolator)
        letter = "Omega" if self.mount is None else "f"
        self.answers = {f"{letter}_{name}" if kind == "frequency" else name: name for name, kind in KIND.items()}

    def _numbers(self, isolator: Isolator) -> dict[str, float]:
        """What an isolator was made from, a mount's in SI units."""
        names = (*(domain.name for domain in ROD_SPRING.design), *(domain.name for domain in DAMPING))
        if self.mount is None:
            return {name: getattr(isolator, name) for name in names}
        base = {name: getattr(self.mount.scales, name) for name in ("m", "k_v", "L")}
        found = dict(base)
        for name, scale in zip(names, self._scales(), strict=True):
            if scale.letter == "c" and "c" not in self.mount.given:
                found["zeta"] = isolator.zeta
            else:
                found[WORDS[scale.letter]] = getattr(isolator, name) * size(scale, **base)
        return found

    def _scales(self) -> list[Any]:
        return [*ROD_SPRING.scales, *(SCALES[domain.name] for domain in DAMPING)]

    def unit(self, answer: str) -> str:
        """Of an answer; "" without dimensions."""
        return next(iter(UNITS[KIND[self.answers[answer]]])) if self.mount else ""

    def forcing(self, F: Any, F_0: Any) -> float | None:
        """The forcing that was given, F of a mount or F_0 of an isolator, or none. Raises ValueError for the other."""
        value, other, name = (F_0, F, "F_0") if self.mount is None else (F, F_0, "F")
        if other is not None:
            raise ValueError(f"the forcing of {'an isolator' if self.mount is None else 'a mount'} is {name}")
        return None if value is None else validate.number(name, value, above=0.0)

    def answered(self, names: Iterable[str] | None, forcing: float | None) -> list[str]:
        """The answers that are wanted, by default all that need no design-by-design search.

        Raises ValueError for an unknown one, and for one that needs a forcing where there is none.
        """
        if names is None:
            of = {**OF_ALL_FORCINGS, **({} if forcing is None else AT_A_FORCING)}
            return [name for name, plain in self.answers.items() if plain in of and plain != "isolation"]
        for name in names:
            if name not in self.answers:
                raise ValueError(f"{name!r} is no answer: it must be one of {', '.join(self.answers)}")
            if forcing is None and self.answers[name] in AT_A_FORCING:
                raise ValueError(f"{name} needs a forcing: give {'F' if self.mount else 'F_0'}")
        return list(names)

    def check_varied(self, names: Iterable[str]) -> None:
        """Raises ValueError for a number that cannot be varied."""
        for name in names:
            if name not in self.nominal:
                raise ValueError(f"{name!r} cannot be varied: it must be one of {', '.join(self.nominal)}")

    def ask(self, values: Mapping[str, Any], names: Iterable[str], forcing: float | None) -> dict[str, Floats]:
        """These answers of designs whose numbers are as given, arrays of one shape, and else nominal.

        NaN for what there is not, or for what is no design.
        """
        given: dict[str, Any] = {**self.nominal, **values}
        shape = np.broadcast_shapes(*(np.shape(value) for value in given.values()))
        units: dict[str, Any] = dict.fromkeys(UNITS, 1.0)
        if self.mount is not None:
            base = {name: given[name] for name in ("m", "k_v", "L")}
            units = sizes(**base)
            names_of = (*(domain.name for domain in ROD_SPRING.design), *(domain.name for domain in DAMPING))
            given = {
                name: given["zeta"]
                if scale.letter == "c" and "zeta" in given
                else given[WORDS[scale.letter]] / size(scale, **base)
                for name, scale in zip(names_of, self._scales(), strict=True)
            }
        arrays = {name: np.broadcast_to(np.asarray(value, dtype=float), shape) for name, value in given.items()}
        F_0 = None if forcing is None else np.broadcast_to(forcing / units["force"], shape)
        batch = _Batch(Designs(self.mechanism, arrays), F_0)
        return {name: frozen(batch.answer(self.answers[name]) * units[KIND[self.answers[name]]]) for name in names}


class _Batch:
    """Answers to a batch of designs, each question asked once."""

    def __init__(self, designs: Designs, F_0: Floats | None) -> None:
        self.designs, self.F_0 = designs, F_0
        self.asked: dict[str, Any] = {}

    def _ask(self, question: str, *arguments: Any) -> Any:
        if question not in self.asked:
            self.asked[question] = getattr(self.designs, question)(*arguments)
        return self.asked[question]

    def answer(self, name: str) -> Floats:
        """One of `KIND`, dimensionless."""
        if name == "F_SN":
            onsets = self._ask("saddle_node_onset")
            lowest = np.where(onsets.status == Status.NONE, math.inf, onsets.F_SN)
            # folds below it end at Omega = 0
            return np.where(onsets.at_rest, np.nan, lowest)
        if name == "F_cr":
            detachments = self._ask("detachment")
            return np.where(detachments.status == Status.NONE, math.inf, detachments.F_cr)
        if name == "rest":
            *design, _, _ = self.designs.values.values()
            mechanism = self.designs.mechanism
            with np.errstate(all="ignore"):  # what is no design has no frequency
                stiffness = -np.asarray(mechanism.averaged(0.0, *mechanism.coefficients(*design))[1])
                return np.sqrt(np.where(stiffness > 0, stiffness, np.nan))
        if name == "isolation":
            return self._isolation()
        if name in ("A_peak", "peak"):
            peaks = self._ask("peak", self.F_0)
            if name == "peak":
                return np.asarray(peaks.Omega)
            bounded = np.where(peaks.status == Status.UNBOUNDED, math.inf, peaks.A)
            return np.where(peaks.status == Status.STICKS, 0.0, bounded)
        return self._jump(name == "jump_up")

    def _jump(self, up: bool) -> Floats:
        """The lowest fold that is left upwards, or the highest that is left downwards."""
        folds = self._ask("saddle_nodes", self.F_0)
        kinds = (
            (FoldKind.JUMP_UP, FoldKind.JUMP_UP_AT_CORNER) if up else (FoldKind.JUMP_DOWN, FoldKind.JUMP_DOWN_AT_CORNER)
        )
        there = np.isin(folds.kind, kinds)
        sign = 1.0 if up else -1.0
        first = sign * np.where(there, sign * folds.Omega, math.inf).min(axis=-1)
        return np.where(there.any(axis=-1), first, np.nan)

    def _isolation(self) -> Floats:
        """Design by design: there is no batch for it."""
        assert self.F_0 is not None
        found = np.full(self.F_0.shape, np.nan)
        for at in np.ndindex(self.F_0.shape):
            values = {name: float(value[at]) for name, value in self.designs.values.items()}
            try:
                one = loads.isolation(Averaged(Model.of(self.designs.mechanism, values)), float(self.F_0[at]))
            except (ValueError, ArithmeticError):
                continue
            found[at] = np.nan if one.Omega is None else one.Omega
        return found
