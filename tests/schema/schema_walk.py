"""Finds the parts of a draft-07 schema that apply to the parts of a document."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Iterator

import jsonschema

from check_schemas import read_strictly

SCHEMA_PATH = Path(__file__).resolve().parents[2] / "schemas" / "mechanism.schema.json"
SCHEMA = read_strictly(SCHEMA_PATH)
# These only count the components of points and vectors: what they are is said elsewhere.
OVERLAYS = ("planar_components", "spatial_components")
Schema = dict[str, Any]


def resolve(schema: Any) -> Any:
    """The schema that a chain of $ref ends in; what stands beside $ref is for readers only."""
    while isinstance(schema, dict) and "$ref" in schema:
        found: Any = SCHEMA
        for part in schema["$ref"].removeprefix("#/").split("/"):
            found = found[part]
        schema = found
    return schema


VALIDATORS: dict[int, jsonschema.Draft7Validator] = {}


def validator(schema: Any) -> jsonschema.Draft7Validator:
    """The validator of the schema or of a part of it, made once."""
    if id(schema) not in VALIDATORS:
        whole = {"definitions": SCHEMA["definitions"], "allOf": [schema]}
        VALIDATORS[id(schema)] = jsonschema.Draft7Validator(whole)
    return VALIDATORS[id(schema)]


def accepts(schema: Any, value: Any) -> bool:
    return validator(schema).is_valid(value)


def is_overlay(schema: Any) -> bool:
    return schema.get("$ref", "").rpartition("/")[2] in OVERLAYS


def applicable(schema: Any, value: Any, overlays: bool = False) -> Iterator[Schema]:
    """The schema and all that it applies to the same value: allOf, anyOf, then, else."""
    if not isinstance(schema, dict) or (is_overlay(schema) and not overlays):
        return
    schema = resolve(schema)
    if not isinstance(schema, dict):
        return
    yield schema
    branches = [*schema.get("allOf", []), *schema.get("anyOf", [])]
    if "if" in schema:
        branches.append(schema.get("then" if accepts(schema["if"], value) else "else", {}))
    for branch in branches:
        yield from applicable(branch, value, overlays)


def children(schemas: list[Schema], value: Any) -> Iterator[tuple[Any, list[Any]]]:
    """The keys or indices of a value, each with the schemas of what stands there."""
    if isinstance(value, list):
        for i in range(len(value)):
            yield i, [one["items"] for one in schemas if "items" in one]
    elif isinstance(value, dict):
        for key in value:
            below = []
            for one in schemas:
                if key in one.get("properties", {}):
                    below.append(one["properties"][key])
                elif isinstance(one.get("additionalProperties"), dict):
                    below.append(one["additionalProperties"])
            yield key, below


Place = tuple[Any, ...]


def places(value: Any, schemas: list[Any] | None = None,
           path: Place = ()) -> Iterator[tuple[Place, Any, list[Schema]]]:
    """Every part of a document: its path, its value and the schemas that apply to it."""
    found = [part for one in (schemas or [SCHEMA]) for part in applicable(one, value)]
    yield path, value, found
    for key, below in children(found, value):
        child = value[key]
        if below:
            yield from places(child, below, (*path, key))


def is_closed(schemas: list[Schema]) -> bool:
    """Whether a mapping may have certain keys only."""
    return any(one.get("additionalProperties") is False for one in schemas)


def keys(schemas: list[Schema]) -> set[str]:
    """The keys that a closed mapping may have."""
    allowed: set[str] = set()
    refused: set[str] = set()
    for one in schemas:
        for key, schema in one.get("properties", {}).items():
            (refused if schema is False else allowed).add(key)
    return allowed - refused


def declared(schemas: list[Schema]) -> set[str]:
    """Likewise with those that others rule out."""
    return {key for one in schemas for key in one.get("properties", {})}


def words(schemas: list[Schema]) -> list[str]:
    return [word for one in schemas for word in one.get("enum", [])]
