"""Motions of AMASS and Inter-X, for the body models of `pelt.body_models`.

    from pelt import motions

    motion = motions.load("walk_poses.npz")
    motion.fps, len(motion), motion.gender      # 120.0, 842, 'male'
    half_a_second = motion[:60]

Positions are in metres, and z is up. Rotations are rotation vectors in radians.
"""

from __future__ import annotations

import math
from typing import Dict, List, Optional

import numpy as np
import numpy.typing as npt

from pelt._npz import Npz, Path, refuse_pickle
from pelt._pelt import Error

Doubles = npt.NDArray[np.float64]

__all__ = ["Motion", "load"]

_BODY_JOINTS = 22


class Motion:
    """A motion of one subject.

    poses:         [F, 3 J] rotation vector of each joint with respect to its parent.
    translations:  [F, 3] of the root.
    betas:         [B] shape parameters of the subject.
    fps:           frames per second.
    gender:        "male", "female", "neutral", or "unknown".

    `len` is F, and slices are motions of fewer frames; `motion[::4]` is every fourth frame.
    """

    def __init__(self, poses: Doubles, translations: Doubles, betas: Doubles, fps: float,
                 gender: str = "unknown") -> None:
        self.poses = poses
        self.translations = translations
        self.betas = betas
        self.fps = fps
        self.gender = gender

    def body_only(self, joint_count: int) -> "Motion":
        """Returns the motion of the root and the 21 joints of the body, which SMPL, SMPL-H and SMPL-X
        share, for a body model of `joint_count` joints. All other joints, such as those of the hands,
        do not rotate."""
        if self.poses.shape[1] < 3 * _BODY_JOINTS or joint_count < _BODY_JOINTS:
            raise Error(f"body_only: expected {_BODY_JOINTS} or more joints, found "
                        f"{min(self.poses.shape[1] // 3, joint_count)}")
        poses = np.zeros((len(self), 3 * joint_count))
        poses[:, :3 * _BODY_JOINTS] = self.poses[:, :3 * _BODY_JOINTS]
        return Motion(poses, self.translations, self.betas, self.fps, self.gender)

    @property
    def seconds(self) -> float:
        """Duration: F / fps."""
        return len(self) / self.fps

    def __len__(self) -> int:
        return len(self.poses)

    def __getitem__(self, frames: slice) -> "Motion":
        step = frames.step if frames.step is not None else 1
        if step < 1:
            raise Error(f"motion: expected a step of 1 or more, found {step}")
        return Motion(self.poses[frames], self.translations[frames], self.betas, self.fps / step,
                      self.gender)

    def __repr__(self) -> str:
        return (f"<pelt.motions.Motion: {len(self)} frames at {self.fps:g} fps, "
                f"{self.poses.shape[1] // 3} joints, {self.gender}>")


def load(path: Path, *, fps: Optional[float] = None) -> Motion:
    """Returns the motion of an `.npz` file of AMASS or Inter-X.

    SMPL-H:   poses [F, 156], trans [F, 3], betas [B], mocap_framerate, gender
    SMPL-X:   poses [F, 165], or root_orient [F, 3], pose_body [F, 63], pose_jaw [F, 3], pose_eye [F, 6],
              pose_hand [F, 90]; trans [F, 3], betas [B], mocap_frame_rate, gender
    Inter-X:  root_orient [F, 3], pose_body [F, 21, 3], pose_lhand [F, 15, 3], pose_rhand [F, 15, 3],
              trans [F, 3], betas [1, B], gender; jaw and eyes do not rotate

    The mean pose of the hands that body models contain is not added: rotations of hands are those of
    smplx with `flat_hand_mean=True` and `use_pca=False`.

    fps:      frames per second, if the file states none. If it states two rates, `fps` must be one of
              them. Files of Inter-X state none: they have 120.

    `poses` of another number of joints are read, too. Without `betas`, the motion has none, so it gets
    the mean shape. Other keys, such as `dmpls`, are ignored; nothing in the file is unpickled.

    Raises `pelt.Error` that names the file and the key.
    """
    refuse_pickle(path, "poses trans betas mocap_framerate gender")
    sizes: Dict[str, int] = {}
    with Npz(path) as npz:
        poses = _poses(npz, sizes)
        translations = npz.floats("trans", ("F", 3), sizes)
        betas = _betas(npz) if "betas" in npz.keys else np.zeros(0)
        gender = npz.text("gender") or "unknown"
        return Motion(poses, translations, betas, _frames_per_second(npz, fps), gender.lower())


