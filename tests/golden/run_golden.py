#!/usr/bin/env python3
"""Compares the report of a mechanism with its golden one, by `kinestat compare`.

The golden of mechanisms/planar/four_bar.yaml is tests/golden/planar_four_bar/report.json. It guards
against change and is no evidence: that is what `published:` and tests/reference are for. With
--update it is written where it is missing or no longer holds.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TIMEOUT_S = 240
# A topology without dimensions is only counted.
COUNTED = {ROOT / "mechanisms" / "cables" / "surgical_instrument.yaml"}
# Tasks hold no mechanism to analyse.
TASKS = ROOT / "mechanisms" / "synthesis"
# Residuals and angles in dead points are rounding, and near positions leave few digits.
TASK_TOLERANCE = ("--atol", "1e-7")
NEAR_TOLERANCE = ("--atol", "1e-3", "--rtol", "1e-3")
# Of `kinestat analyze`: a mechanism may be there for a case without an answer.
WITH_REPORT = {0, 5}


def golden_of(mechanism: Path) -> Path:
    """The file that holds the expected report."""
    parts = mechanism.relative_to(ROOT / "mechanisms").with_suffix("").parts
    return ROOT / "tests" / "golden" / "_".join(parts) / "report.json"


def analyse(program: Path, mechanism: Path) -> subprocess.CompletedProcess[bytes]:
    """Runs in the repository, so that the report names the same path on every machine."""
    word = ("mobility" if mechanism in COUNTED else
            "synthesize" if mechanism.parent == TASKS else "analyze")
    command = [program, word, "--format", "json", mechanism.relative_to(ROOT)]
    return subprocess.run(
        command, cwd=ROOT, capture_output=True, check=False, timeout=TIMEOUT_S
    )


def tolerance_of(mechanism: Path) -> tuple[str, ...]:
    if mechanism.parent != TASKS:
        return ()
    return NEAR_TOLERANCE if "near" in mechanism.stem.split("_") else TASK_TOLERANCE


def differences(program: Path, golden: Path, report: bytes, tolerance: tuple[str, ...]) -> str:
    """What `kinestat compare` says, with its status; empty if the two are equal."""
    with tempfile.NamedTemporaryFile(suffix=".report.json") as file:
        Path(file.name).write_bytes(report)
        done = subprocess.run(
            [program, "compare", *tolerance, golden, file.name], capture_output=True, check=False,
            timeout=TIMEOUT_S,
        )
    text = (done.stdout + done.stderr).decode("utf-8", "replace")
    return f"{text}compare answered {done.returncode}" if done.returncode != 0 else ""


def update(golden: Path, report: bytes) -> None:
    golden.parent.mkdir(parents=True, exist_ok=True)
    golden.write_bytes(report)
    print(f"{golden}: rewritten")


def check(program: Path, mechanism: Path, rewrite: bool) -> str:
    """What is wrong; empty if the report is the golden one."""
    golden = golden_of(mechanism)
    name = golden.parent.name
    done = analyse(program, mechanism)
    if done.returncode not in WITH_REPORT or not done.stdout:
        return f"kinestat answered {done.returncode}:\n{done.stderr.decode('utf-8', 'replace')}"
    found = (differences(program, golden, done.stdout, tolerance_of(mechanism))
             if golden.is_file() else "missing")
    if not found:
        return ""
    if rewrite:
        update(golden, done.stdout)
        return ""
    if found == "missing":
        return (f"there is no golden report {golden.relative_to(ROOT)}: check the numbers against "
                f"the source, then run scripts/update_golden.sh {name}")
    return (f"{found}\nA is {golden.relative_to(ROOT)}. If the change is meant, explain it and run "
            f"scripts/update_golden.sh {name}")


def main() -> int:
    parser = argparse.ArgumentParser(description="Compare a mechanism's report with its golden one.")
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
