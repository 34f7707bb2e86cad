#!/usr/bin/env python3
"""Checks block and tackle and the differential hoist of Weston against their closed forms.

Usage: tackle_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import re
import sys
import unittest
from fractions import Fraction

import program
from reference_case import CASES, number
from reference_test_case import ReferenceTest


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

    @staticmethod
    def with_mass(bodies: re.Match) -> str:
        masses = {"block": "{mass: 60, centre_of_mass: [300, 0]}"}
        return "bodies: {%s}" % ", ".join(
            f"{name}: {masses.get(name, '{}')}" for name in bodies[1].split(", "))

    def test_goods_are_an_output_that_rises_and_an_input_that_sinks(self) -> None:
        eta = Fraction(9, 10)
        goods = {"force": ("loads: {goods: {body: block, at: [300, 0], force: [0, -600 N]}}", "goods"),
                 "weight": ("gravity: [0, -10 m/s^2]", "gravity.block")}
        for kind, (section, name) in goods.items():
            for falls in (1, 2, 4):
                text = tackle(falls, 0.9).split("actuators:")[0]
                if kind == "weight":
                    text = re.sub(r"bodies: \[(.*)\]", self.with_mass, text, count=1)
                text += (f"{section}\nactuators: {{hand: {{coupling: H}}}}\ncases:\n"
                         f"  up: {{motion: {{hand: -12}}, input: hand, output: {name}}}\n"
                         f"  down: {{motion: {{hand: 12}}, input: {name}, output: hand}}\n")
                with self.subTest(kind=kind, falls=falls):
                    cases = program.run("analyze", "-", text=text)["cases"]
                    advantage = eta * (1 - eta ** falls) / (1 - eta)
                    behind = sum(1 / eta ** k for k in range(1, falls + 1))
                    up, down = cases["up"]["power"], cases["down"]["power"]
                    self.near(up["efficiency"]["friction"], float(advantage / falls), "up")
                    self.near(down["efficiency"]["friction"], float(falls / behind), "down")
                    self.near(up["input"], 12e-3 * 600 / float(advantage), "input")
                    self.near(down["input"], 600 * 12e-3 / falls, "what sinks gives")

    def test_a_load_that_does_not_act_is_no_output(self) -> None:
        text = tackle(2, 0.9).replace("output: load}", "output: gravity.block}", 1)
        done = program.call("analyze", "-", text=text)
        self.assertEqual(done.returncode, 3)
        self.assertIn("'gravity.block' does not act in case 'up'", done.stderr)

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
        """W = T_2 + T_3, T_3 = s T_2. The shaft drives: hand and small drum together give it the
        1/l-th part of T_2 R that the large drum asks for, F R + T_3 r m = T_2 R/l."""
        for large, small in self.RADII:
            for first, sheave, last in ((0.95, 1, 1), (1, 0.9, 1), (1, 1, 0.8), (0.95, 0.9, 0.8)):
                with self.subTest(large=large, small=small, losses=(first, sheave, last)):
                    case = program.run("analyze", "-", text=hoist(
                        large, small, (first, sheave, last)))["cases"]["raising"]
                    up = 100 / (1 + sheave)
                    force = up * (large / first - small * last * sheave) / large
                    actions = case["statics"]["actions"]
                    self.near(actions["chain_2.F"], up, "T_2", 100.0)
                    self.near(actions["chain_3.F"], up * sheave, "T_3", 100.0)
                    self.near(actions["hand"], -force, "hand", 100.0)
                    efficiency = 100 * (large - small) / (2 * large) / force
                    self.near(case["power"]["efficiency"]["friction"], efficiency, "efficiency")

    def test_loaded_chain_rubs_alike_up_and_down(self) -> None:
        """What the hand feels of the large drum alone is about the loss of half the load."""
        for large, small in self.RADII:
            with self.subTest(large=large, small=small):
                cases = program.run("analyze", "-", text=hoist(
                    large, small, (0.98, 1, 1)))["cases"]
                ideal = 50 * (large - small) / large
                up, down = (-cases[label]["statics"]["actions"]["hand"]
                            for label in ("raising", "lowering"))
                self.near(up - ideal, 50 * 0.02 / 0.98, "raising", 50.0)
                self.near(ideal - down, 50 * 0.02, "lowering", 50.0)

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


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
