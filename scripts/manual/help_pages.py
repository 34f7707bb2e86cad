"""Pages of topics, commands and messages: what `kinestat help` and `kinestat explain` say."""

from __future__ import annotations

import re

import markdown
from help_text import HelpText
from program import Program


def topic_pages(program: Program) -> dict[str, str]:
    texts = HelpText(program)
    pages = {}
    for word, about in program.topics().items():
        text = program("help", word)
        parts = _parts(program, text, texts) if word == "reports" else ""
        pages[f"topics/{word}.md"] = markdown.page(
            _title(word, about), texts.body(text.partition("\n")[2]), parts,
            texts.see_also(text, word),
        )
    pages["topics/index.md"] = markdown.page(
        "Topics", "What `kinestat help TOPIC` says, in the order in which it lists them.",
        markdown.contents(list(program.topics())), mark="hide-toc",
    )
    return pages


def _parts(program: Program, text: str, texts: HelpText) -> str:
    """Of the topic on reports, which has pages of its own for the keys of each."""
    words = dict.fromkeys(re.findall(r"help reports ([a-z]+)", text))
    return "\n\n".join(
        f"## {word}\n\n{markdown.block(program('help', 'reports', word).partition(chr(10))[2].strip(chr(10)))}"
        for word in words
    )


def command_pages(program: Program) -> dict[str, str]:
    texts = HelpText(program)
    pages = {}
    for word, about in program.commands().items():
        text = program("help", word)
        summary, _, rest = text.partition("\n")
        pages[f"commands/{word}.md"] = markdown.page(
            f"kinestat {word}", markdown.escaped(summary), texts.body(rest), texts.see_also(text, word)
        )
    listed = "\n\n".join(
        f"[`kinestat {word}`]({word}.md)\n: {markdown.escaped(about)}"
        for word, about in program.commands().items()
    )
    pages["commands/index.md"] = markdown.page(
        "Commands", listed, markdown.contents(list(program.commands()), hidden=True), mark="hide-toc"
    )
    return pages


def message_page(program: Program) -> dict[str, str]:
    texts = HelpText(program)
    parts = []
    for code, title in program.messages().items():
        text = program("explain", code).partition("\n")[2]
        body = re.sub(r"^## .*\n+", "", texts.body(text).replace("../", ""), flags=re.M)
        parts.append(f"({code.lower()})=\n## {code}: {markdown.escaped(title)}\n\n{body}")
    return {"messages.md": markdown.page(
        "Messages", "Every error and warning by its code, as `kinestat explain CODE` explains it.",
        *parts,
    )}


def _title(word: str, about: str) -> str:
    return f"{word[0].upper()}{word[1:]}: {markdown.escaped(about)}"
