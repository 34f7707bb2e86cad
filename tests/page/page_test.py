#!/usr/bin/env python3
"""Pages of `kinestat report` in a browser: they load nothing, run nothing of others, and work.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import LUMINANCE, ROOT, PageCase, program, run_tests, write_page  # noqa: E402

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

HOSTILE_TITLE = "<script>alert(1)</script></title><img src=x onerror=alert(2)>]]>\"'=1+1"


class PageTest(PageCase):
    # What every page keeps to

    def test_nothing_is_loaded_and_the_console_is_silent(self) -> None:
        for name in PAGES:
            with self.subTest(name):
                path = self.page(name)
                self.open(path)
                self.ask("for (const one of document.querySelectorAll('input')) one.click();")

                self.assertEqual(self.browser.messages(), [])
                others = [one for one in self.browser.requests()
                          if one != path.as_uri() and not one.startswith("data:")]
                self.assertEqual(others, [])

    def test_title_and_headings_are_there(self) -> None:
        for name, (headings, _) in PAGES.items():
            with self.subTest(name):
                self.open(self.page(name))
                report = json.loads(self.ask(
                    "return document.querySelector('script[data-kind=json]').textContent;"
                ))

                self.assertEqual(self.browser.title(), report["mechanism"]["name"])
                self.assertEqual(self.ask("return document.querySelectorAll('h1').length;"), 1)
                shown = self.ask(
                    "return [...document.querySelectorAll('.part-title')].map((h) => h.textContent);"
                )
                self.assertEqual([one for one in headings if one not in shown], [])

    def test_paragraphs_begin_as_sentences(self) -> None:
        for name in [*PAGES, "planar/stick_slip.yaml", "planar/four_stroke_engine.yaml"]:
            with self.subTest(name):
                self.open(self.page(name))
                lower = self.ask(
                    "return [...document.querySelectorAll('main p:not(.source)')]"
                    ".map((p) => p.textContent).filter((text) => /^[a-z]+( (?!= )|[,;])/.test(text));"
                )
                self.assertEqual(lower, [])

    def test_extremes_beside_the_mechanism_need_no_scrolling(self) -> None:
        for name in ("spatial/rssr.yaml", "planar/cam_and_follower.yaml"):
            with self.subTest(name):
                self.open(self.page(name))
                hidden = self.ask(
                    "return [...document.querySelectorAll('.results .box')]"
                    ".map((one) => one.scrollWidth - one.clientWidth);"
                )
                self.assertEqual(len(hidden), 2)  # cases and extremes
                self.assertLessEqual(max(hidden), 0)

    def test_charts_of_a_motion_stand_beside_each_other(self) -> None:
        self.open(self.page("planar/four_bar.yaml"))
        tops = self.ask(
            "return [...document.querySelectorAll('section.motion figure.chart')]"
            ".map((one) => one.getBoundingClientRect().top);"
        )
        self.assertEqual(len(tops), 2)  # angles, and the path of the coupler point
        self.assertEqual(tops[0], tops[1])

    def test_headings_leave_out_no_level(self) -> None:
        for name in PAGES:
            with self.subTest(name):
                self.open(self.page(name))
                levels = self.ask(
                    "return [...document.querySelectorAll('h1,h2,h3,h4,h5,h6')]"
                    ".map((h) => Number(h.tagName[1]));"
                )
                jumps = [pair for pair in zip(levels, levels[1:]) if pair[1] > pair[0] + 1]
                self.assertEqual((levels[0], jumps), (1, []))

    def test_every_picture_is_there_and_has_words(self) -> None:
        for name, (_, pictures) in PAGES.items():
            with self.subTest(name):
                self.open(self.page(name))
                found = self.ask(
                    "return [...document.querySelectorAll('figure')].map((one) => {"
                    "  const svg = one.querySelector('svg');"
                    "  const hidden = one.closest('[hidden]');"
                    "  if (hidden) hidden.hidden = false;"
                    "  const box = svg.getBoundingClientRect();"
                    "  if (hidden) hidden.hidden = true;"
                    "  return [one.dataset.picture, box.width, box.height,"
                    "    svg.getAttribute('aria-label'), one.querySelector('figcaption').textContent];"
                    "});"
                )
                self.assertEqual([one for one in pictures if one not in {f[0] for f in found}], [])
                for picture, width, height, label, caption in found:
                    self.assertGreater(min(width, height), 20, picture)
                    self.assertTrue(label and caption, picture)

    def test_names_of_a_drawing_that_shrinks_can_be_read(self) -> None:
        for name in ("planar/four_bar.yaml", "spatial/rssr.yaml", "cables/weston_hoist.yaml",
                     "gears/simple_planetary.yaml"):
            with self.subTest(name):
                self.open(self.page(name), width=400)
                heights = self.ask(
                    "return [...document.querySelectorAll("
                    "  '[data-picture=linkage] text, figure.motion text')]"
                    ".map((one) => one.getBoundingClientRect().height)"
                    ".filter((one) => one > 0);"
                )

                # Of a font of 7 px; the small letters of the scale and the axes are the smallest.
                self.assertGreater(min(heights), 8)

    def test_no_moving_mechanism_of_few_parts_is_cut_on_a_telephone(self) -> None:
        for name in ("planar/watt_six_bar.yaml", "planar/four_bar.yaml", "planar/slider_crank.yaml",
                     "planar/four_stroke_engine.yaml", "planar/stick_slip.yaml",
                     "spatial/rssr.yaml", "sweeps/press_stroke.yaml"):
            with self.subTest(name):
                self.open(self.page(name), width=400)
                beyond = self.ask(
                    "const box = document.querySelector('figure.motion .picture');"
                    "return box.scrollWidth - box.clientWidth;")
                self.assertLessEqual(beyond, 1)

    def test_no_picture_is_cut_by_a_few_pixels_on_a_telephone(self) -> None:
        # The lever diagram of the Ravigneaux set is a little over 400 pixels wide, the box of a picture 378.
        for name in ("planar/gripper.yaml", "cables/block_and_tackle.yaml",
                     "transmissions/ravigneaux.yaml"):
            with self.subTest(name):
                self.open(self.page(name), width=400)
                cut = self.ask(
                    "return [...document.querySelectorAll('figure:not(.chart) .picture')]"
                    ".filter((one) => one.getClientRects().length)"
                    ".map((one) => [one.closest('figure').dataset.picture,"
                    "  one.scrollWidth - one.clientWidth])"
                    ".filter(([, beyond]) => beyond > 1 && beyond < 100);")

                self.assertEqual(cut, [])

    def test_no_picture_shrinks_much_on_a_screen(self) -> None:
        for name in (*PAGES, "transmissions/zf_8hp70.yaml"):
            with self.subTest(name):
                self.open(self.page(name))
                shrunk = self.ask(
                    "return [...document.querySelectorAll('figure')].map((one) => {"
                    "  const svg = one.querySelector('svg');"
                    "  const width = svg.getBoundingClientRect().width;"
                    "  return [one.dataset.picture, width / svg.viewBox.baseVal.width];"
                    "}).filter(([, scale]) => scale > 0 && scale < 0.74);"
                )

                self.assertEqual(shrunk, [])

    def test_extremes_are_seen_beside_the_mechanism(self) -> None:
        # What is least and greatest, and where; ranges and means may be scrolled to.
        for name in ("planar/watt_six_bar.yaml", "planar/four_stroke_engine.yaml",
                     "spatial/ups_platform.yaml"):
            with self.subTest(name):
                self.open(self.page(name))
                heads, beyond = self.ask(
                    "const box = [...document.querySelectorAll('.results .box')].at(-1);"
                    "const right = box.getBoundingClientRect().right;"
                    "const heads = [...box.querySelectorAll('thead th')].slice(0, 5);"
                    "return [heads.map((one) => one.textContent),"
                    "  heads.map((one) => one.getBoundingClientRect().right - right)];")
                self.assertEqual([heads[1], heads[3]], ["least", "greatest"])
                self.assertLess(max(beyond), 1)

    def test_bars_of_a_case_leave_no_page_empty(self) -> None:
        # Those of velocities stand beside their tables, those of forces and moments beside each
        # other, forces first.
        self.open(self.page("planar/four_stroke_engine.yaml"))
        tables, speeds, forces, torques = self.ask(
            "const panel = document.querySelector('section.panel');"
            "const box = (one) => { const p = one.getBoundingClientRect();"
            "  return [p.left, p.right, p.top]; };"
            "const figure = (name) => box(panel.querySelector(`[data-picture=${name}]`));"
            "return [box(panel.querySelector('.pair table')), ...['speeds', 'forces', 'torques'].map(figure)];")
        self.assertGreater(speeds[0], tables[1])
        self.assertGreaterEqual(torques[0], forces[1])
        self.assertAlmostEqual(torques[2], forces[2], delta=1)

    def test_errors_come_first_and_their_lines_can_be_reached(self) -> None:
        text = (ROOT / "mechanisms/planar/four_bar.yaml").read_text(encoding="utf-8")
        cases = text.index("cases:")
        file = self.folder / "wrong.yaml"
        file.write_text(text[:cases] + "cases:\n  a case with a motion too many, which no linkage can have: "
                        "{motion: {a.wz: 60 rpm, d.wz: 3 rpm}}\n", encoding="utf-8")
        page = self.folder / "wrong.html"
        self.assertEqual(write_page(page, file).returncode, 3)
        self.open(page, width=400)

        titles, quoted = self.ask(
            "return [[...document.querySelectorAll('.part-title')].map((one) => one.textContent),"
            "  [...document.querySelectorAll('pre.quoted')].map((one) => [one.tabIndex,"
            "    one.scrollWidth > one.clientWidth,"
            "    getComputedStyle(one).backgroundImage !== 'none'])];")
        self.assertEqual(titles[:2], ["Findings", "Summary"])
        self.assertEqual(quoted, [[0, True, True]])

    def test_captions_keep_names_as_the_file_writes_them(self) -> None:
        text = (ROOT / "mechanisms/sweeps/four_bar_height.yaml").read_text(encoding="utf-8")
        text = text[:text.index("published:")].replace("Tin", "tin").replace("crank turns:", "'a: b':")
        text = text.replace("name: Four-bar linkage of", "name: 'pair: four-bar of").replace(
            "varied height", "varied height'", 1)
        file = self.folder / "names.yaml"
        file.write_text(text, encoding="utf-8")
        page = self.folder / "names.html"
        self.assertEqual(write_page(page, file).returncode, 0)
        self.open(page)

        captions = self.ask(
            "return [...document.querySelectorAll('figcaption')]"
            ".map((one) => one.textContent.replace(/^Figure \\d+\\. /, ''));"
        )

        for caption in ("Mechanism", "Mechanism with the forces of case a: b",
                        "Power flow, case a: b", "Sweep over height, tin",
                        "Sweep over height, d.wz"):
            self.assertIn(caption, captions)

    def test_every_picture_of_the_catalogue_is_there(self) -> None:
        for name in PAGES:
            with self.subTest(name):
                listed = subprocess.run(
                    [program(), "plot", "list", ROOT / "mechanisms" / name],
                    capture_output=True, encoding="utf-8", check=True).stdout
                # How long the program computes is no property of a mechanism; the page moves the
                # mechanism itself; maps of gears are left to those who ask for them, that of a duty
                # is on the page.
                wanted = set(re.findall(r"(?m)^yes  (\S+)", listed)) - {
                    "pareto", "animation", "efficiency-map"}
                self.open(self.page(name))
                shown = set(self.ask("return [...document.querySelectorAll('figure')]"
                                     ".map((one) => one.dataset.picture);"))
                self.assertTrue(wanted)
                self.assertEqual(wanted - shown, set())

    def test_the_page_never_scrolls_sideways(self) -> None:
        for name in PAGES:
            for width in (400, 1280):
                for scheme in ("light", "dark"):
                    with self.subTest(name, width=width, scheme=scheme):
                        self.open(self.page(name), width, prefers_color_scheme=scheme)
                        self.ask("for (const one of document.querySelectorAll('[hidden]'))"
                                 " one.hidden = false;"
                                 "for (const one of document.querySelectorAll('details'))"
                                 " one.open = true;")
                        self.assertLessEqual(
                            self.ask("return document.documentElement.scrollWidth;"), width)

    def test_what_is_wider_than_its_box_can_be_reached_and_says_so(self) -> None:
        for name in PAGES:
            with self.subTest(name):
                self.open(self.page(name), 400)
                self.ask("for (const one of document.querySelectorAll('details')) one.open = true;")
                wide = self.ask(
                    "return [...document.querySelectorAll('.box, .picture')]"
                    ".filter((one) => one.scrollWidth > one.clientWidth + 1)"
                    ".map((one) => [one.tabIndex, getComputedStyle(one).overflowX,"
                    " getComputedStyle(one).backgroundImage !== 'none']);")
                self.assertTrue(wide)
                self.assertEqual([one for one in wide if one != [0, "auto", True]], [])

    def test_tables_of_results_that_go_on_below_say_so(self) -> None:
        for name, rows in (("transmissions/rohloff_speedhub.yaml", 18),
                           ("transmissions/vw_02e_dsg.yaml", 24)):
            with self.subTest(name):
                self.open(self.page(name))
                tables = self.ask(
                    "return [...document.querySelectorAll('.results .box')]"
                    ".filter((one) => one.scrollHeight > one.clientHeight + 1)"
                    ".map((one) => {"
                    "  const top = one.getBoundingClientRect().top;"
                    "  one.scrollTop = 100;"
                    "  const head = one.querySelector('thead th').getBoundingClientRect();"
                    "  const count = one.closest('details')?.querySelector('summary').textContent;"
                    "  return [count, Math.abs(head.top - top) < 2];"
                    "});")

                self.assertEqual(tables, [[f"Case: {rows} rows", True]])

    def test_ids_are_unique_and_references_meet_them(self) -> None:
        for name in PAGES:
            with self.subTest(name):
                self.open(self.page(name))
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
        for name in PAGES:
            for scheme in ("light", "dark"):
                with self.subTest(name, scheme=scheme):
                    self.open(self.page(name), prefers_color_scheme=scheme)
                    dull = self.ask(CONTRAST)
                    self.assertEqual(dull, [])
                    dark = self.ask("return luminance(getComputedStyle(document.body)"
                                    ".backgroundColor); " + LUMINANCE) < 0.2
                    self.assertEqual(dark, scheme == "dark")

    def test_colours_can_be_chosen(self) -> None:
        self.open(self.page("planar/four_bar.yaml"), prefers_color_scheme="light")
        before, after = self.ask(
            "const colour = () => getComputedStyle(document.body).backgroundColor;"
            "const first = colour();"
            "const theme = document.getElementById('theme');"
            "theme.value = 'dark'; theme.dispatchEvent(new Event('change'));"
            "return [first, colour()];"
        )
        self.assertNotEqual(before, after)

    # One of several cases

    def test_a_gear_is_chosen_by_the_keyboard_and_by_its_address(self) -> None:
        path = self.page("transmissions/ravigneaux.yaml")
        self.open(path)
        panels = self.is_shown("section.panel")
        self.assertEqual(panels, [True] + [False] * (len(panels) - 1))

        self.ask("document.querySelector('.choices input').focus();")
        for kind in ("keyDown", "keyUp"):
            self.browser.tell("Input.dispatchKeyEvent", type=kind, key="ArrowRight",
                              code="ArrowRight", windowsVirtualKeyCode=39)

        self.assertEqual(self.is_shown("section.panel"), [False, True] + [False] * (len(panels) - 2))

        self.ask("location.hash = document.querySelectorAll('section.panel')[2].id;")
        time.sleep(0.2)
        self.assertEqual(self.is_shown("section.panel"),
                         [False, False, True] + [False] * (len(panels) - 3))

    def test_without_a_script_everything_is_shown(self) -> None:
        self.browser.tell("Emulation.setScriptExecutionDisabled", value=True)
        try:
            self.open(self.page("transmissions/ravigneaux.yaml"))
        finally:
            self.browser.tell("Emulation.setScriptExecutionDisabled", value=False)
        self.assertEqual(set(self.is_shown("section.panel")), {True})
        self.assertEqual(set(self.is_shown(".script")), {False})

    # What others write

    def test_what_a_file_says_stays_text(self) -> None:
        source = (ROOT / "mechanisms/planar/four_bar.yaml").read_text("utf-8")
        hostile = self.folder / "hostile.yaml"
        title = json.dumps(HOSTILE_TITLE)
        hostile.write_text(re.sub(r"(?m)^name:.*$", lambda _: f"name: {title}", source), "utf-8")
        path = self.folder / "hostile.html"
        self.assertEqual(write_page(path, hostile).returncode, 0)

        self.open(path)

        self.assertIsNone(self.browser.alert_text())
        self.assertEqual(self.browser.title(), HOSTILE_TITLE)
        self.assertEqual(self.ask("return document.querySelector('h1').textContent;"), HOSTILE_TITLE)
        self.assertEqual(self.ask("return document.querySelectorAll('img').length;"), 0)
        self.assertEqual(self.browser.messages(), [])
        stored = self.ask(
            "return document.querySelector('script[data-kind=json]').textContent;")
        self.assertEqual(json.loads(stored)["mechanism"]["name"], HOSTILE_TITLE)

    def test_no_other_script_or_style_can_run(self) -> None:
        path = self.page("planar/four_bar.yaml")
        broken = self.folder / "broken.html"
        text = path.read_text("utf-8")
        broken.write_text(
            text.replace("<main", "<script>document.title = 'taken'</script>"
                                  "<p id='painted' style='color:red' onclick='x()'>x</p><main"),
            "utf-8")

        self.open(broken)

        self.assertNotEqual(self.browser.title(), "taken")
        self.assertNotEqual(
            self.ask("return getComputedStyle(document.getElementById('painted')).color;"),
            "rgb(255, 0, 0)")

    def test_a_file_that_is_wrong_has_its_findings(self) -> None:
        wrong = self.folder / "wrong.yaml"
        wrong.write_text("kinestat: 1\nname: Wrong\nbodies: [frame, frame]\n", "utf-8")
        path = self.folder / "two.html"
        right = ROOT / "mechanisms/planar/four_bar.yaml"

        answer = write_page(path, wrong, right)

        self.assertEqual(answer.returncode, 3)
        self.open(path)
        self.assertEqual(self.ask("return document.querySelectorAll('section.file').length;"), 2)
        findings = self.ask("return document.querySelector('.findings').textContent;")
        first = answer.stderr.splitlines()[0]
        self.assertIn(first, findings)

    def test_words_of_findings_are_broken_into_lines_and_quotations_are_not(self) -> None:
        for name in ("gears/self_locking_planetary.yaml", "spatial/bennett.yaml"):
            with self.subTest(name):
                self.open(self.page(name), width=400)
                finding = self.ask(
                    "return [...document.querySelectorAll('.findings pre')]"
                    ".map((one) => [one.className, one.scrollWidth <= one.clientWidth,"
                    "  one.textContent]);"
                )

                self.assertEqual([one[0] for one in finding], ["words", "quoted", "words"])
                self.assertTrue(finding[0][1] and finding[2][1])
                self.assertEqual(finding[1][2].count("\n"), 2)

    def test_the_data_are_those_of_the_reports(self) -> None:
        file = ROOT / "mechanisms/spatial/rssr.yaml"

        def written_by(*options: str) -> dict[str, str]:
            with tempfile.TemporaryDirectory() as folder:
                subprocess.run([program(), "analyze", "-q", "--out", folder, *options, file],
                               check=True)
                return {one.name: one.read_text("utf-8") for one in Path(folder).iterdir()}

        written = written_by()
        # A motion has a row a step: a row a value would be most of the page.
        motion = "rssr.motion.csv"
        self.assertIn(motion, written)
        written[motion] = written_by("--layout", "wide")[motion]
        self.open(self.page("spatial/rssr.yaml"))
        saved = dict(self.ask(SAVE))

        for name, text in written.items():
            self.assertIn(name, saved)
            if name.endswith(".csv"):
                self.assertEqual(saved[name], text, name)
            else:
                self.assertEqual(json.loads(saved[name]), json.loads(text), name)

    def test_a_page_is_light_but_for_its_data(self) -> None:
        html = self.page("transmissions/ravigneaux.yaml").read_text("utf-8")
        shown = re.sub(r"<script[^>]* data-kind=.*?</script>", "", html, flags=re.S)
        self.assertLess(len(shown.encode()), 300_000)

    def test_the_same_files_give_the_same_bytes(self) -> None:
        again = self.folder / "again.html"
        for name in PAGES:
            write_page(again, ROOT / "mechanisms" / name)
            self.assertEqual(again.read_bytes(), self.page(name).read_bytes(), name)


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

# What the buttons would save: names and texts.
SAVE = """
const saved = [];
const make = URL.createObjectURL;
const click = HTMLAnchorElement.prototype.click;
const wait = [];
URL.createObjectURL = (blob) => { wait.push(blob.text()); return 'data:,'; };
HTMLAnchorElement.prototype.click = function () { saved.push(this.download); };
for (const one of document.querySelectorAll('button[data-save]')) one.click();
URL.createObjectURL = make;
HTMLAnchorElement.prototype.click = click;
return Promise.all(wait).then((texts) => texts.map((text, i) => [saved[i], text]));
"""


if __name__ == "__main__":
    sys.exit(run_tests(__doc__))
