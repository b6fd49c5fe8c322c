"""Stationary random vibration by statistical linearization: every equivalent linear oscillator, and records in time."""
