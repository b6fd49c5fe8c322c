"""Maps over named axes, in blocks, in stores that resume: as the same designs in one batch, to the bit."""

from __future__ import annotations

import dataclasses
import os
import pickle
import signal
import subprocess
import sys
import time
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import Barrier

import numpy as np
import pytest

from slowflow import Duffing, Isolator, Oscillator
from slowflow.answers.results import Remark
from slowflow.support.errors import Refused
from slowflow_kernels import rod_spring
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status
from tests.files import Lazily

#: a third of the time of the fast tests went into them
pytestmark = pytest.mark.slow
xarray, dask, lazy, zarr, block = map(Lazily, ("xarray", "dask", "dask.array", "zarr", "slowflow.grid.block"))

R = np.linspace(0.5, 3.0, 7)
PRELOAD = np.linspace(0.1, 1.1, 5)  # the last one is a negative stiffness at rest
#: sticking, without a fold, with folds
FORCES = np.array([0.01, 0.02, 0.05])

ASK = {
    "detachment": {},
    "saddle_node_onset": {},
    "saddle_nodes": {"F_0": FORCES, "max_count": 3},
    "peak": {"F_0": FORCES},
    "amplitudes": {"F_0": FORCES, "Omega": 0.9},
    "certify": {"F_0": FORCES, "Omega": 0.9},
    "frequency_response": {"F_0": FORCES, "samples": 30, "Omega": (0.2, 1.4)},
    "at_rest": {},
    "margins": {"F_0": FORCES},
    "hysteresis": {"F_0": FORCES, "max_count": 2},
    "isolation": {"F_0": FORCES},
    "spectrum": {"Omega": [0.6, 0.9, 1.3, 0.9], "F_0": [0.02, 0.04, 0.04, 0.01]},
    "transient": {"acceleration": 0.3, "duration": 2.0},
    "shock_spectrum": {"acceleration": 0.3, "duration": 2.0},
}


def is_forced(question):
    """Whether it is asked at several forcings."""
    return ASK[question].get("F_0") is FORCES


def axes_of(question):
    """Those of its answer."""
    return ("r", "share", "F_0") if is_forced(question) else ("r", "share")


def arguments_of(question):
    """What it takes, the forcings along an axis of their own."""
    return ASK[question] | ({"F_0": xarray.DataArray(FORCES, dims="F_0")} if is_forced(question) else {})


def axis(name, values):
    return xarray.DataArray(values, dims=name, coords={name: values})


def over(cut=None, **more):
    """Designs over r and preload (axis "share"); one is none, as its r is negative."""
    r, preload = axis("r", np.append(R, -1.0)), axis("share", PRELOAD)
    r, preload = (
        one.chunk({dim: n for dim, n in cut.items() if dim in one.dims}) if cut else one for one in (r, preload)
    )
    return Isolator.many(**{"lam": 3, "r": r, "delta_h": preload / (3 * abs(r)), "mu": 0.012, "zeta": 0.02, **more})


def batch(question, depth=None):
    """The same in one batch of NumPy's arrays; forces along the last axis."""
    r = np.append(R, -1.0)[:, np.newaxis]
    forced = is_forced(question)
    design = {"r": r, "delta_h": PRELOAD / (3 * abs(r))}
    design = {name: value[..., np.newaxis] if forced else value for name, value in design.items()}
    designs = Isolator.many(lam=3, mu=0.012, zeta=0.02, **design)
    return getattr(getattr(designs, depth) if depth else designs, question)(**ASK[question])


def assert_same_bits(found, expected, *dims):
    for name, value in {**expected._content(), "remarks": expected.remarks}.items():
        column = found[name].transpose(*dims, ...)
        assert column.dtype == value.dtype and column.values.tobytes() == value.tobytes(), name


CUTS = {"whole": None, "by r": {"r": 3}, "by both": {"r": 2, "share": 2}}


@pytest.mark.parametrize("cut", CUTS)
@pytest.mark.parametrize("question", ASK)
def test_a_map_is_the_batch_of_its_designs_with_names(question, cut):
    found = getattr(over(CUTS[cut]), question)(**arguments_of(question))
    assert (found["status"].chunks is not None) == (cut != "whole")
    assert_same_bits(found.compute(), batch(question), *axes_of(question))
    codes = set(np.unique(found["status"]))
    assert {Status.OK, Status.INVALID} <= codes


