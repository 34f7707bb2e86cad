#!/usr/bin/env python3
"""Pages on a telephone: what has axes is not cut, and letters can be read.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import PageCase, program, run_tests, write_page  # noqa: E402

WIDTH = 400
LEAST_LETTERS = 9.0

# Drawings of mechanisms and graphs, which are scrolled where their names need the room.
SCROLLED = ["linkage", "motion", "simulation", "gear-scheme", "coupling-graph", "motion-graph",
            "action-graph", "circuits", "cut-sets", "power-flow"]

# Of every picture its name, what of it is beyond its box, and its smallest letters [px].
PICTURES = """
for (const one of document.querySelectorAll('[hidden]')) one.hidden = false;
for (const one of document.querySelectorAll('details')) one.open = true;
return [...document.querySelectorAll('figure')].filter((one) => one.querySelector('.picture > svg'))
  .map((one) => {
    const box = one.querySelector('.picture');
    const svg = box.querySelector('svg');
    const scale = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
    const letters = [...svg.querySelectorAll('text')].filter((text) => text.getClientRects().length)
      .map((text) => scale * parseFloat(getComputedStyle(text).fontSize));
    return [one.dataset.picture, box.scrollWidth - box.clientWidth, Math.min(99, ...letters)];
  });
"""


class TelephoneTest(PageCase):
    def pictures(self, page: Path) -> list[tuple[str, int, float]]:
        self.open(page, width=WIDTH, prefers_reduced_motion="reduce")
        return [tuple(one) for one in self.ask(PICTURES)]

    def new(self, starter: str) -> Path:
        file = self.folder / f"{starter}.yaml"
        subprocess.run([program(), "new", "--force", starter, file], check=True,
                       stdout=subprocess.DEVNULL)
        page = self.folder / f"new-{starter}.html"
        self.assertEqual(write_page(page, file).returncode, 0)
        return page

    def test_no_chart_is_cut_on_a_telephone(self) -> None:
        for name in ("sweeps/press_stroke.yaml", "spatial/ups_platform.yaml", "synthesis/simpson_class.yaml"):
            with self.subTest(name):
                self.open(self.page(name), width=WIDTH)
                charts = self.ask(
                    "return [...document.querySelectorAll('figure.chart')].map((one) => {"
                    "  const box = one.querySelector('.picture');"
                    "  const parts = [...one.querySelectorAll('text, path, line')]"
                    "    .map((part) => part.getBoundingClientRect()).filter((p) => p.width > 0);"
                    "  const letters = [...one.querySelectorAll('text')]"
                    "    .map((part) => part.getBoundingClientRect())"
                    "    .map((p) => Math.min(p.width, p.height)).filter((p) => p > 0);"
                    "  return [box.scrollWidth - box.clientWidth,"
                    "    Math.min(...parts.map((p) => p.left)), Math.max(...parts.map((p) => p.right)),"
                    "    Math.max(...letters)];"
                    "});")
                self.assertGreaterEqual(len(charts), 3)
                for beyond, left, right, letters in charts:
                    self.assertLessEqual(beyond, 1)
                    self.assertGreaterEqual(left, 0)
                    self.assertLessEqual(right, WIDTH)
                    self.assertGreater(letters, 11)

    def test_no_bars_are_cut_on_a_telephone(self) -> None:
        # Of many cases they come in parts, which stand beside each other on a wide screen.
        for name in ("transmissions/zf_8hp70.yaml", "spatial/ups_platform.yaml",
                     "transmissions/ravigneaux.yaml"):
            with self.subTest(name):
                self.open(self.page(name), width=WIDTH)
                bars = self.ask(
                    "for (const one of document.querySelectorAll('[hidden]')) one.hidden = false;"
                    "return [...document.querySelectorAll('figure')]"
                    "  .filter((one) => ['speeds', 'forces', 'torques'].includes(one.dataset.picture))"
                    "  .map((one) => [one.querySelector('.picture').scrollWidth,"
                    "    one.querySelector('.picture').clientWidth,"
                    "    Math.min(...[...one.querySelectorAll('svg text')]"
                    "      .map((part) => part.getBoundingClientRect().height))]);")
                self.assertGreaterEqual(len(bars), 2)
                for whole, shown, letters in bars:
                    self.assertLessEqual(whole, shown)
                    self.assertGreater(letters, 11)
                self.look(width=1280)
                parts = self.ask(
                    "return [...document.querySelectorAll('.parts')].map((one) => [one.children.length,"
                    "  new Set([...one.children].map((f) => f.getBoundingClientRect().top)).size]);")
                self.assertTrue(parts)
                for count, rows in parts:
                    self.assertLessEqual(rows, (count + 2) // 3)

    def test_what_has_axes_is_not_cut(self) -> None:
        pages = {name: self.page(name) for name in (
            "sweeps/press_stroke.yaml", "spatial/ups_platform.yaml",
            "synthesis/simpson_class.yaml", "synthesis/lepelletier_class.yaml",
            "synthesis/crank_rocker.yaml", "synthesis/do_valle_table_1.yaml",
            "synthesis/four_positions.yaml", "transmissions/zf_8hp70.yaml",
            "transmissions/converter_automatic.yaml", "transmissions/ravigneaux.yaml")}
        pages["new hoist"] = self.new("hoist")
        pages["new three-positions"] = self.new("three-positions")
        seen = set()
        for name, page in pages.items():
            with self.subTest(name):
                pictures = [one for one in self.pictures(page) if one[0] not in SCROLLED]
                seen |= {picture for picture, _, _ in pictures}
                self.assertEqual([one for one in pictures if one[1] > 1], [])
        self.assertLess({"burmester", "ladders", "lever", "trade-offs", "ratio-ladder", "speeds",
                         "forces", "motion-curves", "synthesis-motion"}, seen)

    def test_letters_can_be_read(self) -> None:
        for name in ("spatial/rssr.yaml", "cables/block_and_tackle.yaml", "planar/four_bar.yaml",
                     "planar/slider_crank.yaml", "synthesis/crank_rocker.yaml",
                     "synthesis/lepelletier_class.yaml", "transmissions/ravigneaux.yaml"):
            with self.subTest(name):
                pictures = self.pictures(self.page(name))
                self.assertGreater(len(pictures), 2)
                self.assertEqual([one for one in pictures if one[2] < LEAST_LETTERS], [])

    def test_a_drawing_that_moves_fits_where_its_names_have_room(self) -> None:
        for name in ("spatial/rssr.yaml", "spatial/bennett.yaml", "planar/four_bar.yaml",
                     "planar/four_stroke_engine.yaml", "planar/cam_and_follower.yaml"):
            with self.subTest(name):
                moving = [one for one in self.pictures(self.page(name)) if one[0] == "motion"]
                self.assertEqual(len(moving), 1)
                self.assertLessEqual(moving[0][1], 1)


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
