#!/usr/bin/env python3
"""The driver can fail: programs that break one promise each, and what is then reported.

Each of these programs is a script that calls the true one and spoils the answer.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import unittest
from pathlib import Path

import catalogue
import files
import options  # noqa: F401 - its conditions join those of surroundings
import surroundings
from catalogue import Fault, Part
from program import Command, Program
from promises import Promises

TRUE = Path(sys.executable)

# What a spoiled program does, and of what the driver must then complain, of a file that is refused.
REFUSED = {
    "accepts": ('"$TRUE" "$@"; exit 0', "status 0 for a wrong file"),
    "says another code": ('"$TRUE" "$@" 2>&1 | sed "s/E0207/E0302/" >&2; exit 3',
                           "it says ['E0302']"),
    "does not name the file": ('"$TRUE" "$@" 2>&1 | sed "s/file.yaml/it/g" >&2; exit 3',
                               "not named"),
    "prints": ('echo 1; "$TRUE" "$@"', "something on standard output"),
}
# The same of what holds of every run.
ALWAYS = {
    "crashes": ("kill -SEGV $$", "the status -11 is not documented"),
    "admits a bug": ('echo bug >&2; exit 70', "the status 70 is not documented"),
    "is silent": ("exit 3", "status 3 without a word"),
    "leaves a file": ('touch .left; "$TRUE" "$@"', ".left was changed or left behind"),
    "changes its input": ('echo "# x" >> file.yaml; "$TRUE" "$@"', "file.yaml was changed"),
    "rings": (r'printf "\033[31m"; "$TRUE" "$@"', "an ESC byte"),
    "invents a code": ('echo "error[E9999]: no" >&2; exit 3', "the code E9999 is not documented"),
    "shows a trace": ('echo "terminate called" >&2; exit 4', "the trace of a crash"),
    "works too long": ('for ((i = 0; i < 1500000; i++)); do :; done; "$TRUE" "$@"',
                       "of the processor"),
    "takes too much": ('head -c 60000000 /dev/zero | tr "\\0" x > /dev/null; '
                       'x=$(head -c 60000000 /dev/zero | tr "\\0" x); exit 0', "MiB"),
}
ANSWERS = 'shift; echo done; exit 0'            # whatever is wrong
REFUSES = 'echo "error[E0101]: no" >&2; exit 2'  # whatever is right
# Bytes that hang on the surroundings; `inner` runs where nothing is to be refused.
CHANGES = '"$TRUE" "$@"; echo "$$ $RANDOM"'
# Which program each condition must tell from the true one.
CONDITIONS = {
    **dict.fromkeys(("missing_file", "folder_for_a_file", "device_for_a_file", "empty_file_name",
                     "circle_of_links", "too_large_a_file", "endless_input", "full_disk",
                     "help_to_a_full_disk", "output_place_missing", "foreign_output",
                     "output_onto_the_input", "unknown_option", "wrong_values", "wrong_words",
                     "option_without_value", "wrong_settings", "little_memory"), ANSWERS),
    **dict.fromkeys(("odd_file_name", "closed_pipe", "well_formed"), REFUSES),
    **dict.fromkeys(("other_locale", "empty_environment", "no_temporary_folder", "run_again",
                     "few_open_files"), CHANGES),
}
# Held by what holds of every run: time and memory.
BY_BOUNDS = {"long_names"}


class Planted(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        true = Program(TRUE)
        self.commands = {command.name: command for command in true.commands()}
        self.promises = Promises.of(true)

    def spoiled(self, script: str) -> Program:
        path = self.folder / "spoiled"
        path.write_text(f'#!/bin/bash\nTRUE="{TRUE}"\n{script}\n', encoding="utf-8")
        path.chmod(0o755)
        return Program(path)

    def said_of_refused(self, program: Program, promises: Promises) -> str:
        run, wrong = files.refused(program, self.commands["check"], "duplicate_key")
        return "\n".join([*wrong, *promises.broken_by(run)])

    def test_faults_of_a_refused_file_are_seen(self) -> None:
        self.assertEqual(self.said_of_refused(Program(TRUE), self.promises), "")
        for what, (script, complaint) in REFUSED.items():
            with self.subTest(what):
                said = self.said_of_refused(self.spoiled(script), self.promises)
                self.assertIn(complaint, said)

    def test_a_refused_byte_order_mark_is_seen(self) -> None:
        run, wrong = files.accepted(self.spoiled('echo "error[E0203]: no" >&2; exit 3'),
                                    self.commands["check"], "byte_order_mark_at_the_start")
        self.assertEqual(wrong, ["it is refused with ['E0203']", f"check says {run.status}"])

    def test_faults_of_any_run_are_seen(self) -> None:
        narrow = Promises(self.promises.statuses, self.promises.codes, seconds=0.5,
                          memory=40 << 20)
        if not Program(TRUE).has_sanitizers:
            self.assertEqual(self.said_of_refused(Program(TRUE), narrow), "")
        for what, (script, complaint) in ALWAYS.items():
            with self.subTest(what):
                self.assertIn(complaint, self.said_of_refused(self.spoiled(script), narrow))

    def test_every_condition_tells_a_program_that_breaks_it(self) -> None:
        self.assertEqual(CONDITIONS.keys() | BY_BOUNDS, surroundings.FOR_ALL.keys())
        for name, script in CONDITIONS.items():
            for command in map(self.commands.get, ("report", "inputs")):
                with self.subTest(name, command=command.name):
                    self.assert_told(name, self.spoiled(script), command)

    def assert_told(self, name: str, program: Program, command: Command) -> None:
        found = list(surroundings.FOR_ALL[name](program, command))
        if found:  # the condition is one of this command
            self.assertTrue(any(wrong for _, wrong, _ in found))

    def test_gaps_of_the_list_are_seen(self) -> None:
        wrong = [Fault(1, "a", cases=["no_such_case"], promise="p"), Fault(2, "b"),
                 Fault(4, "c", tests=["tests/cli/run_case.py::no_such_test"], promise="p"),
                 Fault(5, "d", everywhere="no_such_condition")]
        said = "\n".join(catalogue.gaps([Part("part", wrong)], {"unused"}))
        for words in ("the numbers are [1, 2, 4, 5]", "1: there is no case no_such_case",
                      "2: nothing holds it", "2: nothing is promised",
                      "4: there is no test tests/cli/run_case.py::no_such_test",
                      "5: there is no condition no_such_condition", "no fault names the condition"):
            self.assertIn(words, said)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    TRUE = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
