"""A case of davies.json as a mechanism file, and its names and magnitudes as those of the program.

The reference takes axes as they are given, the program normalises them: magnitudes along an axis
are multiplied by its length. The reference frees a cable by a rotation and a translation at its
middle, the program by rotations about its two ends; and its forces are along the axis as given,
those of the program are tensions.
"""

from __future__ import annotations

import json
import re
from fractions import Fraction
from pathlib import Path

DOCUMENT = json.loads((Path(__file__).parent / "davies.json").read_text(encoding="utf-8"))
CASES = {case["id"]: case for case in DOCUMENT["cases"]}
TABLES = DOCUMENT["tables"]

TYPES = {"R": "revolute", "P": "prismatic", "C": "cylindrical", "S": "spherical",
         "U": "universal", "G": "gear", "TQ": "revolute", "CABLE": "cable"}


def expression(text: object) -> str:
    """Fractions and functions of degrees are expressions of the file."""
    return re.sub(r"(\d)deg", r"\1 deg", str(text))


def number(text: object) -> float:
    return float(Fraction(str(text)))


def vector(components: list) -> str:
    return "[" + ", ".join(expression(c) for c in components) + "]"


def axis_of(components: list) -> str:
    """A keyword along a world axis, so that the names are those of the reference."""
    for letter, unit in (("x", ["1", "0", "0"]), ("y", ["0", "1", "0"]), ("z", ["0", "0", "1"])):
        if components == unit:
            return letter
    return vector(components)


def length(axis: list) -> float:
    return sum(number(x) ** 2 for x in axis) ** 0.5


def dot(first: list, second: list) -> Fraction:
    return sum(Fraction(str(a)) * Fraction(str(b)) for a, b in zip(first, second))


