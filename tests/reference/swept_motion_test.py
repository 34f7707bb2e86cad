"""Figures of motions in sweeps: closed forms, and the motion of every state by itself.

Usage: swept_motion_test.py KINESTAT MECHANISMS
"""

from __future__ import annotations

import json
import math
import re
from pathlib import Path

import motion_case
import program
from motion_case import in_library
from reference_test_case import ReferenceTest
from swept_case import refused, swept

EXACT = 1e-12

# From a at the origin: crank r along x, rod l, slider on y = e.
SLIDER_CRANK = """
kinestat: 1
space: planar
parameters: {r: 2, l: 5, e: 0, force: 10 N}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [r, 0]}
  c: {type: revolute, bodies: [rod, slider], at: [r + sqrt(l^2 - e^2), e]}
  s: {type: prismatic, bodies: [frame, slider], at: [r + sqrt(l^2 - e^2), e], axis: x}
actuators: {motor: {coupling: a}, press: {coupling: s}}
cases:
  push: {motion: {motor: 1 rad/s}, action: {press: -force}, input: motor, output: press}
motion: {drive: motor, from: 10 deg, to: 370 deg, steps: 72, trace: [{body: crank, at: [r, 0]}]}
"""

# a and d on the ground, the crank along it; the coupler above.
FOUR_BAR = """
kinestat: 1
space: planar
units: {angle: deg}
parameters:
  base: 6
  r: 2
  k: 5
  o: 5
  x: (k^2 - o^2 + (base - r)^2)/(2*(base - r))
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [r, 0]}
  c: {type: revolute, bodies: [coupler, rocker], at: [r + x, "sqrt(max(k^2 - x^2, 0))"]}
  d: {type: revolute, bodies: [frame, rocker], at: [base, 0]}
actuators: {motor: {coupling: a}, load: {coupling: d}}
cases:
  turn: {motion: {motor: 1 rad/s}, action: {load: 1 N*m}, input: motor, output: load}
motion: {drive: motor, to: 360 deg, steps: 72, case: turn}
"""

# The same, drawn with the ends of coupler and rocker apart.
APART = FOUR_BAR.replace('at: [r + x, "sqrt(max(k^2 - x^2, 0))"]',
                         "at: {coupler: [r + k, 0], rocker: [base, o]}")


# A column that no linkage among several has.
BODIES = {FOUR_BAR: "coupler.at.x.mean", SLIDER_CRANK: "rod.at.x.mean"}


def least_slope(r: float, l: float) -> float:
    """Of the slider by the angle of the crank, by golden sections of the first half turn."""

    def slope(phi: float) -> float:
        return (-r * math.sin(phi) - r * r * math.sin(phi) * math.cos(phi)
                / math.sqrt(l * l - (r * math.sin(phi)) ** 2))

    low, high = 0.0, math.pi
    share = (math.sqrt(5) - 1) / 2
    for _ in range(80):
        width = share * (high - low)
        if slope(low + width) < slope(high - width):
            low = high - width
        else:
            high = low + width
    return slope((low + high) / 2)


