#!/usr/bin/env python3
"""Arrows of forces and couples beside a moving drawing: they are what closed forms say, whatever the
motion reports.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import json
import math
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import PageCase, program, run_tests, write_page  # noqa: E402

# A press of crank 40 mm and rod 160 mm, with friction in its guide: at the dead centres, 90 and
# 270 deg on, the ram turns back, and so does friction.
RUBBING = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, ram]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0, 40]}
  c: {type: revolute, bodies: [rod, ram], at: [sqrt(160^2 - 40^2), 0]}
  d: {type: prismatic, bodies: [frame, ram], at: [sqrt(160^2 - 40^2), 0], axis: x, friction: {mu: 0.1}}
actuators: {motor: {coupling: a}, press: {coupling: d}}
cases: {pressing: {motion: {motor: 1 rad/s}, action: {press: -1000 N}, input: motor, output: press}}
motion: {drive: motor, to: 360 deg, steps: 4, case: pressing}
"""

# Two hinges in one place hold the arm; how they share its load nothing tells.
SHARED = """\
kinestat: 1
space: planar
ground: frame
bodies: [arm]
couplings:
  a: {type: revolute, bodies: [frame, arm], at: [0, 0]}
  b: {type: revolute, bodies: [frame, arm], at: [0, 0]}
actuators: {motor: {coupling: a}}
cases: {run: {motion: {motor: 1 rad/s}, loads: {pull: {body: arm, force: [3 N, 4 N], at: [1, 0]}}}}
motion: {drive: motor, to: 90 deg, steps: 3, case: run}
"""

CHOOSE = """
const figure = document.querySelector('figure.motion');
const choice = figure.querySelector('[data-force]');
choice.value = arguments[0];
choice.dispatchEvent(new Event('change'));
const slider = figure.querySelector('input[type=range]');
slider.value = arguments[1];
slider.dispatchEvent(new Event('input'));
return figure.querySelector('output').textContent;
"""

OPTIONS = ("return [...document.querySelectorAll('figure.motion [data-force] option')]"
           ".map((one) => one.textContent);")

# Ends of the shafts, heads left out, and tips; the first corner of a head.
ARROWS = """
const layer = document.querySelector('figure.motion [data-layer=acting]');
return [...layer.querySelectorAll('line')].map((one) => {
  const tip = [...one.nextElementSibling?.points || [], ...one.previousElementSibling?.points || []][0];
  return [...['x1', 'y1'].map((name) => Number(one.getAttribute(name))), tip.x, tip.y];
});
"""

# What is seen of the balls.
BALLS = """
return [...document.querySelectorAll('figure.motion svg circle')]
  .filter((one) => one.getClientRects().length > 0 && Number(one.getAttribute('r')) === 7 &&
    getComputedStyle(one).visibility === 'visible')
  .map((one) => ['cx', 'cy'].map((name) => Number(one.getAttribute(name))));
"""


