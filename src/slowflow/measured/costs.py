"""Seconds that questions take, by backend: of a plain oscillator, with more laws of damping, loaded.

Written by `python -m benchmarks.costs`; never edit. Medians of random mounts; nine of ten answers took between
1/SPREAD and SPREAD times as long.
"""

# fmt: off
from __future__ import annotations

from collections.abc import Mapping

MACHINE = "AMD EPYC"
SPREAD = 1.5
COSTS: Mapping[str, Mapping[str, tuple[float, float, float]]] = {
    "native": {
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
    },
    "numpy": {
        "at_rest": (0.0036, 0.0036, 0),
        "rest": (0.0035, 0.0031, 0.0028),
        "saddle_node_onset": (0.01, 0.38, 0.27),
        "detachment": (0.00046, 0.00057, 0.0039),
        "saddle_nodes": (0.0059, 0.024, 0.14),
        "peak": (0.0045, 0.038, 0.26),
        "margins": (0.037, 0.55, 0.56),
        "hysteresis": (0.018, 0.024, 0.18),
        "isolation": (0.014, 0.13, 0.34),
        "amplitudes": (0.015, 0.074, 0.085),
        "frequency_response": (0.017, 0.082, 0.27),
        "spectrum": (0.045, 0.16, 0.13),
        "tolerances": (1.7, 45, 87),
        "tolerances at a frequency": (0.62, 1.1, 9.4),
        "tolerances in a spectrum": (0.64, 23, 20),
        "tolerances in a shock": (5.7, 0, 6),
        "transient": (0.23, 0.22, 0.22),
        "shock_spectrum": (0.048, 0.05, 0.05),
        "exact_response": (8.1, 4.4, 0),
        "fold_locus": (0.018, 0.13, 0),
        "cusps": (0.0055, 0.045, 0),
        "isola_points": (0.0055, 0.046, 0),
    },
}