class ClosedForms(ReferenceTest):
    """What textbooks say of whole motions."""

    def test_the_stroke_of_a_slider_crank_is_between_its_dead_centres(self) -> None:
        rows, _ = swept(SLIDER_CRANK,
                        "{vary: {r: [1, 1.5, 2], l: [4, 5, 7], e: [0, 0.5, -1.25]}, "
                        "report: [s.vx.position.range, dead_points, s.vx.dead_points]}")
        self.assertEqual(27, len(rows))
        for row in rows:
            r, l, e = row["r"], row["l"], row["e"]
            stroke = math.sqrt((l + r) ** 2 - e * e) - math.sqrt((l - r) ** 2 - e * e)
            self.assertEqual("solved", row["status"])
            self.assertEqual("", row["case"])  # the file's motion has none
            self.assertAlmostEqual(stroke, row["s.vx.position.range [m]"], delta=EXACT * stroke)
            if e == 0:
                self.assertAlmostEqual(2 * r, row["s.vx.position.range [m]"], delta=EXACT)
            self.assertEqual(2, row["dead_points"])
            self.assertEqual(2, row["s.vx.dead_points"])

    def test_a_crank_rocker_swings_between_its_stretched_and_folded_positions(self) -> None:
        rows, _ = swept(FOUR_BAR,
                        "{vary: {r: [1, 1.5, 2], k: [4.5, 5], o: [4, 5], base: [5.5, 6]}, "
                        "report: [d.wz.position.range, transmission_angle.least, "
                        "d.wz.dead_points]}")
        self.assertEqual(24, len(rows))
        for row in rows:
            r, k, o, g = row["r"], row["k"], row["o"], row["base"]

            def at_ground(reach: float) -> float:
                return math.acos((g * g + o * o - reach * reach) / (2 * g * o))

            def at_rocker(base: float) -> float:
                angle = math.degrees(math.acos((k * k + o * o - base * base) / (2 * k * o)))
                return min(angle, 180 - angle)

            swing = math.degrees(at_ground(k + r) - at_ground(k - r))
            least = min(at_rocker(g - r), at_rocker(g + r))
            self.assertEqual("solved", row["status"])
            self.assertEqual("turn", row["case"])
            self.assertAlmostEqual(swing, row["d.wz.position.range [deg]"], delta=EXACT * 360)
            self.assertAlmostEqual(least, row["transmission_angle.least [deg]"], delta=1e-10)
            self.assertEqual(2, row["d.wz.dead_points"])

    def test_dead_points_are_those_within_the_motion(self) -> None:
        """Drawn at its outer dead centre, a slider turns back there only if the crank goes round."""
        for begin, end, expected in ((0, 180, 0), (0, 360, 2), (-180, 180, 2), (0, 540, 2),
                                     (180, 270, 0), (90, 180, 0), (10, 370, 2), (-90, 90, 1),
                                     (0, 720, 4)):
            text = re.sub(r"\nmotion: {.*}",
                          f"\nmotion: {{drive: motor, from: {begin} deg, to: {end} deg, steps: 24}}",
                          SLIDER_CRANK)
            rows, _ = swept(text, "{vary: {r: [1, 1.5], l: [4, 5], e: [0]}, "
                                  "report: [s.vx.dead_points, dead_points]}")
            for row in rows:
                self.assertEqual(expected, row["s.vx.dead_points"], f"{begin} to {end}")
                self.assertEqual(expected, row["dead_points"], f"{begin} to {end}")

    def test_a_dead_point_at_which_a_drive_turns_back_or_rests_counts_once(self) -> None:
        """The crank comes to a dead centre of the slider by a law, rests, and goes back or on."""
        law = "time: 1 s, law: cycloidal"
        for way, expected in ((f"{{to: 180 deg, {law}}}, {{to: 90 deg, {law}}}", 1),
                              (f"{{to: 180 deg, {law}}}, {{dwell: 1 s}}, {{to: 90 deg, {law}}}", 1),
                              (f"{{to: 180 deg, {law}}}, {{dwell: 1 s}}, {{to: 270 deg, {law}}}", 1),
                              (f"{{to: 180 deg, {law}}}, {{to: 0 deg, {law}}}", 2),
                              (f"{{dwell: 1 s}}, {{to: 180 deg, {law}}}, {{dwell: 1 s}}", 0),
                              (f"{{dwell: 1 s}}, {{to: 200 deg, {law}}}, {{to: 180 deg, {law}}}", 1)):
            begin = 90 if "to: 90" in way or "to: 270" in way else 0
            text = re.sub(r"\nmotion: {.*}",
                          f"\nmotion: {{drive: motor, from: {begin} deg, steps: 24, profile: [{way}]}}",
                          SLIDER_CRANK)
            rows, _ = swept(text, "{vary: {l: [4, 5], r: [1], e: [0]}, report: [s.vx.dead_points]}")
            for row in rows:
                self.assertEqual(expected, row["s.vx.dead_points"], way)

    def test_extremes_of_angles_do_not_hang_on_the_steps(self) -> None:
        """Between coupler and rocker, where crank and frame are in line; folded, at right angles."""
        text = FOUR_BAR.replace("to: 360 deg, steps: 72", "from: 3 deg, to: 363 deg, steps: n")
        for steps in (17, 36, 100):
            rows, _ = swept(text.replace("steps: n", f"steps: {steps}"),
                            "{vary: {r: [1, 1.5, 2], k: [4.5, 5], o: [4, 5], base: [5.5, 6]}, "
                            "report: [transmission_angle.least, transmission_angle.greatest, "
                            "c.wz.position.range]}")
            for row in rows:
                r, k, o, g = row["r"], row["k"], row["o"], row["base"]
                narrow, wide = (math.degrees(math.acos((k * k + o * o - base * base)
                                                       / (2 * k * o)))
                                for base in (g - r, g + r))
                folded = [min(angle, 180 - angle) for angle in (narrow, wide)]
                greatest = 90 if narrow < 90 < wide else max(folded)
                self.assertAlmostEqual(min(folded), row["transmission_angle.least [deg]"],
                                       delta=1e-9)
                self.assertAlmostEqual(greatest, row["transmission_angle.greatest [deg]"],
                                       delta=1e-9)
                self.assertAlmostEqual(wide - narrow, row["c.wz.position.range [deg]"], delta=1e-9)

    def test_the_mean_is_over_the_way_of_the_drive(self) -> None:
        """The crank pin over half a turn: 2 r / pi. Fewer steps than 24 are divided into equal parts."""
        text = SLIDER_CRANK.replace("from: 10 deg, to: 370 deg, steps: 72",
                                    "to: 180 deg, steps: n").replace("e: 0,", "e: 0, n: 8,")
        rows, _ = swept(text, "{vary: {n: [1, 2, 9, 60], r: [1, 2]}, report: "
                              "[crank.1.at.y.mean, crank.1.at.y.range, crank.1.at.x.peak]}")
        for row in rows:
            r = row["r"]
            self.assertAlmostEqual(2 * r / math.pi, row["crank.1.at.y.mean [m]"], delta=1e-7)
            self.assertAlmostEqual(r, row["crank.1.at.x.peak [m]"], delta=EXACT)

    def test_each_case_moves_with_its_own_loads(self) -> None:
        """By power the motor bears F ds/dphi; crank and rod drive a force that is twice as large."""
        text = SLIDER_CRANK.replace("motion: {drive", """  pull: {motion: {motor: 2 rad/s},
         action: {press: 2*force}, input: motor, output: press}
motion: {drive""")
        rows, _ = swept(text, "{vary: {r: [1, 2], force: [10 N, 30 N]}, "
                              "cases: [push, pull], report: [motor.greatest, "
                              "motor.peak, s.vx.velocity.least, s.vx.position.range]}")
        self.assertEqual(["push", "pull"] * 4, [row["case"] for row in rows])
        for row in rows:
            r, l, force = row["r"], 5, row["force [N]"]
            least = least_slope(r, l)  # the rod is symmetrical about the guide
            size = -force * least * (2 if row["case"] == "pull" else 1)
            speed = 2 if row["case"] == "pull" else 1
            self.assertEqual("solved", row["status"])
            self.assertAlmostEqual(size, row["motor.peak [N*m]"], delta=1e-11 * size)
            self.assertAlmostEqual(size, row["motor.greatest [N*m]"], delta=1e-11 * size)
            self.assertAlmostEqual(speed * least, row["s.vx.velocity.least [m/s]"],
                                   delta=1e-11 * size)
            self.assertAlmostEqual(2 * r, row["s.vx.position.range [m]"], delta=EXACT)



