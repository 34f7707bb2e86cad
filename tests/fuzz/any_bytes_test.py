#!/usr/bin/env python3
"""One MiB of any bytes is answered soon, in 100 MiB, with one of the statuses for input.

Every kind of input is generated from a fixed seed, as large as the reader accepts, and read by
`kinestat check -` with little address space. Prints processor time and peak memory of each. The
guard on the time is loose, because machines differ; a quadratic step shows up well above it.
"""

from __future__ import annotations

import argparse
import os
import random
import resource
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Callable, Iterator

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from sanitized import has_sanitizers  # noqa: E402

PROGRAM = Path("kinestat")
SIZE = 1 << 20
LONGEST_S = 10
MOST_MEMORY = 100 << 20
ADDRESS_SPACE = 150 << 20
HEAD = """kinestat: 1
space: planar
ground: frame
"""
CHAIN = """bodies: [crank, coupler, rocker]
couplings:
  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}
  b: {type: revolute, bodies: [crank, coupler], at: [1, 3]}
  c: {type: revolute, bodies: [coupler, rocker], at: [6, 5]}
  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}
"""
MECHANISM = HEAD + CHAIN
SIGNS = [
    "[", "{", "]", "}", "- ", "? ", ": ", ", ", "[]", "{}", "[{", "a: ", "a: {", "'", '"', "''",
    '""', "'a' ", "'a", '"\\', "#", "# ", " #", "\n#", " ", "\n", "\r\n", "\t", "a", "a ", "a\n",
    "a\n ", "\n a", "- a\n", "-\n", "? a\n", "a:\n", "|\n", ">\n a\n", "a: |\n", "&a ", "*a ",
    "&a *a ", "! ", "!!a ", "!a", "%", "%a\n", "---\n", "...\n", "--- a\n", "@", "`", "~ ", "\\",
    "ä", "😀", "<<: ", "a:\n - ", "\n\n ", "0,", "\ufeff",
]


