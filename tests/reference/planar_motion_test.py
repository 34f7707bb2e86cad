#!/usr/bin/env python3
"""Checks motions of planar linkages against closed forms, and their tables against each other.

Usage: planar_motion_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import csv
import io
import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Callable

import motion_case
from motion_case import (CLOSURE, DEAD_POINT, Motion, MotionTest, derivative, dyad, in_library,
                         run, turned, unwrapped)


class FourBar:
    """Pins a b c d as drawn, the crank a-b turned by an angle; on its drawn branch."""

    def __init__(self, a: complex, b: complex, c: complex, d: complex) -> None:
        self.a, self.b, self.c, self.d = a, b, c, d

    def pins(self, angle: float) -> tuple[complex, complex]:
        b = self.a + turned(self.b - self.a, angle)
        c = dyad(b, self.d, abs(self.c - self.b), abs(self.d - self.c), (self.b, self.d, self.c))
        return b, c

    def coupler_point(self, point: complex, angle: float) -> complex:
        b, c = self.pins(angle)
        return b + (point - self.b) * (c - b) / (self.c - self.b)

    def coupler(self, angle: float) -> float:
        b, c = self.pins(angle)
        return cmath.phase((c - b) / (self.c - self.b))

    def rocker(self, angle: float) -> float:
        return cmath.phase((self.pins(angle)[1] - self.d) / (self.c - self.d))

    def crank_at(self, diagonal: float, sign: float) -> float:
        """Turn of the crank from its drawn position at which b is that far from d."""
        crank, ground = abs(self.b - self.a), abs(self.d - self.a)
        between = math.acos((crank ** 2 + ground ** 2 - diagonal ** 2) / (2 * crank * ground))
        return sign * between + cmath.phase((self.d - self.a) / (self.b - self.a))

    def rocker_dead_points(self) -> list[float]:
        """Where crank and coupler are in line: c is coupler +- crank from a."""
        crank, coupler = abs(self.b - self.a), abs(self.c - self.b)
        rocker, ground = abs(self.d - self.c), abs(self.d - self.a)
        side = math.copysign(
            1.0, ((self.d - self.b).conjugate() * (self.c - self.b)).imag)
        result = []
        for reach in (coupler + crank, coupler - crank):
            at_a = math.acos((reach ** 2 + ground ** 2 - rocker ** 2) / (2 * reach * ground))
            c = self.a + reach * (self.d - self.a) / ground * cmath.exp(1j * side * at_a)
            b = (c - self.a) * crank / reach if reach > coupler else (self.a - c) * crank / reach
            result.append(cmath.phase(b / (self.b - self.a)))
        return result


def positive(angles: list[float]) -> list[float]:
    """Within a turn, ascending."""
    return sorted(angle % (2 * math.pi) for angle in angles)


CAZANGI = FourBar(0, 1 + 3j, 6 + 5j, 7)
FOUR_BAR = """kinestat: 1
space: planar
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {{type: revolute, bodies: [frame, crank], at: [{0.a.real}, {0.a.imag}]}}
  b: {{type: revolute, bodies: [crank, coupler], at: [{0.b.real}, {0.b.imag}]}}
  c: {{type: revolute, bodies: [coupler, rocker], at: [{0.c.real!r}, {0.c.imag!r}]}}
  d: {{type: revolute, bodies: [frame, rocker], at: [{0.d.real}, {0.d.imag}]}}
actuators: {{motor: {{coupling: a}}, load: {{coupling: d}}}}
cases: {{turning: {{motion: {{motor: 2 rad/s}}, action: {{load: -3}}, input: motor, output: load}}}}
motion:
  drive: motor
  from: {1!r} rad
  to: {2!r} rad
  steps: {3}
  case: turning
  trace: [{{body: coupler, at: [3, 5.5]}}]
  report: [position, velocity, acceleration, action, power, ratio, transmission_angle,
           mechanical_advantage]