class Statuses(ReferenceTest):
    """States whose motion is not what was asked for."""

    def test_links_that_do_not_reach_are_not_assembled(self) -> None:
        rows, said = swept(APART, "{vary: {k: [0.5, 5]}, report: [d.wz.position.range, "
                                     "transmission_angle.least, dead_points]}")
        self.assertEqual(["not_assembled", "solved"], [row["status"] for row in rows])
        self.assertEqual([None] * 3, list(rows[0].values())[2:5])
        self.assertIn("not_assembled", said)

    def test_a_crank_that_cannot_turn_comes_to_its_limit(self) -> None:
        # By Grashof: 3 + 6 > 4 + 4.
        rows, _ = swept(FOUR_BAR, "{vary: {r: [1, 3]}, report: [d.wz.position.range, dead_points]}",
                        "--set", "k=4", "--set", "o=4")
        self.assertEqual(["solved", "limited"], [row["status"] for row in rows])
        self.assertEqual([None, None], list(rows[1].values())[2:4])

    def test_points_that_are_drawn_apart_are_closed_first(self) -> None:
        rows, _ = swept(APART, "{vary: {r: [1, 2]}, report: [d.wz.position.range]}")
        for row in rows:
            r, k, o, g = row["r"], 5, 5, 6
            angles = [math.acos((g * g + o * o - reach * reach) / (2 * g * o))
                      for reach in (k + r, k - r)]
            self.assertEqual("solved", row["status"])  # W0504 says what was closed
            self.assertAlmostEqual(math.degrees(angles[0] - angles[1]),
                                   row["d.wz.position.range [deg]"], delta=EXACT * 360)

    def test_a_position_without_a_value_leaves_the_figure_without_one(self) -> None:
        # From the dead centre, where the slider rests: no force of the motor holds it.
        text = SLIDER_CRANK.replace("from: 10 deg, to: 370 deg", "to: 360 deg")
        rows, _ = swept(text, "{vary: {r: [2]}, cases: [push], report: [s.vx.position.range, "
                              "mechanical_advantage.least]}")
        self.assertEqual("no_value", rows[0]["status"])
        self.assertAlmostEqual(4, rows[0]["s.vx.position.range [m]"], delta=EXACT)
        self.assertIsNone(rows[0]["mechanical_advantage.least [1/m]"])


