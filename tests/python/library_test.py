"""How the shared library is found, and that it is the one of the header."""

from __future__ import annotations

import ctypes.util
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import kinestat

from python_case import Case, ROOT


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
        for place in ("a/b/kinestat", "a/lib", "a/lib64", "lib", "a/build/release/lib"):
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
