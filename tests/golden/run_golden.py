#!/usr/bin/env python3
"""Compares what the program says of a mechanism with its golden, by `kinestat compare`.

The golden of mechanisms/planar/four_bar.yaml is in tests/golden/planar_four_bar: folded.txt, the
tables of the mechanism as folded.py writes them, or report.json for those in WHOLE. It guards
against change and is no evidence: that is what `published:` and tests/reference are for. With
--update it is written where it is missing or no longer holds.

folded.txt holds the name of the mechanism, how often each code of a diagnostic occurs, the tables
of `kinestat analyze` (of counted mechanisms `mobility`, of tasks `synthesize`), of `motion` and of
`simulate`, of which every tenth row, and the words of the JSON report, most of which are in no
table. Left out are evidence, residuals, sentences and what repeats the file; axes and pitches of
screws and the powers between bodies, which follow from twists and wrenches (whole reports have
them); and, of gearboxes, what each coupling does in each gear and each change, held for those in
EVERY_COUPLING: of the others the golden has ratios, torques, slips and losses of gears and elements.
"""

from __future__ import annotations

import argparse
import csv
import io
import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, Iterable, Iterator

import folded
from folded import Row

ROOT = Path(__file__).resolve().parents[2]
TIMEOUT_S = 240
# Whole reports, with their evidence: of a linkage, a belt, a gear with losses and a task.
WHOLE = {"cables_open_belt", "gears_worm_drive", "sweeps_four_bar_height",
         "synthesis_do_valle_table_5"}
# Of these gearboxes the couplings and changes are held too: without and with losses, in teeth, on
# several axes.
EVERY_COUPLING = {"transmissions_ravigneaux", "transmissions_ravigneaux_with_losses",
                  "transmissions_ravigneaux_input_shaft", "transmissions_ravigneaux_teeth",
                  "transmissions_vw_02j"}
DERIVED = ("screw/", "arc/")
OF_COUPLINGS = {"kinematics", "statics", "power"}
# A topology without dimensions is only counted.
COUNTED = {ROOT / "mechanisms" / "cables" / "surgical_instrument.yaml"}
# Tasks hold no mechanism to analyse.
TASKS = ROOT / "mechanisms" / "synthesis"
# Residuals and angles in dead points are rounding, and near positions leave few digits.
TASK_TOLERANCE = ("--atol", "1e-7")
NEAR_TOLERANCE = ("--atol", "1e-3", "--rtol", "1e-3")
# Of `kinestat analyze`: a mechanism may be there for a case without an answer.
WITH_REPORT = {0, 5}
COLUMNS = ["mechanism", "case", "pass", "element", "quantity", "value", "unit", "status"]
MOTION_COLUMNS = [*COLUMNS, "step", "drive"]
IN_TIME = {"motion", "simulation"}  # passes with these columns
# Rounding alone, which differs from machine to machine.
RESIDUALS = {"balance_residual", "closure_error", "error", "residual", "uncertainty"}
# Simulations add up the rounding of every step; their files ask for 1e-11 a step.
SIMULATED_TOLERANCE = ("--atol", "1e-7", "--rtol", "1e-7")
EVERY = 10
# Parts of a report whose words are sentences, are in the tables, or repeat the file.
NO_WORDS = {"arcs", "columns", "diagnostics", "engaged", "evidence", "graph", "kinestat",
            "mechanism", "primary", "reason", "reasons", "remarks", "rows"}


class NoAnswer(Exception):
    """The program did not answer, or not as it should; says how."""


def golden_of(mechanism: Path) -> Path:
    """The file that holds what is expected."""
    parts = mechanism.relative_to(ROOT / "mechanisms").with_suffix("").parts
    folder = ROOT / "tests" / "golden" / "_".join(parts)
    return folder / ("report.json" if folder.name in WHOLE else "folded.txt")


def command_of(mechanism: Path) -> str:
    if mechanism in COUNTED:
        return "mobility"
    return "synthesize" if mechanism.parent == TASKS else "analyze"


