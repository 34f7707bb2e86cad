#!/usr/bin/env python3
"""Simulations with mesh losses, by closed forms: accelerations are constant while one gear drives,
unless losses depend on speed.

Usage: simulation_loss_test.py KINESTAT
"""

from __future__ import annotations

import math
import sys
import unittest

import program
import simulation_test as simulations

Simulation = simulations.Simulation
LOSS = 0.1

# The hinge of the wheel runs from the wheel to the frame: no order of bodies is special.
FLYWHEELS = """
kinestat: 1
space: planar
ground: frame
bodies: {pinion: {inertia: 0.02}, wheel: {inertia: 0.3}}
couplings:
  a: {type: revolute, bodies: [frame, pinion], at: [0, 0]}
  b: {type: revolute, bodies: [wheel, frame], at: [0, 0.15]}
  m: {type: gear, bodies: [GEARS], at: [0, 0.05], tangent: x, pressure_angle: 20 deg}
actuators: {motor: {coupling: a}}
losses: {gear_external: LOSS}
simulation: {action: {motor: TORQUE}, start: {motor: {speed: SPEED}}, time: 2 s, steps: 20,
             tolerance: 1e-11}
"""
PINION, WHEEL, RATIO = 0.02, 0.3, 0.5  # the wheel turns half as fast

PLANETS = """
kinestat: 1
space: planar
ground: frame
bodies: {sun: {inertia: 0.01}, arm: {inertia: 0.2}, planet: {}}
couplings:
  a: {type: revolute, bodies: [frame, sun], at: [0, 0]}
  c: {type: revolute, bodies: [frame, arm], at: [0, 0]}
  d: {type: revolute, bodies: [arm, planet], at: [0, 0.05]}
  e: {type: gear, bodies: [sun, planet], at: [0, 0.02], tangent: x, pressure_angle: 20 deg}
  g: {type: gear, bodies: [frame, planet], at: [0, 0.08], tangent: x, pressure_angle: 20 deg, internal: true}
actuators: {motor: {coupling: a}}
losses: {gear_external: 0.03, gear_internal: 0.02}
simulation: {action: {motor: TORQUE}, start: {motor: {speed: SPEED}}, time: 1 s, steps: 10,
             tolerance: 1e-11}
"""


def filled(text: str, torque: float | str, speed: float, loss: float | str = LOSS,
           gears: str = "pinion, wheel") -> str:
    for word, value in (("TORQUE", torque), ("SPEED", speed), ("LOSS", loss), ("GEARS", gears)):
        text = text.replace(word, str(value))
    return text


