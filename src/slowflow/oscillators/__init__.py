"""The oscillators that users hold, dimensionless and in SI units."""
