#!/usr/bin/env python3
"""The schema of mechanism files: every key described, with examples; the reader's keys and words.

The reader lists the keys that it knows in the hint of an unknown key, and the words that it takes
in the hint of an unknown word; both are provoked wherever a file of valid/ has a mapping or a word.
"""

from __future__ import annotations

import argparse
import copy
import json
import re
import sys
import unittest
from functools import lru_cache
from pathlib import Path
from typing import Any, Iterator

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "scripts")]
import as_read  # noqa: E402
import schema_walk as walk  # noqa: E402
from reader import check  # noqa: E402

PROGRAM = Path("kinestat")
STRANGE = "zzz"
Place = tuple[Any, ...]


def parts(schema: Any, path: Place = (), owner: Any = None) -> Iterator[tuple[Place, Any, Any]]:
    """Every part of the schema with its path and the schema of the value that it belongs to.

    Conditions are left out, and what only counts components.
    """
    if isinstance(schema, list):
        for i, item in enumerate(schema):
            yield from parts(item, (*path, i), owner)
        return
    if not isinstance(schema, dict) or schema.get("doNotSuggest"):
        return
    owner = owner or schema
    yield path, schema, owner
    for key, item in schema.items():
        if key in ("then", "else", "allOf", "anyOf"):
            yield from parts(item, (*path, key), owner)
        elif key in ("additionalProperties", "items", "propertyNames"):
            yield from parts(item, (*path, key))
        elif key in ("properties", "patternProperties", "definitions"):
            for name, child in item.items():
                if name not in walk.OVERLAYS:
                    yield from parts(child, (*path, key, name))


def properties() -> Iterator[tuple[str, Any]]:
    """Every key of the format, with the schema of its value."""
    for path, schema, _ in parts(walk.SCHEMA):
        for kind in ("properties", "patternProperties"):
            for name, child in schema.get(kind, {}).items():
                if isinstance(child, dict) and not child.get("doNotSuggest"):
                    yield "/".join(map(str, (*path, kind, name))), child


def annotation(schema: Any, key: str) -> Any:
    """The description or examples of a schema, its own or those of what it refers to."""
    while isinstance(schema, dict):
        if key in schema:
            return schema[key]
        for branch in ("then", "else"):
            if key in schema.get(branch, {}):
                return schema[branch][key]
        for branch in schema.get("allOf", []):
            if key in branch:
                return branch[key]
        if "$ref" not in schema:
            return None
        found: Any = walk.SCHEMA
        for part in schema["$ref"].removeprefix("#/").split("/"):
            found = found[part]
        schema = found
    return None


@lru_cache(maxsize=1)
def documents() -> dict[str, Any]:
    found = sorted((HERE / "valid").glob("*.yaml"))
    return {path.stem: as_read.read(path.read_text("utf-8")) for path in found}


@lru_cache(maxsize=1)
def all_places() -> list[tuple[str, Place, Any, list[Any]]]:
    """Every part of the valid files and the schemas that apply to it."""
    return [(name, *place) for name, document in documents().items()
            for place in walk.places(document)]


def changed(name: str, path: Place, value: Any) -> Any:
    """A copy of a valid file with another value at a place."""
    if not path:
        return value
    document = copy.deepcopy(documents()[name])
    parent = document
    for key in path[:-1]:
        parent = parent[key]
    parent[path[-1]] = value
    return document


def hints(changes: list[Any], code: str) -> list[str]:
    """What the reader says to each changed file; empty where it finds no error of that code."""
    verdicts = check(PROGRAM, [json.dumps(one, ensure_ascii=False) for one in changes])
    return [next((one.hint for one in verdict.errors
                  if one.code == code and STRANGE in one.message), "") for verdict in verdicts]


def identities(schemas: list[Any]) -> tuple[int, ...]:
    return tuple(id(one) for one in schemas)


def is_shared(schema: Any) -> bool:
    """Whether it is said elsewhere, as what several types of couplings have."""
    return isinstance(schema, dict) and list(schema) == ["$ref"]


class Text(unittest.TestCase):
    def test_describes_every_property(self) -> None:
        found = list(properties())
        self.assertGreater(len(found), 150)
        for where, schema in found:
            with self.subTest(where):
                text = annotation(schema, "description")
                self.assertRegex(text or "", r"^\S.*\.$")
                self.assertNotRegex(text, r"\s{2}|\bjoint\b|\bloop\b|center")
                self.assertTrue(annotation(schema, "examples"), "no example")

    def test_describes_every_word(self) -> None:
        for path, schema, _ in parts(walk.SCHEMA):
            if "enum" in schema:
                with self.subTest(path):
                    self.assertEqual(len(schema["enum"]), len(schema.get("enumDescriptions", [])))

    def test_examples_and_defaults_are_valid(self) -> None:
        for path, schema, owner in parts(walk.SCHEMA):
            for example in [*schema.get("examples", []), *filter(None, [schema.get("default")])]:
                with self.subTest(path, example=example):
                    errors = [*walk.validator(owner).iter_errors(example),
                              *walk.validator(schema).iter_errors(example)]
                    self.assertEqual([error.message for error in errors], [])

    def test_only_annotations_stand_beside_a_reference(self) -> None:
        for path, schema, _ in parts(walk.SCHEMA):
            if "$ref" in schema:
                with self.subTest(path):
                    annotations = {"description", "examples", "default"}
                    self.assertLessEqual(set(schema), {"$ref", *annotations})

    def test_every_definition_is_used(self) -> None:
        text = json.dumps(walk.SCHEMA)
        for name in walk.SCHEMA["definitions"]:
            self.assertRegex(text, rf'"#/definitions/{name}[/"]')

    def test_knows_what_a_parameter_cannot_be_named(self) -> None:
        pattern = walk.SCHEMA["definitions"]["parameter_name"]["pattern"]
        taken = re.search(r"\(\?!\((.*?)\)\$\)", pattern)[1].split("|")
        free = ["N1", "alpha", "z", "Pi", "sine", "MM", "tooth_count", "e"]
        others = ["J", "Hz", "ft", "grad", "mol", "sinh", "sign", "inf", "nan", "true", "km", "and",
                  "or", "not", "if", "pow", "lcm", "lb", "K", "A", "t", "Pa", "MPa", "dm", "ms"]
        names = taken + free + others

        texts = [json.dumps({"kinestat": 1, "ground": "a", "bodies": [], "couplings": {},
                             "parameters": {name: 1}}) for name in names]
        refused = {name for name, verdict in zip(names, check(PROGRAM, texts))
                   if any(one.code == "E0306" for one in verdict.errors)}

        self.assertEqual({name for name in names if not re.match(pattern, name)}, refused)


