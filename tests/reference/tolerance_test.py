#!/usr/bin/env python3
"""Errors of parts and drives against finite positions with a part off, and closed forms.

Usage: tolerance_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import math
import random
import sys
import unittest
from pathlib import Path

import yaml

import program

MECHANISMS = Path()
STEP = 1e-30  # of a complex step: the derivative without a difference


def tolerance(text: str, *arguments: str) -> dict:
    return program.run("tolerance", "-", *arguments, text=text)


def positions(text: str, *arguments: str) -> dict:
    return next(iter(tolerance(text, *arguments)["cases"].values()))["positions"]


def vector(share: dict) -> list[float]:
    """The influence of each direction; none where nothing moves."""
    direction = share["direction"] or [0.0, 0.0, 0.0]
    return [share["influence"] * one for one in direction]


def four_bar(a, b, c, d, space: str = "planar", shift: float = 0.0) -> str:
    def at(point) -> str:
        place = [point[0] + shift, point[1] + shift] + ([shift] if space == "spatial" else [])
        return f"at: {place}" + (", axis: z" if space == "spatial" else "")

    return f"""kinestat: 1
space: {space}
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {{type: revolute, bodies: [frame, crank], {at(a)}}}
  b: {{type: revolute, bodies: [crank, coupler], {at(b)}}}
  c: {{type: revolute, bodies: [coupler, rocker], {at(c)}}}
  d: {{type: revolute, bodies: [frame, rocker], {at(d)}}}
