#!/usr/bin/env python3
"""Cables and contacts with inertia: motions and simulations against Newton's law for each body.

Usage: cable_dynamics_test.py KINESTAT
"""

from __future__ import annotations

import math
import sys
import unittest

import program
import simulation_test as simulations

Simulation = simulations.Simulation

G = 9.81

TACKLE = """
kinestat: 1
space: planar
ground: beam
bodies: {hand: {mass: 5, centre_of_mass: [0.05, 0]}, block: {mass: 100, centre_of_mass: [0.3, 0]},
         s1: {inertia: 0.01}, s2: {inertia: 0.01}, s3: {inertia: 0.01}, s4: {inertia: 0.01}}
gravity: [0, -9.81]
couplings:
  H: {type: prismatic, bodies: [beam, hand], at: [0.05, 0], axis: y}
  L: {type: prismatic, bodies: [beam, block], at: [0.3, 0], axis: y}
  B1: {type: revolute, bodies: [beam, s1], at: [0.1, 5]}
  B2: {type: revolute, bodies: [block, s2], at: [0.2, 0]}
  B3: {type: revolute, bodies: [beam, s3], at: [0.3, 5]}
  B4: {type: revolute, bodies: [block, s4], at: [0.4, 0]}
cables:
  rope:
    over:
      - {body: hand, at: [0.05, 0]}
      - {pulley: s1, radius: 0.05, wrap: clockwise}
      - {pulley: s2, radius: 0.05, wrap: counterclockwise}
      - {pulley: s3, radius: 0.05, wrap: clockwise}
      - {pulley: s4, radius: 0.05, wrap: counterclockwise}
      - {body: beam, at: [0.45, 5]}
actuators: {hand: {coupling: H}}
"""


ATWOOD = """
kinestat: 1
space: planar
ground: frame
bodies: {left: {mass: 2, centre_of_mass: [-0.1, 0]}, right: {mass: 3, centre_of_mass: [0.1, 0]},
         wheel: {inertia: 0.04}}
gravity: [0, -9.81]
couplings:
  a: {type: prismatic, bodies: [frame, left], at: [-0.1, 0], axis: y}
  b: {type: prismatic, bodies: [frame, right], at: [0.1, 0], axis: y}
  e: {type: revolute, bodies: [frame, wheel], at: [0, 5]}
cables:
  rope: {over: [{body: left, at: [-0.1, 0]}, {pulley: wheel, radius: 0.1, wrap: clockwise GRIP},
                {body: right, at: [0.1, 0]}]}
actuators: {motor: {coupling: e}}
curves: {push: {over: time, points: [[0 s, 0 N*m], [1 s, 5 N*m]], between: linear}}
"""
GRIP = ", friction: 0.2"

HOIST = """
kinestat: 1
space: planar
ground: frame
bodies: {load: {mass: 200, centre_of_mass: [0.2, 0]}, drum: {inertia: 8}}
gravity: [0, -9.81]
couplings:
  b: {type: prismatic, bodies: [frame, load], at: [0.2, 0], axis: y}
  e: {type: revolute, bodies: [frame, drum], at: [0, 10]}
cables: {rope: {over: [{pulley: drum, radius: 0.2, wrap: clockwise}, {body: load, at: [0.2, 0]}]}}
actuators: {motor: {coupling: e}}
curves: {brake: {over: time, between: linear,
                 points: [[0 s, 500 N*m], [0.5 s, 500 N*m], [1.5 s, -1500 N*m]]}}
simulation: {action: {motor: TORQUE}, STOPS time: TIME, steps: 6, tolerance: 1e-11,
             report: [position, velocity, acceleration, action, energy]}
"""

# A ball on a string: its place by slides, which have no mass.
BALL = """
kinestat: 1
space: planar
ground: frame
bodies: {x: {}, ball: {mass: 0.5, centre_of_mass: [0, -2]}}
gravity: [0, -9.81]
couplings:
  px: {type: prismatic, bodies: [frame, x], at: [0, -2], axis: x}
  py: {type: prismatic, bodies: [x, ball], at: [0, -2], axis: y}
cables: {string: {over: [{body: frame, at: [0, 0]}, {body: ball, at: [0, -2]}]}}
actuators: {side: {coupling: px}, up: {coupling: py}}
simulation: {action: {side: 0, up: 0}, start: {side: {speed: SPEED}}, time: 3 s, steps: 30,
             tolerance: 1e-11}
"""

