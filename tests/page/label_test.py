#!/usr/bin/env python3
"""Names and values in pictures cover neither each other nor what is drawn, by the boxes that a browser has.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from covered import COVERED_IN_ONE  # noqa: E402
from page_case import PageCase, run_tests, write_page  # noqa: E402

# A winch of two planetary sets in teeth, the drum on the carrier of the second.
WINCH = """
kinestat: 1
name: Two-stage planetary winch
space: planar
units: {length: mm}
ground: housing
bodies: [sun1, carrier1, planet1, carrier2drum, planet2]
couplings:
  S: {type: revolute, bodies: [housing, sun1]}
  C1: {type: revolute, bodies: [housing, carrier1]}
  C2: {type: revolute, bodies: [housing, carrier2drum]}
  P1: {type: revolute, bodies: [carrier1, planet1]}
  P2: {type: revolute, bodies: [carrier2drum, planet2]}
gears:
  module: 3 mm
  members:
    sun1: {body: sun1, teeth: 18}
    planet1: {body: planet1, teeth: 36, count: 3}
    ring1: {body: housing, teeth: 90, internal: true}
    sun2: {body: carrier1, teeth: 18}
    planet2: {body: planet2, teeth: 36, count: 3}
    ring2: {body: housing, teeth: 90, internal: true}
  meshes:
    s1: {members: [sun1, planet1], carrier: carrier1}
    r1: {members: [ring1, planet1], carrier: carrier1}
    s2: {members: [sun2, planet2], carrier: carrier2drum}
    r2: {members: [ring2, planet2], carrier: carrier2drum}
actuators:
  motor: {coupling: S}
  drum: {coupling: C2}
cases:
  hoist: {motion: {motor: 1500 rpm}, action: {drum: -500 N*m}, input: motor, output: drum}
"""

# Of every drawing that is shown: its name, texts that cover others, and those that begin before it.
CROWDED = """
return [...document.querySelectorAll('[data-picture=linkage], figure.motion')]
  .filter((one) => one.getClientRects().length).map((figure) => {
    const svg = figure.querySelector('.picture svg');
    const left = svg.getBoundingClientRect().left;
    const texts = [...svg.querySelectorAll('text')].filter((one) => one.getClientRects().length)
      .map((one) => [one.textContent, one.getBoundingClientRect()])
      // Without descenders and the room above capitals.
      .map(([text, p]) => ({text, left: p.left + 1, right: p.right - 1,
                            top: p.top + p.height / 4, bottom: p.bottom - p.height / 4}));
    const covered = texts.flatMap((a, i) => texts.slice(0, i)
      .filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
      .map((b) => a.text + ' and ' + b.text));
    return [figure.querySelector('figcaption').textContent, covered,
            texts.filter((one) => one.left < left).map((one) => one.text)];
  });
"""


class LabelTest(PageCase):
    def expect_free(self, path: Path, *pictures: str, which: int = 0) -> None:
        self.open(path, prefers_reduced_motion="reduce")
        self.ask("for (const one of document.querySelectorAll('details')) one.open = true;")
        for picture in pictures:
            with self.subTest(path.stem, picture=picture):
                count, covered = self.ask(COVERED_IN_ONE, picture, which)
                self.assertGreater(count, 3)
                self.assertEqual(covered, [])

    def test_the_power_flow_of_a_press(self) -> None:
        for name in ("sweeps/press_stroke.yaml", "planar/toggle_press.yaml",
                     "planar/engine_balance.yaml"):
            self.expect_free(self.page(name), "power-flow")

    def test_the_edges_of_graphs(self) -> None:
        # Bundles of lines with long labels, an arrow for a load, and bodies that edges lead around.
        for name, *pictures in (
                ("planar/gripper.yaml", "motion-graph", "action-graph", "circuits", "cut-sets"),
                ("spatial/kelvin_clamp.yaml", "motion-graph"),
                ("spatial/three_vee_mount.yaml", "motion-graph"),
                ("spatial/ups_platform.yaml", "power-flow"),
                ("transmissions/mercedes_w5a_580.yaml", "power-flow", "motion-graph"),
                ("transmissions/vw_02j.yaml", "power-flow", "action-graph")):
            self.expect_free(self.page(name), *pictures)

    def test_the_extremes_in_charts(self) -> None:
        # Each keeps off the curve between its points, and off the guides of events.
        self.open(self.page("planar/watt_six_bar.yaml"), prefers_reduced_motion="reduce")
        for chart in (1, 3, 4, 5):
            with self.subTest(chart=chart):
                count, covered = self.ask(COVERED_IN_ONE, "motion-curves", chart)
                self.assertGreater(count, 3)
                self.assertEqual(
                    [words for words in covered if words.startswith(("max", "min"))], [])

    def test_series_upon_each_other_have_one_label(self) -> None:
        # The moment on the ground and the shaking moment of an engine are the same.
        self.open(self.page("planar/four_stroke_engine.yaml"), prefers_reduced_motion="reduce")
        labels = self.ask(
            "const chart = [...document.querySelectorAll('figure.chart')].find((one) =>"
            "  one.querySelector('figcaption').textContent.endsWith('Motion: moment z'));"
            "return [...chart.querySelectorAll('.picture text')].map((one) => one.textContent)"
            "  .filter((one) => /^(max|min)/.test(one));")
        self.assertEqual(len(labels), 2, labels)

    def test_the_names_of_cases_beside_levers(self) -> None:
        page = self.page("gears/simple_planetary.yaml")
        self.expect_free(page, "lever", which=-1)
        labels = self.ask("return [...document.querySelectorAll('[data-picture=lever] text')]"
                          ".map((one) => one.textContent);")
        self.assertIn("carrier held", labels)

    def test_the_gear_scheme_of_a_winch(self) -> None:
        file = self.folder / "winch.yaml"
        file.write_text(WINCH, encoding="utf-8")
        page = self.folder / "winch.html"
        answer = write_page(page, file)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.expect_free(page, "gear-scheme", "power-flow")

    def test_the_output_of_the_8hp70(self) -> None:
        self.expect_free(self.page("transmissions/zf_8hp70.yaml"), "gear-scheme")

    def test_the_legs_of_a_platform(self) -> None:
        self.expect_free(self.page("spatial/ups_platform.yaml"), "motion", "linkage")

    def test_the_pivots_of_a_synthesis(self) -> None:
        self.expect_free(self.page("synthesis/crank_rocker.yaml"), "burmester", "synthesis-motion")

    def test_the_names_of_drawings_on_a_telephone(self) -> None:
        # Of those that are scrolled, and of those that shrink: 425 and 439 pixels wide.
        for name in ("planar/four_bar.yaml", "spatial/rssr.yaml", "spatial/ups_platform.yaml",
                     "cables/weston_hoist.yaml", "cables/block_and_tackle.yaml"):
            with self.subTest(name):
                self.open(self.page(name), width=400, prefers_reduced_motion="reduce")
                drawings = self.ask(CROWDED)
                self.assertTrue(drawings)
                self.assertEqual([one for one in drawings if one[1] or one[2]], [])


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
