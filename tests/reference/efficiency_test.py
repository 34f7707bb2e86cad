#!/usr/bin/env python3
"""Efficiencies with losses of meshes against two independent ways: closed forms, and the rule that a
loss η_k of a basic ratio i0k acts like another ratio, i0k η_k^sgn(w_k) with w_k = ∂ln i/∂ln i0k.

The rule needs velocities alone: they follow here from Willis' equations in exact numbers.

Usage: efficiency_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import permutations
from pathlib import Path

import program

MECHANISMS = Path()
EXACT = 1e-10


@dataclass
class Mesh:
    name: str
    first: str
    second: str
    teeth: tuple[int, int]
    loss: Fraction
    carrier: str
    is_internal: bool = False  # the first is a ring


@dataclass
class Train:
    """Central bodies turn about the origin, planets at a distance from it on their carriers."""
    central: list[str]
    meshes: list[Mesh]
    planets: dict[str, tuple[str, Fraction]] = field(default_factory=dict)  # carrier, distance

    def speeds(self, known: dict[str, Fraction], factor: dict[str, Fraction]) -> dict[str, Fraction]:
        """(ω_first - ω_carrier) = ∓ z_second/z_first factor (ω_second - ω_carrier)."""
        bodies = self.central + list(self.planets)
        rows = []
        for mesh in self.meshes:
            ratio = Fraction(mesh.teeth[1], mesh.teeth[0]) * factor.get(mesh.name, Fraction(1))
            ratio *= 1 if mesh.is_internal else -1
            row = {mesh.first: Fraction(1)}
            row[mesh.second] = row.get(mesh.second, Fraction(0)) - ratio
            row[mesh.carrier] = row.get(mesh.carrier, Fraction(0)) + ratio - 1
            rows.append([row.get(body, Fraction(0)) for body in bodies] + [Fraction(0)])
        for body, speed in known.items():
            rows.append([Fraction(int(body == other)) for other in bodies] + [speed])
        return dict(zip(bodies, solve(rows)))

    def ratio(self, drive: str, driven: str, held: dict[str, Fraction],
              factor: dict[str, Fraction]) -> Fraction | None:
        speeds = self.speeds(held | {drive: Fraction(1)}, factor)
        return 1 / speeds[driven] if speeds[driven] != 0 else None

    def efficiency(self, drive: str, driven: str, held: dict[str, Fraction]) -> Fraction:
        ideal = self.ratio(drive, driven, held, {})
        small = Fraction(1, 10**12)
        factor = {}
        for mesh in self.meshes:
            moved = self.ratio(drive, driven, held, {mesh.name: 1 + small})
            slope = (moved - ideal) / ideal
            kept = 1 - mesh.loss
            factor[mesh.name] = kept if slope > 0 else 1 / kept if slope < 0 else Fraction(1)
        lossy = self.ratio(drive, driven, held, factor)
        return lossy / ideal if lossy is not None else Fraction(0)

    def text(self, cases: str) -> str:
        lines = ["kinestat: 1", "space: planar", "ground: housing",
                 f"bodies: [{', '.join([*self.central[1:], *self.planets])}]", "couplings:"]
        lines += [f"  b{body}: {{type: revolute, bodies: [housing, {body}], at: [0, 0]}}"
                  for body in self.central[1:]]
        at = {body: Fraction(0) for body in self.central}
        for planet, (carrier, distance) in self.planets.items():
            at[planet] = distance
            lines.append(f"  b{planet}: {{type: revolute, bodies: [{carrier}, {planet}], "
                         f"at: [0, {float(distance)!r}]}}")
        for mesh in self.meshes:
            first, second = mesh.teeth
            share = Fraction(first, first - second if mesh.is_internal else first + second)
            point = at[mesh.first] + (at[mesh.second] - at[mesh.first]) * share
            lines.append(f"  {mesh.name}: {{type: gear, bodies: [{mesh.first}, {mesh.second}], "
                         f"at: [0, {float(point)!r}], tangent: x, pressure_angle: 20 deg, "
                         f"internal: {str(mesh.is_internal).lower()}}}")
        lines.append("actuators:")
        lines += [f"  T{body}: {{coupling: b{body}}}" for body in self.central[1:]]
        lines.append("losses:\n  meshes:")
        lines += [f"    {mesh.name}: {float(mesh.loss)!r}" for mesh in self.meshes]
        return "\n".join(lines) + f"\ncases:\n{cases}"


def solve(rows: list[list[Fraction]]) -> list[Fraction]:
    """Gauss-Jordan, in exact numbers."""
    size = len(rows[0]) - 1
    for column in range(size):
        pivot = next(r for r in range(column, len(rows)) if rows[r][column] != 0)
        rows[column], rows[pivot] = rows[pivot], rows[column]
        rows[column] = [value / rows[column][column] for value in rows[column]]
        for r, row in enumerate(rows):
            if r != column and row[column] != 0:
                rows[r] = [a - row[column] * b for a, b in zip(row, rows[column])]
    return [row[size] for row in rows[:size]]


def case_text(label: str, drive: str, driven: str, train: Train, held: list[str]) -> str:
    free = [body for body in train.central[1:] if body not in (drive, driven, *held)]
    motion = ", ".join([f"T{drive}: 1"] + [f"T{body}: 0" for body in held])
    action = ", ".join([f"T{drive}: 100"] + [f"T{body}: 0" for body in free])
    return (f"  {label}: {{motion: {{{motion}}}, action: {{{action}}}, input: T{drive}, "
            f"output: T{driven}}}\n")


def powers_of(text: str) -> dict[str, dict]:
    cases = program.report(program.call("analyze", "-", text=text))["cases"]
    return {label: case["power"] for label, case in cases.items() if "power" in case}


def simple_set(sun: int, ring: int, losses: tuple[str, str]) -> Train:
    planet = (ring - sun) // 2
    return Train(
        ["housing", "S", "C", "R"],
        [Mesh("s", "S", "P", (sun, planet), Fraction(losses[0]), "C"),
         Mesh("r", "R", "P", (ring, planet), Fraction(losses[1]), "C", is_internal=True)],
        {"P": ("C", Fraction(sun + planet, 2))})


def stepped_set(teeth: tuple[int, int, int, int], is_internal: bool) -> Train:
    """Sun and planet, then the other step of the planet and another sun or a ring."""
    distance = Fraction(teeth[0] + teeth[1], 2)
    return Train(
        ["housing", "S", "C", "R"],
        [Mesh("s", "S", "P", teeth[:2], Fraction("0.02"), "C"),
         Mesh("r", "R", "P", (teeth[3], teeth[2]), Fraction("0.01"), "C", is_internal)],
        {"P": ("C", distance)})


def ravigneaux() -> Train:
    external, internal = Fraction("0.02"), Fraction("0.01")
    return Train(
        ["housing", "A", "B", "R", "C"],
        [Mesh("h", "A", "P5", (19, 15), external, "C"),
         Mesh("i", "P6", "P5", (14, 15), external, "C"),
         Mesh("j", "B", "P6", (41, 22), external, "C"),
         Mesh("k", "R", "P6", (85, 22), internal, "C", is_internal=True)],
        {"P5": ("C", Fraction(17)), "P6": ("C", Fraction(63, 2))})


def simpson() -> Train:
    """Two sets with a common sun; the carrier of the first turns with the ring of the second."""
    return Train(
        ["housing", "S", "A", "B", "C"],
        [Mesh("s1", "S", "P", (35, 19), Fraction("0.02"), "A"),
         Mesh("r1", "B", "P", (73, 19), Fraction("0.01"), "A", is_internal=True),
         Mesh("s2", "S", "Q", (31, 26), Fraction("0.03"), "C"),
         Mesh("r2", "A", "Q", (83, 26), Fraction("0.015"), "C", is_internal=True)],
        {"P": ("A", Fraction(27)), "Q": ("C", Fraction(57, 2))})


class Rule(unittest.TestCase):
    """The independent way, with one input and one output."""

    def check(self, train: Train, held_count: int = 1) -> None:
        cases = {}
        for chosen in permutations(train.central[1:], 2 + held_count):
            drive, driven, *held = chosen
            if list(held) == sorted(held):
                cases["_".join(chosen)] = (drive, driven, held)
        text = train.text("".join(case_text(label, *case[:2], train, case[2])
                                  for label, case in cases.items()))
        powers = powers_of(text)
        for label, (drive, driven, held) in cases.items():
            with self.subTest(label):
                rest = {body: Fraction(0) for body in ["housing", *held]}
                self.compare(powers[label], train.efficiency(drive, driven, rest),
                             train.efficiency(driven, drive, rest))
                self.check_state(powers[label], drive, driven)

    def compare(self, power: dict, forward: Fraction, backward: Fraction) -> None:
        shares = power["efficiency"]
        for name, expected in (("carrier", forward), ("carrier_backward", backward)):
            if expected > 0:
                self.assertIsNotNone(shares[name], shares)
                self.assertAlmostEqual(shares[name], float(expected), delta=EXACT)
                self.assertNotIn(name, shares.get("self_locking", []))
            else:
                self.assertIsNone(shares[name])
                self.assertIn(name, shares["self_locking"])
                self.assertIn("exceed the power of the inputs", shares["reasons"][name])

    def check_state(self, power: dict, drive: str, driven: str) -> None:
        """The losses are what the output lacks."""
        shares = power["efficiency"]
        if shares["carrier"] is None:
            return
        lost = -sum(mesh["power"] for mesh in power["losses"]["meshes"].values())
        self.assertAlmostEqual(lost, power["input"] * (1 - shares["carrier"]),
                               delta=1e-9 * power["input"])
        self.assertLess(power["losses"]["balance_residual"], 1e-9)
        torques = power["losses"]["actuators"]
        speed = {name: power["actuators"][name] / torque for name, torque in
                 ideal_torques(power, drive, driven).items()}
        self.assertAlmostEqual(-torques[f"T{driven}"] * speed[f"T{driven}"] / power["input"],
                               shares["carrier"], delta=EXACT)

    def test_simple_set_all_six_ways(self) -> None:
        self.check(simple_set(20, 80, ("0.03", "0")))

    def test_simple_set_with_two_losses(self) -> None:
        for sun, ring in ((18, 54), (30, 78), (37, 71), (23, 85)):
            self.check(simple_set(sun, ring, ("0.02", "0.01")))

    def test_stepped_planet_between_sun_and_ring(self) -> None:
        self.check(stepped_set((19, 31, 17, 67), is_internal=True))

    def test_stepped_planet_between_two_suns(self) -> None:
        self.check(stepped_set((20, 30, 20, 30), is_internal=False))
        self.check(stepped_set((30, 20, 22, 28), is_internal=False))

    def test_ratios_near_one_lock_in_one_direction(self) -> None:
        self.check(stepped_set((100, 99, 100, 100), is_internal=False))
        self.check(stepped_set((99, 100, 100, 100), is_internal=False))

    def test_ravigneaux_with_every_member_held_and_another_free(self) -> None:
        self.check(ravigneaux())

    def test_two_coupled_sets(self) -> None:
        self.check(simpson())


def ideal_torques(power: dict, drive: str, driven: str) -> dict[str, float]:
    """The drive has 100 N*m at 1 rad/s; the output's torque without losses follows from its power
    and from its lossy torque by the efficiency."""
    ideal = power["losses"]["actuators"][f"T{driven}"] / power["efficiency"]["carrier"]
    return {f"T{drive}": 100.0, f"T{driven}": ideal}


DRAGS = """kinestat: 1
space: planar
units: {length: mm}
parameters: {w: 100 rad/s}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  s: {type: revolute, bodies: [housing, sun]}
  r: {type: revolute, bodies: [housing, ring], friction: {tau: 0.1 N*m, c: 0.001}}
  c: {type: revolute, bodies: [housing, carrier]}
  p: {type: revolute, bodies: [carrier, planet]PLANET}
  C: {type: clutch, bodies: [sun, ring], friction: DRAG}
  B: {type: brake, bodies: [housing, ring], friction: DRAG}
