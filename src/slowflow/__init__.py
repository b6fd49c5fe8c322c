"""slowflow: response curves, folds and critical forcings of vibration isolators, from derived and generated equations.

In:  an oscillator's parameters. Out: `Isolator`, `Duffing`, `Oscillator` of any derived mechanism, and their answers.
"""

from slowflow.isolator import Duffing, Isolator
from slowflow.oscillator import Oscillator

__all__ = ["Duffing", "Isolator", "Oscillator"]
__version__ = "0.1.0"
