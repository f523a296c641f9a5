"""The wheel builds from the source tree, and works in an environment of its own."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile

from support import SOURCE, Case, skip_program

for module, package in (("build", "python3-build"), ("wheel", "python3-wheel"),
                        ("setuptools", "python3-setuptools"), ("venv", "python3-venv"),
                        ("ensurepip", "python3-venv"), ("pybind11", "python3-pybind11")):
    if subprocess.run([sys.executable, "-c", f"import {module}"], capture_output=True).returncode:
        skip_program(f"no {module} (package {package})")


class Wheel(Case):
    def run_clean(self, *command, cwd):
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        result = subprocess.run(list(map(str, command)), text=True, capture_output=True, cwd=cwd,
                                env=environment)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def copy_source(self, folder):
        """Copies the files that the wheel needs: the source tree stays clean."""
        for name in ("pyproject.toml", "setup.py", "CMakeLists.txt", "LICENSE", "docs/third-party.md",
                     "bindings/python/README.md"):
            target = folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes((SOURCE / name).read_bytes())
        for file in (SOURCE / "bindings/python/pelt").rglob("*"):
            if file.suffix in (".py", ".pyi", ".typed") or file.name == "py.typed":
                target = folder / file.relative_to(SOURCE)
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(file.read_bytes())

    def test_wheel(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.copy_source(folder / "source")
            self.run_clean(sys.executable, "-m", "build", "--wheel", "--no-isolation", "-o", folder,
                           folder / "source", cwd=folder)
            wheel, = folder.glob("pelt-*.whl")
            files = zipfile.ZipFile(wheel).namelist()
            for file in ("pelt/__init__.py", "pelt/_pelt.pyi", "pelt/py.typed"):
                self.assertIn(file, files)
            self.assertTrue(any(file.endswith("LICENSE") for file in files), files)
            for library, package in (("libmeshoptimizer", "libmeshoptimizer-dev"), (None, "pybind11-dev"),
                                     (None, "nlohmann-json3-dev")):
                self.assertTrue(library is None or any(f"pelt/{library}.so" in file for file in files))
                if pathlib.Path(f"/usr/share/doc/{package}/copyright").exists():
                    self.assertIn(f"pelt/notices/{package}.txt", files)
            self.run_clean(sys.executable, "-m", "venv", "--system-site-packages", folder / "env",
                           cwd=folder)
            python = folder / "env" / "bin" / "python"
            self.run_clean(python, "-m", "pip", "install", "--no-index", "--no-deps", wheel, cwd=folder)
            printed = self.run_clean(python, "-c", "import pelt; print(pelt.__file__, pelt.__version__)",
                                     cwd=folder)
            self.assertIn(str(folder / "env"), printed)
            mapped = self.run_clean(python, "-c", "import pelt; print(open('/proc/self/maps').read())",
                                    cwd=folder)
            self.assertRegex(mapped, rf"{re.escape(str(folder))}/env/.*/pelt/libmeshoptimizer.so")


if __name__ == "__main__":
    unittest.main()
