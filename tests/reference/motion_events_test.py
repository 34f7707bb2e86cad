#!/usr/bin/env python3
"""Checks what happens between the positions of a motion against closed forms.

Usage: motion_events_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import math

import motion_case
import program
from motion_case import MotionTest, dyad, in_library, run


def findings(text: str, *options: str) -> str:
    return program.call("motion", *options, "-", text=text).stderr


class RopeThatLiftsOff(MotionTest):
    """From a hand over a small fixed sheave to a ram, whose rise takes the cable off the sheave."""

    CENTRE, RADIUS, HAND, RAM = complex(100, 30), 20.0, -100.0, 200.0

    TEXT = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [hand, sheave, ram]
couplings:
  h: {type: prismatic, bodies: [g, hand], at: [-100, 0], axis: x}
  s: {type: revolute, bodies: [g, sheave], at: [100, %(side)s30]}
  r: {type: prismatic, bodies: [g, ram], at: [200, 0], axis: y}
cables:
  rope:
    over:
      - {body: hand, at: [-100, 0]}
      - {pulley: sheave, radius: 20, wrap: %(wrap)s, slip: true}
      - {body: ram, at: [200, 0]}
actuators: {H: {coupling: h}, R: {coupling: r}, S: {coupling: s}}
cases: {c: {motion: {R: 10 mm/s, s.wz: 0}, action: {H: -50 N}}}
motion:
  drives: [{drive: R, to: %(side)s%(to)s mm}, {drive: S, to: 0}]
  steps: %(steps)s
  case: c
  report: [h.vx, r.vy, rope_1.F]
"""

    def arc_and_length(self, hand: float, rise: float) -> tuple[float, float]:
        """Of a cable that runs clockwise over the sheave; the arc below zero where it is clear."""
        ends = complex(hand, 0), complex(self.RAM, rise)
        tangents = [math.sqrt(abs(end - self.CENTRE) ** 2 - self.RADIUS ** 2) for end in ends]
        lean = [math.atan2(self.RADIUS, tangent) for tangent in tangents]
        first = cmath.phase((self.CENTRE - ends[0]) * cmath.exp(1j * lean[0]))
        second = cmath.phase((ends[1] - self.CENTRE) * cmath.exp(-1j * lean[1]))
        return first - second, sum(tangents) + self.RADIUS * (first - second)

    def hand_at(self, rise: float) -> float:
        whole = self.arc_and_length(self.HAND, 0.0)[1]
        low, high = self.HAND - 60.0, self.HAND + 60.0
        for _ in range(200):
            middle = (low + high) / 2
            if self.arc_and_length(middle, rise)[1] > whole:
                low = middle
            else:
                high = middle
        return low

    def lift_off(self) -> float:
        low, high = 0.0, 100.0
        for _ in range(200):
            middle = (low + high) / 2
            if self.arc_and_length(self.hand_at(middle), middle)[0] > 0.0:
                low = middle
            else:
                high = middle
        return low

    def test_ends_the_motion_where_the_arc_is_zero(self) -> None:
        place = self.lift_off()
        for steps in (1, 2, 15, 150):
            for side, wrap, sign in (("", "clockwise", 1), ("-", "counterclockwise", -1)):
                text = self.TEXT % {"side": side, "wrap": wrap, "to": 150, "steps": steps}
                motion = run(text, status=5)
                self.assertEqual(motion.report["status"], "limited")
                (event,) = motion.events("lift_off")
                self.close(event, sign * place, 1e-7, f"{steps} {wrap}")
                rises = [sign * rise for rise in motion["R/drive"]]
                self.assertEqual(len(rises), int(place / 150 * steps) + 2)
                self.close(rises[-1], place, 1e-7, "the last row")
                for rise, hand in zip(rises, motion["h.vx/position"]):
                    self.close(hand, self.hand_at(rise) - self.HAND, 1e-7, f"hand at {rise}")

    def test_is_told_with_its_place(self) -> None:
        text = self.TEXT % {"side": "", "wrap": "clockwise", "to": 150, "steps": 15}
        told = findings(text)
        self.assertIn("error[E0510]", told)
        self.assertIn(f"R = {self.lift_off():.3f}"[:8], told)

    def test_has_no_event_before(self) -> None:
        text = self.TEXT % {"side": "", "wrap": "clockwise", "to": int(self.lift_off()), "steps": 3}
        self.assertEqual(run(text).events("lift_off"), [])


class DeadPoints(MotionTest):
    STEP_UP = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [w0, w1, w2, rod, ram]
