#!/usr/bin/env python3
"""Checks means and root mean squares of motions in time against closed forms, however few steps.

Usage: motion_means_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math

import motion_case
from motion_case import MotionTest, in_library, run
from swept_case import swept

PI = math.pi
SINE = PI / (PI + 4)  # modified sine: its speed is SINE (1 - cos 4 PI u), then 1 - 3 cos of a third

# Mean squares of speed and acceleration, over way/time and way/time^2. Those of the polynomials
# 30 u^2 (1-u)^2 and 140 u^3 (1-u)^3 and of their derivatives by the integral of Euler.
LAWS = {
    "constant_acceleration": (4 / 3, 16.0),
    "polynomial_345": (900 / 630, 3600 / 210),
    "polynomial_4567": (140 ** 2 / 12012, 420 ** 2 * (1 / 630 - 4 / 2772)),
    "cycloidal": (3 / 2, 2 * PI ** 2),
    "harmonic": (PI ** 2 / 8, PI ** 4 / 8),
    "modified_sine": (SINE ** 2 * ((3 / 2 - 4 / PI) / 4 + 3 / 4 * (11 / 2 + 12 / PI)),
                      8 * PI ** 2 * SINE ** 2),
}

STEPS = (1, 3, 12, 13, 24, 25, 40, 100, 333)

TABLE = """\
kinestat: 1
space: planar
ground: bed
parameters: {way: 1}
bodies: {table: {mass: 60, centre_of_mass: [0, 0]}}
gravity: [0, -9.81]
couplings: {g: {type: prismatic, bodies: [bed, table], at: [0, 0], axis: x, friction: 0.1}}
actuators: {servo: {coupling: g}}
cases: {move: {motion: {servo: 0}, acceleration: {}, action: {}}}
motion:
  drives: [{drive: servo, profile: [PROFILE]}]
  case: move
  report: [position, velocity, acceleration, power]
"""

CRANK, ROD, LOAD = 40.0, 120.0, 500.0

PRESS = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: {crank: {}, rod: {}, ram: {mass: 3, centre_of_mass: [160, 0]}}
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [40, 0]}
  c: {type: revolute, bodies: [rod, ram], at: [160, 0]}
  d: {type: prismatic, bodies: [frame, ram], at: [160, 0], axis: x}
actuators: {motor: {coupling: a}, press: {coupling: d}}
cases: {run: {motion: {motor: 0}, acceleration: {}, action: {press: 500 N}}}
motion: {drive: motor, to: 90, law: LAW, time: 0.5 s, case: run,
         report: [position, velocity, acceleration, power]}
"""


class Laws(MotionTest):
    """A way of 1 m in 0.1 s between two dwells."""

    def figures(self, law: str, steps: int) -> dict:
        text = TABLE.replace("PROFILE", "{dwell: 0.51 s}, {to: way, time: 0.1 s, law: LAW}, "
                                        "{dwell: 0.52 s}").replace("LAW", law)
        return run(text, "--steps", str(steps)).report["figures"]

    def test_speeds_and_accelerations_have_their_mean_squares(self) -> None:
        time, whole = 0.1, 1.13
        for law, squares in LAWS.items():
            for steps in STEPS:
                found = self.figures(law, steps)
                for order, (quantity, square) in enumerate(zip(("velocity", "acceleration"), squares), 1):
                    expected = math.sqrt(square * time / whole) / time ** order
                    self.close(found[f"g.vx/{quantity}"]["rms"], expected, 2e-5 * expected,
                               f"{quantity} of {law} in {steps} steps")

    def test_means_are_what_integrals_change_by(self) -> None:
        for law in (*LAWS, "trapezoid", "modified_trapezoid", "constant_speed"):
            for steps in STEPS:
                found = self.figures(law, steps)
                self.close(found["g.vx/position"]["mean"], (0.05 + 0.52) / 1.13, 1e-5, law)
                self.close(found["g.vx/velocity"]["mean"], 1 / 1.13, 1e-5, f"speed of {law}")
                self.close(found["g.vx/acceleration"]["mean"], 0.0,
                           1e-9 * (found["g.vx/acceleration"]["rms"] or 1.0), f"{law}, {steps}")

    def test_sweeps_say_the_same(self) -> None:
        text = TABLE.replace("PROFILE", "{dwell: 0.51 s}, {to: way, time: 0.1 s, law: cycloidal}")
        names = ("g.vx/velocity", "g.vx/acceleration", "servo/power")
        columns = ", ".join(f"{name.replace('/', '.')}.{figure}"
                            for name in names for figure in ("mean", "rms"))
        rows, _ = swept(text.replace("  case: move", "  steps: 25\n  case: move"),
                        f"{{vary: {{way: [1, 2]}}, report: [{columns}]}}")
        alone = run(text, "--steps", "25").report["figures"]
        expected = [alone[name][figure] for name in names for figure in ("mean", "rms")]
        for found, one in zip(list(rows[0].values())[2:-1], expected):
            self.close(found, one, 1e-9 * (1 + abs(one)), "in a sweep")


