"""Motions, sweeps, shift tables and pages give the same verdict on a position as analysis."""

from __future__ import annotations

import collections
import csv
import io
import math
import re
import tempfile
import unittest
from pathlib import Path

import motion_case
import program
from motion_case import MotionTest, run

WINCH = """
kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {t: 60 deg}
ground: g
bodies: [arm, w]
couplings:
  a: {type: revolute, bodies: [g, arm], at: [0, 0]}
  w: {type: revolute, bodies: [g, w], at: [-300, 0]}
cables:
  rope:
    over:
      - {pulley: w, radius: 10, wrap: counterclockwise}
      - {body: arm, at: [100*cos(t), 100*sin(t)]}
actuators: {M: {coupling: a}, W: {coupling: w}}
loads: {g: {body: arm, at: [100*cos(t), 100*sin(t)], force: [0, -10]}}
cases: {c: {motion: {M: 1 rad/s}, action: {M: 0}}}
"""

# The cam turns about a point beside its own centre; the follower is pulled off it.
FOLLOWER = """
kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {pull: 5 N}
ground: g
bodies: [cam, fol]
couplings:
  a: {type: revolute, bodies: [g, cam], at: [0, 0]}
  k: {type: cam, bodies: [cam, fol], at: [12*cos(20 deg), 30+12*sin(20 deg)], normal: y,
      radii: [30, flat]}
  d: {type: prismatic, bodies: [g, fol], at: [0, 60], axis: y}
actuators: {m: {coupling: a}}
loads: {s: {body: fol, at: [0, 60], force: [0, pull]}}
cases: {c: {motion: {m: 10 rad/s}}}
"""

# A table on two contacts, and between or beside them a pin in a slot that presses on it.
TABLE = """
kinestat: 1
space: planar
units: {length: mm}
parameters: {push: 4 N, x: 0 mm}
ground: floor
bodies: [table]
couplings:
  a: {type: point_contact, bodies: [floor, table], at: [-100, 0], normal: y}
  b: {type: point_contact, bodies: [floor, table], at: [100, 0], normal: y}
  c: {type: pin_in_slot, bodies: [floor, table], at: [x, 0], slot: x}
  d: {type: pin_in_slot, bodies: [floor, table], at: [0, 0], slot: y}
cases: {c: {action: {c.Ry: push}}}
"""

BELT = """
kinestat: 1
space: planar
parameters: {tension: 50 N}
ground: frame
bodies: [driver, driven]
couplings:
  A: {type: revolute, bodies: [frame, driver], at: [0, 0]}
  B: {type: revolute, bodies: [frame, driven], at: [1, 0]}
cables:
  belt:
    closed: true
    over:
      - {pulley: driver, radius: 0.1, wrap: clockwise, friction: 0.2}
      - {pulley: driven, radius: 0.1, wrap: clockwise, friction: 0.5}
actuators: {in: {coupling: A}, out: {coupling: B}}
cases: {c: {motion: {in: -100 rad/s}, action: {in: -10 N*m, belt_1.F: tension}}}
"""

# The follower stands far beside its guide, which is short and rough.
JAMMED = """
kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {mu: 0.9}
ground: g
bodies: [s, m]
couplings:
  a: {type: revolute, bodies: [g, s], at: [0, 0]}
  d: {type: prismatic, bodies: [g, m], at: [40, 0], axis: y, friction: {mu: mu, length: 10}}
  k: {type: cam, bodies: [s, m], at: [30, 20], normal: y, radii: [30, flat]}
actuators: {A: {coupling: a}}
loads: {w: {body: m, at: [40, 0], force: [0, -10]}}
cases: {c: {motion: {A: 1 rad/s}}}
"""

FOUR_BAR = """
kinestat: 1
space: planar
%s
parameters: {load: 1 N*m, speed: 2 rad/s}
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [1, 3]}
  c: {type: revolute, bodies: [coupler, rocker], at: [6, 5]}
  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}
actuators: {drive: {coupling: a}, work: {coupling: d}}
cases: {c: {motion: {%s}, action: {%s}, input: drive, output: work}}
"""

# The thrust of the shaft, the couple across its axis and that of its slide have no radius or length
# on which they rub.
SLIDING_SHAFT = """
kinestat: 1
parameters: {mu: 0.1}
ground: housing
bodies: [shaft, nut]
couplings:
  a: {type: revolute, bodies: [housing, shaft], at: [0, 0, 0], axis: z,
      friction: {mu: mu, radius: 10 mm}}
  b: {type: prismatic, bodies: [shaft, nut], at: [0, 0, 0.1], axis: z, friction: mu}
actuators: {motor: {coupling: a}, press: {coupling: b}}
loads:
  thrust: {body: shaft, at: [0, 0, 0.1], force: [0, 0, -500], couple: [0, 20, 0]}
  brake: {body: nut, couple: [0, 0, -7]}
cases: {c: {motion: {motor: 100, press: 1}}}
"""

