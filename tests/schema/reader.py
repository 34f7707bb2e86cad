"""Asks the program's reader what it thinks of many files at once."""

from __future__ import annotations

import re
import subprocess
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

LINE = re.compile(r"(\d+)\.yaml(?::\d+:\d+)?: (error|warning)\[([EW]\d{4})\]: (.*)")
AT_ONCE = 500


@dataclass(frozen=True)
class Finding:
    code: str
    message: str
    hint: str = ""


@dataclass
class Verdict:
    """What the program found in one file."""

    findings: list[Finding] = field(default_factory=list)

    @property
    def errors(self) -> list[Finding]:
        """Without E0315: such a file is right, though this version cannot analyse it."""
        return [one for one in self.findings if one.code[0] == "E" and one.code != "E0315"]

    @property
    def structural(self) -> list[Finding]:
        """Errors of shape: version, unknown key, missing key, wrong shape, word not allowed."""
        return [one for one in self.errors if "E0301" <= one.code <= "E0305"]


def note(line: str, verdicts: list[Verdict], last: Verdict | None) -> Verdict | None:
    """Adds a line of the program's to the verdicts; answers the verdict that it belongs to."""
    if match := LINE.fullmatch(line):
        last = verdicts[int(match[1])]
        last.findings.append(Finding(match[3], match[4]))
    elif last is not None and line.startswith("  hint: ") and not last.findings[-1].hint:
        finding = last.findings.pop()
        last.findings.append(Finding(finding.code, finding.message, line.removeprefix("  hint: ")))
    return last


def check(program: Path, texts: list[str]) -> list[Verdict]:
    verdicts = [Verdict() for _ in texts]
    with tempfile.TemporaryDirectory() as name:
        for i, text in enumerate(texts):
            (Path(name) / f"{i}.yaml").write_text(text, encoding="utf-8")
        for begin in range(0, len(texts), AT_ONCE):
            paths = [f"{i}.yaml" for i in range(begin, min(begin + AT_ONCE, len(texts)))]
            done = subprocess.run([program, "check", *paths], cwd=name, capture_output=True,
                                  text=True, check=False, timeout=120)
            if done.returncode not in (0, 1, 3, 5):
                raise RuntimeError(f"kinestat check: status {done.returncode}\n{done.stderr}")
            last = None
            for line in done.stderr.splitlines():
                last = note(line, verdicts, last)
    return verdicts