class LossTest(simulations.SimulationCase):
    def test_the_motor_drives_two_flywheels(self) -> None:
        """The wheel is driven, and held back by the share of what the teeth give it."""
        for gears in ("pinion, wheel", "wheel, pinion"):
            for torque in (3.0, -3.0):
                found = Simulation(filled(FLYWHEELS, torque, 0.0, gears=gears))
                speeds_up = torque / (PINION + WHEEL * RATIO ** 2 / (1 - LOSS))
                last = found.last()
                self.near(last["a.wz/acceleration"], speeds_up, 1e-9 * abs(speeds_up))
                self.near(last["a.wz/velocity"], 2 * speeds_up, 1e-9 * abs(speeds_up))
                # What the wheel gains is all but the share of what the teeth gave.
                gained = WHEEL * (RATIO * 2 * speeds_up) ** 2 / 2
                self.near(last["energy/lost"], gained * LOSS / (1 - LOSS), 1e-8)
                self.assertLess(found.report["energy_drift"], 1e-9)

    def test_the_wheel_drives_while_the_motor_brakes(self) -> None:
        """Then the pinion is driven; once it turns back, the wheel is again."""
        found = Simulation(filled(FLYWHEELS, -3.0, 20.0))
        brakes = -3.0 / (PINION + WHEEL * RATIO ** 2 * (1 - LOSS))
        turns = -20.0 / brakes
        self.assertLess(turns, 2.0)
        back = -3.0 / (PINION + WHEEL * RATIO ** 2 / (1 - LOSS))
        for time in (0.1 * i for i in range(21)):
            expected = 20.0 + brakes * time if time < turns else back * (time - turns)
            self.near(found.at(round(time, 10))["a.wz/velocity"], expected, 1e-7, f"at {time}")
        self.assertLess(found.report["energy_drift"], 1e-8)

    def test_a_torque_that_turns_round_lets_each_drive_in_turn(self) -> None:
        """T = 3 - 3 t: the motor drives, then brakes the wheel, then drives it backwards."""
        text = filled(FLYWHEELS, "ramp", 0.0).replace(
            "simulation:", "curves: {ramp: {over: time, points: [[0 s, 3], [2 s, -3]]}}\nsimulation:")
        found = Simulation(text)
        drives = PINION + WHEEL * RATIO ** 2 / (1 - LOSS)
        brakes = PINION + WHEEL * RATIO ** 2 * (1 - LOSS)
        turns = 1.0 + math.sqrt(brakes / drives)
        for time in (0.1 * i for i in range(21)):
            if time <= 1.0:
                expected = 1.5 * (1.0 - (1.0 - time) ** 2) / drives
            elif time <= turns:
                expected = 1.5 / drives - 1.5 * (time - 1.0) ** 2 / brakes
            else:
                expected = -1.5 * ((time - 1.0) ** 2 - (turns - 1.0) ** 2) / drives
            self.near(found.at(round(time, 10))["a.wz/velocity"], expected, 1e-7, f"at {time}")
        self.assertLess(found.report["energy_drift"], 1e-7)

    def test_a_bearing_rubs_beside_the_teeth(self) -> None:
        """The teeth have to turn the wheel against its bearing, too, and lose their share of that."""
        text = filled(FLYWHEELS, 3.0, 0.0).replace("at: [0, 0.15]}", "at: [0, 0.15], friction: {tau: 0.8}}")
        speeds_up = (3.0 - RATIO * 0.8 / (1 - LOSS)) / (PINION + WHEEL * RATIO ** 2 / (1 - LOSS))
        last = Simulation(text).last()
        self.near(last["a.wz/velocity"], 2 * speeds_up, 1e-8)
        self.near(abs(last["b/friction"]), 0.8, 1e-12)

    def test_a_sun_drives_planets_and_their_carrier(self) -> None:
        """The ring rests: the torque of the carrier is 1 + 4 eta times that of the sun, eta that of both
        meshes in the carrier, or 1 + 4/eta where the carrier drives (Macmillan 1961)."""
        eta = 0.97 * 0.98
        for torque, speed, ratio in ((2.0, 0.0, 1 + 4 * eta), (2.0, 30.0, 1 + 4 * eta),
                                     (-0.5, 300.0, 1 + 4 / eta)):
            speeds_up = torque / (0.01 + 0.2 / 5 / ratio)
            last = Simulation(filled(PLANETS, torque, speed)).last()
            self.assertGreater(speed + speeds_up, 0.0)
            self.near(last["a.wz/velocity"], speed + speeds_up, 1e-8 * abs(speed + speeds_up))

    def test_a_loss_grows_with_the_speed_of_the_teeth(self) -> None:
        """(J1 + J2/(1 - c w)) dw = T dt, for a loss c w of the pinion's speed w."""
        share = 0.02 * 0.05  # of a formula in m/s, on the radius of the pinion
        found = Simulation(filled(FLYWHEELS, 3.0, 0.0, loss="0.02*speed/(1 m/s)"))
        for i, time in enumerate(found.columns["time"]):
            speed = found.columns["a.wz/velocity"][i]
            impulse = (PINION * speed -
                       WHEEL * RATIO ** 2 / share * math.log(1.0 - share * speed))
            self.near(impulse, 3.0 * time, 1e-9)
        self.assertLess(found.report["energy_drift"], 1e-6 * found.report["energy_scale"])

    def test_a_loss_without_a_value(self) -> None:
        text = filled(FLYWHEELS, 3.0, 0.0, loss="0.02 - 0.02*speed/(1 m/s)")
        done = program.call("simulate", "-", text=text)
        self.assertRegex(done.stderr, r"E0515.*cannot go on after [0-9.]+ s: the loss of mesh 'm'")
        report = program.report(done)["simulation"]
        speed = [one["name"] for one in report["columns"]].index("a.wz/velocity")
        self.near(report["rows"][-1][speed], 20.0, 0.5)  # 1 m/s at 50 mm

    def test_a_mesh_without_losses_is_as_before(self) -> None:
        found = Simulation(filled(FLYWHEELS, 3.0, 0.0, loss=0))
        self.near(found.last()["a.wz/velocity"], 6.0 / (PINION + WHEEL * RATIO ** 2), 1e-9)
        self.assertEqual(found.last()["energy/lost"], 0.0)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
