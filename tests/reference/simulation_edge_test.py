#!/usr/bin/env python3
"""What simulations of edges do: stops, curves, dead points, what is held or has no mass.

Usage: simulation_edge_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest

import program

# A crank drives a rocker by a rod between two balls; the rod has neither mass nor inertia.
BALLS = """
kinestat: 1
ground: frame
bodies:
  crank: {mass: 1, centre_of_mass: [0, 0, 0], inertia: [0.01, 0.01, 0.02]}
  rod: {}
  rocker: {mass: 1, centre_of_mass: [1, 0, 0], inertia: [0.01, 0.01, 0.02]}
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}
  b: {type: spherical, bodies: [crank, rod], at: [0, 0.2, 0]}
  c: {type: spherical, bodies: [rod, rocker], at: [1, 0.5, 0.1]}
  d: {type: revolute, bodies: [frame, rocker], at: [1, 0, 0], axis: [0, 0.3, 1]}
actuators: {m: {coupling: a}}
loads: {twist: {body: rod, LOAD}}
simulation: {action: {m: 1}, time: 0.1 s, steps: 2}
"""

# Links of 0.2 m and 0.5 m, drawn at 60 degrees.
PARALLELOGRAM = """
kinestat: 1
space: planar
ground: frame
parameters: {y: 0.1*sqrt(3)}
bodies:
  crank: {mass: 1, centre_of_mass: [0.05, y/2], inertia: 0.01}
  coupler: {mass: 0.5, centre_of_mass: [0.35, y], inertia: 0.02}
  rocker: {mass: 1, centre_of_mass: [0.55, y/2], inertia: 0.01}
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [0.1, y]}
  c: {type: revolute, bodies: [coupler, rocker], at: [0.6, y]}
  d: {type: revolute, bodies: [frame, rocker], at: [0.5, 0]}
actuators: {m: {coupling: a}}
simulation: {action: {m: 0.5}, start: {m: {speed: 5}}, time: 3 s, steps: STEPS}
"""

CART = """
kinestat: 1
space: planar
ground: frame
bodies: {cart: {mass: 2, centre_of_mass: [0, 0], inertia: 0.1},
         pendulum: {mass: 1, centre_of_mass: [0.3, -0.4], inertia: 0.01}}
couplings: {a: {type: prismatic, bodies: [frame, cart], at: [0, 0], axis: x},
            b: {type: revolute, bodies: [cart, pendulum], at: [0, 0]}}
actuators: {push: {coupling: a}, swing: {coupling: b}}
simulation: {SECTION, time: 2 s, steps: 4}
"""
ALONE = """
kinestat: 1
space: planar
ground: frame
bodies: {cart: {mass: 2, centre_of_mass: [0, 0], inertia: 0.1}}
couplings: {a: {type: prismatic, bodies: [frame, cart], at: [0, 0], axis: x}}
actuators: {push: {coupling: a}}
curves: {saw: {over: time, points: [[0, 0 N], [HALF, 1 N], [PERIOD, 0 N]], period: PERIOD}}
simulation: {SECTION}
"""
# On a stop where they hang.
PENDULUMS = """
kinestat: 1
space: planar
ground: frame
gravity: [0, -9.81]
BODIES
actuators: {m: {coupling: a}}
simulation: {action: {m: 0}, start: {m: {position: 90 deg}}, stops: {m: {from: 0 deg}}, UNTIL
             time: 2 s, steps: 20}
"""
ONE = """bodies: {upper: {mass: 2, centre_of_mass: [0, -0.5], inertia: 0.1}}
couplings: {a: {type: revolute, bodies: [frame, upper], at: [0, 0]}}"""
TWO = """bodies: {upper: {mass: 2, centre_of_mass: [0, -0.5], inertia: 0.1},
         lower: {mass: 1, centre_of_mass: [0, -1.5], inertia: 0.1}}