actuators: {{motor: {{coupling: a}}, lever: {{coupling: d}}}}
cases: {{held: {{motion: {{motor: 1 rad/s}}}}}}
"""


def apart(a, b, c, d, coupling: str, axis: int):
    """By how much the rocker turns where the head of a coupling is moved against its tail."""
    step = [0.0, 0.0]
    step[axis] = complex(0.0, STEP)

    def moved(point, name):
        return [point[i] + (step[i] if name == coupling else 0.0) for i in range(2)]

    length = math.dist(b, c)
    rocker = math.dist(c, d)
    # The crank held turns nothing: its pin goes with its pivot. The rocker's end lies on a circle
    # about its pivot, and where the coupler's end is, moved by the step there.
    centre = [x + y - z for x, y, z in zip(moved(b, "b"), moved(a, "a"), a)]
    pivot = moved(d, "d")
    shift = [y - x for x, y in zip(c, moved(c, "c"))]
    start = [x + y for x, y in zip(centre, shift)]  # about which the rocker's end lies
    gap = [y - x for x, y in zip(start, pivot)]
    square = gap[0] ** 2 + gap[1] ** 2
    along = (length**2 - rocker**2 + square) / (2 * square)
    across = cmath.sqrt(length**2 / square - along**2)
    side = (c[0] - b[0]) * (d[1] - b[1]) - (c[1] - b[1]) * (d[0] - b[0])
    across = across if side < 0 else -across
    end = [start[0] + along * gap[0] - across * gap[1], start[1] + along * gap[1] + across * gap[0]]
    arm = [end[0] - pivot[0], end[1] - pivot[1]]
    assert abs(end[0] - c[0]) + abs(end[1] - c[1]) < 1e-9
    turn = cmath.atan(arm[1] / arm[0]) if abs(arm[0]) > abs(arm[1]) else -cmath.atan(arm[0] / arm[1])
    return turn.imag / STEP


class FourBars(unittest.TestCase):
    """Each pin in turn stands elsewhere in one of its bodies; the circles then meet elsewhere."""

    def test_turn_as_their_circles_do(self) -> None:
        draw = random.Random(25)
        checked = 0
        while checked < 120:
            points = [[draw.uniform(-1.0, 1.0) for _ in range(2)] for _ in range(4)]
            a, b, c, d = points
            rod = math.atan2(c[1] - b[1], c[0] - b[0]) - math.atan2(c[1] - d[1], c[0] - d[0])
            if abs(math.sin(rod)) < 0.05 or min(math.dist(p, q) for p in points for q in points
                                                if p is not q) < 0.05:
                continue
            checked += 1
            by = positions(four_bar(*points))["d.wz"]["by"]
            largest = max(by[f"{name}/place"]["influence"] for name in "abcd")
            for name in "abcd":
                found = vector(by[f"{name}/place"])
                for axis in range(2):
                    expected = apart(a, b, c, d, name, axis)
                    self.assertAlmostEqual(found[axis], expected, delta=1e-11 * largest)

    def test_of_a_textbook(self) -> None:
        """0.1 mm of any pin turns a rocker of 100.5 mm by 0.1/(100.5 sin 69.1 deg) at most."""
        points = [[0, 0], [30, 40], [110, 90], [120, -10]]
        rod = math.atan2(50, 80) - math.atan2(100, -10)
        turn = 0.1 / (math.hypot(10, 100) * abs(math.sin(rod)))
        text = four_bar(*points).replace("ground:", "units: {length: mm}\nground:")
        lever = positions(text, "--place", "0.1mm")["d.wz"]
        for name in "abcd":
            self.assertAlmostEqual(lever["by"][f"{name}/place"]["moved"]["value"], turn, delta=1e-14)
        self.assertAlmostEqual(lever["worst_case"], 4 * turn, delta=1e-14)
        self.assertAlmostEqual(lever["root_sum_square"], 2 * turn, delta=1e-14)

    def test_tilt_in_space_only_with_play(self) -> None:
        points = [[0, 0], [0.3, 0.4], [1.1, 0.9], [1.2, -0.1]]
        flat = positions(four_bar(*points))["d.wz"]["by"]
        case = tolerance(four_bar(*points, space="spatial"))["cases"]["held"]
        bears = [f"{name}.{action}" for name in "abcd" for action in ("Rz", "Tx", "Ty")]
        self.assertEqual(sorted(case["not_fitting"]), sorted(bears))
        spatial = case["positions"]["d.wz"]["by"]
        for name in "abcd":
            self.assertNotIn(f"{name}/angle", spatial)
            for x, y in zip(vector(spatial[f"{name}/place"]), vector(flat[f"{name}/place"])):
                self.assertAlmostEqual(x, y, delta=1e-12)

    def test_far_from_the_origin(self) -> None:
        points = [[0, 0], [0.25, 0.5], [1, 0.75], [1.25, -0.25]]  # exact there, too
        def answer(shift: float) -> dict:
            trace = f"{{body: coupler, at: [{0.5 + shift}, {1 + shift}], name: P}}"
            motion = f"motion: {{drive: motor, to: 40 deg, steps: 2, trace: [{trace}]}}\n"
            text = four_bar(*points, shift=shift) + motion
            watched = [word for name in ("coupler", "lever", "P") for word in ("--of", name)]
            steps = tolerance(text, "--along", *watched)["cases"]
            return {f"{label} {name}": one for label, step in steps.items()
                    for name, one in step["positions"].items()} | positions(text, *watched)

        near, far = answer(0.0), answer(2.0**20)
        for name, one in near.items():
            for key, share in one["by"].items():
                self.assertAlmostEqual(
                    far[name]["by"][key]["influence"], share["influence"], delta=1e-9)

    def test_of_the_coupler_is_that_of_a_body_on_two_points(self) -> None:
        """Its pins go where crank and rocker take them: a point between them goes half of both."""
        points = [[0, 0], [0.3, 0.4], [1.1, 0.9], [1.2, -0.1]]
        text = four_bar(*points) + """motion:
  drive: motor
  to: 1 deg
  trace: [{body: coupler, at: [0.3, 0.4], name: B}, {body: coupler, at: [1.1, 0.9], name: C},
          {body: coupler, at: [0.7, 0.65], name: M}]
