"""Linear equations over the integers: ranks and solutions without rounding.

Rows are lists of integers, each by itself up to a factor; elimination keeps them whole and short.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Iterable, Sequence


def whole(row: Iterable[Fraction]) -> list[int]:
    """The row as the shortest integers in the same ratio."""
    ratios = [x.as_integer_ratio() for x in row]
    common = math.lcm(*(below for _, below in ratios))
    return _shortened([above * (common // below) for above, below in ratios])


def _shortened(row: list[int]) -> list[int]:
    divisor = math.gcd(*row) if row else 1
    return [x // divisor for x in row] if divisor > 1 else row


class Echelon:
    """The reduced echelon form of rows, its pivots taken from the first columns on."""

    def __init__(self, rows: Sequence[Sequence[Fraction]], columns: int) -> None:
        self.columns = columns
        self.rows: dict[int, list[int]] = {}  # by the column of the pivot
        left = [r for r in (whole(row) for row in rows) if any(r)]
        for column in range(columns):
            at = next((i for i, row in enumerate(left) if row[column]), None)
            if at is None:
                continue
            pivot = left.pop(at)
            left = [r for r in (self._cleared(row, pivot, column) for row in left) if any(r)]
            for known, row in self.rows.items():
                self.rows[known] = self._cleared(row, pivot, column)
            self.rows[column] = pivot

    @staticmethod
    def _cleared(row: list[int], pivot: list[int], column: int) -> list[int]:
        factor = row[column]
        if not factor:
            return row
        head = pivot[column]
        return _shortened([head * x - factor * y for x, y in zip(row, pivot)])

    @property
    def rank(self) -> int:
        return len(self.rows)


def rank(rows: Sequence[Sequence[Fraction]], columns: int) -> int:
    return Echelon(rows, columns).rank


class Solution:
    """Unknowns x of rows · x = right: each one's value, None where it is open."""

    def __init__(self, rows: Sequence[Sequence[Fraction]], right: Sequence[Fraction],
                 count: int) -> None:
        echelon = Echelon([[*row, b] for row, b in zip(rows, right)], count + 1)
        self.is_consistent = count not in echelon.rows
        self.rank = echelon.rank - (0 if self.is_consistent else 1)
        self.values: list[Fraction | None] = [None] * count
        for column, row in echelon.rows.items():
            if column < count and not any(row[column + 1:count]):
                self.values[column] = Fraction(row[count], row[column])
