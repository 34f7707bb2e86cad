#!/usr/bin/env python3
"""Holds ropes of the section `cables` against the pulleys of davies.json, which have RR chains.

Usage: cable_test.py PROGRAM [unittest arguments]

Alves 2023, section 3.4: bodies 1 and 3 are the blocks, 2 the pulley, 4 the virtual link; 5 and 6,
the chains, are the segments rope_1 and rope_2.
"""

from __future__ import annotations

import sys
import unittest
from fractions import Fraction

import program
from reference_case import CASES, TABLES, ReferenceCase, number
from reference_test_case import ReferenceTest

PULLEYS = ("alves_davies_maxima_1_2_10", "alves_davies_matroid_3_6_10", "alves_davies_slanted")


def place(model: ReferenceCase, coupling: str) -> tuple[float, float]:
    x, y = (number(c) for c in model.couplings[coupling]["point"][:2])
    return x, y


def at(model: ReferenceCase, coupling: str) -> str:
    return "[{}, {}]".format(*place(model, coupling))


def contact(model: ReferenceCase, by_points: bool) -> str:
    """Where the rope touches: computed where it hangs, else the points of the reference."""
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


class Ropes(ReferenceTest):
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
        """w_e = -v_a/r where the ropes hang; Eqs. 4.3 and 4.4 print the other sign."""
        for model, by_points in self.VARIANTS:
            with self.subTest(model.id, by_points=by_points):
                if model.id != "alves_davies_slanted":
                    report = program.run("analyze", "-", text=text(model, by_points, slip=False))
                    rates = report["cases"]["k0"]["kinematics"]["freedoms"]
                    self.assertEqual(report["mobility"]["planar"]["net_freedom"], 1)
                    self.near(rates["e.wz"], -1.0 / place(model, "e")[0], "w_e")
                    self.near(rates["b.vy"], -1.0, "v_b")


def tackle(falls: int, eta: float) -> str:
    """Sheaves in turn above and below, a fall beside each; an odd number hangs at the block."""
    couplings, stations, bodies = [], [], []
    for i in range(1, falls + 1):
        above = i % 2 == 1
        owner, y = ("beam", 500) if above else ("block", 0)
        bodies.append(f"s{i}")
        couplings.append(
            f"  B{i}: {{type: revolute, bodies: [{owner}, s{i}], at: [{100 * i}, {y}]}}")
        stations.append(f"      - {{pulley: s{i}, radius: 50, eta: {eta}, "
                        f"wrap: {'' if above else 'counter'}clockwise}}")
    end = ("block", 0) if falls % 2 else ("beam", 500)
    stations.append(f"      - {{body: {end[0]}, at: [{100 * falls + 50}, {end[1]}]}}")
    lines = ["kinestat: 1", "space: planar", "units: {length: mm}", "ground: beam",
             f"bodies: [hand, block, {', '.join(bodies)}]", "couplings:",
             "  H: {type: prismatic, bodies: [beam, hand], at: [50, 0], axis: y}",
             "  L: {type: prismatic, bodies: [beam, block], at: [300, 0], axis: y}", *couplings,
             "cables:", "  rope:", "    over:", "      - {body: hand, at: [50, 0]}", *stations,
             "actuators: {hand: {coupling: H}, load: {coupling: L}}", "cases:",
             "  up: {motion: {hand: -12}, action: {hand: -1 N}, input: hand, output: load}",
             "  down: {motion: {hand: 12}, action: {load: -1 N}, input: load, output: hand}"]
    return "\n".join(lines) + "\n"


class Tackles(ReferenceTest):
    """n falls: the load rises with the n-th part of the speed; MA = eta (1 - eta^n)/(1 - eta)."""

    def test_without_losses(self) -> None:
        for falls in range(1, 7):
            with self.subTest(falls):
                case = program.run("analyze", "-", text=tackle(falls, 1.0))["cases"]["up"]
                self.near(case["kinematics"]["freedoms"]["L.vy"], 12.0 / falls, "speed")
                self.near(case["statics"]["actions"]["load"], -falls, "load", falls)
                reference = CASES.get(f"block_tackle_{falls}")
                if reference:
                    self.assertEqual(reference["expected"]["MA"], falls)

    def test_with_losses(self) -> None:
        eta = Fraction(95, 100)
        for falls in range(1, 7):
            with self.subTest(falls):
                cases = program.run("analyze", "-", text=tackle(falls, 0.95))["cases"]
                advantage = eta * (1 - eta ** falls) / (1 - eta)
                up, down = cases["up"], cases["down"]
                self.near(up["statics"]["actions"]["load"], -float(advantage), "load", falls)
                self.near(up["power"]["efficiency"]["friction"], float(advantage / falls), "eta")
                self.near(up["torque_ratio"], 1.0 / float(advantage), "torque ratio")
                behind = sum(1 / eta ** k for k in range(1, falls + 1))
                self.near(down["statics"]["actions"]["hand"], -float(1 / behind), "hand")
                for k in range(1, falls + 2):
                    tension = up["statics"]["actions"][f"rope_{k}.F"]
                    self.near(tension, float(eta ** (k - 1)), f"tension {k}")
        self.assertEqual(eta * (1 - eta ** 4) / (1 - eta), Fraction("3.52438125"))


class Capstans(ReferenceTest):
    """exp(mu theta) against the table of davies.json, the rope being pulled either way."""

    # Where the rope comes from and goes to, the axes of its ends, and full turns beside the arc.
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
                    self.assertEqual(contact["grip"], "slips")
                    # Clockwise is the order of the rope: onwards at the speed 2.
                    speed = 2.0 if label == "onwards" else -2.0
                    self.near(contact["slip_speed"], speed, "slip")
                    power = (1 - ratio) * speed
                    self.near(contact["slip_power"], power, "power", abs(power))
                    self.assertLess(contact["slip_power"], 0.0)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