class ReferenceCase:
    """The couplings and bodies of one case, and the file that says the same."""

    def __init__(self, case: dict) -> None:
        self.id = case["id"]
        self.expected = case["expected"]
        self.is_planar = case["lambda"] == 3
        self.bodies = case["bodies"]
        self.couplings = {coupling["name"]: coupling for coupling in case["couplings"]}

    def text(self, cases: str = "", head: str = "") -> str:
        """The mechanism file; `cases` are lines of its section `cases`."""
        bodies = ", ".join(self.body(b) for b in self.bodies[1:])
        lines = ["kinestat: 1", f"space: {'planar' if self.is_planar else 'spatial'}",
                 f"ground: {self.body(self.bodies[0])}", f"bodies: [{bodies}]", "couplings:"]
        lines += [self._line(coupling) for coupling in self.couplings.values()]
        actuators = [f"  {name}_{active['name']}: {{coupling: {name}}}"
                     for name, coupling in self.couplings.items()
                     for active in coupling.get("active", [])]
        lines += ["actuators:", *actuators] if actuators else []
        lines += ["cases:", cases] if cases else []
        return head + "\n".join(lines) + "\n"

    @staticmethod
    def body(name: object) -> str:
        return f"body_{name}"

    def _line(self, coupling: dict) -> str:
        size = 2 if self.is_planar else 3
        kind = coupling["type"]
        parts = [f"type: {TYPES[kind]}",
                 f"bodies: [{self.body(coupling['tail'])}, {self.body(coupling['head'])}]"]
        if kind == "CABLE":
            ends = self.cable_ends(coupling["name"])
            parts += [f"{key}: {vector(end[:size])}" for key, end in zip(("from", "to"), ends)]
        else:
            parts.append(f"at: {vector(coupling['point'][:size])}")
        if kind in "RCG" or kind == "TQ":
            parts += [] if self.is_planar else [f"axis: {axis_of(coupling['axis'])}"]
        elif kind == "P":
            axis = axis_of(coupling["axis"])
            parts.append(f"axis: {axis if len(axis) == 1 else vector(coupling['axis'][:size])}")
        elif kind == "U":
            parts.append(f"axes: [{axis_of(coupling['axis'])}, {axis_of(coupling['axis2'])}]")
        if kind == "G":
            parts.append(f"line_of_action: {vector(coupling['normal'][:size])}")
        if kind == "TQ":
            parts.append("passive: []")
        return f"  {coupling['name']}: {{{', '.join(parts)}}}"

    def cable_ends(self, name: str) -> tuple[list, list]:
        """Two points of its line, the first on the side of the tail."""
        coupling = self.couplings[name]
        axis, point = coupling["axis"], coupling["point"]
        on_head = self._along(coupling["head"], axis)
        on_tail = self._along(coupling["tail"], axis)
        side = -1 if on_head is None or (on_tail is not None and on_tail > on_head) else 1
        if on_tail is None and on_head is not None:
            side = 1 if on_head > dot(point, axis) else -1
        ends = [[Fraction(p) + sign * side * Fraction(a) for p, a in zip(point, axis)]
                for sign in (-1, 1)]
        return ends[0], ends[1]

    def _along(self, body: object, axis: list) -> Fraction | None:
        """Where a moving body is in a direction, by its first bearing."""
        if body == self.bodies[0]:
            return None
        for coupling in self.couplings.values():
            if coupling["type"] != "CABLE" and coupling["head"] == body:
                return dot(coupling["point"], axis)
        return None

    def freedom(self, label: str) -> str:
        """a.w is a.wz or, along a vector, a.w; an engaging coupling of the reference turns too."""
        name, kind = (label.split(".") + ["w"])[:2]
        axis = axis_of(self.couplings[name]["axis"])
        return f"{name}.{kind}{axis if len(axis) == 1 else ''}"

    def is_active(self, label: str) -> bool:
        name, action = label.split(".")
        return action in [active["name"] for active in self.couplings[name].get("active", [])]

    def action(self, label: str) -> str:
        name, action = label.split(".")
        if self.is_active(label):
            return f"{name}_{action}"
        return f"{name}.F" if self.couplings[name]["type"] == "CABLE" else label

    def rate(self, label: str, freedoms: dict) -> float:
        """The rate of the reference, from the rates of the program."""
        coupling = self.couplings[label.split(".")[0]]
        if coupling["type"] != "CABLE":
            return freedoms[self.freedom(label)] / length(coupling["axis"])
        first, second = (freedoms[f"{coupling['name']}.w{i}"] for i in (1, 2))
        if label.endswith(".w2"):
            return first + second
        from_, to = self.cable_ends(coupling["name"])
        half = [float(b - a) / 2.0 for a, b in zip(from_, to)]
        # At the middle, a rate w about an end is w z x (middle - end); along (y, -x) of the axis.
        velocity = [(second - first) * half[1], (first - second) * half[0]]
        across = [number(coupling["axis"][1]), -number(coupling["axis"][0])]
        return velocity[0] * across[0] + velocity[1] * across[1]

    def action_value(self, label: str, actions: dict) -> float:
        """The action of the reference, from the actions of the program."""
        coupling = self.couplings[label.split(".")[0]]
        actual = actions[self.action(label)]
        if coupling["type"] != "CABLE":
            return actual
        from_, to = self.cable_ends(coupling["name"])
        pull = dot([a - b for a, b in zip(from_, to)], coupling["axis"])
        return actual if pull > 0 else -actual

    def motion(self, label: str, primary: dict, more: str = "") -> str:
        """A case that knows motions, as a line of the section `cases`."""
        known = [f"{self.freedom(k)}: {self._scaled(k, v)}" for k, v in primary.items()]
        return f"  {label}: {{motion: {{{', '.join(known)}}}{more}}}"

    def actions(self, label: str, primary: dict, more: str = "") -> str:
        known = [f"{self.action(k)}: {v}" for k, v in primary.items()]
        return f"  {label}: {{action: {{{', '.join(known)}}}{more}}}"

    def _scaled(self, label: str, value: object) -> str:
        scale = length(self.couplings[label.split(".")[0]]["axis"])
        return str(value) if scale == 1.0 else repr(number(value) * scale)
