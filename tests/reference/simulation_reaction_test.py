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

# A crank moves a tray by a rod, on which a part lies that nothing else guides.
TRAY = """
kinestat: 1
space: planar
ground: frame
bodies:
  crank: {inertia: 0.01}
  rod: {mass: 1, centre_of_mass: [0.2, 0], inertia: 0.01}
  tray: {mass: 5, centre_of_mass: [0.35, 0]}
  part: {mass: 1.5, centre_of_mass: [0.35, 0]}
gravity: [0, -9.81]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0.03, 0.04]}
  c: {type: revolute, bodies: [rod, tray], at: [0.35, 0]}
  d: {type: prismatic, bodies: [frame, tray], at: [0.35, 0], axis: x}
  e: {type: prismatic, bodies: [tray, part], at: [0.35, 0], axis: xFRICTION}
actuators: {M: {coupling: a}, E: {coupling: e}}
simulation: {action: {E: 0}, motion: {M: SPEED}, START, time: 0.2 s, steps: 20,
             report: [position, velocity, acceleration, action]}
"""


def tray(friction: str, speed: float, start: str = "start: {e.vx: {speed: 0}}") -> Simulation:
    return Simulation(TRAY.replace("FRICTION", friction).replace("SPEED", str(speed))
                      .replace("START", start))


class ReactionTest(simulations.SimulationCase):
    def test_a_tray_bears_what_lies_on_it(self) -> None:
        """What nothing moves along the tray has no equation there but that of rounding."""
        turned = (0.17 - 0.04j) / (0.32 - 0.04j)  # the centre of the rod, from b towards c

        def height(time: float) -> float:
            pin = complex(0.03, 0.04) * complex(math.cos(10 * time), math.sin(10 * time))
            rod = complex(math.sqrt(abs(0.32 - 0.04j) ** 2 - pin.imag ** 2), -pin.imag)
            return (pin + turned * rod).imag

        def rise(time: float) -> float:
            parts = ((-2, -1), (-1, 16), (0, -30), (1, 16), (2, -1))
            return sum(weight * height(time + step * 1e-3) for step, weight in parts) / 12e-6

        found = tray("", 10)
        for i, time in enumerate(found.columns["time"]):
            at = {name: values[i] for name, values in found.columns.items()}
            self.near(at["e.Ry/action"], 1.5 * G, 1e-12, f"{time}")
            # All that the frame bears upwards is the weight, and what lifts the rod.
            self.near(at["a.Ry/action"] + at["d.Ry/action"], 7.5 * G + rise(time), 1e-7, f"{time}")

    def test_a_tray_that_is_tilted_next_to_nothing_bears_as_much(self) -> None:
        """Along the tray the part has an equation of the tilt alone, by which rounding is divided."""
        for tilt in ("1e-14", "1e-13", "5e-13", "1e-12", "1e-11", "-3e-11", "9e-11"):
            text = TRAY.replace("axis: xFRICTION", f"axis: [1, {tilt}]").replace("SPEED", "10")
            found = Simulation(text.replace("START", "start: {e.v: {speed: 0}}"))
            for force in found.columns["e.R/action"]:
                self.near(abs(force), 1.5 * G, 1e-9, tilt)

    def test_what_slides_on_a_tray_is_braked_by_its_weight(self) -> None:
        found = tray(", friction: {mu: 0.1}", 10, "start: {e.vx: {speed: 5}}")
        for force in found.columns["e/friction"]:
            self.near(force, -0.15 * G, 1e-12)
        speeds = [tray_speed + part_speed for tray_speed, part_speed in
                  zip(found.columns["d.vx/velocity"], found.columns["e.vx/velocity"])]
        self.near(speeds[-1] - speeds[0], -0.1 * G * 0.2, 1e-9)

    def test_what_lies_on_a_tray_sticks_as_long_as_friction_holds_it(self) -> None:
        """A crank of 0.05 m at 10 rad/s asks for 5 m/s^2 and what the rod adds, of 19.62."""
        found = tray(", friction: {mu: 2}", 10)
        self.assertEqual([event["kind"] for event in found.events], ["stick"])
        self.assertEqual(set(found.columns["e.vx/velocity"]), {0.0})

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
        self.assertIn("spring.s/couple", found.columns)
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
            self.near(at["spring.s/angle"], at["b.wz/position"], 1e-12, f"spring {time}")
            self.near(at["spring.s/couple"], 3 * (0.2 - at["b.wz/position"]) - 0.1 * spin, 1e-9,
                      f"spring {time}")
            self.near(at["spring.k/length"], 1 + at["a.vx/position"], 1e-12, f"spring {time}")
            self.near(at["spring.k/force"], 40 * (0.1 + at["a.vx/position"]), 1e-10, f"spring {time}")
        self.assertIn("impact", [event["kind"] for event in found.events])

    def test_bearing_of_a_pendulum(self) -> None:
        text = simulations.PENDULUM.replace("tolerance", "report: [a, energy], tolerance")
        found = Simulation(text)
        for row in CASES["pendulum_forward"]["expected"]["rows"]:
            at = found.at(row["time"])
            self.near(at["a.Rx/action"], row["bearing"][0], 1e-8 * 70)
            self.near(at["a.Ry/action"], row["bearing"][1], 1e-8 * 70)
            self.near(at["a/force"], math.hypot(*row["bearing"][:2]), 1e-8 * 70)
        # Tension m g cos + m l w^2 along the rod.
        for i, angle in enumerate(found.columns["a.wz/position"]):
            pull = (-math.sin(angle) * found.columns["a.Rx/action"][i] +
                    math.cos(angle) * found.columns["a.Ry/action"][i])
            speed = found.columns["a.wz/velocity"][i]
            self.near(pull, 2 * G * math.cos(angle) + 2 * 0.5 * speed ** 2, 1e-7)
        for name in found.columns:
            self.assertTrue(name == "time" or name.startswith(("a.", "a/force", "energy/")), name)

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



