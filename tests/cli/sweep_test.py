#!/usr/bin/env python3
"""Sweeps end to end: what their rows say, and that nobody who shares, interrupts or damages a run
changes a byte of its result unseen."""

from __future__ import annotations

import argparse
import csv
import json
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path("kinestat")

# A planetary set whose ring is held: 24 x 4 teeth, two cases.
TRAIN = """
kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {Ns: 24, Np: 18, Nr: Ns + 2*Np, alpha: 20 deg, module: 2, torque: 5 N*m}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  b: {type: revolute, bodies: [housing, ring], at: [0, 0]}
  c: {type: revolute, bodies: [housing, carrier], at: [0, 0]}
  d: {type: revolute, bodies: [carrier, planet], at: [0, (Ns + Np)/2*module]}
  e: {type: gear, bodies: [sun, planet], at: [0, Ns/2*module], tangent: x, pressure_angle: alpha}
  f: {type: gear, bodies: [ring, planet], at: [0, Nr/2*module], tangent: x, pressure_angle: alpha,
      internal: true}
actuators:
  motor: {coupling: a}
  wheel: {coupling: c}
  brake: {coupling: b}
cases:
  low: {motion: {motor: 100 rpm, brake: 0}, action: {motor: torque}, input: motor, output: wheel}
  back: {motion: {motor: 100 rpm, wheel: 0}, action: {motor: torque}, input: motor,
         output: brake}
"""

SWEEP = """
sweep:
  vary:
    Ns: {from: 17, to: 40, step: 1}
    Np: {values: [17, 18, 20, 25]}
    torque: {from: 1 N*m, to: 3 N*m, step: 0.5 N*m}
  require: ["mod(Ns + Nr, 3) == 0"]
  report: [ratio, torque_ratio, brake, e.Rc, d.wz]
"""

# Cranks whose coupler is stretched where the slider rests: x = 5 is a dead point.
CRANK = """
kinestat: 1
space: planar
parameters: {reach: 4}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [2, 5 - reach]}
  c: {type: revolute, bodies: [rod, slider], at: [6, 0]}
  d: {type: prismatic, bodies: [frame, slider], at: [6, 0], axis: x}
actuators:
  drive: {coupling: a}
  load: {coupling: d}
cases:
  push: {motion: {load: 1 m/s}, action: {load: 1 N}, input: load, output: drive}
"""


def kinestat(*arguments: object, **options: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(PROGRAM), *map(str, arguments)], capture_output=True, encoding="utf-8", check=False,
        timeout=240, **options,
    )


class InFolder(unittest.TestCase):
    """Each test in a folder of its own."""

    def setUp(self) -> None:
        self.place = tempfile.TemporaryDirectory(prefix="kinestat-sweep-")
        self.addCleanup(self.place.cleanup)
        self.folder = Path(self.place.name)

    def write(self, text: str, name: str = "train.yaml") -> Path:
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def new_folder(self, name: str) -> Path:
        path = self.folder / name
        path.mkdir()
        return path

    def rows(self, text: str, *options: str) -> list[dict[str, str]]:
        done = kinestat("sweep", *options, self.write(text))
        self.assertEqual(done.returncode, 0, done.stderr)
        return list(csv.DictReader(done.stdout.splitlines()))


