"""How the same questions are answered elsewhere, for the work-precision diagram: in doubles, with NumPy and SciPy.

    numpy.roots     the polynomial (24) or (30) expanded, its companion matrix's eigenvalues; folds bisected in A
    bracketing      sign changes on a grid of Omega, `scipy.optimize.brentq` between them; folds the same way in A
    the recipe      (33) and its like for folds: the resultant's polynomial in A by numpy.roots, then Omega

Every one uses the installed kernels for h and h_A, so that it is the method that is compared and not the formula.
`prepare` makes jobs of them for `benchmarks.remote`, named "scene | method | variant".
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from benchmarks import certified, jobs
from slowflow.example import DESIGN, TABLE_1
from slowflow_kernels import rod_spring, slow_flow

F_0, ZETA = certified.F_0, TABLE_1["zeta"]
M = float(slow_flow.friction(TABLE_1["mu"]))
P = tuple(float(x) for x in rod_spring.coefficients(*DESIGN))
OMEGA_MAX = 2.0
METHODS = ("numpy.roots", "bracketing", "the paper's recipe")
Points = list[tuple[float, float]]
Onset = tuple[float, float, float]


# ---- Omega for given A


def by_numpy_roots(amplitudes: np.ndarray) -> list[np.ndarray]:
    """Positive real roots of (24) for each A, rising."""
    h = rod_spring.averaged_2(amplitudes, *P)[0]
    quartics = np.column_stack(
        [
            amplitudes**2,
            0 * h,
            4 * amplitudes**2 * ZETA**2 + 2 * amplitudes * h,
            4 * amplitudes * ZETA * M,
            M**2 + h**2 - F_0**2,
        ]
    )
    return [_positive(np.roots(quartic)) for quartic in quartics]


def by_bracketing(amplitudes: np.ndarray, cells: int, tolerance: float) -> list[np.ndarray]:
    """The same by brentq in the cells of a grid of Omega where (24) changes its sign."""
    grid = np.linspace(0, OMEGA_MAX, cells + 1)
    h = rod_spring.averaged_2(amplitudes, *P)[0]
    signs = np.sign(_F(grid, amplitudes[:, np.newaxis], h[:, np.newaxis]))
    return [
        np.array([brentq(_F, grid[i], grid[i + 1], args=(A, h_A), xtol=tolerance) for i in np.flatnonzero(change)])
        for A, h_A, change in zip(amplitudes.tolist(), h.tolist(), signs[:, 1:] * signs[:, :-1] < 0, strict=True)
    ]


def _F(Omega: Any, A: Any, h: Any) -> Any:
    R, friction = A * Omega * Omega + h, 2 * ZETA * A * Omega + M
    return R * R + friction * friction - F_0 * F_0


def _positive(roots: np.ndarray) -> np.ndarray:
    return np.sort(roots.real[(roots.imag == 0) & (roots.real > 0)])


# ---- folds at F_0


def folds_between(omegas: Callable[[np.ndarray], list[np.ndarray]], cells: int, tolerance: float) -> Points:
    """(Omega, A) where F_A changes its sign along a branch, by brentq in A between the points of a grid."""

    def slope(A: float, j: int) -> float:
        found = omegas(np.array([A]))[0]
        h, h_A = rod_spring.averaged_2(A, *P)
        return float(slow_flow.F_A(found[j], A, M, ZETA, h, h_A)) if j < found.size else np.nan

    grid = np.linspace(0.0, 0.65, cells + 1)[1:]
    branches, found = omegas(grid), []
    for (low, on_low), (high, on_high) in zip(
        zip(grid[:-1], branches[:-1], strict=True), zip(grid[1:], branches[1:], strict=True), strict=True
    ):
        for j in range(on_low.size if on_low.size == on_high.size else 0):
            if slope(low, j) * slope(high, j) < 0:
                A = brentq(slope, low, high, args=(j,), xtol=tolerance)
                found.append((float(omegas(np.array([A]))[0][j]), A))
    return found


def folds_by_recipe() -> Points:
    """Roots A of Res_Omega(F, F_A) (first regime), and the Omega for which F_A and F vanish best."""
    found = []
    for A in _amplitudes(rod_spring.saddle_nodes(F_0, M, ZETA, *P)):
        h, h_A = rod_spring.averaged_2(A, *P)
        Omega = _positive(np.roots(_fold_quartic(A, h, h_A)))
        gap = np.abs(_F(Omega, A, h))
        if Omega.size and gap.min() < 1e-3 * F_0**2:
            found.append((float(Omega[gap.argmin()]), float(A)))
    return found


def _amplitudes(even: Any) -> np.ndarray:
    """Positive real roots A up to u_cr, below which (33) holds, of a polynomial with even powers only."""
    coefficients = np.zeros(2 * len(even) - 1)
    coefficients[::2] = even
    A = _positive(np.roots(coefficients[::-1]))
    return A[P[-1] >= A]


def _fold_quartic(A: float, h: float, h_A: float) -> list[float]:
    return [A, 0, h + A * h_A + 4 * ZETA**2 * A, 2 * ZETA * M, h * h_A]


# ---- onset


def onset_by_recipe(tried: bool) -> Onset:
    """(33), Omega from F_AA = 0, F_SN from F = 0: for the least positive root, as the paper says, or each root tried.

    The root kept is the one for which F_A vanishes best.
    """
    candidates = []
    for A in _amplitudes(rod_spring.saddle_node_onset(M, ZETA, *P)).tolist():
        h, h_A, h_AA, _ = rod_spring.averaged(A, *P)
        # F_AA/2 = (Omega^2 + h_A)^2 + (A Omega^2 + h) h_AA + 4 zeta^2 Omega^2
        square = np.roots([1, 2 * h_A + A * h_AA + 4 * ZETA**2, h_A**2 + h * h_AA])
        for Omega in np.sqrt(_positive(square)).tolist():
            level = float(np.hypot(A * Omega**2 + h, 2 * ZETA * A * Omega + M))
            candidates.append((abs(float(slow_flow.F_A(Omega, A, M, ZETA, h, h_A))), (level, Omega, A)))
        if not tried and candidates:
            break
    return min(candidates)[1]


def onset_by_search(omegas: Callable[[float], np.ndarray], cells: int, tolerance: float) -> Onset:
    """The least F_0 along the fold locus: a grid of A, then a bounded scalar minimisation."""

    def level(A: float) -> tuple[float, float]:
        h = rod_spring.averaged_2(A, *P)[0]
        found = [(float(np.hypot(A * w**2 + h, 2 * ZETA * A * w + M)), float(w)) for w in omegas(A)]
        return min(found, default=(np.inf, np.nan))

    grid = np.linspace(0, 0.65, cells + 1)[1:]
    i = int(np.argmin([level(A)[0] for A in grid]))
    bounds = (grid[max(i - 1, 0)], grid[min(i + 1, cells - 1)])
    A = minimize_scalar(lambda A: level(A)[0], bounds=bounds, method="bounded", options={"xatol": tolerance}).x
    return (*level(A), float(A))


def fold_roots_by_numpy(A: float) -> np.ndarray:
    """Positive roots of (30) at A."""
    h, h_A = rod_spring.averaged_2(A, *P)
    return _positive(np.roots(_fold_quartic(A, float(h), float(h_A))))


def fold_roots_by_bracketing(A: float, cells: int, tolerance: float) -> np.ndarray:
    """The same by brentq in the cells of a grid of Omega."""
    h, h_A = (float(x) for x in rod_spring.averaged_2(A, *P))
    quartic = _fold_quartic(A, h, h_A)
    grid = np.linspace(0, OMEGA_MAX, cells + 1)
    values = np.polyval(quartic, grid)
    return np.array(
        [
            brentq(lambda w: np.polyval(quartic, w), grid[i], grid[i + 1], xtol=tolerance)
            for i in np.flatnonzero(values[1:] * values[:-1] < 0)
        ]
    )


# ---- jobs


def prepare() -> dict[str, jobs.Job]:
    """Jobs by name."""
    roots, bracketing, recipe = METHODS
    some = jobs.amplitudes(jobs.SAMPLES)
    calls: dict[str, Callable[[], Any]] = {f"response | {roots} | expanded (24)": partial(by_numpy_roots, some)}

    def cells_for(cells: int, tolerance: float) -> Callable[[np.ndarray], list[np.ndarray]]:
        return partial(by_bracketing, cells=cells, tolerance=tolerance)

    for power in range(6):
        amplitudes = jobs.amplitudes(10**power)
        calls[f"response {10**power} | {roots}"] = partial(by_numpy_roots, amplitudes)
        calls[f"response {10**power} | {bracketing}"] = partial(cells_for(100, 1e-12), amplitudes)
    for cells, tolerance in ((20, 1e-12), (100, 1e-4), (100, 1e-8), (100, 1e-12), (2000, 1e-12)):
        calls[f"response | {bracketing} | {cells} cells, xtol {tolerance:.0e}"] = partial(
            cells_for(cells, tolerance), some
        )
    for cells, tolerance in ((30, 1e-12), (100, 1e-4), (100, 1e-8), (100, 1e-12)):
        variant = f"{cells} amplitudes, xtol {tolerance:.0e}"
        for method, omegas in {roots: by_numpy_roots, bracketing: cells_for(100, tolerance)}.items():
            calls[f"folds | {method} | {variant}"] = partial(folds_between, omegas, cells, tolerance)
    calls[f"folds | {recipe} | attached only, Res(F, F_A)"] = folds_by_recipe
    for tolerance in (1e-2, 1e-5, 1e-9):
        variant = f"100 amplitudes, xatol {tolerance:.0e}"
        single = {roots: fold_roots_by_numpy, bracketing: partial(fold_roots_by_bracketing, cells=100, tolerance=1e-12)}
        for method, at in single.items():
            calls[f"onset | {method} | {variant}"] = partial(onset_by_search, at, 100, tolerance)
    calls[f"onset | {recipe} | least root, to the letter"] = partial(onset_by_recipe, False)
    calls[f"onset | {recipe} | every root tried"] = partial(onset_by_recipe, True)
    return {
        name: (call, (lambda found: jobs.vectors([found])) if name.startswith("onset") else jobs.vectors)
        for name, call in calls.items()
    }
