"""Sphinx. Takes docs/; returns the site; `make docs`. Pages that are derived are written first, into docs/_made."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS.parent))

from docs.site import docstrings, mathml, pages, printed  # noqa: E402
from slowflow.version import __version__  # noqa: E402

project = "slowflow"
author = "The slowflow authors"
copyright = "the slowflow authors"
version = release = __version__
extensions = ["myst_parser", "sphinx.ext.autodoc"]
myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence", "attrs_inline"]
myst_heading_anchors = 3
exclude_patterns = ["site", *(page[5:] for page in pages.ELSEWHERE if page.startswith("docs/"))]
html_theme = "furo"
html_title = "slowflow"
html_static_path = ["site/static"]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_search_scorer = str(DOCS / "site" / "scorer.js")
html_extra_path = ["explorer.html"]
# the search has every name
html_use_index = False
html_copy_source = False
html_show_sphinx = False
html_math_renderer = "mathml"
# quotes in docstrings are code
smartquotes = False
pygments_style = "a11y-high-contrast-light"
pygments_dark_style = "monokai"
linkcheck_timeout = 20
linkcheck_retries = 2
linkcheck_allow_unauthorized = False
# a publisher behind a DOI may turn away what is no browser: where the DOI leads to is what is asked
linkcheck_allowed_redirects = {r"https://doi\.org/.*": r"https://.*"}
autodoc_member_order = "bysource"
autodoc_typehints = "none"
# a method described by a base class is on the page of that
autodoc_inherit_docstrings = False


def setup(app: Any) -> dict[str, Any]:
    """What is done before pages are read, and what becomes of equations and docstrings."""
    pages.write(DOCS)
    mathml.register(app)
    app.connect("source-read", pages.inside)
    app.connect("source-read", printed.inside)
    app.connect("env-get-outdated", printed.again)
    app.connect("autodoc-process-docstring", docstrings.as_rst)
    app.connect("autodoc-skip-member", docstrings.unsaid)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
