"""A transmission as exact equations between the speeds of its shafts (Willis 1841).

Every set adds one equation, sum of c_s · w_s = 0 over its three shafts; its torques on them are in
the ratio of the same coefficients, for they do no work. That is a second way beside the screws of
the program: no geometry, no planets, exact fractions.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from fractions import Fraction

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

    def state(self, engaged: tuple[str, ...], torque: Fraction = Fraction(1)) -> State:
        rows = [*self.sets, *(self.slip(element) for element in engaged)]
        turns: Row = {self.input: Fraction(1)}
        if self.rank([*rows, turns]) == self.rank(rows):
            return State("locked")
        speeds = solve([self.row(row) for row in [*rows, turns]],
                       [Fraction(0)] * len(rows) + [Fraction(1)])
        assert speeds is not None
        out = speeds[self.shafts.index(self.output)]
        if out is None:
            return State("neutral")
        if out == 0:
            return State("locked")
        surplus = len(engaged) - (self.rank(rows) - self.rank(self.sets))
        if len(engaged) > self.net_freedom() - 1 and surplus > 0:
            return State("tie-up")
        state = State("gear", 1 / out)
        for element in self.elements:
            ends = [Fraction(0) if end == HOUSING else speeds[self.shafts.index(end)]
                    for end in self.elements[element]]
            state.slips[element] = (Fraction(0) if element in engaged else
                                    None if None in ends else ends[1] - ends[0])
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
