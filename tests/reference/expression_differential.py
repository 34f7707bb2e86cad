#!/usr/bin/env python3
"""Checks the program's expressions against another parser: Python's own, on translated text.

Random expressions become parameters of a mechanism file; the values in the report must be those
that Python finds for the same text, and faulty ones must be refused in their lines.

Usage: expression_differential.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import ast
import functools
import json
import math
import random
import re
import subprocess
import sys
import unittest
from dataclasses import dataclass
from fractions import Fraction
from typing import Callable

PROGRAM = ""
SEEDS = range(4)
EXPRESSIONS = 1000  # a seed
FAULTS = 20  # a seed; the program shows that many errors of one file

Dimension = tuple[int, int, int, int]  # length, mass, time, angle

BARE: Dimension = (0, 0, 0, 0)
LENGTH: Dimension = (1, 0, 0, 0)
ANGLE: Dimension = (0, 0, 0, 1)
FORCE: Dimension = (1, 1, -2, 0)
MOMENT: Dimension = (2, 1, -2, 0)

# Size in SI and dimension, from the definitions of the units.
UNITS: dict[str, tuple[Fraction | float, Dimension]] = {
    "m": (Fraction(1), LENGTH),
    "mm": (Fraction(1, 1000), LENGTH),
    "um": (Fraction(1, 10**6), LENGTH),
    "cm": (Fraction(1, 100), LENGTH),
    "km": (Fraction(1000), LENGTH),
    "in": (Fraction(254, 10000), LENGTH),
    "rad": (Fraction(1), ANGLE),
    "deg": (math.pi / 180, ANGLE),
    "rev": (2 * math.pi, ANGLE),
    "s": (Fraction(1), (0, 0, 1, 0)),
    "min": (Fraction(60), (0, 0, 1, 0)),
    "h": (Fraction(3600), (0, 0, 1, 0)),
    "kg": (Fraction(1), (0, 1, 0, 0)),
    "g": (Fraction(1, 1000), (0, 1, 0, 0)),
    "N": (Fraction(1), FORCE),
    "kN": (Fraction(1000), FORCE),
    "Nm": (Fraction(1), MOMENT),
    "rpm": (math.pi / 30, (0, 0, -1, 1)),
    "W": (Fraction(1), (2, 1, -3, 0)),
    "kW": (Fraction(1000), (2, 1, -3, 0)),
}
SPELLINGS: dict[Dimension, list[str]] = {
    BARE: ["", ""],
    LENGTH: [" mm", "mm", "*m", " in", "*cm"],
    ANGLE: [" deg", "deg", " rad", "*rev"],
    (0, 0, 1, 0): [" s", " min", "*h"],
    FORCE: [" N", "*kN"],
    MOMENT: [" N*m", " Nm", "*N*mm", " kN*m"],
    (2, 0, 0, 0): [" mm^2", "*m^2", " mm*cm"],
    (0, 0, -1, 1): [" rpm", " rad/s", " rev/min"],
    (1, 0, -1, 0): [" m/s", " mm/s"],
    (0, 1, -2, 0): [" N/mm", " N/m"],
}


# The meaning of a text


class Fault(Exception):
    """No value; the text is the code of the error."""


class Unclear(Exception):
    """Rounding decides whether there is a value, or which: not for comparison."""


@dataclass
class Value:
    """A fraction where it stays one, with a bound for the rounding of the program's doubles."""

    number: Fraction | float
    dimension: Dimension
    error: float = 0.0

    @property
    def is_whole(self) -> bool:
        return self.number == math.floor(self.number)


def made(number: Fraction | float, dimension: Dimension, error: float = 0.0) -> Value:
    size = abs(float(number))
    if size > 1e60 or 0 < size < 1e-60:
        raise Unclear
    is_exact = isinstance(number, Fraction) and number.denominator == 1 and error == 0
    return Value(number, dimension, 0.0 if is_exact else error + 1e-15 * size)


