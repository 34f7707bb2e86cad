"""The mechanisms that come with the program: pictures, file, and what the program answers."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor

import markdown
from help_text import is_prose
from mechanism import Mechanism
from picture import Pictures
from program import ANSWERED, Program

# Which pictures say most of a mechanism, the best first; the other kinds show how the method works.
_SHOWN = ["linkage", "animation", "gear-scheme", "burmester", "lever", "shift-matrix", "ratio-ladder",
          "sweep-curves", "motion-curves", "paths", "power-flow", "coupling-graph"]


def gallery_pages(program: Program, pictures: Pictures, library: list[Mechanism]) -> dict[str, str]:
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        drawn = list(pool.map(lambda one: _page(program, pictures, one), library))
    pages = {f"gallery/{one.name}.md": text for one, (text, _) in zip(library, drawn)}
    cards = {one.name: card for one, (_, card) in zip(library, drawn)}
    sections = [
        f"## {folder.capitalize()}\n\n"
        + markdown.cards([cards[one.name] for one in library if one.folder == folder])
        for folder in dict.fromkeys(one.folder for one in library)
    ]
    pages["gallery/index.md"] = markdown.page(
        "Gallery",
        "The mechanisms that come with the program, each with its source. Numbers that a source"
        " prints stand in the section [`published`](../format/published.md) of its file; every run"
        " checks them.",
        *sections,
    )
    return pages


def _page(program: Program, pictures: Pictures, one: Mechanism) -> tuple[str, str]:
    """The page of a mechanism, and the card that leads to it."""
    file = f"mechanisms/{one.name}.yaml"
    has = program.pictures_of(file) if one.has_places() else []
    kinds = [kind for kind in _SHOWN if kind in has]
    drawn = {kind: pictures.draw(kind, file, f"{one.name}-{kind}") for kind in kinds}
    figures = [
        f"### {kind}\n\n{markdown.picture(f'../../pictures/{path}', alt, caption=program.pictures()[kind])}"
        for kind, (path, alt) in drawn.items()
    ]
    remarks = one.remarks()
    couplings = ", ".join(f"[{kind}](../../couplings/{kind}.md)" for kind in one.kinds())
    # Reached from the gallery: in the navigation of every page they would only be in the way.
    text = markdown.page(
        markdown.escaped(one.title),
        f"[Gallery](../index.md#{one.folder})",
        markdown.escaped(one.description()),
        _remarks(remarks),
        f"Source: {markdown.escaped(one.source)}\n" if "Source:" not in remarks else "",
        f"Couplings\n: {couplings}\n" if couplings else "",
        "## Pictures\n" if figures else "", *figures,
        "## Report\n",
        *(_answer(program, command, file) for command in one.commands()),
        "## File\n",
        f"{{download}}`{file} <../../{file}>`",
        markdown.block(one.text, "yaml"),
        mark="orphan",
    )
    link = f"[{markdown.escaped(one.title)}]({one.name}.md)"
    if not drawn:
        return text, f":::{{container}} card\n{link}\n:::\n"
    first = next(iter(drawn.values()))[0]
    return text, markdown.picture(f"../pictures/{first}", "", f"{one.name}.html", link, "card")


def _remarks(text: str) -> str:
    """Drawings as they are, and prose."""
    return "\n\n".join(
        markdown.escaped(" ".join(one.split("\n"))) if is_prose(one.split("\n")) else markdown.block(one)
        for one in text.split("\n\n") if one
    )


def _answer(program: Program, command: str, file: str) -> str:
    line = f"kinestat {command} {file}"
    return markdown.block(f"$ {line}\n{program.shell(line, ANSWERED)}", "console")
