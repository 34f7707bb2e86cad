"""Changes of a mechanism file that do not change its mechanics.

Each takes the file, changes its tree, and returns the factors by which quantities are then multiplied;
None if the change does not apply to this file.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from typing import Callable, Iterator

from mechanism_file import UNITS, MechanismFile

# Whose tail and head are the same to mechanics, but for the sign.
REVERSIBLE = {"revolute", "prismatic", "cylindrical", "spherical", "helical", "clutch", "brake",
              "rigid"}


@dataclass
class Factors:
    """Of a coupling's freedoms and actions, and of everything that slides."""

    reversed: set[str] = field(default_factory=set)   # couplings
    actuators: dict[str, str] = field(default_factory=dict)  # their couplings
    slide: float = 1.0                                # of the rates of slides, in units of the file

    def _sign(self, name: str) -> float:
        coupling = self.actuators.get(name, name.split(".")[0])
        return -1.0 if coupling in self.reversed else 1.0

    def rate(self, name: str) -> float:
        is_slide = name.split(".")[-1].startswith("v")
        return self._sign(name) * (self.slide if is_slide else 1.0)

    def action(self, name: str) -> float:
        return self._sign(name)


def _actuators(file: MechanismFile) -> dict[str, str]:
    result = {name: one["coupling"] for name, one in (file.tree.get("actuators") or {}).items()}
    result.update((name, name) for name, one in file.couplings()
                  if one["type"] in ("clutch", "brake"))
    return result


def _has_geometry(file: MechanismFile) -> bool:
    return "couplings" in file.tree


# Order

def other_order(file: MechanismFile) -> Factors | None:
    """Bodies and couplings from the last to the first."""
    if not _has_geometry(file):
        return None
    bodies = file.tree["bodies"]
    file.tree["bodies"] = (dict(reversed(bodies.items())) if isinstance(bodies, dict)
                           else bodies[::-1])
    file.tree["couplings"] = dict(reversed(file.tree["couplings"].items()))
    return Factors()


# Senses

def _negated(text: str) -> str:
    return f"-({text})"


def _negate_known(values: dict, factors: Factors) -> None:
    for name, value in values.items():
        if factors.action(name) < 0:
            values[name] = _negated(value)


def reversed_couplings(file: MechanismFile) -> Factors | None:
    """Tail and head exchanged wherever that is no other coupling."""
    if not _has_geometry(file):
        return None
    factors = Factors(actuators=_actuators(file))
    in_gears = "gears" in file.tree
    for name, one in file.couplings():
        if one["type"] in REVERSIBLE and "one_way" not in one and not in_gears:
            one["bodies"] = one["bodies"][::-1]
            factors.reversed.add(name)
    for case in (file.tree.get("cases") or {}).values():
        for side in ("motion", "action"):
            _negate_known(case.get(side) or {}, factors)
    shift = file.tree.get("shift") or {}
    for key in ("input_motion", "input_action"):
        if isinstance(shift.get(key), str) and factors.action(shift["input"]) < 0:
            shift[key] = _negated(shift[key])
    for drive in _drives(file):
        if factors.action(drive["drive"]) < 0:
            for key in {"from", "to"} & drive.keys():
                drive[key] = _negated(drive[key])
    for spring in (file.tree.get("springs") or {}).values():
        if spring.get("coupling") in factors.reversed:
            for key in {"free", "drawn", "force"} & spring.keys():
                spring[key] = _negated(spring[key])
    return factors if factors.reversed else None


def _drives(file: MechanismFile) -> list[dict]:
    motion = file.tree.get("motion") or {}
    return motion.get("drives") or ([motion] if "drive" in motion else [])


# Places

Place = Callable[[list], None]


def _points(file: MechanismFile) -> Iterator[list]:
    """Every list of coordinates of a point; lists are to be changed in place."""
    for _, one in file.couplings():
        for key in ("at", "from", "to"):
            if isinstance(one.get(key), dict):
                yield from one[key].values()
            elif isinstance(one.get(key), list):
                yield one[key]
        if isinstance(one.get("screw"), dict):
            yield one["screw"]["at"]
        for part in (one.get("freedoms") or []) + (one.get("constraints") or []):
            if "at" in part:
                yield part["at"]
    for cable in (file.tree.get("cables") or {}).values():
        for station in cable["over"]:
            yield from ([station["at"]] if "at" in station else []) + (station.get("points") or [])
    bodies = file.tree["bodies"]
    for one in bodies.values() if isinstance(bodies, dict) else []:
        for key in ("reference", "centre_of_mass"):
            if isinstance(one, dict) and key in one:
                yield one[key]
    cases = (file.tree.get("cases") or {}).values()
    for loads in [file.tree.get("loads") or {}, *(case.get("loads") or {} for case in cases)]:
        yield from (load["at"] for load in loads.values() if "at" in load)
    for spring in (file.tree.get("springs") or {}).values():
        yield from (spring.get("at") or {}).values()
    for trace in (file.tree.get("motion") or {}).get("trace") or []:
        yield trace["at"]


