#!/usr/bin/env python3
"""Checks the Ravigneaux transmission of the library against exact and printed values.

Usage: reference_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import re
import sys
import unittest
from pathlib import Path

import printed
import program
from program import run
from reference_case import CASES, TABLES
from reference_test_case import ReferenceTest

TRUNCATED = 1e-3
MECHANISMS = Path()


class Ravigneaux(ReferenceTest):
    """The mechanism file of the library against exact and printed values."""

    POSITIONS = "bcdfghijk"

    @classmethod
    def setUpClass(cls) -> None:
        cls.path = str(MECHANISMS / "transmissions" / "ravigneaux.yaml")
        cls.report = run("analyze", cls.path)
        cls.gears = CASES["ravigneaux_seed"]["expected"]["gears"]
        zero = [a for p in cls.POSITIONS for a in ("--set", f"{p}_z=0 m")]
        cls.at_zero = run("analyze", *zero, cls.path)
        cls.at_one = {p: run("analyze", *zero, "--set", f"{p}_z=1 m", cls.path)
                      for p in cls.POSITIONS}

    @staticmethod
    def action(label: str) -> str:
        coupling, name = label.split(".")
        return {"TC1": "C1", "TC2": "C2", "TB1": "B1", "TB2": "B2", "Tout": "out"}.get(
            name, f"{coupling}.{name}")

    def test_exact_rates(self) -> None:
        for gear, expected in self.gears.items():
            result = self.report["cases"][gear]
            self.near(result["ratio"], expected["ratio_i"]["x"], gear)
            self.near(result["torque_ratio"], expected["Gamma"]["x"], gear)
            for coupling, rate in expected["kinematics"].items():
                self.near(result["kinematics"]["freedoms"][f"{coupling}.wz"], rate["x"],
                          f"{gear} {coupling}")

    def test_exact_actions_at_the_sample_positions(self) -> None:
        for gear, expected in self.gears.items():
            actions = self.report["cases"][gear]["statics"]["actions"]
            self.assertEqual(len(expected["statics"]), 39)
            largest = max(abs(a["value_at_z_sample_Tin100"]) for a in expected["statics"].values())
            for label, action in expected["statics"].items():
                self.near(actions[self.action(label)], action["value_at_z_sample_Tin100"],
                          f"{gear} {label}", largest)

    def test_exact_powers(self) -> None:
        for gear, expected in self.gears.items():
            power = self.report["cases"][gear]["power"]
            self.assertLess(power["balance_residual"], 1e-12)
            for coupling, watt in expected["power_into_head_W"].items():
                self.near(power["couplings"][coupling], watt["x"], f"{gear} {coupling}", 100)

    def test_exact_flow_of_power(self) -> None:
        """Each arc from its source to its sink, as many as there are and none beside them."""
        ends = {c["name"]: (str(c["tail"]), str(c["head"]))
                for c in CASES["ravigneaux_seed"]["couplings"]}
        for gear, expected in self.gears.items():
            actual = {}
            for coupling, watt in self.report["cases"][gear]["power"]["couplings"].items():
                tail, head = ends[coupling]
                if watt != 0.0:
                    actual[coupling] = (tail, head) if watt > 0.0 else (head, tail)
            arcs = {arc["coupling"]: arc for arc in expected["flow"]}
            self.assertEqual(actual, {k: (arc["frm"], arc["to"]) for k, arc in arcs.items()}, gear)
            watts = self.report["cases"][gear]["power"]["couplings"]
            self.near_each({coupling: abs(watts[coupling]) for coupling in arcs},
                           {coupling: arc["W"]["x"] for coupling, arc in arcs.items()})

    def test_exact_motion_of_the_bodies(self) -> None:
        names = dict(zip("123456", ("sun1", "sun2", "ring", "carrier", "planet5", "planet6")))
        for gear, expected in self.gears.items():
            for number, motion in expected["body_absolute"].items():
                body = self.report["cases"][gear]["kinematics"]["bodies"][names[number]]
                self.near_all(body["angular"], [0.0, 0.0, motion["w_z"]["x"]])
                self.near_all(body["linear"], [motion["V_x_at_bearing"]["x"], 0.0, 0.0])
                self.near_all(body["twist"][3:], [motion["v_x_at_origin"]["x"], 0.0, 0.0])

    def test_truth_table_5_15(self) -> None:
        """Ratios, torque ratios, and the steps between gears that follow each other."""
        lower = None
        for row in TABLES["truth_table_5_15"]:
            result = self.report["cases"][row["gear"]]
            self.near(result["ratio"], row["i"]["x"], row["gear"])
            self.near(result["torque_ratio"], row["Gamma"]["x"], row["gear"])
            if row["step"] is not None:
                self.near(lower / result["ratio"], row["step"]["x"], f"step to {row['gear']}")
            lower = result["ratio"]

    def test_affine_moments(self) -> None:
        """Moments are affine in each position: the difference to all-zero is the coefficient."""
        for gear, expected in self.gears.items():
            for label, action in expected["statics"].items():
                name = self.action(label)
                base = self.at_zero["cases"][gear]["statics"]["actions"][name]
                coefficients = action["coeff_double_Tin100"]
                self.near(base, coefficients.get("1", 0.0), f"{gear} {label}", 1000)
                for p in self.POSITIONS:
                    moved = self.at_one[p]["cases"][gear]["statics"]["actions"][name]
                    self.near(moved - base, coefficients.get(f"{p}_z", 0.0),
                              f"{gear} {label} d/d{p}_z", 1000)

    def test_affine_dependence_in_the_report(self) -> None:
        """The file leaves the positions free: the report says how every moment depends on them."""
        for gear, expected in self.gears.items():
            affine = self.report["cases"][gear]["affine"]
            seen = set()
            for label, action in expected["statics"].items():
                name = self.action(label)
                coefficients = {key: value for key, value in action["coeff_double_Tin100"].items()
                                if value != 0.0}
                if not any(key != "1" for key in coefficients):
                    self.assertNotIn(name, affine, gear)
                    continue
                seen.add(name)
                self.assertEqual(set(affine[name]), {"1", *coefficients}, f"{gear} {name}")
                for key, value in affine[name].items():
                    self.near(value, coefficients.get(key, 0.0), f"{gear} {name} {key}", 100)
            self.assertEqual(set(affine), seen, gear)

    def test_affine_dependence_as_annex_c_prints_it(self) -> None:
        for gear, couplings in printed.WRENCHES.items():
            affine = self.report["cases"][gear]["affine"]
            for coupling, texts in couplings.items():
                for i in range(2):
                    entry = affine.get(f"{coupling}.T{'xy'[i]}", {})
                    expected = {f"{p}_z" if p else "1": number
                                for p, number in self.coefficients(texts[i]).items()}
                    if expected == {"1": "0"}:
                        self.assertEqual(entry, {}, f"{gear} {coupling}")
                        continue
                    self.assertEqual(set(entry) - {"1"}, set(expected), f"{gear} {coupling}")
                    for key, number in expected.items():
                        self.digits(entry[key], number, f"{gear} {coupling} {key}")

    def test_rates_of_equations_5_51_to_5_70(self) -> None:
        for gear, rates in printed.RATES.items():
            for coupling, rate in rates.items():
                actual = self.report["cases"][gear]["kinematics"]["freedoms"][f"{coupling}.wz"]
                self.assertLess(abs(actual - rate), TRUNCATED, f"{gear} {coupling}")

    def test_bodies_of_annex_c_and_tables_d_1_to_d_4(self) -> None:
        for gear, bodies in printed.BODIES.items():
            for body, (wz, vx) in bodies.items():
                result = self.report["cases"][gear]["kinematics"]["bodies"][body]
                self.digits(result["angular"][2], wz, f"{gear} {body} wz")
                self.digits(result["linear"][0], vx, f"{gear} {body} Vx")

    def digits(self, actual: float, text: str, what: str) -> None:
        """Equal to the digits printed: half a unit of the last one."""
        decimals = len(text.partition(".")[2])
        self.assertLessEqual(abs(actual - float(text)), 0.5 * 10.0**-decimals * (1 + 1e-9),
                             f"{what}: {actual} is not {text}")

    def coefficients(self, text: str) -> dict[str, str]:
        terms = re.findall(r"([+-]?[\d.]+)([a-k]?)", text)
        return {position: number for number, position in terms}

    def moment(self, report: dict, gear: str, coupling: str, i: int) -> float:
        return report["cases"][gear]["statics"]["couplings"][coupling]["moment"][i]

    def slopes(self, gear: str, coupling: str, i: int) -> dict[str, float]:
        base = self.moment(self.at_zero, gear, coupling, i)
        return {p: self.moment(self.at_one[p], gear, coupling, i) - base for p in self.POSITIONS}

    def check_moment(self, gear: str, coupling: str, i: int, text: str) -> None:
        expected = self.coefficients(text)
        what = f"{gear} {coupling} T{'xyz'[i]}"
        self.digits(self.moment(self.at_zero, gear, coupling, i), expected.get("", "0"), what)
        for p, slope in self.slopes(gear, coupling, i).items():
            if p in expected:
                self.digits(slope, expected[p], f"{what} {p}_z")
            else:
                self.near(slope, 0.0, f"{what} {p}_z", 1000)

    def test_wrenches_of_annex_c(self) -> None:
        for gear, couplings in printed.WRENCHES.items():
            self.assertEqual(len(couplings), 11)
            for coupling, texts in couplings.items():
                for i in range(3):
                    self.check_moment(gear, coupling, i, texts[i])
                force = self.report["cases"][gear]["statics"]["couplings"][coupling]["force"]
                self.digits(force[0], texts[3], f"{gear} {coupling} Fx")
                self.digits(force[1], texts[4], f"{gear} {coupling} Fy")
                self.assertEqual(force[2], 0.0)

    def test_twelve_moments_of_annex_d_are_wrong(self) -> None:
        wrong = 0
        for gear, entries in printed.ERRATA_ANNEX_D.items():
            for (coupling, i), text in entries.items():
                slopes = self.slopes(gear, coupling, i)
                expected = self.coefficients(text)
                for p in "fi":
                    self.assertGreater(abs(slopes[p] - float(expected[p])), 1.0,
                                       f"{gear} {coupling}")
                wrong += 1
        self.assertEqual(wrong, 12)

    def test_graph_and_network_matrices(self) -> None:
        matrices = run("graph", "--matrices", self.path)["graph"]["matrices"]
        expected = CASES["ravigneaux_seed"]["expected"]
        for symbol, rows in (("Q", "Q_rows"), ("B", "B_rows")):
            matrix = matrices[symbol]
            self.assertEqual(matrix["rows"], expected[rows])
            self.assertEqual(matrix["columns"], list("abcefgdhijk"))
            order = [matrix["columns"].index(c) for c in "abcdefghijk"]
            self.assertEqual([[row[c] for c in order] for row in matrix["values"]],
                             expected[f"{symbol}_columns_a..k"])
        self.assertEqual((len(matrices["M_N"]["rows"]), len(matrices["M_N"]["columns"])), (10, 11))
        self.assertEqual((len(matrices["A_N"]["rows"]), len(matrices["A_N"]["columns"])), (36, 39))
        echelon = matrices["M_N_echelon"]["values"]
        self.assertEqual(sum(any(row) for row in echelon), 9)

    def test_echelon_form_of_equation_5_44_with_its_erratum(self) -> None:
        """Row 7: w_h + f_y/h_y w_i - f_y k_y/(g_y h_y) w_k; printed with + (Eqs. 5.40, 5.44)."""
        result = self.report["cases"]["M2"]["kinematics"]["freedoms"]
        f, g, h, k = 17.0, 31.5, 9.5, 42.5
        right = result["h.wz"] + f / h * result["i.wz"] - f * k / (g * h) * result["k.wz"]
        as_printed = result["h.wz"] + f / h * result["i.wz"] + f * k / (g * h) * result["k.wz"]
        self.near(right, 0.0, "row 7")
        self.near(as_printed, 697 / 248, "row 7 as printed")

    def test_order_five_without_axial_forces(self) -> None:
        """Line of 5.4: without R_z the statics have 30 equations and 33 unknowns."""
        text = Path(self.path).read_text(encoding="utf-8")
        text = re.sub(r"(type: revolute.*axis: z)}", r"\1, passive: [Rx, Ry, Tx, Ty]}", text)
        text = text[: text.index("published:")]
        report = run("graph", "--matrices", "-", text=text)
        matrix = report["graph"]["matrices"]["A_N"]
        self.assertEqual((len(matrix["rows"]), len(matrix["columns"])), (30, 33))
        statics = run("analyze", "-", text=text)["mobility"]["minimal"]["statics"]
        self.assertEqual((statics["order"], statics["rank"]), (5, 30))


class InputShaft(ReferenceTest):
    """The transmission with its input shaft: every gear without a special case."""

    GEARS = {"M1": "2", "M2": "1", "M3": "3", "MR": "5"}

    def test_rates_and_torques(self) -> None:
        report = run("analyze", str(MECHANISMS / "transmissions" / "ravigneaux_input_shaft.yaml"))
        possibilities = CASES["ravigneaux_input_body"]["expected"]["shift_possibilities"]
        names = {"e": "B2", "IN": "s"}
        for gear, number in self.GEARS.items():
            result = report["cases"][gear]
            expected = possibilities[number]
            self.near(result["ratio"], expected["ratio_i"]["x"], gear)
            for coupling, rate in expected["kin"].items():
                name = names.get(coupling, coupling)
                self.near(result["kinematics"]["freedoms"][f"{name}.wz"], rate["x"], name)
            for torque, value_ in expected["torques"].items():
                action = result["statics"]["actions"][torque[1:]]
                self.near(action / 100, value_["x"], f"{gear} {torque}")

    def test_net_freedom_is_three(self) -> None:
        report = run("analyze", str(MECHANISMS / "transmissions" / "ravigneaux_input_shaft.yaml"))
        self.assertEqual(report["mobility"]["minimal"]["net_freedom"], 3)
        counts = CASES["ravigneaux_input_body"]["expected"]["stat_counts"]
        self.assertEqual(report["mobility"]["minimal"]["statics"]["gross_constraint"], counts["C"])
        self.assertEqual(report["mobility"]["minimal"]["statics"]["rank"], counts["a"])


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
