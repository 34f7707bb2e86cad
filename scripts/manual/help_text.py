"""Help as the terminal shows it, made a page: prose flows, what is laid out stays as it is."""

from __future__ import annotations

import re
import textwrap

import markdown
from program import Program

_LONGEST_HEADING = 48


class HelpText:
    """Finds in a text what has a page of its own."""

    def __init__(self, program: Program):
        self._topics = program.topics()
        self._commands = program.commands()
        self._messages = program.messages()
        self._codes = re.compile(rf"\b({'|'.join(self._messages)})\b")
        self._help = re.compile(rf"\bhelp ({'|'.join([*self._topics, *self._commands])})\b(?!-)")

    def address(self, word: str) -> str:
        """Of the page on a topic or a command, from a folder beside theirs."""
        return f"../{'topics' if word in self._topics else 'commands'}/{word}.md"

    def body(self, text: str) -> str:
        """The text without its first line."""
        parts: list[str] = []
        laid_out: list[str] = []
        for one in text.split("\n\n"):
            if not one.strip():
                continue
            lines = one.strip("\n").split("\n")
            if is_prose(lines):
                parts += _literal(laid_out)
                laid_out = []
                parts.append(self._linked(" ".join(lines)))
            elif _is_heading(lines):
                parts += _literal(laid_out)
                laid_out = ["\n".join(lines[1:])]
                parts.append(f"## {markdown.escaped(lines[0].removesuffix(':'))}")
            else:
                laid_out.append("\n".join(lines))
        return "\n\n".join([*parts, *_literal(laid_out)]) + "\n"

    def see_also(self, text: str, own: str = "") -> str:
        """The pages that a text mentions."""
        words = sorted({found[1] for found in self._help.finditer(text)} - {own})
        codes = sorted({found[1] for found in self._codes.finditer(text)})
        links = [f"[{word}]({self.address(word)})" for word in words]
        links += [f"[{code}: {markdown.escaped(self._messages[code])}]({code.lower()})"
                  for code in codes]
        return "## See also\n\n" + "\n".join(f"- {link}" for link in links) if links else ""

    def _linked(self, prose: str) -> str:
        """Prose in which `help gears` leads to that page."""
        pieces: list[str] = []
        for i, part in enumerate(prose.split("`")):
            if i % 2:
                found = self._help.search(part)
                pieces.append(f"[{markdown.code(part)}]({self.address(found[1])})" if found
                              else markdown.code(part))
            else:
                end = 0
                for found in self._help.finditer(part):
                    pieces.append(markdown.escaped(part[end:found.start()]))
                    pieces.append(f"[{found[0]}]({self.address(found[1])})")
                    end = found.end()
                pieces.append(markdown.escaped(part[end:]))
        return "".join(pieces)


def is_prose(lines: list[str]) -> bool:
    return all(not re.search(r"^ | {3,}|^[+|-]+$", line) for line in lines)


def _is_heading(lines: list[str]) -> bool:
    """A short line with a colon, and below it what is indented."""
    return (
        len(lines) > 1 and lines[0].endswith(":") and len(lines[0]) <= _LONGEST_HEADING
        and not lines[0].startswith(" ") and all(line.startswith(" ") for line in lines[1:])
    )


def _literal(blocks: list[str]) -> list[str]:
    """What is laid out; a mechanism file in it is a block of its own, as far as it is indented."""
    is_file = bool(blocks) and _begins_file(blocks[0])
    for i, one in enumerate(blocks[1:], 1):
        if _begins_file(one) or is_file and not one.startswith(" "):
            return _literal(blocks[:i]) + _literal(blocks[i:])
    if not blocks:
        return []
    text = textwrap.dedent("\n\n".join(blocks))
    if any(line.startswith("+ ") for line in text.splitlines()):
        return [markdown.block(text, "diff")]
    if is_file:
        return [markdown.block(text, "yaml")]
    is_shell = all(line.startswith(("kinestat ", "generator ")) for line in text.splitlines() if line)
    return [markdown.block(text, "bash" if is_shell else "text")]


def _begins_file(block: str) -> bool:
    return bool(re.match(r"( *# .*\n)* +kinestat: 1\b", block))
