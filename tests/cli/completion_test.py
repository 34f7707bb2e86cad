#!/usr/bin/env python3
"""Shell completion: every command, option and value of the help, and the names in a file, in bash,
zsh and fish as users would see it."""

from __future__ import annotations

import argparse
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from functools import lru_cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RAVIGNEAUX = ROOT / "mechanisms/transmissions/ravigneaux.yaml"
PROGRAM = Path("kinestat")


def run(*words: str | Path, **more: object) -> str:
    done = subprocess.run([PROGRAM, *words], capture_output=True, encoding="utf-8", check=False,
                          **more)
    if done.returncode != 0:
        raise AssertionError(f"{words}: {done.returncode}\n{done.stderr}")
    return done.stdout


def candidates(*words: str | Path) -> tuple[str, list[str]]:
    """What fits beside the words, and the words."""
    kind, *lines = run("completion", "candidates", "--", *words).splitlines()
    return kind, [line.split("\t")[0] for line in lines]


@lru_cache(maxsize=None)
def commands() -> list[str]:
    listed = run("--help").partition("\nCommands:\n")[2].partition("\nOptions:\n")[0]
    return re.findall(r"^  (\S+)", listed, re.MULTILINE)


@lru_cache(maxsize=None)
def entries(command: str) -> list[tuple[list[str], str]]:
    """Of its help: the long names of an option, and what its value is called."""
    listed = run(command, "--help").partition("\nOptions:\n")[2]
    found = re.findall(r"^  (-\S+)(?: (\S+))?", listed, re.MULTILINE)
    return [([name for name in names.split(",") if name.startswith("--")], value)
            for names, value in found]