def size_of(file: MechanismFile) -> float:
    """In the unit of length of the file."""
    metre = UNITS[file.length_unit][0]
    points = []
    for point in _points(file):
        values = [file.evaluate(x) for x in point]
        points.append([v.value if v.is_bare else v.value / metre for v in values])
    spans = [max(column) - min(column) for column in zip(*points)] if points else []
    return max(spans, default=0.0) or 1.0


def moved_origin(sizes: float) -> Callable[[MechanismFile], Factors | None]:
    """The world origin that many sizes of the mechanism away."""
    def change(file: MechanismFile) -> Factors | None:
        if not _has_geometry(file) or "gears" in file.tree or not list(_points(file)):
            return None
        size = 10.0 ** math.ceil(math.log10(size_of(file)))
        offset = [share * sizes * size for share in (0.7, -1.1, 0.4)]
        for name, one in file.couplings():
            if one["type"] == "prismatic" and "at" not in one:
                one["at"] = ["0"] * (2 if file.is_planar else 3)
        for point in _points(file):
            for i, text in enumerate(point):
                unit = "" if file.evaluate(text).is_bare else f" {file.length_unit}"
                if text.strip() == "0":
                    unit = ""
                point[i] = f"({text}) + ({offset[i]!r}{unit})"
        return Factors()
    return change


# Units

LENGTHS = {"radius", "thrust_radius", "length", "pitch", "lead", "module", "centre_distance",
           "free_length"}


def _known(file: MechanismFile) -> list[dict]:
    """What says which motions, actions and loads are known."""
    simulation = file.tree.get("simulation")
    return [*(file.tree.get("cases") or {}).values(), *([simulation] if simulation else [])]


def _names_curve(file: MechanismFile, text: str) -> bool:
    return bool(set(re.findall(r"[A-Za-z_]\w*", text)) & set(file.tree.get("curves") or {}))


def _with_unit(file: MechanismFile, text: str, unit: str) -> str:
    """The points of curves have units in the files of the library."""
    if text.strip() in ("0", "flat") or _names_curve(file, text):
        return text
    if not file.evaluate(text).is_bare:
        return text
    return f"({text})*1 {unit}"


def _give_units(file: MechanismFile, tree: dict | list, unit: str) -> None:
    """To the bare lengths under keys that are lengths."""
    for key, one in (tree.items() if isinstance(tree, dict) else enumerate(tree)):
        if isinstance(one, str) and (key in LENGTHS or key == "at"):
            tree[key] = _with_unit(file, one, unit)
        elif key == "radii":
            tree[key] = [_with_unit(file, text, unit) for text in one]
        elif isinstance(one, (dict, list)):
            _give_units(file, one, unit)


def _give_case_units(file: MechanismFile, slide_of: dict[str, bool], speed: str) -> None:
    for case in _known(file):
        for name, value in (case.get("motion") or {}).items():
            if slide_of.get(name, name.split(".")[-1].startswith("v")):
                case["motion"][name] = _with_unit(file, value, speed)


def slides_of(file: MechanismFile) -> dict[str, bool]:
    couplings = dict(file.couplings())
    return {name: (one.get("freedom") or "").startswith("v")
            or couplings.get(one["coupling"], {}).get("type") == "prismatic"
            for name, one in (file.tree.get("actuators") or {}).items()}


def other_units(unit: str) -> Callable[[MechanismFile], Factors | None]:
    """Lengths of the report in `unit`; those of the file keep theirs."""
    def change(file: MechanismFile) -> Factors | None:
        units = file.tree.get("units") or {}
        old, time = file.length_unit, file.time_unit
        damped = any("c" in one["friction"] for _, one in file.couplings()
                     if isinstance(one.get("friction"), dict)) if _has_geometry(file) else False
        if not _has_geometry(file) or unit == old or damped or "velocity" in units:
            return None
        for point in _points(file):
            point[:] = [_with_unit(file, x, old) for x in point]
        for section in ("couplings", "cables", "gears", "springs"):
            _give_units(file, file.tree.get(section) or {}, old)
        slide_of = slides_of(file)
        _give_case_units(file, slide_of, f"{old}/{time}")
        for drive in _drives(file):
            for key in {"from", "to"} & drive.keys():
                if slide_of.get(drive["drive"]):
                    drive[key] = _with_unit(file, drive[key], old)
        if "gravity" in file.tree:
            file.tree["gravity"] = [_with_unit(file, x, f"{old}/{time}^2")
                                    for x in file.tree["gravity"]]
        file.tree["units"] = {**units, "length": unit}
        return Factors(slide=UNITS[old][0] / UNITS[unit][0], actuators=_actuators(file))
    return change


def radians(file: MechanismFile) -> None:
    """Angles of the report in radians, where no coupling has one without a unit."""
    unit = (file.tree.get("units") or {}).get("angle", "rad")
    has_angles = any("angle" in key for _, one in file.couplings() for key in one)
    if unit == "rad" or has_angles:
        return
    slide_of = slides_of(file)
    for drive in _drives(file):
        for key in {"from", "to"} & drive.keys():
            if not slide_of.get(drive["drive"]) and re.fullmatch(r"[-+]?[\d.]+", drive[key]):
                drive[key] += f" {unit}"
    file.tree["units"]["angle"] = "rad"


