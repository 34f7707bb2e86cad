#!/usr/bin/env python3
"""The reports of inputs, sensitivities and tolerances of every mechanism, by their schemas."""

from __future__ import annotations

import argparse
import json
import sys
import unittest
from pathlib import Path
from typing import Iterator

import reports_test
from reports_test import HEADER, ROOT, check_schemas, files, json_of, output, rows_of, schema


class StudyReports(unittest.TestCase):
    def for_each(self) -> Iterator[Path]:
        for path in files():
            with self.subTest(str(path.relative_to(ROOT))):
                yield path

    def test_have_inputs_by_their_schema(self) -> None:
        for path in self.for_each():
            answer = json_of("inputs", path)
            self.assertEqual(check_schemas.report_faults(answer, schema("inputs")), [])
            counts = json_of("analyze", path)["mobility"]["minimal"]
            self.assertEqual(answer["inputs"]["motion"]["needed"], counts["net_freedom"])
            for row in (dict(zip(HEADER, row)) for row in rows_of("inputs", path)[1:]):
                self.assertEqual((row["pass"], row["case"]), ("inputs", ""))
                side, key = row["quantity"].split("/")
                value = answer["inputs"][side].get(key)
                if key == "drives":
                    self.assertIn(row["unit"], ("N/N", "N*m/N", "N*mm/N"))
                    self.assertEqual(row["value"], json.dumps(value[row["element"]]), row)
                    continue
                self.assertEqual(row["unit"], "", row)
                if row["element"] == "" and row["status"] != "none":
                    self.assertEqual(row["value"], json.dumps(value), row)

    def test_have_sensitivities_by_their_schema(self) -> None:
        for path in self.for_each():
            report = json_of("analyze", path)
            if report["mechanism"]["parameters"] and report.get("cases"):
                answer = json_of("sensitivity", path)
                faults = check_schemas.report_faults(answer, schema("sensitivity"))
                self.assertEqual(faults, [])
                self.assertEqual(answer["mechanism"], report["mechanism"])

    def test_have_tolerances_by_their_schema(self) -> None:
        count = 0
        for path in self.for_each():
            for options in (("--place", "0.1mm"), ("--along", "--angle", "0.1deg")):
                if output("tolerance", "json", path, *options):
                    answer = json_of("tolerance", path, *options)
                    faults = check_schemas.report_faults(answer, schema("tolerance"))
                    self.assertEqual(faults, [])
                    count += len(answer["cases"])
        self.assertGreater(count, 100)

    def test_have_a_header_without_a_sensitivity(self) -> None:
        path = ROOT / "mechanisms" / "planar" / "gripper.yaml"
        cases = json_of("sensitivity", path)["cases"]
        self.assertFalse(any(case["sensitivity"] for case in cases.values()))
        self.assertEqual(rows_of("sensitivity", path), [[*HEADER, "parameter"]])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    reports_test.PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
