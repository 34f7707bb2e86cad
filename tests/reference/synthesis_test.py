#!/usr/bin/env python3
"""Checks the tasks of mechanisms/synthesis against numbers that this program did not compute.

Usage: synthesis_test.py PROGRAM MECHANISMS   Known linkages are found again; the dyads of the tables
of do Valle 1983 were computed in arithmetic of 60 digits by an elimination of its own, from the
numbers of the table; curves and trammel have closed forms.
"""

from __future__ import annotations

import cmath
import math
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Iterator

import yaml

import program

TASKS = Path("mechanisms/synthesis")

# A crank: circle point in the moving frame, centre, length.
CRANKS = {
    "do_valle_table_1": [
        ((-1.180312639852056, 0.5292279253865899), (-0.8975667077110346, 0.4024504614959666), 0.30986737081021204),
        ((0.10067334090070472, 1.115955219159956), (0.13511445034074457, 1.4977319188244713), 0.3833270645626139),
        ((0.4932030611384807, -0.2508848025091888), (0.959224154990788, -0.48794255682719034), 0.5228499199556168),
        ((0.8232372128693012, 0.31519945665675775), (1.0890912429164208, 0.41698912858958526), 0.2846743799580275)],
    "do_valle_table_2": [
        ((-0.738173619540675, -0.3152536509992703), (-0.3446693960058629, -1.451567905819637), 1.0928280231416825),
        ((0.15577059189153603, 0.3000426147544221), (0.3838101367229757, 0.3943295069063433), 0.19006097992927115)],
    "do_valle_table_3": [
        ((2.3865483572743615, 2.059431602106604), (2.2913421167200583, 3.103104401077805), 1.2605904630106806),
        ((6.3742347960248935, 0.7491491147535277), (7.686861127183012, 4.902681103349258), 2.756020915115359)],
    "do_valle_table_3_as_printed": [
        ((3.168166817206142, 1.4161672140125763), (3.43286080820276, 3.168701203654673), 1.4424109721390872),
        ((5.651681275268674, 0.9197953734100774), (6.217655664953442, 4.592344771312673), 2.029793216767103)],
    "do_valle_table_4": [
        ((4.88782328437884351, 0.948018322586196227), (4.21706657650893909, 4.02686340458092048), 0.889050544793842951),
        ((3.71878937101869614, 2.89874077143940949), (2.49477906045975882, 3.96031206547388673), 0.831405509714178002)],
    "do_valle_table_4_as_printed": [
        ((1.68631796543742217, -2.80906677451153007), (3.43450680856747781, 1.52488742291491835), 3.16610635245696691),
        ((2.02357159745783549, -1.60923590334273641), (3.2683005201027446, 1.78345962462281199), 2.27912519451670345),
        ((5.6506202820726963, 1.71078212646414614), (4.24181745911498896, 5.05366439786424579), 0.774038053524061551),
        ((3.49938026090064092, 1.10141733170105032), (3.27267422953851186, 3.04464198823614238), 0.86309171402820041)],
    "do_valle_table_5": [
        ((0.0, 0.0), (3.0, 2.6), 3.9698866482558417),
        ((3.0631067464134327, 1.7561847146876113), (3.9831928267071373, 3.7571341247587653), 2.2023525913927435)],
    "do_valle_case_1": [
        ((0.75, 2.0), (2.49, 2.725), 1.885),
        ((0.24516837298653107, 0.6276963426869133), (2.852895527554656, 2.578789342987656), 3.256839696468729),
        ((0.0, 0.0), (3.0, 2.6), 3.9698866482558417),
        ((4.130310963721605, 0.9756129179938484), (7.7378227412073475, -20.5985171165658), 21.873665170080372)],
    "do_valle_case_1_as_printed": [
        ((29.23557777784635, 37.33781347707786), (3.4995654301005907, 2.9150353787794456), 42.97987882216532),
        ((3.0253497763415584, 1.310477606584551), (4.122857343922377, 4.247950658782538), 3.135804648457318)],
    "crank_rocker": [
        ((0.3, -0.2), (0.0, 0.0), 1.0),
        ((3.58780449496582622, 1.00014232609407972), (4.0, 0.5), 2.5),
        ((8.57070468997717545, -0.0536892038881293963), (7.14614820887769854, 3.5200675555395416), 1.30531901759750116),
        ((0.73166476788204767, 11.3270558932985463), (12.0664321758596712, -8.88784631521984192), 25.363357902923191)],
    "coincident_positions": [
        ((0.3, -0.2), (0.0, 0.0), 1.0),
        ((3.58780449496582622, 1.00014232609407972), (4.0, 0.5), 2.5),
        ((6.6803383647945409, -1.8725105574430261), (6.53599714586550153, 1.66409535211919655), 0.851396825301698833),
        ((1.11120753995274919, 18.7887524713577162), (6.71607626610382879, -3.11760433921601398), 24.8508241920975515)],
    "near_positions": [
        ((0.3, -0.2), (0.0, 0.0), 1.0),
        ((3.58780449496582622, 1.00014232609407972), (4.0, 0.5), 2.5),
        ((6.69989642700204359, -1.8825930687512604), (6.54890301358283605, 1.6636106500688325), 0.860486089996337074),
        ((1.05702355186190802, 18.9590287323133605), (6.73476717331772472, -3.12851382622951099), 25.0455055154361779)],
    "slider_crank": [
        ((0.3, -0.2), (0.0, 0.0), 1.0),
        ((2.68019120555852463, 0.549499506723026283), (-2.25924585560105264, 46.9195114951857387), 46.4731897431154294),
        ((5.38370573414764157, 1.40081044378726098), (5.08633606004709704, 1.42592444044284138), 1.10296272389005193)],
    "oscillating_slider": [
        ((-2.0, -1.0), (0.0, 0.0), 1.0),
        ((3.4259467989631323, -1.62111444405789731), (5.4649362112447363, -0.550683393002228164), 0.947143943140506569),
        ((0.982668562576016435, -25.8680045407129459), (3.00410122651365002, -0.302713260025754957), 24.5844230740829542)],
    "instantaneous_translation": [
        ((0.1, 0.2), (0.0, 0.0), 1.0),
        ((3.588606136625849, 1.09078739330954122), (3.0, 0.4), 2.0),
        ((9.84226630097967066, -8.26548074809508222), (11.3636964963980504, -5.47655609627009753), 0.746429442268130016),
        ((-2.66354328142004308, -18.3314056373463969), (2.4829719844543003, -11.0477012396286673), 7.17926166271558833)],
    "elliptic_trammel": [((-1.0, 0.0), (0.0, 0.0), 1.0)],
    "parallelogram": [],
}
IMAGINARY = {"do_valle_table_2": 2, "do_valle_table_3": 2, "do_valle_table_3_as_printed": 2,
             "do_valle_table_4": 2, "do_valle_table_5": 2, "do_valle_case_1_as_printed": 2}
