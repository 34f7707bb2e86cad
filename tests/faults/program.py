"""The program, its commands as listed by its help, and one run with its cost and leftovers."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import sanitized  # noqa: E402  (tests/support/sanitized.py)

HANG_S = 60.0
# What a command needs to have an answer; a command that reads mechanism files and is not named here
# is given the first.
ANSWERED = {
    "": "mechanisms/planar/four_bar.yaml",
    "shift": "mechanisms/transmissions/muncie_m20.yaml",
    "duty": "mechanisms/transmissions/muncie_m20.yaml",
    "simulate": "tests/cli/simulation_of_a_pendulum/file.yaml",
    "sensitivity": "mechanisms/sweeps/four_bar_height.yaml",
    "sweep": "mechanisms/sweeps/four_bar_height.yaml",
    "synthesize": "mechanisms/synthesis/crank_rocker.yaml",
}
# Words that a command takes before its file, and options that keep a run short.
BEFORE = {"plot": ["coupling-graph"], "bench": ["--rounds", "1"], "sweep": ["--quiet"]}


@dataclass(frozen=True)
class Command:
    """A command that reads a mechanism file."""

    name: str
    help: str = field(repr=False)

    def arguments(self, *rest: str | bytes) -> list[str | bytes]:
        return [self.name, *BEFORE.get(self.name, []), *rest]

    @property
    def answered(self) -> Path:
        return ROOT / ANSWERED.get(self.name, ANSWERED[""])

    def options(self) -> dict[str, str]:
        """Long options, each with the word for its value, or with none."""
        listed = self.help.split("\nOptions:", 1)[-1]
        found = re.findall(r"^  (?:-\w,)?(--[\w-]+)(?:,--\w+)?(?: (\S+))?(?:  |$)", listed, re.M)
        return dict(found)


@dataclass
class Run:
    """What became of a run."""

    what: str
    status: int
    out: bytes
    err: bytes
    seconds: float
    memory: int
    left: list[str]

    @property
    def said(self) -> str:
        return self.err.decode("utf-8", "replace")

    def codes(self) -> list[str]:
        """Of the errors, in order."""
        return re.findall(r"error\[([EW]\d{4})\]", self.said)


class Program:
    """Runs in a fresh folder each, so that what a run leaves behind is seen."""

    def __init__(self, path: Path) -> None:
        self.path = path.resolve()
        self.count = 0
        self._lock = threading.Lock()
        self.has_sanitizers = sanitized.has_sanitizers(self.path)

    def run(self, arguments: list[str | bytes], *, files: dict[str, bytes] | None = None,
            env: dict[str, str] | None = None, shell: str = "", stdin: bytes = b"",
            hang: float = HANG_S) -> Run:
        """`shell` is run by bash before the program takes its place, `"$@"`."""
        with tempfile.TemporaryDirectory(prefix="kinestat-fault-") as name:
            folder = Path(name) / "here"
            folder.mkdir()
            for file, content in (files or {}).items():
                (folder / file).parent.mkdir(parents=True, exist_ok=True)
                (folder / file).write_bytes(content)
            before = self._contents(folder)
            run = self._start(arguments, folder, env, shell, stdin, hang)
            after = self._contents(folder)
            run.left = sorted(path for path in before | after
                              if before.get(path) != after.get(path))
        with self._lock:
            self.count += 1
        return run

    @staticmethod
    def _contents(folder: Path) -> dict[str, bytes]:
        return {str(path.relative_to(folder)): b"" if path.is_symlink() or not path.is_file()
                else path.read_bytes() for path in folder.rglob("*")}

    def _start(self, arguments: list[str | bytes], folder: Path, env: dict[str, str] | None,
               shell: str, stdin: bytes, hang: float) -> Run:
        command: list[str | bytes] = [str(self.path), *arguments]
        if shell:
            command = ["bash", "-c", shell, "bash", *command]
        surroundings = {"PATH": os.defpath, "LC_ALL": "C"} if env is None else env
        for kept in ("ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS"):
            if kept in os.environ:
                surroundings = {**surroundings, kept: os.environ[kept]}
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err, \
                tempfile.TemporaryFile() as given:
            given.write(stdin)
            given.seek(0)
            process = subprocess.Popen(command, cwd=folder, env=surroundings, stdin=given,
                                       stdout=out, stderr=err, start_new_session=True)
            killer = threading.Timer(hang, lambda: os.killpg(process.pid, signal.SIGKILL))
            killer.start()
            _, status, usage = os.wait4(process.pid, 0)
            killer.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            out.seek(0)
            err.seek(0)
            what = " ".join(os.fsdecode(word) for word in arguments)[:200]
            return Run(what, process.returncode, out.read(), err.read(),
                       usage.ru_utime + usage.ru_stime, usage.ru_maxrss << 10, [])

    def text(self, *arguments: str) -> str:
        return subprocess.run([self.path, *arguments], capture_output=True, text=True,
                              check=True).stdout

    def commands(self) -> list[Command]:
        """Those that read mechanism files."""
        listed = re.search(r"\nCommands:\n(.*?)\n\n", self.text("help", "commands"), re.S)
        assert listed, "the help lists no commands"
        names = re.findall(r"^  ([a-z]+)\b", listed[1], re.M)
        all_commands = [Command(name, self.text(name, "--help")) for name in names]
        return [one for one in all_commands if "--max-file-size" in one.help]

    def statuses(self) -> set[int]:
        """Those that its help explains, but that of a bug."""
        told = re.findall(r"^  (\d+)  +(.*)", self.text("help", "exit-status"), re.M)
        return {int(number) for number, meaning in told if "bug" not in meaning}

    def known_codes(self) -> set[str]:
        return set(re.findall(r"^([EW]\d{4})  ", self.text("explain"), re.M))
