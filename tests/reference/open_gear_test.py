#!/usr/bin/env python3
"""A gear beside which a planetary set turns freely: what it determines is solved, and the same in
every command; what it leaves open has no value, and a message names it.

Usage: open_gear_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest

import program
from swept_case import swept

# In 'direct' the set on the input shaft carries nothing: carrier and ring turn as they like.
TRAIN = """
kinestat: 1
space: planar
units: {length: mm}
parameters: {a: 20, T: 100 N*m}
ground: housing
bodies: [shaft, idler, wheel, ring, carrier, planet]
couplings:
  I: {type: revolute, bodies: [housing, shaft]}
  J: {type: revolute, bodies: [housing, idler]}
  O: {type: revolute, bodies: [housing, wheel]}
  R: {type: revolute, bodies: [housing, ring]}
  K: {type: revolute, bodies: [housing, carrier]}
  P: {type: revolute, bodies: [carrier, planet]}
  C1: {type: clutch, bodies: [shaft, idler]}
  C2: {type: clutch, bodies: [carrier, idler]}
  B: {type: brake, bodies: [housing, ring]}
gears:
  module: 2 mm
  members:
    sun: {body: shaft, teeth: 24}
    planet: {body: planet, teeth: 18, count: 3}
    ring: {body: ring, teeth: 60, internal: true}
    a: {body: idler, teeth: a}
    b: {body: wheel, teeth: 50}
  meshes:
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
    ab: {members: [a, b]}
actuators: {in: {coupling: I}, out: {coupling: O}}
shift:
  input: in
  output: out
  elements: [C1, C2, B]
  input_motion: 10 rad/s
  input_action: T
  names: {direct: [C1], low: [C2, B]}
