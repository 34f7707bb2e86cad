"""A mechanism as drawn, in fractions: its screws, and its file.

Oblique axes have integer lengths, such as (3, 4) or (1, 2, 2), so that all numbers of the unit screws
are fractions.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Sequence

Vector = list[Fraction]
Screw = tuple[str, Vector]
LETTERS = "xyz"

# Per type, with its axis along z: axes of turns and slides left free.
FREE = {
    "revolute": ("z", ""), "prismatic": ("", "z"), "cylindrical": ("z", "z"),
    "spherical": ("xyz", ""), "planar": ("z", "xy"), "point_contact": ("xyz", "xy"),
    "sphere_in_tube": ("xyz", "z"), "rigid": ("", ""),
}
# In the plane, with the axis, slot or normal along x.
FREE_IN_PLANE = {
    "revolute": ("z", ""), "prismatic": ("", "x"), "pin_in_slot": ("z", "x"),
    "point_contact": ("z", "y"), "gear": ("z", ""), "rigid": ("", ""),
}


def cross(a: Sequence[Fraction], b: Sequence[Fraction]) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(vector: Sequence[int]) -> Vector:
    """Of whole length."""
    square = sum(x * x for x in vector)
    size = next(n for n in range(1, square + 1) if n * n >= square)
    if size * size != square:
        raise ValueError(f"{vector} has no whole length")
    return [Fraction(x, size) for x in vector]


def number(value: Fraction) -> str:
    """As a decimal if that is exact, else as a fraction."""
    scaled = value * 1000
    if scaled.denominator != 1:
        return f"{value.numerator}/{value.denominator}"
    return str(value.numerator) if value.denominator == 1 else repr(float(value))


def vector(components: Sequence[Fraction], is_planar: bool) -> str:
    return "[" + ", ".join(number(Fraction(c)) for c in components[:2 if is_planar else 3]) + "]"


@dataclass
class Coupling:
    """`axis` is a letter, or whole numbers: the axis, slot, normal or line of action of the type."""

    name: str
    type: str
    tail: str
    head: str
    at: Vector
    axis: str | tuple[int, ...] = "z"
    is_planar: bool = False
    to: Vector | None = None  # of a cable: its other end

    @property
    def is_named_by_world(self) -> bool:
        return isinstance(self.axis, str)

    def _frame(self) -> dict[str, Vector]:
        """The directions by letters of FREE; for world axes with the names of these."""
        if self.type == "cable":
            return {}
        if isinstance(self.axis, str):
            return {}
        along = unit(self.axis)
        if self.is_planar:
            along = [*along[:2], Fraction(0)]
            return {"x": along, "y": [-along[1], along[0], Fraction(0)],
                    "z": [Fraction(0), Fraction(0), Fraction(1)]}
        other = min(range(3), key=lambda i: abs(along[i]))
        helper = [Fraction(i == other) for i in range(3)]
        first = cross(along, helper)
        return {"z": along, "x": first, "y": cross(along, first)}

    def _split(self) -> tuple[list[tuple[str, Vector]], ...]:
        """Turns, slides, forces and couples, each with its name and direction."""
        turns, slides = (FREE_IN_PLANE if self.is_planar else FREE)[self.type]
        letters = {c: c for c in LETTERS}
        frame = self._frame()
        if isinstance(self.axis, str):
            frame = {c: [Fraction(c == d) for d in LETTERS] for c in LETTERS}
            start = 0 if self.is_planar else 2
            turn = LETTERS.index(self.axis) - start
            if not (self.is_planar and self.axis == "z"):
                if self.is_planar:
                    letters = {"x": self.axis, "y": "xy"[1 - LETTERS.index(self.axis)], "z": "z"}
                else:
                    letters = {c: LETTERS[(i + turn) % 3] for i, c in enumerate(LETTERS)}
            frame = {c: frame[letters[c]] for c in LETTERS}
        turning, sliding = ("z", "xy") if self.is_planar else ("xyz", "xyz")
        if turns == "xyz":  # about world axes, however the coupling lies
            return ([(c, [Fraction(c == d) for d in LETTERS]) for c in LETTERS],
                    [(letters[c], frame[c]) for c in slides],
                    [(letters[c], frame[c]) for c in sliding if c not in slides], [])
        return ([(letters[c], frame[c]) for c in turns],
                [(letters[c], frame[c]) for c in slides],
                [(letters[c], frame[c]) for c in sliding if c not in slides],
                [(letters[c], frame[c]) for c in turning if c not in turns])

    def _rotation(self, direction: Vector, point: Vector) -> Vector:
        return [*direction, *cross(point, direction)]

    def _force(self, direction: Vector, point: Vector) -> Vector:
        return [*cross(point, direction), *direction]

    def _suffix(self, letter: str, direction: Vector) -> str:
        """A turn in the plane is about z; along an axis of its own a freedom is w or v."""
        is_about_z = self.is_planar and direction[2] != 0
        return letter if self.is_named_by_world or is_about_z else ""

    def freedoms(self) -> list[Screw]:
        """Twists (turn, velocity at the origin) by name; with a '?' where the direction is not
        that of the program."""
        zero = [Fraction(0)] * 3
        if self.type == "cable":
            about = [Fraction(0), Fraction(0), Fraction(1)]
            return [("w1", self._rotation(about, self.at)), ("w2", self._rotation(about, self.to))]
        turns, slides, _, _ = self._split()
        across = "?" if len(slides) > 1 and not self.is_named_by_world else ""
        about = (lambda c, d: c) if len(turns) == 3 else self._suffix
        return ([(f"w{about(c, d)}", self._rotation(d, self.at)) for c, d in turns]
                + [(f"v{c + across if across else self._suffix(c, d)}", [*zero, *d])
                   for c, d in slides])

    def constraints(self) -> list[Screw]:
        """Wrenches (moment about the origin, force) by name; along axes of their own the names
        are not those of the program, and only the whole wrench can be compared."""
        if self.type == "cable":
            pull = unit([int(a - b) for a, b in zip(self.at, self.to)])
            return [("F", self._force(pull, self.to))]
        if self.type == "gear":
            line = [Fraction(1), Fraction(0), Fraction(0)] if self.axis == "x" else unit(self.axis)
            return [("Rc", self._force([*line[:2], Fraction(0)], self.at))]
        zero = [Fraction(0)] * 3
        _, _, forces, couples = self._split()
        mark = "" if self.is_named_by_world else "?"
        return ([(f"R{c}{mark}", self._force(d, self.at)) for c, d in forces]
                + [(f"T{c}{mark}", [*d, *zero]) for c, d in couples])

    def action_of(self, freedom: str) -> Vector:
        """Of an actuator: a couple about, or a force along, what it drives."""
        twist = dict(self.freedoms())[freedom]
        if freedom.startswith("w"):
            return [*twist[:3], *[Fraction(0)] * 3]
        return self._force(twist[3:], self.at)

    def text(self) -> str:
        parts = [f"type: {self.type}", f"bodies: [{self.tail}, {self.head}]"]
        if self.type == "cable":
            parts += [f"from: {vector(self.at, self.is_planar)}",
                      f"to: {vector(self.to, self.is_planar)}"]
        else:
            parts.append(f"at: {vector(self.at, self.is_planar)}")
        key = {"planar": "normal", "point_contact": "normal", "pin_in_slot": "slot",
               "gear": "line_of_action"}.get(self.type, "axis")
        has_axis = (self.type not in ("rigid", "spherical", "cable")
                    and not (self.is_planar and self.type == "revolute"))
        if has_axis:
            axis = self.axis
            if not isinstance(axis, str):
                axis = vector([Fraction(x) for x in axis], self.is_planar)
            parts.append(f"{key}: {axis}")
        if self.type == "gear":
            parts.append("flank: fixed")  # the exact network has one line of action
        return f"  {self.name}: {{{', '.join(parts)}}}"


@dataclass
class Actuator:
    name: str
    coupling: str
    freedom: str


@dataclass
class Load:
    name: str
    body: str
    at: Vector
    force: Vector
    couple: Vector

    def text(self, is_planar: bool) -> str:
        parts = [f"body: {self.body}"]
        if any(self.force):
            parts += [f"at: {vector(self.at, is_planar)}", f"force: {vector(self.force, is_planar)}"]
        if any(self.couple) or not any(self.force):
            couple = number(self.couple[2]) if is_planar else vector(self.couple, False)
            parts.append(f"couple: {couple}")
        return f"  {self.name}: {{{', '.join(parts)}}}"


@dataclass
class Sketch:
    """One mechanism with one case, named `case`."""

    name: str
    is_planar: bool
    ground: str
    bodies: list[str]
    couplings: list[Coupling]
    actuators: list[Actuator] = field(default_factory=list)
    loads: list[Load] = field(default_factory=list)
    motion: dict[str, Fraction] = field(default_factory=dict)  # by coupling.freedom
    action: dict[str, Fraction] | None = None                  # by the program's names
    input: str | None = None
    output: str | None = None

    def actuator_of(self, freedom: str) -> str | None:
        return next((a.name for a in self.actuators if f"{a.coupling}.{a.freedom}" == freedom),
                    None)

    def _case(self) -> str:
        parts = []
        if self.motion:
            known = (f"{self.actuator_of(k) or k}: {number(v)}" for k, v in self.motion.items())
            parts.append(f"motion: {{{', '.join(known)}}}")
        if self.action is not None:
            known = (f"{k}: {number(v)}" for k, v in self.action.items())
            parts.append(f"action: {{{', '.join(known)}}}")
        parts += [f"{key}: {name}" for key, name in
                  (("input", self.input), ("output", self.output)) if name]
        return f"  case: {{{', '.join(parts)}}}"

    def text(self) -> str:
        """The file; every length is a multiple of the parameter k, which is 1."""
        lines = ["kinestat: 1", f"space: {'planar' if self.is_planar else 'spatial'}",
                 f"ground: {self.ground}", f"bodies: [{', '.join(self.bodies)}]", "couplings:"]
        lines += [coupling.text() for coupling in self.couplings]
        if self.actuators:
            lines.append("actuators:")
            lines += [f"  {a.name}: {{coupling: {a.coupling}, freedom: {a.freedom}}}"
                      for a in self.actuators]
        if self.loads:
            lines += ["loads:", *(load.text(self.is_planar) for load in self.loads)]
        return "\n".join([*lines, "cases:", self._case(), ""])