class Choices(ReferenceTest):
    """Names in formulas, and names that are wrong."""

    def test_rows_are_kept_and_ranked_by_figures(self) -> None:
        sweep = ("{vary: {r: {from: 1, to: 2, step: 0.125}, l: [4, 5, 6]}, report: "
                 "[s.vx.position.range, crank.1.at.x.peak], keep: [s.vx.position.range > 3 m, "
                 "crank.1.at.x.peak < 1.9 m]}")
        rows, _ = swept(SLIDER_CRANK, sweep)
        self.assertEqual([1.625, 1.75, 1.875], sorted({row["r"] for row in rows}))
        best, _ = swept(SLIDER_CRANK, sweep, "--top", "1", "--by",
                        "abs(s.vx.position.range - 0.6*l*1 m)", "--order", "smallest")
        self.assertEqual((1.75, 6), (best[0]["r"], best[0]["l"]))

    def test_mistakes_are_told_with_a_guess(self) -> None:
        for name, code, hint in [
                ("s.vx.position.rnge", "E0313", "did you mean 'range'?"),
                ("s.vx.positoin.range", "E0313", "did you mean 's.vx.position'?"),
                ("s.vx.range", "E0313", "it has s.vx.position"),
                ("b.wz.dead_points", "E0313", "s.vx"),
                ("s.vx.velocity.peak", "E0303", "case")]:
            with self.subTest(name):
                said = refused(SLIDER_CRANK, f"{{vary: {{r: [1, 2]}}, report: [{name}]}}")
                self.assertIn(code, said)
                self.assertIn(hint, said)
        without = SLIDER_CRANK[:SLIDER_CRANK.index("motion: {drive")]
        self.assertIn("E0303", refused(without, "{vary: {r: [1]}, report: [s.vx.position.range]}"))


