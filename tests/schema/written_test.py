#!/usr/bin/env python3
"""The schemas in schemas/ are what 'kinestat schema' prints, and describe every key."""

from __future__ import annotations

import argparse
import subprocess
import sys
import unittest
from pathlib import Path
from typing import Any, Iterator

SCHEMAS = Path(__file__).resolve().parents[2] / "schemas"
sys.path[:0] = [str(SCHEMAS.parent / "scripts")]
import check_schemas  # noqa: E402

PROGRAM = Path("kinestat")


def objects(schema: Any, place: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    """The schemas of objects, each with its place."""
    if isinstance(schema, dict):
        if "object" in schema.get("type", ()):
            yield place, schema
        for key, item in schema.items():
            yield from objects(item, f"{place}/{key}")
    elif isinstance(schema, list):
        for i, item in enumerate(schema):
            yield from objects(item, f"{place}/{i}")


def undescribed(schema: Any) -> list[str]:
    """Keys of objects whose meaning is not said in a sentence."""
    return [f"{place}/{key}" for place, one in objects(schema)
            for key, item in one.get("properties", {}).items()
            if not item.get("description", "").endswith(".")]


def left_open(schema: Any) -> list[str]:
    """Objects that may hold a key of any name with any value."""
    return [place for place, one in objects(schema)
            if one.get("additionalProperties", True) in (True, {})]


def schemas_but(*names: str) -> Iterator[tuple[str, Any]]:
    for path in sorted(SCHEMAS.glob("*.schema.json")):
        name = path.name.removesuffix(".schema.json")
        if name not in names:
            yield name, check_schemas.read_strictly(path)


class WrittenTest(unittest.TestCase):
    def test_files_are_as_printed(self) -> None:
        files = sorted(SCHEMAS.glob("*.schema.json"))
        self.assertGreater(len(files), 5)
        for path in files:
            name = path.name.removesuffix(".schema.json")
            printed = subprocess.run([PROGRAM, "schema", name], capture_output=True, check=True)
            self.assertEqual(printed.stdout.decode(), path.read_text(encoding="utf-8"),
                             f"write it anew: kinestat schema {name} > schemas/{path.name}")

    def test_every_key_is_described(self) -> None:
        for name, schema in schemas_but("mechanism"):  # which schema_test.py reads
            self.assertEqual(undescribed(schema), [], name)

    def test_every_object_refuses_unknown_keys(self) -> None:
        for name, schema in schemas_but("mechanism"):  # kept by hand
            self.assertEqual(left_open(schema), [], name)

    def test_a_key_without_a_sentence_and_an_open_object_are_found(self) -> None:
        key = {"type": "number", "description": "Share of the power."}
        closed = {"type": "object", "additionalProperties": False, "properties": {"share": key}}
        cases = {"type": "object", "additionalProperties": closed}
        self.assertEqual((undescribed(cases), left_open(cases)), ([], []))
        for wrong in ({}, {"additionalProperties": True}, {"additionalProperties": {}}):
            self.assertEqual(left_open({"anyOf": [{"type": "object", **wrong}]}), ["/anyOf/0"])
        closed["properties"] = {"share": {"type": "number"}}
        self.assertEqual(undescribed(cases), ["/additionalProperties/share"])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
