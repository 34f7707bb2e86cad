"""A sweep of two states of a file: the oracle that each row agrees with analyze."""

from __future__ import annotations

import random
import re
import sys
from typing import Any, Iterator

import yaml

import mutate
from program import ROOT

sys.path.insert(0, str(ROOT / "tests" / "differential"))
import agreement_test  # noqa: E402
import passes  # noqa: E402
from mechanism_file import written  # noqa: E402

PARAMETER = "swept"
STATES = ("1", "1.5")  # one parameter of the file times that; 1 is the file as it was
SECTIONS = ("parameters", "couplings", "cables", "gears", "loads", "cases", "springs")
# Rows have no bounds: what doubles prove has its digits there, what they do not may lose some.
SHARE, UNPROVED_SHARE = 1e-7, 1e-3
PROVED = 1e-9
# Words of rows that analyze has no status for: what is asked for has no value, or the gear is none.
OTHER_WORDS = {"ambiguous", "unbalanced", "self_locking", "unknown_load", "no_efficiency",
               "no_value", "neutral", "tie-up"}

Analysed = tuple[Any, list[dict]]  # the report, None without one, and the findings


def with_sweep(text: str) -> str | None:
    """The file with the parameter in one of its numbers, the same one every time."""
    tree = yaml.load(text, Loader=yaml.BaseLoader)
    parts = [tree[name] for name in SECTIONS if isinstance(tree.get(name), (dict, list))]
    found = [(parent, key) for part in parts for parent, key in mutate.numbers(part)
             if mutate.NUMBER.match(parent[key])]
    if not found or not isinstance(tree.get("parameters", {}), dict):
        return None
    parent, key = random.Random(text).choice(found)
    parent[key] = f"{PARAMETER}*({parent[key]})"
    tree.setdefault("parameters", {})[PARAMETER] = "1"
    tree["sweep"] = {"vary": {PARAMETER: list(STATES)}}
    return written(tree) + "\n"


def _of(label: str, findings: list[dict]) -> set[str]:
    """Codes of what is said of a case, or of no case."""
    return {one["code"] for one in findings
            if f"case '{label}'" in one["message"] or "case '" not in one["message"]}


def _is_proved(case: dict) -> bool:
    """Whether doubles have the answers of both sides, by their bounds."""
    told = [case[side].get("evidence") or {} for side in ("kinematics", "statics") if side in case]
    return all(one.get("precision") == "double" and (one.get("error_bound") or 0.0) < PROVED
               for one in told)


def compare(rows: list[dict], analyses: list[Analysed]) -> Iterator[str]:
    """`analyses` are those of the states."""
    drawn = analyses[0][0]
    for row in rows:
        state, label = STATES.index(f"{row[PARAMETER]:g}"), row.get("case", "")
        report, findings = analyses[state]
        what = f"{PARAMETER} = {STATES[state]}, case {label}"
        case = (report or {}).get("cases", {}).get(label)
        if case is None:
            if row["status"] == "solved":
                yield f"{what}: the row is solved, analyze has no case"
            continue
        true = passes.of_analysis({"cases": {passes.CASE: case}})
        actions = set(true.values.get("action", {}))
        swept = passes.of_sweep_row(row, actions)
        yield from passes.compare(what, swept, true, SHARE if _is_proved(case) else UNPROVED_SHARE)
        yield from _status(what, swept.status, true, _of(label, findings), label, drawn)


def _status(what: str, word: str, true: passes.Answers, codes: set[str], label: str,
            drawn: Any) -> Iterator[str]:
    told = agreement_test.word_of(true, sorted(codes))
    first = (drawn or {}).get("cases", {}).get(label)
    before = passes.of_analysis({"cases": {passes.CASE: first}}) if first else true
    is_locked = word == "locked" and true.status == "dependent"  # without any freedom
    if word == told or is_locked or re.fullmatch(r"[EW]\d{4}", word):
        return
    if told not in agreement_test.IMPOSSIBLE.values() and (
            word in OTHER_WORDS or agreement_test.is_same_status(word, true, before)):
        return
    yield f"{what}: the row is {word}, analyze says {told}"
