"""What the tests of reports have in common: the mechanisms, and what the program writes of them."""

from __future__ import annotations

import argparse
import csv
import io
import json
import subprocess
import sys
import unittest
from functools import lru_cache
from pathlib import Path
from typing import Any, Iterator

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "scripts"), str(ROOT / "tests" / "support")]
import check_schemas  # noqa: E402  (scripts/check_schemas.py)
import sanitized  # noqa: E402  (tests/support/sanitized.py)

PROGRAM = Path("kinestat")
HEADER = ["mechanism", "case", "pass", "element", "quantity", "value", "unit", "status"]
# Cases whose reports have states that no good mechanism has: null values among them.
STATES = ["parameter_never_used", "e0501_motions_missing", "e0602_no_equilibrium",
          "w0601_actions_indeterminate", "loads_on_a_linkage", "w0601_self_stresses",
          "stiffness_shares_a_load", "minimum_norm_is_labelled",
          "losses_and_friction_of_bearings", "drive_in_reverse", "motion_as_json_and_csv"]
# A topology without dimensions, which only `kinestat mobility` answers.
COUNTED = ROOT / "mechanisms" / "cables" / "surgical_instrument.yaml"
# Tasks, which hold no mechanism and have reports of their own.
TASKS = ROOT / "mechanisms" / "synthesis"


def states() -> list[Path]:
    return [ROOT / "tests" / "cli" / name / "file.yaml" for name in STATES]


def has_sanitizers() -> bool:
    return sanitized.has_sanitizers(PROGRAM)


@lru_cache(maxsize=None)
def files() -> list[Path]:
    found = sorted(path for path in (ROOT / "mechanisms").rglob("*.yaml")
                   if path != COUNTED and path.parent != TASKS)
    return sanitized.sample(PROGRAM, found) + states()


def is_count_or_number(value: Any) -> bool:
    return value is not None and not isinstance(value, bool)


@lru_cache(maxsize=None)
def output(command: str, style: str, path: Path, *options: str) -> bytes:
    arguments = [command, "--format", style, *(["--matrices"] if command == "graph" else []),
                 *options]
    done = subprocess.run(
        [PROGRAM, *arguments, str(path)], capture_output=True, check=False, timeout=120
    )
    return done.stdout


def json_of(command: str, path: Path, *options: str) -> Any:
    return json.loads(output(command, "json", path, *options))


def rows_of(command: str, path: Path) -> list[list[str]]:
    text = output(command, "csv", path).decode("utf-8")
    return list(csv.reader(io.StringIO(text, newline=""), strict=True))


def schema(name: str = "report") -> Any:
    return check_schemas.read_strictly(ROOT / "schemas" / f"{name}.schema.json")


def numbers(value: Any) -> Iterator[Any]:
    """The numbers and nulls of a JSON value."""
    if isinstance(value, (dict, list)):
        for item in value.values() if isinstance(value, dict) else value:
            yield from numbers(item)
    elif value is None or isinstance(value, (int, float)) and not isinstance(value, bool):
        yield value


# Of the components of vectors and screws, by their names in tables.
COMPONENTS = {f"{letter}{axis}": first + i for letter, first in
              (("", 0), ("w", 0), ("v", 3), ("T", 0), ("R", 3)) for i, axis in enumerate("xyz")}


def item(values: list[Any], token: str) -> Any:
    return values[COMPONENTS[token] if token in COMPONENTS else int(token)]


def at(value: Any, path: str) -> Any:
    for token in filter(None, path.split("/")):
        value = item(value, token) if isinstance(value, list) else value[token]
    return value


class ReportCase(unittest.TestCase):
    def for_each(self, paths: list[Path] | None = None) -> Iterator[Path]:
        for path in files() if paths is None else paths:
            with self.subTest(str(path.relative_to(ROOT))):
                yield path


def run_tests(description: str | None) -> None:
    """Those of the main module, of the program that the command line names."""
    global PROGRAM
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
