#!/usr/bin/env python3
"""Duties against closed forms, and each of their points against the case that it is.

Usage: duty_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math
import random
import re
import sys
import tempfile
import unittest
from pathlib import Path

import program
from swept_case import swept

MECHANISMS = Path()

# Two gears on fixed axes: the pinion has 20 teeth, the wheel 50. Teeth lose 2 %, the bearing of the
# wheel rubs with c·ω, the open brake drags with tau.
PAIR = """kinestat: 1
space: planar
units: {length: mm, energy: kJ}
ground: frame
bodies: [pinion, wheel]
couplings:
  a: {type: revolute, bodies: [frame, pinion]}
  b: {type: revolute, bodies: [frame, wheel], friction: {c: 0.02 N*m*s/rad}}
  B: {type: brake, bodies: [frame, wheel], friction: {tau: 3 N*m}}
gears:
  module: 2 mm
  members: {p: {body: pinion, teeth: 20}, w: {body: wheel, teeth: 50}}
  meshes: {m: {members: [p, w]}}
actuators: {in: {coupling: a}, out: {coupling: b}}
losses: {gear_external: 0.02}
cases:
  run: {motion: {in: 100 rad/s}, action: {in: 10 N*m, B: 0}, input: in, output: out}
duty:
  repetitions: 50
  gear_exponent: 3
  bearing_exponent: 10/3
  points:
    - {input_motion: 100 rad/s, input_action: 40 N*m, duration: 2 min}
    - {input_motion: 200 rad/s, input_action: 20 N*m, duration: 30 s}
    - {input_motion: -150 rad/s, input_action: -25 N*m, duration: 60 s}
    - {input_motion: 100 rad/s, input_action: -30 N*m, duration: 10 s}
    - {input_motion: 100 rad/s, input_action: 0, duration: 5 s}
    - {input_motion: 0, duration: 100 s}