def certain(value: Value, level: Fraction | float = 0) -> None:
    """Refuses a value that may be on either side of a level, or is relatively loose there."""
    if value.error > 0 and abs(float(value.number - level)) <= 1e6 * value.error:
        raise Unclear


def same(a: Value, b: Value) -> None:
    if a.dimension != b.dimension:
        raise Fault("E0309")


def bare(value: Value) -> None:
    if value.dimension != BARE:
        raise Fault("E0309")


def times(a: Value, b: Value) -> Value:
    error = a.error * abs(float(b.number)) + b.error * abs(float(a.number))
    dimension = tuple(p + q for p, q in zip(a.dimension, b.dimension))
    return made(a.number * b.number, dimension, error)


def over(a: Value, b: Value) -> Value:
    certain(b)
    if b.number == 0:
        raise Fault("E0316")
    quotient = a.number / b.number
    error = (a.error + b.error * abs(float(quotient))) / abs(float(b.number))
    return made(quotient, tuple(p - q for p, q in zip(a.dimension, b.dimension)), error)


def plus(a: Value, b: Value) -> Value:
    same(a, b)
    return made(a.number + b.number, a.dimension, a.error + b.error)


def minus(a: Value, b: Value) -> Value:
    same(a, b)
    return made(a.number - b.number, a.dimension, a.error + b.error)


def power(a: Value, b: Value) -> Value:
    bare(b)
    if b.error > 0 and abs(float(b.number) - round(b.number)) <= 1e6 * b.error:
        raise Unclear
    if a.dimension != BARE and not b.is_whole:
        raise Fault("E0309")
    certain(a)
    if (a.number == 0 and b.number < 0) or (a.number < 0 and not b.is_whole):
        raise Fault("E0316")
    if abs(b.number) > 30:
        raise Unclear
    number = a.number ** (int(b.number) if b.is_whole else float(b.number))
    by_a = float(b.number) * float(number / a.number) if a.number else 0.0
    by_b = float(number) * math.log(a.number) if a.number > 0 else 0.0
    dimension = tuple(p * int(b.number) for p in a.dimension) if a.dimension != BARE else BARE
    return made(number, dimension, abs(by_a) * a.error + abs(by_b) * b.error)


def of_angle(function: Callable[[float], float]) -> Callable[[Value], Value]:
    def apply(a: Value) -> Value:
        if a.dimension != ANGLE:
            raise Fault("E0309")
        number = function(float(a.number))
        if abs(a.number) > 1e4 or a.error > 1e-9 or abs(number) > 1e3:
            raise Unclear
        return made(number, BARE, (2 + 2 * number**2) * a.error + 1e-15)

    return apply


def of_ratio(function: Callable[[float], float]) -> Callable[[Value], Value]:
    def apply(a: Value) -> Value:
        bare(a)
        if function is not math.atan:
            certain(a, 1)
            certain(a, -1)
            if abs(a.number) > 1:
                raise Fault("E0316")
        return made(function(float(a.number)), ANGLE, 1e3 * a.error + 1e-15)

    return apply


def logarithm(function: Callable[[float], float]) -> Callable[[Value], Value]:
    def apply(a: Value) -> Value:
        bare(a)
        certain(a)
        if a.number <= 0:
            raise Fault("E0316")
        return made(function(float(a.number)), BARE, a.error / float(a.number) + 1e-15)

    return apply


def exponential(a: Value) -> Value:
    bare(a)
    if abs(a.number) > 50 or a.error > 1e-9:
        raise Unclear
    return made(math.exp(a.number), BARE, 2 * math.exp(a.number) * a.error)


