"""What the JSON Schema of the format says of the keys of a mapping."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import yaml

import markdown

# These only count the components of points and vectors.
_OVERLAYS = ("planar_components", "spatial_components")
_MOST_EXAMPLES = 4
Node = dict[str, Any]


@dataclass
class Key:
    """A key of a mapping: its schema, and whether it must stand."""

    name: str
    node: Node
    needed: bool


@dataclass
class Mapping:
    """The keys of a mapping, and what is said of them together."""

    keys: list[Key]
    notes: list[str] = field(default_factory=list)


class Schema:
    def __init__(self, root: Node):
        self.root = root

    def resolved(self, node: Any) -> Node:
        """With what stands beside a reference in the place of what it leads to."""
        if not isinstance(node, dict):
            return {}
        if "$ref" not in node:
            return node
        found: Any = self.root
        for part in node["$ref"].removeprefix("#/").split("/"):
            found = found[part]
        return {**self.resolved(found), **{k: v for k, v in node.items() if k != "$ref"}}

    def shapes(self, node: Any) -> Iterator[Node]:
        """The node and all that it may apply to the same value."""
        if isinstance(node, dict) and _last(node.get("$ref", "")) in _OVERLAYS:
            return
        node = self.resolved(node)
        yield node
        for branch in [*node.get("allOf", []), *node.get("anyOf", [])]:
            if not _by_type(branch):
                yield from self.shapes(branch)
        for word in ("then", "else"):
            if word in node:
                yield from self.shapes(node[word])

    def mapping(self, node: Any) -> Mapping:
        """The keys of a mapping that has certain keys only."""
        found: dict[str, Any] = {}
        needed: set[str] = set()
        notes: dict[str, None] = {}
        for one in self.shapes(node):
            needed.update(one.get("required", []) if "errorMessage" not in one else [])
            if "errorMessage" in one:
                notes[str(one["errorMessage"])] = None
            for key, others in one.get("dependencies", {}).items():
                if isinstance(others, list):
                    notes[f"'{key}' needs '{', '.join(others)}'."] = None
            for key, value in one.get("properties", {}).items():
                if isinstance(value, dict):
                    found.setdefault(key, value)
        keys = [Key(key, value, key in needed) for key, value in found.items()]
        return Mapping(keys, list(notes))

    def inner(self, node: Any, place: str) -> Iterator[tuple[str, Any]]:
        """Mappings with keys of their own below a value, each with its place: `cases.NAME`."""
        if any(isinstance(value, dict) for one in self.shapes(node)
               for value in one.get("properties", {}).values()):
            yield place, node
            return
        for one in self.shapes(node):
            if "items" in one:
                yield from self.inner(one["items"], f"{place}[]")
            if isinstance(one.get("additionalProperties"), dict):
                yield from self.inner(one["additionalProperties"], f"{place}.NAME")

    def value(self, node: Any) -> str:
        """In words what may stand there; kinds of values are links to their page."""
        name = _last(node.get("$ref", "")) if isinstance(node, dict) else ""
        if name and self.is_value(name):
            return f"[{name.replace('_', ' ')}](value-{name.replace('_', '-')})"
        words = list(dict.fromkeys(self._words(node)))
        return " or ".join(words) if words else "anything"

    def _words(self, node: Any) -> Iterator[str]:
        node = self.resolved(node)
        if "const" in node:
            yield markdown.code(_typed(node["const"]))
        elif "enum" in node:
            yield " or ".join(markdown.code(_typed(word)) for word in node["enum"])
        elif "anyOf" in node and not any("required" in one for one in node["anyOf"]):
            for one in node["anyOf"]:
                yield self.value(one)
        else:
            types = node.get("type", [])
            yield from self._words_of_types([types] if isinstance(types, str) else types, node)

    def _words_of_types(self, types: list[str], node: Node) -> Iterator[str]:
        then, other = self.resolved(node.get("then")), node.get("else")
        if "items" in then or "items" in node:
            inner = self.value(then.get("items", node.get("items")))
            least, most = (then.get(word, node.get(word)) for word in ("minItems", "maxItems"))
            count = f"{least} " if least is not None and least == most else ""
            if other and self.value(other) == inner:
                yield f"{inner}, or several in a list"
                return
            yield f"list of {count}" + ("mappings" if inner == "mapping" else _together(inner))
        elif isinstance(then.get("additionalProperties"), dict):
            inner = self.value(then["additionalProperties"])
            yield "names, each with " + ("keys of its own" if inner == "mapping" else _together(inner))
        elif "properties" in then or "object" in types:
            yield "mapping"
        elif not other and not node.get("allOf"):
            yield from ({"boolean": "`true` or `false`", "string": "text", "null": "nothing"}.get(one, one)
                        for one in types)
        if other:
            yield self.value(other)
        for branch in node.get("allOf", []):
            if "$ref" in branch:
                yield self.value(branch)

    def is_value(self, name: str) -> bool:
        """Whether a definition is a kind of value, rather than a mapping with keys."""
        node = self.root["definitions"].get(name, {})
        return "description" in node and not list(self.inner(node, ""))

    def values(self) -> dict[str, Node]:
        return {name: node for name, node in self.root["definitions"].items() if self.is_value(name)}

    def words(self, node: Any) -> dict[str, str]:
        """The words among which a value chooses, each with its meaning."""
        return {word: meaning for one in self.shapes(node)
                for word, meaning in zip(one.get("enum", []), one.get("enumDescriptions", []))}

    def examples(self, node: Any) -> list[str]:
        own = self.resolved(node).get("examples")
        found = own or [one for shape in self.shapes(node) for one in shape.get("examples", [])]
        return list(dict.fromkeys(typed for one in found if (typed := _typed(one))))[:_MOST_EXAMPLES]

    def description(self, node: Any) -> str:
        return self.resolved(node).get("description", "")

    def kinds_of_coupling(self) -> dict[str, str]:
        """The types of couplings, each with what it is."""
        return self.words(self.root["definitions"]["coupling"]["then"]["properties"]["type"])

    def coupling(self, kind: str) -> Mapping:
        """The keys of a coupling of that type."""
        for branch in self.root["definitions"]["coupling"]["then"]["allOf"]:
            if _by_type(branch) == kind:
                return self.mapping(branch["then"])
        raise KeyError(kind)


def _by_type(branch: Any) -> str:
    """The type for which alone a branch holds."""
    return (branch if isinstance(branch, dict) else {}).get("if", {}).get("properties", {}).get(
        "type", {}).get("const", "")


def _together(words: str) -> str:
    return f"({words})" if " or " in words else words


def _last(reference: str) -> str:
    parts = reference.removeprefix("#/").split("/")
    return parts[-1] if len(parts) == 2 else ""


def _typed(value: Any) -> str:
    """As somebody types it in a file, on one line."""
    if isinstance(value, str):
        return value
    text = yaml.safe_dump(value, default_flow_style=True, sort_keys=False, width=10_000,
                          allow_unicode=True)
    return text.removesuffix("\n").removesuffix("\n...").replace("null", "")
