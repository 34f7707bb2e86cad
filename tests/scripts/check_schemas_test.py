"""check_schemas.py refuses wrong schemas and reports that are not strict JSON."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_schemas.py"
SCHEMA = """{"$schema": "http://json-schema.org/draft-07/schema#",
  "type": "object", "required": ["ratio"], "properties": {"ratio": {"type": "number"}}}"""


def check(schema: str | None, report: str | None) -> tuple[int, str]:
    with tempfile.TemporaryDirectory() as name:
        root = Path(name)
        (root / "scripts").mkdir()
        (root / "schemas").mkdir()
        shutil.copy(SCRIPT, root / "scripts")
        command = [sys.executable, "-B", str(root / "scripts" / SCRIPT.name)]
        if schema is not None:
            (root / "schemas/report.schema.json").write_text(schema, encoding="utf-8")
        if report is not None:
            (root / "a.json").write_text(report, encoding="utf-8")
            command.append(str(root / "a.json"))
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout.replace(name, "") + done.stderr


class CheckSchemas(unittest.TestCase):
    def assert_refused(self, report: str, message: str) -> None:
        self.assertEqual(check(SCHEMA, report), (1, f"/a.json: {message}\n"))

    def test_a_good_report_passes(self) -> None:
        status, output = check(SCHEMA, '{"ratio": -2.5e-3}')
        self.assertEqual((status, output), (0, "1 schemas and 1 reports are valid\n"))

    def test_a_tree_without_schemas_is_skipped(self) -> None:
        self.assertEqual(check(None, None)[0], 77)

    def test_a_schema_that_is_none(self) -> None:
        status, output = check(SCHEMA.replace('"object"', '"thing"'), None)
        self.assertEqual(status, 1)
        self.assertIn("report.schema.json: /type:", output)

    def test_a_schema_of_another_draft(self) -> None:
        self.assertEqual(check('{"type": "object"}', None)[0], 1)

    def test_a_report_against_the_schema(self) -> None:
        self.assert_refused('{"ratio": "x"}', "/ratio: 'x' is not of type 'number'")

    def test_not_a_number(self) -> None:
        self.assert_refused('{"ratio": NaN}', "NaN is not allowed")

    def test_infinity(self) -> None:
        self.assert_refused('{"ratio": -Infinity}', "-Infinity is not allowed")

    def test_a_number_too_large_for_a_double(self) -> None:
        self.assert_refused('{"ratio": 1e999}', "1e999 is not allowed")

    def test_negative_zero(self) -> None:
        self.assert_refused('{"ratio": -0.0}', "-0.0 is not allowed")

    def test_negative_zero_without_a_point(self) -> None:
        self.assert_refused('{"ratio": -0}', "-0 is not allowed")

    def test_a_key_twice(self) -> None:
        self.assert_refused('{"ratio": 1, "ratio": 2}', "the key 'ratio' occurs twice")


if __name__ == "__main__":
    unittest.main()
