#!/usr/bin/env python3
"""Synthesis with many digits, from the text of the file to the report.

Positions of a crank-rocker that are so close that doubles lose all digits of its dyads: typed with
40 digits, with dyads computed independently in arithmetic of 60, and as formulas, whose dyads are
the linkage itself. In double they are refused with a warning; with --digits they are right.
"""

from __future__ import annotations

import math
import sys
import unittest
from typing import NamedTuple

import program

Pair = tuple[float, float]


class Task(NamedTuple):
    """Positions x, y, angle as typed, and (circle point, centre point) of the dyads."""

    positions: list[tuple[str, str, str]]
    dyads: list[tuple[Pair, Pair]]
    tolerance: float


TASKS = {
    "IC09": Task(
        [
            ("0.5815525930143709959744744544381568063908",
             "0.3836821224889589524233395664480953194858",
             "0.4721943757718848866841594406037809733252"),
            ("0.5815522648964023757176671227839351535883",
             "0.3836831816929242077986969485102583151871",
             "0.4721940420713528825034391661539307122198"),
            ("0.5815519367775316683196882349117718830267",
             "0.3836842408965232383418083354273871804169",
             "0.4721937083708755061852654671576983059668"),
            ("0.581551608657758874077696513339812373429",
             "0.3836853000997560428979737187344319344511",
             "0.4721933746704527582991865857194346057415"),
            ("0.5815512805370839932888513912834014448224",
             "0.3836863593026226203124938464241598343701",
             "0.4721930409700846394147497320918884193694"),
        ],
        [
            ((0.3, -0.2), (1.1820951255609505e-38, 5.713284966884848e-39)),
            ((1.1111540774826583, 18.788920622629284), (6.71609488624357, -3.1176152891010833)),
            ((6.680357822711736, -1.8725205295535479), (6.536009988571666, 1.6640949098988096)),
            ((3.5878044949658263, 1.0001423260940798), (4.0, 0.5)),
        ],
        1e-11),
    "IC10": Task(
        [
            ("0.5815525930143709959744744544381568063908",
             "0.3836821224889589524233395664480953194858",
             "0.4721943757718848866841594406037809733252"),
            ("0.581552592686253477946843566499156047448",
             "0.3836821235481631006076343076706973882212",
             "0.4721943754381843273935509433072203374857"),
            ("0.5815525923581359590171252405276856813254",
             "0.3836821246073672484257053701933050524821",
             "0.4721943751044837681575697395775969777593"),
            ("0.5815525920300184391853194768209033655622",
             "0.3836821256665713958775527528612171702545",
             "0.4721943747707832089762158299844606824768"),
            ("0.5815525917019009184514262756759667584084",
             "0.3836821267257755429631764545197326002807",
             "0.4721943744370826498494892150973612389371"),
        ],
        [
            ((0.3, -0.2), (8.711581775358339e-26, 4.210336851670838e-26)),
            ((1.1112074864909922, 18.788752639506885), (6.716076284723898, -3.117604350165939)),
            ((6.680338384252358, -1.8725105674150269), (6.5359971587081445, 1.6640953516770183)),
            ((3.5878044949658263, 1.0001423260940798), (4.0, 0.5)),
        ],
        0.001),
    "IC15": Task(
        [
            ("0.0",
             "0.0",
             "0.0"),
            ("0.0000001895572702681690034698133982547179850173",
             "0.000001092539465022968664435925201239234067196",
             "-0.0000003337005320041807202744498502611053989841"),
            ("0.0000003791135705881826803358577894780671393331",
             "0.000002185079014203016646045229288273254284934",
             "-0.0000006674010093804988939734460826673584582434"),
            ("0.0000005686689009597804663037452677036437043965",
             "0.000003277618647538980440782191776598590547432",
             "-0.00000100110143212838497285488434636758371473"),
            ("0.0000007582232613827017980560837007745297027637",
             "0.000004370158365029696544951517917799036130854",
             "-0.000001334801800247269409708511892553955850865"),
        ],
        [
            ((0.3, -0.2), (-0.6924292551486645, -0.07718235662142461)),
            ((1.1111540774826583, 18.788920622629284), (3.8707178639645403, -5.908403839397801)),
            ((6.680357822711736, -1.8725205295535479), (5.885260092914112, -1.5680348913280648)),
            ((3.5878044949658263, 1.0001423260940798), (3.0972809183831607, -1.4512627038462094)),
        ],
        1e-11),
}

