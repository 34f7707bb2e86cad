#!/usr/bin/env python3
"""Derivatives by the adjoint against central differences of whole analyses with --set.

For every mechanism of the library with parameters: the default values of its first solved case, by
every parameter. For those with friction, and some with every kind of friction: all actions, frictions
and powers of every case, against differences of reports; likewise for everything completed by
stiffness or least norm. Tooth numbers are also varied by a thousandth: the formulas allow it.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any

PROGRAM = ""
MECHANISMS = Path()
STEP = 1e-5  # of the parameter: the error of a central difference is about its square


def run(*arguments: str) -> dict[str, Any]:
    """The JSON report; published values that are missed do not matter here."""
    done = subprocess.run([PROGRAM, *arguments, "--format", "json"], capture_output=True,
                          encoding="utf-8", check=False, timeout=60)
    return json.loads(done.stdout) if done.stdout else {}


def values_of(report: dict[str, Any], label: str) -> dict[str, Any]:
    return report.get("cases", {}).get(label, {}).get("sensitivity", {})


# Viscous journals, a guide that tilts, a cam that slips; loads by which the friction turns.
RUBBING = {
    "planar": """\
kinestat: 1
space: planar
parameters: {x: 0.3, mu: 0.2, radius: 0.02, tau: 0.1, oil: 0.03, w: 2 rad/s, force: 40, side: 0.1, long: 0.25}
ground: f
bodies: [crank, rod, block, arm]
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0], friction: {mu: mu, radius: radius, tau: tau, c: oil}}
  b: {type: revolute, bodies: [crank, rod], at: [x, 0.4], friction: {mu: 2*mu, radius: radius}}
  c: {type: revolute, bodies: [rod, block], at: [1.5, 0.1], friction: {c: 0.01}}
  d: {type: prismatic, bodies: [f, block], at: [1.5, 0], axis: x, friction: {mu: mu, length: long, c: 5}}
  e: {type: revolute, bodies: [f, arm], at: [1.3, -1]}
  g: {type: point_contact, bodies: [block, arm], at: [1.6, -side], normal: [x, -1], friction: mu}
actuators: {motor: {coupling: a}, load: {coupling: d}, hold: {coupling: e}}
loads: {push: {body: block, at: [1.7, side], force: [-force, -2*force]}}
cases:
  there: {motion: {motor: w}, action: {load: -3*force, hold: force}, input: motor, output: load}
  back: {motion: {motor: -w}, action: {load: -3*force, hold: 2}, input: load, output: motor}
""",
    "spatial": """\
kinestat: 1
parameters: {x: 0.3, z: 0.1, mu: 0.15, w: 2 rad/s, v: 3 rad/s, force: 90, q: 0.2 rad, up: 0.1}
ground: f
bodies: [disc, slide, wheel]
couplings:
  a: {type: revolute, bodies: [f, disc], at: [0, 0, 0], axis: [0, sin(q), cos(q)], friction: {mu: mu, radius: 0.02}}
  b: {type: prismatic, bodies: [f, slide], at: [x, 0.9, 0.2], axis: [0, sin(q), cos(q)]}
  c: {type: revolute, bodies: [slide, wheel], at: [x, 0.5 + up*sin(q), up*cos(q)], axis: [1, z, 0.2], friction: {mu: mu, radius: 0.01, c: 0.2}}
  d: {type: point_contact, bodies: [disc, wheel], at: [x, 0.5, 0], normal: [0, sin(q), cos(q)], friction: 2*mu}
actuators: {one: {coupling: a}, two: {coupling: c}}
loads: {weight: {body: wheel, at: [x, 0.7, 0.2], force: [5, 0, -force]}}
cases:
  slipping: {motion: {one: w, two: v}, action: {}}
  dragged: {motion: {one: w, two: -v}, action: {}}
""",
}

# Elastic supports of every kind, some actions rigid, some open for good; known actions; friction and
# power beside elastic guides; a size that moves.
SHARING = {
    "beam": """\
