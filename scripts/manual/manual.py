#!/usr/bin/env python3
"""Writes the pages of the manual as Markdown for Sphinx, from what the program and the files say.

Usage: manual.py --program PROGRAM --out FOLDER
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
from pathlib import Path

from coupling_pages import coupling_pages
from format_pages import format_pages
from gallery import gallery_pages
from hand_page import HandPages, named_files
from help_pages import command_pages, message_page, topic_pages
from mechanism import library
from picture import Pictures
from program import Program

ROOT = Path(__file__).resolve().parents[2]
MANUAL = ROOT / "manual"


def write_site(program_path: Path, out: Path) -> None:
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    for path in MANUAL.glob("*.py"):
        shutil.copy(path, out)
    shutil.copytree(MANUAL / "static", out / "static")
    shutil.copytree(ROOT / "mechanisms", out / "mechanisms")
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        shutil.copytree(ROOT / "mechanisms", work / "mechanisms")
        shutil.copytree(MANUAL / "couplings", work / "couplings")
        for name, text in named_files((ROOT / "mechanisms/README.md").read_text(encoding="utf-8")).items():
            (work / name).write_text(text, encoding="utf-8")
        program = Program(program_path, work)
        pictures = Pictures(program, out / "pictures")
        mechanisms = library(ROOT / "mechanisms")
        for pages in (
            topic_pages(program), command_pages(program), message_page(program), format_pages(program),
            coupling_pages(program, pictures, MANUAL / "couplings", mechanisms),
            gallery_pages(program, pictures, mechanisms),
            _hand_pages(HandPages(program, pictures, ROOT)),
        ):
            for name, text in pages.items():
                path = out / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")


def _hand_pages(filler: HandPages) -> dict[str, str]:
    folder = MANUAL / "pages"
    pages = {}
    for path in sorted(folder.rglob("*.md")):
        name = path.relative_to(folder)
        pages[name.as_posix()] = filler.filled(
            path.read_text(encoding="utf-8"), "../" * (len(name.parts) - 1)
        )
    return pages


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--out", type=Path, required=True)
    arguments = parser.parse_args()
    write_site(arguments.program.resolve(), arguments.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
