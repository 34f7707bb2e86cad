"""What the tests of an installed library share: programs and Python find it, and it answers."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLANETARY = ROOT / "lib/run/starters/planetary.yaml"


def run(words: list[str | Path], **more: object) -> str:
    done = subprocess.run(words, capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        raise AssertionError(f"{words}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class LibraryCase:
    """Mixed into a TestCase, which installs."""

    prefix: Path
    cmake: str

    def work(self) -> Path:
        folder = Path(tempfile.mkdtemp(prefix="kinestat-library."))
        self.addCleanup(shutil.rmtree, folder)
        return folder

    def library(self) -> Path:
        return next(self.prefix.glob("lib*/**/libkinestat.so"))

    def examples(self) -> Path:
        """The programs among the installed examples, built by CMake."""
        made = self.work()
        run([self.cmake, "-S", next(self.prefix.glob("share/doc/*/examples")), "-B", made,
             f"-DCMAKE_PREFIX_PATH={self.prefix}"])
        run([self.cmake, "--build", made])
        return made

    def test_is_found_by_cmake(self) -> None:
        made = self.examples()
        # Willis: 1 + Nr/Ns with Nr = Ns + 2 Np, here 1 + 60/24.
        self.assertEqual(run([made / "report", PLANETARY, "/cases/ring held/ratio"]),
                         "/cases/ring held/ratio = 3.5\n")
        found = run([made / "teeth_search", PLANETARY, "ring held", "4.5"])
        # The ratio is 2 + 2 Np/Ns; several sets have it.
        sun, planet = re.fullmatch(
            r"4096 sets tried; nearest: Ns = (\d+), Np = (\d+), ratio 4\.5\n", found).groups()
        self.assertEqual(2 + 2 * int(planet) / int(sun), 4.5)

    @unittest.skipUnless(shutil.which("pkg-config"), "without pkg-config")
    def test_is_found_by_pkg_config(self) -> None:
        found = next(self.prefix.glob("lib*/**/kinestat.pc"))
        words = shlex.split(run(["pkg-config", "--cflags", "--libs", "kinestat"],
                                env={**os.environ, "PKG_CONFIG_PATH": str(found.parent)}))
        program = self.work() / "by_pkg_config"
        run(["cc", next(self.prefix.glob("share/doc/*/examples/report.c")), "-std=c99", "-Wall",
             "-Wextra", "-pedantic", "-Werror", *words, f"-Wl,-rpath,{self.library().parent}",
             "-o", program])
        self.assertEqual(run([program, PLANETARY, "/cases/sun held/ratio"]),
                         "/cases/sun held/ratio = 1.4\n")

    def test_python_finds_it_beside_itself(self) -> None:
        words = ("import kinestat, sys; "
                 "print(kinestat.load(sys.argv[1]).analyze()['/cases/sun held/ratio'])")
        others = {key: value for key, value in os.environ.items() if key != "KINESTAT_LIBRARY"}
        found = run([sys.executable, "-B", "-c", words, PLANETARY],
                    env={**others, "PYTHONPATH": str(self.prefix / "lib/python3/dist-packages")})
        self.assertAlmostEqual(float(found), 1 + 24 / 60, delta=1e-12)
