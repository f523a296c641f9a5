"""Penetration of two bodies: vertices inside, frames, depth."""

from typing import NamedTuple, Optional

import numpy as np
import numpy.typing as npt

import pelt
from pelt._model import Model
from pelt._poses import PosesLike

Flags = npt.NDArray[np.bool_]
Counts = npt.NDArray[np.int64]
Doubles = npt.NDArray[np.float64]


class InsideVertices(NamedTuple):
    """Vertices of two bodies inside each other in F frames, see `vertices_inside`."""

    count_a: Counts
    """[F] number of vertices of a inside b"""

    count_b: Counts
    """[F] number of vertices of b inside a"""

    fraction_a: Doubles
    """[F] count_a / number of vertices of a"""

    fraction_b: Doubles
    """[F] count_b / number of vertices of b"""


class PenetrationFrames(NamedTuple):
    """Frames with penetration, see `penetration_frames`."""

    collides: Flags
    """[F] whether the bodies penetrate each other"""

    frame_percent: float
    """100 x frames with penetration / F"""

    penetration: float
    """mean over the frames with penetration of (fraction_a + fraction_b) / 2; 0 without any"""


class Depth(NamedTuple):
    """Depth of the deepest vertex in F frames, see `depth`."""

    per_frame: Doubles
    """[F] in model units; 0 without penetration"""

    deepest: float
    """the largest of all frames"""

    mean: float
    """the mean of all frames, those without penetration included"""


def vertices_inside(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                    threads: Optional[int] = None) -> InsideVertices:
    """Returns how many vertices of each of two bodies are inside the other one, in each frame.

    model_a, model_b:  closed surfaces.
    poses_a, poses_b:  F frames, in one frame of reference.

    Definition: a vertex is inside if the winding number of the other surface around it is not 0. A
    vertex on the surface is outside.
    Source: TUCH, selfcontact/selfcontact.py: winding number > 0.99, in floating point. `pelt` decides
    exactly, so it needs no threshold.

    Misjudges: a thin limb that pierces a body between its vertices has no vertex inside. Count the
    colliding triangles, too. For vertices of a body inside itself see `BodyParts`.
    """
    in_b = pelt.vertices_inside(model_a, poses_a, model_b, poses_b, threads=threads, progress=False)
    in_a = pelt.vertices_inside(model_b, poses_b, model_a, poses_a, threads=threads, progress=False)
    count_a, count_b = in_b.sum(axis=1), in_a.sum(axis=1)
    return InsideVertices(count_a, count_b, count_a / in_b.shape[1], count_b / in_a.shape[1])


def penetration_frames(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                       threads: Optional[int] = None) -> PenetrationFrames:
    """Returns in which frames two bodies penetrate each other, and how much.

    Arguments: see `vertices_inside`.

    Definition: a frame has penetration if a vertex of one body is inside the other. The penetration
    is the mean over these frames of the mean of both fractions of vertices inside, without unit.
    Source: multiphys, metrics/collision.py, with `trimesh.contains`.

    Misjudges: frames whose surfaces intersect without a vertex inside do not count; see
    `pelt.intersects`. The mean is over frames with penetration only: removing all light collisions
    from a motion raises it.
    """
    inside = vertices_inside(model_a, poses_a, model_b, poses_b, threads=threads)
    both = (inside.fraction_a + inside.fraction_b) / 2
    collides = both > 0
    return PenetrationFrames(collides, 100 * float(collides.mean()),
                             float(both[collides].mean()) if collides.any() else 0.0)


def depth(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
          threads: Optional[int] = None) -> Depth:
    """Returns how deep two bodies penetrate each other, in each frame.

    Arguments: see `vertices_inside`. Lengths are in model units.

    Definition: the largest distance of a vertex inside the other body from the surface of that body,
    of both directions.
    Source: "max penetration" of work on hands and objects, such as GraspTTA; "SDF depth" of PhysiGen,
    coll_metric_mesh.py, sums the distances of all vertices instead.

    Misjudges: this is not the distance by which bodies must be moved apart: a thin plate through the
    middle of a body has a small depth. Only vertices count.
    """
    a_in_b = pelt.deepest_vertex(model_a, poses_a, model_b, poses_b, threads=threads, progress=False)
    b_in_a = pelt.deepest_vertex(model_b, poses_b, model_a, poses_a, threads=threads, progress=False)
    per_frame = np.maximum(a_in_b.depth, b_in_a.depth)
    return Depth(per_frame, float(per_frame.max()), float(per_frame.mean()))
