"""Tables of numbers, with NumPy and without."""

from __future__ import annotations

from array import array
from ctypes import addressof, c_double
from typing import Any, Mapping, Sequence

try:
    import numpy as numpy
except ImportError:
    numpy = None  # type: ignore[assignment]


class Inputs:
    """The inputs of so many states, state after state in memory: at `address`, as long as this
    lives."""

    def __init__(self, states: int, address: int, memory: Any) -> None:
        self.states = states
        self.address = address
        self.memory = memory  # what the address is of


def _shape_problem(got: str, names: Sequence[str]) -> ValueError:
    return ValueError(
        f"the inputs are {got}; a row for each state is needed, with {len(names)} "
        f"number{'s' if len(names) != 1 else ''}: {', '.join(names)}"
    )


def _checked_names(columns: Mapping[str, Any], names: Sequence[str]) -> None:
    missing = [name for name in names if name not in columns]
    surplus = [name for name in columns if name not in names]
    if missing or surplus:
        problem = f"inputs {', '.join(missing)} are missing" if missing else ""
        if surplus:
            problem += ("; " if problem else "") + f"{', '.join(map(str, surplus))} are no inputs"
        raise ValueError(f"{problem}; the inputs of the tape are {', '.join(names)}")


def _numpy_inputs(given: Any, names: Sequence[str]) -> Inputs:
    if isinstance(given, Mapping):
        _checked_names(given, names)
        columns = numpy.broadcast_arrays(
            *[numpy.asarray(given[name], dtype=numpy.float64) for name in names]
        )
        if columns[0].ndim > 1:
            raise ValueError("an input is one number, or a vector with one for each state")
        rows = numpy.stack([numpy.atleast_1d(column) for column in columns], axis=1)
    else:
        rows = numpy.asarray(given, dtype=numpy.float64)
        if rows.ndim == 1 and (len(names) == 1 or isinstance(given, array)):
            if rows.size % len(names) != 0:
                raise _shape_problem(f"{rows.size} numbers", names)
            rows = rows.reshape(-1, len(names))
        if rows.ndim == 1 and rows.size == 0:
            rows = rows.reshape(0, len(names))
        if rows.ndim != 2 or rows.shape[1] != len(names):
            raise _shape_problem(f"an array of shape {rows.shape}", names)
    rows = numpy.ascontiguousarray(rows)
    return Inputs(rows.shape[0], rows.ctypes.data, rows)


def _plain_columns(given: Mapping[str, Any], names: Sequence[str]) -> list[float]:
    _checked_names(given, names)
    columns = [
        list(given[name]) if hasattr(given[name], "__iter__") else [given[name]] for name in names
    ]
    lengths = {len(column) for column in columns} - {1}
    if len(lengths) > 1:
        raise ValueError(f"the inputs have {' and '.join(map(str, sorted(lengths)))} states")
    states = lengths.pop() if lengths else 1
    columns = [column * states if len(column) == 1 else column for column in columns]
    return [float(column[state]) for state in range(states) for column in columns]


def _plain_inputs(given: Any, names: Sequence[str]) -> Inputs:
    if isinstance(given, Mapping):
        flat = _plain_columns(given, names)
    elif isinstance(given, array) or (
        len(names) == 1 and not any(hasattr(number, "__iter__") for number in given)
    ):
        flat = [float(number) for number in given]
        if len(flat) % len(names) != 0:
            raise _shape_problem(f"{len(flat)} numbers", names)
    else:
        flat = []
        for row in given:
            numbers = [float(number) for number in row] if hasattr(row, "__iter__") else [float(row)]
            if len(numbers) != len(names):
                raise _shape_problem(f"a row of {len(numbers)}", names)
            flat += numbers
    memory = (c_double * len(flat))(*flat)
    return Inputs(len(flat) // len(names), addressof(memory), memory)


def inputs_of(given: Any, names: Sequence[str]) -> Inputs:
    """The inputs as the library takes them; an array that is so already is not copied. Of a data
    frame the columns count by their names, and it may have others."""
    if hasattr(given, "columns"):
        given = {name: given[name] for name in names if name in given.columns}
    return _plain_inputs(given, names) if numpy is None else _numpy_inputs(given, names)


class Outputs:
    """Room for the outputs of so many states, state after state; of the caller's if there is."""

    def __init__(self, states: int, count: int, given: Any) -> None:
        self._states = states
        self._count = count
        self._given = given
        if given is not None:
            view = memoryview(given)
            if view.format != "d" or not view.c_contiguous or view.readonly:
                raise ValueError("'out' is not an array of float64, C-contiguous and writable")
            if view.nbytes != 8 * states * count or (view.ndim > 1 and view.shape != (states, count)):
                raise ValueError(f"'out' needs {states} rows of {count}")
            self._memory: Any = (c_double * (states * count)).from_buffer(given) if states else view
            self.address = addressof(self._memory) if states else 0
        elif numpy is not None:
            self._memory = numpy.empty((states, count))
            self.address = self._memory.ctypes.data
        else:
            self._memory = (c_double * (states * count))()
            self.address = addressof(self._memory)

    def table(self) -> Any:
        if self._given is not None:
            return self._given
        if numpy is not None:
            return self._memory
        flat = list(self._memory)
        return [flat[at * self._count:(at + 1) * self._count] for at in range(self._states)]
