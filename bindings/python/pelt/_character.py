"""Characters from glTF files."""

from __future__ import annotations

import math
import os
from typing import List, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, floats, integer, with_axes
from pelt._model import Model
from pelt._near_joints import NearJoints, of_bodies
from pelt._poses import Poses, posed_vertices
from pelt._run import run
from pelt._self_collide import SelfFilter, self_collide


class Clip(NamedTuple):
    """A clip of a file: its name, which may be empty, and its duration."""

    name: str
    duration: float
    """in seconds"""


class Part(NamedTuple):
    """The triangles of one primitive of a file."""

    node: str
    mesh: str
    material: str
    first_triangle: int
    triangle_count: int


class Character:
    """A character of a glTF file: a model, and clips that pose it. `pelt.load` makes it.

    A file is one character: its meshes are the parts of one model, its skins share one palette.

    model:               the `Model`.
    clips:               list of `Clip`: name, and duration in seconds.
    joint_names:         [J] names of the joints; may be empty.
    joint_parents:       [J] parent of each joint, -1 for none.
    morph_target_names:  [M] names of the morph targets; may be empty.
    parts:               list of `Part`, ordered by their triangles.
    warnings:            what Pelt has ignored in the file.
    """

    def __init__(self, character: _pelt.Character, path: str) -> None:
        self._character = character
        self._path = path
        self.model = Model._of(character.model)
        self.clips: List[Clip] = [Clip(*clip) for clip in character.clips]
        self.joint_names: List[str] = character.joint_names
        self.joint_parents: npt.NDArray[np.int32] = np.array(character.joint_parents, np.int32)
        self.morph_target_names: List[str] = character.morph_target_names
        self.parts: List[Part] = [Part(*part) for part in character.parts]
        self.warnings: List[str] = character.warnings

    @property
    def rest(self) -> npt.NDArray[np.float32]:
        """Rest positions [V, 3]."""
        return self._character.rest

    @property
    def faces(self) -> npt.NDArray[np.int32]:
        """Vertices of the triangles [T, 3]."""
        return self._character.faces

    def palettes(self, clip: Optional[str] = None, *, fps: float = 30,
                 frames: Optional[int] = None, seconds: Optional[Array] = None,
                 placement: Optional[Array] = None) -> npt.NDArray[np.float32]:
        """Returns the palettes [F, J, 4, 4] of a clip, for all queries.

        clip:       name of the clip; None is the default pose of the file, one frame.
        fps:        frames per second; frame f is at f / fps seconds.
        frames:     F; default: to the end of the clip. More frames play the clip again.
        seconds:    [F] times, instead of `fps` and `frames`.
        placement:  [4, 4] or [F, 4, 4] world matrix of the character; default: the identity.

        The same times give the same matrices as in `pelt check`.
        """
        index = self._clip_index(clip)
        times = self._times(index, fps, frames, seconds)
        placed = np.eye(4) if placement is None else floats("placement", placement)
        with run("palettes", len(times), None, False) as how:
            return self._character.palettes(index, times, with_axes("placement", placed, 3), how)

    def morph_weights(self, clip: Optional[str] = None, *, fps: float = 30,
                      frames: Optional[int] = None,
                      seconds: Optional[Array] = None) -> npt.NDArray[np.float32]:
        """Returns the weights of the morph targets [F, M]. Arguments: see `palettes`."""
        index = self._clip_index(clip)
        return self._character.morph_weights(index, self._times(index, fps, frames, seconds))

    def poses(self, clip: Optional[str] = None, *, fps: float = 30, frames: Optional[int] = None,
              seconds: Optional[Array] = None, placement: Optional[Array] = None) -> Poses:
        """Returns palettes and morph weights together. Arguments: see `palettes`."""
        palettes = self.palettes(clip, fps=fps, frames=frames, seconds=seconds, placement=placement)
        if not self.morph_target_names:
            return Poses(palettes)
        return Poses(palettes, self.morph_weights(clip, fps=fps, frames=frames, seconds=seconds))

    def near_joints(self, at_rest: Optional[Array] = None) -> NearJoints:
        """Returns which joints are neighbours in the body; see `pelt.near_joints`.

        at_rest:  [N, 2] pairs of triangles that touch in reference poses.

        Joints that no clip of the file moves against each other are one body, such as a bone and the
        armour that is attached to it. These are the joints of `--self-near-joints` of `pelt check`.
        """
        bodies, above = (np.array(joints, np.int64) for joints in self._character.joint_bodies)
        return of_bodies(self.model, bodies, above, self._default_positions(), at_rest)

    def _default_positions(self) -> Optional[npt.NDArray[np.float32]]:
        """Returns the vertices in the default pose without morph targets, or None if it is invalid."""
        try:
            posed: npt.NDArray[np.float32] = posed_vertices(self.model, self.palettes(), progress=False)[0]
            return posed
        except _pelt.Error:
            return None

    def self_filter(self, *, rings: int = 5, at_rest: bool = True,
                    near_joints: bool = True) -> SelfFilter:
        """Returns the filter of `pelt check` for `self_collide`. Make it once for all clips.

        rings:        see `SelfFilter`.
        at_rest:      leave out pairs that touch in the rest pose, or in the default pose of the file.
        near_joints:  leave out creases at joints, see `near_joints`.

        The defaults are those of the command's `--self-rings`, `--self-at-rest` and
        `--self-near-joints`. With them, `self_collide` finds the pairs that `pelt check --self` does.
        """
        joints = self.near_joints() if near_joints else None
        if not at_rest:
            return SelfFilter(self.model, rings=rings, near_joints=joints)
        touching = self._touching_at_rest(SelfFilter(self.model, rings=rings, near_joints=joints))
        joints = self.near_joints(touching) if near_joints else None
        return SelfFilter(self.model, rings=rings, at_rest=touching, near_joints=joints)

    def _touching_at_rest(self, ignore: SelfFilter) -> npt.NDArray[np.int32]:
        """Returns the pairs of triangles [N, 2] that touch in the rest pose or the default pose."""
        rest = np.eye(4)[np.newaxis].repeat(self.model.joint_count, axis=0)[np.newaxis]
        palettes = np.concatenate([rest, self.palettes()])
        poses = Poses(palettes)
        if self.morph_target_names:
            weights = self.morph_weights()
            poses = Poses(palettes, np.concatenate([np.zeros_like(weights), weights]))
        found = self_collide(self.model, poses, ignore, progress=False)
        pairs: npt.NDArray[np.int32] = np.stack([found.triangle_a, found.triangle_b], axis=1)
        return np.unique(pairs, axis=0)

    def _clip_index(self, clip: Optional[str]) -> int:
        names = [known.name for known in self.clips]
        if clip is None:
            return -1
        if clip not in names:
            known = ", ".join(repr(name) for name in names) or "it has none"
            raise _pelt.Error(f"clip: {self._path} has no clip {clip!r} ({known})")
        return names.index(clip)

    def _times(self, index: int, fps: float, frames: Optional[int],
               seconds: Optional[Array]) -> npt.NDArray[np.float32]:
        """Returns the times in the clip [F]."""
        if not (isinstance(fps, (int, float)) and 1e-6 <= fps <= 1e6):
            raise _pelt.Error(f"fps: expected 0.000001 to 1000000, found {fps!r}")
        duration = self.clips[index].duration if index >= 0 else 0.0
        if seconds is None:
            times = np.arange(self._frame_count(duration, fps, frames)) / fps
        else:
            times = floats("seconds", seconds).astype(np.float64).reshape(-1)
            if not np.isfinite(times).all():
                raise _pelt.Error("seconds: expected finite numbers")
        wrapped = np.mod(times, duration) if duration > 0 else np.zeros_like(times)
        return np.where(wrapped < duration, wrapped, 0).astype(np.float32)

    @staticmethod
    def _frame_count(duration: float, fps: float, frames: Optional[int]) -> int:
        if frames is None:
            return max(1, math.ceil(duration * fps))
        return integer("frames", frames, 1, 2**31 - 1)

    def __repr__(self) -> str:
        names = ", ".join(repr(clip.name) for clip in self.clips[:4])
        more = ", ..." if len(self.clips) > 4 else ""
        return f"<pelt.Character: {self._path}, {self.model!r}, clips: [{names}{more}]>"


def load(path: Union[str, "os.PathLike[str]"], *, exclude_nodes: Sequence[str] = (),
         unskinned_parts: bool = True, renormalise: bool = False) -> Character:
    """Returns the character of a glTF file (.glb or .gltf).

    exclude_nodes:    names of nodes whose meshes are left out, with all nodes below them.
    unskinned_parts:  include meshes without a skin, such as weapons.
    renormalise:      divide weights by their sums, see `Model`.

    Raises `pelt.Error` with the path and the reason.
    """
    if isinstance(exclude_nodes, str):
        raise _pelt.Error("exclude_nodes: expected a list of names, found a string")
    file = os.fspath(path)
    character = _pelt.load(file, [str(name) for name in exclude_nodes], bool(unskinned_parts),
                           bool(renormalise))
    return Character(character, file)
