#!/usr/bin/env python3
"""Checks that nothing in lib/ sets values to zero relative to the largest of their kind.

A value becomes zero where it is computed: exactly, or because its own error bound does not
distinguish it from zero (lib/README.md, Zeros). Outside lib/math no value may be compared with a
fraction of another for that purpose. Decisions of other kinds (on ranks, consistency, drawing,
search) are listed below with their reasons.

Usage: check_zeros.py [--root FOLDER]   Prints `file:line: message` for each violation; exit status 1
if there is any, or if a row of the table below is no longer needed.
"""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path
from typing import Iterator

from check_layers import Violation, line_of, read_files, without_strings

RELATIVE_ZERO = re.compile(
    r"\b(?:kReports?\w*Zero|kReportsAgreeBesideLargest|find_zero_snap)\b|\bsnap\s*\("
    r"|(?:[<>]=?|(?<![=!<>])=|\breturn\b)\s*\(?-?\s*k[A-Z]\w*\s*\*[^;{}?]*?"
    r"(?:(?<!/ )\b\w*(?:largest|greatest|fastest|steepest)\w*|maxCoeff)"
)

# Where that is another decision than whether a value is zero: file, and why.
DECISIONS = {
    "lib/studies/motion/picture/motion_curves.cpp": "drawing: which curves would be that of the drive",
    "lib/studies/inputs/cable_tension.cpp": "consistency: pretensions of 1 that are in equilibrium already",
    "lib/mechanism/cables/internal/cable_contact_check.cpp": "drawing: contacts lie on the rim",
    "lib/mechanism/bind/extent.cpp": "consistency: all corners at an end move alike",
    "lib/mechanism/bind/rounding_slopes.cpp": "rank: parameters that move a screw by rounding",
    "lib/studies/mobility/passive_freedom.cpp": "rank: what a passive freedom moves",
    "lib/studies/mobility/redundancy.cpp": "rank: what a self-stress of a circuit loads",
    "lib/studies/motion/internal/path_tracker.cpp": "search: steps of a branch are near each other",
    "lib/screw/coordinate_basis.cpp": "rank: which screws surely span all coordinates",
    "lib/network/primary_check.cpp": "rank: which magnitudes a relation holds",
    "lib/cases/free_parameters.cpp": "search: changes so small that their bounds are asked for",
    "lib/cases/report/results_text.cpp": "words: couplings that bear the same largest action",
    "lib/draw/linkage/drawn_case.cpp": "drawing: an arrow shorter than a hair is none",
    "lib/power/efficiency.cpp": "consistency: the powers of a case balance within kPowerBalance",
    "lib/power/power_flow.cpp": "consistency: the powers of a case balance within kPowerBalance",
    "lib/power/power_record.cpp": "consistency: as of power/efficiency",
    "lib/power/transmission_efficiency.cpp": "search: which assumed senses are accepted",
    "lib/studies/duty/slip_finder.cpp": "search: rates so slow that the position is analysed whole",
    "lib/studies/duty/duty_case.cpp": "search: whether teeth press as where they were analysed",
    "lib/studies/compare/compare_tolerance.cpp": "comparison of two reports, not a zero of a value",
    "lib/studies/motion/joint_follower.cpp": "rank: which joints tell motions apart",
    "lib/studies/simulation/internal/simulator_events.cpp": "search: a rebound by rounding alone is none",
    "lib/studies/simulation/internal/simulator_parting.cpp": "consistency: forces of the wrong sign by rounding alone part nothing",
    "lib/studies/simulation/internal/extreme_watch.cpp": "search: what exceeds an extreme by less is none",
    "lib/studies/simulation/internal/simulator_friction.cpp": "search: where sliding comes to its end",
    "lib/studies/motion/lanes/lane_dead_point_search.cpp": "search: rates so slow that the whole motion decides",
    "lib/studies/motion/report/motion_text.cpp": "words: a range whose ends are the same number is constant",
    "lib/studies/motion/task/motion_events.cpp": "search: rates so slow that their bounds are asked for",
    "lib/studies/motion/task/figures/motion_figures.cpp": "search: whether a column jumps at a place",
    "lib/studies/motion/task/idle_rates.cpp": "rank: what a passive freedom moves",
    "lib/studies/sweep/task/state_solver.cpp": "comparison of two ways to the same state",
    "lib/studies/sweep/task/tape_solver.cpp": "search: states whose output may rest are analysed whole",
    "lib/studies/sweep/task/sizes.hpp": "search: states whose values may be rounding are bounded",
    "lib/studies/sensitivity/internal/compatibility.cpp": "rank: which self-stresses a slope loads",
    "lib/studies/sensitivity/internal/power_value.cpp": "consistency: as of power/efficiency",
    "lib/studies/sensitivity/reported_value.cpp": "rank: on which actions a value depends",
    "lib/statics/completed_actions.cpp": "rank: what a self-stress loads",
    "lib/statics/one_sided_action.cpp": "search: whether another equilibrium, told of, pushes and pulls",
    "lib/statics/internal/friction_system.cpp": "rank: which actions a friction reaches",
    "lib/statics/lossy_system.cpp": "search: which gear of a mesh drives",
}


def find_violations(root: Path) -> Iterator[Violation]:
    unused = dict(DECISIONS)
    for file in read_files(root):
        if file.module in ("app", "math") or file.path.startswith("lib/core/"):
            continue
        code = without_strings(file.text)
        for match in RELATIVE_ZERO.finditer(code):
            unused.pop(file.path, None)
            if file.path not in DECISIONS:
                found = " ".join(match[0].split())
                yield Violation(
                    file.path,
                    line_of(code, match.start()),
                    f"zero is decided relative to something else: {found}",
                )
    for path in unused:
        if (root / path).exists():
            yield Violation(path, 1, "the row of check_zeros.py has nothing to allow any more")


def main() -> int:
    parser = argparse.ArgumentParser(description="Check how lib/ decides on zero.")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[1])
    violations = list(find_violations(parser.parse_args().root))
    print("\n".join(map(str, violations)) or "no zeros but those of bounds, and those listed")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
