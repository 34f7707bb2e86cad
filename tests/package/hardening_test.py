"""What is installed is hardened, as the ELF files say, and does not depend on the folder of its build."""

from __future__ import annotations

import argparse
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
options = argparse.Namespace()


def told(*words: str | Path) -> str:
    return subprocess.run([str(word) for word in words], capture_output=True, text=True,
                          check=True).stdout


def link_of(target: str) -> list[str]:
    *_, command = told("ninja", "-C", options.build, "-t", "commands", "-s", target).splitlines()
    found = re.search(r"&& (.*) && :$", command)
    return shlex.split(found[1] if found else command)


@unittest.skipUnless(shutil.which("readelf"), "readelf is not installed")
class Hardening(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.program = options.build / "app/kinestat"
        cls.shipped = [cls.program, options.build / "lib/libkinestat.so"]
        cls.archives = sorted((options.build / "lib").glob("libkinestat_*.a"))

    def test_what_is_relocated_is_read_only_from_the_start(self) -> None:
        for file in self.shipped:
            with self.subTest(file.name):
                headers = told("readelf", "-lW", file)
                self.assertIn("GNU_RELRO", headers)
                dynamic = told("readelf", "-dW", file)
                self.assertRegex(dynamic, r"\(FLAGS\) +BIND_NOW|\(BIND_NOW\)")
                self.assertRegex(dynamic, r"\(FLAGS_1\) +Flags:.* NOW")
                self.assertNotIn("TEXTREL", dynamic)

    def test_nothing_is_written_and_run(self) -> None:
        for file in self.shipped:
            with self.subTest(file.name):
                headers = told("readelf", "-lW", file)
                self.assertRegex(headers, r"GNU_STACK +(0x0+ +){3}0x0+ +0x0+ +RW +")
                self.assertNotRegex(headers, r"LOAD.* RWE ")

    def test_the_program_stands_where_it_likes(self) -> None:
        self.assertIn("DYN (Position-Independent Executable file)", told("readelf", "-hW", self.program))

    def test_frames_have_canaries(self) -> None:
        # In an archive the program cannot have them from the C library.
        self.assertIn(" __stack_chk_fail", told("readelf", "--dyn-syms", "-W", self.shipped[1]))
        without = [archive.name for archive in self.archives
                   if "__stack_chk_fail" not in told("nm", "--undefined-only", archive)]
        self.assertLess(len(without), len(self.archives) / 10, without)

    def test_copies_are_bounded(self) -> None:
        self.assertRegex(told("readelf", "--dyn-syms", "-W", self.shipped[1]), r" __\w+_chk@GLIBC")

    @unittest.skipUnless(shutil.which("objdump"), "objdump is not installed")
    def test_large_frames_touch_each_page(self) -> None:
        code = told("objdump", "-d", "--no-show-raw-insn", options.build / "lib/libkinestat_run.a")
        if "x86-64" not in code:
            self.skipTest("probes look different on this processor")
        self.assertRegex(code, r"sub +\$0x1000,%rsp\n[^\n]*orq +\$0x0,")

    def test_no_path_of_the_build_is_in_it(self) -> None:
        for file in self.shipped:
            with self.subTest(file.name):
                content = file.read_bytes()
                for folder in (ROOT, options.build):
                    self.assertNotIn(str(folder).encode(), content)

    def test_no_source_asks_for_the_time_of_its_compilation(self) -> None:
        asking = [str(path) for folder in ("lib", "app", "include")
                  for path in (ROOT / folder).rglob("*.[ch]*")
                  if re.search(r"__(DATE|TIME|TIMESTAMP)__", path.read_text(encoding="utf-8"))]
        self.assertEqual(asking, [])


class Relinking(unittest.TestCase):
    """That who may change the LGPL libraries can put them in, as the copyright file says."""

    def test_the_program_runs_with_shared_libraries(self) -> None:
        words = [word for word in link_of("app/kinestat") if word != "-static-pie"]
        shared = [re.sub(r"/lib(gmp|mpfr)\.a$", r"/lib\1.so", word) for word in words]
        if not options.static:
            self.skipTest("this build shares them already")
        self.assertNotEqual(shared, words)
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder, "kinestat")
            shared[shared.index("-o") + 1] = str(program)
            subprocess.run(shared, cwd=options.build, check=True, capture_output=True)
            needed = re.findall(r"\(NEEDED\).*\[lib(\w+)", told("readelf", "-dW", program))
            self.assertLessEqual({"gmp", "mpfr", "c"}, set(needed))
            file = ROOT / "mechanisms/transmissions/ravigneaux.yaml"
            words = ["analyze", "--accuracy", "exact", "--format", "json", file]
            self.assertEqual(told(program, *words), told(options.build / "app/kinestat", *words))

    def test_an_option_chooses_them(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            # Compilers and Debian packages are asked for once, by the build itself.
            told(options.cmake, "-S", ROOT, "-B", folder, "-G", "Ninja", "-DBUILD_TESTING=OFF",
                 "-DKINESTAT_SHARED_LIBRARIES=ON")
            rules = Path(folder, "build.ninja").read_text(encoding="utf-8")
            self.assertRegex(rules, r"build app/kinestat:[^\n]*libgmp\.so")
            self.assertNotRegex(rules, r"build app/kinestat:[^\n]*lib(gmp|mpfr)\.a")
            self.assertNotIn("-static-pie", rules)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--cmake", required=True)
    parser.add_argument("--static", action="store_true")
    options, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
