#!/usr/bin/env python3
"""Every picture of every mechanism: well-formed, inside its frame, legible, reproducible."""

from __future__ import annotations

import argparse
import cmath
import math
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Callable, Iterator

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
from sanitized import has_sanitizers, sample  # noqa: E402

MECHANISMS = ROOT / "mechanisms"
PROGRAM = Path("kinestat")
SVG = "{http://www.w3.org/2000/svg}"
# Their times differ from run to run, and all are of one kind.
TIMED = {"pareto"}
TIMED_FILE = MECHANISMS / "planar" / "four_bar.yaml"
# Adobe's advance widths of Helvetica for ' ' to '~', in thousandths of the size. Texts are at least
# as wide as this in any font of the pictures but the condensed ones.
HELVETICA = [int(width) for width in (
    "278 278 355 556 556 889 667 191 333 333 389 584 278 333 278 278 556 556 556 556 556 556 556 556 "
    "556 556 278 278 584 584 584 556 1015 667 667 722 722 667 611 778 722 278 500 667 556 833 722 "
    "778 667 778 722 667 611 722 667 944 667 667 611 278 278 278 469 556 333 556 556 500 556 556 278 "
    "556 556 222 222 500 222 833 556 556 556 556 333 500 278 556 500 722 500 500 500 334 260 334 "
    "584").split()]
SHAPES = {"line", "rect", "circle", "polygon", "polyline", "path"}
NOT_DRAWN = {"title", "desc", "style", "animate", "animateTransform"}
# What texts have from the groups that they are in.
INHERITED = {"font-size", "text-anchor"}
# How many numbers each command of a path takes.
PATH_NUMBERS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7}


@dataclass
class Box:
    left: float
    top: float
    right: float
    bottom: float

    def shared(self, other: Box) -> float:
        """The smaller side of what both cover."""
        return min(min(self.right, other.right) - max(self.left, other.left),
                   min(self.bottom, other.bottom) - max(self.top, other.top))

    def holds(self, other: Box, slack: float) -> bool:
        return (other.left >= self.left - slack and other.right <= self.right + slack
                and other.top >= self.top - slack and other.bottom <= self.bottom + slack)


@dataclass
class Frame:
    """Where coordinates lie in the view: turned, then moved; points as complex numbers."""
    turn: complex = 1.0
    move: complex = 0.0

    def place(self, x: float, y: float) -> tuple[float, float]:
        point = self.turn * complex(x, y) + self.move
        return point.real, point.imag

    def of(self, inner: Frame) -> Frame:
        return Frame(self.turn * inner.turn, self.turn * inner.move + self.move)


@dataclass
class Drawn:
    """A text or a shape, once for each time that it is drawn."""
    element: ElementTree.Element
    kind: str
    frame: Frame
    inherited: dict[str, str]


def kinestat(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(PROGRAM), *words], capture_output=True, encoding="utf-8",
                          check=False, timeout=240)


@lru_cache(maxsize=None)
def pictures() -> tuple[tuple[Path, str], ...]:
    """Every file with every picture that it has; with sanitizers some files, and of the others what
    none before has."""
    found = []
    paths = sorted(MECHANISMS.rglob("*.yaml"))
    whole = set(sample(PROGRAM, paths))
    for path in paths:
        listed = kinestat("plot", "list", str(path))
        for line in listed.stdout.splitlines():
            word, name, *_ = line.split()
            is_new = path in whole or name not in {one for _, one in found}
            if word == "yes" and is_new and (name not in TIMED or path == TIMED_FILE):
                found.append((path, name))
    return tuple(found)


@lru_cache(maxsize=None)
def drawn(path: Path, name: str) -> subprocess.CompletedProcess[str]:
    return kinestat("plot", name, str(path))


def numbers(text: str) -> list[float]:
    return [float(word) for word in re.findall(r"-?\d*\.?\d+(?:[eE][-+]?\d+)?", text)]


