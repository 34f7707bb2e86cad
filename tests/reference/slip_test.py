#!/usr/bin/env python3
"""Changes of gear in which one element slips: two flywheels, and the Ravigneaux transmission by
Willis' equations and energies in fractions, held against the cases of dynamics.json as well.

Usage: slip_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import re
import sys
import unittest
from fractions import Fraction as F

import program
from dynamics_case import CASES, DynamicsCase


def flywheels(slip: str) -> str:
    section = f"shift: {{input: in, output: out, elements: [C], slip: {{start: {slip}}}}}\n"
    return re.sub(r"cases:.*\n", section, CASES["two_flywheels"]["yaml"])


def ravigneaux(slip: str) -> str:
    return re.sub(r"^shift:.*$",
                  "shift: {input: in, output: out, elements: [C1, C2, B1, B2], names: {M1: [C1, B2], "
                  f"M2: [C1, B1], M3: [C1, C2], MR: [C2, B2]}}, slip: {{up: {slip}}}}}",
                  CASES["shift_slip"]["yaml"], flags=re.M)


def paired_planets(speed: float) -> str:
    """Two sets with paired planets, one of which has mass."""
    return f"""kinestat: 1
space: planar
units: {{length: mm}}
ground: housing
bodies: {{S0: {{inertia: 0.001}}, S1: {{inertia: 0.001}}, S2: {{inertia: 0.001}}, S3: {{inertia: 0.001}},
  p0: {{inertia: 0.001}}, q0: {{inertia: 0.001}}, p1: {{inertia: 0.001}}, q1: {{inertia: 0.001, mass: 0.799}}}}
couplings:
  P0: {{type: revolute, bodies: [S0, p0]}}
  Q0: {{type: revolute, bodies: [S0, q0]}}
  P1: {{type: revolute, bodies: [S1, p1]}}
  Q1: {{type: revolute, bodies: [S1, q1]}}
  JS0: {{type: revolute, bodies: [housing, S0]}}
  JS1: {{type: revolute, bodies: [housing, S1]}}
  JS2: {{type: revolute, bodies: [housing, S2]}}
  JS3: {{type: revolute, bodies: [housing, S3]}}
  E0: {{type: brake, bodies: [housing, S3]}}
  E1: {{type: clutch, bodies: [S2, S1]}}
gears:
  module: 2 mm
  members:
    s0: {{body: S3, teeth: 45}}
    p0: {{body: p0, teeth: 40, count: 3}}
    q0: {{body: q0, teeth: 33, count: 3}}
    r0: {{body: S1, teeth: 174, internal: true}}
    s1: {{body: S2, teeth: 35}}
    p1: {{body: p1, teeth: 29}}
    q1: {{body: q1, teeth: 22}}
    r1: {{body: S3, teeth: 132, internal: true}}
  meshes:
    sp0: {{members: [s0, p0], carrier: S0}}
    pq0: {{members: [p0, q0], carrier: S0}}
    rq0: {{members: [r0, q0], carrier: S0}}
    sp1: {{members: [s1, p1], carrier: S1}}
    pq1: {{members: [p1, q1], carrier: S1}}
    rq1: {{members: [r1, q1], carrier: S1}}
actuators: {{in: {{coupling: JS0}}, out: {{coupling: JS2}}}}
shift:
  input: in
  output: out
  elements: [E0, E1]
  input_motion: -214.66 rad/s
  input_action: 35.58 N*m
  slip:
    up: {{from: E0, to: E1, input_speed: {speed!r} rad/s, input_action: 35.58,
         output_action: -120.5, capacity: 743.2}}
