#!/usr/bin/env python3
"""The schema of mechanism files and the program's reader accept and refuse the same files.

What the reader accepts, the schema accepts. What the reader refuses for its shape (E0301 to E0305),
the schema refuses, but for the exceptions below. What is wrong in its meaning only, the schema may
accept: it knows no names, dimensions or mechanics.

Files: valid/, invalid/ and reader_only/ (which the schema accepts, each saying why in its first
line), all of mechanisms/ and tests/cli/, and mutants of the valid ones: some at random, and of every
single value those with a truth value, a number, nothing or quotes in its place.
"""

from __future__ import annotations

import argparse
import json
import random
import re
import subprocess
import sys
import unittest
from functools import lru_cache
from pathlib import Path
from typing import Any, Iterator

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "scripts")]
import jsonschema  # noqa: E402
import yaml  # noqa: E402

import as_read  # noqa: E402
import mutants  # noqa: E402
import schema_walk as walk  # noqa: E402
from reader import Finding, Verdict, check  # noqa: E402

PROGRAM = Path("kinestat")
MUTANTS = 2000
SEED = 20080517

# What the reader refuses for its shape and the schema lets pass: pattern of the message, reason.
EXCEPTIONS = [
    (r"the planar order cannot hold .*", "follows from the screws of the mechanism"),
    (r"drive '.*' ends where it begins", "compares two values, which may be expressions"),
    (r"the step of '.*' leads away from 'to'", "compares two values, which may be expressions"),
    (r"the step of '.*' is zero", "the value of an expression; a bare 0 is refused"),
    (r"the sweep has .* states; at most .*", "multiplies the numbers of values"),
    (r"the lists of angles make .* tasks; at most .*", "multiplies the numbers of angles"),
    (r"the task .* has \d+ positions?; a dyad takes two to five", "adds the orders of positions"),
    (r"'.*' is chosen in tasks of five positions, and this is P.*", "adds the orders of positions"),
    (r"\d+ digits are for tasks of five positions, and this has \d", "adds the orders of positions"),
    (r"a selection works with \d+ digits, and \d+ are asked for", "looks at digits and ranges"),
    (r"(circle|centre) points are free with three and four positions, and this has \d",
     "adds the orders of positions"),
    (r"dyad \d gives both points, and \d positions leave only one of them free",
     "adds the orders of positions"),
    (r"five positions have dyads of their own, and none can be given",
     "adds the orders of positions"),
    (r"both dyads are given, and '.*' has nothing to choose", "looks at dyads and ranges"),
    (r"'class' of 'limits' is that of a four-bar, .*", "looks at limits and linkage"),
    (r"'.*' of dyad \d is not on the (curve|line) .*", "follows from the positions"),
    (r"dyad \d lacks the key '.*', for which the two positions .*", "follows from the positions"),
    (r"the positions .* leave open what belongs to '.*' of dyad \d", "follows from the positions"),
    (r"'vary' names '.*' and needs '.*' for '.*: true'", "looks at positions and ranges"),
    (r"mesh '.*' needs a carrier: its member '.*' is fixed to the ground", "follows references"),
    (r"mesh '.*' needs a carrier: its planet '.*' turns on '.*', not on the ground",
     "follows references"),
    (r"mesh '.*' has no teeth to find its loss from", "follows references"),
    (r"parameter '.*' of 'vary' lacks the key 'step'", "looks at 'sample' of the sweep, too"),
    (r"body '.*' has a mass, on which gravity acts, but no centre of mass", "looks at 'gravity' too"),
    (r"'gears' lacks the key 'module'", "looks at members and meshes, where it may be instead"),
    (r"planet '.*' has no distance from the main axis", "follows references"),
    (r"mesh '.*' between two planets lacks the key 'module'", "follows references"),
    (r"'.*' cannot be both .* and .*", "compares names in two lists"),
    (r"'.*' is neither a clutch nor a brake", "looks for the type of a coupling by its name"),
    (r"'(pressure|helix|transmission)_angle' of .* cannot be .*",
     "depends on the file's unit of angle"),
    (r".* cannot be (?!'|-?[\d.]+(e[-+]?\d+)?$).*", "the value of an expression"),
    (r"a published value lacks the key 'tolerance'", "the value of an expression"),
    (r"a number of the friction of .* is negative", "the value of an expression"),
    (r"the stiffness '.*' of .* is not positive", "the value of an expression"),
    (r"no normal force acts in .*", "compares the friction with the actions of the coupling"),
    (r"'.*' of the friction of .* has no effect: .*",
     "compares the friction with the actions of the coupling"),
    (r"the friction of .* has a radius of zero", "the value of an expression"),
    (r"the speed ratios of '.*' do not rise", "compares values, which may be expressions"),
    (r"the characteristic of '.*' has \d+ speed ratios and \d+ values of '.*'",
     "compares the lengths of two lists"),
    (r"nothing supports the difference of the torques of '.*'", "looks beside the characteristic"),
    (r"the characteristic of '.*' has a stator and no torque ratio",
     "looks beside the characteristic"),
    (r"torque converter '.*' would generate power at .*", "the values of expressions"),
    (r"the torque of '.*' is given at no speed", "the value of an expression"),
    (r"by their radii the bodies of .*", "the value of an expression"),
    (r"drive \d of 'motion' lacks the key 'to'", "looks beside the list of drives"),
    (r"'ramp' is of law trapezoid alone", "looks at the word of another key"),
    (r"'ramp' of .* is more than half of the time", "the value of an expression"),
    (r"'inertia' of body '.*' is not written like this in three-dimensional space",
     "knows a tensor by its rows"),
    (r"a radius of cam '.*' is zero", "the value of an expression"),
    (r"'ends' of curve '.*' is of between: cubic alone", "looks at the word of another key"),
    (r"drive '.*' cannot follow curve '.*', .*", "looks at the curve"),
    (r"body '.*' has a mass, which accelerations act on, but no centre of mass",
     "looks at 'cases' too"),
    (r"spring '.*' has no point on body '.*'", "compares names in two places"),
    (r"spring '.*' says in two ways where it has no force", "looks at three keys"),
    (r"spring '.*' has a force as drawn and no stiffness", "the value of an expression"),
    (r"machine '.*' of 'reacts' slides", "follows references"),
    (r"'.*' is of a whole motion, and the file has no section 'motion'", "looks at the words of names"),
    (r"'torque' of 'limits' needs the key 'input_action' of 'shift'", "looks outside 'limits'"),
]


