#!/usr/bin/env python3
"""Power from body to body: balances of all mechanisms, and closed forms of the Ravigneaux train.

Usage: power_graph_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import json
import subprocess
import sys
import unittest
from fractions import Fraction
from pathlib import Path
from typing import Any

PROGRAM = ""
MECHANISMS = Path()
TRAIN = "transmissions/ravigneaux.yaml"


def report_of(path: Path) -> dict[str, Any]:
    done = subprocess.run([PROGRAM, "analyze", "--format", "json", str(path)],
                          capture_output=True, encoding="utf-8", check=False, timeout=60)
    return json.loads(done.stdout)


class PowerGraph(unittest.TestCase):
    def test_every_body_gives_what_it_receives(self) -> None:
        balances = 0
        for path in sorted(MECHANISMS.glob("**/*.yaml")):
            for label, case in report_of(path).get("cases", {}).items():
                for name, body in case.get("power", {}).get("bodies", {}).items():
                    if body["given"] is not None:
                        with self.subTest(f"{path.name}: {label}, {name}"):
                            largest = max(map(abs, filter(None, case["power"]["couplings"].values())),
                                          default=1.0)
                            self.assertAlmostEqual(body["received"], body["given"],
                                                   delta=1e-9 * largest)
                            balances += 1
        self.assertGreater(balances, 100)

    def test_arcs_are_the_powers_of_couplings_that_nobody_drives(self) -> None:
        for label, case in report_of(MECHANISMS / TRAIN)["cases"].items():
            power = case["power"]
            couplings = {name for name, value in power["couplings"].items()
                         if name not in "abde" and value != 0.0}
            self.assertEqual(set(power["arcs"]), couplings, label)
            for name in couplings:
                self.assertAlmostEqual(power["arcs"][name]["power"], abs(power["couplings"][name]),
                                       delta=1e-9)

    # Seen from the carrier the train has fixed axes: by Willis the ring turns there 209/595 as fast
    # as sun 1 and -41/85 as fast as sun 2. Sun 1 has 100 N*m, the others by balance of powers.
    def test_meshes_roll_as_seen_from_the_carrier(self) -> None:
        ring_of_1 = Fraction(19, 14) * Fraction(22, 85)
        ring_of_2 = Fraction(-41, 85)
        carrier = ring_of_1 / (ring_of_1 - ring_of_2)  # sun 1 at 1 rad/s, sun 2 at rest
        ring = carrier + ring_of_1 * (1 - carrier)
        torque = {"sun1": Fraction(100), "ring": -100 / ring}
        torque["sun2"] = -torque["sun1"] - torque["ring"]
        rolling = {"h": torque["sun1"] * (1 - carrier), "j": torque["sun2"] * (0 - carrier),
                   "k": torque["ring"] * (ring - carrier)}
        rolling["i"] = rolling["h"]

        power = report_of(MECHANISMS / TRAIN)["cases"]["M2"]["power"]

        self.assertEqual(set(power["meshes"]), set(rolling))
        for name, expected in rolling.items():
            self.assertEqual(power["meshes"][name]["carrier"], "carrier")
            self.assertAlmostEqual(power["meshes"][name]["rolling"], float(expected), delta=1e-10)

    # The carrier is free in both: what goes from it to planet 6 comes back from planet 5 (arcs g and
    # f, Cazangi's figures 5.18 and 5.22), by forces that depend on where the planets are drawn.
    def test_planets_that_mesh_with_each_other_make_no_circle(self) -> None:
        cases = report_of(MECHANISMS / TRAIN)["cases"]
        for label, power in (("M2", 4675 / 31), ("M3", 6930 / 31)):
            arcs = cases[label]["power"]["arcs"]
            self.assertAlmostEqual(arcs["g"]["power"], power, delta=1e-9)
            self.assertAlmostEqual(arcs["f"]["power"], power, delta=1e-9)
            self.assertEqual(cases[label]["power"]["recirculation"]["loops"], [], label)
            self.assertAlmostEqual(cases[label]["power"]["recirculation"]["factor"], 1.0,
                                   delta=1e-12)

    # In the third gear clutch E joins sun 3 and sun 4, and the circle goes through sets 2 and 4. Its
    # largest power is that of set 2's carrier: torque times speed of a shaft.
    def test_power_of_a_clutched_set_goes_in_a_circle(self) -> None:
        power = report_of(MECHANISMS / "transmissions/zf_8hp70.yaml")["cases"]["3"]["power"]
        circle = power["recirculation"]["loops"][0]

        self.assertEqual(circle["couplings"], ["P2", "r2", "E", "C"])
        self.assertAlmostEqual(max(circle["powers"]),
                               power["recirculation"]["factor"] * power["input"], delta=1e-8)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
