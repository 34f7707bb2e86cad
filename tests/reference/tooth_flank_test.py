#!/usr/bin/env python3
"""Flanks of teeth that a file writes as couplings: closed forms for loads of both signs, and trains
of the section `gears`, which say the same in numbers of teeth.

Usage: tooth_flank_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import csv
import io
import math
import sys
import unittest
from pathlib import Path

import program
from reference_test_case import ReferenceTest

MECHANISMS = Path()

ANGLE = math.radians(20)
RADIUS = 2.0  # of the pinion at the origin; its mate is above
TORQUE = 6.0
SIGNS = (1.0, -1.0)


def analyze(text: str) -> dict:
    return program.run("analyze", "-", text=text)


def actions_of(report: dict, label: str = "loaded") -> dict[str, float]:
    return report["cases"][label]["statics"]["actions"]


def spur(mesh: str, torque: float = TORQUE, wheel: str = "[0, 7]", space: str = "planar",
         second: str = "") -> str:
    """A pinion of radius 2 below a wheel of radius 5; `second` holds the wheel instead."""
    place = wheel if space == "planar" else wheel.replace("]", ", 0]")
    third, axis = ("", "") if space == "planar" else (", 0", ", axis: z")
    hinge = f"{{type: revolute, bodies: [frame, wheel], at: {place}{axis}}}"
    return f"""\
kinestat: 1
space: {space}
ground: frame
bodies: [pinion, wheel]
couplings:
  a: {{type: revolute, bodies: [frame, pinion], at: [0, 0{third}]{axis}}}
  b: {second or hinge}
  m: {{type: gear, bodies: [pinion, wheel], at: [0, {RADIUS}{third}]{axis}, {mesh}}}
