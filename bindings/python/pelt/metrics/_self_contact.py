"""Contact of a body with itself, by distance and geodesic distance."""

from __future__ import annotations

import math
from typing import NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, floats, integers
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run


class Geodesics:
    """Which vertices of a body are near each other along its surface. Make it once for each subject.

    rest:    [V, 3] rest positions, V at most 50,000.
    faces:   [T, 3] indices of vertices.
    limit:   vertices are near if a path along edges is shorter, in model units. Default: 30 cm in
             metres, the threshold of TUCH.

    Paths along edges are at least as long as those across triangles, so slightly fewer vertices are
    near than by the exact geodesic distance. Takes V^2 / 8 bytes, and one search of Dijkstra for each
    vertex.
    """

    def __init__(self, rest: Array, faces: Array, limit: float = 0.3, *,
                 threads: Optional[int] = None) -> None:
        self.limit = _positive("limit", limit)
        positions = floats("rest", rest)
        with run("geodesics", len(positions), threads, False) as how:
            self._near = _pelt.NearAlongEdges(positions, integers("faces", faces), self.limit, how)


class SelfContact(NamedTuple):
    """Contacts of a body with itself in F frames, see `self_contact`.

    distance:  [F, V] distance from the closest vertex that is far along the surface, in model units;
               infinite if it is not less than the threshold.
    vertex:    [F, V] that vertex, -1 for none.
    """

    distance: npt.NDArray[np.float32]
    vertex: npt.NDArray[np.int32]

    @property
    def touching(self) -> npt.NDArray[np.bool_]:
        """[F, V] whether a vertex is in contact"""
        return np.greater_equal(self.vertex, 0)

    @property
    def percent(self) -> npt.NDArray[np.float64]:
        """[F] 100 x vertices in contact / V"""
        return np.asarray(100 * self.touching.mean(axis=1))


def self_contact(model: Model, poses: PosesLike, geodesics: Geodesics, *, distance: float = 0.02,
                 threads: Optional[int] = None, progress: Progress = None) -> SelfContact:
    """Returns the vertices of a body that touch the body, in each frame, and the share in percent.

    model:      V vertices.
    poses:      F frames: palettes [F, J, 4, 4], `Poses` or `Vertices`.
    geodesics:  of the rest positions of the model.
    distance:   threshold, in model units. Default: 2 cm in metres.

    Definition: a vertex is in contact if another vertex is nearer than `distance`, and at least
    `geodesics.limit` (30 cm) away along the surface of the rest pose.
    Source: TUCH (Mueller et al. 2021), selfcontact/selfcontact.py: `geothres` 0.3, `euclthres` 0.02.
    There, one file with geodesic distances of the mean shape serves all subjects: for that, make
    `Geodesics` of the rest positions of the mean shape.

    Misjudges: the distance is one of vertices, so large triangles can touch unnoticed. Parts less than
    30 cm apart along the surface, such as fingertip and palm, are never in contact. Vertices inside
    the body count like those on it; see `BodyParts.vertices_inside`.
    """
    clip = clip_poses("poses", model, poses)
    threshold = _positive("distance", distance)
    with run("self_contact", clip.frame_count, threads, progress) as how:
        return SelfContact(*_pelt.self_distances(clip, geodesics._near, threshold, how))


def _positive(name: str, value: float) -> float:
    number = float(value)
    if not 0 < number < math.inf:
        raise _pelt.Error(f"{name}: expected a positive number, found {value!r}")
    return number
