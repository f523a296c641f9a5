"""The blocks of docs/datasets.md run, on generated files."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import generated_body
from pelt import _command
from support import SOURCE, Case

EXAMPLES = SOURCE / "bindings" / "python" / "examples"


class Blocks(Case):
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
