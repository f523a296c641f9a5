"""Body models of the SMPL family: SMPL, SMPL-H, SMPL-X.

    import pelt
    from pelt import body_models, motions

    body = body_models.load("SMPLH_MALE.npz")          # V vertices, T triangles, J joints
    motion = motions.load("walk_poses.npz")            # F frames, of AMASS
    subject = body.subject(motion.betas)               # one pelt.Model for each shape
    contacts = pelt.self_collide(subject.model, subject.poses(motion))

Positions are in metres. The frame is that of the motion: z is up in AMASS.
"""

from __future__ import annotations

from typing import Any, Dict, Iterator, Optional, Tuple, cast

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, floats
from pelt._model import Model
from pelt._npz import LARGEST, Npz, Path, refuse_pickle
from pelt._pelt import Error
from pelt._poses import Vertices
from pelt._run import run
from pelt.motions import Motion

Doubles = npt.NDArray[np.float64]

__all__ = ["BodyModel", "Subject", "load", "rotations"]

_KEYS = "v_template shapedirs posedirs J_regressor weights kintree_table f"


class BodyModel:
    """A body model: a template, and how shape and pose deform it.

    template:          [V, 3] positions of the mean shape, in metres.
    shape_directions:  [V, 3, B] displacements for one unit of each shape parameter.
    pose_directions:   [V, 3, 9 (J - 1)] displacements for one unit of each element of the rotations
                       of the joints 1, ..., J - 1, minus the identity.
    joint_regressor:   [J, V] weights that make joints of vertices.
    weights:           [V, J] weights of linear blend skinning.
    parents:           [J] parent of each joint, -1 for the root, which is joint 0.
    faces:             [T, 3] indices of vertices.
    """

    def __init__(self, template: Doubles, shape_directions: Doubles, pose_directions: Doubles,
                 joint_regressor: Doubles, weights: Doubles, parents: npt.NDArray[np.int64],
                 faces: npt.NDArray[np.int64]) -> None:
        self.template = template
        self.shape_directions = shape_directions
        self.pose_directions = pose_directions
        self.joint_regressor = joint_regressor
        self.weights = weights
        self.parents = parents
        self.faces = faces

    @property
    def joint_count(self) -> int:
        """J"""
        return len(self.parents)

    def subject(self, betas: Array = ()) -> "Subject":
        """Returns the body of one subject. Make it once for all clips of the subject.

        betas:  [b] shape parameters, b at most B; the others are 0.

        Takes O(T log T) for the model.
        """
        values = floats("betas", np.asarray(betas, np.float64)).reshape(-1)
        if len(values) > self.shape_directions.shape[2]:
            raise Error(f"betas: {len(values)} shape parameters, but the body model has "
                        f"{self.shape_directions.shape[2]}: give no more, for example betas[:10]")
        if not np.isfinite(values).all():
            raise Error("betas: expected finite numbers")
        with np.errstate(over="ignore", invalid="ignore"):
            rest = self.template + self.shape_directions[:, :, :len(values)] @ values
        wrong = np.flatnonzero(~(np.abs(rest) <= LARGEST).all(axis=1))  # also those that are NaN
        if len(wrong):
            raise Error(f"betas: vertex {wrong[0]} of this shape is at {rest[wrong[0]].tolist()}, expected "
                        "within 2^60: use smaller shape parameters; those of people are mostly from -5 to 5")
        return Subject(self, rest)

    def __repr__(self) -> str:
        return (f"<pelt.body_models.BodyModel: {len(self.template)} vertices, {len(self.faces)} "
                f"triangles, {self.joint_count} joints, {self.shape_directions.shape[2]} shape "
                f"parameters>")


