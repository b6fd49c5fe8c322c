"""The second approximation: an averaged oscillator's questions with what the higher harmonics change."""

from slowflow.second.questions import SecondApproximation

__all__ = ["SecondApproximation"]
