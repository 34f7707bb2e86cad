#!/usr/bin/env python3
"""Derivatives and affine forms at corners and jumps, against the closed form m = F x of a lever.

At a corner the slopes of both sides differ, at a jump one is infinite: there is no derivative, and
the report says so. With respect to a parameter that does not cross the corner there is one.

Usage: kink_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import sys
import unittest

import program

FORCE = 10.0


def lever(length: str, parameters: str = "p: 3, q: 3, r: 5") -> str:
    return f"""\
kinestat: 1
space: planar
units: {{length: mm}}
ground: g
bodies: [crank]
parameters: {{{parameters}, rest: 1}}
couplings:
  a: {{type: revolute, bodies: [g, crank], at: [0, 0]}}
actuators: {{m: {{coupling: a}}}}
loads: {{f: {{body: crank, at: ["rest*({length})", "p*q*0"], force: [0, -{FORCE}]}}}}
cases: {{c: {{action: {{}}}}}}
"""


def spatial_lever(length: str) -> str:
    return f"""\
kinestat: 1
ground: g
bodies: [crank]
units: {{length: mm}}
parameters: {{p: 3, q: 3, r: 5}}
couplings:
  a: {{type: revolute, bodies: [g, crank], at: [1, 2, 0], axis: z}}
actuators: {{m: {{coupling: a}}}}
loads: {{f: {{body: crank, at: ["{length}", "r", 4], force: [20, -{FORCE}, 0]}}}}
cases: {{c: {{action: {{}}}}}}
"""


def derivatives(text: str, value: str = "m") -> dict[str, float | None]:
    by = program.run("sensitivity", "--of", value, "-", text=text)["cases"]["c"]["sensitivity"]
    return {name: entry["derivative"] for name, entry in by[value]["by"].items()}


class Kinks(unittest.TestCase):
    def expect(self, length: str, p: float | None, q: float | None = 0.0, *,
               parameters: str = "p: 3, q: 3, r: 5", value: float | None = None) -> None:
        """p and q: d length / dp and dq; `value` of the length, by which `rest` moves m."""
        with self.subTest(length):
            found = derivatives(lever(length, parameters))
            for name, expected in (("p", p), ("q", q)):
                if expected is None:
                    self.assertIsNone(found[name])
                else:
                    self.assertAlmostEqual(found[name], FORCE / 1000 * expected, 15)
            if value is not None:
                self.assertAlmostEqual(found["rest"], FORCE / 1000 * value, 15)

    def test_a_corner_has_no_derivative(self) -> None:
        self.expect("max(p, q)", None, None, value=3)
        self.expect("min(p, q) + r", None, None, value=8)
        self.expect("abs(p - q) + 2*q", None, None, value=6)
        self.expect("abs(p - 3) + 2*q", None, 2, value=6)
        self.expect("hypot(p - 3, q - 3) + r", None, None, value=5)
        self.expect("max(p, 3, 2) + q", None, 1, value=6)

    def test_a_jump_has_no_derivative(self) -> None:
        self.expect("floor(p) + q", None, 1, value=6)
        self.expect("ceil(p) + q", None, 1, value=6)
        self.expect("round(p + 0.5) + q", None, 1, value=7)
        self.expect("mod(p, 1.5) + q", None, 1, value=3)
        self.expect("gcd(p, 6) + q", None, 1, value=6)

    def test_between_corners_and_jumps_there_is_one(self) -> None:
        self.expect("max(p, q - 1)", 1, 0)
        self.expect("floor(p + 0.5) + p", 1)
        self.expect("mod(p, 2) + q", 1, 1)
        self.expect("mod(20, p) + q", -6, 1)
        self.expect("hypot(p, q + 1)", 0.6, 0.8)

    def test_both_sides_that_move_alike_are_no_corner(self) -> None:
        self.expect("max(p + r, q + r)", None, None)
        found = derivatives(lever("max(p + r, q + r)"))
        self.assertAlmostEqual(found["r"], FORCE / 1000, 15)

    def test_rounding_does_not_decide_the_side(self) -> None:
        self.expect("1 + max(p + 0.2, 0.3)", None, parameters="p: 0.1, q: 3, r: 5")
        self.expect("floor(p*3)", None, parameters="p: 0.1*10, q: 3, r: 5")

    def test_a_coordinate_that_no_force_feels_does_not_matter(self) -> None:
        """m = -F_x (y - 2) + F_y (x - 1): x has a corner towards p alone; F_z is zero."""
        found = derivatives(spatial_lever("abs(p - 3) + q"))
        self.assertIsNone(found["p"])
        self.assertAlmostEqual(found["q"], FORCE / 1000, 14)
        self.assertAlmostEqual(found["r"], 20 / 1000, 14)

    def test_an_actuator_at_rest_does_not_blank_the_power_of_another(self) -> None:
        """The input is Σ max(P_i, 0): P_a = w T, and the brake b stands still whatever w and T."""
        text = """\
kinestat: 1
space: planar
ground: g
bodies: [one, two]
parameters: {w: 2, T: 3, U: 4}
couplings:
  a: {type: revolute, bodies: [g, one], at: [0, 0]}
  b: {type: revolute, bodies: [g, two], at: [1, 0]}
actuators: {drive: {coupling: a}, brake: {coupling: b}}
loads: {one: {body: one, couple: -T}, two: {body: two, couple: -U}}
cases: {c: {motion: {drive: w, brake: 0}, action: {}}}
"""
        found = derivatives(text, "power/input")
        self.assertAlmostEqual(found["w"], 3, 14)
        self.assertAlmostEqual(found["T"], 2, 14)
        self.assertEqual(found["U"], 0.0)
        moving = derivatives(text.replace("brake: 0}", "brake: 0*1 + w - 2}"), "power/input")
        self.assertIsNone(moving["w"])
        self.assertAlmostEqual(moving["T"], 2, 14)


class Affine(unittest.TestCase):
    def affine(self, length: str, value: str) -> dict | None:
        text = lever(length, f"p: 0, q: 0, q1: {{free: {value}}}")
        return program.run("analyze", "-", text=text)["cases"]["c"]["affine"]["m"]

    def test_a_staircase_or_a_wave_is_not_affine(self) -> None:
        for length, value in (("floor(q1)", "10.5"), ("round(q1)", "10"), ("ceil(q1)", "0.25"),
                              ("q1 + 3*sin(q1*36 deg)", "10"), ("q1 + mod(q1, 0.01)", "10"),
                              ("max(q1, 10)", "10"), ("abs(q1)", "0"), ("q1 + floor(100*q1)", "2")):
            with self.subTest(length):
                self.assertIsNone(self.affine(length, value))

    def test_a_sum_is(self) -> None:
        found = self.affine("3*q1 + 2", "10.5")
        self.assertAlmostEqual(found["q1"], 3 * FORCE / 1000, 15)
        self.assertAlmostEqual(found["1"], 2 * FORCE / 1000, 15)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
