#!/usr/bin/env python3
"""Checks the rows of motions against closed forms where they come to rest, or nearly.

Usage: motion_rows_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import math

import motion_case
import program
from motion_case import Motion, MotionTest, run

CRANK = 40.0
ROD2 = 16000.0

SLIDER_CRANK = """\
kinestat: 1
space: planar
units: {{length: mm, angle: deg}}
parameters: {{t: {turn} deg}}
ground: g
bodies: [crank, rod, ram]
couplings:
  a: {{type: revolute, bodies: [g, crank], at: [0, 0]}}
  b: {{type: revolute, bodies: [crank, rod], at: [-40*sin(t), 40*cos(t)]}}
  c: {{type: revolute, bodies: [rod, ram], at: [120*cos(t), 120*sin(t)]}}
  d: {{type: prismatic, bodies: [g, ram], at: [120*cos(t), 120*sin(t)], axis: [cos(t), sin(t)]}}
actuators: {{m: {{coupling: a}}, o: {{coupling: d}}}}
cases: {{c: {{{case}}}}}
motion: {{{motion}}}
"""


def slope(angle: float) -> float:
    """Of the ram by the crank [mm], which is drawn upright."""
    s, c = math.sin(angle + math.pi / 2), math.cos(angle + math.pi / 2)
    return -CRANK * s - CRANK * CRANK * s * c / math.sqrt(ROD2 - CRANK * CRANK * s * s)


class AtDeadPoints(MotionTest):
    def columns(self, turn: float, steps: int) -> tuple[Motion, list[float]]:
        motion = run(SLIDER_CRANK.format(
            turn=turn,
            case="motion: {m: 10 rad/s}, action: {o: 900 N}, input: m, output: o",
            motion=f"drive: m, to: 360 deg, steps: {steps}, case: c, "
                   "report: [m, o, ratio, mechanical_advantage]"))
        return motion, [math.radians(one) for one in motion["m/drive"]]

    def test_nothing_else_loses_its_ratio_or_advantage(self) -> None:
        for turn, steps in ((0, 8), (33, 8), (0, 36), (71.3, 40)):
            motion, drive = self.columns(turn, steps)
            speed = next(name for name in motion.names if name.startswith("d.")
                         and name.endswith("/velocity"))
            dead = {steps // 4, 3 * steps // 4}
            for step, angle in enumerate(drive):
                row = f"turned by {turn}, {angle} rad"
                ratio = motion["o/ratio"][step]
                advantage = motion["o/mechanical_advantage"][step]
                if step in dead:
                    self.assertIsNone(ratio, row)
                    self.assertIsNone(advantage, row)
                    self.assertEqual(motion[speed][step], 0.0, row)
                    self.assertEqual(motion["m/action"][step], 0.0, row)
                    self.assertEqual(motion["o/power"][step], 0.0, row)
                    self.assertEqual(motion["m/power"][step], 0.0, row)
                else:
                    expected = slope(angle)
                    self.close(ratio * expected, 1.0, 1e-10, row)
                    self.close(motion[speed][step] / (10 * expected), 1.0, 1e-10, row)
                    self.close(advantage * abs(expected) / 1000.0, 1.0, 1e-10, row)

    def test_ratios_and_advantages_have_units(self) -> None:
        motion, _ = self.columns(0, 8)
        units = {column["name"]: column["unit"] for column in motion.report["columns"]}
        self.assertEqual(units["o/ratio"], "rad/mm")
        self.assertEqual(units["o/mechanical_advantage"], "1/m")

    def test_an_advantage_without_statics_has_the_same_unit_and_value(self) -> None:
        motion = run(SLIDER_CRANK.format(
            turn=0, case="motion: {m: 10 rad/s}, input: m, output: o",
            motion="drive: m, to: 360 deg, steps: 8, case: c, report: [mechanical_advantage]"))
        for angle, advantage in zip(motion["m/drive"], motion["o/mechanical_advantage"]):
            if advantage is not None:
                self.close(advantage * abs(slope(math.radians(angle))) / 1000.0, 1.0, 1e-10, f"{angle} rad")
        self.assertEqual([step for step, one in enumerate(motion["o/mechanical_advantage"])
                          if one is None], [2, 6])

    def test_an_output_that_bears_nothing_has_no_ratio_of_rates_for_an_advantage(self) -> None:
        """0/0 has no value, and 0 over the torque that holds a weight on the rod is 0. The pin of
        the crank bears a part of it upwards, which has no torque where the crank is upright."""
        weight = ", loads: {weight: {body: rod, at: [10, 30], force: [0, -50 N]}}"
        for load, step_without in (("", None), (weight, 0)):
            motion = run(SLIDER_CRANK.format(
                turn=0, case="motion: {m: 10 rad/s}, action: {o: 0 N}, input: m, output: o" + load,
                motion="drive: m, to: 60 deg, steps: 6, case: c, "
                       "report: [m, o, ratio, mechanical_advantage]"))
            for step in range(7):
                rests = step_without in (None, step)
                self.assertEqual(motion["o/action"][step], 0.0)
                self.assertEqual(motion["m/action"][step] == 0.0, rests)
                self.assertEqual(motion["o/mechanical_advantage"][step], None if rests else 0.0)
                self.assertIsNotNone(motion["o/ratio"][step])


class BetweenSteps(MotionTest):
    def test_the_stroke_does_not_depend_on_the_steps(self) -> None:
        """Twice the crank, wherever the steps fall."""
        rod = math.sqrt(ROD2)
        for steps in (7, 8, 50, 71):
            text = SLIDER_CRANK.format(
                turn=0, case="motion: {m: 10 rad/s}",
                motion=f"drive: m, to: 360 deg, steps: {steps}, case: c, report: [d.v]")
            done = program.plain("motion", "-", text=text)
            line = next(line for line in done.stdout.splitlines()
                        if line.strip().startswith("d.v/position"))
            least, at_least, greatest, at_greatest = map(float, line.split()[2:6])
            self.close(least, rod - 40 - 120, 1e-4, f"{steps} steps")
            self.close(greatest, rod + 40 - 120, 1e-4, f"{steps} steps")
            self.close(at_least, 90, 1e-3, f"{steps} steps")
            self.close(at_greatest, 270, 1e-3, f"{steps} steps")
            self.assertIn("Extremes  ", done.stdout)

    def test_a_limit_that_is_asked_for_is_no_warning(self) -> None:
        for end, warns in (("46.491106406735", False), ("46.5", True)):
            done = program.call("motion", "-", text=SLIDER_CRANK.format(
                turn=0, case="motion: {o: 1 mm/s}",
                motion=f"drive: o, to: {end} mm, steps: 4, case: c, report: [a.wz]"))
            self.assertEqual((done.returncode, "W0518" in done.stderr), (0, warns), done.stderr)


class NearALimit(MotionTest):
    def test_the_last_row_hides_no_acceleration_of_the_others(self) -> None:
        """cos a = (x² + r² - l²)/(2 r x), the ram running steadily."""
        motion = run(SLIDER_CRANK.format(
            turn=0, case="motion: {o: 1 mm/s}",
            motion="drive: o, to: 46.491106 mm, steps: 10, case: c, report: [a.wz, b.wz]"))
        r, k = CRANK, (CRANK * CRANK - ROD2) / (2 * CRANK)
        for way, actual in list(zip(motion["o/drive"], motion["a.wz/acceleration"]))[:-1]:
            x = 120.0 + way
            c, slope_of_c, bend = x / (2 * r) + k / x, 1 / (2 * r) - k / x ** 2, 2 * k / x ** 3
            s = math.sqrt(1 - c * c)
            expected = -bend / s - c * slope_of_c ** 2 / s ** 3
            self.assertNotEqual(actual, 0.0)
            self.close(actual / expected, 1.0, 1e-9, f"at {way} mm")
        self.assertGreater(abs(motion["a.wz/acceleration"][-1]), 1e6)


GEARS = """\
kinestat: 1
space: planar
units: {angle: deg}
ground: g
bodies: [w, s]
couplings:
  a: {type: revolute, bodies: [g, w], at: [0, 0]}
  b: {type: gear, bodies: [w, s], at: [1, 0], line_of_action: y}
  d: {type: revolute, bodies: [g, s], at: [3, 0]}
