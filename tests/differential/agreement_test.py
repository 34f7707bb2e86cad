#!/usr/bin/env python3
"""Checks every pass that sees a drawn position against what analyze says of it.

The first row of a motion and each row of a sweep must have the values, the status and the findings
that analyze has of the same position.
"""

from __future__ import annotations

from fractions import Fraction

import differential_case
import passes
from batch import Batch
from differential_case import Complaints, DifferentialTest
from exact_network import ExactNetwork
from passes import JUDGEMENTS, Answers
from sketch import Sketch, number, vector

SHARE = 1e-9
STATES = (Fraction(1), Fraction(3, 2))  # of the parameter k in a sweep
# The words of rows whose numbers no cable and no contact can bear, the first that is said.
IMPOSSIBLE = {"W0606": "cable_slack", "W0605": "contact_pulls", "W0607": "cable_slips"}
STATUSES = {"solved", "dependent", "inconsistent", "indeterminate", "overflow", "at_rest"}
REPORT = "[velocity, action, power, ratio, mechanical_advantage]"


def drives_of(sketch: Sketch) -> list[str]:
    """Actuators that move the mechanism alone; none if the case does not drive it so."""
    driven = [sketch.actuator_of(name) for name in sketch.motion]
    if not driven or None in driven:
        return []
    motion = ExactNetwork(sketch).motion(sketch.motion)
    if motion.status != "solved" and not motion.determined:
        return []  # where some are determined, the others may be what no other body feels
    return [name for name in driven if name is not None]


def motion_text(sketch: Sketch) -> str:
    """Two positions, the second next to the first."""
    drives = ", ".join(f"{{drive: {name}, to: 1e-6}}" for name in drives_of(sketch))
    quantities = REPORT if sketch.input else "[velocity, action, power]"
    return (sketch.text() + f"motion: {{drives: [{drives}], steps: 1, case: {passes.CASE}, "
            f"report: {quantities}}}\n")


def is_said_alike(command: str, said: set[str], true: set[str]) -> list[str]:
    return ([f"{command} does not say {code}" for code in sorted(true - said)]
            + [f"{command} says {code}, analyze does not" for code in sorted(said - true)])


def word_of(true: Answers, codes: list[str]) -> str:
    """The status of a row, of which analysis says this: motions without an answer come first."""
    words = [word for code, word in IMPOSSIBLE.items() if code in codes]
    may_be_impossible = true.has_motion and true.status in ("solved", "indeterminate")
    return words[0] if words and may_be_impossible else true.status


def analysed(report: dict, sketch: Sketch) -> Answers:
    names = (sketch.input, sketch.output) if sketch.input and sketch.output else None
    return passes.of_analysis(report, names)


def compare_motion(batch: Batch, sketches: dict[str, Sketch]) -> Complaints:
    analyses, motions = batch.run("analyze"), batch.run("motion")
    found: Complaints = {}
    for name, sketch in sketches.items():
        analysis, motion = analyses[name], motions[name]
        if "E0507" in motion.codes():
            continue  # a coupling that cannot be moved
        true = analysed(analysis.report, sketch)
        if not motion.report.get("motion", {}).get("rows"):
            is_refused = any(code.startswith("E") for code in motion.codes())
            if true.has_motion or not is_refused:
                found[name] = [f"no motion: {motion.codes()}"]
            continue  # drives that determine no motion move nothing
        row = passes.of_first_row(motion.report)
        found[name] = passes.compare("motion", row, true, SHARE)
        word = word_of(true, analysis.codes())
        if row.status != word:
            found[name].append(f"motion: row is {row.status}, analyze says {word}")
        found[name] += is_said_alike("motion", set(motion.codes()) & JUDGEMENTS,
                                     set(analysis.codes()) & JUDGEMENTS)
    return found


def varied_text(sketch: Sketch, state: Fraction) -> str:
    """The first coupling stands where k = `state` puts it; k = 1 is where it was drawn."""
    text, coupling = sketch.text(), sketch.couplings[0]
    line = coupling.text()
    moved = line
    for key, point in (("at", coupling.at), ("from", coupling.at), ("to", coupling.to)):
        if point is not None:
            drawn = f"{key}: {vector(point, sketch.is_planar)}"
            shown = ", ".join(f"{number(x)}*k" for x in point[:2 if sketch.is_planar else 3])
            moved = moved.replace(drawn, f"{key}: [{shown}]")
    return text.replace(line, moved).replace(
        "couplings:", f"parameters: {{k: {number(state)}}}\ncouplings:", 1)


def sweep_text(sketch: Sketch) -> str:
    values = ", ".join(number(state) for state in STATES)
    return varied_text(sketch, STATES[0]) + f"sweep: {{vary: {{k: {{values: [{values}]}}}}}}\n"


def is_same_status(swept: str, true: Answers, drawn: Answers) -> bool:
    """A sweep calls singular what is solved where it was drawn, and locked what nothing moves."""
    if swept == "singular":
        return drawn.status == "solved" and true.status in ("dependent", "indeterminate",
                                                            "inconsistent")
    if swept in ("locked", "no_ratio"):
        return true.values["quotient"]["ratio"] is None
    return swept == true.status or true.status == "solved" and swept not in {
        *STATUSES, *IMPOSSIBLE.values()}


def compare_sweep(batch: Batch, sketches: dict[str, Sketch]) -> Complaints:
    found: Complaints = {name: [] for name in sketches}
    states = {f"{name}.{i}": varied_text(sketch, state)
              for name, sketch in sketches.items() for i, state in enumerate(STATES)}
    analysis = Batch(batch.program, states)
    reports = analysis.run("analyze")
    analysis.close()
    for name, sketch in sketches.items():
        status, rows, said = batch.rows(name)
        if status not in (0, 5) or len(rows) != len(STATES):
            found[name].append(f"no sweep: {status} {said}")
            continue
        drawn = analysed(reports[f"{name}.0"].report, sketch)
        for i, row in enumerate(rows):
            true = analysed(reports[f"{name}.{i}"].report, sketch)
            swept = passes.of_sweep_row(row, set(true.values.get("action", {})))
            found[name] += passes.compare(f"sweep of k = {number(STATES[i])}", swept, true, SHARE)
            word = word_of(true, reports[f"{name}.{i}"].codes())
            if swept.status != word and (word in IMPOSSIBLE.values()
                                         or not is_same_status(swept.status, true, drawn)):
                found[name].append(f"sweep: row {i} is {swept.status}, analyze says {word}")
    return found


class AgreementTest(DifferentialTest):
    def test_planar_motions_begin_as_analysed(self) -> None:
        self.check(True, compare_motion, motion_text, lambda sketch: bool(drives_of(sketch)))

    def test_spatial_motions_begin_as_analysed(self) -> None:
        self.check(False, compare_motion, motion_text, lambda sketch: bool(drives_of(sketch)))

    def test_planar_sweeps_have_the_values_of_analyses(self) -> None:
        self.check(True, compare_sweep, sweep_text)

    def test_spatial_sweeps_have_the_values_of_analyses(self) -> None:
        self.check(False, compare_sweep, sweep_text)


if __name__ == "__main__":
    differential_case.main()