"""
        found = positions(text)
        for axis in "xy":
            for key in found["M/at/x"]["by"]:
                b, c, m = (found[f"{point}/at/{axis}"]["by"][key] for point in "BCM")
                for i in range(2):
                    mean = (vector(b)[i] + vector(c)[i]) / 2 if b["direction"] or c["direction"] \
                        else (b["influence"] + c["influence"]) / 2
                    value = vector(m)[i] if m["direction"] or b["direction"] or c["direction"] \
                        else m["influence"]
                    self.assertAlmostEqual(value, mean, delta=1e-13)
        # The pin of the held crank goes with the pivot, and by what its hole is off.
        self.assertAlmostEqual(found["B/at/x"]["by"]["a/place"]["influence"], 1.0, delta=1e-14)
        self.assertAlmostEqual(found["B/at/x"]["by"]["b/place"]["influence"], 1.0, delta=1e-14)
        self.assertEqual(found["B/at/x"]["by"]["c/place"]["influence"], 0.0)


class Motions(unittest.TestCase):
    def test_step_is_the_mechanism_drawn_there(self) -> None:
        a, b, c, d = [0, 0], [0.3, 0.4], [1.1, 0.9], [1.2, -0.1]
        text = four_bar(a, b, c, d) + """motion:
  drive: motor
  to: 300 deg
  steps: 10
  trace: [{body: coupler, at: [0.5, 0.9], name: P}]
"""
        steps = tolerance(text, "--along", "--of", "d.wz", "--of", "P")["cases"]
        path = program.run("motion", "--report", "position", "-", text=text)["motion"]
        titles = [f"{one['element']}/{one['quantity']}" for one in path["columns"]]
        start = math.atan2(b[1], b[0])
        for k in range(11):
            turn = start + math.radians(30 * k)
            pin = [0.5 * math.cos(turn), 0.5 * math.sin(turn)]
            row = dict(zip(titles, path["rows"][k]))
            lever = math.atan2(c[1] - d[1], c[0] - d[0]) + row["d.wz/position"]
            size = math.dist(c, d)
            end = [d[0] + size * math.cos(lever), d[1] + size * math.sin(lever)]
            self.assertAlmostEqual(math.dist(pin, end), math.dist(b, c), delta=1e-12)
            self.assertAlmostEqual(steps[f"step {k}"]["drive"]["value"], math.radians(30 * k), delta=1e-14)
            found = steps[f"step {k}"]["positions"]
            for name in "abcd":
                share = vector(found["d.wz"]["by"][f"{name}/place"])
                for axis in range(2):
                    self.assertAlmostEqual(
                        share[axis], apart(a, pin, end, d, name, axis) if name != "a" else
                        apart([0, 0], pin, end, d, "a", axis), delta=1e-11)
            place = [row["P/at/x"], row["P/at/y"]]
            drawn = four_bar(a, pin, end, d) + f"""motion:
  drive: motor
  to: 1 deg
  trace: [{{body: coupler, at: {place}, name: P}}]
"""
            expected = positions(drawn, "--of", "P")
            for key, one in expected.items():
                for name, share in one["by"].items():
                    self.assertAlmostEqual(found[key]["by"][name]["influence"],
                                           share["influence"], delta=1e-11)


class SliderCranks(unittest.TestCase):
    R, L, THETA = 0.05, 0.15, math.radians(40)

    def text(self) -> str:
        pin = [self.R * math.cos(self.THETA), self.R * math.sin(self.THETA)]
        piston = [pin[0] + math.sqrt(self.L**2 - pin[1] ** 2), 0.0]
        return f"""kinestat: 1
space: planar
units: {{length: mm, angle: deg}}
ground: frame
bodies: [crank, rod, piston]
couplings:
  a: {{type: revolute, bodies: [frame, crank], at: [0, 0]}}
  b: {{type: revolute, bodies: [crank, rod], at: {[1e3 * x for x in pin]}}}
  c: {{type: revolute, bodies: [rod, piston], at: {[1e3 * x for x in piston]}}}
  d: {{type: prismatic, bodies: [frame, piston], at: {[1e3 * x for x in piston]}, axis: x}}
