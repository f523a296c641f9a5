"""The example that draws a picture."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from support import DEMO, SOURCE, Case, skip_program

try:
    import matplotlib  # noqa: F401
except ImportError:
    skip_program("no matplotlib (package python3-matplotlib)")


class Picture(Case):
    def test_is_drawn(self):
        example = SOURCE / "bindings" / "python" / "examples" / "picture.py"
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run([sys.executable, example, DEMO / "azure.glb"], text=True,
                                    capture_output=True, cwd=folder,
                                    env={**os.environ, "MPLBACKEND": "agg", "MPLCONFIGDIR": folder})
            self.assertEqual(result.returncode, 0, result.stderr)
            written = (pathlib.Path(folder) / "self_contacts.png").read_bytes()
        self.assertTrue(written.startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main()