@pytest.mark.parametrize("question", ASK)
def test_a_store_has_the_bits_of_the_batch(question, tmp_path):
    found = over({"r": 3}).store(tmp_path / "map.zarr", question, **arguments_of(question))
    assert_same_bits(found, batch(question), *axes_of(question))
    again = xarray.open_zarr(tmp_path / "map.zarr", consolidated=False)
    assert again.attrs["complete"] == 1 and bool(again["done"].all())


def test_a_store_says_what_is_in_it(tmp_path):
    found = over({"r": 3}).store(tmp_path / "map.zarr", "saddle_nodes", **arguments_of("saddle_nodes"))
    assert dict(found.sizes) == {"r": 8, "share": 5, "F_0": 3, "place": 3}
    assert set(found.coords) == {"lam", "r", "delta_h", "mu", "zeta", "F_0", "share"}
    assert found.attrs["mechanism"] == "rod_spring" and found.attrs["question"] == "saddle_nodes"
    assert (found.attrs["slowflow"], found.attrs["compiled"]) == tuple(block.made_by(rod_spring.MECHANISM).values())
    for name in ("r", "delta_h", "F_0", "Omega", "A"):
        assert found[name].attrs["units"] == "dimensionless" and found[name].attrs["long_name"]
    status = found["status"].attrs
    assert status["flag_values"] == [-1, *Status]
    assert status["flag_meanings"].split() == ["NOT_YET", *(code.name for code in Status)]
    assert "3  NONE" in status["meaning"] and "no such result" in status["meaning"]
    assert found["kind"].attrs["flag_meanings"].split() == [code.name for code in FoldKind]
    masks = dict(
        zip(found["remarks"].attrs["flag_meanings"].split(), found["remarks"].attrs["flag_masks"], strict=True)
    )
    assert masks == {remark.name: remark.value for remark in Remark}
    soft = found["remarks"].sel(share=PRELOAD[-1], F_0=0.05).isel(r=0)
    assert int(soft) & masks["NEGATIVE_STIFFNESS"]


@pytest.mark.parametrize("question", ["detachment", "saddle_node_onset", "saddle_nodes", "peak"])
def test_the_second_approximation_has_maps_too(question, tmp_path):
    found = over({"r": 3}).second_approximation.store(tmp_path / "map.zarr", question, **arguments_of(question))
    assert_same_bits(found, batch(question, "second_approximation"), *axes_of(question))
    assert found.attrs["depth"] == "second approximation"
    with pytest.raises(ValueError, match="depth: second approximation there, averaging here"):
        over().store(tmp_path / "map.zarr", question, **arguments_of(question))


def test_unnamed_dask_numbers_broadcast_as_numpys(tmp_path):
    r, preload = R[:, np.newaxis], PRELOAD
    design = {"r": lazy.from_array(r, chunks=(2, 1)), "delta_h": lazy.from_array(preload / (3 * r), chunks=2)}
    designs = Isolator.many(lam=3, **design, mu=0.012, zeta=0.02)
    expected = Isolator.many(lam=3, r=r, delta_h=preload / (3 * r), mu=0.012, zeta=0.02).peak(FORCES.reshape(3, 1, 1))
    assert designs.shape == (7, 5)
    for found in (
        designs.peak(FORCES.reshape(3, 1, 1)),
        designs.store(tmp_path / "map.zarr", "peak", F_0=FORCES.reshape(3, 1, 1)),
    ):
        assert set(found.sizes) == {"design_0", "design_1", "design_2"}
        assert found["A"].transpose("design_0", "design_1", "design_2").values.tobytes() == expected.A.tobytes()


def test_parameters_too_many_to_read_are_written_by_blocks(tmp_path, monkeypatch):
    monkeypatch.setattr("slowflow.grid.store.READ", 10)
    found = over({"r": 3}).store(tmp_path / "map.zarr", "detachment")
    assert_same_bits(found, batch("detachment"), "r", "share")
    delta_h = found["delta_h"].transpose("r", "share")
    assert delta_h.values.tobytes() == (PRELOAD / (3 * np.append(R, 1.0)[:, np.newaxis])).tobytes()
    assert {"delta_h", "r", "lam"} <= set(found.coords)
    assert over({"r": 3}).store(tmp_path / "map.zarr", "detachment").identical(found)


