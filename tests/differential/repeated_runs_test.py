#!/usr/bin/env python3
"""Checks motions of the library against themselves in other steps, and sweeps and selections against
other numbers of threads.

Usage: repeated_runs_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import unittest
from pathlib import Path
from typing import Iterator

from changes import size_of, slides_of
from known_defects import sort_out
from mechanism_file import MechanismFile

SHARE = 1e-9
ROUNDINGS = 1e-11  # of the largest of a kind; a position closes to 1e-12 of the size
program = ""
library = Path()


def call(*arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


class Motion:
    """A motion in some number of steps."""

    def __init__(self, path: Path, drive: list[str], steps: int | None = None) -> None:
        options = [*drive, *(["--steps", str(steps)] if steps else [])]
        done = call("motion", "--format", "json", "--diagnostics", "json", *options, str(path))
        self.status = done.returncode
        self.codes = sorted({d["code"] for line in done.stderr.splitlines()
                             for d in json.loads(line)["diagnostics"]})
        report = json.loads(done.stdout)["motion"] if done.stdout else {}
        self.end = report.get("status")
        self.steps = report.get("steps", 0)
        self.columns = [column["name"] for column in report.get("columns", [])]
        file = MechanismFile.read(path)
        self.unit, self.size = file.length_unit, size_of(file)
        self.kinds = [(column["quantity"].split("/")[0], column["unit"])
                      for column in report.get("columns", [])]
        self.rows = report.get("rows", [])
        self.events = report.get("events", [])

    def largest(self) -> list[float]:
        """Of each column that of its kind: positions and velocities of turns, of slides, …"""
        result: dict[tuple[str, str], float] = {}
        for c, kind in enumerate(self.kinds):
            cells = [abs(row[c]) for row in self.rows if isinstance(row[c], float)]
            result[kind] = max([result.get(kind, 0.0), *cells])
        for kind in result.keys() & {("position", self.unit), ("at", self.unit)}:
            result[kind] = max(result[kind], self.size)  # by which a position is closed
        return [result[kind] for kind in self.kinds]

    def row(self, step: int, of: int) -> list | None:
        """At a share of the range, if there is a position."""
        at, rest = divmod(step * self.steps, of)
        return next((row for row in self.rows if row[0] == at), None) if rest == 0 else None


def compare_rows(coarse: Motion, fine: Motion) -> Iterator[str]:
    largest = fine.largest()
    for row in coarse.rows:
        other = fine.row(row[0], coarse.steps)
        if other is None:
            if row[-1] != "limit":
                yield f"step {row[0]} of {coarse.steps} is not reached in {fine.steps}"
            continue
        for name, one, two, size in list(zip(coarse.columns, row, other, largest))[1:]:
            if name == "closure_error":
                continue
            if isinstance(one, float) and isinstance(two, float):
                if abs(one - two) > SHARE * abs(one) + ROUNDINGS * size:
                    yield f"{name} of step {row[0]} is {one} in {coarse.steps}, {two}"
            elif one != two:
                yield f"{name} of step {row[0]} is {one} in {coarse.steps}, {two}"


def compare_events(coarse: Motion, fine: Motion) -> Iterator[str]:
    """In the same order at the same positions, as far as both are certain of them."""
    kinds = [[(e["kind"], e["element"]) for e in one.events] for one in (coarse, fine)]
    if kinds[0] != kinds[1]:
        yield f"events are {kinds[0]} in {coarse.steps}, {kinds[1]}"
        return
    for one, two in zip(coarse.events, fine.events):
        apart = abs(one["drive"][0] - two["drive"][0])
        known = one["uncertainty"] + two["uncertainty"] + 1e-12 * abs(one["drive"][0])
        if apart > known:
            yield f"{one['kind']} of {one['element']} lies {apart} apart, known to {known}"


def compare_motions(coarse: Motion, fine: Motion) -> Iterator[str]:
    for what in ("status", "codes", "end", "columns"):
        one, two = getattr(coarse, what), getattr(fine, what)
        if one != two:
            yield f"{what} is {one} in {coarse.steps} steps, {two} in {fine.steps}"
    yield from compare_rows(coarse, fine)
    yield from compare_events(coarse, fine)


def drive_of(path: Path) -> list[str] | None:
    """Options that move a mechanism; none are needed where its file says how it moves."""
    file = MechanismFile.read(path)
    if "motion" in file.tree:
        return []
    for label, case in (file.tree.get("cases") or {}).items():
        if isinstance(case.get("input"), str) and case.get("motion"):
            slides = slides_of(file).get(case["input"], False)
            to = f"{size_of(file) / 50} {file.length_unit}" if slides else "12 deg"
            return ["--drive", case["input"], "--to", to, "--case", label]
    return None


class RepeatedRunsTest(unittest.TestCase):
    def files_with(self, section: str) -> list[Path]:
        pattern = re.compile(rf"^{section}:", re.MULTILINE)
        return [path for path in sorted(library.glob("**/*.yaml"))
                if pattern.search(path.read_text(encoding="utf-8"))]

    def test_the_number_of_steps_does_not_matter(self) -> None:
        complaints = []
        moved = 0
        for path in self.files_with("couplings"):
            drive = drive_of(path)
            if drive is None:
                continue
            plain = Motion(path, drive, 4 if drive else None)
            moved += bool(plain.rows)
            for steps in (2 * plain.steps, 3 * plain.steps) if plain.rows else ():
                complaints += [f"{path.stem}: {text}"
                               for text in compare_motions(plain, Motion(path, drive, steps))]
        self.assertGreaterEqual(moved, 20)
        said = sort_out("test_the_number_of_steps_does_not_matter", complaints, True)
        if said:
            self.fail("\n".join([f"{len(said)} complaints", *said[:40]]))

    def check_threads(self, command: str, section: str, least: int) -> None:
        paths = self.files_with(section)
        self.assertGreaterEqual(len(paths), least)
        for path in paths:
            one, four = (call(command, "--jobs", jobs, "--format", "json", str(path))
                         for jobs in ("1", "4"))
            self.assertEqual(one.returncode, four.returncode, path)
            self.assertEqual(one.stdout, four.stdout, path)

    def test_sweeps_do_not_depend_on_threads(self) -> None:
        self.check_threads("sweep", "sweep", 2)

    def test_syntheses_do_not_depend_on_threads(self) -> None:
        self.check_threads("synthesize", "synthesis", 15)


if __name__ == "__main__":
    program, library = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
