"""One page a type of coupling: its freedoms, its actions, its keys, and an example."""

from __future__ import annotations

import re
from pathlib import Path

import markdown
from format_pages import keys
from mechanism import Mechanism
from picture import Pictures
from program import Program
from schema import Schema


def coupling_pages(
    program: Program, pictures: Pictures, examples: Path, library: list[Mechanism]
) -> dict[str, str]:
    schema = Schema(program.schema())
    kinds = schema.kinds_of_coupling()
    names = _freedoms_and_actions(program)
    strangers = {path.stem for path in examples.glob("*.yaml")} ^ set(kinds)
    if strangers:
        raise SystemExit(f"manual: types of couplings and examples differ: {', '.join(strangers)}")

    pages = {}
    cards = []
    for kind, about in kinds.items():
        file = f"couplings/{kind}.yaml"
        example = Mechanism.read(examples / f"{kind}.yaml", examples)
        drawn, alt = pictures.draw("linkage", file, f"couplings/{kind}")
        used = [one for one in library if kind in one.kinds()]
        freedoms, actions = names[kind]
        pages[f"couplings/{kind}.md"] = markdown.page(
            kind,
            f"{markdown.escaped(about[0].upper() + about[1:])}.",
            f"Freedoms\n: {markdown.code(freedoms)}\n\nActions\n: {markdown.code(actions)}\n",
            markdown.picture(f"../pictures/{drawn}", alt, caption=markdown.escaped(example.title)),
            markdown.block(example.text, "yaml"),
            _answer(program, file),
            "## Keys\n",
            keys(schema, schema.coupling(kind)),
            _gallery(used),
            "What the keys mean in pictures and formulas: [](../topics/couplings.md),"
            " [](../topics/signs.md).",
        )
        cards.append(markdown.picture(f"../pictures/{drawn}", "", f"{kind}.html",
                                      f"[{kind}]({kind}.md)", "card"))
    pages["couplings/index.md"] = markdown.page(
        "Couplings",
        "A coupling joins two bodies. Names of freedoms and actions are those of an axis z; along"
        " another axis they follow it.",
        markdown.cards(cards),
        markdown.contents(list(kinds), hidden=True), mark="hide-toc",
    )
    return pages


def _freedoms_and_actions(program: Program) -> dict[str, tuple[str, str]]:
    """From the table of `kinestat help couplings`."""
    lines = program("help", "couplings").splitlines()
    header = next(i for i, line in enumerate(lines) if re.match(r"  type +freedoms +actions$", line))
    at = [lines[header].index(word) for word in ("type", "freedoms", "actions")]
    found = {}
    for line in lines[header + 1:]:
        if not line:
            break
        if line[at[0]] != " ":
            found[line[at[0]:at[1]].strip()] = (line[at[1]:at[2]].strip(), line[at[2]:].strip())
    return found


def _answer(program: Program, file: str) -> str:
    command = f"kinestat analyze {file}"
    return markdown.block(f"$ {command}\n{program.shell(command)}", "console")


def _gallery(used: list[Mechanism]) -> str:
    if not used:
        return ""
    links = [f"- [{markdown.escaped(one.title)}](../gallery/{one.name}.md)" for one in used]
    return "## In the gallery\n\n" + "\n".join(links)
