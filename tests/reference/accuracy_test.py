#!/usr/bin/env python3
"""Checks what analysis promises of its digits and its zeros against fractions.

Usage: accuracy_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import random
import sys
import unittest
from decimal import Decimal
from fractions import Fraction

import program

NINE_DIGITS = 1e-9


def solve(text: str, *arguments: str) -> dict:
    return program.run("analyze", *arguments, "-", text=text)


class AccuracyTest(unittest.TestCase):
    def close(self, actual: float, exact: Fraction, what: str, share: float = NINE_DIGITS) -> None:
        """Within a share of the exact value itself; where that is zero, zero."""
        error = abs(Fraction(actual) - exact)
        self.assertLessEqual(error, Fraction(share) * abs(exact),
                             f"{what}: {actual!r} is not {float(exact)!r}")


class DeadPoints(AccuracyTest):
    """A slider-crank in line along a direction, whose slider rests while its crank turns."""

    def text(self, angle: str) -> str:
        return f"""\
kinestat: 1
space: planar
units: {{length: mm, angle: deg}}
parameters: {{t: {angle}}}
ground: g
bodies: [crank, rod, ram]
couplings:
  a: {{type: revolute, bodies: [g, crank], at: [0, 0]}}
  b: {{type: revolute, bodies: [crank, rod], at: [40*cos(t), 40*sin(t)]}}
  c: {{type: revolute, bodies: [rod, ram], at: [160*cos(t), 160*sin(t)]}}
  d: {{type: prismatic, bodies: [g, ram], at: [0, 0], axis: [cos(t), sin(t)]}}
actuators: {{m: {{coupling: a}}, o: {{coupling: d}}}}
cases: {{c: {{motion: {{m: 10 rad/s}}, action: {{o: 900 N}}, input: m, output: o}}}}
"""

    def test_a_slider_in_a_dead_point_rests_by_doubles_and_as_typed(self) -> None:
        for angle in ("60 deg", "17 deg", "1 rad", "atan(3/7)"):
            for accuracy in ("fast", "auto", "exact"):
                with self.subTest(angle=angle, accuracy=accuracy):
                    case = solve(self.text(angle), "--accuracy", accuracy)["cases"]["c"]
                    self.assertEqual(case["kinematics"]["freedoms"]["d.v"], 0.0)
                    self.assertEqual(case["statics"]["actions"]["m"], 0.0)
                    self.assertEqual(case["statics"]["actions"]["d.Tz"], 0.0)
                    self.assertIsNone(case["ratio"])
                    bound = case["kinematics"]["evidence"].get("error_bound")
                    self.assertLess(bound or 0.0, 1e-9)


class NearDeadPoints(AccuracyTest):
    """A slider-crank a little above its dead point, drawn far above the axis of the world."""

    def text(self, x: list[Decimal], y: list[Decimal]) -> str:
        return f"""\
kinestat: 1
space: planar
ground: g
bodies: [k, r, s]
couplings:
  a: {{type: revolute, bodies: [g, k], at: [{x[0]}, {y[0]}]}}
  b: {{type: revolute, bodies: [k, r], at: [{x[1]}, {y[1]}]}}
  c: {{type: revolute, bodies: [r, s], at: [{x[2]}, {y[2]}]}}
  d: {{type: prismatic, bodies: [g, s], at: [{x[2]}, {y[2]}], axis: x}}
actuators: {{m: {{coupling: a}}, o: {{coupling: d}}}}
cases: {{c: {{motion: {{m: 1}}, action: {{o: -1}}, input: m, output: o}}}}
"""

    def check(self, x: list[Decimal], y: list[Decimal]) -> None:
        """The rod turns so that the slider does not rise; the torque follows from the powers."""
        (xa, xb, xc), (ya, yb, yc) = ([Fraction(p) for p in axis] for axis in (x, y))
        rod = -(xb - xa) / (xc - xb)
        slider = -(yb - ya) - rod * (yc - yb)
        case = solve(self.text(x, y))["cases"]["c"]
        freedoms = case["kinematics"]["freedoms"]
        self.close(freedoms["b.wz"], rod - 1, "rod on crank")
        self.close(freedoms["d.vx"], slider, "slider")
        self.close(case["statics"]["actions"]["m"], slider, "torque")
        if slider != 0:
            self.close(case["ratio"], 1 / slider, "ratio")
            self.close(case["torque_ratio"], -slider, "torque ratio")
        else:
            self.assertIsNone(case["ratio"])

    def test_what_cancels_has_nine_digits(self) -> None:
        draw = random.Random(13)
        for far in (0, 1, 3, 5, 7):
            for near in (0, 3, 6, 10):
                with self.subTest(far=far, near=near):
                    level = Decimal(10) ** far if far else Decimal(0)
                    above = Decimal(draw.randint(10000, 99999)).scaleb(-4 - near)
                    x = [Decimal(0), Decimal(1), Decimal(4)]
                    self.check(x, [level, level + above, level])

    def test_a_position_as_typed_is_told_from_a_dead_point_close_by(self) -> None:
        for text in ("1000", "1000.000000000001", "1000.00000000000001"):
            with self.subTest(height=text):
                x = [Decimal(0), Decimal(1), Decimal(4)]
                self.check(x, [Decimal(1000), Decimal(text), Decimal(1000)])


class BalancedLoads(AccuracyTest):
    """Loads that balance as typed, on what leaves their direction free."""

    def ring(self, loads: list[str]) -> str:
        lines = "\n".join(f"  l{i}: {{body: s, {load}}}" for i, load in enumerate(loads))
        return f"""\
