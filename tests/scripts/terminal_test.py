#!/usr/bin/env python3
"""Shows reports and messages on a terminal of a few columns, with and without colors.

Usage: terminal_test.py PROGRAM
"""

from __future__ import annotations

import fcntl
import os
import pty
import re
import struct
import sys
import termios
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOTION = ROOT / "mechanisms" / "planar" / "slider_crank.yaml"
COLOR = re.compile(r"\x1b\[[0-9;]*m")

_program = ""


def shown(width: int, *arguments: str, **environment: str) -> str:
    """What a terminal of that many columns gets, both streams."""
    child, terminal = pty.fork()
    if child == 0:
        os.environ.pop("NO_COLOR", None)
        os.environ.update({"TERM": "xterm", **environment})
        os.execv(_program, [_program, *arguments])
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 40, width, 0, 0))
    text = b""
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError:  # the other side is closed
            break
        if not part:
            break
        text += part
    os.waitpid(child, 0)
    os.close(terminal)
    return text.decode().replace("\r\n", "\n")


class Terminal(unittest.TestCase):
    def test_every_line_of_a_report_fits(self) -> None:
        for command in ("motion", "analyze", "mobility"):
            text = COLOR.sub("", shown(72, command, str(MOTION)))
            self.assertGreater(text.count("\n"), 20, command)
            for line in text.splitlines():
                self.assertLessEqual(len(line), 72, f"{command}: {line}")

    def test_headings_stand_out(self) -> None:
        self.assertIn("\x1b[1mMotion", shown(100, "motion", str(MOTION)))

    def test_an_error_is_red(self) -> None:
        self.assertIn("\x1b[1;31merror[E0151]:", shown(100, "check", "none.yaml"))

    def test_no_color_is_obeyed(self) -> None:
        plain = [shown(100, "check", "none.yaml", NO_COLOR="1"),
                 shown(100, "check", "none.yaml", TERM="dumb"),
                 shown(100, "check", "--color", "never", "none.yaml")]
        for text in plain:
            self.assertNotRegex(text, COLOR)
        self.assertRegex(shown(100, "check", "none.yaml", NO_COLOR=""), COLOR)


if __name__ == "__main__":
    _program = sys.argv.pop(1)
    unittest.main()
