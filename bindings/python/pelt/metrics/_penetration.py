"""Penetration of two bodies: vertices inside, frames, depth."""

from __future__ import annotations

from typing import NamedTuple, Optional

import numpy as np
import numpy.typing as npt

import pelt
from pelt._arrays import Array, integers
from pelt._model import Model
from pelt._pelt import Error
from pelt._poses import PosesLike, Vertices

Flags = npt.NDArray[np.bool_]
Counts = npt.NDArray[np.int64]
Doubles = npt.NDArray[np.float64]


class InsideVertices(NamedTuple):
    """Vertices of two bodies inside each other in F frames, see `vertices_inside`.

    count_a:     [F] number of vertices of a inside b.
    count_b:     [F] number of vertices of b inside a.
    fraction_a:  [F] count_a / number of vertices of a.
    fraction_b:  [F] count_b / number of vertices of b.
    """

    count_a: Counts
    count_b: Counts
    fraction_a: Doubles
    fraction_b: Doubles


class PenetrationFrames(NamedTuple):
    """Frames with penetration, see `penetration_frames`.

    collides:       [F] whether the bodies penetrate each other.
    frame_percent:  100 x frames with penetration / F.
    penetration:    mean over the frames with penetration of (fraction_a + fraction_b) / 2; 0 without any.
    """

    collides: Flags
    frame_percent: float
    penetration: float


class Depth(NamedTuple):
    """Depth of the deepest vertex in F frames, see `depth`.

    per_frame:  [F] in model units; 0 without penetration.
    deepest:    the largest of all frames.
    mean:       the mean of all frames, those without penetration included.
    """

    per_frame: Doubles
    deepest: float
    mean: float


class SummedDepth(NamedTuple):
    """Depths of all vertices in F frames, see `summed_depth`.

    per_frame:      [F] in model units; 0 without penetration.
    mean:           the mean of all frames, those without penetration included.
    frame_percent:  100 x frames with penetration / F.
    """

    per_frame: Doubles
    mean: float
    frame_percent: float


def vertices_inside(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                    threads: Optional[int] = None) -> InsideVertices:
    """Returns how many vertices of each of two bodies are inside the other one, in each frame.

    model_a, model_b:  closed surfaces.
    poses_a, poses_b:  F frames, or one, in one frame of reference: palettes [F, J, 4, 4], `Poses` or
                       `Vertices`.

    Definition: a vertex is inside if the winding number of the other surface around it is not 0. A
    vertex on the surface is outside.
    Source: TUCH, selfcontact/selfcontact.py: winding number > 0.99, in floating point. `pelt` decides
    exactly, so it needs no threshold. The two differ only in regions that are inside out, with a
    negative winding number, which are inside here.

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
    Source: multiphys, metrics/collision.py: `get_frame_penetration`, with `contains` of trimesh.

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
    Source: "max penetration" of work on hands and objects, such as GraspTTA. PhysiGen sums the
    distances of all vertices instead, see `summed_depth`.

    Misjudges: this is not the distance by which bodies must be moved apart: a thin plate through the
    middle of a body has a small depth. Only vertices count.
    """
    a_in_b = pelt.deepest_vertex(model_a, poses_a, model_b, poses_b, threads=threads, progress=False)
    b_in_a = pelt.deepest_vertex(model_b, poses_b, model_a, poses_a, threads=threads, progress=False)
    per_frame = np.maximum(a_in_b.depth, b_in_a.depth)
    return Depth(per_frame, float(per_frame.max()), float(per_frame.mean()))


def summed_depth(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                 counted_a: Optional[Array] = None, counted_b: Optional[Array] = None,
                 threads: Optional[int] = None) -> SummedDepth:
    """Returns the sum of the depths of all vertices of two bodies inside each other, in each frame.

    Arguments: see `vertices_inside`. Lengths are in model units.
    counted_a, counted_b:  [V] flags; only vertices whose flag is not 0 count, for example those that
                           are not on the hands. Default: all vertices.

    Definition: the sum over all vertices of a inside b of the distance from the surface of b, plus the
    same for b inside a. The mean is the sum over all frames / F.
    Source: PhysiGen, coll_metric_mesh.py and sdf_loss.py: `forward_metric` / motion_len. There, only
    frames with vertices of the second body inside the first count as frames with penetration; its
    figures without hands ("wohand") also replace each hand of the surface by a point.

    Misjudges: the sum grows with the number of vertices, so it is not a length: compare only bodies
    with equal `faces`. Dense regions such as hands and face dominate it.
    """
    one = _depth_sums(model_a, poses_a, model_b, poses_b, "counted_a", counted_a, threads)
    other = _depth_sums(model_b, poses_b, model_a, poses_a, "counted_b", counted_b, threads)
    per_frame = one + other
    return SummedDepth(per_frame, float(per_frame.mean()), 100 * float((per_frame > 0).mean()))


def _depth_sums(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, name: str,
                counted: Optional[Array], threads: Optional[int]) -> Doubles:
    """Returns the sum of the depths of the vertices of a inside b, in each frame."""
    inside = pelt.vertices_inside(model_a, poses_a, model_b, poses_b, threads=threads, progress=False)
    if counted is not None:
        flags = integers(name, counted)
        if flags.shape != inside.shape[1:]:
            raise Error(f"{name}: expected the shape [{inside.shape[1]}], found {list(flags.shape)}")
        inside &= flags != 0
    frames, vertices = np.nonzero(inside)
    sums: Doubles = np.zeros(len(inside))
    if len(frames) == 0:
        return sums
    positions = pelt.posed_vertices(model_a, poses_a, threads=threads, progress=False)
    points = positions[frames if len(positions) > 1 else 0, vertices]
    # Frames have different numbers of points: only one frame at a time asks for its own.
    surface = pelt.posed_vertices(model_b, poses_b, threads=threads, progress=False)
    begins = np.searchsorted(frames, np.arange(len(inside) + 1))
    for frame in np.unique(frames):
        rows = slice(begins[frame], begins[frame + 1])
        body = Vertices(surface[frame if len(surface) > 1 else 0])
        sums[frame] = pelt.closest_points(model_b, body, points[rows], threads=1,
                                          progress=False).distance.sum()
    return sums
