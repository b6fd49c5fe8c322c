"""A map of designs in a store on disk, block by block: after an interruption, run it again to resume.

Needs `pip install 'slowflow[grid]'`. With `dask.distributed.Client(...)` before it the blocks go to a cluster.
"""

import tempfile
from pathlib import Path

import numpy as np
import xarray

from slowflow import Isolator


def axis(name, numbers):
    """Numbers along an axis of their own name."""
    return xarray.DataArray(numbers, dims=name, coords={name: numbers})


r = axis("r", np.linspace(0.5, 3.0, 24)).chunk(r=8)  # three blocks along r; a map of 10^9 has some thousand
preload = axis("preload", np.linspace(0.1, 0.9, 17))  # relative to the preload of quasi-zero stiffness
mu = axis("mu", np.array([0.0, 0.01, 0.02]))
designs = Isolator.many(lam=3, r=r, delta_h=preload / (3 * r), mu=mu, zeta=0.02)

with tempfile.TemporaryDirectory() as folder:  # give a map that you keep a permanent path
    onset = designs.store(Path(folder) / "onset.zarr", "saddle_node_onset")
    print(f"{onset.attrs['question']} of {onset.attrs['mechanism']}, slowflow {onset.attrs['slowflow']}")
    print(", ".join(f"{name}: {size}" for name, size in onset.sizes.items()))
    print("status:", onset["status"].attrs["flag_meanings"])

    answered = onset["F_SN"].where(onset["status"] == 0)
    for friction in mu.values:
        best = answered.sel(mu=friction).stack(design=["r", "preload"]).compute()
        r_best, preload_best = best["design"][int(best.argmax("design"))].item()
        print(f"mu = {friction:4.2f}: F_SN is {float(best.min()):.4f} to {float(best.max()):.4f}, "
              f"highest at r = {r_best:.2f}, preload = {preload_best:.2f}")  # fmt: skip
