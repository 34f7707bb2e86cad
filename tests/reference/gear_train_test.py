#!/usr/bin/env python3
"""Gear trains of the section `gears` against hand-written ones, Willis and closed forms.

Usage: gear_train_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math
import random
import re
import sys
import unittest
from fractions import Fraction
from pathlib import Path

import yaml

import program
from reference_test_case import ReferenceTest

MECHANISMS = Path()


def planetary(sun: object, planet: object, ring: object, head: str = "", gears: str = "",
              space: str = "planar", tail: str = "") -> str:
    """A simple set; in space bearings are on z at 1, 2, 3 and 4."""
    where = [f", at: {i}, axis: z" if space == "spatial" else "" for i in range(1, 5)]
    return f"""\
kinestat: 1
space: {space}
{head}ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  S: {{type: revolute, bodies: [housing, sun]{where[0]}}}
  R: {{type: revolute, bodies: [housing, ring]{where[1]}}}
  C: {{type: revolute, bodies: [housing, carrier]{where[2]}}}
  P: {{type: revolute, bodies: [carrier, planet]{where[3]}}}
gears:
  module: 2
{gears}  members:
    sun: {{body: sun, teeth: {sun}}}
    planet: {{body: planet, teeth: {planet}}}
    ring: {{body: ring, teeth: {ring}, internal: true}}
  meshes:
    sp: {{members: [sun, planet], carrier: carrier}}
    rp: {{members: [ring, planet], carrier: carrier}}
