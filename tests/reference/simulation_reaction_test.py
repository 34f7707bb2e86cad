#!/usr/bin/env python3
"""Actions of couplings in simulations, by momentum and by closed forms.

Usage: simulation_reaction_test.py KINESTAT
"""

from __future__ import annotations

import math
import sys
import unittest

import program
import simulation_test as simulations

Simulation = simulations.Simulation
CASES = simulations.CASES
G = 9.81


class ReactionTest(simulations.SimulationCase):
    def test_ground_bears_weight_and_momentum(self) -> None:
        """A pendulum on a cart with springs, a damper, viscous friction, a curve, and a stop."""
        found = Simulation("""
kinestat: 1
space: planar
ground: frame
bodies: {cart: {mass: 2, centre_of_mass: [0, 0], inertia: 0.1},
         pendulum: {mass: 1, centre_of_mass: [0.3, -0.4], inertia: 0.01}}
gravity: [0, -9.81]
couplings: {a: {type: prismatic, bodies: [frame, cart], at: [0, 0], axis: x, friction: {c: 2}},
            b: {type: revolute, bodies: [cart, pendulum], at: [0, 0]}}
springs: {s: {coupling: b, stiffness: 3 N*m/rad, free: 0.2, damping: 0.1 N*m*s/rad},
          k: {bodies: [frame, cart], at: {frame: [-1, 0.5], cart: [0, 0.5]}, stiffness: 40 N/m,
              free_length: 0.9}}
actuators: {push: {coupling: a}, swing: {coupling: b}}
curves: {pull: {over: time, points: [[0 s, 0 N], [1 s, 20 N], [2 s, -5 N]], between: linear}}
loads: {wind: {body: pendulum, at: [0.3, -0.4], force: [0, pull]}}
simulation: {action: {push: 3, swing: 0.5}, stops: {push: {to: 0.05}}, time: 2 s, steps: 40,
             report: [position, velocity, acceleration, action], tolerance: 1e-11}
""")
        for i, time in enumerate(found.columns["time"]):
            at = {name: values[i] for name, values in found.columns.items()}
            angle = math.atan2(-0.4, 0.3) + at["b.wz/position"]
            spin, up = at["b.wz/velocity"], at["b.wz/acceleration"]
            rise = 0.5 * (up * math.cos(angle) - spin ** 2 * math.sin(angle))
            along = at["a.vx/acceleration"] - 0.5 * (up * math.sin(angle) +
                                                     spin ** 2 * math.cos(angle))
            wind = 20 * time if time <= 1 else 20 - 25 * (time - 1)
            self.near(at["a.Ry/action"], 3 * G + rise - wind, 1e-7, f"cart {time}")
            self.near(at["b.Rx/action"], along, 1e-7, f"pin {time}")
            self.near(at["b.Ry/action"], G + rise - wind, 1e-7, f"pin {time}")
        self.assertIn("impact", [event["kind"] for event in found.events])

    def test_bearing_of_a_pendulum(self) -> None:
        text = simulations.PENDULUM.replace("tolerance", "report: [a, energy], tolerance")
        found = Simulation(text)
        for row in CASES["pendulum_forward"]["expected"]["rows"]:
            at = found.at(row["time"])
            self.near(at["a.Rx/action"], row["bearing"][0], 1e-8 * 70)
            self.near(at["a.Ry/action"], row["bearing"][1], 1e-8 * 70)
        # Tension m g cos + m l w^2 along the rod.
        for i, angle in enumerate(found.columns["a.wz/position"]):
            pull = (-math.sin(angle) * found.columns["a.Rx/action"][i] +
                    math.cos(angle) * found.columns["a.Ry/action"][i])
            speed = found.columns["a.wz/velocity"][i]
            self.near(pull, 2 * G * math.cos(angle) + 2 * 0.5 * speed ** 2, 1e-7)
        for name in found.columns:
            self.assertTrue(name == "time" or name.startswith(("a.", "energy/")), name)

    def test_report_of_the_command_line_comes_before_that_of_the_file(self) -> None:
        found = Simulation(simulations.PENDULUM, "--report", "velocity", "--report", "a.Rx")
        self.assertEqual(list(found.columns), ["time", "a.wz/velocity", "a.Rx/action"])
        done = program.call("simulate", "-", "--report", "a.Rz", text=simulations.PENDULUM)
        self.assertIn("E0313", done.stderr)

    def test_every_impact_on_stops_that_are_hit_at_once_is_told(self) -> None:
        """A cart of 1 kg strikes one of 2 kg from inside, which stands at a wall. Momentum and
        restitution 1/2 and 2/5 by hand: the two part at 1/2 m/s, the outer one comes back from the
        wall with 1/5 m/s and strikes the inner one, which stands, with that."""
        done = program.call("simulate", "-", text="""kinestat: 1
space: planar
ground: frame
bodies: {one: {mass: 2, centre_of_mass: [0, 0]}, two: {mass: 1, centre_of_mass: [0, 0]}}
couplings:
  x: {type: prismatic, bodies: [frame, one], at: [0, 0], axis: x}
  y: {type: prismatic, bodies: [one, two], at: [0, 0], axis: x}
actuators: {p: {coupling: x}, q: {coupling: y}}
simulation:
  action: {p: 0, q: 0}
  start: {q: {speed: 1}}
  stops: {p: {to: 0, restitution: 0.4}, q: {to: 0.1, restitution: 0.5}}
  time: 1 s
  steps: 1
""")
        self.assertEqual(done.returncode, 0, done.stderr)
        impacts = [one for one in program.report(done)["simulation"]["events"]
                   if one["kind"] == "impact"]
        for one, (of, before, after) in zip(impacts, [("q", 1, -0.5), ("p", 0.5, -0.2),
                                                      ("q", 0.2, -0.1)], strict=True):
            self.assertEqual(one["element"], of)
            self.assertAlmostEqual(one["time"], 0.1, 9)
            self.assertAlmostEqual(one["speed"], before, 12)
            self.assertAlmostEqual(one["speed_after"], after, 12)

    def test_an_end_condition_at_the_start_is_called_that(self) -> None:
        done = program.call("simulate", "-", text="""kinestat: 1
space: planar
ground: frame
bodies: {cart: {mass: 2, centre_of_mass: [0, 0]}}
couplings: {x: {type: prismatic, bodies: [frame, cart], at: [0, 0], axis: x}}
actuators: {p: {coupling: x}}
simulation: {action: {p: 1}, start: {p: {position: 0.5}}, until: {p: {position: 0.5}}, time: 1 s}
""")
        self.assertIn("W0513]: 'p' starts at and does not come back to 0.5 m in 1 s", done.stderr)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