class Candidates(unittest.TestCase):
    def test_commands_are_those_of_the_help(self) -> None:
        self.assertGreater(len(commands()), 15)
        self.assertEqual(candidates(""), ("words", commands()))
        self.assertEqual(candidates("sy"), ("words", ["synthesize"]))

    def test_options_and_their_words_are_those_of_the_help(self) -> None:
        with_words = 0
        for command in commands():
            names = [name for names, _ in entries(command) for name in names]
            self.assertEqual(candidates(command, "--")[1], names, command)
            for long_names, value in entries(command):
                if "|" in value:
                    with_words += 1
                    for name in long_names:
                        self.assertEqual(candidates(command, name, "")[1], value.split("|"), name)
        self.assertGreater(with_words, 20)

    def test_names_are_those_of_the_file(self) -> None:
        for before in ([], ["--strict"], ["--format", "json"]):
            self.assertEqual(candidates("plot", *before, "levers", RAVIGNEAUX, "--case", "M"),
                             ("words", ["M1", "M2", "M3", "MR"]))
        parameters = candidates("analyze", RAVIGNEAUX, "--set", "")[1]
        text = RAVIGNEAUX.read_text(encoding="utf-8")
        section = text.partition("\nparameters:\n")[2]
        names = re.findall(r"^  (\w+):", re.split(r"^\w", section, flags=re.MULTILINE)[0],
                           re.MULTILINE)
        self.assertGreater(len(names), 3)
        self.assertEqual(parameters, [f"{name}=" for name in names])
        self.assertEqual(candidates("motion", RAVIGNEAUX, "--case=M1")[1], ["--case=M1"])

    def test_help_explains_types_keys_and_codes(self) -> None:
        topics = candidates("help", "")[1]
        self.assertIn("signs", topics)
        self.assertNotIn("revolute", topics)  # hundreds more follow a letter
        for word in ("revolute", "pin_in_slot", "line_of_action", "E0312", "W0511", "analyze"):
            for typed in (word[:2], word):
                self.assertIn(word, candidates("help", typed)[1], typed)
        words = candidates("help", "s")[1]
        self.assertEqual(len(words), len(set(words)))
        meanings = run("completion", "candidates", "--", "help", "revol").splitlines()[1]
        self.assertRegex(meanings, r"^revolute\t\w+")

    def test_reports_of_motions_name_words_and_quantities_of_the_file(self) -> None:
        for command in (["motion"], ["plot", "motion-curves"]):
            words = candidates(*command, RAVIGNEAUX, "--report", "")[1]
            for word in ("velocity", "transmission_angle", "C1", "a.wz", "a.Rx"):
                self.assertIn(word, words)

    def test_paths_stand_where_files_and_folders_do(self) -> None:
        self.assertEqual(candidates("analyze", ""), ("files", []))
        self.assertEqual(candidates("analyze", "a.yaml", "b"), ("files", []))
        self.assertEqual(candidates("analyze", "--out", "")[0], "folders")
        self.assertEqual(candidates("plot", "levers", "")[0], "files")

    def test_a_file_that_is_wrong_has_no_names_and_no_message(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "wrong.yaml"
            for text in ("kinestat: 1\nbodies: [", "", "\0"):
                file.write_text(text, encoding="utf-8")
                self.assertEqual(candidates("plot", "levers", file, "--case", ""), ("words", []))
            self.assertEqual(candidates("plot", "levers", folder, "--case", ""), ("words", []))

    def test_words_beyond_the_last_and_unknown_commands_have_no_candidates(self) -> None:
        self.assertEqual(candidates("compare", "a", "b", ""), ("words", []))
        self.assertEqual(candidates("no such command", ""), ("words", []))

    def test_what_a_value_may_be_is_known(self) -> None:
        """Everything in the help but numbers and texts that a user makes up."""
        free = {"VALUE", "N", "K/N", "SIZE", "X", "KEY=VALUE", "NAME", "NAMES", "SEED",
                "CRITERIA", "LENGTH", "ANGLE", "NAME=VALUE"}
        for command in commands():
            for long_names, value in entries(command):
                if value and "|" not in value and value not in free:
                    kind, words = candidates(command, RAVIGNEAUX, long_names[0], "")
                    self.assertTrue(kind != "words" or words, f"{command} {long_names[0]} {value}")


class Shells(unittest.TestCase):
    """Each with its own script, on a terminal, as a user types: a line, the key TAB, and what the
    line is then."""

    # The line between signs that no prompt and no completion has.
    SHOW = ("show() { print -rn -- \"[[$BUFFER]]\" }; zle -N show; "
            "bindkey -e; bindkey '^X^X' show")
    START = {
        "bash": (["bash", "--norc", "-i"],
                 "bind -x '\"\\C-x\\C-x\": printf \"[[%s]]\" \"$READLINE_LINE\"'; "
                 "bind 'set bell-style none'; source <(kinestat completion bash)"),
        "zsh": (["zsh", "-f", "-i"],
                f"autoload -Uz compinit; compinit -u -D; source <(kinestat completion zsh); {SHOW}"),
        "zsh from a folder": (["zsh", "-f", "-i"],
                              "mkdir ~/.zfunc; kinestat completion zsh > ~/.zfunc/_kinestat; "
                              "fpath+=(~/.zfunc); autoload -Uz compinit; compinit -u -D; "
                              f"{SHOW}"),
        "fish": (["fish", "--no-config", "-i"],
                 "kinestat completion fish | source; "
                 "bind \\cx\\cx 'printf \"[[%s]]\" (commandline | string collect)'"),
    }
    LINES = {
        "kinestat ana": "kinestat analyze",
        "kinestat analyze --format j": "kinestat analyze --format json",
        "kinestat analyze --format=j": "kinestat analyze --format=json",
        "kinestat plot linkage crank.yaml --case dr":
            "kinestat plot linkage crank.yaml --case drawn\\ position",
        "kinestat plot linkage crank.yaml --case drawn\\ p":
            "kinestat plot linkage crank.yaml --case drawn\\ position",
        "kinestat plot linkage a\\ crank.yaml --case dr":
            "kinestat plot linkage a\\ crank.yaml --case drawn\\ position",
        "kinestat plot linkage ~/crank.yaml --case dr":
            "kinestat plot linkage ~/crank.yaml --case drawn\\ position",
        "kinestat analyze crank.yaml --set fr": "kinestat analyze crank.yaml --set frame_length=",
        "kinestat analyze crank.yaml --set=fr": "kinestat analyze crank.yaml --set=frame_length=",
        "kinestat analyze cr": "kinestat analyze crank.yaml",
        "kinestat analyze ~/cr": "kinestat analyze ~/crank.yaml",
        "kinestat analyze --out fol": "kinestat analyze --out folder/",
        "kinestat help revol": "kinestat help revolute",
        "kinestat help E031": "kinestat help E031",
        "kinestat help line_of": "kinestat help line_of_action",
    }

    def setUp(self) -> None:
        folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        (folder / "bin").mkdir()
        (folder / "bin/kinestat").symlink_to(PROGRAM)
        (folder / "folder").mkdir()
        run("new", "four-bar", folder / "crank.yaml")
        shutil.copy(folder / "crank.yaml", folder / "a crank.yaml")
        self.folder = folder

    def open(self, name: str) -> None:
        words, script = self.START[name]
        if not shutil.which(words[0]):
            self.skipTest(f"{words[0]} is not installed")
        child, self.terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder)
            os.execvpe(words[0], words, {
                "PATH": f"{self.folder}/bin:{os.environ['PATH']}", "HOME": str(self.folder),
                "TERM": "xterm", "LC_ALL": "C.UTF-8", "PS1": "$ ", "HISTFILE": "/dev/null"})
        self.addCleanup(self.close, child)
        self.type(script + "; printf '<%s>' ready\r", "<ready>")

    def close(self, child: int) -> None:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        os.close(self.terminal)

    def type(self, keys: str, until: str) -> str:
        """What the terminal shows from then on, up to and with that."""
        os.write(self.terminal, keys.encode())
        shown = ""
        end = time.monotonic() + 60
        while not re.search(re.escape(until), shown):
            ready = select.select([self.terminal], [], [], max(0.0, end - time.monotonic()))[0]
            self.assertTrue(ready, f"{keys!r}: {shown!r}")
            shown += os.read(self.terminal, 65536).decode(errors="replace")
        return shown

    def line_after(self, keys: str) -> str:
        shown = self.type(f"{keys}\x18\x18", "]]")
        return re.findall(r"\[\[(.*?)\]\]", shown, re.DOTALL)[-1].rstrip()

    def check(self, name: str) -> None:
        self.open(name)
        for line, expected in self.LINES.items():
            with self.subTest(line=line):
                self.assertEqual(self.line_after(f"{line}\t"), expected)
            while self.line_after("\x05\x15"):  # to its end, and all of it away
                time.sleep(0.1)

    def test_bash(self) -> None:
        self.check("bash")

    def test_zsh(self) -> None:
        self.check("zsh")

    def test_zsh_from_a_folder(self) -> None:
        self.check("zsh from a folder")

    def test_fish(self) -> None:
        self.check("fish")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
