#!/usr/bin/env python3
"""Checks that the files and functions that docs/algorithm.md names exist.

    check_algorithm.py ROOT

Every `path/of/a.file` and linked picture must exist. In a table row, every `name` after a path must
occur as a whole word in that file; of `Type::name`, both parts must. Elsewhere, a `name` must occur in
one of the files that the page names. Blocks of commands are not checked.
"""

import pathlib
import re
import sys

BLOCK = re.compile(r"^```.*?^```$", re.M | re.S)
CODE = re.compile(r"`([^`]+)`")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]+)\)")


def is_path(span):
    return "/" in span


def missing_names(span, texts):
    """Returns the parts of `Type::name` that do not occur in the texts."""
    return [part for part in span.split("::")
            if not any(re.search(rf"\b{re.escape(part)}\b", text) for text in texts)]


def check_line(number, line, files):
    """Returns the errors of one line; `files` maps each path that the page names to its text."""
    spans = CODE.findall(line)
    paths = [span for span in spans if is_path(span) and not span.endswith("/")]
    in_table = line.startswith("|")
    texts = [files[p] for p in paths if p in files] if in_table else list(files.values())
    for span in spans:
        if not is_path(span):
            for part in missing_names(span, texts):
                where = ", ".join(paths) if in_table else "any file of the page"
                yield f"{number}: `{part}` is not in {where}"


def check(root):
    page = root / "docs" / "algorithm.md"
    text = BLOCK.sub(lambda block: "\n" * block[0].count("\n"), page.read_text())
    paths = {span for span in CODE.findall(text) if is_path(span)}
    paths |= {"docs/" + picture for picture in PICTURE.findall(text)}
    faults = [f"`{path}` does not exist" for path in sorted(paths) if not (root / path).exists()]
    files = {path: (root / path).read_text() for path in paths if (root / path).is_file()}
    for number, line in enumerate(text.splitlines(), 1):
        faults += check_line(number, line, files)
    return len(paths), faults


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    count, faults = check(pathlib.Path(sys.argv[1]))
    print(*faults, f"{count} paths checked, {len(faults)} faults", sep="\n")
    sys.exit(bool(faults) or count == 0)


if __name__ == "__main__":
    main()