"""
POINTS = [(100, 40, 120), (200, 20, 30), (-150, -25, 60), (100, -30, 10), (100, 0, 5)]


class Pair(unittest.TestCase):
    def setUp(self) -> None:
        self.duty = program.run("duty", "-", text=PAIR)["duty"]

    # The wheel passes on what the teeth leave, less drag D = 3 + 0.02 ω/2.5; driven by the wheel, it
    # takes what the teeth need, and the drag.
    def flow(self, speed: float, torque: float) -> tuple[float, float, float, float]:
        wheel = abs(speed) / 2.5
        drag = (3 + 0.02 * wheel) * wheel
        power = speed * torque
        if power > 0:
            return power, 0.98 * power - drag, 0.02 * power, drag
        return -power / 0.98 + drag, -power, -power / 0.98 + power, drag

    def test_energies(self) -> None:
        given = taken = teeth = 0.0
        for speed, torque, time in POINTS:
            flow = self.flow(speed, torque)
            given += 50 * time * flow[0]
            taken += 50 * time * flow[1]
            teeth += 50 * time * flow[2]

        self.assertAlmostEqual(self.duty["given"], given / 1000, delta=1e-10 * given)
        self.assertAlmostEqual(self.duty["taken"], taken / 1000, delta=1e-10 * given)
        self.assertAlmostEqual(self.duty["lost"], (given - taken) / 1000, delta=1e-10 * given)
        self.assertAlmostEqual(self.duty["efficiency"], taken / given, delta=1e-12)
        self.assertAlmostEqual(self.duty["meshes"]["m"]["lost"], teeth / 1000, delta=1e-10 * teeth)
        self.assertEqual(self.duty["at_rest"], 5000)

    def test_losses_of_bearing_and_drag(self) -> None:
        bearing = sum(50 * t * 0.02 * (w / 2.5) ** 2 for w, _, t in POINTS)
        drag = sum(50 * t * 3 * abs(w) / 2.5 for w, _, t in POINTS)

        self.assertAlmostEqual(self.duty["friction"]["b"]["lost"], bearing / 1000, delta=1e-9)
        self.assertAlmostEqual(self.duty["friction"]["B"]["lost"], drag / 1000, delta=1e-9)

    # Torque of the teeth: that of the pinion, and 2.5 times it on the wheel. Where the wheel drives,
    # the losses hold back the pinion, whose shaft then gets less than the teeth bring.
    def test_wear(self) -> None:
        turns = [abs(w) * t / (2 * math.pi) for w, _, t in POINTS]
        torques = [abs(m) if w * m > 0 else abs(m) / 0.98 for w, m, _ in POINTS]
        mean = sum(n * m ** 3 for n, m in zip(turns, torques)) / sum(turns)
        for body, factor in (("pinion", 1.0), ("wheel", 2.5)):
            wear = self.duty["gears"][f"m.{body}"]
            self.assertAlmostEqual(wear["revolutions"], 50 * sum(turns) / factor,
                                   delta=1e-9 * sum(turns))
            self.assertAlmostEqual(wear["largest"], factor * 40, delta=1e-10)
            self.assertAlmostEqual(wear["equivalent"], factor * mean ** (1 / 3), delta=1e-10)
        force = [m / 0.02 / math.cos(math.radians(20)) for m in torques]
        p = 10 / 3
        mean = sum(n * f ** p for n, f in zip(turns, force)) / sum(turns)
        self.assertAlmostEqual(self.duty["bearings"]["a"]["equivalent"], mean ** (1 / p), delta=1e-7)

    def test_points(self) -> None:
        for point, (speed, torque, time) in zip(self.duty["points"], POINTS):
            given, taken, _, _ = self.flow(speed, torque)
            self.assertAlmostEqual(point["given"], time * given / 1000, delta=1e-10 * given)
            self.assertAlmostEqual(point["taken"], time * taken / 1000, delta=1e-10 * given)
            self.assertLess(point["balance_residual"], 1e-12)
        self.assertEqual(self.duty["points"][5]["status"], "at_rest")

    def test_a_table_is_the_same(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            rows = ["duration [min],in [rpm],in [N*m]"]
            rows += [f"{time / 60},{speed * 30 / math.pi},{torque}" for speed, torque, time in POINTS]
            rows.append(f"{100 / 60},0,")
            begin, lines = 0.0, ["time [s],case,in [N*m],in [rad/s]"]
            for speed, torque, time in [*POINTS, (0, 0, 100), (0, 0, 0)]:
                lines.append(f"{begin},run,{torque},{speed}")
                begin += time
            for name, text in (("durations", rows), ("times", lines)):
                path = Path(folder) / f"{name}.csv"
                path.write_text("\n".join(text) + "\n", encoding="utf-8")
                table = program.run("duty", "-", "--cycle", str(path), text=PAIR)["duty"]
                for key in ("duration", "given", "taken", "lost", "efficiency"):
                    self.assertAlmostEqual(table[key], self.duty[key],
                                           delta=1e-12 * abs(self.duty[key]))


class Cases(unittest.TestCase):
    FILES = ["transmissions/ravigneaux_input_shaft", "transmissions/dual_clutch_six_speed",
             "transmissions/zf_8hp70", "transmissions/lepelletier_6hp26"]
    LOSSES = "losses: {gear_external: 0.015, gear_internal: 0.007}\n"

    def check(self, name: str, draw: random.Random) -> None:
        text = (MECHANISMS / f"{name}.yaml").read_text(encoding="utf-8")
        text = re.sub(r"^losses:.*\n(^ .*\n)*", "", text, flags=re.M)
        text = re.sub(r"^published:.*\n((^[ -].*)?\n)*", "", text, flags=re.M) + self.LOSSES
        text = re.sub(r"(type: (clutch|brake), [^}]*)\}", r"\1, friction: {tau: 0.2, c: 0.001}}", text)
        speed, torque = draw.uniform(20, 600), draw.uniform(5, 400)

        def with_input(torque: float) -> str:
            moved = re.sub(r"input_motion: [^,}\n]*", f"input_motion: {speed!r} rad/s", text)
            return re.sub(r"input_action: [^,}\n]*", f"input_action: {torque!r} N*m", moved)

        cases = program.report(program.call("shift", "-", text=with_input(torque)))
        gears = [name for name, state in cases["shift"]["states"].items()
                 if state["class"] == "gear"]
        self.assertTrue(gears)
        # Other magnitudes come first, so that what is compared follows from them.
        points = "".join(f"    - {{case: {gear}, duration: 1, input_motion: {share * speed!r} rad/s, "
                         f"input_action: {load * torque!r} N*m}}\n"
                         for gear in gears for share, load in
                         ((0.4, 0.3), (1.3, -1.7), (1, 1), (1, -1)))
        duty = program.run("duty", "-", text=text + "duty:\n  points:\n" + points)["duty"]
        analysed = program.report(program.call("analyze", "-", text=with_input(torque)))["cases"]
        for i, gear in enumerate(gears):
            with self.subTest(f"{name} {gear}"):
                power = analysed[gear]["power"]
                driven, coasting = duty["points"][4 * i + 2:4 * i + 4]
                self.assertAlmostEqual(driven["efficiency"], power["efficiency"]["carrier"],
                                       delta=1e-11)
                backward = power["efficiency"]["carrier_backward"]
                if backward is not None:
                    self.assertAlmostEqual(coasting["efficiency"], backward, delta=1e-11)
                for point in (driven, coasting):
                    self.assertLess(point["balance_residual"], 1e-11)

    def test_points_are_what_analysis_says(self) -> None:
        draw = random.Random(5)
        for name in self.FILES:
            for _ in range(2):
                self.check(name, draw)


# A wheel with a spring and a brake-like bearing, speeding up or not.
WHEEL = """kinestat: 1
space: planar
units: {length: mm}
ground: frame
bodies: {wheel: {mass: 1, centre_of_mass: [0, 0], inertia: 2}}
couplings:
  a: {type: revolute, bodies: [frame, wheel], at: [0, 0], friction: {c: 0.01}}
