#!/usr/bin/env python3
"""What pages look like on paper."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import LUMINANCE, PageCase, run_tests  # noqa: E402


class PaperTest(PageCase):
    def test_tables_on_paper_cover_nothing(self) -> None:
        # On a screen some are scrolled; on paper they have room for all rows.
        for name in ("planar/watt_six_bar.yaml", "planar/four_stroke_engine.yaml"):
            with self.subTest(name):
                self.browser.set_width(720)
                self.browser.set_media("print")
                self.browser.open(self.page(name))
                beyond = self.ask(
                    "return [...document.querySelectorAll('.box')]"
                    ".filter((one) => one.getClientRects().length)"
                    ".map((one) => one.querySelector('table').getBoundingClientRect().bottom"
                    "  - one.getBoundingClientRect().bottom);")
                self.assertGreater(len(beyond), 5)
                self.assertLess(max(beyond), 1)

    def test_tables_are_as_wide_as_paper(self) -> None:
        # Sheets of A4 within their margins, upright or, where the style says so, lying.
        for name in ("planar/four_bar.yaml", "planar/stephenson_six_bar.yaml",
                     "planar/four_stroke_engine.yaml", "spatial/ups_platform.yaml",
                     "transmissions/dual_clutch_six_speed.yaml", "cables/block_and_tackle.yaml"):
            with self.subTest(name):
                self.browser.set_width(718)
                self.browser.set_media("print")
                self.browser.open(self.page(name))
                tables = self.ask(
                    "return [...document.querySelectorAll('table')]"
                    ".filter((one) => one.getClientRects().length).map((one) => ["
                    "  Math.max(one.getBoundingClientRect().right, ...[...one.rows].slice(0, 3)"
                    "    .flatMap((row) => [...row.cells].map((c) => c.getBoundingClientRect().right))),"
                    "  getComputedStyle(one.closest('.long') ?? one).page === 'lying' ? 1047 : 719]);")
                self.assertGreater(len(tables), 3)
                self.assertEqual([one for one in tables if one[0] > one[1]], [])

    def test_charts_stand_in_two_columns_on_paper(self) -> None:
        self.browser.set_width(720)
        self.browser.set_media("print")
        self.browser.open(self.page("planar/four_stroke_engine.yaml"))
        lefts = self.ask(
            "return [...new Set([...document.querySelectorAll('.charts figure')]"
            ".map((one) => Math.round(one.getBoundingClientRect().left)))];")
        self.assertEqual(len(lefts), 2)

    def test_on_paper_everything_is_shown_and_nothing_that_is_pressed(self) -> None:
        self.open(self.page("transmissions/ravigneaux.yaml"), prefers_color_scheme="dark")
        self.ask("for (const one of document.querySelectorAll('details')) one.open = false;")
        self.browser.set_media("print", prefers_color_scheme="dark")

        self.assertEqual(set(self.is_shown("section.panel")), {True})
        self.assertEqual(set(self.is_shown(".script, button, input")), {False})
        self.assertEqual({one for one in self.is_shown("table")}, {True})
        cut = self.ask("return [...document.querySelectorAll('.box')].filter((one) =>"
                       " getComputedStyle(one).overflow !== 'visible').length;")
        self.assertEqual(cut, 0)
        self.assertGreater(self.ask(
            "return luminance(getComputedStyle(document.body).backgroundColor) || 1;" + LUMINANCE
        ), 0.9)


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
