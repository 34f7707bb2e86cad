#!/usr/bin/env python3
"""Checks the library against itself, changed in ways that must not matter.

Usage: metamorphic_test.py PROGRAM MECHANISMS [unittest arguments]

Other units, another origin, another order, reversed couplings: the same values within the bounds
that the reports give, the same findings and the same exit status.
"""

from __future__ import annotations

import itertools
import json
import subprocess
import sys
import tempfile
import unittest
from functools import lru_cache
from pathlib import Path
from typing import Callable, Iterator

import changes
from batch import Batch, Result
from changes import Factors
from known_defects import sort_out
from mechanism_file import MechanismFile

SHARE = 1e-9
ROUNDINGS = 1e-12
program = ""
library = Path()


def bound_of(*sides: dict) -> float:
    """The digits that are promised, or the bounds where they are of the numbers as typed."""
    evidence = [side.get("evidence", {}) for side in sides]
    if all(one.get("refers_to") == "numbers as typed" for one in evidence):
        return sum(one["error_bound"] for one in evidence) + 1e-15
    return SHARE


def compare_values(what: str, actual: dict, expected: dict, factor: Callable[[str], float],
                   share: float) -> Iterator[str]:
    """Where larger ones cancel, roundings of the largest may be left."""
    if actual.keys() != expected.keys():
        yield f"{what} has {sorted(actual.keys() ^ expected.keys())} only once"
    largest = max((abs(v * factor(n)) for n, v in expected.items() if v is not None), default=0.0)
    for name in expected.keys() & actual.keys():
        value, true = actual[name], expected[name]
        if value is None or true is None:
            if (value is None) != (true is None):
                yield f"{what} {name} is {value}, was {true}"
        elif abs(value - true * factor(name)) > share * abs(value) + ROUNDINGS * largest:
            yield f"{what} {name} is {value}, was {true}"


def compare_side(what: str, actual: dict | None, expected: dict | None, key: str,
                 factor: Callable[[str], float]) -> Iterator[str]:
    if actual is None or expected is None:
        if (actual is None) != (expected is None):
            yield f"{what} are there only once"
    elif actual["status"] != expected["status"]:
        yield f"{what} are {actual['status']}, were {expected['status']}"
    else:
        yield from compare_values(what, actual.get(key, {}), expected.get(key, {}), factor,
                                  bound_of(actual, expected))


def numbers_of(tree: dict) -> dict[str, float | None]:
    return {k: v for k, v in tree.items() if isinstance(v, (int, float)) or v is None}


def compare_case(actual: dict, expected: dict, factors: Factors) -> Iterator[str]:
    yield from compare_side("motions", actual.get("kinematics"), expected.get("kinematics"),
                            "freedoms", factors.rate)
    yield from compare_side("actions", actual.get("statics"), expected.get("statics"), "actions",
                            factors.action)
    power, before = actual.get("power") or {}, expected.get("power") or {}
    for key in ("actuators", "loads"):
        yield from compare_values(f"power of {key}", power.get(key, {}), before.get(key, {}),
                                  lambda _: 1.0, SHARE)
    for key in ("efficiency", "recirculation"):
        yield from compare_values(key, numbers_of(power.get(key) or {}),
                                  numbers_of(before.get(key) or {}), lambda _: 1.0, SHARE)
    for key in ("ratio", "torque_ratio"):
        value, true = actual.get(key), expected.get(key)
        # Where only one of the two couplings was reversed, or slides, a ratio changes by that.
        if (value is None) != (true is None):
            yield f"{key} is {value}, was {true}"
        elif value is not None and factors.slide == 1.0:
            if abs(abs(value) - abs(true)) > SHARE * abs(true):
                yield f"{key} is {value}, was {true}"


def compare_mobility(actual: dict, expected: dict) -> Iterator[str]:
    for order in ("minimal", "planar", "spatial"):
        if actual.get(order) != expected.get(order):
            yield f"{order} counts are {actual.get(order)}, were {expected.get(order)}"


def compare_shift(actual: dict, expected: dict) -> Iterator[str]:
    states, before = actual.get("states", {}), expected.get("states", {})
    if states.keys() != before.keys():
        yield f"states {sorted(states.keys() ^ before.keys())} only once"
    for name in states.keys() & before.keys():
        one, two = states[name], before[name]
        if one["class"] != two["class"]:
            yield f"{name} is {one['class']}, was {two['class']}"
        for key in ("ratio", "torque_ratio", "recirculation", "step"):
            values = ({key: one.get(key)}, {key: two.get(key)})
            if all(isinstance(v[key], (int, float)) or v[key] is None for v in values):
                yield from compare_values(f"{name}", *(
                    {k: v and abs(v) for k, v in one.items()} for one in values),
                    lambda _: 1.0, SHARE)


