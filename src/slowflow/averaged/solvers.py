"""The solvers in use: the same questions, on compiled code where it runs, on NumPy elsewhere; see `backend`.

A mechanism that is derived but not compiled into the solvers (src/slowflow/native/instances.h) is solved on NumPy.
"""

from collections.abc import Callable
from typing import Any, TypeVar, cast

from slowflow import backend
from slowflow.averaged import compiled
from slowflow.averaged.reference import folds, locus, response

Question = TypeVar("Question", bound=Callable[..., Any])


def _chosen(question: str, on_numpy: Question) -> Question:
    if backend.SOLVER is None:
        return on_numpy
    on_compiled = getattr(compiled, question)

    def ask(*arguments: Any) -> Any:
        try:
            return on_compiled(*arguments)
        except NotImplementedError:  # raised for a mechanism that is not compiled, and for nothing else
            return on_numpy(*arguments)

    return cast(Question, ask)


amplitudes = _chosen("amplitudes", response.amplitudes)
detachment = _chosen("detachment", folds.detachment)
extrema = _chosen("extrema", locus.extrema)
fold_locus = _chosen("fold_locus", locus.fold_locus)
frequency_response = _chosen("frequency_response", response.frequency_response)
onset = _chosen("onset", folds.onset)
peak = _chosen("peak", folds.peak)
saddle_nodes = _chosen("saddle_nodes", folds.saddle_nodes)
