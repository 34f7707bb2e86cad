#!/usr/bin/env python3
"""Sweeps, end to end: the contents of their rows."""

from __future__ import annotations

import csv
import json
import math
import random
import re
import subprocess
import sys
import time

import jsonschema

from sweep_case import (ROOT, SWEEP, TRAIN, InFolder, has_sanitizers, kinestat, main, program,
                        sanitized)

# Cranks whose coupler is stretched where the slider rests: x = 5 is a dead point.
CRANK = """
kinestat: 1
space: planar
parameters: {reach: 4}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [2, 5 - reach]}
  c: {type: revolute, bodies: [rod, slider], at: [6, 0]}
  d: {type: prismatic, bodies: [frame, slider], at: [6, 0], axis: x}
actuators:
  drive: {coupling: a}
  load: {coupling: d}
cases:
  push: {motion: {load: 1 m/s}, action: {load: 1 N}, input: load, output: drive}
"""

# By Willis: the ring held, the ratio is 1 + R/S, and carrier and ring turn as the sun, so that K slips
# by the speed of the carrier, in the sense of the input: against it K would engage. Locked, K bears
# -R/S of the torque of the input: it holds where that is positive, and lets go else.
FREEWHEEL = """
kinestat: 1
space: planar
units: {length: mm}
parameters: {S: 20, P: 10, speed: 10 rad/s, torque: 10 N*m}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  I: {type: revolute, bodies: [housing, sun]}
  R: {type: revolute, bodies: [housing, ring]}
  C: {type: revolute, bodies: [housing, carrier]}
  p: {type: revolute, bodies: [carrier, planet]}
  B: {type: brake, bodies: [housing, ring]}
  K: {type: clutch, bodies: [ring, carrier], one_way: +}
gears:
  module: 1 mm
  members:
    s: {body: sun, teeth: S}
    p: {body: planet, teeth: P}
    r: {body: ring, teeth: S + 2*P, internal: true}
  meshes:
    sp: {members: [s, p], carrier: carrier}
    pr: {members: [p, r], carrier: carrier}
actuators: {in: {coupling: I}, out: {coupling: C}}
shift:
  input: in
  output: out
  elements: [B, K]
  input_motion: speed
  input_action: torque
  names: {first: [B], second: [K]}
sweep:
  vary:
    S: {values: [20, 40]}
    speed: {values: [10 rad/s, -10 rad/s]}
    torque: {values: [10 N*m, -10 N*m]}
  report: [ratio, step, B, K]
"""

# Two suns of S1 and S2 teeth and a stepped planet of P1 and P2: with the first sun held and the
# carrier driven the second turns (S2 P1 - S1 P2)/(S2 P1) as fast, which is nothing for the values
# here, and forwards or backwards for others. With both suns held nothing moves; with none, they are
# free.
TWO_SUNS = """
kinestat: 1
space: planar
parameters: {S1: 20, S2: 20, P1: 20, P2: 20, a: 40 mm}
ground: housing
bodies: [first, second, carrier, planet]
couplings:
  f: {type: revolute, bodies: [housing, first], at: [0, 0]}
  s: {type: revolute, bodies: [housing, second], at: [0, 0]}
  c: {type: revolute, bodies: [housing, carrier], at: [0, 0]}
  p: {type: revolute, bodies: [carrier, planet], at: [a, 0]}
  m1: {type: gear, bodies: [first, planet], at: [a*S1/(S1 + P1), 0], line_of_action: y}
  m2: {type: gear, bodies: [second, planet], at: [a*S2/(S2 + P2), 0], line_of_action: y}
  B: {type: brake, bodies: [housing, first], at: [0, 0]}
  K: {type: clutch, bodies: [carrier, second], at: [0, 0]}
actuators: {in: {coupling: c}, out: {coupling: s}}
shift:
  input: in
  output: out
  elements: [B, K]
  input_motion: 100 rad/s
  names: {creeper: [B], direct: [K], open: [], both: [B, K]}
"""


