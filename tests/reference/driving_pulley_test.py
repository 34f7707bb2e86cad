#!/usr/bin/env python3
"""Pulleys with an 'eta' that drive their rope, or are driven by it.

Idle, a pulley leaves eta of the tension T_a ahead in the strand behind: N = T_b - eta T_a = 0. Any
other N is a couple at its rim. Of one that the rope drives, N is what comes out; one that drives
takes N/eta, as a drum of a single strand does. So the couple is r max(N, N/eta), and the loss
(1 - eta) r max(T_a, T_b/eta).

Usage: driving_pulley_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import itertools
import json
import math
import random
import sys
import unittest

import program
import motion_case
import simulation_test as simulations
from reference_test_case import ReferenceTest

G = 9.81


def couple(eta: float, ahead: float, behind: float, radius: float = 1.0) -> float:
    """That of the drive, in the direction of the motion."""
    net = radius * (behind - eta * ahead)
    return max(net, net / eta)


def loss(eta: float, ahead: float, behind: float, radius: float = 1.0) -> float:
    return (1 - eta) * radius * max(ahead, behind / eta)


def sheave(rest: str, station: str = "eta: 0.9", bodies: str = "[left, right, wheel]",
           radius: float = 0.1) -> str:
    """A rope over a wheel: turned clockwise, it runs up on the left and down on the right."""
    return f"""\
kinestat: 1
space: planar
ground: frame
bodies: {bodies}
couplings:
  L: {{type: prismatic, bodies: [frame, left], at: [{-radius}, -5], axis: y}}
  R: {{type: prismatic, bodies: [frame, right], at: [{radius}, -5], axis: y}}
  W: {{type: revolute, bodies: [frame, wheel], at: [0, 0]}}
cables:
  rope: {{over: [{{body: left, at: [{-radius}, -5]}},
                {{pulley: wheel, radius: {radius}, wrap: clockwise, {station}}},
                {{body: right, at: [{radius}, -5]}}]}}
{rest}
"""


def belt(etas: tuple[float, float], radii: tuple[float, float], crossed: bool, case: str) -> str:
    other = "counterclockwise" if crossed else "clockwise"
    return f"""\
kinestat: 1
space: planar
ground: frame
bodies: [driver, driven]
couplings:
  A: {{type: revolute, bodies: [frame, driver], at: [0, 0]}}
  B: {{type: revolute, bodies: [frame, driven], at: [7, 0]}}
cables:
  belt:
    closed: true
    over:
      - {{pulley: driver, radius: {radii[0]}, wrap: clockwise, eta: {etas[0]}}}
      - {{pulley: driven, radius: {radii[1]}, wrap: {other}, eta: {etas[1]}}}
