"""setup.sh, with a package system that only writes down what it is asked."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "setup.sh"
TOOLS = ("bash", "env", "grep", "cat", "mktemp", "rm")
ALL_THERE = 'shift 2; printf "installed %s\\n" "$@"'
NO_COMPILER = 'shift 2; for p; do [ "$p" = g++ ] || echo "installed $p"; done; exit 1'


class Setup(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for tool in TOOLS:
            (self.folder / tool).symlink_to(shutil.which(tool) or tool)

    def fake(self, name: str, body: str) -> None:
        path = self.folder / name
        path.write_text(f"#!/bin/bash\n{body}\n", encoding="utf-8")
        path.chmod(0o755)

    def fake_debian(self, query: str, user: int = 0, install: str = "true") -> None:
        self.fake("dpkg-query", query)
        self.fake("id", f"echo {user}")
        self.fake("apt-get", f'echo "$DEBIAN_FRONTEND $*" >>"{self.folder}/log"; {install}')

    def run_setup(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [SCRIPT, *arguments], env={"PATH": str(self.folder), "TMPDIR": os.fspath(self.folder)},
            capture_output=True, text=True, check=False,
        )

    def asked(self) -> str:
        log = self.folder / "log"
        return log.read_text(encoding="utf-8") if log.exists() else ""

    def test_does_nothing_when_all_is_there(self) -> None:
        self.fake_debian(ALL_THERE)
        done = self.run_setup("build", "sanitize", "bench")
        self.assertEqual((done.returncode, done.stdout + done.stderr, self.asked()), (0, "", ""))

    def test_installs_what_is_missing(self) -> None:
        self.fake_debian(NO_COMPILER)
        self.assertEqual(self.run_setup("build").returncode, 0)
        self.assertEqual(
            self.asked(),
            "noninteractive update\nnoninteractive install -y --no-install-recommends g++\n",
        )

    def test_uses_sudo_when_not_root(self) -> None:
        self.fake_debian(NO_COMPILER, user=1000)
        self.fake("sudo", 'echo sudo >>"${0%/*}/log"; exec "$@"')
        self.assertEqual(self.run_setup("build").returncode, 0)
        self.assertTrue(self.asked().startswith("sudo\nnoninteractive update\n"))

    def test_says_what_root_has_to_do(self) -> None:
        self.fake_debian(NO_COMPILER, user=1000)
        done = self.run_setup("build")
        self.assertEqual(done.returncode, 4)
        self.assertIn("as root: apt-get install --no-install-recommends g++", done.stderr)

    def test_shows_why_an_installation_failed(self) -> None:
        self.fake_debian(NO_COMPILER, install="echo no space >&2; exit 100")
        done = self.run_setup("build")
        self.assertEqual(done.returncode, 4)
        self.assertIn("no space\nsetup.sh: could not install g++", done.stderr)

    def test_names_the_libraries_on_another_system(self) -> None:
        done = self.run_setup("build")
        self.assertEqual(done.returncode, 4)
        self.assertIn("libeigen3-dev", done.stderr)

    def fake_npm(self, install: str = "true") -> None:
        self.fake("npm", f'[ "$1" = root ] && echo "{self.folder}/modules" && exit; '
                         f'echo "npm $*" >>"{self.folder}/log"; {install}')

    def test_takes_the_checker_of_accessibility_from_npm(self) -> None:
        self.fake_debian(ALL_THERE)
        self.fake_npm()
        self.assertEqual(self.run_setup("browser").returncode, 0)
        self.assertRegex(self.asked(), r"^npm install --global .*axe-core\n$")
        (self.folder / "log").unlink()
        checker = self.folder / "modules/axe-core/axe.min.js"
        checker.parent.mkdir(parents=True)
        checker.touch()
        self.assertEqual(self.run_setup("browser").returncode, 0)
        self.assertEqual(self.asked(), "")

    def test_does_without_the_checker_where_npm_has_none(self) -> None:
        self.fake_debian(ALL_THERE)
        self.assertEqual(self.run_setup("browser").returncode, 0)  # no npm
        self.fake_npm(install="exit 1")
        done = self.run_setup("browser")
        self.assertEqual(done.returncode, 0)
        self.assertIn("tests of accessibility are skipped", done.stderr)
        (self.folder / "log").unlink()
        self.assertEqual(self.run_setup("build").returncode, 0)
        self.assertEqual(self.asked(), "")

    def test_refuses_an_unknown_part(self) -> None:
        self.assertEqual(self.run_setup("everything").returncode, 2)


if __name__ == "__main__":
    unittest.main()
