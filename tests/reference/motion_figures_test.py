#!/usr/bin/env python3
"""Checks the extremes and means of a motion, wherever its steps fall, against closed forms.

Usage: motion_figures_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import math
from typing import Callable

import motion_case
from motion_case import Motion, MotionTest, dyad, run

# A value at its extreme moves with the square of the position.
VALUE = 1e-10
PLACE = 1e-4

CRANK, ROD, OFFSET, PRESS = 40.0, 125.0, 15.0, 500.0

SLIDER_CRANK = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [40, 0]}
  c: {type: revolute, bodies: [rod, slider], at: ["40 + sqrt(125^2 - 15^2)", 15]}
  d: {type: prismatic, bodies: [frame, slider], axis: x}
actuators: {motor: {coupling: a}, press: {coupling: d}}
cases:
  run: {motion: {motor: 2 rad/s}, action: {press: 500 N}, input: motor, output: press}
motion: {drive: motor, to: 360, case: run, report: [position, velocity, motor]}
"""

FOUR_BAR = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [30, 40]}
  c: {type: revolute, bodies: [coupler, rocker], at: [150, 100]}
  d: {type: revolute, bodies: [frame, rocker], at: [160, 0]}
actuators: {motor: {coupling: a}, load: {coupling: d}}
cases: {run: {motion: {motor: 1 rad/s}, action: {load: -5 N*m}, input: motor, output: load}}
motion:
  drive: motor
  to: 360
  case: run
  trace: [{body: coupler, at: [90, 110]}]
  report: [transmission_angle]
