#!/usr/bin/env python3
"""Tables load in Python, SQLite, Miller and Octave, as far as these are installed.

Long and wide tables contain the same numbers; names of columns and units are those of the help.
"""

from __future__ import annotations

import argparse
import csv
import functools
import importlib.util
import io
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path("kinestat")
FILES = {"motion": "planar/watt_six_bar.yaml", "analyze": "planar/four_bar.yaml",
         "shift": "transmissions/ravigneaux_input_shaft.yaml"}


def table(command: str, layout: str) -> str:
    return subprocess.run(
        [PROGRAM, command, "--format", "csv", "--layout", layout,
         ROOT / "mechanisms" / FILES[command]],
        capture_output=True, encoding="utf-8", check=True, timeout=120).stdout


def rows(command: str, layout: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(table(command, layout)), strict=True))


def run(words: list[str | Path], text: str) -> str:
    return subprocess.run(words, input=text, capture_output=True, encoding="utf-8", check=True,
                          timeout=120).stdout


@functools.cache
def units_of_tables() -> set[str]:
    """Those of lengths in mm, of screws, of speeds in rpm, and of derivatives of all."""
    units = set()
    for file in (*FILES.values(), "planar/rack_and_pinion.yaml", "spatial/screw_jack.yaml",
                 "planar/toggle_press.yaml", "sweeps/four_bar_height.yaml"):
        for command in ("analyze", "sensitivity"):
            told = subprocess.run(
                [PROGRAM, command, "--format", "csv", ROOT / "mechanisms" / file],
                capture_output=True, encoding="utf-8", check=False, timeout=120).stdout
            units.update(row["unit"] for row in csv.DictReader(io.StringIO(told)) if row["unit"])
    assert len(units) > 10, units
    return units


class Tables(unittest.TestCase):
    def test_of_both_layouts_hold_the_same_numbers(self) -> None:
        for command in FILES:
            wide = rows(command, "wide")
            passes = {row["pass"] for row in rows(command, "long")}
            count = 0
            for row in rows(command, "long"):
                is_of_motion = "step" in row
                if (not row["step"] or row["quantity"].startswith("event/")) if is_of_motion \
                        else not row["case"]:
                    continue
                (there,) = [one for one in wide if one["case"] == row["case"]
                            and (not is_of_motion or one["step"] == row["step"])]
                name = "/".join(filter(None, (row["element"], row["quantity"])))
                unit = f" [{row['unit']}]" if row["unit"] else ""
                found = [there[one] for one in (f"{name}{unit}", f"{row['pass']}/{name}{unit}")
                         if one in there]
                self.assertEqual(found, [row["value"]], (command, passes, name))
                count += 1
            self.assertGreater(count, 20)
            self.assertLessEqual(sum(value != "" for row in wide for value in row.values()),
                                 count + 4 * len(wide))

    def test_have_units_that_calculate(self) -> None:
        """Names, whole powers, products and one quotient."""
        unit = re.compile(r"(1|NAME(\*NAME)*)(/(NAME|\(NAME(\*NAME)+\)))?"
                          .replace("NAME", r"[A-Za-z]+(\^\d+)?"))
        for one in units_of_tables():
            self.assertRegex(one, rf"^{unit.pattern}$")

    @unittest.skipUnless(importlib.util.find_spec("pint"), "without pint")
    def test_have_units_that_pint_reads(self) -> None:
        import pint
        registry = pint.UnitRegistry()
        for one in units_of_tables():
            registry.parse_units(one)
        newton_second_per_metre = registry.Quantity(1.0, "N*s/mm").to("N*s/m").magnitude
        self.assertAlmostEqual(newton_second_per_metre, 1000.0, delta=1e-9)

    @unittest.skipUnless(importlib.util.find_spec("astropy"), "without astropy")
    def test_have_units_that_astropy_reads(self) -> None:
        """It has no rpm, which others define for it."""
        from astropy import units
        rpm = units.def_unit("rpm", units.cycle / units.min)
        with units.add_enabled_units([rpm]):
            for one in units_of_tables():
                units.Unit(one)

    def test_load_into_sqlite(self) -> None:
        connection = sqlite3.connect(":memory:")
        header, *body = csv.reader(io.StringIO(table("motion", "wide")))
        names = ", ".join(f'"{name}"' for name in header)
        connection.execute(f"create table motion ({names})")
        marks = ", ".join("?" * len(header))
        connection.executemany(f"insert into motion values ({marks})", body)
        (swing,) = connection.execute(
            'select max(cast("d.wz/position [rad]" as real)) - '
            'min(cast("d.wz/position [rad]" as real)) from motion').fetchone()
        values = [float(row["value"]) for row in rows("motion", "long")
                  if (row["element"], row["quantity"]) == ("d.wz", "position")]
        self.assertAlmostEqual(swing, max(values) - min(values), delta=1e-12)

    @unittest.skipUnless(shutil.which("sqlite3"), "without sqlite3")
    def test_load_into_the_shell_of_sqlite(self) -> None:
        for layout in ("long", "wide"):
            with tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / "motion.csv"
                path.write_text(table("motion", layout), encoding="utf-8")
                told = run(["sqlite3", "-csv", ":memory:"],
                           f".import '{path}' motion\nselect count(*) from motion;\n")
                self.assertEqual(int(told), len(rows("motion", layout)))

    @unittest.skipUnless(shutil.which("mlr"), "without Miller")
    def test_load_into_miller(self) -> None:
        told = run(["mlr", "--icsv", "--ojson", "stats1", "-a", "max", "-f",
                    "d.wz/position [rad]"], table("motion", "wide"))
        values = [float(row["d.wz/position [rad]"]) for row in rows("motion", "wide")]
        self.assertIn(str(max(values)), told)

    @unittest.skipUnless(shutil.which("octave-cli"), "without Octave")
    def test_load_into_octave(self) -> None:
        wide = rows("motion", "wide")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "motion.csv"
            path.write_text(table("motion", "wide"), encoding="utf-8")
            column = list(wide[0]).index("d.wz/position [rad]")
            told = run(["octave-cli", "--quiet"],
                       f"a = dlmread('{path}', ',', 1, 0); printf('%.12g', max(a(:, {column + 1})))")
        self.assertAlmostEqual(float(told), max(float(row["d.wz/position [rad]"]) for row in wide),
                               delta=1e-9)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    known, others = parser.parse_known_args()
    PROGRAM = known.program.resolve()
    unittest.main(argv=[sys.argv[0], *others])
