#!/usr/bin/env python3
"""Checks the mechanisms with ropes of the library against the tables that Alves 2023 prints.

Usage: cable_mechanism_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import sys
import unittest
from pathlib import Path

import program
from reference_test_case import ReferenceTest

MECHANISMS = Path()


class CableTension(ReferenceTest):
    """What `inputs` says pulls on every segment, put into a case, does so."""

    FILES = ("pulley", "pulley_without_slip", "two_pulleys", "block_and_tackle", "weston_hoist")

    def test_drives_pull_on_every_segment(self) -> None:
        for name in self.FILES:
            with self.subTest(name):
                text = (MECHANISMS / "cables" / f"{name}.yaml").read_text(encoding="utf-8")
                ropes = program.run("inputs", "-", text=text)["inputs"]["cables"]
                self.assertTrue(ropes["possible"])
                self.assertGreater(len(ropes["drives"]), 1)
                pulled = self.with_drives(text, ropes["drives"])
                actions = program.run("analyze", "-", text=pulled)["cases"]["in tension"]["statics"]
                tensions = [value for key, value in actions["actions"].items()
                            if key.endswith(".F")]
                self.assertEqual(len(tensions), ropes["segments"])
                self.near(min(tensions), 1.0, "least tension")

    @staticmethod
    def with_drives(text: str, drives: dict[str, float]) -> str:
        """The bodies and cables of the file with these actuators alone."""
        start = text[:text.index("\nactuators:")]
        names = list(drives)
        lines = ["actuators:"]
        for i, name in enumerate(names):
            coupling, freedom = name.split(".")
            lines.append(f"  T{i}: {{coupling: {coupling}, freedom: {freedom}}}")
        known = ", ".join(f"T{i}: {drives[name]}" for i, name in enumerate(names[:1]))
        return "\n".join([start, *lines, "cases:", f"  in tension: {{action: {{{known}}}}}", ""])


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
                ropes = program.run("inputs", str(path))["inputs"]["cables"]
                self.assertEqual(ropes["net_freedom"], self.PRINTED[name][-1])
                self.assertEqual(ropes["without_slip"], self.PRINTED[name][-1] - pulleys)


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
