"""The paper: Table 2 compared with its derivation, and its figures: `python -m examples.paper`."""
