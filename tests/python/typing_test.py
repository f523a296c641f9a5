"""mypy accepts the package, its examples, and the stubs of the extension."""

import os
import subprocess
import sys
import tempfile
import unittest

from support import SOURCE, Case, skip_program

if subprocess.run([sys.executable, "-m", "mypy", "--version"], capture_output=True).returncode:
    skip_program("no mypy (package mypy)")

PACKAGE = SOURCE / "bindings" / "python"


class Types(Case):
    def run_clean(self, *arguments):
        with tempfile.TemporaryDirectory() as cache:
            result = subprocess.run([sys.executable, "-m", *map(str, arguments)], text=True,
                                    capture_output=True, cwd=PACKAGE,
                                    env={**os.environ, "MYPY_CACHE_DIR": cache, "MYPYPATH": str(PACKAGE)})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_package_and_examples(self):
        self.run_clean("mypy", "--config-file", SOURCE / "tests" / "python" / "mypy.ini", "pelt",
                       *sorted((PACKAGE / "examples").glob("*.py")))

    def test_stubs_match_the_extension(self):
        """Finds functions and classes that the stubs lack, and the other way round."""
        from pelt import _pelt

        stubs = (PACKAGE / "pelt" / "_pelt.pyi").read_text()
        for name in dir(_pelt):
            if not name.startswith("_"):
                self.assertRegex(stubs, rf"(?m)^(class|def) {name}\b")
        for name in __import__("re").findall(r"(?m)^(?:class|def) (\w+)", stubs):
            self.assertTrue(hasattr(_pelt, name), name)


if __name__ == "__main__":
    unittest.main()
