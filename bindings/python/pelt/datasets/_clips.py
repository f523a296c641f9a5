"""Which clips a folder has, and which of them are pairs."""

from __future__ import annotations

import csv
import os
import re
from typing import List, Optional, Tuple

from pelt._npz import Path
from pelt._pelt import Error

Pair = Tuple[str, str]
"""Two clips of one sequence, relative to a folder."""


def find_clips(folder: Path) -> List[str]:
    """Returns the motion files of a folder and its subfolders, sorted, relative to the folder.

    These are all `.npz` and `.pkl` files, apart from the shapes that AMASS keeps beside its motions:
    `shape.npz` and `*_stagei.npz`.
    """
    root = os.fspath(folder)
    if not os.path.isdir(root):
        raise Error(f"{root}: not a folder")
    found = []
    for where, _, names in os.walk(root):
        found += [os.path.relpath(os.path.join(where, name), root) for name in names
                  if name.endswith((".npz", ".pkl"))
                  and name != "shape.npz" and not name.endswith("_stagei.npz")]
    return sorted(found)


def find_pairs(folder: Path, first: str, second: str) -> List[Pair]:
    """Returns the pairs of clips whose paths differ in one word only, sorted.

    folder:         see `find_clips`.
    first, second:  the word of each person, such as "P1" and "P2" for `a/P1.npz` and `a/P2.npz`, or
                    "person1" and "person2" for `person1/a.npz` and `person2/a.npz`.

    A word ends at anything that is neither a letter nor a digit. In a path with several of these words,
    the last one counts. A clip whose partner does not exist is in the list, too, with the name
    that the partner would have. Clips with neither word are left out.

    Raises `pelt.Error` if no clip has a word.
    """
    if not first or not second or first == second:
        raise Error(f"pairs: expected two different words, found {first!r} and {second!r}")
    clips = find_clips(folder)
    pairs = {pair for pair in (_pair_of(clip, first, second) for clip in clips) if pair}
    if not pairs:
        raise Error(f"{os.fspath(folder)}: none of its {len(clips)} clips has the word {first!r} or "
                    f"{second!r} in its path")
    return sorted(pairs)


def _pair_of(clip: str, first: str, second: str) -> Optional[Pair]:
    """Returns the pair that a clip belongs to, if any."""
    either = f"{re.escape(first)}|{re.escape(second)}"
    found = list(re.finditer(rf"(?<![^\W_])(?:{either})(?![^\W_])", clip))
    if not found:
        return None
    before, after = clip[:found[-1].start()], clip[found[-1].end():]
    return before + first + after, before + second + after


def read_pairs(path: Path) -> List[Pair]:
    """Returns the pairs of clips that a CSV file lists, in its order, each once.

    The file has the columns `clip_a` and `clip_b` among others, or two columns without a header. The
    names are relative to the folder that is measured. Tables of pairs are such files, too.

    Raises `pelt.Error` that names the file and the row.
    """
    name = os.fspath(path)
    try:
        with open(name, newline="", encoding="utf-8-sig", errors="surrogateescape") as file:
            rows = list(csv.reader(file))
    except (OSError, csv.Error) as error:
        raise Error(f"{name}: {error}") from error
    a, b, width, first = 0, 1, 2, 0
    if rows and {"clip_a", "clip_b"} <= set(rows[0]):
        a, b, width, first = rows[0].index("clip_a"), rows[0].index("clip_b"), len(rows[0]), 1
    pairs = {}
    for number, row in enumerate(rows[first:], first + 1):
        if not row:
            continue
        if len(row) != width or not row[a] or not row[b]:
            raise Error(f"{name}: row {number}: expected two names of clips, or the columns clip_a and "
                        "clip_b of a header")
        pairs[row[a], row[b]] = True
    if not pairs:
        raise Error(f"{name}: lists no pairs")
    return list(pairs)
