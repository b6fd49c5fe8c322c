"""From derived expressions to files: what to print (`kernels`), how to compute it (`passes`), how to write it (`printers`,
`templates`), where (`write`).

In:  `derivations.results.Results`.
Out: a dict from file name to text.
"""
