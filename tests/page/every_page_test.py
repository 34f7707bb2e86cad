#!/usr/bin/env python3
"""What every page keeps to: it loads nothing, has all its parts, and fits screens and telephones.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import LOWER_CASE, LUMINANCE, ROOT, PageCase, program, run_tests, write_page  # noqa: E402

# A mechanism of each kind, the headings of its page, and the pictures that it must have.
SOLVED = ["Summary", "Structure", "Mobility", "Cases", "Data"]
GRAPHS = ["linkage", "coupling-graph", "motion-graph", "action-graph", "circuits", "cut-sets"]
CASE = ["power-flow", "speeds", "forces"]
PAGES = {
    "transmissions/ravigneaux.yaml": (SOLVED, [*GRAPHS, *CASE, "torques", "lever"]),
    "planar/four_bar.yaml": (SOLVED, [*GRAPHS, *CASE]),
    "planar/cam_and_follower.yaml": (SOLVED, [*GRAPHS, *CASE]),
    "spatial/rssr.yaml": (
        ["Summary", "Structure", "Mobility", "Motion", "Data"], [*GRAPHS, "motion", "motion-curves"]
    ),
    "transmissions/ravigneaux_input_shaft.yaml": (
        ["Summary", "Structure", "Mobility", "Shift table", "Gears", "Data"],
        [*GRAPHS, "gear-scheme", "shift-matrix", "ratio-ladder"],
    ),
    "sweeps/four_bar_height.yaml": (
        [*SOLVED, "Sensitivity", "Sweep"], [*GRAPHS, *CASE, "sweep-curves"]
    ),
    "cables/block_and_tackle.yaml": (SOLVED, [*GRAPHS, *CASE]),
    "synthesis/crank_rocker.yaml": (["Summary", "Synthesis", "Data"], []),
}
# The one with the widest pictures.
WIDEST = "transmissions/zf_8hp70.yaml"

# Elements with text of their own whose colour does not stand out from what is behind.
CONTRAST = LUMINANCE + """
const dull = [];
const paper = luminance(getComputedStyle(document.body).backgroundColor);
for (const one of document.querySelectorAll('body *')) {
  const has = [...one.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
  if (!has || !one.getClientRects().length || one.closest('script, desc, title')) continue;
  const style = getComputedStyle(one);
  const front = luminance(one.closest('svg') ? style.fill : style.color);
  let back = NaN;
  for (let b = one; b && Number.isNaN(back); b = b.parentElement)
    back = b.closest('svg') ? paper : luminance(getComputedStyle(b).backgroundColor);
  const [high, low] = [Math.max(front, back), Math.min(front, back)];
  const contrast = (high + 0.05) / (low + 0.05);
  if (!(contrast >= 4.5)) dull.push([one.tagName, one.textContent.slice(0, 30), contrast]);
}
return dull;
"""


class WidePage:
    """Of one page."""

    name = ""

    def open_at_rest(self, **features: str) -> None:
        """What moves is painted all the time."""
        self.open_once(self.page(self.name), prefers_reduced_motion="reduce", **features)

    def test_no_picture_shrinks_much_on_a_screen(self) -> None:
        self.open_at_rest()
        shrunk = self.ask(
            "return [...document.querySelectorAll('figure')].map((one) => {"
            "  const svg = one.querySelector('svg');"
            "  const width = svg.getBoundingClientRect().width;"
            "  return [one.dataset.picture, width / svg.viewBox.baseVal.width];"
            "}).filter(([, scale]) => scale > 0 && scale < 0.74);"
        )

        self.assertEqual(shrunk, [])


class EveryPage(WidePage):
    """What changes the page opens it for itself."""

    def test_nothing_is_loaded_and_the_console_is_silent(self) -> None:
        path = self.page(self.name)
        self.open(path)
        self.ask("for (const one of document.querySelectorAll('input')) one.click();")

        self.assertEqual(self.browser.messages(), [])
        others = [one for one in self.browser.requests()
                  if one != path.as_uri() and not one.startswith("data:")]
        self.assertEqual(others, [])

    def test_title_and_headings_are_there(self) -> None:
        self.open_at_rest()
        report = json.loads(self.ask(
            "return document.querySelector('script[data-kind=json]').textContent;"
        ))

        self.assertEqual(self.browser.title(), report["mechanism"]["name"])
        self.assertEqual(self.ask("return document.querySelectorAll('h1').length;"), 1)
        shown = self.ask(
            "return [...document.querySelectorAll('.part-title')].map((h) => h.textContent);"
        )
        headings, _ = PAGES[self.name]
        self.assertEqual([one for one in headings if one not in shown], [])

    def test_paragraphs_begin_as_sentences(self) -> None:
        self.open_at_rest()
        self.assertEqual(self.ask(LOWER_CASE), [])

    def test_headings_leave_out_no_level(self) -> None:
        self.open_at_rest()
        levels = self.ask(
            "return [...document.querySelectorAll('h1,h2,h3,h4,h5,h6')]"
            ".map((h) => Number(h.tagName[1]));"
        )
        jumps = [pair for pair in zip(levels, levels[1:]) if pair[1] > pair[0] + 1]
        self.assertEqual((levels[0], jumps), (1, []))

    def test_every_picture_is_there_and_has_words(self) -> None:
        self.open_at_rest()
        found = self.ask(
            "const hidden = [...document.querySelectorAll('[hidden]')];"
            "for (const one of hidden) one.hidden = false;"
            "const found = [...document.querySelectorAll('figure')].map((one) => {"
            "  const svg = one.querySelector('svg');"
            "  const box = svg.getBoundingClientRect();"
            "  return [one.dataset.picture, box.width, box.height,"
            "    svg.getAttribute('aria-label'), one.querySelector('figcaption').textContent];"
            "});"
            "for (const one of hidden) one.hidden = true;"
            "return found;"
        )
        _, pictures = PAGES[self.name]
        self.assertEqual([one for one in pictures if one not in {f[0] for f in found}], [])
        for picture, width, height, label, caption in found:
            self.assertGreater(min(width, height), 20, picture)
            self.assertTrue(label and caption, picture)

    def test_every_picture_of_the_catalogue_is_there(self) -> None:
        listed = subprocess.run(
            [program(), "plot", "list", ROOT / "mechanisms" / self.name],
            capture_output=True, encoding="utf-8", check=True).stdout
        # How long the program computes is no property of a mechanism; the page moves the
        # mechanism itself; maps of gears are left to those who ask for them, that of a duty
        # is on the page.
        wanted = set(re.findall(r"(?m)^yes  (\S+)", listed)) - {
            "pareto", "animation", "efficiency-map"}
        self.open_at_rest()
        shown = set(self.ask("return [...document.querySelectorAll('figure')]"
                             ".map((one) => one.dataset.picture);"))
        self.assertTrue(wanted)
        self.assertEqual(wanted - shown, set())

    def test_ids_are_unique_and_references_meet_them(self) -> None:
        self.open_at_rest()
        repeated, dangling = self.ask(
            "const ids = [...document.querySelectorAll('[id]')].map((one) => one.id);"
            "const all = new Set(ids);"
            "const wanted = [...document.querySelectorAll('[aria-labelledby],[href^=\"#\"]:not(.step-link),"
            "[data-save],[for]')].map((one) => one.getAttribute('aria-labelledby') ||"
            " one.dataset.save || one.htmlFor || one.getAttribute('href').slice(1));"
            "return [ids.filter((one, i) => ids.indexOf(one) !== i),"
            " wanted.filter((one) => !all.has(one))];"
        )
        self.assertEqual((repeated, dangling), ([], []))

    def test_text_stands_out_in_light_and_in_dark(self) -> None:
        # WCAG 2.2, 1.4.3: at least 4.5.
        for scheme in ("light", "dark"):
            with self.subTest(scheme=scheme):
                self.open_at_rest(prefers_color_scheme=scheme)
                dull = self.ask(CONTRAST)
                self.assertEqual(dull, [])
                dark = self.ask("return luminance(getComputedStyle(document.body)"
                                ".backgroundColor); " + LUMINANCE) < 0.2
                self.assertEqual(dark, scheme == "dark")

    def test_the_page_never_scrolls_sideways(self) -> None:
        path = self.page(self.name)
        self.open(path, prefers_reduced_motion="reduce")
        self.ask("for (const one of document.querySelectorAll('[hidden]')) one.hidden = false;"
                 "for (const one of document.querySelectorAll('details')) one.open = true;")
        for width in (400, 1280):
            for scheme in ("light", "dark"):
                with self.subTest(width=width, scheme=scheme):
                    self.look(width, prefers_color_scheme=scheme,
                              prefers_reduced_motion="reduce")
                    self.assertLessEqual(
                        self.ask("return document.documentElement.scrollWidth;"), width)

    def test_what_is_wider_than_its_box_can_be_reached_and_says_so(self) -> None:
        self.open(self.page(self.name), 400, prefers_reduced_motion="reduce")
        self.ask("for (const one of document.querySelectorAll('details')) one.open = true;")
        wide = self.ask(
            "return [...document.querySelectorAll('.box, .picture')]"
            ".filter((one) => one.scrollWidth > one.clientWidth + 1)"
            ".map((one) => [one.tabIndex, getComputedStyle(one).overflowX,"
            " getComputedStyle(one).backgroundImage !== 'none']);")
        self.assertTrue(wide)
        self.assertEqual([one for one in wide if one != [0, "auto", True]], [])

    def test_the_same_files_give_the_same_bytes(self) -> None:
        again = self.folder / "again.html"
        write_page(again, ROOT / "mechanisms" / self.name)
        self.assertEqual(again.read_bytes(), self.page(self.name).read_bytes())


# One class for each page, so that its tests follow each other and share what is opened.
for page, kind in {**dict.fromkeys(PAGES, EveryPage), WIDEST: WidePage}.items():
    globals()[page] = type(page, (kind, PageCase), {"name": page, "__module__": __name__})


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
