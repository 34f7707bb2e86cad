#!/usr/bin/env python3
"""Checks ropes of the section `cables` against the pulleys of davies.json, which have RR chains.

Usage: cable_test.py PROGRAM [unittest arguments]

Alves 2023, section 3.4: bodies 1 and 3 are the blocks, 2 the pulley, 4 the virtual link; 5 and 6,
the chains, are the segments rope_1 and rope_2.
"""

from __future__ import annotations

import math
import sys
import unittest

import program
from reference_case import CASES, ReferenceCase, number
from reference_test_case import ReferenceTest

PULLEYS = ("alves_davies_maxima_1_2_10", "alves_davies_matroid_3_6_10", "alves_davies_slanted")


def place(model: ReferenceCase, coupling: str) -> tuple[float, float]:
    x, y = (number(c) for c in model.couplings[coupling]["point"][:2])
    return x, y


def at(model: ReferenceCase, coupling: str) -> str:
    return "[{}, {}]".format(*place(model, coupling))


def contact(model: ReferenceCase, by_points: bool) -> str:
    """Where the cable touches: computed where it hangs, else the points of the reference."""
    if by_points:
        return f"points: [{at(model, 'c2')}, {at(model, 'd2')}]"
    return f"radius: {place(model, 'e')[0]}, wrap: clockwise"


def text(model: ReferenceCase, by_points: bool, slip: bool = True) -> str:
    cases = []
    for i, case in enumerate(model.expected["kinematics"] if slip else []):
        primary = case["primary"]
        cases.append(f"  k{i}: {{motion: {{Va: {primary['a.v']}, Te: {primary['e.w']}}}}}")
    for i, case in enumerate(model.expected["statics"] if slip else []):
        primary = case["primary"]
        cases.append(f"  s{i}: {{action: {{Va: {primary['a.Va']}, Te: {primary['e.Te']}}}}}")
    if not slip:
        cases.append("  k0: {motion: {Va: 1}}")
    return f"""\
kinestat: 1
space: planar
ground: frame
bodies: [block1, pulley, block3]
couplings:
  a: {{type: prismatic, bodies: [frame, block1], at: {at(model, 'a')}, axis: y}}
  b: {{type: prismatic, bodies: [frame, block3], at: {at(model, 'b')}, axis: y}}
  e: {{type: revolute, bodies: [frame, pulley], at: {at(model, 'e')}}}
cables:
  rope:
    over:
      - {{body: block1, at: {at(model, 'c1')}}}
      - {{pulley: pulley, {contact(model, by_points)}, slip: {str(slip).lower()}}}
      - {{body: block3, at: {at(model, 'd1')}}}
actuators: {{Va: {{coupling: a}}, Vb: {{coupling: b}}, Te: {{coupling: e}}\
{', Tf: {coupling: rope_pulley}' if slip else ''}}}
cases:
""" + "\n".join(cases) + "\n"


