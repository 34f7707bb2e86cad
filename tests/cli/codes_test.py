#!/usr/bin/env python3
"""Every diagnostic code is unique, shown by a case of tests/cli, and explained truthfully.

An explanation ends with an example, a file or commands, in which lines marked - are wrong and lines
marked + right. The wrong version must cause its code and no other, the right one none.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
import unittest
from functools import lru_cache
from pathlib import Path

CASES = Path(__file__).resolve().parent
ROOT = CASES.parents[1]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from sanitized import has_sanitizers  # noqa: E402

PROGRAM = Path("kinestat")
# Codes that no file and no command line brings about, each with its reason; without examples.
NOT_PROVOKED = {
    "E0103": "of other programs that call the library; tests/unit/interface brings it about",
    "E0155": "a mistake in the program itself",
    "E0701": "guards against wrong numbers: the powers of a solved case sum to zero by its own "
             "equations",
    "W0802": "guards against wrong verdicts: no task is known that brings it about",
    "W0804": "guards against wrong numbers: the mechanism is another way to those of the search",
    "W0502": "takes more stages than anybody reads, or refinement alone; a property test of "
             "extremes brings it about",
}
# Examples that are not run, each with its reason.
NOT_RUN = {
    "E0154": "sanitizers need more memory than any limit leaves; see out_of_memory",
}
# Warnings that examples of other codes may bring about too.
BESIDE = {"W0302", "W0314"}
EXAMPLE = "Example (- wrong, + correct):"


@lru_cache(maxsize=None)
def kinestat(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [PROGRAM, *arguments], capture_output=True, encoding="utf-8", check=False, timeout=240
    )


def listed() -> list[tuple[str, str]]:
    """Code and title of each line of `kinestat explain`."""
    found = [line.split("  ", 1) for line in kinestat("explain").stdout.splitlines()]
    return [(code, title) for code, title in found]


def explanation(code: str) -> tuple[list[str], list[str]]:
    """The lines of the paragraph and of the example, the latter with their marks."""
    lines = kinestat("explain", code).stdout.splitlines()[2:]
    if EXAMPLE not in lines:
        return lines, []
    at = lines.index(EXAMPLE)
    return lines[:at - 1], [line[2:] for line in lines[at + 2:]]


def version(example: list[str], mark: str) -> str:
    """The wrong (-) or the right (+) version of an example."""
    lines = [line[2:] for line in example if not line.strip() or line[0] in (" ", mark)]
    return "\n".join(lines).replace("<tab>", "\t") + "\n"


def messages_of(text: str) -> tuple[int, list[str]]:
    """Exit status and codes of a mechanism file, or of a list of commands."""
    with tempfile.TemporaryDirectory(prefix="kinestat-example-") as name:
        folder = Path(name)
        study = "simulate" if "\nsimulation:" in text else "analyze --quiet"
        command = f"kinestat {study} file.yaml"
        if text.startswith("$ "):
            command = "\n".join(line.removeprefix("$ ") for line in text.splitlines())
            write_inputs(folder)
        else:
            (folder / "file.yaml").write_text(text, encoding="utf-8")
        path = f"{PROGRAM.parent}:{os.environ.get('PATH', os.defpath)}"
        done = subprocess.run(
            ["bash", "-c", command], cwd=folder, env={**os.environ, "PATH": path},
            capture_output=True, encoding="utf-8", check=False, timeout=120,
        )
        return done.returncode, re.findall(r"(?:error|warning)\[(\w+)\]", done.stderr)


def write_inputs(folder: Path) -> None:
    """The files that the commands of the examples name."""
    train = (ROOT / "mechanisms/gears/simple_planetary.yaml").read_bytes()
    (folder / "mechanisms").mkdir()
    for path in ("train.yaml", "mechanisms/train.yaml"):
        (folder / path).write_bytes(train)
    (folder / "teeth.yaml").write_bytes(
        train + b"\nsweep: {vary: {Ns: {from: 18, to: 30, step: 2}}, report: [ratio]}\n")
    (folder / "latin1.yaml").write_bytes(train.replace(b"Simple", b"Einfacher Tr\xE4ger,"))
    (folder / "drawing.step").write_bytes(b"#1=CARTESIAN_POINT('',(0.,0.,0.));\n" * 40000)


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
                head, empty, *_ = told.stdout.splitlines()
                paragraph, _ = explanation(code)
                self.assertEqual((head, empty), (f"{code}: {title}", ""))
                self.assertGreaterEqual(len(" ".join(paragraph)), 100)
                self.assertTrue(paragraph[-1].endswith("."), paragraph[-1])
                self.assertLessEqual(max(map(len, paragraph)), 80)

    def test_are_explained_by_an_example(self) -> None:
        for code, _ in listed():
            if code not in NOT_PROVOKED:
                with self.subTest(code):
                    _, example = explanation(code)
                    self.assertTrue(example, f"add lib/run/examples/{code}.diff")
                    self.assertLessEqual(max(map(len, example)), 90)

    def test_come_from_the_wrong_version_of_their_example_alone(self) -> None:
        for code, _ in listed():
            _, example = explanation(code)
            if example and code not in NOT_RUN:
                with self.subTest(code):
                    allowed = BESIDE - {code}
                    _, codes = messages_of(version(example, "-"))
                    self.assertEqual(set(codes) - allowed, {code})
                    if has_sanitizers(PROGRAM):
                        continue  # right files are read by all other tests
                    status, codes = messages_of(version(example, "+"))
                    self.assertEqual((status, set(codes) - allowed), (0, set()))

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