kinestat: 1
space: planar
ground: g
bodies: [s]
couplings:
  r: {{type: revolute, bodies: [g, s], at: [0, 0]}}
loads:
{lines}
cases: {{c: {{action: {{}}}}}}
"""

    def expect_held(self, text: str, reactions: list[str]) -> None:
        for accuracy in ("fast", "auto", "high", "exact"):
            with self.subTest(accuracy=accuracy, text=text):
                statics = solve(text, "--accuracy", accuracy)["cases"]["c"]["statics"]
                self.assertEqual(statics["status"], "solved")
                for name in reactions:
                    self.assertEqual(statics["actions"][name], 0.0, name)

    def test_couples_in_tenths(self) -> None:
        self.expect_held(self.ring(["couple: 0.3", "couple: -0.1", "couple: -0.2"]),
                         ["r.Rx", "r.Ry"])

    def test_random_decimal_couples(self) -> None:
        draw = random.Random(6)
        for _ in range(10):
            couples = [Decimal(draw.randint(-99999, 99999)).scaleb(-draw.randint(1, 6))
                       for _ in range(7)]
            loads = [f"couple: {c}" for c in [*couples, -sum(couples)]]
            draw.shuffle(loads)
            self.expect_held(self.ring(loads), ["r.Rx", "r.Ry"])

    def test_forces_whose_moments_cancel(self) -> None:
        self.expect_held(self.ring(["at: [0.7, 0], force: [0, 0.1]",
                                    "at: [0.07, 0], force: [0, -1]",
                                    "at: [0, 0], force: [0, 0.9]"]), ["r.Rx", "r.Ry"])

    def test_three_forces_around_a_body_that_is_free_in_its_plane(self) -> None:
        forces = "\n".join(
            f"  l{i}: {{body: s, at: [3 + 2*cos({a} deg), 1 + 2*sin({a} deg)],"
            f" force: [100*cos({a} deg), 100*sin({a} deg)]}}" for i, a in enumerate((0, 120, 240)))
        self.expect_held(f"""\
kinestat: 1
space: planar
ground: g
bodies: [u, v, s]
couplings:
  x: {{type: prismatic, bodies: [g, u], at: [0, 0], axis: x}}
  y: {{type: prismatic, bodies: [u, v], at: [0, 0], axis: y}}
  r: {{type: revolute, bodies: [v, s], at: [0.3, 0.1]}}
loads:
{forces}
cases: {{c: {{action: {{}}}}}}
""", ["r.Rx", "r.Ry"])

    def test_what_is_left_as_typed_is_refused(self) -> None:
        for rest in ("0.2000000000001", "0.1999999999", "0.20001"):
            with self.subTest(rest=rest):
                done = program.call("analyze", "-", text=self.ring(
                    ["couple: 0.3", "couple: -0.1", f"couple: -{rest}"]))
                self.assertIn("E0602", done.stderr)
                self.assertEqual(done.returncode, 5)

    def test_exact_numbers_tell_what_is_left_from_rounding(self) -> None:
        text = self.ring(["couple: 0.3", "couple: -0.1", "couple: -0.20000000000000001"])
        done = program.call("analyze", "--accuracy", "exact", "-", text=text)
        self.assertIn("E0602", done.stderr)
        self.assertEqual(done.returncode, 5)


class FarAway(AccuracyTest):
    """Mechanisms whose place in the world has no part in the answer."""

    def four_bar(self, x: str, y: str) -> str:
        return f"""\
