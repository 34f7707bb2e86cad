#!/usr/bin/env python3
"""Checks lib/ and app/ against the table of modules in lib/CMakeLists.txt, and the sizes of files.

Usage: check_layers.py [--root FOLDER]   Prints `file:line: message` for each violation; exit status 1
if there is any. A module may include what it DEPENDS on in that table, which is written from the
bottom upwards.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Iterator

TABLE = "lib/CMakeLists.txt"

FOLDERS_OF_APP = ("options/", "terminal/")
# What a module may include of lib/, beside itself: `app` knows no more than these.
OF_APP = {"core", "files", "run"}

# A header of others begins with ... : it may be included by ...; None: by all modules.
THIRD_PARTY: dict[str, set[str] | None] = {
    "yaml-cpp/": {"io"},
    "nlohmann/": {"format", "report"},
    "Eigen/": {"math"},  # and core/types.hpp, see EIGEN_CORE
    "fmt/": None,
    "CLI/": {"app"},
    "boost/graph/": {"graph"},
    "boost/property_map/": {"graph"},
    "boost/": {"math"},
    "gmp": {"math"},
    "mpfr": {"math"},
    "xxhash": {"io"},
    "dragonbox/": {"core"},
    "sha2.h": {"core"},
    "utf8proc": {"core"},
    "klu": {"math"},
    "suitesparse/": {"math"},
    "sys/": None,
}
EIGEN_CORE = {"Eigen/Core", "Eigen/Dense", "Eigen/Eigen"}
EIGEN_HOME = "lib/core/types.hpp"

TOLERANCE_HOMES = {
    "lib/core/tolerance.hpp",
    "lib/core/angle_tolerance.hpp",
    "lib/core/extreme_tolerance.hpp",
    "lib/core/motion_tolerance.hpp",
    "lib/core/simulation_tolerance.hpp",
    "lib/core/synthesis_tolerance.hpp",
    "lib/expression/units.cpp",
}
TOLERANCE = re.compile(r"(?<![\w.])(?:\d[\d']*\.?\d*|\.\d+)[eE]-\d+")

# What the library never does, and how it would look (comments and strings are not looked at).
_FREE = r"(?<![\w.>])"
FORBIDDEN: dict[str, re.Pattern[str]] = {
    "prints": re.compile(
        r"\bstd::(?:cout|cerr|clog|print|println)\b|\bfmt::print(?:ln)?\b"
        rf"|{_FREE}(?:v?f?printf|f?puts|f?putc|putchar|perror)\s*\("
    ),
    "exits": re.compile(rf"{_FREE}(?:exit|_exit|_Exit|quick_exit|abort)\s*\(|\bstd::terminate\b"),
    "reads the environment": re.compile(r"\b(?:secure_)?getenv\b|\bsetenv\b|\bputenv\b"),
    "reads the clock": re.compile(
        r"\b(?:system|steady|high_resolution)_clock\b|\bclock_gettime\b|\bstd::(?:time|clock)\s*\("
    ),
}
FORBIDDEN_HEADERS = {"iostream": "prints", "print": "prints"}

HEADER_LINES = 150
SOURCE_LINES = 500
FOLDER_FILES = 40
DEPENDS = 12
# They put together what all others offer.
ASSEMBLIES = {"run", "pages", "draw/catalogue", "studies/sweep/task"}


# Reading


@dataclass(frozen=True)
class Violation:
    path: str
    line: int
    message: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line}: {self.message}"


@dataclass(frozen=True)
class Include:
    line: int
    target: str
    quoted: bool
    module: str  # of the target; empty: none


@dataclass(frozen=True)
class Module:
    """A row of the table."""

    name: str
    line: int
    depends: tuple[str, ...]


Modules = dict[str, Module]


def read_modules(root: Path) -> Modules:
    modules: Modules = {}
    table = root / TABLE
    text = table.read_text(encoding="utf-8") if table.exists() else ""
    text = re.sub(r"#[^\n]*", lambda m: blank(m[0]), text)
    for match in re.finditer(r"^kinestat_module\s*\(\s*([\w/]+)([^)]*)\)", text, re.M):
        depends = re.search(r"\bDEPENDS\b((?:\s+(?!LINKS|PARTS)[\w/]+)*)", match[2])
        names = tuple(depends[1].split()) if depends else ()
        modules[match[1]] = Module(match[1], line_of(text, match.start()), names)
    return modules


def module_of(path: str, modules: Modules) -> str:
    """The module of a path from lib/ on: that of the innermost folder that is one; else the first
    folder."""
    folders = path.split("/")[:-1]
    names = ["/".join(folders[: i + 1]) for i in range(len(folders))]
    return next((n for n in reversed(names) if n in modules), names[0] if names else "")


@dataclass(frozen=True)
class File:
    """A C++ file: its place relative to the root, its module, and its text."""

    path: str
    module: str
    text: str
    modules: Modules

    @property
    def is_header(self) -> bool:
        return self.path.endswith((".hpp", ".hpp.in"))

    @property
    def includes(self) -> list[Include]:
        pattern = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>)', re.M)
        code = without_comments(self.text)
        return [
            Include(
                line_of(code, m.start(m.lastindex or 0)),
                m[1] or m[2],
                bool(m[1]),
                module_of(m[1] or "", self.modules),
            )
            for m in pattern.finditer(code)
        ]


LEXEME = re.compile(
    r"""(?P<comment>//(?:\\\n|[^\n])*|/\*.*?\*/)
      | (?P<raw>R"(?P<fence>[^()\\\s]{0,16})\(.*?\)(?P=fence)")
      | (?P<text>"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+')""",
    re.X | re.S,
)


def blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)


