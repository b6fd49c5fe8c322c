"""slowflow: response curves, folds and critical forcings of vibration isolators, from derived and generated equations.

In:  an oscillator's parameters. Out: `Isolator`, `Duffing`, and the answers that they give.
"""

from slowflow.isolator import Duffing, Isolator

__all__ = ["Duffing", "Isolator"]
__version__ = "0.1.0"
