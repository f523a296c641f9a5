#!/usr/bin/env python3
"""Checks that the product links no rival method and no adapter to another library.

    check_symbols.py NM FILES...         prints the symbols of evaluation/ in programs, archives and
                                         objects; exits with 1 if there are any, or no symbols of Pelt
    check_symbols.py --wasm NM FOLDER    the same, and the symbols of paper/, for the objects of the
                                         npm package's engine, if FOLDER has been built; exits with
                                         77 otherwise
"""

import pathlib
import re
import shutil
import subprocess
import sys

EVALUATION = re.compile(r"\bpelt::(lab|rivals|peers|reproduce|programs|pictures)::")
EVALUATION_AND_PAPER = re.compile(r"\bpelt::(lab|rivals|peers|reproduce|programs|pictures|paper)::")


def symbols_of(nm, files):
    """Returns the demangled names that the files define or use."""
    listing = subprocess.run([nm, "--demangle", *files], capture_output=True, text=True, check=True)
    for line in listing.stdout.splitlines():
        if match := re.match(r"[0-9a-f]* +[A-Za-z] (.*)", line):
            yield match[1]


def check(nm, files, forbidden):
    names = {name for name in symbols_of(nm, files) if "pelt::" in name}
    offenders = sorted(name for name in names if forbidden.search(name))
    print(*offenders, f"{len(names)} symbols of Pelt, {len(offenders)} forbidden", sep="\n")
    return 1 if offenders or not names else 0


def linked_from(folder):
    """Returns the objects and archives of the engine, from Ninja."""
    inputs = subprocess.run(["ninja", "-C", folder, "-t", "inputs", "package/engine.mjs"],
                            capture_output=True, text=True, check=True).stdout
    return [folder / line for line in inputs.splitlines() if line.endswith((".o", ".a"))]


def check_wasm(nm, folder):
    files = linked_from(folder) if (folder / "build.ninja").is_file() else []
    if not files or not all(file.is_file() for file in files):
        print(f"skipped: {folder} has not been built: run scripts/build-wasm")
        return 77
    if not shutil.which(nm):
        print(f"skipped: {nm} not found")
        return 77
    return check(nm, files, EVALUATION_AND_PAPER)


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    if arguments[0] == "--wasm":
        return check_wasm(arguments[1], pathlib.Path(arguments[2]))
    return check(arguments[0], arguments[1:], EVALUATION)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