def arc_bounds(at: tuple[float, float], words: list[float]) -> Iterator[tuple[float, float]]:
    """Points of an elliptical arc with equal radii, by its centre (SVG 1.1, appendix F.6)."""
    radius, _, _, large, sweep, x, y = words
    dx, dy = (at[0] - x) / 2, (at[1] - y) / 2
    half = math.hypot(dx, dy)
    radius = max(radius, half)
    if half == 0:
        return
    size = math.sqrt(max(0.0, radius**2 - half**2)) / half
    sign = -1.0 if large == sweep else 1.0
    centre = ((at[0] + x) / 2 + sign * size * dy, (at[1] + y) / 2 - sign * size * dx)
    begin = math.atan2(at[1] - centre[1], at[0] - centre[0])
    end = math.atan2(y - centre[1], x - centre[0])
    turn = (end - begin) % (2 * math.pi)
    if sweep == 0:
        turn -= 2 * math.pi
    for i in range(33):
        angle = begin + turn * i / 32
        yield centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


def path_points(data: str) -> Iterator[tuple[float, float]]:
    """Points of a path; control points of curves among them."""
    x = y = 0.0
    begin = (x, y)
    for letter, rest in re.findall(r"([a-zA-Z])([^a-zA-Z]*)", data):
        kind = letter.upper()
        words = numbers(rest)
        if kind == "Z":
            x, y = begin
            continue
        if kind not in PATH_NUMBERS:
            raise AssertionError(f"unknown path command {letter}")
        size = PATH_NUMBERS[kind]
        if not words or len(words) % size != 0:
            raise AssertionError(f"{len(words)} numbers for path command {letter}")
        for i in range(0, len(words), size):
            part = words[i:i + size]
            # Relative numbers of a part all count from where the part before it ends.
            from_x, from_y = (x, y) if letter.islower() else (0.0, 0.0)
            if kind == "H":
                x = from_x + part[0]
            elif kind == "V":
                y = from_y + part[0]
            elif kind == "A":
                end = (from_x + part[5], from_y + part[6])
                yield from arc_bounds((x, y), [*part[:5], *end])
                x, y = end
            else:
                for j in range(0, size, 2):
                    x, y = from_x + part[j], from_y + part[j + 1]
                    yield x, y
            yield x, y
            if kind == "M" and i == 0:
                begin = (x, y)


def box_of(points: list[tuple[float, float]]) -> Box:
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return Box(min(xs), min(ys), max(xs), max(ys))


def corners_of(box: Box) -> list[tuple[float, float]]:
    return [(x, y) for x in (box.left, box.right) for y in (box.top, box.bottom)]


def text_width(text: str, size: float) -> float:
    return size / 1000 * sum(HELVETICA[ord(c) - 32] if " " <= c <= "~" else 500 for c in text)


def frame_of(element: ElementTree.Element) -> Frame:
    """What `transform` says of the element and all in it."""
    frame = Frame()
    text = element.attrib.get("transform", "")
    if not re.fullmatch(r"(\s*\w+\([^()]*\))*", text):
        raise AssertionError(f"unknown transform {text}")
    for kind, rest in re.findall(r"(\w+)\(([^()]*)\)", text):
        words = numbers(rest)
        if kind == "translate" and len(words) in (1, 2):
            frame = frame.of(Frame(move=complex(*words)))
        elif kind == "rotate" and len(words) in (1, 3):
            turn = cmath.rect(1.0, math.radians(words[0]))
            centre = complex(*words[1:])
            frame = frame.of(Frame(turn, centre - turn * centre))
        else:
            raise AssertionError(f"unknown transform {kind}({rest})")
    return frame


