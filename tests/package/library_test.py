"""The library of this build: installed into an empty prefix, found there by CMake and pkg-config,
and used by the programs in examples/ and from Python."""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLANETARY = ROOT / "lib/run/starters/planetary.yaml"
options = argparse.Namespace()


def run(words: list[str], **more: object) -> str:
    done = subprocess.run(words, capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        raise AssertionError(f"{words}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class InstalledLibrary(unittest.TestCase):
    prefix: Path
    folder: Path

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = Path(tempfile.mkdtemp(prefix="kinestat-library."))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.prefix = cls.folder / "prefix"
        run([options.cmake, "--install", str(options.build), "--prefix", str(cls.prefix),
             "--component", "library"])

    def library(self) -> Path:
        return next(self.prefix.glob("lib*/**/libkinestat.so"))

    def test_shows_the_functions_of_its_header_alone(self) -> None:
        names = {line.split()[-1].split("@")[0] for line in
                 run(["nm", "-D", "--defined-only", str(self.library())]).splitlines()}
        declared = set()
        for line in ROOT.joinpath("include/kinestat.h").read_text(encoding="utf-8").split("KINESTAT_API")[1:]:
            declared.add(line.split("(")[0].split()[-1].lstrip("*"))
        declared.discard('__attribute__')
        self.assertEqual(names - {"KINESTAT_0"}, {name for name in declared if name.startswith("kinestat_")})

    def test_is_found_by_cmake(self) -> None:
        made = self.folder / "by_cmake"
        run([options.cmake, "-S", str(ROOT / "examples"), "-B", str(made),
             f"-DCMAKE_PREFIX_PATH={self.prefix}"])
        run([options.cmake, "--build", str(made)])
        # Willis: 1 + Nr/Ns with Nr = Ns + 2 Np, here 1 + 60/24.
        self.assertEqual(run([str(made / "report"), str(PLANETARY), "/cases/ring held/ratio"]),
                         "/cases/ring held/ratio = 3.5\n")
        found = run([str(made / "teeth_search"), str(PLANETARY), "ring held", "4.5"])
        # The ratio is 2 + 2 Np/Ns; several sets have it.
        sun, planet = re.fullmatch(
            r"4096 sets tried; nearest: Ns = (\d+), Np = (\d+), ratio 4\.5\n", found).groups()
        self.assertEqual(2 + 2 * int(planet) / int(sun), 4.5)

    def test_errors_of_the_examples_have_place_and_status(self) -> None:
        made = self.folder / "of_errors"
        run([options.cmake, "-S", str(ROOT / "examples"), "-B", str(made),
             f"-DCMAKE_PREFIX_PATH={self.prefix}"])
        run([options.cmake, "--build", str(made)])
        wrong = self.folder / "wrong.yaml"
        wrong.write_text("kinestat: 1\nspace: planar\nground: frame\nbodies: [crank]\n"
                         "couplings:\n  a: {type: revolute, bodies: [frame, crnk], at: [0, 0]}\n", encoding="utf-8")
        done = subprocess.run([str(made / "report"), str(wrong), "/cases"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 3)
        self.assertIn("wrong.yaml:6:39:", done.stderr)
        done = subprocess.run([str(made / "teeth_search"), str(PLANETARY), "ring hold", "4"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("ring held", done.stderr)

    @unittest.skipUnless(shutil.which("pkg-config"), "without pkg-config")
    def test_is_found_by_pkg_config(self) -> None:
        found = next(self.prefix.glob("lib*/**/kinestat.pc"))
        words = run(["pkg-config", "--cflags", "--libs", "kinestat"],
                    env={**os.environ, "PKG_CONFIG_PATH": str(found.parent)}).split()
        program = self.folder / "by_pkg_config"
        run(["cc", str(ROOT / "examples/report.c"), "-std=c99", "-Wall", "-Wextra", "-pedantic",
             "-Werror", *words, f"-Wl,-rpath,{self.library().parent}", "-o", str(program)])
        self.assertEqual(run([str(program), str(PLANETARY), "/cases/sun held/ratio"]),
                         "/cases/sun held/ratio = 1.4\n")

    def test_python_finds_it_beside_itself(self) -> None:
        packages = next(self.prefix.glob("lib/python3/dist-packages"))
        words = "import kinestat, sys; print(kinestat.load(sys.argv[1]).analyze()['/cases/sun held/ratio'])"
        others = {k: v for k, v in os.environ.items() if k != "KINESTAT_LIBRARY"}
        found = run([sys.executable, "-B", "-c", words, str(PLANETARY)],
                    env={**others, "PYTHONPATH": str(packages),
                         "LD_LIBRARY_PATH": str(self.library().parent)})
        self.assertAlmostEqual(float(found), 1 + 24 / 60, delta=1e-12)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--cmake", default="cmake")
    options, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