actuators: {m: {coupling: a}}
cases: {k: {motion: {m: 2 rad/s, d.wz: %s rad/s}}}
motion: {drive: m, to: 10 deg, steps: 2, case: k, report: [a.wz, d.wz]}
"""

FIVE_BAR = """\
kinestat: 1
space: planar
units: {angle: deg}
ground: g
bodies: [k1, k2, k3, k4]
couplings:
  a: {type: revolute, bodies: [g, k1], at: [0, 0]}
  b: {type: revolute, bodies: [k1, k2], at: [0, 1]}
  c: {type: revolute, bodies: [k2, k3], at: [1, 2]}
  d: {type: revolute, bodies: [k3, k4], at: [2, 1]}
  e: {type: revolute, bodies: [g, k4], at: [2, 0]}
actuators: {A: {coupling: a}, E: {coupling: e}}
cases:
  one: {motion: {%s}}
motion: {drives: [{drive: A, to: 10 deg}, {drive: E, to: -5 deg}], steps: 2, case: one,
         report: [a.wz, b.wz, e.wz]}
"""


def cross(rate: float, arm: complex) -> complex:
    return 1j * rate * arm


def solve(first: complex, second: complex, right: complex) -> tuple[float, float]:
    """x first + y second = right."""
    det = (first.conjugate() * second).imag
    return (right.conjugate() * second).imag / det, (first.conjugate() * right).imag / det


# Of a crank of 1 m and a rod of 3 m, whose slider at s m drives: cos t = (s^2 - 8)/(2 s).
STRETCHED = """\
kinestat: 1
space: planar
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0, 1]}
  c: {type: revolute, bodies: [rod, slider], at: [sqrt(8), 0]}
  d: {type: prismatic, bodies: [frame, slider], at: [sqrt(8), 0], axis: x}
