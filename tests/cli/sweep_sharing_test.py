#!/usr/bin/env python3
"""Sweeps, end to end: sharding, interrupting or damaging a run changes no byte of its result
unnoticed."""

from __future__ import annotations

import csv
import json
import os
import random
import re
import signal
import subprocess
import tempfile
import time
from functools import lru_cache
from pathlib import Path

from sweep_case import SWEEP, TRAIN, InFolder, has_sanitizers, kinestat, main, program


@lru_cache(maxsize=None)
def written(text: str) -> dict[str, bytes]:
    """What a sweep of the file on one thread writes: with this all others are compared."""
    with tempfile.TemporaryDirectory(prefix="kinestat-sweep-") as name:
        file, out = Path(name) / "train.yaml", Path(name) / "out"
        file.write_text(text, encoding="utf-8")
        out.mkdir()
        done = kinestat("sweep", "--quiet", "--jobs", "1", "--out", out, file)
        assert done.returncode == 0, done.stderr
        files = {path.name: path.read_bytes() for path in out.iterdir()}
    assert set(files) == {"train.sweep.csv", "train.sweep.json"}
    return files


class Sharing(InFolder):
    """Threads, shards, interruptions and damage."""

    SWEEP = SWEEP

    def setUp(self) -> None:
        super().setUp()
        self.file = self.write(TRAIN + self.SWEEP)
        self.files = written(self.file.read_text(encoding="utf-8"))

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
        for jobs in (2, 8):
            out = self.new_folder(f"jobs{jobs}")
            kinestat("sweep", "--jobs", jobs, "--out", out, self.file)
            self.assertEqual({p.name: p.read_bytes() for p in out.iterdir()}, self.files)
        for count in (3,) if has_sanitizers() else (1, 2, 7, 16):
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

    def test_fronts_of_shards(self) -> None:
        """By their definition, of all rows."""
        front = ("--pareto", "ratio, smallest abs(e.Rc)")
        streamed = kinestat("sweep", "--jobs", "2", *front, self.file).stdout
        merged = kinestat("merge", *self.shards(7, "front", *front)).stdout
        self.assertEqual(merged, streamed)
        every = list(csv.DictReader(self.files["train.sweep.csv"].decode().splitlines()))
        def keys(row: dict[str, str]) -> tuple[float, float]:
            # Numbers that differ by rounding alone are equal.
            return float(f"{float(row['ratio']):.10g}"), -float(f"{abs(float(row['e.Rc [N]'])):.10g}")
        def is_beaten(i: int) -> bool:
            ratio, force = keys(every[i])
            return any(keys(row)[0] >= ratio and keys(row)[1] >= force and
                       (keys(row) != (ratio, force) or j < i)
                       for j, row in enumerate(every) if j != i)
        expected = [every[i] for i in range(len(every)) if not is_beaten(i)]
        self.assertTrue(2 < len(expected) < len(every))
        self.assertEqual(list(csv.DictReader(streamed.splitlines())),
                         sorted(expected, key=keys, reverse=True))
        summary = self.new_folder("summary")
        kinestat("sweep", *front, "--out", summary, self.file)
        told = json.loads((summary / "train.sweep.json").read_text())
        self.assertIsNone(told["top"])
        self.assertEqual(told["pareto"], [{"by": "ratio", "order": "largest"},
                                          {"by": "abs(e.Rc)", "order": "smallest"}])

    def test_rows_that_nothing_ranks_are_counted(self) -> None:
        """A file without losses has no efficiency: not one row is left, and that is said."""
        self.write(TRAIN + SWEEP.replace("report: [", "report: [efficiency, "))
        by = ("--pareto", "efficiency, smallest ratio")
        streamed = kinestat("sweep", *by, self.file)
        merged = kinestat("merge", *self.shards(3, "unranked", *by))
        for done in (streamed, merged):
            self.assertEqual(len(done.stdout.splitlines()), 1)
            self.assertIn("without a value of efficiency, ratio: 320 rows", done.stderr)
        ranked = kinestat("sweep", "--top", "3", "--by", "ratio", self.file)
        self.assertNotIn("without a value", ranked.stderr)

    def test_kept_rows_are_those_that_fulfil_the_conditions(self) -> None:
        """By the numbers of all rows, in any shards, and the best of them by a formula."""
        self.write(TRAIN + self.SWEEP + '  keep: [ratio > 4.2, "abs(e.Rc) < 100 N or Np == 18"]\n')
        def is_kept(row: dict[str, str]) -> bool:
            return float(row["ratio"]) > 4.2 and (abs(float(row["e.Rc [N]"])) < 100 or
                                                  row["Np"] == "18")
        every = list(csv.DictReader(self.files["train.sweep.csv"].decode().splitlines()))
        expected = [row for row in every if is_kept(row)]
        self.assertTrue(0 < len(expected) < len(every))
        merged = kinestat("merge", *self.shards(5))
        self.assertEqual(list(csv.DictReader(merged.stdout.splitlines())), expected)
        self.assertEqual(kinestat("sweep", "--jobs", "2", self.file).stdout, merged.stdout)
        self.assertIn(f"dropped by 'ratio > 4.2': "
                      f"{sum(float(row['ratio']) <= 4.2 for row in every)} rows", merged.stderr)
        best = kinestat("sweep", "--top", "1", "--by", "abs(ratio - 4.6) + Ns/1000", "--order",
                        "smallest", self.file).stdout
        self.assertEqual(list(csv.DictReader(best.splitlines())),
                         [min(expected, key=lambda row: abs(float(row["ratio"]) - 4.6) +
                              float(row["Ns"]) / 1000)])

    def test_the_lines_of_a_plan_run_it(self) -> None:
        """As they are printed, through a stand-in for Slurm that runs the tasks one by one."""
        tools = self.new_folder("tools")
        (tools / "kinestat").symlink_to(program().resolve())
        sbatch = tools / "sbatch"
        sbatch.write_text("""#!/bin/bash
for word in "$@"; do
  case $word in --array=1-*) count=${word#--array=1-};; esac
done
for id in $(seq "$count"); do
  SLURM_ARRAY_TASK_ID=$id SLURM_ARRAY_TASK_COUNT=$count bash -c "${@: -1}" || exit 1
done
""")
        sbatch.chmod(0o755)
        name = "it's a train.yaml"
        self.file = self.file.rename(self.folder / name)
        choice = ("--set", "module=3", "--top", "4", "--by", "abs(ratio - 4) + abs(e.Rc/(1 N))/1e6")
        done = kinestat("sweep", "--plan", *choice, "--out", "nowhere", name, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        first = done.stdout.splitlines()[0]
        self.assertRegex(first, r"^it's a train: \d+ states in \d+ chunks$")
        self.assertRegex(done.stdout, r"\nThe whole: about \S+ s on one core")
        lines = [line for line in done.stdout.splitlines() if line.startswith("  ")]
        commands = [line for line in lines if re.match(r"  (mkdir|sbatch|kinestat) ", line)]
        self.assertEqual(len(commands), 3, done.stdout)
        ran = subprocess.run(["bash", "-e", "-c", "\n".join(commands)], cwd=self.folder,
                             env=os.environ | {"PATH": f"{tools}:{os.environ['PATH']}"},
                             capture_output=True, encoding="utf-8", check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        whole = kinestat("sweep", *choice, name, cwd=self.folder).stdout
        self.assertEqual((self.folder / "results" / "it's a train.sweep.csv").read_text(), whole)
        self.assertEqual(len(whole.splitlines()), 5)

    def test_a_plan_takes_about_as_long_as_it_says(self) -> None:
        """Within a factor of five, on whatever machine, of processor time."""
        if has_sanitizers():
            self.skipTest("their time is not the one of the program")
        self.write(TRAIN + SWEEP.replace("step: 0.5 N*m", "step: 0.0002 N*m"))
        told = kinestat("sweep", "--plan", self.file).stdout
        rate = float(re.search(r"s, (\S+) states/s", told)[1])
        states = int(re.search(r": (\d+) states", told)[1])
        before = os.times()
        kinestat("sweep", "--jobs", "1", "--out", self.new_folder("timed"), self.file)
        after = os.times()
        took = after.children_user - before.children_user
        self.assertGreater(5 * took, states / rate)
        self.assertLess(took / 5, states / rate)

    def test_missing_and_duplicate_shards_are_named(self) -> None:
        shards = self.shards(4)
        self.refused(3, ["E0907", "2/4 is missing"], shards[0], *shards[2:])
        self.refused(3, ["E0907", "3/4 is there twice"], *shards, shards[2])
        self.refused(3, ["E0907", "1/4, 3/4, 4/4 are missing"], shards[1])

    def test_damaged_shards_are_named(self) -> None:
        """Cut off, or changed at any place."""
        shards = self.shards(3)
        victim = shards[1]
        text = victim.read_bytes()
        places = random.Random(7).sample(range(len(text)), 5 if has_sanitizers() else 40)
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
        shards = self.shards(2)
        others = self.shards(2, "others", "--set", "module=3")
        self.refused(3, ["E0906", others[1].name, "another sweep"], shards[0], others[1])
        text = shards[0].read_text()
        version = json.loads(text.splitlines()[0])["kinestat"]["version"]
        shards[0].write_text(text.replace(f'"version":"{version}"', '"version":"0.0.1"', 1))
        self.refused(3, ["E0906", "version 0.0.1"], *shards)
        self.refused(3, ["E0906", "not a shard"], self.file)
        self.refused(4, ["E0151"], self.folder / "nothing.shard")

    def test_shards_outside_their_count_are_refused(self) -> None:
        for word in ("0/4", "5/4", "a/b", "1/0", "1", "/", "1/4/2", "-1/4", "1.5/4", ""):
            done = kinestat("sweep", "--out", self.folder / "out", f"--shard={word}", self.file)
            self.assertEqual(done.returncode, 2, word)
            self.assertIn("E0101", done.stderr)


class SampledSharing(Sharing):
    """The same of a sample."""

    SWEEP = SWEEP.replace("to: 3 N*m, step: 0.5 N*m}", "to: 3 N*m}") + (
        "  sample: {count: 500, method: latin, seed: 3}\n")


class Interruption(InFolder):
    """A sweep of some seconds that is ended on the way."""

    SAMPLE = ""
    OPTIONS = ("--jobs", "2", "--quiet", "--progress", "always")

    def setUp(self) -> None:
        super().setUp()
        # The friction keeps every state on the long way.
        text = TRAIN.replace("at: [0, 0]}", "at: [0, 0], friction: {mu: 0.1, radius: 5}}", 1)
        self.file = self.write(text + """
sweep:
  vary: {Ns: {from: 17, to: 66, step: 1}, Np: {from: 17, to: 56, step: 1}}
  report: [ratio, efficiency, e.Rc]
""" + self.SAMPLE)
        self.files = written(self.file.read_text(encoding="utf-8"))

    def start(self, out: Path, *options: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [str(program()), "sweep", *self.OPTIONS, *options, "--out", str(out), str(self.file)],
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
        signals = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)
        for with_signal in signals[-1:] if has_sanitizers() else signals:
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
        # What a power failure leaves: nothing, zeros of the right length, pages that are missing.
        chunks[3].write_bytes(b"")
        chunks[4].write_bytes(bytes(len(chunks[4].read_bytes())))
        text = chunks[5].read_bytes()
        half = len(text) // 2
        chunks[5].write_bytes(text[:half] + bytes(len(text) - half))
        text = chunks[6].read_bytes()
        chunks[6].write_bytes(bytes(half) + text[half:])
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
            ["bash", "-c", f"'{program()}' sweep -q '{self.file}' | head -3; echo ${{PIPESTATUS[0]}}"],
            capture_output=True, encoding="utf-8", check=True, cwd=self.folder, timeout=240,
        )
        self.assertEqual(done.stderr, "")
        self.assertIn(done.stdout.splitlines()[-1], ("141", "0"))
        self.assertEqual(len(done.stdout.splitlines()), 4)
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"train.yaml"})

    def test_progress_has_a_rate_and_no_escape_sequence(self) -> None:
        done = kinestat("sweep", "--progress", "always", self.file)
        self.assertRegex(done.stderr, r"\d+ %, \d+ of 2000 states, \d+ rows")
        self.assertNotIn("\x1b", done.stderr)
        self.assertEqual(kinestat("sweep", "-q", self.file).stderr, "")


class SampledInterruption(Interruption):
    """The same of a sample."""

    SAMPLE = "  sample: {count: 2000}\n"

    def setUp(self) -> None:
        if has_sanitizers():
            self.skipTest("it takes the same ways through the program")
        super().setUp()


if __name__ == "__main__":
    main(__doc__)
