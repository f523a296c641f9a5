"""Shares of colliding triangles, and the filters of SMPLify-X."""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from pelt._arrays import Array, Integers, integers
from pelt._contacts import SelfContacts, limit
from pelt._model import Model
from pelt._pelt import Error
from pelt._poses import PosesLike, posed_vertices
from pelt._run import Progress
from pelt._self_collide import SelfFilter, neighbours, self_collide

Counts = npt.NDArray[np.int64]
Percents = npt.NDArray[np.float64]

_BOXES_AT_A_TIME = 1024

SMPLIFY_X_IGNORED: Tuple[Tuple[int, int], ...] = ((9, 16), (9, 17), (6, 16), (6, 17), (1, 2),
                                                  (12, 22))
"""Pairs of parts that the configuration of SMPLify-X ignores, as joints of SMPL-X."""


class CollidingTriangles(NamedTuple):
    """Collisions of a body with itself in F frames, see `colliding_triangles`.

    pairs:             [F] number of pairs of intersecting triangles.
    percent:           [F] 100 x pairs / T: may exceed 100.
    triangles:         [F] number of triangles that intersect another one.
    triangle_percent:  [F] 100 x triangles / T: at most 100.
    """

    pairs: Counts
    percent: Percents
    triangles: Counts
    triangle_percent: Percents


class CappedCollisions(NamedTuple):
    """Collisions within a cap in F frames, see `capped_colliding_triangles`.

    pairs:     [F] number of pairs within the cap.
    percent:   [F] 100 x pairs / T.
    box_hits:  [F] number of pairs of triangles whose bounding boxes overlap, neighbours included.
    lost:      [F] number of colliding pairs beyond the cap: 0 unless there are more box hits than cap x T.
    """

    pairs: Counts
    percent: Percents
    box_hits: Counts
    lost: Counts


def colliding_triangles(model: Model, poses: PosesLike, ignore: Optional[SelfFilter] = None, *,
                        threads: Optional[int] = None,
                        progress: Progress = None) -> CollidingTriangles:
    """Returns the share of colliding triangles of a body with itself, in each frame.

    model:   T triangles.
    poses:   F frames: palettes [F, J, 4, 4], `Poses` or `Vertices`.
    ignore:  which pairs to leave out, for example `smplify_x_filter`. Default: pairs that share a
             corner, as torch-mesh-isect does. `pelt.SelfFilter(model)` leaves out nothing: triangles
             that share a corner then count if they meet elsewhere, too, as in creases.

    Definition: 100 x pairs / T, in percent, where pairs counts the intersecting pairs of triangles
    that share no corner.
    Source: torch-mesh-isect, examples/detect_and_plot_collisions.py and src/bvh_cuda_op.cu
    (`shareVertex`), there with a cap on box hits, see `capped_colliding_triangles`. This function has
    no cap, so it returns the value that torch-mesh-isect approaches with a large `max_collisions`.

    Misjudges: the share is one of pairs, so it grows with the resolution of the mesh: halving all
    edges halves it. Compare bodies only with equal `faces`. `triangle_percent` depends less on it.
    """
    contacts = self_collide(model, poses, ignore or neighbours(model), threads=threads,
                            progress=progress)
    return collisions_of(contacts, model.triangle_count)


