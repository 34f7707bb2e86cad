#!/usr/bin/env python3
"""Gearboxes as they are built, written in teeth, against the closed forms of Willis.

Usage: gearbox_file_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import json
import math
import random
import re
import sys
import unittest
from collections.abc import Callable, Iterator
from fractions import Fraction

import program
from exact_train import Train
from random_train import draw_box
from reference_test_case import ReferenceTest

PLANETARY = """
kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [SHAFTS sun, ring, carrier, planet]
couplings:
  s: {type: revolute, bodies: [housing, sun]}
  r: {type: revolute, bodies: [housing, ring]DRAG}
  c: {type: revolute, bodies: [housing, carrier]}
  p: {type: revolute, bodies: [carrier, planet]}
COUPLINGS
gears:
  module: 2 mm
  members:
    sun:    {body: sun, teeth: 30}
    planet: {body: planet, teeth: 20}
    ring:   {body: ring, teeth: 70, internal: true}
  meshes:
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
REST
"""


def planetary(couplings: str, rest: str, shafts: str = "", drag: str = "") -> str:
    return (PLANETARY.replace("SHAFTS", shafts).replace("COUPLINGS", couplings)
            .replace("REST", rest).replace("DRAG", drag))


LAY_SHAFT = """
kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [in, lay, out, g1, g2]
couplings:
  I: {type: revolute, bodies: [housing, in]}
  L: {type: revolute, bodies: [housing, lay]}
  O: {type: revolute, bodies: [housing, out]}
  j1: {type: revolute, bodies: [housing, g1]}
  j2: {type: revolute, bodies: [housing, g2]}
  S1: {type: clutch, bodies: [lay, g1]}
  S2: {type: clutch, bodies: [lay, g2]}
gears:
  module: 2.5 mm
  members:
    d1: {body: in, teeth: 14}
    d2: {body: in, teeth: 28}
    w1: {body: g1, teeth: 42}
    w2: {body: g2, teeth: 28}
    p: {body: lay, teeth: 15, centre_distance: 70 mm}
    f: {body: out, teeth: 60, centre_distance: 140 mm}
  meshes:
    m1: {members: [d1, w1]}
    m2: {members: [d2, w2]}
    mf: {members: [p, f]}
actuators: {in: {coupling: I}, out: {coupling: O}}
shift: {input: in, output: out, elements: [S1, S2]}
"""

# The second set stands 75 mm from the first, by the wheel and the pinion; its sun at (0, 75).
SECOND_AXIS = """
kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [sun1, carrier1, p1, sun2, carrier2, p2]
couplings:
  S1: {type: revolute, bodies: [housing, sun1]}
  C1: {type: revolute, bodies: [housing, carrier1]}
  P1: {type: revolute, bodies: [carrier1, p1]}
  S2: {type: revolute, bodies: [housing, sun2]}
  C2: {type: revolute, bodies: [housing, carrier2], at: [0, 75]}
  P2: {type: revolute, bodies: [carrier2, p2], at: [0, 115]}
  d: {type: gear, bodies: [sun2, p2], at: [0, 95],
      line_of_action: [cos(20 deg), sin(20 deg)]}
  e: {type: gear, bodies: [housing, p2], at: [0, 135], internal: true,
      line_of_action: [cos(20 deg), sin(20 deg)]}
gears:
  module: 2 mm
  members:
    s1: {body: sun1, teeth: 20}
    pl1: {body: p1, teeth: 20, count: 3}
    r1: {body: housing, teeth: 60, internal: true}
    wheel: {body: carrier1, teeth: 25}
    pinion: {body: sun2, teeth: 50}
  meshes:
    a: {members: [s1, pl1], carrier: carrier1}
    b: {members: [r1, pl1], carrier: carrier1}
    c: {members: [wheel, pinion]}
