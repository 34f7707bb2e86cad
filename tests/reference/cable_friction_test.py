#!/usr/bin/env python3
"""Checks belts and capstans against the closed forms of Euler and Eytelwein.

Usage: cable_friction_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest

import program
from reference_case import TABLES
from reference_test_case import ReferenceTest


class Belts(ReferenceTest):
    """Two pulleys with a belt, open or crossed."""

    def text(self, radii: tuple[float, float], distance: float, crossed: bool, case: str,
             slip: bool = False, mu: float = 0.3) -> str:
        other = "counterclockwise" if crossed else "clockwise"
        return f"""\
kinestat: 1
space: planar
ground: frame
bodies: [driver, driven]
couplings:
  A: {{type: revolute, bodies: [frame, driver], at: [0, 0]}}
  B: {{type: revolute, bodies: [frame, driven], at: [{distance}, 0]}}
cables:
  belt:
    closed: true
    over:
      - {{pulley: driver, radius: {radii[0]}, wrap: clockwise, friction: {mu},
         slip: {str(slip).lower()}}}
      - {{pulley: driven, radius: {radii[1]}, wrap: {other}}}
actuators: {{in: {{coupling: A}}, out: {{coupling: B}}}}
cases:
  {case}
"""

    def test_angles_ratios_and_tensions(self) -> None:
        for radii, distance in (((1.0, 1.0), 5.0), ((1.0, 2.0), 7.0), ((3.0, 0.5), 4.0)):
            for crossed in (False, True):
                with self.subTest(radii=radii, crossed=crossed):
                    # Clockwise, the driver draws in belt_2, which arrives, and lets out belt_1.
                    case = "one: {motion: {in: -2}, action: {in: -6, belt_1.F: 5}}"
                    text = self.text(radii, distance, crossed, case)
                    one = program.run("analyze", "-", text=text)["cases"]["one"]
                    small, large = radii
                    if crossed:
                        angle = math.pi + 2 * math.asin((small + large) / distance)
                        angles = (angle, angle)
                    else:
                        lean = 2 * math.asin((large - small) / distance)
                        angles = (math.pi - lean, math.pi + lean)
                    sense = -1 if crossed else 1
                    rates = one["kinematics"]["freedoms"]
                    self.near(rates["B.wz"], -2 * sense * radii[0] / radii[1], "rate", 12.0)
                    actions = one["statics"]["actions"]
                    tight = 5 + 6 / radii[0]
                    self.near(actions["belt_2.F"], tight, "tight", tight)
                    self.near(actions["out"], sense * 6 * radii[1] / radii[0], "out", 12.0)
                    contacts = one["statics"]["contacts"]
                    for name, angle in zip(("belt_driver", "belt_driven"), angles):
                        self.near(contacts[name]["wrap"], angle, f"wrap of {name}", angle)
                    driver = contacts["belt_driver"]
                    limit = math.exp(0.3 * angles[0])
                    self.near(driver["limit"], limit, "limit", limit)
                    self.near(driver["ratio"], tight / 5, "ratio", tight)
                    self.assertEqual(
                        driver["belt_state"], "sticking" if tight / 5 <= limit else "beyond the limit")

    def test_that_slips(self) -> None:
        """Tight = slack exp(mu theta), and the slip takes (tight - slack) times its speed."""
        radii, distance, mu = (1.0, 2.0), 7.0, 0.3
        ratio = math.exp(mu * (math.pi - 2 * math.asin(1 / distance)))
        case = "one: {motion: {in: -2, out: -0.9}, action: {belt_1.F: 5}, input: in, output: out}"
        one = program.run(
            "analyze", "-", text=self.text(radii, distance, False, case, slip=True, mu=mu))
        one = one["cases"]["one"]
        contact = one["statics"]["contacts"]["belt_driver"]
        actions = one["statics"]["actions"]
        # The belt runs at 1.8, the rim of the driver at 2: the belt falls back.
        self.near(contact["slip_speed"], -0.2, "slip")
        self.near(contact["before"], 5 * ratio, "tight", 10.0)
        self.near(contact["after"], 5.0, "slack", 5.0)
        self.near(contact["slip_power"], -0.2 * 5 * (ratio - 1), "slip power", 1.0)
        self.near(actions["in"], -5 * (ratio - 1), "in", 10.0)
        self.near(actions["out"], 10 * (ratio - 1), "out", 20.0)
        self.near(one["power"]["efficiency"]["friction"], 0.9, "efficiency")


class Capstans(ReferenceTest):
    """exp(mu theta) against the table of davies.json, the cable being pulled either way."""

    # Where the cable comes from and goes to, the axes of its ends, and full turns beside the arc.
    ROUTES = {"pi": ("[-1, -9]", "y", "[1, -9]", "y", 0),
              "pi/2": ("[-1, -9]", "y", "[9, 1]", "x", 0),
              "2 pi": ("[-9, 1]", "x", "[9, 1]", "x", 1),
              "6 pi": ("[-9, 1]", "x", "[9, 1]", "x", 3)}

    def test_ratios(self) -> None:
        self.assertEqual(len(TABLES["capstan"]), 4)
        for row in TABLES["capstan"]:
            start, first, end, last, turns = self.ROUTES[row["theta_expr"]]
            text = f"""\
