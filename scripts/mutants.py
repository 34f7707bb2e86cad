#!/usr/bin/env python3
"""Mutation testing: changes one token of the library at a time and checks whether a test fails.

Usage: mutants.py [--seed S] [--first N] [--count N] [--minutes M] [--only MODULES]
                  [--labels LABELS] [--below SECONDS]
                  (default: 1, 0, 50, no end, all, golden|reference|cli, however long)
       mutants.py --report | --write

Mutants are numbered: the same seed, number and sources give the same mutant. Each is compiled alone and
linked with the other objects of its module into the unit tests of the module and into the program; tests
run, the fastest first, those --below so many seconds alone, until one fails. Results are lines of
build/mutants/log.jsonl; mutants listed there are not run again, except survivors of other labels.
--report prints the score of each module and the survivors, --write puts the score into RELIABILITY.md.
Needs build/release, with its tests built.
"""

from __future__ import annotations

import argparse
import datetime
import json
import os
import random
import re
import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Iterator

import check_layers
from written_part import WrittenPart

ROOT = Path(__file__).resolve().parents[1]
RELEASE = ROOT / "build/release"
WORK = ROOT / "build/mutants"
LOG = WORK / "log.jsonl"
PART = WrittenPart(ROOT / "RELIABILITY.md",
                   "<!-- written by scripts/mutants.py --write: -->", "<!-- end of mutants -->")
MODULES = ("math", "network", "statics", "power", "studies/shift", "studies/motion")
LABELS = "golden|reference|cli"  # of ctest: the tests of the program, after the unit tests
TOO_LONG = "takes too long"
LONGEST = 60.0  # seconds of a test: a loop without an end is noticed
OPTIMISATION = "-O1"

# Kind, what is changed, into what. A space on both sides tells operators from templates.
CHANGES: tuple[tuple[str, str, tuple[str, ...]], ...] = (
    ("relation", r"(?<= )<=(?= )", ("<", ">")),
    ("relation", r"(?<= )>=(?= )", (">", "<")),
    ("relation", r"(?<= )<(?= )", ("<=", ">=")),
    ("relation", r"(?<= )>(?= )", (">=", "<=")),
    ("relation", r"(?<= )==(?= )", ("!=",)),
    ("relation", r"(?<= )!=(?= )", ("==",)),
    ("logic", r"(?<= )&&(?= )", ("||",)),
    ("logic", r"(?<= )\|\|(?= )", ("&&",)),
    ("logic", r"(?<=[ (])!(?=[a-z(])", ("",)),
    ("logic", r"\btrue\b", ("false",)),
    ("logic", r"\bfalse\b", ("true",)),
    ("arithmetic", r"(?<= )\+(?= )", ("-",)),
    ("arithmetic", r"(?<= )-(?= )", ("+",)),
    ("arithmetic", r"(?<= )\*(?= )", ("/",)),
    ("arithmetic", r"(?<= )/(?= )", ("*",)),
    ("arithmetic", r"(?<= )\+=(?= )", ("-=",)),
    ("arithmetic", r"(?<= )-=(?= )", ("+=",)),
    ("arithmetic", r"(?<= )\*=(?= )", ("/=",)),
    ("sign", r"(?<=[(,=?:] )-(?=[a-z(\d])|(?<=return )-(?=[a-z(\d])|(?<=\()-(?=[a-z(\d])", ("",)),
    ("constant", r"(?<![\w.'])0(?![\w.'])", ("1",)),
    ("constant", r"(?<![\w.'])1(?![\w.'])", ("0", "2")),
    ("constant", r"(?<![\w.'])(?:[2-9]|[1-9]\d+)(?![\w.'])", ("1",)),
    ("constant", r"(?<![\w.'])0\.0?(?![\w.'])", ("1.0",)),
    ("constant", r"(?<![\w.'])(?:0\.5|2\.0|1\.0)(?![\w.'])", ("0.75",)),
    # A call or an assignment of one line.
    ("statement", r"(?m)^ +(?:[a-z][\w.\->\[\]]*\(.*\)|[a-z][\w.\->\[\]()]* [-+*/]?= .*);$", (";",)),
)
NEVER = re.compile(r"^\s*(?:#|static_assert|template|using|namespace|return|throw|assert)")


