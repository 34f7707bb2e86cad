#!/usr/bin/env python3
"""Checks that what a motion comes to does not hang on its steps, however few there are.

Usage: motion_steps_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import math
import re
import subprocess

import motion_case
import program
from motion_case import Motion, MotionTest, dyad, run
from swept_case import swept

MU, PRESS, LEAN = 0.1, 900.0, math.sqrt(0.125)  # the tangent of a rod of three cranks across

# Drawn at a dead centre, so that all rows stand at one where there are one or two steps.
PRESS_WITH_FRICTION = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, ram]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [40, 0]}
  c: {type: revolute, bodies: [rod, ram], at: [160, 0]}
  d: {type: prismatic, bodies: [frame, ram], at: [160, 0], axis: x, friction: 0.1}
actuators: {in: {coupling: a}, out: {coupling: d}}
cases: {run: {motion: {in: 10 rad/s}, action: {out: 900 N}, input: in, output: out}}
motion: {drive: in, to: 360, case: run, report: [velocity, action, reaction, mechanical_advantage]}
"""

TABLE = """\
kinestat: 1
space: planar
ground: bed
bodies: {table: {mass: 60, centre_of_mass: [0, 0]}}
gravity: [0, -9.81]
couplings: {g: {type: prismatic, bodies: [bed, table], at: [0, 0], axis: x, friction: 0.1}}
actuators: {servo: {coupling: g}}
cases: {move: {motion: {servo: 0}, acceleration: {}, action: {}}}
motion:
  drives:
    - drive: servo
      profile:
        - {to: 0.5, time: 0.6 s, law: trapezoid}
        - {dwell: 0.4 s}
        - {to: 0, time: 0.6 s, law: trapezoid}
        - {dwell: 0.4 s}
        - {to: -0.2, time: SHORT s, law: cycloidal}
        - {to: 0, time: SHORT s, law: cycloidal}
  case: move
  report: [position, velocity, acceleration, action, power, reaction]
"""

WEIGHT, FRICTION = 60 * 9.81, 0.1 * 60 * 9.81

# A crank and slider with friction in both guides, ten turns out and ten back.
OUT_AND_BACK = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, ram]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0], friction: {mu: 0.05, radius: 10}}
  b: {type: revolute, bodies: [crank, rod], at: [40, 0]}
  c: {type: revolute, bodies: [rod, ram], at: [160, 0]}
  d: {type: prismatic, bodies: [frame, ram], at: [160, 0], axis: x, friction: 0.1}
actuators: {in: {coupling: a}, out: {coupling: d}}
cases: {run: {motion: {in: 0}, action: {out: 90 N}, input: in, output: out}}
motion:
  drives:
    - drive: in
      from: 17 deg
      profile:
        - {to: 3617 deg, time: 1 s, law: constant_speed}
        - {to: 17 deg, time: 1 s, law: constant_speed}
  case: run
  report: [velocity, action]
"""

# A parallelogram, whose links come to lie on one line; its rocker turns as its crank does.
PARALLELOGRAM = """\
kinestat: 1
space: planar
units: {angle: deg}
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [0, 3]}
  c: {type: revolute, bodies: [coupler, rocker], at: [7, 3]}
  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}
actuators: {motor: {coupling: a}}
cases: {turning: {motion: {motor: 1 rad/s}}}
motion: {drive: motor, to: -180, case: turning, report: [d.wz]}
"""


# Nearly a parallelogram: its rocker turns back sharply beside the line of its links.
PASSING_CLOSE = """\
kinestat: 1
space: planar
parameters: {e: MISFIT}
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [0, 30]}
  c: {type: revolute, bodies: [coupler, rocker], at: [70, 30]}
  d: {type: revolute, bodies: [frame, rocker], at: [70, -e]}
