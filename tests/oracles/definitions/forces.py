"""Coefficients of the forces and how dimensionless parameters follow from what a user gives."""

from __future__ import annotations

from mpmath import mp


def rod_force(lam, r, delta_h):
    """F_k at k_v = L = 1: lam springs of stiffness r, shortened by delta_h - (1 - sqrt(1 - u^2)), on a tilted rod."""

    def force(u):
        adjacent = mp.sqrt(1 - u**2)
        return -lam * r * (delta_h - (1 - adjacent)) * u / adjacent

    return force


def rod_coefficients(lam, r, delta_h):
    taylor = mp.taylor(rod_force(lam, r, delta_h), 0, 5)
    # the spring is at its free length where the rod has drawn back by delta_h
    u_cr = mp.sqrt((1 - (1 - delta_h)) * (1 + (1 - delta_h)))
    return [1 + taylor[1], taylor[3], taylor[5], u_cr]


def untruncated_coefficients(lam, r, delta_h):
    alpha, beta, *_ = rod_coefficients(lam, r, delta_h)
    return [alpha, beta, delta_h]
