"""Velocities and forces of the three sizes, relative to those of 1 m."""

import json

POWER = {"linear": 1, "force": -1}


def vectors(size):
    case = json.load(open(size + ".json"))["cases"]["turning"]
    for things, key in (("bodies", "linear"), ("couplings", "force")):
        pass_ = case["kinematics" if things == "bodies" else "statics"]
        for name, thing in pass_[things].items():
            for i, value in enumerate(thing[key]):
                yield key, (name, i), value


wanted = {(key, place): value for key, place, value in vectors("1")}
for size in ("1e-9", "1e9"):
    worst = max(abs(value / float(size) ** POWER[key] - wanted[key, place])
                for key, place, value in vectors(size))
    print(size, "same" if worst < 1e-12 * max(map(abs, wanted.values())) else worst)