actuators: {{in: {{coupling: A}}, out: {{coupling: B}}}}
cases: {{one: {case}}}
"""


MACHINES = "actuators: {left: {coupling: L}, right: {coupling: R}, motor: {coupling: W}}\n"
TENSIONS = ((100.0, 1.0), (100.0, 50.0), (100.0, 88.0), (100.0, 90.0), (100.0, 94.0),
            (100.0, 100.0), (94.0, 100.0), (90.0, 100.0), (50.0, 100.0), (0.0, 100.0))
ETAS = (0.99, 0.9, 0.6, 0.3)


class Statics(ReferenceTest):
    def test_couple_of_a_sheave(self) -> None:
        for eta, (left, right), turns in itertools.product(ETAS, TENSIONS, (-1, 1)):
            with self.subTest(eta=eta, left=left, right=right, turns=turns):
                ahead, behind = (right, left) if turns < 0 else (left, right)
                case = program.run("analyze", "-", text=sheave(
                    f"{MACHINES}cases: {{one: {{motion: {{motor: {3 * turns}}}, "
                    f"action: {{left: {-left}, right: {-right}}}}}}}",
                    f"eta: {eta}"))["cases"]["one"]["statics"]
                self.near(case["actions"]["motor"] * turns, couple(eta, ahead, behind, 0.1),
                          "motor", 10.0)
                lost = [one["couple"] for one in case["friction"].values()]
                self.near_all(lost, [loss(eta, ahead, behind, 0.1)])

    def test_tension_for_a_couple(self) -> None:
        """Of one strand and the couple the other follows, whichever is given."""
        for eta, (ahead, behind) in itertools.product(ETAS, TENSIONS):
            given = couple(eta, ahead, behind, 0.1)
            for known, value in (("left", behind), ("right", ahead)):
                with self.subTest(eta=eta, ahead=ahead, behind=behind, known=known):
                    found = program.run("analyze", "-", text=sheave(
                        f"{MACHINES}cases: {{one: {{motion: {{motor: -3}}, "
                        f"action: {{{known}: {-value}, motor: {-given}}}}}}}",
                        f"eta: {eta}"))["cases"]["one"]["statics"]["actions"]
                    self.near(found["rope_1.F"], behind, "behind", 100.0 / eta)
                    self.near(found["rope_2.F"], ahead, "ahead", 100.0 / eta)

    def test_row_of_sheaves_some_of_which_drive(self) -> None:
        """Tensions follow from strand to strand, from either end, and there is no other answer."""
        draw = random.Random(5)
        for count, runs_right, at_left in itertools.product(
                (2, 3, 5, 7), (False, True), (False, True)):
            etas = [draw.choice(ETAS) for _ in range(count)]
            tensions = [draw.uniform(50.0, 150.0) for _ in range(count + 1)]
            couples = []
            for eta, left, right in zip(etas, tensions, tensions[1:]):
                ahead, behind = (right, left) if runs_right else (left, right)
                couples.append(couple(eta, ahead, behind, 0.1))
            ends_above = count % 2 == 1
            known = (f"left: {-tensions[0]!r}" if at_left
                     else f"right: {-tensions[-1] if ends_above else tensions[-1]!r}")
            with self.subTest(etas=etas, runs_right=runs_right, at_left=at_left):
                done = program.call("analyze", "-", text=row_of_sheaves(
                    etas, couples, known, runs_right))
                self.assertEqual(done.stderr, "")
                actions = program.report(done)["cases"]["one"]["statics"]["actions"]
                for i, tension in enumerate(tensions):
                    self.near(actions[f"rope_{i + 1}.F"], tension, f"strand {i}", 1e5)

    def test_slack_strand_is_none(self) -> None:
        """A drum of a single strand, winding up and letting out, is the limit without tension."""
        for eta, turns in itertools.product(ETAS, (-1, 1)):
            with self.subTest(eta=eta, turns=turns):
                given = f"motion: {{motor: {turns}}}"
                text = sheave(f"{MACHINES}cases: {{one: {{{given}, "
                              f"action: {{left: -100, right: 0}}}}}}", f"eta: {eta}")
                drum = (text.replace(",\n                {body: right, at: [0.1, -5]}", "")
                        .replace("{body: left, at: [-0.1, -5]},\n                ", "")
                        .replace("[{pulley", "[{body: left, at: [-0.1, -5]}, {pulley")
                        .replace(", right: 0", "").replace(" right: {coupling: R},", "")
                        .replace("left, right, wheel", "left, wheel")
                        .replace("  R: {type: prismatic, bodies: [frame, right], at: [0.1, -5], "
                                 "axis: y}\n", ""))
                torques = [program.run("analyze", "-", text=one)["cases"]["one"]["statics"]
                           ["actions"]["motor"] for one in (text, drum)]
                self.near_all(torques, [-10.0 * (eta if turns > 0 else 1 / eta)] * 2)

    def test_belt(self) -> None:
        """The driver draws in the tight strand, the driven pulley lets it out."""
        for etas, crossed, slack, pull in itertools.product(
                ((0.95, 0.9), (0.7, 1.0), (1.0, 0.6)), (False, True), (0.0, 5.0, 200.0),
                (10.0, 100.0)):
            with self.subTest(etas=etas, crossed=crossed, slack=slack, pull=pull):
                radii, tight = (1.0, 2.0), slack + pull
                torque = couple(etas[0], slack, tight, radii[0])
                case = program.run("analyze", "-", text=belt(
                    etas, radii, crossed,
                    f"{{motion: {{in: -2}}, action: {{in: {-torque}, belt_1.F: {slack}}}, "
                    "input: in, output: out}"))["cases"]["one"]
                actions = case["statics"]["actions"]
                self.near(actions["belt_2.F"], tight, "tight", 300.0)
                sense = 1 if crossed else -1
                # Held back, it gives off; where a slack belt rubs it more than pulls, it is driven.
                out = couple(etas[1], tight, slack, radii[1])
                self.near(actions["out"], -sense * -out, "out", 600.0)
                if out < 0:
                    self.near(case["power"]["efficiency"]["friction"],
                              -out / radii[1] / (torque / radii[0]), "efficiency")

    def test_belt_that_is_driven_back(self) -> None:
        """By what the output drives under the same couple of the pinion and slack tension."""
        slack, torque, etas, radii, teeth = 40.0, 60.0, (0.95, 0.9), (1.0, 2.0), 0.98
        text = (belt(etas, radii, False, f"{{motion: {{pin: 10}}, action: {{pin: {torque / 5}, "
                                         f"belt_1.F: {slack}}}, input: pin, output: out}}")
                .replace("[driver, driven]", "[pinion, driver, driven]")
                .replace("driver], at: [0, 0]}", "driver]}\n"
                         "  P: {type: revolute, bodies: [frame, pinion]}")
                .replace("{pulley: driver,", "{pulley: driver, at: [0, 0],")
                .replace("in: {coupling: A}", "pin: {coupling: P}")) + f"""\
