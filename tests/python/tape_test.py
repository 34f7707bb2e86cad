"""Tapes: a case recorded and played, with NumPy and without."""

from __future__ import annotations

import gc
import json
import math
import subprocess
import unittest
from array import array
from typing import Any
from unittest import mock

import kinestat
from kinestat import _numbers

from python_case import Case, FOUR_BAR, LEVER, PROGRAM, ROOT, first_gear, four_bar_ratio, numpy, ravigneaux


class Tapes(Case):
    """With NumPy, if there; WithoutNumpy runs the same without it."""

    def table(self, rows: Any) -> list[list[float]]:
        if _numbers.numpy is not None:
            self.assertEqual((rows.dtype, rows.ndim), (numpy.float64, 2))
        else:
            self.assertIsInstance(rows, list)
        return [list(row) for row in rows]

    def words(self, tape: kinestat.Tape) -> list[str]:
        self.assertIsInstance(tape.statuses, list if _numbers.numpy is None else numpy.ndarray)
        return list(tape.statuses)

    def test_closed_form_of_a_four_bar(self) -> None:
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], ["d.wz", "ratio", "Tin"])
        self.assertEqual(tape.inputs, ("height", "speed"))
        self.assertEqual(tape.outputs, ("d.wz", "ratio", "Tin"))
        self.assertEqual(tape.input_units, ("m", "rad/s"))
        self.assertEqual(tape.output_units, ("rad/s", "", "N*m"))
        self.assertEqual(tape.messages, [])
        states = [[3 + k / 8, 1.0 + k] for k in range(33)]
        rows = self.table(tape.play(states))
        self.assertEqual(self.words(tape), ["solved"] * 33)
        self.assertTrue(tape.is_played)
        for (height, speed), (rate, ratio, torque) in zip(states, rows):
            self.assert_near(ratio, four_bar_ratio(height), 1e-11)
            self.assert_near(rate, speed / four_bar_ratio(height), 1e-11)
            self.assert_near(torque, -1 / four_bar_ratio(height), 1e-11)  # no power is lost

    def test_a_state_without_a_value(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", ["ratio", "d.wz"])
        rows = self.table(tape.play([5.0, 18.0, 6.0]))  # at 18 m the rocker rests
        self.assertEqual(self.words(tape), ["solved", "no_ratio", "solved"])
        self.assert_near(rows[0][0], 27 / 13)
        self.assertTrue(math.isnan(rows[1][0]))
        self.assertLess(abs(rows[1][1]), 1e-12)
        self.assert_near(rows[2][0], 33 / 12)

    def test_teeth_that_follow_from_others(self) -> None:
        tape = ravigneaux().record(["N1", "N2", "N5"], ["ratio", "out"], case="M1")
        self.assertEqual(tape.input_units, ("", "", ""))
        states = [[n1, n2, n5] for n1 in (16, 19, 24) for n2 in (35, 41, 50) for n5 in (12, 15)]
        for state, row in zip(states, self.table(tape.play(states))):
            self.assert_near(row[0], first_gear(*state), 1e-11)
            self.assert_near(abs(row[1]), 100 * abs(first_gear(*state)), 1e-11)

    def test_outputs_that_a_sweep_would_choose(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height")
        self.assertLessEqual({"ratio", "torque_ratio", "a.wz", "d.wz", "Tin"}, set(tape.outputs))
        self.assertEqual(len(tape.outputs), len(tape.output_units))
        self.assert_near(tape(height=5)["ratio"], 27 / 13)

    def test_forms_of_inputs(self) -> None:
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], "d.wz")
        expected = [speed / four_bar_ratio(height) for height, speed in ((4, 2), (5, 2), (6, 2))]
        forms: list[Any] = [
            [[4, 2], [5, 2], [6, 2]],
            ((4.0, 2.0), (5.0, 2.0), (6.0, 2.0)),
            {"height": [4, 5, 6], "speed": [2, 2, 2]},
            {"speed": 2, "height": (4, 5, 6)},
            {"speed": [2], "height": array("d", [4, 5, 6])},
            array("d", [4, 2, 5, 2, 6, 2]),
        ]
        if _numbers.numpy is not None:
            rows = numpy.array([[4, 2], [5, 2], [6, 2]])
            forms += [rows, rows.astype(numpy.float32), rows.astype(float, order="F"),
                      numpy.array([[4, 9, 2], [5, 9, 2], [6, 9, 2]], dtype=float)[:, ::2],
                      rows.astype(">f8"), {"height": rows[:, 0], "speed": numpy.float64(2)}]
        for form in forms:
            for (value,), right in zip(self.table(tape.play(form)), expected):
                self.assert_near(value, right, 1e-11)
            self.assertEqual(len(tape.statuses), 3)

    def test_one_state(self) -> None:
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], ["ratio", "d.wz"])
        answer = tape(speed=3, height=5)
        self.assertEqual(list(answer), ["ratio", "d.wz"])
        self.assertIs(type(answer["ratio"]), float)
        self.assert_near(answer["ratio"], 27 / 13)
        self.assert_near(answer["d.wz"], 3 * 13 / 27)
        self.assertEqual(self.words(tape), ["solved"])

    def test_no_states(self) -> None:
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], ["ratio", "d.wz"])
        for form in ([], {"height": [], "speed": []}, {"height": [], "speed": 1}, array("d")):
            self.assertEqual(self.table(tape.play(form)), [])
            self.assertEqual(self.words(tape), [])

    def test_more_states_than_a_call_takes(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", ["ratio"])
        heights = [3 + k / 2500 for k in range(10001)]
        rows = self.table(tape.play(heights))
        self.assertEqual(len(rows), 10001)
        self.assertEqual(set(self.words(tape)), {"solved"})
        worst = max(abs(row[0] / four_bar_ratio(h) - 1) for row, h in zip(rows, heights))
        self.assertLess(worst, 1e-11)

    def test_wrong_shapes(self) -> None:
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], "ratio")
        wrong: list[Any] = [
            [[4.0]], [[4.0, 1.0, 1.0]], [4.0, 1.0], array("d", [4, 1, 5]), [[4.0, 1.0], [5.0]],
            {"height": [4, 5]}, {"height": 4, "speed": 1, "N1": 2},
            {"height": [4, 5], "speed": [1, 1, 1]}, {},
        ]
        for form in wrong:
            with self.assertRaises(ValueError, msg=str(form)):
                tape.play(form)
        states: list[dict[str, Any]] = [
            {"height": 4}, {"height": 4, "speed": 1, "depth": 2}, {"height": [4, 5], "speed": 1},
        ]
        for state in states:
            with self.assertRaises(ValueError):
                tape(**state)
        with self.assertRaises((TypeError, ValueError)):
            tape.play([["4 m", 1.0]])
        self.assert_near(tape(height=5, speed=1)["ratio"], 27 / 13)

    def test_numbers_that_are_not_finite(self) -> None:
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], "ratio")
        for number in (math.nan, math.inf, -math.inf):
            with self.assertRaises(kinestat.UsageError) as refused:
                tape.play([[5.0, 1.0], [number, 1.0]])
            self.assertIn("height", str(refused.exception))
        self.assert_near(tape(height=5, speed=1)["ratio"], 27 / 13)

    def test_out(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", ["ratio", "d.wz"])
        out = array("d", [0] * 4)
        self.assertIs(tape.play([5.0, 6.0], out=out), out)
        self.assert_near(out[0], 27 / 13)
        self.assert_near(out[2], 33 / 12)
        for wrong in (array("d", [0] * 3), array("f", [0] * 4), bytes(32), array("q", [0] * 4)):
            with self.assertRaises(ValueError):
                tape.play([5.0, 6.0], out=wrong)

    def test_parameters_that_only_a_sweep_uses_are_no_matter(self) -> None:
        # The file is without warnings; its parameter 'sets' stands in conditions of its sweep.
        train = kinestat.load(ROOT / "mechanisms/sweeps/ravigneaux_search.yaml")
        self.assertEqual(train.messages, [])
        tape = train.record(["N1", "N2", "N5"], "ratio", case="M1")
        self.assert_near(tape(N1=20, N2=43, N5=14)["ratio"], first_gear(20, 43, 14), 1e-11)

    def test_a_tape_outlives_its_mechanism(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", "ratio")
        gc.collect()
        self.assert_near(tape(height=6)["ratio"], 33 / 12)
        mechanism = kinestat.load(FOUR_BAR)
        tape = mechanism.record("height", "ratio")
        mechanism.set("height", "3 m")
        self.assert_near(tape(height=6)["ratio"], 33 / 12)

    def test_statuses_outlive_the_tape(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", "ratio")
        tape.play([5.0])
        statuses = tape.statuses
        del tape
        gc.collect()
        self.assertEqual(list(statuses), ["solved"])

    def test_units_of_the_file(self) -> None:
        tape = kinestat.parse(LEVER).record(["arm", "tilt"], ["motor"])
        self.assertEqual(tape.input_units, ("mm", "deg"))
        self.assertEqual(tape.output_units, ("N*m",))
        for arm, tilt in ((40, 30), (50, 0), (10, 90), (25, 135)):
            torque = tape(arm=arm, tilt=tilt)["motor"]
            right = 10 * arm / 1000 * math.cos(math.radians(tilt))
            self.assertLess(abs(torque - right), 1e-12)

    @unittest.skipUnless(PROGRAM, "KINESTAT_PROGRAM is not set")
    def test_states_are_those_of_the_program(self) -> None:
        path = ROOT / "mechanisms/cables/block_and_tackle.yaml"
        mechanism = kinestat.load(path)
        for name in mechanism.parameter_names:
            tape = mechanism.record(name, case=mechanism.cases[0])
            value = 1.0625 * mechanism.parameters[name]
            row = tape(**{name: value})
            words = ["--set", f"{name}={value!r} {tape.input_units[0]}".rstrip()]
            done = subprocess.run([PROGRAM, "analyze", "--format", "json", *words, path],
                                  capture_output=True, text=True, check=False)
            case = json.loads(done.stdout)["cases"][mechanism.cases[0]]
            actions = {**case["kinematics"]["freedoms"], **case["statics"]["actions"]}
            compared = 0
            for output, number in row.items():
                if actions.get(output) is not None:
                    self.assertTrue(math.isclose(number, actions[output], rel_tol=1e-9, abs_tol=1e-9),
                                    f"{name}: {output} is {number}, not {actions[output]}")
                    compared += 1
            self.assertGreater(compared, 2)


class WithoutNumpy(Tapes):
    def setUp(self) -> None:
        super().setUp()
        without = mock.patch.object(_numbers, "numpy", None)
        without.start()
        self.addCleanup(without.stop)


if __name__ == "__main__":
    unittest.main()
