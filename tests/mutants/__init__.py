"""Plausible errors in `edits.toml`; `python -m tests.mutants` makes them, to see which the tests notice."""
