"""The compiled part of the package: in go the C sources, out come extension modules; pyproject.toml says all else.

Every extension is optional: where there is no C compiler the package installs without it and runs on NumPy.
"""

from setuptools import setup

setup()
