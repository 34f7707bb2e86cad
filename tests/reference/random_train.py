"""Transmissions drawn at random: as exact equations of Willis, and as a file in teeth.

A box joins random shafts by planetary sets of several kinds and by lay shafts; a truck has a
splitter, a lay shaft with four forward pairs and a reverse idler, and a planetary range group. A
layshaft gearbox has idlers on several lay shafts or on the main shafts, and at its end a shaft, a
final drive with an axis of its own, or a planetary set on the main axis or on another one.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from fractions import Fraction

from exact_train import HOUSING, Row, Train, simple_set


@dataclass
class Text:
    """The parts of a file that grow set by set."""

    planets: list[str] = field(default_factory=list)
    bearings: list[str] = field(default_factory=list)
    members: list[str] = field(default_factory=list)
    meshes: list[str] = field(default_factory=list)

    def planet(self, name: str, carrier: str) -> None:
        self.planets.append(name)
        self.bearings.append(f"  J_{name}: {{type: revolute, bodies: [{carrier}, {name}]}}")

    def member(self, name: str, body: str, teeth: int, more: str = "") -> None:
        self.members.append(f"    {name}: {{body: {body}, teeth: {teeth}{more}}}")

    def mesh(self, name: str, first: str, second: str, carrier: str = HOUSING) -> None:
        held = "" if carrier == HOUSING else f", carrier: {carrier}"
        self.meshes.append(f"    {name}: {{members: [{first}, {second}]{held}}}")



def willis(first: tuple[str, int], second: tuple[str, int], carrier: str) -> Row:
    """a (w_first - w_carrier) + b (w_second - w_carrier) = 0; the housing rests."""
    row: Row = {}
    for shaft, factor in (first, second, (carrier, -first[1] - second[1])):
        if shaft != HOUSING:
            row[shaft] = row.get(shaft, Fraction(0)) + factor
    return row


def add_simple(rng: random.Random, i: int, shafts: list[str], text: Text) -> Row:
    sun, ring, carrier = rng.sample(shafts, 3)
    return simple(i, (sun, ring, carrier), (rng.randint(18, 50), rng.randint(15, 40)), text)


def simple(i: int, shafts: tuple[str, str, str], teeth: tuple[int, int], text: Text) -> Row:
    sun, ring, carrier = shafts
    n, p = teeth
    text.planet(f"p{i}", carrier)
    text.member(f"sun{i}", sun, n)
    text.member(f"planet{i}", f"p{i}", p, f", count: 1")
    text.member(f"ring{i}", ring, n + 2 * p, ", internal: true")
    text.mesh(f"s{i}", f"sun{i}", f"planet{i}", carrier)
    text.mesh(f"r{i}", f"ring{i}", f"planet{i}", carrier)
    return simple_set(sun, ring, carrier, (n, n + 2 * p))


def add_double(rng: random.Random, i: int, shafts: list[str], text: Text) -> Row:
    """Two planets between sun and ring turn the sense round."""
    sun, ring, carrier = rng.sample(shafts, 3)
    n, inner, outer = rng.randint(25, 45), rng.randint(15, 22), rng.randint(16, 24)
    teeth = n + inner + outer + rng.randint(2, 8)
    text.planet(f"i{i}", carrier)
    text.planet(f"o{i}", carrier)
    text.member(f"sun{i}", sun, n)
    text.member(f"inner{i}", f"i{i}", inner, ", count: 1")
    text.member(f"outer{i}", f"o{i}", outer, ", count: 1")
    text.member(f"ring{i}", ring, teeth, ", internal: true")
    text.mesh(f"s{i}", f"sun{i}", f"inner{i}", carrier)
    text.mesh(f"t{i}", f"inner{i}", f"outer{i}", carrier)
    text.mesh(f"r{i}", f"ring{i}", f"outer{i}", carrier)
    return willis((sun, n), (ring, -teeth), carrier)


def add_stepped(rng: random.Random, i: int, shafts: list[str], text: Text) -> Row:
    """A planet with two gears, between two suns or a sun and a ring."""
    first, second, carrier = rng.sample(shafts, 3)
    return stepped(rng, i, (first, second, carrier), text, has_ring=rng.random() < 0.4)


def add_lay(rng: random.Random, i: int, shafts: list[str], text: Text) -> Row:
    first, second = rng.sample(shafts, 2)
    return stepped(rng, i, (first, second, HOUSING), text, has_ring=False)


def stepped(rng: random.Random, i: int, shafts: tuple[str, str, str], text: Text,
            has_ring: bool) -> Row:
    first, second, carrier = shafts
    a, pa, pb = rng.randint(17, 40), rng.randint(17, 40), rng.randint(17, 40)
    b = a + pa + pb + rng.randint(0, 2) if has_ring else rng.randint(17, 40)
    text.planet(f"p{i}", carrier)
    text.member(f"a{i}", first, a)
    text.member(f"pa{i}", f"p{i}", pa, ", count: 1")
    text.member(f"pb{i}", f"p{i}", pb)
    text.member(f"b{i}", second, b, ", internal: true" if has_ring else "")
    text.mesh(f"s{i}", f"a{i}", f"pa{i}", carrier)
    text.mesh(f"r{i}", f"b{i}", f"pb{i}", carrier)
    return willis((first, a * pb), (second, b * pa if has_ring else -b * pa), carrier)


def written(train: Train, text: Text, torque: Fraction) -> str:
    geared = {one.split("body: ")[1].split(",")[0] for one in text.members}
    geared |= {one.split("carrier: ")[1].rstrip("}") for one in text.meshes if "carrier: " in one}

    def place(*shafts: str) -> str:
        """A shaft without gears says where it is; 'gears' places the others."""
        return "" if geared & set(shafts) else ", at: [0, 0]"

    shafts = [f"  J_{s}: {{type: revolute, bodies: [housing, {s}]{place(s)}}}"
              for s in train.shafts]
    elements = [f"  {name}: {{type: {'brake' if HOUSING in ends else 'clutch'}, "
                f"bodies: [{ends[0]}, {ends[1]}]{place(*ends)}}}" for name, ends in train.elements.items()]
    return "\n".join([
        "kinestat: 1", "space: planar", "units: {length: mm}", "ground: housing",
        f"bodies: [{', '.join(train.shafts + text.planets)}]",
        "couplings:", *shafts, *text.bearings, *elements,
        "gears:", "  module: 1.5 mm", "  members:", *text.members, "  meshes:", *text.meshes,
        f"actuators: {{in: {{coupling: J_{train.input}}}, out: {{coupling: J_{train.output}}}}}",
        f"shift: {{input: in, output: out, elements: [{', '.join(train.elements)}], "
        f"input_action: {torque} N*m}}", ""])


def draw_box(rng: random.Random, torque: Fraction) -> tuple[Train, str]:
    """One that can move with all elements open."""
    while True:
        train, text = draw_any_box(rng, torque)
        if train.net_freedom() > 0:
            return train, text


def draw_any_box(rng: random.Random, torque: Fraction) -> tuple[Train, str]:
    shafts = [f"s{i}" for i in range(rng.randint(3, 6))]
    text = Text()
    kinds = (add_simple, add_double, add_stepped, add_lay)
    sets = [rng.choice(kinds)(rng, i, shafts, text) for i in range(rng.randint(1, 3))]
    joined = [HOUSING, *shafts]
    ends = [(a, b) for i, a in enumerate(joined) for b in joined[i + 1:]]
    chosen = rng.sample(ends, min(len(ends), rng.randint(2, 5)))
    input_, output = rng.sample(shafts, 2)
    train = Train(shafts=shafts, sets=sets,
                  elements={f"E{i}": pair for i, pair in enumerate(chosen)},
                  input=input_, output=output)
    return train, written(train, text, torque)


def two_suns(first: tuple[int, int], second: tuple[int, int], ends: tuple[str, str],
             torque: Fraction) -> tuple[Train, str]:
    """Simple sets with one carrier and one ring: ratios of their suns are nearly 1.

    `first` and `second` are teeth of sun and planet, `ends` are input and output.
    """
    text = Text()
    sets = [simple(i, (f"sun{i}", "ring", "carrier"), teeth, text)
            for i, teeth in enumerate((first, second))]
    free = next(shaft for shaft in ("carrier", "ring") if shaft not in ends)
    train = Train(shafts=["sun0", "sun1", "ring", "carrier"], sets=sets,
                  elements={"E0": (HOUSING, "sun1"), "E1": (HOUSING, free)},
                  input=ends[0], output=ends[1])
    return train, written(train, text, torque)


def draw_truck(rng: random.Random, torque: Fraction) -> tuple[Train, str]:
    text = Text()
    sets: list[Row] = []

    def pair(name: str, first: tuple[str, str], second: tuple[str, str]) -> None:
        (a, on_a), (b, on_b) = first, second
        text.mesh(name, a, b)
        sets.append({on_a: Fraction(teeth[a]), on_b: Fraction(teeth[b])})

    bodies = {"a1": "split", "a2": "m3", "a3": "m2", "a4": "m1", "ar": "rev", "ir": "ri",
              "b1": "lay", "b2": "lay", "b3": "lay", "b4": "lay", "br": "lay"}
    teeth = {name: rng.randint(18, 40) for name in bodies}
    for name, body in bodies.items():
        text.member(name, body, teeth[name], ", centre_distance: 75 mm" if name == "ir" else "")
    for i in "1234":
        pair(f"c{i}", (f"a{i}", bodies[f"a{i}"]), (f"b{i}", "lay"))
    pair("c5", ("br", "lay"), ("ir", "ri"))
    pair("c6", ("ir", "ri"), ("ar", "rev"))
    n, p = rng.randint(24, 40), rng.randint(17, 26)
    text.planet("planet9", "out")
    text.member("sun9", "main", n)
    text.member("planet9", "planet9", p, ", count: 1")
    text.member("ring9", "ring", n + 2 * p, ", internal: true")
    text.mesh("s9", "sun9", "planet9", "out")
    text.mesh("r9", "ring9", "planet9", "out")
    sets.append(simple_set("main", "ring", "out", (n, n + 2 * p)))
    train = Train(
        shafts=["in", "out", "split", "lay", "main", "m1", "m2", "m3", "rev", "ri", "ring"],
        sets=sets,
        elements={"SL": ("in", "split"), "SH": ("in", "m3"), "G1": ("main", "m1"),
                  "G2": ("main", "m2"), "G3": ("main", "m3"), "G4": ("in", "main"),
                  "GR": ("main", "rev"), "RL": (HOUSING, "ring"), "RH": ("ring", "out")},
        input="in", output="out")
    return train, written(train, text, torque)


def draw_layshafts(rng: random.Random, torque: Fraction) -> tuple[Train, str]:
    """Shafts on the ground, but for idlers, which their shafts bear; no place is said."""
    text = Text()
    sets: list[Row] = []
    shafts = ["in", "out"]
    bearings: dict[str, str] = {}
    elements: dict[str, tuple[str, str]] = {}
    axes: list[str] = []

    def pair(first: tuple[str, int], second: tuple[str, int]) -> None:
        i = len(text.meshes)
        text.member(f"a{i}", *first)
        text.member(f"b{i}", *second)
        text.mesh(f"m{i}", f"a{i}", f"b{i}")
        sets.append({first[0]: Fraction(first[1]), second[0]: Fraction(second[1])})

    def planetary(sun: str, ring: str) -> None:
        n, p = rng.randint(18, 40), rng.randint(15, 30)
        text.planet("planet", "out")
        text.member("sun", sun, n)
        text.member("planet", "planet", p)
        text.member("ring", ring, n + 2 * p, ", internal: true")
        text.mesh("sp", "sun", "planet", "out")
        text.mesh("rp", "ring", "planet", "out")
        sets.append(simple_set(sun, ring, "out", (n, n + 2 * p)))
        elements["B"] = (HOUSING, ring)

    mains = ["in"]
    if rng.random() < 0.5:
        shafts.append("hollow")
        mains.append("hollow")
        bearings["hollow"] = rng.choice([HOUSING, "in"])
        elements["K"] = ("in", "hollow")
    lays = [f"lay{i}" for i in range(rng.randint(1, 3))]
    shafts += lays
    for lay in lays:
        teeth = rng.randint(60, 90)
        for _ in range(rng.randint(1, 3)):
            main, wheel = rng.choice(mains), rng.randint(15, teeth - 15)
            if rng.random() < 0.25:
                pair((main, wheel), (lay, teeth - wheel))
                continue
            shaft = rng.choice([main, lay])
            idler = f"idler{len(text.meshes)}"
            shafts.append(idler)
            bearings[idler] = rng.choice([shaft, HOUSING])
            elements[f"S{len(elements)}"] = (shaft, idler)
            ends = (idler, lay) if shaft == main else (main, idler)
            pair((ends[0], wheel), (ends[1], teeth - wheel))
    end = rng.choice(["shaft", "final drive", "set", "set on its axis"])
    driven = "out" if end in ("shaft", "final drive") else "drum"
    if driven == "drum":
        shafts += ["drum", "ring"]
        planetary("drum", "ring")
    if end in ("final drive", "set on its axis"):
        axes = ["  axes:", "    main: {bodies: [in]}", f"    last: {{bodies: [{driven}]}}"]
    elif end == "set":
        elements["D"] = ("ring", "out")
    for lay in lays:
        pair((lay, rng.randint(14, 40)), (driven, rng.randint(40, 75)))
    train = Train(shafts=shafts, sets=sets, elements=elements, input="in", output="out")
    if train.net_freedom() <= 0 or not elements:
        return draw_layshafts(rng, torque)
    lines = written(train, text, torque).replace(", at: [0, 0]", "").splitlines()
    for shaft, bearer in bearings.items():
        at = next(i for i, line in enumerate(lines) if line.startswith(f"  J_{shaft}:"))
        lines[at] = lines[at].replace("[housing,", f"[{bearer},")
    at = lines.index("  members:")
    return train, "\n".join([*lines[:at], *axes, *lines[at:], ""])
