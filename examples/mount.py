"""A mount from its data sheet, in newtons, millimetres and hertz: what it does, its tolerances, a better one."""

from slowflow import Isolator
from slowflow.sizing import meet, tolerances

mount = Isolator.physical(m=12, k_v=2500, k_h=1700, n=3, L=0.080, preload=0.009, friction=0.4, zeta=0.02)
print(mount.at_rest(), "\n")

print("Under 5 N it jumps:", mount.saddle_nodes(F=5), sep="\n")
print("\nMargins:", mount.margins(F=5), sep="\n")
isolation = mount.isolation(F=5)
print(f"\nIt transmits less than 5 N from {isolation.f:.2f} Hz on, and at 5 Hz", mount.amplitudes(f=5, F=5), sep="\n")

print("\nWith k_h within 5 %, friction within 30 % and damping within 20 %, 95 of 100 mounts are in these bands:")
print(tolerances(mount, {"k_h": 0.05, "friction": 0.3, "zeta": 0.2}, F=5))

better = meet(mount, {"zeta": (0.01, 0.1)}, at_least={"F_SN": 5.0})
print(
    f"\nIt does not jump below 5 N with zeta = {better.numbers['zeta']:.4f}:",
    better.design.saddle_node_onset(),
    sep="\n",
)
