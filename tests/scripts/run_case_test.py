"""run_case.py, with a program that says what the case tells it to."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "tests" / "cli" / "run_case.py"
PROGRAM = '#!/bin/bash\ncase $1 in fail) echo "wrong: $2" >&2; exit 3 ;; *) printf "$@" ;; esac\n'


class RunCase(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = Path(folder.name) / "program"
        self.program.write_text(PROGRAM, encoding="utf-8")
        self.program.chmod(0o755)
        self.case = Path(folder.name) / "case"
        self.case.mkdir()

    def run_case(self, cmd: str, *arguments: str, **expected: str) -> tuple[int, str]:
        """Status and faults; `out_json` stands for the file out.json."""
        for name, text in {"cmd": cmd, **expected}.items():
            path = self.case / name.replace("out_json", "out.json")
            path.write_text(text, encoding="utf-8")
        done = subprocess.run(
            [sys.executable, SCRIPT, self.case, "--program", self.program, *arguments],
            capture_output=True, text=True, check=False, env=os.environ | {"STRANGE": "1"},
        )
        return done.returncode, done.stderr

    def assert_passes(self, cmd: str, **expected: str) -> None:
        self.assertEqual(self.run_case(cmd, **expected), (0, ""))

    def assert_fails(self, message: str, cmd: str, **expected: str) -> None:
        status, faults = self.run_case(cmd, **expected)
        self.assertEqual(status, 1)
        self.assertIn(message, faults)

    def test_exact_text_passes(self) -> None:
        self.assert_passes('"$KINESTAT" "a\\n"', out="a\n", err="")

    def test_other_text_fails(self) -> None:
        self.assert_fails("stdout differs:\n--- expected", '"$KINESTAT" "a\\n"', out="b\n")

    def test_a_missing_line_end_fails(self) -> None:
        self.assert_fails("only the line ends differ", '"$KINESTAT" a', out="a\n")

    def test_a_status_passes(self) -> None:
        self.assert_passes('"$KINESTAT" fail x', status="3\n", err="wrong: x\n")

    def test_a_status_that_nobody_expects_fails(self) -> None:
        self.assert_fails("expected exit status 0, got 3", '"$KINESTAT" fail x', err="wrong: x\n")

    def test_a_case_that_expects_nothing_fails(self) -> None:
        self.assert_fails("nothing is expected", '"$KINESTAT" a', files="*")

    def test_a_folder_without_a_command_fails(self) -> None:
        (self.case / "out").write_text("", encoding="utf-8")
        done = subprocess.run(
            [sys.executable, SCRIPT, self.case, "--program", self.program],
            capture_output=True, text=True, check=False,
        )
        self.assertIn("there is no file cmd", done.stderr)

    def test_lines_that_occur_pass(self) -> None:
        self.assert_passes('"$KINESTAT" "one\\ntwo three\\n"', out_contains="two\none\n")

    def test_a_line_that_does_not_occur_fails(self) -> None:
        self.assert_fails("stderr lacks: y", '"$KINESTAT" fail x', status="3", err_contains="y\n")

    def test_json_is_compared_as_numbers(self) -> None:
        self.assert_passes("echo '{\"a\": [1.0000000001, 1e-13]}'", out_json='{"a": [1, 0.0]}')

    def test_a_json_number_that_differs_fails(self) -> None:
        self.assert_fails(
            "stdout /a/1: expected 0, got 1e-11",
            "echo '{\"a\": [1, 1e-11]}'",
            out_json='{"a": [1, 0]}',
        )

    def test_json_keys_keep_their_order(self) -> None:
        self.assert_fails(
            "the keys ['a', 'b']", "echo '{\"b\": 1, \"a\": 1}'", out_json='{"a": 1, "b": 1}'
        )

    def test_a_boolean_is_no_number(self) -> None:
        self.assert_fails("expected 1, got True", "echo '[true]'", out_json="[1]")

    def test_an_empty_object_is_no_empty_array(self) -> None:
        self.assert_fails("expected [], got {}", "echo '{}'", out_json="[]")

    def test_the_version_is_ignored(self) -> None:
        self.assert_passes(
            "echo '{\"k\": {\"version\": \"2\"}}'", out_json='{"k": {"version": "1"}}'
        )

    def test_several_documents_pass(self) -> None:
        self.assert_passes("echo '{\"a\": 1}'; echo '{\"a\": 2}'", out_json='{"a": 1}\n{"a": 2}\n')

    def test_a_document_too_few_fails(self) -> None:
        self.assert_fails(
            "expected 2 entries, got 1", "echo '{\"a\": 1}'", out_json='{"a": 1} {"a": 2}'
        )

    def test_nan_is_no_json(self) -> None:
        self.assert_fails("NaN is not JSON", "echo '[NaN]'", out_json="[0]")

    def test_an_escape_byte_fails(self) -> None:
        self.assert_fails("stderr holds an ESC byte", "printf '\\033[1m' >&2", status="0")

    def test_bytes_that_are_no_text_fail(self) -> None:
        self.assert_fails("stdout is not UTF-8", "printf '\\377'", status="0")

    def test_the_folders_names_are_replaced(self) -> None:
        self.assert_passes(
            'echo "$PWD $ROOT $MECHANISMS"', out="<tmp> <root> <root>/mechanisms\n"
        )

    def test_the_environment_is_bare(self) -> None:
        self.assert_passes('echo "${STRANGE:-none} ${HOME:-none} $LC_ALL"', out="none none C\n")

    def test_the_command_sees_a_copy_without_the_expectations(self) -> None:
        (self.case / "a.yaml").write_text("x\n", encoding="utf-8")
        self.assert_passes("ls; rm a.yaml", out="a.yaml\n")
        self.assertTrue((self.case / "a.yaml").exists())

    def test_files_that_must_exist_pass(self) -> None:
        self.assert_passes(
            "mkdir -p r/s; touch r/s/a.csv", status="0", files="r/*/a.csv\n**/*.csv\n"
        )

    def test_a_file_that_does_not_exist_fails(self) -> None:
        self.assert_fails(
            "no file matches *.csv", "mkdir r; touch r/a.csv", status="0", files="*.csv"
        )

    def test_a_file_that_must_not_exist_fails(self) -> None:
        self.assert_fails(
            "should not exist (**/*.tmp*): r/.a.tmp7",
            "mkdir r; touch r/.a.tmp7",
            status="0",
            no_files="**/*.tmp*\n",
        )

    @unittest.skipUnless(os.geteuid() == 0, "only root can become nobody")
    def test_as_nobody_root_has_no_rights(self) -> None:
        (self.case / "a.yaml").write_text("x\n", encoding="utf-8")
        self.assert_passes(
            'chmod 0 a.yaml; cat a.yaml 2>/dev/null || "$KINESTAT" no; echo >b',
            out="no",
            as_nobody="",
        )

    def test_an_update_rewrites_what_is_there(self) -> None:
        self.run_case('"$KINESTAT" fail x', "--update", err="old\n")
        self.assertEqual((self.case / "err").read_text(encoding="utf-8"), "wrong: x\n")
        self.assertEqual((self.case / "status").read_text(encoding="utf-8"), "3\n")
        self.assertFalse((self.case / "out").exists())

    def test_an_update_fills_an_empty_case(self) -> None:
        self.run_case("echo '{\"a\": 1}'", "--update")
        self.assertEqual((self.case / "out.json").read_text(encoding="utf-8"), '{"a": 1}\n')
        self.assertEqual({p.name for p in self.case.iterdir()}, {"cmd", "out.json"})

    def test_an_update_leaves_numbers_that_still_hold(self) -> None:
        self.run_case("echo '[1.0000000001]'", "--update", out_json="[1]\n")
        self.assertEqual((self.case / "out.json").read_text(encoding="utf-8"), "[1]\n")


if __name__ == "__main__":
    unittest.main()
