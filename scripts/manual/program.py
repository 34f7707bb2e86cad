"""The program whose manual is written: everything that it knows is asked of it."""

from __future__ import annotations

import json
import os
import re
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

# Lines of lists: two spaces, a word, and what it means.
_ENTRY = re.compile(r"^  ([a-z][a-z_-]*)(?: +|$)(.*)$")


# Exit statuses: 5 where a case, a motion or a task has no answer, and all else is printed.
ANSWERED = (0, 5)


class Program:
    """Called in one folder, so that the names of files are those that a reader would type."""

    def __init__(self, path: Path, folder: Path):
        self._folder = folder
        self.environment = {
            "PATH": f"{path.parent}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8", "HOME": str(folder),
        }
        self._path = path

    def __call__(self, *arguments: str) -> str:
        """What is printed on standard output; an error stops the manual."""
        done = subprocess.run(
            [self._path, *arguments], cwd=self._folder, env=self.environment,
            capture_output=True, encoding="utf-8", check=False,
        )
        _check(done.returncode, ANSWERED, f"kinestat {' '.join(arguments)}\n{done.stderr}")
        return done.stdout

    def shell(self, script: str, expected: tuple[int, ...] = (0,)) -> str:
        """What a reader sees who types these lines: standard output and error together."""
        done = subprocess.run(
            ["bash", "-o", "pipefail", "-c", script], cwd=self._folder, env=self.environment,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False,
        )
        _check(done.returncode, expected, f"{script}\n{done.stdout}")
        return done.stdout

    @cache
    def topics(self) -> dict[str, str]:
        """Topics of help, each with what it is about."""
        return _entries(self("help"), "Topics:")

    @cache
    def commands(self) -> dict[str, str]:
        return _entries(self("--help"), "Commands:")

    @cache
    def pictures(self) -> dict[str, str]:
        return _entries(self("help", "plot"), "Pictures:")

    @cache
    def messages(self) -> dict[str, str]:
        """Codes of errors and warnings, each with its title."""
        return dict(line.split(None, 1) for line in self("explain").splitlines())

    @cache
    def schema(self) -> dict[str, Any]:
        return json.loads(self("schema"))

    def pictures_of(self, file: str) -> list[str]:
        """The pictures that a mechanism file has."""
        lines = [line.split() for line in self("plot", "list", file).splitlines()]
        return [words[1] for words in lines if words and words[0] == "yes"]


def _check(status: int, expected: tuple[int, ...], said: str) -> None:
    if status not in expected:
        awaited = " or ".join(map(str, expected))
        raise SystemExit(f"manual: exit status {status} instead of {awaited}: {said}")


def _entries(text: str, heading: str) -> dict[str, str]:
    """The entries below a heading; a long word has its meaning on the next line."""
    found: dict[str, str] = {}
    block = text.partition(f"{heading}\n")[2].partition("\n\n")[0]
    for line in block.splitlines():
        entry = _ENTRY.match(line)
        if entry:
            found[entry[1]] = entry[2]
        elif found:
            last = list(found)[-1]
            found[last] = f"{found[last]} {line.strip()}".strip()
    if not found:
        raise SystemExit(f"manual: the program lists nothing below '{heading}'")
    return found
