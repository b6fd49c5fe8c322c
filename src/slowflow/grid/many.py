"""Batches of oscillators: averaged results, second approximation and exact motions.

Averaged results are methods of `slowflow.averaged.many`.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from slowflow.answers.table import SHOCKS
from slowflow.averaged import batch_checks
from slowflow.core import validate

if TYPE_CHECKING:
    from slowflow.averaged.batches import Batch
    from slowflow.second.many import SecondDesigns


class Designs(batch_checks.Designs):
    """Arrays of designs of one mechanism, at three levels of approximation; see `slowflow.averaged.many`."""

    @cached_property
    def second_approximation(self) -> SecondDesigns:
        """The same questions with higher harmonics of force and friction."""
        from slowflow.second.many import SecondDesigns

        validate.is_plain("second_approximation", self.laws)
        return SecondDesigns(self)

    def _ask(self, question: str, /, *, workers: int = 1, **kwargs: Any) -> Batch:
        """The answer to a question by its name, from what its method takes."""
        if question in SHOCKS:
            from slowflow.exact import shocks_many
            from slowflow.off_centre.questions import OffCentre

            def at_rest(one: dict[str, float]) -> OffCentre:
                return OffCentre(self.model(one), 0.0)

            return shocks_many.answer(self, question, **kwargs, workers=workers, at_rest=at_rest)
        if question == "random":
            from slowflow.random_vibration import many as random_many

            return random_many.answer(self, **kwargs, workers=workers)
        return super()._ask(question, workers=workers, **kwargs)