"""


def greatest_of(function: Callable[[float], float], near: float) -> float:
    """Of a smooth function of an angle [deg] by golden sections, within 15 deg of a place."""
    low, high = near - 15.0, near + 15.0
    share = (math.sqrt(5.0) - 1.0) / 2.0
    for _ in range(60):
        width = share * (high - low)
        if function(low + width) > function(high - width):
            low = high - width
        else:
            high = low + width
    return max(function(low), function(high))


def extremes_of(function: Callable[[float], float]) -> tuple[float, float]:
    """Over a turn: a look at every degree, then by golden sections."""
    values = [function(float(degree)) for degree in range(361)]
    least = values.index(min(values))
    most = values.index(max(values))
    return (min(-greatest_of(lambda x: -function(x), least), values[0]),
            max(greatest_of(function, most), values[0]))


class FiguresTest(MotionTest):
    def figures(self, motion: Motion, name: str) -> dict:
        return motion.report["figures"][name]

    def holds(self, motion: Motion, name: str, function: Callable[[float], float]) -> None:
        """The extremes of the column are those of the function, and so are their places."""
        found = self.figures(motion, name)
        least, greatest = extremes_of(function)
        size = max(abs(least), abs(greatest))
        self.assertLess(abs(found["least"] - least), VALUE * size, name)
        self.assertLess(abs(found["greatest"] - greatest), VALUE * size, name)
        for figure in ("least", "greatest"):
            there = function(found[f"{figure}_at"])
            self.assertLess(abs(there - found[figure]), PLACE * PLACE * size, name)


class SliderCrank(FiguresTest):
    """x = r cos t + sqrt(l² - (e - r sin t)²); virtual power: motor t' + press x' = 0."""

    @staticmethod
    def place(degrees: float) -> float:
        t = math.radians(degrees)
        drawn = CRANK + math.sqrt(ROD ** 2 - OFFSET ** 2)
        return (CRANK * math.cos(t)
                + math.sqrt(ROD ** 2 - (OFFSET - CRANK * math.sin(t)) ** 2) - drawn)

    @staticmethod
    def slope(degrees: float) -> float:
        t = math.radians(degrees)
        rise = OFFSET - CRANK * math.sin(t)
        return (-CRANK * math.sin(t)
                + rise * CRANK * math.cos(t) / math.sqrt(ROD ** 2 - rise ** 2))

    def test_stroke_speed_and_torque_do_not_hang_on_the_steps(self) -> None:
        for steps in (12, 36, 71, 100):
            motion = run(SLIDER_CRANK, "--steps", str(steps))
            with self.subTest(steps=steps):
                self.holds(motion, "d.vx/position", self.place)
                self.holds(motion, "d.vx/velocity", lambda t: 2.0 * self.slope(t))
                self.holds(motion, "motor/action", lambda t: -PRESS * self.slope(t) / 1000.0)

    def test_stroke_is_that_of_the_dead_centres(self) -> None:
        stroke = (math.sqrt((ROD + CRANK) ** 2 - OFFSET ** 2)
                  - math.sqrt((ROD - CRANK) ** 2 - OFFSET ** 2))
        found = self.figures(run(SLIDER_CRANK, "--steps", "50"), "d.vx/position")
        self.assertLess(abs(found["greatest"] - found["least"] - stroke), VALUE * stroke)

    def test_actions_and_powers_of_actuators_need_no_report(self) -> None:
        motion = run(SLIDER_CRANK.replace(", report: [position, velocity, motor]", ""))
        self.holds(motion, "motor/action", lambda t: -PRESS * self.slope(t) / 1000.0)
        self.holds(motion, "motor/power", lambda t: -2.0 * PRESS * self.slope(t) / 1000.0)
        self.holds(motion, "press/power", lambda t: 2.0 * PRESS * self.slope(t) / 1000.0)
        self.assertEqual([self.figures(motion, "press/action")[one]
                          for one in ("least", "greatest", "mean")], [PRESS] * 3)
        self.assertFalse([one for one in motion.names if one.endswith("/force")])

    def test_mean_torque_of_a_stroke_is_its_work_over_its_way(self) -> None:
        """Without an offset from dead centre to dead centre: the press moves by two cranks."""
        text = (SLIDER_CRANK.replace("40 + sqrt(125^2 - 15^2)", "40 + 125").replace(", 15]", ", 0]")
                .replace("to: 360", "to: 180").replace(", report: [position, velocity, motor]", ""))
        found = self.figures(run(text, "--steps", "720"), "motor/action")
        mean = PRESS * 2.0 * CRANK / 1000.0 / math.pi
        self.assertLess(abs(found["mean"] - mean), 1e-5 * mean)

    def test_what_a_report_does_not_name_is_not_there(self) -> None:
        motion = run(SLIDER_CRANK.replace("report: [position, velocity, motor]",
                                          "report: [position]"))
        self.assertNotIn("motor/action", motion.names)
        self.assertNotIn("motor/power", motion.names)

    def test_mean_is_that_over_the_way_of_the_drive(self) -> None:
        count = 20_000
        mean = sum(self.place(360.0 * i / count) for i in range(count)) / count
        found = self.figures(run(SLIDER_CRANK, "--steps", "72"), "d.vx/position")
        self.assertLess(abs(found["mean"] - mean), 1e-9 * CRANK)

    def test_what_ends_at_its_extreme_has_it_there(self) -> None:
        found = self.figures(run(SLIDER_CRANK, "--to", "30 deg", "--drive", "motor", "--report",
                                 "position", "--steps", "7"), "d.vx/position")
        self.assertLess(abs(found["least"] - self.place(30.0)), VALUE * CRANK)
        self.assertEqual(found["least_at"], 30.0)


class FourBar(FiguresTest):
    LINKS = complex(30, 40), complex(150, 100), complex(160, 0)

    def joint(self, degrees: float) -> tuple[complex, complex]:
        b, c, d = self.LINKS
        at = b * cmath.exp(1j * math.radians(degrees))
        return at, dyad(at, d, abs(c - b), abs(c - d), (b, d, c))

    def angle(self, degrees: float) -> float:
        at, c = self.joint(degrees)
        between = abs(cmath.phase((c - at) / (c - self.LINKS[2])))
        return math.degrees(min(between, math.pi - between))

    def traced(self, degrees: float) -> complex:
        at, c = self.joint(degrees)
        b, c0, _ = self.LINKS
        return at + (complex(90, 110) - b) * (c - at) / (c0 - b)

    def test_least_transmission_angle_lies_where_crank_and_frame_are_in_line(self) -> None:
        b, c, d = self.LINKS
        coupler, rocker = abs(c - b), abs(c - d)
        least = min(
            math.degrees(math.acos(abs(coupler ** 2 + rocker ** 2 - (abs(d) + sign * abs(b)) ** 2)
                                   / (2.0 * coupler * rocker)))
            for sign in (-1, 1))
        for steps in (24, 50, 97):
            found = self.figures(run(FOUR_BAR, "--steps", str(steps)), "load/transmission_angle")
            with self.subTest(steps=steps):
                self.assertLess(abs(found["least"] - least), VALUE * least)

    def test_an_angle_that_passes_90_degrees_is_greatest_there(self) -> None:
        b, c, d = self.LINKS
        across = math.hypot(abs(c - b), abs(c - d))  # from b to d, of a right angle
        self.assertLess(abs(d) - abs(b), across)
        self.assertGreater(abs(d) + abs(b), across)
        for steps in (24, 50, 97):
            found = self.figures(run(FOUR_BAR, "--steps", str(steps)), "load/transmission_angle")
            with self.subTest(steps=steps):
                self.assertLess(abs(found["greatest"] - 90.0), VALUE * 90.0)
                self.assertLess(abs(self.angle(found["greatest_at"]) - 90.0), 1e-6)

    def test_a_traced_point_goes_as_far_as_its_curve(self) -> None:
        motion = run(FOUR_BAR, "--steps", "30")
        self.holds(motion, "coupler.1/at/x", lambda t: self.traced(t).real)
        self.holds(motion, "coupler.1/at/y", lambda t: self.traced(t).imag)


# A couple against the crank that rises to 100 N*m within a degree, falls to 50 in eight more and to
# nothing in another: 50 + 75 * 8 + 25 = 675 N*m deg.
PUNCH = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank]
couplings: {a: {type: revolute, bodies: [frame, crank], at: [0, 0]}}
actuators: {motor: {coupling: a}}
curves: {work: {over: OVER, points: [[0 P, 0 N*m], [11 P, 0 N*m], [12 P, -100 N*m], [20 P, -50 N*m],
  [21 P, 0 N*m], [360 P, 0 N*m]]}}
loads: {punch: {body: crank, couple: work}}
cases: {run: {motion: {motor: 1 deg/s}, action: {}}}
motion: {drive: motor, to: 360 deg, steps: 72, case: run, report: motor/action}
"""