actuators: {{motor: {{coupling: a}}, slide: {{coupling: d}}}}
cases: {{held: {{motion: {{motor: 1 rad/s}}}}}}
"""

    def test_move_as_the_rod_leans(self) -> None:
        lean = math.asin(self.R * math.sin(self.THETA) / self.L)
        slide = positions(self.text(), "--place", "0.02mm", "--each", "motor=0.1deg")["d.vx"]
        for name in "abc":  # along the rod
            self.assertAlmostEqual(slide["by"][f"{name}/place"]["influence"],
                                   1 / math.cos(lean), delta=1e-12)
        self.assertAlmostEqual(slide["by"]["d/place"]["influence"], math.tan(lean), delta=1e-12)
        self.assertEqual(slide["by"]["d/angle"]["influence"], 0.0)  # about the piston's pin
        # ds/dtheta of s = r cos(theta) + sqrt(l^2 - r^2 sin^2(theta)), in mm per degree.
        speed = -self.R * math.sin(self.THETA) * (
            1 + self.R * math.cos(self.THETA) / (self.L * math.cos(lean)))
        drive = slide["by"]["motor/drive"]
        self.assertAlmostEqual(drive["influence"], 1e3 * speed * math.pi / 180, delta=1e-12)
        self.assertEqual(drive["unit"], "mm/deg")
        parts = [0.02 / math.cos(lean)] * 3 + [0.02 * math.tan(lean),
                                               abs(1e3 * speed) * math.pi / 1800]
        self.assertAlmostEqual(slide["worst_case"], sum(parts), delta=1e-13)
        self.assertAlmostEqual(slide["root_sum_square"],
                               math.sqrt(sum(x * x for x in parts)), delta=1e-13)


class Gears(unittest.TestCase):
    def test_turn_by_backlash_along_the_line_of_action(self) -> None:
        text = """kinestat: 1
space: planar
units: {length: mm}
ground: frame
bodies: [pinion, wheel]
couplings:
  a: {type: revolute, bodies: [frame, pinion]}
  b: {type: revolute, bodies: [frame, wheel]}
gears:
  module: 2 mm
  members: {p: {body: pinion, teeth: 20}, w: {body: wheel, teeth: 50}}
  meshes: {m: {members: [p, w]}}
actuators: {in: {coupling: a}, out: {coupling: b}}
cases: {held: {motion: {in: 1 rad/s}}}
"""
        by = positions(text)["b.wz"]["by"]
        base = 50 * math.cos(math.radians(20))  # radius of the wheel's base circle
        for name in ("m", "a", "b"):  # a bearing that is off opens the flanks by as much
            self.assertAlmostEqual(by[f"{name}/place"]["influence"], 1 / base, delta=1e-14)
        self.assertAlmostEqual(abs(by["in/drive"]["influence"]), 20 / 50, delta=1e-14)


TOOTHED = """kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [lever, wheel, rack]
couplings:
  d: {type: revolute, bodies: [frame, lever], at: [120, -10]}
  w: {type: revolute, bodies: [frame, wheel], at: [180, -10]}
  m: {type: gear, bodies: [lever, wheel], at: [160, -10], tangent: y, pressure_angle: 20 deg}
  g: {type: prismatic, bodies: [frame, rack], at: [180, -30], axis: x}
  r: {type: rack, bodies: [wheel, rack], at: [180, -30], line_of_action: [cos(20 deg), -sin(20 deg)]}
actuators: {motor: {coupling: d}, out: {coupling: g}}
cases: {held: {motion: {motor: 1 rad/s}, action: {out: FORCE N}}}
"""


class Flanks(unittest.TestCase):
    def test_are_those_that_the_load_presses(self) -> None:
        """What the bearing of the wheel moves is what it bears under a force of 1 N at the rack:
        that force and the one of the lever, both apart or both together, in x and in y."""
        for force, sign in ((10, 1), (-10, -1)):
            shares = positions(TOOTHED.replace("FORCE", str(force)), "--of", "out",
                               "--place", "1mm")["g.vx"]["by"]
            bearing = shares["w/place"]["influence"]
            self.assertAlmostEqual(bearing, math.sqrt(2) * (1 + sign * math.tan(math.radians(20))),
                                   delta=1e-12)


class Spatial(unittest.TestCase):
    """RSSR: the rod keeps its length, so its ends go equally far along it."""

    def test_rod_keeps_its_length(self) -> None:
        draw = random.Random(7)
        for _ in range(20):
            crank, lever = ([draw.uniform(-1, 1) for _ in range(3)] for _ in range(2))
            pivot = [draw.uniform(1, 3) for _ in range(3)]
            end = [x + y for x, y in zip(pivot, lever)]
            axis = [draw.uniform(-1, 1) for _ in range(3)]
            size = math.hypot(*axis)
            axis = [x / size for x in axis]
            text = f"""kinestat: 1
