#!/usr/bin/env python3
"""Cables with inertia: motions and simulations against Newton's law for each body.

Usage: cable_dynamics_test.py KINESTAT
"""

from __future__ import annotations

import sys
import unittest

import program

G = 9.81

TACKLE = """
kinestat: 1
space: planar
ground: beam
bodies: {hand: {mass: 5, centre_of_mass: [0.05, 0]}, block: {mass: 100, centre_of_mass: [0.3, 0]},
         s1: {inertia: 0.01}, s2: {inertia: 0.01}, s3: {inertia: 0.01}, s4: {inertia: 0.01}}
gravity: [0, -9.81]
couplings:
  H: {type: prismatic, bodies: [beam, hand], at: [0.05, 0], axis: y}
  L: {type: prismatic, bodies: [beam, block], at: [0.3, 0], axis: y}
  B1: {type: revolute, bodies: [beam, s1], at: [0.1, 5]}
  B2: {type: revolute, bodies: [block, s2], at: [0.2, 0]}
  B3: {type: revolute, bodies: [beam, s3], at: [0.3, 5]}
  B4: {type: revolute, bodies: [block, s4], at: [0.4, 0]}
cables:
  rope:
    over:
      - {body: hand, at: [0.05, 0]}
      - {pulley: s1, radius: 0.05, wrap: clockwise}
      - {pulley: s2, radius: 0.05, wrap: counterclockwise}
      - {pulley: s3, radius: 0.05, wrap: clockwise}
      - {pulley: s4, radius: 0.05, wrap: counterclockwise}
      - {body: beam, at: [0.45, 5]}
actuators: {hand: {coupling: H}}
"""


class Tackle:
    """Four falls: the rope passes sheave i at (5 - i)/4 of the speed of the hand."""

    mass, block, inertia, radius = 5.0, 100.0, 0.01, 0.05

    def __init__(self, down: float) -> None:
        """How fast the hand speeds up downwards."""
        spins = [down * (4 - i) / 4 / self.radius for i in range(4)]
        steps = [self.inertia * spin / self.radius for spin in spins]
        self.last = (self.block * (G + down / 4) -
                     sum(i * steps[i] for i in range(1, 4))) / 4
        self.tensions = [self.last + sum(steps[i:]) for i in range(5)]
        falls = zip((-0.15, -0.05, 0.05, 0.15), self.tensions[1:])
        self.guide = -sum(x * t for x, t in falls) - self.inertia * (spins[1] + spins[3])
        self.force = self.tensions[0] - self.mass * (G - down)

    @classmethod
    def of_force(cls, force: float) -> Tackle:
        """Pulled down by that force, which is linear in the acceleration."""
        rest = cls(0.0).force
        return cls((force - rest) / (cls(1.0).force - rest))


class MotionTest(unittest.TestCase):
    def test_inertia_counts_in_every_row_however_far_the_sheaves_have_turned(self) -> None:
        """Bounds of their spins once swamped couples of inertia, which were left out."""
        report = program.run("motion", "-", text=TACKLE + """
cases: {pull: {motion: {hand: -1}, acceleration: {hand: -14}}}
motion: {drive: hand, to: -12, steps: 12, case: pull, report: [position, action]}
""")["motion"]
        columns = [f"{one['element']}/{one['quantity']}" for one in report["columns"]]
        expected = Tackle(14.0)
        for row in report["rows"]:
            at = dict(zip(columns, row))
            for i, tension in enumerate(expected.tensions):
                self.assertAlmostEqual(at[f"rope_{i + 1}.F/action"], tension, delta=1e-9 * 1000)
            self.assertAlmostEqual(at["L.Tz/action"], expected.guide, delta=1e-9 * 1000)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
