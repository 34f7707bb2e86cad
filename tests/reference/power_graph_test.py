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

    def test_power_of_the_second_gear_goes_in_a_circle_that_rolls(self) -> None:
        cases = report_of(MECHANISMS / TRAIN)["cases"]
        circle = {"bodies": ["carrier", "planet6", "planet5"], "couplings": ["g", "i", "f"]}

        self.assertEqual(cases["M1"]["power"]["recirculation"]["loops"], [])
        self.assertEqual(cases["M2"]["power"]["recirculation"]["loops"], [circle | {"rolls": True}])
        self.assertAlmostEqual(cases["M2"]["power"]["recirculation"]["factor"], 46.75 / 31,
                               delta=1e-12)

    def test_power_of_the_direct_gear_goes_in_a_circle_that_does_not_roll(self) -> None:
        cases = report_of(MECHANISMS / TRAIN)["cases"]

        self.assertEqual([loop["rolls"] for loop in cases["M3"]["power"]["recirculation"]["loops"]],
                         [False])
        self.assertAlmostEqual(cases["M3"]["power"]["recirculation"]["factor"], 69.3 / 31,
                               delta=1e-12)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
