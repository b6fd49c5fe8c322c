"""From derived expressions to files.

What a kernel is stands in `form`, which ones there are in `catalogue`, how to compute them in `passes`, how to write
them in `targets`, one folder for each language, where to in `write`.

In:  `derivations.results.Results`.
Out: a dict from file name to text.
"""
