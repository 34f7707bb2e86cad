#!/usr/bin/env python3
"""Friction in the bearings of planetary sets with several equal planets, by closed forms.

Usage: planet_friction_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest

import program

TEXT = """
kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  s: {type: revolute, bodies: [housing, sun]%s}
  r: {type: revolute, bodies: [housing, ring]}
  c: {type: revolute, bodies: [housing, carrier]%s}
  p: {type: revolute, bodies: [carrier, planet]%s}
  B: {type: brake, bodies: [housing, ring]}
gears:
  module: 2 mm
  members:
    sun:    {body: sun, teeth: 30}
    planet: {body: planet, teeth: 21, count: %d}
    ring:   {body: ring, teeth: 72, internal: true}
  meshes:
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
actuators: {in: {coupling: s}, out: {coupling: c}}
%s
"""
CASE = "cases: {run: {motion: {in: 1500 rpm, B.wz: 0}, action: {in: 50}, input: in, output: out%s}}\n"

SUN, PLANET, RING = 0.030, 0.021, 0.072  # pitch radii
TORQUE = 50.0
SPEED = 1500 * math.pi / 30
SPINS = SPEED * (1 - 30 / 102) * 30 / 21  # of a planet in its carrier
FORCE = TORQUE / SUN


def pin_couple(mu: float, radius: float) -> float:
    """Of all planets: mu r times what sun and ring press them with, the ring by the couple less."""
    couple = 0.0
    for _ in range(100):
        less = couple / PLANET
        couple = mu * radius * math.hypot(2 * FORCE - less, less * math.tan(math.radians(20)))
    return couple


def friction(of: str) -> str:
    return f", friction: {{{of}}}" if of else ""


def text(sun: str, carrier: str, planet: str, more: str, count: int = 3) -> str:
    return TEXT % (friction(sun), friction(carrier), friction(planet), count, more)


class PlanetFriction(unittest.TestCase):
    def case(self, *arguments: str, count: int = 3, loads: str = "") -> tuple[dict, str]:
        done = program.call("analyze", "-", text=text(*arguments, CASE % loads, count=count))
        self.assertEqual(done.returncode, 0, done.stderr)
        return program.report(done)["cases"]["run"], done.stderr

    def test_of_central_bearings_is_none_where_planets_press_from_all_sides(self) -> None:
        rubs = ("mu: 0.1, radius: 10", "mu: 0.1, radius: 20", "mu: 0.05, radius: 5")
        expected = 1 - pin_couple(0.05, 0.005) * SPINS / (TORQUE * SPEED)
        for of in (rubs, ("", "", rubs[2])):
            case, said = self.case(*of)
            self.assertAlmostEqual(case["power"]["efficiency"]["friction"], expected, delta=1e-9)
            self.assertNotIn("W0315", said)
        couples = {name: one["couple"] for name, one in self.case(*rubs)[0]["statics"]["friction"].items()}
        self.assertEqual((couples["s"], couples["c"]), (0.0, 0.0))

    def test_of_central_bearings_is_that_of_the_force_of_one_planet(self) -> None:
        """What one planet presses sun and carrier with has nothing against it."""
        case, _ = self.case("mu: 0.1, radius: 10", "", "", count=1)
        force = math.hypot(FORCE, FORCE * math.tan(math.radians(20)))
        drag = case["statics"]["friction"]["s"]["couple"]
        # The couple is taken from the torque that presses.
        self.assertAlmostEqual(drag, 0.001 * force * (1 - drag / TORQUE), delta=1e-9)

    def test_counts_what_is_given_for_one_bearing_for_each_planet(self) -> None:
        for of, couple in (("tau: 0.1 N*m", 0.1), ("c: 0.001", 0.001 * SPINS)):
            for count in (1, 3):
                case, _ = self.case("", "", of, count=count)
                self.assertAlmostEqual(case["power"]["efficiency"]["friction"],
                                       1 - count * couple * SPINS / (TORQUE * SPEED), delta=1e-9)

    def test_of_central_bearings_is_that_of_other_loads(self) -> None:
        """A pull of 100 N on the sun; the planets cancel."""
        case, said = self.case("mu: 0.1, radius: 10", "mu: 0.1, radius: 20", "",
                               loads=", loads: {pull: {body: sun, at: [0, 0], force: [100, 0]}}")
        couples = {name: one["couple"] for name, one in case["statics"]["friction"].items()}
        self.assertAlmostEqual(couples["s"], 0.1 * 0.01 * 100, delta=1e-12)
        self.assertEqual(couples["c"], 0.0)
        self.assertNotIn("W0315", said)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=sys.argv[1:])
