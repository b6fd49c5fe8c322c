"""From derived expressions to files.

What to print is in `kernels`, how to compute it in `passes`, how to write it in `printers`, `render`, `ufuncs` and
`templates`, where in `write`.

In:  `derivations.results.Results`.
Out: a dict from file name to text.
"""
