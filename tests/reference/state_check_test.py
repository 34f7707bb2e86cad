#!/usr/bin/env python3
"""States of sweeps that the check of the file refuses: every one is a row with the code that
'kinestat analyze --set' gives for it, whichever way the others are worked out.

Usage: state_check_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import itertools
import json
import re
import sys
import unittest

import program

CAM = """
kinestat: 1
space: planar
units: {length: mm}
parameters: {r: 31, q: 10, k: 5 N/mm, x: 2}
ground: frame
bodies: {cam: , follower: {MASS}}
couplings:
  a: {type: revolute, bodies: [frame, cam], at: [q, 0]}
  g: {type: prismatic, bodies: [frame, follower], at: [0, 52], axis: y}
  c: {type: cam, bodies: [cam, follower], at: [9, 40], normal: [-9, 40], radii: [r, q]STIFF}
actuators: {motor: {coupling: a}, press: {coupling: g}}
cases: {one: {motion: {motor: 3 rad/s}, action: {press: -10 N}, input: motor, output: press}}
"""


def cam(mass: str = "", stiff: str = "") -> str:
    return CAM.replace("{MASS}", f"{{{mass}}}" if mass else "").replace("STIFF", stiff)


SPATIAL = """
kinestat: 1
space: spatial
parameters: {Jz: 2, shift: 0.3}
ground: frame
bodies: {rotor: {inertia: [1, 1.5, Jz]}}
couplings: {a: {type: revolute, bodies: [frame, rotor], at: [shift, 0, 0], axis: z}}
actuators: {motor: {coupling: a}}
cases: {one: {motion: {motor: 3 rad/s}, action: {}}}
"""

# Gear a says how far its shaft is, gear c by its teeth and those of s.
LAY_SHAFT = """
kinestat: 1
space: planar
units: {length: mm}
parameters: {z: 40, n: 3, share: 1.2}
ground: housing
bodies: [input, lay, idler, planet, ring, carrier]
couplings:
  I: {type: revolute, bodies: [housing, input]}
  L: {type: revolute, bodies: [housing, lay]}
  M: {type: revolute, bodies: [housing, idler]}
  R: {type: revolute, bodies: [housing, ring]}
  K: {type: revolute, bodies: [housing, carrier]}
  P: {type: revolute, bodies: [carrier, planet]}
  C: {type: clutch, bodies: [lay, idler]}
gears:
  module: 2 mm
  members:
    i: {body: input, teeth: 20}
    a: {body: lay, teeth: 40, centre_distance: 60 mm}
    j: {body: input, teeth: 20}
    c: {body: idler, teeth: z}
    sun: {body: input, teeth: 24}
    planet: {body: planet, teeth: 18, count: n, load_sharing: share}
    ring: {body: ring, teeth: 60, internal: true}
  meshes:
    ia: {members: [i, a]}
    jc: {members: [j, c]}
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
actuators: {in: {coupling: I}, out: {coupling: K}, held: {coupling: R}}
cases: {one: {motion: {in: 3 rad/s, held: 0}, action: {in: 5, C: 0}, input: in, output: out}}
"""

FOUR_BAR = """
kinestat: 1
space: planar
parameters: {m1: 2, m2: 1, b: 3, x: 1}
ground: frame
bodies: {crank: {mass: m1 - m2, centre_of_mass: CENTRE}, coupler: , rocker: }
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [1, b]}
  c: {type: revolute, bodies: [coupler, rocker], at: [6, 5]}
  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}
actuators: {motor: {coupling: a}, work: {coupling: d}}
cases: {one: {motion: {motor: 1 rad/s}, action: {work: 1}, input: motor, output: work}}
"""

PLANAR_ORDER = """
kinestat: 1
space: spatial
order: {kinematics: planar}
parameters: {z: 0, y: 1}
ground: frame
bodies: [arm, slide]
couplings:
  a: {type: revolute, bodies: [frame, arm], at: [0, 0, 0], axis: [0, z, 1]}
  b: {type: revolute, bodies: [arm, slide], at: [1, y, 0], axis: z}
