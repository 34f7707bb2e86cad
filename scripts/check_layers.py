#!/usr/bin/env python3
"""Checks that lib/ and app/ keep to the table of modules below.

Usage: check_layers.py [--root FOLDER]   Prints `file:line: message` per violation; exit status 1
if there is any. A new module is a new row of MAY_INCLUDE.
"""

from __future__ import annotations

import argparse
import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Iterator

# The table

_MECHANICS = "core math expression record couplings graph screw mechanism network"
_BOTH_SIDES = f"{_MECHANICS} kinematics statics"

# From the bottom upwards: a module, and the modules that it may include beside itself.
MAY_INCLUDE: dict[str, set[str]] = {
    name: set(allowed.split())
    for name, allowed in {
        "core": "",
        "math": "core",
        "expression": "core math",
        "record": "core expression",
        "description": "core expression",
        "couplings": "core expression description",
        "io": "core expression description couplings",
        "format": "core expression description couplings io",
        "graph": "core",
        "screw": "core math expression record",
        "mechanism": "core math expression record description couplings graph screw",
        "network": "core math expression record graph screw mechanism",
        "mobility": _MECHANICS,
        "inputs": _MECHANICS,
        "kinematics": _MECHANICS,
        "statics": f"{_MECHANICS} kinematics",
        "sensitivity": _BOTH_SIDES,
        "power": _BOTH_SIDES,
        "shift": f"{_BOTH_SIDES} power",
        "motion": f"{_MECHANICS} mobility kinematics",
        "synthesis": "core math expression record screw description",
        "benchmark": _MECHANICS,
        "sweep": f"{_BOTH_SIDES} description power shift",
    }.items()
}
MAY_INCLUDE["report"] = set(MAY_INCLUDE) - {"io", "format"}
MAY_INCLUDE["plot"] = MAY_INCLUDE["report"] | {"report"}
MAY_INCLUDE["run"] = set(MAY_INCLUDE)
MAY_INCLUDE["app"] = {"core", "run"}

LIBRARY = set(MAY_INCLUDE) - {"app"}

# A header of others begins with ... : it may be included by ...
THIRD_PARTY: dict[str, set[str]] = {
    "yaml-cpp/": {"io"},
    "nlohmann/": {"format", "report"},
    "Eigen/": {"math"},  # and core/types.hpp, see EIGEN_CORE
    "fmt/": LIBRARY,
    "CLI/": {"app"},
    "boost/": {"math"},
    "gmp": {"math"},
    "klu": {"math"},
    "suitesparse/": {"math"},
    "sys/": LIBRARY | {"app"},
}
EIGEN_CORE = {"Eigen/Core", "Eigen/Dense", "Eigen/Eigen"}
EIGEN_HOME = "lib/core/types.hpp"

