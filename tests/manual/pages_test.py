#!/usr/bin/env python3
"""What the pages of the manual are made of: blocks that are run, help that becomes Markdown."""

from __future__ import annotations

import argparse
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts" / "manual"))
from hand_page import HandPages, named_files  # noqa: E402
from help_text import HelpText  # noqa: E402
from picture import Pictures  # noqa: E402
from program import Program  # noqa: E402
from schema import Schema  # noqa: E402

program_path = Path("kinestat")


class PagesCase(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.program = Program(program_path, self.folder)
        self.pages = HandPages(self.program, Pictures(self.program, self.folder / "pictures"), self.folder)

    def filled(self, text: str) -> str:
        return self.pages.filled(text, "")


class Answers(PagesCase):
    def test_a_task_without_a_usable_linkage_has_pictures(self) -> None:
        task = str(ROOT / "mechanisms" / "synthesis" / "do_valle_table_2.yaml")
        self.assertEqual(self.program.pictures_of(task), ["synthesis", "burmester"])
        self.assertIn("<svg", self.program("plot", "burmester", task))

    def test_a_file_that_cannot_be_read_stops_the_manual(self) -> None:
        with self.assertRaises(SystemExit):
            self.program("plot", "list", "nowhere.yaml")


class Blocks(PagesCase):
    def test_a_command_stands_above_what_it_prints(self) -> None:
        self.assertEqual(self.filled("```{run}\necho one\n```\n"), "```console\n$ echo one\none\n```\n\n")

    def test_of_paragraphs_those_that_match_are_shown(self) -> None:
        text = self.filled("```{run} /^b/\nprintf 'a\\n\\nb 1\\nb 2\\n\\nc\\n\\nd\\n'\n```\n")
        self.assertIn("\n…\nb 1\nb 2\n…\n", text)

    def test_a_pattern_that_nothing_matches_stops_the_manual(self) -> None:
        with self.assertRaisesRegex(SystemExit, "nothing that is printed matches 'b'"):
            self.filled("```{run} /b/\necho a\n```\n")

    def test_an_exit_status_that_is_expected_passes(self) -> None:
        self.assertIn("E0151", self.filled("```{run} 4\nkinestat check missing.yaml\n```\n"))

    def test_any_other_exit_status_stops_the_manual(self) -> None:
        with self.assertRaisesRegex(SystemExit, "exit status 4 instead of 0"):
            self.filled("```{run}\nkinestat check missing.yaml\n```\n")

    def test_a_command_that_fails_within_a_pipe_stops_the_manual(self) -> None:
        with self.assertRaisesRegex(SystemExit, "exit status 4 instead of 0"):
            self.filled("```{run}\nkinestat check missing.yaml | cat\n```\n")

    def test_a_section_is_that_of_the_file(self) -> None:
        (self.folder / "a.md").write_text(
            "# A\n\n## One\n\n### Within\n\n```yaml\n# x.yaml\nkinestat: 1\n```\n\n## Two\n\nno\n",
            encoding="utf-8",
        )
        self.assertEqual(self.filled("```{section} a.md\nOne\n```\n"),
                         "## Within\n\n```yaml\n# x.yaml\nkinestat: 1\n```\n")

    def test_a_section_that_is_missing_stops_the_manual(self) -> None:
        (self.folder / "a.md").write_text("# A\n", encoding="utf-8")
        with self.assertRaisesRegex(SystemExit, "there is no section 'One'"):
            self.filled("```{section} a.md\nOne\n```\n")

    def test_of_several_files_of_a_name_the_last_counts(self) -> None:
        self.assertEqual(named_files("```yaml\n# x.yaml\na\n```\n\n```yaml\n# x.yaml\nb\n```\n"),
                         {"x.yaml": "b\n"})


class Help(PagesCase):
    def test_prose_flows_and_leads_to_other_topics(self) -> None:
        text = HelpText(self.program).body("One line,\nanother (help signs), a_b.\n")
        self.assertEqual(text, "One line, another ([help signs](../topics/signs.md)), a\\_b.\n")

    def test_what_is_laid_out_stays_and_its_heading_is_one(self) -> None:
        text = HelpText(self.program).body("Options:\n  -h   this help\n")
        self.assertEqual(text, "## Options\n\n```text\n-h   this help\n```\n\n")

    def test_a_mechanism_file_is_known_as_such(self) -> None:
        text = HelpText(self.program).body("    a   b\n\n    kinestat: 1\n    space: planar\n")
        self.assertIn("```yaml\nkinestat: 1\nspace: planar\n```", text)

    def test_a_list_below_a_mechanism_file_is_no_part_of_it(self) -> None:
        text = HelpText(self.program).body("    kinestat: 1\n\n    space: planar\n\nA is\n  b   c\n")
        self.assertEqual(
            text, "```yaml\nkinestat: 1\n\nspace: planar\n```\n\n\n```text\nA is\n  b   c\n```\n\n")

    def test_every_command_has_a_page(self) -> None:
        self.assertIn("tolerance", self.program.commands())


class Format(PagesCase):
    def test_keys_of_a_coupling_are_those_of_its_type(self) -> None:
        schema = Schema(self.program.schema())
        keys = [key.name for key in schema.coupling("gear").keys]
        self.assertIn("pressure_angle", keys)
        self.assertNotIn("radii", keys)

    def test_a_value_that_must_stand_is_told_from_one_that_may(self) -> None:
        schema = Schema(self.program.schema())
        keys = {key.name: key.needed for key in schema.mapping(schema.root["properties"]["shift"]).keys}
        self.assertTrue(keys["elements"])
        self.assertFalse(keys["names"])


def main() -> int:
    global program_path
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True)
    arguments, rest = parser.parse_known_args()
    program_path = arguments.program.resolve()
    done = unittest.main(argv=[sys.argv[0], *rest], exit=False)
    return 0 if done.result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