class ForceTest(PageCase):
    def show(self, choice: str, step: int) -> str:
        return self.ask(CHOOSE, choice, step)

    def open_text(self, name: str, text: str) -> None:
        file = self.folder / f"{name}.yaml"
        file.write_text(text, encoding="utf-8")
        page = self.folder / f"{name}.html"
        write_page(page, file)
        self.open(page, prefers_reduced_motion="reduce")

    def last_step(self) -> int:
        return int(self.ask("return document.querySelector('figure.motion input[type=range]').max;"))

    def test_forces_stand_beside_motions_that_report_none(self) -> None:
        # In the drawn position, by the closed forms that the files name: the rod of the slider-crank
        # pulls along its line; the cam pushes with 200 N by 41/40; the rod of the spatial linkage
        # along (1, 1, 1) with 75 N across; the press by power.
        for name, step, choice, told in (
                ("planar/slider_crank.yaml", 0, "in d", "d 2.4 N"),
                ("planar/slider_crank.yaml", 0, "drive Tin", "Tin 33.6 N*m"),
                ("planar/cam_and_follower.yaml", 0, "in c", "c 205 N"),
                ("planar/cam_and_follower.yaml", 0, "in g", "g 45 N"),
                ("spatial/rssr.yaml", 6, "in b", f"b {75 * math.sqrt(3):.4g} N"),
                ("sweeps/press_stroke.yaml", 0, "drive shaft", "shaft 320 N*m")):
            with self.subTest(name, choice=choice):
                self.open(self.page(name), prefers_reduced_motion="reduce")
                self.assertIn(choice, self.ask(OPTIONS))
                self.assertTrue(self.show(choice, step).endswith(", " + told))
                self.assertEqual(self.browser.messages(), [])

    def test_the_guide_of_a_press_bears_what_its_rod_leans(self) -> None:
        # Rod 160, crank 40, offset 10 (mm): across the guide 8 kN times the tangent of the rod.
        self.open(self.page("sweeps/press_stroke.yaml"), prefers_reduced_motion="reduce")
        lean = [math.tan(math.asin((40 * math.cos(math.radians(5 * step)) - 10) / 160))
                for step in range(73)]
        most = max(map(abs, lean))
        for step in (0, 7, 18, 30, 55, 72):
            told = self.show("in d", step).split(", ")[-1].split()
            self.assertEqual([told[0], told[2]], ["d", "N"])
            self.assertAlmostEqual(float(told[1]), 8000 * abs(lean[step]), delta=0.6)
            x, y, a, b = self.ask(ARROWS)[0]
            self.assertAlmostEqual(math.hypot(a - x, b - y), 70 * abs(lean[step]) / most, delta=0.1)
            self.assertAlmostEqual(y, b, delta=0.01, msg="the guide stands upright")
        # The rod pushes the crank pin outwards where it leans: the arrow turns with it.
        self.show("in d", 0)
        x, _, a, _ = self.ask(ARROWS)[0]
        self.show("in d", 36)
        x_back, _, a_back, _ = self.ask(ARROWS)[0]
        self.assertLess((a - x) * (a_back - x_back), 0.0)

    def test_a_starter_has_its_forces(self) -> None:
        for starter in ("slider-crank", "press", "cam", "rssr"):
            with self.subTest(starter):
                file = self.folder / f"of-{starter}.yaml"
                subprocess.run([program(), "new", "--force", starter, file], check=True,
                               stdout=subprocess.DEVNULL)
                self.open_text("new-" + starter, file.read_text(encoding="utf-8"))
                self.assertIn("of all couplings", self.ask(OPTIONS))
                self.show("of all couplings", self.last_step() // 3)
                self.assertGreater(len(self.ask(ARROWS)), 2)

    def test_a_force_in_space_lies_along_its_rod_and_turns_with_the_drawing(self) -> None:
        self.open(self.page("spatial/rssr.yaml"), prefers_reduced_motion="reduce")
        for turns in (0, 7, 5):
            for _ in range(turns):
                self.ask("document.querySelector('figure.motion .picture').dispatchEvent("
                         "new KeyboardEvent('keydown', {key: 'ArrowLeft'}));")
            self.show("in b", 10)
            balls = self.ask(BALLS)
            (x, y, a, b), = self.ask(ARROWS)
            at, other = sorted(balls, key=lambda p: math.dist(p, (x, y)))
            self.assertLess(math.dist(at, (x, y)), 0.3, "it begins in its ball")
            across = (a - x) * (other[1] - y) - (b - y) * (other[0] - x)
            self.assertLess(abs(across) / (math.dist((a, b), (x, y)) * math.dist(other, (x, y))), 0.01)

    def test_where_friction_reverses_it_says_so(self) -> None:
        self.open_text("rubbing", RUBBING)
        said = [self.show("in d", step) for step in range(5)]
        undetermined = ["undetermined here: friction reverses" in one for one in said]
        self.assertEqual(undetermined, [False, True, False, True, False])
        self.show("of all couplings", 1)
        self.assertEqual(self.ask(ARROWS), [])
        self.show("in d", 0)
        self.assertEqual(len(self.ask(ARROWS)), 1)

    def test_the_longest_of_all_is_said_to_be_that_of_the_steps(self) -> None:
        self.open_text("rubbing", RUBBING)
        words = self.show("of all couplings", 0)
        self.assertIn(", longest at these steps ", words)
        told = float(words.split("at these steps ")[1].split()[0])
        values = []
        for coupling in "abcd":
            for step in (0, 2, 4):
                values.append(float(self.show("in " + coupling, step).split(", ")[-1].split()[1]))
        self.assertEqual(told, max(values))

    def test_what_equilibrium_leaves_open_is_said(self) -> None:
        self.open_text("shared", SHARED)
        self.assertIn(", undetermined here: equilibrium leaves it open", self.show("in b", 1))
        arm = math.radians(30)
        torque = 3 * math.sin(arm) - 4 * math.cos(arm)
        self.assertTrue(self.show("drive motor", 1).endswith(f", motor {-torque:.4g} N*m"))
        self.assertTrue(self.show("load pull", 1).endswith(", pull 5 N"))
        # Along (3, 4) in the world.
        (x, y, a, b), = self.ask(ARROWS)
        self.assertAlmostEqual((a - x) / (y - b), 3 / 4, places=2)

    def test_arrows_are_found_in_little_room(self) -> None:
        page = self.page("planar/four_stroke_engine.yaml").read_text(encoding="utf-8")
        poses = page.split('id="file-1-poses">')[1].split("</script>")[0]
        data = json.loads(poses)
        steps = len(data["labels"])
        self.assertGreater(len(data["acting"]), 8)
        # Four short numbers of an arrow at a step.
        self.assertLess(len(poses), 60 * steps * len(data["acting"]))


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
