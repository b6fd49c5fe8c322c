"""A user's script with each question: `make lint` has mypy and basedpyright check the types of all that it holds.

`assert_type` states a type; no expression may be `Any`, but what an entry is unpacked into; a line
that ends in `# type: ignore` has to be an error.
"""

from typing import assert_type

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from slowflow import Duffing, Isolator, Physical
from slowflow.answers import results
from slowflow.grid.many import Designs
from slowflow.oscillators.physical_designs import PhysicalDesigns
from slowflow.oscillators.physical_grid import PhysicalGrid

Floats = NDArray[np.float64]
Codes = NDArray[np.int8]


def dimensionless(iso: Isolator) -> None:
    folds = iso.saddle_nodes(0.04)
    assert_type(folds, results.SaddleNodes)
    assert_type(folds.Omega, Floats)
    assert_type([fold.Omega for fold in folds], list[float])
    assert_type(folds[0].corner, bool)
    print(*folds[0])  # pyright: ignore[reportAny]
    assert_type(folds.plot(), Axes)
    assert_type(folds.gradient().condition("A"), Floats)
    assert_type(folds.measure().error, Floats)
    assert_type(iso.amplitudes(Omega=[0.9, 1.0], F_0=0.04).transmissibility_dB, Floats)
    assert_type(iso.frequency_response(0.04).branch, NDArray[np.intp])
    assert_type(iso.saddle_node_onset().F_SN, float | None)
    assert_type(iso.detachment().F_cr, float | None)
    assert_type(iso.peak(0.04).A, float | None)
    assert_type(iso.fold_locus().A, Floats)
    assert_type(iso.cusps().minimum, NDArray[np.bool_])
    assert_type(iso.isola_points().kind, NDArray[np.str_])
    assert_type(iso.certify(0.04).saddle_nodes.proved, bool)
    assert_type(iso.margins(0.04).of_SN, float | None)
    assert_type(iso.hysteresis(0.04).Omega_low, Floats)
    assert_type(iso.isolation(0.04, level_dB=-20).Omega, float | None)
    assert_type(iso.spectrum(Omega=[0.9, 1.0], F_0=0.04).A, Floats)
    assert_type(iso.rest().u, Floats)
    assert_type(iso.at_rest().Omega_0, float | None)
    assert_type(iso.steady_state(Omega=0.9, F_0=0.04).A, float)
    assert_type(iso.exact_response(0.04).complete, bool)
    assert_type(iso.sweep(Omega=[0.9, 1.0], F_0=0.04).A, Floats)
    assert_type(iso.transient(acceleration=0.2, duration=2.0).A, float)
    assert_type(iso.shock_spectrum(acceleration=[0.1, 0.2], duration=2.0).ratio, Floats)
    assert_type(iso.random(S_0=1e-4).u_rms, Floats)
    assert_type(iso.second_approximation.peak(0.04).A, float | None)


def many(designs: Designs, r: Floats) -> None:
    assert_type(Isolator.many(lam=3, r=r, delta_h=0.1, load=0.01), Designs)
    assert_type(Duffing.many([1.0, 2.0], 0.1, zeta=np.float64(0.02)), Designs)
    assert_type(designs.saddle_nodes([0.04, 0.05], max_count=2).Omega, Floats)
    assert_type(designs.saddle_nodes(0.04).kind, Codes)
    assert_type(designs.amplitudes(Omega=r, F_0=0.04).phi, Floats)
    assert_type(designs.frequency_response(0.04).branch, NDArray[np.int16])
    assert_type(designs.saddle_node_onset().F_SN, Floats)
    assert_type(designs.detachment().F_cr, Floats)
    assert_type(designs.peak(0.04).status, Codes)
    assert_type(designs.certify(0.04).proved, Codes)
    assert_type(designs.margins(0.04).of_SN, Floats)
    assert_type(designs.hysteresis(0.04).Omega_low, Floats)
    assert_type(designs.isolation(0.04, level_dB=-20).Omega, Floats)
    assert_type(designs.spectrum(Omega=[0.9, 1.0], F_0=0.04).A, Floats)
    assert_type(designs.at_rest().Omega_0, Floats)
    assert_type(designs.transient(acceleration=0.2, duration=2.0).A, Floats)
    assert_type(designs.shock_spectrum(acceleration=0.2, duration=2.0).ratio, Floats)
    assert_type(designs.random(S_0=r).u_rms, Floats)
    assert_type(designs.second_approximation.peak(0.04).A, Floats)