PINION, WHEEL = 0.5, 3.0    # inertias
SMALL, LARGE = 2.0, 5.0     # radii
APART = math.tan(math.radians(20))
WEIGHT = 2 * G

GEARS = """
kinestat: 1
space: planar
ground: frame
gravity: [0, -9.81]
bodies: {pinion: {mass: 2, centre_of_mass: [0, 0], inertia: 0.5}, wheel: {inertia: 3}}
couplings:
  a: {type: revolute, bodies: [frame, pinion], at: [0, 0]FRICTION}
  b: {type: revolute, bodies: [frame, wheel], at: [0, 7]}
  m: {type: gear, bodies: BODIES, at: [0, 2], MESH}
actuators: {motor: {coupling: a}}
curves: {ramp: {over: time, points: [[0 s, 6], [1 s, -6]], between: linear}}
simulation: {action: {motor: TORQUE}, time: 1 s, steps: 8, tolerance: 1e-11,
             report: [velocity, acceleration, action, a, b, m]}
"""
TANGENT = "tangent: x, pressure_angle: 20 deg"
def gears(torque: float | str, mesh: str = TANGENT, bodies: str = "[pinion, wheel]",
          friction: str = "") -> str:
    text = GEARS
    for word, value in (("TORQUE", torque), ("MESH", mesh), ("BODIES", bodies), ("FRICTION", friction)):
        text = text.replace(word, str(value))
    return text


class TeethTest(simulations.SimulationCase):
    """The wheel is above the pinion: its teeth press the pinion down under either load."""

    def test_part_the_gears_whichever_drives(self) -> None:
        for mesh in (TANGENT, "line_of_action: [cos(20 deg), sin(20 deg)]"):
            for bodies in ("[pinion, wheel]", "[wheel, pinion]"):
                found = Simulation(gears("ramp", mesh, bodies))
                for i, time in enumerate(found.columns["time"]):
                    at = {name: values[i] for name, values in found.columns.items()}
                    turns = (6 - 12 * time) / (PINION + WHEEL * (SMALL / LARGE) ** 2)
                    tangential = WHEEL * turns * SMALL / LARGE ** 2
                    self.near(at["a.wz/acceleration"], turns, 1e-9, f"{time}")
                    self.near(at["a.Rx/action"], -tangential, 1e-9, f"{time}")
                    self.near(at["a.Ry/action"], WEIGHT + abs(tangential) * APART, 1e-9, f"{time}")
                    self.near(at["b.Ry/action"], -abs(tangential) * APART, 1e-9, f"{time}")

    def test_press_on_bearings_that_rub(self) -> None:
        for sign in (1, -1):
            found = Simulation(gears(6.0 * sign, friction=", friction: {mu: 0.1, radius: 0.4}"))
            turns = 0.0
            for _ in range(100):
                tangential = WHEEL * turns * SMALL / LARGE ** 2
                rubs = 0.04 * math.hypot(tangential, WEIGHT + tangential * APART)
                turns = (6.0 - rubs) / (PINION + WHEEL * (SMALL / LARGE) ** 2)
            last = found.last()
            self.near(last["a.wz/acceleration"], sign * turns, 1e-9, f"{sign}")
            self.near(last["a.wz/velocity"], sign * turns, 1e-9, f"{sign}")
            self.near(last["a.Ry/action"], WEIGHT + tangential * APART, 1e-9, f"{sign}")
            self.near(last["a/friction"], -sign * rubs, 1e-9, f"{sign}")

    def test_on_a_fixed_flank_pull_under_the_other_load(self) -> None:
        loads = [Simulation(gears(6.0 * sign, TANGENT + ", flank: fixed")).last()["b.Ry/action"]
                 for sign in (1, -1)]
        self.near(loads[0], -loads[1], 1e-12)
        self.assertGreater(abs(loads[0]), 0.1)

    def test_of_contacts_are_said_to_pull(self) -> None:
        for sign, codes in ((1, ["W0610"]), (-1, [])):
            done = program.call("simulate", "-", text=gears(6.0 * sign, TANGENT + ", contact: true"))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual([line.split("[")[1][:5] for line in done.stderr.splitlines()
                              if "warning[W06" in line], codes)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
