"""Tidy tables folded into lines that a reviewer can read, and back.

A line is `elements | quantity | values | units` below a heading `[pass of cases, status]`, which
names cases where there are some and the status where it is not "solved". What stands once in a
line, and in the table once a row:
- components: `a.Rx,Ry` of a coupling, `at/x,y,z` of a point, `points/0..199/x` of the abscissas
  of a curve, `position@0..72` of the steps of a motion, with a value each, and with a unit each
  where these differ;
- elements and cases that have the same values;
- the angular velocity as a part of the twist, the force as a part of the wrench.
Lists are separated by spaces, names with spaces or marks of their own are in quotes, `none` is a
value that does not exist. Numbers have twelve digits: more than are compared, and less than the
noise of rounding.
"""

from __future__ import annotations

import re
import shlex
from typing import Iterable, Iterator, NamedTuple

DIGITS = 12
NO_VALUE = "none"
USUAL_STATUS = "solved"
# Components of a quantity that stand a second time, as another.
REPEATED = {f"{screw}{axis}": f"{part}/{axis}"
            for screw, part in (("twist/w", "angular"), ("wrench/R", "force")) for axis in "xyz"}
QUOTES = re.compile(r"['\"\\]")
PLAIN_NAME = re.compile(r"[^\s'\"\\|\[\]]+")
HEADING = re.compile(r"\[(\w+)(?: of (.*?))?(?:, (\w+))?\]")
NAME = re.compile(r"[wvTR]?[xyz]")  # of a component of a vector or a screw
COMPONENTS = re.compile(rf"(.*?)(?:([@/])([\d,.]+|(?:{NAME.pattern},)*{NAME.pattern})"
                        r"(/(?:\d+|[xyz]))?)?")
LIST_OF_POINTS = re.compile(r"(.*)/(\d+)(/(?:\d+|[xyz]))")


class Row(NamedTuple):
    """A row of a table; step is empty but in motions."""

    case: str
    part: str  # the column `pass`
    element: str
    quantity: str
    value: str
    unit: str = ""
    status: str = USUAL_STATUS
    step: str = ""


class Line(NamedTuple):
    """What is the same in all rows that become one line."""

    cases: tuple[str, ...]
    part: str
    status: str
    elements: tuple[str, ...]
    quantity: str
    values: tuple[str, ...]
    units: tuple[str, ...]


def short(number: str) -> str:
    """With so many digits as are compared; words and whole numbers as they are."""
    if not re.fullmatch(r"-?\d+\.\d+(e[-+]?\d+)?|-?\d+e[-+]?\d+", number):
        return number
    return f"{float(number):.{DIGITS}g}"


def place_of(row: Row) -> Row:
    """What tells it from the other rows."""
    return row._replace(value="", unit="", status="")


def repetitions(rows: Iterable[Row]) -> list[Row]:
    """Those that follow from the twists and wrenches among the rows."""
    return [row._replace(quantity=REPEATED[row.quantity]) for row in rows
            if row.quantity in REPEATED]


class Axis(NamedTuple):
    """Element and quantity without the component, what stands around it, and itself."""

    element: str
    quantity: str
    sign: str  # before the component, empty if there is none
    coordinate: str  # behind it
    component: str


def axis_of(row: Row) -> Axis:
    if row.step:
        return Axis(row.element, row.quantity, "@", "", row.step)
    if points := LIST_OF_POINTS.fullmatch(row.quantity):
        stem, index, coordinate = points.groups()
        return Axis(row.element, stem, "/", coordinate, index)
    stem, slash, index = row.quantity.rpartition("/")
    if slash and (index.isdigit() or NAME.fullmatch(index)):
        return Axis(row.element, stem, "/", "", index)
    stem, dot, label = row.element.rpartition(".")
    return Axis(stem if dot else row.element, row.quantity, dot, "", label if dot else "")


def is_range(components: list[str]) -> bool:
    numbers = [int(one) for one in components if one.isdigit()]
    return (len(numbers) == len(components) > 1 and
            numbers == list(range(numbers[0], numbers[0] + len(numbers))))


def joined(components: list[str]) -> str:
    return f"{components[0]}..{components[-1]}" if is_range(components) else ",".join(components)


def parted(components: str) -> list[str]:
    bounds = re.fullmatch(r"(\d+)\.\.(\d+)", components)
    if not bounds:
        return components.split(",")
    return [str(i) for i in range(int(bounds[1]), int(bounds[2]) + 1)]


