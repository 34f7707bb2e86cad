#!/usr/bin/env python3
"""Charts of a page: they tell their values, follow the motion and lead it, and fit a telephone.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import math
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import ROOT, PageCase, program, run_tests, write_page  # noqa: E402

PRESS = "sweeps/press_stroke.yaml"

# Crank 40, connecting rod 160, offset 10 (mm) as the file has them: the ram over the crank's angle.
CRANK, ROD, OFFSET = 40.0, 160.0, 10.0

DWELL = """\
kinestat: 1
space: planar
units: {angle: deg}
ground: frame
bodies: [arm]
couplings: {a: {type: revolute, bodies: [frame, arm], at: [0, 0]}}
actuators: {motor: {coupling: a}}
cases: {run: {motion: {motor: 1 rad/s}, action: {}}}
motion:
  drives:
    - drive: motor
      profile:
        - {to: 90 deg, time: 0.4 s, law: cycloidal}
        - {dwell: 0.2 s}
        - {to: 0 deg, time: 0.4 s, law: cycloidal}
  steps: 20
  trace: [{body: arm, at: [1, 0], name: tip}]
  report: [position]
"""

# A block of 1 kg on a spring of 100 N/m, pushed off with 1 m/s: x = 0.1 m sin(10/s t).
OSCILLATOR = """\
kinestat: 1
space: planar
ground: frame
bodies: {block: {mass: 1, centre_of_mass: [0, 0]}}
couplings: {run: {type: prismatic, bodies: [frame, block], at: [0, 0], axis: x}}
springs:
  hold: {bodies: [frame, block], at: {frame: [-1, 0], block: [0, 0]}, stiffness: 100 N/m, free_length: 1}
actuators: {drive: {coupling: run}}
simulation:
  action: {drive: 0}
  start: {drive: {speed: 1}}
  time: 0.5 s
  steps: 10
  tolerance: 1e-10
  report: [position]
"""

# The marks of a chart: how its frame stands on the picture, what its axes have, points and words.
MARKS = """
const plot = box.querySelector('[data-plot]');
const numbers = (text) => text.split(' ').map(Number);
return [numbers(plot.dataset.plot), numbers(plot.dataset.x), numbers(plot.dataset.y),
  [...plot.querySelectorAll('circle')].map((one) =>
    ['cx', 'cy'].map((name) => Number(one.getAttribute(name)))),
  [...plot.querySelectorAll('text')].map((one) => one.textContent)];
"""

# The chart of a quantity with that many series: figure, its values, and where a value stands.
CHART = """
const figure = [...document.querySelectorAll('figure[data-chart]')].find((one) =>
  one.querySelector('figcaption').textContent.includes(arguments[0]));
const box = figure.querySelector('.picture');
const told = () => [figure.querySelector('.values .at').textContent,
  ...[...figure.querySelectorAll('.values b')].map((one) => one.textContent)];