class PointsOfCurves(FiguresTest):
    def holds_punch(self, text: str) -> None:
        for steps in (5, 72, 97):
            found = self.figures(run(text, "--steps", str(steps)), "motor/action")
            with self.subTest(steps=steps):
                self.assertLess(abs(found["greatest"] - 100.0), 1e-9)
                self.assertLess(abs(found["greatest_at"] - 12.0), 1e-9)
                self.assertLess(abs(found["mean"] - 675.0 / 360.0), 1e-12)

    def test_peaks_and_means_see_the_points_of_a_curve_over_the_drive(self) -> None:
        self.holds_punch(PUNCH.replace("OVER", "motor").replace(" P,", " deg,"))

    def test_peaks_and_means_see_the_points_of_a_curve_over_time(self) -> None:
        text = PUNCH.replace("OVER", "time").replace(" P,", " s,")
        self.holds_punch(text.replace("steps: 72", "steps: 72, time: 360 s"))

    def test_a_curve_that_repeats_has_its_points_every_time(self) -> None:
        text = PUNCH.replace("OVER", "motor, period: 360 deg").replace(" P,", " deg,")
        self.holds_punch(text)
        text = text.replace("to: 360 deg", "from: 340 deg, to: 1060 deg")
        found = self.figures(run(text, "--steps", "7"), "motor/action")
        self.assertLess(abs(found["greatest"] - 100.0), 1e-9)
        self.assertLess(abs(found["mean"] - 675.0 / 360.0), 1e-12)

    def test_peaks_see_the_points_of_a_curve_over_what_follows(self) -> None:
        """The rod is as long as the crank: the slider is at 200 cos(turn) mm, and the motor bears
        200 sin(turn) times the force, which is greatest at 50 mm."""
        text = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [60, 80]}
  c: {type: revolute, bodies: [rod, slider], at: [120, 0]}
  d: {type: prismatic, bodies: [frame, slider], at: [120, 0], axis: x}