SCREW = """
kinestat: 1
parameters: {mu: 0.15}
ground: base
bodies: [screw, nut]
couplings:
  b: {type: revolute, bodies: [base, screw], at: [0, 0, 0], axis: z, passive: [Rx, Ry, Rz]}
  t: {type: helical, bodies: [screw, nut], at: [0, 0, 1], axis: z, lead: 5 mm,
      friction: {mu: mu, radius: 1 cm}}
  g: {type: prismatic, bodies: [base, nut], at: [0, 0, 1], axis: z, passive: [Tz]}
actuators: {crank: {coupling: b}, lift: {coupling: g}}
cases: {c: {motion: {lift: -1 m/s}, action: {lift: -1 kN}, input: lift, output: crank}}
"""

# A nut that bears no force along the screw.
LOOSE_NUT = """
kinestat: 1
units: {length: mm, angle: deg}
parameters: {work: -800 N}
ground: frame
bodies: [screw, slide]
couplings:
  thread: {type: helical, bodies: [frame, screw], at: [0, 0, 0], axis: x, lead: 1.25}
  nut: {type: helical, bodies: [screw, slide], at: [30, 0, 0], axis: x, lead: 1.0, passive: [Ra]}
  bar: {type: prismatic, bodies: [frame, slide], at: [30, 5, 0], axis: x, passive: [Tx]}
actuators: {motor: {coupling: thread}, tool: {coupling: bar}}
cases: {c: {motion: {motor: 60 rpm}, action: {tool: work}, input: motor, output: tool}}
"""


class Trial:
    """A file, its drive, the parameter that a sweep gives its own value, and what all say."""

    def __init__(self, text: str, drive: str, parameter: str, status: str, codes: list[str],
                 reports: str = "action") -> None:
        self.text = text
        self.drive = drive
        self.parameter = parameter
        self.status = status
        self.codes = collections.Counter(codes)
        self.reports = reports

    def drives(self) -> str:
        """A thousandth of a turn or of a length, each."""
        small = {"lift": "1e-3", "press": "1e-3"}
        names = ["motor", "press"] if "press:" in self.text else [self.drive]
        return ", ".join(f"{{drive: {one}, to: {small.get(one, '1e-3 rad')}}}" for one in names)

    def value(self) -> str:
        found = re.search(r"parameters: \{.*?\b%s: ([^,}]*)" % self.parameter, self.text)
        assert found
        return found.group(1)


TRIALS = {
    "cable in order": Trial(WINCH, "M", "t", "solved", []),
    "cable that pushes": Trial(WINCH.replace("60 deg", "120 deg"), "M", "t", "cable_slack",
                              ["W0606"]),
    "contact that pulls": Trial(FOLLOWER, "m", "pull", "contact_pulls", ["W0605"]),
    "contact in order": Trial(FOLLOWER.replace("5 N", "-5 N"), "m", "pull", "solved", []),
    "belt that would slip": Trial(BELT, "in", "tension", "cable_slips", ["W0607"]),
    "belt that sticks": Trial(BELT.replace("50 N", "500 N"), "in", "tension", "solved", []),
    "belt without tension": Trial(BELT.replace("50 N", "-50 N"), "in", "tension", "cable_slack",
                                  ["W0606"]),
    "friction that locks": Trial(JAMMED, "A", "mu", "locked", ["W0603"]),
    "actions left open": Trial(FOUR_BAR % ("order: {statics: spatial}", "drive: speed",
                                           "work: load"),
                               "drive", "speed", "indeterminate", ["W0601"]),
    "speeds that contradict": Trial(FOUR_BAR % ("", "drive: speed, work: 1 rad/s", "work: load"),
                                    "drive", "speed", "dependent", ["E0502"]),
    "actions that contradict": Trial(FOUR_BAR % ("", "drive: speed", "work: load, drive: 7 N*m"),
                                     "drive", "speed", "inconsistent", ["E0602"]),
    "reactions that do not rub": Trial(SLIDING_SHAFT, "motor", "mu", "solved",
                                       ["W0604"] * 3),
    "screw that locks itself": Trial(SCREW, "lift", "mu", "self_locking", ["W0602"], "power"),
    "load that nothing holds": Trial(LOOSE_NUT, "motor", "work", "inconsistent", ["E0602"]),
}


def codes_of(done: object) -> collections.Counter:
    return collections.Counter(
        re.findall(r"^\S+:\d+:\d+: (?:error|warning)\[(\w+)\]", done.stderr, re.M))