ground: frame
bodies: [crank, rod, lever]
couplings:
  a: {{type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}}
  b: {{type: spherical, bodies: [crank, rod], at: {crank}}}
  c: {{type: spherical, bodies: [rod, lever], at: {end}}}
  d: {{type: revolute, bodies: [frame, lever], at: {pivot}, axis: {axis}}}
actuators: {{motor: {{coupling: a}}}}
cases: {{held: {{motion: {{motor: 1 rad/s}}}}}}
"""
            by = positions(text, "--of", "d.w")["d.w"]["by"]
            rod = [x - y for x, y in zip(end, crank)]
            across = cross(axis, lever)
            leverage = dot(rod, across)
            for name, sign in (("a", 1), ("b", 1), ("c", 1), ("d", -1)):
                for x, y in zip(vector(by[f"{name}/place"]), rod):
                    self.assertAlmostEqual(x, sign * y / leverage, delta=1e-10 * abs(1 / leverage))
            # The head tilts about an axis across the drive's by a small angle t: its end goes by
            # t x arm.
            tilt_a = cross(crank, rod)
            for x, y in zip(vector(by["a/angle"]), (tilt_a[0], tilt_a[1], 0.0)):
                self.assertAlmostEqual(x, y / leverage, delta=1e-10 * abs(1 / leverage))
            tilt_d = cross(lever, rod)
            along = dot(tilt_d, axis)
            for x, y, z in zip(vector(by["d/angle"]), tilt_d, axis):
                self.assertAlmostEqual(x, -(y - along * z) / leverage,
                                       delta=1e-10 * abs(1 / leverage))


# A rod between two ball joints, about whose line it spins freely.
SPUN = """kinestat: 1
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, rocker, nut]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}
  b: {type: spherical, bodies: [crank, rod], at: [20, 40, 10]}
  c: {type: spherical, bodies: [rod, rocker], at: [180, 60, 70]}
  d: {type: revolute, bodies: [frame, rocker], at: [200, 0, 50], axis: [1, 0.2, 0.1]}
  h: {type: helical, bodies: [rocker, nut], at: [200, 0, 50], axis: [1, 0.2, 0.1], pitch: 3}
  g: {type: prismatic, bodies: [frame, nut], at: [200, -100, 50], axis: [1, 0.2, 0.1]}
actuators: {motor: {coupling: a}, lev: {coupling: d}, push: {coupling: g}}
cases: {run: {motion: {motor: 20 rad/s}}}
motion:
  drive: motor
  to: -20
  steps: 1
  trace: [{body: rod, at: [20, 40, 10], name: B}, {body: rod, at: [100, 50, 40], name: P},
          {body: rod, at: [180, 60, 70], name: C}, {body: rod, at: [100, 80, 40], name: Q}]
"""


class IdleTurns(unittest.TestCase):
    def check(self, case: dict) -> None:
        found = case["positions"]
        self.assertEqual(case["held"], ["motor"])
        # Q stands 30 mm in y from P, so that the turn about (160, 20, 60) moves it across y.
        self.assertEqual(case["loose"], ["Q/at/x", "Q/at/z", "rod/rotation/x"])
        for one in found.values():
            self.assertEqual([name for name in one["by"] if name.endswith("/drive")], ["motor/drive"])
        for axis in "xyz":
            b, p, c = (found[f"{point}/at/{axis}"]["by"] for point in "BPC")
            for key in p:
                for i in range(3):
                    mean = (vector(b[key])[i] + vector(c[key])[i]) / 2
                    value = vector(p[key])[i]
                    if key == "motor/drive":
                        mean = (b[key]["influence"] + c[key]["influence"]) / 2
                        value = p[key]["influence"]
                    self.assertAlmostEqual(value, mean, delta=1e-11)

    def test_leave_points_of_their_axis_where_they_are(self) -> None:
        """A point between the balls goes half of both; the end of the crank by its arm of 44.7 mm."""
        watched = [word for name in ("B", "P", "C", "Q", "rod/rotation/x", "lev") for word in ("--of", name)]
        case = tolerance(SPUN, *watched)["cases"]["run"]
        self.check(case)
        for axis, arm in (("x", -40), ("y", 20), ("z", 0)):
            self.assertAlmostEqual(
                case["positions"][f"B/at/{axis}"]["by"]["motor/drive"]["influence"],
                math.radians(arm), delta=1e-12)  # [mm/deg]
        step = tolerance(SPUN, "--along", *watched)["cases"]["step 0"]
        self.check(step)
        shown = program.plain("tolerance", "-", *watched, text=SPUN).stdout
        self.assertIn("The drives do not hold Q/at/x, Q/at/z, rod/rotation/x", shown)


PLANETS = """kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  s: {type: revolute, bodies: [housing, sun]}
  r: {type: revolute, bodies: [housing, ring]}
  c: {type: revolute, bodies: [housing, carrier]}
  p: {type: revolute, bodies: [carrier, planet]}
