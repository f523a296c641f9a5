"""scripts/install-deps installs what the builds need: install_deps_test.py SOURCE.

A developer's machine has other packages and newer programs than a fresh Debian, and does not show
what is missing there.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
SETS = ("demo", "reproduce", "test", "clang", "tidy", "peers", "wasm", "browser", "python")


def packages(name):
    """Returns the packages of a set, as the script installs them where nothing is installed."""
    with tempfile.TemporaryDirectory() as folder:
        for program, text in (("id", "echo 0"), ("uname", "echo x86_64"), ("dpkg-query", "exit 1"),
                              ("apt-get", ":")):
            path = pathlib.Path(folder, program)
            path.write_text(f"#!/bin/sh\n{text}\n")
            path.chmod(0o755)
        printed = subprocess.run(["/bin/bash", SOURCE / "scripts/install-deps", name], text=True,
                                 env={"PATH": folder}, check=True, stdout=subprocess.PIPE).stdout
    return re.search(r"^installing (.*)$", printed, re.MULTILINE)[1].split()


class InstallDeps(unittest.TestCase):
    def test_builds_without_a_preset_have_make(self):
        for name in ("demo", "python", "test"):
            self.assertLessEqual({"g++", "cmake", "make"}, set(packages(name)), name)

    def test_presets_have_ninja(self):
        for name in ("demo", "reproduce", "test", "wasm"):
            self.assertLessEqual({"cmake", "ninja-build"}, set(packages(name)), name)

    def test_a_package_that_cmake_names_is_in_a_set(self):
        known = {package for name in SETS for package in packages(name)}
        features = (SOURCE / "cmake/PeltFeatures.cmake").read_text()
        named = set(re.findall(r'"\$\{package\}" STREQUAL ([\w-]+)\)', features))
        for path in (SOURCE / "CMakeLists.txt", SOURCE / "tests/CMakeLists.txt"):
            named.update(re.findall(r"pelt_program\(\w+ ([\w-]+)", path.read_text()))
        self.assertGreater(len(named), 10)
        self.assertEqual(named - known, set())

    def test_packages_of_npm_have_no_overrides(self):
        """npm 9, which Debian 12 has, cannot read a lock file in which an override names an alias."""
        files = [*SOURCE.glob("*/package.json"), *SOURCE.glob("tests/*/package.json")]
        self.assertGreater(len(files), 2)
        for path in files:
            self.assertNotIn("overrides", json.loads(path.read_text()), path)


if __name__ == "__main__":
    unittest.main()
