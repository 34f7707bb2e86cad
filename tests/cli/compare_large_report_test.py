#!/usr/bin/env python3
"""`kinestat compare` of two reports of 50 MB: what differs is found, in little memory and time."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path("kinestat")
MOTION = ROOT / "mechanisms" / "cables" / "block_and_tackle.yaml"
STEPS = 67000
LARGEST_MEMORY = 500 * 10**6


class Run:
    """A run of the program, and what it took."""

    def __init__(self, out: Path, *arguments: str | Path) -> None:
        with out.open("wb") as stream:
            started = subprocess.Popen([PROGRAM, *arguments], stdout=stream,
                                       stderr=subprocess.DEVNULL)
            _, status, used = os.wait4(started.pid, 0)
        started.returncode = os.waitstatus_to_exitcode(status)
        self.status = started.returncode
        self.seconds = used.ru_utime + used.ru_stime
        self.bytes = used.ru_maxrss * 1024


class CompareLargeTest(unittest.TestCase):
    def test_of_a_long_motion(self) -> None:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            a = folder / "a.json"
            written = Run(a, "motion", "--steps", str(STEPS), "--format", "json", MOTION)
            self.assertEqual(written.status, 0)
            self.assertGreater(a.stat().st_size, 50 * 10**6)

            # Other values in one row, and one row that only A has: the rows before keep their place.
            report = json.loads(a.read_bytes())
            rows = report["motion"]["rows"]
            column = next(i for i, cell in enumerate(rows[-2]) if isinstance(cell, float) and cell)
            key = report["motion"]["columns"][column]["name"].replace("~", "~0").replace("/", "~1")
            rows[-2][column] *= 2
            del rows[-1]
            b = folder / "b.json"
            b.write_text(json.dumps(report), encoding="utf-8")
            del report

            same = Run(folder / "same", "compare", a, a)
            other = Run(folder / "other", "compare", "--format", "json", a, b)

            self.assertEqual(same.status, 0)
            self.assertLess(same.bytes, LARGEST_MEMORY)
            # It takes half of what computing and writing the report does.
            self.assertLess(same.seconds, written.seconds)
            found = json.loads((folder / "other").read_bytes())
            places = {one["place"]: one for one in found["differences"]}
            self.assertEqual(set(places), {f"/motion/rows/{len(rows) - 1}/{key}",
                                           f"/motion/rows/{len(rows)}"})
            print(f"written in {written.seconds:.2f} s, compared in {same.seconds:.2f} s and "
                  f"{same.bytes / 1e6:.0f} MB; with a row that is missing {other.seconds:.2f} s "
                  f"and {other.bytes / 1e6:.0f} MB")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, default=PROGRAM)
    options, rest = parser.parse_known_args()
    PROGRAM = options.program
    unittest.main(argv=[sys.argv[0], *rest])
