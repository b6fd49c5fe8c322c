"""The explorer: one page that runs the compiled solvers in a browser; `python -m explorer` writes it into docs."""
