"""Shared by tests of mechanisms with inertia: the cases of dynamics.json, and tolerances.

The expected rows are there with their mechanisms, by two or three independent methods: Newton
and Euler's equations of each body in forty digits, the reduced equation by virtual power, and a
multibody program.
"""

from __future__ import annotations

import json
import unittest
from pathlib import Path

import program
from motion_case import Motion

DATA = json.loads(Path(__file__).with_name("dynamics.json").read_text(encoding="utf-8"))
CASES = {case["id"]: case for case in DATA["cases"]}
TOLERANCE = 1e-10


def motion_of(case: dict) -> Motion:
    return Motion(program.run("motion", "-", text=case["yaml"]))

class DynamicsCase(unittest.TestCase):
    def near(self, actual: float | None, expected: float, scale: float, what: str) -> None:
        self.assertIsNotNone(actual, what)
        self.assertLessEqual(abs(actual - expected), TOLERANCE * max(scale, 1e-300),
                             f"{what}: {actual} is not {expected}")

    def near_all(self, actual: list, expected: list, what: str) -> None:
        self.assertEqual(len(actual), len(expected), what)
        scale = max(abs(x) for x in expected)
        for a, e in zip(actual, expected):
            self.near(a, e, max(scale, 1.0), what)
