"""scripts/reproduce passes its options on: reproduce_test.py SCRIPT."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv.pop(1))

# Replaces each program that the script runs: records its arguments.
STAND_IN = '#!/bin/sh\nfor word in "${0##*/}" "$@"; do echo "$word"; done >> "$NOTES"\n'


class Reproduce(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name).resolve()
        self.root = self.folder / "clone"
        for program in ("scripts/install-deps", "bin/cmake", "build/release/evaluation/lab/pelt-lab",
                        "build/peers/evaluation/lab/pelt-lab"):
            path = self.root / program
            path.parent.mkdir(parents=True)
            path.write_text(STAND_IN)
            path.chmod(0o755)
        shutil.copy(SCRIPT, self.root / "scripts/reproduce")

    def run_script(self, *words):
        """(exit status, what was printed, the words of the programs that were run)."""
        notes = self.folder / "notes"
        environment = dict(os.environ, NOTES=str(notes),
                           PATH=f"{self.root / 'bin'}:{os.environ['PATH']}")
        done = subprocess.run([self.root / "scripts/reproduce", *words], cwd=self.folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment)
        return done.returncode, done.stdout, notes.read_text().split() if notes.exists() else []

    def command(self, *words):
        """Returns the arguments of the command."""
        status, _, ran = self.run_script(*words)
        self.assertEqual(status, 0)
        return ran[ran.index("pelt-lab"):]

    def test_installs_and_builds_first(self):
        _, printed, ran = self.run_script()
        self.assertEqual(ran[:ran.index("pelt-lab")],
                         ["install-deps", "reproduce", "cmake", "--preset", "release",
                          "-DPELT_BUILD_EVALUATION=ON", "cmake", "--build", "--preset", "release",
                          "--target", "pelt_lab"])
        self.assertEqual(printed, f"look at {self.folder}/pelt-reproduce/report.html\n")

    def test_takes_all_experiments_unless_told(self):
        self.assertEqual(self.command(),
                         ["pelt-lab", "reproduce", "-o", f"{self.folder}/pelt-reproduce"])

    def test_passes_options_on_and_finds_folders_from_where_it_was_called(self):
        self.assertEqual(self.command("--quick", "--models", "some", "--only", "a,b", "report"),
                         ["pelt-lab", "reproduce", "--quick", "--models", f"{self.folder}/some",
                          "--only", "a,b", "-o", f"{self.folder}/report"])

    def test_builds_with_other_libraries_when_asked_for_them(self):
        _, _, ran = self.run_script("--peers")
        self.assertEqual(ran[:4], ["install-deps", "reproduce", "install-deps", "peers"])
        self.assertEqual(ran[4:7], ["cmake", "--preset", "peers"])
        self.assertIn("--peers", ran[ran.index("pelt-lab"):])

    def test_refuses_what_it_does_not_know(self):
        for words in (["--fast"], ["one", "two"], ["--models"]):
            status, printed, ran = self.run_script(*words)
            self.assertEqual((status, ran), (2, []), words)
            self.assertIn("scripts/reproduce [--quick]", printed)

    def test_helps(self):
        status, printed, ran = self.run_script("--help")
        self.assertEqual((status, ran), (0, []))
        self.assertIn("scripts/reproduce [--quick]", printed)


if __name__ == "__main__":
    unittest.main()
