"""check_layers.py finds each kind of violation in a tree that is otherwise clean."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_layers.py"

CLEAN = {
    "lib/core/types.hpp": (
        "// Names.\n#pragma once\n#include <Eigen/Core>\n#include <Eigen/Geometry>\n"
    ),
    "lib/core/tolerance.hpp": "// Tolerances.\n#pragma once\nconstexpr double kGap = 1e-9;\n",
    "lib/CMakeLists.txt": (
        "kinestat_module(core LINKS Eigen3::Eigen)\n"
        "kinestat_module(math DEPENDS core)\n"
        "kinestat_module(expression)\n"
        "kinestat_module(io)\n"
        "kinestat_module(graph)\n"
        "kinestat_module(screw\n  DEPENDS math\n  LINKS x)\n"
        "kinestat_module(studies/motion DEPENDS screw)\n"
        "kinestat_module(studies/motion/report DEPENDS studies/motion)\n"
    ),
    "lib/math/rank.hpp": (
        '// Ranks.\n#pragma once\n#include <Eigen/QR>\n#include "core/types.hpp"\n'
    ),
    "lib/math/internal/pivot.hpp": "// Pivots.\n#pragma once\n",
    "lib/math/rank.cpp": (
        '#include "math/rank.hpp"\n#include "math/internal/pivot.hpp"\n'
        "// 1e-9 and std::cout, exit(1) are words here\n"
        "const char* text = \"exit(1) 1e-9\"; const char* raw = R\"x(\n#include <iostream>\n)x\";\n"
        "int large = 1'000'000; double m = 1e3; void f() { state.exit(); }\n"
    ),
    "lib/screw/twist.hpp": '// Twists.\n#pragma once\n#include "math/rank.hpp"\n',
    "lib/studies/motion/path.hpp": '// Paths.\n#pragma once\n#include "screw/twist.hpp"\n',
    "lib/studies/motion/report/text.cpp": '#include "studies/motion/path.hpp"\n',
    "lib/expression/units.cpp": "double mm = 1e-3;\n",
    "lib/io/yaml_tree.cpp": "#include <yaml-cpp/yaml.h>\n#include <sys/stat.h>\n",
    "app/command.hpp": "// A command.\n#pragma once\n",
    "app/main.cpp": '#include <CLI/CLI.hpp>\n#include <iostream>\n#include "command.hpp"\n',
}
HEADER = "// A noun.\n#pragma once\n"


def check(files: dict[str, str]) -> tuple[int, str]:
    """Status and output of the script for the clean tree with some files replaced or added."""
    with tempfile.TemporaryDirectory() as root:
        for name, text in (CLEAN | files).items():
            path = Path(root) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        command = [sys.executable, str(SCRIPT), "--root", root]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


class CheckLayers(unittest.TestCase):
    def assert_found(self, path: str, text: str, *violations: str) -> None:
        status, output = check({path: text})
        self.assertEqual(sorted(output.splitlines()), sorted(violations))
        self.assertEqual(status, 1)

    def test_a_clean_tree_passes(self) -> None:
        self.assertEqual(check({}), (0, "all layers hold\n"))

    def test_an_include_that_the_table_does_not_allow(self) -> None:
        self.assert_found(
            "lib/graph/tree.cpp", '#include "screw/twist.hpp"\n',
            "lib/graph/tree.cpp:1: graph may not include screw",
        )

    def test_an_app_that_reaches_below_run(self) -> None:
        self.assert_found(
            "app/x.cpp", '\n#include "math/rank.hpp"\n', "app/x.cpp:2: app may not include math"
        )

    def test_an_include_relative_to_its_own_folder(self) -> None:
        self.assert_found(
            "lib/math/newton.cpp", '#include "rank.hpp"\n',
            'lib/math/newton.cpp:1: "rank.hpp" is not written from lib/ on, '
            'as in "screw/twist.hpp"',
        )

    def test_an_internal_header_of_another_module(self) -> None:
        self.assert_found(
            "lib/screw/pose.cpp", '#include "math/internal/pivot.hpp"\n',
            "lib/screw/pose.cpp:1: math/internal/pivot.hpp is internal to math",
        )

    def test_yaml_outside_io(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "#include <yaml-cpp/yaml.h>\n",
            "lib/math/a.cpp:1: math may not include <yaml-cpp/yaml.h>",
        )

    def test_json_outside_report(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "#include <nlohmann/json.hpp>\n",
            "lib/math/a.cpp:1: math may not include <nlohmann/json.hpp>",
        )

    def test_the_command_line_library_outside_app(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "#include <CLI/CLI.hpp>\n",
            "lib/math/a.cpp:1: math may not include <CLI/CLI.hpp>",
        )

    def test_matrices_that_do_not_come_through_types(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "#include <Eigen/Dense>\n",
            'lib/math/a.cpp:1: <Eigen/Dense> comes through "core/types.hpp"',
        )

    def test_a_decomposition_outside_math(self) -> None:
        self.assert_found(
            "lib/screw/a.cpp", "#include <Eigen/SVD>\n",
            "lib/screw/a.cpp:1: screw may not include <Eigen/SVD>",
        )

    def test_a_library_that_nobody_decided_on(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "#include <armadillo/mat.h>\n",
            "lib/math/a.cpp:1: <armadillo/mat.h> has no row in THIRD_PARTY",
        )

    def test_a_stream_header_in_the_library(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "#include <iostream>\n",
            "lib/math/a.cpp:1: the library never prints: iostream",
        )

    def test_printing(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "/* one\n */ void f() { std::cout << 1; printf(\"\"); }\n",
            "lib/math/a.cpp:2: the library never prints: printf",
            "lib/math/a.cpp:2: the library never prints: std::cout",
        )

    def test_exiting(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "void f() { std::exit(1); }\n",
            "lib/math/a.cpp:1: the library never exits: exit",
        )

    def test_the_environment(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", 'auto x = std::getenv("X");\n',
            "lib/math/a.cpp:1: the library never reads the environment: getenv",
        )

    def test_the_clock(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "auto t = std::chrono::steady_clock::now();\n",
            "lib/math/a.cpp:1: the library never reads the clock: steady_clock",
        )

    def test_a_tolerance_without_a_name(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "bool f(double x) {\n  return x < 1.5E-9;\n}\n",
            "lib/math/a.cpp:2: the tolerance 1.5E-9 wants a name in core/tolerance.hpp",
        )

    def test_a_long_header(self) -> None:
        self.assert_found(
            "lib/math/a.hpp", HEADER + "\n" * 149,
            "lib/math/a.hpp:151: 151 lines, above the limit of 150",
        )

    def test_a_long_source(self) -> None:
        self.assert_found(
            "lib/math/a.cpp", "\n" * 501, "lib/math/a.cpp:501: 501 lines, above the limit of 500"
        )

    def test_a_header_without_its_first_comment(self) -> None:
        self.assert_found(
            "lib/math/a.hpp", "#pragma once\n",
            "lib/math/a.hpp:1: the first line is no comment saying what the header is",
        )

    def test_a_header_without_a_guard(self) -> None:
        self.assert_found(
            "lib/math/a.hpp", "// A noun.\n", "lib/math/a.hpp:1: #pragma once is missing"
        )

    def test_a_module_without_a_row(self) -> None:
        self.assert_found(
            "lib/utilities/notes.hpp",
            HEADER,
            "lib/utilities:1: the module has no row in lib/CMakeLists.txt",
        )

    def test_a_study_that_reaches_up_into_its_report(self) -> None:
        self.assert_found(
            "lib/studies/motion/a.cpp", '#include "studies/motion/report/text.hpp"\n',
            "lib/studies/motion/a.cpp:1: studies/motion may not include studies/motion/report",
        )

    def test_a_row_above_what_it_depends_on(self) -> None:
        table = CLEAN["lib/CMakeLists.txt"].replace("(graph)", "(graph DEPENDS screw)")
        self.assert_found(
            "lib/CMakeLists.txt", table,
            "lib/CMakeLists.txt:5: graph depends on screw, which does not stand above it",
        )

    def test_a_row_that_names_more_than_is_included(self) -> None:
        table = CLEAN["lib/CMakeLists.txt"].replace("DEPENDS math\n", "DEPENDS core math\n")
        self.assert_found(
            "lib/CMakeLists.txt", table,
            "lib/CMakeLists.txt:6: screw depends on core and includes nothing of it",
        )

    def test_a_module_that_knows_too_many(self) -> None:
        many = [f"m{i}" for i in range(13)]
        table = CLEAN["lib/CMakeLists.txt"] + "".join(f"kinestat_module({m})\n" for m in many)
        table += f"kinestat_module(all DEPENDS {' '.join(many)})\n"
        files = {f"lib/{m}/a.hpp": HEADER for m in many}
        files["lib/all/a.cpp"] = "".join(f'#include "{m}/a.hpp"\n' for m in many)
        self.assertEqual(
            check(files | {"lib/CMakeLists.txt": table}),
            (1, "lib/CMakeLists.txt:24: all depends on 13 modules, above 12\n"),
        )

    def test_a_full_folder(self) -> None:
        files = {f"lib/graph/a{i}.hpp": HEADER for i in range(41)}
        self.assertEqual(check(files), (1, "lib/graph:1: 41 files, above the limit of 40\n"))


if __name__ == "__main__":
    unittest.main()