def all_drawn(root: ElementTree.Element) -> Iterator[Drawn]:
    """Texts and shapes where they are drawn; what is used again is drawn again."""
    named = {element.attrib["id"]: element for element in root.iter() if "id" in element.attrib}

    def walk(element: ElementTree.Element, frame: Frame, inherited: dict[str, str],
             using: tuple[str, ...]) -> Iterator[Drawn]:
        kind = element.tag.removeprefix(SVG)
        if kind in NOT_DRAWN:
            return
        frame = frame.of(frame_of(element))
        inherited = inherited | {key: text for key, text in element.attrib.items()
                                 if key in INHERITED}
        if kind == "use":
            name = element.attrib["href"].removeprefix("#")
            if name in using:
                raise AssertionError(f"{name} uses itself")
            move = complex(float(element.attrib.get("x", "0")), float(element.attrib.get("y", "0")))
            yield from walk(named[name], frame.of(Frame(move=move)), inherited, (*using, name))
        elif kind == "text" or kind in SHAPES:
            yield Drawn(element, kind, frame, inherited)
        elif kind != "g" and element is not root:
            raise AssertionError(f"unknown element {kind}")
        for child in element:
            if kind not in ("svg", "g") and child.tag.removeprefix(SVG) not in NOT_DRAWN:
                raise AssertionError(f"{child.tag} in {kind}")
            yield from walk(child, frame, inherited, using)

    yield from walk(root, Frame(), {}, ())


def written(element: ElementTree.Element) -> str:
    """The letters of a text, without those of its title."""
    return (element.text or "") + "".join(child.tail or "" for child in element)


def text_corners(one: Drawn) -> list[tuple[float, float]]:
    x, y = float(one.element.attrib.get("x", "0")), float(one.element.attrib.get("y", "0"))
    size = float(one.inherited["font-size"])
    width = text_width(written(one.element), size)
    anchor = one.inherited.get("text-anchor", "start")
    left = x + {"start": 0.0, "middle": -width / 2, "end": -width}[anchor]
    return corners_of(Box(left, y - 0.72 * size, left + width, y + 0.2 * size))