# Relative to the size of the dyad. Rounding of near positions leaves no more.
TOLERANCE = {"near_positions": 1e-3}
ALL_DIGITS = 1e-11

# What is usable, and what is not: pairs of the cranks above, with the lengths of ground, crank,
# coupler and crank of those that the same reference gives.
FOUR_BARS = {
    "do_valle_table_1": {(0, 1): None, (0, 2): None, (0, 3): "branch", (1, 2): "branch",
                         (1, 3): "branch", (2, 3): "branch"},
    "do_valle_table_2": {(0, 1): "circuit"},
    "do_valle_table_3": {(0, 1): "circuit"},
    "do_valle_table_3_as_printed": {(0, 1): None},
    "do_valle_table_5": {(0, 1): "circuit"},
    "crank_rocker": {(0, 1): None, (0, 2): "branch", (0, 3): "transmission_angle",
                     (1, 2): "transmission_angle", (1, 3): "branch",
                     (2, 3): "transmission_angle"},
}


def path_of(name: str) -> str:
    return str(TASKS / f"{name}.yaml")


def task_of(name: str) -> dict:
    tasks = program.synthesize(path_of(name))["synthesis"]["tasks"]
    assert len(tasks) == 1
    return tasks[0]


def point(pair: list) -> complex:
    return complex(*pair)