TOLERANCE_HOMES = {
    "lib/core/tolerance.hpp",
    "lib/core/motion_tolerance.hpp",
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

    @property
    def module(self) -> str:
        return self.target.split("/")[0] if "/" in self.target else ""


@dataclass(frozen=True)
class File:
    """A C++ file: its place relative to the root, its module, and its text."""

    path: str
    module: str
    text: str

    @property
    def is_header(self) -> bool:
        return self.path.endswith((".hpp", ".hpp.in"))

    @property
    def includes(self) -> list[Include]:
        pattern = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>)', re.M)
        code = without_comments(self.text)
        return [
            Include(line_of(code, m.start(m.lastindex or 0)), m[1] or m[2], bool(m[1]))
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
    files = []
    for path in sorted([*root.glob("lib/**/*"), *root.glob("app/**/*")]):
        if path.name.endswith((".hpp", ".cpp", ".hpp.in", ".cpp.in")) and path.is_file():
            parts = path.relative_to(root).parts
            module = "app" if parts[0] == "app" else parts[1]
            files.append(File("/".join(parts), module, path.read_text(encoding="utf-8")))
    return files


# Rules about one file


def check_own_includes(file: File) -> Iterator[Violation]:
    for include in (i for i in file.includes if i.quoted):
        target, module = include.target, include.module
        beside = file.module == "app" and not module
        if beside or module == file.module:
            continue
        if not module or ".." in target.split("/"):
            message = f'"{target}" is not written from lib/ on, as in "screw/twist.hpp"'
        elif "/internal/" in target:
            message = f"{target} is internal to {module}"
        elif module not in MAY_INCLUDE.get(file.module, set()):
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
        elif prefix and file.module not in THIRD_PARTY[prefix] and not is_eigen_home(file, prefix):
            yield Violation(file.path, include.line, f"{file.module} may not include <{target}>")


def is_eigen_home(file: File, prefix: str) -> bool:
    return prefix == "Eigen/" and file.path == EIGEN_HOME


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


def check_rows(root: Path) -> Iterator[Violation]:
    for folder in sorted(path for path in root.glob("lib/*") if path.is_dir()):
        if folder.name not in LIBRARY and any(folder.iterdir()):
            yield Violation(f"lib/{folder.name}", 1, "the module has no row in check_layers.py")


@dataclass(frozen=True)
class Module:
    """What the CMakeLists.txt of a module declares."""

    path: str
    line: int
    name: str
    depends: list[str]


def read_modules(root: Path) -> dict[str, Module]:
    modules = {}
    for path in sorted(root.glob("lib/*/CMakeLists.txt")):
        text = re.sub(r"#[^\n]*", blank_match, path.read_text(encoding="utf-8"))
        match = re.search(r"\bkinestat_module\s*\(\s*(\w+)([^)]*)\)", text)
        if match:
            depends = re.search(r"\bDEPENDS\b((?:\s+[a-z_]+\b)*)", match[2])
            names = depends[1].split() if depends else []
            place = str(path.relative_to(root))
            modules[path.parent.name] = Module(
                place, line_of(text, match.start()), match[1], names
            )
    return modules


def blank_match(match: re.Match[str]) -> str:
    return blank(match[0])


def reachable(modules: dict[str, Module], start: str) -> set[str]:
    seen: set[str] = set()
    waiting = [start]
    while waiting:
        module = modules.get(waiting.pop())
        new = set(module.depends) - seen if module else set()
        seen |= new
        waiting += new
    return seen


def check_cmake(modules: dict[str, Module], files: list[File]) -> Iterator[Violation]:
    for folder, module in modules.items():
        if module.name != folder:
            message = f"the module is called {folder} by its folder"
            yield Violation(module.path, module.line, message)
        for name in module.depends:
            if name not in MAY_INCLUDE.get(folder, set()):
                yield Violation(module.path, module.line, f"{folder} may not depend on {name}")
        included = {i.module for f in files if f.module == folder for i in f.includes if i.quoted}
        for name in sorted((included & LIBRARY) - {folder} - reachable(modules, folder)):
            message = f"{folder} includes {name}, which DEPENDS does not name"
            yield Violation(module.path, module.line, message)


def check_cycles(modules: dict[str, Module], files: list[File]) -> Iterator[Violation]:
    """Cycles of what is there, whatever the table says."""
    edges: dict[str, set[str]] = {}
    for file in files:
        used = {i.module for i in file.includes if i.quoted} - {"", file.module}
        edges.setdefault(file.module, set()).update(used)
    for folder, module in modules.items():
        edges.setdefault(folder, set()).update(module.depends)
    cycle = find_cycle(edges)
    if cycle:
        yield Violation(f"lib/{cycle[0]}", 1, f"modules in a circle: {' -> '.join(cycle)}")


def find_cycle(edges: dict[str, set[str]]) -> list[str]:
    done: set[str] = set()

    def visit(node: str, trail: list[str]) -> list[str]:
        if node in trail:
            return [*trail[trail.index(node):], node]
        if node in done:
            return []
        for successor in sorted(edges.get(node, ())):
            if found := visit(successor, [*trail, node]):
                return found
        done.add(node)
        return []

    return next((found for node in sorted(edges) if (found := visit(node, []))), [])


# The command


def find_violations(root: Path) -> list[Violation]:
    files = read_files(root)
    modules = read_modules(root)
    found = [violation for file in files for rule in FILE_RULES for violation in rule(file)]
    found += check_rows(root)
    found += check_cmake(modules, files)
    found += check_cycles(modules, files)
    return sorted(found, key=lambda v: (v.path, v.line, v.message))


def main() -> int:
    parser = argparse.ArgumentParser(description="Check the layers of lib/ and app/.")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[1])
    violations = find_violations(parser.parse_args().root)
    print("\n".join(map(str, violations)) or "all layers hold")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
