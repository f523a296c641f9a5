"""The chart of the README is what scripts/plot-peers draws from the committed results, and the ratios
of the README's table are those of the chart."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop())


class Chart(unittest.TestCase):
    def setUp(self):
        with tempfile.NamedTemporaryFile(suffix=".svg") as drawn:
            subprocess.run([sys.executable, ROOT / "scripts/plot-peers", drawn.name], check=True)
            self.drawn = pathlib.Path(drawn.name).read_text()

    def test_is_drawn_from_the_results(self):
        self.assertEqual(self.drawn, (ROOT / "docs/figures/peers.svg").read_text())

    def test_has_the_ratios_of_the_table(self):
        drawn = re.findall(r">(\d+) times Pelt<", self.drawn)
        rows = re.findall(r"^\| \[.*?\| (\d+) \|", (ROOT / "README.md").read_text(), re.MULTILINE)
        self.assertEqual(rows, drawn)
        self.assertGreater(len(rows), 3)


if __name__ == "__main__":
    unittest.main()
