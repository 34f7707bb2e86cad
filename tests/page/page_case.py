"""What the tests of pages have in common: a browser, and pages that are written once."""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, find_browser

ROOT = Path(__file__).resolve().parents[2]
SKIPPED = 77  # SKIP_RETURN_CODE of the tests

# Paragraphs that do not begin as sentences; a quantity may, with its value.
LOWER_CASE = (
    "return [...document.querySelectorAll('main p:not(.source)')].map((p) => p.textContent)"
    ".filter((text) => /^[a-z]+( (?!= )|[,;])/.test(text));"
)

# Relative luminance by WCAG 2.2 of a computed colour.
LUMINANCE = """
function luminance(colour) {
  const [r, g, b, a] = colour.match(/[\\d.]+/g).map(Number);
  if (a === 0) return NaN;
  const part = (x) => { x /= 255; return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4; };
  return 0.2126 * part(r) + 0.7152 * part(g) + 0.0722 * part(b);
}
"""

_program = Path("kinestat")


def program() -> Path:
    return _program


def write_page(path: Path, *files: Path | str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [_program, "report", "--force", "--out", path, *files],
        capture_output=True, encoding="utf-8", check=False, timeout=300,
    )


class PageCase(unittest.TestCase):
    """Pages are 1280 pixels wide, light, without a wish for less motion, if a test says no other."""

    browser: Browser
    folder: Path
    _shown: Path | None = None  # opened by `open_once`, and not changed since

    @classmethod
    def page(cls, name: str) -> Path:
        path = cls.folder / (Path(name).stem + ".html")
        if not path.exists():
            answer = write_page(path, ROOT / "mechanisms" / name)
            assert answer.returncode == 0, answer.stderr
        return path

    def look(self, width: int = 1280, **features: str) -> None:
        self.browser.set_width(width)
        self.browser.set_media(**features)

    def open(self, path: Path, width: int = 1280, **features: str) -> None:
        self.look(width, **features)
        self.browser.messages()
        self.browser.requests()
        self.browser.open(path)
        PageCase._shown = None

    def open_once(self, path: Path, width: int = 1280, **features: str) -> None:
        """As `open`, for a test that changes nothing; what is shown already is not loaded again."""
        if PageCase._shown == path:
            self.look(width, **features)
        else:
            self.open(path, width, **features)
            PageCase._shown = path

    def ask(self, script: str, *arguments: object):
        return self.browser.ask(script, *arguments)

    def is_shown(self, selector: str) -> list[bool]:
        return self.ask(
            "return [...document.querySelectorAll(arguments[0])]"
            ".map((one) => one.getClientRects().length > 0);",
            selector,
        )


def run_tests(description: str) -> int:
    """Those of the main module."""
    global _program
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    _program = arguments.program.resolve()
    found = find_browser()
    if not found:
        print("skipped: chromium and chromium-driver are not installed; scripts/setup.sh browser"
              " installs them")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder, Browser(*found) as browser:
        PageCase.browser = browser
        PageCase.folder = Path(folder)
        done = unittest.main(argv=[sys.argv[0], *rest], exit=False)
    return 0 if done.result.wasSuccessful() else 1