actuators: {{s: {{coupling: S}}, r: {{coupling: R}}, c: {{coupling: C}}}}
cases:
  ring held: {{motion: {{s: 1, r: 0}}, action: {{s: 1}}, input: s, output: c}}
  carrier held: {{motion: {{s: 1, c: 0}}, action: {{s: 1}}, input: s, output: r}}
  sun held: {{motion: {{r: 1, s: 0}}, action: {{r: 1}}, input: r, output: c}}
  reverse load: {{motion: {{s: 1, r: 0}}, action: {{s: -1}}, input: s, output: c}}
{tail}"""


def analyze(text: str) -> dict:
    return program.run("analyze", "-", text=text)


def couplings(report: dict) -> dict[str, dict]:
    return {one["name"]: one for one in report["graph"]["couplings"]}


class RavigneauxInTeeth(ReferenceTest):
    """ravigneaux_teeth.yaml says in teeth what ravigneaux.yaml says in coordinates."""

    def setUp(self) -> None:
        folder = MECHANISMS / "transmissions"
        self.by_hand = program.run("analyze", str(folder / "ravigneaux.yaml"))
        self.in_teeth = program.run("analyze", str(folder / "ravigneaux_teeth.yaml"))

    def numbers(self, value: object, path: str = "") -> dict[str, float]:
        if isinstance(value, dict):
            return {k: v for key, one in value.items()
                    for k, v in self.numbers(one, f"{path}/{key}").items()}
        if isinstance(value, list):
            return {k: v for i, one in enumerate(value)
                    for k, v in self.numbers(one, f"{path}/{i}").items()}
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        return {path: float(value)} if is_number else {}

    def test_has_the_same_report(self) -> None:
        for part in ("mobility", "cases"):
            by_hand = self.numbers(self.by_hand[part])
            in_teeth = self.numbers(self.in_teeth[part])
            for numbers in (by_hand, in_teeth):
                for path in [p for p in numbers if "evidence" in p or "residual" in p]:
                    del numbers[path]
            self.assertEqual(by_hand.keys(), in_teeth.keys())
            self.assertGreater(len(by_hand), 20)
            for path, value in by_hand.items():
                largest = max(abs(v) for p, v in by_hand.items()
                              if p.split("/")[:4] == path.split("/")[:4])
                self.near(in_teeth[path] / max(1.0, largest), value / max(1.0, largest), path)

    def test_has_the_same_couplings(self) -> None:
        by_hand, in_teeth = couplings(self.by_hand), couplings(self.in_teeth)
        self.assertEqual(list(by_hand), list(in_teeth))
        for name, one in by_hand.items():
            for a, b in zip(one["at"], in_teeth[name]["at"]):
                self.near(b, a, name, 100.0)


class Willis(ReferenceTest):
    """Simple sets with random teeth: i = 1 + R/S, -R/S and 1 + S/R, whatever the planet."""

    def test_random_trains(self) -> None:
        seed = 20080417
        numbers = random.Random(seed)
        for i in range(40):
            sun, planet = numbers.randint(12, 90), numbers.randint(12, 60)
            ring = sun + 2 * planet + numbers.choice([0, 0, 0, 1, -1, 2])
            with self.subTest(seed=seed, train=i, teeth=(sun, planet, ring)):
                cases = analyze(planetary(sun, planet, ring))["cases"]
                self.near_each({k: cases[k]["ratio"] for k in ("ring held", "carrier held", "sun held")},
                               {"ring held": 1 + ring / sun,
                                "carrier held": -ring / sun,
                                "sun held": 1 + sun / ring})

    def test_bounds_cover_the_error(self) -> None:
        """Of the numbers as typed: doubles do not hold the directions of teeth."""
        numbers = random.Random(19630301)
        for _ in range(10):
            sun, planet = numbers.randint(12, 90), numbers.randint(12, 60)
            ring = sun + 2 * planet
            cases = program.run("analyze", "--accuracy", "exact", "-",
                                text=planetary(sun, planet, ring))["cases"]
            for label, exact in (("ring held", 1 + Fraction(ring, sun)),
                                 ("carrier held", -Fraction(ring, sun)),
                                 ("sun held", 1 + Fraction(sun, ring))):
                one = cases[label]
                bounds = one["evidence"]
                self.covers(one["ratio"], bounds["ratio_error_bound"], exact)
                self.covers(one["torque_ratio"], bounds["torque_ratio_error_bound"], -1 / exact)
                self.assertLess(one["power"]["evidence"]["error_bound"], 1e-12)

    def covers(self, value: float, bound: float, exact: Fraction) -> None:
        error = abs(Fraction(value) - exact)
        self.assertLessEqual(error, Fraction(bound) * abs(Fraction(value)))
        self.assertLess(bound, 1e-12)

    def test_random_stepped_trains(self) -> None:
        """Carrier held: -R p1/(S p2), with p1 on the sun and p2 in the ring."""
        seed = 19120101
        numbers = random.Random(seed)
        for i in range(20):
            sun, first, second = (numbers.randint(14, 60) for _ in range(3))
            ring = sun + first + second
            text = planetary(sun, first, ring)
            text = text.replace("    ring: {", f"    step: {{body: planet, teeth: {second}}}\n    ring: {{")
            text = text.replace("[ring, planet], carrier", "[ring, step], carrier")
            with self.subTest(seed=seed, train=i, teeth=(sun, first, second, ring)):
                cases = analyze(text)["cases"]
                self.near_each({"": cases["carrier held"]["ratio"]},
                               {"": -ring * first / (sun * second)})


class Places(ReferenceTest):
    def test_of_a_set_in_space(self) -> None:
        """Module 2: the planet at 24 + 18, the pitch points at 24 and 60 on y, positions on z kept."""
        found = couplings(analyze(planetary(24, 18, 60, space="spatial")))
        for name, point in {"S": [0, 0, 1], "R": [0, 0, 2], "C": [0, 0, 3], "P": [0, 42, 4],
                            "sp": [0, 24, 0], "rp": [0, 60, 0]}.items():
            for actual, expected in zip(found[name]["at"], point):
                self.near(actual, expected, name)

    def test_of_a_countershaft(self) -> None:
        """Two gears on the main axis and a shaft with two beside them, all on the ground."""
        report = analyze("""\
kinestat: 1
space: planar
ground: housing
bodies: [in, out, counter]
couplings:
  I: {type: revolute, bodies: [housing, in]}
  O: {type: revolute, bodies: [housing, out]}
  L: {type: revolute, bodies: [housing, counter]}
gears:
  module: 2
  members:
    a: {body: in, teeth: 20}
    b: {body: counter, teeth: 40}
    c: {body: counter, teeth: 25}
    d: {body: out, teeth: 35}
  meshes:
    ab: {members: [a, b]}
    cd: {members: [c, d]}