class Tasks(unittest.TestCase):
    def assertNear(self, found: complex, expected: complex, limit: float, what: object = "") -> None:
        self.assertLessEqual(abs(found - expected), limit, (what, found, expected))

    def index_of(self, crank: tuple, dyads: list, tolerance: float) -> int:
        """The dyad that is this crank."""
        circle, centre, length = point(crank[0]), point(crank[1]), crank[2]
        limit = tolerance * max(abs(circle), abs(centre), length)
        near = [i for i, dyad in enumerate(dyads) if dyad["type"] == "crank"
                and abs(point(dyad["circle_point"]) - circle) <= limit
                and abs(point(dyad["centre_point"]) - centre) <= limit
                and abs(dyad["length"] - length) <= limit]
        self.assertEqual(len(near), 1, (crank, dyads))
        return near[0]

    def test_find_all_known_cranks_and_no_others(self) -> None:
        for name, cranks in CRANKS.items():
            with self.subTest(name):
                task = task_of(name)
                found = [self.index_of(crank, task["dyads"], TOLERANCE.get(name, ALL_DIGITS))
                         for crank in cranks]
                self.assertEqual(len(set(found)), len(cranks))
                others = [dyad["type"] for dyad in task["dyads"] if dyad["type"] != "crank"]
                self.assertEqual(len(task["dyads"]), len(cranks) + len(others))
                self.assertEqual(task["imaginary_dyads"], IMAGINARY.get(name, 0))

    def test_find_the_known_slider(self) -> None:
        sliders = [one for one in task_of("slider_crank")["dyads"] if one["type"] == "slider"]

        self.assertEqual(len(sliders), 1)
        slider = sliders[0]
        self.assertNear(point(slider["circle_point"]), 2.7 + 0.4j, 1e-11)
        self.assertNear(point(slider["direction"]).real, math.cos(0.1), 1e-11)
        self.assertNear(point(slider["direction"]).imag, math.sin(0.1), 1e-11)
        # Its first place is on the line through (0, 0.3) at 0.1 rad.
        place = point(slider["centre_point"]) - 0.3j
        self.assertNear((place / cmath.rect(1, 0.1)).imag, 0.0, 1e-11)

    def test_find_the_known_inverted_slider(self) -> None:
        found = [one for one in task_of("oscillating_slider")["dyads"]
                 if one["type"] == "inverted_slider"]

        self.assertEqual(len(found), 1)
        self.assertNear(point(found[0]["centre_point"]), 3.0, 1e-11)
        self.assertNear(point(found[0]["circle_point"]), -1j, 1e-11)
        self.assertNear(abs(point(found[0]["direction"]).real), 1.0, 1e-11)
        self.assertNear(point(found[0]["direction"]).imag, 0.0, 1e-11)

    def test_judge_the_four_bars_as_the_reference_does(self) -> None:
        for name, verdicts in FOUR_BARS.items():
            with self.subTest(name):
                task = task_of(name)
                index = [self.index_of(crank, task["dyads"], ALL_DIGITS) for crank in CRANKS[name]]
                found = {tuple(sorted(one["dyads"])): one["defect"] for one in task["linkages"]}
                self.assertEqual(found, {tuple(sorted((index[i], index[j]))): defect
                                         for (i, j), defect in verdicts.items()})

    def test_find_the_known_linkages_as_the_best(self) -> None:
        best = task_of("crank_rocker")["linkages"][0]
        lengths = [best["lengths"][key] for key in ("ground", "coupler")]
        cranks = sorted(best["lengths"][key] for key in ("crank_one", "crank_other"))
        for found, expected in zip(lengths + cranks, [math.sqrt(16.25), 3.5, 1.0, 2.5]):
            self.assertNear(found, expected, 1e-11)
        self.assertEqual(best["grashof"]["class"], "crank_rocker")
        # At crank angles of 20 deg and, in line with the ground, of 7.125 + 180 deg.
        self.assertNear(math.degrees(best["margin"]), 58.631093345885844, 1e-9)
        slider = task_of("slider_crank")["linkages"][0]
        self.assertEqual((slider["type"], slider["defect"]), ("slider_crank", None))
        inverted = task_of("oscillating_slider")["linkages"][0]
        self.assertEqual((inverted["type"], inverted["defect"]), ("inverted_slider_crank", None))
        # A line through A is turned best everywhere.
        self.assertNear(inverted["margin"], math.pi / 2, 1e-9)

    def test_tell_families_and_positions_that_are_too_near(self) -> None:
        trammel = task_of("elliptic_trammel")
        self.assertEqual((trammel["status"], trammel["reason"]), ("family", "straight_paths"))
        parallelogram = task_of("parallelogram")
        self.assertEqual((parallelogram["status"], parallelogram["reason"]),
                         ("family", "parallelogram"))
        refused = task_of("too_near_positions")
        self.assertEqual((refused["status"], refused["dyads"], refused["linkages"]),
                         ("no_digits", [], []))

    def test_estimate_the_digits_of_near_positions(self) -> None:
        known = CRANKS["near_positions"]
        task = task_of("near_positions")
        for crank in known:
            dyad = task["dyads"][self.index_of(crank, task["dyads"], 1e-3)]
            size = max(abs(point(crank[0])), abs(point(crank[1])), crank[2])
            error = abs(point(dyad["centre_point"]) - point(crank[1])) / size
            self.assertLessEqual(error, 10.0 ** -dyad["digits"], dyad)
            self.assertLess(dyad["digits"], 6.0)
        for dyad in task_of("coincident_positions")["dyads"]:
            self.assertGreater(dyad["digits"], 12.0)

    def test_give_the_instant_of_table_5(self) -> None:
        for name in ("stationary_curvature", "do_valle_table_5", "do_valle_case_1"):
            with self.subTest(name):
                position = task_of(name)["positions"][0]
                self.assertNear(point(position["pole"]), 3.75 + 3.25j, 1e-14)
                frame = position["special_frame"]
                self.assertNear(frame["diameter"], 3.945141004294418, 1e-13)
                self.assertNear(math.radians(frame["angle"]), -2.107614068818801, 1e-13)
                self.assertNear(1 / frame["inverse_m"], 30.067141391776246, 1e-11)
                self.assertNear(1 / frame["inverse_n"], 3.4282508134720073, 1e-11)
                a_3 = point(frame["derivatives"][3])
                self.assertNear(a_3, -10.282484806257916 + 13.619893984363163j, 1e-11)
                self.assertNear(point(frame["ball_point"]),
                                4.010597772544078 + 0.8872587592577862j, 1e-12)
                centre = point(frame["inflection_circle"]["centre"])
                self.assertNear(centre, 5.4451096211153684 + 2.2412196679438057j, 1e-12)
                # K is 1/|E O_E|, and its derivative is zero where it is stationary.
                k, k_prime = position["path_curvature"][:2]
                self.assertNear(abs(k), 1 / abs(3.0 + 2.6j), 1e-13)
                self.assertNear(k_prime, 0.0, 1e-12)
        a_4 = point(task_of("do_valle_case_1")["positions"][0]["special_frame"]["derivatives"][4])
        self.assertNear(a_4, -49.815674395919935 + 66.82753009375611j, 1e-10)

    def test_draw_the_cubic_of_stationary_curvature(self) -> None:
        curves = task_of("stationary_curvature")["curves"]
        self.assertNear(point(curves["circle_points"]["focus"]),
                        3.0504373944221093 + 1.6972186830883185j, 1e-12)
        self.assertNear(point(curves["centre_points"]["focus"]),
                        2.4832967148674814 + 2.733293912289172j, 1e-12)
        # Ball's point is the only slider; E and F lie on the curve: 1/r = 1/(M sin) + 1/(N cos).
        self.assertNear(point(curves["slider"]["circle_point"]),
                        4.010597772544078 + 0.8872587592577862j, 1e-12)
        inverse_m, inverse_n = 1 / 30.067141391776246, 1 / 3.4282508134720073
        count = 0
        for branch in curves["circle_points"]["branches"]:
            for place in branch["points"]:
                z = (point(place) - (3.75 + 3.25j)) * cmath.rect(1, 2.107614068818801)
                sine, cosine = z.imag, z.real
                miss = (abs(z) ** 2 * (inverse_m * cosine + inverse_n * sine) - sine * cosine)
                self.assertNear(miss / max(abs(z) ** 3, 1e-3), 0.0, 1e-9, place)
                count += 1
        self.assertGreater(count, 40)


