#!/usr/bin/env python3
"""Checks numbers that move against their tables, interpolated here, and against what other commands
say of the same position.

Usage: curve_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import bisect
import math
import sys
import tempfile
import unittest
from pathlib import Path

import program
from motion_case import Motion

# A slide that one actuator holds against a force: what it does is the negative of that force.
SLIDE = """
kinestat: 1
space: planar
ground: frame
bodies: {{slide: {{mass: 2, centre_of_mass: [0, 0]}}}}
couplings: {{g: {{type: prismatic, bodies: [frame, slide], at: [0, 0], axis: x}}}}
actuators: {{hand: {{coupling: g}}, engine: {{coupling: g}}}}
curves: {{push: {curve}}}
{sections}
"""

LINE = [(-1.0, 40.0), (0.0, 10.0), (0.5, -20.0), (2.0, 70.0)]
RISING = [(0.0, 0.0), (0.3, 1.0), (0.5, 4.0), (1.2, 4.0), (2.0, 9.0)]


def straight(points: list[tuple[float, float]], x: float) -> float:
    at = [p[0] for p in points]
    i = min(max(bisect.bisect_right(at, x) - 1, 0), len(points) - 2)
    (a, low), (b, high) = points[i], points[i + 1]
    return low + (x - a) * (high - low) / (b - a)


def monotone(points: list[tuple[float, float]], x: float) -> float:
    """Fritsch and Butland 1984, by the four basis functions of Hermite."""
    at = [p[0] for p in points]
    values = [p[1] for p in points]
    width = [b - a for a, b in zip(at, at[1:])]
    slope = [(b - a) / h for a, b, h in zip(values, values[1:], width)]

    def end(h0: float, h1: float, m0: float, m1: float) -> float:
        d = ((2 * h0 + h1) * m0 - h0 * m1) / (h0 + h1)
        if d * m0 <= 0:
            return 0.0
        return 3 * m0 if m0 * m1 <= 0 and abs(d) > 3 * abs(m0) else d

    slopes = [end(width[0], width[1], slope[0], slope[1])]
    for i in range(1, len(points) - 1):
        a, b = slope[i - 1], slope[i]
        w1, w2 = 2 * width[i] + width[i - 1], width[i] + 2 * width[i - 1]
        slopes.append(0.0 if a * b <= 0 else (w1 + w2) / (w1 / a + w2 / b))
    slopes.append(end(width[-1], width[-2], slope[-1], slope[-2]))
    i = min(max(bisect.bisect_right(at, x) - 1, 0), len(points) - 2)
    t = (x - at[i]) / width[i]
    return ((1 + 2 * t) * (1 - t) ** 2 * values[i] + t * (1 - t) ** 2 * width[i] * slopes[i]
            + t * t * (3 - 2 * t) * values[i + 1] - t * t * (1 - t) * width[i] * slopes[i + 1])


def table(points: list[tuple[float, float]], x: str = "m", y: str = "N") -> str:
    return "[" + ", ".join(f"[{a} {x}, {b} {y}]" for a, b in points) + "]"


def slide(curve: str, sections: str) -> str:
    return SLIDE.format(curve=curve, sections=sections)


LOAD = "loads: {push: {body: slide, at: [0, 0], force: [push, 0]}}\n"
WORKING = ("cases: {working: {motion: {hand: 2 m/s}, action: {engine: 0}}}\n"
           "motion: {drive: hand, from: -1, to: 2, steps: 60, case: working, report: [action]}\n")


class CurveTest(unittest.TestCase):
    def near(self, actual: float, expected: float, what: str, scale: float = 100.0) -> None:
        self.assertLessEqual(abs(actual - expected), 1e-12 * scale,
                             f"{what}: {actual} is not {expected}")

    def check_slide(self, between: str, points: list, value) -> None:
        curve = f"{{over: hand, between: {between}, points: {table(points)}}}"
        text = slide(curve, LOAD + WORKING).replace("from: -1", f"from: {points[0][0]}")
        motion = Motion(program.run("motion", "-", text=text))
        self.assertEqual(len(motion.rows), 61)
        for place, action in zip(motion["hand/drive"], motion["hand/action"]):
            self.near(action, -value(points, place), f"{between} at {place}")

    def test_force_over_a_position_by_straight_lines(self) -> None:
        self.check_slide("linear", LINE, straight)

    def test_force_over_a_position_by_monotone_cubics(self) -> None:
        self.check_slide("monotone", RISING, monotone)

    def test_period_counts_turns_on_either_side(self) -> None:
        points = [(0.0, 5.0), (0.25, -7.0)]
        curve = f"{{over: hand, period: 1 m, points: {table(points)}}}"
        closed = points + [(1.0, 5.0)]
        motion = Motion(program.run("motion", "-", text=slide(curve, LOAD + WORKING)))
        for place, action in zip(motion["hand/drive"], motion["hand/action"]):
            self.near(action, -straight(closed, place - math.floor(place)), f"at {place}")

    def test_force_over_time(self) -> None:
        curve = f"{{over: time, points: {table(LINE[1:], 's')}}}"
        sections = LOAD + WORKING.replace("from: -1, to: 2", "to: 4, time: 2 s")
        motion = Motion(program.run("motion", "-", text=slide(curve, sections)))
        for time, action in zip(motion["time"], motion["hand/action"]):
            self.near(action, -straight(LINE[1:], time), f"after {time} s")

    def test_action_over_a_speed_that_grows(self) -> None:
        """What the engine can do at a speed; the hand holds the rest and the inertia."""
        points = [(0.0, 90.0), (3.0, 60.0), (10.0, 0.0)]
        curve = f"{{over: hand.speed, points: {table(points, 'm/s')}}}"
        sections = ("cases: {faster: {motion: {hand: 1}, acceleration: {hand: 2}, "
                    "action: {engine: push}}}\n"
                    "motion: {drive: hand, time: 3 s, steps: 30, case: faster, report: [action]}\n")
        motion = Motion(program.run("motion", "-", text=slide(curve, sections)))
        for time, hand, engine in zip(motion["time"], motion["hand/action"],
                                      motion["engine/action"]):
            expected = straight(points, 1 + 2 * time)
            self.near(engine, expected, f"engine after {time} s")
            self.near(hand, 2 * 2 - expected, f"hand after {time} s")

    def test_expression_of_a_curve_and_a_couple(self) -> None:
        """Without a unit the values take that of the file; the couple is about z."""
        text = slide("{over: hand, points: [[-1 m, 1], [2 m, 4]]}",
                     "parameters: {k: 3}\n"
                     "loads: {push: {body: slide, at: [0, 0], force: [2*k*push, -push], "
                     "couple: push^2}}\n" + WORKING)
        motion = Motion(program.run("motion", "-", text=text))
        for place, hand, side, couple in zip(motion["hand/drive"], motion["hand/action"],
                                             motion["g.Ry/action"], motion["g.Tz/action"]):
            value = place + 2
            self.near(hand, -6 * value, f"along at {place}")
            self.near(side, value, f"across at {place}")
            # The guide bears it where it was drawn; the force across has the arm of the way.
            self.assertTrue(math.isfinite(couple))

    def test_force_of_a_spring(self) -> None:
        curve = f"{{over: hand, points: {table(LINE)}}}"
        sections = "springs: {s: {coupling: g, stiffness: 30 N/m, force: push}}\n" + WORKING
        motion = Motion(program.run("motion", "-", text=slide(curve, sections)))
        for place, action in zip(motion["hand/drive"], motion["hand/action"]):
            self.near(action, 30 * place - straight(LINE, place), f"at {place}")

    def test_commands_agree_on_a_position(self) -> None:
        """analyze, the first step of a motion, a sweep, and a table in place of the points."""
        curve = f"{{over: hand, points: [[-1 m, 4 N], [0 m, size], [2 m, 6 N]]}}"
        sections = ("parameters: {size: 10 N}\n" + LOAD
                    + WORKING.replace("from: -1", "from: 0")
                    + "sweep: {vary: {size: [10 N, 25 N]}, report: [hand]}\n")
        text = slide(curve, sections)
        one = program.run("analyze", "-", text=text)["cases"]["working"]["statics"]
        self.near(one["actions"]["hand"], -10.0, "analyze")
        self.near(Motion(program.run("motion", "-", text=text))["hand/action"][0], -10.0, "motion")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "slide.yaml"
            file.write_text(text, encoding="utf-8")
            done = program.plain("sweep", str(file))
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = [line.split(",") for line in done.stdout.splitlines()]
            column = next(i for i, name in enumerate(rows[0]) if name.startswith("hand"))
            self.assertEqual([float(row[column]) for row in rows[1:]], [-10.0, -25.0])
            csv = Path(folder) / "push.csv"
            csv.write_text("way [mm],force [kN]\n-1000,0.004\n0,0.0125\n2000,0.006\n",
                           encoding="utf-8")
            report = program.run("analyze", "--curve", f"push={csv}", "--set", "size=10 N", "-",
                                 text=text)
            self.near(report["cases"]["working"]["statics"]["actions"]["hand"], -12.5, "table")
            used = report["mechanism"]["curves"]["push"]
            self.assertEqual(used["points"], 3)
            self.assertEqual(len(used["sha256"]), 64)

    def test_load_that_follows_a_curve_is_an_input(self) -> None:
        """Its power is that of the force on the moving slide, and all of it reaches the output."""
        curve = f"{{over: hand, points: {table(LINE)}}}"
        text = slide(curve, LOAD + "cases: {working: {motion: {hand: 2 m/s}, action: {engine: 0}, "
                     "input: push, output: hand}}\n")
        power = program.run("analyze", "-", text=text)["cases"]["working"]["power"]
        self.near(power["loads"]["push"], 20.0, "power")
        self.near(power["input"], 20.0, "input")
        self.near(power["actuators"]["hand"], -20.0, "output")


class ProfileTest(unittest.TestCase):
    def near(self, actual: float, expected: float, what: str) -> None:
        self.assertLessEqual(abs(actual - expected), 1e-12 * 100.0,
                             f"{what}: {actual} is not {expected}")

    def test_rise_dwell_return(self) -> None:
        """Cycloidal rise in 0.3 s, dwell of 0.2 s, return by a polynomial in 0.5 s, by their closed
        forms; another drive has a shorter profile and rests behind it."""
        text = """