"""


def other_assembly(linkage: FourBar) -> FourBar:
    """c mirrored in the diagonal b-d."""
    diagonal = linkage.d - linkage.b
    c = linkage.b + diagonal * ((linkage.c - linkage.b) / diagonal).conjugate()
    return FourBar(complex(linkage.a), linkage.b, c, complex(linkage.d))


class FourBars(MotionTest):
    def check_linkage(self, linkage: FourBar) -> None:
        steps = 72
        motion = run(FOUR_BAR.format(linkage, 0.0, 2 * math.pi, steps))
        self.check_complete(motion, steps)
        drive = motion["motor/drive"]
        rocker = unwrapped([linkage.rocker(angle) for angle in drive])
        for step, angle in enumerate(drive):
            self.close(angle, 2 * math.pi * step / steps, 1e-13, "drive")
            self.close(motion["d.wz/position"][step], rocker[step], 1e-12, f"rocker at {angle}")
        self.check(motion, "b.wz/position",
                   lambda t: unwrapped([0.0, *[linkage.coupler(s * t / 99) - s * t / 99
                                               for s in range(100)]])[-1], 1e-12)
        point = 3 + 5.5j
        paths = motion.point("coupler.1", "at")
        for angle, at in zip(drive, paths):
            self.close(abs(at - linkage.coupler_point(point, angle)), 0.0, 1e-12, "coupler curve")
        # Two turns a second: derivatives by time are those by the angle times 2 and 4.
        self.check(motion, "d.wz/velocity",
                   lambda t: 2 * derivative(linkage.rocker, t, 1).real, 1e-8)
        self.check(motion, "d.wz/acceleration",
                   lambda t: 4 * derivative(linkage.rocker, t, 2).real, 1e-6)
        velocities = motion.point("coupler.1", "linear")
        accelerations = motion.point("coupler.1", "linear_acceleration")

        def path(t: float) -> complex:
            return linkage.coupler_point(point, t)
        for angle, v, a in zip(drive, velocities, accelerations):
            self.close(abs(v - 2 * derivative(path, angle, 1)), 0.0, 1e-8, f"velocity at {angle}")
            self.close(abs(a - 4 * derivative(path, angle, 2)), 0.0, 1e-6, f"acceleration {angle}")
        dead = positive(linkage.rocker_dead_points())
        found = motion.events("dead_point", "d.wz")
        self.assertEqual(len(found), 2)
        for expected, actual in zip(dead, found):
            self.close(actual, expected, DEAD_POINT, "dead point")
        self.check_forces(linkage, motion)

    def check_forces(self, linkage: FourBar, motion: Motion) -> None:
        """The coupler has two pins alone: its force is along b-c, and its lever about d gives 3."""
        for step, angle in enumerate(motion["motor/drive"]):
            b, c = linkage.pins(angle)
            along = (c - b) / abs(c - b)
            lever = ((c - linkage.d).conjugate() * along).imag
            force = 3 / lever * along
            self.close(motion["c.Rx/action"][step], force.real, 1e-9 * abs(force), "force x")
            self.close(motion["c.Ry/action"][step], force.imag, 1e-9 * abs(force), "force y")
            torque = (((b - linkage.a).conjugate()) * force).imag
            self.close(motion["motor/action"][step], torque, 1e-9 * abs(force), "torque")
            self.close(motion["motor/power"][step], 2 * torque, 1e-8 * abs(force), "power")
            between = abs(cmath.phase((b - c) / (linkage.d - c)))
            self.close(motion["load/transmission_angle"][step],
                       min(between, math.pi - between), 1e-7, f"transmission angle at {angle}")
            if abs(torque) > 1e-6:
                self.close(motion["load/mechanical_advantage"][step], abs(3 / torque),
                           1e-8 * abs(3 / torque), "mechanical advantage")

    def test_follow_the_drawn_assembly(self) -> None:
        self.check_linkage(FourBar(complex(0), 1 + 3j, 6 + 5j, complex(7)))

    def test_follow_the_other_assembly(self) -> None:
        self.check_linkage(other_assembly(CAZANGI))

    def test_come_to_the_limits_of_the_rocker_as_drive(self) -> None:
        """Crank and coupler in line stop the rocker when it drives."""
        text = FOUR_BAR.format(other_assembly(other_assembly(CAZANGI)), 0.0, 1.0, 50)
        text = text.replace("drive: motor", "drive: load").replace("{motor: 2 rad/s}", "{load: 1}")
        limits = [CAZANGI.rocker(t) for t in CAZANGI.rocker_dead_points()]
        for to, expected in ((3.0, max(limits)), (-3.0, min(limits))):
            motion = run(text.replace("to: 1.0", f"to: {to}"))
            self.assertEqual(motion.report["status"], "limited")
            self.close(motion.events("limit")[0], expected, DEAD_POINT, "limit of the rocker")
            self.assertLessEqual(motion.report["closure"]["largest"], CLOSURE)

    def test_without_a_full_turn_stop_where_the_other_links_are_in_line(self) -> None:
        """Links 4, 3, 4 on a ground of 6 are not Grashof: the crank turns until b-d is 7."""
        linkage = FourBar(complex(0), 4 * cmath.exp(1j), 0j, complex(6))
        linkage.c = dyad(linkage.b, linkage.d, 3, 4, (0, 1, 1j))
        for sign in (1, -1):
            stop = [linkage.crank_at(7.0, s) for s in (1, -1)]
            expected = max(stop) if sign > 0 else min(stop)
            motion = run(FOUR_BAR.format(linkage, 0.0, 3.0 * sign, 60))
            self.close(motion.events("limit")[0], expected, DEAD_POINT, "limit of the crank")

    def test_reach_what_lies_just_before_a_limit(self) -> None:
        """Crank and rod of 50 let the slider go to 100, where the crank comes to 0."""
        text = """kinestat: 1