@dataclass(frozen=True)
class Mutant:
    seed: int
    number: int
    module: str
    file: str
    start: int
    end: int
    kind: str
    after: str

    @cached_property
    def text(self) -> str:
        return (ROOT / self.file).read_text(encoding="utf-8")

    @property
    def before(self) -> str:
        return self.text[self.start:self.end]

    @property
    def line(self) -> int:
        return check_layers.line_of(self.text, self.start)

    @property
    def source(self) -> str:
        return self.text[:self.start] + self.after + self.text[self.end:]

    def told(self) -> dict:
        return {"seed": self.seed, "number": self.number, "module": self.module, "file": self.file,
                "line": self.line, "kind": self.kind, "before": self.before.strip(), "after": self.after}


def sources(module: str) -> list[str]:
    modules = check_layers.read_modules(ROOT)
    return [path.relative_to(ROOT).as_posix() for path in sorted((ROOT / "lib" / module).rglob("*.cpp"))
            if check_layers.module_of(path.relative_to(ROOT / "lib").as_posix(), modules) == module]


def sites(module: str) -> Iterator[tuple[str, int, int, str, str]]:
    """All that can be changed in a module, in an order that only its sources decide."""
    for file in sources(module):
        text = check_layers.without_strings((ROOT / file).read_text(encoding="utf-8"))
        for kind, pattern, afters in CHANGES:
            for found in re.finditer(pattern, text):
                line_begin = text.rfind("\n", 0, found.start() + 1) + 1
                line = text[line_begin:text.find("\n", found.end())]
                if kind == "statement":
                    if NEVER.match(line) or line.count("(") != line.count(")"):
                        continue
                elif re.match(r"\s*(?:#|static_assert|template|using)", line):
                    continue
                for after in afters:
                    yield file, found.start(), found.end(), kind, after


def mutants(seed: int) -> Iterator[Mutant]:
    """Endless but for the sites: one of each module in turn."""
    draws = {module: random.Random(f"{seed} {module}") for module in MODULES}
    orders = {}
    for module in MODULES:
        orders[module] = list(sites(module))
        draws[module].shuffle(orders[module])
    number = 0
    while any(orders.values()):
        for module in MODULES:
            if orders[module]:
                yield Mutant(seed, number, module, *orders[module].pop())
                number += 1


def run(words: list[str], seconds: float | None = None, **more: object) -> tuple[bool, str]:
    """Whether it ended well, and the end of what it said."""
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", start_new_session=True, **more) as process:
        try:
            said, _ = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.communicate()
            return False, TOO_LONG
    return process.returncode == 0, said[-2000:]


def commands(target: str) -> list[str]:
    done = subprocess.run(["ninja", "-C", str(RELEASE), "-t", "commands", "-s", target],
                          capture_output=True, text=True, check=True)
    found = re.search(r"&& (.*) && :$", done.stdout.splitlines()[-1])
    return shlex.split(found[1] if found else done.stdout.splitlines()[-1])


def target_of(module: str) -> str:
    return "kinestat_" + re.sub(r"\W", "_", module)


