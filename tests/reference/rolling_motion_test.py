#!/usr/bin/env python3
"""Checks motions of cams, gears and ropes against closed forms.

Usage: rolling_motion_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import cmath
import math

import motion_case
import program
from motion_case import MotionTest, derivative, dyad, in_library, run, turned


def findings(text: str) -> str:
    return program.call("motion", "-", text=text).stderr


def orders_of(couplings: list[str]) -> list[str]:
    """Each coupling as the first of the file, the others behind it as they are and reversed."""
    turned_lists = [couplings[i:] + couplings[:i] for i in range(len(couplings))]
    return ["".join(f"  {line}\n" for line in order)
            for one in turned_lists for order in (one, one[::-1])]


class Cams(MotionTest):
    def test_lift_as_the_disc_turns(self) -> None:
        motion = run(in_library("planar/cam_and_follower.yaml"))
        self.check_complete(motion, motion.report["steps"])

        def lift(angle: float) -> float:
            e = turned(9 + 12j, angle)
            return e.imag + math.sqrt(41.0 ** 2 - e.real ** 2) - 52.0
        speed = 20 * math.pi
        self.check(motion, "g.vy/position", lift, 1e-10)
        self.check(motion, "g.vy/velocity",
                   lambda t: speed * derivative(lift, t, 1).real, 1e-4)
        self.check(motion, "g.vy/acceleration",
                   lambda t: speed ** 2 * derivative(lift, t, 2).real, 1e-1)
        for step, angle in enumerate(motion["motor/drive"]):
            e = turned(9 + 12j, angle)
            slope = math.asin(abs(e.real) / 41)
            self.close(motion["valve_spring/transmission_angle"][step], math.pi / 2 - slope, 1e-9,
                       "pressure angle")
            self.close(motion["c.R/action"][step], 200 / math.cos(slope), 1e-8, "contact force")


class Gears(MotionTest):
    def test_may_be_driven_on_both_sides(self) -> None:
        """Where no joint is left to follow."""
        text = """kinestat: 1
space: planar
ground: frame
bodies: [p, q]
couplings:
  a: {type: revolute, bodies: [frame, p], at: [0, 0]}
  b: {type: revolute, bodies: [frame, q], at: [3, 0]}
  g: {type: gear, bodies: [p, q], at: [1, 0], tangent: y, pressure_angle: 20 deg}
