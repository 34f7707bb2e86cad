#!/usr/bin/env python3
"""Graphviz and gnuplot draw the output of `plot --emit` without a warning.

A program that is not installed is skipped, with a note.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MECHANISMS = ROOT / "mechanisms"
PROGRAM = Path("kinestat")
SKIPPED = 77  # SKIP_RETURN_CODE of the test
SVG = "{http://www.w3.org/2000/svg}"

# Planar and spatial, trains, cables, gears in cases, many charts in one figure.
FILES = ["planar/four_bar.yaml", "planar/slider_crank.yaml", "spatial/rssr.yaml",
         "spatial/ups_platform.yaml", "cables/block_and_tackle.yaml",
         "transmissions/ravigneaux.yaml", "transmissions/zf_8hp70.yaml",
         "sweeps/four_bar_height.yaml"]
GRAPHS = ["coupling-graph", "motion-graph", "action-graph", "power-flow"]
CHARTS = ["speeds", "torques", "forces", "motion-curves", "paths", "sweep-curves"]


def emitted(form: str, picture: str, file: Path) -> str | None:
    """None where the file has no such picture."""
    done = subprocess.run([PROGRAM, "plot", picture, "--emit", form, file],
                          capture_output=True, encoding="utf-8", check=False, timeout=120)
    if done.returncode == 0:
        return done.stdout
    if not re.search(r"error\[(E0909|E0303)\]", done.stderr):  # no picture, or no section for it
        raise AssertionError(f"plot {picture} {file}: {done.returncode}\n{done.stderr}")
    return None


def run(program: list[str], text: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(program, input=text, capture_output=True, encoding="utf-8",
                          check=False, timeout=120)


def hostile(folder: Path) -> Path:
    """A mechanism whose name means something to both programs."""
    source = (MECHANISMS / "planar/four_bar.yaml").read_text("utf-8")
    title = '"%s"' % r"""x\"]; node; 'y' `z` \\ $w {v} @u <b> # t"""
    path = folder / "hostile.yaml"
    path.write_text(re.sub(r"(?m)^name:.*$", lambda _: f"name: {title}", source), "utf-8")
    return path


class OtherProgramsTest(unittest.TestCase):
    @unittest.skipUnless(shutil.which("dot"), "Graphviz is not installed")
    def test_graphviz_draws_every_graph(self) -> None:
        drawn = 0
        for name in FILES:
            for picture in GRAPHS:
                text = emitted("dot", picture, MECHANISMS / name)
                if text is None:
                    continue
                with self.subTest(name, picture=picture):
                    done = run(["dot", "-Tsvg"], text)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    groups = ElementTree.fromstring(done.stdout).iter(f"{SVG}g")
                    edges = sum(one.get("class") == "edge" for one in groups)
                    self.assertEqual(edges, len(re.findall(r"(?m)^  \w+ -> \w+ \[", text)))
                    drawn += 1
        self.assertGreater(drawn, 3 * len(FILES))

    @unittest.skipUnless(shutil.which("gnuplot"), "gnuplot is not installed")
    def test_gnuplot_draws_every_chart(self) -> None:
        drawn = 0
        for name in FILES:
            for picture in CHARTS:
                text = emitted("gnuplot", picture, MECHANISMS / name)
                if text is None:
                    continue
                with self.subTest(name, picture=picture):
                    # The script says how large a picture must be for its charts to be read.
                    size = re.search(r"(?m)^# .* size (\d+),(\d+)$", text)
                    self.assertIsNotNone(size)
                    width, height = size.groups()
                    done = run(["gnuplot"], f"set terminal svg size {width},{height}\n" + text)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    words = "".join(ElementTree.fromstring(done.stdout).itertext())
                    for title in re.findall(r"(?m)^set title '(.+)' noenhanced", text):
                        self.assertIn(title.replace("''", "'"), words)
                    drawn += 1
        self.assertGreater(drawn, 3 * len(FILES))

    def test_a_name_stays_a_name(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = hostile(Path(folder))
            for program, form, picture in ((["dot", "-Tsvg"], "dot", "coupling-graph"),
                                           (["gnuplot"], "gnuplot", "paths")):
                if not shutil.which(program[0]):
                    continue
                with self.subTest(form):
                    text = emitted(form, picture, file)
                    self.assertIsNotNone(text)
                    begin = "set terminal svg\n" if form == "gnuplot" else ""
                    done = run(program, begin + text)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))


def main() -> int:
    global PROGRAM
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = arguments.program.resolve()
    if not shutil.which("dot") and not shutil.which("gnuplot"):
        print("skipped: graphviz and gnuplot are not installed; scripts/setup.sh viewers installs"
              " them")
        return SKIPPED
    done = unittest.main(argv=[sys.argv[0], *rest], exit=False)
    return 0 if done.result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