class Rows(InFolder):
    """What the rows say."""

    def test_the_ratio_is_one_plus_ring_over_sun(self) -> None:
        rows = self.rows(TRAIN + SWEEP)
        low = [row for row in rows if row["case"] == "low"]
        self.assertEqual(len(low) * 2, len(rows))
        for row in low:
            sun, planet = int(row["Ns"]), int(row["Np"])
            self.assertAlmostEqual(float(row["ratio"]), 1 + (sun + 2 * planet) / sun, delta=1e-13)

    def test_rows_are_those_of_single_analyses(self) -> None:
        rows = self.rows(TRAIN + SWEEP)
        seed = random.SystemRandom().randrange(10**6)
        print(f"seed {seed}")
        for row in random.Random(seed).sample(rows, 25):
            done = kinestat(
                "analyze", "--format", "json", "--set", f"Ns={row['Ns']}", "--set",
                f"Np={row['Np']}", "--set", f"torque={row['torque [N*m]']} N*m",
                self.folder / "train.yaml",
            )
            case = json.loads(done.stdout)["cases"][row["case"]]
            for title, value in (
                ("ratio", case["ratio"]), ("torque_ratio", case["torque_ratio"]),
                ("brake [N*m]", case["statics"]["actions"]["brake"]),
                ("e.Rc [N]", case["statics"]["actions"]["e.Rc"]),
                ("d.wz [rad/s]", case["kinematics"]["freedoms"]["d.wz"]),
            ):
                # Other pivots round otherwise, no more.
                self.assertAlmostEqual(float(row[title]), value, delta=1e-13 * abs(value))

    def test_ranges_are_exact_and_teeth_are_whole(self) -> None:
        text = TRAIN + """
sweep:
  vary: {module: {from: 0.1, to: 0.3, step: 0.1}, Ns: {from: 30, to: 18, step: -6}}
  cases: [low]
  report: [ratio]
"""
        rows = self.rows(text)
        self.assertEqual([row["module"] for row in rows[::3]], ["0.1", "0.2", "0.3"])
        self.assertEqual([row["Ns"] for row in rows[:3]], ["30", "24", "18"])

    def test_what_is_left_out_counts_for_the_first_requirement(self) -> None:
        text = TRAIN + """
sweep:
  vary: {Ns: {from: 1, to: 10, step: 1}, Np: {from: 1, to: 10, step: 1}}
  require: [Np > 2, Ns > 4, Ns + Np > 12]
  cases: [low]
  report: [ratio]
"""
        out = self.new_folder("out")
        done = kinestat("sweep", "--out", out, self.write(text))
        self.assertEqual(done.returncode, 0, done.stderr)
        told = json.loads((out / "train.sweep.json").read_text())
        excluded = [one["excluded"] for one in told["require"]]
        pairs = [(s, p) for s in range(1, 11) for p in range(1, 11)]
        self.assertEqual(excluded[0], sum(p <= 2 for s, p in pairs))
        self.assertEqual(excluded[1], sum(p > 2 and s <= 4 for s, p in pairs))
        self.assertEqual(excluded[2], sum(p > 2 and s > 4 and s + p <= 12 for s, p in pairs))
        self.assertEqual(told["analysed"], 100 - sum(excluded))
        self.assertEqual(told["rows"], told["analysed"])

    def test_requirements_of_the_outer_parameters_skip_at_once(self) -> None:
        text = TRAIN.replace("torque: 5 N*m", "torque: 5 N*m, x: 1, y: 1") + """
sweep:
  vary:
    x: {from: 1, to: 100000, step: 1}
    y: {from: 1, to: 1000000, step: 1}
    Ns: {from: 20, to: 21, step: 1}
  require: [x == 77, y == x*x]
  cases: [low]
  report: [ratio]
"""
        rows = self.rows(text)
        self.assertEqual([(row["x"], row["y"], row["Ns"]) for row in rows],
                         [("77", "5929", "20"), ("77", "5929", "21")])

    def test_a_singular_position_is_a_row_and_its_neighbours_are_right(self) -> None:
        """Fault 75: with the rod along the slider's way, the slider cannot drive the crank."""
        text = CRANK + """
sweep:
  vary: {reach: {from: 4, to: 6, step: 0.25}}
  report: [ratio, a.wz]
"""
        rows = self.rows(text)
        for row in rows:
            height = 5 - float(row["reach"])
            if height == 0:
                self.assertEqual((row["status"], row["ratio [m/s per rad/s]"]), ("singular", ""))
                continue
            # The pole of the rod lies above the slider on the line of the crank, at 6/2 of its height.
            speed = -6 / 4 * height
            self.assertEqual(row["status"], "solved")
            self.assertAlmostEqual(float(row["ratio [m/s per rad/s]"]), speed, delta=1e-12)

    def test_a_set_that_rests_is_locked(self) -> None:
        """Fault 79: the ratio is 0/0."""
        text = TRAIN + """
sweep:
  vary: {Ns: [20, 24]}
  cases: [rest, held]
  report: [ratio]
"""
        text = text.replace("cases:\n", """cases:
  rest: {motion: {motor: 0, brake: 0}, input: motor, output: wheel}
  held: {motion: {motor: 1 rad/s, wheel: 0}, input: motor, output: wheel}
""", 1)
        rows = self.rows(text)
        self.assertEqual([(row["ratio"], row["status"]) for row in rows],
                         [("", "locked"), ("", "no_ratio")] * 2)

    def test_a_mechanism_that_cannot_move_is_locked(self) -> None:
        """Fault 70: net degree of freedom 0."""
        text = CRANK.replace("  d: {type: prismatic, bodies: [frame, slider], at: [6, 0], axis: x}",
                             "  d: {type: revolute, bodies: [frame, slider], at: [6, -2]}\n"
                             "  e: {type: revolute, bodies: [frame, slider], at: [7, 3]}")
        text = text.replace("load: 1 m/s", "load: 1 rad/s").replace("action: {load: 1 N}, ", "")
        rows = self.rows(text + "\nsweep: {vary: {reach: [3, 4]}, report: [ratio]}\n")
        self.assertEqual([row["status"] for row in rows], ["locked", "locked"])

    def test_geometry_that_does_not_exist_is_a_row_with_its_code(self) -> None:
        text = CRANK.replace("at: [2, 5 - reach]", "at: [2, sqrt(9 - reach^2)]") + """
sweep:
  vary: {reach: [2, 3, 4]}
  require: [1/(reach - 2) > -100]
  report: [ratio]
"""
        rows = self.rows(text.replace("reach: 4}", "reach: 1}"))
        self.assertEqual([row["status"] for row in rows], ["E0316", "singular", "E0316"])

    def test_top_rows_are_the_best_and_ties_go_to_the_first(self) -> None:
        text = TRAIN + SWEEP
        everything = self.rows(text)
        for order, sign in (("largest", -1), ("smallest", 1)):
            best = self.rows(text, "--top", "13", "--by", "ratio", "--order", order)
            wanted = sorted(everything, key=lambda row: sign * float(row["ratio"]))[:13]
            self.assertEqual(best, wanted)

    def test_json_lines_say_the_same_as_csv(self) -> None:
        table = self.rows(TRAIN + SWEEP)
        done = kinestat("sweep", "--format", "json", self.folder / "train.yaml")
        objects = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(len(objects), len(table))
        for row, one in zip(table, objects):
            self.assertEqual(list(row), list(one))
            for title, cell in row.items():
                value = one[title]
                text = value if isinstance(value, str) else json.dumps(value)
                self.assertEqual(cell, "" if value is None else text)

    def test_parameters_that_move_the_shape_of_couplings(self) -> None:
        """The force along the line of action, times cos alpha, is the torque over the radius."""
        import math

        text = TRAIN + """
sweep: {vary: {alpha: {from: 15 deg, to: 25 deg, step: 2.5 deg}}, cases: [low], report: [e.Rc]}
"""
        for row in self.rows(text):
            force = float(row["e.Rc [N]"]) * math.cos(math.radians(float(row["alpha [deg]"])))
            self.assertAlmostEqual(abs(force), 5 / 0.024, delta=1e-9)


