#!/usr/bin/env python3
"""Checks motions through singular positions against closed forms.

Usage: singular_motion_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import math

import motion_case
from motion_case import MotionTest, derivative, dyad, run, turned


class SingularPositions(MotionTest):
    """A parallelogram, whose links are in line where its crank has turned by a quarter."""

    TEXT = """\
kinestat: 1
name: parallelogram
space: planar
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [0, 1]}
  c: {type: revolute, bodies: [coupler, rocker], at: [3, 1]}
  d: {type: revolute, bodies: [frame, rocker], at: [3, 0]}
actuators: {Tin: {coupling: a}, Tout: {coupling: d}}
cases:
  one: {motion: {Tin: 1 rad/s}, action: {Tout: 1 N*m}, input: Tin, output: Tout}
motion: {drive: Tin, from: %s deg, to: %s deg, steps: 1, case: one,
         report: [d.wz, ratio, power, action]}
"""

    def test_have_positions_alone(self) -> None:
        motion = run(self.TEXT % ("0", "90.0000001"))
        last = dict(zip(motion.names, motion.rows[1]))
        self.assertEqual(last["status"], "singular")
        self.close(last["d.wz/position"], math.radians(90.0000001), 1e-9, "position")
        for name, value in last.items():
            if name.split("/")[-1] in ("velocity", "ratio", "power", "action"):
                self.assertIsNone(value, name)

    def test_are_found_on_the_way_and_nowhere_else(self) -> None:
        for start in ("0", "89", "89.9", "89.99"):
            (place,) = run(self.TEXT % (start, "100")).events("singular")
            self.close(place, math.pi / 2, 1e-9, start)

    def test_may_be_where_a_motion_begins(self) -> None:
        """The parallelogram stays one, from there forwards and back."""
        for start in (90, 89.9999999, 89.99999, 89.9998, 90.0000001, 90.00001, 90.0002, -90,
                      -89.9998, 270.00001):
            for end in (100, 0, -100, 280):
                motion = run(self.TEXT % (start, end))
                for crank, rocker in zip(motion["Tin/drive"], motion["d.wz/position"]):
                    self.close(rocker, crank, 1e-9, f"{start} to {end}")
                self.close(motion["Tin/drive"][-1], math.radians(end), 1e-12, f"{start} to {end}")
                self.assertEqual([round(math.degrees(place), 6)
                                  for place in motion.events("singular")],
                                 self.passed(0, start) + self.passed(start, end)[start in (90, -90):],
                                 f"{start} to {end}")

    def test_may_be_where_several_drives_leave_their_way(self) -> None:
        """An arm on the coupler is driven too: there the drives do not go on in one line."""
        text = self.TEXT[:self.TEXT.index("cases:")]
        text = text.replace("rocker]", "rocker, arm]", 1).replace(
            "actuators: {", "  e: {type: revolute, bodies: [coupler, arm], at: [1, 1]}\n"
            "actuators: {arm: {coupling: e}, ")
        for start in (90, 89.99999, 90.0001, -90, 270):
            for end in (-80, 60, 100, 200):
                for arm in ((10, 20), (10, -300), (0, 5), (5, 5)):
                    motion = run(text + f"""motion:
  drives: [{{drive: Tin, from: {start} deg, to: {end} deg}},
           {{drive: arm, from: {arm[0]} deg, to: {arm[1]} deg}}]
  steps: 3
  report: [d.wz]