# A clutch between two ends of one shaft, whose torque nothing determines: with it alone the wheel is
# free, with the brake nothing is open.
CLUTCH_IN_ONE_SHAFT = """
kinestat: 1
space: planar
ground: housing
parameters: {T: 50 N*m}
bodies: [shaft, end, gear, wheel]
couplings:
  s: {type: revolute, bodies: [housing, shaft], at: [0, 0]}
  g: {type: revolute, bodies: [housing, gear], at: [0, 0.05]}
  w: {type: revolute, bodies: [housing, wheel], at: [0.2, 0]}
  r: {type: rigid, bodies: [shaft, end], at: [0, 0]}
  K: {type: clutch, bodies: [shaft, end], at: [0, 0]}
  B: {type: brake, bodies: [housing, wheel], at: [0.2, 0]}
gears:
  module: 2 mm
  members: {driving: {body: shaft, teeth: 20}, driven: {body: gear, teeth: 30}}
  meshes: {m: {members: [driving, driven], carrier: housing}}
losses: {gear_external: 0.02}
actuators: {in: {coupling: s}, out: {coupling: g}}
shift: {input: in, output: out, elements: [K, B], input_motion: 100 rad/s, input_action: T}
sweep: {vary: {T: [50 N*m, 20 N*m]}, report: [out, lossy.out]}
"""


