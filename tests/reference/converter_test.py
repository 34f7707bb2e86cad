#!/usr/bin/env python3
"""Torque converters against their characteristic, by closed forms.

Usage: converter_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import csv
import json
import math
import random
import re
import sys
import tempfile
import unittest
from pathlib import Path

import program

# Pump and turbine on one axis, with a lock-up; torques at 2000 rpm.
RATIOS = [0, 0.3, 0.5, 0.85, 0.95, 1]
MU = [2.1, 1.75, 1.5, 1, 1, 1]
PUMP = [150, 146, 140, 90, 45, 0]

CHARACTERISTIC = f"""
      stator: housing
      characteristic:
        speed_ratio:  {RATIOS}
        torque_ratio: {MU}
        pump_torque:  {PUMP}
        pump_speed: 2000 rpm"""

FLUID_COUPLING = """
      characteristic: {pump_torque: 150 N*m*(1 - speed_ratio), pump_speed: 2000 rpm}"""


def model(cases: str, characteristic: str = CHARACTERISTIC, more: str = "") -> str:
    return f"""kinestat: 1
space: planar
units: {{length: mm, angular_velocity: rpm, power: W}}
ground: housing
bodies: [pump, turbine]
couplings:
  E: {{type: revolute, bodies: [housing, pump], at: [0, 0]}}
  T: {{type: revolute, bodies: [housing, turbine], at: [0, 0]}}
  L: {{type: clutch, bodies: [pump, turbine], at: [0, 0]}}
  TC: {{type: torque_converter, bodies: [pump, turbine], at: [0, 0]{flow(characteristic)}}}
actuators: {{engine: {{coupling: E}}, out: {{coupling: T}}}}
{more}cases:
{cases}"""


# The lines of a mapping as one in braces.
def flow(block: str) -> str:
    text = ""
    for line in block.strip().splitlines():
        key, _, value = line.strip().partition(":")
        text += ", " + (f"{key}: {{" if not value else f"{key}: {value.strip()}")
    text = text.replace("{, ", "{")
    return text + ("}" if text.count("{") > text.count("}") else "")


def case(name: str, engine: float | None, out: float | None, action: str = "L: 0") -> str:
    motion = ", ".join(f"{key}: {value!r}" for key, value in (("engine", engine), ("out", out))
                       if value is not None)
    return f"  {name}: {{motion: {{{motion}}}, action: {{{action}}}, input: engine, output: out}}\n"


def analyze(text: str) -> dict:
    return program.run("analyze", "-", text=text)["cases"]


# Fritsch and Butland 1984, written down anew: slopes are weighted harmonic means of the chords.
def interpolated(xs: list[float], ys: list[float], x: float) -> float:
    count = len(xs)
    widths = [xs[i + 1] - xs[i] for i in range(count - 1)]
    chords = [(ys[i + 1] - ys[i]) / widths[i] for i in range(count - 1)]

    def end(h0: float, h1: float, c0: float, c1: float) -> float:
        slope = ((2 * h0 + h1) * c0 - h0 * c1) / (h0 + h1)
        if slope * c0 <= 0:
            return 0.0
        return 3 * c0 if c0 * c1 <= 0 and abs(slope) > 3 * abs(c0) else slope

    slopes = [end(widths[0], widths[1], chords[0], chords[1])]
    for i in range(1, count - 1):
        a, b = chords[i - 1], chords[i]
        w1 = 2 * widths[i] + widths[i - 1]
        w2 = widths[i] + 2 * widths[i - 1]
        slopes.append(0.0 if a * b <= 0 else (w1 + w2) / (w1 / a + w2 / b))
    slopes.append(end(widths[-1], widths[-2], chords[-1], chords[-2]))
    i = max(k for k in range(count - 1) if xs[k] <= x)
    h = widths[i]
    t = (x - xs[i]) / h
    return (ys[i] * (1 + 2 * t) * (1 - t) ** 2 + h * slopes[i] * t * (1 - t) ** 2
            + ys[i + 1] * t * t * (3 - 2 * t) + h * slopes[i + 1] * t * t * (t - 1))


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
