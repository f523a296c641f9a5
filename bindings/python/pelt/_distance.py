"""Distances of surfaces from each other and from points."""

from __future__ import annotations

import math
from typing import Optional

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, floats, number, with_axes
from pelt._contacts import Indices
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run

_Floats = npt.NDArray[np.float32]
_Doubles = npt.NDArray[np.float64]


class SurfacePoints:
    """Points of a posed surface.

    triangle:      [...] int32, -1 where nothing was found.
    barycentrics:  [..., 3] float32, weights of the vertices of the triangle.
    position:      [..., 3] float32, NaN where nothing was found.
    """

    def __init__(self, triangle: Indices, barycentrics: _Floats, position: _Floats) -> None:
        self.triangle = triangle
        self.barycentrics = barycentrics
        self.position = position

    def __repr__(self) -> str:
        return f"<pelt.SurfacePoints: {list(self.triangle.shape)}>"


class Distances:
    """Least distances of two models in F frames.

    distance:  [F] float64, in model units; infinite if nothing is within `max_distance`.
    a, b:      `SurfacePoints` [F], points of the two surfaces at this distance.
    """

    def __init__(self, distance: _Doubles, a: SurfacePoints, b: SurfacePoints) -> None:
        self.distance = distance
        self.a = a
        self.b = b

    def __len__(self) -> int:
        return len(self.distance)

    def __repr__(self) -> str:
        return f"<pelt.Distances: {len(self)} frames, least {self.distance.min():.6g}>"


class ClosestPoints:
    """Points of a surface that are closest to P points in F frames.

    distance:  [F, P] float64, in model units; infinite if nothing is within `max_distance`.
    point:     `SurfacePoints` [F, P].
    """

    def __init__(self, distance: _Doubles, point: SurfacePoints) -> None:
        self.distance = distance
        self.point = point

    def __repr__(self) -> str:
        return f"<pelt.ClosestPoints: {list(self.distance.shape)}>"


def distance(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
             max_distance: float = math.inf, tolerance: float = 0, threads: Optional[int] = None,
             progress: Progress = None) -> Distances:
    """Returns the least distance of the surfaces of two models, in each frame.

    poses_a, poses_b:  as for `collide`.
    max_distance:      ignore everything farther away, which is faster.
    tolerance:         allowed difference from the least distance, which is faster. Points may then
                       depend on the number of threads.

    The distance is 0 if and only if triangles intersect, which is decided exactly; the points are
    then on the lowest intersecting pair. A surface is not a solid: a body inside another one that it
    does not touch has a positive distance. Of equally distant triangles, the lowest are returned.

    Raises `pelt.Error` for invalid arguments.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    with run("distance", max(a.frame_count, b.frame_count), threads, progress) as how:
        least, on_a, weights_a, point_a, on_b, weights_b, point_b = _pelt.distance(
            a, b, number("max_distance", max_distance), number("tolerance", tolerance), how)
        return Distances(least, SurfacePoints(on_a, weights_a, point_a),
                         SurfacePoints(on_b, weights_b, point_b))


def closest_points(model: Model, poses: PosesLike, points: Array, *,
                   max_distance: float = math.inf, threads: Optional[int] = None,
                   progress: Progress = None) -> ClosestPoints:
    """Returns, for each point, the point of the surface that is closest to it, in each frame.

    points:        [P, 3] for all frames, or [F, P, 3], in the frame of the palettes.
    max_distance:  ignore everything farther away.

    Raises `pelt.Error` for invalid arguments.
    """
    clip = clip_poses("poses", model, poses)
    given = with_axes("points", floats("points", points), 3)
    with run("closest_points", clip.frame_count, threads, progress) as how:
        least, triangle, weights, position = _pelt.closest_points(
            clip, given, number("max_distance", max_distance), how)
        return ClosestPoints(least, SurfacePoints(triangle, weights, position))
