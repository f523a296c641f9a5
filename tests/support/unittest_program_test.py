"""unittest_program: exit status and reason of programs of tests."""

import pathlib
import subprocess
import sys
import unittest

PROGRAM = """
import sys, unittest
sys.path.append({folder!r})
import unittest_program

class A(unittest.TestCase):
    def test_passes(self):
        pass
    def test_fails(self):
        self.fail("why")
    def test_first(self):
        self.skipTest("no tool")
    def test_second(self):
        self.skipTest("no tool")

class B(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        raise unittest.SkipTest("no folder")
    def test(self):
        pass

unittest_program.main({names!r})
"""


class Programs(unittest.TestCase):
    def ended(self, *names):
        """Returns exit status and output of a program with these tests."""
        code = PROGRAM.format(folder=str(pathlib.Path(__file__).parent), names=names)
        run = subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True,
                             check=False)
        return run.returncode, run.stdout

    def test_all_are_skipped(self):
        self.assertEqual(self.ended("A.test_first"), (77, "skipped: no tool\n"))
        self.assertEqual(self.ended("A.test_first", "A.test_second"), (77, "skipped: no tool\n"))
        self.assertEqual(self.ended("B"), (77, "skipped: no folder\n"))

    def test_some_are_skipped(self):
        self.assertEqual(self.ended("A.test_first", "A.test_passes"), (0, ""))
        self.assertEqual(self.ended("A.test_first", "A.test_fails"), (1, ""))

    def test_none_is_skipped(self):
        self.assertEqual(self.ended("A.test_passes"), (0, ""))
        self.assertEqual(self.ended("A.test_fails"), (1, ""))
        self.assertEqual(self.ended(), (1, ""))


if __name__ == "__main__":
    unittest.main()
