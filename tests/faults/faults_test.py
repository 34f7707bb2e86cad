#!/usr/bin/env python3
"""Every fault of faults.yaml on every command to which it applies.

Usage: faults_test.py --program PROGRAM [--write] [unittest arguments]

--write updates the table of RELIABILITY.md. With sanitizers, which make a run fifty times slower, each
fault is tried on some commands, and every command with some faults.
"""

from __future__ import annotations

import argparse
import os
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Callable, Iterable

import catalogue
import files
import options  # noqa: F401 - its conditions join those of surroundings
import page
import surroundings
from program import Command, Program
from promises import Promises

Job = Callable[[], list[str]]
SHARE_WITH_SANITIZERS = 8
program = Program(Path(sys.executable))


def of_file(kind: str, case: str, command: Command, promises: Promises) -> Job:
    def judge() -> list[str]:
        run, wrong = getattr(files, kind)(program, command, case)
        return [f"{kind} {case}: {run.what}: {text}"
                for text in (*wrong, *promises.broken_by(run))]
    return judge


def of_condition(name: str, command: Command, promises: Promises) -> Job:
    def judge() -> list[str]:
        return [f"{name}: {run.what}: {text}"
                for run, wrong, written in surroundings.FOR_ALL[name](program, command)
                for text in (*wrong, *promises.broken_by(run, written))]
    return judge


def jobs_of(parts: list[catalogue.Part], commands: list[Command],
            promises: Promises) -> Iterable[Job]:
    for fault in catalogue.faults(parts):
        for command in commands:
            for kind in ("refused", "accepted"):
                for case in getattr(fault, kind):
                    yield of_file(kind, case, command, promises)
            if fault.everywhere:
                yield of_condition(fault.everywhere, command, promises)


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.parts = catalogue.read()
        cls.commands = program.commands()

    def test_have_something_that_holds_each(self) -> None:
        self.assertEqual(list(catalogue.gaps(self.parts, set(surroundings.FOR_ALL))), [])

    def test_keep_all_promises_on_every_command(self) -> None:
        jobs = list(jobs_of(self.parts, self.commands, Promises.of(program)))
        if program.has_sanitizers:
            # The step has no divisor in common with the number of commands.
            jobs = jobs[::SHARE_WITH_SANITIZERS + 1]
        self.assertGreater(len(jobs), 200)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            complaints = [text for said in pool.map(lambda job: job(), jobs) for text in said]
        print(f"{len(jobs)} faults and commands, {program.count} runs", flush=True)
        self.assertEqual(complaints, [])

    def test_are_told_in_the_page(self) -> None:
        self.assertEqual(page.PART.replaced(page.table(self.parts, self.commands)),
                         page.PART.page.read_text(encoding="utf-8"),
                         "faults_test.py --write brings it up to date")


def main() -> None:
    global program
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--write", action="store_true")
    known, others = parser.parse_known_args()
    program = Program(known.program)
    if known.write:
        page.PART.write(page.table(catalogue.read(), program.commands()))
        return
    unittest.main(argv=[sys.argv[0], *others])


if __name__ == "__main__":
    main()
