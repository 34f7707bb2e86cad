"""check_zeros.py finds comparisons with a relative zero, and rows that allow nothing any more."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_zeros.py"


def check(files: dict[str, str]) -> tuple[int, list[str]]:
    with tempfile.TemporaryDirectory() as root:
        for name, text in files.items():
            path = Path(root) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        command = [sys.executable, "-B", str(SCRIPT), "--root", root]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, (done.stdout + done.stderr).splitlines()


class CheckZeros(unittest.TestCase):
    def assert_found(self, code: str) -> None:
        status, lines = check({"lib/power/some_flow.cpp": f"// Powers.\n{code}\n"})
        self.assertEqual(status, 1)
        self.assertEqual(len(lines), 1)
        self.assertTrue(lines[0].startswith("lib/power/some_flow.cpp:2: zero is decided"), lines)

    def assert_allowed(self, path: str, code: str) -> None:
        self.assertEqual(check({path: code}), (0, ["no zeros but those of bounds, and those listed"]))

    def test_a_share_of_the_largest_is_found(self) -> None:
        self.assert_found("bool b = std::abs(x) <= kRankZero * largest;")

    def test_a_share_of_a_computed_largest_is_found(self) -> None:
        self.assert_found("bool b = x > kNoReaction * v.cwiseAbs().maxCoeff();")

    def test_a_share_of_the_largest_that_is_kept_or_returned_is_found(self) -> None:
        self.assert_found("const double zero = kNoReaction * largest;")
        self.assert_found("return kNoReaction * flow.largest;")

    def test_a_share_is_found_however_it_is_spelled(self) -> None:
        for code in (
            "bool b = std::abs(x) <= largest * kRankZero;",
            "bool b = std::abs(x) <= all.largest() * kRankZero;",
            "bool b = std::abs(x) <= 1e-12 * largest;",
            "bool b = std::abs(x) / largest < kRankZero;",
            "bool b = kRankZero > std::abs(x) / v.norm();",
            "bool b = std::abs(x) <= kRankZero * scale;",
            "bool b = std::abs(x) <= kRankZero * flow.scale_;",
            "bool b = std::abs(x) <= kRankZero * v.norm();",
            "bool b = std::abs(x) <= v.norm() * 1e-9;",
            "const double zero{kRankZero * largest};",
            "f(kRankZero * largest);",
            "bool b = std::abs(x) <= kRankZero * std::ranges::max(all);",
            "bool b = std::abs(x) <= kRankZero * *std::ranges::max_element(all);",
            "if (std::abs(x) < (kRankZero * largest)) x = 0;",
            "double zero = tolerance.zero * largest;",
            "bool b = is_small(x, kRankZero, largest);",
            "bool b = is_small(x, largest, 1e-12);",
            "bool b = kRankZero * largest > std::abs(x);",
            "bool b = std::max(a, kRankZero * largest) > x;",
            "bool b = Eigen::internal::isMuchSmallerThan(x, y);",
        ):
            with self.subTest(code):
                self.assert_found(code)

    def test_shares_that_are_not_small_are_of_another_kind(self) -> None:
        self.assert_allowed(
            "lib/draw/a.cpp",
            "constexpr double kHead = 0.2;\ndouble head(double size) { return kHead * size; }",
        )

    def test_rounding_of_the_terms_of_a_sum_is_a_bound(self) -> None:
        self.assert_allowed("lib/power/flow.cpp", "bound += kDataRounding * v.norm();")
        self.assert_allowed("lib/power/flow.cpp", "bound += 4.0 * kEpsilon * force.norm();")

    def test_a_part_of_the_largest_is_none(self) -> None:
        self.assert_allowed("lib/plot/a.cpp", "const double x = kArrow * force / largest_force_;")

    def test_a_comparison_over_two_lines_is_one(self) -> None:
        status, lines = check({"lib/run/a.cpp": "bool b = x <\n  kSmall *\n  flow.largest;"})
        self.assertEqual((status, len(lines)), (1, 1))

    def test_the_zero_of_reports_is_found_by_its_name(self) -> None:
        self.assert_found("const double zero = kReportZero;")

    def test_a_snap_is_found(self) -> None:
        self.assert_found("return snap(value, zero);")

    def test_a_bound_of_its_own_is_allowed(self) -> None:
        self.assert_allowed("lib/power/flow.cpp", "return std::abs(x) <= bound ? 0.0 : x;")

    def test_arithmetic_may_use_shares(self) -> None:
        self.assert_allowed("lib/math/sum.cpp", "bool b = std::abs(x) <= kCancellation * largest;")

    def test_words_and_texts_are_no_code(self) -> None:
        self.assert_allowed("lib/run/a.cpp", '// snap(x)\nconst char* a = "snap(x)";')

    def test_a_listed_decision_is_allowed(self) -> None:
        self.assert_allowed(
            "lib/network/primary_check.cpp",
            "MatX clear_part(const MatX& all) {\n  return all < kSmall * largest;\n}",
        )

    def test_a_listed_decision_is_of_one_function(self) -> None:
        status, lines = check(
            {
                "lib/network/primary_check.cpp": "MatX clear_part(const MatX& all) {\n"
                "  return all < kSmall * largest;\n}\n\n"
                "bool other(const MatX& all,\n           int a) {\n"
                "  return all < kSmall * largest;\n}\n"
            }
        )
        self.assertEqual((status, len(lines)), (1, 1))
        self.assertIn("in other ", lines[0])

    def test_a_function_of_a_class_has_its_own_name(self) -> None:
        status, lines = check(
            {
                "lib/power/a.cpp": "class Flow {\n public:\n  bool is_open(int a) const {\n"
                "    return x < kSmall * largest;\n  }\n};\n"
            }
        )
        self.assertEqual((status, len(lines)), (1, 1))
        self.assertIn("in is_open ", lines[0])

    def test_a_row_that_allows_nothing_is_found(self) -> None:
        status, lines = check({"lib/network/primary_check.cpp": "int none = 0;"})
        self.assertEqual(status, 1)
        self.assertIn("nothing to allow", lines[0])


if __name__ == "__main__":
    unittest.main()
