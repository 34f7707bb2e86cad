"""The values of a JSON report that the rows of its CSV repeat."""

from __future__ import annotations

import json
import re
from typing import Any, Iterator

from report_case import at, item, numbers

# Where the CSV table of a pass finds its values: the quantity names the section.
SECTIONS = {
    "kinematics": {"velocity": "freedoms", None: "bodies"},
    "statics": {"action": "actions", "load": "loads", "friction": "friction",
                "planet": "planets", "contact": "contacts", "converter": "converters",
                None: "couplings"},
    "power": {"into_head": "couplings", "supplied": "supplied", "actuator": "actuators",
              "load": "loads", "friction": "friction", "body": "bodies", "mesh": "meshes"},
    "dynamics": {"body": "bodies", "reduced": "reduced"},
}

# Tables have the ratio of a case in the pass of its magnitudes.
RATIOS = {"kinematics": "ratio", "statics": "torque_ratio", "power": None, "dynamics": None}

LOSSES = {"loss": "meshes", "lossy_friction": "friction", "lossy_action": "actuators",
          "lossy_power": "powers"}


def facts(value: Any) -> Iterator[Any]:
    """The words, numbers, and yes or no of a JSON value."""
    if isinstance(value, (dict, list)):
        for item in value.values() if isinstance(value, dict) else value:
            yield from facts(item)
    elif value is not None:
        yield value


def mobility_value(value: Any, path: str) -> str:
    """As the CSV writes it: words that end a path are 1, yes and no are 1 and 0, null is empty."""
    tokens = list(filter(None, path.split("/")))
    for i, token in enumerate(tokens):
        if isinstance(value, str):
            return "1" if value == "/".join(tokens[i:]) else "another word"
        value = item(value, token) if isinstance(value, list) else value[token]
    if value is None:
        return ""
    return json.dumps(int(value) if isinstance(value, bool) else value)


def shift_value(shift: Any, row: dict[str, str]) -> Any:
    if row["quantity"].startswith("change/"):
        change = next(one for one in shift["changes"]
                      if f"{one['from']} - {one['to']}" == row["element"])
        return change[row["quantity"].removeprefix("change/")]
    if not row["case"]:
        return shift[row["quantity"]]
    state = shift["states"][row["case"]]
    if row["quantity"] == "engaged":
        return int(row["element"] in state["engaged"])
    if row["quantity"].startswith("worst_"):
        worst = state[row["quantity"].removesuffix("/force")]
        return worst and worst["force"]
    if row["quantity"].startswith("reaction/"):
        return state["reactions"][row["element"]][row["quantity"].removeprefix("reaction/")]
    if row["quantity"].startswith("limits/"):
        return state["limits"][row["element"]][row["quantity"].removeprefix("limits/")]
    return at(state["elements"][row["element"]] if row["element"] else state, row["quantity"])


def shift_values(shift: Any) -> list[Any]:
    found = [shift[key] for key in ("possibilities", "net_freedom", "engaged", "span")]
    for change in shift["changes"]:
        found += numbers(change)
    for state in shift["states"].values():
        found += state["engaged"]
        for key, value in state.items():
            found += numbers(value) if key not in ("direction", "speed_shares", "torque_shares",
                                                   "reactions") else []
        for reaction in state.get("reactions", {}).values():
            found += [reaction["speed"], reaction["torque"]]
    return found


def json_value(report: Any, row: dict[str, str]) -> Any:
    """The value of the JSON report that a row of the CSV repeats."""
    if row["pass"] == "mobility":
        return at(report["mobility"][row["element"]], row["quantity"])
    if row["pass"] == "shift":
        return shift_value(report["shift"], row)
    case = report["cases"][row["case"]]
    if row["quantity"] == RATIOS[row["pass"]]:
        return case[row["quantity"]]
    value = case[row["pass"]]
    if not row["element"]:
        return at(value, row["quantity"])
    sections = SECTIONS[row["pass"]]
    section, _, path = row["quantity"].partition("/")
    if section in LOSSES:
        return at(value["losses"][LOSSES[section]][row["element"]], path)
    if section == "self_stress":
        return value["self_stresses"][int(path)]["actions"][row["element"]]
    if section == "arc":
        arc = value["arcs"][row["element"]]
        return arc["power"] if path == f"{arc['from']}/{arc['to']}" else "another way"
    if section == "loop":
        loop = value["recirculation"]["loops"][int(path)]
        powers = dict(zip(loop["couplings"], loop["powers"]))
        return powers.get(row["element"], "not in it")
    if section in sections:
        return at(value[sections[section]][row["element"]], path)
    return at(value[sections[None]][row["element"]], row["quantity"])


def repeated_values(report: Any) -> list[Any]:
    """All numbers and nulls that the CSV must hold."""
    found = []
    for order in ("minimal", "planar", "spatial"):
        counts = report["mobility"][order]
        found += [] if counts is None else numbers(counts)
    for case in report["cases"].values():
        for name, sections in SECTIONS.items():
            for section in sections.values() if name in case else []:
                found += numbers(case[name].get(section, {}))
            found += [case[key] for key in [RATIOS[name]] if name in case and key in case]
        for stress in case.get("statics", {}).get("self_stresses", []):
            found += numbers(stress["actions"])
        if "dynamics" in case:
            for key in ("kinetic_energy", "kinetic_energy_rate", "shaking", "ground"):
                found += numbers(case["dynamics"].get(key, {}))
        if "power" in case:
            found += numbers(case["power"].get("efficiency", {}))
            found += numbers(case["power"].get("losses", {}))
            found += [case["power"]["input"], case["power"]["balance_residual"]]
            found += [case["power"]["recirculation"]["factor"]]
            found += numbers(case["power"]["arcs"])
            for loop in case["power"]["recirculation"]["loops"]:
                found += loop["powers"]
    if "shift" in report:
        found += shift_values(report["shift"])
    return found


def status_of(report: Any, row: dict[str, str]) -> str:
    """That of the pass, but of contacts their belt_state and of what completes equilibrium the method."""
    if row["pass"] == "mobility":
        return "solved"
    if row["pass"] == "shift":
        return report["shift"]["states"][row["case"]]["class"] if row["case"] else "solved"
    if row["pass"] == "dynamics":
        return report["cases"][row["case"]]["kinematics"]["status"]
    value = report["cases"][row["case"]][row["pass"]]
    if row["pass"] == "statics" and row["quantity"].startswith("contact/"):
        return value["contacts"][row["element"]]["belt_state"]
    if row["pass"] != "statics" or "completion" not in value:
        return value["status"]
    actions = value["completion"]["actions"]
    couplings = [coupling["name"] for coupling in report["graph"]["couplings"]
                 if any(action in coupling["actuators"] or
                        action.startswith(coupling["name"] + ".") for action in actions)]
    is_action = re.match(r"action|planet", row["quantity"])
    is_coupling = not re.match(r"action|load|friction|planet|contact|self_stress", row["quantity"])
    is_completed = row["element"] in (actions if is_action else couplings if is_coupling else [])
    return value["completion"]["method"] if is_completed else value["status"]