""")
                    what = f"{start} to {end}, arm {arm}"
                    self.assertEqual(motion.report["status"], "complete", what)
                    for crank, rocker in zip(motion["Tin/drive"], motion["d.wz/position"]):
                        self.close(rocker, crank, 1e-9, what)
                    self.assertEqual(
                        [round(math.degrees(place), 6) for place in motion.events("singular")],
                        self.passed(0, start) + self.passed(start, end)[start % 180 == 90:], what)

    def test_are_passed_a_thousand_times_in_one_step(self) -> None:
        turns = 1000
        motion = run(self.TEXT % (0, 360 * turns))
        last = 2 * math.pi * turns
        self.close(motion["d.wz/position"][-1], last, 1e-9, "rocker")
        places = motion.events("singular")
        self.assertEqual(len(places), 2 * turns)
        for half, place in enumerate(places):
            self.close(place, math.pi * (half + 0.5), 1e-9 + 1e-15 * last, "change point")

    def test_that_are_missed_by_a_hair_are_none(self) -> None:
        """With a coupler a little longer the branches bend there: beyond it the rocker follows the
        crossed linkage. Where the hair is rounding, they cross and the parallelogram stays one."""
        for gap in (3e-9, 1e-9, 1e-10, 1e-11, 1e-13):
            text = (self.TEXT % (60, 120)).replace("steps: 1,", "steps: 6,")
            motion = run(text.replace("at: [3, 1]", f"at: [{3 + gap!r}, 1]"))
            is_rounding = gap < 1e-12
            self.assertEqual(len(motion.events("singular")), int(is_rounding), f"gap of {gap}")
            for crank, speed in zip(motion["Tin/drive"], motion["d.wz/velocity"]):
                if abs(crank - math.pi / 2) < 1e-3:
                    continue  # In the bend itself, which is sharper than velocities are known.
                crossed = crank > math.pi / 2 and not is_rounding
                expected = derivative(self.crossed_rocker, crank, 1, 0.01).real if crossed else 1.0
                self.close(speed, expected, 1e-6, f"rocker at {crank} with a gap of {gap}")

    @staticmethod
    def crossed_rocker(crank: float) -> float:
        """The angle of the rocker beyond the position in line, on the side on which it came."""
        pin = turned(1j, crank)
        joint = dyad(pin, 3, 3, 1, (1j, 3, 3 + 1j))
        return cmath.phase(joint - 3) % (2 * math.pi)

    def test_are_found_beside_a_fast_gear(self) -> None:
        """A pinion that turns the crank slowly, or that the crank turns fast."""
        for ratio in (10, 15, 30, 100, 1000):
            pinion = f"""  p: {{type: revolute, bodies: [frame, pinion], at: [0, {2 + 2 / ratio!r}]}}
  k: {{type: gear, bodies: [pinion, crank], at: [0, 2], tangent: x,
      pressure_angle: 20 deg}}
"""
            text = (self.TEXT % (0, 200)).replace("bodies: [crank,", "bodies: [pinion, crank,", 1)
            text = text.replace("couplings:\n", "couplings:\n" + pinion)
            fast = text.replace("Tin: {coupling: a}", "Tin: {coupling: p}")
            fast = fast.replace("to: 200 deg", f"to: {-200 * ratio} deg")
            for per_crank, one in ((1, text), (-ratio, fast)):
                for steps in (1, 8, 300):
                    motion = run(one.replace("steps: 1,", f"steps: {steps},"))
                    (event,) = [event for event in motion.report["events"]
                                if event["kind"] == "singular"]
                    self.assertLessEqual(event["uncertainty"], 2e-10 * max(ratio, 10))
                    self.close(event["drive"][0], per_crank * math.pi / 2, event["uncertainty"],
                               f"{ratio} in {steps}")
                    self.close(motion["d.wz/position"][-1], math.radians(200), 1e-9, "rocker")

    @staticmethod
    def passed(start: float, end: float) -> list[float]:
        """The odd quarters of a turn from start to end, both included."""
        quarters = [quarter for quarter in (-270, -90, 90, 270)
                    if min(start, end) <= quarter <= max(start, end)]
        return quarters if end > start else quarters[::-1]


SPRINGS_TO_A_LIMIT = """\
kinestat: 1
space: planar
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [0.03, 0.04]}
  c: {type: revolute, bodies: [coupler, rocker], at: [0.07, 0.06]}
  d: {type: revolute, bodies: [frame, rocker], at: [0.12, 0]}
springs:
  q: {coupling: d, stiffness: 2, damping: DAMPING}
  p: {bodies: [frame, rocker], at: {frame: [0.2, 0.1], rocker: [0.07, 0.06]}, stiffness: 100}
