#!/usr/bin/env python3
"""Pages of `kinestat report` in a browser: they run nothing of others, and work.

Skipped, with a word on it, where Chromium and its driver are not installed.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from page_case import LOWER_CASE, ROOT, PageCase, program, run_tests, write_page  # noqa: E402

HOSTILE_TITLE = "<script>alert(1)</script></title><img src=x onerror=alert(2)>]]>\"'=1+1"


# Of a screen as PNG: the colour that most pixels of each column have, and that of the page.
PAPER_BETWEEN = """
const image = new Image();
image.src = 'data:image/png;base64,' + arguments[0];
return image.decode().then(() => {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [image.width, image.height];
  const paint = canvas.getContext('2d');
  paint.drawImage(image, 0, 0);
  const columns = [];
  for (let x = 0; x < image.width; ++x) {
    const counts = {};
    const data = paint.getImageData(x, 0, 1, image.height).data;
    for (let i = 0; i < data.length; i += 4) {
      const colour = data.slice(i, i + 3).join(' ');
      counts[colour] = (counts[colour] ?? 0) + 1;
    }
    columns.push(Object.entries(counts).sort((a, b) => b[1] - a[1])[0][0].split(' ').map(Number));
  }
  const paper = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number);
  return [columns, paper.slice(0, 3)];
});
"""


class PageTest(PageCase):
    def test_paragraphs_begin_as_sentences(self) -> None:
        for name in ("planar/stick_slip.yaml", "planar/four_stroke_engine.yaml"):
            with self.subTest(name):
                self.open(self.page(name))
                self.assertEqual(self.ask(LOWER_CASE), [])

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

    def test_extremes_are_seen_whole_and_their_names_on_one_line(self) -> None:
        for name in ("planar/watt_six_bar.yaml", "planar/four_stroke_engine.yaml",
                     "spatial/ups_platform.yaml", "planar/tailgate.yaml"):
            with self.subTest(name):
                self.open(self.page(name))
                beyond, heights, kinds = self.ask(
                    "const box = [...document.querySelectorAll('.results .box')].at(-1);"
                    "const rows = [...box.querySelectorAll('tbody tr')];"
                    "return [box.scrollWidth - box.clientWidth,"
                    "  [...new Set(rows.map((one) => Math.round(one.getBoundingClientRect().height)))],"
                    "  [...new Set(rows.flatMap((one) => [...one.cells].slice(1))"
                    "    .map((one) => getComputedStyle(one).textAlign))]];")
                self.assertLess(beyond, 1)
                self.assertLess(max(heights), 1.5 * min(heights))
                self.assertEqual(kinds, ["right"])

    def test_pictures_beside_a_table_leave_it_its_width(self) -> None:
        # Their captions are wider than the bars themselves.
        for name in ("spatial/rssr.yaml", "planar/toggle_press.yaml"):
            with self.subTest(name):
                self.open(self.page(name))
                cut = self.ask(
                    "return [...document.querySelectorAll('.pair.both .box')]"
                    ".map((one) => one.scrollWidth - one.clientWidth);")
                self.assertTrue(cut)
                self.assertLessEqual(max(cut), 1)

    def test_shadows_stand_where_a_box_goes_on(self) -> None:
        # Between the lines of a table: at an end that is reached its paper is that of the page.
        self.open(self.page("transmissions/zf_8hp70.yaml"), width=400)
        for scheme in ("light", "dark"):
            self.look(400, prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
            for end, is_there in ((0, [False, True]), (1, [True, False])):
                with self.subTest(scheme=scheme, end=end):
                    left, top, width, height = self.ask(
                        "const box = [...document.querySelectorAll('.box')].find((one) =>"
                        "  one.getClientRects().length && one.scrollWidth > one.clientWidth + 60);"
                        "box.scrollLeft = arguments[0] * 9999;"
                        "const p = box.getBoundingClientRect();"
                        "return [p.left + scrollX, p.top + scrollY, box.clientWidth, box.clientHeight];",
                        end)
                    picture = self.browser.tell(
                        "Page.captureScreenshot", captureBeyondViewport=True,
                        clip={"x": left, "y": top, "width": width, "height": height, "scale": 1})
                    # The colour that most of a column of pixels has, as its distance from the paper.
                    columns, paper = self.ask(PAPER_BETWEEN, picture["data"])
                    shaded = [[one for one in side if one != paper]
                              for side in (columns[:12], columns[-12:])]
                    self.assertEqual([len(one) >= 6 for one in shaded], is_there)
                    # A shadow is darker than paper; one line at its edge may be lighter.
                    for side in shaded:
                        lighter = [one for one in side if sum(one) > sum(paper)]
                        self.assertLessEqual(len(lighter), 1 if scheme == "dark" else 0)

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
                        "Power flow, case a: b", "Sweep over height: tin",
                        "Sweep over height: d.wz"):
            self.assertIn(caption, captions)

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

    def test_a_page_loads_as_fast_as_it_should(self) -> None:
        """By an empty page in the same run; half a second, where that one takes a hundredth."""
        empty = self.folder / "empty.html"
        empty.write_text("<!DOCTYPE html><title>empty</title>", encoding="utf-8")
        took = ("const one = performance.getEntriesByType('navigation')[0];"
                "return one.loadEventEnd - one.startTime;")

        def best(page: Path) -> float:
            times = []
            for _ in range(5):
                self.open(page)
                times.append(self.ask(took))
            return min(times)

        self.assertLess(best(self.page("transmissions/ravigneaux.yaml")), 50 * best(empty))

    def test_cases_beside_gears_are_not_called_so(self) -> None:
        # Five cases of its own, and the gears 1, 2, 3 and R of its section `shift`.
        self.open(self.page("transmissions/converter_automatic.yaml"))
        self.assertIn("5 cases and 4 gears are solved.", self.ask("return document.body.textContent;"))
        self.assertEqual(
            self.ask("return document.querySelector('.chooser legend').textContent;"), "Case or gear")
        self.open(self.page("transmissions/zf_8hp70.yaml"))
        self.assertEqual(
            self.ask("return document.querySelector('.chooser legend').textContent;"), "Gear")

    def test_an_axis_of_efficiencies_ends_at_one(self) -> None:
        self.open(self.page("synthesis/lepelletier_class.yaml"))
        axes = self.ask("return [...document.querySelectorAll('[data-picture=trade-offs] [data-plot]')]"
                        ".map((one) => one.dataset.x.split(' ').map(Number));")
        self.assertEqual(len(axes), 3)
        for low, high in axes:
            self.assertEqual(high, 1.0)
            self.assertGreater(low, 0.9)

    def test_bars_leave_no_wide_empty_space(self) -> None:
        # Those of a case of many couplings are not one column far below its tables.
        self.open(self.page("spatial/ups_platform.yaml"))
        heights = self.ask(
            "return [...document.querySelectorAll('section.panel figure')]"
            ".filter((one) => ['speeds', 'forces'].includes(one.dataset.picture))"
            ".map((one) => one.getBoundingClientRect().height).filter((one) => one > 0);")
        self.assertGreater(len(heights), 3)
        self.assertLess(max(heights), 900)


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
