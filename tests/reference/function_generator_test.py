#!/usr/bin/env python3
"""Checks function generators against Freudenstein's equation, and the linkages that are written
against their angles. Of a four-bar with ground d, input a, coupler b, output c and the angles phi
and psi of input and output from the ground

    K1 cos psi - K2 cos phi + K3 = cos(phi - psi),  K1 = d/a, K2 = d/c, K3 = (a2 - b2 + c2 + d2)/2ac

Usage: function_generator_test.py PROGRAM [unittest arguments]
"""

from __future__ import annotations

import cmath
import math
import random
import sys
import tempfile
import unittest

import program

EXACT = 1e-9
GRID = 4001  # places of the input at which the transmission angle is looked at


def determinant(m: list[list[float]]) -> float:
    return sum(m[0][k] * (m[1][(k + 1) % 3] * m[2][(k + 2) % 3]
                          - m[1][(k + 2) % 3] * m[2][(k + 1) % 3]) for k in range(3))


class FourBar:
    """Drawn in the first position; angles are from there."""

    def __init__(self, pivots: tuple[complex, complex], a: complex, b: complex) -> None:
        self.a0, self.b0 = pivots
        self.a, self.b = a, b
        self.side = self.side_of(a, b)

    def side_of(self, a: complex, b: complex) -> float:
        """On which side of the dead points."""
        return math.copysign(1.0, ((b - a).conjugate() * (self.b0 - b)).imag)

    def lengths(self) -> list[float]:
        return [abs(self.b0 - self.a0), abs(self.a - self.a0), abs(self.b - self.a),
                abs(self.b - self.b0)]

    def input_at(self, phi: float) -> complex:
        return self.a0 + (self.a - self.a0) * cmath.exp(1j * phi)

    def output_at(self, psi: float) -> complex:
        return self.b0 + (self.b - self.b0) * cmath.exp(1j * psi)

    def psi(self, phi: float) -> float:
        """By the circles about A and B0."""
        a = self.input_at(phi)
        coupler, output = abs(self.b - self.a), abs(self.b - self.b0)
        across = self.b0 - a
        along = (coupler ** 2 - output ** 2 + abs(across) ** 2) / (2 * abs(across))
        height = math.sqrt(max(0.0, coupler ** 2 - along ** 2))
        for sign in (1.0, -1.0):
            b = a + across / abs(across) * complex(along, sign * height)
            if self.side_of(a, b) == self.side:
                return cmath.phase((b - self.b0) / (self.b - self.b0))
        raise AssertionError("no place of the output")

    def transmission(self, phi: float) -> float:
        """At the output link, from a dead point; zero where the input cannot go."""
        _, _, coupler, output = self.lengths()
        across = abs(self.b0 - self.input_at(phi))
        cosine = (coupler ** 2 + output ** 2 - across ** 2) / (2 * coupler * output)
        if abs(cosine) > 1:
            return 0.0
        angle = math.acos(cosine)
        return min(angle, math.pi - angle)

    def least(self, arc: float) -> float:
        return min(self.transmission(arc * i / (GRID - 1)) for i in range(GRID))


def freudenstein(pivots: tuple[complex, complex], phi_0: float, psi_0: float, phi: list[float],
                 psi: list[float]) -> FourBar:
    """The first angles are free; a link below zero points the other way."""
    rows = [([math.cos(psi_0 + s), -math.cos(phi_0 + p), 1.0], math.cos(phi_0 + p - psi_0 - s))
            for p, s in zip(phi, psi)]
    whole = determinant([row for row, _ in rows])
    k1, k2 = (determinant([[right if i == k else row[i] for i in range(3)] for row, right in rows])
              / whole for k in range(2))
    ground = pivots[1] - pivots[0]
    return FourBar(pivots, pivots[0] + ground / k1 * cmath.exp(1j * phi_0),
                   pivots[1] + ground / k2 * cmath.exp(1j * psi_0))


def point(z: complex) -> str:
    return f"[{z.real!r}, {z.imag!r}]"


