#!/usr/bin/env python3
"""Runs the fuzz targets for some minutes and notes what was run and found.

Usage: campaign.py MINUTES [--seed S] [--only TARGETS] | --write

The targets share the time. Those of libFuzzer are run from build/fuzz; `mechanism`, where it is not
there, with random bytes from build/sanitize or build/release; `files` is tests/faults/mutation_test.py.
Inputs with complaints are kept in build/found. Each run is a line of log.jsonl, from which --write
makes the table in RELIABILITY.md. Exit status 1 if anything was found.
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import re
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
from written_part import WrittenPart  # noqa: E402

HERE = Path(__file__).resolve().parent
LOG = HERE / "log.jsonl"
FOUND = ROOT / "build/found"
PART = WrittenPart(ROOT / "RELIABILITY.md",
                   "<!-- written by tests/fuzz/campaign.py --write: -->", "<!-- end of fuzzing -->")
LONGEST = {"units": 40, "expression": 80, "reader": 2000, "mechanism": 40}  # bytes of an input
TARGETS = (*LONGEST, "files")
MOST = 50  # findings of a target, after which it is not worth while to go on
# Freed memory is kept for as long as a small input needs: more of it is slower, not better.
SANITIZERS = {"ASAN_OPTIONS": "quarantine_size_mb=8:malloc_context_size=5"}


@dataclass
class Record:
    date: str
    target: str
    how: str
    seed: int
    minutes: float = 0.0
    executions: int = 0
    found: int = 0


def keep(record: Record, data: bytes, said: str) -> None:
    record.found += 1
    FOUND.mkdir(parents=True, exist_ok=True)
    path = FOUND / f"{record.target}-{record.seed}-{record.found}"
    path.write_bytes(data)
    print(f"{record.target}: {path}:\n{said[-1500:]}", flush=True)


def by_libfuzzer(record: Record, program: Path, minutes: float) -> None:
    """libFuzzer ends with the first finding; the rest of the time goes on with another seed."""
    queue = FOUND / "queue" / record.target
    queue.mkdir(parents=True, exist_ok=True)
    words = HERE / f"{record.target}.dict"
    end = time.monotonic() + 60 * minutes
    while (left := end - time.monotonic()) > 1 and record.found < MOST:
        crash = FOUND / f"{record.target}-crash"
        crash.unlink(missing_ok=True)
        done = subprocess.run(
            [program, *([f"-dict={words}"] if words.exists() else []), f"-seed={record.seed + record.found}",
             f"-max_len={LONGEST[record.target]}", f"-max_total_time={int(left)}", "-timeout=60",
             "-rss_limit_mb=2048", "-print_final_stats=1", f"-exact_artifact_path={crash}", queue,
             HERE / "corpus" / record.target],
            capture_output=True, text=True, errors="replace", env={**os.environ, **SANITIZERS}, check=False)
        told = re.findall(r"number_of_executed_units: (\d+)", done.stderr)
        record.executions += int(told[-1]) if told else 0
        if done.returncode != 0:
            keep(record, crash.read_bytes() if crash.exists() else b"", done.stderr)


def by_random_bytes(record: Record, program: Path, minutes: float) -> None:
    FOUND.mkdir(parents=True, exist_ok=True)
    current = FOUND / f"{record.target}-current"
    end = time.monotonic() + 60 * minutes
    while (left := end - time.monotonic()) > 1 and record.found < MOST:
        done = subprocess.run(
            [program, "--random", str(record.seed + record.found), str(left / 60), current],
            capture_output=True, text=True, errors="replace", env={**os.environ, **SANITIZERS}, check=False)
        record.executions += len(done.stdout.splitlines())
        if done.returncode != 0:
            keep(record, current.read_bytes(), done.stderr)


def by_processes(record: Record, program: Path, minutes: float) -> None:
    done = subprocess.run(
        [sys.executable, "-B", ROOT / "tests/faults/mutation_test.py", "--program", program,
         "--minutes", str(minutes), "--first", str(record.seed)],
        capture_output=True, text=True, check=False)
    told = re.search(r"(\d+) files from seed \d+, (\d+) runs, (\d+) with complaints", done.stdout)
    if not told:
        sys.exit(f"campaign.py: mutation_test.py ended with\n{done.stdout}{done.stderr}")
    record.executions, record.found = int(told[2]), int(told[3])
    print(done.stdout, end="", flush=True)


def run(target: str, minutes: float, seed: int) -> Record | None:
    """None where the target is not built."""
    record = Record(datetime.date.today().isoformat(), target, "", seed)
    begin = time.monotonic()
    fuzzer = ROOT / f"build/fuzz/tests/fuzz/{target}_fuzz"
    program = Path(os.environ.get("PROGRAM", ROOT / "build/release/app/kinestat"))
    replays = [(ROOT / f"build/{build}/tests/fuzz/{target}_replay", how) for build, how in
               (("sanitize", "random, with sanitizers"), ("release", "random"))]
    if target == "files":
        record.how = "processes"
        by_processes(record, program, minutes)
    elif fuzzer.exists():
        record.how = "libFuzzer, with sanitizers"
        by_libfuzzer(record, fuzzer, minutes)
    elif found := [one for one in replays if one[0].exists() and target == "mechanism"]:
        record.how = found[0][1]
        by_random_bytes(record, found[0][0], minutes)
    else:
        return None
    record.minutes = round((time.monotonic() - begin) / 60, 1)
    with LOG.open("a", encoding="utf-8") as log:
        log.write(json.dumps(asdict(record)) + "\n")
    print(f"{target}: {record.executions} executions in {record.minutes} minutes, {record.found} found",
          flush=True)
    return record


def table() -> str:
    rows = [Record(**json.loads(line)) for line in LOG.read_text(encoding="utf-8").splitlines()]
    lines = ["| date | target | how | seeds | minutes | executions | complaints |",
             "|---|---|---|---|---|---|---|"]
    for date, target, how in dict.fromkeys((row.date, row.target, row.how) for row in rows):
        its = [row for row in rows if (row.date, row.target, row.how) == (date, target, how)]
        seeds = ", ".join(str(seed) for seed in dict.fromkeys(row.seed for row in its))
        lines.append(f"| {date} | `{target}` | {how} | {seeds} | {sum(row.minutes for row in its):.0f} | "
                     f"{sum(row.executions for row in its):.2e} | {sum(row.found for row in its)} |")
    lines.append(f"| | all | | | {sum(row.minutes for row in rows):.0f} | "
                 f"{sum(row.executions for row in rows):.2e} | {sum(row.found for row in rows)} |")
    return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("minutes", type=float, nargs="?")
    parser.add_argument("--seed", type=int, default=int(time.time()))
    parser.add_argument("--only", default=".*")
    parser.add_argument("--write", action="store_true")
    known = parser.parse_args()
    if known.minutes is None and not known.write:
        parser.error("how many minutes?")
    found = 0
    if known.minutes is not None:
        chosen = [one for one in TARGETS if re.fullmatch(known.only, one)]
        for target in chosen:
            record = run(target, known.minutes / len(chosen), known.seed)
            if record is None:
                print(f"{target}: not built; tests/fuzz/README.md says how")
            found += record.found if record else 0
    if known.write:
        PART.write(table())
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
