"""Many files through one process of the program, and the result of each."""

from __future__ import annotations

import json
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path


@dataclass
class Result:
    """The exit status that the file alone would have, its report if there is one, its findings."""

    status: int
    report: dict
    findings: list[dict]

    def codes(self) -> list[str]:
        return sorted(one["code"] for one in self.findings)


class Batch:
    """Files in a folder of their own; every command is given all of them at once."""

    def __init__(self, program: str, texts: dict[str, str]) -> None:
        self.program = program
        self._folder = tempfile.TemporaryDirectory()
        self.paths: dict[str, Path] = {}
        for name, text in texts.items():
            path = Path(self._folder.name) / f"{name}.yaml"
            path.write_text(text, encoding="utf-8")
            self.paths[name] = path

    def close(self) -> None:
        self._folder.cleanup()

    def run(self, command: str, *options: str) -> dict[str, Result]:
        """A command that takes many files."""
        paths = [str(path) for path in self.paths.values()]
        done = subprocess.run(
            [self.program, command, "--format", "json", "--diagnostics", "json", *options, *paths],
            capture_output=True, text=True, check=False)
        # Alone, a file has its report on several lines.
        reports = ([json.loads(done.stdout)] if len(paths) == 1 and done.stdout
                   else [json.loads(line) for line in done.stdout.splitlines()])
        by_file = {report["mechanism"]["file"]: report for report in reports}
        said = {one["file"]: one for one in map(json.loads, done.stderr.splitlines())}
        return {name: Result(said[str(path)]["status"], by_file.get(str(path), {}),
                             said[str(path)]["diagnostics"])
                for name, path in self.paths.items()}

    def rows(self, name: str, *options: str) -> tuple[int, list[dict], str]:
        """The exit status, rows and messages of a sweep, which takes one file."""
        done = subprocess.run(
            [self.program, "sweep", "--format", "json", "--quiet", *options,
             str(self.paths[name])], capture_output=True, text=True, check=False)
        return done.returncode, [json.loads(line) for line in done.stdout.splitlines()], done.stderr