couplings:
  r0: {type: revolute, bodies: [g, w0], at: [-180, 0]}
  r1: {type: revolute, bodies: [g, w1], at: [-90, 0]}
  r2: {type: revolute, bodies: [g, w2], at: [0, 0]}
  m0: {type: gear, bodies: [w0, w1], at: [-100, 0], line_of_action: y}
  m1: {type: gear, bodies: [w1, w2], at: [-10, 0], line_of_action: y}
  b: {type: revolute, bodies: [w2, rod], at: [18, 24]}
  c: {type: revolute, bodies: [rod, ram], at: [118, 0]}
  d: {type: prismatic, bodies: [g, ram], at: [118, 0], axis: x}
actuators: {m: {coupling: r0}}
cases: {c: {motion: {m: 1 rad/s}}}
motion: {drive: m, to: 360 deg, steps: %s, case: c, report: [d.vx]}
"""

    def test_of_a_crank_behind_a_step_up_of_64_are_all_found(self) -> None:
        """Its crank is in line with its rod twice a turn."""
        drawn = math.atan2(24, 18)
        expected = [math.degrees((k * math.pi - drawn) / 64) for k in range(1, 129)]
        for steps in (1, 10, 36, 360):
            places = run(self.STEP_UP % steps).events("dead_point", "d.vx")
            self.assertEqual(len(places), 128, f"steps: {steps}")
            for place, one in zip(places, expected):
                self.close(place, one, 1e-9, f"steps: {steps}")

    TWO_CRANKS = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [arm, tip, ram]
parameters: {b: "10 mm/cos(%(half)r deg)"}
couplings:
  a: {type: revolute, bodies: [g, arm], at: [0, 0]}
  j: {type: revolute, bodies: [arm, tip], at: [40, 0]}
  p: {type: pin_in_slot, bodies: [tip, ram], at: [40 mm + b, 0], slot: y}
  r: {type: prismatic, bodies: [g, ram], at: [40 mm + b, 0], axis: x}
actuators: {A: {coupling: a}, J: {coupling: j}, R: {coupling: r}}
cases: {c: {motion: {A: 1 rad/s, J: 1 rad/s}}}
motion:
  drives: [{drive: A, from: %(start)s deg, to: %(end)s deg},
           {drive: J, from: %(start)s deg, to: %(end)s deg}]
  steps: %(steps)s
  case: c
  report: [r.vx]
"""

    def test_close_together_are_all_found(self) -> None:
        """x = A cos(t) + B cos(2t) rests at 0 and 180 deg and, with cos(h) = A / 4B, h beside."""
        for half in (30.0, 1.7, 0.85, 0.1, 0.01):
            for start, end, steps in ((90.3, 270.3, 180), (90, 270, 1), (100, 260, 7),
                                      (179.3, 180.3, 1), (90, 270, 180)):
                text = self.TWO_CRANKS % {"half": half, "start": start, "end": end, "steps": steps}
                places = run(text).events("dead_point", "r.vx")
                expected = [place for place in (180 - half, 180.0, 180 + half)
                            if start < place < end]
                self.assertEqual(len(places), len(expected), f"{half} {start} {steps} {places}")
                for place, one in zip(places, expected):
                    # The rate is flat there: rounding counts by its slope.
                    self.close(place, one, 1e-9 + 1e-11 / math.radians(half) ** 2, f"{half}")

    def test_that_are_nearly_there_are_not_invented(self) -> None:
        """With A a little larger than 4B it rests at 180 deg alone."""
        text = self.TWO_CRANKS % {"half": 1, "start": 90.3, "end": 270.3, "steps": 180}
        for share in (0.99, 0.9999, 0.999999):
            one = text.replace("10 mm/cos(1 deg)", f"{10 * share!r} mm")
            (place,) = run(one).events("dead_point", "r.vx")
            self.close(place, 180.0, 1e-8 / (1 - share), str(share))

    BEHIND = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [crank, coupler, rocker, rod, ram]