class Friction(MotionTest):
    def test_has_the_power_that_the_servo_needs(self) -> None:
        """It loses 58.86 N over 1.4 m, out and back; kinetic energy comes back."""
        text = TABLE.replace("PROFILE", """
        {to: 0.5, time: 0.6 s, law: trapezoid}, {dwell: 0.4 s}, {to: 0, time: 0.6 s, law: trapezoid},
        {dwell: 0.4 s}, {to: -0.2, time: 0.03 s, law: cycloidal},
        {to: 0, time: 0.03 s, law: cycloidal}""")
        for steps in STEPS:
            power = run(text, "--steps", str(steps)).report["figures"]["servo/power"]
            expected = 58.86 * 1.4 / 2.06
            self.close(power["mean"], expected, 1e-5 * power["rms"], f"in {steps} steps")


class Mechanism(MotionTest):
    """A crank from in line with its rod to upright: the ram goes by x."""

    def test_means_agree_with_ways_and_work(self) -> None:
        x = math.sqrt(ROD ** 2 - CRANK ** 2) - CRANK - ROD
        for law in ("cycloidal", "modified_sine", "trapezoid", "polynomial_345", "harmonic"):
            for steps in STEPS:
                found = run(PRESS.replace("LAW", law), "--steps", str(steps)).report["figures"]
                speed, acceleration = found["d.vx/velocity"], found["d.vx/acceleration"]
                self.close(speed["mean"], x / 0.5, 5e-5 * speed["rms"], f"{law} in {steps}")
                power = found["motor/power"]
                self.close(power["mean"], -LOAD * x / 1000 / 0.5, 5e-5 * power["rms"], law)
                self.close(acceleration["mean"], 0.0, 1e-4 * acceleration["rms"],
                           f"{law} in {steps}")

    def test_turns_between_dwells_do_their_work(self) -> None:
        """From dead centre to dead centre the ram goes by twice the crank, there and back over four of
        its turns by nothing."""
        profiles = (("{to: 180, time: 0.3 s, law: cycloidal}, {dwell: 0.6 s}", 0.9, 0.5),
                    ("{dwell: 0.31 s}, {to: 180, time: 0.5 s, law: modified_trapezoid}, {dwell: 0.17 s}",
                     0.98, 0.5),
                    ("{to: 1440, time: 0.4 s, law: modified_sine}, {dwell: 3.6 s}", 4.0, 4.0))
        for profile, time, turns in profiles:
            way = -2 * CRANK * (turns % 1 != 0)
            for steps in (1, 12, 24, 36, 48, 72, 100):
                text = PRESS.replace("to: 90, law: LAW, time: 0.5 s", f"profile: [{profile}]")
                found = run(text, "--steps", str(steps)).report["figures"]
                power, acceleration = found["motor/power"], found["d.vx/acceleration"]
                where = f"{profile} in {steps} steps"
                self.close(power["mean"], -LOAD * way / 1000 / time, 1e-4 * power["rms"], where)
                self.close(acceleration["mean"], 0.0, 1e-4 * acceleration["rms"], where)

    def test_a_whole_turn_at_a_steady_speed_returns(self) -> None:
        text = PRESS.replace("to: 90, law: LAW, time: 0.5 s", "to: 360").replace(
            "{motor: 0}, acceleration", "{motor: 60 rpm}, acceleration")
        for steps in (13, 24, 50, 72):
            found = run(text, "--steps", str(steps)).report["figures"]
            for quantity in ("velocity", "acceleration"):
                one = found[f"d.vx/{quantity}"]
                self.close(one["mean"], 0.0, 1e-12 * one["greatest"], quantity)


class NearSingularPositions(MotionTest):
    """A crank of 15 m that turns by 1 rad/s: its pin accelerates by what it is away from the axis."""

    def test_rows_that_rounding_leaves_open_take_no_means_away(self) -> None:
        press = in_library("planar/slider_crank.yaml")
        for steps in (100, 337, 1000, 1001):
            found = run(press, "--drive", "Fout", "--to", "-limit", "--steps",
                        str(steps)).report["figures"]
            for axis in "xy":
                self.close(found[f"rod/linear_acceleration/{axis}"]["mean"],
                           -found[f"rod/at/{axis}"]["mean"], 0.02, f"{axis} in {steps} steps")

    def test_what_is_zero_has_its_mean_up_to_a_limit(self) -> None:
        press = in_library("planar/slider_crank.yaml")
        for steps in (100, 1000, 3000):
            found = run(press, "--drive", "Tin", "--to", "limit", "--steps", str(steps))
            self.assertEqual(found.report["figures"]["slider/linear_acceleration/y"]["mean"], 0.0)


if __name__ == "__main__":
    motion_case.main()
