"""Closed parts of a body."""

from __future__ import annotations

import collections
from typing import Dict, List, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

import pelt
from pelt._arrays import Array, integers
from pelt._model import Model
from pelt._pelt import Error
from pelt._poses import PosesLike, Vertices

Integers = npt.NDArray[np.int64]
Floats = npt.NDArray[np.float32]


class _Part(NamedTuple):
    """A part, whose holes are closed by fans around the mean of each boundary."""

    model: Model
    faces: Integers
    vertices: Integers
    """vertices of the body, in the order of the model"""

    loops: List[Integers]
    """vertices of the body around each hole"""

    own: npt.NDArray[np.bool_]
    """[V] whether a vertex of the body is of the part, or on a triangle with one that is"""


class BodyParts:
    """A body cut into parts, each of which is closed.

    rest:   [V, 3] rest positions.
    faces:  [T, 3] indices of vertices.
    parts:  [V] number of the part of each vertex; for example `weights.argmax(axis=1)`.

    A part has the triangles whose three corners are of the part, and a fan around the mean of each
    boundary. Parts may be ragged, have islands, and have boundaries that touch each other. With a
    single part, the holes of an open body such as SMPL-X are closed.

    Source: TUCH, selfcontact/body_segmentation.py: `BodySegment`, which closes hand-picked segments by
    fans around the means of hand-picked boundaries.
    """

    def __init__(self, rest: Array, faces: Array, parts: Array) -> None:
        self._parts = integers("parts", parts)
        corners = integers("faces", faces)
        positions = np.asarray(rest, np.float32)
        if self._parts.shape != positions.shape[:1]:
            raise Error(f"parts: expected the shape [{len(positions)}], found {list(self._parts.shape)}")
        self._closed = {number: _closed_part(number, positions, corners, self._parts)
                        for number in np.unique(self._parts).tolist()
                        if (self._parts[corners] == number).all(axis=1).any()}

    @property
    def numbers(self) -> List[int]:
        """Numbers of the parts that have triangles, ascending."""
        return sorted(self._closed)

    def model(self, part: int) -> Model:
        """Returns the closed surface of a part, for queries with its `poses`."""
        return self._part(part).model

    def faces(self, part: int) -> Integers:
        """Returns the triangles of `model`, [T', 3] indices of the vertices of `poses`: those of the body,
        in its order, then the fans. To draw contacts, or to compute a number in another way."""
        return self._part(part).faces

    def poses(self, part: int, positions: Array) -> Vertices:
        """Returns the poses of a part.

        positions:  [F, V, 3] posed vertices of the body, as from `pelt.posed_vertices`.
        """
        posed = np.asarray(positions, np.float32)
        if posed.ndim != 3 or posed.shape[1:] != (len(self._parts), 3):
            raise Error(f"positions: expected the shape [F, {len(self._parts)}, 3] of the whole body, found "
                        f"{list(posed.shape)}")
        return Vertices(_part_positions(self._part(part), posed))

    def _part(self, part: int) -> _Part:
        if part not in self._closed:
            raise Error(f"part: no part {part}, expected one of {self.numbers}")
        return self._closed[part]

    def vertices_inside(self, model: Model, poses: PosesLike, *,
                        threads: Optional[int] = None) -> npt.NDArray[np.bool_]:
        """Returns which vertices of a body are inside a part that is not theirs, in each frame [F, V].

        model, poses:  of the whole body, F frames.

        Definition: a vertex of one part is inside another part if the winding number of the closed
        surface of that part is not 0. Vertices next to the part, on triangles that share one with it,
        do not count: they are inside in many poses without harm, as at armpits and groins.
        Source: TUCH, selfcontact/selfcontact.py, where the winding number of the whole body is
        compared with 0.99 and tests by segments excuse vertices. A whole surface passes through its
        own vertices, so its winding number is not defined there; with parts, the decision is exact.

        Misjudges: a part inside itself, such as a folded belly, has no vertices inside. Vertices in the
        gap between two parts belong to neither part's closed surface.
        """
        positions = pelt.posed_vertices(model, poses, threads=threads, progress=False)
        inside = np.zeros(positions.shape[:2], np.bool_)
        for part in self.numbers:
            others = np.flatnonzero(~self._closed[part].own)
            sides = pelt.side_of(self.model(part), self.poses(part, positions), positions[:, others],
                                 threads=threads, progress=False)
            inside[:, others] |= sides > 0
        return inside


def _closed_part(number: int, positions: Floats, faces: Integers, parts: Integers) -> _Part:
    of_part = parts[faces] == number
    inner = faces[of_part.all(axis=1)]
    vertices, local = np.unique(inner, return_inverse=True)
    triangles = local.reshape(-1, 3)
    loops = _boundary_loops(triangles)
    fans = [np.stack([np.roll(loop, -1), loop, np.full_like(loop, len(vertices) + index)], axis=1)
            for index, loop in enumerate(loops)]
    own = np.zeros(len(positions), np.bool_)
    own[faces[of_part.any(axis=1)]] = True
    closed = np.concatenate([triangles, *fans])
    part = _Part(None, closed, vertices, [vertices[loop] for loop in loops], own)  # type: ignore[arg-type]
    rest = _part_positions(part, positions[np.newaxis])[0]
    model = Model(rest, closed)
    if not model.is_closed:
        raise Error(f"parts: part {number} cannot be closed: more than two of its triangles meet at an "
                    "edge, or two that do not traverse it in opposite directions")
    return part._replace(model=model)


def _part_positions(part: _Part, positions: Floats) -> Floats:
    """Returns the vertices of the part, then the mean of each loop, [F, ...]."""
    means = [positions[:, loop].mean(axis=1, keepdims=True) for loop in part.loops]
    return np.concatenate([positions[:, part.vertices], *means], axis=1)


def _boundary_loops(triangles: Integers) -> List[Integers]:
    """Returns the boundary of a surface as loops without repeated vertices, each in the direction of its
    triangles' edges. Boundaries may touch each other at vertices, as those of ragged parts do."""
    after = _edges_of_boundary(triangles)
    loops = []
    for start in sorted(after):
        path, place = [start], {start: 0}
        while after[path[-1]]:
            vertex = after[path[-1]].pop()
            if vertex in place:
                loops.append(np.array(path[place[vertex]:], np.int64))
                for passed in path[place[vertex] + 1:]:
                    del place[passed]
                del path[place[vertex] + 1:]
            else:
                place[vertex] = len(path)
                path.append(vertex)
    return loops


def _edges_of_boundary(triangles: Integers) -> Dict[int, List[int]]:
    """Returns the ends of all edges that no triangle traverses in the other direction, by their starts.
    At each vertex, as many of them end as start."""
    edges = collections.Counter((int(a), int(b)) for triangle in triangles
                                for a, b in zip(triangle, np.roll(triangle, -1)))
    after: Dict[int, List[int]] = {}
    for (a, b), count in sorted(edges.items()):
        for vertex in (a, b):
            after.setdefault(vertex, [])
        after[a] += [b] * max(0, count - edges[b, a])
    return after
