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


def undescribed(schema: Any, place: str = "") -> Iterator[str]:
    """Keys of objects without a description."""
    if isinstance(schema, dict):
        for key, item in schema.get("properties", {}).items():
            if isinstance(item, dict) and not item.get("description"):
                yield f"{place}/{key}"
        for key, item in schema.items():
            yield from undescribed(item, f"{place}/{key}")


class WrittenTest(unittest.TestCase):
    def test_files_are_as_printed(self) -> None:
        files = sorted(SCHEMAS.glob("*.schema.json"))
        self.assertGreater(len(files), 5)
        for path in files:
            name = path.name.removesuffix(".schema.json")
            printed = subprocess.run([PROGRAM, "schema", name], capture_output=True, check=True)
            self.assertEqual(printed.stdout.decode(), path.read_text(encoding="utf-8"),
                             f"write it anew: kinestat schema {name} > schemas/{path.name}")

    def test_reports_describe_every_key(self) -> None:
        for name in ("report", "synthesis"):
            schema = check_schemas.read_strictly(SCHEMAS / f"{name}.schema.json")
            self.assertEqual(list(undescribed(schema)), [], name)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
