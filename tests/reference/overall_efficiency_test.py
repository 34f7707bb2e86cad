#!/usr/bin/env python3
"""Checks the efficiency of a whole motion, by mean powers, against closed forms.

Usage: overall_efficiency_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math

import motion_case
import program
from motion_case import Motion, MotionTest
from swept_case import refused, swept

MU = 0.2

# The pin runs along x as cos(a), and along its slot, in which it slides with friction, as sin(a).
YOKE = """\
kinestat: 1
space: planar
units: {angle: deg}
ground: frame
bodies: [crank, yoke]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  s: {type: pin_in_slot, bodies: [crank, yoke], at: [0.8, 0.6], slot: y, friction: mu}
  d: {type: prismatic, bodies: [frame, yoke], at: [2, 0], axis: x}
parameters: {a0: atan(0.75), mu: 0.2}
actuators: {crank: {coupling: a}, F: {coupling: d}}
cases: {one: {motion: {crank: 1 rad/s}, action: {F: 10 N}, input: crank, output: F}}
motion: {drive: crank, from: FROM deg - a0, to: TO deg - a0, steps: STEPS, case: one}
"""

SCREW = """\
kinestat: 1
space: spatial
units: {length: mm, angle: deg}
ground: frame
bodies: [spindle]
couplings:
  s: {type: helical, bodies: [frame, spindle], at: [0, 0, 0], axis: z, lead: 6,
      friction: {mu: 0.1, radius: 15}}
actuators: {motor: {coupling: s}}
loads: {press: {body: spindle, at: [0, 0, 0], force: [0, 0, LOAD]}}
cases: {pressing: {motion: {motor: 10 rad/s}, action: {}, input: motor, output: press}}
motion: {drive: motor, to: 720, steps: 24, case: pressing}
"""

CRANK = """\
kinestat: 1
space: planar
units: {length: mm, angle: deg}
ground: frame
bodies: [crank, rod, slider]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, rod], at: [40, 0]}
  c: {type: revolute, bodies: [rod, slider], at: [165, 0]}
  d: {type: prismatic, bodies: [frame, slider], axis: x}