actuators: {Tin: {coupling: a}, F: {coupling: d}}
cases:
  one: {motion: {F: 1 m/s}, input: F, output: Tin}
  two: {motion: {Tin: 1 rad/s, F: 3 m/s}, input: Tin, output: F}
motion:
  drive: F
  to: 4 - sqrt(8) - %s
  steps: %d
  case: %s
  trace: [{body: rod, at: [0, 1]}]
  report: [%s]
"""


class NearADeadCentre(MotionTest):
    def test_a_cell_is_right_or_empty_and_never_zero_for_want_of_digits(self) -> None:
        for before in ("1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9"):
            done = program.call("motion", "-",
                                text=STRETCHED % (before, 1, "one", "velocity, acceleration"))
            motion = Motion(program.report(done))
            d = float(before)
            s = 4 - d
            # sin^2 t = (1 - cos t)(1 + cos t) without what cancels: 1 - cos t = d (6 - d)/(2 s).
            cos = (s * s - 8) / (2 * s)
            sin = math.sqrt(d * (6 - d) / (2 * s) * (1 + cos))
            first, second = (s * s + 8) / (2 * s * s), -8 / s ** 3
            omega = -first / sin
            alpha = -(second + cos * omega * omega) / sin
            expected = {"crank/angular/z": omega,
                        "crank/angular_acceleration/z": alpha,
                        "crank/linear/x": 0.0,
                        "slider/linear/x": 1.0,
                        "slider/linear/y": 0.0,
                        "slider/linear_acceleration/x": 0.0,
                        "rod/linear/x": first,
                        "rod/linear/y": cos * omega,
                        "rod/linear_acceleration/x": second,
                        "rod/linear_acceleration/y": -sin * omega * omega + cos * alpha,
                        "rod.1/linear/x": first,
                        "rod.1/linear/y": cos * omega,
                        "rod.1/linear_acceleration/x": second}
            for name, value in expected.items():
                cell = motion[name][1]
                if cell is None:
                    self.assertIn("W0507", done.stderr, f"{name}, {before}")
                else:
                    # The place of the slider is known to 1e-15 of itself.
                    self.close(cell, value, 1e-14 / d * max(abs(value), 1.0) + 1e-9 * abs(value),
                               f"{name}, {before} m before")
            if d >= 1e-3:
                self.assertNotIn("W0507", done.stderr, before)

    def test_contradictory_speeds_are_refused_there_too(self) -> None:
        for before in ("1e-3", "1e-6", "1e-9"):
            done = program.call("motion", "-", text=STRETCHED % (before, 4, "two", "ratio"))
            motion = Motion(program.report(done))
            self.assertEqual(set(motion["status"]), {"dependent"}, before)
            self.assertEqual(set(motion["F/ratio"]), {None}, before)
            self.assertEqual(done.returncode, 3, before)


# A parallelogram with a third crank, drawn exactly or off by some micrometres.
THREE_CRANKS = """\
kinestat: 1
space: planar
ground: frame
bodies: [crank, coupler, rocker, third]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [0.1, 0.3]}
  c: {type: revolute, bodies: [coupler, rocker], at: [0.8, 0.3]}
  d: {type: revolute, bodies: [frame, rocker], at: [0.7, 0]}
  e: {type: revolute, bodies: [frame, third], at: [0.3, 0]}
  f: {type: revolute, bodies: [third, coupler], at: [%s, 0.3]}
