"""Runs two analyses at once, again and again; prints what is amiss, or that nothing is."""

import os
import shutil
import subprocess
from pathlib import Path

PASSES = ("kinematics", "mobility", "power", "statics")


def wanted(value):
    """The files of one run alone."""
    folder = Path(f"alone{value}")
    folder.mkdir()
    run(value, folder).wait()
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def run(value, folder):
    return subprocess.Popen(
        [os.environ["KINESTAT"], "analyze", "--quiet", "--set", f"crank_x={value}", "--out", folder,
         "file.yaml"], stderr=subprocess.PIPE,
    )


def race(reports):
    """One race; the complaints about it."""
    both = [run(value, reports) for value in (1, 2)]
    told = [process.communicate()[1] for process in both]
    statuses = sorted(process.returncode for process in both)
    if statuses not in ([0, 0], [0, 4]):
        yield f"{statuses}: {told}"
    found = {file.name: file.read_bytes() for file in reports.iterdir()}
    if found.keys() != alone[1].keys():
        yield f"files {sorted(found)}"
    for name, content in found.items():
        if content not in (alone[1][name], alone[2][name]):
            yield f"{name} is of neither"


alone = {1: wanted(1), 2: wanted(2)}
assert len(alone[1]) == 1 + len(PASSES) and alone[1] != alone[2]
complaints = []
for is_empty in (True, False):
    for _ in range(15):
        reports = Path("reports")
        if is_empty:
            shutil.rmtree(reports, ignore_errors=True)
        reports.mkdir(exist_ok=True)
        complaints += race(reports)
print(complaints or "all whole")
