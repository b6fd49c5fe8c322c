"""The solvers in use: the same questions, on compiled code where it runs, on NumPy elsewhere; see `backend`."""

from slowflow import backend

if backend.SOLVER is None:
    from slowflow.folds import detachment, onset, peak, saddle_nodes
    from slowflow.locus import extrema, fold_locus
    from slowflow.response import amplitudes, frequency_response
else:
    from slowflow.compiled import (
        amplitudes,
        detachment,
        extrema,
        fold_locus,
        frequency_response,
        onset,
        peak,
        saddle_nodes,
    )

__all__ = [
    "amplitudes",
    "detachment",
    "extrema",
    "fold_locus",
    "frequency_response",
    "onset",
    "peak",
    "saddle_nodes",
]
