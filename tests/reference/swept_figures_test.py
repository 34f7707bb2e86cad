"""Figures of motions in sweeps beside those of the motion alone: to a limit, with dwells, means.

Usage: swept_figures_test.py KINESTAT
"""

from __future__ import annotations

import math

import motion_case
import program
from reference_test_case import ReferenceTest
from swept_case import swept
from swept_motion_test import FOUR_BAR, least_slope

# The slider drives.
TO_THE_LIMIT = """
kinestat: 1
space: planar
parameters: {r: 2, l: 5}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [0, r]}
  c: {type: revolute, bodies: [rod, slider], at: [sqrt(l^2 - r^2), 0]}
  s: {type: prismatic, bodies: [frame, slider], at: [sqrt(l^2 - r^2), 0], axis: x}
actuators: {motor: {coupling: a}, press: {coupling: s}}
cases:
  pull: {motion: {press: 1 m/s}, action: {motor: 1 N*m}, input: press, output: motor}
motion: {drive: press, to: limit, steps: 100, case: pull, report: [velocity, ratio]}
"""

# The crank is drawn at 30 degrees.
DWELL = """
kinestat: 1
space: planar
parameters: {r: 2, l: 5, y: r/2, x: r*sqrt(3)/2}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [x, y]}
  c: {type: revolute, bodies: [rod, slider], at: [x + sqrt(l^2 - y^2), 0]}
  s: {type: prismatic, bodies: [frame, slider], at: [x + sqrt(l^2 - y^2), 0], axis: x}
actuators: {motor: {coupling: a}, press: {coupling: s}}
cases: {run: {motion: {}, action: {press: 10 N}, input: motor, output: press}}
motion:
  drive: motor
  profile: [{to: 40 deg, time: 1 s, law: cycloidal}, {dwell: 2 s},
            {to: 0, time: 1 s, law: cycloidal}]
  steps: 400
  case: run
  report: [position, velocity, ratio, mechanical_advantage]
"""


class Figures(ReferenceTest):
    """The same whichever command tells them, and of closed forms."""

    def test_figures_of_a_motion_to_its_limit_are_those_of_the_motion(self) -> None:
        """From an upright crank the slider goes out to where crank and rod are in line; there the
        crank is infinitely fast. By its angle from that line, from 90 degrees to 0, the slider is
        at r cos a + sqrt(l^2 - r^2 sin^2 a)."""
        r = 2.0
        rows, _ = swept(TO_THE_LIMIT, "{vary: {l: [5, 6]}, report: [ratio.mean, ratio.greatest, "
                                      "a.wz.velocity.greatest, a.wz.velocity.least]}")
        for row in rows:
            l = row["l"]

            def place(a: float) -> float:
                return r * math.cos(a) + math.sqrt(l * l - (r * math.sin(a)) ** 2)

            def slope(a: float) -> float:
                return (r * math.sin(a) + r * r * math.sin(a) * math.cos(a)
                        / math.sqrt(l * l - (r * math.sin(a)) ** 2))

            n = 2000
            weights = [1 if k in (0, n) else 4 if k % 2 else 2 for k in range(n + 1)]
            squares = [w * slope(k * math.pi / 2 / n) ** 2 for k, w in enumerate(weights)]
            mean = sum(squares) * math.pi / 6 / n / (place(0.0) - place(math.pi / 2))
            self.assertAlmostEqual(row["ratio.mean [m/rad]"], -mean, delta=1e-4)  # of 100 steps
            self.assertAlmostEqual(row["ratio.greatest [m/rad]"], 0.0, delta=1e-6)
            steepest = -least_slope(r, l)
            self.assertAlmostEqual(row["a.wz.velocity.greatest [rad/s]"], -1 / steepest, delta=1e-9)
            self.assertIsNone(row["a.wz.velocity.least [rad/s]"])
            self.assertEqual(row["status"], "no_value")

    def test_means_are_those_of_the_motion(self) -> None:
        turn = FOUR_BAR.replace("case: turn}", "case: turn, report: [position, velocity, action, ratio]}")
        for text, columns in ((turn, ["d.wz.position", "d.wz.velocity", "motor.action"]),
                              (DWELL, ["s.vx.position", "s.vx.velocity",
                                       "press.mechanical_advantage"])):
            figures = program.run("motion", "-", text=text)["motion"]["figures"]
            asked = ", ".join(one + ".mean" for one in columns)
            rows, _ = swept(text, f"{{vary: {{r: [2]}}, report: [{asked}]}}")
            for one, value in zip(columns, list(rows[0].values())[2:-1]):
                mean = figures["/".join(one.rsplit(".", 1))]["mean"]
                self.assertAlmostEqual(value, mean, delta=1e-8 * max(1.0, abs(mean)), msg=one)

    def test_quotients_have_the_value_of_their_position_in_a_dwell(self) -> None:
        """The crank runs by a cycloid in 1 s, rests for 2 s, and runs back. By virtual work the
        force on the slider is that of the motor by da/dx, which is geometry; its mean in time is
        that over all four seconds."""
        r, l = 2.0, 5.0

        def slope(t: float) -> float:
            a = math.pi / 6 + math.radians(40) * (t - math.sin(2 * math.pi * t) / (2 * math.pi))
            return (-r * math.sin(a) - r * r * math.sin(a) * math.cos(a)
                    / math.sqrt(l * l - (r * math.sin(a)) ** 2))

        n = 2000
        weights = [1 if k in (0, n) else 4 if k % 2 else 2 for k in range(n + 1)]
        runs = sum(w / -slope(k / n) for k, w in enumerate(weights)) / 3 / n
        figures = program.run("motion", "-", text=DWELL)["motion"]["figures"]
        self.assertAlmostEqual(figures["press/ratio"]["least"], 1 / slope(0.0), delta=1e-9)
        self.assertAlmostEqual(figures["press/ratio"]["greatest"], 1 / slope(1.0), delta=1e-9)
        rows, _ = swept(DWELL, "{vary: {r: [2]}, report: [press.mechanical_advantage.mean, "
                               "press.mechanical_advantage.least]}")
        found = rows[0]
        self.assertAlmostEqual(found["press.mechanical_advantage.mean [1/m]"],
                               (2 * runs - 2 / slope(1.0)) / 4, delta=1e-6)  # of 400 steps
        self.assertAlmostEqual(found["press.mechanical_advantage.least [1/m]"], -1 / slope(1.0),
                               delta=1e-9)


if __name__ == "__main__":
    motion_case.main()
