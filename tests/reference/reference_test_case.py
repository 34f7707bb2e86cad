"""Comparison with exact values, to 1e-12 of the value itself."""

from __future__ import annotations

import unittest

EXACT = 1e-12


class ReferenceTest(unittest.TestCase):
    def near(self, actual: float, expected: float, what: str, scale: float = 1.0) -> None:
        """Equal to 1e-12 of `scale`, or of one."""
        self.assertLessEqual(
            abs(actual - expected), EXACT * max(1.0, scale), f"{what}: {actual} is not {expected}")

    def near_each(self, actual: dict[str, float], expected: dict[str, float]) -> None:
        """Each equal to 1e-12 of itself; where zero is expected, to 1e-12 of the largest."""
        largest = max(abs(x) for x in expected.values())
        for key, value in expected.items():
            scale = abs(value) if value != 0.0 else largest
            self.assertLessEqual(
                abs(actual[key] - value), EXACT * scale, f"{key}: {actual[key]} is not {value}")

    def near_all(self, actual: list[float], expected: list[float]) -> None:
        self.assertEqual(len(actual), len(expected))
        self.near_each({str(i): x for i, x in enumerate(actual)},
                       {str(i): x for i, x in enumerate(expected)})
