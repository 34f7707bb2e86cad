"""Markdown as MyST reads it."""

from __future__ import annotations

import json
import re


def escaped(text: str) -> str:
    """Plain text: no character of it means anything to Markdown, but for `code`."""
    parts = text.split("`")
    if len(parts) % 2 == 0:
        return _plain(text)
    return "".join(f"`{part}`" if i % 2 else _plain(part) for i, part in enumerate(parts))


def _plain(text: str) -> str:
    return re.sub(r"([\\`*_{}\[\]<>#|$~^!:-])", r"\\\1", text)


def code(text: str) -> str:
    """A word as it is typed."""
    fence = "``" if "`" in text else "`"
    return f"{fence}{text}{fence}"


def block(text: str, language: str = "text") -> str:
    longest = max((len(run) for run in re.findall(r"`{3,}", text)), default=2)
    fence = "`" * max(3, longest + 1)
    return f"{fence}{language}\n{text.rstrip()}\n{fence}\n"


def page(title: str, *parts: str, mark: str = "") -> str:
    """A page with its heading; parts that are empty are left out. A mark is one of Sphinx or of its
    theme: `orphan` for a page that no table of contents has, `hide-toc` for one without sections."""
    front = f"---\n{mark}: true\n---\n\n" if mark else ""
    return front + "\n".join([f"# {title}\n", *(part.rstrip() + "\n" for part in parts if part)])


def contents(names: list[str], caption: str = "", depth: int = 1, hidden: bool = False) -> str:
    """A table of contents, which also gives the pages their place in the navigation."""
    options = [f":maxdepth: {depth}"]
    if caption:
        options.append(f":caption: {caption}")
    if hidden:
        options.append(":hidden:")
    return "\n".join(["```{toctree}", *options, "", *names, "```", ""])


def picture(path: str, alt: str, target: str = "", caption: str = "", kind: str = "") -> str:
    """A figure; its target is an address of the site."""
    options = [f":alt: {json.dumps(' '.join(alt.split()), ensure_ascii=False)}"] if alt else []
    if target:
        options.append(f":target: {target}")
    if kind:
        options.append(f":figclass: {kind}")
    return "\n".join([f":::{{figure}} {path}", *options, "", caption, ":::", ""])


def cards(inside: list[str]) -> str:
    """Pictures side by side."""
    return ":::::{container} cards\n\n" + "\n".join(inside) + "\n:::::\n"