def repeated(part: str, head: str = "", tail: str = "") -> bytes:
    """head, the part as often as fits, tail."""
    room = SIZE - len(head.encode()) - len(tail.encode())
    return (head + part * (room // len(part.encode())) + tail).encode()


def numbered(part: str, head: str = "", tail: str = "") -> bytes:
    """The same with {0} counting up, so that names differ."""
    room = SIZE - len(head.encode()) - len(tail.encode())
    parts: list[str] = []
    while len(one := part.format(len(parts))) <= room:
        parts.append(one)
        room -= len(one)
    return (head + "".join(parts) + tail).encode()


def mechanisms() -> bytes:
    return b"".join(path.read_bytes() for path in sorted((ROOT / "mechanisms").rglob("*.yaml")))


def shuffled(pieces: list[bytes], rng: random.Random) -> bytes:
    result: list[bytes] = []
    size = 0
    while size < SIZE:
        result.append(rng.choice(pieces))
        size += len(result[-1])
    return b"".join(result)[:SIZE]


def random_inputs() -> Iterator[tuple[str, bytes]]:
    rng = random.Random(20261121)
    yield "random bytes", rng.randbytes(SIZE)
    printable = bytes(range(32, 127)) + b"\n"
    yield "random printable characters", bytes(rng.choices(printable, k=SIZE))
    yield "random signs of YAML", bytes(rng.choices(b"[]{}:,-?&*!|>'\"%@` \na", k=SIZE))
    yield "random letters, colons and spaces", bytes(rng.choices(b"ab: \n", k=SIZE))
    yield "random UTF-8", "".join(rng.choices("aä€😀\n :", k=SIZE // 3)).encode()[:SIZE]
    text = mechanisms()
    yield "bytes of mechanisms", shuffled([bytes([byte]) for byte in text], rng)
    yield "words of mechanisms", shuffled([word + b" " for word in text.split()], rng)
    yield "lines of mechanisms", shuffled(text.splitlines(keepends=True), rng)
    yield "mechanisms in a row", (text * (SIZE // len(text) + 1))[:SIZE]
    changed = bytearray((text * (SIZE // len(text) + 1))[:SIZE])
    for at in rng.sample(range(SIZE), 1000):
        changed[at] = rng.randrange(32, 127)
    yield "mechanisms with faults", bytes(changed)


def signs() -> Iterator[tuple[str, bytes]]:
    for part in SIGNS:
        yield f"only {part!r}", repeated(part)
        yield f"a list of {part!r}", repeated(part, "a: [", "]")
        yield f"a text of {part!r}", repeated(part, 'a: "', '"')
        yield f"a block text of {part!r}", repeated(part.replace("\n", "\n  "), "a: |\n  ", "\n")


def trees() -> Iterator[tuple[str, bytes]]:
    notes = MECHANISM + "x-notes:"
    yield "many keys", numbered("x-{0}: 1\n", MECHANISM)
    yield "many unknown keys", numbered("k{0}: 1\n", MECHANISM)
    yield "one key again and again", repeated("a: 1\n", MECHANISM)
    yield "many keys in brackets", numbered("k{0}: 1, ", notes + " {", "}")
    yield "many keys without values", numbered("k{0}, ", notes + " {", "}")
    yield "many items", repeated("0,", notes + " [", "0]")
    yield "many items in a block", repeated("- 0\n", notes + "\n")
    yield "many empty items", repeated(",", notes + " [", "]")
    yield "many empty lists", repeated("[],", notes + " [", "[]]")
    yield "many empty mappings", repeated("{},", notes + " [", "{}]")
    yield "many small mappings", repeated("{a: 1},", notes + " [", "{}]")
    yield "many quoted items", repeated("'',", notes + " [", "'']")
    yield "many anchors", numbered("&a{0} 1, ", notes + " [", "1]")
    yield "one anchor again and again", repeated("&a 1, ", notes + " [", "1]")
    yield "many aliases", repeated("*a, ", notes + " [&a 1, ", "1]")
    yield "many aliases of many anchors", numbered("&a{0} 1, *a{0}, ", notes + " [", "1]")
    yield "many unknown aliases", numbered("*a{0}, ", notes + " [", "1]")
    yield "aliases of a large list", repeated("*a, ", notes + " [&a [" + "1," * 1000 + "1], ", "1]")
    yield "aliases of a long text", repeated("*a, ", notes + " [&a " + "x" * 60000 + ", ", "1]")
    yield "many tags", repeated("!a 1, ", notes + " [", "1]")
    yield "many merge keys", repeated("{<<: 1},", notes + " [", "1]")
    yield "many lists as keys", repeated("{[]: 1},", notes + " [", "1]")
    yield "nested lists side by side", repeated("[" * 50 + "]" * 50 + ",", notes + " [", "1]")
    yield "nested mappings side by side", repeated("{a: " * 50 + "}" * 50 + ",", notes + " [", "1]")
    yield "a long plain text", repeated("x", notes + " ")
    yield "a long quoted text", repeated("x", notes + ' "', '"')
    yield "a long text of escapes", repeated("\\n", notes + ' "', '"')
    yield "a long text of bad escapes", repeated("\\0", notes + ' "', '"')
    yield "a long text over lines", repeated("x\n  ", notes + "\n  ")
    yield "a long block text", repeated("  x\n", notes + " |\n")
    yield "many long texts", repeated("- " + "x" * 60000 + "\n", notes + "\n")
    yield "a long key", repeated("x", notes + " {", ": 1}")
    steps = "".join(" " * i + "a:\n" for i in range(1400))
    yield "a deep block", (MECHANISM + steps).encode()[:SIZE]
    yield "a deep block list", repeated("- ", notes + "\n")
    yield "a comment at each line", repeated("# x\n", MECHANISM)
    yield "one long comment", repeated("x", MECHANISM + "# ")
    yield "CRLF at each line", repeated("x: 1\r\n", "")
    yield "null bytes behind", MECHANISM.encode() + bytes(SIZE - len(MECHANISM))
    yield "the last byte bad", repeated("# x\n", MECHANISM)[:SIZE - 1] + b"\xff"


def descriptions() -> Iterator[tuple[str, bytes]]:
    yield "many bodies", numbered("b{0},", HEAD + "bodies: [", "b]\ncouplings: {}\n")
    yield "many bodies and one coupling", numbered(
        "b{0},", HEAD + "bodies: [", "b]\ncouplings: {a: {type: rigid, bodies: [c, frame]}}\n")
    yield "one body again and again", repeated("b,", HEAD + "bodies: [", "b]\ncouplings: {}\n")
    yield "many bad names", repeated("=,", HEAD + "bodies: [", "b]\ncouplings: {}\n")
    yield "many couplings", numbered("  c{0}: {{type: rigid, bodies: [frame, b]}}\n",
                                     HEAD + "bodies: [b]\ncouplings:\n")
    yield "a chain of couplings", chain()
    yield "many couplings of unknown bodies", numbered(
        "  c{0}: {{type: rigid, bodies: [x{0}, y{0}]}}\n", HEAD + "bodies: [b]\ncouplings:\n")
    yield "many unknown bodies among many", unknown_bodies()
    yield "many couplings of unknown type", numbered("  c{0}: {{type: revolut}}\n",
                                                     HEAD + "bodies: [b]\ncouplings:\n")
    yield "many empty couplings", numbered("  c{0}:\n", HEAD + "bodies: [b]\ncouplings:\n")
    yield "many parameters", numbered("  p{0}: 1\n", MECHANISM + "parameters:\n")
    yield "many parameters in a chain", numbered("  p{0}: p{0}1 + 1\n", MECHANISM + "parameters:\n")
    yield "many parameters of the one before", chained_parameters()
    yield "many parameters in a circle", chained_parameters(closed=True)
    yield "many unknown names", numbered("  p{0}: q{0}\n", MECHANISM + "parameters:\n")
    yield "many names of units", repeated("  m: 1\n", MECHANISM + "parameters:\n")
    yield "many divisions by zero", numbered("  p{0}: 1/0\n", MECHANISM + "parameters:\n")
    yield "one long sum", repeated("+1", MECHANISM + "parameters: {p: 1", "}\n")
    yield "many long sums", numbered("  p{0}: " + "1+" * 2000 + "1\n", MECHANISM + "parameters:\n")
    yield "many long sums of names", numbered("  p{0}: " + "q+" * 2000 + "q\n",
                                              MECHANISM + "parameters:\n  q: 1\n")
    yield "many deep sums", numbered("  p{0}: " + "(" * 60 + "1" + ")" * 60 + "\n",
                                     MECHANISM + "parameters:\n")
    yield "many unfinished sums", numbered("  p{0}: 1+\n", MECHANISM + "parameters:\n")
    yield "a tree of unknown couplings", repeated("x, ", MECHANISM + "tree: [", "a]\n")
    yield "a tree of one coupling", repeated("a, ", MECHANISM + "tree: [", "a]\n")
    yield "many actuators", numbered("  t{0}: {{coupling: a}}\n", MECHANISM + "actuators:\n")
    yield "many unknown actuators", numbered("  t{0}: {{coupling: x{0}}}\n",
                                             MECHANISM + "actuators:\n")
    yield "many cases", numbered("  k{0}: {{motion: {{a.wz: 1}}}}\n", MECHANISM + "cases:\n")
    yield "many cases of unknown motions", numbered("  k{0}: {{motion: {{x: 1}}}}\n",
                                                    MECHANISM + "cases:\n")
    yield "one case of many motions", numbered(
        "x{0}: 1, ", MECHANISM + "cases: {k: {motion: {", "}}}\n")
    yield "one case of many inputs", repeated(
        "x, ", MECHANISM + "cases: {k: {motion: {a.wz: 1}, input: [", "x]}}\n")
    yield "many empty cases", numbered("  k{0}:\n", MECHANISM + "cases:\n")
    yield "many published values", repeated(
        "- {value: /x, is: 1, tolerance: 1}\n", MECHANISM + "published:\n")
    yield "many wrong published values", repeated("- {}\n", MECHANISM + "published:\n")
    joint = MECHANISM + "  e: {type: revolute, bodies: [frame, crank], "
    yield "a point of many components", repeated("1,", joint + "at: [", "1]}\n")
    yield "many passive actions", repeated("Rx, ", joint + "at: [0, 0], passive: [", "Rx]}\n")


def chain() -> bytes:
    count = 12000
    bodies = ", ".join(f"b{i}" for i in range(count))
    first = "  g: {type: revolute, bodies: [frame, b0], at: [0, 1]}\n"
    others = "".join(f"  c{i}: {{type: revolute, bodies: [b{i}, b{i + 1}], at: [{i}, 0]}}\n"
                     for i in range(count - 1))
    return f"{HEAD}bodies: [{bodies}]\ncouplings:\n{first}{others}".encode()


def unknown_bodies() -> bytes:
    bodies = ", ".join(f"body{i}" for i in range(30000))
    return numbered("  c{0}: {{type: rigid, bodies: [frame, bdoy{0}]}}\n",
                    f"{HEAD}bodies: [{bodies}]\ncouplings:\n")


def chained_parameters(closed: bool = False) -> bytes:
    count = 50000
    first = f"p{count - 1}" if closed else "1"
    lines = [f"  p0: {first}\n", *(f"  p{i}: p{i - 1}\n" for i in range(1, count))]
    return (MECHANISM + "parameters:\n" + "".join(reversed(lines))).encode()


def inputs() -> Iterator[tuple[str, bytes]]:
    for family in (random_inputs, signs, trees, descriptions):
        yield from family()


def limit_memory() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))


def check(text: bytes) -> tuple[int, float, int, bytes]:
    """Exit status, processor seconds, peak bytes and standard error of `kinestat check -`."""
    with tempfile.TemporaryFile() as file, tempfile.TemporaryFile() as err:
        file.write(text)
        file.seek(0)
        before: Callable[[], None] | None = None if has_sanitizers(PROGRAM) else limit_memory
        process = subprocess.Popen([PROGRAM, "check", "-"], stdin=file, stdout=subprocess.DEVNULL,
                                   stderr=err, preexec_fn=before)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        err.seek(0)
        seconds = usage.ru_utime + usage.ru_stime
        return process.returncode, seconds, usage.ru_maxrss << 10, err.read()


class AnyBytes(unittest.TestCase):
    def test_are_answered_soon_and_in_bounded_memory(self) -> None:
        loose = 10 if has_sanitizers(PROGRAM) else 1
        for i, (name, text) in enumerate(inputs()):
            if has_sanitizers(PROGRAM) and i % 8 != 0:
                continue  # they are ten times slower; the release build tries all
            with self.subTest(name):
                self.assertLessEqual(len(text), SIZE)
                status, seconds, memory, err = check(text)
                print(f"{seconds:7.3f} s {memory / 2**20:6.1f} MiB  status {status}  {name}",
                      flush=True)
                self.assertIn(status, (0, 3), err[:500])
                self.assertLess(seconds, LONGEST_S * loose)
                self.assertLess(memory, MOST_MEMORY * loose)
                self.assertLess(len(err), 20_000)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
