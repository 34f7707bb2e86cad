#!/usr/bin/env python3
"""Overall results of a motion with inertia: flywheels, harmonics, counterweights, limit speeds,
against closed forms and the cases of dynamics.json.

Usage: cycle_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import cmath
import json
import math
import re
import sys
import unittest

import program
from dynamics_case import CASES, DynamicsCase


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


class CycleTest(DynamicsCase):
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
        self.assertEqual(balance["counterweights"]["rotor"]["unit"], "kg*m")
        small = whole_of(text.replace("ground:", "units: {mass: g, length: cm}\nground:"),
                         "{balance: {bodies: rotor}}")["balance"]["counterweights"]["rotor"]
        self.near_relative(small["along"], [-0.4, 0.12, 0.0], "in g*cm")
        self.assertEqual(small["unit"], "g*cm")
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

    def test_flywheel_of_a_machine_without_masses(self) -> None:
        """A couple of 10 N*m, and a triangle of 20 more over half a turn: the excess over the mean
        of 15 is a triangle of 15 over three quarters of that half."""
        text = """kinestat: 1
space: planar
ground: frame
bodies: [crank]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
actuators: {motor: {coupling: a}}
curves:
  work: {over: motor, period: 360 deg,
         points: [[0 deg, 10 N*m], [90 deg, 30 N*m], [180 deg, 10 N*m], [360 deg, 10 N*m]]}
loads: {tool: {body: crank, couple: -work}}
cases: {running: {motion: {motor: 10}, acceleration: {}, action: {}}}
motion: {drive: motor, to: 360 deg, steps: 72, case: running}
"""
        whole = whole_of(text, "{flywheel: {at: motor, fluctuation: 0.02}, actuators: [motor], "
                               "harmonics: 1}")
        wheel, energy = whole["flywheel"], 0.5 * 15 * 0.75 * math.pi
        self.near(wheel["mean_moment"], 15.0, 15.0, "mean")
        self.near(wheel["energy_fluctuation"], energy, energy, "energy")
        self.near(wheel["inertia"], energy / (0.02 * 100), energy, "inertia")
        # With it the squares of the speeds differ by 2 E / J, whatever they are.
        speeds = wheel["with_it"]
        self.near(speeds["greatest"] ** 2 - speeds["least"] ** 2, 4.0, 100.0, "speeds")
        self.near(whole["actuators"]["motor"]["energy_in"], 30 * math.pi, 100.0, "work")
        done = program.call("motion", "-", text=text + "dynamics: {balance: {bodies: [crank]}}\n")
        self.assertEqual(done.returncode, 5)
        self.assertIn("no counterweights: no body has mass", done.stderr)

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
                (("to: 360 deg", "to: 300 deg"), "turns; a cycle needs whole turns"),
                (("motor: 0}", "motor: 5}"), "does not run at a steady speed"),
                (("action: {press: 0}", "action: {}"), "both 'motor' and 'press' could drive"),
                (("at: motor", "at: press"), "which slides"),
                (("acceleration: {motor: 0}, ", ""), "lacks 'acceleration'")):
            with self.subTest(change):
                done = program.call("motion", "-", text=(text + wheel).replace(*change, 1))
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(reason, done.stderr)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
