#!/usr/bin/env python3
"""Checks the JSON Schemas of schemas/, and reports against schemas/report.schema.json.

Usage: check_schemas.py [REPORT]...   Prints one line per fault; exit status 1 if there is any.
JSON is read strictly: no NaN or infinity (including overflow), no -0.0, no duplicate keys.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import jsonschema

SCHEMAS = Path(__file__).resolve().parents[1] / "schemas"
DRAFT = "http://json-schema.org/draft-07/schema"
NOTHING_TO_CHECK = 77


def refuse(token: str) -> Any:
    raise ValueError(f"{token} is not allowed")


def strict_float(token: str) -> float:
    value = float(token)
    if value in (float("inf"), float("-inf")) or (value == 0 and token.startswith("-")):
        refuse(token)
    return value


def strict_int(token: str) -> int:
    return refuse(token) if token == "-0" else int(token)


def unique_keys(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    keys = [key for key, _ in pairs]
    for key in keys:
        if keys.count(key) > 1:
            raise ValueError(f"the key '{key}' occurs twice")
    return dict(pairs)


def read_strictly(path: Path) -> Any:
    """The JSON value of a file; ValueError says what is wrong with it."""
    return json.loads(
        path.read_bytes().decode("utf-8"), parse_float=strict_float, parse_int=strict_int,
        parse_constant=refuse, object_pairs_hook=unique_keys,
    )


def pointer(error: jsonschema.ValidationError | jsonschema.SchemaError) -> str:
    return "".join(f"/{part}" for part in error.absolute_path) or "/"


def schema_faults(schema: Any) -> list[str]:
    if not isinstance(schema, dict) or schema.get("$schema", "").rstrip("#") != DRAFT:
        return [f'"$schema" is not {DRAFT}#']
    meta = jsonschema.Draft7Validator(jsonschema.Draft7Validator.META_SCHEMA)
    return [f"{pointer(error)}: {error.message}" for error in meta.iter_errors(schema)]


def report_faults(report: Any, schema: Any) -> list[str]:
    errors = jsonschema.Draft7Validator(schema).iter_errors(report)
    ordered = sorted(errors, key=lambda error: [str(part) for part in error.absolute_path])
    return [f"{pointer(error)}: {error.message[:300]}" for error in ordered]


def check(path: Path, schema: Any = None) -> list[str]:
    """Faults of a schema, or of a report when its schema is given."""
    try:
        value = read_strictly(path)
    except (OSError, ValueError) as error:
        return [f"{path}: {error}"]
    found = schema_faults(value) if schema is None else report_faults(value, schema)
    return [f"{path}: {fault}" for fault in found]


def main(reports: list[Path]) -> int:
    schemas = sorted(SCHEMAS.glob("*.schema.json"))
    if not schemas and not reports:
        print("no schemas yet")
        return NOTHING_TO_CHECK
    faults = [fault for path in schemas for fault in check(path)]
    if reports and not faults:
        schema = read_strictly(SCHEMAS / "report.schema.json")
        faults = [fault for path in reports for fault in check(path, schema)]
    print("\n".join(faults) or f"{len(schemas)} schemas and {len(reports)} reports are valid")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main([Path(argument) for argument in sys.argv[1:]]))
