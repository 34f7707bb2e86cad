#!/usr/bin/env python3
"""The documentation of the format is true: examples of the help, the starter files and the READMEs.

An example is a block that begins with `kinestat: 1`, possibly after the name of its file, as in
`# press.yaml`; it must be accepted without a message and follow the schema. A console block of a
README is run line by line, in a folder with the files named earlier on the page, and must print
the output shown; a line `…` stands for any lines. A script that begins with its name, as in
`# check.sh`, can be called by a console block.
"""

from __future__ import annotations

import argparse
import fcntl
import json
import os
import pty
import re
import struct
import subprocess
import sys
import tempfile
import termios
import unittest
from pathlib import Path
from typing import Any, Iterator

import jsonschema
import yaml

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from sanitized import few, has_sanitizers  # noqa: E402

CASES = ROOT / "tests" / "cli"
PAGES = ["README.md", "mechanisms/README.md"]
PROGRAM = Path("kinestat")


def kinestat(*arguments: str | Path, cwd: Path = ROOT) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], capture_output=True, encoding="utf-8", check=False,
        timeout=240, cwd=cwd,
    )


def topics() -> list[str]:
    lines = kinestat("help").stdout.splitlines()
    return [line.split()[0] for line in lines if line.startswith("  ")]


def kinds() -> list[str]:
    hint = kinestat("new").stderr.splitlines()[-1]
    return hint.split("kinds are ")[1].split(", ")


def indented_examples(text: str) -> Iterator[str]:
    """The blocks of a page of help that begin with `    kinestat: 1`."""
    for match in re.finditer(r"^    kinestat: 1\b.*\n(?:    .*\n)*", text, re.M):
        yield re.sub(r"^    ", "", match[0], flags=re.M)


def blocks(page: str) -> list[tuple[str, str]]:
    """The fenced blocks of a page: their language, and their text."""
    text = (ROOT / page).read_text("utf-8")
    return re.findall(r"^```(\w+)\n(.*?)^```$", text, re.M | re.S)


def schema(name: str) -> Any:
    return json.loads((ROOT / "schemas" / f"{name}.schema.json").read_text("utf-8"))


def faults(value: Any, name: str) -> list[str]:
    errors = jsonschema.Draft7Validator(schema(name)).iter_errors(value)
    return [f"{list(error.absolute_path)}: {error.message[:200]}" for error in errors]


def matches(expected: str, actual: str) -> bool:
    """Whether two texts are equal, where a line `…` of the first is any lines of the second."""
    parts = [re.escape(part) for part in re.split(r"^…\n", expected, flags=re.M)]
    return re.fullmatch("(?:.*\n)*".join(parts), actual) is not None


def command_of(text: str) -> str:
    """What a file is for: a synthesis task alone holds no mechanism."""
    return "synthesize" if "\nsynthesis:" in text and "\ncouplings:" not in text else "analyze"


class Examples(unittest.TestCase):
    def accept(self, text: str, command: str) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "example.yaml"
            path.write_text(text, encoding="utf-8")
            told = kinestat(command, path)
        self.assertEqual((told.returncode, told.stderr), (0, ""), text)
        self.assertEqual(faults(yaml.safe_load(text), "mechanism"), [], text)

    def test_of_each_topic_are_accepted(self) -> None:
        count = 0
        for topic in topics():
            for text in indented_examples(kinestat("help", topic).stdout):
                with self.subTest(topic):
                    self.accept(text, command_of(text))
                    count += 1
        self.assertGreaterEqual(count, 7)

    def test_of_the_pages_are_accepted(self) -> None:
        for page in PAGES:
            for language, text in blocks(page):
                if language == "yaml" and re.match(r"(# \S+\.yaml\n)?kinestat: 1\b", text):
                    with self.subTest(page):
                        self.accept(text, command_of(text))


    def test_of_each_type_of_coupling_are_accepted(self) -> None:
        for kind in types_of_couplings():
            with self.subTest(kind):
                page = kinestat("help", kind).stdout
                self.assertRegex(page, rf"(?m)^{kind}: ")  # behind what the glossary says
                told = re.sub(r"^    kinestat: 1\n(    .*\n)*", "", page, flags=re.M)
                self.assertLessEqual(max(map(len, told.splitlines())), 80)
                examples = list(indented_examples(page))
                self.assertEqual(len(examples), 1)
                self.accept(examples[0], "analyze")


def types_of_couplings() -> list[str]:
    keys = schema("mechanism")["definitions"]["coupling"]["then"]["properties"]
    return keys["type"]["enum"]