kinestat: 1
space: planar
parameters: {x: 0.7, L: 3, ka: 1e6, kb: 2e6, kt: 5e4, force: 700, pre: 40, tilt: 0.2 rad, up: 0.2}
statics: {indeterminate: stiffness}
ground: base
bodies: [beam]
couplings:
  a: {type: revolute, bodies: [base, beam], at: [0, 0], stiffness: {Rx: 3*ka, Ry: ka}}
  b: {type: revolute, bodies: [base, beam], at: [1, up], stiffness: {Ry: kb}}
  c: {type: point_contact, bodies: [base, beam], at: [L, 0], normal: [sin(tilt), cos(tilt)]}
  e: {type: prismatic, bodies: [base, beam], at: [x + 1.5, -0.1], axis: x, stiffness: {Ry: kb/2, Tz: kt}}
loads: {push: {body: beam, at: [x, 0], force: [force/5, -force]}}
cases:
  loaded: {action: {}}
  preloaded: {action: {a.Ry: pre}}
""",
    "rigid": """\
kinestat: 1
space: planar
parameters: {x: 1, k: 2e6, force: 700, far: 3}
statics: {indeterminate: stiffness}
ground: base
bodies: [beam]
couplings:
  a: {type: revolute, bodies: [base, beam], at: [0, 0], stiffness: {Ry: 1e6}}
  b: {type: revolute, bodies: [base, beam], at: [1, 0], stiffness: {Ry: k}}
  c: {type: revolute, bodies: [base, beam], at: [far, 0], passive: [Ry], stiffness: {Ry: 4e6}}
loads: {push: {body: beam, at: [x, 0], force: [9, -force]}}
cases: {loaded: {action: {}}}
""",
    "plate": """\
kinestat: 1
parameters: {x: 0.4, k: 1e6, kt: 2e4, force: 90, q: 0.3 rad, soft: 3}
statics: {indeterminate: stiffness}
ground: base
bodies: [plate, arm]
couplings:
  a: {type: spherical, bodies: [base, plate], at: [0, 0, 0], stiffness: {Rx: k, Ry: 2*k, Rz: k}}
  b: {type: revolute, bodies: [base, plate], at: [1, x, 0.1], axis: z, stiffness: {Rx: k, Rz: soft*k, Tx: kt, Ty: 2*kt}}
  c: {type: point_contact, bodies: [base, plate], at: [0.3, 1, x], normal: [sin(q), 0, cos(q)]}
  d: {type: revolute, bodies: [plate, arm], at: [0.5, 0.5, 0.2], axis: [0, sin(q), cos(q)]}
  e: {type: point_contact, bodies: [base, arm], at: [1.2, 0.4, 0.8], normal: x, stiffness: {Rx: k}}
  g: {type: cable, bodies: [base, arm], from: [2, x, 1], to: [1.2, 0.9, 0.6], stiffness: {F: k/soft}}
loads: {pull: {body: arm, at: [1, x, 1], force: [force, -force/2, 30], couple: [1, 0, soft]}}
cases: {pulled: {action: {}}}
""",
    "press": """\
kinestat: 1
space: planar
parameters: {r: 0.3, l: 1.1, q: 0.7 rad, mu: 0.1, w: 2 rad/s, force: 40, k: 1e6, gap: 0.4, up: 0.1}
statics: {indeterminate: stiffness}
ground: f
bodies: [crank, rod, block]
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0], friction: {mu: mu, radius: 0.02, c: 0.1}}
  b: {type: revolute, bodies: [crank, rod], at: [r*cos(q), r*sin(q)], friction: {mu: 2*mu, radius: 0.03}}
  c: {type: revolute, bodies: [rod, block], at: [r*cos(q) + sqrt(l^2 - (r*sin(q))^2), 0]}
  d: {type: prismatic, bodies: [f, block], at: [1, 0], axis: x, stiffness: {Ry: k, Tz: 1e3}}
  e: {type: prismatic, bodies: [f, block], at: [1 + gap, up], axis: x, stiffness: {Ry: 2*k, Tz: 500}}
actuators: {motor: {coupling: a}, load: {coupling: d}}
loads: {side: {body: block, at: [1.6, up], force: [0, -force]}}
cases:
  pressing: {motion: {motor: w}, action: {load: -force}, input: motor, output: load}
""",
}
SHARING["least"] = SHARING["press"].replace("indeterminate: stiffness", "indeterminate: minimum_norm")
SHARING["least_beam"] = SHARING["beam"].replace("indeterminate: stiffness",
                                                "indeterminate: minimum_norm")

# Forces of inertia and of springs: pins, slots, teeth with several planets, a ball, a universal joint
# and a cylinder; friction and dampers beside them; axes and places that move.
MOVING = {
    "engine": """\
