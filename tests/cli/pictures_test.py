#!/usr/bin/env python3
"""Every picture of every mechanism: well-formed, inside its view, legible, the same every time."""

from __future__ import annotations

import argparse
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


def kinestat(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([str(PROGRAM), *words], capture_output=True, encoding="utf-8",
                          check=False, timeout=240)


@lru_cache(maxsize=None)
def pictures() -> tuple[tuple[Path, str], ...]:
    """Every file with every picture that it has."""
    found = []
    for path in sorted(MECHANISMS.rglob("*.yaml")):
        listed = kinestat("plot", "list", str(path))
        for line in listed.stdout.splitlines():
            word, name, *_ = line.split()
            if word == "yes" and (name not in TIMED or path == TIMED_FILE):
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
    for letter, rest in re.findall(r"([a-zA-Z])([^a-zA-Z]*)", data):
        words = numbers(rest)
        if letter in "MLT":
            for i in range(0, len(words), 2):
                x, y = words[i], words[i + 1]
                yield x, y
        elif letter in "CSQ":
            for i in range(0, len(words), 2):
                x, y = words[i], words[i + 1]
                yield x, y
        elif letter == "H":
            x = words[-1]
            yield x, y
        elif letter == "V":
            y = words[-1]
            yield x, y
        elif letter == "h":
            yield x + words[0], y
        elif letter == "A":
            for i in range(0, len(words), 7):
                yield from arc_bounds((x, y), words[i:i + 7])
                x, y = words[i + 5], words[i + 6]
                yield x, y
        elif letter not in "Zz":
            raise AssertionError(f"unknown path command {letter}")


def box_of(points: list[tuple[float, float]]) -> Box:
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return Box(min(xs), min(ys), max(xs), max(ys))


def text_width(text: str, size: float) -> float:
    return size / 1000 * sum(HELVETICA[ord(c) - 32] if " " <= c <= "~" else 500 for c in text)


def text_box(element: ElementTree.Element) -> Box:
    x, y = float(element.attrib["x"]), float(element.attrib["y"])
    size = float(element.attrib["font-size"])
    width = text_width(element.text or "", size)
    anchor = element.attrib.get("text-anchor", "start")
    left = {"start": 0.0, "middle": -width / 2, "end": -width}[anchor]
    corners = [(dx, dy) for dx in (left, left + width) for dy in (-0.72 * size, 0.2 * size)]
    angle = 0.0
    if "transform" in element.attrib:
        angle = math.radians(numbers(element.attrib["transform"])[0])
    turned = [(x + dx * math.cos(angle) - dy * math.sin(angle),
               y + dx * math.sin(angle) + dy * math.cos(angle)) for dx, dy in corners]
    return box_of(turned)


def shape_box(element: ElementTree.Element) -> Box | None:
    kind = element.tag.removeprefix(SVG)
    value = {key: float(text) for key, text in element.attrib.items()
             if key in ("x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "width", "height")}
    if kind == "line":
        return box_of([(value["x1"], value["y1"]), (value["x2"], value["y2"])])
    if kind == "rect":
        return Box(value["x"], value["y"], value["x"] + value["width"],
                   value["y"] + value["height"])
    if kind == "circle":
        return Box(value["cx"] - value["r"], value["cy"] - value["r"], value["cx"] + value["r"],
                   value["cy"] + value["r"])
    if kind in ("polygon", "polyline"):
        words = numbers(element.attrib["points"])
        return box_of(list(zip(words[::2], words[1::2])))
    if kind == "path":
        points = list(path_points(element.attrib["d"]))
        return box_of(points) if points else None
    return None


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
            for element in root.iter():
                self.assertNotIn(element.tag.removeprefix(SVG),
                                 ("script", "image", "use", "foreignObject", "a", "set"))
                for key in element.attrib:
                    self.assertFalse(key.startswith("on") or "href" in key or key == "style", key)
            self.assertNotIn("url(", text)

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
            for element in root.iter():
                box = text_box(element) if element.tag == f"{SVG}text" else shape_box(element)
                if box is not None:
                    self.assertTrue(view.holds(box, 0.51),
                                    f"{ElementTree.tostring(element)!r} {box} {view}")

        self.each(check)

    def test_have_no_text_upon_another(self) -> None:
        def check(root: ElementTree.Element, _: str) -> None:
            texts = [(text_box(element), element.text) for element in root.iter(f"{SVG}text")]
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
            if name not in TIMED and seen[name] <= 3:
                with self.subTest(file=path.name, picture=name):
                    again = kinestat("plot", name, str(path)).stdout
                    self.assertEqual(again, drawn(path, name).stdout)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