# What the other kinds of quantity are reported in, and what a bare number of the file is in.
OTHER_UNITS = {"time": ("min", "s"), "mass": ("g", "kg"), "force": ("kN", "N"),
               "moment": ("N*mm", "N*m"), "angular_velocity": ("rpm", "rad/s"),
               "power": ("kW", "W"), "stiffness": ("N/mm", "N/m")}
USUAL = {kind: usual for kind, (_, usual) in OTHER_UNITS.items()}


def _each_with_unit(file: MechanismFile, tree: dict | list | None,
                    unit_of: Callable[[str], str]) -> None:
    """To the bare numbers of a list or a mapping; `unit_of` its key."""
    for key, text in list(tree.items() if isinstance(tree, dict) else enumerate(tree or [])):
        if isinstance(text, str):
            tree[key] = _with_unit(file, text, unit_of(key))


def _give_unit(file: MechanismFile, tree: dict, key: str, unit: str) -> None:
    """To the bare number behind a key, or to those in the list or mapping there."""
    if isinstance(tree.get(key), str):
        tree[key] = _with_unit(file, tree[key], unit)
    else:
        _each_with_unit(file, tree.get(key), lambda _: unit)


def _give_known_units(file: MechanismFile) -> None:
    """To what cases and gears know, but for the rates of slides, which go with the length."""
    slides = slides_of(file)

    def slides_at(name: str) -> bool:
        return slides.get(name, name.split(".")[-1][:1] in ("v", "R", "F"))

    for case in _known(file):
        _each_with_unit(file, case.get("action"),
                        lambda name: USUAL["force" if slides_at(name) else "moment"])
        rates = {n: x for n, x in (case.get("motion") or {}).items() if not slides_at(n)}
        _each_with_unit(file, rates, lambda _: USUAL["angular_velocity"])
        (case.get("motion") or {}).update(rates)
    shift = file.tree.get("shift") or {}
    for key, kind in (("input_action", "moment"), ("input_motion", "angular_velocity")):
        _give_unit(file, shift, key, USUAL[kind])


def _give_load_units(file: MechanismFile) -> None:
    """To loads, masses and stiffness."""
    for loads in [file.tree.get("loads"), *(case.get("loads") for case in _known(file))]:
        for load in (loads or {}).values():
            _give_unit(file, load, "force", USUAL["force"])
            _give_unit(file, load, "couple", USUAL["moment"])
    for _, one in file.couplings():
        _each_with_unit(file, one.get("stiffness"),
                        lambda name: "N*m/rad" if name[0] == "T" else USUAL["stiffness"])
    bodies = file.tree["bodies"]
    for one in bodies.values() if isinstance(bodies, dict) else []:
        if isinstance(one, dict) and not re.search("[a-z]", one.get("mass", "kg")):
            one["mass"] += f" {USUAL['mass']}"


def units_throughout(length: str) -> Callable[[MechanismFile], Factors | None]:
    """All quantities of the report in other units; those of the file keep theirs."""
    def change(file: MechanismFile) -> Factors | None:
        units = file.tree.get("units") or {}
        rubs_by_size = any({"tau", "c"} & set(one["friction"]) for _, one in file.couplings()
                           if isinstance(one.get("friction"), dict))
        if not _has_geometry(file) or rubs_by_size or set(units) - {"length", "angle"}:
            return None
        _give_known_units(file)
        _give_load_units(file)
        if other_units(length)(file) is None:
            return None
        radians(file)
        file.tree["units"].update({kind: new for kind, (new, _) in OTHER_UNITS.items()})
        return Factors()
    return change


POINTS_OF_TASKS = {"at", "pole", "centre", "free_point", "circle_point", "centre_point"}


def _metres(tree: dict | list) -> None:
    for key, one in tree.items() if isinstance(tree, dict) else enumerate(tree):
        if key in POINTS_OF_TASKS:
            tree[key] = [f"({text})*1 m" for text in one]
        elif isinstance(one, (dict, list)):
            _metres(one)


def units_of_task(file: MechanismFile, length: str, other_angle: bool) -> None:
    """A synthesis task in metres, reported in another unit of length, perhaps of angle, too."""
    task = file.tree["synthesis"]
    _metres(task)
    units = dict(file.tree.get("units") or {})
    old = units.get("angle", "rad")
    units["length"] = length
    if other_angle:
        units["angle"] = "deg" if old == "rad" else "rad"
        bare = re.compile(r"[-+.\de]+")
        for position in task.get("positions", []):
            for one in [position, *position.get("derivatives", [])]:
                if bare.fullmatch(one.get("angle", "")):
                    one["angle"] += f" {old}"
        for link in task.get("function", {}).values():
            link["angles"] = [f"{one} {old}" if bare.fullmatch(one) else one for one in link["angles"]]
    file.tree["units"] = units