actuators: {motor: {coupling: a}}
cases: {turning: {motion: {motor: 1 rad/s}}}
motion: {drive: motor, from: 3 deg, to: -357 deg, case: turning, report: [d.wz]}
"""


class NarrowPeaks(MotionTest):
    @staticmethod
    def acceleration(misfit: float, turn: float) -> float:
        """Of the rocker, by the derivatives of the square of the distance of the coupler's ends."""
        def dot(p: complex, q: complex) -> float:
            return (p.conjugate() * q).real

        ground = 70 - misfit * 1j
        b = 30j * cmath.exp(1j * turn)
        c = dyad(b, ground, 70, 30 + misfit, (30j, ground, 70 + 30j))
        along, arm = c - b, c - ground
        speed = dot(along, 1j * b) / dot(along, 1j * arm)
        return ((dot(along, speed ** 2 * arm - b) - abs(1j * speed * arm - 1j * b) ** 2)
                / dot(along, 1j * arm))

    def greatest(self, misfit: float, sign: float) -> float:
        """By many looks, then by golden sections."""
        count, share = 50_000, (math.sqrt(5) - 1) / 2
        turns = [math.radians(3 - 360 * i / count) for i in range(count + 1)]
        best = max(turns, key=lambda turn: sign * self.acceleration(misfit, turn))
        low, high = best - 2e-4, best + 2e-4
        for _ in range(50):
            width = share * (high - low)
            if (sign * self.acceleration(misfit, low + width)
                    > sign * self.acceleration(misfit, high - width)):
                low = high - width
            else:
                high = low + width
        return self.acceleration(misfit, low)

    def test_beside_a_change_point_are_found_in_few_steps(self) -> None:
        for misfit in (0.3, 0.01, 0.001):
            least, greatest = (self.greatest(misfit, sign) for sign in (-1.0, 1.0))
            text = PASSING_CLOSE.replace("MISFIT", str(misfit))
            for steps in (1, 5, 7, 13, 24, 36, 50, 100):
                found = run(text, "--steps", str(steps)).report["figures"]["d.wz/acceleration"]
                self.close(found["least"], least, -1e-6 * least, f"{misfit} in {steps} steps")
                self.close(found["greatest"], greatest, 1e-6 * greatest, f"{misfit} in {steps} steps")

    def test_are_those_of_sweeps(self) -> None:
        text = PASSING_CLOSE.replace("MISFIT", "0.01").replace("case: turning,", "case: turning, steps: 13,")
        rows, _ = swept(text, "{vary: {e: [0.01, 0.3]}, report: [d.wz.acceleration.least]}")
        for row in rows:
            least = self.greatest(row["e"], -1.0)
            self.close(list(row.values())[-2], least, -1e-6 * least, "in a sweep")


class FewSteps(MotionTest):
    def test_peaks_behind_a_dwell_are_found(self) -> None:
        """That of modified sine is 4 pi^2 / (pi + 4) times the way over the square of the time."""
        first = re.sub(r"profile:\n(.*\n){6}", "profile: [{dwell: 0.51 s}, {to: 1, time: 0.1 s, "
                       "law: modified_sine}, {dwell: 0.52 s}]\n", TABLE)
        peak = 4 * math.pi ** 2 / (math.pi + 4) / 0.1 ** 2
        for steps in (24, 25, 40, 60):
            figures = run(first, "--steps", str(steps)).report["figures"]["g.vx/acceleration"]
            self.close(figures["greatest"], peak, 1e-8 * peak, f"{steps} steps")
            self.close(figures["least"], -peak, 1e-8 * peak, f"{steps} steps")

    def test_turns_there_and_back_are_all_seen(self) -> None:
        """Two dead points a turn, at which the guide's friction reverses; both do where the drive does."""
        for steps in (3, 24, 40):
            events = run(OUT_AND_BACK, "--steps", str(steps)).report["events"]
            kinds = [one["kind"] for one in events]
            self.assertEqual(kinds.count("dead_point"), 40, steps)
            self.assertEqual(kinds.count("friction_reversal"), 42, steps)

    def test_what_does_not_jump_is_not_said_to(self) -> None:
        """Where the table comes back from its short way, its servo alone goes from one to the other."""
        table = TABLE.replace("SHORT", "0.3")
        for steps in (40, 360):
            last = run(table, "--steps", str(steps)).report["events"][-1]
            self.assertEqual(last["drive"], [-0.2])
            self.assertEqual(last["jumps"].keys(), {"servo/action"}, steps)

    def test_what_is_constant_is_so_beside_a_singular_position(self) -> None:
        for steps in (36, 40, 60, 90):
            figures = run(PARALLELOGRAM, "--steps", str(steps)).report["figures"]["d.wz/velocity"]
            self.close(figures["least"], 1.0, 1e-11, f"{steps} steps")
            self.close(figures["greatest"], 1.0, 1e-11, f"{steps} steps")

    def test_that_all_stand_at_reversals_tell_what_many_do(self) -> None:
        """With the lean of the rod the guide bears PRESS LEAN / (1 -+ MU LEAN), where it is greatest."""
        figures = [run(PRESS_WITH_FRICTION, "--steps", str(steps)).report["figures"]
                   for steps in (1, 2, 3, 4, 5, 360)]
        for one in figures:
            side = one["d.Ry/action"]
            self.close(side["least"], -PRESS * LEAN / (1 - MU * LEAN), 1e-9 * PRESS, "forwards")
            self.close(side["greatest"], PRESS * LEAN / (1 + MU * LEAN), 1e-9 * PRESS, "back")
            self.assertIsNone(one["out/mechanical_advantage"]["greatest"])
        for one in figures[:-1]:
            self.assertEqual(one.keys(), figures[-1].keys())
            for name, expected in figures[-1].items():
                if name == "closure_error":
                    continue
                size = max(abs(expected[key] or 0.0) for key in ("least", "greatest"))
                for key, share in (("least", 1e-8), ("greatest", 1e-8), ("mean", 0.01)):
                    found = one[name][key]
                    self.assertEqual(found is None, expected[key] is None, f"{key} of {name}")
                    if found is not None:
                        self.close(found, expected[key], share * size + 1e-9, f"{key} of {name}")

    def test_have_their_reversals(self) -> None:
        for steps in (1, 2, 3, 7):
            motion = run(PRESS_WITH_FRICTION, "--steps", str(steps))
            self.assertEqual(len(motion.rows), steps + 1)
            places = motion.events("friction_reversal")
            self.assertEqual(len(places), 3, steps)
            for place, expected in zip(places, (0.0, 180.0, 360.0)):
                self.close(place, expected, 1e-5, f"reversal in {steps} steps")


