#!/usr/bin/env python3
"""Checks motions of spatial linkages against closed forms.

Usage: spatial_motion_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math
import re

import motion_case
import program
from motion_case import CLOSURE, DEAD_POINT, MotionTest, derivative, in_library, run, turned


class SpatialLinkages(MotionTest):
    @staticmethod
    def rod(crank: float) -> tuple[float, float, float]:
        """p, q, s of the rod's length p cos(t) + q sin(t) = s, the rocker turned by t about y."""
        b = turned(40 + 20j, crank)
        k = (120 - b.real, 20 - b.imag, 40.0)  # from the crank's ball to the rocker's bearing
        r = (-20, 60, 20)                      # from there to its own ball, as drawn
        fixed = sum(x * x for x in k) + sum(x * x for x in r) + 2 * k[1] * r[1]
        return 2 * (k[0] * r[0] + k[2] * r[2]), 2 * (k[0] * r[2] - k[2] * r[0]), 10800 - fixed

    @classmethod
    def rocker(cls, crank: float) -> float:
        """Its turn from the drawn position, on the branch on which that is none for no turn."""
        def on(branch: float, angle: float) -> float:
            p, q, s = cls.rod(angle)
            half = math.acos(max(-1.0, min(1.0, s / math.hypot(p, q))))
            return math.remainder(math.atan2(q, p) + branch * half, 2 * math.pi)
        return on(1.0 if abs(on(1.0, 0.0)) < abs(on(-1.0, 0.0)) else -1.0, crank)

    def test_rssr_keeps_the_length_of_its_rod(self) -> None:
        self.assertLess(abs(self.rocker(0.0)), 1e-12)
        motion = run(in_library("spatial/rssr.yaml"))
        self.check_complete(motion, motion.report["steps"])
        for step, angle in enumerate(motion["motor/drive"]):
            self.close(motion["d.wy/position"][step], self.rocker(angle), 1e-12, f"at {angle}")
            self.close(motion["d.wy/velocity"][step],
                       10 * derivative(self.rocker, angle, 1, 0.01).real, 1e-6, "velocity")
            self.close(motion["d.wy/acceleration"][step],
                       100 * derivative(self.rocker, angle, 2, 0.01).real, 1e-3, "acceleration")

    def test_rssr_spins_its_rod_as_the_case_says(self) -> None:
        """b.wx = 0: the rod's ends and its turn about x determine the other two, as analyze does."""
        motion = run(in_library("spatial/rssr.yaml"), "--from", "0", "--to", "10 deg", "--steps",
                     "2", "--report", "velocity", "--report", "acceleration")
        for step, angle in enumerate(motion["motor/drive"]):
            y, z = (10 * self.rod_turn(angle)[i] for i in (0, 1))
            self.close(motion["b.wx/velocity"][step], 0.0, 1e-12, "b.wx")
            self.close(motion["rod/angular_acceleration/x"][step], 0.0, 1e-9, "change of b.wx")
            self.close(motion["b.wy/velocity"][step], y, 1e-8, "b.wy")
            self.close(motion["b.wz/velocity"][step], z - 10, 1e-8, "b.wz")
            for i, axis in enumerate("yz"):
                bend = 100 * derivative(lambda t: self.rod_turn(t)[i], angle, 1, 0.01).real
                self.close(motion[f"rod/angular_acceleration/{axis}"][step], bend, 1e-4, axis)
        self.close(motion["b.wy/velocity"][0], -5 / 3, 1e-12, "b.wy as drawn")
        self.close(motion["b.wz/velocity"][0], -50 / 3, 1e-12, "b.wz as drawn")

    @classmethod
    def rod_turn(cls, crank: float) -> tuple[float, float]:
        """wy, wz for each radian of the crank, wx being 0: w x (c - b) is vc - vb."""
        turn, rate = cls.rocker(crank), derivative(cls.rocker, crank, 1, 0.01).real
        b = turned(40 + 20j, crank)
        arm = turned(-20 - 20j, turn)  # x - iz: a turn about y
        x, z = arm.real, -arm.imag
        rod = (120 + x - b.real, 80 - b.imag, 40 + z)
        speed = (rate * z + b.imag, -b.real, -rate * x)
        return -speed[2] / rod[0], speed[1] / rod[0]

    def test_rssr_takes_its_speed_from_the_output_and_none_from_the_spin(self) -> None:
        text = in_library("spatial/rssr.yaml").read_text(encoding="utf-8")
        given = re.search(r"motion: ({motor: [^}]*})", text)
        assert given

        def speeds(known: str, name: str, status: int = 0) -> list[float]:
            return run(text.replace(given[1], known), "--to", "60 deg", "--steps", "3",
                       "--report", "velocity", status=status)[f"{name}/velocity"]
        alone = speeds("{work: 5 rad/s, b.wx: 0}", "a.wz")
        for speed, other in zip(speeds("{work: 5 rad/s, b.wx: 3 rad/s}", "a.wz"), alone):
            self.close(speed, other, 1e-9 * abs(other), "crank")
        for speed in speeds("{work: 5 rad/s, b.wx: 3 rad/s}", "d.wy"):
            self.close(speed, 5.0, 1e-9, "output")
        self.assertEqual(set(speeds("{b.wx: 3 rad/s}", "a.wz", 3)), {None})
        self.assertEqual(set(speeds("{motor: 10 rad/s, work: 99 rad/s}", "a.wz", 3)), {None})

    def test_what_spins_by_itself_has_no_position(self) -> None:
        """The slipper of a pump may turn on its plate, which nothing drives."""
        for steps in (4, 24, 50):
            motion = run(in_library("spatial/swash_plate_pump.yaml"), "--drive", "motor", "--to",
                         "360 deg", "--steps", str(steps))
            for name in ("plate.w/position", "bore.wz/position"):
                self.assertEqual(set(motion[name]), {None}, name)

    def test_a_rod_between_two_balls_is_known_but_for_its_spin(self) -> None:
        for steps in (1, 18, 50):
            motion = run(in_library("spatial/rssr.yaml"), "--to", "1 rad", "--steps", str(steps),
                         "--report", "position")
            for axis in "xyz":
                self.assertEqual(set(motion[f"rod/rotation/{axis}"]), {None})
            for crank, x, y in zip(motion["motor/drive"], motion["rod/at/x"], motion["rod/at/y"]):
                pin = turned(40 + 20j, crank)
                self.close(x, pin.real, 1e-9, "ball of the crank")
                self.close(y, pin.imag, 1e-9, "ball of the crank")

    def test_what_spins_by_itself_does_so_as_fast_as_a_case_says(self) -> None:
        """Slipper and piston at once: the ball does not turn about z, nor does the piston."""
        motion = run(in_library("spatial/swash_plate_pump.yaml"), "--drive", "motor", "--to",
                     "360 deg", "--steps", "12", "--case", "pumping", "--report", "velocity")
        self.assertEqual(set(motion["status"]), {"solved"})
        for turn, speed in zip(motion["motor/drive"], motion["bore.vz/velocity"]):
            expected = 2000 * math.pi * math.tan(math.radians(18)) * math.sin(
                math.radians(50 + turn))
            self.close(speed, expected, 1e-8, f"at {turn}")

    def test_rssr_stops_where_its_balls_cannot_reach_further(self) -> None:
        for to in (3.0, -3.0):
            motion = run(in_library("spatial/rssr.yaml"), "--from", "0", "--to", f"{to} rad")
            self.close(motion.events("limit")[0], self.limit(math.copysign(1.0, to)), DEAD_POINT,
                       "limit")

    @classmethod
    def limit(cls, sign: float) -> float:
        """Where |s| = hypot(p, q), by bisection."""
        def slack(crank: float) -> float:
            p, q, s = cls.rod(crank)
            return math.hypot(p, q) - abs(s)
        low, high = 0.0, 0.0
        while slack(high) > 0:
            low, high = high, high + sign * 0.01
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (middle, high) if slack(middle) > 0 else (low, middle)
        return low

    def test_bennett_keeps_the_product_of_half_tangents(self) -> None:
        """tan(A/2) tan(B/2) is constant, A and B the angles at neighbouring joints."""
        motion = run(in_library("spatial/bennett.yaml"))
        self.check_complete(motion, motion.report["steps"])
        # The rate of b to that of a is -sin(B)/sin(A), and opposite joints turn equally.
        for step in range(len(motion.rows)):
            self.close(motion["c.w/position"][step], motion["a.w/position"][step], 1e-12,
                       "opposite joints")
        joint = [(40.0, 0.0, 20.0), (20.0, 60.0, -20.0), (-40.0, 0.0, 20.0), (-20.0, -60.0, -20.0)]
        axis = [(-3, 1, 3), (0, 2, 3), (3, -1, 3), (0, -2, 3)]
        start = [self.turn_at(joint, axis, i) for i in (0, 1)]
        constant = math.tan(start[0] / 2) * math.tan(start[1] / 2)
        for step in range(len(motion.rows)):
            first = start[0] + motion["a.w/position"][step]
            second = start[1] + motion["b.w/position"][step]
            # tan(A/2) tan(B/2) = k without the poles of the tangent.
            fault = (math.sin(first / 2) * math.sin(second / 2)
                     - constant * math.cos(first / 2) * math.cos(second / 2))
            self.close(fault, 0.0, 1e-12 * max(1.0, abs(constant)), "product of half tangents")

    @staticmethod
    def turn_at(joint: list, axis: list, i: int) -> float:
        """Angle at joint i from the link before it to the link behind it, about its axis."""
        def minus(a: tuple, b: tuple) -> tuple:
            return tuple(x - y for x, y in zip(a, b))

        def dot(a: tuple, b: tuple) -> float:
            return sum(x * y for x, y in zip(a, b))

        def cross(a: tuple, b: tuple) -> tuple:
            return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
        before = minus(joint[i], joint[i - 1])
        behind = minus(joint[(i + 1) % 4], joint[i])
        size = math.sqrt(dot(axis[i], axis[i]))
        return math.atan2(dot(axis[i], cross(before, behind)) / size, dot(before, behind))

    def test_schatz_linkage_has_the_torque_of_its_motor_everywhere(self) -> None:
        """A redundant linkage leaves bearing forces open, and the power of its shafts does not:
        tan A tan E = 2, A being 45 deg as drawn, and 1 N*m drives the other shaft."""
        motion = run(in_library("spatial/schatz_linkage.yaml"), "--drive", "motor", "--to",
                     "360 deg", "--steps", "200", "--case", "left shaft turns",
                     "--report", "action")
        self.assertEqual(set(motion["status"]), {"indeterminate"})
        for angle, torque in zip(motion["motor/drive"], motion["motor/action"]):
            a = math.pi / 4 + angle
            self.assertIsNotNone(torque, f"at {angle}")
            self.close(torque, 2 / (math.sin(a) ** 2 + 4 * math.cos(a) ** 2), 1e-9, f"at {angle}")

    def test_a_velocity_that_cancels_is_zero(self) -> None:
        """The axes of both joints between frame and right arm meet on the x axis: a turn about any
        line through there moves the origin across x alone."""
        report = program.run("mobility", str(in_library("spatial/schatz_linkage.yaml")))
        arm = report["mobility"]["motions"][0]["bodies"]["right_arm"]
        self.assertEqual(arm["twist"][3], 0.0)
        self.assertEqual(arm["screw"]["pitch"], 0.0)

    def test_bennett_with_rounded_axes_has_the_torque_of_its_motor(self) -> None:
        """It closes by least squares, and the torque is right to that."""
        exact = in_library("spatial/bennett.yaml").read_text(encoding="utf-8")
        case = ("--steps", "60", "--case", "crank turns", "--report", "action")
        right = run(exact, *case)
        for error in (1e-9, 1e-6):
            rough = run(exact.replace("[-3, 1, 3]", f"[-3 + {error}, 1, 3 - {error}]"), *case)
            self.assertGreater(rough.report["closure"]["largest"], 0.01 * error)
            for step, torque in enumerate(right["motor/action"]):
                self.assertIsNotNone(rough["motor/action"][step], f"step {step}")
                self.close(rough["motor/action"][step], torque, 10 * error, f"step {step}")

    def test_platform_has_the_lengths_of_its_legs(self) -> None:
        """The distances of the joints, to the closure of a mechanism of more than 2 m."""
        motion = run(in_library("spatial/ups_platform.yaml"))
        self.check_complete(motion, motion.report["steps"])
        base = [math.radians(x) for x in (10, 110, 130, 230, 250, 350)]
        top = [math.radians(x) for x in (50, 70, 170, 190, 290, 310)]
        big, small, height = 1.2, 0.7, 1.0
        drawn = math.sqrt(big ** 2 + small ** 2 + height ** 2
                          - 2 * big * small * math.cos(math.radians(40)))
        for step in range(len(motion.rows)):
            at = [motion[f"platform/at/{x}"][step] for x in "xyz"]
            rotation = [math.radians(motion[f"platform/rotation/{x}"][step]) for x in "xyz"]
            for leg in range(6):
                drawn_joint = (small * math.cos(top[leg]), small * math.sin(top[leg]), 0.0)
                joint = [a + b for a, b in zip(at, rotated(rotation, drawn_joint))]
                foot = (big * math.cos(base[leg]), big * math.sin(base[leg]), 0.0)
                length = math.dist(joint, foot)
                self.close(length - drawn, motion[f"leg{leg + 1}/drive"][step], 2 * CLOSURE,
                           f"leg {leg + 1} in step {step}")


def rotated(turn: list[float], point: tuple[float, ...]) -> list[float]:
    """By Rodrigues' formula; the vector is the axis times the angle."""
    angle = math.sqrt(sum(x * x for x in turn))
    if angle == 0.0:
        return list(point)
    k = [x / angle for x in turn]
    cross = (k[1] * point[2] - k[2] * point[1], k[2] * point[0] - k[0] * point[2],
             k[0] * point[1] - k[1] * point[0])
    along = sum(x * y for x, y in zip(k, point))
    return [p * math.cos(angle) + c * math.sin(angle) + x * along * (1 - math.cos(angle))
            for p, c, x in zip(point, cross, k)]


if __name__ == "__main__":
    motion_case.main()