class Mechanisms(unittest.TestCase):
    def test_name_the_schema_in_their_first_line(self) -> None:
        for path in sorted((ROOT / "mechanisms").rglob("*.yaml")):
            with self.subTest(path.name):
                first = path.read_text("utf-8").splitlines()[0]
                relative = first.removeprefix("# yaml-language-server: $schema=")
                self.assertEqual((path.parent / relative).resolve(), walk.SCHEMA_PATH)


class Reader(unittest.TestCase):
    maxDiff = None

    def test_knows_the_same_keys_in_every_mapping(self) -> None:
        places = {identities(schemas): (name, path, value, schemas)
                  for name, path, value, schemas in all_places()
                  if isinstance(value, dict) and walk.is_closed(schemas)}
        changes = [changed(name, path, {**value, STRANGE: 1})
                   for name, path, value, _ in places.values()]
        for (name, path, _, schemas), hint in zip(places.values(), hints(changes, "E0302")):
            with self.subTest(f"{name}: /{'/'.join(map(str, path))}"):
                known = re.search(r"known keys are (.*)", hint)
                self.assertIsNotNone(known, hint)
                listed = set(known[1].split(", "))
                self.assertLessEqual(walk.keys(schemas), listed)
                self.assertLessEqual(listed, walk.declared(schemas))

    def test_lists_the_same_keys_for_a_coupling_of_any_type(self) -> None:
        for coupling in walk.SCHEMA["definitions"]["coupling"]["then"]["allOf"]:
            then = walk.resolve(coupling["then"])["properties"]
            kind = coupling["if"]["properties"]["type"]["const"]
            document = {"kinestat": 1, "ground": "a", "bodies": ["b"],
                        "couplings": {"c": {"type": kind, "bodies": ["a", "b"], STRANGE: 1}}}
            with self.subTest(kind):
                listed = hints([document], "E0302")[0].rpartition("known keys are ")[2]
                self.assertEqual(sorted(listed.split(", ")), sorted(then))

    def test_takes_the_same_words(self) -> None:
        places = {identities(schemas): (name, path, schemas)
                  for name, path, value, schemas in all_places()
                  if isinstance(value, str) and walk.words(schemas)}
        changes = [changed(name, path, STRANGE) for name, path, _ in places.values()]
        for (name, path, schemas), hint in zip(places.values(), hints(changes, "E0305")):
            with self.subTest(f"{name}: /{'/'.join(map(str, path))}"):
                if hint.startswith("write x, y, z, -x, … or a vector"):
                    self.assert_taken(name, path, walk.words(schemas))
                    continue
                listed = hint.rpartition("it is one of ")[2].split(", ")
                self.assertEqual(sorted(listed), sorted(walk.words(schemas)))

    def assert_taken(self, name: str, path: Place, words: list[str]) -> None:
        """For directions, whose hint does not list all words."""
        self.assertEqual(words, ["x", "y", "z", "-x", "-y", "-z"])
        texts = [json.dumps(changed(name, path, word)) for word in words]
        for word, verdict in zip(words, check(PROGRAM, texts)):
            self.assertNotIn("E0305", [one.code for one in verdict.errors], word)


class ValidFiles(unittest.TestCase):
    """The files of valid/ show the whole format, so that the other tests see all of it."""

    def test_have_every_mapping_and_key(self) -> None:
        seen = {(id(schema), key) for _, _, value, schemas in all_places()
                if isinstance(value, dict) for schema in schemas for key in value}
        used = {child["$ref"] for schema, key, child in self.keys()
                if (id(schema), key) in seen and is_shared(child)}
        for schema, key, child in self.keys():
            with self.subTest(key, among=list(schema["properties"])):
                self.assertTrue((id(schema), key) in seen or
                                (is_shared(child) and child["$ref"] in used))

    @staticmethod
    def keys() -> Iterator[tuple[Any, str, Any]]:
        """The keys that mappings may have, each with its mapping and its value's schema."""
        for path, schema, _ in parts(walk.SCHEMA):
            for key, child in schema.get("properties", {}).items():
                if child is not False and "coupling_keys" not in path:
                    yield schema, key, child

    def test_have_a_word_of_every_list(self) -> None:
        seen = {id(schema) for _, _, value, schemas in all_places() if isinstance(value, str)
                for schema in schemas}
        for path, schema, _ in parts(walk.SCHEMA):
            if "enum" in schema:
                with self.subTest(path):
                    self.assertIn(id(schema), seen)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known_arguments, others = parser.parse_known_args()
    PROGRAM = known_arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
