"""Pages written by hand, in which blocks are filled by the program or by the README files.

    ```{run} 3 /Slip/               command lines, run as they stand, with their exit status if it
    kinestat shift gearbox.yaml     is not 0; of what they print, the paragraphs that match
    ```
    ```{draw} lever                 a picture of a mechanism file
    mechanisms/gears/worm_drive.yaml
    ```
    ```{section} mechanisms/README.md
    The format by example           a section of a README file without its heading
    ```
    ```{intro} README.md            the prose of a README file above its first section
    ```
"""

from __future__ import annotations

import re
from pathlib import Path

import markdown
from picture import Pictures
from program import Program

_BLOCK = re.compile(r"^```\{(run|draw|section|intro)\} *(.*)\n((?:.*\n)*?)```$", re.M)


class HandPages:
    def __init__(self, program: Program, pictures: Pictures, root: Path):
        self._program = program
        self._pictures = pictures
        self._root = root
        self._drawn = 0

    def filled(self, text: str, up: str) -> str:
        """The page; `up` leads from it to the root of the site."""
        return _BLOCK.sub(lambda found: self._fill(found[1], found[2].strip(), found[3], up), text)

    def _fill(self, kind: str, argument: str, body: str, up: str) -> str:
        if kind == "run":
            return self._run(body.strip("\n"), *_status_and_pattern(argument))
        if kind == "draw":
            self._drawn += 1
            return self._pictures.figure(argument, body.strip(), f"pages/{self._drawn}-{argument}",
                                         f"{up}pictures/")
        text = (self._root / argument).read_text(encoding="utf-8")
        return _intro(text) if kind == "intro" else _section(text, body.strip())

    def _run(self, script: str, status: int, pattern: str) -> str:
        shown = "\n".join(f"> {line}" if line.startswith((" ", "done")) else f"$ {line}"
                          for line in script.split("\n"))
        return markdown.block(f"{shown}\n{_excerpt(self._program.shell(script, (status,)), pattern)}",
                              "console")


def _status_and_pattern(argument: str) -> tuple[int, str]:
    found = re.fullmatch(r"(\d*) *(?:/(.*)/)?", argument)
    if not found:
        raise SystemExit(f"manual: '{argument}' is no exit status and no pattern")
    return int(found[1] or 0), found[2] or ""


def _excerpt(printed: str, pattern: str) -> str:
    """The paragraphs that match, an ellipsis in the place of the others."""
    if not pattern:
        return printed
    kept: list[str] = []
    for one in printed.strip("\n").split("\n\n"):
        if re.search(pattern, one, re.M):
            kept.append(one)
        elif not kept or kept[-1] != "…":
            kept.append("…")
    if kept == ["…"]:
        raise SystemExit(f"manual: nothing that is printed matches '{pattern}':\n{printed}")
    return re.sub(r"(^…|\n\n…)(?:\n\n|$)", lambda m: m[1].replace("\n\n", "\n") + "\n",
                  "\n\n".join(kept))


def _section(text: str, heading: str) -> str:
    """What stands below a heading, its own headings one level up where they can be."""
    found = re.search(rf"^(#+) {re.escape(heading)}\n", text, re.M)
    if not found:
        raise SystemExit(f"manual: there is no section '{heading}'")
    rest = text[found.end():]
    end = re.search(rf"^#{{1,{len(found[1])}}} (?!\S+\.yaml$)", rest, re.M)
    body = rest[:end.start()] if end else rest
    return re.sub(r"^##(#+ )", r"#\1", body, flags=re.M).strip("\n")


def _intro(text: str) -> str:
    """Without what is laid out for another page: tables and pictures."""
    paragraphs = text.partition("\n## ")[0].split("\n\n")
    return "\n\n".join(one.strip() for one in paragraphs if one[0] not in "#|")


def named_files(text: str) -> dict[str, str]:
    """Files that a README writes out, each with its name in a comment; of several the last."""
    return {name: body for name, body in re.findall(r"^```yaml\n# (\S+\.yaml)\n(.*?)^```$", text, re.M | re.S)}
