#!/usr/bin/env python3
"""axe-core, a checker of accessibility, finds nothing against pages, light or dark, wide or narrow.

Skipped, with a word on it, where Chromium, its driver or axe-core are not installed.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import PageCase, program, run_tests, write_page  # noqa: E402

RUN = """
return window.axe.run(document, {resultTypes: ['violations']}).then((result) =>
  [result.passes.length,
   result.violations.map((one) => [one.id, one.nodes.map((node) => node.html.slice(0, 200))])]);
"""

SCREENS = ((1280, "light"), (1280, "dark"), (400, "light"), (400, "dark"))


def axe_core() -> Path | None:
    """Where npm has it: npm install --global axe-core, as scripts/setup.sh browser does."""
    folders = [os.environ.get("NODE_PATH", "")]
    if shutil.which("npm"):
        folders.append(subprocess.run(["npm", "root", "--global"], capture_output=True,
                                      encoding="utf-8", check=False).stdout.strip())
    paths = [Path(one) / "axe-core/axe.min.js" for one in folders if one]
    return next((one for one in paths if one.exists()), None)


class AccessTest(PageCase):
    checker = axe_core()

    def expect_nothing(self, page: Path, screens: tuple[tuple[int, str], ...] = SCREENS) -> None:
        if not self.checker:
            self.skipTest("axe-core is not installed; scripts/setup.sh browser, with npm, installs it")
        self.open(page, prefers_reduced_motion="reduce")
        self.ask(self.checker.read_text(encoding="utf-8") + "; window.axe = axe;")
        for width, scheme in screens:
            with self.subTest(page.stem, width=width, scheme=scheme):
                self.look(width, prefers_reduced_motion="reduce", prefers_color_scheme=scheme)
                passed, found = self.ask(RUN)
                self.assertGreater(passed, 10)
                self.assertEqual(found, [])

    def new(self, starter: str) -> Path:
        file = self.folder / f"{starter}.yaml"
        subprocess.run([program(), "new", "--force", starter, file], check=True,
                       stdout=subprocess.DEVNULL)
        page = self.folder / f"new-{starter}.html"
        self.assertEqual(write_page(page, file).returncode, 0)
        return page

    def test_motions(self) -> None:
        for name in ("sweeps/press_stroke.yaml", "spatial/rssr.yaml"):
            self.expect_nothing(self.page(name))

    def test_a_press_as_it_is_begun(self) -> None:
        self.expect_nothing(self.new("press"))

    def test_a_simulation(self) -> None:
        self.expect_nothing(self.new("run-up"))

    def test_a_duty(self) -> None:
        page = self.page("transmissions/muncie_m20.yaml")
        self.assertIn('class="duty"', page.read_text(encoding="utf-8"))
        self.expect_nothing(page)

    def test_a_sweep(self) -> None:
        self.expect_nothing(self.page("sweeps/ravigneaux_search.yaml"))

    def test_syntheses(self) -> None:
        for name in ("synthesis/crank_rocker.yaml", "synthesis/simpson_class.yaml"):
            self.expect_nothing(self.page(name))

    def test_many_gears(self) -> None:
        self.expect_nothing(self.page("transmissions/zf_8hp70.yaml"), ((1280, "light"), (400, "dark")))


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
