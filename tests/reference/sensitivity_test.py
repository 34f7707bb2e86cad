#!/usr/bin/env python3
"""Derivatives by the adjoint against central differences of whole analyses with --set.

For every mechanism of the library with parameters: the usual values of its first case that is
solved without friction, by every parameter. Parameters that are whole numbers of teeth move by a
thousandth all the same: formulas do not mind.
"""

from __future__ import annotations

import json
import subprocess
import sys
import unittest
from pathlib import Path
from typing import Any

PROGRAM = ""
MECHANISMS = Path()
STEP = 1e-5  # of the parameter: the error of a central difference is about its square


def run(*arguments: str) -> dict[str, Any]:
    """The JSON report; published values that are missed do not matter here."""
    done = subprocess.run([PROGRAM, *arguments, "--format", "json"], capture_output=True,
                          encoding="utf-8", check=False, timeout=60)
    return json.loads(done.stdout) if done.stdout else {}


def values_of(report: dict[str, Any], label: str) -> dict[str, Any]:
    return report.get("cases", {}).get(label, {}).get("sensitivity", {})


class Sensitivity(unittest.TestCase):
    def test_agrees_with_differences(self) -> None:
        compared = 0
        for path in sorted(MECHANISMS.glob("**/*.yaml")):
            text = path.read_text(encoding="utf-8")
            if "\nparameters:" in text and "friction:" not in text:
                with self.subTest(path.name):
                    compared += self.compare(str(path))
        self.assertGreater(compared, 100)

    def compare(self, path: str) -> int:
        report = run("sensitivity", path)
        for label, case in report.get("cases", {}).items():
            if case["sensitivity"]:
                return self.compare_case(path, report, label)
        return 0

    def compare_case(self, path: str, report: dict[str, Any], label: str) -> int:
        compared = 0
        values = values_of(report, label)
        for name, parameter in report["mechanism"]["parameters"].items():
            step = STEP * (abs(parameter["value"]) or 1.0)
            ends = [self.moved(path, label, list(values), name, parameter, sign * step)
                    for sign in (-1.0, 1.0)]
            for value, entry in values.items():
                derivative = entry["by"][name]["derivative"]
                if derivative is None or not all(value in end for end in ends):
                    continue
                low, high = (end[value]["value"] for end in ends)
                difference = (high - low) / (2.0 * step)
                size = abs(entry["value"]) / (abs(parameter["value"]) or 1.0)
                self.assertAlmostEqual(derivative, difference, delta=1e-6 * (abs(difference) + size),
                                       msg=f"{label}: {value} by {name}")
                compared += 1
        return compared

    @staticmethod
    def moved(path: str, label: str, names: list[str], parameter: str, known: dict[str, Any],
              by: float) -> dict[str, Any]:
        """The values with the parameter moved; empty where the mechanism no longer fits."""
        unit = f"*{known['unit']}" if known["unit"] else ""
        chosen = [word for name in names for word in ("--of", name)]
        report = run("sensitivity", "--case", label, *chosen, "--by", parameter,
                     "--set", f"{parameter}=({known['value'] + by!r}){unit}", path)
        return values_of(report, label)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
