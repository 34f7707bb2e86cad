#!/usr/bin/env python3
"""Torque converters against their characteristic, by closed forms.

Usage: converter_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import json
import math
import random
import sys
import unittest

import program
from converter_case import (
    CHARACTERISTIC, FLUID_COUPLING, MU, PUMP, RATIOS,
    analyze, case, flow, interpolated, model)


class Characteristic(unittest.TestCase):
    def check(self, one: dict, engine: float, nu: float, mu: float, pump: float) -> None:
        """All that a case says, of the pump's torque at 2000 rpm."""
        torque = pump * (engine / 2000) ** 2 * math.copysign(1, engine)
        actions = one["statics"]["actions"]
        near = lambda a, b: self.assertAlmostEqual(a, b, delta=1e-9 * (1 + abs(b)))
        near(actions["engine"], torque)
        near(actions["out"], -mu * torque)
        converter = one["statics"]["converters"]["TC"]
        near(converter["speed_ratio"], nu)
        near(converter["torque_ratio"], mu)
        near(converter["pump_torque"], torque)
        near(converter["turbine_torque"], mu * torque)
        near(converter["stator_torque"], (mu - 1) * torque)
        near(converter["efficiency"], mu * nu)
        loss = torque * engine * math.pi / 30 * (1 - mu * nu)
        near(converter["loss"], loss)
        # What the housing bears beside the engine and the output.
        near(one["statics"]["couplings"]["TC_stator"]["moment"][2], (mu - 1) * torque)
        near(one["statics"]["couplings"]["TC"]["moment"][2], torque)
        power = one["power"]
        near(power["actuators"]["engine"] + power["actuators"]["out"], loss)
        near(-sum(power["friction"].values()), loss)
        near(power["efficiency"]["friction"], mu * nu)
        self.assertLess(power["balance_residual"], 1e-12)

    def test_points_of_the_table(self) -> None:
        text = "".join(case(f"p{i}", 1700, 1700 * nu) for i, nu in enumerate(RATIOS[:-1]))
        cases = analyze(model(text))
        for i, nu in enumerate(RATIOS[:-1]):
            self.check(cases[f"p{i}"], 1700, nu, MU[i], PUMP[i])

    def test_between_them(self) -> None:
        rng = random.Random(24)
        points = [(rng.uniform(300, 3000) * rng.choice((-1, 1)), rng.uniform(0.001, 0.999))
                  for _ in range(40)]
        cases = analyze(model("".join(case(f"p{i}", n, n * nu)
                                      for i, (n, nu) in enumerate(points))))
        for i, (n, nu) in enumerate(points):
            self.check(cases[f"p{i}"], n, nu, interpolated(RATIOS, MU, nu),
                       interpolated(RATIOS, PUMP, nu))

    def test_ends_of_a_table(self) -> None:
        """A quotient of two speeds may lie beyond an end by its rounding."""
        form = (", stator: housing, characteristic: {speed_ratio: [0.1, 0.4, 0.95], torque_ratio: "
                "[1.9, 1.5, 1], pump_torque: [150, 140, 20], pump_speed: 2000 rpm}")
        rng = random.Random(3)
        speeds = [rng.uniform(500, 3000) for _ in range(40)]
        ends = ((0.1, 1.9, 150), (0.95, 1, 20))
        text = "".join(case(f"p{k}_{i}", n, n * ends[k][0])
                       for k in range(2) for i, n in enumerate(speeds))
        # a torque that only ratios of the last interval of the search have
        text += "".join(case(f"s{i}", n, None, f"engine: {20.02 * (n / 2000) ** 2!r}, L: 0")
                        for i, n in enumerate(speeds))
        cases = analyze(model(text).replace(flow(CHARACTERISTIC), form))
        for i, n in enumerate(speeds):
            for k, (nu, mu, pump) in enumerate(ends):
                self.check(cases[f"p{k}_{i}"], n, nu, mu, pump)
            found = cases[f"s{i}"]["statics"]["converters"]["TC"]["speed_ratio"]
            self.assertAlmostEqual(found, 0.95, delta=1e-3)

    def test_lock_up_carries_all(self) -> None:
        one = analyze(model(
            "  c: {motion: {engine: 2000, L: 0}, action: {engine: 100}, input: engine, output: out}\n"
        ))["c"]
        self.assertAlmostEqual(one["statics"]["actions"]["L"], 100)
        self.assertAlmostEqual(one["statics"]["actions"]["out"], -100)
        self.assertEqual(one["statics"]["converters"]["TC"]["pump_torque"], 0)
        self.assertIsNone(one["statics"]["converters"]["TC"]["efficiency"])
        self.assertEqual(one["ratio"], 1)

    def test_all_at_rest(self) -> None:
        one = analyze(model(case("c", 0, 0)))["c"]
        self.assertEqual(one["statics"]["actions"]["out"], 0)

    def test_forms_agree(self) -> None:
        """MP2000, lambda and a K factor of one converter."""
        rho, size, w = 860, 0.26, 2000 * math.pi / 30
        lambdas = [pump / (rho * size ** 5 * w * w) for pump in PUMP]
        stator = "stator: housing, characteristic: "
        table = f"speed_ratio: {RATIOS}, torque_ratio: {MU}"
        forms = [
            f"{table}, lambda: {lambdas}, density: 860 kg/m^3, diameter: 260 mm",
            f"{table}, lambda: {lambdas}, density: 860, diameter: 260 mm",
            f"{table}, pump_speed: 1000 rpm, pump_torque: {[pump / 4 for pump in PUMP]}",
            f"{table}, pump_speed: 2000 rpm, pump_torque: "
            f"[{', '.join(f'(2000/{2000 / math.sqrt(p)!r})^2' if p else '0' for p in PUMP)}]",
        ]
        for form in forms:
            text = model(case("c", 1500, 600)).replace(flow(CHARACTERISTIC),
                                                       f", {stator}{{{form}}}")
            self.check(analyze(text)["c"], 1500, 0.4, interpolated(RATIOS, MU, 0.4),
                       interpolated(RATIOS, PUMP, 0.4))

    def test_expressions(self) -> None:
        form = (", stator: housing, characteristic: {torque_ratio: 'max(1, 2 - 1.25*speed_ratio)', "
                "pump_torque: 'top*(1 - speed_ratio^4)', pump_speed: 2000 rpm}")
        text = model(case("c", 1500, 600) + case("d", 1500, 1350),
                     more="parameters: {top: 160 N*m}\n").replace(flow(CHARACTERISTIC), form)
        cases = analyze(text)
        self.check(cases["c"], 1500, 0.4, 1.5, 160 * (1 - 0.4 ** 4))
        self.check(cases["d"], 1500, 0.9, 1, 160 * (1 - 0.9 ** 4))

    def test_fluid_coupling(self) -> None:
        one = analyze(model(case("c", 1000, 800), FLUID_COUPLING))["c"]
        self.assertAlmostEqual(one["statics"]["actions"]["engine"], 150 * 0.2 / 4)
        self.assertAlmostEqual(one["statics"]["actions"]["out"], -150 * 0.2 / 4)
        self.assertAlmostEqual(one["power"]["efficiency"]["friction"], 0.8)
        self.assertNotIn("TC_stator", one["statics"]["couplings"])

    def test_overrun(self) -> None:
        """Beyond 1 the turbine drives: a negative torque of the pump."""
        form = (", stator: housing, characteristic: {speed_ratio: [0, 1, 1.25], torque_ratio: "
                "[2, 1, 1], pump_torque: [150, 0, -30], pump_speed: 2000 rpm}")
        one = analyze(model(case("c", 2000, 2500)).replace(flow(CHARACTERISTIC), form))["c"]
        self.assertAlmostEqual(one["statics"]["actions"]["engine"], -30)
        self.assertAlmostEqual(one["statics"]["actions"]["out"], 30)
        converter = one["statics"]["converters"]["TC"]
        self.assertAlmostEqual(converter["efficiency"], 0.8)
        self.assertAlmostEqual(converter["loss"], 30 * 500 * math.pi / 30)

    def test_no_value(self) -> None:
        for engine, out in ((1000, 1100), (1000, -100), (0, 100)):
            done = program.call("analyze", "-", text=model(case("c", engine, out)))
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("E0604", done.stderr)
            self.assertIn("torque converter 'TC'", done.stderr)