class Rows(InFolder):
    """What the rows say."""

    def test_the_ratio_is_one_plus_ring_over_sun(self) -> None:
        rows = self.rows(TRAIN + SWEEP)
        low = [row for row in rows if row["case"] == "low"]
        self.assertEqual(len(low) * 2, len(rows))
        for row in low:
            sun, planet = int(row["Ns"]), int(row["Np"])
            self.assertAlmostEqual(float(row["ratio"]), 1 + (sun + 2 * planet) / sun, delta=1e-13)

    def test_the_ratio_of_a_four_bar_follows_its_pole(self) -> None:
        file = ROOT / "mechanisms/sweeps/four_bar_height.yaml"
        rows = list(csv.DictReader(kinestat("sweep", "--quiet", file).stdout.splitlines()))
        self.assertEqual(len(rows), 34)
        for row in rows:
            height = float(row["height [m]"])
            ratio = (6 * height - 3) / (18 - height)
            self.assertAlmostEqual(float(row["ratio"]), ratio, delta=1e-12)

    def test_rows_are_those_of_single_analyses(self) -> None:
        rows = self.rows(TRAIN + SWEEP)
        seed = random.SystemRandom().randrange(10**6)
        print(f"seed {seed}")
        for row in random.Random(seed).sample(rows, 25):
            done = kinestat(
                "analyze", "--format", "json", "--set", f"Ns={row['Ns']}", "--set",
                f"Np={row['Np']}", "--set", f"torque={row['torque [N*m]']} N*m",
                self.folder / "train.yaml",
            )
            case = json.loads(done.stdout)["cases"][row["case"]]
            for title, value in (
                ("ratio", case["ratio"]), ("torque_ratio", case["torque_ratio"]),
                ("brake [N*m]", case["statics"]["actions"]["brake"]),
                ("e.Rc [N]", case["statics"]["actions"]["e.Rc"]),
                ("d.wz [rad/s]", case["kinematics"]["freedoms"]["d.wz"]),
            ):
                # Other pivots round otherwise, no more.
                self.assertAlmostEqual(float(row[title]), value, delta=1e-13 * abs(value))

    def test_ranges_are_exact_and_teeth_are_whole(self) -> None:
        text = TRAIN + """
sweep:
  vary: {module: {from: 0.1, to: 0.3, step: 0.1}, Ns: {from: 30, to: 18, step: -6}}
  cases: [low]
  report: [ratio]
"""
        rows = self.rows(text)
        self.assertEqual([row["module"] for row in rows[::3]], ["0.1", "0.2", "0.3"])
        self.assertEqual([row["Ns"] for row in rows[:3]], ["30", "24", "18"])

    def test_what_is_left_out_counts_for_the_first_requirement(self) -> None:
        text = TRAIN + """
sweep:
  vary: {Ns: {from: 1, to: 10, step: 1}, Np: {from: 1, to: 10, step: 1}}
  require: [Np > 2, Ns > 4, Ns + Np > 12]
  cases: [low]
  report: [ratio]
"""
        out = self.new_folder("out")
        done = kinestat("sweep", "--out", out, self.write(text))
        self.assertEqual(done.returncode, 0, done.stderr)
        told = json.loads((out / "train.sweep.json").read_text())
        schema = json.loads((ROOT / "schemas" / "sweep.schema.json").read_text("utf-8"))
        jsonschema.Draft7Validator(schema).validate(told)
        excluded = [one["excluded"] for one in told["require"]]
        pairs = [(s, p) for s in range(1, 11) for p in range(1, 11)]
        self.assertEqual(excluded[0], sum(p <= 2 for s, p in pairs))
        self.assertEqual(excluded[1], sum(p > 2 and s <= 4 for s, p in pairs))
        self.assertEqual(excluded[2], sum(p > 2 and s > 4 and s + p <= 12 for s, p in pairs))
        self.assertEqual(told["analysed"], 100 - sum(excluded))
        self.assertEqual(told["rows"], told["analysed"])

    def test_requirements_of_the_outer_parameters_skip_at_once(self) -> None:
        text = TRAIN.replace("torque: 5 N*m", "torque: 5 N*m, x: 1, y: 1") + """
sweep:
  vary:
    x: {from: 1, to: 100000, step: 1}
    y: {from: 1, to: 1000000, step: 1}
    Ns: {from: 20, to: 21, step: 1}
  require: [x == 77, y == x*x]
  cases: [low]
  report: [ratio]
"""
        rows = self.rows(text)
        self.assertEqual([(row["x"], row["y"], row["Ns"]) for row in rows],
                         [("77", "5929", "20"), ("77", "5929", "21")])

    def test_a_singular_position_is_a_row_and_its_neighbours_are_right(self) -> None:
        """Fault 75: with the rod along the slider's way, the slider cannot drive the crank."""
        text = CRANK + """
sweep:
  vary: {reach: {from: 4, to: 6, step: 0.25}}
  report: [ratio, a.wz]
"""
        rows = self.rows(text)
        for row in rows:
            height = 5 - float(row["reach"])
            if height == 0:
                self.assertEqual((row["status"], row["ratio [m/rad]"]), ("singular", ""))
                continue
            # The pole of the rod lies above the slider on the line of the crank, at 6/2 of its height.
            speed = -6 / 4 * height
            self.assertEqual(row["status"], "solved")
            self.assertAlmostEqual(float(row["ratio [m/rad]"]), speed, delta=1e-12)

    def test_a_set_that_rests_is_locked(self) -> None:
        """Fault 79: the ratio is 0/0."""
        text = TRAIN + """
sweep:
  vary: {Ns: [20, 24]}
  cases: [rest, held]
  report: [ratio]
"""
        text = text.replace("cases:\n", """cases:
  rest: {motion: {motor: 0, brake: 0}, input: motor, output: wheel}
  held: {motion: {motor: 1 rad/s, wheel: 0}, input: motor, output: wheel}
""", 1)
        rows = self.rows(text)
        self.assertEqual([(row["ratio"], row["status"]) for row in rows],
                         [("", "locked"), ("", "no_ratio")] * 2)

    def test_a_mechanism_that_cannot_move_is_locked(self) -> None:
        """Fault 70: net degree of freedom 0."""
        text = CRANK.replace("  d: {type: prismatic, bodies: [frame, slider], at: [6, 0], axis: x}",
                             "  d: {type: revolute, bodies: [frame, slider], at: [6, -2]}\n"
                             "  e: {type: revolute, bodies: [frame, slider], at: [7, 3]}")
        text = text.replace("load: 1 m/s", "load: 1 rad/s").replace("action: {load: 1 N}, ", "")
        rows = self.rows(text + "\nsweep: {vary: {reach: [3, 4]}, report: [ratio]}\n")
        self.assertEqual([row["status"] for row in rows], ["locked", "locked"])

    def test_geometry_that_does_not_exist_is_a_row_with_its_code(self) -> None:
        text = CRANK.replace("at: [2, 5 - reach]", "at: [2, sqrt(9 - reach^2)]") + """
sweep:
  vary: {reach: [2, 3, 4]}
  require: [1/(reach - 2) > -100]
  report: [ratio]
"""
        rows = self.rows(text.replace("reach: 4}", "reach: 1}"))
        self.assertEqual([row["status"] for row in rows], ["E0316", "singular", "E0316"])

    def test_top_rows_are_the_best_and_ties_go_to_the_first(self) -> None:
        text = TRAIN + SWEEP
        everything = self.rows(text)
        for order, sign in (("largest", -1), ("smallest", 1)):
            best = self.rows(text, "--top", "13", "--by", "ratio", "--order", order)
            wanted = sorted(everything, key=lambda row: sign * float(row["ratio"]))[:13]
            self.assertEqual(best, wanted)

    def test_json_lines_say_the_same_as_csv(self) -> None:
        table = self.rows(TRAIN + SWEEP)
        done = kinestat("sweep", "--format", "json", self.folder / "train.yaml")
        objects = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(len(objects), len(table))
        for row, one in zip(table, objects):
            self.assertEqual(list(row), list(one))
            for title, cell in row.items():
                value = one[title]
                text = value if isinstance(value, str) else json.dumps(value)
                self.assertEqual(cell, "" if value is None else text)

    def test_parameters_that_move_the_shape_of_couplings(self) -> None:
        """The force along the line of action, times cos alpha, is the torque over the radius."""
        import math

        text = TRAIN + """
sweep: {vary: {alpha: {from: 15 deg, to: 25 deg, step: 2.5 deg}}, cases: [low], report: [e.Rc]}
"""
        for row in self.rows(text):
            force = float(row["e.Rc [N]"]) * math.cos(math.radians(float(row["alpha [deg]"])))
            self.assertAlmostEqual(abs(force), 5 / 0.024, delta=1e-9)


