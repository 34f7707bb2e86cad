#!/usr/bin/env python3
"""Simulations against closed forms, other integrators, and the laws of energy.

simulation.json has the expected numbers with the two ways by which each was found. The rest is by
closed forms and by Runge and Kutta's method here, on equations that are written down anew.

Usage: simulation_test.py KINESTAT
"""

from __future__ import annotations

import json
import math
import random
import re
import sys
import unittest
from pathlib import Path

import program

CASES = json.loads(Path(__file__).with_name("simulation.json").read_text(encoding="utf-8"))["cases"]

SQUEEZER = Path(__file__).resolve().parents[2] / "mechanisms" / "planar" / "squeezer.yaml"

PENDULUM = """
kinestat: 1
space: planar
ground: frame
bodies: {rod: {mass: 2, centre_of_mass: [0, -0.5], inertia: 0.1}}
gravity: [0, -9.81]
couplings: {a: {type: revolute, bodies: [frame, rod], at: [0, 0]}}
actuators: {pivot: {coupling: a}}
simulation: {action: {pivot: 0}, start: {pivot: {position: 120 deg, speed: 0}}, time: 10 s,
             steps: 40, tolerance: 1e-11}
"""

DOUBLE_PENDULUM = """
kinestat: 1
space: planar
ground: frame
bodies: {upper: {mass: 1.2, centre_of_mass: [0, -0.2], inertia: 0.02},
         lower: {mass: 0.8, centre_of_mass: [0, -0.55], inertia: 0.01}}
gravity: [0, -9.81]
couplings: {a: {type: revolute, bodies: [frame, upper], at: [0, 0]},
            b: {type: revolute, bodies: [upper, lower], at: [0, -0.4]}}
actuators: {A: {coupling: a}, B: {coupling: b}}
simulation: {action: {A: 0, B: 0}, start: {A: {position: 60 deg}, B: {position: -80 deg}},
             time: 3 s, steps: 6, tolerance: 1e-12}
"""

SLIDER_CRANK = """
kinestat: 1
space: planar
ground: frame
bodies:
  crank: {mass: 1.2, centre_of_mass: [-0.006, -0.008], inertia: 0.0015}
  rod: {mass: 0.6, centre_of_mass: [0.084, 0.028], inertia: 0.0025}
  piston: {mass: 0.5, centre_of_mass: [0.21, 0], inertia: 0.0004}
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0.03, 0.04]}
  c: {type: revolute, bodies: [rod, piston], at: [0.21, 0]}
  d: {type: prismatic, bodies: [frame, piston], at: [0.21, 0], axis: x}
loads: {push: {body: piston, at: [0.21, 0], force: [-30, 0]}}
actuators: {motor: {coupling: a}}
simulation: {action: {motor: 4}, until: {motor: {position: TURN deg}}, time: 0.2 s, steps: 200,
             tolerance: 1e-11}
"""

BOUNCE = """
kinestat: 1
space: planar
ground: frame
bodies: {block: {mass: 1, centre_of_mass: [0, 0.8]}}
gravity: [0, -9.81]
couplings: {g: {type: prismatic, bodies: [frame, block], at: [0, 0.8], axis: y}}
actuators: {hand: {coupling: g}}
simulation: {action: {hand: 0}, stops: {hand: {from: -0.8, restitution: 0.7}}, time: 3 s,
             steps: 30, tolerance: 1e-12}
"""

FLYWHEELS = """
kinestat: 1
space: spatial
ground: frame
bodies: {shaft: {inertia: {polar: 0.3, axis: z}}, disc: {inertia: {polar: 1.2, axis: z}}}
couplings:
  a: {type: revolute, bodies: [frame, shaft], at: [0, 0, 0], axis: z}
  b: {type: revolute, bodies: [frame, disc], at: [0, 0, 0.1], axis: z}
  C: {type: clutch, bodies: [shaft, disc], at: [0, 0, 0.05], axis: z}
actuators: {in: {coupling: a}, out: {coupling: b}}
simulation: {action: {in: 0, out: 0, C: 80}, start: {in: {speed: 200}, C: {speed: -150}},
             until: {C: {speed: 0}}, time: 2 s}
"""

