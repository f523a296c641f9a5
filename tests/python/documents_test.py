"""The code blocks of the documents and the examples run. picture_test.py runs the one with a picture."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import generated_body
from pelt import _command
from support import DEMO, SOURCE, Case


class PythonBlocks(Case):
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


EXAMPLES = SOURCE / "bindings" / "python" / "examples"


class DatasetsDocument(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        self.root = pathlib.Path(folder.name)
        generated_body.save_body(self.root / "SMPLH_MALE.npz")
        for name in ("walk_poses.npz", "run_poses.npz", "sit_poses.npz"):
            generated_body.save_motion(self.root / "AMASS" / name)
        generated_body.save_body(self.root / "SMPLX_NEUTRAL.npz")
        for name in ("P1.npz", "P2.npz"):
            generated_body.save_motion(self.root / "Inter-X" / "sequence" / name)
        (self.root / "dask_metrics.py").write_text((EXAMPLES / "dask_metrics.py").read_text())
        self.text = (SOURCE / "docs" / "datasets.md").read_text()

    def blocks(self, language):
        found = re.findall(rf"(?ms)^```{language}\n(.*?)^```$", self.text)
        self.assertGreater(len(found), 1)
        return found

    def test_python(self):
        self.assertEqual(_command.main(["metrics", "AMASS", "--body-model", "SMPLH_MALE.npz",
                                        "--out", "table.csv"]), 0)
        names = {}
        for number, block in enumerate(self.blocks("python")):
            exec(compile(block, f"block {number + 1}", "exec"), names)

    def test_shell(self):
        for block in self.blocks("sh"):
            if "dask" in block and subprocess.run([sys.executable, "-c", "import distributed"],
                                                  capture_output=True).returncode:
                continue
            block = block.replace("python3", f"{sys.executable} -B")
            result = subprocess.run(["sh", "-e", "-c", block], capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, block + result.stdout + result.stderr)
        table = (self.root / "table.csv").read_text().splitlines()
        self.assertEqual(sorted((self.root / "all.csv").read_text().splitlines()), sorted(table))
        self.assertEqual(len(table), 4)
        self.assertEqual(len((self.root / "pairs.csv").read_text().splitlines()), 2)


if __name__ == "__main__":
    unittest.main()
