"""update_golden.sh and run_golden.py, in a repository of one mechanism and one case."""

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


class UpdateGolden(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "repository"
        for file in ("scripts/update_golden.sh", "tests/cli/run_case.py",
                     "tests/golden/run_golden.py", "mechanisms/planar/four_bar.yaml"):
            (self.root / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / file, self.root / file)
        self.golden = self.root / "tests" / "golden" / NAME / "report.json"
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

    def check(self) -> tuple[int, str]:
        """Status and complaint of the test of the mechanism."""
        done = self.call(
            sys.executable, "-B", self.root / "tests/golden/run_golden.py",
            self.root / "mechanisms/planar/four_bar.yaml", "--program", PROGRAM,
        )
        return done.returncode, done.stderr

    def change_ratio(self, factor: float) -> None:
        report = json.loads(self.golden.read_text("utf-8"))
        case = next(iter(report["cases"].values()))
        case["ratio"] *= factor
        self.golden.write_text(json.dumps(report), encoding="utf-8")

    def test_a_missing_report_says_how_to_write_it(self) -> None:
        status, complaint = self.check()

        self.assertEqual(status, 1)
        self.assertIn(f"then run scripts/update_golden.sh {NAME}", complaint)

    def test_a_written_report_is_met_and_names_no_path_of_this_machine(self) -> None:
        self.assertIn(f"{NAME}/report.json: rewritten", self.update(NAME))

        self.assertEqual(self.check(), (0, ""))
        self.assertNotIn(str(self.root), self.golden.read_text("utf-8"))

    def test_a_changed_value_is_shown_and_rewritten(self) -> None:
        self.update(NAME)
        self.change_ratio(1.001)

        status, complaint = self.check()

        self.assertEqual(status, 1)
        self.assertIn("/ratio ", complaint)
        self.assertIn("rewritten", self.update(NAME))
        self.assertEqual(self.check(), (0, ""))

    def test_what_still_holds_is_not_touched(self) -> None:
        self.update()
        self.change_ratio(1 + 1e-12)
        text = self.golden.read_text("utf-8")

        self.assertEqual(self.update(), "")
        self.assertEqual(self.golden.read_text("utf-8"), text)

    def test_all_are_the_default(self) -> None:
        said = self.update()

        self.assertIn("report.json: rewritten", said)
        self.assertIn("version/out: rewritten", said)

    def test_folders_may_be_named_from_anywhere(self) -> None:
        self.assertIn("version/out: rewritten", self.update("version", cwd=self.case))
        self.golden.parent.mkdir()
        self.assertIn("report.json: rewritten", self.update(NAME, cwd=self.golden.parent.parent))
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