def shape_points(one: Drawn) -> list[tuple[float, float]]:
    """Points between which the shape lies, before it is moved into the view."""
    attributes = one.element.attrib
    value = {key: float(text) for key, text in attributes.items()
             if key in ("x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "width", "height")}
    if one.kind == "line":
        return [(value["x1"], value["y1"]), (value["x2"], value["y2"])]
    if one.kind == "rect":
        return corners_of(Box(value["x"], value["y"], value["x"] + value["width"],
                              value["y"] + value["height"]))
    if one.kind == "circle":
        return corners_of(Box(value["cx"] - value["r"], value["cy"] - value["r"],
                              value["cx"] + value["r"], value["cy"] + value["r"]))
    if one.kind in ("polygon", "polyline"):
        words = numbers(attributes["points"])
        return list(zip(words[::2], words[1::2]))
    return list(path_points(attributes["d"]))


def box_in_view(one: Drawn) -> Box:
    points = text_corners(one) if one.kind == "text" else shape_points(one)
    return box_of([one.frame.place(x, y) for x, y in points])


def view_of(root: ElementTree.Element) -> Box:
    x, y, width, height = numbers(root.attrib["viewBox"])
    return Box(x, y, x + width, y + height)


class Pictures(unittest.TestCase):
    def each(self, check: Callable[[ElementTree.Element, str], None]) -> None:
        for path, name in pictures():
            with self.subTest(file=str(path.relative_to(MECHANISMS)), picture=name):
                text = drawn(path, name).stdout
                check(ElementTree.fromstring(text), text)

    def test_are_many(self) -> None:
        self.assertGreater(len(pictures()), 150)

    def test_are_all_shown_by_some_mechanism(self) -> None:
        every = [line.split()[1]
                 for line in kinestat("plot", "list", str(TIMED_FILE)).stdout.splitlines()]

        self.assertEqual({name for _, name in pictures()}, set(every))

    def test_have_no_complaint_that_the_analysis_has_not(self) -> None:
        for path, name in pictures():
            with self.subTest(file=path.name, picture=name):
                self.assertIn(drawn(path, name).returncode, (0, 5))
                self.assertNotIn("E0909", drawn(path, name).stderr)

    def test_are_named_and_described(self) -> None:
        def check(root: ElementTree.Element, _: str) -> None:
            self.assertEqual(root.attrib["role"], "img")
            title, description = root.find(f"{SVG}title"), root.find(f"{SVG}desc")
            assert title is not None and description is not None
            self.assertEqual(root.attrib["aria-label"], title.text)
            self.assertGreater(len(description.text or ""), 20)

        self.each(check)

    def test_load_and_run_nothing(self) -> None:
        def check(root: ElementTree.Element, text: str) -> None:
            ids = {"#" + element.attrib["id"] for element in root.iter() if "id" in element.attrib}
            for element in root.iter():
                kind = element.tag.removeprefix(SVG)
                self.assertNotIn(kind, ("script", "image", "foreignObject", "a", "set"))
                if kind == "use":
                    # Only what the picture itself has may be drawn again.
                    self.assertIn(element.attrib["href"], ids)
                for key in element.attrib:
                    self.assertFalse(key.startswith("on") or key == "style", key)
                    self.assertTrue("href" not in key or (kind, key) == ("use", "href"), key)
            self.assertNotRegex(text, r"(?i)url\(|@import")

        self.each(check)

    def test_move_only_where_they_say_so(self) -> None:
        # An animation of `href` could run what it likes.
        for path, name in pictures():
            with self.subTest(file=path.name, picture=name):
                root = ElementTree.fromstring(drawn(path, name).stdout)
                moved = {element.attrib["attributeName"] for element in root.iter()
                         if element.tag.removeprefix(SVG).startswith("animate")}
                self.assertLessEqual(moved, {"transform", "display"})
                self.assertEqual(bool(moved), name == "animation")

    def test_have_ids_once(self) -> None:
        def check(root: ElementTree.Element, _: str) -> None:
            ids = [element.attrib["id"] for element in root.iter() if "id" in element.attrib]
            self.assertEqual(len(ids), len(set(ids)))

        self.each(check)

    def test_have_numbers_only(self) -> None:
        def check(root: ElementTree.Element, _: str) -> None:
            for element in root.iter():
                for key, value in element.attrib.items():
                    if key in ("d", "points", "transform", "viewBox", "width", "height"):
                        self.assertNotRegex(value, r"(?i)nan|inf|e[+-]\d")

        self.each(check)

    def test_lie_inside_their_views(self) -> None:
        def check(root: ElementTree.Element, _: str) -> None:
            view = view_of(root)
            for one in all_drawn(root):
                box = box_in_view(one)
                self.assertTrue(view.holds(box, 0.51),
                                f"{ElementTree.tostring(one.element)!r} {box} {view}")

        self.each(check)

    def test_have_no_text_upon_another(self) -> None:
        def check(root: ElementTree.Element, _: str) -> None:
            texts = [(box_in_view(one), written(one.element))
                     for one in all_drawn(root) if one.kind == "text"]
            texts.sort(key=lambda one: one[0].left)
            for i, (box, text) in enumerate(texts):
                for other, other_text in texts[i + 1:]:
                    if other.left >= box.right:
                        break
                    self.assertLess(box.shared(other), 2.0, f"{text!r} and {other_text!r}")

        self.each(check)

    def test_are_small_enough_for_a_page(self) -> None:
        def check(root: ElementTree.Element, text: str) -> None:
            view = view_of(root)
            self.assertLess(view.right - view.left, 1700)
            self.assertLess(len(text), 2_000_000)

        self.each(check)

    def test_are_the_same_every_time(self) -> None:
        seen: dict[str, int] = {}
        for path, name in pictures():
            seen[name] = seen.get(name, 0) + 1
            if name not in TIMED and seen[name] <= (1 if has_sanitizers(PROGRAM) else 3):
                with self.subTest(file=path.name, picture=name):
                    again = kinestat("plot", name, str(path)).stdout
                    self.assertEqual(again, drawn(path, name).stdout)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
