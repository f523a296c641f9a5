#!/usr/bin/env python3
"""Compiles each public header as C++17 and expects one error, which says that C++20 is needed.

    cxx17_test.py COMPILER INCLUDE_FOLDER GENERATED_FOLDER
"""

import pathlib
import subprocess
import sys


def errors_of(compiler, folders, name):
    program = f"#include <pelt/{name}>\nint main() {{ pelt::Pose pose; return pelt::nothing(pose); }}\n"
    command = [compiler, "-std=c++17", "-fsyntax-only", "-x", "c++",
               *(f"-I{folder}" for folder in folders), "-"]
    done = subprocess.run(command, input=program, capture_output=True, text=True)
    return [line for line in done.stderr.splitlines() if "error:" in line]


def main():
    compiler, *folders = sys.argv[1:]
    headers = {p.name for p in (pathlib.Path(folders[0]) / "pelt").glob("*.hpp")}
    assert len(headers) > 15, headers
    for name in sorted(headers):
        errors = errors_of(compiler, folders, name)
        assert len(errors) == 1 and "Pelt needs C++20" in errors[0], (name, errors)
    print(f"{len(headers)} headers")


main()
