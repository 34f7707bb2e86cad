#!/usr/bin/env python3
"""Holds the program against exact values and against what the source prints.

Usage: reference_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import unittest
from fractions import Fraction
from pathlib import Path

import printed

HERE = Path(__file__).parent
EXACT = 1e-12
TRUNCATED = 1e-3
PROGRAM = ""
MECHANISMS = Path()
CASES = {case["id"]: case for case in json.loads((HERE / "davies.json").read_text())["cases"]}


def run(command: str, *arguments: str, text: str | None = None) -> dict:
    done = subprocess.run(
        [PROGRAM, command, "--format", "json", *arguments],
        input=text, capture_output=True, text=True, check=False,
    )
    if done.returncode != 0:
        raise AssertionError(f"status {done.returncode}\n{done.stderr}\n{text or ''}")
    return json.loads(done.stdout)


# A reference case as a mechanism file.

def value(text: object) -> str:
    """Fractions and functions of degrees are expressions of the file."""
    return re.sub(r"(\d)deg", r"\1 deg", str(text))


def vector(components: list) -> str:
    return "[" + ", ".join(value(c) for c in components) + "]"


def axis_of(components: list) -> str:
    """A keyword along a world axis, so that the names are those of the reference."""
    for letter, unit in (("x", ["1", "0", "0"]), ("y", ["0", "1", "0"]), ("z", ["0", "0", "1"])):
        if components == unit:
            return letter
    return vector(components)


def coupling_line(coupling: dict, planar: bool) -> str:
    size = 2 if planar else 3
    keys = {"R": "revolute", "P": "prismatic", "G": "gear", "TQ": "revolute"}
    line = (f"  {coupling['name']}: {{type: {keys[coupling['type']]}, "
            f"bodies: [body_{coupling['tail']}, body_{coupling['head']}], "
            f"at: {vector(coupling['point'][:size])}")
    if coupling["type"] == "P" or not planar:
        line += f", axis: {axis_of(coupling['axis'])}"
    if coupling["type"] == "G":
        line += f", line_of_action: {vector(coupling['normal'][:size])}"
    if coupling["type"] == "TQ":
        line += ", passive: []"
    return line + "}"


def actuator_name(coupling: str, action: str) -> str:
    return f"{coupling}_{action}"


def mechanism_text(case: dict, cases: str = "") -> str:
    planar = case["lambda"] == 3
    bodies = [f"body_{b}" for b in case["bodies"][1:]]
    lines = ["kinestat: 1", f"space: {'planar' if planar else 'spatial'}",
             f"ground: body_{case['bodies'][0]}", f"bodies: [{', '.join(bodies)}]", "couplings:"]
    lines += [coupling_line(c, planar) for c in case["couplings"]]
    actuators = [(c["name"], a["name"]) for c in case["couplings"] for a in c.get("active", [])]
    if actuators:
        lines.append("actuators:")
        lines += [f"  {actuator_name(c, a)}: {{coupling: {c}}}" for c, a in actuators]
    return "\n".join(lines) + "\n" + cases


def freedom_name(case: dict, label: str) -> str:
    """a.w of the reference is a.wz or, along a vector, a.w; a clutch of the reference turns too."""
    name, kind = (label.split(".") + ["w"])[:2]
    coupling = next(c for c in case["couplings"] if c["name"] == name)
    axis = axis_of(coupling["axis"])
    return f"{name}.{kind}{axis if len(axis) == 1 else ''}"


def axis_length(case: dict, label: str) -> float:
    """The reference uses axes as given; the program normalises them."""
    coupling = next(c for c in case["couplings"] if c["name"] == label.split(".")[0])
    return sum(float(Fraction(x)) ** 2 for x in coupling["axis"]) ** 0.5


def action_name(case: dict, label: str) -> str:
    name, action = label.split(".")
    coupling = next(c for c in case["couplings"] if c["name"] == name)
    is_active = action in [a["name"] for a in coupling.get("active", [])]
    return actuator_name(name, action) if is_active else label


def solution_case(case: dict, side: str, primary: dict) -> str:
    if side == "kinematics":
        known = ", ".join(
            f"{freedom_name(case, k)}: {float(Fraction(v)) * axis_length(case, k)!r}"
            for k, v in primary.items())
        return f"cases: {{test: {{motion: {{{known}}}}}}}\n"
    known = ", ".join(f"{action_name(case, k)}: {v}" for k, v in primary.items())
    return f"cases: {{test: {{action: {{{known}}}}}}}\n"


class ReferenceTest(unittest.TestCase):
    def near(self, actual: float, expected: float, what: str, scale: float = 1.0) -> None:
        self.assertLessEqual(
            abs(actual - expected), EXACT * max(1.0, scale), f"{what}: {actual} is not {expected}")


class Generated(ReferenceTest):
    """Every case of the reference as a file of its own, made from its data."""

    def check_counts(self, actual: dict, expected: dict, what: str) -> None:
        self.assertEqual(actual["gross_freedom"], expected["F"], what)
        self.assertEqual(actual["rank"], expected["m"], what)
        self.assertEqual(actual["net_freedom"], expected["FN_kin"], what)
        self.assertEqual(actual["net_constraint"], expected["CN_kin"], what)
        if "a" in expected:
            self.assertEqual(actual["statics"]["gross_constraint"], expected["C"], what)
            self.assertEqual(actual["statics"]["rank"], expected["a"], what)
            self.assertEqual(actual["statics"]["net_constraint"], expected["CN_stat"], what)
            self.assertEqual(actual["statics"]["net_freedom"], expected["FN_stat"], what)

    def check_all_counts(self, case: dict) -> None:
        orders = {3: "planar", 6: "spatial"}
        expected = case["expected"]
        mobility = run("analyze", "-", text=mechanism_text(case))["mobility"]
        if "counts" in expected:
            self.check_counts(mobility[orders[case["lambda"]]], expected["counts"], case["id"])
        if "counts_lambda6" in expected:
            self.check_counts(mobility["spatial"], expected["counts_lambda6"], case["id"])
        for order, counts in expected.get("kin_counts", {}).items():
            name = {"2": "minimal"}.get(order, orders.get(int(order)))
            actual = mobility[name]
            self.assertEqual(actual["rank"], counts["m"], name)
            self.assertEqual(actual["net_freedom"], counts["FN_kin"], name)
            self.assertEqual(actual["net_constraint"], counts["CN_kin"], name)
        if "stat_counts" in expected:
            statics = mobility["minimal"]["statics"]
            counts = expected["stat_counts"]
            self.assertEqual(statics["gross_constraint"], counts["C"])
            self.assertEqual(statics["rank"], counts["a"])
            self.assertEqual(statics["net_constraint"], counts["CN_stat"])
            self.assertEqual(statics["net_freedom"], counts["FN_stat"])

    def check_kinematics(self, case: dict, one: dict) -> None:
        text = mechanism_text(case, solution_case(case, "kinematics", one["primary"]))
        result = run("analyze", "-", text=text)["cases"]["test"]["kinematics"]
        scale = max(abs(v["x"]) for v in one["solution"].values())
        for label, expected in one["solution"].items():
            rate = result["freedoms"][freedom_name(case, label)] / axis_length(case, label)
            self.near(rate, expected["x"], f"{case['id']} {label}", scale)
        for body, twist in one.get("body_twist", {}).items():
            for actual, exact in zip(result["bodies"][f"body_{body}"]["twist"], twist):
                self.near(actual, float(Fraction(exact)), f"{case['id']} body {body}", 100 * scale)

    def check_statics(self, case: dict, one: dict) -> None:
        text = mechanism_text(case, solution_case(case, "statics", one["primary"]))
        result = run("analyze", "-", text=text)["cases"]["test"]["statics"]
        scale = max(abs(v["x"]) for v in one["solution"].values())
        for label, expected in one["solution"].items():
            action = result["actions"][action_name(case, label)]
            self.near(action, expected["x"], f"{case['id']} {label}", scale)

    def test_counts_and_solutions(self) -> None:
        solutions = 0
        for case in CASES.values():
            with self.subTest(case["id"]):
                self.check_all_counts(case)
                for one in case["expected"].get("kinematics", []):
                    self.check_kinematics(case, one)
                    solutions += 1
                for one in case["expected"].get("statics", []):
                    self.check_statics(case, one)
                    solutions += 1
        self.assertGreaterEqual(solutions, 30)

    def test_pulley_network_matrix_is_that_of_equation_3_17(self) -> None:
        case = CASES["alves_davies_maxima_1_2_10"]
        text = mechanism_text(case, "tree: [c1, c2, d1, d2, e, f]\n")
        matrix = run("graph", "--matrices", "-", text=text)["graph"]["matrices"]["M_N"]
        expected = case["expected"]["M_N"]
        labels = [label.split("_")[1] for label in case["expected"]["kin_column_order"]]
        for row, expected_row in zip(matrix["values"], expected, strict=True):
            by_coupling = {c.split(".")[0]: v for c, v in zip(matrix["columns"], row)}
            for label, entry in zip(labels, expected_row):
                self.near(by_coupling[label], float(Fraction(entry)), label)


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
                self.assertGreater(abs(slopes["f"] - float(expected["f"])), 1.0, f"{gear} {coupling}")
                self.assertGreater(abs(slopes["i"] - float(expected["i"])), 1.0, f"{gear} {coupling}")
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
        """Row 7: w_h + f_y/h_y w_i - f_y k_y/(g_y h_y) w_k; the source prints + (Eqs. 5.40, 5.44)."""
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
    PROGRAM = sys.argv[1]
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
