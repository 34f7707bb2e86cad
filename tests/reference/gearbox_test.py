#!/usr/bin/env python3
"""Checks the program against the gearboxes of davies.json, gear by gear.

Usage: gearbox_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import sys
import unittest

import program
from reference_case import CASES, ReferenceCase
from reference_test_case import ReferenceTest


class PublishedRatios(ReferenceTest):
    """Simpson (Chrysler A727) and Lepelletier (ZF 6HP26)."""

    # What the catalogues print; the reference has those of the 6HP26 as numbers.
    A727 = {"1": "2.45", "2": "1.45", "3": "1.00", "R": "-2.20"}

    def ratios(self, name: str, inputs: dict[str, str], output: str) -> dict[str, float]:
        model = ReferenceCase(CASES[name])
        kinematics = model.expected["kinematics"]
        lines = [model.motion(f"gear {one['name']}", one["primary"],
                              f", input: {inputs[one['name']]}, output: {output}")
                 for one in kinematics]
        cases = program.run("analyze", "-", text=model.text("\n".join(lines)))["cases"]
        return {one["name"]: cases[f"gear {one['name']}"]["ratio"] for one in kinematics}

    def check(self, actual: dict[str, float], name: str) -> None:
        expected = CASES[name]["expected"]["ratios"]
        self.assertEqual(set(actual), set(expected))
        self.near_each(actual, {gear: ratio["x"] for gear, ratio in expected.items()})

    def test_simpson(self) -> None:
        inputs = {"1": "R1_Tr1", "2": "R1_Tr1", "3": "R1_Tr1", "R": "S_Ts"}
        ratios = self.ratios("simpson", inputs, "O_Tout")
        self.check(ratios, "simpson")
        for gear, printed in self.A727.items():
            self.assertLessEqual(abs(ratios[gear] - float(printed)), 0.005, gear)

    def test_lepelletier(self) -> None:
        ratios = self.ratios("lepelletier_6hp26", dict.fromkeys("123456R", "IN_Tin"), "O_Tout")
        self.check(ratios, "lepelletier_6hp26")
        expected = CASES["lepelletier_6hp26"]["expected"]
        for gear, printed in expected["published"].items():
            self.assertLessEqual(abs(ratios[gear] - printed), 0.0005, gear)

    def test_engaged_elements_of_lepelletier(self) -> None:
        """The elements that the shift table names are those without slip, and no other."""
        case = CASES["lepelletier_6hp26"]["expected"]
        coupling = {"A": "A.w", "B": "B.w", "C": "SL.w", "D": "CR.w", "E": "E.w"}
        for one in case["kinematics"]:
            engaged = [e for e, label in coupling.items() if one["solution"][label]["x"] == 0.0]
            self.assertEqual(engaged, case["shift"][one["name"]])


class ShiftPossibilities(ReferenceTest):
    """All six pairs of shift elements of the Ravigneaux transmission with its input shaft."""

    ELEMENTS = {"C1": "C1.w", "C2": "C2.w", "B1": "b.w", "B2": "e.w"}
    TORQUES = {"TC1": "C1.TC1", "TC2": "C2.TC2", "TB1": "b.TB1", "TB2": "e.TB2",
               "Tin": "IN.Tin", "Tout": "d.Tout"}

    @classmethod
    def setUpClass(cls) -> None:
        cls.model = ReferenceCase(CASES["ravigneaux_input_body"])
        cls.pairs = cls.model.expected["shift_possibilities"]
        cls.primaries = cls.model.expected["kin_primaries"]

    def known_torques(self, pair: dict) -> dict[str, int]:
        """The input torque 1, and none on the elements that are open."""
        engaged = pair["pair"].split("+")
        open_ = [e for e in self.ELEMENTS if e not in engaged]
        return {"IN.Tin": 1, **{self.TORQUES[f"T{e}"]: 0 for e in open_}}

    def analyze(self, line: str) -> tuple[int, str, dict]:
        done = program.call("analyze", "-", text=self.model.text(line))
        return done.returncode, done.stderr, program.report(done)

    def check_motion(self, number: str, result: dict) -> None:
        expected = self.pairs[number]["kin"]
        self.assertEqual(len(expected), 14)
        actual = {k: self.model.rate(f"{k}.w", result["freedoms"]) for k in expected}
        self.near_each(actual, {k: rate["x"] for k, rate in expected.items()})

    def check_torques(self, number: str, result: dict) -> None:
        expected = self.pairs[number]["torques"]
        self.assertEqual(set(expected), set(self.TORQUES))
        actual = {k: result["actions"][self.model.action(self.TORQUES[k])] for k in expected}
        self.near_each(actual, {k: torque["x"] for k, torque in expected.items()})

    def test_gears(self) -> None:
        gears = [number for number, pair in self.pairs.items() if pair["feasible"]]
        self.assertEqual(gears, ["1", "2", "3", "5"])
        for number in gears:
            with self.subTest(self.pairs[number]["pair"]):
                motion = self.model.motion("m", self.primaries[number],
                                           ", input: IN_Tin, output: d_Tout")
                action = self.model.actions("a", self.known_torques(self.pairs[number]))
                status, errors, report = self.analyze(motion + "\n" + action)
                self.assertEqual((status, errors), (0, ""))
                self.check_motion(number, report["cases"]["m"]["kinematics"])
                self.check_torques(number, report["cases"]["a"]["statics"])
                self.near(report["cases"]["m"]["ratio"],
                          self.pairs[number]["ratio_i"]["x"], "ratio")

    def test_c2_with_b1_holds_the_input(self) -> None:
        """No motion is possible, as the input turns and is held; the torques balance."""
        status, errors, _ = self.analyze(self.model.motion("m", self.primaries["4"]))
        self.assertEqual(self.pairs["4"]["kin_error"], "inconsistent")
        self.assertEqual(status, 3, errors)
        self.assertIn("error[E05", errors)
        action = self.model.actions("a", self.known_torques(self.pairs["4"]))
        status, errors, report = self.analyze(action)
        self.assertEqual(status, 0, errors)
        self.check_torques("4", report["cases"]["a"]["statics"])

    def test_b1_with_b2_leaves_the_input_free(self) -> None:
        """The train stands still while the input turns; nothing balances the input torque."""
        status, errors, report = self.analyze(self.model.motion("m", self.primaries["6"]))
        self.assertEqual(status, 0, errors)
        self.check_motion("6", report["cases"]["m"]["kinematics"])
        action = self.model.actions("a", self.known_torques(self.pairs["6"]))
        status, errors, _ = self.analyze(action)
        self.assertEqual(self.pairs["6"]["stat_error"], "inconsistent")
        self.assertEqual(status, 5, errors)
        self.assertIn("error[E0602]", errors)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
