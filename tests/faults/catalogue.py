"""The list of faults of faults.yaml, and whether the tests it names exist."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Iterator

import yaml

from program import ROOT

CASES = ROOT / "tests" / "cli"
# Numbers that were never assigned.
NEVER_GIVEN = {104, 125}


@dataclass(frozen=True)
class Fault:
    number: int
    name: str
    refused: list[str] = field(default_factory=list)
    accepted: list[str] = field(default_factory=list)
    cases: list[str] = field(default_factory=list)
    tests: list[str] = field(default_factory=list)
    everywhere: str = ""
    promise: str = ""


@dataclass(frozen=True)
class Part:
    name: str
    faults: list[Fault]


def read(path: Path = Path(__file__).with_name("faults.yaml")) -> list[Part]:
    return [Part(part["part"], [Fault(**fault) for fault in part["faults"]])
            for part in yaml.safe_load(path.read_text(encoding="utf-8"))]


def faults(parts: list[Part]) -> list[Fault]:
    return [fault for part in parts for fault in part.faults]


def expected_code(case: str) -> str:
    """Of the first error that the case shows."""
    found = re.search(r"error\[(E\d{4})\]", (CASES / case / "err").read_text(encoding="utf-8"))
    assert found, f"{case} shows no error"
    return found[1]


def gaps(parts: list[Part], conditions: set[str]) -> Iterator[str]:
    """What is missing: numbers, cases, tests, conditions, or anything that holds a fault."""
    listed = faults(parts)
    numbers = [fault.number for fault in listed]
    if numbers != sorted(set(range(1, max(numbers) + 1)) - NEVER_GIVEN):
        yield f"the numbers are {numbers}"
    for fault in listed:
        yield from (f"{fault.number}: {text}" for text in gaps_of(fault, conditions))
    for name in conditions - {fault.everywhere for fault in listed}:
        yield f"no fault names the condition {name}"


def gaps_of(fault: Fault, conditions: set[str]) -> Iterator[str]:
    if not (fault.refused or fault.accepted or fault.cases or fault.tests or fault.everywhere):
        yield "nothing holds it"
    if not (fault.refused or fault.accepted or fault.everywhere or fault.promise):
        yield "nothing is promised"
    for case in [*fault.refused, *fault.accepted, *fault.cases]:
        if not (CASES / case / "cmd").is_file():
            yield f"there is no case {case}"
    for case in [*fault.refused, *fault.accepted]:
        if not (CASES / case / "file.yaml").is_file():
            yield f"the case {case} has no file.yaml"
    for test in fault.tests:
        path, _, name = test.partition("::")
        if not name or not (ROOT / path).is_file() or name not in (ROOT / path).read_text("utf-8"):
            yield f"there is no test {test}"
    if fault.everywhere and fault.everywhere not in conditions:
        yield f"there is no condition {fault.everywhere}"
