#!/usr/bin/env python3
"""Power splits with a machine that reacts, by Willis and by virtual power.

Usage: hybrid_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import random
import sys
import unittest

import program


# One planetary set, engine on the carrier, MG1 on the sun, output and MG2 on the ring.
def input_split(sun: int, ring: int, shift: str) -> str:
    planet = (ring - sun) // 2
    return f"""kinestat: 1
space: planar
units: {{length: mm, angular_velocity: rpm}}
ground: housing
bodies: [carrier, sun, ring, planet]
couplings:
  E: {{type: revolute, bodies: [housing, carrier]}}
  G: {{type: revolute, bodies: [housing, sun]}}
  O: {{type: revolute, bodies: [housing, ring]}}
  P: {{type: revolute, bodies: [carrier, planet]}}
  B1: {{type: brake, bodies: [housing, sun]}}
  BE: {{type: brake, bodies: [housing, carrier]}}
  K: {{type: clutch, bodies: [carrier, sun]}}
gears:
  module: 2 mm
  members:
    s: {{body: sun, teeth: {sun}}}
    p: {{body: planet, teeth: {planet}}}
    r: {{body: ring, teeth: {ring}, internal: true}}
  meshes:
    sp: {{members: [s, p], carrier: carrier}}
    rp: {{members: [r, p], carrier: carrier}}
actuators:
  engine: {{coupling: E}}
  MG1: {{coupling: G}}
  MG2: {{coupling: O}}
  out: {{coupling: O}}
shift:
  input: [engine, MG2]
  output: out
  elements: [B1, BE, K]
  reacts: MG1
  names: {{EVT: [], over: [B1], electric: [BE], direct: [K]}}
{shift}"""


class InputSplit(unittest.TestCase):
    def test_modes(self) -> None:
        rng = random.Random(3)
        for _ in range(10):
            s = rng.randrange(18, 50)
            r = s + 2 * rng.randrange(14, 40)
            e, m = rng.uniform(800, 4000), rng.uniform(500, 5000)
            te, tm = rng.uniform(20, 200), rng.uniform(-80, 150)
            shift = program.run("analyze", "-", text=input_split(
                s, r, f"  input_motion: {{engine: {e!r}, MG2: {m!r}}}\n"
                      f"  input_action: {{engine: {te!r}, MG2: {tm!r}}}\n"))["shift"]
            states = shift["states"]
            self.assertEqual({name: states[name]["class"] for name in
                              ("EVT", "over", "electric", "direct")},
                             dict.fromkeys(("EVT", "over", "electric", "direct"), "gear"))
            near = lambda a, b: self.assertAlmostEqual(a, b, delta=1e-9 * (1 + abs(b)))
            # Willis: (s + r) engine = s MG1 + r out.
            evt = states["EVT"]
            self.assertIsNone(evt["ratio"])
            machine = evt["reactions"]["MG1"]
            near(machine["speed"], ((s + r) * e - r * m) / s)
            near(machine["speed_shares"]["engine"], (s + r) / s)
            near(machine["speed_shares"]["MG2"], -r / s)
            near(machine["torque"], -te * s / (s + r))
            near(machine["torque_shares"]["engine"], -s / (s + r))
            near(machine["torque_shares"]["MG2"], 0)
            near(evt["torque_shares"]["out"]["engine"], -r / (s + r))
            near(evt["torque_shares"]["out"]["MG2"], -1)
            near(evt["speed_shares"]["out"]["engine"], 0)
            near(evt["speed_shares"]["out"]["MG2"], 1)
            # MG1 held by its brake: a fixed gear.
            over = states["over"]
            near(over["ratio"], r / (s + r))
            near(over["elements"]["B1"]["torque"], -te * s / (s + r))
            self.assertEqual(over["reactions"]["MG1"]["torque"], 0)
            self.assertEqual(over["reactions"]["MG1"]["speed"], 0)
            near(over["torque_shares"]["out"]["engine"], -r / (s + r))
            # All as one: the torques of both inputs add.
            direct = states["direct"]
            near(direct["ratio"], 1)
            near(direct["torque_shares"]["out"]["engine"], -1)
            near(direct["torque_shares"]["out"]["MG2"], -1)
            # The engine held: MG2 drives alone, MG1 idles without a torque.
            electric = states["electric"]
            self.assertIsNone(electric["ratio"])
            near(electric["speed_shares"]["out"]["MG2"], 1)
            near(electric["reactions"]["MG1"]["speed"], -r / s * m)
            near(electric["elements"]["BE"]["torque"], -te)

    def test_cases_of_the_modes(self) -> None:
        """Each mode is a case that balances, with the same torques."""
        text = input_split(30, 78, "  input_motion: {engine: 1500, MG2: 2000}\n"
                                   "  input_action: {engine: 100, MG2: 20}\n")
        report = program.run("analyze", "-", text=text)
        for name in ("EVT", "over", "electric", "direct"):
            one = report["cases"][name]
            state = report["shift"]["states"][name]
            self.assertLess(one["power"]["balance_residual"], 1e-12, name)
            actions = one["statics"]["actions"]
            shares = state["torque_shares"]["out"]
            self.assertAlmostEqual(actions["out"], 100 * shares["engine"] + 20 * shares["MG2"])
            self.assertAlmostEqual(actions["MG1"], state["reactions"]["MG1"]["torque"])

    def test_without_torques(self) -> None:
        states = program.run("analyze", "-", text=input_split(
            30, 78, "  input_motion: {engine: 1500, MG2: 2000}\n"))["shift"]["states"]
        machine = states["EVT"]["reactions"]["MG1"]
        self.assertIsNone(machine["torque"])
        self.assertAlmostEqual(machine["torque_shares"]["engine"], -30 / 108)

    def test_all_combinations(self) -> None:
        """From none to one element; two hold everything."""
        text = input_split(30, 78, "").replace(
            "  names: {EVT: [], over: [B1], electric: [BE], direct: [K]}\n", "")
        states = program.run("analyze", "-", text=text)["shift"]["states"]
        self.assertEqual(set(states), {"none", "B1", "BE", "K"})
        self.assertEqual({one["class"] for one in states.values()}, {"gear"})

    def test_torques_of_one_input_alone(self) -> None:
        """What has no torque given has none."""
        states = program.run("analyze", "-", text=input_split(
            30, 78, "  input_action: {engine: 108}\n"))["shift"]["states"]
        self.assertAlmostEqual(states["EVT"]["reactions"]["MG1"]["torque"], -30)

    def test_roles(self) -> None:
        text = input_split(30, 78, "").replace("reacts: MG1", "reacts: MG2")
        done = program.call("analyze", "-", text=text)
        self.assertIn("'MG2' cannot be both input and what reacts", done.stderr)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
