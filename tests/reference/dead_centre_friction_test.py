#!/usr/bin/env python3
"""Friction near dead centres, where without it known torques have no, or another, equilibrium.

Usage: dead_centre_friction_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import csv
import io
import math
import sys
import unittest

import program
from motion_case import Motion
from reference_test_case import ReferenceTest

MU = 0.1
TORQUE = 2.0  # [N·m], known of the motor
HIGH = 15.0   # of the disc's centre above the crank's axis [mm]
DISC = 30.0   # radius [mm]
TIP = 10.0    # radius [mm]


def cam_text(aside: float, torque: float = TORQUE) -> str:
    """A disc off the axis pushes a follower that slides along y, the motor turning by 1 rad/s."""
    return f"""\
kinestat: 1
space: planar
units: {{length: mm}}
parameters: {{ex: {aside}, ey: {HIGH}, D: {DISC}, R: {DISC + TIP}, q: sqrt(R^2 - ex^2)}}
ground: frame
bodies: [cam, fol]
couplings:
  a: {{type: revolute, bodies: [frame, cam], at: [0, 0]}}
  g: {{type: prismatic, bodies: [frame, fol], at: [0, ey + q], axis: y}}
  c: {{type: cam, bodies: [cam, fol], at: [ex - ex*D/R, ey + q*D/R], normal: [-ex, q],
       radii: [D, {TIP}], friction: {MU}}}
actuators: {{motor: {{coupling: a}}, spring: {{coupling: g}}}}
cases:
  one: {{motion: {{motor: 1}}, action: {{motor: {torque} N*m}}, input: motor, output: spring}}
"""


def cam_forces(x: float, y: float, torque: float = TORQUE) -> tuple[float, float]:
    """Normal force and spring [N] with the disc's centre at (x, y) mm, the surfaces pushing."""
    reach = DISC + TIP
    rise = math.sqrt(reach**2 - x**2)
    normal = (-x / reach, rise / reach)
    touch = (x + DISC * normal[0], y + DISC * normal[1])
    # The disc's surface runs by at (-y, x); the follower moves so that it does not part.
    lift = (-touch[1] * normal[0] + touch[0] * normal[1]) / normal[1]
    slide = (touch[1], lift - touch[0])
    speed = math.hypot(*slide)
    push = tuple(n - MU * s / speed for n, s in zip(normal, slide))
    lever = (touch[0] * push[1] - touch[1] * push[0]) / 1000
    force = torque / lever
    return force, -force * push[1]


class Cams(ReferenceTest):
    def solved(self, text: str) -> dict:
        one = program.run("analyze", "-", text=text)["cases"]["one"]
        self.assertEqual(one["statics"]["status"], "solved")
        return one["statics"]

    def test_pushes_behind_the_dead_centre(self) -> None:
        """Friction outweighs what the follower gives back: of two roots one pushes."""
        for aside in (-1.5, -3.0, -0.1):
            with self.subTest(aside):
                statics = self.solved(cam_text(aside))
                force, spring = cam_forces(aside, HIGH)
                self.assertGreater(force, 0.0)
                self.near(statics["actions"]["c.R"], force, "R", force)
                self.near(statics["actions"]["spring"], spring, "spring", force)
                self.near(statics["actions"]["motor"], TORQUE, "motor")
                self.near(statics["friction"]["c"]["drag"], MU * force, "friction", force)

    def test_numbers_worked_out_by_hand(self) -> None:
        force, spring = cam_forces(-1.5, HIGH)
        self.assertAlmostEqual(force, 822.411, 3)
        self.assertAlmostEqual(spring, -824.916, 3)
        self.assertAlmostEqual(cam_forces(0.0, HIGH)[0], 2000 / 4.5, 9)

    def test_pushes_at_the_dead_centre(self) -> None:
        """mu N 45 mm = 2 N·m: without friction nothing would hold the torque."""
        statics = self.solved(cam_text(0.0))
        force = 2000 / (MU * (HIGH + DISC))
        self.near(statics["actions"]["c.R"], force, "R", force)
        self.near(statics["actions"]["spring"], -force, "spring", force)
        self.near(statics["friction"]["c"]["drag"], MU * force, "friction", force)

    def test_a_torque_that_brakes_has_no_equilibrium_there(self) -> None:
        done = program.call("analyze", "-", text=cam_text(0.0, -TORQUE))
        self.assertIn("error[E0602]", done.stderr)

    def test_pulls_where_no_push_fits(self) -> None:
        """Far enough behind, the follower drives: the motor would have to hold it back."""
        done = program.call("analyze", "-", text=cam_text(-6.0))
        self.assertLess(cam_forces(-6.0, HIGH)[0], 0.0)
        self.assertIn("W0605", done.stderr)

    def test_motions_and_sweeps_find_the_same(self) -> None:
        """The centre of the disc turns with the cam from -4.5 to 4.5 degrees about the top."""
        centre = complex(0.0, HIGH)
        text = cam_text(0.0) + """\
sweep: {vary: {ex: {values: [-3, -1.5, 0, 1.5]}}, report: [c.R, spring]}
motion: {drive: motor, from: -0.08, to: 0.08, steps: 4, case: one, report: [c.R, spring]}
"""
        motion = Motion(program.report(program.call("motion", "-", text=text)))
        self.assertEqual(motion["status"], ["solved"] * 5)
        for angle, force, spring in zip(
                motion["motor/drive"], motion["c.R/action"], motion["spring/action"]):
            at = centre * complex(math.cos(angle), math.sin(angle))
            expected = cam_forces(at.real, at.imag)
            # A moved position closes to some 1e-12 of its size.
            self.assertLess(abs(force / expected[0] - 1), 1e-9)
            self.assertLess(abs(spring / expected[1] - 1), 1e-9)
        rows = list(csv.DictReader(io.StringIO(program.plain("sweep", "-", text=text).stdout)))
        self.assertEqual([row["status"] for row in rows], ["solved"] * 4)
        for row in rows:
            force = cam_forces(float(row["ex"]), HIGH)[0]
            self.near(float(row["c.R [N]"]), force, "R", abs(force))