def distance(place: complex, first: complex, second: complex) -> float:
    """From a point to a segment."""
    way = second - first
    share = ((place - first) * way.conjugate()).real / abs(way) ** 2 if way else 0.0
    return abs(place - first - min(max(share, 0.0), 1.0) * way)


class CouplerCurves(unittest.TestCase):
    def test_pass_the_positions_that_lie_on_one_circuit(self) -> None:
        passed = 0
        for name in ("crank_rocker", "slider_crank", "oscillating_slider", "do_valle_table_1"):
            text = Path(path_of(name)).read_text(encoding="utf-8") + "  curves: {count: 2000}\n"
            answer = program.synthesize("-", text=text)["synthesis"]["tasks"][0]
            for linkage in answer["linkages"]:
                curve = linkage["coupler_curve"]
                places = [point(one) for one in curve["points"]]
                # Rounding may leave a dead point out of reach.
                self.assertIn(len(places), range(1996, 2001))
                ends = places[1:] + (places[:1] if curve["closed"] else [])
                size = max(abs(place - places[0]) for place in places)
                for i, position in enumerate(answer["positions"]):
                    drive = linkage["drives"][linkage["dyads"].index(linkage["drive"])]
                    near = min(distance(point(position["at"]), one, other)
                               for one, other in zip(places, ends))
                    if drive["circuits"][i] == drive["circuits"][0]:
                        self.assertLess(near, 1e-4 * size, (name, linkage["dyads"], i))
                        passed += 1
        self.assertGreater(passed, 50)


