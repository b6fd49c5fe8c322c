"""The second approximation: the questions about an averaged oscillator, with higher harmonics."""

from slowflow.second.questions import SecondApproximation

__all__ = ["SecondApproximation"]