def compare_motion(actual: dict, expected: dict) -> Iterator[str]:
    for key in ("status", "steps"):
        if actual.get(key) != expected.get(key):
            yield f"motion's {key} is {actual.get(key)}, was {expected.get(key)}"
    events = [[(e["kind"], e["element"]) for e in motion.get("events", [])]
              for motion in (actual, expected)]
    if events[0] != events[1]:
        yield f"events are {events[0]}, were {events[1]}"
    words = [[row[-1] for row in motion.get("rows", [])] for motion in (actual, expected)]
    if words[0] != words[1]:
        yield "statuses of rows differ"


def compare_results(actual: Result, expected: Result, factors: Factors) -> Iterator[str]:
    if actual.status != expected.status:
        yield f"exit status is {actual.status}, was {expected.status}: {actual.codes()}"
    if actual.codes() != expected.codes():
        yield f"findings are {actual.codes()}, were {expected.codes()}"
    report, before = actual.report, expected.report
    if bool(report) != bool(before):
        yield f"no report: {[f['message'] for f in actual.findings][:2]}"
        return
    yield from compare_mobility(report.get("mobility", {}), before.get("mobility", {}))
    cases, cases_before = report.get("cases", {}), before.get("cases", {})
    if cases.keys() != cases_before.keys():
        yield f"cases {sorted(cases.keys() ^ cases_before.keys())} only once"
    for label in cases.keys() & cases_before.keys():
        for text in compare_case(cases[label], cases_before[label], factors):
            yield f"{label}: {text}"
    yield from compare_shift(report.get("shift") or {}, before.get("shift") or {})
    yield from compare_motion(report.get("motion") or {}, before.get("motion") or {})


def output_of(command: str, style: str, text: str) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "file.yaml"
        path.write_text(text, encoding="utf-8")
        return subprocess.run([program, command, "--format", style, path], capture_output=True,
                              check=False).stdout


# Of a file as it is, for which several tests ask.
plain_output_of = lru_cache(maxsize=None)(output_of)