couplings:
  a: {type: revolute, bodies: [g, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [0, 10]}
  c: {type: revolute, bodies: [coupler, rocker], at: [30, 10]}
  d: {type: revolute, bodies: [g, rocker], at: [30, 0]}
  e: {type: revolute, bodies: [crank, rod], at: [0, 10]}
  f: {type: revolute, bodies: [rod, ram], at: [50*cos(20 deg), 50*sin(20 deg)]}
  h: {type: prismatic, bodies: [g, ram], at: [50*cos(20 deg), 50*sin(20 deg)],
      axis: [cos(20 deg), sin(20 deg)]}
actuators: {A: {coupling: a}}
cases: {c: {motion: {A: 1 rad/s}}}
motion: {drive: A, from: %s deg, to: %s deg, steps: %s, case: c, report: [position]}
"""

    def test_behind_a_row_at_a_singular_position_are_found(self) -> None:
        """A parallelogram in line after 90 deg; a ram on the same crank turns back at 110 deg."""
        for start, end, steps in ((0, 180, 2), (90, 180, 1), (0, 180, 1), (90, 112, 1),
                                  (60, 120, 6), (0, 180, 4)):
            motion = run(self.BEHIND % (start, end, steps))
            places = motion.events("dead_point", "h.v")
            self.assertEqual(len(places), 1, f"{start} to {end} in {steps}: {motion.report['events']}")
            self.close(places[0], 110.0, 1e-8, f"{start} to {end} in {steps}")

    IN_LINE = """\
kinestat: 1
space: planar
ground: g
bodies: [crank, rod, ram]
couplings:
  a: {type: revolute, bodies: [g, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [%s, %s]}
  c: {type: revolute, bodies: [rod, ram], at: [%s, 0]}
  d: {type: prismatic, bodies: [g, ram], at: [%s, 0], axis: x}
actuators: {A: {coupling: a}}
cases: {c: {motion: {A: 1 rad/s}}}
motion: {drive: A, to: 0.1, steps: 4, case: c, report: [position]}
"""

    def test_in_a_row_are_no_nearer_than_its_rate_is_told_from_zero(self) -> None:
        """The crank is in line with the rod at -atan(y/x); as drawn its rate is rounding."""
        for x, y, end in ((9e9, -12, 14), (0.3, -1e-15, 1.3), (0.3, 0, 1.3), (3e6, 1e-8, 4e6)):
            events = run(self.IN_LINE % (x, y, end, end)).report["events"]
            (one,) = [event for event in events if event["element"] == "d.vx"]
            self.assertLessEqual(abs(one["drive"][0] + math.atan2(y, x)), one["uncertainty"] + 1e-16,
                                 f"{x} {one}")
            self.assertLess(one["uncertainty"], 1e-3 if x > 1e9 else 1e-12, f"{x} {one}")

    def test_behind_the_first_row_are_none_of_the_motion(self) -> None:
        """It lies 3.3e-13 rad behind it: far, as 1e-15 of the crank is some 1e-15 rad."""
        events = run(self.IN_LINE % (3e6, 1e-6, 4e6, 4e6)).report["events"]
        self.assertEqual([event for event in events if event["element"] == "d.vx"], [])


class CircuitsThatHoldTooMuch(MotionTest):
    """As many equations as unknowns, but one circuit has one too many and the other too few."""

    TEXT = """\
kinestat: 1
space: planar
ground: base
bodies: [arm, disk, link, bar, shoe]
couplings:
  c1: {type: revolute, bodies: [arm, base], at: [4, -4]}
  c2: {type: revolute, bodies: [arm, link], at: [-4, -3]}
  c3: {type: revolute, bodies: [arm, disk], at: [-3.4, -3]}
  c4: {type: revolute, bodies: [link, bar], at: [-3, 0]}
  c5: {type: prismatic, bodies: [bar, shoe], at: [-2, -3], axis: x}
  c6: {type: revolute, bodies: [shoe, bar], at: [-2.1, 2.9]}
  c7: {type: pin_in_slot, bodies: [bar, arm], at: [-4, 1], slot: y}
actuators: {m1: {coupling: c3}, m2: {coupling: c1}}
motion: {drives: [{drive: m1, to: 0.1}, {drive: m2, to: 0.1}], steps: 1}
"""

    def test_leave_a_freedom_open(self) -> None:
        done = program.call("motion", "-", text=self.TEXT)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("E0508", done.stderr)
        self.assertIn("do not determine c4.wz", done.stderr)


class ChangePoints(MotionTest):
    LOCOMOTIVE = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [c, k1, r1, k2, r2]
parameters: {t: 60 deg, o: %s deg}
couplings:
  A: {type: revolute, bodies: [g, c], at: [0, 0]}
  B1: {type: revolute, bodies: [c, k1], at: [50*cos(t), 50*sin(t)]}
  C1: {type: revolute, bodies: [k1, r1], at: [100+50*cos(t), 50*sin(t)]}
  D1: {type: revolute, bodies: [g, r1], at: [100, 0]}
  B2: {type: revolute, bodies: [c, k2], at: [40*cos(t-o), 40*sin(t-o)]}
  C2: {type: revolute, bodies: [k2, r2], at: [130+40*cos(t-o), 40*sin(t-o)]}
  D2: {type: revolute, bodies: [g, r2], at: [130, 0]}
actuators: {m: {coupling: A}}
motion: {drive: m, to: 360 deg, steps: %s, report: [position]}
"""

    def test_of_two_parallelograms_are_found_in_any_number_of_steps(self) -> None:
        for behind in (0.0, 0.5, 0.1, 1e-3, -0.5, 10.0):
            expected = sorted({120.0, 120.0 + behind, 300.0, 300.0 + behind})
            for steps in (1, 2, 3, 5, 7, 11, 36, 50, 100, 360):
                text = self.LOCOMOTIVE % (behind, steps)
                motion = run(text)
                what = f"{behind} deg behind in {steps}"
                places = motion.events("singular")
                self.assertEqual(len(places), len(expected), f"{what}: {places}")
                for place, one in zip(places, expected):
                    self.close(place, one, 1e-6, what)
                self.assertIn("W0503", findings(text), what)
                for crank, first, second in zip(motion["m/drive"], motion["D1.wz/position"],
                                                motion["D2.wz/position"]):
                    self.close(first, crank, 1e-6, f"{what}: first rocker at {crank}")
                    self.close(second, crank, 1e-6, f"{what}: second rocker at {crank}")

    SCISSOR_LIFT = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {arm: 1200, tilt: 15 deg, x: arm*cos(tilt), y: arm*sin(tilt)}
ground: base
bodies: [arm1, arm2, platform]
couplings:
  a: {type: revolute, bodies: [base, arm1], at: [0, 0]}
  m: {type: revolute, bodies: [arm1, arm2], at: [x/2, y/2]}
  r: {type: pin_in_slot, bodies: [arm2, base], at: [x, 0], slot: x}
  p: {type: revolute, bodies: [platform, arm2], at: [0, y]}
  r2: {type: pin_in_slot, bodies: [arm1, platform], at: [x, y], slot: x}
actuators: {turn: {coupling: a}}
motion: {drive: turn, to: %s deg, steps: %s, report: [top/at],
         trace: [{body: arm2, at: [0, y], name: top}]}
"""

    def test_where_arms_of_a_scissor_stand_upright_lead_on_by_any_number_of_steps(self) -> None:
        """Both slots could turn with the arms from there on; the platform stays level above them."""
        for to in (105, 150, 74, 75, -10):
            for steps in (1, 2, 3, 4, 5, 7, 10, 11, 13, 15, 20, 30, 31):
                motion = run(self.SCISSOR_LIFT % (to, steps))
                what = f"to {to} in {steps}"
                self.assertEqual([round(one, 5) for one in motion.events("singular")],
                                 [75.0] if to > 74 else [], what)
                for turn, x, y in zip(motion["turn/drive"], motion["top/at/x"], motion["top/at/y"]):
                    self.close(x, 0.0, 1e-4, f"{what}: x at {turn}")
                    self.close(y, 1200 * math.sin(math.radians(15 + turn)), 1e-4,
                               f"{what}: y at {turn}")

    THREE_CRANKS = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [c1, k, c2, e, c3]
parameters: {t: 60 deg}
couplings:
  A: {type: revolute, bodies: [g, c1], at: [0, 0]}
  B: {type: revolute, bodies: [c1, k], at: [40*cos(t), 40*sin(t)]}
  C: {type: revolute, bodies: [k, c2], at: [100+40*cos(t), 40*sin(t)]}
  D: {type: revolute, bodies: [g, c2], at: [100, 0]}
  E: {type: revolute, bodies: [k, e], at: [30+40*cos(t), 40*sin(t)]}
  G: {type: revolute, bodies: [e, c3], at: [160+40*cos(t), 40*sin(t)]}
  F: {type: revolute, bodies: [g, c3], at: [160, 0]}
actuators: {m: {coupling: F}}
motion: {drive: m, to: %s deg, steps: %s, report: [position]}
"""

    def test_that_leave_the_determinant_its_sign_are_found(self) -> None:
        """Both circuits of three parallel cranks are in line at once, and neither moves alone."""
        for to in (360, 240, 320.0005, -360):
            expected = [place for place in ((120, 300) if to > 0 else (-60, -240))
                        if abs(place) < abs(to)]
            for steps in (1, 2, 3, 5, 7, 11, 36, 50, 100, 360):
                text = self.THREE_CRANKS % (to, steps)
                motion = run(text)
                what = f"to {to} in {steps}"
                places = motion.events("singular")
                self.assertEqual(len(places), len(expected), f"{what}: {places}")
                for place, one in zip(places, expected):
                    self.close(place, one, 1e-6, what)
                self.assertIn("W0503", findings(text), what)
                for crank, other in zip(motion["m/drive"], motion["A.wz/position"]):
                    self.close(other, crank, 1e-6, f"{what}: at {crank}")

    FOUR_BAR = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [k2, k3, k4]
parameters: {a: 50 mm - %s mm, b: 100 mm, c: 50 mm, d: 100 mm, t2: 60 deg, px: a*cos(t2),
  py: a*sin(t2), L: "hypot(d-px, py)", xx: (b^2-c^2+L^2)/(2*L), hh: sqrt(b^2-xx^2),
  ux: (d-px)/L, uy: -py/L}
couplings:
  A: {type: revolute, bodies: [g, k2], at: [0, 0]}
  B: {type: revolute, bodies: [k2, k3], at: [px, py]}
  C: {type: revolute, bodies: [k3, k4], at: [px+xx*ux-hh*uy, py+xx*uy+hh*ux]}
  D: {type: revolute, bodies: [g, k4], at: [d, 0]}
actuators: {m: {coupling: A}}
motion: {drive: m, to: 360 deg, steps: %s, report: [D.wz]}
"""

    def test_are_not_taken_where_branches_miss_each_other(self) -> None:
        """Shorter by a hair, the crank of a parallelogram makes a rocker of the other link."""
        for short in (1e-3, 1e-5, 1e-7, 1e-8, 1e-9):
            a, b, c, d = 50 - short, 100.0, 50.0, 100.0
            # Where crank and coupler are in line, folded and stretched: cos x = 1 - 2 sin(x/2)^2.
            folded = 2 * math.asin(math.sqrt((c ** 2 - (d - (b - a)) ** 2) / (4 * d * (b - a))))
            stretched = 2 * math.asin(math.sqrt((c ** 2 - (b + a - d) ** 2) / (4 * d * (b + a))))
            expected = [120 + math.degrees(folded), 300 + math.degrees(stretched)]
            for steps in (1, 7, 36):
                motion = run(self.FOUR_BAR % (repr(short), steps))
                what = f"{short} mm in {steps}"
                self.assertEqual(motion.events("singular"), [], what)
                places = motion.events("dead_point", "D.wz")
                self.assertEqual(len(places), 2, what)
                stated = [event["uncertainty"] for event in motion.report["events"]]
                for place, one, uncertainty in zip(places, expected, stated):
                    self.close(place, one, uncertainty + 1e-7, what)
                    self.assertLessEqual(uncertainty, 1e-6 if short >= 1e-7 else 0.01, what)
                for crank, rocker in zip(motion["m/drive"], motion["D.wz/position"]):
                    pin = a * cmath.exp(1j * math.radians(60 + crank))
                    joint = dyad(pin, d, b, c, (0, d, 1j))
                    drawn = dyad(a * cmath.exp(1j * math.pi / 3), d, b, c, (0, d, 1j))
                    turned = math.degrees(cmath.phase((joint - d) / (drawn - d)))
                    self.close((rocker - turned + 180) % 360 - 180, 0.0, 1e-4, f"{what}: {crank}")


class DrawingsThatDoNotFit(MotionTest):
    """Three parallel cranks move only if all are of one length."""

    TEXT = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: g
bodies: [c1, c2, c3, bar]
couplings:
  a1: {type: revolute, bodies: [g, c1], at: [0, 0]}
  a2: {type: revolute, bodies: [g, c2], at: [100, 0]}
  a3: {type: revolute, bodies: [g, c3], at: [200, 0]}
  b1: {type: revolute, bodies: [c1, bar], at: [30, 40]}
  b2: {type: revolute, bodies: [c2, bar], at: [130, 40]}
  b3: {type: revolute, bodies: [c3, bar], at: [230, %s]}
actuators: {m: {coupling: a1}}
cases: {c: {motion: {m: 1 rad/s}}}
motion: {drive: m, to: 60 deg, steps: 6, case: c, report: [position, velocity]}
"""

    def test_are_told_with_what_they_miss(self) -> None:
        for third, fits in (("40", True), ("40.01", False), ("40.0000001", False)):
            text = self.TEXT % third
            worst = run(text).report["closure"]["largest"]
            self.assertEqual(worst <= 1e-13, fits, third)
            self.assertEqual("W0510" in findings(text), not fits, third)

    def test_move_all_the_same_with_axes_of_six_decimals(self) -> None:
        exact = in_library("spatial/bennett.yaml").read_text(encoding="utf-8")
        rough = exact.replace("[-3, 1, 3]", "[-3.000001, 1, 3.000001]")
        self.assertNotEqual(exact, rough)
        self.assertNotIn("W0510", findings(exact))
        self.assertIn("W0510", findings(rough))
        self.assertEqual(run(rough).report["status"], "complete")


if __name__ == "__main__":
    motion_case.main()
