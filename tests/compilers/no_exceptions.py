#!/usr/bin/env python3
"""Compiles all files of the library with -fno-exceptions -fno-rtti -Werror.

    no_exceptions.py COMPILE_COMMANDS SOURCE_FOLDER BINARY_FOLDER

The files and their other flags are those of the build, but nothing is optimised. Of the files that are
compiled once for each instruction set, only those for the last set are compiled.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

FLAGS = ["-O0", "-fno-exceptions", "-fno-rtti", "-Werror"]


def commands_of(database, folders):
    """By object: the words of each command that compiles a file below one of the folders."""
    found = {}
    for entry in json.loads(pathlib.Path(database).read_text()):
        file = pathlib.Path(entry["file"])
        if "cmake_pch" not in file.name and any(file.is_relative_to(f) for f in folders):
            words = shlex.split(entry["command"])
            found[words[words.index("-o") + 1]] = entry["directory"], words
    return found


def for_one_set(commands):
    """Leaves out the objects of all instruction sets but the last."""
    sets = sorted({match[1] for output in commands if (match := re.search(r"/pelt_(\w+)\.dir/", output))})
    left_out = tuple(f"/pelt_{name}.dir/" for name in sets[:-1])
    return {output: command for output, command in commands.items()
            if not any(name in output for name in left_out)}


def without(words, *dropped):
    """The words without the first occurrence of `dropped`, and without the word after it."""
    for at in range(len(words)):
        if tuple(words[at:at + len(dropped)]) == dropped:
            return words[:at] + words[at + len(dropped) + 1:]
    return words


def compile_one(folder, words):
    """The messages of the compiler, empty if there are none."""
    words = without(words, "-o")
    words = without(words, "-Xclang", "-include-pch", "-Xclang")  # made with exceptions
    launcher = ["ccache"] if shutil.which("ccache") else []
    with tempfile.TemporaryDirectory() as scratch:
        run = subprocess.run([*launcher, *words, *FLAGS, "-o", f"{scratch}/object.o"], cwd=folder,
                             capture_output=True, text=True, check=False)
    return run.stdout + run.stderr + ("" if run.returncode == 0 else f"exit code {run.returncode}\n")


def main(database, *folders):
    commands = for_one_set(commands_of(database, folders))
    with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count())) as pool:
        messages = list(pool.map(lambda command: compile_one(*command), commands.values()))
    print(*filter(None, messages), f"{len(messages)} files", sep="\n")
    return 1 if any(messages) or len(messages) < 20 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
