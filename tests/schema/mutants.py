"""Small structural changes of a document, as a user would make them by mistake."""

from __future__ import annotations

import copy
import json
import random
from typing import Any, Callable, Iterator

UNKNOWN = ["colour", "att", "typ", "speed", "x-note", "unit", "comment"]
# Keys that stand somewhere in the format, and now in the wrong place.
MISPLACED = ["at", "axis", "bodies", "body", "coupling", "eta", "free", "from", "friction",
             "internal", "members", "motion", "pitch", "report", "teeth", "to", "type", "value"]

Path = tuple[Any, ...]


def paths(value: Any, path: Path = ()) -> Iterator[Path]:
    yield path
    for key in (value if isinstance(value, dict) else
                range(len(value)) if isinstance(value, list) else ()):
        yield from paths(value[key], (*path, key))


def at(value: Any, path: Path) -> Any:
    for key in path:
        value = value[key]
    return value


def single_values(value: Any) -> Iterator[tuple[Path, Any]]:
    """What is neither a list nor a mapping, with its path."""
    for path in paths(value):
        if not isinstance(at(value, path), (list, dict)):
            yield path, at(value, path)


def other_types(value: Any) -> list[Any]:
    """What another type of single value makes of it, quoted numbers and words among them."""
    quoted = [] if isinstance(value, str) or value is None else [json.dumps(value)]
    others = [True, False, 1, 1.5, None, *quoted]
    return [one for one in others if (type(one), one) != (type(value), value)]


def replaced(document: Any, path: Path, value: Any) -> Any:
    """A copy with another value there."""
    changed = copy.deepcopy(document)
    at(changed, path[:-1])[path[-1]] = value
    return changed


def misspelt(word: str, chance: random.Random) -> str:
    i = chance.randrange(len(word))
    return chance.choice([word[:i] + word[i + 1:], word[:i] + word[i] + word[i:],
                          word[:i] + word[i:i + 2][::-1] + word[i + 2:], word.capitalize()])


def other_shape(value: Any, chance: random.Random) -> Any:
    shapes = [None, [value], {"value": value}, [], {}, "word", 3, -1.5, True, 0]
    return chance.choice([shape for shape in shapes if type(shape) is not type(value)])


def drop(parent: Any, key: Any, chance: random.Random) -> str:
    del parent[key]
    return f"without {key}"


def reshape(parent: Any, key: Any, chance: random.Random) -> str:
    parent[key] = other_shape(parent[key], chance)
    return f"{key} is {parent[key]!r}"


def respell(parent: Any, key: Any, chance: random.Random) -> str:
    if isinstance(parent[key], str) and parent[key]:
        parent[key] = misspelt(parent[key], chance)
    elif isinstance(parent, dict) and key:
        rename(parent, key, misspelt(key, chance))
    return f"{key} respelt"


def rename(parent: dict[str, Any], key: str, new: str) -> None:
    items = [(new if name == key else name, item) for name, item in parent.items()]
    parent.clear()
    parent.update(items)


def add(parent: Any, key: Any, chance: random.Random) -> str:
    new = chance.choice(UNKNOWN + MISPLACED)
    if isinstance(parent, dict):
        parent.setdefault(new, copy.deepcopy(parent[key]))
        return f"with {new}"
    parent.append(copy.deepcopy(parent[key]))
    return "one more item"


CHANGES: list[Callable[[Any, Any, random.Random], str]] = [drop, reshape, respell, add]


def mutant(document: Any, chance: random.Random) -> tuple[Any, str]:
    """A changed copy of a document, and what was changed."""
    changed = copy.deepcopy(document)
    path = chance.choice([path for path in paths(document) if path])
    what = chance.choice(CHANGES)(at(changed, path[:-1]), path[-1], chance)
    return changed, f"/{'/'.join(map(str, path[:-1]))}: {what}"
