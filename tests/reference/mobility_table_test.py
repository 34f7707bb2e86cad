#!/usr/bin/env python3
"""Checks the program against the counts that tables of davies.json collect from the sources.

Usage: mobility_table_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import random
import sys
import unittest

import program
from reference_case import CASES, TABLES, ReferenceCase

# Tab. 3.3 of Alves 2023, two pulleys with slip between two blocks: the cables c, d, e, the slides
# f, g of the blocks, the bearings h, i of the pulleys and a, b of the virtual links.
TWO_PULLEYS = """\
kinestat: 1
ground: frame
bodies: [link1, link2, pulley3, pulley4, block5, block6]
couplings:
  a: {type: revolute, bodies: [pulley3, link1], at: [3, 10, 0], axis: z}
  b: {type: revolute, bodies: [pulley4, link2], at: [13, 10, 0], axis: z}
  c: {type: cable, bodies: [block5, link1], from: [0, 0, 0], to: [0, 10, 0]}
  d: {type: cable, bodies: [link1, link2], from: [3, 13, 0], to: [13, 13, 0]}
  e: {type: cable, bodies: [link2, block6], from: [16, 10, 0], to: [16, 0, 0]}
  f: {type: prismatic, bodies: [frame, block5], axis: y}
  g: {type: prismatic, bodies: [frame, block6], axis: y}
  h: {type: revolute, bodies: [frame, pulley3], at: [3, 10, 0], axis: z}
  i: {type: revolute, bodies: [frame, pulley4], at: [13, 10, 0], axis: z}
"""


def instrument() -> str:
    """The surgical instrument of Tabs. 3.6 and 3.7, at points and along axes in general position.

    The source prints the pairs and not their places.
    """
    table = TABLES["alves_3.6_3.7"]
    source = random.Random(37)

    def place() -> str:
        return "[" + ", ".join(str(source.randint(-99, 99)) for _ in "xyz") + "]"

    lines = ["kinestat: 1", "ground: body_0",
             f"bodies: [{', '.join(f'body_{i}' for i in range(1, table['bodies']))}]", "couplings:"]
    for i, (tail, head) in enumerate(table["P_V"]):
        lines.append(f"  r{i}: {{type: revolute, bodies: [body_{tail}, body_{head}], "
                     f"at: {place()}, axis: {place()}}}")
    for i, (tail, head) in enumerate(table["P_I"]):
        lines.append(f"  c{i}: {{type: cable, bodies: [body_{tail}, body_{head}], "
                     f"from: {place()}, to: {place()}}}")
    return "\n".join(lines) + "\n"


def reference(name: str) -> str:
    return ReferenceCase(CASES[name]).text()


class Grubler(unittest.TestCase):
    """M = lambda (n - 1 - j) + sum f of Alves 2023, Eqs. 3.1 to 3.8, and that it is the freedom."""

    TEXTS = {"3.1": reference("alves_eq3.1"), "3.2": reference("alves_eq3.2"), "3.4": TWO_PULLEYS,
             "3.5": reference("alves_eq3.5"), "3.6": reference("alves_eq3.6"),
             "3.7": instrument(), "3.8": reference("alves_davies_matroid_3_6_10")}

    def test_equations_3_1_to_3_8(self) -> None:
        self.assertEqual(set(self.TEXTS), set(TABLES["grubler"]))
        for equation, expected in TABLES["grubler"].items():
            with self.subTest(equation):
                report = program.run("analyze", "-", text=self.TEXTS[equation])
                counts = report["mobility"]["planar" if expected["lam"] == 3 else "spatial"]
                graph = report["graph"]
                self.assertEqual(counts["order"], expected["lam"])
                self.assertEqual(len(graph["bodies"]), expected["n"])
                self.assertEqual(len(graph["couplings"]), expected["j"])
                self.assertEqual(len(graph["chords"]), expected["l"])
                self.assertEqual(counts["gross_freedom"], expected["f"])
                count = counts["gross_freedom"] - expected["lam"] * len(graph["chords"])
                self.assertEqual(count, expected["M"])
                self.assertEqual(counts["net_freedom"], expected["M"])
                self.assertEqual(counts["net_constraint"], 0)

    def test_instrument_has_twelve_circuits(self) -> None:
        """The source says fourteen above Fig. 3.26; e - n + 1 = 37 - 26 + 1."""
        table = TABLES["alves_3.6_3.7"]
        graph = program.run("analyze", "-", text=self.TEXTS["3.7"])["graph"]
        self.assertEqual(len(graph["bodies"]), table["bodies"])
        self.assertEqual(len(graph["couplings"]), table["couplings"])
        self.assertEqual(len(graph["chords"]), table["independent_circuits"])
        self.assertEqual(table["seed_says"], 14)
        degrees = [sum(body["name"] in c["bodies"] for c in graph["couplings"])
                   for body in graph["bodies"]]
        self.assertEqual(degrees[0], table["fixed_degree"])
        self.assertEqual(degrees[1:].count(3), table["ternary"])
        self.assertEqual(degrees[1:].count(2), table["binary"])


class Reshetov(unittest.TestCase):
    """The exact counts beside the tables of Reshetov, which are to come."""

    CASES_OF_TABLES = {"planar RRRR": "fourbar3d_RRRR", "CSRR": "fourbar3d_CSRR",
                       "slider-crank RRRP": "slider_crank", "Sarrus": "sarrus6R"}

    def test_exact_counts(self) -> None:
        for table in TABLES["reshetov_single_loop"]:
            with self.subTest(table["name"]):
                text = reference(self.CASES_OF_TABLES[table["name"]])
                counts = program.run("analyze", "-", text=text)["mobility"]["spatial"]
                self.assertEqual(counts["net_freedom"], table["exact"]["M"])
                self.assertEqual(counts["net_constraint"], table["exact"]["redundant"])
                # Here the tables are right: Alves 2023, section 2.2 says 2 for the planar RRRR.
                for key, count in (("mobility", "net_freedom"), ("redundant", "net_constraint")):
                    self.assertEqual(counts[count], table["result"][key])


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