actuators: {m: {coupling: a}, n: {coupling: b}}
motion: {drives: [{drive: m, to: 90 deg}, {drive: n, to: %s deg}], steps: 3, report: [a.wz, b.wz]}
"""
        motion = run(text % -45)
        self.check_complete(motion, 3)
        for step, angle in enumerate(motion["m/drive"]):
            self.close(angle, step * math.pi / 6, 1e-13, "first wheel")
            self.close(motion["b.wz/position"][step], -angle / 2, 1e-13, "second wheel")
        self.assertEqual(run(text % -44, status=5).report["status"], "locked")

    def test_of_a_five_bar_turn_in_any_order_of_the_couplings(self) -> None:
        """Wheels of radii 40 and 60 turn the two cranks; some orders leave a crank out of the tree."""
        couplings = [
            "a: {type: revolute, bodies: [frame, l1], at: [0, 0]}",
            "b: {type: revolute, bodies: [l1, l2], at: [10, 40]}",
            "c: {type: revolute, bodies: [l2, l3], at: [70, 120]}",
            "d: {type: revolute, bodies: [l3, l4], at: [125, 45]}",
            "e: {type: revolute, bodies: [frame, l4], at: [100, 0]}",
            "m: {type: gear, bodies: [l1, l4], at: [40, 0], tangent: y, pressure_angle: 20 deg}"]

        def elbow(angle: float) -> complex:
            b = turned(10 + 40j, angle)
            d = 100 + turned(25 + 45j, -angle / 1.5)
            return dyad(b, d, abs(60 + 80j), abs(55 - 75j), (10 + 40j, 125 + 45j, 70 + 120j))
        for order in orders_of(couplings):
            motion = run("kinestat: 1\nspace: planar\nunits: {length: mm}\nground: frame\n"
                         "bodies: [l1, l2, l3, l4]\ncouplings:\n" + order +
                         "actuators: {motor: {coupling: a}}\n"
                         "motion: {drive: motor, to: 1 rad, steps: 4,\n"
                         "         trace: [{body: l3, at: [70, 120], name: P}], report: [position]}\n")
            self.check_complete(motion, 4)
            self.check(motion, "P/at/x", lambda t: elbow(t).real, 1e-9)
            self.check(motion, "P/at/y", lambda t: elbow(t).imag, 1e-9)

    def test_on_both_ends_of_a_coupler_turn_in_any_order_of_the_couplings(self) -> None:
        """A wheel of radius 20 about each end of the coupler of a four-bar, and wheels about the
        fixed pivots: in the crank and in the rocker each pair turns as 20 to the rest of the arm."""
        couplings = [
            "a: {type: revolute, bodies: [frame, crank], at: [0, 0]}",
            "b: {type: revolute, bodies: [crank, coupler], at: [0, 50]}",
            "c: {type: revolute, bodies: [coupler, rocker], at: [120, 100]}",
            "d: {type: revolute, bodies: [frame, rocker], at: [120, 0]}",
            "o: {type: revolute, bodies: [frame, near], at: [0, 0]}",
            "p: {type: revolute, bodies: [frame, far], at: [120, 0]}",
            "m: {type: gear, bodies: [coupler, near], at: [0, 30], tangent: x, pressure_angle: 20 deg}",
            "n: {type: gear, bodies: [coupler, far], at: [120, 80], tangent: x, pressure_angle: 20 deg}"]

        def turns(angle: float) -> tuple[float, float]:
            b = turned(50j, angle)
            c = dyad(b, 120, abs(120 + 50j), 100, (50j, 120, 120 + 100j))
            coupler = cmath.phase((c - b) / (120 + 50j))
            rocker = cmath.phase((c - 120) / 100j)
            return (angle - (coupler - angle) * 20 / 30, rocker - (coupler - rocker) * 20 / 80)
        for order in orders_of(couplings):
            motion = run("kinestat: 1\nspace: planar\nunits: {length: mm}\nground: frame\n"
                         "bodies: [crank, coupler, rocker, near, far]\ncouplings:\n" + order +
                         "actuators: {motor: {coupling: a}}\n"
                         "motion: {drive: motor, to: 360 deg, steps: 8, report: [o.wz, p.wz]}\n")
            self.check_complete(motion, 8)
            self.check(motion, "o.wz/position", lambda t: turns(t)[0], 1e-9)
            self.check(motion, "p.wz/position", lambda t: turns(t)[1], 1e-9)

    def test_between_racks_roll_in_any_order_of_the_couplings(self) -> None:
        """A pinion on a slider between a fixed rack and a sliding one, which moves twice as far."""
        couplings = [
            "a: {type: revolute, bodies: [frame, crank], at: [0, 0]}",
            "b: {type: revolute, bodies: [crank, rod], at: [30, 40]}",
            "c: {type: revolute, bodies: [rod, slider], at: [150, 60]}",
            "s: {type: prismatic, bodies: [frame, slider], at: [150, 60], axis: x}",
            "r: {type: prismatic, bodies: [frame, ram], at: [150, 80], axis: x}",
            "p: {type: revolute, bodies: [slider, pinion], at: [150, 60]}",
            "k: {type: rack, bodies: [pinion, frame], at: [150, 40], line_of_action: [1, 0]}",
            "l: {type: rack, bodies: [pinion, ram], at: [150, 80], line_of_action: [1, 0]}"]

        def stroke(angle: float) -> float:
            b = turned(30 + 40j, angle)
            return b.real + math.sqrt(120 ** 2 + 20 ** 2 - (60 - b.imag) ** 2) - 150
        for order in orders_of(couplings):
            motion = run("kinestat: 1\nspace: planar\nunits: {length: mm}\nground: frame\n"
                         "bodies: [crank, rod, slider, ram, pinion]\ncouplings:\n" + order +
                         "actuators: {motor: {coupling: a}}\n"
                         "motion: {drive: motor, to: 360 deg, steps: 8, report: [r.vx, p.wz]}\n")
            self.check_complete(motion, 8)
            self.check(motion, "r.vx/position", lambda t: 2 * stroke(t), 1e-9)
            self.check(motion, "p.wz/position", lambda t: -stroke(t) / 20, 1e-9)


class Cables(MotionTest):
    def test_of_a_tackle_share_the_travel_of_the_hand(self) -> None:
        motion = run(in_library("cables/block_and_tackle.yaml"))
        self.check_complete(motion, motion.report["steps"])
        for step, hand in enumerate(motion["hand/drive"]):
            self.close(motion["L.vy/position"][step], -hand / 4, 1e-9, "block")
            # The cable runs over the sheave, which does not slip.
            self.close(motion["B1.wz/position"][step], -hand / 50, 1e-9, "first sheave")

    CAPSTAN = """kinestat: 1