"""

KNOWN = {"I.wz": 10.0, "J.wz": 10.0, "O.wz": -4.0, "C1.wz": 0.0}
OPEN = ("R.wz", "K.wz", "P.wz", "C2.wz", "B.wz")


class OpenGear(unittest.TestCase):
    def test_every_command_says_the_same(self) -> None:
        done = program.call("analyze", "-", text=TRAIN)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = program.report(done)
        one = report["cases"]["direct"]
        freedoms = one["kinematics"]["freedoms"]
        for name, rate in KNOWN.items():
            self.assertAlmostEqual(freedoms[name], rate, delta=1e-13)
        for name in OPEN:
            self.assertIsNone(freedoms[name], name)
        gear = report["shift"]["states"]["direct"]
        self.assertAlmostEqual(one["ratio"], -2.5, delta=1e-14)
        self.assertEqual(gear["ratio"], one["ratio"])
        self.assertAlmostEqual(one["torque_ratio"], 0.4, delta=1e-14)
        actions = one["statics"]["actions"]
        self.assertAlmostEqual(actions["out"], 250.0, delta=1e-11)
        self.assertAlmostEqual(abs(actions["C1"]), 100.0, delta=1e-11)
        self.assertEqual((actions["C2"], actions["B"]), (0.0, 0.0))
        self.assertEqual({name: one["slip"] for name, one in gear["elements"].items()},
                         {"C1": 0.0, "C2": None, "B": None})
        self.assertIn("besides, one freedom remains, moving ring, carrier, planet", gear["reason"])
        self.assertIn("W0506", done.stderr)
        self.assertIn("gear 'direct' leaves the speed of 'ring', 'carrier', 'planet' open",
                      done.stderr)
        low = report["cases"]["low"]
        self.assertAlmostEqual(low["ratio"], -8.75, delta=1e-13)
        self.assertNotIn("'low'", done.stderr)

    def test_shift_says_it_too(self) -> None:
        done = program.call("shift", "-", text=TRAIN)
        self.assertAlmostEqual(program.report(done)["shift"]["states"]["direct"]["ratio"], -2.5,
                               delta=1e-14)
        self.assertIn("W0506", done.stderr)

    def test_swept(self) -> None:
        rows, _ = swept(TRAIN, "{vary: {a: [20, 25, 40]}, cases: [direct, low], "
                               "report: [ratio, O.wz, out]}")
        self.assertEqual(len(rows), 6)
        for row in rows:
            ratio = -50 / row["a"] * (3.5 if row["case"] == "low" else 1.0)
            self.assertEqual(row["status"], "solved")
            self.assertAlmostEqual(row["ratio"], ratio, delta=1e-13)
            self.assertAlmostEqual(row["O.wz [rad/s]"], 10 / ratio, delta=1e-13)
            self.assertAlmostEqual(row["out [N*m]"], -100 * ratio, delta=1e-10)
        rows, _ = swept(TRAIN, "{vary: {a: [20]}, cases: [direct], report: [ratio, R.wz]}")
        self.assertIsNone(rows[0]["R.wz [rad/s]"])
        self.assertAlmostEqual(rows[0]["ratio"], -2.5, delta=1e-14)

    def test_inertia_that_turns_freely(self) -> None:
        """The input feels what is determined, and of the rest nobody knows."""
        text = TRAIN.replace("[shaft, idler, wheel, ring,",
                             "{shaft: {inertia: 0.1}, idler: {inertia: 0.2}, wheel: {inertia: 0.5}, "
                             "ring:").replace("ring: carrier, planet]",
                                              "ring: , carrier: , planet: }")
        states = program.run("shift", "-", text=text)["shift"]["states"]
        self.assertAlmostEqual(states["direct"]["equivalent_inertia"], 0.1 + 0.2 + 0.5 * 0.16,
                               delta=1e-14)
        text = text.replace("ring: ,", "ring: {inertia: 0.3},")
        states = program.run("shift", "-", text=text)["shift"]["states"]
        self.assertIsNone(states["direct"].get("equivalent_inertia"))

    def test_limits_of_what_turns_freely(self) -> None:
        """The shaft turns at 10 and the wheel at 4 rad/s, ring, carrier and planets as they like."""
        text = TRAIN.replace("  input_action: T\n",
                             "  input_action: T\n  limits: {speed: 5 rad/s, planet_speed: 1 rad/s}\n")
        text += "duty: {points: [{case: direct, duration: 1}]}\n"
        done = program.call("shift", "-", text=text)
        state = program.report(done)["shift"]["states"]["direct"]
        self.assertAlmostEqual(state["limits"]["speed.shaft"]["use"], 2.0)
        self.assertAlmostEqual(state["limits"]["speed.wheel"]["use"], 0.8)
        for name in ("speed.ring", "speed.carrier", "planet_speed.planet"):
            self.assertIsNone(state["limits"][name]["use"], name)
            self.assertIsNone(state["limits"][name]["speed"], name)
        self.assertAlmostEqual(state["limit_use"], 2.0)  # what nobody knows uses nothing
        rows, _ = swept(text, "{vary: {a: [20, 25]}, cases: [direct], report: [limit_use]}")
        for row in rows:
            self.assertAlmostEqual(row["limit_use"], 2.0)
        for stderr in (done.stderr, program.call("duty", "-", text=text).stderr):
            of_direct = [line for line in stderr.splitlines()
                         if "W0712" in line and "gear 'direct'" in line]
            self.assertEqual(len(of_direct), 2, stderr)
            self.assertIn("body 'shaft' turns at 10 rad/s", of_direct[0])
            self.assertIn("body 'idler' turns at 10 rad/s", of_direct[1])

    def test_in_a_duty(self) -> None:
        """Energies are those of the gear; nobody knows how often the rest turns."""
        text = TRAIN + "duty: {gear_exponent: 6, points: [{case: direct, duration: 5 s}]}\n"
        duty = program.run("duty", "-", text=text)["duty"]
        self.assertAlmostEqual(duty["given"], 100 * 10 * 5, delta=1e-9)
        self.assertAlmostEqual(duty["taken"], 100 * 10 * 5, delta=1e-9)
        turns = {name: one["revolutions"] for name, one in duty["bearings"].items()}
        self.assertAlmostEqual(turns["I"], 50 / (2 * math.pi), delta=1e-12)
        self.assertAlmostEqual(turns["O"], 20 / (2 * math.pi), delta=1e-12)
        self.assertEqual({turns[name] for name in ("R", "K", "P")}, {None})
        gears = {name: one["revolutions"] for name, one in duty["gears"].items()}
        self.assertEqual((gears["sp.shaft"], gears["rp.planet"]), (None, None))
        self.assertAlmostEqual(gears["ab.wheel"], 20 / (2 * math.pi), delta=1e-12)

    def test_drag_on_what_turns_freely(self) -> None:
        """It changes no speed that is determined, and nobody knows its sense."""
        for where, drag in (("R: {type: revolute, bodies: [housing, ring]", "{tau: 1 N*m}"),
                            ("K: {type: revolute, bodies: [housing, carrier]", "{c: 1}"),
                            ("C2: {type: clutch, bodies: [carrier, idler]", "{tau: 1 N*m}")):
            text = TRAIN.replace(where, f"{where}, friction: {drag}")
            self.assertNotEqual(text, TRAIN)
            done = program.call("analyze", "-", text=text)
            self.assertEqual(done.returncode, 5, done.stderr)
            self.assertNotIn("E0501", done.stderr)
            self.assertEqual(done.stderr.count("E0606"), 1, done.stderr)
            report = program.report(done)
            one = report["cases"]["direct"]
            for name, rate in KNOWN.items():
                self.assertAlmostEqual(one["kinematics"]["freedoms"][name], rate, delta=1e-13)
            for name in OPEN:
                self.assertIsNone(one["kinematics"]["freedoms"][name], name)
            self.assertAlmostEqual(one["ratio"], -2.5, delta=1e-14)
            self.assertIsNone(one["torque_ratio"])
            self.assertEqual(one["statics"]["status"], "at_rest")
            shift = program.call("shift", "-", text=text)
            self.assertEqual(shift.returncode, 5)
            self.assertEqual(shift.stderr, done.stderr)
            gear = program.report(shift)["shift"]["states"]["direct"]
            self.assertEqual(gear, report["shift"]["states"]["direct"])
            self.assertEqual(gear["ratio"], one["ratio"])

    def test_drag_on_what_is_determined(self) -> None:
        """Beside what turns freely it counts: 2 N*m at the idler."""
        text = TRAIN.replace("J: {type: revolute, bodies: [housing, idler]",
                             "J: {type: revolute, bodies: [housing, idler], friction: {tau: 2 N*m}")
        one = program.run("analyze", "-", text=text)["cases"]["direct"]
        self.assertAlmostEqual(one["statics"]["actions"]["out"], 245.0, delta=1e-11)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
