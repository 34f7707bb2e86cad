#!/usr/bin/env python3
"""Simulations with dry friction: sticking and slipping.

simulation.json has cases by closed form and by an integrator; the rest is by closed forms, and by
Newton's equations of each body with Runge and Kutta's method here.

Usage: simulation_friction_test.py KINESTAT
"""

from __future__ import annotations

import math
import sys
import unittest

import program
import simulation_test as simulations

Simulation = simulations.Simulation
CASES = simulations.CASES
G = 9.81

BELT = """
kinestat: 1
space: planar
ground: frame
bodies: {belt: {}, block: {mass: 1.5, centre_of_mass: [0, 0], inertia: 0.001}}
gravity: [0, -9.81]
couplings:
  run: {type: prismatic, bodies: [frame, belt], at: [0, 0], axis: x}
  rub: {type: prismatic, bodies: [belt, block], at: [0, 0], axis: x,
        friction: {mu: 0.25, mu_static: 0.4}}
springs: {hold: {bodies: [frame, block], at: {frame: [-1, 0], block: [0, 0]}, stiffness: 300 N/m,
                 free_length: 1}}
actuators: {drive: {coupling: run}, slip: {coupling: rub}}
simulation: {motion: {drive: 0.3}, action: {slip: 0}, time: 5 s, steps: 500, tolerance: 1e-11}
"""

GUIDE = """
kinestat: 1
space: planar
ground: frame
bodies: {block: {mass: 2, centre_of_mass: [0, ARM]}}
gravity: [DOWN]
couplings: {g: {type: prismatic, bodies: [frame, block], at: [0, 0], axis: x, friction: {RUBS}}}
springs: {s: {coupling: g, stiffness: STIFF N/m, free: 0}}
actuators: {hand: {coupling: g}}
simulation: {action: {hand: 0}, start: {hand: {position: PLACE, speed: SPEED}}, time: 2 s, steps: 20,
             tolerance: 1e-11 MORE}
"""

PENDULUM = """
kinestat: 1
space: planar
ground: frame
bodies: {rod: {mass: 2, centre_of_mass: [0, -0.5], inertia: 0.1}}
gravity: [0, -9.81]
couplings: {a: {type: revolute, bodies: [frame, rod], at: [0, 0], friction: {mu: MU, radius: 0.05}}}
actuators: {pivot: {coupling: a}}
simulation: {action: {pivot: 0}, start: {pivot: {position: BEGIN}}, time: TIME s, steps: STEPS,
             report: [position, velocity, acceleration, action, energy], tolerance: 1e-11}
"""

PLANK = """
kinestat: 1
space: planar
ground: frame
bodies: {plank: {mass: 3, centre_of_mass: [0, 0]}, block: {mass: 2, centre_of_mass: [0, 0]}}
gravity: [0, -9.81]
couplings:
  below: {type: prismatic, bodies: [frame, plank], at: [0, 0], axis: x, friction: 0.1}
  above: {type: prismatic, bodies: [plank, block], at: [0, 0], axis: x, friction: 0.3}
actuators: {push: {coupling: below}}
curves: {ramp: {over: time, points: [[0 s, 0 N], [10 s, 100 N]], between: linear}}
simulation: {action: {push: ramp}, time: 3 s, steps: 30, tolerance: 1e-11}
"""

CLUTCH = """
kinestat: 1
space: spatial
ground: frame
bodies: {shaft: {inertia: {polar: 0.3, axis: z}}, disc: {inertia: {polar: 1.2, axis: z}}}
couplings:
  a: {type: revolute, bodies: [frame, shaft], at: [0, 0, 0], axis: z}
  b: {type: revolute, bodies: [frame, disc], at: [0, 0, 0.1], axis: z}
  C: {type: clutch, bodies: [shaft, disc], at: [0, 0, 0.05], axis: z, friction: {tau: 80}}
actuators: {in: {coupling: a}, out: {coupling: b}}
simulation: {action: {in: 0, out: 0, C: 0}, start: {in: {speed: 200}, C: {speed: -150}}, time: 2 s,
             steps: 20}
"""

