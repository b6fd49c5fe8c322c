"""How good is averaging? The same jumps and the same state averaged, in the second approximation, and exactly."""

from slowflow import example

F_0, WINDOW = 0.04, (0.8, 1.05)

isolator = example.isolator(force="untruncated")
averaged = isolator.saddle_nodes(F_0)
second = isolator.second_approximation.saddle_nodes(F_0)
exact = isolator.exact_response(F_0, Omega=WINDOW, step=0.05)  # the equation of motion itself, no averaging

for k, fold in enumerate(exact.folds):
    print(
        f"{fold.kind:9} Omega = {averaged.Omega[k]:.5f} averaged, {second.Omega[k]:.5f} second approximation, "
        f"{fold.Omega:.5f} exact"
    )
print(f"highest   A = {isolator.peak(F_0).A:.5f} averaged, {exact.peak.A:.5f} exact")

# one periodic motion, with everything that averaging neglects
state = isolator.steady_state(Omega=0.9, F_0=F_0)
tau, u, v = state.series(8)
print(f"\nat Omega = 0.9: A = {state.A:.5f}, stops {state.stops} times in a period, residual {state.residual:.0e}")
print("largest multiplier", f"{max(abs(state.multipliers)):.3f}, stable" if state.stable else "above 1: unstable")
print("harmonics", " ".join(f"{abs(x):.1e}" for x in state.harmonics(5)))
print("one period, u:", " ".join(f"{x:+.3f}" for x in u))

# what a stepped-sine test measures as the frequency rises: past the fold the motion falls to the lower branch
seen = isolator.sweep(F_0=F_0, Omega=[0.8, 0.9, 0.95, 0.99, 1.0])
print("\nswept up:", ", ".join(f"A({w}) = {A:.3f}" for w, A in zip(seen.Omega, seen.A, strict=True)))
print("jumps between", *(f"Omega = {before} and {after}" for before, after in seen.jumps))
