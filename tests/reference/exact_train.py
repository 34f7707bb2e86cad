"""A transmission as exact equations between the speeds of its shafts (Willis 1841).

Every set adds one equation, sum of c_s · w_s = 0 over its three shafts; its torques on them are in
the ratio of the same coefficients, for they do no work. That is a second way beside the screws of
the program: no geometry, no planets, exact fractions.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

Row = dict[str, Fraction]
HOUSING = "housing"


def simple_set(sun: str, ring: str, carrier: str, teeth: tuple[int, int]) -> Row:
    """Willis: Ns (w_s - w_c) + Nr (w_r - w_c) = 0."""
    row: Row = {}
    for shaft, factor in ((sun, teeth[0]), (ring, teeth[1]), (carrier, -teeth[0] - teeth[1])):
        row[shaft] = row.get(shaft, Fraction(0)) + factor
    return row


def echelon(rows: list[list[Fraction]]) -> list[list[Fraction]]:
    """Reduced, without its zero rows."""
    rows = [list(row) for row in rows]
    done = 0
    for column in range(len(rows[0]) if rows else 0):
        pivot = next((r for r in range(done, len(rows)) if rows[r][column] != 0), None)
        if pivot is None:
            continue
        rows[done], rows[pivot] = rows[pivot], rows[done]
        rows[done] = [x / rows[done][column] for x in rows[done]]
        for r, row in enumerate(rows):
            if r != done and row[column] != 0:
                rows[r] = [a - row[column] * b for a, b in zip(row, rows[done])]
        done += 1
    return rows[:done]


def solve(rows: list[list[Fraction]], right: list[Fraction]) -> list[Fraction | None] | None:
    """Of each unknown its value, None where it is open; None if the equations contradict."""
    count = len(rows[0])
    reduced = echelon([[*row, b] for row, b in zip(rows, right)])
    values: list[Fraction | None] = [None] * count
    for row in reduced:
        leading = next(i for i, x in enumerate(row) if x != 0)
        if leading == count:
            return None
        if all(x == 0 for x in row[leading + 1:count]):
            values[leading] = row[count]
    return values


def particular(rows: list[list[Fraction]], right: list[Fraction]) -> list[Fraction]:
    """The solution with zeros where it is open."""
    values = [Fraction(0)] * len(rows[0])
    for row in echelon([[*row, b] for row, b in zip(rows, right)]):
        values[next(i for i, x in enumerate(row) if x != 0)] = row[-1]
    return values


def null_space(rows: list[list[Fraction]], count: int) -> list[list[Fraction]]:
    """One vector a free unknown, which is 1 there."""
    reduced = echelon(rows)
    leading = [next(i for i, x in enumerate(row) if x != 0) for row in reduced]
    vectors = []
    for free in (i for i in range(count) if i not in leading):
        vector = [Fraction(0)] * count
        vector[free] = Fraction(1)
        for at, row in zip(leading, reduced):
            vector[at] = -row[free]
        vectors.append(vector)
    return vectors


@dataclass
class State:
    """What becomes of one combination of engaged elements."""

    kind: str
    ratio: Fraction | None = None
    torque_ratio: Fraction | None = None
    torques: dict[str, Fraction | None] = field(default_factory=dict)
    slips: dict[str, Fraction | None] = field(default_factory=dict)


@dataclass
class Train:
    """Elements are couplings tail -> head between shafts, one of which may be the housing."""

    shafts: list[str]
    sets: list[Row]
    elements: dict[str, tuple[str, str]]
    input: str
    output: str

    def row(self, speeds: Row) -> list[Fraction]:
        return [Fraction(speeds.get(shaft, 0)) for shaft in self.shafts]

    def slip(self, element: str) -> Row:
        tail, head = self.elements[element]
        return {head: Fraction(1), tail: Fraction(-1)}

    def rank(self, rows: list[Row]) -> int:
        return len(echelon([self.row(row) for row in rows]))

    def net_freedom(self) -> int:
        return len(self.shafts) - self.rank(self.sets)

    def combinations(self, size: int) -> list[tuple[str, ...]]:
        return list(itertools.combinations(self.elements, size))

    @cached_property
    def motions(self) -> list[list[Fraction]]:
        """What the open train can do: the speeds of all shafts in each motion."""
        return null_space([self.row(one) for one in self.sets], len(self.shafts))

    def rates(self, speeds: Row) -> list[Fraction]:
        """A combination of speeds, in each motion of the open train."""
        row = self.row(speeds)
        return [sum((a * b for a, b in zip(row, motion)), Fraction(0)) for motion in self.motions]

    def state(self, engaged: tuple[str, ...], torque: Fraction = Fraction(1)) -> State:
        rows = [self.rates(self.slip(element)) for element in engaged]
        held = len(echelon(rows))
        turns = self.rates({self.input: Fraction(1)})
        driven = echelon([*rows, turns])
        if len(driven) == held:
            return State("locked")
        fixed = particular([*rows, turns], [Fraction(0)] * len(rows) + [Fraction(1)])

        def rate(speeds: Row) -> Fraction | None:
            """In the motion with the input at 1; None where it is open."""
            row = self.rates(speeds)
            if len(echelon([*driven, row])) > len(driven):
                return None
            return sum((a * b for a, b in zip(row, fixed)), Fraction(0))

        out = rate({self.output: Fraction(1)})
        if out is None:
            return State("neutral")
        if out == 0:
            return State("locked")
        if len(engaged) > self.net_freedom() - 1 and len(engaged) > held:
            return State("tie-up")
        state = State("gear", 1 / out)
        for element in self.elements:
            state.slips[element] = (Fraction(0) if element in engaged else
                                    rate(self.slip(element)))
        self.add_torques(engaged, torque, state)
        return state

    def add_torques(self, engaged: tuple[str, ...], torque: Fraction, state: State) -> None:
        """Equilibrium of every shaft: torques of the sets, of the elements, input and output."""
        unknown = [*self.sets, *(self.slip(e) for e in engaged), {self.output: Fraction(1)}]
        columns = [self.row(one) for one in unknown]
        equations = [list(row) for row in zip(*columns)]
        right = [-torque if shaft == self.input else Fraction(0) for shaft in self.shafts]
        values = solve(equations, right)
        assert values is not None
        state.torques = {element: Fraction(0) for element in self.elements}
        for element, value in zip(engaged, values[len(self.sets):]):
            state.torques[element] = value
        state.torque_ratio = torque / values[-1] if values[-1] else None
