#!/usr/bin/env python3
"""Checks the program against every case of davies.json, each as a file of its own.

Usage: davies_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import sys
import unittest

import program
from reference_case import CASES, ReferenceCase, number
from reference_test_case import ReferenceTest

ORDERS = {2: "minimal", 3: "planar", 6: "spatial"}
MODELS = {name: ReferenceCase(case) for name, case in CASES.items()}


def report_of(model: ReferenceCase) -> dict:
    """The report with all motions k0, k1, … and all actions s0, s1, … of the case."""
    expected = model.expected
    lines = [model.motion(f"k{i}", one["primary"])
             for i, one in enumerate(expected.get("kinematics", []))]
    lines += [model.actions(f"s{i}", one["primary"])
              for i, one in enumerate(expected.get("statics", []))]
    return program.run("analyze", "-", text=model.text("\n".join(lines)))


class Davies(ReferenceTest):
    @classmethod
    def setUpClass(cls) -> None:
        cls.reports = {name: report_of(model) for name, model in MODELS.items()}
        cls.counts = {name: program.run("analyze", "-", text=model.text())
                      for name, model in MODELS.items()}

    def test_all_cases_are_there(self) -> None:
        self.assertEqual(len(CASES), 27)
        solutions = [one for case in CASES.values() for side in ("kinematics", "statics")
                     for one in case["expected"].get(side, [])]
        self.assertEqual(len(solutions), 57)

    def check_graph(self, graph: dict, counts: dict) -> None:
        self.assertEqual(len(graph["bodies"]), counts["n"])
        self.assertEqual(len(graph["couplings"]), counts["e"])
        self.assertEqual(len(graph["tree"]), counts["k"])
        self.assertEqual(len(graph["chords"]), counts["l"])

    def check_motions(self, actual: dict, counts: dict) -> None:
        self.assertEqual(actual["order"], counts["lam"])
        self.assertEqual(actual["gross_freedom"], counts["F"])
        self.assertEqual(actual["rank"], counts["m"])
        self.assertEqual(actual["net_freedom"], counts["FN_kin"])
        self.assertEqual(actual["net_constraint"], counts["CN_kin"])

    def check_actions(self, actual: dict, counts: dict) -> None:
        self.assertEqual(actual["order"], counts["lam"])
        self.assertEqual(actual["gross_constraint"], counts["C"])
        self.assertEqual(actual["rank"], counts["a"])
        self.assertEqual(actual["net_constraint"], counts["CN_stat"])
        self.assertEqual(actual["net_freedom"], counts["FN_stat"])

    def test_counts(self) -> None:
        compared = 0
        for name, model in MODELS.items():
            expected, report = model.expected, self.counts[name]
            mobility = report["mobility"]
            motions = [*expected.get("kin_counts", {}).values()]
            actions = [expected["stat_counts"]] if "stat_counts" in expected else []
            both = [expected[key] for key in ("counts", "counts_lambda6") if key in expected]
            for counts in motions + both:
                with self.subTest(name, order=counts["lam"]):
                    self.check_graph(report["graph"], counts)
                    self.check_motions(mobility[ORDERS[counts["lam"]]], counts)
                    compared += 1
            for counts in actions + both:
                with self.subTest(name, order=counts["lam"]):
                    self.check_actions(mobility[ORDERS[counts["lam"]]]["statics"], counts)
                    compared += 1
        self.assertEqual(compared, 81)

    def test_rates(self) -> None:
        for name, model in MODELS.items():
            for i, one in enumerate(model.expected.get("kinematics", [])):
                with self.subTest(name, case=one["name"]):
                    result = self.reports[name]["cases"][f"k{i}"]["kinematics"]
                    self.assertEqual(result["status"], "solved")
                    actual = {key: model.rate(key, result["freedoms"]) for key in one["solution"]}
                    self.near_each(actual, {k: v["x"] for k, v in one["solution"].items()})

    def test_twists_of_bodies(self) -> None:
        bodies = 0
        for name, model in MODELS.items():
            for i, one in enumerate(model.expected.get("kinematics", [])):
                with self.subTest(name, case=one["name"]):
                    result = self.reports[name]["cases"][f"k{i}"]["kinematics"]["bodies"]
                    twists = {model.body(body): [number(x) for x in twist]
                              for body, twist in one["body_twist"].items()}
                    self.assertEqual(set(result), set(twists))
                    for part in (slice(0, 3), slice(3, 6)):
                        self.near_all([x for b in twists for x in result[b]["twist"][part]],
                                      [x for b in twists for x in twists[b][part]])
                    bodies += len(twists)
        self.assertGreater(bodies, 150)

    def test_actions(self) -> None:
        for name, model in MODELS.items():
            for i, one in enumerate(model.expected.get("statics", [])):
                with self.subTest(name, case=one["name"]):
                    result = self.reports[name]["cases"][f"s{i}"]["statics"]
                    self.assertEqual(result["status"], "solved")
                    self.assertEqual(len(result["actions"]), len(one["solution"]))
                    actual = {key: model.action_value(key, result["actions"])
                              for key in one["solution"]}
                    self.near_each(actual, {k: v["x"] for k, v in one["solution"].items()})

    def test_matrices_of_the_four_bars(self) -> None:
        for name in ("fourbar_1", "fourbar_2"):
            expected = CASES[name]["expected"]
            text = MODELS[name].text()
            matrices = program.run("graph", "--matrices", "-", text=text)["graph"]["matrices"]
            for symbol in "BQ":
                self.assertEqual(matrices[symbol]["columns"], expected["order"])
                self.assertEqual(matrices[symbol]["values"], expected[symbol])

    def test_equations_3_71_and_3_96(self) -> None:
        """The formulas of the source, with the denominator D1 of Eq. 3.90."""
        for name in ("fourbar_1", "fourbar_2"):
            expected, cases = CASES[name]["expected"], self.reports[name]["cases"]
            freedoms = cases["k0"]["kinematics"]["freedoms"]
            self.near_each({key: freedoms[f"{key}.wz"] for key in expected["eq_3_71"]},
                           {key: entry["x"] for key, entry in expected["eq_3_71"].items()})
            actions = cases["s0"]["statics"]["actions"]
            self.near_each({key: actions[MODELS[name].action(key)] for key in expected["eq_3_96"]},
                           {key: entry["x"] for key, entry in expected["eq_3_96"].items()})
            b, c = ([number(x) for x in MODELS[name].couplings[k]["point"]] for k in "bc")
            self.near(actions["b.Rx"] * number(expected["D1"]), b[0] - c[0], "D1")

    def test_motion_matrix_of_the_pulley(self) -> None:
        """Eqs. 3.17 and 3.24 of Alves 2023, and the same with the cables inclined."""
        compared = 0
        for name, model in MODELS.items():
            if "M_N" not in model.expected:
                continue
            text = model.text(head="tree: [c1, c2, d1, d2, e, f]\n")
            matrix = program.run("graph", "--matrices", "-", text=text)["graph"]["matrices"]["M_N"]
            columns = [c.split(".")[0] for c in matrix["columns"]]
            order = [columns.index(label.split("_")[1])
                     for label in model.expected["kin_column_order"]]
            self.assertEqual([[row[i] for i in order] for row in matrix["values"]],
                             [[number(x) for x in row] for row in model.expected["M_N"]])
            compared += 1
        self.assertEqual(compared, 3)

    def test_ropes_of_a_tackle_share_the_load(self) -> None:
        """n falls: the load is n times the hand's force, and every fall has the hand's force."""
        for falls in (1, 2, 3, 4, 6):
            name = f"block_tackle_{falls}"
            actions = self.reports[name]["cases"]["s0"]["statics"]["actions"]
            self.assertEqual(CASES[name]["expected"]["MA"], falls)
            self.near(actions["L_Fl"] / actions["H_Fh"], falls, name)
            for k in range(1, falls + 2):
                self.near(actions[f"k{k}.F"], -actions["H_Fh"], f"{name} tension {k}")

    def test_sarrus_platform_rises(self) -> None:
        """Without turning, with the speed 6 along z, and by one constraint too many."""
        bodies = self.reports["sarrus6R"]["cases"]["k0"]["kinematics"]["bodies"]
        self.assertEqual(bodies["body_3"]["angular"], [0.0, 0.0, 0.0])
        self.near_all(bodies["body_3"]["linear"], [0.0, 0.0, 6.0])

    def test_grubler_where_it_agrees_and_where_not(self) -> None:
        """M = F - lambda l: that of the pulleys is the freedom, Bennett's is -2 instead of 1."""
        for name, model in MODELS.items():
            counts = self.reports[name]["mobility"]["spatial"]
            count = counts["gross_freedom"] - 6 * len(self.reports[name]["graph"]["chords"])
            if "grubler" in model.expected:
                self.assertEqual(count, model.expected["grubler"], name)
                self.assertEqual(counts["net_freedom"], model.expected["grubler"], name)
            if name == "bennett4R":
                self.assertEqual((count, counts["net_freedom"]), (-2, 1))


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
