#!/usr/bin/env python3
"""Mutated valid files, through every command and every oracle.

Usage: mutation_test.py --program PROGRAM [--minutes M] [--first SEED] [unittest arguments]

Without --minutes the same few seeds every time, and the files of corpus/, each of which has once shown
a defect; with it as many seeds as fit from --first on, each complaint with its seed and its file.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from itertools import count, islice
from pathlib import Path

import mutate
import oracles
import sweeps
from mutation import Judge, Verdict
from program import Program

FEW = 100
# With sanitizers a file takes minutes.
FEW_WITH_SANITIZERS = 2
program = Program(Path(sys.executable))


def corpus() -> dict[str, str]:
    return {path.name: path.read_text(encoding="utf-8")
            for path in sorted((Path(__file__).parent / "corpus").glob("*.yaml"))}


def judged(judge: Judge, seed: int) -> tuple[int, str, str, Verdict]:
    text, done = mutate.mutant(seed)
    return seed, done, text, judge.judge(text)


class Mutation(unittest.TestCase):
    def test_of_valid_files_breaks_no_promise(self) -> None:
        judge = Judge(program)
        few = FEW_WITH_SANITIZERS if program.has_sanitizers else FEW
        seeds = range(few)
        counts: dict[str, int] = {}
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for seed, done, _, verdict in pool.map(lambda one: judged(judge, one), seeds):
                self.assertEqual(verdict.wrong, [], f"seed {seed}, {done}")
                for name, number in verdict.judged.items():
                    counts[name] = counts.get(name, 0) + number
        print(f"{len(seeds)} files, {program.count} runs; judged: {counts}", flush=True)
        if not program.has_sanitizers:
            for name in ("CSV as JSON", "text as JSON", "auto as fast", "auto as exact",
                         "motion as analyze", "sweep as analyze"):
                self.assertIn(name, counts)

    def test_of_the_corpus_breaks_no_promise(self) -> None:
        judge = Judge(program)
        for name, text in corpus().items():
            with self.subTest(name):
                self.assertEqual(judge.judge(text).wrong, [])

    def test_of_one_seed_is_always_the_same(self) -> None:
        for seed in range(5):
            self.assertEqual(mutate.mutant(seed), mutate.mutant(seed))


class Oracles(unittest.TestCase):
    """That each complains of a number that is another."""

    @staticmethod
    def report(value: float, bound: float | None = 1e-12) -> dict:
        evidence = {"precision": "double", "refers_to": "numbers as typed", "error_bound": bound}
        side = {"status": "solved", "freedoms": {"a.wz": value}, "evidence": evidence}
        return {"cases": {"c": {"kinematics": side}}}

    def test_of_accuracies(self) -> None:
        for is_fast, near, far in ((True, 1 + 1e-8, 1 + 1e-4), (False, 1 + 1e-13, 1 + 1e-8)):
            same = oracles.accuracies(self.report(1.0), self.report(near), is_fast)
            other = oracles.accuracies(self.report(1.0), self.report(far), is_fast)
            self.assertEqual((len(list(same)), len(list(other))), (0, 1))

    def test_of_texts(self) -> None:
        for number, said in (("0.333333", 0), ("0.333343", 1)):
            text = f"Case c\n  a.wz   {number}  rad/s\n".encode()
            found = list(oracles.text_as_json(self.report(1 / 3), text))
            self.assertEqual(len(found), said)

    def test_of_tables(self) -> None:
        path = mutate.ROOT / "mechanisms" / "planar" / "four_bar.yaml"
        runs = [program.run(["analyze", "--format", form, str(path)]) for form in ("json", "csv")]
        report, table = oracles.strict(runs[0].out), runs[1].out
        self.assertEqual(list(oracles.csv_as_json(report, table)), [])
        lines = table.splitlines(keepends=True)
        self.assertNotEqual(list(oracles.csv_as_json(report, b"".join(lines[:-1]))), [])
        spoiled = table.replace(b"net_freedom,1,", b"net_freedom,2,", 1)
        self.assertNotEqual(spoiled, table)
        self.assertNotEqual(list(oracles.csv_as_json(report, spoiled)), [])

    def test_of_first_rows(self) -> None:
        path = mutate.ROOT / "mechanisms" / "planar" / "slider_crank.yaml"
        reports = [oracles.strict(program.run([command, "--format", "json", str(path)]).out)
                   for command in ("analyze", "motion")]
        self.assertEqual(list(oracles.first_row(*reports)), [])
        freedoms = reports[0]["cases"][reports[1]["motion"]["case"]]["kinematics"]["freedoms"]
        for name in freedoms:
            freedoms[name] *= 1.001
        self.assertNotEqual(list(oracles.first_row(*reports)), [])

    def test_of_sweeps(self) -> None:
        file = mutate.MechanismFile.read(mutate.ROOT / "mechanisms" / "planar" / "slider_crank.yaml")
        judge, text = Judge(program), sweeps.with_sweep(file.text())
        assert text
        rows, analyses = judge.swept(Verdict(), text)
        self.assertEqual(len(rows), len(sweeps.STATES) * len(analyses[0][0]["cases"]))
        self.assertEqual(list(sweeps.compare(rows, analyses)), [])
        for row in rows:
            self.assertNotEqual(list(sweeps.compare([{**row, "status": "singular"}], analyses)), [])
            name = next(one for one, value in row.items() if isinstance(value, float) and value and
                        not one.startswith(sweeps.PARAMETER))
            spoiled = {**row, name: 1.001 * row[name]}
            self.assertNotEqual(list(sweeps.compare([spoiled], analyses)), [])

    def test_of_json(self) -> None:
        for text in (b'{"a": NaN}', b'{"a": 1', b"Infinity"):
            with self.assertRaises(ValueError):
                oracles.strict(text)


def fuzz(minutes: float, first: int) -> int:
    """1 if anything was wrong."""
    judge, end, found, tried = Judge(program), time.monotonic() + 60 * minutes, 0, 0
    seeds = count(first)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        while time.monotonic() < end:
            for seed, done, text, verdict in pool.map(lambda one: judged(judge, one),
                                                      list(islice(seeds, 8))):
                tried += 1
                if verdict.wrong:
                    found += 1
                    print(f"seed {seed}, {done}:", *verdict.wrong[:5], text, sep="\n", flush=True)
    print(f"{tried} files from seed {first}, {program.count} runs, {found} with complaints")
    return 1 if found else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--first", type=int, default=int(time.time()))
    known, others = parser.parse_known_args()
    program = Program(known.program)
    if known.minutes is not None:
        sys.exit(fuzz(known.minutes, known.first))
    unittest.main(argv=[sys.argv[0], *others])