# Of each file: what becomes the parameter p, if its own are not varied; what is varied and how;
# which columns of its motion are asked for.

    def test_means_in_time_need_time(self) -> None:
        said = refused(SLIDER_CRANK, "{vary: {r: [1, 2]}, cases: [push], report: [motor.rms]}")
        self.assertIn("'motor.rms' is a mean in time, and the motion has none", said)


LIBRARY = {
    "planar/slider_crank.yaml": (
        ("at: [9, 12]", "at: [9 + p, 12]"), "p", (0, 0.7, -1.3, 4, 30),
        ("position", "velocity", "acceleration", "transmission_angle", "mechanical_advantage")),
    "planar/four_bar.yaml": (
        ("at: [0, 0]", "at: [p/5, p/9]"), "p", (0, 0.7, -1.3, 3, 30),
        ("position", "velocity", "action", "power")),
    "planar/stephenson_six_bar.yaml": (
        ("at: [0, 0]", "at: [p, 0]"), "p", (0, 3, -5, 12, 40),
        ("position", "acceleration", "transmission_angle")),
    "planar/watt_six_bar.yaml": (
        ("at: [0, 0]", "at: [0, p]"), "p", (0, 3, -5, 12, 60), ("position", "acceleration")),
    "planar/cam_and_follower.yaml": (None, "ex", (9, 7, 9.5, 12, 60), ("velocity", "action")),
    "spatial/rssr.yaml": (
        ("at: [0, 0, 0]", "at: [p, 0, 0]"), "p", (0, 0.1, -0.2, 5), ("position", "velocity")),
    "spatial/bennett.yaml": (None, "k", (20, 1, 35), ("position",)),
    "spatial/ups_platform.yaml": (None, "height", (1, 0.8, 1.4), ("position",)),
    "cables/block_and_tackle.yaml": (None, "height", (500, 400, 900), ("position", "action")),
}


