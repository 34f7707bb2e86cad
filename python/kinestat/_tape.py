"""Recorded cases, evaluated for many states."""

from __future__ import annotations

from ctypes import addressof, c_char_p, c_double, c_void_p, cast, sizeof
from typing import TYPE_CHECKING, Any, Mapping, Sequence, Union

from . import _numbers
from ._library import Handle, library, text_of
from ._messages import Message, call, warn

if TYPE_CHECKING:
    import numpy
    import pandas
    from numpy.typing import ArrayLike, NDArray

    Table = NDArray[numpy.float64]  # without NumPy: List[List[float]]
    States = Union[ArrayLike, Mapping[str, ArrayLike], pandas.DataFrame]

# States for one call of the library, between which Ctrl-C is heard.
STATES_A_CALL = 4096


class Tape:
    """The recorded solution of one case, to be evaluated for many values of its inputs;
    Mechanism.record creates it, and it no longer needs the mechanism.

        tape = train.record(["N1", "N5"], ["ratio", "out"], case="M1")
        tape.play([[19, 15], [20, 16]])                 # one row per state
        tape.play({"N1": [19, 20, 21], "N5": 15})       # or one vector per input
        tape(N1=19, N5=15)["ratio"]                     # or one state

    Outputs equal those of an analysis of each state, except for rounding. A state for which the
    recording is not valid is analysed again, which takes thousands of times longer. One thread at a
    time uses a tape, others wait; to use several threads, record one tape per thread."""

    def __init__(self, handle: Handle, inputs: Sequence[str], messages: list[Message]) -> None:
        self._handle = handle
        pointer = handle.pointer
        self.inputs = tuple(inputs)
        """Names of the parameters, in the order of the columns that play expects."""
        self.outputs = tuple(
            text_of(library.kinestat_output_name(pointer, output))
            for output in range(library.kinestat_output_count(pointer))
        )
        """Names of the columns that play returns."""
        self.input_units = tuple(
            text_of(library.kinestat_input_unit(pointer, at)) for at in range(len(self.inputs))
        )
        """Units of the inputs; "" is a bare number."""
        self.output_units = tuple(
            text_of(library.kinestat_output_unit(pointer, at)) for at in range(len(self.outputs))
        )
        """Units of the outputs; "" is a bare number."""
        self.messages = messages
        """Warnings of the recording, then those of the last call of play."""
        self._words: Any = (c_void_p * 0)()
        self._statuses: Any = None

    def play(self, states: States, out: Any = None) -> Table:
        """The outputs of each state, one row per state, in the order of `outputs`.

        `states` is an array of states x inputs; or a mapping with a vector or a number for each
        input, where a number applies to every state; or a data frame with a column for each input,
        and possibly others. A plain vector is taken as states if the tape has one input; an
        array.array is read row by row. Numbers are in `input_units`; all must be finite, or
        UsageError is raised.

        With NumPy the result is an array of float64, without it a list of rows. An input array of
        float64 that is C-contiguous is not copied. `out`, a writable C-contiguous array of float64
        (or an array.array of typecode "d"), receives the outputs and is returned.

        NaN is an output without a value; `statuses` then gives the reason, and nothing is raised."""
        given = _numbers.inputs_of(states, self.inputs)
        room = _numbers.Outputs(given.states, len(self.outputs), out)
        words = (c_void_p * given.states)()
        messages: list[Message] = []
        with self._handle.lock:
            for begin in range(0, given.states, STATES_A_CALL):
                messages += call(
                    library.kinestat_play, self._handle.pointer,
                    given.address + begin * len(self.inputs) * sizeof(c_double),
                    min(STATES_A_CALL, given.states - begin),
                    room.address + begin * len(self.outputs) * sizeof(c_double),
                    addressof(words) + begin * sizeof(c_void_p),
                )
            self._words = words
            self._statuses = None
            self.messages = messages
        warn(messages)
        table: Table = room.table()
        return table

    def __call__(self, /, **inputs: float) -> dict[str, float]:
        """The outputs of one state, by name; NaN where `statuses[0]` says why there is no value."""
        given = _numbers.inputs_of(inputs, self.inputs)
        if given.states != 1:
            raise ValueError("a call takes one number for each input; 'play' takes several states")
        row = self.play(inputs)[0]
        return {name: float(value) for name, value in zip(self.outputs, row)}

    @property
    def statuses(self) -> Any:
        """A word for each state of the last play: "solved", or the reason why it is not ("locked",
        "no_ratio", "singular", an error code; `kinestat help sweeps` lists them). With NumPy this is
        an array, so that `tape.statuses == "solved"` is a mask; without it a list."""
        if self._statuses is None:
            self._statuses = self._read_statuses()
        return self._statuses

    def _read_statuses(self) -> Any:
        numpy = _numbers.numpy
        if numpy is None or not len(self._words):
            known = {address: _word(address) for address in set(self._words)}
            words = [known[address] for address in self._words]
            return words if numpy is None else numpy.array(words, dtype=str)
        addresses = numpy.frombuffer(self._words, dtype=numpy.uintp)
        different, which = numpy.unique(addresses, return_inverse=True)
        return numpy.array([_word(int(address)) for address in different], dtype=str)[which]

    @property
    def is_played(self) -> bool:
        """Whether states are evaluated from the recording; if no tape can be made of the case, each
        state is analysed instead. Known after the first play."""
        return bool(library.kinestat_is_played(self._handle.pointer))

    def frame(self, states: States) -> pandas.DataFrame:
        """Evaluates the states; returns a pandas.DataFrame of inputs, outputs and "status", one row
        per state.

        Columns have the names of inputs and outputs; an output with the name of an input has
        " (output)" appended. `frame.attrs["units"]` has the unit of each numeric column."""
        import numpy
        import pandas

        given = _numbers.inputs_of(states, self.inputs)
        rows = numpy.array(given.memory, dtype=numpy.float64)  # a copy, for a frame may be changed
        table = self.play(rows)
        outputs = [f"{name} (output)" if name in self.inputs else name for name in self.outputs]
        columns = dict(zip(self.inputs, rows.T))
        columns.update(zip(outputs, table.T))
        frame = pandas.DataFrame({**columns, "status": self.statuses})
        frame.attrs["units"] = dict(zip(
            [*self.inputs, *outputs], [*self.input_units, *self.output_units]
        ))
        return frame

    def __repr__(self) -> str:
        return f"<kinestat.Tape: {', '.join(self.inputs)} -> {', '.join(self.outputs)}>"


def _word(address: int) -> str:
    return text_of(cast(address, c_char_p).value)
