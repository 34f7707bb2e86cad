#!/usr/bin/env python3
"""Checks sweeps of the library, whose states tapes answer, against analyses of single states.

Usage: swept_library_test.py PROGRAM MECHANISMS [unittest arguments]

The numbers of a file's parameters are moved at random, whole ones by whole numbers. Of some states of
each sweep, every value and the status must be those of `analyze --set`. KINESTAT_DIFFERENTIAL is the
number of states over all files.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import passes
from passes import Answers

SHARE = 1e-9
MOST_PARAMETERS = 4
# What analyze says of a case with an answer, by the word of the row.
WORDS = {"W0605": "contact_pulls", "W0606": "cable_slack", "W0607": "cable_slips"}
NUMBER = re.compile(r"  (\w+): *(-?\d+(?:\.\d+)?)(?: (\S+))?\s*(?:#.*)?$")
program = ""
library = Path()
states = int(os.environ.get("KINESTAT_DIFFERENTIAL", "250"))


def numbers_of(text: str) -> dict[str, tuple[str, str]]:
    """The parameters that are numbers other than zero, with their units."""
    section = re.search(r"^parameters:[^\n]*\n((?:  [^\n]*\n|\n)+)", text, re.MULTILINE)
    lines = section[1].splitlines() if section else []
    found = {m[1]: (m[2], m[3] or "") for m in map(NUMBER.match, lines) if m}
    return {name: one for name, one in found.items() if float(one[0]) != 0.0}


def has_sweep(text: str) -> bool:
    return bool(numbers_of(text)) and bool(re.search("^(cases|shift):", text, re.MULTILINE))


def axis_of(number: str, unit: str) -> str:
    value = float(number)
    if not unit and value.is_integer():
        return f"{{from: {max(1, value - 2):g}, to: {max(1, value + 4):g}, step: 1}}"
    low, high = sorted((0.9 * value, 1.1 * value))
    return f"{{from: {low!r} {unit}, to: {high!r} {unit}}}"


def sweep_of(text: str, count: int) -> tuple[str, list[str]]:
    """The file with a sweep in place of its own, and the parameters that are varied."""
    numbers = dict(list(numbers_of(text).items())[:MOST_PARAMETERS])
    axes = "".join(f"    {name}: {axis_of(*one)}\n" for name, one in numbers.items())
    others = re.split(r"^(?=\S)", text, flags=re.MULTILINE)
    kept = "".join(part for part in others if not part.startswith(("sweep:", "published:")))
    sample = f"sample: {{count: {count}, method: random, seed: 1}}"
    return f"{kept}\nsweep:\n  vary:\n{axes}  {sample}\n", list(numbers)


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


def value_of(row: dict, name: str) -> str:
    """As --set takes it; the title of a column has the unit."""
    title = next(title for title in row if title.split(" [")[0] == name)
    return f"{row[title]!r} {title.partition(' [')[2][:-1]}".strip()


class SweptLibraryTest(unittest.TestCase):
    def setUp(self) -> None:
        self.complaints: list[str] = []
        self.compared = 0
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def compare(self, place: str, row: dict, report: dict, codes: set[str]) -> None:
        case = report["cases"].get(row["case"])
        if case is None:  # of a gear that is none in this state
            return
        true = passes.of_analysis({"cases": {passes.CASE: case}})
        swept = passes.of_sweep_row(row, set(true.values.get("action", {})))
        self.compared += 1
        if swept.status != true.status and swept.status not in self.statuses(true, codes):
            self.complaints.append(f"{place} is {swept.status}, analyze says {true.status}")
        elif swept.status == "solved":
            self.complaints += passes.compare(place, swept, true, SHARE)

    @staticmethod
    def statuses(true: Answers, codes: set[str]) -> set[str]:
        """What a row may say instead of the status of the case."""
        if true.status == "solved":
            named = {word for code, word in WORDS.items() if code in codes}
            return named | {"locked", "no_ratio", "unbalanced", "doubtful"}
        return {"singular"}

    def check_state(self, path: Path, rows: list[dict], parameters: list[str]) -> None:
        settings = [f"--set={name}={value_of(rows[0], name)}" for name in parameters]
        done = run("analyze", "--format", "json", "--diagnostics", "json", *settings, str(path))
        said = json.loads(done.stderr)["diagnostics"] if done.stderr else []
        place = f"{path.stem} {' '.join(settings)}"
        if not done.stdout:
            codes = {one["code"] for one in said}
            self.complaints += [f"{place} {row['case']} is {row['status']}, analyze says {codes}"
                                for row in rows if row["status"] not in codes]
            return
        report = json.loads(done.stdout)
        for row in rows:
            case = f"cases/{row['case']}"
            self.compare(f"{place} {case}", row, report, {one["code"] for one in said})

    def check_file(self, path: Path, count: int) -> None:
        text, parameters = sweep_of(path.read_text(encoding="utf-8"), count)
        copy = Path(self.folder.name) / path.name
        copy.write_text(text, encoding="utf-8")
        done = run("sweep", "--format", "json", "--quiet", str(copy))
        if done.returncode not in (0, 5):
            self.complaints.append(f"{path.stem}: no sweep: {done.stderr}")
            return
        by_state: dict[tuple, list[dict]] = {}
        for row in map(json.loads, done.stdout.splitlines()):
            state = tuple(value_of(row, name) for name in parameters)
            by_state.setdefault(state, []).append(row)
        for rows in by_state.values():
            self.check_state(copy, rows, parameters)

    def test_rows_are_what_analyze_says_of_their_states(self) -> None:
        files = [path for path in sorted(library.glob("*/*.yaml"))
                 if path.parent.name not in ("sweeps", "synthesis")
                 and has_sweep(path.read_text(encoding="utf-8"))]
        for path in files:
            self.check_file(path, -(-states // len(files)))
        self.assertGreater(len(files), 60)
        self.assertGreater(self.compared, states)
        if self.complaints:
            self.fail("\n".join([f"{len(self.complaints)} complaints", *self.complaints[:40]]))


if __name__ == "__main__":
    program, library = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
