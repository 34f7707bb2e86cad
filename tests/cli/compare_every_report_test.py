#!/usr/bin/env python3
"""`kinestat compare` reads every report and every table that the program writes."""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path("kinestat")

# A command with its options, and a file of the library that has much for it.
COMMANDS = {
    ("analyze",): ("planar/toggle_press", "cables/capstan", "gears/simple_planetary",
                   "spatial/four_legged_table", "transmissions/ravigneaux_with_losses"),
    ("graph", "--matrices"): ("planar/four_bar",),
    ("shift",): ("transmissions/lepelletier_6hp26",),
    ("duty",): ("transmissions/muncie_m20",),
    ("motion",): ("planar/slider_crank",),
    ("simulate",): ("../tests/schema/valid/simulation",),
    ("mobility",): ("spatial/bennett", "cables/surgical_instrument"),
    ("inputs",): ("planar/four_bar", "cables/finger_rehabilitation"),
    ("sensitivity",): ("planar/rack_and_pinion", "gears/simple_planetary"),
    ("tolerance", "--place", "0.1mm"): ("planar/slider_crank", "spatial/rssr"),
    ("tolerance", "--angle", "0.1deg", "--along"): ("planar/slider_crank",),
    ("synthesize",): ("synthesis/do_valle_table_1", "synthesis/near_positions"),
    ("bench",): ("planar/four_bar",),
    ("sweep",): ("sweeps/four_bar_height",),
}

def run(*arguments: str | Path) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run([PROGRAM, *arguments], capture_output=True, check=False, timeout=120)


class CompareTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def check(self, style: str) -> None:
        for command, names in COMMANDS.items():
            for name in names:
                with self.subTest(command=command[0], file=name):
                    path = ROOT / "mechanisms" / f"{name}.yaml"
                    text = run(*command, "--format", style, path).stdout
                    report = self.folder / f"report.{style}"
                    report.write_bytes(text)
                    done = run("compare", report, report)
                    self.assertEqual((done.returncode, done.stderr), (0, b""))
                    count = re.search(rb"(\d+) values", done.stdout)
                    self.assertIsNotNone(count, done.stdout)
                    self.assertGreater(int(count[1]), 5)

    def test_reads_every_report(self) -> None:
        self.check("json")

    def test_reads_every_table(self) -> None:
        self.check("csv")

    def test_has_the_commands_that_write_reports(self) -> None:
        asked = {command[0] for command in COMMANDS}
        listed = set(re.findall(r"(?m)^  ([a-z]+)(?: |$)", run("--help").stdout.decode()))
        writing = {name for name in listed if b"--format" in run(name, "--help").stdout}
        self.assertGreaterEqual(writing, asked)
        # compare writes what it found; merge the rows of a sweep.
        self.assertEqual(writing - asked - {"compare", "merge"}, set())


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