class EveryState(ReferenceTest):
    """A row says what the motion of its state says."""

    def test_rows_are_those_of_motions(self) -> None:
        for path, (change, parameter, values, words) in LIBRARY.items():
            text = in_library(path).read_text(encoding="utf-8").split("published:")[0]
            if change:
                self.assertIn(change[0], text, path)
                text = text.replace(*change, 1)
                text = (text.replace("\nparameters:\n", "\nparameters:\n  p: 0\n", 1)
                        if "\nparameters:\n" in text else f"{text}\nparameters: {{p: 0}}\n")
            with self.subTest(path):
                self.compare(text, parameter, values, words)

    def test_linkages_together_say_what_each_says_alone(self) -> None:
        """With a column of a body beside them, figures are those of whole motions."""
        for text, vary, columns, steps in (
                (FOUR_BAR, "r: {from: 0.5, to: 3}, k: {from: 3, to: 7.5}, o: {from: 3, to: 7.5}",
                 "b.wz.position.least, c.wz.position.range, d.wz.position.range, "
                 "transmission_angle.least, transmission_angle.greatest", "steps: 72"),
                (SLIDER_CRANK, "r: {from: 0.5, to: 3}, l: {from: 3, to: 7}, "
                               "e: {from: -1.5, to: 1.5}",
                 "b.wz.position.peak, c.wz.position.range, s.vx.position.range, "
                 "transmission_angle.least, transmission_angle.greatest", "steps: 72")):
            for count in (6, 13, 40):
                sweep = (f"{{vary: {{{vary}}}, cases: [{'turn' if 'turn' in text else 'push'}], "
                         "sample: {count: 150, method: random, seed: 7}, report: [COLUMNS]}")
                moved = text.replace(steps, f"steps: {count}")
                together, _ = swept(moved, sweep.replace("COLUMNS", columns))
                alone, _ = swept(moved, sweep.replace("COLUMNS", f"{columns}, {BODIES[text]}"))
                self.assertGreater(sum(row["status"] == "solved" for row in alone), 40)
                for one, other in zip(together, alone, strict=True):
                    self.assertEqual(one["status"], other["status"])
                    for name, value in one.items():
                        if isinstance(value, float):
                            self.assertAlmostEqual(value, other[name], delta=1e-10, msg=name)

    def compare(self, text: str, parameter: str, values: tuple, words: tuple) -> None:
        report = [option for word in words for option in ("--report", word)]
        labels = re.findall(r"^cases:\n  ([^:]+):", text, re.M)
        case = labels[0] if labels else None
        if case:
            report += ["--case", case]
        states = [StateOfMotion(text, f"{parameter}={value}", report) for value in values]
        columns = [name for name in states[0].names[1:-1] if not name.endswith("/drive")]
        figures = ["least", "greatest", "range", "mean", "peak"]
        asked = [f"{name.replace('/', '.')}.{figure}" for name in columns for figure in figures]
        rows, _ = swept(text, f"{{vary: {{{parameter}: {list(values)}}}, "
                        + (f"cases: ['{case}'], " if case else "")
                        + f"report: [{', '.join(asked)}, dead_points]}}")
        self.assertEqual(len(states), len(rows))
        for value, motion, row in zip(values, states, rows):
            cells = list(row.values())
            with self.subTest(parameter=value):
                self.assertEqual(motion.status, row["status"])
                if not motion.is_complete:
                    self.assertEqual([None] * (len(asked) + 1), cells[2:-1])
                    continue
                self.assertEqual(len(motion.events("dead_point")), cells[-2])
                for c, name in enumerate(columns):
                    found = cells[2 + c * len(figures):2 + (c + 1) * len(figures)]
                    for figure, one, other in zip(figures, motion.figures(name), found):
                        self.assert_same(one, other, f"{name} {figure}")
                    if name in motion.told and found[0] is not None:
                        for one, other in zip(motion.told[name], found):
                            self.assertAlmostEqual(one, other, delta=2e-5 * found[4], msg=name)

    def assert_same(self, one: float | None, other: float | None, what: str) -> None:
        if one is None or other is None:
            self.assertEqual(one, other, what)
        else:
            self.assertAlmostEqual(one, other, delta=1e-9 * (1 + abs(one)), msg=what)


def trapezoids(rows: list[float]) -> float:
    """The mean over steps of the same length."""
    return (sum(rows) - (rows[0] + rows[-1]) / 2) / (len(rows) - 1)


def gregory(rows: list[float], orders: int) -> float:
    """The same by the formula of Gregory: trapezoids, and differences of so many orders at the ends."""
    both = [rows, rows[::-1]]
    total = trapezoids(rows) * (len(rows) - 1)
    for share in (1 / 12, -1 / 24, 19 / 720, -3 / 160)[:orders]:
        both = [[b - a for a, b in zip(one, one[1:])] for one in both]
        total += share * sum(one[0] for one in both)
    return total / (len(rows) - 1)


