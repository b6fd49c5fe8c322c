"""A map of designs: the force above which each isolator jumps, and that which detaches its springs, in a call each."""

import numpy as np

from slowflow import Isolator

r = np.linspace(0.5, 3.0, 6)[:, None]  # stiffness of a horizontal spring over that of the vertical one
preload = np.linspace(0.1, 0.9, 5)  # relative to the preload of quasi-zero stiffness
designs = Isolator.many(lam=3, r=r, delta_h=preload / (3 * r), mu=0.012, zeta=0.02)

onset, detachment = designs.saddle_node_onset(), designs.detachment()

for name, found in (("F_SN", onset.F_SN), ("F_cr", detachment.F_cr)):
    print(f"{name:6}" + "".join(f"{x:10.2f}" for x in preload))
    for k, row in enumerate(found):
        print(f"r={r[k, 0]:4.1f}" + "".join(f"{value:10.4f}" for value in row))
    print()

# a design without a result has NaN and a status with the reason: 0 is a result, 3 means that none exists
answered = (onset.status == 0) & (detachment.status == 0)
first = np.count_nonzero(onset.F_SN[answered] < detachment.F_cr[answered])
print(f"{first} of {np.count_nonzero(answered)} designs jump before their springs detach")

# the same for a million designs takes seconds
best = np.unravel_index(np.nanargmax(onset.F_SN), onset.F_SN.shape)
print(f"the highest onset has r = {r[best[0], 0]:.1f}, preload = {preload[best[1]]:.1f}: F_SN = {onset.F_SN[best]:.4f}")
