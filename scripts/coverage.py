#!/usr/bin/env python3
"""The coverage of each module of lib/, from the counters of the compiler; see coverage.sh.

Usage: coverage.py --build FOLDER --tests WORDS [--only MODULES] [--write]
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import re
import subprocess
import sys
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Iterable, Iterator

import check_layers
from written_part import WrittenPart

ROOT = Path(__file__).resolve().parents[1]
PART = WrittenPart(ROOT / "RELIABILITY.md",
                   "<!-- written by scripts/coverage.sh --write: -->", "<!-- end of coverage -->")
ASKED = 0.90  # of the lines


@dataclass
class Count:
    """Of lines or branches: how many there are, how many are reached."""

    all: int = 0
    reached: int = 0

    def add(self, counts: Iterable[int]) -> None:
        for count in counts:
            self.all += 1
            self.reached += count > 0

    @property
    def share(self) -> float:
        return self.reached / self.all if self.all else 1.0

    def __str__(self) -> str:
        return f"{100 * self.share:.1f} %" if self.all else "none"


def module_of(file: str, modules: check_layers.Modules) -> str | None:
    """None of what is not in lib/, or is made by the build."""
    path = Path(file)
    if not path.is_relative_to(ROOT / "lib"):
        return None
    return check_layers.module_of(path.relative_to(ROOT / "lib").as_posix(), modules)


def counted(objects: list[Path]) -> Iterator[dict]:
    """What gcov says of the sources of each object; those that never ran have zeros."""
    def one(file: Path) -> list[dict]:
        done = subprocess.run(["gcov", "--json-format", "--stdout", "--branch-probabilities", file.name],
                              cwd=file.parent, capture_output=True, text=True, check=True)
        told = [json.loads(line) for line in done.stdout.splitlines()]
        # ccache makes paths relative to the build.
        return [row | {"file": os.path.normpath(Path(part["current_working_directory"], row["file"]))}
                for part in told for row in part["files"]]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for rows in pool.map(one, objects):
            yield from rows


def ways(branches: list[dict]) -> list[int]:
    """How often each way of a decision was gone. That a call may throw is none: its edge and the one
    beside it are left out."""
    kept, i = [], 0
    while i < len(branches):
        beside = branches[i + 1] if i + 1 < len(branches) else None
        if branches[i]["throw"] or (beside and beside["throw"]):
            i += 2
            continue
        kept.append(branches[i]["count"])
        i += 1
    return kept


class Source:
    """The counts of a file, of all objects that it is part of and all instances of its templates."""

    def __init__(self) -> None:
        self.lines: dict[int, int] = defaultdict(int)
        self.ways: dict[tuple[int, int], int] = defaultdict(int)

    def add(self, row: dict) -> None:
        for line in row["lines"]:
            number = line["line_number"]
            self.lines[number] += line["count"]
            for i, count in enumerate(ways(line["branches"])):
                self.ways[number, i] += count

    @property
    def unreached(self) -> list[int]:
        return sorted(number for number, count in self.lines.items() if count == 0)


def ranges(numbers: list[int]) -> str:
    """3, 4, 5, 9 as `3-5, 9`."""
    parts: list[list[int]] = []
    for number in numbers:
        if parts and number == parts[-1][1] + 1:
            parts[-1][1] = number
        else:
            parts.append([number, number])
    return ", ".join(f"{first}" if first == last else f"{first}-{last}" for first, last in parts)


def table(lines: dict[str, Count], branches: dict[str, Count], tests: str) -> str:
    total = Count(sum(one.all for one in lines.values()), sum(one.reached for one in lines.values()))
    gone = Count(sum(one.all for one in branches.values()), sum(one.reached for one in branches.values()))
    commit = subprocess.run(["git", "-C", str(ROOT), "log", "-1", "--format=%cs"], capture_output=True,
                            text=True, check=False).stdout.strip()
    rows = [f"Tests: {tests}; sources of {commit or 'unknown date'}, counted on "
            f"{datetime.date.today().isoformat()}.",
            "",
            "| module | lines | reached | branches reached |", "|---|---|---|---|"]
    for name in sorted(lines):
        bold = "**" if lines[name].share < ASKED else ""
        rows.append(f"| `{name}` | {lines[name].all} | {bold}{lines[name]}{bold} | {branches[name]} |")
    rows.append(f"| all | {total.all} | {total} | {gone} |")
    return "\n".join(rows)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--tests", required=True)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--only", default=".*")
    known = parser.parse_args()
    modules = check_layers.read_modules(ROOT)
    sources: dict[str, Source] = defaultdict(Source)
    # Where the compiler was interrupted there is no object.
    objects = [file for file in sorted((known.build / "lib").rglob("*.gcno"))
               if file.with_suffix(".o").exists()]
    for row in counted(objects):
        module = module_of(row["file"], modules)
        if module and re.fullmatch(known.only, module):
            sources[row["file"]].add(row)
    lines: dict[str, Count] = defaultdict(Count)
    branches: dict[str, Count] = defaultdict(Count)
    listed = []
    for file, source in sorted(sources.items()):
        module = module_of(file, modules)
        lines[module].add(source.lines.values())
        branches[module].add(source.ways.values())
        if source.unreached:
            listed.append(f"{Path(file).relative_to(ROOT)}: {ranges(source.unreached)}")
    (known.build / "unreached.txt").write_text("\n".join([*listed, ""]), encoding="utf-8")
    text = table(lines, branches, known.tests)
    print(text)
    if known.write:
        PART.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
