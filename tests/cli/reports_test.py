#!/usr/bin/env python3
"""The reports of every mechanism: strict JSON by the schema, and CSV with the same values."""

from __future__ import annotations

import json
import re
import tempfile
import unittest
from collections import Counter
from pathlib import Path

from report_case import (HEADER, ROOT, ReportCase, check_schemas, files, json_of, output, rows_of,
                         run_tests, schema, states)
from report_values import RATIOS, json_value, repeated_values, status_of


def powers(unit: str) -> Counter[str]:
    """Of each of its parts, below zero where it divides; "N*s/(mm*kg)" has one stroke."""
    found: Counter[str] = Counter()
    above, _, below = unit.partition("/")
    for part, sign in ((above, 1), (below, -1)):
        for name, power in re.findall(r"([A-Za-z]+)(?:\^(\d+))?", part):
            found[name] += sign * int(power or 1)
    return Counter({name: power for name, power in found.items() if power})


def is_quotient(unit: str, above: str, below: str) -> bool:
    apart = powers(above)
    apart.subtract(powers(below))
    return powers(unit) == Counter({name: power for name, power in apart.items() if power})


class Reports(ReportCase):
    def test_are_strict_json_by_the_schema(self) -> None:
        for path in self.for_each():
            for command in ("analyze", "graph"):
                with tempfile.NamedTemporaryFile(suffix=".json") as file:
                    Path(file.name).write_bytes(output(command, "json", path))
                    self.assertEqual(check_schemas.check(Path(file.name), schema()), [], command)

    def test_end_lines_with_lf_and_hold_no_minus_zero(self) -> None:
        # Those of the mechanisms are read by the case files_of_every_mechanism.
        for path in states():
            for command in ("analyze", "graph"):
                for style in ("json", "csv", "table"):
                    text = output(command, style, path)
                    self.assertTrue(text.endswith(b"\n"), (command, style))
                    self.assertNotIn(b"\r", text)
                    self.assertNotRegex(text, rb"(?<![\w.])-0(\.0*)?(?![\w.])", (command, style))
                    self.assertNotRegex(text, rb"(?i)(?<![\w])[+-]?(nan|inf|infinity)(?![\w])")

    def test_write_the_csv_header_once(self) -> None:
        for path in self.for_each():
            rows = rows_of("analyze", path)
            self.assertEqual(rows[0], HEADER)
            self.assertEqual(rows.count(HEADER), 1)
            self.assertEqual({len(row) for row in rows}, {len(HEADER)})

    def test_have_the_same_values_in_csv_and_json(self) -> None:
        for path in self.for_each():
            report = json_of("analyze", path)
            rows = [dict(zip(HEADER, row)) for row in rows_of("analyze", path)[1:]]
            for row in rows:
                value = json_value(report, row)
                self.assertEqual(row["value"], "" if value is None else json.dumps(value), row)
            self.assertEqual(len(rows), len(repeated_values(report)))

    def test_name_mechanism_status_and_unit_in_the_csv(self) -> None:
        for path in self.for_each():
            report = json_of("analyze", path)
            units = {"", *report["mechanism"]["units"].values()}
            for row in (dict(zip(HEADER, row)) for row in rows_of("analyze", path)[1:]):
                self.assertEqual(row["mechanism"], report["mechanism"]["name"])
                self.assertEqual(row["status"], status_of(report, row), row)
                ratio_unit = report.get("cases", {}).get(row["case"], {}).get(
                    f"{RATIOS.get(row['pass'])}_unit", "")
                is_ratio = row["quantity"] == RATIOS.get(row["pass"])
                if "acceleration" in row["quantity"]:
                    own = report["mechanism"]["units"]
                    self.assertIn(row["unit"], {f"{own[key]}/{own['time']}^2"
                                                for key in ("angle", "length")}, row)
                    continue
                if "self_stress" in row["quantity"]:  # for one unit of its first action
                    self.assertTrue(any(is_quotient(row["unit"], above, below)
                                        for above in units for below in units), row)
                    continue
                self.assertIn(row["unit"], {ratio_unit} if is_ratio else units, row)

    def test_have_the_same_matrices_in_csv_and_json(self) -> None:
        for path in self.for_each():
            wanted = [["matrix", "row", "column", "value"]]
            for symbol, matrix in json_of("graph", path)["graph"]["matrices"].items():
                for label, values in zip(matrix["rows"], matrix["values"]):
                    wanted += [[symbol, label, column, json.dumps(value)]
                               for column, value in zip(matrix["columns"], values)]
            self.assertEqual(rows_of("graph", path), wanted)

    def test_write_whole_doubles_with_a_point(self) -> None:
        for path in self.for_each():
            for row in rows_of("graph", path)[1:]:
                self.assertRegex(row[3], r"^-?\d+(\.\d+|(\.\d+)?e[+-]\d+)$")


class Goldens(unittest.TestCase):
    def test_are_of_mechanisms_that_exist(self) -> None:
        library = ROOT / "mechanisms"
        names = {"_".join(path.relative_to(library).with_suffix("").parts)
                 for path in library.rglob("*.yaml")}
        for pattern in ("*/report.json", "*/folded.txt"):
            for path in sorted((ROOT / "tests" / "golden").glob(pattern)):
                self.assertIn(path.parent.name, names, "remove the folder")


class Schema(unittest.TestCase):
    def test_refuses_a_text_for_a_number(self) -> None:
        report = json_of("analyze", files()[0])
        text = json.dumps(report)
        first = re.search(r'"balance_residual": [^,}]+', text)

        changed = json.loads(text.replace(first[0], '"balance_residual": "small"'))

        self.assertNotEqual(check_schemas.report_faults(changed, schema()), [])

if __name__ == "__main__":
    run_tests(__doc__)