@pytest.mark.parametrize("designs", [Duffing.many, lambda **numbers: Oscillator.many(rod_spring.MECHANISM, **numbers)])
def test_every_mechanism_takes_named_axes(designs):
    design = {"alpha": 1.0, "beta": axis("beta", R)} if designs == Duffing.many else {"lam": 3, "r": axis("r", R)}
    design |= {} if designs == Duffing.many else {"delta_h": 0.1}
    plain = {name: getattr(value, "values", value) for name, value in design.items()}
    found, expected = (designs(**one, mu=0.01, zeta=0.02).saddle_node_onset() for one in (design, plain))
    assert found["F_SN"].values.tobytes() == expected.F_SN.tobytes()


def test_one_design_is_a_map_without_axes(tmp_path):
    one = Isolator.many(lam=3, r=xarray.DataArray(1.0), delta_h=0.2, zeta=0.02, mu=0.01)
    assert float(one.store(tmp_path / "map.zarr", "peak", F_0=0.05)["A"]) == float(one.peak(0.05)["A"])


def test_uncut_axes_are_cut_into_ordinary_blocks(tmp_path, monkeypatch):
    monkeypatch.setattr("slowflow.grid.designs.AT_ONCE", 12)
    over().store(tmp_path / "map.zarr", "detachment")
    group = zarr.open_group(tmp_path / "map.zarr", mode="r")
    assert int(np.prod(group["F_cr"].chunks)) <= 12 and group["done"].size >= 4


def test_a_question_pickles():
    ask, values = over()._query("peak", 1, F_0=0.05)
    numbers = [value.values for value in (values["lam"], values["r"][0], values["delta_h"][0, 0])]
    copy = pickle.loads(pickle.dumps(ask))
    assert copy(*numbers, 0.012, 0.02, 0.05) == ask(*numbers, 0.012, 0.02, 0.05)


def test_tables_and_records_may_differ_from_design_to_design(tmp_path):
    """Rows lie along "row", samples along "instant"; what is plain is the same for all."""
    forces = xarray.DataArray(np.outer(np.append(R, 1.0), [0.01, 0.02, 0.03]), dims=("r", "row"))
    designs, Omega = over({"r": 3}), [0.7, 0.9, 1.1]
    r = np.append(R, -1.0)[:, np.newaxis]
    plain = Isolator.many(lam=3, r=r, delta_h=PRELOAD / (3 * abs(r)), mu=0.012, zeta=0.02)
    expected = plain.spectrum(Omega=Omega, F_0=forces.values[:, np.newaxis, :])
    for found in (
        designs.spectrum(Omega=Omega, F_0=forces),
        designs.store(tmp_path / "rows.zarr", "spectrum", Omega=Omega, F_0=forces),
    ):
        assert dict(found.sizes) == {"r": 8, "share": 5, "row": 3} and found["Omega"].values.tolist() == Omega
        assert found["transmissibility_dB"].attrs["units"] == "dB"
        assert_same_bits(found, expected, "r", "share", "row")
    tau = np.linspace(0, 2, 12)
    pulse = np.outer(np.linspace(0.1, 0.3, 8), np.sin(np.pi * tau / 2))
    expected = plain.transient(tau=tau, acceleration=pulse[:, np.newaxis, :], after=3.0)
    record = {"tau": tau, "acceleration": xarray.DataArray(pulse, dims=("r", "instant")), "after": 3.0}
    for found in (designs.transient(**record), designs.store(tmp_path / "records.zarr", "transient", **record)):
        assert_same_bits(found, expected, "r", "share")
    assert designs.spectrum(Omega=0.9, F_0=0.04)["A"].sizes["row"] == 1
    with pytest.raises(ValueError, match="several axes without names"):
        designs.spectrum(Omega=[[0.9], [1.0]], F_0=0.04)
    with pytest.raises(ValueError, match="either its duration"):
        designs.transient(acceleration=0.3)


