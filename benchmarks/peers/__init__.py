"""Other tools on the same problem, each in an environment of its own; `python -m benchmarks.peers` runs them."""