def physical(mount: Physical) -> None:
    assert_type(mount.saddle_nodes(F=5).f, Floats)
    assert_type(mount.saddle_nodes(5).answer, results.SaddleNodes)
    assert_type([fold.corner for fold in mount.saddle_nodes(5)], list[bool])
    assert_type(mount.saddle_nodes(5).measure().error, Floats)
    assert_type(mount.amplitudes(f=np.linspace(3, 5), F=np.float32(5)).transmissibility_dB, Floats)
    assert_type(mount.frequency_response(5.0, f=(1, 3)).in_units("kN").A, Floats)
    assert_type(mount.peak("5 N").A, float | None)
    assert_type(mount.peak(5).answer, results.Peak)
    assert_type(mount.peak(5).measure().error, float | None)
    assert_type(mount.saddle_node_onset().F_SN, float | None)
    assert_type(mount.detachment().F_cr, float | None)
    assert_type(mount.fold_locus().F, Floats)
    assert_type(mount.cusps().F, Floats)
    assert_type(mount.isola_points().f, Floats)
    assert_type(mount.certify(5).saddle_nodes.A, Floats)
    assert_type(mount.margins(5).of_SN, float | None)
    assert_type(mount.hysteresis(5).f_low, Floats)
    assert_type(mount.isolation(5, level_dB=-20).f, float | None)
    assert_type(mount.isolation(5, level_dB=-20).level_dB, float)
    assert_type(mount.spectrum(f=[3, 4], F=5).A, Floats)
    assert_type(mount.rest().x, Floats)
    assert_type(mount.at_rest().f_0, float | None)
    assert_type(mount.steady_state(f=3, F=5).t, Floats)
    assert_type(mount.exact_response(5, start=mount.steady_state(f=3, F=5)).folds.f, Floats)
    assert_type(mount.sweep(f=[3, 4], F=5).A, Floats)
    assert_type(mount.transient(acceleration=5, duration=0.01).x, Floats)
    assert_type(mount.shock_spectrum(acceleration=[5, 6], duration=0.01).ratio, Floats)
    assert_type(mount.random(psd=([1, 50], [1e-4, 1e-6])).x_rms, Floats)
    assert_type(mount.second_approximation.peak(5).A, float | None)
    assert_type(mount.oscillator.peak(0.04).A, float | None)
    assert_type(mount.many(m=[11.0, 12.0]), PhysicalDesigns)


def many_mounts(mounts: PhysicalDesigns, loaded: PhysicalDesigns) -> None:
    assert_type(mounts.saddle_nodes(F=5, max_count=2).f, Floats)
    assert_type(mounts.amplitudes(f=3, F=5, max_count=2).answer.A, Floats)
    assert_type(mounts.frequency_response(5, f=(1, 3)).fold_f, Floats)
    assert_type(mounts.peak(F=[5.0, 6.0]).A, Floats)
    assert_type(mounts.saddle_node_onset().F_SN, Floats)
    assert_type(mounts.detachment().F_cr, Floats)
    assert_type(mounts.certify(5).proved, Codes)
    assert_type(mounts.margins(5).of_SN, Floats)
    assert_type(mounts.hysteresis(5).f_low, Floats)
    assert_type(mounts.isolation(5, level_dB=-20).f, Floats)
    assert_type(mounts.spectrum(f=[3, 4], F=5).A, Floats)
    assert_type(loaded.rest().x, Floats)
    assert_type(mounts.at_rest().f_0, Floats)
    assert_type(mounts.transient(acceleration=5, duration=0.01).a_max, Floats)
    assert_type(mounts.shock_spectrum(acceleration=5, duration=0.01).ratio, Floats)
    assert_type(mounts.random(psd=([1, 50], [1e-4, 1e-6])).x_rms, Floats)


def maps(grid: PhysicalGrid) -> None:
    assert_type(grid.sizes, dict[str, int])
    grid.peak(F="5 N")
    grid.saddle_nodes(5, max_count=2)
    grid.random(psd=([1.0, 50.0], [1e-4, 1e-6]))


def wrong(iso: Isolator, designs: Designs, mount: Physical, mounts: PhysicalDesigns, grid: PhysicalGrid) -> None:
    grid.peak(G=5)  # type: ignore
    grid.amplitudes(F=5)  # type: ignore
    iso.saddle_nodes("x")  # type: ignore
    iso.amplitudes(Omega="x", F_0=0.04)  # type: ignore
    print(iso.saddle_nodes(0.04).onmega)  # type: ignore
    print(iso.saddle_nodes(0.04)[0].onmega)  # type: ignore
    designs.saddle_nodes("x")  # type: ignore
    print(designs.saddle_nodes(0.04).onmega)  # type: ignore
    designs.peak(0.04, max_count=2)  # type: ignore
    Isolator.physical(m=[1.0], k_v=9000, k_h=4000, L=0.08, preload=0.006)  # type: ignore
    mount.saddle_nodes(F=None)  # type: ignore
    mount.saddle_nodes(F=[5])  # type: ignore
    print(mount.saddle_nodes(5).onmega)  # type: ignore
    print(*mount.saddle_nodes(5)[0])  # type: ignore
    mount.amplitudes(f=None, F=5)  # type: ignore
    mount.frequency_response(5, f="ab")  # type: ignore
    mount.exact_response(5, start=mount.peak(5))  # type: ignore
    mounts.peak(5, max_count=2)  # type: ignore
    mounts.peak(G=5)  # type: ignore
    print(mounts.peak(5).onmega)  # type: ignore
    mounts.amplitudes(F=5)  # type: ignore
    mounts.saddle_nodes(5, f=3)  # type: ignore
    mounts.isolation(5, samples=100)  # type: ignore
