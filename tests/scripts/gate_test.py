"""scripts/test runs the gate, and fails if any part fails: gate_test.py SCRIPTS_FOLDER."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(sys.argv.pop(1))

# Replaces each program that the script runs: records its arguments, and fails if $FAILING names it.
STAND_IN = ('#!/bin/sh\necho "${0##*/} $*" >> "$NOTES"\n'
            'case " $FAILING " in *" ${0##*/} "*) exit 1 ;; esac\n')
PASSED = '<testsuite><testcase name="good" status="run"/></testsuite>'
CTEST = STAND_IN + f"""while [ $# -gt 1 ]; do
  [ "$1" = --output-junit ] && mkdir -p "${{2%/*}}" && echo '{PASSED}' > "$2"
  shift
done
"""


class Gate(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.root = pathlib.Path(holder.name).resolve()
        stand_ins = ("scripts/install-deps", "scripts/build-viewer", "scripts/npm-ci", "scripts/tidy",
                     "scripts/check-alone", "bin/cmake")
        for name, text in {**dict.fromkeys(stand_ins, STAND_IN), "bin/ctest": CTEST}.items():
            path = self.root / name
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
            path.chmod(0o755)
        for script in ("test", "summarise-tests"):
            shutil.copy(SCRIPTS / script, self.root / "scripts" / script)

    def run_script(self, *words, failing="", ci=False):
        """(exit status, what was printed, the lines of the programs that were run)."""
        notes = self.root / "notes"
        notes.unlink(missing_ok=True)
        environment = dict(os.environ, NOTES=str(notes), FAILING=failing,
                           PATH=f"{self.root / 'bin'}:{os.environ['PATH']}")
        environment.pop("CI", None)
        if ci:
            environment["CI"] = "true"
        done = subprocess.run([self.root / "scripts/test", *words], text=True, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return done.returncode, done.stdout, notes.read_text().splitlines() if notes.exists() else []

    def presets_of(self, program, ran):
        return [line[len(program):].split()[0] for line in ran if line.startswith(program)]

    def test_gate_builds_and_tests_each_preset_and_lints(self):
        status, printed, ran = self.run_script("--gate")
        self.assertEqual(status, 0, printed)
        for program in ("cmake --preset", "cmake --build --preset", "ctest --preset"):
            self.assertEqual(self.presets_of(program, ran),
                             ["release", "clang-asan", "tsan", "scalar"], program)
        self.assertLessEqual({"tidy ", "check-alone "}, set(ran))
        for packages in ("test", "clang", "tidy", "browser"):
            self.assertIn(f"install-deps {packages}", ran)
        self.assertIn("[5/5] lint: clang-tidy", printed)
        self.assertIn("scripts/test: 4 passed, 0 failed, 0 skipped", printed)

    def test_without_arguments_the_release_build_is_tested(self):
        status, printed, ran = self.run_script()
        self.assertEqual(status, 0, printed)
        self.assertEqual(self.presets_of("ctest --preset", ran), ["release"])
        self.assertIn("[1/1] release: testing", printed)
        self.assertIn("--label-exclude gate", next(line for line in ran if line.startswith("ctest")))
        self.assertIn("scripts/test: 1 passed, 0 failed, 0 skipped", printed)

    def test_tests_are_never_left_out(self):
        _, _, ran = self.run_script("--all")
        configured = [line for line in ran if line.startswith("cmake --preset")]
        self.assertEqual(len(configured), 8)
        self.assertTrue(all("-DPELT_BUILD_TESTS=ON" in line for line in configured), configured)
        self.assertNotIn("--label-exclude", " ".join(ran))

    def test_peers_are_installed_on_request(self):
        self.assertIn("install-deps peers", self.run_script("peers")[2])
        self.assertNotIn("install-deps peers", self.run_script("--gate")[2])

    def test_one_part_installs_what_it_needs_alone(self):
        status, _, ran = self.run_script("tsan")
        self.assertEqual(status, 0)
        self.assertEqual([line for line in ran if line.startswith("install-deps")],
                         ["install-deps test"])
        self.assertNotIn("build-viewer ", ran)

    def test_a_finding_of_lint_or_a_lost_build_fails(self):
        for program in ("tidy", "check-alone", "cmake"):
            status, printed, _ = self.run_script("--gate", failing=program)
            self.assertNotEqual(status, 0, (program, printed))

    def test_what_npm_cannot_fetch_is_skipped_but_not_in_ci(self):
        status, printed, _ = self.run_script("release", failing="npm-ci build-viewer")
        self.assertEqual(status, 0, printed)
        self.assertIn("scripts/build-viewer failed: its tests will be skipped", printed)
        self.assertNotEqual(self.run_script("release", failing="npm-ci", ci=True)[0], 0)
        self.assertNotEqual(self.run_script("release", failing="build-viewer", ci=True)[0], 0)

    def test_helps_and_refuses(self):
        status, printed, ran = self.run_script("--help")
        self.assertEqual((status, ran), (0, []))
        for part in ("release", "clang-asan", "tsan", "scalar", "lint", "peers"):
            self.assertIn(f"  {part} ", printed)
        self.assertNotEqual(self.run_script("--fast")[0], 0)


if __name__ == "__main__":
    unittest.main()
