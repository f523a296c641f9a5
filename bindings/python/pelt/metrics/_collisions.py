"""Shares of colliding triangles, and the filters of SMPLify-X."""

from typing import NamedTuple, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from pelt._arrays import Array, Integers, integers
from pelt._contacts import SelfContacts, limit
from pelt._model import Model
from pelt._pelt import Error
from pelt._poses import PosesLike, posed_vertices
from pelt._run import Progress
from pelt._self_collide import SelfFilter, self_collide

Counts = npt.NDArray[np.int64]
Percents = npt.NDArray[np.float64]

SMPLIFY_X_IGNORED: Tuple[Tuple[int, int], ...] = ((9, 16), (9, 17), (6, 16), (6, 17), (1, 2),
                                                  (12, 22))
"""Pairs of parts that the configuration of SMPLify-X ignores, as joints of SMPL-X."""


class CollidingTriangles(NamedTuple):
    """Collisions of a body with itself in F frames, see `colliding_triangles`."""

    pairs: Counts
    """[F] number of pairs of intersecting triangles"""

    percent: Percents
    """[F] 100 x pairs / T: may exceed 100"""

    triangles: Counts
    """[F] number of triangles that intersect another one"""

    triangle_percent: Percents
    """[F] 100 x triangles / T: at most 100"""


class CappedCollisions(NamedTuple):
    """Collisions within a cap in F frames, see `capped_colliding_triangles`."""

    pairs: Counts
    """[F] number of pairs within the cap"""

    percent: Percents
    """[F] 100 x pairs / T"""

    lost: Counts
    """[F] number of colliding pairs beyond the cap"""


def colliding_triangles(model: Model, poses: PosesLike, ignore: Optional[SelfFilter] = None, *,
                        threads: Optional[int] = None,
                        progress: Progress = None) -> CollidingTriangles:
    """Returns the share of colliding triangles of a body with itself, in each frame.

    model:   T triangles.
    poses:   F frames: palettes [F, J, 4, 4], `Poses` or `Vertices`.
    ignore:  which pairs to leave out, for example `smplify_x_filter`.

    Definition: 100 x pairs / T, in percent, where pairs counts the intersecting pairs of triangles.
    Triangles that share a corner or an edge count only if they meet elsewhere, too.
    Source: torch-mesh-isect, examples/detect_and_plot_collisions.py, there with a cap, see
    `capped_colliding_triangles`. This function has no cap.

    Misjudges: the share is one of pairs, so it grows with the resolution of the mesh: halving all
    edges halves it. Compare bodies only with equal `faces`. `triangle_percent` depends less on it.
    """
    contacts = self_collide(model, poses, ignore, threads=threads, progress=progress)
    return _collisions(contacts, model.triangle_count)


