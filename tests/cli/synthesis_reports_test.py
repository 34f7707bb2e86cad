#!/usr/bin/env python3
"""The reports of synthesis tasks: strict JSON by their schemas, and CSV with the same values."""

from __future__ import annotations

import json
import unittest
from pathlib import Path

from report_case import (HEADER, ROOT, TASKS, at, check_schemas, is_count_or_number, json_of, numbers,
                         rows_of, run_tests, schema)


def of_transmissions(path: Path) -> bool:
    return "transmission:" in path.read_text("utf-8")


def tasks() -> list[Path]:
    """The tasks of linkages of the library and of the cases that have an answer."""
    folders = ("synthesize_tables_of_the_source", "synthesize_families",
               "synthesize_few_positions", "synthesize_coupler_curves")
    selections = ROOT / "tests" / "cli" / "synthesize_selection"
    return [*(selections / f"{name}.yaml" for name in ("ratio", "point", "narrow")),
            *sorted(path for folder in (TASKS, *(ROOT / "tests" / "cli" / one for one in folders))
                    for path in folder.glob("*.yaml") if not of_transmissions(path))]


class SynthesisReports(unittest.TestCase):
    def test_have_linkages_by_their_schema_and_the_same_in_csv(self) -> None:
        for path in tasks():
            with self.subTest(path=path):
                answer = json_of("synthesize", path)
                faults = check_schemas.report_faults(answer, schema("synthesis"))
                self.assertEqual(faults, [])
                rows = [dict(zip(HEADER, row)) for row in rows_of("synthesize", path)[1:]]
                for row in rows:
                    synthesis = answer["synthesis"]
                    part = synthesis["tasks"][int(row["case"])] if row["case"] else synthesis
                    value = at(part, f"{row['element']}/{row['quantity']}")
                    self.assertEqual(row["value"], json.dumps(value), row)
                found = list(numbers(answer["synthesis"]))
                self.assertEqual(len(rows), sum(is_count_or_number(one) for one in found))

    def test_have_transmissions_by_their_schema_and_the_same_in_csv(self) -> None:
        for path in filter(of_transmissions, sorted(TASKS.glob("*.yaml"))):
            with self.subTest(path=path):
                answer = json_of("synthesize", path)
                self.assertEqual(
                    check_schemas.report_faults(answer, schema("transmission")), [])
                found = answer["transmissions"]
                rows = [dict(zip(HEADER, row)) for row in rows_of("synthesize", path)[1:]]
                for row in rows:
                    part = found
                    if row["case"]:
                        group, variant = row["case"].split(".")
                        part = found["groups"][group]["variants"][variant]
                    key, *keys = row["quantity"].split("/")
                    if row["element"] == "stages":
                        keys, key = [key], "stages"
                    elif row["element"]:
                        keys = [row["element"], *keys]
                    value = at(part, "/".join([key, *keys]))
                    self.assertEqual(row["value"], json.dumps(value), row)
                self.assertEqual(len({tuple(row[one] for one in HEADER[:5]) for row in rows}),
                                 len(rows))
                numbered = list(numbers(found))
                self.assertEqual(len(rows), sum(is_count_or_number(one) for one in numbered))

if __name__ == "__main__":
    run_tests(__doc__)
