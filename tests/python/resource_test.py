"""Memory that stays as it is, and threads."""

from __future__ import annotations

import gc
import json
import re
import resource
import sys
import threading
from typing import Any
import unittest

import kinestat

from python_case import Case, FOUR_BAR, four_bar_ratio


class Resources(Case):
    def peak(self) -> int:
        """Most memory so far, in bytes."""
        unit = 1 if sys.platform == "darwin" else 1024
        return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    def assert_flat(self, work: Any, times: int) -> None:
        for _ in range(times // 10):
            work()
        gc.collect()
        before = self.peak()
        for _ in range(times):
            work()
        self.assertLess(self.peak() - before, 8 << 20)

    def test_playing_keeps_no_memory(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", ["ratio", "d.wz"])
        self.assert_flat(lambda: tape(height=4.5), 10_000)

    def test_setting_and_refusing_keep_no_memory(self) -> None:
        bar = kinestat.load(FOUR_BAR)

        def work() -> None:
            bar.set("height", "5 m")
            try:
                bar.set("heigth", "5 m")
            except kinestat.UsageError:
                pass

        self.assert_flat(work, 10_000)

    def test_objects_are_freed(self) -> None:
        def work() -> None:
            bar = kinestat.load(FOUR_BAR)
            bar.record("height", "ratio")(height=4)
            json.loads(bar.analyze().json)

        self.assert_flat(work, 500)

    def test_threads_with_their_own_tapes_agree(self) -> None:
        heights = [3 + k / 1000 for k in range(4000)]
        right = [list(row) for row in kinestat.load(FOUR_BAR).record("height").play(heights)]
        self.in_threads(lambda: self.assertEqual(
            [list(row) for row in kinestat.load(FOUR_BAR).record("height").play(heights)], right))

    def test_threads_wait_for_a_tape(self) -> None:
        tape = kinestat.load(FOUR_BAR).record("height", "ratio")

        def work() -> None:
            for k in range(2000):
                height = 3 + k / 1000
                self.assertAlmostEqual(tape(height=height)["ratio"], four_bar_ratio(height))

        self.in_threads(work)

    def test_messages_are_those_of_the_thread(self) -> None:
        bar = kinestat.load(FOUR_BAR)

        def work() -> None:
            name = threading.current_thread().name
            for _ in range(300):
                with self.assertRaisesRegex(kinestat.UsageError, re.escape(name)):
                    bar.set(name, "1 m")

        self.in_threads(work)

    def in_threads(self, work: Any) -> None:
        problems: list[BaseException] = []

        def guarded() -> None:
            try:
                work()
            except BaseException as problem:
                problems.append(problem)

        threads = [threading.Thread(target=guarded) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(problems, [])


if __name__ == "__main__":
    unittest.main()
