"""Mistakes: exceptions with the place, and what to type instead."""

from __future__ import annotations

import math
import warnings
from typing import Any
import unittest

import kinestat

from python_case import Case, FOUR_BAR, LEVER, RAVIGNEAUX, ROOT


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


if __name__ == "__main__":
    unittest.main()
