"""Plausible errors in `edits.txt`; `python -m tests.mutants` makes them, to see which the tests notice."""
