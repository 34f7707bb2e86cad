"""Finite motions as columns, and the closed forms they are held against."""

from __future__ import annotations

import cmath
import math
import sys
import unittest
from pathlib import Path
from typing import Callable

import program
from reference_test_case import ReferenceTest

CLOSURE = 1e-12
DEAD_POINT = 1e-9


class Motion:
    """The rows of a report as columns by name; every cell by step."""

    def __init__(self, report: dict) -> None:
        self.report = report["motion"]
        self.names = [column["name"] for column in self.report["columns"]]
        self.rows = self.report["rows"]

    def __getitem__(self, name: str) -> list[float]:
        at = self.names.index(name)
        return [row[at] for row in self.rows]

    def events(self, kind: str, element: str | None = None) -> list[float]:
        """Positions of the first drive."""
        return [event["drive"][0] for event in self.report["events"]
                if event["kind"] == kind and element in (None, event["element"])]

    def point(self, element: str, quantity: str) -> list[complex]:
        return [complex(x, y) for x, y in
                zip(self[f"{element}/{quantity}/x"], self[f"{element}/{quantity}/y"])]


_library = Path()


def in_library(path: str) -> Path:
    return _library / path


def run(source: str | Path, *options: str, status: int = 0) -> Motion:
    """The motion of a file, or of a text."""
    is_file = isinstance(source, Path)
    done = program.call("motion", *options, str(source) if is_file else "-",
                        text=None if is_file else source)
    if done.returncode != status:
        raise AssertionError(f"status {done.returncode}\n{done.stderr}")
    return Motion(program.report(done))


# Closed forms


def turned(point: complex, angle: float) -> complex:
    return point * cmath.exp(1j * angle)


def dyad(p: complex, q: complex, r: float, s: float, like: tuple[complex, ...]) -> complex:
    """The point at the distances r from p and s from q, on the side on which c is of a-b."""
    d = abs(q - p)
    along = (r * r - s * s + d * d) / (2 * d)
    across = math.sqrt(max(r * r - along * along, 0.0))
    a, b, c = like
    side = math.copysign(1.0, ((b - a).conjugate() * (c - a)).imag)
    return p + (along + 1j * side * across) * (q - p) / d


def unwrapped(angles: list[float]) -> list[float]:
    result = angles[:1]
    for angle in angles[1:]:
        result.append(angle + 2 * math.pi * round((result[-1] - angle) / (2 * math.pi)))
    return result


def derivative(f: Callable[[float], complex], t: float, order: int, h: float = 0.08) -> complex:
    """By Richardson's extrapolation of central differences, to about 1e-9 of the function."""
    def difference(d: float) -> complex:
        if order == 1:
            return (f(t + d) - f(t - d)) / (2 * d)
        return (f(t + d) - 2 * f(t) + f(t - d)) / (d * d)

    table = [difference(h / 2 ** k) for k in range(5)]
    for level in range(1, 5):
        table = [(4 ** level * fine - coarse) / (4 ** level - 1)
                 for coarse, fine in zip(table, table[1:])]
    return table[0]


class MotionTest(ReferenceTest):
    def close(self, actual: float, expected: float, tolerance: float, what: str) -> None:
        self.assertLessEqual(abs(actual - expected), tolerance,
                             f"{what}: {actual} is not {expected}")

    def check(self, motion: Motion, name: str, expected: Callable[[float], float],
              tolerance: float) -> None:
        """A column against a function of the first drive."""
        for drive, value in zip(motion[motion.names[1]], motion[name]):
            self.close(value, expected(drive), tolerance, f"{name} at {drive}")

    def check_complete(self, motion: Motion, steps: int) -> None:
        self.assertEqual(motion.report["status"], "complete")
        self.assertEqual([row[0] for row in motion.rows], list(range(steps + 1)))
        self.assertEqual(set(motion["status"]), {"solved"})
        self.assertLessEqual(motion.report["closure"]["largest"], CLOSURE)


def main() -> None:
    """Tests of the calling file, whose arguments are the program, the library, and unittest's."""
    global _library
    program.use(sys.argv[1])
    _library = Path(sys.argv[2])
    sys.argv = [sys.argv[1], *sys.argv[3:]]
    unittest.main(argv=sys.argv)
