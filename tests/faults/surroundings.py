"""Conditions under which every command runs: disks, pipes, limits, environments, output paths.

Each condition takes the program and a command, and yields its runs with what is wrong in each; its
first line states the promise. `FOR_ALL` lists them by name.
"""

from __future__ import annotations

import json
import os
import re
from typing import Callable, Iterator

from program import Command, Program, Run

Judged = tuple[Run, list[str], tuple[str, ...]]  # the run, what is wrong, files that it may write
Condition = Callable[[Program, Command], Iterator[Judged]]

FOR_ALL: dict[str, Condition] = {}
PAGE = b"<!doctype html>"


def condition(function: Condition) -> Condition:
    FOR_ALL[function.__name__] = function
    return function


def judged(run: Run, *checks: tuple[bool, str], written: tuple[str, ...] = ()) -> Judged:
    return run, [text for is_right, text in checks if not is_right], written


def content(command: Command) -> dict[str, bytes]:
    return {"file.yaml": command.answered.read_bytes()}


def ordinary(program: Program, command: Command) -> Run:
    return program.run(command.arguments("file.yaml"), files=content(command))


def without_times(command: Command, text: bytes) -> bytes:
    """Only measurements differ from run to run."""
    return b"" if command.name == "bench" else text


def unreadable(run: Run, code: bytes = b"E0151") -> Judged:
    """A page that a report writes says of every file what was wrong with it."""
    return judged(run, (run.status == 4, f"status {run.status} instead of 4"),
                  (code in run.err, f"no {code.decode()}"),
                  (not run.out or run.out.startswith(PAGE), "something is printed"))


def same_as_ordinary(program: Program, command: Command, run: Run) -> Judged:
    plain = ordinary(program, command)
    return judged(run, (run.status == 0, f"status {run.status}"),
                  (without_times(command, run.out) == without_times(command, plain.out),
                   "other bytes than without"))