SPRINGS
actuators: {motor: {coupling: a}}
cases: {k: {motion: {motor: 2}, ACCELERATION action: {}, input: motor}}
duty: {case: k, points: [{input_motion: 2, duration: 1}, {input_motion: 4, duration: 3}]}
"""


class LoadsOfTheMechanism(unittest.TestCase):
    """Springs and inertia take what the motor gives beside c·ω²."""

    def check(self, torque: float, springs: str = "", acceleration: str = "") -> None:
        text = WHEEL.replace("SPRINGS", springs).replace("ACCELERATION", acceleration)
        duty = program.run("duty", "-", text=text)["duty"]
        for point, speed, time in zip(duty["points"], (2, 4), (1, 3)):
            self.assertAlmostEqual(point["given"], time * speed * (torque + 0.01 * speed))
            self.assertAlmostEqual(point["taken"], time * speed * torque)
            self.assertAlmostEqual(point["lost"], time * 0.01 * speed ** 2)

    def test_springs(self) -> None:
        self.check(5, springs="springs: {s: {coupling: a, stiffness: 10 N*m/rad, free: -0.5 rad}}")

    def test_inertia(self) -> None:
        self.check(6, acceleration="acceleration: {motor: 3},")

    def test_neither(self) -> None:
        self.check(0)


class Converter(unittest.TestCase):
    """An automatic with lossy teeth, drags and viscous bearings: its engine's torque decides the slip."""

    LOSSES = "losses: {gear_external: 0.015, gear_internal: 0.007}\n"

    def test_points_are_what_analysis_says(self) -> None:
        draw = random.Random(24)
        path = MECHANISMS / "transmissions" / "converter_automatic.yaml"
        text = path.read_text(encoding="utf-8")
        text = re.sub(r"^published:.*\n((^[ -].*)?\n)*", "", text, flags=re.M) + self.LOSSES
        text = re.sub(r"(type: (clutch|brake), [^}]*)\}", r"\1, friction: {tau: 2, c: 0.01}}", text)
        text = text.replace("[housing, pump]}", "[housing, pump], friction: {c: 0.1}}")
        text = text.replace("[housing, out]}", "[housing, out], friction: {c: 0.2}}")
        points = []
        for _ in range(60):
            n = draw.uniform(500, 2500)
            torque = draw.uniform(-0.1, 1.1) * 860 * 9.8 * 6.4e-6 * n * n * 0.43 ** 5
            points.append((n, torque, draw.uniform(1, 9)))
        driven = re.search(r"  driven:\n(    .*\n)*", text)
        cases = "".join(
            f"  p{i}: {{motion: {{engine: {n!r}, A: 0, D: 0}}, "
            f"action: {{engine: {torque!r}, L: 0, B: 0, C: 0}}, input: engine, output: out}}\n"
            for i, (n, torque, _) in enumerate(points))
        text = text.replace(driven.group(0), cases)
        with tempfile.TemporaryDirectory() as folder:
            cycle = Path(folder) / "cycle.csv"
            cycle.write_text("duration [s],case,engine [rpm],engine [N*m]\n" + "".join(
                f"{t!r},p0,{n!r},{torque!r}\n" for n, torque, t in points), encoding="utf-8")
            done = program.call("duty", "-", "--cycle", str(cycle), text=text)
        states = program.report(done)["duty"]["points"]
        analysed = program.report(program.call("analyze", "-", text=text))["cases"]
        answered = 0
        for i, (state, (n, torque, t)) in enumerate(zip(states, points)):
            power = analysed[f"p{i}"].get("power")
            if power is None:
                self.assertEqual(state["status"], "unanswered")
                continue
            answered += 1
            # Without losses in the teeth it is solved, with them it may be that nothing drives.
            if power["efficiency"]["carrier"] is None:
                continue
            self.assertAlmostEqual(state["given"] / 1000 / t, power["input"],  # [kW]
                                   delta=1e-9 * power["input"])
            self.assertAlmostEqual(state["efficiency"], power["efficiency"]["carrier"], delta=1e-11)
            self.assertLess(state["balance_residual"], 1e-11)
        self.assertGreater(answered, 15)
        self.assertLess(answered, 60)