class Gears(InFolder):
    """What combinations of shift elements are is decided in every state."""

    def test_freewheels_hold_or_slip_by_the_signs_of_the_state(self) -> None:
        rows = self.rows(FREEWHEEL, "--jobs", "2")
        self.assertEqual(len(rows), 16)
        for row in rows:
            sun, ring = float(row["S"]), float(row["S"]) + 20
            speed, torque = float(row["speed [rad/s]"]), float(row["torque [N*m]"])
            with self.subTest(row):
                if row["case"] == "first":
                    self.assertEqual(row["status"], "solved" if speed > 0 else "tie-up")
                    self.assert_number(row["ratio"], 1 + ring / sun if speed > 0 else None)
                    self.assert_number(row["B [N*m]"], torque * ring / sun if speed > 0 else None)
                    self.assert_number(row["step"], None)
                else:
                    holds = torque < 0
                    self.assertEqual(row["status"], "solved" if holds else "neutral")
                    self.assert_number(row["ratio"], 1 if holds else None)
                    self.assert_number(row["K [N*m]"], -torque * ring / sun if holds else None)
                    is_second = holds and speed > 0
                    self.assert_number(row["step"], 1 + ring / sun if is_second else None)

    def test_no_action_without_losses_is_told_as_one_with_them(self) -> None:
        """What is not known with losses is left out, as in the analysis; known are 0.98 of 3/2 T."""
        self.assertEqual([tuple(row.values()) for row in self.rows(CLUTCH_IN_ONE_SHAFT)],
                         [("50.0", "K", "75.0", "", "indeterminate"),
                          ("50.0", "B", "75.0", "73.5", "solved"),
                          ("20.0", "K", "30.0", "", "indeterminate"),
                          ("20.0", "B", "30.0", "29.4", "solved")])

    def test_a_combination_may_be_a_gear_for_other_values_alone(self) -> None:
        sweep = "sweep: {vary: {S1: {from: 19, to: 21, step: 1}}, report: [ratio, step, p.wz]}\n"
        rows = self.rows(TWO_SUNS + sweep)
        self.assertEqual([row["case"] for row in rows], 3 * ["direct", "creeper", "open", "both"])
        for row in rows:
            first = int(row["S1"])
            with self.subTest(row):
                self.assertEqual(row["status"], {
                    "direct": "solved", "open": "neutral", "both": "locked",
                    "creeper": "locked" if first == 20 else "solved"}[row["case"]])
                if row["case"] == "creeper":
                    moves = first != 20
                    self.assert_number(row["ratio"], 400 / (400 - 20 * first) if moves else None)
                    self.assert_number(row["p.wz [rad/s]"], 5 * first if moves else None)
                    self.assert_number(row["step"], None)
                if row["case"] == "direct":
                    self.assert_number(row["ratio"], 1)
                    self.assert_number(row["step"], 20 if first == 19 else None)

        named = sweep.replace("report", "cases: [creeper, K+B], report").replace("ratio, step,", "ratio,")
        self.assertEqual([(row["S1"], row["case"], row["status"]) for row in
                          self.rows(TWO_SUNS + named)],
                         [(first, label, status) for first, creeper in
                          (("19", "solved"), ("20", "locked"), ("21", "solved"))
                          for label, status in (("creeper", creeper), ("K+B", "locked"))])

    def assert_number(self, text: str, expected: float | None) -> None:
        if expected is None:
            self.assertEqual(text, "")
        else:
            self.assertAlmostEqual(float(text) / expected, 1, delta=1e-12)


