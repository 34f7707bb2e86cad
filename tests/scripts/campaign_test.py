"""campaign.py: what a run of a fuzz target comes to, with programs that stand for targets."""

from __future__ import annotations

import contextlib
import io
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/fuzz"))
import campaign  # noqa: E402

GOOD = "number_of_executed_units: 700"


class Campaign(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        campaign.FOUND = self.folder / "found"
        campaign.LOG = self.folder / "log.jsonl"

    def program(self, script: str) -> Path:
        path = self.folder / "target"
        path.write_text(f"#!/bin/bash\n{script}\n", encoding="utf-8")
        path.chmod(0o755)
        return path

    def record(self, target: str) -> campaign.Record:
        return campaign.Record("2026-01-02", target, "somehow", 5)

    def test_counts_executions_and_keeps_what_ended_them(self) -> None:
        # Its first seed ends it; then it runs for as long as it may.
        script = (f'echo "{GOOD}" >&2; for word; do case $word in -seed=5) first=yes;; '
                  '-max_total_time=*) left=${word#*=};; -exact_artifact_path=*) at=${word#*=};; esac; done; '
                  'if [[ ${first:-} ]]; then printf bytes >"$at"; exit 77; fi; sleep "$left"')
        record = self.record("units")
        with contextlib.redirect_stdout(io.StringIO()) as said:
            campaign.by_libfuzzer(record, self.program(script), 3 / 60)
        self.assertEqual((record.executions, record.found), (1400, 1))
        self.assertEqual((campaign.FOUND / "units-5-1").read_bytes(), b"bytes")
        self.assertIn("units-5-1", said.getvalue())

    def test_gives_up_where_nothing_else_is_found(self) -> None:
        record = self.record("mechanism")
        with contextlib.redirect_stdout(io.StringIO()):
            campaign.by_random_bytes(record, self.program('printf x >"$4"; echo 1; exit 1'), 10)
        self.assertEqual((record.executions, record.found), (campaign.MOST, campaign.MOST))

    def test_sums_runs_of_one_target(self) -> None:
        with campaign.LOG.open("w", encoding="utf-8") as log:
            for seed, executions, found in ((1, 3000, 0), (2, 1000, 1)):
                one = self.record("units")
                one.seed, one.executions, one.found, one.minutes = seed, executions, found, 1.5
                log.write(campaign.json.dumps(campaign.asdict(one)) + "\n")
        text = campaign.table()
        self.assertIn("| 2026-01-02 | `units` | somehow | 1, 2 | 3 | 4.00e+03 | 1 |", text)
        self.assertIn("| | all | | | 3 | 4.00e+03 | 1 |", text)


if __name__ == "__main__":
    unittest.main()