gears:
  module: 10 mm
  members: {{z1: {{body: pinion, teeth: 20, centre_distance: 0.6}}, z2: {{body: driver, teeth: 100}}}}
  meshes: {{m: {{members: [z1, z2]}}}}
losses: {{gear_external: {1 - teeth}}}
"""
        efficiency = program.run("analyze", "-", text=text)["cases"]["one"]["power"]["efficiency"]
        tight = etas[0] * (torque * teeth + slack)
        self.near(efficiency["carrier"], (etas[1] * tight - slack) / torque, "forwards")
        tight = (torque / teeth + slack) / etas[0]
        self.near(efficiency["carrier_backward"], torque / (tight / etas[1] - slack), "back")

    def test_lift_with_a_counterweight(self) -> None:
        for eta, turns in itertools.product((0.95, 0.8), (-1, 1)):
            with self.subTest(eta=eta, turns=turns):
                load, other = 900.0, 500.0
                case = program.run("analyze", "-", text=sheave(f"""\
loads: {{load: {{body: left, at: [-0.1, -5], force: [0, {-load}]}},
        other: {{body: right, at: [0.1, -5], force: [0, {-other}]}}}}
actuators: {{motor: {{coupling: W}}}}
cases: {{up: {{motion: {{motor: {3 * turns}}}}}}}""", f"eta: {eta}"))["cases"]["up"]
                tensions = (other, load) if turns < 0 else (load, other)
                self.near(case["statics"]["actions"]["motor"], turns * couple(eta, *tensions, 0.1),
                          "motor", 100.0)
                self.near(case["power"]["friction"]["W"], -3 * loss(eta, *tensions, 0.1), "lost",
                          100.0)

    def test_gears_turn_the_sheave(self) -> None:
        """The teeth are what drives, and lose their own share."""
        for eta, turns in itertools.product((0.95, 0.6), (-1, 1)):
            with self.subTest(eta=eta, turns=turns):
                ahead, behind = (50.0, 100.0) if turns < 0 else (100.0, 50.0)
                text = sheave(f"""\
gears:
  module: 10 mm
  members: {{z1: {{body: pinion, teeth: 20, centre_distance: 0.6}}, z2: {{body: wheel, teeth: 100}}}}
  meshes: {{m: {{members: [z1, z2]}}}}
