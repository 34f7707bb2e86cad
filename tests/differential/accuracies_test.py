#!/usr/bin/env python3
"""Checks that exact arithmetic says what doubles say, and warns of the same: of the library and of
the files of tests/cli.

Usage: accuracies_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from batch import Batch, Result

# Where rounding decides on a rank or a zero, and exact arithmetic knows better.
BY_ROUNDING = {"bennett_linkage_file", "exact_refuses_a_value_by_rounding_noise",
               "mobility_of_a_platform_on_concurrent_bars_file",
               "sweep_bounds_values_that_may_be_rounding_file",
               "w0501_cranks_rounded_before_they_were_typed_file",
               "w0501_names_the_singular_value_file"}
CASES = Path(__file__).resolve().parents[1] / "cli"
program = ""
library = Path()


def texts_below(folder: Path) -> dict[str, str]:
    """Files of other encodings are for the reader alone."""
    return {"_".join(path.relative_to(folder).with_suffix("").parts):
            path.read_text(encoding="utf-8", errors="ignore")
            for path in sorted(folder.glob("**/*.yaml"))}


class AccuraciesTest(unittest.TestCase):
    def difference(self, folder: Path, fast: Result, exact: Result) -> str:
        if exact.codes() != fast.codes():
            return f"findings are {exact.codes()}, were {fast.codes()}"
        if bool(exact.report) != bool(fast.report):
            return "a report only once"
        if not fast.report:
            return ""
        paths = [folder / "fast.json", folder / "exact.json"]
        for path, result in zip(paths, (fast, exact), strict=True):
            path.write_text(json.dumps(result.report), encoding="utf-8")
        done = subprocess.run([program, "compare", "--rtol", "1e-9", "--atol", "1e-10", *paths],
                              capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else done.stdout + done.stderr

    def check(self, texts: dict[str, str], least: int) -> None:
        """At least so many have a report."""
        batch = Batch(program, texts)
        try:
            fast, exact = (batch.run("analyze", "--accuracy", accuracy)
                           for accuracy in ("fast", "exact"))
        finally:
            batch.close()
        self.assertGreaterEqual(sum(bool(one.report) for one in fast.values()), least)
        with tempfile.TemporaryDirectory() as folder:
            for name in texts:
                with self.subTest(name):
                    self.assertEqual(self.difference(Path(folder), fast[name], exact[name]), "")

    def test_of_the_library(self) -> None:
        self.check(texts_below(library), 100)

    def test_of_the_files_of_cases(self) -> None:
        texts = texts_below(CASES)
        self.assertLessEqual(BY_ROUNDING, texts.keys())
        self.check({name: text for name, text in texts.items() if name not in BY_ROUNDING}, 400)


if __name__ == "__main__":
    program, library = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
