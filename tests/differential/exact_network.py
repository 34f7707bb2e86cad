"""Velocities and actions of a drawn mechanism from the plain equations, in fractions.

Closure: around every circuit the twists of the couplings sum to zero. Equilibrium: on every moving
body the wrenches of its couplings and loads do. Nothing here knows of Davies' matrices, of
elimination orders or of tolerances: a rank is a rank.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction

from exact_matrix import Solution, rank
from sketch import Coupling, Sketch, cross

Vector = list[Fraction]
PLANAR = (2, 3, 4)  # about z, along x, along y
ZERO = Fraction(0)
SPATIAL = (0, 1, 2, 3, 4, 5)


@dataclass
class Side:
    """Motions or actions of a case: what the program calls status, and the values by name."""

    status: str
    values: dict[str, Fraction | None] = field(default_factory=dict)
    wholes: dict[str, Vector | None] = field(default_factory=dict)  # twists or wrenches
    determined: dict[str, Fraction | None] = field(default_factory=dict)  # where not all are


@dataclass
class Counts:
    """Of motions F, or of actions C."""

    gross: int
    rank: int
    net: int        # what must be known
    other_net: int  # redundant constraints of motions; unresisted freedoms of actions


def signed(value: Fraction, sign: int) -> Fraction:
    """The value times 1, 0 or -1."""
    return value if sign > 0 else -value if sign < 0 else ZERO


def wrench(point: Vector, force: Vector, couple: Vector) -> Vector:
    return [a + b for a, b in zip(couple, cross(point, force))] + list(force)


class ExactNetwork:
    """The equations of a sketch; `order` are the coordinates in which they are written."""

    def __init__(self, sketch: Sketch, order: tuple[int, ...] | None = None) -> None:
        self.sketch = sketch
        self.order = order or (PLANAR if sketch.is_planar else SPATIAL)
        self.freedoms = [(f"{c.name}.{name}", c, twist) for c in sketch.couplings
                         for name, twist in c.freedoms()]
        self.actions = []
        for coupling in sketch.couplings:
            self.actions += [(f"{coupling.name}.{name}", coupling, one)
                             for name, one in coupling.constraints()]
            self.actions += [(a.name, coupling, coupling.action_of(a.freedom))
                             for a in sketch.actuators if a.coupling == coupling.name]
        self.parents: dict[str, tuple[str, str, int]] = {}  # body, coupling, sense
        self.circuits = [self._circuit(chord) for chord in self._grow_tree()]

    def _path(self, body: str) -> dict[str, int]:
        """The couplings between the ground and a body, and in which sense they are passed."""
        steps: dict[str, int] = {}
        while body != self.sketch.ground:
            body, name, sign = self.parents[body]
            steps[name] = sign
        return steps

    def _grow_tree(self) -> list[Coupling]:
        """Fills in the parents of the bodies; the couplings that are left are the chords."""
        reached, chords, waiting = {self.sketch.ground}, [], list(self.sketch.couplings)
        while waiting:
            one = next(c for c in waiting if c.tail in reached or c.head in reached)
            waiting.remove(one)
            if one.tail in reached and one.head in reached:
                chords.append(one)
            elif one.tail in reached:
                self.parents[one.head] = (one.tail, one.name, 1)
            else:
                self.parents[one.tail] = (one.head, one.name, -1)
            reached |= {one.tail, one.head}
        return chords

    def _circuit(self, chord: Coupling) -> dict[str, int]:
        steps = self._path(chord.tail)
        for name, sign in self._path(chord.head).items():
            steps[name] = steps.get(name, 0) - sign
        steps[chord.name] = 1
        return {name: sign for name, sign in steps.items() if sign}

    def closure(self) -> list[Vector]:
        """Rows of M_N: circuits by coordinates, columns by freedoms."""
        return [[signed(twist[i], circuit.get(coupling.name, 0))
                 for _, coupling, twist in self.freedoms]
                for circuit in self.circuits for i in self.order]

    def equilibrium(self) -> list[Vector]:
        """Rows by moving bodies and coordinates, columns by actions."""
        return [[signed(one[i], (c.head == body) - (c.tail == body)) for _, c, one in self.actions]
                for body in self.sketch.bodies for i in self.order]

    def motion_counts(self) -> Counts:
        gross = len(self.freedoms)
        found = rank(self.closure(), gross)
        return Counts(gross, found, gross - found, len(self.order) * len(self.circuits) - found)

    def action_counts(self) -> Counts:
        gross = len(self.actions)
        rows = self.equilibrium()
        found = rank(rows, gross)
        return Counts(gross, found, gross - found, len(rows) - found)

    def motion(self, known: dict[str, Fraction]) -> Side:
        """The case that knows these rates."""
        names = [name for name, _, _ in self.freedoms]
        rows = self.closure()
        columns = {name: i for i, name in enumerate(names)}
        given = [[Fraction(i == columns[name]) for i in range(len(names))] for name in known]
        without, with_known = rank(rows, len(names)), rank(rows + given, len(names))
        if with_known < without + len(known):
            return Side("dependent")
        solution = Solution(rows + given, [ZERO] * len(rows) + list(known.values()),
                            len(names))
        values = dict(zip(names, solution.values))
        if with_known < len(names):
            return Side("indeterminate", determined=values)
        return Side("solved", values, {b: self._twist(b, values) for b in self.sketch.bodies})

    def _twist(self, body: str, rates: dict[str, Fraction | None]) -> Vector:
        steps = self._path(body)
        passed = [(signed(rates[name], steps[c.name]), twist)
                  for name, c, twist in self.freedoms if c.name in steps]
        return [sum((rate * twist[i] for rate, twist in passed if twist[i]), ZERO)
                for i in SPATIAL]

    def loads(self) -> dict[str, Vector]:
        """On every body, about the origin."""
        result: dict[str, Vector] = {}
        for load in self.sketch.loads:
            one = wrench(load.at, load.force, load.couple)
            before = result.get(load.body, [ZERO] * 6)
            result[load.body] = [a + b for a, b in zip(before, one)]
        return result

    def statics(self, known: dict[str, Fraction]) -> Side:
        """The case that knows these actions, under the loads of the sketch."""
        rows = self.equilibrium()
        names = [name for name, _, _ in self.actions]
        loads = self.loads()
        right = [-loads.get(body, [ZERO] * 6)[i]
                 for body in self.sketch.bodies for i in self.order]
        open_ = [i for i, name in enumerate(names) if name not in known]
        given = [i for i, name in enumerate(names) if name in known]
        right = [b - sum((row[i] * known[names[i]] for i in given), ZERO)
                 for row, b in zip(rows, right)]
        solution = Solution([[row[i] for i in open_] for row in rows], right, len(open_))
        if not solution.is_consistent:
            return Side("inconsistent")
        if rank(rows, len(names)) > solution.rank:
            return Side("dependent")
        values: dict[str, Fraction | None] = {name: known.get(name) for name in names}
        values.update(zip((names[i] for i in open_), solution.values))
        status = "solved" if solution.rank == len(open_) else "indeterminate"
        return Side(status, values, {c.name: self._wrench(c, values)
                                     for c in self.sketch.couplings})

    def _wrench(self, coupling: Coupling, values: dict[str, Fraction | None]) -> Vector | None:
        parts = [(values[name], one) for name, c, one in self.actions if c is coupling]
        if any(value is None for value, _ in parts):
            return None
        return [sum((value * one[i] for value, one in parts if one[i]), ZERO)
                for i in SPATIAL]
