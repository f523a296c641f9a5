#!/usr/bin/env python3
"""Checks that wide code defines no symbols that the linker could merge with another instruction set's.

    check_wide_symbols.py NM SET OBJECTS...     prints such symbols, exits with 1 if there are any
    check_wide_symbols.py --skip REASON            exits with 77

If a function outside of the namespace of the instruction set (of std::vector, for example) is not inlined, the
linker keeps one copy of it for the whole program, perhaps one with instructions that the machine does
not support.
"""

import subprocess
import sys


def shared_symbols(nm, target, file):
    """Returns the external symbols of the object file that are not in the namespace of the instruction set."""
    command = [nm, "--demangle", "--defined-only", file]
    listing = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    for line in listing.splitlines():
        _, kind, name = line.split(maxsplit=2)
        if (kind.isupper() or kind == "u") and f"::{target}::" not in name:
            yield name


def main(arguments):
    if arguments[0] == "--skip":
        print(f"skipped: {arguments[1]}")
        return 77
    nm, target, *files = arguments
    if not files:
        sys.exit("no object files")
    offenders = [f"{file}: {name}" for file in files for name in shared_symbols(nm, target, file)]
    print("\n".join(offenders) or f"{len(files)} files of {target} share nothing")
    return 1 if offenders else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