losses: {{gear_external: 0.02}}
actuators: {{left: {{coupling: L}}, right: {{coupling: R}}, motor: {{coupling: P}}}}
cases: {{one: {{motion: {{motor: {-15 * turns}}}, action: {{left: -100, right: -50}}}}}}""",
                              f"eta: {eta}", "[left, right, wheel, pinion]").replace(
                    "W: {type: revolute, bodies: [frame, wheel], at: [0, 0]}",
                    "W: {type: revolute, bodies: [frame, wheel]}\n"
                    "  P: {type: revolute, bodies: [frame, pinion]}").replace(
                    "{pulley: wheel,", "{pulley: wheel, at: [0, 0],")
                case = program.run("analyze", "-", text=text)["cases"]["one"]
                wheel = couple(eta, ahead, behind, 0.1)
                self.near(case["statics"]["actions"]["motor"], -turns * wheel / 5, "ideal")
                drives = wheel > 0
                lossy = wheel / 5 / 0.98 if drives else wheel / 5 * 0.98
                self.near(case["power"]["losses"]["actuators"]["motor"], -turns * lossy,
                          "lossy")

def row_of_sheaves(etas: list[float], couples: list[float], known: str, runs_right: bool) -> str:
    """In turn above and below, a motor on each; the ends hang down or stand up."""
    last = 0.2 * len(etas)
    sense = 1 if runs_right else -1
    lines = ["kinestat: 1", "space: planar", "ground: frame", "couplings:",
             "  L: {type: prismatic, bodies: [frame, left], at: [0, 2.5], axis: y}",
             f"  R: {{type: prismatic, bodies: [frame, right], at: [{last}, 2.5], axis: y}}"]
    stations, motors, actions = [], [], []
    for i, eta in enumerate(etas):
        above = i % 2 == 0
        lines.append(f"  W{i}: {{type: revolute, bodies: [frame, w{i}], "
                     f"at: [{0.2 * i + 0.1}, {5 if above else 0}]}}")
        stations.append(f"      - {{pulley: w{i}, radius: 0.1, eta: {eta}, "
                        f"wrap: {'' if above else 'counter'}clockwise}}")
        motors.append(f"m{i}: {{coupling: W{i}}}")
        actions.append(f"m{i}: {(-sense if above else sense) * couples[i]!r}")
    return "\n".join([
        *lines, f"bodies: [left, right, {', '.join(f'w{i}' for i in range(len(etas)))}]",
        "cables:", "  rope:", "    over:", "      - {body: left, at: [0, 2.5]}", *stations,
        f"      - {{body: right, at: [{last}, 2.5]}}",
        f"actuators: {{left: {{coupling: L}}, right: {{coupling: R}}, {', '.join(motors)}}}",
        f"cases: {{one: {{motion: {{left: {sense}}}, action: {{{known}, {', '.join(actions)}}}}}}}",
        ""])


# The pulley turns with its cable, which may slip but does not.
MAY_SLIP = "slip: true, friction: 1.5"


class Gripped(ReferenceTest):
    def grip(self, case: str, eta: float, friction: float = 1.5) -> dict:
        machines = MACHINES.replace("}}\n", "}, grip: {coupling: rope_wheel}}\n")
        done = program.call("analyze", "-", text=sheave(
            f"{machines}cases: {{one: {{{case}}}}}",
            f"slip: true, friction: {friction}, eta: {eta}"))
        self.assertEqual(done.stderr, "")
        return program.report(done)["cases"]["one"]

    def test_couple_of_a_sheave(self) -> None:
        for eta, (left, right), turns in itertools.product((0.9, 0.6), TENSIONS[1:-1], (-1, 1)):
            with self.subTest(eta=eta, left=left, right=right, turns=turns):
                case = self.grip(f"motion: {{motor: {3 * turns}, grip: 0}}, "
                                 f"action: {{left: {-left}, right: {-right}}}", eta)["statics"]
                ahead, behind = (right, left) if turns < 0 else (left, right)
                self.near(case["actions"]["motor"] * turns, couple(eta, ahead, behind, 0.1),
                          "motor", 10.0)
                self.near(case["actions"]["grip"], 0.1 * (right - left), "grip", 10.0)
                self.near_all([one["couple"] for one in case["friction"].values()],
                              [loss(eta, ahead, behind, 0.1)])

    def test_slip_takes_the_loss_instead(self) -> None:
        """Also of a pulley that turns; on one that stands, nothing else rubs."""
        for turns in (0.0, 4.0):
            with self.subTest(turns=turns):
                ratio = math.exp(0.2 * math.pi) / 0.9
                case = self.grip(f"motion: {{motor: {turns}, grip: 2}}, "
                                 "action: {left: -100, grip: 0}", 0.9, 0.2)["statics"]
                self.near(case["actions"]["rope_2.F"], 100 / ratio, "tension", 100.0)
                self.near(case["actions"]["motor"], -10 * (1 - 1 / ratio), "motor", 10.0)

    def test_arc_that_grows(self) -> None:
        """It changes what friction could hold, and not what the sheave loses."""
        found = motion_case.run(sheave("""\
