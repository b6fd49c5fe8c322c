"""A custom mechanism, defined by its force alone: a soft mount with an elastic stop, derived here and compiled."""

import sympy as sp

from slowflow import derive

u, soft, hard, gap = sp.symbols("u soft hard gap")
stop = derive.mechanism(
    "soft_stop",
    pieces=[(soft * u, gap), (soft * u + hard * (u - gap), None)],
    parameters={
        "soft": {"above": 0, "doc": "stiffness of the mount", "unit": "k_v"},
        "hard": {"above": 0, "doc": "stiffness of the stop", "unit": "k_v"},
        "gap": {"above": 0, "doc": "gap to the stop", "unit": "L"},
    },
    compile=True,
)
mount = stop(soft=0.6, hard=8.0, gap=0.2, mu=0.005, zeta=0.03)
onset, detachment, folds = mount.saddle_node_onset(), mount.detachment(), mount.saddle_nodes(0.05)
print(stop)
print(f"it reaches the stop from F_0 = {detachment.F_cr:.4f} on, and jumps from {onset.F_SN:.4f} on")
print(f"at 0.05 it jumps at Omega = {folds.Omega[0]:.4f} and {folds.Omega[1]:.4f}")
print(f"its highest peak there: A = {mount.peak(0.05).A:.4f}")
many = stop.many(soft=0.6, hard=[2.0, 8.0, 32.0], gap=0.2, mu=0.005, zeta=0.03).saddle_node_onset()
print("harder stops jump from", *(f"{F_SN:.5f}" for F_SN in many.F_SN), "on")
