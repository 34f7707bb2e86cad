#!/usr/bin/env python3
"""Checks that exact arithmetic says of the library what doubles say, and warns of the same.

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

program = ""
library = Path()


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

    def test_exact_arithmetic_says_what_doubles_say(self) -> None:
        texts = {"_".join(path.relative_to(library).with_suffix("").parts):
                 path.read_text(encoding="utf-8") for path in sorted(library.glob("**/*.yaml"))}
        self.assertGreater(len(texts), 100)
        batch = Batch(program, texts)
        try:
            fast, exact = (batch.run("analyze", "--accuracy", accuracy)
                           for accuracy in ("fast", "exact"))
        finally:
            batch.close()
        with tempfile.TemporaryDirectory() as folder:
            for name in texts:
                with self.subTest(name):
                    self.assertEqual(self.difference(Path(folder), fast[name], exact[name]), "")


if __name__ == "__main__":
    program, library = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