def output(program: Path, command: str, style: str, mechanism: Path) -> bytes:
    """Runs in the repository, so that the report names the same path on every machine."""
    done = subprocess.run(
        [program, command, "--format", style, mechanism.relative_to(ROOT)], cwd=ROOT,
        capture_output=True, check=False, timeout=TIMEOUT_S,
    )
    if done.returncode not in WITH_REPORT or not done.stdout:
        raise NoAnswer(f"kinestat {command} --format {style} answered {done.returncode}:\n"
                       f"{done.stderr.decode('utf-8', 'replace')}")
    return done.stdout


def read_table(table: bytes) -> tuple[str, list[Row]]:
    """Name of the mechanism, and the rows of a table without residuals."""
    lines = list(csv.DictReader(io.StringIO(table.decode("utf-8"), newline=""), strict=True))
    rows = [Row(line["case"], line["pass"], line["element"], line["quantity"], line["value"],
                line["unit"], line["status"], line.get("step", "")) for line in lines]
    return (lines[0]["mechanism"] if lines else "",
            [row for row in rows if row.quantity.rpartition("/")[2] not in RESIDUALS])


def words(value: Any, path: tuple[str, ...] = ()) -> Iterator[Row]:
    """The words of a report, and its yes and no, as rows."""
    if isinstance(value, (dict, list)):
        for key, item in value.items() if isinstance(value, dict) else enumerate(value):
            if key not in NO_WORDS:
                yield from words(item, (*path, str(key)))
    elif isinstance(value, (str, bool)):
        yield word(value if isinstance(value, str) else str(value).lower(), path)


def word(value: str, path: tuple[str, ...]) -> Row:
    """Its quantity is the key, with the number in a list."""
    case, place = (path[1], path[2:]) if path[0] == "cases" else ("", path)
    cut = -2 if place[-1].isdigit() else -1
    return Row(case, "words", "/".join(place[:cut]), "/".join(place[cut:]), value, "")


def findings(report: Any) -> Iterator[Row]:
    """How often each code occurs."""
    codes = [one["code"] for one in report.get("diagnostics", [])]
    for code in sorted(set(codes)):
        yield Row("", "findings", code, "count", str(codes.count(code)), "")


def examine(program: Path, mechanism: Path) -> tuple[str, list[Row]]:
    """Name of the mechanism, and all that the golden holds of it."""
    command = command_of(mechanism)
    report = json.loads(output(program, command, "json", mechanism))
    name, rows = read_table(output(program, command, "csv", mechanism))
    if "motion" in report:
        rows += read_table(output(program, "motion", "csv", mechanism))[1]
    if is_simulated(mechanism):
        rows += [row for row in read_table(output(program, "simulate", "csv", mechanism))[1]
                 if not row.step or int(row.step) % EVERY == 0]
    told = [*rows, *words(report)]
    if "shift" in report and golden_of(mechanism).parent.name not in EVERY_COUPLING:
        told = filter(is_of_gear, told)
    return name, [*findings(report), *(row for row in told if not row.quantity.startswith(DERIVED))]


def is_of_gear(row: Row) -> bool:
    """Not of its couplings, nor of a change to another gear."""
    if row.part == "words":
        return row.case == ""
    return row.part not in OF_COUPLINGS and not row.quantity.startswith("change/")


def is_simulated(mechanism: Path) -> bool:
    return "\nsimulation:" in mechanism.read_text(encoding="utf-8")


def is_exact(row: Row) -> bool:
    return row.part in ("findings", "words")


