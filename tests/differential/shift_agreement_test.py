#!/usr/bin/env python3
"""Checks shift tables of random trains against analyses of the same states written by hand."""

from __future__ import annotations

import differential_case
from batch import Batch, Result
from differential_case import CHUNK, DifferentialTest
from random_train import RandomTrain, random_train

SHARE = 1e-9


def near(value: float | None, true: float | None, largest: float) -> bool:
    """To nine digits, and where it should be zero to the roundings of the largest of its kind."""
    if value is None or true is None:
        return value is None and true is None
    return abs(value - true) <= SHARE * abs(true) + 1e-13 * largest


def compare_gear(state: dict, case: dict, gear: dict, train: RandomTrain) -> list[str]:
    """`case` is written by hand; `gear` the one that the program made of the table."""
    if case["kinematics"]["status"] != "solved":
        if state["freedom"] <= 1:
            return [f"gear, but its motions are {case['kinematics']['status']}"]
        # What turns freely beside the gear is open by hand, and as a case has no value.
        return [f"{name} is {state[name]}, as a case {gear.get(name)}"
                for name in ("ratio", "torque_ratio") if not near(state[name], gear.get(name), 0.0)]
    said = []
    for name in ("ratio", "torque_ratio"):
        for what, one in (("by hand", case), ("as a case", gear)):
            if not near(state[name], one.get(name), 0.0):
                said.append(f"{name} is {state[name]}, {what} {one.get(name)}")
    actions, rates = case["statics"]["actions"], case["kinematics"]["freedoms"]
    torque = max((abs(v) for k, v in actions.items() if v is not None and "." not in k), default=0)
    speed = max(abs(v) for v in rates.values())
    for element in train.elements:
        values = state["elements"][element]
        for key, true, largest in (("torque", actions[element], torque),
                                   ("slip", rates[f"{element}.wz"], speed)):
            if not near(values[key], true, largest):
                said.append(f"{key} of {element} is {values[key]}, by hand {true}")
    return said


def compare_no_gear(state: dict, case: dict) -> list[str]:
    """By hand the input cannot turn like that, or the output rests or is left open."""
    motion = case["kinematics"]
    if motion["status"] != "solved":
        return []
    # A case does not say what its inputs drag along: a tie-up may move all the same.
    if state["class"] == "tie-up" or not motion["freedoms"].get("out"):
        return []
    return [f"is {state['class']}, but by hand its ratio is {case.get('ratio')}"]


def compare_state(label: str, state: dict, case: dict, gears: dict,
                  train: RandomTrain) -> list[str]:
    found = (compare_gear(state, case, gears[label], train) if state["class"] == "gear"
             else compare_no_gear(state, case))
    return [f"{label} {text}" for text in found]


def results(texts: dict[str, str], *commands: str) -> list[dict[str, Result]]:
    batch = Batch(differential_case.program, texts)
    try:
        return [batch.run(command) for command in commands]
    finally:
        batch.close()


def states_of(result: Result) -> dict[str, dict]:
    return result.report.get("shift", {}).get("states", {})


def hand_text(train: RandomTrain, states: dict[str, dict]) -> str:
    cases = (train.case(f"state {label}", state["engaged"]) for label, state in states.items())
    return train.text(cases="\n".join(["cases:", *cases]))


class ShiftAgreementTest(DifferentialTest):
    def setUp(self) -> None:
        self.gears = 0
        self.complaints: list[str] = []
        self.texts: dict[str, str] = {}

    def compare(self, trains: dict[str, RandomTrain]) -> None:
        texts = {name: train.text(shift=train.shift()) for name, train in trains.items()}
        shifts, analyses = results(texts, "shift", "analyze")
        states = {name: states_of(one) for name, one in shifts.items() if states_of(one)}
        by_hand, = results({name: hand_text(trains[name], one) for name, one in states.items()},
                           "analyze")
        for name, train in trains.items():
            said = []
            if analyses[name].report.get("shift") != shifts[name].report.get("shift"):
                said.append("shift and analyze have different tables")
            for label, state in states.get(name, {}).items():
                self.gears += state["class"] == "gear"
                said += compare_state(label, state,
                                      by_hand[name].report["cases"][f"state {label}"],
                                      analyses[name].report["cases"], train)
            self.complaints += [f"{name}: {text}" for text in said]
            self.texts.update({name: texts[name]} if said else {})

    def test_gears_have_the_values_of_cases_by_hand(self) -> None:
        last = differential_case.first + differential_case.count
        for start in range(differential_case.first, last, CHUNK):
            self.compare({f"train-{seed}": random_train(seed)
                          for seed in range(start, min(start + CHUNK, last))})
        self.assertGreaterEqual(self.gears, differential_case.count)
        self.report(self.complaints, self.texts)


if __name__ == "__main__":
    differential_case.main()
