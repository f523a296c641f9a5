"""Volumes of intersection."""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

import pelt
from pelt import _pelt
from pelt._model import Model
from pelt._pelt import Error
from pelt._poses import PosesLike, Vertices, clip_poses
from pelt._run import Progress, run

Doubles = npt.NDArray[np.float64]
Floats = npt.NDArray[np.float32]

_MAX_VOXELS = 50_000_000


class Volumes(NamedTuple):
    """Volumes in F frames.

    value:  [F] in cubed model units.
    error:  [F] the exact volume of the float32 posed surfaces differs from the value by at most this.
    """

    value: Doubles
    error: Doubles


class VoxelVolume(NamedTuple):
    """Volumes in F frames by voxels, see `voxel_intersection_volume`.

    volume:   [F] in cubed model units.
    percent:  [F] 100 x volume / volume of all voxels inside; 0 if there are none.
    """

    volume: Doubles
    percent: Doubles


def volume(model: Model, poses: PosesLike, *, threads: Optional[int] = None,
           progress: Progress = None) -> Volumes:
    """Returns the volume of a closed body, in each frame, in cubed model units.

    model:  a closed surface.
    poses:  F frames: palettes [F, J, 4, 4], `Poses` or `Vertices`.

    Definition: the integral of the winding number. Regions that the surface encloses twice count
    twice, and regions that are inside out count negatively. The cost is O(V + T) for each frame.
    Source: the divergence theorem, as `Trimesh.volume` of trimesh uses it, there in floating point
    without a bound of the error.

    Raises `pelt.Error` if the surface of the model is not closed.
    """
    clip = clip_poses("poses", model, poses)
    with run("volume", clip.frame_count, threads, progress) as how:
        return Volumes(*_pelt.volume(clip, how))


def self_intersection_volume(model: Model, poses: PosesLike, *, threads: Optional[int] = None,
                             progress: Progress = None) -> Volumes:
    """Returns the volume that a closed body shares with itself, in each frame, in cubed model units.

    model:  a closed surface.
    poses:  F frames: palettes [F, J, 4, 4], `Poses` or `Vertices`.

    Definition: the integral of w (w - 1) / 2, where w is the winding number: a region that the surface
    encloses twice counts once. A region that is inside out, with w = -1, counts once, too. Rounding
    never makes the value negative. The cost is little more than that of `self_collide`.
    Source: the exact counterpart of the voxels of humansphereproxy with an in-count of 2 or more, see
    `voxel_self_intersection_volume`, which counts a region that the surface encloses twice as 2.

    Misjudges: skin creases at bent joints are inside out in many poses of linear blend skinning.
    If all triangles face inwards, the whole body is inside out and counts: `volume` is then negative.

    Raises `pelt.Error` if the surface of the model is not closed.
    """
    clip = clip_poses("poses", model, poses)
    with run("self_intersection_volume", clip.frame_count, threads, progress) as how:
        value, error = _pelt.self_intersection_volume(clip, how)
        return Volumes(np.maximum(value, 0), error)


def intersection_volume(model_a: Model, poses_a: PosesLike, model_b: Model, poses_b: PosesLike, *,
                        threads: Optional[int] = None, progress: Progress = None) -> Volumes:
    """Returns the volume inside two closed bodies, in each frame, in cubed model units.

    model_a, model_b:  closed surfaces.
    poses_a, poses_b:  F frames, or one, in one frame of reference: palettes [F, J, 4, 4], `Poses` or
                       `Vertices`.

    Definition: the integral of the product of the winding numbers, which is the volume of the points
    inside both bodies if neither intersects itself. All decisions are exact; the value has a stated
    error of rounding.
    Source: "intersection volume" of work on hands and objects, such as GraspTTA, there by voxels.

    Misjudges: a body that intersects itself counts such regions several times. The value is negative if
    the triangles of one body face inwards.

    Raises `pelt.Error` if a surface is not closed.
    """
    a, b = clip_poses("poses_a", model_a, poses_a), clip_poses("poses_b", model_b, poses_b)
    with run("intersection_volume", max(a.frame_count, b.frame_count), threads, progress) as how:
        return Volumes(*_pelt.intersection_volume(a, b, how))


