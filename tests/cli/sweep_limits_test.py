#!/usr/bin/env python3
"""Sweeps of tooth numbers with conditions on planets, and with limits of gears."""

from __future__ import annotations

import math

from sweep_case import SWEEP, TRAIN, InFolder, kinestat, main

# A brake on the sun, driven by the carrier. By Willis the ring turns 1 + S/R as fast, the brake on the
# sun bears 1/(1 + eta R/S) of the torque of the carrier, as the sun drives in the carrier, and the
# planet turns by S/P on its carrier.
OVERDRIVE = """
kinestat: 1
space: planar
units: {length: mm}
parameters: {S: 20, P: 10, R: S + 2*P, planets: 3, most: 13 N*m}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  I: {type: revolute, bodies: [housing, sun]}
  R: {type: revolute, bodies: [housing, ring]}
  C: {type: revolute, bodies: [housing, carrier]}
  p: {type: revolute, bodies: [carrier, planet]}
  B: {type: brake, bodies: [housing, sun]}
  K: {type: clutch, bodies: [ring, carrier]}
gears:
  module: 1 mm
  members:
    s: {body: sun, teeth: S}
    p: {body: planet, teeth: P, count: planets}
    r: {body: ring, teeth: R, internal: true}
  meshes:
    sp: {members: [s, p], carrier: carrier}
    pr: {members: [p, r], carrier: carrier}
actuators: {in: {coupling: C}, out: {coupling: R}}
losses: {meshes: {sp: 0.03}}
shift:
  input: in
  output: out
  elements: [B, K]
  input_motion: 10 rad/s
  input_action: 50 N*m
  names: {over: [B], direct: [K]}
  limits:
    torque: {B: most}
    slip: 11 rad/s
    speed: 14 rad/s
    planet_speed: {planet: 9 rad/s}
"""