gears:
  module: 2 mm
  members: {s: {body: sun, teeth: 30}, p: {body: planet, teeth: 21, count: 3}, r: {body: ring, teeth: 72, internal: true}}
  meshes: {sp: {members: [s, p], carrier: carrier}, rp: {members: [r, p], carrier: carrier}}
actuators: {in: {coupling: s}, out: {coupling: c}, B: {coupling: r}}
cases: {run: {motion: {in: 10, B: 0}}}
"""


class EqualPlanets(unittest.TestCase):
    def test_of_central_bearings_cancel(self) -> None:
        """The pins stand 51 mm from the axis and bear the couple; teeth of sun and ring half each."""
        by = positions(PLANETS, "--of", "c.wz")["c.wz"]["by"]
        for name in "src":
            self.assertEqual(by[f"{name}/place"]["influence"], 0.0, name)
            self.assertIsNone(by[f"{name}/place"]["direction"], name)
        pin = math.degrees(1 / 51)
        self.assertAlmostEqual(by["p/place"]["influence"], pin, delta=1e-12)
        for name in ("sp", "rp"):
            self.assertAlmostEqual(by[f"{name}/place"]["influence"],
                                   pin / 2 / math.cos(math.radians(20)), delta=1e-12)

    def test_of_a_point_of_the_carrier_go_with_its_bearing(self) -> None:
        text = PLANETS + """motion: {drive: in, to: 10, steps: 1,
         trace: [{body: carrier, at: [0, 0], name: M}]}
"""
        by = positions(text, "--of", "M/at/x")["M/at/x"]["by"]
        self.assertAlmostEqual(by["c/place"]["influence"], 1.0, delta=1e-12)
        for name in ("s", "r", "p", "sp", "rp"):
            self.assertAlmostEqual(by[f"{name}/place"]["influence"], 0.0, delta=1e-12)


def cross(a, b) -> list[float]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b) -> float:
    return sum(x * y for x, y in zip(a, b))


def freedom_of(held: str, file: dict, rates: dict) -> str | None:
    """The freedom that an actuator drives, where its coupling has one; or held by its own name."""
    coupling = (file.get("actuators") or {}).get(held, {}).get("coupling")
    of_coupling = [name for name in rates if name.split(".")[0] == coupling]
    return of_coupling[0] if len(of_coupling) == 1 else held if held in rates else None


class Library(unittest.TestCase):
    """What a drive does when its place is off is what its speed does."""

    def test_drives_move_as_speeds_do(self) -> None:
        checked = 0
        for path in sorted(MECHANISMS.rglob("*.yaml")):
            done = program.call("tolerance", str(path))
            if done.returncode != 0:
                continue
            answer = program.report(done)
            solved = program.report(program.call("analyze", str(path)))["cases"]
            for label, case in answer["cases"].items():
                if len(case["held"]) != 1:
                    continue
                rates = solved[label]["kinematics"]["freedoms"]
                drive = freedom_of(case["held"][0], yaml.safe_load(path.read_text()), rates)
                for name, position in case["positions"].items():
                    if name not in rates or name == drive or not rates.get(drive):
                        continue
                    share = position["by"][f"{case['held'][0]}/drive"]
                    ratio = rates[name] / rates[drive]
                    if share["unit"] == "":
                        self.assertAlmostEqual(share["influence"], ratio,
                                               delta=1e-9 * max(1, abs(ratio)), msg=f"{path} {name}")
                        checked += 1
        self.assertGreater(checked, 25)


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
