#!/usr/bin/env python3
"""Checks cases that leave the spin of a rod between two balls open against closed forms.

Usage: idle_freedom_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import csv
import io
import math
import sys
import unittest

import program
from reference_test_case import ReferenceTest

# What lies between a plane of the frame and one of the lid, or round a shaft, with two or three idle
# freedoms; the lid and the shaft turn about (4, 4, 7)/9 and (1, 2, 2)/3.
PAD = """\
kinestat: 1
ground: base
bodies: [pad, lid]
couplings:
  below: {type: planar, bodies: [base, pad], at: [1, 2, -3], normal: [4, 4, 7]}
  above: {type: planar, bodies: [pad, lid], at: [3, 4, 5], normal: [4, 4, 7]}
  turn: {type: revolute, bodies: [base, lid], at: [2, 1, 0], axis: [4, 4, 7]}
actuators: {motor: {coupling: turn}}
cases: {go: {motion: {motor: 1, KNOWN}}}
"""
SLEEVE = """\
kinestat: 1
ground: base
bodies: [sleeve, shaft]
couplings:
  outer: {type: cylindrical, bodies: [base, sleeve], at: [1, 2, -3], axis: [1, 2, 2]}
  inner: {type: cylindrical, bodies: [sleeve, shaft], at: [1, 2, -3], axis: [1, 2, 2]}
  turn: {type: revolute, bodies: [base, shaft], at: [1, 2, -3], axis: [1, 2, 2]}
actuators: {motor: {coupling: turn}}
cases: {go: {motion: {motor: 1, KNOWN}}}
"""

# A plate on a plane, its point on a slide whose surface has the same normal.
PLATE = """\
kinestat: 1
ground: base
bodies: [slide, plate]
couplings:
  guide: {type: prismatic, bodies: [slide, base], at: [-2, -1, -2], axis: x}
  table: {type: planar, bodies: [base, plate], at: [0, 2, 4], normal: [4, 4, 7]}
  touch: {type: point_contact, bodies: [plate, slide], at: [0.8, -2, 0], normal: [4, 4, 7]}
cases: {go: {motion: {touch.wz: 2}}}
"""

# The crank turns about z through the origin, the lever about x through (150, 0, 50).
TEXT = """\
kinestat: 1
units: {length: mm, angle: deg}
parameters: {r: 40}
ground: frame
bodies: [crank, rod, lever]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}
  b: {type: spherical, bodies: [crank, rod], at: [r, 0, 0]}
  c: {type: spherical, bodies: [rod, lever], at: [120, 60, 50]}
  d: {type: revolute, bodies: [frame, lever], at: [150, 0, 50], axis: x}
actuators: {motor: {coupling: a}, load: {coupling: d}}
cases:
  go: {motion: {motor: 1 rad/s}, action: {load: -1 N*m}, input: motor, output: load}
