#!/usr/bin/env python3
"""Loads that turn with their body, against closed forms.

Usage: body_fixed_load_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest

import motion_case
import program
from dynamics_case import DynamicsCase
from simulation_test import Simulation

CRANK = """kinestat: 1
space: planar
ground: frame
bodies: [crank]
couplings: {{a: {{type: revolute, bodies: [frame, crank], at: [0.1, 0.2]}}}}
actuators: {{motor: {{coupling: a}}}}
loads: {{thrust: {{body: crank, at: [0.5, 0.2], force: [0, 20]{frame}}}}}
cases: {{pushed: {{motion: {{motor: 3}}}}}}
motion: {{drive: motor, case: pushed, from: {start}, to: 400 deg, steps: 40,
         report: [action, power]}}
"""

# Turned about z by A, then about the axis that was drawn as x by B: the rotation is Rz(A) Rx(B).
GIMBAL = """kinestat: 1
space: spatial
ground: frame
bodies: [yoke, head]
couplings:
  a: {type: revolute, bodies: [frame, yoke], at: [0, 0, 0], axis: z}
  b: {type: revolute, bodies: [yoke, head], at: [0, 0, 0], axis: x}
actuators: {A: {coupling: a}, B: {coupling: b}}
loads: {jet: {body: head, at: [0.3, 0.2, -0.1], force: [5, -7, 11], couple: [2, 3, -1],
              frame: body}}
cases: {turned: {motion: {A: 1, B: 2}}}
motion: {drives: [{drive: A, to: 200 deg}, {drive: B, to: 300 deg}], case: turned,
         steps: 20, report: [action]}
"""


def about_z(angle: float, v: list[float]) -> list[float]:
    c, s = math.cos(angle), math.sin(angle)
    return [c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]]


def about_x(angle: float, v: list[float]) -> list[float]:
    c, s = math.cos(angle), math.sin(angle)
    return [v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]]


def cross(a: list[float], b: list[float]) -> list[float]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a: list[float], b: list[float]) -> list[float]:
    return [x + y for x, y in zip(a, b)]


class BodyFixedLoadTest(DynamicsCase):
    def test_tangential_force_on_a_crank(self) -> None:
        """In the frame of the crank the torque is F r everywhere, in that of the world F r cos."""
        for frame, share in ((", frame: body", lambda angle: 1.0),
                             (", frame: world", math.cos), ("", math.cos)):
            found = motion_case.run(CRANK.format(frame=frame, start=0))
            for angle, torque, power in zip(found["motor/drive"], found["motor/action"],
                                            found["thrust/power"]):
                self.near(torque, -20 * 0.4 * share(angle), 8, f"{frame} at {angle}")
                self.near(power, 3 * 20 * 0.4 * share(angle), 24, f"{frame} at {angle}")

    def test_bearing_turns_with_the_force(self) -> None:
        found = motion_case.run(CRANK.format(frame=", frame: body", start="-30 deg"))
        for angle, x, y in zip(found["motor/drive"], found["a.Rx/action"],
                               found["a.Ry/action"]):
            self.near(x, 20 * math.sin(angle), 20, f"x at {angle}")
            self.near(y, -20 * math.cos(angle), 20, f"y at {angle}")

    def test_first_row_is_the_case_as_drawn(self) -> None:
        text = CRANK.format(frame=", frame: body", start=0)
        case = program.run("analyze", "-", text=text)["cases"]["pushed"]
        rows = motion_case.run(text)
        for name in ("motor", "a.Rx", "a.Ry"):
            self.near(rows[f"{name}/action"][0], case["statics"]["actions"][name], 20, name)

    def test_load_of_a_case_has_its_own_frame(self) -> None:
        text = CRANK.format(frame=", frame: body", start=0).replace(
            "{motor: 3}", "{motor: 3}, loads: {thrust: {body: crank, at: [0.5, 0.2], "
            "force: [0, 20]}}")
        found = motion_case.run(text)
        for angle, torque in zip(found["motor/drive"], found["motor/action"]):
            self.near(torque, -8 * math.cos(angle), 8, f"at {angle}")

    def test_force_on_a_slider_keeps_its_direction(self) -> None:
        """A slider does not turn, its crank does: one frame for the piston, another for the rod."""
        text = """kinestat: 1
