#!/usr/bin/env python3
"""In no figure of a page of the library does a text cover another or what is drawn.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import itertools
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from covered import COVERED_IN_ALL  # noqa: E402
from page_case import ROOT, PageCase, run_tests, write_page  # noqa: E402

# A file that the program refuses to solve has a page too; one without an answer has status 5.
ANSWERED = (0, 5)
PAGES_AT_ONCE = 12


# Bars of a case, each word in a row of its own: one of each kind is enough.
BARS = re.compile(r'data-picture="(speeds|torques|forces)"')


def is_repeated(figure: str, seen: set[str]) -> bool:
    kind = BARS.search(figure)
    if not kind or kind[1] not in seen:
        seen.update(kind.groups() if kind else ())
        return False
    return True


def figures_of(page: Path) -> str:
    """The figures of a page, those of all cases, with its style."""
    text = page.read_text(encoding="utf-8")
    style = re.search(r"<style.*?</style>", text, re.DOTALL)
    figures = re.findall(r"<figure.*?</figure>", text, re.DOTALL)
    assert style
    seen = set()
    figures = [one for one in figures if not is_repeated(one, seen)]
    return style[0] + f"<h1>{page.stem}</h1>" + re.sub(
        r"<script.*?</script>", "", "".join(figures), flags=re.DOTALL)


class LibraryTest(PageCase):
    def test_texts_of_figures_are_free(self) -> None:
        files = sorted((ROOT / "mechanisms").rglob("*.yaml"))
        self.assertGreater(len(files), 100)

        def figures(file: Path) -> str:
            page = self.folder / f"{file.parent.name}-{file.stem}.html"
            answer = write_page(page, file)
            assert answer.returncode in ANSWERED, answer.stderr
            return figures_of(page)

        count = 0
        with ThreadPoolExecutor(max_workers=2) as pool:
            texts = pool.map(figures, files)
            while pages := list(itertools.islice(texts, PAGES_AT_ONCE)):
                page = self.folder / "figures.html"
                page.write_text("<!DOCTYPE html><meta charset=utf-8>" + "".join(pages),
                                encoding="utf-8")
                self.open(page)
                checked, covered = self.ask(COVERED_IN_ALL)
                count += checked
                with self.subTest(count=count):
                    self.assertEqual(covered, [])
        self.assertGreater(count, 1500)


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