CRANK = simulations.SLIDER_CRANK.split("simulation:")[0].replace(
    "axis: x}", "axis: x, friction: MU}") + """
simulation: {action: {motor: 4}, time: 0.1 s, steps: 4, report: [a.wz, d.vx, action],
             tolerance: 1e-11}
"""

FOUR_BAR = """
kinestat: 1
space: planar
ground: frame
bodies:
  crank: {mass: 1.0, centre_of_mass: [0.05, 0], inertia: 0.001}
  coupler: {mass: 1.5, centre_of_mass: [0.2, 0.13], inertia: 0.02}
  rocker: {mass: 1.2, centre_of_mass: [0.35, 0.12], inertia: 0.01}
gravity: [0, -9.81]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0], friction: {mu: 0.2, radius: 0.01}}
  b: {type: revolute, bodies: [crank, coupler], at: [0.1, 0], friction: {mu: 0.2, radius: 0.01}}
  c: {type: revolute, bodies: [coupler, rocker], at: [0.32, 0.25], friction: {mu: 0.2, radius: 0.01}}
  d: {type: revolute, bodies: [frame, rocker], at: [0.4, 0], friction: {mu: 0.2, radius: 0.01}}
actuators: {motor: {coupling: a}}
simulation: {action: {motor: 0}, start: {motor: {speed: 20 rad/s}}, time: 10 s, steps: 100}
"""


def guide(rubs: str, down: str = "0, -9.81", stiff: float = 0.0, place: float = 0.0,
          speed: float = 0.0, arm: float = 0.0, more: str = "") -> str:
    text = GUIDE
    if not stiff:
        text = "\n".join(line for line in text.split("\n") if not line.startswith("springs"))
    for word, value in (("RUBS", rubs), ("DOWN", down), ("STIFF", stiff), ("PLACE", place),
                        ("SPEED", speed), ("ARM", arm), ("MORE", more)):
        text = text.replace(word, str(value))
    return text


def kinds(found: Simulation) -> list[str]:
    return [event["kind"] for event in found.events]


