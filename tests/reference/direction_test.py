#!/usr/bin/env python3
"""Directions whose components are lengths, such as differences of points, against closed forms.

Usage: direction_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest

import program
from dynamics_case import DynamicsCase

# A weight on a guide from a pin to the end of a lever that stands at the angle A.
GUIDE = """kinestat: 1
space: planar
UNITSparameters: {lp: 0.5 m, A: 40 deg}
ground: frame
bodies: [block]
couplings:
  guide: {type: prismatic, bodies: [frame, block], at: [0, 0], axis: AXIS}
actuators: {ram: {coupling: guide}}
loads: {weight: {body: block, at: [0, 0], force: [0, -10]}}
cases: {held: {motion: {ram: 0}, action: {}}}
"""
AXIS = "[lp*cos(A) - 0.6 m, lp*sin(A) + 0.8 m]"


def guide(axis: str = AXIS, units: str = "") -> str:
    return GUIDE.replace("AXIS", axis).replace("UNITS", units)


class DirectionTest(DynamicsCase):
    def messages(self, axis: str) -> str:
        done = program.plain("analyze", "-", text=guide(axis))
        self.assertEqual(done.returncode, 3, done.stderr)
        return done.stderr

    def test_difference_of_two_points(self) -> None:
        for units in ("", "units: {length: mm}\n"):
            action = program.run("analyze", "-", text=guide(units=units))
            force = action["cases"]["held"]["statics"]["actions"]["ram"]
            x = 0.5 * math.cos(math.radians(40)) - 0.6
            y = 0.5 * math.sin(math.radians(40)) + 0.8
            self.near(force, 10 * y / math.hypot(x, y), 10, units)

    def test_derivatives_are_those_of_the_unit_vector(self) -> None:
        """F = 10 sin b, b being the angle of the guide: dF = 10 cos b db."""
        found = program.run("sensitivity", "-", "--of", "ram", text=guide())
        by = found["cases"]["held"]["sensitivity"]["ram"]["by"]
        angle, lever = math.radians(40), 0.5
        x = lever * math.cos(angle) - 0.6
        y = lever * math.sin(angle) + 0.8
        square = x * x + y * y
        slope = 10 * x / math.sqrt(square)
        turn_by_lever = (x * math.sin(angle) - y * math.cos(angle)) / square
        turn_by_angle = lever * (x * math.cos(angle) + y * math.sin(angle)) / square
        self.near(by["lp"]["derivative"], slope * turn_by_lever, 20, "by lp")
        self.near(by["A"]["derivative"], slope * turn_by_angle, 20, "by A")

    def test_zero_needs_no_unit(self) -> None:
        for axis, expected in (("[0, 3 mm]", 10.0), ("[lp, 0]", 0.0), ("[3 N, 4 N]", 8.0),
                               ("[30 mm, 4 cm]", 8.0), ("[3, 4]", 8.0)):
            text = guide(axis).replace("lp: 0.5 m, A: 40 deg", "lp: 0.5 m").replace(
                "{lp: 0.5 m}", "{lp: 0.5 m}" if "lp" in axis else "{}")
            report = program.run("analyze", "-", text=text)
            self.near(report["cases"]["held"]["statics"]["actions"]["ram"], expected, 10, axis)

    def test_mixed_components_have_no_direction(self) -> None:
        for axis, first, second in (("[1, 3 mm]", "a bare number", "a length"),
                                    ("[lp, A]", "a length", "an angle"),
                                    ("[2 N, lp]", "a force", "a length")):
            found = self.messages(axis)
            self.assertIn(f"a direction of {first} and {second} has no meaning", found)
            self.assertIn("E0309", found)

    def test_no_length_in_metres_is_no_direction(self) -> None:
        self.assertIn("E0314", self.messages("[lp - 500 mm, 0]"))


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
