#!/usr/bin/env python3
"""Runs one command-line case: a folder with `cmd` and what is expected of it.

The command runs under bash in a fresh copy of the folder, in an environment of KINESTAT (the
program), ROOT (the repository), MECHANISMS, PATH and LC_ALL=C. Expectations, each optional:

  status        exit status (0 when absent)
  out, err      the text of stdout, stderr, exactly
  out.json      stdout as JSON, one or more documents: numbers compared with tolerance, keys in
                order, the values of keys named `version` or `evidence` ignored
  out_contains, err_contains    lines that must occur somewhere in the text
  files, no_files               patterns (**, *) that must, must not, match a file afterwards
  as_nobody     an empty file: run without root's rights
  not_with_sanitizers    an empty file: CMake leaves the case out of builds with sanitizers

In all text the folder reads `<tmp>` and the repository `<root>`. With --update (or UPDATE=1) the
files status, out, out.json and err are rewritten; a case without any gets those that fit.
"""

from __future__ import annotations

import argparse
import difflib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterator

RTOL = 1e-9
ATOL = 1e-12
TIMEOUT_S = 240
NOBODY = 65534
ROOT = Path(__file__).resolve().parents[2]
EXACT = {"status", "out", "out.json", "err"}
ASSERTING = EXACT | {"out_contains", "err_contains"}
EXPECTATIONS = ASSERTING | {"cmd", "files", "no_files", "as_nobody", "not_with_sanitizers"}
PASSED_ON = ("PATH", "ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS")


class CaseError(Exception):
    """The case itself is wrong, or its output is not even text."""


@dataclass
class Outcome:
    """What the command did, with the folders' names taken out of the text."""

    status: int
    out: str
    err: str
    files: list[str]


class Pairs(list):  # type: ignore[type-arg]
    """A JSON object as its pairs in order, so that it is never mistaken for an array."""

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{key!r}: {value!r}" for key, value in self) + "}"


# Running


def environment(program: Path) -> dict[str, str]:
    kept = {name: os.environ[name] for name in PASSED_ON if name in os.environ}
    named = {"KINESTAT": program, "ROOT": ROOT, "MECHANISMS": ROOT / "mechanisms"}
    return {"PATH": os.defpath, "LC_ALL": "C"} | kept | {k: str(v) for k, v in named.items()}


def copy_inputs(case: Path, folder: Path) -> None:
    shutil.copytree(
        case, folder, ignore=lambda at, names: EXPECTATIONS & set(names) if Path(at) == case else ()
    )


def give_to_nobody(parent: Path, program: Path) -> Path:
    """Hands the tree over, with a copy of the program: the build may lie where only root looks."""
    copied = parent / program.name
    shutil.copy(program, copied)
    for path in (parent, *parent.rglob("*")):
        os.chown(path, NOBODY, NOBODY, follow_symlinks=False)
    return copied


def execute(command: list[str], folder: Path, env: dict[str, str]) -> tuple[int, bytes, bytes]:
    process = subprocess.Popen(
        command, cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, start_new_session=True,
    )
    try:
        out, err = process.communicate(timeout=TIMEOUT_S)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        raise CaseError(f"still running after {TIMEOUT_S} s") from None
    return process.returncode, out, err


def readable(stream: str, raw: bytes, folder: Path) -> str:
    if b"\x1b" in raw:
        raise CaseError(f"{stream} holds an ESC byte: {raw!r}")
    try:
        text = raw.decode("utf-8")
    except UnicodeDecodeError as error:
        raise CaseError(f"{stream} is not UTF-8: {error}") from None
    return text.replace(str(folder), "<tmp>").replace(str(ROOT), "<root>")


def run(case: Path, program: Path) -> Outcome:
    shell = ["bash", "-c", (case / "cmd").read_text(encoding="utf-8")]
    with tempfile.TemporaryDirectory(prefix="kinestat-case-") as parent_name:
        parent = Path(parent_name).resolve()
        folder = parent / case.name
        copy_inputs(case, folder)
        if (case / "as_nobody").exists() and os.geteuid() == 0:
            program = give_to_nobody(parent, program)
            shell = ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups", *shell]
        status, out, err = execute(shell, folder, environment(program))
        files = sorted(str(f.relative_to(folder)) for f in folder.rglob("*") if not f.is_dir())
        texts = [readable(*item, folder) for item in (("stdout", out), ("stderr", err))]
    return Outcome(status, texts[0], texts[1], files)


# Comparing


def refuse_constant(token: str) -> Any:
    raise ValueError(f"{token} is not JSON")


def documents(text: str) -> list[Any]:
    """The JSON documents of a text, one after the other."""
    decoder = json.JSONDecoder(object_pairs_hook=Pairs, parse_constant=refuse_constant)
    found, at = [], 0
    while text[at:].strip():
        at += len(text[at:]) - len(text[at:].lstrip())
        value, at = decoder.raw_decode(text, at)
        found.append(value)
    return found


def is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def differences(expected: Any, actual: Any, at: str = "") -> Iterator[str]:
    """Where two JSON values differ, each place as a JSON Pointer."""
    if is_number(expected) and is_number(actual):
        if not abs(actual - expected) <= ATOL + RTOL * abs(expected):
            yield f"{at}: expected {expected!r}, got {actual!r}"
    elif isinstance(expected, Pairs) and isinstance(actual, Pairs):
        yield from object_differences(expected, actual, at)
    elif type(expected) is list and type(actual) is list:
        if len(expected) != len(actual):
            yield f"{at}: expected {len(expected)} entries, got {len(actual)}"
        for i, (wanted, got) in enumerate(zip(expected, actual)):
            yield from differences(wanted, got, f"{at}/{i}")
    elif type(expected) is not type(actual) or expected != actual:
        yield f"{at}: expected {expected!r}, got {actual!r}"