gears:
  module: 2 mm
  members:
    sun: {body: sun, teeth: 30}
    planet: {body: planet, teeth: 20}
    ring: {body: ring, teeth: 70, internal: true}
  meshes:
    sp: {members: [sun, planet], carrier: carrier}
    rp: {members: [ring, planet], carrier: carrier}
actuators: {in: {coupling: s}, out: {coupling: c}}
losses: {gear_external: 0.01}
shift: {input: in, output: out, elements: [C, B], input_motion: 1500 rpm, input_action: 50 N*m,
        names: {M1: [B], M2: [C]}}
"""


class ClosedForms(unittest.TestCase):
    # i0 = -4, η0 = 0.97
    def test_simple_set(self) -> None:
        train = simple_set(20, 80, ("0.03", "0"))
        cases = {"S C R": Fraction(122, 125), "C S R": Fraction(485, 497),
                 "R C S": Fraction(497, 500), "C R S": Fraction(485, 488)}
        text = train.text("".join(
            case_text(label.replace(" ", "_"), *label.split()[:2], train, label.split()[2:])
            for label in cases))

        powers = powers_of(text)

        for label, expected in cases.items():
            self.assertAlmostEqual(powers[label.replace(" ", "_")]["efficiency"]["carrier"],
                                   float(expected), delta=1e-12)

    def test_fixed_axes_multiply(self) -> None:
        power = powers_of(PAIR.format(bearing="", more="losses: {gear_external: 0.02}"))["run"]

        self.assertAlmostEqual(power["efficiency"]["carrier"], 0.98, delta=1e-12)
        self.assertAlmostEqual(power["efficiency"]["absolute"], 0.98, delta=1e-12)
        self.assertAlmostEqual(power["efficiency"]["carrier_backward"], 0.98, delta=1e-12)

    # The wheel of radius 2 turns with 1 rad/s: its pitch point moves with 2 m/s. Where it drives, its
    # torque is that of the teeth; where it is driven, the teeth bring 1/(1 - s) times as much, and
    # the share s of what they lose follows from that.
    def test_losses_that_depend_on_speed_and_force(self) -> None:
        def share(force: float) -> float:
            return 0.02 + 0.03 * math.exp(-2 / 4) + 0.01 * (force / 50) ** 0.4

        losses = "0.02 + 0.03*exp(-speed/(4 m/s)) + 0.01*(force/(50 N))^0.4"
        driven = 0.0
        for _ in range(100):
            driven = share(100 / 2 / (1 - driven))

        for loss in (losses, f"{{eta: 1 - ({losses})}}"):
            power = powers_of(PAIR.format(bearing="", more=f"losses: {{gear_external: {loss}}}"))
            shares = power["run"]["efficiency"]
            self.assertAlmostEqual(shares["carrier"], 1 - share(50), delta=1e-12)
            self.assertAlmostEqual(shares["carrier_backward"], 1 - driven, delta=1e-12)
            self.assertIsNone(shares["absolute"])
            self.assertIn("depend on speed", shares["reasons"]["absolute"])

    def test_losses_without_a_value(self) -> None:
        for loss in ("0.02/(speed - 2 m/s)*(1 m/s)", "force/(40 N)", "0.01 - speed/(100 m/s)"):
            power = powers_of(PAIR.format(bearing="", more=f"losses: {{gear_external: {loss}}}"))
            shares = power["run"]["efficiency"]
            self.assertIsNone(shares["carrier"], loss)
            self.assertIn("no value", shares["reasons"]["carrier"])

    # A ring held by brake B: the open clutch C between sun and ring takes D(ω) from the sun's torque
    # and gives it to the brake, so that (T - D)/T of the power passes the teeth, which take 0.7 % of
    # it. In direct drive B drags the ring, and its bearing too; the planets are at rest.
    def test_drags_of_open_elements_and_of_bearings(self) -> None:
        torque, speed = 50.0, 1500 * math.pi / 30
        cases = {"{tau: 2 N*m}": lambda w: 2.0,
                 "{c: 0.01 N*m*s/rad}": lambda w: 0.01 * w,
                 "{tau: 0.5, c: 0.01}": lambda w: 0.5 + 0.01 * w,
                 "{tau: 3 N*m*exp(-speed/w), c: 0.01}": lambda w: 3 * math.exp(-w / 100) + 0.01 * w,
                 "{tau: 0.1 N*m + 1e-5 N*m*s^2/rad^2 * speed^2}": lambda w: 0.1 + 1e-5 * w * w}
        bearing = 0.1 + 0.001 * speed
        for text, drag in cases.items():
            with self.subTest(text):
                file = DRAGS.replace("DRAG", text)
                report = program.run("analyze", "-", text=file.replace("PLANET", ""))["cases"]
                passed = (torque - drag(speed)) / torque
                direct = (torque - drag(speed) - bearing) / torque
                powers = {label: report[label]["power"] for label in ("M1", "M2")}
                self.assertAlmostEqual(powers["M1"]["efficiency"]["carrier"], 0.993 * passed,
                                       delta=1e-12)
                self.assertAlmostEqual(powers["M2"]["efficiency"]["carrier"], direct, delta=1e-12)
                lossy = powers["M1"]["losses"]["actuators"]
                ring = torque - drag(speed) - 0.993 * (torque - drag(speed)) * 10 / 3
                self.assertAlmostEqual(abs(lossy["B"]), abs(ring + drag(speed)), delta=1e-10)
                rubbing = file.replace("PLANET", ", friction: {mu: 0.01, radius: 5}")
                direct_there = program.run("analyze", "-", text=rubbing)["cases"]["M2"]["power"]
                self.assertAlmostEqual(direct_there["efficiency"]["carrier"], direct, delta=1e-12)

    # Each journal is pressed by the force F of the teeth: T_in = F (cos α r_a + μ r), and
    # T_out = F (η cos α r_b - μ r).
    def test_friction_of_bearings_adds_to_that_of_teeth(self) -> None:
        text = PAIR.format(bearing=", friction: {mu: 0.1, radius: 0.2}",
                           more="losses: {gear_external: 0.02}")
        arm, friction = math.cos(0.35), 0.1 * 0.2
        force = 100 / (arm * 2 + friction)
        expected = (0.98 * force * arm * 1 - friction * force) * 2 / 100

        power = powers_of(text)["run"]

        self.assertAlmostEqual(power["efficiency"]["carrier"], expected, delta=1e-12)
        self.assertAlmostEqual(power["efficiency"]["friction"],
                               (force * arm - friction * force) * 2 / 100, delta=1e-12)
        lost = sum(power["losses"]["friction"].values()) + power["losses"]["meshes"]["g"]["power"]
        self.assertAlmostEqual(1 + lost / 100, expected, delta=1e-12)
        # Seen from the ground: what the first journal leaves, then the teeth, then the second.
        given = arm * 2 * force
        self.assertAlmostEqual(power["efficiency"]["absolute"],
                               0.98 * (given - 2 * friction * force) / 100, delta=1e-12)

    def test_losses_of_nothing(self) -> None:
        power = powers_of(PAIR.format(bearing="", more="losses: {gear_external: 0}"))["run"]

        for value in ("carrier", "carrier_backward", "absolute"):
            self.assertAlmostEqual(power["efficiency"][value], 1, delta=1e-12)
        self.assertEqual(power["losses"]["meshes"]["g"]["power"], 0)
        self.assertNotIn("driven", power["losses"]["meshes"]["g"])

    # At i0 = η0 the sun gives all that the teeth take.
    def test_efficiency_of_exactly_zero(self) -> None:
        train = stepped_set((100, 97, 100, 100), is_internal=False)
        train.meshes[0].loss, train.meshes[1].loss = Fraction("0.03"), Fraction(0)
        shares = powers_of(train.text(case_text("run", "S", "C", train, ["R"])))["run"]["efficiency"]

        self.assertIn("carrier", shares["self_locking"])
        self.assertIn("losses absorb", shares["reasons"]["carrier"])
        self.assertIn(shares["carrier"], (None, 0.0))

    def test_train_that_turns_as_a_block(self) -> None:
        train = ravigneaux()
        text = train.text("  run: {motion: {TA: 1, TB: 1}, action: {TR: -100, TC: 0}, "
                          "input: [TA, TB], output: TR}\n")

        power = powers_of(text)["run"]

        self.assertAlmostEqual(power["efficiency"]["carrier"], 1.0, delta=1e-12)
        self.assertAlmostEqual(power["efficiency"]["absolute"], 0.939918, delta=1e-6)
        self.assertEqual({mesh["rolls"] for mesh in power["losses"]["meshes"].values()}, {False})


PAIR = """kinestat: 1
space: planar
ground: frame
bodies: [wheel, pinion]
couplings:
  a: {{type: revolute, bodies: [frame, wheel], at: [0, 0]{bearing}}}
  b: {{type: revolute, bodies: [frame, pinion], at: [0, 3]{bearing}}}
  g: {{type: gear, bodies: [wheel, pinion], at: [0, 2], tangent: x, pressure_angle: 0.35}}
