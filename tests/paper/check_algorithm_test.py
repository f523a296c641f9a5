"""check_algorithm.py finds each kind of error in a test page."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).with_name("check_algorithm.py")


def check(page):
    """Returns exit status and output of the checker for a tree with this page and two files of code."""
    files = {"docs/algorithm.md": page, "paper/a.cpp": "void Alpha::walk_on() {}",
             "paper/b.cpp": "int beta;", "docs/figures/a.svg": "<svg/>"}
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            file = pathlib.Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        run = subprocess.run([sys.executable, CHECKER, folder], capture_output=True, text=True)
        return run.returncode, run.stdout


class CheckAlgorithm(unittest.TestCase):
    def assert_accepted(self, page):
        self.assertEqual(check(page)[0], 0, check(page)[1])

    def assert_refused(self, page, fault):
        status, output = check(page)
        self.assertEqual(status, 1, output)
        self.assertIn(fault, output)

    def test_what_exists_is_accepted(self):
        self.assert_accepted("| eq. 1 | `paper/a.cpp` | `Alpha::walk_on` |\n"
                             "All is in `paper/`, such as `beta` in `paper/b.cpp`.\n"
                             "![A](figures/a.svg)\n")

    def test_missing_files_are_refused(self):
        self.assert_refused("in `paper/c.cpp`", "`paper/c.cpp` does not exist")
        self.assert_refused("`paper/a.cpp` ![B](figures/b.svg)", "`docs/figures/b.svg`")

    def test_missing_names_are_refused(self):
        self.assert_refused("| `paper/a.cpp` | `Alpha::walk` |", "1: `walk` is not in paper/a.cpp")
        self.assert_refused("`paper/a.cpp`\n\nand `gamma`", "3: `gamma` is not in any file")

    def test_a_row_is_held_to_its_own_file(self):
        self.assert_refused("| `paper/a.cpp` | `beta` |\n| `paper/b.cpp` | `beta` |",
                            "1: `beta` is not in paper/a.cpp")

    def test_a_page_that_names_nothing_is_refused(self):
        self.assertEqual(check("no code at all")[0], 1)


if __name__ == "__main__":
    unittest.main()