space: planar
units: {length: mm}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [30, 40]}
  c: {type: revolute, bodies: [rod, slider], at: [60, 0]}
  d: {type: prismatic, bodies: [frame, slider], axis: x, at: [60, 0]}
actuators: {crank: {coupling: a}, slider: {coupling: d}}
motion: {drive: slider, from: %r mm, to: %r mm, steps: %d, report: [a.wz]}
"""
        drawn = math.acos(0.6)
        for gap in (1, 1e-3, 1e-6, 1e-9):
            crank = math.acos((100 - gap) / 100) - drawn
            for steps in (1, 4, 100):
                motion = run(text % (0.0, 40 - gap, steps))
                self.assertEqual(motion.report["status"], "complete")
                self.assertEqual(motion.events("limit"), [])
                # The crank turns by the root of what the slider moves.
                self.close(motion["a.wz/position"][-1], crank, 1e-13 / math.sqrt(gap), f"at {gap}")
            motion = run(text % (40 - gap, 0.0, 4))
            self.close(motion["a.wz/position"][0], crank, 1e-13 / math.sqrt(gap), f"from {gap}")
            self.close(motion["a.wz/position"][-1], 0.0, 1e-12, f"back from {gap}")
        motion = run(text % (0.0, 40.0, 4))
        self.assertEqual(motion.rows[-1][-1], "singular")
        self.close(motion["a.wz/position"][-1], -drawn, 1e-7, "at the limit")
        motion = run(text % (0.0, 59.9985, 3))
        self.assertEqual([row[0] for row in motion.rows], [0, 1, 2, 3])
        self.close(motion["a.wz/position"][2], math.acos(0.99999) - drawn, 1e-12, "before")
        self.close(motion.events("limit")[0], 40.0, DEAD_POINT, "limit")

    def test_in_long_steps_miss_no_dead_point_and_no_turn(self) -> None:
        turns = 2
        motion = run(FOUR_BAR.format(CAZANGI, 0.0, 2 * turns * math.pi, 1))
        self.check_complete(motion, 1)
        expected = [angle + 2 * math.pi * turn for turn in range(turns)
                    for angle in positive(CAZANGI.rocker_dead_points())]
        found = motion.events("dead_point", "d.wz")
        self.assertEqual(len(found), len(expected))
        for one, actual in zip(expected, found):
            self.close(actual, one, DEAD_POINT, "dead point")
        for body in ("crank", "coupler"):  # both turn with the crank
            turned_by = motion[f"{body}/rotation/z"][-1]
            self.close(turned_by, 2 * turns * math.pi if body == "crank" else 0.0, 1e-11, body)

    def test_of_many_turns_are_followed_to_their_rounding(self) -> None:
        turns = 2500
        last = 2 * math.pi * turns + 0.3
        rounding = 16 * sys.float_info.epsilon * last
        motion = run(FOUR_BAR.format(CAZANGI, 0.0, last, 1))
        self.assertEqual(motion.report["status"], "complete")
        self.assertLessEqual(motion.report["closure"]["largest"], rounding)
        self.close(motion["d.wz/position"][-1], CAZANGI.rocker(0.3), rounding, "rocker")
        found = motion.events("dead_point", "d.wz")
        expected = [angle + 2 * math.pi * turn for turn in range(turns + 1)
                    for angle in positive(CAZANGI.rocker_dead_points())]
        expected = [angle for angle in expected if angle < last]
        self.assertEqual(len(found), len(expected))
        for one, actual in zip(expected, found):
            self.close(actual, one, DEAD_POINT, "dead point")

    def test_find_a_dead_point_in_the_step_before_a_limit(self) -> None:
        """Crank and coupler in line, 16 deg before coupler and rocker are."""
        crank, coupler, rocker, ground = 2.0, 0.58, 1.35, 3.74
        b = crank * cmath.exp(-1j * math.radians(2))
        linkage = FourBar(0j, b, dyad(b, complex(ground), coupler, rocker, (0, 1, 1j)),
                          complex(ground))
        motion = run(FOUR_BAR.format(linkage, 0.0, math.pi, 6))
        reach = crank + coupler
        at_a = math.acos((reach ** 2 + ground ** 2 - rocker ** 2) / (2 * reach * ground))
        found = motion.events("dead_point", "d.wz")
        self.assertEqual(len(found), 1)
        self.close(found[0], at_a + math.radians(2), DEAD_POINT, "dead point")
        self.close(motion.events("limit")[0], linkage.crank_at(coupler + rocker, 1.0), DEAD_POINT,
                   "limit")

    def test_of_the_library_reports_it_in_its_own_units(self) -> None:
        motion = run(in_library("planar/four_bar.yaml"))
        self.check_complete(motion, motion.report["steps"])
        for step, angle in enumerate(motion["Tin/drive"]):
            at = motion.point("coupler.1", "at")[step]
            self.close(abs(at - CAZANGI.coupler_point(3 + 6j, angle)), 0.0, 1e-12, "coupler curve")


SLIDER_CRANK = """kinestat: 1
space: planar
units: {{length: mm, angle: deg}}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {{type: revolute, bodies: [frame, crank], at: [0, 0]}}
  b: {{type: revolute, bodies: [crank, rod], at: [9, 12]}}
  c: {{type: revolute, bodies: [rod, slider], at: [{c}, 0]}}
  d: {{type: prismatic, bodies: [frame, slider], at: [{c}, 0], axis: x}}
