#!/usr/bin/env python3
"""Checks the dependency rules.

    tests/floors/check_floors.py [ROOT]     prints each violation as file:line, exits with 1 if there
                                            is any

The product has floors: a file may include files of its own floor and of lower ones. In addition,
public headers include only public headers; the library includes only the standard library; the glTF
reader includes only public headers of the core; examples include only what users can include. The
product includes nothing of evaluation/. Of the command, only its methods include the paper's system. Each
folder of evaluation/ may include the library and the folders listed for it below. Tests may include anything.

A folder of the library with queries is a room. Other folders include only its doors.
"""

import pathlib
import re
import sys

LIBRARY = ["include/pelt", "src/base", "src/exact", "src/geometry", "src/skin", "src/model", "src/pose",
           "src/query", "src/motion", "src/collide", "src/self", "src/bounds", "src/ray", "src/distance",
           "src/field", "src/solid", "src/contact", "src/inside", "src/volume", "src/crowd"]
FLOORS = [*LIBRARY, "text", "asset", "scenes", "bindings/python", "bindings", "paper",
          *("tools/pelt/" + f for f in ("output", "arguments", "methods", "scene", "query", "bench",
                                        "picture", "prepared", "page", "check", "list", "shard",
                                        "verbs")),
          "tools/pelt"]

# The headers of a room that other folders may include. The folders of the library that are not listed
# are kits, whose headers anyone may include.
DOORS = {
    # A kit, too: its other headers are the mathematics behind these.
    "src/motion": ["instants.hpp", "meeting_order.hpp", "moving_boxes.hpp", "moving_determinants.hpp",
                   "moving_filter.hpp", "moving_pair.hpp", "moving_pairs.hpp", "moving_tree.hpp",
                   "moving_triage.hpp"],
    "src/collide": ["collide_trees.hpp", "cluster_pair.hpp", "eager.hpp", "search.hpp"],
    "src/self": ["self_tree.hpp", "self_filter.hpp", "fans.hpp", "near_joints.hpp", "neighbours.hpp"],
    "src/bounds": ["level_boxes.hpp"],
    "src/ray": ["ray_descent.hpp"],
    "src/distance": ["answers.hpp", "distance_search.hpp", "triangle_gaps.hpp",
                     "triangle_search.hpp"],
    "src/field": [],
    "src/solid": [],
    "src/contact": [],
    "src/inside": [],
    "src/volume": [],
    "src/crowd": ["broad_phase.hpp"],
}
# Headers that evaluation/ may also include, because it measures the stages of a query.
STAGES = {
    "src/self": ["grid_boxes.hpp", "pair_masks.hpp", "self_descent.hpp"],
}

COMMAND = ["text", "asset", "scenes", *(f for f in FLOORS if f.startswith("tools/pelt"))]
EVALUATION = {
    "evaluation/rivals": [*LIBRARY, "paper"],
    "evaluation/methods": [*LIBRARY, "tools/pelt/methods", "paper", "evaluation/rivals"],
    "evaluation/bench": [*LIBRARY, *COMMAND, "evaluation/methods"],
    "evaluation/peers": [*LIBRARY, *COMMAND, "evaluation/rivals", "evaluation/methods", "evaluation/bench"],
    "evaluation/programs": [*LIBRARY, "text", "asset", "scenes", "tools/pelt/output", "tools/pelt/bench",
                            "tools/pelt/scene", "evaluation/bench", "evaluation/peers"],
    "evaluation/reproduce": [*LIBRARY, *COMMAND, "paper", "evaluation/rivals",
                             "evaluation/methods", "evaluation/bench", "evaluation/peers",
                             "evaluation/programs"],
    "evaluation/pictures": [*LIBRARY, *COMMAND, "evaluation/reproduce"],
    "evaluation/lab": ["tools/pelt/arguments", "tools/pelt/methods", "tools/pelt/verbs",
                       "evaluation/methods", "evaluation/bench", "evaluation/reproduce"],
}
FOLDERS = [*FLOORS, *EVALUATION, "docs/examples", "tests"]

MAY_INCLUDE_PAPER = ("tools/pelt/methods", *EVALUATION)
MAY_INCLUDE_ONLY = {
    "include/pelt": ["include/pelt"],
    "text": ["include/pelt", "text"],
    "asset": ["include/pelt", "src/base", "text", "asset"],
    "bindings/python": ["include/pelt", "bindings/python"],
    "docs/examples": ["include/pelt"],
    "paper": ["include/pelt", "src/base", "src/exact", "src/geometry", "src/skin"],
}
# src/base includes headers of instruction sets and systems.
STANDARD_LIBRARY_ONLY = ("include/pelt", "paper", "docs/examples",
                         *(f for f in LIBRARY if f.startswith("src/") and f != "src/base"))

INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path):
    """Returns the folder of the rules that contains a file, or None."""
    return next((f for f in FOLDERS if path.startswith(f + "/")), None)


def resolve(root, file, name):
    """Returns the included file, relative to the root, or None if it is not a file of Pelt."""
    if name.startswith("pelt/"):
        return "include/" + name
    for folder in (root, root / "src", root / "tests", file.parent):
        if (folder / name).is_file():
            return (folder / name).resolve().relative_to(root).as_posix()
    return None


def may_include(folder, theirs):
    """Returns whether a file in one folder of the rules may include a file in another."""
    if folder == theirs or folder == "tests":
        return True
    if theirs == "paper" and folder not in MAY_INCLUDE_PAPER:
        return False
    if folder in MAY_INCLUDE_ONLY:
        return theirs in MAY_INCLUDE_ONLY[folder]
    if folder in EVALUATION:
        return theirs in EVALUATION[folder]
    return theirs in FLOORS and FLOORS.index(theirs) < FLOORS.index(folder)


def is_open(folder, theirs, target):
    """Returns whether a file of the product or of evaluation may include a header of a room."""
    if theirs not in DOORS or folder in (theirs, "tests"):
        return True
    name = target[len(theirs) + 1:]
    return name in DOORS[theirs] or (folder in EVALUATION and name in STAGES.get(theirs, ()))


def violation(folder, bracket, name, target):
    """Returns the error of an include, or None."""
    if target is None:
        if bracket == '"':
            return f'"{name}" is no file of this project'
        if folder in STANDARD_LIBRARY_ONLY and re.search(r"[./]", name):
            return f"{folder} uses the standard library only, not <{name}>"
        return None
    theirs = folder_of(target)
    if theirs is None:
        return f"{target} is in none of the folders that the rules name"
    if not may_include(folder, theirs):
        return f"{folder} must not include {target}"
    if not is_open(folder, theirs, target):
        return f"{target} is no door of {theirs} (DOORS)"
    return None


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    root = root if root.is_dir() else root.parents[2]
    files = sorted({f for top in FOLDERS for f in (root / top).rglob("*.[ch]pp")})
    if not files:
        sys.exit(f"{root}: no sources here")
    found = 0
    for file in files:
        path = file.relative_to(root).as_posix()
        for number, line in enumerate(file.read_text().splitlines(), 1):
            if match := INCLUDE.match(line):
                target = resolve(root, file, match[2])
                if wrong := violation(folder_of(path), match[1], match[2], target):
                    print(f"{path}:{number}: {wrong}")
                    found += 1
    print(f"{len(files)} files, {found} violations")
    sys.exit(found > 0)


if __name__ == "__main__":
    main()
