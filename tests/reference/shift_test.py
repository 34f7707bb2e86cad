#!/usr/bin/env python3
"""Checks shift tables against exact equations of Willis, gear by gear and class by class.

Usage: shift_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math
import random
import re
import sys
import unittest
from fractions import Fraction
from pathlib import Path

import program
from exact_train import HOUSING, Train, simple_set
from reference_test_case import ReferenceTest

MECHANISMS = Path("mechanisms")
SEEDS = range(120)


def ravigneaux() -> Train:
    """Cazangi 2008, Tab. 5.7, with the input shaft; the planets are eliminated by hand."""
    n1, n2, n3, n6i, n6 = 19, 41, 85, 14, 22
    small = {"sun1": Fraction(n1 * n6), "ring": Fraction(-n6i * n3),
             "carrier": Fraction(n6i * n3 - n1 * n6)}
    return Train(
        shafts=["shaft", "sun1", "sun2", "ring", "carrier"],
        sets=[small, simple_set("sun2", "ring", "carrier", (n2, n3))],
        elements={"C1": ("shaft", "sun1"), "C2": ("shaft", "sun2"),
                  "B1": (HOUSING, "sun2"), "B2": (HOUSING, "carrier")},
        input="shaft", output="ring")


def zf_8hp70() -> Train:
    """Four simple sets: S1=S2, C1=R4, C2=input, R2=S3, R3=S4, C4=output."""
    return Train(
        shafts=["in", "out", "s12", "r1", "c1", "s3", "c3", "s4"],
        sets=[simple_set("s12", "r1", "c1", (48, 96)), simple_set("s12", "s3", "in", (48, 96)),
              simple_set("s3", "s4", "c3", (69, 111)), simple_set("s4", "c1", "out", (23, 85))],
        elements={"A": (HOUSING, "s12"), "B": (HOUSING, "r1"), "C": ("in", "s4"),
                  "D": ("c3", "out"), "E": ("s3", "s4")},
        input="in", output="out")


def lepelletier_6hp26() -> Train:
    """A simple set with its sun at rest, ring driven, before a Ravigneaux set 31/38/85."""
    first = {"in": Fraction(71), "c0": Fraction(-37 - 71)}
    small = {"s1": Fraction(31), "out": Fraction(-85), "c": Fraction(85 - 31)}
    return Train(
        shafts=["in", "c0", "s1", "s2", "c", "out"],
        sets=[first, small, simple_set("s2", "out", "c", (38, 85))],
        elements={"A": ("c0", "s1"), "B": ("c0", "s2"), "C": (HOUSING, "s2"), "D": (HOUSING, "c"),
                  "E": ("in", "c")},
        input="in", output="out")


class ShiftTest(ReferenceTest):
    """Compares the states of a report with those of an exact train."""

    def check_values(self, actual: dict, expected: dict[str, Fraction | None], what: str) -> None:
        largest = max((abs(x) for x in expected.values() if x is not None), default=Fraction(0))
        for name, value in expected.items():
            if value is None:
                self.assertIsNone(actual[name], f"{what} of {name}")
            else:
                self.near(actual[name], float(value), f"{what} of {name}", float(largest))

    def check_state(self, train: Train, state: dict, torque: Fraction, speed: float) -> str:
        expected = train.state(tuple(state["engaged"]), torque)
        self.assertEqual(state["class"], expected.kind, state)
        if expected.kind != "gear":
            self.assertIsNone(state["ratio"])
            self.assertNotEqual(state["reason"], "")
            return expected.kind
        self.near(state["ratio"], float(expected.ratio), "ratio", abs(float(expected.ratio)))
        if expected.torque_ratio is not None:
            self.assertEqual(expected.ratio * expected.torque_ratio, -1)
            self.near(state["ratio"] * state["torque_ratio"], -1.0, "ratio · torque ratio")
        elements = state["elements"]
        slips = {e: None if v["slip"] is None else v["slip"] / speed for e, v in elements.items()}
        self.check_values(slips, expected.slips, "slip")
        self.check_values({e: v["torque"] for e, v in elements.items()}, expected.torques, "torque")
        return expected.kind

    def check_shift(self, train: Train, shift: dict, torque: Fraction,
                    speed: float = 1.0) -> list[str]:
        self.assertEqual(shift["net_freedom"], train.net_freedom())
        self.assertEqual(shift["engaged"], train.net_freedom() - 1)
        expected = {frozenset(c) for c in train.combinations(train.net_freedom() - 1)}
        self.assertEqual(shift["possibilities"], len(expected))
        self.assertEqual({frozenset(s["engaged"]) for s in shift["states"].values()
                          if len(s["engaged"]) == shift["engaged"]}, expected)
        return [self.check_state(train, state, torque, speed)
                for state in shift["states"].values()]

    def check_changes(self, train: Train, shift: dict, speed: float) -> None:
        """What the engaging elements slip before, by Willis."""
        for change in shift["changes"]:
            states = [shift["states"][change[key]] for key in ("from", "to")]
            exact = [train.state(tuple(state["engaged"]), Fraction(1)) for state in states]
            self.assertEqual(change["elements"], len(change["opens"]) + len(change["engages"]))
            for key, before, elements in (("slip", 0, change["engages"]),
                                          ("slip_back", 1, change["opens"])):
                total = sum(abs(exact[before].slips[element]) for element in elements)
                self.near(change[key] / speed, float(total), f"{key} of {change}")
            if all(one.ratio > 0 for one in exact):
                self.near(change["step"], float(exact[0].ratio / exact[1].ratio), "step")
            else:
                self.assertIsNone(change["step"])


class Ravigneaux(ShiftTest):
    @classmethod
    def setUpClass(cls) -> None:
        path = MECHANISMS / "transmissions" / "ravigneaux_input_shaft.yaml"
        cls.more = program.run("shift", "--one-more", "--one-fewer", str(path))["shift"]
        cls.report = program.run("analyze", str(path))
        cls.shift = cls.report["shift"]

    def test_all_six_pairs_are_those_of_willis(self) -> None:
        kinds = self.check_shift(ravigneaux(), self.shift, Fraction(100))
        self.assertEqual(kinds, ["gear"] * 4 + ["locked"] * 2)

    def test_one_more_and_one_fewer(self) -> None:
        self.check_shift(ravigneaux(), self.more, Fraction(100))
        self.assertEqual(len(self.more["states"]), 4 + 6 + 4)

    def test_ratios_of_the_table(self) -> None:
        """Tab. 5.15."""
        exact = {"M1": Fraction(595, 209), "M2": Fraction(21080, 13167), "M3": Fraction(1),
                 "MR": Fraction(-85, 41)}
        states = self.shift["states"]
        self.assertEqual(list(states), ["M1", "M2", "M3", "MR", "C2+B1", "B1+B2"])
        for name, ratio in exact.items():
            self.near(states[name]["ratio"], float(ratio), name)
        self.near(states["M2"]["step"], float(exact["M1"] / exact["M2"]), "step of M2")
        self.near(states["M3"]["step"], float(exact["M2"]), "step of M3")
        self.near(self.shift["span"], float(exact["M1"]), "span")
        self.assertEqual([states[n]["direction"] for n in exact], ["forward"] * 3 + ["reverse"])

    def test_reasons_name_what_is_held(self) -> None:
        states = self.shift["states"]
        self.assertIn("input 'in' is locked; locked bodies: sun2, shaft", states["C2+B1"]["reason"])
        self.assertIn("output 'out' is locked; locked bodies: sun1, sun2, ring, carrier, planet5, "
                      "planet6; one freedom remains, moving shaft", states["B1+B2"]["reason"])

    def test_changes_of_one_element(self) -> None:
        """Every two gears but M2 = C1+B1 and MR = C2+B2 share one element."""
        pairs = {(c["from"], c["to"]): (c["opens"], c["engages"]) for c in self.shift["changes"]}
        self.assertEqual(pairs, {("M1", "M2"): (["B2"], ["B1"]), ("M1", "M3"): (["B2"], ["C2"]),
                                 ("M1", "MR"): (["C1"], ["C2"]), ("M2", "M3"): (["B1"], ["C2"]),
                                 ("M3", "MR"): (["C1"], ["B2"])})

    def test_slips_that_changes_take_up(self) -> None:
        self.check_changes(ravigneaux(), self.shift, 1.0)
        self.near(self.shift["changes"][0]["step"],
                  float(Fraction(595, 209) / Fraction(21080, 13167)), "M1 - M2")
        self.assertEqual(self.shift["changes"][0]["elements"], 2)

    def test_limits(self) -> None:
        """Of all elements and of one body, planets on their carrier by the teeth in mesh with suns."""
        path = MECHANISMS / "transmissions" / "ravigneaux_input_shaft.yaml"
        text = path.read_text(encoding="utf-8").replace(
            "\nshift:\n", "\nshift:\n  limits: {torque: {C1: 70 N*m, B2: 400 N*m}, slip: 2 rad/s, "
            "speed: {carrier: 1.01 rad/s}, planet_speed: {planet5: 1.5 rad/s}}\n")
        shift = program.run("shift", "-", text=text)["shift"]
        train = ravigneaux()
        for name in ("M1", "M2", "M3", "MR"):
            state = shift["states"][name]
            exact = train.state(tuple(state["engaged"]), Fraction(100))
            limits = state["limits"]
            for element, most in (("C1", 70), ("B2", 400)):
                self.near(limits[f"torque.{element}"]["use"],
                          abs(float(exact.torques[element])) / most, f"{name} {element}", 1.0)
            for element, slip in exact.slips.items():
                self.near(limits[f"slip.{element}"]["use"], abs(float(slip)) / 2, f"{name} {element}", 1.0)
            # B2 holds the carrier and C1 joins sun 1 to the input, which turns at 1.
            carrier = exact.slips["B2"]
            sun1 = 1 + exact.slips["C1"]
            self.near(limits["speed.carrier"]["use"], abs(float(carrier)) / 1.01, name, 1.0)
            planet = abs(float((sun1 - carrier) * Fraction(19, 15)))
            self.near(limits["planet_speed.planet5"]["speed"], planet, name, 1.0)
            self.near(limits["planet_speed.planet5"]["use"], planet / 1.5, name, 1.0)
            self.near(state["limit_use"], max(one["use"] for one in limits.values()), name, 1.0)

    def test_gears_are_cases(self) -> None:
        for name in ("M1", "M2", "M3", "MR"):
            case, state = self.report["cases"][name], self.shift["states"][name]
            self.assertEqual(case["ratio"], state["ratio"])
            self.assertEqual(case["power"]["recirculation"]["factor"], state["recirculation"])
            for element, values in state["elements"].items():
                self.assertEqual(case["statics"]["actions"][element], values["torque"])
                self.assertEqual(case["kinematics"]["freedoms"][f"{element}.wz"], values["slip"])

    def test_worst_members_bear_most(self) -> None:
        for name in ("M1", "M2", "M3", "MR"):
            couplings = self.report["cases"][name]["statics"]["couplings"]
            for key, members in (("worst_bearing", "abcdfgs"), ("worst_mesh", "hijk")):
                force = {m: sum(x * x for x in couplings[m]["force"]) ** 0.5 for m in members}
                worst = self.shift["states"][name][key]
                largest = max(force.values())
                # Meshes of one planet bear the same: the first of them is named.
                first = next(m for m in members if force[m] >= largest * (1 - 1e-12))
                self.assertEqual(worst["coupling"], first)
                self.near(worst["force"], max(force.values()), name, worst["force"])


class Library(ShiftTest):
    """The gearboxes of the library, driven with 1000 rpm and 100 N·m."""

    SPEED = 1000 * math.pi / 30
    TORQUE = Fraction(100)

    def shift_of(self, name: str, *options: str) -> dict:
        path = MECHANISMS / "transmissions" / f"{name}.yaml"
        return program.run("shift", *options, str(path))["shift"]

    def test_8hp70_has_nine_gears_and_one_lock(self) -> None:
        kinds = self.check_shift(zf_8hp70(), self.shift_of("zf_8hp70"), self.TORQUE, self.SPEED)
        self.assertEqual(kinds, ["gear"] * 9 + ["locked"])
        self.check_shift(zf_8hp70(), self.shift_of("zf_8hp70", "--one-more", "--one-fewer"),
                         self.TORQUE, self.SPEED)

    def test_8hp70_changes_one_element_between_neighbours(self) -> None:
        """The design of this transmission: each gear shares two elements with the next."""
        changes = self.shift_of("zf_8hp70")["changes"]
        pairs = {frozenset((c["from"], c["to"])) for c in changes}
        for low, high in zip("1234567", "2345678"):
            self.assertIn(frozenset((low, high)), pairs)

    def test_8hp70_slips_that_changes_take_up(self) -> None:
        self.check_changes(zf_8hp70(), self.shift_of("zf_8hp70"), self.SPEED)

    def test_6hp26_has_seven_gears(self) -> None:
        shift = self.shift_of("lepelletier_6hp26", "--one-more", "--one-fewer")
        self.check_shift(lepelletier_6hp26(), shift, self.TORQUE, self.SPEED)
        of_two = [s["class"] for s in shift["states"].values() if len(s["engaged"]) == 2]
        self.assertEqual((len(of_two), of_two.count("gear")), (10, 7))

    def test_balances_power_in_every_gear(self) -> None:
        gears = 0
        for path in sorted((MECHANISMS / "transmissions").glob("*.yaml")):
            report = program.run("analyze", str(path))
            for name, case in report["cases"].items():
                if name == "jacked up":  # asks for speeds alone
                    continue
                with self.subTest(file=path.name, case=name):
                    self.assertLess(case["power"]["balance_residual"], 1e-9)
            for name, state in report.get("shift", {"states": {}})["states"].items():
                with self.subTest(file=path.name, state=name):
                    if state["class"] == "gear":
                        gears += 1
                        if "reactions" not in state:  # a machine exchanges power too
                            self.near(state["ratio"] * state["torque_ratio"], -1.0, name)
                        self.assertIn(name, report["cases"])
        self.assertGreaterEqual(gears, 9 + 7 + 5 + 5 + 5 + 4 + 4)


class RandomTrains(ShiftTest):
    """Planetary sets between random shafts, with random clutches and brakes."""

    TORQUE = Fraction(7)

    def draw(self, rng: random.Random) -> tuple[Train, list[tuple]]:
        shafts = [f"s{i}" for i in range(rng.randint(3, 6))]
        sets = []
        for _ in range(rng.randint(1, 3)):
            sun, planet = rng.randint(18, 50), rng.randint(15, 40)
            sets.append((*rng.sample(shafts, 3), sun, planet))
        ends = [(a, b) for i, a in enumerate([HOUSING, *shafts])
                for b in [HOUSING, *shafts][i + 1:]]
        chosen = rng.sample(ends, min(len(ends), rng.randint(2, 5)))
        input_, output = rng.sample(shafts, 2)
        train = Train(
            shafts=shafts,
            sets=[simple_set(s, r, c, (n, n + 2 * p)) for s, r, c, n, p in sets],
            elements={f"E{i}": ends for i, ends in enumerate(chosen)},
            input=input_, output=output)
        return train, sets

    def text(self, train: Train, sets: list[tuple]) -> str:
        lines = [f"  b_{s}: {{type: revolute, bodies: [housing, {s}], at: [0, 0]}}"
                 for s in train.shafts]
        for i, (sun, ring, carrier, n, p) in enumerate(sets):
            lines += [
                f"  p{i}: {{type: revolute, bodies: [{carrier}, planet{i}], "
                f"at: [0, {n + p}/2]}}",
                f"  g{i}: {{type: gear, bodies: [{sun}, planet{i}], at: [0, {n}/2], "
                "line_of_action: [-cos(20 deg), sin(20 deg)]}",
                f"  h{i}: {{type: gear, bodies: [{ring}, planet{i}], at: [0, {n + 2 * p}/2], "
                "line_of_action: [-cos(20 deg), -sin(20 deg)], internal: true}"]
        lines += [f"  {name}: {{type: {'brake' if HOUSING in ends else 'clutch'}, "
                  f"bodies: [{ends[0]}, {ends[1]}], at: [0, 0]}}"
                  for name, ends in train.elements.items()]
        planets = [f"planet{i}" for i in range(len(sets))]
        return "\n".join([
            "kinestat: 1", "space: planar", "ground: housing",
            f"bodies: [{', '.join(train.shafts + planets)}]", "couplings:", *lines,
            f"actuators: {{in: {{coupling: b_{train.input}}}, "
            f"out: {{coupling: b_{train.output}}}}}",
            f"shift: {{input: in, output: out, elements: [{', '.join(train.elements)}], "
            f"input_action: {self.TORQUE}}}", ""])

    def test_are_those_of_willis(self) -> None:
        kinds: list[str] = []
        for seed in SEEDS:
            with self.subTest(seed=seed):
                train, sets = self.draw(random.Random(seed))
                done = program.call("shift", "--one-more", "--one-fewer", "-",
                                    text=self.text(train, sets))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertLessEqual(set(re.findall(r"\[(\w+)\]:", done.stderr)),
                                     {"W0506", "W0711", "W0601"})
                kinds += self.check_shift(train, program.report(done)["shift"], self.TORQUE)
        for kind in ("gear", "neutral", "locked", "tie-up"):
            self.assertGreater(kinds.count(kind), len(SEEDS) // 4, kind)


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
