#!/usr/bin/env python3
"""Zero-length springs whose points meet: no length, no force, and no need of a direction.

Usage: zero_length_spring_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest

import motion_case
import program
from dynamics_case import DynamicsCase
from simulation_test import Simulation

SLIDE = """kinestat: 1
space: planar
parameters: {k: 300 N/m, p: 0.1 m}
ground: frame
bodies: {block: {mass: 2, centre_of_mass: [0.3, 0], inertia: 0.1}}
couplings: {g: {type: prismatic, bodies: [frame, block], at: [0.3, 0], axis: x}}
springs: {band: {bodies: [frame, block], at: {frame: [p, 0], block: [0.1, 0]},
                 stiffness: k, free_length: 0EXTRA}}
actuators: {hand: {coupling: g}}
"""
CASE = "cases: {slow: {motion: {hand: SPEED}, action: {}}}\n"
MOTION = "motion: {drive: hand, from: -0.2, to: 0.2, steps: 8, case: slow, report: [action, spring.band]}\n"


def slide(extra: str = "", speed: str = "0") -> str:
    return SLIDE.replace("EXTRA", extra) + CASE.replace("SPEED", speed)


class ZeroLengthSpringTest(DynamicsCase):
    def test_drawn_where_its_points_meet(self) -> None:
        case = program.run("analyze", "-", text=slide())["cases"]["slow"]
        self.assertEqual(case["statics"]["actions"]["hand"], 0.0)
        self.assertEqual(case["springs"]["band"], {"length": 0.0, "force": 0.0})

    def test_moved_through_its_anchor(self) -> None:
        """The force is k x on both sides and zero between: every row is solved."""
        for extra, sign in (("", 1.0), (", acts: pull", 1.0), (", acts: push", 0.0)):
            found = motion_case.run(slide(extra, "0.5") + MOTION)
            for x, force, length in zip(found["hand/drive"], found["hand/action"],
                                        found["spring.band/length"]):
                self.near(force, sign * 300 * x, 60, f"at {x}")
                self.near(length, abs(x), 0.2, f"at {x}")

    def test_slopes_where_its_points_meet(self) -> None:
        """F = k (x - p) of the hand: no slope by k, -k by the place of the anchor."""
        found = program.run("sensitivity", "-", "--of", "hand", text=slide())
        by = found["cases"]["slow"]["sensitivity"]["hand"]["by"]
        self.near(by["p"]["derivative"], -300.0, 300, "by p")
        self.near(by["k"]["derivative"], 0.0, 1, "by k")

    def test_sets_out_from_its_anchor(self) -> None:
        """x = v/w sin wt, w^2 = k/m."""
        text = SLIDE.replace("EXTRA", "") + """simulation: {action: {hand: 0}, start: {hand: {speed: 3}},
             time: 1 s, steps: 20, tolerance: 1e-11}
"""
        found = Simulation(text)
        w = math.sqrt(150.0)
        for time, x in zip(found.columns["time"], found.columns["g.vx/position"]):
            self.assertLess(abs(x - 3 / w * math.sin(w * time)), 1e-8)

    def test_force_without_length_needs_a_direction(self) -> None:
        """Of a free length, of a force beside it, and of a damper whose ends part."""
        for extra, speed in ((", free_length: 0.05", "0"), (", force: 2 N", "0"),
                             (", damping: 5 N*s/m", "0.5")):
            text = slide(extra, speed).replace("free_length: 0, free", "free")
            done = program.call("analyze", "-", text=text)
            self.assertEqual(done.returncode, 5, extra)
            self.assertIn("E0324", done.stderr)
            self.assertIn("its two points meet", done.stderr)
        at_rest = program.call("analyze", "-", text=slide(", damping: 5 N*s/m", "0"))
        self.assertEqual(at_rest.returncode, 0, at_rest.stderr)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