def without_comments(text: str) -> str:
    """The text with comments and raw strings blanked; ordinary strings stay."""
    return LEXEME.sub(lambda m: m[0] if m["text"] else blank(m[0]), text)


def without_strings(text: str) -> str:
    return LEXEME.sub(lambda m: blank(m[0]), text)


def line_of(text: str, position: int) -> int:
    return text.count("\n", 0, position) + 1


def read_files(root: Path) -> list[File]:
    modules = read_modules(root)
    files = []
    for path in sorted([*root.glob("lib/**/*"), *root.glob("app/**/*")]):
        if path.name.endswith((".hpp", ".cpp", ".hpp.in", ".cpp.in")) and path.is_file():
            parts = path.relative_to(root).parts
            module = "app" if parts[0] == "app" else module_of("/".join(parts[1:]), modules)
            files.append(File("/".join(parts), module, path.read_text(encoding="utf-8"), modules))
    return files


# Rules about one file


def may_include(file: File) -> set[str]:
    if file.module == "app":
        return OF_APP
    row = file.modules.get(file.module)
    return set(row.depends) if row else set()


def check_own_includes(file: File) -> Iterator[Violation]:
    for include in (i for i in file.includes if i.quoted):
        target, module = include.target, include.module
        beside = file.module == "app" and (not module or target.startswith(FOLDERS_OF_APP))
        if beside or module == file.module:
            continue
        if not module or ".." in target.split("/"):
            message = f'"{target}" is not written from lib/ on, as in "screw/twist.hpp"'
        elif "/internal/" in target:
            message = f"{target} is internal to {module}"
        elif module not in may_include(file):
            message = f"{file.module} may not include {module}"
        else:
            continue
        yield Violation(file.path, include.line, message)


def check_third_party(file: File) -> Iterator[Violation]:
    for include in (i for i in file.includes if not i.quoted):
        target = include.target
        prefix = next((p for p in THIRD_PARTY if target.startswith(p)), None)
        if target in EIGEN_CORE and file.path != EIGEN_HOME:
            yield Violation(file.path, include.line, f'<{target}> comes through "core/types.hpp"')
        elif prefix is None and "/" in target:
            yield Violation(file.path, include.line, f"<{target}> has no row in THIRD_PARTY")
        elif prefix and not may_use(file, prefix):
            yield Violation(file.path, include.line, f"{file.module} may not include <{target}>")


