"""Seconds that questions take: of a plain oscillator, with more laws of damping, loaded.

Written by `python -m benchmarks.costs`; never edit. Medians of random mounts; nine of ten answers took between
1/SPREAD and SPREAD times as long.
"""

# fmt: off
from __future__ import annotations

from collections.abc import Mapping

MACHINE = "AMD EPYC"
SPREAD = 1.4
COSTS: Mapping[str, tuple[float, float, float]] = {
    "at_rest": (0.0031, 0.0031, 0),
    "rest": (0.0026, 0.0025, 0.0022),
    "saddle_node_onset": (0.00012, 0.00028, 0.18),
    "detachment": (0.0001, 8.3e-05, 0.0032),
    "saddle_nodes": (0.00015, 0.00014, 0.083),
    "peak": (0.00011, 0.00011, 0.17),
    "margins": (0.00037, 0.00094, 0.34),
    "hysteresis": (0.00024, 0.00016, 0.11),
    "isolation": (0.00086, 0.0013, 0.22),
    "amplitudes": (0.00026, 0.00028, 0.051),
    "frequency_response": (0.00024, 0.00047, 0.18),
    "spectrum": (0.00031, 0.00032, 0.092),
    "tolerances": (0.24, 0.31, 64),
    "tolerances at a frequency": (0.008, 0.021, 6.3),
    "tolerances in a spectrum": (0.089, 0.023, 16),
    "tolerances in a shock": (0.19, 0, 0.37),
    "transient": (0.0014, 0.0014, 0.0036),
    "shock_spectrum": (0.00053, 0.00056, 0.0028),
    "random": (0.027, 0.037, 0),
    "exact_response": (0.011, 0.0082, 0.21),
    "fold_locus": (0.00027, 0.00048, 0),
    "cusps": (0.00015, 0.00015, 0),
    "isola_points": (0.00016, 0.00016, 0),
}
