#!/usr/bin/env python3
"""Holds mechanisms with inertia against two or three independent ways: Newton and Euler's equations of
each body in forty digits, the reduced equation by virtual power, and a multibody program.

Usage: dynamics_test.py PROGRAM [unittest arguments]

The expected rows stand in dynamics.json, with the mechanisms they are of.
"""

from __future__ import annotations

import cmath
import json
import math
import re
import sys
import unittest
from pathlib import Path

import program
from motion_case import Motion

DATA = json.loads(Path(__file__).with_name("dynamics.json").read_text(encoding="utf-8"))
CASES = {case["id"]: case for case in DATA["cases"]}
TOLERANCE = 1e-10


def motion_of(case: dict) -> Motion:
    return Motion(program.run("motion", "-", text=case["yaml"]))


def whole_of(text: str, section: str, command: str = "motion") -> dict:
    """What the section 'dynamics' is answered."""
    return program.run(command, "-", text=f"{text}dynamics: {section}\n")["motion"]["dynamics"]


def without_gas(text: str) -> str:
    """The engine without the force of its gas, whose torque has a closed form."""
    return re.sub(r"^curves:.*?(?=^cases:)", "", text, flags=re.M | re.S)


def found_range(function, places: int = 20000) -> tuple[float, float]:
    """Least and greatest over a turn: of samples, then by parabolas through three of them."""
    def vertex(sign: float) -> float:
        step = 2 * math.pi / places
        best = max(range(places), key=lambda i: sign * function(i * step))
        a, b, c = (sign * function((best + k) * step) for k in (-1, 0, 1))
        bend = a - 2 * b + c
        return sign * (b if bend == 0 else b - (a - c) ** 2 / (8 * bend))

    return vertex(-1.0), vertex(1.0)


class Engine:
    """The reflected inertia and the potential of the slider-crank engine, by its two angles."""

    crank, rod = abs(complex(0.03, 0.04)), abs(complex(0.18, -0.04))
    drawn = cmath.phase(complex(0.03, 0.04))

    def rates(self, turn: float) -> tuple[complex, float, complex, complex]:
        """Towards the turn: places of the centre of the rod, its angle, the piston, the crank."""
        angle = self.drawn + turn
        slope = math.asin(-self.crank * math.sin(angle) / self.rod)
        rate = -self.crank * math.cos(angle) / (self.rod * math.cos(slope))
        pin = self.crank * cmath.exp(1j * angle)
        moved = 1j * pin
        rod = self.rod * cmath.exp(1j * slope)
        return (moved + 0.3 * 1j * rate * rod, rate, moved + 1j * rate * rod,
                1j * complex(-0.006, -0.008) * cmath.exp(1j * turn))

    def inertia(self, turn: float) -> float:
        centre, rate, piston, crank = self.rates(turn)
        return (1.2 * abs(crank) ** 2 + 0.0015 + 0.6 * abs(centre) ** 2 + 0.0025 * rate ** 2
                + 0.5 * abs(piston) ** 2)

    def potential(self, turn: float) -> float:
        """Weights along -y."""
        angle = self.drawn + turn
        return 9.81 * (1.2 * (complex(-0.006, -0.008) * cmath.exp(1j * turn)).imag
                       + 0.6 * 0.7 * self.crank * math.sin(angle))


def as_list(value: float | list) -> list:
    return value if isinstance(value, list) else [value]


