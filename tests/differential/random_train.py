"""Random planetary trains of one or two sets, with clutches and brakes."""

from __future__ import annotations

import random
from dataclasses import dataclass


@dataclass
class RandomTrain:
    """Shafts with a bearing each; `elements` are (type, tail, head) by name."""

    head: str
    couplings: list[str]
    elements: dict[str, tuple[str, str, str]]
    input: str
    output: str
    speed: int
    torque: int

    def text(self, cases: str = "", shift: str = "", more: str = "") -> str:
        lines = [f"  {name}: {{type: {kind}, bodies: [{tail}, {head}]}}"
                 for name, (kind, tail, head) in self.elements.items()]
        begin, gears = self.head.split("gears:")
        return "\n".join([begin + "couplings:", *self.couplings, *lines, "gears:" + gears
                          + f"actuators: {{in: {{coupling: s_{self.input}}}, "
                          f"out: {{coupling: s_{self.output}}}}}",
                          *([cases] if cases else []), *([shift] if shift else []),
                          *([more] if more else []), ""])

    def shift(self) -> str:
        return (f"shift: {{input: in, output: out, elements: [{', '.join(self.elements)}], "
                f"input_motion: {self.speed}, input_action: {self.torque}}}")

    def case(self, name: str, engaged: list[str]) -> str:
        """What a gear is by hand: no slip of what is engaged, no torque of what is open."""
        motion = ", ".join([f"in: {self.speed}", *(f"{e}: 0" for e in engaged)])
        action = ", ".join([f"in: {self.torque}",
                            *(f"{e}: 0" for e in self.elements if e not in engaged)])
        return f"  {name}: {{motion: {{{motion}}}, action: {{{action}}}, input: in, output: out}}"


def random_train(seed: int) -> RandomTrain:
    draw = random.Random(f"train {seed}")
    sets = draw.randint(1, 2)
    shafts = ["sun1", "ring1", "carrier1"]
    second = {"sun": "sun2", "ring": "ring2", "carrier": "carrier2"}
    if sets == 2:
        # Joined on one shaft or two, as Simpson's are.
        for part in draw.sample(sorted(second), draw.randint(1, 2)):
            second[part] = draw.choice([s for s in shafts if s not in second.values()])
        shafts += [body for body in second.values() if body not in shafts]
    members, meshes, planets = [], [], []
    for i in range(1, sets + 1):
        parts = ({"sun": "sun1", "ring": "ring1", "carrier": "carrier1"} if i == 1 else second)
        zs, zp = draw.randint(18, 40), draw.randint(14, 26)
        planets.append(f"  p{i}: {{type: revolute, bodies: [{parts['carrier']}, planet{i}]}}")
        members += [f"    s{i}: {{body: {parts['sun']}, teeth: {zs}}}",
                    f"    p{i}: {{body: planet{i}, teeth: {zp}, count: 3}}",
                    f"    r{i}: {{body: {parts['ring']}, teeth: {zs + 2 * zp}, internal: true}}"]
        meshes += [f"    sp{i}: {{members: [s{i}, p{i}], carrier: {parts['carrier']}}}",
                   f"    rp{i}: {{members: [r{i}, p{i}], carrier: {parts['carrier']}}}"]
    bodies = shafts + [f"planet{i}" for i in range(1, sets + 1)]
    head = "\n".join(["kinestat: 1", "space: planar", "units: {length: mm}", "ground: housing",
                      f"bodies: [{', '.join(bodies)}]", "gears:", "  module: 2 mm", "  members:",
                      *members, "  meshes:", *meshes, ""])
    couplings = [f"  s_{s}: {{type: revolute, bodies: [housing, {s}]}}" for s in shafts] + planets
    input_, output = draw.sample(shafts, 2)
    elements: dict[str, tuple[str, str, str]] = {}
    for shaft in draw.sample(shafts, min(len(shafts), draw.randint(1, 3))):
        elements[f"B{len(elements) + 1}"] = ("brake", "housing", shaft)
    for _ in range(draw.randint(1, 2)):
        elements[f"C{len(elements) + 1}"] = ("clutch", *draw.sample(shafts, 2))
    return RandomTrain(head, couplings, elements, input_, output, draw.choice([1, 100, -30]),
                       draw.choice([1, 50, -7]))