def collisions_of(contacts: SelfContacts, count: int) -> CollidingTriangles:
    """Returns the shares of contacts of a body with this number of triangles."""
    pairs = contacts.per_frame()
    ends = np.concatenate([contacts.triangle_a, contacts.triangle_b]).astype(np.int64)
    keys = np.unique(np.tile(contacts.frame.astype(np.int64), 2) * count + ends)
    triangles = np.bincount(keys // max(count, 1), minlength=contacts.frames)
    per_cent = 100 / max(count, 1)
    return CollidingTriangles(pairs, pairs * per_cent, triangles, triangles * per_cent)


def capped_colliding_triangles(model: Model, poses: PosesLike, faces: Array, *, cap: int = 8,
                               threads: Optional[int] = None) -> CappedCollisions:
    """Returns the share of colliding triangles as torch-mesh-isect counts it, in each frame.

    model:  T triangles.
    poses:  F frames: palettes [F, J, 4, 4], `Poses` or `Vertices`.
    faces:  [T, 3] the triangles of the model.
    cap:    `max_collisions`; 8 is the default of torch-mesh-isect.

    Definition: box hits are the pairs of triangles whose bounding boxes overlap, neighbours included.
    At most cap x T of them are kept, for the mesh as a whole. Pairs counts the kept ones whose
    triangles intersect and share no corner; the share is 100 x pairs / T, in percent.
    Source: torch-mesh-isect, src/bvh_cuda_op.cu: `BVH(max_collisions=8)` allocates cap x T box hits,
    which all triangles share.

    Saturates: if there are more box hits than cap x T, torch-mesh-isect writes them behind its memory
    and its result is undefined; the neighbours alone are about 6 box hits for each triangle of a closed
    mesh. This function then keeps the box hits of lowest indices, so that the answer can be reproduced,
    and `lost` counts the colliding pairs beyond them. As long as `box_hits` is at most cap x T, nothing
    is lost, and the share is that of torch-mesh-isect, apart from its rounding, and that of
    `colliding_triangles`.
    """
    kept = limit("cap", cap)
    corners = integers("faces", faces)
    if corners.shape != (model.triangle_count, 3):
        raise Error(f"faces: expected the shape [{model.triangle_count}, 3], found "
                    f"{list(corners.shape)}")
    contacts = self_collide(model, poses, neighbours(model), threads=threads, progress=False)
    pairs: Counts = np.zeros(contacts.frames, np.int64)
    box_hits: Counts = np.zeros(contacts.frames, np.int64)
    for frame, positions in enumerate(posed_vertices(model, poses, threads=threads, progress=False)):
        hits = _box_hits(positions[corners])
        found = contacts.in_frame(frame).astype(np.int64)
        box_hits[frame] = len(hits)
        pairs[frame] = _count_within(found[:, 0] * len(corners) + found[:, 1], hits,
                                     kept * len(corners))
    lost = contacts.per_frame() - pairs
    return CappedCollisions(pairs, 100 / max(model.triangle_count, 1) * pairs, box_hits, lost)


def _count_within(keys: Counts, hits: Counts, most: int) -> int:
    """Counts the keys that are among the first box hits."""
    if len(hits) <= most:
        return len(keys)
    return int((keys < np.partition(hits, most)[most]).sum())


def _box_hits(triangles: npt.NDArray[np.float32]) -> Counts:
    """Returns a T + b for all pairs a < b of T triangles whose boxes overlap, in any order."""
    low, high = triangles.min(axis=1), triangles.max(axis=1)
    count = len(triangles)
    if count == 0:
        return np.zeros(0, np.int64)
    axis = int(np.argmax(high.max(axis=0) - low.min(axis=0)))
    order = np.argsort(low[:, axis], kind="stable")
    low, high = low[order], high[order]
    # In this order, the box of a triangle overlaps those after it up to `ends` along the axis.
    ends = np.searchsorted(low[:, axis], high[:, axis], side="right")
    found = []
    for begin in range(0, count, _BOXES_AT_A_TIME):
        rows = np.arange(begin, min(begin + _BOXES_AT_A_TIME, count))
        more = ends[rows] - rows - 1
        first = np.repeat(rows, more)
        second = first + 1 + np.arange(len(first)) - np.repeat(np.cumsum(more) - more, more)
        for other in {0, 1, 2} - {axis}:
            meets = ((low[first, other] <= high[second, other])
                     & (low[second, other] <= high[first, other]))
            first, second = first[meets], second[meets]
        a, b = order[first], order[second]
        found.append(np.minimum(a, b) * count + np.maximum(a, b))
    return np.concatenate(found)


def smplify_x_filter(model: Model, joint_parents: Optional[Array] = None, *,
                     segments: Optional[Array] = None, segment_parents: Optional[Array] = None,
                     ignored_pairs: Sequence[Tuple[int, int]] = SMPLIFY_X_IGNORED) -> SelfFilter:
    """Returns the filter that leaves out the pairs of triangles that SMPLify-X leaves out.

    model:            T triangles, J joints.
    joint_parents:    [J] parent of each joint, -1 for none: each triangle belongs to the joint with
                      the largest sum of weights over its corners.
    segments:         [T] part of each triangle, instead of the joints: the `segm` of a parts file.
    segment_parents:  [T] parent part of each triangle: the `parents` of a parts file.
    ignored_pairs:    pairs of parts; the default is that of SMPLify-X, for the joints of SMPL-X.

    Definition: a pair is left out if its triangles share a corner, if both are of one part, if the part
    of one is the parent of the other's, or if the two parts are an ignored pair. Use it as
    `colliding_triangles(model, poses, smplify_x_filter(model, parents))`.
    Source: torch-mesh-isect, src/bvh_cuda_op.cu (`shareVertex`) and `FilterFaces`; smplify-x, cfg_files:
    `ign_part_pairs` "9,16 9,17 6,16 6,17 1,2 12,22" for all body models.

    Misjudges: collisions within a part, such as a folded hand or belly, and between a part and its
    parent, such as a forearm through its upper arm, never count. The pair 12,22 is the neck and the jaw
    of SMPL-X. In SMPL and SMPL-H, 22 is a joint of the left hand: its contact with the neck is left out,
    and that of the right hand counts. `ignored_pairs=SMPLIFY_X_IGNORED[:-1]` counts both. SMPLify-X
    keeps at most 128 T box hits of T triangles; this filter has no cap.
    """
    if (joint_parents is None) == (segments is None) or (segments is None) != (segment_parents is None):
        raise Error("smplify_x_filter: expected joint_parents, or segments and segment_parents")
    if joint_parents is not None:
        known = [pair for pair in ignored_pairs if max(pair) < model.joint_count]
        return SelfFilter(model, rings=1, joint_parents=joint_parents, joint_pairs=_pairs(known))
    parts = integers("segments", segments)
    parents = integers("segment_parents", segment_parents)
    if parts.shape != (model.triangle_count,) or parents.shape != parts.shape:
        raise Error(f"segments: expected the shape [{model.triangle_count}], found "
                    f"{list(parts.shape)} and {list(parents.shape)}")
    pairs = {(int(part), int(part)) for part in parts} | {tuple(pair) for pair in ignored_pairs}
    pairs |= {(int(a), int(b)) for a, b in zip(parts, parents) if b >= 0}
    return SelfFilter(model, rings=1, groups=parts, group_pairs=_pairs(sorted(pairs)))


def _pairs(pairs: Sequence[Tuple[int, ...]]) -> Integers:
    return np.array(list(pairs), np.int64).reshape(-1, 2)