actuators: {{in: {{coupling: a}}, out: {{coupling: b}}}}
cases: {{loaded: {{action: {{in: {torque}}}}}}}
"""


TANGENT = "tangent: x, pressure_angle: 20 deg"
LINES = (
    TANGENT,
    "line_of_action: [cos(20 deg), sin(20 deg){third}]",
    "line_of_action: [-cos(20 deg), -sin(20 deg){third}]",  # under the other load
    "line_of_action: [cos(20 deg), -sin(20 deg){third}]",   # would pull: of the coast flank
    "tangent: -x, pressure_angle: 20 deg",
    "tangent: x, pressure_angle: -20 deg",
)


class SpurGears(ReferenceTest):
    """T on a pitch radius r is a tangential force T/r, and tan(20 deg) of it parts the gears."""

    def test_are_parted_by_either_load(self) -> None:
        for space in ("planar", "spatial"):
            for mesh in LINES:
                mesh = mesh.replace("{third}", ", 0" if space == "spatial" else "")
                for sign in SIGNS:
                    with self.subTest(space=space, mesh=mesh, sign=sign):
                        text = spur(mesh, sign * TORQUE, space=space)
                        actions = actions_of(analyze(text))
                        parting = TORQUE / RADIUS * math.tan(ANGLE)
                        self.near(actions["a.Rx"], -sign * TORQUE / RADIUS, "tangential")
                        self.near(actions["a.Ry"], parting, "pinion")
                        self.near(actions["b.Ry"], -parting, "wheel")

    def test_keep_their_line_if_the_file_says_so(self) -> None:
        for mesh in LINES[:1] + LINES[3:4]:
            mesh = mesh.replace("{third}", "")
            radial = []
            for sign in SIGNS:
                text = spur(mesh + ", flank: fixed", sign * TORQUE)
                radial.append(actions_of(analyze(text))["a.Ry"])
            self.near(abs(radial[0]), TORQUE / RADIUS * math.tan(ANGLE), mesh)
            self.near(radial[1], -radial[0], mesh)

    def test_of_a_ring_push_the_pinion_inwards(self) -> None:
        """The ring of radius 5 is about [0, -3], around the pinion; either may be the tail."""
        parting = TORQUE / RADIUS * math.tan(ANGLE)
        for mesh in (TANGENT + ", internal: true", LINES[1].replace("{third}", ""), LINES[3].replace("{third}", "")):
            for bodies in ("[pinion, wheel]", "[wheel, pinion]"):
                for sign in SIGNS:
                    with self.subTest(mesh=mesh, bodies=bodies, sign=sign):
                        text = spur(mesh, sign * TORQUE, "[0, -3]").replace(
                            "type: gear, bodies: [pinion, wheel]", f"type: gear, bodies: {bodies}")
                        actions = actions_of(analyze(text))
                        self.near(actions["a.Rx"], -sign * TORQUE / RADIUS, "tangential")
                        self.near(actions["a.Ry"], parting, "pinion")
                        self.near(actions["b.Ry"], -parting, "ring")

    def test_are_found_from_one_hinge_where_the_mate_floats(self) -> None:
        """Nothing of what holds the wheel is a hinge."""
        held = "{type: screws, bodies: [frame, wheel], freedoms: [{rotation: z, at: [0, 7]}]}"
        for sign in SIGNS:
            text = spur(LINES[1].replace("{third}", ""), sign * TORQUE, second=held)
            self.near(actions_of(analyze(text))["a.Ry"], TORQUE / RADIUS * math.tan(ANGLE), f"{sign}")

    def test_on_a_shaft_to_which_they_are_fixed(self) -> None:
        for sign in SIGNS:
            text = spur(LINES[1].replace("{third}", ""), sign * TORQUE).replace(
                "bodies: [pinion, wheel]\n", "bodies: [shaft, pinion, wheel]\n", 1).replace(
                "bodies: [frame, pinion], at: [0, 0]}", "bodies: [frame, shaft], at: [0, 0]}\n"
                "  f: {type: rigid, bodies: [shaft, pinion], at: [0, 0]}")
            self.near(actions_of(analyze(text))["a.Ry"], TORQUE / RADIUS * math.tan(ANGLE), f"{sign}")


class HelicalGears(ReferenceTest):
    """tan(helix) of the tangential force along the axis, tan(20 deg) of it apart."""

    def test_push_along_the_axis_as_the_load_does(self) -> None:
        helix = math.radians(15)
        force = TORQUE / RADIUS
        for sign in SIGNS:
            text = spur(TANGENT + ", helix_angle: 15 deg", sign * TORQUE, space="spatial")
            actions = actions_of(analyze(text))
            # The tooth pushes the wheel along -x under a positive torque on the pinion below it.
            self.near(actions["b.Rx"], sign * force, "tangential")
            self.near(actions["b.Ry"], -force * math.tan(ANGLE), "radial")
            self.near(actions["b.Rz"], sign * force * math.tan(helix), "axial")

    def test_of_a_line_of_action_too(self) -> None:
        """cos αn (cos β t + sin β a) + sin αn r, with tan αn = tan 20 deg cos β."""
        line = ("line_of_action: [cos(an)*cos(15 deg), sin(an), cos(an)*sin(15 deg)]")
        head = "parameters: {an: atan(tan(20 deg)*cos(15 deg))}\n"
        for sign in SIGNS:
            loads = []
            for mesh in (line, TANGENT + ", helix_angle: 15 deg"):
                text = spur(mesh, sign * TORQUE, space="spatial")
                loads.append(actions_of(analyze(text.replace("ground:", head + "ground:"))))
            self.near_each(loads[0], loads[1])


class Rack(ReferenceTest):
    """A pinion of radius 2 above the rack; F along it lifts F tan(20 deg) off, to the guide."""

    TEXT = """\
kinestat: 1
space: {space}
ground: frame
bodies: [pinion, rack]
couplings:
  a: {{type: revolute, bodies: [frame, pinion], at: [0, 2{third}]{axis}}}
  g: {{type: prismatic, bodies: [frame, rack], at: [0, 0{third}], axis: x}}
  m: {{type: rack, bodies: {bodies}, at: [0, 0{third}]{axis}, line_of_action: {line}}}
