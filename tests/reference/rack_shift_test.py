#!/usr/bin/env python3
"""Checks the shift table of a two-speed rack drive to closed form, in several units.

Usage: rack_shift_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import csv
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path

import program
from reference_test_case import ReferenceTest

# A shaft turns one of two pinions, which drive one rack; radii of 30 and 20 mm.
RACK = """\
kinestat: 1
name: Two speeds of a rack
space: planar
units: {{length: {length}, force: N, moment: {torque}}}
ground: frame
bodies: [shaft, slow, fast, rack{more}]
couplings:
  a: {{type: revolute, bodies: [frame, shaft], at: [0 m, 30 mm]}}
  S: {{type: clutch, bodies: [shaft, slow], at: [0 m, 30 mm]}}
  F: {{type: clutch, bodies: [shaft, fast], at: [0 m, 30 mm]}}
  b: {{type: revolute, bodies: [frame, slow], at: [0 m, 30 mm]}}
  c: {{type: revolute, bodies: [frame, fast], at: [0 m, 30 mm]}}
  r: {{type: prismatic, bodies: [frame, rack], at: [0, 0], axis: x}}
  p: {{type: rack, bodies: [slow, rack], at: [0, 0], line_of_action: [cos(20 deg), -sin(20 deg)]}}
  q: {{type: rack, bodies: [fast, rack], at: [0 m, 10 mm], line_of_action: [cos(20 deg), -sin(20 deg)]}}
{couplings}
actuators: {{motor: {{coupling: a}}, feed: {{coupling: r}}{actuator}}}
shift:
  input: motor
  {outputs}
  elements: [S, F]
  input_motion: 10 rad/s
  input_action: 3 N*m
  names: {{"1": [S], "2": [F]}}
"""
ONE = {"more": "", "couplings": "", "actuator": "", "outputs": "output: feed"}
TWO = {"more": ", wheel", "actuator": ", side: {coupling: d}",
       "couplings": "  d: {type: revolute, bodies: [frame, wheel], at: [0 m, 75 mm]}\n"
                    "  t: {type: gear, bodies: [slow, wheel], at: [0 m, 60 mm], tangent: x,"
                    " pressure_angle: 20 deg}",
       "outputs": "output: [feed, side]"}
# Unit of length, of torque, radius of 1 m in it, and 1 N·m in it.
UNITS = (("mm", "N*m", 1000.0, 1.0), ("m", "N*mm", 1.0, 1000.0))
RADII = {"1": 0.030, "2": 0.020}  # [m]


class RackShift(ReferenceTest):
    def write(self, length: str, torque: str, outputs: dict[str, str]) -> Path:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = Path(folder.name) / "rack.yaml"
        path.write_text(RACK.format(length=length, torque=torque, **outputs), encoding="utf-8")
        return path

    def shift(self, path: Path, style: str) -> str:
        done = program.plain("shift", "--format", style, str(path))
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_ratios_have_their_units_in_reports(self) -> None:
        for length, torque, metre, newton_metre in UNITS:
            shift = json.loads(self.shift(self.write(length, torque, ONE), "json"))["shift"]
            self.assertEqual(shift["ratio_unit"], f"rad/{length}")
            self.assertEqual(shift["torque_ratio_unit"], torque.removeprefix("N*"))
            for gear, radius in RADII.items():
                state = shift["states"][gear]
                self.near(state["ratio"], 1 / (radius * metre), gear, 1.0)
                self.near(state["torque_ratio"], -radius * newton_metre, gear, 1.0)

    def test_ratios_have_their_units_in_tables(self) -> None:
        for length, torque, metre, _ in UNITS:
            path = self.write(length, torque, ONE)
            rows = list(csv.DictReader(io.StringIO(self.shift(path, "csv"))))
            ratios = [row for row in rows if row["quantity"] == "ratio"]
            self.assertEqual(len(ratios), 2)
            for row in ratios:
                self.assertEqual(row["unit"], f"rad/{length}")
                self.near(float(row["value"]), 1 / (RADII[row["case"]] * metre), row["case"], 1.0)
            self.assertIn(f"ratio [rad/{length}]", self.shift(path, "table"))

    def test_each_of_several_outputs_has_its_own(self) -> None:
        shift = json.loads(self.shift(self.write("mm", "N*m", TWO), "json"))["shift"]
        self.assertEqual(shift["ratio_unit"], {"feed": "rad/mm", "side": ""})
        first = shift["states"]["1"]["ratio"]
        self.near(first["feed"], 1 / 30, "feed", 1.0)
        self.near(first["side"], -15 / 30, "side", 1.0)

    def test_reports_in_other_units_are_equal(self) -> None:
        for outputs in (ONE, TWO):
            for style in ("json", "csv"):
                reports = []
                for i, (length, torque, _, _) in enumerate(UNITS):
                    path = self.write(length, torque, outputs)
                    reports.append(path.parent / f"{i}.{style}")
                    reports[-1].write_text(self.shift(path, style), encoding="utf-8")
                done = program.plain("compare", *map(str, reports))
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
