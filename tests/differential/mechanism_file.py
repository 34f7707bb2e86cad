"""A mechanism file as a tree of texts, every scalar as typed, to be changed and written."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Callable, Iterator

import yaml

Tree = dict | list | str

# Units in SI and their powers of length and time; angles count as numbers.
UNITS = {"m": (1.0, 1, 0), "mm": (1e-3, 1, 0), "cm": (1e-2, 1, 0), "um": (1e-6, 1, 0),
         "km": (1e3, 1, 0), "in": (0.0254, 1, 0), "s": (1.0, 0, 1), "min": (60.0, 0, 1),
         "h": (3600.0, 0, 1), "rad": (1.0, 0, 0), "deg": (math.pi / 180, 0, 0),
         "rev": (2 * math.pi, 0, 0), "rpm": (math.pi / 30, 0, -1), "N": (1.0, 1, -2),
         "kN": (1e3, 1, -2), "Nm": (1.0, 2, -2), "kg": (1.0, 0, 0), "g": (1e-3, 0, 0),
         "W": (1.0, 2, -3), "kW": (1e3, 2, -3)}


# A number and the units behind it.
_NUMBER = re.compile(r"(?<![\w.])(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+)"
                     r"(\s*[A-Za-z]\w*(?:\*\*\d+)?(?:[*/][A-Za-z]\w*(?:\*\*\d+)?)*)?")


class Quantity:
    """A number with powers of length and time, for the operators of the file's expressions."""

    def __init__(self, value: float, length: float = 0, time: float = 0) -> None:
        self.value, self.length, self.time = float(value), length, time

    @property
    def is_bare(self) -> bool:
        return self.length == 0 and self.time == 0

    @staticmethod
    def of(other: "Quantity | float") -> "Quantity":
        return other if isinstance(other, Quantity) else Quantity(other)

    def _like(self, value: float) -> "Quantity":
        return Quantity(value, self.length, self.time)

    def __mul__(self, other: "Quantity | float") -> "Quantity":
        o = self.of(other)
        return Quantity(self.value * o.value, self.length + o.length, self.time + o.time)

    def __truediv__(self, other: "Quantity | float") -> "Quantity":
        o = self.of(other)
        return Quantity(self.value / o.value, self.length - o.length, self.time - o.time)

    def __pow__(self, other: "Quantity | float") -> "Quantity":
        power = self.of(other).value
        return Quantity(self.value ** power, self.length * power, self.time * power)

    def __add__(self, other: "Quantity | float") -> "Quantity":
        return self._like(self.value + self.of(other).value)

    def __sub__(self, other: "Quantity | float") -> "Quantity":
        return self._like(self.value - self.of(other).value)

    def __neg__(self) -> "Quantity":
        return self._like(-self.value)

    def __pos__(self) -> "Quantity":
        return self


def _function(real: Callable[..., float], keeps: bool = False) -> Callable[..., Quantity]:
    def apply(*arguments: Quantity | float) -> Quantity:
        quantities = [Quantity.of(a) for a in arguments]
        value = real(*(q.value for q in quantities))
        return quantities[0]._like(value) if keeps else Quantity(value)
    return apply


FUNCTIONS = {
    **{name: _function(getattr(math, name)) for name in
       ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log10")},
    "ln": _function(math.log), "log": _function(math.log),
    **{name: _function(real, keeps=True) for name, real in
       (("abs", abs), ("min", min), ("max", max), ("floor", math.floor), ("ceil", math.ceil),
        ("round", round), ("mod", lambda a, b: a - b * math.floor(a / b)), ("hypot", math.hypot),
        ("gcd", lambda a, b: math.gcd(int(a), int(b))))},
    "sqrt": lambda q: Quantity.of(q) ** 0.5,
    "pi": Quantity(math.pi),
}


class MechanismFile:
    """`tree` may be changed freely; `text` writes it."""

    def __init__(self, source: str) -> None:
        self.tree: dict = yaml.load(source, Loader=yaml.BaseLoader)
        self.tree.pop("published", None)  # values of one drawing only
        self._parameters = {k: v["free"] if isinstance(v, dict) else v
                            for k, v in (self.tree.get("parameters") or {}).items()}

    @staticmethod
    def read(path: Path) -> "MechanismFile":
        return MechanismFile(path.read_text(encoding="utf-8"))

    @property
    def is_planar(self) -> bool:
        return self.tree.get("space") == "planar"

    @property
    def length_unit(self) -> str:
        return (self.tree.get("units") or {}).get("length", "m")

    @property
    def time_unit(self) -> str:
        return (self.tree.get("units") or {}).get("time", "s")

    def evaluate(self, text: str) -> Quantity:
        """Names behind a number are units, others parameters and functions."""
        source = _NUMBER.sub(lambda m: "_q(" + m[1] + ")" + self._units(m[2] or ""),
                             text.strip().replace("^", "**"))
        names = {name: self.evaluate(self._parameters[name])
                 for name in set(re.findall(r"[A-Za-z_]\w*", source)) & set(self._parameters)}
        return Quantity.of(eval(  # noqa: S307 - files of the repository
            source, {"__builtins__": {}}, {**FUNCTIONS, **names, "_q": Quantity}))

    def _units(self, text: str) -> str:
        """Of `mm/s^2` the factor, as an expression."""
        def quantity(match: re.Match) -> str:
            name = match[0]
            if name in self._parameters or name not in UNITS:
                return name
            return "_q({!r}, {}, {})".format(*UNITS[name])
        return "*" + re.sub(r"[A-Za-z_]\w*", quantity, text.strip()) if text.strip() else ""

    def couplings(self) -> Iterator[tuple[str, dict]]:
        yield from (self.tree.get("couplings") or {}).items()

    def text(self) -> str:
        return written(self.tree) + "\n"


def written(tree: Tree) -> str:
    if isinstance(tree, dict):
        return "{" + ", ".join(f"{json.dumps(k)}: {written(v)}" for k, v in tree.items()) + "}"
    if isinstance(tree, list):
        return "[" + ", ".join(map(written, tree)) + "]"
    is_plain = re.fullmatch(r"true|false|[+-]?\d+(\.\d+)?|", tree)
    return (tree or "null") if is_plain else json.dumps(tree, ensure_ascii=False)