def with_components(rows: Iterable[Row]) -> Iterator[Line]:
    """A line for each group of rows that differ only in their component."""
    groups: dict[tuple[str, str, str, Axis], list[Row]] = {}
    for row in rows:
        axis = axis_of(row)._replace(component="")
        groups.setdefault((row.case, row.part, row.status, axis), []).append(row)
    for (case, part, status, axis), group in groups.items():
        element, quantity = axis.element, axis.quantity
        components = [axis_of(row).component for row in group]
        if axis.sign == ".":
            element += "." + ",".join(components)
        elif axis.sign:
            quantity += axis.sign + joined(components) + axis.coordinate
        units = tuple(row.unit for row in group)
        yield Line((case,), part, status, (element,), quantity,
                   tuple(short(row.value) or NO_VALUE for row in group),
                   units if len(set(units)) > 1 else tuple(filter(None, units[:1])))


def gathered(lines: Iterable[Line], field: str) -> list[Line]:
    """Lines that differ in their cases or elements alone become one."""
    groups: dict[Line, list[str]] = {}
    for line in lines:
        groups.setdefault(line._replace(**{field: ()}), []).extend(getattr(line, field))
    return [line._replace(**{field: tuple(names)}) for line, names in groups.items()]


def quoted(names: Iterable[str]) -> str:
    """As names_in reads them, in quotes only where they need some."""
    return " ".join(name if PLAIN_NAME.fullmatch(name) else shlex.quote(name) for name in names)


def names_in(text: str) -> tuple[str, ...]:
    return tuple(shlex.split(text) if QUOTES.search(text) else text.split())


def heading(line: Line) -> str:
    cases = "" if line.cases == ("",) else f" of {quoted(line.cases)}"
    return f"[{line.part}{cases}{'' if line.status == USUAL_STATUS else f', {line.status}'}]"


def read_heading(text: str) -> tuple[str, tuple[str, ...], str]:
    """Pass, cases and status."""
    found = HEADING.fullmatch(text)
    if not found:
        raise ValueError("no heading")
    part, cases, status = found.groups()
    return part, ("",) if cases is None else names_in(cases), status or USUAL_STATUS


def written(line: Line) -> str:
    cells = [line.elements, [line.quantity], line.values, *([line.units] if line.units else [])]
    return " | ".join(map(quoted, cells))


def fold(rows: Iterable[Row]) -> str:
    """The lines of the rows; the rows of a heading stand where its first one stood."""
    rows = list(rows)
    repeated = set(repetitions(rows))
    told = [row for row in rows if row not in repeated]
    sections: dict[str, list[str]] = {}
    for line in gathered(gathered(with_components(told), "cases"), "elements"):
        sections.setdefault(heading(line), []).append(written(line))
    return "".join("\n".join([name, *lines]) + "\n" for name, lines in sections.items())


def places(element: str, quantity: str) -> list[tuple[str, str, str]]:
    """Element, quantity and step of each component."""
    stem, sign, components, coordinate = COMPONENTS.fullmatch(quantity).groups("")
    if sign == "@":
        return [(element, stem, step) for step in parted(components)]
    if sign == "/":
        return [(element, f"{stem}/{index}{coordinate}", "") for index in parted(components)]
    stem, dot, labels = element.rpartition(".")
    names = [f"{stem}.{label}" for label in labels.split(",")] if dot else [element]
    return [(name, quantity, "") for name in names]


def rows_of(line: Line) -> Iterator[Row]:
    units = line.units or ("",)
    if len(units) == 1:
        units *= len(line.values)
    for case in line.cases:
        for element in line.elements:
            found = places(element, line.quantity)
            if not len(found) == len(line.values) == len(units):
                raise ValueError(f"{element} has {len(found)} components of '{line.quantity}', "
                                 f"{len(line.values)} values and {len(units)} units")
            for (name, quantity, step), value, unit in zip(found, line.values, units):
                yield Row(case, line.part, name, quantity,
                          "" if value == NO_VALUE else value, unit, line.status, step)


def cells_of(text: str) -> list[tuple[str, ...]]:
    cells: list[list[str]] = [[]]
    for word in names_in(text):
        if word == "|":
            cells.append([])
        else:
            cells[-1].append(word)
    return [tuple(cell) for cell in cells]


def read_line(text: str, cases: tuple[str, ...], part: str, status: str) -> Line:
    cells = cells_of(text)
    if len(cells) not in (3, 4) or len(cells[1]) != 1:
        raise ValueError("no line of elements, quantity, values and units")
    elements, (quantity,), values, *units = cells
    return Line(cases, part, status, elements, quantity, values, units[0] if units else ())


def unfold(text: str) -> list[Row]:
    """The rows that were folded; ValueError where a line is none."""
    rows: list[Row] = []
    part, cases, status = "", ("",), USUAL_STATUS
    for number, line in enumerate(text.splitlines(), 1):
        try:
            if line.startswith("["):
                part, cases, status = read_heading(line)
            else:
                rows += rows_of(read_line(line, cases, part, status))
        except ValueError as error:
            raise ValueError(f"line {number}: {error}: {line}") from error
    there = {place_of(row) for row in rows}
    return rows + [row for row in repetitions(rows) if place_of(row) not in there]