class Dwells(MotionTest):
    def test_peaks_beside_them_do_not_hang_on_the_steps(self) -> None:
        """A cycloid accelerates by up to 2 pi s / T^2, with friction when it goes away from rest and
        against it when it stops."""
        for short in (0.3, 0.03):
            peak = 60 * 2 * math.pi * 0.2 / short ** 2 + FRICTION
            for steps in (12, 13, 24, 36, 360):
                motion = run(TABLE.replace("SHORT", str(short)), "--steps", str(steps))
                action = motion.report["figures"]["servo/action"]
                self.close(action["least"], -peak, 1e-8 * peak, f"least in {steps} steps")
                self.close(action["greatest"], peak, 1e-8 * peak, f"greatest in {steps} steps")

    def test_means_are_among_what_acts(self) -> None:
        """At rest the guide bears the weight alone, sliding its friction, too."""
        for steps in (12, 13, 24, 36, 360):
            figures = run(TABLE.replace("SHORT", "0.3"), "--steps", str(steps)).report["figures"]
            force = figures["g/force"]
            self.close(force["least"], WEIGHT, 1e-9, "least")
            self.close(force["greatest"], math.hypot(WEIGHT, FRICTION), 1e-9, "greatest")
            for name, one in figures.items():
                if one["mean"] is not None and one["least"] is not None:
                    size = max(abs(one["least"]), abs(one["greatest"] or 0.0))
                    self.assertGreaterEqual(one["mean"], one["least"] - 1e-12 * size, name)
                    if one["greatest"] is not None:
                        self.assertLessEqual(one["mean"], one["greatest"] + 1e-12 * size, name)

    def test_in_which_friction_turns_round_have_its_event(self) -> None:
        """It comes to rest at 0.6 s braking by 6.25 m/s^2, and begins to go back as fast at 1 s."""
        for steps in (4, 12, 13, 36, 360):
            motion = run(TABLE.replace("SHORT", "0.3"), "--steps", str(steps))
            event = next(one for one in motion.report["events"]
                         if one["kind"] == "friction_reversal" and abs(one["drive"][0] - 0.5) < 1e-9)
            self.close(event["time"], 1.0, 1e-9, f"time in {steps} steps")
            jump = event["jumps"]["servo/action"]
            self.close(jump["before"], FRICTION - 60 * 6.25, 1e-6, "before")
            self.close(jump["after"], -FRICTION - 60 * 6.25, 1e-6, "after")

    def test_have_no_power(self) -> None:
        motion = run(TABLE.replace("SHORT", "0.3"), "--steps", "33")
        for event in motion.report["events"]:
            for name in ("servo/power", "g/loss"):
                for value in event.get("jumps", {}).get(name, {}).values():
                    self.assertIn(value, (0.0, "W"), name)


class Lines(MotionTest):
    def test_go_on_to_where_a_drive_comes_to_rest(self) -> None:
        """Friction of 3 N*m beside a load of 1 N*m, there and back by the drawn curve."""
        text = """\
kinestat: 1
space: planar
ground: frame
bodies: [crank]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0], friction: {tau: 3}}
  d: {type: revolute, bodies: [frame, crank], at: [0, 0]}
actuators: {in: {coupling: a}, out: {coupling: d}}
cases: {run: {motion: {in: 0}, action: {out: 1}}}
motion:
  drives:
    - drive: in
      profile: [{to: 1, time: 1 s, law: cycloidal}, {to: 0, time: 1 s, law: cycloidal}]
  steps: 8
  case: run
  report: in/action
"""
        drawn = subprocess.run([program._path, "plot", "motion-curves", "--emit", "gnuplot", "-"],
                               input=text, text=True, capture_output=True, check=True).stdout
        data = re.search(r"<< END\n(.*?)END\n", drawn, re.S).group(1)
        points = [tuple(float(one) for one in line.split()) for line in data.splitlines()
                  if line and "NaN" not in line]
        out = [x for x, y in points if abs(y - 2.0) < 1e-9]
        back = [x for x, y in points if abs(y + 4.0) < 1e-9]
        self.assertEqual(len(out) + len(back), len(points))
        for found, expected in zip((min(out), max(out), min(back), max(back)), (0, 1, 1, 2)):
            self.close(found, expected, 1e-5, "end of a line")


if __name__ == "__main__":
    motion_case.main()
