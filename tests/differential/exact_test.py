#!/usr/bin/env python3
"""Checks analyses of random mechanisms against plain equations in fractions.

Status, every rate and action, twists, wrenches, ratios and powers, and the counts. Values must keep
the digits that are promised, or the bound of the report if it refers to the numbers as typed; what is
zero, or open, must be exactly that.
"""

from __future__ import annotations

import sys
from fractions import Fraction

import differential_case
from batch import Batch, Result
from differential_case import Complaints, DifferentialTest
from exact_network import PLANAR, SPATIAL, Counts, ExactNetwork, Side
from sketch import Sketch

DIGITS = 1e-9  # that `auto` promises of numbers as typed, by solving these where doubles may miss it
ROUNDING = 4 * sys.float_info.epsilon  # of writing a value, and of a sum of two
DERIVED = 1e-11  # of values without a bound of their own, of the largest that they are made of


def differs(actual: float | None, expected: Fraction | None, bound: float) -> bool:
    if actual is None or expected is None:
        return (actual is None) != (expected is None)
    return abs(Fraction(actual) - expected) > Fraction(bound) * abs(expected)


def compare_values(what: str, actual: dict, expected: dict, bound: float) -> list[str]:
    return [f"{what} {name} is {actual.get(name)}, exactly {None if v is None else float(v)}"
            for name, v in expected.items()
            if "?" not in name and (name not in actual or differs(actual[name], v, bound))]


def compare_vectors(what: str, actual: list[float] | None, expected: list[Fraction] | None,
                    size: float) -> list[str]:
    """By shares of the largest of all, for a component may be a difference of large ones."""
    if actual is None or expected is None:
        return [] if actual is expected else [f"{what} is {actual}, exactly {expected}"]
    if any(abs(a - float(e)) > DERIVED * size for a, e in zip(actual, expected)):
        return [f"{what} is {actual}, exactly {[float(e) for e in expected]}"]
    return []


def largest(vectors: list[list[Fraction] | None]) -> float:
    return max((abs(float(x)) for v in vectors if v is not None for x in v), default=0.0)


def bound_of(side: dict) -> float:
    """That of the report, if it refers to the numbers that the fractions have."""
    evidence = side["evidence"]
    is_typed = evidence["refers_to"] == "numbers as typed"
    return evidence["error_bound"] + ROUNDING if is_typed else DIGITS


def compare_side(what: str, side: Side, actual: dict, values: str, wholes: str,
                 vector: str) -> list[str]:
    if actual["status"] == "solved" and side.determined:
        # What no other body feels is left open, and the rest is solved.
        return compare_values(what, actual[values], side.determined, bound_of(actual))
    if actual["status"] != side.status:
        return [f"{what} are {actual['status']}, exactly {side.status}"]
    if side.status not in ("solved", "indeterminate") or not side.values:
        return []
    said = compare_values(what, actual[values], side.values, bound_of(actual))
    size = largest(list(side.wholes.values()))
    for name, expected in side.wholes.items():
        one = actual[wholes].get(name)
        said += compare_vectors(f"{vector} of {name}", one and one[vector], expected, size)
    return said


def compare_counts(what: str, actual: dict, exact: Counts, names: tuple[str, ...]) -> list[str]:
    expected = dict(zip(names, (exact.gross, exact.rank, exact.net, exact.other_net)))
    return [f"{what} {name} is {actual[name]}, exactly {value}"
            for name, value in expected.items() if actual[name] != value]


def compare_mobility(sketch: Sketch, report: dict) -> list[str]:
    said = []
    orders = {"spatial": SPATIAL, **({"planar": PLANAR} if sketch.is_planar else {})}
    for order, coordinates in orders.items():
        if sketch.is_planar and order == "spatial":
            continue  # where the program adds the constraints across the plane
        exact, counts = ExactNetwork(sketch, coordinates), report["mobility"][order]
        said += compare_counts(f"{order} motions", counts, exact.motion_counts(),
                               ("gross_freedom", "rank", "net_freedom", "net_constraint"))
        said += compare_counts(f"{order} actions", counts["statics"], exact.action_counts(),
                               ("gross_constraint", "rank", "net_constraint", "net_freedom"))
    return said


def quotient(above: Fraction | None, below: Fraction | None) -> Fraction | None:
    return None if above is None or not below else above / below


def compare_quotient(case: dict, name: str, expected: Fraction | None) -> list[str]:
    bound = bound_of(case["kinematics"]) + bound_of(case["statics"])
    return compare_values("the", {name: case.get(name)}, {name: expected}, bound)


def compare_actuators(sketch: Sketch, case: dict, motion: Side | None, action: Side) -> list[str]:
    """Ratios and powers, where both sides have values."""
    said = []
    rates = motion.values if motion and motion.status == "solved" else {}
    freedoms = {a.name: f"{a.coupling}.{a.freedom}" for a in sketch.actuators}
    if sketch.input and rates:
        expected = quotient(*(rates[freedoms[n]] for n in (sketch.input, sketch.output)))
        said += compare_quotient(case, "ratio", expected)
    if sketch.input and action.values and rates:
        expected = quotient(action.values[sketch.input], action.values[sketch.output])
        said += compare_quotient(case, "torque_ratio", expected)
    if rates and action.values and case.get("power"):
        powers = {n: None if action.values[n] is None else action.values[n] * rates[f]
                  for n, f in freedoms.items()}
        bound = bound_of(case["kinematics"]) + bound_of(case["statics"])
        size = max((abs(p) for p in powers.values() if p is not None), default=Fraction(0))
        said += [f"power of {n} is {case['power']['actuators'][n]}, exactly {p and float(p)}"
                 for n, p in powers.items()
                 if (p is None) != (case["power"]["actuators"][n] is None) or p is not None and
                 abs(Fraction(case["power"]["actuators"][n]) - p) > Fraction(bound) * size]
    return said


def compare_one(sketch: Sketch, result: Result) -> list[str]:
    if "cases" not in result.report:
        return [f"no report: {result.codes()} {[f['message'] for f in result.findings]}"]
    exact = ExactNetwork(sketch)
    case = result.report["cases"]["case"]
    said = compare_mobility(sketch, result.report)
    motion = exact.motion(sketch.motion) if sketch.motion else None
    if motion:
        said += compare_side("motions", motion, case["kinematics"], "freedoms", "bodies", "twist")
    action = exact.statics(sketch.action or {})
    said += compare_side("actions", action, case["statics"], "actions", "couplings", "wrench")
    return said + compare_actuators(sketch, case, motion, action)


def compare(batch: Batch, sketches: dict[str, Sketch]) -> Complaints:
    """By default, and from the numbers as typed."""
    found: Complaints = {name: [] for name in sketches}
    for options in ((), ("--accuracy", "exact")):
        results = batch.run("analyze", *options)
        for name, sketch in sketches.items():
            found[name] += [f"{' '.join(options)} {text}".strip()
                            for text in compare_one(sketch, results[name])]
    return found


class ExactTest(DifferentialTest):
    def test_planar_mechanisms_have_the_values_of_fractions(self) -> None:
        self.check(True, compare)

    def test_spatial_mechanisms_have_the_values_of_fractions(self) -> None:
        self.check(False, compare)


if __name__ == "__main__":
    differential_case.main()
