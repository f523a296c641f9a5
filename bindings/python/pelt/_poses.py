"""Poses of all frames of a call."""

from __future__ import annotations

from typing import Optional, Union

import numpy as np
import numpy.typing as npt

from pelt import _pelt
from pelt._arrays import Array, Floats, floats, with_axes
from pelt._model import Model
from pelt._run import Progress, run


def _check_slice(frames: object) -> None:
    """Otherwise NumPy would read poses as nested lists."""
    if not isinstance(frames, slice):
        raise TypeError(f"expected a slice of frames such as [3:4], found {frames!r}")


class Poses:
    """Palettes, weights of morph targets, and offsets of vertices.

    palettes:       [F, J, 4, 4] or [F, J, 3, 4], or without F for one frame.
    morph_weights:  [F, M], or [M] for all frames; None means that all weights are 0.
    offsets:        [F, V, 3], or [V, 3] for all frames: added to each vertex after the joints have
                    posed it, in the frame that all poses of a call share. The model needs
                    `offset_caps`, which no offset may exceed. None: no offsets.

    `len` is F, and slices are poses of fewer frames.
    """

    def __init__(self, palettes: Array, morph_weights: Optional[Array] = None,
                 offsets: Optional[Array] = None) -> None:
        self.palettes: Floats = with_axes("palettes", floats("palettes", palettes), 4)
        self.morph_weights = self._for_all_frames("morph_weights", morph_weights, 2)
        self.offsets = self._for_all_frames("offsets", offsets, 3)

    def _for_all_frames(self, name: str, value: Optional[Array], axes: int) -> Optional[Floats]:
        """Returns an array with the frames of the palettes, without a copy."""
        if value is None:
            return None
        array = with_axes(name, floats(name, value), axes)
        if len(array) == 1:
            array = np.broadcast_to(array, (len(self.palettes), *array.shape[1:]))
        return array

    def __len__(self) -> int:
        return len(self.palettes)

    def __getitem__(self, frames: slice) -> "Poses":
        _check_slice(frames)
        weights = None if self.morph_weights is None else self.morph_weights[frames]
        offsets = None if self.offsets is None else self.offsets[frames]
        return Poses(self.palettes[frames], weights, offsets)

    def __repr__(self) -> str:
        morphs = 0 if self.morph_weights is None else self.morph_weights.shape[1]
        more = f", {morphs} morph weights" if morphs else ""
        more += ", offsets" if self.offsets is not None else ""
        return f"<pelt.Poses: {len(self)} frames, {self.palettes.shape[1]} joints{more}>"


class Vertices:
    """Positions of all vertices, instead of palettes: cloth, simulations, pose correctives.

    positions:  [F, V, 3], or [V, 3] for one frame, in the frame that all poses of a call share.

    `len` is F, and slices are poses of fewer frames.
    """

    def __init__(self, positions: Array) -> None:
        self.positions: Floats = with_axes("positions", floats("positions", positions), 3)

    def __len__(self) -> int:
        return len(self.positions)

    def __getitem__(self, frames: slice) -> "Vertices":
        _check_slice(frames)
        return Vertices(self.positions[frames])

    def __repr__(self) -> str:
        return f"<pelt.Vertices: {len(self)} frames, {self.positions.shape[1]} vertices>"


PosesLike = Union[Array, Poses, Vertices]
"""An array of palettes, `Poses`, or `Vertices`."""


def clip_poses(name: str, model: Model, poses: PosesLike) -> _pelt.ClipPoses:
    """Returns the poses of an argument, whose name messages contain."""
    if not isinstance(model, Model):
        expected = name.replace("poses", "model")
        raise TypeError(f"{expected}: expected a pelt.Model, found {type(model).__name__}")
    if isinstance(poses, Vertices):
        return _pelt.ClipPoses.of_vertices(model._model, name, poses.positions)
    if not isinstance(poses, Poses):
        matrices = with_axes(name, floats(name, poses), 4)
        return _pelt.ClipPoses.of_palettes(model._model, name, matrices, None, None)
    return _pelt.ClipPoses.of_palettes(model._model, name, poses.palettes, poses.morph_weights,
                                       poses.offsets)


def posed_vertices(model: Model, poses: PosesLike, *, threads: Optional[int] = None,
                   progress: Progress = None) -> npt.NDArray[np.float32]:
    """Returns the posed vertices [F, V, 3] in float32, bit for bit those that queries use."""
    clip = clip_poses("poses", model, poses)
    with run("posed_vertices", clip.frame_count, threads, progress) as how:
        return _pelt.posed_vertices(clip, how)
