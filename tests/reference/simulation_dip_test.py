#!/usr/bin/env python3
"""What happens within one step of a simulation and is over before its end, and what swings while the
coordinates are steady. By closed forms.

Usage: simulation_dip_test.py KINESTAT
"""

from __future__ import annotations

import math
import sys
import unittest
from typing import Callable

import program

# Thrown up at 10 m/s: its apex is at 5 m, after 1 s.
BALL = """
kinestat: 1
space: planar
ground: frame
bodies: {ball: {mass: 2, centre_of_mass: [0, 0], inertia: 0.1}}
gravity: [0, -10]
couplings: {g: {type: prismatic, bodies: [frame, ball], at: [0, 0], axis: y}}
SPRINGS
actuators: {f: {coupling: g}}
simulation: {action: {f: 0}, start: {f: {speed: 10}}, SECTION}
"""

# A rotor of 1 kg, held at 80 rad/s, whose centre is below its axis at the begin.
ROTOR = """
kinestat: 1
space: planar
ground: frame
bodies: {block: {mass: 10, centre_of_mass: [0, 0]},
         rotor: {mass: 1, centre_of_mass: [0, -ECCENTRICITY], inertia: 0.001},
         other: {mass: 1, centre_of_mass: [1, 0]}}
gravity: [0, -9.81]
couplings:
  a: {type: prismatic, bodies: [frame, block], at: [0, 0], MOVES}
  b: {type: revolute, bodies: [BEARING, rotor], at: [0, 0]}
  z: {type: prismatic, bodies: [frame, other], at: [1, 0], axis: x}
CABLES
actuators: {A: {coupling: a}, B: {coupling: b}, Z: {coupling: z}}
simulation: {action: {ACTION}, motion: {B: 80}, SECTION}
"""
SPEED = 80.0
GRAVITY = 9.81


def simulated(text: str, **parts: str) -> dict:
    for name, part in {"SPRINGS": "", "CABLES": "", "ACTION": "A: 0, Z: 0", **parts}.items():
        text = text.replace(name, part)
    return program.run("simulate", "-", text=text, statuses=(0, 5))["simulation"]


def first_zero(value: Callable[[float], float], end: float) -> float:
    """The first time at which it is negative, to 1e-12 s."""
    high = next(t for t in (i * end / 1e5 for i in range(100001)) if value(t) < 0.0)
    low = high - end / 1e5
    while high - low > 1e-12:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if value(middle) < 0.0 else (middle, high)
    return high


class DipTest(unittest.TestCase):
    def first_event(self, found: dict, kind: str) -> dict:
        return next(one for one in found["events"] if one["kind"] == kind)

    def test_a_stop_just_below_the_apex_is_struck(self) -> None:
        for place in (4.95, 4.99, 4.9999, 4.999999):
            for time in (2, 20, 100):
                with self.subTest(place=place, time=time):
                    stop = f"stops: {{f: {{from: 0, to: {place}, restitution: 0.9}}}}"
                    found = simulated(BALL, SECTION=f"{stop}, time: {time} s, steps: 10")
                    first = self.first_event(found, "impact")
                    rises = math.sqrt(100 - 20 * place)
                    self.assertLess(abs(first["time"] - (10 - rises) / 10), 1e-7)
                    self.assertLess(abs(first["speed"] - rises), 1e-6)
                    self.assertLess(abs(found["figures"]["g.vy/position"]["greatest"] - place), 1e-9)

    def test_a_goal_just_below_the_apex_is_reached(self) -> None:
        for place in (4.9999, 4.9999999):
            for time in (2, 20, 100):
                with self.subTest(place=place, time=time):
                    goal = f"until: {{f: {{position: {place}}}}}"
                    found = simulated(BALL, SECTION=f"{goal}, time: {time} s, steps: 1")
                    self.assertEqual(found["status"], "goal")
                    self.assertLess(abs(found["time"] - (1 - math.sqrt(1 - place / 5))), 1e-6)

    def test_a_goal_just_above_the_apex_is_not(self) -> None:
        found = simulated(BALL, SECTION="until: {f: {position: 5.0000001}}, time: 1.9 s, steps: 1")
        self.assertEqual(found["status"], "complete")

    def test_a_hard_spring_just_below_the_apex_throws_it_back(self) -> None:
        """It is pressed by d from 4.999 m on: m g (0.001 - d) = k d^2 / 2."""
        weight, stiffness = 20.0, 1e6
        pressed = (-weight + math.sqrt(weight ** 2 + 2 * stiffness * weight * 0.001)) / stiffness
        spring = ("springs: {s: {bodies: [frame, ball], at: {frame: [0, 8], ball: [0, 0]}, "
                  "stiffness: 1000000, free_length: 3.001, acts: push}}")
        for time in (2, 20, 100):
            with self.subTest(time=time):
                found = simulated(BALL, SPRINGS=spring, SECTION=f"time: {time} s, steps: 10")
                greatest = found["figures"]["g.vy/position"]["greatest"]
                self.assertLess(abs(greatest - 4.999 - pressed), 1e-6)

    def test_what_a_rotor_shakes_slips_in_its_first_revolution(self) -> None:
        def margin(time: float, stick: float, eccentricity: float) -> float:
            force = eccentricity * SPEED ** 2
            normal = 11 * GRAVITY + force * math.cos(SPEED * time)
            return stick * normal - abs(force * math.sin(SPEED * time))

        for stick in (0.7, 0.735):
            expected = first_zero(lambda t, mu=stick: margin(t, mu, 0.01), 0.1)
            for time in (1, 20):
                with self.subTest(stick=stick, time=time):
                    found = simulated(
                        ROTOR, MOVES=f"axis: x, friction: {{mu: 0.3, mu_static: {stick}}}", BEARING="block",
                        ECCENTRICITY="0.01", SECTION=f"time: {time} s, steps: 40")
                    self.assertLess(abs(self.first_event(found, "slip")["time"] - expected), 1e-9)

    def test_a_cable_that_a_rotor_lifts_is_slack_in_its_first_revolution(self) -> None:
        expected = first_zero(
            lambda t: 11 * GRAVITY + 0.02 * SPEED ** 2 * math.cos(SPEED * t), 0.1)
        cables = "cables: {rope: {over: [{body: frame, at: [0, 1]}, {body: block, at: [0, 0]}]}}"
        for time in (1, 100):
            with self.subTest(time=time):
                found = simulated(ROTOR.replace("A: {coupling: a}, ", ""), MOVES="axis: y", BEARING="block",
                                  ECCENTRICITY="0.02", ACTION="Z: 0", CABLES=cables,
                                  SECTION=f"time: {time} s, steps: 10")
                self.assertEqual((found["status"], found["events"][-1]["kind"]), ("parted", "cable_slack"))
                self.assertLess(abs(found["time"] - expected), 1e-9)

    def test_work_that_swings_adds_up(self) -> None:
        """1 N pushes 10 kg on for half a t^2, and the rotor is lifted."""
        for time in (1, 20):
            with self.subTest(time=time):
                found = simulated(ROTOR, MOVES="axis: x", BEARING="frame", ECCENTRICITY="0.1",
                                  ACTION="A: 1, Z: 0", SECTION=f"time: {time} s, steps: 10, report: [energy]")
                names = [one["name"] for one in found["columns"]]
                last = dict(zip(names, found["rows"][-1]))
                lifted = GRAVITY * 0.1 * (1 - math.cos(SPEED * time))
                self.assertLess(abs(last["energy/supplied"] - 0.05 * time ** 2 - lifted), 1e-6)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
