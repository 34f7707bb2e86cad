"""Mutations of valid mechanism files, as trees and not as bytes.

The originals are the mechanisms of the library; inserted words come from the schema.
"""

from __future__ import annotations

import json
import random
import re
import sys
from pathlib import Path
from typing import Any, Callable, Iterator

from program import ROOT

sys.path.insert(0, str(ROOT / "tests" / "differential"))
from mechanism_file import MechanismFile  # noqa: E402

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
NUMBERS = ("0", "-1", "1e-300", "1e300", "1e16", "1e-16", "1e60", "-1e9", ".nan", ".inf", "1/0",
           "0/0", "sqrt(-1)", "2147483648", "18446744073709551616", "0.1+0.2-0.3")
UNITS = ("mm", "m", "deg", "rad", "N", "N*m", "rpm", "s", "kg", "W", "m/s", "%")

SEARCHES = {"crank_rocker_search", "ravigneaux_search", "year_train"}

Node = tuple[Any, Any]  # a list or mapping, and the key or index in it


def schema_words() -> tuple[list[str], list[str]]:
    """The keys and the examples of values that the schema has."""
    keys: set[str] = set()
    values: set[str] = set()

    def walk(node: Any) -> None:
        if isinstance(node, dict):
            keys.update(node.get("properties", {}) if isinstance(node.get("properties"), dict)
                        else ())
            for name in ("enum", "examples"):
                listed = node.get(name)
                values.update(str(one) for one in listed if isinstance(one, (str, int, float))) \
                    if isinstance(listed, list) else None
        for one in node.values() if isinstance(node, dict) else node if isinstance(node, list) \
                else ():
            walk(one)

    walk(json.loads((ROOT / "schemas" / "mechanism.schema.json").read_text(encoding="utf-8")))
    return sorted(keys), sorted(values)


KEYS, VALUES = schema_words()


def nodes(tree: Any) -> Iterator[Node]:
    for key in list(tree) if isinstance(tree, dict) else range(len(tree)):
        yield tree, key
        if isinstance(tree[key], (dict, list)):
            yield from nodes(tree[key])


def numbers(tree: dict) -> list[Node]:
    return [(parent, key) for parent, key in nodes(tree)
            if isinstance(parent[key], str) and NUMBER.search(parent[key])]


def other_number(tree: dict, chance: random.Random) -> None:
    parent, key = chance.choice(numbers(tree))
    parent[key] = chance.choice(NUMBERS)


def equal_number(tree: dict, chance: random.Random) -> None:
    """The same as another of the file: points that coincide, parameters that cancel."""
    found = numbers(tree)
    (parent, key), (other, its) = chance.choice(found), chance.choice(found)
    parent[key] = other[its]


def scaled_number(tree: dict, chance: random.Random) -> None:
    parent, key = chance.choice(numbers(tree))
    factor = chance.choice(("-1", "1e-9", "1e9", "(1+1e-12)", "1000"))
    parent[key] = f"{factor}*({parent[key]})"


def all_numbers_of_a_list(tree: dict, chance: random.Random) -> None:
    lists = [parent for parent, key in numbers(tree) if isinstance(parent, list)]
    chosen = chance.choice(lists)
    chosen[:] = [chance.choice(("0", chosen[0], "1"))] * len(chosen)


def other_unit(tree: dict, chance: random.Random) -> None:
    parent, key = chance.choice(numbers(tree))
    number = NUMBER.search(parent[key])
    assert number
    parent[key] = f"{number[0]} {chance.choice(UNITS)}"


def removed(tree: dict, chance: random.Random) -> None:
    parent, key = chance.choice([node for node in nodes(tree) if node[1] != "kinestat"])
    del parent[key]


def doubled(tree: dict, chance: random.Random) -> None:
    """An item once more; a coupling, case or body under another name."""
    parent, key = chance.choice(list(nodes(tree)))
    if isinstance(parent, list):
        parent.insert(key, parent[key])
    else:
        parent[f"{key}_2"] = json.loads(json.dumps(parent[key]))


def reversed_list(tree: dict, chance: random.Random) -> None:
    lists = [parent[key] for parent, key in nodes(tree)
             if isinstance(parent[key], list) and len(parent[key]) > 1]
    chance.choice(lists).reverse()


def exchanged(tree: dict, chance: random.Random) -> None:
    """Two values of one kind: bodies of couplings, points, names."""
    found = list(nodes(tree))
    parent, key = chance.choice(found)
    alike = [(other, its) for other, its in found if type(other[its]) is type(parent[key])]
    other, its = chance.choice(alike)
    mine, yours = json.loads(json.dumps([parent[key], other[its]]))
    parent[key], other[its] = yours, mine


def other_word(tree: dict, chance: random.Random) -> None:
    words = [(parent, key) for parent, key in nodes(tree) if isinstance(parent[key], str)]
    parent, key = chance.choice(words)
    parent[key] = chance.choice(VALUES)


def another_key(tree: dict, chance: random.Random) -> None:
    mappings = [tree, *(parent[key] for parent, key in nodes(tree)
                        if isinstance(parent[key], dict))]
    chance.choice(mappings)[chance.choice(KEYS)] = chance.choice(VALUES)


# Most files are to stay well-formed, so that there are numbers to compare.
MILD = [equal_number, scaled_number, all_numbers_of_a_list, reversed_list, exchanged]
CHANGES: list[Callable[[dict, random.Random], None]] = [
    *MILD, *MILD, scaled_number, other_number, other_unit, removed, doubled, other_word,
    another_key]


def seeds() -> list[Path]:
    """Searches of minutes are left out."""
    return [path for path in sorted((ROOT / "mechanisms").rglob("*.yaml"))
            if path.stem not in SEARCHES]


def mutant(seed: int) -> tuple[str, str]:
    """A file with one to three changes, and what was done; the same for the same seed."""
    chance = random.Random(seed)
    path = chance.choice(seeds())
    file = MechanismFile.read(path)
    done = []
    for _ in range(chance.choice((1, 1, 2, 3))):
        change = chance.choice(CHANGES)
        try:
            change(file.tree, chance)
        except IndexError:
            continue  # nothing of that kind in this file
        done.append(change.__name__)
    return file.text(), f"{path.stem}: {', '.join(done)}"
