#!/usr/bin/env python3
"""Samples of a sweep, end to end: rows agree with a second implementation, means with closed forms."""

from __future__ import annotations

import csv
import json
import math
from collections import Counter

from sweep_case import TRAIN, InFolder, kinestat, main

LOW = 2**32 - 1
ALL = 2**64 - 1

# Degree, polynomial and first direction numbers of the dimensions behind the first, as the table
# new-joe-kuo-6.21201 of Joe and Kuo 2008 has them.
JOE_KUO = [(1, 0, [1]), (2, 1, [1, 3]), (3, 1, [1, 3, 1]), (3, 2, [1, 1, 1]),
           (4, 1, [1, 1, 3, 3]), (4, 4, [1, 3, 5, 13]), (5, 2, [1, 1, 5, 5, 17]),
           (5, 4, [1, 1, 5, 5, 5]), (5, 7, [1, 1, 7, 11, 19])]


def philox(counter: list[int], key: list[int]) -> list[int]:
    """Salmon et al. 2011, Philox 4x32 with ten rounds."""
    for _ in range(10):
        first, second = 0xD2511F53 * counter[0], 0xCD9E8D57 * counter[2]
        counter = [(second >> 32) ^ counter[1] ^ key[0], second & LOW,
                   (first >> 32) ^ counter[3] ^ key[1], first & LOW]
        key = [(key[0] + 0x9E3779B9) & LOW, (key[1] + 0xBB67AE85) & LOW]
    return counter


def bits(seed: int, stream: int, index: int) -> int:
    words = philox([index & LOW, index >> 32, stream & LOW, stream >> 32], [seed, 0])
    return words[1] << 32 | words[0]


def sobol(index: int, dimension: int) -> int:
    """As a share of 2^64: the digits of the index by those of Joe and Kuo's notes, their equations 2
    and 3, in the order of the Gray code."""
    if dimension == 0:
        numbers = [1] * 64
    else:
        degree, polynomial, numbers = JOE_KUO[dimension - 1]
        numbers = list(numbers)
        for k in range(degree, 64):
            number = numbers[k - degree] ^ (numbers[k - degree] << degree)
            for i in range(1, degree):
                if polynomial >> (degree - 1 - i) & 1:
                    number ^= numbers[k - i] << i
            numbers.append(number)
    gray = index ^ index >> 1
    point = 0
    for k in range(64):
        if gray >> k & 1:
            point ^= numbers[k] << (63 - k)
    return point


def mixed(z: int) -> int:
    z = ((z ^ z >> 30) * 0xBF58476D1CE4E5B9) & ALL
    z = ((z ^ z >> 27) * 0x94D049BB133111EB) & ALL
    return z ^ z >> 31


def part(index: int, count: int, keys: list[int]) -> int:
    """A Feistel network on the numbers of so many bits, walked until it is below the count."""
    width = (count - 1).bit_length()
    low = width - width // 2
    while True:
        left, left_bits = index >> low, width // 2
        right, right_bits = index % 2**low, low
        for key in keys:
            changed = left ^ mixed((right + key) & ALL) % 2**left_bits
            left, left_bits, right, right_bits = right, right_bits, changed, left_bits
        index = left << low | right
        if index < count:
            return index