def object_differences(expected: Pairs, actual: Pairs, at: str) -> Iterator[str]:
    wanted, got = [key for key, _ in expected], [key for key, _ in actual]
    if wanted != got:
        yield f"{at}: expected the keys {wanted}, got {got}"
        return
    for (key, value), (_, other) in zip(expected, actual):
        if key not in ("version", "evidence"):
            name = key.replace("~", "~0").replace("/", "~1")
            yield from differences(value, other, f"{at}/{name}")


def json_faults(expected: str, actual: str) -> list[str]:
    try:
        wanted, got = documents(expected), documents(actual)
    except ValueError as error:
        return [f"stdout or out.json is not JSON: {error}"]
    if len(wanted) == len(got) == 1:
        wanted, got = wanted[0], got[0]
    return [f"stdout {line}" for line in differences(wanted, got)]


def text_faults(stream: str, expected: str, actual: str) -> list[str]:
    if expected == actual:
        return []
    lines = difflib.unified_diff(
        expected.splitlines(), actual.splitlines(), "expected", "actual", lineterm="", n=2
    )
    shown = list(lines) or ["(only the line ends differ)"]
    return ["\n".join([f"{stream} differs:", *shown])]


def missing_lines(stream: str, wanted: str, text: str) -> list[str]:
    return [f"{stream} lacks: {line}" for line in wanted.splitlines() if line and line not in text]


def file_faults(patterns: str, files: list[str], wanted: bool) -> list[str]:
    faults = []
    for pattern in filter(None, patterns.splitlines()):
        hits = [name for name in files if matches(name, pattern)]
        if wanted and not hits:
            faults.append(f"no file matches {pattern}; there are: {', '.join(files) or 'none'}")
        if not wanted and hits:
            faults.append(f"these should not exist ({pattern}): {', '.join(hits)}")
    return faults


def matches(name: str, pattern: str) -> bool:
    """Whether a relative path matches; `*` stays in one folder, `**/` is any depth."""
    parts = {r"\*\*/": "(?:.*/)?", r"\*\*": ".*", r"\*": "[^/]*", r"\?": "[^/]"}
    translate = re.compile("|".join(re.escape(part) for part in parts))
    return bool(re.fullmatch(translate.sub(lambda m: parts[m[0]], re.escape(pattern)), name))


def status_faults(expected: str, actual: str) -> list[str]:
    same = int(expected) == int(actual)
    return [] if same else [f"expected exit status {expected.strip()}, got {actual}"]


def faults_of(case: Path, outcome: Outcome) -> list[str]:
    given = expectations(case)
    checks = {
        "out": lambda text: text_faults("stdout", text, outcome.out),
        "out.json": lambda text: json_faults(text, outcome.out),
        "out_contains": lambda text: missing_lines("stdout", text, outcome.out),
        "err": lambda text: text_faults("stderr", text, outcome.err),
        "err_contains": lambda text: missing_lines("stderr", text, outcome.err),
        "files": lambda text: file_faults(text, outcome.files, wanted=True),
        "no_files": lambda text: file_faults(text, outcome.files, wanted=False),
    }
    faults = status_faults(given.get("status", "0"), str(outcome.status))
    for name, check in checks.items():
        faults += check(given[name]) if name in given else []
    return faults


def expectations(case: Path) -> dict[str, str]:
    names = (EXPECTATIONS - {"cmd"}) & {path.name for path in case.iterdir() if path.is_file()}
    return {name: (case / name).read_text(encoding="utf-8") for name in names}


# Updating


def is_json(text: str) -> bool:
    try:
        values = documents(text)
    except ValueError:
        return False
    return bool(values) and all(isinstance(value, (Pairs, list)) for value in values)


def fitting(outcome: Outcome) -> set[str]:
    names = {"err"} if outcome.err else set()
    if outcome.out:
        names.add("out.json" if is_json(outcome.out) else "out")
    if outcome.status != 0 or not names:
        names.add("status")
    return names


def update(case: Path, outcome: Outcome) -> None:
    """Rewrites what is compared exactly, and only where it no longer holds."""
    given = expectations(case)
    names = EXACT & set(given) or (set() if ASSERTING & set(given) else fitting(outcome))
    if outcome.status != 0:
        names.add("status")
    texts = {
        "status": f"{outcome.status}\n",
        "out": outcome.out,
        "out.json": outcome.out,
        "err": outcome.err,
    }
    for name in sorted(names):
        old = given.get(name)
        if name == "out.json" and old is not None and not json_faults(old, outcome.out):
            continue
        if texts[name] != old:
            (case / name).write_text(texts[name], encoding="utf-8")
            print(f"{case / name}: rewritten")


# The command


def check_case(case: Path, program: Path, rewrite: bool) -> list[str]:
    if not (case / "cmd").is_file():
        return ["there is no file cmd"]
    if not rewrite and not ASSERTING & set(expectations(case)):
        return ["nothing is expected: add status, out, out.json, err, or a *_contains"]
    try:
        outcome = run(case, program)
    except (CaseError, OSError) as error:
        return [str(error)]
    if rewrite:
        update(case, outcome)
    faults = faults_of(case, outcome)
    if faults:
        faults += [f"stdout was:\n{outcome.out}", f"stderr was:\n{outcome.err}"]
    return faults


def main() -> int:
    parser = argparse.ArgumentParser(description="Run one command-line case.")
    parser.add_argument("case", type=Path)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--update", action="store_true", default=os.environ.get("UPDATE") == "1")
    arguments = parser.parse_args()
    faults = check_case(arguments.case.resolve(), arguments.program.resolve(), arguments.update)
    for fault in faults:
        print(f"{arguments.case}: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