def is_exception(finding: Finding, value: Any) -> bool:
    if finding.code == "E0301":
        return isinstance(value.get("kinestat"), float) and value["kinestat"] == 1  # to a schema 1
    return any(re.fullmatch(pattern, finding.message) for pattern, _ in EXCEPTIONS)


@lru_cache(maxsize=None)
def files(folder: str) -> dict[str, str]:
    found = sorted((HERE / folder).glob("*.yaml"))
    return {path.stem: path.read_text("utf-8") for path in found}


def other_files() -> dict[str, str]:
    found = [*(ROOT / "mechanisms").rglob("*.yaml"), *(ROOT / "tests" / "cli").glob("*/*.yaml")]
    texts = {}
    for path in sorted(found):
        try:
            texts[str(path.relative_to(ROOT))] = path.read_bytes().decode("utf-8")
        except UnicodeDecodeError:
            continue  # refused before anyone reads YAML
    return texts


def columns(command: str, section: str, path: Path) -> list[str]:
    """As a report names them, but for those that count rows and tell how each went."""
    done = subprocess.run([PROGRAM, command, "--format", "json", path], capture_output=True,
                          check=False)
    named = [f"{one['element']}/{one['quantity']}" if one["element"] else one["quantity"]
             for one in json.loads(done.stdout)[section]["columns"]]
    return [name for name in dict.fromkeys(named) if name not in ("step", "status", "time")]


def code_of(text: str) -> str:
    """The code that a file says it shows: "# E0304: …"."""
    return text[2:7]


def accepts(value: Any) -> bool:
    return walk.accepts(walk.SCHEMA, value)


def complaints(value: Any) -> list[jsonschema.ValidationError]:
    return list(walk.validator(walk.SCHEMA).iter_errors(value))


def disagreement(verdict: Verdict, value: Any) -> str:
    """What is wrong between reader and schema; empty if nothing."""
    if not verdict.errors:
        wrong = complaints(value)
        return "" if not wrong else f"the schema refuses it: {shown(wrong[0])}"
    shape = [one for one in verdict.structural if not is_exception(one, value)]
    if shape and accepts(value):
        return "the schema accepts it, the reader says: " + "; ".join(
            f"{one.code} {one.message}" for one in shape)
    return ""


def shown(error: jsonschema.ValidationError) -> str:
    return f"/{'/'.join(map(str, error.absolute_path))}: {error.message[:200]}"