kinestat: 1
space: planar
parameters: {r: 0.3, l: 1.1, q: 0.7 rad, mu: 0.1, w: 12 rad/s, speeds_up: 30 rad/s^2, ma: 2, Jz: 0.3, off: 0.05,
             k: 900 N/m, l0: 0.9, c: 40 N*s/m, kt: 7 N*m/rad, swing: 0.4 rad, pre: 60 N, p: 300 N}
gravity: [0, -9.81]
ground: f
bodies:
  crank: {mass: 3*ma, centre_of_mass: [off, 2*off], inertia: Jz/4}
  rod: {mass: ma, centre_of_mass: [r*cos(q) + l/3, r*sin(q)/2 - off], inertia: Jz}
  block: {mass: 4*ma, centre_of_mass: [1.3, off]}
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0], friction: {mu: mu, radius: 0.02, c: 0.1}}
  b: {type: revolute, bodies: [crank, rod], at: [r*cos(q), r*sin(q)]}
  c: {type: revolute, bodies: [rod, block], at: [r*cos(q) + sqrt(l^2 - (r*sin(q))^2), 0]}
  d: {type: prismatic, bodies: [f, block], at: [1, 0], axis: x, friction: {mu: mu, length: 0.25}}
springs:
  back: {bodies: [f, rod], at: {f: [0.4, -0.5], rod: [r*cos(q) + l/2, r*sin(q)/2]}, stiffness: k,
         free_length: l0, damping: c, force: pre/3}
  turn: {coupling: b, stiffness: kt, free: swing, damping: Jz}
  slide: {coupling: d, stiffness: k/3, damping: c}
  gas: {bodies: [f, crank], at: {f: [-0.5, 0.1], crank: [r*cos(q)/2, 0.2]},
        gas: {force: pre, length: 0.8, stroke: 0.3, ratio: 1 + l0, exponent: 1.2}}
  slack: {bodies: [f, block], at: {f: [3, 0], block: [1.4, 0]}, stiffness: k, free_length: 2, acts: pull}
actuators: {motor: {coupling: a}, load: {coupling: d}}
cases:
  running: {motion: {motor: w}, acceleration: {motor: speeds_up}, action: {load: -p}, input: motor,
            output: load}
  at rest: {action: {load: p}}
""",
    "slot": """\
kinestat: 1
space: planar
parameters: {x: 0.3, y: 0.9, w: 5 rad/s, ma: 2, Jz: 0.3, slope: 0.3}
ground: f
bodies:
  crank: {mass: ma, centre_of_mass: [x/2, 0.6], inertia: Jz/4}
  lever: {mass: ma, centre_of_mass: [0.1, y/2], inertia: Jz}
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0.6]}
  s: {type: pin_in_slot, bodies: [crank, lever], at: [x, y], slot: [slope, 1]}
  b: {type: revolute, bodies: [f, lever], at: [0, 0]}
actuators: {motor: {coupling: a}, tool: {coupling: b}}
cases:
  running: {motion: {motor: w}, acceleration: {}, action: {tool: -5}}
  starting: {motion: {motor: 0}, acceleration: {motor: 3*w/(1 s)}, action: {tool: 0}}
""",
    "planets": """\
kinestat: 1
space: planar
parameters: {r1: 0.05, r2: 0.03, w: 70 rad/s, slow: 20 rad/s^2, ma: 2, Jz: 0.01, torque: 9 N*m, tilt: 20 deg}
ground: f
bodies:
  sun: {inertia: Jz}
  arm: {inertia: 5*Jz, mass: ma, centre_of_mass: [0.001, 0]}
  planet: {inertia: Jz/3, mass: ma/2, centre_of_mass: [0, r1 + r2]}
couplings:
  a: {type: revolute, bodies: [f, sun], at: [0, 0]}
  c: {type: revolute, bodies: [f, arm], at: [0, 0]}
  d: {type: revolute, bodies: [arm, planet], at: [0, r1 + r2]}
  e: {type: gear, bodies: [sun, planet], at: [0, r1], tangent: x, pressure_angle: tilt}
  g: {type: gear, bodies: [f, planet], at: [0, r1 + 2*r2], tangent: x, pressure_angle: tilt, internal: true}
actuators: {motor: {coupling: a}, out: {coupling: c}}
cases: {running: {motion: {motor: w}, acceleration: {motor: -slow}, action: {out: -torque}}}
""",
    "space": """\
