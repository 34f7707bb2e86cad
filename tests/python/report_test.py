"""Reports: numbers by their places, statuses, warnings."""

from __future__ import annotations

import gc
import json
import math
import subprocess
import unittest
import warnings
from pathlib import Path

import kinestat

from python_case import Case, FOUR_BAR, LEVER, PROGRAM, RAVIGNEAUX, ROOT


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


if __name__ == "__main__":
    unittest.main()