def _poses(npz: Npz, sizes: Dict[str, int]) -> Doubles:
    if "poses" in npz.keys:
        poses = npz.floats("poses", ("F", "3 J"), sizes)
    elif "root_orient" in npz.keys:
        poses = _poses_of_parts(npz, sizes)
    else:
        raise npz.error("poses", f"missing, and no root_orient: no motion of AMASS (the file has "
                                 f"{', '.join(sorted(npz.keys)) or 'no arrays'})")
    if poses.shape[0] == 0 or poses.shape[1] == 0 or poses.shape[1] % 3:
        raise npz.error("poses", f"expected [F, 3 J] with one frame or more, found {list(poses.shape)}")
    return poses


def _poses_of_parts(npz: Npz, sizes: Dict[str, int]) -> Doubles:
    """Returns the parts in the order of the joints of SMPL-X: the jaw and eyes before the hands."""
    parts = [npz.floats("root_orient", ("F", 3), sizes), _turns(npz, "pose_body", 21, sizes)]
    if "pose_jaw" in npz.keys:
        parts += [npz.floats("pose_jaw", ("F", 3), sizes), npz.floats("pose_eye", ("F", 6), sizes)]
    elif "pose_lhand" in npz.keys:
        parts.append(np.zeros((sizes["F"], 9)))
    if "pose_lhand" in npz.keys:
        parts += [_turns(npz, name, 15, sizes) for name in ("pose_lhand", "pose_rhand")]
    else:
        parts.append(npz.floats("pose_hand", ("F", 90), sizes))
    return np.concatenate(parts, axis=1)


def _turns(npz: Npz, key: str, joints: int, sizes: Dict[str, int]) -> Doubles:
    """Returns the rotation vectors of some joints [F, 3 joints]."""
    if key in npz.keys and npz.axes(key) == 3:
        return npz.floats(key, ("F", joints, 3), sizes).reshape(-1, 3 * joints)
    return npz.floats(key, ("F", 3 * joints), sizes)


def _betas(npz: Npz) -> Doubles:
    # [B] in AMASS; what smplx writes has an axis for a batch of one.
    if npz.axes("betas") == 1:
        return npz.floats("betas", ("B",))
    return npz.floats("betas", (1, "B")).reshape(-1)


def _frames_per_second(npz: Npz, given: Optional[float]) -> float:
    rates = [_rate(npz, key) for key in ("mocap_framerate", "mocap_frame_rate") if key in npz.keys]
    if not rates:
        if given is None:
            raise npz.error("mocap_framerate", "missing, and no mocap_frame_rate: state the rate by "
                                               "`--fps`, or fps=")
        return given
    if _is_one_rate(rates):
        return rates[0]
    for rate in rates:
        if given is not None and _is_one_rate([rate, given]):
            return rate
    raise npz.error("mocap_framerate", f"is {rates[0]}, but mocap_frame_rate is {rates[1]}: state which of "
                                       f"the two is right by `--fps`, or fps=")


def _rate(npz: Npz, key: str) -> float:
    # A scalar in AMASS; some copies have an array of one element.
    rates = npz.floats(key, ()) if npz.axes(key) == 0 else npz.floats(key, (1,))
    rate = float(rates.reshape(-1)[0])
    if not 0 < rate <= 1e6:
        raise npz.error(key, f"expected more than 0 frames per second, found {rate:g}")
    return rate


def _is_one_rate(rates: List[float]) -> bool:
    """Returns whether rates are equal, apart from rounding to float32."""
    return math.isclose(rates[0], rates[-1], rel_tol=1e-6)