couplings: {a: {type: revolute, bodies: [frame, upper], at: [0, 0]},
            b: {type: revolute, bodies: [upper, lower], at: [0, -1]}}"""
# The crank strikes; the rocker is what is watched.
FOUR_BAR = """
kinestat: 1
space: planar
ground: frame
units: {length: mm, angle: deg}
gravity: [0, -9810]
bodies:
  crank: {mass: 1, centre_of_mass: [15, 20], inertia: 0.001}
  coupler: {mass: 2, centre_of_mass: [90, 70], inertia: 0.004}
  rocker: {mass: 1.5, centre_of_mass: [155, 50], inertia: 0.003}
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [30, 40]}
  c: {type: revolute, bodies: [coupler, rocker], at: [150, 100]}
  d: {type: revolute, bodies: [frame, rocker], at: [160, 0]}
actuators: {m: {coupling: a}, l: {coupling: d}}
simulation: {action: {m: 0, l: 0}, stops: {m: {from: -10, to: 400}}, until: {l: {speed: 0}},
             time: 3 s, steps: 4}
"""
# A flat follower on a circle about a point 12 mm off the axis.
CAM = """
kinestat: 1
space: planar
units: {length: mm}
ground: frame
gravity: [0, -9810]
bodies: {cam: {mass: 1, centre_of_mass: [0, 0], inertia: 0.001},
         follower: {mass: 0.5, centre_of_mass: [12, 60]}}
couplings:
  a: {type: revolute, bodies: [frame, cam], at: [0, 0]}
  c: {type: cam, bodies: [cam, follower], at: [12, 31], normal: y, radii: [31, flat]}
  g: {type: prismatic, bodies: [frame, follower], at: [0, 70], axis: y}
actuators: {shaft: {coupling: a}}
simulation: {action: {shaft: 0}, start: {shaft: {speed: 10}}, time: 0.1, steps: 4}
"""

# A four-bar, a slide on a spring beside it, and a rotor far away, none of which feels the others.
FAR = """
kinestat: 1
space: planar
ground: frame
gravity: [0, -9.81]
parameters: {D: 1, k: 400 N/m}
bodies: {k2: {mass: 1, centre_of_mass: [0.05, 0], inertia: 0.01},
         k3: {mass: 1, centre_of_mass: [0.3, 0.2], inertia: 0.01},
         k4: {mass: 1, centre_of_mass: [0.5, 0.2], inertia: 0.01},
         far: {mass: 1, centre_of_mass: [D, 0], inertia: 0.01}}
couplings:
  a: {type: revolute, bodies: [frame, k2], at: [0, 0]}
  b: {type: revolute, bodies: [k2, k3], at: [0.1, 0]}
  c: {type: revolute, bodies: [k3, k4], at: [0.5, 0.4]}
  d: {type: revolute, bodies: [frame, k4], at: [0.5, 0]}
  e: {type: revolute, bodies: [frame, far], at: [D, 0]}
actuators: {m: {coupling: a}, f: {coupling: e}}
simulation: {action: {m: 0.1, f: 0.2}, time: 0.2, steps: 2}
"""
# A ram driven by a crank on a spring far from a rotor: m x'' = -k x.
FAR_RAM = """
kinestat: 1
space: planar
ground: frame
parameters: {D: 1}
bodies: {crank: {}, rod: {}, ram: {mass: 2, centre_of_mass: [0.3, 0]},
         far: {mass: 1, centre_of_mass: [D, 0], inertia: 0.01}}
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0, 0.1]}
  c: {type: revolute, bodies: [rod, ram], at: [0.3, 0]}
  d: {type: prismatic, bodies: [frame, ram], at: [0.3, 0], axis: x}
  e: {type: revolute, bodies: [frame, far], at: [D, 0]}
