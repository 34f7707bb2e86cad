"""Wrong options for every command, derived from its help."""

from __future__ import annotations

from typing import Iterator

from program import Command, Program
from surroundings import PAGE, Judged, condition, content, judged

WRONG_NUMBERS = ("x", "", "-1", "1e99", "nan")
WORDS_FOR_NUMBERS = {"N"}
WRONG_SETTINGS = ("", "=", "x", "=1", "nobody=1", "x=1 +")


def told_wrong(program: Program, command: Command, *options: str,
               statuses: tuple[int, ...] = (2,)) -> Judged:
    run = program.run(command.arguments(*options, "file.yaml"), files=content(command))
    return judged(run, (run.status in statuses, f"status {run.status} for a wrong option"),
                  (not run.out or run.out.startswith(PAGE), "something is printed"))


@condition
def unknown_option(program: Program, command: Command) -> Iterator[Judged]:
    """status 2 from every command"""
    yield told_wrong(program, command, "--wrong-option")
    yield told_wrong(program, command, "--wrong-option=1")


@condition
def wrong_values(program: Program, command: Command) -> Iterator[Judged]:
    """status 2 for every option that takes a count; 3 if it overrides a key of the file"""
    for option, value in command.options().items():
        if value in WORDS_FOR_NUMBERS:
            for wrong in WRONG_NUMBERS:
                yield told_wrong(program, command, f"{option}={wrong}", statuses=(2, 3))


@condition
def wrong_words(program: Program, command: Command) -> Iterator[Judged]:
    """status 2 for every option that takes one of several words"""
    for option, value in command.options().items():
        if "|" in value:
            yield told_wrong(program, command, option, "nonsense")
            yield told_wrong(program, command, option, value.split("|")[0].upper())


@condition
def option_without_value(program: Program, command: Command) -> Iterator[Judged]:
    """status 2 for every option that takes a value"""
    for option, value in command.options().items():
        if value:
            run = program.run(command.arguments("file.yaml", option), files=content(command))
            yield judged(run, (run.status == 2, f"status {run.status} instead of 2"))


@condition
def wrong_settings(program: Program, command: Command) -> Iterator[Judged]:
    """status 2 from every command"""
    for setting in WRONG_SETTINGS:
        yield told_wrong(program, command, "--set", setting)
