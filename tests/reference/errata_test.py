#!/usr/bin/env python3
"""Errata of the sources: the right value, and that it differs from the printed one.

Usage: errata_test.py PROGRAM MECHANISMS [unittest arguments]
"""

from __future__ import annotations

import math
import sys
import unittest
from pathlib import Path

import program
from reference_case import CASES, ReferenceCase, number
from reference_test_case import ReferenceTest

MECHANISMS = Path()


class FourBar(ReferenceTest):
    """Cazangi 2008, chapters 3 and 4."""

    def test_row_8_of_equation_3_89(self) -> None:
        """R_dy + (d_y - c_y)/q T_in - c_y/q T_out = 0, q = c_x d_y - c_y d_x; printed + c_y/q."""
        for name in ("fourbar_1", "fourbar_2"):
            model = ReferenceCase(CASES[name])
            c, d = ([number(x) for x in model.couplings[k]["point"]] for k in "cd")
            q = c[0] * d[1] - c[1] * d[0]
            text = model.text(model.actions("one", {"d.Tout": 1}))
            actions = program.run("analyze", "-", text=text)["cases"]["one"]["statics"]["actions"]
            left = actions["d.Ry"] + (d[1] - c[1]) / q * actions["a_Tin"]
            self.near(left - c[1] / q, 0.0, name)
            self.assertGreater(abs(left + c[1] / q), 0.1)

    def test_size_of_equations_3_79_and_4_23(self) -> None:
        """The expanded cut-set matrix is 3 x 10; printed 1 x 4."""
        text = ReferenceCase(CASES["fourbar_1"]).text()
        matrix = program.run("graph", "--matrices", "-", text=text)["graph"]["matrices"]["Q_A"]
        self.assertEqual((len(matrix["rows"]), len(matrix["columns"])), (3, 10))

    def test_redundancy_of_the_four_bar_in_space(self) -> None:
        """Three constraints too many; Alves 2023, section 2.2 says two."""
        text = ReferenceCase(CASES["fourbar3d_RRRR"]).text()
        counts = program.run("analyze", "-", text=text)["mobility"]["spatial"]
        self.assertEqual(counts["net_constraint"], 3)
        self.assertEqual(counts["gross_freedom"] - 6, -2)


