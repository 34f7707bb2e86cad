"""The table of RELIABILITY.md: the promise for each fault, and its tests."""

from __future__ import annotations

import sys

import surroundings
from catalogue import Fault, Part, expected_code, faults
from program import ROOT, Command

sys.path.insert(0, str(ROOT / "scripts"))
from written_part import WrittenPart  # noqa: E402

PART = WrittenPart(ROOT / "RELIABILITY.md",
                   "<!-- written by tests/faults/faults_test.py --write: -->",
                   "<!-- end of what is written -->")


def promise(fault: Fault) -> str:
    told = [fault.promise] if fault.promise else []
    if fault.refused:
        codes = sorted({expected_code(case) for case in fault.refused})
        told.append(f"refused by every command, status 3, {', '.join(codes)}")
    if fault.accepted:
        told.append("accepted by every command")
    if fault.everywhere:
        told.append((surroundings.FOR_ALL[fault.everywhere].__doc__ or "").strip())
    return "; ".join(told)


def holders(fault: Fault) -> str:
    files = len(fault.refused) + len(fault.accepted)
    held = [f"{files} file{'s'[:files > 1]} × commands"] if files else []
    held += [f"`{fault.everywhere}` × commands"] if fault.everywhere else []
    cases = [*fault.refused, *fault.accepted, *fault.cases]
    held += [f"`tests/cli/{cases[0]}`" + (f" and {len(cases) - 1} more" if cases[1:] else "")] \
        if cases else []
    held += [f"`{test.split('::')[0]}`" for test in dict.fromkeys(fault.tests)]
    return ", ".join(held)


def table(parts: list[Part], commands: list[Command]) -> str:
    listed = faults(parts)
    files = sum(len(fault.refused) + len(fault.accepted) for fault in listed)
    cases = {case for fault in listed for case in (*fault.refused, *fault.accepted, *fault.cases)}
    conditions = sum(bool(fault.everywhere) for fault in listed)
    lines = [
        f"{len(listed)} faults. {files} files are given to each of {len(commands)} commands, "
        f"{files * len(commands)} runs; each command runs in {conditions} test environments; "
        f"{len(cases)} cases of `tests/cli` show the messages. The commands that read a mechanism "
        f"file are {', '.join(command.name for command in commands)}."]
    for part in parts:
        lines += ["", f"### {part.name}", "", "| | fault | promise | held by |",
                  "|---|---|---|---|"]
        lines += [f"| {one.number} | {one.name} | {promise(one)} | {holders(one)} |"
                  for one in part.faults]
    return "\n".join(lines)
