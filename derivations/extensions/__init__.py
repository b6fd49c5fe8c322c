"""Beyond the paper: other damping, other excitation, the next order, the motion in time.

dissipation            damping laws beside viscous damping and dry friction
inertia                base excitation and rotating unbalance
second_approximation   the higher harmonics and what they add; `wave`, its motion over half a cycle
motion                 the equation of motion (3) as it is followed in time, (A1), (A2); `switching`: its edges
scaling                what each dimensionless number is measured in (4)
"""