"""


def up(torque: str = "120 N*m", change: str = "from: M1, to: M2", element: str = "B1") -> str:
    return (f"{{{change}, input_speed: 400 rad/s, input_action: 150 N*m, output_action: -250 N*m, "
            f"capacity: {{{element}: {torque}}}}}")


class Train:
    """Speeds of the bodies by those of shaft (with sun 1) and ring, and the energy that they have."""

    turn = F(19, 15) * F(15, 14) * F(22, 85)  # ring over sun 1, seen from the carrier

    def speeds(self, first: F, ring: F) -> dict[str, F]:
        carrier = (ring - self.turn * first) / (1 - self.turn)
        return {"first": first, "ring": ring, "carrier": carrier,
                "second": carrier - F(85, 41) * (ring - carrier),
                "short": carrier - F(19, 15) * (first - carrier),
                "long": carrier + F(19, 14) * (first - carrier)}

    def energy(self, first: F, ring: F) -> F:
        of = self.speeds(first, ring)
        double = (F(254, 1000) * of["first"] ** 2 + F(9, 1000) * of["second"] ** 2
                  + F(456, 100) * of["ring"] ** 2 + F(3, 100) * of["carrier"] ** 2)
        for planet, inertia, mass, radius in (("short", F(4, 100000), F(35, 100), F(34, 1000)),
                                              ("long", F(25, 100000), F(9, 10), F(63, 1000))):
            double += 2 * (inertia * of[planet] ** 2 + mass * (radius * of["carrier"]) ** 2)
        return double / 2

    def matrix(self) -> tuple[F, F, F]:
        first, ring = 2 * self.energy(F(1), F(0)), 2 * self.energy(F(0), F(1))
        return first, self.energy(F(1), F(1)) - (first + ring) / 2, ring

    def rates(self, torque: F) -> tuple[F, F]:
        """Of shaft and ring, where brake B1 gives sun 2 this torque."""
        a, b, c = self.matrix()
        first = 150 + torque * self.speeds(F(1), F(0))["second"]
        ring = -250 + torque * self.speeds(F(0), F(1))["second"]
        det = a * c - b * b
        return (c * first - b * ring) / det, (a * ring - b * first) / det


class SlipTest(DynamicsCase):
    def test_two_flywheels(self) -> None:
        """J1 J2/(J1 + J2) (w1 - w2)^2/2 is lost, whatever the clutch bears."""
        expected = CASES["two_flywheels"]["expected"]
        slip = program.run("shift", "-", text=flywheels(
            "{to: C, input_speed: 200, output_speed: 50, input_action: 0, output_action: 0, "
            "capacity: 80}"))["shift"]["slip"]["start"]
        self.near(slip["time"], expected["time"], 1.0, "time")
        self.near(slip["energy"], expected["energy"], 1e3, "energy")
        self.near(slip["input"]["speed_at_end"], expected["common_speed"], 100.0, "speed")
        self.near(slip["output"]["speed_at_end"], expected["common_speed"], 100.0, "speed")
        self.assertEqual(slip["holding_torque"], 0.0)
        self.assertEqual(slip["work"], 0.0)
        self.assertEqual((slip["from"], slip["opens"], slip["slips"]), (None, None, "C"))

    def test_launch(self) -> None:
        """From rest: 60 N*m accelerate 0.3 kg*m^2 less 100 N*m, 100 N*m accelerate 1.2 kg*m^2."""
        slip = program.run("shift", "-", text=flywheels(
            "{to: C, input_speed: 100, output_speed: 0, input_action: 60, output_action: 0, "
            "capacity: {C: 100 N*m}}"))["shift"]["slip"]["start"]
        first, second = (60 - 100) / 0.3, 100 / 1.2
        self.near(slip["input"]["angular_acceleration"], first, 100.0, "input")
        self.near(slip["output"]["angular_acceleration"], second, 100.0, "output")
        self.near(slip["time"], 100 / (second - first), 1.0, "time")
        self.near(abs(slip["holding_torque"]), 60 * 1.2 / 1.5, 100.0, "to hold")
        self.near(slip["least_capacity"], 60 * 1.2 / 1.5, 100.0, "least")

    def test_published_change(self) -> None:
        expected = CASES["shift_slip"]["expected"]
        slip = program.run("shift", "-", text=ravigneaux(up()))["shift"]["slip"]["up"]
        for key, value in {"slip": expected["slip_at_start"], "slip_rate": expected["slip_rate"],
                           "time": expected["time"], "energy": expected["energy"],
                           "peak_power": expected["power_peak"],
                           "input_inertia": expected["mass_matrix"][0][0],
                           "shared_inertia": expected["mass_matrix"][0][1],
                           "output_inertia": expected["mass_matrix"][1][1]}.items():
            self.near(slip[key], value, abs(value), key)
        for shaft, name in (("input", "in"), ("output", "out")):
            self.near(slip[shaft]["speed_at_end"], expected[f"speed_{name}_end"], 100.0, shaft)
            self.near(slip[shaft]["angular_acceleration"], expected[f"acceleration_{name}"], 100.0,
                      shaft)

    def test_by_fractions(self) -> None:
        train = Train()
        slip = program.run("shift", "-", text=ravigneaux(up()))["shift"]["slip"]["up"]
        ring = 400 * train.turn  # of M1, whose carrier rests
        start = train.speeds(F(400), ring)["second"]
        first_rate, ring_rate = train.rates(F(120))
        rate = train.speeds(first_rate, ring_rate)["second"]
        time = -start / rate
        end = (400 + first_rate * time, ring + ring_rate * time)
        change = train.energy(*end) - train.energy(F(400), ring)
        work = time * (150 * (400 + end[0]) - 250 * (ring + end[1])) / 2
        self.assertEqual(change, work - 120 * abs(start) * time / 2)
        self.near(slip["slip"], float(start), 100.0, "slip")
        self.near(slip["time"], float(time), 1.0, "time")
        self.near(slip["work"], float(work), 1e4, "work")
        self.near(slip["kinetic_energy_change"], float(change), 1e4, "kinetic energy")
        self.assertLess(slip["residual"], 1e-13)
        # What the clutch hands on is what the shaft does not take for itself.
        self.near(slip["held"]["C1"], float(150 - F(1, 4) * first_rate), 100.0, "C1")
        free, loaded = (train.speeds(*train.rates(F(t)))["second"] for t in (0, 1))
        self.near(slip["holding_torque"], float(-free / (loaded - free)), 100.0, "to hold")

    def test_never_synchronises(self) -> None:
        done = program.call("shift", "-", text=ravigneaux(up("90 N*m")))
        slip = program.report(done)["shift"]["slip"]["up"]
        self.assertEqual(slip["status"], "never synchronises")
        self.assertIsNone(slip["time"])
        self.assertIsNone(slip["input"]["speed_at_end"])
        self.assertIn("W0713", done.stderr)
        self.assertIn("90.5924 N*m", done.stderr)
        just = slip["least_capacity"]
        for share, status in ((0.999, "never synchronises"), (1.001, "synchronises")):
            text = ravigneaux(up(f"{just * share!r} N*m"))
            slip = program.run("shift", "-", text=text)["shift"]["slip"]["up"]
            self.assertEqual(slip["status"], status)

    def test_inertia_does_not_hang_on_speed(self) -> None:
        """Of a train whose bodies turn about their centres of mass, whatever rounding makes of it."""
        slips = {}
        for speed in (0.001, 20.0, 100.0, 200.0, 214.0, 214.66, 3000.0):
            slips[speed] = program.run("shift", "-", text=paired_planets(speed))["shift"]["slip"]["up"]
        for speed, slip in slips.items():
            for key in ("input_inertia", "output_inertia", "shared_inertia", "slip_rate",
                        "holding_torque", "least_capacity"):
                self.near(slip[key], slips[20.0][key], abs(slips[20.0][key]), f"{key} at {speed}")
            self.near(slip["slip"], slips[20.0]["slip"] * speed / 20.0, speed, f"slip at {speed}")

    def test_inertia_that_changes(self) -> None:
        """A planet off its centre of mass is lifted by its carrier."""
        text = paired_planets(20.0).replace("q1: {inertia: 0.001,", "q1: {inertia: 0.001, centre_of_mass: [0, 30 mm],")
        done = program.call("shift", "-", text=text)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("the inertia of the mechanism changes", done.stderr)

    def test_one_refused(self) -> None:
        """The gears, and the slips that have an answer, are written all the same."""
        text = ravigneaux(up()).replace("slip: {up:", "slip: {down: "
                                        + up(change="from: MR, to: M2") + ", up:")
        done = program.call("shift", "-", text=text)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertEqual(done.stderr.count("E0712"), 1, done.stderr)
        shift = program.report(done)["shift"]
        alone = program.run("shift", "-", text=ravigneaux(up()))["shift"]
        self.assertEqual(shift["slip"], alone["slip"])
        self.assertEqual(shift["states"], alone["states"])
        self.assertIn("one element must open", shift["slip_without_answer"]["down"]["reason"])

    def test_refusals(self) -> None:
        for text, reason in {
            ravigneaux(up(change="from: MR, to: M2")): "opened are 'C2', 'B2', to be engaged 'C1', 'B1'",
            ravigneaux(up(change="from: M1, to: M7")): "'M7' is not a gear",
            ravigneaux(up(element="C2")): "'B1' engages, not 'C2'",
            re.sub(r"inertia: \{polar: [^}]*\}", "inertia: {polar: 0, axis: z}",
                   ravigneaux(up())).replace("mass: 0.35, ", "").replace("mass: 0.9, ", ""):
                "nothing resists",
        }.items():
            done = program.call("shift", "-", text=text)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("E0712", done.stderr)
            self.assertIn(reason, done.stderr)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
