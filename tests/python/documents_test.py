"""The code blocks of the documents run. A block may use what earlier blocks have defined."""

import os
import re
import shutil
import tempfile
import unittest

from support import DEMO, SOURCE, Case


class Blocks(Case):
    def run_blocks(self, file):
        blocks = re.findall(r"(?ms)^```python\n(.*?)^```$", (SOURCE / file).read_text())
        self.assertGreater(len(blocks), 0)
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(DEMO / "azure.glb", f"{folder}/azure.glb")
            shutil.copy(DEMO / "sand.glb", f"{folder}/sand.glb")
            os.chdir(folder)
            try:
                names = {}
                for number, block in enumerate(blocks):
                    exec(compile(block, f"{file}, block {number + 1}", "exec"), names)
            finally:
                os.chdir(before)

    def test_readme(self):
        self.run_blocks("bindings/python/README.md")

    def test_page(self):
        self.run_blocks("docs/python.md")


if __name__ == "__main__":
    unittest.main()
