"""The program under test: its reports as dictionaries."""

from __future__ import annotations

import json
import subprocess

_path = ""


def use(path: str) -> None:
    global _path
    _path = path


def call(command: str, *arguments: str, text: str | None = None) -> subprocess.CompletedProcess:
    return subprocess.run(
        [_path, command, "--format", "json", *arguments],
        input=text, capture_output=True, text=True, check=False,
    )


def plain(command: str, *arguments: str, text: str | None = None) -> subprocess.CompletedProcess:
    """A call in the form that the command has by itself."""
    return subprocess.run(
        [_path, command, *arguments],
        input=text, capture_output=True, text=True, check=False,
    )


def report(done: subprocess.CompletedProcess) -> dict:
    """The report of a call, which may have failed; empty if it wrote none."""
    return json.loads(done.stdout or "{}")


def run(command: str, *arguments: str, text: str | None = None,
        statuses: tuple[int, ...] = (0,)) -> dict:
    done = call(command, *arguments, text=text)
    if done.returncode not in statuses:
        raise AssertionError(f"status {done.returncode}\n{done.stderr}\n{text or ''}")
    return report(done)


def synthesize(*arguments: str, text: str | None = None) -> dict:
    """With its report where no linkage is usable, too."""
    return run("synthesize", *arguments, text=text, statuses=(0, 5))