"""

SPIN = TEXT.replace("{motor: 1 rad/s}", "{motor: 1 rad/s, b.wx: 0.3 rad/s}")


def lever_speed(r: float) -> float:
    """The rod keeps its length: (v_c - v_b) . (c - b) = 0, v_b = (0, r, 0), v_c = (0, 0, 60 w)."""
    rod = (120 - r, 60, 50)
    return r * rod[1] / (60 * rod[2])


def lever_ratio(turn: float, swing: float) -> float:
    """The same with the crank and the lever turned by so much from where they are drawn."""
    c, s = math.cos(swing), math.sin(swing)
    rod = (120 - 40 * math.cos(turn), 60 * c - 40 * math.sin(turn), 50 + 60 * s)
    crank = (-40 * math.sin(turn), 40 * math.cos(turn), 0.0)
    lever = (0.0, -60 * s, 60 * c)
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    return dot(rod, crank) / dot(rod, lever)


class SpinOfARod(ReferenceTest):
    def test_what_is_determined_is_solved_and_the_rest_has_no_number(self) -> None:
        done = program.call("analyze", "-", text=TEXT)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning[W0506]: case 'go' gives no rate for an idle freedom of 'rod'", done.stderr)
        case = program.report(done)["cases"]["go"]
        freedoms = case["kinematics"]["freedoms"]
        self.near(freedoms["d.wx"], lever_speed(40), "lever")
        self.near(case["ratio"], 1 / lever_speed(40), "ratio")
        for name in ("b.wx", "b.wy", "b.wz", "c.wx", "c.wy", "c.wz"):
            self.assertIsNone(freedoms[name], name)
        # Its reference point is the ball on the crank.
        rod = case["kinematics"]["bodies"]["rod"]
        self.assertEqual(sorted(rod), ["at", "linear"])
        for found, expected in zip(rod["linear"], (0.0, 40.0, 0.0)):
            self.assertAlmostEqual(found, expected, delta=1e-12)
        self.assertEqual(case["primary"]["motion"], ["a.wz"])
        self.near(case["statics"]["actions"]["motor"], lever_speed(40), "virtual power")

    def test_every_accuracy_says_the_same(self) -> None:
        for accuracy in ("fast", "high", "exact"):
            case = program.run("analyze", "--accuracy", accuracy, "-", text=TEXT)["cases"]["go"]
            self.near(case["kinematics"]["freedoms"]["d.wx"], lever_speed(40), accuracy)
            self.assertIsNone(case["kinematics"]["freedoms"]["b.wx"], accuracy)

    def test_a_spin_that_is_given_is_solved_as_before(self) -> None:
        done = program.call("analyze", "-", text=SPIN)
        self.assertNotIn("W0506", done.stderr)
        freedoms = program.report(done)["cases"]["go"]["kinematics"]["freedoms"]
        self.near(freedoms["d.wx"], lever_speed(40), "lever")
        self.near(freedoms["b.wx"], 0.3, "given")
        self.assertIsNotNone(freedoms["c.wy"])

    def test_a_sweep_has_no_number_either(self) -> None:
        text = TEXT + "sweep: {vary: {r: {from: 30, to: 50, step: 10}}, report: [d.wx, b.wx]}\n"
        rows = list(csv.DictReader(io.StringIO(program.plain("sweep", "-q", "-", text=text).stdout)))
        self.assertEqual([row["r"] for row in rows], ["30", "40", "50"])
        for row in rows:
            self.near(float(row["d.wx [rad/s]"]), lever_speed(float(row["r"])), "lever")
            self.assertEqual((row["b.wx [rad/s]"], row["status"]), ("", "no_value"))

    def test_forces_of_a_motion_need_no_velocities_beside(self) -> None:
        text = TEXT + "motion: {drive: motor, to: 72 deg, steps: 6, case: go}\n"

        def rows(*report: str) -> list[dict[str, str]]:
            asked = [word for one in report for word in ("--report", one)]
            done = program.plain("motion", "--format", "csv", "--layout", "wide", *asked, "-",
                                 text=text)
            self.assertEqual(done.returncode, 0, done.stderr)
            return list(csv.DictReader(io.StringIO(done.stdout)))

        swings = [float(row["d.wx/position [deg]"]) for row in rows("d.wx/position")]
        expected = [lever_ratio(math.radians(12 * i), math.radians(swing))
                    for i, swing in enumerate(swings)]
        for report, column, value in (
                ("motor/action", "motor/action [N*m]", lambda w: w),
                ("ratio", "load/ratio", lambda w: 1 / w),
                ("mechanical_advantage", "load/mechanical_advantage", lambda w: abs(1 / w))):
            found = rows(report)
            self.assertEqual({row["status"] for row in found}, {"solved"}, column)
            for row, speed in zip(found, expected):
                self.near(float(row[column]), value(speed), column)

    def test_the_derivative_is_that_of_the_lever(self) -> None:
        """w = r 60 / 3000: linear in r."""
        values = program.run("sensitivity", "-", text=TEXT)["cases"]["go"]["sensitivity"]
        self.near(values["d.wx"]["by"]["r"]["derivative"], 60 / 3000, "derivative")

    def test_what_is_not_determined_has_no_derivative(self) -> None:
        for value in ("b.wx", "kinematics/bodies/rod/angular/0"):
            done = program.call("sensitivity", "--of", value, "-", text=TEXT)
            self.assertNotEqual(done.returncode, 0, value)
            self.assertNotIn('"derivative"', done.stdout, value)

    def test_a_free_speed_moves_what_is_determined_alone(self) -> None:
        text = TEXT.replace("{r: 40}", "{speed: {free: 1 rad/s}}").replace("[r, 0, 0]", "[40, 0, 0]")
        text = text.replace("motor: 1 rad/s", "motor: speed")
        affine = program.run("analyze", "-", text=text)["cases"]["go"]["affine"]
        self.near(affine["d.wx"]["speed"], lever_speed(40), "lever")
        for name in ("b.wy", "b.wz", "c.wx", "c.wy", "c.wz"):
            self.assertIsNone(affine.get(name), name)

    def test_what_more_bodies_feel_is_still_an_error(self) -> None:
        text = TEXT.replace("motion: {motor: 1 rad/s}", "motion: {}")
        done = program.call("analyze", "-", text=text)
        self.assertEqual(done.returncode, 3)
        self.assertIn("E0501", done.stderr)

    def test_a_rod_that_rubs_in_its_ball_is_not_assumed_to_rest(self) -> None:
        text = TEXT.replace("bodies: [crank, rod], at: [r, 0, 0]",
                            "bodies: [crank, rod], at: [r, 0, 0], friction: 0.1")
        done = program.call("analyze", "-", text=text)
        self.assertNotEqual(done.returncode, 0)


# Two balls and a guide hold `held` and what is rigid with it; `rod` spins between a ball and a slide.
HELD_BESIDE = """\
kinestat: 1
ground: base
bodies: [held, lever, rod, arm]
couplings:
  c1: {type: spherical, bodies: [base, held], at: [0.7, -1, -2]}
  c2: {type: revolute, bodies: [lever, base], at: [-1.6, 0.4, 3.1], axis: y}
  c3: {type: spherical, bodies: [lever, rod], at: [0, -4, 1]}
  c4: {type: spherical, bodies: [arm, base], at: [0, -1, -4]}
  c5: {type: rigid, bodies: [held, arm], at: [-3.8, -2, -3]}
  c6: {type: prismatic, bodies: [arm, base], at: [-1, 0.1, 3], axis: y}
  c7: {type: sphere_in_tube, bodies: [arm, rod], at: [3.2, -1, 2.4], axis: y}
