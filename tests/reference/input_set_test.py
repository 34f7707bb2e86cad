#!/usr/bin/env python3
"""Tries every set of known motions and actions of the pulleys of davies.json.

The sets that determine all the rest are the cobases of the column matroids of M_N and A_N
(Alves 2023, section 3.4): each must be solved, each other set of this size refused.

Usage: input_set_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import itertools
import json
import sys
import tempfile
import unittest
from pathlib import Path

import program
from reference_case import CASES, ReferenceCase

PULLEYS = ("alves_davies_maxima_1_2_10", "alves_davies_matroid_3_6_10", "alves_davies_slanted")


class InputSets(unittest.TestCase):
    def motion_label(self, model: ReferenceCase, column: str) -> str:
        kind, coupling = column.split("_")
        return f"{coupling}.{kind}"

    def action_label(self, model: ReferenceCase, column: str) -> str:
        """U and V are the forces along x and y, T the couples; some are those of actuators."""
        kind, coupling = column.split("_")
        active = [a["name"] for a in model.couplings[coupling].get("active", [])]
        name = {"U": "Rx", "V": "Ry", "T": "Tz"}[kind]
        return f"{coupling}.{kind + coupling if kind + coupling in active else name}"

    @staticmethod
    def shown(label: str) -> str:
        """Freedoms with their axes; the action of an actuator has the actuator's name alone."""
        coupling, _, name = label.partition(".")
        whole = {"v": "vy", "w": "wz"}.get(name, name)
        return f"{coupling}_{name}" if name[1:] == coupling else f"{coupling}.{whole}"

    def statuses(self, texts: list[str]) -> list[tuple[int, list[str]]]:
        """Exit status and codes of each file; all are analysed by one call."""
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(folder) / f"{i}.yaml" for i in range(len(texts))]
            for path, text in zip(paths, texts):
                path.write_text(text, encoding="utf-8")
            done = program.call("analyze", "--diagnostics", "json", *map(str, paths))
        answers = [json.loads(line) for line in done.stderr.splitlines()]
        self.assertEqual(len(answers), len(texts))
        return [(a["status"], [d["code"] for d in a["diagnostics"]]) for a in answers]

    def check(self, name: str, side: str) -> None:
        model = ReferenceCase(CASES[name])
        columns = model.expected[f"{side}_column_order"]
        cobases = {tuple(pair) for pair in model.expected[f"{side}_cobases"]}
        self.assertEqual(len(cobases), model.expected[f"n_{side}_cobases"])
        label, line, refusal = {
            "kin": (self.motion_label, model.motion, (3, ["E0502"])),
            "stat": (self.action_label, model.actions, (5, ["E0602"])),
        }[side]
        pairs = list(itertools.combinations(range(len(columns)), 2))
        known = [{label(model, columns[pair[0]]): "1", label(model, columns[pair[1]]): "2.7"}
                 for pair in pairs]
        answers = self.statuses([model.text(line("test", one)) for one in known])
        for pair, one, answer in zip(pairs, known, answers):
            self.assertEqual(answer, (0, []) if pair in cobases else refusal, f"{name} {one}")

    def test_are_what_the_command_lists(self) -> None:
        for name in PULLEYS:
            model = ReferenceCase(CASES[name])
            text = model.text(model.motion("test", {}))
            report = program.run("inputs", "--limit", "1000", "-", text=text)["inputs"]
            for side, key, label in (("kin", "motion", self.motion_label),
                                     ("stat", "action", self.action_label)):
                columns = [self.shown(label(model, column))
                           for column in model.expected[f"{side}_column_order"]]
                wanted = {frozenset(columns[i] for i in pair)
                          for pair in model.expected[f"{side}_cobases"]}
                groups = report[key]["groups"]
                self.assertEqual(len(groups), 1)
                listed = {frozenset(one["magnitudes"]) for one in groups[0]["sets"]}
                self.assertEqual(listed, wanted)
                self.assertEqual(report[key]["count"], model.expected[f"n_{side}_cobases"])
                ranks = [one["conditioning"] for one in groups[0]["sets"]]
                self.assertTrue(all(0.0 < rank <= 1.0 for rank in ranks))
                self.assertTrue(all(b <= a * (1 + 1e-8) for a, b in zip(ranks, ranks[1:])))

    def test_known_motions(self) -> None:
        for name in PULLEYS:
            self.check(name, "kin")

    def test_known_actions(self) -> None:
        for name in PULLEYS:
            self.check(name, "stat")


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
