"""run.sh, with a build that makes a program which only writes a report."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "run.sh"
CMAKE = """#!/bin/bash
echo "$*" >>"$LOG"
mkdir -p "$BUILD/app"
touch "$BUILD/build.ninja"
[[ -z ${NINJA_STATUS:-} ]] || echo "progress of $NINJA_STATUS"
[[ -z ${BROKEN:-} ]] || { echo "an error in a source"; exit 1; }
"""
PROGRAM = """#!/bin/bash
[[ $1 == report ]] && { [[ -n ${NO_PAGE:-} ]] || touch "$3"; exit 0; }
echo "table of ${*: -1} in $PWD"
touch "$3/new.report.json"
exit "${STATUS:-0}"
"""


class RunScript(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "a root"
        self.build = self.root / "build" / "release"
        (self.build / "app").mkdir(parents=True)
        (self.root / "scripts").mkdir()
        shutil.copy(SCRIPT, self.root / "scripts")
        self.write("scripts/setup.sh", "#!/bin/bash\n")
        self.write("bin/cmake", CMAKE)
        self.write("build/release/app/kinestat", PROGRAM)
        self.write("reports/old.report.json", "")
        os.utime(self.root / "reports/old.report.json", (0, 0))

    def write(self, name: str, text: str) -> None:
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        path.chmod(0o755)

    def run_script(self, *arguments: str, **env: str) -> subprocess.CompletedProcess[str]:
        path = f"{self.root / 'bin'}:{os.environ['PATH']}"
        told = {"PATH": path, "LOG": str(self.root / "log"), "BUILD": str(self.build)}
        return subprocess.run(
            [self.root / "scripts/run.sh", *arguments], env=told | env, cwd="/",
            capture_output=True, text=True, check=False,
        )

    def test_shows_the_table_and_the_new_files(self) -> None:
        done = self.run_script("x y.yaml")
        self.assertEqual(
            done.stdout,
            f"table of x y.yaml in /\n\nWritten:\n  {self.root}/reports/new.report.json\n"
            f"  {self.root}/reports/report.html\n"
            f"Open in a browser: {self.root}/reports/report.html\n"
            f"The program: {self.build}/app/kinestat; to install it: scripts/package.sh, which "
            f"makes packages,\nor: cmake --install {self.build} --prefix ~/.local\n",
        )

    def test_names_no_page_that_was_not_written(self) -> None:
        done = self.run_script("x.yaml", NO_PAGE="1")
        self.assertNotIn("report.html", done.stdout)

    def test_writes_no_page_for_options_of_the_analysis(self) -> None:
        done = self.run_script("--format", "json", "x.yaml")
        self.assertNotIn("report.html", done.stdout)

    def test_takes_the_ravigneaux_train_without_a_file(self) -> None:
        done = self.run_script()
        self.assertIn(f"{self.root}/mechanisms/transmissions/ravigneaux.yaml", done.stdout)

    def test_returns_the_programs_status(self) -> None:
        self.assertEqual(self.run_script("x.yaml", STATUS="5").returncode, 5)

    def test_configures_only_once(self) -> None:
        self.run_script("x.yaml")
        self.run_script("x.yaml")
        asked = (self.root / "log").read_text(encoding="utf-8")
        self.assertEqual(asked.count("--preset release"), 1)
        self.assertEqual(asked.count("--target kinestat"), 2)

    def test_shows_how_far_the_build_is(self) -> None:
        done = self.run_script("x.yaml")
        self.assertIn("progress of run.sh: step %f of %t", done.stderr)

    def test_shows_why_a_build_failed(self) -> None:
        done = self.run_script("x.yaml", BROKEN="1")
        self.assertEqual((done.returncode, done.stdout), (4, ""))
        self.assertIn("an error in a source", done.stderr)


if __name__ == "__main__":
    unittest.main()