class FoundSlip(unittest.TestCase):
    """Engine speed and engine torque, and no speed of the output."""

    def test_speed_ratio(self) -> None:
        rng = random.Random(7)
        points = []
        text = ""
        for i in range(12):
            nu = rng.uniform(0.31, 0.99)
            n = rng.uniform(500, 3000) * rng.choice((-1, 1))
            torque = math.copysign(1, n) * interpolated(RATIOS, PUMP, nu) * (n / 2000) ** 2
            points.append((n, nu))
            text += case(f"p{i}", n, None, f"engine: {torque!r}, L: 0")
        cases = analyze(model(text))
        for i, (n, nu) in enumerate(points):
            Characteristic.check(self, cases[f"p{i}"], n, nu, interpolated(RATIOS, MU, nu),
                                 interpolated(RATIOS, PUMP, nu))
            self.assertAlmostEqual(cases[f"p{i}"]["kinematics"]["freedoms"]["T.wz"], n * nu,
                                   delta=1e-8 * abs(n))

    def test_engine_speed_from_the_output(self) -> None:
        """The output's speed and the engine's torque: K(nu) / nu^2 falls."""
        nu, out = 0.6, 900
        torque = interpolated(RATIOS, PUMP, nu) * (out / nu / 2000) ** 2
        one = analyze(model(case("c", None, out, f"engine: {torque!r}, L: 0")))["c"]
        Characteristic.check(self, one, out / nu, nu, interpolated(RATIOS, MU, nu),
                             interpolated(RATIOS, PUMP, nu))

    def test_load_of_the_output(self) -> None:
        """The torque that the output takes instead of the engine's."""
        nu, n = 0.5, 1800
        torque = -1.5 * 140 * (n / 2000) ** 2
        one = analyze(model(case("c", n, None, f"out: {torque!r}, L: 0")))["c"]
        Characteristic.check(self, one, n, nu, 1.5, 140)

    def test_none(self) -> None:
        done = program.call("analyze", "-", text=model(case("c", 2000, None, "engine: 500, L: 0")))
        self.assertIn("E0501", done.stderr)
        self.assertIn("at no speed ratio: it ranges from 0 N*m to 150 N*m there", done.stderr)

    def test_several(self) -> None:
        form = (", stator: housing, characteristic: {speed_ratio: [0, 0.4, 1], torque_ratio: "
                "[2, 1.6, 1], pump_torque: [100, 140, 0], pump_speed: 2000 rpm}")
        done = program.call("analyze", "-", text=model(
            case("c", 2000, None, "engine: 120, L: 0")).replace(flow(CHARACTERISTIC), form))
        self.assertIn("E0501", done.stderr)
        self.assertIn("at speed ratios of", done.stderr)