@condition
def missing_file(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 and E0151 from every command"""
    yield unreadable(program.run(command.arguments("nowhere.yaml")))


@condition
def folder_for_a_file(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 and E0151 from every command"""
    yield unreadable(program.run(command.arguments(".")))


@condition
def device_for_a_file(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 and E0151 from every command, without waiting"""
    yield unreadable(program.run(command.arguments("/dev/zero"), hang=10))


@condition
def empty_file_name(program: Program, command: Command) -> Iterator[Judged]:
    """status 2 or 4 from every command"""
    run = program.run(command.arguments(""))
    yield judged(run, (run.status in (2, 4), f"status {run.status}"))


@condition
def circle_of_links(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 and E0151 from every command"""
    run = program.run(command.arguments("a.yaml"), shell='ln -s a.yaml a.yaml; exec "$@"')
    run.left = [path for path in run.left if path != "a.yaml"]
    yield unreadable(run)


@condition
def too_large_a_file(program: Program, command: Command) -> Iterator[Judged]:
    """status 3 or 4 and the limit, from every command"""
    run = program.run(command.arguments("file.yaml"), files={"file.yaml": b"#" * ((1 << 20) + 1)})
    yield judged(run, (run.status in (3, 4), f"status {run.status}"),
                 (b"1048576" in run.err, "the limit is not named"))


@condition
def endless_input(program: Program, command: Command) -> Iterator[Judged]:
    """refused at the limit by every command"""
    run = program.run(command.arguments("-"), shell='yes | "$@"; exit "${PIPESTATUS[1]}"', hang=20)
    yield judged(run, (run.status in (3, 4), f"status {run.status}"),
                 (b"1048576" in run.err, "the limit is not named"))


@condition
def odd_file_name(program: Program, command: Command) -> Iterator[Judged]:
    """every command answers, and no name reaches the terminal unescaped"""
    name = b"-a b\n%s\xff\x1b[31m.yaml"
    shell = 'cp file.yaml "./$ODD"; "$@" "./$ODD"; status=$?; rm "./$ODD"; exit $status'
    env = {b"PATH": os.defpath.encode(), b"LC_ALL": b"C", b"ODD": name}
    run = program.run(command.arguments(), files=content(command), shell=shell, env=env)
    yield judged(run, (run.status == 0, f"status {run.status}"))


@condition
def full_disk(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 and E0152 from every command"""
    run = program.run(command.arguments("file.yaml"), files=content(command),
                      shell='exec "$@" > /dev/full')
    yield unreadable(run, b"E0152")


@condition
def help_to_a_full_disk(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 and E0152 from every command"""
    run = program.run([command.name, "--help"], shell='exec "$@" > /dev/full')
    yield unreadable(run, b"E0152")


@condition
def closed_pipe(program: Program, command: Command) -> Iterator[Judged]:
    """every command ends quietly and leaves nothing behind"""
    run = program.run(command.arguments("file.yaml"), files=content(command),
                      shell='"$@" | true; status=${PIPESTATUS[0]}; '
                            '[[ $status == 141 ]] && exit 0; exit "$status"')
    yield judged(run, (run.status == 0, f"status {run.status}"),
                 (b"error" not in run.err, "an error is told to nobody"))


@condition
def other_locale(program: Program, command: Command) -> Iterator[Judged]:
    """the same bytes from every command"""
    for locale in ("pt_BR.UTF-8", "tr_TR.UTF-8", "xx_NOWHERE"):
        env = {"PATH": os.defpath, "LC_ALL": locale, "LANG": locale}
        run = program.run(command.arguments("file.yaml"), files=content(command), env=env)
        yield same_as_ordinary(program, command, run)


@condition
def empty_environment(program: Program, command: Command) -> Iterator[Judged]:
    """the same bytes from every command"""
    run = program.run(command.arguments("file.yaml"), files=content(command),
                      shell='exec /usr/bin/env -i '
                            '${ASAN_OPTIONS+"ASAN_OPTIONS=$ASAN_OPTIONS"} "$@"')
    yield same_as_ordinary(program, command, run)


@condition
def no_temporary_folder(program: Program, command: Command) -> Iterator[Judged]:
    """the same bytes from every command"""
    env = {"PATH": os.defpath, "LC_ALL": "C", "TMPDIR": "/nonexistent", "HOME": "/nonexistent"}
    run = program.run(command.arguments("file.yaml"), files=content(command), env=env)
    yield same_as_ordinary(program, command, run)


@condition
def run_again(program: Program, command: Command) -> Iterator[Judged]:
    """the same bytes from every command, repeated and with any number of threads"""
    for jobs in ([], ["--jobs", "1"], ["--jobs", "3"]):
        if jobs and "--jobs" not in command.options():
            continue
        run = program.run(command.arguments(*jobs, "file.yaml"), files=content(command))
        yield same_as_ordinary(program, command, run)


@condition
def little_memory(program: Program, command: Command) -> Iterator[Judged]:
    """an answer, or status 4 and E0154, from every command"""
    if program.has_sanitizers:
        return  # they reserve terabytes of addresses
    notes = b"x-notes: [" + b"0,\n  " * 150000 + b"0]\n"
    files = {"file.yaml": content(command)["file.yaml"] + b"\n" + notes}
    run = program.run(command.arguments("file.yaml"), files=files,
                      shell='ulimit -v 30000; exec "$@"')
    yield unreadable(run, b"E0154")


@condition
def few_open_files(program: Program, command: Command) -> Iterator[Judged]:
    """the same bytes from every command"""
    run = program.run(command.arguments("file.yaml"), files=content(command),
                      shell='ulimit -n 8; exec "$@"')
    yield same_as_ordinary(program, command, run)


def bad_tokens(text: bytes) -> list[str]:
    words = re.findall(rb"(?<![\w.-])(-?nan|-?inf|-0(?:\.0*)?(?:e[+-]?\d+)?)(?![\w.])", text, re.I)
    return [word.decode() for word in words]


def refuse_constant(token: str) -> None:
    raise ValueError(token)


def is_json(text: bytes) -> bool:
    """One document, or one a line."""
    for parts in ([text], text.splitlines()):
        try:
            for part in parts:
                json.loads(part, parse_constant=refuse_constant)
            return True
        except ValueError:
            continue
    return False


@condition
def well_formed(program: Program, command: Command) -> Iterator[Judged]:
    """strict JSON, complete lines ending in LF, no NaN, infinity or minus zero, in every format"""
    forms = re.search(r"--format (\S+)", command.help)
    for form in forms[1].split("|") if forms else [""]:
        if form == "npy":
            continue
        options = ["--format", form] if form else []
        run = program.run(command.arguments(*options, "file.yaml"), files=content(command))
        text = without_times(command, run.out)
        tokens = bad_tokens(text) if form else []
        yield judged(run, (run.status == 0, f"status {run.status}"),
                     (run.out.endswith(b"\n"), "the last line has no end"),
                     (b"\r" not in run.out, "a carriage return"),
                     (not tokens, f"{tokens} among the numbers"),
                     (form != "json" or is_json(run.out), "no JSON"))


@condition
def long_names(program: Program, command: Command) -> Iterator[Judged]:
    """every command answers or refuses in bounded time and memory"""
    name = "b" * 60_000
    text = command.answered.read_text(encoding="utf-8")
    bodies = re.search(r"^bodies:\s*[\[{]\s*(\w+)", text, re.M)
    if not bodies:
        return  # a task of synthesis has no names
    renamed = re.sub(rf"\b{bodies[1]}\b", name, text)
    run = program.run(command.arguments("file.yaml"), files={"file.yaml": renamed.encode()})
    yield judged(run)


def output(command: Command) -> str:
    """FILE or FOLDER where the command writes one."""
    return command.options().get("--out", "")


@condition
def output_place_missing(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 from every command with --out"""
    if output(command):
        run = program.run(command.arguments("--out", "no/where", "file.yaml"),
                          files=content(command))
        yield judged(run, (run.status == 4, f"status {run.status}"))


@condition
def foreign_output(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 from every command with --out, and the existing file is unchanged"""
    if output(command) == "FILE":
        run = program.run(command.arguments("--out", "mine", "file.yaml"),
                          files={**content(command), "mine": b"my notes\n"})
        yield judged(run, (run.status == 4, f"status {run.status}"))
    if output(command) == "FOLDER":
        run = program.run(command.arguments("--out", "mine", "file.yaml"),
                          files={**content(command), "mine": b"my notes\n"})
        yield judged(run, (run.status == 4, f"status {run.status}"))


@condition
def output_onto_the_input(program: Program, command: Command) -> Iterator[Judged]:
    """status 4 from every command with --out, and the mechanism file is unchanged"""
    if output(command):
        run = program.run(command.arguments("--out", "file.yaml", "file.yaml"),
                          files=content(command))
        yield judged(run, (run.status == 4, f"status {run.status}"))