def root(a: Value) -> Value:
    if any(p % 2 for p in a.dimension):
        raise Fault("E0309")
    certain(a)
    if a.number < 0:
        raise Fault("E0316")
    number = math.sqrt(a.number)
    error = a.error / number if number else 0.0
    return made(number, tuple(p // 2 for p in a.dimension), error)


def step(function: Callable[[Fraction | float], int], shift: float) -> Callable[[Value], Value]:
    def apply(a: Value) -> Value:
        bare(a)
        certain(a, round(a.number + Fraction(shift)) - Fraction(shift))
        return made(Fraction(function(a.number)), BARE)

    return apply


def half_away(number: Fraction | float) -> int:
    return math.floor(abs(number) + Fraction(1, 2)) * (-1 if number < 0 else 1)


def modulo(a: Value, b: Value) -> Value:
    same(a, b)
    certain(b)
    if b.number == 0:
        raise Fault("E0316")
    ratio = over(a, b)
    certain(ratio, round(ratio.number))
    count = math.floor(ratio.number)
    error = a.error + abs(count) * b.error
    return made(a.number - count * b.number, a.dimension,
                error + (1e-15 * abs(float(a.number)) if error else 0.0))


def divisor(a: Value, b: Value) -> Value:
    same(a, b)
    bare(a)
    certain(a, round(a.number))
    certain(b, round(b.number))
    if not a.is_whole or not b.is_whole:
        raise Fault("E0316")
    return made(Fraction(math.gcd(int(a.number), int(b.number))), BARE)


def pair(function: Callable[..., float],
         dimension: Dimension | None = None) -> Callable[..., Value]:
    def apply(a: Value, b: Value) -> Value:
        same(a, b)
        size = math.hypot(a.number, b.number)
        if function is math.atan2 and (a.error or b.error or size == 0):
            certain(a)
            certain(b)
        error = a.error + b.error
        if function is math.atan2 and size:
            error = error / size + 1e-15
        return made(function(a.number, b.number), dimension or a.dimension, error)

    return apply


FUNCTIONS: dict[str, Callable[..., Value]] = {
    "sin": of_angle(math.sin), "cos": of_angle(math.cos), "tan": of_angle(math.tan),
    "asin": of_ratio(math.asin), "acos": of_ratio(math.acos), "atan": of_ratio(math.atan),
    "atan2": pair(math.atan2, ANGLE), "sqrt": root, "exp": exponential,
    "abs": lambda a: made(abs(a.number), a.dimension, a.error),
    "log": logarithm(math.log), "ln": logarithm(math.log), "log10": logarithm(math.log10),
    "min": pair(min), "max": pair(max), "hypot": pair(math.hypot),
    "floor": step(math.floor, 0), "ceil": step(math.ceil, 0), "round": step(half_away, 0.5),
    "mod": modulo, "gcd": divisor,
}  # fmt: skip
OPERATIONS = {ast.Add: plus, ast.Sub: minus, ast.Mult: times, ast.Div: over, ast.Pow: power}


def translated(text: str) -> str:
    """The text as Python: ^ is **, and a unit directly after a number or ')' becomes a call."""
    pattern = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[A-Za-z_]\w*|\S"
    tokens = re.findall(pattern, text)
    done: list[str] = []
    opened: list[int] = []
    at = 0
    while at < len(tokens):
        token = tokens[at]
        after = tokens[at + 1] if at + 1 < len(tokens) else ""
        begin = len(done)
        if token == "(":
            opened.append(begin)
        if token == ")":
            begin = opened.pop()
        done.append("**" if token == "^" else token)
        is_value = token == ")" or re.fullmatch(r"[\d.].*", token) is not None
        if is_value and after in UNITS:
            unit, at = measure_unit(tokens, at + 1)
            done[begin:] = ["measure(", *done[begin:], ",", unit, ")"]
        elif token in UNITS and after != "(":
            done[-1] = f"unit_{token}"
        at += 1
    return "".join(done)


def measure_unit(tokens: list[str], at: int) -> tuple[str, int]:
    """The unit at a token with its exponent, and the last token that belongs to it."""
    if at + 2 < len(tokens) and tokens[at + 1] == "^":
        return f"unit_{tokens[at]}**{tokens[at + 2]}", at + 2
    return f"unit_{tokens[at]}", at


def meaning(text: str) -> Value:
    source = translated(text)
    return walk(ast.parse(source, mode="eval").body, source)


def walk(node: ast.expr, source: str) -> Value:
    if isinstance(node, ast.Constant):
        return made(Fraction(ast.get_source_segment(source, node) or ""), BARE)
    if isinstance(node, ast.Name):
        if node.id == "pi":
            return made(math.pi, BARE)
        return made(*UNITS[node.id.removeprefix("unit_")])
    if isinstance(node, ast.UnaryOp):
        operand = walk(node.operand, source)
        is_minus = isinstance(node.op, ast.USub)
        return Value(-operand.number, operand.dimension, operand.error) if is_minus else operand
    if isinstance(node, ast.BinOp):
        return OPERATIONS[type(node.op)](walk(node.left, source), walk(node.right, source))
    assert isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    values = [walk(value, source) for value in node.args]
    if node.func.id == "measure":
        return times(values[0], values[1])
    function = FUNCTIONS[node.func.id]
    result = function(*values[:2])
    for value in values[2:]:
        result = function(result, value)
    return result


# Texts


class Writer:
    """Writes expressions of a dimension, at times with a slip of one."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)

    def number(self) -> str:
        whole = str(self.random.randint(0, 60))
        return self.random.choice([whole, whole, f"{whole}.5", f"{whole}.125", f"{whole}e-1",
                                   f".{whole}", f"{whole}.", f"{whole}.0E+1"])

    def leaf(self, dimension: Dimension) -> str:
        unit = self.random.choice(SPELLINGS.get(dimension, [""]))
        number = self.number()
        if number.endswith(".") and unit and unit[0].isalpha():
            number += "0"
        if unit and unit[0] == " " and self.random.random() < 0.2:
            number = f"({self.number()}/{self.random.randint(1, 9)})"
        return number + unit

    def blank(self) -> str:
        return " " if self.random.random() < 0.5 else ""

    def text(self, dimension: Dimension, depth: int) -> str:
        if self.random.random() < 0.01:
            dimension = self.random.choice(list(SPELLINGS))
        if depth <= 0:
            return self.leaf(dimension)
        inner = self.compound(dimension, depth - 1)
        return f"({inner})" if self.random.random() < 0.3 else inner

    def compound(self, dimension: Dimension, depth: int) -> str:
        a = self.text(dimension, depth)
        b = self.text(dimension, depth)
        factor = self.text(BARE, depth)
        if dimension == BARE and self.random.random() < 0.5:
            return self.bare_call(depth)
        if dimension == ANGLE and self.random.random() < 0.3:
            name = self.random.choice(["asin", "acos", "atan"])
            return self.random.choice([f"{name}({factor})", f"atan2({factor}, {factor}+1)"])
        return self.random.choice([
            f"{a}{self.blank()}+{self.blank()}{b}", f"{a} - {b}", f"{a}-{b}", f"-{a}", f"- ({a})",
            f"{factor}*({a})", f"({a})/({factor})", f"{a}/{self.random.randint(0, 12)}",
            f"abs({a})", f"min({a}, {b})", f"max({a},{b}, {a})", f"mod({a}, {b})",
            f"hypot({a}, {b})", f"sqrt(({a})*({b}))", f"({a})^1", f"({a})^2/({b})",
            f"{factor}*{b}", f"({factor})^-1*({b})",
        ])  # fmt: skip

    def bare_call(self, depth: int) -> str:
        angle = self.text(ANGLE, depth)
        number = self.text(BARE, depth)
        length = self.text(LENGTH, depth)
        name = self.random.choice(["sin", "cos", "tan"])
        other = self.random.choice(["floor", "ceil", "round", "exp", "log", "ln", "log10"])
        return self.random.choice([
            f"{name}({angle})", f"{name} ( {angle} )", f"{other}({number})", "pi", f"2^({number})",
            f"-2^2*{number}", f"2^3^{self.random.randint(0, 2)}", f"({length})/({length} + 1 mm)",
            f"gcd({self.random.randint(0, 90)}, {self.random.randint(0, 90)})",
            f"{self.random.randint(0, 30)} mm/2 mm*{number}", f"(({length})^2/(2 mm^2))",
        ])  # fmt: skip


@functools.cache
def written(seed: int) -> list[tuple[str, Value | str]]:
    """Texts with their values, or the codes of their errors."""
    writer = Writer(seed)
    found: list[tuple[str, Value | str]] = []
    while len(found) < 2 * EXPRESSIONS:
        text = writer.text(writer.random.choice(list(SPELLINGS)), writer.random.randint(0, 3))
        try:
            found.append((text, meaning(text)))
        except Fault as fault:
            found.append((text, str(fault)))
        except (Unclear, OverflowError):
            pass
    return found


# The program


def mechanism(texts: list[str]) -> str:
    lines = ["kinestat: 1", "space: planar", "ground: frame", "bodies: [crank]", "couplings:",
             "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}", "parameters:"]
    return "\n".join(lines + [f"  p{i}: '{text}'" for i, text in enumerate(texts)]) + "\n"


FIRST_LINE = 8  # of the parameters


def run(command: list[str], text: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([PROGRAM, *command, "-"], input=text, capture_output=True, text=True,
                          check=False)


def dimension_of_unit(text: str) -> Dimension:
    """From the unit of the report, which is SI here: "N*m", "rad/s", "kg*m^2/s", "1/s"."""
    if not text or text == "1":
        return BARE
    value = meaning(text)
    assert value.number == 1, text
    return value.dimension


class ExpressionTest(unittest.TestCase):
    def check_values(self, pairs: list[tuple[str, Value]]) -> None:
        done = run(["analyze", "--format", "json"], mechanism([text for text, _ in pairs]))
        self.assertEqual(done.returncode, 0, done.stderr)
        parameters = json.loads(done.stdout)["mechanism"]["parameters"]
        for i, (text, value) in enumerate(pairs):
            actual = parameters[f"p{i}"]
            self.assertEqual(actual["expression"], text)
            self.assertEqual(dimension_of_unit(actual["unit"]), value.dimension, text)
            self.assertLessEqual(abs(actual["value"] - float(value.number)),
                                 value.error + 1e-12 * abs(float(value.number)),
                                 f"{text}: {actual['value']} is not {float(value.number)}")

    def test_values(self) -> None:
        for seed in SEEDS:
            with self.subTest(seed=seed):
                pairs = [(text, v) for text, v in written(seed) if isinstance(v, Value)]
                self.assertGreaterEqual(len(pairs), EXPRESSIONS)
                self.check_values(pairs[:EXPRESSIONS])

    def test_faults_in_their_lines(self) -> None:
        for seed in SEEDS:
            with self.subTest(seed=seed):
                pairs = [(text, v) for text, v in written(seed) if isinstance(v, str)]
                self.assertGreaterEqual(len(pairs), FAULTS)
                done = run(["check"], mechanism([text for text, _ in pairs[:FAULTS]]))
                self.assertNotEqual(done.returncode, 0)
                errors = re.findall(r":(\d+):\d+: error\[(\w+)\]", done.stderr)
                expected = [(str(FIRST_LINE + i), code) for i, (_, code) in enumerate(pairs)]
                self.assertEqual(errors, expected[:FAULTS], done.stderr)

    def test_fraction_before_a_unit_is_told_how_to_write_it(self) -> None:
        text = mechanism([]).replace("at: [0, 0]", "at: [1/2 mm, 0]").replace("parameters:\n", "")
        done = run(["check"], text)
        self.assertIn("write (1/2) mm", done.stderr)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
