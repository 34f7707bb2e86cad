"""A mechanism file, as far as a page on it needs to know it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml


@dataclass
class Mechanism:
    """`name` is that of the file below its folder, without the ending: planar/four_bar."""

    name: str
    text: str
    content: dict[str, Any]

    @classmethod
    def read(cls, path: Path, root: Path) -> "Mechanism":
        text = path.read_text(encoding="utf-8")
        # Numbers and words as typed: nothing of them is calculated here.
        content = yaml.load(text, Loader=yaml.BaseLoader)
        return cls(path.relative_to(root).with_suffix("").as_posix(), text, content)

    @property
    def folder(self) -> str:
        return self.name.partition("/")[0]

    @property
    def title(self) -> str:
        return self.content.get("name", self.name)

    @property
    def source(self) -> str:
        return self.content.get("source", "")

    def comment(self) -> str:
        """What stands above the first key."""
        lines = self.text.split("kinestat:", 1)[0].splitlines()
        kept = [line.removeprefix("#").removeprefix(" ") for line in lines if "$schema=" not in line]
        return "\n".join(kept).strip("\n")

    def description(self) -> str:
        """The first sentences of the comment, up to the drawing."""
        return " ".join(self.comment().partition("\n\n")[0].split())

    def remarks(self) -> str:
        """The rest of the comment: the drawing, and what is said below it."""
        return self.comment().partition("\n\n")[2].strip("\n")

    def kinds(self) -> list[str]:
        """The types of its couplings, those that gears and cables make too."""
        couplings = self.content.get("couplings", {}) or {}
        found = {one["type"] for one in couplings.values()}
        if self.content.get("gears"):
            found.add("gear")
        if self.content.get("cables"):
            found.add("cable")
        return sorted(found)

    def commands(self) -> list[str]:
        """The commands that answer what the file asks."""
        if "synthesis" in self.content and "couplings" not in self.content:
            return ["synthesize"]
        found = ["shift"] if "shift" in self.content else []
        found += ["analyze"] if self.has_places() else ["mobility"]
        found += ["motion"] if "motion" in self.content else []
        return found

    def has_places(self) -> bool:
        """Whether the file says where its couplings are, or is only a topology."""
        return "gears" in self.content or bool(re.search(r"\b(at|from): *[\[{]", self.text))


def library(root: Path) -> list[Mechanism]:
    return [Mechanism.read(path, root) for path in sorted(root.glob("*/*.yaml"))]
