"""The Python package: numbers against sources, closed forms and the program; what it refuses; memory
and threads."""

from __future__ import annotations

import copy
import ctypes.util
import gc
import json
import math
import os
import pickle
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
import unittest
import warnings
from array import array
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any
from unittest import mock

import kinestat
from kinestat import _numbers

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]
try:
    import pandas
except ImportError:
    pandas = None

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("KINESTAT_PROGRAM", "")
RAVIGNEAUX = ROOT / "mechanisms/transmissions/ravigneaux.yaml"
FOUR_BAR = ROOT / "mechanisms/sweeps/four_bar_height.yaml"
LEVER = """kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {arm: 40 mm, tilt: 30 deg, push: 5 N, count: 2}
ground: frame
bodies: [lever]
couplings:
  a: {type: revolute, bodies: [frame, lever], at: [0, 0]}
actuators: {motor: {coupling: a}}
loads:
  weight: {body: lever, at: [arm*cos(tilt), arm*sin(tilt)], force: [0, -count*push]}
cases:
  held: {motion: {motor: 60 rpm}, input: motor}
"""


def four_bar_ratio(height: float) -> float:
    """By the pole of crank and rocker: mechanisms/sweeps/four_bar_height.yaml."""
    return (6 * height - 3) / (18 - height)


def first_gear(n1: float, n2: float, n5: float, n6: float = 22) -> float:
    """The ratio of M1: sun 1, planet 5, the long planet in two steps, the ring."""
    return (n2 + n6 - n1 - 2 * n5) / n1 * (n2 + 2 * n6) / n6


def ravigneaux(**parameters: Any) -> kinestat.Mechanism:
    """With planets that fit whatever N1, N2 and N5 are."""
    train = kinestat.load(RAVIGNEAUX, N3="N2 + 2*N6jk", N6i="N2 + N6jk - N1 - 2*N5")
    train.parameters.update(parameters)
    return train


class Case(unittest.TestCase):
    def setUp(self) -> None:
        # No warning passes unseen.
        catcher = warnings.catch_warnings()
        catcher.__enter__()
        self.addCleanup(catcher.__exit__, None, None, None)
        warnings.simplefilter("error")

    def assert_near(self, a: float, b: float, relative: float = 1e-12) -> None:
        self.assertTrue(math.isclose(a, b, rel_tol=relative), f"{a} is not {b}")

    def folder(self) -> Path:
        place = tempfile.TemporaryDirectory(prefix="kinestat-python-")
        self.addCleanup(place.cleanup)
        return Path(place.name)


class Reports(Case):
    def test_values_of_the_source(self) -> None:
        report = kinestat.load(RAVIGNEAUX).analyze()
        self.assertEqual(report.status, kinestat.Status.DONE)
        self.assertEqual(report.messages, [])
        # Cazangi 2008, Tab. 5.15, in fractions, and Eq. 5.73
        for case, ratio in (("M1", 595 / 209), ("M2", 21080 / 13167), ("M3", 1), ("MR", -85 / 41)):
            self.assert_near(report["cases", case, "ratio"], ratio)
        self.assert_near(report["/cases/MR/statics/actions/out"], 207.3, 0.05 / 207.3)
        self.assertEqual(report["/mobility/minimal/net_freedom"], 2)

    def test_null_is_nan_and_truth_is_one(self) -> None:
        report = kinestat.load(RAVIGNEAUX).analyze()
        self.assertEqual(report["/cases/M1/kinematics/evidence/exact"], 0)
        values = report.to_dict()
        found = [key for key, value in values["cases"]["M1"]["statics"]["evidence"].items()
                 if value is None]
        for key in found:
            self.assertTrue(math.isnan(report["cases", "M1", "statics", "evidence", key]), key)

    def test_places_that_are_none(self) -> None:
        report = kinestat.load(RAVIGNEAUX).analyze()
        for place in ("/cases/M9/ratio", "/cases", "", "ratio", "/kinestat/version"):
            with self.assertRaises(kinestat.UnknownPlace, msg=place) as refused:
                report[place]
            self.assertIsInstance(refused.exception, KeyError)
            self.assertEqual(refused.exception.status, kinestat.Status.USAGE)
            self.assertNotIn("'\\", str(refused.exception))
        self.assertIsNone(report.get("/cases/M9/ratio"))
        self.assertEqual(report.get("/cases/M9/ratio", 0.5), 0.5)
        with self.assertRaises(ValueError):
            report["/cases/M1/ratio\0"]

    def test_keys_with_slashes(self) -> None:
        report = kinestat.parse(LEVER.replace("held:", "held/~up:")).analyze()
        self.assert_near(report["cases", "held/~up", "kinematics", "freedoms", "a.wz"], 2 * math.pi)

    @unittest.skipUnless(PROGRAM, "KINESTAT_PROGRAM is not set")
    def test_the_report_is_that_of_the_program(self) -> None:
        chosen: list[tuple[Path, dict[str, str]]] = [
            (RAVIGNEAUX, {}), (FOUR_BAR, {"height": "450 cm"}),
            (ROOT / "mechanisms/cables/capstan.yaml", {}),
            (ROOT / "mechanisms/spatial/rssr.yaml", {}),
        ]
        for path, settings in chosen:
            words = [word for item in settings.items() for word in ("--set", "=".join(item))]
            done = subprocess.run([PROGRAM, "analyze", "--format", "json", *words, path],
                                  capture_output=True, text=True, check=False)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", kinestat.MechanismWarning)
                report = kinestat.load(path, **settings).analyze()
            self.assertEqual(report.status, done.returncode)
            self.assertEqual(report.to_dict(), json.loads(done.stdout))
            self.assertEqual("\n".join(map(str, report.messages))[:40], done.stderr[:40])

    def test_json_is_utf8(self) -> None:
        text = LEVER.replace("held:", "gehalten – 保持:")
        report = kinestat.parse(text, name="Ärm.yaml").analyze()
        self.assertIn("gehalten – 保持", report.to_dict()["cases"])
        self.assertEqual(report.to_dict()["mechanism"]["file"], "Ärm.yaml")

    def test_a_report_outlives_its_mechanism(self) -> None:
        report = kinestat.load(RAVIGNEAUX).analyze()
        gc.collect()
        self.assert_near(report["/cases/M1/ratio"], 595 / 209)


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
            with self.assertRaises(ValueError):
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


