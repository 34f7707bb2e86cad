#!/usr/bin/env python3
"""The reports of every mechanism: strict JSON by the schema, and CSV that says the same."""

from __future__ import annotations

import argparse
import csv
import io
import json
import re
import subprocess
import sys
import tempfile
import unittest
from functools import lru_cache
from pathlib import Path
from typing import Any, Iterator

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import check_schemas  # noqa: E402  (scripts/check_schemas.py)

PROGRAM = Path("kinestat")
HEADER = ["mechanism", "case", "pass", "element", "quantity", "value", "unit", "status"]
# Cases whose reports have states that no good mechanism has: null values among them.
STATES = ["parameter_never_used", "e0501_motions_missing", "e0602_no_equilibrium",
          "w0601_actions_indeterminate", "loads_on_a_linkage", "w0601_self_stresses",
          "stiffness_shares_a_load", "minimum_norm_is_labelled",
          "losses_and_friction_of_bearings", "drive_in_reverse", "motion_as_json_and_csv"]
# A topology without dimensions, which only `kinestat mobility` answers.
COUNTED = ROOT / "mechanisms" / "cables" / "surgical_instrument.yaml"
# Tasks, which hold no mechanism and have reports of their own.
TASKS = ROOT / "mechanisms" / "synthesis"
# Where the CSV table of a pass finds its values: the quantity names the section.
SECTIONS = {
    "kinematics": {"rate": "freedoms", None: "bodies"},
    "statics": {"action": "actions", "load": "loads", "friction": "friction",
                "planet": "planets", "contact": "contacts", "converter": "converters",
                None: "couplings"},
    "power": {"into_head": "couplings", "supplied": "supplied", "actuator": "actuators",
              "load": "loads", "friction": "friction", "body": "bodies", "mesh": "meshes"},
    "dynamics": {"body": "bodies", "reduced": "reduced"},
}

# Tables have the ratio of a case in the pass of its magnitudes.
RATIOS = {"kinematics": "ratio", "statics": "torque_ratio", "power": None, "dynamics": None}

LOSSES = {"loss": "meshes", "lossy_friction": "friction", "lossy_action": "actuators"}


def states() -> list[Path]:
    return [ROOT / "tests" / "cli" / name / "file.yaml" for name in STATES]


def files() -> list[Path]:
    found = sorted(path for path in (ROOT / "mechanisms").rglob("*.yaml")
                   if path != COUNTED and path.parent != TASKS)
    return found + states()


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


def is_count_or_number(value: Any) -> bool:
    return value is not None and not isinstance(value, bool)


@lru_cache(maxsize=None)
def output(command: str, style: str, path: Path, *options: str) -> bytes:
    arguments = [command, "--format", style, *(["--matrices"] if command == "graph" else []),
                 *options]
    done = subprocess.run(
        [PROGRAM, *arguments, str(path)], capture_output=True, check=False, timeout=120
    )
    return done.stdout


def json_of(command: str, path: Path, *options: str) -> Any:
    return json.loads(output(command, "json", path, *options))


def rows_of(command: str, path: Path) -> list[list[str]]:
    text = output(command, "csv", path).decode("utf-8")
    return list(csv.reader(io.StringIO(text, newline=""), strict=True))


def schema(name: str = "report") -> Any:
    return check_schemas.read_strictly(ROOT / "schemas" / f"{name}.schema.json")


def numbers(value: Any) -> Iterator[Any]:
    """The numbers and nulls of a JSON value."""
    if isinstance(value, (dict, list)):
        for item in value.values() if isinstance(value, dict) else value:
            yield from numbers(item)
    elif value is None or isinstance(value, (int, float)) and not isinstance(value, bool):
        yield value


# Of the components of vectors and screws, by their names in tables.
COMPONENTS = {f"{letter}{axis}": first + i for letter, first in
              (("", 0), ("w", 0), ("v", 3), ("T", 0), ("R", 3)) for i, axis in enumerate("xyz")}