class Module:
    """The objects of a module, each source compiled alone."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.folder = WORK / "objects" / target_of(name)
        self.archive = f"lib/lib{target_of(name)}.a"
        any_object = f"lib/CMakeFiles/{target_of(name)}.dir/Unity/unity_0_cxx.cxx.o"
        words = commands(any_object)
        keep, skip = [], False
        for word in words:
            if skip:
                skip = False
            elif word in ("-MT", "-MF", "-o", "-c"):
                skip = True
            elif word not in ("-MD", "-Winvalid-pch", "-Werror"):
                keep.append(OPTIMISATION if re.fullmatch(r"-O\w", word) else word)
        self.compiler = keep

    def object_of(self, file: str) -> Path:
        return self.folder / (file.replace("/", "_") + ".o")

    def compile(self, source: Path, out: Path, file: str) -> tuple[bool, str]:
        """A changed source is elsewhere, and finds the headers beside it all the same."""
        beside = [f"-I{(ROOT / file).parent}"]
        return run([*self.compiler, *beside, "-w", "-o", str(out), "-c", str(source)], 300, cwd=RELEASE)

    def build(self) -> None:
        """What is not there yet, or older than its source."""
        self.folder.mkdir(parents=True, exist_ok=True)
        missing = [file for file in sources(self.name) if not self.object_of(file).exists()
                   or self.object_of(file).stat().st_mtime < (ROOT / file).stat().st_mtime]
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for file, (good, said) in zip(missing, pool.map(
                    lambda one: self.compile(ROOT / one, self.object_of(one), one), missing)):
                if not good:
                    sys.exit(f"mutants.py: {file} does not compile alone:\n{said}")

    def objects(self, file: str, changed: Path) -> list[str]:
        embedded = sorted(str(path) for path in
                          (RELEASE / f"lib/CMakeFiles/{target_of(self.name)}.dir").glob("embedded_*.o"))
        return [str(changed if one == file else self.object_of(one))
                for one in sources(self.name)] + embedded


@dataclass
class Test:
    name: str
    target: str  # of the program that is linked for it
    words: list[str]
    cwd: str


def unit_tests(module: str) -> list[Test]:
    name = module.rpartition("/")[2]
    target = f"tests/unit/{name}/unit_{name}"
    return [Test(f"unit_{name}", target, [str(RELEASE / target), "--gtest_brief=1"],
                 str((RELEASE / target).parent))]


def program_tests(labels: str) -> list[Test]:
    done = subprocess.run(["ctest", "--show-only=json-v1", "-L", f"^({labels})$"], cwd=RELEASE,
                          capture_output=True, text=True, check=True)
    found = []
    for test in json.loads(done.stdout)["tests"]:
        where = next((one["value"] for one in test["properties"]
                      if one["name"] == "WORKING_DIRECTORY"), str(RELEASE))
        found.append(Test(test["name"], "app/kinestat", test["command"], where))
    return found


class Suite:
    """The tests of the program, the fastest first as far as ctest has run them."""

    def __init__(self, labels: str, below: float) -> None:
        costs = {}
        file = RELEASE / "Testing/Temporary/CTestCostData.txt"
        if file.exists():
            for line in file.read_text(encoding="utf-8").splitlines():
                if found := re.fullmatch(r"(\S+) \d+ (\S+)", line):
                    costs[found[1]] = float(found[2])
        cost = lambda test: costs.get(test.name, 1.0)  # noqa: E731
        self.programs = sorted((test for test in program_tests(labels) if cost(test) < below), key=cost)
        self.broken: set[str] = set()

    def notices(self, test: Test, program: Path) -> str:
        """How a test fails that does not fail without the change; empty if it does not."""
        words = [word.replace(str(RELEASE / test.target), str(program)) for word in test.words]
        good, said = run(words, LONGEST, cwd=test.cwd)
        if good or test.name in self.broken:
            return ""
        if not run(test.words, LONGEST, cwd=test.cwd)[0]:
            self.broken.add(test.name)
            return ""
        return test.name + (f": {said}" if said == TOO_LONG else "")

    def judged(self, mutant: Mutant, module: Module) -> tuple[str, str]:
        """killed, survived or `does not compile`, and by which test."""
        folder = WORK / f"mutant_{os.getpid()}"
        folder.mkdir(parents=True, exist_ok=True)
        changed = folder / Path(mutant.file).name
        changed.write_text(mutant.source, encoding="utf-8")
        good, _ = module.compile(changed, folder / "changed.o", mutant.file)
        if not good:
            return "does not compile", ""
        archive = folder / "module.a"
        archive.unlink(missing_ok=True)
        run(["ar", "qcsT", str(archive), *module.objects(mutant.file, folder / "changed.o")])
        linked: dict[str, Path] = {}
        for test in [*unit_tests(mutant.module), *self.programs]:
            if test.target not in linked:
                linked[test.target] = self.link(test.target, module, archive, folder)
            if by := self.notices(test, linked[test.target]):
                return "killed", by
        return "survived", ""

    @staticmethod
    def link(target: str, module: Module, archive: Path, folder: Path) -> Path:
        program = folder / Path(target).name
        words = [str(archive) if word == module.archive else word for word in commands(target)]
        words[words.index("-o") + 1] = str(program)
        good, said = run(words, 300, cwd=RELEASE)
        if not good:
            sys.exit(f"mutants.py: {target} cannot be linked:\n{said}")
        return program


def key(row: dict) -> tuple:
    return row["seed"], row["number"], row["file"], row["before"], row["after"]


def logged() -> list[dict]:
    """Of each mutant what was written last."""
    if not LOG.exists():
        return []
    rows = [json.loads(line) for line in LOG.read_text(encoding="utf-8").splitlines()]
    return list({key(row): row for row in rows}.values())


def sample(known: argparse.Namespace) -> None:
    for need in (RELEASE / "build.ninja", RELEASE / "app/kinestat"):
        if not need.exists():
            sys.exit("mutants.py: build/release is not there; first: scripts/test.sh")
    WORK.mkdir(parents=True, exist_ok=True)
    suite = Suite(known.labels, known.below)
    tests = known.labels + (f" below {known.below:g} s" if known.below < LONGEST else "")
    modules: dict[str, Module] = {}
    begin = time.monotonic()
    # What survived other tests has to survive these too.
    done = {key(row) for row in logged()
            if row["outcome"] != "survived" or row["labels"] == tests}
    for mutant in mutants(known.seed):
        if mutant.number < known.first or not re.fullmatch(known.only, mutant.module):
            continue
        if mutant.number >= known.first + known.count or (
                known.minutes and time.monotonic() - begin > 60 * known.minutes):
            break
        told = mutant.told()
        if key(told) in done:
            continue
        if mutant.module not in modules:
            modules[mutant.module] = Module(mutant.module)
            modules[mutant.module].build()
        started = time.monotonic()
        outcome, test = suite.judged(mutant, modules[mutant.module])
        told |= {"outcome": outcome, "by": test, "seconds": round(time.monotonic() - started, 1),
                 "date": datetime.date.today().isoformat(), "labels": tests}
        with LOG.open("a", encoding="utf-8") as log:
            log.write(json.dumps(told, ensure_ascii=False) + "\n")
        print(f"{mutant.number}: {mutant.file}:{told['line']}: {told['before']} -> "
              f"{mutant.after or 'nothing'}: {outcome} {test}", flush=True)


def table(rows: list[dict]) -> str:
    lines = ["| module | mutants | killed | of them by the unit tests of the module | survived |",
             "|---|---|---|---|---|"]
    whole = [row for row in rows if row["outcome"] != "does not compile"]
    for module in (*MODULES, None):
        its = [row for row in whole if module in (row["module"], None)]
        killed = [row for row in its if row["outcome"] == "killed"]
        units = [row for row in killed if row["by"].startswith("unit_")]
        share = f" ({100 * len(killed) / len(its):.0f} %)" if its else ""
        lines.append(f"| {f'`{module}`' if module else 'all'} | {len(its)} | {len(killed)}{share} | "
                     f"{len(units)} | {len(its) - len(killed)} |")
    runs = sorted({(row["date"], row["seed"]) for row in rows})
    parts = []
    for date, seed in runs:
        numbers = sorted(row["number"] for row in rows if (row["date"], row["seed"]) == (date, seed))
        parts.append(f"{date}, seed {seed}, {len(numbers)} numbers of {numbers[0]} to {numbers[-1]}")
    tests: dict[str, int] = {}
    for row in whole:
        tests[row["labels"]] = tests.get(row["labels"], 0) + 1
    judged = "; ".join(f"{count} by {labels.replace('|', ', ')}" for labels, count in tests.items())
    unbuilt = len(rows) - len(whole)
    return "\n".join([f"Run on {'; '.join(parts)}; {unbuilt} did not compile. After the unit tests of "
                      f"their module they were judged: {judged}.", "", *lines])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=50)
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--only", default=".*")
    parser.add_argument("--labels", default=LABELS)
    parser.add_argument("--below", type=float, default=LONGEST)
    parser.add_argument("--report", action="store_true")
    parser.add_argument("--write", action="store_true")
    known = parser.parse_args()
    if not known.report and not known.write:
        sample(known)
    rows = logged()
    if not rows:
        return 0
    text = table(rows)
    print(text)
    for row in rows:
        if row["outcome"] == "survived":
            print(f"survived: {row['number']}: {row['file']}:{row['line']}: {row['before']} -> "
                  f"{row['after'] or 'nothing'}")
    if known.write:
        PART.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
