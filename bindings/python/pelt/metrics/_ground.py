"""Bodies and the ground: penetration, floating, skating."""

from __future__ import annotations

from typing import NamedTuple, Optional

import numpy as np
import numpy.typing as npt

import pelt
from pelt._arrays import Array, floats, number
from pelt._model import Model
from pelt._pelt import Error
from pelt._poses import PosesLike

Doubles = npt.NDArray[np.float64]


class Ground(NamedTuple):
    """A body and the ground in F frames, see `ground`. All lengths are in model units.

    penetrate:  [F] how deep the lowest vertex is below the ground; 0 within the tolerance.
    floating:   [F] how high the lowest vertex is above the ground; 0 within the tolerance.
    skate:      [F - 1] mean horizontal displacement, from each frame to the next, of the vertices that are
                on or below the ground in both; 0 without such vertices.
    """

    penetrate: Doubles
    floating: Doubles
    skate: Doubles


def ground(model: Model, poses: PosesLike, *, up: Array = (0, 0, 1), height: float = 0.0,
           tolerance: float = 0.005, threads: Optional[int] = None) -> Ground:
    """Returns how a body penetrates the ground, floats above it, and skates on it, in each frame.

    model:      any surface; it need not be closed.
    poses:      F frames: palettes [F, J, 4, 4], `Poses` or `Vertices`.
    up:         [3] direction out of the ground, of any length. Default: z, as in AMASS.
    height:     of the ground along `up`.
    tolerance:  smaller penetrations and heights count as 0. Default: 5 mm in metres.

    Definition: penetrate is the distance between the ground and the lowest vertex if that is below it,
    floating if that is above it. Skate is the mean displacement along the ground of the vertices that
    are at most at the height of the ground in two consecutive frames. All are in model units. Papers
    give the means over all frames, in millimetres: `1000 * ground(...).penetrate.mean()`. Their
    Phys-Err is the sum of the three means.
    Heights are computed in float64. Unless `up` is along an axis, vertices nearer to the ground than
    2^-48 times the largest coordinate or height may count as above or below it.
    Source: PhysDiff (Yuan et al., ICCV 2023), "Penetrate", "Float", "Skate" with a tolerance of 5 mm;
    its skate uses joints of the feet. UniversalHumanoidControl, uhc/smpllib/smpl_eval.py, uses
    vertices, as this function does.

    Misjudges: some programs take the lowest of the vertices above the ground for floating, so that a
    coarse body that stands in the ground also floats; here, it does not. Lying and sitting bodies
    skate by the vertices of all their parts. The triangles at the ground are those of
    `pelt.collide_solid(model, poses, pelt.HalfSpace(up, height))`, if `up` has the length 1.
    """
    along = floats("up", up).astype(np.float64)
    if along.shape != (3,) or not np.isfinite(along).all() or not along.any():
        raise Error(f"up: expected a direction [3], found {np.asarray(up).tolist()}")
    along /= np.abs(along).max()  # so that no square overflows or becomes 0
    along /= np.linalg.norm(along)
    level, least = number("height", height), number("tolerance", tolerance)
    if not (np.isfinite(level) and 0 <= least < np.inf):
        raise Error("height, tolerance: expected finite numbers, and a tolerance of 0 or more")
    positions = pelt.posed_vertices(model, poses, threads=threads, progress=False).astype(np.float64)
    heights = positions @ along - level
    lowest: Doubles = heights.min(axis=1)
    return Ground(np.where(lowest < -least, -lowest, 0), np.where(lowest > least, lowest, 0),
                  _skate(positions, heights, along))


def _skate(positions: Doubles, heights: Doubles, along: Doubles) -> Doubles:
    """Returns the mean horizontal displacement of the vertices that stay on or below the ground."""
    stays = (heights[:-1] <= 0) & (heights[1:] <= 0)
    moves = np.diff(positions, axis=0)
    moves -= (moves @ along)[:, :, np.newaxis] * along
    sums = (np.linalg.norm(moves, axis=2) * stays).sum(axis=1)
    mean: Doubles = sums / np.maximum(stays.sum(axis=1), 1)
    return mean
