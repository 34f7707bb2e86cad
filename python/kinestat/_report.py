"""Reports: every number by its place."""

from __future__ import annotations

import json
from ctypes import byref, c_double
from typing import Any, overload

from ._library import Handle, c_text, library, text_of
from ._messages import Message, Status, UnknownPlace, UsageError, call, error_of


class Report:
    """The report of `kinestat analyze` on a mechanism; Mechanism.analyze creates it.

    A number is addressed by a JSON Pointer, or by its keys one by one, which can then contain "/":

        report["/cases/M1/ratio"]
        report["cases", "M1", "statics", "actions", "out"]

    A value that does not exist (null in JSON) is NaN; true and false are 1.0 and 0.0. A place without
    a number raises UnknownPlace, which is a KeyError. `kinestat help reports` describes the places,
    `kinestat schema report` prints the schema. Units are those of the file; the report lists them at
    "/mechanism/units"."""

    def __init__(self, handle: Handle, status: int, messages: list[Message], text: str) -> None:
        self._handle = handle
        self._text = text
        self._json: str | None = None
        self.status = Status(status)
        """DONE; CHECK_FAILED if a published value of the file is not matched; NO_ANSWER if a case has
        none, with its numbers NaN or absent."""
        self.messages = messages
        """Warnings, and the errors that explain the status."""

    def check(self) -> Report:
        """Raises CheckFailed or NoAnswer, which contain this report, unless the status is DONE."""
        if self.status != Status.DONE:
            raise error_of(self.status, self.messages, self._text, self)
        return self

    def __getitem__(self, place: str | tuple[str | int, ...]) -> float:
        pointer = place if isinstance(place, str) else "".join(
            "/" + str(key).replace("~", "~0").replace("/", "~1") for key in place
        )
        number = c_double()
        with self._handle.lock:
            try:
                call(library.kinestat_number, self._handle.pointer,
                     c_text(pointer, "the place"), byref(number))
            except UsageError as problem:
                raise UnknownPlace(str(problem), problem.messages) from None
        return number.value

    @overload
    def get(self, place: str | tuple[str | int, ...]) -> float | None: ...

    @overload
    def get(self, place: str | tuple[str | int, ...], default: float) -> float: ...

    def get(
        self, place: str | tuple[str | int, ...], default: float | None = None
    ) -> float | None:
        """The number at a place, or the default where the report has none."""
        try:
            return self[place]
        except UnknownPlace:
            return default

    @property
    def json(self) -> str:
        """The report as JSON, as `kinestat analyze --format json` prints it."""
        if self._json is None:
            with self._handle.lock:
                self._json = text_of(library.kinestat_json(self._handle.pointer))
        return self._json

    def to_dict(self) -> dict[str, Any]:
        """The report as dictionaries and lists, with keys in the order of the report; missing values
        are None."""
        result: dict[str, Any] = json.loads(self.json)
        return result

    def __repr__(self) -> str:
        return f"<kinestat.Report: {self.status.name}, {len(self.messages)} messages>"
