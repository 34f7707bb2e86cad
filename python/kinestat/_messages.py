"""Messages of the library, as exceptions and as warnings."""

from __future__ import annotations

import enum
import sys
import warnings
from ctypes import byref
from dataclasses import dataclass
from types import FrameType
from typing import TYPE_CHECKING, Any, Callable

from ._library import RawMessage, library, text_of

if TYPE_CHECKING:
    from ._report import Report


class Status(enum.IntEnum):
    """How a call ended: the exit statuses of the program `kinestat`."""

    DONE = 0
    CHECK_FAILED = 1
    USAGE = 2
    WRONG_INPUT = 3
    ENVIRONMENT = 4
    NO_ANSWER = 5
    BUG = 70


@dataclass(frozen=True)
class Message:
    """One error or warning, with its place."""

    is_error: bool
    """False: a warning."""
    code: str
    """"E0312"; explained by `kinestat explain E0312`."""
    text: str
    hint: str
    """What to do; may be empty."""
    file: str
    """As given; empty if the message concerns no file."""
    line: int
    """From 1; 0 is the whole file."""
    column: int
    """In characters from 1."""
    length: int
    """In characters."""

    def __str__(self) -> str:
        place = self.file
        if place and self.line > 0:
            place += f":{self.line}:{self.column}"
        kind = "error" if self.is_error else "warning"
        text = f"{place}: " if place else ""
        text += f"{kind}[{self.code}]: {self.text}"
        return f"{text}\n  hint: {self.hint}" if self.hint else text


class MechanismWarning(UserWarning):
    """A warning about a mechanism that is analysed nevertheless.

    `message` is the Message, with code and place."""

    def __init__(self, message: Message) -> None:
        super().__init__(str(message))
        self.message = message


class Error(Exception):
    """Base of all errors; the text is what the program would print.

    `messages` are its errors and warnings, `status` is the exit status of the program, and `report`
    is the report, if there is one nevertheless (CheckFailed and NoAnswer have one)."""

    status = Status.BUG

    def __init__(
        self,
        text: str,
        messages: tuple[Message, ...] | list[Message] = (),
        report: Report | None = None,
    ) -> None:
        super().__init__(text)
        self.messages = list(messages)
        self.report = report

    def __str__(self) -> str:
        return str(self.args[0])


class CheckFailed(Error):
    """The report does not match a published value of the file (E0901)."""

    status = Status.CHECK_FAILED


class UsageError(Error, ValueError):
    """An argument is wrong: a parameter, output or case that the file does not have, a value of
    another dimension, a number that is not finite."""

    status = Status.USAGE


class UnknownPlace(UsageError, KeyError):
    """The report has no number there."""


class WrongInput(Error, ValueError):
    """The mechanism file is wrong; the messages have the places."""

    status = Status.WRONG_INPUT


class EnvironmentFailure(Error):
    """A file cannot be read, or no memory is left."""

    status = Status.ENVIRONMENT


class NoAnswer(Error):
    """A case has no answer: no equilibrium, a singular position, numbers that are too large."""

    status = Status.NO_ANSWER


class Bug(Error):
    """A bug in the library; please report it with the mechanism file."""


ERRORS: dict[int, type[Error]] = {
    kind.status: kind
    for kind in (CheckFailed, UsageError, WrongInput, EnvironmentFailure, NoAnswer, Bug)
}


def last_messages() -> list[Message]:
    """Those of the last call of this thread."""
    result = []
    raw = RawMessage()
    for index in range(library.kinestat_message_count()):
        library.kinestat_message_at(index, byref(raw))
        result.append(
            Message(
                bool(raw.is_error), text_of(raw.code), text_of(raw.text), text_of(raw.hint),
                text_of(raw.file), raw.line, raw.column, raw.length,
            )
        )
    return result


def error_of(
    status: int, messages: list[Message], text: str = "", report: Report | None = None
) -> Error:
    """The exception of a status; `text` is by default what the last call of this thread has to
    say."""
    kind = ERRORS.get(status, Bug)
    text = text or text_of(library.kinestat_message_text()).rstrip("\n")
    if not text:
        text = "memory is used up" if kind is EnvironmentFailure else f"status {status}"
    return kind(text, messages, report)


def warn(messages: list[Message]) -> None:
    """Warns of each, at the line of the caller outside this package."""
    if not messages:
        return
    package = __name__.rpartition(".")[0]
    level = 1
    frame: FrameType | None = sys._getframe()
    while frame is not None and frame.f_globals.get("__package__") == package:
        frame = frame.f_back
        level += 1
    for message in messages:
        warnings.warn(MechanismWarning(message), stacklevel=level)


def call(function: Callable[..., int], *arguments: Any) -> list[Message]:
    """Calls a function that answers a status: its warnings, or an exception."""
    status = function(*arguments)
    messages = last_messages()
    if status != Status.DONE:
        raise error_of(status, messages)
    return messages