def test_maps_under_a_load_have_the_answers_of_the_batch(tmp_path):
    load = axis("load", np.array([0.3, 0.2, -0.1]))
    designs = Duffing.many(alpha=1.0, beta=0.5, mu=0.01, zeta=0.05, load=load.chunk(load=2))
    plain = Duffing.many(1.0, 0.5, 0.01, 0.05, load=load.values)
    for question, arguments in {
        "rest": {},
        "detachment": {},
        "saddle_nodes": {"F_0": 0.2},
        "amplitudes": {"F_0": 0.2, "Omega": 1.2},
        "peak": {"F_0": 0.2},
        "margins": {"F_0": 0.2},
        "hysteresis": {"F_0": 0.2},
        "spectrum": {"Omega": [1.0, 1.3], "F_0": [0.2, 0.2]},
        "shock_spectrum": {"acceleration": 0.5, "duration": 2.0},
        "transient": {"acceleration": 0.5, "duration": 2.0},
    }.items():
        expected = getattr(plain, question)(**arguments)
        found = designs.store(tmp_path / f"{question}.zarr", question, **arguments)
        assert {"B", "stands"} & set(found) or question not in ("amplitudes", "transient")
        assert_same_bits(found, expected, "load")
    for refused in (lambda: designs.certify(0.2), lambda: designs.at_rest(), lambda: designs.second_approximation):
        with pytest.raises(ValueError, match="assumes motion about the centre"):
            refused()
    with pytest.raises(ValueError, match="rest is not available for many designs without a load"):
        over().rest()


def test_each_column_of_a_map_says_what_it_is():
    found = over().margins(F_0=0.05)
    assert all(found[name].attrs["long_name"] for name in (*found.data_vars, "F_0", "mu"))
    assert not any({"units", "flag_meanings"} <= column.attrs.keys() for column in found.variables.values())
    assert found["kind"].attrs["flag_meanings"].split() == [code.name for code in OnsetKind]
    assert found["onset"].attrs["flag_meanings"].split() == [code.name for code in Status]
    with pytest.raises(ValueError, match="cannot be named row"):
        Duffing.many(alpha=1.0, beta=axis("row", R), mu=0.0, zeta=0.1).peak(0.1)


# ---- stopped and continued


def blocks_asked(monkeypatch, stop_after=None):
    """Counts the blocks that are computed, and fails after some."""
    calls = []
    answer = block.Ask.__call__

    def counted(self, *values):
        if len(calls) == stop_after:
            raise KeyboardInterrupt
        calls.append(values)
        return answer(self, *values)

    monkeypatch.setattr(block.Ask, "__call__", counted)
    return calls


def files(folder):
    """Every file of a store with its bytes."""
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("written", [0, 1, 5])
def test_a_map_that_was_stopped_is_continued_with_the_same_bits(written, tmp_path, monkeypatch):
    over({"r": 2, "share": 2}).store(tmp_path / "whole.zarr", "saddle_node_onset")
    path = tmp_path / "map.zarr"
    with monkeypatch.context() as patched, dask.config.set(scheduler="synchronous"):
        blocks_asked(patched, stop_after=written)
        with pytest.raises(KeyboardInterrupt):
            over({"r": 2, "share": 2}).store(path, "saddle_node_onset")
    part = xarray.open_zarr(path, consolidated=False)
    assert part.attrs["complete"] == 0 and int(part["done"].sum()) == written
    # what is not computed says so
    missing = part["status"] == -1
    assert bool(missing.any()) and bool(part["F_SN"].where(missing).isnull().all())
    calls = blocks_asked(monkeypatch)
    over({"r": 2, "share": 2}).store(path, "saddle_node_onset")
    assert len(calls) == 12 - written
    assert files(path) == files(tmp_path / "whole.zarr")
    over({"r": 2, "share": 2}).store(path, "saddle_node_onset")
    assert len(calls) == 12 - written


def test_store_stopped_before_preparation_is_prepared_anew(tmp_path, monkeypatch):
    path = tmp_path / "map.zarr"

    def stopped(*args, **more):
        raise KeyboardInterrupt

    for broken in ("xarray.Dataset.to_zarr", "zarr.Group.create_array"):
        with monkeypatch.context() as patched:
            patched.setattr(broken, stopped)
            with pytest.raises(KeyboardInterrupt):
                over().store(path, "detachment")
    found = over().store(path, "detachment")
    assert_same_bits(found, batch("detachment"), "r", "share")
    assert set(found.coords) == {"lam", "r", "delta_h", "mu", "zeta", "share"}


