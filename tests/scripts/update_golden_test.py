"""update_golden.sh and run_golden.py, in a repository of two mechanisms and one case."""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path("kinestat")
NAME = "planar_four_bar"
MODEL = "mechanisms/planar/four_bar.yaml"
# Of this one the whole report is kept.
WHOLE = "sweeps_four_bar_height"
WHOLE_MODEL = "mechanisms/sweeps/four_bar_height.yaml"


class UpdateGolden(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "repository"
        for file in ("scripts/update_golden.sh", "tests/cli/run_case.py",
                     "tests/golden/run_golden.py", "tests/golden/folded.py", MODEL,
                     WHOLE_MODEL):
            (self.root / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / file, self.root / file)
        self.golden = self.root / "tests" / "golden" / NAME / "folded.txt"
        self.report = self.root / "tests" / "golden" / WHOLE / "report.json"
        self.case = self.root / "tests" / "cli" / "version"
        self.case.mkdir()
        (self.case / "cmd").write_text('"$KINESTAT" --version\n', encoding="utf-8")

    def call(self, *command: str | Path, **where: Path) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            list(map(str, command)), capture_output=True, encoding="utf-8", check=False,
            env=os.environ | {"KINESTAT": str(PROGRAM)}, timeout=120, **where,
        )

    def update(self, *names: str, **where: Path) -> str:
        """What the script says when it succeeds."""
        done = self.call(self.root / "scripts" / "update_golden.sh", *names, **where)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def check(self, model: str = MODEL) -> tuple[int, str]:
        """Status and complaint of the test of the mechanism."""
        done = self.call(
            sys.executable, "-B", self.root / "tests/golden/run_golden.py", self.root / model,
            "--program", PROGRAM,
        )
        return done.returncode, done.stderr

    def change(self, line: str, new: str) -> None:
        """Replaces the one such text of the golden."""
        text = self.golden.read_text("utf-8")
        self.assertEqual(text.count(line), 1, line)
        self.golden.write_text(text.replace(line, new), encoding="utf-8")

    def change_ratio(self, factor: float) -> None:
        report = json.loads(self.report.read_text("utf-8"))
        case = next(iter(report["cases"].values()))
        case["ratio"] *= factor
        self.report.write_text(json.dumps(report), encoding="utf-8")

    def test_a_missing_report_says_how_to_write_it(self) -> None:
        status, complaint = self.check()

        self.assertEqual(status, 1)
        self.assertIn(f"then run scripts/update_golden.sh {NAME}", complaint)

    def test_a_written_report_is_met_and_names_no_path_of_this_machine(self) -> None:
        self.assertIn(f"{NAME}/folded.txt: rewritten", self.update(NAME))

        self.assertEqual(self.check(), (0, ""))
        self.assertNotIn(str(self.root), self.golden.read_text("utf-8"))

    def test_a_change_of_any_kind_is_shown(self) -> None:
        changes = {
            "a value in the sixth digit": ("a.wz | velocity | 2.07692", "a.wz | velocity | 2.07693"),
            "a value of a motion": (" | 2.34849893905 ", " | 2.34850893905 "),
            "no value": ("recirculation/factor | none", "recirculation/factor | 0"),
            "a line less": ("spatial | net_constraint | 3\n", ""),
            "a line more": ("spatial | order | 6\n", "spatial | order | 6\nspatial | size | 6\n"),
            "another status": ("[power of 'known output']", "[power of 'known output', locked]"),
            "another unit": ("d.wz | velocity | 1 | rad/s", "d.wz | velocity | 1 | rpm"),
            "another dimension": ("d.wz | velocity | 1 | rad/s", "d.wz | velocity | 1 | m/s"),
            "another word": ("motion | status | complete", "motion | status | blocked"),
            "another finding": ("[mobility]\n", "[findings]\nW0601 | count | 1\n[mobility]\n"),
            "another name": ("Four-bar linkage\n", "Five-bar linkage\n"),
            "a damaged line": ("d.wz | velocity | 1 | rad/s", "d.wz | velocity"),
        }
        self.update(NAME)
        text = self.golden.read_text("utf-8")
        for what, (line, new) in changes.items():
            with self.subTest(what):
                self.golden.write_text(text, encoding="utf-8")
                self.change(line, new)

                status, complaint = self.check()

                self.assertEqual(status, 1)
                self.assertIn(f"scripts/update_golden.sh {NAME}", complaint)

    def test_what_differs_is_said_and_rewritten(self) -> None:
        self.update(NAME)
        self.change("d.wz | velocity | 1 |", "d.wz | velocity | 1.001 |")
        self.change("motion | status | complete", "motion | status | blocked")

        complaint = self.check()[1]

        self.assertIn("/Four-bar linkage/known output/kinematics/d.wz/velocity ", complaint)
        self.assertIn("only in A: [words] motion | status | blocked", complaint)
        self.assertIn("rewritten", self.update(NAME))
        self.assertEqual(self.check(), (0, ""))

    def test_a_whole_report_is_kept_as_it_is(self) -> None:
        self.assertIn(f"{WHOLE}/report.json: rewritten", self.update(WHOLE))
        self.assertEqual(self.check(WHOLE_MODEL), (0, ""))
        self.change_ratio(1.001)

        status, complaint = self.check(WHOLE_MODEL)

        self.assertEqual(status, 1)
        self.assertIn("/ratio ", complaint)
        self.assertIn("rewritten", self.update(WHOLE))
        self.assertEqual(self.check(WHOLE_MODEL), (0, ""))

    def test_what_still_holds_is_not_touched(self) -> None:
        self.update()
        self.change_ratio(1 + 1e-12)
        self.change("2.07692307692 | rad/s", "2.0769230769 | rad/s")
        texts = [file.read_text("utf-8") for file in (self.golden, self.report)]

        self.assertEqual(self.update(), "")
        self.assertEqual([file.read_text("utf-8") for file in (self.golden, self.report)], texts)

    def test_all_are_the_default(self) -> None:
        said = self.update()

        self.assertIn("folded.txt: rewritten", said)
        self.assertIn("report.json: rewritten", said)
        self.assertIn("version/out: rewritten", said)

    def test_folders_may_be_named_from_anywhere(self) -> None:
        self.assertIn("version/out: rewritten", self.update("version", cwd=self.case))
        self.golden.parent.mkdir()
        self.assertIn("folded.txt: rewritten", self.update(NAME, cwd=self.golden.parent.parent))
        (self.case / "out").unlink()
        self.assertIn("version/out: rewritten", self.update(".", cwd=self.case))

    def test_an_unknown_name_is_refused(self) -> None:
        done = self.call(self.root / "scripts" / "update_golden.sh", "planar_five_bar")

        self.assertEqual(done.returncode, 2)
        self.assertIn("'planar_five_bar' is neither a mechanism", done.stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
