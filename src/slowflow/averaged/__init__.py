"""Averaged motions: in go oscillators and questions, out come answers; `questions` for one, `many` for many."""