@pytest.mark.parametrize("written", [1, 4, 6, 13])
def test_block_stopped_while_written_is_written_again(written, tmp_path, monkeypatch):
    """Of the six arrays of a block some are written: it is not ticked off."""
    over({"r": 3}).store(tmp_path / "whole.zarr", "detachment")
    path, put, puts = tmp_path / "map.zarr", zarr.Array.__setitem__, []

    def stopped(self, *args):
        if "done" in self.name or self.name.strip("/") in over()._query("detachment", 1)[0].columns:
            if len(puts) == written:
                raise KeyboardInterrupt
            puts.append(self.name)
        put(self, *args)

    with monkeypatch.context() as patched, dask.config.set(scheduler="synchronous"):
        patched.setattr(zarr.Array, "__setitem__", stopped)
        with pytest.raises(KeyboardInterrupt):
            over({"r": 3}).store(path, "detachment")
    assert ticked(path) == sum("done" in name for name in puts) == written // 6
    over({"r": 3}).store(path, "detachment")
    assert files(path) == files(tmp_path / "whole.zarr")


@pytest.mark.filterwarnings("ignore:Object at zarr.*partial")  # Zarr sees what the other one is about to write
def test_two_writers_of_one_store_do_no_harm(tmp_path):
    over({"r": 2}).store(tmp_path / "whole.zarr", "saddle_node_onset")
    path = tmp_path / "map.zarr"
    with dask.config.set(scheduler="synchronous"), pytest.MonkeyPatch.context() as patched:
        blocks_asked(patched, stop_after=1)
        with pytest.raises(KeyboardInterrupt):
            over({"r": 2}).store(path, "saddle_node_onset")
    with ThreadPoolExecutor(2) as pool:
        both = [pool.submit(over({"r": 2}).store, path, "saddle_node_onset") for _ in range(2)]
        one, other = (each.result() for each in both)
    assert one.identical(other) and files(path) == files(tmp_path / "whole.zarr")


@pytest.mark.filterwarnings("ignore:Object at zarr.*partial")  # Zarr sees what another one is about to write
def test_writers_that_begin_together_do_no_harm(tmp_path):
    over({"r": 3}).store(tmp_path / "whole.zarr", "detachment")
    for number in range(4):
        path, together = tmp_path / f"{number}.zarr", Barrier(3)

        def begin(path=path, together=together):
            together.wait()
            return over({"r": 3}).store(path, "detachment")

        with ThreadPoolExecutor(3) as pool:
            found = [each.result() for each in [pool.submit(begin) for _ in range(3)]]
        assert all(one.identical(found[0]) for one in found)
        assert files(path) == files(tmp_path / "whole.zarr")


@pytest.mark.parametrize("of", ["Omega", "status", "r", "mu"])
@pytest.mark.parametrize("damage", ["missing", "garbled"])
def test_damaged_chunk_is_computed_again(of, damage, tmp_path):
    over({"r": 3}).store(tmp_path / "map.zarr", "saddle_nodes", F_0=0.05)
    whole = files(tmp_path / "map.zarr")
    chunk = min(tmp_path / "map.zarr" / name for name in whole if name.startswith(f"{of}/c"))
    if damage == "missing":
        chunk.unlink()
    else:
        content = bytearray(chunk.read_bytes())
        content[-1] ^= 1  # of the checksum
        chunk.write_bytes(content)
    over({"r": 3}).store(tmp_path / "map.zarr", "saddle_nodes", F_0=0.05)
    assert files(tmp_path / "map.zarr") == whole


@pytest.mark.parametrize("of", ["zarr.json", "status/zarr.json", "done/zarr.json", "done/c/0/0"])
@pytest.mark.parametrize("content", ["{", '{"zarr_format": 3, "node_type": "array"}'])
def test_damaged_metadata_are_refused_with_their_name(of, content, tmp_path):
    over({"r": 3}).store(tmp_path / "map.zarr", "detachment")
    (tmp_path / "map.zarr" / of).write_text(content)
    before = files(tmp_path / "map.zarr")
    name = "done" if of.startswith("done/c") else of
    with pytest.raises(Refused, match=rf"map\.zarr is damaged and is unchanged: {name} cannot be read \(.*delete"):
        over({"r": 3}).store(tmp_path / "map.zarr", "detachment")
    assert files(tmp_path / "map.zarr") == before