actuators: {push: {coupling: c7, freedom: vy}}
cases: {go: {motion: {push: 5}}}
motion: {drive: push, to: 1e-6, steps: 1, case: go, report: [velocity]}
"""


class WhatRestsBesideIdleFreedoms(ReferenceTest):
    def test_has_no_rounding_for_a_rate(self) -> None:
        """The balls let it turn about their line, and the guide not at all."""
        done = program.plain("motion", "--format", "csv", "--layout", "wide", "-", text=HELD_BESIDE)
        for row in csv.DictReader(io.StringIO(done.stdout)):
            found = {name: value for name, value in row.items()
                     if name.startswith(("held/", "arm/", "c1.", "c4.", "c6."))}
            self.assertEqual(len(found), 19)
            self.assertEqual(set(found.values()), {"0.0"}, found)


class SeveralIdleFreedomsOfOneBody(ReferenceTest):
    """Whatever basis their space has, what is given of them leaves the rest open, and no more."""

    def rates(self, text: str, expected: dict[str, float | None]) -> None:
        for accuracy in ("auto", "fast", "high", "exact"):
            done = program.call("analyze", "--accuracy", accuracy, "-", text=text)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("W0506", done.stderr)
            self.holds(program.report(done)["cases"]["go"]["kinematics"]["freedoms"], expected)
        rows = list(csv.DictReader(io.StringIO(self.motion(text))))
        self.assertEqual({row["status"] for row in rows}, {"solved"})
        for row in rows:
            found = {name.split("/velocity")[0]: value for name, value in row.items()}
            self.holds({name: float(found[name]) if found[name] else None for name in expected},
                       expected)

    def holds(self, found: dict[str, float | None], expected: dict[str, float | None]) -> None:
        for name, value in expected.items():
            if value is None:
                self.assertIsNone(found[name], name)
            else:
                self.near(found[name], value, name)

    def motion(self, text: str) -> str:
        text += "motion: {drive: motor, to: 0.5, steps: 4, case: go, report: [velocity]}\n"
        done = program.plain("motion", "--format", "csv", "--layout", "wide", "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("W0506", done.stderr)
        return done.stdout

    def test_a_pad_that_turns_by_itself(self) -> None:
        for normal in ("[4, 4, 7]", "[0, 3, 4]", "[0, 0, 1]"):
            text = PAD.replace("KNOWN", "below.w: 0.25").replace("[4, 4, 7]", normal)
            self.rates(text, {"below.w": 0.25, "above.w": 0.75, "below.v1": None,
                              "below.v2": None, "above.v1": None, "above.v2": None})

    def test_a_pad_that_shifts_one_way(self) -> None:
        self.rates(PAD.replace("KNOWN", "below.v1: 0.5"),
                   {"below.v1": 0.5, "below.v2": None, "below.w": None, "above.w": None})

    def test_a_sleeve_that_turns(self) -> None:
        self.rates(SLEEVE.replace("KNOWN", "outer.w: 0.25"),
                   {"outer.w": 0.25, "inner.w": 0.75, "outer.v": None, "inner.v": None})

    def test_a_sleeve_that_shifts(self) -> None:
        self.rates(SLEEVE.replace("KNOWN", "inner.v: 0.5"),
                   {"inner.v": 0.5, "outer.v": -0.5, "outer.w": None, "inner.w": None})

    def test_a_plate_that_turns_is_held_in_two_ways_that_differ(self) -> None:
        """The spin 2 about z is that of a turn of 18/7 about (4, 4, 7)/9; the slide rests."""
        for accuracy in ("auto", "fast", "high", "exact"):
            done = program.call("analyze", "--accuracy", accuracy, "-", text=PLATE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.holds(program.report(done)["cases"]["go"]["kinematics"]["freedoms"],
                       {"guide.vx": 0.0, "table.w": -18 / 7, "touch.wx": 8 / 7, "touch.wy": 8 / 7,
                        "touch.wz": 2.0, "table.v1": None, "table.v2": None, "touch.v1": None,
                        "touch.v2": None})

    def test_what_a_drive_holds_of_them_leaves_the_others_passive(self) -> None:
        text = PAD.replace("motor: {coupling: turn}",
                           "motor: {coupling: turn}, push: {coupling: above, freedom: v1}")
        done = program.plain("mobility", "-", text=text.replace(", KNOWN", ", push: 1"))
        self.assertEqual(done.stdout.count("passive: only pad moves"), 2, done.stdout)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