FOUR_BAR = """
kinestat: 1
space: planar
ground: frame
bodies:
  crank: {mass: 1.0, centre_of_mass: [0.05, 0], inertia: 0.001}
  coupler: {mass: 1.5, centre_of_mass: [0.2, 0.13], inertia: 0.02}
  rocker: {mass: 1.2, centre_of_mass: [0.35, 0.12], inertia: 0.01}
gravity: [0, -9.81]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [0.1, 0]}
  c: {type: revolute, bodies: [coupler, rocker], at: [0.32, 0.25]}
  d: {type: revolute, bodies: [frame, rocker], at: [0.4, 0]}
actuators: {motor: {coupling: a}, lever: {coupling: d}}
simulation: {action: {motor: 0, lever: 0}, start: START, time: TIME, steps: STEPS}
"""

OSCILLATOR = """
kinestat: 1
space: planar
ground: frame
bodies: {block: {mass: 2, centre_of_mass: [0, 0]}}
couplings: {g: {type: prismatic, bodies: [frame, block], at: [0, 0], axis: x}}
springs: {s: {coupling: g, stiffness: 200 N/m, free: 0, damping: 4 N*s/m}}
actuators: {hand: {coupling: g}}
simulation: {action: {hand: 0}, start: {hand: {position: 0.1, speed: 0}}, time: 2 s, steps: 20,
             tolerance: 1e-11}
"""

MOTOR = """
kinestat: 1
space: planar
ground: frame
bodies: {rotor: {mass: 1, centre_of_mass: [0, 0], inertia: 0.5}}
couplings: {a: {type: revolute, bodies: [frame, rotor], at: [0, 0], friction: {c: 0.25}}}
actuators: {motor: {coupling: a}}
curves: {torque: {over: motor.speed, points: [[0 rad/s, 10 N*m], [40 rad/s, 0 N*m]], between: linear}}
simulation: {action: {motor: torque}, time: 3 s, steps: 30, tolerance: 1e-11}
"""

BELT = """
kinestat: 1
space: planar
ground: frame
bodies: {belt: {}, block: {mass: 1.5, centre_of_mass: [0, 0], inertia: 0.001}}
couplings:
  run: {type: prismatic, bodies: [frame, belt], at: [0, 0], axis: x}
  rub: {type: prismatic, bodies: [belt, block], at: [0, 0], axis: x, friction: {c: 3}}
springs: {hold: {bodies: [frame, block], at: {frame: [-1, 0], block: [0, 0]}, stiffness: 300 N/m,
                 free_length: 1}}
actuators: {drive: {coupling: run}, slip: {coupling: rub}}
simulation: {motion: {drive: 0.3}, action: {slip: 0}, time: 5 s, steps: 50, tolerance: 1e-11}
"""


class Simulation:
    """The rows of a report by the names of their columns."""

    def __init__(self, text: str, *arguments: str):
        self.report = program.run("simulate", "-", *arguments, text=text)["simulation"]
        names = [column["name"] for column in self.report["columns"]]
        self.columns = {name: [row[i] for row in self.report["rows"]]
                        for i, name in enumerate(names)}
        self.events = self.report["events"]

    def at(self, time: float) -> dict[str, float]:
        row = min(range(len(self.columns["time"])),
                  key=lambda i: abs(self.columns["time"][i] - time))
        assert abs(self.columns["time"][row] - time) < 1e-12
        return {name: values[row] for name, values in self.columns.items()}

    def last(self) -> dict[str, float]:
        return {name: values[-1] for name, values in self.columns.items()}


