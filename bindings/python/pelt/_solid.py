"""Simple solids: planes, boxes, spheres, capsules."""

from __future__ import annotations

import math
from typing import Dict, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, floats, number
from pelt._contacts import Flags, Indices, rows_of_frame
from pelt._distance import SurfacePoints
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run


class HalfSpace(NamedTuple):
    """All points p with normal . p <= offset, such as what is below a floor.

    normal:  [3] or [F, 3], of any length; points out of the solid.
    offset:  a number or [F].

    The floor of motions with z up is `HalfSpace([0, 0, 1], 0)`.
    """

    normal: Array
    offset: Array = 0.0


class Box(NamedTuple):
    """All points with low <= p <= high on each axis.

    low, high:  [3] or [F, 3].
    """

    low: Array
    high: Array


class OrientedBox(NamedTuple):
    """All points p with abs(axes[i] . (p - centre)) <= half[i] for i = 0, 1, 2.

    centre:  [3] or [F, 3].
    half:    [3] or [F, 3], 0 or more; half of the lengths of the sides if the axes have length 1.
    axes:    [3, 3] or [F, 3, 3] linearly independent vectors, one in each row.
    """

    centre: Array
    half: Array
    axes: Array = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


class Sphere(NamedTuple):
    """All points at most `radius` from `centre`.

    centre:  [3] or [F, 3].
    radius:  a number or [F], 0 or more.
    """

    centre: Array
    radius: Array


class Capsule(NamedTuple):
    """All points at most `radius` from the segment between `a` and `b`.

    a, b:    [3] or [F, 3].
    radius:  a number or [F], 0 or more.
    """

    a: Array
    b: Array
    radius: Array


Solid = Union[HalfSpace, Box, OrientedBox, Sphere, Capsule]
"""A closed convex set in the frame of the palettes. Members with an axis F move it from frame to frame."""

# The sizes of the members, in the order of the extension.
_MEMBERS: Dict[type, Tuple[Tuple[str, Tuple[int, ...]], ...]] = {
    HalfSpace: (("normal", (3,)), ("offset", ())),
    Box: (("low", (3,)), ("high", (3,))),
    OrientedBox: (("centre", (3,)), ("axes", (3, 3)), ("half", (3,))),
    Sphere: (("centre", (3,)), ("radius", ())),
    Capsule: (("a", (3,)), ("b", (3,)), ("radius", ())),
}


class SolidContacts:
    """N triangles that touch a solid in F frames, in coordinate form.

    frame:     [N] int32, ascending.
    triangle:  [N] int32, ascending within a frame.
    inside:    [N] bool, whether the triangle is wholly in the solid.
    frames:    F.
    """

    def __init__(self, frame: Indices, triangle: Indices, inside: Flags, frames: int) -> None:
        self.frame = frame
        self.triangle = triangle
        self.inside = inside
        self.frames = frames

    def per_frame(self) -> npt.NDArray[np.int64]:
        """Returns the number of triangles in each frame [F]."""
        return np.bincount(self.frame, minlength=self.frames).astype(np.int64, copy=False)

    def in_frame(self, frame: int) -> Indices:
        """Returns the triangles in one frame [n]. O(log N)."""
        return self.triangle[rows_of_frame(self.frame, frame, self.frames)]

    def __len__(self) -> int:
        return len(self.frame)

    def __repr__(self) -> str:
        touched = int(np.count_nonzero(self.per_frame()))
        return (f"<pelt.SolidContacts: {len(self)} triangles in {touched} of {self.frames} frames, "
                f"{int(self.inside.sum())} of them inside>")


class SolidDistances:
    """Least distances of a model from a solid in F frames.

    distance:  [F] float64, in model units; infinite if nothing is within `max_distance`.
    surface:   `SurfacePoints` [F], the point of the surface at this distance.
    solid:     [F, 3] float32, the closest point of the solid; NaN where nothing was found.
    """

    def __init__(self, distance: npt.NDArray[np.float64], surface: SurfacePoints,
                 solid: npt.NDArray[np.float32]) -> None:
        self.distance = distance
        self.surface = surface
        self.solid = solid

    def __len__(self) -> int:
        return len(self.distance)

    def __repr__(self) -> str:
        return f"<pelt.SolidDistances: {len(self)} frames, least {self.distance.min():.6g}>"