def commands() -> list[str]:
    told = kinestat("--help").stdout.split("\nCommands:\n")[1].split("\n\n")[0]
    return re.findall(r"(?m)^  (\w+) ", told)


def on_terminal(*arguments: str) -> str:
    """What a terminal of 80 columns shows, without colours."""
    leader, follower = pty.openpty()
    fcntl.ioctl(follower, termios.TIOCSWINSZ, struct.pack("HHHH", 25, 80, 0, 0))
    text = b""
    with subprocess.Popen([PROGRAM, *arguments], stdout=follower, stderr=subprocess.DEVNULL,
                          env={**os.environ, "NO_COLOR": "1"}):
        os.close(follower)
        try:
            while part := os.read(leader, 4096):
                text += part
        except OSError:
            pass  # the end
    os.close(leader)
    shown = text.decode().replace("\r\n", "\n")
    long = [line for line in shown.splitlines() if len(line) > 80]
    if long or not shown:
        raise AssertionError(f"{arguments}: {long}")
    return shown


class Width(unittest.TestCase):
    """What people read fits a terminal of 80 columns."""

    def check(self, *arguments: str) -> None:
        with self.subTest(arguments):
            told = kinestat(*arguments)
            self.assertEqual((told.returncode, told.stderr), (0, ""))
            self.assertGreater(len(told.stdout), 0)
            self.assertEqual([line for line in told.stdout.splitlines() if len(line) > 80], [])

    def test_of_the_use_of_every_command(self) -> None:
        self.assertGreaterEqual(len(commands()), 20)
        self.check("--help")
        for command in commands():
            self.check(command, "--help")

    def test_of_the_lists(self) -> None:
        for words in (("help",), ("help", "commands"), ("examples",), ("help", "efficiency"),
                      ("help", "helical")):
            self.check(*words)

    def test_of_a_terminal_where_lines_hold_what_a_file_says(self) -> None:
        """In a pipe each picture has its line."""
        file = str(ROOT / "mechanisms" / "transmissions" / "ravigneaux.yaml")
        piped = kinestat("plot", "list", file).stdout
        self.assertGreater(max(map(len, piped.splitlines())), 80)
        self.assertEqual(on_terminal("plot", "list", file).split(), piped.split())
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(folder) / "a.json", Path(folder) / "b.json"]
            for path, mu in zip(paths, ("19", "20")):
                path.write_text(kinestat("analyze", "--format", "json", "--set", f"N1={mu}",
                                         file).stdout, encoding="utf-8")
            told = on_terminal("compare", *map(str, paths))
            self.assertIn("values differ", told)


def keys_of_the_format() -> list[str]:
    """Those of the schema; what stands in its `coupling_keys` has names of its own there."""
    whole = schema("mechanism")
    whole["definitions"]["coupling_keys"] = list(
        whole["definitions"]["coupling_keys"]["properties"].values())
    return sorted(set(keys_of(whole)))


class Topics(unittest.TestCase):
    def test_tell_every_key_of_the_schema(self) -> None:
        told = "".join(kinestat("help", topic).stdout for topic in topics())
        for key in few(PROGRAM, keys_of_the_format()):
            with self.subTest(key):
                self.assertRegex(told, rf"(?m)^ +{key}  ")
                page = kinestat("help", key)
                self.assertEqual((page.returncode, page.stderr), (0, ""))
                self.assertRegex(page.stdout, rf"(?m)^(  {key}  |{key}: |Usage: kinestat {key} )")
                self.assertLessEqual(max(map(len, page.stdout.splitlines())), 80)

    def test_fit_a_terminal_and_name_themselves(self) -> None:
        for topic in topics():
            with self.subTest(topic):
                page = kinestat("help", topic).stdout
                self.assertTrue(page.startswith(f"{topic}: "))
                self.assertLessEqual(max(map(len, page.splitlines())), 80)

    def test_name_only_codes_that_exist(self) -> None:
        for topic in topics():
            for code in set(re.findall(r"\b[EW]\d{4}\b", kinestat("help", topic).stdout)):
                with self.subTest(topic):
                    self.assertEqual(kinestat("explain", code).returncode, 0, code)


def report_parts() -> list[str]:
    hint = kinestat("help", "reports", "?").stderr.splitlines()[-1]
    return hint.split("parts of 'reports' are ")[1].split(", ")


def keys_of(schema_part: Any) -> Iterator[str]:
    """The keys of all objects of a schema."""
    if isinstance(schema_part, list):
        for item in schema_part:
            yield from keys_of(item)
    elif isinstance(schema_part, dict):
        yield from schema_part.get("properties", {})
        for item in schema_part.values():
            yield from keys_of(item)


