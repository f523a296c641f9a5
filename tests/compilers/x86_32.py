#!/usr/bin/env python3
"""Builds the library for 32-bit x86 without warnings, and compares its answers with the 64-bit ones.

    x86_32.py PROJECT FOLDER ANSWERS CMAKE OPTIONS...

PROJECT is configured with CMAKE OPTIONS and built in FOLDER. Its program must print the same lines as
the program ANSWERS. Exits with 77 if the compiler cannot link 32-bit programs, or none can run.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77


def compiler_of(options):
    return next(o.split("=", 1)[1] for o in options if o.startswith("-DCMAKE_CXX_COMPILER="))


def why_not(compiler):
    """Why 32-bit programs cannot be built or run here, or None."""
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder, "program")
        build = [compiler, "-m32", "-x", "c++", "-", "-o", str(program)]
        text = "#include <vector>\nint main() { return std::vector<int>(3).size() - 3; }\n"
        if subprocess.run(build, input=text, text=True, capture_output=True).returncode != 0:
            return f"{compiler} -m32 cannot link a program: install g++-multilib"
        try:
            subprocess.run([program], check=True)
        except (OSError, subprocess.CalledProcessError) as error:
            return f"32-bit programs do not run on this system: {error}"
    return None


def answers_of(program):
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    return [line for line in printed.splitlines() if not line.startswith("seed ")]


def main(project, folder, program, *cmake):
    if reason := why_not(compiler_of(cmake)):
        print("skipped:", reason)
        return SKIPPED
    subprocess.run([*cmake, "-S", project, "-B", folder, "-DCMAKE_CXX_FLAGS=-m32",
                    "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"], check=True)
    jobs = str(min(2, os.cpu_count()))
    subprocess.run([cmake[0], "--build", folder, "--parallel", jobs], check=True)
    narrow, wide = answers_of(pathlib.Path(folder, "answers")), answers_of(program)
    differing = sorted(set(narrow) ^ set(wide))
    print(*differing, f"{len(narrow)} lines, {len(differing)} differ", sep="\n")
    found = [int(line.split()[-1]) for line in narrow if " found " in line]
    return 0 if not differing and found and min(found) > 50 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
