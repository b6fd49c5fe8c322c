"""The solvers in use: the same questions, on compiled code where a model has it, on NumPy elsewhere.

Which of them is decided when the model is made, see `Model.native`.
"""

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numpy as np

from slowflow.averaged import compiled
from slowflow.averaged.reference import folds, locus, response
from slowflow.averaged.reference import onset as critical
from slowflow.model import Model

Question = TypeVar("Question", bound=Callable[..., Any])


def _either(on_compiled: Question, on_numpy: Question) -> Question:
    def ask(model: Model, *arguments: Any) -> Any:
        if model.native is not None:
            return on_compiled(model, *arguments)
        # a solver tries values that it then discards: the warnings that these raise are no fault of the arguments
        with np.errstate(all="ignore"):
            return on_numpy(model, *arguments)

    return cast(Question, ask)


amplitudes = _either(compiled.amplitudes, response.amplitudes)
detachment = _either(compiled.detachment, critical.detachment)
extrema = _either(compiled.extrema, locus.extrema)
fold_locus = _either(compiled.fold_locus, locus.fold_locus)
frequency_response = _either(compiled.frequency_response, response.frequency_response)
onset = _either(compiled.onset, critical.onset)
peak = _either(compiled.peak, critical.peak)
saddle_nodes = _either(compiled.saddle_nodes, folds.saddle_nodes)