def quotient(above: str, below: str) -> str:
    return f"{above}/({below})" if re.search(r"[*/]", below) else f"{above}/{below}"


def item(values: list[Any], token: str) -> Any:
    return values[COMPONENTS[token] if token in COMPONENTS else int(token)]


def at(value: Any, path: str) -> Any:
    for token in filter(None, path.split("/")):
        value = item(value, token) if isinstance(value, list) else value[token]
    return value


def facts(value: Any) -> Iterator[Any]:
    """The words, numbers, and yes or no of a JSON value."""
    if isinstance(value, (dict, list)):
        for item in value.values() if isinstance(value, dict) else value:
            yield from facts(item)
    elif value is not None:
        yield value


def mobility_value(value: Any, path: str) -> str:
    """As the CSV writes it: words that end a path are 1, yes and no are 1 and 0, null is empty."""
    tokens = list(filter(None, path.split("/")))
    for i, token in enumerate(tokens):
        if isinstance(value, str):
            return "1" if value == "/".join(tokens[i:]) else "another word"
        value = item(value, token) if isinstance(value, list) else value[token]
    if value is None:
        return ""
    return json.dumps(int(value) if isinstance(value, bool) else value)


def shift_value(shift: Any, row: dict[str, str]) -> Any:
    if row["quantity"].startswith("change/"):
        change = next(one for one in shift["changes"]
                      if f"{one['from']} - {one['to']}" == row["element"])
        return change[row["quantity"].removeprefix("change/")]
    if not row["case"]:
        return shift[row["quantity"]]
    state = shift["states"][row["case"]]
    if row["quantity"] == "engaged":
        return int(row["element"] in state["engaged"])
    if row["quantity"].startswith("worst_"):
        worst = state[row["quantity"].removesuffix("/force")]
        return worst and worst["force"]
    if row["quantity"].startswith("reaction/"):
        return state["reactions"][row["element"]][row["quantity"].removeprefix("reaction/")]
    if row["quantity"].startswith("limits/"):
        return state["limits"][row["element"]][row["quantity"].removeprefix("limits/")]
    return at(state["elements"][row["element"]] if row["element"] else state, row["quantity"])


def shift_values(shift: Any) -> list[Any]:
    found = [shift[key] for key in ("possibilities", "net_freedom", "engaged", "span")]
    for change in shift["changes"]:
        found += numbers(change)
    for state in shift["states"].values():
        found += state["engaged"]
        for key, value in state.items():
            found += numbers(value) if key not in ("direction", "speed_shares", "torque_shares",
                                                   "reactions") else []
        for reaction in state.get("reactions", {}).values():
            found += [reaction["speed"], reaction["torque"]]
    return found


def json_value(report: Any, row: dict[str, str]) -> Any:
    """The value of the JSON report that a row of the CSV repeats."""
    if row["pass"] == "mobility":
        return at(report["mobility"][row["element"]], row["quantity"])
    if row["pass"] == "shift":
        return shift_value(report["shift"], row)
    case = report["cases"][row["case"]]
    if row["quantity"] == RATIOS[row["pass"]]:
        return case[row["quantity"]]
    value = case[row["pass"]]
    if not row["element"]:
        return at(value, row["quantity"])
    sections = SECTIONS[row["pass"]]
    section, _, path = row["quantity"].partition("/")
    if section in LOSSES:
        return at(value["losses"][LOSSES[section]][row["element"]], path)
    if section == "self_stress":
        return value["self_stresses"][int(path)]["actions"][row["element"]]
    if section == "arc":
        arc = value["arcs"][row["element"]]
        return arc["power"] if path == f"{arc['from']}/{arc['to']}" else "another way"
    if section == "loop":
        loop = value["recirculation"]["loops"][int(path)]
        powers = dict(zip(loop["couplings"], loop["powers"]))
        return powers.get(row["element"], "not in it")
    if section in sections:
        return at(value[sections[section]][row["element"]], path)
    return at(value[sections[None]][row["element"]], row["quantity"])