# A planetary set whose three planets share the load unevenly.
PLANETS = """kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [sun, carrier, planet]
couplings:
  s: {type: revolute, bodies: [housing, sun]}
  c: {type: revolute, bodies: [housing, carrier]}
  p: {type: revolute, bodies: [carrier, planet]}
gears:
  module: 2 mm
  members:
    sun: {body: sun, teeth: 30}
    planet: {body: planet, teeth: 30, count: 3, load_sharing: SHARING}
    ring: {body: housing, teeth: 90, internal: true}
  meshes:
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
actuators: {in: {coupling: s}, out: {coupling: c}}
cases:
  run: {motion: {in: 100 rad/s}, action: {in: 90 N*m}, input: in, output: out}
duty:
  gear_exponent: 3
  bearing_exponent: 3
  points: [{case: run, duration: 10 s}]
"""


class UnevenPlanets(unittest.TestCase):
    def test_loads_are_those_of_the_most_loaded(self) -> None:
        """A third of 90 N m is 30 N m at the sun, 1.2 times that for the most loaded planet."""
        duty = program.run("duty", "-", text=PLANETS.replace("SHARING", "1.2"))["duty"]
        even = program.run("duty", "-", text=PLANETS.replace("SHARING", "1"))["duty"]
        for gear, torque in (("sp.sun", 36), ("sp.planet", 36), ("rp.planet", 36),
                             ("rp.housing", 108)):
            self.assertAlmostEqual(duty["gears"][gear]["largest"], torque)
            self.assertAlmostEqual(duty["gears"][gear]["equivalent"], torque)
            self.assertAlmostEqual(even["gears"][gear]["largest"], torque / 1.2)
        # The pin of a planet bears two forces of the teeth, each 30 N m / 30 mm.
        self.assertAlmostEqual(even["bearings"]["p"]["largest"], 2000)
        self.assertAlmostEqual(duty["bearings"]["p"]["largest"], 2400)
        # Three planets press the sun and the carrier from all sides.
        for bearing in ("s", "c"):
            self.assertEqual(even["bearings"][bearing]["largest"], 0)
            self.assertEqual(duty["bearings"][bearing]["largest"], 0)

    def test_bearings_of_a_pressed_shaft_bear_what_presses_it_beside_planets(self) -> None:
        """A belt on the carrier, whose planets cancel as those of the sun do."""
        text = PLANETS.replace("SHARING", "1").replace(
            "cases:", "loads: {belt: {body: carrier, at: [0, 0], force: [0, -70]}}\ncases:")
        bearings = program.run("duty", "-", text=text)["duty"]["bearings"]
        self.assertAlmostEqual(bearings["c"]["largest"], 70)
        self.assertEqual(bearings["s"]["largest"], 0)


