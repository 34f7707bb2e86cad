#!/usr/bin/env python3
"""The reports of studies of every mechanism, by their schemas, and CSV with the same values."""

from __future__ import annotations

import json

from report_case import (COUNTED, HEADER, ROOT, ReportCase, check_schemas, files, has_sanitizers,
                         json_of, output, rows_of, run_tests, schema, states)
from report_values import facts, mobility_value


class StudyReports(ReportCase):
    def test_have_the_same_shift_table_alone(self) -> None:
        for path in self.for_each():
            report = json_of("analyze", path)
            if "shift" in report:
                answer = json_of("shift", path)
                self.assertEqual(check_schemas.report_faults(answer, schema()), [])
                self.assertEqual(answer["shift"], report["shift"])
                rows = [row for row in rows_of("analyze", path) if row[2] == "shift"]
                self.assertEqual(rows_of("shift", path)[1:], rows)

    def test_have_the_same_motion_alone_and_in_csv(self) -> None:
        for path in self.for_each():
            report = json_of("analyze", path)
            if "motion" not in report:
                continue
            answer = json_of("motion", path)
            self.assertEqual(check_schemas.report_faults(answer, schema()), [])
            motion = answer["motion"]
            self.assertEqual(motion, report["motion"])
            header, *rows = rows_of("motion", path)
            self.assertEqual(header, [*HEADER, "step", "drive"])
            columns = motion["columns"][1:-1]
            cells = [(column, row) for row in motion["rows"] for column in columns]
            for text, (column, row) in zip(rows, cells):
                value = row[1 + columns.index(column)]
                self.assertEqual(text, [
                    report["mechanism"]["name"], motion["case"] or "", "motion", column["element"],
                    column["quantity"], "" if value is None else json.dumps(value),
                    column["unit"], row[-1], str(row[0]), json.dumps(row[1])])
            rest = sum(len(event["drive"]) + 1 for event in motion["events"])
            gaps = motion["assembly"]["drawn_gaps"], motion["assembly"]["nearest_gaps"]
            rest += sum(2 * len(one) for one in gaps) + 4 * len(motion["assembly"]["corrections"])
            rest += motion.get("overall_efficiency") is not None
            of_cycle = [row for row in rows if row[2] == "dynamics"]
            self.assertEqual(bool(of_cycle), "dynamics" in motion)
            self.assertEqual(len(rows), len(cells) + rest + len(of_cycle))

    def test_have_a_mobility_by_its_schema(self) -> None:
        for path in self.for_each():
            report = json_of("analyze", path)
            if "mobility" in report:
                answer = json_of("mobility", path)
                faults = check_schemas.report_faults(answer, schema("mobility"))
                self.assertEqual(faults, [])
                self.assertEqual(answer["mechanism"], report["mechanism"])

    def test_count_a_file_without_dimensions(self) -> None:
        answer = json_of("mobility", COUNTED)

        self.assertEqual(check_schemas.report_faults(answer, schema("mobility")), [])
        self.assertIsNone(answer["mobility"]["counts"])
        self.assertEqual(answer["mobility"]["grubler"]["spatial"]["mobility"], 13)

    def test_have_the_same_mobility_in_csv_and_json(self) -> None:
        for path in self.for_each():
            mobility = json_of("mobility", path)["mobility"]
            for row in (dict(zip(HEADER, row)) for row in rows_of("mobility", path)[1:]):
                value = mobility_value(mobility, f"{row['element']}/{row['quantity']}")
                self.assertEqual(row["value"], value, row)
            words = [row for row in rows_of("mobility", path)[1:] if row[3].startswith("repairs")]
            self.assertEqual(len(words), sum(1 for _ in facts(mobility["repairs"])), path)

    def test_have_inputs_by_their_schema(self) -> None:
        # In the library some take seconds, with sanitizers minutes.
        for path in self.for_each(states() if has_sanitizers() else files()):
            answer = json_of("inputs", path)
            self.assertEqual(check_schemas.report_faults(answer, schema("inputs")), [])
            counts = json_of("analyze", path)["mobility"]["minimal"]
            self.assertEqual(answer["inputs"]["motion"]["needed"], counts["net_freedom"])
            for row in (dict(zip(HEADER, row)) for row in rows_of("inputs", path)[1:]):
                self.assertEqual((row["pass"], row["case"]), ("inputs", ""))
                side, key = row["quantity"].split("/")
                value = answer["inputs"][side].get(key)
                if key == "drives":
                    self.assertIn(row["unit"], ("", "m", "mm"))
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


class TradeOffs(ReportCase):
    def test_are_told_by_their_schema(self) -> None:
        for path in self.for_each():
            if path.name in ("four_bar.yaml", "ravigneaux.yaml"):
                answer = json_of("bench", path)
                self.assertEqual(check_schemas.report_faults(answer, schema("bench")), [])
                for side in (s for case in answer["bench"].values() for s in case.values()):
                    if side["status"] == "measured":
                        self.check_front(list(side["methods"].values()))

    def check_front(self, methods: list[dict]) -> None:
        def beats(one: dict, other: dict) -> bool:
            pairs = [(one[key], other[key]) for key in ("time", "worst_error")]
            return all(a <= b for a, b in pairs) and any(a < b for a, b in pairs)

        judged = [method for method in methods if method["worst_error"] is not None]
        for method in methods:
            is_best = method in judged and not any(beats(other, method) for other in judged)
            self.assertEqual(method["pareto"], is_best)

    def test_are_the_same_in_csv(self) -> None:
        path = ROOT / "mechanisms" / "planar" / "four_bar.yaml"
        answer = json_of("bench", path)
        sides = [side for case in answer["bench"].values() for side in case.values()]
        rows = [dict(zip(HEADER, row)) for row in rows_of("bench", path)[1:]]
        # Two numbers a side; four of each method, three of each extreme. Times are of another run.
        count = sum(2 + len(s["methods"]) * (4 + 3 * 6) for s in sides if s["status"] == "measured")
        self.assertEqual(len(rows), count)
        for row in rows:
            side, *keys = row["quantity"].split("/")
            value = answer["bench"][row["case"]][side]
            for key in ([] if row["element"] == "" else ["methods", row["element"]]) + keys:
                value = value[key]
            if keys[-1] in ("unknowns", "error", "value_error", "bound", "worst_error"):
                self.assertEqual(row["value"], "" if value is None else json.dumps(value), row)


if __name__ == "__main__":
    run_tests(__doc__)
