"""Answers, their units, pictures and gradients, and the table of questions."""
