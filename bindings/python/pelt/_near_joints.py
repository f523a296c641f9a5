"""Which joints of a character are neighbours in its body."""

from __future__ import annotations

from typing import NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, Integers, floats, integers
from pelt._model import Model

Indices = npt.NDArray[np.int32]


class NearJoints(NamedTuple):
    """Joints that are neighbours in the body, for `SelfFilter`; see `near_joints`."""

    bodies: Indices
    """[J] the rigid body of each joint, named by its lowest joint"""

    joint_pairs: Indices
    """[N, 2] bodies that are near everywhere"""

    joint_pairs_in_zones: Indices
    """[N, 2] bodies that are near in the zone of their joint"""

    zones: Indices
    """[N, 2] a triangle, and the number of a zone that contains it"""


def near_joints(model: Model, joint_parents: Array, *, positions: Optional[Array] = None,
                at_rest: Optional[Array] = None) -> NearJoints:
    """Returns which joints are neighbours, so that `SelfFilter` can leave out creases of the skin.

    joint_parents:  [J] parent of each joint, -1 for none.
    positions:      [V, 3] vertices in a pose in which each part of the body is in its place. Default:
                    the rest positions.
    at_rest:        [N, 2] pairs of triangles that touch in reference poses, found with the filter that
                    no `at_rest` gives: joints whose triangles touch there are near, too.

    Joints that share skin, such as upper arm and forearm, are near only in the zone of their joint: an
    upper arm in the ribs counts, the crease of the armpit does not. For a character of a file see
    `Character.self_filter`, which also treats joints that no clip moves as one body.

    Takes O(T log T + V). Raises `pelt.Error` for invalid arguments.
    """
    parents = integers("joint_parents", joint_parents)
    return of_bodies(model, np.arange(parents.size, dtype=np.int64), parents, positions, at_rest)


def of_bodies(model: Model, bodies: Integers, above: Integers, positions: Optional[Array],
              at_rest: Optional[Array]) -> NearJoints:
    """Returns which joints are neighbours.

    bodies:  [J] the lowest joint of the rigid body of each joint.
    above:   [J] the body above that body, or -1.
    """
    return NearJoints(*_pelt.near_joints(
        model._model, bodies, above,
        None if positions is None else floats("positions", positions),
        None if at_rest is None else integers("at_rest", at_rest)))