def table_of(name: str, rows: Iterable[Row], columns: list[str]) -> str:
    """As the program writes it."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(columns)
    for row in rows:
        cells = [name, *row[:-1], *([row.step, ""] if columns is MOTION_COLUMNS else [])]
        table.writerow(cells)
    return text.getvalue()


def tolerance_of(mechanism: Path) -> tuple[str, ...]:
    if is_simulated(mechanism):
        return SIMULATED_TOLERANCE
    if mechanism.parent != TASKS:
        return ()
    return NEAR_TOLERANCE if "near" in mechanism.stem.split("_") else TASK_TOLERANCE


def differences(program: Path, expected: bytes, found: bytes, tolerance: tuple[str, ...]) -> str:
    """What `kinestat compare` says, with its status; empty if the two are equal."""
    with tempfile.TemporaryDirectory() as folder:
        files = [Path(folder) / "golden", Path(folder) / "found"]
        for file, text in zip(files, (expected, found)):
            file.write_bytes(text)
        done = subprocess.run(
            [program, "compare", *tolerance, *files], capture_output=True, check=False,
            timeout=TIMEOUT_S,
        )
    text = (done.stdout + done.stderr).decode("utf-8", "replace")
    return f"{text}compare answered {done.returncode}" if done.returncode != 0 else ""


def table_differences(program: Path, expected: tuple[str, list[Row]], found: tuple[str, list[Row]],
                      tolerance: tuple[str, ...]) -> str:
    """Of the numbers: those of motions and simulations are a table of their own form."""
    said = []
    for columns in (COLUMNS, MOTION_COLUMNS):
        tables = [[row for row in rows if not is_exact(row) and
                   (row.part in IN_TIME) == (columns is MOTION_COLUMNS)]
                  for _, rows in (expected, found)]
        if any(tables):
            texts = [table_of(name, rows, columns).encode("utf-8")
                     for (name, _), rows in zip((expected, found), tables)]
            said.append(differences(program, *texts, tolerance))
    return "\n".join(filter(None, said))


def word_differences(expected: list[Row], found: list[Row]) -> str:
    """Of what is equal or not: words and findings."""
    golden = set(filter(is_exact, expected))
    there = set(folded.unfold(folded.fold(filter(is_exact, found))))
    return "\n".join(f"only in {side}: {' '.join(folded.fold([row]).splitlines())}"
                     for side, rows in (("A", golden - there), ("B", there - golden))
                     for row in sorted(rows))


def check_folded(program: Path, mechanism: Path, golden: Path) -> tuple[str, bytes]:
    """What differs, and what the golden should be."""
    name, rows = examine(program, mechanism)
    text = f"{name}\n{folded.fold(rows)}".encode("utf-8")
    if not golden.is_file():
        return "missing", text
    title, _, lines = golden.read_text("utf-8").partition("\n")
    try:
        expected = folded.unfold(lines)
    except ValueError as error:
        return f"{golden.name} is damaged: {error}", text
    said = [table_differences(program, (title, expected), (name, rows), tolerance_of(mechanism)),
            word_differences(expected, rows)]
    return "\n".join(filter(None, said)), text


def check_whole(program: Path, mechanism: Path, golden: Path) -> tuple[str, bytes]:
    report = output(program, command_of(mechanism), "json", mechanism)
    if not golden.is_file():
        return "missing", report
    return differences(program, golden.read_bytes(), report, tolerance_of(mechanism)), report


def update(golden: Path, text: bytes) -> None:
    golden.parent.mkdir(parents=True, exist_ok=True)
    golden.write_bytes(text)
    print(f"{golden}: rewritten")


def check(program: Path, mechanism: Path, rewrite: bool) -> str:
    """What is wrong; empty if the golden holds."""
    golden = golden_of(mechanism)
    name = golden.parent.name
    try:
        ways = check_whole if name in WHOLE else check_folded
        found, text = ways(program, mechanism, golden)
    except NoAnswer as answer:
        return str(answer)
    if not found:
        return ""
    if rewrite:
        update(golden, text)
        return ""
    if found == "missing":
        return (f"there is no golden {golden.relative_to(ROOT)}: check the numbers against "
                f"the source, then run scripts/update_golden.sh {name}")
    return (f"{found}\nA is {golden.relative_to(ROOT)}. If the change is meant, explain it and run "
            f"scripts/update_golden.sh {name}")


def main() -> int:
    parser = argparse.ArgumentParser(description="Compare a mechanism with its golden.")
    parser.add_argument("mechanism", type=Path)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    mechanism = arguments.mechanism.resolve()
    problem = check(arguments.program.resolve(), mechanism, arguments.update)
    if problem:
        print(f"{mechanism.relative_to(ROOT)}: {problem}", file=sys.stderr)
    return 1 if problem else 0


if __name__ == "__main__":
    sys.exit(main())
