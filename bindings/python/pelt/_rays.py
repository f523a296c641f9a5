"""Rays against posed surfaces."""

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

_FACINGS = {"both": _pelt.Facing.both, "front": _pelt.Facing.front, "back": _pelt.Facing.back}


class RayHits:
    """First hits of R rays in F frames.

    triangle:      [F, R] int32, -1 for rays that hit nothing.
    t:             [F, R] float32, the hit is origin + t * direction; infinite if nothing is hit.
    barycentrics:  [F, R, 3] float32, weights of the vertices of the triangle.
    normal:        [F, R, 3] float32, unit normal of the triangle.
    """

    def __init__(self, triangle: Indices, t: npt.NDArray[np.float32],
                 barycentrics: npt.NDArray[np.float32], normal: npt.NDArray[np.float32]) -> None:
        self.triangle = triangle
        self.t = t
        self.barycentrics = barycentrics
        self.normal = normal

    @property
    def hit(self) -> npt.NDArray[np.bool_]:
        """Whether each ray hits anything [F, R]."""
        return np.greater_equal(self.triangle, 0)

    def __repr__(self) -> str:
        return f"<pelt.RayHits: {int(self.hit.sum())} of {self.triangle.size} rays hit>"


def cast_rays(model: Model, poses: PosesLike, origins: Array, directions: Array, *,
              t_min: float = 0, t_max: float = math.inf, facing: str = "both",
              threads: Optional[int] = None, progress: Progress = None) -> RayHits:
    """Returns the first hit of each ray, in each frame.

    origins, directions:  [R, 3] for all frames, or [F, R, 3], in the frame of the palettes.
                          Directions may have any length; t is in units of this length.
    t_min, t_max:         range of t.
    facing:               "front" or "back" hits only triangles from this side.

    Hits are exact with respect to the float32 posed vertices: no ray slips between triangles.

    Raises `pelt.Error` for invalid arguments.
    """
    clip = clip_poses("poses", model, poses)
    if facing not in _FACINGS:
        raise _pelt.Error(f"facing: expected 'both', 'front' or 'back', found {facing!r}")
    with run("cast_rays", clip.frame_count, threads, progress) as how:
        return RayHits(*_pelt.cast_rays(
            clip, with_axes("origins", floats("origins", origins), 3),
            with_axes("directions", floats("directions", directions), 3), number("t_min", t_min),
            number("t_max", t_max), _FACINGS[facing], how))