actuators: {{in: {{coupling: a}}, out: {{coupling: g}}}}
cases: {{loaded: {{action: {{out: {force}}}}}}}
"""

    def test_is_lifted_off_by_either_load(self) -> None:
        for space, third, axis in (("planar", "", ""), ("spatial", ", 0", ", axis: z")):
            for line in ("cos(20 deg), sin(20 deg)", "cos(20 deg), -sin(20 deg)"):
                for bodies in ("[pinion, rack]", "[rack, pinion]"):
                    for sign in SIGNS:
                        with self.subTest(space=space, line=line, bodies=bodies, sign=sign):
                            actions = actions_of(analyze(self.TEXT.format(
                                space=space, third=third, axis=axis, bodies=bodies,
                                line=f"[{line}{third}]", force=sign * 5)))
                            parting = 5 * math.tan(ANGLE)
                            self.near(actions["g.Ry"], parting, "guide")
                            self.near(actions["a.Ry"], -parting, "hinge")
                            self.near(actions["a.Rx"], -sign * 5, "along the rack")


class BevelGears(ReferenceTest):
    """Shigley chapter 13: of W on the pitch radius, W tan(α) cos(δ) apart and W tan(α) sin(δ) along
    the axis, always from the apex outwards. Axes x and z through the origin, radii 3 and 4."""

    TEXT = """\
kinestat: 1
space: spatial
ground: frame
bodies: [pinion, crown]
couplings:
  a: {{type: revolute, bodies: [frame, pinion], at: [4, 0, 0], axis: x}}
  b: {{type: revolute, bodies: [frame, crown], at: [0, 0, 3], axis: z}}
  m: {{type: bevel_gear, bodies: [pinion, crown], at: [4, 0, 3], axis: [4, 0, 3], line_of_action: {line}}}
actuators: {{in: {{coupling: a}}, out: {{coupling: b}}}}
cases: {{loaded: {{action: {{in: {torque}}}}}}}
"""

    def test_push_from_the_apex_under_either_load(self) -> None:
        for line in ("[-3/5*sin(20 deg), cos(20 deg), 4/5*sin(20 deg)]",
                     "[3/5*sin(20 deg), cos(20 deg), -4/5*sin(20 deg)]"):
            for sign in SIGNS:
                with self.subTest(line=line, sign=sign):
                    actions = actions_of(analyze(self.TEXT.format(line=line, torque=sign * TORQUE)))
                    force = TORQUE / 3 * math.tan(ANGLE)
                    # The mesh pushes the pinion outwards and down to its axis, the crown likewise.
                    self.near(actions["a.Rx"], -force * 3 / 5, "thrust of the pinion")
                    self.near(actions["a.Rz"], force * 4 / 5, "radial force of the pinion")
                    self.near(actions["b.Rz"], -force * 4 / 5, "thrust of the crown")
                    self.near(actions["b.Rx"], force * 3 / 5, "radial force of the crown")
                    self.near(actions["a.Ry"], -sign * TORQUE / 3, "tangential")


class Worm(ReferenceTest):
    """worm_drive.yaml with a load of either sign: 300 N·m on a radius of 80 mm is 3750 N."""

    def test_is_parted_from_its_wheel_by_either_load(self) -> None:
        path = str(MECHANISMS / "gears" / "worm_drive.yaml")
        lead = 0.2
        for sign in SIGNS:
            report = program.run("analyze", "--set", f"load={sign * 300} N*m", path,
                                 statuses=(0, 1))  # the published values are of the first
            actions = actions_of(report, "driving")
            self.near(actions["A.Rx"], -sign * 3750, "thrust of the worm", 3750)
            self.near(actions["A.Rz"], sign * 3750 * lead, "across the worm", 3750)
            parting = 3750 * math.tan(ANGLE) * math.sqrt(1 + lead**2)
            self.near(actions["A.Ry"], parting, "apart", 3750)
            self.near(actions["B.Ry"], -parting, "apart", 3750)
            self.near(actions["B.Rz"], -sign * 750, "thrust of the wheel", 3750)


def planetary(by_hand: bool, tail: str) -> str:
    """Sun 24, planet 18, ring 60, module 2; the same in teeth and in coordinates."""
    teeth = """\
