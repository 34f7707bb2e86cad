#!/usr/bin/env python3
"""What sweeps, sensitivities and other studies say of torque converters, by closed forms.

Usage: converter_study_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import csv
import math
import random
import re
import sys
import tempfile
import unittest
from pathlib import Path

import program
from converter_case import (
    CHARACTERISTIC, FLUID_COUPLING, MU, PUMP,
    RATIOS, case, interpolated, model)


class Studies(unittest.TestCase):
    POINTS = [(1500, 0, 10), (1800, 900, 20), (1800, 1700, 60), (2000, 1000, 5)]

    def test_duty(self) -> None:
        """Energies are sums of powers in closed form; the stator's is part of the converter's."""
        more = ("duty:\n  case: c\n  points:\n" + "".join(
            f"    - {{input_motion: {{engine: {n}, out: {m}}}, duration: {t}}}\n"
            for n, m, t in self.POINTS))
        one = "  c: {motion: {engine: 1000, out: 500}, action: {L: 0}, input: [engine, out]}\n"
        self.check_duty(model(one).replace("cases:\n", more + "cases:\n"))

    def test_duty_of_an_engine(self) -> None:
        """Speed and torque of the engine in each point: the speed of the output follows."""
        more = "duty:\n  case: c\n  points:\n"
        for n, m, t in self.POINTS:
            torque = interpolated(RATIOS, PUMP, m / n) * (n / 2000) ** 2
            more += (f"    - {{input_motion: {n}, input_action: {torque!r}, duration: {t}}}\n")
        text = model(case("c", 1000, None, "engine: 30, L: 0"))
        self.check_duty(text.replace("cases:\n", more + "cases:\n"))

    # Frictions of other couplings; the last one hangs on what presses, so that its points are not
    # solved together.
    FRICTIONS = ({},
                 {"E": "c: 0.05 N*m*s/rad", "T": "tau: 2 N*m, c: 0.01 N*m*s/rad"},
                 {"L": "tau: 3 N*m", "T": "c: 0.02 N*m*s/rad"},
                 {"T": "tau: '1 + 2*exp(-speed/(100 rad/s))'"},
                 {"T": "mu: 0.1, radius: 20 mm, tau: 1 N*m"})
    CHARACTERISTICS = (CHARACTERISTIC, FLUID_COUPLING, """
      stator: housing
      characteristic:
        torque_ratio: 'max(1, 2 - 1.25*speed_ratio)'
        pump_torque: 160 N*m*(1 - speed_ratio^4)
        pump_speed: 2000 rpm""",
                       # takes some torques at two speed ratios
                       """
      stator: housing
      characteristic:
        speed_ratio:  [0, 0.4, 0.96]
        torque_ratio: [2, 1.6, 1]
        pump_torque:  [100, 140, 20]
        pump_speed: 2000 rpm""")

    def test_points_of_a_cycle_are_those_of_an_analysis(self) -> None:
        """Whatever else rubs, and where no speed ratio fits, or more than one."""
        rng = random.Random(2026)
        for characteristic in self.CHARACTERISTICS:
            for frictions in self.FRICTIONS:
                for known in ("engine", "out"):
                    with self.subTest(characteristic=characteristic, frictions=frictions, known=known):
                        self.check_points(rng, characteristic, frictions, known)

    def check_points(self, rng: random.Random, characteristic: str, frictions: dict[str, str],
                     known: str) -> None:
        """`known` is the actuator whose torque decides the slip."""
        points = []
        for i in range(24):
            speed = rng.uniform(400, 3000) * rng.choice((-1, 1))
            size = rng.uniform(0, 170) * (speed / 2000) ** 2 * math.copysign(1, speed)
            points.append((speed, rng.choice((1, 1, 1, -0.2, 0)) * size, rng.uniform(1, 9)))
        points.append((1700.0, 0.0, 3.0))
        sign = 1 if known == "engine" else -1.2
        cases = "".join(case(f"p{i}", n, None, f"{known}: {sign * torque!r}, L: 0")
                        for i, (n, torque, _) in enumerate(points))
        text = model(cases, characteristic)
        for name, friction in frictions.items():
            text = text.replace(f"  {name}: {{type", f"  {name}: {{friction: {{{friction}}}, type")
        analysis = program.call("analyze", "-", text=text)
        cases = program.report(analysis)["cases"]
        rows = [f"duration [s],case,engine [rpm],{known} [N*m]"]
        rows += [f"{t!r},p0,{n!r},{sign * torque!r}" for n, torque, t in points]
        with tempfile.TemporaryDirectory() as folder:
            cycle = Path(folder) / "cycle.csv"
            cycle.write_text("\n".join(rows) + "\n", encoding="utf-8")
            done = program.call("duty", "-", "--cycle", str(cycle), text=text)
        states = program.report(done)["duty"]["points"]
        self.assertEqual(len(states), len(points))
        answered = 0
        for i, (state, (n, torque, t)) in enumerate(zip(states, points)):
            power = cases[f"p{i}"].get("power")
            if power is None:
                self.assertEqual(state["status"], "unanswered", (n, torque))
                continue
            answered += 1
            self.assertIn(state["status"], ("solved", "both_ends"), (n, torque))
            flows = power["actuators"].values()
            largest = t * max(map(abs, flows))
            near = lambda a, b: self.assertAlmostEqual(a, b, delta=1e-11 * largest + 1e-300)
            near(state["given"], t * sum(p for p in flows if p > 0))
            near(state["taken"], -t * sum(p for p in flows if p < 0))
            near(state["lost"], -t * sum(power["friction"].values()))
            self.assertLess(state["balance_residual"], 1e-12)
        self.assertGreater(answered, 0)
        # The message is that of the first point without an answer.
        first = next((i for i, state in enumerate(states) if state["status"] == "unanswered"), None)
        if first is not None:
            said = re.search(r"E\d+\]: case 'p\d+' (.*)", analysis.stderr)
            self.assertIn(said.group(1), done.stderr)

    def check_duty(self, text: str) -> None:
        points = self.POINTS
        duty = program.run("duty", "-", text=text)["duty"]
        given = lost = 0.0
        for n, m, t in points:
            nu = m / n
            torque = interpolated(RATIOS, PUMP, nu) * (n / 2000) ** 2
            power = torque * n * math.pi / 30
            given += power * t
            lost += power * (1 - interpolated(RATIOS, MU, nu) * nu) * t
        self.assertAlmostEqual(duty["given"], given, delta=1e-9 * given)
        self.assertAlmostEqual(duty["lost"], lost, delta=1e-9 * lost)
        self.assertAlmostEqual(duty["efficiency"], 1 - lost / given, delta=1e-12)
        self.assertEqual(list(duty["friction"]), ["TC"])
        self.assertAlmostEqual(duty["friction"]["TC"]["lost"], lost, delta=1e-9 * lost)
        self.assertLess(duty["balance_residual"], 1e-12)

    def test_sensitivity(self) -> None:
        """Towards the speed of the engine: T = K(nu) n^2 at a given output speed."""
        text = model(case("c", None, 900).replace("motion: {", "motion: {engine: n, "),
                     more="parameters: {n: 1500 rpm}\n")
        value = "cases/c/statics/actions/out"
        found = program.run("sensitivity", "-", "--of", value, text=text)
        self.maxDiff = None

        def torque(n: float) -> float:
            nu = 900 / n
            return (-interpolated(RATIOS, MU, nu) * interpolated(RATIOS, PUMP, nu)
                    * (n / 2000) ** 2)

        slope = (torque(1500 + 1e-3) - torque(1500 - 1e-3)) / 2e-3
        text = str(found)
        self.assertIn("n", text)
        derivative = first_number(found, "derivative")
        self.assertAlmostEqual(derivative, slope, delta=1e-5 * abs(slope))

    def test_sweep(self) -> None:
        """Every state is analysed whole, and equals its closed form."""
        more = ("parameters: {rate: 0 rpm}\n")
        text = model(case("c", 1500, None).replace("{engine: 1500", "{engine: 1500, out: rate"),
                     more=more).replace("cases:\n", "sweep: {vary: {rate: {from: 0 rpm, to: 1400 rpm, "
                                        "step: 200 rpm}}, report: [out]}\ncases:\n")
        done = program.plain("sweep", "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = list(csv.DictReader(line for line in done.stdout.splitlines()
                                   if not line.startswith("#")))
        self.assertEqual(len(rows), 8)
        for i, row in enumerate(rows):
            nu = 200 * i / 1500
            expected = (-interpolated(RATIOS, MU, nu) * interpolated(RATIOS, PUMP, nu)
                        * 0.75 ** 2)
            value = next(float(v) for k, v in row.items() if k.startswith("out"))
            self.assertAlmostEqual(value, expected, delta=1e-9 * abs(expected))


def first_number(node: object, key: str) -> float:
    if isinstance(node, dict):
        for name, value in node.items():
            if name == key and isinstance(value, (int, float)):
                return value
        for value in node.values():
            found = first_number(value, key)
            if found is not None:
                return found
    if isinstance(node, list):
        for value in node:
            found = first_number(value, key)
            if found is not None:
                return found
    return None


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
