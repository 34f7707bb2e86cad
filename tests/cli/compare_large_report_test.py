#!/usr/bin/env python3
"""`kinestat compare` of two reports of 50 MB: differences are found, in little memory and time."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Iterable

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path("kinestat")
MOTION = ROOT / "mechanisms" / "cables" / "block_and_tackle.yaml"
STEPS = 67000
CASES = ROOT / "mechanisms" / "transmissions" / "ravigneaux.yaml"
REPEATS = 720
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


def reversed_keys(value: object) -> object:
    """The same with the keys of every object in the other order."""
    if isinstance(value, dict):
        return {key: reversed_keys(one) for key, one in reversed(value.items())}
    return [reversed_keys(one) for one in value] if isinstance(value, list) else value


def write(path: Path, report: dict, labels: Iterable[tuple[str, str]]) -> Path:
    """The report with its cases under those labels, each instead of the one that it had. It is
    written case by case: the memory of a child counts from that of this process."""
    cases = {name: json.dumps(case, indent=2) for name, case in report["cases"].items()}
    before, after = json.dumps(report | {"cases": 0}, indent=2).split('"cases": 0')
    with path.open("w", encoding="utf-8") as out:
        out.write(f'{before}"cases": ')
        for i, (label, name) in enumerate(labels):
            out.write(f"{'{,'[i > 0]}\n{json.dumps(label)}: {cases[name]}")
        out.write(f"}}{after}")
    return path


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

    def test_of_many_cases(self) -> None:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            self.assertEqual(
                Run(folder / "one", "analyze", "--format", "json", CASES).status, 0)
            report = json.loads((folder / "one").read_bytes())
            labels = [(f"{name} of state {i}", name)
                      for i in range(REPEATS) for name in report["cases"]]
            a = write(folder / "a.json", report, labels)
            self.assertGreater(a.stat().st_size, 50 * 10**6)
            turned = write(folder / "turned.json", reversed_keys(report), reversed(labels))
            lacked = labels.pop(5)[0]
            shorter = write(folder / "shorter.json", report, labels)

            same = Run(folder / "same", "compare", a, a)
            reordered = Run(folder / "reordered", "compare", a, turned)
            other = Run(folder / "other", "compare", "--format", "json", a, shorter)

            self.assertEqual((same.status, reordered.status), (0, 0))
            found = json.loads((folder / "other").read_bytes())
            self.assertEqual([one["place"] for one in found["differences"]],
                             [f"/cases/{lacked}"])
            for run in (same, reordered, other):
                self.assertLess(run.bytes, LARGEST_MEMORY)
            print(f"compared in {same.seconds:.2f} s and {same.bytes / 1e6:.0f} MB; "
                  f"in another order {reordered.seconds:.2f} s and {reordered.bytes / 1e6:.0f} MB; "
                  f"with a case that is missing {other.seconds:.2f} s and "
                  f"{other.bytes / 1e6:.0f} MB")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, default=PROGRAM)
    options, rest = parser.parse_known_args()
    PROGRAM = options.program
    unittest.main(argv=[sys.argv[0], *rest])