DEFLECTED = """
kinestat: 1
space: planar
ground: frame
bodies: {left: {mass: 1, centre_of_mass: [-1, 0]}, right: {mass: 1, centre_of_mass: [1, 0]},
         wheel: {inertia: 0.001}}
couplings:
  a: {type: prismatic, bodies: [frame, left], at: [-1, 0], axis: x, friction: {c: 50}}
  b: {type: prismatic, bodies: [frame, right], at: [1, 0], axis: y}
  e: {type: revolute, bodies: [frame, wheel], at: [0, 0]}
cables:
  rope: {over: [{body: left, at: [-1, 0]}, {pulley: wheel, radius: 0.1, wrap: clockwise},
                {body: right, at: [1, 0]}]}
actuators: {hold: {coupling: a}, pull: {coupling: b}}
simulation: {action: {hold: -20, pull: 10}, time: 3 s, steps: 30, tolerance: 1e-11}
"""

BELT = """
kinestat: 1
space: planar
ground: frame
bodies: {driver: {inertia: 0.1}, driven: {inertia: 0.9}}
couplings:
  a: {type: revolute, bodies: [frame, driver], at: [0, 0]}
  b: {type: revolute, bodies: [frame, driven], at: [1, 0]}
cables:
  belt: {closed: true, over: [{pulley: driver, radius: 0.1, wrap: counterclockwise},
                              {pulley: driven, radius: 0.3, wrap: counterclockwise}]}
actuators: {motor: {coupling: a}}
simulation: {action: {motor: 2}, time: 1 s, steps: 4, tolerance: 1e-11}
"""

CAM = """
kinestat: 1
space: planar
ground: housing
bodies: {cam: {inertia: 0.01}, follower: {mass: 0.5, centre_of_mass: [0, 0.052]}}
couplings:
  a: {type: revolute, bodies: [housing, cam], at: [0, 0]}
  g: {type: prismatic, bodies: [housing, follower], at: [0, 0.052], axis: y}
  c: {type: cam, bodies: [cam, follower], at: [0.009 - 0.009*31/41, 0.012 + 0.04*31/41],
      normal: [-9, 40], radii: [0.031, 0.010]}
actuators: {motor: {coupling: a}, spring: {coupling: g}}
simulation: {action: {motor: 2, spring: -20 N}, time: 0.3 s, steps: 6, tolerance: 1e-11,
             report: [position, velocity, acceleration, action]}
"""


class Tackle:
    """Four falls: the rope passes sheave i at (5 - i)/4 of the speed of the hand."""

    mass, block, inertia, radius = 5.0, 100.0, 0.01, 0.05

    def __init__(self, down: float, eta: float = 1.0) -> None:
        """How fast the hand speeds up downwards; a sheave passes on eta of the tension ahead."""
        spins = [down * (4 - i) / 4 / self.radius for i in range(4)]

        def tensions(last: float) -> list[float]:
            found = [last]
            for spin in reversed(spins):
                found.insert(0, (found[0] + self.inertia * spin / self.radius) / eta)
            return found

        held = [sum(tensions(last)[1:]) for last in (0.0, 1.0)]
        self.tensions = tensions((self.block * (G + down / 4) - held[0]) / (held[1] - held[0]))
        falls = zip((-0.15, -0.05, 0.05, 0.15), self.tensions[1:])
        self.guide = -sum(x * t for x, t in falls) - self.inertia * (spins[1] + spins[3])
        self.down = down
        self.force = self.tensions[0] - self.mass * (G - down)

    @classmethod
    def of_force(cls, force: float, eta: float = 1.0) -> Tackle:
        """Pulled down by that force, which is linear in the acceleration."""
        rest = cls(0.0, eta).force
        return cls((force - rest) / (cls(1.0, eta).force - rest), eta)