# Crank 1 about (0, 0), coupler 3.5, rocker 2.5 about (4, 0.5); the coupler stands at 0.35 rad in the
# moving frame, in which the crank pin is (0.3, -0.2).
FORMULA_PARAMETERS = """\
  t{k}: 20 deg + {k}*step*1 rad
  d{k}: (4 - cos(t{k}))^2 + (0.5 - sin(t{k}))^2
  g{k}: atan2(0.5 - sin(t{k}), 4 - cos(t{k})) + acos((6 + d{k})/(7*sqrt(d{k}))) - 0.35 rad
"""
FORMULA_POSITION = """\
    - {{at: [cos(t{k}) - 0.3*cos(g{k}) - 0.2*sin(g{k}), sin(t{k}) - 0.3*sin(g{k}) + 0.2*cos(g{k})], angle: g{k}}}
"""
KNOWN = [((0.3, -0.2), (0.0, 0.0)),
         ((0.3 + 3.5 * math.cos(0.35), -0.2 + 3.5 * math.sin(0.35)), (4.0, 0.5))]


def typed(task: Task) -> str:
    lines = [f"    - {{at: [{x}, {y}], angle: {angle}}}" for x, y, angle in task.positions]
    return "kinestat: 1\nsynthesis:\n  positions:\n" + "\n".join(lines) + "\n"


def formulas(step: str) -> str:
    return ("kinestat: 1\nparameters:\n  step: " + step + "\n"
            + "".join(FORMULA_PARAMETERS.format(k=k) for k in range(5))
            + "synthesis:\n  positions:\n"
            + "".join(FORMULA_POSITION.format(k=k) for k in range(5)))


def error(dyad: dict, expected: tuple[Pair, Pair]) -> float:
    """Of both points, relative to their distance from the origin where that is above one."""
    found = (dyad["circle_point"], dyad["centre_point"])
    return max(math.dist(a, b) / max(1.0, math.hypot(*b)) for a, b in zip(found, expected))