# Engine and output by gears beside the axis of the converter: 31 teeth drive 17, 13 drive 37.
GEARED = f"""kinestat: 1
space: planar
units: {{length: mm, angular_velocity: rpm, power: W}}
ground: housing
bodies: [crank, pump, turbine, shaft]
couplings:
  E: {{type: revolute, bodies: [housing, crank]}}
  P: {{type: revolute, bodies: [housing, pump]}}
  T: {{type: revolute, bodies: [housing, turbine]}}
  O: {{type: revolute, bodies: [housing, shaft]}}
  TC: {{type: torque_converter, bodies: [pump, turbine]{flow(CHARACTERISTIC)}}}
gears:
  module: 2 mm
  members:
    p: {{body: pump, teeth: 17}}
    e: {{body: crank, teeth: 31, centre_distance: 48 mm}}
    t: {{body: turbine, teeth: 13}}
    o: {{body: shaft, teeth: 37, centre_distance: 50 mm}}
  meshes: {{first: {{members: [p, e]}}, last: {{members: [t, o]}}}}
actuators: {{engine: {{coupling: E}}, out: {{coupling: O}}}}
cases:
"""


class Stall(unittest.TestCase):
    """The turbine rests: all power is lost, and there is no ratio of speeds."""

    def check(self, one: dict, pump: float, freedom: str, torque_ratio: float = 2.1) -> None:
        torque = 150 * (pump / 2000) ** 2
        self.assertEqual(one["kinematics"]["freedoms"][freedom], 0.0)
        self.assertIsNone(one["ratio"])
        converter = one["statics"]["converters"]["TC"]
        self.assertEqual(converter["speed_ratio"], 0.0)
        self.assertEqual(converter["efficiency"], 0.0)
        self.assertAlmostEqual(abs(converter["turbine_torque"]), torque_ratio * torque,
                               delta=1e-12 * torque)
        self.assertAlmostEqual(converter["loss"], torque * abs(pump) * math.pi / 30,
                               delta=1e-10 * torque * abs(pump))
        self.assertEqual(one["power"]["efficiency"]["friction"], 0.0)

    def test_given_speeds(self) -> None:
        for i, one in analyze(model("".join(case(f"p{n}", n, 0) for n in (700, -1300)))).items():
            self.check(one, float(i[1:]), "T.wz")

    def test_torque_of_the_engine(self) -> None:
        """Whatever the last digits of that torque are."""
        rng = random.Random(12)
        speeds = [rng.uniform(500, 3000) * rng.choice((-1, 1)) for _ in range(40)]
        text = "".join(
            case(f"p{i}", n, None, f"engine: {150 * (n / 2000) ** 2 * math.copysign(1, n)!r}, L: 0")
            for i, n in enumerate(speeds))
        cases = analyze(model(text))
        for i, n in enumerate(speeds):
            self.check(cases[f"p{i}"], n, "T.wz")

    def test_behind_gears(self) -> None:
        rng = random.Random(13)
        speeds = [rng.uniform(500, 2000) * rng.choice((-1, 1)) for _ in range(40)]
        text = ""
        for i, n in enumerate(speeds):
            torque = 150 * (n * 31 / 17 / 2000) ** 2 * 31 / 17 * math.copysign(1, n)
            text += case(f"p{i}", n, None, f"engine: {torque!r}")
        cases = analyze(GEARED + text)
        for i, n in enumerate(speeds):
            self.check(cases[f"p{i}"], n * 31 / 17, "O.wz")

    def test_fluid_coupling(self) -> None:
        rng = random.Random(14)
        speeds = [rng.uniform(500, 3000) for _ in range(20)]
        text = "".join(case(f"p{i}", n, None, f"engine: {150 * (n / 2000) ** 2!r}, L: 0")
                       for i, n in enumerate(speeds))
        cases = analyze(model(text, FLUID_COUPLING))
        for i, n in enumerate(speeds):
            self.check(cases[f"p{i}"], n, "T.wz", 1.0)

    def test_swept(self) -> None:
        text = GEARED.replace("bodies: [crank", "parameters: {n: 1000}\nbodies: [crank") + (
            "  c: {motion: {engine: n}, action: {engine: 150 N*m*(n*31/17/2000)^2*31/17}, "
            "input: engine, output: out}\n")
        done = program.call("sweep", "-", text=text + "sweep: {vary: {n: {from: 500, to: 1500, "
                            "step: 20}}, report: [ratio, out, O.wz, efficiency]}\n")
        rows = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(len(rows), 51)
        for row in rows:
            self.assertEqual(row["status"], "no_ratio", row)
            self.assertEqual((row["O.wz [rpm]"], row["ratio"]), (0.0, None))
            self.assertAlmostEqual(abs(row["out [N*m]"]),
                                   2.1 * 150 * (row["n"] * 31 / 17 / 2000) ** 2 * 37 / 13, delta=1e-9)

    def test_points_of_a_duty(self) -> None:
        more = "duty:\n  case: c\n  points:\n"
        given = 0.0
        for n in (1700, 900, 2100):
            torque = 150 * (n / 2000) ** 2
            given += torque * n * math.pi / 30 * 5
            more += f"    - {{input_motion: {n}, input_action: {torque!r}, duration: 5}}\n"
        text = model(case("c", 1000, None, "engine: 30, L: 0"))
        duty = program.run("duty", "-", text=text.replace("cases:\n", more + "cases:\n"))["duty"]
        self.assertAlmostEqual(duty["given"], given, delta=1e-9 * given)
        self.assertEqual((duty["taken"], duty["efficiency"]), (0.0, 0.0))

    def test_a_turbine_that_is_driven_backwards(self) -> None:
        """Both shafts give power: nothing comes out."""
        form = (", stator: housing, characteristic: {speed_ratio: [-0.5, 0, 1], torque_ratio: "
                "[2.5, 2, 1], pump_torque: [150, 150, 0], pump_speed: 2000 rpm}")
        one = analyze(model(case("c", 2000, -1000)).replace(flow(CHARACTERISTIC), form))["c"]
        converter = one["statics"]["converters"]["TC"]
        self.assertEqual(converter["efficiency"], 0.0)
        self.assertAlmostEqual(converter["loss"], 150 * (2000 + 2.5 * 1000) * math.pi / 30,
                               delta=1e-8)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
