"""Contacts of two models."""

from __future__ import annotations

from typing import Optional

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import number
from pelt._contacts import Contacts, limit
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run


def collide(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
            max_contacts: Optional[int] = None, threads: Optional[int] = None,
            progress: Progress = None) -> Contacts:
    """Returns every pair of intersecting triangles of two models, in each frame.

    poses_a, poses_b:  palettes [F, J, 4, 4] or [F, J, 3, 4], `Poses` or `Vertices`. Both have F
                       frames, or one of them has one frame.
    max_contacts:      stop the query of a frame after this number of pairs; which are found first is
                       unspecified.

    The answer is exact with respect to the float32 posed vertices. Triangles that only touch, or
    overlap in one plane, intersect. A body that is wholly inside another one has no contact: see
    `vertices_inside`. The cost grows with the contact area, not with the size of the meshes.

    Raises `pelt.Error` for invalid arguments.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    with run("collide", max(a.frame_count, b.frame_count), threads, progress) as how:
        return Contacts(*_pelt.collide(a, b, limit("max_contacts", max_contacts), how))


def intersects(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
               threads: Optional[int] = None,
               progress: Progress = None) -> npt.NDArray[np.bool_]:
    """Returns whether any triangles of two models intersect, in each frame [F].

    Like `collide`, but stops at the first contact of a frame.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    with run("intersects", max(a.frame_count, b.frame_count), threads, progress) as how:
        return _pelt.intersects(a, b, how)


def clearance(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike,
              tolerance: float, *, max_contacts: Optional[int] = None,
              threads: Optional[int] = None, progress: Progress = None) -> Contacts:
    """Returns every pair of triangles whose distance is at most `tolerance`, in each frame.

    tolerance:  in model units, 0 or more. With 0, the pairs are those of `collide`.

    Other arguments, exactness and errors: see `collide`.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    with run("clearance", max(a.frame_count, b.frame_count), threads, progress) as how:
        return Contacts(*_pelt.clearance(a, b, number("tolerance", tolerance),
                                         limit("max_contacts", max_contacts), how))