def place(method: str, seed: int, count: int, axes: int, state: int, axis: int,
          size: int | None) -> int:
    """On an axis of so many values, or on the 2^53 of a whole range."""
    places = size or 2**53
    shift = bits(seed, axes + axis, 0)
    if method == "sobol":
        return places * (sobol(state, axis) ^ shift) >> 64
    if method == "random":
        return places * bits(seed, axis, state) >> 64
    which = part(state, count, [bits(seed, 2 * axes + axis, i) for i in range(8)])
    if size:
        return (which * size + (size * shift >> 64)) // count
    least, end = -(-which * places // count), -(-(which + 1) * places // count)
    return least + ((end - least) * bits(seed, axis, state) >> 64)


def within(least: float, most: float, share: int) -> float:
    u = share / 2**53
    return min(max(least * (1 - u) + most * u, least), most)


def sample(count: int, method: str, seed: int = 1) -> str:
    return f"  sample: {{count: {count}, method: {method}, seed: {seed}}}\n"


class Draws(InFolder):
    """Which values states have."""

    NP = [17, 18, 20, 25]
    VARY = """
sweep:
  vary:
    Ns: {from: 17, to: 40, step: 1}
    Np: {values: [17, 18, 20, 25]}
    torque: {from: 1 N*m, to: 3 N*m}
    module: {from: 1, to: 2.5}
  cases: [low]
  report: [ratio, brake]
"""

    def test_are_those_of_a_second_implementation(self) -> None:
        for method in ("sobol", "random", "latin"):
            for seed, count in ((1, 100), (4294967295, 37)):
                rows = self.rows(TRAIN + self.VARY + sample(count, method, seed))
                self.assertEqual(len(rows), count)
                for state, row in enumerate(rows):
                    def drawn(axis: int, size: int | None) -> int:
                        return place(method, seed, count, 4, state, axis, size)
                    self.assertEqual(int(row["Ns"]), 17 + drawn(0, 24))
                    self.assertEqual(int(row["Np"]), self.NP[drawn(1, 4)])
                    self.assertEqual(float(row["torque [N*m]"]), within(1, 3, drawn(2, None)))
                    self.assertEqual(float(row["module"]), within(1, 2.5, drawn(3, None)))

    def test_give_the_numbers_of_closed_forms(self) -> None:
        """Willis: with the ring held 2 + 2 Np/Ns; it bears Nr/Ns of the torque of the sun."""
        for row in self.rows(TRAIN + self.VARY + sample(200, "random")):
            sun, planet = int(row["Ns"]), int(row["Np"])
            self.assertAlmostEqual(float(row["ratio"]), 2 + 2 * planet / sun, places=12)
            self.assertAlmostEqual(float(row["brake [N*m]"]),
                                   float(row["torque [N*m]"]) * (sun + 2 * planet) / sun, places=12)
            self.assertEqual(row["status"], "solved")

    def test_have_the_rows_of_the_whole_sweep(self) -> None:
        vary = self.VARY.replace("to: 3 N*m}", "to: 3 N*m, step: 0.5 N*m}").replace(
            "    module: {from: 1, to: 2.5}\n", "").replace("  cases: [low]\n", "")
        whole = kinestat("sweep", self.write(TRAIN + vary)).stdout.splitlines()
        for method in ("sobol", "random", "latin"):
            text = TRAIN + vary + '  require: ["mod(Ns + Nr, 3) == 0"]\n' + sample(300, method)
            done = kinestat("sweep", self.write(text))
            drawn = done.stdout.splitlines()
            self.assertEqual(drawn[0], whole[0])
            self.assertLess(set(drawn), set(whole))
            self.assertIn(f"train: 300 states, {(len(drawn) - 1) // 2} analysed", done.stderr)
            left_out = 300 - (len(drawn) - 1) // 2
            self.assertIn(f"excluded by 'mod(Ns + Nr, 3) == 0': {left_out}\n", done.stderr)
            self.assertTrue(100 < left_out < 300)
            self.assertTrue(all((2 * int(row["Ns"]) + 2 * int(row["Np"])) % 3 == 0
                                for row in csv.DictReader(drawn)))

    def test_fall_evenly_on_values(self) -> None:
        """Of 192 draws of 24 and of 4 values; of the first 2^m of Sobol each 2^m-th of a range has
        one."""
        for method in ("latin", "sobol"):
            rows = self.rows(TRAIN + self.VARY + sample(192 if method == "latin" else 256, method))
            self.assertEqual(set(Counter(row["Np"] for row in rows).values()),
                             {48 if method == "latin" else 64})
            moduli = Counter(int((float(row["module"]) - 1) / 1.5 * len(rows)) for row in rows)
            self.assertEqual(moduli, {i: 1 for i in range(len(rows))})
        teeth = Counter(row["Ns"] for row in self.rows(TRAIN + self.VARY + sample(192, "latin")))
        self.assertEqual(teeth, {str(17 + i): 8 for i in range(24)})

    def test_are_told_in_the_summary(self) -> None:
        out = self.new_folder("out")
        text = TRAIN + self.VARY + "  sample: {count: 20}\n"
        kinestat("sweep", "--out", out, self.write(text))
        summary = json.loads((out / "train.sweep.json").read_text())
        self.assertEqual(summary["sample"], {"count": 20, "method": "sobol", "seed": 1})
        self.assertEqual(summary["states"], 20)

    def test_follow_what_is_set(self) -> None:
        file = self.write(TRAIN.replace("module: 2,", "module: 2, draws: 3,") + self.VARY +
                          "  sample: {count: 2*draws}\n")
        self.assertEqual(kinestat("sweep", file).stdout.count("low"), 6)
        self.assertEqual(kinestat("sweep", "--set", "draws=5", file).stdout.count("low"), 10)


class Means(InFolder):
    """Means over a range, whose closed forms are integrals."""

    VARY = """
sweep:
  vary:
    Ns: {from: 20, to: 40}
    Np: {from: 16, to: 24}
  cases: [low]
  report: [ratio]
"""
    # Of 2 + 2 Np/Ns over the rectangle.
    MEAN = 2 + 2 * 20 * math.log(2) / 20

    def error(self, count: int, method: str, seed: int) -> float:
        rows = self.rows(TRAIN + self.VARY + sample(count, method, seed))
        return abs(math.fsum(float(row["ratio"]) for row in rows) / count - self.MEAN)

    def test_of_sobol_are_within_the_bound_of_koksma_and_hlawka(self) -> None:
        """Two dimensions of 2^m points are a (0, m, 2)-net: their star discrepancy is at most
        floor(m/2 + 3/2)/2^m (Niederreiter 1992, theorem 4.7). The variation of 2 Np/Ns, monotone in
        both, is what the rectangle and its two far edges give."""
        variation = 2 * 8 * (1 / 20 - 1 / 40) + 2 * 24 * (1 / 20 - 1 / 40) + 2 * 8 / 40
        for m in (6, 9, 12):
            for seed in (1, 2, 3):
                bound = variation * math.floor(m / 2 + 1.5) / 2**m
                self.assertLess(self.error(2**m, "sobol", seed), bound)

    def test_of_random_draws_are_within_their_spread(self) -> None:
        """Five times the deviation of a mean; the square of Np/Ns has the mean of Np^2 times that of
        1/Ns^2."""
        square = (20**2 + 8**2 / 12) / (20 * 40)
        deviation = 2 * math.sqrt(square - (20 * math.log(2) / 20)**2)
        for seed in (1, 2, 3):
            self.assertLess(self.error(4096, "random", seed), 5 * deviation / math.sqrt(4096))


class Pictures(InFolder):
    def test_show_points(self) -> None:
        file = self.write(TRAIN + Means.VARY + sample(50, "sobol"))
        done = kinestat("plot", "sweep-curves", "--emit", "gnuplot", file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("with points", done.stdout)
        self.assertNotIn("with lines", done.stdout)


if __name__ == "__main__":
    main(__doc__)