class Ravigneaux(ReferenceTest):
    """Cazangi 2008, chapter 5 and annex D, by the file of the library."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.path = str(MECHANISMS / "transmissions" / "ravigneaux.yaml")
        cls.cases = program.run("analyze", cls.path)["cases"]

    def test_strict_row_reduction_makes_d_a_branch(self) -> None:
        """Eqs. 5.6 and 5.7 are called echelon forms with branch e and chord d."""
        text = Path(self.path).read_text(encoding="utf-8").replace("tree: [a, b, c, e, f, g]", "")
        graph = program.run("graph", "-", text=text)["graph"]
        self.assertEqual(graph["tree"], list("abcdfg"))
        self.assertEqual(graph["chords"], list("ehijk"))

    def test_ratio_d_15_is_inverted(self) -> None:
        """(w6 - w4)/(w3 - w4) = N3/N6jk = 85/22; printed N6jk/N3."""
        for gear in ("M1", "M2", "MR"):
            rates = self.cases[gear]["kinematics"]["freedoms"]
            self.near(rates["g.wz"] / -rates["c.wz"], 85 / 22, gear, 4.0)

    def test_speed_of_planet_5_is_negative(self) -> None:
        """Annex D: V_5x = -w4 (N1 + N5)/2 = -7.163; the formula lacks the sign."""
        bodies = self.cases["M2"]["kinematics"]["bodies"]
        carrier = bodies["carrier"]["angular"][2]
        self.near(bodies["planet5"]["linear"][0], -carrier * (19 + 15) / 2, "V_5x", 10.0)
        self.assertAlmostEqual(bodies["planet5"]["linear"][0], -7.163, places=3)

    def test_bearing_of_planet_5_bears_moments(self) -> None:
        """Eqs. D.49 and D.50 print T_fx = T_fy = 0: so only if 2 f_z = h_z + i_z."""
        tangent = math.tan(math.radians(20.0))
        for gear in ("M1", "M2"):
            for f_z, factor in ((40, 4 * 40 - 2 * 10 - 2 * 25), (17.5, 0)):
                report = program.run("analyze", "--set", f"f_z={f_z} m", self.path)
                moment = report["cases"][gear]["statics"]["couplings"]["f"]["moment"]
                self.near(moment[0], tangent * 100 * factor / 19, f"{gear} T_fx", 1000.0)
                self.near(moment[1], -100 * factor / 19, f"{gear} T_fy", 1000.0)

    def test_module_is_one_metre(self) -> None:
        """The source gives 1 without a unit; in mm its forces of 10.53 N are 10.53 kN."""
        report = program.run("analyze", "--set", "module=1 mm", self.path)
        self.near(report["cases"]["M1"]["statics"]["actions"]["a.Rx"], -200e3 / 19, "R_ax", 1e4)
        self.near(self.cases["M1"]["statics"]["actions"]["a.Rx"], -200 / 19, "R_ax", 10.0)


class Pulley(ReferenceTest):
    """Alves 2023, sections 3.4 and 4.1, by pulleys of radius 1 (annex I) and 3 (Fig. 3.31)."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.cases = {}
        for radius, name in ((1, "alves_davies_maxima_1_2_10"), (3, "alves_davies_matroid_3_6_10")):
            model = ReferenceCase(CASES[name])
            lines = [model.motion(f"moves {a} {e}", {"a.v": a, "e.w": e})
                     for a, e in ((1, 0), (0, 1), (1, 1))]
            lines += [model.actions(f"pulls {a} {e}", {"a.Va": a, "e.Te": e})
                      for a, e in ((1, 0), (0, 1))]
            report = program.run("analyze", "-", text=model.text("\n".join(lines)))
            cls.cases[radius] = report["cases"]

    def rates(self, radius: int) -> list[dict]:
        cases = self.cases[radius].values()
        return [one["kinematics"]["freedoms"] for one in cases if "kinematics" in one]

    def actions(self, radius: int) -> list[dict]:
        cases = self.cases[radius].values()
        return [one["statics"]["actions"] for one in cases if "statics" in one]

    def test_slip_of_the_rope(self) -> None:
        """w_f = -w_e - v_a/r. Eq. 4.1 prints w_a for v_a; Eq. 4.2 claims w_e = w_f."""
        for radius in (1, 3):
            for rates in self.rates(radius):
                self.near(rates["f.wz"], -rates["e.wz"] - rates["a.vy"] / radius, "w_f")
                self.assertGreater(abs(rates["f.wz"] - rates["e.wz"]), 0.1)

    def test_without_slip_the_rope_turns_the_pulley(self) -> None:
        """w_f = 0: v_a = -r w_e; Eqs. 4.3 and 4.4 print the other sign."""
        for radius, name in ((1, "alves_davies_maxima_1_2_10"), (3, "alves_davies_matroid_3_6_10")):
            model = ReferenceCase(CASES[name])
            text = model.text(model.motion("no slip", {"e.w": 1, "f.w": 0}))
            result = program.run("analyze", "-", text=text)["cases"]["no slip"]["kinematics"]
            self.near(result["freedoms"]["a.vy"], -radius, "v_a")
            # The centre of a fixed pulley stands still; section 4.1 gives it half the speed.
            self.near_all(result["bodies"]["body_2"]["linear"], [0.0, 0.0, 0.0])

    def test_hanging_ropes_stay_upright(self) -> None:
        """w_c1 = w_d1 = 0 always: therefore no input set has v_a with w_c1, not for its place."""
        for radius in (1, 3):
            for rates in self.rates(radius):
                self.assertEqual((rates["c1.wz"], rates["d1.wz"]), (0.0, 0.0))
                self.near(rates["c2.wz"], -rates["a.vy"] / radius, "w_c2")
                self.near(rates["d2.wz"], -rates["a.vy"] / radius, "w_d2")

    def test_forces_depend_on_the_radius(self) -> None:
        """V_b = V_a - T_e/r, V_e = -2 V_a + T_e/r, T_f = T_e with slip or without.

        Eqs. 3.31 and 4.6 hold for r = 1 alone, Eq. 4.9 has two wrong signs.
        """
        for radius in (1, 3):
            for actions in self.actions(radius):
                force, torque = actions["a_Va"], actions["e_Te"]
                self.near(actions["b_Vb"], force - torque / radius, "V_b")
                self.near(actions["e.Ry"], -2 * force + torque / radius, "V_e")
                self.near(actions["f_Tf"], torque, "T_f")

    def test_classes_of_pairs(self) -> None:
        """A cable is of class I, a virtual link's revolute of class V; printed the other way."""
        text = ReferenceCase(CASES["alves_eq3.2"]).text()
        couplings = program.run("analyze", "-", text=text)["graph"]["couplings"]
        borne = {c["type"]: (len(c["freedoms"]), len(c["constraints"])) for c in couplings}
        self.assertEqual(borne["cable"], (5, 1))
        self.assertEqual(borne["revolute"], (1, 5))


if __name__ == "__main__":
    program.use(sys.argv[1])
    MECHANISMS = Path(sys.argv[2])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