gears:
  module: size
  pressure_angle: alpha
  members:
    sun: {body: sun, teeth: 24}
    planet: {body: planet, teeth: 18}
    ring: {body: ring, teeth: 60, internal: true}
  meshes:
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
"""
    couplings = """\
  sp: {type: gear, bodies: [sun, planet], at: [0, 12*size], LINE}
  rp: {type: gear, bodies: [ring, planet], at: [0, 30*size], LINE, internal: true}
"""
    return f"""\
kinestat: 1
space: planar
parameters: {{size: 2, alpha: 25 deg, load: 1}}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  S: {{type: revolute, bodies: [housing, sun], at: [0, 0]}}
  R: {{type: revolute, bodies: [housing, ring], at: [0, 0]}}
  C: {{type: revolute, bodies: [housing, carrier], at: [0, 0]}}
  P: {{type: revolute, bodies: [carrier, planet], at: [0, 21*size]}}
{couplings if by_hand else teeth}\
actuators: {{s: {{coupling: S}}, r: {{coupling: R}}, c: {{coupling: C}}}}
cases:
  forward: {{motion: {{s: 1, r: 0}}, action: {{s: load}}, input: s, output: c}}
  backward: {{motion: {{s: 1, r: 0}}, action: {{s: -load}}, input: s, output: c}}
{tail}"""


class LikeTheSectionGears(ReferenceTest):
    """Whatever pass: the forces are those of `gears`, whose flanks have closed forms of their own in
    gear_train_test."""

    HAND = ("tangent: x, pressure_angle: alpha", "line_of_action: [cos(alpha), sin(alpha)]",
            "line_of_action: [cos(alpha), -sin(alpha)]")

    def texts(self, tail: str) -> list[str]:
        by_hand = planetary(True, tail)
        return [planetary(False, tail)] + [by_hand.replace("LINE", line) for line in self.HAND]

    def same(self, actual: object, expected: object, what: str) -> None:
        if isinstance(expected, dict):
            self.assertEqual(actual.keys(), expected.keys(), what)
            for key, value in expected.items():
                self.same(actual[key], value, f"{what}/{key}")
        elif isinstance(expected, float):
            self.near(actual, expected, what)
        else:
            self.assertEqual(actual, expected, what)

    def test_in_cases(self) -> None:
        by_teeth, *by_hand = (analyze(text) for text in self.texts(""))
        for label in ("forward", "backward"):
            for report in by_hand:
                self.same(actions_of(report, label), actions_of(by_teeth, label), label)

    def test_in_moved_positions(self) -> None:
        tail = ("motion: {drives: [{drive: s, to: 2}, {drive: r, to: 0.5}], steps: 4, case: backward, "
                "report: [action]}\n")
        tables = [self.table("motion", text, "--layout", "wide") for text in self.texts(tail)]
        self.assertIn("P.Ry/action [N]", tables[0][0])
        for table in tables[1:]:
            self.same_rows(table, tables[0])

    def test_in_sweeps_of_load_and_angle(self) -> None:
        tail = ("sweep: {vary: {load: {from: -3, to: 3, step: 1.5}, alpha: {from: 10 deg, to: 30 deg, "
                "step: 5 deg}}, cases: [forward], report: [S.Ry, R.Ry, P.Rx]}\n")
        tables = [self.table("sweep", text) for text in self.texts(tail)]
        for table in tables[1:]:
            self.same_rows(table, tables[0])

    def test_in_sweeps_of_the_size(self) -> None:
        tail = ("sweep: {vary: {size: {from: -3, to: 3, step: 1.2}, load: {from: -1, to: 1, step: 2}}, "
                "cases: [forward], report: [S.Ry, R.Ry]}\n")
        for text in self.texts(tail)[1:]:
            rows = self.table("sweep", text)
            self.assertEqual(len(rows), 12)
            for row in rows:
                # Apart: the sun from the planet on its side of the axis.
                size, load = float(row["size"]), float(row["load"])
                radial = abs(load) / (12 * abs(size)) * math.tan(math.radians(25))
                self.near(float(row["S.Ry [N]"]), math.copysign(radial, size), f"{row}")

    def test_in_sensitivities(self) -> None:
        reports = [program.run("sensitivity", "--of", "R.Ry", "--by", "alpha", "-", text=text)
                   for text in self.texts("")]
        for label in ("forward", "backward"):
            derivative, *others = (report["cases"][label]["sensitivity"]["R.Ry"]["by"]["alpha"]["derivative"]
                                   for report in reports)
            self.near(abs(derivative), 1 / 24 / math.cos(math.radians(25))**2, label)
            for other in others:
                self.near(other, derivative, label)

    def table(self, command: str, text: str, *options: str) -> list[dict[str, str]]:
        done = program.plain(command, "--format", "csv", *options, "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return list(csv.DictReader(io.StringIO(done.stdout)))

    def same_rows(self, actual: list[dict[str, str]], expected: list[dict[str, str]]) -> None:
        self.assertEqual(len(actual), len(expected))
        for one, other in zip(actual, expected, strict=True):
            for key, value in other.items():
                try:
                    number = float(value)
                except ValueError:
                    self.assertEqual(one[key], value, key)
                else:
                    self.near(float(one[key]), number, f"{key} in {other}")


ECCENTRIC = """kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies:
  pinion:
  wheel: {mass: 5 kg, centre_of_mass: [60*cos(10 deg) + 50, 60*sin(10 deg)]}