space: planar
units: {{length: mm, angle: deg}}
ground: drum
bodies: [load, arm]
couplings:
  L: {{type: prismatic, bodies: [drum, load], at: [-100, -2000], axis: y}}
  A: {{type: revolute, bodies: [drum, arm], at: [0, 0]}}
cables:
  rope:
    over:
      - {{body: load, at: [-100, -2000]}}
      - {{pulley: drum, at: [0, 0], radius: 100, wrap: clockwise, slip: true, friction: 0.15{turns}}}
      - {{body: arm, at: [100, -500]}}
actuators: {{weight: {{coupling: L}}, crank: {{coupling: A}}}}
cases:
  hoist: {{motion: {{crank: -1 rad/s}}, action: {{weight: -1000 N}}, input: crank, output: weight}}
motion: {{drive: crank, to: -{to}, steps: {steps}, case: hoist,
          report: [weight, crank, L.vy, mechanical_advantage]}}
"""

    def test_of_a_capstan_hold_by_every_turn_that_an_arm_winds_on(self) -> None:
        """Half a turn as drawn and as much more as the arm turns: T2 = T1 exp(mu theta)."""
        for turns, more in (("", 0), (", turns: 2", 4 * math.pi)):
            motion = run(self.CAPSTAN.format(to=900, steps=20, turns=turns))
            self.check_complete(motion, 20)
            for step, degrees in enumerate(motion["crank/drive"]):
                angle = math.radians(degrees)
                theta = math.pi + more - angle
                torque = 100 * math.exp(0.15 * theta)  # 1000 N at 0.1 m
                self.close(motion["L.vy/position"][step], -100 * angle, 1e-9, "lift")
                self.close(motion["crank/action"][step], -torque, 1e-11 * torque, f"at {angle}")
                self.close(motion["weight/mechanical_advantage"][step] * torque, 1000,
                           1e-8, "advantage")

    def test_that_wind_over_themselves_on_the_way_are_told(self) -> None:
        """The tangents at -100 and at the arm meet at 100 tan(theta/2) below the ends of the arc."""
        text = self.CAPSTAN.format(to=80, steps=8, turns="")
        said = findings(text)
        self.assertIn("warning[W0308]: cable 'rope' turns by 260 deg about pulley 'drum' and "
                      "crosses itself (crank from -", said)
        # The shorter segment is 500 long: from 180 deg on they meet where 100 |tan| < 500.
        # Eight steps are divided into three parts each, which tell the range more closely.
        onset = math.degrees(2 * (math.pi - math.atan(5))) - 180
        first = 10 * math.ceil(onset / 10)
        part = 10 / 3 * math.ceil(onset / (10 / 3))
        self.assertIn(f"crank from {-part:.6g} to -80 deg, {(80 - first) // 10 + 1} of 9 "
                      "positions, the worst at -80", said)
        self.assertNotIn("W0308", findings(self.CAPSTAN.format(to=80, steps=8, turns=", turns: 0")))

    def test_turn_at_both_ends_as_the_line_between_two_cranks_does(self) -> None:
        """A cable from (1, 3) on a crank about (0, 0) to (6, 5) on a rocker about (7, 0)."""
        motion = run("""kinestat: 1
space: planar
ground: frame
bodies: [crank, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  c: {type: cable, bodies: [crank, rocker], from: [1, 3], to: [6, 5]}
  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}
actuators: {motor: {coupling: a}}
cases: {turning: {motion: {motor: 2 rad/s}}}
motion: {drive: motor, to: 1 rad, steps: 10, case: turning, report: [velocity]}
""")
        self.check_complete(motion, 10)

        def line(angle: float) -> complex:
            b = turned(1 + 3j, angle)
            return dyad(b, 7, abs(5 + 2j), abs(1 - 5j), (1 + 3j, 7, 6 + 5j)) - b

        def rocker(angle: float) -> float:
            return cmath.phase((turned(1 + 3j, angle) + line(angle) - 7) / (-1 + 5j))
        for step, angle in enumerate(motion["motor/drive"]):
            turn = 2 * derivative(lambda t: cmath.phase(line(t)), angle, 1).real
            self.close(motion["c.w1/velocity"][step], turn - 2, 1e-8, f"at the crank at {angle}")
            self.close(motion["c.w2/velocity"][step], 2 * derivative(rocker, angle, 1).real - turn,
                       1e-8, f"at the rocker at {angle}")


if __name__ == "__main__":
    motion_case.main()