actuators: {{in: {{coupling: a}}, out: {{coupling: b}}}}
cases:
  run: {{motion: {{in: 1}}, action: {{in: 100}}, input: in, output: out}}
  backwards: {{motion: {{in: 1}}, action: {{in: -100}}, input: in, output: out}}
  idle: {{motion: {{in: 1}}, action: {{in: 0}}, input: in, output: out}}
  at rest: {{motion: {{in: 0}}, action: {{in: 100}}, input: in, output: out}}
  unnamed: {{motion: {{in: 1}}, action: {{in: 100}}}}
  wind: {{motion: {{in: 1}}, action: {{in: 100}}, input: in, output: out,
         loads: {{w: {{body: pinion, couple: 5}}}}}}
{more}
"""


class Answers(unittest.TestCase):
    """Where there is no efficiency there is a reason."""

    def setUp(self) -> None:
        self.powers = powers_of(PAIR.format(bearing="", more="losses: {gear_external: 0.02}"))

    def check(self, case: str, reason: str) -> None:
        shares = self.powers[case]["efficiency"]
        for name in ("carrier", "carrier_backward", "absolute"):
            self.assertIsNone(shares[name])
            self.assertIn(reason, shares["reasons"][name])
        self.assertNotIn("self_locking", shares)

    def test_input_that_takes_power(self) -> None:
        self.check("backwards", "the inputs absorb power: the outputs drive")
        self.assertEqual(self.powers["backwards"]["absorbing_inputs"], ["in"])
        self.assertNotIn("absorbing_inputs", self.powers["run"])

    def test_input_that_takes_power_without_losses(self) -> None:
        text = PAIR.format(bearing="", more="").replace("idle:", (
            "both: {motion: {in: 1}, action: {in: -100}, input: [in, out]}\n  idle:"))
        for case, inputs in (("run", None), ("backwards", ["in"]), ("both", ["in"])):
            self.assertEqual(powers_of(text)[case].get("absorbing_inputs"), inputs, case)

    def test_input_without_torque(self) -> None:
        self.check("idle", "the inputs supply no power")

    def test_input_at_rest(self) -> None:
        self.check("at rest", "the inputs supply no power")

    def test_case_without_input(self) -> None:
        self.check("unnamed", "does not name input and output")
        self.assertAlmostEqual(self.powers["unnamed"]["losses"]["meshes"]["g"]["power"], -2,
                               delta=1e-12)

    def test_load_that_drives(self) -> None:
        self.check("wind", "load 'w' also supplies or absorbs power")

    # Two planets share the load in a proportion that equilibrium does not tell.
    def test_forces_that_equilibrium_leaves_open(self) -> None:
        train = simple_set(20, 80, ("0.03", "0.01"))
        train.planets["Q"] = ("C", Fraction(-50))
        train.meshes += [Mesh("t", "S", "Q", (20, 30), Fraction("0.03"), "C"),
                         Mesh("u", "R", "Q", (80, 30), Fraction("0.01"), "C", is_internal=True)]

        power = powers_of(train.text(case_text("run", "S", "C", train, ["R"])))["run"]

        for name in ("carrier", "carrier_backward"):
            self.assertIsNone(power["efficiency"][name])
            self.assertIn("equilibrium does not determine", power["efficiency"]["reasons"][name])
        self.assertIsNone(power["efficiency"]["absolute"])
        self.assertNotIn("losses", power)


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
