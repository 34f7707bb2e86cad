#!/usr/bin/env python3
"""A bill of materials, SPDX 2.3 as JSON: what others wrote that is in the program of a build.

Usage: sbom.py --build FOLDER [--out FILE]

What is in it the linker and the compiler told: the archives that the last link took something from,
and the headers that sources were compiled with. Names and licences are those of dependencies.json,
versions those of the Debian packages. A file that no library of dependencies.json owns is an error.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PACKAGING = Path(__file__).resolve().parent
PROGRAM = "app/kinestat"
PROJECT_SITE = "https://kinestat.example.org"


class Failure(Exception):
    """Why there is no bill."""


def output(words: list[str], **more: object) -> str:
    done = subprocess.run(words, capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        raise Failure(f"{shlex.join(words)[:200]}: {done.stderr.strip() or done.stdout[-500:]}")
    return done.stdout


def dependencies() -> list[dict]:
    return json.loads((PACKAGING / "dependencies.json").read_text(encoding="utf-8"))


def linked(build: Path) -> set[Path]:
    """The archives, objects and libraries of others that a link of the program reads something from."""
    *_, command = output(["ninja", "-C", str(build), "-t", "commands", "-s", PROGRAM]).splitlines()
    found = re.search(r"&& (.*) && :$", command)
    words = shlex.split(found[1] if found else command)
    with tempfile.TemporaryDirectory() as folder:
        words[words.index("-o") + 1] = f"{folder}/program"
        told = output([*words, "-Wl,--trace"], cwd=build)
    files = set()
    for line in told.splitlines():
        path = Path(build, line.strip().lstrip("(").partition(")")[0])
        if path.is_file() and not path.resolve().is_relative_to(build.resolve()):
            files.add(path.resolve())
    return files


def included(build: Path) -> set[Path]:
    """The headers of others that the sources of the program were compiled with."""
    root = PACKAGING.parent
    files: set[str] = set()
    for part in output(["ninja", "-C", str(build), "-t", "deps"]).split("\n\n"):
        target, *lines = part.splitlines() or [""]
        if target.startswith(("lib/", "app/")):
            files.update(line.strip() for line in lines)
    paths = {Path(build, name).resolve() for name in files}
    return {path for path in paths if path.is_file() and not path.is_relative_to(root)
            and not path.is_relative_to(build.resolve())}


def owners(files: set[Path]) -> dict[str, str]:
    """The Debian packages of files, each with its version."""
    if not files:
        return {}
    names = set()
    for line in output(["dpkg", "-S", *map(str, sorted(files))]).splitlines():
        names.update(name.partition(":")[0].strip() for name in line.rpartition(": ")[0].split(","))
    # A package can be there for several processors.
    told = output(["dpkg-query", "-W", "-f", "${Package} ${Version}\n", *sorted(names)])
    return dict(line.split(" ", 1) for line in told.splitlines())


def used(build: Path) -> list[tuple[dict, dict[str, str], str]]:
    """The libraries that are in the program: the row of each, its packages with versions, and how."""
    by_use = {"static": owners(linked(build)), "headers": owners(included(build))}
    rows = dependencies()
    known = {package for row in rows for package in row["packages"]}
    unknown = {package for packages in by_use.values() for package in packages} - known
    if unknown:
        raise Failure(f"not in packaging/dependencies.json: {', '.join(sorted(unknown))}")
    found = []
    for row in rows:
        for use, packages in by_use.items():
            its = {name: packages[name] for name in row["packages"] if name in packages}
            if its:
                shared = use == "static" and not any(name.endswith("-dev") for name in its)
                found.append((row, its, "shared" if shared else use))
                break
    return found


def project_version(build: Path) -> str:
    return output([str(build / PROGRAM), "--version"]).split()[1]


def created(build: Path) -> str:
    """SOURCE_DATE_EPOCH where it is set, otherwise the date of the packages of this version."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH")
    if epoch is None:
        found = re.search(r'CPACK_KINESTAT_EPOCH "(\d+)"',
                          (build / "CPackConfig.cmake").read_text(encoding="utf-8"))
        epoch = found[1] if found else "0"
    return time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(int(epoch)))


def package(row: dict, packages: dict[str, str]) -> dict:
    (name, version), *_ = packages.items()
    upstream = re.sub(r"^\d+:", "", version).rpartition("-")[0] or version
    return {
        "SPDXID": "SPDXRef-" + re.sub(r"[^a-zA-Z0-9.]+", "-", row["name"].replace("+", "p")),
        "name": row["name"],
        "versionInfo": re.sub(r"\+(dfsg|ds).*$", "", upstream),
        "supplier": "Organization: Debian",
        "downloadLocation": "NOASSERTION",
        "homepage": row["site"],
        "filesAnalyzed": False,
        "licenseConcluded": row["licence"],
        "licenseDeclared": row["licence"],
        "copyrightText": row["copyright"],
        "primaryPackagePurpose": "LIBRARY",
        "externalRefs": [{
            "referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
            "referenceLocator": f"pkg:deb/debian/{name}@{version.replace(':', '%3A').replace('+', '%2B')}",
        }],
    }


def bill(build: Path) -> dict:
    version = project_version(build)
    digest = hashlib.sha256((build / PROGRAM).read_bytes()).hexdigest()
    program = {
        "SPDXID": "SPDXRef-kinestat",
        "name": "kinestat",
        "versionInfo": version,
        "supplier": "Organization: kinestat authors",
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": "MIT",
        "licenseDeclared": "MIT",
        "copyrightText": "2026 the kinestat authors",
        "primaryPackagePurpose": "APPLICATION",
        "checksums": [{"algorithm": "SHA256", "checksumValue": digest}],
    }
    packages = [program]
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", program["SPDXID"])]
    how = {"static": "STATIC_LINK", "shared": "DYNAMIC_LINK", "headers": "CONTAINS"}
    for row, its, use in used(build):
        packages.append(package(row, its))
        relations.append((program["SPDXID"], how[use], packages[-1]["SPDXID"]))
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"kinestat-{version}",
        "documentNamespace": f"{PROJECT_SITE}/spdx/kinestat-{version}-{digest}",
        "creationInfo": {"created": created(build), "creators": ["Tool: kinestat-sbom"]},
        "packages": packages,
        "relationships": [{"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other}
                          for one, kind, other in relations],
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--out", type=Path)
    known = parser.parse_args()
    try:
        text = json.dumps(bill(known.build.resolve()), indent=2, ensure_ascii=False) + "\n"
    except (Failure, OSError) as failure:
        print(f"sbom.py: {failure}", file=sys.stderr)
        return 4
    if known.out:
        known.out.write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
