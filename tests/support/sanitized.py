"""What tests of a program with sanitizers leave out: a run takes twenty times as long, and finds what
sanitizers find wherever code runs once. The release build tries everything."""

from __future__ import annotations

import json
import re
from functools import lru_cache
from pathlib import Path
from typing import Any, Iterator, Sequence, TypeVar

ROOT = Path(__file__).resolve().parents[2]
SCHEMA = ROOT / "schemas" / "mechanism.schema.json"


EACH = 20  # of many alike, each so many-th

T = TypeVar("T")


@lru_cache(maxsize=None)
def has_sanitizers(program: Path) -> bool:
    return b"__asan_init" in program.read_bytes()


def few(program: Path, alike: Sequence[T]) -> Sequence[T]:
    """All; with sanitizers a few of what takes the same ways through the program."""
    return alike[::EACH] if has_sanitizers(program) else alike


def _words(schema: Any) -> Iterator[str]:
    """Keys, and words that stand for themselves."""
    if isinstance(schema, dict):
        yield from schema.get("properties", {})
        yield from (one for one in [*schema.get("enum", []), schema.get("const")]
                    if isinstance(one, str))
    for part in schema.values() if isinstance(schema, dict) else schema:
        if isinstance(part, (dict, list)):
            yield from _words(part)


def sample(program: Path, files: list[Path]) -> list[Path]:
    """All files; with sanitizers a few in which every word of the format occurs that occurs in all."""
    if not has_sanitizers(program):
        return files
    words = set(_words(json.loads(SCHEMA.read_text(encoding="utf-8"))))
    texts = {path: path.read_text(encoding="utf-8") for path in files}
    found = {path: words.intersection(re.findall(r"[\w-]+", re.sub("#.*", "", text)))
             for path, text in texts.items()}
    left, chosen = set().union(*found.values()), []
    while left:
        chosen.append(max(files, key=lambda path: (len(found[path] & left), -len(texts[path]))))
        left -= found[chosen[-1]]
    return sorted(chosen)