kinestat: 1
space: planar
ground: g
bodies: [k2, k3, k4]
parameters: {{ox: {x}, oy: {y}}}
couplings:
  a: {{type: revolute, bodies: [g, k2], at: [ox, oy]}}
  b: {{type: revolute, bodies: [k2, k3], at: [ox + 0.3, oy + 0.4]}}
  c: {{type: revolute, bodies: [k3, k4], at: [ox + 1.5, oy + 1]}}
  d: {{type: revolute, bodies: [g, k4], at: [ox + 1.6, oy + 0]}}
actuators: {{m: {{coupling: a}}, o: {{coupling: d}}}}
loads: {{W: {{body: k3, at: [ox+1, oy+1], force: [3, -40]}}}}
cases: {{c: {{motion: {{m: 1e-3}}, action: {{o: -5}}, input: m, output: o}}}}
"""

    def test_the_powers_of_a_four_bar_balance(self) -> None:
        """Velocities from the two circuits' equations, the power of the drive from the others."""
        wa, (xb, yb), (xc, yc), xd = Fraction(1, 1000), (Fraction(3, 10), Fraction(4, 10)), (
            Fraction(15, 10), Fraction(1)), Fraction(16, 10)
        # wa x b + w3 x (c - b) = w4 x (c - d)
        p, q, r, s = -(yc - yb), yc, xc - xb, -(xc - xd)
        right = (wa * yb, -wa * xb)
        w3 = (right[0] * s - q * right[1]) / (p * s - q * r)
        w4 = (p * right[1] - r * right[0]) / (p * s - q * r)
        at = (-wa * yb - w3 * (1 - yb), wa * xb + w3 * (1 - xb))
        load = 3 * at[0] - 40 * at[1]
        out = -5 * w4
        for x, y in (("0", "0"), ("1e4", "3e5"), ("1e7", "-1e7"), ("1e8", "-2e8"), ("-1e9", "1e9")):
            with self.subTest(x=x, y=y):
                power = solve(self.four_bar(x, y))["cases"]["c"]["power"]
                self.close(power["actuators"]["m"], -(out + load), "m")
                self.close(power["actuators"]["o"], out, "o")

    def planets(self, place: str, count: int) -> str:
        angles = [f"{360 * i // count} deg" for i in range(count)]
        lines = []
        for i, angle in enumerate(angles):
            def at(radius: str) -> str:
                return f"at: [o + {radius}*cos({angle}), -2*o + {radius}*sin({angle})]"
            line = f"line_of_action: [-sin({angle}), cos({angle})]"
            lines += [f"  P{i}: {{type: revolute, bodies: [carrier, p{i}], {at('21')}}}",
                      f"  s{i}: {{type: gear, bodies: [sun, p{i}], {at('12')}, {line}}}",
                      f"  r{i}: {{type: gear, bodies: [ring, p{i}], {at('30')}, {line},"
                      " internal: true}"]
        bodies = ", ".join(["sun", "ring", "carrier", *(f"p{i}" for i in range(count))])
        bearings = "\n".join(
            f"  {name}: {{type: revolute, bodies: [housing, {body}], at: [o, -2*o]}}"
            for name, body in (("S", "sun"), ("R", "ring"), ("C", "carrier")))
        couplings = "\n".join(lines)
        return f"""\
kinestat: 1
space: planar
units: {{length: mm}}
parameters: {{o: {place}}}
ground: housing
bodies: [{bodies}]
couplings:
{bearings}
{couplings}
actuators: {{Ts: {{coupling: S}}, Tr: {{coupling: R}}, Tc: {{coupling: C}}}}
cases: {{c: {{motion: {{Ts: 7 rad/s, Tr: 0}}, input: Ts, output: Tc}}}}
"""

    def test_planets_far_away_are_as_redundant_as_near(self) -> None:
        """Two inputs move 18 freedoms in ten circuits: 3*10 - (18 - 2) equations are redundant."""
        for place in ("0", "1e4", "6e8", "6e10"):
            with self.subTest(place=place):
                text = self.planets(place, 5)
                found = solve(text)
                for order in ("minimal", "planar"):
                    self.assertEqual(found["mobility"][order]["net_freedom"], 2)
                    self.assertEqual(found["mobility"][order]["net_constraint"], 14)
                self.close(found["cases"]["c"]["ratio"], Fraction(7, 2), "ratio")
                counted = program.run("mobility", "-", text=text)
                self.assertEqual(counted["mobility"]["counts"]["planar"]["net_freedom"], 2)
                self.assertEqual(len(counted["mobility"]["motions"]), 2)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
