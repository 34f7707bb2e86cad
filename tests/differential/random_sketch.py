"""Random mechanisms from a seed: any network, and families that are degenerate on purpose."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Callable

from exact_matrix import Echelon
from exact_network import ExactNetwork
from sketch import Actuator, Coupling, Load, Sketch, Vector

PLANAR_AXES = [(3, 4), (-4, 3), (5, 12), (12, -5), (-3, -4)]
SPATIAL_AXES = [(1, 2, 2), (2, -2, 1), (-2, 3, 6), (4, 4, 7), (3, 4, 0), (0, -4, 3), (8, 1, -4)]
PLANAR_TYPES = ["revolute"] * 7 + ["prismatic"] * 3 + ["pin_in_slot", "point_contact", "gear",
                                                       "rigid", "cable"]
SPATIAL_TYPES = ["revolute"] * 6 + ["prismatic"] * 2 + ["cylindrical"] * 2 + [
    "spherical", "spherical", "planar", "point_contact", "sphere_in_tube", "rigid"]
ZERO = Fraction(0)


def point(draw: random.Random, is_planar: bool, size: int = 4) -> Vector:
    """On a coarse grid, where things fall in line, or between its points."""
    def coordinate() -> Fraction:
        if draw.random() < 0.7:
            return Fraction(draw.randint(-size, size))
        return Fraction(draw.randint(-10 * size, 10 * size), 10)
    return [coordinate(), coordinate(), ZERO if is_planar else coordinate()]


def value(draw: random.Random) -> Fraction:
    return Fraction(draw.choice([0, 1, -1, 2, 5, -3, 7]), draw.choice([1, 1, 2, 10]))


def axis(draw: random.Random, is_planar: bool) -> str | tuple[int, ...]:
    if draw.random() < 0.65:
        return draw.choice("xy" if is_planar else "xyz")
    return draw.choice(PLANAR_AXES if is_planar else SPATIAL_AXES)


def coupling(draw: random.Random, name: str, kind: str, tail: str, head: str,
             is_planar: bool) -> Coupling:
    at = point(draw, is_planar)
    along: str | tuple[int, ...] = axis(draw, is_planar)
    if kind in ("rigid", "spherical") or (is_planar and kind == "revolute"):
        along = "z"
    to = None
    if kind == "cable":
        at = [Fraction(draw.randint(-4, 4)), Fraction(draw.randint(-4, 4)), ZERO]
        step = draw.choice([(3, 4), (-4, 3), (5, 0), (0, -2)])
        to = [at[0] + step[0], at[1] + step[1], ZERO]
    elif kind == "gear":
        along = draw.choice(PLANAR_AXES)
    return Coupling(name, kind, tail, head, at, along, is_planar, to)


def network(draw: random.Random, is_planar: bool) -> Sketch:
    """A random tree of bodies, and couplings that close circuits."""
    bodies = [f"b{i}" for i in range(1, draw.randint(1, 5 if is_planar else 4) + 1)]
    types = PLANAR_TYPES if is_planar else SPATIAL_TYPES
    reached, couplings = ["base"], []

    def add(tail: str, head: str) -> None:
        ends = (tail, head) if draw.random() < 0.8 else (head, tail)
        couplings.append(coupling(draw, f"c{len(couplings) + 1}", draw.choice(types), *ends,
                                  is_planar))
    for body in bodies:
        add(draw.choice(reached), body)
        reached.append(body)
    for _ in range(draw.randint(0, 3)):
        add(*draw.sample(reached, 2))
    return Sketch("network", is_planar, "base", bodies, couplings)


def revolute(name: str, tail: str, head: str, x: int | Fraction, y: int | Fraction) -> Coupling:
    return Coupling(name, "revolute", tail, head, [Fraction(x), Fraction(y), ZERO], "z", True)


def guide(name: str, tail: str, head: str, x: int, y: int, along: str) -> Coupling:
    return Coupling(name, "prismatic", tail, head, [Fraction(x), Fraction(y), ZERO], along, True)


def parallel_cranks(draw: random.Random) -> Sketch:
    """Equal cranks on one platform: one freedom, every crank beyond the second redundant."""
    count, dx, dy = draw.randint(2, 4), draw.randint(-3, 3), draw.randint(0, 3)
    couplings = []
    for i in range(count):
        x, y = draw.randint(-5, 5), draw.choice([0, 0, 1, 2])
        couplings += [revolute(f"f{i}", "base", f"crank{i}", x, y),
                      revolute(f"p{i}", f"crank{i}", "platform", x + dx, y + dy)]
    return Sketch("parallel cranks", True, "base",
                  [*(f"crank{i}" for i in range(count)), "platform"], couplings)


def dead_four_bar(draw: random.Random) -> Sketch:
    """Crank and coupler in line: the rocker is at rest and cannot drive."""
    x, y = draw.choice([(1, 2), (2, 1), (1, 0), (0, 1), (-1, 3)])
    reach, on = draw.choice([-1, 1, 2]), draw.choice([3, 4, -2])
    far = draw.choice([(7, 0), (5, -1), (6, 2)])
    couplings = [revolute("a", "base", "crank", 0, 0), revolute("b", "crank", "rod", reach * x,
                                                                reach * y),
                 revolute("c", "rod", "rocker", on * x, on * y),
                 revolute("d", "base", "rocker", *far)]
    return Sketch("four-bar at a dead point", True, "base", ["crank", "rod", "rocker"], couplings)


def dead_slider_crank(draw: random.Random) -> Sketch:
    crank = draw.choice([1, 2, -1])
    couplings = [revolute("a", "base", "crank", 0, 0), revolute("b", "crank", "rod", crank, 0),
                 revolute("c", "rod", "ram", draw.choice([4, 5, 7]), 0),
                 guide("d", "base", "ram", 5, draw.choice([0, 1]), draw.choice(["x", "x", "y"]))]
    return Sketch("slider-crank at a dead point", True, "base", ["crank", "rod", "ram"], couplings)


def flat_four_bar(draw: random.Random) -> Sketch:
    """All joints on one line: a change point, where the circuit loses a rank."""
    places = draw.sample(range(-6, 7), 4)
    couplings = [revolute(n, t, h, x, 0) for n, t, h, x in
                 zip("abcd", ("base", "l1", "l2", "base"), ("l1", "l2", "l3", "l3"), places)]
    return Sketch("flat four-bar", True, "base", ["l1", "l2", "l3"], couplings)


def beam(draw: random.Random) -> Sketch:
    """On two to four supports, some too many, some along the beam."""
    couplings = [revolute("pin", "base", "beam", 0, 0)] if draw.random() < 0.8 else []
    for i in range(draw.randint(1, 3)):
        couplings.append(Coupling(f"s{i}", "point_contact", "base", "beam",
                                  [Fraction(draw.randint(-4, 8)), ZERO, ZERO],
                                  draw.choice(["y", "y", "y", "x"]), True))
    return Sketch("beam", True, "base", ["beam"], couplings)


def balanced_ring(draw: random.Random) -> Sketch:
    """On a pin that leaves it free to turn, under couples and forces that balance in decimals."""
    sketch = Sketch("balanced ring", True, "base", ["ring"],
                    [revolute("pin", "base", "ring", draw.randint(-2, 2), draw.randint(-2, 2))])
    parts = [Fraction(draw.randint(-9, 9), 10) for _ in range(draw.randint(2, 5))]
    pin = sketch.couplings[0].at
    for i, part in enumerate([*parts, -sum(parts, ZERO)]):
        arm = draw.choice([1, 2, 4])
        if draw.random() < 0.5:
            load = Load(f"l{i}", "ring", pin, [ZERO] * 3, [ZERO, ZERO, part])
        else:
            load = Load(f"l{i}", "ring", [pin[0] + arm, pin[1], ZERO], [ZERO, part / arm, ZERO],
                        [ZERO] * 3)
        sketch.loads.append(load)
    return sketch


def truss(draw: random.Random) -> Sketch:
    """Bars from the wall to one body: three in a point or parallel hold it badly."""
    sketch = Sketch("truss", True, "base", ["plate"], [])
    hub = [Fraction(draw.randint(-3, 3)), Fraction(draw.randint(-3, 3)), ZERO]
    is_bad = draw.random() < 0.5
    for i in range(draw.randint(2, 4)):
        near = list(hub) if is_bad else [h + draw.randint(-2, 2) for h in hub]
        step = draw.choice([(3, 4), (-4, 3), (5, 0), (0, -2), (-3, 4), (-3, -4)])
        sketch.bodies.append(f"bar{i}")
        sketch.couplings += [
            revolute(f"w{i}", "base", f"bar{i}", near[0] + step[0], near[1] + step[1]),
            revolute(f"p{i}", f"bar{i}", "plate", near[0], near[1])]
    return sketch


def door(draw: random.Random) -> Sketch:
    """Hinges on one axis, or one of them beside it, where nothing moves."""
    couplings = []
    aside = draw.random() < 0.3
    for i in range(draw.randint(2, 3)):
        at = [Fraction(1 if aside and i == 1 else 0), ZERO, Fraction(draw.randint(-3, 3))]
        couplings.append(Coupling(f"h{i}", draw.choice(["revolute", "cylindrical", "spherical"]),
                                  "base", "door", at, "z"))
    return Sketch("door", False, "base", ["door"], couplings)


def table(draw: random.Random) -> Sketch:
    """A plate on contacts: legs in line, too many, too few."""
    couplings = [Coupling(f"leg{i}", "point_contact", "base", "plate", point(draw, False, 3),
                          draw.choice(["z", "z", "z", "x", "y", (1, 2, 2)]))
                 for i in range(draw.randint(3, 8))]
    return Sketch("table", False, "base", ["plate"], couplings)


def sarrus(draw: random.Random) -> Sketch:
    """Hinges of two directions lead a plate along z; in the last position all lie flat."""
    height = draw.choice([1, 2, 0])
    couplings, bodies = [], ["top"]
    for side, letter in enumerate("xy"[:draw.randint(1, 2)]):
        def at(out: int, up: int) -> Vector:
            across = [ZERO, Fraction(out)] if letter == "x" else [Fraction(out), ZERO]
            return [*across, Fraction(up)]
        bodies += [f"lower{side}", f"upper{side}"]
        couplings += [
            Coupling(f"a{side}", "revolute", "base", f"lower{side}", at(1, 0), letter),
            Coupling(f"b{side}", "revolute", f"lower{side}", f"upper{side}", at(3, height), letter),
            Coupling(f"c{side}", "revolute", f"upper{side}", "top", at(1, 2 * height), letter)]
    return Sketch("sarrus", False, "base", bodies, couplings)


FAMILIES: dict[bool, list[Callable[[random.Random], Sketch]]] = {
    True: [parallel_cranks, dead_four_bar, dead_slider_crank, flat_four_bar, beam, balanced_ring,
           truss],
    False: [door, table, sarrus],
}


def _independent(order: list[str], names: list[str], rows: list[Vector]) -> list[str]:
    """Of the columns `names`, as many as nothing else determines; the first of the order first."""
    columns = [n for n in names if n not in order] + order[::-1]
    places = [names.index(n) for n in columns]
    echelon = Echelon([[row[i] for i in places] for row in rows], len(columns))
    free = {n for i, n in enumerate(columns) if i not in echelon.rows}
    return [n for n in order if n in free]


def _shuffled(draw: random.Random, names: list[str]) -> list[str]:
    return draw.sample(names, len(names))


def _add_actuators(draw: random.Random, sketch: Sketch) -> None:
    """Mostly one for every freedom, as far as simple couplings have it."""
    exact = ExactNetwork(sketch)
    simple = _shuffled(draw, [name for name, c, _ in exact.freedoms
                              if c.type in ("revolute", "prismatic", "cylindrical")])
    if draw.random() < 0.7:
        chosen = _independent(simple, [name for name, _, _ in exact.freedoms], exact.closure())
        chosen += simple[:1] if draw.random() < 0.5 and simple[:1] != chosen[:1] else []
    else:
        chosen = simple[:draw.randint(0, 3)]
    sketch.actuators = [Actuator(f"m{i + 1}", *name.split("."))
                        for i, name in enumerate(dict.fromkeys(chosen))]


def _choose_motions(draw: random.Random, sketch: Sketch) -> None:
    exact = ExactNetwork(sketch)
    names = [name for name, _, _ in exact.freedoms]
    usable = [name for name in names if "?" not in name]
    driven = [f"{a.coupling}.{a.freedom}" for a in sketch.actuators]
    spoil = draw.random()
    if spoil < 0.15:
        known = _shuffled(draw, usable)[:draw.randint(0, 3)]
    else:
        order = driven + _shuffled(draw, [n for n in usable if n not in driven])
        known = _independent(order, names, exact.closure())
        known = known[1:] if spoil < 0.25 else known
    sketch.motion = {name: value(draw) for name in known}


def _choose_actions(draw: random.Random, sketch: Sketch) -> None:
    exact = ExactNetwork(sketch)
    names = [name for name, _, _ in exact.actions]
    usable = _shuffled(draw, [name for name in names if "?" not in name])
    spoil = draw.random()
    if spoil < 0.15:
        known = usable[:draw.randint(0, 3)]
    else:
        known = _independent(usable, names, exact.equilibrium())
        known = known[:draw.randint(0, len(known))] if spoil < 0.35 else known
    sketch.action = {name: value(draw) for name in known}


def _add_loads(draw: random.Random, sketch: Sketch) -> None:
    for i in range(draw.choice([0, 1, 1, 2, 3])):
        force = [value(draw), value(draw), ZERO if sketch.is_planar else value(draw)]
        couple = [ZERO, ZERO, draw.choice([ZERO, value(draw)])]
        sketch.loads.append(Load(f"l{i + 1}", draw.choice(sketch.bodies),
                                 point(draw, sketch.is_planar), force, couple))


def random_sketch(seed: int, is_planar: bool) -> Sketch:
    """Every third one is of a degenerate family."""
    draw = random.Random(f"{seed} {is_planar}")
    sketch = draw.choice(FAMILIES[is_planar])(draw) if seed % 3 == 0 else network(draw, is_planar)
    sketch.name += f" {seed}"
    _add_actuators(draw, sketch)
    _choose_motions(draw, sketch)
    _choose_actions(draw, sketch)
    if not sketch.loads:
        _add_loads(draw, sketch)
    if len(sketch.actuators) > 1:
        sketch.input, sketch.output = (a.name for a in draw.sample(sketch.actuators, 2))
    return sketch
