"""A custom force defined by hand: a spring with elastic stops behind a gap. It has the functions of the isolator."""

import numpy as np

from slowflow.core.mechanism import Law, Mechanism, Parameter
from slowflow.oscillators.oscillator import Oscillator


def averaged(A, s, gap):
    """h(A) and its first three derivatives (20): closed forms, with cos psi_0 = gap/A where the stops are reached."""
    c = gap / np.maximum(A, gap)
    S, psi_0, more = np.sqrt((1 - c) * (1 + c)), np.arctan2(np.sqrt((1 - c) * (1 + c)), c), 2 * s / np.pi
    with np.errstate(divide="ignore", invalid="ignore"):
        h_AA = np.where(S > 0, -2 * more * c**3 / (A * S), 0.0)
        h_AAA = np.where(S > 0, 2 * more * c**3 * (4 * S**2 + c**2) / (A**2 * S**3), 0.0)
    return -A - more * (A * psi_0 - gap * S), -1 - more * (psi_0 + c * S), h_AA, h_AAA


def intercept(A, s, gap):
    """h - A h_A, in which the linear terms cancel."""
    c = gap / np.maximum(A, gap)
    return 4 * s / np.pi * gap * np.sqrt((1 - c) * (1 + c))


NUMBERS = (Parameter("s", "stiffness of a stop", "k_v", above=0.0), Parameter("gap", "gap to a stop", "L", above=0.0))
STOPS = Mechanism(
    name="stops", title="a spring with elastic stops behind a gap", design=NUMBERS, parameters=NUMBERS,
    coefficients=lambda s, gap: (s, gap),
    pieces=(
        Law(lambda u, s, gap: 1.0 * u, lambda u, s, gap: 1.0 + 0 * u),
        Law(lambda u, s, gap: u + s * (u - gap * np.sign(u)), lambda u, s, gap: 1.0 + s + 0 * u),
    ),
    breakpoints=lambda s, gap: (gap,), jumps=lambda s, gap: (0.0,), hardening=lambda s, gap: (s,),
    averaged=averaged, intercept=intercept, harmonics=lambda A, s, gap: np.nan, harmonics_up_to=0.0,
    reach=np.inf, reach_reason="", truncated=False, load_untruncated=None,
)  # fmt: skip

oscillator = Oscillator(STOPS, s=4.0, gap=0.5, mu=0.01, zeta=0.02)
detachment, onset = oscillator.detachment(), oscillator.saddle_node_onset()
print(f"it reaches the stops from {detachment.F_cr:.4f} on, and jumps from {onset.F_SN:.4f} on ({onset.kind})")

for Omega, A, kind in zip(
    *(getattr(oscillator.saddle_nodes(0.1), name) for name in ("Omega", "A", "kind")), strict=True
):
    print(f"{kind:9} at Omega = {Omega:.4f}, A = {A:.4f}")
states = oscillator.amplitudes(Omega=1.1, F_0=0.1)
for A, stable in zip(states.A, states.stable, strict=True):
    exact = oscillator.steady_state(Omega=1.1, F_0=0.1, A=A).A
    print(f"A at Omega = 1.1: {A:.4f} averaged, {exact:.4f} exact, {'stable' if stable else 'unstable'}")