class MotionTest(unittest.TestCase):
    def test_inertia_counts_in_every_row_however_far_the_sheaves_have_turned(self) -> None:
        """Bounds of their spins once swamped couples of inertia, which were left out."""
        report = program.run("motion", "-", text=TACKLE + """
cases: {pull: {motion: {hand: -1}, acceleration: {hand: -14}}}
motion: {drive: hand, to: -12, steps: 12, case: pull, report: [position, action]}
""")["motion"]
        columns = [f"{one['element']}/{one['quantity']}" for one in report["columns"]]
        expected = Tackle(14.0)
        for row in report["rows"]:
            at = dict(zip(columns, row))
            for i, tension in enumerate(expected.tensions):
                self.assertAlmostEqual(at[f"rope_{i + 1}.F/action"], tension, delta=1e-9 * 1000)
            self.assertAlmostEqual(at["L.Tz/action"], expected.guide, delta=1e-9 * 1000)


class CableCase(simulations.SimulationCase):
    def conserves(self, found: Simulation) -> None:
        self.assertLessEqual(found.report["energy_drift"], 1e-6 * found.report["energy_scale"])

    def ends_with(self, found: Simulation, kind: str, element: str) -> float:
        self.assertEqual(found.report["status"], "parted")
        event = found.events[-1]
        self.assertEqual((event["kind"], event["element"]), (kind, element))
        self.assertEqual(event["time"], found.columns["time"][-1])
        self.assertIsNone(event["position"])
        return event["time"]

    def check_tackle(self, found: Simulation, force: float, eta: float = 1.0) -> None:
        expected = Tackle.of_force(force, eta)
        down = expected.down
        for i, time in enumerate(found.columns["time"]):
            at = {name: values[i] for name, values in found.columns.items()}
            self.near(at["H.vy/position"], -down * time ** 2 / 2, 1e-9 * 10)
            self.near(at["H.vy/acceleration"], -down, 1e-9 * 10)
            for k, tension in enumerate(expected.tensions):
                self.near(at[f"rope_{k + 1}.F/action"], tension, 1e-9 * 1000)
            if eta == 1.0:
                self.near(at["L.Tz/action"], expected.guide, 1e-9 * 1000)


