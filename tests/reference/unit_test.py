#!/usr/bin/env python3
"""Numbers in other units mean the same: derivatives of angles in a synthesis, and what `compare`
knows of the unit of each number of a report.

Usage: unit_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import program

PROGRAM = ""
MECHANISMS = Path()

# A position of the coupler of a four-bar with the centres (0, 0) and (100, 0), and its derivatives
# by the angle of the crank.
AT = (36.360618665509389, 63.634052253840025)
ANGLE = 28.233327929978075  # [deg]
PATH = ((-17.587604731018758, 17.793001031133758), (-35.434865968411706, -25.0018543628305),
        (40.697720630498997, -15.182808621895394), (21.994230481939902, -0.2003848449128784))
TURN = (-15.549089992687156, 19.937672248046308, -15.610547348622894, -6.6666709517084634)  # [deg]


def task(file_unit: str, angles: list[str]) -> str:
    angle = ANGLE if file_unit == "deg" else math.radians(ANGLE)
    steps = "".join(f"        - {{at: [{x}, {y}], angle: {a}}}\n"
                    for (x, y), a in zip(PATH, angles))
    return (f"kinestat: 1\nunits: {{length: mm, angle: {file_unit}}}\nsynthesis:\n  positions:\n"
            f"    - at: [{AT[0]}, {AT[1]}]\n      angle: {angle!r}\n      derivatives:\n{steps}")


class DerivativesOfAngles(unittest.TestCase):
    def expect_known_centres(self, text: str, *arguments: str) -> None:
        found = program.run("synthesize", *arguments, "-", text=text)
        dyads = found["synthesis"]["tasks"][0]["dyads"]
        centres = [dyad["centre_point"] for dyad in dyads]
        for known in ((0.0, 0.0), (100.0, 0.0)):
            nearest = min(math.dist(known, centre) for centre in centres if centre)
            self.assertLess(nearest, 1e-7, centres)

    def test_bare_numbers_count_in_the_angle_unit_of_the_file(self) -> None:
        self.expect_known_centres(task("deg", [repr(a) for a in TURN]))
        self.expect_known_centres(task("rad", [repr(math.radians(a)) for a in TURN]))

    def test_numbers_with_a_unit_count_in_that(self) -> None:
        self.expect_known_centres(task("rad", [f"{a!r} deg" for a in TURN]))
        self.expect_known_centres(task("deg", [f"{math.radians(a)!r} rad" for a in TURN]))

    def test_with_many_digits_too(self) -> None:
        self.expect_known_centres(task("deg", [repr(a) for a in TURN]), "--digits", "40")


BODY = """\
kinestat: 1
space: planar
units: {units}
gravity: [0, -9.81 m/s^2]
ground: g
bodies: {{crank: {{mass: 2 kg, centre_of_mass: [0.3 m, 0.1 m]}}}}
couplings:
  a: {{type: revolute, bodies: [g, crank], at: [0, 0]}}
actuators: {{motor: {{coupling: a}}}}
loads:
  f: {{body: crank, at: [0.2 m, 0.05 m], force: [3 N, -10 N]}}
  t: {{body: crank, couple: 2 N*m}}
cases: {{c: {{motion: {{motor: 3 rad/s}}, action: {{}}}}}}
"""

CRANK_AND_SLIDER = """\
kinestat: 1
space: planar
units: {units}
ground: g
bodies: [crank, rod, slider]
couplings:
  a: {{type: revolute, bodies: [g, crank], at: [0 m, 0 m]}}
  b: {{type: revolute, bodies: [crank, rod], at: [0.3 m, 0.4 m]}}
  c: {{type: revolute, bodies: [rod, slider], at: [1.5 m, 0 m]}}
  d: {{type: prismatic, bodies: [g, slider], at: [1.5 m, 0 m], axis: x}}
actuators: {{motor: {{coupling: a}}}}
loads: {{push: {{body: slider, at: [1.5 m, 0 m], force: [-10 N, 0]}}}}
cases: {{c: {{motion: {{motor: 3 rad/s}}, action: {{}}}}}}
motion: {{case: c, drive: motor, to: 360 deg, steps: 12}}
"""

PENDULUM = """\
kinestat: 1
space: planar
units: {units}
gravity: [0, -9.81 m/s^2]
ground: g
bodies: {{rod: {{mass: 2 kg, inertia: 0.1 kg*m^2, centre_of_mass: [0.3 m, 0 m]}}}}
couplings:
  a: {{type: revolute, bodies: [g, rod], at: [0 m, 0 m]}}