actuators: {motor: {coupling: a}}
cases: {run: {motion: {motor: 1}, action: {}}}
motion: {drive: motor, to: limit, steps: %d, case: run, report: [spring.q, spring.p, motor/action]}
"""


class SpringsAtALimit(MotionTest):
    def test_have_their_lengths_and_what_follows_from_these_alone(self) -> None:
        """Where coupler and rocker are in line nobody knows speeds, and a damper has no force."""
        crank, coupler, rocker = 0.05, math.hypot(0.04, 0.02), math.hypot(0.05, 0.06)
        along = coupler + rocker
        turn = math.acos((0.12 ** 2 + crank ** 2 - along ** 2) / (2 * 0.12 * crank))
        line = complex(crank * math.cos(turn) - 0.12, crank * math.sin(turn)) / along
        joint = 0.12 + rocker * line
        angle = math.atan2(line.imag, line.real) - math.atan2(0.06, -0.05)
        length = abs(0.2 + 0.1j - joint)
        for damping in (0, 0.01):
            for steps in (1, 5, 24, 80):
                motion = run(SPRINGS_TO_A_LIMIT.replace("DAMPING", str(damping)) % steps)
                self.assertEqual(motion["status"][-1], "limit")
                where = f"damping {damping}, {steps} steps"
                self.close(motion["spring.q/angle"][-1], angle, 1e-12, where)
                self.close(motion["spring.p/length"][-1], length, 1e-12, where)
                self.close(motion["spring.p/force"][-1], 100 * (length - math.hypot(0.13, 0.04)),
                           1e-10, where)
                couple = motion["spring.q/couple"][-1]
                if damping:
                    self.assertIsNone(couple, where)
                else:
                    self.close(couple, -2 * angle, 1e-12, where)


IN_LINE = """\
kinestat: 1
space: planar
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0, 2]}
  c: {type: revolute, bodies: [rod, slider], at: [sqrt(21), 0]}
  s: {type: prismatic, bodies: [frame, slider], at: [sqrt(21), 0], axis: x}
actuators: {motor: {coupling: a}, press: {coupling: s}}
motion: {drive: DRIVE, to: END, steps: %d, report: [position]}
"""


class MeansOverTheWay(MotionTest):
    def test_to_a_limit_hardly_hang_on_the_steps(self) -> None:
        """The slider drives the crank, from upright to in line: by parts the mean of its angle is
        that of the way that is left, over the angle."""
        def place(angle: float) -> float:
            return 2 * math.cos(angle) + math.sqrt(25 - (2 * math.sin(angle)) ** 2)

        n = 4000
        weights = [1 if k in (0, n) else 4 if k % 2 else 2 for k in range(n + 1)]
        places = [place(math.pi / 2 * k / n) for k in range(n + 1)]
        area = sum(w * (x - places[0]) for w, x in zip(weights, places)) * math.pi / 6 / n
        expected = area / (places[0] - places[-1])
        for steps, least in ((1, 2e-5), (10, 2e-5), (24, 2e-5), (40, 1e-5), (200, 1e-6)):
            text = IN_LINE.replace("DRIVE", "press").replace("END", "limit") % steps
            mean = run(text).report["figures"]["a.wz/position"]["mean"]
            self.close(mean, expected, least, f"{steps} steps")

    def test_of_part_of_a_turn_are_those_of_the_function(self) -> None:
        """Of the slider over a tenth of a turn: 2 cos a is integrated, of the root Simpson's rule is."""
        end = math.pi / 2 - 0.2 * math.pi
        n = 2000
        weights = [1 if k in (0, n) else 4 if k % 2 else 2 for k in range(n + 1)]
        roots = [math.sqrt(25 - (2 * math.sin(math.pi / 2 - 0.2 * math.pi * k / n)) ** 2)
                 for k in range(n + 1)]
        root = sum(w * one for w, one in zip(weights, roots)) / 3 / n
        expected = 2 * (1 - math.sin(end)) / (0.2 * math.pi) + root - math.sqrt(21)
        for steps in (1, 12, 24, 100):
            text = IN_LINE.replace("DRIVE", "motor").replace("END", "-0.2*pi") % steps
            mean = run(text).report["figures"]["s.vx/position"]["mean"]
            self.close(mean, expected, 1e-8, f"{steps} steps")


if __name__ == "__main__":
    motion_case.main()