actuators: {left: {coupling: L}, right: {coupling: R}, grip: {coupling: rope_wheel}}
cases: {one: {motion: {left: -1, grip: 0}, action: {right: -100}}}
motion: {drives: [{drive: left, to: -3}, {drive: grip, to: 0}], steps: 6, case: one,
         report: [action, reaction]}""", f"{MAY_SLIP}, eta: 0.9").replace(
             "frame, left], at: [-0.1, -5], axis: y", "frame, left], at: [-1, -5], axis: x").replace(
             "body: left, at: [-0.1, -5]", "body: left, at: [-1, -5]"))
        # The hand pulls the rope over the wheel.
        self.near_all(found["rope_1.F/action"], [100 / 0.9] * 7)
        self.near_all(found["W/friction"], [loss(0.9, 100 / 0.9, 100, 0.1)] * 7)


MASSES = ("{left: {mass: 2, centre_of_mass: [-0.1, -5]}, "
          "right: {mass: 3, centre_of_mass: [0.1, -5]}, wheel: {inertia: 0.04}}")


class Studies(ReferenceTest):
    def test_rows_of_a_motion(self) -> None:
        """Speeded up and slowed down, the wheel drives in some rows and is driven in others."""
        for eta, travel in itertools.product((0.97, 0.8), (-20.0, 20.0)):
            with self.subTest(eta=eta, travel=travel):
                found = motion_case.run(sheave(f"""\
gravity: [0, -9.81]
actuators: {{motor: {{coupling: W}}}}
cases: {{one: {{motion: {{}}, acceleration: {{}}}}}}
motion: {{drive: motor, to: {travel} rad, time: 1 s, law: cycloidal, steps: 24, case: one,
         report: [acceleration, action, reaction]}}""", f"eta: {eta}", MASSES))
                decided = set()
                for i, spin in enumerate(found["W.wz/acceleration"][1:-1], 1):
                    left, right = 2 * (G - spin * 0.1), 3 * (G + spin * 0.1)
                    ahead, behind = (left, right) if travel > 0 else (right, left)
                    drives = couple(eta, ahead, behind, 0.1)
                    decided.add(drives > 0)
                    sense = math.copysign(1.0, travel)
                    self.near(found["motor/action"][i], sense * drives + 0.04 * spin, "motor", 20.0)
                    self.near(found["rope_1.F/action"][i], left, "left", 100.0)
                    self.near(found["W/friction"][i], loss(eta, ahead, behind, 0.1), "friction",
                              20.0)
                self.assertEqual(len(decided), 2)

    def test_sweep_across_the_kink(self) -> None:
        rows = [json.loads(line) for line in program.call("sweep", "-", text=sheave(f"""\
parameters: {{pull: 80 N, eta: 0.9}}
{MACHINES}cases: {{one: {{motion: {{motor: -3}}, action: {{left: -pull, right: -100}}}}}}
sweep: {{vary: {{pull: {{from: 60 N, to: 140 N, step: 5 N}}, eta: [0.9, 0.8]}}, report: [motor]}}
""", "eta: eta")).stdout.splitlines()]
        self.assertEqual(len(rows), 34)
        for row in rows:
            self.near(row["motor [N*m]"], -couple(row["eta"], 100.0, row["pull [N]"], 0.1),
                      "motor", 10.0)

    def test_motion_of_a_driven_wheel(self) -> None:
        """The couple of the motor falls: it drives, then the heavier block does, and the wheel
        slows down all the same, until it stands."""
        eta, radius, inertia = 0.9, 0.1, 0.04
        found = simulations.Simulation(sheave("""\
