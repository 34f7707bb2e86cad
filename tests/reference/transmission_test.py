#!/usr/bin/env python3
"""Searches for planetary transmissions: their counts, and every gear solved anew in fractions.

Usage: transmission_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import json
import math
import statistics
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path
from typing import Any

import program

TASKS = json.loads(Path(__file__).with_name("transmissions.json").read_text(encoding="utf-8"))["tasks"]
SLOW = 1_000_000  # labelled layouts, of which one run is enough

Row = list[Fraction]


def text_of(task: dict[str, Any], **more: Any) -> str:
    wanted = {**task, "layout": "any", **more}
    return json.dumps({"kinestat": 1, "name": "task", "synthesis": {"transmission": wanted}})


def search(task: dict[str, Any], *options: str, **more: Any) -> dict[str, Any]:
    return program.run("synthesize", *options, "-", text=text_of(task, **more))["transmissions"]


def solve(rows: list[Row]) -> Row:
    """Gauss and Jordan in fractions: the unknowns of equations that end with their right sides."""
    rows = [list(row) for row in rows]
    count = len(rows[0]) - 1
    for k in range(count):
        pivot = next(i for i in range(k, len(rows)) if rows[i][k] != 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [value / rows[k][k] for value in rows[k]]
        for i, row in enumerate(rows):
            if i != k and row[k] != 0:
                rows[i] = [a - row[k] * b for a, b in zip(row, rows[k])]
    return [rows[k][count] for k in range(count)]


class Train:
    """A gear of a listed transmission by speeds of shafts and equilibrium, set by set."""

    def __init__(self, variant: dict[str, Any], engaged: str, ratios: list[Fraction]) -> None:
        self.sets = list(variant["sets"].values())
        self.elements = variant["elements"]
        self.engaged = engaged
        shafts = {"housing", "in", "out"}
        for one in self.sets:
            shafts |= {one["sun"], one["carrier"], one["ring"]}
        for one in self.elements.values():
            shafts |= {one["tail"], one["head"]}
        self.place = {shaft: i for i, shaft in enumerate(sorted(shafts))}
        self.i0 = [-ratio if one["kind"] == "simple" else ratio
                   for ratio, one in zip(ratios, self.sets)]
        self.speeds = dict(zip(self.place, self.find_speeds()))

    def row(self, size: int, *entries: tuple[int, Fraction | int]) -> Row:
        row = [Fraction(0)] * (size + 1)
        for at, value in entries:
            row[at] += value
        return row

    def find_speeds(self) -> Row:
        n, at = len(self.place), self.place
        rows = [self.row(n, (at["housing"], 1)), self.row(n, (at["in"], 1), (n, 1))]
        for one, i0 in zip(self.sets, self.i0):
            rows.append(self.row(n, (at[one["sun"]], 1), (at[one["ring"]], -i0),
                                 (at[one["carrier"]], i0 - 1)))
        for letter in self.engaged:
            pair = self.elements[letter]
            rows.append(self.row(n, (at[pair["head"]], 1), (at[pair["tail"]], -1)))
        return solve(rows)

    def rolls(self, one: dict[str, Any]) -> Fraction:
        return self.speeds[one["sun"]] - self.speeds[one["carrier"]]

    def torques(self, i0: list[Fraction]) -> tuple[Row, dict[str, Fraction], Fraction]:
        """Of suns, of elements (tail on head) and of the output, by that of the input. `i0` are
        the ratios of torques."""
        sets, n = len(self.sets), len(self.place)
        count = sets + len(self.engaged) + 2  # and of what holds housing and output
        columns: list[Row] = [[Fraction(0)] * n for _ in range(count)]
        for column, one, ratio in zip(columns, self.sets, i0):
            column[self.place[one["sun"]]] += 1
            column[self.place[one["ring"]]] -= ratio
            column[self.place[one["carrier"]]] += ratio - 1
        for column, letter in zip(columns[sets:], self.engaged):
            column[self.place[self.elements[letter]["head"]]] += 1
            column[self.place[self.elements[letter]["tail"]]] -= 1
        columns[-2][self.place["housing"]] = Fraction(1)
        columns[-1][self.place["out"]] = Fraction(1)
        right = [Fraction(0)] * n
        right[self.place["in"]] = Fraction(-1)
        values = solve([[column[i] for column in columns] + [right[i]] for i in range(n)])
        return values[:sets], dict(zip(self.engaged, values[sets:])), values[-1]

    def efficiency(self, losses: dict[str, Fraction]) -> Fraction:
        suns, _, _ = self.torques(self.i0)
        lossy = []
        for one, i0, sun in zip(self.sets, self.i0, suns):
            kept = 1 - losses[one["kind"]]
            power = -sun * self.rolls(one)  # `sun` is what the set does to its shaft
            lossy.append(i0 * kept if power > 0 else i0 / kept if power < 0 else i0)
        _, _, output = self.torques(lossy)
        return -output * self.speeds["out"]


class Counts(unittest.TestCase):
    def test_stages_are_those_that_another_program_counts(self) -> None:
        for one in TASKS:
            with self.subTest(one["name"]):
                stages = search(one["task"], "--top", "1")["stages"]
                counts = dict(one["counts"])
                # The other program hands ranges along a ladder in one direction alone.
                self.assertLessEqual(stages["not_refuted"], counts.pop("not_refuted"))
                self.assertGreaterEqual(stages["not_refuted"], stages["found"])
                self.assertEqual({key: stages[key] for key in counts}, counts)

    def test_what_can_be_arranged_is_counted(self) -> None:
        for one in TASKS:
            for layout, count in one.get("buildable", {}).items():
                if one["counts"]["labelled_layouts"] > SLOW:
                    continue
                with self.subTest(one["name"], layout=layout):
                    stages = search(one["task"], "--top", "1", layout=layout)["stages"]
                    self.assertEqual(stages["found"], count)
                    self.assertEqual(stages["not_buildable"], one["counts"]["found"] - count)

    # With small losses the rank is what rolls, times the loss.
    def test_the_best_is_the_one_of_which_least_rolls(self) -> None:
        for one in TASKS:
            with self.subTest(one["name"]):
                loss = 1e-6
                losses = {"simple": loss, "double_planet": loss}
                found = search(one["task"], "--top", "1", losses=losses)
                best = found["groups"]["0"]["variants"]["0"]
                self.assertAlmostEqual(
                    best["rank"] / loss, one["best"]["mean_rolling_power"], delta=2e-5)
                ratios = [gear["ratio"] for gear in best["gears"].values()]
                for ratio, wanted in zip(ratios, one["best"]["ratios"], strict=True):
                    self.assertAlmostEqual(ratio, wanted, delta=1e-8 * abs(wanted))


class Gears(unittest.TestCase):
    LOSSES = {"simple": 0.02, "double_planet": 0.03}

    def check(self, variant: dict[str, Any]) -> None:
        ratios = [Fraction(str(one["stationary_ratio"])) for one in variant["sets"].values()]
        losses = {kind: Fraction(str(loss)) for kind, loss in self.LOSSES.items()}
        for gear in variant["gears"].values():
            train = Train(variant, gear["engaged"], ratios)
            self.close(gear["ratio"], 1 / train.speeds["out"])
            for shaft, speed in gear["speeds"].items():
                self.close(speed, train.speeds[shaft])
            for letter, slip in gear["slips"].items():
                pair = variant["elements"][letter]
                self.close(slip, train.speeds[pair["head"]] - train.speeds[pair["tail"]])
            for (number, one), ratio in zip(variant["sets"].items(), ratios):
                teeth = one["teeth"]
                planet = (Fraction(teeth["sun"], teeth["planet"])
                          if one["kind"] == "double_planet" else 2 / (ratio - 1))
                # Teeth outside each other turn in opposite senses.
                self.close(gear["planet_speeds"][number], -train.rolls(one) * planet)
            _, torques, output = train.torques(train.i0)
            self.assertEqual(output, -1 / train.speeds["out"])
            self.assertEqual(set(gear["torques"]), set(torques))
            for letter, torque in gear["torques"].items():
                self.close(torque, torques[letter])
            self.close(gear["efficiency"], train.efficiency(losses))
        self.check_figures(variant)

    # What the ladder asks as a whole, from its gears.
    def check_figures(self, variant: dict[str, Any]) -> None:
        figures, gears = variant["figures"], variant["gears"].values()
        forward = [gear for gear in gears if gear["ratio"] > 0]
        steps = [math.log(a["ratio"] / b["ratio"]) for a, b in zip(forward, forward[1:])]
        self.close(figures["spread"], forward[0]["ratio"] / forward[-1]["ratio"])
        self.close(figures["mean_efficiency"], statistics.mean(g["efficiency"] for g in forward))
        self.close(figures["least_efficiency"], min(g["efficiency"] for g in gears))
        self.close(figures["unevenness"], statistics.pstdev(steps))
        for figure, key in [("element_torque", "torques"), ("element_slip", "slips"),
                            ("shaft_speed", "speeds"), ("planet_speed", "planet_speeds")]:
            self.close(figures[figure], max(abs(v) for g in gears for v in g[key].values()))
        self.assertEqual(figures["rotating_clutches"], sum(
            one["type"] == "clutch" for one in variant["elements"].values()))

    def close(self, value: float, exact: Fraction) -> None:
        self.assertLessEqual(abs(value - float(exact)), 1e-11 * max(1.0, abs(float(exact))))

    def test_every_listed_gear_is_solved_anew(self) -> None:
        for one in TASKS:
            if one["counts"]["labelled_layouts"] > SLOW:
                continue
            with self.subTest(one["name"]):
                found = search(one["task"], "--top", "12", losses=self.LOSSES)
                for group in found["groups"].values():
                    for variant in group["variants"].values():
                        self.check(variant)


class Mechanisms(unittest.TestCase):
    # A file for every transmission, of which the table of gears has the ladder that was found with
    # the ratios of its teeth.
    def test_written_files_have_the_ladder(self) -> None:
        for one in TASKS[:5]:
            with self.subTest(one["name"]), tempfile.TemporaryDirectory() as folder:
                found = program.run("synthesize", "--top", "3", "--write-mechanism", folder, "-",
                                    text=text_of(one["task"], losses=Gears.LOSSES))["transmissions"]
                for group in found["groups"].values():
                    for variant in group["variants"].values():
                        self.assertTrue(variant["verification"]["agrees"])
                        self.check_file(Path(variant["file"]), variant)

    def check_file(self, path: Path, variant: dict[str, Any]) -> None:
        report = program.run("shift", str(path))
        states = report["shift"]["states"]
        ratios = [Fraction(one["teeth"]["ring"], one["teeth"]["sun"])
                  for one in variant["sets"].values()]
        for label, gear in variant["gears"].items():
            train = Train(variant, gear["engaged"], ratios)
            exact = float(1 / train.speeds["out"])
            self.assertEqual("".join(states[label]["engaged"]), gear["engaged"])
            self.assertLessEqual(abs(states[label]["ratio"] / exact - 1.0), 1e-12)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