class CableSimulationTest(CableCase):
    def test_machine_of_atwood(self) -> None:
        found = Simulation(ATWOOD.replace("GRIP", "") + """
simulation: {action: {motor: 0}, time: 1 s, steps: 4, tolerance: 1e-11,
             report: [position, velocity, acceleration, action, energy]}
""")
        up = (3 - 2) * G / (2 + 3 + 0.04 / 0.1 ** 2)
        for i, time in enumerate(found.columns["time"]):
            at = {name: values[i] for name, values in found.columns.items()}
            self.near(at["a.vy/acceleration"], up, 1e-10 * G)
            self.near(at["a.vy/position"], up * time ** 2 / 2, 1e-10)
            self.near(at["e.wz/velocity"], -up * time / 0.1, 1e-9)
            self.near(at["rope_1.F/action"], 2 * (G + up), 1e-9 * 30)
            self.near(at["rope_2.F/action"], 3 * (G - up), 1e-9 * 30)
        self.conserves(found)

    def test_hoist_by_torque_and_reflected_inertia(self) -> None:
        found = Simulation(HOIST.replace("TORQUE", "500").replace("STOPS", "")
                           .replace("TIME", "1 s"))
        up = (500 / 0.2 - 200 * G) / (200 + 8 / 0.2 ** 2)
        self.near(found.last()["b.vy/position"], up / 2, 1e-10)
        self.near(found.last()["rope_1.F/action"], 200 * (G + up), 1e-9 * 2000)
        self.near(500, 0.2 * 200 * (G + up) + 8 * up / 0.2, 1e-9)
        self.conserves(found)

    def test_tackle_with_heavy_sheaves(self) -> None:
        found = Simulation(TACKLE + """
simulation: {action: {hand: -260}, time: 1.5 s, steps: 6, tolerance: 1e-11,
             report: [position, acceleration, action, energy]}
""")
        self.check_tackle(found, 260.0)
        self.conserves(found)

    def test_first_row_is_that_of_analyze(self) -> None:
        first = Simulation(TACKLE + "simulation: {action: {hand: -260}, time: 1 s, steps: 1, "
                                    "report: [acceleration, action]}").at(0.0)
        case = program.run("analyze", "-", text=TACKLE + f"""
cases: {{still: {{motion: {{hand: 0}}, acceleration: {{hand: {first["H.vy/acceleration"]!r}}}}}}}
""")["cases"]["still"]
        for name, value in case["statics"]["actions"].items():
            self.near(first[f"{name}/action"], value, 1e-9 * 1000, name)
        self.near(case["statics"]["actions"]["hand"], -260, 1e-9 * 1000)

    def test_rope_goes_slack_where_a_drum_lets_it_fall(self) -> None:
        """The load falls freely once the drum turns as fast: torque - J g/r."""
        found = Simulation(HOIST.replace("TORQUE", "brake").replace("STOPS", "")
                           .replace("TIME", "1.5 s"))
        time = self.ends_with(found, "cable_slack", "rope_1")
        self.near(500 - 2000 * (time - 0.5), -8 * G / 0.2, 1e-5)
        last = found.last()
        self.near(last["b.vy/acceleration"], -G, 1e-7)
        self.near(last["rope_1.F/action"], 0.0, 1e-4)
        self.assertTrue(all(force > -1e-4 for force in found.columns["rope_1.F/action"]))
        self.conserves(found)

    def test_slack_at_once(self) -> None:
        found = Simulation(HOIST.replace("TORQUE", "-400").replace("STOPS", "")
                           .replace("TIME", "1 s"))
        self.assertEqual(self.ends_with(found, "cable_slack", "rope_1"), 0.0)
        self.assertEqual(len(found.columns["time"]), 1)
        hung = Simulation(HOIST.replace("TORQUE", "-390").replace("STOPS", "")
                          .replace("TIME", "1 s"))
        self.assertEqual(hung.report["status"], "complete")

    def test_impact_that_a_rope_cannot_pass_on(self) -> None:
        """A falling load meets the floor, and the drum turns on."""
        found = Simulation(HOIST.replace("TORQUE", "300").replace("TIME", "3 s")
                           .replace("STOPS", "stops: {b.vy: {from: -0.5, restitution: 0.3}},"))
        time = self.ends_with(found, "cable_slack", "rope_1")
        down = (200 * G - 300 / 0.2) / (200 + 8 / 0.2 ** 2)
        self.near(time, math.sqrt(2 * 0.5 / down), 1e-9)
        self.near(found.last()["b.vy/velocity"], -down * time, 1e-8)

    def test_impact_that_a_rope_passes_on(self) -> None:
        """Stopped from above, load and drum lose speed together."""
        found = Simulation(HOIST.replace("TORQUE", "500").replace("TIME", "3 s")
                           .replace("STOPS", "stops: {b.vy: {to: 0.5, restitution: 0.3}},"))
        self.assertEqual(found.report["status"], "complete")
        up = (500 / 0.2 - 200 * G) / (200 + 8 / 0.2 ** 2)
        first = found.events[0]
        self.near(first["speed"], math.sqrt(2 * 0.5 * up), 1e-8)
        # All that the weight does not take is lost in impacts.
        self.near(found.last()["energy/lost"], 500 * 0.5 / 0.2 - 200 * G * 0.5, 1e-6)

    def test_ball_leaves_the_circle_of_its_string(self) -> None:
        """v^2 = k g l at the bottom: slack where cos = (2 - k)/3, for 2 < k < 5."""
        k, length = 3.0, 2.0
        found = Simulation(BALL.replace("SPEED", repr(math.sqrt(k * G * length))))
        self.ends_with(found, "cable_slack", "string_1")
        last = found.last()
        self.near((2 - last["py.vy/position"]) / length, (2 - k) / 3, 1e-7)
        self.conserves(found)
        # Less than that, and it swings.
        swings = Simulation(BALL.replace("SPEED", repr(math.sqrt(1.9 * G * length))))
        self.assertEqual(swings.report["status"], "complete")
        self.near(max(swings.columns["py.vy/position"]), 0.95 * length, 0.1)

    def test_cable_slips_where_friction_no_longer_holds_it(self) -> None:
        found = Simulation(ATWOOD.replace("GRIP", GRIP) + """
simulation: {action: {motor: push}, time: 1 s, steps: 4, tolerance: 1e-11, report: [action]}
""")
        time = self.ends_with(found, "cable_slips", "rope_wheel")
        up = (3 * G - 2 * G - 5 * time / 0.1) / (2 + 3 + 0.04 / 0.1 ** 2)
        self.near(3 * (G - up) / (2 * (G + up)), math.exp(0.2 * math.pi), 1e-7)

    def test_cable_lifts_off_where_its_ends_are_in_line(self) -> None:
        found = Simulation(DEFLECTED)
        self.ends_with(found, "lift_off", "rope_wheel")
        last = found.last()
        left, rise = -1 + last["a.vx/position"], last["b.vy/position"]
        span = math.hypot(1 - left, rise)
        self.near(span, 2 * math.sqrt(1 - 0.01) + 0.1 * 2 * math.asin(0.1), 1e-9)
        self.near(abs(left * rise) / span, 0.1, 1e-9)  # of the pulley from the line
        self.conserves(found)

    def test_belt_with_a_pretension_that_nothing_gives(self) -> None:
        done = program.call("simulate", "-", text=BELT)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"W0601.*'belt_1', 'belt_2'")
        found = Simulation(BELT)
        self.near(found.last()["a.wz/position"], 2 / (0.1 + 0.9 / 9) / 2, 1e-9)
        self.near(found.last()["b.wz/position"], 10 / 3 / 2, 1e-9)


