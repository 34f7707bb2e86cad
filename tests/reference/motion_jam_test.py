#!/usr/bin/env python3
"""Checks what a motion says of a linkage that friction jams on its way, wherever its steps fall.

A rod of length L leans at the angle a between a hand that is pulled along y and a ram in a guide
along x with friction mu; a load W resists the ram. With the force F of the rod
    F cos a = W + mu F sin a,  so hand = W sin a / (cos a - mu sin a),
    efficiency 1 - mu tan a,  advantage (cos a - mu sin a) / sin a,  ratio cot a.
It jams at tan a = 1 / mu, on the way to the limit of the hand at a = 90 degrees.

And a slider-crank whose input needs nothing in two places.

Usage: motion_jam_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math

import motion_case
from motion_case import Motion, MotionTest, run

LENGTH, LOAD, MU, SPEED = 100.0, 100.0, 0.5, 10.0
BEGIN = 50.0  # of the hand
JAM = LENGTH / math.sqrt(1.0 + MU * MU) - BEGIN
STEPS = (4, 24, 36, 72, 361, 1440)

LADDER = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [hand, rod, ram]
couplings:
  h: {type: prismatic, bodies: [frame, hand], at: [0, 50], axis: y}
  p: {type: revolute, bodies: [hand, rod], at: [0, 50]}
  q: {type: revolute, bodies: [rod, ram], at: ["sqrt(7500)", 0]}
  g: {type: prismatic, bodies: [frame, ram], at: ["sqrt(7500)", 0], axis: x, friction: 0.5}
actuators: {in: {coupling: h}, out: {coupling: g}}
cases: {run: {motion: {in: 10 mm/s}, action: {out: 100 N}, input: in, output: out}}
motion:
  drive: in
  to: limit
  case: run
  report: [velocity, action, power, efficiency, ratio, mechanical_advantage]
"""


def angle(place: float) -> float:
    return math.asin((BEGIN + place) / LENGTH)


def hand(place: float) -> float:
    a = angle(place)
    return LOAD * math.sin(a) / (math.cos(a) - MU * math.sin(a))


class Jam(MotionTest):
    def figures(self, motion: Motion, name: str) -> dict:
        return motion.report["figures"][name]

    def test_is_no_nearer_than_where_it_jams(self) -> None:
        """Frictions that amplify each other a million times are found as well as others."""
        text = LADDER.replace("to: limit", f"from: {JAM - 1e-3} mm\n  to: {JAM - 1e-5} mm")
        motion = run(text, "--steps", "200")
        for place, found in zip(motion["in/drive"], motion["in/action"]):
            self.assertIsNotNone(found, place)
            expected = hand(place)
            self.assertLess(abs(abs(found) - expected), 1e-13 * expected * expected, place)


class Figures(Jam):
    def test_what_grows_towards_a_jam_is_unbounded(self) -> None:
        for steps in STEPS:
            motion = run(LADDER, "--steps", str(steps))
            with self.subTest(steps=steps):
                found = self.figures(motion, "in/action")
                self.assertIsNone(found["greatest"])
                self.assertIsNone(found["mean"])
                self.near(found["least"], hand(0.0))
                self.assertIsNone(self.figures(motion, "in/power")["greatest"])
                self.assertIsNone(self.figures(motion, "g.Ry/action")["least"])

    def test_what_comes_to_an_end_there_has_its_limit(self) -> None:
        a = angle(JAM)
        for steps in STEPS:
            motion = run(LADDER, "--steps", str(steps))
            with self.subTest(steps=steps):
                efficiency = self.figures(motion, "efficiency")
                self.assertEqual(efficiency["least"], 0.0)
                self.assertLess(abs(efficiency["least_at"] - JAM), 1e-9 * LENGTH)
                self.near(efficiency["greatest"], 1.0 - MU * math.tan(angle(0.0)))
                advantage = self.figures(motion, "out/mechanical_advantage")
                self.assertEqual(advantage["least"], 0.0)
                power = self.figures(motion, "out/power")
                self.near(power["least"], -LOAD * SPEED / 1000.0 * math.tan(a))

    def test_motion_beyond_it_comes_to_the_limit(self) -> None:
        for steps in STEPS:
            motion = run(LADDER, "--steps", str(steps))
            with self.subTest(steps=steps):
                self.assertIsNone(self.figures(motion, "g.vx/velocity")["least"])
                self.assertEqual(self.figures(motion, "out/ratio")["greatest"], 0.0)
                self.near(self.figures(motion, "p.wz/velocity")["least"], None)

    def near(self, found: float | None, expected: float | None) -> None:
        if expected is None:
            self.assertIsNone(found)
        else:
            self.assertIsNotNone(found)
            self.assertLess(abs(found - expected), 1e-6 * max(1.0, abs(expected)))


CRANK = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, ram]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0], friction: {tau: 0.02 N*m}}
  b: {type: revolute, bodies: [crank, rod], at: [-30, 0]}
  c: {type: revolute, bodies: [rod, ram], at: [120, 0]}
  d: {type: prismatic, bodies: [frame, ram], at: [120, 0], axis: x, friction: 0.1}
actuators: {in: {coupling: a}, out: {coupling: d}}
loads: {w: {body: ram, at: [120, 0], force: [0, -3]}}
cases: {run: {motion: {in: 1 rad/s}, action: {out: 1 N}, input: in, output: out}}
motion: {drive: in, to: 180, case: run, report: [action, mechanical_advantage]}
"""


class Quotients(MotionTest):
    def test_goes_through_infinity_between_steps(self) -> None:
        """The bearing of the crank takes 20 N mm, and the load of 1 N, less 0.3 N of the guide, drives
        with 0.7 N * 30 mm = 21 N mm where the crank stands across: the input needs nothing twice.
        """
        for steps in (3, 4, 5, 24, 72, 360):
            motion = run(CRANK, "--steps", str(steps))
            with self.subTest(steps=steps):
                event = next(one for one in motion.report["events"]
                             if one["kind"] == "friction_reversal")
                self.assertAlmostEqual(event["jumps"]["in/action"]["after"], 0.02, 9)
                action = motion.report["figures"]["in/action"]
                self.assertLess(action["least"], 20e-3 - 21e-3 + 1e-5)
                advantage = motion.report["figures"]["out/mechanical_advantage"]
                self.assertIsNone(advantage["greatest"])
                self.assertIsNone(advantage["mean"])

    def test_is_what_a_reversal_leaves_however_small_it_is(self) -> None:
        """At the dead centre the ram does nothing, and the bearing of the crank takes 1e-9 N m."""
        text = CRANK.replace("tau: 0.02 N*m", "tau: 1e-9 N*m")
        for steps in (5, 24, 361):
            motion = run(text, "--steps", str(steps))
            event = next(one for one in motion.report["events"]
                         if one["kind"] == "friction_reversal")
            found = event["jumps"]["in/action"]["after"]
            self.assertIsNotNone(found, steps)
            self.assertLess(abs(found - 1e-9), 1e-12, steps)


if __name__ == "__main__":
    motion_case.main()