actuators: {motor: {coupling: a}, press: {coupling: d}}
curves:
  work: {over: press, points: [[-300, 0 N], [-71, 0 N], [-70, 900 N], [-69, 0 N], [300, 0 N]]}
loads: {work: {body: slider, at: [120, 0], force: [work, 0]}}
cases: {run: {motion: {motor: 1 deg/s}, action: {press: 0}}}
motion: {drive: motor, to: 30 deg, steps: 4, case: run, report: motor/action}
"""
        found = self.figures(run(text), "motor/action")
        turn = math.degrees(math.acos(0.25) - math.atan2(4, 3))
        expected = 900.0 * 0.2 * math.sqrt(1.0 - 0.25 ** 2)
        self.assertLess(abs(abs(found["greatest"]) - expected), 1e-9 * expected)
        self.assertLess(abs(found["greatest_at"] - turn), 1e-9)


class Quotients(FiguresTest):
    """The rocker of the crank-rocker turns back twice: rates over its own have no bound."""

    def test_what_becomes_infinite_on_the_way_has_no_greatest_value_and_no_mean(self) -> None:
        for steps in (24, 97):
            motion = run(FOUR_BAR, "--report", "ratio", "--report", "mechanical_advantage",
                         "--steps", str(steps))
            ratio = self.figures(motion, "load/ratio")
            advantage = self.figures(motion, "load/mechanical_advantage")
            with self.subTest(steps=steps):
                for key in ("least", "greatest", "mean"):
                    self.assertIsNone(ratio[key], key)
                for key in ("greatest", "mean"):
                    self.assertIsNone(advantage[key], key)
                self.assertGreater(advantage["least"], 0.0)

    def test_rest_of_all_is_no_infinity(self) -> None:
        text = FOUR_BAR.replace("motor: 1 rad/s", "motor: 0").replace("  to: 360\n", (
            "  profile: [{to: 20 deg, time: 1 s, law: cycloidal}, "
            "{to: 0 deg, time: 1 s, law: cycloidal}]\n"))
        motion = run(text, "--report", "ratio", "--report", "mechanical_advantage")
        steady = run(FOUR_BAR.replace("to: 360", "to: 20"), "--report", "mechanical_advantage")
        expected = self.figures(steady, "load/mechanical_advantage")
        advantage = self.figures(motion, "load/mechanical_advantage")
        for key in ("least", "greatest"):
            self.assertLess(abs(advantage[key] - expected[key]), 1e-9 * expected[key])
            self.assertIsNotNone(self.figures(motion, "load/ratio")[key])

    def test_what_does_not_has_them(self) -> None:
        text = FOUR_BAR.replace("to: 360", "to: 20")
        figures = self.figures(run(text, "--report", "ratio"), "load/ratio")
        self.assertIsNotNone(figures["greatest"])
        self.assertIsNotNone(figures["mean"])


LIFTED = """\
kinestat: 1
space: planar
ground: frame
gravity: [0, -9.81]
bodies: {arm: {mass: 2, centre_of_mass: [0, -0.5], inertia: 0.1}}
couplings: {a: {type: revolute, bodies: [frame, arm], at: [0, 0]}}
actuators: {m: {coupling: a}}
cases: {run: {motion: {m: 0}, acceleration: {}, action: {}}}
motion: {drive: m, MOTION, case: run, report: [m, power]}
"""


class JumpsOfLaws(FiguresTest):
    def test_extremes_are_those_before_a_jump_too(self) -> None:
        """0.6 kg*m^2 at 4 ranges by the square of the time, and 9.81 N*m at half of 90 degrees."""
        action = 0.6 * 2 * math.pi + 9.81 * math.sin(math.pi / 4)
        for motion in ("to: 90 deg, time: 1 s, law: constant_acceleration",
                       "profile: [{to: 90 deg, time: 1 s, law: constant_acceleration}], time: 1 s"):
            for steps in (2, 3, 7, 10, 100):
                found = run(LIFTED.replace("MOTION", f"{motion}, steps: {steps}"))
                for name, value in (("m/action", action), ("m/power", action * math.pi)):
                    figures = self.figures(found, name)
                    self.assertLess(abs(figures["greatest"] - value), 1e-9 * value, (name, steps))

    def test_an_action_that_ends_at_once_counts(self) -> None:
        """A trapezoid slows down from three quarters of the way on, until then at one speed."""
        action = 9.81 * math.sin(math.pi / 2 * 0.75)
        for steps in (2, 3, 4, 10):
            found = run(LIFTED.replace("MOTION", "to: 90 deg, time: 1 s, law: trapezoid, "
                                       f"steps: {steps}"))
            self.assertLess(abs(self.figures(found, "m/action")["greatest"] - action),
                            1e-9 * action, steps)


HINGE = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank]
couplings: {a: {type: revolute, bodies: [frame, crank], at: [0, 0]}}
actuators: {motor: {coupling: a}}
curves: {push: {over: motor, points: [[0, -100 N], [360, 300 N]]}}
loads: {w: {body: crank, at: [0, 0], force: [0.5 N, push]}}
cases: {run: {motion: {motor: 1 rad/s}}}
motion: {drive: motor, to: 91, case: run, report: [a/force]}
"""