def task(pivots: tuple[complex, complex], phi: list[float], psi: list[float],
         a: complex | None = None, b: complex | None = None, more: str = "") -> str:
    def link(pivot: complex, angles: list[float], given: complex | None) -> str:
        circle_point = f", circle_point: {point(given)}" if given is not None else ""
        return f"{{centre_point: {point(pivot)}, angles: {angles}{circle_point}}}"

    return (f"kinestat: 1\nsynthesis:\n  function:\n    input: {link(pivots[0], phi, a)}\n"
            f"    output: {link(pivots[1], psi, b)}\n{more}")


def solve(text: str) -> dict:
    return program.synthesize("-", text=text)["synthesis"]["tasks"][0]


# y = x^1.5 from 1 to 4 at Chebyshev's places; a quarter turn of both links.
X = [2.5 + 1.5 * math.cos(math.radians(angle)) for angle in (150, 90, 30)]
PHI = [(x - X[0]) / 3 * math.pi / 2 for x in X]
PSI = [(x ** 1.5 - X[0] ** 1.5) / 7 * math.pi / 2 for x in X]


class FunctionGenerators(unittest.TestCase):
    def check_links(self, found: dict, linkage: dict, four_bar: FourBar, share: float) -> None:
        lengths = [linkage["lengths"][key] for key in ("ground", "crank_one", "coupler",
                                                       "crank_other")]
        for length, wanted in zip(lengths, four_bar.lengths()):
            self.assertAlmostEqual(length / wanted, 1.0, delta=share)
        one, other = (found["dyads"][i] for i in linkage["dyads"])
        size = max(four_bar.lengths())
        for got, wanted in ((one["centre_point"], four_bar.a0), (one["circle_point"], four_bar.a),
                            (other["centre_point"], four_bar.b0),
                            (other["circle_point"], four_bar.b)):
            self.assertLess(abs(complex(*got) - wanted), share * size)

    def check_margin(self, linkage: dict, four_bar: FourBar, arc: float) -> None:
        """The grid misses its extreme by far less than this."""
        self.assertAlmostEqual(linkage["margin"], four_bar.least(arc), delta=1e-6)

    def check_motion(self, text: str, phi: list[float], psi: list[float], margin: float) -> None:
        """The files of usable linkages pass the precision points and keep the margin."""
        with tempfile.TemporaryDirectory() as folder:
            report = program.synthesize("--write-mechanism", folder, "-", text=text)
            file = report["synthesis"]["tasks"][0]["linkages"][0]["file"]
            for p, s in zip(phi[1:], psi[1:]):
                motion = program.run("motion", "--to", repr(p), "--steps", "20", file)["motion"]
                self.assertEqual(motion["status"], "complete")
                last = dict(zip((one["name"] for one in motion["columns"]), motion["rows"][-1]))
                self.assertLess(abs(math.remainder(last["B0.wz/position"] - s, 2 * math.pi)), EXACT)
            motion = program.run("motion", "--steps", "400", file)["motion"]
            names = [one["name"] for one in motion["columns"]]
            angles = [row[names.index("output/transmission_angle")] for row in motion["rows"]]
            least = min(min(mu, math.pi - mu) for mu in angles)
            self.assertAlmostEqual(least, margin, delta=1e-3)
            self.assertGreater(least, margin - EXACT)

    def test_agree_with_freudenstein(self) -> None:
        numbers = random.Random(7)
        usable = defects = 0
        pivots = (complex(3, -2), complex(8, 1))
        for _ in range(100):
            phi_0, psi_0 = numbers.uniform(-3, 3), numbers.uniform(-3, 3)
            four_bar = freudenstein(pivots, phi_0, psi_0, PHI, PSI)
            links = four_bar.lengths()
            if max(links) > 30 * min(links):
                continue
            for given in ({"a": four_bar.a}, {"b": four_bar.b}):
                text = task(pivots, PHI, PSI, **given)
                found = solve(text)
                linkage = found["linkages"][0]
                self.check_links(found, linkage, four_bar, 1e-9)
                sides = {four_bar.side_of(four_bar.input_at(p), four_bar.output_at(s))
                         for p, s in zip(PHI, PSI)}
                if len(sides) == 1 and four_bar.least(PHI[-1]) > 0:
                    self.assertIsNone(linkage["defect"])
                    self.check_margin(linkage, four_bar, PHI[-1])
                    usable += 1
                    if usable % 8 == 1:
                        self.check_motion(text, PHI, PSI, linkage["margin"])
                else:
                    self.assertIn(linkage["defect"], ("circuit", "branch", "order"))
                    defects += 1
        self.assertGreater(usable, 10)
        self.assertGreater(defects, 10)

    def test_the_transmission_angle_is_that_of_the_linkage_as_built(self) -> None:
        """Seen from the output link the same task has a margin of 51 degrees."""
        given = complex(76.98626325588035, 95.16808143769853)
        linkage = solve(task((0j, 100 + 0j), PHI, PSI, a=given))["linkages"][0]
        self.assertAlmostEqual(math.degrees(linkage["margin"]), 17.1574, delta=1e-4)

    def test_a_search_finds_the_best_of_all_first_angles(self) -> None:
        """Of linkages whose input pivot lies in the area none on a grid is better."""
        pivots = (0j, 100 + 0j)
        text = task(pivots, PHI, PSI, more="  vary: {circle_points: {from: [-100, -100], to: [100, "
                    "100]}, samples: 10000}\n  limits: {link_ratio: 5}\n")
        best = solve(text)["linkages"][0]
        self.check_motion(text, PHI, PSI, best["margin"])
        for i in range(120):
            for j in range(120):
                four_bar = freudenstein(pivots, i * math.pi / 60, j * math.pi / 60, PHI, PSI)
                links = four_bar.lengths()
                if (max(abs(four_bar.a.real), abs(four_bar.a.imag)) > 100
                        or max(links) > 5 * min(links)):
                    continue
                sides = {four_bar.side_of(four_bar.input_at(p), four_bar.output_at(s))
                         for p, s in zip(PHI, PSI)}
                at_ends = min(four_bar.transmission(p) for p in (0.0, PHI[-1]))
                if len(sides) == 1 and at_ends > best["margin"]:
                    self.assertLessEqual(four_bar.least(PHI[-1]), best["margin"] + 1e-3)

    def test_find_a_known_linkage(self) -> None:
        """Five angles of a crank-rocker have it among their answers, four with its input pivot."""
        four_bar = FourBar((complex(-1, 2), complex(2.5, 2.7)), complex(-0.3, 2.9),
                           complex(2.0, 5.2))
        phi = [0.0, 0.5, 1.1, 1.9, 2.8]
        psi = [four_bar.psi(p) for p in phi]
        pivots = (four_bar.a0, four_bar.b0)
        for count, given in ((5, {}), (4, {"a": four_bar.a}), (4, {"b": four_bar.b})):
            text = task(pivots, phi[:count], psi[:count], **given)
            found = solve(text)
            linkage = min(found["linkages"], key=lambda one: abs(
                complex(*found["dyads"][one["dyads"][0]]["circle_point"]) - four_bar.a))
            self.check_links(found, linkage, four_bar, 1e-8)
            self.assertIsNone(linkage["defect"])
            self.check_margin(linkage, four_bar, phi[count - 1])
            self.assertEqual(linkage["grashof"]["class"], "crank_rocker")
            for one in found["linkages"]:
                for i in one["dyads"]:
                    self.assertLess(found["dyads"][i]["residual"], 1e-9)

    def test_the_input_goes_the_way_that_is_asked_for(self) -> None:
        """A crank comes to a second place both ways; the output passes other angles then."""
        four_bar = FourBar((0j, 4 + 0j), complex(0.8, 0.6), complex(3.2, 2.9))
        for way in (2.5, 2.5 - 2 * math.pi):
            found = solve(task((0j, 4 + 0j), [0.0, way], [0.0, four_bar.psi(way)],
                               four_bar.a, four_bar.b))
            linkage = found["linkages"][0]
            self.assertEqual(linkage["drives"][0]["passage"],
                             "increasing" if way > 0 else "decreasing")
            self.assertAlmostEqual(linkage["drives"][0]["arc"], way, delta=EXACT)
            self.check_margin(linkage, four_bar, way)


if __name__ == "__main__":
    program.use(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
