"""scripts/summarise-tests reads the output of ctest: counts, reasons, exit status."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = sys.argv.pop()
PASSED = '<testcase name="good" status="run"/>'
FAILED = '<testcase name="bad" status="fail"><failure message=""/></testcase>'
LOST = ('<testcase name="lost" status="notrun"><skipped message="Unable to find executable"/>'
        "</testcase>")


def skipped(output):
    return ('<testcase name="later" status="notrun">'
            '<skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>'
            f"<system-out>{output}</system-out></testcase>")


GTEST_SKIPPED = skipped("[ RUN      ] A.b\na_test.cpp:12: Skipped\nno folder\n\n[  SKIPPED ] A.b")


class SummariseTests(unittest.TestCase):
    def summarise(self, *reports):
        with tempfile.TemporaryDirectory() as folder:
            files = [pathlib.Path(folder, f"{i}.xml") for i in range(len(reports))]
            for file, cases in zip(files, reports):
                file.write_text(f"<testsuite>{cases}</testsuite>")
            run = subprocess.run([sys.executable, SCRIPT, *files], capture_output=True, text=True)
            return run.returncode, run.stdout.splitlines()

    def test_reports_are_added_up(self):
        status, lines = self.summarise(PASSED + PASSED, PASSED)
        self.assertEqual(status, 0)
        self.assertEqual(lines[-2:], ["3 passed, 0 failed, 0 skipped",
                                      "scripts/test: 3 passed, 0 failed, 0 skipped"])

    def test_the_ten_slowest_are_named(self):
        cases = [f'<testcase name="t{i:02}" status="run" time="{i}.25"/>' for i in range(12)]
        _, lines = self.summarise("".join(cases[:6]), "".join(cases[6:]))
        at = lines.index("slowest tests:") + 1
        self.assertEqual([line.split()[2] for line in lines[at:at + 10]],
                         [f"t{i:02}" for i in range(11, 1, -1)])
        self.assertIn(" 11.2 s  t11 (", lines[at])
        self.assertEqual(lines[at + 10], "12 passed, 0 failed, 0 skipped")

    def test_skipped_tests_say_why(self):
        status, lines = self.summarise(PASSED + GTEST_SKIPPED + GTEST_SKIPPED +
                                       skipped("skipped: no tool"))
        self.assertEqual(status, 0)
        self.assertEqual(lines[-1], "scripts/test: 1 passed, 0 failed, 3 skipped "
                                    "(2: no folder; 1: no tool)")

    def test_failed_and_lost_tests_are_named_and_fail(self):
        status, lines = self.summarise(PASSED + FAILED + LOST)
        self.assertEqual(status, 1)
        self.assertIn("failed: bad", lines[-4])
        self.assertIn("failed: lost", lines[-3])
        self.assertEqual(lines[-2], "1 passed, 2 failed, 0 skipped")

    def test_nothing_passed_fails(self):
        self.assertEqual(self.summarise("")[0], 1)
        self.assertEqual(self.summarise(GTEST_SKIPPED)[0], 1)


if __name__ == "__main__":
    unittest.main()
