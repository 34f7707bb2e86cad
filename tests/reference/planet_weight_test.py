#!/usr/bin/env python3
"""Weights of gears: on their axes, those of equal planets on that of their carrier, by closed forms.

Usage: planet_weight_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import re
import sys
import unittest
from collections.abc import Callable
from typing import NamedTuple

import program
from slip_test import ravigneaux, up
from swept_case import swept

G = 9.81
MASSES = {"sun": 0.3, "ring": 1.1, "carrier": 0.8, "planet": 0.5}
DIRECTIONS = ((0.0, -G), (-G, 0.0), (G * 0.6, -G * 0.8))


def train(count: int = 3, gravity: tuple[float, ...] = (0.0, -G), planet: str = "", more: str = "",
          bearing: str = "[carrier, planet]", carrier: str = ", carrier: carrier") -> str:
    """A planetary set with its planet drawn at (0, 42 mm), m*(24 + 18)/2."""
    bodies = ", ".join(
        f"{name}: {{mass: {mass}, centre_of_mass: [0, {42 if name == 'planet' else 0}]"
        f"{planet if name == 'planet' else ''}}}" for name, mass in MASSES.items())
    return f"""
kinestat: 1
space: planar
units: {{length: mm}}
gravity: [{', '.join(f'{g} m/s^2' for g in gravity)}]
ground: housing
bodies: {{{bodies}}}
couplings:
  S: {{type: revolute, bodies: [housing, sun]}}
  R: {{type: revolute, bodies: [housing, ring]}}
  C: {{type: revolute, bodies: [housing, carrier]}}
  P: {{type: revolute, bodies: {bearing}}}
gears:
  module: 2 mm
  members:
    sun: {{body: sun, teeth: 24}}
    planet: {{body: planet, teeth: 18, count: {count}}}
    ring: {{body: ring, teeth: 60, internal: true}}
  meshes:
    sp: {{members: [sun, planet]{carrier}}}
    rp: {{members: [ring, planet]{carrier}}}
