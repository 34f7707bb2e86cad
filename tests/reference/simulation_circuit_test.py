#!/usr/bin/env python3
"""Simulations in which all couplings of a circuit rub: a flywheel takes a shaft along through a clutch,
both in bearings of their own. By closed forms.

Usage: simulation_circuit_test.py KINESTAT
"""

from __future__ import annotations

import sys
import unittest

import program
import simulation_test as simulations

Simulation = simulations.Simulation

FLY, SHAFT = 5.0, 0.1                    # inertias
BEARING, OTHER, CLUTCH = 2.0, 1.0, 80.0  # couples of friction
COUPLINGS = {
    "a": f"a: {{type: revolute, bodies: [frame, fly], at: [0, 0], friction: {{tau: {BEARING}}}}}",
    "b": f"b: {{type: revolute, bodies: [frame, shaft], at: [0, 0], friction: {{tau: {OTHER}}}}}",
    "C": f"C: {{type: clutch, bodies: [fly, shaft], at: [0, 0], friction: {{tau: {CLUTCH}}}}}"}


def simulated(simulation: str, order: str = "abC", clutch: str = "clutch",
              actuators: str = "{m: {coupling: a}}") -> Simulation:
    couplings = "\n  ".join(COUPLINGS[name].replace("type: clutch", f"type: {clutch}") for name in order)
    return Simulation(f"""
kinestat: 1
space: planar
ground: frame
bodies: {{fly: {{inertia: {FLY}}}, shaft: {{inertia: {SHAFT}}}}}
couplings:
  {couplings}
actuators: {actuators}
simulation: {{{simulation}, tolerance: 1e-11}}
""")


class CircuitTest(simulations.SimulationCase):
    def test_the_clutch_slips_until_both_turn_alike_and_the_bearings_bring_them_to_rest(self) -> None:
        alike = 30 / ((CLUTCH + BEARING) / FLY + (CLUTCH - OTHER) / SHAFT)
        speed = 30 - (CLUTCH + BEARING) / FLY * alike
        slows = (BEARING + OTHER) / (FLY + SHAFT)
        rest = alike + speed / slows
        for order in ("abC", "Cab", "bCa"):
            found = simulated("action: {m: 0, o: 0, C: 0}, start: {m: {speed: 30 rad/s}}, time: 60 s, "
                              "steps: 600, report: [a.wz, b.wz, C.wz, C/friction, energy/lost]",
                              order, actuators="{m: {coupling: a}, o: {coupling: b}}")
            sticks = [event for event in found.events if event["kind"] == "stick"]
            self.assertEqual(len(sticks), 2)
            self.near(sticks[0]["time"], alike, 1e-9, "alike")
            self.near(sticks[1]["time"], rest, 1e-8, "rest")
            for i, time in enumerate(found.columns["time"]):
                at = {name: values[i] for name, values in found.columns.items()}
                if alike < time < rest:
                    self.near(at["a.wz/velocity"], speed - slows * (time - alike), 1e-8, f"{time}")
                    self.near(at["b.wz/velocity"], at["a.wz/velocity"], 1e-9, f"{time}")
                    # On the shaft, what its bearing takes beyond what slows it down.
                    self.near(abs(at["C/friction"]), OTHER - SHAFT * slows, 1e-8, f"{time}")
                elif time > rest:
                    self.near(at["a.wz/velocity"], 0.0, 1e-12, f"{time}")
                    self.assertIsNone(at["C/friction"])
            self.near(found.last()["energy/lost"], FLY * 30 ** 2 / 2, 1e-6)

    def test_from_rest_the_clutch_sticks_while_both_bearings_slide(self) -> None:
        for torque in (5.0, 90.0):
            last = simulated(f"action: {{m: {torque}, C: 0}}, time: 2, steps: 4").last()
            turns = (torque - BEARING - OTHER) / (FLY + SHAFT)
            self.near(last["a.wz/velocity"], 2 * turns, 1e-9, f"{torque}")
            self.near(last["b.wz/velocity"], 2 * turns, 1e-9, f"{torque}")
            self.near(abs(last["C/friction"]), OTHER + SHAFT * turns, 1e-9, f"{torque}")

    def test_what_the_start_does_not_name_is_at_rest_however_long_it_takes(self) -> None:
        for clutch, action in (("clutch", "m: 0, C: 0"), ("revolute", "m: 0")):
            for time in (0.001, 60):
                found = simulated(f"action: {{{action}}}, start: {{a.wz: {{speed: 30}}}}, time: {time}, "
                                  "steps: 2", clutch=clutch)
                self.near(found.at(0)["b.wz/velocity"], 0.0, 1e-12, f"{clutch} {time}")


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
