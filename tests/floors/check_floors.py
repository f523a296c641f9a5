#!/usr/bin/env python3
"""Checks the dependency rule: a file includes files of its own floor or of lower ones.

    tests/floors/check_floors.py [ROOT]     prints each violation as file:line, exits with 1 if there is any

Beyond the floors: public headers include public headers only; the library and the paper stand on
the standard library alone; the library does not know the paper; the glTF reader knows the core by
its public headers; examples are written as a user would write them.
"""

import pathlib
import re
import sys

FLOORS = ["include/pelt", "src/base", "src/geometry", "src/skin", "evaluation/paper", "src/model", "src/pose",
          "src/query", "src/collide", "src/bounds", "src/ray", "src/region", "src/distance",
          "src/farthest", "src/field", "src/solid", "src/contact", "src/inside", "src/crowd",
          "evaluation/rivals", "asset", "scenes", "evaluation/methods",
          "bindings",
          *("tools/pelt/" + f for f in ("output", "arguments", "scene", "query", "bench", "picture",
                                        "prepared", "page", "check", "verbs")),
          "tools/pelt", "evaluation/peers", "evaluation/programs", "evaluation/reproduce", "evaluation/pictures", "tests"]

MAY_INCLUDE_PAPER = ("evaluation", "tools", "tests")
MAY_INCLUDE_ONLY = {
    "include/pelt": {"include/pelt"},
    "asset": {"include/pelt", "src/base", "asset"},
    "docs/examples": {"include/pelt"},
}
# src/base has the headers of instruction sets and systems.
STANDARD_LIBRARY_ONLY = ("include/pelt", "evaluation/paper", "docs/examples",
                         *(f for f in FLOORS if f.startswith("src/") and f != "src/base"))

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def floor_of(path):
    """The name of the floor on which a file stands, or None."""
    return next((f for f in [*FLOORS, "docs/examples"] if path.startswith(f + "/")), None)


def resolve(root, file, name):
    """The included file, relative to the root, or None if it is none of ours."""
    if name.startswith("pelt/"):
        return "include/" + name
    for folder in (root, root / "src", root / "tests", file.parent):
        if (folder / name).is_file():
            return (folder / name).resolve().relative_to(root).as_posix()
    return None


def violation(path, floor, bracket, name, target):
    """What is wrong with one include, or None."""
    if target is None:
        if bracket == '"':
            return f'"{name}" is no file of this project'
        if floor in STANDARD_LIBRARY_ONLY and re.search(r"[./]", name):
            return f"{floor} uses the standard library only, not <{name}>"
        return None
    theirs = floor_of(target)
    if theirs is None:
        return f"{target} stands on no floor"
    if theirs == "evaluation/paper" and floor.split("/")[0] not in MAY_INCLUDE_PAPER:
        return f"{path} must not know {target}"
    if floor in MAY_INCLUDE_ONLY and theirs not in MAY_INCLUDE_ONLY[floor]:
        return f"{floor} must not include {target}"
    if floor in FLOORS and FLOORS.index(theirs) > FLOORS.index(floor):
        return f"{target} stands above {floor}"
    return None


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    root = root if root.is_dir() else root.parents[2]
    files = [f for top in (*FLOORS, "docs/examples") for f in sorted((root / top).rglob("*.[ch]pp"))]
    if not files:
        sys.exit(f"{root}: no sources here")
    found = 0
    for file in files:
        path = file.relative_to(root).as_posix()
        for number, line in enumerate(file.read_text().splitlines(), 1):
            if match := INCLUDE.match(line):
                target = resolve(root, file, match[2])
                if wrong := violation(path, floor_of(path), match[1], match[2], target):
                    print(f"{path}:{number}: {wrong}")
                    found += 1
    print(f"{len(files)} files, {found} violations")
    sys.exit(found > 0)


if __name__ == "__main__":
    main()