actuators: {m: {coupling: a}, o: {coupling: d}}
cases: {one: {motion: {%s}, input: m, output: o}}
motion: {drive: m, to: 30 deg, steps: 3, case: one, report: [%s]}
"""


class ClosedByLeastSquares(MotionTest):
    def test_contradictory_speeds_are_refused_as_where_it_closes(self) -> None:
        for at in ("0.4", "0.40000000001", "0.400001"):
            for report in ("ratio", "velocity", "velocity, ratio"):
                done = program.call("motion", "-", text=THREE_CRANKS % (
                    at, "m: 1 rad/s, o: 2 rad/s", report))
                what = f"{at}, {report}"
                self.assertEqual(set(Motion(program.report(done))["status"]), {"dependent"}, what)
                self.assertIn("E0502", done.stderr, what)
                self.assertEqual(done.returncode, 3, what)

    def test_its_ratio_is_that_of_its_velocities(self) -> None:
        for at in ("0.4", "0.40000000001", "0.400001"):
            for known, ratio in (("m: 1 rad/s", 1.0), ("m: 2 rad/s", 1.0)):
                motion = run(THREE_CRANKS % (at, known, "ratio, velocity"))
                for step in range(4):
                    self.close(motion["o/ratio"][step], ratio, 1e-5, at)
                    self.close(motion["o/ratio"][step] * motion["d.wz/velocity"][step]
                               / motion["a.wz/velocity"][step], 1.0, 1e-12, at)


# The slider rests where crank and rod are in line: no speed of it is possible there.
IN_LINE = """\
kinestat: 1
space: planar
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [1, 0]}
  c: {type: revolute, bodies: [rod, slider], at: [4, 0]}
  d: {type: prismatic, bodies: [frame, slider], at: [4, 0], axis: x}
actuators: {Tin: {coupling: a}, F: {coupling: d}}
cases: {two: {motion: {F: 1 m/s}}}
motion: {drive: Tin, to: 180 deg, steps: 4, case: two, report: [velocity]}
"""

# In two positions so near a singular one that accelerations of other bodies have few digits.
STEADY_ROCKER = """\
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
cases: {c: {motion: {load: 1}}}
motion: {drive: motor, to: 180, steps: 36, case: c, report: acceleration}
"""


class KnownRates(MotionTest):
    def test_a_body_on_the_ground_speeds_up_as_its_bearing_does(self) -> None:
        motion = run(STEADY_ROCKER)
        self.assertEqual(set(motion["d.wz/acceleration"]), {0.0})
        self.assertEqual(set(motion["rocker/angular_acceleration/z"]), {0.0})

    def test_that_no_motion_has_are_refused_in_the_rows_where_it_has_none(self) -> None:
        analysed = program.call("analyze", "-", text=IN_LINE)
        moved = program.call("motion", "-", text=IN_LINE)
        self.assertIn("E0502", analysed.stderr)
        self.assertIn("E0502", moved.stderr)
        self.assertEqual(moved.returncode, analysed.returncode)
        self.assertEqual(Motion(program.report(moved))["status"],
                         ["dependent", "solved", "solved", "solved", "dependent"])

    def test_that_contradict_the_moved_mechanism_are_refused_as_by_analysis(self) -> None:
        for rate in ("-1.0005", "-1.01", "-1", "-0.9999999"):
            text = GEARS % rate
            analysed = program.call("analyze", "-", text=text)
            moved = program.call("motion", "-", text=text)
            self.assertIn("E0502", analysed.stderr, rate)
            self.assertIn("E0502", moved.stderr, rate)
            self.assertIn("3 of 3 positions", moved.stderr, rate)
            self.assertEqual(moved.returncode, analysed.returncode, rate)
            motion = Motion(program.report(moved))
            self.assertEqual(set(motion["d.wz/velocity"]), {None}, rate)
            self.assertEqual(set(motion["status"]), {"dependent"}, rate)

    def test_of_other_couplings_than_the_drives_give_the_speeds_of_both(self) -> None:
        motion = run(FIVE_BAR % "a.wz: 2 rad/s, b.wz: 1 rad/s")
        e = 2 + 0j
        for step in range(3):
            alpha, beta, epsilon = (math.radians(motion[f"{name}.wz/position"][step])
                                    for name in "abe")
            ab = 1j * cmath.exp(1j * alpha)
            bc = (1 + 1j) * cmath.exp(1j * (alpha + beta))
            ed = 1j * cmath.exp(1j * epsilon)
            cd = e + ed - ab - bc
            w3, w4 = solve(-1j * cd, 1j * ed, cross(2, ab) + cross(3, bc))
            bend = -4 * ab - 9 * bc - w3 * w3 * cd + w4 * w4 * ed
            _, bend4 = solve(-1j * cd, 1j * ed, bend)
            self.close(motion["e.wz/velocity"][step], w4, 1e-11 * abs(w4), f"step {step}")
            self.close(motion["e.wz/acceleration"][step], bend4, 1e-9 * abs(bend4), f"step {step}")
            self.close(motion["b.wz/velocity"][step], 1.0, 1e-12, f"step {step}")
            self.assertEqual(motion["a.wz/velocity"][step], 2.0)
            self.close(motion["b.wz/acceleration"][step], 0.0, 1e-9, f"step {step}")
        self.close(motion["e.wz/velocity"][0], 8.0, 1e-12, "drawn")

    def test_that_are_too_few_are_named(self) -> None:
        done = program.call("motion", "-", text=FIVE_BAR % "b.wz: 1 rad/s")
        self.assertIn("E0501", done.stderr)
        self.assertEqual(done.returncode, 3)


FAR = """\
kinestat: 1
space: planar
ground: g
bodies: [k2, k3, k4]
parameters: {ox: %s, oy: %s}
couplings:
  a: {type: revolute, bodies: [g, k2], at: [ox, oy]}
  b: {type: revolute, bodies: [k2, k3], at: [ox + 0.3, oy + 0.4]}
  c: {type: revolute, bodies: [k3, k4], at: [ox + 1.5, oy + 1]}
  d: {type: revolute, bodies: [g, k4], at: [ox + 1.6, oy + 0]}
