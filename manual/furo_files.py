"""Mends what Debian's Furo leaves undone where pages are read from the file system.

Its style imports another by an address of a server, its script is a module that imports another,
which browsers refuse from files, and its style has lost the dark colours of whoever prefers them
without having asked for them. A Furo that has none of this is left as it is.
"""

from __future__ import annotations

import re
from pathlib import Path

from sphinx.application import Sphinx

_NORMALIZE = "@import url(/javascript/normalize.css/normalize.css);"
_IMPORT = re.compile(r'^import Gumshoe from "\./(gumshoe-patched\.js)";\n')
_DARK = re.compile(r'^@media not print \{\n(  body\[data-theme="dark"\] \{\n.*?\}) \}\n', re.M | re.S)


def _mend_script(folder: Path) -> None:
    path = folder / "furo.js"
    text = path.read_text(encoding="utf-8")
    imported = _IMPORT.match(text)
    if imported:
        other = (folder / imported[1]).read_text(encoding="utf-8")
        path.write_text(other + text[imported.end():], encoding="utf-8")


def _mend_style(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    if _NORMALIZE in text:
        other = Path("/usr/share/javascript/normalize.css/normalize.css").read_text(encoding="utf-8")
        text = text.replace(_NORMALIZE, other)
    dark = _DARK.search(text)
    if dark and "prefers-color-scheme" not in text:
        rules = dark[1].replace('body[data-theme="dark"]', 'body:not([data-theme="light"])')
        text = (f"{text[:dark.end()]}\n@media not print {{ @media (prefers-color-scheme: dark) {{\n"
                f"{rules} }} }}\n{text[dark.end():]}")
    path.write_text(text, encoding="utf-8")


def _mend(app: Sphinx, problem: Exception | None) -> None:
    static = Path(app.outdir) / "_static"
    if problem is None and (static / "styles" / "furo.css").exists():
        _mend_script(static / "scripts")
        _mend_style(static / "styles" / "furo.css")


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("build-finished", _mend)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
