"""The isolator of the paper's Table 1: when do its springs detach, when does it jump, and where?"""

import numpy as np

from slowflow import example

F_0 = 0.04

isolator = example.isolator()
print(isolator)

detachment, onset = isolator.detachment(), isolator.saddle_node_onset()
print(f"the springs detach from F_cr = {detachment.F_cr:.4f} on, first at Omega = {detachment.Omega_cr:.4f}")
print(f"jumps begin at F_SN = {onset.F_SN:.4f}, Omega = {onset.Omega:.4f}, A = {onset.A:.4f}")

print(f"\nat F_0 = {F_0}:")
folds = isolator.saddle_nodes(F_0)
for kind, Omega, A, error in zip(folds.kind, folds.Omega, folds.A, folds.validity.error, strict=True):
    # 95 of 100 states like this one are closer to the equation of motion; errors below 1 % are not resolved
    print(f"{kind:9} at Omega = {Omega:.4f}, A = {A:.4f}, A good to {max(error, 0.01):.0%}")

curve = isolator.frequency_response(F_0)
peak = isolator.peak(F_0)
print(f"curve with {curve.A.size} points, {np.count_nonzero(~curve.stable)} of them unstable")
print(f"largest amplitude {peak.A:.4f} at Omega = {peak.Omega:.4f}")

states = isolator.amplitudes(Omega=0.9, F_0=F_0)
for A, phi, stable in zip(states.A, states.phi, states.stable, strict=True):
    print(f"steady state at Omega = 0.9: A = {A:.4f}, phi = {phi:.3f}, {'stable' if stable else 'unstable'}")