class Errors(Case):
    def refused(self, kind: type[kinestat.Error], code: str, call: Any) -> kinestat.Error:
        with self.assertRaises(kind) as refused:
            call()
        error = refused.exception
        self.assertEqual(error.messages[0].code, code)
        self.assertTrue(error.messages[0].is_error)
        self.assertIn(error.messages[0].text, str(error))
        self.assertIn(error.messages[0].hint, str(error))
        self.assertIsNone(error.report)
        return error

    def test_no_such_file(self) -> None:
        error = self.refused(kinestat.EnvironmentFailure, "E0151", lambda: kinestat.load("none.yaml"))
        self.assertEqual(error.messages[0].file, "none.yaml")
        self.assertTrue(str(error).startswith("none.yaml: error[E0151]: cannot read 'none.yaml'"))

    def test_a_wrong_file_has_a_place(self) -> None:
        text = LEVER.replace("[frame, lever], at", "[frame, levr], at")
        error = self.refused(kinestat.WrongInput, "E0312", lambda: kinestat.parse(text, "lever.yaml"))
        line = text.splitlines()[7]
        message = error.messages[0]
        self.assertEqual((message.file, message.line, message.column, message.length),
                         ("lever.yaml", 8, line.index("levr") + 1, 4))
        self.assertEqual(str(message).splitlines()[0], str(error).splitlines()[0])
        self.assertIn(line, str(error))
        self.assertIn("^^^^", str(error))
        self.assertIsInstance(error, ValueError)

    def test_columns_count_characters(self) -> None:
        text = ("{kinestat: 1, name: 'äöü', space: planar, ground: frame, bodies: [lever], "
                "couplings: {a: {type: revolute, bodies: [frame, levr], at: [0, 0]}}}")
        error = self.refused(kinestat.WrongInput, "E0312", lambda: kinestat.parse(text))
        self.assertEqual(error.messages[0].column, text.index("levr") + 1)

    def test_a_file_of_other_bytes(self) -> None:
        path = self.folder() / "bytes.yaml"
        path.write_bytes(b"kinestat: 1\n\xff\xfe\n")
        self.refused(kinestat.WrongInput, "E0202", lambda: kinestat.load(path))
        with self.assertRaises(kinestat.WrongInput):
            kinestat.parse("")
        with self.assertRaises(kinestat.WrongInput):
            kinestat.parse("kinestat: 1\0\n")
        with self.assertRaises(kinestat.EnvironmentFailure):
            kinestat.load(path.parent)

    def test_several_mistakes_are_all_told(self) -> None:
        text = LEVER.replace("bodies: [lever]", "bodies: [levre]")
        with self.assertRaises(kinestat.WrongInput) as refused:
            kinestat.parse(text)
        self.assertGreater(len(refused.exception.messages), 1)

    def test_unknown_names(self) -> None:
        bar = kinestat.load(FOUR_BAR)
        error = self.refused(kinestat.UsageError, "E0102", lambda: bar.set("heigth", "4 m"))
        self.assertIn("height", error.messages[0].hint)
        with self.assertRaises(kinestat.UsageError):
            kinestat.load(FOUR_BAR, heigth="4 m")
        wrong: list[dict[str, Any]] = [
            {"inputs": "heigth"}, {"inputs": []}, {"inputs": "height", "outputs": "torque"},
            {"inputs": "height", "case": "M1"}, {"inputs": ["height", "height"]}, {"inputs": ""},
        ]
        for arguments in wrong:
            with self.subTest(arguments):
                with self.assertRaises(kinestat.UsageError) as refused:
                    bar.record(**arguments)
                self.assertTrue(refused.exception.messages[0].text)
        with self.assertRaises(kinestat.UsageError):
            kinestat.load(RAVIGNEAUX).record("N1")  # which of four cases

    def test_wrong_units(self) -> None:
        bar = kinestat.load(FOUR_BAR)
        error = self.refused(kinestat.UsageError, "E0102", lambda: bar.set("height", "4 kg"))
        self.assertIn("length", str(error))

    def test_a_missed_value_has_a_report(self) -> None:
        bar = kinestat.load(FOUR_BAR, height="4 m")
        with self.assertWarns(kinestat.MechanismWarning) as warned:
            report = bar.analyze()
        self.assertEqual(warned.filename, __file__)
        assert isinstance(warned.warning, kinestat.MechanismWarning)
        self.assertEqual(warned.warning.message.code, "E0901")
        self.assertEqual(report.status, kinestat.Status.CHECK_FAILED)
        self.assertEqual([message.code for message in report.messages], ["E0901"])
        self.assertTrue(report.messages[0].is_error)
        with self.assertRaises(kinestat.CheckFailed) as refused:
            bar.analyze(check=True)
        assert refused.exception.report is not None
        self.assert_near(refused.exception.report["/cases/crank turns/ratio"], 21 / 14)
        with self.assertRaises(kinestat.CheckFailed) as again:
            report.check()
        self.assertIs(again.exception.report, report)
        self.assertEqual(str(again.exception), str(refused.exception))
        self.assertIn("^", str(again.exception))

    def test_no_answer_has_a_report(self) -> None:
        path = ROOT / "tests/cli/e0602_no_equilibrium/file.yaml"
        mechanism = kinestat.load(path)
        with self.assertWarns(kinestat.MechanismWarning):
            report = mechanism.analyze()
        self.assertEqual(report.status, kinestat.Status.NO_ANSWER)
        self.assertTrue(math.isnan(report["/cases/known output/statics/actions/a.Rx"]))
        with self.assertRaises(kinestat.NoAnswer) as refused:
            mechanism.analyze(check=True)
        self.assertEqual(refused.exception.messages[0].code, "E0602")
        self.assertIsNotNone(refused.exception.report)

    def test_too_few_knowns(self) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", kinestat.MechanismWarning)  # no use of 'speed' is left
            bar = kinestat.parse(FOUR_BAR.read_text().replace("motion: {Tin: speed}", "motion: {}"))
        with self.assertRaises(kinestat.WrongInput):
            bar.analyze(check=True)

    def test_warnings(self) -> None:
        path = ROOT / "tests/cli/w0605_contact_that_pulls/file.yaml"
        mechanism = kinestat.load(path)
        with warnings.catch_warnings(record=True) as seen:
            warnings.simplefilter("always")
            report = mechanism.analyze(check=True)
        self.assertEqual(report.status, kinestat.Status.DONE)
        self.assertEqual([message.code for message in report.messages], ["W0605"])
        self.assertEqual([warning.category for warning in seen], [kinestat.MechanismWarning])
        self.assertEqual(seen[0].filename, __file__)
        self.assertEqual(str(seen[0].message), str(report.messages[0]))
        with self.assertRaises(kinestat.MechanismWarning):
            mechanism.analyze()  # which setUp makes an error


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


