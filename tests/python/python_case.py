"""What the tests of the Python package share: models with closed forms, and how values are compared."""

from __future__ import annotations

import math
import os
import tempfile
import unittest
import warnings
from pathlib import Path
from typing import Any

import kinestat

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]
try:
    import pandas
except ImportError:
    pandas = None

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("KINESTAT_PROGRAM", "")
RAVIGNEAUX = ROOT / "mechanisms/transmissions/ravigneaux.yaml"
FOUR_BAR = ROOT / "mechanisms/sweeps/four_bar_height.yaml"
LEVER = """kinestat: 1
space: planar
units: {length: mm, angle: deg}
parameters: {arm: 40 mm, tilt: 30 deg, push: 5 N, count: 2}
ground: frame
bodies: [lever]
couplings:
  a: {type: revolute, bodies: [frame, lever], at: [0, 0]}
actuators: {motor: {coupling: a}}
loads:
  weight: {body: lever, at: [arm*cos(tilt), arm*sin(tilt)], force: [0, -count*push]}
cases:
  held: {motion: {motor: 60 rpm}, input: motor}
"""


def four_bar_ratio(height: float) -> float:
    """By the pole of crank and rocker: mechanisms/sweeps/four_bar_height.yaml."""
    return (6 * height - 3) / (18 - height)


def first_gear(n1: float, n2: float, n5: float, n6: float = 22) -> float:
    """The ratio of M1: sun 1, planet 5, the long planet in two steps, the ring."""
    return (n2 + n6 - n1 - 2 * n5) / n1 * (n2 + 2 * n6) / n6


def ravigneaux(**parameters: Any) -> kinestat.Mechanism:
    """With planets that fit whatever N1, N2 and N5 are."""
    train = kinestat.load(RAVIGNEAUX, N3="N2 + 2*N6jk", N6i="N2 + N6jk - N1 - 2*N5")
    train.parameters.update(parameters)
    return train


class Case(unittest.TestCase):
    def setUp(self) -> None:
        # No warning passes unseen.
        catcher = warnings.catch_warnings()
        catcher.__enter__()
        self.addCleanup(catcher.__exit__, None, None, None)
        warnings.simplefilter("error")

    def assert_near(self, a: float, b: float, relative: float = 1e-12) -> None:
        self.assertTrue(math.isclose(a, b, rel_tol=relative), f"{a} is not {b}")

    def folder(self) -> Path:
        place = tempfile.TemporaryDirectory(prefix="kinestat-python-")
        self.addCleanup(place.cleanup)
        return Path(place.name)
