#!/usr/bin/env python3
"""Derivatives of drive torques and reactions with forces of inertia and springs: closed forms, and a
slider-crank by Newton and Euler's equations in complex numbers, whose imaginary part is the derivative.
"""

from __future__ import annotations

import cmath
import math
import re
import sys
import unittest

import program
from dynamics_case import CASES

PENDULUM = """\
kinestat: 1
space: planar
parameters: {ma: 2, d: 0.4, Jz: 0.1, q: 0.6 rad, w: 3 rad/s, a: 7 rad/s^2, gr: 9.81, k: 5 N*m/rad,
              free: 0.2 rad, c: 0.3}
gravity: [0, -gr]
ground: f
bodies: {bob: {mass: ma, centre_of_mass: [d*sin(q), -d*cos(q)], inertia: Jz}}
couplings: {h: {type: revolute, bodies: [f, bob], at: [0, 0]}}
springs: {coil: {coupling: h, stiffness: k, free: free, damping: c}}
actuators: {motor: {coupling: h}}
cases: {swings: {motion: {motor: w}, acceleration: {motor: a}, action: {}}}
"""

CRANK = """\
kinestat: 1
space: planar
parameters: {r: 0.12, l: 0.4, q: 0.9 rad, w: 60 rad/s, a: 500 rad/s^2, mr: 1.4, mp: 0.8, d: 0.15, Jz: 0.03,
              k: 4000 N/m, l0: 0.3}
ground: f
bodies:
  crank: {}
  rod: {mass: mr, inertia: Jz,
        centre_of_mass: [r*cos(q) + d/l*sqrt(l^2 - (r*sin(q))^2), r*sin(q) - d/l*r*sin(q)]}
  piston: {mass: mp, centre_of_mass: [r*cos(q) + sqrt(l^2 - (r*sin(q))^2), 0]}
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [r*cos(q), r*sin(q)]}
  c: {type: revolute, bodies: [rod, piston], at: [r*cos(q) + sqrt(l^2 - (r*sin(q))^2), 0]}
  d: {type: prismatic, bodies: [f, piston], at: [0.4, 0], axis: x}
springs:
  push: {bodies: [f, piston], at: {f: [0.9, 0], piston: [r*cos(q) + sqrt(l^2 - (r*sin(q))^2), 0]},
         stiffness: k, free_length: l0}
actuators: {motor: {coupling: a}}
cases: {runs: {motion: {motor: w}, acceleration: {motor: a}, action: {}}}
"""
CRANK_NUMBERS = {"r": 0.12, "l": 0.4, "q": 0.9, "w": 60.0, "a": 500.0, "mr": 1.4, "mp": 0.8, "d": 0.15,
                 "Jz": 0.03, "k": 4000.0, "l0": 0.3}


def derivatives_of(text: str, case: str, *values: str) -> dict[str, dict[str, float]]:
    words = [word for value in values for word in ("--of", value)]
    report = program.run("sensitivity", "-", *words, text=text)
    return {value: {name: entry["derivative"] for name, entry in one["by"].items()}
            for value, one in report["cases"][case]["sensitivity"].items()}


def crank_forces(**n: complex) -> dict[str, complex]:
    """Torque of the motor and the forces on the guide and the crank pin. Positions by the crank angle
    q and the rod angle p, sin p = r sin q / l; the rod leans down."""
    r, l, q, w, a, s = (n[name] for name in ("r", "l", "q", "w", "a", "d"))
    p = cmath.asin(r * cmath.sin(q) / l)
    dp = r * w * cmath.cos(q) / (l * cmath.cos(p))
    ddp = (r * (a * cmath.cos(q) - w * w * cmath.sin(q)) + l * dp * dp * cmath.sin(p)) / (l * cmath.cos(p))
    pin = (-r * (a * cmath.sin(q) + w * w * cmath.cos(q)), r * (a * cmath.cos(q) - w * w * cmath.sin(q)))

    def along(d: complex) -> tuple[complex, complex]:  # of the rod at distance d from the pin
        return (pin[0] - d * (ddp * cmath.sin(p) + dp * dp * cmath.cos(p)),
                pin[1] - d * (ddp * cmath.cos(p) - dp * dp * cmath.sin(p)))

    centre, end = along(s), along(l)
    x = r * cmath.cos(q) + l * cmath.cos(p)
    stretch = 0.9 - x - n["l0"]  # pulls the piston towards +x
    small_x = n["mp"] * end[0] - n["k"] * stretch  # of the rod on the piston
    # Of the rod about its pin, turning by -p: the piston bears on it with -small_x and -small_y.
    arm = (l * cmath.cos(p), -l * cmath.sin(p))
    to_centre = (s * cmath.cos(p), -s * cmath.sin(p))
    spin = -n["Jz"] * ddp + n["mr"] * (to_centre[0] * centre[1] - to_centre[1] * centre[0])
    small_y = (-spin + arm[1] * small_x) / arm[0]  # arm x (-small) = spin
    pin_x = n["mr"] * centre[0] + small_x  # of the crank on the rod
    pin_y = n["mr"] * centre[1] + small_y
    torque = r * cmath.cos(q) * pin_y - r * cmath.sin(q) * pin_x
    return {"motor": torque, "guide": -small_y, "pin_x": pin_x, "pin_y": pin_y}


