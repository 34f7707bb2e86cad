#!/usr/bin/env python3
"""The motion of a mechanism on its page: what the slider shows is what closed forms say.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import json
import math
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import ROOT, PageCase, program, run_tests, write_page  # noqa: E402

METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3}
PLANAR = ["planar/four_bar.yaml", "planar/slider_crank.yaml", "planar/watt_six_bar.yaml"]
MOVING = [*PLANAR, "spatial/rssr.yaml", "spatial/bennett.yaml", "cables/block_and_tackle.yaml"]

# Writing 0.01 px and matrices of six decimals leave less than this [px].
SHARP = 0.02

# checkVisibility() knows nothing of the attribute `display` of pictures.
IS_SEEN = """
const isSeen = (one) =>
  !one.closest('[display=none]') && getComputedStyle(one).visibility !== 'hidden';
"""

# What is seen of the picture beyond its edges: corners of links, and boxes of the rest.
OUTSIDE = IS_SEEN + """
const svg = document.querySelector('figure.motion svg');
const view = svg.getBoundingClientRect();
const isOut = (x, y) =>
  x < view.left - 1 || x > view.right + 1 || y < view.top - 1 || y > view.bottom + 1;
const corners = (one) => {
  if (one.tagName === 'polygon')
    return [...one.points].map((p) => p.matrixTransform(one.getScreenCTM()));
  const box = one.getBoundingClientRect();
  return [{x: box.left, y: box.top}, {x: box.right, y: box.bottom}];
};
return [...svg.querySelectorAll('circle, polygon, text')].filter(isSeen)
  .filter((one) => corners(one).some((p) => isOut(p.x, p.y))).map((one) => one.outerHTML);
"""

SET = """
const slider = document.querySelector('figure.motion input[type=range]');
slider.value = arguments[0];
slider.dispatchEvent(new Event('input'));
return document.querySelector('figure.motion output').textContent;
"""

# What moves with a body, from the place where it is drawn to where it is seen in the picture.
MATRICES = """
const frame = document.querySelector('figure.motion [data-scale]');
const back = frame.getCTM().inverse();
const found = {};
for (const one of frame.querySelectorAll(':scope > [data-body]')) {
  const m = back.multiply(one.getCTM());
  (found[one.dataset.body.replace(/-\\d+$/, '')] ||= []).push([m.a, m.b, m.c, m.d, m.e, m.f]);
}
return [['scale', 'x0', 'y0'].map((name) => Number(frame.dataset[name])), found];
"""

# Of everything in the picture that is seen: kind, body, and numbers.
SEEN = IS_SEEN + """
const frame = document.querySelector('figure.motion [data-scale]');
return [...frame.querySelectorAll('circle, line, polyline')].filter(isSeen).map((one) => {
  const body = one.closest('[data-body]');
  const value = (name) => Number(one.getAttribute(name));
  return {kind: one.tagName, body: body ? body.dataset.body.replace(/-\\d+$/, '') : '',
          dash: one.getAttribute('stroke-dasharray') || '', ink: one.getAttribute('class'),
          length: one.getTotalLength(), r: value('r'),
          at: one.tagName === 'circle' ? [value('cx'), value('cy')]
            : [(value('x1') + value('x2')) / 2, (value('y1') + value('y2')) / 2],
          ends: [[value('x1'), value('y1')], [value('x2'), value('y2')]]};
});
"""


def placed(matrix: list[float], point: tuple[float, float]) -> tuple[float, float]:
    a, b, c, d, e, f = matrix
    x, y = point
    return (a * x + c * y + e, b * x + d * y + f)


def turned(point: list[float], centre: list[float], axis: int, angle: float) -> list[float]:
    """About an axis of the world through the centre."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    arm = [p - c for p, c in zip(point, centre)]
    result = list(arm)
    result[u] = math.cos(angle) * arm[u] - math.sin(angle) * arm[v]
    result[v] = math.sin(angle) * arm[u] + math.cos(angle) * arm[v]
    return [r + c for r, c in zip(result, centre)]


