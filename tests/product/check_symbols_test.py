"""check_symbols.py finds rivals in a program that links them, and rejects a stripped program.

    check_symbols_test.py CHECKER NM PROGRAM_WITH_RIVALS
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CHECKER, NM, LAB = sys.argv[1:4]


def check(*arguments):
    run = subprocess.run([sys.executable, "-B", CHECKER, *arguments], capture_output=True, text=True)
    return run.returncode, run.stdout


class CheckSymbols(unittest.TestCase):
    def test_rivals_are_found_and_named(self):
        status, output = check(NM, LAB)
        self.assertEqual(status, 1, output)
        for name in ("pelt::lab::", "pelt::rivals::", "pelt::reproduce::"):
            self.assertIn(name, output)

    def test_a_program_without_names_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            stripped = pathlib.Path(folder, "stripped")
            shutil.copy(LAB, stripped)
            subprocess.run(["strip", stripped], check=True)
            status, output = check(NM, stripped)
            self.assertEqual(status, 1, output)
            self.assertIn("0 symbols of Pelt", output)

    def test_a_package_that_was_not_built_is_skipped(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(check("--wasm", NM, folder)[0], 77)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
