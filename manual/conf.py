"""Sphinx makes the pages of the manual with it; scripts/manual.sh calls Sphinx."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

project = "kinestat"
html_title = "kinestat"
extensions = ["myst_parser", "furo_files", "mathml"]
myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3
exclude_patterns = ["mechanisms"]

# Pages are read from the file system, where a browser fetches nothing: no summaries of what a
# search finds, for which Sphinx would fetch the pages, and formulas without a script.
html_show_search_summary = False
html_math_renderer = "mathml"

html_theme = "furo"
# A font that knows where the signs of formulas stand, which few systems have.
html_static_path = ["static", "/usr/share/fonts/opentype/stix-word/STIXMath-Regular.otf"]
html_css_files = ["manual.css"]
html_copy_source = False
html_use_index = False
html_show_sourcelink = False
html_show_copyright = False
html_last_updated_fmt = None
html_theme_options = {"navigation_with_keys": False}
pygments_style = "default"
highlight_language = "text"
smartquotes = False  # quotes are those of the messages


def _own_branch_alone(app, pagename, templatename, context, doctree):
    """Of the navigation, the branch in which a page is: all of it would be most of every page."""
    whole = context.get("toctree")
    if whole:
        context["toctree"] = lambda **options: whole(**{**options, "collapse": True})


def setup(app):
    app.connect("html-page-context", _own_branch_alone, priority=1)
