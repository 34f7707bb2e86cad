#!/usr/bin/env python3
"""Checks the states of random transmissions against exact fractions: class, ratio, slips, torques.

Usage: shift_differential.py PROGRAM [COUNT [FIRST]]

COUNT trains are drawn, 200 if it is not given; every tenth is a truck gearbox with 84 states, every
third of the others a layshaft gearbox.
"""

from __future__ import annotations

import json
import random
import re
import sys
import unittest
from fractions import Fraction

import program
from random_train import draw_box, draw_layshafts, draw_truck, two_suns
from shift_test import ShiftTest

COUNT = 200
FIRST = 0
TORQUE = Fraction(7)

# Teeth that do not fit a place, planets that touch, and what equilibrium or a gear leaves open are
# said; they change no state.
SAID = {"W0305", "W0307", "W0506", "W0601", "W0711"}


class RandomTeeth(ShiftTest):
    def test_class_ratio_and_torques_are_exact(self) -> None:
        kinds: list[str] = []
        for seed in range(FIRST, FIRST + COUNT):
            with self.subTest(seed=seed):
                kinds += self.check_seed(seed)
        for kind in ("gear", "neutral", "locked", "tie-up"):
            self.assertGreater(kinds.count(kind), COUNT // 4, kind)

    def check_seed(self, seed: int) -> list[str]:
        rng = random.Random(seed)
        is_truck = seed % 10 == 0
        draw = draw_truck if is_truck else draw_layshafts if seed % 3 == 0 else draw_box
        train, text = draw(rng, TORQUE)
        sizes = [] if is_truck else ["--one-more", "--one-fewer"]
        done = program.call("shift", *sizes, "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr + text)
        self.assertLessEqual(set(re.findall(r"\[(\w+)\]:", done.stderr)), SAID, text)
        return self.check_shift(train, program.report(done)["shift"], TORQUE)


class SmallDifferences(ShiftTest):
    """Ratios of thousands, which are differences of nearly equal products of teeth.

    What rounding the places of teeth takes from speeds it takes from torques as well: both must be
    exact, whichever of the two is small, and whichever side has the small pivots.
    """

    def test_speeds_and_torques_are_exact(self) -> None:
        for first, second in worst_sets(12):
            for ends in (("sun0", "ring"), ("ring", "sun0"), ("sun0", "carrier"), ("carrier", "sun0")):
                with self.subTest(first=first, second=second, ends=ends):
                    train, text = two_suns(first, second, ends, TORQUE)
                    self.check_shift(train, program.run("shift", "-", text=text)["shift"], TORQUE)
                    exact = train.state(("E0",), TORQUE)
                    case = program.run("analyze", "-", text=text)["cases"]["E0"]
                    self.near(case["ratio"] / float(exact.ratio), 1.0, "ratio")
                    self.near(case["torque_ratio"] / float(exact.torque_ratio), 1.0, "torque ratio")

    def test_a_loose_shaft_takes_no_digits(self) -> None:
        """What turns as it likes leaves the case without velocities; the gear has its ratio."""
        for first, second in worst_sets(6):
            for ends in (("sun0", "ring"), ("ring", "sun0")):
                train, text = two_suns(first, second, ends, TORQUE)
                exact = train.state(("E0",), TORQUE)
                loose = text.replace("bodies: [", "bodies: [loose, ", 1).replace(
                    "couplings:", "couplings:\n"
                    "  J_loose: {type: revolute, bodies: [housing, loose], at: [0, 0]}\n"
                    "  E9: {type: clutch, bodies: [sun1, loose]}", 1).replace(
                    "elements: [", "elements: [E9, ")
                for accuracy in ("auto", "exact"):
                    with self.subTest(first=first, second=second, ends=ends, accuracy=accuracy):
                        states = program.run("shift", "--one-fewer", "--accuracy", accuracy, "-",
                                             text=loose)["shift"]["states"]
                        for name in ("E0", "E9+E0"):
                            self.near(states[name]["ratio"] / float(exact.ratio), 1.0, name)
                            self.near(states[name]["torque_ratio"] / float(exact.torque_ratio), 1.0,
                                      name)

    def test_a_box_of_1_to_2542(self) -> None:
        self.assertIn("gear", RandomTeeth().check_seed(63911))


def worst_sets(count: int) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """Two simple sets, sun and planet of each, whose ratios are as near to each other as they come."""
    sets = [(sun, planet) for sun in range(18, 51) for planet in range(15, 41)]
    pairs = []
    for i, (a, p) in enumerate(sets):
        for b, q in sets[i + 1:]:
            product = a * (b + 2 * q)
            difference = abs(product - b * (a + 2 * p))
            if 0 < difference * 2000 < product:
                pairs.append((Fraction(difference, product), (a, p), (b, q)))
    return [(first, second) for _, first, second in sorted(pairs)[:count]]


class Sweeps(ShiftTest):
    """A sweep decides in every state what the combinations of a truck gearbox are."""

    def test_states_are_those_of_the_exact_train(self) -> None:
        for seed in range(0, 50, 10):
            train, text = draw_truck(random.Random(seed), TORQUE)
            labels = ["+".join(one) for one in train.combinations(3)]
            first = re.search(r"a1: {body: split, teeth: (\d+)}", text)
            swept = text.replace(first.group(0), "a1: {body: split, teeth: Na}").replace(
                "couplings:", f"parameters: {{Na: {first.group(1)}}}\ncouplings:", 1) + (
                f"sweep: {{vary: {{Na: {{values: [17, {first.group(1)}, 41]}}}}, "
                f"cases: [{', '.join(labels)}], report: [ratio]}}\n")
            done = program.call("sweep", "--quiet", "-", text=swept)
            self.assertEqual(done.returncode, 0, done.stderr)
            for line in done.stdout.splitlines():
                teeth, label, ratio, status = json.loads(line).values()
                train.sets[0]["split"] = Fraction(teeth)
                train.__dict__.pop("motions", None)
                expected = train.state(tuple(label.split("+")), TORQUE)
                with self.subTest(seed=seed, teeth=teeth, state=label):
                    self.assertEqual("gear" if status == "solved" else status, expected.kind)
                    if expected.ratio is not None:
                        self.near(ratio, float(expected.ratio), label,
                                  abs(float(expected.ratio)))


class HeldOutput(ShiftTest):
    """Two planetary sets and a lay shaft; E1 brakes b3, and E0, E3 join it to the output's side."""

    def test_is_locked_by_every_command_and_accuracy(self) -> None:
        for accuracy in ("fast", "auto", "high", "exact"):
            shift = program.run("shift", "--accuracy", accuracy, "-", text=HELD_OUTPUT)["shift"]
            for label in ("E1+E3", "E0+E1", "E0+E3"):
                self.assertEqual(shift["states"][label]["class"], "locked", label)
            self.assertLess(shift["span"], 10.0)


HELD_OUTPUT = """
kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [shaft, b1, b3, planet1, b2, b0, planet2, out, planet3]
couplings:
  J_shaft: {type: revolute, bodies: [housing, shaft]}
  J_b1: {type: revolute, bodies: [housing, b1]}
  J_b3: {type: revolute, bodies: [housing, b3]}
  J_planet1: {type: revolute, bodies: [b1, planet1]}
  J_b2: {type: revolute, bodies: [housing, b2]}
  J_b0: {type: revolute, bodies: [housing, b0]}
  J_planet2: {type: revolute, bodies: [shaft, planet2]}
  J_out: {type: revolute, bodies: [housing, out]}
  J_planet3: {type: revolute, bodies: [housing, planet3]}
  E0: {type: clutch, bodies: [b3, b2]}
  E1: {type: brake, bodies: [housing, b3]}
  E2: {type: clutch, bodies: [b1, b2]}
  E3: {type: clutch, bodies: [b3, out]}
gears:
  module: 1.5 mm
  members:
    sun1: {body: shaft, teeth: 21}
    planet1: {body: planet1, teeth: 17}
    ring1: {body: b3, teeth: 55, internal: true}
    sun2: {body: b2, teeth: 23}
    pa2: {body: planet2, teeth: 41, count: 2}
    pb2: {body: planet2, teeth: 33}
    sunb2: {body: b0, teeth: 31}
    sun3: {body: out, teeth: 22}
    pa3: {body: planet3, teeth: 24}
    pb3: {body: planet3, teeth: 29}
    sunb3: {body: b2, teeth: 17}
  meshes:
    s1: {members: [sun1, planet1], carrier: b1}
    r1: {members: [ring1, planet1], carrier: b1}
    s2: {members: [sun2, pa2], carrier: shaft}
    r2: {members: [sunb2, pb2], carrier: shaft}
    s3: {members: [sun3, pa3]}
    r3: {members: [sunb3, pb3]}
actuators: {in: {coupling: J_shaft}, out: {coupling: J_out}}
shift: {input: in, output: out, elements: [E0, E1, E2, E3]}
"""


if __name__ == "__main__":
    program.use(sys.argv[1])
    COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else COUNT
    FIRST = int(sys.argv[3]) if len(sys.argv) > 3 else FIRST
    unittest.main(argv=[sys.argv[0]], defaultTest=["RandomTeeth", "SmallDifferences", "Sweeps",
                                                    "HeldOutput"])
