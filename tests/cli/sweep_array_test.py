#!/usr/bin/env python3
"""Sweeps as NumPy arrays: every value equals that of the text, also when a run is sharded or
interrupted, and the recipes of the cookbook run as printed if their packages are installed."""

from __future__ import annotations

import ast
import contextlib
import importlib.util
import io
import json
import math
import os
import re
import signal
import struct
import subprocess
import time
import unittest
from pathlib import Path
from typing import Any

from sweep_case import ROOT, SWEEP, TRAIN, InFolder, kinestat, main, program

# A four-bar whose crank and coupler are in line at y = 1, and that does not exist below y = 0.
FOUR_BAR = """
kinestat: 1
space: planar
parameters: {y: 2, F: 5 N*m}
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [2, sqrt(y)*sqrt(y)]}
  c: {type: revolute, bodies: [coupler, rocker], at: [6, 3]}
  d: {type: revolute, bodies: [frame, rocker], at: [8, 0]}
actuators: {crank: {coupling: a}, rocker: {coupling: d}}
cases:
  'push, "hard" ü': {motion: {crank: 1 rad/s}, action: {crank: F}, input: crank, output: rocker}
  pull: {motion: {rocker: 1 rad/s}, action: {rocker: 5 N*m}, input: rocker, output: crank}
sweep: {vary: {y: {from: -0.5, to: 2, step: 0.25}, F: [0 N*m, 5 N*m]}, report: [ratio, crank, c.wz]}
"""

# What a number in a field of the header is in the module struct.
CODES = {"<i8": "q", "<f8": "d"}

Row = dict[str, Any]


class Array:
    """A file of NumPy, read by its specification alone."""

    def __init__(self, path: Path):
        data = path.read_bytes()
        assert data[:6] == b"\x93NUMPY" and data[7] == 0, data[:10]
        self.version = data[6]
        wide = self.version > 1
        size = struct.unpack_from("<I" if wide else "<H", data, 8)[0]
        self.begin = (12 if wide else 10) + size
        header = data[self.begin - size:self.begin].decode("utf-8" if self.version == 3 else "ascii")
        fields = ast.literal_eval(header)
        assert set(fields) == {"descr", "fortran_order", "shape"} and not fields["fortran_order"]
        self.types = dict(fields["descr"])
        (self.count,) = fields["shape"]
        form = "<" + "".join(CODES[one] for one in self.types.values())
        assert self.begin + self.count * struct.calcsize(form) == len(data)
        self.rows = list(struct.iter_unpack(form, data[self.begin:]))

    def in_words(self, words: dict[str, list[str]]) -> list[Row]:
        """As JSON has them."""
        return [{title: self._value(title, value, words) for title, value in zip(self.types, row)}
                for row in self.rows]

    @staticmethod
    def _value(title: str, value: Any, words: dict[str, list[str]]) -> Any:
        if title in words:
            return words[title][value]
        return None if isinstance(value, float) and math.isnan(value) else value


