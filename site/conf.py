"""The configuration of Sphinx for the website; `website.py` calls Sphinx."""

from pathlib import Path
from typing import Any

import groups
import mathematics
import previews
import projected_pages
import room
from repository import ROOT, documented

project = "EduGym"
author = "The EduGym developers"
project_copyright = "The EduGym developers, MIT licence"
version = release = documented((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))
language = "en"
smartquotes = False  # docstrings speak of code

extensions = ["myst_parser"]
myst_enable_extensions = ["amsmath", "attrs_inline", "colon_fence", "dollarmath"]
myst_heading_anchors = 3
# Texts that are written for GitHub, and docstrings within directives, begin with a heading of any level.
suppress_warnings = ["myst.header"]

html_theme = "furo"
html_title = "EduGym"  # the version stands below, where `versions.py` finds it
html_favicon = "playground/favicon.svg"
html_static_path = ["static"]
templates_path = ["templates"]
_PARTS = "brand versions search scroll-start navigation scroll-end"
html_sidebars = {"**": [f"sidebar/{part}.html" for part in _PARTS.split()]}
html_css_files = ["site.css"]
html_js_files = [("site.js", {"defer": "defer"})]
html_math_renderer = "mathml"
html_copy_source = False
html_search_scorer = str(Path(__file__).with_name("scorer.js"))
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#2b5a9e", "color-brand-content": "#2b5a9e"},
    "dark_css_variables": {"color-brand-primary": "#8ab8ff", "color-brand-content": "#8ab8ff"},
}
pygments_style = "a11y-high-contrast-light"
pygments_dark_style = "a11y-high-contrast-dark"
python_maximum_signature_line_length = 60
toc_object_entries_show_parents = "hide"


def setup(app: Any) -> None:
    """Formulas become MathML, which needs no script; the head of a page and its sidebar say more than Sphinx writes."""
    app.add_html_math_renderer("mathml", (mathematics.visit_inline, None), (mathematics.visit_block, None))
    app.connect("html-page-context", previews.add)
    app.connect("html-page-context", projected_pages.add_style)
    app.connect("html-page-context", room.add)
    app.connect("html-page-context", groups.add, priority=900)  # after the theme has written the tree