class FrictionTest(simulations.SimulationCase):
    def test_block_on_a_belt_sticks_and_slips(self) -> None:
        found = Simulation(BELT)
        expected = CASES["stick_slip_belt"]["expected"]
        events = found.events
        self.assertEqual(kinds(found)[0], "stick")
        self.assertEqual(kinds(found), ["stick", "slip"] * (len(events) // 2) + ["stick"] *
                         (len(events) % 2))
        times = [event["time"] for event in events]
        self.near(times[1], expected["first_slip"], 1e-8)
        for k in range(2, 12, 2):
            self.near(times[k] - times[k - 1], expected["slip_time"], 1e-8, "slips")
            self.near(times[k + 1] - times[k], expected["stick_time"], 1e-8, "sticks")
        # While it sticks friction holds the spring.
        at = found.at(0.05)
        self.near(at["rub/friction"], 300 * 0.3 * 0.05, 1e-9)
        self.assertEqual(at["rub.vx/velocity"], 0.0)
        self.assertLess(found.report["energy_drift"], 1e-7)

    def test_mass_and_spring_on_a_rough_guide_come_to_rest(self) -> None:
        found = Simulation(guide("mu: 0.3", stiff=200, place=0.1))
        expected = CASES["rough_guide_stops"]["expected"]
        self.assertEqual(kinds(found), ["stick"])
        self.near(found.events[0]["time"], expected["time"], 1e-8)
        last = found.last()
        self.near(last["g.vx/position"], expected["rest"], 1e-9)
        self.near(last["energy/lost"], expected["heat"], 1e-8)
        self.near(last["g/friction"], 200 * expected["rest"], 1e-6)

    def test_block_stops_after_its_way_and_stays(self) -> None:
        found = Simulation(guide("mu: 0.3", speed=2))
        self.assertEqual(kinds(found), ["stick"])
        self.near(found.events[0]["time"], 2 / (0.3 * G), 1e-10)
        self.near(found.last()["g.vx/position"], 4 / (2 * 0.3 * G), 1e-10)
        self.assertEqual(found.last()["g.vx/velocity"], 0.0)
        self.near(found.last()["energy/lost"], 4.0, 1e-10)

    def test_viscous_and_dry_friction_together(self) -> None:
        found = Simulation(guide("mu: 0.3, c: 3", speed=2))
        # m v' = -mu m g - c v.
        rest = 0.3 * 2 * G / 3
        time = 2 / 3 * math.log(1 + 2 / rest)
        self.near(found.events[0]["time"], time, 1e-10)
        self.near(found.last()["g.vx/position"], 2 / 3 * 2 - rest * time, 1e-10)

    def test_block_on_an_incline(self) -> None:
        for angle, mu in ((0.5, 0.3), (0.5, 0.6), (-0.5, 0.3)):
            down = f"{G * math.sin(angle)!r}, {-G * math.cos(angle)!r}"
            found = Simulation(guide(f"mu: {mu}", down=down))
            slides = math.tan(abs(angle)) > mu
            acceleration = G * (math.sin(abs(angle)) - mu * math.cos(angle)) if slides else 0.0
            self.near(found.last()["g.vx/position"],
                      math.copysign(acceleration * 2, angle), 1e-9)
            self.assertEqual(kinds(found), [] if slides else ["stick"])
            if not slides:
                self.near(found.last()["g/friction"], -2 * G * math.sin(angle), 1e-9)
        # Thrown upwards it turns back where it is steep, and the friction with it.
        angle, mu = 0.5, 0.3
        down = f"{G * math.sin(angle)!r}, {-G * math.cos(angle)!r}"
        found = Simulation(guide(f"mu: {mu}", down=down, speed=-3))
        up = 3 / (G * (math.sin(angle) + mu * math.cos(angle)))
        place = -1.5 * up + G * (math.sin(angle) - mu * math.cos(angle)) * (2 - up) ** 2 / 2
        self.near(found.last()["g.vx/position"], place, 1e-9)
        self.assertEqual(kinds(found), [])

    def test_guide_of_a_length_presses_at_its_edges(self) -> None:
        # The centre of mass beside the guide: mu m g where its edges would press less.
        found = Simulation(guide("mu: 0.3, length: 0.3", speed=2, arm=0.3))
        self.near(found.events[0]["time"], 2 / (0.3 * G), 1e-10)
        # The pull of the spring gives no couple: -k x -+ mu max(m g, 2 |couple|/length).

    def test_friction_that_grows_with_what_it_causes_has_no_answer(self) -> None:
        # The couple of inertia m a e presses with 2 m a e/length: above mu 2 e/length = 1 no
        # deceleration is enough.
        done = program.call("simulate", "-", text=guide("mu: 0.3, length: 0.1", speed=2, arm=0.3))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("E0519", done.stderr)
        self.assertIn("'g'", done.stderr)

    def test_clutch_drags_two_flywheels_together(self) -> None:
        found = Simulation(CLUTCH)
        expected = CASES["two_flywheels"]["expected"]
        self.assertEqual(kinds(found), ["stick"])
        self.near(found.events[0]["time"], expected["time"], 1e-10)
        self.near(found.last()["a.wz/velocity"], expected["common_speed"], 1e-8)
        self.near(found.last()["b.wz/velocity"], expected["common_speed"], 1e-8)
        self.near(found.last()["energy/lost"], expected["energy"], 1e-6)

    def test_plank_takes_a_block_along_until_it_is_too_fast(self) -> None:
        found = Simulation(PLANK)
        self.assertEqual(kinds(found), ["stick", "stick", "slip", "slip"])
        first, second = 0.1 * 5 * G / 10, (0.1 + 0.3) * 5 * G / 10
        slips = {event["element"]: event["time"] for event in found.events[2:]}
        self.near(slips["below.vx"], first, 1e-9)
        self.near(slips["above.vx"], second, 1e-9)
        # The block then has 0.3 g, the plank 10 N/s t less both frictions.
        speed = 10 / 5 * (second - first) ** 2 / 2
        block = speed + 0.3 * G * (3 - second)
        plank = speed + (10 * (9 - second ** 2) / 2 - (0.1 * 5 + 0.3 * 2) * G * (3 - second)) / 3
        last = found.last()
        self.near(last["below.vx/velocity"], plank, 1e-8)
        self.near(last["below.vx/velocity"] + last["above.vx/velocity"], block, 1e-8)
        self.assertLess(found.report["energy_drift"], 1e-7)

    def test_wall_behind_a_rough_way(self) -> None:
        more = ", stops: {hand: {to: 0.3, restitution: 0.5}}"
        found = Simulation(guide("mu: 0.3", speed=3, more=more))
        self.assertEqual(kinds(found), ["impact", "stick"])
        before = math.sqrt(9 - 2 * 0.3 * G * 0.3)
        self.near(found.events[0]["speed"], before, 1e-9)
        self.near(found.last()["g.vx/position"], 0.3 - (before / 2) ** 2 / (2 * 0.3 * G), 1e-9)

    def test_pendulum_in_a_rough_bearing(self) -> None:
        for mu in (0.3, 0.1):
            found = Simulation(PENDULUM.replace("MU", str(mu)).replace("BEGIN", "0.5")
                               .replace("TIME", "9").replace("STEPS", "18"))
            samples, rest = rough_pendulum(mu * 0.05, 0.5, [0.5 * k for k in range(19)])
            for time, (place, speed) in samples.items():
                at = found.at(time)
                self.near(at["a.wz/position"], place, 2e-8, f"{mu} {time}")
                self.near(at["a.wz/velocity"], speed, 2e-7, f"{mu} {time}")
            self.assertEqual(kinds(found), ["stick"] if rest else [])
            if rest:
                self.near(found.events[0]["time"], rest, 1e-7)
            self.assertLess(found.report["energy_drift"], 1e-7)

    def test_slider_crank_with_a_rough_guide_by_newtons_equations(self) -> None:
        for mu in (0.0, 0.25):
            found = Simulation(CRANK.replace("MU", str(mu)) if mu else
                               CRANK.replace(", friction: MU", ""))
            for row, time in enumerate((0.0, 0.025, 0.05, 0.075, 0.1)):
                theta0 = math.atan2(0.04, 0.03)
                state = simulations.runge_kutta(
                    lambda y: [y[1], crank_equations(*y, mu)[0]], [theta0, 0.0], time,
                    3000) if time else [theta0, 0.0]
                answer = crank_equations(*state, mu)
                at = {name: values[row] for name, values in found.columns.items()}
                self.near(at["a.wz/position"] + theta0, state[0], 1e-8)
                self.near(at["a.wz/velocity"], state[1], 1e-6)
                self.near(at["a.wz/acceleration"], answer[0], 1e-4)
                for name, value in zip(("a.Rx", "a.Ry", "b.Rx", "b.Ry", "c.Rx", "c.Ry", "d.Ry"),
                                       answer[1:8]):
                    self.near(at[f"{name}/action"], value, 2e-6 * max(map(abs, answer[1:8])), name)
                if mu:
                    self.near(at["d/friction"], answer[8], 2e-5, "friction")

    def test_four_bar_with_rough_pins_comes_to_rest(self) -> None:
        found = Simulation(FOUR_BAR)
        self.assertEqual(kinds(found), ["stick"])
        last = found.last()
        self.assertEqual(last["a.wz/velocity"], 0.0)
        self.assertLess(found.report["energy_drift"], 1e-6)
        # At rest several couplings stick, and nothing says how they share.
        self.assertIsNone(last["a/friction"])
        before = max(i for i, time in enumerate(found.columns["time"])
                     if time < found.events[0]["time"])
        self.assertIsNotNone(found.columns["a/friction"][before])
        # It lies where its weight does not overcome the four couples.
        self.near(last["energy/lost"] + last["energy/potential"],
                  found.columns["energy/kinetic"][0] + found.columns["energy/potential"][0], 1e-6)


    def test_disc_on_a_rough_collar(self) -> None:
        # Couple mu m g (thrust radius) on 0.5 J w^2.
        found = Simulation("""
kinestat: 1
space: spatial
ground: frame
bodies: {disc: {mass: 4, centre_of_mass: [0, 0, 0], inertia: [0.02, 0.02, 0.03]}}
gravity: [0, 0, -9.81]
couplings: {a: {type: revolute, bodies: [frame, disc], at: [0, 0, 0], axis: z,
                friction: {mu: 0.1, radius: 0.01, thrust_radius: 0.015}}}
actuators: {spin: {coupling: a}}
simulation: {action: {spin: 0}, start: {spin: {speed: 20}}, time: 20 s, steps: 10}
""")
        self.assertEqual(kinds(found), ["stick"])
        self.near(found.events[0]["time"], 0.03 * 20 / (0.1 * 4 * G * 0.015), 1e-8)
        self.near(found.last()["energy/lost"], 0.5 * 0.03 * 400, 1e-9)

    def test_screw_that_holds_its_nut_and_one_that_does_not(self) -> None:
        text = """
kinestat: 1
space: spatial
ground: frame
bodies: {nut: {mass: 2, centre_of_mass: [0, 0, 0], inertia: [0.001, 0.001, 0.002]}}
gravity: [0, 0, -9.81]
couplings: {t: {type: helical, bodies: [frame, nut], at: [0, 0, 0], axis: z, pitch: PITCH,
                friction: {mu: 0.15, radius: 0.01}}}
actuators: {turn: {coupling: t}}
simulation: {action: {turn: 0}, time: 0.5 s, steps: 5}
"""
        found = Simulation(text.replace("PITCH", "0.001"))
        self.assertEqual(kinds(found), ["stick"])
        self.near(found.last()["t/friction"], 2 * G * 0.001, 1e-12)
        # Down a steep thread: the force of the thread F follows from m g - F = m h a, and the couple
        # r tan(lead - angle of friction) F speeds the nut up.
        h, r = 0.002, 0.01
        arm = r * math.tan(math.atan(h / r) - math.atan(0.15))
        spin = arm * 2 * G / (0.002 + 2 * h * arm)
        found = Simulation(text.replace("PITCH", "0.002"))
        self.near(found.last()["t.w/acceleration"], -spin, 1e-9)
        self.near(found.last()["t.w/position"], -spin * 0.125, 1e-9)


def rough_pendulum(arm: float, begin: float, times: list[float]):
    """Places and speeds at these times, and when it comes to rest: m 2, l 0.5, J 0.6 about the pin,
    friction arm N against the motion."""
    m, l, j = 2.0, 0.5, 0.6

    def acceleration(place: float, speed: float, sense: float) -> float:
        a = 0.0
        for _ in range(200):
            normal = m * math.hypot(l * a + G * math.sin(place),
                                    l * speed * speed + G * math.cos(place))
            a, before = (-m * G * l * math.sin(place) - sense * arm * normal) / j, a
            if abs(a - before) < 1e-15:
                break
        return a

    def step(y, h, sense):
        return simulations.runge_kutta(lambda z: [z[1], acceleration(z[0], z[1], sense)], y, h, 1)

    samples = {0.0: (begin, 0.0)}
    y, time, rest, sense = [begin, 0.0], 0.0, None, -1.0
    for target in times[1:]:
        while target - time > 1e-13 and rest is None:
            h = min(1e-3, target - time)
            after = step(y, h, sense)
            if sense * after[1] < 0.0:
                low, high = 0.0, h
                for _ in range(60):
                    middle = 0.5 * (low + high)
                    low, high = (middle, high) if sense * step(y, middle, sense)[1] > 0.0 else (
                        low, middle)
                y, time = [step(y, low, sense)[0], 0.0], time + low
                sense = -sense
                if sense * acceleration(y[0], 0.0, sense) <= 0.0:
                    rest = time
            else:
                y, time = after, time + h
        samples[target] = (y[0], 0.0 if rest else y[1])
    return samples, rest


def crank_equations(theta: float, speed: float, mu: float) -> list[float]:
    """Crank acceleration, forces of frame on crank, crank on rod, rod on piston, frame on piston,
    and the friction, from Newton's equations of each body."""
    r, l, torque, push = 0.05, math.hypot(0.18, 0.04), 4.0, -30.0
    m1, m2, m3, j1, j2 = 1.2, 0.6, 0.5, 0.0015, 0.0025
    phi = -math.asin(r * math.sin(theta) / l)
    turn = -r * math.cos(theta) * speed / (l * math.cos(phi))

    def accelerations(a: float):
        b = [-r * a * math.sin(theta) - r * speed ** 2 * math.cos(theta),
             r * a * math.cos(theta) - r * speed ** 2 * math.sin(theta)]
        spin = (-r * math.cos(theta) * a + r * math.sin(theta) * speed ** 2 +
                l * math.sin(phi) * turn ** 2) / (l * math.cos(phi))
        along = [-spin * math.sin(phi) - turn ** 2 * math.cos(phi),
                 spin * math.cos(phi) - turn ** 2 * math.sin(phi)]
        return ([-0.2 * x for x in b], [x + 0.3 * l * e for x, e in zip(b, along)],
                b[0] + l * along[0], spin)

    zero, one = accelerations(0.0), accelerations(1.0)
    velocity = -r * speed * math.sin(theta) - l * turn * math.sin(phi)
    sense = 0.0 if velocity == 0.0 else math.copysign(1.0, velocity)
    if speed == 0.0:  # it begins by turning forwards
        sense = math.copysign(1.0, -math.sin(theta) + math.cos(theta) * math.tan(phi))
    pin = [r * math.cos(theta), r * math.sin(theta)]
    g1 = [-0.2 * x for x in pin]
    e = [math.cos(phi), math.sin(phi)]
    answer = []
    for side in (1.0, -1.0):
        # Unknown: a, Ax, Ay, Bx, By, Cx, Cy, N; N has the sign `side`.
        rows = [[0.0] * 9 for _ in range(8)]

        def inertia(row: int, mass: float, at_zero: float, at_one: float) -> None:
            rows[row][0] = -mass * (at_one - at_zero)
            rows[row][8] = mass * at_zero

        for i in range(2):
            inertia(i, m1, zero[0][i], one[0][i])
            rows[i][1 + i], rows[i][3 + i] = 1.0, -1.0
            inertia(3 + i, m2, zero[1][i], one[1][i])
            rows[3 + i][3 + i], rows[3 + i][5 + i] = 1.0, -1.0
        rows[2][0], rows[2][8] = -j1, -torque
        rows[2][1], rows[2][2] = g1[1], -g1[0]
        rows[2][3], rows[2][4] = pin[1] - g1[1], -(pin[0] - g1[0])
        inertia(5, j2, zero[3], one[3])
        rows[5][3], rows[5][4] = 0.3 * l * e[1], -0.3 * l * e[0]
        rows[5][5], rows[5][6] = 0.7 * l * e[1], -0.7 * l * e[0]
        inertia(6, m3, zero[2], one[2])
        rows[6][5], rows[6][7] = 1.0, -sense * mu * side
        rows[6][8] -= push
        rows[7][6], rows[7][7] = 1.0, 1.0
        answer = solved(rows)
        if answer[7] * side >= 0.0:
            break
    return [*answer, -sense * mu * abs(answer[7])]


def solved(rows: list[list[float]]) -> list[float]:
    """Gauss and Jordan with pivots; the last column is the right side."""
    count = len(rows)
    for i in range(count):
        pivot = max(range(i, count), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(count):
            if k != i:
                share = rows[k][i] / rows[i][i]
                rows[k] = [a - share * b for a, b in zip(rows[k], rows[i])]
    return [rows[i][-1] / rows[i][i] for i in range(count)]


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