def _clip_solid(solid: Solid) -> _pelt.ClipSolid:
    members = _MEMBERS.get(type(solid))
    if members is None:
        names = ", ".join(kind.__name__ for kind in _MEMBERS)
        raise TypeError(f"solid: expected one of {names}, found {type(solid).__name__}")
    kind = type(solid).__name__
    arrays = [(name, shape, floats(f"{kind}, {name}", getattr(solid, name)))
              for name, shape in members]
    moving = {len(array) for _, shape, array in arrays if array.ndim == len(shape) + 1}
    if len(moving - {1}) > 1:
        raise _pelt.Error(f"{kind}: its members have {' and '.join(map(str, sorted(moving)))} frames "
                          "(expected equal numbers)")
    frames = max(moving, default=1)
    return _pelt.ClipSolid(kind, np.concatenate(
        [_rows(f"{kind}, {name}", array, shape, frames) for name, shape, array in arrays], axis=1))


def _rows(name: str, array: npt.NDArray[np.floating], shape: Sequence[int],  # type: ignore[type-arg]
          frames: int) -> npt.NDArray[np.float64]:
    """Returns the numbers of a member [frames, n]."""
    if array.shape not in (tuple(shape), (1, *shape), (frames, *shape)):
        text = ", ".join(map(str, shape))
        moving = f"[F, {text}]" if text else "[F]"
        raise _pelt.Error(f"{name}: expected {f'[{text}]' if text else 'a number'} or {moving}, found "
                          f"the shape {list(array.shape)}")
    rows: npt.NDArray[np.float64] = np.empty((frames, math.prod(shape)))
    rows[:] = array.reshape(-1, rows.shape[1])
    return rows


def collide_solid(model: Model, poses: PosesLike, solid: Solid, *, threads: Optional[int] = None,
                  progress: Progress = None) -> SolidContacts:
    """Returns every triangle that touches a solid or is inside it, in each frame.

    poses:  palettes [F, J, 4, 4] or [F, J, 3, 4], `Poses` or `Vertices`.
    solid:  `HalfSpace`, `Box`, `OrientedBox`, `Sphere` or `Capsule`, in the frame of the palettes. It
            moves if its members have F frames.

    The answer is exact with respect to the float32 posed vertices and the numbers of the solid,
    rounded to float32. A triangle that only touches the solid is in the answer. The cost grows with
    the number of triangles at the boundary of the solid.

    Raises `pelt.Error` for invalid arguments.
    """
    clip, region = clip_poses("poses", model, poses), _clip_solid(solid)
    frames = max(clip.frame_count, region.frame_count)
    with run("collide_solid", frames, threads, progress) as how:
        return SolidContacts(*_pelt.collide_solid(clip, region, how), frames)


def solid_distance(model: Model, poses: PosesLike, solid: Solid, *, max_distance: float = math.inf,
                   threads: Optional[int] = None, progress: Progress = None) -> SolidDistances:
    """Returns the least distance of the surface from a solid, in each frame.

    poses, solid:  see `collide_solid`.
    max_distance:  ignore everything farther away.

    The distance is 0 if and only if a triangle touches the solid or is inside it, which is decided
    exactly; otherwise its error is less than 2^-45 of the largest coordinate (2^-22 for an
    `OrientedBox`).

    Raises `pelt.Error` for invalid arguments.
    """
    clip, region = clip_poses("poses", model, poses), _clip_solid(solid)
    frames = max(clip.frame_count, region.frame_count)
    with run("solid_distance", frames, threads, progress) as how:
        least, triangle, weights, position, on_solid = _pelt.solid_distance(
            clip, region, number("max_distance", max_distance), how)
        return SolidDistances(least, SurfacePoints(triangle, weights, position), on_solid)
