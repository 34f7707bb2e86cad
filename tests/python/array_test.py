"""Tapes with arrays of NumPy and frames of pandas."""

from __future__ import annotations

import math
import unittest
from array import array

import kinestat
from kinestat import _numbers

from python_case import Case, FOUR_BAR, LEVER, numpy, pandas


@unittest.skipIf(numpy is None, "NumPy is not installed")
class Arrays(Case):
    def test_contiguous_arrays_are_not_copied(self) -> None:
        rows = numpy.array([[4.0, 2.0], [5.0, 2.0]])
        rows.flags.writeable = False
        given = _numbers.inputs_of(rows, ["height", "speed"])
        self.assertEqual(given.address, rows.ctypes.data)
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], ["ratio"])
        out = numpy.full((2, 1), -1.0)
        self.assertIs(tape.play(rows, out=out), out)
        self.assert_near(out[1, 0], 27 / 13)
        for wrong in (numpy.zeros((1, 2)), numpy.zeros((2, 2)), numpy.zeros((2, 1), dtype=numpy.float32),
                      numpy.zeros((4, 1))[::2], numpy.zeros((2, 1), dtype=">f8")):
            with self.assertRaises(ValueError):
                tape.play(rows, out=wrong)

    def test_a_vector_is_no_state_of_several_inputs(self) -> None:
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], ["ratio"])
        for shape in ((2,), (4,), (1, 2, 1), ()):
            with self.assertRaises(ValueError):
                tape.play(numpy.full(shape, 4.0))
        with self.assertRaises(ValueError):
            tape.play({"height": numpy.full((2, 2), 4.0), "speed": 1})

    def test_statuses_are_a_mask(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", ["ratio"])
        table = tape.play(numpy.array([5.0, 18.0, 6.0]))
        solved = tape.statuses == "solved"
        self.assertEqual(solved.tolist(), [True, False, True])
        self.assertTrue(numpy.isfinite(table[solved]).all())

    @unittest.skipIf(pandas is None, "pandas is not installed")
    def test_frames(self) -> None:
        tape = kinestat.load(FOUR_BAR).record(["height", "speed"], ["ratio", "d.wz"])
        frame = tape.frame({"height": [5, 18, 6], "speed": 2})
        self.assertEqual(list(frame), ["height", "speed", "ratio", "d.wz", "status"])
        self.assertEqual(list(frame["status"]), ["solved", "no_ratio", "solved"])
        self.assertEqual(frame.attrs["units"],
                         {"height": "m", "speed": "rad/s", "ratio": "", "d.wz": "rad/s"})
        self.assert_near(frame["ratio"][2], 33 / 12)
        self.assertTrue(math.isnan(frame["ratio"][1]))
        given = pandas.DataFrame({"speed": [1.0, 2.0], "height": [5.0, 6.0], "name": ["a", "b"]})
        self.assert_near(tape.play(given)[1, 0], 33 / 12)
        again = tape.frame(given)
        self.assert_near(again["d.wz"][1], 2 * 12 / 33)
        again["height"] = 0.0
        self.assertEqual(list(given["height"]), [5.0, 6.0])
        with self.assertRaises(ValueError):
            tape.play(given[["speed", "name"]])
        self.assertEqual(len(tape.frame(numpy.zeros((0, 2)))), 0)

    @unittest.skipIf(pandas is None, "pandas is not installed")
    def test_an_output_called_as_an_input(self) -> None:
        lever = kinestat.parse(LEVER.replace("arm", "motor"))
        frame = lever.record("motor", "motor").frame([40.0])
        self.assertEqual(list(frame), ["motor", "motor (output)", "status"])


if __name__ == "__main__":
    unittest.main()