class DynamicSensitivity(unittest.TestCase):
    def near(self, actual: float, expected: float, what: str, scale: float = 1.0) -> None:
        self.assertIsNotNone(actual, what)
        self.assertLessEqual(abs(actual - expected), 1e-10 * max(abs(expected), scale),
                             f"{what}: {actual}, {expected}")

    def test_a_pendulum_with_a_spring_has_closed_forms(self) -> None:
        """T = (J + m s^2) a + m g s sin q - k free + c w: the spring counts from the drawn position."""
        m, s, q, w, a, g, k = 2.0, 0.4, 0.6, 3.0, 7.0, 9.81, 5.0
        found = derivatives_of(PENDULUM, "swings", "motor", "h.Rx", "h.Ry")
        free = 0.2
        for name, expected in {"ma": s * s * a + g * s * math.sin(q),
                               "d": 2.0 * m * s * a + m * g * math.sin(q), "Jz": a,
                               "q": m * g * s * math.cos(q), "w": 0.3, "a": 0.1 + m * s * s,
                               "gr": m * s * math.sin(q), "k": -free, "free": -k, "c": w}.items():
            self.near(found["motor"][name], expected, f"motor by {name}")
        # The hinge moves the centre: m (a s cos q - w^2 s sin q) along x.
        for name, expected in {"ma": s * (a * math.cos(q) - w * w * math.sin(q)),
                               "w": -2.0 * m * s * w * math.sin(q), "a": m * s * math.cos(q),
                               "Jz": 0.0, "k": 0.0}.items():
            self.near(found["h.Rx"][name], expected, f"h.Rx by {name}")
        for name, expected in {"ma": s * (a * math.sin(q) + w * w * math.cos(q)) + g,
                               "w": 2.0 * m * s * w * math.cos(q), "gr": m}.items():
            self.near(found["h.Ry"][name], expected, f"h.Ry by {name}")

    def test_a_slider_crank_agrees_with_complex_steps(self) -> None:
        found = derivatives_of(CRANK, "runs", "motor", "d.Ry", "b.Rx", "b.Ry")
        scale = abs(crank_forces(**CRANK_NUMBERS)["pin_x"])
        for name, value in CRANK_NUMBERS.items():
            step = 1e-30
            moved = crank_forces(**CRANK_NUMBERS | {name: complex(value, step)})
            for action, which in {"motor": "motor", "d.Ry": "guide", "b.Rx": "pin_x",
                                  "b.Ry": "pin_y"}.items():
                self.near(found[action][name], moved[which].imag / step, f"{action} by {name}",
                          scale / abs(value))

    def test_actions_are_linear_in_a_mass(self) -> None:
        """So that a difference of two analyses is exact but for rounding: linkages in plane and space, a
        platform on six legs, a rod that spins freely between balls."""
        for name in ("four_bar_masses", "quick_return", "watt_six_bar", "rssr", "cardan_shaft",
                     "gyroscope", "stewart_platform"):
            text = CASES[name]["yaml"]
            mass = re.search(r"mass: ([0-9.]+)", text)
            size = float(mass.group(1))
            text = f"parameters: {{kilos: {size}}}\n" + text.replace(mass.group(0), "mass: kilos", 1)
            low, high = (program.run("analyze", "--set", f"kilos={share * size!r}", "-", text=text)
                         ["cases"]["running"]["statics"]["actions"] for share in (1.0, 1.5))
            known = [action for action, value in low.items() if value is not None]
            scale = max(abs(low[action]) for action in known) / size
            words = [word for action in known for word in ("--of", action)]
            found = program.run("sensitivity", *words, "-", text=text)["cases"]["running"]["sensitivity"]
            for action in known:
                self.near(found[action]["by"]["kilos"]["derivative"],
                          (high[action] - low[action]) / (0.5 * size), f"{name}: {action}", scale)

    def test_contacts_that_move_bodies_with_inertia_are_refused(self) -> None:
        """Velocities have derivatives all the same: the follower is driven along the normal."""
        text = "parameters: {kilos: 0.3}\n" + CASES["cam_return_spring"]["yaml"].replace(
            "mass: 0.3", "mass: kilos")
        done = program.call("sensitivity", "--case", "slow", "--of", "g.vy", "-", text=text)
        self.assertIn("W0302", done.stderr)
        self.assertIn("how coupling 'c' moves its bodies on", done.stderr)
        values = program.report(done)["cases"]["slow"]["sensitivity"]
        self.assertEqual(values["g.vy"]["by"]["kilos"]["derivative"], 0.0)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
