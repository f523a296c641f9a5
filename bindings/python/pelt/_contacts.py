"""Lists of pairs of triangles, as columns of NumPy."""

from __future__ import annotations

from typing import Dict, Iterator, Tuple, Union

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import integer

Indices = npt.NDArray[np.int32]
Flags = npt.NDArray[np.bool_]


def rows_of_frame(frames: Indices, frame: int, count: int) -> slice:
    """Returns the rows of one of `count` frames, where `frames` [N] is ascending. O(log N)."""
    if not 0 <= frame < count:
        raise IndexError(f"frame {frame} of {count}")
    begin, end = np.searchsorted(frames, [frame, frame + 1])
    return slice(int(begin), int(end))


class Contacts:
    """N pairs of triangles in F frames, in coordinate form.

    frame:       [N] int32, ascending.
    triangle_a:  [N] int32, triangle of model a; ascending within a frame.
    triangle_b:  [N] int32, triangle of model b; ascending for equal triangles of a.
    frames:      F.
    cut_short:   [F] bool, whether `max_contacts` has ended the query of a frame, so that contacts
                 may be missing.

    `len` is N. Iteration yields, for each frame, the pairs of triangles as an array [n, 2].
    """

    _bodies = (0, 1)

    def __init__(self, frame: Indices, triangle_a: Indices, triangle_b: Indices,
                 cut_short: Flags) -> None:
        self.frame = frame
        self.triangle_a = triangle_a
        self.triangle_b = triangle_b
        self.cut_short = cut_short

    @property
    def frames(self) -> int:
        """F, the number of frames."""
        return len(self.cut_short)

    def per_frame(self) -> npt.NDArray[np.int64]:
        """Returns the number of pairs in each frame [F]."""
        return np.bincount(self.frame, minlength=self.frames).astype(np.int64, copy=False)

    def in_frame(self, frame: int) -> Indices:
        """Returns the pairs of triangles in one frame [n, 2]. O(log N)."""
        rows = rows_of_frame(self.frame, frame, self.frames)
        return np.stack([self.triangle_a[rows], self.triangle_b[rows]], axis=1)

    @property
    def hash(self) -> str:
        """The hash that `pelt check` prints for these contacts, as 16 hexadecimal digits."""
        bodies_a, bodies_b = (np.broadcast_to(np.int32(body), len(self)) for body in self._bodies)
        value = _pelt.contact_hash(self.frame, self.triangle_a, self.triangle_b, bodies_a, bodies_b)
        return f"{value:016x}"

    def __len__(self) -> int:
        return len(self.frame)

    def __iter__(self) -> Iterator[Indices]:
        return (self.in_frame(frame) for frame in range(self.frames))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Contacts):
            return NotImplemented
        return (self.frames == other.frames and np.array_equal(self.frame, other.frame)
                and np.array_equal(self.triangle_a, other.triangle_a)
                and np.array_equal(self.triangle_b, other.triangle_b))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        touched = int(np.count_nonzero(self.per_frame()))
        cut = ", cut short" if self.cut_short.any() else ""
        return (f"<pelt.{type(self).__name__}: {len(self)} pairs of triangles in {touched} of "
                f"{self.frames} frames{cut}>")


class SelfContacts(Contacts):
    """Contacts of a model with itself: triangle_a < triangle_b in each pair.

    left_out:  number of pairs that each filter has left out, by the name of the filter.
    """

    _bodies = (0, 0)

    def __init__(self, frame: Indices, triangle_a: Indices, triangle_b: Indices, cut_short: Flags,
                 left_out: Dict[str, int]) -> None:
        super().__init__(frame, triangle_a, triangle_b, cut_short)
        self.left_out = left_out


Pairs = Tuple[Indices, Indices, Indices, Flags]


def limit(name: str, value: Union[int, None]) -> int:
    """Returns a limit as the library expects it; None means no limit."""
    greatest = 2**32 - 1
    return greatest if value is None else integer(name, value, 0, greatest)
