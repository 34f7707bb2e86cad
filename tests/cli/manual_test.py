#!/usr/bin/env python3
"""The pages for man(1): of the program, of every command and of every topic, with the complete help
text, formatted without a warning."""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

PROGRAM = Path("kinestat")


def run(*words: str) -> str:
    done = subprocess.run([PROGRAM, *words], capture_output=True, encoding="utf-8", check=False)
    if done.returncode != 0:
        raise AssertionError(f"{words}: {done.returncode}\n{done.stderr}")
    return done.stdout


def listed(text: str, head: str) -> list[str]:
    """The first words of the indented lines behind a heading of the help."""
    part = text.partition(f"{head}:\n")[2].split("\n\n")[0]
    return re.findall(r"^  (\S+)", part, re.MULTILINE)


def commands() -> list[str]:
    return listed(run("--help"), "Commands")


def topics() -> list[str]:
    return listed(run("help"), "Topics")


def pages() -> dict[str, str]:
    return ({"kinestat.1": run("help", "--man")}
            | {f"kinestat-{one}.1": run("help", "--man", one) for one in commands()}
            | {f"kinestat-{one}.7": run("help", "--man", f"{one}.7") for one in topics()})


def words_of(text: str) -> list[str]:
    return re.sub(r"[‐−]", "-", text).split()


class Manual(unittest.TestCase):
    def formatted(self, page: str) -> str:
        if not shutil.which("groff"):
            self.skipTest("groff is not installed")
        # As man(1) calls it, on a page so broad that no word of an option is parted.
        done = subprocess.run(["groff", "-man", "-Tutf8", "-Kutf8", "-ww", "-rLL=200n", "-P-c"],
                              input=page, capture_output=True, encoding="utf-8", check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""), page[:200])
        return re.sub(r".\x08", "", done.stdout)

    def test_every_command_and_topic_has_a_page(self) -> None:
        self.assertGreater(len(commands()), 15)
        self.assertGreater(len(topics()), 15)
        whole = pages()["kinestat.1"].replace("\\-", "-")
        for page in pages():
            if page != "kinestat.1":
                name, section = page.rsplit(".", 1)
                self.assertRegex(whole, rf"{name}\\fR\({section}\)")

    def test_pages_are_read_without_a_complaint(self) -> None:
        for name, page in pages().items():
            title, section = name.rsplit(".", 1)
            text = self.formatted(page)
            self.assertIn(f"{title.upper()}({section})", text, name)
            self.assertIn("NAME", text)

    def test_pages_have_every_option_and_example_of_the_help(self) -> None:
        for command in commands():
            use = run(command, "--help")
            page = " ".join(words_of(self.formatted(run("help", "--man", command))))
            for names in listed(use, "Options"):
                self.assertIn(names.replace(",", ", "), page, command)
            for line in use.partition("Examples:\n")[2].partition("\nUsage:")[0].splitlines():
                self.assertIn(" ".join(words_of(line)), page, command)

    def test_pages_have_the_text_of_their_topic(self) -> None:
        for topic in topics():
            first, _, rest = run("help", topic).partition("\n")
            page = " ".join(words_of(self.formatted(run("help", "--man", f"{topic}.7"))))
            for line in [first.partition(": ")[2], *rest.splitlines()]:
                self.assertIn(" ".join(words_of(line)), page, topic)

    def test_unknown_words_are_answered_as_by_the_help(self) -> None:
        done = [subprocess.run([PROGRAM, "help", *words], capture_output=True, check=False)
                for words in (["anlyze"], ["--man", "anlyze"])]
        self.assertEqual(done[0].returncode, 2)
        self.assertEqual((done[0].returncode, done[0].stderr), (done[1].returncode, done[1].stderr))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