kinestat: 1
space: planar
ground: frame
bodies: {one: {}, two: {}}
couplings:
  a: {type: revolute, bodies: [frame, one], at: [0, 0]}
  b: {type: revolute, bodies: [frame, two], at: [1, 0]}
actuators: {first: {coupling: a}, second: {coupling: b}}
cases: {running: {motion: {}}}
motion:
  drives:
    - drive: first
      from: 0.5 rad
      profile: [{to: 2 rad, time: 0.3 s, law: cycloidal}, {dwell: 0.2 s},
                {to: -1 rad, time: 0.5 s, law: polynomial_345}]
    - {drive: second, profile: [{dwell: 0.1 s}, {to: 1 rad, time: 0.4 s, law: constant_acceleration}]}
  steps: 40
  case: running
  report: [position, velocity, acceleration]
"""

        def first(t: float) -> tuple[float, float, float]:
            if t < 0.3 - 1e-12:
                u, w = t / 0.3, 2 * math.pi
                return (0.5 + 1.5 * (u - math.sin(w * u) / w), 1.5 / 0.3 * (1 - math.cos(w * u)),
                        1.5 / 0.09 * w * math.sin(w * u))
            if t < 0.5 - 1e-12:
                return 2.0, 0.0, 0.0
            u = (t - 0.5) / 0.5
            return (2 - 3 * (10 * u ** 3 - 15 * u ** 4 + 6 * u ** 5),
                    -6 * (30 * u ** 2 - 60 * u ** 3 + 30 * u ** 4),
                    -12 * (60 * u - 180 * u ** 2 + 120 * u ** 3))

        def second(t: float) -> tuple[float, float, float]:
            if t < 0.1 - 1e-12:
                return 0.0, 0.0, 0.0
            if t < 0.3 - 1e-12:
                u = (t - 0.1) / 0.4
                return 2 * u * u, 10 * u, 25.0
            if t < 0.5 - 1e-12:
                u = 1 - (t - 0.1) / 0.4
                return 1 - 2 * u * u, 10 * u, -25.0
            return 1.0, 0.0, 0.0

        motion = Motion(program.run("motion", "-", text=text))
        self.assertEqual(len(motion.rows), 41)
        for step in range(41):
            time = step / 40
            self.near(motion["time"][step], time, "time")
            for name, drive, law in (("a", "first", first), ("b", "second", second)):
                expected = law(time)
                self.near(motion[f"{drive}/drive"][step], expected[0], f"{drive} after {time} s")
                for quantity, value in zip(("position", "velocity", "acceleration"), expected):
                    self.near(motion[f"{name}.wz/{quantity}"][step], value,
                              f"{quantity} of {drive} after {time} s")


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
