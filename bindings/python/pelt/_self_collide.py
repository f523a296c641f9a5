"""Contacts of a model with itself."""

from __future__ import annotations

from typing import Optional

import numpy as np

from pelt import _pelt
from pelt._arrays import Array, Integers, integers
from pelt._contacts import Contacts, SelfContacts, limit
from pelt._model import Model
from pelt._near_joints import NearJoints
from pelt._poses import PosesLike, clip_poses
from pelt._run import Progress, run


class SelfFilter:
    """Pairs of triangles that `self_collide` leaves out. Make one for each model.

    rings:          0 to 64. 1: pairs that share a vertex; k: also pairs that a chain of k - 1 other
                    triangles connects. Skin creases at joints: 5 is what `pelt check` uses.
    takes_part:     [T] flags; pairs with a triangle whose flag is 0 are left out.
    at_rest:        [N, 2] pairs of triangles that touch at rest, for example
                    `next(iter(pelt.self_collide(model, rest_palette)))`.
    always:         [N, 2] pairs of triangles that touch in nearly all poses.
    joint_parents:  [J] parent of each joint, -1 for none: leaves out pairs of triangles that follow
                    one joint, or a joint and its parent.
    joint_pairs:    [N, 2] joints: leaves out pairs of triangles that follow two such joints.
    joint_bodies:   [J] numbers; joints with equal numbers count as one joint.
    joint_pairs_in_zones:  [N, 2] joints, as `joint_pairs`, but only where one of the `zones` contains
                    both triangles.
    zones:          [N, 2] a triangle, and the number of a zone that contains it.
    near_joints:    `NearJoints`: leaves out creases of the skin at joints. Gives joint_bodies,
                    joint_pairs, joint_pairs_in_zones and zones together.
    groups:         [T] group of each triangle.
    group_pairs:    [N, 2] groups: leaves out pairs of triangles of two such groups.

    A triangle follows the joint with the largest sum of weights over its vertices. Filters are
    applied in the order takes_part, rings, at_rest, always, joints, groups; `SelfContacts.left_out`
    counts a pair for the first one that leaves it out.
    """

    def __init__(self, model: Model, *, rings: int = 0, takes_part: Optional[Array] = None,
                 at_rest: Optional[Array] = None, always: Optional[Array] = None,
                 joint_parents: Optional[Array] = None, joint_pairs: Optional[Array] = None,
                 joint_bodies: Optional[Array] = None,
                 joint_pairs_in_zones: Optional[Array] = None, zones: Optional[Array] = None,
                 near_joints: Optional[NearJoints] = None, groups: Optional[Array] = None,
                 group_pairs: Optional[Array] = None) -> None:
        if near_joints is not None:
            if not all(given is None
                       for given in (joint_bodies, joint_pairs, joint_pairs_in_zones, zones)):
                raise _pelt.Error("near_joints: cannot be combined with joint_bodies, joint_pairs, "
                                  "joint_pairs_in_zones or zones")
            joint_bodies, joint_pairs, joint_pairs_in_zones, zones = near_joints

        def optional(name: str, value: Optional[Array]) -> Optional[Integers]:
            return None if value is None else integers(name, value)

        self._filter = _pelt.SelfFilter(
            model._model, limit("rings", rings), optional("takes_part", takes_part),
            optional("at_rest", at_rest), optional("always", always),
            optional("joint_bodies", joint_bodies), optional("joint_parents", joint_parents),
            optional("joint_pairs", joint_pairs),
            optional("joint_pairs_in_zones", joint_pairs_in_zones), optional("zones", zones),
            optional("groups", groups), optional("group_pairs", group_pairs))

    def leave_out(self, contacts: Contacts) -> SelfContacts:
        """Returns the contacts that this filter does not leave out.

        contacts:  of the model with itself, for example of `self_collide` without a filter, or of
                   `collide` between parts of it whose triangles are numbered as in the model.

        One query and several filters cost less than several queries.
        """
        pairs = np.stack([contacts.triangle_a, contacts.triangle_b], axis=1).astype(np.int64)
        kept, left_out = self._filter.kept_pairs(pairs)
        low, high = pairs[kept].min(axis=1, initial=2**31), pairs[kept].max(axis=1, initial=-1)
        return SelfContacts(contacts.frame[kept], low.astype(np.int32), high.astype(np.int32),
                            contacts.cut_short, left_out)


def _empty_filter(model: Model) -> _pelt.SelfFilter:
    """Making one takes as long as a query of tens of frames, so each model keeps its own."""
    if model._empty_filter is None:
        model._empty_filter = SelfFilter(model)._filter
    return model._empty_filter


def neighbours(model: Model) -> SelfFilter:
    """Returns the filter that leaves out pairs of triangles that share a corner."""
    if not isinstance(model._neighbours, SelfFilter):
        model._neighbours = SelfFilter(model, rings=1)
    return model._neighbours


def filter_of(model: Model, ignore: Optional[SelfFilter]) -> _pelt.SelfFilter:
    """Returns the filter of an argument; None leaves nothing out."""
    if ignore is None:
        return _empty_filter(model)
    if not isinstance(ignore, SelfFilter):
        raise TypeError(f"ignore: expected a pelt.SelfFilter, found {type(ignore).__name__}")
    return ignore._filter


def self_collide(model: Model, poses: PosesLike, ignore: Optional[SelfFilter] = None, *,
                 max_contacts: Optional[int] = None, threads: Optional[int] = None,
                 progress: Progress = None) -> SelfContacts:
    """Returns every pair of triangles of one model that intersect each other, in each frame.

    poses:         palettes [F, J, 4, 4] or [F, J, 3, 4], `Poses` or `Vertices`.
    ignore:        which pairs to leave out; default: none. Make the filter once and use it for all
                   clips.
    max_contacts:  stop the query of a frame after this number of pairs.

    Corners and edges that two triangles share do not count as intersection. The answer is exact with
    respect to the float32 posed vertices. The cost is O(V + T) for each frame.

    Raises `pelt.Error` for invalid arguments.
    """
    clip = clip_poses("poses", model, poses)
    with run("self_collide", clip.frame_count, threads, progress) as how:
        columns, left_out = _pelt.self_collide(clip, filter_of(model, ignore),
                                               limit("max_contacts", max_contacts), how)
        return SelfContacts(*columns, left_out)
