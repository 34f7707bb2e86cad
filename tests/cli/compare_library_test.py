#!/usr/bin/env python3
"""`kinestat compare` reads what every command writes on every file of the library, in every form and
layout: no table has two rows of one name, none is empty, and equal reports are equal."""

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
MECHANISMS = ROOT / "mechanisms"

# Each with its options, and the file of the library that it is asked about; all files but those that
# other commands answer.
COMMANDS = {
    ("analyze",): "*",
    ("graph",): "*",
    ("graph", "--matrices"): "*",
    ("shift",): "*",
    ("motion",): "*",
    ("simulate",): "*",
    ("duty",): "*",
    ("mobility",): "*",
    ("inputs",): "*",
    ("sensitivity",): "*",
    ("tolerance", "--place", "0.1mm", "--angle", "0.1deg"): "*",
    ("tolerance", "--place", "0.1mm", "--along"): "planar/*",
    ("synthesize",): "synthesis/[!el]*",  # others are searches that take long
    ("bench",): "planar/*",
}
LAYOUT = {"analyze", "shift", "motion", "simulate"}


def run(*arguments: str | Path) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run([PROGRAM, *arguments], capture_output=True, check=False, timeout=280)


class CompareLibraryTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def check_equal(self, report: Path) -> None:
        done = run("compare", report, report)
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        count = re.search(rb"(\d+) values", done.stdout)
        self.assertIsNotNone(count, done.stdout)
        self.assertGreater(int(count[1]), 5)

    def check_stream(self, *options: str) -> None:
        """All files on one stream."""
        for command, names in COMMANDS.items():
            if "--layout" in options and command[0] not in LAYOUT:
                continue
            paths = sorted(path for path in MECHANISMS.glob(f"{'*/' if names == '*' else ''}{names}")
                           if path.suffix == ".yaml")
            if names == "*":
                paths = [path for path in paths if "synthesis" not in path.parts]
            with self.subTest(command=" ".join(command)):
                report = self.folder / "report"
                report.write_bytes(run(*command, *options, *paths).stdout)
                self.check_equal(report)

    def test_reads_reports_of_many_files(self) -> None:
        self.check_stream("--format", "json")

    def test_reads_tables_of_many_files(self) -> None:
        self.check_stream("--format", "csv")

    def test_reads_wide_tables_of_many_files(self) -> None:
        self.check_stream("--format", "csv", "--layout", "wide")

    def test_reads_every_file_that_is_written(self) -> None:
        paths = sorted(path for path in MECHANISMS.glob("*/*.yaml")
                       if path.parent.name != "synthesis")  # which has names of other folders
        for layout in ("long", "wide"):
            for command in ("analyze", "motion"):
                folder = self.folder / f"{command}_{layout}"
                folder.mkdir()
                run(command, "--quiet", "--layout", layout, "--out", folder, *paths)
                written = sorted(folder.iterdir())
                self.assertGreater(len(written), 20)
                for path in written:
                    with self.subTest(file=path.name, layout=layout):
                        self.assertGreater(path.stat().st_size, 0)
                        done = run("compare", path, path)
                        self.assertEqual((done.returncode, done.stderr), (0, b""))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
