#!/usr/bin/env python3
"""The manual as it is read: made by scripts/manual.sh, opened from the file system.

Skipped where Sphinx is not installed; what needs a browser, where there is none.
"""

from __future__ import annotations

import argparse
import itertools
import subprocess
import sys
import tempfile
import time
import unittest
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "page"))
from browser import Browser, find_browser  # noqa: E402

SKIPPED = 77
VIEWS = list(itertools.product((400, 1280), ("light", "dark")))
# Looked at in every view; of the others each in one of them, in turn.
MAIN = [
    "index.html", "cookbook.html", "format/cases.html", "couplings/gear.html", "topics/gears.html",
    "commands/analyze.html", "theory/kinematics.html", "gallery/index.html",
    "gallery/transmissions/ravigneaux.html", "search.html",
]


class Page(HTMLParser):
    """What a page leads to, what it loads, and the places in it."""

    def __init__(self, path: Path):
        super().__init__()
        self.path = path
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.places: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        found = {name: value or "" for name, value in attributes}
        self.places.update(found[name] for name in ("id", "name") if name in found)
        if tag == "a" and "href" in found:
            self.links.append(found["href"])
        elif tag == "link" and found.get("rel") == "stylesheet":
            self.loaded.append(found["href"])
        elif tag in ("script", "img", "iframe") and "src" in found:
            self.loaded.append(found["src"])


class SiteCase(unittest.TestCase):
    html: Path
    pages: dict[Path, Page]

    @classmethod
    def setUpClass(cls) -> None:
        cls.pages = {path: Page(path) for path in sorted(cls.html.rglob("*.html"))}


class Site(SiteCase):
    def test_there_is_a_page_on_everything(self) -> None:
        names = {path.relative_to(self.html).as_posix() for path in self.pages}
        written = (path.relative_to(ROOT / "manual" / "pages").with_suffix(".html").as_posix()
                   for path in (ROOT / "manual" / "pages").rglob("*.md"))
        self.assertEqual([one for one in [*MAIN, *written] if one not in names], [])
        mechanisms = (path.relative_to(ROOT / "mechanisms").with_suffix(".html").as_posix()
                      for path in (ROOT / "mechanisms").glob("*/*.yaml"))
        self.assertEqual([one for one in mechanisms if f"gallery/{one}" not in names], [])

    def test_every_link_leads_somewhere(self) -> None:
        lost = [f"{path.relative_to(self.html)}: {link}" for path, page in self.pages.items()
                for link in page.links if not self._leads(page, link)]
        self.assertEqual(lost, [])

    def _leads(self, page: Page, link: str) -> bool:
        parts = urlsplit(link)
        if parts.scheme in ("http", "https"):
            return True
        target = (page.path.parent / unquote(parts.path)).resolve() if parts.path else page.path
        if not target.is_file():
            return False
        return not parts.fragment or target not in self.pages or unquote(
            parts.fragment) in self.pages[target].places

    def test_what_is_loaded_is_there(self) -> None:
        lost = [f"{path.relative_to(self.html)}: {one}" for path, page in self.pages.items()
                for one in page.loaded if urlsplit(one).scheme
                or not (path.parent / unquote(urlsplit(one).path)).is_file()]
        self.assertEqual(lost, [])

    def test_pictures_say_what_they_show(self) -> None:
        text = (self.html / "couplings" / "gear.html").read_text(encoding="utf-8")
        self.assertIn('alt="Mechanism with the forces of case', text)

    def test_the_cookbook_has_thirty_recipes(self) -> None:
        text = (self.html / "cookbook.html").read_text(encoding="utf-8")
        self.assertGreaterEqual(text.count("<h3>"), 30)


class InBrowser(SiteCase):
    browser: Browser | None

    def setUp(self) -> None:
        if not self.browser:
            self.skipTest("chromium and chromium-driver are not installed")

    def test_pages_load_alone_are_silent_and_fit(self) -> None:
        names = [path.relative_to(self.html).as_posix() for path in self.pages]
        self.browser.requests()
        for i, (width, scheme) in enumerate(VIEWS):
            self.browser.set_width(width)
            self.browser.set_media(prefers_color_scheme=scheme)
            for name in [one for j, one in enumerate(names) if one in MAIN or j % len(VIEWS) == i]:
                with self.subTest(name, width=width, scheme=scheme):
                    self.browser.open(self.html / name)
                    wide = self.browser.ask(
                        "return document.documentElement.scrollWidth - window.innerWidth;")
                    self.assertLessEqual(wide, 0)
                    self.assertEqual(self.browser.messages(), [])
        self.assertEqual([one for one in self.browser.requests()
                          if not one.startswith(("file:", "data:"))], [])

    def test_the_search_finds_a_word(self) -> None:
        self.browser.open(self.html / "search.html", "?q=revolute")
        found: list[str] = []
        for _ in range(100):
            found = self.browser.ask(
                "return [...document.querySelectorAll('#search-results li a')].map((a) => a.href);")
            if found:
                break
            time.sleep(0.1)
        self.assertIn((self.html / "couplings" / "revolute.html").as_uri(),
                      [one.partition("?")[0].partition("#")[0] for one in found])

    def test_colours_follow_the_reader(self) -> None:
        grounds = []
        for scheme in ("light", "dark"):
            self.browser.set_media(prefers_color_scheme=scheme)
            self.browser.open(self.html / "index.html")
            grounds.append(self.browser.ask("return getComputedStyle(document.body).backgroundColor;"))
        self.browser.ask("document.querySelector('.theme-toggle').click();")
        self.assertNotEqual(*grounds)
        self.assertEqual(self.browser.ask("return document.body.dataset.theme;"), "light")
        self.browser.ask("localStorage.clear();")
        self.browser.messages()


def sphinx_is_there() -> bool:
    asked = subprocess.run(["/usr/bin/python3", "-c", "import sphinx, furo, myst_parser, yaml"],
                           stderr=subprocess.DEVNULL, check=False)
    return asked.returncode == 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    if not sphinx_is_there():
        print("skipped: Sphinx is not installed; scripts/setup.sh manual installs it")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        made = subprocess.run(
            [ROOT / "scripts" / "manual.sh", "--program", arguments.program.resolve(), "--out", folder],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False,
        )
        if made.returncode:
            print(made.stdout)
            return 1
        SiteCase.html = Path(folder).resolve() / "html"
        found = find_browser()
        InBrowser.browser = Browser(*found) if found else None
        try:
            done = unittest.main(argv=[sys.argv[0], *rest], exit=False)
        finally:
            if InBrowser.browser:
                InBrowser.browser.__exit__()
    return 0 if done.result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
