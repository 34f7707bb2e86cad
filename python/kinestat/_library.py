"""The shared library, found and declared as kinestat.h has it."""

from __future__ import annotations

import ctypes
import ctypes.util
import os
import threading
import weakref
from ctypes import POINTER, c_char_p, c_double, c_int, c_size_t, c_void_p
from pathlib import Path
from typing import Any, Iterator, NoReturn

VARIABLE = "KINESTAT_LIBRARY"
NAMES = ("libkinestat.so.0", "libkinestat.so", "libkinestat.dylib")


class RawMessage(ctypes.Structure):
    """kinestat_message."""

    _fields_ = [
        ("is_error", c_int),
        ("code", c_char_p),
        ("text", c_char_p),
        ("hint", c_char_p),
        ("file", c_char_p),
        ("line", c_int),
        ("column", c_int),
        ("length", c_int),
    ]


# Handles are c_void_p, statuses of states too: their texts are read later, a word once.
FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "kinestat_version": (c_char_p, []),
    "kinestat_read_file": (c_int, [c_char_p, POINTER(c_void_p)]),
    "kinestat_read_text": (c_int, [c_char_p, c_size_t, c_char_p, POINTER(c_void_p)]),
    "kinestat_free_mechanism": (None, [c_void_p]),
    "kinestat_set": (c_int, [c_void_p, c_char_p, c_char_p]),
    "kinestat_name": (c_char_p, [c_void_p, c_int, c_size_t]),
    "kinestat_analyze": (c_int, [c_void_p, POINTER(c_void_p)]),
    "kinestat_free_report": (None, [c_void_p]),
    "kinestat_json": (c_char_p, [c_void_p]),
    "kinestat_number": (c_int, [c_void_p, c_char_p, POINTER(c_double)]),
    "kinestat_record": (
        c_int,
        [c_void_p, c_char_p, POINTER(c_char_p), c_size_t, POINTER(c_char_p), c_size_t,
         POINTER(c_void_p)],
    ),
    "kinestat_free_tape": (None, [c_void_p]),
    "kinestat_output_count": (c_size_t, [c_void_p]),
    "kinestat_output_name": (c_char_p, [c_void_p, c_size_t]),
    "kinestat_output_unit": (c_char_p, [c_void_p, c_size_t]),
    "kinestat_input_unit": (c_char_p, [c_void_p, c_size_t]),
    "kinestat_play": (c_int, [c_void_p, c_void_p, c_size_t, c_void_p, c_void_p]),
    "kinestat_is_played": (c_int, [c_void_p]),
    "kinestat_message_count": (c_size_t, []),
    "kinestat_message_at": (c_int, [c_size_t, POINTER(RawMessage)]),
    "kinestat_message_text": (c_char_p, []),
}


def _candidates() -> Iterator[str]:
    """Where the library may be: beside the package, in the folders `lib` above it (an unpacked
    archive, the build of a source tree), and where the system looks."""
    package = Path(__file__).resolve().parent
    folders = [package]
    for parent in list(package.parents)[:4]:
        folders += [parent / "lib", parent / "lib64", parent / "build" / "release" / "lib"]
    for folder in folders:
        for name in NAMES:
            if (folder / name).is_file():
                yield str(folder / name)
    yield from NAMES
    found = ctypes.util.find_library("kinestat")
    if found:
        yield found


def _open(path: str) -> ctypes.CDLL:
    opened = ctypes.CDLL(path)
    for name, (result, arguments) in FUNCTIONS.items():
        try:
            function = getattr(opened, name)
        except AttributeError:
            raise ImportError(
                f"'{path}' has no function '{name}', so it is no kinestat library, or one of another "
                "version than this package; install both of the same version"
            ) from None
        function.restype = result
        function.argtypes = arguments
    return opened


def _find() -> ctypes.CDLL:
    chosen = os.environ.get(VARIABLE)
    if chosen:
        try:
            return _open(chosen)
        except OSError as problem:
            raise ImportError(
                f"{VARIABLE} is '{chosen}', which cannot be loaded: {problem}; let it name the file "
                f"{NAMES[0]}, or unset it to search the usual places"
            ) from None
    for path in _candidates():
        try:
            return _open(path)
        except OSError as problem:
            if os.path.isfile(path):
                raise ImportError(f"'{path}' cannot be loaded: {problem}") from None
    raise ImportError(
        f"the shared library of kinestat is not found; install the package of kinestat, or set the "
        f"environment variable {VARIABLE} to the path of {NAMES[0]}, in a source tree "
        f"build/release/lib/{NAMES[0]}"
    )


library: ctypes.CDLL = _find()


class Handle:
    """An object of the library, freed with this one. The library lets one thread at a time use an
    object: whoever calls with it holds the lock."""

    def __init__(self, pointer: c_void_p, free: str) -> None:
        self.pointer = pointer
        self.lock = threading.RLock()
        weakref.finalize(self, getattr(library, free), pointer)

    def __reduce__(self) -> NoReturn:
        raise TypeError("mechanisms, reports and tapes cannot be pickled or copied deeply; let each "
                        "process load the mechanism itself")


def c_text(text: str, what: str) -> bytes:
    """A text for the library, in which a null would be the end."""
    if not isinstance(text, str):
        raise TypeError(f"{what} is a text, not {type(text).__name__}")
    if "\0" in text:
        raise ValueError(f"{what} contains a null character")
    return text.encode("utf-8", "surrogateescape")


def text_of(data: bytes | None) -> str:
    return "" if data is None else data.decode("utf-8", "replace")