actuators: {motor: {coupling: a}, other: {coupling: b}}
cases: {one: {motion: {motor: 1 rad/s, other: 2}}}
"""


class StateChecks(unittest.TestCase):
    def compare(self, text: str, vary: dict[str, list], report: str, refused: int,
                more: str = "") -> None:
        """`refused` is how many of the states the file's own check does not take."""
        axes = ", ".join(f"{name}: [{', '.join(map(str, values))}]" for name, values in vary.items())
        done = program.call("sweep", "-", text=f"{text}{more}\n"
                            f"sweep: {{vary: {{{axes}}}, report: [{report}]}}\n")
        self.assertIn(done.returncode, (0, 5), done.stderr)
        rows = [json.loads(line) for line in done.stdout.splitlines()]
        states = list(itertools.product(*vary.values()))
        self.assertEqual(len(rows), len(states))
        count = 0
        for row, values in zip(rows, states):
            sets = [word for name, value in zip(vary, values) for word in ("--set", f"{name}={value}")]
            alone = program.call("analyze", *sets, "-", text=text + more)
            code = re.search(r"error\[(E\d+)\]", alone.stderr)
            expected = code.group(1) if code else "solved"
            count += expected != "solved"
            self.assertEqual(row["status"], expected, f"{values}: {alone.stderr}")
            if code:
                numbers = [value for key, value in row.items()
                           if key not in ("case", "status") and key.split(" ")[0] not in vary]
                self.assertEqual(set(numbers), {None}, values)
        self.assertEqual(count, refused)

    def test_radii_of_a_cam(self) -> None:
        self.compare(cam(), {"r": [31, 0, -5, 12, -40]}, "ratio", 2)
        self.compare(cam(), {"q": [10, 0, 12], "r": [31, 20, -5]}, "ratio", 5)

    def test_stiffness(self) -> None:
        self.compare(cam(stiff=", stiffness: {R: k}"), {"k": ["5 N/mm", "0 N/mm", "-1 N/mm"]},
                     "ratio", 2)

    def test_numbers_without_a_value(self) -> None:
        body = "mass: 1, centre_of_mass: [1/x, 3]"
        self.compare(cam(body), {"x": [1, 0, 2], "q": [10, 12]}, "ratio", 2)
        self.compare(cam("centre_of_mass: [1/x, 3]"), {"x": [1, 0, 2]}, "ratio", 1)

    def test_moments_of_inertia(self) -> None:
        self.compare(SPATIAL, {"Jz": [2, 2.5, 2.6, 0.4], "shift": [0.3, 0]}, "a.wz", 4)

    def test_distances_of_a_clutched_shaft(self) -> None:
        self.compare(LAY_SHAFT, {"z": [40, 41, 30]}, "ratio", 2)

    def test_shares_of_planets(self) -> None:
        self.compare(LAY_SHAFT, {"n": [3, 2, 1], "share": [1.2, 2.5]}, "ratio", 3)

    def test_rules_of_two_parameters(self) -> None:
        text = FOUR_BAR.replace("CENTRE", "[0, 0]")
        self.compare(text, {"m1": [2, 1, 0.5], "m2": [1, 0]}, "ratio", 1)

    def test_motions(self) -> None:
        """Followed several at a time."""
        text = FOUR_BAR.replace("CENTRE", "[1/x, 0]")
        self.compare(text, {"m1": [2, 0.5], "b": [3, 2.9]}, "d.wz.position.range", 2,
                     "motion: {drive: motor, to: 40 deg, steps: 5}\n")
        self.compare(text, {"x": [2, 0], "b": [3, 2.9]}, "d.wz.position.range", 2,
                     "motion: {drive: motor, to: 40 deg, steps: 5}\n")

    def test_orders(self) -> None:
        self.compare(PLANAR_ORDER, {"y": [1, 2], "z": [0, 0.1]}, "b.wz", 2)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
