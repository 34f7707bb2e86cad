"""The packages: made from this build; the program installed into an empty root, used as the README
says, removed without a trace; the library unpacked and used; the archive likewise."""

from __future__ import annotations

import argparse
import gzip
import io
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import unittest
from datetime import datetime, timezone
from email.utils import parsedate_to_datetime
from pathlib import Path

from library_case import ROOT, LibraryCase

LARGEST = 5_000_000  # bytes of a package
FILES = {"mechanisms/transmissions/ravigneaux.yaml", "schemas/mechanism.schema.json",
         "examples/largest_powers.sh"}
SHELL_FILES = {"man/man1/kinestat-motion.1.gz": b"\\-\\-steps",
               "man/man7/kinestat-motion.7.gz": b"KINESTAT\\-MOTION 7",
               "bash-completion/completions/kinestat": b"complete -F _kinestat kinestat",
               "fish/vendor_completions.d/kinestat.fish": b"--command kinestat"}
options = argparse.Namespace()


def run(words: list[str], **more: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(words, capture_output=True, text=True, check=False, **more)


def tree(root: Path) -> set[str]:
    """Every file and folder, but for what dpkg notes about itself."""
    names = {str(path.relative_to(root)) for path in root.rglob("*")}
    return {name for name in names if not name.startswith(("var/lib/dpkg", "var/log"))}


def readme_commands() -> list[str]:
    """The lines of its shell blocks that call the program, and nothing that is not installed."""
    commands = []
    for block in re.findall(r"```(console|sh)\n(.*?)```", ROOT.joinpath("README.md").read_text(
            encoding="utf-8"), re.DOTALL):
        for line in block[1].splitlines():
            line = line.removeprefix("$ ") if block[0] == "console" else line
            is_call = line.startswith("mkdir ") or (
                line.startswith(("kinestat ", "sed ")) and "kinestat " in line)
            if is_call and (block[0] == "sh" or f"$ {line}" in block[1]):
                commands.append(line)
    return commands


def versions() -> list[tuple[str, str, list[str]]]:
    """The versions of CHANGELOG.md that have a date, and the words of a Debian changelog for each."""
    text = ROOT.joinpath("CHANGELOG.md").read_text(encoding="utf-8")
    text = re.sub(r"^### (.*)$", r"[ \1 ]", text, flags=re.MULTILINE)
    text = re.sub(r"^- ", "* ", text, flags=re.MULTILINE)
    return [(version, date, words.split()) for version, date, words in
            re.findall(r"^## (\S+) - (\S+)\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)]


class Made:
    """The packages, made once: the Debian ones by name, and the archive."""

    folder: Path
    debs: dict[str, Path]
    archive: Path


def setUpModule() -> None:
    Made.folder = Path(tempfile.mkdtemp(prefix="kinestat-package."))
    unittest.addModuleCleanup(shutil.rmtree, Made.folder)
    generators = "DEB;TGZ" if shutil.which("dpkg-deb") else "TGZ"
    start = time.monotonic()
    made = run([options.cpack, "--config", str(options.build / "CPackConfig.cmake"),
                "-G", generators, "-B", str(Made.folder / "made")], cwd=Made.folder)
    print(f"packages made in {time.monotonic() - start:.1f} s", file=sys.stderr)
    if made.returncode != 0:
        raise AssertionError(made.stdout + made.stderr)
    (Made.archive,) = (Made.folder / "made").glob("*.tar.gz")
    Made.debs = {file.name.split("_")[0]: file for file in (Made.folder / "made").glob("*.deb")}


def field(package: str, name: str) -> str:
    return run(["dpkg-deb", "--field", str(Made.debs[package]), name]).stdout.strip()


def unpacked_debs() -> Path:
    """A folder with what is in all Debian packages."""
    if not Made.debs:
        raise unittest.SkipTest("dpkg is not installed")
    root = Path(tempfile.mkdtemp(dir=Made.folder))
    for deb in Made.debs.values():
        run(["dpkg-deb", "--extract", str(deb), str(root)])
    return root


def unpacked_archive() -> Path:
    """The archive, unpacked into a folder whose name has a space; the folder in it."""
    place = Path(tempfile.mkdtemp(prefix="a place ", dir=Made.folder))
    with tarfile.open(Made.archive) as archive:
        archive.extractall(place)
    (top,) = place.iterdir()
    return top


class Packages(unittest.TestCase):
    def use(self, program: Path, data: Path, zsh: str) -> None:
        """Runs what the README shows, with the installed program and files alone."""
        for name in FILES:
            self.assertTrue((data / name).is_file(), name)
        for name, text in SHELL_FILES.items():
            file = data.parent / name
            content = gzip.decompress(file.read_bytes()) if file.suffix == ".gz" else file.read_bytes()
            self.assertIn(text, content, name)
        self.assertEqual([str(file.relative_to(data.parent / "zsh"))
                          for file in data.parent.glob("zsh/*/*")], [zsh])
        pages = {page.name.split(".")[0] for page in (data.parent / "man/man1").iterdir()}
        told = run([program, "--help"]).stdout.partition("\nCommands:\n")[2]
        commands = re.findall(r"^  (\S+)", told.partition("\nOptions:\n")[0], re.MULTILINE)
        self.assertEqual(pages, {"kinestat", *(f"kinestat-{name}" for name in commands)})
        with tempfile.TemporaryDirectory(dir=Made.folder) as work:
            (Path(work) / "mechanisms").symlink_to(data / "mechanisms")
            env = {"PATH": f"{program.parent}:/usr/bin:/bin", "HOME": work, "LC_ALL": "C"}
            commands = readme_commands()
            self.assertGreater(len(commands), 6)
            ended = {}
            for command in commands:
                if "teeth." in command or " FILE" in command or "sweep " in command:
                    continue  # files of the reader, and minutes of work
                done = run(["bash", "-c", command], env=env, cwd=work)
                ended[command] = done.returncode
                self.assertIn(done.returncode, (0, 3), f"{command}\n{done.stderr}")
                self.assertEqual(done.returncode == 3, command.startswith("sed"), command)
            self.assertIn("kinestat analyze crank.yaml", ended)
            self.assertTrue((Path(work) / "crank.yaml").is_file())

    def installed(self) -> Path:
        if not Made.debs:
            self.skipTest("dpkg is not installed")
        root = Path(tempfile.mkdtemp(dir=Made.folder))
        for name in ("info", "updates"):
            (root / "var/lib/dpkg" / name).mkdir(parents=True)
        (root / "var/lib/dpkg/status").touch()
        (root / "var/lib/dpkg/available").touch()
        return root

    def dpkg(self, root: Path, *words: str) -> None:
        done = run(["dpkg", f"--root={root}", "--force-not-root", "--force-bad-path",
                    *([] if options.static else ["--force-depends"]), *words],
                   env=os.environ | {"PATH": f"/usr/sbin:/sbin:{os.environ['PATH']}"})
        if done.returncode != 0 and os.geteuid() != 0:
            self.skipTest(f"dpkg needs root here: {done.stderr.strip()}")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_package_in_an_empty_root(self) -> None:
        root = self.installed()
        before = tree(root)
        start = time.monotonic()
        self.dpkg(root, "--install", str(Made.debs["kinestat"]))
        program = root / "usr/bin/kinestat"
        data = root / "usr/share/kinestat"
        if options.static and os.geteuid() == 0:
            # There is nothing but the package: no shell, no library, no /dev, no /proc.
            (root / "out").mkdir()
            file = "/usr/share/kinestat/mechanisms/transmissions/ravigneaux.yaml"
            for words in (["analyze", "--out", "/out"], ["report", "--out", "/out/page.html"]):
                done = run(["chroot", str(root), "/usr/bin/kinestat", *words, file])
                self.assertEqual((done.returncode, done.stderr), (0, ""), words)
            print(f"installed, report and page in {time.monotonic() - start:.2f} s",
                  file=sys.stderr)
            self.assertIn("</html>", (root / "out/page.html").read_text(encoding="utf-8"))
            shutil.rmtree(root / "out")
        self.use(program, data, "vendor-completions/_kinestat")
        self.dpkg(root, "--purge", "kinestat")
        self.assertEqual(tree(root), before)

    def test_archive_in_any_folder(self) -> None:
        top = unpacked_archive()
        self.use(top / "bin/kinestat", top / "share/kinestat", "site-functions/_kinestat")

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_completes_from_the_archive_as_the_readme_says(self) -> None:
        told, = re.findall(r"`(fpath=.*?)`", ROOT.joinpath("README.md").read_text(encoding="utf-8"))
        home = unpacked_archive()
        home.rename(home.parent / ".local")
        begin = "autoload -Uz compinit; compinit -D -u; print -r - $_comps[kinestat]"
        done = run(["zsh", "-f", "-c", f"{told}; {begin}"], env={**os.environ, "HOME": str(home.parent)})
        self.assertEqual((done.stdout, done.stderr), ("_kinestat\n", ""))

    def test_package_is_small(self) -> None:
        for package in (*Made.debs.values(), Made.archive):
            print(f"{package.name}: {package.stat().st_size} bytes", file=sys.stderr)
        for deb in Made.debs.values():  # gzip packs a program by a fifth less
            self.assertLessEqual(deb.stat().st_size, LARGEST, deb.name)

    def test_program_needs_no_other_file(self) -> None:
        if not options.static or not shutil.which("readelf"):
            self.skipTest("this build shares libraries, or readelf is not installed")
        program = str(options.build / "app/kinestat")
        headers = run(["readelf", "-ldW", program]).stdout
        self.assertNotIn("INTERP", headers)
        self.assertNotIn("(NEEDED)", headers)
        self.assertIn("DYN (Position-Independent Executable file)", headers)

    def test_packages_need_each_other_and_little_else(self) -> None:
        if not Made.debs:
            self.skipTest("dpkg is not installed")
        same = f"libkinestat0 (= {field('kinestat', 'Version')})"
        if options.static:
            self.assertEqual(field("kinestat", "Depends"), "")
        self.assertEqual(re.findall(r"([^ ,]+) \(", field("libkinestat0", "Depends")),
                         ["libc6", "libgmp10", "libmpfr6"])
        self.assertEqual(field("libkinestat-dev", "Depends"), same)
        self.assertEqual(field("python3-kinestat", "Depends"), f"python3:any (>= 3.9), {same}")

    def test_no_file_is_younger_than_the_version(self) -> None:
        """So that packages of two builds have the same bytes, and none has the name of who built it."""
        dates = {version: date for version, date, _ in versions()}
        epoch = int(os.environ.get("SOURCE_DATE_EPOCH") or datetime.fromisoformat(
            max(dates.values())).replace(tzinfo=timezone.utc).timestamp())
        with tarfile.open(Made.archive) as archive:
            self.assertEqual({member.mtime for member in archive}, {epoch})
        for name, deb in Made.debs.items():
            for what in ("--fsys-tarfile", "--ctrl-tarfile"):
                content = subprocess.run(["dpkg-deb", what, str(deb)], capture_output=True, check=True)
                with tarfile.open(fileobj=io.BytesIO(content.stdout)) as archive:
                    self.assertEqual({(member.mtime, member.uid, member.gid) for member in archive},
                                     {(epoch, 0, 0)}, f"{name} {what}")

    def test_copyrights_name_what_others_wrote(self) -> None:
        ours = ROOT.joinpath("LICENSE").read_text(encoding="utf-8")
        noted = (options.build / "packaging/copyright").read_text(encoding="utf-8")
        root = unpacked_debs()
        for name in Made.debs:
            file = root / f"usr/share/doc/{name}/copyright"
            is_own = name.startswith(("python3-", "libkinestat-dev"))
            self.assertEqual(file.read_text(encoding="utf-8"), ours if is_own else noted, name)
        doc = unpacked_archive() / "share/doc/kinestat"
        self.assertEqual((doc / "copyright").read_text(encoding="utf-8"), noted)
        for licence in ("LGPL-3", "LGPL-2.1", "GPL-3", "MPL-2.0"):
            self.assertTrue((doc / "licences" / licence).is_file(), licence)

    def test_changelogs_say_what_that_of_the_project_says(self) -> None:
        root = unpacked_debs()
        for name in Made.debs:
            file = root / f"usr/share/doc/{name}/changelog.gz"
            entries = re.findall(r"^kinestat \((\S+)\) [^\n]*\n(.*?)^ -- [^\n]*>  ([^\n]*)\n",
                                 gzip.decompress(file.read_bytes()).decode(), re.MULTILINE | re.DOTALL)
            told = [(version, parsedate_to_datetime(date).date().isoformat(), text.split())
                    for version, text, date in entries]
            self.assertEqual(told, versions(), name)

    def test_lintian_finds_no_error_and_no_warning(self) -> None:
        if not Made.debs or not shutil.which("lintian"):
            self.skipTest("lintian is not installed")
        done = run(["lintian", "--allow-root", "--fail-on", "error,warning",
                    *map(str, Made.debs.values())])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class Version(unittest.TestCase):
    def test_is_the_same_everywhere(self) -> None:
        (version, date, _), *_ = versions()
        self.assertEqual(run([str(options.build / "app/kinestat"), "--version"]).stdout,
                         f"kinestat {version}\n")
        citation = ROOT.joinpath("CITATION.cff").read_text(encoding="utf-8")
        self.assertIn(f"\nversion: {version}\ndate-released: {date}\n", citation)


class PackagedLibrary(LibraryCase, unittest.TestCase):
    """Of the Debian packages, unpacked: it needs others, which an empty root has not."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.cmake = options.cmake
        cls.prefix = unpacked_debs() / "usr"


class ArchivedLibrary(LibraryCase, unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.cmake = options.cmake
        cls.prefix = unpacked_archive()


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--cpack", required=True)
    parser.add_argument("--cmake", required=True)
    parser.add_argument("--static", action="store_true")
    options, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
