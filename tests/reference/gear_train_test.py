#!/usr/bin/env python3
"""Gear trains of the section `gears` against hand-written ones, Willis and closed forms.

Usage: gear_train_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math
import random
import re
import sys
import unittest
from pathlib import Path

import program
from reference_test_case import ReferenceTest

MECHANISMS = Path()


def planetary(sun: object, planet: object, ring: object, head: str = "", gears: str = "",
              space: str = "planar", tail: str = "") -> str:
    """A simple set; in space bearings are on z at 1, 2, 3 and 4."""
    where = [f", at: {i}, axis: z" if space == "spatial" else "" for i in range(1, 5)]
    return f"""\
kinestat: 1
space: {space}
{head}ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  S: {{type: revolute, bodies: [housing, sun]{where[0]}}}
  R: {{type: revolute, bodies: [housing, ring]{where[1]}}}
  C: {{type: revolute, bodies: [housing, carrier]{where[2]}}}
  P: {{type: revolute, bodies: [carrier, planet]{where[3]}}}
gears:
  module: 2
{gears}  members:
    sun: {{body: sun, teeth: {sun}}}
    planet: {{body: planet, teeth: {planet}}}
    ring: {{body: ring, teeth: {ring}, internal: true}}
  meshes:
    sp: {{members: [sun, planet], carrier: carrier}}
    rp: {{members: [ring, planet], carrier: carrier}}
actuators: {{s: {{coupling: S}}, r: {{coupling: R}}, c: {{coupling: C}}}}
cases:
  ring held: {{motion: {{s: 1, r: 0}}, action: {{s: 1}}, input: s, output: c}}
  carrier held: {{motion: {{s: 1, c: 0}}, action: {{s: 1}}, input: s, output: r}}
  sun held: {{motion: {{r: 1, s: 0}}, action: {{r: 1}}, input: r, output: c}}
  reverse load: {{motion: {{s: 1, r: 0}}, action: {{s: -1}}, input: s, output: c}}
{tail}"""


def analyze(text: str) -> dict:
    return program.run("analyze", "-", text=text)


def couplings(report: dict) -> dict[str, dict]:
    return {one["name"]: one for one in report["graph"]["couplings"]}


class RavigneauxInTeeth(ReferenceTest):
    """ravigneaux_teeth.yaml says in teeth what ravigneaux.yaml says in coordinates."""

    def setUp(self) -> None:
        folder = MECHANISMS / "transmissions"
        self.by_hand = program.run("analyze", str(folder / "ravigneaux.yaml"))
        self.in_teeth = program.run("analyze", str(folder / "ravigneaux_teeth.yaml"))

    def numbers(self, value: object, path: str = "") -> dict[str, float]:
        if isinstance(value, dict):
            return {k: v for key, one in value.items()
                    for k, v in self.numbers(one, f"{path}/{key}").items()}
        if isinstance(value, list):
            return {k: v for i, one in enumerate(value)
                    for k, v in self.numbers(one, f"{path}/{i}").items()}
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        return {path: float(value)} if is_number else {}

    def test_has_the_same_report(self) -> None:
        for part in ("mobility", "cases"):
            by_hand = self.numbers(self.by_hand[part])
            in_teeth = self.numbers(self.in_teeth[part])
            for numbers in (by_hand, in_teeth):
                for path in [p for p in numbers if "evidence" in p or "residual" in p]:
                    del numbers[path]
            self.assertEqual(by_hand.keys(), in_teeth.keys())
            self.assertGreater(len(by_hand), 20)
            for path, value in by_hand.items():
                largest = max(abs(v) for p, v in by_hand.items()
                              if p.split("/")[:4] == path.split("/")[:4])
                self.near(in_teeth[path] / max(1.0, largest), value / max(1.0, largest), path)

    def test_has_the_same_couplings(self) -> None:
        by_hand, in_teeth = couplings(self.by_hand), couplings(self.in_teeth)
        self.assertEqual(list(by_hand), list(in_teeth))
        for name, one in by_hand.items():
            for a, b in zip(one["at"], in_teeth[name]["at"]):
                self.near(b, a, name, 100.0)


class Willis(ReferenceTest):
    """Simple sets with random teeth: i = 1 + R/S, -R/S and 1 + S/R, whatever the planet."""

    def test_random_trains(self) -> None:
        seed = 20080417
        numbers = random.Random(seed)
        for i in range(40):
            sun, planet = numbers.randint(12, 90), numbers.randint(12, 60)
            ring = sun + 2 * planet + numbers.choice([0, 0, 0, 1, -1, 2])
            with self.subTest(seed=seed, train=i, teeth=(sun, planet, ring)):
                cases = analyze(planetary(sun, planet, ring))["cases"]
                self.near_each({k: cases[k]["ratio"] for k in ("ring held", "carrier held", "sun held")},
                               {"ring held": 1 + ring / sun,
                                "carrier held": -ring / sun,
                                "sun held": 1 + sun / ring})

    def test_random_stepped_trains(self) -> None:
        """Carrier held: -R p1/(S p2), with p1 on the sun and p2 in the ring."""
        seed = 19120101
        numbers = random.Random(seed)
        for i in range(20):
            sun, first, second = (numbers.randint(14, 60) for _ in range(3))
            ring = sun + first + second
            text = planetary(sun, first, ring)
            text = text.replace("    ring: {", f"    step: {{body: planet, teeth: {second}}}\n    ring: {{")
            text = text.replace("[ring, planet], carrier", "[ring, step], carrier")
            with self.subTest(seed=seed, train=i, teeth=(sun, first, second, ring)):
                cases = analyze(text)["cases"]
                self.near_each({"": cases["carrier held"]["ratio"]},
                               {"": -ring * first / (sun * second)})


class Places(ReferenceTest):
    def test_of_a_set_in_space(self) -> None:
        """Module 2: the planet at 24 + 18, the pitch points at 24 and 60 on y, positions on z kept."""
        found = couplings(analyze(planetary(24, 18, 60, space="spatial")))
        for name, point in {"S": [0, 0, 1], "R": [0, 0, 2], "C": [0, 0, 3], "P": [0, 42, 4],
                            "sp": [0, 24, 0], "rp": [0, 60, 0]}.items():
            for actual, expected in zip(found[name]["at"], point):
                self.near(actual, expected, name)

    def test_of_a_countershaft(self) -> None:
        """Two gears on the main axis and a shaft with two beside them, all on the ground."""
        report = analyze("""\