class Planets(InFolder):
    """Conditions on planets, decided before anything is analysed."""

    def kept(self, text: str, names: list[str]) -> set[tuple[int, ...]]:
        return {tuple(int(row[name]) for name in names) for row in self.rows(text)}

    def test_equal_angles_need_the_sum_of_sun_and_ring_divided(self) -> None:
        text = OVERDRIVE + """
sweep:
  vary: {S: {from: 12, to: 40, step: 1}, P: {from: 9, to: 24, step: 1}, planets: [2, 3, 4, 5, 7]}
  require: [assembles(p)]
  cases: [over]
  report: [ratio]
"""
        expected = {(s, p, n) for s in range(12, 41) for p in range(9, 25) for n in (2, 3, 4, 5, 7)
                    if (2 * s + 2 * p) % n == 0}
        self.assertEqual(self.kept(text, ["S", "P", "planets"]), expected)

    def test_neighbours_clear_where_their_chord_is_longer_than_their_tips(self) -> None:
        text = OVERDRIVE + """
sweep:
  vary: {S: {from: 12, to: 40, step: 1}, P: {from: 9, to: 24, step: 1}, planets: [1, 3, 4, 5, 7]}
  require: ["clears(planet) and not planets == 1"]
  cases: [over]
  report: [ratio]
"""
        expected = {(s, p, n) for s in range(12, 41) for p in range(9, 25) for n in (3, 4, 5, 7)
                    if (s + p) * math.sin(math.pi / n) > p + 2}
        self.assertEqual(self.kept(text, ["S", "P", "planets"]), expected)

    def test_stepped_planets_need_all_their_teeth(self) -> None:
        """(S Q + R P)/gcd(P, Q), with P on the sun and Q on the ring."""
        text = OVERDRIVE.replace("R: S + 2*P", "Q: 10, R: S + P + Q").replace(
            "    r: {", "    q: {body: planet, teeth: Q}\n    r: {").replace("[p, r]", "[q, r]")
        text += """
sweep:
  vary: {S: {from: 20, to: 30, step: 1}, P: {from: 9, to: 16, step: 1}, Q: [8, 10, 12, 15]}
  require: [assembles(q)]
  cases: [over]
  report: [ratio]
"""
        expected = {(s, p, q) for s in range(20, 31) for p in range(9, 17) for q in (8, 10, 12, 15)
                    if (s * q + (s + p + q) * p) // math.gcd(p, q) % 3 == 0}
        self.assertEqual(self.kept(text, ["S", "P", "Q"]), expected)

    def test_they_are_what_the_warnings_say(self) -> None:
        """Of trains with two planets in mesh, whose condition nobody writes by hand."""
        text = OVERDRIVE.replace("R: S + 2*P", "Q: 14, R: S + 2*P + Q").replace(
            "carrier, planet]\ncouplings:", "carrier, planet, outer]\ncouplings:\n"
            "  o: {type: revolute, bodies: [carrier, outer]}").replace(
            "    r: {", "    q: {body: outer, teeth: Q}\n    r: {").replace(
            "    pr: {members: [p, r]", "    pq: {members: [p, q], carrier: carrier}\n"
            "    pr: {members: [q, r]")
        sweep = """
sweep:
  vary: {S: {from: 24, to: 31, step: 1}, P: {from: 10, to: 15, step: 1}, planets: [3, 6]}
  require: [CONDITION]
  cases: [over]
  report: [ratio]
"""
        names = ["S", "P", "planets"]
        kept = {word: self.kept(text + sweep.replace("CONDITION", f"{word}(p)"), names)
                for word in ("assembles", "clears")}
        for s in range(24, 32):
            for p in range(10, 16):
                for n in (3, 6):
                    done = kinestat("check", "--set", f"S={s}", "--set", f"P={p}",
                                    "--set", f"planets={n}", self.write(text))
                    said = done.stdout + done.stderr
                    self.assertEqual((s, p, n) in kept["assembles"], "W0306" not in said)
                    self.assertEqual((s, p, n) in kept["clears"], "W0307" not in said)
        for word, some in kept.items():
            self.assertTrue(0 < len(some) < 96, word)

    def test_questions_that_cannot_be_answered(self) -> None:
        for condition, message in (
                ("assembles(s)", "'assembles(s)' names 's', which is not a planet"),
                ("clears(x)", "'clears(x)' names 'x', which is not a gear member")):
            text = OVERDRIVE + f"sweep: {{vary: {{S: [20]}}, require: ['{condition}']}}\n"
            done = kinestat("sweep", self.write(text))
            self.assertIn("E0313", done.stderr)
            self.assertIn(message, done.stderr)
        text = OVERDRIVE.replace(", count: planets", "").replace(", planets: 3", "")
        done = kinestat("sweep", self.write(
            text + "sweep: {vary: {S: [20]}, require: [assembles(p)]}\n"))
        self.assertIn("'assembles(p)' names 'p', which has no 'count'", done.stderr)
        done = kinestat("sweep", self.write(
            OVERDRIVE + "sweep: {vary: {S: [20]}, report: [ratio], keep: [clears(p)]}\n"))
        self.assertIn("'clears(p)' is not allowed in 'keep'", done.stderr)
        done = kinestat("sweep", self.write(
            TRAIN + "sweep: {vary: {Ns: [20]}, require: [clears(planet)]}\n"))
        self.assertIn("the section 'gears', which the file does not have", done.stderr)


class Limits(InFolder):
    """What gears take of their limits, by Willis."""

    SWEEP = """
sweep:
  vary: {S: {from: 18, to: 36, step: 6}, P: {from: 9, to: 21, step: 3}}
  report: [limit_use, B]
"""

    def use(self, sun: int, planet: int, label: str, most: float = 13.0) -> float:
        ring = sun + 2 * planet
        if label == "direct":  # all turn as one; the brake slips
            return max(10 / 11, 10 / 14)
        torque = max(50 / (1 + 0.97 * ring / sun), 50 / (1 + ring / sun))
        # K slips by the ring less the carrier.
        return max(torque / most, 10 * sun / ring / 11, 10 * (1 + sun / ring) / 14,
                   10 * sun / planet / 9)

    def check(self, rows: list[dict[str, str]], most: float = 13.0) -> set[str]:
        largest = set()
        self.assertEqual(len(rows), 4 * 5 * 2)
        for row in rows:
            expected = self.use(int(row["S"]), int(row["P"]), row["case"], most)
            self.assertAlmostEqual(float(row["limit_use"]), expected, delta=1e-12)
            largest.add("above" if expected > 1 else "below")
        return largest

    def test_of_every_state(self) -> None:
        self.assertEqual(self.check(self.rows(OVERDRIVE + self.SWEEP)), {"above", "below"})

    def test_of_torques_alone(self) -> None:
        text = OVERDRIVE[:OVERDRIVE.index("    slip:")] + self.SWEEP
        for row in self.rows(text):
            sun, ring = int(row["S"]), int(row["S"]) + 2 * int(row["P"])
            bears = 50 / (1 + 0.97 * ring / sun) if row["case"] == "over" else 0.0
            self.assertAlmostEqual(float(row["limit_use"]), bears / 13, delta=1e-12)
            self.assertLessEqual(abs(float(row["B [N*m]"])), bears)  # without losses

    def test_of_limits_that_vary(self) -> None:
        text = OVERDRIVE.replace("most: 13 N*m", "most: S*0.5 N*m") + self.SWEEP
        for row in self.rows(text):
            most = 0.5 * int(row["S"])
            self.assertAlmostEqual(
                float(row["limit_use"]),
                self.use(int(row["S"]), int(row["P"]), row["case"], most), delta=1e-12)

    def test_keep_drops_states_that_exceed_one(self) -> None:
        rows = self.rows(OVERDRIVE + self.SWEEP + "  keep: [limit_use <= 1]\n")
        expected = {(s, p, label) for s in range(18, 37, 6) for p in range(9, 22, 3)
                    for label in ("over", "direct") if self.use(s, p, label) <= 1}
        self.assertEqual({(int(r["S"]), int(r["P"]), r["case"]) for r in rows}, expected)

    def test_needs_limits(self) -> None:
        text = OVERDRIVE[:OVERDRIVE.index("  limits:")] + self.SWEEP
        done = kinestat("sweep", self.write(text))
        self.assertIn("E0305", done.stderr)
        self.assertIn("no 'limits' in a section 'shift'", done.stderr)


if __name__ == "__main__":
    main(__doc__)
