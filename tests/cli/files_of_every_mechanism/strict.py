"""Refuses what no output may hold: NaN, infinity, -0, carriage returns, a last line without end."""

import json
import re
import sys
from pathlib import Path

NOT_FINITE = re.compile(rb"(?i)(?<![\w.-])[+-]?(nan|inf|infinity)(?![\w-])")
MINUS_ZERO = re.compile(rb"(?<![\w.-])-0(\.0*)?(e[+-]?\d+)?(?![\w.])")


def refuse(token: str) -> None:
    raise ValueError(f"{token} is not JSON")


def faults(path: Path) -> list[str]:
    text = path.read_bytes()
    matches = [pattern.search(text) for pattern in (NOT_FINITE, MINUS_ZERO)]
    found = [f"holds {match[0]!r}" for match in matches if match]
    if b"\r" in text or not text.endswith(b"\n"):
        found.append("has line ends other than LF")
    # A report is one document over lines; those of several files stand one a line.
    is_report = path.name.endswith(".report.json")
    for one in [text] if is_report else text.splitlines() if path.suffix == ".json" else []:
        json.loads(one.decode("utf-8"), parse_constant=refuse)
    text.decode("utf-8")
    return found


paths = sorted(Path(sys.argv[1]).iterdir())
for path in paths:
    for fault in faults(path):
        print(f"{path}: {fault}")
kinds = sorted({"".join(path.suffixes) for path in paths})
print("\n".join(["checked", *kinds]))