def voxel_intersection_volume(bodies: Sequence[Tuple[Model, PosesLike]], *, side: float = 0.06,
                              threads: Optional[int] = None) -> VoxelVolume:
    """Returns the volume that is inside two or more bodies, in steps of a voxel, in each frame, in cubed
    model units.

    bodies:  (model, poses) of closed surfaces; poses have F frames, or one. For a body with itself see
             `voxel_self_intersection_volume`; the parts of `BodyParts` are bodies, too.
    side:    of a voxel, in model units. Default: 6 cm in metres.

    Definition: the number of voxels whose centres are inside two or more bodies, times side^3; the
    share is relative to the voxels inside at least one. Centres are at (i + 1/2) x side from the
    origin, for integers i.
    Source: work on hands and objects, such as GraspTTA, with voxels of 5 mm.

    Saturates and misjudges: the smallest volume is one voxel, with the default 216 cm^3, about that of
    a hand. Thinner penetrations are found by chance, and the answer changes when bodies move together
    by less than a voxel. `intersection_volume` has neither problem.
    """
    if not 0 < side < np.inf or not bodies:
        raise Error(f"voxel_intersection_volume: expected bodies and a positive side, found {side!r}")
    positions = [pelt.posed_vertices(model, poses, threads=threads, progress=False)
                 for model, poses in bodies]
    frames = max(len(of_body) for of_body in positions)
    volume: Doubles = np.zeros(frames)
    percent: Doubles = np.zeros(frames)
    for frame in range(frames):
        of_frame = [of_body[min(frame, len(of_body) - 1)] for of_body in positions]
        counts = _in_counts(bodies, of_frame, frame, side, threads)
        shared, inside = int((counts >= 2).sum()), int((counts >= 1).sum())
        volume[frame] = shared * side**3
        percent[frame] = 100 * shared / max(inside, 1)
    return VoxelVolume(volume, percent)


def voxel_self_intersection_volume(model: Model, poses: PosesLike, *, side: float = 0.06,
                                   threads: Optional[int] = None) -> VoxelVolume:
    """Returns the volume that a closed body shares with itself, in steps of a voxel, in each frame, in
    cubed model units.

    model:  a closed surface.
    poses:  F frames: palettes [F, J, 4, 4], `Poses` or `Vertices`.
    side:   of a voxel, in model units. Default: 6 cm in metres.

    Definition: the in-count of a voxel is the winding number of the surface around its centre. The
    volume is the sum of all in-counts of 2 or more, times side^3: a region that the surface encloses
    twice counts as 2. The share is relative to the sum of all in-counts, times side^3. Centres are at
    (i + 1/2) x side from the origin, for integers i.
    Source: humansphereproxy (Bosch Research), eval/metrics.py: `calculate_selfintersection_volume`
    with prec 0.06, in cm^3; there, the body is first centred and scaled into the unit sphere, and its
    voxels are 0.0588 apart but count as 0.06^3. Scale the poses in the same way to compare figures.

    Saturates and misjudges: the smallest volume is two voxels, 432 cm^3. Penetrations thinner than 6 cm
    are found by chance. Regions that are inside out, such as creases, lower the volume of the whole
    body. `self_intersection_volume` is exact.

    Raises `pelt.Error` if the surface of the model is not closed.
    """
    if not 0 < side < np.inf:
        raise Error(f"side: expected a positive number, found {side!r}")
    positions = pelt.posed_vertices(model, poses, threads=threads, progress=False)
    volume: Doubles = np.zeros(len(positions))
    percent: Doubles = np.zeros(len(positions))
    for frame, vertices in enumerate(positions):
        points = (_centres(vertices, frame, side) + 0.5) * side
        counts = pelt.winding_numbers(model, Vertices(vertices), points, threads=threads,
                                      progress=False)[0]
        shared, whole = int(counts[counts >= 2].sum()), int(counts.sum())
        volume[frame] = shared * side**3
        percent[frame] = 100 * shared / whole if whole else 0
    return VoxelVolume(volume, percent)


def _in_counts(bodies: Sequence[Tuple[Model, PosesLike]], positions: Sequence[Floats], frame: int,
               side: float, threads: Optional[int]) -> npt.NDArray[np.int64]:
    """Returns in how many bodies the centre of each voxel is that is inside any."""
    counts = []
    for (model, _), vertices in zip(bodies, positions):
        centres = _centres(vertices, frame, side)
        if len(centres) == 0:
            continue
        points = (centres + 0.5) * side
        sides = pelt.side_of(model, Vertices(vertices), points, threads=threads, progress=False)
        counts.append(centres[sides[0] > 0])
    if not counts:
        return np.zeros(0, np.int64)
    found: npt.NDArray[np.int64] = np.unique(np.concatenate(counts), axis=0, return_counts=True)[1]
    return found


def _centres(vertices: Floats, frame: int, side: float) -> npt.NDArray[np.int64]:
    """Returns the integers (i, j, k) of the voxels whose centres are in the box of a body."""
    low = np.ceil(vertices.min(axis=0) / side - 0.5).astype(np.int64)
    high = np.floor(vertices.max(axis=0) / side - 0.5).astype(np.int64)
    sizes = np.maximum(high - low + 1, 0)
    if float(np.prod(sizes.astype(np.float64))) > _MAX_VOXELS:
        raise Error(f"side: frame {frame} would need more than {_MAX_VOXELS} voxels")
    axes = [np.arange(start, start + size) for start, size in zip(low, sizes)]
    centres: npt.NDArray[np.int64] = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    return centres