class StateOfMotion(motion_case.Motion):
    """The motion of a state by itself: its rows, its dead points one by one, what its text tells."""

    def __init__(self, text: str, override: str, report: list[str]) -> None:
        options = ["--set", override, *report, "-"]
        done = program.call("motion", *options, text=text)
        self.text = text
        self.is_complete = False
        self.told: dict[str, tuple[float, float]] = {}
        if not done.stdout:
            self.status = re.search(r"error\[(\w+)\]", done.stderr)[1]
            return
        super().__init__(program.report(done))
        self.is_complete = self.report["status"] == "complete"
        self.status = self.status_of(done.stderr) if self.is_complete else self.report["status"]
        # Fewer steps than 24 are divided into equal parts for means.
        steps = len(self.rows) - 1
        parts = math.ceil(24 / steps)
        self.finer = self if parts == 1 else motion_case.Motion(program.report(
            program.call("motion", "--steps", f"{steps * parts}", *options, text=text)))
        self.turns = []
        for event in self.report["events"]:
            drive = self.report["drives"][0]
            if event["kind"] == "dead_point" and self.has_one_way(event, done.stderr):
                there = program.call("motion", "--to", f"{event['drive'][0]!r} {drive['unit']}",
                                     "--steps", "1", *options, text=text)
                self.turns.append(motion_case.Motion(program.report(there)))
        for line in program.plain("motion", *options, text=text).stdout.splitlines():
            found = re.fullmatch(r" *(\S+)(?: \[.*\])? +(\S+) +\S+ +(\S+) +\S+", line)
            if found and found[1] in self.names:
                self.told[found[1]] = (float(found[2]), float(found[3]))

    def has_one_way(self, event: dict, said: str) -> bool:
        """Whether a motion that ends at the event is there where this one passes it."""
        drives = self.report["drives"]
        return (len(drives) == 1 and event["step"] >= 0 and event["drive"][0] != drives[0]["from"]
                and "W0506" not in said)

    def status_of(self, said: str) -> str:
        gaps = [row for row in self.rows if None in row]
        words = [row[-1] for row in [*gaps, *self.rows] if row[-1] != "solved"]
        codes = [code for code in re.findall(r"warning\[(W05\d\d)\]", said)
                 if code not in ("W0504", "W0508")]
        has_poles = any(one["greatest"] is None for one in self.report["figures"].values())
        return [*words, *codes, "no_value" if gaps or has_poles else "solved"][0]

    def figures(self, name: str) -> list[float | None]:
        """Those of the report, which go at least as far as the rows and the dead points do; the
        closure error has none."""
        rows = self[name]
        if None in rows:
            return [None] * 5
        extremes = list(rows)
        quantity = name.partition("/")[2]
        if quantity == "position" or quantity.startswith(("at/", "rotation/")):
            extremes += [turn[name][-1] for turn in self.turns]
        finer = self.finer[name]
        middle = trapezoids(finer)
        found = self.report["figures"].get(
            name, {"least": min(rows), "greatest": max(rows), "mean": middle})
        least, greatest, mean = found["least"], found["greatest"], found["mean"]
        most = 1e-9 * (1 + max(-min(extremes), max(extremes)))
        if greatest is None:  # it becomes infinite on the way
            if least is not None and least > min(extremes) + most:
                raise AssertionError(f"{name}: {found}, and {min(extremes)} to {max(extremes)}")
            return [least, None, None, mean, None]
        if least > min(extremes) + most or greatest < max(extremes) - most:
            raise AssertionError(f"{name}: {found}, and {min(extremes)} to {max(extremes)}")
        # Means see more than the rows where friction turns round, a spring begins to act, or speeds
        # become infinite.
        has_corners = ("friction" in self.text or "acts:" in self.text
                       or any(one["least"] is None for one in self.report["figures"].values()))
        even = rows if len(rows) % 2 == 1 else rows[:-1]
        between = abs(trapezoids(even) - trapezoids(even[::2]))
        # Along a whole turn trapezoids are best, else polynomials through rows where these are smooth:
        # the mean lies within what the rows bend of that of straight lines.
        better = gregory(finer, 4)
        off = min(abs(mean - middle), abs(mean - better) - abs(better - gregory(finer, 2))) - most
        bends = sum(abs(a - 2 * b + c) for a, b, c in zip(finer, finer[1:], finer[2:])) / 12
        if off > max(between if has_corners else 0.0, bends / (len(finer) - 1)):
            raise AssertionError(f"{name}: {found}, and the mean of the rows")
        return [least, greatest, greatest - least, mean, max(-least, greatest)]


if __name__ == "__main__":
    motion_case.main()