space: planar
ground: frame
bodies: [crank, rod, piston]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0.1, 0]}
  c: {type: revolute, bodies: [rod, piston], at: [0.5, 0]}
  d: {type: prismatic, bodies: [frame, piston], at: [0.5, 0], axis: x}
actuators: {motor: {coupling: a}}
loads: {gas: {body: piston, at: [0.5, 0], force: [-50, 0], frame: body},
        along: {body: rod, at: [0.3, 0], force: [0, 8], frame: body}}
cases: {pushed: {motion: {motor: 1}}}
motion: {drive: motor, case: pushed, from: 20 deg, to: 160 deg, steps: 14, report: [action]}
"""
        found = motion_case.run(text)
        for angle, torque in zip(found["motor/drive"], found["motor/action"]):
            lean = -math.asin(0.1 * math.sin(angle) / 0.4)  # of the rod
            turn = -0.1 * math.cos(angle) / (0.4 * math.cos(lean))
            slide = -0.1 * math.sin(angle) - 0.4 * math.sin(lean) * turn
            across = (-0.1 * math.sin(angle) * -math.sin(lean) +
                      0.1 * math.cos(angle) * math.cos(lean) + 0.2 * turn)
            self.near(torque, 50 * slide - 8 * across, 10, f"at {angle}")

    def test_head_turned_about_two_axes(self) -> None:
        found = motion_case.run(GIMBAL)
        for a, b, motor_a, motor_b in zip(found["A/drive"], found["B/drive"],
                                          found["A/action"], found["B/action"]):
            def turned(v: list[float]) -> list[float]:
                return about_z(a, about_x(b, v))
            force = turned([5, -7, 11])
            moment = plus(cross(turned([0.3, 0.2, -0.1]), force), turned([2, 3, -1]))
            axis = about_z(a, [1, 0, 0])
            self.near(motor_a, -moment[2], 10, f"A at {a}, {b}")
            self.near(motor_b, -sum(x * y for x, y in zip(axis, moment)), 10, f"B at {a}, {b}")

    def test_couple_alone_turns_with_its_body(self) -> None:
        text = GIMBAL.replace("at: [0.3, 0.2, -0.1], force: [5, -7, 11], ", "")
        found = motion_case.run(text)
        for a, b, motor_a, motor_b in zip(found["A/drive"], found["B/drive"],
                                          found["A/action"], found["B/action"]):
            moment = about_z(a, about_x(b, [2, 3, -1]))
            self.near(motor_a, -moment[2], 3, f"A at {a}, {b}")
            self.near(motor_b, -2, 3, f"B at {a}, {b}")

    def test_curve_is_the_magnitude(self) -> None:
        """Along the crank's tangent, growing with its angle; as written it does work F r phi."""
        text = CRANK.format(frame=", frame: body", start=0).replace(
            "loads:", "curves: {push: {over: motor, between: linear, "
            "points: [[0 deg, 2 N], [400 deg, 10 N]]}}\nloads:").replace("[0, 20]", "[0, push]")
        found = motion_case.run(text)
        for angle, torque in zip(found["motor/drive"], found["motor/action"]):
            push = 2 + 8 * angle / math.radians(400)
            self.near(torque, -push * 0.4, 4, f"at {angle}")

    def test_lever_started_by_a_thrust(self) -> None:
        """Under a constant torque M the lever turns by M t^2/(2 J), and its energy is M phi."""
        text = """kinestat: 1
space: planar
ground: frame
bodies: {lever: {mass: 2, centre_of_mass: [0.3, 0], inertia: 0.07}}
couplings: {a: {type: revolute, bodies: [frame, lever], at: [0, 0]}}
actuators: {hinge: {coupling: a}}
CURVE
loads: {jet: {body: lever, at: [0.6, 0], force: [PULL, PUSH], frame: body}}
simulation: {action: {hinge: 0}, time: 4 s, steps: 16,
             report: [position, velocity, action, energy], tolerance: 1e-11}
"""
        inertia = 0.07 + 2 * 0.3 ** 2
        torque = 0.6 * 1.5
        for curve, pull, push in (("", "-4", "1.5"),
                                  ("curves: {p: {over: time, points: [[0 s, 1.5 N], "
                                   "[9 s, 1.5 N]], between: linear}}", "-4", "p")):
            found = Simulation(
                text.replace("CURVE", curve).replace("PULL", pull).replace("PUSH", push))
            for i, time in enumerate(found.columns["time"]):
                at = {name: values[i] for name, values in found.columns.items()}
                angle = torque * time ** 2 / (2 * inertia)
                speed = torque * time / inertia
                self.near(at["a.wz/position"], angle, 30, f"angle at {time}")
                self.near(at["a.wz/velocity"], speed, 15, f"speed at {time}")
                self.near(at["energy/kinetic"], torque * angle, 30, f"energy at {time}")
                # The bearing and the jet carry the centre of mass around.
                radial = -2 * 0.3 * speed ** 2 + 4
                across = 2 * 0.3 * torque / inertia - 1.5
                along = [math.cos(angle), math.sin(angle)]
                self.assertLess(abs(at["a.Rx/action"] - (radial * along[0] - across * along[1])),
                                1e-7)
                self.assertLess(abs(at["a.Ry/action"] - (radial * along[1] + across * along[0])),
                                1e-7)

    def test_energy_of_a_turn(self) -> None:
        """A force fixed to the crank has no potential: each turn takes 2 pi F r of the motor."""
        text = CRANK.format(frame=", frame: body", start=0).replace(
            "to: 400 deg", "to: 360 deg").replace(
            "motion: {motor: 3}", "motion: {motor: 3}, acceleration: {}").replace(
            "[crank]\ncoup", "{crank: {inertia: 0.5}}\ncoup").replace(
            "\nmotion:", "\ndynamics: {actuators: motor}\nmotion:")
        found = program.run("motion", "-", text=text)["motion"]["dynamics"]
        work = 2 * math.pi * 8
        self.near(found["actuators"]["motor"]["energy_out"], work, work, "taken by the motor")
        self.near(found["actuators"]["motor"]["energy_in"], 0.0, work, "given")
        self.near(found["energy"]["loads"], work, work, "given by the load")
        self.assertLess(found["energy"]["audit"], 1e-9)

    def test_direction_by_an_idle_freedom_is_told(self) -> None:
        """A force at the axis of a rod moves nothing, but turns with its spin if it is fixed to it."""
        text = """kinestat: 1
ground: frame
bodies: [crank, rod, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}
  b: {type: spherical, bodies: [crank, rod], at: [1, 0, 0]}
  c: {type: spherical, bodies: [rod, rocker], at: [3, 3, 2]}
  d: {type: revolute, bodies: [frame, rocker], at: [3, 0, 2], axis: x}
actuators: {motor: {coupling: a}}
loads: {push: {body: rod, at: [2, 1.5, 1], force: FORCE}}
cases: {c: {motion: {motor: 1}}}
motion: {drive: motor, to: 20 deg, steps: 4, case: c, report: [motor]}
"""
        for force, is_told in (("[1, 0, 0], frame: body", True), ("[1, 0, 0]", False),
                               ("[2, 3, 2], frame: body", False)):
            done = program.plain("motion", "-", text=text.replace("FORCE", force))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("W0506" in done.stderr, is_told, force)

    def test_sweep_of_motions(self) -> None:
        text = CRANK.format(frame=", frame: body", start=0).replace(
            "ground: frame\n", "ground: frame\nparameters: {F: 20 N}\n").replace(
            "[0, 20]", "[0, F]") + """sweep:
  vary: {F: [5 N, 20 N]}
  report: [motor.greatest, motor.least]
"""
        done = program.plain("sweep", "--quiet", "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split(",") for line in done.stdout.splitlines()[1:]]
        for row, force in zip(rows, (5.0, 20.0)):
            for value in row[-3:-1]:
                self.near(float(value), -0.4 * force, 8, str(row))


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
