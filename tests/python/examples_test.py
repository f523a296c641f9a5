"""The examples run; for the one that draws a picture, see picture_test.py."""

import subprocess
import sys
import unittest

from support import DEMO, SOURCE, Case

EXAMPLES = SOURCE / "bindings" / "python" / "examples"


class Examples(Case):
    def run_example(self, name, *arguments):
        result = subprocess.run([sys.executable, EXAMPLES / name, *map(str, arguments)], text=True,
                                capture_output=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def test_two_characters(self):
        self.assertRegex(self.run_example("two_characters.py", DEMO / "azure.glb", DEMO / "sand.glb"),
                         r"<pelt.Contacts: [1-9]\d* pairs")

    def test_arrays(self):
        self.assertRegex(self.run_example("arrays.py"), r"frame 0: 0 .*\n(.*\n)*.*frame \d+: [1-9]")

    def test_usage_is_printed(self):
        result = subprocess.run([sys.executable, EXAMPLES / "two_characters.py"], text=True,
                                capture_output=True)
        self.assertEqual((result.returncode, result.stderr),
                         (1, "usage: two_characters.py WALKER.glb STANDER.glb\n"))

    def test_they_are_short(self):
        for file in (EXAMPLES / name for name in ("two_characters.py", "arrays.py", "picture.py")):
            code = [line for line in file.read_text().split('"""')[2].splitlines() if line.strip()]
            self.assertLessEqual(len(code), 14, file.name)


if __name__ == "__main__":
    unittest.main()