DWELL = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
gravity: [0, -9.81 m/s^2]
bodies: {ram: {mass: 1, centre_of_mass: [0, 0]}}
couplings:
  d: {type: prismatic, bodies: [frame, ram], at: [0, 0], axis: x, friction: 0.1}
actuators: {motor: {coupling: d}}
springs: {s: {coupling: d, stiffness: 1 N/mm, free: 0}}
cases: {run: {motion: {}, acceleration: {}}}
motion:
  drive: motor
  case: run
  profile: [{to: 100, time: 0.4 s, law: cycloidal}, {dwell: 0.2 s}]
  report: [action]
"""


# From 1.02 on the couple is 10 u (1 - u), u the share of the way to 1.06: 2.5 at 1.04.
BEHIND_POINTS = """\
kinestat: 1
space: planar
ground: f
bodies: [c]
couplings: {a: {type: revolute, bodies: [f, c], at: [0, 0]}}
actuators: {M: {coupling: a}}
curves:
  rise: {over: M, points: [[0, 0 N*m], [1.02, 0 N*m], [1.06, 10 N*m]]}
  fall: {over: M, points: [[0, 1], [1.02, 1], [1.06, 0]]}
loads: {L: {body: c, couple: -rise*fall}}
cases: {c: {motion: {M: 1}, action: {}}}
motion: {drive: M, to: END, case: c, report: [M/action]}
"""

# The curve has one of its points twice, at the end of a period and at the begin of the next.
BEHIND_A_PERIOD = """\
kinestat: 1
space: planar
ground: f
bodies: [c, r, s]
couplings:
  a: {type: revolute, bodies: [f, c], at: [0, 0]}
  b: {type: revolute, bodies: [c, r], at: [0.1, 0]}
  c: {type: revolute, bodies: [r, s], at: [0.4, 0]}
  d: {type: prismatic, bodies: [f, s], at: [0.4, 0], axis: x}
