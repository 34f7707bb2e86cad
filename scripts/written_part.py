"""The generated parts of a page: the text between two marks."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class WrittenPart:
    """A generated part of one page; its marks are comments, which are not displayed."""

    page: Path
    begin: str
    end: str

    def replaced(self, text: str) -> str:
        """The page with `text` between the marks, each of which occurs in it once."""
        head, rest = self.page.read_text(encoding="utf-8").split(self.begin)
        _, tail = rest.split(self.end)
        return f"{head}{self.begin}\n\n{text}\n\n{self.end}{tail}"

    def write(self, text: str) -> None:
        self.page.write_text(self.replaced(text), encoding="utf-8")