kinestat: 1
space: planar
ground: housing
bodies: [in, out, counter]
couplings:
  I: {type: revolute, bodies: [housing, in]}
  O: {type: revolute, bodies: [housing, out]}
  L: {type: revolute, bodies: [housing, counter]}
gears:
  module: 2
  members:
    a: {body: in, teeth: 20}
    b: {body: counter, teeth: 40}
    c: {body: counter, teeth: 25}
    d: {body: out, teeth: 35}
  meshes:
    ab: {members: [a, b]}
    cd: {members: [c, d]}
actuators: {i: {coupling: I}, o: {coupling: O}}
cases: {turning: {motion: {i: 1}, action: {i: 1}, input: i, output: o}}
""")
        self.near(report["cases"]["turning"]["ratio"], 40 / 20 * 35 / 25, "ratio")
        for actual, expected in zip(couplings(report)["L"]["at"], [0, 60]):
            self.near(actual, expected, "L")


class Derivatives(ReferenceTest):
    def test_by_numbers_of_teeth(self) -> None:
        """i = 1 + R/S: -R/S², 1/S and nothing."""
        head = "parameters: {zs: 24, zp: 18, zr: 60}\n"
        report = program.run("sensitivity", "--of", "ratio", "-",
                             text=planetary("zs", "zp", "zr", head))
        by = report["cases"]["ring held"]["sensitivity"]["ratio"]["by"]
        self.near(by["zs"]["derivative"], -60 / 24**2, "zs")
        self.near(by["zr"]["derivative"], 1 / 24, "zr")
        self.near(by["zp"]["derivative"], 0.0, "zp")

    def test_of_planets_in_line(self) -> None:
        """M1 of the Ravigneaux train: N3/N1, although its flat triangle has no derivative."""
        path = str(MECHANISMS / "transmissions" / "ravigneaux_teeth.yaml")
        report = program.run("sensitivity", "--case", "M1", "--of", "ratio", path)
        by = report["cases"]["M1"]["sensitivity"]["ratio"]["by"]
        # i = N3 N6i/(N6jk N1)
        ratio = 85 * 14 / (22 * 19)
        self.near(by["N1"]["derivative"], -ratio / 19, "N1")
        self.near(by["N3"]["derivative"], ratio / 85, "N3")
        self.near(by["N5"]["derivative"], 0.0, "N5")

    def test_of_forces_on_turned_flanks(self) -> None:
        """The bearing of the ring bears tan(α) times the tangential force, on either flank."""
        head = "parameters: {zs: 24, alpha: 25 deg}\n"
        text = planetary("zs", 18, 60, head, "  pressure_angle: alpha\n")
        report = program.run("sensitivity", "--of", "R.Ry", "--by", "alpha", "-", text=text)
        expected = 1 / 24 / math.cos(math.radians(25))**2
        for label in ("ring held", "reverse load"):
            by = report["cases"][label]["sensitivity"]["R.Ry"]["by"]["alpha"]
            self.near(abs(by["derivative"]), expected, label)


class Flanks(ReferenceTest):
    """Sun torque 1 N·m on a pitch radius of 24 m, 25 degrees."""

    TANGENTIAL = 1 / 24
    ANGLE = "  pressure_angle: 25 deg\n"

    def radial(self, gears: str, label: str, space: str = "planar") -> tuple[float, float]:
        """The force on sun and ring along the line of centres, through their bearings."""
        report = analyze(planetary(24, 18, 60, "", gears, space))
        actions = report["cases"][label]["statics"]["actions"]
        return -actions["S.Ry"], -actions["R.Ry"]

    def test_loaded_teeth_push_apart(self) -> None:
        """The sun away from the planet above it, the ring away from the planet below its teeth."""
        radial = self.TANGENTIAL * math.tan(math.radians(25))
        for label in ("ring held", "reverse load"):
            for space in ("planar", "spatial"):
                sun, ring = self.radial(self.ANGLE, label, space)
                self.near(sun, -radial, f"{label} {space}: sun")
                self.near(ring, radial, f"{label} {space}: ring")

    def test_fixed_flanks_keep_their_line(self) -> None:
        radial = self.TANGENTIAL * math.tan(math.radians(25))
        fixed = self.ANGLE + "  flank: fixed\n"
        forward, _ = self.radial(fixed, "ring held")
        backward, _ = self.radial(fixed, "reverse load")
        self.near(abs(forward), radial, "forward")
        self.near(backward, -forward, "backward")

    def test_a_planet_between_helical_gears_bears_no_thrust(self) -> None:
        """Sun and ring push the planet along the axis, against each other; 15 degrees."""
        gears = self.ANGLE + "  helix_angle: 15 deg\n"
        thrust = self.TANGENTIAL * math.tan(math.radians(15))
        report = analyze(planetary(24, 18, 60, "", gears, "spatial"))
        actions = report["cases"]["ring held"]["statics"]["actions"]
        self.near(actions["P.Rz"], 0.0, "planet")
        self.near(abs(actions["S.Rz"]), thrust, "sun")
        self.near(actions["S.Rz"] + actions["R.Rz"], 0.0, "sun and ring")


class Gearboxes(ReferenceTest):
    """Every gear of every transmission of the library loses nothing."""

    def test_power_balance(self) -> None:
        for path in sorted(MECHANISMS.glob("transmissions/*.yaml")):
            if not re.search(r"^gears:", path.read_text(encoding="utf-8"), re.MULTILINE):
                continue
            for label, case in program.run("analyze", str(path))["cases"].items():
                with self.subTest(path.name, gear=label):
                    self.assertLess(abs(case["power"]["balance_residual"]), 1e-9)
                    if "ratio" in case and isinstance(case["ratio"], float):
                        self.near(case["ratio"] * case["torque_ratio"], -1.0, label)


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
