"""The answers of analyze, of a motion's first row and of a sweep's row, by the same names.

Kinds: rate, speed of bodies, action, power, quotient. A name without an answer of a pass is absent;
a value that does not exist according to the pass is None.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

CASE = "case"

# Findings on a solved state: each must come from every pass that sees the state.
JUDGEMENTS = {"E0501", "E0502", "E0503", "E0601", "E0602", "E0603", "E0604", "E0606", "E0701",
              "W0601", "W0602", "W0603", "W0604", "W0605", "W0606", "W0607", "W0610",
              "W0701", "W0702"}


@dataclass
class Answers:
    status: str
    has_motion: bool = True  # false: the motions have no answer
    values: dict[str, dict[str, float | None]] = field(default_factory=dict)  # by kind and name

    def put(self, kind: str, name: str, value: float | None) -> None:
        self.values.setdefault(kind, {})[name] = value


def _advantage(actions: dict, names: tuple[str, str] | None) -> float | None:
    """Action of the output by that of the input, without its sign."""
    if names is None or any(actions.get(name) is None for name in names):
        return None
    input_, output = (actions[name] for name in names)
    return abs(output / input_) if input_ else None


def of_analysis(report: dict, names: tuple[str, str] | None = None) -> Answers:
    """`names` are input and output."""
    case = report["cases"][CASE]
    motion, action = case.get("kinematics", {}), case.get("statics", {})
    statuses = [s for s in (motion.get("status"), action.get("status")) if s]
    answers = Answers(next((s for s in statuses if s != "solved"), "solved"),
                      motion.get("status", "solved") == "solved")
    for name, value in motion.get("freedoms", {}).items():
        answers.put("rate", name, value)
    for name, body in motion.get("bodies", {}).items():
        for part in ("angular", "linear"):
            for letter, value in zip("xyz", body.get(part, ())):
                answers.put(part, f"{name}/{letter}", value)
    for name, value in action.get("actions", {}).items():
        answers.put("action", name, value)
    power = case.get("power", {})
    for name, value in {**power.get("actuators", {}), **power.get("loads", {})}.items():
        answers.put("power", name, value)
    answers.put("quotient", "ratio", case.get("ratio"))
    answers.put("quotient", "torque_ratio", case.get("torque_ratio"))
    answers.put("quotient", "mechanical_advantage", _advantage(action.get("actions", {}), names))
    return answers


MOTION_KINDS = {"velocity": "rate", "action": "action", "power": "power"}


def of_first_row(report: dict) -> Answers:
    motion = report["motion"]
    row = motion["rows"][0]
    answers = Answers(row[-1])
    for column, value in zip(motion["columns"], row):
        element, quantity = column["element"], column["quantity"]
        if quantity in MOTION_KINDS:
            answers.put(MOTION_KINDS[quantity], element, value)
        elif quantity in ("ratio", "mechanical_advantage"):
            answers.put("quotient", quantity, value)
        elif quantity.split("/")[0] in ("angular", "linear"):
            part, letter = quantity.split("/")
            answers.put(part, f"{element}/{letter}", value)
    return answers


def of_sweep_row(row: dict, actions: set[str]) -> Answers:
    answers = Answers(row["status"])
    for title, value in row.items():
        name = re.sub(r" \[.*\]$", "", title)
        if name in ("k", "case", "status"):
            continue
        kind = ("quotient" if name in ("ratio", "torque_ratio") else
                "action" if name in actions else "rate")
        answers.put(kind, name, value)
    return answers


def compare(what: str, actual: Answers, expected: Answers, share: float) -> list[str]:
    """Of the names that both know. Values agree to this share of themselves; what a sum of larger
    ones cancels to agrees to the roundings of the largest of its kind."""
    said = []
    for kind, values in actual.values.items():
        truth = expected.values.get(kind, {})
        largest = max((abs(v) for v in truth.values() if v is not None), default=0.0)
        rounding = 0.0 if kind == "quotient" else 1e-14 * largest
        for name in values.keys() & truth.keys():
            value, true = values[name], truth[name]
            if value is None or true is None:
                if (value is None) != (true is None):
                    said.append(f"{what}: {kind} {name} is {value}, analyze has {true}")
            elif abs(value - true) > share * abs(true) + rounding:
                said.append(f"{what}: {kind} {name} is {value}, analyze has {true}")
    return said
