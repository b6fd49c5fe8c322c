"""Seconds that questions take: of a plain oscillator, with more laws of damping, loaded.

Written by `python -m benchmarks.costs`; never edit. Medians of random mounts; nine of ten answers took between
1/SPREAD and SPREAD times as long.
"""

# fmt: off
from __future__ import annotations

from collections.abc import Mapping

MACHINE = "AMD EPYC"
SPREAD = 1.5
COSTS: Mapping[str, tuple[float, float, float]] = {
    "at_rest": (0.0036, 0.0036, 0),
    "rest": (0.0031, 0.0033, 0.0029),
    "saddle_node_onset": (0.00023, 0.15, 0.21),
    "detachment": (0.00016, 0.00037, 0.0038),
    "saddle_nodes": (0.00029, 0.015, 0.094),
    "peak": (0.00016, 0.025, 0.19),
    "margins": (0.00045, 0.23, 0.39),
    "hysteresis": (0.0008, 0.017, 0.14),
    "isolation": (0.00062, 0.037, 0.25),
    "amplitudes": (0.00042, 0.0063, 0.063),
    "frequency_response": (0.00029, 0.0099, 0.2),
    "spectrum": (0.00045, 0.1, 0.1),
    "tolerances": (0.17, 27, 70),
    "tolerances at a frequency": (0.0095, 0.68, 6.3),
    "tolerances in a spectrum": (0.12, 15, 16),
    "tolerances in a shock": (0.21, 0, 0.35),
    "transient": (0.0014, 0.0014, 0.0035),
    "shock_spectrum": (0.0006, 0.0006, 0.0028),
    "exact_response": (0.01, 0.053, 0.21),
    "fold_locus": (0.00031, 0.077, 0),
    "cusps": (0.00022, 0.028, 0),
    "isola_points": (0.00024, 0.029, 0),
}