# Two lay shafts in parallel share the power as their teeth happen to fit.
LAY_SHAFTS = """kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [i, o, l1, l2]
couplings:
  bi: {type: revolute, bodies: [housing, i]}
  bo: {type: revolute, bodies: [housing, o], friction: {tau: 0.5 N*m}}
  b1: {type: revolute, bodies: [housing, l1]}
  b2: {type: revolute, bodies: [housing, l2]}
  K: {type: clutch, bodies: [i, o]}
  B: {type: brake, bodies: [housing, o]}
gears:
  module: 2 mm
  members:
    gi: {body: i, teeth: 20}
    go: {body: o, teeth: 30}
    a1: {body: l1, teeth: 40}
    c1: {body: l1, teeth: 30}
    a2: {body: l2, teeth: 40}
    c2: {body: l2, teeth: 30}
  meshes:
    m1: {members: [gi, a1]}
    n1: {members: [c1, go]}
    m2: {members: [gi, a2]}
    n2: {members: [c2, go]}
actuators: {in: {coupling: bi}, out: {coupling: bo}}
cases:
  run: {motion: {in: 100}, action: {in: 20, K: 0, B: 0}, input: in, output: out}
"""


class OpenLoads(unittest.TestCase):
    def test_what_equilibrium_leaves_open_has_no_load(self) -> None:
        """Gears of the shafts bear tangential forces of 20 N m/20 mm and 39.5 N m + 0.5 N m of friction by 30 mm."""
        text = LAY_SHAFTS + """duty:
  gear_exponent: 6
  bearing_exponent: 3
  points: [{case: run, duration: 10}]
"""
        done = program.call("duty", "-", text=text)
        duty = program.report(done)["duty"]
        for name, gear in duty["gears"].items():
            self.assertIsNone(gear["largest"], name)
            self.assertIsNone(gear["equivalent"], name)
        for name in ("b1", "b2"):
            self.assertIsNone(duty["bearings"][name]["largest"])
            self.assertIsNone(duty["bearings"][name]["equivalent"])
        for name, force in (("bi", 20 / 0.02), ("bo", 40 / 0.03)):
            self.assertAlmostEqual(duty["bearings"][name]["largest"],
                                   force / math.cos(math.radians(20)), delta=1e-9 * force)
        self.assertAlmostEqual(duty["lost"], 0.5 * 50 * 10)
        self.assertEqual(done.stderr.count("W0601"), 1)
        self.assertIn("m2.Rc, n2.Rc (point 1)", done.stderr)

    def test_power_that_may_circulate_is_not_known(self) -> None:
        recirculation = program.run("analyze", "-", text=LAY_SHAFTS)["cases"]["run"]["power"]["recirculation"]
        self.assertIsNone(recirculation["factor"])
        rows, _ = swept(LAY_SHAFTS + "parameters: {q: 1}",
                        "{vary: {q: {values: [1, 2, 3]}}, report: [ratio, recirculation]}")
        self.assertEqual([round(row["ratio"], 12) for row in rows], [2.0] * 3)
        self.assertEqual([row["recirculation"] for row in rows], [None] * 3)

    def test_the_most_loaded_of_open_bearings_is_not_known(self) -> None:
        text = re.sub(r"cases:\n.*\n", "", LAY_SHAFTS) + """shift:
  {input: in, output: out, elements: [K, B], input_motion: 100, input_action: 20}
"""
        done = program.call("shift", "-", text=text)
        state = program.report(done)["shift"]["states"]["none"]
        for key in ("recirculation", "worst_bearing", "worst_mesh"):
            self.assertIsNone(state[key], key)
        self.assertIn("W0601", done.stderr)
        self.assertNotIn("'action:'", done.stderr)  # which a gear does not have

    def test_loads_of_a_belt_with_an_open_pretension(self) -> None:
        """Teeth press the sun with 50 N m/30 mm; a belt pulls at the bearings of its pulleys."""
        text = BELT
        bearings = program.run("duty", "-", text=text)["duty"]["bearings"]
        self.assertIsNone(bearings["c"]["largest"])
        self.assertIsNone(bearings["w"]["largest"])
        self.assertIsNone(bearings["w"]["equivalent"])
        self.assertAlmostEqual(bearings["s"]["largest"], 50 / 0.03 / math.cos(math.radians(20)))


