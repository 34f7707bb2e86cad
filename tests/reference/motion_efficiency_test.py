#!/usr/bin/env python3
"""Checks the efficiency along a motion against closed forms, and against the case as it is drawn.

Usage: motion_efficiency_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math

import motion_case
import program
from motion_case import Motion, MotionTest, in_library
from swept_case import swept

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
  s: {type: pin_in_slot, bodies: [crank, yoke], at: [0.8, 0.6], slot: y, friction: 0.2}
  d: {type: prismatic, bodies: [frame, yoke], at: [2, 0], axis: x}
parameters: {a0: atan(0.75)}
actuators: {crank: {coupling: a}, F: {coupling: d}}
cases: {one: {motion: {crank: 1 rad/s}, action: {F: 10 N}, input: crank, output: F}}
motion: {drive: crank, from: FROM - a0, to: TO - a0, steps: STEPS, case: one, report: [efficiency]}
"""

DRAWN = math.degrees(math.atan(0.75))


def yoke(begin: float, end: float, steps: int) -> str:
    return (YOKE.replace("FROM", f"{begin} deg").replace("TO", f"{end} deg")
            .replace("STEPS", str(steps)))


def efficiency_of_yoke(angle: float) -> float:
    """The power of the load, sin(a), over that and what friction takes, mu |cos(a)|."""
    a = math.radians(angle)
    return math.sin(a) / (math.sin(a) + MU * abs(math.cos(a)))


def motion_of(text: str) -> tuple[Motion, str]:
    done = program.call("motion", "-", text=text)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return Motion(program.report(done)), done.stderr


class EfficiencyOfAYoke(MotionTest):
    def test_has_the_closed_form_in_each_position(self) -> None:
        motion, said = motion_of(yoke(5.0, 173.0, 24))
        self.assertNotIn("W0516", said)
        self.check(motion, "efficiency", lambda drive: efficiency_of_yoke(drive + DRAWN), 1e-12)
        self.assertEqual(set(motion["status"]), {"solved"})

    def test_is_greatest_where_nothing_slides_and_least_at_the_end(self) -> None:
        for steps in (5, 7, 24, 33):
            motion, _ = motion_of(yoke(5.0, 173.0, steps))
            figures = motion.report["figures"]["efficiency"]
            self.close(figures["least"], efficiency_of_yoke(5.0), 1e-12, f"{steps} steps")
            self.close(figures["greatest"], 1.0, 1e-6, f"{steps} steps")
            self.close(figures["greatest_at"], 90.0 - DRAWN, 1e-3, f"{steps} steps")

    def test_has_no_value_where_the_load_drives(self) -> None:
        """The crank goes down behind 180 deg: the load supplies power, at first less than friction
        takes, tan(a) < mu, so that alone it would not move."""
        for steps in (26, 27, 51):
            motion, said = motion_of(yoke(90.5, 220.0, steps))
            for drive, value, status in zip(motion["crank/drive"], motion["efficiency"],
                                            motion["status"]):
                angle = drive + DRAWN
                if angle < 180.0:
                    self.close(value, efficiency_of_yoke(angle), 1e-11, f"at {angle}")
                    self.assertEqual(status, "solved")
                else:
                    self.assertIsNone(value, f"at {angle}")
                    locks = math.tan(math.radians(angle)) < MU
                    self.assertEqual(status, "self_locking" if locks else "no_efficiency",
                                     f"at {angle}")
            figures = motion.report["figures"]["efficiency"]
            self.close(figures["least"], 0.0, 1e-8, f"{steps} steps: it falls to zero at 180 deg")
            self.close(figures["least_at"], 180.0 - DRAWN, 1e-5, f"{steps} steps")
            self.assertIsNone(figures["mean"])
            self.assertIn("warning[W0602]: case 'one' is self-locking", said)
            self.assertIn("the inputs absorb power: the outputs drive (crank from", said)

    def test_has_a_mean_where_no_row_lacks_it_but_at_a_dead_point(self) -> None:
        """A row that has none is not bridged by its neighbours, but where friction turns round."""
        motion, _ = motion_of(yoke(141.0, 181.0, 4))
        self.assertEqual([value is None for value in motion["efficiency"]], [False] * 4 + [True])
        self.assertIsNone(motion.report["figures"]["efficiency"]["mean"])

        motion, _ = motion_of(yoke(10.0, 170.0, 160))
        self.assertEqual(motion["status"][80], "friction_reversal")
        middle = sum(efficiency_of_yoke(10.0 + (k + 0.5) / 100.0) for k in range(16000)) / 16000
        self.close(motion.report["figures"]["efficiency"]["mean"], middle, 1e-4, "mean")

    def test_is_of_loads_too(self) -> None:
        loaded = (yoke(5.0, 173.0, 12).replace("action: {F: 10 N}", "action: {F: 0 N}")
                  .replace("output: F", "output: pull, loads: {pull: {body: yoke, "
                           "at: [2, 0], force: [10, 0]}}"))
        motion, _ = motion_of(loaded)
        self.check(motion, "efficiency", lambda drive: efficiency_of_yoke(drive + DRAWN), 1e-12)

    def test_is_refused_without_both_ends(self) -> None:
        done = program.call("motion", "-", text=yoke(5.0, 173.0, 4).replace(", output: F", ""))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("E0303", done.stderr)
        self.assertIn("add input: NAME and output: NAME", done.stderr)

    def test_says_where_nothing_loses_power(self) -> None:
        motion, said = motion_of(yoke(5.0, 173.0, 4).replace(", friction: 0.2", ""))
        self.assertEqual(set(motion["efficiency"]), {None})
        self.assertEqual(set(motion["status"]), {"solved"})
        self.assertIn("W0516", said)
        self.assertIn("nothing loses power", said)

    def test_is_swept(self) -> None:
        rows, _ = swept(yoke(5.0, 173.0, 24).replace("friction: 0.2", "friction: mu")
                        .replace("parameters: {", "parameters: {mu: 0.2, "),
                        "{vary: {mu: [0.1, 0.2, 0.3]}, cases: [one], "
                        "report: [efficiency.least]}")
        for row in rows:
            a = math.radians(5.0)
            self.close(row["efficiency.least"],
                       math.sin(a) / (math.sin(a) + row["mu"] * math.cos(a)), 1e-12, "swept")


class EfficiencyAsDrawn(MotionTest):
    """In the first row, where the motion begins as drawn."""

    def check_first_row(self, text: str, case: str, key: str) -> None:
        efficiency = program.run("analyze", "-", text=text)["cases"][case]["power"]["efficiency"]
        motion, _ = motion_of(text)
        self.assertIsNotNone(efficiency[key])
        self.close(motion["efficiency"][0], efficiency[key], 1e-12, key)

    def test_is_that_of_the_case(self) -> None:
        self.check_first_row(yoke(DRAWN, 100.0, 3), "one", "friction")

    def test_is_by_the_model_of_losses_that_the_file_prefers(self) -> None:
        train = in_library("transmissions/ravigneaux_with_losses.yaml").read_text(encoding="utf-8")
        for model in ("carrier", "absolute"):
            text = train.replace("losses: {", f"losses: {{model: {model}, ")
            text += ("\nmotion: {drives: [{drive: C1, to: 30 deg}, {drive: B2, to: 0}], steps: 2, "
                     "case: M1, report: [efficiency]}\n")
            self.check_first_row(text, "M1", model)


if __name__ == "__main__":
    motion_case.main()
