#!/usr/bin/env python3
"""The example scripts do what their first lines say."""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "scripts" / "examples"
PROGRAM = Path("kinestat")


def run(name: str, *arguments: str | Path, cwd: Path) -> subprocess.CompletedProcess[str]:
    path = f"{PROGRAM.parent}:{os.environ.get('PATH', os.defpath)}"
    return subprocess.run(
        [EXAMPLES / name, *map(str, arguments)], capture_output=True, encoding="utf-8",
        check=False, timeout=240, cwd=cwd, env={**os.environ, "PATH": path, "LC_ALL": "C"},
    )


class Examples(unittest.TestCase):
    def setUp(self) -> None:
        self.place = tempfile.TemporaryDirectory(prefix="kinestat-examples-")
        self.addCleanup(self.place.cleanup)
        self.folder = Path(self.place.name)

    def test_largest_powers_are_those_of_the_source(self) -> None:
        wrong = self.folder / "wrong.yaml"
        wrong.write_text("kinestat: 1\n")
        train = ROOT / "mechanisms/transmissions/ravigneaux.yaml"
        done = run("largest_powers.sh", train, wrong, train, cwd=self.folder)
        rows = done.stdout.splitlines()
        self.assertEqual(done.returncode, 1)
        self.assertIn("wrong.yaml", done.stderr)
        self.assertEqual(rows[0], "file,case,coupling,power [W]")
        # Cazangi 2008, Figs. 5.18 and 5.22: 4675/31 and 6930/31 W on f and g.
        self.assertIn("ravigneaux,M2,f,150.806", rows)
        self.assertIn("ravigneaux,M3,f,223.548", rows)
        self.assertEqual(len(rows), 9)

    def test_gear_steps_are_ranked_and_hold_the_train_of_the_source(self) -> None:
        text = (ROOT / "mechanisms/sweeps/ravigneaux_search.yaml").read_text()
        for wide, narrow in (("from: 16, to: 40", "from: 19, to: 22"),
                             ("from: 28, to: 67", "from: 39, to: 43")):
            self.assertIn(wide, text)
            text = text.replace(wide, narrow)
        file = self.folder / "search.yaml"
        file.write_text(text)
        done = run("gear_steps.sh", file, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        rows = [line.split(",") for line in done.stdout.splitlines()]
        steps = [float(row[0]) for row in rows]
        self.assertEqual(steps, sorted(steps))
        teeth = {tuple(row[1:5]): row for row in rows}
        first, second, reverse = 595 / 209, 21080 / 13167, -85 / 41  # Tab. 5.15
        row = teeth[("19", "41", "15", "22")]
        self.assertAlmostEqual(float(row[0]), first / second, places=6)
        for cell, ratio in zip(row[5:], (first, second, reverse)):
            self.assertAlmostEqual(float(cell), ratio, places=12)

    def test_golden_regression_finds_what_has_changed(self) -> None:
        model = self.folder / "crank.yaml"
        shutil.copy(ROOT / "mechanisms/planar/slider_crank.yaml", model)
        accepted = run("golden_regression.sh", "--accept", "golden", model, cwd=self.folder)
        self.assertEqual(accepted.returncode, 0, accepted.stderr)
        same = run("golden_regression.sh", "golden", model, cwd=self.folder)
        self.assertEqual(same.returncode, 0, same.stdout + same.stderr)
        added = self.folder / "other.yaml"
        shutil.copy(ROOT / "mechanisms/planar/four_bar.yaml", added)
        missing = run("golden_regression.sh", "golden", model, added, cwd=self.folder)
        self.assertEqual(missing.returncode, 1)
        self.assertIn("other.report.json: no golden report", missing.stdout)
        shutil.copy(added, model)
        changed = run("golden_regression.sh", "golden", model, cwd=self.folder)
        self.assertEqual(changed.returncode, 1)
        self.assertIn("crank.report.json: differs", changed.stdout)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, rest = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
