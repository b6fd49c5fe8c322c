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
    "detachment": (0.00024, 0.0002, 0.0048),
    "saddle_node_onset": (0.00023, 0.00026, 0.22),
    "saddle_nodes": (0.00029, 0.00026, 0.015),
    "amplitudes": (0.00065, 0.00063, 0.0097),
    "frequency_response": (0.00067, 0.00086, 0.14),
    "peak": (0.00026, 0.00023, 0.099),
    "rest": (0.0064, 0.0053, 0.0026),
    "at_rest": (0.0043, 0.0045, 0),
    "margins": (0.00052, 0.00066, 0.31),
    "hysteresis": (0.00043, 0.00029, 0.029),
    "isolation": (0.0023, 0.0036, 0.033),
    "spectrum": (0.0005, 0.00056, 0.035),
    "transient": (0.0012, 0.0012, 0.0038),
    "shock_spectrum": (0.00049, 0.00047, 0.0031),
    "random": (0.00053, 0.00049, 0.0013),
    "tolerances": (0.55, 0.42, 49),
    "tolerances at a frequency": (0.024, 0.043, 1.4),
    "tolerances in a spectrum": (0.5, 0.048, 14),
    "tolerances in a shock": (0.29, 0, 0.57),
    "exact_response": (0.016, 0.013, 0.11),
    "fold_locus": (0.00044, 0.00061, 0),
    "cusps": (0.00021, 0.00026, 0),
    "isola_points": (0.00022, 0.00027, 0),
}