class Cables(ReferenceTest):
    VARIANTS = [(ReferenceCase(CASES[name]), by_points) for name in PULLEYS
                for by_points in (True, False) if by_points or name != "alves_davies_slanted"]

    def test_motions(self) -> None:
        names = {"a.v": "a.vy", "b.v": "b.vy", "e.w": "e.wz", "f.w": "rope_pulley.wz"}
        for model, by_points in self.VARIANTS:
            with self.subTest(model.id, by_points=by_points):
                report = program.run("analyze", "-", text=text(model, by_points))
                self.assertEqual(report["mobility"]["planar"]["net_freedom"],
                                 model.expected["counts"]["FN_kin"])
                self.assertEqual(report["mobility"]["planar"]["net_constraint"], 0)
                for i, case in enumerate(model.expected["kinematics"]):
                    kinematics = report["cases"][f"k{i}"]["kinematics"]
                    solution = {key: entry["x"] for key, entry in case["solution"].items()}
                    rates = kinematics["freedoms"]
                    self.near_each({key: rates[name] for key, name in names.items()},
                                   {key: solution[key] for key in names})
                    turn = number(case["body_twist"]["4"][2])
                    body = kinematics["bodies"]["rope_pulley"]
                    self.near(body["angular"][-1], turn, "virtual link")
                    # A chain turns by w_c1 + w_b = w_c1, as the blocks do not turn.
                    for segment, joints in (("rope_1", "c"), ("rope_2", "d")):
                        end = 1 if segment == "rope_1" else 2
                        self.near(abs(rates[f"{segment}.w{end}"]), abs(solution[f"{joints}1.w"]),
                                  f"{segment} {end}")

    def test_actions(self) -> None:
        actuators = (("a.Va", "Va"), ("b.Vb", "Vb"), ("e.Te", "Te"), ("f.Tf", "Tf"))
        same = ("a.Rx", "a.Tz", "b.Rx", "b.Tz", "e.Rx", "e.Ry")
        for model, by_points in self.VARIANTS:
            with self.subTest(model.id, by_points=by_points):
                report = program.run("analyze", "-", text=text(model, by_points))
                for i, case in enumerate(model.expected["statics"]):
                    actions = report["cases"][f"s{i}"]["statics"]["actions"]
                    solution = {key: entry["x"] for key, entry in case["solution"].items()}
                    expected = {key: solution[key] for key in same}
                    actual = {key: actions[key] for key in same}
                    for key, name in actuators:
                        expected[key], actual[key] = solution[key], actions[name]
                    for key in ("Rx", "Ry"):
                        expected[f"f.{key}"] = solution[f"f.{key}"]
                        actual[f"f.{key}"] = actions[f"rope_pulley.{key}"]
                    # The chain of the block bears along itself; a tension pulls the block upwards.
                    for rope, lower, upper in (("rope_1", "c1", "c2"), ("rope_2", "d1", "d2")):
                        ends = [place(model, lower), place(model, upper)]
                        along = [b - a for a, b in zip(*ends)]
                        size = sum(x * x for x in along) ** 0.5
                        expected[rope] = -sum(
                            solution[f"{lower}.R{k}"] * x / size for k, x in zip("xy", along))
                        actual[rope] = actions[f"{rope}.F"]
                    self.near_each(actual, expected)

    def test_without_slip(self) -> None:
        """w_e = -v_a/r where the cables hang; Eqs. 4.3 and 4.4 print the other sign."""
        for model, by_points in self.VARIANTS:
            with self.subTest(model.id, by_points=by_points):
                if model.id != "alves_davies_slanted":
                    report = program.run("analyze", "-", text=text(model, by_points, slip=False))
                    rates = report["cases"]["k0"]["kinematics"]["freedoms"]
                    self.assertEqual(report["mobility"]["planar"]["net_freedom"], 1)
                    self.near(rates["e.wz"], -1.0 / place(model, "e")[0], "w_e")
                    self.near(rates["b.vy"], -1.0, "v_b")

    def test_rates_on_pulleys_of_any_size(self) -> None:
        """w_f = -w_e - v_a/r where it slips, w_e = -v_a/r where it does not; Alves, Eq. 4.1."""
        for radius in (0.25, 1.0, 3.0, 7.5):
            for speed, turn in ((1.0, 0.0), (-2.0, 0.7), (0.0, -1.3), (0.3, 5.0)):
                with self.subTest(radius=radius, speed=speed, turn=turn):
                    case = f"one: {{motion: {{Va: {speed}, Te: {turn}}}}}"
                    slips = program.run("analyze", "-", text=pulley(radius, True, case))
                    rates = slips["cases"]["one"]["kinematics"]["freedoms"]
                    self.assertEqual(slips["mobility"]["planar"]["net_freedom"], 2)
                    self.near(rates["rope_wheel.wz"], -turn - speed / radius, "w_f", 8.0)
                    self.near(rates["b.vy"], -speed, "v_b")
                    case = f"one: {{motion: {{Va: {speed}}}}}"
                    sticks = program.run("analyze", "-", text=pulley(radius, False, case))
                    rates = sticks["cases"]["one"]["kinematics"]["freedoms"]
                    self.assertEqual(sticks["mobility"]["planar"]["net_freedom"], 1)
                    self.near(rates["e.wz"], -speed / radius, "w_e", 8.0)


def pulley(radius: float, slip: bool, case: str, mu: float = 0.0) -> str:
    return f"""\
kinestat: 1
space: planar
ground: frame
bodies: [left, wheel, right]
couplings:
  a: {{type: prismatic, bodies: [frame, left], at: [0, 0], axis: y}}
  b: {{type: prismatic, bodies: [frame, right], at: [{2 * radius}, 0], axis: y}}
  e: {{type: revolute, bodies: [frame, wheel], at: [{radius}, 20]}}
cables:
  rope:
    over:
      - {{body: left, at: [0, 0]}}
      - {{pulley: wheel, radius: {radius}, wrap: clockwise, slip: {str(slip).lower()},
         friction: {mu}}}
      - {{body: right, at: [{2 * radius}, 0]}}
actuators: {{Va: {{coupling: a}}, Vb: {{coupling: b}}, Te: {{coupling: e}}}}
cases:
  {case}
"""


class Slip(ReferenceTest):
    """A cable drawn over a driven pulley: T_high/T_low = exp(mu pi) in the sense of the slip."""

    def test_power(self) -> None:
        mu, radius, pull = 0.25, 1.5, 40.0
        high = math.exp(mu * math.pi)
        # The cable runs on over the pulley at the speed v + w r, v up its first segment.
        for speed, turn in ((2.0, 0.0), (-2.0, 0.0), (1.0, 3.0), (1.0, -3.0)):
            with self.subTest(speed=speed, turn=turn):
                case = f"one: {{motion: {{Va: {speed}, Te: {turn}}}, action: {{Va: -{pull}}}}}"
                report = program.run("analyze", "-", text=pulley(radius, True, case, mu))
                one = report["cases"]["one"]
                contact = one["statics"]["contacts"]["rope_wheel"]
                slip = speed + turn * radius
                after = pull * (high if slip > 0 else 1 / high)
                self.near(contact["slip_speed"], slip, "slip", 8.0)
                self.near(contact["before"], pull, "T_1", pull)
                self.near(contact["after"], after, "T_2", pull)
                self.near(contact["ratio"], high, "ratio", high)
                self.near(contact["limit"], high, "limit", high)
                self.near(contact["slip_power"], (pull - after) * slip, "power", 400.0)
                self.assertLess(contact["slip_power"], 0.0)
                # The pulley bears the difference, and the power is that of Va, Te and Vb.
                actions = one["statics"]["actions"]
                self.near(actions["Te"], (after - pull) * radius, "torque", 100.0)
                given = actions["Va"] * speed + actions["Te"] * turn + actions["Vb"] * -speed
                self.near(given, -contact["slip_power"], "given", 400.0)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
