"""Averaged motions. Takes oscillators and questions; returns answers; `questions` for one, `many` for many."""