class Library(InFolder):
    """Every mechanism, with its parameters moved one by one: rows are what analyses say."""

    def compare(self, row: dict[str, str], case: dict[str, object], context: str) -> int:
        kinematics, statics = case.get("kinematics") or {}, case.get("statics") or {}
        values = {"ratio": case.get("ratio"), "torque_ratio": case.get("torque_ratio"),
                  **kinematics.get("freedoms", {}), **statics.get("actions", {})}
        largest: dict[str, float] = {}
        for title in row:
            name, _, unit = title.partition(" [")
            if isinstance(values.get(name), float):
                largest[unit] = max(largest.get(unit, 0.0), abs(values[name]))
        compared = 0
        for title, cell in row.items():
            name, _, unit = title.partition(" [")
            if name not in values:
                continue
            if values[name] is None:
                self.assertEqual(cell, "", (context, title))
            else:
                self.assertAlmostEqual(float(cell), values[name], delta=1e-9 * largest[unit],
                                       msg=f"{context} {title}")
                compared += 1
        return compared

    def sweep_one(self, text: str, name: str, value: float, unit: str) -> int:
        typed = f"{value!r} {unit}".strip()
        text = re.split(r"^published:", text, flags=re.M)[0]
        file = self.write(f"{text}\nsweep: {{vary: {{{name}: [{typed}]}}}}\n")
        swept = kinestat("sweep", "--quiet", file)
        analysed = kinestat("analyze", "--format", "json", "--set", f"{name}={typed}", file)
        rows = list(csv.DictReader(swept.stdout.splitlines()))
        if analysed.returncode not in (0, 5) or not analysed.stdout:
            self.assertTrue(all(row["status"].startswith("E") for row in rows), swept.stdout)
            return 0
        cases = json.loads(analysed.stdout).get("cases", {})
        return sum(self.compare(row, cases[row["case"]], f"{name}={typed}") for row in rows)

    def test_rows_are_those_of_analyses(self) -> None:
        compared = 0
        for path in sanitized.sample(program(), sorted((ROOT / "mechanisms").rglob("*.yaml"))):
            report = json.loads(kinestat("analyze", "--format", "json", path).stdout or "{}")
            parameters = report.get("mechanism", {}).get("parameters", {})
            text = re.sub(r"^sweep:\n(?:[ ].*\n)*", "", path.read_text(), flags=re.M)
            for name, entry in list(parameters.items())[:4]:
                with self.subTest(file=path.name, parameter=name):
                    if "value" in entry and "cases" in report:
                        value = entry["value"] * 1.0625 + (entry["value"] == 0.0) * 0.125
                        compared += self.sweep_one(text, name, value, entry["unit"])
        self.assertGreater(compared, 200 if has_sanitizers() else 1000)


class Extremes(InFolder):
    """Size."""

    def test_a_train_of_a_thousand_members(self) -> None:
        """Fault 88: a chain of 1000 wheels, a sweep over one of them."""
        names = [f"g{i}" for i in range(1000)]
        lines = ["kinestat: 1", "space: planar", "parameters: {r: 1}", "ground: frame",
                 f"bodies: [{', '.join(names)}]", "couplings:"]
        for i, name in enumerate(names):
            lines.append(f"  c{i}: {{type: revolute, bodies: [frame, {name}], at: [{2 * i}, 0]}}")
        for i in range(999):
            at = "r" if i == 0 else str(2 * i + 1)
            lines.append(f"  m{i}: {{type: gear, bodies: [g{i}, g{i + 1}], at: [{at}, 0], "
                         "tangent: y, pressure_angle: 20 deg}")
        lines += ["actuators: {first: {coupling: c0}, last: {coupling: c999}}",
                  "cases: {turn: {motion: {first: 1 rad/s}, input: first, output: last}}",
                  "sweep: {vary: {r: {from: 0.5, to: 1.5, step: 0.25}}, report: [ratio]}"]
        begin = time.monotonic()
        rows = self.rows("\n".join(lines) + "\n")
        self.assertLess(time.monotonic() - begin, 60)
        for row in rows:
            radius = float(row["r"])
            # The first mesh has radii r and 2 - r; all others are even.
            self.assertAlmostEqual(float(row["ratio"]), -(2 - radius) / radius, delta=1e-9)

    def test_memory_does_not_depend_on_the_number_of_states(self) -> None:
        if has_sanitizers():
            self.skipTest("their memory is not the one of the program")

        def peak(last: int) -> int:
            file = self.write(TRAIN + f"""
sweep: {{vary: {{Ns: {{from: 17, to: {last}, step: 1}}}}, cases: [low], report: [ratio]}}
""")
            code = ("import resource,subprocess,sys;subprocess.run(sys.argv[1:],check=True,"
                    "stdout=subprocess.DEVNULL);"
                    "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
            done = subprocess.run(
                [sys.executable, "-c", code, str(program()), "sweep", "-q", str(file)],
                capture_output=True, encoding="utf-8", check=True, timeout=240,
            )
            return int(done.stdout)

        self.assertLess(peak(200017), 1.2 * peak(20017) + 2000)


if __name__ == "__main__":
    main(__doc__)