class ArrayCase(InFolder):
    def sweep(self, text: str, *options: object) -> tuple[Array, list[Row], dict[str, Any]]:
        """The array, in the words that stand beside it, and what that file says."""
        file = self.write(text)
        out = self.folder / "out"
        out.mkdir(exist_ok=True)
        done = kinestat("sweep", "--format", "npy", "--out", out, *options, file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual({path.name for path in out.iterdir()}, {"train.sweep.npy", "train.sweep.json"})
        array = Array(out / "train.sweep.npy")
        summary = json.loads((out / "train.sweep.json").read_text())
        return array, array.in_words(summary["words"]), summary

    def text_rows(self, text: str, *options: object) -> list[Row]:
        done = kinestat("sweep", "--format", "json", *options, self.write(text))
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def assert_same(self, text: str, *options: object) -> tuple[Array, dict[str, Any]]:
        array, rows, summary = self.sweep(text, *options)
        expected = self.text_rows(text, *options)
        self.assertEqual(list(array.types), list(expected[0]))
        self.assertEqual(list(array.types), summary["columns"])
        self.assertEqual(rows, expected)
        self.assertEqual(array.begin % 64, 0)
        return array, summary


class Values(ArrayCase):
    """Against the rows in JSON, value by value."""

    def test_numbers_are_those_of_the_text_to_the_last_bit(self) -> None:
        array, _ = self.assert_same(TRAIN + SWEEP)
        self.assertEqual(array.count, 24 * 4 * 5 // 3 * 2)
        self.assertEqual(list(array.types.items()),
                         [("Ns", "<i8"), ("Np", "<i8"), ("torque [N*m]", "<f8"), ("case", "<i8"),
                          ("ratio", "<f8"), ("torque_ratio", "<f8"), ("brake [N*m]", "<f8"),
                          ("e.Rc [N]", "<f8"), ("d.wz [rad/s]", "<f8"), ("status", "<i8")])

    def test_rows_without_values_have_nan_and_their_status(self) -> None:
        array, summary = self.assert_same(FOUR_BAR)
        self.assertEqual(array.types["y"], "<f8")
        self.assertEqual(summary["words"]["case"], ['push, "hard" ü', "pull"])
        self.assertEqual(summary["words"]["status"][0], "solved")
        self.assertTrue({"solved", "singular", "E0316"} <= set(summary["statuses"]), summary)
        without = [row for row in array.rows if math.isnan(row[3])]
        self.assertTrue(0 < len(without) < array.count)

    def test_no_other_rows_take_its_words_away(self) -> None:
        self.sweep(TRAIN + SWEEP)
        out, file = self.folder / "out", self.write(TRAIN + SWEEP)
        before = {path.name: path.read_bytes() for path in out.iterdir()}
        shard = self.new_folder("shards")
        self.assertEqual(kinestat("sweep", "--shard", "1/1", "--out", shard, file).returncode, 0)
        for command in (["sweep", "--format", "csv", file], ["sweep", "--format", "json", file],
                        ["merge", *shard.iterdir()]):
            done = kinestat(command[0], "--out", out, *command[1:])
            self.assertEqual(done.returncode, 4, done.stderr)
            self.assertIn("error[E0153]", done.stderr)
            self.assertIn("has the words for the numbers of", done.stderr)
            self.assertEqual({path.name: path.read_bytes() for path in out.iterdir()}, before)
        for _ in range(2):
            done = kinestat("sweep", "--format", "csv", "--force", "--out", out, file)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(kinestat("sweep", "--format", "csv", "--out", out, file).returncode, 0)

    def test_motions_of_linkages_that_cannot_turn_right_round(self) -> None:
        _, summary = self.assert_same(FOUR_BAR.split("sweep:")[0] + """
motion: {drive: crank, to: 1 rad, steps: 24, case: pull}
sweep: {vary: {y: {from: -0.5, to: 8, step: 0.25}, F: [5 N*m]},
        report: [d.wz.position.range, transmission_angle.least, mechanical_advantage.least]}
""")
        self.assertTrue({"solved", "limited", "E0316"} <= set(summary["statuses"]), summary)

    def test_what_is_drawn_between_whole_numbers_is_not_whole(self) -> None:
        array, _ = self.assert_same(TRAIN.replace("module: 2", "module: 2, x: 1, k: 3") + """
sweep:
  vary: {Ns: {from: 17, to: 40, step: 1}, x: {from: 0, to: 8}, k: {from: 1, to: 3}}
  sample: {count: 50}
  report: [ratio]
""")
        self.assertEqual([array.types[name] for name in ("Ns", "x", "k")], ["<i8", "<f8", "<f8"])
        self.assertTrue(any(row[1] % 1 for row in array.rows))

    def test_kept_rows_and_the_best_of_them(self) -> None:
        kept = TRAIN + SWEEP + "  keep: [ratio > 4.2]\n"
        array, _ = self.assert_same(kept)
        self.assertTrue(0 < array.count < 320)
        top = ("--top", 7, "--by", "abs(ratio - 4.4)", "--order", "smallest")
        self.assertEqual(self.assert_same(kept, *top)[0].count, 7)
        none, _, _ = self.sweep(TRAIN + SWEEP + "  keep: [ratio > 1000]\n")
        self.assertEqual((none.count, none.rows), (0, []))
        self.assertEqual(none.begin, array.begin)

    def test_every_status_of_the_help_has_its_number(self) -> None:
        _, _, summary = self.sweep(FOUR_BAR)
        words = summary["words"]["status"]
        self.assertEqual(len(words), len(set(words)))
        topic = kinestat("help", "sweeps").stdout
        block = re.split(r"others are not\s+affected:\n", topic)[1].split("\n\n")[0]
        told = set(re.findall(r"[a-z_-]+", " ".join(re.findall(
            r"^  ((?:[a-z_-]+,? ?)+|E\d+.*?)(?:  |$)", block, re.M))))
        self.assertIn("tie-up", told)
        self.assertEqual(told - set(words), set())
        self.assertEqual({word for word in words if not re.fullmatch(r"[EW]\d+", word)} - told, {"solved"})


class Sharing(ArrayCase):
    """The bytes are those of one run alone."""

    def setUp(self) -> None:
        super().setUp()
        self.file = self.write(TRAIN + SWEEP)

    def files_of(self, name: str, *options: object) -> dict[str, bytes]:
        out = self.new_folder(name)
        done = kinestat("sweep", "--format", "npy", *options, "--out", out, self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return {path.name: path.read_bytes() for path in out.iterdir()}

    def merged(self, name: str, count: int, *options: object) -> dict[str, bytes]:
        shards = self.new_folder(f"{name}-shards")
        for k in range(1, count + 1):
            done = kinestat("sweep", "--format", "npy", *options, "--shard", f"{k}/{count}", "--out",
                            shards, self.file)
            self.assertEqual(done.returncode, 0, done.stderr)
        out = self.new_folder(f"{name}-merged")
        done = kinestat("merge", "--out", out, *shards.iterdir())
        self.assertEqual(done.returncode, 0, done.stderr)
        return {path.name: path.read_bytes() for path in out.iterdir()}

    def test_threads_and_shards_change_no_byte(self) -> None:
        whole = self.files_of("whole", "--jobs", 1)
        self.assertEqual(self.files_of("threads", "--jobs", 5), whole)
        self.assertEqual(self.merged("one", 1), whole)
        self.assertEqual(self.merged("seven", 7, "--jobs", 2), whole)

    def test_top_rows_of_shards(self) -> None:
        top = ("--top", 9, "--by", "e.Rc", "--order", "smallest")
        self.assertEqual(self.merged("top", 4, *top), self.files_of("whole", *top))

    def test_the_front_of_shards(self) -> None:
        front = ("--pareto", "ratio, smallest abs(brake)")
        whole = self.files_of("whole", *front)
        self.assertEqual(self.merged("front", 4, *front), whole)
        self.assertEqual(Array(self.folder / "whole" / "train.sweep.npy").in_words(
            json.loads(whole["train.sweep.json"])["words"]), self.text_rows(TRAIN + SWEEP, *front))

    def test_a_result_is_replaced_and_a_foreign_file_is_not(self) -> None:
        whole = self.files_of("whole")
        out = self.folder / "whole"
        again = kinestat("sweep", "--format", "npy", "--out", out, self.file)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual({path.name: path.read_bytes() for path in out.iterdir()}, whole)
        (out / "train.sweep.npy").write_bytes(b"\x93NUMPY\x01\x00 of somebody else")
        refused = kinestat("sweep", "--format", "npy", "--out", out, self.file)
        self.assertEqual(refused.returncode, 4)
        self.assertIn("E0153", refused.stderr)

    def test_what_is_killed_goes_on_to_the_same_bytes(self) -> None:
        # The friction keeps every state on the long way.
        text = TRAIN.replace("at: [0, 0]}", "at: [0, 0], friction: {mu: 0.1, radius: 5}}", 1)
        self.file = self.write(text + """
sweep:
  vary: {Ns: {from: 17, to: 66, step: 1}, Np: {from: 17, to: 56, step: 1}}
  report: [ratio, efficiency, e.Rc]
""")
        whole = self.files_of("whole")
        out = self.new_folder("killed")
        command = [str(program()), "sweep", "--quiet", "--format", "npy", "--jobs", "2", "--out",
                   str(out)]
        with subprocess.Popen([*command, str(self.file)]) as process:
            work = out / "train.sweep-work"
            while process.poll() is None:
                if work.is_dir() and len(list(work.glob("chunk-*"))) >= 20:
                    process.send_signal(signal.SIGKILL)
                    break
                time.sleep(0.002)
        self.assertEqual(process.returncode, -signal.SIGKILL)
        done = kinestat(*command[1:], "--resume", self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual({path.name: path.read_bytes() for path in out.iterdir()}, whole)


def is_installed(name: str) -> bool:
    return importlib.util.find_spec(name) is not None


class Recipes(ArrayCase):
    """Those of the cookbook, run as they are printed."""

    def setUp(self) -> None:
        super().setUp()
        page = (ROOT / "manual" / "pages" / "cookbook.md").read_text(encoding="utf-8")
        self.recipes = {re.search(r"^import (\w+) as|^import (duckdb)$", code, re.M)[0].split()[1]: code
                        for code in re.findall(r"^```python\n(.*?)^```$", page, re.M | re.S)}
        self.assertEqual(set(self.recipes), {"numpy", "pandas", "duckdb"})
        file = self.write(TRAIN + SWEEP)
        rows = self.new_folder("rows")
        done = kinestat("sweep", "--format", "npy", "--out", rows, file)
        self.assertEqual(done.returncode, 0, done.stderr)
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)

    def run_printed(self, *names: str) -> dict[str, Any]:
        for name in names:
            if not is_installed(name):
                self.skipTest(f"{name} is not installed")
        space: dict[str, Any] = {}
        for name in names:
            with contextlib.redirect_stdout(io.StringIO()):
                exec(compile(self.recipes[name], f"recipe of {name}", "exec"), space)  # noqa: S102
        return space

    def test_numpy(self) -> None:
        space = self.run_printed("numpy")
        ratios = sorted(row["ratio"] for row in self.text_rows(TRAIN + SWEEP))
        self.assertEqual(sorted(space["best"]["ratio"].tolist()), ratios[-5:])
        self.assertTrue(space["rows"]["ratio"].flags.aligned)

    def test_pandas(self) -> None:
        frame = self.run_printed("numpy", "pandas")["frame"]
        expected = self.text_rows(TRAIN + SWEEP)
        self.assertEqual(list(frame.columns), list(expected[0]))
        self.assertEqual(frame["case"].astype(str).tolist(), [row["case"] for row in expected])
        self.assertEqual(frame["status"].astype(str).tolist(), [row["status"] for row in expected])
        self.assertEqual(frame["e.Rc [N]"].tolist(), [row["e.Rc [N]"] for row in expected])

    def test_duckdb(self) -> None:
        self.run_printed("numpy", "pandas", "duckdb")


class Refusals(ArrayCase):
    """What cannot be is said, with what to type instead."""

    def test_an_array_goes_into_a_folder(self) -> None:
        file = self.write(TRAIN + SWEEP)
        done = kinestat("sweep", "--format", "npy", file)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("--format npy needs --out", done.stderr)
        planned = kinestat("sweep", "--format", "npy", "--plan", file)
        self.assertIn("--format npy", planned.stdout, planned.stderr)
        shards = self.new_folder("shards")
        kinestat("sweep", "--format", "npy", "--shard", "1/1", "--out", shards, file)
        done = kinestat("merge", *shards.iterdir())
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("that needs --out", done.stderr)

    def test_two_columns_of_one_title(self) -> None:
        text = TRAIN.replace("torque: 5 N*m}", "torque: 5 N*m, status: 1}")
        self.write(text + "\nsweep: {vary: {status: [1, 2]}, report: [ratio]}\n")
        done = kinestat("sweep", "--format", "npy", "--out", self.folder, self.folder / "train.yaml")
        self.assertEqual(done.returncode, 3)
        self.assertIn("'status'", done.stderr)

    def test_compare_says_what_it_reads(self) -> None:
        self.sweep(TRAIN + SWEEP)
        array = self.folder / "out" / "train.sweep.npy"
        done = kinestat("compare", array, array)
        self.assertEqual(done.returncode, 3)
        self.assertIn("--format csv", done.stderr)


if __name__ == "__main__":
    main(__doc__)
