"""The bill of materials and the copyright file: of what is really in the program, and as SPDX wants it."""

from __future__ import annotations

import argparse
import hashlib
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "packaging/sbom.py"
# What SPDX 2.3 requires (its clauses 6, 7 and 11), and the forms that it gives.
TEXT = {"type": "string", "minLength": 1}
ID = {"type": "string", "pattern": r"^SPDXRef-[a-zA-Z0-9.-]+$"}
URI = {"type": "string", "pattern": r"^(https?|git)[^#\s]*$|^NOASSERTION$|^NONE$"}
LICENCE = {"type": "string", "pattern": r"^[A-Za-z0-9.+-]+( (AND|OR|WITH) [A-Za-z0-9.+-]+)*$"}
SCHEMA = {
    "type": "object",
    "required": ["spdxVersion", "dataLicense", "SPDXID", "name", "documentNamespace", "creationInfo",
                 "packages", "relationships"],
    "additionalProperties": False,
    "properties": {
        "spdxVersion": {"const": "SPDX-2.3"},
        "dataLicense": {"const": "CC0-1.0"},
        "SPDXID": {"const": "SPDXRef-DOCUMENT"},
        "name": TEXT,
        "documentNamespace": {"type": "string", "pattern": r"^https://[^#\s]+$"},
        "creationInfo": {
            "type": "object", "required": ["created", "creators"], "additionalProperties": False,
            "properties": {
                "created": {"type": "string", "pattern": r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$"},
                "creators": {"type": "array", "minItems": 1, "items": {
                    "type": "string", "pattern": r"^(Tool|Organization|Person): \S"}}}},
        "packages": {"type": "array", "minItems": 2, "items": {
            "type": "object",
            "required": ["SPDXID", "name", "versionInfo", "downloadLocation", "filesAnalyzed",
                         "licenseConcluded", "licenseDeclared", "copyrightText"],
            "properties": {
                "SPDXID": ID, "name": TEXT, "versionInfo": TEXT, "downloadLocation": URI, "homepage": URI,
                "filesAnalyzed": {"const": False},
                "licenseConcluded": LICENCE, "licenseDeclared": LICENCE, "copyrightText": TEXT,
                "supplier": {"type": "string", "pattern": r"^(Organization|Person): \S|^NOASSERTION$"},
                "primaryPackagePurpose": {"enum": ["APPLICATION", "LIBRARY"]},
                "externalRefs": {"type": "array", "items": {
                    "type": "object",
                    "required": ["referenceCategory", "referenceType", "referenceLocator"],
                    "properties": {
                        "referenceCategory": {"const": "PACKAGE-MANAGER"},
                        "referenceType": {"const": "purl"},
                        "referenceLocator": {"type": "string", "pattern": r"^pkg:deb/debian/[^@\s+]+[^@\s]*@[^\s:+]+$"}}}}}}},
        "relationships": {"type": "array", "minItems": 2, "items": {
            "type": "object",
            "required": ["spdxElementId", "relationshipType", "relatedSpdxElement"],
            "properties": {
                "relationshipType": {"enum": ["DESCRIBES", "STATIC_LINK", "DYNAMIC_LINK", "CONTAINS"]},
                "spdxElementId": ID, "relatedSpdxElement": ID}}},
    },
}
options = argparse.Namespace()


def module() -> object:
    spec = importlib.util.spec_from_file_location("sbom", SCRIPT)
    assert spec and spec.loader
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    return made


@unittest.skipUnless(shutil.which("dpkg-query") and shutil.which("ninja"), "needs dpkg and ninja")
class Bill(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        done = subprocess.run([sys.executable, "-B", SCRIPT, "--build", options.build],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise AssertionError(done.stderr)
        cls.text = done.stdout
        cls.bill = json.loads(done.stdout)
        cls.by_id = {package["SPDXID"]: package for package in cls.bill["packages"]}

    def related(self, kind: str) -> set[str]:
        return {self.by_id[row["relatedSpdxElement"]]["name"] for row in self.bill["relationships"]
                if row["relationshipType"] == kind}

    def test_has_what_spdx_requires(self) -> None:
        import jsonschema  # pylint: disable=import-outside-toplevel
        jsonschema.validate(self.bill, SCHEMA)

    def test_each_package_has_a_name_of_its_own_and_a_place(self) -> None:
        self.assertEqual(len(self.by_id), len(self.bill["packages"]))
        placed = [row["relatedSpdxElement"] for row in self.bill["relationships"]]
        self.assertEqual(sorted(placed), sorted(self.by_id))

    def test_says_which_program_it_is_of(self) -> None:
        program = self.by_id["SPDXRef-kinestat"]
        content = (options.build / "app/kinestat").read_bytes()
        self.assertEqual(program["checksums"], [
            {"algorithm": "SHA256", "checksumValue": hashlib.sha256(content).hexdigest()}])

    def test_names_every_archive_of_the_link(self) -> None:
        """By the words of the command, which the script does not read."""
        command = subprocess.run(["ninja", "-C", str(options.build), "-t", "commands", "-s", "app/kinestat"],
                                 capture_output=True, text=True, check=True).stdout
        archives = set(re.findall(r"(?<=/)lib([\w-]+)\.a(?= )", command)) & set(
            re.findall(r" /\S*/lib([\w-]+)\.a(?= )", command))
        self.assertGreaterEqual(len(archives), 5 if options.static else 0)
        told = {re.sub(r"\W", "", name.lower()) for name in
                self.related("STATIC_LINK") | self.related("DYNAMIC_LINK")}
        for archive in archives:
            self.assertTrue({archive.replace("-", ""), f"lib{archive}"} & told, archive)
        if options.static:
            self.assertLessEqual({"GNU C Library", "GNU C++ runtime library"}, self.related("STATIC_LINK"))
        self.assertLessEqual({"Boost", "Eigen", "fmt", "CLI11", "JSON for Modern C++", "xxHash"},
                             self.related("CONTAINS"))

    def test_lists_no_library_that_is_not_used(self) -> None:
        listed = {row["name"] for row in module().dependencies()}
        self.assertEqual(listed, {package["name"] for package in self.bill["packages"]} - {"kinestat"})

    def test_versions_are_those_of_the_packages(self) -> None:
        for package in self.bill["packages"][1:]:
            name, version = package["externalRefs"][0]["referenceLocator"].removeprefix(
                "pkg:deb/debian/").split("@")
            shown = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", name], capture_output=True,
                                   text=True, check=True).stdout
            self.assertEqual(version.replace("%3A", ":").replace("%2B", "+"), shown)
            self.assertIn(package["versionInfo"], shown)

    def test_is_the_same_again(self) -> None:
        again = subprocess.run([sys.executable, "-B", SCRIPT, "--build", options.build],
                               capture_output=True, text=True, check=True).stdout
        self.assertEqual(again, self.text)

    def test_refuses_a_library_that_is_not_listed(self) -> None:
        sbom = module()
        rows = [row for row in sbom.dependencies() if row["name"] != "GMP"]
        sbom.dependencies = lambda: rows
        with self.assertRaisesRegex(sbom.Failure, "libgmp"):
            sbom.used(options.build.resolve())


class Copyright(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.text = (options.build / "packaging/copyright").read_text(encoding="utf-8")

    def test_begins_with_our_own(self) -> None:
        self.assertIn(ROOT.joinpath("LICENSE").read_text(encoding="utf-8").strip(), self.text)

    def test_names_every_library_with_its_licence(self) -> None:
        for row in module().dependencies():
            self.assertIn(f"{row['name']} ({row['use']}), {row['site']}\n  Licence: {row['licence']}\n"
                          f"  Copyright: {row['copyright']}\n", self.text)

    def test_has_the_texts_that_are_nowhere_else(self) -> None:
        for row in module().dependencies():
            for name in row["texts"]:
                body = (ROOT / "packaging/licences" / name).read_text(encoding="utf-8").strip()
                self.assertEqual(body in self.text, not re.search("GPL|MPL", name), name)
                if "GPL" in name and Path("/usr/share/common-licenses").is_dir():
                    common = Path("/usr/share/common-licenses", name).read_text(encoding="utf-8")
                    self.assertEqual(body, common.strip())

    def test_leaves_nothing_to_be_filled_in(self) -> None:
        self.assertNotRegex(self.text, r"@[A-Z_]+@|\n\n\n")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--static", action="store_true")
    options, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
