"""Pictures that the program draws of mechanism files."""

from __future__ import annotations

import html
import re
from pathlib import Path

import markdown
from program import Program

_TITLE = re.compile(r"<title>(.*?)</title>\s*<desc>(.*?)</desc>", re.S)


class Pictures:
    """Draws into one folder of the site; each picture once."""

    def __init__(self, program: Program, folder: Path):
        self._program = program
        self._folder = folder

    def draw(self, kind: str, file: str, name: str) -> tuple[str, str]:
        """The name of the picture in the folder, and what it shows in words."""
        svg = self._program("plot", kind, file)
        path = self._folder / f"{name}.svg"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(svg, encoding="utf-8")
        said = _TITLE.search(svg)
        if not said:
            raise SystemExit(f"manual: the picture {kind} of {file} has no title and description")
        return f"{name}.svg", html.unescape(f"{said[1]}. {said[2]}")

    def figure(self, kind: str, file: str, name: str, up: str, caption: str = "") -> str:
        """Markdown of a picture on a page; `up` leads from it to the folder of pictures."""
        drawn, alt = self.draw(kind, file, name)
        return markdown.picture(f"{up}{drawn}", alt, caption=caption)
