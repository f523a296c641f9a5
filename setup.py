"""Builds the Python package: setuptools packs the Python files, CMake compiles the extension.

PELT_BUILD_FOLDER: a configured build of Pelt to use, instead of a new one.
"""

import os
import pathlib
import re
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
CONTAINED = ("libmeshoptimizer-dev", "nlohmann-json3-dev", "pybind11-dev")


def version():
    """Returns the version that CMakeLists.txt states."""
    return re.search(r"project\(pelt VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


class CMakeBuild(build_ext):
    """Compiles the extension with CMake."""

    def build_extension(self, ext):
        folder = pathlib.Path(os.environ.get("PELT_BUILD_FOLDER") or self.configured())
        jobs = ["--parallel", str(os.cpu_count() or 1)]
        subprocess.run(["cmake", "--build", folder, "--target", "pelt_python", *jobs], check=True)
        built = folder / "python" / "pelt"
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).parent
        target.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(built / ("_pelt" + sysconfig.get_config_var("EXT_SUFFIX"))), str(target))
        for library in built.glob("lib*.so*"):
            self.copy_file(str(library), str(target))
        self.copy_notices(target / "notices")

    def copy_notices(self, target):
        """Copies the licences of the libraries that the extension contains, as Debian installs them."""
        for package in CONTAINED:
            notice = pathlib.Path("/usr/share/doc") / package / "copyright"
            if notice.exists():
                target.mkdir(exist_ok=True)
                self.copy_file(str(notice), str(target / f"{package}.txt"))

    def configured(self):
        """Returns a new build folder for this interpreter."""
        import pybind11

        folder = pathlib.Path(self.build_temp).resolve()
        subprocess.run(
            ["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
             "-DPELT_COMPILE_TOGETHER=ON", "-DPELT_BUILD_PYTHON=ON", f"-DPELT_PYTHON={sys.executable}",
             f"-Dpybind11_DIR={pybind11.get_cmake_dir()}", "-DPELT_BUILD_TOOLS=OFF",
             "-DPELT_BUILD_EVALUATION=OFF", "-DPELT_BUILD_TESTS=OFF", "-DPELT_BUILD_EXAMPLES=OFF",
             "-DPELT_INSTALL=OFF"], check=True)
        return folder


setup(version=version(), ext_modules=[Extension("pelt._pelt", sources=[])],
      cmdclass={"build_ext": CMakeBuild})
