"""Pelt configures with any set of installed packages: configure_test.py SOURCE CMAKE COMPILER.

Each test hides packages from CMake, configures in a scratch folder, and looks at the targets that
exist and at the lines that name what was left out.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

COMPILER, CMAKE, SOURCE = sys.argv.pop(), sys.argv.pop(), pathlib.Path(sys.argv.pop()).resolve()

# Hides each Debian package. CMake treats an empty path as a search that found nothing.
HIDDEN = {
    "nlohmann-json3-dev": ["-DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON"],
    "libmeshoptimizer-dev": ["-DPELT_MESHOPTIMIZER="],
    "libcli11-dev": ["-DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON"],
    "pkg-config": ["-DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON"],
    "libgtest-dev": ["-DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON"],
    "libcgal-dev": ["-DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON"],
    "libgmp-dev": ["-DPELT_GMP=", "-DPELT_GMPXX="],
    "gnuplot-nox": ["-DPELT_PROGRAM_gnuplot="],
    "povray": ["-DPELT_PROGRAM_povray="],
    "nodejs": ["-DPELT_PROGRAM_node="],
    "npm": ["-DPELT_PROGRAM_npm="],
    "pybind11-dev": ["-DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON"],
}
EVALUATION_AND_TESTS = ["libcgal-dev", "libgtest-dev", "gnuplot-nox", "npm"]
LIBRARY, READER, COMMAND = "pelt", "pelt_asset", "pelt_command"
TEST, GMP_TEST, CGAL_TEST = "collide_test", "predicates_test", "triangle_pair_cgal_test"
LAB = "pelt_lab"


class Configured:
    """One configuration: exit status, targets by name, and the lines that Pelt printed."""

    def __init__(self, hidden, options=(), preset=None, source=SOURCE):
        with tempfile.TemporaryDirectory() as folder:
            query = pathlib.Path(folder, ".cmake/api/v1/query/codemodel-v2")
            query.parent.mkdir(parents=True)
            query.touch()
            words = [CMAKE, "-S", str(source), "-B", folder, f"-DCMAKE_CXX_COMPILER={COMPILER}"]
            words += ["--preset", preset] if preset else ["-G", "Ninja"]
            words += [option for package in hidden for option in HIDDEN[package]]
            run = subprocess.run(words + list(options), cwd=source, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.status, self.printed = run.returncode, run.stdout
            self.words = " ".join(run.stdout.split())  # CMake wraps error messages
            self.lines = [line for line in run.stdout.splitlines() if line.startswith("-- Pelt: ")]
            self.targets = set()
            for model in pathlib.Path(folder).glob(".cmake/api/v1/reply/codemodel-v2-*.json"):
                targets = json.loads(model.read_text())["configurations"][0]["targets"]
                self.targets = {target["name"] for target in targets}


class Configure(unittest.TestCase):
    def configure(self, *arguments, **options):
        configured = Configured(*arguments, **options)
        self.assertEqual(configured.status, 0, configured.printed)
        return configured

    def assert_left_out(self, configured, *packages):
        """For each part that is left out, one line names the package to install."""
        for package in packages:
            naming = [line for line in configured.lines if f"install {package}" in line]
            self.assertEqual(len(naming), 1, (package, configured.lines))

    def test_demo_needs_nothing_of_the_tests_and_the_evaluation(self):
        configured = self.configure(EVALUATION_AND_TESTS, preset="demo")
        self.assertLessEqual({LIBRARY, READER, COMMAND}, configured.targets)
        self.assertFalse({TEST, LAB, "pelt_rivals", "pelt_reproduce", "hello_pelt"} &
                         configured.targets)
        self.assertEqual(configured.lines, [])

    def test_library_alone(self):
        configured = self.configure(EVALUATION_AND_TESTS, ["-DPELT_BUILD_ASSET=OFF"])
        self.assertIn(LIBRARY, configured.targets)
        self.assertFalse({READER, COMMAND, TEST} & configured.targets)

    def test_command_alone(self):
        configured = self.configure(EVALUATION_AND_TESTS, ["-DPELT_BUILD_EVALUATION=OFF"])
        self.assertLessEqual({LIBRARY, READER, COMMAND}, configured.targets)
        self.assertFalse({TEST, LAB} & configured.targets)

    def test_tests_without_the_evaluation(self):
        configured = self.configure([], ["-DPELT_BUILD_EVALUATION=OFF"])
        self.assertLessEqual({LIBRARY, READER, COMMAND, TEST}, configured.targets)
        self.assertFalse({LAB, "pelt_rivals", "rivals_test"} & configured.targets)

    def test_everything(self):
        configured = self.configure([])
        self.assertLessEqual({LIBRARY, READER, COMMAND, LAB, TEST, GMP_TEST, CGAL_TEST},
                             configured.targets)

    def test_without_json_or_meshoptimizer_there_is_the_library(self):
        for package in ("nlohmann-json3-dev", "libmeshoptimizer-dev"):
            configured = self.configure([package])
            self.assertIn(LIBRARY, configured.targets)
            self.assertIn("plain_arrays", configured.targets)
            self.assertFalse({READER, COMMAND, TEST, "hello_pelt"} & configured.targets)
            self.assert_left_out(configured, package)

    def test_without_what_the_command_needs_there_is_the_reader(self):
        configured = self.configure(["libcli11-dev"])
        self.assertIn(READER, configured.targets)
        self.assertFalse({COMMAND, TEST} & configured.targets)
        self.assert_left_out(configured, "libcli11-dev")

    def test_without_pybind11_there_is_no_python_package(self):
        configured = self.configure(["pybind11-dev"])
        self.assertLessEqual({COMMAND, TEST}, configured.targets)
        self.assertNotIn("pelt_python", configured.targets)
        self.assert_left_out(configured, "pybind11-dev")

    def test_without_googletest_there_are_no_tests(self):
        configured = self.configure(["libgtest-dev"])
        self.assertIn(COMMAND, configured.targets)
        self.assertNotIn(TEST, configured.targets)
        self.assert_left_out(configured, "libgtest-dev")

    def test_without_cgal_or_gmp_there_are_the_other_tests(self):
        configured = self.configure(["libcgal-dev"])
        self.assertLessEqual({TEST, GMP_TEST}, configured.targets)
        self.assertNotIn(CGAL_TEST, configured.targets)
        self.assert_left_out(configured, "libcgal-dev")
        configured = self.configure(["libgmp-dev"])
        self.assertIn(TEST, configured.targets)
        self.assertFalse({GMP_TEST, CGAL_TEST} & configured.targets)

    def test_packages_are_searched_in_one_place(self):
        """Nothing below tests/ and tools/ searches again, under names that HIDDEN does not know."""
        lists = [path for folder in ("tests", "tools", "asset", "scenes", "src")
                 for path in (SOURCE / folder).rglob("CMakeLists.txt")]
        self.assertGreater(len(lists), 30)
        searching = [str(path) for path in lists
                     if re.search(r"find_(library|path|program)\(", path.read_text())]
        self.assertEqual(searching, [])

    def test_unknown_test_folders_are_errors(self):
        configured = Configured([], ["-DPELT_BUILD_TESTS=ON", "-DPELT_TEST_FOLDERS=collide;colide"])
        self.assertNotEqual(configured.status, 0)
        self.assertIn("tests/colide is not one of the test folders", configured.words)

    def test_the_tests_of_the_library_are_one_choice(self):
        configured = Configured([], ["-DPELT_BUILD_TESTS=ON", "-DPELT_TEST_FOLDERS=library"])
        self.assertEqual(configured.status, 0, configured.words)
        self.assertIn("collide_test", configured.targets)
        self.assertNotIn("tools_test", configured.targets)

    def test_missing_programs_are_named(self):
        programs = ("gnuplot-nox", "povray", "nodejs", "npm")
        configured = self.configure(programs)
        self.assertIn(TEST, configured.targets)
        self.assert_left_out(configured, *programs)

    def test_what_was_asked_for_is_not_left_out(self):
        for package, option in (("libcgal-dev", "TESTS"), ("libgtest-dev", "TESTS"),
                                ("libcli11-dev", "TOOLS"), ("nlohmann-json3-dev", "ASSET")):
            configured = Configured([package], [f"-DPELT_BUILD_{option}=ON"])
            self.assertNotEqual(configured.status, 0, package)
            self.assertIn(f"install {package}", configured.words)

    def test_the_packages_of_an_absent_feature_are_named(self):
        for option in ("TOOLS", "EVALUATION", "PYTHON"):
            configured = Configured(["libmeshoptimizer-dev"], [f"-DPELT_BUILD_{option}=ON"])
            self.assertNotEqual(configured.status, 0, option)
            self.assertRegex(configured.words, r"needs PELT_BUILD_\w+; install libmeshoptimizer-dev\)")
        configured = Configured([], ["-DPELT_BUILD_ASSET=OFF", "-DPELT_BUILD_TOOLS=ON"])
        self.assertNotEqual(configured.status, 0)
        self.assertIn("(needs PELT_BUILD_ASSET)", configured.words)

    def test_missing_peers_are_errors(self):
        for package in ("libcgal-dev", "pkg-config"):
            configured = Configured([package], ["-DPELT_BENCH_PEERS=ON"])
            self.assertNotEqual(configured.status, 0, package)
            self.assertIn("run scripts/install-deps peers", configured.words)

    def test_a_project_gets_the_reader_on_request(self):
        project = SOURCE / "tests/consumer/project"
        options = [f"-DPELT_SOURCE={SOURCE}", f"-DEXAMPLES={SOURCE / 'docs/examples'}"]
        configured = self.configure(EVALUATION_AND_TESTS, options, source=project)
        self.assertLessEqual({LIBRARY, READER, "hello_pelt"}, configured.targets)
        self.assertFalse({COMMAND, TEST} & configured.targets)
        configured = Configured(["nlohmann-json3-dev"], options, source=project)
        self.assertNotEqual(configured.status, 0)
        self.assertIn("install nlohmann-json3-dev", configured.words)


if __name__ == "__main__":
    unittest.main()
