#!/usr/bin/env python3
"""Pictures that move by themselves: at every time they show what closed forms say.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import json
import math
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import ROOT, PageCase, program, run_tests  # noqa: E402

PLANAR = ["planar/four_bar.yaml", "planar/slider_crank.yaml", "planar/watt_six_bar.yaml"]
FRAMES = ["spatial/rssr.yaml", "spatial/bennett.yaml", "cables/block_and_tackle.yaml"]
METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3}
SECONDS = 4.0

# Hundredths of a pixel and of a degree are written; between key frames arcs are chords of 5 degrees
# at most.
SHARP = 0.1
BETWEEN = 0.5

SEEK = """
const svg = document.documentElement;
svg.pauseAnimations();
svg.setCurrentTime(arguments[0]);
"""

MATRICES = SEEK + """
const frame = document.querySelector('[data-scale]');
const back = frame.getCTM().inverse();
const found = {};
for (const one of frame.querySelectorAll(':scope > [data-body]')) {
  const m = back.multiply(one.getCTM());
  (found[one.dataset.body.replace(/-\\d+$/, '')] ||= []).push([m.a, m.b, m.c, m.d, m.e, m.f]);
}
return [['scale', 'x0', 'y0'].map((name) => Number(frame.dataset[name])), found];
"""

SEEN_FRAMES = SEEK + """
return [...document.querySelectorAll('[data-frame]')]
  .filter((one) => getComputedStyle(one).display !== 'none').map((one) => Number(one.dataset.frame));
"""

# The end of the rope in the hand, and what moves with the hand.
ROPE = SEEK + """
const seen = [...document.querySelectorAll('[data-cable=rope_1] line')]
  .filter((one) => one.getClientRects().length > 0);
const hand = document.querySelector('[data-body=hand-1]:has(polygon)');
const m = document.querySelector('[data-scale]').getCTM().inverse().multiply(hand.getCTM());
return [seen.map((one) => ['x1', 'y1'].map((name) => Number(one.getAttribute(name)))),
        [m.a, m.b, m.c, m.d, m.e, m.f]];
"""

# Corners and circles of what is seen beyond the edges.
OUTSIDE = SEEK + """
const view = svg.getBoundingClientRect();
const isOut = (p) => p.x < view.left - 1 || p.x > view.right + 1 ||
  p.y < view.top - 1 || p.y > view.bottom + 1;
const corners = (one) => {
  if (one.tagName === 'polygon')
    return [...one.points].map((p) => p.matrixTransform(one.getScreenCTM()));
  const box = one.getBoundingClientRect();
  return [{x: box.left, y: box.top}, {x: box.right, y: box.bottom}];
};
return [...svg.querySelectorAll('circle, polygon, text')]
  .filter((one) => one.getClientRects().length > 0 && corners(one).some(isOut))
  .map((one) => one.outerHTML);
