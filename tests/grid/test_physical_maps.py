"""Maps of mounts in SI units and their stores: each mount as single, with the bits of a batch, and with units."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers.table import OFFSET, QUESTIONS, SECOND
from slowflow_kernels.conventions import Status
from tests.files import Lazily
from tests.oscillators.test_physical_designs import LOADED, SHEET, answered, arguments, single_columns

pytestmark = pytest.mark.slow
xarray, zarr = map(Lazily, ("xarray", "zarr"))

#: data that vary along two axes; the last mass is none
MASSES = np.array([22.0, 25.0, 27.0, -1.0])
LENGTHS = np.array([0.075, 0.08])
PRELOADS = np.outer([0.004, 0.006, 0.008, 0.006], LENGTHS) / 0.08


def axis(name, values, **attributes):
    return xarray.DataArray(values, dims=name, coords={name: values}, attrs=attributes)


def over(mount, cut=0, count=None):
    """Mounts over m and L, of a preload that depends on both; in blocks of m. `count` is how many of either."""
    m, preload = axis("m", MASSES[:count]), xarray.DataArray(PRELOADS[:count, :count], dims=("m", "L"))
    m, preload = (one.chunk(m=cut) if cut else one for one in (m, preload))
    return mount.many(m=m, L=axis("L", LENGTHS[:count]), preload=preload)


def batch(mount, count=None):
    """The same in one batch."""
    return mount.many(m=MASSES[:count, np.newaxis], L=LENGTHS[:count], preload=PRELOADS[:count, :count])


def assert_same_bits(found, expected):
    for name, value in {**expected.values, "remarks": expected.remarks}.items():
        column = found[name].transpose("m", "L", ...)
        assert column.dtype == value.dtype and column.values.tobytes() == value.tobytes(), name
        plain = "" if "flag_meanings" in column.attrs else "dB" if name.endswith("_dB") else "dimensionless"
        assert column.attrs.get("units", "") == expected.units.get(name, plain), name


def test_a_map_of_motions_in_time_names_no_other_excitation():
    """Of a base under a spectral density it said "force"."""
    found = over(Isolator.physical(**SHEET)).random(psd=([1.0, 100.0], [1e-4, 1e-4]))
    assert "excitation" not in found.attrs and found.attrs["question"] == "random"


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("excitation, load", [("force", {}), ("force", LOADED), ("base", {}), ("acceleration", {})])
def test_a_map_and_its_store_have_the_bits_of_the_batch(question, excitation, load):
    mount, count = Isolator.physical(**SHEET, **load, excitation=excitation), 1 if load else None
    expected = answered(batch(mount, count), question, excitation)
    designs, files = over(mount, 2, count), {}
    memory = zarr.storage.MemoryStore(files)
    if isinstance(expected, str):
        with pytest.raises(ValueError) as refused:
            designs.store(memory, question, **arguments(question, excitation))
        assert str(refused.value) == expected and not files
        return
    stored = designs.store(memory, question, **arguments(question, excitation))
    assert_same_bits(stored.load(), expected)
    if not load:  # tenths of a second each
        assert_same_bits(getattr(designs, question)(**arguments(question, excitation)).load(), expected)
        assert (stored["status"].sel(m=-1.0) == Status.INVALID).all()


@pytest.mark.parametrize("question", [name for name, row in QUESTIONS.items() if {OFFSET} != set(row.columns)])
def test_each_mount_of_a_map_is_answered_as_single(question):
    mount = Isolator.physical(**SHEET)
    found = getattr(over(mount), question)(**arguments(question, "force"))
    k, j = 1, 0
    single = answered(mount.replace(m=MASSES[k], L=LENGTHS[j], preload=PRELOADS[k, j]), question, "force")
    for name, value in single_columns(single, set(found.data_vars) - {"remarks"}):
        column = found[name].isel(m=k, L=j).values
        if question == "margins" and np.isinf(column):
            column = np.nan  # where there is no such forcing
        np.testing.assert_allclose(column[: value.size] if column.ndim else column, value, rtol=1e-9, err_msg=name)


@pytest.mark.parametrize("question", [name for name, row in QUESTIONS.items() if SECOND in row.columns])
def test_second_approximations_have_maps_in_si_units(question):
    mount = Isolator.physical(**SHEET)
    found = getattr(over(mount).second_approximation, question)(**arguments(question, "force"))
    assert_same_bits(found, answered(batch(mount).second_approximation, question, "force"))


def test_a_store_is_read_back_in_si_units(tmp_path):
    mount = Isolator.physical(**SHEET, c_xx=20.0)
    designs, F = over(mount, cut=2), axis("F", [10.0, 20.0])
    designs.store(tmp_path / "map.zarr", "saddle_nodes", F=F, max_count=3)
    found = xarray.open_zarr(tmp_path / "map.zarr", consolidated=False)
    assert (
        found.attrs["complete"] == 1 and found.attrs["excitation"] == "force" and found.attrs["force"] == "untruncated"
    )
    units = {name: column.attrs.get("units") for name, column in found.variables.items() if name != "done"}
    assert units == {
        **{"m": "kg", "k_v": "N/m", "k_h": "N/m", "L": "m", "preload": "m", "friction": "N", "c_xx": "N s/m^3"},
        **{"F": "N", "f": "Hz", "A": "m", "kind": None, "status": None, "remarks": None},
        **dict.fromkeys(("n", "zeta", "count", "undecided"), "dimensionless"),
    }
    assert "mass" in found["m"].attrs["long_name"]
    # its own data make the same map again, which is complete: nothing is computed
    data = {name: found[name] for name in designs.values}
    again = mount.many(**{name: value.load() for name, value in data.items()})
    ticked = [path.stat().st_mtime_ns for path in sorted((tmp_path / "map.zarr" / "done").rglob("*"))]
    again.store(tmp_path / "map.zarr", "saddle_nodes", F=F, max_count=3)
    with pytest.raises(ValueError, match="F: "):
        again.store(tmp_path / "map.zarr", "saddle_nodes", F=2 * F, max_count=3)
    assert_same_bits(again.peak(F=20.0), batch(mount).peak(F=20.0))
    assert ticked == [path.stat().st_mtime_ns for path in sorted((tmp_path / "map.zarr" / "done").rglob("*"))]


def test_a_window_in_hertz_and_that_of_each_mount(tmp_path):
    mount = Isolator.physical(**SHEET)
    designs = over(mount)
    for window in ({}, {"f": ("1 Hz", 5.0)}):
        found = designs.store(tmp_path / f"{len(window)}.zarr", "frequency_response", F=20.0, samples=30, **window)
        assert_same_bits(found, batch(mount).frequency_response(F=20.0, samples=30, **window))
    with pytest.raises(ValueError, match=r"f: \[1\.0, 5\.0\] there, \[1\.0, 6\.0\] here"):
        designs.store(tmp_path / "1.zarr", "frequency_response", F=20.0, samples=30, f=(1.0, 6.0))


def test_units_of_labelled_arrays_are_converted(tmp_path):
    pint = pytest.importorskip("pint")
    mount = Isolator.physical(**SHEET)
    expected = mount.many(L=LENGTHS).peak(F=[10.0, 20.0])
    in_mm, newtons = 1000 * LENGTHS, np.array([10.0, 20.0])
    quantity = pint.UnitRegistry().Quantity
    for L in (axis("L", in_mm, units="mm"), xarray.DataArray(quantity(in_mm, "mm"), dims="L")):
        designs = mount.many(L=L)
        assert mount.many(**designs.values) == designs  # in SI units, with no attribute of another
        found = designs.peak(F=xarray.DataArray(newtons / 1000, dims="L", attrs={"units": "kN"}))
        np.testing.assert_allclose(found.A.values, expected.A, rtol=1e-12)
        np.testing.assert_allclose(found.L.values, LENGTHS, rtol=1e-15)
        assert found.L.attrs["units"] == "m" and found.F.attrs["units"] == "N"


@pytest.mark.parametrize(
    ("data", "named", "message"),
    [
        ({"L": "kg"}, {"F": 20.0}, "L has units = 'kg': they must be one of m, mm, um, in"),
        ({"n": "m"}, {"F": 20.0}, "n has units = 'm': it must be dimensionless"),
        ({}, {"F": "20 m"}, "F = '20 m' is not allowed"),
        ({}, {"F": lambda: axis("F", [1.0], units="mm")}, "F has units = 'mm'"),
        ({}, {"U": 1.0}, "the amplitude of the excitation is needed once, F in N: got U"),
        ({}, {"F": lambda: axis("A", [1.0])}, "cannot be named A"),
        ({}, {"F": 20.0, "workers": 0}, "workers"),
        ({"static_friction": "N"}, {"F": 20.0}, "static_friction is not available for many mounts"),
    ],
)
def test_a_wrong_unit_is_refused_before_any_file(data, named, message, tmp_path):
    named = {name: value() if callable(value) else value for name, value in named.items()}
    labelled = {name: axis(name, [4.0], units=unit) for name, unit in data.items()}
    with pytest.raises((ValueError, TypeError), match=message):
        Isolator.physical(**SHEET).many(m=axis("m", MASSES), **labelled).store(tmp_path / "map.zarr", "peak", **named)
    assert not (tmp_path / "map.zarr").exists()


def test_other_coordinates_of_one_axis_are_named():
    """Numbers in mm along an axis of their own name have their coordinate in m."""
    preload = xarray.DataArray([6.0, 8.0], dims="L", coords={"L": [75.0, 80.0]}, attrs={"units": "mm"})
    message = r"L and preload have different coordinates along the axis L: \[0.075 0.08 \] and \[75. 80.\]"
    with pytest.raises(ValueError, match=message):
        Isolator.physical(**SHEET).many(L=axis("L", [75.0, 80.0], units="mm"), preload=preload)


def test_base_excitation_takes_displacement_or_acceleration():
    mount = Isolator.physical(**SHEET, excitation="base")
    found = over(mount).peak(a=0.8)
    assert_same_bits(found, batch(mount).peak(a=0.8))
    assert found.attrs["excitation"] == "acceleration" and found.a.attrs["units"] == "m/s^2"
    found = over(mount).detachment()
    assert set(found.data_vars) == {"Y_cr", "f_cr", "x_cr", "status", "remarks"}
    assert found.Y_cr.attrs["long_name"] == "lowest forcing that reaches x_cr (34)"


def test_data_in_another_unit_are_noted_of_a_map():
    mount = Isolator.physical(**SHEET)
    with pytest.warns(UserWarning, match="L = 90 m is a push-rod as long as a house"):
        mount.many(L=axis("L", [80.0, 90.0]), m=axis("m", np.linspace(20.0, 30.0, 2000)).chunk(m=10).compute())
    with pytest.warns(UserWarning, match="is it in rpm") as warned:
        over(mount).amplitudes(f=900.0, F=20.0)
    assert {one.filename for one in warned} == {__file__}


def test_maps_of_mounts_pickle_and_compare():
    mount = Duffing.physical(m=12, k_1=2500, k_3=4e5, friction=0.4, c=8.0, c_3="2 N s^3/m^3")
    designs = mount.many(m=axis("m", [11.0, 12.0]), k_1=axis("k_1", [2000.0, -500.0]))
    assert pickle.loads(pickle.dumps(designs)) == designs and hash(designs) == hash(mount.many(**designs.values))
    assert designs != mount.many(m=axis("m", [11.0, 13.0])) and designs.sizes == {"m": 2, "k_1": 2}
    expected = mount.replace(m=12.0, k_1=-500.0).peak(F=5.0)
    np.testing.assert_allclose(designs.peak(F=5.0).A.sel(m=12.0, k_1=-500.0), expected.A, rtol=1e-9)