kinestat: 1
space: planar
ground: frame
bodies: [first, last]
couplings:
  a: {{type: prismatic, bodies: [frame, first], at: {start}, axis: {first}}}
  b: {{type: prismatic, bodies: [frame, last], at: {end}, axis: {last}}}
cables:
  rope:
    over:
      - {{body: first, at: {start}}}
      - {{pulley: frame, at: [0, 0], radius: 1, wrap: clockwise, slip: true, turns: {turns},
         friction: {row['mu']}}}
      - {{body: last, at: {end}}}
cases:
  onwards: {{motion: {{rope_frame.wz: -2}}, action: {{rope_1.F: 1}}}}
  back: {{motion: {{rope_frame.wz: 2}}, action: {{rope_1.F: 1}}}}
actuators: {{A: {{coupling: a}}, B: {{coupling: b}}}}
"""
            with self.subTest(row["theta_expr"]):
                cases = program.run("analyze", "-", text=text)["cases"]
                for label, ratio in (("onwards", row["ratio"]), ("back", 1 / row["ratio"])):
                    statics = cases[label]["statics"]
                    contact = statics["contacts"]["rope_frame"]
                    self.near(contact["wrap"], row["theta"], "theta", row["theta"])
                    self.near(contact["limit"], row["ratio"], "limit", row["ratio"])
                    self.near(statics["actions"]["rope_2.F"], ratio, "T_2", ratio)
                    self.near(contact["ratio"], row["ratio"], "ratio", row["ratio"])
                    self.assertEqual(contact["belt_state"], "slipping")
                    # Clockwise is the order of the rope: onwards at the speed 2.
                    speed = 2.0 if label == "onwards" else -2.0
                    self.near(contact["slip_speed"], speed, "slip")
                    power = (1 - ratio) * speed
                    self.near(contact["slip_power"], power, "power", abs(power))
                    self.assertLess(contact["slip_power"], 0.0)


    def wound(self, mu: float, turns: int) -> str:
        """A load on a cable that is wound round a fixed drum; half a turn more than so many."""
        return f"""\
kinestat: 1
space: planar
units: {{length: mm}}
ground: frame
bodies: [load, hand]
couplings:
  L: {{type: prismatic, bodies: [frame, load], at: [0, 0], axis: y}}
  H: {{type: prismatic, bodies: [frame, hand], at: [200, 0], axis: y}}
cables:
  rope:
    over:
      - {{body: load, at: [0, 0]}}
      - {{pulley: frame, at: [100, 900], radius: 100, wrap: clockwise, slip: true,
         turns: {turns}, friction: {mu}}}
      - {{body: hand, at: [200, 0]}}
