#!/usr/bin/env python3
"""Holds finite motions against closed forms: positions, paths, velocities, accelerations, limits.

Usage: motion_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import csv
import io
import json
import math
import subprocess
import sys
import unittest
from pathlib import Path
from typing import Callable

import program
from reference_test_case import ReferenceTest

MECHANISMS = Path()
CLOSURE = 1e-12
DEAD_POINT = 1e-9


class Motion:
    """The rows of a report as columns by name; every cell by step."""

    def __init__(self, report: dict) -> None:
        self.report = report["motion"]
        self.names = [column["name"] for column in self.report["columns"]]
        self.rows = self.report["rows"]

    def __getitem__(self, name: str) -> list[float]:
        at = self.names.index(name)
        return [row[at] for row in self.rows]

    def events(self, kind: str, element: str | None = None) -> list[float]:
        """Positions of the first drive."""
        return [event["drive"][0] for event in self.report["events"]
                if event["kind"] == kind and element in (None, event["element"])]

    def point(self, element: str, quantity: str) -> list[complex]:
        return [complex(x, y) for x, y in
                zip(self[f"{element}/{quantity}/x"], self[f"{element}/{quantity}/y"])]


def run(source: str | Path, *options: str, status: int = 0) -> Motion:
    """The motion of a file of the library, or of a text."""
    is_file = isinstance(source, Path)
    done = program.call("motion", *options, str(MECHANISMS / source) if is_file else "-",
                        text=None if is_file else source)
    if done.returncode != status:
        raise AssertionError(f"status {done.returncode}\n{done.stderr}")
    return Motion(program.report(done))


# Closed forms


def turned(point: complex, angle: float) -> complex:
    return point * cmath.exp(1j * angle)


def dyad(p: complex, q: complex, r: float, s: float, like: tuple[complex, ...]) -> complex:
    """The point at the distances r from p and s from q, on the side on which c is of a-b."""
    d = abs(q - p)
    along = (r * r - s * s + d * d) / (2 * d)
    across = math.sqrt(max(r * r - along * along, 0.0))
    a, b, c = like
    side = math.copysign(1.0, ((b - a).conjugate() * (c - a)).imag)
    return p + (along + 1j * side * across) * (q - p) / d


def unwrapped(angles: list[float]) -> list[float]:
    result = angles[:1]
    for angle in angles[1:]:
        result.append(angle + 2 * math.pi * round((result[-1] - angle) / (2 * math.pi)))
    return result


def derivative(f: Callable[[float], complex], t: float, order: int, h: float = 0.08) -> complex:
    """By Richardson's extrapolation of central differences, to about 1e-9 of the function."""
    def difference(d: float) -> complex:
        if order == 1:
            return (f(t + d) - f(t - d)) / (2 * d)
        return (f(t + d) - 2 * f(t) + f(t - d)) / (d * d)

    table = [difference(h / 2 ** k) for k in range(5)]
    for level in range(1, 5):
        table = [(4 ** level * fine - coarse) / (4 ** level - 1)
                 for coarse, fine in zip(table, table[1:])]
    return table[0]


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