def repeated_values(report: Any) -> list[Any]:
    """All numbers and nulls that the CSV must hold."""
    found = []
    for order in ("minimal", "planar", "spatial"):
        counts = report["mobility"][order]
        found += [] if counts is None else numbers(counts)
    for case in report["cases"].values():
        for name, sections in SECTIONS.items():
            for section in sections.values() if name in case else []:
                found += numbers(case[name].get(section, {}))
            found += [case[key] for key in [RATIOS[name]] if name in case and key in case]
        for stress in case.get("statics", {}).get("self_stresses", []):
            found += numbers(stress["actions"])
        if "dynamics" in case:
            for key in ("kinetic_energy", "kinetic_energy_rate", "shaking", "ground"):
                found += numbers(case["dynamics"].get(key, {}))
        if "power" in case:
            found += numbers(case["power"].get("efficiency", {}))
            found += numbers(case["power"].get("losses", {}))
            found += [case["power"]["input"], case["power"]["balance_residual"]]
            found += [case["power"]["recirculation"]["factor"]]
            found += numbers(case["power"]["arcs"])
            for loop in case["power"]["recirculation"]["loops"]:
                found += loop["powers"]
    if "shift" in report:
        found += shift_values(report["shift"])
    return found


def status_of(report: Any, row: dict[str, str]) -> str:
    """That of the pass, but of contacts their belt_state and of what completes equilibrium the method."""
    if row["pass"] == "mobility":
        return "solved"
    if row["pass"] == "shift":
        return report["shift"]["states"][row["case"]]["class"] if row["case"] else "solved"
    if row["pass"] == "dynamics":
        return report["cases"][row["case"]]["kinematics"]["status"]
    value = report["cases"][row["case"]][row["pass"]]
    if row["pass"] == "statics" and row["quantity"].startswith("contact/"):
        return value["contacts"][row["element"]]["belt_state"]
    if row["pass"] != "statics" or "completion" not in value:
        return value["status"]
    actions = value["completion"]["actions"]
    couplings = [coupling["name"] for coupling in report["graph"]["couplings"]
                 if any(action in coupling["actuators"] or
                        action.startswith(coupling["name"] + ".") for action in actions)]
    is_action = re.match(r"action|planet", row["quantity"])
    is_coupling = not re.match(r"action|load|friction|planet|contact|self_stress", row["quantity"])
    is_completed = row["element"] in (actions if is_action else couplings if is_coupling else [])
    return value["completion"]["method"] if is_completed else value["status"]


class Reports(unittest.TestCase):
    def for_each(self) -> Iterator[Path]:
        for path in files():
            with self.subTest(str(path.relative_to(ROOT))):
                yield path

    def test_are_strict_json_by_the_schema(self) -> None:
        for path in self.for_each():
            for command in ("analyze", "graph"):
                with tempfile.NamedTemporaryFile(suffix=".json") as file:
                    Path(file.name).write_bytes(output(command, "json", path))
                    self.assertEqual(check_schemas.check(Path(file.name), schema()), [], command)

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
            of_cycle = [row for row in rows if row[2] == "dynamics"]
            self.assertEqual(bool(of_cycle), "dynamics" in motion)
            self.assertEqual(len(rows), len(cells) + rest + len(of_cycle))

    def test_have_trade_offs_by_their_schema(self) -> None:
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

    def test_have_the_same_trade_offs_in_csv(self) -> None:
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
            words = [row for row in rows_of("mobility", path)[1:] if row[3] == "repairs"]
            self.assertEqual(len(words), sum(1 for _ in facts(mobility["repairs"])), path)

    def test_have_a_synthesis_by_its_schema_and_the_same_in_csv(self) -> None:
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
                    self.assertIn(row["unit"], {quotient(above, below) for above in units
                                                for below in units}, row)
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
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