BELT = """kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: [sun, ring, carrier, planet, wheel]
couplings:
  s: {type: revolute, bodies: [housing, sun]}
  r: {type: revolute, bodies: [housing, ring]}
  c: {type: revolute, bodies: [housing, carrier]}
  p: {type: revolute, bodies: [carrier, planet]}
  w: {type: revolute, bodies: [housing, wheel], at: [300, 0]}
  C: {type: clutch, bodies: [sun, ring]}
  B: {type: brake, bodies: [housing, ring]}
gears:
  module: 2 mm
  members:
    sun:    {body: sun, teeth: 30}
    planet: {body: planet, teeth: 20}
    ring:   {body: ring, teeth: 70, internal: true}
  meshes:
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
cables:
  belt:
    closed: true
    over:
      - {pulley: carrier, at: [0, 0], radius: 40, wrap: counterclockwise}
      - {pulley: wheel, radius: 80, wrap: counterclockwise}
losses: {gear_external: 0.02, gear_internal: 0.01}
actuators: {in: {coupling: s}, out: {coupling: w}}
shift:
  input: in
  output: out
  elements: [C, B]
  input_motion: 1500 rpm
  input_action: 50 N*m
  names: {M1: [B], M2: [C]}
duty:
  bearing_exponent: 3
  points: [{case: M1, duration: 10}]
"""

# A damper and friction on the shaft of the wheel, which a load brakes.
DAMPED = """kinestat: 1
space: planar
units: {length: mm}
ground: housing
bodies: {p: {inertia: 0.01}, w: {inertia: 0.5}}
couplings:
  a: {type: revolute, bodies: [housing, p]}
  b: {type: revolute, bodies: [housing, w], friction: {c: 0.02 N*m*s/rad}}
gears:
  module: 2 mm
  members: {gp: {body: p, teeth: 20}, gw: {body: w, teeth: 50}}
  meshes: {m: {members: [gp, gw]}}
losses: {gear_external: 0.02}
springs: {s: {coupling: b, stiffness: 0 N*m/rad, damping: 0.1 N*m*s/rad}}
actuators: {in: {coupling: a}, out: {coupling: b}}
loads: {l: {body: w, couple: 3 N*m}}
cases:
  run: {motion: {in: 100}, acceleration: {in: 50}, action: {in: 40}, input: in, output: out}
duty:
  points: [{case: run, duration: 20}, {case: run, duration: 10, input_action: 20}]
"""


class Dampers(unittest.TestCase):
    def test_lose_what_they_dissipate(self) -> None:
        """At 40 rad/s the damper takes 0.1 * 40^2 W, the bearing 0.02 * 40^2 W, the teeth 2 %."""
        duty = program.run("duty", "-", text=DAMPED.replace("acceleration: {in: 50}, ", ""))["duty"]
        lost = 20 * (0.02 * 4000 + 32 + 160) + 10 * (0.02 * 2000 + 32 + 160)
        self.assertAlmostEqual(duty["dampers"]["s"]["lost"], 30 * 160)
        self.assertAlmostEqual(duty["lost"], lost)
        self.assertAlmostEqual(duty["given"], 100_000)
        self.assertAlmostEqual(duty["taken"], 100_000 - lost)
        self.assertAlmostEqual(duty["efficiency"], 1 - lost / 100_000)
        self.assertNotIn("reason", duty)
        self.assertLess(duty["balance_residual"], 1e-12)

    def test_masses_that_are_sped_up_leave_no_efficiency(self) -> None:
        """Speeding up the pinion takes 0.01 * 50 N m, of which teeth lose nothing."""
        duty = program.run("duty", "-", text=DAMPED)["duty"]
        lost = 20 * (0.02 * 3950 + 32 + 160) + 10 * (0.02 * 1950 + 32 + 160)
        self.assertAlmostEqual(duty["lost"], lost)
        for one in (duty, duty["cases"]["run"], *duty["points"]):
            self.assertIsNone(one["efficiency"])
            self.assertIn("kinetic energy", one["reason"])


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