actuators: {{motor: {{coupling: a}}, gas: {{coupling: d}}}}
cases: {{running: {{motion: {{motor: 10 rad/s}}, action: {{gas: -5 N}}, input: motor, output: gas}}}}
motion: {{drive: motor, to: {to} deg, steps: {steps}, case: running,
         report: [position, velocity, acceleration, action, transmission_angle]}}
"""


class SliderCranks(MotionTest):
    def stroke(self, rod: float) -> Callable[[float], float]:
        """From the drawn position, of the angle from there [rad]."""
        def x(angle: float) -> float:
            b = turned(9 + 12j, angle)
            return b.real + math.sqrt(rod * rod - b.imag * b.imag)
        return lambda angle: x(angle) - x(0.0)

    def test_follow_the_closed_form(self) -> None:
        rod = 37.0
        stroke = self.stroke(rod)
        motion = run(SLIDER_CRANK.format(c=9 + 35, to=720, steps=144))
        self.check_complete(motion, 144)
        self.check(motion, "d.vx/position", lambda t: stroke(math.radians(t)), 1e-11)
        self.check(motion, "d.vx/velocity",
                   lambda t: 10 * derivative(stroke, math.radians(t), 1).real, 1e-6)
        self.check(motion, "d.vx/acceleration",
                   lambda t: 100 * derivative(stroke, math.radians(t), 2).real, 1e-4)
        for step, angle in enumerate(motion["motor/drive"]):
            b = turned(9 + 12j, math.radians(angle))
            rod_angle = math.asin(b.imag / rod)
            self.close(motion["gas/transmission_angle"][step], 90 - abs(math.degrees(rod_angle)),
                       1e-6, "transmission angle")
            self.close(motion["d.Ry/action"][step], 5 * math.tan(rod_angle), 1e-10, "side force")
        first = math.degrees(cmath.phase(9 + 12j))
        dead = [180 * k - first for k in range(1, 5)]
        found = motion.events("dead_point", "d.vx")
        self.assertEqual(len(found), 4)
        for expected, actual in zip(dead, found):
            self.close(math.radians(actual - expected), 0.0, DEAD_POINT, "dead point")

    def test_stop_where_a_short_rod_stands_across(self) -> None:
        """The rod of 13 is across the slider's path when the crank's 15 sin(t) is 13."""
        motion = run(SLIDER_CRANK.format(c=14, to=90, steps=90))
        expected = math.degrees(math.asin(13 / 15) - cmath.phase(9 + 12j))
        self.close(math.radians(motion.events("limit")[0] - expected), 0.0, DEAD_POINT, "limit")
        self.assertLessEqual(motion.report["closure"]["largest"], CLOSURE)


class SixBars(MotionTest):
    def test_of_watt(self) -> None:
        first = FourBar(complex(0), 10 + 40j, 70 + 60j, complex(80))
        e, f, g = 50 + 90j, 120 + 110j, 110 + 50j

        def pins(angle: float) -> tuple[complex, complex, complex]:
            at_e = first.coupler_point(e, angle)
            at_g = first.d + turned(g - first.d, first.rocker(angle))
            return at_e, dyad(at_e, at_g, abs(f - e), abs(g - f), (e, g, f)), at_g

        self.check_six_bar(in_library("planar/watt_six_bar.yaml"), "swing", f, "motor",
                           lambda t: pins(t),
                           lambda t: cmath.phase((pins(t)[1] - pins(t)[2]) / (f - g)))

    def test_of_stephenson(self) -> None:
        first = FourBar(complex(0), 20 + 40j, 90 + 75j, complex(100))
        e, f, g = 60 + 110j, 150 + 120j, 170 + 10j

        def pins(angle: float) -> tuple[complex, complex, complex]:
            at_e = first.coupler_point(e, angle)
            return at_e, dyad(at_e, g, abs(f - e), abs(g - f), (e, g, f)), g

        self.check_six_bar(in_library("planar/stephenson_six_bar.yaml"), "lever", f, "motor",
                           lambda t: pins(t),
                           lambda t: cmath.phase((pins(t)[1] - g) / (f - g)))

    def check_six_bar(self, path: Path, body: str, f: complex, drive: str, pins: Callable,
                      swing: Callable[[float], float]) -> None:
        motion = run(path)
        self.check_complete(motion, motion.report["steps"])
        angles = [math.radians(t) for t in self.degrees(motion, drive)]
        expected = unwrapped([swing(t) for t in angles])
        for step, angle in enumerate(angles):
            self.close(abs(motion.point(f"{body}.1", "at")[step] - pins(angle)[1]), 0.0, 1e-10,
                       f"pin f at {angle}")
            turn = motion[f"{body}/rotation/z"][step]
            self.close(turn, expected[step], 1e-12, f"{body} at {angle}")
            self.close(motion[f"{body}/angular/z"][step], derivative(swing, angle, 1).real, 1e-7,
                       "velocity")
            self.close(motion[f"{body}/angular_acceleration/z"][step],
                       derivative(swing, angle, 2).real, 1e-5, "acceleration")

    @staticmethod
    def degrees(motion: Motion, drive: str) -> list[float]:
        column = f"{drive}/drive"
        unit = next(c["unit"] for c in motion.report["columns"] if c["name"] == column)
        return [x if unit == "deg" else math.degrees(x) for x in motion[column]]


class Tables(MotionTest):
    def test_are_the_same_in_csv(self) -> None:
        path = in_library("planar/four_bar.yaml")
        motion = run(path)
        done = subprocess.run([sys.argv[0], "motion", "--format", "csv", str(path)],
                              capture_output=True, text=True, check=True)
        rows = list(csv.DictReader(io.StringIO(done.stdout)))
        inner = motion.report["columns"][1:-1]
        cells = [row for row in rows if not row["quantity"].startswith("event/")]
        self.assertEqual(len(cells), len(inner) * len(motion.rows))
        for i, row in enumerate(cells):
            wanted = motion.rows[i // len(inner)]
            column = inner[i % len(inner)]
            value = wanted[1 + i % len(inner)]
            self.assertEqual(row["value"], "" if value is None else json.dumps(value))
            self.assertEqual((row["element"], row["quantity"], row["unit"]),
                             (column["element"], column["quantity"], column["unit"]))
            self.assertEqual((row["step"], row["status"]), (str(wanted[0]), wanted[-1]))


if __name__ == "__main__":
    motion_case.main()
