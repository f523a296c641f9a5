"""Boxes and spheres."""

from __future__ import annotations

from typing import Optional

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._contacts import limit
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run

_Floats = npt.NDArray[np.float32]


class Bounds:
    """Boxes and spheres around a posed surface in F frames.

    low, high:  [F, 3] float32, corners of the box.
    centre:     [F, 3] float32, centre of the sphere.
    radius:     [F] float32, radius of the sphere.
    """

    def __init__(self, low: _Floats, high: _Floats, centre: _Floats, radius: _Floats) -> None:
        self.low = low
        self.high = high
        self.centre = centre
        self.radius = radius

    def __len__(self) -> int:
        return len(self.radius)

    def __repr__(self) -> str:
        return f"<pelt.Bounds: {len(self)} frames>"


def bounds(model: Model, poses: PosesLike, *, exact: bool = True, levels: int = 0,
           threads: Optional[int] = None, progress: Progress = None) -> Bounds:
    """Returns a box and a sphere that enclose all triangles, in each frame.

    exact:   True: the smallest box. False: a box that is guaranteed to enclose the surface, computed
             from the palette without posing vertices, a few per cent larger.
    levels:  with `exact=False`, number of levels of the tree to open for a tighter box.

    Raises `pelt.Error` for invalid arguments.
    """
    clip = clip_poses("poses", model, poses)
    with run("bounds", clip.frame_count, threads, progress) as how:
        return Bounds(*_pelt.bounds(clip, bool(exact), limit("levels", levels), how))