def test_a_store_keeps_the_numbers_and_not_how_they_came(tmp_path):
    """Numbers read from a file bring an encoding along, which may round."""
    data = xarray.Dataset({"delta_h": ("share", PRELOAD / 7)}, coords={"share": PRELOAD / 3})
    data["delta_h"].encoding = data["share"].encoding = {"dtype": np.dtype("float32"), "_FillValue": -9.0}
    designs = Isolator.many(lam=3, r=1, delta_h=data["delta_h"], zeta=0.01)
    found = designs.store(tmp_path / "map.zarr", "detachment")
    assert found["delta_h"].values.tobytes() == (PRELOAD / 7).tobytes()
    assert found["share"].values.tobytes() == (PRELOAD / 3).tobytes()


def test_a_store_of_zarr_that_is_no_folder_is_filled():
    memory = zarr.storage.MemoryStore()
    assert_same_bits(over({"r": 3}).store(memory, "detachment"), batch("detachment"), "r", "share")
    assert over({"r": 3}).store(memory, "detachment").attrs["complete"] == 1


def test_a_map_without_designs_is_complete(tmp_path):
    found = Isolator.many(lam=3, r=axis("r", R[:0]), delta_h=0.1).store(tmp_path / "map.zarr", "detachment")
    assert found.sizes["r"] == 0 and found.attrs["complete"] == 1


PROGRAM = """
import sys, numpy as np, xarray
from slowflow import Isolator
r = xarray.DataArray(np.linspace(0.5, 3, 40), dims="r").chunk(r=1)
share = xarray.DataArray(np.linspace(0.1, 0.9, 2000), dims="share")
Isolator.many(lam=3, r=r, delta_h=share / (3 * r), mu=0.012, zeta=0.02).store(sys.argv[1], "saddle_node_onset")
"""


def written(path):
    """The files of the blocks that are written; what a process was killed at has another name still."""
    return [file for file in path.glob("done/c/**/*") if file.is_file() and file.name.isdigit()]


def ticked(path):
    """How many these are."""
    return len(written(path))


def wait_for(path, blocks, alive):
    """Until so many blocks are written, or the work has ended."""
    end = time.monotonic() + 60
    while ticked(path) < blocks and alive() and time.monotonic() < end:
        time.sleep(0.002)


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGKILL")
def test_a_process_that_was_killed_is_continued_by_another(tmp_path):
    path = tmp_path / "map.zarr"
    with subprocess.Popen([sys.executable, "-c", PROGRAM, str(path)]) as process:
        wait_for(path, 5, lambda: process.poll() is None)
        process.kill()
    assert process.returncode == -signal.SIGKILL
    before = ticked(path)
    assert 5 <= before < 40 and xarray.open_zarr(path, consolidated=False).attrs["complete"] == 0
    kept = {file: file.stat().st_mtime_ns for file in written(path)}
    subprocess.run([sys.executable, "-c", PROGRAM, str(path)], check=True)
    assert ticked(path) == 40 and {file: file.stat().st_mtime_ns for file in kept} == kept
    found = xarray.open_zarr(path, consolidated=False)
    assert found.attrs["complete"] == 1
    r = np.linspace(0.5, 3, 40)[:, np.newaxis]
    whole = Isolator.many(lam=3, r=r, delta_h=np.linspace(0.1, 0.9, 2000) / (3 * r), mu=0.012, zeta=0.02)
    assert found["F_SN"].values.tobytes() == whole.saddle_node_onset().F_SN.tobytes()


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGKILL")
@pytest.mark.night
def test_cluster_with_a_killed_worker_gives_the_same_bits(tmp_path):
    distributed = pytest.importorskip("distributed", reason="the extra `grid` is not installed: distributed")
    path = tmp_path / "map.zarr"
    r = np.linspace(0.5, 3, 60)
    preload = np.linspace(0.1, 0.9, 2000)
    designs = Isolator.many(
        lam=3,
        r=xarray.DataArray(r, dims="r").chunk(r=1),
        delta_h=xarray.DataArray(preload, dims="share") / (3 * xarray.DataArray(r, dims="r")),
        mu=0.012,
        zeta=0.02,
    )
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        processes = sorted(client.run(os.getpid).values())
        watch = subprocess.Popen([sys.executable, "-c", KILLER, str(path), str(processes[0])])
        found = designs.store(path, "saddle_node_onset")
        assert watch.wait(timeout=60) == 0
        now = sorted(client.run(os.getpid).values())
    assert processes[0] not in now
    r = r[:, np.newaxis]
    whole = Isolator.many(lam=3, r=r, delta_h=preload / (3 * r), mu=0.012, zeta=0.02).saddle_node_onset()
    assert found["F_SN"].values.tobytes() == whole.F_SN.tobytes()
    assert found["remarks"].values.tobytes() == whole.remarks.tobytes()
    assert found.attrs["complete"] == 1


