"""The second approximation: averaging with higher harmonics."""

from slowflow.second.questions import SecondApproximation

__all__ = ["SecondApproximation"]