actuators: {{load: {{coupling: L}}, hand: {{coupling: H}}}}
cases:
  holding: {{motion: {{load: -50 mm/s}}, action: {{load: -1000 N}}, input: load, output: hand}}
  pulling: {{motion: {{load: 50 mm/s}}, action: {{load: -1 N}}, input: hand, output: load}}
  held: {{motion: {{load: -50 mm/s}}, action: {{hand: -1 N}}, input: load, output: hand}}
"""

    def test_tensions_keep_their_digits_however_far_the_rope_is_wound(self) -> None:
        for mu, turns in ((0.25, 1), (0.25, 9), (0.25, 14), (0.25, 20), (2.0, 2), (0.25, 100)):
            gain = math.exp(mu * (2 * turns + 1) * math.pi)
            with self.subTest(mu=mu, turns=turns):
                cases = program.run("analyze", "-", text=self.wound(mu, turns))["cases"]
                for label, load, hand in (("holding", -1000.0, -1000 / gain),
                                          ("pulling", -1.0, -gain), ("held", -gain, -1.0)):
                    case = cases[label]
                    self.assertEqual(case["statics"]["status"], "solved")
                    actions = case["statics"]["actions"]
                    # The exponent is rounded, and with it the ratio.
                    self.assertLess(abs(actions["hand"] / hand - 1), 1e-12)
                    self.assertLess(abs(actions["load"] / load - 1), 1e-12)
                    contact = case["statics"]["contacts"]["rope_frame"]
                    self.assertLess(abs(contact["ratio"] / gain - 1), 1e-12)
                    self.assertEqual(contact["belt_state"], "slipping")
                    friction = case["power"]["efficiency"]["friction"]
                    self.assertLess(abs(friction * gain - 1), 1e-12)

    def test_a_lever_holds_a_load_over_two_drums(self) -> None:
        """It has an arm of 100 mm, and no cable touches it."""
        for turns in (1, 9, 20, 60):
            text = f"""\
kinestat: 1
space: planar
units: {{length: mm}}
ground: frame
bodies: [load, hand, lever]
couplings:
  L: {{type: prismatic, bodies: [frame, load], at: [0, 0], axis: y}}
  H: {{type: prismatic, bodies: [frame, hand], at: [800, 0], axis: y}}
  pivot: {{type: revolute, bodies: [frame, lever], at: [1000, 0]}}
  pin: {{type: pin_in_slot, bodies: [hand, lever], at: [900, 0], slot: x}}
cables:
  rope:
    over:
      - {{body: load, at: [0, 0]}}
      - {{pulley: frame, at: [100, 900], radius: 100, wrap: clockwise, slip: true,
         turns: {turns}, friction: 0.25}}
      - {{pulley: frame, at: [700, 900], radius: 100, wrap: clockwise, slip: true,
         turns: {turns}, friction: 0.25}}
      - {{body: hand, at: [800, 0]}}
actuators: {{load: {{coupling: L}}, lever: {{coupling: pivot}}}}
cases:
  held: {{motion: {{load: -50 mm/s}}, action: {{lever: 0.1 N*m}}}}
"""
            with self.subTest(turns=turns):
                statics = program.run("analyze", "-", text=text)["cases"]["held"]["statics"]
                self.assertEqual(statics["status"], "solved")
                # Two quarters of a turn beside the full ones.
                gain = math.exp(0.25 * (4 * turns + 1) * math.pi)
                self.assertLess(abs(statics["actions"]["load"] / -gain - 1), 1e-12)
                self.assertLess(abs(statics["actions"]["rope_3.F"] - 1), 1e-12)

    def test_ratios_that_no_number_holds_are_refused(self) -> None:
        """exp(0.25 · 1001 pi) is above 1e308."""
        done = program.call("analyze", "-", text=self.wound(0.25, 500))
        self.assertNotIn("E0155", done.stderr)
        self.assertIn("error[E0316]", done.stderr)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