class CableFrictionSimulationTest(CableCase):
    """Of a sheave that nothing turns but a rope with the tension T ahead, eta T is left behind; of
    one that the cable slips over, T exp(-mu theta). What drives the sheave takes 1/eta."""

    def atwood(self, grip: str, simulation: str) -> Simulation:
        found = Simulation(ATWOOD.replace("GRIP", ", " + grip) +
                           f"simulation: {{{simulation}, time: 1 s, steps: 4, tolerance: 1e-11}}\n")
        self.assertEqual(found.report["status"], "complete")
        self.conserves(found)
        return found

    def test_sheave_with_an_efficiency(self) -> None:
        found = self.atwood("eta: 0.9", "action: {motor: 0}")
        up = G * (3 * 0.9 - 2) / (3 * 0.9 + 2 + 4)
        self.near(found.last()["a.vy/acceleration"], up, 1e-9 * G)
        self.near(found.last()["energy/lost"], (1 - 0.9) * 3 * (G - up) * up / 2, 1e-8)
        # Turning the other way the lighter block is ahead, and the inertia of the wheel drives.
        found = self.atwood("eta: 0.9", "action: {motor: 0}, start: {motor: {speed: 30}}")
        down = G * (3 / 0.9 - 2) / (3 / 0.9 + 2 + 4)
        self.near(found.last()["e.wz/acceleration"], -10 * down, 1e-8 * 10)

    def test_sheave_that_holds_at_rest(self) -> None:
        found = self.atwood("eta: 0.6", "action: {motor: 0}")
        self.assertEqual(found.last()["b.vy/position"], 0.0)
        self.near(found.last()["e/friction"], (3 - 2) * G * 0.1, 1e-12)

    def test_rope_that_slips_over_a_post(self) -> None:
        found = self.atwood("slip: true, friction: 0.1", "motion: {motor: 0}")
        ratio = math.exp(0.1 * math.pi)
        self.near(found.last()["a.vy/position"], G * (3 - 2 * ratio) / (3 + 2 * ratio) / 2, 1e-9)

    def test_rope_that_begins_to_slip(self) -> None:
        """When the couple of the wheel is more than friction passes on."""
        found = self.atwood("slip: true, friction: 0.2", "action: {motor: push}")
        self.assertEqual([event["kind"] for event in found.events], ["stick", "slip"])
        up = (3 * G - 2 * G - 5 * found.events[1]["time"] / 0.1) / (2 + 3 + 4)
        self.near(3 * (G - up) / (2 * (G + up)), math.exp(0.2 * math.pi), 1e-8)

    def test_tackle_with_efficiencies(self) -> None:
        for force, eta in ((330.0, 0.95), (400.0, 0.9)):
            found = Simulation(TACKLE.replace("radius: 0.05", f"radius: 0.05, eta: {eta}") + f"""
simulation: {{action: {{hand: {-force}}}, time: 1 s, steps: 4, tolerance: 1e-11,
             report: [position, acceleration, action, energy]}}
""")
            self.check_tackle(found, force, eta)
            self.conserves(found)

    def test_tackle_whose_rope_may_slip_but_does_not(self) -> None:
        """Then sheaves lose what they do without slip, from rest on."""
        for slipping in (1, 2, 4):
            text = TACKLE.replace("radius: 0.05", "radius: 0.05, eta: 0.95")
            text = text.replace("eta: 0.95", "eta: 0.95, slip: true, friction: 1", slipping)
            found = Simulation(text + """
simulation: {action: {hand: -330}, time: 1 s, steps: 2, tolerance: 1e-11,
             report: [position, acceleration, action, energy]}
""")
            self.check_tackle(found, 330.0, 0.95)
            self.conserves(found)

    def test_drum_with_an_efficiency(self) -> None:
        """Winding up, it takes 1/eta of what the rope asks for."""
        found = Simulation(HOIST.replace("radius: 0.2", "radius: 0.2, eta: 0.9")
                           .replace("TORQUE", "500").replace("STOPS", "").replace("TIME", "1 s"))
        up = (500 / 0.2 - 200 * G / 0.9) / (200 / 0.9 + 8 / 0.2 ** 2)
        self.near(found.last()["b.vy/acceleration"], up, 1e-9 * G)
        self.conserves(found)


