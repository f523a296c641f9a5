"""Many characters in one scene."""

from __future__ import annotations

from typing import Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, Integers, integers
from pelt._contacts import Indices, limit
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run
from pelt._self_collide import SelfFilter, filter_of


class CrowdContacts:
    """N pairs of triangles of many characters in F frames, in coordinate form.

    frame:        [N] int32, ascending.
    character_a:  [N] int32, ascending within a frame.
    triangle_a:   [N] int32, triangle of character a.
    character_b:  [N] int32, greater than character_a; equal to it for contacts of a character with
                  itself.
    triangle_b:   [N] int32, triangle of character b.
    frames:       F.

    Within a frame, pairs are ordered by character_a, character_b, triangle_a, triangle_b.
    """

    def __init__(self, frame: Indices, character_a: Indices, triangle_a: Indices,
                 character_b: Indices, triangle_b: Indices, frames: int) -> None:
        self.frame = frame
        self.character_a = character_a
        self.triangle_a = triangle_a
        self.character_b = character_b
        self.triangle_b = triangle_b
        self.frames = frames

    def per_frame(self) -> npt.NDArray[np.int64]:
        """Returns the number of pairs of triangles in each frame [F]."""
        return np.bincount(self.frame, minlength=self.frames).astype(np.int64, copy=False)

    def pairs(self) -> Indices:
        """Returns the pairs of characters that touch, as rows of frame, character a, character b [n, 3],
        in ascending order."""
        rows = np.stack([self.frame, self.character_a, self.character_b], axis=1)
        is_first = np.ones(len(rows), np.bool_)
        is_first[1:] = (rows[1:] != rows[:-1]).any(axis=1)
        found: Indices = rows[is_first]
        return found

    @property
    def hash(self) -> str:
        """The hash that `pelt check` prints for a scene of these characters, as 16 hexadecimal digits."""
        value = _pelt.contact_hash(self.frame, self.triangle_a, self.triangle_b, self.character_a,
                                   self.character_b)
        return f"{value:016x}"

    def __len__(self) -> int:
        return len(self.frame)

    def __repr__(self) -> str:
        return (f"<pelt.CrowdContacts: {len(self)} pairs of triangles, {len(self.pairs())} pairs of "
                f"characters in {self.frames} frames>")


def collide_crowd(characters: Sequence[Tuple[Model, PosesLike]], *, pairs: Optional[Array] = None,
                  self_filters: Optional[Sequence[Optional[SelfFilter]]] = None,
                  max_contacts: Optional[int] = None, threads: Optional[int] = None,
                  progress: Progress = None) -> CrowdContacts:
    """Returns every pair of intersecting triangles of many characters, in each frame.

    characters:    (model, poses) of each character, in one frame of reference. Poses are palettes
                   [F, J, 4, 4] or [F, J, 3, 4], `Poses`, or `Vertices`; all have F frames, or one.
                   Characters can share a model.
    pairs:         [n, 2] pairs of characters to test. Default: all.
    self_filters:  for each character the `SelfFilter` with which it is tested against itself, or None
                   for characters that are not. Default: none is.
    max_contacts:  stop the test of each pair of characters in a frame after this number of pairs of
                   triangles; which are found first is unspecified.

    The answer is that of `collide` for each pair of characters, but only pairs whose boxes overlap cost
    more than a test of boxes, and each character is posed once for all its pairs. Exact with respect to
    the float32 posed vertices.

    Raises `pelt.Error` for invalid arguments.
    """
    clips = [clip_poses(f"characters[{number}], poses", *_checked(number, character))
             for number, character in enumerate(characters)]
    if not clips:
        raise _pelt.Error("characters: there are none")
    tested = None if pairs is None else _tested_pairs(pairs)
    filters = [None if ignore is None else filter_of(clip[0], ignore)
               for clip, ignore in zip(characters, self_filters or ())]
    if self_filters is not None and len(self_filters) != len(clips):
        raise _pelt.Error(f"self_filters: expected one for each of the {len(clips)} characters, found "
                          f"{len(self_filters)}")
    frames = max(clip.frame_count for clip in clips)
    with run("collide_crowd", frames, threads, progress) as how:
        return CrowdContacts(*_pelt.collide_crowd(clips, tested, filters,
                                                  limit("max_contacts", max_contacts), how), frames)


def _tested_pairs(pairs: Array) -> Integers:
    given = integers("pairs", pairs)
    if given.shape == (0,):  # an empty list
        given = given.reshape(0, 2)
    if given.ndim != 2 or given.shape[1] != 2:
        raise _pelt.Error(f"pairs: expected the shape [N, 2], found {list(given.shape)}")
    alone = np.flatnonzero(given[:, 0] == given[:, 1])
    if len(alone):
        raise _pelt.Error(f"pairs: row {alone[0]} is a character with itself: see self_filters")
    return given


def _checked(number: int, character: Tuple[Model, PosesLike]) -> Tuple[Model, PosesLike]:
    if not isinstance(character, (tuple, list)) or len(character) != 2:
        raise TypeError(f"characters[{number}]: expected (model, poses), found "
                        f"{type(character).__name__}")
    return character[0], character[1]