class Resources(Case):
    def peak(self) -> int:
        """Most memory so far, in bytes."""
        unit = 1 if sys.platform == "darwin" else 1024
        return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    def assert_flat(self, work: Any, times: int) -> None:
        for _ in range(times // 10):
            work()
        gc.collect()
        before = self.peak()
        for _ in range(times):
            work()
        self.assertLess(self.peak() - before, 8 << 20)

    def test_playing_keeps_no_memory(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", ["ratio", "d.wz"])
        self.assert_flat(lambda: tape(height=4.5), 10_000)

    def test_setting_and_refusing_keep_no_memory(self) -> None:
        bar = kinestat.load(FOUR_BAR)

        def work() -> None:
            bar.set("height", "5 m")
            try:
                bar.set("heigth", "5 m")
            except kinestat.UsageError:
                pass

        self.assert_flat(work, 10_000)

    def test_objects_are_freed(self) -> None:
        def work() -> None:
            bar = kinestat.load(FOUR_BAR)
            bar.record("height", "ratio")(height=4)
            json.loads(bar.analyze().json)

        self.assert_flat(work, 500)

    def test_threads_with_their_own_tapes_agree(self) -> None:
        heights = [3 + k / 1000 for k in range(4000)]
        right = [list(row) for row in kinestat.load(FOUR_BAR).record("height").play(heights)]
        self.in_threads(lambda: self.assertEqual(
            [list(row) for row in kinestat.load(FOUR_BAR).record("height").play(heights)], right))

    def test_threads_wait_for_a_tape(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", "ratio")

        def work() -> None:
            for k in range(2000):
                height = 3 + k / 1000
                self.assertAlmostEqual(tape(height=height)["ratio"], four_bar_ratio(height))

        self.in_threads(work)

    def test_messages_are_those_of_the_thread(self) -> None:
        bar = kinestat.load(FOUR_BAR)

        def work() -> None:
            name = threading.current_thread().name
            for _ in range(300):
                with self.assertRaisesRegex(kinestat.UsageError, re.escape(name)):
                    bar.set(name, "1 m")

        self.in_threads(work)

    def in_threads(self, work: Any) -> None:
        problems: list[BaseException] = []

        def guarded() -> None:
            try:
                work()
            except BaseException as problem:
                problems.append(problem)

        threads = [threading.Thread(target=guarded) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(problems, [])


class Library(Case):
    def run_python(self, code: str, cwd: Path, **environment: str) -> subprocess.CompletedProcess[str]:
        kept = {key: value for key, value in os.environ.items() if not key.startswith("KINESTAT")}
        return subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True,
                              check=False, cwd=cwd, env={**kept, **environment})

    def package(self) -> Path:
        """A folder with the package alone."""
        folder = self.folder()
        shutil.copytree(Path(kinestat.__file__).parent, folder / "a/b/kinestat",
                        ignore=shutil.ignore_patterns("__pycache__"))
        return folder / "a/b"

    def test_version_is_that_of_the_project(self) -> None:
        text = (ROOT / "python/pyproject.toml").read_text()
        self.assertEqual(re.findall(r'^version = "(.*?)"', text, re.MULTILINE), [kinestat.__version__])

    def test_a_library_that_is_not_there(self) -> None:
        done = self.run_python("import kinestat", self.folder(), KINESTAT_LIBRARY="/nowhere/lib.so",
                               PYTHONPATH=str(self.package()))
        self.assertEqual(done.returncode, 1)
        self.assertIn("ImportError: KINESTAT_LIBRARY is '/nowhere/lib.so', which cannot be loaded",
                      done.stderr)

    @unittest.skipIf(ctypes.util.find_library("kinestat"), "a library is installed")
    def test_no_library_anywhere(self) -> None:
        done = self.run_python("import kinestat", self.folder(), PYTHONPATH=str(self.package()))
        self.assertEqual(done.returncode, 1)
        self.assertIn("set the environment variable KINESTAT_LIBRARY", done.stderr)

    @unittest.skipUnless(ctypes.util.find_library("c"), "no library to take for it")
    def test_another_library(self) -> None:
        done = self.run_python("import kinestat", self.folder(), PYTHONPATH=str(self.package()),
                               KINESTAT_LIBRARY=str(ctypes.util.find_library("c")))
        self.assertEqual(done.returncode, 1)
        self.assertIn("has no function 'kinestat_version'", done.stderr)

    @unittest.skipUnless(os.environ.get("KINESTAT_LIBRARY"), "KINESTAT_LIBRARY is not set")
    def test_a_library_beside_the_package_or_above_it(self) -> None:
        for place in ("a/b/kinestat", "a/lib", "lib", "a/build/release/lib"):
            package = self.package()
            folder = package.parents[1] / place
            folder.mkdir(parents=True, exist_ok=True)
            (folder / "libkinestat.so.0").symlink_to(os.environ["KINESTAT_LIBRARY"])
            done = self.run_python("import kinestat; print(kinestat.__version__)", self.folder(),
                                   PYTHONPATH=str(package))
            self.assertEqual((done.stdout.strip(), done.stderr), (kinestat.__version__, ""))

    def test_all_that_the_header_declares_is_there(self) -> None:
        header = (ROOT / "include/kinestat.h").read_text()
        declared = set(re.findall(r"\b(kinestat_\w+)\(", header))
        self.assertEqual(declared, set(kinestat._library.FUNCTIONS))
        statuses = {name: int(value) for name, value in
                    re.findall(r"KINESTAT_(\w+) = (\d+)", header.partition("kinestat_status")[2]
                               .partition("}")[0])}
        self.assertEqual(statuses, {one.name: one.value for one in kinestat.Status})


if __name__ == "__main__":
    unittest.main()
