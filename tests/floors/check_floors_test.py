"""check_floors.py finds each kind of wrong include in a small test tree."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = pathlib.Path(sys.argv.pop())


def check(files):
    """Returns exit status and output of the checker for a tree of {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            file = pathlib.Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        run = subprocess.run([sys.executable, CHECKER, folder], capture_output=True, text=True)
        return run.returncode, run.stdout


class CheckFloors(unittest.TestCase):
    def assert_refused(self, path, text, also=()):
        status, output = check({path: text, **dict.fromkeys(also, "")})
        self.assertEqual(status, 1, output)
        self.assertIn(f"{path}:{text.count(chr(10)) + 1}: ", output)

    def assert_accepted(self, path, text, also=()):
        status, output = check({path: text, **dict.fromkeys(also, "")})
        self.assertEqual(status, 0, output)

    def test_own_and_lower_floors_are_accepted(self):
        self.assert_accepted("src/pose/a.cpp", '#include "pose/b.hpp"', ["src/pose/b.hpp"])
        self.assert_accepted("src/pose/a.cpp", '#include "base/b.hpp"', ["src/base/b.hpp"])
        self.assert_accepted("src/pose/a.cpp", "#include <vector>\n#include <pelt/pose.hpp>")
        self.assert_accepted("scenes/a.cpp", "#include <nlohmann/json.hpp>")

    def test_higher_floors_are_refused_with_their_line(self):
        self.assert_refused("src/base/a.hpp", '#pragma once\n\n#include "geometry/b.hpp"',
                            ["src/geometry/b.hpp"])
        self.assert_refused("scenes/a.cpp", '  # include "tools/pelt/b.hpp"',
                            ["tools/pelt/b.hpp"])

    def test_the_product_includes_no_evaluation(self):
        for path in ("src/collide/a.cpp", "scenes/a.cpp", "bindings/a.cpp", "paper/a.cpp",
                     "tools/pelt/methods/a.cpp", "tools/pelt/verbs/a.cpp"):
            self.assert_refused(path, '#include "evaluation/rivals/b.hpp"',
                                ["evaluation/rivals/b.hpp"])

    def test_the_methods_of_the_command_include_the_papers_system(self):
        self.assert_accepted("tools/pelt/methods/a.cpp", '#include "paper/b.hpp"', ["paper/b.hpp"])
        for path in ("src/collide/a.cpp", "scenes/a.cpp", "bindings/a.cpp", "tools/pelt/verbs/a.cpp"):
            self.assert_refused(path, '#include "paper/b.hpp"', ["paper/b.hpp"])

    def test_the_papers_system_includes_few_folders(self):
        self.assert_accepted("paper/a.cpp", '#include "skin/b.hpp"', ["src/skin/b.hpp"])
        self.assert_refused("paper/a.cpp", '#include "pose/b.hpp"', ["src/pose/b.hpp"])
        self.assert_refused("paper/a.cpp", '#include "asset/b.hpp"', ["asset/b.hpp"])

    def test_evaluation_includes_what_is_listed_for_it(self):
        self.assert_accepted("evaluation/rivals/a.cpp", '#include "paper/b.hpp"',
                             ["paper/b.hpp"])
        self.assert_refused("evaluation/rivals/a.cpp", '#include "tools/pelt/output/b.hpp"',
                            ["tools/pelt/output/b.hpp"])

    def test_tests_include_anything(self):
        self.assert_accepted("tests/a.cpp", '#include "evaluation/rivals/b.hpp"',
                             ["evaluation/rivals/b.hpp"])
        self.assert_accepted("tests/a.cpp", '#include "self/b.hpp"', ["src/self/b.hpp"])

    def test_rooms_are_entered_through_their_doors(self):
        self.assert_accepted("src/crowd/a.cpp", '#include "self/self_tree.hpp"',
                             ["src/self/self_tree.hpp"])
        self.assert_accepted("src/self/a.cpp", '#include "self/b.hpp"', ["src/self/b.hpp"])
        for path in ("src/crowd/a.cpp", "tools/pelt/verbs/a.cpp", "evaluation/rivals/a.cpp"):
            self.assert_refused(path, '#include "self/b.hpp"', ["src/self/b.hpp"])

    def test_evaluation_sees_the_stages_that_it_measures(self):
        stage = ["src/self/grid_boxes.hpp"]
        self.assert_accepted("evaluation/rivals/a.cpp", '#include "self/grid_boxes.hpp"', stage)
        self.assert_refused("src/crowd/a.cpp", '#include "self/grid_boxes.hpp"', stage)

    def test_the_reader_knows_the_core_by_its_public_headers(self):
        self.assert_refused("asset/a.cpp", '#include "model/b.hpp"', ["src/model/b.hpp"])

    def test_public_headers_stand_on_public_headers_and_the_standard_library(self):
        self.assert_refused("include/pelt/a.hpp", '#include "base/b.hpp"', ["src/base/b.hpp"])
        self.assert_refused("include/pelt/a.hpp", "#include <nlohmann/json.hpp>")
        self.assert_refused("src/geometry/a.cpp", "#include <immintrin.h>")

    def test_a_file_that_does_not_exist_is_refused(self):
        self.assert_refused("src/base/a.hpp", '#include "base/missing.hpp"')

    def test_an_empty_tree_is_refused(self):
        self.assertEqual(check({})[0], 1)


if __name__ == "__main__":
    unittest.main()