simulation: {{time: 0.5 s, steps: 5, report: [position, velocity, action, energy]}}
"""

# It falls on a stop, from which it rises again.
FALL = """kinestat: 1
space: planar
units: {units}
gravity: [0, -9.81 m/s^2]
ground: g
bodies: {{block: {{mass: 2 kg, centre_of_mass: [0 m, 1 m]}}}}
couplings:
  a: {{type: prismatic, bodies: [g, block], at: [0 m, 1 m], axis: y}}
simulation:
  stops: {{a.vy: {{from: -0.4 m, restitution: 0.5}}}}
  time: 0.5 s
  steps: 5
"""

IN_METRES = "{length: m}"
IN_OTHERS = "{length: mm, angle: deg, angular_velocity: rpm, force: kN, moment: N*mm, power: kW}"


class Compare(unittest.TestCase):
    def differences(self, command: str, form: str, first: str, second: str) -> list[dict]:
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for name, text in (("a", first), ("b", second)):
                paths.append(Path(folder, name))
                done = subprocess.run([PROGRAM, command, "--format", form, "-"], input=text,
                                      capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)
                paths[-1].write_text(done.stdout, encoding="utf-8")
            return self.compared(*paths)

    @staticmethod
    def compared(first: Path, second: Path) -> list[dict]:
        done = subprocess.run([PROGRAM, "compare", "--format", "json", str(first), str(second)],
                              capture_output=True, text=True, check=False)
        return json.loads(done.stdout)["differences"]

    def test_one_body_in_two_sets_of_units_is_the_same(self) -> None:
        for form in ("json", "csv"):
            self.assertEqual(self.differences("analyze", form, BODY.format(units=IN_METRES),
                                              BODY.format(units=IN_OTHERS)), [])

    def test_one_motion_in_two_sets_of_units_is_the_same(self) -> None:
        for form in ("json", "csv"):
            self.assertEqual(self.differences("motion", form,
                                              CRANK_AND_SLIDER.format(units=IN_METRES),
                                              CRANK_AND_SLIDER.format(units=IN_OTHERS)), [])

    def test_one_simulation_in_two_sets_of_units_is_the_same(self) -> None:
        for form in ("json", "csv"):
            self.assertEqual(self.differences("simulate", form, PENDULUM.format(units=IN_METRES),
                                              PENDULUM.format(units=IN_OTHERS)), [])

    def test_one_fall_in_two_sets_of_units_is_the_same(self) -> None:
        """Where and how fast it strikes, too."""
        for form in ("json", "csv"):
            self.assertEqual(self.differences("simulate", form, FALL.format(units=IN_METRES),
                                              FALL.format(units=IN_OTHERS)), [])
        speeds = "{length: mm, velocity: ft/s}"
        report = program.run("simulate", "-", text=FALL.format(units=speeds))
        event = report["simulation"]["events"][0]
        self.assertEqual((event["kind"], event["unit"], event["speed_unit"]),
                         ("impact", "mm", "ft/s"))
        self.assertAlmostEqual(event["position"], -400, delta=1e-9)
        self.assertAlmostEqual(event["speed"], -math.sqrt(2 * 9.81 * 0.4) / 0.3048, delta=1e-7)

    def test_another_motion_is_not(self) -> None:
        text = CRANK_AND_SLIDER.format(units=IN_METRES)
        for form in ("json", "csv"):
            found = self.differences("motion", form, text, text.replace("1.5 m, 0 m]}", "1.5 m, 1 mm]}"))
            self.assertTrue(any("position" in one["place"] for one in found), found[:5])

    def test_the_unit_of_every_number_is_known(self) -> None:
        """The same numbers under another unit of length: what counts in lengths then differs in
        size; a number whose unit is not known cannot be compared."""
        unknown = ("/graph/matrices/", "/affine/", "/self_stresses/", "/ratio", "/torque_ratio",
                   "/freedoms/", "/actions/", "/each", "/losses/actuators/", "/parameters/",
                   "~1ratio", "~1mechanical_advantage")
        for path in sorted(MECHANISMS.rglob("*.yaml")):
            for command in ("analyze", "motion"):
                with self.subTest(f"{command} {path.name}"), tempfile.TemporaryDirectory() as folder:
                    report = program.report(program.call(command, str(path)))
                    if "mechanism" not in report:
                        continue
                    first, second = Path(folder, "a"), Path(folder, "b")
                    first.write_text(json.dumps(report), encoding="utf-8")
                    units = report["mechanism"]["units"]
                    units["length"] = "cm" if units["length"] == "mm" else "mm"
                    second.write_text(json.dumps(report), encoding="utf-8")
                    for one in self.compared(first, second):
                        is_known = one["type"] != "unit" or any(u in one["place"] for u in unknown)
                        self.assertTrue(is_known, one)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    program.use(PROGRAM)
    MECHANISMS = Path(sys.argv.pop(1))
    unittest.main()