kinestat: 1
parameters: {r: 0.2, x: 0.7, z: 0.3, w: 9 rad/s, up: 15 rad/s^2, ma: 1.5, Jz: 0.02, tilt: 0.3 rad}
gravity: [0, 0, -9.81]
ground: f
bodies:
  crank: {mass: ma, centre_of_mass: [r/2, 0.01, 0], inertia: [Jz, 2*Jz, 2.5*Jz]}
  rod: {mass: 2*ma, centre_of_mass: [x/2 + r/2, 0.2, z/2], inertia: [[3*Jz, -Jz/5, 0.001], [-Jz/5, 4*Jz, Jz/9], [0.001, Jz/9, 4*Jz]]}
  rocker: {mass: ma, centre_of_mass: [x, 0.5, z/2], inertia: {polar: Jz, axis: [cos(tilt), 0, sin(tilt)]}}
couplings:
  a: {type: revolute, bodies: [f, crank], at: [0, 0, 0], axis: [0, sin(tilt), cos(tilt)]}
  s: {type: spherical, bodies: [crank, rod], at: [r, 0, 0]}
  u: {type: universal, bodies: [rod, rocker], at: [x, 0.5, z], axes: [[0, 1, 0], [cos(tilt), 0, sin(tilt)]]}
  b: {type: cylindrical, bodies: [f, rocker], at: [x, 0.5, 0], axis: [cos(tilt), 0, sin(tilt)]}
  h: {type: helical, bodies: [f, rocker], at: [x, 0.5, 0], axis: [cos(tilt), 0, sin(tilt)], pitch: 0.01}
springs:
  wire: {bodies: [f, rod], at: {f: [0, 1, 1], rod: [0.4, 0.2, z]}, stiffness: 300, free_length: 0.8, damping: 2*ma}
