#!/usr/bin/env python3
"""Checks what slides in contacts that move, and what acts along it, against closed forms.

Usage: contact_motion_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math

import motion_case
import program
from motion_case import MotionTest, run


class FlatFollowers(MotionTest):
    """An eccentric of 31 mm, 12 mm off its axis, under a flat follower."""

    TEXT = """\
kinestat: 1
space: planar
units: {length: %s}
ground: frame
bodies: [cam, follower]
couplings:
  a: {type: revolute, bodies: [frame, cam], at: [0, 0]}
  c: {type: cam, bodies: [cam, follower], at: [12 mm, 31 mm], normal: y, radii: [31 mm, flat]}
  g: {type: prismatic, bodies: [frame, follower], at: [0, 70 mm], axis: y}
actuators: {shaft: {coupling: a}, spring: {coupling: g}, slip: {coupling: c, freedom: vx}}
cases: {lifting: {motion: {shaft: 1 rad/s}, action: {spring: -40 N, slip: 2 N}}}
motion: {drive: shaft, to: 360 deg, steps: %d, case: lifting, report: [velocity, action, power]}
"""

    def test_slide_as_fast_as_the_cam_is_high_whatever_the_size_and_the_unit(self) -> None:
        for unit, scale in (("mm", 1.0), ("m", 1e-3)):
            for top in (70, 99, 700):
                motion = run((self.TEXT % (unit, 8)).replace("70 mm", f"{top} mm"))
                for turn, slides in zip(motion["shaft/drive"], motion["c.vx/velocity"]):
                    self.close(slides, scale * (31 + 12 * math.sin(turn)), 1e-9 * scale,
                               f"{unit}, {top}, {turn}")

    def test_need_the_torque_of_the_virtual_power(self) -> None:
        """T w = 40 N v - 2 N u, with v = 12 mm w cos and u = (31 mm + 12 mm sin) w."""
        motion = run(self.TEXT % ("mm", 8))
        for turn, torque, power in zip(motion["shaft/drive"], motion["shaft/action"],
                                       motion["slip/power"]):
            slides = 0.031 + 0.012 * math.sin(turn)
            self.close(torque, 40 * 0.012 * math.cos(turn) - 2 * slides, 1e-12, f"{turn}")
            self.close(power, 2 * slides, 1e-12, f"{turn}")

    def test_may_be_given_the_speed_at_which_they_slide(self) -> None:
        text = self.TEXT % ("mm", 4)
        text = text.replace("{shaft: 1 rad/s}", "{slip: 62 mm/s}").replace("slip: 2 N", "")
        text = text.replace("[velocity, action, power]", "velocity")
        motion = run(text)
        for turn, speed in zip(motion["shaft/drive"], motion["a.wz/velocity"]):
            self.close(speed, 62 / (31 + 12 * math.sin(turn)), 1e-9, f"{turn}")


class Directions(MotionTest):
    """A contact has its freedoms along the axes of their names, in 'motion' as in 'analyze'."""

    PLANE = """\
kinestat: 1
space: planar
units: {length: mm}
ground: f
bodies: [cam, fol]
couplings:
  a: {type: revolute, bodies: [f, cam], at: [0, 0]}
  c: {type: cam, bodies: %s, at: %s, normal: %s, radii: %s}
  g: {type: prismatic, bodies: [f, fol], at: [0, 70], axis: %s}
actuators: {m: {coupling: a}, s: {coupling: g}, t: {coupling: c, freedom: v%s}}
cases: {c: {motion: {m: 2}, action: {s: -40, t: 3}}}
motion: {drive: m, to: 1e-7, steps: 1, case: c, report: [velocity, action, power]}
"""
    SPACE = """\
kinestat: 1
units: {length: mm}
ground: f
bodies: [cam, fol]
couplings:
  a: {type: revolute, bodies: [f, cam], at: [0, 0, 0], axis: %s}
  c: {type: %s, bodies: [cam, fol], at: %s, normal: %s%s, radii: [31, flat]}
  g: {type: prismatic, bodies: [f, fol], at: [70, 60, 50], axis: %s}
actuators: {m: {coupling: a}, s: {coupling: g}, t: {coupling: c, freedom: v%s}}
cases: {c: {motion: {m: 2}, action: {s: -40, t: 3}}}
motion: {drive: m, to: 1e-7, steps: 1, case: c, report: [velocity, action, power]}
"""

    def agree(self, text: str) -> int:
        motion = run(text)
        case = program.run("analyze", "-", text=text)["cases"]["c"]
        values = [(name, "velocity", value)
                  for name, value in case["kinematics"]["freedoms"].items()]
        values += [(name, "action", value) for name, value in case["statics"]["actions"].items()]
        known = 0
        for name, quantity, value in values:
            column = f"{name}/{quantity}"
            if value is None or column not in motion.names:
                continue
            known += 1
            self.close(motion[column][0], value, 1e-6 * max(1.0, abs(value)), f"{column}\n{text}")
        return known

    def test_in_the_plane_are_those_of_analysis(self) -> None:
        for axis, other, at in (("x", "y", "[%d, 12]"), ("y", "x", "[12, %d]")):
            for side in (1, -1):
                sign, against = ("", "-") if side > 0 else ("-", "")
                for normal, bodies, radii in ((sign + axis, "[cam, fol]", "[31, flat]"),
                                              (against + axis, "[fol, cam]", "[flat, 31]")):
                    text = self.PLANE % (bodies, at % (31 * side), normal, radii, axis, other)
                    self.assertGreater(self.agree(text), 5)

    def test_in_space_are_those_of_analysis(self) -> None:
        axes = "xyz"
        for n, normal in enumerate(axes):
            line, turns = axes[(n + 1) % 3], axes[(n + 2) % 3]
            at = [0.0, 0.0, 0.0]
            at[n], at[(n + 1) % 3] = 31.0, 12.0
            for kind in ("cam", "point_contact", "line_contact"):
                for slides in (line, turns):
                    along = f", line: {turns}" if kind == "line_contact" else ""
                    text = self.SPACE % (turns, kind, at, normal, along, normal, slides)
                    self.assertGreater(self.agree(text), 5)


if __name__ == "__main__":
    motion_case.main()
