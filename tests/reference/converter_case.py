"""A torque converter with a lock-up, its characteristic, and what the program says of it."""

from __future__ import annotations

import program

# Pump and turbine on one axis, with a lock-up; torques at 2000 rpm.
RATIOS = [0, 0.3, 0.5, 0.85, 0.95, 1]
MU = [2.1, 1.75, 1.5, 1, 1, 1]
PUMP = [150, 146, 140, 90, 45, 0]

CHARACTERISTIC = f"""
      stator: housing
      characteristic:
        speed_ratio:  {RATIOS}
        torque_ratio: {MU}
        pump_torque:  {PUMP}
        pump_speed: 2000 rpm"""

FLUID_COUPLING = """
      characteristic: {pump_torque: 150 N*m*(1 - speed_ratio), pump_speed: 2000 rpm}"""


def model(cases: str, characteristic: str = CHARACTERISTIC, more: str = "") -> str:
    return f"""kinestat: 1
space: planar
units: {{length: mm, angular_velocity: rpm, power: W}}
ground: housing
bodies: [pump, turbine]
couplings:
  E: {{type: revolute, bodies: [housing, pump], at: [0, 0]}}
  T: {{type: revolute, bodies: [housing, turbine], at: [0, 0]}}
  L: {{type: clutch, bodies: [pump, turbine], at: [0, 0]}}
  TC: {{type: torque_converter, bodies: [pump, turbine], at: [0, 0]{flow(characteristic)}}}
actuators: {{engine: {{coupling: E}}, out: {{coupling: T}}}}
{more}cases:
{cases}"""


# The lines of a mapping as one in braces.
def flow(block: str) -> str:
    text = ""
    for line in block.strip().splitlines():
        key, _, value = line.strip().partition(":")
        text += ", " + (f"{key}: {{" if not value else f"{key}: {value.strip()}")
    text = text.replace("{, ", "{")
    return text + ("}" if text.count("{") > text.count("}") else "")


def case(name: str, engine: float | None, out: float | None, action: str = "L: 0") -> str:
    motion = ", ".join(f"{key}: {value!r}" for key, value in (("engine", engine), ("out", out))
                       if value is not None)
    return f"  {name}: {{motion: {{{motion}}}, action: {{{action}}}, input: engine, output: out}}\n"


def analyze(text: str) -> dict:
    return program.run("analyze", "-", text=text)["cases"]


# Fritsch and Butland 1984, written down anew: slopes are weighted harmonic means of the chords.
def interpolated(xs: list[float], ys: list[float], x: float) -> float:
    count = len(xs)
    widths = [xs[i + 1] - xs[i] for i in range(count - 1)]
    chords = [(ys[i + 1] - ys[i]) / widths[i] for i in range(count - 1)]

    def end(h0: float, h1: float, c0: float, c1: float) -> float:
        slope = ((2 * h0 + h1) * c0 - h0 * c1) / (h0 + h1)
        if slope * c0 <= 0:
            return 0.0
        return 3 * c0 if c0 * c1 <= 0 and abs(slope) > 3 * abs(c0) else slope

    slopes = [end(widths[0], widths[1], chords[0], chords[1])]
    for i in range(1, count - 1):
        a, b = chords[i - 1], chords[i]
        w1 = 2 * widths[i] + widths[i - 1]
        w2 = widths[i] + 2 * widths[i - 1]
        slopes.append(0.0 if a * b <= 0 else (w1 + w2) / (w1 / a + w2 / b))
    slopes.append(end(widths[-1], widths[-2], chords[-1], chords[-2]))
    i = max(k for k in range(count - 1) if xs[k] <= x)
    h = widths[i]
    t = (x - xs[i]) / h
    return (ys[i] * (1 + 2 * t) * (1 - t) ** 2 + h * slopes[i] * t * (1 - t) ** 2
            + ys[i + 1] * t * t * (3 - 2 * t) + h * slopes[i + 1] * t * t * (t - 1))
