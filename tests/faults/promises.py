"""What holds for every run, with any arguments."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Iterator

from program import Program, Run

LONGEST_S = 10.0
MOST_MEMORY = 2 << 30
SANITIZERS_ARE_SLOWER = 20


@dataclass(frozen=True)
class Promises:
    """The statuses and codes that are documented, and bounds."""

    statuses: frozenset[int]
    codes: frozenset[str]
    seconds: float = LONGEST_S
    memory: int = MOST_MEMORY

    @staticmethod
    def of(program: Program) -> "Promises":
        slower = SANITIZERS_ARE_SLOWER if program.has_sanitizers else 1
        return Promises(frozenset(program.statuses()), frozenset(program.known_codes()),
                        LONGEST_S * slower, MOST_MEMORY)

    def broken_by(self, run: Run, written: tuple[str, ...] = ()) -> Iterator[str]:
        """`written` are the files that the run was told to write."""
        if run.status not in self.statuses:
            yield f"the status {run.status} is not documented"
        if run.status not in (0, 1) and not run.err.strip():
            yield f"status {run.status} without a word"
        if b"\x1b" in run.out or b"\x1b" in run.err:
            yield "an ESC byte"
        for code in set(re.findall(r"(?:error|warning)\[(\w+)\]", run.said)) - self.codes:
            yield f"the code {code} is not documented"
        if re.search(r"terminate called|Sanitizer|runtime error|Segmentation|Traceback", run.said):
            yield "the trace of a crash"
        for path in run.left:
            if path not in written:
                yield f"{path} was changed or left behind"
        if run.seconds > self.seconds:
            yield f"{run.seconds:.1f} s of the processor"
        if run.memory > self.memory:
            yield f"{run.memory >> 20} MiB"
