"""Batches of offset motions, averaged and random. Takes arrays of designs and loads; returns averaged answers."""

from __future__ import annotations

from typing import Any

from slowflow.averaged.batches import Batch
from slowflow.off_centre import many
from slowflow.random_vibration.many import answer


class OffCentreDesigns(many.OffCentreDesigns):
    """Arrays of designs of one mechanism under static loads; see `slowflow.off_centre.many`."""

    def _ask(self, question: str, /, *, workers: int = 1, **kwargs: Any) -> Batch:
        """The answer to a question by its name, from what its method takes."""
        if question == "random":
            return answer(self, **kwargs, workers=workers)
        return super()._ask(question, workers=workers, **kwargs)