class JudgementTest(MotionTest):
    def analysed(self, trial: Trial) -> object:
        return program.call("analyze", "-", text=trial.text)

    def test_analysis_says_what_the_mechanics_ask_for(self) -> None:
        for name, trial in TRIALS.items():
            with self.subTest(name):
                self.assertEqual(codes_of(self.analysed(trial)), trial.codes)

    def test_a_motion_says_of_its_first_position_what_analysis_says(self) -> None:
        for name, trial in TRIALS.items():
            with self.subTest(name):
                motion = f"motion: {{drives: [{trial.drives()}], steps: 1, case: c, " \
                         f"report: [{trial.reports}]}}\n"
                done = program.call("motion", "-", text=trial.text + motion)
                analysed = self.analysed(trial)
                self.assertEqual(codes_of(done), trial.codes, done.stderr)
                self.assertEqual(done.returncode, analysed.returncode)
                self.assertEqual(motion_case.Motion(program.report(done))["status"],
                                 [trial.status] * 2)

    def test_a_sweep_of_one_state_has_the_status_of_the_motion(self) -> None:
        for name, trial in TRIALS.items():
            with self.subTest(name):
                quantity = "efficiency" if trial.reports == "power" else trial.drive
                sweep = f"sweep: {{vary: {{{trial.parameter}: {{values: [{trial.value()}]}}}}, " \
                        f"report: [{quantity}]}}\n"
                self.assertEqual(self.statuses(trial.text + sweep), [trial.status])

    def test_a_shift_table_says_of_its_gears_what_analysis_says(self) -> None:
        """A second bearing of the shaft shares its load with the first as equilibrium cannot know."""
        text = motion_case.in_library("transmissions/simpson_a727.yaml").read_text(encoding="utf-8")
        text = text.replace("  O:  {type", "  I2: {type: revolute, bodies: [housing, shaft], "
                                           "at: [0, 0]}\n  O:  {type", 1)
        analysed = program.call("analyze", "-", text=text)
        done = program.call("shift", "-", text=text)
        self.assertEqual(codes_of(analysed), {"W0601": 4})
        self.assertEqual(done.stderr, analysed.stderr)

    def test_a_page_ends_as_analysis_does(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            page = str(Path(folder) / "page.html")
            for name, trial in TRIALS.items():
                with self.subTest(name):
                    path = Path(folder) / "file.yaml"
                    path.write_text(trial.text, encoding="utf-8")
                    analysed = program.call("analyze", str(path))
                    done = program.plain("report", "-o", page, "--force", str(path))
                    self.assertEqual(codes_of(done), codes_of(analysed))
                    self.assertEqual(done.returncode, analysed.returncode)

    def test_a_rope_pushes_beyond_the_vertical(self) -> None:
        """The moment of the weight about the pivot of the arm is zero there and turns round. The
        steps of 10 degrees are divided into four for the extremes, which tells where more closely."""
        text = WINCH + "motion: {drive: M, to: 60 deg, steps: 6, case: c, report: [rope_1.F]}\n"
        done = program.call("motion", "-", text=text)
        self.assertEqual(done.returncode, 0)
        self.assertIn("(M from 32.5 to 60 deg, 3 of 7 positions, the worst at 60)", done.stderr)
        motion = motion_case.Motion(program.report(done))
        self.assertEqual(motion["status"], ["solved"] * 4 + ["cable_slack"] * 3)
        for drive, force in zip(motion["M/drive"], motion["rope_1.F/action"]):
            arm = complex(0.1 * math.cos(math.radians(60 + drive)),
                          0.1 * math.sin(math.radians(60 + drive)))
            self.close(force, 10 * arm.real / self.lever(arm), 1e-11, f"at {drive}")

    @staticmethod
    def lever(arm: complex) -> float:
        """Of the cable about the pivot: from the point on the arm to where it touches the winch."""
        winch = -0.3
        away = winch - arm
        half = math.asin(0.01 / abs(away))
        along = away / abs(away)
        best = [along * complex(math.cos(half), s * math.sin(half)) for s in (1, -1)]
        # Wound counterclockwise, the cable comes to the pulley and has its centre on the left on the way to the arm.
        direction = next(u for u in best if (u.conjugate() * away).imag < 0)
        return (arm.conjugate() * direction).imag

    def test_states_of_a_tape_know_which_contact_pulls(self) -> None:
        """The pin at x presses with 4 N up or down: the contacts bear (1 -+ x / 100 mm) / 2 of it."""
        text = TABLE + "sweep: {vary: {x: {from: -300 mm, to: 300 mm, step: 1 mm}, " \
                       "push: {values: [-4 N, 4 N]}}, report: [a.Ry, b.Ry]}\n"
        rows = self.rows(text)
        self.assertEqual(len(rows), 1202)
        for row in rows:
            x, push = float(row["x [mm]"]) / 100, float(row["push [N]"])
            a, b = -push * (1 - x) / 2, -push * (1 + x) / 2
            self.close(float(row["a.Ry [N]"]), a, 1e-12, str(row))
            self.close(float(row["b.Ry [N]"]), b, 1e-12, str(row))
            self.assertEqual(row["status"], "contact_pulls" if min(a, b) < 0 else "solved")

    def rows(self, text: str) -> list[dict]:
        done = program.plain("sweep", "-", text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return list(csv.DictReader(io.StringIO(done.stdout)))

    def statuses(self, text: str) -> list[str]:
        return [row["status"] for row in self.rows(text)]


if __name__ == "__main__":
    motion_case.main()
