"""What the site adds to Sphinx: pages that follow from the project, what code prints, MathML, plain docstrings."""
