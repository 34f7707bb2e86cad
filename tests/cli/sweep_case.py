"""What the tests of sweeps share: a train, the program, a folder for each test."""

from __future__ import annotations

import argparse
import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import sanitized  # noqa: E402  (tests/support/sanitized.py)

PROGRAM = Path("kinestat")

# A planetary set whose ring is held: 24 x 4 teeth, two cases.
TRAIN = """
kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {Ns: 24, Np: 18, Nr: Ns + 2*Np, alpha: 20 deg, module: 2, torque: 5 N*m}
ground: housing
bodies: [sun, ring, carrier, planet]
couplings:
  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  b: {type: revolute, bodies: [housing, ring], at: [0, 0]}
  c: {type: revolute, bodies: [housing, carrier], at: [0, 0]}
  d: {type: revolute, bodies: [carrier, planet], at: [0, (Ns + Np)/2*module]}
  e: {type: gear, bodies: [sun, planet], at: [0, Ns/2*module], tangent: x, pressure_angle: alpha}
  f: {type: gear, bodies: [ring, planet], at: [0, Nr/2*module], tangent: x, pressure_angle: alpha,
      internal: true}
actuators:
  motor: {coupling: a}
  wheel: {coupling: c}
  brake: {coupling: b}
cases:
  low: {motion: {motor: 100 rpm, brake: 0}, action: {motor: torque}, input: motor, output: wheel}
  back: {motion: {motor: 100 rpm, wheel: 0}, action: {motor: torque}, input: motor,
         output: brake}
"""

SWEEP = """
sweep:
  vary:
    Ns: {from: 17, to: 40, step: 1}
    Np: {values: [17, 18, 20, 25]}
    torque: {from: 1 N*m, to: 3 N*m, step: 0.5 N*m}
  require: ["mod(Ns + Nr, 3) == 0"]
  report: [ratio, torque_ratio, brake, e.Rc, d.wz]
"""


def program() -> Path:
    return PROGRAM


def has_sanitizers() -> bool:
    return sanitized.has_sanitizers(PROGRAM)


def kinestat(*arguments: object, **options: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(PROGRAM), *map(str, arguments)], capture_output=True, encoding="utf-8", check=False,
        timeout=240, **options,
    )


class InFolder(unittest.TestCase):
    """Each test in a folder of its own."""

    def setUp(self) -> None:
        self.place = tempfile.TemporaryDirectory(prefix="kinestat-sweep-")
        self.addCleanup(self.place.cleanup)
        self.folder = Path(self.place.name)

    def write(self, text: str, name: str = "train.yaml") -> Path:
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def new_folder(self, name: str) -> Path:
        path = self.folder / name
        path.mkdir()
        return path

    def rows(self, text: str, *options: str) -> list[dict[str, str]]:
        done = kinestat("sweep", *options, self.write(text))
        self.assertEqual(done.returncode, 0, done.stderr)
        return list(csv.DictReader(done.stdout.splitlines()))


def main(description: str | None) -> None:
    """Runs the tests of the file that is run."""
    global PROGRAM
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", type=Path, required=True)
    known, rest = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