actuators: {i: {coupling: I}, o: {coupling: O}}
cases: {turning: {motion: {i: 1}, action: {i: 1}, input: i, output: o}}
""")
        self.near(report["cases"]["turning"]["ratio"], 40 / 20 * 35 / 25, "ratio")
        for actual, expected in zip(couplings(report)["L"]["at"], [0, 60]):
            self.near(actual, expected, "L")


class Derivatives(ReferenceTest):
    def test_by_numbers_of_teeth_there_is_none(self) -> None:
        """Teeth are whole, in whatever expression; --set refuses others."""
        head = "parameters: {zs: 24, zp: (zr - zs)/2, zr: 60, size: 2}\n"
        text = planetary("zs", "zp", "zr", head).replace("module: 2", "module: size")
        report = program.run("sensitivity", "--of", "ratio", "-", text=text)
        by = report["cases"]["ring held"]["sensitivity"]["ratio"]["by"]
        self.assertEqual({name: by[name]["derivative"] for name in by},
                         {"zs": None, "zp": None, "zr": None, "size": 0.0})
        for change in ("zs=24.001", "zr=60.001"):
            self.assertNotEqual(program.call("analyze", "--set", change, "-", text=text).returncode, 0)

    def test_of_planets_in_line(self) -> None:
        """Their flat triangle has no derivative, yet they stay in line: torques do not depend on the
        module, forces go with 1/module."""
        path = str(MECHANISMS / "transmissions" / "ravigneaux_teeth.yaml")
        report = program.run("sensitivity", "--case", "M1", "--of", "out", "--of", "i.Rc", path)
        values = report["cases"]["M1"]["sensitivity"]
        self.near(values["out"]["by"]["module"]["derivative"], 0.0, "out")
        self.near(values["i.Rc"]["by"]["module"]["derivative"], -values["i.Rc"]["value"], "i.Rc",
                  abs(values["i.Rc"]["value"]))

    def test_of_forces_on_turned_flanks(self) -> None:
        """The bearing of the ring bears tan(α) times the tangential force, on either flank."""
        head = "parameters: {zs: 24, alpha: 25 deg}\n"
        text = planetary("zs", 18, 60, head, "  pressure_angle: alpha\n")
        report = program.run("sensitivity", "--of", "R.Ry", "--by", "alpha", "-", text=text)
        expected = 1 / 24 / math.cos(math.radians(25))**2
        for label in ("ring held", "reverse load"):
            by = report["cases"][label]["sensitivity"]["R.Ry"]["by"]["alpha"]
            self.near(abs(by["derivative"]), expected, label)


class Flanks(ReferenceTest):
    """Sun torque 1 N·m on a pitch radius of 24 m, 25 degrees."""

    TANGENTIAL = 1 / 24
    ANGLE = "  pressure_angle: 25 deg\n"

    def radial(self, gears: str, label: str, space: str = "planar") -> tuple[float, float]:
        """The force on sun and ring along the line of centres, through their bearings."""
        report = analyze(planetary(24, 18, 60, "", gears, space))
        actions = report["cases"][label]["statics"]["actions"]
        return -actions["S.Ry"], -actions["R.Ry"]

    def test_loaded_teeth_push_apart(self) -> None:
        """The sun away from the planet above it, the ring away from the planet below its teeth."""
        radial = self.TANGENTIAL * math.tan(math.radians(25))
        for label in ("ring held", "reverse load"):
            for space in ("planar", "spatial"):
                sun, ring = self.radial(self.ANGLE, label, space)
                self.near(sun, -radial, f"{label} {space}: sun")
                self.near(ring, radial, f"{label} {space}: ring")

    def test_fixed_flanks_keep_their_line(self) -> None:
        radial = self.TANGENTIAL * math.tan(math.radians(25))
        fixed = self.ANGLE + "  flank: fixed\n"
        forward, _ = self.radial(fixed, "ring held")
        backward, _ = self.radial(fixed, "reverse load")
        self.near(abs(forward), radial, "forward")
        self.near(backward, -forward, "backward")

    def test_a_planet_between_helical_gears_bears_no_thrust(self) -> None:
        """Sun and ring push the planet along the axis, against each other; 15 degrees."""
        gears = self.ANGLE + "  helix_angle: 15 deg\n"
        thrust = self.TANGENTIAL * math.tan(math.radians(15))
        report = analyze(planetary(24, 18, 60, "", gears, "spatial"))
        actions = report["cases"]["ring held"]["statics"]["actions"]
        self.near(actions["P.Rz"], 0.0, "planet")
        self.near(abs(actions["S.Rz"]), thrust, "sun")
        self.near(actions["S.Rz"] + actions["R.Rz"], 0.0, "sun and ring")


class NormalAngle(ReferenceTest):
    """20 degrees across teeth at a helix of 30: tan(at) = tan(20 deg)/cos(30 deg)."""

    HELIX = "  helix_angle: 30 deg\n"
    NORMAL = "  normal_pressure_angle: 20 deg\n"

    def loads(self, gears: str, tail: str = "") -> dict[str, float]:
        text = planetary(24, 18, 60, "", gears, "spatial")
        if tail:
            text = text.replace("sp: {members: [sun, planet], ", f"sp: {{members: [sun, planet], {tail}, ")
        return analyze(text)["cases"]["ring held"]["statics"]["actions"]

    def test_axial_and_radial_force_of_the_sun(self) -> None:
        """Of the tangential force 1/24: tan(helix) and tan(20 deg)/cos(helix) of it; the teeth bear
        1/(cos(20 deg) cos(helix))."""
        actions = self.loads(self.HELIX + self.NORMAL)
        helix, normal = math.radians(30), math.radians(20)
        self.near(abs(actions["S.Rz"]), math.tan(helix) / 24, "axial")
        self.near(abs(actions["S.Ry"]), math.tan(normal) / math.cos(helix) / 24, "radial")
        self.near(abs(actions["sp.Rc"]), 1 / (math.cos(normal) * math.cos(helix)) / 24, "teeth")

    def test_is_the_transverse_angle_in_another_plane(self) -> None:
        transverse = math.degrees(math.atan(math.tan(math.radians(20)) / math.cos(math.radians(30))))
        by_normal = self.loads(self.HELIX + self.NORMAL)
        by_transverse = self.loads(self.HELIX + f"  pressure_angle: {transverse!r} deg\n")
        for name, value in by_transverse.items():
            self.near(by_normal[name], value, name, 1 / 24)

    def test_of_one_mesh(self) -> None:
        """Its own angle, of whichever plane, counts instead of that of the section."""
        actions = self.loads(self.HELIX + self.NORMAL, "pressure_angle: 25 deg")
        self.near(abs(actions["S.Ry"]), math.tan(math.radians(25)) / 24, "of the mesh")
        self.near(abs(actions["R.Ry"]), math.tan(math.radians(20)) / math.cos(math.radians(30)) / 24,
                  "of the section")

    def test_is_that_of_spur_gears_without_a_helix(self) -> None:
        text = planetary(24, 18, 60, "", self.NORMAL)
        actions = analyze(text)["cases"]["ring held"]["statics"]["actions"]
        self.near(abs(actions["S.Ry"]), math.tan(math.radians(20)) / 24, "radial")


class PlanetLoads(ReferenceTest):
    """Three planets share what one has in their place."""

    def test_of_each_planet(self) -> None:
        alone = analyze(planetary(24, 18, 60))["cases"]["ring held"]["statics"]
        text = planetary(24, 18, 60).replace("teeth: 18}", "teeth: 18, count: 3}")
        shared = analyze(text)["cases"]["ring held"]["statics"]
        self.assertNotIn("planets", alone)
        self.assertEqual(shared["actions"], alone["actions"])
        self.assertEqual(set(shared["planets"]), {"P.Rx", "P.Ry", "sp.Rc", "rp.Rc"})
        for name, one in shared["planets"].items():
            self.assertEqual(one["count"], 3)
            self.near(one["each"], alone["actions"][name] / 3, name)
        # 1 N·m of the sun on a pitch radius of 24 m.
        force = 1 / 24 / math.cos(math.radians(20)) / 3
        self.near(abs(shared["planets"]["sp.Rc"]["each"]), force, "sp.Rc")
        self.assertNotIn("most_loaded", shared["planets"]["sp.Rc"])

    def test_of_planets_that_do_not_share_evenly(self) -> None:
        """The most loaded bears 1.2/3; what all have together, and torques, stay."""
        text = planetary(24, 18, 60).replace("teeth: 18}", "teeth: 18, count: 3, load_sharing: 1.2}")
        evenly = analyze(planetary(24, 18, 60))["cases"]["ring held"]["statics"]
        uneven = analyze(text)["cases"]["ring held"]["statics"]
        self.assertEqual(uneven["actions"], evenly["actions"])
        force = 1 / 24 / math.cos(math.radians(20))
        self.near(abs(uneven["planets"]["sp.Rc"]["each"]), force / 3, "each")
        self.near(abs(uneven["planets"]["sp.Rc"]["most_loaded"]), force * 1.2 / 3, "most loaded")
        # The bearing of the planet has both tangential forces.
        self.near(abs(uneven["planets"]["P.Rx"]["most_loaded"]), 2 / 24 * 1.2 / 3, "P.Rx")

    def test_raises_the_most_loaded_of_a_shift_table(self) -> None:
        shift = "shift: {input: s, output: c, elements: B, input_action: 1, names: {low: [B]}}\n"
        text = planetary(24, 18, 60).replace(
            "gears:\n", "  B: {type: brake, bodies: [housing, ring]}\ngears:\n").replace(
            "r: {coupling: R}, ", "")
        text = text[:text.index("cases:")] + shift
        for sharing in (1.0, 1.2):
            shared = text.replace("teeth: 18}", f"teeth: 18, count: 3, load_sharing: {sharing}}}")
            state = program.run("shift", "-", text=shared)["shift"]["states"]["low"]
            self.assertEqual(state["worst_bearing"]["coupling"], "P")
            self.near(state["worst_bearing"]["force"], 2 / 24 * sharing / 3, "bearing")
            self.near(state["worst_mesh"]["force"],
                      1 / 24 / math.cos(math.radians(20)) * sharing / 3, "mesh")
            self.near(abs(state["elements"]["B"]["torque"]), 60 / 24, "brake")


class Exactly:
    """The speeds of a file in fractions: Willis of each mesh, what cases hold and drive."""

    def __init__(self, path: Path) -> None:
        self.file = yaml.safe_load(path.read_text(encoding="utf-8"))
        self.bodies = [*self.file["bodies"]]
        given = self.file.get("parameters", {})
        self.numbers = {name: Fraction(value) if isinstance(value, int) else Fraction(1)
                        for name, value in given.items()}

    def number(self, text: object) -> Fraction:
        """Of speeds the unit drops out of ratios."""
        text = str(text).removesuffix(" rpm")
        return Fraction(eval(text, {"__builtins__": {}}, self.numbers))

    def row(self, *terms: tuple[str, Fraction]) -> list[Fraction]:
        row = [Fraction(0)] * (len(self.bodies) + 1)
        for body, factor in terms:
            if body in self.bodies:
                row[self.bodies.index(body)] += factor
        return row

    def meshes(self) -> list[list[Fraction]]:
        members, rows = self.file["gears"]["members"], []
        for mesh in self.file["gears"]["meshes"].values():
            gears = [members[name] for name in mesh["members"]]
            teeth = [self.number(one["teeth"]) * (-1 if one.get("internal") else 1) for one in gears]
            rows.append(self.row((gears[0]["body"], teeth[0]), (gears[1]["body"], teeth[1]),
                                 (mesh.get("carrier", ""), -sum(teeth))))
        return rows

    def turning(self, name: str) -> list[Fraction]:
        """The turning of a coupling, head less tail; of an actuator, that of its coupling."""
        name = self.file["actuators"].get(name, {"coupling": name})["coupling"]
        tail, head = self.file["couplings"][name]["bodies"]
        return self.row((head, Fraction(1)), (tail, Fraction(-1)))

    def cases(self) -> dict[str, dict]:
        """Those of the file, and its labelled gears: engaged elements do not slip."""
        cases, shift = dict(self.file.get("cases", {})), self.file.get("shift")
        for label, engaged in (shift["names"] if shift else {}).items():
            held = dict.fromkeys(engaged, 0)
            if isinstance(shift["input"], list):
                continue  # each with a speed of its own
            cases[label] = {"motion": {shift["input"]: 1, **held},
                            "input": shift["input"], "output": shift["output"]}
        return cases

    def ratio(self, case: dict) -> Fraction:
        rows = self.meshes()
        for name, value in case["motion"].items():
            rows.append(self.turning(name))
            rows[-1][-1] = self.number(value)
        speeds = solve(rows)
        turning = [sum(a * b for a, b in zip(self.turning(case[end]), speeds))
                   for end in ("input", "output")]
        return turning[0] / turning[1]


def solve(rows: list[list[Fraction]]) -> list[Fraction]:
    """Gauss and Jordan; the speeds that a case leaves open count as zero."""
    size, begin = len(rows[0]) - 1, 0
    pivots = {}
    for column in range(size):
        at = next((i for i in range(begin, len(rows)) if rows[i][column]), None)
        if at is None:
            continue
        rows[begin], rows[at] = rows[at], rows[begin]
        rows[begin] = [x / rows[begin][column] for x in rows[begin]]
        for i, row in enumerate(rows):
            if i != begin and row[column]:
                rows[i] = [x - row[column] * y for x, y in zip(row, rows[begin])]
        pivots[column], begin = begin, begin + 1
    assert all(not any(row) for row in rows[begin:]), "the case contradicts itself"
    return [rows[pivots[c]][-1] if c in pivots else Fraction(0) for c in range(size)]


class Fractions(ReferenceTest):
    """Every ratio of the library whose file is in teeth."""

    # What the sources print as fractions, by file and case.
    PRINTED = {
        "simpson_4hp22": ["181/73", "108/73", "1", "83/114", "-73/35"],
        "lepelletier_6hp26": ["9180/2201", "211140/90241", "108/71", "9180/8033", "4590/5293",
                              "85/123", "-4590/1349"],
        "zf_8hp70": ["108/23", "72/23", "162/77", "5/3", "8826/6871", "1", "120/143", "2/3",
                     "-1744/529"],
    }

    def test_ratios(self) -> None:
        compared = 0
        for path in sorted(MECHANISMS.glob("transmissions/*.yaml")):
            if not re.search(r"^gears:", path.read_text(encoding="utf-8"), re.MULTILINE):
                continue
            exactly = Exactly(path)
            reported = program.run("analyze", str(path))["cases"]
            found = {label: exactly.ratio(case) for label, case in exactly.cases().items()
                     if isinstance(case.get("input"), str) and isinstance(case.get("output"), str)
                     and converter_efficiency(reported[str(label)]) is None}
            for label, ratio in found.items():
                with self.subTest(path.name, gear=label):
                    self.near_each({"": reported[str(label)]["ratio"]}, {"": float(ratio)})
            printed = self.PRINTED.get(path.stem)
            if printed:
                self.assertEqual([*found.values()], [Fraction(one) for one in printed], path.name)
            compared += len(found)
        self.assertGreater(compared, 40)


def converter_efficiency(case: dict) -> float | None:
    """Of a torque converter through which a fluid flows; None without one."""
    for one in case.get("statics", {}).get("converters", {}).values():
        return one["efficiency"]
    return None


class Gearboxes(ReferenceTest):
    """Every gear of every transmission of the library loses nothing."""

    def test_power_balance(self) -> None:
        compared = 0
        for path in sorted(MECHANISMS.glob("transmissions/*.yaml")):
            for label, case in program.run("analyze", str(path))["cases"].items():
                if label == "jacked up":  # asks for speeds alone
                    continue
                with self.subTest(path.name, gear=label):
                    self.assertLess(abs(case["power"]["balance_residual"]), 1e-9)
                    compared += 1
                    if "ratio" in case and isinstance(case["ratio"], float):
                        lost = converter_efficiency(case) or 1.0
                        self.near(case["ratio"] * case["torque_ratio"] * lost, -1.0, label)
        self.assertGreater(compared, 60)


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