#: kills a process as soon as some blocks are ticked off, and says whether there were others left to do
KILLER = """
import os, pathlib, signal, sys, time
done, end = pathlib.Path(sys.argv[1], "done"), time.monotonic() + 50
def ticked(): return len([file for file in done.glob("c/**/*") if file.is_file() and file.name.isdigit()])
while ticked() < 10 and time.monotonic() < end: time.sleep(0.002)
os.kill(int(sys.argv[2]), signal.SIGKILL)
sys.exit(not 10 <= ticked() < 60)
"""


# ---- refused


@pytest.mark.parametrize(
    ("change", "named"),
    [
        (lambda: {"zeta": 0.03}, "zeta"),
        (lambda: {"lam": axis("r", np.append(R, -1.0)), "delta_h": 0.1}, "delta_h: .* lam: "),
        (lambda: {"mu": axis("mu", np.array([0.01, 0.02]))}, "axes"),
    ],
    ids=["another number", "other numbers", "another axis"],
)
def test_a_store_of_other_numbers_is_left_alone(change, named, tmp_path):
    over().store(tmp_path / "map.zarr", "detachment")
    before = files(tmp_path / "map.zarr")
    with pytest.raises(ValueError, match=named):
        over(**change()).store(tmp_path / "map.zarr", "detachment")
    with pytest.raises(ValueError, match="question: detachment there, saddle_node_onset here"):
        over().store(tmp_path / "map.zarr", "saddle_node_onset")
    assert files(tmp_path / "map.zarr") == before


def test_a_store_of_another_forcing_shows_both(tmp_path):
    over().store(tmp_path / "map.zarr", "peak", F_0=0.04)
    with pytest.raises(ValueError, match=r"F_0: \[\[\], 0\.04\] there, \[\[\], 0\.05\] here"):
        over().store(tmp_path / "map.zarr", "peak", F_0=0.05)


def test_a_map_is_of_one_version(tmp_path, monkeypatch):
    over().store(tmp_path / "map.zarr", "detachment")
    ask, values = over()._query("detachment", 1)
    monkeypatch.setattr("slowflow.grid.block.__version__", "0.0.0")
    with pytest.raises(ValueError, match=r"slowflow: .* there, 0\.0\.0 here"):
        over().store(tmp_path / "map.zarr", "detachment")
    with pytest.raises(RuntimeError, match=r"this process runs .*0\.0\.0"):
        ask(*(value.values for value in values.values()))


def test_what_is_there_already_is_not_written_over(tmp_path):
    (tmp_path / "notes").mkdir()
    (tmp_path / "notes" / "a.txt").write_text("mine")
    with pytest.raises(FileExistsError, match="not a Zarr store"):
        over().store(tmp_path / "notes", "detachment")
    with pytest.raises(FileExistsError, match="not a Zarr store"):
        over().store(tmp_path / "notes" / "a.txt", "detachment")
    xarray.Dataset({"x": ("y", [1.0])}).to_zarr(tmp_path / "other.zarr", consolidated=False)
    with pytest.raises(FileExistsError, match="not that of a map"):
        over().store(tmp_path / "other.zarr", "detachment")
    assert float(xarray.open_zarr(tmp_path / "other.zarr", consolidated=False)["x"][0]) == 1.0


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"question": "peaks"}, ValueError, "question"),
        ({"question": "peak"}, TypeError, r"peak takes F_0, workers: .*'F_0'"),
        ({"question": "detachment", "F_0": 0.1}, TypeError, "detachment has no argument 'F_0'"),
        ({"question": "peak", "F_0": 0.1, "max_count": 2}, TypeError, "one of F_0, workers"),
        ({"question": "peak", "F_0": "0.1"}, ValueError, "F_0"),
        ({"question": "saddle_nodes", "F_0": 0.1, "max_count": 0}, ValueError, "max_count"),
        ({"question": "peak", "F_0": 0.1, "workers": 0}, ValueError, "workers"),
        ({"question": "peak", "F_0": lambda: axis("r", R)}, ValueError, "r"),
        ({"question": "peak", "F_0": lambda: axis("status", R)}, ValueError, "cannot be named status"),
        ({"question": "peak", "F_0": R}, ValueError, "axes without names"),
        ({"question": "peak", "F_0": lambda: axis("F_0", R).assign_attrs(units="N")}, ValueError, "F_0 has units"),
    ],
)
def test_bad_questions_are_refused_before_anything_is_written(arguments, error, message, tmp_path):
    arguments = {name: value() if callable(value) else value for name, value in arguments.items()}
    with pytest.raises(error, match=message):
        over().store(tmp_path / "map.zarr", **arguments)
    assert not (tmp_path / "map.zarr").exists()


