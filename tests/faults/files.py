"""Wrong files, and unusual but valid ones, through every command."""

from __future__ import annotations

from typing import Iterator

import catalogue
from program import Command, Program, Run

# What a command says that finds its section missing before anything is bound to numbers.
SECTION_MISSING = "E0303"
# What writes a page says there what is wrong.
PAGES = "report"


def run_case(program: Program, command: Command, case: str) -> Run:
    content = (catalogue.CASES / case / "file.yaml").read_bytes()
    return program.run(command.arguments("file.yaml"), files={"file.yaml": content})


def refused(program: Program, command: Command, case: str) -> tuple[Run, list[str]]:
    run = run_case(program, command, case)
    return run, list(not_refused(run, command, catalogue.expected_code(case)))


def not_refused(run: Run, command: Command, code: str) -> Iterator[str]:
    if run.status != 3:
        yield f"status {run.status} for a wrong file"
    said = run.codes()[:1]
    if said != [code] and said != [SECTION_MISSING]:
        yield f"it says {said} instead of {code}"
    if "file.yaml" not in run.said:
        yield "the file is not named"
    if run.out and command.name != PAGES:
        yield "something on standard output"


def accepted(program: Program, command: Command, case: str) -> tuple[Run, list[str]]:
    run = run_case(program, command, case)
    return run, list(not_accepted(run, command))


def not_accepted(run: Run, command: Command) -> Iterator[str]:
    """What a command needs may be missing or be wrong to ask for; the form may not be."""
    if any(code.startswith("E02") for code in run.codes()):
        yield f"it is refused with {run.codes()}"
    if command.name == "check" and run.status != 0:
        yield f"check says {run.status}"
