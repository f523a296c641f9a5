"""Terrain."""

from __future__ import annotations

import math
from typing import Optional, Sequence

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, floats, number
from pelt._contacts import Contacts, limit
from pelt._distance import Distances, SurfacePoints
from pelt._model import Model
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run


class HeightField:
    """A grid of heights, with y up as in glTF. Make it once for all clips.

    heights:         [R, C]; row r and column c is the height at x = origin[0] + c * column_spacing and
                     z = origin[2] + r * row_spacing. NaN makes a hole.
    origin:          [3] is added to all vertices.
    column_spacing, row_spacing:  more than 0.

    rows, columns:   R, C.
    triangle_count:  T = 2 (R - 1) (C - 1). The cell between rows r and r + 1 and columns c and c + 1
                     has the triangles n = 2 (r (C - 1) + c) and n + 1.

    Motions with z up, such as those of AMASS, must be turned: x, y, z become x, z, -y.

    Raises `pelt.Error` for invalid arguments.
    """

    def __init__(self, heights: Array, *, origin: Sequence[float] = (0, 0, 0),
                 column_spacing: float = 1, row_spacing: float = 1) -> None:
        if len(origin) != 3:
            raise _pelt.Error(f"origin: expected three numbers, found {len(origin)}")
        x, y, z = (number("origin", value) for value in origin)
        self._field = _pelt.HeightField(floats("heights", heights), (x, y, z),
                                        number("column_spacing", column_spacing),
                                        number("row_spacing", row_spacing))

    @property
    def rows(self) -> int:
        """R"""
        return self._field.rows

    @property
    def columns(self) -> int:
        """C"""
        return self._field.columns

    @property
    def triangle_count(self) -> int:
        """T, with those that have a hole"""
        return self._field.triangle_count

    @property
    def triangles(self) -> npt.NDArray[np.float32]:
        """Vertices of the triangles [T, 3, 3]; the y of a hole is NaN."""
        return self._field.triangles

    def __repr__(self) -> str:
        return f"<pelt.HeightField: {self.rows} rows, {self.columns} columns>"


def _field_of(field: HeightField) -> _pelt.HeightField:
    if not isinstance(field, HeightField):
        raise TypeError(f"field: expected a pelt.HeightField, found {type(field).__name__}")
    return field._field


def collide_field(model: Model, poses: PosesLike, field: HeightField, *,
                  max_contacts: Optional[int] = None, threads: Optional[int] = None,
                  progress: Progress = None) -> Contacts:
    """Returns every pair of intersecting triangles of a model and a height field, in each frame.

    poses:         palettes [F, J, 4, 4] or [F, J, 3, 4], `Poses` or `Vertices`.
    max_contacts:  stop the query of a frame after this number of pairs.

    `triangle_b` of the contacts is a triangle of the field. A field is a surface and no solid: a body
    wholly below it has no contact. The answer is exact with respect to the float32 posed vertices.

    Raises `pelt.Error` for invalid arguments.
    """
    clip, terrain = clip_poses("poses", model, poses), _field_of(field)
    with run("collide_field", clip.frame_count, threads, progress) as how:
        return Contacts(*_pelt.collide_field(clip, terrain, limit("max_contacts", max_contacts), how))


def field_distance(model: Model, poses: PosesLike, field: HeightField, *,
                   max_distance: float = math.inf, threads: Optional[int] = None,
                   progress: Progress = None) -> Distances:
    """Returns the least distance of a model from a height field, in each frame.

    poses:         see `collide_field`.
    max_distance:  ignore everything farther away.

    `b` of the distances is on the field. The distance is 0 if and only if triangles intersect; a body
    below the field has a positive distance.

    Raises `pelt.Error` for invalid arguments.
    """
    clip, terrain = clip_poses("poses", model, poses), _field_of(field)
    with run("field_distance", clip.frame_count, threads, progress) as how:
        least, on_a, weights_a, point_a, on_b, weights_b, point_b = _pelt.field_distance(
            clip, terrain, number("max_distance", max_distance), how)
        return Distances(least, SurfacePoints(on_a, weights_a, point_a),
                         SurfacePoints(on_b, weights_b, point_b))