def solve(rows: list[list[float]], right: list[float]) -> list[float]:
    """Gauss with pivots."""
    table = [[*row, value] for row, value in zip(rows, right)]
    count = len(table)
    for i in range(count):
        pivot = max(range(i, count), key=lambda k: abs(table[k][i]))
        table[i], table[pivot] = table[pivot], table[i]
        for k in range(count):
            if k != i:
                share = table[k][i] / table[i][i]
                table[k] = [a - share * b for a, b in zip(table[k], table[i])]
    return [table[i][-1] / table[i][i] for i in range(count)]


class MotionTest(PageCase):
    def report(self) -> dict:
        return json.loads(self.ask(
            "return document.querySelector('script[data-kind=json]').textContent;"))

    def last_step(self) -> int:
        return int(self.ask(
            "return document.querySelector('figure.motion input[type=range]').max;"))

    def show(self, step: int) -> str:
        return self.ask(SET, step)

    def steps(self) -> list[int]:
        last = self.last_step()
        return sorted({0, 1, last // 3, last // 2, last - 1, last})

    def test_hinges_hold_bodies_together_and_links_keep_their_length(self) -> None:
        for name in PLANAR:
            with self.subTest(name):
                self.open(self.page(name), prefers_reduced_motion="reduce")
                report = self.report()
                metres = METRES[report["mechanism"]["units"]["length"]]
                hinges = [one for one in report["graph"]["couplings"] if one["type"] == "revolute"]
                self.assertGreater(len(hinges), 2)
                farthest = 0.0
                for step in self.steps():
                    self.show(step)
                    (scale, x0, y0), matrices = self.ask(MATRICES)
                    for hinge in hinges:
                        x, y = (metres * value for value in hinge["at"][:2])
                        drawn = (x0 + scale * x, y0 - scale * y)
                        places = [placed(matrix, drawn)
                                  for body in hinge["bodies"] for matrix in matrices.get(body, [])]
                        for place in places:
                            apart = math.dist(place, places[0])
                            self.assertLess(apart, SHARP, (name, step, hinge["name"]))
                            farthest = max(farthest, math.dist(place, drawn))
                    for of_body in matrices.values():
                        for a, b, c, d, _, _ in of_body:
                            # Turned and shifted, neither stretched nor mirrored.
                            self.assertAlmostEqual(a * d - b * c, 1.0, places=5)
                            self.assertAlmostEqual(math.hypot(a, b), 1.0, places=5)
                self.assertGreater(farthest, 20.0, "it moves")

    def test_a_simulation_stands_where_its_rows_say(self) -> None:
        file = self.folder / "run-up.yaml"
        subprocess.run([program(), "new", "--force", "run-up", file], check=True,
                       stdout=subprocess.DEVNULL)
        page = self.folder / "run-up.html"
        self.assertEqual(write_page(page, file).returncode, 0)
        self.open(page, prefers_reduced_motion="reduce")
        rows = json.loads(subprocess.run([program(), "simulate", "--format", "json", file],
                                         check=True, capture_output=True).stdout)["simulation"]
        turn = [one["name"] for one in rows["columns"]].index("a.wz/position")
        last = self.last_step()
        self.assertEqual(last, len(rows["rows"]) - 1)
        for step in (0, 1, last // 3, last):
            self.assertIn(f"time {rows['rows'][step][0]:.6g} s", self.show(step))
            (scale, x0, y0), matrices = self.ask(MATRICES)
            a, b, *_ = matrices["crank"][0]
            angle = math.radians(rows["rows"][step][turn])
            self.assertAlmostEqual(a, math.cos(angle), places=5)
            self.assertAlmostEqual(b, -math.sin(angle), places=5)
            pin = (x0, y0 - scale * 0.04)
            self.assertLess(math.dist(placed(matrices["crank"][0], pin),
                                      placed(matrices["rod"][0], pin)), SHARP)
        self.assertIn("in d", self.ask(
            "return [...document.querySelectorAll('[data-force] option')].map((one) => "
            "one.textContent);"))
        self.assertGreater(len(self.ask(
            "return [...document.querySelectorAll('figure.chart')]"
            ".filter((one) => one.dataset.follows === "
            "document.querySelector('figure.motion').dataset.motion);")), 4)

    def test_the_force_beside_a_drawing_is_the_reaction(self) -> None:
        # What slides bears its weight and mu times that across, whatever drives it along.
        sliding = ROOT / "tests/cli/motion_there_and_back/file.yaml"
        for file, coupling, step, weight, friction in (
                (ROOT / "mechanisms/planar/stick_slip.yaml", "rub", 20, 1.5 * 9.81, 0.25),
                (sliding, "g", 2, 60 * 9.81, 0.1)):
            with self.subTest(coupling):
                page = self.folder / f"force-in-{coupling}.html"
                self.assertEqual(write_page(page, file).returncode, 0)
                self.open(page, prefers_reduced_motion="reduce")
                self.ask("""
                    const choice = document.querySelector('[data-force]');
                    choice.value = [...choice.options].find((one) => one.textContent === arguments[0]).value;
                    choice.dispatchEvent(new Event('change'));""", "in " + coupling)
                force = weight * math.hypot(1.0, friction)
                self.assertIn(f", {coupling} {force:.4g} N", self.show(step))

    def test_a_spatial_linkage_is_seen_where_its_closed_form_is(self) -> None:
        # Hinge a about z at the origin, d about y; the balls b and c are fixed in crank and rocker.
        self.open(self.page("spatial/rssr.yaml"), prefers_reduced_motion="reduce")
        report = self.report()
        at = {one["name"]: one["at"] for one in report["graph"]["couplings"]}
        columns = [one["name"] for one in report["motion"]["columns"]]
        rows = [dict(zip(columns, row)) for row in report["motion"]["rows"]]
        self.assertEqual(self.last_step() + 1, len(rows))

        def seen() -> dict[str, list[float]]:
            found = {}
            for one in self.ask(SEEN):
                if one["kind"] == "circle" and one["r"] == 7:
                    found["b" if one["body"] == "rod" else "c"] = one["at"]
                elif one["dash"] == "7 2 1.5 2":
                    found["a" if one["body"] == "crank" else "d"] = one["at"]
            return found

        # The drawn position tells the projection, which is affine: four points not in a plane.
        self.show(next(i for i, row in enumerate(rows) if abs(row["motor/drive"]) < 1e-12))
        still = seen()
        names = ["a", "b", "c", "d"]
        view = [solve([[*at[name], 1.0] for name in names], [still[name][k] for name in names])
                for k in (0, 1)]

        def projected(point: list[float]) -> list[float]:
            return [sum(w * p for w, p in zip(view[k], [*point, 1.0])) for k in (0, 1)]

        for step, row in enumerate(rows):
            self.show(step)
            places = seen()
            ball_b = turned(at["b"], at["a"], 2, row["motor/drive"])
            ball_c = turned(at["c"], at["d"], 1, row["d.wy/position"])
            # The rod keeps its length: the closed form of the linkage.
            self.assertAlmostEqual(math.dist(ball_b, ball_c), math.dist(at["b"], at["c"]), places=9)
            self.assertLess(math.dist(places["b"], projected(ball_b)), 5 * SHARP, step)
            self.assertLess(math.dist(places["c"], projected(ball_c)), 5 * SHARP, step)
            self.assertLess(math.dist(places["a"], still["a"]), SHARP, step)

    def test_a_spatial_drawing_is_turned_and_turned_back(self) -> None:
        # Balls b and c in the first position; seen from above, z is no longer on the picture.
        self.open(self.page("spatial/rssr.yaml"), prefers_reduced_motion="reduce")
        report = self.report()
        at = {one["name"]: one["at"] for one in report["graph"]["couplings"]}
        drive = [one["name"] for one in report["motion"]["columns"]].index("motor/drive")
        step = next(i for i, row in enumerate(report["motion"]["rows"]) if abs(row[drive]) < 1e-12)
        self.show(step)
        press = ("document.querySelector('figure.motion .picture').dispatchEvent("
                 "new KeyboardEvent('keydown', {key: arguments[0]}));")
        for _ in range(20):
            self.ask(press, "ArrowDown")
        balls = self.ask(
            "return [...document.querySelectorAll('[data-layer=turned] circle')]"
            ".filter((one) => one.getAttribute('r') === '7')"
            ".map((one) => ['cx', 'cy'].map((name) => Number(one.getAttribute(name))));")
        self.assertEqual(len(balls), 2)
        seen = self.ask(
            "const seen = [...document.querySelectorAll('figure.motion [data-scale] > *')]"
            ".filter((one) => one.getClientRects().length > 0);"
            "return [seen.length, seen[0].dataset.layer];")
        self.assertEqual(seen, [1, "turned"])
        # The length of the rod in the plane of x and y, by the scale of the two hinges.
        hinges = self.ask(
            "return [...document.querySelectorAll('[data-layer=turned] text')]"
            ".filter((one) => 'ad'.includes(one.textContent))"
            ".map((one) => ['x', 'y'].map((name) => Number(one.getAttribute(name))));")
        flat = {name: place[:2] for name, place in at.items()}
        self.assertAlmostEqual(math.dist(*balls) / math.dist(*hinges),
                               math.dist(flat["b"], flat["c"]) / math.dist(flat["a"], flat["d"]),
                               places=3)

        self.ask(press, "Home")

        self.assertEqual(self.is_shown("[data-layer=turned] circle"), [])
        self.assertIn(True, self.is_shown("[data-layer=still] circle"))

    def test_a_rope_keeps_its_length_and_its_ends(self) -> None:
        self.open(self.page("cables/block_and_tackle.yaml"), prefers_reduced_motion="reduce")
        lengths = []
        lowest = []
        for step in range(self.last_step() + 1):
            self.show(step)
            rope = [one for one in self.ask(SEEN) if "ks-s-brown" in one["ink"] and not one["body"]]
            self.assertEqual(len([one for one in rope if one["kind"] == "line"]), 5)
            lengths.append(sum(one["length"] for one in rope))
            lowest.append(max(y for one in rope if one["kind"] == "line" for _, y in one["ends"]))
        # Nine pieces of 0.01 px; arcs are chords.
        self.assertLess(max(lengths) - min(lengths), 0.2)
        self.assertGreater(max(lowest) - min(lowest), 50.0)

    def test_only_one_position_is_seen_at_a_time_within_the_picture(self) -> None:
        for name in [*MOVING, "planar/cam_and_follower.yaml"]:
            with self.subTest(name):
                self.open(self.page(name), prefers_reduced_motion="reduce")
                labels = set()
                for step in self.steps():
                    labels.add(self.show(step))
                    self.assertLessEqual(self.ask(
                        IS_SEEN + "return [...document.querySelectorAll('[data-frame]')]"
                        ".filter(isSeen).length;"), 1)
                    self.assertEqual(self.ask(OUTSIDE), [], step)
                self.assertEqual(len(labels), len(self.steps()))
                self.assertEqual(self.browser.messages(), [])

    def test_it_plays_by_itself_but_for_those_who_want_less_motion(self) -> None:
        state = ("return [document.querySelector('figure.motion input[type=range]').value,"
                 " document.querySelector('figure.motion button').textContent];")
        for name in MOVING:
            for wish in ("reduce", "no-preference"):
                with self.subTest(name, wish=wish):
                    self.open(self.page(name), prefers_reduced_motion=wish)
                    before, words = self.ask(state)
                    time.sleep(0.3)
                    after, _ = self.ask(state)

                    self.assertEqual(words, "Play" if wish == "reduce" else "Pause")
                    self.assertEqual(before == after, wish == "reduce")

    def test_the_button_stops_and_goes_on(self) -> None:
        self.open(self.page("planar/four_bar.yaml"), prefers_reduced_motion="reduce")
        press = "document.querySelector('figure.motion button').click();"
        state = "return document.querySelector('figure.motion input[type=range]').value;"

        self.ask(press)
        time.sleep(0.3)
        self.ask(press)
        stopped = self.ask(state)
        time.sleep(0.3)

        self.assertNotEqual(stopped, "0")
        self.assertEqual(self.ask(state), stopped)


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