"""

# The middle of the dots of a chart, and the frame, on the screen.
DOTS = CHART + """
return [...figure.querySelectorAll('[data-cursor] circle')].map((one) => {
  const p = one.getBoundingClientRect();
  return [p.left + p.width / 2, p.top + p.height / 2];
});
"""


def ram(angle: float) -> float:
    """Height of the ram over where it is drawn, the crank at 0: Pythagoras."""
    def height(at: float) -> float:
        return CRANK * math.sin(at) - math.sqrt(ROD**2 - (CRANK * math.cos(at) - OFFSET) ** 2)
    return height(angle) - height(0.0)


class ChartTest(PageCase):
    def press(self, key: str, code: int) -> None:
        for kind in ("keyDown", "keyUp"):
            self.browser.tell("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                              windowsVirtualKeyCode=code)

    def step_of_motion(self) -> int:
        return int(self.ask("return document.querySelector('figure.motion input[type=range]').value;"))

    def marks(self, quantity: str) -> tuple[list[tuple[float, float]], list[str]]:
        """Where they stand by the axes of the chart, and their words."""
        frame, across, up, marks, words = self.ask(CHART + MARKS, quantity)
        left, top, right, bottom = frame
        return [(across[0] + (across[1] - across[0]) * (x - left) / (right - left),
                 up[0] + (up[1] - up[0]) * (bottom - y) / (bottom - top)) for x, y in marks], words

    def test_charts_follow_the_slider(self) -> None:
        self.open(self.page(PRESS), prefers_reduced_motion="reduce")
        for step in (0, 20, 51):
            self.ask("const slider = document.querySelector('figure.motion input[type=range]');"
                     "slider.value = arguments[0]; slider.dispatchEvent(new Event('input'));", step)
            told = self.ask(CHART + "return told();", "position of d.vy")

            self.assertEqual(told[0], f"position of shaft {5 * step} deg")
            value, unit = told[1].split()
            self.assertEqual(unit, "mm")
            self.assertAlmostEqual(float(value), ram(math.radians(5 * step)), delta=1e-4)

    def test_charts_over_time_follow_a_drive_that_dwells_and_comes_back(self) -> None:
        """A cycloid of 0.4 s over 90 deg, a dwell of 0.2 s and the same back, in steps of 0.05 s."""
        path = self.folder / "dwell.yaml"
        path.write_text(DWELL, encoding="utf-8")
        page = self.folder / "dwell.html"
        self.assertEqual(write_page(page, path).returncode, 0)
        self.open(page, prefers_reduced_motion="reduce")
        for step, angle in ((4, 45.0), (8, 90.0), (10, 90.0), (16, 45.0)):
            label = self.ask(
                "const slider = document.querySelector('figure.motion input[type=range]');"
                "slider.value = arguments[0]; slider.dispatchEvent(new Event('input'));"
                "return document.querySelector('figure.motion output').textContent;", step)
            told = self.ask(CHART + "return told();", "position of a.wz")

            self.assertEqual(told, [f"time {round(0.05 * step, 2):g} s", f"{angle:g} deg"])
            self.assertEqual(label, f"motor {angle:g} deg, time {round(0.05 * step, 2):g} s")
        self.ask(CHART + "box.focus();", "position of a.wz")
        for key, code, step in (("Home", 36, 0), ("PageUp", 33, 10), ("ArrowRight", 39, 11)):
            self.press(key, code)
            self.assertEqual(self.step_of_motion(), step, key)

    def test_frames_of_a_row_stand_on_one_line(self) -> None:
        # Words on events stand above the first chart alone, and captions take one line or two.
        for name in (PRESS, "planar/slider_crank.yaml"):
            self.open(self.page(name), prefers_reduced_motion="reduce")
            rows = self.ask(
                "const rows = {};"
                "for (const one of document.querySelectorAll('.motion .charts > figure[data-follows],"
                " .motion .charts .charts > figure')) {"
                "  const top = Math.round(one.getBoundingClientRect().top);"
                "  const plot = one.querySelector('[data-plot] path').ownerSVGElement;"
                "  (rows[top] ??= []).push(plot.getBoundingClientRect().bottom);"
                "}"
                "return Object.values(rows);")
            self.assertTrue(any(len(row) > 1 for row in rows), name)
            for row in rows:
                self.assertLess(max(row) - min(row), 1.5, name)

    def test_the_keyboard_moves_the_cursor_and_the_mechanism(self) -> None:
        self.open(self.page(PRESS), prefers_reduced_motion="reduce")
        self.ask(CHART + "box.focus();", "position of d.vy")
        for key, code, step in (("Home", 36, 0), ("ArrowRight", 39, 1), ("PageUp", 33, 11),
                                ("ArrowLeft", 37, 10), ("End", 35, 72)):
            self.press(key, code)
            self.assertEqual(self.step_of_motion(), step, key)
            self.assertEqual(self.ask(CHART + "return told()[0];", "velocity of d.vy"),
                             f"position of shaft {5 * step} deg")
            self.assertIn(f"position of shaft {5 * step} deg; d.vy ",
                          self.ask(CHART + "return box.getAttribute('aria-valuetext');",
                                   "position of d.vy"))

    def test_values_are_told_under_the_pointer_and_no_longer_beside_it(self) -> None:
        self.open(self.page(PRESS), prefers_reduced_motion="reduce")
        x, y, width, height = self.ask(
            CHART + "box.scrollIntoView({behavior: 'instant', block: 'center'});"
            "const p = box.querySelector('[data-plot]').getBoundingClientRect();"
            "return [p.left, p.top, p.width, p.height];", "position of d.vy")
        self.browser.tell("Input.dispatchMouseEvent", type="mouseMoved", x=x + width / 4,
                          y=y + height / 2)
        time.sleep(0.1)
        place, value = self.ask(CHART + "return told();", "position of d.vy")

        angle = float(place.split()[3])
        self.assertAlmostEqual(angle, 90.0, delta=10.0)
        self.assertAlmostEqual(float(value.split()[0]), ram(math.radians(angle)), delta=1e-4)
        (dot,) = self.ask(DOTS, "position of d.vy")
        self.assertAlmostEqual(dot[0], x + width / 4, delta=width / 72)
        self.assertEqual(self.step_of_motion(), 0)
        self.browser.tell("Input.dispatchMouseEvent", type="mouseMoved", x=1, y=1)
        time.sleep(0.1)
        self.assertEqual(self.ask(CHART + "return told()[0];", "position of d.vy"),
                         "position of shaft 0 deg")

    def test_series_are_chosen(self) -> None:
        self.open(self.page(PRESS), prefers_reduced_motion="reduce")
        seen = ("return [...figure.querySelectorAll('[data-series]')]"
                ".map((one) => one.getClientRects().length > 0);")
        self.assertEqual(self.ask(CHART + seen, "Motion: velocity"), [True] * 2)

        self.ask(CHART + "figure.querySelectorAll('.values input')[1].click();", "Motion: velocity")

        self.assertEqual(self.ask(CHART + seen, "Motion: velocity"), [True, False])
        self.assertEqual(len(self.ask(DOTS, "Motion: velocity")), 1)

    def test_words_stand_within_their_charts(self) -> None:
        # Two charts of paths have a legend, which a list of values replaces.
        for width in (400, 1280):
            with self.subTest(width=width):
                self.open(self.page("spatial/ups_platform.yaml"), width=width)
                beyond = self.ask(
                    "return [...document.querySelectorAll('[data-picture=paths] svg[data-whole]')]"
                    ".map((svg) => { const p = svg.getBoundingClientRect();"
                    "  return [...svg.querySelectorAll('text')]"
                    "    .filter((one) => one.getClientRects().length)"
                    "    .map((one) => [one.textContent, one.getBoundingClientRect()])"
                    "    .filter(([, q]) => q.top < p.top - 1 || q.bottom > p.bottom + 1)"
                    "    .map(([text]) => text); });")
                self.assertEqual(beyond, [[], []])

    def test_extremes_are_marked_where_they_are(self) -> None:
        # The ram turns back where crank and rod are in line, up and down, between the steps of 5
        # degrees. The ram then is as far from the shaft as their difference or their sum, and the
        # crank points away from it or towards it.
        self.open(self.page(PRESS), prefers_reduced_motion="reduce")
        found, words = self.marks("position of d.vy")
        expected = [math.acos(-OFFSET / (ROD - CRANK)),
                    2 * math.pi - math.acos(OFFSET / (ROD + CRANK))]
        for angle, (x, y), word in zip(expected, found, words, strict=True):
            self.assertAlmostEqual(x, math.degrees(angle), delta=0.1)
            self.assertAlmostEqual(y, ram(angle), delta=0.05)
            self.assertEqual(word.split()[1].replace("−", "-"), f"{ram(angle):.2f}")

    def test_extremes_of_a_simulation_come_first_and_are_marked_where_they_are(self) -> None:
        # The block turns back at pi/20 and 3 pi/20 s, between rows of 0.05 s.
        path = self.folder / "oscillator.yaml"
        path.write_text(OSCILLATOR, encoding="utf-8")
        page = self.folder / "oscillator.html"
        answer = write_page(page, path)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.open(page, prefers_reduced_motion="reduce")
        least, at_least, greatest, at_greatest = (float(one) for one in self.ask(
            "const row = [...document.querySelectorAll('.summary tr')]"
            "  .find((one) => one.cells[0].textContent.startsWith('run.vx/position'));"
            "return [...row.cells].slice(1).map((one) => one.textContent);"))
        for value, time_, expected, at in ((greatest, at_greatest, 0.1, math.pi / 20),
                                           (least, at_least, -0.1, 3 * math.pi / 20)):
            self.assertAlmostEqual(value, expected, delta=1e-6)
            self.assertAlmostEqual(time_, at, delta=1e-5)
        found, words = self.marks("position of run.vx")
        self.assertEqual(words, ["max 0.1", "min −0.1"])
        for (x, y), value, at in zip(found, (0.1, -0.1), (math.pi / 20, 3 * math.pi / 20), strict=True):
            self.assertAlmostEqual(x, at, delta=1e-3)
            self.assertAlmostEqual(y, value, delta=1e-3)

    def test_time_has_no_chart(self) -> None:
        page = self.folder / "in_time.html"
        answer = write_page(page, ROOT / "tests/schema/valid/motion_in_time.yaml")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.open(page, prefers_reduced_motion="reduce")
        captions = self.ask("return [...document.querySelectorAll('figure.chart figcaption')]"
                            ".map((one) => one.textContent);")
        self.assertTrue(captions)
        self.assertEqual([one for one in captions if one.endswith("Motion: time")], [])

    # What moves a drawing

    def test_single_steps_and_the_speed(self) -> None:
        self.open(self.page(PRESS), prefers_reduced_motion="reduce")
        press = "document.querySelectorAll('figure.motion [data-step]')[arguments[0]].click();"
        self.ask(press, 1)
        self.ask(press, 1)
        self.assertEqual(self.step_of_motion(), 2)
        self.ask(press, 0)
        self.assertEqual(self.step_of_motion(), 1)

        steps = []
        for speed in ("0.25", "4"):
            self.ask("document.querySelector('[data-speed]').value = arguments[0];"
                     "document.querySelectorAll('[data-step]')[0].click();"
                     "document.querySelector('[data-play]').click();", speed)
            time.sleep(0.45)
            steps.append(self.step_of_motion())
        self.assertLess(steps[0], 8)
        self.assertGreater(steps[1], 2 * steps[0])

    def test_the_force_of_a_bearing_is_an_arrow_while_it_moves(self) -> None:
        # The rod is pushed at its ends alone: the force is along it, 8 kN upwards at the ram.
        text = (ROOT / "mechanisms" / PRESS).read_text(encoding="utf-8")
        text = text[:text.index("published:")].replace("steps: 72, case: pressing}",
                                                       "steps: 72, case: pressing, report: action}")
        file = self.folder / "forces.yaml"
        file.write_text(text, encoding="utf-8")
        page = self.folder / "forces.html"
        self.assertEqual(write_page(page, file).returncode, 0)
        self.open(page, prefers_reduced_motion="reduce")
        self.ask("const choice = document.querySelector('[data-force]');"
                 "choice.value = [...choice.options].find((one) => one.textContent === 'in b').value;"
                 "choice.dispatchEvent(new Event('change'));")
        for step in (0, 7, 40):
            words, line = self.ask(
                "const slider = document.querySelector('figure.motion input[type=range]');"
                "slider.value = arguments[0]; slider.dispatchEvent(new Event('input'));"
                "const line = document.querySelector('[data-layer=acting] line');"
                "return [document.querySelector('figure.motion output').textContent,"
                " ['x1', 'y1', 'x2', 'y2'].map((name) => Number(line.getAttribute(name)))];", step)
            angle = math.radians(5 * step)
            across = CRANK * math.cos(angle) - OFFSET
            up = math.sqrt(ROD**2 - across**2)
            self.assertTrue(words.startswith(f"shaft {5 * step} deg, b "), words)
            self.assertAlmostEqual(float(words.split()[-2]), 8000 * ROD / up, delta=0.6)
            x1, y1, x2, y2 = line
            self.assertAlmostEqual(abs((x2 - x1) / (y2 - y1)), abs(across / up), delta=1e-3)

    def test_an_address_leads_to_a_step(self) -> None:
        path = self.page(PRESS)
        self.open(path, prefers_reduced_motion="no-preference")
        self.ask("location.hash = 'file-1-step-30';")
        time.sleep(0.3)
        self.assertEqual(self.step_of_motion(), 30)
        self.assertEqual(self.ask("return document.querySelector('.step-link').hash;"),
                         "#file-1-step-30")
        self.assertEqual(self.ask("return document.querySelector('[data-play]').textContent;"), "Play")

    def test_a_synthesis_meets_its_positions(self) -> None:
        self.open(self.page("synthesis/crank_rocker.yaml"), prefers_reduced_motion="reduce")
        labels = self.ask("return JSON.parse(document.querySelector('[id$=-poses]').textContent).labels;")
        self.assertEqual(sum(", position " in one for one in labels), 5)
        # Its crank is as long as the file says, 1, and turns about the origin.
        first, other = self.ask(
            "const places = [];"
            "const slider = document.querySelector('figure.motion input[type=range]');"
            "for (const step of [0, 60]) {"
            "  slider.value = step; slider.dispatchEvent(new Event('input'));"
            "  places.push([...document.querySelectorAll('[data-body=dyad-A] circle')]"
            "    .map((one) => one.getBoundingClientRect()).map((p) => [p.x + p.width / 2, p.y + p.height / 2]));"
            "}"
            "return places;")
        self.assertLess(math.dist(first[0], other[0]), 0.5)
        self.assertAlmostEqual(math.dist(*first), math.dist(*other), delta=0.5)
        self.assertGreater(math.dist(first[1], other[1]), 20)

    # What is taken along

    def test_every_figure_is_saved_as_svg_and_png(self) -> None:
        self.open(self.page(PRESS), prefers_color_scheme="dark", prefers_reduced_motion="reduce")
        saved = self.ask(
            "const saved = [];"
            "const names = [];"
            "URL.createObjectURL = (blob) => { saved.push(blob); return 'data:,'; };"
            "HTMLAnchorElement.prototype.click = function () { names.push(this.download); };"
            "const figure = document.querySelector('figure[data-chart]');"
            "for (const one of figure.querySelectorAll('.save button')) one.click();"
            "return new Promise((done) => window.setTimeout(async () => done("
            "  [names, await saved[0].text(), saved[1].type, saved[1].size]), 600));")
        names, text, kind, size = saved
        self.assertEqual([one.rsplit(".")[-1] for one in names], ["svg", "png"])
        self.assertTrue(text.startswith("<svg xmlns="), text[:60])
        self.assertIn('fill="#ffffff"', text)
        self.assertEqual((kind, size > 2000), ("image/png", True))
        count = self.ask("return [document.querySelectorAll('figure').length,"
                         " document.querySelectorAll('figure .save').length];")
        self.assertEqual(count[0], count[1])

    def test_the_model_and_the_rows_of_its_sweep_are_among_the_data(self) -> None:
        self.open(self.page(PRESS))
        names = self.ask("return [...document.querySelectorAll('[data-save]')].map((one) => one.textContent);")
        self.assertIn("press_stroke.yaml", names)
        rows = self.ask(
            "const button = [...document.querySelectorAll('[data-save]')]"
            "  .find((one) => one.textContent === 'press_stroke.sweep.csv');"
            "return JSON.parse(document.getElementById(button.dataset.save).textContent);")
        answer = subprocess.run([program(), "sweep", ROOT / "mechanisms" / PRESS],
                                capture_output=True, encoding="utf-8", check=True)
        self.assertEqual(rows, answer.stdout)


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
