#!/usr/bin/env python3
"""Gives the bodies of every mechanism of the library random masses and its cases accelerations.

Usage: dynamics_library_test.py PROGRAM LIBRARY [unittest arguments]

Equilibrium with the forces of inertia and virtual power on the drives must say the same of every
case, and without masses a case with inertia must be the case without.
"""

from __future__ import annotations

import json
import random
import sys
import unittest
from pathlib import Path

import yaml

import program

TWO_WAYS = 1e-9
SAME = 1e-9

_library = Path()


class _Loader(yaml.SafeLoader):
    """Reads words as the program does: yes, no, on and off are texts."""


_Loader.yaml_implicit_resolvers = {
    first: [(tag, pattern) for tag, pattern in resolvers
            if tag not in ("tag:yaml.org,2002:bool", "tag:yaml.org,2002:timestamp")]
    for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()}


def files() -> list[Path]:
    return sorted(_library.glob("*/*.yaml"))


def random_inertia(chance: random.Random, planar: bool) -> dict:
    """Of a box: no moment exceeds the sum of the others."""
    a, b, c = (chance.uniform(0.01, 0.1) for _ in range(3))
    return {
        "mass": f"{chance.uniform(0.5, 3)} kg",
        "centre_of_mass": [f"{chance.uniform(-0.1, 0.1)} m" for _ in range(2 if planar else 3)],
        "inertia": f"{a + b} kg*m^2" if planar else [f"{x} kg*m^2" for x in (b + c, c + a, a + b)],
    }


def with_inertia(text: str, chance: random.Random, massive: bool) -> str | None:
    """Empty where no case knows motions, or the file has no case."""
    model = yaml.load(text, _Loader)
    cases = model.get("cases") or {}
    known = [case for case in cases.values() if case and case.get("motion")]
    if not known or "bodies" not in model:
        return None
    planar = model.get("space") == "planar"
    bodies = model["bodies"]
    if isinstance(bodies, list):
        bodies = {name: None for name in bodies}
    if massive:
        bodies = {name: {**(value or {}), **random_inertia(chance, planar)}
                  for name, value in bodies.items()}
    model["bodies"] = bodies
    for case in known:
        case["acceleration"] = {}
        case.setdefault("action", {})
    for section in ("published", "shift", "duty", "sweep", "motion"):
        model.pop(section, None)
    return json.dumps(model)


class LibraryDynamicsTest(unittest.TestCase):
    def solved(self, text: str) -> dict:
        return program.report(program.call("analyze", "-", text=text)).get("cases", {})

    def test_two_ways_to_the_drives(self) -> None:
        held = 0
        for file in files():
            text = with_inertia(file.read_text(encoding="utf-8"), random.Random(file.name), True)
            for label, one in self.solved(text).items() if text else ():
                two_ways = one.get("dynamics", {}).get("two_ways")
                if two_ways is None:
                    continue
                with self.subTest(file.name, case=label):
                    self.assertLessEqual(two_ways, TWO_WAYS)
                    held += 1
        self.assertGreater(held, 30)

    def test_without_masses_it_is_statics(self) -> None:
        held = 0
        for file in files():
            text = file.read_text(encoding="utf-8")
            light = with_inertia(text, random.Random(0), False)
            if not light or "mass:" in text:
                continue
            before = self.solved(text)
            for label, one in self.solved(light).items():
                actions = before.get(label, {}).get("statics", {}).get("actions", {})
                if "dynamics" not in one or not actions:
                    continue
                largest = max((abs(x) for x in actions.values() if x is not None), default=0.0)
                with self.subTest(file.name, case=label):
                    for name, value in one["statics"]["actions"].items():
                        expected = actions[name]
                        self.assertEqual(value is None, expected is None, name)
                        if value is not None:
                            self.assertLessEqual(abs(value - expected), SAME * largest, name)
                    held += 1
        self.assertGreater(held, 20)


if __name__ == "__main__":
    program.use(sys.argv[1])
    _library = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
