#!/usr/bin/env python3
"""Checks motions of the library against themselves, changed in ways that must not matter.

Usage: metamorphic_motion_test.py PROGRAM MECHANISMS [unittest arguments]

Another order, reversed couplings, another origin: the same value in every row. Another number of
steps: the same extremes, and means that differ by what their trapezoids may.
"""

from __future__ import annotations

import re
import sys
import unittest
from pathlib import Path
from typing import Callable, Iterator

import changes
from batch import Batch, Result
from changes import Factors
from known_defects import sort_out
from mechanism_file import MechanismFile

SHARE = 2e-9      # of the value
ROUNDINGS = 1e-11  # of the largest of its kind
EXTREME = 1e-6    # of the largest of the column
MEAN = 0.02       # likewise
STEPS = (60, 97, 240)
program = ""
library = Path()


def columns_of(motion: dict) -> dict[str, list]:
    """The values of each column, row after row."""
    return {column["name"]: [row[i] for row in motion["rows"]]
            for i, column in enumerate(motion["columns"])
            if column["name"] not in ("closure_error", "step", "status")}


def kinds_of(motion: dict) -> dict[str, tuple[str, str]]:
    return {column["name"]: (column["unit"], column["quantity"].split("/")[0])
            for column in motion["columns"]}


def largest_of(values: list) -> float:
    return max((abs(one) for one in values if isinstance(one, float)), default=0.0)


# What is about the origin, and of the point of a body that its first coupling gives.
ABOUT_ORIGIN = re.compile("/(at|moment)/")
OF_POINT = re.compile("/(at|linear|linear_acceleration)/")


class Change:
    """What is left as it was, but for columns of such names and perhaps for signs."""

    def __init__(self, change: Callable[[MechanismFile], Factors | None],
                 but: re.Pattern = re.compile("$^"), turns: bool = False) -> None:
        self.change, self.but, self.turns = change, but, turns

    def compare(self, actual: dict, expected: dict) -> Iterator[str]:
        found, before = columns_of(actual), columns_of(expected)
        if found.keys() != before.keys():
            yield f"columns {sorted(found.keys() ^ before.keys())} only once"
        largest: dict[tuple[str, str], float] = {}
        kinds = kinds_of(expected)
        for name, values in before.items():
            largest[kinds[name]] = max(largest.get(kinds[name], 0.0), largest_of(values))
        for name in found.keys() & before.keys():
            if self.but.search(name):
                continue
            if len(found[name]) != len(before[name]):
                yield f"{len(found[name])} rows, were {len(before[name])}"
            for row, (x, y) in enumerate(zip(found[name], before[name])):
                if not self.is_same(x, y, largest[kinds[name]]):
                    yield f"{name} of row {row} is {x}, was {y}"
                    break

    def is_same(self, x: float | None, y: float | None, largest: float) -> bool:
        if not isinstance(x, float) or not isinstance(y, float):
            return x == y
        x, y = (abs(x), abs(y)) if self.turns else (x, y)
        return abs(x - y) <= SHARE * abs(y) + ROUNDINGS * largest


def compare_figures(actual: dict, expected: dict) -> Iterator[str]:
    """Of another number of steps."""
    figures, before = actual["figures"], expected["figures"]
    if figures.keys() != before.keys():
        yield f"figures {sorted(figures.keys() ^ before.keys())} only once"
    for name in figures.keys() & before.keys():
        one, two = figures[name], before[name]
        size = largest_of([side.get(key) for side in (one, two) for key in ("least", "greatest")])
        for key in ("least", "greatest", "mean"):
            x, y = one.get(key), two.get(key)
            share = MEAN if key == "mean" else EXTREME
            if (x is None) != (y is None) or (x is not None and abs(x - y) > share * size):
                yield f"{key} of {name} is {x}, was {y}"


class MetamorphicMotionTest(unittest.TestCase):
    texts: dict[str, str]
    plain: dict[str, Result]

    @classmethod
    def setUpClass(cls) -> None:
        paths = {"_".join(path.relative_to(library).with_suffix("").parts): path
                 for path in sorted(library.glob("**/*.yaml"))
                 if re.search("^motion:", path.read_text("utf-8"), re.M)}
        cls.texts = {name: MechanismFile.read(path).text() for name, path in paths.items()}
        cls.paths = paths
        cls.plain = cls.moved(cls.texts)

    @staticmethod
    def moved(texts: dict[str, str], *options: str) -> dict[str, Result]:
        batch = Batch(program, texts)
        try:
            return batch.run("motion", *options)
        finally:
            batch.close()

    def complain(self, complaints: list[str]) -> None:
        said = sort_out(self.id().rsplit(".", 1)[1], complaints, True)
        if said:
            self.fail("\n".join([f"{len(said)} complaints", *said[:60]]))

    def check(self, change: Change, least: int) -> None:
        """At least so many files can be changed like that."""
        texts = {}
        for name, path in self.paths.items():
            file = MechanismFile.read(path)
            # A curve over a freedom that is reversed would have to be, too.
            has_curves = change.turns and "curves" in file.tree
            if not has_curves and change.change(file) is not None and self.plain[name].report:
                texts[name] = file.text()
        self.assertGreaterEqual(len(texts), least)
        results = self.moved(texts)
        self.complain([f"{name}: {text}" for name in texts for text in
                       (change.compare(results[name].report["motion"],
                                       self.plain[name].report["motion"])
                        if results[name].report else ["no report"])])

    def test_the_order_of_bodies_and_couplings_does_not_matter(self) -> None:
        self.check(Change(changes.other_order, but=OF_POINT), 12)

    def test_reversed_couplings_change_signs_alone(self) -> None:
        self.check(Change(changes.reversed_couplings, turns=True), 12)

    def test_the_origin_ten_sizes_away_does_not_matter(self) -> None:
        self.check(Change(changes.moved_origin(10), but=ABOUT_ORIGIN), 12)

    def test_the_origin_a_thousand_sizes_away_does_not_matter(self) -> None:
        self.check(Change(changes.moved_origin(1e3), but=ABOUT_ORIGIN), 12)

    def test_extremes_and_means_do_not_hang_on_the_steps(self) -> None:
        runs = [self.moved(self.texts, "--steps", str(steps)) for steps in STEPS]
        complaints = []
        count = 0
        for name in self.texts:
            motions = [(run[name].report or {}).get("motion") for run in runs]
            if all(motions):
                count += 1
                complaints += [f"{name}: {steps} steps: {text}"
                               for steps, one in zip(STEPS[:-1], motions[:-1])
                               for text in compare_figures(one, motions[-1])]
        self.complain(complaints)
        self.assertGreaterEqual(count, 12)


if __name__ == "__main__":
    program, library = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
