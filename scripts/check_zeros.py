#!/usr/bin/env python3
"""Checks that nothing in lib/ sets values to zero relative to the largest of their kind.

A value becomes zero where it is computed: exactly, or because its own error bound does not
distinguish it from zero (lib/README.md, Zeros). Outside lib/math no value may be compared with a
fraction of another for that purpose: a small constant or literal, times or beside the largest, the
norm, the scale or the size of something, however that is spelled. Rounding of a value's own terms
is a bound and may be a share of their size. Decisions of other kinds (on ranks, consistency,
drawing, search) are listed below by their function, with their reasons.

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

# Constants of at least this are shares of another kind, such as how far an arrow reaches.
NO_SMALL_SHARE = 1e-3

ROUNDING = r"k(?:Epsilon|UnitRoundoff|Cancellation|\w*Rounding\w*)\b"
CONSTANT = r"\bk[A-Z]\w*"
LITERAL = r"(?<![\w.])(?:\d+\.?\d*|\.\d+)e-(?:[6-9]|[1-9]\d+)\b"
SMALL = rf"(?:{CONSTANT}|{LITERAL}|\b(?:\w+(?:\.|->))?\w*(?:zero|tolerance)_?\b)"
LEAST = rf"(?:(?!{ROUNDING}){CONSTANT}|{LITERAL})"

OWNER = r"(?:[\w:]+(?:\([^()]*\))?(?:\.|->))*"
CALL = r"(?:\([^()]*\)|\[\w*\])*"
LARGEST = (
    rf"(?:{OWNER}\w*(?:largest|greatest|fastest|steepest|biggest)\w*"
    rf"|\*?\s*(?:std::)?(?:ranges::)?max_element\b|(?:std::)?ranges::max\b|{OWNER}maxCoeff\b)"
)
# A `size()` counts elements; one of something has arguments.
SIZE = rf"(?:{OWNER}\w*(?:scale|size|magnitude)_?\b(?!\s*\(\s*\))|{OWNER}(?:norm|lpNorm)\b)"


def product(small: str, large: str) -> str:
    return rf"{small}\s*\*\s*\(?\s*{large}|{large}{CALL}\s*\*\s*\(?\s*{small}"


NEARBY = r"[^;{}?&|,]*?"
ARGUMENTS = r"\(\s*[^;{}()]*,\s*"
RELATIVE_ZERO = re.compile(
    "|".join(
        [
            r"\b(?:kReports?\w*Zero|kReportsAgreeBesideLargest|find_zero_snap)\b|\bsnap\s*\(",
            r"\bisMuchSmallerThan\s*\(",
            product(SMALL, LARGEST),
            product(LEAST, SIZE),
            rf"/\s*\(?\s*(?:{LARGEST}|{SIZE}){NEARBY}[<>]=?\s*{SMALL}",
            rf"{SMALL}\s*[<>]=?{NEARBY}/\s*\(?\s*(?:{LARGEST}|{SIZE})",
            rf"{ARGUMENTS}{SMALL}\s*,\s*{LARGEST}",
            rf"{ARGUMENTS}{LARGEST}{CALL}\s*,\s*{SMALL}",
        ]
    )
)

# Where that is another decision than whether a value is zero: file, functions, and why.
DECISIONS: dict[str, dict[str, str]] = {
    "lib/cases/findings/load_findings.cpp": {
        "add_point_masses": "consistency: the axis about which a body turns is that of its inertia",
    },
    "lib/cases/free_parameters.cpp": {
        "may_be_rounding": "search: changes so small that their bounds are asked for",
    },
    "lib/couplings/cable_geometry.cpp": {
        "find_fault": "consistency: circles with one centre have no common tangent",
    },
    "lib/draw/linkage/drawn_case.cpp": {"take": "drawing: an arrow shorter than a hair is none"},
    "lib/draw/train/scheme_radii.cpp": {"find": "drawing: radii that are one line"},
    "lib/mechanism/bind/extent.cpp": {"slope_at": "consistency: all corners at an end move alike"},
    "lib/mechanism/bind/rounding_slopes.cpp": {
        "drop_rounding": "rank: parameters that move a screw by rounding",
    },
    "lib/mechanism/couplings/internal/friction_binder.cpp": {
        "bears": "rank: which actions of a coupling press in a direction",
    },
    "lib/mechanism/couplings/reciprocity.cpp": {
        "moves_power": "consistency: typed screws and wrenches do no work on each other",
    },
    "lib/mechanism/drive_schedule.cpp": {
        "runs_straight": "consistency: the drives of a typed course move in proportion",
    },
    "lib/mechanism/gears/gear_layout.cpp": {
        "turn_between": "consistency: three centres are in line",
    },
    "lib/mechanism/gears/internal/gear_train_check.cpp": {
        "check_bearing": "consistency: typed points are on typed axes",
    },
    "lib/mechanism/gears/tooth_flanks.cpp": {"makes": "rank: whether rates make a motion at all"},
    "lib/mechanism/motion_plan.cpp": {"end_steady_course": "consistency: two typed ends are one"},
    "lib/network/primary_check.cpp": {"clear_part": "rank: which magnitudes a relation holds"},
    "lib/power/efficiency.cpp": {
        "exchange_beside has_power":
        "consistency: the powers of a case balance within kPowerBalance",
    },
    "lib/power/power_flow.cpp": {
        "find_power": "consistency: the powers of a case balance within kPowerBalance",
    },
    "lib/power/power_record.cpp": {"absorbing_inputs": "consistency: as of power/efficiency"},
    "lib/power/transmission_efficiency.cpp": {
        "passes_on": "search: which assumed senses are accepted",
    },
    "lib/screw/coordinate_basis.cpp": {"holds": "rank: whether a screw is in the span of others"},
    "lib/screw/point_motion.cpp": {
        "moves_point": "rank: what an idle or passive freedom moves",
        "turns": "rank: likewise",
    },
    "lib/screw/screw_axis.cpp": {
        "axis_of": "rank: a screw without a direction is a translation or a couple",
    },
    "lib/statics/action.cpp": {
        "is_violated":
        "consistency: which relation known actions violate, of an equilibrium without solution",
    },
    "lib/statics/completed_actions.cpp": {"scaled_columns": "rank: what a self-stress loads"},
    "lib/statics/internal/friction_function.cpp": {
        "find_other_friction": "search: whether another friction that was found is the same",
    },
    "lib/statics/internal/friction_hold.cpp": {
        "find_held_by_friction": "consistency: whether what was found is in equilibrium",
    },
    "lib/statics/internal/friction_system.cpp": {
        "find_open": "rank: which actions a friction reaches",
    },
    "lib/statics/lossy_system.cpp": {
        "take_other": "search: whether another equilibrium is the one that is known",
        "turned": "search: which gear of a mesh drives",
    },
    "lib/statics/one_sided_action.cpp": {
        "is_one_sided": "search: whether another equilibrium, told of, pushes and pulls",
    },
    "lib/studies/compare/compare_tolerance.cpp": {
        "allowed_difference": "comparison of two reports, not a zero of a value",
    },
    "lib/studies/duty/duty_case.cpp": {
        "add_loads": "consistency: as of power/efficiency",
        "presses_alike": "search: whether teeth press as where they were analysed",
    },
    "lib/studies/duty/slip_finder.cpp": {
        "drag_of": "search: rates so slow that the position is analysed whole",
        "is_doubtful": "search: signs so unsure that the position is analysed whole",
    },
    "lib/studies/inputs/cable_tension.cpp": {
        "find_drives": "consistency: pretensions of 1 that are in equilibrium already",
    },
    "lib/studies/inputs/internal/cobasis_search.cpp": {
        "CobasisSearch": "rank: which columns are independent",
    },
    "lib/studies/mobility/motion_space.cpp": {
        "may_be_rounding": "search: products so small that their bounds are asked for",
    },
    "lib/studies/mobility/passive_freedom.cpp": {
        "is_across": "rank: directions of a passive freedom",
        "snap rates_of passive_freedoms_beside": "rank: what a passive freedom moves",
    },
    "lib/studies/mobility/redundancy.cpp": {
        "snap circuit_constraint": "rank: what a self-stress of a circuit loads",
    },
    "lib/studies/mobility/repair.cpp": {"add": "rank: freedoms that release independently"},
    "lib/studies/mobility/reshetov.cpp": {"service_of": "rank: whether a freedom turns or slides"},
    "lib/studies/motion/internal/path_arrival.cpp": {"arrive": "search: where a path has arrived"},
    "lib/studies/motion/internal/path_tracker.cpp": {
        "rounding_of": "search: steps of a branch are near each other",
    },
    "lib/studies/motion/internal/rolling.cpp": {
        "rolling_ratio": "rank: whether rates make a motion at all",
    },
    "lib/studies/motion/joint_follower.cpp": {
        "close": "search: when Newton's method has come to rounding",
        "independent_rates": "rank: which joints tell motions apart",
    },
    "lib/studies/motion/lanes/lane_dead_point_search.cpp": {
        "find_turns is_doubtful": "search: rates so slow that the whole motion decides",
    },
    "lib/studies/motion/picture/motion_curves.cpp": {
        "follows_drive": "drawing: which curves would be that of the drive",
    },
    "lib/studies/motion/task/cycle/cycle_checks.cpp": {
        "why_not_closed": "consistency: a cycle ends as it begins",
    },
    "lib/studies/motion/task/cycle/find_actuators.cpp": {
        "peak_of integral_of add_energies figures_of energy":
        "bound: what polynomials leave of the function itself",
    },
    "lib/studies/motion/task/cycle/find_balance.cpp": {
        "solve": "bound: what polynomials leave of the function itself",
    },
    "lib/studies/motion/task/cycle/find_flywheel.cpp": {
        "solve": "bound: what polynomials leave of the function itself",
        "hangs_on_position_alone": "consistency: whether actions depend on position alone",
    },
    "lib/studies/motion/task/cycle/find_harmonics.cpp": {
        "take_apart": "bound: what polynomials leave of the function itself",
    },
    "lib/studies/motion/task/cycle/find_limit_speed.cpp": {
        "holds_at_twice": "consistency: whether actions go with the square of speed",
        "solve": "bound: what polynomials leave of the function itself",
    },
    "lib/studies/motion/task/figures/friction_rests.cpp": {
        "find": "search: whether friction stands where a drive turns back or stops",
    },
    "lib/studies/motion/task/figures/motion_figures.cpp": {
        "samples_with_jumps": "search: whether a column jumps at a place",
    },
    "lib/studies/motion/task/figures/reversal_events.cpp": {
        "level_sides": "search: whether a column jumps at a reversal",
    },
    "lib/studies/motion/task/figures/sharp_bends.cpp": {
        "BendFinder": "search: rates so slow that how they bend may be rounding",
    },
    "lib/studies/motion/task/figures/unbounded_quotients.cpp": {
        "is_unbounded": "search: whether a divisor jumps there",
    },
    "lib/studies/motion/task/figures/value_ends.cpp": {
        "zero_beyond": "search: where a value runs on to zero at a jam, before which rounding ends it",
    },
    "lib/studies/motion/task/friction_places.cpp": {
        "keep_between": "search: speeds that only touch zero are no turn",
    },
    "lib/studies/motion/task/motion_events.cpp": {
        "may_rest": "search: rates so slow that their bounds are asked for",
    },
    "lib/studies/sensitivity/internal/change.cpp": {
        "moves": "rank: on which parameters a value depends",
    },
    "lib/studies/sensitivity/internal/compatibility.cpp": {
        "shares": "rank: which self-stresses a slope loads",
    },
    "lib/studies/sensitivity/internal/power_value.cpp": {
        "is_between_inputs_and_outputs": "consistency: as of power/efficiency",
    },
    "lib/studies/sensitivity/reported_value.cpp": {
        "drop_rounding": "rank: on which actions a value depends",
    },
    "lib/studies/simulation/internal/extreme_watch.cpp": {
        "climb": "search: what exceeds an extreme by less is none",
        "extremes": "search: where values touch zero between two looks",
    },
    "lib/studies/simulation/internal/simulator_events.cpp": {
        "distance": "search: where sliding begins anew",
        "note_signs": "search: which events are just passed",
        "settle strike": "search: a rebound by rounding alone is none",
    },
    "lib/studies/simulation/internal/simulator_friction.cpp": {
        "no_sliding": "search: where sliding comes to its end",
    },
    "lib/studies/simulation/internal/simulator_parting.cpp": {
        "margin": "consistency: forces of the wrong sign by rounding alone part nothing",
    },
    "lib/studies/simulation/task/simulation_findings.cpp": {
        "least_slip": "consistency: slip by what the integration is off is none",
    },
    "lib/studies/simulation/internal/state_in_time.cpp": {
        "settled": "bound: roundings of what the integration adds up",
    },
    "lib/studies/simulation/reduced_system.cpp": {
        "accelerate": "a sum and its own terms: what holds a freedom, beyond what closures leave",
    },
    "lib/studies/simulation/simulation_network.cpp": {
        "shifts": "rank: whether a motion moves a point",
    },
    "lib/studies/simulation/state_balance.cpp": {
        "drop_rounding": "rank: which components a moved unit action has",
        "tooth_forces": "consistency: forces that decide the flank, in lib/README.md",
    },
    "lib/studies/sweep/task/lane_rows.hpp": {
        "are_clear": "search: states whose values may be rounding are bounded",
    },
    "lib/studies/sweep/task/state_solver.cpp": {
        "check_answer": "comparison of two ways to the same state",
        "may_be_rounding": "search: states whose values may be rounding are bounded",
    },
    "lib/studies/sweep/task/tape_solver.cpp": {
        "drives_output": "search: states whose output may rest are analysed whole",
        "fill_efficiency": "consistency: as of power/efficiency; else analysed whole",
        "fill_powers": "search: states whose input may rest are analysed whole",
    },
    "lib/studies/synthesis/dyads/given_dyad.cpp": {
        "allowance": "consistency: the given point of a dyad is on its curve",
    },
    "lib/studies/synthesis/positions/plane_area.cpp": {
        "distance": "consistency: a point on the edge of an area is in it",
    },
    "lib/studies/synthesis/task/synthesis_task.cpp": {"are_alike": "comparison of two dyads"},
}

DEFINITION = re.compile(r"\bconstexpr\s+(?:double|float|auto|int)\s+(k[A-Z]\w*)\s*[={]\s*([^;}]+)")
HEAD = re.compile(r"(?!(?:namespace|template|public|private|requires|#)\b)[A-Za-z_\[]")
INNER_HEAD = re.compile(r"  (?!(?:if|for|while|return|switch|else|case)\b)[A-Za-z_][^=;]*\(")


def shares_of_other_kinds(code: str) -> Iterator[str]:
    """The constants of a file that are no small shares, by their plain values."""
    for name, value in DEFINITION.findall(code):
        try:
            if abs(float(value.strip().replace("'", ""))) >= NO_SMALL_SHARE:
                yield name
        except ValueError:
            continue  # made of others: taken for small


def name_in(line: str) -> str:
    found = re.search(r"([\w~]+)\s*\(", line) or re.search(r"(\w+)\s*[={]", line)
    return found[1] if found else line.strip()


def function_at(code: str, position: int) -> str:
    """The name of the function around a place, by the layout of clang-format: functions begin at
    the margin, those in a class two columns further."""
    inner = ""
    end = code.find("\n", position)
    for line in reversed(code[:end].split("\n")):
        if HEAD.match(line):
            is_class = re.match(r"(?:class|struct)\b[^(]*$", line) is not None
            return (inner or name_in(line)) if is_class else name_in(line)
        if not inner and INNER_HEAD.match(line):
            inner = name_in(line)
    return inner


def find_violations(root: Path) -> Iterator[Violation]:
    unused = {
        (path, function)
        for path, rows in DECISIONS.items()
        for functions in rows
        for function in functions.split()
    }
    allowed = frozenset(unused)
    files = [(file, without_strings(file.text)) for file in read_files(root)]
    others = {name for _, code in files for name in shares_of_other_kinds(code)}
    for file, code in files:
        if file.module in ("app", "math") or file.path.startswith("lib/core/"):
            continue
        for match in RELATIVE_ZERO.finditer(code):
            constants = re.findall(CONSTANT, match[0])
            if constants and others.issuperset(constants):
                continue
            place = (file.path, function_at(code, match.start()))
            unused.discard(place)
            if place not in allowed:
                found = " ".join(match[0].split())
                yield Violation(
                    file.path,
                    line_of(code, match.start()),
                    f"zero is decided in {place[1]} relative to something else: {found}",
                )
    for path, function in sorted(unused):
        if (root / path).exists():
            yield Violation(
                path, 1, f"the row of check_zeros.py for {function} has nothing to allow any more"
            )


def main() -> int:
    parser = argparse.ArgumentParser(description="Check how lib/ decides on zero.")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[1])
    violations = list(find_violations(parser.parse_args().root))
    print("\n".join(map(str, violations)) or "no zeros but those of bounds, and those listed")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
