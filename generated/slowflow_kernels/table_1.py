"""Table 1 of the paper: lam, r, delta_h, mu, zeta, each the double next to the published fraction.

Written by `make derive`; never edit.
"""

TABLE_1: dict[str, float] = {
    "lam": 3.0,
    "r": 2.0275974025974026,
    "delta_h": 0.08219909260741927,
    "mu": 0.012,
    "zeta": 0.02,
}