actuators: {in: {coupling: S1}, out: {coupling: C2}}
cases: {k: {motion: {in: 100 rad/s}, action: {in: 1 N*m}, input: in, output: out}}
"""

HYBRID = """
kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [engine, motor, carrier, planet, out, w]
couplings:
  e: {type: revolute, bodies: [housing, engine]}
  m: {type: revolute, bodies: [housing, motor]}
  c: {type: revolute, bodies: [housing, carrier]}
  p: {type: revolute, bodies: [carrier, planet]}
  o: {type: revolute, bodies: [housing, out], at: [0, 0]}
  x: {type: revolute, bodies: [housing, w]}
  K1: {type: clutch, bodies: [carrier, out]}
  K2: {type: clutch, bodies: [motor, out]}
gears:
  module: 2 mm
  members:
    sun:    {body: motor, teeth: 30}
    planet: {body: planet, teeth: 15, count: 3}
    ring:   {body: engine, teeth: 60, internal: true}
    a: {body: carrier, teeth: 40}
    b: {body: w, teeth: 40}
  meshes:
    s: {members: [sun, planet], carrier: carrier}
    r: {members: [ring, planet], carrier: carrier}
    ab: {members: [a, b]}
actuators: {engine: {coupling: e}, motor: {coupling: m}, out: {coupling: o}}
shift: {input: [engine, motor], output: out, elements: [K1, K2],
        input_motion: {engine: 200 rad/s, motor: 100 rad/s}, input_action: 100 N*m}
"""

DIFFERENTIAL = """
kinestat: 1
space: planar
units: {length: mm}
parameters: {loss: 0.02}
ground: housing
bodies: [case, left, right, p1, p2]
couplings:
  C: {type: revolute, bodies: [housing, case]}
  L: {type: revolute, bodies: [housing, left]}
  R: {type: revolute, bodies: [housing, right]}
  P1: {type: revolute, bodies: [case, p1]}
  P2: {type: revolute, bodies: [case, p2]}
  LSD: {type: clutch, bodies: [case, left]}
gears:
  module: 2 mm
  members:
    sl: {body: left, teeth: 24}
    sr: {body: right, teeth: 24}
    p1: {body: p1, teeth: 18, count: 3}
    p2: {body: p2, teeth: 18, count: 3}
  meshes:
    a: {members: [sl, p1], carrier: case}
    b: {members: [p1, p2], carrier: case}
    c: {members: [sr, p2], carrier: case}
actuators:
  engine: {coupling: C}
  left: {coupling: L}
  right: {coupling: R}
losses: {gear_external: loss}
cases:
  slipping: {motion: {engine: 100 rad/s, left: 110 rad/s}, action: {engine: 600 N*m, LSD: -80 N*m},
             input: engine, output: [left, right]}
"""

DOUBLE_PINION = """
kinestat: 1
space: planar
units: {length: mm}
parameters: {alpha: 20 deg}
ground: housing
bodies: [carrier, ring, inner, outer]
couplings:
  c: {type: revolute, bodies: [housing, carrier]}
  r: {type: revolute, bodies: [housing, ring]}
  i: {type: revolute, bodies: [carrier, inner]}
  o: {type: revolute, bodies: [carrier, outer]}
gears:
  module: 1.5 mm
  pressure_angle: alpha
  members:
    sun:   {body: housing, teeth: 42}
    inner: {body: inner, teeth: 18, count: 3}
    outer: {body: outer, teeth: 19, count: 3SIDE}
    ring:  {body: ring, teeth: 80, internal: true}
  meshes:
    a: {members: [sun, inner], carrier: carrier}
    b: {members: [inner, outer], carrier: carrier}
    d: {members: [ring, outer], carrier: carrier}
actuators: {in: {coupling: c}, out: {coupling: r}}
cases: {k: {motion: {in: 100 rad/s}, action: {in: 100 N*m}, input: in, output: out}}
"""


class GearboxFiles(ReferenceTest):
    def states(self, text: str) -> dict:
        return program.run("shift", "-", text=text)["shift"]["states"]

    def test_a_shaft_between_clutches_turns_about_their_axis(self) -> None:
        """Input by C1 to the sun: 1 + 70/30; by C2 to the ring free sun: needs the brake."""
        text = planetary("""
  in: {type: revolute, bodies: [housing, shaft]}
  C1: {type: clutch, bodies: [shaft, sun]}
  C2: {type: clutch, bodies: [shaft, ring]}
  B: {type: brake, bodies: [housing, ring]}
