"""Figures of motions in sweeps beside those of the motion alone: to a limit, with dwells, means.

Usage: swept_figures_test.py KINESTAT
"""

from __future__ import annotations

import math

import motion_case
import program
from reference_test_case import ReferenceTest
from swept_case import refused, swept
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

# A flat follower on an eccentric of 12 mm; the spring presses with 40 N.
CAM = """
kinestat: 1
space: planar
parameters: {load: 1 kg}
ground: frame
bodies:
  cam: {mass: 1 kg, inertia: 0, centre_of_mass: [0, 0]}
  follower: {mass: load, inertia: 0, centre_of_mass: [0, 70 mm]}
couplings:
  a: {type: revolute, bodies: [frame, cam], at: [0, 0]}
  c: {type: cam, bodies: [cam, follower], at: [12 mm, 31 mm], normal: y, radii: [31 mm, flat]}
  g: {type: prismatic, bodies: [frame, follower], at: [0, 70 mm], axis: y}
actuators: {shaft: {coupling: a}, spring: {coupling: g}}
cases:
  run: {motion: {shaft: 60 rad/s}, action: {spring: -40 N}, acceleration: {}}
motion: {drive: shaft, to: 360 deg, steps: 3, case: run, report: [c.Ry]}
"""

# A telescope between two slides, 3 along x and 1 along y, whose laws differ.
TELESCOPE = """
kinestat: 1
space: planar
parameters: {x: 3}
ground: frame
bodies: [across, up, sleeve, rod]
couplings:
  x: {type: prismatic, bodies: [frame, across], at: [x, 0], axis: x}
  y: {type: prismatic, bodies: [frame, up], at: [0, 1], axis: y}
  a: {type: revolute, bodies: [across, sleeve], at: [x, 0]}
  b: {type: revolute, bodies: [up, rod], at: [0, 1]}
  t: {type: prismatic, bodies: [sleeve, rod], at: [0, 1], axis: [-x, 1]}
actuators: {one: {coupling: x}, other: {coupling: y}, gauge: {coupling: t}}
motion:
  drives:
    - {drive: one, profile: [{to: -4, time: 1 s, law: harmonic}]}
    - {drive: other, profile: [{to: 2, time: 1 s, law: cycloidal}]}
  steps: 10
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
            self.assertAlmostEqual(row["ratio.mean [m/rad]"], -mean, delta=1e-6)  # of 100 steps
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

    def test_what_holds_between_the_rows_is_the_status_of_its_figures(self) -> None:
        # The lift is 12 mm times the sine: at the top 40 N less 43.2 N or 38.88 N.
        rows, _ = swept(CAM, "{vary: {load: {values: [1 kg, 0.9 kg]}}, report: [c.Ry.least]}")
        self.assertEqual([row["status"] for row in rows], ["contact_pulls", "solved"])
        for row, least in zip(rows, [-3.2, 1.12]):
            self.assertAlmostEqual(row["c.Ry.least [N]"], least, delta=1e-12)
        alone = program.call("motion", "-", text=CAM)
        self.assertIn("W0605", alone.stderr)
        self.assertIn("between the steps, the worst at 1.5708)", alone.stderr)
        self.assertEqual(program.call("motion", "--set", "load=0.9 kg", "-", text=CAM).stderr, "")

    def test_positions_have_figures_where_dead_points_may_be_missing(self) -> None:
        def length(time: float) -> float:
            across = 3 - 2 * (1 - math.cos(math.pi * time))
            up = 1 + 2 * (time - math.sin(2 * math.pi * time) / (2 * math.pi))
            return math.hypot(across, up)

        shortest = min(length(i / 10**5) for i in range(10**5 + 1))
        rows, _ = swept(TELESCOPE, "{vary: {x: {values: [3]}}, report: "
                        "[t.v.position.least, t.v.position.mean, t.v.dead_points]}")
        alone = program.run("motion", "-", text=TELESCOPE)["motion"]["figures"]["t.v/position"]
        self.assertAlmostEqual(rows[0]["t.v.position.least [m]"],
                               shortest - math.sqrt(10), delta=1e-9)
        self.assertEqual(rows[0]["t.v.position.mean [m]"], alone["mean"])
        self.assertIsNone(rows[0]["t.v.dead_points"])
        self.assertEqual(rows[0]["status"], "W0509")
        without = TELESCOPE.replace(", gauge: {coupling: t}", "")
        said = refused(without, "{vary: {x: [3]}, report: [t.v.dead_points]}")
        self.assertIn("make it one of an actuator", said)


if __name__ == "__main__":
    motion_case.main()