class MetamorphicTest(unittest.TestCase):
    files: dict[str, Path]
    plain: dict[str, Result]

    @classmethod
    def setUpClass(cls) -> None:
        cls.files = {"_".join(path.relative_to(library).with_suffix("").parts): path
                     for path in sorted(library.glob("**/*.yaml"))}
        cls.plain = cls.analysed({name: MechanismFile.read(path).text()
                                  for name, path in cls.files.items()})

    @staticmethod
    def analysed(texts: dict[str, str]) -> dict[str, Result]:
        batch = Batch(program, texts)
        try:
            return batch.run("analyze")
        finally:
            batch.close()

    def check(self, change: Callable[[MechanismFile], Factors | None], least: int) -> None:
        """At least so many files can be changed like that."""
        texts, factors = {}, {}
        for name, path in self.files.items():
            file = MechanismFile.read(path)
            changed = change(file)
            if changed is not None:
                texts[name], factors[name] = file.text(), changed
        self.assertGreaterEqual(len(texts), least)
        results = self.analysed(texts)
        complaints = [f"{name}: {text}" for name in texts
                      for text in compare_results(results[name], self.plain[name], factors[name])]
        said = sort_out(self.id().rsplit(".", 1)[1], complaints, True)
        if said:
            self.fail("\n".join([f"{len(said)} complaints", *said[:60]]))

    def differences(self, folder: Path, name: str, changed: dict) -> str:
        """What `kinestat compare` says of the two reports."""
        paths = [folder / f"{name}.{side}.json" for side in ("as_it_is", "changed")]
        for path, report in zip(paths, (self.plain[name].report, changed)):
            path.write_text(json.dumps(report), encoding="utf-8")
        done = subprocess.run([program, "compare", "--rtol", str(SHARE), *paths],
                              capture_output=True, text=True, check=False)
        return "" if done.returncode == 0 else done.stdout + done.stderr

    def check_compare(self, unit: str, least: int) -> None:
        """Loads, motions and gears included."""
        texts = {}
        for name, path in self.files.items():
            file = MechanismFile.read(path)
            if changes.other_units(unit)(file) is not None and self.plain[name].report:
                changes.radians(file)
                texts[name] = file.text()
        self.assertGreaterEqual(len(texts), least)
        results = self.analysed(texts)
        with tempfile.TemporaryDirectory() as folder:
            complaints = [f"{name}: {text}" for name, result in results.items()
                          if (text := self.differences(Path(folder), name, result.report))]
        said = sort_out(self.id().rsplit(".", 1)[1], complaints, True)
        if said:
            self.fail("\n".join([f"{len(said)} complaints", *said]))

    def test_compare_finds_no_difference_in_metres_and_radians(self) -> None:
        self.check_compare("m", 25)

    def test_compare_finds_no_difference_of_studies_in_metres(self) -> None:
        """Rates of a motion are for one unit of its first freedom, whatever that is."""
        self.check_studies(changes.other_units("m"), 280)

    def test_compare_finds_no_difference_of_studies_in_other_units_throughout(self) -> None:
        """Tensions, torques, powers and speeds among them."""
        self.check_studies(changes.units_throughout("in"), 360)

    def check_studies(self, change: Callable[[MechanismFile], Factors | None], least: int) -> None:
        """At least so many reports are compared."""
        commands = ("mobility", "inputs", "sensitivity", "tolerance", "shift", "motion",
                    "simulate")
        count = 0
        with tempfile.TemporaryDirectory() as folder:
            for name, path in self.files.items():
                file = MechanismFile.read(path)
                texts = [file.text()]
                if change(file) is None:
                    continue
                texts.append(file.text())
                for command, style in itertools.product(commands, ("json", "csv")):
                    with self.subTest(file=name, command=command, style=style):
                        count += self.compare_outputs(Path(folder), command, style, texts)
        self.assertGreaterEqual(count, least)

    def compare_outputs(self, folder: Path, command: str, style: str, texts: list[str]) -> int:
        """0 where the command has no answer."""
        paths = []
        for ask, text in zip((plain_output_of, output_of), texts, strict=True):
            output = ask(command, style, text)
            if not output:
                return 0
            paths.append(folder / f"{len(paths)}.{style}")
            paths[-1].write_bytes(output)
        done = subprocess.run([program, "compare", "--rtol", "1e-7", *paths],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return 1

    def test_compare_finds_no_difference_between_tasks_in_other_units(self) -> None:
        """Slider-cranks among them, whose drives have lengths for coordinates, and curves."""
        count = 0
        paths = sorted(path for path in (library / "synthesis").glob("*.yaml")
                       if "transmission:" not in path.read_text("utf-8"))  # ratios have no units
        for path, units in itertools.product(paths, (("mm", False), ("in", True))):
            with self.subTest(path.stem, units=units), tempfile.TemporaryDirectory() as folder:
                texts = [self.task_in(path, *units) for units in (("m", False), units)]
                for style in ("json", "csv"):
                    count += self.compare_outputs(Path(folder), "synthesize", style, texts)
        self.assertGreaterEqual(count, 80)

    @staticmethod
    def task_in(path: Path, length: str, other_angle: bool) -> str:
        file = MechanismFile.read(path)
        changes.units_of_task(file, length, other_angle)
        return file.text()

    def test_compare_finds_no_difference_in_inches_and_radians(self) -> None:
        self.check_compare("in", 45)

    def test_the_order_of_bodies_and_couplings_does_not_matter(self) -> None:
        self.check(changes.other_order, 50)

    def test_reversed_couplings_change_signs_alone(self) -> None:
        self.check(changes.reversed_couplings, 40)

    def test_the_origin_less_than_a_size_away_does_not_matter(self) -> None:
        """Where screws are still written about the origin of the world."""
        self.check(changes.moved_origin(0.77), 45)

    def test_the_origin_ten_sizes_away_does_not_matter(self) -> None:
        self.check(changes.moved_origin(10), 45)

    def test_the_origin_a_thousand_sizes_away_does_not_matter(self) -> None:
        self.check(changes.moved_origin(1e3), 45)

    def test_the_origin_a_million_sizes_away_does_not_matter(self) -> None:
        self.check(changes.moved_origin(1e6), 45)

    def test_the_origin_a_hundred_million_sizes_away_does_not_matter(self) -> None:
        self.check(changes.moved_origin(1e8), 45)

    def test_inches_do_not_matter(self) -> None:
        self.check(changes.other_units("in"), 45)

    def test_metres_do_not_matter(self) -> None:
        self.check(changes.other_units("m"), 25)

    def test_millimetres_do_not_matter(self) -> None:
        self.check(changes.other_units("mm"), 5)


if __name__ == "__main__":
    program, library = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