class Digits(unittest.TestCase):
    def solved(self, text: str, *arguments: str) -> dict:
        synthesis = program.synthesize(*arguments, "-", text=text)["synthesis"]
        self.assertEqual(synthesis["tasks"][0]["status"], "solved")
        return synthesis

    def test_doubles_refuse_with_a_warning(self) -> None:
        texts = {name: typed(task) for name, task in TASKS.items()}
        for name, text in {**texts, "formulas": formulas("1e-6")}.items():
            with self.subTest(name):
                report = program.synthesize("-", text=text)
                task = report["synthesis"]["tasks"][0]
                self.assertEqual(task["status"], "no_digits")
                self.assertEqual(task["dyads"], [])
                codes = [one["code"] for one in report["diagnostics"]]
                self.assertEqual(codes, ["W0801", "E0802"])
                self.assertIn("--digits", report["diagnostics"][0]["hint"])

    def test_typed_digits_are_used(self) -> None:
        for name, task in TASKS.items():
            with self.subTest(name):
                synthesis = self.solved(typed(task), "--digits", "40")
                self.assertEqual(synthesis["working_digits"], 40)
                dyads = synthesis["tasks"][0]["dyads"]
                self.assertEqual(len(dyads), len(task.dyads))
                for expected in task.dyads:
                    self.assertLess(min(error(one, expected) for one in dyads), task.tolerance)

    def test_residuals_have_the_digits_of_the_arithmetic(self) -> None:
        dyads = self.solved(typed(TASKS["IC09"]), "--digits", "40")["tasks"][0]["dyads"]
        for dyad in dyads:
            self.assertLess(dyad["residual"], 1e-60)

    def test_estimated_digits_are_not_more_than_there_are(self) -> None:
        for name, task in TASKS.items():
            dyads = self.solved(typed(task), "--digits", "40")["tasks"][0]["dyads"]
            for expected in task.dyads:
                nearest = min(dyads, key=lambda one: error(one, expected))
                with self.subTest(f"{name} {expected}"):
                    true_digits = -math.log10(max(error(nearest, expected), 1e-16))
                    self.assertLess(nearest["digits"], true_digits + 2.0)

    def test_formulas_are_evaluated_with_all_digits(self) -> None:
        for step in ("1e-6", "1e-9", "1e-12"):
            with self.subTest(step):
                synthesis = self.solved(formulas(step), "--digits", "100")
                for expected in KNOWN:
                    dyads = synthesis["tasks"][0]["dyads"]
                    self.assertLess(min(error(one, expected) for one in dyads), 1e-14)

    def test_the_file_may_ask_for_them(self) -> None:
        text = formulas("1e-9").replace("synthesis:\n", "synthesis:\n  digits: 100\n")
        synthesis = self.solved(text)
        self.assertEqual(synthesis["working_digits"], 100)
        self.assertLess(min(error(one, KNOWN[0]) for one in synthesis["tasks"][0]["dyads"]), 1e-14)

    def test_a_task_that_doubles_can_solve_stays_the_same(self) -> None:
        text = formulas("0.5")
        doubles = self.solved(text)["tasks"][0]["dyads"]
        digits = self.solved(text, "--digits", "50")["tasks"][0]["dyads"]
        self.assertEqual(len(doubles), len(digits))
        for one, other in zip(doubles, digits):
            expected = (tuple(other["circle_point"]), tuple(other["centre_point"]))
            self.assertLess(error(one, expected), 1e-11)

    def test_a_far_origin_takes_no_digits(self) -> None:
        text = formulas("1e-9").replace("at: [cos", "at: [1e6 + cos").replace(", sin(t",
                                                                           ", -1e6 + sin(t")
        dyads = self.solved(text, "--digits", "100")["tasks"][0]["dyads"]
        for circle_point, (x, y) in KNOWN:
            expected = (circle_point, (x + 1e6, y - 1e6))
            nearest = min(dyads, key=lambda one: error(one, expected))
            self.assertLess(math.dist(nearest["circle_point"], circle_point), 1e-13)
            self.assertLess(math.dist(nearest["centre_point"], expected[1]), 1e-9)

    # An elliptic trammel: the midpoint of its two sliders turns about the crossing of their lines.
    def test_a_family_stays_a_family(self) -> None:
        angles = (10, 40, 75, 110, 160)
        text = "kinestat: 1\nsynthesis:\n  positions:\n" + "".join(
            f"    - {{at: [2*cos({a} deg), 0], angle: -{a} deg}}\n" for a in angles)
        task = program.synthesize("--digits", "40", "-", text=text)["synthesis"]["tasks"][0]
        self.assertEqual((task["status"], task["reason"]), ("family", "straight_paths"))
        self.assertLess(error(task["dyads"][0], ((-1.0, 0.0), (0.0, 0.0))), 1e-12)

    # PP-PP-P by poles, PPP-P-P by curvature and PPPPP by Burmester points: do Valle 1983, tables 2,
    # 3 and 5, with far more digits than they have.
    def test_poles_and_curvatures_are_read_with_all_digits(self) -> None:
        curvature = "pole: [3.75, 3.25], curvature: {centre: [3, 2.6], free_point: [0.75, 2], m: 0.58}"
        tasks = {
            "table 2": ["at: [0.424, 0.245], angle: 30 deg, pole: [0.6, 2.019]",
                        "at: [0.424, 0.245], angle: 55 deg, pole: [0.65, 0.05]",
                        "at: [0.49, 0], angle: 70 deg"],
            "table 3": [f"at: [0, 0], angle: 30 deg, {curvature}",
                        "at: [2.25, 1.2], angle: 52 deg", "at: [4, 1], angle: 65 deg"],
            "table 5": [f"at: [0, 0], angle: 0, {curvature}, stationary: true",
                        "at: [0, 0], angle: 27 deg"],
            "PPPPP": [f"at: [0, 0], angle: 0, {curvature}, stationary: true, burmester: true"],
        }
        for name, positions in tasks.items():
            text = "kinestat: 1\nsynthesis:\n  positions:\n" + "".join(
                f"    - {{{one}}}\n" for one in positions)
            with self.subTest(name):
                doubles = self.solved(text)["tasks"][0]["dyads"]
                digits = self.solved(text, "--digits", "60")["tasks"][0]["dyads"]
                self.assertEqual(len(doubles), len(digits))
                for one, other in zip(doubles, digits):
                    expected = (tuple(other["circle_point"]), tuple(other["centre_point"]))
                    self.assertLess(error(one, expected), 1e-11)
                    self.assertLess(other["residual"], 1e-60)


if __name__ == "__main__":
    program.use(sys.argv.pop(1))
    unittest.main()