gravity: [0, -10 m/s^2]
couplings:
  a: {type: revolute, bodies: [frame, pinion], at: [0, 0]}
  b: {type: revolute, bodies: [frame, wheel], at: [60*cos(10 deg), 60*sin(10 deg)]}
  m: {type: gear, bodies: [pinion, wheel], at: [20*cos(10 deg), 20*sin(10 deg)],
      tangent: [sin(10 deg), -cos(10 deg)], pressure_angle: 20 deg}
actuators: {in: {coupling: a}, out: {coupling: b}}
loads: {push: {body: pinion, at: [0, 0], force: [-7 N, 0]}}
cases: {run: {motion: {out: 100 rpm}, action: {out: 0}}}
motion: {drive: out, to: 200 deg, steps: STEPS, case: run, report: [a.Rx, reaction]}
"""


class Extremes(ReferenceTest):
    def test_lie_where_the_flank_changes(self) -> None:
        """An eccentric weight of 50 N, 50 mm from the axis, turns with the wheel: no force at 90 deg."""
        most = 50 * 50 / 40 / math.cos(ANGLE)
        for steps in (7, 8, 10, 20, 50):
            motion = program.run("motion", "-", text=ECCENTRIC.replace("STEPS", str(steps)))["motion"]
            found = motion["figures"]
            for name, side, value in (("m/force", "least", 0.0), ("m/force", "greatest", most),
                                      ("a/force", "least", 7.0), ("a.Rx/action", "least", 7.0)):
                self.assertAlmostEqual(found[name][side], value, delta=1e-9, msg=f"{name}, {steps}")


class UnknownFlanks(ReferenceTest):
    def codes(self, mesh: str, sign: float, second: str = "") -> list[str]:
        text = spur(mesh, sign * TORQUE, second=second)
        done = program.call("analyze", "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line.split("[")[1][:5] for line in done.stderr.splitlines() if "warning[" in line]

    def test_are_said_where_they_carry(self) -> None:
        """A positive torque on the pinion pulls at a line along +x."""
        contact = TANGENT + ", contact: true"
        self.assertEqual(self.codes(contact, 1), ["W0610"])
        self.assertEqual(self.codes(contact, -1), [])
        self.assertEqual(self.codes(contact + ", flank: fixed", 1), [])
        self.assertEqual(self.codes(TANGENT, 1), [])


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
