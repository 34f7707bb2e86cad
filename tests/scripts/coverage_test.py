"""coverage.py: to which module a source counts, what is listed, and the table."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import check_layers  # noqa: E402
import coverage  # noqa: E402


class Coverage(unittest.TestCase):
    def test_counts_a_source_to_the_innermost_module(self) -> None:
        modules = check_layers.read_modules(ROOT)
        for file, module in (("lib/math/dense/span.cpp", "math"), ("lib/studies/shift/x.cpp", "studies/shift"),
                             ("lib/studies/shift/report/x.cpp", "studies/shift/report")):
            self.assertEqual(coverage.module_of(str(ROOT / file), modules), module)
        for file in ("app/main.cpp", "tests/unit/math/x.cpp", "build/coverage/lib/embedded.cpp"):
            self.assertIsNone(coverage.module_of(str(ROOT / file), modules))
        self.assertIsNone(coverage.module_of("/usr/include/stdio.h", modules))

    def test_lists_the_lines_that_nothing_reaches(self) -> None:
        source = coverage.Source()
        for counts in ({3: 0, 4: 0, 5: 7, 9: 0}, {4: 0, 9: 0, 12: 1}, {9: 0}):
            source.add({"lines": [{"line_number": number, "count": count, "branches": []}
                                  for number, count in counts.items()]})
        self.assertEqual(source.unreached, [3, 4, 9])
        self.assertEqual(coverage.ranges(source.unreached), "3-4, 9")

    def test_of_branches_leaves_out_that_a_call_may_throw(self) -> None:
        def branch(count: int, throw: bool = False) -> dict:
            return {"count": count, "throw": throw, "fallthrough": not throw}
        self.assertEqual(coverage.ways([branch(5), branch(0)]), [5, 0])
        self.assertEqual(coverage.ways([branch(5), branch(0, True)]), [])
        self.assertEqual(coverage.ways([branch(5), branch(0, True), branch(4), branch(1)]), [4, 1])
        self.assertEqual(coverage.ways([branch(2), branch(3), branch(0)]), [2, 3, 0])

    def test_counts_what_gcov_says_of_a_program(self) -> None:
        if not shutil.which("g++") or not shutil.which("gcov"):
            self.skipTest("g++ or gcov is not installed")
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "a.cpp").write_text(
                "int f(int x) {\n  if (x > 1) {\n    return 2;\n  }\n  return 3;\n}\n"
                "int g() {\n  return 4;\n}\nint main() { return f(0) - 3; }\n", encoding="utf-8")
            for words in (["g++", "--coverage", "-O0", "-c", "a.cpp"], ["g++", "--coverage", "a.o"],
                          ["./a.out"]):
                subprocess.run(words, cwd=folder, check=True)
            source = coverage.Source()
            for row in coverage.counted([Path(folder, "a.gcno")]):
                source.add(row)
            self.assertEqual(source.unreached, [3, 7, 8])
            self.assertEqual([count > 0 for count in source.ways.values()].count(True), 1)
            self.assertEqual(len(source.ways), 2)

    def test_table_shows_what_is_below_the_aim(self) -> None:
        lines = {"core": coverage.Count(1000, 950), "run": coverage.Count(100, 80)}
        branches = {"core": coverage.Count(10, 5), "run": coverage.Count()}
        text = coverage.table(lines, branches, "units")
        self.assertIn("| `core` | 1000 | 95.0 % | 50.0 % |", text)
        self.assertIn("| `run` | 100 | **80.0 %** | none |", text)
        self.assertIn("| all | 1100 | 93.6 % | 50.0 % |", text)


if __name__ == "__main__":
    unittest.main()
