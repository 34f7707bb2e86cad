#!/usr/bin/env python3
"""The recipes for continuous integration and the hook: what they call runs as it is printed."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "scripts/examples"
program = Path(sys.argv.pop(1)).resolve()


class Recipes(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        for name in ("bin", "models", "golden"):
            (self.folder / name).mkdir()
        (self.folder / "bin/kinestat").symlink_to(program)
        self.env = {"PATH": f"{self.folder}/bin:{os.environ['PATH']}", "HOME": str(self.folder),
                    "LC_ALL": "C"}
        self.shell("kinestat new four-bar models/crank.yaml")
        self.shell("kinestat analyze --quiet --out golden models/*.yaml")

    def shell(self, script: str, status: int = 0) -> str:
        done = subprocess.run(["bash", "-e", "-c", script], cwd=self.folder, env=self.env,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, f"{script}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def shorten(self) -> None:
        """The frame, as the README has it."""
        self.shell("sed -i 's/frame_length: 160/frame_length: 159/' models/crank.yaml")

    def run_lines(self, lines: list[str], changed: int) -> None:
        """Those that call the program, twice: as the golden reports have it, and with a change."""
        wanted = [line.replace("/usr/share/kinestat/examples", str(EXAMPLES)) for line in lines
                  if "kinestat" in line and "dpkg" not in line]
        self.assertEqual(len(wanted), 3)
        for line in wanted:
            self.shell(line)
        self.shorten()
        for line in wanted:
            self.shell(line, changed if "golden" in line else 0)
        shutil.copy(self.folder / "models/crank.yaml", self.folder / "models/another.yaml")
        self.assertIn("no golden report", self.shell(next(l for l in wanted if "golden" in l), 1))

    def test_github(self) -> None:
        workflow = yaml.safe_load((EXAMPLES / "github_workflow.yml").read_text(encoding="utf-8"))
        self.run_lines([step.get("run", "") for step in workflow["jobs"]["models"]["steps"]], 1)
        self.assertIn('"version"', (self.folder / "kinestat.sarif").read_text(encoding="utf-8"))

    def test_gitlab(self) -> None:
        job = yaml.safe_load((EXAMPLES / "gitlab_ci.yml").read_text(encoding="utf-8"))["models"]
        self.run_lines(job["script"], 1)

    def test_hook_looks_at_what_is_committed(self) -> None:
        for line in ("git init -q .", "git config user.email a@example.org",
                     "git config user.name a", f"cp {EXAMPLES}/pre_commit .git/hooks/pre-commit",
                     "echo 'key: [' > other.yaml", "git add models other.yaml",
                     "git commit -qm 'a model'"):
            self.shell(line)
        # Larger than what a pipe holds.
        self.shell("yes '# a comment' | head -n 20000 >> models/crank.yaml")
        self.shell("sed -i 's/frame, rocker/frame, rockr/' models/crank.yaml")
        self.shell("git commit -q --allow-empty -m 'nothing of it'")
        self.assertIn("E0312", self.shell("git commit -qam 'a mistake'", 1))


if __name__ == "__main__":
    unittest.main()
