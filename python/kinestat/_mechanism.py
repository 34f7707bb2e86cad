"""Mechanism files: loading, setting parameters, analysing and recording."""

from __future__ import annotations

import math
import os
from ctypes import byref, c_char_p, c_void_p
from decimal import Decimal
from fractions import Fraction
from typing import (
    Any, Iterable, Iterator, MutableMapping, SupportsFloat, SupportsIndex, Union,
)

from ._library import Handle, c_text, library, text_of
from ._messages import Message, UsageError, call, error_of, last_messages, warn
from ._report import Report
from ._tape import Tape

Value = Union[str, SupportsFloat, SupportsIndex]
"""A number (integers, fractions and decimals are passed on exactly), or a text as in a mechanism
file: "20 deg", "2*N1"."""


def value_text(value: Value) -> str:
    """The value of a parameter as written in a mechanism file."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        raise TypeError("a value of a parameter is a number or a text, not bool")
    if isinstance(value, Fraction):
        return f"{value.numerator}/{value.denominator}"
    if isinstance(value, (int, Decimal)):
        return str(value)
    if isinstance(value, SupportsIndex):  # integers of NumPy
        return str(value.__index__())
    try:
        number = float(value)
    except TypeError:
        raise TypeError(
            f"a value of a parameter is a number or a text, not {type(value).__name__}"
        ) from None
    if not math.isfinite(number):
        raise UsageError(f"a value of a parameter is finite, not {number}")
    return repr(number)


class Parameters(MutableMapping[str, Any]):
    """The parameters of a mechanism, by name in the order of the file.

    Set a number, in the unit that a bare number has at that place, or a text with a unit or an
    expression of other parameters. A parameter that the file writes with a unit needs a value with a
    unit: "0.3 rad". Reading gives the value as a number in the unit returned by `unit`. It is the
    value in a report, for which the mechanism is analysed once after parameters were set.

        mechanism.parameters["N1"] = 24
        mechanism.parameters.update(alpha="20 deg", N3="N2 + 2*N6jk")
    """

    def __init__(self, mechanism: Mechanism) -> None:
        self._mechanism = mechanism

    def __setitem__(self, name: str, value: Value) -> None:
        self._mechanism.set(name, value)

    def __delitem__(self, name: str) -> None:
        raise TypeError("a parameter can be set, but not taken away")

    def __getitem__(self, name: str) -> Any:
        return self._entry(name)["value"]

    def unit(self, name: str) -> str:
        """The unit of the value; "" for a bare number."""
        return str(self._entry(name)["unit"])

    def _entry(self, name: str) -> dict[str, Any]:
        if name not in self._mechanism.parameter_names:
            raise KeyError(name)
        entry: dict[str, Any] = self._mechanism._reported_parameters()[name]
        return entry

    def __iter__(self) -> Iterator[str]:
        return iter(self._mechanism.parameter_names)

    def __len__(self) -> int:
        return len(self._mechanism.parameter_names)

    def __contains__(self, name: object) -> bool:
        return name in self._mechanism.parameter_names

    def __repr__(self) -> str:
        return f"<kinestat.Parameters: {', '.join(self)}>"


class Mechanism:
    """A mechanism file with the values of its parameters; load and parse create it.

    One thread at a time uses an object, others wait; use one object per thread to work in
    parallel."""

    def __init__(self, handle: Handle, name: str, messages: list[Message]) -> None:
        self._handle = handle
        self._name = name
        self._reported: dict[str, Any] | None = None
        self.messages = messages
        """Warnings of the last load or set."""
        self.parameter_names = self._names(0)
        """In the order of the file."""
        self.actuators = self._names(1)
        """In the order of the file."""
        self.cases = self._names(2)
        """Labels of the cases of the file, then those of its gears."""

    def _names(self, kind: int) -> tuple[str, ...]:
        result: list[str] = []
        while True:
            name = library.kinestat_name(self._handle.pointer, kind, len(result))
            if name is None:
                return tuple(result)
            result.append(text_of(name))

    def set(self, name: str, value: Value) -> None:
        """Sets a parameter from now on, as `kinestat analyze --set` does.

        The value is a number, or a text: a number with a unit, or an expression of other parameters
        ("24", "20 deg", "2*N1"). If it is refused, the parameter keeps its value, and UsageError
        gives the reason. analyze and record check whether the value suits the mechanism, since other
        parameters may have to change with it. Existing reports and tapes do not change."""
        with self._handle.lock:
            messages = call(
                library.kinestat_set, self._handle.pointer,
                c_text(name, "the name of a parameter"),
                c_text(value_text(value), "the value of a parameter"),
            )
            self.messages = messages
            self._reported = None
        warn(messages)

    @property
    def parameters(self) -> Parameters:
        """The parameters as a mapping, to read and set."""
        return Parameters(self)

    def analyze(self, check: bool = False) -> Report:
        """The report of all cases.

        A report that does not match a published value, which is normal after parameters were set, or
        a case without an answer raises nothing: the status of the report says so, its messages are
        issued as warnings, and everything else is reported. With `check`, as in subprocess.run, they
        raise CheckFailed or NoAnswer, which contain the report."""
        report = self._analyze()
        if check:
            report.check()
        warn(report.messages)
        return report

    def _analyze(self) -> Report:
        pointer = c_void_p()
        with self._handle.lock:
            status = library.kinestat_analyze(self._handle.pointer, byref(pointer))
            messages = last_messages()
            if not pointer:
                raise error_of(status, messages)
            text = text_of(library.kinestat_message_text()).rstrip("\n")
            return Report(Handle(pointer, "kinestat_free_report"), status, messages, text)

    def _reported_parameters(self) -> dict[str, Any]:
        with self._handle.lock:
            if self._reported is None:
                self._reported = self._analyze().to_dict()["mechanism"]["parameters"]
            return self._reported

    def record(
        self,
        inputs: str | Iterable[str],
        outputs: str | Iterable[str] | None = None,
        case: str | None = None,
    ) -> Tape:
        """Records one case for many values of its inputs, which are parameters of the file.

        Parameters that depend on the inputs change with them, all others keep their present values.
        Outputs are the names that `report` of a section `sweep` accepts: "ratio", "torque_ratio",
        "efficiency", "recirculation", actuators (their action), "COUPLING.FREEDOM" ("a.wz", the
        motion of the head relative to the tail) and "COUPLING.ACTION" ("h.Rc", of the tail on the
        head); without them, the default outputs of a sweep. `case` is a label; without it, the only
        case of the file. The less you request, the faster: a ratio needs no forces."""
        input_names = [inputs] if isinstance(inputs, str) else list(inputs)
        output_names = [outputs] if isinstance(outputs, str) else list(outputs or ())
        input_list = (c_char_p * len(input_names))(*[c_text(n, "an input") for n in input_names])
        output_list = (c_char_p * len(output_names))(
            *[c_text(name, "an output") for name in output_names]
        )
        label = None if case is None else c_text(case, "the label of a case")
        pointer = c_void_p()
        with self._handle.lock:
            messages = call(
                library.kinestat_record, self._handle.pointer, label, input_list, len(input_names),
                output_list if output_names else None, len(output_names), byref(pointer),
            )
        tape = Tape(Handle(pointer, "kinestat_free_tape"), input_names, messages)
        warn(messages)
        return tape

    def __repr__(self) -> str:
        return f"<kinestat.Mechanism: {self._name}>"


def load(path: str | os.PathLike[str], /, **parameters: Value) -> Mechanism:
    """Reads a mechanism file and sets parameters, one after the other.

        kinestat.load("ravigneaux.yaml", N1=20, alpha="22.5 deg")

    Raises EnvironmentFailure if the file cannot be read, WrongInput if it is wrong, and UsageError if
    it has no such parameter, or the value has another dimension."""
    name = os.fspath(path)
    pointer = c_void_p()
    messages = call(library.kinestat_read_file, c_text(name, "the path"), byref(pointer))
    mechanism = Mechanism(Handle(pointer, "kinestat_free_mechanism"), name, messages)
    warn(messages)
    mechanism.parameters.update(parameters)
    return mechanism


def parse(text: str, name: str = "<text>") -> Mechanism:
    """Reads the text of a mechanism file; `name` stands for the path in messages and reports."""
    data = text.encode()
    pointer = c_void_p()
    messages = call(
        library.kinestat_read_text, data, len(data), c_text(name, "the name of the text"),
        byref(pointer),
    )
    mechanism = Mechanism(Handle(pointer, "kinestat_free_mechanism"), name, messages)
    warn(messages)
    return mechanism
