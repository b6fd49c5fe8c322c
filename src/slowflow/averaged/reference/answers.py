"""The answers of the NumPy solvers, in one place: a model in, results out."""

from slowflow.averaged.reference.bounds import closes
from slowflow.averaged.reference.folds import saddle_nodes
from slowflow.averaged.reference.locus import extrema, fold_locus
from slowflow.averaged.reference.onset import detachment, onset, peak
from slowflow.averaged.reference.response import amplitudes, frequency_response

__all__ = [
    "amplitudes",
    "closes",
    "detachment",
    "extrema",
    "fold_locus",
    "frequency_response",
    "onset",
    "peak",
    "saddle_nodes",
]
