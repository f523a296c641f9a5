"""Inside and outside of closed surfaces."""

from __future__ import annotations

from typing import Optional

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, floats, with_axes
from pelt._contacts import Indices
from pelt._distance import SurfacePoints
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run


class Penetrations:
    """The deepest vertex of a model inside another one, in F frames.

    vertex:    [F] int32, -1 where no vertex is inside.
    depth:     [F] float64, distance of the vertex from the surface, in model units; 0 where no
               vertex is inside.
    position:  [F, 3] float32, of the vertex; NaN where no vertex is inside.
    closest:   `SurfacePoints` [F], closest point of the surface.
    """

    def __init__(self, vertex: Indices, depth: npt.NDArray[np.float64],
                 position: npt.NDArray[np.float32], closest: SurfacePoints) -> None:
        self.vertex = vertex
        self.depth = depth
        self.position = position
        self.closest = closest

    def __len__(self) -> int:
        return len(self.vertex)

    def __repr__(self) -> str:
        inside = int(np.count_nonzero(self.vertex >= 0))
        return (f"<pelt.Penetrations: in {inside} of {len(self)} frames, "
                f"deepest {self.depth.max():.6g}>")


def side_of(model: Model, poses: PosesLike, points: Array, *, threads: Optional[int] = None,
            progress: Progress = None) -> npt.NDArray[np.int8]:
    """Returns the side of each point in each frame [F, P]: -1 outside, 0 on the surface, 1 inside.

    points:  [P, 3] for all frames, or [F, P, 3], in the frame of the palettes.

    A point is inside if the winding number of the surface around it is not 0. Decisions are exact
    with respect to the float32 posed vertices. The surface must be closed (`Model.is_closed`).

    Raises `pelt.Error` for invalid arguments.
    """
    clip = clip_poses("poses", model, poses)
    given = with_axes("points", floats("points", points), 3)
    with run("side_of", clip.frame_count, threads, progress) as how:
        return _pelt.side_of(clip, given, how)


def winding_numbers(model: Model, poses: PosesLike, points: Array, *,
                    threads: Optional[int] = None,
                    progress: Progress = None) -> npt.NDArray[np.int32]:
    """Returns how often the surface encloses each point in each frame [F, P].

    points:  [P, 3] for all frames, or [F, P, 3], in the frame of the palettes.

    0 outside, 1 inside, 2 or more where the body overlaps itself, negative where the surface is
    inside out. Exact with respect to the float32 posed vertices. A point on the surface has no winding
    number, and the value 0; `side_of` returns 0 for such points only. The surface must be closed
    (`Model.is_closed`).

    Raises `pelt.Error` for invalid arguments.
    """
    clip = clip_poses("poses", model, poses)
    given = with_axes("points", floats("points", points), 3)
    with run("winding_numbers", clip.frame_count, threads, progress) as how:
        return _pelt.winding_numbers(clip, given, how)


def vertices_inside(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                    threads: Optional[int] = None,
                    progress: Progress = None) -> npt.NDArray[np.bool_]:
    """Returns whether each vertex of a is inside b, in each frame [F, V]. Vertices on the surface are
    not inside. See `side_of`."""
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    with run("vertices_inside", max(a.frame_count, b.frame_count), threads, progress) as how:
        return np.greater(_pelt.vertex_sides(a, b, how), 0)


def deepest_vertex(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                   threads: Optional[int] = None, progress: Progress = None) -> Penetrations:
    """Returns the vertex of a inside b that is farthest from the surface of b, in each frame.

    The depth is not the distance by which the bodies must be moved to separate them. The surface of
    b must be closed (`Model.is_closed`).

    Raises `pelt.Error` for invalid arguments.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    with run("deepest_vertex", max(a.frame_count, b.frame_count), threads, progress) as how:
        vertex, depth, position, triangle, weights, point = _pelt.deepest_vertex(a, b, how)
        return Penetrations(vertex, depth, position, SurfacePoints(triangle, weights, point))