def _collisions(contacts: SelfContacts, count: int) -> CollidingTriangles:
    pairs = contacts.per_frame()
    ends = np.concatenate([contacts.triangle_a, contacts.triangle_b]).astype(np.int64)
    keys = np.unique(np.tile(contacts.frame.astype(np.int64), 2) * count + ends)
    triangles = np.bincount(keys // max(count, 1), minlength=contacts.frames)
    per_cent = 100 / max(count, 1)
    return CollidingTriangles(pairs, pairs * per_cent, triangles, triangles * per_cent)


def capped_colliding_triangles(model: Model, poses: PosesLike, faces: Array, *, cap: int = 8,
                               threads: Optional[int] = None) -> CappedCollisions:
    """Returns the share of colliding triangles as torch-mesh-isect counts it, in each frame.

    faces:  [T, 3] the triangles of the model.
    cap:    number of box hits that each triangle keeps; 8 is the default of torch-mesh-isect.

    Definition: for each triangle, the triangles of higher index whose bounding boxes overlap its own
    are its box hits, neighbours included. At most `cap` of them are kept. Pairs counts the kept hits
    whose triangles intersect; the share is 100 x pairs / T, in percent.
    Source: torch-mesh-isect, `BVH(max_collisions=8)` and examples/detect_and_plot_collisions.py.

    Saturates: deep collisions have more than `cap` box hits for each triangle, and the neighbours
    alone fill most of the cap in a fine mesh, so the share is at most 100 x cap percent and hides how
    bad a pose is. Which hits torch-mesh-isect keeps depends on the order in which it visits its tree.
    This function keeps those of lowest index instead, so that the answer can be reproduced: expect
    figures that are close to published ones, not equal. `colliding_triangles` has neither problem.
    """
    kept = limit("cap", cap)
    corners = integers("faces", faces)
    if corners.shape != (model.triangle_count, 3):
        raise Error(f"faces: expected the shape [{model.triangle_count}, 3], found "
                    f"{list(corners.shape)}")
    contacts = self_collide(model, poses, threads=threads, progress=False)
    pairs: Counts = np.zeros(contacts.frames, np.int64)
    for frame, positions in enumerate(posed_vertices(model, poses, threads=threads, progress=False)):
        pairs[frame] = _pairs_within_cap(positions[corners], contacts.in_frame(frame), kept)
    lost = contacts.per_frame() - pairs
    return CappedCollisions(pairs, 100 / max(model.triangle_count, 1) * pairs, lost)


def _pairs_within_cap(triangles: npt.NDArray[np.float32], pairs: npt.NDArray[np.int32],
                      cap: int) -> int:
    """Counts the pairs whose second triangle is among the first box hits of the first one."""
    low, high = triangles.min(axis=1), triangles.max(axis=1)
    count = 0
    for first in np.unique(pairs[:, 0]):
        above = slice(first + 1, None)
        overlap = ((low[above] <= high[first]) & (high[above] >= low[first])).all(axis=1)
        hits = np.flatnonzero(overlap)[:cap] + first + 1
        count += int(np.isin(pairs[pairs[:, 0] == first, 1], hits).sum())
    return count


def smplify_x_filter(model: Model, joint_parents: Optional[Array] = None, *,
                     segments: Optional[Array] = None, segment_parents: Optional[Array] = None,
                     ignored_pairs: Sequence[Tuple[int, int]] = SMPLIFY_X_IGNORED) -> SelfFilter:
    """Returns the filter that leaves out the pairs of triangles that SMPLify-X leaves out.

    joint_parents:    [J] parent of each joint, -1 for none: each triangle belongs to the joint with
                      the largest sum of weights over its corners.
    segments:         [T] part of each triangle, instead of the joints: the `segm` of a parts file.
    segment_parents:  [T] parent part of each triangle: the `parents` of a parts file.
    ignored_pairs:    pairs of parts; the default is that of SMPLify-X, for the joints of SMPL-X.

    Definition: a pair is left out if both triangles are of one part, if the part of one is the parent
    of the other's, or if the two parts are an ignored pair. Use it as
    `colliding_triangles(model, poses, smplify_x_filter(model, parents))`.
    Source: torch-mesh-isect, `FilterFaces`; smplify-x, cfg_files: `ign_part_pairs` "9,16 9,17 6,16 6,17
    1,2 12,22".

    Misjudges: collisions within a part, such as a folded hand or belly, and between a part and its
    parent, such as a forearm through its upper arm, never count. SMPLify-X keeps at most 128 box hits
    of each triangle; this filter has no cap.
    """
    if (joint_parents is None) == (segments is None) or (segments is None) != (segment_parents is None):
        raise Error("smplify_x_filter: expected joint_parents, or segments and segment_parents")
    if joint_parents is not None:
        known = [pair for pair in ignored_pairs if max(pair) < model.joint_count]
        return SelfFilter(model, joint_parents=joint_parents, joint_pairs=_pairs(known))
    parts = integers("segments", segments)
    parents = integers("segment_parents", segment_parents)
    if parts.shape != (model.triangle_count,) or parents.shape != parts.shape:
        raise Error(f"segments: expected the shape [{model.triangle_count}], found "
                    f"{list(parts.shape)} and {list(parents.shape)}")
    pairs = {(int(part), int(part)) for part in parts} | {tuple(pair) for pair in ignored_pairs}
    pairs |= {(int(a), int(b)) for a, b in zip(parts, parents) if b >= 0}
    return SelfFilter(model, groups=parts, group_pairs=_pairs(sorted(pairs)))


def _pairs(pairs: Sequence[Tuple[int, ...]]) -> Integers:
    return np.array(list(pairs), np.int64).reshape(-1, 2)