"""


def placed(matrix: list[float], point: tuple[float, float]) -> tuple[float, float]:
    a, b, c, d, e, f = matrix
    x, y = point
    return (a * x + c * y + e, b * x + d * y + f)


def hinges_of(name: str) -> dict[str, tuple[list[str], tuple[float, float]]]:
    """The bodies and the place [m] of each turning pair."""
    done = subprocess.run([program(), "analyze", "--format", "json", ROOT / "mechanisms" / name],
                          capture_output=True, encoding="utf-8", check=True, timeout=120)
    report = json.loads(done.stdout)
    metres = METRES[report["mechanism"]["units"]["length"]]
    return {one["name"]: (one["bodies"], (metres * one["at"][0], metres * one["at"][1]))
            for one in report["graph"]["couplings"] if one["type"] == "revolute"}


class AnimationTest(PageCase):
    @classmethod
    def picture(cls, name: str) -> Path:
        path = cls.folder / (Path(name).stem + ".svg")
        if not path.exists():
            subprocess.run([program(), "plot", "animation", "-o", path, ROOT / "mechanisms" / name],
                           capture_output=True, encoding="utf-8", check=True, timeout=120)
        return path

    def test_hinges_hold_bodies_together_at_every_time(self) -> None:
        for name in PLANAR:
            with self.subTest(name):
                self.open(self.picture(name))
                hinges = hinges_of(name)
                farthest = 0.0
                for share in (0.0, 0.013, 0.21, 0.37, 0.5, 0.501, 0.77, 0.999):
                    (scale, x0, y0), matrices = self.ask(MATRICES, share * SECONDS)
                    for hinge, (bodies, (x, y)) in hinges.items():
                        drawn = (x0 + scale * x, y0 - scale * y)
                        places = [placed(matrix, drawn)
                                  for body in bodies for matrix in matrices.get(body, [])]
                        for place in places:
                            self.assertLess(math.dist(place, places[0]), BETWEEN, (share, hinge))
                            farthest = max(farthest, math.dist(place, drawn))
                self.assertGreater(farthest, 20.0, "it moves")

    def test_the_crank_turns_evenly(self) -> None:
        self.open(self.picture("planar/four_bar.yaml"))
        for share in (0.0, 0.1, 0.3, 0.6, 0.9):
            (scale, x0, y0), matrices = self.ask(MATRICES, share * SECONDS)
            turn = 2 * math.pi * share
            x = math.cos(turn) - 3 * math.sin(turn)
            y = math.sin(turn) + 3 * math.cos(turn)
            place = placed(matrices["crank"][0], (x0 + scale, y0 - 3 * scale))
            self.assertLess(math.dist(place, (x0 + scale * x, y0 - scale * y)), SHARP, share)

    def test_the_slider_goes_there_and_back(self) -> None:
        # At x = 15 cos t + sqrt(13^2 - (15 sin t)^2); the crank goes back by 110 degrees from (9, 12).
        self.open(self.picture("planar/slider_crank.yaml"))
        for share in (0.0, 0.25, 0.5, 0.75, 1 - 1e-6):
            (scale, _, _), matrices = self.ask(MATRICES, share * SECONDS)
            turn = math.atan2(12, 9) - math.radians(110) * (1 - abs(2 * share - 1))
            x = 15 * math.cos(turn) + math.sqrt(169 - (15 * math.sin(turn)) ** 2)
            self.assertAlmostEqual(matrices["slider"][0][4], scale * (x - 14), delta=SHARP)

    def test_one_frame_is_seen_at_a_time(self) -> None:
        for name in FRAMES:
            with self.subTest(name):
                self.open(self.picture(name))
                seen = [self.ask(SEEN_FRAMES, share * SECONDS)
                        for share in (0.0, 0.1, 0.26, 0.49, 0.51, 0.74, 0.9, 0.999)]
                self.assertEqual([len(one) for one in seen], [1] * len(seen))
                self.assertEqual(seen[0], [0])
                self.assertGreater(len({one[0] for one in seen}), 3)

    def test_what_hangs_on_a_rope_moves_with_it(self) -> None:
        self.open(self.picture("cables/block_and_tackle.yaml"))
        ends, matrix = self.ask(ROPE, 0.0)
        begin = tuple(ends[0])
        farthest = 0.0
        for share in (0.1, 0.237, 0.41, 0.6, 0.83):
            ends, matrix = self.ask(ROPE, share * SECONDS)
            self.assertEqual(len(ends), 1)
            self.assertLess(math.dist(ends[0], placed(matrix, begin)), SHARP, share)
            farthest = max(farthest, math.dist(ends[0], begin))
        self.assertGreater(farthest, 100.0)

    def test_everything_stays_within_the_picture(self) -> None:
        for name in [*PLANAR, *FRAMES, "planar/cam_and_follower.yaml"]:
            with self.subTest(name):
                self.open(self.picture(name))
                for share in (0.0, 0.13, 0.29, 0.5, 0.62, 0.81):
                    self.assertEqual(self.ask(OUTSIDE, share * SECONDS), [], share)

    def test_it_plays_in_an_img_of_a_page(self) -> None:
        for name in [PLANAR[0], FRAMES[0]]:
            with self.subTest(name):
                page = self.folder / "img.html"
                page.write_text(f'<!doctype html><img src="{self.picture(name).name}" width="400">',
                                encoding="utf-8")
                self.open(page)
                shots = []
                for number in range(2):
                    time.sleep(0.3)
                    shots.append(self.folder / f"shot-{number}.png")
                    self.browser.picture(shots[-1])
                self.assertNotEqual(shots[0].read_bytes(), shots[1].read_bytes())

    def test_it_is_one_file_without_script(self) -> None:
        for name in [*PLANAR, *FRAMES]:
            with self.subTest(name):
                text = self.picture(name).read_text(encoding="utf-8")
                tags = {one.tag.rpartition("}")[2] for one in ElementTree.fromstring(text).iter()}
                self.assertNotIn("script", tags)
                self.assertNotIn("href", text)
                self.assertTrue({"animate", "animateTransform"} & tags)


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