def repeated_axis():
    """What xarray lets one make, with a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return {"r": xarray.DataArray([R[:1]], dims=["x", "x"])}


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        (lambda: {"r": axis("r", np.array(["a", "b"]))}, ValueError, "r holds"),
        (lambda: {"r": lazy.ones(3, dtype=complex)}, ValueError, "r holds complex128"),
        (lambda: {"r": axis("r", R).assign_attrs(units="N/m")}, ValueError, "r has units = 'N/m': it must be dimensio"),
        (lambda: {"r": axis("x", R), "delta_h": axis("x", R[:3])}, ValueError, "x"),
        (lambda: {"r": axis("x", R), "delta_h": axis("x", R + 1)}, ValueError, "x"),
        (lambda: {"r": axis("x", R), "delta_h": R}, ValueError, "delta_h has axes without names"),
        (lambda: {"r": lazy.ones(3), "delta_h": R}, ValueError, "do not broadcast"),
        (
            lambda: {"r": xarray.DataArray(R, dims="r", coords={"r": R + 1})},
            ValueError,
            "the coordinate r differs from the values of r",
        ),
        (lambda: {"r": axis("delta_h", R), "delta_h": 0.1}, ValueError, "an axis is named delta_h"),
        (lambda: {"r": xarray.DataArray(R, dims=[3])}, ValueError, "names of axes must be strings"),
        (repeated_axis, ValueError, "r has the axes x, x: each name"),
        (lambda: {"r": lazy.ones(3)[lazy.ones(3) > 0]}, ValueError, "unknown length"),
        (lambda: {"r": axis("r", R), "stiffness": 1}, TypeError, "stiffness"),
    ],
)
def test_bad_numbers_are_refused(arguments, error, message):
    with pytest.raises(error, match=message):
        Oscillator.many(rod_spring.MECHANISM, **{"lam": 3, "delta_h": 0.1, **arguments()})


def test_a_force_with_named_axes_is_not_taken_for_one_without():
    with pytest.raises(ValueError, match="F_0 has named axes"):
        Isolator.many(lam=3, r=R, delta_h=0.1).peak(axis("F_0", R))


def test_the_second_approximation_proves_nothing(tmp_path):
    with pytest.raises(ValueError, match="proofs concern the averaged equations"):
        over().second_approximation.store(tmp_path / "map.zarr", "certify", F_0=0.05)


def test_a_mechanism_that_other_processes_cannot_find_is_refused(tmp_path):
    own = dataclasses.replace(rod_spring.MECHANISM, hardening=lambda *parameters: (0.0,))
    designs = Oscillator.many(own, lam=3, r=axis("r", R), delta_h=0.1)
    assert designs.peak(0.05)["A"].shape == (7,)
    with pytest.raises(ValueError, match="cannot be sent to other processes"):
        designs.store(Path(tmp_path) / "map.zarr", "detachment")


def test_a_map_of_a_record_that_was_changed_is_another_map(tmp_path):
    of = {"lam": 3, "r": axis("r", R), "delta_h": 0.1}
    Oscillator.many(rod_spring.MECHANISM, **of).store(tmp_path / "map.zarr", "detachment")
    own = dataclasses.replace(rod_spring.MECHANISM, reach=0.5)
    with pytest.raises(ValueError, match=r"begun with other values.*record"):
        Oscillator.many(own, **of).store(tmp_path / "map.zarr", "detachment")


def test_a_package_that_is_missing_is_named(monkeypatch, tmp_path):
    designs = over()
    for package in ("dask", "zarr"):
        with monkeypatch.context() as patched:
            patched.setitem(sys.modules, package, None)
            patched.delitem(sys.modules, "slowflow.grid.store")
            with pytest.raises(ImportError, match=rf"needs {package}: pip install 'slowflow\[grid\]'"):
                designs.store(tmp_path / "map.zarr", "detachment")