class ContactSimulationTest(simulations.SimulationCase):
    def test_follower_lifts_where_its_spring_is_too_weak(self) -> None:
        """The only coordinate is the angle; y is by the triangle of cam, disc and tip."""
        ex, ey, reach, mass, inertia, press = 0.009, 0.012, 0.041, 0.5, 0.01, 20.0

        def lift(angle: float) -> tuple[float, float]:
            x = ex * math.cos(angle) - ey * math.sin(angle)
            y = ex * math.sin(angle) + ey * math.cos(angle)
            root = math.sqrt(reach ** 2 - x ** 2)
            return (x + x * y / root,
                    -y + (x ** 2 - y ** 2) / root - (x * y) ** 2 / root ** 3)

        def speed_up(angle: float, speed: float) -> float:
            first, second = lift(angle)
            return ((2.0 - press * first - mass * first * second * speed ** 2) /
                    (inertia + mass * first ** 2))

        def force(state: list[float]) -> float:
            first, second = lift(state[0])
            return press + mass * (first * speed_up(*state) + second * state[1] ** 2)

        found = Simulation(CAM)
        self.assertEqual(found.report["status"], "parted")
        event = found.events[-1]
        self.assertEqual((event["kind"], event["element"]), ("contact_pulls", "c"))
        state, steps = [0.0, 0.0], 2000
        for _ in range(steps):
            self.assertGreater(force(state), 0.0)
            state = simulations.runge_kutta(lambda s: [s[1], speed_up(*s)], state,
                                            event["time"] / steps, 1)
        self.near(force(state), 0.0, 1e-5 * press)
        self.near(found.last()["a.wz/position"], state[0], 1e-7)
        self.near(found.last()["a.wz/velocity"], state[1], 1e-6)
        self.near(found.last()["c.R/action"], 0.0, 1e-5 * press)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
