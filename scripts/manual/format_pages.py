"""The reference of the format: a page a section, and one on the kinds of values."""

from __future__ import annotations

from typing import Any

import markdown
from program import Program
from schema import Key, Mapping, Schema


def format_pages(program: Program) -> dict[str, str]:
    schema = Schema(program.schema())
    top = schema.mapping({**schema.root, "allOf": []})
    needed = {name for rule in schema.root["allOf"]
              for name in rule.get("else", {}).get("required", [])}
    pages = {f"format/{key.name}.md": _section(schema, key) for key in top.keys}
    listed = "\n\n".join(
        f"[`{key.name}`]({key.name}.md)"
        f"{' (needed)' if key.needed else ' (needed for a mechanism)' if key.name in needed else ''}\n"
        f": {markdown.escaped(schema.description(key.node))}"
        for key in top.keys
    )
    notes = "\n\n".join(
        f"`{pattern.removeprefix('^')}…`\n: {markdown.escaped(node['description'])}"
        for pattern, node in schema.root.get("patternProperties", {}).items()
    )
    pages["format/index.md"] = markdown.page(
        "Format reference",
        markdown.escaped(schema.root["description"]),
        "Every section and key of a mechanism file, from the schema with which the program checks it"
        " and editors complete it: [`kinestat schema`](../commands/schema.md). The whole in words:"
        " [](../topics/format.md). Values: [](values.md).",
        listed, notes,
        markdown.contents([key.name for key in top.keys] + ["values"], hidden=True),
        mark="hide-toc",
    )
    pages["format/values.md"] = _values(schema)
    return pages


def keys(schema: Schema, mapping: Mapping) -> str:
    """What each key of a mapping means."""
    parts = [_key(schema, key) for key in mapping.keys]
    return "\n\n".join(parts + [markdown.escaped(note) for note in mapping.notes])


def _key(schema: Schema, key: Key) -> str:
    lines = [markdown.escaped(schema.description(key.node)), *_facts(schema, key)]
    return f"`{key.name}`\n: " + "\n\n  ".join(line for line in lines if line)


def _facts(schema: Schema, key: Key) -> list[str]:
    """What may stand there, and examples."""
    facts = [schema.value(key.node)]
    if key.needed:
        facts.append("**needed**")
    default = schema.resolved(key.node).get("default")
    if default is not None:
        facts.append(f"default {markdown.code(str(default))}")
    examples = schema.examples(key.node)
    if examples:
        facts.append("e.g. " + ", ".join(markdown.code(f"{key.name}: {one}") for one in examples))
    words = schema.words(key.node)
    return ["; ".join(facts), _words(words).replace("\n", "\n  ") if words else ""]


def _words(words: dict[str, str]) -> str:
    return "\n".join(f"- {markdown.code(word)}: {markdown.escaped(meaning)}"
                     for word, meaning in words.items())


def _section(schema: Schema, key: Key) -> str:
    parts = [markdown.escaped(schema.description(key.node)), *_facts(schema, key)]
    if key.name == "couplings":
        parts.append("The keys of each type: [](../couplings/index.md).")
    for place, node in _places(schema, key.name, key.node):
        parts.append(f"## {markdown.code(place)}" if place != key.name else "## Keys")
        if node is not key.node:
            parts.append(markdown.escaped(schema.description(node)))
        parts.append(keys(schema, schema.mapping(node)))
    return markdown.page(key.name, *(f"{part}\n" for part in parts))


def _places(schema: Schema, place: str, node: Any) -> list[tuple[str, Any]]:
    """The mappings in a section, the outer ones first."""
    found = []
    for where, inner in schema.inner(node, place):
        if all(schema.resolved(one) is not schema.resolved(inner) for _, one in found):
            found.append((where, inner))
        for key in schema.mapping(inner).keys:
            found += _places(schema, f"{where}.{key.name}", key.node)
    return found


def _values(schema: Schema) -> str:
    parts = []
    for name, node in schema.values().items():
        examples = schema.examples(node)
        words = schema.words(node)
        said = [markdown.escaped(schema.description(node))]
        if words:
            said.append(_words(words))
        if examples:
            said.append("For example " + ", ".join(markdown.code(one) for one in examples))
        title = name.replace("_", " ")
        parts.append(f"(value-{name.replace('_', '-')})=\n## {title}\n\n" + "\n\n".join(said))
    return markdown.page(
        "Values", "What may stand behind the keys; units are those of [](../topics/units.md),"
        " expressions those of [](../topics/expressions.md).", *parts,
    )
