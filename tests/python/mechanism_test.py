"""Mechanisms: names, parameters and what they may be set to."""

from __future__ import annotations

import copy
import gc
import math
import pickle
from decimal import Decimal
from fractions import Fraction
from typing import Any
import unittest

import kinestat

from python_case import Case, FOUR_BAR, LEVER, RAVIGNEAUX, ROOT, first_gear, four_bar_ratio, numpy, ravigneaux


class Mechanisms(Case):
    def test_names(self) -> None:
        train = kinestat.load(str(RAVIGNEAUX))
        self.assertEqual(train.parameter_names[:6], ("N1", "N2", "N3", "N5", "N6i", "N6jk"))
        self.assertEqual(train.actuators, ("C1", "C2", "B1", "out", "B2"))
        self.assertEqual(train.cases, ("M1", "M2", "M3", "MR"))
        self.assertEqual(list(train.parameters), list(train.parameter_names))
        self.assertIn("N1", train.parameters)
        self.assertNotIn("N9", train.parameters)

    def test_cases_of_gears_come_after_those_of_the_file(self) -> None:
        train = kinestat.load(ROOT / "mechanisms/transmissions/ravigneaux_input_shaft.yaml")
        self.assertLessEqual({"M1", "M2", "M3", "MR"}, set(train.cases))

    def test_parameters_are_set(self) -> None:
        bar = kinestat.load(FOUR_BAR, height="4 m")
        for value, meters in (("4 m", 4), ("4.5 m", 4.5), ("425 cm", 4.25), ("(13/3)*1 m", 13 / 3),
                              ("2*2.05 m", 4.1)):
            bar.set("height", value)
            self.assert_near(bar.parameters["height"], meters)
            with self.assertWarns(kinestat.MechanismWarning):  # the published ratio of 5 m
                ratio = bar.analyze()["/cases/crank turns/ratio"]
            self.assert_near(ratio, four_bar_ratio(meters))

    def test_values_are_handed_over_as_they_are(self) -> None:
        lever = kinestat.parse(LEVER)
        values: list[tuple[Any, float]] = [(3, 3.0), (0.1, 0.1), (Fraction(1, 3), 1 / 3),
                                           (Decimal("0.7"), 0.7), ("2*2", 4.0), (1e-7, 1e-7),
                                           (2.5e15, 2.5e15), (-1.5, -1.5),
                                           (Fraction(-2, 7), -2 / 7), (Decimal("1E+3"), 1000.0)]
        for value, read in values:
            lever.parameters["count"] = value
            self.assertEqual(lever.parameters["count"], read)
        if numpy is not None:
            for value in (numpy.float64(0.3), numpy.int32(3), numpy.float32(0.5)):
                lever.parameters["count"] = value
                self.assertEqual(lever.parameters["count"], float(value))
        lever.parameters["count"] = 0.5
        lever.parameters["count"] += 1
        self.assertEqual(lever.parameters["count"], 1.5)
        wrong: Any
        for wrong in (True, None, [1.0], object()):
            with self.assertRaises(TypeError):
                lever.parameters["count"] = wrong

    def test_units_of_parameters(self) -> None:
        lever = kinestat.parse(LEVER)
        lever.parameters.update(arm="4 cm", tilt="0.5 rad")
        self.assertEqual(lever.parameters["arm"], 40)
        self.assertEqual(lever.parameters.unit("arm"), "mm")
        self.assert_near(lever.parameters["tilt"], math.degrees(0.5))
        self.assertEqual(lever.parameters.unit("tilt"), "deg")
        self.assertEqual(lever.parameters.unit("count"), "")
        with self.assertRaises(KeyError):
            lever.parameters["leg"]
        with self.assertRaises(TypeError):
            del lever.parameters["arm"]

    def test_several_at_once(self) -> None:
        train = ravigneaux(N1=20, N2=43, N5=16)
        with self.assertWarns(kinestat.MechanismWarning):
            ratio = train.analyze()["/cases/M1/ratio"]
        self.assert_near(ratio, first_gear(20, 43, 16))
        train.parameters.update({"N1": 19, "N2": 41, "N5": 15})
        self.assert_near(train.analyze()["/cases/M1/ratio"], 595 / 209)

    def test_what_is_refused_changes_nothing(self) -> None:
        bar = kinestat.load(FOUR_BAR)
        wrong: list[tuple[str, Any]] = [
            ("heigth", "4 m"), ("height", "4 kg"), ("height", 4), ("height", "4 m +"),
            ("height", ""), ("height", "wide"), ("", "4 m"),
            ("speed", "height"),
        ]
        for name, value in wrong:
            with self.assertRaises(kinestat.Error, msg=f"{name}={value}") as refused:
                bar.set(name, value)
            self.assertIn(refused.exception.status,
                          (kinestat.Status.USAGE, kinestat.Status.WRONG_INPUT))
            self.assertTrue(refused.exception.messages)
        for number in (math.nan, math.inf, -math.inf):
            with self.assertRaises(kinestat.UsageError):
                bar.set("height", number)
        with self.assertRaises(ValueError):
            bar.set("height\0", "4 m")
        with self.assertRaises(ValueError):
            bar.set("height", "4 m\0")
        self.assert_near(bar.analyze()["/cases/crank turns/ratio"], 27 / 13)

    def test_a_value_that_the_mechanism_cannot_have_is_told_when_it_is_analysed(self) -> None:
        text = FOUR_BAR.read_text().replace("at: [6, height]", "at: [6, height], x: 1")
        with self.assertRaises(kinestat.WrongInput):
            kinestat.parse(text)
        train = kinestat.parse(RAVIGNEAUX.read_text())
        train.set("alpha", "90 deg")  # teeth that push along the line of centres
        with self.assertRaises(kinestat.WrongInput):
            train.analyze()
        train.set("alpha", "20 deg")
        self.assert_near(train.analyze()["/cases/M1/ratio"], 595 / 209)

    def test_copies_share_the_mechanism(self) -> None:
        bar = copy.copy(kinestat.load(FOUR_BAR))
        gc.collect()
        self.assert_near(bar.analyze()["/cases/crank turns/ratio"], 27 / 13)
        with self.assertRaises(TypeError):
            pickle.dumps(bar)

    def test_one_text_for_a_list_of_names(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", "ratio")
        self.assertEqual((tape.inputs, tape.outputs), (("height",), ("ratio",)))


if __name__ == "__main__":
    unittest.main()
