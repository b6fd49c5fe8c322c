"""The paper: Table 2 beside its derivation, and its figures: `python -m examples.paper`."""
