"""The library of this build: installed into an empty prefix, found there by CMake, pkg-config and
Python, and used by the programs in examples/."""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from library_case import PLANETARY, ROOT, LibraryCase, run

options = argparse.Namespace()


class InstalledLibrary(LibraryCase, unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.cmake = options.cmake
        cls.prefix = Path(tempfile.mkdtemp(prefix="kinestat-library."))
        cls.addClassCleanup(shutil.rmtree, cls.prefix)
        for component in ("library", "development", "python"):
            run([options.cmake, "--install", options.build, "--prefix", cls.prefix,
                 "--component", component])

    def test_shows_the_functions_of_its_header_alone(self) -> None:
        names = {line.split()[-1].split("@")[0] for line in
                 run(["nm", "-D", "--defined-only", self.library()]).splitlines()}
        declared = set()
        for line in ROOT.joinpath("include/kinestat.h").read_text(encoding="utf-8").split("KINESTAT_API")[1:]:
            declared.add(line.split("(")[0].split()[-1].lstrip("*"))
        declared.discard('__attribute__')
        self.assertEqual(names - {"KINESTAT_0"}, {name for name in declared if name.startswith("kinestat_")})

    def test_errors_of_the_examples_have_place_and_status(self) -> None:
        made = self.examples()
        wrong = self.work() / "wrong.yaml"
        wrong.write_text("kinestat: 1\nspace: planar\nground: frame\nbodies: [crank]\n"
                         "couplings:\n  a: {type: revolute, bodies: [frame, crnk], at: [0, 0]}\n", encoding="utf-8")
        done = subprocess.run([made / "report", wrong, "/cases"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 3)
        self.assertIn("wrong.yaml:6:39:", done.stderr)
        done = subprocess.run([made / "teeth_search", PLANETARY, "ring hold", "4"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("ring held", done.stderr)

    @unittest.skipUnless(shutil.which("valgrind"), "without valgrind")
    def test_touches_no_memory_but_its_own_and_loses_none(self) -> None:
        report = self.examples() / "report"
        for place in (("transmissions/ravigneaux.yaml", "/cases/M2/ratio"),
                      ("planar/four_bar.yaml", "/cases/known output/kinematics/order"),
                      ("cables/pulley_rr_chains.yaml", "/cases/block moves/kinematics/order")):
            with self.subTest(place[0]):
                done = subprocess.run(
                    ["valgrind", "--quiet", "--leak-check=full", "--error-exitcode=99", report,
                     ROOT / "mechanisms" / place[0], place[1]],
                    capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn("==", done.stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--cmake", default="cmake")
    options, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