# A slider on the x axis whose rod slides through a guide at (0, 1): Nicomedes' conchoid.
CONCHOID = """kinestat: 1
name: Conchoid
units: {length: mm}
synthesis:
  linkage: any
  positions:
%s
""" % "\n".join(
    f"    - {{at: [{place.real!r}, {place.imag!r}], angle: {turn!r}}}"
    for turn in (2.6, 2.2, 1.7, 1.2, 0.7)
    for place in [-1 / math.tan(turn) + cmath.rect(1, turn) * (0.5 + 0.25j)])


def pole_of(twist: dict) -> complex:
    """About which a body turns, from its angular velocity and the velocity of a point of it."""
    speed = complex(*twist["linear"][:2])
    return complex(*twist["at"][:2]) + 1j * speed / twist["angular"][2]


class Link:
    """A link that leads the coupler, from the couplings of a file and the pose it is drawn in."""

    def __init__(self, outer: dict, inner: dict, pose: tuple[complex, float]) -> None:
        self.centre, place = point(outer["at"]), point(inner["at"])
        self.moving = (place - pose[0]) / cmath.rect(1, pose[1])
        self.kind = ("slider" if outer["type"] == "prismatic" else
                     "guide" if inner["type"] == "prismatic" else "crank")
        self.axis = point(outer["axis"]) if self.kind == "slider" else 1.0
        if self.kind == "guide":
            self.axis = point(inner["axis"]) / cmath.rect(1, pose[1])
        self.length = abs(place - self.centre)

    def miss(self, pose: tuple[complex, float]) -> float:
        """How far the coupler would have to leave the link to stand there."""
        turn = cmath.rect(1, pose[1])
        arm = pose[0] + turn * self.moving - self.centre
        if self.kind == "crank":
            return abs(arm) - self.length
        return (arm / (self.axis * (turn if self.kind == "guide" else 1.0))).imag

    def normal(self, pose: tuple[complex, float]) -> complex:
        """Across the path of the coupler: the line from the centre to this place has the pole."""
        turn = cmath.rect(1, pose[1])
        if self.kind == "crank":
            return pose[0] + turn * self.moving - self.centre
        return 1j * self.axis * (turn if self.kind == "guide" else 1.0)

    def place(self, pose: tuple[complex, float]) -> complex:
        if self.kind == "guide":
            return self.centre
        return pose[0] + cmath.rect(1, pose[1]) * self.moving