def runge_kutta(slope, state: list[float], time: float, steps: int) -> list[float]:
    h = time / steps
    for _ in range(steps):
        k1 = slope(state)
        k2 = slope([y + h / 2 * k for y, k in zip(state, k1)])
        k3 = slope([y + h / 2 * k for y, k in zip(state, k2)])
        k4 = slope([y + h * k for y, k in zip(state, k3)])
        state = [y + h / 6 * (a + 2 * b + 2 * c + d)
                 for y, a, b, c, d in zip(state, k1, k2, k3, k4)]
    return state


class SimulationCase(unittest.TestCase):
    def near(self, actual: float, expected: float, tolerance: float, what: str = "") -> None:
        self.assertLessEqual(abs(actual - expected), tolerance, f"{what}: {actual}, {expected}")


class SimulationTest(SimulationCase):
    def test_pendulum_by_elliptic_functions(self) -> None:
        found = Simulation(PENDULUM)
        for row in CASES["pendulum_forward"]["expected"]["rows"]:
            at = found.at(row["time"])
            self.near(at["a.wz/position"], row["angle"], 1e-8 * math.pi, "angle")
            self.near(at["a.wz/velocity"], row["speed"], 1e-8 * 10, "speed")
            self.near(at["a.wz/acceleration"], row["acceleration"], 1e-8 * 20, "acceleration")

    def test_double_pendulum_by_lagrange_and_hamilton(self) -> None:
        found = Simulation(DOUBLE_PENDULUM)
        for row in CASES["double_pendulum_forward"]["expected"]["rows"]:
            at = found.at(row["time"])
            self.near(at["a.wz/position"], row["upper"], 1e-7)
            self.near(at["a.wz/position"] + at["b.wz/position"], row["lower"], 1e-7 * 8)
            self.near(at["a.wz/velocity"], row["upper_speed"], 1e-7 * 10)
            self.near(at["a.wz/velocity"] + at["b.wz/velocity"], row["lower_speed"], 1e-7 * 10)

    def test_slider_crank_from_rest_by_quadrature(self) -> None:
        for row in CASES["slider_crank_forward"]["expected"]["rows"]:
            found = Simulation(SLIDER_CRANK.replace("TURN", str(row["turn_deg"])))
            self.assertEqual(found.report["status"], "goal")
            self.near(found.report["time"], row["time"], 1e-8 * row["time"], "time")
            self.near(found.last()["a.wz/velocity"], row["speed"], 2e-8 * row["speed"], "speed")

    def test_bouncing_mass_by_its_geometric_series(self) -> None:
        found = Simulation(BOUNCE)
        expected = CASES["bouncing_stop"]["expected"]
        impacts = [event for event in found.events if event["kind"] == "impact"]
        for event, (time, speed) in zip(impacts, expected["impacts"]):
            self.near(event["time"], time, 1e-9 * time)
            self.near(-event["speed"], speed, 1e-9 * speed)
            self.near(event["speed_after"], 0.7 * speed, 1e-9 * speed)
        rests = [event for event in found.events if event["kind"] == "rest"]
        self.assertEqual(len(rests), 1)
        self.near(rests[0]["time"], expected["rest_time"], 1e-9 * expected["rest_time"])
        last = found.last()
        self.near(last["g.vy/position"], -0.8, 1e-11)
        self.assertEqual(last["g.vy/velocity"], 0.0)
        self.near(last["energy/lost"], 9.81 * 0.8, 1e-9)

    def test_two_flywheels_that_a_slipping_clutch_joins(self) -> None:
        found = Simulation(FLYWHEELS)
        expected = CASES["two_flywheels"]["expected"]
        self.near(found.report["time"], expected["time"], 1e-10)
        self.near(-found.last()["energy/supplied"], expected["energy"], 1e-6)
        self.near(found.last()["a.wz/velocity"], expected["common_speed"], 1e-8)

    def test_squeezer_of_the_library_at_its_published_end(self) -> None:
        """Mazzia and Magherini, Test Set for IVP Solvers: angles at 0.03 s."""
        last = Simulation(SQUEEZER.read_text(encoding="utf-8")).last()
        for name, begin, end in (
                ("o", -0.0617138900142764496, 15.81077119629904),
                ("p", 0.0, -15.75637105984298),
                ("b", 0.455279819163070380, 0.04082224013073101),
                ("e", 0.222668390165885885, -0.5347301163226948),
                ("a5", 0.487364979543842550, 0.5244099658805304),
                ("h", -0.222668390165885885, 0.5347301163226948),
                ("a7", 1.23054744454982119, 1.048080741042263)):
            self.near(last[f"{name}.wz/position"], end - begin, 1e-8, name)

    def test_energy_and_closure_over_seventy_turns(self) -> None:
        found = Simulation(FOUR_BAR.replace("START", "{motor: {speed: 20 rad/s}}")
                           .replace("TIME", "20 s").replace("STEPS", "100"))
        self.assertGreater(found.last()["a.wz/position"], 70 * 2 * math.pi)
        self.assertLess(found.report["energy_drift"], 1e-6)
        self.assertLess(found.report["closure_error"], 1e-12)

    def test_any_freedom_tells_the_state_through_its_dead_points(self) -> None:
        by_crank = Simulation(FOUR_BAR.replace("START", "{motor: {speed: 20 rad/s}}")
                              .replace("TIME", "2 s").replace("STEPS", "8"))
        speed = by_crank.at(0.0)["d.wz/velocity"]
        by_lever = Simulation(FOUR_BAR.replace("START", f"{{lever: {{speed: {speed!r} rad/s}}}}")
                              .replace("TIME", "2 s").replace("STEPS", "8"))
        self.assertEqual(by_crank.report["coordinates"], ["a.wz"])
        self.assertEqual(by_lever.report["coordinates"], ["d.wz"])
        for name in ("a.wz/position", "d.wz/position", "c.wz/velocity", "energy/kinetic"):
            for one, other in zip(by_crank.columns[name], by_lever.columns[name]):
                self.near(one, other, 2e-6, name)

    def test_rows_do_not_depend_on_their_number(self) -> None:
        text = FOUR_BAR.replace("START", "{motor: {speed: 5 rad/s}}").replace("TIME", "3 s")
        few = Simulation(text.replace("STEPS", "3"))
        many = Simulation(text.replace("STEPS", "300"))
        for time in (1.0, 2.0, 3.0):
            for name in ("a.wz/position", "a.wz/velocity", "d.wz/position"):
                self.near(few.at(time)[name], many.at(time)[name], 2e-6, name)

    def test_damped_spring(self) -> None:
        found = Simulation(OSCILLATOR)
        decay, frequency = 1.0, math.sqrt(200 / 2 - 1.0)
        for time in (0.5, 1.0, 2.0):
            place = 0.1 * math.exp(-decay * time) * (
                math.cos(frequency * time) + decay / frequency * math.sin(frequency * time))
            self.near(found.at(time)["g.vx/position"], place, 1e-10)
        last = found.last()
        self.near(last["energy/lost"] + last["energy/kinetic"] + last["energy/potential"], 1.0, 1e-8)

    def test_motor_along_its_curve_over_speed(self) -> None:
        found = Simulation(MOTOR)
        # J w' = 10 - w/4 - w/4.
        for time in (1.0, 3.0):
            self.near(found.at(time)["a.wz/velocity"], 20 * (1 - math.exp(-time)), 1e-8)

    def test_what_is_held_at_a_speed(self) -> None:
        found = Simulation(BELT)
        # m x'' + c x' + k x = c v, x being the place of the block.
        decay = 3 / (2 * 1.5)
        frequency = math.sqrt(300 / 1.5 - decay ** 2)
        rest = 3 * 0.3 / 300
        for time in (0.5, 2.0, 5.0):
            # It begins at rest on the belt, with its speed.
            a, b = -rest, (0.3 - decay * rest) / frequency
            place = rest + math.exp(-decay * time) * (
                a * math.cos(frequency * time) + b * math.sin(frequency * time))
            at = found.at(time)
            self.near(at["run.vx/position"], 0.3 * time, 1e-12)
            self.near(at["run.vx/position"] + at["rub.vx/position"], place, 1e-9)
            # What drives the belt carries what rubs there.
            self.near(at["drive/action"], -3 * at["rub.vx/velocity"], 1e-8)
        self.assertLess(found.report["energy_drift"], 1e-8)

    def test_random_double_pendulums_by_another_integrator(self) -> None:
        draw = random.Random(20261127)
        for _ in range(3):
            m1, m2 = draw.uniform(0.5, 2), draw.uniform(0.5, 2)
            l1, c1, c2 = draw.uniform(0.3, 0.6), draw.uniform(0.1, 0.3), draw.uniform(0.1, 0.4)
            j1, j2 = draw.uniform(0.005, 0.05), draw.uniform(0.005, 0.05)
            a0, b0 = draw.uniform(-1, 1), draw.uniform(-1, 1)
            torque = draw.uniform(-1, 1)

            def slope(y: list[float]) -> list[float]:
                p, q, u, v = y  # turns of both bodies from hanging, and their speeds
                c, s = math.cos(p - q), math.sin(p - q)
                a = j1 + m1 * c1 * c1 + m2 * l1 * l1
                b = m2 * l1 * c2
                d = j2 + m2 * c2 * c2
                f = -torque - b * s * v * v - 9.81 * (m1 * c1 + m2 * l1) * math.sin(p)
                g = torque + b * s * u * u - 9.81 * m2 * c2 * math.sin(q)
                det = a * d - b * b * c * c
                return [u, v, (d * f - b * c * g) / det, (a * g - b * c * f) / det]

            expected = runge_kutta(slope, [a0, a0 + b0, 0.0, 0.0], 1.0, 20000)
            text = f"""
kinestat: 1
space: planar
ground: frame
bodies: {{upper: {{mass: {m1}, centre_of_mass: [0, {-c1}], inertia: {j1}}},
         lower: {{mass: {m2}, centre_of_mass: [0, {-l1 - c2}], inertia: {j2}}}}}
gravity: [0, -9.81]
couplings: {{a: {{type: revolute, bodies: [frame, upper], at: [0, 0]}},
            b: {{type: revolute, bodies: [upper, lower], at: [0, {-l1}]}}}}
actuators: {{B: {{coupling: b}}}}
simulation: {{action: {{B: {torque}}}, start: {{a.wz: {{position: {a0}}}, B: {{position: {b0}}}}},
             time: 1 s, steps: 1, tolerance: 1e-12}}
"""
            last = Simulation(text).last()
            actual = [last["a.wz/position"], last["a.wz/position"] + last["b.wz/position"],
                      last["a.wz/velocity"], last["a.wz/velocity"] + last["b.wz/velocity"]]
            for one, other in zip(actual, expected):
                self.near(one, other, 1e-8)

    def test_a_stop_lets_go_what_it_would_have_to_pull(self) -> None:
        text = re.sub(r"simulation: .*", "", BOUNCE, flags=re.DOTALL) + """
curves: {pull: {over: time, points: [[0 s, 0 N], [2 s, 19.62 N]], between: linear}}
simulation: {action: {hand: pull}, start: {hand: {position: -0.8}},
             stops: {hand: {from: -0.8}}, time: 2 s, steps: 20, tolerance: 1e-11}
"""
        found = Simulation(text)
        self.assertEqual([event["kind"] for event in found.events], ["rest", "release"])
        self.near(found.events[1]["time"], 1.0, 1e-9)
        # From there on m x'' = 9.81 (t - 1 s)/s.
        self.near(found.last()["g.vy/position"], -0.8 + 9.81 / 6, 1e-9)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