actuators: {{s: {{coupling: S}}, r: {{coupling: R}}, c: {{coupling: C}}}}
{more or 'cases: {low: {motion: {s: 7 rad/s, r: 0}, action: {s: 0}, input: s, output: c}}'}
"""


def analyze(text: str) -> dict:
    return program.run("analyze", "-", text=text)["cases"]["low"]


def without_centre(text: str, body: str) -> str:
    return re.sub(rf"(\b{body}: {{mass: [0-9.]+), centre_of_mass: \[[^]]*\]", r"\1", text)


class Turning(NamedTuple):
    """Speed and acceleration about z."""
    speed: float
    rate: float

    def acceleration(self, x: float, y: float) -> tuple[float, float]:
        """Of a point there from the axis."""
        return (-self.rate * y - self.speed ** 2 * x, self.rate * x - self.speed ** 2 * y)


def planets_shake(count: int, sun: Turning, ring: Turning,
                  arm: Turning = Turning(0.0, 0.0)) -> list[float]:
    """Force and couple about the origin, each planet in its place; 24, 18 and 60 teeth."""
    def each(of: Callable[[float, float], float]) -> Turning:
        return Turning(*(of(*pair) for pair in zip(sun, ring)))

    carrier = each(lambda s, r: (24 * s + 60 * r) / 84)
    planet = each(lambda s, r: (60 * r - 24 * s) / 36)
    axis = arm.acceleration(0.1, -0.03)
    total = [0.0, 0.0, 0.0]
    for k in range(count):
        angle = 2 * math.pi * k / count

        def turned(x: float, y: float, a: float = angle) -> tuple[float, float]:
            return x * math.cos(a) - y * math.sin(a), x * math.sin(a) + y * math.cos(a)

        pin, off = turned(0.0, 0.042), turned(0.003, 0.005)
        parts = (axis, carrier.acceleration(*pin), planet.acceleration(*off))
        force = [-MASSES["planet"] * sum(part[i] for part in parts) for i in range(2)]
        at = [pin[i] + off[i] for i in range(2)]
        total[0] += force[0]
        total[1] += force[1]
        total[2] += at[0] * force[1] - at[1] * force[0] - 0.0001 * planet.rate
    return total


class PlanetWeights(unittest.TestCase):
    def near(self, actual: float, expected: float, what: object = None) -> None:
        self.assertAlmostEqual(actual, expected, delta=1e-12 * (1 + abs(expected)), msg=str(what))

    def test_no_torque_and_the_whole_weight(self) -> None:
        for count in (2, 3, 5):
            for gravity in DIRECTIONS:
                statics = analyze(train(count, gravity))["statics"]
                what = (count, gravity)
                self.assertEqual(statics["actions"]["c"], 0.0, what)
                self.assertEqual(statics["actions"]["r"], 0.0, what)
                bears = {"S": MASSES["sun"], "R": MASSES["ring"],
                         "C": MASSES["carrier"] + count * MASSES["planet"], "P": 0.0}
                for name, mass in bears.items():
                    force = statics["couplings"][name]["force"]
                    for i in range(2):  # what bears hangs against the weight
                        self.near(force[i], -mass * gravity[i], (name, what))
                total = sum(MASSES.values()) + (count - 1) * MASSES["planet"]
                for i in range(2):
                    sums = sum(statics["couplings"][name]["force"][i] for name in "SRC")
                    self.near(sums, -total * gravity[i], what)

    def test_a_single_planet_weighs_where_it_is(self) -> None:
        """With the sun free and the ring held, the carrier's torque is all that bears it."""
        actions = analyze(train(1, (-G, 0.0)))["statics"]["actions"]
        self.near(abs(actions["c"]), MASSES["planet"] * G * 0.042)

    def test_a_planet_out_of_balance(self) -> None:
        """Three of them, each turned by a third, have their centre on the axis all the same."""
        text = train(3, (-G, 0.0)).replace("centre_of_mass: [0, 42]", "centre_of_mass: [3, 47]")
        statics = analyze(text)["statics"]
        self.assertEqual(statics["actions"]["c"], 0.0)
        self.near(statics["couplings"]["C"]["force"][0], (0.8 + 3 * 0.5) * G)

    def test_planets_that_stand_on_the_ground(self) -> None:
        """The housing bears them: no load of the train."""
        text = train(3, (-G, 0.0), bearing="[housing, planet]", carrier="", more=(
            "cases: {low: {motion: {s: 7 rad/s, c: 0}, action: {s: 0}, input: s, output: r}}"))
        one = analyze(text)
        self.assertEqual(one["statics"]["actions"]["r"], 0.0)
        self.assertEqual(sorted(one["statics"]["loads"]), ["gravity.carrier", "gravity.ring",
                                                           "gravity.sun"])
        self.near(one["statics"]["couplings"]["P"]["force"][0], 0.0)

    def test_gears_without_a_centre_weigh_on_their_axes(self) -> None:
        for gravity in DIRECTIONS:
            text = train(3, gravity)
            for name in ("sun", "ring", "planet"):
                text = without_centre(text, name)
            statics = analyze(text)["statics"]
            self.assertEqual(statics["actions"]["c"], 0.0, gravity)
            bears = {"S": MASSES["sun"], "R": MASSES["ring"],
                     "C": MASSES["carrier"] + 3 * MASSES["planet"]}
            for name, mass in bears.items():
                for i in range(2):
                    self.near(statics["couplings"][name]["force"][i], -mass * gravity[i], gravity)

    def test_a_single_planet_without_a_centre_weighs_at_its_pin(self) -> None:
        actions = analyze(without_centre(train(1, (-G, 0.0)), "planet"))["statics"]["actions"]
        self.near(abs(actions["c"]), MASSES["planet"] * G * 0.042)

    def test_where_along_an_axis_a_gear_hangs(self) -> None:
        """It tells nothing of a weight along the axis; across it, it is asked for."""
        def upright(gravity: tuple[float, ...]) -> str:
            text = train(3, gravity).replace("planar", "spatial")
            for name, at in zip("SRCP", (5, 15, 10, 30)):
                text = text.replace(f"  {name}: {{", f"  {name}: {{at: {at}, axis: z, ")
            text = text.replace("centre_of_mass: [0, 0]", "centre_of_mass: [0, 0, 0]")
            for name in ("sun", "ring", "planet"):
                text = without_centre(text, name)
            return text.replace("carrier: carrier}", "carrier: carrier, at: 30}")

        statics = analyze(upright((0.0, 0.0, -G)))["statics"]
        for name, mass in (("S", 0.3), ("R", 1.1), ("C", 0.8 + 3 * 0.5)):
            self.near(statics["couplings"][name]["force"][2], mass * G, name)
            for moment in statics["couplings"][name]["moment"]:
                self.near(moment, 0.0, name)
        done = program.call("analyze", "-", text=upright((0.0, -G, 0.0)))
        self.assertEqual(done.returncode, 3)
        self.assertEqual(done.stderr.count("E0303"), 3, done.stderr)

    def test_in_space_they_tilt_their_carrier(self) -> None:
        """Planets 30 mm above the origin, a carrier borne at 10 mm: 3 m g times 20 mm."""
        text = train(3, (0.0, -G, 0.0)).replace("planar", "spatial")
        for name, at in zip("SRCP", (5, 15, 10, 30)):
            text = text.replace(f"  {name}: {{", f"  {name}: {{at: {at}, axis: z, ")
        for name in ("sun", "ring", "carrier"):
            text = text.replace(f"{name}: {{mass: {MASSES[name]}, centre_of_mass: [0, 0]",
                                f"{name}: {{mass: 0, centre_of_mass: [0, 0, 0]")
        text = text.replace("centre_of_mass: [0, 42]", "centre_of_mass: [0, 42, 30]")
        text = text.replace("carrier: carrier}", "carrier: carrier, at: 30}")
        statics = analyze(text)["statics"]
        self.assertEqual(statics["actions"]["c"], 0.0)
        carries = statics["couplings"]["C"]
        weight = 3 * MASSES["planet"] * G
        self.near(carries["force"][1], weight)
        # About the bearing: the weight is 20 mm above it, along y.
        self.near(abs(carries["moment"][0]), weight * 0.02)
        self.near(carries["moment"][2], 0.0)

    def test_with_inertia(self) -> None:
        """At constant speed the train turns by itself, in any position."""
        text = train(3, (-G, 0.0), ", inertia: 0.0001", (
            "cases: {low: {motion: {s: 7 rad/s, r: 0}, acceleration: {}, action: {s: 0}, "
            "input: s, output: c}}\n"
            "motion: {drives: [{drive: s}, {drive: r}], time: 1.7 s, steps: 7, "
            "case: low, report: [action]}"))
        motion = program.run("motion", "-", text=text)["motion"]
        titles = [column["name"] for column in motion["columns"]]
        self.assertEqual(len(motion["rows"]), 8)
        for row in motion["rows"]:
            at = dict(zip(titles, row))
            for name in ("c/action", "r/action"):
                self.assertAlmostEqual(at[name], 0.0, delta=1e-12)
            self.near(at["C.Rx/action"] - self.inertia_along_x(at), (0.8 + 3 * 0.5) * G)

    def inertia_along_x(self, at: dict) -> float:
        """What three planets at the place of the one that is drawn pull outwards, 7/3.5 rad/s."""
        angle = math.pi / 2 + at["time"] * 2.0
        return -3 * MASSES["planet"] * 0.042 * 4.0 * math.cos(angle)

    def shaken(self, text: str, of: dict) -> None:
        dynamics = program.run("analyze", "-", text=text)["cases"]["low"]["dynamics"]
        for key in ("shaking", "ground"):
            for i in range(2):
                self.near(dynamics[key][3 + i], of[key][i], (key, i))
            self.near(dynamics[key][2], of[key][2], key)

    def test_planets_shake_where_they_are(self) -> None:
        """The sum over three planets out of balance, each at its place."""
        speeds = "{s: 7 rad/s, r: 0}, acceleration: {s: 3.5 rad/s^2}, action: {s: 0}"
        text = train(3, (-G, 0.5), ", inertia: 0.0001",
                     f"cases: {{low: {{motion: {speeds}, input: s, output: c}}}}")
        text = text.replace("centre_of_mass: [0, 42]", "centre_of_mass: [3, 47]")
        shaking = planets_shake(3, Turning(7.0, 3.5), Turning(0.0, 0.0))
        total = sum(MASSES.values()) + 2 * MASSES["planet"]
        self.shaken(text, {"shaking": shaking, "ground": [shaking[0] - total * G,
                                                          shaking[1] + total * 0.5, shaking[2]]})
        dynamics = program.run("analyze", "-", text=text)["cases"]["low"]["dynamics"]
        self.assertEqual(dynamics["shaking"][3:], [0.0, 0.0, 0.0])

    def test_planets_shake_on_a_train_that_is_carried(self) -> None:
        """The whole train on an arm about (-100, 30) mm, with its case: the axis speeds up, too."""
        arm = Turning(5.0, -8.0)
        speeds = ("{turn: 5 rad/s, s: 7 rad/s, r: 0}, acceleration: {turn: -8 rad/s^2, s: 3.5 "
                  "rad/s^2}, action: {s: 0}")
        text = train(3, (0.0, 0.0), ", inertia: 0.0001",
                     f"cases: {{low: {{motion: {speeds}, input: s, output: c}}}}")
        text = text.replace("centre_of_mass: [0, 42]", "centre_of_mass: [3, 47]")
        text = text.replace("ground: housing", "ground: base").replace(
            "bodies: {", "bodies: {housing: , ").replace(
            "couplings:", "couplings:\n  A: {type: revolute, bodies: [base, housing], "
            "at: [-100, 30]}").replace("actuators: {", "actuators: {turn: {coupling: A}, ")
        shaking = planets_shake(3, Turning(12.0, -4.5), arm, arm)
        rest = sum(MASSES[name] for name in ("sun", "ring", "carrier"))
        force = [-rest * a for a in arm.acceleration(0.1, -0.03)]
        shaking = [shaking[0] + force[0], shaking[1] + force[1], shaking[2]]
        self.shaken(text, {"shaking": shaking, "ground": shaking})

    def test_simulated_they_drive_nothing(self) -> None:
        """The sun begins at 7 rad/s and keeps it; the ring is held."""
        inertia = ", inertia: 0.0001"
        text = train(3, (-G, 0.0), inertia, (
            "simulation: {action: {s: 0, c: 0}, start: {s: {speed: 7 rad/s}}, motion: {r: 0}, "
            "time: 2 s, steps: 4, report: [velocity, action]}"))
        for name in ("sun", "ring", "carrier"):
            text = text.replace("centre_of_mass: [0, 0]}", f"centre_of_mass: [0, 0]{inertia}}}")
        done = program.run("simulate", "-", text=text)["simulation"]
        titles = [column["name"] for column in done["columns"]]
        self.assertEqual(len(done["rows"]), 5)
        for row in done["rows"]:
            at = dict(zip(titles, row))
            self.assertAlmostEqual(at["S.wz/velocity"], 7.0, delta=1e-9)
            self.assertAlmostEqual(at["C.wz/velocity"], 2.0, delta=1e-9)
            self.assertAlmostEqual(at["r/action"], 0.0, delta=1e-9)

    def test_slopes(self) -> None:
        """Towards the mass of one planet, and towards the module, which moves it outwards."""
        text = train(3, (-G, 0.0)).replace("planet: {mass: 0.5", "planet: {mass: mp").replace(
            "module: 2 mm", "module: z").replace("[0, 42]", "[0, 21*z]").replace(
            "space:", "parameters: {mp: 0.5, z: 2}\nspace:")
        found = program.run("sensitivity", "--of", "c", "--of", "C.Rx", "--by", "mp", "--by", "z",
                            "-", text=text)["cases"]["low"]["sensitivity"]
        for value, by, slope in (("c", "mp", 0.0), ("c", "z", 0.0), ("C.Rx", "mp", 3 * G),
                                 ("C.Rx", "z", 0.0)):
            actual = found[value]["by"][by]["derivative"]
            if slope == 0.0:
                self.assertEqual(actual, 0.0, (value, by))
            else:
                self.near(actual, slope, (value, by))

    def test_the_place_on_an_axis_that_moves(self) -> None:
        """A planet at 21 z mm, z being the module: m g 21 mm for every millimetre of it."""
        text = without_centre(train(1, (-G, 0.0)), "planet").replace("module: 2 mm", "module: z")
        text = text.replace("space:", "parameters: {z: 2}\nspace:")
        torque = MASSES["planet"] * G * 0.021
        found = program.run("sensitivity", "--of", "c", "--by", "z", "-", text=text)
        self.near(abs(found["cases"]["low"]["sensitivity"]["c"]["by"]["z"]["derivative"]), torque)
        rows, _ = swept(text, "{vary: {z: [1, 2, 3]}, report: [c]}")
        for row in rows:
            self.near(abs(row["c [N*m]"]), row["z"] * torque)

    def test_swept(self) -> None:
        text = train(3, (-G, 0.0)).replace("planet: {mass: 0.5", "planet: {mass: mp").replace(
            "space:", "parameters: {mp: 0.5}\nspace:")
        rows, _ = swept(text, "{vary: {mp: [0.1, 0.5, 2]}, report: [c, C.Rx]}")
        for row in rows:
            self.assertEqual(row["status"], "solved")
            self.assertEqual(row["c [N*m]"], 0.0)
            self.near(row["C.Rx [N]"], (0.8 + 3 * row["mp"]) * G)

    def test_gears_of_a_shift(self) -> None:
        """The torques of its elements are those without weights, and every way says so."""
        shift = ("shift: {input: s, output: c, elements: [B], input_motion: 7 rad/s, "
                 "input_action: 10 N*m, names: {low: [B]}}")
        text = train(3, (-G, 0.0), more=shift).replace(
            "gears:\n", "  B: {type: brake, bodies: [housing, ring]}\ngears:\n")
        report = program.run("shift", "-", text=text)["shift"]["states"]["low"]
        one = analyze(text)["statics"]["actions"]
        self.near(one["c"], -35.0)
        self.near(one["B"], 25.0)
        self.near(report["elements"]["B"]["torque"], 25.0)

    def test_a_change_of_gear(self) -> None:
        """Weights of planets do nothing while an element slips."""
        text = ravigneaux(up()).replace("{mass: 0.9,", "{")
        heavy = text.replace("{mass: 0.35,", "{mass: 0.35, centre_of_mass: [0, 0.034, 0.03],").replace(
            "ground:", "gravity: [3 m/s^2, -9.81 m/s^2, 1 m/s^2]\nground:", 1)
        slips = [program.run("shift", "-", text=one)["shift"]["slip"]["up"] for one in (text, heavy)]
        self.assertIn("gravity", heavy)
        for key, value in slips[0].items():
            if isinstance(value, float):
                self.assertAlmostEqual(slips[1][key], value, delta=1e-12 * abs(value), msg=key)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