class Subject:
    """The body of one subject: a shape that motions pose.

    body:    the `BodyModel`.
    rest:    [V, 3] rest positions, in metres.
    joints:  [J, 3] rest positions of the joints, which depend on the shape.
    model:   the `pelt.Model`.
    """

    def __init__(self, body: BodyModel, rest: Doubles) -> None:
        self.body = body
        self.rest = rest
        self.joints: Doubles = body.joint_regressor @ rest
        self.model = Model(rest, body.faces, body.weights, renormalise=True)

    def palettes(self, motion: Motion) -> Doubles:
        """Returns the palettes [F, J, 4, 4] of a motion, by forward kinematics. Pelt poses without
        pose correctives by them: less memory than `poses`, and shapes that are wrong at bent
        joints."""
        return self._palettes(self._rotations(motion), motion.translations)

    def poses(self, motion: Motion, *, threads: Optional[int] = None) -> Vertices:
        """Returns the vertices [F, V, 3] of a motion, in float32, with pose correctives: the positions
        of `smplx.lbs` for the same parameters, computed in float64.

        Takes 12 F V bytes: use `chunks` for long clips.
        """
        turns = self._rotations(motion)
        palettes = self._palettes(turns, motion.translations)
        features = (turns[:, 1:] - np.eye(3)).reshape(len(motion), -1)
        with run("poses", len(motion), threads, False) as how:
            return Vertices(_pelt.body_vertices(
                self.rest, self.body.pose_directions, self.body.weights, features,
                palettes[:, :, :3].reshape(*palettes.shape[:2], 12), how))

    def chunks(self, motion: Motion, frames: int = 128, *,
               threads: Optional[int] = None) -> Iterator[Tuple[int, Vertices]]:
        """Yields the first frame and the `poses` of at most `frames` consecutive frames at a time."""
        for first in range(0, len(motion), frames):
            yield first, self.poses(motion[first:first + frames], threads=threads)

    def _rotations(self, motion: Motion) -> Doubles:
        count = self.body.joint_count
        if motion.poses.shape[1] != 3 * count:
            raise Error(f"motion: has poses of {motion.poses.shape[1] // 3} joints, but the body model "
                        f"has {count}. Use the body model that the motion was made for "
                        f"(24 joints: SMPL, 52: SMPL-H, 55: SMPL-X), or ignore hands and face by "
                        f"`--body-only`, or `motion.body_only({count})`")
        return rotations(motion.poses.reshape(-1, count, 3))

    def _palettes(self, turns: Doubles, translations: Doubles) -> Doubles:
        world: Doubles = np.zeros((*turns.shape[:2], 4, 4))
        world[:, :, :3, :3] = turns
        world[:, :, 3, 3] = 1
        world[:, 0, :3, 3] = self.joints[0] + translations
        for joint in range(1, self.body.joint_count):
            parent = self.body.parents[joint]
            world[:, joint, :3, 3] = self.joints[joint] - self.joints[parent]
            world[:, joint] = world[:, parent] @ world[:, joint]
        # The inverse bind matrix of a joint is the translation by minus its rest position.
        world[:, :, :3, 3] -= np.einsum("fjab,jb->fja", world[:, :, :3, :3], self.joints)
        return world


def rotations(axis_angles: Array) -> Doubles:
    """Returns the rotation matrices [..., 3, 3] of rotation vectors [..., 3] in radians, by the
    formula of Rodrigues."""
    vectors = floats("axis_angles", axis_angles).astype(np.float64)
    angles = np.linalg.norm(vectors, axis=-1, keepdims=True)
    # The axis of a zero rotation does not matter.
    x, y, z = np.moveaxis(vectors / np.maximum(angles, 1e-300), -1, 0)
    zero = np.zeros_like(x)
    cross: Doubles = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], -1).reshape(*x.shape, 3, 3)
    turn = angles[..., np.newaxis]
    return cast(Doubles, np.eye(3) + np.sin(turn) * cross + (1 - np.cos(turn)) * (cross @ cross))


def load(path: Path) -> BodyModel:
    """Returns the body model of an `.npz` file with the keys of the SMPL family.

    v_template     [V, 3]
    shapedirs      [V, 3, B]
    posedirs       [V, 3, 9 (J - 1)]
    J_regressor    [J, V], dense
    weights        [V, J], dense
    kintree_table  [2, J]: parents, and the numbers of the joints
    f              [T, 3]

    Other keys are ignored. Nothing in the file is unpickled. `.pkl` files are refused, with the way to
    convert them.

    Raises `pelt.Error` that names the file and the key.
    """
    refuse_pickle(path, _KEYS)
    sizes: Dict[str, int] = {}
    with Npz(path) as npz:
        weights = npz.floats("weights", ("V", "J"), sizes)
        _check_weights(npz, weights)
        body = BodyModel(
            npz.floats("v_template", ("V", 3), sizes), npz.floats("shapedirs", ("V", 3, "B"), sizes),
            npz.floats("posedirs", ("V", 3, 9 * (sizes["J"] - 1)), sizes),
            npz.floats("J_regressor", ("J", "V"), sizes), weights, _parents(npz, sizes),
            npz.integers("f", ("T", 3), sizes))
        if not body.faces.size:
            raise npz.error("f", "there are no triangles")
        if not 0 <= body.faces.min() <= body.faces.max() < sizes["V"]:
            raise npz.error("f", f"expected vertices from 0 to {sizes['V'] - 1}")
    return body


def _check_weights(npz: Npz, weights: Doubles) -> None:
    if weights.shape[1] < 1:
        raise npz.error("weights", "there are no joints")
    stored = weights.astype(np.float32)
    wrong = np.flatnonzero((stored < 0).any(axis=1) | ~(stored > 0).any(axis=1))
    if len(wrong):
        raise npz.error("weights", f"vertex {wrong[0]} has a weight less than 0, or none greater than 0: "
                                   "save the file again with correct weights")


def _parents(npz: Npz, sizes: Any) -> npt.NDArray[np.int64]:
    table = npz.integers("kintree_table", (2, "J"), sizes)
    parents: npt.NDArray[np.int64] = table[0].copy()
    parents[0] = -1  # written as -1 or as 2^32 - 1
    wrong = np.flatnonzero((parents[1:] < 0) | (parents[1:] >= np.arange(1, len(parents)))) + 1
    if len(wrong):
        raise npz.error("kintree_table", f"joint {wrong[0]} has the parent {parents[wrong[0]]}, "
                                         f"expected a joint from 0 to {wrong[0] - 1}")
    return parents
