"""The examples of the Python package print what the arithmetic of gears and closed forms say."""

from __future__ import annotations

import importlib.util
import itertools
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "python/examples"


def best_train() -> tuple[float, tuple[int, int, int], int, int]:
    """Ratio and teeth of the largest ratio in M1, how many trains can be built, and in how many the
    long planet has no teeth for planet 5."""
    found = []
    toothless = 0
    for n1, n2, n5 in itertools.product(range(16, 36), range(30, 55), range(12, 32)):
        n6, n3 = 22, n2 + 44
        n6i = n2 + n6 - n1 - 2 * n5
        toothless += n6i == 0
        if 12 <= n6i <= n6 and (n2 + n3) % 3 == 0 and (n3 - n1) % 3 == 0:
            found.append((n6i / n1 * n3 / n6, (n1, n2, n5)))
    ratio, teeth = max(found, key=lambda one: one[0])
    return ratio, teeth, len(found), toothless


def run(*words: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(words, capture_output=True, text=True, check=False, timeout=250,
                          env=os.environ)


class Examples(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("numpy"), "NumPy is not installed")
    def test_python_prints_the_best_train(self) -> None:
        done = run(sys.executable, "-B", EXAMPLES / "ravigneaux.py")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        # Cazangi 2008, Tab. 5.15
        self.assertEqual(lines[0], "ratios: {'M1': 2.847, 'M2': 1.601, 'M3': 1.0, 'MR': -2.073}")
        self.assertEqual(lines[1], "ring: 85.0 teeth, torque of brake B2 in M1: "
                         f"{round(100 * (595 / 209 - 1), 1)} N*m")  # torques of the train balance
        ratio, teeth, count, toothless = best_train()
        self.assertEqual(lines[2], f"10000 states, {10000 - toothless} solved")
        self.assertEqual(
            lines[3], f"{count} can be built; largest ratio {round(ratio, 4)} with N1 = {teeth[0]}, "
            f"N2 = {teeth[1]}, N5 = {teeth[2]}, torque of the ring {-100 * ratio:.1f} N*m")
        self.assertIn(f"'M1': {round(ratio, 3)}", lines[4])

    @unittest.skipUnless(shutil.which("octave-cli"), "GNU Octave is not installed")
    def test_octave_agrees_with_the_closed_form(self) -> None:
        done = run("octave-cli", EXAMPLES / "octave_sweep.m")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual(lines[0], "ratios: 2.8469 1.6010 1.0000 -2.0732")
        # Heights 3 m and 7 m: 15/15 and 39/11
        rows, _, off = lines[1].partition(", off the closed form by less than ")
        self.assertEqual(rows, "34 rows, ratio from 1.0000 to 3.5455")
        self.assertLessEqual(float(off), 1e-14)

    @unittest.skipUnless(shutil.which("julia"), "Julia is not installed")
    def test_julia_plays_the_first_gear(self) -> None:
        done = run("julia", "--startup-file=no", EXAMPLES / "julia_report.jl")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertEqual(lines[:4], ["M1: ratio 2.8469", "M2: ratio 1.601", "M3: ratio 1.0",
                                     "MR: ratio -2.0732"])
        self.assertEqual(lines[4], "20 of 20 states are solved")
        self.assertIn("N1 = 19: ratio 2.8469, torque of the ring -284.7 N*m", lines)


if __name__ == "__main__":
    unittest.main()
