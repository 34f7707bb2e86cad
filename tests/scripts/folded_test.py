"""folded.py: rows of tables become lines, and the lines the same rows."""

from __future__ import annotations

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "golden"))
from folded import Row, fold, unfold  # noqa: E402

SCREW = ["Tx", "Ty", "Tz", "Rx", "Ry", "Rz"]


def lines(*rows: Row) -> list[str]:
    return fold(rows).splitlines()


class Folded(unittest.TestCase):
    def check(self, rows: list[Row], *folded: str) -> None:
        """Written so, and read back."""
        self.assertEqual(lines(*rows), list(folded))
        self.assertEqual(sorted(unfold(fold(rows))), sorted(rows))

    def test_components_of_a_screw_are_one_line(self) -> None:
        units = 3 * ["N*m"] + 3 * ["N"]
        self.check([Row("1", "statics", "hook", f"load/wrench/{SCREW[i]}", str(i), unit)
                    for i, unit in enumerate(units)],
                   "[statics of 1]",
                   "hook | load/wrench/Tx,Ty,Tz,Rx,Ry,Rz | 0 1 2 3 4 5 | N*m N*m N*m N N N")

    def test_actions_of_a_coupling_are_one_line(self) -> None:
        self.check([Row("1", "statics", f"a.{label}", "action", value, "N")
                    for label, value in (("Rx", "3"), ("Ry", "-4"))],
                   "[statics of 1]", "a.Rx,Ry | action | 3 -4 | N")

    def test_points_of_a_curve_are_a_line_for_each_coordinate(self) -> None:
        self.check([Row("0", "synthesis", "curves", f"points/{i}/{'xy'[k]}", str(10 * i + k), "m")
                    for i in range(3) for k in range(2)],
                   "[synthesis of 0]", "curves | points/0..2/x | 0 10 20 | m",
                   "curves | points/0..2/y | 1 11 21 | m")

    def test_steps_of_a_motion_are_one_line(self) -> None:
        rows = [Row("", "motion", "a.wz", "position", str(i), "rad", step=str(i)) for i in range(3)]
        events = [Row("", "motion", "a.wz", "event/dead_point", "7", "rad", step=step)
                  for step in ("4", "4", "9")]
        self.check(rows + events, "[motion]", "a.wz | position@0..2 | 0 1 2 | rad",
                   "a.wz | event/dead_point@4,4,9 | 7 7 7 | rad")

    def test_elements_and_cases_of_the_same_values_are_one_line(self) -> None:
        self.check([Row(case, "power", element, "supplied", value, "W")
                    for case, element, value in (
                        ("1", "a", "0"), ("1", "b", "0"), ("1", "c", "5"),
                        ("2", "a", "0"), ("2", "b", "0"), ("2", "c", "6"))],
                   "[power of 1 2]", "a b | supplied | 0 | W",
                   "[power of 1]", "c | supplied | 5 | W",
                   "[power of 2]", "c | supplied | 6 | W")

    def test_only_what_is_equal_throughout_is_one_line(self) -> None:
        one = Row("1", "statics", "a", "action", "2", "N")
        for other in (one._replace(value="3"), one._replace(unit="kN"), one._replace(value=""),
                      one._replace(status="locked"), one._replace(quantity="load")):
            with self.subTest(other):
                other = other._replace(element="b")
                self.assertEqual(len([line for line in lines(one, other) if "|" in line]), 2)
                self.assertEqual(sorted(unfold(fold([one, other]))), sorted([one, other]))

    def test_what_repeats_a_screw_is_told_once(self) -> None:
        wrench = [Row("1", "statics", "a", f"wrench/{SCREW[i]}", str(i), "N") for i in range(6)]
        force = [Row("1", "statics", "a", f"force/{'xyz'[i]}", str(3 + i), "N") for i in range(3)]
        self.check(wrench + force, "[statics of 1]",
                   "a | wrench/Tx,Ty,Tz,Rx,Ry,Rz | 0 1 2 3 4 5 | N")

    def test_what_should_repeat_a_screw_and_does_not_is_told(self) -> None:
        wrench = [Row("1", "statics", "a", f"wrench/{SCREW[i]}", str(i), "N") for i in range(6)]
        force = [Row("1", "statics", "a", f"force/{axis}", "8", "N") for axis in "xyz"]
        self.check(wrench + force, "[statics of 1]",
                   "a | wrench/Tx,Ty,Tz,Rx,Ry,Rz | 0 1 2 3 4 5 | N",
                   "a | force/x,y,z | 8 8 8 | N")

    def test_a_value_that_does_not_exist_is_none(self) -> None:
        self.check([Row("", "shift", "", "span", "")], "[shift]", "'' | span | none")

    def test_names_of_any_kind_are_read_back(self) -> None:
        for name in ("known output", "a | b", "[x]", "it's", 'a "b"', "a\\b", "", "a,b", "1.2"):
            with self.subTest(name):
                row = Row(name, "power", name, "supplied", "1", "rad/s per mm/s", "no_value")
                self.assertEqual(unfold(fold([row])), [row])

    def test_numbers_have_twelve_digits_and_words_all_letters(self) -> None:
        values = {"0.6666666666666666": "0.666666666667", "1.0": "1", "-2.5e-17": "-2.5e-17",
                  "12345678901234": "12345678901234", "A+B": "A+B", "": "none"}
        for value, short in values.items():
            with self.subTest(value):
                self.assertEqual(lines(Row("", "power", "a", "supplied", value)),
                                 ["[power]", f"a | supplied | {short}"])

    def test_a_damaged_line_is_named(self) -> None:
        for text in ("[power", "a | supplied", "a | twist/0..5 | 1 2 3", "a | b | 'c",
                     "a | rate | 1 | N kN", "a | rate | 1 | N | more"):
            with self.subTest(text), self.assertRaisesRegex(ValueError, "^line 2: "):
                unfold(f"[power]\n{text}\n")


if __name__ == "__main__":
    unittest.main()