""", """
actuators: {out: {coupling: c}, drive: {coupling: in}}
shift: {input: drive, output: out, elements: [C1, C2, B]}
""", shafts="shaft, ")
        states = self.states(text)
        self.near(states["C1+B"]["ratio"], 1 + 70 / 30, "first gear")
        self.near(states["C1+C2"]["ratio"], 1.0, "block")
        self.assertEqual(states["C2+B"]["class"], "locked")

    def test_a_shaft_clutched_to_a_lay_shaft_stands_beside_the_main_axis(self) -> None:
        text = LAY_SHAFT.replace("g1, g2]", "g1, g2, pto]").replace(
            "gears:\n", "  T: {type: revolute, bodies: [housing, pto]}\n"
                        "  S3: {type: clutch, bodies: [lay, pto]}\ngears:\n")
        rows = program.run("graph", "-", text=text)["graph"]["couplings"]
        couplings = {row["name"]: row for row in rows}
        self.assertEqual(couplings["T"]["at"][:2], couplings["L"]["at"][:2])

    def test_idlers_of_a_lay_shaft_make_two_speeds(self) -> None:
        states = self.states(LAY_SHAFT)
        self.near(states["S1"]["ratio"], 42 / 14 * 60 / 15, "S1", 12.0)
        self.near(states["S2"]["ratio"], 28 / 28 * 60 / 15, "S2")

    def test_a_planetary_set_on_another_axis_is_written_with_couplings(self) -> None:
        case = program.run("analyze", "-", text=SECOND_AXIS)["cases"]["k"]
        self.near(case["ratio"], -(1 + 60 / 20) * (50 / 25) * (1 + 60 / 20), "ratio", 32.0)

    def test_viscous_drag_of_a_shaft_at_rest_is_nothing(self) -> None:
        """The brake holds the ring: efficiency 1 - 0.01·(1 - 30/100) as without the drag."""
        rest = """
actuators: {in: {coupling: s}, out: {coupling: c}}
losses: {meshes: {sp: 0.01}}
shift: {input: in, output: out, elements: [C, B], input_motion: 1500 rpm, input_action: 50 N*m,
        names: {M1: [B], M2: [C]}}
"""
        elements = """
  C: {type: clutch, bodies: [sun, ring]}
  B: {type: brake, bodies: [housing, ring]}
"""
        report = program.run("analyze", "-",
                             text=planetary(elements, rest, drag=", friction: {c: 0.001}"))
        self.near(report["cases"]["M1"]["power"]["efficiency"]["carrier"], 1 - 0.01 * 0.7, "M1")
        self.near(report["cases"]["M1"]["statics"]["friction"]["r"]["couple"], 0.0, "drag at rest")
        # The ring turns at 50π rad/s in the second gear.
        self.near(report["cases"]["M2"]["statics"]["friction"]["r"]["couple"],
                  0.001 * 50 * math.pi, "drag")

    def test_no_step_stands_where_the_inputs_have_no_common_ratio(self) -> None:
        done = program.call("shift", "-", text=HYBRID)
        self.assertEqual(done.returncode, 5, "the engine has nothing to push against in K2")
        shift = program.report(done)["shift"]
        self.assertEqual({state["class"] for state in shift["states"].values()}, {"gear"})
        self.assertEqual([state["ratio"] for state in shift["states"].values()], [None, None])
        self.assertEqual([state["step"] for state in shift["states"].values()], [None, None])
        self.assertIsNone(shift["span"])
        self.assertEqual(shift["equal_ratios"], [])

    def test_a_clutch_that_slips_loses_its_power(self) -> None:
        """Half of 600 N·m reaches each wheel, less and more what the clutch passes on: without
        losses of teeth 260·110 + 340·90 W of 60 000 W come out, and with them less."""
        for loss, least, most in (("0", 0.98666, 0.98667), ("0.02", 0.98, 0.98666)):
            done = program.run("analyze", "--set", f"loss={loss}", "-", text=DIFFERENTIAL)
            power = done["cases"]["slipping"]["power"]
            self.near(power["actuators"]["LSD"], -800.0, "slip", 60000.0)
            self.assertGreater(power["efficiency"]["carrier"], least)
            self.assertLess(power["efficiency"]["carrier"], most)

    def test_lossy_actions_of_a_sweep_balance_with_its_efficiency(self) -> None:
        """out = -efficiency·ratio·in, beside the ideal torque of the same row."""
        text = planetary("  B: {type: brake, bodies: [housing, ring]}", """
