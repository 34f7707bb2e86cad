#!/usr/bin/env python3
"""Checks mechanisms with inertia, row by row, against two or three independent ways.

Usage: dynamics_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import re
import sys
import unittest

import program
from dynamics_case import CASES, DynamicsCase, motion_of
from motion_case import Motion


def as_list(value: float | list) -> list:
    return value if isinstance(value, list) else [value]


class DynamicsTest(DynamicsCase):
    def check_wrench(self, motion: Motion, step: int, name: str, expected: list) -> None:
        """Planar [Tz, Fx, Fy] or spatial [T, F]; moments and forces are kinds of their own."""
        planar = len(expected) == 3
        moments, forces = (expected[:1], expected[1:]) if planar else (expected[:3], expected[3:])
        for kind, axes, values in (("moment", "z" if planar else "xyz", moments),
                                   ("force", "xy" if planar else "xyz", forces)):
            self.near_all([motion[f"{name}/{kind}/{axis}"][step] for axis in axes], values,
                          f"{name} {kind} at step {step}")

    def check_row(self, case: dict, motion: Motion, step: int) -> None:
        row = case["expected"]["rows"][step]
        what = f"{case['id']} step {step} "
        self.near(motion["time"][step], row["time"], 1.0, what + "time")
        for drive, value in row["drive"].items():
            self.near(motion[f"{drive}/drive"][step], value, max(abs(value), 1.0), what + drive)
        largest = max(abs(x) for x in row["action"].values())
        for actuator, value in row["action"].items():
            self.near(motion[f"{actuator}/action"][step], value, largest, what + actuator)
        self.check_wrench(motion, step, "ground", row["ground"])
        self.check_wrench(motion, step, "shaking", row["shaking"])
        energy = row["kinetic_energy"]
        self.near(motion["kinetic_energy"][step], energy, energy, what + "energy")
        rate = row["kinetic_energy_rate"]
        self.near(motion["kinetic_energy_rate"][step], rate,
                  max(abs(rate), energy), what + "energy rate")
        for d, drive in enumerate(row["drive"]):
            mass = row["mass_matrix"][d][d]
            bias = row["bias"][d]
            turns = f"{drive}/inertia" in motion.names
            self.near(motion[f"{drive}/{'inertia' if turns else 'mass'}"][step], mass, mass,
                      what + "equivalent inertia")
            self.near(motion[f"{drive}/bias_{'moment' if turns else 'force'}"][step], bias,
                      max(abs(x) for x in row["bias"] + [largest]), what + "bias")
        for body, expected in row["bodies"].items():
            angular = as_list(expected["angular_acceleration"])
            axes = "z" if len(angular) == 1 else "xyz"
            self.near_all([motion[f"{body}/angular_acceleration/{axis}"][step] for axis in axes],
                          angular, what + body)

    def check_drawn(self, case: dict) -> None:
        """Everything of the first row, whose position is drawn."""
        row = case["expected"]["rows"][0]
        report = program.run("analyze", "-", text=case["yaml"])
        one = report["cases"]["running"]
        planar = report["mechanism"]["space"] == "planar"
        for coupling, expected in row["wrench"].items():
            actual = one["statics"]["couplings"][coupling]["wrench"]
            if planar:
                actual = [actual[2], actual[3], actual[4]]
            split = 1 if planar else 3
            self.near_all(actual[:split], expected[:split], coupling)
            self.near_all(actual[split:], expected[split:], coupling)
        for body, expected in row["bodies"].items():
            actual = one["dynamics"]["bodies"][body]
            size = len(expected["centre_acceleration"])
            self.near_all(actual["centre_acceleration"][:size], expected["centre_acceleration"],
                          body)
        self.assertLessEqual(one["dynamics"]["two_ways"], 1e-12)

    def test_motor_with_masses_in_every_row(self) -> None:
        for name in ("slider_crank_engine", "four_bar_masses", "four_bar_balanced", "quick_return",
                     "watt_six_bar", "rssr", "cardan_shaft", "gyroscope", "stewart_platform"):
            case = CASES[name]
            with self.subTest(name):
                motion = motion_of(case)
                self.assertGreaterEqual(len(motion.rows), len(case["expected"]["rows"]))
                for step in range(len(case["expected"]["rows"])):
                    self.check_row(case, motion, step)
                self.check_drawn(case)

    def test_friction_by_what_presses_with_inertia(self) -> None:
        """Nine scalar equations, solved to 1e-36."""
        case = CASES["slider_crank_friction"]
        motion = motion_of(case)
        for row in case["expected"]["rows"]:
            step = round(row["time"] / 0.01)
            self.near(motion["motor/drive"][step], row["turn"], 1.0, "turn")
            self.near(motion["motor/action"][step], row["torque"], 100.0, "torque")
            for coupling, bearing in row["bearing"].items():
                for axis, value in zip("xy", bearing):
                    self.near(motion[f"{coupling}.R{axis}/action"][step], value, 1000.0, coupling)

    def test_spring_of_a_cam_follower(self) -> None:
        """Follower lift y = e sin + distance of centres, by hand; the spring is on a freedom."""
        case = CASES["cam_return_spring"]
        motion = motion_of({**case, "yaml": case["yaml"].replace(
            "report: [acceleration, action, dynamics]", "report: [position, velocity, acceleration, action]")})
        contact = next(name for name in motion.names if re.match(r"c\.\w+/action", name))
        for row in case["expected"]["rows"]:
            step = round(row["turn_deg"] / 30)
            what = f"cam at {row['turn_deg']} deg: "
            self.near(motion["g.vy/position"][step], row["lift"], 0.1, what + "lift")
            self.near(motion["g.vy/velocity"][step], row["velocity"], 1.0, what + "velocity")
            self.near(motion["g.vy/acceleration"][step], row["acceleration"], 100.0, what + "bend")
            self.near(abs(motion[contact][step]), row["contact"], 300.0, what + "contact")
            self.near(motion["motor/action"][step], row["torque"], 10.0, what + "torque")

    def test_gas_spring_and_damper_of_a_hatch(self) -> None:
        """Equilibrium of the lid alone, with the law of the drive in closed form."""
        case = CASES["hatch_gas_spring"]
        motion = motion_of({**case, "yaml": case["yaml"].replace(
            "report: [action, dynamics]", "report: [velocity, acceleration, action]")})
        for row, step in zip(case["expected"]["rows"], (0, 6, 16, 25, 34, 44, 50)):
            what = f"hatch after {row['time']} s: "
            self.near(motion["time"][step], row["time"], 1.0, what + "time")
            self.near(motion["hand/drive"][step], row["turn"], 1.0, what + "turn")
            self.near(motion["h.wz/velocity"][step], row["speed"], 1.0, what + "speed")
            self.near(motion["h.wz/acceleration"][step], row["acceleration"], 1.0, what + "bend")
            self.near(motion["hand/action"][step], row["torque"], 100.0, what + "torque")
            for axis, value in zip("xy", row["hinge"]):
                self.near(motion[f"h.R{axis}/action"][step], value, 1000.0, what + "hinge")

    def test_lift(self) -> None:
        """m (g + a) on both sides of the drum."""
        expected = CASES["lift"]["expected"]
        report = program.run("analyze", "-", text=CASES["lift"]["yaml"])["cases"]["starting"]
        actions = report["statics"]["actions"]
        self.near(actions["rope_1.F"], expected["tension_car"], 1e4, "car")
        self.near(actions["rope_2.F"], expected["tension_counterweight"], 1e4, "counterweight")
        self.near(actions["a.Ry"], expected["bearing_Ry_with_drum"], 1e4, "bearing")
        self.near(actions["motor"], expected["motor"], 1e3, "motor")
        reduced = report["dynamics"]["reduced"]
        mass = next(iter(reduced.values()))["mass"]
        self.near(mass * 0.25 ** 2, expected["reflected_inertia"], 100.0, "reflected inertia")

    def test_belt_drive(self) -> None:
        expected = CASES["belt_drive"]["expected"]
        report = program.run("analyze", "-", text=CASES["belt_drive"]["yaml"])["cases"]["starting"]
        actions = report["statics"]["actions"]
        self.near(actions["in"], expected["torque_in"], 10.0, "torque")
        self.near(actions["belt_2.F"], expected["belt_2.F"], 1e3, "belt")
        self.near(report["dynamics"]["reduced"]["a.wz"]["inertia"], expected["reflected_inertia"],
                  1.0, "reflected inertia")
        self.near(report["dynamics"]["bodies"]["driven"]["angular_acceleration"][2],
                  expected["acceleration_out"], 100.0, "acceleration")

    def test_laws(self) -> None:
        """Range and time of one: columns are the shares themselves."""
        text = CASES["drive_laws"]["yaml"]
        for law in CASES["drive_laws"]["expected"]["laws"]:
            word = law["law"].replace("poly", "polynomial_")
            with self.subTest(word):
                one = text.replace("law: polynomial_345", f"law: {word}")
                one = one.replace("case: turning", "case: turning, report: [position, velocity, "
                                  "acceleration]")
                motion = Motion(program.run("motion", "-", text=one))
                for u, share, slope, bend in law["values"]:
                    step = round(20 * u)
                    self.near(motion["a.wz/position"][step], share, 0.01, f"s({u})")
                    self.near(motion["a.wz/velocity"][step], slope, 0.01, f"s'({u})")
                    self.near(motion["a.wz/acceleration"][step], bend, 0.01, f"s''({u})")

    def test_drive_by_a_spline_through_a_table(self) -> None:
        """Tridiagonal moments in 40 digits, and CubicSpline of SciPy."""
        case = CASES["drive_table"]
        tolerance = case["tolerance"]["relative"]
        for spline in case["expected"]["splines"]:
            ends = spline["ends"]
            points = ", ".join(f"[{t} s, {x} rad]" for t, x in spline["points"])
            last = spline["points"][-1][0]
            steps = round(last / 0.01)
            text = re.sub(r"points: \[.*\]\], ", f"points: [{points}], ", case["yaml"])
            text = text.replace("ends: rest", f"ends: {ends}").replace("steps: 12", f"steps: {steps}")
            text = text.replace("case: turning", "case: turning, report: [position, velocity, "
                                f"acceleration], time: {last} s")
            with self.subTest(ends):
                motion = Motion(program.run("motion", "-", text=text))
                columns = [motion[f"a.wz/{quantity}"]
                           for quantity in ("position", "velocity", "acceleration")]
                scales = [max(abs(value) for value in column) for column in columns]
                for time, *values in spline["values"]:
                    step = round(time / 0.01)
                    self.near(motion["time"][step], time, 1.0, "time")
                    for column, scale, value in zip(columns, scales, values):
                        self.assertLessEqual(abs(column[step] - value), tolerance * scale,
                                             f"{ends} at {time} s: {column[step]} is not {value}")

    def test_equivalent_inertia_of_gears(self) -> None:
        """Fractions, by the speeds of Willis' equations."""
        text = CASES["ravigneaux_inertia"]["yaml"].replace(" input_acceleration: 200 rad/s^2,", "")
        states = program.run("shift", "-", text=text)["shift"]["states"]
        for name, gear in CASES["ravigneaux_inertia"]["expected"]["gears"].items():
            self.near(states[name]["equivalent_inertia"], gear["equivalent_inertia_value"], 0.01,
                      name)
            self.near(sum(states[name]["inertia_shares"].values()), 1.0, 1.0, name)

    def test_torques_of_gears_that_speed_up(self) -> None:
        text = CASES["ravigneaux_inertia"]["yaml"]
        text = re.sub(r"^shift:.*$", "", text, flags=re.M).replace("loads: {}", "")
        for name, gear in CASES["ravigneaux_inertia"]["expected"]["gears"].items():
            engaged = ", ".join(f"{element}: 0" for element in gear["engaged"])
            opened = ", ".join(f"{e}: 0" for e in ("C1", "C2", "B1", "B2") if e not in gear["engaged"])
            case = (f"cases: {{gear: {{motion: {{in: 100, {engaged}}}, acceleration: {{in: 200}}, "
                    f"action: {{out: {gear['out']}, {opened}}}}}}}\n")
            report = program.run("analyze", "-", text=text + case)["cases"]["gear"]
            actions = report["statics"]["actions"]
            self.near(actions["in"], gear["torque_in_value"], 100.0, name)
            for element, torque in gear["elements"].items():
                self.near(abs(actions[element]), abs(torque), 100.0, f"{name} {element}")
            for mesh, force in gear["mesh"].items():
                # Tangential: the planets stand on +y.
                self.near(report["statics"]["couplings"][mesh]["wrench"][3], force, 1e3,
                          f"{name} {mesh}")

if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