def may_use(file: File, prefix: str) -> bool:
    allowed = THIRD_PARTY[prefix]
    is_eigen_home = prefix == "Eigen/" and file.path == EIGEN_HOME
    return allowed is None or file.module in allowed or is_eigen_home


def check_forbidden(file: File) -> Iterator[Violation]:
    if file.module == "app":
        return
    for include in file.includes:
        if include.target in FORBIDDEN_HEADERS:
            what = FORBIDDEN_HEADERS[include.target]
            yield Violation(file.path, include.line, f"the library never {what}: {include.target}")
    code = without_strings(file.text)
    for what, pattern in FORBIDDEN.items():
        for match in pattern.finditer(code):
            found = match[0].rstrip("( \n")
            message = f"the library never {what}: {found}"
            yield Violation(file.path, line_of(code, match.start()), message)


def check_tolerances(file: File) -> Iterator[Violation]:
    if file.module == "app" or file.path in TOLERANCE_HOMES:
        return
    code = without_strings(file.text)
    for match in TOLERANCE.finditer(code):
        message = f"the tolerance {match[0]} wants a name in core/tolerance.hpp"
        yield Violation(file.path, line_of(code, match.start()), message)


def check_shape(file: File) -> Iterator[Violation]:
    lines = file.text.splitlines()
    limit = HEADER_LINES if file.is_header else SOURCE_LINES
    if len(lines) > limit:
        yield Violation(file.path, limit + 1, f"{len(lines)} lines, above the limit of {limit}")
    if not file.is_header:
        return
    if not lines or not re.match(r"//+ \S", lines[0]):
        yield Violation(file.path, 1, "the first line is no comment saying what the header is")
    if not any(line.strip() == "#pragma once" for line in lines):
        yield Violation(file.path, 1, "#pragma once is missing")


FILE_RULES: list[Callable[[File], Iterator[Violation]]] = [
    check_own_includes, check_third_party, check_forbidden, check_tolerances, check_shape,
]


# Rules about modules


def check_folders(files: list[File]) -> Iterator[Violation]:
    counts = Counter(file.path.rsplit("/", 1)[0] for file in files if file.path.startswith("lib/"))
    for folder, count in sorted(counts.items()):
        if count > FOLDER_FILES:
            yield Violation(folder, 1, f"{count} files, above the limit of {FOLDER_FILES}")


def check_table(modules: Modules, files: list[File]) -> Iterator[Violation]:
    """Each folder has a row, and each row stands below what it depends on and needs all of it."""
    for name in sorted({f.module for f in files} - modules.keys() - {"app"}):
        yield Violation(f"lib/{name}", 1, f"the module has no row in {TABLE}")
    above: set[str] = set()
    for module in modules.values():
        included = {i.module for f in files if f.module == module.name for i in f.includes}
        for name in module.depends:
            if name not in above:
                message = f"{module.name} depends on {name}, which does not stand above it"
                yield Violation(TABLE, module.line, message)
            elif name not in included:
                message = f"{module.name} depends on {name} and includes nothing of it"
                yield Violation(TABLE, module.line, message)
        if len(module.depends) > DEPENDS and module.name not in ASSEMBLIES:
            message = f"{module.name} depends on {len(module.depends)} modules, above {DEPENDS}"
            yield Violation(TABLE, module.line, message)
        above.add(module.name)


# The command


def find_violations(root: Path) -> list[Violation]:
    modules = read_modules(root)
    files = read_files(root)
    found = [violation for file in files for rule in FILE_RULES for violation in rule(file)]
    found += check_folders(files)
    found += check_table(modules, files)
    return sorted(found, key=lambda v: (v.path, v.line, v.message))


def main() -> int:
    parser = argparse.ArgumentParser(description="Check the layers of lib/ and app/.")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[1])
    violations = find_violations(parser.parse_args().root)
    print("\n".join(map(str, violations)) or "all layers hold")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
