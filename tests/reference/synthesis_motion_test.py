#!/usr/bin/env python3
"""Moves the linkages of the synthesis tasks: they do what their verdicts say, and nothing else.

Usage: synthesis_motion_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Iterator

import program

MECHANISMS = Path()
POSITION = 1e-9


def tasks(report: dict) -> Iterator[dict]:
    for task in report["synthesis"]["tasks"]:
        if task.get("linkages"):
            yield task


def digits(task: dict, linkage: dict) -> float:
    return min(task["dyads"][i]["digits"] for i in linkage["dyads"])


class Linkages(unittest.TestCase):
    def files(self) -> list[Path]:
        return sorted(path for path in (MECHANISMS / "synthesis").glob("*.yaml")
                      if "transmission:" not in path.read_text("utf-8"))

    def test_move_as_their_verdicts_say(self) -> None:
        counts = {"passes": 0, "cannot": 0}
        for path in self.files():
            for task in tasks(program.synthesize("--verify", str(path))):
                for linkage in task["linkages"]:
                    check = linkage["verification"]
                    if check is None:
                        self.assertEqual(linkage["defect"], "digits")
                        continue
                    self.assertTrue(check["agrees"], linkage)
                    if linkage["defect"] in ("circuit", "branch"):
                        self.assertIn(False, check["reached"])
                        counts["cannot"] += 1
                    if linkage["defect"] is None:
                        self.assertTrue(check["in_order"])
                        self.assertNotIn(False, check["reached"])
                        allowed = max(POSITION, 10 ** -digits(task, linkage))
                        self.assertLessEqual(check["worst"], allowed)
                        counts["passes"] += 1
        self.assertGreater(counts["passes"], 10)
        self.assertGreater(counts["cannot"], 5)

    def test_lead_through_the_positions_as_written(self) -> None:
        """What the comment of a written file says of its drive, by 'kinestat motion' on the file."""
        moved = 0
        for path in self.files():
            if path.stem == "function_generator":  # see function_generator_test
                continue
            with tempfile.TemporaryDirectory() as folder:
                report = program.synthesize("--write-mechanism", folder, str(path))
                turn = 360.0 if report["mechanism"]["units"]["angle"] == "deg" else 2 * math.pi
                for task in tasks(report):
                    for linkage in task["linkages"]:
                        if linkage["file"] and digits(task, linkage) > 9:
                            self.check_file(task, linkage, turn)
                            moved += 1
        self.assertGreater(moved, 10)

    def check_file(self, task: dict, linkage: dict, turn: float) -> None:
        verdict = next(one for one in linkage["drives"] if one["dyad"] == linkage["drive"])
        slides = task["dyads"][linkage["drive"]]["type"] == "slider"
        sign = -1.0 if verdict["passage"] == "decreasing" else 1.0
        way = 0.0
        for before, now, position in zip(verdict["coordinates"], verdict["coordinates"][1:],
                                         task["positions"][1:]):
            step = now - before
            way += step + (sign * turn if not slides and sign * step < 0 else 0.0)
            if abs(way) > 1e-6:
                motion = program.run("motion", linkage["file"], "--drive", "drive", "--to",
                                     repr(way), "--steps", "20", "--report", "position")["motion"]
                self.check_pose(motion, task["positions"][0], position, turn)

    def check_pose(self, motion: dict, first: dict, wanted: dict, turn: float) -> None:
        names = [column["name"] for column in motion["columns"]]
        last = dict(zip(names, motion["rows"][-1]))
        self.assertEqual(motion["status"], "complete")
        at = last["coupler/at/x"], last["coupler/at/y"]
        size = max(1.0, *(abs(x) for x in (*first["at"], *wanted["at"])))
        self.assertLessEqual(math.dist(at, wanted["at"]), 100 * POSITION * size)
        fault = math.remainder(
            last["coupler/rotation/z"] - (wanted["angle"] - first["angle"]), turn)
        self.assertLessEqual(abs(fault), 100 * POSITION * turn)


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    sys.argv = [sys.argv[0], *sys.argv[3:]]
    unittest.main(argv=sys.argv)