class DynamicsTest(unittest.TestCase):
    def near(self, actual: float | None, expected: float, scale: float, what: str) -> None:
        self.assertIsNotNone(actual, what)
        self.assertLessEqual(abs(actual - expected), TOLERANCE * max(scale, 1e-300),
                             f"{what}: {actual} is not {expected}")

    def near_all(self, actual: list, expected: list, what: str) -> None:
        self.assertEqual(len(actual), len(expected), what)
        scale = max(abs(x) for x in expected)
        for a, e in zip(actual, expected):
            self.near(a, e, max(scale, 1.0), what)

    def check_wrench(self, motion: Motion, step: int, name: str, expected: list) -> None:
        """Planar [Tz, Fx, Fy] or spatial [T, F]; moments and forces are kinds of their own."""
        planar = len(expected) == 3
        moments, forces = (expected[:1], expected[1:]) if planar else (expected[:3], expected[3:])
        for kind, axes, values in (("moment", "z" if planar else "xyz", moments),
                                   ("force", "xy" if planar else "xyz", forces)):
            self.near_all([motion[f"{name}/{kind}/{axis}"][step] for axis in axes], values,
                          f"{name} {kind} at step {step}")

    def check_row(self, case: dict, motion: Motion, step: int) -> None:
        row = case["expected"]["rows"][step]
        what = f"{case['id']} step {step} "
        self.near(motion["time"][step], row["time"], 1.0, what + "time")
        for drive, value in row["drive"].items():
            self.near(motion[f"{drive}/drive"][step], value, max(abs(value), 1.0), what + drive)
        largest = max(abs(x) for x in row["action"].values())
        for actuator, value in row["action"].items():
            self.near(motion[f"{actuator}/action"][step], value, largest, what + actuator)
        self.check_wrench(motion, step, "ground", row["ground"])
        self.check_wrench(motion, step, "shaking", row["shaking"])
        energy = row["kinetic_energy"]
        self.near(motion["kinetic_energy"][step], energy, energy, what + "energy")
        rate = row["kinetic_energy_rate"]
        self.near(motion["kinetic_energy_rate"][step], rate,
                  max(abs(rate), energy), what + "energy rate")
        for d, drive in enumerate(row["drive"]):
            mass = row["mass_matrix"][d][d]
            bias = row["bias"][d]
            turns = f"{drive}/inertia" in motion.names
            self.near(motion[f"{drive}/{'inertia' if turns else 'mass'}"][step], mass, mass,
                      what + "equivalent inertia")
            self.near(motion[f"{drive}/bias_{'moment' if turns else 'force'}"][step], bias,
                      max(abs(x) for x in row["bias"] + [largest]), what + "bias")
        for body, expected in row["bodies"].items():
            angular = as_list(expected["angular_acceleration"])
            axes = "z" if len(angular) == 1 else "xyz"
            self.near_all([motion[f"{body}/angular_acceleration/{axis}"][step] for axis in axes],
                          angular, what + body)

    def check_drawn(self, case: dict) -> None:
        """Everything of the first row, whose position is drawn."""
        row = case["expected"]["rows"][0]
        report = program.run("analyze", "-", text=case["yaml"])
        one = report["cases"]["running"]
        planar = report["mechanism"]["space"] == "planar"
        for coupling, expected in row["wrench"].items():
            actual = one["statics"]["couplings"][coupling]["wrench"]
            if planar:
                actual = [actual[2], actual[3], actual[4]]
            split = 1 if planar else 3
            self.near_all(actual[:split], expected[:split], coupling)
            self.near_all(actual[split:], expected[split:], coupling)
        for body, expected in row["bodies"].items():
            actual = one["dynamics"]["bodies"][body]
            size = len(expected["centre_acceleration"])
            self.near_all(actual["centre_acceleration"][:size], expected["centre_acceleration"],
                          body)
        self.assertLessEqual(one["dynamics"]["two_ways"], 1e-12)

    def test_motor_with_masses_in_every_row(self) -> None:
        for name in ("slider_crank_engine", "four_bar_masses", "four_bar_balanced", "quick_return",
                     "watt_six_bar", "rssr", "cardan_shaft", "gyroscope", "stewart_platform"):
            case = CASES[name]
            with self.subTest(name):
                motion = motion_of(case)
                self.assertGreaterEqual(len(motion.rows), len(case["expected"]["rows"]))
                for step in range(len(case["expected"]["rows"])):
                    self.check_row(case, motion, step)
                self.check_drawn(case)

    def test_friction_by_what_presses_with_inertia(self) -> None:
        """Nine scalar equations, solved to 1e-36."""
        case = CASES["slider_crank_friction"]
        motion = motion_of(case)
        for row in case["expected"]["rows"]:
            step = round(row["time"] / 0.01)
            self.near(motion["motor/drive"][step], row["turn"], 1.0, "turn")
            self.near(motion["motor/action"][step], row["torque"], 100.0, "torque")
            for coupling, bearing in row["bearing"].items():
                for axis, value in zip("xy", bearing):
                    self.near(motion[f"{coupling}.R{axis}/action"][step], value, 1000.0, coupling)

    def test_spring_of_a_cam_follower(self) -> None:
        """Follower lift y = e sin + distance of centres, by hand; the spring is on a freedom."""
        case = CASES["cam_return_spring"]
        motion = motion_of({**case, "yaml": case["yaml"].replace(
            "report: [acceleration, action, dynamics]", "report: [position, velocity, acceleration, action]")})
        contact = next(name for name in motion.names if re.match(r"c\.\w+/action", name))
        for row in case["expected"]["rows"]:
            step = round(row["turn_deg"] / 30)
            what = f"cam at {row['turn_deg']} deg: "
            self.near(motion["g.vy/position"][step], row["lift"], 0.1, what + "lift")
            self.near(motion["g.vy/velocity"][step], row["velocity"], 1.0, what + "velocity")
            self.near(motion["g.vy/acceleration"][step], row["acceleration"], 100.0, what + "bend")
            self.near(abs(motion[contact][step]), row["contact"], 300.0, what + "contact")
            self.near(motion["motor/action"][step], row["torque"], 10.0, what + "torque")

    def test_gas_spring_and_damper_of_a_hatch(self) -> None:
        """Equilibrium of the lid alone, with the law of the drive in closed form."""
        case = CASES["hatch_gas_spring"]
        motion = motion_of({**case, "yaml": case["yaml"].replace(
            "report: [action, dynamics]", "report: [velocity, acceleration, action]")})
        for row, step in zip(case["expected"]["rows"], (0, 6, 16, 25, 34, 44, 50)):
            what = f"hatch after {row['time']} s: "
            self.near(motion["time"][step], row["time"], 1.0, what + "time")
            self.near(motion["hand/drive"][step], row["turn"], 1.0, what + "turn")
            self.near(motion["h.wz/velocity"][step], row["speed"], 1.0, what + "speed")
            self.near(motion["h.wz/acceleration"][step], row["acceleration"], 1.0, what + "bend")
            self.near(motion["hand/action"][step], row["torque"], 100.0, what + "torque")
            for axis, value in zip("xy", row["hinge"]):
                self.near(motion[f"h.R{axis}/action"][step], value, 1000.0, what + "hinge")

    def test_shaking_of_an_engine_by_orders(self) -> None:
        """Orders of the force on the frame, from 140 bits; of odd orders above 1 there is nothing."""
        case = CASES["slider_crank_engine"]
        whole = whole_of(without_gas(case["yaml"]), "{harmonics: 6, balance: {bodies: [crank]}}")
        cycle = case["expected"]["cycle"]
        largest = max(x for row in cycle["harmonics"] for x in row[1:])
        for order, *amplitudes in cycle["harmonics"]:
            for axis, amplitude in zip("xy", amplitudes):
                found = whole["harmonics"][f"shaking/force/{axis}"]["orders"][str(order)]
                self.near(found["force"], amplitude, largest, f"order {order} {axis}")
        # The first order has its greatest value along x where the crank stands on the left.
        first = whole["harmonics"]["shaking/force/x"]["orders"]["1"]
        self.near(first["phase"], -Engine.drawn, 1.0, "phase")

    def test_counterweight_of_an_engine(self) -> None:
        """Half of what goes to and fro, all that goes round: of the least mean square."""
        case = CASES["slider_crank_engine"]
        balance = whole_of(without_gas(case["yaml"]), "{balance: {bodies: [crank]}}")["balance"]
        expected = case["expected"]["cycle"]["counterweight"]
        weight = balance["counterweights"]["crank"]
        self.near_relative(weight["along"][:2], expected["mass_radius"], "counterweight")
        # The rod as two masses: 0.7 of it at the crank.
        round_and_round = 0.7 * 0.6 * Engine.crank - 1.2 * abs(complex(-0.006, -0.008))
        to_and_fro = (0.3 * 0.6 + 0.5) * Engine.crank
        self.near(weight["mass_radius"], round_and_round + to_and_fro / 2, 0.01, "half rule")
        self.near(weight["angle"], Engine.drawn - math.pi, 1.0, "opposite to the crank")
        self.near(balance["before"]["rms"], expected["rms_before"], 1000.0, "before")
        self.near(balance["after"]["rms"], expected["rms_left"], 1000.0, "after")

    def near_relative(self, actual: list, expected: list, what: str) -> None:
        scale = max(abs(x) for x in expected)
        for a, e in zip(actual, expected):
            self.near(a, e, scale, what)

    def test_nothing_is_left_of_a_rotor_with_its_counterweight(self) -> None:
        text = """kinestat: 1
space: planar
ground: frame
bodies: {rotor: {mass: 2, centre_of_mass: [0.3, 0.14], inertia: 0.1}}
couplings: {a: {type: revolute, bodies: [frame, rotor], at: [0.1, 0.2]}}
actuators: {motor: {coupling: a}}
cases: {running: {motion: {motor: 10}, acceleration: {motor: 3}, action: {}}}
motion: {drive: motor, time: 0.4 s, steps: 7, case: running}
"""
        balance = whole_of(text, "{balance: {bodies: rotor}}")["balance"]
        self.near_relative(balance["counterweights"]["rotor"]["along"], [-0.4, 0.12, 0.0], "rotor")
        # 2 kg at 0.2088 m, with a speed that grows from 10 to 11.2 rad/s.
        squares = ((10.0 + 3.0 * t) ** 4 + 9.0 for t in (0.4 * (i + 0.5) / 4000 for i in range(4000)))
        rms = 2 * math.hypot(0.2, 0.06) * math.sqrt(sum(squares) / 4000)
        self.assertLess(abs(balance["before"]["rms"] / rms - 1), 1e-7)
        self.assertEqual(balance["after"]["rms"], 0.0)
        self.assertEqual(balance["after"]["greatest"], 0.0)

    def test_table_balances_what_it_carries(self) -> None:
        """A gimbal of 3 kg and a rotor of 8 kg at 0.4 m, this 0.02 m aside; the tilt is small."""
        balance = whole_of(CASES["gyroscope"]["yaml"], "{balance: {bodies: table}}")["balance"]
        along = balance["counterweights"]["table"]["along"]
        for value, expected in zip(along, (-11 * 0.4, -8 * 0.02, 0.0)):
            self.assertLess(abs(value - expected), 5e-3)
        self.assertLess(balance["after"]["rms"], 0.002 * balance["before"]["rms"])

    def test_nothing_to_add_to_a_balanced_four_bar(self) -> None:
        """Berkof and Lowen: its centre of mass rests."""
        whole = whole_of(CASES["four_bar_balanced"]["yaml"],
                         "{harmonics: 3, balance: {bodies: [crank, rocker]}}")
        for body in ("crank", "rocker"):
            self.assertLessEqual(whole["balance"]["counterweights"][body]["mass_radius"], 1e-12)
        self.assertEqual(whole["balance"]["before"]["rms"], 0.0)
        for axis in "xy":
            self.assertEqual([one["force"] for one in
                              whole["harmonics"][f"shaking/force/{axis}"]["orders"].values()],
                             [0.0] * 3)

    def test_four_bar_is_balanced_again(self) -> None:
        """Less mass on crank and rocker: what Berkof and Lowen ask for comes out."""
        text = CASES["four_bar_balanced"]["yaml"]
        text = text.replace("{mass: 1.0, centre_of_mass: [-0.012, -0.016]",
                            "{mass: 1.0, centre_of_mass: [-0.002, -0.011]")
        text = text.replace("{mass: 1.6, centre_of_mass: [0.1625, -0.025]",
                            "{mass: 1.6, centre_of_mass: [0.16, 0.015]")
        balance = whole_of(text, "{balance: {bodies: [crank, rocker]}}")["balance"]
        weights = balance["counterweights"]
        self.near_relative(weights["crank"]["along"], [-0.010, -0.005, 0.0], "crank")
        self.near_relative(weights["rocker"]["along"], [0.004, -0.064, 0.0], "rocker")
        self.assertGreater(balance["before"]["rms"], 10.0)
        self.assertLessEqual(balance["after"]["rms"], 1e-8)

    def test_flywheel_of_an_engine_without_gas(self) -> None:
        """Its energy is 1/2 M w^2 + V, and with the flywheel 1/2 (M + J) w^2 + V stays the same."""
        engine = Engine()
        text = without_gas(CASES["slider_crank_engine"]["yaml"])
        wheel = whole_of(text, "{flywheel: {at: motor, fluctuation: 0.02}}")["flywheel"]
        low, high = found_range(
            lambda turn: 0.5 * 300 ** 2 * engine.inertia(turn) + engine.potential(turn))
        self.near(wheel["energy_fluctuation"], high - low, high - low, "energy")
        self.near(wheel["inertia"], (high - low) / (0.02 * 300 ** 2), 0.1, "inertia")
        self.near(wheel["mean_moment"], 0.0, 100.0, "mean")
        self.assertEqual(wheel["speed"], 300.0)
        places = [2 * math.pi * i / 720 for i in range(720)]

        def square(energy: float, turn: float) -> float:
            return (2 * (energy - engine.potential(turn))
                    / (engine.inertia(turn) + wheel["inertia"]))

        def mean_speed(energy: float) -> float:
            return 720 / sum(1 / math.sqrt(square(energy, turn)) for turn in places)

        low_energy, high_energy = 500.0, 5000.0
        for _ in range(200):
            energy = (low_energy + high_energy) / 2
            low_energy, high_energy = ((energy, high_energy) if mean_speed(energy) < 300
                                       else (low_energy, energy))
        least, greatest = found_range(lambda turn: square(energy, turn))
        speed = wheel["with_it"]
        self.near(speed["least"], math.sqrt(least), 300.0, "least speed")
        self.near(speed["greatest"], math.sqrt(greatest), 300.0, "greatest speed")
        self.near(speed["fluctuation"], (math.sqrt(greatest) - math.sqrt(least)) / 300, 1.0,
                  "fluctuation")
        for turn, value in ((speed["least_at"], least), (speed["greatest_at"], greatest)):
            self.near(square(energy, turn), value, value, "place")

    def test_flywheel_of_an_engine_with_gas(self) -> None:
        """Torque from 140 bits, the force of the gas linear between its points."""
        case = CASES["slider_crank_engine"]
        if "curves" not in json.loads(program.plain("schema").stdout)["properties"]:
            self.skipTest("no force over a position is known")
        cycle = case["expected"]["cycle"]
        wheel = whole_of(case["yaml"], "{flywheel: {at: motor, fluctuation: 0.02}}")["flywheel"]
        self.near(wheel["mean_moment"], cycle["mean_torque"], 100.0, "mean")
        energy = cycle["energy_fluctuation"]
        self.near(wheel["energy_fluctuation"], energy, energy, "energy")
        inertia = cycle["flywheel"]["inertia"]
        self.near(wheel["inertia"], inertia, inertia, "inertia")
        expected = cycle["speed_with_flywheel"]
        speed = wheel["with_it"]
        self.near(speed["greatest"], expected["largest"], 300.0, "greatest")
        self.near(speed["least"], expected["least"], 300.0, "least")
        self.near(speed["fluctuation"], expected["fluctuation"], 1.0, "fluctuation")
        self.assertLess(abs(speed["greatest_at"] - expected["at"]), 1e-6)
        self.assertLess(abs(speed["least_at"] - expected["at_least"]), 1e-6)

    def test_flywheel_against_friction_that_turns_round(self) -> None:
        """A couple of 5 N*m in the pin of the ram, against the way that the rod turns there."""
        text = """kinestat: 1
space: planar
ground: frame
bodies: {crank: {mass: 1, centre_of_mass: [0, 0], inertia: 0.1}, rod: , ram: }
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0.03, 0.04]}
  c: {type: revolute, bodies: [rod, ram], at: [0.21, 0], friction: {tau: 5}}
  d: {type: prismatic, bodies: [frame, ram], at: [0.21, 0], axis: x}
actuators: {motor: {coupling: a}}
cases: {running: {motion: {motor: 20}, acceleration: {}, action: {}}}
motion: {drive: motor, to: 360 deg, steps: 20, case: running}
"""
        wheel = whole_of(text, "{flywheel: {at: motor, fluctuation: 0.01}}")["flywheel"]
        engine = Engine()
        half = math.asin(engine.crank / engine.rod)  # how far the rod turns from the guide
        mean = 5 * 4 * half / (2 * math.pi)

        def turned(angle: float) -> float:
            """The way of the rod since the crank pointed along the guide."""
            quarter, rest = divmod(angle, math.pi / 2)
            way = math.asin(engine.crank / engine.rod * math.sin(rest))
            back = half - math.asin(engine.crank / engine.rod * math.cos(rest))
            return quarter * half + (back if quarter % 2 else way)

        def surplus(angle: float) -> float:
            return 5 * turned(angle) - mean * angle

        low, high = found_range(surplus)
        self.near(wheel["mean_moment"], mean, mean, "mean")
        self.assertLess(abs(wheel["energy_fluctuation"] / (high - low) - 1), 1e-8)
        # Friction hangs on the place alone here, so that the speed is known.
        added = wheel["inertia"] + 0.1
        places = [2 * math.pi * (i + 0.5) / 20000 for i in range(20000)]
        energy = 0.5 * added * 400
        for _ in range(20):
            speeds = [math.sqrt(2 * (energy - surplus(place)) / added) for place in places]
            energy *= (20 * sum(1 / speed for speed in speeds) / 20000) ** 2
        for key, bound in (("least", high), ("greatest", low)):
            expected = math.sqrt(2 * (energy - bound) / added)
            self.assertLess(abs(wheel["with_it"][key] / expected - 1), 1e-7, key)

    def test_flywheel_on_a_geared_shaft(self) -> None:
        """At three times the speed a ninth of the inertia, and the same speed with it."""
        text = without_gas(CASES["slider_crank_engine"]["yaml"])
        geared = text.replace("bodies:\n", "bodies:\n  fast: {inertia: 0}\n", 1)
        geared = geared.replace("couplings:\n", """couplings:
  f: {type: revolute, bodies: [frame, fast], at: [0, 0.4]}
  m: {type: gear, bodies: [crank, fast], at: [0, 0.3], tangent: x, pressure_angle: 20 deg}
""", 1).replace("actuators:\n", "actuators:\n  shaft: {coupling: f}\n", 1)
        geared = geared.replace("press: 0}", "press: 0, shaft: 0}")
        slow, fast = (whole_of(one, f"{{flywheel: {{at: {at}, fluctuation: 0.02}}}}")["flywheel"]
                      for one, at in ((text, "motor"), (geared, "shaft")))
        self.near(abs(fast["speed"]), 900.0, 900.0, "speed")
        self.near(fast["inertia"], slow["inertia"] / 9, 0.1, "inertia")
        self.near(fast["with_it"]["fluctuation"], slow["with_it"]["fluctuation"], 1.0, "speed")

    def test_speed_at_which_a_cam_lets_go(self) -> None:
        case = CASES["cam_return_spring"]
        expected = case["expected"]
        for label in ("slow", "fast"):
            text = case["yaml"].replace("case: slow", f"case: {label}")
            limit = whole_of(text, "{limit_speed: c}")["limit_speed"]["c.R"]
            self.assertEqual(limit["coupling"], "c")
            critical = expected["critical_speed"]
            self.near(limit["angular_velocity"], critical["rad_s"], critical["rad_s"], label)
            self.assertLess(abs(limit["at"] - critical["turn"]), 1e-6)
            report = program.run("motion", "-", text=text)["motion"]
            key = "least_contact_600rpm" if label == "slow" else "at_2600rpm"
            least = expected[key].get("force", expected[key].get("least"))
            self.assertLess(abs(report["figures"]["c.R/action"]["least"] - least), 1e-6)

    def test_no_flywheel_where_there_is_no_cycle(self) -> None:
        text = without_gas(CASES["slider_crank_engine"]["yaml"])
        wheel = "dynamics: {flywheel: {at: motor, fluctuation: 0.02}, harmonics: 2}\n"
        for change, reason in (
                (("to: 360 deg", "to: 300 deg"), "turns, and a cycle has whole ones"),
                (("motor: 0}", "motor: 5}"), "does not run at a steady speed"),
                (("action: {press: 0}", "action: {}"), "both 'motor' and 'press' could drive"),
                (("at: motor", "at: press"), "which slides"),
                (("acceleration: {motor: 0}, ", ""), "lacks 'acceleration'")):
            with self.subTest(change):
                done = program.call("motion", "-", text=(text + wheel).replace(*change, 1))
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(reason, done.stderr)

    def test_lift(self) -> None:
        """m (g + a) on both sides of the drum."""
        expected = CASES["lift"]["expected"]
        report = program.run("analyze", "-", text=CASES["lift"]["yaml"])["cases"]["starting"]
        actions = report["statics"]["actions"]
        self.near(actions["rope_1.F"], expected["tension_car"], 1e4, "car")
        self.near(actions["rope_2.F"], expected["tension_counterweight"], 1e4, "counterweight")
        self.near(actions["a.Ry"], expected["bearing_Ry_with_drum"], 1e4, "bearing")
        self.near(actions["motor"], expected["motor"], 1e3, "motor")
        reduced = report["dynamics"]["reduced"]
        mass = next(iter(reduced.values()))["mass"]
        self.near(mass * 0.25 ** 2, expected["reflected_inertia"], 100.0, "reflected inertia")

    def test_belt_drive(self) -> None:
        expected = CASES["belt_drive"]["expected"]
        report = program.run("analyze", "-", text=CASES["belt_drive"]["yaml"])["cases"]["starting"]
        actions = report["statics"]["actions"]
        self.near(actions["in"], expected["torque_in"], 10.0, "torque")
        self.near(actions["belt_2.F"], expected["belt_2.F"], 1e3, "belt")
        self.near(report["dynamics"]["reduced"]["a.wz"]["inertia"], expected["reflected_inertia"],
                  1.0, "reflected inertia")
        self.near(report["dynamics"]["bodies"]["driven"]["angular_acceleration"][2],
                  expected["acceleration_out"], 100.0, "acceleration")

    def test_laws(self) -> None:
        """Range and time of one: columns are the shares themselves."""
        text = CASES["drive_laws"]["yaml"]
        for law in CASES["drive_laws"]["expected"]["laws"]:
            word = law["law"].replace("poly", "polynomial_")
            with self.subTest(word):
                one = text.replace("law: polynomial_345", f"law: {word}")
                one = one.replace("case: turning", "case: turning, report: [position, velocity, "
                                  "acceleration]")
                motion = Motion(program.run("motion", "-", text=one))
                for u, share, slope, bend in law["values"]:
                    step = round(20 * u)
                    self.near(motion["a.wz/position"][step], share, 0.01, f"s({u})")
                    self.near(motion["a.wz/velocity"][step], slope, 0.01, f"s'({u})")
                    self.near(motion["a.wz/acceleration"][step], bend, 0.01, f"s''({u})")

    def test_drive_by_a_spline_through_a_table(self) -> None:
        """Tridiagonal moments in 40 digits, and CubicSpline of SciPy."""
        case = CASES["drive_table"]
        tolerance = case["tolerance"]["relative"]
        for spline in case["expected"]["splines"]:
            ends = spline["ends"]
            points = ", ".join(f"[{t} s, {x} rad]" for t, x in spline["points"])
            last = spline["points"][-1][0]
            steps = round(last / 0.01)
            text = re.sub(r"points: \[.*\]\], ", f"points: [{points}], ", case["yaml"])
            text = text.replace("ends: rest", f"ends: {ends}").replace("steps: 12", f"steps: {steps}")
            text = text.replace("case: turning", "case: turning, report: [position, velocity, "
                                f"acceleration], time: {last} s")
            with self.subTest(ends):
                motion = Motion(program.run("motion", "-", text=text))
                columns = [motion[f"a.wz/{quantity}"]
                           for quantity in ("position", "velocity", "acceleration")]
                scales = [max(abs(value) for value in column) for column in columns]
                for time, *values in spline["values"]:
                    step = round(time / 0.01)
                    self.near(motion["time"][step], time, 1.0, "time")
                    for column, scale, value in zip(columns, scales, values):
                        self.assertLessEqual(abs(column[step] - value), tolerance * scale,
                                             f"{ends} at {time} s: {column[step]} is not {value}")

    def test_equivalent_inertia_of_gears(self) -> None:
        """Fractions, by the speeds of Willis' equations."""
        text = CASES["ravigneaux_inertia"]["yaml"].replace(" input_acceleration: 200 rad/s^2,", "")
        states = program.run("shift", "-", text=text)["shift"]["states"]
        for name, gear in CASES["ravigneaux_inertia"]["expected"]["gears"].items():
            self.near(states[name]["equivalent_inertia"], gear["equivalent_inertia_value"], 0.01,
                      name)
            self.near(sum(states[name]["inertia_shares"].values()), 1.0, 1.0, name)

    def test_torques_of_gears_that_speed_up(self) -> None:
        text = CASES["ravigneaux_inertia"]["yaml"]
        text = re.sub(r"^shift:.*$", "", text, flags=re.M).replace("loads: {}", "")
        for name, gear in CASES["ravigneaux_inertia"]["expected"]["gears"].items():
            engaged = ", ".join(f"{element}: 0" for element in gear["engaged"])
            opened = ", ".join(f"{e}: 0" for e in ("C1", "C2", "B1", "B2") if e not in gear["engaged"])
            case = (f"cases: {{gear: {{motion: {{in: 100, {engaged}}}, acceleration: {{in: 200}}, "
                    f"action: {{out: {gear['out']}, {opened}}}}}}}\n")
            report = program.run("analyze", "-", text=text + case)["cases"]["gear"]
            actions = report["statics"]["actions"]
            self.near(actions["in"], gear["torque_in_value"], 100.0, name)
            for element, torque in gear["elements"].items():
                self.near(abs(actions[element]), abs(torque), 100.0, f"{name} {element}")
            for mesh, force in gear["mesh"].items():
                # Tangential: the planets stand on +y.
                self.near(report["statics"]["couplings"][mesh]["wrench"][3], force, 1e3,
                          f"{name} {mesh}")


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