class Agreement(unittest.TestCase):
    maxDiff = None

    def for_each(self, folder: str) -> Iterator[tuple[str, Verdict, Any]]:
        texts = files(folder)
        self.assertNotEqual(texts, {})
        for (name, text), verdict in zip(texts.items(), check(PROGRAM, list(texts.values()))):
            with self.subTest(f"{folder}/{name}"):
                yield text, verdict, as_read.read(text)

    def test_valid_files_are_valid_for_both(self) -> None:
        for _, verdict, value in self.for_each("valid"):
            self.assertEqual(verdict.errors, [])
            self.assertEqual([shown(one) for one in complaints(value)], [])

    def test_invalid_files_are_invalid_for_both(self) -> None:
        for text, verdict, value in self.for_each("invalid"):
            self.assertIn(code_of(text), [one.code for one in verdict.structural])
            self.assertFalse(accepts(value), verdict.errors)

    def test_what_only_the_reader_refuses(self) -> None:
        messages = []
        for text, verdict, value in self.for_each("reader_only"):
            self.assertEqual([code_of(text)], [one.code for one in verdict.structural])
            self.assertEqual([shown(one) for one in complaints(value)], [])
            messages.append(verdict.structural[0].message)
        for pattern, _ in EXCEPTIONS:
            self.assertTrue(any(re.fullmatch(pattern, one) for one in messages), pattern)

    def test_all_other_files_of_the_project(self) -> None:
        texts = other_files()
        for name, verdict in zip(texts, check(PROGRAM, list(texts.values()))):
            if any(one.code < "E0300" for one in verdict.errors):
                continue  # no YAML
            with self.subTest(name):
                try:
                    value = as_read.read(texts[name])
                except yaml.YAMLError:
                    continue  # tabs where Python's reader takes none
                self.assertEqual(disagreement(verdict, value), "")

    def test_every_column_of_a_table_may_be_asked_for(self) -> None:
        asked = []
        for path in sorted((ROOT / "mechanisms").rglob("*.yaml")):
            document = as_read.read(path.read_text("utf-8"))
            for command, section in (("motion", "motion"), ("simulate", "simulation")):
                if section in document:
                    document[section]["report"] = columns(command, section, path)
                    asked.append((path.name, document))
        self.assertGreater(sum("/" in name for _, one in asked for section in ("motion", "simulation")
                               for name in one.get(section, {}).get("report", [])), 300)
        texts = [json.dumps(value, ensure_ascii=False) for _, value in asked]
        for (name, value), verdict in zip(asked, check(PROGRAM, texts)):
            with self.subTest(name):
                self.assertEqual(verdict.errors, [])
                self.assertEqual([shown(one) for one in complaints(value)], [])

    def test_mutants_of_the_valid_files(self) -> None:
        changed = list(self.mutants())
        texts = [json.dumps(value, ensure_ascii=False) for _, value in changed]
        refused = 0
        for (what, value), verdict in zip(changed, check(PROGRAM, texts)):
            refused += bool(verdict.structural)
            found = disagreement(verdict, value)
            if found:
                with self.subTest(what):
                    self.fail(f"{found}\n{json.dumps(value, ensure_ascii=False)}")
        self.assertGreater(refused, MUTANTS // 3, "most mutants must be wrong in their shape")

    def test_values_of_another_type_in_every_place(self) -> None:
        changed = list(self.retyped())
        self.assertGreater(len(changed), 1500)
        texts = [json.dumps(value, ensure_ascii=False) for _, value in changed]
        for (what, value), verdict in zip(changed, check(PROGRAM, texts)):
            found = disagreement(verdict, value)
            if found:
                with self.subTest(what):
                    self.fail(f"{found}\n{json.dumps(value, ensure_ascii=False)}")

    @staticmethod
    def retyped() -> Iterator[tuple[str, Any]]:
        """Of places that differ only in the numbers of items, the first."""
        seen = set()
        for name, text in files("valid").items():
            document = as_read.read(text)
            for path, value in mutants.single_values(document):
                place = tuple("*" if isinstance(key, int) else key for key in path)
                if (place, type(value)) in seen:
                    continue
                seen.add((place, type(value)))
                for other in mutants.other_types(value):
                    yield (f"{name} /{'/'.join(map(str, path))} is {other!r}",
                           mutants.replaced(document, path, other))

    @staticmethod
    def mutants() -> Iterator[tuple[str, Any]]:
        chance = random.Random(SEED)
        names = list(files("valid"))
        documents = {name: as_read.read(files("valid")[name]) for name in names}
        for i in range(MUTANTS):
            name = names[i % len(names)]
            value, what = mutants.mutant(documents[name], chance)
            yield f"{name} {what}", value


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