class WrittenMechanisms(unittest.TestCase):
    """Linkages as mechanism files, read by other means and analysed."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def written(self, path: str, *options: str) -> Iterator[tuple[dict, dict, Path]]:
        """Task, linkage and file of everything that is written."""
        report = program.synthesize("--write-mechanism", str(self.folder), *options, path)
        unit = math.radians(1) if report["mechanism"]["units"]["angle"] == "deg" else 1.0
        for task in report["synthesis"]["tasks"]:
            task["poses"] = [(point(one["at"]), one["angle"] * unit) for one in task["positions"]]
            for linkage in task["linkages"]:
                is_usable = linkage["defect"] is None
                self.assertEqual(linkage["file"] is not None, is_usable or bool(options))
                if linkage["file"]:
                    yield task, linkage, Path(linkage["file"])

    def check(self, task: dict, linkage: dict, path: Path) -> None:
        done = program.call("analyze", "--strict", str(path))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        report = program.report(done)
        self.assertEqual(report["diagnostics"], [])
        counts = report["mobility"]["planar"]
        self.assertEqual((counts["net_freedom"], counts["net_constraint"]), (1, 0))
        file = yaml.safe_load(path.read_text(encoding="utf-8"))
        couplings, first = file["couplings"], task["poses"][0]
        # The coupler is drawn where the task says.
        drawn = point(file["bodies"]["coupler"]["reference"])
        size = max(abs(drawn), *(abs(point(one["at"])) for one in couplings.values()))
        self.assertLessEqual(abs(drawn - first[0]), 1e-13 * size)
        links = [Link(couplings["A0"], couplings["A"], first),
                 Link(couplings["B0"], couplings["B"], first)]
        for pose, position in zip(task["poses"], task["positions"]):
            for link in links:
                self.assertLessEqual(abs(link.miss(pose)), 1e-10 * size, (path.name, pose))
                if position["pole"]:
                    # A link that stands in the pole has no direction of its own.
                    arm = point(position["pole"]) - link.place(pose)
                    across = (arm * link.normal(pose).conjugate()).imag
                    self.assertLessEqual(abs(across), 1e-9 * size * abs(link.normal(pose)))
        case = report["cases"]["first position"]
        self.assertEqual(case["kinematics"]["status"], "solved")
        if task["positions"][0]["pole"]:
            pole = point(task["positions"][0]["pole"])
            found = pole_of(case["kinematics"]["bodies"]["coupler"])
            self.assertLessEqual(abs(found - pole), 1e-9 * max(size, abs(pole)))
        drive = linkage["drives"][linkage["dyads"].index(linkage["drive"])]
        freedoms = case["kinematics"]["freedoms"]
        speed = freedoms["A0.v" if links[0].kind == "slider" else "A0.wz"]
        self.assertEqual(speed, -1.0 if drive["passage"] == "decreasing" else 1.0)

    def test_meet_every_position_and_pole_of_their_task(self) -> None:
        types = []
        for name in sorted(CRANKS.keys() - {"near_positions"}):
            for task, linkage, path in self.written(path_of(name)):
                with self.subTest(path.name):
                    self.check(task, linkage, path)
                    types.append(linkage["type"])
        for kind, least in (("four_bar", 20), ("slider_crank", 2), ("inverted_slider_crank", 2)):
            self.assertGreaterEqual(types.count(kind), least, kind)

    def test_hold_sliders_and_guides_in_one_linkage(self) -> None:
        text = self.folder / "conchoid.yaml"
        text.write_text(CONCHOID, encoding="utf-8")
        types = []
        for task, linkage, path in self.written(str(text), "--all-linkages"):
            with self.subTest(path.name):
                self.check(task, linkage, path)
                types.append(linkage["type"])
        self.assertIn("slider_inverted_slider", types)

    def test_are_taken_by_the_other_commands(self) -> None:
        *_, path = next(self.written(path_of("slider_crank")))
        for command in ("mobility", "inputs", "graph"):
            done = program.call(command, str(path))
            self.assertEqual((done.returncode, done.stderr), (0, ""), command)


if __name__ == "__main__":
    program.use(sys.argv[1])
    TASKS = Path(sys.argv[2]) / "synthesis"
    unittest.main(argv=sys.argv[:1])