gravity: [0, -9.81]
actuators: {motor: {coupling: W}}
curves: {falling: {over: time, points: [[0 s, 4 N*m], [0.5 s, -1 N*m]], between: linear}}
simulation: {action: {motor: falling}, start: {motor: {speed: 10}}, time: 0.5 s, steps: 25,
             tolerance: 1e-11, report: [position, velocity, acceleration, action, energy]}""",
                                       f"eta: {eta}", MASSES))
        decided = set()
        for i, time in enumerate(found.columns["time"]):
            spin = found.columns["W.wz/acceleration"][i]
            left, right = 2 * (G - spin * radius), 3 * (G + spin * radius)
            net = 4 - 10 * time - inertia * spin
            decided.add(net > 0)
            scale = 1e-9 * 50
            self.assertLessEqual(abs(net - couple(eta, left, right, radius)), scale)
            self.assertLessEqual(abs(found.columns["rope_2.F/action"][i] - right), scale)
        self.assertEqual(len(decided), 2)
        self.assertLessEqual(found.report["energy_drift"], 1e-6 * found.report["energy_scale"])

    def test_couple_that_sets_a_wheel_going(self) -> None:
        """The blocks alone do not: the motor takes 1/eta of what it moves."""
        eta, radius = 0.6, 0.1
        for sense in (1, -1):
            with self.subTest(sense=sense):
                found = simulations.Simulation(sheave(f"""\
gravity: [0, -9.81]
actuators: {{motor: {{coupling: W}}}}
curves: {{rising: {{over: time, points: [[0 s, 0 N*m], [1 s, {5 * sense} N*m]], between: linear}}}}
simulation: {{action: {{motor: rising}}, time: 1 s, steps: 2, tolerance: 1e-11}}""",
                                                      f"eta: {eta}", MASSES))
                self.assertEqual([one["kind"] for one in found.events], ["stick", "slip"])
                ahead, behind = (2 * G, 3 * G) if sense > 0 else (3 * G, 2 * G)
                self.assertLessEqual(abs(5 * found.events[1]["time"] -
                                         couple(eta, ahead, behind, radius)), 1e-8)

    def test_wheel_that_its_cable_does_not_slip_on(self) -> None:
        eta = 0.9
        found = simulations.Simulation(sheave(f"""\
gravity: [0, -9.81]
actuators: {{motor: {{coupling: W}}}}
simulation: {{action: {{motor: 0}}, time: 1 s, steps: 2, tolerance: 1e-11, report: [acceleration]}}""",
                                              f"{MAY_SLIP}, eta: {eta}", MASSES))
        up = G * (3 * eta - 2) / (3 * eta + 2 + 4)
        self.assertLessEqual(abs(found.last()["L.vy/acceleration"] - up), 1e-9 * G)

    def test_cable_that_begins_to_slip_on_a_wheel_that_drives(self) -> None:
        """Until then the wheel loses what it does without slip, from then on the slip does."""
        eta, radius, mu = 0.9, 0.1, 0.2
        found = simulations.Simulation(sheave("""\
gravity: [0, -9.81]
actuators: {motor: {coupling: W}}
curves: {rising: {over: time, points: [[0 s, 0 N*m], [1 s, 5 N*m]], between: linear}}
simulation: {action: {motor: rising}, start: {motor: {speed: 30}}, time: 0.7 s, steps: 70,
             tolerance: 1e-11, report: [acceleration, action]}""",
                                              f"slip: true, friction: {mu}, eta: {eta}", MASSES))
        ratio = math.exp(mu * math.pi) / eta
        ends = G * (2 * ratio - 3) / (2 * ratio + 3)  # the right rises, and the left sinks, by this
        slips = [one["time"] for one in found.events if one["kind"] == "slip"]
        inertia = 0.04 / radius ** 2
        self.assertEqual(len(slips), 1)
        self.assertLessEqual(abs(5 * slips[0] / radius - couple(eta, 2 * (G - ends), 3 * (G + ends))
                                 - inertia * ends), 1e-6)
        for i, time in enumerate(found.columns["time"]):
            at = {name: values[i] for name, values in found.columns.items()}
            rise, spin = at["R.vy/acceleration"], at["W.wz/acceleration"]
            ahead, behind = 2 * (G - rise), 3 * (G + rise)
            if time < slips[0]:
                expected = couple(eta, ahead, behind, radius)
            else:
                self.assertLessEqual(abs(rise - ends), 1e-7)
                expected = radius * (behind - ahead)
            self.assertLessEqual(abs(5 * time - 0.04 * spin - expected), 1e-7)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
