"""What must agree between the reports of one file, for any file.

Each oracle takes the reports as written and yields the disagreements.
"""

from __future__ import annotations

import csv
import io
import json
import math
import re
import sys
from typing import Any, Iterator

from program import ROOT

sys.path.insert(0, str(ROOT / "tests" / "cli"))
sys.path.insert(0, str(ROOT / "tests" / "differential"))
import passes  # noqa: E402
import report_values  # noqa: E402

# Of a table of the text: a name, a number, and its unit.
ROW = r"^ +{} +(-?[\d.]+(?:e[+-]\d+)?) +[A-Za-z]"
SIDES = (("kinematics", "freedoms"), ("statics", "actions"))
# Without a bound, where doubles alone have proved nine digits.
FAST = 1e-6
PROVED = 1e-9
FIRST_ROW = 1e-7
ROUNDINGS = 1e-12


def strict(text: bytes) -> Any:
    def refuse(token: str) -> None:
        raise ValueError(f"{token} is no JSON")
    return json.loads(text, parse_constant=refuse)


def csv_as_json(report: Any, table: bytes) -> Iterator[str]:
    """Each row of the table has the value that the report has there, and none is missing."""
    if "mobility" not in report:
        return  # a task of synthesis
    rows = list(csv.reader(io.StringIO(table.decode("utf-8"), newline=""), strict=True))
    for row in (dict(zip(rows[0], cells)) for cells in rows[1:]):
        value = report_values.json_value(report, row)
        if row["value"] != ("" if value is None else json.dumps(value)):
            yield f"CSV has {row}, JSON {value!r}"
    if len(rows) - 1 != len(report_values.repeated_values(report)):
        yield f"CSV has {len(rows) - 1} values, JSON {len(report_values.repeated_values(report))}"


def text_as_json(report: Any, text: bytes) -> Iterator[str]:
    """Rates and actions of the tables, which stand there with six digits."""
    parts = re.split(r"^Case (.*)$", text.decode("utf-8"), flags=re.M)
    told = dict(zip(parts[1::2], parts[2::2]))
    for label, case in report.get("cases", {}).items():
        said = told.get(label, "")
        for side, group in SIDES:
            values = (case.get(side) or {}).get(group) or {}
            for name, value in values.items():
                rows = re.findall(ROW.format(re.escape(name)), said, re.M)
                if value is not None and rows and not any(
                        abs(float(row) - value) <= 1e-5 * abs(value) for row in rows):
                    yield f"{label}: the text has {name} = {rows}, JSON {value!r}"


def _values(report: Any, side: str, group: str) -> Iterator[tuple[str, dict, dict]]:
    for label, case in report.get("cases", {}).items():
        one = case.get(side) or {}
        if one.get("status") == "solved" and isinstance(one.get(group), dict):
            yield label, one[group], one.get("evidence") or {}


def accuracies(auto: Any, other: Any, is_fast: bool) -> Iterator[str]:
    """`auto` against `fast` where doubles proved it, or against `high` or `exact` by the bounds."""
    for side, group in SIDES:
        theirs = {label: (values, evidence) for label, values, evidence in
                  _values(other, side, group)}
        for label, values, evidence in _values(auto, side, group):
            if label not in theirs:
                continue
            bound = share(evidence, theirs[label][1], is_fast)
            if bound is None:
                continue
            largest = max((abs(v) for v in values.values() if v is not None), default=0.0)
            for name in values.keys() & theirs[label][0].keys():
                one, two = values[name], theirs[label][0][name]
                if one is not None and two is not None and abs(one - two) > (
                        bound * max(abs(one), abs(two)) + ROUNDINGS * largest):
                    yield f"{label}: {name} is {one!r} with auto, {two!r} with the other"


def share(auto: dict, other: dict, is_fast: bool) -> float | None:
    """None where nothing is promised of the two together."""
    bound = auto.get("error_bound")
    if bound is None:
        return None
    if is_fast:
        return FAST if auto.get("precision") == "double" and bound < PROVED else None
    if auto.get("refers_to") != other.get("refers_to") or other.get("error_bound") is None:
        return None
    return bound + other["error_bound"] + 1e-15


def first_row(analysis: Any, motion: Any) -> Iterator[str]:
    """A motion that begins where the mechanism is drawn begins as analysed."""
    told = motion.get("motion") or {}
    rows, label = told.get("rows"), told.get("case")
    case = analysis.get("cases", {}).get(label)
    if not rows or not case or any(_as_number(rows[0][i]) != 0 for i in _drives(told)):
        return
    if rows[0][-1] != "solved" or not _drives(told):
        return
    if any((case.get(side) or {}).get("status", "solved") != "solved" for side, _ in SIDES):
        return
    true = passes.of_analysis({"cases": {passes.CASE: case}})
    true.values["quotient"].pop("mechanical_advantage")  # it is not among what is analysed
    # Rates are sums of products with coordinates, and lose the digits that these cancel.
    largest = max((abs(one) for one in rows[0] if isinstance(one, (int, float))), default=0.0)
    row = passes.of_first_row(motion)
    for kind, values in row.values.items():
        for name, value in list(values.items()):
            other = true.values.get(kind, {}).get(name)
            if None not in (value, other) and abs(value - other) <= 1e-13 * largest:
                del values[name]
    yield from passes.compare("motion", row, true, FIRST_ROW)


def _drives(motion: dict) -> list[int]:
    return [i for i, column in enumerate(motion["columns"]) if column["quantity"] == "drive"]


def _as_number(value: Any) -> float:
    return float(value) if isinstance(value, (int, float)) else math.nan
