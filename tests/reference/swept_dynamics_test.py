"""Dynamics in sweeps: figures of motions in time, equivalent inertias, curves by tables.

Usage: swept_dynamics_test.py KINESTAT
"""

from __future__ import annotations

import math
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

import program
from dynamics_case import CASES
from reference_test_case import ReferenceTest
from swept_case import refused, swept

# A disc with its centre of mass beside the axis, turning steadily under its weight.
ROTOR = """
kinestat: 1
space: planar
parameters: {ma: 2, e: 0.1, n: 12, w: 4 rad/s, push: 6 N*m}
gravity: [0, -9.81]
ground: frame
bodies: {disc: {mass: ma, centre_of_mass: [e, 0], inertia: 0.3}}
couplings: {a: {type: revolute, bodies: [frame, disc], at: [0, 0]}}
actuators: {motor: {coupling: a}}
curves: {gas: {over: motor, period: 360 deg, points: [[0 deg, push], [360 deg, push]]}}
loads: {gas: {body: disc, couple: gas}}
cases: {turns: {motion: {motor: w}, acceleration: {}, action: {}}}
motion: {drive: motor, to: 360 deg, steps: n, case: turns}
"""

# Two gears and a rack, whose mass the pinion feels by the square of its radius.
RACK = """
kinestat: 1
space: planar
parameters: {r: 0.05, r2: 0.1, ma: 7, Jz: 0.02}
ground: frame
bodies: {pinion: {inertia: Jz}, wheel: {inertia: 3*Jz}, rack: {mass: ma, centre_of_mass: [0.3, -r]}}
couplings:
  a: {type: revolute, bodies: [frame, pinion], at: [0, 0]}
  b: {type: revolute, bodies: [frame, wheel], at: [0, r + r2]}
  g: {type: gear, bodies: [pinion, wheel], at: [0, r], tangent: x, pressure_angle: 20 deg}
  d: {type: prismatic, bodies: [frame, rack], at: [0, -r], axis: x}
  t: {type: gear, bodies: [pinion, rack], at: [0, -r], tangent: x, pressure_angle: 20 deg}
actuators: {motor: {coupling: a}, push: {coupling: d}}
cases:
  turns: {motion: {motor: 2 rad/s}, action: {push: 0}, input: motor}
"""


DISC = """kinestat: 1
space: planar
ground: frame
parameters: {e: 0.1}
bodies: {disc: {mass: 1, centre_of_mass: [e, 0], inertia: 0.02}}
couplings: {a: {type: revolute, bodies: [frame, disc], at: [0, 0], friction: {tau: 0.1, c: 0.05}}}
actuators: {motor: {coupling: a}}
cases:
  speeding: {motion: {motor: 10 rad/s}, acceleration: {motor: 20 rad/s^2}}
  steady: {motion: {motor: 10 rad/s}, acceleration: {}}
  still: {motion: {motor: 3 rad/s}, action: {}}
motion: {drive: motor, RANGE, steps: 12}
"""