actuators: {motor: {coupling: a}}
cases: {running: {motion: {motor: w}, acceleration: {motor: up}, action: {}}}
""",
}


def moved_to(parameter: str, known: dict[str, Any], by: float) -> str:
    """For --set."""
    unit = f"*{known['unit']}" if known["unit"] else ""
    return f"{parameter}=({known['value'] + by!r}){unit}"


def numbers_in(node: Any, path: str = "") -> dict[str, float]:
    """The numbers of a part of the report, by their paths."""
    if isinstance(node, dict | list):
        items = node.items() if isinstance(node, dict) else enumerate(node)
        return {at: number for key, item in items
                for at, number in numbers_in(item, f"{path}/{key}").items()}
    return {path[1:]: node} if isinstance(node, float | int) else {}


def physics_of(case: dict[str, Any]) -> dict[str, float]:
    """What a case says of actions and powers."""
    names = {"statics": ("actions", "couplings", "friction"),
             "power": ("couplings", "supplied", "actuators", "loads", "friction", "efficiency",
                       "input")}
    chosen = {part: {name: case.get(part, {}).get(name) for name in those}
              for part, those in names.items()}
    found = {path: number for path, number in numbers_in(chosen).items() if "/screw/" not in path}
    ratio = case.get("torque_ratio")
    return found | ({"torque_ratio": ratio} if ratio is not None else {})


class Sensitivity(unittest.TestCase):
    def test_agrees_with_differences(self) -> None:
        compared = 0
        for path in sorted(MECHANISMS.glob("**/*.yaml")):
            text = path.read_text(encoding="utf-8")
            if "\nparameters:" in text and "\ncouplings:" in text:
                with self.subTest(path.name):
                    compared += self.compare(str(path))
        self.assertGreater(compared, 100)

    def test_agrees_with_differences_where_there_is_friction(self) -> None:
        paths = [path for path in sorted(MECHANISMS.glob("**/*.yaml"))
                 if re.search(r"^parameters:.*friction:", path.read_text(encoding="utf-8"),
                              re.DOTALL | re.MULTILINE)
                 and "\ncables:" not in path.read_text(encoding="utf-8")]  # ropes: not yet
        self.compare_reports(paths, 4, RUBBING, 100)

    def test_agrees_with_differences_where_actions_are_completed(self) -> None:
        paths = [path for path in sorted(MECHANISMS.glob("**/*.yaml"))
                 if re.search(r"^parameters:.*^statics: {indeterminate: (stiffness|minimum_norm)}",
                              path.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)]
        self.compare_reports(paths, 3, SHARING, 30)

    def test_agrees_with_differences_where_bodies_have_inertia(self) -> None:
        self.compare_reports([], 0, MOVING, 20)

    def compare_reports(self, paths: list[Path], least_paths: int, texts: dict[str, str],
                        least: int) -> None:
        """Of the files, and of the texts written to files."""
        self.assertGreaterEqual(len(paths), least_paths)
        with tempfile.TemporaryDirectory() as folder:
            for name, text in texts.items():
                paths.append(Path(folder, f"{name}.yaml"))
                paths[-1].write_text(text, encoding="utf-8")
            for path in paths:
                with self.subTest(path.name):
                    self.assertGreater(self.compare_report(str(path)), least)

    def compare_report(self, path: str) -> int:
        """How many derivatives of actions and powers agree with differences of the report; none is
        missing but where the report beside has no value."""
        compared = 0
        report = run("analyze", path)
        for label, case in report["cases"].items():
            known = physics_of(case)
            chosen = [word for name in known for word in ("--of", name)]
            answer = run("sensitivity", "--case", label, *chosen, path)
            self.assertEqual(values_of(answer, label).keys(), known.keys())
            for name, entry in values_of(answer, label).items():
                self.assertAlmostEqual(entry["value"], known[name],
                                       delta=1e-11 * self.scale(known, name), msg=name)
            for name, parameter in answer["mechanism"]["parameters"].items():
                compared += self.compare_parameter(path, label, values_of(answer, label),
                                                   (name, parameter))
        return compared

    @staticmethod
    def scale(known: dict[str, float], name: str) -> float:
        """The largest value beside a name, for zero is what is rounding of that."""
        group = name.split("/")[:2]
        return max(abs(value) for other, value in known.items() if other.split("/")[:2] == group)

    def compare_parameter(self, path: str, label: str, values: dict[str, Any],
                          named: tuple[str, dict[str, Any]]) -> int:
        name, parameter = named
        size = abs(parameter["value"]) or 1.0
        low, high = (physics_of(run("analyze", "--set", moved_to(name, parameter, sign * STEP * size),
                                    path).get("cases", {}).get(label, {}))
                     for sign in (-1.0, 1.0))
        known = {value: entry["value"] for value, entry in values.items()}
        return sum(self.agrees(entry["by"][name]["derivative"],
                               [end[value] for end in (low, high) if value in end], size,
                               self.scale(known, value), f"{label}: {value} by {name}")
                   for value, entry in values.items())

    def agrees(self, derivative: float | None, ends: list[float], size: float, scale: float,
               where: str) -> bool:
        """Whether there is a derivative, which must be where both ends have a value and nowhere
        else, and must agree with their difference."""
        self.assertEqual(derivative is None, len(ends) < 2, msg=where)
        if derivative is None:
            return False
        difference = (ends[1] - ends[0]) / (2.0 * STEP * size)
        self.assertAlmostEqual(derivative, difference,
                               delta=1e-6 * (abs(difference) + scale / size), msg=where)
        return True

    def compare(self, path: str) -> int:
        report = run("sensitivity", path)
        for label, case in report.get("cases", {}).items():
            if case["sensitivity"]:
                return self.compare_case(path, report, label)
        return 0

    def compare_case(self, path: str, report: dict[str, Any], label: str) -> int:
        compared = 0
        values = values_of(report, label)
        for name, parameter in report["mechanism"]["parameters"].items():
            size = abs(parameter["value"]) or 1.0
            ends = [self.moved(path, label, list(values), name, parameter, sign * STEP * size)
                    for sign in (-1.0, 1.0)]
            compared += sum(self.agrees(entry["by"][name]["derivative"],
                                        [end[value]["value"] for end in ends if value in end], size,
                                        abs(entry["value"]), f"{label}: {value} by {name}")
                            for value, entry in values.items())
        return compared

    @staticmethod
    def moved(path: str, label: str, names: list[str], parameter: str, known: dict[str, Any],
              by: float) -> dict[str, Any]:
        """The values with the parameter moved; empty where the mechanism no longer fits."""
        chosen = [word for name in names for word in ("--of", name)]
        report = run("sensitivity", "--case", label, *chosen, "--by", parameter,
                     "--set", moved_to(parameter, known, by), path)
        return values_of(report, label)


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