actuators: {p: {coupling: d}, f: {coupling: e}}
springs: {s: {coupling: d, stiffness: 800 N/m, free: 0}}
simulation: {action: {p: 0, f: 0.2}, start: {p: {speed: 0.2}}, time: 1, steps: 4}
"""
# The rotor meshes with the crank of the four-bar, one to one; wheels as large as that is far.
FAR_GEAR = FAR.replace("actuators: {m", """  g: {type: gear, bodies: [k2, far], at: [D/2, 0], tangent: y, pressure_angle: 20 deg}
actuators: {m""").replace("f: 0.2}", "f: 0}")
# A pinion of radius 0.05 on the far end of the ram: m + J/r^2 = 2 + 4.
FAR_RACK = FAR_RAM.replace("actuators: {p", """  g: {type: rack, bodies: [far, ram], at: [D, 0], line_of_action: [cos(20 deg), -sin(20 deg)]}
actuators: {p""").replace("[D, 0], inertia", "[D, 0.05], inertia").replace(
    "[frame, far], at: [D, 0]", "[frame, far], at: [D, 0.05]").replace("f: 0.2}", "f: 0}")
# Two masses on a rough rail, pulled against their stops.
TWO_STOPS = """
kinestat: 1
space: planar
ground: frame
bodies: {m: {mass: 2, centre_of_mass: [0, 0]}, k: {mass: 1, centre_of_mass: [3, 0]}}
couplings:
  g: {type: prismatic, bodies: [frame, m], at: [0, 0], axis: x}
  h: {type: prismatic, bodies: [frame, k], at: [3, 0], axis: x}
actuators: {p: {coupling: g}, q: {coupling: h}}
simulation: {action: {p: 20 N, q: 20 N}, time: 2, steps: 4,
             stops: {p: {to: 0.4, restitution: 0}, q: {to: 0.4 + 1, restitution: 0.5}}}
"""


def agm(a: float, b: float) -> float:
    """The arithmetic-geometric mean, by which a pendulum swings."""
    for _ in range(8):
        a, b = (a + b) / 2, math.sqrt(a * b)
    return a


class FarBodies(unittest.TestCase):
    """What is far away from others changes nothing of them."""

    def values(self, text: str, distance: float) -> tuple[list[str], list[list[float | None]]]:
        text = text.replace("{D: 1", f"{{D: {distance}")
        simulation = program.run("simulate", "-", text=text)["simulation"]
        self.assertEqual(simulation["status"], "complete", distance)
        return [one["name"] for one in simulation["columns"]], simulation["rows"]

    def test_a_rotor_far_from_a_four_bar(self) -> None:
        names, near = self.values(FAR, 1)
        for sizes, within in ((10, 1e-12), (1e3, 1e-11), (1e5, 1e-9), (1e6, 1e-8)):
            _, far = self.values(FAR, 0.64 * sizes)
            for c, name in enumerate(names):
                if name.startswith("energy"):  # from differences of high potentials and works
                    continue
                largest = max(abs(row[c] or 0.0) for row in near)
                for row, other in zip(near, far):
                    self.assertIsNotNone(other[c], (sizes, name))
                    self.assertAlmostEqual(row[c], other[c], delta=within * largest,
                                           msg=f"{name} {sizes}")

    def test_a_wheel_far_from_the_one_that_it_meshes_with(self) -> None:
        names, near = self.values(FAR_GEAR, 1)
        for sizes, within in ((1e3, 1e-10), (1e5, 1e-9), (1e6, 1e-8)):
            _, far = self.values(FAR_GEAR, 0.64 * sizes)
            for name in ("a.wz/position", "a.wz/velocity", "e.wz/velocity", "d.wz/velocity"):
                c = names.index(name)
                largest = max(abs(row[c]) for row in near)
                for row, other in zip(near, far):
                    self.assertAlmostEqual(row[c], other[c], delta=within * largest,
                                           msg=f"{name} {sizes}")

    def test_a_pinion_far_along_a_rack(self) -> None:
        omega = math.sqrt(800 / 6)
        for distance in (1.0, 1e3, 3e5):
            names, rows = self.values(FAR_RACK, distance)
            place = names.index("d.vx/position")
            for row in rows:
                self.assertAlmostEqual(row[place], 0.2 / omega * math.sin(omega * row[0]),
                                       delta=1e-9, msg=str(distance))

    def test_motions_have_the_same_accelerations(self) -> None:
        section = ("cases: {run: {motion: {m: 1, f: 1}}}\n"
                   "motion: {drives: [{drive: m, to: 0.2}, {drive: f, to: 0.2}], case: run, steps: 2,\n"
                   "         report: [velocity, acceleration]}\n")
        text = FAR[:FAR.index("simulation:")] + section

        def row(distance: float) -> dict[str, float | None]:
            motion = program.run("motion", "-", text=text.replace("{D: 1", f"{{D: {distance}"))
            names = [one["name"] for one in motion["motion"]["columns"]]
            return dict(zip(names, motion["motion"]["rows"][-1]))

        near, far = row(1.0), row(6.4e4)
        for name, value in near.items():
            if not name.startswith("far"):
                self.assertIsNotNone(far[name], name)
                self.assertAlmostEqual(value, far[name], delta=1e-8, msg=name)

    def test_a_slide_far_from_a_rotor_swings_as_its_spring_says(self) -> None:
        for distance in (1.0, 1e3, 3e5):
            names, rows = self.values(FAR_RAM, distance)
            place = names.index("d.vx/position")
            for row in rows:
                self.assertAlmostEqual(row[place], 0.2 / 20 * math.sin(20 * row[0]), delta=1e-9,
                                       msg=str(distance))


class Stops(unittest.TestCase):
    def test_what_rests_rests_once(self) -> None:
        """p comes to rest at sqrt(2 0.4 / 10) s; q bounces on while it does."""
        simulation = program.run("simulate", "-", text=TWO_STOPS)["simulation"]
        rests = [(one["element"], one["time"]) for one in simulation["events"] if one["kind"] == "rest"]
        self.assertEqual([of for of, _ in rests], ["p", "q"])
        self.assertAlmostEqual(rests[0][1], math.sqrt(0.08), delta=1e-9)
        # Each flight of q takes half as long as the one before, and the first v / a, v of its fall.
        falls = math.sqrt(2 * 1.4 / 20)
        self.assertAlmostEqual(rests[1][1], falls + 2 * falls, delta=1e-6)
        impacts = [one for one in simulation["events"] if one["kind"] == "impact"]
        self.assertGreater(len([one for one in impacts if one["element"] == "q"]), 5)


class Edges(unittest.TestCase):
    """What hung or was called singular."""

    def last(self, text: str) -> dict:
        done = program.call("simulate", "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return program.report(done)["simulation"]

    def refused(self, text: str, code: str) -> str:
        done = program.call("simulate", "-", text=text)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(code, done.stderr)
        return done.stderr

    def test_what_coasts_against_a_stop_without_restitution_stays_there(self) -> None:
        text = ALONE.replace("SECTION", "action: {push: 0}, start: {push: {speed: 1}}, "
                             "stops: {push: {to: 0.53}}, time: 2 s, steps: 4")
        found = self.last(text.replace("HALF", "1").replace("PERIOD", "2"))
        self.assertEqual([one["kind"] for one in found["events"]], ["impact", "rest"])
        self.assertLess(abs(found["events"][0]["time"] - 0.53), 1e-12)
        self.assertLess(found["energy_drift"], 1e-12)

    def test_a_curve_may_repeat_as_often_as_it_likes(self) -> None:
        """Triangles of 1 N on 2 kg speed up by 0.25 m/s^2 in the mean."""
        for period, time in ((0.1, 1.0), (0.05, 0.5), (0.2, 2.0), (0.3, 3.0), (0.1, 10.0)):
            text = ALONE.replace("SECTION", "action: {push: saw}, start: {push: {speed: 1}}, "
                                 f"time: {time} s, steps: 3")
            found = self.last(text.replace("HALF", str(period / 2)).replace("PERIOD", str(period)))
            with self.subTest(period=period, time=time):
                rows = found["rows"]
                self.assertEqual(len(rows), 4)
                names = [one["name"] for one in found["columns"]]
                speed = rows[-1][names.index("a.vx/velocity")]
                self.assertLess(abs(speed - 1.0 - 0.25 * time), 1e-9 * (1 + time))

    def test_no_point_of_a_curve_over_position_is_stepped_over(self) -> None:
        """A pulse of 1 N within 20 mm does 0.01 J, whatever the steps."""
        text = ALONE.replace("SECTION", "action: {push: saw}, start: {push: {speed: 1}}, time: 3 s, "
                             "steps: STEPS").replace("over: time, points: [[0, 0 N], [HALF, 1 N], "
                             "[PERIOD, 0 N]], period: PERIOD", "over: push, points: [[-1, 0 N], "
                             "[1, 0 N], [1.01, 1 N], [1.02, 0 N], [99, 0 N]]")
        for steps in (1, 7, 100):
            found = self.last(text.replace("STEPS", str(steps)))
            names = [one["name"] for one in found["columns"]]
            supplied = found["rows"][-1][names.index("energy/supplied")]
            self.assertLess(abs(supplied - 0.01), 1e-9, steps)
            speed = found["rows"][-1][names.index("a.vx/velocity")]
            self.assertLess(abs(speed - math.sqrt(1.01)), 1e-9, steps)

    def test_a_speed_that_an_impact_turns_round_does_not_pass_zero(self) -> None:
        """Dropped from 1 m it comes up again with half its speed, and is at rest at 1/4 m."""
        text = ALONE.replace("SECTION", "action: {push: -20}, start: {push: {position: 1}}, "
                             "stops: {push: {from: 0, restitution: 0.5}}, until: {push: {speed: 0}}, "
                             "time: 3 s, steps: 6").replace("HALF", "1").replace("PERIOD", "2")
        found = self.last(text)
        self.assertEqual([one["kind"] for one in found["events"]], ["impact", "goal"])
        self.assertLess(abs(found["events"][1]["position"] - 0.25), 1e-9)

    def test_a_speed_that_a_stop_takes_away_is_reached(self) -> None:
        """A pendulum from 90 degrees on a stop that takes all its speed, where it hangs: after a
        quarter of its period, of 0.6 kg*m^2 and 9.81 N*m. Without an end it rests there."""
        quarter = math.sqrt(0.6 / 9.81) * math.pi / 2 / agm(1.0, math.sqrt(0.5))
        for until in ("", "until: {m: {speed: 0}}, "):
            found = self.last(PENDULUMS.replace("BODIES", ONE).replace("UNTIL", until))
            self.assertEqual([one["kind"] for one in found["events"]],
                             ["impact", "rest", "goal"][:3 if until else 2])
            for event in found["events"]:
                self.assertLess(abs(event["time"] - quarter), 1e-8)
            self.assertLess(abs(found["time"] - (quarter if until else 2.0)), 1e-8)
            self.assertLess(abs(found["rows"][-1][1]), 1e-12)

    def test_a_speed_that_a_stop_takes_away_is_reached_by_what_moves_with_it(self) -> None:
        """The upper of two pendulums stands still from the impact on, whatever the lower one does;
        of a four-bar all stands still."""
        two = self.last(PENDULUMS.replace("BODIES", TWO).replace("UNTIL", "until: {m: {speed: 0}}, "))
        bars = self.last(FOUR_BAR)
        for found, position in ((two, 0.0), (bars, None)):
            impact, rest, goal = found["events"]
            self.assertEqual([impact["kind"], rest["kind"], goal["kind"]], ["impact", "rest", "goal"])
            self.assertLess(abs(goal["time"] - impact["time"]), 1e-12)
            self.assertLess(abs(goal["speed"]), 1e-11)
            if position is not None:
                self.assertLess(abs(goal["position"] - position), 1e-12)
        self.assertEqual(goal["element"], "l")

    def test_a_speed_that_a_stop_takes_away_at_the_start_is_reached(self) -> None:
        text = ALONE.replace("SECTION", "action: {push: 1}, start: {push: {speed: -1}}, "
                             "stops: {push: {from: 0}}, until: {push: {speed: 0}}, time: 2 s, steps: 4")
        found = self.last(text.replace("HALF", "1").replace("PERIOD", "2"))
        self.assertEqual([one["kind"] for one in found["events"]], ["impact", "goal"])
        self.assertEqual(found["time"], 0.0)

    def test_contacts_have_their_speeds(self) -> None:
        """The follower slides on the cam by its speed times the height of the contact."""
        for report in ((), ("--report", "c.vx", "--report", "shaft")):
            done = program.call("simulate", *report, "-", text=CAM)
            self.assertEqual(done.returncode, 0, done.stderr)
            found = program.report(done)["simulation"]
            names = [one["name"] for one in found["columns"]]
            self.assertNotIn("c.vx/position", names)
            for cells in found["rows"]:
                row = dict(zip(names, cells))
                height = 31 + 12 * math.sin(row["a.wz/position"])
                self.assertLess(abs(row["c.vx/velocity"] - row["a.wz/velocity"] * height), 1e-9)

    def test_a_column_that_no_row_has_is_refused(self) -> None:
        done = program.call("simulate", "--report", "c.vx.position", "-", text=CAM)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("E0313", done.stderr)

    def test_what_holds_a_speed_bears_impacts(self) -> None:
        """A pendulum between stops on a cart that is held at 1 m/s: no energy without a source."""
        section = ("action: {swing: 0}, motion: {push: 1}, start: {swing: {speed: 3}}, "
                   "stops: {swing: {from: -1.2, to: 0.2, restitution: 0.5}}")
        text = CART.replace("ground: frame", "ground: frame\ngravity: [0, -9.81]")
        found = self.last(text.replace("SECTION", section))
        self.assertGreater(len([1 for one in found["events"] if one["kind"] == "impact"]), 1)
        self.assertGreater(found["rows"][-1][-2], 0.1)  # lost in impacts
        self.assertLess(found["energy_drift"], 1e-7 * found["energy_scale"])

    def test_what_acts_on_the_spin_of_a_massless_rod_is_refused(self) -> None:
        """Nothing but its inertia would say how fast it spins; a force at its ball does not spin it."""
        self.assertIn("body 'rod'", self.refused(BALLS.replace("LOAD", "couple: [5, 1.5, 0.5]"),
                                                 "E0516"))
        self.refused(BALLS.replace("LOAD", "at: [0.5, 0, 0], force: [0, 0, 3]"), "E0516")
        free = self.last(BALLS.replace("LOAD", "couple: [0, 0, 0]"))
        pushed = self.last(BALLS.replace("LOAD", "at: [0, 0.2, 0], force: [1, 0, 0]"))
        # At the crank pin 1 N at 0.2 m turns it back with 0.2 N*m of the 1 N*m of the motor.
        begins = [one["rows"][0][[c["name"] for c in one["columns"]].index("a.wz/acceleration")]
                  for one in (free, pushed)]
        self.assertAlmostEqual(begins[1] / begins[0], 0.8, delta=1e-12)

    def test_a_parallelogram_keeps_its_branch_through_its_change_points(self) -> None:
        """Where its links are in line it could turn into an antiparallelogram, which would have other
        speeds; 0.5 N*m on 0.02 + 0.02 + 0.02 kg*m^2 for 52.5 rad, however many steps there are."""
        for steps in (1, 7, 20, 100, 333):
            found = self.last(PARALLELOGRAM.replace("STEPS", str(steps)))
            names = [one["name"] for one in found["columns"]]
            self.assertEqual(found["status"], "complete")
            for cells in found["rows"]:
                row = dict(zip(names, cells))
                turned = 5 * row["time"] + 0.25 / 0.06 * row["time"] ** 2
                for name in ("a.wz", "d.wz", "c.wz"):
                    self.assertLess(abs(row[f"{name}/position"] - turned), 1e-7, (steps, name))
                self.assertLess(abs(row["b.wz/position"] + turned), 1e-7, steps)

    def test_rows_in_change_points_tell_what_is_determined_there(self) -> None:
        """Free at 120 deg/s from 60 deg it is in line after 1 s and 2.5 s, where only the speed of
        its coordinate is determined; it passes, or ends there by its time or its goal."""
        free = PARALLELOGRAM.replace("m: 0.5", "m: 0").replace("speed: 5", "speed: 120 deg/s")
        speed = math.radians(120)
        for steps, end, until in ((6, 3, ""), (60, 3, ""), (3000, 3, ""), (1, 1, ""), (10, 1, ""),
                                  (6, 3, ", until: {m: {position: 120 deg}}"),
                                  (6, 3, ", until: {d.wz: {position: 120 deg}}")):
            text = free.replace("time: 3 s", f"time: {end} s{until}").replace("STEPS", str(steps))
            done = program.call("simulate", "-", text=text)
            with self.subTest(steps=steps, end=end, until=until):
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("W0507", done.stderr)
                found = program.report(done)["simulation"]
                names = [one["name"] for one in found["columns"]]
                rows = [dict(zip(names, cells)) for cells in found["rows"]]
                self.assertAlmostEqual(rows[-1]["time"], 1.0 if until else end, delta=1e-9)
                for row in rows:
                    time = row["time"]
                    in_line = min(abs(time - 1.0), abs(time - 2.5)) < 1e-6
                    self.assertLess(abs(row["d.wz/position"] - speed * time), 1e-7)
                    self.assertLess(abs(row["a.wz/velocity"] - speed), 1e-8)
                    if in_line:
                        self.assertIsNone(row["d.wz/velocity"])
                        self.assertIsNone(row["energy/kinetic"])
                    else:
                        self.assertLess(abs(row["d.wz/velocity"] - speed), 1e-8)
                        self.assertLess(abs(row["energy/kinetic"] - 0.03 * speed**2), 1e-8)
                for event in found["events"]:
                    self.assertLess(abs(event["position"] - math.radians(120)), 1e-8)

    def test_a_stop_of_what_is_held_is_refused(self) -> None:
        section = "action: {swing: 0}, motion: {push: 1}, stops: {push: {to: 0.53}}"
        self.refused(CART.replace("SECTION", section), "E0517")

    def test_stops_press_through_each_other(self) -> None:
        """Alone the cart would run away from under the pendulum, which the stop of the cart prevents."""
        section = "action: {swing: 0.05, push: 5}, stops: {swing: {to: 0}, push: {to: 0}}"
        found = self.last(CART.replace("SECTION", section))
        self.assertEqual([one["kind"] for one in found["events"]], ["rest", "rest"])
        # Pulled back, both go together with 5 N on 3 kg, which presses the pendulum on its stop.
        found = self.last(CART.replace("SECTION", section.replace("push: 5", "push: -5")))
        self.assertEqual([one["element"] for one in found["events"]], ["swing"])
        names = [one["name"] for one in found["columns"]]
        last = dict(zip(names, found["rows"][-1]))
        self.assertLess(abs(last["a.vx/position"] + 5 / 3 * 2), 1e-8)
        self.assertEqual(last["b.wz/position"], 0.0)

    def test_the_energies_between_rows_are_what_little_is_measured_by(self) -> None:
        """A mass that falls 0.2 m onto its spring swings back between two rows: at all rows it is where
        it began, and it had m (g sqrt(m/k))^2 / 2 = 0.5 J meanwhile."""
        for rows in (1, 10, 77):
            done = program.call("simulate", "-", text=f"""
kinestat: 1
space: planar
ground: frame
bodies: {{m: {{mass: 1, centre_of_mass: [0, 0]}}}}
gravity: [-10, 0]
couplings: {{a: {{type: prismatic, bodies: [frame, m], at: [0, 0], axis: x}}}}
springs: {{k: {{coupling: a, stiffness: 100}}}}
actuators: {{A: {{coupling: a}}}}
simulation: {{action: {{A: 0}}, time: "10*0.2*pi*1 s", steps: {rows}}}
""")
            self.assertEqual(done.stderr, "")
            found = program.report(done)["simulation"]
            self.assertLess(found["energy_scale"], 0.5 + 1e-6)
            self.assertGreater(found["energy_scale"], 0.49)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