actuators: {m: {coupling: a}, o: {coupling: d}}
loads: {W: {body: k3, at: [ox+1, oy+1], force: [3, -40]}}
cases: {c: {motion: {m: 1e-3}, action: {o: -5}, input: m, output: o}}
motion: {drive: m, to: 1.5 rad, steps: 5, case: c,
         report: [position, velocity, acceleration, action],
         trace: [{body: k3, at: [ox+1, oy+1]}]}
"""


class FarFromTheOrigin(MotionTest):
    def test_all_rows_are_those_beside_it(self) -> None:
        near = run(FAR % ("0", "0"))
        for ox, oy in (("4.5e6", "1e6"), ("1e8", "-2e8"), ("1e10", "-2e10"), ("1e12", "1e12")):
            far = run(FAR % (ox, oy))
            self.assertEqual(far.names, near.names)
            for name in near.names:
                if name in ("closure_error", "status"):
                    continue
                place = {"x": float(ox), "y": float(oy)}.get(name[-1], 0.0) if "/at/" in name else 0
                for step, (one, other) in enumerate(zip(near[name], far[name])):
                    tolerance = 1e-12 * (1 + abs(one)) + 4e-16 * abs(place)
                    self.close(other - place, one, tolerance, f"{name} at {ox}, step {step}")

    def test_a_place_in_line_with_a_far_origin_is_zero_as_near_it(self) -> None:
        text = """\
kinestat: 1
space: planar
ground: g
bodies: [crank]
parameters: {ox: %s}
couplings: {a: {type: revolute, bodies: [g, crank], at: [ox, 0.1]}}
actuators: {m: {coupling: a}}
cases: {c: {motion: {m: 1 rad/s}}}
motion:
  drive: m
  to: 360 deg
  steps: 12
  case: c
  trace: [{body: crank, at: [ox + 0.1, 0.1]}, {body: crank, at: [ox + 0.2, 0.1]}]
  report: [position]
"""
        for origin in ("0", "1000", "12345.678"):
            motion = run(text % origin)
            # 0.1 + 0.1 sin 270 deg, and 0.1 + 0.2 sin 210 deg and 330 deg.
            for name, steps in (("crank.1", (9,)), ("crank.2", (7, 11))):
                for step in steps:
                    self.assertEqual(motion[f"{name}/at/y"][step], 0.0, f"{origin}, step {step}")

    def test_the_drawn_position_is_that_of_analysis(self) -> None:
        text = FAR % ("1e10", "-2e10")
        actions = run(text)
        self.close(actions["a.Rx/action"][0], -5.396825396825397, 1e-12, "a.Rx")


if __name__ == "__main__":
    motion_case.main()