class MotionTest(ReferenceTest):
    def close(self, actual: float, expected: float, tolerance: float, what: str) -> None:
        self.assertLessEqual(abs(actual - expected), tolerance,
                             f"{what}: {actual} is not {expected}")

    def check(self, motion: Motion, name: str, expected: Callable[[float], float],
              tolerance: float) -> None:
        """A column against a function of the first drive."""
        for drive, value in zip(motion[motion.names[1]], motion[name]):
            self.close(value, expected(drive), tolerance, f"{name} at {drive}")

    def check_complete(self, motion: Motion, steps: int) -> None:
        self.assertEqual(motion.report["status"], "complete")
        self.assertEqual([row[0] for row in motion.rows], list(range(steps + 1)))
        self.assertEqual(set(motion["status"]), {"solved"})
        self.assertLessEqual(motion.report["closure"]["largest"], CLOSURE)


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
        velocities = motion.point("coupler.1", "velocity")
        accelerations = motion.point("coupler.1", "acceleration")

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
            motion = run(text.replace("to: 1.0", f"to: {to}"), status=5)
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
            motion = run(FOUR_BAR.format(linkage, 0.0, 3.0 * sign, 60), status=5)
            self.close(motion.events("limit")[0], expected, DEAD_POINT, "limit of the crank")

    def test_of_the_library_reports_it_in_its_own_units(self) -> None:
        motion = run(Path("planar/four_bar.yaml"))
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
        motion = run(SLIDER_CRANK.format(c=14, to=90, steps=90), status=5)
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

        self.check_six_bar(Path("planar/watt_six_bar.yaml"), "swing", f, "motor", lambda t: pins(t),
                           lambda t: cmath.phase((pins(t)[1] - pins(t)[2]) / (f - g)))

    def test_of_stephenson(self) -> None:
        first = FourBar(complex(0), 20 + 40j, 90 + 75j, complex(100))
        e, f, g = 60 + 110j, 150 + 120j, 170 + 10j

        def pins(angle: float) -> tuple[complex, complex, complex]:
            at_e = first.coupler_point(e, angle)
            return at_e, dyad(at_e, g, abs(f - e), abs(g - f), (e, g, f)), g

        self.check_six_bar(Path("planar/stephenson_six_bar.yaml"), "lever", f, "motor",
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


class Cams(MotionTest):
    def test_lift_as_the_disc_turns(self) -> None:
        motion = run(Path("planar/cam_and_follower.yaml"), "--drive", "motor", "--to", "360 deg",
                     "--steps", "36", "--case", "opening", "--report", "g.vy", "--report", "c.R",
                     "--report", "transmission_angle")
        self.check_complete(motion, motion.report["steps"])

        def lift(angle: float) -> float:
            e = turned(9 + 12j, angle)
            return e.imag + math.sqrt(41.0 ** 2 - e.real ** 2) - 52.0
        speed = 20 * math.pi
        self.check(motion, "g.vy/position", lift, 1e-10)
        self.check(motion, "g.vy/velocity",
                   lambda t: speed * derivative(lift, t, 1).real, 1e-4)
        self.check(motion, "g.vy/acceleration",
                   lambda t: speed ** 2 * derivative(lift, t, 2).real, 1e-1)
        for step, angle in enumerate(motion["motor/drive"]):
            e = turned(9 + 12j, angle)
            slope = math.asin(abs(e.real) / 41)
            self.close(motion["valve_spring/transmission_angle"][step], math.pi / 2 - slope, 1e-9,
                       "pressure angle")
            self.close(motion["c.R/action"][step], 200 / math.cos(slope), 1e-8, "contact force")


class SpatialLinkages(MotionTest):
    @staticmethod
    def rod(crank: float) -> tuple[float, float, float]:
        """p, q, s of the rod's length p cos(t) + q sin(t) = s, the rocker turned by t about y."""
        b = turned(40 + 20j, crank)
        k = (120 - b.real, 20 - b.imag, 40.0)  # from the crank's ball to the rocker's bearing
        r = (-20, 60, 20)                      # from there to its own ball, as drawn
        fixed = sum(x * x for x in k) + sum(x * x for x in r) + 2 * k[1] * r[1]
        return 2 * (k[0] * r[0] + k[2] * r[2]), 2 * (k[0] * r[2] - k[2] * r[0]), 10800 - fixed

    @classmethod
    def rocker(cls, crank: float) -> float:
        """Its turn from the drawn position, on the branch on which that is none for no turn."""
        def on(branch: float, angle: float) -> float:
            p, q, s = cls.rod(angle)
            half = math.acos(max(-1.0, min(1.0, s / math.hypot(p, q))))
            return math.remainder(math.atan2(q, p) + branch * half, 2 * math.pi)
        return on(1.0 if abs(on(1.0, 0.0)) < abs(on(-1.0, 0.0)) else -1.0, crank)

    def test_rssr_keeps_the_length_of_its_rod(self) -> None:
        self.assertLess(abs(self.rocker(0.0)), 1e-12)
        motion = run(Path("spatial/rssr.yaml"))
        self.check_complete(motion, motion.report["steps"])
        for step, angle in enumerate(motion["motor/drive"]):
            self.close(motion["d.wy/position"][step], self.rocker(angle), 1e-12, f"at {angle}")
            self.close(motion["d.wy/velocity"][step],
                       10 * derivative(self.rocker, angle, 1, 0.01).real, 1e-6, "velocity")
            self.close(motion["d.wy/acceleration"][step],
                       100 * derivative(self.rocker, angle, 2, 0.01).real, 1e-3, "acceleration")

    def test_rssr_stops_where_its_balls_cannot_reach_further(self) -> None:
        for to in (3.0, -3.0):
            motion = run(Path("spatial/rssr.yaml"), "--from", "0", "--to", f"{to} rad", status=5)
            self.close(motion.events("limit")[0], self.limit(math.copysign(1.0, to)), DEAD_POINT,
                       "limit")

    @classmethod
    def limit(cls, sign: float) -> float:
        """Where |s| = hypot(p, q), by bisection."""
        def slack(crank: float) -> float:
            p, q, s = cls.rod(crank)
            return math.hypot(p, q) - abs(s)
        low, high = 0.0, 0.0
        while slack(high) > 0:
            low, high = high, high + sign * 0.01
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (middle, high) if slack(middle) > 0 else (low, middle)
        return low

    def test_bennett_keeps_the_product_of_half_tangents(self) -> None:
        """tan(A/2) tan(B/2) is constant, A and B the angles at neighbouring joints."""
        motion = run(Path("spatial/bennett.yaml"))
        self.check_complete(motion, motion.report["steps"])
        # The rate of b to that of a is -sin(B)/sin(A), and opposite joints turn equally.
        for step in range(len(motion.rows)):
            self.close(motion["c.w/position"][step], motion["a.w/position"][step], 1e-12,
                       "opposite joints")
        joint = [(40.0, 0.0, 20.0), (20.0, 60.0, -20.0), (-40.0, 0.0, 20.0), (-20.0, -60.0, -20.0)]
        axis = [(-3, 1, 3), (0, 2, 3), (3, -1, 3), (0, -2, 3)]
        start = [self.turn_at(joint, axis, i) for i in (0, 1)]
        constant = math.tan(start[0] / 2) * math.tan(start[1] / 2)
        for step in range(len(motion.rows)):
            first = start[0] + motion["a.w/position"][step]
            second = start[1] + motion["b.w/position"][step]
            # tan(A/2) tan(B/2) = k without the poles of the tangent.
            fault = (math.sin(first / 2) * math.sin(second / 2)
                     - constant * math.cos(first / 2) * math.cos(second / 2))
            self.close(fault, 0.0, 1e-12 * max(1.0, abs(constant)), "product of half tangents")

    @staticmethod
    def turn_at(joint: list, axis: list, i: int) -> float:
        """Angle at joint i from the link before it to the link behind it, about its axis."""
        def minus(a: tuple, b: tuple) -> tuple:
            return tuple(x - y for x, y in zip(a, b))

        def dot(a: tuple, b: tuple) -> float:
            return sum(x * y for x, y in zip(a, b))

        def cross(a: tuple, b: tuple) -> tuple:
            return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
        before = minus(joint[i], joint[i - 1])
        behind = minus(joint[(i + 1) % 4], joint[i])
        size = math.sqrt(dot(axis[i], axis[i]))
        return math.atan2(dot(axis[i], cross(before, behind)) / size, dot(before, behind))

    def test_platform_has_the_lengths_of_its_legs(self) -> None:
        """The distances of the joints, to the closure of a mechanism of more than 2 m."""
        motion = run(Path("spatial/ups_platform.yaml"))
        self.check_complete(motion, motion.report["steps"])
        base = [math.radians(x) for x in (10, 110, 130, 230, 250, 350)]
        top = [math.radians(x) for x in (50, 70, 170, 190, 290, 310)]
        big, small, height = 1.2, 0.7, 1.0
        drawn = math.sqrt(big ** 2 + small ** 2 + height ** 2
                          - 2 * big * small * math.cos(math.radians(40)))
        for step in range(len(motion.rows)):
            at = [motion[f"platform/at/{x}"][step] for x in "xyz"]
            rotation = [math.radians(motion[f"platform/rotation/{x}"][step]) for x in "xyz"]
            for leg in range(6):
                drawn_joint = (small * math.cos(top[leg]), small * math.sin(top[leg]), 0.0)
                joint = [a + b for a, b in zip(at, rotated(rotation, drawn_joint))]
                foot = (big * math.cos(base[leg]), big * math.sin(base[leg]), 0.0)
                length = math.dist(joint, foot)
                self.close(length - drawn, motion[f"leg{leg + 1}/drive"][step], 2 * CLOSURE,
                           f"leg {leg + 1} in step {step}")


def rotated(turn: list[float], point: tuple[float, ...]) -> list[float]:
    """By Rodrigues' formula; the vector is the axis times the angle."""
    angle = math.sqrt(sum(x * x for x in turn))
    if angle == 0.0:
        return list(point)
    k = [x / angle for x in turn]
    cross = (k[1] * point[2] - k[2] * point[1], k[2] * point[0] - k[0] * point[2],
             k[0] * point[1] - k[1] * point[0])
    along = sum(x * y for x, y in zip(k, point))
    return [p * math.cos(angle) + c * math.sin(angle) + x * along * (1 - math.cos(angle))
            for p, c, x in zip(point, cross, k)]


class Cables(MotionTest):
    def test_of_a_tackle_share_the_travel_of_the_hand(self) -> None:
        motion = run(Path("cables/block_and_tackle.yaml"))
        self.check_complete(motion, motion.report["steps"])
        for step, hand in enumerate(motion["hand/drive"]):
            self.close(motion["L.vy/position"][step], -hand / 4, 1e-9, "block")
            # The rope runs over the sheave, which does not slip.
            self.close(motion["B1.wz/position"][step], -hand / 50, 1e-9, "first sheave")


class Tables(MotionTest):
    def test_are_the_same_in_csv(self) -> None:
        path = MECHANISMS / "planar/four_bar.yaml"
        motion = run(Path("planar/four_bar.yaml"))
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
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    sys.argv = [sys.argv[1], *sys.argv[3:]]
    unittest.main(argv=sys.argv)
