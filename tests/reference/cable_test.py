#!/usr/bin/env python3
"""Holds ropes of the section `cables` against the pulleys of davies.json, which have RR chains.

Usage: cable_test.py PROGRAM MECHANISMS [unittest arguments]

Alves 2023, section 3.4: bodies 1 and 3 are the blocks, 2 the pulley, 4 the virtual link; 5 and 6,
the chains, are the segments rope_1 and rope_2.
"""

from __future__ import annotations

import math
import sys
import unittest
from fractions import Fraction
from pathlib import Path

import program
from reference_case import CASES, TABLES, ReferenceCase, number
from reference_test_case import ReferenceTest

MECHANISMS = Path()
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
    """A rope drawn over a driven pulley: T_high/T_low = exp(mu pi) in the sense of the slip."""

    def test_power(self) -> None:
        mu, radius, pull = 0.25, 1.5, 40.0
        high = math.exp(mu * math.pi)
        # The rope runs on over the pulley at the speed v + w r, v up its first segment.
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

    def test_over_a_pulley_whose_journal_rubs_too(self) -> None:
        """(T - W) r = mu r_j (T + W) + (1 - eta) T r"""
        radius, journal, mu, eta, weight = 50, 10, 0.2, 0.9, 1000
        lines = ["kinestat: 1", "space: planar", "ground: frame", "bodies: [load, hand, wheel]",
                 "couplings:",
                 f"  L: {{type: prismatic, bodies: [frame, load], at: [{-radius}, 0], axis: y}}",
                 f"  H: {{type: prismatic, bodies: [frame, hand], at: [{radius}, 0], axis: y}}",
                 "  A: {type: revolute, bodies: [frame, wheel], at: [0, 500], "
                 f"friction: {{mu: {mu}, radius: {journal}}}}}",
                 "cables:", "  rope:", "    over:",
                 f"      - {{body: load, at: [{-radius}, 0]}}",
                 f"      - {{pulley: wheel, radius: {radius}, wrap: clockwise, eta: {eta}}}",
                 f"      - {{body: hand, at: [{radius}, 0]}}",
                 "actuators: {load: {coupling: L}, hand: {coupling: H}}", "cases:",
                 f"  up: {{motion: {{load: 1}}, action: {{load: {-weight}}}}}"]
        case = program.run("analyze", "-", text="\n".join(lines) + "\n")["cases"]["up"]
        drag = mu * journal
        self.near(case["statics"]["actions"]["hand"],
                  -weight * (radius + drag) / (eta * radius - drag), "hand", weight)


def hoist(large: float, small: float, losses: tuple[float, float, float]) -> str:
    """Weston's: the chain over the large drum, round the sheave, up to the small drum."""
    eta_large, eta_sheave, eta_small = losses
    middle = (large - small) / 2
    return f"""\
kinestat: 1
space: planar
ground: frame
bodies: [hand, shaft, block, sheave]
couplings:
  H: {{type: prismatic, bodies: [frame, hand], at: [{-large}, -9], axis: y}}
  A: {{type: revolute, bodies: [frame, shaft], at: [0, 0]}}
  L: {{type: prismatic, bodies: [frame, block], at: [{middle}, -9], axis: y}}
  B: {{type: revolute, bodies: [block, sheave], at: [{middle}, -9]}}
cables:
  chain:
    over:
      - {{body: hand, at: [{-large}, -9]}}
      - {{pulley: shaft, radius: {large}, wrap: clockwise, eta: {eta_large}}}
      - {{pulley: sheave, radius: {(large + small) / 2}, wrap: clockwise, eta: {eta_sheave}}}
      - {{pulley: shaft, radius: {small}, wrap: clockwise, eta: {eta_small}}}
actuators: {{hand: {{coupling: H}}, load: {{coupling: L}}}}
cases:
  raising: {{motion: {{hand: -1}}, action: {{load: -100}}, input: hand, output: load}}
  lowering: {{motion: {{hand: 1}}, action: {{load: -100}}, input: load, output: hand}}
"""


class Hoists(ReferenceTest):
    """The load rises by (R - r)/(2 R) of the chain; each contact passes on eta of the tension."""

    RADII = ((1.0, 0.9), (1.0, 0.5), (0.75, 0.25))

    def test_without_losses(self) -> None:
        for large, small in self.RADII:
            with self.subTest(large=large, small=small):
                advantage = 2 * large / (large - small)
                cases = program.run("analyze", "-", text=hoist(large, small, (1, 1, 1)))["cases"]
                for label in ("raising", "lowering"):
                    actions = cases[label]["statics"]["actions"]
                    self.near(actions["hand"], -100 / advantage, "hand", 100.0)
                    self.near(actions["chain_2.F"], 50.0, "T_2", 50.0)
                    self.near(actions["chain_3.F"], 50.0, "T_3", 50.0)
                rates = cases["raising"]["kinematics"]["freedoms"]
                self.near(rates["L.vy"], 1 / advantage, "speed")
                self.near(cases["raising"]["ratio"], -advantage, "ratio", advantage)

    def test_raising_with_losses(self) -> None:
        """W = T_2 + T_3, T_3 = s T_2; F R l + T_3 r m = T_2 R: the small drum gives m of it."""
        for large, small in self.RADII:
            for first, sheave, last in ((0.95, 1, 1), (1, 0.9, 1), (1, 1, 0.8), (0.95, 0.9, 0.8)):
                with self.subTest(large=large, small=small, losses=(first, sheave, last)):
                    case = program.run("analyze", "-", text=hoist(
                        large, small, (first, sheave, last)))["cases"]["raising"]
                    up = 100 / (1 + sheave)
                    force = up * (large - small * last * sheave) / (large * first)
                    actions = case["statics"]["actions"]
                    self.near(actions["chain_2.F"], up, "T_2", 100.0)
                    self.near(actions["chain_3.F"], up * sheave, "T_3", 100.0)
                    self.near(actions["hand"], -force, "hand", 100.0)
                    efficiency = 100 * (large - small) / (2 * large) / force
                    self.near(case["power"]["efficiency"]["friction"], efficiency, "efficiency")

    def test_lowering_with_losses(self) -> None:
        """The tension is larger where the chain runs to: T_2 = s T_3; F R = T_2 R l - T_3 r/m."""
        large, small = 1.0, 0.25
        for first, sheave, last in ((0.95, 1, 1), (1, 0.9, 1), (1, 1, 0.8), (0.95, 0.9, 0.8)):
            with self.subTest(losses=(first, sheave, last)):
                case = program.run("analyze", "-", text=hoist(
                    large, small, (first, sheave, last)))["cases"]["lowering"]
                up = 100 / (1 + sheave)
                force = (up * sheave * large * first - up * small / last) / large
                self.assertGreater(force, 0.0)
                self.near(case["statics"]["actions"]["hand"], -force, "hand", 100.0)


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
                        driver["grip"], "sticks" if tight / 5 <= limit else "would slip")

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