class ReportKeys(unittest.TestCase):
    def test_stand_on_pages_that_fit_a_terminal(self) -> None:
        pages = {part: kinestat("help", "reports", part).stdout for part in report_parts()}
        shared = kinestat("help", "reports").stdout + pages["mechanism"] + pages["diagnostics"]
        names = [path.name.removesuffix(".schema.json")
                 for path in (ROOT / "schemas").glob("*.schema.json")]
        for name in names:
            if name == "mechanism":
                continue  # a file, no report
            told = shared + ("".join(pages.values()) if name == "report" else pages[name])
            for key in set(keys_of(schema(name))):
                with self.subTest(name, key=key):
                    self.assertRegex(told, rf"(?m)^ +{key}  ")
        for part, page in pages.items():
            with self.subTest(part):
                self.assertLessEqual(max(map(len, page.splitlines())), 80)

    def test_have_no_page_of_another_name(self) -> None:
        for words in (("reports", "pwer"), ("signs", "power")):
            told = kinestat("help", *words)
            self.assertEqual((told.returncode, told.stdout), (2, ""))
            self.assertIn("E0101", told.stderr)


class Starters(unittest.TestCase):
    def test_follow_the_schema(self) -> None:
        for kind in kinds():
            with self.subTest(kind):
                value = yaml.safe_load(kinestat("new", kind).stdout)
                self.assertEqual(faults(value, "mechanism"), [])

    def test_name_the_schema_for_editors_first(self) -> None:
        for kind in kinds():
            with self.subTest(kind):
                first = kinestat("new", kind).stdout.splitlines()[0]
                self.assertEqual(
                    first, "# yaml-language-server: $schema=mechanism.schema.json")

    def test_are_accepted_by_all_commands_that_they_ask_for(self) -> None:
        for kind in kinds():
            text = kinestat("new", kind).stdout
            commands = [["check", "--strict"], ["report", "--strict"], [command_of(text)]]
            commands += [[word] for word in ("motion", "shift", "sweep") if f"\n{word}:" in text]
            for words in commands:
                with self.subTest(kind, command=words), tempfile.TemporaryDirectory() as folder:
                    path = Path(folder) / "file.yaml"
                    kinestat("new", kind, path)
                    told = kinestat(*words, path)
                    said = told.stderr if words != ["sweep"] else ""  # of a sweep, its summary
                    self.assertEqual((told.returncode, said), (0, ""))


class Consoles(unittest.TestCase):
    def test_print_what_the_pages_say(self) -> None:
        for page in PAGES:
            with self.subTest(page), tempfile.TemporaryDirectory() as name:
                folder = Path(name)
                (folder / "mechanisms").symlink_to(ROOT / "mechanisms")
                for language, text in blocks(page):
                    if language == "console":
                        self.run_console(text, folder)
                    elif match := re.match(r"# (\S+\.(?:yaml|sh))\n", text):
                        (folder / match[1]).write_text(text, encoding="utf-8")

    def run_console(self, text: str, folder: Path) -> None:
        path = f"{PROGRAM.parent}:{os.environ.get('PATH', os.defpath)}"
        for match in re.finditer(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", text, re.M):
            told = subprocess.run(
                ["bash", "-c", match[1]], cwd=folder, env={**os.environ, "PATH": path},
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", check=False,
                timeout=480,
            )
            if not matches(match[2], told.stdout):
                self.assertEqual(match[2], told.stdout, match[1])


class Diagnostics(unittest.TestCase):
    def test_as_json_follow_the_schema_and_say_what_the_text_says(self) -> None:
        paths = sorted(CASES.glob("*/*.yaml"))
        if has_sanitizers(PROGRAM):
            paths = [path for path in paths
                     if not path.with_name("not_with_sanitizers").exists()]
        for path in few(PROGRAM, paths):
            with self.subTest(path.parent.name):
                told = kinestat("analyze", "--quiet", path)
                lines = kinestat("analyze", "--quiet", "--diagnostics", "json", path).stderr
                line = json.loads(lines)
                self.assertEqual(faults(line, "diagnostics"), [])
                self.assertEqual(line["status"], told.returncode)
                self.assertTrue(lines.isascii() and lines.count("\n") == 1)
                pattern = r"^(?:\S.*: )?(error|warning)\[(\w+)\]: (.*)$"
                shown = re.findall(pattern, told.stderr, re.M)
                meant = [(d["severity"], d["code"], d["message"]) for d in line["diagnostics"]]
                if len(meant) <= 20:
                    self.assertEqual(shown, meant)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
