#!/usr/bin/env python3
"""Powers and energies of actuators over a whole motion, against closed forms.

Usage: energy_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest

import program
from dynamics_case import DynamicsCase


def rotor(motion: str, case: str, extra: str = "", coupling: str = "") -> dict:
    """A rotor of 0.5 kg*m^2 about its bearing, with 2 kg at 0.3 m where gravity acts."""
    mass = "mass: 2, centre_of_mass: [0.3, 0], inertia: 0.32" if "gravity" in extra \
        else "inertia: 0.5"
    text = f"""kinestat: 1
space: planar
ground: frame
bodies: {{rotor: {{{mass}}}}}
{extra}couplings: {{a: {{type: revolute, bodies: [frame, rotor], at: [0, 0]{coupling}}}}}
actuators: {{motor: {{coupling: a}}}}
cases: {{running: {case}}}
motion: {{drive: motor, case: running, steps: 8, {motion}}}
dynamics: {{actuators: motor}}
"""
    return program.run("motion", "-", text=text)["motion"]["dynamics"]


class EnergyTest(DynamicsCase):
    def test_weight_lifted_and_lowered(self) -> None:
        """Once a turn at 4 rad/s: 2 m g r are given and taken, RMS is the peak over root 2."""
        found = rotor("to: 360 deg", "{motion: {motor: 4}, acceleration: {}}",
                      extra="gravity: [0, -9.81]\n")
        motor = found["actuators"]["motor"]
        peak = 2 * 9.81 * 0.3
        self.near(abs(motor["peak_moment"]), peak, peak, "peak")
        self.near(motor["mean_moment"], 0.0, peak, "mean")
        self.near(motor["rms_moment"], peak / math.sqrt(2), peak, "RMS")
        self.near(abs(motor["peak_power"]), 4 * peak, 4 * peak, "power")
        self.near(motor["energy_in"], 2 * peak, peak, "in")
        self.near(motor["energy_out"], 2 * peak, peak, "out")
        self.assertLess(found["energy"]["audit"], 1e-9)

    def test_cycloidal_law(self) -> None:
        """J = 0.5, 3 rad in 0.2 s: sin x (1 - cos x) is greatest at 3 sqrt(3)/4."""
        found = rotor("to: 3 rad, time: 0.2 s, law: cycloidal", "{motion: {}, acceleration: {}}")
        motor = found["actuators"]["motor"]
        peak = 0.5 * 2 * math.pi * 3 / 0.2 ** 2
        self.near(abs(motor["peak_moment"]), peak, peak, "peak")
        self.near(motor["rms_moment"], peak / math.sqrt(2), peak, "RMS")
        self.near(motor["peak_angular_velocity"], 30.0, 30.0, "speed")
        power = 0.5 * 2 * math.pi * 9 / 0.2 ** 3 * 0.75 * math.sqrt(3)
        self.near(abs(motor["peak_power"]), power, power, "power")
        self.near(motor["energy_in"], 0.25 * 30 ** 2, 225.0, "in")
        self.near(motor["energy_out"], 0.25 * 30 ** 2, 225.0, "out")
        self.near(motor["mean_power"], 0.0, power, "mean power")
        self.near(found["energy"]["greatest_kinetic_energy"], 225.0, 225.0, "kinetic energy")
        self.assertLess(found["energy"]["audit"], 1e-9)

    def test_a_dwell_between_giving_and_taking(self) -> None:
        """What speeds it up comes back behind the dwell, in which the power is zero."""
        for law, size in (("trapezoid", 1.5), ("cycloidal", 2.0), ("harmonic", math.pi / 2)):
            profile = (f"profile: [{{to: 3 rad, time: 1 s, law: {law}}}, {{dwell: 2 s}}, "
                       f"{{to: 0 rad, time: 1 s, law: {law}}}]")
            found = rotor(profile, "{motion: {}, acceleration: {}}")
            motor = found["actuators"]["motor"]
            energy = 2 * 0.25 * (3 * size) ** 2  # there and back
            self.assertLess(abs(motor["energy_in"] - energy), 1e-9 * energy, law)
            self.assertLess(abs(motor["energy_out"] - energy), 1e-9 * energy, law)

    def test_torque_that_jumps(self) -> None:
        """Half of the time up, half down: the torque is 4 J range/T^2 all along, and no more."""
        found = rotor("to: 3 rad, time: 0.2 s, law: constant_acceleration",
                      "{motion: {}, acceleration: {}}")
        motor = found["actuators"]["motor"]
        torque = 0.5 * 4 * 3 / 0.2 ** 2
        self.near(abs(motor["peak_moment"]), torque, torque, "peak")
        self.near(motor["rms_moment"], torque, torque, "RMS")
        self.near(abs(motor["peak_power"]), 30 * torque, 30 * torque, "power")
        self.near(motor["energy_in"], 225.0, 225.0, "in")
        self.near(motor["energy_out"], 225.0, 225.0, "out")

    def test_friction(self) -> None:
        """2 N*m over 4 turns are lost."""
        found = rotor("to: 1440 deg", "{motion: {motor: 5}, acceleration: {}}",
                      coupling=", friction: {tau: 2 N*m}")
        lost = 2 * 8 * math.pi
        self.near(found["energy"]["lost"], lost, lost, "lost")
        self.near(found["energy"]["actuators"], lost, lost, "given")
        self.near(found["actuators"]["motor"]["energy_in"], lost, lost, "in")
        self.assertEqual(found["actuators"]["motor"]["energy_out"], 0.0)
        self.assertLess(found["energy"]["audit"], 1e-9)

    def test_efficiency_of_a_whole_cycle(self) -> None:
        """A load that falls from 30 N*m to 10 and rises again over a turn, mean 20 N*m, behind teeth
        1:1 and a bearing that takes 0.5 N*m: 20/20.5 of the energy comes out, of the power less."""
        text = """kinestat: 1
space: planar
ground: frame
bodies: [one, other]
couplings:
  a: {type: revolute, bodies: [frame, one], at: [0, 0]}
  b: {type: revolute, bodies: [frame, other], at: [0.1, 0], friction: {tau: 0.5}}
  m: {type: gear, bodies: [one, other], at: [0.05, 0], tangent: y, pressure_angle: 20 deg}
actuators: {motor: {coupling: a}, tool: {coupling: b}}
curves:
  work: {over: motor, period: 360 deg, points: [[0, 30 N*m], [180 deg, 10 N*m], [360 deg, 30 N*m]]}
cases: {run: {motion: {motor: 10}, acceleration: {}, action: {tool: work},
              input: motor, output: tool}}
motion: {drive: motor, to: 360 deg, steps: 12, case: run}
dynamics: {actuators: motor}
"""
        energy = program.run("motion", "-", text=text)["motion"]["dynamics"]["energy"]
        self.near(energy["efficiency"], 20 / 20.5, 1.0, "efficiency")
        self.near(energy["lost"], 0.5 * 2 * math.pi, 100.0, "lost")
        speeding_up = text.replace("bodies: [one, other]", "bodies: {one: {inertia: 1}, other: }", 1)
        speeding_up = speeding_up.replace("acceleration: {}", "acceleration: {motor: 5}")
        kept = program.run("motion", "-", text=speeding_up)["motion"]["dynamics"]["energy"]
        self.assertIsNone(kept["efficiency"])


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
