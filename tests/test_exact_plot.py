"""Figures 2a and 2b are drawn from the exact and the averaged curves."""

import numpy as np
import pytest

from slowflow.backend import EXACT
from slowflow.paper.example import isolator
from tests.oracles.exact_cases import table_1

figure = pytest.importorskip("matplotlib.figure")


@pytest.mark.skipif(EXACT is None, reason="not compiled: curves take too long")
def test_figure_2():
    from slowflow.paper.figure_2 import figure_2a, figure_2b

    left, right = figure.Figure().subplots(1, 2)
    figure_2a(left, ratios=(0.3, 0.6))
    lines = [line for line in left.get_lines() if line.get_marker() == "o"]
    assert len(lines) == 4
    # Den Hartog's points lie on the exact curve, which is the first line of each group of four
    for k, line in enumerate(lines):
        exact = left.get_lines()[4 * k]
        x, y = (np.asarray(values, float) for values in line.get_data())
        on = np.isfinite(y)
        curve_x, curve_y = (np.asarray(values, float) for values in exact.get_data())
        moving = np.isfinite(curve_y)
        inside = on & (x >= curve_x[moving].min()) & (x <= curve_x[moving].max())
        assert np.max(np.abs(np.interp(x[inside], curve_x[moving], curve_y[moving]) / y[inside] - 1)) <= 1e-3
    averaged = isolator()
    figure_2b(right, ((averaged, table_1(exact=True)),), 0.04, (0.6, 1.2))
    assert len(right.get_lines()) >= 3