JOURNAL = 0.2 * 0.020  # coefficient times radius [m]
CRANK, ROD = 0.030, 0.100  # [m]


def crank_text(angle: float) -> str:
    """A crank that turns by 1 rad/s in a journal with friction, under a known torque."""
    return f"""\
kinestat: 1
space: planar
units: {{length: mm, angle: deg}}
parameters: {{th: {angle} deg, x: 30 mm*cos(th) + sqrt((100 mm)^2 - (30 mm*sin(th))^2)}}
ground: frame
bodies: [crank, rod, ram]
couplings:
  a: {{type: revolute, bodies: [frame, crank], at: [0, 0], friction: {{mu: 0.2, radius: 20}}}}
  b: {{type: revolute, bodies: [crank, rod], at: [30 mm*cos(th), 30 mm*sin(th)]}}
  c: {{type: revolute, bodies: [rod, ram], at: [x, 0]}}
  d: {{type: prismatic, bodies: [frame, ram], at: [x, 0], axis: x}}
actuators: {{motor: {{coupling: a}}, work: {{coupling: d}}}}
cases:
  one: {{motion: {{motor: 1}}, action: {{motor: {TORQUE} N*m}}, input: motor, output: work}}
"""


def ram_forces(angle: float) -> list[float]:
    """T = mu r |W| / cos(beta) - W dx/dtheta: the work [N] of either sign that fulfils it."""
    theta = math.radians(angle)
    lean = math.asin(CRANK * math.sin(theta) / ROD)
    advance = -CRANK * math.sin(theta) - CRANK * math.cos(theta) * math.tan(lean)
    rub = JOURNAL / math.cos(lean)
    forces = [TORQUE / (sign * rub - advance) for sign in (1, -1)]
    return [w for w, sign in zip(forces, (1, -1)) if w * sign > 0]


class Cranks(ReferenceTest):
    """A journal rubs pressed either way."""

    def test_says_that_there_is_another_equilibrium(self) -> None:
        for angle in (5, 3, 1):
            with self.subTest(angle):
                first, other = ram_forces(angle)
                done = program.call("analyze", "-", text=crank_text(angle))
                statics = program.report(done)["cases"]["one"]["statics"]
                self.near(statics["actions"]["work"], first, "work", first)
                self.assertIn("warning[W0608]", done.stderr)
                self.assertIn(f"work = {other:.6g} N", done.stderr)
        self.assertAlmostEqual(ram_forces(5)[0], 270.353, 3)
        self.assertAlmostEqual(ram_forces(5)[1], -3305.72, 2)

    def test_is_silent_where_there_is_one(self) -> None:
        for angle in (10, 45, 90, -10, -60, 150):
            with self.subTest(angle):
                self.assertEqual(len(ram_forces(angle)), 1)
                done = program.call("analyze", "-", text=crank_text(angle))
                statics = program.report(done)["cases"]["one"]["statics"]
                self.near(statics["actions"]["work"], ram_forces(angle)[0], "work", 1e4)
                self.assertNotIn("W0608", done.stderr)

    def test_leaves_the_sign_open_at_the_dead_centre(self) -> None:
        """4 mm |F| = 2 N·m: 500 N either way."""
        done = program.call("analyze", "-", text=crank_text(0))
        self.assertNotIn("E0602", done.stderr)
        self.assertIn("error[E0605]", done.stderr)
        self.assertIn("work = 500 N, or work = -500 N", done.stderr)

    def test_motions_say_so_too(self) -> None:
        text = crank_text(5) + "motion: {drive: motor, from: 0 deg, to: -10 deg, steps: 2, " \
                               "case: one, report: [work]}\n"
        done = program.call("motion", "-", text=text)
        motion = Motion(program.report(done))
        self.assertEqual(motion["status"], ["solved", "ambiguous", "solved"])
        self.assertIsNone(motion["work/action"][1])
        self.assertIn("E0605", done.stderr)
        self.assertIn("W0608", done.stderr)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
