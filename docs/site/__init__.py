"""What the site adds to Sphinx: pages that follow from the project, equations without a script, plain docstrings."""