parameters: {T: 50 N*m}
actuators: {in: {coupling: s}, out: {coupling: c}}
losses: {gear_external: 0.01, gear_internal: 0.005}
cases: {k: {motion: {in: 100, B: 0}, action: {in: T}, input: in, output: out}}
sweep: {vary: {T: {values: [1 N*m, 10 N*m]}}, report: [ratio, efficiency, out, lossy.out]}
""")
        done = program.call("sweep", "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [list(json.loads(line).values()) for line in done.stdout.splitlines()]
        self.assertEqual(len(rows), 2)
        for torque, _, ratio, efficiency, ideal, lossy, status in rows:
            self.assertEqual(status, "solved")
            self.near(ideal, -ratio * torque, "without losses", 100.0)
            self.near(lossy, -efficiency * ratio * torque, "with losses", 100.0)
            self.assertLess(abs(lossy), abs(ideal))

    def test_one_path_does_not_recirculate_whatever_the_drawing(self) -> None:
        for side in ("", ", side: right"):
            for alpha in ("14.5 deg", "20 deg", "25 deg", "30 deg"):
                done = program.run("analyze", "--set", f"alpha={alpha}", "-",
                                   text=DOUBLE_PINION.replace("SIDE", side))
                recirculation = done["cases"]["k"]["power"]["recirculation"]
                self.near(recirculation["factor"], 1.0, alpha + side)
                self.assertEqual(recirculation["loops"], [])

    def test_circulating_power_is_that_of_the_train(self) -> None:
        """Of twenty random trains, whatever the pressure angle, the side of planets and the space."""
        found: list[float] = []
        for text in random_trains(20, lambda train: True):
            factors = [self.factors(one) for one in drawings(text)]
            for other in factors[1:]:
                self.assertEqual(other.keys(), factors[0].keys())
                for name, factor in factors[0].items():
                    self.near(other[name], factor, name, max(1.0, abs(factor)))
            found += factors[0].values()
        self.assertGreater(len([one for one in found if one > 1.1]), 5)

    def test_one_set_with_a_brake_has_one_path(self) -> None:
        def has_one_path(train: Train) -> bool:
            return len(train.sets) == 1 and all("housing" in ends for ends in train.elements.values())

        gears = 0
        for text in random_trains(20, has_one_path):
            for one in drawings(text):
                for name, factor in self.factors(one).items():
                    self.near(factor, 1.0, name)
                    gears += 1
        self.assertGreater(gears, 50)

    def factors(self, text: str) -> dict[str, float]:
        return {name: state["recirculation"] for name, state in self.states(text).items()
                if state["class"] == "gear" and state["recirculation"] is not None}


def random_trains(count: int, is_meant: Callable[[Train], bool]) -> Iterator[str]:
    """Files of trains that have planets in pairs."""
    seed = 0
    while count > 0:
        seed += 1
        train, text = draw_box(random.Random(seed), Fraction(7))
        if "outer" in text and is_meant(train):
            count -= 1
            yield text


def drawings(text: str) -> Iterator[str]:
    """The train of a file drawn anew, in the plane and in space."""
    for side in ("", ", side: right"):
        placed = re.sub(r"(outer\d: \{[^}]*)\}", rf"\1{side}}}", text)
        for alpha in ("14.5 deg", "20 deg", "25 deg", "30 deg"):
            planar = placed.replace("gears:\n", f"gears:\n  pressure_angle: {alpha}\n")
            yield planar
            spatial = planar.replace(", at: [0, 0]", "").replace("space: planar", "space: spatial")
            yield re.sub(r"(type: (revolute|clutch|brake), bodies: \[[^]]*\])\}",
                         r"\1, at: 0, axis: z}", spatial)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