actuators: {M: {coupling: a}}
curves: {cv: {over: M, period: 1.25, points: [[0, 0 N*m], [0.625, 1 N*m], [1.0, 0.5 N*m]]}}
loads: {L: {body: c, couple: cv}}
cases: {c: {motion: {M: 1}, action: {}}}
motion: {drive: M, to: 1.29, case: c, report: [d.vx/velocity]}
"""


class BehindTheLastPoint(FiguresTest):
    def test_of_a_curve_a_peak_before_the_end_is_seen(self) -> None:
        for end in (1.042, 1.05, 1.06):
            for steps in (1, 4, 12, 23, 24, 25, 30, 100):
                text = BEHIND_POINTS.replace("END", str(end))
                found = self.figures(run(text, "--steps", str(steps)), "M/action")
                self.assertLess(abs(found["greatest"] - 2.5), VALUE, (end, steps))

    def test_of_a_period_a_peak_before_the_end_is_seen(self) -> None:
        def speed(turn: float) -> float:
            s, c = 0.1 * math.sin(turn), 0.1 * math.cos(turn)
            return -s - s * c / math.sqrt(0.09 - s * s)

        low, high = 1.25, 1.29
        for _ in range(100):
            a, b = low + 0.4 * (high - low), low + 0.6 * (high - low)
            low, high = (low, b) if speed(a) < speed(b) else (a, high)
        for steps in (1, 5, 12, 24, 25, 30, 100):
            found = self.figures(run(BEHIND_A_PERIOD, "--steps", str(steps)), "d.vx/velocity")
            self.assertLess(abs(found["least"] - speed(low)), VALUE, steps)


class SharpTurns(FiguresTest):
    def test_a_force_that_turns_sharply_within_the_last_step_is_seen(self) -> None:
        """hypot(0.5 N, (t - 90 deg) 10 / 9 N / deg), one degree before the end."""
        for steps in (4, 5, 7, 12, 90, 91):
            found = self.figures(run(HINGE, "--steps", str(steps)), "a/force")
            self.assertLess(abs(found["least"] - 0.5), VALUE, steps)

    def test_what_acts_when_a_drive_comes_to_rest_does_not_hang_on_the_steps(self) -> None:
        """The spring and friction at the end of the stroke, which mostly lies between two steps."""
        for steps in (30, 100, 1000, 3601):
            found = self.figures(run(DWELL, "--steps", str(steps)), "motor/action")
            self.assertLess(abs(found["greatest"] - (100.0 + 0.981)), 1e-6, steps)
            self.assertLess(abs(found["least"] - 0.981), 1e-6, steps)


class Returns(MotionTest):
    def test_what_acts_before_and_after_a_drive_returns_is_known(self) -> None:
        """The spring and friction, first against the drive and then with it."""
        text = DWELL.replace("{dwell: 0.2 s}", "{to: 0, time: 0.4 s, law: cycloidal}")
        for steps in (30, 101, 1000):
            motion = run(text, "--steps", str(steps))
            jumps = [event["jumps"]["motor/action"] for event in motion.report["events"]
                     if event["kind"] == "friction_reversal"
                     and abs(event["drive"][0] - 100.0) < 1e-6]
            self.assertEqual(len(jumps), 1, steps)
            self.assertIsNotNone(jumps[0]["before"], steps)
            self.assertIsNotNone(jumps[0]["after"], steps)
            self.assertLess(abs(jumps[0]["before"] - 100.981), 1e-4, steps)
            self.assertLess(abs(jumps[0]["after"] - (100.0 - 0.981)), 1e-4, steps)


class Limited(MotionTest):
    def test_a_motion_that_ends_before_has_no_mean(self) -> None:
        text = FOUR_BAR.replace("[160, 0]", "[230, 0]")
        motion = run(text, "--report", "position", "--steps", "40")
        figures = motion.report["figures"]["d.wz/position"]
        self.assertIsNone(figures["mean"])
        self.assertIsNotNone(figures["least"])


if __name__ == "__main__":
    motion_case.main()