class TautRopes(ReferenceTest):
    """What `inputs` says pulls on every segment, put into a case, does so."""

    FILES = ("pulley", "pulley_without_slip", "two_pulleys", "block_and_tackle", "weston_hoist")

    def test_drives_pull_on_every_segment(self) -> None:
        for name in self.FILES:
            with self.subTest(name):
                text = (MECHANISMS / "cables" / f"{name}.yaml").read_text(encoding="utf-8")
                ropes = program.run("inputs", "-", text=text)["inputs"]["ropes"]
                self.assertTrue(ropes["possible"])
                self.assertGreater(len(ropes["drives"]), 1)
                pulled = self.with_drives(text, ropes["drives"])
                actions = program.run("analyze", "-", text=pulled)["cases"]["taut"]["statics"]
                tensions = [value for key, value in actions["actions"].items()
                            if key.endswith(".F")]
                self.assertEqual(len(tensions), ropes["segments"])
                self.near(min(tensions), 1.0, "least tension")

    @staticmethod
    def with_drives(text: str, drives: dict[str, float]) -> str:
        """The bodies and ropes of the file with these actuators alone."""
        start = text[:text.index("\nactuators:")]
        names = list(drives)
        lines = ["actuators:"]
        for i, name in enumerate(names):
            coupling, freedom = name.split(".")
            lines.append(f"  T{i}: {{coupling: {coupling}, freedom: {freedom}}}")
        known = ", ".join(f"T{i}: {drives[name]}" for i, name in enumerate(names[:1]))
        return "\n".join([start, *lines, "cases:", f"  taut: {{action: {{{known}}}}}", ""])


class Tables(ReferenceTest):
    """Alves 2023, tables 3.1 to 3.7: links, pairs, freedoms, circuits, M."""

    # Bodies, pairs of class I and V, circuits, mobility in space; eqs. 3.1, 3.2, 3.4 to 3.7. For
    # the instrument the source prints 14 circuits; its own tables make 37 - 26 + 1 = 12.
    PRINTED = {
        "pulley_without_slip": (4, 2, 3, 2, 1),
        "pulley": (5, 2, 4, 2, 2),
        "two_pulleys": (7, 3, 6, 3, 3),
        "two_pulleys_with_weights": (7, 3, 4, 1, 13),
        "finger_rehabilitation": (9, 4, 8, 4, 4),
        "surgical_instrument": (26, 12, 25, 12, 13),
    }

    def test_mobility(self) -> None:
        for name, (bodies, ropes, others, circuits, mobility) in self.PRINTED.items():
            with self.subTest(name):
                path = MECHANISMS / "cables" / f"{name}.yaml"
                report = program.run("mobility", str(path))["mobility"]
                count = report["grubler"]["spatial"]
                self.assertEqual(count["bodies"], bodies)
                self.assertEqual(count["couplings"], ropes + others)
                self.assertEqual(count["freedoms"], 5 * ropes + others)
                self.assertEqual(count["mobility"], mobility)
                self.assertEqual(len(count["classes"]["P_I"]["couplings"]), ropes)
                self.assertEqual(len(count["classes"]["P_V"]["couplings"]), others)
                self.assertEqual(report["circuits"], circuits)
                if report["counts"]:
                    exact = report["counts"]["spatial"]
                    self.assertEqual(exact["net_freedom"], mobility)
                    self.assertEqual(exact["net_constraint"], 0)

    def test_slip_adds_one_freedom_a_pulley(self) -> None:
        for name, pulleys in (("pulley", 1), ("two_pulleys", 2), ("two_pulleys_with_weights", 2),
                              ("finger_rehabilitation", 3), ("pulley_without_slip", 0)):
            with self.subTest(name):
                path = MECHANISMS / "cables" / f"{name}.yaml"
                ropes = program.run("inputs", str(path))["inputs"]["ropes"]
                self.assertEqual(ropes["net_freedom"], self.PRINTED[name][-1])
                self.assertEqual(ropes["without_slip"], self.PRINTED[name][-1] - pulleys)


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
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
