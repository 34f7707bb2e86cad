#!/usr/bin/env python3
"""Every diagnostic code is unique, explained, and shown by a case of tests/cli."""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import unittest
from pathlib import Path

CASES = Path(__file__).resolve().parent
PROGRAM = Path("kinestat")

# Codes that no file and no command line brings about, each with its reason.
NOT_PROVOKED = {
    "E0701": "guards against wrong numbers: the powers of a solved case sum to zero by its own "
             "equations",
}


def kinestat(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [PROGRAM, *arguments], capture_output=True, encoding="utf-8", check=False, timeout=60
    )


def listed() -> list[tuple[str, str]]:
    """Code and title of each line of `kinestat explain`."""
    found = [line.split("  ", 1) for line in kinestat("explain").stdout.splitlines()]
    return [(code, title) for code, title in found]


def shown() -> dict[str, str]:
    """The codes in the expected messages of the cases, each with the name of a case."""
    found: dict[str, str] = {}
    for name in ("err", "err_contains"):
        for path in sorted(CASES.glob(f"*/{name}")):
            for code in re.findall(r"(?:error|warning)\[(\w+)\]", path.read_text("utf-8")):
                found.setdefault(code, path.parent.name)
    return found


class Codes(unittest.TestCase):
    def test_are_listed_once_and_in_order(self) -> None:
        codes = [code for code, _ in listed()]

        self.assertGreater(len(codes), 40)
        self.assertEqual(codes, sorted(set(codes)))

    def test_are_a_letter_and_four_digits_with_a_title(self) -> None:
        for code, title in listed():
            with self.subTest(code):
                self.assertRegex(code, r"^[EW]0[1-9]\d\d$")
                self.assertRegex(title, r"^(YAML |[a-z'-]).*[^.\s]$")

    def test_are_explained_by_a_paragraph(self) -> None:
        for code, title in listed():
            with self.subTest(code):
                told = kinestat("explain", code)
                self.assertEqual((told.returncode, told.stderr), (0, ""))
                head, empty, *paragraph = told.stdout.splitlines()
                self.assertEqual((head, empty), (f"{code}: {title}", ""))
                self.assertGreaterEqual(len(" ".join(paragraph)), 25)
                self.assertTrue(paragraph[-1].endswith("."), paragraph[-1])
                self.assertLessEqual(max(map(len, paragraph)), 80)

    def test_are_shown_by_a_case(self) -> None:
        codes, cases = [code for code, _ in listed()], shown()

        without = [code for code in codes if code not in cases and code not in NOT_PROVOKED]

        self.assertEqual(without, [], "add a case to tests/cli, or a reason to NOT_PROVOKED")

    def test_of_the_cases_are_listed(self) -> None:
        codes = {code for code, _ in listed()}

        unknown = {code: case for code, case in shown().items() if code not in codes}

        self.assertEqual(unknown, {})

    def test_without_a_case_have_a_reason_that_still_holds(self) -> None:
        codes, cases = {code for code, _ in listed()}, shown()

        outdated = [code for code in NOT_PROVOKED if code not in codes or code in cases]

        self.assertEqual(outdated, [], "remove them from NOT_PROVOKED")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
