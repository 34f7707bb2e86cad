"""mutants.py: what it changes, and that seed and number decide it."""

from __future__ import annotations

import itertools
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import check_layers  # noqa: E402
import mutants  # noqa: E402


class Mutants(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.some = list(itertools.islice(mutants.mutants(7), 300))

    def test_are_those_of_their_seed_and_number(self) -> None:
        again = list(itertools.islice(mutants.mutants(7), 300))
        self.assertEqual(again, self.some)
        self.assertEqual([one.number for one in self.some], list(range(300)))
        self.assertNotEqual(list(itertools.islice(mutants.mutants(8), 300)), self.some)

    def test_are_of_every_module_in_turn(self) -> None:
        for module in mutants.MODULES:
            its = [one for one in self.some if one.module == module]
            self.assertEqual(len(its), 300 // len(mutants.MODULES))
            for one in its:
                self.assertTrue(one.file.startswith(f"lib/{module}/"), one.file)

    def test_change_code_and_neither_words_nor_comments(self) -> None:
        for one in self.some:
            code = check_layers.without_strings(one.text)
            self.assertEqual(code[one.start:one.end], check_layers.without_strings(one.before),
                             one.told())
            self.assertTrue(code[one.start:one.end].strip(), one.told())
            self.assertNotEqual(one.source, one.text)
            changed = check_layers.without_strings(one.source)
            self.assertNotEqual(changed, code, one.told())

    def test_are_of_every_kind(self) -> None:
        kinds = {kind for kind, *_ in mutants.CHANGES}
        sites = (site for module in mutants.MODULES for site in mutants.sites(module))
        self.assertEqual({kind for *_, kind, _ in sites}, kinds)

    def test_leave_out_what_no_test_can_tell(self) -> None:
        for one in self.some:
            line = one.text.splitlines()[one.line - 1].strip()
            self.assertFalse(line.startswith(("#", "static_assert", "template", "using")), line)


class Score(unittest.TestCase):
    def test_counts_what_compiles(self) -> None:
        row = {"seed": 1, "module": "math", "date": "2026-01-02", "labels": "golden|cli"}
        rows = [row | {"number": 0, "outcome": "killed", "by": "unit_math"},
                row | {"number": 6, "outcome": "killed", "by": "golden.x"},
                row | {"number": 12, "outcome": "survived", "by": ""},
                row | {"number": 18, "outcome": "does not compile", "by": ""}]
        text = mutants.table(rows)
        self.assertIn("| `math` | 3 | 2 (67 %) | 1 | 1 |", text)
        self.assertIn("| `network` | 0 | 0 | 0 | 0 |", text)
        self.assertIn("| all | 3 | 2 (67 %) | 1 | 1 |", text)
        self.assertIn("2026-01-02, seed 1, 4 numbers of 0 to 18; 1 did not compile", text)
        self.assertIn("they were judged: 3 by golden, cli.", text)


if __name__ == "__main__":
    unittest.main()
