"""What the differential tests have in common: their arguments, chunks of seeds, and complaints.

Usage of each: NAME_test.py PROGRAM COUNT [unittest arguments]

COUNT seeds are tried; the environment variable KINESTAT_DIFFERENTIAL overrides it (100000 on
demand), KINESTAT_DIFFERENTIAL_FIRST is the first seed.
"""

from __future__ import annotations

import os
import sys
import unittest
from typing import Callable, Iterator

from batch import Batch
from known_defects import sort_out
from random_sketch import random_sketch
from sketch import Sketch

CHUNK = 250
WHOLE_RUN = 200  # seeds in which every known defect shows
SHOWN = 40
# Seeds beyond the first ones that have once shown a defect, by whether they are planar.
REMEMBERED = {True: [939, 1119, 2369, 3980],
              False: [404, 407, 607, 1025, 1277, 6433, 10900, 15776, 32919, 34070, 35287, 40712,
                      69128, 73130, 74183, 87535, 89754, 93401]}
program = ""
count = 0
first = 0

Complaints = dict[str, list[str]]


def is_whole_run() -> bool:
    return first == 0 and count >= WHOLE_RUN


def chunks(is_planar: bool) -> Iterator[dict[str, Sketch]]:
    """The sketches of the seeds by name, some at a time."""
    space = "planar" if is_planar else "spatial"
    seeds = [*range(first, first + count)]
    seeds += [s for s in REMEMBERED[is_planar] if is_whole_run() and s >= count]
    for start in range(0, len(seeds), CHUNK):
        yield {f"{space}-{seed}": random_sketch(seed, is_planar)
               for seed in seeds[start:start + CHUNK]}


class DifferentialTest(unittest.TestCase):
    def check(self, is_planar: bool, compare: Callable[[Batch, dict[str, Sketch]], Complaints],
              text_of: Callable[[Sketch], str] = Sketch.text,
              fits: Callable[[Sketch], bool] = lambda _: True) -> None:
        """Nothing is to be said of any seed but what is known; at least a fifth must fit."""
        complaints: list[str] = []
        texts: dict[str, str] = {}
        tried = 0
        for drawn in chunks(is_planar):
            sketches = {name: one for name, one in drawn.items() if fits(one)}
            tried += len(sketches)
            batch = Batch(program, {name: text_of(one) for name, one in sketches.items()})
            try:
                found = compare(batch, sketches)
            finally:
                batch.close()
            complaints += [f"{name}: {text}" for name, said in found.items() for text in said]
            texts.update((name, text_of(sketches[name])) for name, said in found.items() if said)
        self.assertGreaterEqual(tried, count // 5)
        self.report(complaints, texts)

    def report(self, complaints: list[str], texts: dict[str, str]) -> None:
        said = sort_out(self.id().rsplit(".", 1)[1], complaints, is_whole_run())
        if said:
            names = dict.fromkeys(line.split(":")[0] for line in said)
            shown = [f"--- {name}\n{texts[name]}" for name in list(names)[:5] if name in texts]
            self.fail("\n".join([f"{len(said)} complaints", *said[:SHOWN], *shown]))


def main() -> None:
    global program, count, first
    program = sys.argv[1]
    count = int(os.environ.get("KINESTAT_DIFFERENTIAL", sys.argv[2]))
    first = int(os.environ.get("KINESTAT_DIFFERENTIAL_FIRST", "0"))
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