class Sharing(InFolder):
    """Threads, shards, interruptions and damage."""

    def setUp(self) -> None:
        super().setUp()
        self.file = self.write(TRAIN + SWEEP)
        self.whole = self.new_folder("whole")
        done = kinestat("sweep", "--jobs", "1", "--out", self.whole, self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.files = {path.name: path.read_bytes() for path in self.whole.iterdir()}
        self.assertEqual(set(self.files), {"train.sweep.csv", "train.sweep.json"})

    def shards(self, count: int, folder: str = "shards", *options: str) -> list[Path]:
        place = self.new_folder(folder)
        for k in range(1, count + 1):
            done = kinestat("sweep", *options, "--shard", f"{k}/{count}", "--out", place, self.file)
            self.assertEqual(done.returncode, 0, done.stderr)
        return sorted(place.iterdir())

    def assert_merges(self, shards: list[Path], name: str) -> None:
        out = self.new_folder(name)
        done = kinestat("merge", "--out", out, *shards)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual({path.name: path.read_bytes() for path in out.iterdir()}, self.files)

    def refused(self, status: int, words: list[str], *shards: object) -> None:
        out = self.folder / "refused"
        out.mkdir(exist_ok=True)
        done = kinestat("merge", "--out", out, *shards)
        self.assertEqual(done.returncode, status, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertEqual(list(out.iterdir()), [])

    def test_threads_and_shards_change_no_byte(self) -> None:
        """Fault 112."""
        for jobs in (2, 8):
            out = self.new_folder(f"jobs{jobs}")
            kinestat("sweep", "--jobs", jobs, "--out", out, self.file)
            self.assertEqual({p.name: p.read_bytes() for p in out.iterdir()}, self.files)
        for count in (1, 2, 7, 16):
            for jobs in ("1", "2"):
                shards = self.shards(count, f"s{count}j{jobs}", "--jobs", jobs)
                self.assertEqual(len(shards), count)
                random.shuffle(shards)
                self.assert_merges(shards, f"m{count}j{jobs}")

    def test_standard_output_has_the_same_rows(self) -> None:
        streamed = kinestat("sweep", "--jobs", "3", self.file).stdout.encode()
        merged = kinestat("merge", *self.shards(3)).stdout.encode()
        self.assertEqual(streamed, self.files["train.sweep.csv"])
        self.assertEqual(merged, self.files["train.sweep.csv"])

    def test_top_rows_of_shards(self) -> None:
        top = ("--top", "5", "--by", "e.Rc", "--order", "smallest")
        streamed = kinestat("sweep", *top, self.file).stdout
        merged = kinestat("merge", *self.shards(7, "top", *top)).stdout
        self.assertEqual(merged, streamed)
        self.assertEqual(len(streamed.splitlines()), 6)

    def test_missing_and_duplicate_shards_are_named(self) -> None:
        """Fault 109."""
        shards = self.shards(4)
        self.refused(3, ["E0907", "2/4 is missing"], shards[0], *shards[2:])
        self.refused(3, ["E0907", "3/4 is there twice"], *shards, shards[2])
        self.refused(3, ["E0907", "1/4, 3/4, 4/4 are missing"], shards[1])

    def test_damaged_shards_are_named(self) -> None:
        """Fault 108: cut off or changed at any place."""
        shards = self.shards(3)
        victim = shards[1]
        text = victim.read_bytes()
        places = random.Random(7).sample(range(len(text)), 40)
        for at in [0, len(text) - 1, *places]:
            victim.write_bytes(text[:at])
            self.refused(3, ["E0906", victim.name], *shards)
            changed = bytes([text[at] ^ 1])
            victim.write_bytes(text[:at] + changed + text[at + 1:])
            done = kinestat("merge", *shards)
            self.assertEqual(done.returncode, 3, (at, text[at - 20:at + 20], done.stderr))
        victim.write_bytes(text + text)
        self.refused(3, ["E0906", victim.name], *shards)
        victim.write_bytes(text)
        self.assert_merges(shards, "mended")

    def test_shards_of_another_plan_or_version_are_refused(self) -> None:
        """Fault 111."""
        shards = self.shards(2)
        others = self.shards(2, "others", "--set", "module=3")
        self.refused(3, ["E0906", others[1].name, "another sweep"], shards[0], others[1])
        text = shards[0].read_text()
        version = json.loads(text.splitlines()[0])["kinestat"]["version"]
        shards[0].write_text(text.replace(f'"version":"{version}"', '"version":"0.0.1"', 1))
        self.refused(3, ["E0906", "version 0.0.1"], *shards)
        self.refused(3, ["E0906", "no shard"], self.file)
        self.refused(4, ["E0151"], self.folder / "nothing.shard")

    def test_shards_outside_their_count_are_refused(self) -> None:
        """Fault 110."""
        for word in ("0/4", "5/4", "a/b", "1/0", "1", "/", "1/4/2", "-1/4", "1.5/4", ""):
            done = kinestat("sweep", "--out", self.whole, f"--shard={word}", self.file)
            self.assertEqual(done.returncode, 2, word)
            self.assertIn("E0101", done.stderr)


class Interruption(InFolder):
    """A sweep of some seconds that is ended on the way."""

    OPTIONS = ("--jobs", "2", "--quiet", "--progress", "always")

    def setUp(self) -> None:
        super().setUp()
        # The friction keeps every state on the long way.
        text = TRAIN.replace("at: [0, 0]}", "at: [0, 0], friction: {mu: 0.1, radius: 5}}", 1)
        self.file = self.write(text + """
sweep:
  vary: {Ns: {from: 17, to: 66, step: 1}, Np: {from: 17, to: 56, step: 1}}
  report: [ratio, efficiency, e.Rc]
""")
        out = self.new_folder("whole")
        kinestat("sweep", "--quiet", "--out", out, self.file)
        self.files = {path.name: path.read_bytes() for path in out.iterdir()}
        self.assertEqual(len(self.files), 2)

    def start(self, out: Path, *options: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [str(PROGRAM), "sweep", *self.OPTIONS, *options, "--out", str(out), str(self.file)],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
        )

    def interrupt(self, out: Path, with_signal: signal.Signals, *options: str) -> int:
        """Ends it once some chunks are there, if it has not ended before."""
        process = self.start(out, *options)
        work = out / "train.sweep-work"
        while process.poll() is None:
            if work.is_dir() and len(list(work.glob("chunk-*"))) >= 20:
                process.send_signal(with_signal)
                break
            time.sleep(0.002)
        process.communicate()
        return process.returncode

    def test_signals_end_it_and_resume_completes_it(self) -> None:
        """Faults 105 and 106."""
        for with_signal in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            with self.subTest(with_signal=with_signal):
                out = self.new_folder(with_signal.name)
                status = self.interrupt(out, with_signal)
                self.assertEqual(status, -with_signal)
                self.assertEqual([path.name for path in out.iterdir()], ["train.sweep-work"])
                (out / "train.sweep-work" / ".kinestat-0123456789abcdef.tmp").write_text("stale")
                refused = kinestat("sweep", "--out", out, self.file)
                self.assertEqual(refused.returncode, 4)
                self.assertIn("E0908", refused.stderr)
                again = self.interrupt(out, with_signal, "--resume")
                self.assertIn(again, (0, -with_signal))
                done = kinestat("sweep", "--resume", "--jobs", "1", "--out", out, self.file)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual({p.name: p.read_bytes() for p in out.iterdir()}, self.files)

    def test_damaged_chunks_are_made_again(self) -> None:
        out = self.new_folder("damaged")
        self.interrupt(out, signal.SIGKILL)
        chunks = sorted((out / "train.sweep-work").glob("chunk-*"))
        chunks[0].write_bytes(chunks[0].read_bytes()[:-5])
        text = chunks[1].read_bytes()
        chunks[1].write_bytes(text[:-9] + bytes([text[-9] ^ 1]) + text[-8:])
        chunks[2].rename(chunks[2].with_name("chunk-99999999"))
        done = kinestat("sweep", "--resume", "--out", out, self.file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual({p.name: p.read_bytes() for p in out.iterdir()}, self.files)

    def test_resume_goes_on_only_with_the_same_sweep(self) -> None:
        out = self.new_folder("other")
        self.interrupt(out, signal.SIGTERM)
        done = kinestat("sweep", "--resume", "--set", "module=3", "--out", out, self.file)
        self.assertEqual(done.returncode, 4)
        self.assertIn("E0908", done.stderr)
        done = kinestat("sweep", "--force", "--out", out, self.file)
        self.assertEqual({p.name: p.read_bytes() for p in out.iterdir()}, self.files)
        before = {p.name: p.stat().st_ino for p in out.iterdir()}
        done = kinestat("sweep", "--resume", "--out", out, self.file)
        self.assertIn("complete", done.stderr)
        self.assertEqual({p.name: p.stat().st_ino for p in out.iterdir()}, before)

    def test_two_processes_on_one_folder(self) -> None:
        """Fault 107: the second is told, and both together leave one whole result."""
        out = self.new_folder("both")
        both = [self.start(out), self.start(out)]
        told = [process.communicate()[1] for process in both]
        statuses = sorted(process.returncode for process in both)
        self.assertIn(statuses, ([0, 4], [0, 0]), told)
        self.assertEqual({p.name: p.read_bytes() for p in out.iterdir()}, self.files)

    def test_a_closed_pipe_ends_it_quietly(self) -> None:
        """Fault 100."""
        done = subprocess.run(
            ["bash", "-c", f"'{PROGRAM}' sweep -q '{self.file}' | head -3; echo ${{PIPESTATUS[0]}}"],
            capture_output=True, encoding="utf-8", check=True, cwd=self.folder, timeout=240,
        )
        self.assertEqual(done.stderr, "")
        self.assertIn(done.stdout.splitlines()[-1], ("141", "0"))
        self.assertEqual(len(done.stdout.splitlines()), 4)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"train.yaml", "whole"})

    def test_progress_has_a_rate_and_no_escape_sequence(self) -> None:
        done = kinestat("sweep", "--progress", "always", self.file)
        self.assertRegex(done.stderr, r"\d+ %, \d+ of 2000 states, \d+ rows")
        self.assertNotIn("\x1b", done.stderr)
        self.assertEqual(kinestat("sweep", "-q", self.file).stderr, "")


class Library(InFolder):
    """Every mechanism, with its parameters moved one by one: rows are what analyses say."""

    def compare(self, row: dict[str, str], case: dict[str, object], context: str) -> int:
        kinematics, statics = case.get("kinematics") or {}, case.get("statics") or {}
        values = {"ratio": case.get("ratio"), "torque_ratio": case.get("torque_ratio"),
                  **kinematics.get("freedoms", {}), **statics.get("actions", {})}
        largest: dict[str, float] = {}
        for title in row:
            name, _, unit = title.partition(" [")
            if isinstance(values.get(name), float):
                largest[unit] = max(largest.get(unit, 0.0), abs(values[name]))
        compared = 0
        for title, cell in row.items():
            name, _, unit = title.partition(" [")
            if name not in values:
                continue
            if values[name] is None:
                self.assertEqual(cell, "", (context, title))
            else:
                self.assertAlmostEqual(float(cell), values[name], delta=1e-9 * largest[unit],
                                       msg=f"{context} {title}")
                compared += 1
        return compared

    def sweep_one(self, text: str, name: str, value: float, unit: str) -> int:
        typed = f"{value!r} {unit}".strip()
        text = re.split(r"^published:", text, flags=re.M)[0]
        file = self.write(f"{text}\nsweep: {{vary: {{{name}: [{typed}]}}}}\n")
        swept = kinestat("sweep", "--quiet", file)
        analysed = kinestat("analyze", "--format", "json", "--set", f"{name}={typed}", file)
        rows = list(csv.DictReader(swept.stdout.splitlines()))
        if analysed.returncode not in (0, 5) or not analysed.stdout:
            self.assertTrue(all(row["status"].startswith("E") for row in rows), swept.stdout)
            return 0
        cases = json.loads(analysed.stdout).get("cases", {})
        return sum(self.compare(row, cases[row["case"]], f"{name}={typed}") for row in rows)

    def test_rows_are_those_of_analyses(self) -> None:
        compared = 0
        for path in sorted((ROOT / "mechanisms").rglob("*.yaml")):
            report = json.loads(kinestat("analyze", "--format", "json", path).stdout or "{}")
            parameters = report.get("mechanism", {}).get("parameters", {})
            text = re.sub(r"^sweep:\n(?:[ ].*\n)*", "", path.read_text(), flags=re.M)
            for name, entry in list(parameters.items())[:4]:
                with self.subTest(file=path.name, parameter=name):
                    if "value" in entry and "cases" in report:
                        value = entry["value"] * 1.0625 + (entry["value"] == 0.0) * 0.125
                        compared += self.sweep_one(text, name, value, entry["unit"])
        self.assertGreater(compared, 1000)


class Extremes(InFolder):
    """Size."""

    def test_a_train_of_a_thousand_members(self) -> None:
        """Fault 88: a chain of 1000 wheels, a sweep over one of them."""
        names = [f"g{i}" for i in range(1000)]
        lines = ["kinestat: 1", "space: planar", "parameters: {r: 1}", "ground: frame",
                 f"bodies: [{', '.join(names)}]", "couplings:"]
        for i, name in enumerate(names):
            lines.append(f"  c{i}: {{type: revolute, bodies: [frame, {name}], at: [{2 * i}, 0]}}")
        for i in range(999):
            at = "r" if i == 0 else str(2 * i + 1)
            lines.append(f"  m{i}: {{type: gear, bodies: [g{i}, g{i + 1}], at: [{at}, 0], "
                         "tangent: y, pressure_angle: 20 deg}")
        lines += ["actuators: {first: {coupling: c0}, last: {coupling: c999}}",
                  "cases: {turn: {motion: {first: 1 rad/s}, input: first, output: last}}",
                  "sweep: {vary: {r: {from: 0.5, to: 1.5, step: 0.25}}, report: [ratio]}"]
        begin = time.monotonic()
        rows = self.rows("\n".join(lines) + "\n")
        self.assertLess(time.monotonic() - begin, 60)
        for row in rows:
            radius = float(row["r"])
            # The first mesh has radii r and 2 - r; all others are even.
            self.assertAlmostEqual(float(row["ratio"]), -(2 - radius) / radius, delta=1e-9)

    def test_memory_does_not_depend_on_the_number_of_states(self) -> None:
        import resource

        def peak(last: int) -> int:
            file = self.write(TRAIN + f"""
sweep: {{vary: {{Ns: {{from: 17, to: {last}, step: 1}}}}, cases: [low], report: [ratio]}}
""")
            code = ("import resource,subprocess,sys;subprocess.run(sys.argv[1:],check=True,"
                    "stdout=subprocess.DEVNULL);"
                    "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
            done = subprocess.run(
                [sys.executable, "-c", code, str(PROGRAM), "sweep", "-q", str(file)],
                capture_output=True, encoding="utf-8", check=True, timeout=240,
                # With the address sanitizer, what is freed is kept to be looked at.
                env={**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=4"},
            )
            return int(done.stdout)

        self.assertLess(peak(200017), 1.2 * peak(20017) + 2000)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, rest = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