actuators: {motor: {coupling: a}, press: {coupling: d}}
cases: {run: {motion: {motor: 2 rad/s}, action: {press: 500 N}, input: motor, output: press}}
motion: {drive: motor, to: 180, steps: 72, case: run}
"""


def yoke(begin: float, end: float, steps: int = 96) -> str:
    return YOKE.replace("FROM", f"{begin}").replace("TO", f"{end}").replace("STEPS", str(steps))


def of_yoke(begin: float, end: float, mu: float = MU) -> float:
    """The load does cos(begin) - cos(end), friction takes mu |cos(a)| on both sides of 90 deg."""
    b, e = math.radians(begin), math.radians(end)
    work = math.cos(b) - math.cos(e)
    return work / (work + mu * (2.0 - math.sin(b) - math.sin(e)))


def found(text: str, *options: str) -> tuple[float | None, str]:
    done = program.call("motion", *options, "-", text=text)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    motion = Motion(program.report(done)).report
    return motion["overall_efficiency"], motion["no_overall_efficiency"]


class OverallEfficiency(MotionTest):
    def check_value(self, text: str, expected: float, tolerance: float) -> None:
        value, why = found(text)
        self.assertEqual(why, "")
        self.close(value, expected, tolerance, "overall efficiency")

    def test_is_that_of_the_work_not_the_mean_of_efficiencies(self) -> None:
        for steps in (96, 384):
            self.check_value(yoke(10.0, 170.0, steps), of_yoke(10.0, 170.0), 0.2 / steps ** 2)
        text = yoke(10.0, 170.0).replace("case: one", "case: one, report: [power, efficiency]")
        mean = Motion(program.run("motion", "-", text=text)).report["figures"]["efficiency"]["mean"]
        self.assertGreater(abs(mean - of_yoke(10.0, 170.0)), 0.01)

    def test_does_not_hang_on_which_end_runs_steadily(self) -> None:
        """At a steady speed of the load the crank stays longer where it is fast per load."""
        for speed in ("motion: {F: -1 m/s}", "motion: {F: -7 m/s}", "motion: {crank: 5 rad/s}"):
            text = yoke(10.0, 170.0, 384).replace("motion: {crank: 1 rad/s}", speed)
            self.check_value(text, of_yoke(10.0, 170.0), 2e-6)

    def test_is_in_time_where_the_motion_is(self) -> None:
        text = yoke(10.0, 170.0).replace("motion: {crank: 1 rad/s}, ", "").replace(
            "case: one}", "case: one, time: 2 s, law: polynomial_345}")
        self.check_value(text, of_yoke(10.0, 170.0), 1e-4)

    def test_of_a_screw_press_is_that_of_each_position(self) -> None:
        """The tangent of the lead angle over that of this and the friction angle. Down again the
        thread holds the load: the spindle must be turned, and the load supplies power, too."""
        lead = math.atan(6.0 / (2.0 * math.pi * 15.0))
        self.check_value(SCREW.replace("LOAD", "-500 N"),
                         math.tan(lead) / math.tan(lead + math.atan(0.1)), 1e-12)
        value, why = found(SCREW.replace("LOAD", "500 N"))
        self.assertIsNone(value)
        self.assertEqual(why, "friction absorbs more power than the inputs supply")

    def test_of_a_conservative_stroke_is_one(self) -> None:
        self.check_value(CRANK, 1.0, 1e-12)

    def test_of_an_engine_without_friction_is_one(self) -> None:
        """Its gas force is a table of straight lines, and its masses come back to their speed."""
        text = motion_case.in_library("planar/four_stroke_engine.yaml").read_text(encoding="utf-8")
        for steps in ("48", "72", "100"):
            value, why = found(text, "--steps", steps)
            self.assertEqual(why, "")
            self.close(value, 1.0, 1e-9, steps)

    def test_has_a_reason_where_a_whole_cycle_takes_nothing(self) -> None:
        for steps in (24, 36, 71, 300):
            value, why = found(CRANK.replace("to: 180", "to: 360"), "--steps", str(steps))
            self.assertIsNone(value)
            self.assertEqual(why, "the inputs supply no power")

    def test_has_a_reason_where_power_flows_back(self) -> None:
        value, why = found(yoke(190.0, 350.0))
        self.assertIsNone(value)
        self.assertIn("the inputs absorb power: the outputs drive", why)

    def test_of_a_turn_does_not_see_a_weight_that_comes_back(self) -> None:
        """A drag c v on the slider takes c w times the integral of (dx/da)^2, a bearing 2 pi tau,
        and the weight of the slider, which stands upright, nothing."""
        def slope(a: float) -> float:
            return 0.04 * math.sin(a) * (1.0 + 0.04 * math.cos(a) / math.sqrt(
                0.125 ** 2 - (0.04 * math.sin(a)) ** 2))

        drag = 2.0 * 100.0 * sum(slope(2.0 * math.pi * k / 1000) ** 2
                                 for k in range(1000)) * 2.0 * math.pi / 1000
        expected = drag / (drag + 2.0 * math.pi * 0.01)
        text = (CRANK.replace("to: 180", "to: 360")
                .replace("at: [0, 0]}", "at: [0, 0], friction: {tau: 0.01 N*m}}")
                .replace("{press: 500 N}", "{press: drag}")
                .replace("cases:", "curves: {drag: {over: press.speed, "
                         "points: [[-1 m/s, 100 N], [1 m/s, -100 N]]}}\ncases:"))
        for body in ("slider: {}", "slider: {mass: 3, centre_of_mass: [165, 0]}"):
            upright = text.replace("[crank, rod, slider]\n",
                                   f"{{crank: {{}}, rod: {{}}, {body}}}\ngravity: [-9.81, 0]\n")
            for steps in (36, 72):
                value, why = found(upright, "--steps", str(steps))
                self.assertEqual(why, "", body)
                self.close(value, expected, 1e-6, body)

    def test_is_told_in_every_form(self) -> None:
        text = yoke(10.0, 170.0)
        value, _ = found(text)
        table = program.plain("motion", "-", text=text).stdout
        self.assertTrue(f"  overall efficiency {value:.6g}, of mean powers\n" in table)
        lines = program.plain("motion", "--format", "csv", "-", text=text).stdout.splitlines()
        line = [one for one in lines if ",overall_efficiency," in one]
        self.assertEqual([one.split(",")[4:6] for one in line], [["overall_efficiency", str(value)]])

    def test_is_swept(self) -> None:
        rows, _ = swept(yoke(10.0, 170.0), "{vary: {mu: [0.1, 0.2, 0.3]}, cases: [one], "
                        "report: [overall_efficiency, crank.peak]}")
        for row in rows:
            self.close(row["overall_efficiency"], of_yoke(10.0, 170.0, row["mu"]), 1e-4, "swept")
            self.assertEqual(row["status"], "solved")
        sweep = "{vary: {n: [1]}, cases: [run], report: [overall_efficiency]}"
        crank = CRANK.replace("ground:", "parameters: {n: 1}\nground:")
        rows, _ = swept(crank.replace("to: 180", "to: 360"), sweep)
        self.assertEqual([(row["overall_efficiency"], row["status"]) for row in rows],
                         [(None, "no_efficiency")])
        said = refused(crank.replace(", output: press", ""), sweep)
        self.assertIn("does not name both ends", said)

    def test_of_the_energies_is_the_same(self) -> None:
        text = yoke(10.0, 170.0).replace("motion: {crank: 1 rad/s}",
                                         "motion: {crank: 0}, acceleration: {}").replace(
            "case: one}", "case: one, time: 2 s, law: polynomial_345}").replace(
            "bodies: [crank, yoke]\n", "bodies: {crank: {}, yoke: {mass: 3, centre_of_mass: [2, 0]}}\n")
        text += "dynamics: {actuators: [crank]}\n"
        motion = Motion(program.run("motion", "-", text=text)).report
        self.assertEqual(motion["overall_efficiency"], motion["dynamics"]["energy"]["efficiency"])
        self.assertTrue(0.0 < motion["overall_efficiency"] < 1.0)

    def test_out_and_back_in_time(self) -> None:
        """What a constant force takes on the way out it gives on the way back: the motor supplies
        nothing, or with a drag what that absorbs."""
        for law in ("cycloidal", "polynomial_345"):
            for end in (90, 180):
                for steps in (10, 24, 25, 48):
                    for drag in (0.0, 0.1):
                        motion = Motion(program.run("motion", "-", text=f"""\
kinestat: 1
space: planar
units: {{length: mm}}
ground: f
bodies: [crank, rod, piston]
couplings:
  A: {{type: revolute, bodies: [f, crank], at: [0, 0], friction: {{tau: {drag} N*m}}}}
  B: {{type: revolute, bodies: [crank, rod], at: [30, 0]}}
  C: {{type: revolute, bodies: [rod, piston], at: [130, 0]}}
  D: {{type: prismatic, bodies: [f, piston], at: [130, 0], axis: x}}
actuators: {{m: {{coupling: A}}, p: {{coupling: D}}}}
cases: {{c: {{motion: {{}}, action: {{p: 100}}, input: m, output: p}}}}
motion:
  drive: m
  profile: [{{to: {end} deg, time: 1 s, law: {law}}}, {{to: 0 deg, time: 0.7 s, law: {law}}}]
  case: c
  steps: {steps}
""")).report
                        where = f"{law} {end} {steps} {drag}"
                        if drag > 0.0:
                            self.assertEqual(motion["overall_efficiency"], 0, where)
                        else:
                            self.assertIsNone(motion["overall_efficiency"], where)
                            self.assertIn("supply no power", motion["no_overall_efficiency"], where)


if __name__ == "__main__":
    motion_case.main()