class Dynamics(ReferenceTest):
    """RMS and peaks of drives and shaking forces, equivalent inertias."""

    def test_an_eccentric_disc_shakes_and_asks_for_torque(self) -> None:
        """Torque m g e cos phi - couple has A^2/2 as mean square beside the square of the mean, however
        many steps. It shakes by m e w^2."""
        rows, _ = swept(ROTOR, "{vary: {ma: [1, 2], e: [0.1, 0.05], n: [12, 90], "
                               "w: [3 rad/s, 50 rad/s]}, report: [motor.rms, motor.peak, "
                               "shaking.force.magnitude.rms, shaking.force.magnitude.peak, "
                               "shaking.force.x.rms, motor.inertia.mean]}")
        self.assertEqual(16, len(rows))
        for row in rows:
            size = row["ma"] * row["e"] * 9.81
            self.assertEqual("solved", row["status"])
            self.assertAlmostEqual(math.sqrt(size ** 2 / 2 + 36), row["motor.rms [N*m]"],
                                   delta=1e-11)
            self.assertAlmostEqual(size + 6, row["motor.peak [N*m]"], delta=1e-9)
            shakes = row["ma"] * row["e"] * row["w [rad/s]"] ** 2
            for figure in ("rms", "peak"):
                self.assertAlmostEqual(shakes, row[f"shaking.force.magnitude.{figure} [N]"],
                                       delta=1e-11 * shakes)
            self.assertAlmostEqual(shakes * math.sqrt(1 / 2), row["shaking.force.x.rms [N]"],
                                   delta=1e-11 * shakes)
            self.assertAlmostEqual(0.3 + row["ma"] * row["e"] ** 2, row["motor.inertia.mean [kg*m^2]"],
                                   delta=1e-12)

    def test_rows_are_those_of_motions_by_themselves(self) -> None:
        columns = {"motor.rms": ("motor/action", "rms"),
                   "ground.force.magnitude.rms": ("ground/force/magnitude", "rms"),
                   "kinetic_energy.mean": ("kinetic_energy", "mean")}
        rows, _ = swept(ROTOR, f"{{vary: {{e: [0.1, 0.2], w: [3 rad/s]}}, report: [{', '.join(columns)}]}}")
        for row in rows:
            text = ROTOR.replace("case: turns}", "case: turns, report: [action, dynamics]}")
            motion = program.run("motion", "--set", f"e={row['e']}", "--set", "w=3 rad/s", "-", text=text)
            figures = motion["motion"]["figures"]
            for column, (name, figure) in columns.items():
                title = next(key for key in row if key.startswith(column + " "))
                self.assertEqual(figures[name][figure], row[title], column)

    def test_each_case_runs_by_its_own_speed_and_acceleration(self) -> None:
        """w^2 = w0^2 + 2 a phi, and the torque of friction and inertia is 0.1 + 0.05 w + J a."""
        figures = "report: [a.wz.velocity.peak, motor.greatest, motor.least, a.loss.greatest]"
        fast = math.sqrt(10 ** 2 + 2 * 20 * 6)
        expected = {"speeding": (fast, 20, 10), "steady": (10, 0, 10), "still": (3, 0, 3)}
        for case in ("", ", case: speeding", ", case: steady", ", case: still"):
            for cases in (("speeding", "steady", "still"), ("steady", "speeding"), ("speeding",)):
                rows, _ = swept(DISC.replace("RANGE", "to: 6 rad" + case),
                                f"{{vary: {{e: [0.1]}}, {figures}, cases: [{', '.join(cases)}]}}")
                self.assertEqual([row["case"] for row in rows], list(cases))
                for row in rows:
                    speed, acceleration, first = expected[row["case"]]
                    values = [value for key, value in row.items() if "[" in key]
                    rubs = 0.1 + 0.05 * speed
                    wanted = (speed, rubs + 0.03 * acceleration,
                              0.1 + 0.05 * first + 0.03 * acceleration, rubs * speed)
                    self.assertEqual(row["status"], "solved")
                    for value, number in zip(values, wanted, strict=True):
                        self.assertAlmostEqual(value, number, delta=1e-9, msg=f"{case} {row}")

    def test_the_way_in_a_time_is_that_of_each_case(self) -> None:
        """In half a second, v t + a t^2 / 2."""
        rows, _ = swept(DISC.replace("RANGE", "time: 0.5 s, case: speeding"),
                        "{vary: {e: [0.1]}, report: [disc.rotation.z.greatest], cases: [speeding, steady, still]}")
        for row, wanted in zip(rows, (5 + 2.5, 5, 1.5), strict=True):
            value = next(value for key, value in row.items() if "greatest" in key)
            self.assertAlmostEqual(value, wanted, delta=1e-12)

    def test_the_input_feels_all_inertia_by_the_square_of_its_ratio(self) -> None:
        rows, _ = swept(RACK, "{vary: {r: [0.05, 0.03], ma: [7, 1], Jz: [0.02, 0.5]}, "
                              "report: [equivalent_inertia, b.wz]}")
        self.assertEqual(8, len(rows))
        for row in rows:
            expected = row["Jz"] * (1 + 3 * (row["r"] / 0.1) ** 2) + row["ma"] * row["r"] ** 2
            self.assertAlmostEqual(expected, row["equivalent_inertia [kg*m^2]"], delta=1e-13)
        slides, _ = swept(RACK.replace("motion: {motor: 2 rad/s}, action: {push: 0}, input: motor",
                                       "motion: {push: 1 m/s}, action: {motor: 0}, input: push"),
                          "{vary: {r: [0.05, 0.03]}, report: [equivalent_inertia]}")
        for row in slides:
            self.assertAlmostEqual(0.02 * (1 / row["r"] ** 2 + 3 / 0.1 ** 2) + 7,
                                   row["equivalent_inertia [kg]"], delta=1e-11)

    def test_gears_feel_what_their_table_tells(self) -> None:
        """By fractions; the ring adds the square of its speed."""
        case = CASES["ravigneaux_inertia"]
        text = "parameters: {Jr: 0.06}\n" + case["yaml"].replace(
            ", input_acceleration: 200 rad/s^2", "").replace("ring: {inertia: {polar: 0.06,",
                                                                  "ring: {inertia: {polar: Jr,")
        rows, _ = swept(text, "{vary: {Jr: [0.06, 0.2]}, cases: [M1, M2, M3, MR], "
                              "report: [equivalent_inertia]}")
        self.assertEqual(8, len(rows))
        for row in rows:
            gear = case["expected"]["gears"][row["case"]]
            ring = float(Fraction(gear["speeds"]["ring"]))
            expected = gear["equivalent_inertia_value"] + (row["Jr"] - 0.06) * ring ** 2
            self.assertAlmostEqual(expected, row["equivalent_inertia [kg*m^2]"], delta=1e-13)

    def test_what_has_no_equivalent_inertia_is_refused(self) -> None:
        sweep = "{vary: {r: [0.05]}, report: [equivalent_inertia]}"
        self.assertIn("case 'turns' names none", refused(RACK.replace(", input: motor", ""), sweep))
        self.assertIn("none has any", refused(
            RACK.replace("pinion: {inertia: Jz}, wheel: {inertia: 3*Jz}, rack: {mass: ma, centre_of_mass: [0.3, -r]}",
                         "pinion: {}, wheel: {}, rack: {}").replace(", ma: 7, Jz: 0.02", ""), sweep))
        # A mass that nobody places would count as if it were at the origin.
        self.assertIn("no centre of mass", refused(RACK.replace(", centre_of_mass: [0.3, -r]", ""), sweep))

    def test_a_table_gives_a_curve_other_points_in_all_states(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder, "gas.csv")
            table.write_text("turn [deg],couple [N*m]\n0,10\n360,10\n", encoding="utf-8")
            sweep = "{vary: {ma: [1, 2]}, report: [motor.mean]}"
            plain, _ = swept(ROTOR, sweep)
            other, _ = swept(ROTOR, sweep, "--curve", f"gas={table}")
            for row in plain:
                self.assertAlmostEqual(-6, row["motor.mean [N*m]"], delta=1e-11)
            for row in other:
                self.assertAlmostEqual(-10, row["motor.mean [N*m]"], delta=1e-11)
            # What was begun with other points is not gone on with.
            file = Path(folder, "rotor.yaml")
            file.write_text(f"{ROTOR}\nsweep: {sweep}\n", encoding="utf-8")
            plans = []
            for number in (10, 11):
                table.write_text(f"turn [deg],couple [N*m]\n0,{number}\n360,{number}\n", encoding="utf-8")
                done = program.plain("sweep", "--curve", f"gas={table}", "--shard", "1/2",
                                     "--out", folder, str(file))
                self.assertEqual("", "" if done.returncode == 0 else done.stderr)
                shard = next(Path(folder).glob("*.shard"))
                plans.append(shard.read_text(encoding="utf-8").splitlines()[0])
                shard.unlink()
            self.assertNotEqual(*plans)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
